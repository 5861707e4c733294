// Why a plane has its label, in sentences. Written after the answer is found; nothing here changes it.
#pragma once

#include <vector>

#include "scenelore/kb/evidence.hpp"
#include "world.hpp"

namespace scenelore::rules {

/// What one feature says for one class against another.
struct FeatureReason {
  kb::Reason::Term term;
  double gain = 0;  ///< nats for the class against the other one, weighted
  double error = 0;  ///< standard error of the value
};

/// Reads the best world and the worlds in which each plane is something else.
class Reasoner {
 public:
  Reasoner(const Case& about, const World& best);

  /// `rival` is the best world in which the plane is something else; nullptr where there is none or it is not known.
  void add_rival(int plane, const kb::Label& label, const World* rival);
  void add_evidence(int plane);
  void add_truth(int plane);
  void add_floor();
  void add_supports(const std::vector<double>& margins);
  void add_violations();

  /// By plane in the scene's order, then in the order added.
  [[nodiscard]] std::vector<kb::Reason> take();

 private:
  void add(int plane, const char* kind, double amount, std::string sentence, const kb::ClassConstraint* row = nullptr,
           int other = -1);
  void add_violation(const engine::Violation& violation);
  [[nodiscard]] const TupleConstraint::Tuple* best_tuple(const TupleConstraint& constraint, int a) const;
  [[nodiscard]] std::string others(const std::vector<kb::PlaneId>& planes, kb::PlaneId but) const;
  void add_tuple_support(const kb::ClassConstraint& row, const TupleConstraint::Tuple& tuple, double amount, double margin);
  void add_tuple_violation(const kb::ClassConstraint& row, const TupleConstraint& tuples, const engine::Violation& violation);
  [[nodiscard]] std::string strongest_features(const std::vector<FeatureReason>& strongest, const std::vector<std::string>& described) const;

  const Case& about_;
  const World& best_;
  std::map<kb::PlaneId, int> index_;                // of planes in the scene
  std::vector<int> rivals_;                         // by plane: the class that features prefer after the plane's own, −1 = none
  std::vector<std::vector<kb::Contribution>> mine_, theirs_;  // by plane: terms of its class, of its rival
  std::vector<std::vector<kb::Reason>> by_plane_;
};

/// What each feature of a plane says for one class against another, strongest first; empty without features.
[[nodiscard]] std::vector<kb::Reason> feature_reasons(const Case& about, int plane, int object_class, int against);

/// "evidence of plane 3 (wall instead of door)" or the row's message: what a difference is about.
[[nodiscard]] std::string name_difference(const Case& about, const World& to, const Difference& difference, int subject);

}  // namespace scenelore::rules
