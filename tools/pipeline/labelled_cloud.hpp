// A scan's points with what the labelling says about each.
#pragma once

#include <cstdint>
#include <vector>

#include "scenelore/kb/inference.hpp"
#include "scenelore/kb/knowledge.hpp"
#include "scenelore/perception/point_table.hpp"

namespace scenelore::pipeline {

/// Adds to `points`: int scalar_plane (plane id, −1 = on none), int scalar_label (class id, −1 = none), float
/// scalar_probability (0 where there is no label), and the class colour as uchar red, green, blue; a cloud that has
/// colours keeps them, the class colour is then class_red, class_green, class_blue. All other properties stay as read.
/// `plane_of_point` has one plane id a point.
void add_labels(perception::PointTable& points, const std::vector<std::int64_t>& plane_of_point,
                const std::vector<kb::Label>& labels, const kb::Knowledge& knowledge);

}  // namespace scenelore::pipeline
