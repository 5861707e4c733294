#include "knowledge_rows.hpp"

#include "composites.hpp"
#include "digest.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

#include "scenelore/kb/sha256.hpp"

namespace scenelore::kb {

namespace {

Scale scale_of(const std::string& name) {
  return name == "log" ? Scale::log : name == "circular" ? Scale::circular : Scale::linear;
}

Quantifier quantifier_of(const std::string& name) {
  static constexpr std::array kNames = {"some", "every", "no", "at_most", "at_least"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames[i]) return static_cast<Quantifier>(i);
  }
  throw Error("unknown quantifier '" + name + "'");  // the CHECK of the table allows no other
}

template <typename Row, typename Read>
std::vector<Row> rows(const Database& database, std::string_view sql, Read read) {
  Statement select = database.prepare(sql);
  std::vector<Row> result;
  for (auto row = select.use(); row.next();) result.push_back(read(row));
  return result;
}

}  // namespace

namespace {

Orientation orientation_of(const std::optional<std::string>& text) {
  return !text ? Orientation::any : *text == "level" ? Orientation::level : Orientation::upright;
}

// With what they need, as constraint rows behind the others.
void read_composites(const Database& database, Knowledge& knowledge) {
  Statement composites = database.prepare("SELECT name, enabled FROM composite ORDER BY id");
  for (auto row = composites.use(); row.next();) knowledge.composites.push_back({row.text(0), {}, row.integer(1) != 0});
  Statement parts = database.prepare(
      "SELECT composite, part, class, relation, orientation, fewest, most, weight FROM composite_part ORDER BY id");
  for (auto row = parts.use(); row.next();) {
    for (Composite& composite : knowledge.composites) {
      if (composite.name != row.text(0)) continue;
      composite.parts.push_back({row.text(1), row.text(2), row.optional_text(3), orientation_of(row.optional_text(4)),
                                 static_cast<int>(row.integer(5)), static_cast<int>(row.integer(6)), row.optional_real(7)});
    }
  }
  for (ClassConstraint& need : composite_needs(knowledge.composites)) knowledge.constraints.push_back(std::move(need));
}

/// By class, feature, low. The thousands of bins were written histogram by histogram: putting those in order is cheaper than following
/// an index from bin to bin.
std::vector<ClassDensity> in_order(std::vector<ClassDensity> bins) {
  const auto before = [](const ClassDensity& a, const ClassDensity& b) {
    return std::tie(a.object_class, a.feature, a.low) < std::tie(b.object_class, b.feature, b.low);
  };
  std::vector<std::span<ClassDensity>> runs;
  for (std::size_t begin = 0, end = 0; begin < bins.size(); begin = end) {
    for (end = begin + 1; end < bins.size() && before(bins[end - 1], bins[end]) && bins[end].feature == bins[begin].feature; ++end) {}
    runs.push_back(std::span(bins).subspan(begin, end - begin));
  }
  std::sort(runs.begin(), runs.end(), [&](const auto& a, const auto& b) { return before(a.front(), b.front()); });
  std::vector<ClassDensity> out;
  out.reserve(bins.size());
  for (const std::span<ClassDensity> run : runs) std::move(run.begin(), run.end(), std::back_inserter(out));
  if (!std::is_sorted(out.begin(), out.end(), before)) std::sort(out.begin(), out.end(), before);  // a histogram in pieces
  return out;
}

std::vector<ClassKind> read_kinds(const Database& database) {
  auto kinds = rows<ClassKind>(database, "SELECT class, kind, share, description FROM class_kind ORDER BY class, kind", [](const Statement::Use& row) {
    return ClassKind{row.text(0), static_cast<int>(row.integer(1)), row.real(2), row.text(3), {}};
  });
  Statement features = database.prepare("SELECT class, kind, feature, mean, sigma FROM kind_feature ORDER BY class, kind, feature");
  auto kind = kinds.begin();
  for (auto row = features.use(); row.next();) {
    const std::string object_class = row.text(0);
    const std::int64_t number = row.integer(1);
    while (kind != kinds.end() && std::tie(kind->object_class, kind->number) < std::tie(object_class, number)) ++kind;
    if (kind == kinds.end() || kind->object_class != object_class || kind->number != number) {  // written with foreign keys switched off
      throw Error(database.name() + ": kind_feature row ('" + object_class + "', " + std::to_string(number) + ", '" + row.text(2) +
                  "'): there is no such row in class_kind");
    }
    kind->features.push_back({row.text(2), row.real(3), row.real(4)});
  }
  return kinds;
}

}  // namespace

