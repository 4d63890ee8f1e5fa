#include "transformesh/fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <unordered_map>

#include "fill/contact_edges.h"
#include "fill/face_search.h"
#include "fill/hole_loops.h"
#include "fill/hole_neighborhood.h"
#include "fill/hole_patch.h"
#include "fill/openings.h"
#include "geometry/numbers/predicates.h"
#include "mesh/adjacency.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/surface_columns.h"
#include "mesh/triangle.h"
#include "support/error_prefix.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Number of faces in the first sample of a patch, and ratio of the sizes of successive samples.
/// All samples of a patch together have at most a tenth as many faces as the patch. Measured on
/// flat borders of 12000 edges with random radii: 1.6 s with samples, 27 s without.
constexpr std::size_t first_sample = 64, growth = 16;

void check(const Mesh& mesh, const ManifoldReport& found, const FillOptions& options) {
  if (options.max_edges < 3)
    throw UsageError("a hole has at least 3 edges: the limit must be 3 or more");
  if (!(options.max_diameter > 0)) throw UsageError("the largest diameter must be greater than 0");
  // Vertices with several umbrellas are separated after holes are filled.
  const bool may_touch =
      !found.is_closed() && found.nonmanifold_edges.empty() && found.collapsed_faces.empty();
  if (!(found.is_manifold() || may_touch) || !found.is_oriented())
    throw InputError(prefixed("holes are filled only in oriented manifolds, but ",
                              manifold_problem(mesh, found, false)));
}

bool is_too_large(const Mesh& mesh, const HoleLoop& loop, const FillOptions& options) {
  Box box;
  for (const Index h : loop) box.extend(mesh.positions[halfedge_source(mesh, h)]);
  return loop.size() > options.max_edges || box.diagonal().stableNorm() > options.max_diameter;
}

class Filler {
 public:
  Filler(Mesh& mesh, const FillOptions& options)
      : mesh_(mesh),
        options_(options),
        around_(mesh),
        search_(mesh),
        blends_(mesh.positions.size()) {}

  /// Fills a hole; only openings of openings.h have several loops.
  void fill(const std::vector<HoleLoop>& loops);
  /// Adds the attributes (column rows) of the new vertices and faces, and returns the result.
  FillResult finish();
  FillResult& result() { return result_; }

 private:
  void fill_loop(const HoleLoop& loop);
  bool fill_opening(const std::vector<HoleLoop>& loops);
  HoleNeighborhood part_around(const HoleLoop& loop, std::vector<Index>& faces) const;
  PatchKind finest() const;
  bool fits(const HolePatch& patch, const HoleNeighborhood& part, bool may_intersect) const;
  bool crosses(const HolePatch& patch, const HoleNeighborhood& part) const;
  /// Adds the first patch in `found` that fits into the hole, and returns true if there is one. If
  /// `may_intersect` is set, patches that intersect the mesh fit, too. Then the patch is added only
  /// if the options allow self-intersections.
  bool try_patches(const HoleLoop& loop, const HoleNeighborhood& part, const HolePatches& found,
                   bool may_intersect = false);
  HolePatches patches_of(const HoleNeighborhood& part, const HoleLoop& border, Search search) const;
  void round(HolePatches& found) const;
  void add(const HolePatch& patch, const HoleNeighborhood& part, const HoleLoop& loop);
  /// Describes the hole, with its first halfedge instead of a vertex.
  OpenHole open_hole(const HoleLoop& loop) const;
  std::vector<Index> vertices_of(const HoleLoop& loop) const;

  Mesh& mesh_;
  const FillOptions& options_;
  VertexFaces around_;                                   ///< faces of the input at each vertex
  std::unordered_map<Index, std::vector<Index>> added_;  ///< faces of patches at vertices
  FaceSearch search_;
  std::vector<RowBlend> blends_;
  FillResult result_;
};

OpenHole Filler::open_hole(const HoleLoop& loop) const {
  OpenHole hole{loop.front(), loop.size(), 0};
  for (const Index h : loop)
    hole.length +=
        (mesh_.positions[halfedge_target(mesh_, h)] - mesh_.positions[halfedge_source(mesh_, h)])
            .norm();
  return hole;
}

std::vector<Index> Filler::vertices_of(const HoleLoop& loop) const {
  std::vector<Index> vertices;
  for (const Index h : loop) vertices.push_back(halfedge_source(mesh_, h));
  return vertices;
}

