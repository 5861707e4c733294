#include "evaluation/calibration.hpp"

#include <algorithm>
#include <cmath>

namespace scenelore::evaluation {

void Calibration::add(const Claim& claim) {
  const double at = std::ceil(claim.probability * static_cast<double>(kBins)) - 1;
  Bin& bin = bins[static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(kBins - 1)))];
  bin.claims += 1;
  bin.right += claim.right;
  bin.probability += claim.probability;
  squares += std::pow(claim.probability - claim.right, 2);
}

Calibration& Calibration::operator+=(const Calibration& other) {
  for (std::size_t b = 0; b < kBins; ++b) {
    bins[b].claims += other.bins[b].claims;
    bins[b].right += other.bins[b].right;
    bins[b].probability += other.bins[b].probability;
  }
  squares += other.squares;
  return *this;
}

double Calibration::claims() const {
  double n = 0;
  for (const Bin& bin : bins) n += bin.claims;
  return n;
}

double Calibration::ece() const {
  double error = 0;
  for (const Bin& bin : bins) error += std::abs(bin.right - bin.probability);
  return error / std::max(1.0, claims());
}

double Calibration::brier() const { return squares / std::max(1.0, claims()); }

double Calibration::accuracy() const {
  double right = 0;
  for (const Bin& bin : bins) right += bin.right;
  return right / std::max(1.0, claims());
}

double Calibration::confidence() const {
  double sum = 0;
  for (const Bin& bin : bins) sum += bin.probability;
  return sum / std::max(1.0, claims());
}

}  // namespace scenelore::evaluation
