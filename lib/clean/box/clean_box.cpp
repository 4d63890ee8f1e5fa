#include "clean/box/clean_box.h"

#include <algorithm>
#include <string>

#include "clean/box/box_part.h"
#include "clean/box/box_submesh.h"
#include "clean/whole/clean_whole.h"
#include "mesh/surface_columns.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

namespace transformesh {
namespace {

/// A box with more faces than this is divided into parts of at most this many faces. Each part also
/// processes the faces around it. A box with a million folded faces takes 5.7 s and 157 MB. It
/// takes 8.3 s and 123 MB with 2^16, and 3.3 s and 360 MB with 2^20.
constexpr std::size_t most_faces_at_once = std::size_t{1} << 18;
constexpr const char* source_name = "source face of a box";

std::size_t count(const std::vector<bool>& faces) {
  return static_cast<std::size_t>(std::count(faces.begin(), faces.end(), true));
}

// Cleans the whole mesh, and records from which input face each face is cut.
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

// Counts the new vertices: those of pieces of own faces (faces of the box) that are not corners of
// the faces from which the pieces are cut.
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

// Stores the numbers of cut faces, removed faces and new vertices in `counts`. Only own faces (the
// faces of the box) count.
void count_faces(const Mesh& mesh, const std::vector<bool>& is_own, const CleanedFaces& cleaned,
                 CleanResult& counts) {
  const std::vector<bool> is_uncut = find_uncut(mesh, cleaned);
  // For each face 0 if it is removed, 1 if cut, 2 if whole.
  std::vector<char> pieces(mesh.faces.size(), 0);
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

// Splits the box at the middle of its faces, along the axis of their largest extent. Returns
// nothing if one half would be empty.
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
    throw UsageError(
        "the box is empty: each coordinate of its first corner must be less than that of its "
        "second corner");
  if (mesh.faces.empty()) throw InputError("the mesh has no faces: there is nothing to clean");
  if (face_sums(mesh).is_closed()) return;
  throw InputError(ErrorKind::box_in_open_mesh,
                   "a box can be cleaned only in a closed oriented mesh, but some edges are not "
                   "traversed equally often in both directions");
}

// Rejects options that need the whole mesh. A tile is a part of a mesh that is cleaned alone; its
// data defines the box.
void check_tile_options(const Tile& tile, const CleanOptions& options) {
  if (options.coordinate == Scalar::float32 && tile.coordinate != Scalar::float32)
    throw UsageError(
        "the tile was made for 64-bit coordinates: 32-bit floats are too coarse for its faces");
  const char* const refused = options.box                              ? "a box"
                              : options.method != ExteriorMethod::grow ? "the static test"
                              : options.outermost                      ? "outermost"
                              : options.merge_flat                     ? "merging flat faces"
                              : options.separate > 0                   ? "separate"
                              : options.sources != CleanSources::none  ? "a source"
                                                                       : nullptr;
  if (refused)
    throw UsageError(std::string(refused) + " needs the whole mesh and cannot be used for a tile");
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
    const Region region = whole_region(mesh);
    std::optional<CleanedFaces> cleaned =
        BoxPart(mesh, region, is_own, options, progress).clean(counts);
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

/// Cleans a box in parts, one after the other, and collects the pieces. Thus the memory for
/// cleaning does not grow with the box.
class Pieces {
 public:
  Pieces(const Mesh& mesh, const Region& region, const CleanOptions& options,
         const Progress& progress)
      : mesh_(mesh), region_(region), options_(options), progress_(progress) {}
  CleanResult collect();

 private:
  bool collect_from(const Box& box);
  void collect_from_whole();
  void add(const Mesh& pieces);

  const Mesh& mesh_;
  const Region& region_;
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

// Collects the pieces of the faces in a box. Returns false if faces intersect or have no area after
// rounding.
bool Pieces::collect_from(const Box& box) {
  const std::vector<bool> is_own = faces_of_box(mesh_, box);
  const std::size_t faces = count(is_own);
  if (faces == 0) return true;
  if (region_.is_whole && faces > most_faces_at_once) {
    const auto halves = split(mesh_, is_own, box);
    if (halves) return collect_from((*halves)[0]) && collect_from((*halves)[1]);
  }
  CleanResult counts;
  const auto cleaned = BoxPart(mesh_, region_, is_own, options_, progress_).clean(counts);
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
  if (!region_.is_whole)
    throw GoalError(
        "rounding makes faces intersect in the tile, and removing these intersections needs the "
        "whole mesh");
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
  if (!options.only) return clean_in_place(mesh, options, progress);
  const Region region = whole_region(mesh);
  return Pieces(mesh, region, options, progress).collect();
}

CleanResult clean_tile(const Mesh& mesh, const Tile& tile, const CleanOptions& options,
                       const Progress& progress) {
  check_tile_options(tile, options);
  if (face_sums(mesh).hash() != tile.faces)
    throw InputError(
        "the mesh differs from the tile that its comment describes: it was changed after tiling");
  CellSize least;
  for (Index f = 0; f < mesh.faces.size(); ++f) least.add(triangle_of(mesh, f));
  if (!mesh.faces.empty() && !(tile.cell_size >= least.least()))
    throw InputError("the comment of the tile states a cell size that is too small for the mesh");
  CleanOptions how = options;
  how.box = tile.own;
  how.only = true;
  const Region region{false, tile.held, tile.reference, tile.cell_size};
  return Pieces(mesh, region, how, progress).collect();
}

}  // namespace transformesh
