#include "face_model.hpp"

#include <cmath>

namespace scenelore::perception {
namespace {

constexpr std::size_t kKnots = 9;

/// Log-odds at knots; straight lines between them, constant beyond.
struct Curve {
  std::array<double, kKnots> at, odds;
};

struct Model {
  double offset;
  std::array<Curve, kTraits> curves;
};

#include "face_curves.inc"

double value(const Curve& curve, double x) {
  if (std::isnan(x)) return 0;  // the mean of a curve over the examples
  if (x <= curve.at.front()) return curve.odds.front();
  for (std::size_t k = 1; k < kKnots; ++k) {
    if (x >= curve.at[k]) continue;
    const double t = (x - curve.at[k - 1]) / (curve.at[k] - curve.at[k - 1]);
    return curve.odds[k - 1] + t * (curve.odds[k] - curve.odds[k - 1]);
  }
  return curve.odds.back();
}

}  // namespace

double face_probability(const FaceTraits& traits, Origin origin) {
  const Model& model = origin == Origin::thing ? kThings : origin == Origin::earlier ? kEarlier : kSurfaces;
  double odds = model.offset;
  for (std::size_t t = 0; t < kTraits; ++t) odds += value(model.curves[t], traits[t]);
  return 1 / (1 + std::exp(-odds));
}

}  // namespace scenelore::perception
