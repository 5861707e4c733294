#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

#include "command.hpp"

namespace {

/// Vectors of some megabytes come and go while a scan is labelled. Memory that is kept need not be mapped and zeroed again,
/// and in pages of 2 MB instead of 4 kB the first use costs a thousandth of the interruptions. Only advice: without it all
/// works the same.
void keep_memory() {
  constexpr std::uintptr_t kHugePage = 2 << 20;
  constexpr int kAtOnce = 32 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 128 << 20);
  mallopt(M_TOP_PAD, 4 << 20);
  void* volatile first = std::malloc(kAtOnce - kHugePage);
  std::free(first);
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0)) & ~(kHugePage - 1);
  const auto begin = end - (kAtOnce - kHugePage);
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory();
  return scenelore::tools::run_command_line(argc, argv);
}
