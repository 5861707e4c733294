// Simulated scans of furnished rooms with ground truth: test data, demo, and the source of the learned priors.
//
//   SimulatedScan scan = simulate({.seed = 7});
//   perception::write_points("office.ply", scan.points);   // columns x y z label instance
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenelore/perception/point_table.hpp"

namespace scenelore::simulator {

enum class Sensor {
  lidar,        ///< tilting line scanner like the Hokuyo UTM-30LX: 0.25 degrees, 270 degrees, one pose after another
  depth_camera  ///< 640×480, 57°×43°, noise growing with z²
};

enum class RoomKind {
  office,
  home,    ///< a table, sofas, a bed, radiators: classes of the knowledge pack home
  kitchen  ///< a table, a counter over cabinets, a stove, a fridge, cupboards on the wall: of the pack kitchen
};

/// How many objects of the paper's three classes a room has; drawn from the seed when not set.
struct Inventory {
  int tables = 0, screens = 0, keyboards = 0;
};

struct SimulationOptions {
  std::uint64_t seed = 1;
  RoomKind room = RoomKind::office;
  std::optional<Inventory> inventory;
  Sensor sensor = Sensor::lidar;
  double noise = 0.01;         ///< metres, standard deviation of the range; of a depth camera: of the depth at 3 m
  double material_bias = 0;    ///< metres, standard deviation of a constant range error per object
  int poses = 1;               ///< sensor positions, clouds merged; each point tells its own when there are several
  std::size_t points = 0;      ///< wanted number of points (angular steps adapt); 0 = the sensor's own resolution
  double tilt_deg = 0;         ///< the whole cloud tilted by this much, about a seeded horizontal axis
  bool varied = false;         ///< sizes far beyond the usual office's, and a depth camera that bends planes
};

/// One planar face (or curved thing) of the room: what a label is about.
struct TruthObject {
  int instance = 0;            ///< value of the `instance` column; > 0
  std::string object_class;    ///< name as in the default knowledge; "unknown" for distractors and unclassed faces
  std::string thing;           ///< what it belongs to: "desk 2", "chair 1", "plant 3"
  bool planar = true;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the face itself, not of its visible points; in the cloud's frame
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< zero when not planar
  double area_m2 = 0;          ///< of the face itself
  std::size_t points = 0;      ///< visible points
};

/// One planar face as geometry has it, whatever objects its parts belong to: coplanar things that touch are one (faces.hpp).
struct TruthFace {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< in the cloud's frame
  double width = 0;            ///< metres, shorter side of its widest part
  std::size_t points = 0;      ///< visible points
};

struct SimulatedScan {
  /// x y z (float), label (int, class id of the default knowledge, 0 = mixed pixel), instance (int); where the sensor stood is the table's
  /// viewpoint, of several poses vp_x vp_y vp_z (float) of each point.
  perception::PointTable points;
  std::vector<TruthObject> objects;
  std::vector<TruthFace> faces;
  std::vector<std::int32_t> face_of_point;  ///< index in faces, −1 = on a curved thing, or a mixed pixel
};

/// Deterministic: same options, same bytes.
[[nodiscard]] SimulatedScan simulate(const SimulationOptions& options);

/// Options of six rooms like the paper's: 12 tables, 9 screens and 7 keyboards in all, spread by the seed.
[[nodiscard]] std::vector<SimulationOptions> paper_rooms(std::uint64_t seed, double noise = 0.01);

}  // namespace scenelore::simulator
