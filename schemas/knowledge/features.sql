-- The start of every knowledge pack: the built-in features, the unknown class, the settings.
-- Weights: sizes say the same thing three times (area ~ length x width x rectangularity), and so do the height of the
-- centroid and of the two edges; their weights are below 1 so that the product does not count one observation thrice.
INSERT INTO feature (name, unit, scale, low, high, weight, description) VALUES
  ('area_m2',        'm2',   'log',    0.002, 100,  0.5, 'area of the alpha hull'),
  ('length',         'm',    'log',    0.03,  30,   0.7, 'longer side of the minimum-area rectangle'),
  ('width',          'm',    'log',    0.01,  12,   0.7, 'shorter side of the minimum-area rectangle'),
  ('spread_length',  'm',    'log',    0.01,  40,   0.5, 'longer side of the rectangle that spreads as the points do'),
  ('spread_width',   'm',    'log',    0.003, 20,   0.5, 'its shorter side; a few stray points hardly change it'),
  ('rectangularity', '1',    'linear', 0,     1,    0.5, 'share of that rectangle which the hull fills'),
  ('tilt_deg',       'deg',  'linear', 0,     90,   1,   'angle between normal and vertical: 0 = horizontal plane, 90 = vertical'),
  ('height',         'm',    'linear', -0.5,  4,    1,   'centroid above the floor'),
  ('z_min',          'm',    'linear', -0.5,  4,    0.5, 'lower edge above the floor'),
  ('z_max',          'm',    'linear', -0.5,  4,    0.5, 'upper edge above the floor'),
  ('x',              'm',    'linear', -20,   20,   0,   'centroid along the upright frame''s x, from the middle of the scan'),
  ('y',              'm',    'linear', -20,   20,   0,   'centroid along the upright frame''s y, from the middle of the scan'),
  ('rmse',           'm',    'log',    0.0002, 0.1, 0,   'root of the mean squared distance of its points'),
  ('point_density',  '1/m2', 'log',    1,     1e6,  0,   'points a square metre: depends on the distance to the sensor'),
  ('facing_up',      '1',    'linear', -1,    1,    0,   'z of the normal on the sensor''s side; 1 = seen from above, -1 = from below'),
  ('seen_share',     '1',    'linear', 0,     1,    0,   'share of the hull that holds points'),
  ('behind',         '1',    'linear', 0,     1,    0.5, 'share of the cubes around it that lie on its emptier side: 0 where the room ends'),
  ('edge_free',      '1',    'linear', 0,     1,    0.5, 'share of its outline beyond which the sensor looked into the room behind'),
  ('edge_free_top',  '1',    'linear', 0,     1,    0.5, 'the same of its upper edge; unknown of level planes'),
  ('edge_joined',    '1',    'linear', 0,     1,    0.5, 'share of its outline along which another surface goes on in its plane'),
  ('edge_unseen',    '1',    'linear', 0,     1,    0.5, 'share of its outline beyond which nothing was measured: the view ends there'),
  ('lift',           'm',    'log',    0.005, 2.5,  0.5, 'lower edge over the level plane beneath its middle; unknown over the floor alone'),
  ('headroom',       'm',    'linear', -2,    4,    0.5, 'from its upper edge to the lowest level plane above its middle'),
  ('standoff',       'm',    'linear', -0.05, 1.5,  0.5, 'distance of what is upright from the nearest larger plane that it stands before'),
  ('wall_offset',    'm',    'linear', -2,    6,    0.5, 'how far its middle is before the plane through the nearest parallel wall'),
  ('corner_offset',  'm',    'linear', -2,    6,    0.5, 'how far its middle is before the plane through the nearest wall at right angles'),
  ('edge_concave',   '1',    'linear', 0,     1,    0.5, 'share of its outline where another plane comes forward, as walls do at a floor''s edge'),
  ('edge_convex',    '1',    'linear', 0,     1,    0.5, 'share of its outline where another plane goes back, as the front of a cabinet does at its top''s');

INSERT INTO object_class (id, name, prior, color, fallback, description) VALUES
  (0, 'unknown', 0.30, '#9e9e9e', 1, 'what fits nothing: books, boxes, plants, people');

INSERT INTO setting (key, value, description) VALUES
  ('combination',     'product', 'how features combine: product (weights as exponents) or mean (equation 1 of the paper)'),
  ('floor',           'ranked',  'where the search starts: ranked (by cost) or threshold (the paper: a floor with at least floor_threshold)'),
  ('floor_threshold', '0.4',     'probability that the first floor needs; used with floor = threshold'),
  ('outlier_share',   '0.05',    'share of values that do not follow their class''s density, 0 to 0.5: bounds what one odd value can do');
