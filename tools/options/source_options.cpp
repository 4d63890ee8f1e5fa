#include "options/source_options.h"

#include <memory>

namespace transformesh::tool {

void declare_reading(Program& program, ViewSources& sources) {
  program.options.flag(
      "mirror", &sources.mirror,
      "mirror the coordinates of the cameras, z to -z: for left-handed coordinates");
  const auto word = std::make_shared<std::string>("skip");
  Option& missing = program.options.choice(
      "missing", word.get(), {"skip", "refuse"},
      "skip or refuse cameras without an image, and images without a camera");
  missing.assign = [word, &sources, assign = missing.assign](const std::string& text) {
    assign(text);
    sources.needs_all_images = *word == "refuse";
  };
}

}  // namespace transformesh::tool
