#include "scenelore/perception/memory.hpp"

#include <climits>
#include <cstdint>
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace scenelore::perception {

#ifdef __GLIBC__
namespace {

/// Makes the heap as large, and marks it while nothing of it has been touched. Needs a heap that does not shrink.
void reserve(std::uintptr_t bytes) {
  constexpr std::uintptr_t kHugePage = std::uintptr_t{2} << 20;
  void* const block = std::malloc(bytes);
  if (block == nullptr) return;
  const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(block) + kHugePage - 1) / kHugePage * kHugePage;
  const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(block) + bytes) / kHugePage * kHugePage;
  ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  std::free(block);
}

}  // namespace
#endif

void keep_memory([[maybe_unused]] Work work) {
#ifdef __GLIBC__
  constexpr std::uintptr_t kLabelling = std::uintptr_t{32} << 20, kPerception = std::uintptr_t{1} << 30;
  constexpr int kStep = 64 << 20;     // bytes by which the heap grows
  ::mallopt(M_MMAP_MAX, 0);           // large blocks come from the heap, where they can be used again
  ::mallopt(M_TRIM_THRESHOLD, INT_MAX);
  ::mallopt(M_TOP_PAD, work == Work::perception ? kStep : kStep / 16);
  if (work == Work::perception) ::mallopt(M_ARENA_MAX, 1);  // threads share it: they live for one step each
  reserve(work == Work::perception ? kPerception : kLabelling);
#endif
}

}  // namespace scenelore::perception
