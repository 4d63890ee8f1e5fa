#include "io/polygons/planar_outline.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace transformesh {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct VertexInfo {
  std::uint32_t corner = 0;  ///< one of the corners at this point
  std::uint32_t visits = 0;  ///< number of outline corners at this point
};

/// Data of a face of the triangulation. Arrays are indexed like the neighbors and vertices of the
/// face.
struct FaceInfo {
  int winding = 0;
  bool is_reached = false;
  /// Number of outline edges with the face on their left, minus those with the face on their right.
  std::array<int, 3> turns{};
  CornerTriangle corners{};
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Vertex = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;

constexpr int ccw(int i) { return (i + 1) % 3; }
constexpr int cw(int i) { return (i + 2) % 3; }

/// A triangulation edge that is part of an outline edge.
struct Part {
  Vertex from, to;
  FaceHandle left, right;
};

class OutlineTriangulation {
 public:
  /// `next[i]` is the index in `outline` of the corner that follows `outline[i]`.
  OutlineTriangulation(std::span<const Eigen::Vector2d> points,
                       std::span<const std::uint32_t> outline, std::span<const std::size_t> next)
      : points_(points), outline_(outline), next_(next) {}

  PlanarTriangles run() {
    if (!insert_points() || !insert_edges()) return std::move(result_);
    count_turns();
    find_winding_numbers();
    name_corners();
    collect();
    return std::move(result_);
  }

 private:
  /// Returns true if the points span the plane. Inserts three points that span it first, because
  /// CGAL searches collinear points linearly.
  bool insert_points() {
    std::vector<Kernel::Point_2> points;
    points.reserve(outline_.size());
    for (const std::uint32_t corner : outline_)
      points.emplace_back(points_[corner][0], points_[corner][1]);
    vertices_.resize(points.size());
    const std::array<std::size_t, 2> spanning = spanning_points(points);
    if (spanning[1] == points.size()) return false;
    insert(points, 0);
    for (const std::size_t place : spanning) insert(points, place);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto map = CGAL::make_property_map(points);
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(map)>(map));
    for (const std::size_t place : order)
      if (vertices_[place] == Vertex()) insert(points, place);
    return true;
  }

  /// Returns two indices: of a point that differs from the first point, and of a point that is not
  /// collinear with these two. If there is no such point, the index is the number of points.
  static std::array<std::size_t, 2> spanning_points(const std::vector<Kernel::Point_2>& points) {
    std::array<std::size_t, 2> found{1, 1};
    while (found[0] < points.size() && points[found[0]] == points[0]) ++found[0];
    found[1] = std::min(found[0] + 1, points.size());
    while (found[1] < points.size() &&
           CGAL::collinear(points[0], points[found[0]], points[found[1]]))
      ++found[1];
    return found;
  }

  void insert(const std::vector<Kernel::Point_2>& points, std::size_t place) {
    // The point is located first: CGAL's insertion at an existing vertex would circulate around it,
    // which is slow at high valence.
    Triangulation::Locate_type type{};
    int i = 0;
    const FaceHandle face = triangulation_.locate(points[place], type, i, near_);
    const Vertex vertex = type == Triangulation::VERTEX
                              ? face->vertex(i)
                              : triangulation_.insert(points[place], type, face, i);
    near_ = vertex->face();
    vertices_[place] = vertex;
    VertexInfo& info = vertex->info();
    if (info.visits++ == 0 || outline_[place] < info.corner) info.corner = outline_[place];
  }

  /// Returns the triangulation edges that form the outline edge from `vertices_[place]`. The search
  /// circulates around one end of the outline edge. It starts at the end with fewer visits.
  std::vector<Part> parts_of(std::size_t place) const {
    Vertex from = vertices_[place];
    Vertex to = vertices_[next_[place]];
    const bool is_reversed = from->info().visits > to->info().visits;
    if (is_reversed) std::swap(from, to);
    std::vector<Part> parts;
    while (from != to) {
      Vertex end;
      FaceHandle face;
      int i = 0;
      triangulation_.includes_edge(from, to, end, face, i);
      FaceHandle other = face->neighbor(i);
      if (face->vertex(ccw(i)) != from) std::swap(face, other);
      parts.push_back(is_reversed ? Part{end, from, other, face} : Part{from, end, face, other});
      from = end;
    }
    if (is_reversed) std::reverse(parts.begin(), parts.end());
    return parts;
  }

  /// Inserts the outline edges as constraints. Returns false if two edges intersect, or if edges
  /// pass through other corners more often than the outline has corners.
  bool insert_edges() {
    std::size_t touches = 0;
    for (std::size_t place = 0; place < outline_.size(); ++place) {
      Vertex from = vertices_[place];
      Vertex to = vertices_[next_[place]];
      if (from == to) {
        // An outline of a single corner is a point. Otherwise the edge has length 0.
        if (next_[place] != place) result_.crossing.push_back(outline_[place]);
        continue;
      }
      if (from->info().visits > to->info().visits) std::swap(from, to);
      try {
        triangulation_.insert_constraint(from, to);
      } catch (const Triangulation::Intersection_of_constraints_exception&) {
        result_.crossing.push_back(outline_[place]);
        continue;
      }
      touches += parts_of(place).size() - 1;
      if (touches > outline_.size()) return false;
    }
    return result_.crossing.empty();
  }

