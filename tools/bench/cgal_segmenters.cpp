// Peers of CGAL; the only source of the benchmark that sees its headers.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <tuple>

#include "bench/segmenters.hpp"

namespace scenelore::experiment {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// With its number in the cloud: Efficient RANSAC changes the order of its input.
using PointWithNormal = std::tuple<Kernel::Point_3, Kernel::Vector_3, std::size_t>;
using Input = std::vector<PointWithNormal>;
using PointMap = CGAL::Nth_of_tuple_property_map<0, PointWithNormal>;
using NormalMap = CGAL::Nth_of_tuple_property_map<1, PointWithNormal>;

/// Requires: every point is valid, as in simulated rooms; invalid ones are put at the origin.
Input with_normals(const perception::Cloud& cloud) {
  Input points;
  points.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool valid = cloud.valid(i);
    points.emplace_back(valid ? Kernel::Point_3(cloud.x[i], cloud.y[i], cloud.z[i]) : Kernel::Point_3(0, 0, 0), Kernel::Vector_3(0, 0, 0), i);
  }
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(points, 20, CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));
  return points;
}

std::vector<std::int32_t> grow(const perception::Cloud& cloud) {
  using Query = CGAL::Shape_detection::Point_set::K_neighbor_query<Kernel, Input, PointMap>;
  using Region = CGAL::Shape_detection::Point_set::Least_squares_plane_fit_region<Kernel, Input, PointMap, NormalMap>;
  const Input points = with_normals(cloud);
  Query query(points, 20, PointMap());
  Region region(points, 0.03, 25, 50, PointMap(), NormalMap());
  CGAL::Shape_detection::Region_growing<Input, Query, Region> growing(points, query, region);
  std::vector<std::vector<std::size_t>> regions;
  growing.detect(std::back_inserter(regions));
  std::vector<std::int32_t> label(cloud.size(), -1);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const std::size_t i : regions[r]) label[i] = static_cast<std::int32_t>(r);
  }
  return label;
}

std::vector<std::int32_t> efficient_ransac(const perception::Cloud& cloud) {
  using Traits = CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, Input, PointMap, NormalMap>;
  using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
  Input points = with_normals(cloud);
  Ransac ransac;
  ransac.set_input(points);
  ransac.add_shape_factory<CGAL::Shape_detection::Plane<Traits>>();
  Ransac::Parameters parameters;
  parameters.probability = 0.05;
  parameters.min_points = 50;
  parameters.epsilon = 0.03;
  parameters.cluster_epsilon = 0.1;
  parameters.normal_threshold = 0.85;
  ransac.detect(parameters);
  std::vector<std::int32_t> label(cloud.size(), -1);
  std::int32_t plane = 0;
  for (const auto& shape : ransac.shapes()) {
    for (const std::size_t i : shape->indices_of_assigned_points()) label[std::get<2>(points[i])] = plane;
    ++plane;
  }
  return label;
}

}  // namespace

std::vector<Segmenter> cgal_segmenters() {
  return {{"CGAL region growing, k = 20", 1'000'000, grow}, {"CGAL Efficient RANSAC", 1'000'000, efficient_ransac}};
}

}  // namespace scenelore::experiment
