-- Schema version 11: kinds. Many classes look like several things: a wall seen whole, a strip of wall between shelves; what is unknown
-- is books, lamps, people. A kind is a Gaussian of each feature, all of one kind together: p(features | class) = sum of share * p(features |
-- kind), and what shares leave over of 1 belongs to the class's own rows (class_feature, class_density), which also judge the
-- features that a kind has no row for. A class without kinds is judged by its own rows alone.
CREATE TABLE class_kind (
  id INTEGER PRIMARY KEY,
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  kind INTEGER NOT NULL CHECK (kind >= 1),  -- 1, 2, ... within the class
  share REAL NOT NULL CHECK (share > 0 AND share <= 1),  -- of the class's planes
  description TEXT NOT NULL DEFAULT '',
  UNIQUE (class, kind)
) STRICT;

CREATE TABLE kind_feature (
  id INTEGER PRIMARY KEY,
  class TEXT NOT NULL,
  kind INTEGER NOT NULL,
  feature TEXT NOT NULL REFERENCES feature(name) ON UPDATE CASCADE ON DELETE CASCADE,
  mean REAL NOT NULL,                     -- on the feature's scale, as in class_feature
  sigma REAL NOT NULL CHECK (sigma > 0),  -- standard deviation on that scale
  UNIQUE (class, kind, feature),
  FOREIGN KEY (class, kind) REFERENCES class_kind(class, kind) ON UPDATE CASCADE ON DELETE CASCADE
) STRICT;
CREATE INDEX kind_feature_feature ON kind_feature(feature);

-- Also for programs that leave foreign keys switched off, as the sqlite3 shell does.
CREATE TRIGGER class_kind_deleted AFTER DELETE ON class_kind
BEGIN
  DELETE FROM kind_feature WHERE class = OLD.class AND kind = OLD.kind;
END;

INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('class_kind', 'attributes', 'class_kind', 'kinds that classes consist of', NULL),
  ('kind_feature', 'attributes', 'kind_feature', 'Gaussian of a feature of a kind', NULL);

UPDATE scenelore_meta SET schema_version = 11, oldest_reader = 1;
