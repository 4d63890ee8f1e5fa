#include "transformesh/repair.h"

#include <cmath>

#include "clean/open/borders.h"
#include "clean/stitch/double_sided.h"
#include "clean/stitch/outward_bodies.h"
#include "geometry/numbers/predicates.h"
#include "geometry/search/closest_point.h"
#include "mesh/local_measures.h"
#include "mesh/location_text.h"
#include "repair/crack_tolerance.h"
#include "repair/losses.h"
#include "repair/repair_steps.h"
#include "repair/shards.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/check_mesh.h"
#include "transformesh/compare.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Holes get smooth patches if the diagonal of their bounding box is at most this share of the
/// model's diagonal. Larger holes get flat patches, near the places where the generalized winding
/// number of the open surface is 1/2; a smooth patch would turn an open bowl into a ball. With a
/// larger share, patches of openings bulge; with a smaller share, flat patches leave dents in
/// curved surfaces.
constexpr double small_hole = 0.1;

/// Largest number of rounds of filling and cleaning. Cleaning closes slits that filling leaves, and
/// the second round fills holes that cleaning leaves. More rounds have never helped.
constexpr int most_rounds = 3;

bool is_oriented_manifold(const Mesh& mesh) {
  return check_manifold(mesh).isolated_vertices.empty() && is_oriented_by_indices(weld(mesh), mesh);
}

bool is_solid(const MeshCheck& check, bool may_be_open) {
  return check.problems.empty() && check.degenerate_faces == 0 &&
         check.manifold.isolated_vertices.empty() && check.manifold.touching_borders == 0 &&
         (may_be_open || check.manifold.is_closed());
}

/// True if all faces have the same corner positions in the same order.
bool has_same_triangles(const Mesh& before, const Mesh& after) {
  if (before.faces.size() != after.faces.size()) return false;
  for (std::size_t f = 0; f < before.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      if (before.positions[before.faces[f][i]] != after.positions[after.faces[f][i]]) return false;
  return true;
}

class Repair {
 public:
  Repair(const Mesh& mesh, const RepairOptions& options, const Progress& progress)
      : input_(mesh),
        options_(options),
        progress_(progress),
        steps_(mesh, options.coordinate, progress) {}

  RepairResult run();

 private:
  MeshCheck check(bool intersections) const;
  bool is_done() const;
  void join();
  void stitch(StitchOptions options);
  void fill_and_clean();
  void fill();
  void turn();
  void drop_shards();
  void refuse_unless_solid() const;
  void refuse_large_change() const;

  const Mesh& input_;
  const RepairOptions& options_;
  const Progress& progress_;
  RepairSteps steps_;
  double crack_width_ = 0;
};

MeshCheck Repair::check(bool intersections) const {
  CheckMeshOptions options;
  options.closed = !options_.keep_open;
  options.intersections = intersections;
  options.coordinate = options_.coordinate;
  return check_mesh(steps_.mesh(), options, progress_);
}

// True if nothing needs repair. Intersections are searched last, because separate triangles that
// share edges intersect each other, which makes this search several times slower.
bool Repair::is_done() const {
  const Mesh& mesh = steps_.mesh();
  return is_solid(check(false), options_.keep_open) &&
         find_intersections(mesh, progress_).empty() && !has_inward_bodies(mesh) &&
         !has_bodies_in_bodies(mesh);
}

// Stitches the mesh. A one-sided surface cannot be oriented. It stays open at the edges where faces
// disagree.
void Repair::stitch(StitchOptions options) {
  try {
    steps_.stitch(options);
  } catch (const InputError& error) {
    if (error.kind() != ErrorKind::one_sided) throw;
    options.orient = options.one_side = false;
    steps_.stitch(options);
  }
}

void Repair::join() {
  const Mesh& mesh = steps_.mesh();
  const Cracks cracks = find_cracks(mesh);
  crack_width_ = cracks.width;
  StitchOptions options;
  options.tolerance = cracks.tolerance;
  options.one_side = needs_one_side(mesh, cracks.tolerance);
  options.orient = !options.one_side;
  options.outwards = options.drop_copies = true;
  const bool needs_none = cracks.tolerance == 0 && !options.one_side && is_oriented_manifold(mesh);
  if (!needs_none) stitch(options);
  if (steps_.mesh().faces.empty())
    throw GoalError(
        "no face has three different corners, so nothing can be repaired: check how the file was "
        "written");
}

void Repair::fill() {
  const double diameter = small_hole * diagonal_of(bounding_box(steps_.mesh()));
  if (diameter > 0) steps_.fill(true, diameter);
  steps_.fill(false, std::numeric_limits<double>::infinity());
}

void Repair::turn() {
  if (!has_inward_bodies(steps_.mesh())) return;
  StitchOptions options;
  options.outwards = true;
  steps_.stitch(options);
}

void Repair::fill_and_clean() {
  for (int round = 0; round < most_rounds; ++round) {
    if (!options_.keep_open) fill();
    turn();
    steps_.clean();
    if (options_.keep_open || check_manifold(steps_.mesh()).is_closed()) return;
  }
}

void Repair::drop_shards() {
  const double area = least_area(steps_.mesh());
  if (area > 0) steps_.drop_components(area);
}

void Repair::refuse_unless_solid() const {
  const MeshCheck found = check(true);
  if (is_solid(found, options_.keep_open)) return;
  const Mesh& mesh = steps_.mesh();
  if (const std::vector<Index> flat = degenerate_faces(mesh); !flat.empty())
    throw GoalError(counted(flat.size(), "face") +
                    " without area cannot be removed, the first at " +
                    rough_point_text(face_middle(mesh, flat[0])));
  if (found.problems.empty())
    throw GoalError(counted(found.manifold.touching_borders, "border edge") +
                    " that coincide cannot be joined");
  throw GoalError(found.problems.front());
}

void Repair::refuse_large_change() const {
  if (!std::isfinite(options_.max_change) || steps_.mesh().faces.empty()) return;
  const Farthest farthest = farthest_from(ClosestPointQuery(input_), steps_.mesh());
  if (farthest.distance <= options_.max_change) return;
  throw GoalError("the repaired surface is " + significant(farthest.distance, 3) +
                  " away from the input at " + rough_point_text(farthest.point) +
                  ", more than the change that is allowed");
}

RepairResult Repair::run() {
  RepairResult result;
  const Sizes before = sizes_of(input_);
  if (!is_done()) {
    join();
    fill_and_clean();
    drop_shards();
    refuse_unless_solid();
    refuse_large_change();
  }
  result.same_triangles = has_same_triangles(input_, steps_.mesh());
  result.steps = steps_.take_steps();
  result.mesh = steps_.take_mesh();
  const Sizes after = sizes_of(result.mesh);
  result.crack_width = crack_width_;
  result.area_before = before.area;
  result.area_after = after.area;
  result.volume_before = before.volume;
  result.volume_after = after.volume;
  return result;
}

}  // namespace

RepairResult repair(const Mesh& mesh, const RepairOptions& options, const Progress& progress) {
  if (!(options.max_change > 0)) throw UsageError("the largest change must be greater than 0");
  if (mesh.faces.empty()) throw GoalError("a mesh without faces cannot be a solid");
  return Repair(mesh, options, progress).run();
}

}  // namespace transformesh
