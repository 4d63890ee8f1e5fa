// Libraries for every image format there is take 60 ms to load, of which a loop's programs would
// pay in each of hundreds of runs. So they are loaded for a file that needs them.
#include <dlfcn.h>

#include "tm/views/image_module.h"
#include "tm/views/samples.h"

namespace transformesh {
namespace {

DecodeImage* load(std::string& problem) {
  // Found beside the program, by its RUNPATH; never unloaded.
  void* module = dlopen(TM_IMAGE_MODULE, RTLD_NOW | RTLD_LOCAL);
  void* function = module != nullptr ? dlsym(module, decode_image_name) : nullptr;
  if (function == nullptr) problem = dlerror();
  return reinterpret_cast<DecodeImage*>(function);
}

}  // namespace

Samples decode_other(const Source& source) {
  std::string problem;
  DecodeImage* decode_image = load(problem);
  if (decode_image == nullptr) {
    source.fail("only PNG and PNM images can be read, because a part of tm does not load: " +
                problem);
  }
  Samples samples;
  if (!decode_image(source.bytes, samples)) {
    source.fail("not a complete image, or of a kind that OpenCV cannot read");
  }
  return samples;
}

}  // namespace transformesh
