-- Schema version 7: what Lua features and Lua constraints answered, so that the next run asks only those that changed; and which
-- features of the catalogue a relation looked at, so that an edited feature has only those relations asked again.
ALTER TABLE relation_asked ADD COLUMN features TEXT NOT NULL DEFAULT '';  -- names, one a line

CREATE TABLE rule_answer (
  id INTEGER PRIMARY KEY,
  scan_id INTEGER NOT NULL REFERENCES scan(id) ON DELETE CASCADE,
  rule TEXT NOT NULL,           -- "feature NAME" or "constraint NAME"
  features TEXT NOT NULL,       -- of the catalogue that it looked at: names, one a line
  inputs_sha256 TEXT NOT NULL,  -- of the rule, the program's geometry, the scan's planes and those features
  answers BLOB NOT NULL,        -- feature: a double a plane (NaN = not known); constraint: ids of the planes of a tuple, then its degree
  UNIQUE (scan_id, rule)
) STRICT;

INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('rule_answer', 'attributes', 'rule_answer', 'what Lua features and constraints answered, kept for the next run', NULL);

UPDATE scenelore_meta SET schema_version = 7, oldest_reader = 1;
