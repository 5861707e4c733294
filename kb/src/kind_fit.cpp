#include "kind_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

#include "likelihood.hpp"

namespace scenelore::kb {

namespace {

constexpr int kStarts = 8, kSteps = 100;
constexpr double kLeast = 0.005;         // of the range: no kind is sharper
// Of shares, which are counted from a few dozen samples: most are 0 or 1 in clean scans, and kinds that are made of exact zeros say nothing about
// a scan where one sample is odd.
constexpr double kLeastOfShare = 0.03;
constexpr double kDone = 1e-4;           // gain of a step, nats an example
constexpr double kVarianceExamples = 4;  // pretended, with a tenth of the class's variance
constexpr double kVarianceShare = 0.1;
constexpr double kMeanExamples = 1;      // pretended, at the class's mean

bool is_share(const Feature& feature) { return feature.scale == Scale::linear && feature.unit == "1" && feature.low == 0 && feature.high == 1; }

/// What is known of one feature of one kind.
struct Normal {
  double mean = 0, variance = 1;
};

struct FittedKind {
  double share = 1;
  std::vector<Normal> features;
};

/// What a present kind adds to the sums of a step, as if examples had said it.
struct Pretended {
  double share_examples = 0;    // for its share
  double feature_examples = 0;  // for each Gaussian: were they spread over the kinds, one plane alone would shrink a kind to itself
  std::vector<Normal> features;
};

struct Data {
  std::vector<KindExample> examples;
  std::vector<Normal> all;          // of the whole class
  std::vector<double> least;        // variance that no kind goes below
};

struct Fit {
  std::vector<FittedKind> kinds;
  double log_likelihood = -std::numeric_limits<double>::infinity();
};

Normal normal_of(const std::vector<KindExample>& examples, std::size_t feature) {
  double n = 0, sum = 0, squares = 0;
  for (const KindExample& example : examples) {
    if (std::isnan(example[feature])) continue;
    n += 1;
    sum += example[feature];
  }
  const double mean = n > 0 ? sum / n : 0;
  for (const KindExample& example : examples) {
    if (!std::isnan(example[feature])) squares += (example[feature] - mean) * (example[feature] - mean);
  }
  return {mean, n > 0 ? squares / n : 1};
}

/// ln of share · density, one a kind, by the example; returns ln of the sum.
double log_terms(const std::vector<FittedKind>& kinds, const std::vector<std::vector<double>>& constants, const KindExample& example,
                 std::vector<double>& logs) {
  logs.clear();
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    double log = std::log(kinds[k].share);
    for (std::size_t f = 0; f < example.size(); ++f) {
      if (std::isnan(example[f])) continue;
      const Normal& normal = kinds[k].features[f];
      const double far = example[f] - normal.mean;
      log -= constants[k][f] + far * far / (2 * normal.variance);
    }
    logs.push_back(log);
  }
  const double highest = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (const double log : logs) sum += std::exp(log - highest);
  return highest + std::log(sum);
}

struct Sums {
  double count = 0;
  std::vector<double> n, sum, squares;  // by feature; squares about the kind's mean of before
  explicit Sums(std::size_t features) : n(features, 0.0), sum(features, 0.0), squares(features, 0.0) {}
};

void add(Sums& sums, const KindExample& example, const FittedKind& kind, double share) {
  sums.count += share;
  for (std::size_t f = 0; f < example.size(); ++f) {
    if (std::isnan(example[f])) continue;
    const double far = example[f] - kind.features[f].mean;
    sums.n[f] += share;
    sums.sum[f] += share * far;
    sums.squares[f] += share * far * far;
  }
}

Normal posterior(const Normal& before, const Sums& sums, std::size_t f, const Data& data, const Pretended* pretended) {
  double n = sums.n[f], sum = sums.sum[f], squares = sums.squares[f];  // about before.mean
  if (pretended != nullptr) {
    const double far = pretended->features[f].mean - before.mean;
    n += pretended->feature_examples;
    sum += pretended->feature_examples * far;
    squares += pretended->feature_examples * (far * far + pretended->features[f].variance);
    const double shift = sum / n;
    return {before.mean + shift, std::max(squares / n - shift * shift, data.least[f])};
  }
  const double shift = (sum + kMeanExamples * (data.all[f].mean - before.mean)) / (n + kMeanExamples);
  const double about = std::max(0.0, squares - 2 * shift * sum + shift * shift * n);
  const double variance = (about + kVarianceExamples * kVarianceShare * data.all[f].variance) / (n + kVarianceExamples);
  return {before.mean + shift, std::max(variance, data.least[f])};
}

/// One step of expectation maximisation; returns the log-likelihood of the examples before it.
double step(const Data& data, std::vector<FittedKind>& kinds, const std::vector<Pretended>& pretended) {
  const std::size_t features = data.least.size();
  std::vector<std::vector<double>> constants;
  for (const FittedKind& kind : kinds) {
    std::vector<double>& of = constants.emplace_back();
    for (const Normal& normal : kind.features) of.push_back(0.5 * std::log(2 * std::numbers::pi * normal.variance));
  }
  std::vector<Sums> sums(kinds.size(), Sums(features));
  std::vector<double> logs;
  double log_likelihood = 0;
  for (const KindExample& example : data.examples) {
    const double all = log_terms(kinds, constants, example, logs);
    log_likelihood += all;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const double share = std::exp(logs[k] - all);
      if (share > 1e-12) add(sums[k], example, kinds[k], share);
    }
  }
  double count = 0;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const Pretended* const told = pretended.empty() ? nullptr : &pretended[k];
    for (std::size_t f = 0; f < features; ++f) kinds[k].features[f] = posterior(kinds[k].features[f], sums[k], f, data, told);
    kinds[k].share = sums[k].count + (told != nullptr ? told->share_examples : 1);
    count += kinds[k].share;
  }
  for (FittedKind& kind : kinds) kind.share /= count;
  return log_likelihood;
}

