-- Schema version 1: the knowledge base file. One SQLite file that is also a valid GeoPackage (OGC 12-128r17).
-- Metres where a name carries no unit; booleans are 0/1; angles in degrees carry _deg.

-- ---------------------------------------------------------------------------------------------------------------------
-- GeoPackage frame. 0x47504B47 = "GPKG"; 10300 = GeoPackage 1.3 (GDAL 3.6 warns of later ones), never our own version.
PRAGMA application_id = 0x47504B47;
PRAGMA user_version = 10300;

CREATE TABLE gpkg_spatial_ref_sys (
  srs_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL PRIMARY KEY,
  organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL,
  definition TEXT NOT NULL,
  description TEXT
);
INSERT INTO gpkg_spatial_ref_sys VALUES
  ('Undefined Cartesian SRS', -1, 'NONE', -1, 'undefined', 'undefined Cartesian coordinate reference system'),
  ('Undefined geographic SRS', 0, 'NONE', 0, 'undefined', 'undefined geographic coordinate reference system'),
  ('WGS 84 geodetic', 4326, 'EPSG', 4326, 'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AXIS["Latitude",NORTH],AXIS["Longitude",EAST],AUTHORITY["EPSG","4326"]]', 'longitude/latitude on the WGS 84 spheroid');

CREATE TABLE gpkg_contents (
  table_name TEXT NOT NULL PRIMARY KEY,
  data_type TEXT NOT NULL,
  identifier TEXT UNIQUE,
  description TEXT DEFAULT '',
  last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')),
  min_x DOUBLE,
  min_y DOUBLE,
  max_x DOUBLE,
  max_y DOUBLE,
  srs_id INTEGER,
  CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id)
);

CREATE TABLE gpkg_geometry_columns (
  table_name TEXT NOT NULL,
  column_name TEXT NOT NULL,
  geometry_type_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL,
  z TINYINT NOT NULL,
  m TINYINT NOT NULL,
  CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name),
  CONSTRAINT uk_gc_table_name UNIQUE (table_name),
  CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name),
  CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id)
);

-- Our own version, apart from GeoPackage's. A program of schema version v reads the file when oldest_reader <= v, and
-- writes it when schema_version <= v (after migrating it).
CREATE TABLE scenelore_meta (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  schema_version INTEGER NOT NULL,
  oldest_reader INTEGER NOT NULL,  -- oldest schema version whose programs can still read this file
  knowledge_pack TEXT NOT NULL     -- the pack the file was created with: office, paper, empty
) STRICT;
INSERT INTO scenelore_meta VALUES (1, 1, 1, '');

-- ---------------------------------------------------------------------------------------------------------------------
-- Knowledge: edited by people. Adding a class is adding rows; nothing is compiled or trained.

CREATE TABLE object_class (
  id INTEGER PRIMARY KEY CHECK (id BETWEEN 0 AND 1000000),  -- the number in labelled clouds
  name TEXT NOT NULL UNIQUE CHECK (length(name) > 0),       -- what all other rows refer to
  prior REAL NOT NULL DEFAULT 0.02 CHECK (prior > 0 AND prior < 1e300),  -- share of planes; normalised over all classes
  description TEXT NOT NULL DEFAULT '',
  color TEXT NOT NULL DEFAULT '#9e9e9e'
    CHECK (color GLOB '#[0-9a-fA-F][0-9a-fA-F][0-9a-fA-F][0-9a-fA-F][0-9a-fA-F][0-9a-fA-F]'),
  fallback INTEGER NOT NULL DEFAULT 0 CHECK (fallback IN (0, 1))  -- 1: takes what fits nothing; exactly one class
) STRICT;
CREATE UNIQUE INDEX object_class_one_fallback ON object_class(fallback) WHERE fallback = 1;

CREATE TABLE feature (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE CHECK (length(name) > 0),
  unit TEXT NOT NULL DEFAULT '1',
  scale TEXT NOT NULL DEFAULT 'linear' CHECK (scale IN ('linear', 'log', 'circular')),  -- log: densities are of ln x; circular: high - low is one turn
  low REAL NOT NULL,   -- range of values, in the unit; a class without rows for this feature is uniform over it
  high REAL NOT NULL,
  weight REAL NOT NULL DEFAULT 1 CHECK (weight >= 0 AND weight < 1e300),  -- F_i: exponent in the product, weight in the mean; 0 = not used
  description TEXT NOT NULL DEFAULT '',
  CHECK (low < high),
  CHECK (scale <> 'log' OR low > 0)
) STRICT;

