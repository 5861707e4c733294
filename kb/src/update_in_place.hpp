// Replacing many rows by mostly the same ones.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "scenelore/kb/inference.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {

/// Evidence and facts are most of the rows, and a run after a changed row of knowledge finds mostly the same ones again.
/// Where just the numbers differ they are updated in place, which touches no index; `matches` says whether a stored row is
/// the i-th wanted one, `value` what its number should be. False: rows differ, all have to be written anew.
template <typename Matches, typename Value>
bool update_in_place(Statement& select, Statement& update, ScanId scan, std::size_t wanted, Matches matches, Value value) {
  std::vector<std::pair<std::int64_t, double>> changed;  // id, number
  std::size_t i = 0;
  auto row = select.use();
  for (row(scan); row.next(); ++i) {
    if (i >= wanted || !matches(row, i)) return false;
    if (row.real(1) != value(i)) changed.emplace_back(row.integer(0), value(i));
  }
  if (i != wanted) return false;
  for (const auto& [id, number] : changed) update.use()(number)(id).run();
  return true;
}

}  // namespace scenelore::kb
