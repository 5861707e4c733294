// Segmentation beside the plane finders of PCL and CGAL, on simulated rooms of several densities: time, memory, planes
// found. Usage: segmentation_bench [SEED [ROOMS [POINTS...]]]; `make segmentation_bench` builds it with the peers that are installed.
// Each method runs in a process of its own on a binary PLY file of the room; its CPU time and memory are those of that
// process, from the file to the planes. All read the file in the same way.
#include <fmt/core.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "bench/segmentation_scores.hpp"
#include "bench/segmenters.hpp"
#include "scenelore/perception/perceive.hpp"

namespace {

using namespace scenelore;
using experiment::SegmentationScore;
using experiment::Segmenter;
namespace fs = std::filesystem;

/// What one run cost; nothing of it counts when it failed.
struct Run {
  bool done = false;
  double cpu = 0, wall = 0, reading = 0;  ///< seconds
  double memory = 0;                      ///< bytes at the most, of the process beyond what it began with
  std::vector<std::int32_t> label;
};

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

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

/// One method over the rooms of one density.
struct Row {
  std::vector<double> cpu, wall, reading, memory;
  SegmentationScore score;
};

void print(const std::string& name, Row& row) {
  if (row.cpu.empty()) return;
  const SegmentationScore& s = row.score;
  fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {}/{} | {:.2f} |\n", name, median(row.cpu),
             median(row.wall), median(row.reading), median(row.memory), share(s.right, s.planes), share(s.found, s.faces), share(s.well, s.faces),
             share(s.split, s.faces), share(s.joined, s.planes), s.keyboards_found, s.keyboards, median(s.normal_errors));
  std::fflush(stdout);
}

/// A file of x, y and z alone.
void write_geometry(const fs::path& file, const simulator::SimulatedScan& scan) {
  perception::PointTable table;
  table.rows = scan.points.rows;
  table.viewpoint = scan.points.viewpoint;
  for (const char* axis : {"x", "y", "z"}) {
    const perception::Column& column = *scan.points.find(axis);
    std::vector<float> values(table.rows);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(scan.points.value(column, i));
    table.set_column(axis, values);
  }
  perception::write_points(file, table);
}

std::vector<Segmenter> methods() {
  std::vector<Segmenter> all{{"Scenelore, planes and features", 0, [](const perception::Cloud& c) { return perception::perceive(c).plane_of_point; }}};
#ifdef SCENELORE_WITH_PCL
  for (Segmenter& peer : experiment::pcl_segmenters()) all.push_back(std::move(peer));
#endif
#ifdef SCENELORE_WITH_CGAL_PEERS
  for (Segmenter& peer : experiment::cgal_segmenters()) all.push_back(std::move(peer));
#endif
  return all;
}

void bench(std::uint64_t seed, std::size_t rooms, std::size_t points, const fs::path& folder) {
  const std::vector<Segmenter> all = methods();
  std::vector<Row> rows(all.size());
  std::vector<simulator::SimulationOptions> options = simulator::paper_rooms(seed);
  options.resize(std::min(rooms, options.size()));
  for (simulator::SimulationOptions& room : options) {
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
      rows[m].cpu.push_back(run.cpu), rows[m].wall.push_back(run.wall), rows[m].reading.push_back(run.reading);
      rows[m].memory.push_back(run.memory / bytes);
      rows[m].score += experiment::score_segmentation(scan, cloud, run.label);
    }
  }
  fmt::print("\n{} rooms of {} points (seed {}); medians, memory in bytes a byte of the file\n\n", options.size(), points, seed);
  fmt::print("| method | CPU s | wall s | reading s | memory | precision | recall 0.5 | recall 0.8 | split | joined | keyboards | normals ° |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (std::size_t m = 0; m < all.size(); ++m) print(all[m].name, rows[m]);
}

}  // namespace

int main(int count, char** arguments) {
  const auto number = [&](int index, std::size_t otherwise) { return count > index ? std::strtoul(arguments[index], nullptr, 10) : otherwise; };
  std::vector<std::size_t> sizes;
  for (int i = 3; i < count; ++i) sizes.push_back(number(i, 0));
  if (sizes.empty()) sizes = {100'000, 500'000, 2'000'000, 5'000'000};
  const fs::path folder = fs::temp_directory_path() / ("segmentation_bench_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  for (const std::size_t points : sizes) bench(number(1, 7101), number(2, 3), points, folder);
  fs::remove_all(folder);
  return 0;
}
