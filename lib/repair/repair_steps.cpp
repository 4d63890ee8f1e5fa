#include "repair/repair_steps.h"

#include <utility>

#include "clean/open/join_soup.h"
#include "io/document/round_as_written.h"
#include "repair/losses.h"
#include "support/counted.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"
#include "transformesh/fill.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/select.h"

namespace transformesh {
namespace {

void add_finding(RepairStep& step, std::size_t count, const std::string& noun,
                 const std::string& verb) {
  if (count == 0) return;
  step.count += count;
  step.findings.push_back(counted(count, noun) + ' ' + verb);
}

/// True if the operation may remove surface. Filling removes nothing; stitching removes only
/// duplicates and faces without area.
bool may_lose(const RepairStep& step) {
  return std::holds_alternative<CleanOptions>(step.operation) ||
         std::holds_alternative<SelectionOptions>(step.operation);
}

bool is_same_surface(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.faces == b.faces;
}

}  // namespace

void RepairSteps::record(Mesh after, RepairStep step) {
  Document document{std::move(after), {}, {}};
  document.style.coordinate = coordinate_;
  round_as_written(document);
  after = std::move(document.mesh);
  const Sizes before_sizes = sizes_of(mesh_), after_sizes = sizes_of(after);
  step.area_change = after_sizes.area - before_sizes.area;
  step.volume_change = after_sizes.volume - before_sizes.volume;
  if (may_lose(step)) {
    const Loss loss = find_loss(mesh_, after);
    step.lost_share = loss.share;
    step.lost_place = loss.place;
  }
  step.place = first_change(mesh_, after);
  mesh_ = std::move(after);
  steps_.push_back(std::move(step));
}

void RepairSteps::stitch(const StitchOptions& options) {
  progress_("joining");
  Mesh after = mesh_;
  const StitchResult result = transformesh::stitch(after, options);
  if (is_same_surface(mesh_, after)) return;
  RepairStep step;
  step.operation = options;
  add_finding(step, check_manifold(mesh_).isolated_vertices.size(), "vertex",
              "without a face dropped");
  add_finding(step, result.joined_vertices, "vertex", "joined with others");
  add_finding(step, result.split_borders, "border edge", "split at vertices that lie on them");
  add_finding(step, result.dropped_faces, "face", "without three corners dropped");
  add_finding(step, result.dropped_copies, "face", "dropped as copies of others");
  add_finding(step, result.dropped_reverses, "face", "dropped as reverses of others");
  add_finding(step, result.reversed_faces, "face", "reversed");
  add_finding(step, result.copied_vertices, "vertex", "copied where sheets touch");
  add_finding(step, result.split_edges, "edge", "split where sheets touch");
  record(std::move(after), std::move(step));
}

void RepairSteps::fill(bool fair, double max_diameter) {
  Mesh after = mesh_;
  join_soup(after);
  FillOptions options;
  options.fair = fair;
  options.max_diameter = max_diameter;
  options.allow_self_intersections = true;
  options.coordinate = coordinate_;
  const FillResult result = fill_holes(after, options, progress_);
  if (result.filled() == 0) return;
  RepairStep step;
  step.operation = options;
  add_finding(step, result.filled(), "hole", "filled");
  add_finding(step, result.cut_edges, "edge", "cut where bodies touch");
  record(std::move(after), std::move(step));
}

void RepairSteps::clean() {
  CleanOptions options;
  options.coordinate = coordinate_;
  CleanResult result = transformesh::clean(mesh_, options, progress_);
  if (!result.changed) return;
  RepairStep step;
  step.operation = options;
  add_finding(step, result.pairs, "pair", "of intersecting faces resolved");
  add_finding(step, result.removed_faces, "face", "dropped inside of others or on them");
  add_finding(step, result.copied_vertices, "vertex", "copied where sheets touch");
  record(std::move(result.mesh), std::move(step));
}

void RepairSteps::drop_components(double least_area) {
  SelectionOptions options;
  options.by = ComponentSize::area;
  options.at_least = least_area;
  Mesh after = mesh_;
  const std::size_t before = connected_components(mesh_).components.size();
  select(after, options);
  const std::size_t dropped = before - connected_components(after).components.size();
  RepairStep step;
  step.operation = options;
  add_finding(step, dropped, "component", "dropped as small components");
  record(std::move(after), std::move(step));
}

}  // namespace transformesh
