#include "scenelore/engine/certificate.hpp"

#include <algorithm>

#include "component.hpp"
#include "proof_log.hpp"
#include "scenelore/engine/error.hpp"
#include "search.hpp"

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

class Writer {
 public:
  Writer(const Problem& problem, const Solution& solution, const CertificateOptions& options)
      : problem_(problem), solution_(solution), options_(options), scale_(problem), outline_(problem, scale_), budget_(options.limits) {}

  std::optional<std::string> write() {
    Decomposition parts = build_parts(outline_, {.labels = labels()});
    for (Component& part : parts.components) part.network.close();
    text_ = "scenelore certificate 1\n";
    const bool written = solution_.outcome == Outcome::proved ? proved(parts) : infeasible(parts);
    if (!written) return std::nullopt;
    text_ += "end\n";
    return std::move(text_);
  }

 private:
  /// Labels that cost too much whatever the others are take no part.
  std::vector<std::vector<char>> labels() {
    if (solution_.outcome != Outcome::proved) return {};
    std::vector<std::vector<char>> all;
    std::vector<Cost> cheapest;
    Cost sum = 0;
    for (const Variable& variable : problem_.variables()) {
      cheapest.push_back(scale_.whole(*std::min_element(variable.costs.begin(), variable.costs.end())));
      sum += cheapest.back();
    }
    const Cost limit = cost();
    for (std::size_t v = 0; v < problem_.variables().size(); ++v) {
      auto& row = all.emplace_back();
      for (const double cost : problem_.variables()[v].costs) {
        const bool out = sum - cheapest[v] + scale_.whole(cost) >= limit;
        const bool chosen = solution_.assignment[v] == static_cast<int>(row.size());
        if (out && !chosen)
          dropped_ += "- " + std::to_string(v) + ' ' + std::to_string(row.size()) + '\n';
        row.push_back(out && !chosen ? 0 : 1);
      }
    }
    return all;
  }

  /// Of the answer, in whole numbers.
  Cost cost() {
    std::vector<std::vector<char>> only;
    for (std::size_t v = 0; v < solution_.assignment.size(); ++v) {
      auto& row = only.emplace_back(problem_.variables()[v].labels.size(), char{0});
      row[index(solution_.assignment[v])] = 1;
    }
    Decomposition world = build_parts(outline_, {.labels = std::move(only)});
    for (Component& part : world.components) part.network.close();
    return cost(world);
  }
  Cost cost(const Decomposition& parts) const {
    Cost sum = parts.constant;
    for (const Component& part : parts.components) sum = std::min(sum + part.network.evaluate(chosen(parts, part)), kTop);
    if (is_forbidden(sum)) throw Error("certificate: the answer is no world of the problem");
    return sum;
  }
  std::vector<int> chosen(const Decomposition& parts, const Component& part) const {
    std::vector<int> labels;
    for (const int v : part.variables) labels.push_back(parts.label_in[index(v)][index(solution_.assignment[index(v)])]);
    return labels;
  }

  bool proved(Decomposition& parts) {
    text_ += "proved " + std::to_string(cost(parts)) + "\nworld";
    for (const int label : solution_.assignment) text_ += ' ' + std::to_string(label);
    text_ += '\n' + dropped_;
    for (Component& part : parts.components) {
      const Cost least = part.network.evaluate(chosen(parts, part));
      bool cheaper = false;
      const auto lines = refute(part, least, cheaper);
      if (cheaper) throw Error("certificate: there is a world that is cheaper than the answer");
      if (!lines) return false;
      append(part, std::to_string(least), *lines);
    }
    return true;
  }

  bool infeasible(Decomposition& parts) {
    text_ += "infeasible\n";
    if (parts.broken >= 0) return true;
    for (Component& part : parts.components) {
      bool any = false;
      const auto lines = refute(part, kTop / 2, any);
      if (any) continue;
      if (!lines) return false;
      append(part, "none", *lines);
      return true;
    }
    throw Error("certificate: the answer is 'infeasible', but there is a world");
  }

  void append(const Component& part, const std::string& bound, const std::string& lines) {
    text_ += "part " + bound;
    for (const int v : part.variables) text_ += ' ' + std::to_string(v);
    text_ += '\n' + lines;
  }

  /// The proof that no world of the part is cheaper than the limit; nothing when one is (`found`), or no room or time is left.
  std::optional<std::string> refute(Component& part, Cost limit, bool& found) {
    if (text_.size() >= options_.most_bytes) return std::nullopt;
    ProofLog log(part, options_.most_bytes - text_.size());
    Network& network = part.network;
    network.set_log(&log);
    network.set_limit(limit);
    const Search::Report nobody;
    Search search(network, budget_, nobody);
    search.log_to(log);
    const bool complete = search.enumerate({}, limit, [&](const std::vector<int>&, Cost) {
      found = true;
      return Cost{0};
    });
    network.set_log(nullptr);
    if (!complete || found || log.is_full()) return std::nullopt;
    return log.take();
  }

  const Problem& problem_;
  const Solution& solution_;
  const CertificateOptions& options_;
  Scale scale_;
  Outline outline_;
  Budget budget_;
  std::string text_, dropped_;
};

}  // namespace

std::optional<std::string> certificate(const Problem& problem, const Solution& solution,
                                       const CertificateOptions& options) {
  if (solution.outcome != Outcome::proved && solution.outcome != Outcome::infeasible)
    throw Error(std::string("certificate: the outcome is '") + to_string(solution.outcome) +
                "'; only 'proved' and 'infeasible' can be shown");
  if (solution.outcome == Outcome::proved && solution.assignment.size() != problem.variables().size())
    throw Error("certificate: the answer is not one of this problem");
  return Writer(problem, solution, options).write();
}

}  // namespace scenelore::engine
