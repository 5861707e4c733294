-- Knowledge pack "office". One row a line; a row may be changed, added or deleted without touching anything else.
-- Sizes are of what a scan shows: partial views make things smaller, never larger, hence means a little below the norm.

-- Feature weights: features say the same thing several times over, so their weights must sum to less than their number. These are
-- where learning starts; office_learned.sql replaces them, as it does the priors and the weights of the constraint rows below.
INSERT INTO feature (name, unit, scale, low, high, weight, description) VALUES
  ('aspect', '1', 'log', 1, 100, 0.39, 'length over width of the smallest rectangle (rules/features/aspect.lua)');
UPDATE feature SET weight = 0 WHERE name IN ('area_m2', 'length', 'edge_joined');  -- others say all that they do
UPDATE feature SET weight = 0.56 WHERE name = 'height';
UPDATE feature SET weight = 0.62 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.36 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.31 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.64 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.26 WHERE name = 'width';
UPDATE feature SET weight = 0.66 WHERE name = 'z_max';
UPDATE feature SET weight = 0.25 WHERE name = 'z_min';

-- Priors: shares of the planes that segmentation finds in furnished offices, estimated by hand.
INSERT INTO object_class (id, name, prior, color, description) VALUES
  ( 1, 'floor',       0.02, '#8d6e63', 'what one walks on'),
  ( 2, 'ceiling',     0.02, '#cfd8dc', 'the lower side of what is above the room'),
  ( 3, 'wall',        0.09, '#ffe0b2', 'walls, faces of columns'),
  ( 4, 'table',       0.05, '#ff9800', 'tops of tables and desks'),
  ( 5, 'flat_screen', 0.05, '#1565c0', 'fronts and backs of monitors'),
  ( 6, 'keyboard',    0.04, '#c2185b', 'keyboards on tables'),
  ( 7, 'chair_seat',  0.05, '#7cb342', 'what one sits on'),
  ( 8, 'chair_back',  0.05, '#33691e', 'what one leans against'),
  ( 9, 'door',        0.02, '#6d4c41', 'door leaves, open or closed'),
  (10, 'window',      0.03, '#4fc3f7', 'panes, frames and blinds'),
  (11, 'whiteboard',  0.01, '#ab47bc', 'boards to write on, hung on a wall'),
  (12, 'shelf',       0.10, '#fdd835', 'boards and sides of open shelves'),
  (13, 'cabinet',     0.07, '#00897b', 'fronts, sides and tops of closed furniture');

-- Gaussians. The mean is on the feature's scale: ln(metres) for sizes, so that sigma 0.1 is about 10 %.
INSERT INTO class_feature (class, feature, mean, sigma) VALUES
-- floor: rooms of 10 to 60 m2, furniture hides a good part; the floor level is estimated to about 2 cm.
  ('floor', 'area_m2',        ln(12.0),  0.80),
  ('floor', 'length',         ln(5.0),   0.50),
  ('floor', 'width',          ln(3.5),   0.50),
  ('floor', 'rectangularity', 0.75,      0.20),
  ('floor', 'tilt_deg',       0.5,       1.5),
  ('floor', 'height',         0.0,       0.06),
  ('floor', 'z_min',         -0.03,      0.06),
  ('floor', 'z_max',          0.03,      0.06),
-- ceiling: as the floor, less hidden; clear heights of offices 2.50 to 3.00 m (ASR A1.2: at least 2.50 m up to 50 m2).
  ('ceiling', 'area_m2',        ln(14.0),  0.80),
  ('ceiling', 'length',         ln(5.2),   0.50),
  ('ceiling', 'width',          ln(3.7),   0.50),
  ('ceiling', 'rectangularity', 0.80,      0.20),
  ('ceiling', 'tilt_deg',       0.5,       1.5),
  ('ceiling', 'height',         2.70,      0.25),
  ('ceiling', 'z_min',          2.66,      0.25),
  ('ceiling', 'z_max',          2.74,      0.25),
-- wall: from the floor to the ceiling where nothing stands before it; pieces between doors and windows are smaller.
  ('wall', 'area_m2',        ln(5.0),   0.90),
  ('wall', 'length',         ln(3.5),   0.60),
  ('wall', 'width',          ln(2.0),   0.60),
  ('wall', 'rectangularity', 0.75,      0.20),
  ('wall', 'tilt_deg',       89.5,      1.5),
  ('wall', 'height',         1.40,      0.30),
  ('wall', 'z_min',          0.20,      0.40),
  ('wall', 'z_max',          2.55,      0.35),
