// Classes that came after the fallback class was learned, by rows alone. What they describe is among the fallback class's kinds, told
// more exactly than by any row that a person writes, so a newcomer takes over what it describes.
//
//   d_kC = Π_i (min(1, σ_C / σ_k) exp(−(μ_k − μ_C)² / 2 (σ_k² + σ_C²)))^F_i                                       (7)
//
// is how much of kind k class C describes, over the features i for which both have a Gaussian (0 without any); s_k the kind's share, U the
// fallback class. Of kind k
//
//   t_kC = d_kC min(1, π_C / π_U Σ_j s_j d_jC)                                                                     (8)
//
// goes over to C: all that C describes, but no more than its own prior. For what C says nothing about, the kinds speak, as far as C
// describes them.
#pragma once

#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "scenelore/kb/knowledge.hpp"

namespace scenelore::kb {

struct Newcomer {
  struct Row {
    double mean, sigma, weight;  ///< on the feature's scale; F_i
  };
  double prior = 0;                         ///< π_C / π_U
  std::map<std::string_view, Row> rows{};   ///< by feature
};

class Newcomers {
 public:
  /// `kinds` of the fallback class.
  Newcomers(std::span<const ClassKind> kinds, std::span<const Newcomer> newcomers);

  /// What the fallback class keeps of each kind's share: Π_C (1 − t_kC), in [0, 1].
  [[nodiscard]] std::vector<double> kept() const;
  /// By what factor a kind's share differs in the mixture that speaks for a newcomer where it says nothing: less what others took over,
  /// weighed by what it describes of it. A newcomer that describes nothing has the mixture of the fallback class.
  [[nodiscard]] std::vector<double> factors(std::size_t newcomer) const;

 private:
  static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);
  [[nodiscard]] double kept(std::size_t kind, std::size_t except) const;

  std::vector<double> own_shares_;
  std::vector<std::vector<double>> described_, taken_;  // [newcomer][kind]
};

}  // namespace scenelore::kb
