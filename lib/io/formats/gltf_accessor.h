/// Numbers of a glTF accessor (ISO/IEC 12113:2022, section 3.6).
#pragma once

#include <string>
#include <vector>

#include "io/formats/gltf_file.h"

namespace transformesh {

struct GltfNumbers {
  /// Values of all elements, `width` for each; normalized integers are in [-1, 1].
  std::vector<double> values;
  std::size_t width = 1;
  bool is_byte = false;      ///< true if the file stores unsigned bytes
  bool is_floating = false;  ///< true if the file stores floats
  /// Value of full color intensity: 1, or the largest value of an integer type that is not
  /// normalized.
  double one = 1;

  std::size_t size() const { return values.size() / width; }
};

/// Returns the numbers of an accessor of scalars or vectors. Throws InputError if the accessor
/// exceeds its buffer, if an index of its sparse part is out of range, and for more than `most`
/// elements.
GltfNumbers gltf_numbers(const GltfFile& file, std::size_t accessor, std::size_t most);

}  // namespace transformesh
