#include "tm/clean/clean_box.h"

#include <algorithm>
#include <string>

#include "tm/clean/box/mesh_part.h"
#include "tm/clean/box/put_in_place.h"
#include "tm/clean/exterior/exterior_arrangement.h"
#include "tm/clean/intersect/intersect.h"
#include "tm/clean/rounding/snap_rounding.h"
#include "tm/clean/stitch/assemble.h"
#include "tm/mesh/components.h"
#include "tm/mesh/digits.h"
#include "tm/mesh/surface_columns.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

constexpr double margin_spacings = 64;
constexpr char source_name[] = "source face of a box";

/// What is in and around a box, arranged.
class BoxPart {
 public:
  BoxPart(const Mesh& mesh, const std::vector<bool>& is_own, const CleanBoxOptions& options,
          const Progress& progress)
      : mesh_(mesh), is_own_(is_own), options_(options), progress_(progress) {}

  /// Nothing where rounding breaks faces in or beside the box.
  std::optional<CleanedFaces> clean(CleanResult& counts);

 private:
  std::vector<bool> near(const std::vector<bool>& faces) const;
  void find_complete();
  bool complete_planes();
  void count_pairs(CleanResult& counts) const;

  const Mesh& mesh_;
  const std::vector<bool>& is_own_;
  const CleanBoxOptions& options_;
  const Progress& progress_;
  std::vector<bool> is_complete_, is_in_part_;  ///< per face of the mesh
  MeshPart part_;
  std::shared_ptr<const WeldedMesh> welded_;
  std::vector<Meeting> meetings_;
};

std::vector<bool> BoxPart::near(const std::vector<bool>& faces) const {
  const Box box = box_around(mesh_, faces);
  const Vec3 farthest = box.minimum.cwiseAbs().cwiseMax(box.maximum.cwiseAbs());
  return faces_near(mesh_, box, margin_spacings * spacing_around(farthest, options_.coordinate));
}

// The pieces of the box's faces depend on those beside them where they are rounded; these on all
// that meet them, and on whether that lies in one plane with others. Each adds a ring.
void BoxPart::find_complete() {
  is_complete_ = near(near(is_own_));
  do {
    progress_("intersect");
    is_in_part_ = near(near(is_complete_));
    part_ = take_part(mesh_, is_in_part_);
    welded_ = std::make_shared<const WeldedMesh>(weld(part_.mesh));
    meetings_ = find_meetings(*welded_, progress_);
  } while (complete_planes());
}

