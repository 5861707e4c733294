// The smallest rectangle beside OpenCV's, which the paper used.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "scenelore/perception/hull.hpp"

namespace scenelore::perception {
namespace {

TEST(MinimumRectangle, IsAsSmallAsThatOfOpenCv) {
  std::mt19937 random(11);
  const auto uniform = [&] { return static_cast<double>(random() % 100'000) / 50'000 - 1; };
  for (int round = 0; round < 500; ++round) {
    std::vector<Eigen::Vector2d> points;
    std::vector<cv::Point2f> theirs;
    const Eigen::Vector2d along = Eigen::Vector2d(uniform(), uniform() + 1e-3).normalized(), across(-along.y(), along.x());
    const double stretch = 1 + 3 * std::abs(uniform());
    for (int i = 0; i < 3 + round % 60; ++i) {
      points.emplace_back(stretch * uniform() * along + uniform() * across);
      theirs.emplace_back(static_cast<float>(points.back().x()), static_cast<float>(points.back().y()));
    }
    const Rectangle mine = minimum_rectangle(points);
    const cv::RotatedRect found = cv::minAreaRect(theirs);
    const double area = double(found.size.width) * double(found.size.height);
    EXPECT_NEAR(mine.length * mine.width, area, 1e-5 * (1 + area)) << round;
    EXPECT_NEAR(mine.along.norm(), 1, 1e-12) << round;
    EXPECT_GE(mine.length, mine.width) << round;
    for (const Eigen::Vector2d& p : points) {  // and it holds all of them
      const Eigen::Vector2d d = p - mine.center;
      EXPECT_LE(std::abs(mine.along.dot(d)), mine.length / 2 + 1e-9) << round;
      EXPECT_LE(std::abs(mine.along.x() * d.y() - mine.along.y() * d.x()), mine.width / 2 + 1e-9) << round;
    }
  }
}

}  // namespace
}  // namespace scenelore::perception
