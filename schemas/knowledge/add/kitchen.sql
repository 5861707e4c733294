-- Knowledge pack "kitchen", for `scenelore kb add kitchen FILE` on top of the office's: what kitchens have besides.
-- Gaussians by hand from usual measures (EN 1116: worktops 0.6 m deep and about 0.9 m high); `scenelore learn` makes them better.
INSERT INTO object_class (id, name, prior, color, description) VALUES
  (50, 'counter',      0.03,  '#a1887f', 'worktops over base cabinets'),
  (51, 'stove',        0.03,  '#455a64', 'the top that one cooks on, when it is not level with the counter'),
  (52, 'fridge',       0.05,  '#80deea', 'fronts and sides of refrigerators'),
  (53, 'wall_cabinet', 0.10,  '#26a69a', 'fronts, sides and undersides of cupboards that hang on a wall');

INSERT INTO class_feature (class, feature, mean, sigma) VALUES
-- counter: runs of 1 to 3 m, 0.6 m deep, 0.85-0.95 m high, the sink a hole in it.
  ('counter', 'area_m2',        ln(0.85), 0.45),
  ('counter', 'length',         ln(1.75), 0.35),
  ('counter', 'width',          ln(0.60), 0.12),
  ('counter', 'spread_length',  ln(1.75), 0.40),
  ('counter', 'spread_width',   ln(0.55), 0.20),
  ('counter', 'aspect',         ln(2.9),  0.35),
  ('counter', 'rectangularity', 0.85,     0.12),
  ('counter', 'tilt_deg',       0.7,      1.5),
  ('counter', 'height',         0.91,     0.025),
  ('counter', 'z_min',          0.90,     0.03),
  ('counter', 'z_max',          0.92,     0.03),
-- stove: 0.6 m square, a little below the counter.
  ('stove', 'area_m2',        ln(0.25), 0.40),
  ('stove', 'length',         ln(0.66), 0.22),
  ('stove', 'width',          ln(0.48), 0.25),
  ('stove', 'spread_length',  ln(0.62), 0.25),
  ('stove', 'spread_width',   ln(0.45), 0.30),
  ('stove', 'aspect',         ln(1.30), 0.25),
  ('stove', 'rectangularity', 0.72,     0.20),
  ('stove', 'tilt_deg',       1.0,      2.0),
  ('stove', 'height',         0.84,     0.03),
  ('stove', 'z_min',          0.83,     0.03),
  ('stove', 'z_max',          0.85,     0.03),
-- fridge: 0.55-0.65 m wide and deep, 1.4-1.9 m high, from the floor up.
  ('fridge', 'area_m2',        ln(0.90), 0.30),
  ('fridge', 'length',         ln(1.65), 0.15),
  ('fridge', 'width',          ln(0.58), 0.15),
  ('fridge', 'spread_length',  ln(1.65), 0.20),
  ('fridge', 'spread_width',   ln(0.57), 0.15),
  ('fridge', 'aspect',         ln(2.9),  0.20),
  ('fridge', 'rectangularity', 0.85,     0.14),
  ('fridge', 'tilt_deg',       89,       1.5),
  ('fridge', 'height',         0.87,     0.12),
  ('fridge', 'z_min',          0.05,     0.06),
  ('fridge', 'z_max',          1.70,     0.15),
-- wall_cabinet: fronts 0.4-2 m wide and 0.6-0.75 m high, from 1.4 m up; depths of 0.33 m.
  ('wall_cabinet', 'area_m2',        ln(0.50), 0.70),
  ('wall_cabinet', 'length',         ln(1.00), 0.50),
  ('wall_cabinet', 'width',          ln(0.55), 0.40),
  ('wall_cabinet', 'spread_length',  ln(1.00), 0.55),
  ('wall_cabinet', 'spread_width',   ln(0.55), 0.40),
  ('wall_cabinet', 'aspect',         ln(1.9),  0.45),
  ('wall_cabinet', 'rectangularity', 0.82,     0.14),
  ('wall_cabinet', 'tilt_deg',       88,       12),
  ('wall_cabinet', 'height',         1.75,     0.10),
  ('wall_cabinet', 'z_min',          1.42,     0.07),
  ('wall_cabinet', 'z_max',          2.10,     0.08);

INSERT INTO class_constraint (name, class, quantifier, relation, other_class, count, weight, message) VALUES
  ('counter_level',            'counter',      'every', 'parallel', 'floor',   NULL, 2.0, 'a counter is level'),
  ('counter_near_wall',        'counter',      'some',  'near',     'wall',    NULL, 1.0, 'a counter runs along a wall'),
  ('stove_near_counter',       'stove',        'some',  'near',     'counter', NULL, 1.5, 'a stove stands beside the counter'),
  ('fridge_upright',           'fridge',       'every', 'orthogonal', 'floor', NULL, 2.0, 'a fridge stands upright'),
  ('fridge_near_wall',         'fridge',       'some',  'near',     'wall',    NULL, 0.7, 'a fridge stands near a wall'),
  ('fridge_not_on_table',      'fridge',       'no',    'above',    'table',   NULL, 2.0, 'no fridge stands on a table'),
  ('wall_cabinet_at_wall',     'wall_cabinet', 'some',  'near',     'wall',    NULL, 1.5, 'a cupboard hangs on a wall');
