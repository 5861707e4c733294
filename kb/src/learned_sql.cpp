#include <fmt/format.h>

#include "quoted.hpp"
#include "scenelore/kb/learn.hpp"

namespace scenelore::kb {

namespace {

std::string gaussian_sql(const ClassFeature& row) {
  return fmt::format(
      "INSERT INTO class_feature (class, feature, mean, sigma) VALUES ({}, {}, {:.4g}, {:.4g})\n"
      "  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;\n",
      quoted(row.object_class), quoted(row.feature), row.mean, row.sigma);
}

// Bounds with more digits than densities: neighbours must stay apart, and must still meet after rounding.
std::string bin_sql(const ClassDensity& row) {
  return fmt::format("({}, {}, {:.6g}, {:.6g}, {:.4g})", quoted(row.object_class), quoted(row.feature), row.low, row.high, row.density);
}

std::string densities_sql(const LearnedClass& learned) {
  std::string sql;
  for (std::size_t i = 0; i < learned.densities.size(); ++i) {
    const ClassDensity& row = learned.densities[i];
    const bool first = i == 0 || learned.densities[i - 1].feature != row.feature;
    if (first) {
      sql += (i == 0 ? "" : ";\n") + fmt::format("DELETE FROM class_density WHERE class = {} AND feature = {};\n",
                                                 quoted(row.object_class), quoted(row.feature));
      sql += "INSERT INTO class_density (class, feature, low, high, density) VALUES\n  ";
    } else {
      sql += ",\n  ";
    }
    sql += bin_sql(row);
  }
  return sql.empty() ? sql : sql + ";\n";
}

// One INSERT for the kinds and one for each kind's features.
std::string kinds_sql(const LearnedClass& learned) {
  if (learned.gaussians.empty()) return "";
  std::string sql = fmt::format("DELETE FROM class_kind WHERE class = {};\n", quoted(learned.object_class));
  if (learned.kinds_replace_densities()) sql += fmt::format("DELETE FROM class_density WHERE class = {};\n", quoted(learned.object_class));
  for (const ClassKind& kind : learned.kinds) {
    sql += fmt::format("INSERT INTO class_kind (class, kind, share, description) VALUES ({}, {}, {:.4g}, {});\n", quoted(kind.object_class), kind.number,
                       kind.share, quoted(kind.description));
    sql += "INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES\n";
    for (std::size_t f = 0; f < kind.features.size(); ++f) {
      const KindFeature& row = kind.features[f];
      sql += fmt::format("  ({}, {}, {}, {:.4g}, {:.4g}){}\n", quoted(kind.object_class), kind.number, quoted(row.feature), row.mean, row.sigma,
                         f + 1 < kind.features.size() ? "," : ";");
    }
  }
  return sql;
}

}  // namespace

std::string to_sql(const LearnedRows& rows) {
  std::string sql;
  for (const std::string& note : rows.notes) sql += "-- " + note + "\n";
  for (const LearnedClass& learned : rows.classes) {
    sql += fmt::format("\n-- {}: {} examples\n", learned.object_class, learned.examples);
    sql += fmt::format("UPDATE object_class SET prior = {:.4g} WHERE name = {};\n", learned.prior, quoted(learned.object_class));
    for (const ClassFeature& row : learned.gaussians) sql += gaussian_sql(row);
    sql += densities_sql(learned);
    sql += kinds_sql(learned);
  }
  return sql;
}

}  // namespace scenelore::kb
