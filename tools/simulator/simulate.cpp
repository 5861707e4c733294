#include "simulator/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "simulator/office.hpp"
#include "simulator/sensor.hpp"

namespace scenelore::simulator {
namespace {

void check(const SimulationOptions& options) {
  const auto sensible = [](double value) { return std::isfinite(value) && value >= 0; };
  if (!sensible(options.noise)) throw std::invalid_argument("simulate: noise must be a finite number of metres, not negative");
  if (!sensible(options.material_bias)) throw std::invalid_argument("simulate: material_bias must be a finite number of metres, not negative");
  if (!std::isfinite(options.tilt_deg)) throw std::invalid_argument("simulate: tilt_deg must be finite");
  if (options.poses < 1 || options.poses > 8) throw std::invalid_argument("simulate: poses must be 1 to 8");
  if (options.points > 50'000'000) throw std::invalid_argument("simulate: points must be at most 50 million");
}

std::vector<Sample> scan(const World& world, const SensorPose& pose, Sensor sensor, double scale) {
  return sensor == Sensor::lidar ? scan_lidar(world, pose, scale) : scan_depth_camera(world, pose, scale);
}

std::vector<std::size_t> count_points(const std::vector<Sample>& samples, std::size_t objects) {
  std::vector<std::size_t> counts(objects, 0);
  for (const Sample& sample : samples) {
    if (sample.object >= 0) ++counts[static_cast<std::size_t>(sample.object)];
  }
  return counts;
}

// Tables, screens and keyboards count for a place to measure from: the more of them show, the better, with little gain
// from more points of what is seen well anyway.
double worth(const Office& office, const std::vector<std::size_t>& counts) {
  double sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const ObjectClass c = office.scene.objects()[i].object_class;
    const double weight = c == ObjectClass::table ? 0.5 : c == ObjectClass::flat_screen ? 1.5 : c == ObjectClass::keyboard ? 3 : 0.02;
    sum += weight * std::sqrt(std::min(static_cast<double>(counts[i]), 50.0));
  }
  return sum;
}

SensorPose draw_pose(const Office& office, std::size_t stand, Sensor sensor, Random& random) {
  SensorPose pose;
  const Eigen::Vector2d at = office.stands[stand];
  const Eigen::Vector2d to_middle = Eigen::Vector2d(office.width, office.depth) / 2 - at;
  pose.position = Vector3d(at.x(), at.y(), sensor == Sensor::lidar ? random.between(1.1, 1.5) : random.between(1.2, 1.6));
  pose.heading = std::atan2(to_middle.y(), to_middle.x()) + random.normal() * 0.4;
  if (sensor == Sensor::depth_camera && !office.desks.empty()) {  // somebody points it at a desk
    const Desk& desk = office.desks[static_cast<std::size_t>(random.integer(0, static_cast<int>(office.desks.size()) - 1))];
    const Eigen::Vector2d to = desk.frame.translation().head<2>() - at;
    pose.heading = std::atan2(to.y(), to.x()) + random.normal() * 0.1;
  }
  if (sensor == Sensor::depth_camera) pose.pitch = random.between(12, 28) * std::numbers::pi / 180;
  return pose;
}

struct Planned {
  std::vector<SensorPose> poses;
  double share = 1;  ///< points a pose at scale 1, estimated
};

// Poses one after another, each the best of a few drawn ones given the poses before it, judged by a coarse scan.
Planned plan_poses(const Office& office, const World& world, const SimulationOptions& options) {
  constexpr double coarse = 5;
  Random random(options.seed, 2000);
  Planned planned;
  std::vector<std::size_t> seen(office.scene.objects().size(), 0);
  std::size_t total = 0;
  for (int number = 0; number < options.poses; ++number) {
    double best = -1;
    SensorPose chosen;
    std::vector<std::size_t> chosen_counts;
    for (int candidate = 0; candidate < 5; ++candidate) {
      const auto stand = static_cast<std::size_t>(random.integer(0, static_cast<int>(office.stands.size()) - 1));
      SensorPose pose = draw_pose(office, stand, options.sensor, random);
      pose.number = number;
      std::vector<std::size_t> counts = count_points(scan(world, pose, options.sensor, coarse), seen.size());
      for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += seen[i];
      const double value = worth(office, counts);
      if (value <= best) continue;
      best = value;
      chosen = pose;
      chosen_counts = std::move(counts);
    }
    planned.poses.push_back(chosen);
    seen = std::move(chosen_counts);
  }
  total = std::accumulate(seen.begin(), seen.end(), std::size_t{0});
  planned.share = static_cast<double>(total) * coarse * coarse / options.poses;
  return planned;
}

// The cloud's frame: the floor's level is 0, the origin below the first pose, x its heading; then tilted, if wanted.
Eigen::Isometry3d cloud_from_room(const SensorPose& first, const SimulationOptions& options) {
  Random random(options.seed, 3000);
  const double about = random.between(0, 2 * std::numbers::pi);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.rotate(Eigen::AngleAxisd(options.tilt_deg * std::numbers::pi / 180, Vector3d(std::cos(about), std::sin(about), 0)));
  frame.rotate(Eigen::AngleAxisd(-first.heading, Vector3d::UnitZ()));
  frame.translate(-Vector3d(first.position.x(), first.position.y(), 0));
  return frame;
}

perception::PointTable make_table(const std::vector<Sample>& samples, const std::vector<Object>& objects, const Eigen::Isometry3d& frame) {
  using perception::ScalarType;
  perception::PointTable table;
  table.columns = {{"x", ScalarType::f32, 0}, {"y", ScalarType::f32, 4}, {"z", ScalarType::f32, 8}, {"label", ScalarType::i32, 12}, {"instance", ScalarType::i32, 16}};
  table.stride = 20;
  table.rows = samples.size();
  table.bytes.resize(table.stride * table.rows);
  std::byte* row = table.bytes.data();
  for (const Sample& sample : samples) {
    const Eigen::Vector3f point = (frame * sample.point).cast<float>();
    const std::int32_t truth[2] = {sample.object < 0 ? 0 : static_cast<std::int32_t>(objects[static_cast<std::size_t>(sample.object)].object_class), sample.object + 1};
    std::memcpy(row, point.data(), 12);
    std::memcpy(row + 12, truth, 8);
    row += table.stride;
  }
  return table;
}

std::vector<TruthObject> make_truth(const std::vector<Object>& objects, const std::vector<std::size_t>& counts, const Eigen::Isometry3d& frame) {
  std::vector<TruthObject> truth;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Object& object = objects[i];
    TruthObject t;
    t.instance = static_cast<int>(i) + 1;
    t.object_class = name_of(object.object_class);
    t.thing = object.thing;
    t.planar = object.planar;
    t.centroid = frame * object.centroid;
    t.normal = frame.linear() * object.normal;
    t.area_m2 = object.area;
    t.points = counts[i];
    truth.push_back(std::move(t));
  }
  return truth;
}

