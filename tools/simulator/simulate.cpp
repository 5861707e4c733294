#include "simulator/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "simulator/faces.hpp"
#include "simulator/poses.hpp"

namespace scenelore::simulator {
namespace {

void check(const SimulationOptions& options) {
  const auto sensible = [](double value) { return std::isfinite(value) && value >= 0; };
  if (!sensible(options.noise))
    throw std::invalid_argument("simulate: noise must be a finite number of metres, not negative");
  if (!sensible(options.material_bias))
    throw std::invalid_argument("simulate: material_bias must be a finite number of metres, not negative");
  if (!std::isfinite(options.tilt_deg)) throw std::invalid_argument("simulate: tilt_deg must be finite");
  if (options.poses < 1 || options.poses > 8) throw std::invalid_argument("simulate: poses must be 1 to 8");
  if (options.points > 50'000'000) throw std::invalid_argument("simulate: points must be at most 50 million");
}

// The cloud's frame: the floor's level is 0, the origin below the first pose, x its heading; then tilted, if wanted.
Eigen::Isometry3d cloud_from_room(const SensorPose& first, const SimulationOptions& options) {
  Random random(options.seed, 3000);
  const double about = random.between(0, 2 * std::numbers::pi);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.rotate(
      Eigen::AngleAxisd(options.tilt_deg * std::numbers::pi / 180, Vector3d(std::cos(about), std::sin(about), 0)));
  frame.rotate(Eigen::AngleAxisd(-first.heading, Vector3d::UnitZ()));
  frame.translate(-Vector3d(first.position.x(), first.position.y(), 0));
  return frame;
}

/// What was measured from one pose.
struct PoseScan {
  Vector3d position;
  std::vector<Sample> samples;
};

/// Of several poses each point says from where it was measured.
perception::PointTable make_table(const std::vector<PoseScan>& scans, const std::vector<Object>& objects,
                                  const Eigen::Isometry3d& frame) {
  using perception::ScalarType;
  perception::PointTable table;
  table.columns = {{"x", ScalarType::f32, 0},
                   {"y", ScalarType::f32, 4},
                   {"z", ScalarType::f32, 8},
                   {"label", ScalarType::i32, 12},
                   {"instance", ScalarType::i32, 16}};
  table.stride = 20;
  const bool several = scans.size() > 1;
  for (const char* name : {"vp_x", "vp_y", "vp_z"}) {
    if (!several) break;
    table.columns.push_back({name, ScalarType::f32, table.stride});
    table.stride += 4;
  }
  for (const PoseScan& scan : scans) table.rows += scan.samples.size();
  table.bytes.resize(table.stride * table.rows);
  std::byte* row = table.bytes.data();
  for (const PoseScan& scan : scans) {
    const Eigen::Vector3f sensor = (frame * scan.position).cast<float>();
    for (const Sample& sample : scan.samples) {
      const Eigen::Vector3f point = (frame * sample.point).cast<float>();
      const std::int32_t truth[2] = {
          sample.object < 0 ? 0
                            : static_cast<std::int32_t>(objects[static_cast<std::size_t>(sample.object)].object_class),
          sample.object + 1};
      std::memcpy(row, point.data(), 12);
      std::memcpy(row + 12, truth, 8);
      if (several) std::memcpy(row + 20, sensor.data(), 12);
      row += table.stride;
    }
  }
  if (!several) table.viewpoint = frame * scans.front().position;
  return table;
}

std::vector<TruthObject> make_truth(const std::vector<Object>& objects, const std::vector<std::size_t>& counts,
                                    const Eigen::Isometry3d& frame) {
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

/// Faces without visible points keep their numbers.
void tell_faces(const std::vector<PoseScan>& scans, const std::vector<Face>& faces, const Eigen::Isometry3d& frame,
                SimulatedScan& out) {
  for (const Face& face : faces) out.faces.push_back({.normal = frame.linear() * face.normal, .width = face.width});
  out.face_of_point.reserve(out.points.rows);
  for (const PoseScan& scan : scans) {
    for (const Sample& sample : scan.samples) {
      out.face_of_point.push_back(sample.face);
      if (sample.face >= 0) ++out.faces[static_cast<std::size_t>(sample.face)].points;
    }
  }
}

std::vector<double> draw_bias(const SimulationOptions& options, std::size_t objects) {
  std::vector<double> bias(objects);
  for (std::size_t i = 0; i < objects; ++i)
    bias[i] = options.material_bias * Random(options.seed ^ 0xB1A5U, i).normal();
  return bias;
}

}  // namespace

SimulatedScan simulate(const SimulationOptions& options) {
  check(options);
  const Office office =
      make_office(options.seed, options.inventory.value_or(draw_inventory(options.seed, options.room)), options.varied, options.room);
  const std::vector<Object>& objects = office.scene.objects();
  std::vector<Shape> drawn = office.scene.shapes();
  const std::vector<Face> faces = number_faces(drawn);
  const Bvh shapes(std::move(drawn));
  const World world{
      .shapes = shapes, .seed = options.seed, .noise = options.noise, .bias = draw_bias(options, objects.size()), .bends = options.varied};
  const PosePlan planned = plan_poses(office, world, options);
  const double wanted = static_cast<double>(options.points) / options.poses;
  const double scale = options.points == 0 ? 1 : std::sqrt(std::max(planned.points, 1.0) / wanted);
  std::vector<PoseScan> scans;
  std::vector<std::size_t> counts(objects.size(), 0);
  for (const SensorPose& pose : planned.poses) {
    scans.push_back({pose.position, scan(world, pose, options.sensor, scale)});
    const std::vector<std::size_t> more = count_points(scans.back().samples, objects.size());
    std::transform(counts.begin(), counts.end(), more.begin(), counts.begin(), std::plus<>());
  }
  const Eigen::Isometry3d frame = cloud_from_room(planned.poses.front(), options);
  SimulatedScan out{
      .points = make_table(scans, objects, frame), .objects = make_truth(objects, counts, frame), .faces = {}, .face_of_point = {}};
  tell_faces(scans, faces, frame, out);
  return out;
}

}  // namespace scenelore::simulator
