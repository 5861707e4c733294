// `scenelore solve`: the search alone, on a problem file of toulbar2's or of the UAI competitions.
#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "scenelore/engine/certificate.hpp"
#include "scenelore/engine/error.hpp"
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
           "scenelore solve two.cfn --certificate two.proof && scenelore solve two.cfn --check two.proof";
  }
  std::vector<Argument> arguments() override {
    return {positional("FILE", &file_, "FILE", "problem file; its ending tells the format"),
            {"--time", &seconds_, "s", "stop after so long and print the best answer so far", Effect::result, 0, 1e9},
            {"--nodes", &nodes_, "N", "stop after so many nodes", Effect::result, 0, 1e18},
            {"--bound", &bound_, "default|paper", "default: soft local consistency; paper: sum of the least label costs",
             Effect::speed},
            {"--certificate", &certificate_, "FILE", "write a proof of the answer, for --check", Effect::result},
            {"--certificate-size", &certificate_megabytes_, "MB", "write no more than so much (default 256)", Effect::result, 1, 1e6},
            {"--check", &check_, "CERTIFICATE", "search nothing: verify a proof that --certificate wrote", Effect::result},
            json_argument(json_)};
  }

  int run() override {
    if (bound_ != "default" && bound_ != "paper")
      throw UsageError(fmt::format("--bound is '{}'; it must be 'default' or 'paper'", bound_));
    const engine::ProblemFile file = engine::read_problem_file(file_);
    if (check_) return check(file);
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
    if (certificate_ && !write_certificate(file, options, solution)) return kLimit;
    if (none) return kNegative;
    return solution.outcome == engine::Outcome::proved ? kOk : kLimit;
  }

 private:
  /// False, with a word, when a limit leaves no proof.
  bool write_certificate(const engine::ProblemFile& file, const engine::SolverOptions& options, engine::Solution solution) const {
    using engine::Outcome;
    if (solution.outcome == Outcome::stopped && solution.lower_bound >= file.below)  // show what the best one costs instead
      solution = engine::Solver(file.problem, options).solve();
    std::optional<std::string> text;
    if (solution.outcome == Outcome::proved || solution.outcome == Outcome::infeasible)
      text = engine::certificate(file.problem, solution,
                                 {.limits = options.limits, .most_bytes = static_cast<std::size_t>(certificate_megabytes_.value_or(256) * 1e6)});
    if (!text) {
      fmt::print(stderr, "{}: not written: a limit came before the proof was complete\n", *certificate_);
      return false;
    }
    std::ofstream out(*certificate_, std::ios::binary);
    out << *text;
    out.close();
    if (!out) throw engine::FileError(*certificate_ + ": cannot be written");
    return true;
  }

  int check(const engine::ProblemFile& file) const {
    std::ifstream in(*check_, std::ios::binary);
    if (!in) throw engine::FileError(*check_ + ": cannot be opened");
    const engine::Verdict verdict = engine::verify(file.problem, in);
    if (!verdict.accepted) {
      fmt::print(stderr, "{}: refused: {}\n", *check_, verdict.reason);
      return kNegative;
    }
    // Worlds that cost the file's bound or more do not count as solutions.
    const bool any = verdict.outcome == engine::Outcome::proved && verdict.cost < file.below;
    engine::Solution solution;
    if (any) solution.cost = verdict.cost;
    if (any) solution.assignment = verdict.assignment;
    solution.lower_bound = any ? verdict.cost - verdict.tolerance : std::numeric_limits<double>::infinity();
    print(file, solution, any ? "proved" : "infeasible", true);
    return kOk;  // whatever is shown, it is so
  }

  void print(const engine::ProblemFile& file, const engine::Solution& solution, const char* outcome,
             bool verified = false) const {
    const bool any = !solution.assignment.empty();
    const double cost = file.in_file(solution.cost), bound = file.in_file(solution.lower_bound);
    nlohmann::ordered_json out{{"outcome", outcome}};
    if (verified) out["certificate"] = "verified";
    out["cost"] = any ? nlohmann::ordered_json(cost) : nullptr;
    out["lower_bound"] = std::isfinite(bound) ? nlohmann::ordered_json(bound) : nullptr;
    if (!verified) out["nodes"] = solution.nodes;
    if (!verified) out["seconds"] = solution.seconds;
    out["assignment"] = nlohmann::ordered_json::object();
    const std::vector<int> labels = any ? file.in_file(solution.assignment) : std::vector<int>();
    for (std::size_t v = 0; v < labels.size(); ++v)
      out["assignment"][file.variables[v].name] = file.variables[v].labels[static_cast<std::size_t>(labels[v])];
    if (json_) {
      fmt::print("{}\n", out.dump(2));
      return;
    }
    for (const char* field : {"outcome", "certificate", "cost", "lower_bound", "nodes", "seconds"}) {
      if (!out.contains(field)) continue;
      const auto& value = out[field];
      fmt::print("{:<12} {}\n", field, value.is_string() ? value.get<std::string>() : value.is_null() ? "-" : value.dump());
    }
    for (const auto& [variable, label] : out["assignment"].items()) fmt::print("{} = {}\n", variable, label.get<std::string>());
  }

  std::string file_;
  std::optional<double> seconds_;
  std::optional<double> nodes_;
  std::optional<std::string> certificate_, check_;
  std::optional<double> certificate_megabytes_;
  std::string bound_ = "default";
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> solve_command() { return std::make_unique<SolveCommand>(); }

}  // namespace scenelore::tools
