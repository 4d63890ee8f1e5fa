/// The two ways to find the exterior (exterior.h).
#pragma once

namespace transformesh {

enum class ExteriorMethod {
  grow,        ///< region growing over patches (paper 3.2)
  static_test  ///< a ray for every piece (paper 4.5): slow, the reference
};

}  // namespace transformesh
