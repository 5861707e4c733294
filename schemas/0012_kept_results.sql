-- Schema version 12: what evidence and feature values were made from, the evidence once more in one piece, and hashes of the reasons: the
-- next run makes, reads and compares only what has changed. A row that somebody changes makes the piece void.
CREATE TABLE kept_result (
  id INTEGER PRIMARY KEY,
  scan_id INTEGER NOT NULL REFERENCES scan(id) ON DELETE CASCADE,
  what TEXT NOT NULL,           -- 'evidence', 'features' or 'reasons'
  inputs_sha256 TEXT NOT NULL,  -- of all that it depends on; reasons: the run's id
  content BLOB NOT NULL,        -- evidence: a double for each plane and class, by plane; features: empty; reasons: id and hash of each row
  UNIQUE (scan_id, what)
) STRICT;

CREATE TRIGGER evidence_inserted AFTER INSERT ON evidence BEGIN DELETE FROM kept_result WHERE what = 'evidence'; END;
CREATE TRIGGER evidence_updated AFTER UPDATE ON evidence BEGIN DELETE FROM kept_result WHERE what = 'evidence'; END;
CREATE TRIGGER evidence_deleted AFTER DELETE ON evidence BEGIN DELETE FROM kept_result WHERE what = 'evidence'; END;
CREATE TRIGGER plane_feature_inserted AFTER INSERT ON plane_feature BEGIN DELETE FROM kept_result WHERE what = 'features'; END;
CREATE TRIGGER plane_feature_updated AFTER UPDATE ON plane_feature BEGIN DELETE FROM kept_result WHERE what = 'features'; END;
CREATE TRIGGER plane_feature_deleted AFTER DELETE ON plane_feature BEGIN DELETE FROM kept_result WHERE what = 'features'; END;
CREATE TRIGGER reason_inserted AFTER INSERT ON reason BEGIN DELETE FROM kept_result WHERE what = 'reasons'; END;
CREATE TRIGGER reason_updated AFTER UPDATE ON reason BEGIN DELETE FROM kept_result WHERE what = 'reasons'; END;
CREATE TRIGGER reason_deleted AFTER DELETE ON reason BEGIN DELETE FROM kept_result WHERE what = 'reasons'; END;

INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('kept_result', 'attributes', 'kept_result', 'what evidence, features and reasons were, kept for the next run', NULL);

UPDATE scenelore_meta SET schema_version = 12, oldest_reader = 1;
