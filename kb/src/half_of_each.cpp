#include "scenelore/kb/learn.hpp"

namespace scenelore::kb {

LearnedRows half_of_each(LearnedRows rows, const LearnedRows& others) {
  for (std::size_t c = 0; c < rows.classes.size(); ++c) {
    LearnedClass& of = rows.classes[c];
    const LearnedClass& other = others.classes[c];
    of.examples += other.examples;
    of.prior = (of.prior + other.prior) / 2;
    if (of.kinds.empty() || other.kinds.empty()) continue;
    of.kinds.insert(of.kinds.end(), other.kinds.begin(), other.kinds.end());
    for (std::size_t k = 0; k < of.kinds.size(); ++k) of.kinds[k].share /= 2, of.kinds[k].number = static_cast<int>(k) + 1;
  }
  return rows;
}

}  // namespace scenelore::kb