/// True if the patch intersects itself or a nearby face of the mesh. Growing samples of the patch
/// are tested first: if every face of a patch intersects n others, all pairs would be too many.
bool Filler::crosses(const HolePatch& patch, const HoleNeighborhood& part) const {
  std::vector<Vec3> positions = part.mesh.positions;
  positions.insert(positions.end(), patch.points.begin(), patch.points.end());
  std::vector<Triangle> triangles;
  for (const Face& face : patch.faces) triangles.push_back(triangle_of(positions, face));

  std::vector<Triangle> sample;
  for (std::size_t count = first_sample; growth * count <= triangles.size(); count *= growth) {
    sample.clear();
    for (std::size_t i = 0; i < count; ++i)
      sample.push_back(triangles[i * triangles.size() / count]);
    if (search_.intersect(sample)) return true;
  }
  return search_.intersect(triangles);
}

bool Filler::fits(const HolePatch& patch, const HoleNeighborhood& part, bool may_intersect) const {
  Mesh joined = part.mesh;
  joined.positions.insert(joined.positions.end(), patch.points.begin(), patch.points.end());
  joined.faces.insert(joined.faces.end(), patch.faces.begin(), patch.faces.end());

  // The patch does not fit if one of its inner edges already exists in the mesh.
  const ManifoldReport found = check_manifold(joined);
  if (!found.nonmanifold_edges.empty() || !found.misoriented_edges.empty()) return false;
  const std::vector<Index> flat = degenerate_faces(joined);
  if (!flat.empty() && flat.back() >= part.mesh.faces.size()) return false;
  return may_intersect || !crosses(patch, part);
}

void Filler::add(const HolePatch& patch, const HoleNeighborhood& part, const HoleLoop& loop) {
  const auto first_new = static_cast<Index>(mesh_.positions.size());
  const auto known = static_cast<Index>(part.vertices.size());
  const BorderBlend blend(mesh_, vertices_of(loop));
  for (const Vec3& point : patch.points) {
    mesh_.positions.push_back(point);
    blends_.push_back(blend(point));
  }
  for (Face face : patch.faces) {
    for (Index& v : face) {
      v = v < known ? part.vertices[v] : first_new + v - known;
      added_[v].push_back(static_cast<Index>(mesh_.faces.size()));
    }
    mesh_.faces.push_back(face);
  }
  search_.update();
  result_.new_vertices += patch.points.size();
  result_.new_faces += patch.faces.size();
}

PatchKind Filler::finest() const {
  return !options_.refine ? PatchKind::plain
         : options_.fair  ? PatchKind::faired
                          : PatchKind::refined;
}

/// Returns the faces around a hole. Sets `faces` to their indices.
HoleNeighborhood Filler::part_around(const HoleLoop& loop, std::vector<Index>& faces) const {
  faces = faces_around(mesh_, vertices_of(loop), [&](Index v, std::vector<Index>& all) {
    if (v < blends_.size() - result_.new_vertices)
      all.insert(all.end(), around_[v].begin(), around_[v].end());
    if (const auto added = added_.find(v); added != added_.end())
      all.insert(all.end(), added->second.begin(), added->second.end());
  });
  return neighborhood_of(mesh_, faces);
}

void Filler::fill(const std::vector<HoleLoop>& loops) {
  if (loops.size() > 1 && fill_opening(loops)) return;
  for (const HoleLoop& loop : loops) fill_loop(loop);
}

bool Filler::fill_opening(const std::vector<HoleLoop>& loops) {
  HoleLoop all;
  for (const HoleLoop& loop : loops) all.insert(all.end(), loop.begin(), loop.end());
  const bool is_large = is_too_large(mesh_, all, options_);
  std::vector<Index> faces;
  const HoleNeighborhood part = part_around(all, faces);
  std::vector<HoleLoop> borders = loops;
  for (HoleLoop& border : borders)
    for (Index& h : border) h = halfedge_in_neighborhood(faces, h);
  HolePatches found = finer_patches(part.mesh, triangulate_opening(part.mesh, borders),
                                    is_large ? PatchKind::plain : finest());
  round(found);
  // At the border of a flat sheet with holes no patch fits, because it would be on the sheet.
  const auto fits_here = [&](const HolePatch& patch) { return fits(patch, part, false); };
  if (!(is_large ? std::ranges::any_of(found.patches, fits_here) : try_patches(all, part, found)))
    return false;
  if (is_large) result_.too_large.push_back(open_hole(all));
  ++result_.holes;
  return true;
}

