#include "newcomers.hpp"

#include <algorithm>
#include <cmath>

namespace scenelore::kb {

namespace {

/// What a kind that a newcomer does not describe counts for it, by one that it describes.
constexpr double kNotDescribed = 0.01;

// Equation (7).
double described(const ClassKind& kind, const Newcomer& newcomer) {
  double logarithm = 0;
  bool any = false;
  for (const KindFeature& of : kind.features) {
    const auto row = newcomer.rows.find(of.feature);
    if (row == newcomer.rows.end()) continue;
    const auto& [mean, sigma, weight] = row->second;
    const double off = of.mean - mean;
    logarithm += weight * (std::min(0.0, std::log(sigma / of.sigma)) - off * off / (2 * (sigma * sigma + of.sigma * of.sigma)));
    any = true;
  }
  return any ? std::exp(logarithm) : 0;
}

}  // namespace

Newcomers::Newcomers(std::span<const ClassKind> kinds, std::span<const Newcomer> newcomers) {
  for (const ClassKind& kind : kinds) own_shares_.push_back(kind.share);
  for (const Newcomer& newcomer : newcomers) {
    std::vector<double> share;
    double sum = 0;
    for (const ClassKind& kind : kinds) {
      share.push_back(described(kind, newcomer));
      sum += kind.share * share.back();
    }
    described_.push_back(share);
    for (double& t : share) t *= sum > 0 ? std::min(1.0, newcomer.prior / sum) : 0;  // (8)
    taken_.push_back(std::move(share));
  }
}

double Newcomers::kept(std::size_t kind, std::size_t except) const {
  double left = 1;
  for (std::size_t c = 0; c < taken_.size(); ++c) left *= c == except ? 1 : 1 - taken_[c][kind];
  return left;
}

std::vector<double> Newcomers::kept() const {
  std::vector<double> out;
  for (std::size_t k = 0; k < own_shares_.size(); ++k) out.push_back(kept(k, kNobody));
  return out;
}

std::vector<double> Newcomers::factors(std::size_t newcomer) const {
  std::vector<double> out;
  double all = 0, weighed = 0;
  for (std::size_t k = 0; k < own_shares_.size(); ++k) {
    const double left = kept(k, newcomer);
    out.push_back(left * (described_[newcomer][k] + kNotDescribed));
    all += own_shares_[k] * left;
    weighed += own_shares_[k] * out.back();
  }
  for (double& factor : out) factor *= weighed > 0 ? all / weighed : 0;
  return out;
}

}  // namespace scenelore::kb
