-- Schema version 5: what learning replaced, so that it can be undone.
CREATE TABLE knowledge_undo (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  made_at TEXT NOT NULL,  -- ISO 8601, UTC
  what TEXT NOT NULL,     -- the change that would be undone, in words
  sql TEXT NOT NULL       -- statements over the knowledge tables that bring back what was there; the newest row goes first
) STRICT;

INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('knowledge_undo', 'attributes', 'knowledge_undo', 'how to undo what was learned', NULL);

UPDATE scenelore_meta SET schema_version = 5, oldest_reader = 1;
