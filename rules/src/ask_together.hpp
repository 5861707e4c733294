// Several built-in relations asked about one scene by several threads.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "deadline.hpp"
#include "loaded_rules.hpp"
#include "pair_geometry.hpp"

namespace scenelore::rules {

/// One relation, the pairs it is asked about, and what it answered.
struct AskedRelation {
  std::string name;
  RelationInfo info;
  const Pairs* pairs = nullptr;
  std::vector<double> degrees{};  ///< one a pair or, where the relation is not symmetric, two: forth and back
  FeatureNames features{};        ///< that it looked at
  double milliseconds = 0;        ///< of all threads together

  [[nodiscard]] std::size_t degrees_a_pair() const { return info.symmetric ? 1 : 2; }
};

/// Fills in what each answers, all of them built-in ones. Degrees, features, and what the geometry knows afterwards are the same bytes with any
/// number of threads; so is the Error of the first relation, and of the first pair, that fails.
///
/// Threads take the planes piece by piece, each asking all relations in their order about the pairs of which these planes have the smaller
/// index. So the questions about a pair come one after the other, in the order in which a single thread would ask them, and no two threads
/// ask for the same piece of geometry.
void ask_together(LoadedRules& rules, const Scene& scene, PairGeometry& geometry, std::vector<AskedRelation>& relations, int threads);

/// Puts the degrees of pairs into `degrees`, of a file that has been shown the scene: one a pair or, where it is not symmetric, two: forth and
/// back. `asked`: questions before these, for the message of a deadline that is over.
void put_degrees(RuleFile& file, std::span<const std::pair<int, int>> pairs, const Deadline& deadline, std::int64_t asked, double* degrees);

}  // namespace scenelore::rules
