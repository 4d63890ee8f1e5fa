#include "frame/memory.h"

#include <cstdlib>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#include <malloc.h>
#include <sys/mman.h>

#include <cstdint>
#include <new>

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::size_t large = 2 * huge_page;

// Asks for huge pages where whole ones lie in the block. It is no error that there are none.
void advise(void* block, std::size_t size) {
  const auto address = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t first = (address + huge_page - 1) / huge_page * huge_page;
  const std::uintptr_t last = (address + size) / huge_page * huge_page;
  if (last > first) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

}  // namespace

void* operator new(std::size_t size) {
  for (;;) {
    void* block = std::malloc(size == 0 ? 1 : size);
    if (block != nullptr) {
      if (size >= large) advise(block, size);
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

}  // namespace transformesh::tool

#else

namespace transformesh::tool {

void prepare_memory() {}

}  // namespace transformesh::tool

#endif
