#include "snapshot.hpp"

#include <fmt/format.h>

#include "quoted.hpp"

namespace scenelore::kb {

namespace {

// 17 significant digits read back as the same number.
std::string number(double value) { return fmt::format("{:.17g}", value); }

// `INSERT … SELECT … WHERE` skips rows of a class or feature that a person has deleted since.
std::string guarded(const std::string& table, const std::string& columns, const std::string& object_class, const std::string& feature,
                    const std::string& values) {
  return fmt::format("INSERT INTO {0} (class, feature, {1}) SELECT {2}, {3}, {4} WHERE {2} IN (SELECT name FROM object_class) "
                     "AND {3} IN (SELECT name FROM feature);\n", table, columns, quoted(object_class), quoted(feature), values);
}

std::string kind_snapshot(const ClassKind& kind) {
  std::string sql = fmt::format("INSERT INTO class_kind (class, kind, share, description) SELECT {0}, {1}, {2}, {3} WHERE {0} IN (SELECT name FROM object_class);\n",
                                quoted(kind.object_class), kind.number, number(kind.share), quoted(kind.description));
  for (const KindFeature& row : kind.features) {
    sql += fmt::format("INSERT INTO kind_feature (class, kind, feature, mean, sigma) SELECT {0}, {1}, {2}, {3}, {4} "
                       "WHERE {0} IN (SELECT name FROM object_class) AND {2} IN (SELECT name FROM feature);\n",
                       quoted(kind.object_class), kind.number, quoted(row.feature), number(row.mean), number(row.sigma));
  }
  return sql;
}

}  // namespace

std::string snapshot_sql(const Knowledge& knowledge) {
  std::string sql;
  for (const ObjectClass& c : knowledge.classes) {
    sql += fmt::format("UPDATE object_class SET prior = {} WHERE name = {};\n", number(c.prior), quoted(c.name));
    sql += fmt::format("DELETE FROM class_feature WHERE class = {0};\nDELETE FROM class_density WHERE class = {0};\n"
                       "DELETE FROM class_kind WHERE class = {0};\n", quoted(c.name));
  }
  for (const Feature& f : knowledge.features) {
    sql += fmt::format("UPDATE feature SET weight = {} WHERE name = {};\n", number(f.weight), quoted(f.name));
  }
  for (const ClassConstraint& row : knowledge.constraints) {
    if (row.id < 0) continue;  // of a composite
    sql += fmt::format("UPDATE class_constraint SET weight = {} WHERE name = {};\n", row.weight ? number(*row.weight) : "NULL", quoted(row.name));
  }
  sql += "DELETE FROM setting WHERE key IN ('probability_slope', 'probability_offset');\n";
  for (const char* key : {"probability_slope", "probability_offset"}) {
    const auto found = knowledge.settings.find(key);
    if (found != knowledge.settings.end()) sql += fmt::format("INSERT INTO setting (key, value) VALUES ({}, {});\n", quoted(key), quoted(found->second));
  }
  for (const ClassFeature& row : knowledge.class_features) {
    sql += guarded("class_feature", "mean, sigma", row.object_class, row.feature, number(row.mean) + ", " + number(row.sigma));
  }
  for (const ClassDensity& row : knowledge.class_densities) {
    sql += guarded("class_density", "low, high, density", row.object_class, row.feature,
                   number(row.low) + ", " + number(row.high) + ", " + number(row.density));
  }
  for (const ClassKind& kind : knowledge.kinds) sql += kind_snapshot(kind);
  return sql;
}

}  // namespace scenelore::kb
