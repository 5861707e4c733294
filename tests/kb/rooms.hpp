// Small made-up rooms and files for the tests of kb.
#pragma once

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenelore/kb/knowledge_base.hpp"
#include "temporary_folder.hpp"

namespace scenelore::kb::testing {

using test::TemporaryFolder;

/// A level or upright rectangle of the given sides about a centre.
inline perception::Plane rectangle(const Eigen::Vector3d& centre, const Eigen::Vector3d& along, const Eigen::Vector3d& across,
                                   std::size_t points) {
  perception::Plane plane;
  plane.centroid = centre;
  plane.normal = along.cross(across).normalized();
  Eigen::Matrix3d axes;
  axes << across.normalized(), along.normalized(), across.normalized().cross(along.normalized());
  plane.orientation = Eigen::Quaterniond(axes);
  plane.hull.outer = {centre - along / 2 - across / 2, centre + along / 2 - across / 2, centre + along / 2 + across / 2,
                      centre - along / 2 + across / 2};
  plane.length = along.norm();
  plane.width = across.norm();
  plane.area_m2 = plane.length * plane.width;
  plane.rectangularity = 1;
  plane.tilt_deg = std::acos(std::min(1.0, std::abs(plane.normal.z()))) * 57.29577951308232;
  plane.height = centre.z();
  plane.z_min = plane.z_max = centre.z();
  for (const Eigen::Vector3d& corner : plane.hull.outer) {
    plane.z_min = std::min(plane.z_min, corner.z());
    plane.z_max = std::max(plane.z_max, corner.z());
  }
  plane.rmse = 0.01;
  plane.facing_up = plane.normal.z();
  plane.point_density = static_cast<double>(points) / plane.area_m2;
  plane.seen_share = 0.9;
  if (plane.tilt_deg < 45) plane.behind = 0.25;  // not known of the others
  plane.edge_free = 0.5;
  plane.edge_joined = 0.25;
  plane.edge_unseen = 0.125;
  if (plane.tilt_deg > 45) plane.edge_free_top = 0.75;
  plane.point_count = points;
  return plane;
}

/// Floor, a wall, a table (with a hole in its hull) and a screen; 100 points each and 50 that belong to no plane.
struct Room {
  Scan scan;
  std::vector<perception::Plane> planes;
  std::vector<std::int32_t> plane_of_point;
};

inline Room room(const std::string& name = "room") {
  Room room;
  room.planes = {rectangle({2, 1.5, 0}, {4, 0, 0}, {0, 3, 0}, 100), rectangle({2, 3, 1.3}, {4, 0, 0}, {0, 0, 2.6}, 100),
                 rectangle({1, 1, 0.72}, {1.4, 0, 0}, {0, 0.8, 0}, 100), rectangle({1, 1.2, 1.0}, {0.5, 0, 0}, {0, 0, 0.3}, 100)};
  room.planes[2].hull.holes = {{{0.9, 0.9, 0.72}, {0.9, 1.1, 0.72}, {1.1, 1.1, 0.72}, {1.1, 0.9, 0.72}}};
  for (std::int32_t number = 0; number < 4; ++number) room.plane_of_point.insert(room.plane_of_point.end(), 100, number);
  room.plane_of_point.insert(room.plane_of_point.end(), 50, -1);
  room.scan = {.name = name, .source = name + ".ply", .sha256 = std::string(64, 'a'), .point_count = 450,
               .parameters = "{\"min_points\": 20}", .imported_at = "2026-01-01T00:00:00Z"};
  return room;
}

/// An answer about stored planes: the first classes of the office in turn.
inline Inference inference(const std::vector<StoredPlane>& planes) {
  static const std::vector<std::string> kClasses = {"floor", "wall", "table", "flat_screen", "keyboard"};
  Inference result;
  result.run = {.outcome = "proved", .cost = 1.5, .lower_bound = 1.5, .nodes = 7, .seconds = 0.25,
                .knowledge_hash = "k", .rules_hash = "r", .engine_version = "1"};
  result.classes = kClasses;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const std::string& best = kClasses[p % kClasses.size()];
    result.planes.push_back(planes[p].id);
    std::vector<double>& row = result.evidence.emplace_back(kClasses.size(), 0.05);
    row[p % kClasses.size()] = 0.8;
    result.labels.push_back({planes[p].id, best, 0.9, 1.0 + static_cast<double>(p), "unknown"});
    result.reasons.push_back({planes[p].id, best, "evidence", std::nullopt, std::nullopt, 1.25, "it looks like it"});
  }
  for (std::size_t a = 0; a + 1 < planes.size(); ++a) {
    result.facts.push_back({"near", planes[a].id, planes[a + 1].id, 0.5});
  }
  if (planes.size() > 3) {
    result.facts.push_back({"above", planes[3].id, planes[2].id, 1.0});
    result.alternatives.push_back({2, planes[3].id, "unknown"});
    result.reasons.push_back({planes[3].id, "flat_screen", "support", "screen_over_table", planes[2].id, 2.5, "over a table"});
  }
  return result;
}

/// All rows of a query, values joined with '|', NULL as an empty value.
inline std::vector<std::string> ask(const KnowledgeBase& base, const std::string& sql) {
  std::vector<std::string> lines;
  base.query(sql, [](const auto&) {}, [&](const QueryRow& row) {
    std::string line;
    for (std::size_t i = 0; i < row.values.size(); ++i) line += (i == 0 ? "" : "|") + row.values[i].value_or("");
    lines.push_back(line);
  });
  return lines;
}

/// The text of the Error that `action` throws; a failure when it throws none.
template <typename Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

}  // namespace scenelore::kb::testing
