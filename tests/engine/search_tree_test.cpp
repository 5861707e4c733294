// The search tree in docs/search.md is drawn from what the search tells its observer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>

#include "random_problem.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The worked example of docs/search.md: what would do best on their own are two tables, a screen and a keyboard.
Problem small_room() {
  Problem problem;
  const std::vector<std::string> classes{"floor", "table", "screen", "keyboard"};
  problem.add_variable("low plane", classes, {0.9, 0.3, 5.6, 1.1});
  problem.add_variable("board", classes, {1.0, 1.2, 2.6, 0.8});
  problem.add_variable("panel", classes, {5.6, 1.9, 0.1, 1.1});
  problem.add_variable("small board", classes, {3.1, 1.0, 2.3, 0.8});
  Cardinality floors;
  for (int p = 0; p < 4; ++p) floors.literals.push_back({p, 0});
  floors.high = 1;
  problem.add("one floor", kHard, 0, floors);
  const auto needs_table = [&](int plane, int object_class, int table) {
    problem.add(classes[index(object_class)] + " needs table", 1.5, 0, Requirement{{plane, object_class}, {{{table, 1}, 0}}});
  };
  needs_table(0, 3, 1);
  needs_table(1, 3, 0);
  needs_table(2, 2, 1);
  needs_table(3, 3, 1);
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 3}, {0, 3}}) problem.add("one table", 2, 0, Conflict{{a, 1}, {b, 1}});
  return problem;
}

struct Node {
  std::string branch;  ///< what led here
  std::string text;    ///< what was found here
  const char* fill = "#cfd8dc";
  std::vector<int> children{};
  double x = 0, y = 0;
};

/// Keeps the tree that the search goes through.
class Tree : public Observer {
 public:
  explicit Tree(const Problem& problem) : problem_(problem) { nodes_.push_back({"all worlds", ""}); }

  void entered(std::uint64_t number) override {
    others_.clear();
    const auto known = waiting_.find(number);
    here_ = known == waiting_.end() ? 0 : known->second;
    waiting_.erase(number);
  }
  void expanded(int, Literal literal, double bound) override {
    ++expansions;
    here().text = "≥ " + number(bound) + (here().text.empty() ? "" : ", " + here().text);
    const Variable& variable = problem_.variables()[index(literal.variable)];
    const int yes = add(variable.name + " = " + variable.labels[index(literal.label)]);
    others_.push_back(add(variable.name + " ≠ " + variable.labels[index(literal.label)]));
    here_ = yes;
  }
  void pruned(int, Literal, int constraint) override {
    here().text = constraint < 0 ? "too dear" : problem_.constraints()[index(constraint)].name;
    here().fill = "#ef9a9a";
  }
  void improved(double cost) override {
    here().text += (here().text.empty() ? "world of " : ", world of ") + number(cost);
    here().fill = "#a5d6a7";
  }
  void backtracked(int depth) override {
    here_ = others_[index(depth - 1)];
    others_.resize(index(depth - 1));
  }
  void deferred(int depth, std::uint64_t number) override { waiting_[number] = others_[index(depth - 1)]; }

  std::string picture(const Solution& solution) {
    for (Node& node : nodes_)  // left alone, since a world had been found meanwhile that costs no more than its bound
      if (node.text.empty()) node.text = "too dear by then", node.fill = "#ef9a9a";
    place(0, 0);
    std::ostringstream out;
    out << std::fixed << std::setprecision(0);
    const double width = std::max(520.0, kColumn * column_ + 20), height = kRow * (deepest_ + 1) + 40;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
        << "\" font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (const Node& node : nodes_)
      for (const int child : node.children)
        out << "<line x1=\"" << node.x << "\" y1=\"" << node.y + 17 << "\" x2=\"" << nodes_[index(child)].x << "\" y2=\""
            << nodes_[index(child)].y - 17 << "\" stroke=\"#78909c\"/>\n";
    for (const Node& node : nodes_)
      out << "<rect x=\"" << node.x - 76 << "\" y=\"" << node.y - 17 << "\" width=\"152\" height=\"34\" rx=\"5\" fill=\"" << node.fill
          << "\" stroke=\"#546e7a\"/>\n<text x=\"" << node.x << "\" y=\"" << node.y - 3 << "\" text-anchor=\"middle\">" << node.branch
          << "</text>\n<text x=\"" << node.x << "\" y=\"" << node.y + 11 << "\" text-anchor=\"middle\" font-size=\"10\">" << node.text
          << "</text>\n";
    out << "<text x=\"10\" y=\"" << height - 12 << "\">" << to_string(solution.outcome) << " at " << number(solution.cost) << " after "
        << solution.nodes << " nodes. Green: a better world; red: nothing better below, and why.</text>\n</svg>\n";
    return out.str();
  }

  std::uint64_t expansions = 0;

 private:
  static constexpr double kColumn = 160, kRow = 76;
  static std::string number(double value) {
    std::ostringstream out;
    out << std::fixed << std::setprecision(1) << value;
    return out.str();
  }
  Node& here() { return nodes_[index(here_)]; }
  int add(std::string branch) {
    const int child = static_cast<int>(nodes_.size());
    nodes_.push_back({std::move(branch), "", "#eceff1"});
    here().children.push_back(child);
    return child;
  }
  /// Leaves side by side, inner nodes above the middle of their children.
  void place(int number, int depth) {
    deepest_ = std::max(deepest_, depth);
    for (const int child : nodes_[index(number)].children) place(child, depth + 1);
    Node& node = nodes_[index(number)];
    node.x = node.children.empty() ? kColumn * column_++ + 90
                                   : (nodes_[index(node.children.front())].x + nodes_[index(node.children.back())].x) / 2;
    node.y = kRow * depth + 27;
  }

  const Problem& problem_;
  std::vector<Node> nodes_;
  std::vector<int> others_;               ///< the other branches of the nodes on the path
  std::map<std::uint64_t, int> waiting_;  ///< nodes of the frontier
  int here_ = 0, deepest_ = 0, column_ = 0;
};

TEST(SearchTree, IsTheOneInTheDocs) {
  const Problem problem = small_room();
  Tree tree(problem);
  const Solution solution = Solver(problem, {.bound = Bound::paper, .observer = &tree}).solve();
  EXPECT_EQ(tree.expansions, solution.nodes);
  EXPECT_EQ(solution.cost, testing::all_worlds(problem)[0].first);
  const std::string picture = tree.picture(solution);
  if (const char* file = std::getenv("SCENELORE_DRAW")) std::ofstream(file) << picture;
  std::ostringstream shipped;
  shipped << std::ifstream(SCENELORE_SOURCE_DIR "/docs/images/search_tree.svg").rdbuf();
  EXPECT_EQ(shipped.str(), picture) << "SCENELORE_DRAW=docs/images/search_tree.svg engine_test --gtest_filter='SearchTree.*'";
}

TEST(SearchTree, IsARootAloneWithTheDefaultBound) {
  const Problem problem = small_room();
  const Solution paper = Solver(problem, {.bound = Bound::paper}).solve(), best = Solver(problem).solve();
  EXPECT_EQ(best.assignment, paper.assignment);
  EXPECT_EQ(best.nodes, 0u);
}

}  // namespace
}  // namespace scenelore::engine