void Filler::fill_loop(const HoleLoop& loop) {
  ++result_.holes;
  if (is_too_large(mesh_, loop, options_)) {
    result_.too_large.push_back(open_hole(loop));
    return;
  }
  std::vector<Index> faces;
  const HoleNeighborhood part = part_around(loop, faces);
  HoleLoop border;
  for (const Index h : loop) border.push_back(halfedge_in_neighborhood(faces, h));

  const HolePatches found = patches_of(part, border, Search::delaunay);
  if (try_patches(loop, part, found)) return;
  if (!found.are_of_all && loop.size() <= most_edges_of_all &&
      try_patches(loop, part, patches_of(part, border, Search::all)))
    return;
  const bool crosses = try_patches(loop, part, found, true);
  if (crosses && options_.allow_self_intersections) return;
  (crosses ? result_.crossing : result_.flat).push_back(open_hole(loop));
}

/// Rounds positions to the type in which they will be written.
void Filler::round(HolePatches& found) const {
  for (HolePatch& patch : found.patches)
    for (Vec3& point : patch.points) point = rounded_to(point, options_.coordinate);
}

HolePatches Filler::patches_of(const HoleNeighborhood& part, const HoleLoop& border,
                               Search search) const {
  const HoleNeighborhood apart = with_other_holes_apart(part.mesh, border);
  const auto known = static_cast<Index>(apart.vertices.size());
  const auto first_new = static_cast<Index>(part.vertices.size());
  HolePatches found = patch_hole(apart.mesh, border.front(), finest(), search);
  round(found);
  for (HolePatch& patch : found.patches)
    for (Face& face : patch.faces)
      for (Index& v : face) v = v < known ? apart.vertices[v] : first_new + v - known;
  return found;
}

bool Filler::try_patches(const HoleLoop& loop, const HoleNeighborhood& part,
                         const HolePatches& found, bool may_intersect) {
  for (const HolePatch& patch : found.patches) {
    if (!fits(patch, part, may_intersect)) continue;
    if (may_intersect && !options_.allow_self_intersections) return true;
    ++(may_intersect                      ? result_.crossed
       : patch.kind == PatchKind::faired  ? result_.faired
       : patch.kind == PatchKind::refined ? result_.refined
                                          : result_.plain);
    add(patch, part, loop);
    return true;
  }
  return false;
}

FillResult Filler::finish() {
  const std::size_t old_vertices = mesh_.positions.size() - result_.new_vertices;
  const std::vector<RowBlend> rows(blends_.begin() + static_cast<std::ptrdiff_t>(old_vertices),
                                   blends_.end());
  for (const RowBlend& row : rows) mesh_.vertex_columns.append(row);
  mesh_.face_columns.concatenate(Columns(), mesh_.faces.size() - result_.new_faces,
                                 result_.new_faces);
  if (result_.new_faces > 0) result_.dropped_source_points = drop_source_points(mesh_);
  return std::move(result_);
}

}  // namespace

FillResult fill_holes(Mesh& mesh, const FillOptions& options, const Progress& progress) {
  const ManifoldReport found = check_manifold(mesh);
  check(mesh, found, options);
  if (found.is_closed()) return {};
  std::vector<Face> before = mesh.faces;
  std::vector<HoleLoop> loops = join_touching_holes(mesh, found.border_halfedges);
  const auto may_fill = [&](const HoleLoop& loop) { return !is_too_large(mesh, loop, options); };
  const std::size_t cut_edges = cut_contact_edges(mesh, before, loops, may_fill);
  const std::size_t loop_count = loops.size();
  const std::vector<std::vector<HoleLoop>> holes = group_openings(mesh, std::move(loops));
  if (holes.size() < loop_count) join_touching_loops(mesh, holes);
  const bool any_touch = mesh.faces != before || !found.nonmanifold_vertices.empty();
  Filler filler(mesh, options);
  for (const std::vector<HoleLoop>& hole : holes) {
    progress("filling holes");
    filler.fill(hole);
  }
  FillResult result = filler.finish();
  result.cut_edges = cut_edges;
  if (any_touch) separate_open_holes(mesh, before);
  for (std::vector<OpenHole>* holes : {&result.too_large, &result.crossing, &result.flat})
    for (OpenHole& hole : *holes) hole.vertex = halfedge_source(mesh, hole.vertex);
  return result;
}

}  // namespace transformesh
