// Writes down what a search does to one component, in the words of a certificate (see certificate.hpp).
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "component.hpp"

namespace scenelore::engine {

class ProofLog {
 public:
  /// The component's network is closed. `most`: bytes after which nothing is written any more.
  ProofLog(const Component& component, std::size_t most);

  /// A cell of the network has another cost: written down when something is drawn from it.
  void changed(int cell);
  void struck(int v, int label);
  void assumed(int v, int label);
  /// The newest assumption that stands leads nowhere.
  void refuted();
  /// Writes down what has changed last.
  void finish() { write_changes(); }

  bool is_full() const { return text_.size() > most_; }
  std::string take() { return std::move(text_); }

 private:
  struct Shift {
    int pair_x = -1, pair_y = -1;  ///< variables of the problem; −1: a constraint
    int constraint = -1;
    Literal literal{-1, -1};
  };
  Literal in_problem(int v, int label) const;
  void write_changes();
  void line(std::initializer_list<long long> numbers, char word);

  const Component& component_;
  std::size_t most_;
  std::vector<Shift> shifts_;  ///< by cell
  std::vector<int> changed_;   ///< cells, each once
  std::vector<char> is_changed_;
  std::string text_;
};

}  // namespace scenelore::engine