-- A Gaussian. No row means: this feature says nothing about this class (uniform over the feature's range).
CREATE TABLE class_feature (
  id INTEGER PRIMARY KEY,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  feature TEXT NOT NULL REFERENCES feature(name) ON UPDATE CASCADE ON DELETE CASCADE,
  mean REAL NOT NULL,                     -- on the feature's scale: of ln x for log features, so ln(0.45) for 45 cm
  sigma REAL NOT NULL CHECK (sigma > 0),  -- standard deviation on that scale
  UNIQUE (class, feature)
) STRICT;

-- One bin of a histogram that replaces the Gaussian of its class and feature. Between and outside bins the density is 0.
CREATE TABLE class_density (
  id INTEGER PRIMARY KEY,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  feature TEXT NOT NULL REFERENCES feature(name) ON UPDATE CASCADE ON DELETE CASCADE,
  low REAL NOT NULL,   -- bounds of the bin in the feature's unit
  high REAL NOT NULL,
  density REAL NOT NULL CHECK (density >= 0),  -- per unit of the feature's scale: per unit of ln x for log features
  UNIQUE (class, feature, low),
  CHECK (low < high)
) STRICT;

CREATE TABLE setting (
  id INTEGER PRIMARY KEY,
  key TEXT NOT NULL UNIQUE CHECK (length(key) > 0),
  value TEXT NOT NULL,
  description TEXT NOT NULL DEFAULT '',
  CHECK (key <> 'combination' OR value IN ('product', 'mean')),
  CHECK (key <> 'floor' OR value IN ('ranked', 'threshold')),
  CHECK (key <> 'floor_threshold' OR CAST(value AS REAL) BETWEEN 0 AND 1),
  CHECK (key <> 'outlier_share' OR CAST(value AS REAL) BETWEEN 0 AND 0.5)
) STRICT;

-- For each plane labelled `class`; see docs/rules.md. "Screens stand over a table" is the row
-- ('screen_over_table', 'flat_screen', 'some', 'above', 'table', NULL, 2.5, 'a flat screen stands over some table', 1).
CREATE TABLE class_constraint (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE CHECK (length(name) > 0),
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  quantifier TEXT NOT NULL CHECK (quantifier IN ('some', 'every', 'no', 'at_most', 'at_least')),
  relation TEXT,     -- name of a Lua relation; NULL only for at_most / at_least: planes of `class` in the scene
  other_class TEXT REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,  -- NULL = any class but the fallback
  count INTEGER CHECK (count >= 0),  -- for at_most / at_least, NULL else
  weight REAL CHECK (weight > 0),    -- nats paid when it does not hold; NULL = hard, it must hold
  message TEXT NOT NULL DEFAULT '',  -- the constraint in words, used in reasons
  enabled INTEGER NOT NULL DEFAULT 1 CHECK (enabled IN (0, 1)),
  CHECK ((quantifier IN ('at_most', 'at_least')) = (count IS NOT NULL)),
  CHECK (relation IS NOT NULL OR (quantifier IN ('at_most', 'at_least') AND other_class IS NULL))
) STRICT;
CREATE INDEX class_constraint_class ON class_constraint(class);
CREATE INDEX class_constraint_other_class ON class_constraint(other_class);

-- ---------------------------------------------------------------------------------------------------------------------
-- World: written by perception.

CREATE TABLE scan (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  name TEXT NOT NULL UNIQUE CHECK (length(name) > 0),
  source TEXT NOT NULL,   -- path as the user gave it
  sha256 TEXT NOT NULL,   -- of the source file, lower-case hexadecimal; '' = not known
  point_count INTEGER NOT NULL CHECK (point_count >= 0),
  origin_x REAL NOT NULL, -- what perception subtracted to keep precision; already added back to all stored coordinates
  origin_y REAL NOT NULL,
  origin_z REAL NOT NULL,
  qw REAL NOT NULL,       -- unit quaternion from the scan's frame to the upright frame (z up)
  qx REAL NOT NULL,
  qy REAL NOT NULL,
  qz REAL NOT NULL,
  floor_z REAL NOT NULL,  -- floor level along the upright z: height = (q p).z - floor_z
  parameters TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(parameters)),  -- JSON: everything that chose this segmentation
  imported_at TEXT NOT NULL  -- ISO 8601, UTC
) STRICT;

