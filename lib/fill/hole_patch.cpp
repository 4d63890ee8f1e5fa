#include "fill/hole_patch.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <optional>

#include "fill/hole_triangulation.h"
#include "geometry/numbers/predicates.h"

namespace transformesh {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;
using FaceNumber = Surface::Face_index;

/// For borders of at most this number of edges, Search::all is used instead of Search::delaunay. It
/// takes about 1 ms.
constexpr std::size_t few_edges = 64;
/// For borders of more edges than this, a search among all triangles is slow, and only edges
/// between near points are used. Planar borders have a lower limit: all their triangulations are
/// equally good up to rounding, so that no candidate can be skipped.
constexpr std::size_t many_edges = 512, many_flat_edges = 256;

Surface surface_of(const Mesh& mesh) {
  Surface surface;
  for (const Vec3& p : mesh.positions) surface.add_vertex(Point(p.x(), p.y(), p.z()));
  for (const Face& f : mesh.faces) surface.add_face(Vertex(f[0]), Vertex(f[1]), Vertex(f[2]));
  return surface;
}

/// Returns the border halfedges of the hole, in order. Halfedge i ends at point i of the
/// HoleBorder.
std::vector<Halfedge> border_of(const Surface& surface, Halfedge first) {
  std::vector<Halfedge> border;
  for (const Halfedge h : surface.halfedges_around_face(first)) border.push_back(h);
  return border;
}

/// Returns the points of the border of a hole and the surrounding geometry. Returns nothing if the
/// border passes through a vertex twice.
std::optional<HoleBorder> describe(const Surface& surface, const std::vector<Halfedge>& border) {
  const auto position = [&](Vertex v) -> Vec3 {
    const Point& p = surface.point(v);
    return {p.x(), p.y(), p.z()};
  };
  const auto size = static_cast<Index>(border.size());
  std::vector<Index> number(surface.number_of_vertices(), no_index);
  HoleBorder result;
  for (Index i = 0; i < size; ++i) {
    const Vertex v = surface.target(border[i]);
    if (number[v] != no_index) return std::nullopt;
    number[v] = i;
    result.points.push_back(position(v));
    const Halfedge inner = surface.opposite(border[(i + 1) % size]);
    result.across.push_back(position(surface.target(surface.next(inner))));
  }
  for (Index i = 0; i < size; ++i)
    for (const Halfedge h : surface.halfedges_around_target(border[i])) {
      const Index k = number[surface.source(h)];
      if (k == no_index || k <= i + 1 || (i == 0 && k == size - 1)) continue;
      result.chords.emplace_back(i, k);
    }
  std::sort(result.chords.begin(), result.chords.end());
  return result;
}

std::vector<FaceNumber> add_triangles(Surface& surface, const std::vector<Halfedge>& border,
                                      const std::vector<HoleTriangle>& triangles) {
  std::vector<FaceNumber> faces;
  std::vector<Halfedge> open;  // border halfedges at triangles that were already added
  const auto side = [&](Index from, Index to) {
    if (from + 1 == to) return border[to];
    const Halfedge h = open.back();
    open.pop_back();
    return h;
  };
  for (const auto& [i, m, k] : triangles) {
    const Halfedge second = side(m, k), first = side(i, m);
    Halfedge made = border.size() == 3 ? first : second;
    if (i == 0 && k + 1 == border.size())
      CGAL::Euler::fill_hole(made, surface);
    else
      made = CGAL::Euler::add_face_to_border(surface.prev(first), second, surface);
    faces.push_back(surface.face(made));
    open.push_back(surface.opposite(made));
  }
  return faces;
}

/// Returns the edges of the Delaunay tetrahedralization of the points. The result does not depend
/// on memory addresses.
std::vector<std::pair<Index, Index>> delaunay_edges(const std::vector<Vec3>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Base = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
  using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
  using Tetrahedra =
      CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Base, Cell>>;
  std::vector<std::pair<Point, Index>> numbered;
  for (const Vec3& p : points)
    numbered.emplace_back(Point(p.x(), p.y(), p.z()), static_cast<Index>(numbered.size()));
  const Tetrahedra tetrahedra(numbered.begin(), numbered.end());
  std::vector<std::pair<Index, Index>> edges;
  for (const auto& [cell, i, k] : tetrahedra.finite_edges())
    edges.emplace_back(cell->vertex(i)->info(), cell->vertex(k)->info());
  return edges;
}

/// True if all points are coplanar.
bool is_flat(const std::vector<Vec3>& points) {
  std::size_t i = 2;
  while (i < points.size() && collinear(points[0], points[1], points[i])) ++i;
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return i == points.size() || orient3d(points[0], points[1], points[i], p) == 0;
  });
}

