#include "slot_layout.hpp"

#include <algorithm>
#include <utility>

namespace scenelore::perception {
namespace {

/// A voxel's own slots: one for each candidate, and the last one.
std::uint32_t slots_of(const Candidates& candidates, std::size_t v) { return candidates.first[v + 1] - candidates.first[v] + 1; }

/// `rulers`: number of the first plane's.
void lay_out(const Candidates& candidates, std::size_t v, std::size_t rulers, Slots& slots) {
  std::uint32_t s = slots.first[v];
  for (std::uint32_t k = candidates.first[v]; k < candidates.first[v + 1]; ++k, ++s) {
    slots.region[s] = candidates.regions[k];
    slots.ruler[s] = static_cast<std::int32_t>(rulers) + candidates.regions[k];
  }
  slots.region[s] = slots.ruler[s] = -1;
}

void resize(Slots& slots, std::size_t count) {
  slots.voxel.resize(count), slots.region.resize(count), slots.ruler.resize(count);
  if (count > slots.moments.capacity()) slots.moments.reserve(count + count / 16);  // not twice as much
  slots.moments.resize(count);
}

void move_slot(Slots& slots, std::uint32_t from, std::uint32_t to) {
  slots.region[to] = slots.region[from], slots.ruler[to] = slots.ruler[from];
  slots.moments[to] = slots.moments[from];
}

}  // namespace

Slots slots_for(const VoxelGrid& grid, const Candidates& candidates) {
  Slots slots;
  slots.first.resize(grid.count() + 1);
  for (std::size_t v = 0; v < grid.count(); ++v) slots.first[v + 1] = slots.first[v] + slots_of(candidates, v);
  slots.voxel.resize(slots.first.back()), slots.region.resize(slots.first.back()), slots.ruler.resize(slots.first.back());
  for (std::size_t v = 0; v < grid.count(); ++v) {
    std::fill(slots.voxel.begin() + slots.first[v], slots.voxel.begin() + slots.first[v + 1], static_cast<std::uint32_t>(v));
    lay_out(candidates, v, 0, slots);
  }
  return slots;
}

std::vector<std::uint32_t> lay_out_anew(const std::vector<bool>& anew, const Candidates& candidates, Slots& slots) {
  const std::size_t voxels = anew.size();
  std::vector<std::uint32_t> first(voxels + 1, 0);
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < voxels; ++v) {
    const std::uint32_t own = slots.first[v + 1] - slots.first[v];
    first[v + 1] = first[v] + (anew[v] ? slots_of(candidates, v) : own);
    if (anew[v]) continue;
    for (std::uint32_t s = slots.first[v]; s < slots.first[v + 1]; ++s, ++kept) move_slot(slots, s, kept);
  }
  resize(slots, first.back());
  std::swap(slots.first, first);
  for (std::size_t v = voxels; v-- > 0;) {
    for (std::uint32_t s = slots.first[v + 1]; s-- > slots.first[v];) {
      slots.voxel[s] = static_cast<std::uint32_t>(v);
      if (!anew[v]) move_slot(slots, --kept, s);
    }
    if (anew[v]) lay_out(candidates, v, slots.rulers.size(), slots);
  }
  return first;
}

}  // namespace scenelore::perception
