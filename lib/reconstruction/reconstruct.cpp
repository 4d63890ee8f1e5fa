#include "transformesh/reconstruct.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "evolution/loop/csv_row.h"
#include "evolution/loop/iteration_text.h"
#include "evolution/loop/loop.h"
#include "evolution/loop/record.h"
#include "evolution/loop/stages.h"
#include "evolution/loop/stopwatch.h"
#include "io/document/round_as_written.h"
#include "mesh/component_areas.h"
#include "reconstruction/carving.h"
#include "reconstruction/convergence.h"
#include "reconstruction/fin_trial.h"
#include "reconstruction/first_scale.h"
#include "reconstruction/handle_trial.h"
#include "reconstruction/image_scales.h"
#include "reconstruction/initial_mesh.h"
#include "reconstruction/initial_state.h"
#include "reconstruction/judge_result.h"
#include "reconstruction/photographs.h"
#include "reconstruction/recorded_reconstruction.h"
#include "reconstruction/scale_rule.h"
#include "reconstruction/surface_doubt.h"
#include "reconstruction/sweep_rules.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/handles.h"
#include "transformesh/hull.h"
#include "transformesh/manifold.h"
#include "transformesh/mesh_io.h"
#include "views/cameras/view.h"
#include "views/hull/silhouette.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photo_steps.h"

namespace transformesh {
namespace {

/// Factor by which the stiffness grows each time that the surface falls apart (is_exploded()), and
/// the limit of the product of these factors.
constexpr double stiffer = 4;
constexpr double most_stiffness = 16;
/// Number of steps of a sweep between two rounds of carving. After five or more steps, the
/// stiffness has brought the carved parts back, and thin sheets across holes stay closed.
constexpr int carving_steps = 2;
/// Largest movement in a round of carving, in edge lengths. The steps after each round bring parts
/// back by up to one edge length.
constexpr double carving_edges = 1.5;
/// Multiples of ReconstructionOptions::handles that are tried as lengths of loops. Several, because
/// a trial fails if a true handle is among the removed ones. By default, the longest loop has 45
/// pixels. Two windows fit into a wider tunnel, so that its walls are doubtful if it is false.
constexpr std::array<double, 4> trial_loops = {1.5, 2, 2.5, 3};
/// Finest scale at which the loop restarts if the surface falls apart; at finer scales too much
/// work would be repeated. Slightly below 2, because scales are rounded.
constexpr double stiffer_scale = 1.99;

ScaleOptions scales_of(const ReconstructionOptions& options, const InitialState& initial_state) {
  ScaleOptions scales = options.scales;
  for (const auto& limit : {initial_state.coarsest, initial_state.first_scale})
    if (limit) scales.largest = std::min(scales.largest, *limit);
  return scales;
}

void find_first_scale(InitialState& initial_state, Photographs& photographs,
                      const ReconstructionOptions& options, Record& record,
                      const Progress& progress) {
  std::vector<double> scales;
  for (const ScaleStep& step :
       coarse_to_fine(options.scales, photographs.width(), photographs.pixel()))
    if (scales.empty() || step.scale < scales.back()) scales.push_back(step.scale);
  const double scale = first_scale(scales, [&](double at) {
    return photographs.disagreement_at(initial_state.document.mesh, at, progress);
  });
  if (options.on_detail)
    options.on_detail("the initial mesh is refined from scale " + fixed(scale, 4));
  set_first_scale(initial_state, scale, record);
}

/// Returns the volumes of the components, or their areas if one of them is open.
std::vector<double> sizes_of(const Mesh& mesh, const Components& parts) {
  std::vector<double> sizes;
  bool is_open = false;
  for (const Component& part : parts.components) {
    sizes.push_back(part.volume);
    is_open = is_open || part.boundary_loops > 0;
  }
  return is_open ? component_areas(mesh, parts) : sizes;
}

class ReconstructionLoop : public Loop {
 public:
  ReconstructionLoop(Photographs& photographs, const InitialState& initial_state,
                     const ReconstructionOptions& options)
      : photographs_(photographs),
        initial_(initial_state.document),
        given_(initial_state.unclipped.value_or(initial_state.document)),
        options_(options),
        scale_steps_(coarse_to_fine(scales_of(options, initial_state), photographs.width(),
                                    photographs.pixel())),
        rule_(options.sweeps) {}

