// Composes source points (faces with barycentric coordinates) along a chain of meshes, and carries
// columns to them; corner lists, such as texture coordinates, without crossing seams. Deterministic
// floating point. Cost: O(n log n) for closest points, and O(1) per source point otherwise.
#include "transformesh/carry.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/search/closest_point.h"
#include "geometry/source_points.h"
#include "mesh/edges.h"
#include "mesh/surface_columns.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::size_t places_per_task = 1024;  ///< affects time only

/// Maps points of an intermediate mesh (face, barycentric coordinates) to points of the first mesh.
class Composition {
 public:
  Composition(const Mesh& first, const SourcePoints& middle_on_first, const Mesh& middle)
      : first_(first), on_first_(middle_on_first), middle_(middle), closest_(first) {}

  /// Returns the source point on the first mesh of a vertex that is at `place` on the intermediate
  /// mesh. Exact if `place` is a corner, or if all corners with nonzero weight come from one face.
  SourcePoint of_vertex(const SourcePoint& place) const {
    const std::array<SourcePoint, 3> corners = corners_of(place.face);
    const auto weights = place.weights();
    const auto heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
    const SourcePoint& main = corners[static_cast<std::size_t>(heaviest)];
    if (weights[static_cast<std::size_t>(heaviest)] == 1) return main;
    // If the corners come from faces that meet at an angle, use the weighted mean of their normals.
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      normal += weights[i] * face_normal(first_, corners[i].face).stableNormalized();
    return are_on(main.face, corners, weights) ? mean_on_face(main.face, corners, weights)
                                               : mean_on_surface(place, corners, normal);
  }

  /// Returns the source point on the first mesh of a face whose centroid is at `place` on the
  /// intermediate mesh. Exact if the face at `place` and its corners come from one face.
  SourcePoint of_face(const SourcePoint& place) const {
    const std::array<SourcePoint, 3> corners = corners_of(place.face);
    const Index own = on_first_.of_faces[place.face].face;
    return are_on(own, corners, {1, 1, 1})
               ? mean_on_face(own, corners, place.weights())
               : mean_on_surface(place, corners, face_normal(first_, own));
  }

 private:
  /// A point counts as on a face if its distance is at most this fraction of the size of the
  /// intermediate face. The value exceeds the rounding errors of floats, by which pieces of a face
  /// deviate from the face. At half and twice the value, source points change by no more than this
  /// distance.
  static constexpr double same_distance = 1e-4;

  /// Returns the mean position of the corners' source points, projected onto a face of the first
  /// mesh. This is the face from which the intermediate face comes, if the mean is on that face.
  /// Otherwise it is the nearest face with a similar normal.
  SourcePoint mean_on_surface(const SourcePoint& place, const std::array<SourcePoint, 3>& corners,
                              const Vec3& normal) const {
    const Index own = on_first_.of_faces[place.face].face;
    const Vec3 point = mean_position(corners, place.weights());
    const SourcePoint on_own = source_point_on(first_, own, point);
    const double from_own = (position_of(first_, on_own) - point).norm();
    if (from_own <= same_distance * reach(corners, point)) return on_own;
    return source_point_on(first_, closest_.facing(point, normal).face, point);
  }

  std::array<SourcePoint, 3> corners_of(Index face) const {
    const auto& [a, b, c] = middle_.faces[face];
    return {on_first_.of_vertices[a], on_first_.of_vertices[b], on_first_.of_vertices[c]};
  }

  Vec3 mean_position(const std::array<SourcePoint, 3>& places,
                     const std::array<double, 3>& weights) const {
    Vec3 point = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) point += weights[i] * position_of(first_, places[i]);
    return point;
  }

  double reach(const std::array<SourcePoint, 3>& places, const Vec3& center) const {
    double most = 0;
    for (const SourcePoint& place : places)
      most = std::max(most, (position_of(first_, place) - center).norm());
    return most;
  }

  /// True if all source points in `places` with nonzero weight are on the face.
  static bool are_on(Index face, const std::array<SourcePoint, 3>& places,
                     const std::array<double, 3>& weights) {
    for (std::size_t i = 0; i < 3; ++i)
      if (weights[i] != 0 && places[i].face != face) return false;
    return true;
  }

  static SourcePoint mean_on_face(Index face, const std::array<SourcePoint, 3>& places,
                                  const std::array<double, 3>& weights) {
    SourcePoint mean{face, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      if (weights[i] == 0) continue;
      mean.u += weights[i] * places[i].u;
      mean.v += weights[i] * places[i].v;
    }
    mean.u = std::clamp(mean.u, 0.0, 1.0);
    mean.v = std::clamp(mean.v, 0.0, 1 - mean.u);
    return mean;
  }

  const Mesh& first_;
  const SourcePoints& on_first_;
  const Mesh& middle_;
  ClosestPointQuery closest_;
};

