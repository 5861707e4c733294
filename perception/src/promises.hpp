// Makes the promises of a segmentation true: connectedness, distance, mean squared error, number of points.
#pragma once

#include "regions.hpp"

namespace scenelore::perception {

/// Splits, trims and drops regions until every one keeps all limits, and numbers them by falling point count, ties by
/// position. What is too narrow, too thick or too loosely filled to be a surface (edges, legs, frames) is dropped.
void keep_promises(const Cloud& cloud, const Limits& limits, int threads, Regions& regions);

}  // namespace scenelore::perception
