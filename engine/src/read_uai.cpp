// The .uai format of the UAI competitions: kind, number of variables, domain sizes, number of factors, scopes, then the
// tables. A factor's cost is −ln of its entry; 0 = forbidden.
#include <cmath>

#include "file_reader.hpp"

namespace scenelore::engine {

ProblemFile read_uai(FileText& text) {
  if (!text.accept("MARKOV") && !text.accept("BAYES")) text.fail("a .uai file begins with MARKOV or BAYES");
  const auto most = static_cast<long long>(text.size());
  FileBuilder builder;
  const long long count = text.integer("the number of variables", 0, most);
  long long labels = 0;
  for (long long v = 0; v < count; ++v) {
    const long long size = text.integer("a domain size", 1, kMostLabels);
    labels += size;
    if (labels > kMostLabels) text.fail("the domains are too large together");
    std::vector<std::string> names;
    for (long long l = 0; l < size; ++l) names.push_back(std::to_string(l));
    builder.add_variable("x" + std::to_string(v), std::move(names));
  }
  const long long factors = text.integer("the number of factors", 0, most);
  std::vector<std::vector<int>> scopes(static_cast<std::size_t>(factors));
  for (auto& scope : scopes) {
    for (long long i = text.integer("the size of a scope", 0, 1000); i > 0; --i) {
      scope.push_back(static_cast<int>(text.integer("a variable of a factor", 0, count - 1)));
      for (std::size_t j = 0; j + 1 < scope.size(); ++j)
        if (scope[j] == scope.back()) text.fail("a factor names variable " + std::to_string(scope[j]) + " twice");
    }
    if (builder.tuples(scope) > FileBuilder::kMostTuples) text.fail("a factor has too many entries");
  }
  for (std::size_t f = 0; f < scopes.size(); ++f) {
    const auto size = static_cast<long long>(builder.tuples(scopes[f]));
    text.integer("the number of entries of a factor, which is the product of its domain sizes,", size, size);
    std::vector<double> costs;
    for (long long i = 0; i < size; ++i) {
      const double entry = text.number("an entry of a factor");
      if (!(entry >= 0) || !std::isfinite(entry)) text.fail("an entry of a factor is negative or infinite");
      costs.push_back(entry > 0 ? -std::log(entry) : kHard);
    }
    builder.add_function("f" + std::to_string(f), scopes[f], std::move(costs));
  }
  if (!text.at_end()) text.fail("the file goes on after its last factor (evidence belongs in a file of its own)");
  return builder.finish();
}

}  // namespace scenelore::engine
