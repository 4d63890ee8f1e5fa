/// Scales of colors, which depend on the type of their column.
#pragma once

#include "transformesh/columns.h"

namespace transformesh {

/// Returns the value of full intensity: 1 for floating types, 65535 for ushort, and 255 for other
/// types, because programs that write wider integers usually store bytes in them.
inline double full_intensity(Scalar type) {
  if (type == Scalar::float32 || type == Scalar::float64) return 1;
  return type == Scalar::uint16 ? 65535 : 255;
}

}  // namespace transformesh
