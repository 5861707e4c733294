-- Knowledge pack "home", for `scenelore kb add home FILE` on top of the office's: what living rooms and bedrooms have besides.
-- Gaussians by hand from usual measures; `scenelore learn` makes them better. Means of sizes are ln(metres).
INSERT INTO object_class (id, name, prior, color, description) VALUES
  (40, 'sofa',      0.02,  '#ec407a', 'seats of sofas for two and more'),
  (41, 'sofa_back', 0.02,  '#ad1457', 'what one leans against on a sofa'),
  (42, 'bed',       0.02,  '#9575cd', 'what one lies on'),
  (43, 'radiator',  0.05,  '#ff7043', 'heaters along walls, mostly below windows');

INSERT INTO class_feature (class, feature, mean, sigma) VALUES
-- sofa: 1.2-1.9 m between the arms, 0.55-0.75 m deep, 0.40-0.46 m high.
  ('sofa', 'area_m2',        ln(0.85), 0.40),
  ('sofa', 'length',         ln(1.45), 0.25),
  ('sofa', 'width',          ln(0.65), 0.25),
  ('sofa', 'spread_length',  ln(1.45), 0.25),
  ('sofa', 'spread_width',   ln(0.62), 0.25),
  ('sofa', 'aspect',         ln(2.3),  0.35),
  ('sofa', 'rectangularity', 0.90,     0.12),
  ('sofa', 'tilt_deg',       2.0,      3.0),
  ('sofa', 'height',         0.43,     0.05),
  ('sofa', 'z_min',          0.41,     0.05),
  ('sofa', 'z_max',          0.45,     0.05),
-- sofa_back: the same length, from the seat up to 0.75-0.90 m.
  ('sofa_back', 'area_m2',        ln(0.50), 0.45),
  ('sofa_back', 'length',         ln(1.40), 0.30),
  ('sofa_back', 'width',          ln(0.37), 0.30),
  ('sofa_back', 'spread_length',  ln(1.40), 0.30),
  ('sofa_back', 'spread_width',   ln(0.37), 0.30),
  ('sofa_back', 'aspect',         ln(3.8),  0.40),
  ('sofa_back', 'rectangularity', 0.90,     0.12),
  ('sofa_back', 'tilt_deg',       86,       6.0),
  ('sofa_back', 'height',         0.62,     0.06),
  ('sofa_back', 'z_min',          0.45,     0.07),
  ('sofa_back', 'z_max',          0.81,     0.06),
-- bed: 0.9-1.8 m by 2.0 m, 0.45-0.60 m high.
  ('bed', 'area_m2',        ln(2.2),  0.40),
  ('bed', 'length',         ln(1.95), 0.15),
  ('bed', 'width',          ln(1.20), 0.30),
  ('bed', 'spread_length',  ln(1.95), 0.20),
  ('bed', 'spread_width',   ln(1.15), 0.30),
  ('bed', 'aspect',         ln(1.5),  0.30),
  ('bed', 'rectangularity', 0.88,     0.12),
  ('bed', 'tilt_deg',       1.0,      3.0),
  ('bed', 'height',         0.52,     0.07),
  ('bed', 'z_min',          0.49,     0.08),
  ('bed', 'z_max',          0.55,     0.08),
-- radiator: 0.6-2.0 m long, 0.4-0.7 m high, its lower edge at 0.10-0.15 m.
  ('radiator', 'area_m2',        ln(0.50), 0.55),
  ('radiator', 'length',         ln(1.10), 0.40),
  ('radiator', 'width',          ln(0.52), 0.25),
  ('radiator', 'spread_length',  ln(1.10), 0.45),
  ('radiator', 'spread_width',   ln(0.50), 0.25),
  ('radiator', 'aspect',         ln(2.1),  0.40),
  ('radiator', 'rectangularity', 0.82,     0.15),
  ('radiator', 'tilt_deg',       89,       2.0),
  ('radiator', 'height',         0.42,     0.08),
  ('radiator', 'z_min',          0.14,     0.06),
  ('radiator', 'z_max',          0.70,     0.12);

INSERT INTO class_constraint (name, class, quantifier, relation, other_class, count, weight, message) VALUES
  ('sofa_level',           'sofa',      'every', 'parallel',  'floor',     NULL, 1.0, 'the seat of a sofa is about parallel to the floor'),
  ('bed_level',            'bed',       'every', 'parallel',  'floor',     NULL, 1.0, 'a bed is level'),
  ('bed_not_on_table',     'bed',       'no',   'above',      'table',     NULL, 2.0, 'no bed stands on a table'),
  ('radiator_at_wall',     'radiator',  'some', 'near',       'wall',      NULL, 2.0, 'a radiator hangs near a wall'),
  ('radiator_along_wall',  'radiator',  'some', 'parallel',   'wall',      NULL, 1.5, 'a radiator is parallel to a wall'),
  ('radiator_not_on_table', 'radiator', 'no',   'above',      'table',     NULL, 2.0, 'no radiator stands on a table');

-- A sofa has a seat and a back, and each asks for the other.
INSERT INTO composite (name, description) VALUES ('sofa', 'a seat and its back');
INSERT INTO composite_part (composite, part, class, relation, orientation, fewest, most, weight) VALUES
  ('sofa', 'seat', 'sofa',      NULL,   'level',   0, 1, NULL),
  ('sofa', 'back', 'sofa_back', 'near', 'upright', 0, 1, 2.0);
