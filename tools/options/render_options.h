/// The options of tm-render, and what they say of the picture.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"
#include "picture/picture.h"

namespace transformesh::tool {

/// Options as they are written; the rest are in `picture`.
struct RenderOptions {
  std::string size = "800x600";
  std::string orbit = "30,20";
  std::string up = "y";
  std::string frame = "each";
  std::string around;
  std::string color;
  std::string background = "#f7f7f7,#d6d9de";
  std::string segments;
  std::vector<double> range;
  long columns = 0;
  int frames = 0;
  bool occlusion = false;
  PictureOptions picture;
};

void declare_picture(Program& program, RenderOptions& options);

/// The picture that they describe, but for `around` and segments, which are files. Throws
/// UsageError for what cannot be read.
PictureOptions picture_of(const RenderOptions& options);

/// Whether -o is a line drawing: .svg. Throws UsageError where an option is given that is none of
/// lines.
bool draws_lines(const Run& run);

}  // namespace transformesh::tool
