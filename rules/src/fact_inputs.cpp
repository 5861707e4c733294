#include "fact_inputs.hpp"

#include <algorithm>

#include "lua_files.hpp"
#include "scenelore/kb/sha256.hpp"

namespace scenelore::rules {

namespace {

class Bytes {
 public:
  void number(double value) { text_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void count(std::size_t value) { text_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void text(std::string_view value) {
    count(value.size());
    text_ += value;
  }
  template <typename Vector>
  void vector(const Vector& values) {
    text_.append(reinterpret_cast<const char*>(values.data()), static_cast<std::size_t>(values.size()) * sizeof(double));
  }
  void ring(const perception::Ring& ring) {
    count(ring.size());
    for (const Eigen::Vector3d& corner : ring) vector(corner);
  }
  [[nodiscard]] const std::string& all() const { return text_; }

 private:
  std::string text_;
};

void add(Bytes& bytes, const perception::Plane& plane) {
  bytes.vector(plane.centroid);
  bytes.vector(plane.normal);
  for (const double value : {plane.area_m2, plane.length, plane.width, plane.rectangularity, plane.spread_length,
                             plane.spread_width, plane.tilt_deg, plane.height, plane.z_min, plane.z_max, plane.rmse,
                             plane.facing_up, plane.point_density, plane.seen_share, plane.behind, plane.edge_free,
                             plane.edge_free_top, plane.edge_joined, plane.edge_unseen}) {
    bytes.number(value);
  }
  bytes.count(plane.point_count);
  bytes.ring(plane.hull.outer);
  bytes.count(plane.hull.holes.size());
  for (const perception::Ring& hole : plane.hull.holes) bytes.ring(hole);
}

}  // namespace

SceneDigest::SceneDigest(const Scene& scene, Last& last) : scene_(scene) {
  Bytes bytes;
  bytes.count(scene.planes.size());
  for (const kb::PlaneId id : scene.ids) bytes.count(static_cast<std::size_t>(id));
  for (const perception::Plane& plane : scene.planes) add(bytes, plane);
  if (last.digest.empty() || last.bytes != bytes.all()) last = {bytes.all(), kb::sha256_of(bytes.all())};
  planes_ = last.digest;
}

std::string SceneDigest::with(const std::string& features) const {
  if (features.empty()) return planes_;
  Bytes bytes;
  bytes.text(planes_);
  const std::vector<std::string>& names = scene_.features.names;
  for (std::size_t begin = 0, end = 0; begin < features.size(); begin = end + 1) {
    end = std::min(features.find('\n', begin), features.size());
    const std::string name = features.substr(begin, end - begin);
    bytes.text(name);
    if (name == "?") {
      for (const std::string& known : names) bytes.text(known);
      continue;
    }
    const auto column = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    for (const std::vector<double>& row : scene_.features.values) {
      bytes.count(column < row.size() ? 1 : 0);
      if (column < row.size()) bytes.number(row[column]);
    }
  }
  return kb::sha256_of(bytes.all());
}

std::string fact_inputs(const RuleSource& relation, const Overrides& settings, const std::string& planes) {
  // Built-in files count as part of the program: other files may extend them.
  static const std::string program = [] {
    std::string all = SCENELORE_RULE_HOST;  // hash of the sources behind geometry.*, made by CMake
    for (const EmbeddedFile& file : lua_files()) all += file.text;
    return kb::sha256_of(all);
  }();
  Bytes bytes;
  bytes.text(program);
  bytes.text(relation.text);
  for (const auto& [field, value] : settings) {
    bytes.text(field);
    bytes.number(value);
  }
  bytes.text(planes);
  return kb::sha256_of(bytes.all());
}

}  // namespace scenelore::rules
