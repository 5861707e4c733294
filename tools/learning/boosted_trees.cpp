#include "learning/boosted_trees.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace scenelore::learning {
namespace {

std::size_t leaf_of(const QuestionTree& tree, const std::vector<double>& traits) {
  std::size_t leaf = 0;
  for (std::size_t q = 0; q < tree.questions.size(); ++q) {
    if (traits[tree.questions[q].trait] > tree.questions[q].above) leaf |= std::size_t{1} << q;
  }
  return leaf;
}

/// Thresholds of each trait, rising, and how many of them each example's value is above.
struct Bins {
  std::vector<std::vector<double>> above;
  std::vector<std::vector<std::uint8_t>> of;  // by trait, then example
};

Bins binned(const std::vector<std::vector<double>>& traits, std::size_t most) {
  Bins bins;
  for (std::size_t t = 0; t < traits.front().size(); ++t) {
    std::vector<double> values;
    for (const std::vector<double>& row : traits) {
      if (!std::isnan(row[t])) values.push_back(row[t]);
    }
    std::sort(values.begin(), values.end());
    std::vector<double> above;
    if (!values.empty() && values.size() < traits.size()) above.push_back(std::nextafter(values.front(), -std::numeric_limits<double>::infinity()));
    for (std::size_t k = 1; k <= most && !values.empty(); ++k) {
      const std::size_t at = k * values.size() / (most + 1);
      const auto next = std::upper_bound(values.begin(), values.end(), values[at]);
      if (next == values.end()) break;
      const double middle = values[at] + (*next - values[at]) / 2;
      if (above.empty() || middle > above.back()) above.push_back(middle);
    }
    std::vector<std::uint8_t> of;
    for (const std::vector<double>& row : traits) {
      const auto below = std::isnan(row[t]) ? above.begin() : std::lower_bound(above.begin(), above.end(), row[t]);
      of.push_back(static_cast<std::uint8_t>(below - above.begin()));
    }
    bins.above.push_back(std::move(above));
    bins.of.push_back(std::move(of));
  }
  return bins;
}

/// First and second derivative of the likelihood, summed.
struct Slope {
  double first = 0, second = 0;
  void add(const Slope& o) { first += o.first, second += o.second; }
  [[nodiscard]] double worth(double shrinkage) const { return first * first / (second + shrinkage); }
};

class Grower {
 public:
  Grower(const Bins& bins, const std::vector<Slope>& slopes, const BoostingOptions& options)
      : bins_(bins), slopes_(slopes), options_(options), leaf_(slopes.size(), 0) {}

  QuestionTree grow() {
    QuestionTree tree;
    while (tree.questions.size() < options_.depth && ask(tree)) {
    }
    std::vector<Slope> sums(std::size_t{1} << tree.questions.size());
    for (std::size_t i = 0; i < leaf_.size(); ++i) sums[leaf_[i]].add(slopes_[i]);
    for (const Slope& s : sums) tree.odds.push_back(options_.rate * s.first / (s.second + options_.shrinkage));
    return tree;
  }
  [[nodiscard]] const std::vector<std::uint32_t>& leaf() const { return leaf_; }

 private:
  /// Adds the question that says most over all leaves; false when none says anything.
  bool ask(QuestionTree& tree);

  const Bins& bins_;
  const std::vector<Slope>& slopes_;
  const BoostingOptions& options_;
  std::vector<std::uint32_t> leaf_;  // by example
};

bool Grower::ask(QuestionTree& tree) {
  const std::size_t leaves = std::size_t{1} << tree.questions.size();
  double best = 0;
  std::size_t trait = 0, bin = 0;
  for (std::size_t t = 0; t < bins_.above.size(); ++t) {
    const std::size_t count = bins_.above[t].size() + 1;
    std::vector<Slope> sums(leaves * count), whole(leaves), low(leaves);
    for (std::size_t i = 0; i < leaf_.size(); ++i) sums[bins_.of[t][i] * leaves + leaf_[i]].add(slopes_[i]);
    for (std::size_t k = 0; k < sums.size(); ++k) whole[k % leaves].add(sums[k]);
    for (std::size_t b = 0; b + 1 < count; ++b) {
      double gain = 0;
      for (std::size_t l = 0; l < leaves; ++l) {
        low[l].add(sums[b * leaves + l]);
        const Slope high{whole[l].first - low[l].first, whole[l].second - low[l].second};
        gain += low[l].worth(options_.shrinkage) + high.worth(options_.shrinkage) - whole[l].worth(options_.shrinkage);
      }
      if (gain > best) best = gain, trait = t, bin = b;
    }
  }
  if (best <= 0) return false;
  for (std::size_t i = 0; i < leaf_.size(); ++i) {
    if (bins_.of[trait][i] > bin) leaf_[i] |= static_cast<std::uint32_t>(leaves);
  }
  tree.questions.push_back({trait, bins_.above[trait][bin]});
  return true;
}

}  // namespace

double BoostedTrees::odds(const std::vector<double>& traits) const {
  double sum = offset;
  for (const QuestionTree& tree : trees) sum += tree.odds[leaf_of(tree, traits)];
  return sum;
}

BoostedTrees fit_boosted_trees(const std::vector<std::vector<double>>& traits, const std::vector<bool>& outcomes, const BoostingOptions& options) {
  const std::size_t n = traits.size();
  const auto yes = static_cast<std::size_t>(std::count(outcomes.begin(), outcomes.end(), true));
  if (n != outcomes.size() || yes == 0 || yes == n) throw std::invalid_argument("boosted trees need examples of both outcomes");
  for (const std::vector<double>& row : traits) {
    if (row.size() != traits.front().size()) throw std::invalid_argument("examples of boosted trees differ in their number of traits");
  }
  BoostedTrees model;
  model.offset = std::log(static_cast<double>(yes) / static_cast<double>(n - yes));
  const Bins bins = binned(traits, std::min<std::size_t>(options.bins, 250));
  std::vector<double> odds(n, model.offset);
  std::vector<Slope> slopes(n);
  for (std::size_t round = 0; round < options.trees; ++round) {
    for (std::size_t i = 0; i < n; ++i) {
      const double p = 1 / (1 + std::exp(-odds[i]));
      slopes[i] = {(outcomes[i] ? 1.0 : 0.0) - p, p * (1 - p)};
    }
    Grower grower(bins, slopes, options);
    QuestionTree tree = grower.grow();
    if (tree.questions.empty()) break;
    for (std::size_t i = 0; i < n; ++i) odds[i] += tree.odds[grower.leaf()[i]];
    model.trees.push_back(std::move(tree));
  }
  return model;
}

}  // namespace scenelore::learning
