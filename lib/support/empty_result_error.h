/// Recognizes errors which mean that an operation would leave no face of the surface. Iterations of
/// an evolution handle them differently from other errors.
#pragma once

#include "transformesh/error_kind.h"
#include "transformesh/errors.h"

namespace transformesh {

/// Returns true if an operation failed because no face of the surface would be left.
constexpr bool is_nothing_left(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::inside_out:
    case ErrorKind::double_sided:
    case ErrorKind::double_sided_sheet:
    case ErrorKind::canceling_faces:
    case ErrorKind::no_area:
    case ErrorKind::no_positive_winding:
    case ErrorKind::no_such_level:
    case ErrorKind::component_too_small:
    case ErrorKind::surface_vanished:
      return true;
    default:
      return false;
  }
}

}  // namespace transformesh
