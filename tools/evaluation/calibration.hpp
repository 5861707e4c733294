// Whether probabilities mean what they say.
#pragma once

#include <array>
#include <vector>

namespace scenelore::evaluation {

/// A probability of the class that was chosen, and whether that class is right.
struct Claim {
  double probability = 0;
  bool right = false;
};

/// Ten bins of equal width over [0, 1]; a probability on a border belongs to the lower bin, as in Guo et al. 2017.
struct Calibration {
  static constexpr std::size_t kBins = 10;
  struct Bin {
    double claims = 0, right = 0, probability = 0;  ///< sums
  };
  std::array<Bin, kBins> bins;
  double squares = 0;  ///< Σ (probability − right)²

  void add(const Claim& claim);
  Calibration& operator+=(const Calibration& other);
  [[nodiscard]] double claims() const;
  /// Expected calibration error: Σ over bins of share of claims × |share right − mean probability| (Naeini et al. 2015).
  [[nodiscard]] double ece() const;
  [[nodiscard]] double brier() const;  ///< mean square, Brier 1950, of the chosen class
  [[nodiscard]] double accuracy() const;
  [[nodiscard]] double confidence() const;  ///< mean probability
};

}  // namespace scenelore::evaluation
