-- Knowledge pack "paper": the reference mode, as Goldhoorn & Hartanto 2014 describe it. Equation 1 (the weighted mean) over
-- Gaussians, a floor to start from with at least 40 %, hard constraints. The paper prints no mu, sigma or F_i, so they are
-- the hand-set ones of pack "office", with equal weights for its features A, E, R, O and P (O as tilt, P as height).
UPDATE setting SET value = 'mean' WHERE key = 'combination';
UPDATE setting SET value = 'threshold' WHERE key = 'floor';
UPDATE setting SET value = '0' WHERE key = 'outlier_share';
UPDATE feature SET weight = 0;
UPDATE feature SET weight = 1 WHERE name IN ('area_m2', 'rectangularity', 'tilt_deg', 'height');
UPDATE feature SET weight = 0.5 WHERE name IN ('length', 'width');  -- together the expansion E
UPDATE object_class SET prior = 1 WHERE name = 'unknown';           -- the paper weighs no class above another

INSERT INTO object_class (id, name, prior, color, description) VALUES
  (1, 'floor',       1, '#8d6e63', 'what one walks on'),
  (2, 'ceiling',     1, '#cfd8dc', 'the lower side of what is above the room'),
  (3, 'wall',        1, '#ffe0b2', 'walls'),
  (4, 'table',       1, '#ff9800', 'tops of tables and desks'),
  (5, 'flat_screen', 1, '#1565c0', 'monitors'),
  (6, 'keyboard',    1, '#c2185b', 'keyboards on tables');

INSERT INTO class_feature (class, feature, mean, sigma) VALUES
  ('floor',       'area_m2',        ln(12.0),  0.80),
  ('floor',       'length',         ln(5.0),   0.50),
  ('floor',       'width',          ln(3.5),   0.50),
  ('floor',       'rectangularity', 0.75,      0.20),
  ('floor',       'tilt_deg',       0.5,       1.5),
  ('floor',       'height',         0.0,       0.06),
  ('ceiling',     'area_m2',        ln(14.0),  0.80),
  ('ceiling',     'length',         ln(5.2),   0.50),
  ('ceiling',     'width',          ln(3.7),   0.50),
  ('ceiling',     'rectangularity', 0.80,      0.20),
  ('ceiling',     'tilt_deg',       0.5,       1.5),
  ('ceiling',     'height',         2.70,      0.25),
  ('wall',        'area_m2',        ln(5.0),   0.90),
  ('wall',        'length',         ln(3.5),   0.60),
  ('wall',        'width',          ln(2.0),   0.60),
  ('wall',        'rectangularity', 0.75,      0.20),
  ('wall',        'tilt_deg',       89.5,      1.5),
  ('wall',        'height',         1.40,      0.30),
  ('table',       'area_m2',        ln(0.95),  0.45),
  ('table',       'length',         ln(1.45),  0.30),
  ('table',       'width',          ln(0.74),  0.25),
  ('table',       'rectangularity', 0.82,      0.15),
  ('table',       'tilt_deg',       0.8,       1.8),
  ('table',       'height',         0.73,      0.04),
  ('flat_screen', 'area_m2',        ln(0.14),  0.35),
  ('flat_screen', 'length',         ln(0.49),  0.18),
  ('flat_screen', 'width',          ln(0.30),  0.20),
  ('flat_screen', 'rectangularity', 0.90,      0.10),
  ('flat_screen', 'tilt_deg',       84.0,      6.0),
  ('flat_screen', 'height',         1.02,      0.10),
  ('keyboard',    'area_m2',        ln(0.058), 0.35),
  ('keyboard',    'length',         ln(0.43),  0.15),
  ('keyboard',    'width',          ln(0.145), 0.22),
  ('keyboard',    'rectangularity', 0.85,      0.12),
  ('keyboard',    'tilt_deg',       3.0,       3.0),
  ('keyboard',    'height',         0.76,      0.04);

-- The relations that the paper names (parallel, orthogonal, above, under, equal height), all hard.
INSERT INTO class_constraint (name, class, quantifier, relation, other_class, count, weight, message) VALUES
  ('floor_lowest',        'floor',       'no',    'above',        NULL,      NULL, NULL, 'a floor lies above nothing'),
  ('one_floor_level',     'floor',       'every', 'equal_height', 'floor',   NULL, NULL, 'all parts of a floor are at one height'),
  ('wall_upright',        'wall',        'every', 'orthogonal',   'floor',   NULL, NULL, 'a wall is orthogonal to the floor'),
  ('ceiling_level',       'ceiling',     'every', 'parallel',     'floor',   NULL, NULL, 'a ceiling is parallel to the floor'),
  ('ceiling_highest',     'ceiling',     'no',    'under',        NULL,      NULL, NULL, 'a ceiling lies under nothing'),
  ('table_level',         'table',       'every', 'parallel',     'floor',   NULL, NULL, 'a table top is parallel to the floor'),
  ('screen_over_table',   'flat_screen', 'some',  'above',        'table',   NULL, NULL, 'a flat screen stands over some table'),
  ('screen_upright',      'flat_screen', 'some',  'orthogonal',   'table',   NULL, NULL, 'a flat screen is orthogonal to some table'),
  ('keyboard_over_table', 'keyboard',    'some',  'above',        'table',   NULL, NULL, 'a keyboard lies over some table'),
  ('keyboard_level',      'keyboard',    'some',  'parallel',     'table',   NULL, NULL, 'a keyboard is parallel to some table');
