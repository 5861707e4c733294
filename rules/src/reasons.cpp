#include "reasons.hpp"

#include <algorithm>
#include <cmath>

namespace scenelore::rules {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

int best_class(const std::vector<double>& evidence, int but) {
  int best = -1;
  for (int c = 0; c < static_cast<int>(evidence.size()); ++c) {
    if (c != but && (best < 0 || evidence[at(c)] > evidence[at(best)])) best = c;
  }
  return best;
}

const kb::Feature* find_feature(const kb::Knowledge& knowledge, const std::string& name) {
  const auto found = std::find_if(knowledge.features.begin(), knowledge.features.end(),
                                  [&](const kb::Feature& f) { return f.name == name; });
  return found == knowledge.features.end() ? nullptr : &*found;
}

/// "tilt_deg 6.3 ± 4.2 deg (typical 0.77 ± 0.63)": the value and its standard error, then the class's. μ on a log scale is that of ln x.
std::string describe_feature(const kb::Knowledge& knowledge, const FeatureReason& reason) {
  const kb::Reason::Term& c = reason.term;
  if (c.feature == kb::kKindTerm) return c.value > 0 ? "how usual kind " + number(c.value) + " is" : "how usual it is to be of no kind";
  const kb::Feature* feature = find_feature(knowledge, c.feature);
  std::string out;
  out.reserve(120);  // a run has a thousand of them
  out.append(c.feature).append(" ").append(number(c.value, 2));
  if (reason.error >= 0.05) out.append(" ± ").append(number(reason.error, 1));
  if (feature != nullptr && !feature->unit.empty() && feature->unit != "1") out.append(" ").append(feature->unit);
  if (std::isnan(c.mean)) return out;
  const bool log = feature != nullptr && feature->scale == kb::Scale::log;
  out.append(" (typical ").append(number(log ? std::exp(c.mean) : c.mean));
  out.append(log ? ", give or take a factor " : " ± ").append(number(log ? std::exp(c.sigma) : c.sigma)).append(")");
  return out;
}

struct ActiveSupports {
  const engine::Support* first = nullptr;
  double second = 0;  ///< cost without the first
};

ActiveSupports active_supports(const World& world, const engine::Requirement& requirement, double weight) {
  ActiveSupports found{.second = weight};
  for (const engine::Support& support : requirement.supports) {
    if (!world.holds(support.literal)) continue;
    if (found.first == nullptr || support.cost < found.first->cost) {
      if (found.first != nullptr) found.second = std::min(found.second, found.first->cost);
      found.first = &support;
    } else {
      found.second = std::min(found.second, support.cost);
    }
  }
  return found;
}

/// "a, b and c"
std::string in_words(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

std::string relation_phrase(const kb::ClassConstraint& row, double degree) {
  return row.relation ? *row.relation + ", " + number(degree) : std::string("present");
}

/// A histogram may decide in place of the Gaussian; what is typical of the class is told by its class_feature row all the same.
void add_typical(const kb::Knowledge& knowledge, int object_class, std::vector<kb::Contribution>& terms) {
  const std::string& name = knowledge.classes[at(object_class)].name;
  for (const kb::ClassFeature& row : knowledge.class_features) {
    if (row.object_class != name) continue;
    for (kb::Contribution& term : terms) {
      if (term.feature != row.feature || !std::isnan(term.mean)) continue;
      term.mean = row.mean;
      term.sigma = row.sigma;
    }
  }
}

/// Terms of one class against those of another, strongest first.
std::vector<FeatureReason> compared(const std::vector<kb::Contribution>& mine, const std::vector<kb::Contribution>& theirs) {
  std::vector<FeatureReason> out;
  out.reserve(std::min(mine.size(), theirs.size()));
  for (std::size_t i = 0; i < std::min(mine.size(), theirs.size()); ++i) {
    out.push_back({{mine[i].feature, mine[i].value, mine[i].mean, mine[i].sigma},
                   mine[i].weight * (mine[i].log_likelihood - theirs[i].log_likelihood), mine[i].error});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const FeatureReason& a, const FeatureReason& b) { return std::abs(a.gain) > std::abs(b.gain); });
  return out;
}

std::string feature_sentence(const std::string& described, double gain, const std::string& mine, const std::string& theirs) {
  std::string out;
  out.reserve(described.size() + mine.size() + theirs.size() + 40);
  out.append(described).append(": ").append(number(std::abs(gain)));
  out.append(gain < 0 ? " against " : " for ").append(mine);
  out.append(gain < 0 ? ", for " : " against ").append(theirs);
  return out;
}

}  // namespace