/// Adds a plain patch of the hole to the surface, and returns its faces. Sets `is_of_all` if
/// Search::all would give the same triangulation.
std::vector<FaceNumber> triangulate(Surface& surface, Halfedge first, Search search,
                                    bool& is_of_all) {
  std::vector<FaceNumber> faces;
  const std::vector<Halfedge> border = border_of(surface, first);
  const std::optional<HoleBorder> hole = describe(surface, border);
  if (!hole) return faces;
  if (search == Search::delaunay && border.size() > few_edges) {
    faces =
        add_triangles(surface, border, triangulation_among(*hole, delaunay_edges(hole->points)));
    if (!faces.empty()) return faces;
  }
  is_of_all = border.size() <= (is_flat(hole->points) ? many_flat_edges : many_edges);
  const std::vector<HoleTriangle> triangles =
      is_of_all ? least_triangulation(*hole) : sparse_triangulation(*hole);
  return add_triangles(surface, border, triangles);
}

/// Inserts a patch at the beginning of `patches`. It consists of the vertices and faces of
/// `surface` that are not in `mesh`. Does nothing if a point of the patch is not finite.
void add_patch(const Surface& surface, const Mesh& mesh, PatchKind kind,
               std::vector<HolePatch>& patches) {
  HolePatch patch{kind, {}, {}};
  for (std::size_t v = mesh.positions.size(); v < surface.number_of_vertices(); ++v) {
    const Point& p = surface.point(Vertex(static_cast<Index>(v)));
    patch.points.emplace_back(p.x(), p.y(), p.z());
    if (!patch.points.back().allFinite()) return;
  }
  for (std::size_t f = mesh.faces.size(); f < surface.number_of_faces(); ++f) {
    Face face{};
    int corner = 0;
    const auto start = surface.halfedge(FaceNumber(static_cast<Index>(f)));
    for (const Vertex v : surface.vertices_around_face(start)) face.at(corner++) = v;
    patch.faces.push_back(face);
  }
  patches.insert(patches.begin(), std::move(patch));
}

void add_finer_patches(Surface& surface, const Mesh& mesh, const std::vector<FaceNumber>& faces,
                       PatchKind finest, std::vector<HolePatch>& patches) {
  std::vector<Vertex> vertices;
  std::vector<FaceNumber> new_faces;
  processing::refine(surface, faces, std::back_inserter(new_faces), std::back_inserter(vertices));
  if (vertices.empty()) return;
  add_patch(surface, mesh, PatchKind::refined, patches);
  if (finest == PatchKind::faired && processing::fair(surface, vertices))
    add_patch(surface, mesh, PatchKind::faired, patches);
}

}  // namespace

HolePatches patch_hole(const Mesh& around, Index border_halfedge, PatchKind finest, Search search) {
  HolePatches result;
  try {
    Surface surface = surface_of(around);
    if (surface.number_of_faces() != around.faces.size()) return result;
    const auto inner = surface.halfedge(Vertex(halfedge_source(around, border_halfedge)),
                                        Vertex(halfedge_target(around, border_halfedge)));
    const std::vector<FaceNumber> faces =
        triangulate(surface, surface.opposite(inner), search, result.are_of_all);
    if (faces.empty()) return result;
    add_patch(surface, around, PatchKind::plain, result.patches);
    if (finest != PatchKind::plain)
      add_finer_patches(surface, around, faces, finest, result.patches);
  } catch (const CGAL::Failure_exception&) {  // rounding violated a precondition of CGAL
  }
  return result;
}

HolePatches finer_patches(const Mesh& around, const std::vector<Face>& plain, PatchKind finest) {
  HolePatches result;
  if (plain.empty()) return result;
  result.patches.push_back({PatchKind::plain, {}, plain});
  if (finest == PatchKind::plain) return result;
  try {
    Surface surface = surface_of(around);
    std::vector<FaceNumber> faces;
    for (const auto& [a, b, c] : plain)
      faces.push_back(surface.add_face(Vertex(a), Vertex(b), Vertex(c)));
    if (surface.number_of_faces() == around.faces.size() + plain.size())
      add_finer_patches(surface, around, faces, finest, result.patches);
  } catch (const CGAL::Failure_exception&) {  // rounding violated a precondition of CGAL
  }
  return result;
}

}  // namespace transformesh
