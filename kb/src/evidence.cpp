// Pre-classification. Notation: π_C prior of class C, normalised over the classes; F_i weight of feature i; x_i its value.
//
//   product:  ln P(C|Φ) = ln π_C + Σ_i F_i ln p(x_i|C) − ln Z                                                      (3)
//             where class C has kinds, ln of the mixture (5) of mixture.hpp in place of Σ_i F_i ln p(x_i|C);
//             where it has none, of that of the fallback class for the features that C has no row for;
//             what C describes among these kinds it takes over: see newcomers.hpp
//   mean:     P(C|x_i) = p(x_i|C) π_C / Σ_D p(x_i|D) π_D,   P(C|Φ) = Σ_i F_i P(C|x_i) / Σ_i F_i                    (4)
//
// (4) is equation 1 of Goldhoorn & Hartanto 2014. Sums run over the features that are known of the plane; without any,
// P(C|Φ) = π_C in both. All is computed in logarithms, so nothing underflows before the last step.
#include "scenelore/kb/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

#include "likelihood.hpp"
#include "mixture.hpp"
#include "newcomers.hpp"
#include "scenelore/perception/parallel.hpp"

namespace scenelore::kb {

namespace {

struct FeatureModel {
  const Feature* feature = nullptr;
  std::size_t column = 0;                 // in the feature table
  const std::vector<double>* errors = nullptr;
  std::vector<Likelihood> likelihoods{};  // one a class
  std::vector<bool> silent{};             // classes that have no row, so that the fallback class speaks for them
};

bool is_mean(const Knowledge& knowledge) { return knowledge.setting("combination", "product") == "mean"; }

class Model {
 public:
  Model(const Knowledge& knowledge, const FeatureTable& table);

  [[nodiscard]] std::vector<double> product(std::size_t plane) const;
  [[nodiscard]] std::vector<double> mean(std::size_t plane) const;
  [[nodiscard]] double value(const FeatureModel& model, std::size_t plane) const { return table_.values[plane][model.column]; }
  [[nodiscard]] static double error(const FeatureModel& model, std::size_t plane) { return model.errors == nullptr ? 0 : (*model.errors)[plane]; }
  [[nodiscard]] const std::vector<FeatureModel>& features() const { return features_; }
  /// The known ones of some features of a plane, in their order.
  [[nodiscard]] std::vector<MixtureInput> inputs(std::size_t plane, const std::vector<std::size_t>& features) const;
  [[nodiscard]] const std::vector<std::size_t>& in_order() const { return in_order_; }
  [[nodiscard]] const Mixtures& mixtures() const { return mixtures_; }

 private:
  void find_mixtures(const Knowledge& knowledge, double outlier_share);
  [[nodiscard]] Newcomer newcomer(std::size_t object_class, std::size_t fallback) const;

