/// Decodes many image files in parallel.
#pragma once

#include <exception>
#include <string>
#include <vector>

#include "io/streams/file_list.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "views/images/packable_image.h"

namespace transformesh {

/// Calls `decode` with the index and the bytes of each file, in parallel. If several files cause an
/// InputError, rethrows that of the first file in the list.
template <typename Decode>
void decode_all(const std::vector<std::string>& paths, const Decode& decode) {
  std::vector<std::exception_ptr> failures(paths.size());
  parallel_for(paths.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      try {
        decode(i, file_bytes(paths[i]));
      } catch (const InputError&) {
        failures[i] = std::current_exception();
      }
    }
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

/// Compresses the image in memory (packable_image.h) if `count` images of its size would have more
/// than `most_pixels` pixels in total. Otherwise the image stays uncompressed, which is faster to
/// read.
inline void pack_one_of(std::size_t count, PackableImage& image) {
  constexpr double most_pixels = 8e6;  ///< largest total of uncompressed pixels: 32 MB of floats
  if (static_cast<double>(count) * image.width * image.height > most_pixels) image.pack();
}

}  // namespace transformesh
