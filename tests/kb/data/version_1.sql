PRAGMA foreign_keys = OFF;
BEGIN TRANSACTION;
CREATE TABLE gpkg_spatial_ref_sys (
  srs_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL PRIMARY KEY,
  organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL,
  definition TEXT NOT NULL,
  description TEXT
);
INSERT INTO gpkg_spatial_ref_sys VALUES('Undefined Cartesian SRS',-1,'NONE',-1,'undefined','undefined Cartesian coordinate reference system');
INSERT INTO gpkg_spatial_ref_sys VALUES('Undefined geographic SRS',0,'NONE',0,'undefined','undefined geographic coordinate reference system');
INSERT INTO gpkg_spatial_ref_sys VALUES('WGS 84 geodetic',4326,'EPSG',4326,'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AXIS["Latitude",NORTH],AXIS["Longitude",EAST],AUTHORITY["EPSG","4326"]]','longitude/latitude on the WGS 84 spheroid');
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
INSERT INTO gpkg_contents VALUES('plane','features','plane','segmented planes with their feature vectors','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,-1);
INSERT INTO gpkg_contents VALUES('labelled_plane_3d','features','labelled_plane_3d','planes with their labels','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,-1);
INSERT INTO gpkg_contents VALUES('object_class','attributes','object_class','classes of objects','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('feature','attributes','feature','catalogue of features','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('class_feature','attributes','class_feature','Gaussian of a feature of a class','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('class_density','attributes','class_density','histogram of a feature of a class','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('setting','attributes','setting','switches of the knowledge','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('class_constraint','attributes','class_constraint','constraints between classes','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('truth','attributes','truth','classes of planes that a person knows','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('scan','attributes','scan','imported scans','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('plane_feature','attributes','plane_feature','values of all features of planes','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('scan_points','attributes','scan_points','plane numbers of the points of a scan','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('run','attributes','run','the last run over each scan','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('evidence','attributes','evidence','probabilities before constraints','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('relation_fact','attributes','relation_fact','relations that hold between planes','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('label','attributes','label','the labels','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('alternative','attributes','alternative','the next best world models','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
INSERT INTO gpkg_contents VALUES('reason','attributes','reason','why each label','2026-11-22T02:39:11.856Z',NULL,NULL,NULL,NULL,NULL);
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
INSERT INTO gpkg_geometry_columns VALUES('plane','geom','POLYGON',-1,1,0);
INSERT INTO gpkg_geometry_columns VALUES('labelled_plane_3d','geom','POLYGON',-1,1,0);
CREATE TABLE scenelore_meta (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  schema_version INTEGER NOT NULL,
  oldest_reader INTEGER NOT NULL,  -- oldest schema version whose programs can still read this file
  knowledge_pack TEXT NOT NULL     -- the pack the file was created with: office, paper, empty
) STRICT;
INSERT INTO scenelore_meta VALUES(1,1,1,'empty');
CREATE TABLE object_class (
  id INTEGER PRIMARY KEY CHECK (id BETWEEN 0 AND 1000000),  -- the number in labelled clouds
  name TEXT NOT NULL UNIQUE CHECK (length(name) > 0),       -- what all other rows refer to
  prior REAL NOT NULL DEFAULT 0.02 CHECK (prior > 0 AND prior < 1e300),  -- share of planes; normalised over all classes
  description TEXT NOT NULL DEFAULT '',
  color TEXT NOT NULL DEFAULT '#9e9e9e'
    CHECK (color GLOB '#[0-9a-fA-F][0-9a-fA-F][0-9a-fA-F][0-9a-fA-F][0-9a-fA-F][0-9a-fA-F]'),
  fallback INTEGER NOT NULL DEFAULT 0 CHECK (fallback IN (0, 1))  -- 1: takes what fits nothing; exactly one class
) STRICT;
INSERT INTO object_class VALUES(0,'unknown',0.29999999999999998889,'what fits nothing: books, boxes, plants, people','#9e9e9e',1);
INSERT INTO object_class VALUES(3,'wall',0.10000000000000000555,'','#9e9e9e',0);
INSERT INTO object_class VALUES(4,'table',0.050000000000000002775,'','#9e9e9e',0);
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
INSERT INTO feature VALUES(1,'area_m2','m2','log',0.0020000000000000000416,100.0,0.5,'area of the alpha hull');
INSERT INTO feature VALUES(2,'length','m','log',0.029999999999999998889,30.0,0.69999999999999995559,'longer side of the minimum-area rectangle');
INSERT INTO feature VALUES(3,'width','m','log',0.010000000000000000208,12.0,0.69999999999999995559,'shorter side of the minimum-area rectangle');
INSERT INTO feature VALUES(4,'rectangularity','1','linear',0.0,1.0,0.5,'share of that rectangle which the hull fills');
INSERT INTO feature VALUES(5,'tilt_deg','deg','linear',0.0,90.0,1.0,'angle between normal and vertical: 0 = horizontal plane, 90 = vertical');
INSERT INTO feature VALUES(6,'height','m','linear',-0.5,4.0,1.0,'centroid above the floor');
INSERT INTO feature VALUES(7,'z_min','m','linear',-0.5,4.0,0.5,'lower edge above the floor');
INSERT INTO feature VALUES(8,'z_max','m','linear',-0.5,4.0,0.5,'upper edge above the floor');
INSERT INTO feature VALUES(9,'x','m','linear',-20.0,20.0,0.0,'centroid along the upright frame''s x, from the middle of the scan');
INSERT INTO feature VALUES(10,'y','m','linear',-20.0,20.0,0.0,'centroid along the upright frame''s y, from the middle of the scan');
INSERT INTO feature VALUES(11,'rmse','m','log',0.00020000000000000000958,0.10000000000000000555,0.0,'root of the mean squared distance of its points');
INSERT INTO feature VALUES(12,'point_density','1/m2','log',1.0,1000000.0,0.0,'points a square metre: depends on the distance to the sensor');
INSERT INTO feature VALUES(13,'facing_up','1','linear',-1.0,1.0,0.0,'z of the normal on the sensor''s side; 1 = seen from above, -1 = from below');
INSERT INTO feature VALUES(14,'seen_share','1','linear',0.0,1.0,0.0,'share of the hull that holds points');
CREATE TABLE class_feature (
  id INTEGER PRIMARY KEY,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  feature TEXT NOT NULL REFERENCES feature(name) ON UPDATE CASCADE ON DELETE CASCADE,
  mean REAL NOT NULL,                     -- on the feature's scale: of ln x for log features, so ln(0.45) for 45 cm
  sigma REAL NOT NULL CHECK (sigma > 0),  -- standard deviation on that scale
  UNIQUE (class, feature)
) STRICT;
INSERT INTO class_feature VALUES(1,'table','height',0.72999999999999998223,0.040000000000000000832);
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
INSERT INTO setting VALUES(1,'combination','product','how features combine: product (weights as exponents) or mean (equation 1 of the paper)');
INSERT INTO setting VALUES(2,'floor','ranked','where the search starts: ranked (by cost) or threshold (the paper: a floor with at least floor_threshold)');
INSERT INTO setting VALUES(3,'floor_threshold','0.4','probability that the first floor needs; used with floor = threshold');
INSERT INTO setting VALUES(4,'outlier_share','0.002','share of values that do not follow their class''s density, 0 to 0.5: bounds what one odd value can do');
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
INSERT INTO scan VALUES(1,'lab','lab.ply','',10,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,'{}','2026-01-01T00:00:00Z');
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
INSERT INTO plane VALUES(1,X'47500005ffffffff0000000000000000000000000000f03f0000000000000000000000000000f03f0ad7a3703d0ae73f0ad7a3703d0ae73f01eb0300000100000005000000000000000000000000000000000000000ad7a3703d0ae73f000000000000f03f00000000000000000ad7a3703d0ae73f000000000000f03f000000000000f03f0ad7a3703d0ae73f0000000000000000000000000000f03f0ad7a3703d0ae73f000000000000000000000000000000000ad7a3703d0ae73f',1,0,0.5,0.5,0.71999999999999997335,0.71999999999999997335,0.0,0.0,1.0,1.0,0.0,0.0,0.0,1.0,1.0,1.0,1.0,0.0,0.010000000000000000208,5,0.0,1.0,1.0,5.0,1.0);
INSERT INTO plane VALUES(2,X'47500005ffffffff00000000000000000000000000000840000000000000004000000000000000400000000000000000000000000000044001eb0300000100000005000000000000000000000000000000000000400000000000000000000000000000084000000000000000400000000000000000000000000000084000000000000000400000000000000440000000000000000000000000000000400000000000000440000000000000000000000000000000400000000000000000',1,1,0.5,0.5,1.25,1.25,0.0,-1.0,0.0,1.0,0.0,0.0,0.0,1.0,1.0,1.0,1.0,90.0,0.010000000000000000208,5,0.0,1.0,1.0,5.0,1.0);
CREATE TABLE plane_feature (
  id INTEGER PRIMARY KEY,
  plane_id INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,
  feature TEXT NOT NULL REFERENCES feature(name) ON UPDATE CASCADE ON DELETE CASCADE,
  value REAL NOT NULL,
  UNIQUE (plane_id, feature)
) STRICT;
CREATE TABLE scan_points (
  scan_id INTEGER PRIMARY KEY REFERENCES scan(id) ON DELETE CASCADE,
  encoding TEXT NOT NULL CHECK (encoding = 'runs1'),
  -- runs1: for each run of equal numbers two LEB128 varints: plane number + 1 (0 = no plane), then the run's length.
  plane_numbers BLOB NOT NULL
) STRICT;
INSERT INTO scan_points VALUES(1,'runs1',X'01050205');
CREATE TABLE truth (
  plane_id INTEGER PRIMARY KEY REFERENCES plane(id) ON DELETE CASCADE,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE
) STRICT;
INSERT INTO truth VALUES(1,'table');
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
CREATE TABLE relation_fact (
  id INTEGER PRIMARY KEY,
  scan_id INTEGER NOT NULL REFERENCES scan(id) ON DELETE CASCADE,
  relation TEXT NOT NULL,
  a INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,  -- the relation holds from plane a to plane b
  b INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,
  degree REAL NOT NULL CHECK (degree > 0 AND degree <= 1),
  UNIQUE (a, relation, b)
) STRICT;
CREATE TABLE label (
  plane_id INTEGER PRIMARY KEY REFERENCES plane(id) ON DELETE CASCADE,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  probability REAL NOT NULL CHECK (probability BETWEEN 0 AND 1),  -- marginal over the consistent world models
  run_id INTEGER NOT NULL REFERENCES run(id) ON DELETE CASCADE,
  margin REAL NOT NULL CHECK (margin >= 0),  -- nats: extra cost of the best world where this plane is something else; Inf = none
  runner_up TEXT REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE SET NULL  -- its class in that world
) STRICT;
CREATE TABLE alternative (
  id INTEGER PRIMARY KEY,
  run_id INTEGER NOT NULL REFERENCES run(id) ON DELETE CASCADE,
  rank INTEGER NOT NULL CHECK (rank >= 2),  -- 2 = second best world
  plane_id INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  UNIQUE (run_id, rank, plane_id)
) STRICT;
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
DELETE FROM sqlite_sequence;
INSERT INTO sqlite_sequence VALUES('scan',1);
INSERT INTO sqlite_sequence VALUES('plane',2);
CREATE UNIQUE INDEX object_class_one_fallback ON object_class(fallback) WHERE fallback = 1;
CREATE INDEX class_constraint_class ON class_constraint(class);
CREATE INDEX class_constraint_other_class ON class_constraint(other_class);
CREATE INDEX plane_feature_feature ON plane_feature(feature);
CREATE INDEX truth_class ON truth(class);
CREATE INDEX evidence_class ON evidence(class);
CREATE INDEX relation_fact_b ON relation_fact(b);
CREATE INDEX relation_fact_scan ON relation_fact(scan_id, relation);
CREATE INDEX label_class ON label(class);
CREATE INDEX label_runner_up ON label(runner_up);
CREATE INDEX label_run ON label(run_id);
CREATE TRIGGER label_corrected AFTER UPDATE OF class ON label
WHEN NEW.class <> OLD.class AND EXISTS (SELECT 1 FROM object_class WHERE name = OLD.class)
BEGIN
  INSERT INTO truth (plane_id, class) VALUES (NEW.plane_id, NEW.class)
    ON CONFLICT (plane_id) DO UPDATE SET class = excluded.class;
END;
CREATE INDEX alternative_plane ON alternative(plane_id);
CREATE INDEX alternative_class ON alternative(class);
CREATE INDEX reason_run ON reason(run_id);
CREATE INDEX reason_plane ON reason(plane_id);
CREATE INDEX reason_class ON reason(class);
CREATE INDEX reason_other_plane ON reason(other_plane_id);
CREATE VIEW labelled_plane AS
SELECT s.name AS scan, p.id AS plane, l.class AS class, l.probability AS probability, e.probability AS evidence,
       l.margin AS margin, l.runner_up AS runner_up, p.height AS height, p.area_m2 AS area_m2, p.length AS length,
       p.width AS width, p.tilt_deg AS tilt_deg
FROM label l
JOIN plane p ON p.id = l.plane_id
JOIN scan s ON s.id = p.scan_id
LEFT JOIN evidence e ON e.plane_id = p.id AND e.class = l.class;
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
CREATE VIEW needs_review AS
SELECT s.name AS scan, p.id AS plane, l.class AS class, l.probability AS probability, l.margin AS margin,
       l.runner_up AS runner_up, p.height AS height, p.area_m2 AS area_m2
FROM label l
JOIN plane p ON p.id = l.plane_id
JOIN scan s ON s.id = p.scan_id
WHERE p.id NOT IN (SELECT plane_id FROM truth)
ORDER BY l.margin, p.id;
CREATE VIEW labelled_plane_3d AS
SELECT p.id AS id, p.geom AS geom, s.name AS scan, l.class AS class, c.color AS color, l.probability AS probability,
       l.margin AS margin, l.runner_up AS runner_up, p.height AS height, p.area_m2 AS area_m2, p.length AS length,
       p.width AS width, p.tilt_deg AS tilt_deg
FROM label l
JOIN plane p ON p.id = l.plane_id
JOIN scan s ON s.id = p.scan_id
JOIN object_class c ON c.name = l.class;
COMMIT;
PRAGMA application_id = 0x47504B47;
PRAGMA user_version = 10300;
