#include "geometry/source_points.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/common_extent.h"
#include "geometry/search/closest_point.h"
#include "mesh/adjacency.h"
#include "mesh/local_measures.h"
#include "mesh/surface_columns.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::size_t located_per_task = 1024;  ///< affects time only
constexpr const char* face_name = source_point_names[0];
constexpr const char* u_name = source_point_names[1];
constexpr const char* v_name = source_point_names[2];

double share(double part, double whole) {
  return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0;
}

// Returns the source point on the edge from corner `edge` to the next corner of the face. Exact if
// the point is a corner.
SourcePoint on_edge(Index face, int edge, double along) {
  std::array<double, 3> weights{};
  weights[static_cast<std::size_t>(edge)] = 1 - along;
  weights[static_cast<std::size_t>((edge + 1) % 3)] = along;
  return {face, weights[1], weights[2]};
}

SourcePoint inside(Index face, const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  const double u = share(normal.dot((point - a).cross(c - a)), squared);
  const double v = share(normal.dot((b - a).cross(point - a)), squared);
  return {face, u, std::min(v, 1 - u)};
}

SourcePoint nearest_on_edge(Index face, const std::array<Vec3, 3>& corners, int edge,
                            const Vec3& point) {
  const Vec3& from = corners[static_cast<std::size_t>(edge)];
  const Vec3 direction = corners[static_cast<std::size_t>((edge + 1) % 3)] - from;
  return on_edge(face, edge, share(direction.dot(point - from), direction.squaredNorm()));
}

// Returns the place nearest to the point on the source faces of the faces at a vertex. Ties are
// broken by the lowest face index.
SourcePoint nearest_of(const Mesh& source, const Vec3& point, std::span<const Index> faces,
                       std::span<const double> face_sources) {
  double least = HUGE_VAL;
  SourcePoint nearest{no_index, 0, 0};
  for (const Index face : faces) {
    const auto from = static_cast<Index>(face_sources[face]);
    const SourcePoint place = source_point_on(source, from, point);
    const double squared = (position_of(source, place) - point).squaredNorm();
    if (squared > least || (squared == least && from >= nearest.face)) continue;
    least = squared;
    nearest = place;
  }
  return nearest;
}

// Returns the area-weighted normal of each vertex, not normalized. Slivers, whose normals are
// unreliable, have hardly any weight.
std::vector<Vec3> sums_of_normals(const Mesh& mesh) {
  std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (const Index v : mesh.faces[f]) sums[v] += face_normal(mesh, f);
  return sums;
}

// True if the value is a valid face index; false for fractions and NaN.
bool is_face_number(double value, std::size_t faces) {
  return value >= 0 && value < static_cast<double>(faces) && value == std::floor(value);
}

bool is_share(double value) { return value >= 0 && value <= 1; }

std::vector<SourcePoint> read(const Columns& columns, std::size_t source_faces, const char* element,
                              const std::string& source_name) {
  const std::vector<double>& faces = columns.find(face_name)->values;
  const std::vector<double>& u = columns.find(u_name)->values;
  const std::vector<double>& v = columns.find(v_name)->values;
  std::vector<SourcePoint> places(faces.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!is_face_number(faces[i], source_faces) || !is_share(u[i]) || !is_share(v[i]))
      throw InputError(element + (" " + std::to_string(i)) + " cannot lie on " + source_name +
                       ", which has " + std::to_string(source_faces) +
                       " faces, at its source_face, source_u and source_v: name the mesh that was "
                       "the input when these were written");
    places[i] = {static_cast<Index>(faces[i]), u[i], v[i]};
  }
  return places;
}

void write(Columns& columns, std::span<const SourcePoint> places) {
  const auto put = [&](const char* name, Scalar type, const auto& value) {
    Column& column = columns.get(name, type, places.size());
    for (std::size_t i = 0; i < places.size(); ++i) column.values[i] = value(places[i]);
  };
  put(face_name, Scalar::int32, [](const SourcePoint& place) { return 1.0 * place.face; });
  put(u_name, Scalar::float64, [](const SourcePoint& place) { return place.u; });
  put(v_name, Scalar::float64, [](const SourcePoint& place) { return place.v; });
}

