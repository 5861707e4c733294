#include "world.hpp"

#include <algorithm>
#include <cmath>

namespace scenelore::rules {

namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

const kb::ClassConstraint& Case::row(int constraint) const {
  return knowledge.constraints[at(compiled.origins[at(constraint)].row)];
}

std::string Case::quoted(const kb::ClassConstraint& row) const {
  return "'" + (row.message.empty() ? row.name : row.message) + "'";
}

double Case::unary(int plane, int object_class) const {
  const int variable = compiled.variable_of_plane[at(plane)];
  const int label = compiled.label_of_class[at(variable)][at(object_class)];
  return compiled.problem.variables()[at(variable)].costs[at(label)];
}

World::World(const Case& about, const engine::Solution& solution)
    : about_(about), cost_(solution.cost), assignment_(solution.assignment), violations_(solution.violations) {
  classes_.resize(about.scene.planes.size());
  for (std::size_t variable = 0; variable < classes_.size(); ++variable) {
    const int plane = about.compiled.plane_of_variable[variable];
    classes_[at(plane)] = about.compiled.class_of_label[variable][at(assignment_[variable])];
  }
}

std::string World::named(int plane) const {
  return about_.class_name(class_of(plane)) + " " + std::to_string(about_.id(plane));
}

std::vector<Difference> differences(const Case& about, const World& from, const World& to, double least) {
  std::vector<Difference> out;
  for (int plane = 0; plane < about.planes(); ++plane) {
    if (from.class_of(plane) == to.class_of(plane)) continue;
    out.push_back({.amount = about.unary(plane, to.class_of(plane)) - about.unary(plane, from.class_of(plane)),
                   .plane = plane});
  }
  std::map<int, double> by_row;
  const auto row = [&](const engine::Violation& v) { return about.compiled.origins[at(v.constraint)].row; };
  for (const engine::Violation& violation : to.violations()) by_row[row(violation)] += violation.amount;
  for (const engine::Violation& violation : from.violations()) by_row[row(violation)] -= violation.amount;
  for (const auto& [index, amount] : by_row) out.push_back({.amount = amount, .row = index});
  std::erase_if(out, [&](const Difference& d) { return std::abs(d.amount) < least; });
  std::stable_sort(out.begin(), out.end(), [](const auto& d, const auto& e) { return d.amount > e.amount; });
  return out;
}

}  // namespace scenelore::rules
