-- Schema version 3: what the facts of each relation were found from, so that the next run asks only the relations whose
-- rule, tolerances or planes have changed; and layers of a GIS in which a label can be corrected.
CREATE TABLE relation_asked (
  id INTEGER PRIMARY KEY,
  scan_id INTEGER NOT NULL REFERENCES scan(id) ON DELETE CASCADE,
  relation TEXT NOT NULL,
  asked INTEGER NOT NULL CHECK (asked >= 0),  -- ordered pairs of planes that were within reach
  held INTEGER NOT NULL CHECK (held >= 0),    -- of these, pairs that stand in the relation: rows of relation_fact
  within REAL,        -- metres between the boxes of two planes up to which the relation is asked; NULL = no limit
  within_plan REAL,   -- the same seen from above
  inputs_sha256 TEXT NOT NULL,                -- of the rule, its tolerances, the program's geometry and the scan's planes
  facts_sha256 TEXT NOT NULL,                 -- of the rows of relation_fact; rows that a person changed are found anew
  UNIQUE (scan_id, relation)
) STRICT;

-- An edit in a GIS reaches the view of a layer; as in labelled_plane it becomes truth by way of the label.
CREATE TRIGGER labelled_plane_3d_corrected INSTEAD OF UPDATE OF class ON labelled_plane_3d
BEGIN
  UPDATE label SET class = NEW.class WHERE plane_id = OLD.id;
END;
CREATE TRIGGER labelled_plane_plan_corrected INSTEAD OF UPDATE OF class ON labelled_plane_plan
BEGIN
  UPDATE label SET class = NEW.class WHERE plane_id = OLD.id;
END;

INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('relation_asked', 'attributes', 'relation_asked', 'what the facts of each relation were found from', NULL);

UPDATE scenelore_meta SET schema_version = 3, oldest_reader = 1;
