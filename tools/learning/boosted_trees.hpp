// Logistic regression on a sum of small trees (gradient boosting), each of which asks all examples the same few questions.
#pragma once

#include <cstddef>
#include <vector>

namespace scenelore::learning {

/// Asks whether traits are above thresholds. The answers are the bits of a leaf's number, the first question's the lowest. What is not known (NaN) is
/// above nothing, not even below everything known.
struct QuestionTree {
  struct Question {
    std::size_t trait = 0;
    double above = 0;
  };
  std::vector<Question> questions;
  std::vector<double> odds;  ///< log-odds by leaf, 2^questions of them
};

struct BoostedTrees {
  double offset = 0;  ///< log-odds
  std::vector<QuestionTree> trees;
  [[nodiscard]] double odds(const std::vector<double>& traits) const;
};

struct BoostingOptions {
  std::size_t trees = 300;
  std::size_t depth = 4;  ///< questions of a tree, at most
  double rate = 0.15;     ///< share of each tree's step that is made
  double shrinkage = 10;  ///< added to the curvature of a leaf, of which an example has a quarter at the most
  std::size_t bins = 48;  ///< thresholds of a trait that are tried, at equal shares of the examples; 250 at the most
};

/// Gradient boosting (Friedman 2001) by steps of second order (Chen & Guestrin 2016), with one question for a whole level of a tree (oblivious trees,
/// Prokhorenkova et al. 2018). Deterministic. Fewer trees than asked for where no question says anything more. Throws std::invalid_argument when an
/// example has another number of traits than the first, or one outcome is missing.
[[nodiscard]] BoostedTrees fit_boosted_trees(const std::vector<std::vector<double>>& traits, const std::vector<bool>& outcomes, const BoostingOptions& options = {});

}  // namespace scenelore::learning