std::vector<kb::Reason> feature_reasons(const Case& about, int plane, int object_class, int against) {
  std::vector<kb::Reason> out;
  if (about.scene.features.values.size() != about.scene.planes.size()) return out;
  std::vector<std::vector<kb::Contribution>> terms =
      kb::contributions(about.knowledge, about.scene.features, {{at(plane), at(object_class)}, {at(plane), at(against)}});
  add_typical(about.knowledge, object_class, terms[0]);
  const std::string &mine = about.class_name(object_class), &theirs = about.class_name(against);
  for (const FeatureReason& reason : compared(terms[0], terms[1])) {
    out.push_back({.plane = about.id(plane), .object_class = mine, .kind = "feature", .amount = reason.gain,
                   .sentence = feature_sentence(describe_feature(about.knowledge, reason), reason.gain, mine, theirs),
                   .term = reason.term, .against = theirs});
  }
  return out;
}

std::string name_difference(const Case& about, const World& to, const Difference& difference, int subject) {
  if (difference.row >= 0) return about.quoted(about.knowledge.constraints[at(difference.row)]);
  if (difference.plane == subject) return "its features";
  return "plane " + std::to_string(about.id(difference.plane)) + " as " + about.class_name(to.class_of(difference.plane));
}

void Reasoner::add(int plane, const char* kind, double amount, std::string sentence, const kb::ClassConstraint* row,
                   int other) {
  kb::Reason reason{.plane = about_.id(plane), .object_class = about_.class_name(best_.class_of(plane)), .kind = kind,
                    .amount = amount, .sentence = std::move(sentence)};
  if (row != nullptr) reason.constraint_name = row->name;
  if (other >= 0) reason.other_plane = about_.id(other);
  by_plane_[at(plane)].push_back(std::move(reason));
}

Reasoner::Reasoner(const Case& about, const World& best) : about_(about), best_(best), by_plane_(about.scene.planes.size()) {
  for (int plane = 0; plane < about.planes(); ++plane) index_[about.id(plane)] = plane;
  std::vector<std::pair<std::size_t, std::size_t>> entries;  // the plane's own class, then its rival
  for (int plane = 0; plane < about.planes(); ++plane) {
    const int own = best.class_of(plane), rival = best_class(about.evidence[at(plane)], own);
    rivals_.push_back(rival);
    entries.emplace_back(at(plane), at(own));
    entries.emplace_back(at(plane), at(std::max(rival, 0)));
  }
  if (about.scene.features.values.size() != about.scene.planes.size()) return;
  std::vector<std::vector<kb::Contribution>> terms = kb::contributions(about.knowledge, about.scene.features, entries);
  for (std::size_t i = 0; i + 1 < terms.size(); i += 2) {
    add_typical(about.knowledge, best.class_of(static_cast<int>(i / 2)), terms[i]);
    mine_.push_back(std::move(terms[i]));
    theirs_.push_back(std::move(terms[i + 1]));
  }
}

/// The features that tell the class from its strongest rival, by what they add.
std::string Reasoner::strongest_features(const std::vector<FeatureReason>& strongest, const std::vector<std::string>& described) const {
  std::string fits, odd;
  for (std::size_t i = 0; i < std::min<std::size_t>(strongest.size(), 3); ++i) {
    if (std::abs(strongest[i].gain) < 0.1) continue;
    std::string& list = strongest[i].gain > 0 ? fits : odd;
    list += (list.empty() ? "" : ", ") + described[i];
  }
  std::string out;
  if (!fits.empty()) out += "; for it: " + fits;
  if (!odd.empty()) out += "; against it: " + odd;
  return out;
}

