-- Schema version 10: what the sensor saw beyond a plane's outline, measured when a scan is segmented; NULL where its position is
-- not known, and for planes of older files.
ALTER TABLE plane ADD COLUMN edge_free DOUBLE CHECK (edge_free BETWEEN 0 AND 1);
ALTER TABLE plane ADD COLUMN edge_free_top DOUBLE CHECK (edge_free_top BETWEEN 0 AND 1);
ALTER TABLE plane ADD COLUMN edge_joined DOUBLE CHECK (edge_joined BETWEEN 0 AND 1);

UPDATE scenelore_meta SET schema_version = 10, oldest_reader = 1;