-- A feature layer, so not STRICT. Coordinates are the scan's own (those of its source file).
CREATE TABLE plane (
  id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL,
  geom POLYGON,                      -- hull with holes, POLYGON Z; empty for a degenerate plane
  scan_id INTEGER NOT NULL REFERENCES scan(id) ON DELETE CASCADE,
  number INTEGER NOT NULL CHECK (number >= 0),  -- place in the segmentation, from 0; what scan_points refers to
  x DOUBLE NOT NULL,                 -- centroid
  y DOUBLE NOT NULL,
  z DOUBLE NOT NULL,
  height DOUBLE NOT NULL,            -- of the centroid above the floor
  normal_x DOUBLE NOT NULL,          -- unit normal, towards the sensor where its position is known, else upwards
  normal_y DOUBLE NOT NULL,
  normal_z DOUBLE NOT NULL,
  qw DOUBLE NOT NULL,                -- orientation: rotates local axes (z = normal, y = longest) into the scan's frame
  qx DOUBLE NOT NULL,
  qy DOUBLE NOT NULL,
  qz DOUBLE NOT NULL,
  area_m2 DOUBLE NOT NULL CHECK (area_m2 >= 0),
  length DOUBLE NOT NULL CHECK (length >= 0),  -- sides of the minimum-area rectangle
  width DOUBLE NOT NULL CHECK (width >= 0),
  rectangularity DOUBLE NOT NULL CHECK (rectangularity BETWEEN 0 AND 1),
  tilt_deg DOUBLE NOT NULL CHECK (tilt_deg BETWEEN 0 AND 90),  -- between normal and vertical: 0 = horizontal plane
  rmse DOUBLE NOT NULL CHECK (rmse >= 0),
  point_count INTEGER NOT NULL CHECK (point_count >= 0),
  z_min DOUBLE NOT NULL,             -- lower and upper edge above the floor
  z_max DOUBLE NOT NULL,
  facing_up DOUBLE NOT NULL CHECK (facing_up BETWEEN -1 AND 1),  -- z of the upright normal on the sensor's side
  point_density DOUBLE NOT NULL CHECK (point_density >= 0),      -- points a square metre
  seen_share DOUBLE NOT NULL CHECK (seen_share BETWEEN 0 AND 1), -- share of the hull that holds points
  UNIQUE (scan_id, number)
);

-- Every feature of the catalogue, Lua ones too. A value that is not known has no row.
CREATE TABLE plane_feature (
  id INTEGER PRIMARY KEY,
  plane_id INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,
  feature TEXT NOT NULL REFERENCES feature(name) ON UPDATE CASCADE ON DELETE CASCADE,
  value REAL NOT NULL,
  UNIQUE (plane_id, feature)
) STRICT;
CREATE INDEX plane_feature_feature ON plane_feature(feature);

-- The plane number of each point of the source file, in file order.
CREATE TABLE scan_points (
  scan_id INTEGER PRIMARY KEY REFERENCES scan(id) ON DELETE CASCADE,
  encoding TEXT NOT NULL CHECK (encoding = 'runs1'),
  -- runs1: for each run of equal numbers two LEB128 varints: plane number + 1 (0 = no plane), then the run's length.
  plane_numbers BLOB NOT NULL
) STRICT;

-- What a person knows. A row fixes that plane's label in the next run, and feeds learning and evaluation.
CREATE TABLE truth (
  plane_id INTEGER PRIMARY KEY REFERENCES plane(id) ON DELETE CASCADE,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE
) STRICT;
CREATE INDEX truth_class ON truth(class);

-- ---------------------------------------------------------------------------------------------------------------------
-- Inference: written by the engine, replaced as a whole by the next run over the same scan.

