/// A vector that does not initialize its elements when it is created or grows. This avoids a serial
/// pass over the memory before a parallel loop writes all elements. The threads of the loop are
/// then the first to access the memory pages.
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