void Reasoner::add_evidence(int plane) {
  const int object_class = best_.class_of(plane);
  const std::vector<double>& p = about_.evidence[at(plane)];
  const int rival = rivals_[at(plane)];
  const double most = std::exp(-kImpossibleEvidence);
  const double amount =
      rival < 0 ? 0 : std::log(std::max(p[at(object_class)], most)) - std::log(std::max(p[at(rival)], most));
  std::string sentence = "from features alone " + number(p[at(object_class)]);
  if (rival >= 0) {
    sentence += std::string(amount < 0 ? ", which prefer " : ", before ") + about_.class_name(rival) + " with " + number(p[at(rival)]);
  }
  const std::vector<FeatureReason> strongest =
      mine_.empty() || rival < 0 ? std::vector<FeatureReason>{} : compared(mine_[at(plane)], theirs_[at(plane)]);
  std::vector<std::string> described;
  described.reserve(strongest.size());
  for (const FeatureReason& reason : strongest) described.push_back(describe_feature(about_.knowledge, reason));
  add(plane, "evidence", amount, sentence + strongest_features(strongest, described));
  if (rival < 0) return;
  const std::string &mine = about_.class_name(object_class), &theirs = about_.class_name(rival);
  by_plane_[at(plane)].back().against = theirs;
  by_plane_[at(plane)].reserve(by_plane_[at(plane)].size() + 2 * strongest.size());
  for (std::size_t i = 0; i < strongest.size(); ++i) {
    add(plane, "feature", strongest[i].gain, feature_sentence(described[i], strongest[i].gain, mine, theirs));
    by_plane_[at(plane)].back().term = strongest[i].term;
    by_plane_[at(plane)].back().against = theirs;
  }
}

void Reasoner::add_truth(int plane) {
  add(plane, "truth", 0, "plane " + std::to_string(about_.id(plane)) + " is " + about_.class_name(best_.class_of(plane)) +
                             " because a truth row says so");
}

void Reasoner::add_floor() {
  if (!about_.compiled.floor || about_.compiled.floor->plane < 0) return;
  const FloorStart& floor = *about_.compiled.floor;
  const std::string share = number(floor.probability) + (floor.found ? ", at least " : ", less than ") +
                            number(floor.threshold) + " by its features";
  const std::string who = "plane " + std::to_string(about_.id(floor.plane));
  add(floor.plane, "floor", 0,
      floor.found ? who + " is the floor to start from: the lowest plane that is likely enough (" + share + ")"
                  : "no floor to start from: " + who + " comes closest (" + share + ")");
}

void Reasoner::add_rival(int plane, const kb::Label& label, const World* rival) {
  if (rival == nullptr) return;
  std::string sentence = "next best: " + label.runner_up.value_or("?") + ", costs " + number(label.margin) + " more";
  const char* separator = " (";
  const kb::ClassConstraint* row = nullptr;
  int named = 0;
  for (const Difference& d : differences(about_, best_, *rival)) {
    if (d.amount <= 0 || named == 3) break;
    if (named++ == 0 && d.row >= 0) row = &about_.knowledge.constraints[at(d.row)];
    sentence += separator + name_difference(about_, *rival, d, plane) + " " + number(d.amount);
    separator = ", ";
  }
  add(plane, "runner_up", label.margin, named > 0 ? sentence + ")" : sentence, row);
  by_plane_[at(plane)].back().against = label.runner_up;
}

/// The tuple of a Lua constraint that holds best in the world with plane `a` first; nullptr when none does.
const TupleConstraint::Tuple* Reasoner::best_tuple(const TupleConstraint& constraint, int a) const {
  const TupleConstraint::Tuple* best = nullptr;
  for (const TupleConstraint::Tuple& tuple : constraint.tuples) {
    if (tuple.planes[0] != about_.id(a) || (best != nullptr && best->degree >= tuple.degree)) continue;
    bool holds = true;
    for (std::size_t i = 0; i < tuple.planes.size(); ++i) {
      holds = holds && about_.class_name(best_.class_of(index_.at(tuple.planes[i]))) == constraint.classes[i];
    }
    if (holds) best = &tuple;
  }
  return best;
}

