#include "knowledge_rows.hpp"

#include <sqlite3.h>

#include <array>

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
  knowledge.class_densities = rows<ClassDensity>(
      database, "SELECT class, feature, low, high, density FROM class_density ORDER BY class, feature, low",
      [](const Use& row) { return ClassDensity{row.text(0), row.text(1), row.real(2), row.real(3), row.real(4)}; });
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
  Statement settings = database.prepare("SELECT key, value FROM setting");
  for (auto row = settings.use(); row.next();) knowledge.settings.emplace(row.text(0), row.text(1));
  return knowledge;
}

// Every value of every knowledge table in the order of its names, each with its type and, for text, its length, so that
// no two contents give the same bytes. Row ids that nothing refers to do not matter.
std::string hash_knowledge(const Database& database) {
  static constexpr std::array kTables = {
      "SELECT id, name, prior, description, color, fallback FROM object_class ORDER BY id",
      "SELECT name, unit, scale, low, high, weight, description FROM feature ORDER BY name",
      "SELECT class, feature, mean, sigma FROM class_feature ORDER BY class, feature",
      "SELECT class, feature, low, high, density FROM class_density ORDER BY class, feature, low",
      "SELECT key, value FROM setting ORDER BY key",
      "SELECT id, name, class, quantifier, relation, other_class, count, weight, message, enabled FROM class_constraint "
      "ORDER BY id"};
  Sha256 hash;
  const auto add_number = [&](auto value) { hash.add(std::as_bytes(std::span(&value, 1))); };
  for (const char* const table : kTables) {
    Statement select = database.prepare(table);
    hash.add(table);
    for (auto row = select.use(); row.next();) {
      for (int column = 0; column < select.columns(); ++column) {
        const int type = row.type(column);
        add_number(static_cast<std::uint8_t>(type));
        if (type == SQLITE_INTEGER) add_number(row.integer(column));
        if (type == SQLITE_FLOAT) add_number(row.real(column));
        if (type != SQLITE_TEXT) continue;
        const std::string text = row.text(column);
        add_number(static_cast<std::uint64_t>(text.size()));
        hash.add(text);
      }
    }
  }
  return hash.hex();
}

}  // namespace scenelore::kb