CREATE TABLE run (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  scan_id INTEGER NOT NULL UNIQUE REFERENCES scan(id) ON DELETE CASCADE,
  outcome TEXT NOT NULL CHECK (outcome IN ('proved', 'feasible', 'infeasible', 'stopped')),
  cost REAL,              -- nats: -ln of the product of probabilities + what soft constraints cost; NULL = no world found
  lower_bound REAL,       -- no world model is cheaper than this
  nodes INTEGER NOT NULL CHECK (nodes >= 0),
  seconds REAL NOT NULL CHECK (seconds >= 0),
  knowledge_hash TEXT NOT NULL,
  rules_hash TEXT NOT NULL,
  engine_version TEXT NOT NULL,
  started_at TEXT NOT NULL  -- ISO 8601, UTC
) STRICT;

CREATE TABLE evidence (
  id INTEGER PRIMARY KEY,
  plane_id INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  probability REAL NOT NULL CHECK (probability BETWEEN 0 AND 1),  -- P(class | features), before any constraint
  UNIQUE (plane_id, class)
) STRICT;
CREATE INDEX evidence_class ON evidence(class);

CREATE TABLE relation_fact (
  id INTEGER PRIMARY KEY,
  scan_id INTEGER NOT NULL REFERENCES scan(id) ON DELETE CASCADE,
  relation TEXT NOT NULL,
  a INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,  -- the relation holds from plane a to plane b
  b INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,
  degree REAL NOT NULL CHECK (degree > 0 AND degree <= 1),
  UNIQUE (a, relation, b)
) STRICT;
CREATE INDEX relation_fact_b ON relation_fact(b);
CREATE INDEX relation_fact_scan ON relation_fact(scan_id, relation);

CREATE TABLE label (
  plane_id INTEGER PRIMARY KEY REFERENCES plane(id) ON DELETE CASCADE,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  probability REAL NOT NULL CHECK (probability BETWEEN 0 AND 1),  -- marginal over the consistent world models
  run_id INTEGER NOT NULL REFERENCES run(id) ON DELETE CASCADE,
  margin REAL NOT NULL CHECK (margin >= 0),  -- nats: extra cost of the best world where this plane is something else; Inf = none
  runner_up TEXT REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE SET NULL  -- its class in that world
) STRICT;
CREATE INDEX label_class ON label(class);
CREATE INDEX label_runner_up ON label(runner_up);
CREATE INDEX label_run ON label(run_id);

-- A label that a person corrects, in a GIS or by UPDATE, becomes truth. The engine itself only deletes and inserts; the
-- second condition leaves renaming a class alone, which reaches here through ON UPDATE CASCADE.
CREATE TRIGGER label_corrected AFTER UPDATE OF class ON label
WHEN NEW.class <> OLD.class AND EXISTS (SELECT 1 FROM object_class WHERE name = OLD.class)
BEGIN
  INSERT INTO truth (plane_id, class) VALUES (NEW.plane_id, NEW.class)
    ON CONFLICT (plane_id) DO UPDATE SET class = excluded.class;
END;

-- The next best world models, where they differ from the first.
CREATE TABLE alternative (
  id INTEGER PRIMARY KEY,
  run_id INTEGER NOT NULL REFERENCES run(id) ON DELETE CASCADE,
  rank INTEGER NOT NULL CHECK (rank >= 2),  -- 2 = second best world
  plane_id INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  UNIQUE (run_id, rank, plane_id)
) STRICT;
CREATE INDEX alternative_plane ON alternative(plane_id);
CREATE INDEX alternative_class ON alternative(class);

CREATE TABLE reason (
  id INTEGER PRIMARY KEY,
  run_id INTEGER NOT NULL REFERENCES run(id) ON DELETE CASCADE,
  plane_id INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,  -- what the reason speaks for or against
  kind TEXT NOT NULL,      -- evidence, support, violation, runner_up, truth, floor
  constraint_name TEXT,    -- of the row in class_constraint
  other_plane_id INTEGER REFERENCES plane(id) ON DELETE CASCADE,
  amount REAL NOT NULL,    -- nats in favour (> 0) or against (< 0)
  sentence TEXT NOT NULL
) STRICT;
CREATE INDEX reason_run ON reason(run_id);
CREATE INDEX reason_plane ON reason(plane_id);
CREATE INDEX reason_class ON reason(class);
CREATE INDEX reason_other_plane ON reason(other_plane_id);

-- ---------------------------------------------------------------------------------------------------------------------
-- Views for people: short columns, stable names.

