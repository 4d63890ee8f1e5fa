#pragma once

#include <limits>

namespace transformesh {

/// Machine epsilon of doubles: twice the value in Shewchuk 1997, so bounds hold in any rounding
/// mode.
inline constexpr double machine_epsilon = std::numeric_limits<double>::epsilon();

/// Products below this may have lost bits to underflow. Then no comparison of doubles decides.
inline constexpr double underflow_guard = 1e-280;

}  // namespace transformesh