-- table: desk height 0.72 +- 0.03 m (DIN EN 527-1: 0.74 m fixed, 0.65 to 0.85 m adjustable), tops 1.2-1.8 x 0.8 m.
  ('table', 'area_m2',        ln(0.95),  0.45),
  ('table', 'length',         ln(1.45),  0.30),
  ('table', 'width',          ln(0.74),  0.25),
  ('table', 'rectangularity', 0.82,      0.15),
  ('table', 'tilt_deg',       0.8,       1.8),
  ('table', 'height',         0.73,      0.04),
  ('table', 'z_min',          0.70,      0.05),
  ('table', 'z_max',          0.76,      0.05),
-- flat_screen: 19 to 27 inch, so 0.41-0.60 x 0.26-0.34 m; tilted back by up to 20 degrees; foot of 0.10 to 0.15 m on a desk.
  ('flat_screen', 'area_m2',        ln(0.14),  0.35),
  ('flat_screen', 'length',         ln(0.49),  0.18),
  ('flat_screen', 'width',          ln(0.30),  0.20),
  ('flat_screen', 'rectangularity', 0.90,      0.10),
  ('flat_screen', 'tilt_deg',       84.0,      6.0),
  ('flat_screen', 'height',         1.02,      0.10),
  ('flat_screen', 'z_min',          0.86,      0.08),
  ('flat_screen', 'z_max',          1.16,      0.10),
-- keyboard: 0.45 x 0.15 m, 2 to 3 cm above a desk, its back raised by up to 6 degrees (ISO 9241-410).
  ('keyboard', 'area_m2',        ln(0.058), 0.35),
  ('keyboard', 'length',         ln(0.43),  0.15),
  ('keyboard', 'width',          ln(0.145), 0.22),
  ('keyboard', 'rectangularity', 0.85,      0.12),
  ('keyboard', 'tilt_deg',       3.0,       3.0),
  ('keyboard', 'height',         0.76,      0.04),
  ('keyboard', 'z_min',          0.74,      0.05),
  ('keyboard', 'z_max',          0.78,      0.05),
-- chair_seat: seats 0.42-0.50 m high (DIN EN 1335-1: 0.40 to 0.51 m), 0.40 to 0.50 m in both directions.
  ('chair_seat', 'area_m2',        ln(0.17),  0.40),
  ('chair_seat', 'length',         ln(0.47),  0.20),
  ('chair_seat', 'width',          ln(0.41),  0.22),
  ('chair_seat', 'rectangularity', 0.80,      0.15),
  ('chair_seat', 'tilt_deg',       3.0,       4.0),
  ('chair_seat', 'height',         0.47,      0.05),
  ('chair_seat', 'z_min',          0.44,      0.06),
  ('chair_seat', 'z_max',          0.50,      0.06),
-- chair_back: 0.35-0.50 m wide, 0.30-0.65 m high, above a seat, leaning back by 5 to 20 degrees.
  ('chair_back', 'area_m2',        ln(0.17),  0.45),
  ('chair_back', 'length',         ln(0.50),  0.25),
  ('chair_back', 'width',          ln(0.40),  0.22),
  ('chair_back', 'rectangularity', 0.80,      0.15),
  ('chair_back', 'tilt_deg',       79.0,      6.0),
  ('chair_back', 'height',         0.80,      0.12),
  ('chair_back', 'z_min',          0.57,      0.10),
  ('chair_back', 'z_max',          1.02,      0.16),
-- door: 2.0 x 0.9 m (DIN 18101: leaves 1.985 m high, 0.86 and 0.985 m wide).
  ('door', 'area_m2',        ln(1.65),  0.25),
  ('door', 'length',         ln(1.98),  0.12),
  ('door', 'width',          ln(0.87),  0.12),
  ('door', 'rectangularity', 0.92,      0.10),
  ('door', 'tilt_deg',       89.5,      1.5),
  ('door', 'height',         1.02,      0.10),
  ('door', 'z_min',          0.03,      0.10),
  ('door', 'z_max',          2.02,      0.10),
-- window: sills 0.8-1.0 m above the floor, heads at 1.9-2.4 m, 0.9-1.7 m wide; glass returns little, so parts are missing.
  ('window', 'area_m2',        ln(1.0),   0.70),
  ('window', 'length',         ln(1.35),  0.30),
  ('window', 'width',          ln(1.0),   0.40),
  ('window', 'rectangularity', 0.75,      0.25),
  ('window', 'tilt_deg',       89.0,      2.0),
  ('window', 'height',         1.55,      0.22),
  ('window', 'z_min',          0.95,      0.25),
  ('window', 'z_max',          2.15,      0.25),
