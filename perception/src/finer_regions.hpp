// What is too small or too close to others for the usual voxels: boards of shelves between books, tops of radiators, sides of boxes.
#pragma once

#include "regions.hpp"

namespace scenelore::perception {

/// Grows regions from the points that no plane has, in cubes of `voxel` metres, and appends them; each needs `fewest` points. A point is of its
/// cube's region when it lies within that one's tolerance.
void grow_finer(const Cloud& cloud, double voxel, double fewest, const Limits& limits, int threads, Regions& regions);

}  // namespace scenelore::perception
