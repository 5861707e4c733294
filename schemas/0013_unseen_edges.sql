-- Schema version 13: how much of a plane's outline is where the view ends, measured when a scan is segmented; NULL where it is not
-- known, and for planes of older files.
ALTER TABLE plane ADD COLUMN edge_unseen DOUBLE CHECK (edge_unseen BETWEEN 0 AND 1);

UPDATE scenelore_meta SET schema_version = 13, oldest_reader = 1;