  void count_turns() {
    for (std::size_t place = 0; place < outline_.size(); ++place) {
      const std::vector<Part> parts = parts_of(place);
      const std::uint32_t first = outline_[place];
      std::uint32_t last = outline_[next_[place]];
      for (std::size_t i = parts.size(); i-- > 0;) {
        const Part& part = parts[i];
        ++part.left->info().turns[opposite(part.left, part)];
        --part.right->info().turns[opposite(part.right, part)];
        if (i == 0) break;
        const std::uint32_t between = part.from->info().corner;
        result_.flat.push_back({first, last, between});
        last = between;
      }
    }
  }

  static std::size_t opposite(FaceHandle face, const Part& part) {
    return static_cast<std::size_t>(3 - face->index(part.from) - face->index(part.to));
  }

  void find_winding_numbers() {
    std::vector<FaceHandle> reached{triangulation_.infinite_face()};
    reached.back()->info().is_reached = true;
    while (!reached.empty()) {
      const FaceHandle face = reached.back();
      reached.pop_back();
      for (int i = 0; i < 3; ++i) {
        FaceInfo& other = face->neighbor(i)->info();
        if (other.is_reached) continue;
        other.is_reached = true;
        other.winding = face->info().winding - face->info().turns[static_cast<std::size_t>(i)];
        reached.push_back(face->neighbor(i));
      }
    }
  }

  /// Assigns corners to each triangle. If several corners coincide, each corner gets the triangles
  /// between its two edges.
  void name_corners() {
    for (const FaceHandle face : triangulation_.finite_face_handles())
      for (int i = 0; i < 3; ++i)
        face->info().corners[static_cast<std::size_t>(i)] = face->vertex(i)->info().corner;
    for (std::size_t place = 0; place < outline_.size(); ++place) {
      if (vertices_[place]->info().visits == 1 || next_[place] == place) continue;
      const Part part = parts_of(place).front();
      if (part.left->info().winding > 0) sweep(part.from, part.left, ccw, outline_[place]);
      if (part.right->info().winding < 0) sweep(part.from, part.right, cw, outline_[place]);
    }
  }

  static void sweep(Vertex around, FaceHandle face, int (*turn)(int), std::uint32_t corner) {
    for (;;) {
      const int i = face->index(around);
      face->info().corners[static_cast<std::size_t>(i)] = corner;
      if (face->is_constrained(turn(i))) return;
      face = face->neighbor(turn(i));
    }
  }

  void collect() {
    std::size_t count = 0, reversed = 0, copies = 0;
    for (const FaceHandle face : triangulation_.finite_face_handles()) {
      const int winding = face->info().winding;
      const auto size = static_cast<std::size_t>(std::abs(winding));
      count += size;
      if (winding < 0) reversed += size;
      if (size > 1) copies += size - 1;
    }
    if (count > 2 * outline_.size()) return;
    result_.folds = std::min(reversed, count - reversed) + copies;
    result_.is_complete = true;
    for (const FaceHandle face : triangulation_.finite_face_handles()) {
      CornerTriangle triangle = face->info().corners;
      if (face->info().winding < 0) std::swap(triangle[1], triangle[2]);
      for (int i = std::abs(face->info().winding); i > 0; --i)
        result_.triangles.push_back(triangle);
    }
  }

  std::span<const Eigen::Vector2d> points_;
  std::span<const std::uint32_t> outline_;
  std::span<const std::size_t> next_;
  Triangulation triangulation_;
  FaceHandle near_;               ///< a face at the last point, as a hint for the next search
  std::vector<Vertex> vertices_;  ///< vertices of the outline
  PlanarTriangles result_;
};

}  // namespace

PlanarTriangles triangulate_outline(std::span<const Eigen::Vector2d> points,
                                    std::span<const std::uint32_t> outline) {
  std::vector<std::size_t> next(outline.size());
  for (std::size_t i = 0; i < next.size(); ++i) next[i] = i + 1 < next.size() ? i + 1 : 0;
  return OutlineTriangulation(points, outline, next).run();
}

PlanarTriangles triangulate_outlines(std::span<const Eigen::Vector2d> points,
                                     const std::vector<std::vector<std::uint32_t>>& outlines) {
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> next;
  for (const std::vector<std::uint32_t>& outline : outlines) {
    const std::size_t first = corners.size();
    corners.insert(corners.end(), outline.begin(), outline.end());
    for (std::size_t i = first; i < corners.size(); ++i)
      next.push_back(i + 1 < corners.size() ? i + 1 : first);
  }
  return OutlineTriangulation(points, corners, next).run();
}

}  // namespace transformesh
