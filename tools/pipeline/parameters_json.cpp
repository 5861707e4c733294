#include "pipeline/parameters_json.hpp"

#include <nlohmann/json.hpp>

namespace scenelore::pipeline {

std::string parameters_json(const perception::Perception& perception) {
  const perception::SegmentationParameters& used = perception.parameters;
  return nlohmann::ordered_json{{"max_point_distance", used.max_point_distance.value()},
                                {"max_plane_distance", used.max_plane_distance.value()},
                                {"max_mse", used.max_mse.value()},
                                {"min_points", used.min_points.value()},
                                {"max_neighbours", used.max_neighbours.value()},
                                {"spacing", perception.spacing},
                                {"noise", perception.noise},
                                {"floor_found", perception.upright.floor_found},
                                {"upright_confidence", perception.upright.confidence},
                                {"upright", perception.upright.explanation}}
      .dump();
}

}  // namespace scenelore::pipeline
