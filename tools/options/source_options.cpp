#include "options/source_options.h"

namespace transformesh::tool {

void declare_reading(Program& program, ViewSources& sources) {
  program.options.flag(
      "mirror", &sources.mirror,
      "take the mirror image of the cameras' world, z for -z: for left-handed ones");
  program.options.named("missing", &sources.needs_all_images, {{"skip", false}, {"refuse", true}},
                        "images that camera files name but that are not there, and "
                        "images without a camera");
}

}  // namespace transformesh::tool
