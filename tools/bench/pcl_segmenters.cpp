// Peers of the Point Cloud Library; the only source that sees its headers.
#include <pcl/features/normal_3d.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>
#include <pcl/segmentation/sac_segmentation.h>

#include "bench/segmenters.hpp"

namespace scenelore::experiment {
namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;

Points::Ptr to_pcl(const perception::Cloud& cloud) {
  Points::Ptr points(new Points);
  points->reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) points->emplace_back(cloud.x[i], cloud.y[i], cloud.z[i]);
  return points;
}

/// The tutorial's settings (https://pcl.readthedocs.io/projects/tutorials/en/latest/region_growing_segmentation.html).
std::vector<std::int32_t> grow(const Points::Ptr& points, int fewest) {
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setSearchMethod(tree);
  estimation.setInputCloud(points);
  estimation.setKSearch(30);
  estimation.compute(*normals);
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setMinClusterSize(fewest);
  growing.setMaxClusterSize(static_cast<int>(points->size()));
  growing.setSearchMethod(tree);
  growing.setNumberOfNeighbours(30);
  growing.setInputCloud(points);
  growing.setInputNormals(normals);
  growing.setSmoothnessThreshold(static_cast<float>(3.0 / 180.0 * M_PI));
  growing.setCurvatureThreshold(1.0);
  std::vector<pcl::PointIndices> clusters;
  growing.extract(clusters);
  std::vector<std::int32_t> label(points->size(), -1);
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    for (const auto i : clusters[c].indices) label[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(c);
  }
  return label;
}

std::vector<std::int32_t> grow_on_voxels(const perception::Cloud& cloud, float leaf) {
  const Points::Ptr points = to_pcl(cloud);
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  filter.setInputCloud(points);
  filter.setLeafSize(leaf, leaf, leaf);
  filter.setSaveLeafLayout(true);
  const Points::Ptr thinned(new Points);
  filter.filter(*thinned);
  const std::vector<std::int32_t> of_leaf = grow(thinned, 10);
  std::vector<std::int32_t> label(cloud.size(), -1);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const int leaf_of_point = filter.getCentroidIndex((*points)[i]);
    if (leaf_of_point >= 0) label[i] = of_leaf[static_cast<std::size_t>(leaf_of_point)];
  }
  return label;
}

std::vector<std::int32_t> planes_by_ransac(const perception::Cloud& cloud) {
  std::vector<std::int32_t> label(cloud.size(), -1);
  Points::Ptr rest = to_pcl(cloud);
  std::vector<std::uint32_t> place(cloud.size());
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = static_cast<std::uint32_t>(i);
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setOptimizeCoefficients(true);
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setMaxIterations(1000);
  segmentation.setDistanceThreshold(0.03);
  for (std::int32_t plane = 0; plane < 60 && rest->size() > cloud.size() / 200; ++plane) {
    pcl::ModelCoefficients coefficients;
    const pcl::PointIndices::Ptr inliers(new pcl::PointIndices);
    segmentation.setInputCloud(rest);
    segmentation.segment(*inliers, coefficients);
    if (inliers->indices.size() < std::max<std::size_t>(50, cloud.size() / 2000)) break;
    std::vector<bool> taken(rest->size(), false);
    for (const auto i : inliers->indices) {
      taken[static_cast<std::size_t>(i)] = true;
      label[place[static_cast<std::size_t>(i)]] = plane;
    }
    const Points::Ptr left(new Points);
    std::vector<std::uint32_t> left_place;
    for (std::size_t i = 0; i < rest->size(); ++i) {
      if (!taken[i]) left->push_back((*rest)[i]), left_place.push_back(place[i]);
    }
    rest = left;
    place = std::move(left_place);
  }
  return label;
}

}  // namespace

std::vector<Segmenter> pcl_segmenters() {
  return {{"PCL region growing, 5 cm voxels", 0, [](const perception::Cloud& c) { return grow_on_voxels(c, 0.05F); }},
          {"PCL region growing, 3 cm voxels", 0, [](const perception::Cloud& c) { return grow_on_voxels(c, 0.03F); }},
          {"PCL region growing, k = 30", 1'000'000, [](const perception::Cloud& c) { return grow(to_pcl(c), 50); }},
          {"PCL RANSAC, plane by plane", 1'000'000, planes_by_ransac}};
}

}  // namespace scenelore::experiment