  const FeatureTable& table_;
  std::vector<double> log_priors_;
  std::vector<FeatureModel> features_;             // used ones: weight above 0 and a column in the table
  std::vector<std::size_t> in_order_, by_weight_;  // all of them
  Mixtures mixtures_;
};

// exp and normalise. Returns the probabilities; safe for any finite logarithms.
std::vector<double> normalised(std::vector<double> logs) {
  const double highest = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (double& value : logs) sum += value = std::exp(value - highest);
  for (double& value : logs) value /= sum;
  return logs;
}

std::vector<double> log_priors(const Knowledge& knowledge) {
  double sum = 0;
  for (const ObjectClass& c : knowledge.classes) sum += c.prior;
  std::vector<double> result;
  for (const ObjectClass& c : knowledge.classes) result.push_back(std::log(c.prior / sum));
  return result;
}

/// What the knowledge says about one feature, by class.
struct OfFeature {
  std::vector<const ClassFeature*> gaussians;
  std::vector<std::vector<const ClassDensity*>> bins;
};

/// One pass over the rows, of which there are thousands.
std::map<std::string_view, OfFeature> rows_by_feature(const Knowledge& knowledge) {
  std::map<std::string_view, std::size_t> number;
  for (std::size_t c = 0; c < knowledge.classes.size(); ++c) number[knowledge.classes[c].name] = c;
  std::map<std::string_view, OfFeature> out;
  for (const Feature& feature : knowledge.features) out[feature.name] = {std::vector<const ClassFeature*>(number.size()), std::vector<std::vector<const ClassDensity*>>(number.size())};
  for (const ClassFeature& row : knowledge.class_features) {
    const auto feature = out.find(row.feature);
    const auto object_class = number.find(row.object_class);
    if (feature != out.end() && object_class != number.end()) feature->second.gaussians[object_class->second] = &row;
  }
  const ClassDensity* previous = nullptr;
  std::vector<const ClassDensity*>* bins = nullptr;
  for (const ClassDensity& row : knowledge.class_densities) {
    if (previous == nullptr || previous->feature != row.feature || previous->object_class != row.object_class) {
      const auto feature = out.find(row.feature);
      const auto object_class = number.find(row.object_class);
      bins = feature == out.end() || object_class == number.end() ? nullptr : &feature->second.bins[object_class->second];
    }
    if (bins != nullptr) bins->push_back(&row);
    previous = &row;
  }
  return out;
}

Model::Model(const Knowledge& knowledge, const FeatureTable& table) : table_(table), log_priors_(log_priors(knowledge)) {
  const double outlier_share = std::strtod(knowledge.setting("outlier_share", "0").c_str(), nullptr);
  const int fallback = knowledge.fallback_index();
  std::map<std::string_view, OfFeature> rows = rows_by_feature(knowledge);
  for (const Feature& feature : knowledge.features) {
    const auto column = std::find(table.names.begin(), table.names.end(), feature.name);
    if (column == table.names.end() || feature.weight <= 0) continue;
    const auto errors = is_mean(knowledge) ? table.errors.end() : table.errors.find(feature.name);  // the paper knows none
    features_.push_back({&feature, static_cast<std::size_t>(column - table.names.begin()), errors == table.errors.end() ? nullptr : &errors->second});
    OfFeature& of = rows.at(feature.name);
    for (auto& bins : of.bins) std::sort(bins.begin(), bins.end(), [](const ClassDensity* a, const ClassDensity* b) { return a->low < b->low; });
    for (std::size_t c = 0; c < knowledge.classes.size(); ++c) {
      const bool silent = of.gaussians[c] == nullptr && of.bins[c].empty() && fallback >= 0;
      features_.back().silent.push_back(silent);
      const std::size_t like = silent ? static_cast<std::size_t>(fallback) : c;
      features_.back().likelihoods.emplace_back(feature, of.gaussians[like], of.bins[like], outlier_share, features_.back().errors != nullptr);
    }
  }
  in_order_.resize(features_.size());
  std::iota(in_order_.begin(), in_order_.end(), 0);
  by_weight_ = in_order_;
  std::stable_sort(by_weight_.begin(), by_weight_.end(), [&](std::size_t f, std::size_t g) { return features_[f].feature->weight < features_[g].feature->weight; });
  find_mixtures(knowledge, outlier_share);
}

Newcomer Model::newcomer(std::size_t object_class, std::size_t fallback) const {
  Newcomer out{.prior = std::exp(log_priors_[object_class] - log_priors_[fallback])};
  for (const FeatureModel& model : features_) {
    const Likelihood& likelihood = model.likelihoods[object_class];
    if (model.silent[object_class] || model.feature->scale == Scale::circular || std::isnan(likelihood.sigma())) continue;
    out.rows[model.feature->name] = {likelihood.mean(), likelihood.sigma(), model.feature->weight};
  }
  return out;
}

void Model::find_mixtures(const Knowledge& knowledge, double outlier_share) {
  std::vector<const Feature*> features;
  for (const FeatureModel& model : features_) features.push_back(model.feature);
  const auto kinds_of = [&](std::size_t object_class) {
    const auto is_of = [&](const ClassKind& kind) { return kind.object_class == knowledge.classes[object_class].name; };
    const auto first = std::find_if(knowledge.kinds.begin(), knowledge.kinds.end(), is_of);
    return std::span(first, std::find_if_not(first, knowledge.kinds.end(), is_of));
  };
  const int fallback = knowledge.fallback_index();
  const std::span<const ClassKind> of_fallback = fallback < 0 ? std::span<const ClassKind>() : kinds_of(static_cast<std::size_t>(fallback));
  std::vector<std::size_t> without;  // kinds, and so newcomers
  std::vector<Newcomer> list;
  for (std::size_t c = 0; !of_fallback.empty() && c < knowledge.classes.size(); ++c) {
    if (static_cast<int>(c) == fallback || !kinds_of(c).empty()) continue;
    without.push_back(c);
    list.push_back(newcomer(c, static_cast<std::size_t>(fallback)));
  }
  const Newcomers newcomers(of_fallback, list);
  // By its blur alone, a class without rows would fit whatever is of no kind better than the fallback class itself.
  const auto borrowed_by = [&](std::size_t object_class) {
    std::vector<ClassKind> borrowed(of_fallback.begin(), of_fallback.end());
    for (ClassKind& kind : borrowed) {
      std::erase_if(kind.features, [&](const KindFeature& row) {
        return std::any_of(features_.begin(), features_.end(), [&](const FeatureModel& f) { return f.feature->name == row.feature && !f.silent[object_class]; });
      });
    }
    return borrowed;
  };
  std::vector<std::vector<ClassKind>> borrowed(without.size());
  std::vector<MixtureClass> classes(knowledge.classes.size());
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const auto number = static_cast<std::size_t>(std::find(without.begin(), without.end(), c) - without.begin());
    MixtureClass& of = classes[c];
    of.kinds = kinds_of(c);
    if (static_cast<int>(c) == fallback) of.factors = newcomers.kept();
    if (number < without.size()) {
      of.kinds = borrowed[number] = borrowed_by(c);
      of.factors = newcomers.factors(number);
    }
    for (const FeatureModel& model : features_) of.own.push_back(&model.likelihoods[c]);
  }
  mixtures_ = Mixtures(classes, features, outlier_share);
}

std::vector<MixtureInput> Model::inputs(std::size_t plane, const std::vector<std::size_t>& features) const {
  std::vector<MixtureInput> out;
  out.reserve(features.size());
  for (const std::size_t f : features) {
    const FeatureModel& model = features_[f];
    const double x = value(model, plane);
    if (!std::isnan(x)) out.push_back({f, x, on_scale(*model.feature, x), error(model, plane), model.feature->weight});
  }
  return out;
}

// Equation (3).
std::vector<double> Model::product(std::size_t plane) const {
  std::vector<double> logs = mixtures_.log_densities(inputs(plane, by_weight_));
  for (std::size_t c = 0; c < logs.size(); ++c) logs[c] += log_priors_[c];
  return normalised(std::move(logs));
}

// Equation (4).
std::vector<double> Model::mean(std::size_t plane) const {
  std::vector<double> sum(log_priors_.size(), 0.0);
  double weights = 0;
  for (const FeatureModel& model : features_) {
    const double x = value(model, plane);
    if (std::isnan(x)) continue;
    std::vector<double> logs = log_priors_;
    for (std::size_t c = 0; c < logs.size(); ++c) logs[c] += model.likelihoods[c].log_density(x);
    const std::vector<double> posterior = normalised(std::move(logs));
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += model.feature->weight * posterior[c];
    weights += model.feature->weight;
  }
  if (weights == 0) return normalised(log_priors_);
  for (double& probability : sum) probability /= weights;
  return sum;
}

// ln Σ_k s_k Π_i p_ik^F_i = Σ_i F_i Σ_k r_k ln p_ik + Σ_k r_k (ln s_k − ln r_k) with r_k the share that kind k has of the sum: what a
// feature says is the mean of what it says to the kinds, and the rest is how usual these kinds are.                     (6)
void add_kinds(const Mixtures& mixtures, std::size_t object_class, const std::vector<MixtureInput>& inputs, std::vector<Contribution>& terms) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Contribution usual{.feature = kKindTerm, .mean = kNone, .sigma = kNone, .weight = 1};
  if (mixtures.has_kinds(object_class)) {
    const Mixtures::Division division = mixtures.divide(object_class, inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      terms[i].log_likelihood = division.log_likelihoods[i];
      if (std::isnan(division.means[i])) continue;
      terms[i].mean = division.means[i];
      terms[i].sigma = division.sigmas[i];
    }
    usual.log_likelihood = division.usual;
    usual.value = division.likeliest;
  }
  terms.push_back(std::move(usual));
}

