-- Schema version 2: the floor plan as a layer of its own, since a GIS draws vertical polygons as nothing at all and its
-- validity checks refuse them. Footprints are computed when a plane is stored (kb/src/footprint.cpp), because a view of a
-- GeoPackage may call no function of ours; for planes of older files the migration computes them.
CREATE TABLE plane_plan (
  plane_id INTEGER PRIMARY KEY NOT NULL REFERENCES plane(id) ON DELETE CASCADE,
  geom POLYGON  -- POLYGON in the upright frame's x and y, turned about the scan's origin; steep planes as thin strips
);

-- Sides of the rectangle that spreads as the plane's points do when evenly filled; NULL for planes of older files.
ALTER TABLE plane ADD COLUMN spread_length DOUBLE;
ALTER TABLE plane ADD COLUMN spread_width DOUBLE;

CREATE VIEW labelled_plane_plan AS
SELECT p.id AS id, f.geom AS geom, s.name AS scan, l.class AS class, c.color AS color, l.probability AS probability,
       l.margin AS margin, p.height AS height, p.area_m2 AS area_m2, p.tilt_deg AS tilt_deg
FROM label l
JOIN plane p ON p.id = l.plane_id
JOIN plane_plan f ON f.plane_id = p.id
JOIN scan s ON s.id = p.scan_id
JOIN object_class c ON c.name = l.class;

INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('plane_plan', 'features', 'plane_plan', 'footprints of planes', -1),
  ('labelled_plane_plan', 'features', 'labelled_plane_plan', 'floor plan of labelled planes', -1);
INSERT INTO gpkg_geometry_columns VALUES
  ('plane_plan', 'geom', 'POLYGON', -1, 0, 0),
  ('labelled_plane_plan', 'geom', 'POLYGON', -1, 0, 0);

UPDATE scenelore_meta SET schema_version = 2, oldest_reader = 1;
