/// Writes movies as numbered files, or encoded by ffmpeg.
#pragma once

#include <functional>
#include <string>

#include "frame/run.h"

namespace transformesh::tool {

/// Returns the bytes of a frame. The bytes are a PNG file if a movie is encoded.
using DrawFrame = std::function<std::string(int frame)>;

/// Returns the ending of a file name with its dot, in lower case.
std::string ending_of(const std::string& path);

/// Checks the options before anything is drawn. `frames` is 0 for a single picture. Throws
/// UsageError if -o is a movie and there is a single picture, or if there are frames and -o is
/// stdout. Also throws UsageError for an MP4 movie of odd width or height, or with a transparent
/// background. Throws GoalError if ffmpeg is needed but not installed.
void check_movie(int frames, int width, int height, bool is_transparent, const Run& run);

/// Draws all frames and writes them to -o: a movie with `per_second` frames per second, or files
/// numbered from 0, such as orbit-000.png for orbit.png. Throws GoalError if ffmpeg fails. In this
/// case, ffmpeg prints the reason on stderr.
void write_frames(int frames, double per_second, const DrawFrame& draw, Run& run);

}  // namespace transformesh::tool
