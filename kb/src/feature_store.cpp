// The values of the catalogue's features, one row a plane and feature.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "implementation.hpp"
#include "kept_result.hpp"
#include "no_triggers.hpp"
#include "scenelore/kb/sha256.hpp"

namespace scenelore::kb {

namespace {

const char* name_of(Scale scale) {
  switch (scale) {
    case Scale::linear: return "linear";
    case Scale::log: return "log";
    case Scale::circular: return "circular";
  }
  return "";
}

std::vector<std::string> catalogue(const Database& database) {
  std::vector<std::string> names;
  Statement select = database.prepare("SELECT name FROM feature ORDER BY name");
  for (auto row = select.use(); row.next();) names.push_back(row.text(0));
  return names;
}

// Whether these planes have as many rows as there are known values in the given columns.
bool as_many(const Database& database, const std::vector<PlaneId>& planes, std::size_t wanted) {
  Statement count = database.prepare("SELECT count(*) FROM plane_feature WHERE plane_id BETWEEN ? AND ?");
  const auto [first, last] = std::minmax_element(planes.begin(), planes.end());
  auto row = count.use();
  return row(*first)(*last).next() && row.integer(0) == static_cast<std::int64_t>(wanted);
}

// Whether the rows of these planes are those that store_features would write, and no others. What was written together lies together:
// one pass over the table from the first row on, without an index. False at worst has the same rows written again.
bool same_values(const Database& database, const std::vector<PlaneId>& planes, const FeatureTable& given, const std::vector<std::size_t>& columns) {
  if (planes.empty()) return true;
  Statement select = database.prepare(
      "SELECT plane_id, feature, value FROM plane_feature NOT INDEXED WHERE id >= (SELECT min(id) FROM plane_feature WHERE plane_id = ?) ORDER BY id");
  auto row = select.use();
  row(planes[0]);
  std::size_t wanted = 0;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    for (const std::size_t column : columns) {
      const double value = given.values[p][column];
      if (std::isnan(value)) continue;
      if (!row.next() || row.integer(0) != planes[p] || row.view(1) != given.names[column] || row.real(2) != value) return false;
      ++wanted;
    }
  }
  return as_many(database, planes, wanted);
}

}  // namespace

void KnowledgeBase::register_features(const std::vector<Feature>& features) {
  Database& database = implementation_->database;
  const std::vector<std::string> known = catalogue(database);
  const auto is_known = [&](const Feature& f) { return std::binary_search(known.begin(), known.end(), f.name); };
  if (std::all_of(features.begin(), features.end(), is_known)) return;
  implementation_->read.reset();
  Transaction transaction(database);
  Statement insert = database.prepare(
      "INSERT INTO feature (name, unit, scale, low, high, weight, description) VALUES (?, ?, ?, ?, ?, 0, ?) "
      "ON CONFLICT (name) DO NOTHING");
  for (const Feature& f : features) {
    insert.use()(f.name)(f.unit)(name_of(f.scale))(f.low)(f.high)(f.description).run();
  }
  transaction.commit();
}

void KnowledgeBase::store_features(ScanId scan, const std::vector<PlaneId>& planes, const FeatureTable& features) {
  Database& database = implementation_->database;
  const std::vector<std::string> known = catalogue(database);
  std::string inputs = hash_of(planes, features);
  for (const std::string& name : known) inputs += '\n' + name;
  inputs = sha256_of(inputs);
  if (is_kept(database, scan, "features", inputs)) return;  // relabelling: nothing to write
  std::vector<std::size_t> columns;
  for (std::size_t f = 0; f < features.names.size(); ++f) {
    if (std::binary_search(known.begin(), known.end(), features.names[f])) columns.push_back(f);
  }
  Transaction transaction(database);
  const NoTriggers own_writing(database);
  keep_result(database, scan, "features", {inputs, {}});
  if (same_values(database, planes, features, columns)) return transaction.commit();
  Statement remove = database.prepare("DELETE FROM plane_feature WHERE plane_id = ?");
  Statement insert = database.prepare("INSERT INTO plane_feature (plane_id, feature, value) VALUES (?, ?, ?)");
  for (std::size_t p = 0; p < planes.size(); ++p) {
    remove.use()(planes[p]).run();
    for (const std::size_t f : columns) {
      const double value = features.values[p][f];
      if (!std::isnan(value)) insert.use()(planes[p])(features.names[f])(value).run();
    }
  }
  transaction.commit();
}

FeatureTable KnowledgeBase::features(const std::vector<PlaneId>& planes) const {
  const Database& database = implementation_->database;
  std::vector<std::map<std::string, double>> values(planes.size());
  std::set<std::string> names;
  Statement select = database.prepare("SELECT feature, value FROM plane_feature WHERE plane_id = ?");
  for (std::size_t p = 0; p < planes.size(); ++p) {
    auto row = select.use();
    for (row(planes[p]); row.next();) {
      names.insert(row.text(0));
      values[p].emplace(row.text(0), row.real(1));
    }
  }
  FeatureTable table{{names.begin(), names.end()}, {}};
  for (const std::map<std::string, double>& of_plane : values) {
    std::vector<double>& line = table.values.emplace_back();
    for (const std::string& name : table.names) {
      const auto found = of_plane.find(name);
      line.push_back(found == of_plane.end() ? std::numeric_limits<double>::quiet_NaN() : found->second);
    }
  }
  return table;
}

}  // namespace scenelore::kb
