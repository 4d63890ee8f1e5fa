/// Where something is, in the words of a message.
#pragma once

#include <string>

#include "transformesh/mesh.h"

namespace transformesh {

/// "(1, 0, 0.5)"
std::string point_text(const Vec3& point);

/// "vertex 3 at (1, 0, 0.5)"
std::string vertex_text(const Mesh& mesh, Index vertex);

/// "edge from vertex 3 at (1, 0, 0.5) to vertex 4 at (0, 0, 0.5)"
std::string edge_text(const Mesh& mesh, Index halfedge);

}  // namespace transformesh
