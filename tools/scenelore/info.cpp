// `scenelore info`: what is in a point file.
#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::tools {

namespace {

const char* type_name(perception::ScalarType type) {
  using enum perception::ScalarType;
  switch (type) {
    case i8: return "int8";
    case u8: return "uint8";
    case i16: return "int16";
    case u16: return "uint16";
    case i32: return "int32";
    case u32: return "uint32";
    case i64: return "int64";
    case u64: return "uint64";
    case f32: return "float32";
    case f64: return "float64";
  }
  return "?";
}

class InfoCommand : public Command {
 public:
  std::string name() const override { return "info"; }
  std::string summary() const override { return "Show what a scan file holds: properties, points, bounds, sensor positions."; }
  std::string example() const override { return "scenelore info office.ply"; }
  std::vector<Argument> arguments() override {
    return {positional("SCAN", &scan_, "FILE", "point cloud: PLY, PCD or text with x y z"),
            json_argument(json_)};
  }

  int run() override {
    const perception::PointTable points = perception::read_points(scan_);
    const perception::Cloud cloud = perception::to_cloud(points, scan_);
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = -low;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (!cloud.valid(i)) continue;
      low = low.cwiseMin(cloud.position(i));
      high = high.cwiseMax(cloud.position(i));
    }
    if (json_) print_json(points, cloud, low, high);
    else print_text(points, cloud, low, high);
    return kOk;
  }

 private:
  void print_text(const perception::PointTable& points, const perception::Cloud& cloud, const Eigen::Vector3d& low,
                  const Eigen::Vector3d& high) const {
    fmt::print("{}: {} points, {} of them invalid\n", scan_, cloud.size(), cloud.invalid);
    fmt::print("properties:");
    for (const perception::Column& column : points.columns) fmt::print(" {}({})", column.name, type_name(column.type));
    fmt::print("\nbounds: x {:.3f} to {:.3f}, y {:.3f} to {:.3f}, z {:.3f} to {:.3f}\n", low.x(), high.x(), low.y(), high.y(),
               low.z(), high.z());
    print_sensors(cloud);
    for (const std::string& comment : points.comments) fmt::print("comment: {}\n", comment);
  }

  /// Longer lists are for --json.
  static void print_sensors(const perception::Cloud& cloud) {
    constexpr std::size_t kShown = 20;
    const auto& positions = cloud.sensors.positions();
    const std::vector<std::size_t> counts = points_by_sensor(cloud);
    for (std::size_t s = 0; s < std::min(positions.size(), kShown); ++s) {
      fmt::print("sensor at {:.3f} {:.3f} {:.3f}", positions[s].x(), positions[s].y(), positions[s].z());
      fmt::print("{}\n", cloud.sensors.single() ? "" : fmt::format(": {} points", counts[s]));
    }
    if (positions.size() > kShown) fmt::print("sensor at {} more positions (--json lists all)\n", positions.size() - kShown);
    if (cloud.sensors.known() && counts.back() > 0) fmt::print("sensor position unknown: {} points\n", counts.back());
  }

  /// Valid points of each sensor position; at last those whose position is not known.
  static std::vector<std::size_t> points_by_sensor(const perception::Cloud& cloud) {
    std::vector<std::size_t> counts(cloud.sensors.positions().size() + 1, 0);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (cloud.valid(i)) ++counts[cloud.sensors.of_point(i)];
    }
    return counts;
  }

  void print_json(const perception::PointTable& points, const perception::Cloud& cloud, const Eigen::Vector3d& low,
                  const Eigen::Vector3d& high) const {
    using Json = nlohmann::ordered_json;
    Json properties = Json::array();
    for (const perception::Column& column : points.columns) {
      properties.push_back({{"name", column.name}, {"type", type_name(column.type)}});
    }
    const auto vector = [](const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); };
    const std::vector<std::size_t> counts = points_by_sensor(cloud);
    Json sensors = Json::array();
    for (std::size_t s = 0; s + 1 < counts.size(); ++s) {
      sensors.push_back({{"position", vector(cloud.sensors.positions()[s])}, {"points", counts[s]}});
    }
    const Json out{{"file", scan_},
                   {"points", cloud.size()},
                   {"invalid", cloud.invalid},
                   {"properties", std::move(properties)},
                   {"low", vector(low)},
                   {"high", vector(high)},
                   {"viewpoint", cloud.sensors.single() ? vector(cloud.sensors.positions().front()) : Json(nullptr)},
                   {"sensors", std::move(sensors)},
                   {"points_without_sensor", counts.back()},
                   {"comments", points.comments}};
    fmt::print("{}\n", out.dump(2, ' ', false, Json::error_handler_t::replace));
  }

  std::string scan_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> info_command() { return std::make_unique<InfoCommand>(); }

}  // namespace scenelore::tools