// Faces that are cut together must all be complete. Returns whether there are more now.
bool BoxPart::complete_planes() {
  const Planes planes(*welded_, meetings_);
  std::vector<char> is_wanted(planes.size(), 0);
  const auto is_complete = [&](Index f) { return is_complete_[part_.face_of[welded_->face_of[f]]]; };
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

void BoxPart::count_pairs(CleanResult& counts) const {
  const auto is_own = [&](Index f) { return is_own_[part_.face_of[welded_->face_of[f]]]; };
  for (const Meeting& meeting : meetings_)
    if (is_own(meeting.first) || is_own(meeting.second)) ++counts.pairs;
}

std::optional<CleanedFaces> BoxPart::clean(CleanResult& counts) {
  find_complete();
  count_pairs(counts);
  Surroundings around;
  for (const Index f : welded_->face_of)
    around.is_complete.push_back(is_complete_[part_.face_of[f]] ? 1 : 0);
  const Box reach = box_around(mesh_, is_complete_);
  around.faces = FarFaces(mesh_, is_in_part_, reach.minimum, reach.maximum);

  const ExteriorArrangement exterior =
      arrange_exterior(welded_, meetings_, options_.level, progress_, &around);
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

// The whole mesh cleaned, with its faces numbered on the way.
CleanedFaces clean_whole(const Mesh& mesh, const CleanBoxOptions& options, CleanResult& counts,
                         const Progress& progress) {
  Mesh numbered = mesh;
  Column& column = numbered.face_columns.get(source_name, Scalar::uint32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) column.values[f] = static_cast<double>(f);
  CleanOptions how;
  how.level = options.level;
  how.coordinate = options.coordinate;
  counts = clean(numbered, how, progress);
  CleanedFaces cleaned{std::move(counts.mesh), {}};
  for (const double face : cleaned.mesh.face_columns.find(source_name)->values)
    cleaned.source_face.push_back(static_cast<Index>(face));
  cleaned.mesh.face_columns.erase(source_name);
  counts.connectivity.reset();
  return cleaned;
}

// Vertices of the box's pieces that are at no corner of their sources.
std::size_t count_new_vertices(const Mesh& mesh, const std::vector<bool>& is_own,
                               const CleanedFaces& cleaned) {
  std::vector<bool> is_new(cleaned.mesh.positions.size(), false);
  for (std::size_t p = 0; p < cleaned.source_face.size(); ++p) {
    const Index source = cleaned.source_face[p];
    if (!is_own[source]) continue;
    const Triangle t = triangle_of(mesh, source);
    for (const Index v : cleaned.mesh.faces[p]) {
      const Vec3& position = cleaned.mesh.positions[v];
      is_new[v] = position != t[0] && position != t[1] && position != t[2];
    }
  }
  return static_cast<std::size_t>(std::count(is_new.begin(), is_new.end(), true));
}

// Of the box's own faces: what was cut, what is gone, and which vertices are new.
void count_faces(const Mesh& mesh, const std::vector<bool>& is_own, const CleanedFaces& cleaned,
                 CleanResult& counts) {
  const std::vector<bool> is_uncut = find_uncut(mesh, cleaned);
  std::vector<char> pieces(mesh.faces.size(), 0);  // 1 cut, 2 whole
  for (std::size_t p = 0; p < is_uncut.size(); ++p)
    pieces[cleaned.source_face[p]] = is_uncut[p] ? 2 : 1;
  counts.cut_faces = counts.removed_faces = 0;
  for (std::size_t f = 0; f < pieces.size(); ++f)
    if (is_own[f] && pieces[f] != 2) ++(pieces[f] == 1 ? counts.cut_faces : counts.removed_faces);
  counts.new_vertices = count_new_vertices(mesh, is_own, cleaned);
}

Mesh own_pieces(const CleanedFaces& cleaned, const std::vector<bool>& is_own) {
  std::vector<bool> keep(cleaned.source_face.size());
  for (std::size_t p = 0; p < keep.size(); ++p) keep[p] = is_own[cleaned.source_face[p]];
  return select_faces(cleaned.mesh, keep);
}

void refuse_change(const CleanResult& counts) {
  throw GoalError("the box needs cleaning (" + std::to_string(counts.pairs) +
                  " intersecting face pairs, " + std::to_string(counts.cut_faces) +
                  " faces to cut, " + std::to_string(counts.removed_faces) +
                  " to remove) and --refuse forbids it");
}

}  // namespace

CleanBoxResult clean_box(const Mesh& mesh, const CleanBoxOptions& options,
                         const Progress& progress) {
  if (!(options.box.minimum.array() < options.box.maximum.array()).all())
    throw UsageError("the box has no inside: its first corner must be below the second");
  if (mesh.faces.empty()) throw InputError("the mesh has no faces: there is nothing to clean");
  if (!is_closed_chain(mesh))
    throw InputError("a box can be cleaned in a closed oriented mesh only, and here faces are left "
                     "over along edges: tm-checkmanifold names them, tm-fill closes holes, and "
                     "tm-clean without --box takes open meshes");
  CleanBoxResult result;
  CleanResult& counts = result.clean;
  const std::vector<bool> is_own = faces_of_box(mesh, options.box);
  result.box_faces = static_cast<std::size_t>(std::count(is_own.begin(), is_own.end(), true));
  if (result.box_faces == 0) {
    counts.mesh = options.only ? select_faces(mesh, is_own) : mesh;
    return result;
  }

  std::optional<CleanedFaces> cleaned = BoxPart(mesh, is_own, options, progress).clean(counts);
  if (!cleaned) {
    result.is_whole = true;
    cleaned = clean_whole(mesh, options, counts, progress);
  }
  count_faces(mesh, is_own, *cleaned, counts);
  counts.changed = counts.cut_faces + counts.removed_faces > 0;
  if (options.refuse && counts.changed) refuse_change(counts);
  if (options.only) {
    counts.mesh = own_pieces(*cleaned, is_own);
  } else {
    counts.mesh = counts.changed ? put_in_place(mesh, is_own, *cleaned) : mesh;
  }
  if (counts.cut_faces > 0) counts.dropped_columns = drop_corner_lists(counts.mesh.face_columns);
  return result;
}

}  // namespace transformesh
