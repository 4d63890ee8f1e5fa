#include "clean/box/box_part.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clean/box/find_reference.h"
#include "clean/exterior/exterior_arrangement.h"
#include "clean/intersect/find_meetings.h"
#include "clean/rounding/snap_rounding.h"
#include "clean/stitch/assemble.h"
#include "transformesh/errors.h"

namespace transformesh {

Region whole_region(const Mesh& mesh) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CellSize cells;
  for (Index f = 0; f < mesh.faces.size(); ++f) cells.add(triangle_of(mesh, f));
  const Vec3 outside =
      cells.bounds().min().unaryExpr([](double x) { return std::nextafter(x, -infinity); });
  return {true, {Vec3::Constant(-infinity), Vec3::Constant(infinity)}, {outside, 0}, cells.size()};
}

BoxPart::BoxPart(const Mesh& mesh, const Region& region, const std::vector<bool>& is_own,
                 const CleanOptions& options, const Progress& progress)
    : mesh_(mesh),
      region_(region),
      is_own_(is_own),
      options_(options),
      progress_(progress),
      grid_(region.cell_size) {}

// Finds the complete faces (of which all pieces are needed) and the part of the mesh to arrange.
// The part also contains all faces that touch `own_box_`, the box of the faces to clean. Paths from
// the reference point, a point with known winding number, to these faces are in this box.
void BoxPart::find_complete() {
  own_box_ = with_margin(first_vertices(mesh_, is_own_), options_.coordinate);
  const std::vector<bool> is_between = faces_near(mesh_, own_box_);
  std::optional<FacesAround> faces(std::in_place, mesh_, is_own_, grid_, options_.coordinate);
  for (int ring = 0; ring < rings_of_complete; ++ring) faces->grow();
  is_complete_ = faces->faces();
  bool has_added = false;
  while (true) {
    progress_("intersect");
    faces->grow();
    std::vector<bool> is_in_part = faces->next();
    for (std::size_t f = 0; f < is_in_part.size(); ++f)
      is_in_part[f] = is_in_part[f] || is_between[f];
    covered_ = faces->take_cells();
    part_ = take_submesh(mesh_, is_in_part);
    welded_ = std::make_shared<const WeldedMesh>(weld(part_.mesh));
    meetings_ = find_meetings(*welded_, progress_);
    if (!complete_planes()) break;
    has_added = true;
    faces.emplace(mesh_, is_complete_, grid_, options_.coordinate);
  }
  if (has_added && !region_.is_whole) check_held();
}

// Adds faces to the complete faces: if one of several coplanar faces that are cut together is
// complete, all of them must be. Returns true if faces were added.
bool BoxPart::complete_planes() {
  const Planes planes(*welded_, meetings_);
  std::vector<char> is_wanted(planes.size(), 0);
  const auto is_complete = [&](Index f) {
    return is_complete_[part_.face_of[welded_->face_of[f]]];
  };
  for (Index f = 0; f < welded_->faces.size(); ++f)
    if (!planes.is_whole(f) && is_complete(f)) is_wanted[planes.plane_of(f)] = 1;
  bool has_more = false;
  for (Index f = 0; f < welded_->faces.size(); ++f) {
    if (planes.is_whole(f) || !is_wanted[planes.plane_of(f)] || is_complete(f)) continue;
    is_complete_[part_.face_of[welded_->face_of[f]]] = true;
    has_more = true;
  }
  return has_more;
}

// Throws GoalError if the loaded part of the mesh lacks faces around complete faces (of which all
// pieces are needed). Faces around the first two rings are loaded in any case. complete_planes()
// may have added complete faces beyond them. The box `region_.held` must contain the grid cells
// around these faces.
void BoxPart::check_held() const {
  FacesAround around(mesh_, is_own_, grid_, options_.coordinate);
  for (int ring = 0; ring < rings_of_complete; ++ring) around.grow();
  std::vector<bool> others = is_complete_;
  for (std::size_t f = 0; f < others.size(); ++f) others[f] = others[f] && !around.faces()[f];
  if (std::find(others.begin(), others.end(), true) == others.end()) return;
  const FacesAround around_others(mesh_, others, grid_, options_.coordinate);
  if (are_held(others) && are_held(around_others.next())) return;
  throw GoalError(
      "faces in one plane reach beyond the tile and are cut together: use fewer and larger tiles, "
      "or clean the whole mesh at once");
}

bool BoxPart::are_held(const std::vector<bool>& faces) const {
  Box box = with_margin(box_around(mesh_, faces), options_.coordinate);
  box.min().array() -= region_.cell_size;
  box.max().array() += region_.cell_size;
  return region_.held.contains(box);
}

void BoxPart::count_pairs(CleanResult& counts) const {
  const auto is_own = [&](Index f) { return is_own_[part_.face_of[welded_->face_of[f]]]; };
  for (const Meeting& meeting : meetings_)
    if (is_own(meeting.first) || is_own(meeting.second)) ++counts.pairs;
}

Surroundings BoxPart::surroundings() {
  Surroundings around;
  for (const Index f : welded_->face_of)
    around.is_complete.push_back(is_complete_[part_.face_of[f]] ? 1 : 0);
  around.held = own_box_;
  around.reference = find_reference(mesh_, region_.reference, own_box_);
  around.grid = grid_;
  around.covered = std::move(covered_);
  return around;
}

std::optional<CleanedFaces> BoxPart::clean(CleanResult& counts) {
  find_complete();
  count_pairs(counts);
  const Surroundings around = surroundings();
  const ExteriorArrangement exterior =
      arrange_exterior(welded_, meetings_, {options_.winding_level, false, &around}, progress_);
  counts.pieces = exterior.arrangement.pieces.size();
  counts.rays = exterior.rays;
  const std::vector<char> kept(exterior.arrangement.pieces.size(), 1);
  progress_("stitch");
  Assembly assembly = assemble(part_.mesh, exterior.arrangement, kept);
  progress_("round");
  const FirstRound rounded = round_once(assembly, options_.coordinate);
  if (rounded.places > 0) {
    counts.rounding_places = rounded.places;
    return std::nullopt;
  }
  counts.rounding_displacement = rounded.displacement.length;
  counts.rounding_spacings = rounded.displacement.spacings;
  for (Index& face : assembly.source_face) face = part_.face_of[face];
  return CleanedFaces{std::move(assembly.mesh), std::move(assembly.source_face)};
}

}  // namespace transformesh
