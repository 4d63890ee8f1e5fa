/// tm-render: draws pictures of meshes without a display.
#include "frame/movie.h"
#include "io/segments.h"
#include "options/render_options.h"
#include "picture/ambient_occlusion.h"
#include "picture/line_drawing.h"
#include "transformesh/errors.h"
#include "transformesh/image.h"

namespace {

using namespace transformesh;

/// Pictures per second of a movie in which the camera turns around the mesh. Half of it does not
/// look smooth, and twice as many pictures take twice the time to draw.
constexpr double frames_per_second = 25;

void render(const tool::RenderOptions& options, tool::Run& run) {
  PictureOptions picture = tool::picture_of(options);
  const bool is_lines = tool::draws_lines(run);
  const bool is_film = options.film > 0;
  if (is_film) tool::check_film(options, run.program());
  tool::check_movie(is_film ? 1 : options.frames, picture.width, picture.height,
                    picture.shade.background.is_transparent, run);

  const Mesh around = options.around.empty() ? Mesh{} : run.in().read(options.around).mesh;
  if (!options.around.empty()) picture.around = &around;
  if (!options.segments.empty())
    picture.shade.segments = segments_of(run.in().read(options.segments), options.segments);
  if (options.occlusion) picture.shade.openness = "tm:openness";
  std::vector<const Mesh*> meshes;
  for (Document& document : run.in().documents()) {
    if (options.occlusion) set_openness(document.mesh, picture.shade.openness, run.progress());
    meshes.push_back(&document.mesh);
  }
  run.report("meshes", meshes.size());
  const Mesh corners = is_film ? corners_around(meshes) : Mesh{};
  if (is_film) tool::hold_still(meshes, corners, picture);

  const auto draw = [&](int frame, const Progress& progress) {
    if (is_film)
      picture.only = static_cast<std::size_t>(frame);
    else
      picture.frame = frame;
    return is_lines ? draw_lines(meshes, picture, progress)
                    : write_png(draw_picture(meshes, picture, progress));
  };
  const int frames = is_film ? static_cast<int>(meshes.size()) : options.frames;
  if (frames == 0) return run.out().set_bytes(draw(0, run.progress()));
  const auto draw_frame = [&](int frame) { return draw(frame, {}); };
  tool::write_frames(frames, is_film ? frames / options.film : frames_per_second, draw_frame, run);
}

}  // namespace

int main(int argc, char** argv) {
  tool::RenderOptions options;
  tool::Program program{"tm-render",
                        "[OPTION]... [INPUT]...",
                        "Draws meshes as a PNG picture, an SVG line drawing or a movie",
                        {tool::Reads::meshes},
                        {tool::Writes::picture}};
  tool::declare_picture(program, options);
  program.output.picture_endings = {".png", ".svg", ".mp4", ".gif"};
  program.epilog = "Before and after: tm-clean a.ply | tm-render --frame place a.ply - > both.png";
  program.example = "tm-render mesh.ply > mesh.png";
  return program.run(argc, argv, [&](tool::Run& run) { render(options, run); });
}