std::vector<double> draw_bias(const SimulationOptions& options, std::size_t objects) {
  std::vector<double> bias(objects);
  for (std::size_t i = 0; i < objects; ++i) bias[i] = options.material_bias * Random(options.seed ^ 0xB1A5U, i).normal();
  return bias;
}

}  // namespace

SimulatedScan simulate(const SimulationOptions& options) {
  check(options);
  const Office office = make_office(options.seed, options.inventory.value_or(draw_inventory(options.seed)));
  const std::vector<Object>& objects = office.scene.objects();
  const Bvh shapes(office.scene.shapes());
  const World world{shapes, options.seed, options.noise, draw_bias(options, objects.size())};
  const Planned planned = plan_poses(office, world, options);
  const double wanted = static_cast<double>(options.points) / options.poses;
  const double scale = options.points == 0 ? 1 : std::sqrt(std::max(planned.share, 1.0) / wanted);
  std::vector<Sample> samples;
  for (const SensorPose& pose : planned.poses) {
    const std::vector<Sample> more = scan(world, pose, options.sensor, scale);
    samples.insert(samples.end(), more.begin(), more.end());
  }
  const Eigen::Isometry3d frame = cloud_from_room(planned.poses.front(), options);
  SimulatedScan result{make_table(samples, objects, frame), make_truth(objects, count_points(samples, objects.size()), frame)};
  if (options.poses == 1) result.points.viewpoint = frame * planned.poses.front().position;
  return result;
}

}  // namespace scenelore::simulator
