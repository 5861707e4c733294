#include "scenelore/kb/learn.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "density_fit.hpp"
#include "kind_fit.hpp"
#include "likelihood.hpp"
#include "scenelore/kb/error.hpp"
#include "scenelore/kb/suggest.hpp"

namespace scenelore::kb {

namespace {

void check_input(const Knowledge& knowledge, const LabelledPlanes& planes) {
  if (planes.classes.size() != planes.features.values.size()) {
    throw Error("learning: " + std::to_string(planes.classes.size()) + " classes for " +
                std::to_string(planes.features.values.size()) + " planes");
  }
  std::vector<std::string> known;
  for (const ObjectClass& c : knowledge.classes) known.push_back(c.name);
  for (const std::string& name : planes.classes) {
    if (!name.empty() && knowledge.class_index(name) < 0) {
      throw Error("learning: class '" + name + "' does not exist" + did_you_mean(name, known));
    }
  }
}

// Values of one feature of one class on the feature's scale, ascending.
std::vector<double> examples_of(const LabelledPlanes& planes, const std::string& object_class, std::size_t column,
                                const Feature& feature) {
  std::vector<double> values;
  for (std::size_t p = 0; p < planes.classes.size(); ++p) {
    const double value = planes.features.values[p][column];
    if (planes.classes[p] == object_class && std::isfinite(value)) values.push_back(on_scale(feature, value));
  }
  std::sort(values.begin(), values.end());
  return values;
}

// Angles are cut open opposite to where they gather, so that the fit on a line is right.
double circular_middle(const std::vector<double>& values, double turn) {
  const double to_radians = 2 * M_PI / turn;
  double sine = 0, cosine = 0;
  for (const double value : values) {
    sine += std::sin(value * to_radians);
    cosine += std::cos(value * to_radians);
  }
  return std::atan2(sine, cosine) / to_radians;
}

// What the knowledge says about a feature of a class, on the feature's scale.
Present present_rows(const Knowledge& knowledge, const std::string& object_class, const Feature& feature) {
  Present present;
  for (const ClassFeature& row : knowledge.class_features) {
    if (row.object_class == object_class && row.feature == feature.name) present.gaussian = Gaussian{row.mean, row.sigma};
  }
  for (const ClassDensity& row : knowledge.class_densities) {
    if (row.object_class != object_class || row.feature != feature.name) continue;
    present.bins.push_back({on_scale(feature, row.low), on_scale(feature, row.high), row.density});
  }
  std::sort(present.bins.begin(), present.bins.end(), [](const Bin& a, const Bin& b) { return a.low < b.low; });
  return present;
}

void fit_circular(LearnedClass& learned, const Feature& feature, std::vector<double> values, Present present,
                  const LearnOptions& options) {
  const double turn = range_on_scale(feature), middle = circular_middle(values, turn);
  for (double& value : values) value = middle + std::remainder(value - middle, turn);
  std::sort(values.begin(), values.end());
  if (present.gaussian) present.gaussian->mean = middle + std::remainder(present.gaussian->mean - middle, turn);
  const Gaussian gaussian =
      joined(fit_gaussian(values, turn, options), static_cast<double>(values.size()), present, options.present_strength);
  learned.gaussians.push_back({learned.object_class, feature.name, gaussian.mean, gaussian.sigma});
}

void fit_feature(LearnedClass& learned, const Feature& feature, const std::vector<double>& values, const Present& present,
                 const LearnOptions& options) {
  if (feature.scale == Scale::circular) return fit_circular(learned, feature, values, present, options);
  const double low = on_scale(feature, feature.low), high = on_scale(feature, feature.high);
  const Gaussian gaussian = fit_gaussian(values, high - low, options);
  const Gaussian told = joined(gaussian, static_cast<double>(values.size()), present, options.present_strength);
  learned.gaussians.push_back({learned.object_class, feature.name, told.mean, told.sigma});
  const auto unit = [&](double at) { return feature.scale == Scale::log ? std::exp(at) : at; };
  for (const Bin& bin : fit_histogram(values, gaussian, present, low, high, options)) {
    learned.densities.push_back({learned.object_class, feature.name, unit(bin.low), unit(bin.high), bin.density});
  }
}

// Of the features that count; circular ones stay with the class's own rows.
std::vector<ClassKind> kinds_of(const Knowledge& knowledge, const LabelledPlanes& planes, const ObjectClass& of, const LearnOptions& options) {
  std::vector<const Feature*> features;
  std::vector<std::size_t> columns;
  for (const Feature& feature : knowledge.features) {
    const auto found = std::find(planes.features.names.begin(), planes.features.names.end(), feature.name);
    if (found == planes.features.names.end() || feature.weight <= 0 || feature.scale == Scale::circular) continue;
    features.push_back(&feature);
    columns.push_back(static_cast<std::size_t>(found - planes.features.names.begin()));
  }
  std::vector<KindExample> examples;
  for (std::size_t p = 0; p < planes.classes.size(); ++p) {
    if (planes.classes[p] != of.name) continue;
    KindExample& example = examples.emplace_back();
    for (std::size_t f = 0; f < features.size(); ++f) {
      const double value = planes.features.values[p][columns[f]];
      example.push_back(std::isfinite(value) ? on_scale(*features[f], value) : std::numeric_limits<double>::quiet_NaN());
    }
  }
  std::vector<ClassKind> present;
  std::copy_if(knowledge.kinds.begin(), knowledge.kinds.end(), std::back_inserter(present), [&](const ClassKind& kind) { return kind.object_class == of.name; });
  return fit_kinds(of.name, std::move(examples), features, present, of.fallback ? options.most_kinds_of_fallback : options.most_kinds, options);
}

// The mean of a Dirichlet posterior: (n_C + k π_C) / (n + k), π the present priors.
void fit_priors(const Knowledge& knowledge, const LearnOptions& options, std::vector<LearnedClass>& classes) {
  double priors = 0, examples = 0;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    priors += knowledge.classes[c].prior;
    examples += classes[c].examples;
  }
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const double present = knowledge.classes[c].prior / priors;
    classes[c].prior = !options.priors ? present : (classes[c].examples + options.prior_strength * present) / (examples + options.prior_strength);
  }
}

}  // namespace

