#include "frame/memory.h"

#include <cstdlib>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <new>

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::size_t large = 2 * huge_page;
constexpr std::size_t small_page = std::size_t{4} << 10;
constexpr std::size_t medium = 16 * small_page;

/// Up to where the heap has been touched.
std::atomic<std::uintptr_t> touched_end{0};

// Asks for huge pages where whole ones lie in the block. It is no error that there are none.
void advise(void* block, std::size_t size) {
  const auto address = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t first = (address + huge_page - 1) / huge_page * huge_page;
  const std::uintptr_t last = (address + size) / huge_page * huge_page;
  if (last > first) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

// Takes the pages of a block for which the heap has grown, all at once: one by one, at their first
// touch, they take longer. Where the system cannot do that, nothing happens.
void touch([[maybe_unused]] void* block, [[maybe_unused]] std::size_t size) {
#ifdef MADV_POPULATE_WRITE
  const auto address = reinterpret_cast<std::uintptr_t>(block);
  if (address > reinterpret_cast<std::uintptr_t>(sbrk(0))) return;  // not in the heap
  const std::uintptr_t last = (address + size) / small_page * small_page;
  const std::uintptr_t first = std::max(address / small_page * small_page + small_page,
                                        touched_end.load(std::memory_order_relaxed));
  if (last <= first) return;
  touched_end.store(last, std::memory_order_relaxed);
  madvise(reinterpret_cast<void*>(first), last - first, MADV_POPULATE_WRITE);
#endif
}

}  // namespace

void* operator new(std::size_t size) {
  for (;;) {
    void* block = std::malloc(size == 0 ? 1 : size);
    if (block != nullptr) {
      if (size >= large) {
        advise(block, size);
      } else if (size >= medium) {
        touch(block, size);
      }
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
  mallopt(M_TOP_PAD, 4 << 20);
}

void give_large_blocks_back() {
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  mallopt(M_MMAP_MAX, 1 << 16);
  mallopt(M_TRIM_THRESHOLD, 16 << 20);
}

}  // namespace transformesh::tool

#else

namespace transformesh::tool {

void prepare_memory() {}
void give_large_blocks_back() {}

}  // namespace transformesh::tool

#endif
