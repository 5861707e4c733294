#include <utility>

#include "scenelore/kb/learn.hpp"

namespace scenelore::kb {

LearnedRows mix_fits(std::vector<LearnedRows> fits) {
  LearnedRows out = std::move(fits.at(0));
  for (std::size_t c = 0; c < out.classes.size(); ++c) {
    LearnedClass& of = out.classes[c];
    double fits_with_kinds = of.kinds.empty() ? 0 : 1;
    for (std::size_t f = 1; f < fits.size(); ++f) {
      const LearnedClass& other = fits[f].classes[c];
      of.examples += other.examples;
      of.prior += other.prior;
      of.kinds.insert(of.kinds.end(), other.kinds.begin(), other.kinds.end());
      if (!other.kinds.empty()) ++fits_with_kinds;
    }
    of.prior /= static_cast<double>(fits.size());
    for (std::size_t k = 0; k < of.kinds.size(); ++k) of.kinds[k].share /= fits_with_kinds, of.kinds[k].number = static_cast<int>(k) + 1;
  }
  return out;
}

}  // namespace scenelore::kb
