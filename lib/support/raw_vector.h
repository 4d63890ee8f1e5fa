/// A vector that does not initialize its elements when it is created or grows. Loops that write
/// every element then touch the memory first, in parallel, and no serial pass fills it before.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace transformesh {

/// Allocator that default-initializes elements, which leaves numbers uninitialized.
template <class T>
class RawAllocator : public std::allocator<T> {
 public:
  template <class Other>
  struct rebind {
    using other = RawAllocator<Other>;
  };

  template <class Other>
  void construct(Other* at) {
    ::new (static_cast<void*>(at)) Other;
  }
  template <class Other, class... Arguments>
  void construct(Other* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) Other(std::forward<Arguments>(arguments)...);
  }
};

template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace transformesh
