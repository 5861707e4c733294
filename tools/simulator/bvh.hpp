// Exact ray casting among many shapes: a binary tree of bounding boxes.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/shape.hpp"

namespace scenelore::simulator {

struct Hit {
  double range = kMiss;
  const Shape* shape = nullptr;  ///< null when nothing was hit; lives as long as the tree
};

class Bvh {
 public:
  explicit Bvh(std::vector<Shape> shapes);
  /// The first hit with nearest < range < farthest. Thread-safe.
  [[nodiscard]] Hit cast(const Ray& ray, double nearest, double farthest = kMiss) const;

 private:
  struct Node {
    Eigen::Array3d low, high;
    std::uint32_t first = 0;  ///< of its shapes, or of its two children
    std::uint32_t count = 0;  ///< of its shapes; 0 in an inner node
  };
  void build(std::size_t node, std::uint32_t first, std::uint32_t last, int depth);

  std::vector<Shape> shapes_;
  std::vector<Node> nodes_;
};

}  // namespace scenelore::simulator
