#include "scenelore/perception/memory.hpp"

#include <climits>
#include <cstdint>
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace scenelore::perception {

void keep_memory() {
#ifdef __GLIBC__
  constexpr int kStep = 64 << 20;  // bytes by which the heap grows
  ::mallopt(M_MMAP_MAX, 0);        // large blocks come from the heap, where they can be used again
  ::mallopt(M_TRIM_THRESHOLD, INT_MAX);
  ::mallopt(M_TOP_PAD, kStep);
  ::mallopt(M_ARENA_MAX, 1);       // threads share it: they live for one step each
  // The heap is made as large as clouds of some ten million points need, and marked while nothing of it has been touched: addresses
  // alone cost nothing.
  constexpr std::uintptr_t kReserve = std::uintptr_t{1} << 30, kHugePage = std::uintptr_t{2} << 20;
  void* const reserve = std::malloc(kReserve);
  if (reserve == nullptr) return;
  const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(reserve) + kHugePage - 1) / kHugePage * kHugePage;
  const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(reserve) + kReserve) / kHugePage * kHugePage;
  ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // a hint
  std::free(reserve);
#endif
}

}  // namespace scenelore::perception
