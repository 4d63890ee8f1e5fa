/// Line drawings for print: SVG with the edges of meshes that the eye sees, hidden lines removed.
#pragma once

#include <span>
#include <string>

#include "picture/picture.h"

namespace transformesh {

/// Panels and views are those of draw_picture(), with its errors. Drawn are outlines (borders, and
/// edges between a face seen from outside and one seen from inside), creases (edges that bend by
/// more than shade.crease_angle_deg), shade.segments, and with shade.draw_edges all other edges:
/// each kind is one path of its own class in each panel, thicker in that order. Colors, background
/// and legend are left out. Lengths are pixels with two decimals, and lines that meet are joined.
/// Vertices are the same when their indices are: all edges of a soup are borders.
/// Cost: see visible_lines.h; parallel over edges. The same bytes for any number of threads.
std::string draw_lines(std::span<const Mesh* const> meshes, const PictureOptions& options = {},
                       const Progress& progress = {});

}  // namespace transformesh