/// "flat_screen 4 and table 2": the planes of a tuple but one.
std::string Reasoner::others(const std::vector<kb::PlaneId>& planes, kb::PlaneId but) const {
  std::vector<std::string> names;
  for (const kb::PlaneId id : planes) {
    if (id != but) names.push_back(best_.named(index_.at(id)));
  }
  return in_words(names);
}

/// For each requirement that a plane keeps alone thanks to another one, the reason of the one and of the other.
void Reasoner::add_supports(const std::vector<double>& margins) {
  const engine::Constraints constraints = about_.compiled.problem.constraints();
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    const auto* requirement = constraints[c].as<engine::Requirement>();
    if (requirement == nullptr || !best_.holds(requirement->literal)) continue;
    const ActiveSupports found = active_supports(best_, *requirement, constraints[c].weight);
    if (found.first == nullptr) continue;
    if (about_.compiled.origins[c].is_definition()) continue;
    const kb::ClassConstraint& row = about_.row(static_cast<int>(c));
    const int a = about_.compiled.origins[c].a;
    if (const TupleConstraint* tuples = about_.facts.tuples(row)) {
      add_tuple_support(row, *best_tuple(*tuples, a), found.second - found.first->cost, margins[at(a)]);
      continue;
    }
    const int b = about_.compiled.plane_of_variable[at(found.first->literal.variable)];
    const double degree = row.relation ? about_.facts.degree(*row.relation, a, b) : 1;
    double amount = found.second - found.first->cost;
    std::string without = amount < 0.005 ? "; another one would do" : "; without it " + number(amount) + " more";
    if (std::isinf(amount)) {
      amount = std::isinf(margins[at(a)]) ? 0 : margins[at(a)];
      without = "; without it the plane could not be " + about_.class_name(best_.class_of(a));
    }
    const std::string how = " (" + relation_phrase(row, degree) + ")";
    add(a, "support", amount, "thanks to " + best_.named(b) + how + ": " + about_.quoted(row) + without, &row, b);
    if (amount > 0) {
      add(b, "support", amount, best_.named(a) + " relies on it" + how + ": " + about_.quoted(row), &row, a);
    }
  }
}

/// `some` over several planes: the reason of the first plane, and of those it leans on.
void Reasoner::add_tuple_support(const kb::ClassConstraint& row, const TupleConstraint::Tuple& tuple, double amount, double margin) {
  const int a = index_.at(tuple.planes[0]);
  std::string without = amount < 0.005 ? "; others would do" : "; without them " + number(amount) + " more";
  if (std::isinf(amount)) {
    amount = std::isinf(margin) ? 0 : margin;
    without = "; without them the plane could not be " + about_.class_name(best_.class_of(a));
  }
  const std::string how = " (degree " + number(tuple.degree) + ")";
  add(a, "support", amount, "thanks to " + others(tuple.planes, tuple.planes[0]) + how + ": " + about_.quoted(row) + without, &row,
      index_.at(tuple.planes[1]));
  for (std::size_t i = 1; amount > 0 && i < tuple.planes.size(); ++i) {
    add(index_.at(tuple.planes[i]), "support", amount, best_.named(a) + " relies on it" + how + ": " + about_.quoted(row), &row, a);
  }
}