/// Texture coordinates of the first mesh. If two neighboring faces have different values at their
/// common edge, the edge is a seam.
class Texture {
 public:
  Texture(const Mesh& mesh, const Column& column)
      : mesh_(mesh),
        column_(column),
        across_(neighbors_across(Edges(mesh), mesh.faces.size())),
        is_reached_(mesh.faces.size(), 0) {}

  /// Appends the texture coordinates of a face, given the source points of corners and centroid.
  void append_face(const std::array<SourcePoint, 3>& corners, const SourcePoint& middle,
                   Column& to) {
    gather_around(middle, corners);
    for (const SourcePoint& corner : corners) append(nearest_gathered(corner), to);
    to.list_offsets.push_back(to.values.size());
    for (const Index face : gathered_) is_reached_[face] = 0;
  }

 private:
  void append(const SourcePoint& place, Column& to) const {
    const auto values = values_of(place.face);
    const std::size_t width = values.size() / 3;
    const auto weights = place.weights();
    for (std::size_t i = 0; i < width; ++i)
      to.values.push_back(weights[0] * values[i] + weights[1] * values[width + i] +
                          weights[2] * values[2 * width + i]);
  }

  /// Collects in `gathered_` the faces within the corners' distance from the centroid, to which a
  /// breadth-first search leads without crossing a seam.
  void gather_around(const SourcePoint& middle, const std::array<SourcePoint, 3>& corners) {
    const Vec3 center = position_of(mesh_, middle);
    reach_ = 0;
    for (const SourcePoint& corner : corners)
      reach_ = std::max(reach_, (position_of(mesh_, corner) - center).norm());
    gathered_ = {middle.face};
    is_reached_[middle.face] = 1;
    for (std::size_t i = 0; i < gathered_.size(); ++i)
      for (Index side = 0; side < 3; ++side) {
        const Index halfedge = 3 * gathered_[i] + side;
        const Index other = across_[halfedge];
        if (other == no_index || is_reached_[other / 3] || is_seam(halfedge, other)) continue;
        if (distance(other / 3, center) > (1 + slack) * reach_) continue;
        is_reached_[other / 3] = 1;
        gathered_.push_back(other / 3);
      }
  }

  /// Returns the point on faces in `gathered_` nearest to `place`; of equals, on the first face.
  SourcePoint nearest_gathered(const SourcePoint& place) const {
    const Vec3 point = position_of(mesh_, place);
    Index nearest = gathered_[0];
    double least = distance(nearest, point);
    for (const Index face : gathered_) {
      const double from_face = distance(face, point);
      if (!(from_face < least - slack * reach_)) continue;
      nearest = face;
      least = from_face;
    }
    return source_point_on(mesh_, nearest, point);
  }

  double distance(Index face, const Vec3& point) const {
    const auto& [a, b, c] = mesh_.faces[face];
    return (closest_point_of_triangle(point, mesh_.positions[a], mesh_.positions[b],
                                      mesh_.positions[c])
                .point -
            point)
        .norm();
  }

  bool is_seam(Index halfedge, Index other) const {
    const auto agrees_at = [&](Index vertex) {
      return std::ranges::equal(values_at(halfedge / 3, vertex), values_at(other / 3, vertex));
    };
    return !agrees_at(halfedge_source(mesh_, halfedge)) ||
           !agrees_at(halfedge_target(mesh_, halfedge));
  }

  std::span<const double> values_of(Index face) const {
    const std::size_t first = column_.list_offsets[face];
    const std::size_t count = column_.list_offsets[face + 1] - first;
    return {column_.values.data() + first, count % 3 == 0 ? count : 0};
  }

