// Rows of the tables scan, plane and plane_plan, to and from values.
#pragma once

#include <cstddef>
#include <vector>

#include "scenelore/kb/knowledge_base.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {

[[nodiscard]] std::vector<Scan> read_scans(const Database& database);
[[nodiscard]] std::vector<StoredPlane> read_planes(const Database& database, ScanId scan);

/// Inserts plane rows with numbers 0, 1, … and their footprints. `scan.id` says whose.
void insert_planes(Database& database, const Scan& scan, const std::vector<perception::Plane>& planes);

/// Footprints of all planes that have none.
void store_missing_footprints(Database& database);

/// Widens the extents of the layers in gpkg_contents (which GeoPackage wants informative, not tight) to these planes.
void grow_layer_extents(Database& database, const Scan& scan, const std::vector<perception::Plane>& planes);

/// Equal in every value that a row holds.
[[nodiscard]] bool same_plane(const perception::Plane& a, const perception::Plane& b);

}  // namespace scenelore::kb
