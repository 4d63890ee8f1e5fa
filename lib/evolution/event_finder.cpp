#include "evolution/event_finder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "evolution/loop/event_row.h"
#include "geometry/search/closest_point.h"

namespace transformesh {
namespace {

LabeledStates by_label(std::vector<ComponentState> states) {
  LabeledStates result;
  for (ComponentState& state : states) result.emplace(state.label, std::move(state));
  return result;
}

/// Removes the states with these labels, and returns them.
LabeledStates taken_from(LabeledStates& states, const std::vector<long>& labels) {
  LabeledStates taken;
  for (const long label : labels)
    if (auto node = states.extract(label)) taken.insert(std::move(node));
  return taken;
}

bool takes_part(const Event& event, long label) {
  const auto has = [&](const std::vector<LabeledVolume>& components) {
    return std::ranges::find(components, label, &LabeledVolume::label) != components.end();
  };
  return has(event.before) && !has(event.after);
}

/// True if the event is the separation of a part. The curve along which the part is cut off shrinks
/// to a point, so its size has no meaning. These events report the result of free_diameter()
/// instead.
bool separates(const Event& event) {
  return event.kind == EventKind::split || event.kind == EventKind::cavity_closed;
}

/// Returns the diameter of the largest ball around `center` that no face of the mesh enters.
double free_diameter(const Mesh& mesh, const Vec3& center) {
  return 2 * ClosestPointQuery(mesh)(center).distance;
}

/// Removes from an event those parts that remeshing dropped in the same step. `labels` are the
/// labels of all faces before and after the step. An event of a closed cavity is not changed.
void forget_dropped(Event& event, const std::set<long>& labels) {
  if (event.kind == EventKind::cavity_closed) return;
  std::erase_if(event.after,
                [&](const LabeledVolume& part) { return !labels.contains(part.label); });
}

bool have_common(const std::vector<LabeledVolume>& some, const std::vector<LabeledVolume>& others) {
  return std::ranges::any_of(some, [&](const LabeledVolume& one) {
    return std::ranges::find(others, one.label, &LabeledVolume::label) != others.end();
  });
}

/// Drops pairs of events that cancel each other: cleaning opened a handle of a component, and
/// pinching (the cutting of thin parts) closed a handle of the same component.
void cancel_handles(std::vector<Event>& events) {
  std::vector<Event> kept;
  for (Event& event : events) {
    const auto opened = std::ranges::find_if(kept, [&](const Event& earlier) {
      return event.kind == EventKind::handle_closed && earlier.kind == EventKind::handle_opened &&
             have_common(earlier.after, event.before);
    });
    if (opened == kept.end())
      kept.push_back(std::move(event));
    else
      kept.erase(opened);
  }
  events = std::move(kept);
}

}  // namespace

void EventFinder::start(Mesh& mesh) {
  const Components components = connected_components(mesh);
  std::vector<ComponentState> states = component_states(mesh, components);
  for (ComponentState& state : states) state.label = next_label_++;
  write_labels(mesh, components, states);
}

void EventFinder::begin_step(const Mesh& mesh) {
  before_.positions = mesh.positions;
  before_.faces = mesh.faces;
  before_.face_columns.columns = {*mesh.face_columns.find(component_label)};
  begun_.reset();
  found_.clear();
  label_after_step_ = next_label_;
}

void EventFinder::watch(IterationOptions& options) {
  options.on_cleaned = [this](const Mesh& moved, Mesh& cleaned) { see(moved, cleaned); };
  const double shortest = options.edge_factor * options.min_edge.resolve(0, options.reference_edge);
  least_volume_ = std::numbers::pi / 6 * shortest * shortest * shortest;
}

/// True if a part separated and was removed in the same step, and this is not worth a report.
/// Remeshing removes parts that are too small; the split of such a part is not reported. A cavity
/// that closes and is filled is reported, unless it is smaller than the parts that remeshing
/// removes.
bool EventFinder::is_brief(const Event& event, const std::set<long>& labels) const {
  if (!separates(event) || labels.contains(event.after.back().label)) return false;
  return event.kind == EventKind::split || std::abs(event.after.back().volume) < least_volume_;
}

void EventFinder::measure_before() {
  if (begun_) return;
  now_ = by_label(component_states(before_, connected_components(before_)));
  begun_ = now_;
}

void EventFinder::see(const Mesh& moved, Mesh& cleaned) {
  measure_before();
  const LabeledStates were = taken_from(now_, face_labels(moved));
  const Components components = connected_components(cleaned);
  std::vector<ComponentState> states = component_states(cleaned, components);
  if (!is_same_topology(were, states)) {
    assign_labels(were, states, label_after_step_);
    const std::vector<Seam> seams = find_seams(moved, cleaned, components);
    for (Event& event : find_events(were, states, seams)) {
      if (separates(event)) event.size = free_diameter(before_, event.place);
      found_.push_back(std::move(event));
    }
    cancel_handles(found_);
  }
  // Write labels even if the topology is unchanged: faces that cleaning created have no label.
  write_labels(cleaned, components, states);
  now_.merge(by_label(std::move(states)));
}

void EventFinder::end_step(const Mesh& mesh, std::size_t iteration, double time) {
  events_before_step_ = events_.size();
  add_vanished(mesh);
  for (Event& event : found_) {
    event.iteration = iteration;
    event.time = time;
    events_.push_back(std::move(event));
  }
  found_.clear();
  event_count_ += events_.size() - events_before_step_;
  next_label_ = label_after_step_;
}

void EventFinder::add_vanished(const Mesh& mesh) {
  const std::vector<long> of_faces = face_labels(mesh), of_faces_before = face_labels(before_);
  const std::set<long> labels(of_faces.begin(), of_faces.end());
  std::erase_if(found_, [&](const Event& event) { return is_brief(event, labels); });
  std::set<long> known = labels;
  known.insert(of_faces_before.begin(), of_faces_before.end());
  for (Event& event : found_) forget_dropped(event, known);
  for (const long label : std::set<long>(of_faces_before.begin(), of_faces_before.end())) {
    if (labels.contains(label)) continue;
    const auto absorbs = [&](const Event& event) { return takes_part(event, label); };
    if (std::ranges::any_of(found_, absorbs)) continue;
    measure_before();
    const ComponentState& state = begun_->at(label);
    Event event;
    event.kind = EventKind::component_vanished;
    event.place = state.extent.center;
    event.size = state.extent.size;
    event.before = {{label, state.volume}};
    found_.push_back(std::move(event));
  }
}

std::vector<std::string> EventFinder::last_rows() const {
  std::vector<std::string> rows;
  for (std::size_t i = events_before_step_; i < events_.size(); ++i)
    rows.push_back(event_row(events_[i]).line());
  return rows;
}

}  // namespace transformesh
