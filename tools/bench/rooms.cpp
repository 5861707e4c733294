#include "bench/rooms.hpp"

#include <atomic>
#include <thread>

#include "scenelore/perception/perceive.hpp"

namespace scenelore::experiment {

namespace {

Room perceive_room(const simulator::SimulationOptions& options) {
  Room room;
  room.scan = simulator::simulate(options);
  const perception::Cloud cloud = perception::to_cloud(room.scan.points, "simulated room");
  const perception::Perception seen = perception::perceive(cloud, {.threads = 1});
  room.record = {.name = "room", .rotation = seen.upright.rotation, .floor_z = seen.upright.floor_z};
  for (std::size_t i = 0; i < seen.planes.size(); ++i) room.planes.push_back({static_cast<kb::PlaneId>(i + 1), seen.planes[i]});
  room.truth = plane_truth(room.scan, seen.plane_of_point, seen.planes.size());
  room.scan.points.bytes = {};  // the points are not needed any more, and a hundred rooms of them fill the memory
  return room;
}

}  // namespace

std::vector<Room> perceive_rooms(const std::vector<simulator::SimulationOptions>& rooms, int threads) {
  std::vector<Room> out(rooms.size());
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> workers;
  for (int t = 0; t < threads; ++t) {
    workers.emplace_back([&] {
      for (std::size_t i = next++; i < rooms.size(); i = next++) out[i] = perceive_room(rooms[i]);
    });
  }
  workers.clear();
  return out;
}

}  // namespace scenelore::experiment
