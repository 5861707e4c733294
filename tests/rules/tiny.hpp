// Small scenes and knowledge for tests: planes at rising heights, facts and rows by hand.
#pragma once

#include <random>

#include "scenelore/rules/labelling.hpp"
#include "scenelore/rules/made_plane.hpp"

namespace scenelore::rules::tiny {

/// Classes "unknown" (fallback), then those named.
inline kb::Knowledge knowledge(const std::vector<std::string>& classes) {
  kb::Knowledge out;
  out.classes.push_back({.id = 0, .name = "unknown", .fallback = true});
  for (const std::string& name : classes) out.classes.push_back({.id = static_cast<int>(out.classes.size()), .name = name});
  return out;
}

inline kb::ClassConstraint row(std::int64_t id, std::string object_class, kb::Quantifier quantifier,
                               std::optional<std::string> relation, std::optional<std::string> other,
                               std::optional<double> weight, std::optional<int> count = std::nullopt) {
  return {.id = id, .name = "row_" + std::to_string(id), .object_class = std::move(object_class),
          .quantifier = quantifier, .relation = std::move(relation), .other_class = std::move(other), .count = count,
          .weight = weight};
}

/// Square metre planes one above the other, half a metre apart; ids 10, 11, …
inline Scene scene(int planes) {
  std::vector<MadePlane> made;
  for (int i = 0; i < planes; ++i) made.push_back({.center = {0, 0, 0.5 * i}});
  Scene out = make_scene(made);
  for (std::size_t i = 0; i < out.ids.size(); ++i) out.ids[i] = 10 + static_cast<kb::PlaneId>(i);
  return out;
}

/// Rows that sum to one.
inline std::vector<std::vector<double>> evidence(std::mt19937& random, int planes, int classes) {
  std::vector<std::vector<double>> out;
  for (int i = 0; i < planes; ++i) {
    std::vector<double> p;
    double sum = 0;
    for (int c = 0; c < classes; ++c) sum += p.emplace_back(1 + static_cast<double>(random() % 20));
    for (double& x : p) x /= sum;
    out.push_back(p);
  }
  return out;
}

}  // namespace scenelore::rules::tiny