-- whiteboard: 0.9-2.4 x 0.9-1.2 m, lower edge 0.85-1.05 m above the floor.
  ('whiteboard', 'area_m2',        ln(1.6),   0.40),
  ('whiteboard', 'length',         ln(1.6),   0.30),
  ('whiteboard', 'width',          ln(1.02),  0.15),
  ('whiteboard', 'rectangularity', 0.93,      0.08),
  ('whiteboard', 'tilt_deg',       89.5,      1.5),
  ('whiteboard', 'height',         1.48,      0.12),
  ('whiteboard', 'z_min',          0.95,      0.12),
  ('whiteboard', 'z_max',          2.00,      0.15),
-- shelf: boards and sides 0.25-0.40 m deep, 0.6-1.2 m wide, up to 2.2 m high; height says little.
  ('shelf', 'area_m2',        ln(0.22),  0.60),
  ('shelf', 'length',         ln(0.90),  0.35),
  ('shelf', 'width',          ln(0.28),  0.35),
  ('shelf', 'rectangularity', 0.75,      0.20),
  ('shelf', 'height',         1.05,      0.55),
  ('shelf', 'z_min',          0.80,      0.70),
  ('shelf', 'z_max',          1.30,      0.60),
-- cabinet: 0.6-1.2 m wide, 0.36-0.60 m deep, 0.7-2.15 m high.
  ('cabinet', 'area_m2',        ln(0.70),  0.60),
  ('cabinet', 'length',         ln(1.15),  0.40),
  ('cabinet', 'width',          ln(0.58),  0.35),
  ('cabinet', 'rectangularity', 0.88,      0.12),
  ('cabinet', 'height',         0.80,      0.35),
  ('cabinet', 'z_min',          0.35,      0.50),
  ('cabinet', 'z_max',          1.40,      0.50);

-- Faces of furniture are either level or upright, which no Gaussian says: two bins each, densities per degree.
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf',   'tilt_deg',  0,  4, 0.15),
  ('shelf',   'tilt_deg', 86, 90, 0.10),
  ('cabinet', 'tilt_deg',  0,  4, 0.05),
  ('cabinet', 'tilt_deg', 86, 90, 0.20);

-- Constraints. For each plane of `class`: some / every / no plane of other_class stands in the relation (other_class NULL:
-- any class but unknown). Weights are nats: what a violation costs; 0.7 halves the odds, 2.3 divides them by ten, NULL forbids.
INSERT INTO class_constraint (name, class, quantifier, relation, other_class, count, weight, message) VALUES
-- the room
  ('some_floor',            'floor',       'at_least', NULL,       NULL,        1,    3.0, 'a room has a floor'),
  ('one_ceiling_level',     'ceiling',     'every',    'equal_height', 'ceiling', NULL, 1.5, 'all parts of a ceiling are at one height'),
  ('one_floor_level',       'floor',       'every',    'equal_height', 'floor',   NULL, 2.5, 'all parts of a floor are at one height'),
  ('floor_lowest',          'floor',       'no',       'above',    NULL,        NULL, 4.0, 'nothing but the floor is lowest: a floor lies above nothing'),
  ('ceiling_highest',       'ceiling',     'no',       'under',    NULL,        NULL, 4.0, 'a ceiling lies under nothing'),
  ('ceiling_over_floor',    'ceiling',     'every',    'parallel', 'floor',     NULL, 2.5, 'a ceiling is parallel to the floor'),
  ('wall_upright',          'wall',        'every',    'orthogonal', 'floor',   NULL, 3.0, 'a wall is orthogonal to the floor'),
  ('wall_meets_ceiling',    'wall',        'every',    'orthogonal', 'ceiling', NULL, 1.5, 'a wall is orthogonal to the ceiling'),
  ('wall_beside_wall',      'wall',        'some',     'near',       'wall',    NULL, 0.3, 'a wall goes on into the next one'),
  ('wall_at_corner',        'wall',        'some',     'meets_at_corner', 'wall', NULL, 0.5, 'a wall meets another at a corner of the room'),
  ('wall_in_one_plane',     'wall',        'some',     'coplanar',   'wall',      NULL, 0.3, 'a wall goes on in its own plane'),
  ('cabinet_off_wall',      'cabinet',     'no',       'coplanar',   'wall',      NULL, 0.3, 'a cabinet stands out from the walls'),
  ('window_off_wall',       'window',      'no',       'coplanar',   'wall',      NULL, 0.3, 'a window lies behind the face of its wall'),
