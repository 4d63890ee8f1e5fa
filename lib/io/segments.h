/// Segments in a PLY: the element `edge`, whose numbers vertex1 and vertex2 name the vertices at
/// their ends, as in files of the curves along which a mesh intersects itself.
#pragma once

#include <utility>
#include <vector>

#include "transformesh/document.h"

namespace transformesh {

using Segment = std::pair<Vec3, Vec3>;

/// In the order of the file. Throws InputError, calling the file `name`, where there is no such
/// element and where a vertex is named that does not exist.
std::vector<Segment> segments_of(const Document& document, const std::string& name);

/// The bytes of a binary PLY that holds the segments, each with vertices of its own.
std::string segment_file(const std::vector<Segment>& segments);

}  // namespace transformesh
