#include "evaluation/scene_truth.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "evaluation/error.hpp"

namespace scenelore::evaluation {

namespace {

namespace fs = std::filesystem;
using perception::Column;
using perception::PointTable;

const Column* column_of(const PointTable& points, const char* name) {
  const Column* found = points.find(name);
  return found ? found : points.find(std::string("scalar_") + name);
}

/// Right classes of a label; nothing = not judged.
std::vector<std::string> classes_of(int label, const TruthFile& file, const kb::Knowledge& knowledge) {
  const std::string where = file.path.string() + ": ";
  if (!file.map) {
    for (const kb::ObjectClass& c : knowledge.classes) {
      if (c.id == label) return {c.name};
    }
    throw Error(where + fmt::format("label {} is no id in object_class; labels of another collection need --class-map", label));
  }
  if (label == 0) return {};
  const auto name = file.names.find(label);
  if (name == file.names.end()) throw Error(where + fmt::format("label {} has no name in labels.txt", label));
  const auto right = file.map->find(name->second);
  if (right == file.map->end()) throw Error(where + fmt::format("the class map has no line for label '{}'", name->second));
  return right->second;
}

/// Instance → planar, from the simulator's NAME.truth.json; empty without one.
std::map<int, bool> told_planar(const fs::path& cloud) {
  const fs::path path = fs::path(cloud).replace_extension(".truth.json");
  if (!fs::exists(path)) return {};
  std::map<int, bool> planar;
  try {
    std::ifstream stream(path);
    const nlohmann::json json = nlohmann::json::parse(stream);
    for (const auto& object : json.at("objects")) {
      planar[object.at("instance").get<int>()] = object.at("planar").get<bool>();
    }
  } catch (const nlohmann::json::exception& error) {
    throw Error(fmt::format("{}: not what `scenelore simulate` writes: {}", path.string(), error.what()));
  }
  return planar;
}

constexpr double kFlatDistance = 0.03, kFlatShare = 0.9;

/// By the plane of least squares through all points.
std::vector<bool> seem_planar(const PointTable& points, const SceneTruth& truth) {
  const Column *x = points.find("x"), *y = points.find("y"), *z = points.find("z");
  if (!x || !y || !z) return std::vector<bool>(truth.objects.size(), true);
  std::vector<std::vector<Eigen::Vector3d>> of_object(truth.objects.size());
  for (std::size_t i = 0; i < points.rows; ++i) {
    const std::int32_t object = truth.object_of_point[i];
    const Eigen::Vector3d p(points.value(*x, i), points.value(*y, i), points.value(*z, i));
    if (object >= 0 && p.allFinite()) of_object[static_cast<std::size_t>(object)].push_back(p);
  }
  std::vector<bool> out;
  for (const auto& part : of_object) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : part) mean += p / static_cast<double>(part.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& p : part) spread += (p - mean) * (p - mean).transpose();
    const Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
    const auto near = std::count_if(part.begin(), part.end(),
                                    [&](const Eigen::Vector3d& p) { return std::abs(normal.dot(p - mean)) <= kFlatDistance; });
    out.push_back(static_cast<double>(near) >= kFlatShare * static_cast<double>(part.size()));
  }
  return out;
}

}  // namespace

SceneTruth truth_of_table(const PointTable& points, const TruthFile& file, const kb::Knowledge& knowledge) {
  const Column *label = column_of(points, "label"), *instance = column_of(points, "instance");
  if (!label) {
    throw NoTruth(file.path.string() + ": holds no truth: a property `label` is needed, and `instance` where single objects are known");
  }
  SceneTruth truth{.objects = {}, .object_of_point = std::vector<std::int32_t>(points.rows, kNotKnown), .faces = file.map == nullptr};
  std::map<std::pair<int, int>, std::int32_t> index;  // instance, label → object
  for (std::size_t i = 0; i < points.rows; ++i) {
    const int id = static_cast<int>(points.value(*label, i)), number = instance ? static_cast<int>(points.value(*instance, i)) : id;
    if (instance && number <= 0) {
      truth.object_of_point[i] = file.map ? kNotKnown : kNothing;
      continue;
    }
    const auto [entry, fresh] = index.try_emplace({number, id}, kNotKnown);
    if (fresh) {
      std::vector<std::string> classes = classes_of(id, file, knowledge);
      if (!classes.empty()) {
        entry->second = static_cast<std::int32_t>(truth.objects.size());
        truth.objects.push_back({.instance = number, .classes = std::move(classes)});
      }
    }
    truth.object_of_point[i] = entry->second;
    if (entry->second >= 0) ++truth.objects[static_cast<std::size_t>(entry->second)].points;
  }
  if (truth.objects.empty()) throw NoTruth(file.path.string() + ": holds no truth: not one point has a label that is judged");
  const std::map<int, bool> told = told_planar(file.path);
  const std::vector<bool> seem = told.empty() ? seem_planar(points, truth) : std::vector<bool>{};
  for (std::size_t o = 0; o < truth.objects.size(); ++o) {
    const auto entry = told.find(truth.objects[o].instance);
    truth.objects[o].planar = told.empty() ? seem[o] : entry != told.end() && entry->second;
  }
  return truth;
}

SceneTruth read_truth(const TruthFile& file, const kb::Knowledge& knowledge) {
  return truth_of_table(perception::read_points(file.path), file, knowledge);
}

SceneTruth truth_of_rows(const std::vector<std::pair<kb::PlaneId, std::string>>& rows, const std::vector<std::int64_t>& plane_id_of_point) {
  SceneTruth truth{.objects = {}, .object_of_point = std::vector<std::int32_t>(plane_id_of_point.size(), kNotKnown)};
  std::map<kb::PlaneId, std::int32_t> index;
  for (const auto& [plane, name] : rows) {
    index[plane] = static_cast<std::int32_t>(truth.objects.size());
    truth.objects.push_back({.instance = static_cast<int>(plane), .classes = {name}});
  }
  for (std::size_t i = 0; i < plane_id_of_point.size(); ++i) {
    const auto found = index.find(plane_id_of_point[i]);
    if (found == index.end()) continue;
    truth.object_of_point[i] = found->second;
    ++truth.objects[static_cast<std::size_t>(found->second)].points;
  }
  return truth;
}

}  // namespace scenelore::evaluation
