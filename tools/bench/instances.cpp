#include "instances.hpp"

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace scenelore::bench {

namespace {

using engine::kHard;
using engine::Literal;
using engine::PairTable;
using engine::Problem;

/// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
  double real() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double gauss() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += real();
    return sum;
  }

 private:
  std::uint64_t state_;
};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<std::string> numbered(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.push_back("l" + std::to_string(i));
  return names;
}

constexpr int kRelations = 6;

/// Adds one room's planes and constraints to `problem`. `truth`: by how much the true class is cheaper; 0 = none is true.
void add_planes(Problem& problem, Random& random, int planes, int classes, double noise, double truth) {
  const int first = static_cast<int>(problem.variables().size());
  std::vector<int> real;
  for (int p = 0; p < planes; ++p) {
    std::vector<double> costs;
    double sum = 0;
    real.push_back(random.below(classes));
    for (int c = 0; c < classes; ++c) costs.push_back(noise * random.gauss() - (c == real.back() ? truth : 0));
    for (const double cost : costs) sum += std::exp(-cost);
    for (double& cost : costs) cost = std::max(0.0, cost + std::log(sum));
    problem.add_variable("p" + std::to_string(first + p), numbered(classes), costs);
  }
  std::vector<std::vector<double>> relations;
  std::vector<int> tables;
  for (int r = 0; r < kRelations; ++r) {
    std::vector<double> costs;
    for (int i = 0; i < classes * classes; ++i) costs.push_back(random.real() < 0.06 ? 1 : 0);
    tables.push_back(problem.add_table(classes, classes, costs));
    relations.push_back(std::move(costs));
  }
  for (int a = 0; a < planes; ++a)
    for (int b = a + 1; b < planes; ++b) {
      int r = random.below(kRelations);
      for (int i = 0; i < kRelations && truth > 0 && relations[at(r)][at(real[at(a)] * classes + real[at(b)])] > 0; ++i)
        r = (r + 1) % kRelations;
      problem.add("pair", kHard, -1, PairTable{first + a, first + b, tables[at(r)]});
    }
  for (int a = 0; a < planes; ++a) {
    engine::Requirement needs{{first + a, 0}, {}};
    for (int b = 0; b < planes; ++b)
      if (b != a && random.real() < 0.3) needs.supports.push_back({{first + b, 1}, 0});
    for (int i = 0, b = random.below(planes); i < planes && truth > 0; ++i, b = (b + 1) % planes)
      if (b != a && real[at(b)] == 1) {
        needs.supports.push_back({{first + b, 1}, 0});
        break;
      }
    problem.add("screen needs table", kHard, -1, needs);
  }
}

}  // namespace

Problem random_planes(std::uint64_t seed, int planes, int classes) {
  Random random(seed);
  Problem problem;
  add_planes(problem, random, planes, classes, 1, 0);
  return problem;
}

Problem noisy_room(std::uint64_t seed, int planes, int classes) {
  Random random(seed);
  Problem problem;
  add_planes(problem, random, planes, classes, 1, 2.5);
  return problem;
}

Problem building(std::uint64_t seed, int rooms, int planes) {
  Random random(seed);
  Problem problem;
  for (int room = 0; room < rooms; ++room) add_planes(problem, random, planes, 8, 1, 2.5);
  return problem;
}

Problem max_csp(std::uint64_t seed, int variables, int labels, double density, double tightness) {
  Random random(seed);
  Problem problem;
  for (int v = 0; v < variables; ++v)
    problem.add_variable("v" + std::to_string(v), numbered(labels), std::vector<double>(at(labels), 0.0));
  for (int a = 0; a < variables; ++a)
    for (int b = a + 1; b < variables; ++b) {
      if (random.real() >= density) continue;
      std::vector<double> costs;
      for (int i = 0; i < labels * labels; ++i) costs.push_back(random.real() < tightness ? 1 : 0);
      problem.add("c", 1, -1, PairTable{a, b, problem.add_table(labels, labels, costs)});
    }
  return problem;
}

Problem grid_mrf(std::uint64_t seed, int side, int labels) {
  Random random(seed);
  Problem problem;
  for (int v = 0; v < side * side; ++v) {
    std::vector<double> costs;
    for (int l = 0; l < labels; ++l) costs.push_back(random.real() * 2);
    problem.add_variable("v" + std::to_string(v), numbered(labels), costs);
  }
  std::vector<double> differ;
  for (int i = 0; i < labels * labels; ++i) differ.push_back(i % (labels + 1) == 0 ? 0 : 1);
  const int table = problem.add_table(labels, labels, differ);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (x + 1 < side) problem.add("right", 0.2 + random.real(), -1, PairTable{y * side + x, y * side + x + 1, table});
      if (y + 1 < side) problem.add("down", 0.2 + random.real(), -1, PairTable{y * side + x, (y + 1) * side + x, table});
    }
  return problem;
}

Problem warehouses(std::uint64_t seed, int count, int customers) {
  Random random(seed);
  Problem problem;
  std::vector<std::pair<double, double>> sites;
  for (int w = 0; w < count; ++w) {
    sites.emplace_back(random.real(), random.real());
    problem.add_variable("w" + std::to_string(w), {"closed", "open"}, {0, 1 + random.real()});
  }
  for (int c = 0; c < customers; ++c) {
    const double x = random.real(), y = random.real();
    std::vector<double> costs;
    for (const auto& [sx, sy] : sites) costs.push_back(3 * std::hypot(sx - x, sy - y));
    problem.add_variable("c" + std::to_string(c), numbered(count), costs);
  }
  for (int c = 0; c < customers; ++c)
    for (int w = 0; w < count; ++w) problem.add("served by an open one", kHard, -1, engine::Conflict{{w, 0}, {count + c, w}});
  return problem;
}

Problem radio_links(std::uint64_t seed, int links, int frequencies) {
  Random random(seed);
  Problem problem;
  for (int v = 0; v < links; ++v) {
    std::vector<double> costs;
    for (int f = 0; f < frequencies; ++f) costs.push_back(random.real() * 0.5);
    problem.add_variable("link" + std::to_string(v), numbered(frequencies), costs);
  }
  std::vector<int> tables;
  for (int distance = 1; distance <= 4; ++distance) {
    std::vector<double> costs;
    for (int a = 0; a < frequencies; ++a)
      for (int b = 0; b < frequencies; ++b) costs.push_back(std::abs(a - b) < distance ? 1 : 0);
    tables.push_back(problem.add_table(frequencies, frequencies, costs));
  }
  for (int a = 0; a < links; ++a)
    for (int i = 0; i < 3; ++i) {
      const int b = (a + 1 + random.below(links / 4)) % links;
      if (b == a) continue;
      problem.add("apart", random.real() < 0.2 ? kHard : 1 + random.below(5), -1, PairTable{a, b, tables[at(random.below(4))]});
    }
  return problem;
}

}  // namespace scenelore::bench
