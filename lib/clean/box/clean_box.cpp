#include "clean/box/clean_box.h"

#include <algorithm>
#include <string>

#include "clean/box/box_submesh.h"
#include "clean/box/replace_faces.h"
#include "clean/exterior/exterior_arrangement.h"
#include "clean/intersect/find_meetings.h"
#include "clean/rounding/snap_rounding.h"
#include "clean/stitch/assemble.h"
#include "clean/whole/clean_whole.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/surface_columns.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

namespace transformesh {
namespace {

constexpr double margin_spacings = 64;
constexpr std::size_t most_faces_at_once = std::size_t{1} << 16;
constexpr char source_name[] = "source face of a box";

std::size_t count(const std::vector<bool>& faces) {
  return static_cast<std::size_t>(std::count(faces.begin(), faces.end(), true));
}

/// What is in and around a box, arranged.
class BoxPart {
 public:
  BoxPart(const Mesh& mesh, const std::vector<bool>& is_own, const CleanOptions& options,
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
  const CleanOptions& options_;
  const Progress& progress_;
  std::vector<bool> is_complete_, is_in_part_;  ///< per face of the mesh
  BoxSubmesh part_;
  std::shared_ptr<const WeldedMesh> welded_;
  std::vector<Meeting> meetings_;
};

std::vector<bool> BoxPart::near(const std::vector<bool>& faces) const {
  const Box box = box_around(mesh_, faces);
  const Vec3 farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
  return faces_near(mesh_, box, margin_spacings * spacing_around(farthest, options_.coordinate));
}

// The pieces of the box's faces depend on those beside them where they are rounded; these on all
// that meet them, and on whether that lies in one plane with others. Each adds a ring.
void BoxPart::find_complete() {
  is_complete_ = near(near(is_own_));
  do {
    progress_("intersect");
    is_in_part_ = near(near(is_complete_));
    part_ = take_submesh(mesh_, is_in_part_);
    welded_ = std::make_shared<const WeldedMesh>(weld(part_.mesh));
    meetings_ = find_meetings(*welded_, progress_);
  } while (complete_planes());
}

// Faces that are cut together must all be complete. Returns whether there are more now.
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
  around.faces = FarFaces(mesh_, is_in_part_, reach.min(), reach.max());

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

// The whole mesh cleaned, with its faces numbered on the way.
CleanedFaces clean_numbered(const Mesh& mesh, const CleanOptions& options, CleanResult& counts,
                            const Progress& progress) {
  Mesh numbered = mesh;
  Column& column = numbered.face_columns.get(source_name, Scalar::uint32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) column.values[f] = static_cast<double>(f);
  CleanOptions how;
  how.winding_level = options.winding_level;
  how.coordinate = options.coordinate;
  counts = clean_whole(numbered, how, progress);
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
  std::vector<bool> is_new(cleaned.mesh.positions.size(), false), is_corner = is_new;
  for (std::size_t p = 0; p < cleaned.source_face.size(); ++p) {
    const Index source = cleaned.source_face[p];
    if (!is_own[source]) continue;
    const Triangle t = triangle_of(mesh, source);
    for (const Index v : cleaned.mesh.faces[p]) {
      const Vec3& position = cleaned.mesh.positions[v];
      const bool is_at_one = std::find(t.begin(), t.end(), position) != t.end();
      is_corner[v] = is_corner[v] || is_at_one;
      is_new[v] = !is_corner[v];
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

void finish_counts(const CleanOptions& options, CleanResult& counts) {
  counts.changed = counts.cut_faces + counts.removed_faces > 0;
  if (!options.refuse || !counts.changed) return;
  throw GoalError(ErrorKind::needs_cleaning,
                  "the box needs cleaning (" + std::to_string(counts.pairs) +
                      " intersecting face pairs, " + std::to_string(counts.cut_faces) +
                      " faces to cut, " + std::to_string(counts.removed_faces) + " to remove)",
                  {.counts = {counts.pairs, counts.cut_faces, counts.removed_faces}});
}

// The box cut through the middle of its faces, along the axis on which they reach farthest. Nothing
// where that leaves one half empty.
std::optional<std::array<Box, 2>> split(const Mesh& mesh, const std::vector<bool>& is_own,
                                        const Box& box) {
  const Box around = box_around(mesh, is_own);
  const Vec3 low = around.min().cwiseMax(box.min()), high = around.max().cwiseMin(box.max());
  int axis = 0;
  (high / 2 - low / 2).maxCoeff(&axis);
  std::array<Box, 2> halves{box, box};
  halves[0].max()[axis] = halves[1].min()[axis] = low[axis] / 2 + high[axis] / 2;
  const std::size_t first = count(faces_of_box(mesh, halves[0]));
  if (first == 0 || first == count(is_own)) return std::nullopt;
  return halves;
}

void check_input(const Mesh& mesh, const CleanOptions& options) {
  if (!(options.box->min().array() < options.box->max().array()).all())
    throw UsageError("the box has no inside: its first corner must be below the second");
  if (mesh.faces.empty()) throw InputError("the mesh has no faces: there is nothing to clean");
  if (is_closed_chain(mesh)) return;
  throw InputError(ErrorKind::box_in_open_mesh,
                   "a box can be cleaned in a closed oriented mesh only, and here faces are left "
                   "over along edges");
}

void drop_stale_columns(CleanResult& counts) {
  if (counts.cut_faces == 0) return;
  counts.dropped_columns = drop_corner_lists(counts.mesh.face_columns);
  counts.dropped_source_points = drop_source_points(counts.mesh);
}

CleanResult clean_in_place(const Mesh& mesh, const CleanOptions& options,
                           const Progress& progress) {
  CleanResult counts;
  const std::vector<bool> is_own = faces_of_box(mesh, *options.box);
  const std::size_t box_faces = count(is_own);
  if (box_faces > 0) {
    std::optional<CleanedFaces> cleaned = BoxPart(mesh, is_own, options, progress).clean(counts);
    const bool is_whole = !cleaned;
    if (!cleaned) cleaned = clean_numbered(mesh, options, counts, progress);
    counts.is_whole = is_whole;
    count_faces(mesh, is_own, *cleaned, counts);
    finish_counts(options, counts);
    if (counts.changed) counts.mesh = replace_faces(mesh, is_own, *cleaned);
  }
  if (!counts.changed) counts.mesh = mesh;
  counts.box_faces = box_faces;
  drop_stale_columns(counts);
  return counts;
}

/// The pieces of the box's faces, from smaller boxes one after the other: what that takes does not
/// grow with the box.
class Pieces {
 public:
  Pieces(const Mesh& mesh, const CleanOptions& options, const Progress& progress)
      : mesh_(mesh), options_(options), progress_(progress) {}
  CleanResult collect();

 private:
  bool collect_from(const Box& box);
  void collect_from_whole();
  void add(const Mesh& pieces);

  const Mesh& mesh_;
  const CleanOptions& options_;
  const Progress& progress_;
  CleanResult result_;
};

void Pieces::add(const Mesh& pieces) {
  Mesh& mesh = result_.mesh;
  const auto offset = static_cast<Index>(mesh.positions.size());
  mesh.vertex_columns.concatenate(pieces.vertex_columns, offset, pieces.positions.size());
  mesh.face_columns.concatenate(pieces.face_columns, mesh.faces.size(), pieces.faces.size());
  mesh.positions.insert(mesh.positions.end(), pieces.positions.begin(), pieces.positions.end());
  for (const auto& [a, b, c] : pieces.faces)
    mesh.faces.push_back({a + offset, b + offset, c + offset});
}

// Returns whether rounding broke nothing.
bool Pieces::collect_from(const Box& box) {
  const std::vector<bool> is_own = faces_of_box(mesh_, box);
  const std::size_t faces = count(is_own);
  if (faces == 0) return true;
  if (faces > most_faces_at_once) {
    const auto halves = split(mesh_, is_own, box);
    if (halves) return collect_from((*halves)[0]) && collect_from((*halves)[1]);
  }
  CleanResult counts;
  const auto cleaned = BoxPart(mesh_, is_own, options_, progress_).clean(counts);
  if (!cleaned) return false;
  count_faces(mesh_, is_own, *cleaned, counts);
  CleanResult& sum = result_;
  sum.pairs += counts.pairs;
  sum.pieces += counts.pieces;
  sum.rays += counts.rays;
  sum.cut_faces += counts.cut_faces;
  sum.removed_faces += counts.removed_faces;
  sum.new_vertices += counts.new_vertices;
  sum.rounding_displacement = std::max(sum.rounding_displacement, counts.rounding_displacement);
  sum.rounding_spacings = std::max(sum.rounding_spacings, counts.rounding_spacings);
  add(own_pieces(*cleaned, is_own));
  return true;
}

void Pieces::collect_from_whole() {
  const std::vector<bool> is_own = faces_of_box(mesh_, *options_.box);
  const CleanedFaces cleaned = clean_numbered(mesh_, options_, result_, progress_);
  result_.is_whole = true;
  count_faces(mesh_, is_own, cleaned, result_);
  result_.mesh = own_pieces(cleaned, is_own);
}

CleanResult Pieces::collect() {
  result_.mesh = select_faces(mesh_, std::vector<bool>(mesh_.faces.size(), false));
  if (!collect_from(*options_.box)) collect_from_whole();
  result_.box_faces = count(faces_of_box(mesh_, *options_.box));
  finish_counts(options_, result_);
  drop_stale_columns(result_);
  return std::move(result_);
}

}  // namespace

CleanResult clean_box(const Mesh& mesh, const CleanOptions& options, const Progress& progress) {
  check_input(mesh, options);
  return options.only ? Pieces(mesh, options, progress).collect()
                      : clean_in_place(mesh, options, progress);
}

}  // namespace transformesh
