// Which cells of a grid are of one kind and which of the other, when neighbours tend to be alike.
#pragma once

#include <vector>

#include "height_grid.hpp"

namespace scenelore::perception {

/// True for the cells of the set that maximises the sum of `evidence` (nats for being in it, negative against) over its
/// cells less `border` nats for each side between a cell in and a cell out (Greig, Porteous & Seheult 1989). Found by
/// denoising the evidence with total variation as regulariser, whose level set at zero is that set (Chambolle 2005,
/// "Total variation minimization and a class of binary MRF models"), by accelerated projection of its dual (Beck &
/// Teboulle 2009), 80 rounds: to within a few cells.
[[nodiscard]] std::vector<bool> binary_cut(const HeightGrid& grid, const std::vector<double>& evidence, double border);

}  // namespace scenelore::perception