-- tables and what stands on them
  ('table_level',           'table',       'every',    'parallel',   'floor',       NULL, 3.0, 'a table top is parallel to the floor'),
  ('table_over_floor',      'table',       'no',       'under',      'floor',       NULL, 4.0, 'a table is not under a floor'),
  ('table_clear_above',     'table',       'no',       'under',      'table',       NULL, 1.5, 'no table stands over a table'),
  ('screen_over_table',     'flat_screen', 'some',     'above',      'table',       NULL, 2.5, 'a flat screen stands over some table'),
  ('screen_upright',        'flat_screen', 'every',    'orthogonal', 'table',       NULL, 0.5, 'a flat screen is about orthogonal to tables'),
  ('screen_within_table',   'flat_screen', 'some',     'inside_footprint', 'table', NULL, 0.5, 'a flat screen does not reach beyond its table'),
  ('keyboard_on_table',     'keyboard',    'some',     'inside_footprint', 'table', NULL, 3.0, 'a keyboard lies on some table'),
  ('keyboard_level',        'keyboard',    'some',     'parallel',   'table',       NULL, 1.0, 'a keyboard is about parallel to some table'),
  ('keyboard_before_screen', 'keyboard',   'some',     'in_front_of', 'flat_screen', NULL, 3.0, 'a keyboard lies before a flat screen'),
  ('keyboard_not_beneath',  'keyboard',    'no',       'beneath',    'flat_screen', NULL, 5.0, 'what lies beneath a flat screen is its foot'),
  ('keyboards_apart',       'keyboard',    'no',       'near',       'keyboard',    NULL, 1.0, 'keyboards do not lie side by side'),
  ('screen_off_wall',       'flat_screen', 'no',       'touching',   'wall',        NULL, 1.0, 'a flat screen stands free of the walls'),
-- chairs
  ('seat_level',            'chair_seat',  'every',    'parallel', 'floor',     NULL, 0.7, 'a seat is about parallel to the floor'),
  ('seat_not_on_table',     'chair_seat',  'no',       'above',    'table',     NULL, 3.0, 'no seat is on a table'),
  ('back_near_seat',        'chair_back',  'some',     'near',     'chair_seat', NULL, 1.5, 'the back of a chair is near its seat'),
  ('back_not_on_table',     'chair_back',  'no',       'near',     'flat_screen', NULL, 0.3, 'backs of chairs stay away from flat screens'),
-- what is on or in walls, and furniture along them
  ('door_upright',          'door',        'every',    'orthogonal', 'floor',   NULL, 2.0, 'a door is orthogonal to the floor'),
  ('door_in_wall',          'door',        'some',     'near',     'wall',      NULL, 1.5, 'a door is in or near a wall'),
  ('window_in_wall',        'window',      'some',     'near',     'wall',      NULL, 1.5, 'a window is in or near a wall'),
  ('window_along_wall',     'window',      'some',     'parallel', 'wall',      NULL, 1.5, 'a window is parallel to a wall'),
  ('whiteboard_on_wall',    'whiteboard',  'some',     'near',     'wall',      NULL, 2.0, 'a whiteboard hangs on a wall'),
  ('whiteboard_along_wall', 'whiteboard',  'some',     'parallel', 'wall',      NULL, 2.0, 'a whiteboard is parallel to a wall'),
  ('shelf_not_on_table',    'shelf',       'no',       'above',    'table',     NULL, 0.7, 'shelves seldom stand on tables'),
  ('shelf_near_shelf',      'shelf',       'some',     'near',     'shelf',     NULL, 1.0, 'a shelf has several boards'),
  ('cabinet_of_faces',      'cabinet',     'some',     'touching', 'cabinet',   NULL, 0.5, 'of a cabinet more than one face is seen'),
  ('cabinet_near_wall',     'cabinet',     'some',     'near',     'wall',      NULL, 0.5, 'a cabinet mostly stands near a wall'),
  ('cabinet_not_on_table',  'cabinet',     'no',       'above',    'table',     NULL, 1.0, 'no cabinet stands on a table');

-- Things of several surfaces. The rows above already ask for backs near seats, so that these only group what is labelled.
INSERT INTO composite (name, description) VALUES
  ('chair',   'a seat and its back'),
  ('cabinet', 'its front, sides, top and open wings');
INSERT INTO composite_part (composite, part, class, relation, orientation, fewest, most, weight) VALUES
  ('chair',   'seat',  'chair_seat', NULL,       NULL,      0, 1, NULL),
  ('chair',   'back',  'chair_back', 'near',     NULL,      0, 1, NULL),
  ('cabinet', 'front', 'cabinet',    NULL,       'upright', 0, 1, NULL),
  ('cabinet', 'side',  'cabinet',    'touching', 'upright', 0, 4, NULL),
  ('cabinet', 'top',   'cabinet',    'touching', 'level',   0, 1, NULL);

-- Until something better is learned (docs/knowledge.md, "What a told probability means").
INSERT INTO setting (key, value, description) VALUES
  ('probability_slope',  '0.74', 'logit of a told probability per logit of the model''s'),
  ('probability_offset', '0.16', 'what is added to it');
