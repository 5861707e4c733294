#include "pipeline/labelled_cloud.hpp"

#include <array>
#include <charconv>
#include <map>
#include <string>

namespace scenelore::pipeline {

namespace {

struct PointLabel {
  std::int32_t label = -1;
  float probability = 0;
  std::array<std::uint8_t, 3> color{160, 160, 160};  // grey: no label
};

std::array<std::uint8_t, 3> parse_color(const std::string& text, std::array<std::uint8_t, 3> otherwise) {
  if (text.size() != 7 || text[0] != '#') return otherwise;
  std::array<std::uint8_t, 3> color{};
  for (std::size_t i = 0; i < 3; ++i) {
    const char* first = text.data() + 1 + 2 * i;
    if (std::from_chars(first, first + 2, color[i], 16).ptr != first + 2) return otherwise;
  }
  return color;
}

std::map<std::int64_t, PointLabel> by_plane(const std::vector<kb::Label>& labels, const kb::Knowledge& knowledge) {
  std::map<std::int64_t, PointLabel> out;
  for (const kb::Label& label : labels) {
    PointLabel point;
    if (const int index = knowledge.class_index(label.object_class); index >= 0) {
      const kb::ObjectClass& known = knowledge.classes[static_cast<std::size_t>(index)];
      point = {known.id, static_cast<float>(label.probability), parse_color(known.color, point.color)};
    }
    out[label.plane] = point;
  }
  return out;
}

}  // namespace

void add_labels(perception::PointTable& points, const std::vector<std::int64_t>& plane_of_point,
                const std::vector<kb::Label>& labels, const kb::Knowledge& knowledge) {
  const auto of_plane = by_plane(labels, knowledge);
  std::vector<std::int32_t> plane(points.rows, -1), label(points.rows, -1);
  std::vector<float> probability(points.rows, 0);
  std::array<std::vector<std::uint8_t>, 3> color;
  for (auto& channel : color) channel.resize(points.rows);

  for (std::size_t i = 0; i < points.rows; ++i) {
    PointLabel point;
    if (plane_of_point[i] >= 0) {
      plane[i] = static_cast<std::int32_t>(plane_of_point[i]);
      if (const auto found = of_plane.find(plane_of_point[i]); found != of_plane.end()) point = found->second;
    }
    label[i] = point.label;
    probability[i] = point.probability;
    for (std::size_t c = 0; c < 3; ++c) color[c][i] = point.color[c];
  }

  const std::string prefix = points.find("red") || points.find("rgb") || points.find("rgba") ? "class_" : "";
  points.set_column("scalar_plane", plane);
  points.set_column("scalar_label", label);
  points.set_column("scalar_probability", probability);
  points.set_column(prefix + "red", color[0]);
  points.set_column(prefix + "green", color[1]);
  points.set_column(prefix + "blue", color[2]);
}

}  // namespace scenelore::pipeline
