#include <cmath>
#include <set>

#include "knowledge_rows.hpp"
#include "scenelore/kb/suggest.hpp"

namespace scenelore::kb {

namespace {

constexpr double kRounding = 1e-3;  // shares are written with four digits

// Collects what the checks share: the names that exist, and how an error is worded.
class Checker {
 public:
  Checker(const Knowledge& knowledge, std::string file) : knowledge_(knowledge), file_(std::move(file)) {
    for (const ObjectClass& c : knowledge.classes) classes_.push_back(c.name);
    for (const Feature& f : knowledge.features) features_.push_back(f.name);
  }

  void check_classes() const {
    int fallbacks = 0;
    for (const ObjectClass& c : knowledge_.classes) {
      const std::string row = "object_class row " + std::to_string(c.id) + " '" + c.name + "'";
      need(std::isfinite(c.prior) && c.prior > 0, row, "its prior must be above 0");
      fallbacks += c.fallback ? 1 : 0;
    }
    need(fallbacks == 1, "object_class",
         "exactly one class must have fallback = 1 (the unknown class), but " + std::to_string(fallbacks) + " have");
  }

  void check_features() const {
    for (const Feature& f : knowledge_.features) {
      const std::string row = "feature row '" + f.name + "'";
      need(f.low < f.high && std::isfinite(f.low) && std::isfinite(f.high), row, "low must be below high");
      need(f.scale != Scale::log || f.low > 0, row, "low must be above 0 on a log scale");
      need(std::isfinite(f.weight) && f.weight >= 0, row, "its weight must be 0 or more");
    }
    for (const ClassFeature& g : knowledge_.class_features) {
      const std::string row = "class_feature row ('" + g.object_class + "', '" + g.feature + "')";
      check_pair(row, g.object_class, g.feature);
      need(std::isfinite(g.sigma) && g.sigma > 0, row, "sigma must be above 0");
      need(std::isfinite(g.mean), row, "mean must be a number");
    }
  }

  void check_densities() const {
    const ClassDensity* previous = nullptr;
    const Feature* feature = nullptr;
    for (const ClassDensity& bin : knowledge_.class_densities) {  // by class, feature, low
      const bool follows = previous != nullptr && previous->object_class == bin.object_class &&
                           previous->feature == bin.feature;
      if (!follows) feature = find_feature(bin.feature);
      if (!good_bin(bin, feature, follows ? previous : nullptr)) explain_bin(bin, feature, follows ? previous : nullptr);
      previous = &bin;
    }
  }

  void check_kinds() const {
    double shares = 0;
    const ClassKind* previous = nullptr;
    for (const ClassKind& kind : knowledge_.kinds) {  // by class, number
      const std::string row = "class_kind row ('" + kind.object_class + "', " + std::to_string(kind.number) + ")";
      need_class(row, kind.object_class);
      need(std::isfinite(kind.share) && kind.share > 0, row, "share must be above 0");
      shares = kind.share + (previous != nullptr && previous->object_class == kind.object_class ? shares : 0);
      need(shares <= 1 + kRounding, row, "with it the shares of the class's kinds add up to more than 1");
      for (const KindFeature& g : kind.features) {
        const std::string of = "kind_feature row ('" + kind.object_class + "', " + std::to_string(kind.number) + ", '" + g.feature + "')";
        check_pair(of, kind.object_class, g.feature);
        need(std::isfinite(g.sigma) && g.sigma > 0, of, "sigma must be above 0");
        need(std::isfinite(g.mean), of, "mean must be a number");
      }
      previous = &kind;
    }
  }

  void check_constraints() const {
    std::set<std::string> names;
    for (const ClassConstraint& c : knowledge_.constraints) {
      const std::string row = "class_constraint row " + std::to_string(c.id) + " '" + c.name + "'";
      need(names.insert(c.name).second, row, "there is another constraint of this name");
      need_class(row, c.object_class);
      if (c.other_class) need_class(row, *c.other_class);
      const bool counts = c.quantifier == Quantifier::at_most || c.quantifier == Quantifier::at_least;
      need(counts == c.count.has_value(), row, "count goes with at_most and at_least, and with nothing else");
      need(!c.count || *c.count >= 0, row, "count must be 0 or more");
      need(c.relation || (counts && !c.other_class), row, "it needs a relation");
      need(!c.weight || (*c.weight > 0 && !std::isnan(*c.weight)), row, "weight must be above 0, or NULL for a hard constraint");
      const int index = knowledge_.class_index(c.object_class);
      need(!knowledge_.classes[static_cast<std::size_t>(index)].fallback, row,
           "'" + c.object_class + "' is the fallback class, which has no constraints");
    }
  }

