// Segmentation beside the plane finders of PCL and CGAL, on simulated rooms of several densities and on real scans: time,
// memory, planes found. `make segmentation_bench` builds and runs it with the peers that are installed.
// Each method runs in a process of its own on a binary PLY file; its CPU time and memory are those of that process, from
// the file to the planes. All read the file in the same way.
#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <map>

#include "bench/segmentation_scores.hpp"
#include "bench/segmenters.hpp"
#include "scenelore/perception/memory.hpp"
#include "scenelore/perception/perceive.hpp"
#include "scenelore/perception/segment.hpp"

namespace {

using namespace scenelore;
using experiment::InstanceScore;
using experiment::SegmentationScore;
using experiment::Segmenter;
namespace fs = std::filesystem;

struct Options {
  std::uint64_t seed = 7101;
  std::size_t rooms = 3;
  std::vector<std::size_t> points{100'000, 500'000, 2'000'000, 5'000'000};
  std::vector<std::string> only;
  fs::path scans;
};

/// What one run cost; nothing of it counts when it failed.
struct Run {
  bool done = false;
  double cpu = 0, wall = 0, reading = 0;  ///< seconds
  double memory = 0;                      ///< bytes at the most, of the process beyond what it began with
  std::vector<std::int32_t> label;
};

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }
double cpu_now() {
  timespec t{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double resident() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// In a child process, which hands its labels over in shared memory: two numbers (reading time, memory), then the labels.
Run run_alone(const Segmenter& method, const fs::path& file, std::size_t points) {
  Run run;
  const std::size_t bytes = 2 * sizeof(double) + points * sizeof(std::int32_t);
  void* const shared = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return run;
  const double start = seconds_now();
  const pid_t child = ::fork();
  if (child == 0) {
    if (method.name.starts_with("Scenelore")) perception::keep_memory(perception::Work::perception);  // as the program's commands do
    const double before = resident(), began = seconds_now();
    const perception::Cloud cloud = perception::read_cloud(file);
    const double reading = seconds_now() - began;
    const std::vector<std::int32_t> label = method.segment(cloud);
    const double numbers[] = {reading, resident() - before};
    std::memcpy(shared, numbers, sizeof numbers);
    std::memcpy(static_cast<std::byte*>(shared) + sizeof numbers, label.data(), points * sizeof(std::int32_t));
    ::_exit(0);
  }
  int status = 0;
  rusage usage{};
  if (child > 0 && ::wait4(child, &status, 0, &usage) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    run.done = true;
    run.wall = seconds_now() - start;
    run.cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    double numbers[2];
    std::memcpy(numbers, shared, sizeof numbers);
    run.reading = numbers[0], run.memory = numbers[1];
    run.label.resize(points);
    std::memcpy(run.label.data(), static_cast<std::byte*>(shared) + sizeof numbers, points * sizeof(std::int32_t));
  }
  ::munmap(shared, bytes);
  return run;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

double share(int part, int whole) { return whole == 0 ? 0 : static_cast<double>(part) / whole; }

/// One method over the rooms of one density, or over the real scans.
struct Row {
  std::vector<double> cpu, wall, reading, memory;

  void add(const Run& run, double bytes) {
    cpu.push_back(run.cpu), wall.push_back(run.wall), reading.push_back(run.reading), memory.push_back(run.memory / bytes);
  }
};

/// A file of x, y and z alone, and of where the sensor stood.
void write_geometry(const fs::path& file, const simulator::SimulatedScan& scan) {
  perception::PointTable table;
  table.rows = scan.points.rows;
  table.viewpoint = scan.points.viewpoint;
  for (const char* name : {"x", "y", "z", "vp_x", "vp_y", "vp_z"}) {
    const perception::Column* const column = scan.points.find(name);
    if (column == nullptr) continue;
    std::vector<float> values(table.rows);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(scan.points.value(*column, i));
    table.set_column(name, values);
  }
  perception::write_points(file, table);
}

std::vector<Segmenter> methods(const std::vector<std::string>& only) {
  std::vector<Segmenter> all{{"Scenelore, planes and features", 0, [](const perception::Cloud& c) { return perception::perceive(c).plane_of_point; }},
                             {"Scenelore, planes alone", 0, [](const perception::Cloud& c) { return perception::segment(c, {}, 2).plane_of_point; }}};
#ifdef SCENELORE_WITH_PCL
  for (Segmenter& peer : experiment::pcl_segmenters()) all.push_back(std::move(peer));
#endif
#ifdef SCENELORE_WITH_CGAL_PEERS
  for (Segmenter& peer : experiment::cgal_segmenters()) all.push_back(std::move(peer));
#endif
  const auto unwanted = [&](const Segmenter& method) {
    return !only.empty() && std::none_of(only.begin(), only.end(), [&](const std::string& part) { return method.name.find(part) != std::string::npos; });
  };
  std::erase_if(all, unwanted);
  return all;
}

/// CPU and wall time of the stages of our own pipeline, in this process.
class Stages {
 public:
  void run(const fs::path& file) {
    perception::PerceptionOptions options;
    options.on_stage = [this](std::string_view stage) { begin(std::string(stage)); };
    begin("reading");
    const perception::Cloud cloud = perception::read_cloud(file);
    const perception::Perception result = perception::perceive(cloud, options);
    begin("");
  }
  void print() const {
    fmt::print("\n| stage | CPU s | wall s |\n| --- | --- | --- |\n");
    for (const std::string& stage : order_) fmt::print("| {} | {:.3f} | {:.3f} |\n", stage, median(cpu_.at(stage)), median(wall_.at(stage)));
  }

 private:
  /// Times of a stage that comes several times in one run add up.
  void begin(const std::string& stage) {
    const double cpu = cpu_now(), wall = seconds_now();
    if (!now_.empty()) {
      sum_[now_].first += cpu - cpu_began_;
      sum_[now_].second += wall - wall_began_;
      if (std::find(order_.begin(), order_.end(), now_) == order_.end()) order_.push_back(now_);
    }
    if (stage.empty()) {
      for (const auto& [name, times] : sum_) cpu_[name].push_back(times.first), wall_[name].push_back(times.second);
      sum_.clear();
    }
    now_ = stage, cpu_began_ = cpu, wall_began_ = wall;
  }

  std::string now_;
  double cpu_began_ = 0, wall_began_ = 0;
  std::map<std::string, std::pair<double, double>> sum_;
  std::map<std::string, std::vector<double>> cpu_, wall_;
  std::vector<std::string> order_;
};

void bench_rooms(const Options& options, std::size_t points, const fs::path& folder) {
  const std::vector<Segmenter> all = methods(options.only);
  std::vector<Row> rows(all.size());
  std::vector<SegmentationScore> scores(all.size());
  Stages stages;
  std::vector<simulator::SimulationOptions> rooms = simulator::paper_rooms(options.seed);
  rooms.resize(std::min(options.rooms, rooms.size()));
  for (simulator::SimulationOptions& room : rooms) {
    room.points = points;
    const simulator::SimulatedScan scan = simulator::simulate(room);
    const fs::path file = folder / "room.ply";
    write_geometry(file, scan);
    const auto bytes = static_cast<double>(fs::file_size(file));
    const perception::Cloud cloud = perception::to_cloud(scan.points, "room");
    for (std::size_t m = 0; m < all.size(); ++m) {
      if (all[m].most_points > 0 && points > all[m].most_points) continue;
      const Run run = run_alone(all[m], file, cloud.size());
      if (!run.done) {
        fmt::print(stderr, "{} did not end on a room of {} points\n", all[m].name, cloud.size());
        continue;
      }
      rows[m].add(run, bytes);
      scores[m] += experiment::score_segmentation(scan, cloud, run.label);
    }
    stages.run(file);
  }
  fmt::print("\n{} rooms of {} points (seed {}); medians, memory in bytes a byte of the file\n\n", rooms.size(), points, options.seed);
  fmt::print("| method | CPU s | wall s | reading s | memory | precision | recall 0.5 | recall 0.8 | split | joined | keyboards | normals ° |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (std::size_t m = 0; m < all.size(); ++m) {
    const SegmentationScore& s = scores[m];
    if (rows[m].cpu.empty()) continue;
    fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {}/{} | {:.2f} |\n", all[m].name,
               median(rows[m].cpu), median(rows[m].wall), median(rows[m].reading), median(rows[m].memory), share(s.right, s.planes),
               share(s.found, s.faces), share(s.well, s.faces), share(s.split, s.faces), share(s.joined, s.planes), s.keyboards_found,
               s.keyboards, median(s.normal_errors));
  }
  stages.print();
  std::fflush(stdout);
}

std::vector<fs::path> scans_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".ply") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void bench_scans(const Options& options) {
  const std::vector<Segmenter> all = methods(options.only);
  for (const fs::path& file : scans_below(options.scans)) {
    const perception::PointTable table = perception::read_points(file);
    fmt::print("\n{}, {} points\n\n| method | CPU s | wall s | memory | planes | instances found at 0.5 | at 0.8 |\n", file.stem().string(), table.rows);
    fmt::print("| --- | --- | --- | --- | --- | --- | --- |\n");
    for (const Segmenter& method : all) {
      const Run run = run_alone(method, file, table.rows);
      if (!run.done) {
        fmt::print(stderr, "{} did not end on {}\n", method.name, file.string());
        continue;
      }
      const InstanceScore score = experiment::score_instances(table, run.label);
      fmt::print("| {} | {:.3f} | {:.3f} | {:.1f} | {} | {}/{} | {}/{} |\n", method.name, run.cpu, run.wall,
                 run.memory / static_cast<double>(fs::file_size(file)), score.planes, score.found, score.instances, score.well, score.instances);
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  CLI::App app{"Segmentation beside PCL and CGAL."};
  app.add_option("--seed", options.seed, "set of paper-like rooms")->capture_default_str();
  app.add_option("--rooms", options.rooms, "how many of the set's six")->capture_default_str();
  app.add_option("--points", options.points, "sizes of the clouds")->capture_default_str();
  app.add_option("--only", options.only, "methods with this in their names");
  app.add_option("--scans", options.scans, "scans below this folder instead of simulated rooms")->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, count, arguments);
  if (!options.scans.empty()) {
    bench_scans(options);
    return 0;
  }
  const fs::path folder = fs::temp_directory_path() / ("segmentation_bench_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  for (const std::size_t points : options.points) bench_rooms(options, points, folder);
  fs::remove_all(folder);
  return 0;
}
