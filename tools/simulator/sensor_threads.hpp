// Definition of measure_lines; included by sensor.hpp alone.
#pragma once

#include <array>
#include <thread>

namespace scenelore::simulator {

template <typename Measure>
std::vector<Sample> measure_lines(int lines, const Measure& measure) {
  std::array<std::vector<Sample>, 2> halves;
  const auto run = [&](int half) {
    const int from = half * (lines / 2), to = half == 0 ? lines / 2 : lines;
    for (int line = from; line < to; ++line) measure(line, halves[static_cast<std::size_t>(half)]);
  };
  {
    const std::jthread helper(run, 1);
    run(0);
  }
  halves[0].insert(halves[0].end(), halves[1].begin(), halves[1].end());
  return std::move(halves[0]);
}

}  // namespace scenelore::simulator
