#include "proof_log.hpp"

#include <algorithm>
#include <type_traits>

namespace scenelore::engine {

ProofLog::ProofLog(const Component& component, std::size_t most)
    : component_(component), most_(most) {
  component.network.for_each_shift([&](int cell, const auto& function, int v, int label) {
    const auto i = static_cast<std::size_t>(cell);
    if (i >= shifts_.size()) shifts_.resize(i + 1);
    Shift& shift = shifts_[i];
    shift.literal = in_problem(v, label);
    if constexpr (std::is_same_v<std::decay_t<decltype(function)>, BinaryFunction>) {
      shift.pair_x = component.variables[static_cast<std::size_t>(function.x)];
      shift.pair_y = component.variables[static_cast<std::size_t>(function.y)];
    } else {
      shift.constraint = function.constraint;
    }
  });
  is_changed_.resize(shifts_.size(), 0);
}

Literal ProofLog::in_problem(int v, int label) const {
  const auto place = static_cast<std::size_t>(v);
  return {component_.variables[place], component_.labels[place][static_cast<std::size_t>(label)]};
}

void ProofLog::line(std::initializer_list<long long> numbers, char word) {
  if (is_full()) return;
  text_ += word;
  for (const long long number : numbers) text_ += ' ' + std::to_string(number);
  text_ += '\n';
}

void ProofLog::changed(int cell) {
  const auto i = static_cast<std::size_t>(cell);
  if (i >= shifts_.size() || shifts_[i].literal.variable < 0 || is_changed_[i] != 0) return;
  is_changed_[i] = 1;
  changed_.push_back(cell);
}

void ProofLog::write_changes() {
  for (const int cell : changed_) {
    const auto i = static_cast<std::size_t>(cell);
    const Shift& shift = shifts_[i];
    const long long amount = component_.network.cost_at(cell);
    if (shift.constraint < 0)
      line({shift.pair_x, shift.pair_y, shift.literal.variable, shift.literal.label, amount}, 'p');
    else
      line({shift.constraint, shift.literal.variable, shift.literal.label, amount}, 'c');
    is_changed_[i] = 0;
  }
  changed_.clear();
}

void ProofLog::struck(int v, int label) {
  write_changes();
  const Literal gone = in_problem(v, label);
  line({gone.variable, gone.label}, '-');
}

void ProofLog::assumed(int v, int label) {
  write_changes();
  const Literal literal = in_problem(v, label);
  line({literal.variable, literal.label}, '(');
}

void ProofLog::refuted() {
  write_changes();
  line({}, ')');
}

}  // namespace scenelore::engine
