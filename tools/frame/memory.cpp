#include "frame/memory.h"

#include <cstdlib>  // defines __GLIBC__

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace transformesh::tool {
namespace {

constexpr int reserved = 1 << 30;
constexpr int mebibyte = 1 << 20;
constexpr std::uintptr_t huge_page = std::uintptr_t{2} << 20;

/// Extends the heap at once, without touching its pages, and requests huge pages for it. If a
/// memory limit forbids the extension, the heap grows in small pages later.
void reserve_heap() {
  const auto begin = reinterpret_cast<std::uintptr_t>(sbrk(0));
  mallopt(M_TOP_PAD, reserved);
  // The pointer is volatile, so that the compiler does not remove the allocation.
  void* volatile block = std::malloc(mebibyte);
  std::free(block);
  mallopt(M_TOP_PAD, 16 * mebibyte);
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  const std::uintptr_t first = (begin + huge_page - 1) / huge_page * huge_page;
  if (end > first) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

}  // namespace

void prepare_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, reserved + reserved / 2);
  reserve_heap();
}

void give_large_blocks_back() {
  mallopt(M_MMAP_THRESHOLD, mebibyte);
  mallopt(M_MMAP_MAX, 1 << 16);
  mallopt(M_TRIM_THRESHOLD, 16 * mebibyte);
}

}  // namespace transformesh::tool

#else

namespace transformesh::tool {

void prepare_memory() {}
void give_large_blocks_back() {}

}  // namespace transformesh::tool

#endif
