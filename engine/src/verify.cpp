#include <algorithm>
#include <istream>
#include <numeric>
#include <optional>
#include <sstream>

#include "exact_part.hpp"
#include "scenelore/engine/certificate.hpp"
#include "scenelore/engine/checker.hpp"

namespace scenelore::engine {
namespace {

using exact::kNever;
using exact::Part;
using exact::Refused;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

class Verifier {
 public:
  Verifier(const Problem& problem, std::istream& in)
      : problem_(problem), in_(in), scale_(problem), constraints_of_(exact::constraints_of(problem)) {
    for (const Variable& variable : problem.variables()) {
      live_.emplace_back(variable.labels.size(), char{1});
      const Cost least = scale_.whole(*std::min_element(variable.costs.begin(), variable.costs.end()));
      cheapest_.push_back(is_forbidden(least) ? kNever : least);
      cheapest_sum_ = exact::plus(cheapest_sum_, cheapest_.back());
    }
    taken_.assign(problem.variables().size(), 0);
  }

  Verdict run() {
    Verdict verdict;
    try {
      header(verdict);
      while (next()) step();
      finish(verdict);
      verdict.accepted = true;
    } catch (const Refused& refusal) {
      verdict.reason = "line " + std::to_string(line_) + ": " + refusal.what();
    }
    return verdict;
  }

 private:
  struct Assumption {
    std::size_t mark;
    Literal literal;
  };

  // --- reading ---
  bool next() {
    std::string text;
    if (!std::getline(in_, text)) return false;
    ++line_;
    words_ = std::istringstream(text);
    if (!(words_ >> word_)) throw Refused("the line is empty");
    return true;
  }
  void require_next(const char* what) {
    if (!next()) {
      ++line_;
      throw Refused(std::string(what) + " is expected");
    }
  }
  Cost number() {
    Cost value = 0;
    if (!(words_ >> value)) throw Refused("a whole number is expected");
    return value;
  }
  int variable() {
    const Cost v = number();
    if (v < 0 || v >= static_cast<Cost>(problem_.variables().size())) throw Refused("there is no variable " + std::to_string(v));
    return static_cast<int>(v);
  }
  Literal literal() {
    const int v = variable();
    const Cost label = number();
    if (label < 0 || label >= static_cast<Cost>(live_[index(v)].size()))
      throw Refused("variable '" + name(v) + "' has no label " + std::to_string(label));
    return {v, static_cast<int>(label)};
  }
  void line_ends() {
    std::string more;
    if (words_ >> more) throw Refused("'" + more + "' is one word too many");
  }
  std::string name(int v) const { return problem_.variables()[index(v)].name; }

  // --- what is claimed ---
  void header(Verdict& verdict) {
    std::string format, version;
    require_next("'scenelore certificate 1'");
    if (word_ != "scenelore" || !(words_ >> format >> version) || format != "certificate" || version != "1")
      throw Refused("'scenelore certificate 1' is expected");
    line_ends();
    require_next("'proved' or 'infeasible'");
    verdict.cost = kHard;
    verdict.outcome = word_ == "proved" ? Outcome::proved : Outcome::infeasible;
    if (word_ == "proved") {
      claim_ = number();
      line_ends();
      world(verdict);
    } else if (word_ == "infeasible") {
      line_ends();
    } else {
      throw Refused("'proved' or 'infeasible' is expected, not '" + word_ + "'");
    }
  }

  void world(Verdict& verdict) {
    require_next("'world' with a label for each variable");
    if (word_ != "world") throw Refused("'world' is expected, not '" + word_ + "'");
    std::vector<std::vector<char>> only;
    for (std::size_t v = 0; v < live_.size(); ++v) {
      const Cost label = number();
      if (label < 0 || label >= static_cast<Cost>(live_[v].size()))
        throw Refused("variable '" + name(static_cast<int>(v)) + "' has no label " + std::to_string(label));
      verdict.assignment.push_back(static_cast<int>(label));
      only.emplace_back(live_[v].size(), char{0})[static_cast<std::size_t>(label)] = 1;
    }
    line_ends();
    const Check checked = check(problem_, verdict.assignment);
    if (!checked.valid) throw Refused("this world breaks a hard constraint");
    std::vector<int> all(live_.size());
    std::iota(all.begin(), all.end(), 0);
    const Cost cost = exact::plus(Part(problem_, scale_, constraints_of_, only, all).least(), constant(only));
    if (cost != claim_)
      throw Refused("this world costs " + std::to_string(cost) + " units, not " + std::to_string(claim_));
    verdict.cost = checked.cost;
    verdict.tolerance = scale_.real(scale_.slack());
  }

  /// Cardinalities none of whose literals is left.
  Cost constant(const std::vector<std::vector<char>>& live) const {
    Cost sum = 0;
    for (const ConstraintView constraint : problem_.constraints()) {
      if (constraint.as<Cardinality>() == nullptr) continue;
      const auto term = exact::make_term(problem_, scale_, constraint, live);
      if (term->scope().empty()) sum = exact::plus(sum, term->least(exact::Choice(live)));
    }
    return sum;
  }

