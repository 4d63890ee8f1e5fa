/// Segments in a PLY file: rows of the element `edge`, whose properties vertex1 and vertex2 are the
/// indices of their ends. Files of self-intersection curves have this form.
#pragma once

#include <utility>
#include <vector>

#include "transformesh/document.h"

namespace transformesh {

using Segment = std::pair<Vec3, Vec3>;

/// Returns the segments in the order of the file. Throws InputError, naming the file `name`, if
/// there is no element `edge` or an index is out of range.
std::vector<Segment> segments_of(const Document& document, const std::string& name);

/// Returns the bytes of a binary PLY file with the segments. Each segment gets two vertices of its
/// own.
std::string segment_file(const std::vector<Segment>& segments);

}  // namespace transformesh
