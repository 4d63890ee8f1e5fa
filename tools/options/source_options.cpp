#include "options/source_options.h"

#include <memory>

namespace transformesh::tool {

void declare_reading(Program& program, ViewSources& sources) {
  program.options.flag(
      "mirror", &sources.mirror,
      "take the mirror image of the cameras' world, z for -z: for left-handed ones");
  const auto word = std::make_shared<std::string>("skip");
  Option& missing =
      program.options.choice("missing", word.get(), {"skip", "refuse"},
                             "images that camera files name but that are not there, and "
                             "images without a camera");
  missing.assign = [word, &sources, assign = missing.assign](const std::string& text) {
    assign(text);
    sources.needs_all_images = *word == "refuse";
  };
}

}  // namespace transformesh::tool
