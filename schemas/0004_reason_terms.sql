-- Schema version 4: what each feature says as numbers beside the sentence; and the geometry between the planes of a scan, so
-- that an edited rule need not have it computed again.
ALTER TABLE reason ADD COLUMN feature TEXT;  -- of kind feature: one row for each feature that is known of the plane
ALTER TABLE reason ADD COLUMN value REAL;    -- of the feature at the plane
ALTER TABLE reason ADD COLUMN mean REAL;     -- mu and sigma of the class on the feature's scale; NULL where the class has no
ALTER TABLE reason ADD COLUMN sigma REAL;    -- row in class_feature
ALTER TABLE reason ADD COLUMN against TEXT;  -- the class that a feature, evidence or runner_up row compares with

CREATE TABLE pair_geometry (
  scan_id INTEGER PRIMARY KEY REFERENCES scan(id) ON DELETE CASCADE,
  inputs_sha256 TEXT NOT NULL,  -- of the scan's planes and the program's geometry
  answers BLOB NOT NULL         -- sorted entries: planes a and b by position (32 bits each), reach or -1 for the gap, value (doubles)
) STRICT;

INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('pair_geometry', 'attributes', 'pair_geometry', 'distances and overlaps between planes, kept for the next run', NULL);

UPDATE scenelore_meta SET schema_version = 4, oldest_reader = 1;
