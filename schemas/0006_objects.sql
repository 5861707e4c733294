-- Schema version 6: things of several surfaces. A composite says of which classes its parts are and how they hang together;
-- objects are the things found, with their planes.
CREATE TABLE composite (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE CHECK (length(name) > 0),
  description TEXT NOT NULL DEFAULT '',
  enabled INTEGER NOT NULL DEFAULT 1 CHECK (enabled IN (0, 1))
) STRICT;

-- One part is the anchor: the part that every such thing shows, one of it (relation NULL). The others stand in a relation to it.
-- A weight makes the part a need of the world model, as if rows of class_constraint said: a plane of this class has an anchor, and
-- (fewest > 0) an anchor has so many of them; without one the part only groups what is labelled already.
CREATE TABLE composite_part (
  id INTEGER PRIMARY KEY,
  composite TEXT NOT NULL REFERENCES composite(name) ON UPDATE CASCADE ON DELETE CASCADE,
  part TEXT NOT NULL CHECK (length(part) > 0),
  class TEXT NOT NULL REFERENCES object_class(name) ON UPDATE CASCADE ON DELETE CASCADE,
  relation TEXT,      -- from the part to the anchor, and from the anchor to the part where it needs one: a symmetric one is best
  orientation TEXT CHECK (orientation IN ('level', 'upright')),  -- of the plane; NULL = either
  fewest INTEGER NOT NULL DEFAULT 0 CHECK (fewest >= 0),  -- of this part, in one thing
  most INTEGER NOT NULL DEFAULT 1 CHECK (most >= 1),
  weight REAL CHECK (weight > 0),  -- nats paid where the need is not met; NULL = no need
  UNIQUE (composite, part),
  CHECK (fewest <= most)
) STRICT;
CREATE UNIQUE INDEX composite_one_anchor ON composite_part(composite) WHERE relation IS NULL;
CREATE INDEX composite_part_class ON composite_part(class);

CREATE TABLE object (
  id INTEGER PRIMARY KEY,
  run_id INTEGER NOT NULL REFERENCES run(id) ON DELETE CASCADE,
  composite TEXT NOT NULL,
  number INTEGER NOT NULL CHECK (number >= 1),  -- chair 1, chair 2, … of this scan
  UNIQUE (run_id, composite, number)
) STRICT;

CREATE TABLE object_plane (
  plane_id INTEGER NOT NULL REFERENCES plane(id) ON DELETE CASCADE,
  object_id INTEGER NOT NULL REFERENCES object(id) ON DELETE CASCADE,
  part TEXT NOT NULL,
  PRIMARY KEY (plane_id, object_id)
) STRICT, WITHOUT ROWID;
CREATE INDEX object_plane_object ON object_plane(object_id);

CREATE VIEW labelled_object AS
SELECT s.name AS scan, o.id AS object, o.composite AS composite, o.number AS number, p.plane_id AS plane, p.part AS part
FROM object o
JOIN run r ON r.id = o.run_id
JOIN scan s ON s.id = r.scan_id
JOIN object_plane p ON p.object_id = o.id;

INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('composite', 'attributes', 'composite', 'things of several surfaces', NULL),
  ('composite_part', 'attributes', 'composite_part', 'their parts', NULL),
  ('object', 'attributes', 'object', 'things found', NULL);

UPDATE scenelore_meta SET schema_version = 6, oldest_reader = 1;
