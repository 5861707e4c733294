// `scenelore simulate`: a scan of a furnished room with ground truth.
#include <fmt/core.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "pipeline/text_file.hpp"
#include "simulator/simulate.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

using Json = nlohmann::ordered_json;

std::string truth_json(const simulator::SimulatedScan& scan) {
  const auto vector = [](const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); };
  Json objects = Json::array();
  for (const simulator::TruthObject& object : scan.objects) {
    objects.push_back({{"instance", object.instance},
                       {"class", object.object_class},
                       {"thing", object.thing},
                       {"planar", object.planar},
                       {"centroid", vector(object.centroid)},
                       {"normal", vector(object.normal)},
                       {"area_m2", object.area_m2},
                       {"points", object.points}});
  }
  return Json{{"objects", std::move(objects)}}.dump(1) + "\n";
}

class SimulateCommand : public Command {
 public:
  std::string name() const override { return "simulate"; }
  std::string summary() const override { return "Make a scan of a furnished office with ground truth per point and per object."; }
  std::string example() const override { return "scenelore simulate office.ply --seed 11"; }
  std::vector<Argument> arguments() override {
    return {positional("OUT", &out_, "FILE", "point cloud to write (.ply, .pcd, .csv); the truth goes to OUT's name with .truth.json"),
            {"--seed", &options_.seed, "N", "which room; the same seed gives the same bytes", Effect::result},
            {"--room", &room_, "NAME", "office, home or kitchen (the classes of the packs of `kb add`)", Effect::result},
            {"--sensor", &sensor_, "NAME", "lidar (tilting line scanner) or depth_camera", Effect::result},
            {"--noise", &options_.noise, "m", "standard deviation of a range", Effect::result, 0, 1},
            {"--material-bias", &options_.material_bias, "m", "standard deviation of a range error that is constant per object",
             Effect::result, 0, 1},
            {"--poses", &options_.poses, "N", "sensor positions whose clouds are merged; each point tells its own (vp_x vp_y vp_z)", Effect::result, 1, 8},
            {"--points", &points_, "N", "wanted number of points (default: the sensor's own resolution)", Effect::result, 100, 1e8},
            {"--tilt", &options_.tilt_deg, "deg", "tilt the whole cloud by this much", Effect::result, 0, 180},
            {"--varied", &options_.varied, "", "sizes far beyond the usual office's; a depth camera bends planes", Effect::result},
            {"--paper-room", &paper_room_, "1..6", "a room of the paper-like set of this seed", Effect::result, 1, 6}};
  }

  int run() override {
    if (sensor_ != "lidar" && sensor_ != "depth_camera") {
      throw UsageError("--sensor '" + sensor_ + "' is unknown; there are lidar and depth_camera");
    }
    if (room_ != "office" && room_ != "home" && room_ != "kitchen") {
      throw UsageError("--room '" + room_ + "' is unknown; there are office, home and kitchen");
    }
    if (paper_room_ && room_ != "office") throw UsageError("--paper-room is an office");
    simulator::SimulationOptions options = options_;
    options.room = room_ == "home" ? simulator::RoomKind::home : room_ == "kitchen" ? simulator::RoomKind::kitchen : simulator::RoomKind::office;
    if (paper_room_) {
      options = simulator::paper_rooms(options_.seed, options_.noise).at(static_cast<std::size_t>(*paper_room_ - 1));
      options.material_bias = options_.material_bias;
      options.tilt_deg = options_.tilt_deg;
    }
    options.sensor = sensor_ == "lidar" ? simulator::Sensor::lidar : simulator::Sensor::depth_camera;
    if (points_) options.points = static_cast<std::size_t>(*points_);
    terminal_progress(out_)("simulating");
    const simulator::SimulatedScan scan = simulator::simulate(options);
    const std::filesystem::path truth = std::filesystem::path(out_).replace_extension(".truth.json");
    perception::write_points(out_, scan.points);
    pipeline::write_text_file(truth, truth_json(scan));
    fmt::print("{}: {} points\n{}: {} objects\n", out_, scan.points.rows, truth.string(), scan.objects.size());
    return kOk;
  }

 private:
  std::string out_;
  simulator::SimulationOptions options_;
  std::string sensor_ = "lidar", room_ = "office";
  std::optional<int> points_;
  std::optional<int> paper_room_;
};

}  // namespace

std::unique_ptr<Command> simulate_command() { return std::make_unique<SimulateCommand>(); }

}  // namespace scenelore::tools
