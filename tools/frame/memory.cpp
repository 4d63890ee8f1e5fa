#include "frame/memory.h"

#include <cstdlib>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <new>

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::size_t large = 2 * huge_page;
/// A program that takes no block of this size does without huge pages, which take time to clear.
constexpr std::size_t notable = std::size_t{64} << 10;

/// Where the heap ended when it was last seen.
std::atomic<std::uintptr_t> seen_end{0};

void advise(std::uintptr_t first, std::uintptr_t last) {
  if (last > first) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

// Asks for huge pages for what the heap has grown by and, where the block lies elsewhere, for the
// whole ones in it. It is no error that there are none.
void advise_around(void* block, std::size_t size) {
  const auto address = reinterpret_cast<std::uintptr_t>(block);
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  if (address > end) {
    if (size >= large)
      advise((address + huge_page - 1) / huge_page * huge_page,
             (address + size) / huge_page * huge_page);
    return;
  }
  const std::uintptr_t before = seen_end.exchange(end);
  if (before == end) return;
  const std::uintptr_t page = 4096;
  advise(before == 0 || before > end ? address / page * page : before / page * page,
         end / page * page);
}

}  // namespace

void* operator new(std::size_t size) {
  for (;;) {
    void* block = std::malloc(size == 0 ? 1 : size);
    if (block != nullptr) {
      if (size >= notable) advise_around(block, size);
      return block;
    }
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }

namespace transformesh::tool {

void prepare_memory() {
  // A filter lives for milliseconds: memory given back to the system and taken again costs more of
  // them than it saves, but for large blocks.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, 512 << 20);
  mallopt(M_TOP_PAD, 32 << 20);
}

}  // namespace transformesh::tool

#else

namespace transformesh::tool {

void prepare_memory() {}

}  // namespace transformesh::tool

#endif