  std::string noun() const override { return "sweep"; }
  std::string column() const override { return "pass"; }
  void start(Document& document, const Progress& progress) override;
  void advance(Document& document, std::size_t iteration, const Progress& progress) override;
  bool is_done() const override { return scale_step_ == scale_steps_.size(); }
  void finish(Document& document, const Progress& progress) override;

  void remember(LoopState& loop_state) override;
  void measure(CsvRow& row) const override;
  std::string message() const override;

  const ReconstructionResult& result() const { return result_; }

 private:
  bool is_last_scale() const { return scale_step_ + 1 == scale_steps_.size(); }
  bool may_begin_finer() const;
  bool restarts_or_ends(Document& document, const Progress& progress);
  bool drops_handles(Document& document, const Progress& progress);
  void drop_crumbs(Document& document);
  void begin_finer(Document& document, const Progress& progress);
  bool takes_sweep(Document& document, const Progress& progress);
  void take_sweep(Document& document, const Progress& progress,
                  std::optional<int> iterations = std::nullopt);
  bool carves(Document& document, const Progress& progress);
  bool tries_without_handles(Document& document, const Progress& progress);
  bool tries_without_fins(Document& document, const Progress& progress);
  bool begin_robust();
  void begin_next_scale(Document& document, const Progress& progress);
  std::size_t pixels_compared(const Document& document, const Progress& progress) const {
    return photographs_.look(document.mesh, sweep_.scale_step.scale, true, progress).pixels;
  }

  Photographs& photographs_;
  const Document& initial_;
  /// The given mesh, cleaned but not intersected with the hull. It is the initial mesh if there was
  /// no intersection with the hull.
  const Document given_;
  const ReconstructionOptions& options_;
  std::vector<ScaleStep> scale_steps_;

  // State that is kept from sweep to sweep.
  std::size_t first_ = 0;       ///< index of the first scale
  std::size_t scale_step_ = 0;  ///< index of the scale of the next sweep
  ScaleRule rule_;
  ReconstructionFaults faults_;
  bool is_carved_ = false;  ///< true if the sweeps before carving are finished at the current scale
  bool has_tried_fins_ = false;  ///< true after the call of try_without_fins()
  double loss_ = 0;
  double stiffness_ = 1;     ///< factor by which the stiffness of the options is multiplied
  std::size_t handles_ = 0;  ///< number of removed handles

