// Scans, planes, features and truth: what perception and people write.
#include <algorithm>
#include <cmath>
#include <map>

#include "implementation.hpp"
#include "plane_rows.hpp"
#include "point_runs.hpp"
#include "scenelore/kb/suggest.hpp"
#include "truth_transfer.hpp"

namespace scenelore::kb {

namespace {

struct OldTruth {
  std::int32_t number = 0;  // of the plane in the old segmentation
  PlaneId plane = 0;
  std::string object_class;
};

std::vector<OldTruth> read_truth(const Database& database, ScanId scan) {
  Statement select = database.prepare(
      "SELECT p.number, p.id, t.class FROM truth t JOIN plane p ON p.id = t.plane_id WHERE p.scan_id = ? ORDER BY p.id");
  std::vector<OldTruth> result;
  auto row = select.use();
  for (row(scan); row.next();) result.push_back({static_cast<std::int32_t>(row.integer(0)), row.integer(1), row.text(2)});
  return result;
}

std::vector<PlaneId> ids_by_number(const Database& database, ScanId scan) {
  Statement select = database.prepare("SELECT id, number FROM plane WHERE scan_id = ?");
  std::vector<PlaneId> ids;
  auto row = select.use();
  for (row(scan); row.next();) {
    const auto number = static_cast<std::size_t>(row.integer(1));
    if (number >= ids.size()) ids.resize(number + 1, -1);
    ids[number] = row.integer(0);
  }
  return ids;
}

std::vector<std::int32_t> read_point_numbers(const Database& database, ScanId scan) {
  Statement select = database.prepare(
      "SELECT s.point_count, p.plane_numbers FROM scan s JOIN scan_points p ON p.scan_id = s.id WHERE s.id = ?");
  auto row = select.use();
  if (!row(scan).next()) return {};
  try {
    return decode_runs(row.blob(1), static_cast<std::size_t>(row.integer(0)));
  } catch (const Error& error) {
    throw Error(database.name() + ": scan_points row " + std::to_string(scan) + ": " + error.what());
  }
}

void check_input(const Database& database, const Scan& scan, std::size_t planes, const std::vector<std::int32_t>& plane_of_point) {
  const std::string where = database.name() + ": scan '" + scan.name + "': ";
  if (scan.name.empty()) throw Error(where + "a scan needs a name");
  if (static_cast<std::size_t>(scan.point_count) != plane_of_point.size()) {
    throw Error(where + "has " + std::to_string(scan.point_count) + " points, but plane numbers for " +
                std::to_string(plane_of_point.size()));
  }
  for (const std::int32_t number : plane_of_point) {
    if (number < -1 || number >= static_cast<std::int64_t>(planes)) {
      throw Error(where + "a point has plane number " + std::to_string(number) + " of " + std::to_string(planes));
    }
  }
}

bool unchanged(const Database& database, const Scan& before, const Scan& now, const std::vector<perception::Plane>& planes,
               const std::vector<std::int32_t>& plane_of_point) {
  if (now.sha256.empty() || before.sha256 != now.sha256 || before.origin != now.origin ||
      before.rotation.coeffs() != now.rotation.coeffs() || before.floor_z != now.floor_z ||
      before.point_count != now.point_count) {
    return false;
  }
  const std::vector<StoredPlane> stored = read_planes(database, before.id);
  const auto same = [](const StoredPlane& a, const perception::Plane& b) { return same_plane(a.plane, b); };
  return std::equal(stored.begin(), stored.end(), planes.begin(), planes.end(), same) &&
         read_point_numbers(database, before.id) == plane_of_point;
}

void write_scan(Database& database, const Scan& scan) {
  Statement upsert = database.prepare(
      "INSERT INTO scan (id, name, source, sha256, point_count, origin_x, origin_y, origin_z, qw, qx, qy, qz, floor_z, "
      "parameters, imported_at) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
      "coalesce(?, strftime('%Y-%m-%dT%H:%M:%SZ', 'now'))) ON CONFLICT (id) DO UPDATE SET name = excluded.name, "
      "source = excluded.source, sha256 = excluded.sha256, point_count = excluded.point_count, origin_x = excluded.origin_x, "
      "origin_y = excluded.origin_y, origin_z = excluded.origin_z, qw = excluded.qw, qx = excluded.qx, qy = excluded.qy, "
      "qz = excluded.qz, floor_z = excluded.floor_z, parameters = excluded.parameters, imported_at = excluded.imported_at");
  auto use = upsert.use();
  scan.id == 0 ? use(std::nullopt) : use(scan.id);
  use(scan.name)(scan.source)(scan.sha256)(scan.point_count);
  for (const double value : {scan.origin.x(), scan.origin.y(), scan.origin.z(), scan.rotation.w(), scan.rotation.x(),
                             scan.rotation.y(), scan.rotation.z(), scan.floor_z}) {
    use(value);
  }
  use(scan.parameters.empty() ? "{}" : scan.parameters);
  scan.imported_at.empty() ? use(std::nullopt) : use(scan.imported_at);
  use.run();
}

void delete_world(Database& database, ScanId scan) {
  for (const char* const sql : {"DELETE FROM plane WHERE scan_id = ?", "DELETE FROM scan_points WHERE scan_id = ?",
                                "DELETE FROM run WHERE scan_id = ?"}) {
    database.prepare(sql).use()(scan).run();
  }
}

void restore_truth(Database& database, const Scan& scan, const std::vector<OldTruth>& truth,
                   const std::vector<std::int32_t>& match, std::vector<std::string>* warnings) {
  const std::vector<PlaneId> ids = ids_by_number(database, scan.id);
  Statement insert = database.prepare("INSERT INTO truth (plane_id, class) VALUES (?, ?)");
  for (const OldTruth& row : truth) {
    const std::int32_t number = match[static_cast<std::size_t>(row.number)];
    if (number >= 0) {
      insert.use()(ids[static_cast<std::size_t>(number)])(row.object_class).run();
    } else if (warnings != nullptr) {
      warnings->push_back("scan '" + scan.name + "': the truth that plane " + std::to_string(row.plane) + " is '" +
                          row.object_class + "' is lost, since no new plane shares most of its points");
    }
  }
}

}  // namespace

std::vector<Scan> KnowledgeBase::scans() const { return read_scans(implementation_->database); }

std::optional<Scan> KnowledgeBase::find_scan(const std::string& name) const {
  for (Scan& scan : scans()) {
    if (scan.name == name) return std::move(scan);
  }
  return std::nullopt;
}

ScanId KnowledgeBase::store_scan(const Scan& scan, const std::vector<perception::Plane>& planes,
                                 const std::vector<std::int32_t>& plane_of_point, std::vector<std::string>* warnings) {
  Database& database = implementation_->database;
  check_input(database, scan, planes.size(), plane_of_point);
  Transaction transaction(database);
  const std::optional<Scan> before = find_scan(scan.name);
  Scan stored = scan;
  stored.id = before ? before->id : 0;
  if (before && unchanged(database, *before, scan, planes, plane_of_point)) {
    write_scan(database, stored);
    transaction.commit();
    return stored.id;
  }
  std::vector<OldTruth> truth;
  std::vector<std::int32_t> match;
  if (before) {
    truth = read_truth(database, before->id);
    if (!truth.empty()) {
      match = match_planes(read_point_numbers(database, before->id), plane_of_point,
                           ids_by_number(database, before->id).size());
    }
    delete_world(database, before->id);
  }
  write_scan(database, stored);
  if (!before) stored.id = database.last_id();
  insert_planes(database, stored, planes);
  const std::vector<std::byte> runs = encode_runs(plane_of_point);
  database.prepare("INSERT INTO scan_points (scan_id, encoding, plane_numbers) VALUES (?, 'runs1', ?)").use()(stored.id)(runs).run();
  restore_truth(database, stored, truth, match, warnings);
  grow_layer_extents(database, stored, planes);
  transaction.commit();
  return stored.id;
}

std::vector<StoredPlane> KnowledgeBase::planes(ScanId scan) const { return read_planes(implementation_->database, scan); }

std::vector<std::int64_t> KnowledgeBase::plane_of_point(ScanId scan) const {
  const std::vector<PlaneId> ids = ids_by_number(implementation_->database, scan);
  const std::vector<std::int32_t> numbers = read_point_numbers(implementation_->database, scan);
  std::vector<std::int64_t> result(numbers.size(), -1);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::int32_t number = numbers[i];
    // A plane whose row somebody deleted is no plane any more.
    if (number >= 0 && static_cast<std::size_t>(number) < ids.size()) result[i] = ids[static_cast<std::size_t>(number)];
  }
  return result;
}

std::vector<std::pair<PlaneId, std::string>> KnowledgeBase::truth(ScanId scan) const {
  const Database& database = implementation_->database;
  Statement orphan = database.prepare("SELECT plane_id FROM truth WHERE plane_id NOT IN (SELECT id FROM plane) ORDER BY 1");
  if (auto row = orphan.use(); row.next()) {
    throw Error(database.name() + ": truth row " + std::to_string(row.integer(0)) + ": there is no plane of this number");
  }
  std::vector<std::string> classes;
  Statement names = database.prepare("SELECT name FROM object_class ORDER BY id");
  for (auto row = names.use(); row.next();) classes.push_back(row.text(0));
  std::vector<std::pair<PlaneId, std::string>> result;
  for (const OldTruth& row : read_truth(database, scan)) {
    if (std::find(classes.begin(), classes.end(), row.object_class) == classes.end()) {
      throw Error(database.name() + ": truth row " + std::to_string(row.plane) + ": class '" + row.object_class +
                  "' does not exist" + did_you_mean(row.object_class, classes));
    }
    result.emplace_back(row.plane, row.object_class);
  }
  return result;
}

}  // namespace scenelore::kb
