#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::proved:
      return "proved";
    case Outcome::feasible:
      return "feasible";
    case Outcome::infeasible:
      return "infeasible";
    case Outcome::stopped:
      return "stopped";
  }
  return "stopped";
}

}  // namespace scenelore::engine
