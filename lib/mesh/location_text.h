/// Locations as text for messages, and as data for errors.
#pragma once

#include <array>
#include <string>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Returns text like "(1, 0, 0.5)".
std::string point_text(const Vec3& point);

/// Returns text like "(1, 0, 0.3333)", with four significant digits.
std::string rough_point_text(const Vec3& point);

/// Returns text like "vertex 3 at (1, 0, 0.5)".
std::string vertex_text(const Mesh& mesh, Index vertex);

/// Returns text like "edge from vertex 3 at (1, 0, 0.5) to vertex 4 at (0, 0, 0.5)".
std::string edge_text(const Mesh& mesh, Index halfedge);

/// Returns the coordinates for ErrorData::position.
inline std::array<double, 3> position_data(const Vec3& point) {
  return {point.x(), point.y(), point.z()};
}

/// Returns the face, the edge and the position of its first vertex.
ErrorData edge_data(const Mesh& mesh, Index halfedge);

}  // namespace transformesh
