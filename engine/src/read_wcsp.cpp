// toulbar2's .wcsp: name, counts and top in the first line, then domain sizes, then one function after the other: arity,
// variables, default cost, number of tuples, tuples with costs. A negative arity marks a function whose tuples others
// share by giving minus its number (from 1) as their number of tuples.
#include <cmath>

#include "file_reader.hpp"

namespace scenelore::engine {
namespace {

constexpr long long kMostCount = 1'000'000'000;

struct Shared {
  std::vector<std::size_t> sizes;
  std::vector<double> costs;
};

class WcspReader {
 public:
  explicit WcspReader(FileText& text) : text_(text) {}

  ProblemFile read() {
    text_.next();  // name
    const long long count = text_.integer("the number of variables", 0, static_cast<long long>(text_.size()));
    text_.integer("the largest domain size", 0, kMostCount);
    const long long functions = text_.integer("the number of functions", 0, static_cast<long long>(text_.size()));
    const double top = text_.number("the top cost");
    if (!(top > 0)) text_.fail("the top cost must be above 0");
    builder_.set_top(top);
    long long labels = 0;
    for (long long v = 0; v < count; ++v) {
      const long long size = text_.integer("a domain size (from 1; intervals, written as negative ones, are not supported)",
                                           1, kMostLabels);
      labels += size;
      if (labels > kMostLabels) text_.fail("the domains are too large together");
      std::vector<std::string> names;
      for (long long l = 0; l < size; ++l) names.push_back(std::to_string(l));
      builder_.add_variable("x" + std::to_string(v), std::move(names));
    }
    for (long long f = 0; f < functions; ++f) function("f" + std::to_string(f));
    if (!text_.at_end()) text_.fail("the file goes on after its last function");
    return builder_.finish();
  }

 private:
  void function(const std::string& name) {
    const long long arity = text_.integer("the arity of a function", -1000, 1000);
    std::vector<int> scope;
    std::vector<std::size_t> sizes;
    for (long long i = 0; i < std::abs(arity); ++i) {
      scope.push_back(static_cast<int>(text_.integer("a variable of a function", 0, builder_.variables() - 1)));
      sizes.push_back(builder_.labels(scope.back()).size());
      for (std::size_t j = 0; j + 1 < scope.size(); ++j)
        if (scope[j] == scope.back()) text_.fail("a function names variable " + std::to_string(scope[j]) + " twice");
    }
    const std::size_t size = builder_.tuples(scope);
    if (size > FileBuilder::kMostTuples) text_.fail("the function has too many tuples");
    const double other = text_.number("the default cost of a function");
    if (other == -1 && !text_.at_end()) {
      const std::string word(text_.peek());
      if (word.find_first_not_of("-0123456789") != std::string::npos)
        text_.fail("the global cost function '" + word + "' is not supported; write it as tables");
    }
    const long long listed = text_.integer("the number of tuples of a function", -kMostCount, kMostCount);
    if (listed < 0) return builder_.add_function(name, scope, shared(listed, sizes));
    std::vector<double> costs(size, other);
    for (long long t = 0; t < listed; ++t) {
      std::size_t place = 0;
      for (const std::size_t labels : sizes)
        place = place * labels +
                static_cast<std::size_t>(text_.integer("a label of a tuple", 0, static_cast<long long>(labels) - 1));
      costs[place] = text_.number("the cost of a tuple");
    }
    if (arity < 0) shared_.push_back({sizes, costs});
    builder_.add_function(name, scope, std::move(costs));
  }

  std::vector<double> shared(long long listed, const std::vector<std::size_t>& sizes) {
    if (-listed > static_cast<long long>(shared_.size()))
      text_.fail("there is no shared function " + std::to_string(-listed));
    const Shared& other = shared_[static_cast<std::size_t>(-listed - 1)];
    if (other.sizes != sizes) text_.fail("the shared function " + std::to_string(-listed) + " has other domain sizes");
    return other.costs;
  }

  FileText& text_;
  FileBuilder builder_;
  std::vector<Shared> shared_;
};

}  // namespace

ProblemFile read_wcsp(FileText& text) { return WcspReader(text).read(); }

}  // namespace scenelore::engine
