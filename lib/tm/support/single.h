/// Rounding to float and back. Write this, not a pair of casts: g++ 12 with optimization drops the
/// pair where it handles two coordinates at once, and leaves doubles that no float can hold.
#pragma once

namespace transformesh {

inline double round_to_single(double value) {
  const volatile auto single = static_cast<float>(value);  // volatile: the casts must happen
  return single;
}

}  // namespace transformesh
