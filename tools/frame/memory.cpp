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
constexpr std::size_t large = huge_page / 4;
constexpr std::size_t small_page = std::size_t{4} << 10;
constexpr std::size_t medium = 16 * small_page;

/// Up to where the heap has been prepared.
std::atomic<std::uintptr_t> prepared_end{0};

void advise(std::uintptr_t first, std::uintptr_t last, int advice) {
  if (last > first) madvise(reinterpret_cast<void*>(first), last - first, advice);
}

// Pages take long one by one at their first touch. Once a block is large, all that the heap has
// grown by may have huge pages; before, small ones are taken for each block, all at once. Outside
// of the heap, a block has huge pages where whole ones lie in it. It is no error where the system
// cannot do that.
void prepare(void* block, std::size_t size) {
  const auto first = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t last = first + size;
  const auto heap_end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  if (first >= heap_end) {
    advise((first + huge_page - 1) / huge_page * huge_page, last / huge_page * huge_page,
           MADV_HUGEPAGE);
    return;
  }
  const std::uintptr_t prepared = prepared_end.load(std::memory_order_relaxed);
  if (last <= prepared) return;
  const std::uintptr_t begin = std::max(first / small_page * small_page + small_page, prepared);
  const std::uintptr_t end = size >= large ? heap_end : last / small_page * small_page;
  prepared_end.store(end, std::memory_order_relaxed);
  if (size >= large) advise(begin, end, MADV_HUGEPAGE);
#ifdef MADV_POPULATE_WRITE
  else
    advise(begin, end, MADV_POPULATE_WRITE);
#endif
}

}  // namespace

void* operator new(std::size_t size) {
  for (;;) {
    void* block = std::malloc(size == 0 ? 1 : size);
    if (block != nullptr) {
      if (size >= medium) prepare(block, size);
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
  mallopt(M_TOP_PAD, 16 << 20);
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
