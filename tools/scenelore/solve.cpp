// `scenelore solve`: the search alone, on a problem file of toulbar2's or of the UAI competitions.
#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "scenelore/engine/problem_file.hpp"
#include "scenelore/engine/solver.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

class SolveCommand : public Command {
 public:
  std::string name() const override { return "solve"; }
  std::string summary() const override { return "Solve a weighted constraint problem from a .cfn, .wcsp or .uai file."; }
  std::string example() const override {
    return "printf '%s' '{\"problem\":{\"name\":\"two\",\"mustbe\":\"<100\"}, \"variables\":{\"a\":[\"x\",\"y\"],\"b\":[\"x\",\"y\"]},\n"
           "  \"functions\":{\"f\":{\"scope\":[\"a\",\"b\"],\"costs\":[3,1.5,2,9]}}}' > two.cfn\n"
           "scenelore solve two.cfn";
  }
  std::vector<Argument> arguments() override {
    return {positional("FILE", &file_, "FILE", "problem file; its ending tells the format"),
            {"--time", &seconds_, "s", "stop after so long and print the best answer so far", Effect::result, 0, 1e9},
            {"--nodes", &nodes_, "N", "stop after so many nodes", Effect::result, 0, 1e18},
            {"--bound", &bound_, "default|paper", "default: soft local consistency; paper: sum of the least label costs",
             Effect::speed},
            json_argument(json_)};
  }

  int run() override {
    if (bound_ != "default" && bound_ != "paper")
      throw UsageError(fmt::format("--bound is '{}'; it must be 'default' or 'paper'", bound_));
    const engine::ProblemFile file = engine::read_problem_file(file_);
    engine::SolverOptions options;
    options.bound = bound_ == "paper" ? engine::Bound::paper : engine::Bound::soft_consistency;
    options.limits = {.interrupt = interrupt_flag()};
    if (seconds_) options.limits.seconds = *seconds_;
    if (nodes_) options.limits.nodes = static_cast<std::uint64_t>(*nodes_);
    const engine::Solution solution =
        engine::Solver(file.problem, options).solve({.fixed = {}, .forbidden = {}, .below = file.below});
    // Worlds that cost the file's bound or more do not count as solutions.
    const bool none = solution.outcome == engine::Outcome::infeasible ||
                      (solution.outcome == engine::Outcome::stopped && solution.lower_bound >= file.below);
    print(file, solution, none ? "infeasible" : engine::to_string(solution.outcome));
    if (none) return kNegative;
    return solution.outcome == engine::Outcome::proved ? kOk : kLimit;
  }

 private:
  void print(const engine::ProblemFile& file, const engine::Solution& solution, const char* outcome) const {
    const bool any = !solution.assignment.empty();
    const double cost = file.in_file(solution.cost), bound = file.in_file(solution.lower_bound);
    nlohmann::ordered_json out{{"outcome", outcome}};
    out["cost"] = any ? nlohmann::ordered_json(cost) : nullptr;
    out["lower_bound"] = std::isfinite(bound) ? nlohmann::ordered_json(bound) : nullptr;
    out["nodes"] = solution.nodes;
    out["seconds"] = solution.seconds;
    out["assignment"] = nlohmann::ordered_json::object();
    for (int v = 0; any && v < file.variables; ++v) {
      const engine::Variable& variable = file.problem.variables()[static_cast<std::size_t>(v)];
      out["assignment"][variable.name] = variable.labels[static_cast<std::size_t>(solution.assignment[static_cast<std::size_t>(v)])];
    }
    if (json_) {
      fmt::print("{}\n", out.dump(2));
      return;
    }
    for (const char* field : {"outcome", "cost", "lower_bound", "nodes", "seconds"}) {
      const auto& value = out[field];
      fmt::print("{:<12} {}\n", field, value.is_string() ? value.get<std::string>() : value.is_null() ? "-" : value.dump());
    }
    for (const auto& [variable, label] : out["assignment"].items()) fmt::print("{} = {}\n", variable, label.get<std::string>());
  }

  std::string file_;
  std::optional<double> seconds_;
  std::optional<double> nodes_;
  std::string bound_ = "default";
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> solve_command() { return std::make_unique<SolveCommand>(); }

}  // namespace scenelore::tools