double run(const Data& data, std::vector<FittedKind>& kinds, const std::vector<Pretended>& pretended) {
  double last = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSteps; ++i) {
    const double now = step(data, kinds, pretended);
    if (now - last < kDone * static_cast<double>(data.examples.size())) return now;
    last = now;
  }
  return last;
}

double distance(const Data& data, const KindExample& a, const KindExample& b) {
  double sum = 0;
  for (std::size_t f = 0; f < a.size(); ++f) {
    if (std::isnan(a[f]) || std::isnan(b[f])) continue;
    sum += (a[f] - b[f]) * (a[f] - b[f]) / std::max(data.all[f].variance, data.least[f]);
  }
  return sum;
}

/// Seeds far apart: each next one drawn with a chance as its squared distance from those before.
std::vector<FittedKind> start(const Data& data, int count, std::mt19937_64& random) {
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };  // std's distributions differ from library to library
  std::vector<double> nearest(data.examples.size(), std::numeric_limits<double>::max());
  std::size_t chosen = std::min(data.examples.size() - 1, static_cast<std::size_t>(uniform() * static_cast<double>(data.examples.size())));
  std::vector<FittedKind> kinds;
  while (true) {
    FittedKind& kind = kinds.emplace_back();
    kind.share = 1.0 / count;
    for (std::size_t f = 0; f < data.least.size(); ++f) {
      const double value = data.examples[chosen][f];
      const double variance = data.all[f].variance / std::cbrt(static_cast<double>(count));
      kind.features.push_back({std::isnan(value) ? data.all[f].mean : value, std::max(variance, data.least[f])});
    }
    if (static_cast<int>(kinds.size()) == count) return kinds;
    double sum = 0;
    for (std::size_t i = 0; i < nearest.size(); ++i) sum += nearest[i] = std::min(nearest[i], distance(data, data.examples[i], data.examples[chosen]));
    double left = uniform() * sum;
    for (chosen = 0; chosen + 1 < nearest.size() && left >= nearest[chosen]; ++chosen) left -= nearest[chosen];
  }
}

