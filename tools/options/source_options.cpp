#include "options/source_options.h"

namespace transformesh::tool {

void declare_reading(Program& program, ViewSources& sources) {
  program.options.flag(
      "mirror", &sources.mirror,
      "mirror the coordinates of the cameras, z to -z: for left-handed coordinates");
  program.options.named("missing", &sources.needs_all_images, {{"skip", false}, {"refuse", true}},
                        "skip or refuse cameras without an image, and images without a camera");
}

}  // namespace transformesh::tool
