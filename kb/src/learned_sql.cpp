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

}  // namespace

std::string to_sql(const LearnedRows& rows) {
  std::string sql;
  for (const std::string& note : rows.notes) sql += "-- " + note + "\n";
  for (const LearnedClass& learned : rows.classes) {
    sql += fmt::format("\n-- {}: {} examples\n", learned.object_class, learned.examples);
    sql += fmt::format("UPDATE object_class SET prior = {:.4g} WHERE name = {};\n", learned.prior, quoted(learned.object_class));
    for (const ClassFeature& row : learned.gaussians) sql += gaussian_sql(row);
    sql += densities_sql(learned);
  }
  return sql;
}

}  // namespace scenelore::kb
