// Costs as whole numbers: to the nearest, as the C library rounds.
#include "scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace scenelore::engine {
namespace {

TEST(Scale, RoundsToTheNearestWholeCost) {
  const Scale scale{Problem()};
  const double unit = scale.real(1);
  std::mt19937_64 random(5);
  const auto expect = [&](double cost) { EXPECT_EQ(scale.whole(cost), std::llround(cost / unit)) << cost; };
  for (const double units : {0.0, 0.25, 0.49999999999999994, 0.5, 1.0, 1.5, 2.5, 0x1p52 + 1, 0x1p53 + 2}) expect(units * unit);
  for (int i = 0; i < 10000; ++i) expect(std::exp(std::uniform_real_distribution<double>(-30, 9)(random)));
}

TEST(Scale, ForbidsWhatIsTooDear) {
  const Scale scale{Problem()};
  EXPECT_EQ(scale.whole(kHard), kTop);
  EXPECT_EQ(scale.whole(std::numeric_limits<double>::max()), kTop);
}

}  // namespace
}  // namespace scenelore::engine
