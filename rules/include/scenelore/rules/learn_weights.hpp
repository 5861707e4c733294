// Learning how much each feature, class and constraint row counts, from scenes whose planes are labelled.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {

/// Planes whose class is known, and the facts between them.
struct LabelledScene {
  Scene scene;                       ///< with the features that count, Lua ones too
  Facts facts;                       ///< of all relations that the knowledge's enabled rows use
  std::vector<std::string> classes;  ///< one a plane; empty = not known: it teaches nothing, but others may relate to it
};

struct LearnWeightsOptions {
  int rounds = 5;          ///< of labelling all scenes and fitting the weights to what came out
  double strength = 4;     ///< how firmly a weight holds on to its present value, in pretended planes
  double most = 8;         ///< nats, no row weighs more; rows are for the usual, hard rows for the certain
  double most_of_feature = 8;  ///< no feature weighs more; less than 1 where the scenes are sharper than what will be labelled
  engine::SolverOptions solver = {.limits = {.seconds = 5}};
};

struct LearnedWeights {
  std::vector<double> features;     ///< in the knowledge's order; those of weight 0 stay 0
  std::vector<double> priors;       ///< one a class, sum 1
  std::vector<double> constraints;  ///< one a row of the knowledge; hard and disabled rows: 0, not learned
  std::vector<double> log_likelihood;  ///< mean over the planes after each round: ln of the true class's probability given the rest
};

/// Maximises the pseudo-likelihood (Besag 1975) of the true classes: of each plane's class given the classes of all other
/// planes. Those others are the true ones in one half of the examples and, in the other half, the classes that the best
/// world of the previous round gives them; for rows are used among neighbours that perception missed or mistook, and a
/// row that only holds among true neighbours must not weigh as if they were known. Each fit is convex; weights stay ≥ 0.
/// Deterministic. Throws Error for sizes that do not fit and for classes that the knowledge lacks.
[[nodiscard]] LearnedWeights learn_weights(const kb::Knowledge& knowledge, std::span<const LabelledScene> scenes,
                                           const LearnWeightsOptions& options = {});

/// The knowledge with the weights in place.
[[nodiscard]] kb::Knowledge with_weights(kb::Knowledge knowledge, const LearnedWeights& weights);

/// UPDATE statements, one a weight that differs from the knowledge's by more than rounding.
[[nodiscard]] std::string to_sql(const kb::Knowledge& knowledge, const LearnedWeights& weights);

}  // namespace scenelore::rules
