/// Movies: pictures that follow each other, as numbered files or encoded by ffmpeg.
#pragma once

#include <functional>
#include <string>

#include "frame/run.h"

namespace transformesh::tool {

/// The bytes of a picture, of PNG for movies.
using DrawFrame = std::function<std::string(int frame)>;

/// The ending of a file's name with its dot, in lower case.
std::string ending_of(const std::string& path);

/// Before anything is drawn. Throws UsageError where -o cannot hold so many frames (0: a picture
/// alone), or no movie of that kind, and GoalError where ffmpeg is needed and not installed.
void check_movie(int frames, int width, int height, bool is_transparent, const Run& run);

/// Draws all frames and writes them to -o: a movie of 25 pictures a second, or files numbered from
/// 0 on, orbit-000.png for orbit.png. Throws GoalError where ffmpeg fails, having told why.
void write_frames(int frames, const DrawFrame& draw, Run& run);

}  // namespace transformesh::tool