CREATE VIEW labelled_plane AS
SELECT s.name AS scan, p.id AS plane, l.class AS class, l.probability AS probability, e.probability AS evidence,
       l.margin AS margin, l.runner_up AS runner_up, p.height AS height, p.area_m2 AS area_m2, p.length AS length,
       p.width AS width, p.tilt_deg AS tilt_deg
FROM label l
JOIN plane p ON p.id = l.plane_id
JOIN scan s ON s.id = p.scan_id
LEFT JOIN evidence e ON e.plane_id = p.id AND e.class = l.class;

-- UPDATE labelled_plane SET class = 'table' WHERE plane = 7 corrects a label.
CREATE TRIGGER labelled_plane_corrected INSTEAD OF UPDATE OF class ON labelled_plane
BEGIN
  UPDATE label SET class = NEW.class WHERE plane_id = OLD.plane;
END;

CREATE VIEW labelled_relation AS
SELECT s.name AS scan, r.relation AS relation, r.a AS a, la.class AS a_class, r.b AS b, lb.class AS b_class,
       r.degree AS degree
FROM relation_fact r
JOIN scan s ON s.id = r.scan_id
JOIN label la ON la.plane_id = r.a
JOIN label lb ON lb.plane_id = r.b;

CREATE VIEW class_count AS
SELECT s.name AS scan, l.class AS class, count(*) AS planes
FROM label l
JOIN plane p ON p.id = l.plane_id
JOIN scan s ON s.id = p.scan_id
GROUP BY s.id, l.class;

-- Smallest margins first; planes that a person has spoken about are left out.
CREATE VIEW needs_review AS
SELECT s.name AS scan, p.id AS plane, l.class AS class, l.probability AS probability, l.margin AS margin,
       l.runner_up AS runner_up, p.height AS height, p.area_m2 AS area_m2
FROM label l
JOIN plane p ON p.id = l.plane_id
JOIN scan s ON s.id = p.scan_id
WHERE p.id NOT IN (SELECT plane_id FROM truth)
ORDER BY l.margin, p.id;

-- The planes with their labels as a layer for GIS programs. Its first column identifies a feature.
CREATE VIEW labelled_plane_3d AS
SELECT p.id AS id, p.geom AS geom, s.name AS scan, l.class AS class, c.color AS color, l.probability AS probability,
       l.margin AS margin, l.runner_up AS runner_up, p.height AS height, p.area_m2 AS area_m2, p.length AS length,
       p.width AS width, p.tilt_deg AS tilt_deg
FROM label l
JOIN plane p ON p.id = l.plane_id
JOIN scan s ON s.id = p.scan_id
JOIN object_class c ON c.name = l.class;

INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('plane', 'features', 'plane', 'segmented planes with their feature vectors', -1),
  ('labelled_plane_3d', 'features', 'labelled_plane_3d', 'planes with their labels', -1),
  ('object_class', 'attributes', 'object_class', 'classes of objects', NULL),
  ('feature', 'attributes', 'feature', 'catalogue of features', NULL),
  ('class_feature', 'attributes', 'class_feature', 'Gaussian of a feature of a class', NULL),
  ('class_density', 'attributes', 'class_density', 'histogram of a feature of a class', NULL),
  ('setting', 'attributes', 'setting', 'switches of the knowledge', NULL),
  ('class_constraint', 'attributes', 'class_constraint', 'constraints between classes', NULL),
  ('truth', 'attributes', 'truth', 'classes of planes that a person knows', NULL),
  ('scan', 'attributes', 'scan', 'imported scans', NULL),
  ('plane_feature', 'attributes', 'plane_feature', 'values of all features of planes', NULL),
  ('scan_points', 'attributes', 'scan_points', 'plane numbers of the points of a scan', NULL),
  ('run', 'attributes', 'run', 'the last run over each scan', NULL),
  ('evidence', 'attributes', 'evidence', 'probabilities before constraints', NULL),
  ('relation_fact', 'attributes', 'relation_fact', 'relations that hold between planes', NULL),
  ('label', 'attributes', 'label', 'the labels', NULL),
  ('alternative', 'attributes', 'alternative', 'the next best world models', NULL),
  ('reason', 'attributes', 'reason', 'why each label', NULL);
INSERT INTO gpkg_geometry_columns VALUES
  ('plane', 'geom', 'POLYGON', -1, 1, 0),
  ('labelled_plane_3d', 'geom', 'POLYGON', -1, 1, 0);
