#include "plane_rows.hpp"

#include <algorithm>
#include <array>

#include "footprint.hpp"
#include "geometry_blob.hpp"

namespace scenelore::kb {

namespace {

// The order in which insert_planes binds and read_plane reads.
constexpr std::string_view kPlaneColumns =
    "geom, x, y, z, normal_x, normal_y, normal_z, qw, qx, qy, qz, area_m2, length, width, rectangularity, tilt_deg, "
    "height, z_min, z_max, rmse, facing_up, point_density, seen_share, spread_length, spread_width, "
    "behind, edge_free, edge_free_top, edge_joined, edge_unseen, point_count";

Eigen::Vector3d vector_at(const Statement::Use& row, int column) {
  return {row.real(column), row.real(column + 1), row.real(column + 2)};
}

Eigen::Quaterniond quaternion_at(const Statement::Use& row, int column) {
  return {row.real(column), row.real(column + 1), row.real(column + 2), row.real(column + 3)};
}

perception::Plane read_plane(const Statement::Use& row, int column) {
  perception::Plane plane;
  if (!row.is_null(column)) plane.hull = decode_polygon(row.blob(column));
  plane.centroid = vector_at(row, column + 1);
  plane.normal = vector_at(row, column + 4);
  plane.orientation = quaternion_at(row, column + 7);
  column += 11;
  for (double* value : {&plane.area_m2, &plane.length, &plane.width, &plane.rectangularity, &plane.tilt_deg,
                        &plane.height, &plane.z_min, &plane.z_max, &plane.rmse, &plane.facing_up,
                        &plane.point_density, &plane.seen_share, &plane.spread_length, &plane.spread_width}) {
    *value = row.real(column++);
  }
  for (double* share : {&plane.behind, &plane.edge_free, &plane.edge_free_top, &plane.edge_joined, &plane.edge_unseen}) {
    if (!row.is_null(column)) *share = row.real(column);
    ++column;
  }
  plane.point_count = static_cast<std::size_t>(row.integer(column));
  return plane;
}

// The values of kPlaneColumns between geom and behind. Ratios that rounding pushed over their range are put back.
std::vector<double> numbers_of(const perception::Plane& plane) {
  return {plane.centroid.x(), plane.centroid.y(), plane.centroid.z(), plane.normal.x(), plane.normal.y(),
          plane.normal.z(), plane.orientation.w(), plane.orientation.x(), plane.orientation.y(), plane.orientation.z(),
          plane.area_m2, plane.length, plane.width, std::clamp(plane.rectangularity, 0.0, 1.0),
          std::clamp(plane.tilt_deg, 0.0, 90.0), plane.height, plane.z_min, plane.z_max, plane.rmse,
          std::clamp(plane.facing_up, -1.0, 1.0), plane.point_density, std::clamp(plane.seen_share, 0.0, 1.0),
          plane.spread_length, plane.spread_width};
}

// What may be unknown, between those and the number of points: a share, −1 = not known.
std::array<double, 5> shares_of(const perception::Plane& plane) {
  return {plane.behind, plane.edge_free, plane.edge_free_top, plane.edge_joined, plane.edge_unseen};
}

std::string placeholders(std::ptrdiff_t count) {
  std::string text;
  for (std::ptrdiff_t i = 0; i < count; ++i) text += i == 0 ? "?" : ", ?";
  return text;
}

void store_footprint(Statement& insert, const Scan& scan, PlaneId id, const perception::Plane& plane) {
  const std::vector<std::byte> blob = encode_polygon(footprint(scan, plane), Dimensions::xy);
  insert.use()(id)(blob).run();
}

constexpr std::string_view kInsertFootprint = "INSERT INTO plane_plan (plane_id, geom) VALUES (?, ?)";

}  // namespace

std::vector<Scan> read_scans(const Database& database) {
  Statement select = database.prepare(
      "SELECT id, name, source, sha256, point_count, origin_x, origin_y, origin_z, qw, qx, qy, qz, floor_z, parameters, "
      "imported_at FROM scan ORDER BY id");
  std::vector<Scan> scans;
  for (auto row = select.use(); row.next();) {
    scans.push_back({.id = row.integer(0), .name = row.text(1), .source = row.text(2), .sha256 = row.text(3),
                     .point_count = row.integer(4), .origin = vector_at(row, 5), .rotation = quaternion_at(row, 8),
                     .floor_z = row.real(12), .parameters = row.text(13), .imported_at = row.text(14)});
  }
  return scans;
}

std::vector<StoredPlane> read_planes(const Database& database, ScanId scan) {
  Statement select = database.prepare("SELECT id, " + std::string(kPlaneColumns) +
                                      " FROM plane WHERE scan_id = ? ORDER BY id");
  std::vector<StoredPlane> planes;
  auto row = select.use();
  for (row(scan); row.next();) {
    try {
      planes.push_back({row.integer(0), read_plane(row, 1)});
    } catch (const Error& error) {
      throw Error(database.name() + ": plane " + std::to_string(row.integer(0)) + ": " + error.what());
    }
  }
  return planes;
}

void insert_planes(Database& database, const Scan& scan, const std::vector<perception::Plane>& planes) {
  const auto columns = 2 + 1 + std::count(kPlaneColumns.begin(), kPlaneColumns.end(), ',');
  Statement insert = database.prepare("INSERT INTO plane (scan_id, number, " + std::string(kPlaneColumns) +
                                      ") VALUES (" + placeholders(columns) + ")");
  Statement insert_footprint = database.prepare(kInsertFootprint);
  std::int64_t number = 0;
  for (const perception::Plane& plane : planes) {
    const std::vector<std::byte> geometry = encode_polygon(plane.hull, Dimensions::xyz);
    auto use = insert.use();
    use(scan.id)(number++)(geometry);
    for (const double value : numbers_of(plane)) use(value);
    for (const double share : shares_of(plane)) use(share >= 0 ? std::optional(std::min(share, 1.0)) : std::nullopt);
    use(static_cast<std::int64_t>(plane.point_count)).run();
    store_footprint(insert_footprint, scan, database.last_id(), plane);
  }
}

void store_missing_footprints(Database& database) {
  Statement insert = database.prepare(kInsertFootprint);
  Statement missing = database.prepare("SELECT 1 FROM plane WHERE id = ? AND id NOT IN (SELECT plane_id FROM plane_plan)");
  for (const Scan& scan : read_scans(database)) {
    std::vector<perception::Plane> planes;
    for (const StoredPlane& stored : read_planes(database, scan.id)) {
      planes.push_back(stored.plane);
      auto use = missing.use();
      use(stored.id);
      if (use.next()) store_footprint(insert, scan, stored.id, stored.plane);
    }
    grow_layer_extents(database, scan, planes);
  }
}

bool same_plane(const perception::Plane& a, const perception::Plane& b) {
  return a.point_count == b.point_count && shares_of(a) == shares_of(b) && numbers_of(a) == numbers_of(b) &&
         encode_polygon(a.hull, Dimensions::xyz) == encode_polygon(b.hull, Dimensions::xyz);
}

namespace {

struct Extent {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = -low;
  void add(const perception::Ring& ring) {
    for (const Eigen::Vector3d& corner : ring) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
};

void grow(Database& database, const std::vector<std::string>& layers, const Extent& extent) {
  if (extent.low.x() > extent.high.x()) return;
  Statement update = database.prepare(
      "UPDATE gpkg_contents SET min_x = min(coalesce(min_x, ?1), ?1), min_y = min(coalesce(min_y, ?2), ?2), "
      "max_x = max(coalesce(max_x, ?3), ?3), max_y = max(coalesce(max_y, ?4), ?4), "
      "last_change = strftime('%Y-%m-%dT%H:%M:%fZ', 'now') WHERE table_name = ?5");
  for (const std::string& layer : layers) {
    update.use()(extent.low.x())(extent.low.y())(extent.high.x())(extent.high.y())(layer).run();
  }
}

}  // namespace

void grow_layer_extents(Database& database, const Scan& scan, const std::vector<perception::Plane>& planes) {
  Extent in_scan, in_plan;
  for (const perception::Plane& plane : planes) {
    in_scan.add(plane.hull.outer);
    in_plan.add(footprint(scan, plane).outer);
  }
  grow(database, {"plane", "labelled_plane_3d"}, in_scan);
  grow(database, {"plane_plan", "labelled_plane_plan"}, in_plan);
}

}  // namespace scenelore::kb