Knowledge read_knowledge(const Database& database) {
  using Use = Statement::Use;
  Knowledge knowledge;
  knowledge.classes = rows<ObjectClass>(
      database, "SELECT id, name, prior, description, color, fallback FROM object_class ORDER BY id", [](const Use& row) {
        return ObjectClass{static_cast<int>(row.integer(0)), row.text(1), row.real(2), row.text(3), row.text(4),
                           row.integer(5) != 0};
      });
  knowledge.features = rows<Feature>(
      database, "SELECT name, unit, scale, low, high, weight, description FROM feature ORDER BY name",
      [](const Use& row) {
        return Feature{row.text(0), row.text(1), scale_of(row.text(2)), row.real(3), row.real(4), row.real(5), row.text(6)};
      });
  knowledge.class_features = rows<ClassFeature>(
      database, "SELECT class, feature, mean, sigma FROM class_feature ORDER BY class, feature",
      [](const Use& row) { return ClassFeature{row.text(0), row.text(1), row.real(2), row.real(3)}; });
  knowledge.class_densities = in_order(rows<ClassDensity>(
      database, "SELECT class, feature, low, high, density FROM class_density NOT INDEXED",
      [](const Use& row) { return ClassDensity{row.text(0), row.text(1), row.real(2), row.real(3), row.real(4)}; }));
  knowledge.kinds = read_kinds(database);
  knowledge.constraints = rows<ClassConstraint>(
      database,
      "SELECT id, name, class, quantifier, relation, other_class, count, weight, message, enabled FROM class_constraint "
      "ORDER BY id",
      [](const Use& row) {
        return ClassConstraint{row.integer(0), row.text(1), row.text(2), quantifier_of(row.text(3)),
                               row.optional_text(4), row.optional_text(5),
                               row.is_null(6) ? std::nullopt : std::optional(static_cast<int>(row.integer(6))),
                               row.optional_real(7), row.text(8), row.integer(9) != 0};
      });
  read_composites(database, knowledge);
  Statement settings = database.prepare("SELECT key, value FROM setting");
  for (auto row = settings.use(); row.next();) knowledge.settings.emplace(row.text(0), row.text(1));
  return knowledge;
}

// Row ids that nothing refers to do not matter.
KnowledgeHashes hash_knowledge(const Knowledge& knowledge) {
  Digest add;
  add("object_class");
  for (const ObjectClass& c : knowledge.classes) add(c.id)(c.name)(c.prior)(c.description)(c.color)(c.fallback ? 1 : 0);
  add("feature");
  for (const Feature& f : knowledge.features) {
    add(f.name)(f.unit)(static_cast<int>(f.scale))(f.low)(f.high)(f.weight)(f.description);
  }
  add("class_feature");
  for (const ClassFeature& g : knowledge.class_features) add(g.object_class)(g.feature)(g.mean)(g.sigma);
  add("class_density");
  for (const ClassDensity& d : knowledge.class_densities) add(d.object_class)(d.feature)(d.low)(d.high)(d.density);
  add("class_kind");
  for (const ClassKind& kind : knowledge.kinds) {
    add(kind.object_class)(kind.number)(kind.share)(kind.description);
    for (const KindFeature& f : kind.features) add(f.feature)(f.mean)(f.sigma);
  }
  add("setting");
  for (const auto& [key, value] : knowledge.settings) add(key)(value);
  const std::size_t of_evidence = add.bytes().size();
  add("class_constraint");
  for (const ClassConstraint& c : knowledge.constraints) {
    add(c.id)(c.name)(c.object_class)(static_cast<int>(c.quantifier))(c.relation)(c.other_class)(c.count)(c.weight)(
        c.message)(c.enabled ? 1 : 0);
  }
  add("composite");
  for (const Composite& c : knowledge.composites) {
    add(c.name)(c.enabled ? 1 : 0);
    for (const CompositePart& p : c.parts) {
      add(p.part)(p.object_class)(p.relation)(static_cast<int>(p.orientation))(p.fewest)(p.most)(p.weight);
    }
  }
  Sha256 all;
  all.add(std::string_view(add.bytes()).substr(0, of_evidence));
  Sha256 evidence = all;
  all.add(std::string_view(add.bytes()).substr(of_evidence));
  return {all.hex(), evidence.hex()};
}

}  // namespace scenelore::kb
