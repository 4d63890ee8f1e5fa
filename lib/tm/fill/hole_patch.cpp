#include "tm/fill/hole_patch.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

namespace transformesh {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Vertex = Surface::Vertex_index;

Surface surface_of(const Mesh& mesh) {
  Surface surface;
  for (const Vec3& p : mesh.positions) surface.add_vertex(Point(p.x(), p.y(), p.z()));
  for (const Face& f : mesh.faces) surface.add_face(Vertex(f[0]), Vertex(f[1]), Vertex(f[2]));
  return surface;
}

/// So few that a search among all triangles takes a hundredth of a second.
constexpr std::size_t few_edges = 64;

bool has_few_edges(const Surface& surface, Surface::Halfedge_index border) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto h : surface.halfedges_around_face(border))
    if (++count > few_edges) return false;
  return true;
}

/// Whether the surface has a patch of that kind now.
bool fill_hole(Surface& surface, Surface::Halfedge_index border, PatchKind kind, Search search) {
  std::vector<Surface::Face_index> faces;
  const bool is_quick = search == Search::delaunay && !has_few_edges(surface, border);
  processing::triangulate_hole(surface, border, std::back_inserter(faces),
                               CGAL::parameters::use_delaunay_triangulation(is_quick));
  if (faces.empty() || kind == PatchKind::plain) return !faces.empty();

  std::vector<Vertex> vertices;
  std::vector<Surface::Face_index> new_faces;
  processing::refine(surface, faces, std::back_inserter(new_faces), std::back_inserter(vertices));
  return kind == PatchKind::refined || vertices.empty() || processing::fair(surface, vertices);
}

/// What follows the vertices and faces of the mesh. Nothing where a point is not finite.
std::optional<HolePatch> new_part(const Surface& surface, const Mesh& mesh) {
  HolePatch patch;
  for (std::size_t v = mesh.positions.size(); v < surface.number_of_vertices(); ++v) {
    const Point& p = surface.point(Vertex(static_cast<Index>(v)));
    patch.points.emplace_back(p.x(), p.y(), p.z());
    if (!patch.points.back().allFinite()) return std::nullopt;
  }
  for (std::size_t f = mesh.faces.size(); f < surface.number_of_faces(); ++f) {
    Face face{};
    int corner = 0;
    const auto start = surface.halfedge(Surface::Face_index(static_cast<Index>(f)));
    for (const Vertex v : surface.vertices_around_face(start)) face.at(corner++) = v;
    patch.faces.push_back(face);
  }
  return patch;
}

}  // namespace

std::optional<HolePatch> patch_hole(const Mesh& around, Index border_halfedge, PatchKind kind,
                                    Search search) {
  try {
    Surface surface = surface_of(around);
    if (surface.number_of_faces() != around.faces.size()) return std::nullopt;
    const auto inner = surface.halfedge(Vertex(halfedge_source(around, border_halfedge)),
                                        Vertex(halfedge_target(around, border_halfedge)));
    if (!fill_hole(surface, surface.opposite(inner), kind, search)) return std::nullopt;
    return new_part(surface, around);
  } catch (const CGAL::Failure_exception&) {
    return std::nullopt;  // a precondition that rounding broke
  }
}

}  // namespace transformesh