  void check_composites() const {
    for (const Composite& composite : knowledge_.composites) {
      const std::string row = "composite '" + composite.name + "'";
      int anchors = 0;
      for (const CompositePart& part : composite.parts) {
        need_class(row + ", part '" + part.part + "'", part.object_class);
        anchors += part.relation ? 0 : 1;
      }
      need(anchors == 1 || composite.parts.empty(), row, "one of its parts, the anchor, must have no relation, all others one");
    }
  }

  void check_settings() const {
    one_of("combination", {"product", "mean"});
    one_of("floor", {"ranked", "threshold"});
    number_within("floor_threshold", 0, 1);
    number_within("outlier_share", 0, 0.5);
    number_within("probability_slope", 0, 9);
    number_within("probability_offset", -9, 9);
  }

 private:
  // There are thousands of bins: what is wrong with one is worded only when something is.
  bool good_bin(const ClassDensity& bin, const Feature* feature, const ClassDensity* previous) const {
    return feature != nullptr && bin.low < bin.high && std::isfinite(bin.low) && std::isfinite(bin.high) &&
           std::isfinite(bin.density) && bin.density >= 0 && (feature->scale != Scale::log || bin.low > 0) &&
           (previous != nullptr ? previous->high <= bin.low + 1e-12 * std::abs(bin.low)
                                : knowledge_.class_index(bin.object_class) >= 0);
  }

  void explain_bin(const ClassDensity& bin, const Feature* feature, const ClassDensity* previous) const {
    const std::string row =
        "class_density row ('" + bin.object_class + "', '" + bin.feature + "', low " + std::to_string(bin.low) + ")";
    check_pair(row, bin.object_class, bin.feature);
    need(bin.low < bin.high && std::isfinite(bin.low) && std::isfinite(bin.high), row, "low must be below high");
    need(std::isfinite(bin.density) && bin.density >= 0, row, "density must be 0 or more");
    need(feature == nullptr || feature->scale != Scale::log || bin.low > 0, row, "low must be above 0 on a log scale");
    need(previous == nullptr, row, "overlaps the bin before it");
  }

  void need(bool holds, const std::string& row, const std::string& rule) const {
    if (!holds) throw Error(file_ + ": " + row + ": " + rule);
  }

  const Feature* find_feature(const std::string& name) const {
    for (const Feature& f : knowledge_.features) {
      if (f.name == name) return &f;
    }
    return nullptr;
  }

  void need_class(const std::string& row, const std::string& name) const {
    if (knowledge_.class_index(name) >= 0) return;
    need(false, row, "class '" + name + "' does not exist" + did_you_mean(name, classes_));
  }

  void check_pair(const std::string& row, const std::string& object_class, const std::string& feature) const {
    need_class(row, object_class);
    if (find_feature(feature) != nullptr) return;
    need(false, row, "feature '" + feature + "' does not exist" + did_you_mean(feature, features_));
  }

  void one_of(const std::string& key, const std::vector<std::string>& values) const {
    const auto found = knowledge_.settings.find(key);
    if (found == knowledge_.settings.end()) return;
    for (const std::string& value : values) {
      if (found->second == value) return;
    }
    need(false, "setting row '" + key + "'", "'" + found->second + "' must be " + values[0] + " or " + values[1]);
  }

  void number_within(const std::string& key, double low, double high) const {
    const auto found = knowledge_.settings.find(key);
    if (found == knowledge_.settings.end()) return;
    char* end = nullptr;
    const double value = std::strtod(found->second.c_str(), &end);
    need(!found->second.empty() && *end == '\0' && value >= low && value <= high, "setting row '" + key + "'",
         "'" + found->second + "' must be a number from " + std::to_string(low).substr(0, 3) + " to " +
             std::to_string(high).substr(0, 3));
  }

  const Knowledge& knowledge_;
  std::string file_;
  std::vector<std::string> classes_, features_;
};

}  // namespace

void validate(const Knowledge& knowledge, const std::string& file_name) {
  const Checker checker(knowledge, file_name);
  checker.check_classes();
  checker.check_features();
  checker.check_densities();
  checker.check_kinds();
  checker.check_constraints();
  checker.check_composites();
  checker.check_settings();
}

}  // namespace scenelore::kb
