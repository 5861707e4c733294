// The values of the catalogue's features, one row a plane and feature.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "implementation.hpp"

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

bool same_value(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Whether `stored` holds just the given columns of `given`, and nothing else.
bool same_values(const FeatureTable& stored, const FeatureTable& given, const std::vector<std::size_t>& columns) {
  std::size_t found = 0;
  for (const std::size_t column : columns) {
    const auto name = std::find(stored.names.begin(), stored.names.end(), given.names[column]);
    const auto at = static_cast<std::size_t>(name - stored.names.begin());
    const bool known = name != stored.names.end();
    found += known ? 1 : 0;
    for (std::size_t p = 0; p < given.values.size(); ++p) {
      const double value = known ? stored.values[p][at] : std::numeric_limits<double>::quiet_NaN();
      if (!same_value(value, given.values[p][column])) return false;
    }
  }
  return found == stored.names.size();
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

void KnowledgeBase::store_features(const std::vector<PlaneId>& planes, const FeatureTable& features) {
  Database& database = implementation_->database;
  const std::vector<std::string> known = catalogue(database);
  std::vector<std::size_t> columns;
  for (std::size_t f = 0; f < features.names.size(); ++f) {
    if (std::binary_search(known.begin(), known.end(), features.names[f])) columns.push_back(f);
  }
  if (same_values(this->features(planes), features, columns)) return;  // relabelling: nothing to write
  Transaction transaction(database);
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
