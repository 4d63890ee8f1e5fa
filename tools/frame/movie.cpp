#include "frame/movie.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "frame/filter_process.h"
#include "support/lower_case.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t least_digits = 3;
/// Smallest number of pictures per second of a movie; chosen by hand.
constexpr double slowest = 0.01;

// Returns the beginning of the ffmpeg command, which reads PNG pictures from stdin. The encoder
// x264 runs on one thread, because its output depends on the number of threads.
std::string read_pictures(double per_second) {
  return "ffmpeg -v error -y -f image2pipe -c:v png -framerate " + significant(per_second, 9) +
         " -i - -threads 1 -fflags +bitexact -flags:v +bitexact ";
}

const std::string write_mp4 = "-pix_fmt yuv420p -movflags +faststart -f mp4 /dev/stdout";
const std::string write_gif =
    "-filter_complex 'split[a][b];[a]palettegen[p];[b][p]paletteuse' -loop 0 -f gif /dev/stdout";

bool is_movie(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".mp4" || ending == ".gif";
}

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access(folder.append("/").append(program).c_str(), X_OK) == 0) return true;
  return false;
}

/// Returns the name of a numbered file, such as `orbit-007.png` for `orbit.png`.
std::string numbered(const std::string& path, int frame, int frames) {
  const std::size_t digits = std::max(std::to_string(frames - 1).size(), least_digits);
  const std::string number = std::to_string(frame);
  const std::size_t stem = path.size() - ending_of(path).size();
  std::string name = path.substr(0, stem);
  name.append("-").append(digits - number.size(), '0').append(number);
  return name.append(path, stem);
}

// Throws UsageError if players would not show a movie at the requested speed. The delay of a
// picture in a GIF is a whole number of hundredths of a second, and browsers lengthen delays below
// two hundredths.
void check_speed(double per_second, const std::string& path) {
  const double most = ending_of(path) == ".gif" ? 50 : 120;
  if (per_second >= slowest && per_second <= most) return;
  throw UsageError("--film: the movie would have " + significant(per_second, 3) +
                   " pictures per second: choose a duration in which it has " +
                   significant(slowest, 1) + " to " + significant(most, 3));
}

}  // namespace

std::string ending_of(const std::string& path) {
  return lower_case(fs::path(path).extension().string());
}

void check_movie(int frames, int width, int height, bool is_transparent, const Run& run) {
  const std::string& path = run.out().name();
  if (frames == 0 && is_movie(path))
    throw UsageError("--output: '" + path +
                     "' is a movie: give --film, or the number of pictures with --frames");
  if (frames > 0 && path == "-")
    throw UsageError(
        "a movie needs a name: -o orbit.mp4 or orbit.gif for a movie, orbit.png for numbered "
        "pictures");
  if (!is_movie(path)) return;
  const bool is_mp4 = ending_of(path) == ".mp4";
  if (is_mp4 && (width % 2 != 0 || height % 2 != 0))
    throw UsageError("--size: width and height of an MP4 movie must be even: add a pixel");
  if (is_mp4 && is_transparent)
    throw UsageError(
        "--background: an MP4 movie cannot be transparent: give a color, or write a GIF");
  if (!is_installed("ffmpeg"))
    throw GoalError(
        "movies are encoded by ffmpeg, which is not installed: install it (Debian: "
        "apt-get install ffmpeg), or write numbered pictures with -o NAME.png");
}

void write_frames(int frames, double per_second, const DrawFrame& draw, Run& run) {
  const std::string& path = run.out().name();
  if (is_movie(path)) check_speed(per_second, path);
  std::string pictures;
  for (int frame = 0; frame < frames; ++frame) {
    run.progress()("draw", static_cast<double>(frame) / frames);
    if (is_movie(path))
      pictures += draw(frame);
    else
      run.out().write(numbered(path, frame, frames), draw(frame));
  }
  run.report("frames", static_cast<std::size_t>(frames));
  if (!is_movie(path)) return run.out().write_nothing();
  run.progress()("encode");
  const std::string& write = ending_of(path) == ".mp4" ? write_mp4 : write_gif;
  run.out().set_bytes(run_filter(read_pictures(per_second) + write, pictures, FilterOutput::file));
}

}  // namespace transformesh::tool
