// Libraries for every image format there is take 60 ms to load, of which a loop's programs would
// pay in each of hundreds of runs. So they are loaded for a file that needs them.
#include <dlfcn.h>

#include "tm/views/images/image_module.h"
#include "tm/views/images/samples.h"

namespace transformesh {
namespace {

DecodeImage* load(std::string& problem) {
  // Found beside the program, by its RUNPATH; never unloaded.
  void* module = dlopen(TM_IMAGE_MODULE, RTLD_NOW | RTLD_LOCAL);
  void* function = module != nullptr ? dlsym(module, decode_image_name) : nullptr;
  if (function == nullptr) problem = dlerror();
  return reinterpret_cast<DecodeImage*>(function);
}

std::uint8_t byte_at(std::string_view bytes, std::size_t place) {
  return static_cast<std::uint8_t>(bytes[place]);
}

/// Goes from segment to segment to the end of the image, which decoders do without: they fill what
/// is missing with grey.
bool is_complete_jpeg(std::string_view bytes) {
  constexpr std::uint8_t end_of_image = 0xd9;
  constexpr std::uint8_t start_of_scan = 0xda;
  std::size_t place = 2;
  while (place + 4 <= bytes.size()) {
    const std::uint8_t marker = byte_at(bytes, place + 1);
    if (byte_at(bytes, place) != 0xff) return false;
    if (marker == 0xff) {
      ++place;  // fill
      continue;
    }
    place += 2 + 256 * std::size_t{byte_at(bytes, place + 2)} + byte_at(bytes, place + 3);
    if (marker != start_of_scan) continue;
    // In a scan's data, 0xff stands before 0 and before the marks of restarts.
    const auto is_data = [&] {
      const std::uint8_t next = byte_at(bytes, place + 1);
      return byte_at(bytes, place) != 0xff || next == 0 || (next >= 0xd0 && next <= 0xd7);
    };
    while (place + 2 <= bytes.size() && is_data()) ++place;
    if (place + 2 <= bytes.size() && byte_at(bytes, place + 1) == end_of_image) return true;
  }
  return false;
}

}  // namespace

Samples decode_other(const Source& source) {
  std::string problem;
  DecodeImage* decode_image = load(problem);
  if (decode_image == nullptr) {
    source.fail("only PNG and PNM images can be read, because a part of tm does not load: " +
                problem);
  }
  if (source.bytes.starts_with("\xff\xd8") && !is_complete_jpeg(source.bytes)) {
    source.fail("not a complete JPEG image: the file ends too early");
  }
  Samples samples;
  if (!decode_image(source.bytes, samples, problem)) {
    source.fail("not a complete image: " +
                (problem.empty() ? "OpenCV finds none of 8 or 16 bits" : problem));
  }
  return samples;
}

}  // namespace transformesh
