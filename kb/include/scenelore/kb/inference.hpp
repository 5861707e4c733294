// What the engine found out about one scan, as values that the knowledge base stores.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scenelore::kb {

using ScanId = std::int64_t;
using PlaneId = std::int64_t;

struct RelationFact {
  std::string relation;
  PlaneId a = 0, b = 0;
  double degree = 1;  ///< in (0, 1]
};

struct Run {
  std::string outcome;  ///< proved, feasible, infeasible, stopped
  double cost = 0, lower_bound = 0;
  std::int64_t nodes = 0;
  double seconds = 0;
  std::string knowledge_hash, rules_hash, engine_version;
};

struct Label {
  PlaneId plane = 0;
  std::string object_class;
  double probability = 0;  ///< adjusted: marginal over the consistent world models
  double margin = 0;       ///< extra cost of the best world where this plane is something else; may be infinite
  std::optional<std::string> runner_up;  ///< its class in that world
};

struct Alternative {
  int rank = 0;  ///< 2 = second best world
  PlaneId plane = 0;
  std::string object_class;
};

struct Reason {
  PlaneId plane = 0;
  std::string object_class;
  std::string kind;  ///< evidence, support, violation, runner_up, truth, floor
  std::optional<std::string> constraint_name;
  std::optional<PlaneId> other_plane;
  double amount = 0;  ///< nats in favour (> 0) or against (< 0)
  std::string sentence;
};

/// Everything of one labelling of one scan.
struct Inference {
  Run run;
  std::vector<std::string> classes;              ///< column names of `evidence`
  std::vector<PlaneId> planes;                   ///< row names of `evidence`
  std::vector<std::vector<double>> evidence;     ///< [plane][class]
  std::vector<RelationFact> facts;
  std::vector<Label> labels;
  std::vector<Alternative> alternatives;
  std::vector<Reason> reasons;
};

}  // namespace scenelore::kb