/// Returns place_of(i) for all indices i below `count`. Uses all allowed threads.
template <typename PlaceOf>
std::vector<SourcePoint> places_of_all(std::size_t count, const PlaceOf& place_of) {
  std::vector<SourcePoint> places(count);
  parallel_for(count, located_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) places[i] = place_of(static_cast<Index>(i));
  });
  return places;
}

}  // namespace

SourcePoint source_point_on(const Mesh& source, Index face, const Vec3& point) {
  const auto& [first, second, third] = source.faces[face];
  const std::array<Vec3, 3> corners{source.positions[first], source.positions[second],
                                    source.positions[third]};
  const TrianglePoint nearest =
      closest_point_of_triangle(point, corners[0], corners[1], corners[2]);
  if (nearest.part == TriangleSimplex::inside) {
    // For a sliver, barycentric coordinates of a point inside suffer from rounding. A point on an
    // edge may be nearer.
    SourcePoint place = inside(face, nearest.point, corners[0], corners[1], corners[2]);
    const auto distance_of = [&](const SourcePoint& of) {
      return (position_of(source, of) - point).squaredNorm();
    };
    for (int edge = 0; edge < 3; ++edge) {
      const SourcePoint other = nearest_on_edge(face, corners, edge, point);
      if (distance_of(other) < distance_of(place)) place = other;
    }
    return place;
  }
  const auto part = static_cast<int>(nearest.part);
  if (part < 3) return on_edge(face, part, 0);
  const Vec3& from = corners[static_cast<std::size_t>(part - 3)];
  const Vec3& to = corners[static_cast<std::size_t>((part - 2) % 3)];
  return on_edge(face, part - 3, share((nearest.point - from).norm(), (to - from).norm()));
}

Vec3 position_of(const Mesh& source, const SourcePoint& place) {
  const auto& [a, b, c] = source.faces[place.face];
  const auto [of_a, of_b, of_c] = place.weights();
  return of_a * source.positions[a] + of_b * source.positions[b] + of_c * source.positions[c];
}

SourcePoints source_points_of_pieces(const Mesh& source, const Mesh& mesh,
                                     std::span<const double> face_sources) {
  const VertexFaces faces_at(mesh);
  SourcePoints places;
  places.of_vertices.resize(mesh.positions.size());
  std::optional<ClosestPointQuery> closest;  // search for vertices that no face uses
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& point = mesh.positions[v];
    if (!faces_at[v].empty()) {
      places.of_vertices[v] = nearest_of(source, point, faces_at[v], face_sources);
      continue;
    }
    if (!closest) closest.emplace(source);
    places.of_vertices[v] = source_point_on(source, (*closest)(point).face, point);
  }
  places.of_faces = places_of_all(mesh.faces.size(), [&](Index f) {
    return source_point_on(source, static_cast<Index>(face_sources[f]), face_middle(mesh, f));
  });
  return places;
}

SourcePoints closest_source_points(const Mesh& source, const Mesh& mesh) {
  check_common_extent(mesh, source, "to find closest points");
  const ClosestPointQuery closest(source);
  const std::vector<Vec3> normals = sums_of_normals(mesh);
  const auto place = [&](const Vec3& point, const Vec3& normal) {
    return source_point_on(source, closest.facing(point, normal).face, point);
  };
  return {places_of_all(mesh.positions.size(),
                        [&](Index v) { return place(mesh.positions[v], normals[v]); }),
          places_of_all(mesh.faces.size(), [&](Index f) {
            return place(face_middle(mesh, f), face_normal(mesh, f));
          })};
}

bool has_source_points(const Mesh& mesh) {
  return has_source_columns(mesh.vertex_columns) && has_source_columns(mesh.face_columns);
}

SourcePoints read_source_points(const Mesh& mesh, std::size_t source_faces,
                                const std::string& source_name) {
  if (!has_source_points(mesh))
    throw InputError(
        "the mesh lacks the vertex and face properties source_face, source_u and source_v");
  return {read(mesh.vertex_columns, source_faces, "vertex", source_name),
          read(mesh.face_columns, source_faces, "face", source_name)};
}

void write_source_points(Mesh& mesh, const SourcePoints& places) {
  write(mesh.vertex_columns, places.of_vertices);
  write(mesh.face_columns, places.of_faces);
}

}  // namespace transformesh
