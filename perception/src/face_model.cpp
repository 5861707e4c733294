#include "face_model.hpp"

#include <cmath>
#include <span>

namespace scenelore::perception {
namespace {

constexpr std::size_t kQuestions = 4;  // of a tree

/// Asks whether traits are above thresholds; the answers are the bits of the number of a log-odds, the first one's the lowest.
struct Tree {
  std::uint8_t trait[kQuestions];
  double above[kQuestions];
  double odds[1 << kQuestions];

  [[nodiscard]] double answer(const FaceTraits& traits) const {
    std::size_t leaf = 0;
    for (std::size_t q = 0; q < kQuestions; ++q) leaf |= static_cast<std::size_t>(traits[trait[q]] > above[q]) << q;
    return odds[leaf];
  }
};

#include "face_trees.inc"

double odds_of(const FaceTraits& traits, double offset, std::span<const Tree> trees) {
  for (const Tree& tree : trees) offset += tree.answer(traits);
  return offset;
}

}  // namespace

double face_probability(const FaceTraits& traits, Origin origin) {
  const auto odds = [&] {
    switch (origin) {
      case Origin::thing: return odds_of(traits, kThingsOffset, kThings);
      case Origin::earlier: return odds_of(traits, kEarlierOffset, kEarlier);
      case Origin::finer: return odds_of(traits, kFinerOffset, kFiner);
      case Origin::surface: break;
    }
    return odds_of(traits, kSurfacesOffset, kSurfaces);
  };
  return 1 / (1 + std::exp(-odds()));
}

}  // namespace scenelore::perception
