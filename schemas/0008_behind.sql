-- Schema version 8: whether the room ends at a plane or goes on behind it, measured when a scan is segmented; NULL for planes of
-- older files.
ALTER TABLE plane ADD COLUMN behind DOUBLE CHECK (behind BETWEEN 0 AND 1);

UPDATE scenelore_meta SET schema_version = 8, oldest_reader = 1;