void Reasoner::add_tuple_violation(const kb::ClassConstraint& row, const TupleConstraint& tuples, const engine::Violation& violation) {
  const ConstraintOrigin& origin = about_.compiled.origins[at(violation.constraint)];
  const std::string pays = "pays " + number(violation.amount) + " for " + about_.quoted(row) + ": ";
  if (tuples.quantifier == kb::Quantifier::some) {
    const TupleConstraint::Tuple* best = best_tuple(tuples, origin.a);
    if (best != nullptr) {
      return add(origin.a, "violation", -violation.amount,
                 pays + "the best is with " + others(best->planes, best->planes[0]) + " (degree " + number(best->degree) + ")", &row,
                 index_.at(best->planes[1]));
    }
    const std::vector<std::string> classes(tuples.classes.begin() + 1, tuples.classes.end());
    return add(origin.a, "violation", -violation.amount, pays + "there is no " + in_words(classes) + " for which it holds", &row);
  }
  std::vector<kb::PlaneId> planes{about_.id(origin.a), about_.id(origin.b)};
  if (const auto more = about_.compiled.more_planes.find(violation.constraint); more != about_.compiled.more_planes.end()) {
    for (const int plane : more->second) planes.push_back(about_.id(plane));
  }
  const auto tuple = std::find_if(tuples.tuples.begin(), tuples.tuples.end(), [&](const auto& t) { return t.planes == planes; });
  const std::string how = tuple == tuples.tuples.end() ? "" : " (degree " + number(tuple->degree) + ")";
  for (const kb::PlaneId plane : planes) {
    add(index_.at(plane), "violation", -violation.amount, pays + "with " + others(planes, plane) + how, &row,
        index_.at(plane == planes[0] ? planes[1] : planes[0]));
  }
}

void Reasoner::add_violation(const engine::Violation& violation) {
  const ConstraintOrigin& origin = about_.compiled.origins[at(violation.constraint)];
  const engine::ConstraintView constraint = about_.compiled.problem.constraints()[at(violation.constraint)];
  const kb::ClassConstraint& row = about_.row(violation.constraint);
  if (const TupleConstraint* tuples = about_.facts.tuples(row)) return add_tuple_violation(row, *tuples, violation);
  const std::string pays = "pays " + number(violation.amount) + " for " + about_.quoted(row) + ": ";
  const std::string other_class = row.other_class ? *row.other_class : std::string("other plane");
  if (const auto* requirement = constraint.as<engine::Requirement>()) {
    const ActiveSupports found = active_supports(best_, *requirement, constraint.weight);
    if (found.first == nullptr) {
      return add(origin.a, "violation", -violation.amount,
                 pays + "no " + other_class + (row.relation ? " for which '" + *row.relation + "' holds" : ""), &row);
    }
    const int b = about_.compiled.plane_of_variable[at(found.first->literal.variable)];
    return add(origin.a, "violation", -violation.amount,
               pays + "the best is " + best_.named(b) + " (" +
                   relation_phrase(row, row.relation ? about_.facts.degree(*row.relation, origin.a, b) : 1) + ")",
               &row, b);
  }
  if (const auto* body = constraint.as<engine::Cardinality>()) {
    const auto count = std::count_if(body->literals.begin(), body->literals.end(), [&](auto l) { return best_.holds(l); });
    const std::string found = pays + std::to_string(count) + " found, " +
                              (row.quantifier == kb::Quantifier::at_most ? "at most " : "at least ") +
                              std::to_string(row.count.value_or(0)) + " wanted";
    if (origin.a >= 0) return add(origin.a, "violation", -violation.amount, found, &row);
    for (const engine::Literal& literal : body->literals) {
      const int plane = about_.compiled.plane_of_variable[at(literal.variable)];
      if (best_.holds(literal)) add(plane, "violation", -violation.amount, found, &row);
    }
    return;
  }
  const double degree = row.relation ? about_.facts.degree(*row.relation, origin.a, origin.b) : 1;
  const std::string how = " (" + relation_phrase(row, degree) + ")";
  add(origin.a, "violation", -violation.amount, pays + best_.named(origin.b) + how, &row, origin.b);
  add(origin.b, "violation", -violation.amount, pays + best_.named(origin.a) + how, &row, origin.a);
}

void Reasoner::add_violations() {
  for (const engine::Violation& violation : best_.violations()) {
    if (violation.amount >= 0.005) add_violation(violation);
  }
}

std::vector<kb::Reason> Reasoner::take() {
  std::vector<kb::Reason> out;
  std::size_t count = 0;
  for (const std::vector<kb::Reason>& list : by_plane_) count += list.size();
  out.reserve(count);
  for (std::vector<kb::Reason>& list : by_plane_) {
    std::move(list.begin(), list.end(), std::back_inserter(out));
  }
  return out;
}

}  // namespace scenelore::rules