LearnedRows learn(const Knowledge& knowledge, const LabelledPlanes& planes, const LearnOptions& options) {
  check_input(knowledge, planes);
  LearnedRows rows;
  for (const ObjectClass& c : knowledge.classes) {
    LearnedClass& learned = rows.classes.emplace_back();
    learned.object_class = c.name;
    learned.examples = static_cast<int>(std::count(planes.classes.begin(), planes.classes.end(), c.name));
    if (learned.examples < options.min_examples) {
      rows.notes.push_back("class '" + c.name + "' keeps its rows: " + std::to_string(learned.examples) +
                           " examples, " + std::to_string(options.min_examples) + " are needed");
      continue;
    }
    for (const Feature& feature : knowledge.features) {
      const auto found = std::find(planes.features.names.begin(), planes.features.names.end(), feature.name);
      if (found == planes.features.names.end() || feature.weight <= 0) continue;
      const auto column = static_cast<std::size_t>(found - planes.features.names.begin());
      const std::vector<double> values = examples_of(planes, c.name, column, feature);
      if (static_cast<int>(values.size()) >= options.min_examples) fit_feature(learned, feature, values, present_rows(knowledge, c.name, feature), options);
    }
    learned.kinds = kinds_of(knowledge, planes, c, options);
    if (!learned.kinds.empty() && !c.fallback) learned.densities.clear();  // kinds say more; the fallback class speaks for classes without rows, too
  }
  fit_priors(knowledge, options, rows.classes);
  return rows;
}

Knowledge with_rows(Knowledge knowledge, const LearnedRows& rows) {
  for (const LearnedClass& learned : rows.classes) {
    const int c = knowledge.class_index(learned.object_class);
    if (c >= 0) knowledge.classes[static_cast<std::size_t>(c)].prior = learned.prior;
    std::set<std::string> replaced;
    for (const ClassDensity& row : learned.densities) replaced.insert(row.feature);
    std::erase_if(knowledge.class_densities, [&](const ClassDensity& row) {
      return row.object_class == learned.object_class && (learned.kinds_replace_densities() || replaced.contains(row.feature));
    });
    knowledge.class_densities.insert(knowledge.class_densities.end(), learned.densities.begin(), learned.densities.end());
    for (const ClassFeature& row : learned.gaussians) {
      const auto same = [&](const ClassFeature& old) { return old.object_class == row.object_class && old.feature == row.feature; };
      const auto found = std::find_if(knowledge.class_features.begin(), knowledge.class_features.end(), same);
      if (found == knowledge.class_features.end()) knowledge.class_features.push_back(row);
      else *found = row;
    }
    if (learned.gaussians.empty()) continue;  // it keeps its rows
    std::erase_if(knowledge.kinds, [&](const ClassKind& kind) { return kind.object_class == learned.object_class; });
    knowledge.kinds.insert(knowledge.kinds.end(), learned.kinds.begin(), learned.kinds.end());
  }
  std::stable_sort(knowledge.kinds.begin(), knowledge.kinds.end(),
                   [](const ClassKind& a, const ClassKind& b) { return std::tie(a.object_class, a.number) < std::tie(b.object_class, b.number); });
  return knowledge;
}

}  // namespace scenelore::kb
