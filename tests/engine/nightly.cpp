// engine_nightly [COUNT] [FIRST]: random problems by the million, all answers about each one. Stops at the first fault
// and prints the smallest problem on which something is wrong, as .cfn.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "model.hpp"

int main(int argc, char** argv) {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2'000'000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0;
  for (std::uint64_t number = first; number < first + count; ++number) {
    const std::string fault = scenelore::engine::testing::report(number);
    if (!fault.empty()) {
      std::printf("%s", fault.c_str());
      return 1;
    }
    if ((number - first + 1) % 10'000 == 0) {
      std::printf("%llu problems, no fault\n", static_cast<unsigned long long>(number - first + 1));
      std::fflush(stdout);
    }
  }
  std::printf("%llu problems, no fault\n", static_cast<unsigned long long>(count));
  return 0;
}
