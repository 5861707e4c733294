#include <malloc.h>

#include "command.hpp"

int main(int argc, char** argv) {
  // Vectors of some megabytes come and go while a scan is labelled: memory that is kept need not be mapped and zeroed again.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 128 << 20);
  mallopt(M_TOP_PAD, 4 << 20);
  return scenelore::tools::run_command_line(argc, argv);
}
