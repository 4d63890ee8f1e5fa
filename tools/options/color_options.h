/// Colors and textures from photographs, as options of programs.
#pragma once

#include "frame/run.h"
#include "views/cameras/view_files.h"
#include "views/color/texture_surface.h"

namespace transformesh::tool {

struct ColorChoices {
  bool has_texture = false;
  AtlasOptions atlas;
};

/// Declares --texture and --texture-size.
void declare_texture(Program& program, ColorChoices& choices);

/// Throws UsageError if a texture can be stored neither in the output nor beside it.
void check_texture(const ColorChoices& choices, const Run& run);

/// Colors the vertices, or makes a texture and writes it beside the output. Adds the result to the
/// report.
void color(Document& document, std::span<const PictureView> views, const ColorChoices& choices,
           Run& run);

}  // namespace transformesh::tool