  std::span<const double> values_at(Index face, Index vertex) const {
    const Face& corners = mesh_.faces[face];
    const auto corner = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
    const auto values = values_of(face);
    return values.subspan(static_cast<std::size_t>(corner) * (values.size() / 3),
                          values.size() / 3);
  }

  static constexpr double slack = 1e-9;  ///< margin for rounding errors, relative to `reach_`

  const Mesh& mesh_;
  const Column& column_;
  std::vector<Index> across_;  ///< opposite of each halfedge, or no_index
  std::vector<char> is_reached_;
  std::vector<Index> gathered_;
  double reach_ = 0;
};

bool is_left_out(const std::string& name) {
  return name == "nx" || name == "ny" || name == "nz" ||
         std::ranges::find(source_point_names, name) != source_point_names.end();
}

Columns wanted_columns(const Columns& all, const std::vector<std::string>& names) {
  Columns wanted;
  for (const Column& column : all.columns) {
    const bool is_wanted = names.empty() ? !is_left_out(column.name)
                                         : std::ranges::find(names, column.name) != names.end();
    if (is_wanted) wanted.columns.push_back(column);
  }
  return wanted;
}

void check_names(const Mesh& first, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (!first.vertex_columns.find(name) && !first.face_columns.find(name))
      throw InputError("the first mesh has no vertex or face property '" + name + "' to carry");
}

void put(Columns columns, Columns& to) {
  for (Column& column : columns.columns) {
    Column* known = to.find(column.name);
    if (known != nullptr) {
      *known = std::move(column);
    } else {
      to.columns.push_back(std::move(column));
    }
  }
}

Columns of_vertices(const Mesh& first, const Columns& columns,
                    std::span<const SourcePoint> on_first) {
  std::vector<RowBlend> rows;
  rows.reserve(on_first.size());
  for (const SourcePoint& place : on_first)
    rows.push_back({first.faces[place.face], place.weights()});
  return columns.blend(rows);
}

std::array<SourcePoint, 3> at_corners(const Face& face, std::span<const SourcePoint> places) {
  return {places[face[0]], places[face[1]], places[face[2]]};
}

Columns of_faces(const Mesh& first, const Columns& columns, const SourcePoints& on_first,
                 const Mesh& mesh) {
  const std::vector<SourcePoint>& places = on_first.of_faces;
  std::vector<Index> rows;
  rows.reserve(places.size());
  for (const SourcePoint& place : places) rows.push_back(place.face);
  Columns carried = columns.select(rows);
  for (std::size_t i = 0; i < columns.columns.size(); ++i) {
    const Column& column = columns.columns[i];
    if (!is_corner_list(column)) continue;
    Texture texture(first, column);
    Column list{column.name, column.type, {}, column.list_count_type, {0}};
    for (std::size_t f = 0; f < places.size(); ++f)
      texture.append_face(at_corners(mesh.faces[f], on_first.of_vertices), places[f], list);
    carried.columns[i] = std::move(list);
  }
  return carried;
}

}  // namespace

SourcePoints compose_source_points(const Mesh& first, const SourcePoints& middle_on_first,
                                   const Mesh& middle, const SourcePoints& on_middle) {
  const Composition composition(first, middle_on_first, middle);
  const auto composed = [](const std::vector<SourcePoint>& places, const auto& place_of) {
    std::vector<SourcePoint> result(places.size());
    parallel_for(places.size(), places_per_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) result[i] = place_of(places[i]);
    });
    return result;
  };
  return {composed(on_middle.of_vertices,
                   [&](const SourcePoint& place) { return composition.of_vertex(place); }),
          composed(on_middle.of_faces,
                   [&](const SourcePoint& place) { return composition.of_face(place); })};
}

CarryResult carry_columns(const Mesh& first, const SourcePoints& on_first, Mesh& mesh,
                          const std::vector<std::string>& names) {
  check_names(first, names);
  const Columns vertex_columns = wanted_columns(first.vertex_columns, names);
  const Columns face_columns = wanted_columns(first.face_columns, names);
  put(of_vertices(first, vertex_columns, on_first.of_vertices), mesh.vertex_columns);
  put(of_faces(first, face_columns, on_first, mesh), mesh.face_columns);
  return {vertex_columns.columns.size(), face_columns.columns.size()};
}

}  // namespace transformesh
