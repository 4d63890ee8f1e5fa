/// tm-color: colors a surface from calibrated photographs.
#include "options/color_options.h"
#include "options/source_options.h"
#include "views/cameras/view_files.h"

namespace {

using namespace transformesh;

struct Options {
  ViewSources sources;
  tool::ColorChoices choices;
};

void declare(tool::Program& program, Options& options) {
  program.options
      .text("cameras", &options.sources.cameras, "WHERE", "file, folder or pattern of the cameras")
      .is_needed = true;
  program.options
      .text("images", &options.sources.images, "WHERE",
            "file, folder or pattern of the photographs")
      .is_needed = true;
  tool::declare_reading(program, options.sources);
  tool::declare_texture(program, options.choices);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-color", "[OPTION]... --cameras WHERE --images WHERE [INPUT]",
                        "Colors a surface from calibrated photographs"};
  declare(program, options);
  program.epilog =
      "Make a textured GLB file, for web pages and games:\n"
      "  tm-color --cameras par.txt --images photos --texture a.ply -o a.glb";
  program.example = "tm-color --cameras par.txt --images photos hull.ply > colored.ply";
  return program.run(argc, argv, [&](tool::Run& run) {
    tool::check_texture(options.choices, run);
    options.sources.on_note = [&run](const std::string& text) { run.note(text); };
    const std::vector<PictureView> views = picture_views_from(options.sources);
    run.report("views", views.size());
    tool::color(run.document(), views, options.choices, run);
  });
}