  // --- the proof ---
  void step() {
    if (ended_) throw Refused("the certificate goes on after 'end'");
    if (word_ == "end") {
      line_ends();
      close_part();
      ended_ = true;
    } else if (word_ == "part") {
      close_part();
      open_part();
    } else if (word_ == "-") {
      const Literal gone = literal();
      line_ends();
      part_ ? strike(gone) : drop(gone);
    } else if (!part_) {
      throw Refused("'" + word_ + "' is not inside a part");
    } else if (word_ == "p") {
      const int x = variable(), y = variable();
      const Literal to = literal();
      const Cost amount = number();
      line_ends();
      part_->move_from_pair(x, y, to, amount);
    } else if (word_ == "c") {
      const Cost constraint = number();
      if (constraint < 0 || constraint >= static_cast<Cost>(problem_.constraints().size()))
        throw Refused("there is no constraint " + std::to_string(constraint));
      const Literal to = literal();
      const Cost amount = number();
      line_ends();
      part_->move_from_constraint(static_cast<int>(constraint), to, amount);
    } else if (word_ == "(") {
      assume(literal());
    } else if (word_ == ")") {
      line_ends();
      refute();
    } else {
      throw Refused("'" + word_ + "' means nothing");
    }
  }

  /// Before all parts: whatever the other labels are, this one costs too much.
  void drop(Literal gone) {
    if (parts_begun_) throw Refused("labels can be dropped only before the first part");
    const Cost own = scale_.whole(problem_.variables()[index(gone.variable)].costs[index(gone.label)]);
    const Cost others = cheapest_sum_ == kNever ? kNever : exact::minus(cheapest_sum_, cheapest_[index(gone.variable)]);
    if (!is_forbidden(own) && exact::plus(others, own) < claim_)
      throw Refused("label " + std::to_string(gone.label) + " of '" + name(gone.variable) + "' may be in a world cheaper than the claim");
    live_[index(gone.variable)][index(gone.label)] = 0;
  }

  void open_part() {
    if (!parts_begun_) proved_ = constant(live_);
    parts_begun_ = true;
    std::string bound;
    words_ >> bound;
    if (bound == "none") {
      bound_ = kNever;
    } else {
      std::istringstream text(bound);
      if (!(text >> bound_) || !text.eof()) throw Refused("'part' is followed by a whole number or 'none', not '" + bound + "'");
    }
    std::vector<int> variables;
    while (!(words_ >> std::ws).eof()) {
      variables.push_back(variable());
      char& taken = taken_[index(variables.back())];
      if (taken != 0) throw Refused("'" + name(variables.back()) + "' is in a part already");
      taken = 1;
    }
    part_.emplace(problem_, scale_, constraints_of_, live_, variables);
  }

  void strike(Literal gone) {
    if (!part_->is_live(gone)) throw Refused("the label is gone already");
    const Cost least = part_->least(gone, bound_);
    if (least < bound_)
      throw Refused("label " + std::to_string(gone.label) + " of '" + name(gone.variable) + "' may be in a world of " +
                    std::to_string(least) + " units, less than " + told(bound_));
    part_->remove(gone);
  }

  void assume(Literal literal) {
    line_ends();
    if (!part_->is_live(literal)) throw Refused("the label that is tried is gone already");
    open_.push_back({part_->mark(), literal});
    for (int label = 0; label < static_cast<int>(live_[index(literal.variable)].size()); ++label)
      if (label != literal.label && part_->is_live({literal.variable, label})) part_->remove({literal.variable, label});
  }

  void require_bound() {
    const Cost least = part_->least(bound_);
    if (least < bound_)
      throw Refused("a world of " + std::to_string(least) + " units is not ruled out, which is less than " + told(bound_));
  }

  void refute() {
    if (open_.empty()) throw Refused("there is no '(' for this ')'");
    require_bound();
    part_->undo(open_.back().mark);
    part_->remove(open_.back().literal);
    open_.pop_back();
  }

  void close_part() {
    if (!part_) return;
    if (!open_.empty()) throw Refused("a '(' has no ')'");
    require_bound();
    proved_ = exact::plus(proved_, bound_);
    part_.reset();
  }

  void finish(const Verdict& verdict) {
    ++line_;
    if (!ended_) throw Refused("'end' is missing");
    if (!parts_begun_) proved_ = constant(live_);
    if (proved_ < claim_ && verdict.outcome == Outcome::infeasible) throw Refused("no part is shown to be impossible");
    if (proved_ < claim_)
      throw Refused("the parts add up to a bound of " + std::to_string(proved_) + " units, less than the claim");
  }

  static std::string told(Cost bound) { return bound == kNever ? "impossible" : std::to_string(bound); }

  const Problem& problem_;
  std::istream& in_;
  Scale scale_;
  std::vector<std::vector<int>> constraints_of_;
  std::vector<std::vector<char>> live_;
  std::vector<Cost> cheapest_;
  Cost cheapest_sum_ = 0;
  std::vector<char> taken_;  ///< by variable: in a part
  Cost claim_ = kNever;      ///< no world costs less
  Cost bound_ = 0;           ///< of the part
  Cost proved_ = 0;          ///< bounds of the parts so far
  bool parts_begun_ = false, ended_ = false;
  std::optional<Part> part_;
  std::vector<Assumption> open_;
  int line_ = 0;
  std::istringstream words_;
  std::string word_;
};

}  // namespace

Verdict verify(const Problem& problem, std::istream& certificate) { return Verifier(problem, certificate).run(); }

}  // namespace scenelore::engine