// No class is ruled out by evidence alone: −ln P stays finite, so that a constraint or a person can still speak for it.
void keep_possible(std::vector<double>& probabilities) {
  double sum = 0;
  for (double& p : probabilities) sum += p = std::max(p, kLeastProbability);
  for (double& p : probabilities) p /= sum;
}

}  // namespace

std::vector<std::vector<double>> preclassify(const Knowledge& knowledge, const FeatureTable& features, int threads) {
  constexpr std::size_t kPiece = 8;  // planes, about a quarter of a millisecond: five times what a thread costs
  std::vector<std::vector<double>> result(features.values.size());
  if (knowledge.classes.empty()) return result;
  const Model model(knowledge, features);
  const bool mean = is_mean(knowledge);
  perception::parallel_pieces(result.size(), kPiece, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t plane = begin; plane < end; ++plane) {
      result[plane] = mean ? model.mean(plane) : model.product(plane);
      keep_possible(result[plane]);
    }
  });
  return result;
}

std::vector<std::vector<Contribution>> contributions(const Knowledge& knowledge, const FeatureTable& features,
                                                     const std::vector<std::pair<std::size_t, std::size_t>>& entries) {
  const Model model(knowledge, features);
  const bool kinds = model.mixtures().any_kinds() && !is_mean(knowledge);
  std::vector<std::vector<Contribution>> result;
  for (const auto& [plane, object_class] : entries) {
    const std::vector<MixtureInput> inputs = model.inputs(plane, model.in_order());
    std::vector<Contribution>& terms = result.emplace_back();
    for (const MixtureInput& input : inputs) {
      const FeatureModel& f = model.features()[input.feature];
      const Likelihood& likelihood = f.likelihoods[object_class];
      const double own = likelihood.log_density(input.value, input.scaled, input.error);
      terms.push_back({f.feature->name, input.value, likelihood.mean(), likelihood.sigma(), own, input.weight, input.error});
    }
    if (kinds) add_kinds(model.mixtures(), object_class, inputs, terms);
  }
  return result;
}

std::vector<Contribution> contributions(const Knowledge& knowledge, const FeatureTable& features, std::size_t plane,
                                        std::size_t object_class) {
  return std::move(contributions(knowledge, features, {{plane, object_class}})[0]);
}

}  // namespace scenelore::kb
