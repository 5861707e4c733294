#include "relation_answer.hpp"

#include <algorithm>
#include <numeric>

namespace scenelore::rules {

std::vector<Held> held_facts(const std::vector<kb::PlaneId>& ids, const std::vector<std::pair<int, int>>& pairs, const std::vector<double>& degrees) {
  const std::size_t step = degrees.size() > pairs.size() ? 2 : 1;
  const auto for_each = [&](auto visit) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto [a, b] = pairs[i];
      const double forth = degrees[i * step], back = degrees[i * step + step - 1];
      if (forth > 0) visit(static_cast<std::size_t>(a), static_cast<std::size_t>(b), forth);
      if (back > 0) visit(static_cast<std::size_t>(b), static_cast<std::size_t>(a), back);
    }
  };
  // Of one a, those b that come before it are seen first, and all are seen rising: counting sorts them.
  std::vector<std::size_t> place(ids.size() + 1);
  for_each([&](std::size_t a, std::size_t, double) { ++place[a + 1]; });
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<Held> facts(place.back());
  for_each([&](std::size_t a, std::size_t b, double degree) { facts[place[a]++] = {ids[a], ids[b], degree}; });
  return facts;
}

void sort_by_planes(std::vector<Held>& facts) {
  const auto before = [](const Held& f, const Held& g) { return std::pair(f.a, f.b) < std::pair(g.a, g.b); };
  if (!std::is_sorted(facts.begin(), facts.end(), before)) std::sort(facts.begin(), facts.end(), before);
}

}  // namespace scenelore::rules