  Sweep sweep_;  ///< measures of the last sweep
  ReconstructionResult result_;
};

void ReconstructionLoop::start(Document& document, const Progress& progress) {
  document = initial_;
  document.mesh.vertex_columns.erase(doubt_column);
  is_carved_ = has_tried_fins_ = false;
  coarsen(document, scale_steps_[scale_step_].edge, progress);
}

// True if the first scale was chosen by default, all sweeps so far were at this scale, and a finer
// one follows.
bool ReconstructionLoop::may_begin_finer() const {
  return !options_.scales.coarsest && scale_step_ == first_ && !is_last_scale();
}

void ReconstructionLoop::begin_finer(Document& document, const Progress& progress) {
  if (options_.on_detail)
    options_.on_detail("scale " + fixed(sweep_.scale_step.scale, 4) +
                       " is too coarse for this surface: restarting at the next finer scale");
  scale_step_ = ++first_;
  // The surface may have exploded only because edges were longer than thin parts are thick.
  stiffness_ = 1;
  faults_.lost_at = 0;
  rule_.begin();
  start(document, progress);
}

// Returns true if the surface fell apart in the last sweep (is_exploded()). Then restarts from the
// initial mesh with a larger stiffness, or ends the loop with the initial mesh.
bool ReconstructionLoop::restarts_or_ends(Document& document, const Progress& progress) {
  if (!is_exploded(sweep_, connected_components(initial_.mesh).components.size())) return false;
  faults_ = {};
  const double scale = sweep_.scale_step.scale;
  if (scale < stiffer_scale || stiffness_ >= most_stiffness) {
    faults_.exploded_at = scale;
    document = initial_;
    scale_step_ = scale_steps_.size();
    return true;
  }
  stiffness_ *= stiffer;
  if (options_.on_note)
    options_.on_note("the surface explodes at scale " + fixed(scale, 4) + ": restarting with " +
                     fixed(stiffness_, 0) + " times the stiffness");
  scale_step_ = first_;
  rule_.begin();
  start(document, progress);
  return true;
}

// Returns true if handles were removed. The mesh must then be cleaned again.
bool ReconstructionLoop::drops_handles(Document& document, const Progress& progress) {
  if (options_.handles == 0 || !check_manifold(document.mesh).is_closed()) return false;
  const HandleOptions options{options_.handles * scale_steps_.back().edge,
                              document.style.coordinate};
  const std::size_t removed = remove_handles(document.mesh, options, progress).removed;
  handles_ += removed;
  return removed > 0;
}

void ReconstructionLoop::drop_crumbs(Document& document) {
  const Components parts = connected_components(document.mesh);
  const std::vector<double> sizes = sizes_of(document.mesh, parts);
  const double largest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
  std::vector<bool> keeps;
  for (const double size : sizes) keeps.push_back(size >= options_.crumbs * largest);
  result_.crumbs = static_cast<std::size_t>(std::count(keeps.begin(), keeps.end(), false));
  if (result_.crumbs == 0) return;
  std::vector<bool> keeps_face;
  for (const Index part : parts.of_face) keeps_face.push_back(keeps[part]);
  document.mesh = select_faces(document.mesh, keeps_face);
  const Components kept = connected_components(document.mesh);
  result_.topology = {kept.components.size(), kept.genus()};
}

void ReconstructionLoop::take_sweep(Document& document, const Progress& progress,
                                    std::optional<int> iterations) {
  Stopwatch watch;
  IterationResult& mesh = sweep_.mesh;
  sweep_.scale_step = scale_steps_[scale_step_];
  remesh_to(document, sweep_.scale_step.edge, 2, progress);
  mesh.seconds_remesh = watch.lap();

  mesh.vertices = document.mesh.positions.size();
  sweep_.steps = photographs_.sweep(document.mesh, sweep_.scale_step.scale,
                                    {loss_, stiffness_, iterations}, progress);
  round_as_written(document);
  mesh.seconds_step = watch.lap();

  const CleanedTopology cleaned = clean_in_place(document, progress);
  mesh.pairs = cleaned.pairs;
  mesh.topology = cleaned.topology;
  if (is_late_scale(sweep_.scale_step.scale) && drops_handles(document, progress))
    mesh.topology = clean_in_place(document, progress).topology;
  mesh.faces = document.mesh.faces.size();
  mesh.seconds_clean = watch.lap();
}

bool ReconstructionLoop::takes_sweep(Document& document, const Progress& progress) {
  try {
    take_sweep(document, progress);
    return true;
  } catch (const CancelledError&) {
    throw;
  } catch (const std::runtime_error&) {
    if (!may_begin_finer()) throw;
    return false;
  }
}

void ReconstructionLoop::advance(Document& document, std::size_t /*iteration*/,
                                 const Progress& progress) {
  while (!takes_sweep(document, progress)) begin_finer(document, progress);
  if (restarts_or_ends(document, progress)) return;
  const SweepVerdict verdict = rule_.add(sweep_, is_last_scale() && is_carved_);
  faults_.is_at_rest = verdict.is_at_rest;
  if (verdict.is_late && scale_step_ > first_) faults_.late_at = sweep_.scale_step.scale;
  if (!verdict.is_done) return;
  if (verdict.is_lost) faults_.lost_at = sweep_.scale_step.scale;
  const bool may_go_on = !is_carved_ && is_last_scale() && !verdict.is_lost;
  if (carves(document, progress) || tries_without_handles(document, progress)) return;
  if (may_go_on && !verdict.is_at_rest) return;
  if (!begin_robust() && !tries_without_fins(document, progress))
    begin_next_scale(document, progress);
}

// Calls carve() (carving.h) once per scale. Returns true if the surface changed and thus needs more
// sweeps.
bool ReconstructionLoop::carves(Document& document, const Progress& progress) {
  // Only the hull of exact masks is known to contain the object. At coarse scales photographs
  // disagree on true surfaces, too: a strand of the torus knot 2,3 was cut at scale 2.
  if (std::exchange(is_carved_, true) || loss_ > 0 || options_.initial.is_given ||
      !photographs_.has_exact_outlines() || !is_late_scale(scale_steps_[scale_step_].scale))
    return false;
  Stopwatch watch;
  Sweep kept = sweep_;
  std::size_t handles = handles_;
  bool is_changed = false;
  const auto& [scale, edge] = scale_steps_[scale_step_];
  carve(document, {[&, at = scale](const Mesh& mesh) {
                     return photographs_.carving_evidence(mesh, at, progress);
                   },
                   [&](Document& carved) { clean_in_place(carved, progress); },
                   [&](Document& carved) { take_sweep(carved, progress, carving_steps); },
                   [&](Document& carved) { take_sweep(carved, progress); },
                   [&] {
                     kept = sweep_;
                     handles = handles_;
                     is_changed = true;
                   },
                   carving_edges * edge});
  sweep_ = kept;
  sweep_.mesh.seconds_step += watch.lap();
  handles_ = handles;
  if (!is_changed) return false;
  if (options_.on_detail)
    options_.on_detail("parts that photographs contradict were removed at scale " +
                       fixed(scale, 4));
  rule_.begin();
  return true;
}

// Calls try_without_handles() (handle_trial.h) at the end of the last scale. Returns true if the
// surface changed and thus needs more sweeps.
bool ReconstructionLoop::tries_without_handles(Document& document, const Progress& progress) {
  if (options_.handles == 0 || loss_ > 0 || !is_last_scale() ||
      !check_manifold(document.mesh).is_closed())
    return false;
  const Sweep kept = sweep_;
  const std::size_t handles = handles_;
  const auto& [scale, edge] = scale_steps_[scale_step_];
  const HandleTrialStages stages{
      [&, at = scale](const Mesh& mesh) {
        return photographs_.carving_evidence(mesh, at, progress).of_vertex;
      },
      [&](Document& tried) {
        clean_in_place(tried, progress);
        take_sweep(tried, progress);
      }};
  for (const double loop : trial_loops) {
    const auto removed = try_without_handles(document, loop * options_.handles * edge, stages);
    if (!removed) continue;
    if (*removed == 0) break;
    handles_ += *removed;
    rule_.begin();
    return true;
  }
  sweep_ = kept;
  handles_ = handles;
  return false;
}

// Calls try_without_fins() (fin_trial.h) once, at the end of the last scale. Returns true if the
// surface changed and thus needs more sweeps.
bool ReconstructionLoop::tries_without_fins(Document& document, const Progress& progress) {
  // A given mesh may show what photographs do not. Without exact masks, no outline proves a fin.
  if (!is_last_scale() || std::exchange(has_tried_fins_, true) || options_.initial.is_given ||
      !photographs_.has_exact_outlines() || !check_manifold(document.mesh).is_closed())
    return false;
  const double scale = scale_steps_[scale_step_].scale;
  const bool is_changed = try_without_fins(
      document, photographs_.pixel(),
      {[&](const Mesh& mesh) { return photographs_.carving_evidence(mesh, scale, progress); },
       [&](Document& tried) { clean_in_place(tried, progress); }},
      progress);
  if (!is_changed) return false;
  if (options_.on_detail)
    options_.on_detail("thin sheets or fins that fewer than two photographs show were removed");
  rule_.begin();
  return true;
}

// After the last scale, once, begins further sweeps with a robust loss (robust_loss()). Returns
// true if such sweeps follow. Earlier sweeps need the full weight of disagreeing windows, because
// these show where the surface is inaccurate.
bool ReconstructionLoop::begin_robust() {
  if (!is_last_scale() || loss_ > 0 || !faults_.is_at_rest) return false;
  loss_ = robust_loss(options_.robust, rule_.dissimilarity());
  if (loss_ > 0) rule_.begin();
  return loss_ > 0;
}

void ReconstructionLoop::begin_next_scale(Document& document, const Progress& progress) {
  const bool was_first = may_begin_finer();
  ++scale_step_;
  is_carved_ = false;
  rule_.begin();
  if (was_first &&
      is_torn(pixels_compared(initial_, progress), pixels_compared(document, progress)))
    begin_finer(document, progress);
}

void ReconstructionLoop::finish(Document& document, const Progress& progress) {
  result_.topology = clean_in_place(document, progress).topology;
  if (drops_handles(document, progress))
    result_.topology = clean_in_place(document, progress).topology;
  result_.handles = handles_;
  drop_crumbs(document);
  result_.pixel = photographs_.pixel();
  ResultJudge(photographs_, given_, options_).judge(document, faults_, result_, progress);
  result_.faces = document.mesh.faces.size();
}

void ReconstructionLoop::remember(LoopState& loop_state) {
  rule_.remember(loop_state);
  faults_.remember(loop_state);
  loop_state("first", first_)("level", scale_step_)("loss", loss_)("stiffness", stiffness_);
  loop_state("handles", handles_)("carved", is_carved_)("fins", has_tried_fins_);
}

void ReconstructionLoop::measure(CsvRow& row) const {
  const auto& [scale_step, mesh, steps] = sweep_;
  row.share("scale", scale_step.scale).number("edge", scale_step.edge, 9);
  measure_mesh(mesh, row);
  row.share("dissimilarity", steps.last.dissimilarity, 6).count("pixels", steps.last.pixels);
  row.share("coverage", steps.last.coverage).share("mean_share", steps.last.mean_share, 5);
  row.count("outside", steps.last.outside).seconds("seconds_remesh", mesh.seconds_remesh);
  row.seconds("seconds_step", mesh.seconds_step).seconds("seconds_clean", mesh.seconds_clean);
  row.seconds("seconds", mesh.seconds_remesh + mesh.seconds_step + mesh.seconds_clean);
}

std::string ReconstructionLoop::message() const {
  return ", scale " + fixed(sweep_.scale_step.scale, 2) + ": " +
         in_words(sweep_.mesh.faces, sweep_.mesh.topology) + ", dissimilarity " +
         fixed(sweep_.steps.last.dissimilarity, 4);
}

}  // namespace

ReconstructionResult reconstruct(Document& document, std::vector<View>& views,
                                 const ReconstructionOptions& options, Record& record,
                                 const Progress& progress) {
  InitialState initial_state =
      record.resumed()
          ? read_initial_state(record)
          : make_initial_state(document, views, {options.initial, options.pairs}, record, progress);
  const bool is_dense = !initial_state.why_dense.empty();
  if (is_dense && options.on_note) options.on_note(initial_state.why_dense);
  if (initial_state.coarsest && options.on_detail)
    options.on_detail(
        "photographs show hollows that the hull fills: the reconstruction begins with open "
        "hollows");
  if (initial_state.outlined) outline(views, *initial_state.outlined);
  const int width = views.front().image.width;
  if (options.spends_views) crop_views(views, initial_state.document.mesh);
  Photographs photographs(views, width, options, initial_state);
  const bool is_near = options.initial.is_given || is_dense;
  if (is_near && !options.scales.coarsest && !initial_state.first_scale)
    find_first_scale(initial_state, photographs, options, record, progress);
  ReconstructionLoop loop(photographs, initial_state, options);
  const LoopOptions unlimited{std::numeric_limits<std::size_t>::max(), options.on_sweep};
  run_loop(loop, document, unlimited, record, progress);
  ReconstructionResult result = loop.result();
  result.sweeps = record.iteration();
  return result;
}

ReconstructionResult reconstruct(Document& document, Views& views,
                                 const ReconstructionOptions& options,
                                 const RecordOptions& record_options, const Progress& progress) {
  Record record(record_options);
  if (record.resumed()) document = record.resumed()->document;
  return reconstruct(document, views.list(), options, record, progress);
}

std::string summary_of(const ReconstructionResult& result) {
  return counted(result.sweeps, "sweep") + ": " + in_short(result.faces, result.topology) +
         "; dissimilarity from " + fixed(result.first.dissimilarity, 4) + " to " +
         fixed(result.last.dissimilarity, 4) +
         (result.kept.empty() ? "" : "; the initial mesh is kept") +
         (result.fault.empty() ? "" : "; " + result.fault);
}

}  // namespace transformesh
