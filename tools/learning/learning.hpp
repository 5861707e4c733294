// Learning from what people have labelled: rows in place of the present ones, what they change, and whether that helps.
//
//   const Learned learned = learn(base.knowledge(), labelled_scenes(base, rules), {});
//   if (!learned.refusal) base.learn_knowledge(learned.sql, "…");
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/pipeline.hpp"
#include "scenelore/kb/learn.hpp"
#include "scenelore/rules/learn_weights.hpp"

namespace scenelore::learning {

/// A scan with the classes that truth rows give its planes ("" without one).
struct LabelledScan {
  std::string scan;
  rules::LabelledScene planes;
};
/// Scans without a truth row are left out.
[[nodiscard]] std::vector<LabelledScan> labelled_scans(const kb::KnowledgeBase& base, const std::vector<kb::Scan>& scans, rules::RuleSet& rules);

struct Options {
  int fewest_planes = 20;        ///< labelled; with fewer nothing is learned
  int min_examples = 5;          ///< of a class; classes with fewer keep their rows
  double present_strength = 12;  ///< pretended examples of the present rows, for each class and feature
  double outliers = 0.04;        ///< share of wrong labels that move no Gaussian
  double suspicious = 0.1;       ///< a label that the other planes find less likely than this, and another class more likely than not, …
  double most_suspects = 0.1;    ///< … is left out, the least likely first, up to this share of the labels
  int folds = 4;                 ///< of the cross-validation; at least 2
  bool weights = true;           ///< learn weights of features and constraint rows, too
  int scans_for_weights = 4;     ///< mostly labelled ones, which weights need
  int threads = 2;               ///< the result does not depend on them
};

/// A label that does not fit what the others teach.
struct Suspect {
  std::string scan;
  kb::PlaneId plane = 0;
  std::string labelled, seems;
  double probability = 0;  ///< of the class it was given, without itself
};

/// How well labelled planes that were not learned from are told.
struct Effect {
  int planes = 0;
  double evidence_accuracy = 0;  ///< share whose class has the highest evidence
  double accuracy = 0;           ///< share with the right class in the best world model, which is told no truth
  double macro_f1 = 0;           ///< mean F1 over the classes that occur, without the fallback
  double log_likelihood = 0;     ///< mean ln of the right class's evidence
  double ece = 0;                ///< of the adjusted probabilities
};

struct Learned {
  std::optional<std::string> refusal;  ///< why nothing was learned: too little
  int planes = 0, scans = 0;           ///< labelled
  kb::LearnedRows rows;
  std::optional<rules::LearnedWeights> weights;
  kb::ProbabilityScale scale;  ///< of the adjusted probabilities, from held-back planes
  kb::Knowledge knowledge;  ///< with everything in place
  std::string sql;
  std::vector<Suspect> suspects;
  std::vector<std::string> notes;  ///< sentences about what was not learned
  Effect before, after;            ///< cross-validated: `after` on planes that each time were held back
  /// Whether the new rows tell held-back planes worse than the present ones: in accuracy by over 2 %, and in likelihood.
  [[nodiscard]] bool harmful() const;
};

/// Fits priors (from mostly labelled scans), Gaussians, densities and, from enough scans, weights. Weights come from scans whose
/// planes the densities they go with have not seen. Cross-validation holds back whole scans, or planes where scans are few.
[[nodiscard]] Learned learn(const kb::Knowledge& knowledge, const std::vector<LabelledScan>& scans, const Options& options = {});

}  // namespace scenelore::learning
