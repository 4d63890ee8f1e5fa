/// Line drawings for print: SVG with the visible edges of meshes.
#pragma once

#include <span>
#include <string>

#include "picture/picture.h"

namespace transformesh {

/// Draws panels as draw_picture() does, and throws as it does. The lines are of four kinds.
/// Outlines are borders, and edges between a front face and a back face. Creases are edges that
/// bend by more than `shade.crease_angle_deg`. Further kinds are `shade.segments`, and all other
/// edges if `shade.draw_edges` is true. Each kind is one path of its own class in each panel.
/// Outlines and segments are 1.2 pixels wide, creases 0.8, and other edges 0.4.
///
/// Colors, background and legend are omitted. Lengths are pixels with two decimals, and lines with
/// common ends are joined. Vertices are identified by index, so that all edges of a soup are
/// borders. Cost: see visible_lines.h; parallel over edges. The result does not depend on the
/// number of threads.
std::string draw_lines(std::span<const Mesh* const> meshes, const PictureOptions& options = {},
                       const Progress& progress = {});

}  // namespace transformesh
