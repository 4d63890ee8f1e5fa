/// The options of tm-render, and their conversion to options of the library.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"
#include "picture/picture.h"

namespace transformesh::tool {

/// Values of the options on the command line. Values that need no conversion are stored in
/// `picture`. The others are converted by picture_of().
struct RenderOptions {
  std::string size = "800x600";
  std::string orbit = "30,20";
  std::string around;
  std::string color;
  std::string background = "#f7f7f7,#d6d9de";
  std::string segments;
  std::vector<double> range;
  int frames = 0;
  /// Duration in seconds of a movie that shows one mesh after the other; 0: no such movie.
  double film = 0;
  bool occlusion = false;
  PictureOptions picture;
};

void declare_picture(Program& program, RenderOptions& options);

/// Returns the options of a picture. Does not set `around` and `segments`, which are read from
/// files. Throws UsageError for values that cannot be parsed.
PictureOptions picture_of(const RenderOptions& options);

/// Throws UsageError if --film, a movie of several meshes, is combined with options that it does
/// not support.
void check_film(const RenderOptions& options, const Program& program);
/// Makes all pictures of a movie of --film have the same camera, floor and colors. `corners` has
/// the corners of the box around all meshes. The pictures frame this box unless `picture.around`
/// already names a mesh to frame.
void hold_still(const std::vector<const Mesh*>& meshes, const Mesh& corners,
                PictureOptions& picture);

/// True if -o is a line drawing (.svg). Throws UsageError if options are given that line drawings
/// do not have.
bool draws_lines(const Run& run);

}  // namespace transformesh::tool