Fit fit_new(const Data& data, int count, double least_examples) {
  std::mt19937_64 random(2014);
  Fit best;
  for (int i = 0; i < kStarts; ++i) {
    Fit fit{.kinds = start(data, count, random)};
    fit.log_likelihood = run(data, fit.kinds, {});
    if (fit.log_likelihood > best.log_likelihood) best = std::move(fit);
  }
  const double least = least_examples / static_cast<double>(data.examples.size());
  if (std::erase_if(best.kinds, [&](const FittedKind& kind) { return kind.share < least; }) > 0 && !best.kinds.empty()) run(data, best.kinds, {});
  return best;
}

Fit fit_from(const Data& data, const std::vector<const Feature*>& features, const std::vector<ClassKind>& present, double strength) {
  Fit fit;
  std::vector<Pretended> pretended;
  for (const ClassKind& kind : present) {
    FittedKind from{.share = kind.share, .features = data.all};
    for (const KindFeature& row : kind.features) {
      for (std::size_t f = 0; f < features.size(); ++f) {
        if (features[f]->name == row.feature) from.features[f] = {row.mean, std::max(row.sigma * row.sigma, data.least[f])};
      }
    }
    pretended.push_back({strength * kind.share, strength, from.features});
    fit.kinds.push_back(std::move(from));
  }
  fit.log_likelihood = run(data, fit.kinds, pretended);
  return fit;
}

}  // namespace

double least_sigma(const Feature& feature) { return range_on_scale(feature) * (is_share(feature) ? kLeastOfShare : kLeast); }

std::vector<ClassKind> fit_kinds(const std::string& object_class, std::vector<KindExample> examples, const std::vector<const Feature*>& features,
                                 const std::vector<ClassKind>& present, int most, const LearnOptions& options) {
  // NaN first; so the seeds do not depend on the order that planes came in.
  const auto before = [](double a, double b) { return std::isnan(b) ? false : std::isnan(a) || a < b; };
  std::sort(examples.begin(), examples.end(), [&](const KindExample& a, const KindExample& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), before);
  });
  Data data{.examples = std::move(examples), .all = {}, .least = {}};
  for (std::size_t f = 0; f < features.size(); ++f) {
    data.least.push_back(std::pow(least_sigma(*features[f]), 2));
    data.all.push_back(normal_of(data.examples, f));
    data.all.back().variance = std::max(data.all.back().variance, data.least.back());
  }
  const int count = std::min(most, static_cast<int>(data.examples.size()) / options.examples_per_kind);
  const bool moved = !present.empty() && options.present_strength > 0;
  if (data.examples.empty() || (!moved && count < 2)) return {};
  Fit fit = moved ? fit_from(data, features, present, options.present_strength) : fit_new(data, count, options.min_of_kind);
  if (fit.kinds.size() < 2 && !moved) return {};
  std::stable_sort(fit.kinds.begin(), fit.kinds.end(), [&](const FittedKind& a, const FittedKind& b) { return !moved && a.share > b.share; });
  double shares = 0;
  for (const FittedKind& kind : fit.kinds) shares += kind.share;
  std::vector<ClassKind> out;
  for (std::size_t k = 0; k < fit.kinds.size(); ++k) {
    ClassKind& kind = out.emplace_back();
    kind.object_class = object_class;
    kind.number = moved ? present[k].number : static_cast<int>(k) + 1;
    kind.description = moved ? present[k].description : "";
    kind.share = options.kind_share * fit.kinds[k].share / shares;
    for (std::size_t f = 0; f < features.size(); ++f) {
      kind.features.push_back({features[f]->name, fit.kinds[k].features[f].mean, std::sqrt(fit.kinds[k].features[f].variance)});
    }
  }
  return out;
}

}  // namespace scenelore::kb
