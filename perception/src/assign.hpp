// Gives each point to the nearest of the planes around it: growing over voxels loses a band along every edge.
#pragma once

#include "cell_index.hpp"
#include "regions.hpp"

namespace scenelore::perception {

/// Planes that hold points in a point's cell or the 26 around it compete for it, by distance in units of their tolerance.
/// Points further than the tolerance from all of them lose their plane. With `only_free` points that have a plane keep it.
void assign_points(const Cloud& cloud, const CellIndex& cells, const Limits& limits, bool only_free, int threads, Regions& regions);

}  // namespace scenelore::perception
