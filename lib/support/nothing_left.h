/// The refusal of operations that would leave no surface, which loops tell from other ones.
#pragma once

#include "transformesh/errors.h"

namespace transformesh {

/// The goal cannot be reached because no face of the surface would be left.
struct NothingLeftError : GoalError {
  using GoalError::GoalError;
};

}  // namespace transformesh
