-- Schema version 9: the facts of a relation once more in one piece, which the next run reads instead of thousands of rows; a row
-- that somebody changes makes the piece void, and the relation is asked anew.
ALTER TABLE relation_asked DROP COLUMN facts_sha256;
ALTER TABLE relation_asked ADD COLUMN facts BLOB;  -- of each row by a and b: a, b as 8-byte integers, degree as a double; NULL = void

CREATE TRIGGER relation_fact_inserted AFTER INSERT ON relation_fact
BEGIN
  UPDATE relation_asked SET facts = NULL WHERE scan_id = NEW.scan_id AND relation = NEW.relation;
END;
CREATE TRIGGER relation_fact_updated AFTER UPDATE ON relation_fact
BEGIN
  UPDATE relation_asked SET facts = NULL WHERE scan_id IN (OLD.scan_id, NEW.scan_id) AND relation IN (OLD.relation, NEW.relation);
END;
CREATE TRIGGER relation_fact_deleted AFTER DELETE ON relation_fact
BEGIN
  UPDATE relation_asked SET facts = NULL WHERE scan_id = OLD.scan_id AND relation = OLD.relation;
END;

UPDATE scenelore_meta SET schema_version = 9, oldest_reader = 1;
