/// Colors and textures from photographs, as options of programs.
#pragma once

#include "frame/run.h"
#include "views/cameras/view_files.h"
#include "views/color/texture_surface.h"

namespace transformesh::tool {

struct ColorChoices {
  bool has_texture = false;
  long texture_size = AtlasOptions().most_size;
};

/// --texture and --texture-size.
void declare_texture(Program& program, ColorChoices& choices);

/// Throws UsageError where a texture has no place beside the output or in it.
void check_texture(const ColorChoices& choices, const Run& run);

/// Colors the vertices, or makes a texture, which is written beside the output, and reports it.
void color(Document& document, std::span<const PictureView> views, const ColorChoices& choices,
           Run& run);

}  // namespace transformesh::tool
