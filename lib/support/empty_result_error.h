/// Error of operations that would leave no surface. Loops distinguish it from other errors.
#pragma once

#include "support/error.h"

namespace transformesh {

/// The goal cannot be reached because no face of the surface would be left.
struct EmptyResultError : GoalError {
  using GoalError::GoalError;
};

}  // namespace transformesh
