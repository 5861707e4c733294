-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 8088 planes of 60 paper-like rooms, seeds from 1; 48 varied rooms, seeds from 301; 72 depth-camera frames, seeds from 101.
-- Priors and weights: 36 paper-like rooms, seeds from 11; 24 varied rooms, seeds from 401; 36 depth-camera frames, seeds from 201.

-- unknown: 3628 examples
UPDATE object_class SET prior = 0.526 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -2.064, 1.188)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6122, 0.4964)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4402, 0.2906)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.4572, 0.3047)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.5773, 0.4018)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_joined', 0.3114, 0.3195)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 0.9746, 0.6679)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.5395, 0.6847)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.7062, 0.1383)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.6684, 0.6979)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.356, 0.5961)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 65.25, 36.09)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.154, 0.6014)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.21, 0.8197)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7279, 0.7031)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0156266, 0.003857),
  ('unknown', 'area_m2', 0.0156266, 0.0325183, 0.1398),
  ('unknown', 'area_m2', 0.0325183, 0.0342084, 0.2169),
  ('unknown', 'area_m2', 0.0342084, 0.053016, 0.233),
  ('unknown', 'area_m2', 0.053016, 0.0707056, 0.3793),
  ('unknown', 'area_m2', 0.0707056, 0.0748859, 0.339),
  ('unknown', 'area_m2', 0.0748859, 0.0941242, 0.3993),
  ('unknown', 'area_m2', 0.0941242, 0.131006, 0.34),
  ('unknown', 'area_m2', 0.131006, 0.163933, 0.2826),
  ('unknown', 'area_m2', 0.163933, 0.194656, 0.2799),
  ('unknown', 'area_m2', 0.194656, 0.281903, 0.2958),
  ('unknown', 'area_m2', 0.281903, 0.358868, 0.2694),
  ('unknown', 'area_m2', 0.358868, 0.474097, 0.167),
  ('unknown', 'area_m2', 0.474097, 0.785602, 0.1273),
  ('unknown', 'area_m2', 0.785602, 1.71977, 0.03041),
  ('unknown', 'area_m2', 1.71977, 3.76477, 0.006444),
  ('unknown', 'area_m2', 3.76477, 8.24149, 0.004934),
  ('unknown', 'area_m2', 8.24149, 18.0415, 0.006234),
  ('unknown', 'area_m2', 18.0415, 100, 0.005636);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.11354, 1.044),
  ('unknown', 'aspect', 1.11354, 1.23416, 1.075),
  ('unknown', 'aspect', 1.23416, 1.25263, 0.9515),
  ('unknown', 'aspect', 1.25263, 1.36552, 1.106),
  ('unknown', 'aspect', 1.36552, 1.52259, 1.037),
  ('unknown', 'aspect', 1.52259, 1.56908, 0.9595),
  ('unknown', 'aspect', 1.56908, 1.72103, 0.8648),
  ('unknown', 'aspect', 1.72103, 1.96548, 0.732),
  ('unknown', 'aspect', 1.96548, 2.00656, 0.6963),
  ('unknown', 'aspect', 2.00656, 2.46201, 0.5456),
  ('unknown', 'aspect', 2.46201, 3.08399, 0.319),
  ('unknown', 'aspect', 3.08399, 3.8631, 0.1742),
  ('unknown', 'aspect', 3.8631, 3.91621, 0.1214),
  ('unknown', 'aspect', 3.91621, 4.83903, 0.1481),
  ('unknown', 'aspect', 4.83903, 6.06151, 0.1991),
  ('unknown', 'aspect', 6.06151, 7.59282, 0.1036),
  ('unknown', 'aspect', 7.59282, 100, 0.00399);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.0968735, 2.238),
  ('unknown', 'behind', 0.0968735, 0.107143, 0.5262),
  ('unknown', 'behind', 0.107143, 0.193747, 0.4674),
  ('unknown', 'behind', 0.193747, 0.290621, 0.697),
  ('unknown', 'behind', 0.290621, 0.294118, 0.8256),
  ('unknown', 'behind', 0.294118, 0.387494, 0.6779),
  ('unknown', 'behind', 0.387494, 0.437652, 0.9541),
  ('unknown', 'behind', 0.437652, 0.484368, 0.9631),
  ('unknown', 'behind', 0.484368, 0.549354, 0.9998),
  ('unknown', 'behind', 0.549354, 0.581241, 1.114),
  ('unknown', 'behind', 0.581241, 0.638009, 1.37),
  ('unknown', 'behind', 0.638009, 0.678115, 1.22),
  ('unknown', 'behind', 0.678115, 0.717716, 1.556),
  ('unknown', 'behind', 0.717716, 0.774988, 1.669),
  ('unknown', 'behind', 0.774988, 0.785034, 1.541),
  ('unknown', 'behind', 0.785034, 0.871862, 1.212),
  ('unknown', 'behind', 0.871862, 1, 0.04419);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free', 0, 0.00893214, 12.63),
  ('unknown', 'edge_free', 0.00893214, 0.111111, 0.7413),
  ('unknown', 'edge_free', 0.111111, 0.160689, 0.6531),
  ('unknown', 'edge_free', 0.160689, 0.222222, 0.6773),
  ('unknown', 'edge_free', 0.222222, 0.31069, 0.8047),
  ('unknown', 'edge_free', 0.31069, 0.333333, 0.8301),
  ('unknown', 'edge_free', 0.333333, 0.420803, 1.058),
  ('unknown', 'edge_free', 0.420803, 0.444444, 1.351),
  ('unknown', 'edge_free', 0.444444, 0.505638, 1.284),
  ('unknown', 'edge_free', 0.505638, 0.555556, 1.091),
  ('unknown', 'edge_free', 0.555556, 0.608652, 1.071),
  ('unknown', 'edge_free', 0.608652, 0.666667, 1.147),
  ('unknown', 'edge_free', 0.666667, 0.710391, 0.9948),
  ('unknown', 'edge_free', 0.710391, 0.777778, 0.8325),
  ('unknown', 'edge_free', 0.777778, 0.878604, 0.5446),
  ('unknown', 'edge_free', 0.878604, 0.888889, 0.4309),
  ('unknown', 'edge_free', 0.888889, 1, 0.9676);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free_top', 0, 0.054775, 4.072),
  ('unknown', 'edge_free_top', 0.054775, 0.111111, 0.4023),
  ('unknown', 'edge_free_top', 0.111111, 0.222222, 0.3698),
  ('unknown', 'edge_free_top', 0.222222, 0.333271, 0.4149),
  ('unknown', 'edge_free_top', 0.333271, 0.444444, 0.443),
  ('unknown', 'edge_free_top', 0.444444, 0.555556, 0.4109),
  ('unknown', 'edge_free_top', 0.555556, 0.594691, 0.4568),
  ('unknown', 'edge_free_top', 0.594691, 0.666667, 0.4783),
  ('unknown', 'edge_free_top', 0.666667, 0.777778, 0.6775),
  ('unknown', 'edge_free_top', 0.777778, 0.888889, 0.6793),
  ('unknown', 'edge_free_top', 0.888889, 0.924376, 1.058),
  ('unknown', 'edge_free_top', 0.924376, 1, 4.385);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_joined', 0, 0.0198234, 11.22),
  ('unknown', 'edge_joined', 0.0198234, 0.0678417, 2.296),
  ('unknown', 'edge_joined', 0.0678417, 0.111111, 1.546),
  ('unknown', 'edge_joined', 0.111111, 0.142882, 1.37),
  ('unknown', 'edge_joined', 0.142882, 0.222222, 1.072),
  ('unknown', 'edge_joined', 0.222222, 0.249264, 0.9779),
  ('unknown', 'edge_joined', 0.249264, 0.333333, 0.7538),
  ('unknown', 'edge_joined', 0.333333, 0.40275, 0.701),
  ('unknown', 'edge_joined', 0.40275, 0.444444, 0.6615),
  ('unknown', 'edge_joined', 0.444444, 0.555556, 0.5868),
  ('unknown', 'edge_joined', 0.555556, 0.586911, 0.5827),
  ('unknown', 'edge_joined', 0.586911, 0.666667, 0.5632),
  ('unknown', 'edge_joined', 0.666667, 0.777778, 0.418),
  ('unknown', 'edge_joined', 0.777778, 0.824419, 0.4101),
  ('unknown', 'edge_joined', 0.824419, 0.888889, 0.3526),
  ('unknown', 'edge_joined', 0.888889, 1, 0.8016);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.00958471, 0.01257),
  ('unknown', 'height', 0.00958471, 0.222727, 0.4954),
  ('unknown', 'height', 0.222727, 0.340622, 0.5701),
  ('unknown', 'height', 0.340622, 0.42797, 0.5211),
  ('unknown', 'height', 0.42797, 0.603855, 0.6176),
  ('unknown', 'height', 0.603855, 0.671659, 0.5073),
  ('unknown', 'height', 0.671659, 0.782918, 0.6837),
  ('unknown', 'height', 0.782918, 0.904956, 0.9111),
  ('unknown', 'height', 0.904956, 1.0027, 0.6179),
  ('unknown', 'height', 1.0027, 1.12082, 0.425),
  ('unknown', 'height', 1.12082, 1.33373, 0.3704),
  ('unknown', 'height', 1.33373, 1.43418, 0.3304),
  ('unknown', 'height', 1.43418, 1.66477, 0.3304),
  ('unknown', 'height', 1.66477, 1.85661, 0.1793),
  ('unknown', 'height', 1.85661, 1.99581, 0.1104),
  ('unknown', 'height', 1.99581, 2.32685, 0.1379),
  ('unknown', 'height', 2.32685, 2.65788, 0.07357),
  ('unknown', 'height', 2.65788, 2.98892, 0.04659),
  ('unknown', 'height', 2.98892, 4, 0.01083);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.154748, 0.004023),
  ('unknown', 'length', 0.154748, 0.233524, 0.1802),
  ('unknown', 'length', 0.233524, 0.260712, 0.2785),
  ('unknown', 'length', 0.260712, 0.338055, 0.4272),
  ('unknown', 'length', 0.338055, 0.352402, 0.5755),
  ('unknown', 'length', 0.352402, 0.409235, 0.5757),
  ('unknown', 'length', 0.409235, 0.493837, 0.5981),
  ('unknown', 'length', 0.493837, 0.531796, 0.5792),
  ('unknown', 'length', 0.531796, 0.612778, 0.4729),
  ('unknown', 'length', 0.612778, 0.772041, 0.4868),
  ('unknown', 'length', 0.772041, 0.802512, 0.4508),
  ('unknown', 'length', 0.802512, 0.984475, 0.4518),
  ('unknown', 'length', 0.984475, 1.21104, 0.3503),
  ('unknown', 'length', 1.21104, 1.32771, 0.4329),
  ('unknown', 'length', 1.32771, 1.82753, 0.2434),
  ('unknown', 'length', 1.82753, 2.75786, 0.0262),
  ('unknown', 'length', 2.75786, 4.16178, 0.01304),
  ('unknown', 'length', 4.16178, 6.28038, 0.01668),
  ('unknown', 'length', 6.28038, 30, 0.006311);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.319742, 0.02947),
  ('unknown', 'rectangularity', 0.319742, 0.390854, 0.2456),
  ('unknown', 'rectangularity', 0.390854, 0.461966, 0.3769),
  ('unknown', 'rectangularity', 0.461966, 0.529014, 0.8683),
  ('unknown', 'rectangularity', 0.529014, 0.533078, 1.474),
  ('unknown', 'rectangularity', 0.533078, 0.60234, 1.512),
  ('unknown', 'rectangularity', 0.60234, 0.60419, 1.871),
  ('unknown', 'rectangularity', 0.60419, 0.65527, 2.096),
  ('unknown', 'rectangularity', 0.65527, 0.675302, 2.317),
  ('unknown', 'rectangularity', 0.675302, 0.699238, 2.745),
  ('unknown', 'rectangularity', 0.699238, 0.74055, 2.683),
  ('unknown', 'rectangularity', 0.74055, 0.746413, 2.744),
  ('unknown', 'rectangularity', 0.746413, 0.7818, 2.683),
  ('unknown', 'rectangularity', 0.7818, 0.817525, 2.838),
  ('unknown', 'rectangularity', 0.817525, 0.821927, 2.103),
  ('unknown', 'rectangularity', 0.821927, 0.869544, 2.343),
  ('unknown', 'rectangularity', 0.869544, 0.888637, 1.789),
  ('unknown', 'rectangularity', 0.888637, 0.959749, 0.9804),
  ('unknown', 'rectangularity', 0.959749, 1, 0.1679);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.14675, 0.002705),
  ('unknown', 'spread_length', 0.14675, 0.222639, 0.2189),
  ('unknown', 'spread_length', 0.222639, 0.231568, 0.3191),
  ('unknown', 'spread_length', 0.231568, 0.290832, 0.4908),
  ('unknown', 'spread_length', 0.290832, 0.337773, 0.6971),
  ('unknown', 'spread_length', 0.337773, 0.341763, 0.6015),
  ('unknown', 'spread_length', 0.341763, 0.420036, 0.533),
  ('unknown', 'spread_length', 0.420036, 0.512447, 0.5043),
  ('unknown', 'spread_length', 0.512447, 0.52852, 0.385),
  ('unknown', 'spread_length', 0.52852, 0.690924, 0.4108),
  ('unknown', 'spread_length', 0.690924, 0.77745, 0.4872),
  ('unknown', 'spread_length', 0.77745, 0.884549, 0.4197),
  ('unknown', 'spread_length', 0.884549, 1.17949, 0.3577),
  ('unknown', 'spread_length', 1.17949, 1.20719, 0.312),
  ('unknown', 'spread_length', 1.20719, 1.78945, 0.2104),
  ('unknown', 'spread_length', 1.78945, 2.71483, 0.02036),
  ('unknown', 'spread_length', 2.71483, 4.11875, 0.01054),
  ('unknown', 'spread_length', 4.11875, 6.24869, 0.01597),
  ('unknown', 'spread_length', 6.24869, 40, 0.00507);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.107172, 0.0002784),
  ('unknown', 'spread_width', 0.107172, 0.110028, 0.1641),
  ('unknown', 'spread_width', 0.110028, 0.13538, 0.5147),
  ('unknown', 'spread_width', 0.13538, 0.158702, 0.5856),
  ('unknown', 'spread_width', 0.158702, 0.162943, 0.6161),
  ('unknown', 'spread_width', 0.162943, 0.1928, 0.6714),
  ('unknown', 'spread_width', 0.1928, 0.216752, 0.9289),
  ('unknown', 'spread_width', 0.216752, 0.23501, 1.02),
  ('unknown', 'spread_width', 0.23501, 0.243284, 0.8005),
  ('unknown', 'spread_width', 0.243284, 0.291103, 0.6192),
  ('unknown', 'spread_width', 0.291103, 0.348009, 0.5005),
  ('unknown', 'spread_width', 0.348009, 0.366952, 0.4208),
  ('unknown', 'spread_width', 0.366952, 0.515339, 0.2972),
  ('unknown', 'spread_width', 0.515339, 0.536141, 0.2538),
  ('unknown', 'spread_width', 0.536141, 0.763126, 0.2204),
  ('unknown', 'spread_width', 0.763126, 1.13006, 0.03546),
  ('unknown', 'spread_width', 1.13006, 1.67341, 0.01217),
  ('unknown', 'spread_width', 1.67341, 2.47803, 0.01067),
  ('unknown', 'spread_width', 2.47803, 3.66952, 0.007596),
  ('unknown', 'spread_width', 3.66952, 20, 0.005497);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 1.70172, 0.06493),
  ('unknown', 'tilt_deg', 1.70172, 10, 0.01134),
  ('unknown', 'tilt_deg', 10, 14.5647, 0.003724),
  ('unknown', 'tilt_deg', 14.5647, 20, 0.003231),
  ('unknown', 'tilt_deg', 20, 30, 0.00134),
  ('unknown', 'tilt_deg', 30, 40, 0.001033),
  ('unknown', 'tilt_deg', 40, 50, 0.0009626),
  ('unknown', 'tilt_deg', 50, 60, 0.0008962),
  ('unknown', 'tilt_deg', 60, 70, 0.001431),
  ('unknown', 'tilt_deg', 70, 77.8494, 0.004889),
  ('unknown', 'tilt_deg', 77.8494, 80, 0.006373),
  ('unknown', 'tilt_deg', 80, 86.8464, 0.01441),
  ('unknown', 'tilt_deg', 86.8464, 88.6479, 0.06221),
  ('unknown', 'tilt_deg', 88.6479, 89.4012, 0.1591),
  ('unknown', 'tilt_deg', 89.4012, 89.7634, 0.4045),
  ('unknown', 'tilt_deg', 89.7634, 90, 0.7398);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.113903, 0.002554),
  ('unknown', 'width', 0.113903, 0.159582, 0.3126),
  ('unknown', 'width', 0.159582, 0.168253, 0.4581),
  ('unknown', 'width', 0.168253, 0.200002, 0.5057),
  ('unknown', 'width', 0.200002, 0.232696, 0.7233),
  ('unknown', 'width', 0.232696, 0.248537, 0.8305),
  ('unknown', 'width', 0.248537, 0.266772, 0.7914),
  ('unknown', 'width', 0.266772, 0.316792, 0.6498),
  ('unknown', 'width', 0.316792, 0.36713, 0.7364),
  ('unknown', 'width', 0.36713, 0.463257, 0.4869),
  ('unknown', 'width', 0.463257, 0.542311, 0.3409),
  ('unknown', 'width', 0.542311, 0.666874, 0.2823),
  ('unknown', 'width', 0.666874, 0.801081, 0.3084),
  ('unknown', 'width', 0.801081, 1.18333, 0.07715),
  ('unknown', 'width', 1.18333, 1.74797, 0.01676),
  ('unknown', 'width', 1.74797, 2.58203, 0.01163),
  ('unknown', 'width', 2.58203, 3.81408, 0.009513),
  ('unknown', 'width', 3.81408, 12, 0.00826);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.028058, 0.01319),
  ('unknown', 'z_max', 0.028058, 0.393265, 0.283),
  ('unknown', 'z_max', 0.393265, 0.469385, 0.6006),
  ('unknown', 'z_max', 0.469385, 0.662606, 0.3457),
  ('unknown', 'z_max', 0.662606, 0.783276, 0.9301),
  ('unknown', 'z_max', 0.783276, 0.897715, 0.9509),
  ('unknown', 'z_max', 0.897715, 0.910712, 0.7844),
  ('unknown', 'z_max', 0.910712, 1.06525, 0.6599),
  ('unknown', 'z_max', 1.06525, 1.31312, 0.4439),
  ('unknown', 'z_max', 1.31312, 1.35204, 0.2959),
  ('unknown', 'z_max', 1.35204, 1.78521, 0.2324),
  ('unknown', 'z_max', 1.78521, 1.79337, 0.2424),
  ('unknown', 'z_max', 1.79337, 2.1774, 0.2792),
  ('unknown', 'z_max', 2.1774, 2.23469, 0.3494),
  ('unknown', 'z_max', 2.23469, 2.67602, 0.1151),
  ('unknown', 'z_max', 2.67602, 3.11735, 0.04038),
  ('unknown', 'z_max', 3.11735, 3.55867, 0.01507),
  ('unknown', 'z_max', 3.55867, 4, 0.03903);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.124968, 0.04338),
  ('unknown', 'z_min', -0.124968, -0.0118496, 0.8395),
  ('unknown', 'z_min', -0.0118496, 0.0598839, 1.551),
  ('unknown', 'z_min', 0.0598839, 0.250065, 0.4416),
  ('unknown', 'z_min', 0.250065, 0.335382, 0.3106),
  ('unknown', 'z_min', 0.335382, 0.614603, 0.3928),
  ('unknown', 'z_min', 0.614603, 0.625097, 0.585),
  ('unknown', 'z_min', 0.625097, 0.74611, 0.8858),
  ('unknown', 'z_min', 0.74611, 0.866486, 0.9051),
  ('unknown', 'z_min', 0.866486, 1.00013, 0.5295),
  ('unknown', 'z_min', 1.00013, 1.11876, 0.3474),
  ('unknown', 'z_min', 1.11876, 1.37516, 0.3161),
  ('unknown', 'z_min', 1.37516, 1.55407, 0.171),
  ('unknown', 'z_min', 1.55407, 1.75019, 0.08863),
  ('unknown', 'z_min', 1.75019, 2.12523, 0.07791),
  ('unknown', 'z_min', 2.12523, 2.50026, 0.09321),
  ('unknown', 'z_min', 2.50026, 2.87529, 0.05017),
  ('unknown', 'z_min', 2.87529, 4, 0.009824);
DELETE FROM class_kind WHERE class = 'unknown';
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.05161, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'area_m2', -2.616, 0.3239),
  ('unknown', 1, 'aspect', 0.3401, 0.2354),
  ('unknown', 1, 'behind', 0.6592, 0.1616),
  ('unknown', 1, 'edge_free', 0.5628, 0.1371),
  ('unknown', 1, 'edge_free_top', 0.8673, 0.1686),
  ('unknown', 1, 'edge_joined', 0.1368, 0.1494),
  ('unknown', 1, 'height', 0.1789, 0.04762),
  ('unknown', 1, 'length', -0.8963, 0.1848),
  ('unknown', 1, 'rectangularity', 0.6303, 0.1272),
  ('unknown', 1, 'spread_length', -1.084, 0.1789),
  ('unknown', 1, 'spread_width', -1.604, 0.2085),
  ('unknown', 1, 'tilt_deg', 88.04, 3.325),
  ('unknown', 1, 'width', -1.236, 0.2387),
  ('unknown', 1, 'z_max', 0.3452, 0.07099),
  ('unknown', 1, 'z_min', -0.002834, 0.04207);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.03989, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'area_m2', -3.823, 0.2571),
  ('unknown', 2, 'aspect', 0.2905, 0.227),
  ('unknown', 2, 'behind', 0.2907, 0.2419),
  ('unknown', 2, 'edge_free', 0.3025, 0.2697),
  ('unknown', 2, 'edge_free_top', 0.2747, 0.3321),
  ('unknown', 2, 'edge_joined', 0.5687, 0.3131),
  ('unknown', 2, 'height', 0.7621, 0.1315),
  ('unknown', 2, 'length', -1.617, 0.1938),
  ('unknown', 2, 'rectangularity', 0.75, 0.09937),
  ('unknown', 2, 'spread_length', -1.675, 0.176),
  ('unknown', 2, 'spread_width', -2.014, 0.1171),
  ('unknown', 2, 'tilt_deg', 43.97, 36.69),
  ('unknown', 2, 'width', -1.908, 0.147),
  ('unknown', 2, 'z_max', 0.8111, 0.1397),
  ('unknown', 2, 'z_min', 0.71, 0.141);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.0387, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'area_m2', -2.236, 0.2156),
  ('unknown', 3, 'aspect', 0.3258, 0.1938),
  ('unknown', 3, 'behind', 0.5072, 0.2862),
  ('unknown', 3, 'edge_free', 0.4724, 0.2192),
  ('unknown', 3, 'edge_free_top', 0.6489, 0.2984),
  ('unknown', 3, 'edge_joined', 0.2847, 0.2333),
  ('unknown', 3, 'height', 1.248, 0.3131),
  ('unknown', 3, 'length', -0.7544, 0.158),
  ('unknown', 3, 'rectangularity', 0.6757, 0.09227),
  ('unknown', 3, 'spread_length', -0.9627, 0.168),
  ('unknown', 3, 'spread_width', -1.337, 0.1558),
  ('unknown', 3, 'tilt_deg', 87.84, 3.151),
  ('unknown', 3, 'width', -1.08, 0.1301),
  ('unknown', 3, 'z_max', 1.464, 0.3324),
  ('unknown', 3, 'z_min', 1.037, 0.3119);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.0378, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'area_m2', -2.7, 0.3377),
  ('unknown', 4, 'aspect', 0.4937, 0.33),
  ('unknown', 4, 'behind', 0.5611, 0.2108),
  ('unknown', 4, 'edge_free', 0.6412, 0.1125),
  ('unknown', 4, 'edge_free_top', 0.9818, 0.04523),
  ('unknown', 4, 'edge_joined', 0.02194, 0.03361),
  ('unknown', 4, 'height', 0.8669, 0.06958),
  ('unknown', 4, 'length', -0.9235, 0.2699),
  ('unknown', 4, 'rectangularity', 0.7082, 0.115),
  ('unknown', 4, 'spread_length', -1.212, 0.1806),
  ('unknown', 4, 'spread_width', -1.591, 0.216),
  ('unknown', 4, 'tilt_deg', 83.54, 7.132),
  ('unknown', 4, 'width', -1.417, 0.2375),
  ('unknown', 4, 'z_max', 0.9856, 0.08592),
  ('unknown', 4, 'z_min', 0.716, 0.07412);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.03588, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'area_m2', -3.523, 0.3733),
  ('unknown', 5, 'aspect', 0.4525, 0.2601),
  ('unknown', 5, 'behind', 0.3122, 0.2777),
  ('unknown', 5, 'edge_free', 0.2675, 0.2224),
  ('unknown', 5, 'edge_free_top', 0.3783, 0.3647),
  ('unknown', 5, 'edge_joined', 0.4343, 0.272),
  ('unknown', 5, 'height', 0.1588, 0.1187),
  ('unknown', 5, 'length', -1.371, 0.2531),
  ('unknown', 5, 'rectangularity', 0.7259, 0.08861),
  ('unknown', 5, 'spread_length', -1.471, 0.2587),
  ('unknown', 5, 'spread_width', -1.973, 0.1591),
  ('unknown', 5, 'tilt_deg', 53.8, 35.19),
  ('unknown', 5, 'width', -1.824, 0.1924),
  ('unknown', 5, 'z_max', 0.2298, 0.1533),
  ('unknown', 5, 'z_min', 0.08671, 0.1028);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.03536, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'area_m2', -1.155, 0.3154),
  ('unknown', 6, 'aspect', 0.3243, 0.2326),
  ('unknown', 6, 'behind', 0.5414, 0.2313),
  ('unknown', 6, 'edge_free', 0.3631, 0.2205),
  ('unknown', 6, 'edge_free_top', 0.4783, 0.3436),
  ('unknown', 6, 'edge_joined', 0.3434, 0.2907),
  ('unknown', 6, 'height', 0.4387, 0.1317),
  ('unknown', 6, 'length', -0.1449, 0.1675),
  ('unknown', 6, 'rectangularity', 0.5972, 0.1261),
  ('unknown', 6, 'spread_length', -0.2565, 0.1764),
  ('unknown', 6, 'spread_width', -0.7797, 0.2382),
  ('unknown', 6, 'tilt_deg', 88.85, 2.311),
  ('unknown', 6, 'width', -0.4692, 0.1967),
  ('unknown', 6, 'z_max', 0.8016, 0.1309),
  ('unknown', 6, 'z_min', 0.04919, 0.1018);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.03512, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'area_m2', -2.19, 0.4329),
  ('unknown', 7, 'aspect', 0.4754, 0.2674),
  ('unknown', 7, 'behind', 0.5368, 0.2592),
  ('unknown', 7, 'edge_free', 0.2182, 0.1489),
  ('unknown', 7, 'edge_free_top', 0.2601, 0.2443),
  ('unknown', 7, 'edge_joined', 0.3835, 0.3217),
  ('unknown', 7, 'height', 0.2192, 0.07132),
  ('unknown', 7, 'length', -0.5947, 0.2302),
  ('unknown', 7, 'rectangularity', 0.6082, 0.1325),
  ('unknown', 7, 'spread_length', -0.7334, 0.217),
  ('unknown', 7, 'spread_width', -1.357, 0.3066),
  ('unknown', 7, 'tilt_deg', 88.22, 3.366),
  ('unknown', 7, 'width', -1.07, 0.2487),
  ('unknown', 7, 'z_max', 0.4538, 0.1207),
  ('unknown', 7, 'z_min', 0.005945, 0.05577);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.03384, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'area_m2', -1.379, 0.2196),
  ('unknown', 8, 'aspect', 1.698, 0.1801),
  ('unknown', 8, 'behind', 0.2599, 0.282),
  ('unknown', 8, 'edge_free', 0.9321, 0.08616),
  ('unknown', 8, 'edge_free_top', 0.5773, 0.127),
  ('unknown', 8, 'edge_joined', 0.06546, 0.08513),
  ('unknown', 8, 'height', 2.557, 0.3028),
  ('unknown', 8, 'length', 0.2354, 0.1729),
  ('unknown', 8, 'rectangularity', 0.8607, 0.04515),
  ('unknown', 8, 'spread_length', 0.1836, 0.1916),
  ('unknown', 8, 'spread_width', -1.535, 0.063),
  ('unknown', 8, 'tilt_deg', 2.106, 2.533),
  ('unknown', 8, 'width', -1.463, 0.09699),
  ('unknown', 8, 'z_max', 2.562, 0.3054),
  ('unknown', 8, 'z_min', 2.55, 0.3032);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.03319, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'area_m2', -3.253, 0.2642),
  ('unknown', 9, 'aspect', 0.4617, 0.2624),
  ('unknown', 9, 'behind', 0.3947, 0.2802),
  ('unknown', 9, 'edge_free', 0.4134, 0.2697),
  ('unknown', 9, 'edge_free_top', 0.4846, 0.383),
  ('unknown', 9, 'edge_joined', 0.3191, 0.2982),
  ('unknown', 9, 'height', 0.6948, 0.194),
  ('unknown', 9, 'length', -1.215, 0.1772),
  ('unknown', 9, 'rectangularity', 0.7072, 0.1166),
  ('unknown', 9, 'spread_length', -1.335, 0.1814),
  ('unknown', 9, 'spread_width', -1.861, 0.1731),
  ('unknown', 9, 'tilt_deg', 87.27, 3.313),
  ('unknown', 9, 'width', -1.677, 0.1939),
  ('unknown', 9, 'z_max', 0.8222, 0.2041),
  ('unknown', 9, 'z_min', 0.555, 0.1944);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.03052, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'area_m2', -2.506, 0.3589),
  ('unknown', 10, 'aspect', 0.4121, 0.2289),
  ('unknown', 10, 'behind', 0.5001, 0.2716),
  ('unknown', 10, 'edge_free', 0.5152, 0.2717),
  ('unknown', 10, 'edge_free_top', 0.5887, 0.3526),
  ('unknown', 10, 'edge_joined', 0.2248, 0.261),
  ('unknown', 10, 'height', 0.6494, 0.1463),
  ('unknown', 10, 'length', -0.8062, 0.1892),
  ('unknown', 10, 'rectangularity', 0.6381, 0.1351),
  ('unknown', 10, 'spread_length', -0.986, 0.222),
  ('unknown', 10, 'spread_width', -1.458, 0.2258),
  ('unknown', 10, 'tilt_deg', 78.26, 15.24),
  ('unknown', 10, 'width', -1.218, 0.1915),
  ('unknown', 10, 'z_max', 0.8109, 0.1552),
  ('unknown', 10, 'z_min', 0.4643, 0.1559);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.02818, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'area_m2', -0.5098, 0.321),
  ('unknown', 11, 'aspect', 0.4322, 0.2173),
  ('unknown', 11, 'behind', 0.4758, 0.1461),
  ('unknown', 11, 'edge_free', 0.8692, 0.1318),
  ('unknown', 11, 'edge_free_top', 0.994, 0.02543),
  ('unknown', 11, 'edge_joined', 0.02279, 0.03421),
  ('unknown', 11, 'height', 0.484, 0.06365),
  ('unknown', 11, 'length', 0.06612, 0.2221),
  ('unknown', 11, 'rectangularity', 0.8243, 0.1329),
  ('unknown', 11, 'spread_length', -0.001095, 0.2364),
  ('unknown', 11, 'spread_width', -0.4982, 0.1554),
  ('unknown', 11, 'tilt_deg', 89.42, 2.378),
  ('unknown', 11, 'width', -0.3661, 0.1119),
  ('unknown', 11, 'z_max', 0.7906, 0.07951),
  ('unknown', 11, 'z_min', 0.07812, 0.0735);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.02751, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'area_m2', -2.941, 0.3825),
  ('unknown', 12, 'aspect', 0.42, 0.2831),
  ('unknown', 12, 'behind', 0.4116, 0.2733),
  ('unknown', 12, 'edge_free', 0.7497, 0.1571),
  ('unknown', 12, 'edge_free_top', 0.9937, 0.02794),
  ('unknown', 12, 'edge_joined', 0.02088, 0.03366),
  ('unknown', 12, 'height', 1.409, 0.3084),
  ('unknown', 12, 'length', -1.111, 0.2665),
  ('unknown', 12, 'rectangularity', 0.7504, 0.1113),
  ('unknown', 12, 'spread_length', -1.307, 0.2452),
  ('unknown', 12, 'spread_width', -1.705, 0.2007),
  ('unknown', 12, 'tilt_deg', 87.94, 3.397),
  ('unknown', 12, 'width', -1.531, 0.2508),
  ('unknown', 12, 'z_max', 1.533, 0.3208),
  ('unknown', 12, 'z_min', 1.252, 0.3039);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.02675, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'area_m2', -2.074, 0.441),
  ('unknown', 13, 'aspect', 0.9883, 0.2549),
  ('unknown', 13, 'behind', 0.5442, 0.2455),
  ('unknown', 13, 'edge_free', 0.5347, 0.2555),
  ('unknown', 13, 'edge_free_top', 0.6027, 0.3719),
  ('unknown', 13, 'edge_joined', 0.05667, 0.07407),
  ('unknown', 13, 'height', 0.5511, 0.2279),
  ('unknown', 13, 'length', -0.2485, 0.245),
  ('unknown', 13, 'rectangularity', 0.5852, 0.1783),
  ('unknown', 13, 'spread_length', -0.3627, 0.277),
  ('unknown', 13, 'spread_width', -1.556, 0.2624),
  ('unknown', 13, 'tilt_deg', 88.27, 2.84),
  ('unknown', 13, 'width', -1.237, 0.2846),
  ('unknown', 13, 'z_max', 0.8133, 0.2404),
  ('unknown', 13, 'z_min', 0.2659, 0.2708);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.02622, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'area_m2', -1.459, 0.3555),
  ('unknown', 14, 'aspect', 0.5333, 0.3086),
  ('unknown', 14, 'behind', 0.3058, 0.2764),
  ('unknown', 14, 'edge_free', 0.4313, 0.2938),
  ('unknown', 14, 'edge_free_top', 0.5389, 0.3341),
  ('unknown', 14, 'edge_joined', 0.3787, 0.295),
  ('unknown', 14, 'height', 1.372, 0.1975),
  ('unknown', 14, 'length', -0.2921, 0.1782),
  ('unknown', 14, 'rectangularity', 0.7219, 0.1169),
  ('unknown', 14, 'spread_length', -0.4556, 0.1913),
  ('unknown', 14, 'spread_width', -1.061, 0.2866),
  ('unknown', 14, 'tilt_deg', 87.8, 3.193),
  ('unknown', 14, 'width', -0.8254, 0.2709),
  ('unknown', 14, 'z_max', 1.714, 0.2211),
  ('unknown', 14, 'z_min', 1.031, 0.2318);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.02543, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'area_m2', -1.695, 0.289),
  ('unknown', 15, 'aspect', 0.3581, 0.222),
  ('unknown', 15, 'behind', 0.5183, 0.2669),
  ('unknown', 15, 'edge_free', 0.5987, 0.1913),
  ('unknown', 15, 'edge_free_top', 0.8288, 0.2024),
  ('unknown', 15, 'edge_joined', 0.2038, 0.1793),
  ('unknown', 15, 'height', 0.8752, 0.1477),
  ('unknown', 15, 'length', -0.4602, 0.1806),
  ('unknown', 15, 'rectangularity', 0.6723, 0.1209),
  ('unknown', 15, 'spread_length', -0.5922, 0.1945),
  ('unknown', 15, 'spread_width', -1.07, 0.2068),
  ('unknown', 15, 'tilt_deg', 80.2, 11.3),
  ('unknown', 15, 'width', -0.8183, 0.1622),
  ('unknown', 15, 'z_max', 1.11, 0.1688),
  ('unknown', 15, 'z_min', 0.5644, 0.1788);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.02537, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'area_m2', -1.352, 0.5555),
  ('unknown', 16, 'aspect', 0.3787, 0.2792),
  ('unknown', 16, 'behind', 0.004783, 0.01905),
  ('unknown', 16, 'edge_free', 0.03104, 0.04367),
  ('unknown', 16, 'edge_free_top', 0.03106, 0.04818),
  ('unknown', 16, 'edge_joined', 0.8999, 0.1208),
  ('unknown', 16, 'height', 1.628, 0.1304),
  ('unknown', 16, 'length', -0.372, 0.2661),
  ('unknown', 16, 'rectangularity', 0.7984, 0.06663),
  ('unknown', 16, 'spread_length', -0.5068, 0.2811),
  ('unknown', 16, 'spread_width', -0.9647, 0.3542),
  ('unknown', 16, 'tilt_deg', 89.56, 2.302),
  ('unknown', 16, 'width', -0.7508, 0.3304),
  ('unknown', 16, 'z_max', 1.951, 0.1831),
  ('unknown', 16, 'z_min', 1.335, 0.1332);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.02453, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'area_m2', -2.318, 0.367),
  ('unknown', 17, 'aspect', 0.3963, 0.2706),
  ('unknown', 17, 'behind', 0.6092, 0.2201),
  ('unknown', 17, 'edge_free', 0.5912, 0.2449),
  ('unknown', 17, 'edge_free_top', 0.5773, 0.127),
  ('unknown', 17, 'edge_joined', 0.203, 0.1698),
  ('unknown', 17, 'height', 0.3872, 0.1259),
  ('unknown', 17, 'length', -0.8257, 0.2099),
  ('unknown', 17, 'rectangularity', 0.77, 0.09732),
  ('unknown', 17, 'spread_length', -0.9211, 0.1964),
  ('unknown', 17, 'spread_width', -1.382, 0.2471),
  ('unknown', 17, 'tilt_deg', 3.178, 4.121),
  ('unknown', 17, 'width', -1.222, 0.2405),
  ('unknown', 17, 'z_max', 0.3986, 0.1335),
  ('unknown', 17, 'z_min', 0.377, 0.1287);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.02449, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'area_m2', -3.418, 0.3871),
  ('unknown', 18, 'aspect', 0.5168, 0.3103),
  ('unknown', 18, 'behind', 0.07847, 0.1445),
  ('unknown', 18, 'edge_free', 0.1651, 0.1802),
  ('unknown', 18, 'edge_free_top', 0.08658, 0.1231),
  ('unknown', 18, 'edge_joined', 0.7324, 0.2232),
  ('unknown', 18, 'height', 1.477, 0.2866),
  ('unknown', 18, 'length', -1.293, 0.2656),
  ('unknown', 18, 'rectangularity', 0.7335, 0.07461),
  ('unknown', 18, 'spread_length', -1.399, 0.2787),
  ('unknown', 18, 'spread_width', -1.948, 0.1756),
  ('unknown', 18, 'tilt_deg', 87.17, 3.675),
  ('unknown', 18, 'width', -1.81, 0.2304),
  ('unknown', 18, 'z_max', 1.606, 0.2871),
  ('unknown', 18, 'z_min', 1.35, 0.2953);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.02409, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'area_m2', -1.822, 0.2906),
  ('unknown', 19, 'aspect', 0.3062, 0.2077),
  ('unknown', 19, 'behind', 0.6729, 0.1236),
  ('unknown', 19, 'edge_free', 0.5964, 0.1004),
  ('unknown', 19, 'edge_free_top', 0.8858, 0.142),
  ('unknown', 19, 'edge_joined', 0.1173, 0.124),
  ('unknown', 19, 'height', 0.3022, 0.118),
  ('unknown', 19, 'length', -0.4896, 0.159),
  ('unknown', 19, 'rectangularity', 0.6113, 0.1701),
  ('unknown', 19, 'spread_length', -0.6449, 0.1963),
  ('unknown', 19, 'spread_width', -1.115, 0.2278),
  ('unknown', 19, 'tilt_deg', 88.81, 2.654),
  ('unknown', 19, 'width', -0.7958, 0.1783),
  ('unknown', 19, 'z_max', 0.5639, 0.1478),
  ('unknown', 19, 'z_min', 0.02446, 0.0861);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.02401, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'area_m2', -2.756, 0.386),
  ('unknown', 20, 'aspect', 0.2892, 0.1875),
  ('unknown', 20, 'behind', 0.3036, 0.2279),
  ('unknown', 20, 'edge_free', 0.7007, 0.1522),
  ('unknown', 20, 'edge_free_top', 0.5773, 0.127),
  ('unknown', 20, 'edge_joined', 0.2398, 0.1279),
  ('unknown', 20, 'height', 0.8566, 0.1033),
  ('unknown', 20, 'length', -1.139, 0.1975),
  ('unknown', 20, 'rectangularity', 0.8321, 0.07958),
  ('unknown', 20, 'spread_length', -1.21, 0.1813),
  ('unknown', 20, 'spread_width', -1.535, 0.2199),
  ('unknown', 20, 'tilt_deg', 4.843, 6.214),
  ('unknown', 20, 'width', -1.428, 0.2355),
  ('unknown', 20, 'z_max', 0.8702, 0.1097),
  ('unknown', 20, 'z_min', 0.8448, 0.1098);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.02285, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'area_m2', -1.762, 0.2948),
  ('unknown', 21, 'aspect', 0.7245, 0.2992),
  ('unknown', 21, 'behind', 0.6634, 0.1821),
  ('unknown', 21, 'edge_free', 0.3512, 0.1998),
  ('unknown', 21, 'edge_free_top', 0.3348, 0.1964),
  ('unknown', 21, 'edge_joined', 0.4632, 0.2127),
  ('unknown', 21, 'height', 0.8133, 0.2284),
  ('unknown', 21, 'length', -0.2779, 0.1808),
  ('unknown', 21, 'rectangularity', 0.6332, 0.1281),
  ('unknown', 21, 'spread_length', -0.3758, 0.2107),
  ('unknown', 21, 'spread_width', -1.189, 0.2513),
  ('unknown', 21, 'tilt_deg', 8.774, 8.675),
  ('unknown', 21, 'width', -1.002, 0.2346),
  ('unknown', 21, 'z_max', 0.8498, 0.2298),
  ('unknown', 21, 'z_min', 0.7741, 0.2436);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.02242, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'area_m2', -1.354, 0.2843),
  ('unknown', 22, 'aspect', 1.708, 0.2149),
  ('unknown', 22, 'behind', 0.6265, 0.1386),
  ('unknown', 22, 'edge_free', 0.3574, 0.1878),
  ('unknown', 22, 'edge_free_top', 0.03207, 0.06598),
  ('unknown', 22, 'edge_joined', 0.3087, 0.3121),
  ('unknown', 22, 'height', 1.481, 0.1041),
  ('unknown', 22, 'length', 0.3014, 0.15),
  ('unknown', 22, 'rectangularity', 0.7828, 0.06496),
  ('unknown', 22, 'spread_length', 0.1278, 0.199),
  ('unknown', 22, 'spread_width', -1.545, 0.2359),
  ('unknown', 22, 'tilt_deg', 89.65, 2.43),
  ('unknown', 22, 'width', -1.406, 0.2069),
  ('unknown', 22, 'z_max', 2.197, 0.1738),
  ('unknown', 22, 'z_min', 0.8278, 0.113);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.0219, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'area_m2', -2.83, 0.222),
  ('unknown', 23, 'aspect', 0.2519, 0.1408),
  ('unknown', 23, 'behind', 0.3504, 0.2225),
  ('unknown', 23, 'edge_free', 0.07085, 0.0981),
  ('unknown', 23, 'edge_free_top', 0.5773, 0.127),
  ('unknown', 23, 'edge_joined', 0.8256, 0.1566),
  ('unknown', 23, 'height', 0.7722, 0.08994),
  ('unknown', 23, 'length', -1.187, 0.137),
  ('unknown', 23, 'rectangularity', 0.8196, 0.07207),
  ('unknown', 23, 'spread_length', -1.287, 0.1343),
  ('unknown', 23, 'spread_width', -1.58, 0.1142),
  ('unknown', 23, 'tilt_deg', 1.964, 2.879),
  ('unknown', 23, 'width', -1.439, 0.1392),
  ('unknown', 23, 'z_max', 0.7783, 0.1016),
  ('unknown', 23, 'z_min', 0.7664, 0.09224);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.02184, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'area_m2', -2.868, 0.3346),
  ('unknown', 24, 'aspect', 0.5028, 0.2949),
  ('unknown', 24, 'behind', 0.4269, 0.2789),
  ('unknown', 24, 'edge_free', 0.6287, 0.2185),
  ('unknown', 24, 'edge_free_top', 0.7747, 0.2441),
  ('unknown', 24, 'edge_joined', 0.1364, 0.1228),
  ('unknown', 24, 'height', 1.157, 0.1432),
  ('unknown', 24, 'length', -0.9747, 0.2212),
  ('unknown', 24, 'rectangularity', 0.6711, 0.1142),
  ('unknown', 24, 'spread_length', -1.117, 0.2317),
  ('unknown', 24, 'spread_width', -1.695, 0.2522),
  ('unknown', 24, 'tilt_deg', 61.96, 24.72),
  ('unknown', 24, 'width', -1.477, 0.2485),
  ('unknown', 24, 'z_max', 1.282, 0.1521),
  ('unknown', 24, 'z_min', 1.024, 0.1606);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.02117, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'area_m2', -0.9908, 0.6687),
  ('unknown', 25, 'aspect', 0.9442, 0.4923),
  ('unknown', 25, 'behind', 0.6724, 0.1664),
  ('unknown', 25, 'edge_free', 0.1625, 0.145),
  ('unknown', 25, 'edge_free_top', 0.5773, 0.127),
  ('unknown', 25, 'edge_joined', 0.7407, 0.2106),
  ('unknown', 25, 'height', 1.042, 0.2395),
  ('unknown', 25, 'length', 0.1512, 0.297),
  ('unknown', 25, 'rectangularity', 0.7175, 0.1194),
  ('unknown', 25, 'spread_length', 0.03238, 0.2771),
  ('unknown', 25, 'spread_width', -0.8737, 0.506),
  ('unknown', 25, 'tilt_deg', 3.894, 4.271),
  ('unknown', 25, 'width', -0.793, 0.509),
  ('unknown', 25, 'z_max', 1.062, 0.2418),
  ('unknown', 25, 'z_min', 1.026, 0.2419);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.02056, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'area_m2', -1.08, 0.4279),
  ('unknown', 26, 'aspect', 1.307, 0.4773),
  ('unknown', 26, 'behind', 0.4891, 0.2537),
  ('unknown', 26, 'edge_free', 0.3879, 0.231),
  ('unknown', 26, 'edge_free_top', 0.3525, 0.3038),
  ('unknown', 26, 'edge_joined', 0.3922, 0.2672),
  ('unknown', 26, 'height', 0.9184, 0.3611),
  ('unknown', 26, 'length', 0.3572, 0.2774),
  ('unknown', 26, 'rectangularity', 0.6306, 0.1333),
  ('unknown', 26, 'spread_length', 0.2686, 0.2908),
  ('unknown', 26, 'spread_width', -1.198, 0.3873),
  ('unknown', 26, 'tilt_deg', 78.84, 18),
  ('unknown', 26, 'width', -0.9497, 0.3185),
  ('unknown', 26, 'z_max', 1.408, 0.5704),
  ('unknown', 26, 'z_min', 0.3621, 0.3638);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.01801, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'area_m2', -2.606, 0.4276),
  ('unknown', 27, 'aspect', 0.7458, 0.3267),
  ('unknown', 27, 'behind', 0.5194, 0.2724),
  ('unknown', 27, 'edge_free', 0.6796, 0.3097),
  ('unknown', 27, 'edge_free_top', 0.7573, 0.2516),
  ('unknown', 27, 'edge_joined', 0.1785, 0.2236),
  ('unknown', 27, 'height', 2.144, 0.3216),
  ('unknown', 27, 'length', -0.732, 0.2693),
  ('unknown', 27, 'rectangularity', 0.6909, 0.1468),
  ('unknown', 27, 'spread_length', -0.8676, 0.3001),
  ('unknown', 27, 'spread_width', -1.627, 0.2264),
  ('unknown', 27, 'tilt_deg', 32.56, 36.79),
  ('unknown', 27, 'width', -1.478, 0.2544),
  ('unknown', 27, 'z_max', 2.215, 0.315),
  ('unknown', 27, 'z_min', 2.068, 0.366);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.01727, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'area_m2', -2.728, 0.3835),
  ('unknown', 28, 'aspect', 1.308, 0.3346),
  ('unknown', 28, 'behind', 0.4152, 0.299),
  ('unknown', 28, 'edge_free', 0.2866, 0.2344),
  ('unknown', 28, 'edge_free_top', 0.2664, 0.3197),
  ('unknown', 28, 'edge_joined', 0.4054, 0.3207),
  ('unknown', 28, 'height', 0.4669, 0.3365),
  ('unknown', 28, 'length', -0.4956, 0.2839),
  ('unknown', 28, 'rectangularity', 0.6678, 0.134),
  ('unknown', 28, 'spread_length', -0.5885, 0.3057),
  ('unknown', 28, 'spread_width', -2.041, 0.136),
  ('unknown', 28, 'tilt_deg', 63.9, 31.7),
  ('unknown', 28, 'width', -1.804, 0.2109),
  ('unknown', 28, 'z_max', 0.6306, 0.3499),
  ('unknown', 28, 'z_min', 0.2959, 0.3725);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.01628, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'area_m2', -0.4335, 0.2502),
  ('unknown', 29, 'aspect', 0.3229, 0.2009),
  ('unknown', 29, 'behind', 0.4489, 0.1892),
  ('unknown', 29, 'edge_free', 0.5999, 0.1566),
  ('unknown', 29, 'edge_free_top', 0.8374, 0.1505),
  ('unknown', 29, 'edge_joined', 0.1708, 0.1411),
  ('unknown', 29, 'height', 0.5087, 0.1093),
  ('unknown', 29, 'length', 0.09795, 0.1538),
  ('unknown', 29, 'rectangularity', 0.7421, 0.08994),
  ('unknown', 29, 'spread_length', -0.0362, 0.1728),
  ('unknown', 29, 'spread_width', -0.4205, 0.1772),
  ('unknown', 29, 'tilt_deg', 87.38, 4.813),
  ('unknown', 29, 'width', -0.2249, 0.1751),
  ('unknown', 29, 'z_max', 0.9367, 0.1987),
  ('unknown', 29, 'z_min', 0.0249, 0.0777);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.01564, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'area_m2', -1.522, 0.3775),
  ('unknown', 30, 'aspect', 1.647, 0.2648),
  ('unknown', 30, 'behind', 0.6579, 0.1107),
  ('unknown', 30, 'edge_free', 0.3163, 0.2634),
  ('unknown', 30, 'edge_free_top', 0.5757, 0.1279),
  ('unknown', 30, 'edge_joined', 0.5742, 0.2765),
  ('unknown', 30, 'height', 2.122, 0.1339),
  ('unknown', 30, 'length', 0.2023, 0.2336),
  ('unknown', 30, 'rectangularity', 0.7601, 0.07128),
  ('unknown', 30, 'spread_length', 0.05886, 0.2525),
  ('unknown', 30, 'spread_width', -1.558, 0.2175),
  ('unknown', 30, 'tilt_deg', 4.068, 6.264),
  ('unknown', 30, 'width', -1.444, 0.2112),
  ('unknown', 30, 'z_max', 2.132, 0.1443),
  ('unknown', 30, 'z_min', 2.111, 0.1373);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.01539, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'area_m2', -2.42, 0.3457),
  ('unknown', 31, 'aspect', 1.256, 0.3401),
  ('unknown', 31, 'behind', 0.2784, 0.3336),
  ('unknown', 31, 'edge_free', 0.3132, 0.2582),
  ('unknown', 31, 'edge_free_top', 0.3224, 0.3159),
  ('unknown', 31, 'edge_joined', 0.5548, 0.2703),
  ('unknown', 31, 'height', 1.564, 0.2635),
  ('unknown', 31, 'length', -0.3885, 0.2723),
  ('unknown', 31, 'rectangularity', 0.6879, 0.1012),
  ('unknown', 31, 'spread_length', -0.5244, 0.2822),
  ('unknown', 31, 'spread_width', -1.894, 0.2065),
  ('unknown', 31, 'tilt_deg', 88.14, 3.769),
  ('unknown', 31, 'width', -1.644, 0.2212),
  ('unknown', 31, 'z_max', 1.868, 0.2647),
  ('unknown', 31, 'z_min', 1.281, 0.3281);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.01539, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'area_m2', -0.7709, 0.3331),
  ('unknown', 32, 'aspect', 0.3647, 0.2369),
  ('unknown', 32, 'behind', 0.3899, 0.1579),
  ('unknown', 32, 'edge_free', 0.6242, 0.1942),
  ('unknown', 32, 'edge_free_top', 0.7545, 0.1717),
  ('unknown', 32, 'edge_joined', 0.1356, 0.113),
  ('unknown', 32, 'height', 1.068, 0.2197),
  ('unknown', 32, 'length', 0.01574, 0.2068),
  ('unknown', 32, 'rectangularity', 0.6546, 0.1028),
  ('unknown', 32, 'spread_length', -0.1137, 0.2034),
  ('unknown', 32, 'spread_width', -0.6141, 0.2272),
  ('unknown', 32, 'tilt_deg', 85.33, 5.453),
  ('unknown', 32, 'width', -0.349, 0.1759),
  ('unknown', 32, 'z_max', 1.505, 0.2701),
  ('unknown', 32, 'z_min', 0.5455, 0.2904);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.01504, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'area_m2', -3.786, 0.274),
  ('unknown', 33, 'aspect', 0.3698, 0.1975),
  ('unknown', 33, 'behind', 0.2448, 0.2424),
  ('unknown', 33, 'edge_free', 0.4824, 0.2785),
  ('unknown', 33, 'edge_free_top', 0.6175, 0.3638),
  ('unknown', 33, 'edge_joined', 0.3664, 0.2595),
  ('unknown', 33, 'height', 1.622, 0.5074),
  ('unknown', 33, 'length', -1.565, 0.1875),
  ('unknown', 33, 'rectangularity', 0.757, 0.09116),
  ('unknown', 33, 'spread_length', -1.622, 0.1703),
  ('unknown', 33, 'spread_width', -2.049, 0.1204),
  ('unknown', 33, 'tilt_deg', 62.8, 29.28),
  ('unknown', 33, 'width', -1.935, 0.1429),
  ('unknown', 33, 'z_max', 1.691, 0.4996),
  ('unknown', 33, 'z_min', 1.546, 0.5204);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.01438, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'area_m2', -2.619, 0.3412),
  ('unknown', 34, 'aspect', 0.657, 0.2866),
  ('unknown', 34, 'behind', 0.521, 0.2345),
  ('unknown', 34, 'edge_free', 0.2121, 0.16),
  ('unknown', 34, 'edge_free_top', 0.5773, 0.127),
  ('unknown', 34, 'edge_joined', 0.6082, 0.2483),
  ('unknown', 34, 'height', 0.8336, 0.1546),
  ('unknown', 34, 'length', -0.7752, 0.1479),
  ('unknown', 34, 'rectangularity', 0.6722, 0.1022),
  ('unknown', 34, 'spread_length', -0.8888, 0.1777),
  ('unknown', 34, 'spread_width', -1.61, 0.2786),
  ('unknown', 34, 'tilt_deg', 8.735, 7.429),
  ('unknown', 34, 'width', -1.432, 0.2768),
  ('unknown', 34, 'z_max', 0.86, 0.1647),
  ('unknown', 34, 'z_min', 0.8087, 0.1612);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.01298, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'area_m2', 3.28, 0.8009),
  ('unknown', 35, 'aspect', 0.4092, 0.3993),
  ('unknown', 35, 'behind', 0.01227, 0.0317),
  ('unknown', 35, 'edge_free', 0.009561, 0.02794),
  ('unknown', 35, 'edge_free_top', 0.01217, 0.03689),
  ('unknown', 35, 'edge_joined', 0.05168, 0.0742),
  ('unknown', 35, 'height', 2.253, 0.8623),
  ('unknown', 35, 'length', 1.915, 0.4101),
  ('unknown', 35, 'rectangularity', 0.8732, 0.07876),
  ('unknown', 35, 'spread_length', 1.888, 0.378),
  ('unknown', 35, 'spread_width', 1.435, 0.4431),
  ('unknown', 35, 'tilt_deg', 89.49, 3.167),
  ('unknown', 35, 'width', 1.506, 0.481),
  ('unknown', 35, 'z_max', 5.815, 2.231),
  ('unknown', 35, 'z_min', -0.8917, 1.338);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.01276, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'area_m2', -1.309, 0.6106),
  ('unknown', 36, 'aspect', 1.068, 0.4606),
  ('unknown', 36, 'behind', 0.5429, 0.2389),
  ('unknown', 36, 'edge_free', 0.4361, 0.2889),
  ('unknown', 36, 'edge_free_top', 0.02702, 0.05571),
  ('unknown', 36, 'edge_joined', 0.3915, 0.283),
  ('unknown', 36, 'height', 2.684, 0.5238),
  ('unknown', 36, 'length', 0.1525, 0.4259),
  ('unknown', 36, 'rectangularity', 0.5994, 0.147),
  ('unknown', 36, 'spread_length', 0.1122, 0.4176),
  ('unknown', 36, 'spread_width', -1.124, 0.3499),
  ('unknown', 36, 'tilt_deg', 45.18, 34.61),
  ('unknown', 36, 'width', -0.9155, 0.3201),
  ('unknown', 36, 'z_max', 2.828, 0.5353),
  ('unknown', 36, 'z_min', 2.536, 0.553);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.01171, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'area_m2', -0.01034, 0.5907),
  ('unknown', 37, 'aspect', 0.5443, 0.3161),
  ('unknown', 37, 'behind', 0.3318, 0.2376),
  ('unknown', 37, 'edge_free', 0.4652, 0.2052),
  ('unknown', 37, 'edge_free_top', 0.6203, 0.238),
  ('unknown', 37, 'edge_joined', 0.2515, 0.1943),
  ('unknown', 37, 'height', 1.117, 0.5102),
  ('unknown', 37, 'length', 0.545, 0.3178),
  ('unknown', 37, 'rectangularity', 0.5868, 0.1151),
  ('unknown', 37, 'spread_length', 0.4054, 0.3241),
  ('unknown', 37, 'spread_width', -0.2852, 0.2967),
  ('unknown', 37, 'tilt_deg', 81.91, 16.77),
  ('unknown', 37, 'width', 0.0006435, 0.3141),
  ('unknown', 37, 'z_max', 1.755, 0.6345),
  ('unknown', 37, 'z_min', 0.3479, 0.5406);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.009265, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'area_m2', 1.002, 1.089),
  ('unknown', 38, 'aspect', 1.004, 0.7522),
  ('unknown', 38, 'behind', 0.01917, 0.03968),
  ('unknown', 38, 'edge_free', 0.03184, 0.05385),
  ('unknown', 38, 'edge_free_top', 0.0329, 0.05951),
  ('unknown', 38, 'edge_joined', 0.3559, 0.2799),
  ('unknown', 38, 'height', 1.381, 1.028),
  ('unknown', 38, 'length', 1.224, 0.6523),
  ('unknown', 38, 'rectangularity', 0.6627, 0.1529),
  ('unknown', 38, 'spread_length', 1.099, 0.6442),
  ('unknown', 38, 'spread_width', 0.09542, 0.568),
  ('unknown', 38, 'tilt_deg', 89.03, 3.761),
  ('unknown', 38, 'width', 0.2204, 0.6202),
  ('unknown', 38, 'z_max', 3.464, 2.355),
  ('unknown', 38, 'z_min', -0.5224, 1.4);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.009032, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'area_m2', -0.9634, 0.296),
  ('unknown', 39, 'aspect', 1.165, 0.2434),
  ('unknown', 39, 'behind', 0.4507, 0.2368),
  ('unknown', 39, 'edge_free', 0.5395, 0.1846),
  ('unknown', 39, 'edge_free_top', 0.8949, 0.1599),
  ('unknown', 39, 'edge_joined', 0.02017, 0.03829),
  ('unknown', 39, 'height', 0.9316, 0.09939),
  ('unknown', 39, 'length', 0.2632, 0.2022),
  ('unknown', 39, 'rectangularity', 0.736, 0.1262),
  ('unknown', 39, 'spread_length', 0.09485, 0.2072),
  ('unknown', 39, 'spread_width', -1.053, 0.1877),
  ('unknown', 39, 'tilt_deg', 88.66, 3.898),
  ('unknown', 39, 'width', -0.902, 0.1929),
  ('unknown', 39, 'z_max', 1.121, 0.1296),
  ('unknown', 39, 'z_min', 0.6885, 0.1009);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.007608, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'area_m2', -0.6586, 0.3646),
  ('unknown', 40, 'aspect', 0.4856, 0.2038),
  ('unknown', 40, 'behind', 0.07615, 0.1256),
  ('unknown', 40, 'edge_free', 0.8956, 0.1055),
  ('unknown', 40, 'edge_free_top', 0.9709, 0.07363),
  ('unknown', 40, 'edge_joined', 0.05356, 0.07281),
  ('unknown', 40, 'height', 1.619, 0.1136),
  ('unknown', 40, 'length', 0.02044, 0.2236),
  ('unknown', 40, 'rectangularity', 0.8153, 0.1002),
  ('unknown', 40, 'spread_length', -0.06457, 0.2241),
  ('unknown', 40, 'spread_width', -0.6212, 0.163),
  ('unknown', 40, 'tilt_deg', 88.55, 4.272),
  ('unknown', 40, 'width', -0.4651, 0.147),
  ('unknown', 40, 'z_max', 1.979, 0.1457),
  ('unknown', 40, 'z_min', 1.308, 0.1313);

-- floor: 187 examples
UPDATE object_class SET prior = 0.02713 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.42, 1.391)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4428, 0.3282)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_joined', 0.2256, 0.1302)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.002561, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.213, 0.6614)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5842, 0.1207)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.9358, 0.5816)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.3972, 0.7257)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.714, 1.012)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.7666, 0.7907)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.01318, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.008836, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'floor';
DELETE FROM class_density WHERE class = 'floor';
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.2431, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'area_m2', 2.63, 0.277),
  ('floor', 1, 'aspect', 0.3635, 0.2394),
  ('floor', 1, 'behind', 0, 0.005),
  ('floor', 1, 'edge_free', 0, 0.005),
  ('floor', 1, 'edge_free_top', 0, 0.3162),
  ('floor', 1, 'edge_joined', 0.2904, 0.113),
  ('floor', 1, 'height', 2.014e-06, 0.0225),
  ('floor', 1, 'length', 1.809, 0.1828),
  ('floor', 1, 'rectangularity', 0.5488, 0.1153),
  ('floor', 1, 'spread_length', 1.419, 0.1353),
  ('floor', 1, 'spread_width', 0.9811, 0.1546),
  ('floor', 1, 'tilt_deg', 0.02017, 0.45),
  ('floor', 1, 'width', 1.446, 0.1703),
  ('floor', 1, 'z_max', 0.0004417, 0.0225),
  ('floor', 1, 'z_min', -0.0005113, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.1367, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'area_m2', 2.274, 0.2291),
  ('floor', 2, 'aspect', 0.124, 0.08283),
  ('floor', 2, 'behind', 0, 0.005),
  ('floor', 2, 'edge_free', 0, 0.005),
  ('floor', 2, 'edge_free_top', 0, 0.3162),
  ('floor', 2, 'edge_joined', 0.3276, 0.09288),
  ('floor', 2, 'height', 4.559e-07, 0.0225),
  ('floor', 2, 'length', 1.425, 0.1099),
  ('floor', 2, 'rectangularity', 0.6487, 0.1149),
  ('floor', 2, 'spread_length', 1.185, 0.1119),
  ('floor', 2, 'spread_width', 0.8795, 0.1208),
  ('floor', 2, 'tilt_deg', 0.03046, 0.45),
  ('floor', 2, 'width', 1.301, 0.1301),
  ('floor', 2, 'z_max', 0.000552, 0.0225),
  ('floor', 2, 'z_min', -0.0005969, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.123, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'area_m2', 0.01719, 0.3433),
  ('floor', 3, 'aspect', 0.6381, 0.3471),
  ('floor', 3, 'behind', 0, 0.005),
  ('floor', 3, 'edge_free', 0, 0.005),
  ('floor', 3, 'edge_free_top', 0, 0.3162),
  ('floor', 3, 'edge_joined', 0.164, 0.1304),
  ('floor', 3, 'height', 0.005698, 0.0225),
  ('floor', 3, 'length', 0.5856, 0.2312),
  ('floor', 3, 'rectangularity', 0.6094, 0.1107),
  ('floor', 3, 'spread_length', 0.4205, 0.2007),
  ('floor', 3, 'spread_width', -0.3472, 0.2279),
  ('floor', 3, 'tilt_deg', 1.631, 0.7636),
  ('floor', 3, 'width', -0.05251, 0.2305),
  ('floor', 3, 'z_max', 0.02643, 0.0225),
  ('floor', 3, 'z_min', -0.01257, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.1058, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'area_m2', 1.837, 0.2482),
  ('floor', 4, 'aspect', 0.3533, 0.1342),
  ('floor', 4, 'behind', 0, 0.005),
  ('floor', 4, 'edge_free', 0, 0.005),
  ('floor', 4, 'edge_free_top', 0, 0.3162),
  ('floor', 4, 'edge_joined', 0.2272, 0.07026),
  ('floor', 4, 'height', -9.633e-05, 0.0225),
  ('floor', 4, 'length', 1.377, 0.1285),
  ('floor', 4, 'rectangularity', 0.5791, 0.09998),
  ('floor', 4, 'spread_length', 1.101, 0.1218),
  ('floor', 4, 'spread_width', 0.6603, 0.1355),
  ('floor', 4, 'tilt_deg', 0.1507, 0.45),
  ('floor', 4, 'width', 1.024, 0.1672),
  ('floor', 4, 'z_max', 0.003025, 0.0225),
  ('floor', 4, 'z_min', -0.004137, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.1045, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'area_m2', -1.233, 0.6394),
  ('floor', 5, 'aspect', 0.6527, 0.3892),
  ('floor', 5, 'behind', 0, 0.005),
  ('floor', 5, 'edge_free', 0, 0.005),
  ('floor', 5, 'edge_free_top', 0, 0.3162),
  ('floor', 5, 'edge_joined', 0.0914, 0.08145),
  ('floor', 5, 'height', 0.01045, 0.0225),
  ('floor', 5, 'length', -0.03091, 0.3122),
  ('floor', 5, 'rectangularity', 0.6117, 0.1281),
  ('floor', 5, 'spread_length', -0.2135, 0.3283),
  ('floor', 5, 'spread_width', -0.951, 0.4046),
  ('floor', 5, 'tilt_deg', 1.886, 1.061),
  ('floor', 5, 'width', -0.6836, 0.4084),
  ('floor', 5, 'z_max', 0.02345, 0.0225),
  ('floor', 5, 'z_min', -0.001889, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.08059, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'area_m2', 1.683, 0.3094),
  ('floor', 6, 'aspect', 0.39, 0.2058),
  ('floor', 6, 'behind', 0, 0.005),
  ('floor', 6, 'edge_free', 0, 0.005),
  ('floor', 6, 'edge_free_top', 0, 0.3162),
  ('floor', 6, 'edge_joined', 0.1888, 0.08588),
  ('floor', 6, 'height', 0.001172, 0.0225),
  ('floor', 6, 'length', 1.317, 0.1739),
  ('floor', 6, 'rectangularity', 0.5803, 0.09175),
  ('floor', 6, 'spread_length', 1.028, 0.1351),
  ('floor', 6, 'spread_width', 0.6447, 0.1737),
  ('floor', 6, 'tilt_deg', 1.659, 0.45),
  ('floor', 6, 'width', 0.9266, 0.201),
  ('floor', 6, 'z_max', 0.04599, 0.0225),
  ('floor', 6, 'z_min', -0.05341, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.07662, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'area_m2', 1.964, 0.305),
  ('floor', 7, 'aspect', 0.7469, 0.1288),
  ('floor', 7, 'behind', 0, 0.005),
  ('floor', 7, 'edge_free', 0, 0.005),
  ('floor', 7, 'edge_free_top', 0, 0.3162),
  ('floor', 7, 'edge_joined', 0.2255, 0.08267),
  ('floor', 7, 'height', -3.649e-05, 0.0225),
  ('floor', 7, 'length', 1.684, 0.1793),
  ('floor', 7, 'rectangularity', 0.5242, 0.06918),
  ('floor', 7, 'spread_length', 1.319, 0.1362),
  ('floor', 7, 'spread_width', 0.5538, 0.1775),
  ('floor', 7, 'tilt_deg', 0.0555, 0.45),
  ('floor', 7, 'width', 0.9371, 0.1728),
  ('floor', 7, 'z_max', 0.0009017, 0.0225),
  ('floor', 7, 'z_min', -0.001058, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.06057, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'area_m2', 0.8301, 0.36),
  ('floor', 8, 'aspect', 0.4892, 0.2629),
  ('floor', 8, 'behind', 0, 0.005),
  ('floor', 8, 'edge_free', 0, 0.005),
  ('floor', 8, 'edge_free_top', 0, 0.3162),
  ('floor', 8, 'edge_joined', 0.1517, 0.06474),
  ('floor', 8, 'height', 0.0002902, 0.0225),
  ('floor', 8, 'length', 0.9647, 0.2118),
  ('floor', 8, 'rectangularity', 0.5508, 0.07975),
  ('floor', 8, 'spread_length', 0.7632, 0.212),
  ('floor', 8, 'spread_width', 0.1629, 0.2222),
  ('floor', 8, 'tilt_deg', 1.165, 0.5005),
  ('floor', 8, 'width', 0.4755, 0.2044),
  ('floor', 8, 'z_max', 0.02174, 0.0225),
  ('floor', 8, 'z_min', -0.02318, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.01919, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'area_m2', -0.3371, 1.065),
  ('floor', 9, 'aspect', 0.7661, 0.2536),
  ('floor', 9, 'behind', 0, 0.005),
  ('floor', 9, 'edge_free', 0, 0.005),
  ('floor', 9, 'edge_free_top', 0, 0.3162),
  ('floor', 9, 'edge_joined', 0.1938, 0.09994),
  ('floor', 9, 'height', -0.13, 0.2431),
  ('floor', 9, 'length', 0.4328, 0.6475),
  ('floor', 9, 'rectangularity', 0.6564, 0.0723),
  ('floor', 9, 'spread_length', 0.2832, 0.5396),
  ('floor', 9, 'spread_width', -0.6488, 0.5583),
  ('floor', 9, 'tilt_deg', 2.732, 0.623),
  ('floor', 9, 'width', -0.3333, 0.5331),
  ('floor', 9, 'z_max', -0.09431, 0.2586),
  ('floor', 9, 'z_min', -0.1596, 0.2324);

-- ceiling: 130 examples
UPDATE object_class SET prior = 0.01889 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.99, 1.148)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4099, 0.359)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.03235, 0.1031)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.03128, 0.1032)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_joined', 0.4525, 0.2102)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.871, 0.377)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.387, 0.4991)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6988, 0.1312)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.261, 0.481)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.6936, 0.6558)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.02741, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.9759, 0.723)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.871, 0.377)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.871, 0.377)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'ceiling';
DELETE FROM class_density WHERE class = 'ceiling';
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.23, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'area_m2', 2.825, 0.2749),
  ('ceiling', 1, 'aspect', 0.2798, 0.1487),
  ('ceiling', 1, 'behind', 0.001027, 0.01179),
  ('ceiling', 1, 'edge_free', 0.0009424, 0.01091),
  ('ceiling', 1, 'edge_free_top', 0, 0.3162),
  ('ceiling', 1, 'edge_joined', 0.6058, 0.1567),
  ('ceiling', 1, 'height', 2.632, 0.1608),
  ('ceiling', 1, 'length', 1.722, 0.1193),
  ('ceiling', 1, 'rectangularity', 0.7206, 0.1072),
  ('ceiling', 1, 'spread_length', 1.563, 0.1174),
  ('ceiling', 1, 'spread_width', 1.136, 0.138),
  ('ceiling', 1, 'tilt_deg', 0.005186, 0.45),
  ('ceiling', 1, 'width', 1.443, 0.1368),
  ('ceiling', 1, 'z_max', 2.632, 0.1608),
  ('ceiling', 1, 'z_min', 2.632, 0.1608);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1535, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'area_m2', 2.242, 0.2327),
  ('ceiling', 2, 'aspect', 0.2439, 0.187),
  ('ceiling', 2, 'behind', 0.001539, 0.01417),
  ('ceiling', 2, 'edge_free', 0.001412, 0.01311),
  ('ceiling', 2, 'edge_free_top', 0, 0.3162),
  ('ceiling', 2, 'edge_joined', 0.621, 0.1204),
  ('ceiling', 2, 'height', 2.575, 0.1007),
  ('ceiling', 2, 'length', 1.442, 0.1019),
  ('ceiling', 2, 'rectangularity', 0.6802, 0.1028),
  ('ceiling', 2, 'spread_length', 1.332, 0.1056),
  ('ceiling', 2, 'spread_width', 0.8931, 0.169),
  ('ceiling', 2, 'tilt_deg', 0.006195, 0.45),
  ('ceiling', 2, 'width', 1.198, 0.1904),
  ('ceiling', 2, 'z_max', 2.575, 0.1007),
  ('ceiling', 2, 'z_min', 2.574, 0.1007);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'area_m2', 2.532, 0.2821),
  ('ceiling', 3, 'aspect', 0.3054, 0.2025),
  ('ceiling', 3, 'behind', 0.001629, 0.01454),
  ('ceiling', 3, 'edge_free', 0.001495, 0.01344),
  ('ceiling', 3, 'edge_free_top', 0, 0.3162),
  ('ceiling', 3, 'edge_joined', 0.4548, 0.1268),
  ('ceiling', 3, 'height', 3.038, 0.07984),
  ('ceiling', 3, 'length', 1.635, 0.1411),
  ('ceiling', 3, 'rectangularity', 0.6623, 0.1259),
  ('ceiling', 3, 'spread_length', 1.491, 0.1156),
  ('ceiling', 3, 'spread_width', 1.009, 0.1759),
  ('ceiling', 3, 'tilt_deg', 0.005076, 0.45),
  ('ceiling', 3, 'width', 1.33, 0.1767),
  ('ceiling', 3, 'z_max', 3.038, 0.07987),
  ('ceiling', 3, 'z_min', 3.038, 0.07984);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.1018, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'area_m2', 2.328, 0.3786),
  ('ceiling', 4, 'aspect', 0.4311, 0.2519),
  ('ceiling', 4, 'behind', 0.00232, 0.01694),
  ('ceiling', 4, 'edge_free', 0.002129, 0.01567),
  ('ceiling', 4, 'edge_free_top', 0, 0.3162),
  ('ceiling', 4, 'edge_joined', 0.2519, 0.1015),
  ('ceiling', 4, 'height', 3.448, 0.219),
  ('ceiling', 4, 'length', 1.604, 0.1457),
  ('ceiling', 4, 'rectangularity', 0.6532, 0.1226),
  ('ceiling', 4, 'spread_length', 1.475, 0.1379),
  ('ceiling', 4, 'spread_width', 0.8693, 0.2154),
  ('ceiling', 4, 'tilt_deg', 0.01215, 0.45),
  ('ceiling', 4, 'width', 1.173, 0.284),
  ('ceiling', 4, 'z_max', 3.448, 0.2191),
  ('ceiling', 4, 'z_min', 3.447, 0.2189);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.08949, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'area_m2', 0.6254, 0.4692),
  ('ceiling', 5, 'aspect', 0.7934, 0.4492),
  ('ceiling', 5, 'behind', 0.3458, 0.09455),
  ('ceiling', 5, 'edge_free', 0.3173, 0.0943),
  ('ceiling', 5, 'edge_free_top', 0, 0.3162),
  ('ceiling', 5, 'edge_joined', 0.3433, 0.1469),
  ('ceiling', 5, 'height', 3.01, 0.3257),
  ('ceiling', 5, 'length', 0.8517, 0.3288),
  ('ceiling', 5, 'rectangularity', 0.7654, 0.1157),
  ('ceiling', 5, 'spread_length', 0.7433, 0.3072),
  ('ceiling', 5, 'spread_width', -0.1291, 0.2895),
  ('ceiling', 5, 'tilt_deg', 0.06081, 0.45),
  ('ceiling', 5, 'width', 0.05833, 0.3009),
  ('ceiling', 5, 'z_max', 3.011, 0.3259),
  ('ceiling', 5, 'z_min', 3.01, 0.3255);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.08534, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'area_m2', 2.155, 0.2857),
  ('ceiling', 6, 'aspect', 0.3735, 0.2147),
  ('ceiling', 6, 'behind', 0.002768, 0.01823),
  ('ceiling', 6, 'edge_free', 0.00254, 0.01686),
  ('ceiling', 6, 'edge_free_top', 0, 0.3162),
  ('ceiling', 6, 'edge_joined', 0.4238, 0.1051),
  ('ceiling', 6, 'height', 2.825, 0.08464),
  ('ceiling', 6, 'length', 1.516, 0.1383),
  ('ceiling', 6, 'rectangularity', 0.6129, 0.08654),
  ('ceiling', 6, 'spread_length', 1.405, 0.1186),
  ('ceiling', 6, 'spread_width', 0.7717, 0.1706),
  ('ceiling', 6, 'tilt_deg', 0.01045, 0.45),
  ('ceiling', 6, 'width', 1.142, 0.2026),
  ('ceiling', 6, 'z_max', 2.825, 0.08461),
  ('ceiling', 6, 'z_min', 2.825, 0.08464);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.07572, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'area_m2', -0.9331, 0.7063),
  ('ceiling', 7, 'aspect', 1.021, 0.398),
  ('ceiling', 7, 'behind', 0.00312, 0.01914),
  ('ceiling', 7, 'edge_free', 0.002863, 0.0177),
  ('ceiling', 7, 'edge_free_top', 0, 0.3162),
  ('ceiling', 7, 'edge_joined', 0.2798, 0.1202),
  ('ceiling', 7, 'height', 2.556, 0.09366),
  ('ceiling', 7, 'length', 0.2045, 0.368),
  ('ceiling', 7, 'rectangularity', 0.7333, 0.08707),
  ('ceiling', 7, 'spread_length', 0.09877, 0.3435),
  ('ceiling', 7, 'spread_width', -0.9427, 0.4162),
  ('ceiling', 7, 'tilt_deg', 0.2228, 0.45),
  ('ceiling', 7, 'width', -0.8164, 0.4607),
  ('ceiling', 7, 'z_max', 2.557, 0.09381),
  ('ceiling', 7, 'z_min', 2.555, 0.09356);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.06906, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'area_m2', 1.649, 0.2928),
  ('ceiling', 8, 'aspect', 0.3377, 0.2219),
  ('ceiling', 8, 'behind', 0.003421, 0.01986),
  ('ceiling', 8, 'edge_free', 0.003139, 0.01836),
  ('ceiling', 8, 'edge_free_top', 0, 0.3162),
  ('ceiling', 8, 'edge_joined', 0.2242, 0.08865),
  ('ceiling', 8, 'height', 3.342, 0.2836),
  ('ceiling', 8, 'length', 1.119, 0.1106),
  ('ceiling', 8, 'rectangularity', 0.7916, 0.1158),
  ('ceiling', 8, 'spread_length', 1.069, 0.1122),
  ('ceiling', 8, 'spread_width', 0.5605, 0.1896),
  ('ceiling', 8, 'tilt_deg', 0.02606, 0.45),
  ('ceiling', 8, 'width', 0.7815, 0.2315),
  ('ceiling', 8, 'z_max', 3.343, 0.2837),
  ('ceiling', 8, 'z_min', 3.342, 0.2834);

-- wall: 704 examples
UPDATE object_class SET prior = 0.1022 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 1.102, 1.038)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.5848, 0.4272)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.1045, 0.1954)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.1087, 0.1938)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.0622, 0.1677)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_joined', 0.1544, 0.2058)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.411, 0.3543)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 1.052, 0.4543)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.677, 0.1451)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.8839, 0.4653)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', 0.2172, 0.6587)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.53, 1.237)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.465, 0.6669)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.546, 0.6578)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.164, 0.3599)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'wall';
DELETE FROM class_density WHERE class = 'wall';
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.2535, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'area_m2', 2.119, 0.3394),
  ('wall', 1, 'aspect', 0.3894, 0.2228),
  ('wall', 1, 'behind', 0.0009217, 0.009346),
  ('wall', 1, 'edge_free', 0.0009438, 0.009338),
  ('wall', 1, 'edge_free_top', 0.0004097, 0.00789),
  ('wall', 1, 'edge_joined', 0.08666, 0.09036),
  ('wall', 1, 'height', 1.547, 0.1873),
  ('wall', 1, 'length', 1.44, 0.2179),
  ('wall', 1, 'rectangularity', 0.7015, 0.1236),
  ('wall', 1, 'spread_length', 1.275, 0.2124),
  ('wall', 1, 'spread_width', 0.7755, 0.1888),
  ('wall', 1, 'tilt_deg', 89.98, 0.45),
  ('wall', 1, 'width', 1.051, 0.1204),
  ('wall', 1, 'z_max', 2.909, 0.37),
  ('wall', 1, 'z_min', -0.01108, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.136, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'area_m2', 1.931, 0.3192),
  ('wall', 2, 'aspect', 0.3771, 0.2258),
  ('wall', 2, 'behind', 0.1184, 0.1185),
  ('wall', 2, 'edge_free', 0.1636, 0.1028),
  ('wall', 2, 'edge_free_top', 0.07314, 0.1108),
  ('wall', 2, 'edge_joined', 0.08531, 0.1259),
  ('wall', 2, 'height', 1.567, 0.2108),
  ('wall', 2, 'length', 1.412, 0.2211),
  ('wall', 2, 'rectangularity', 0.6087, 0.1179),
  ('wall', 2, 'spread_length', 1.288, 0.2089),
  ('wall', 2, 'spread_width', 0.847, 0.1891),
  ('wall', 2, 'tilt_deg', 89.98, 0.45),
  ('wall', 2, 'width', 1.035, 0.1175),
  ('wall', 2, 'z_max', 2.885, 0.338),
  ('wall', 2, 'z_min', -0.009139, 0.02571);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.111, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'area_m2', 1.298, 0.3993),
  ('wall', 3, 'aspect', 0.3571, 0.2615),
  ('wall', 3, 'behind', 0.001973, 0.01493),
  ('wall', 3, 'edge_free', 0.001664, 0.01375),
  ('wall', 3, 'edge_free_top', 0.001174, 0.01286),
  ('wall', 3, 'edge_joined', 0.2748, 0.2238),
  ('wall', 3, 'height', 1.491, 0.2145),
  ('wall', 3, 'length', 1.084, 0.2413),
  ('wall', 3, 'rectangularity', 0.6085, 0.1046),
  ('wall', 3, 'spread_length', 0.8361, 0.2489),
  ('wall', 3, 'spread_width', 0.3389, 0.2128),
  ('wall', 3, 'tilt_deg', 89.93, 0.45),
  ('wall', 3, 'width', 0.7264, 0.2485),
  ('wall', 3, 'z_max', 2.791, 0.3793),
  ('wall', 3, 'z_min', 0.2541, 0.2784);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.1108, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'area_m2', 0.01018, 0.4212),
  ('wall', 4, 'aspect', 0.6303, 0.3514),
  ('wall', 4, 'behind', 0.00148, 0.01361),
  ('wall', 4, 'edge_free', 0.002839, 0.01501),
  ('wall', 4, 'edge_free_top', 0.002777, 0.02155),
  ('wall', 4, 'edge_joined', 0.1652, 0.2041),
  ('wall', 4, 'height', 1.023, 0.4015),
  ('wall', 4, 'length', 0.4967, 0.2598),
  ('wall', 4, 'rectangularity', 0.7146, 0.1187),
  ('wall', 4, 'spread_length', 0.3398, 0.2684),
  ('wall', 4, 'spread_width', -0.3615, 0.2888),
  ('wall', 4, 'tilt_deg', 87.95, 2.24),
  ('wall', 4, 'width', -0.1336, 0.3091),
  ('wall', 4, 'z_max', 1.629, 0.5298),
  ('wall', 4, 'z_min', 0.3154, 0.4458);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.09806, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'area_m2', 0.7209, 0.4852),
  ('wall', 5, 'aspect', 0.9142, 0.4429),
  ('wall', 5, 'behind', 0.4189, 0.2273),
  ('wall', 5, 'edge_free', 0.3189, 0.2104),
  ('wall', 5, 'edge_free_top', 0.1963, 0.2405),
  ('wall', 5, 'edge_joined', 0.2706, 0.286),
  ('wall', 5, 'height', 1.435, 0.1999),
  ('wall', 5, 'length', 1.038, 0.1151),
  ('wall', 5, 'rectangularity', 0.666, 0.1572),
  ('wall', 5, 'spread_length', 0.8583, 0.1512),
  ('wall', 5, 'spread_width', -0.119, 0.4792),
  ('wall', 5, 'tilt_deg', 89.98, 0.45),
  ('wall', 5, 'width', 0.1236, 0.4474),
  ('wall', 5, 'z_max', 2.809, 0.33),
  ('wall', 5, 'z_min', -0.009214, 0.02919);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.06461, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'area_m2', 0.3386, 0.5678),
  ('wall', 6, 'aspect', 0.795, 0.5077),
  ('wall', 6, 'behind', 0.3474, 0.2456),
  ('wall', 6, 'edge_free', 0.2302, 0.2224),
  ('wall', 6, 'edge_free_top', 0.002155, 0.01663),
  ('wall', 6, 'edge_joined', 0.3601, 0.2733),
  ('wall', 6, 'height', 1.825, 0.3183),
  ('wall', 6, 'length', 0.7259, 0.2526),
  ('wall', 6, 'rectangularity', 0.7434, 0.1372),
  ('wall', 6, 'spread_length', 0.5609, 0.2499),
  ('wall', 6, 'spread_width', -0.238, 0.4696),
  ('wall', 6, 'tilt_deg', 89.95, 0.45),
  ('wall', 6, 'width', -0.06904, 0.4583),
  ('wall', 6, 'z_max', 2.858, 0.3592),
  ('wall', 6, 'z_min', 0.865, 0.539);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.06036, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'area_m2', 0.009538, 0.5749),
  ('wall', 7, 'aspect', 0.7753, 0.4678),
  ('wall', 7, 'behind', 0.2979, 0.2013),
  ('wall', 7, 'edge_free', 0.4475, 0.2653),
  ('wall', 7, 'edge_free_top', 0.532, 0.2738),
  ('wall', 7, 'edge_joined', 0.1004, 0.1208),
  ('wall', 7, 'height', 1.159, 0.3309),
  ('wall', 7, 'length', 0.6347, 0.3225),
  ('wall', 7, 'rectangularity', 0.6373, 0.1549),
  ('wall', 7, 'spread_length', 0.3981, 0.3442),
  ('wall', 7, 'spread_width', -0.3749, 0.4978),
  ('wall', 7, 'tilt_deg', 89.09, 1.575),
  ('wall', 7, 'width', -0.1406, 0.4989),
  ('wall', 7, 'z_max', 2.001, 0.5673),
  ('wall', 7, 'z_min', 0.2968, 0.3295);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.04109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'area_m2', -1.133, 0.469),
  ('wall', 8, 'aspect', 0.954, 0.474),
  ('wall', 8, 'behind', 0.02199, 0.0439),
  ('wall', 8, 'edge_free', 0.1525, 0.2662),
  ('wall', 8, 'edge_free_top', 0.04791, 0.09694),
  ('wall', 8, 'edge_joined', 0.1313, 0.2015),
  ('wall', 8, 'height', 0.9776, 0.5152),
  ('wall', 8, 'length', 0.1079, 0.2988),
  ('wall', 8, 'rectangularity', 0.693, 0.1514),
  ('wall', 8, 'spread_length', -0.06399, 0.2897),
  ('wall', 8, 'spread_width', -1.079, 0.3631),
  ('wall', 8, 'tilt_deg', 88.57, 1.734),
  ('wall', 8, 'width', -0.8461, 0.3626),
  ('wall', 8, 'z_max', 1.493, 0.5639),
  ('wall', 8, 'z_min', 0.4838, 0.5211);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.04019, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'area_m2', 0.4804, 0.737),
  ('wall', 9, 'aspect', 1.155, 0.6538),
  ('wall', 9, 'behind', 0.006458, 0.02668),
  ('wall', 9, 'edge_free', 0.003624, 0.02189),
  ('wall', 9, 'edge_free_top', 0.002227, 0.0195),
  ('wall', 9, 'edge_joined', 0.009801, 0.02815),
  ('wall', 9, 'height', 1.243, 0.07302),
  ('wall', 9, 'length', 0.8849, 0.06465),
  ('wall', 9, 'rectangularity', 0.8825, 0.1016),
  ('wall', 9, 'spread_length', 0.8201, 0.1121),
  ('wall', 9, 'spread_width', -0.3264, 0.6892),
  ('wall', 9, 'tilt_deg', 89.96, 0.45),
  ('wall', 9, 'width', -0.2697, 0.6555),
  ('wall', 9, 'z_max', 2.42, 0.1193),
  ('wall', 9, 'z_min', 0.01084, 0.05296);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.03436, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'area_m2', 0.9269, 0.3888),
  ('wall', 10, 'aspect', 0.7519, 0.2546),
  ('wall', 10, 'behind', 0.007725, 0.02592),
  ('wall', 10, 'edge_free', 0.02141, 0.04639),
  ('wall', 10, 'edge_free_top', 0.00944, 0.03495),
  ('wall', 10, 'edge_joined', 0.09661, 0.1259),
  ('wall', 10, 'height', 1.095, 0.2024),
  ('wall', 10, 'length', 1.128, 0.2168),
  ('wall', 10, 'rectangularity', 0.5748, 0.1123),
  ('wall', 10, 'spread_length', 1.016, 0.2544),
  ('wall', 10, 'spread_width', 0.08954, 0.1732),
  ('wall', 10, 'tilt_deg', 87.05, 1.657),
  ('wall', 10, 'width', 0.3765, 0.1903),
  ('wall', 10, 'z_max', 1.674, 0.3152),
  ('wall', 10, 'z_min', 0.06343, 0.1488);

-- table: 312 examples
UPDATE object_class SET prior = 0.04535 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.3658, 0.6164)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5486, 0.2991)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5256, 0.208)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.435, 0.1998)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_joined', 0.3043, 0.1948)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7416, 0.1222)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.274, 0.3216)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.706, 0.122)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.137, 0.3162)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4602, 0.354)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.7822, 0.6448)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2768, 0.3284)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7499, 0.1222)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7353, 0.1214)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'table';
DELETE FROM class_density WHERE class = 'table';
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.1516, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'area_m2', 0.04203, 0.2704),
  ('table', 1, 'aspect', 0.355, 0.1533),
  ('table', 1, 'behind', 0.6448, 0.09164),
  ('table', 1, 'edge_free', 0.4055, 0.198),
  ('table', 1, 'edge_free_top', 0, 0.3162),
  ('table', 1, 'edge_joined', 0.3607, 0.2027),
  ('table', 1, 'height', 0.7391, 0.02746),
  ('table', 1, 'length', 0.3798, 0.1402),
  ('table', 1, 'rectangularity', 0.706, 0.1109),
  ('table', 1, 'spread_length', 0.2353, 0.1463),
  ('table', 1, 'spread_width', -0.1626, 0.1692),
  ('table', 1, 'tilt_deg', 0.4146, 0.45),
  ('table', 1, 'width', 0.02478, 0.1595),
  ('table', 1, 'z_max', 0.7444, 0.02847),
  ('table', 1, 'z_min', 0.7353, 0.02763);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.143, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'area_m2', 0.1593, 0.1442),
  ('table', 2, 'aspect', 0.7372, 0.1202),
  ('table', 2, 'behind', 0.5924, 0.1742),
  ('table', 2, 'edge_free', 0.4521, 0.1741),
  ('table', 2, 'edge_free_top', 0, 0.3162),
  ('table', 2, 'edge_joined', 0.3086, 0.1486),
  ('table', 2, 'height', 0.728, 0.02441),
  ('table', 2, 'length', 0.5907, 0.102),
  ('table', 2, 'rectangularity', 0.7595, 0.09812),
  ('table', 2, 'spread_length', 0.4249, 0.1354),
  ('table', 2, 'spread_width', -0.276, 0.1228),
  ('table', 2, 'tilt_deg', 0.4922, 0.45),
  ('table', 2, 'width', -0.1465, 0.09392),
  ('table', 2, 'z_max', 0.7338, 0.02541),
  ('table', 2, 'z_min', 0.7228, 0.02505);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.1401, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'area_m2', -0.1579, 0.2831),
  ('table', 3, 'aspect', 0.5726, 0.2366),
  ('table', 3, 'behind', 0.5487, 0.1601),
  ('table', 3, 'edge_free', 0.4624, 0.1752),
  ('table', 3, 'edge_free_top', 0, 0.3162),
  ('table', 3, 'edge_joined', 0.2397, 0.1493),
  ('table', 3, 'height', 0.6518, 0.02472),
  ('table', 3, 'length', 0.3864, 0.2077),
  ('table', 3, 'rectangularity', 0.7116, 0.1246),
  ('table', 3, 'spread_length', 0.2701, 0.1924),
  ('table', 3, 'spread_width', -0.3301, 0.1541),
  ('table', 3, 'tilt_deg', 0.99, 0.7369),
  ('table', 3, 'width', -0.1862, 0.1463),
  ('table', 3, 'z_max', 0.6646, 0.0253),
  ('table', 3, 'z_min', 0.6436, 0.02703);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.1232, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'area_m2', -0.8647, 0.1634),
  ('table', 4, 'aspect', 0.2494, 0.1673),
  ('table', 4, 'behind', 0.5212, 0.1983),
  ('table', 4, 'edge_free', 0.4621, 0.1494),
  ('table', 4, 'edge_free_top', 0, 0.3162),
  ('table', 4, 'edge_joined', 0.2795, 0.1339),
  ('table', 4, 'height', 0.746, 0.07305),
  ('table', 4, 'length', -0.1574, 0.106),
  ('table', 4, 'rectangularity', 0.7475, 0.09675),
  ('table', 4, 'spread_length', -0.2421, 0.09904),
  ('table', 4, 'spread_width', -0.5807, 0.135),
  ('table', 4, 'tilt_deg', 1.028, 0.5816),
  ('table', 4, 'width', -0.4067, 0.1441),
  ('table', 4, 'z_max', 0.7547, 0.07409),
  ('table', 4, 'z_min', 0.7398, 0.07275);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.1218, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'area_m2', -0.02861, 0.2771),
  ('table', 5, 'aspect', 0.5816, 0.25),
  ('table', 5, 'behind', 0.5197, 0.1569),
  ('table', 5, 'edge_free', 0.4443, 0.1887),
  ('table', 5, 'edge_free_top', 0, 0.3162),
  ('table', 5, 'edge_joined', 0.3098, 0.1805),
  ('table', 5, 'height', 0.8154, 0.03491),
  ('table', 5, 'length', 0.4382, 0.2151),
  ('table', 5, 'rectangularity', 0.7336, 0.1137),
  ('table', 5, 'spread_length', 0.297, 0.1953),
  ('table', 5, 'spread_width', -0.3127, 0.1556),
  ('table', 5, 'tilt_deg', 0.9092, 0.5944),
  ('table', 5, 'width', -0.1434, 0.1631),
  ('table', 5, 'z_max', 0.8266, 0.03818),
  ('table', 5, 'z_min', 0.8063, 0.03407);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.1068, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'area_m2', -0.6334, 0.2458),
  ('table', 6, 'aspect', 0.5602, 0.2916),
  ('table', 6, 'behind', 0.493, 0.2263),
  ('table', 6, 'edge_free', 0.3892, 0.1948),
  ('table', 6, 'edge_free_top', 0, 0.3162),
  ('table', 6, 'edge_joined', 0.3763, 0.2196),
  ('table', 6, 'height', 0.7237, 0.02836),
  ('table', 6, 'length', 0.1893, 0.1906),
  ('table', 6, 'rectangularity', 0.6493, 0.1157),
  ('table', 6, 'spread_length', 0.0593, 0.2085),
  ('table', 6, 'spread_width', -0.6264, 0.2202),
  ('table', 6, 'tilt_deg', 0.5562, 0.45),
  ('table', 6, 'width', -0.3709, 0.1949),
  ('table', 6, 'z_max', 0.7291, 0.02886),
  ('table', 6, 'z_min', 0.7202, 0.02827);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.08666, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'area_m2', -1.632, 0.4491),
  ('table', 7, 'aspect', 0.7936, 0.3476),
  ('table', 7, 'behind', 0.3981, 0.2483),
  ('table', 7, 'edge_free', 0.4538, 0.2408),
  ('table', 7, 'edge_free_top', 0, 0.3162),
  ('table', 7, 'edge_joined', 0.2165, 0.2089),
  ('table', 7, 'height', 0.7254, 0.05148),
  ('table', 7, 'length', -0.1798, 0.2522),
  ('table', 7, 'rectangularity', 0.6315, 0.1114),
  ('table', 7, 'spread_length', -0.3345, 0.2779),
  ('table', 7, 'spread_width', -1.202, 0.3158),
  ('table', 7, 'tilt_deg', 1.182, 0.8833),
  ('table', 7, 'width', -0.9734, 0.2988),
  ('table', 7, 'z_max', 0.7328, 0.05102),
  ('table', 7, 'z_min', 0.7203, 0.05185);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.05652, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'area_m2', -0.4175, 0.6136),
  ('table', 8, 'aspect', 0.695, 0.2783),
  ('table', 8, 'behind', 0.3745, 0.1633),
  ('table', 8, 'edge_free', 0.4155, 0.2319),
  ('table', 8, 'edge_free_top', 0, 0.3162),
  ('table', 8, 'edge_joined', 0.4108, 0.1884),
  ('table', 8, 'height', 1.027, 0.06574),
  ('table', 8, 'length', 0.3628, 0.2891),
  ('table', 8, 'rectangularity', 0.6478, 0.09687),
  ('table', 8, 'spread_length', 0.1845, 0.3007),
  ('table', 8, 'spread_width', -0.5759, 0.3576),
  ('table', 8, 'tilt_deg', 0.8536, 0.5323),
  ('table', 8, 'width', -0.3322, 0.2811),
  ('table', 8, 'z_max', 1.036, 0.06704),
  ('table', 8, 'z_min', 1.017, 0.0668);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.0203, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'area_m2', -0.7192, 0.4004),
  ('table', 9, 'aspect', 0.6476, 0.3303),
  ('table', 9, 'behind', 0.2111, 0.1203),
  ('table', 9, 'edge_free', 0.3551, 0.1243),
  ('table', 9, 'edge_free_top', 0, 0.3162),
  ('table', 9, 'edge_joined', 0.142, 0.07361),
  ('table', 9, 'height', 0.351, 0.3278),
  ('table', 9, 'length', 0.2088, 0.08283),
  ('table', 9, 'rectangularity', 0.6281, 0.1029),
  ('table', 9, 'spread_length', 0.05881, 0.1259),
  ('table', 9, 'spread_width', -0.6822, 0.2996),
  ('table', 9, 'tilt_deg', 1.429, 0.5986),
  ('table', 9, 'width', -0.4389, 0.3131),
  ('table', 9, 'z_max', 0.3606, 0.3258),
  ('table', 9, 'z_min', 0.341, 0.3304);

-- flat_screen: 254 examples
UPDATE object_class SET prior = 0.03696 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.832, 0.432)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.4066, 0.2193)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5694, 0.1421)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.7624, 0.1791)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.9732, 0.07896)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_joined', 0.04477, 0.08837)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.027, 0.1213)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.593, 0.2755)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.7985, 0.1134)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7453, 0.2283)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.202, 0.195)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 84.88, 3.59)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -1.002, 0.2276)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.188, 0.1279)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7894, 0.1659)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'flat_screen';
DELETE FROM class_density WHERE class = 'flat_screen';
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.2513, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'area_m2', -1.589, 0.161),
  ('flat_screen', 1, 'aspect', 0.3851, 0.1538),
  ('flat_screen', 1, 'behind', 0.5727, 0.1469),
  ('flat_screen', 1, 'edge_free', 0.7176, 0.0965),
  ('flat_screen', 1, 'edge_free_top', 0.9993, 0.008109),
  ('flat_screen', 1, 'edge_joined', 0.04869, 0.06746),
  ('flat_screen', 1, 'height', 0.979, 0.1154),
  ('flat_screen', 1, 'length', -0.4815, 0.1298),
  ('flat_screen', 1, 'rectangularity', 0.7911, 0.08498),
  ('flat_screen', 1, 'spread_length', -0.643, 0.1072),
  ('flat_screen', 1, 'spread_width', -1.104, 0.09075),
  ('flat_screen', 1, 'tilt_deg', 85.46, 3.359),
  ('flat_screen', 1, 'width', -0.8666, 0.08959),
  ('flat_screen', 1, 'z_max', 1.14, 0.1202),
  ('flat_screen', 1, 'z_min', 0.7161, 0.11);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.1557, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'area_m2', -1.549, 0.3894),
  ('flat_screen', 2, 'aspect', 0.5007, 0.205),
  ('flat_screen', 2, 'behind', 0.6209, 0.08772),
  ('flat_screen', 2, 'edge_free', 0.5552, 0.1063),
  ('flat_screen', 2, 'edge_free_top', 0.8334, 0.183),
  ('flat_screen', 2, 'edge_joined', 0.1211, 0.1417),
  ('flat_screen', 2, 'height', 1.001, 0.06082),
  ('flat_screen', 2, 'length', -0.357, 0.2265),
  ('flat_screen', 2, 'rectangularity', 0.7199, 0.07089),
  ('flat_screen', 2, 'spread_length', -0.6431, 0.2198),
  ('flat_screen', 2, 'spread_width', -1.117, 0.1601),
  ('flat_screen', 2, 'tilt_deg', 84.97, 3.237),
  ('flat_screen', 2, 'width', -0.8576, 0.1889),
  ('flat_screen', 2, 'z_max', 1.194, 0.08882),
  ('flat_screen', 2, 'z_min', 0.7432, 0.07225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.1458, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'area_m2', -1.827, 0.179),
  ('flat_screen', 3, 'aspect', 0.4875, 0.06924),
  ('flat_screen', 3, 'behind', 0.5589, 0.115),
  ('flat_screen', 3, 'edge_free', 0.9832, 0.02589),
  ('flat_screen', 3, 'edge_free_top', 0.9993, 0.009807),
  ('flat_screen', 3, 'edge_joined', 0.002188, 0.009683),
  ('flat_screen', 3, 'height', 1.028, 0.06126),
  ('flat_screen', 3, 'length', -0.6273, 0.1038),
  ('flat_screen', 3, 'rectangularity', 0.9202, 0.04419),
  ('flat_screen', 3, 'spread_length', -0.6758, 0.08611),
  ('flat_screen', 3, 'spread_width', -1.168, 0.09472),
  ('flat_screen', 3, 'tilt_deg', 85.04, 3.384),
  ('flat_screen', 3, 'width', -1.115, 0.1031),
  ('flat_screen', 3, 'z_max', 1.179, 0.06261),
  ('flat_screen', 3, 'z_min', 0.8492, 0.05195);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.141, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'area_m2', -2.034, 0.1901),
  ('flat_screen', 4, 'aspect', 0.1813, 0.1342),
  ('flat_screen', 4, 'behind', 0.5984, 0.1379),
  ('flat_screen', 4, 'edge_free', 0.7456, 0.1007),
  ('flat_screen', 4, 'edge_free_top', 0.9981, 0.01213),
  ('flat_screen', 4, 'edge_joined', 0.02429, 0.02227),
  ('flat_screen', 4, 'height', 0.9949, 0.04412),
  ('flat_screen', 4, 'length', -0.7905, 0.1439),
  ('flat_screen', 4, 'rectangularity', 0.7694, 0.09755),
  ('flat_screen', 4, 'spread_length', -0.9392, 0.1101),
  ('flat_screen', 4, 'spread_width', -1.25, 0.07123),
  ('flat_screen', 4, 'tilt_deg', 85.18, 3.052),
  ('flat_screen', 4, 'width', -0.9718, 0.09242),
  ('flat_screen', 4, 'z_max', 1.135, 0.04767),
  ('flat_screen', 4, 'z_min', 0.7464, 0.04256);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.09812, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'area_m2', -2.274, 0.1816),
  ('flat_screen', 5, 'aspect', 0.2547, 0.1142),
  ('flat_screen', 5, 'behind', 0.545, 0.1138),
  ('flat_screen', 5, 'edge_free', 0.9016, 0.1238),
  ('flat_screen', 5, 'edge_free_top', 0.9966, 0.01591),
  ('flat_screen', 5, 'edge_joined', 0.01015, 0.02922),
  ('flat_screen', 5, 'height', 1.081, 0.06392),
  ('flat_screen', 5, 'length', -0.9349, 0.1217),
  ('flat_screen', 5, 'rectangularity', 0.8658, 0.07947),
  ('flat_screen', 5, 'spread_length', -0.9926, 0.08208),
  ('flat_screen', 5, 'spread_width', -1.3, 0.09128),
  ('flat_screen', 5, 'tilt_deg', 84.52, 2.836),
  ('flat_screen', 5, 'width', -1.19, 0.1168),
  ('flat_screen', 5, 'z_max', 1.216, 0.06981),
  ('flat_screen', 5, 'z_min', 0.9068, 0.06095);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.05525, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'area_m2', -2.73, 0.3282),
  ('flat_screen', 6, 'aspect', 0.657, 0.3143),
  ('flat_screen', 6, 'behind', 0.5868, 0.1929),
  ('flat_screen', 6, 'edge_free', 0.6404, 0.1604),
  ('flat_screen', 6, 'edge_free_top', 0.9975, 0.01661),
  ('flat_screen', 6, 'edge_joined', 0.09731, 0.1542),
  ('flat_screen', 6, 'height', 1.04, 0.06436),
  ('flat_screen', 6, 'length', -0.8724, 0.2798),
  ('flat_screen', 6, 'rectangularity', 0.7321, 0.112),
  ('flat_screen', 6, 'spread_length', -1.028, 0.2546),
  ('flat_screen', 6, 'spread_width', -1.732, 0.2074),
  ('flat_screen', 6, 'tilt_deg', 83.09, 4.922),
  ('flat_screen', 6, 'width', -1.529, 0.1836),
  ('flat_screen', 6, 'z_max', 1.167, 0.07191),
  ('flat_screen', 6, 'z_min', 0.8563, 0.0742);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.05438, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'area_m2', -1.963, 0.2858),
  ('flat_screen', 7, 'aspect', 0.4303, 0.08608),
  ('flat_screen', 7, 'behind', 0.4425, 0.07542),
  ('flat_screen', 7, 'edge_free', 0.8366, 0.1846),
  ('flat_screen', 7, 'edge_free_top', 0.9875, 0.03398),
  ('flat_screen', 7, 'edge_joined', 0.007829, 0.01656),
  ('flat_screen', 7, 'height', 1.328, 0.04526),
  ('flat_screen', 7, 'length', -0.6718, 0.1628),
  ('flat_screen', 7, 'rectangularity', 0.8345, 0.09296),
  ('flat_screen', 7, 'spread_length', -0.7831, 0.1614),
  ('flat_screen', 7, 'spread_width', -1.263, 0.1527),
  ('flat_screen', 7, 'tilt_deg', 83.18, 2.499),
  ('flat_screen', 7, 'width', -1.102, 0.157),
  ('flat_screen', 7, 'z_max', 1.479, 0.05399),
  ('flat_screen', 7, 'z_min', 1.135, 0.06515);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.04853, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'area_m2', -1.399, 0.4013),
  ('flat_screen', 8, 'aspect', 0.6445, 0.1961),
  ('flat_screen', 8, 'behind', 0.5172, 0.1454),
  ('flat_screen', 8, 'edge_free', 0.8082, 0.1117),
  ('flat_screen', 8, 'edge_free_top', 0.9943, 0.01769),
  ('flat_screen', 8, 'edge_joined', 0.03516, 0.03037),
  ('flat_screen', 8, 'height', 0.9266, 0.2879),
  ('flat_screen', 8, 'length', -0.1785, 0.2836),
  ('flat_screen', 8, 'rectangularity', 0.6922, 0.1408),
  ('flat_screen', 8, 'spread_length', -0.4095, 0.2597),
  ('flat_screen', 8, 'spread_width', -1.075, 0.2461),
  ('flat_screen', 8, 'tilt_deg', 84.64, 4.193),
  ('flat_screen', 8, 'width', -0.8229, 0.2708),
  ('flat_screen', 8, 'z_max', 1.173, 0.3282),
  ('flat_screen', 8, 'z_min', 0.5526, 0.345);

-- keyboard: 155 examples
UPDATE object_class SET prior = 0.0226 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.779, 0.3671)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7756, 0.3014)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.2466, 0.1613)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.2736, 0.2025)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_joined', 0.6731, 0.2123)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7845, 0.1174)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.9092, 0.2696)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8336, 0.07889)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9774, 0.2865)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.831, 0.1238)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 4.011, 2.121)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.684, 0.2017)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7925, 0.1181)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7769, 0.1171)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'keyboard';
DELETE FROM class_density WHERE class = 'keyboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1548, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'area_m2', -2.575, 0.09519),
  ('keyboard', 1, 'aspect', 0.8226, 0.1175),
  ('keyboard', 1, 'behind', 0.3119, 0.1536),
  ('keyboard', 1, 'edge_free', 0.4202, 0.1576),
  ('keyboard', 1, 'edge_free_top', 0, 0.3162),
  ('keyboard', 1, 'edge_joined', 0.5486, 0.1481),
  ('keyboard', 1, 'height', 0.7847, 0.02482),
  ('keyboard', 1, 'length', -0.7878, 0.05831),
  ('keyboard', 1, 'rectangularity', 0.84, 0.05466),
  ('keyboard', 1, 'spread_length', -0.8457, 0.07773),
  ('keyboard', 1, 'spread_width', -1.797, 0.09795),
  ('keyboard', 1, 'tilt_deg', 4.953, 1.217),
  ('keyboard', 1, 'width', -1.61, 0.1069),
  ('keyboard', 1, 'z_max', 0.7947, 0.02514),
  ('keyboard', 1, 'z_min', 0.7755, 0.02512);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.1487, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'area_m2', -2.771, 0.126),
  ('keyboard', 2, 'aspect', 1.022, 0.1068),
  ('keyboard', 2, 'behind', 0.1903, 0.1269),
  ('keyboard', 2, 'edge_free', 0.3822, 0.131),
  ('keyboard', 2, 'edge_free_top', 0, 0.3162),
  ('keyboard', 2, 'edge_joined', 0.561, 0.1091),
  ('keyboard', 2, 'height', 0.7118, 0.0411),
  ('keyboard', 2, 'length', -0.8004, 0.07639),
  ('keyboard', 2, 'rectangularity', 0.8651, 0.06663),
  ('keyboard', 2, 'spread_length', -0.8331, 0.0729),
  ('keyboard', 2, 'spread_width', -1.911, 0.07531),
  ('keyboard', 2, 'tilt_deg', 4.4, 1.742),
  ('keyboard', 2, 'width', -1.822, 0.1004),
  ('keyboard', 2, 'z_max', 0.7201, 0.04098),
  ('keyboard', 2, 'z_min', 0.7041, 0.04163);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.1282, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'area_m2', -3.088, 0.2174),
  ('keyboard', 3, 'aspect', 0.4117, 0.1731),
  ('keyboard', 3, 'behind', 0.3372, 0.1625),
  ('keyboard', 3, 'edge_free', 0.1786, 0.1213),
  ('keyboard', 3, 'edge_free_top', 0, 0.3162),
  ('keyboard', 3, 'edge_joined', 0.7107, 0.1711),
  ('keyboard', 3, 'height', 0.7342, 0.04208),
  ('keyboard', 3, 'length', -1.227, 0.1487),
  ('keyboard', 3, 'rectangularity', 0.802, 0.04315),
  ('keyboard', 3, 'spread_length', -1.322, 0.1758),
  ('keyboard', 3, 'spread_width', -1.8, 0.08478),
  ('keyboard', 3, 'tilt_deg', 3.344, 1.495),
  ('keyboard', 3, 'width', -1.639, 0.1291),
  ('keyboard', 3, 'z_max', 0.7409, 0.04144),
  ('keyboard', 3, 'z_min', 0.7287, 0.04264);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.1166, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'area_m2', -2.351, 0.1531),
  ('keyboard', 4, 'aspect', 0.6444, 0.1167),
  ('keyboard', 4, 'behind', 0.2703, 0.09526),
  ('keyboard', 4, 'edge_free', 0.2719, 0.159),
  ('keyboard', 4, 'edge_free_top', 0, 0.3162),
  ('keyboard', 4, 'edge_joined', 0.682, 0.1852),
  ('keyboard', 4, 'height', 0.7633, 0.06435),
  ('keyboard', 4, 'length', -0.7149, 0.08277),
  ('keyboard', 4, 'rectangularity', 0.7598, 0.04425),
  ('keyboard', 4, 'spread_length', -0.8428, 0.08379),
  ('keyboard', 4, 'spread_width', -1.664, 0.0825),
  ('keyboard', 4, 'tilt_deg', 3.41, 1.953),
  ('keyboard', 4, 'width', -1.359, 0.09174),
  ('keyboard', 4, 'z_max', 0.7711, 0.06472),
  ('keyboard', 4, 'z_min', 0.7547, 0.06459);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.09931, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'area_m2', -2.721, 0.116),
  ('keyboard', 5, 'aspect', 1.047, 0.1112),
  ('keyboard', 5, 'behind', 0.2467, 0.1369),
  ('keyboard', 5, 'edge_free', 0.1904, 0.1831),
  ('keyboard', 5, 'edge_free_top', 0, 0.3162),
  ('keyboard', 5, 'edge_joined', 0.754, 0.2302),
  ('keyboard', 5, 'height', 0.869, 0.05827),
  ('keyboard', 5, 'length', -0.7628, 0.09158),
  ('keyboard', 5, 'rectangularity', 0.8648, 0.06028),
  ('keyboard', 5, 'spread_length', -0.8148, 0.1162),
  ('keyboard', 5, 'spread_width', -1.881, 0.07716),
  ('keyboard', 5, 'tilt_deg', 3.387, 1.585),
  ('keyboard', 5, 'width', -1.81, 0.09124),
  ('keyboard', 5, 'z_max', 0.8758, 0.05841),
  ('keyboard', 5, 'z_min', 0.8626, 0.05803);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.09379, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'area_m2', -2.593, 0.1896),
  ('keyboard', 6, 'aspect', 0.9267, 0.1752),
  ('keyboard', 6, 'behind', 0.2912, 0.1373),
  ('keyboard', 6, 'edge_free', 0.043, 0.04528),
  ('keyboard', 6, 'edge_free_top', 0, 0.3162),
  ('keyboard', 6, 'edge_joined', 0.9308, 0.06974),
  ('keyboard', 6, 'height', 0.7401, 0.02939),
  ('keyboard', 6, 'length', -0.7289, 0.1785),
  ('keyboard', 6, 'rectangularity', 0.8158, 0.06784),
  ('keyboard', 6, 'spread_length', -0.7999, 0.1839),
  ('keyboard', 6, 'spread_width', -1.822, 0.07801),
  ('keyboard', 6, 'tilt_deg', 1.926, 1.151),
  ('keyboard', 6, 'width', -1.656, 0.09677),
  ('keyboard', 6, 'z_max', 0.7444, 0.02939),
  ('keyboard', 6, 'z_min', 0.7363, 0.02945);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.08041, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'area_m2', -3.463, 0.367),
  ('keyboard', 7, 'aspect', 0.5775, 0.3274),
  ('keyboard', 7, 'behind', 0.1701, 0.1308),
  ('keyboard', 7, 'edge_free', 0.08314, 0.1043),
  ('keyboard', 7, 'edge_free_top', 0, 0.3162),
  ('keyboard', 7, 'edge_joined', 0.8127, 0.1965),
  ('keyboard', 7, 'height', 0.6786, 0.2497),
  ('keyboard', 7, 'length', -1.335, 0.306),
  ('keyboard', 7, 'rectangularity', 0.8144, 0.09814),
  ('keyboard', 7, 'spread_length', -1.417, 0.3224),
  ('keyboard', 7, 'spread_width', -1.997, 0.06463),
  ('keyboard', 7, 'tilt_deg', 3.402, 2.101),
  ('keyboard', 7, 'width', -1.913, 0.09272),
  ('keyboard', 7, 'z_max', 0.6846, 0.2501),
  ('keyboard', 7, 'z_min', 0.6727, 0.2494);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.07021, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'area_m2', -2.968, 0.2305),
  ('keyboard', 8, 'aspect', 0.4856, 0.2113),
  ('keyboard', 8, 'behind', 0.1945, 0.1149),
  ('keyboard', 8, 'edge_free', 0.4485, 0.06496),
  ('keyboard', 8, 'edge_free_top', 0, 0.3162),
  ('keyboard', 8, 'edge_joined', 0.5344, 0.07074),
  ('keyboard', 8, 'height', 0.8253, 0.06354),
  ('keyboard', 8, 'length', -1.155, 0.1893),
  ('keyboard', 8, 'rectangularity', 0.8453, 0.06042),
  ('keyboard', 8, 'spread_length', -1.203, 0.1834),
  ('keyboard', 8, 'spread_width', -1.805, 0.09155),
  ('keyboard', 8, 'tilt_deg', 6.654, 1.607),
  ('keyboard', 8, 'width', -1.641, 0.145),
  ('keyboard', 8, 'z_max', 0.8374, 0.06383),
  ('keyboard', 8, 'z_min', 0.8129, 0.06407);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.05793, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'area_m2', -2.759, 0.1664),
  ('keyboard', 9, 'aspect', 1.006, 0.1251),
  ('keyboard', 9, 'behind', 0.07627, 0.06624),
  ('keyboard', 9, 'edge_free', 0.3937, 0.09587),
  ('keyboard', 9, 'edge_free_top', 0, 0.3162),
  ('keyboard', 9, 'edge_joined', 0.601, 0.09613),
  ('keyboard', 9, 'height', 1.084, 0.05247),
  ('keyboard', 9, 'length', -0.8425, 0.115),
  ('keyboard', 9, 'rectangularity', 0.9358, 0.03102),
  ('keyboard', 9, 'spread_length', -0.8549, 0.1147),
  ('keyboard', 9, 'spread_width', -1.848, 0.07229),
  ('keyboard', 9, 'tilt_deg', 5.448, 1.282),
  ('keyboard', 9, 'width', -1.848, 0.09806),
  ('keyboard', 9, 'z_max', 1.095, 0.05303),
  ('keyboard', 9, 'z_min', 1.075, 0.05279);

-- chair_seat: 202 examples
UPDATE object_class SET prior = 0.02944 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.066, 0.5566)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.3062, 0.2912)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6294, 0.1984)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.6316, 0.1892)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_joined', 0.07917, 0.09397)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.471, 0.03293)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7257, 0.1823)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7491, 0.1285)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.774, 0.1867)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.228, 0.3863)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 1.467, 1.233)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.033, 0.3602)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4773, 0.03336)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4665, 0.03305)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_seat';
DELETE FROM class_density WHERE class = 'chair_seat';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.1949, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'area_m2', -1.694, 0.1157),
  ('chair_seat', 1, 'aspect', 0.1378, 0.09517),
  ('chair_seat', 1, 'behind', 0.7256, 0.07256),
  ('chair_seat', 1, 'edge_free', 0.7563, 0.1256),
  ('chair_seat', 1, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 1, 'edge_joined', 0.05582, 0.05717),
  ('chair_seat', 1, 'height', 0.4427, 0.0225),
  ('chair_seat', 1, 'length', -0.6877, 0.07819),
  ('chair_seat', 1, 'rectangularity', 0.8387, 0.07124),
  ('chair_seat', 1, 'spread_length', -0.7315, 0.06641),
  ('chair_seat', 1, 'spread_width', -0.9547, 0.08404),
  ('chair_seat', 1, 'tilt_deg', 0.9545, 0.7083),
  ('chair_seat', 1, 'width', -0.8256, 0.07623),
  ('chair_seat', 1, 'z_max', 0.4478, 0.0225),
  ('chair_seat', 1, 'z_min', 0.439, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'area_m2', -1.596, 0.1133),
  ('chair_seat', 2, 'aspect', 0.119, 0.06884),
  ('chair_seat', 2, 'behind', 0.5895, 0.146),
  ('chair_seat', 2, 'edge_free', 0.7755, 0.1244),
  ('chair_seat', 2, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 2, 'edge_joined', 0.1022, 0.1013),
  ('chair_seat', 2, 'height', 0.4887, 0.0225),
  ('chair_seat', 2, 'length', -0.6654, 0.06224),
  ('chair_seat', 2, 'rectangularity', 0.8663, 0.0464),
  ('chair_seat', 2, 'spread_length', -0.7155, 0.06166),
  ('chair_seat', 2, 'spread_width', -0.9037, 0.09969),
  ('chair_seat', 2, 'tilt_deg', 0.9541, 0.5356),
  ('chair_seat', 2, 'width', -0.7844, 0.07555),
  ('chair_seat', 2, 'z_max', 0.4941, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4849, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.1339, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'area_m2', -2.062, 0.2762),
  ('chair_seat', 3, 'aspect', 0.4968, 0.1689),
  ('chair_seat', 3, 'behind', 0.5732, 0.2062),
  ('chair_seat', 3, 'edge_free', 0.5525, 0.1735),
  ('chair_seat', 3, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 3, 'edge_joined', 0.08586, 0.08623),
  ('chair_seat', 3, 'height', 0.4629, 0.02768),
  ('chair_seat', 3, 'length', -0.6285, 0.1864),
  ('chair_seat', 3, 'rectangularity', 0.7417, 0.09436),
  ('chair_seat', 3, 'spread_length', -0.7148, 0.143),
  ('chair_seat', 3, 'spread_width', -1.323, 0.1674),
  ('chair_seat', 3, 'tilt_deg', 1.482, 1.156),
  ('chair_seat', 3, 'width', -1.125, 0.1619),
  ('chair_seat', 3, 'z_max', 0.4702, 0.02837),
  ('chair_seat', 3, 'z_min', 0.4573, 0.02817);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.1115, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'area_m2', -1.765, 0.2328),
  ('chair_seat', 4, 'aspect', 0.1286, 0.1075),
  ('chair_seat', 4, 'behind', 0.6703, 0.07423),
  ('chair_seat', 4, 'edge_free', 0.6442, 0.09149),
  ('chair_seat', 4, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 4, 'edge_joined', 0.04892, 0.05019),
  ('chair_seat', 4, 'height', 0.4997, 0.0225),
  ('chair_seat', 4, 'length', -0.6249, 0.1233),
  ('chair_seat', 4, 'rectangularity', 0.6865, 0.08949),
  ('chair_seat', 4, 'spread_length', -0.6843, 0.07029),
  ('chair_seat', 4, 'spread_width', -1.007, 0.1087),
  ('chair_seat', 4, 'tilt_deg', 1.205, 0.6996),
  ('chair_seat', 4, 'width', -0.7535, 0.1104),
  ('chair_seat', 4, 'z_max', 0.5063, 0.0225),
  ('chair_seat', 4, 'z_min', 0.4955, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.09848, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'area_m2', -1.933, 0.1675),
  ('chair_seat', 5, 'aspect', 0.1553, 0.08269),
  ('chair_seat', 5, 'behind', 0.6975, 0.05917),
  ('chair_seat', 5, 'edge_free', 0.4322, 0.08827),
  ('chair_seat', 5, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 5, 'edge_joined', 0.2166, 0.09432),
  ('chair_seat', 5, 'height', 0.4838, 0.02802),
  ('chair_seat', 5, 'length', -0.7188, 0.0715),
  ('chair_seat', 5, 'rectangularity', 0.7217, 0.1055),
  ('chair_seat', 5, 'spread_length', -0.7143, 0.1064),
  ('chair_seat', 5, 'spread_width', -1.07, 0.1095),
  ('chair_seat', 5, 'tilt_deg', 1.382, 0.85),
  ('chair_seat', 5, 'width', -0.8741, 0.09577),
  ('chair_seat', 5, 'z_max', 0.4905, 0.02825),
  ('chair_seat', 5, 'z_min', 0.4789, 0.02835);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.0956, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'area_m2', -3.132, 0.3123),
  ('chair_seat', 6, 'aspect', 0.4885, 0.1696),
  ('chair_seat', 6, 'behind', 0.381, 0.3028),
  ('chair_seat', 6, 'edge_free', 0.5525, 0.1536),
  ('chair_seat', 6, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 6, 'edge_joined', 0.04727, 0.07799),
  ('chair_seat', 6, 'height', 0.4767, 0.03797),
  ('chair_seat', 6, 'length', -1.122, 0.1529),
  ('chair_seat', 6, 'rectangularity', 0.6754, 0.07088),
  ('chair_seat', 6, 'spread_length', -1.21, 0.2129),
  ('chair_seat', 6, 'spread_width', -1.827, 0.1933),
  ('chair_seat', 6, 'tilt_deg', 2.353, 1.263),
  ('chair_seat', 6, 'width', -1.61, 0.1687),
  ('chair_seat', 6, 'z_max', 0.4827, 0.03719),
  ('chair_seat', 6, 'z_min', 0.4719, 0.03872);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.06677, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'area_m2', -2.759, 0.2972),
  ('chair_seat', 7, 'aspect', 0.8956, 0.1872),
  ('chair_seat', 7, 'behind', 0.6747, 0.1588),
  ('chair_seat', 7, 'edge_free', 0.6458, 0.2154),
  ('chair_seat', 7, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 7, 'edge_joined', 0.01742, 0.02619),
  ('chair_seat', 7, 'height', 0.4797, 0.0225),
  ('chair_seat', 7, 'length', -0.7543, 0.1102),
  ('chair_seat', 7, 'rectangularity', 0.7153, 0.1243),
  ('chair_seat', 7, 'spread_length', -0.8169, 0.1511),
  ('chair_seat', 7, 'spread_width', -1.872, 0.1771),
  ('chair_seat', 7, 'tilt_deg', 2.189, 1.422),
  ('chair_seat', 7, 'width', -1.65, 0.2026),
  ('chair_seat', 7, 'z_max', 0.4854, 0.0225),
  ('chair_seat', 7, 'z_min', 0.4755, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.05857, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'area_m2', -2.328, 0.1519),
  ('chair_seat', 8, 'aspect', 0.1709, 0.1054),
  ('chair_seat', 8, 'behind', 0.6801, 0.0665),
  ('chair_seat', 8, 'edge_free', 0.6031, 0.07647),
  ('chair_seat', 8, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 8, 'edge_joined', 0.01865, 0.02959),
  ('chair_seat', 8, 'height', 0.4486, 0.02958),
  ('chair_seat', 8, 'length', -0.7383, 0.05978),
  ('chair_seat', 8, 'rectangularity', 0.5144, 0.05949),
  ('chair_seat', 8, 'spread_length', -0.7063, 0.1062),
  ('chair_seat', 8, 'spread_width', -1.306, 0.1432),
  ('chair_seat', 8, 'tilt_deg', 1.416, 0.894),
  ('chair_seat', 8, 'width', -0.9092, 0.113),
  ('chair_seat', 8, 'z_max', 0.4548, 0.02959),
  ('chair_seat', 8, 'z_min', 0.4443, 0.02902);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.04526, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'area_m2', -2.605, 0.1738),
  ('chair_seat', 9, 'aspect', 0.7826, 0.2026),
  ('chair_seat', 9, 'behind', 0.6546, 0.2027),
  ('chair_seat', 9, 'edge_free', 0.4527, 0.1129),
  ('chair_seat', 9, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 9, 'edge_joined', 0.1182, 0.07203),
  ('chair_seat', 9, 'height', 0.4042, 0.2019),
  ('chair_seat', 9, 'length', -0.7477, 0.07502),
  ('chair_seat', 9, 'rectangularity', 0.7261, 0.06865),
  ('chair_seat', 9, 'spread_length', -0.7971, 0.1072),
  ('chair_seat', 9, 'spread_width', -1.73, 0.1518),
  ('chair_seat', 9, 'tilt_deg', 3.593, 2.083),
  ('chair_seat', 9, 'width', -1.53, 0.1676),
  ('chair_seat', 9, 'z_max', 0.4154, 0.2053),
  ('chair_seat', 9, 'z_min', 0.3963, 0.2001);

-- chair_back: 202 examples
UPDATE object_class SET prior = 0.02944 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.747, 0.5837)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3921, 0.2793)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.5236, 0.3063)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.806, 0.2035)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9456, 0.186)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_joined', 0.08901, 0.1414)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8154, 0.0898)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5396, 0.2843)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7743, 0.1298)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6847, 0.2308)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.128, 0.3845)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.63, 3.718)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9336, 0.3189)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.022, 0.09547)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4497, 0.1925)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_back';
DELETE FROM class_density WHERE class = 'chair_back';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1415, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'area_m2', -1.387, 0.1279),
  ('chair_back', 1, 'aspect', 0.2125, 0.09844),
  ('chair_back', 1, 'behind', 0.627, 0.2095),
  ('chair_back', 1, 'edge_free', 0.9263, 0.08911),
  ('chair_back', 1, 'edge_free_top', 0.9982, 0.02006),
  ('chair_back', 1, 'edge_joined', 0.01812, 0.02938),
  ('chair_back', 1, 'height', 0.7627, 0.04019),
  ('chair_back', 1, 'length', -0.5131, 0.07809),
  ('chair_back', 1, 'rectangularity', 0.8656, 0.06914),
  ('chair_back', 1, 'spread_length', -0.6494, 0.08632),
  ('chair_back', 1, 'spread_width', -0.8415, 0.1073),
  ('chair_back', 1, 'tilt_deg', 79.37, 3.73),
  ('chair_back', 1, 'width', -0.7256, 0.07486),
  ('chair_back', 1, 'z_max', 0.979, 0.04937),
  ('chair_back', 1, 'z_min', 0.3934, 0.05246);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.1317, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'area_m2', -1.735, 0.1616),
  ('chair_back', 2, 'aspect', 0.1556, 0.08541),
  ('chair_back', 2, 'behind', 0.2665, 0.3003),
  ('chair_back', 2, 'edge_free', 0.9274, 0.09295),
  ('chair_back', 2, 'edge_free_top', 0.9981, 0.02069),
  ('chair_back', 2, 'edge_joined', 0.01907, 0.03564),
  ('chair_back', 2, 'height', 0.8489, 0.07348),
  ('chair_back', 2, 'length', -0.712, 0.07352),
  ('chair_back', 2, 'rectangularity', 0.8611, 0.08257),
  ('chair_back', 2, 'spread_length', -0.7573, 0.06486),
  ('chair_back', 2, 'spread_width', -0.9922, 0.1391),
  ('chair_back', 2, 'tilt_deg', 81.93, 3.255),
  ('chair_back', 2, 'width', -0.8676, 0.07707),
  ('chair_back', 2, 'z_max', 1.027, 0.07328),
  ('chair_back', 2, 'z_min', 0.5715, 0.07397);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.1294, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'area_m2', -1.291, 0.2108),
  ('chair_back', 3, 'aspect', 0.435, 0.1324),
  ('chair_back', 3, 'behind', 0.5553, 0.2407),
  ('chair_back', 3, 'edge_free', 0.9044, 0.09346),
  ('chair_back', 3, 'edge_free_top', 0.9946, 0.02727),
  ('chair_back', 3, 'edge_joined', 0.05878, 0.064),
  ('chair_back', 3, 'height', 0.8508, 0.0434),
  ('chair_back', 3, 'length', -0.3168, 0.09301),
  ('chair_back', 3, 'rectangularity', 0.805, 0.07853),
  ('chair_back', 3, 'spread_length', -0.4982, 0.08517),
  ('chair_back', 3, 'spread_width', -0.9418, 0.2016),
  ('chair_back', 3, 'tilt_deg', 80.71, 3.392),
  ('chair_back', 3, 'width', -0.7518, 0.1277),
  ('chair_back', 3, 'z_max', 1.105, 0.04262),
  ('chair_back', 3, 'z_min', 0.3919, 0.06538);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.125, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'area_m2', -1.971, 0.2154),
  ('chair_back', 4, 'aspect', 0.6778, 0.1841),
  ('chair_back', 4, 'behind', 0.6191, 0.2546),
  ('chair_back', 4, 'edge_free', 0.7878, 0.1125),
  ('chair_back', 4, 'edge_free_top', 0.9755, 0.08355),
  ('chair_back', 4, 'edge_joined', 0.08044, 0.07871),
  ('chair_back', 4, 'height', 0.8424, 0.06359),
  ('chair_back', 4, 'length', -0.4494, 0.1286),
  ('chair_back', 4, 'rectangularity', 0.6859, 0.1146),
  ('chair_back', 4, 'spread_length', -0.6183, 0.1259),
  ('chair_back', 4, 'spread_width', -1.466, 0.1969),
  ('chair_back', 4, 'tilt_deg', 80.43, 2.545),
  ('chair_back', 4, 'width', -1.127, 0.1959),
  ('chair_back', 4, 'z_max', 1.077, 0.06557),
  ('chair_back', 4, 'z_min', 0.4681, 0.0915);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.09442, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'area_m2', -2.646, 0.3615),
  ('chair_back', 5, 'aspect', 0.4477, 0.2722),
  ('chair_back', 5, 'behind', 0.5275, 0.2716),
  ('chair_back', 5, 'edge_free', 0.7981, 0.1818),
  ('chair_back', 5, 'edge_free_top', 0.9902, 0.03187),
  ('chair_back', 5, 'edge_joined', 0.03615, 0.08088),
  ('chair_back', 5, 'height', 0.8766, 0.07573),
  ('chair_back', 5, 'length', -0.9385, 0.1464),
  ('chair_back', 5, 'rectangularity', 0.7404, 0.1321),
  ('chair_back', 5, 'spread_length', -1.064, 0.1825),
  ('chair_back', 5, 'spread_width', -1.627, 0.2438),
  ('chair_back', 5, 'tilt_deg', 79.58, 2.917),
  ('chair_back', 5, 'width', -1.386, 0.2317),
  ('chair_back', 5, 'z_max', 1.002, 0.06642),
  ('chair_back', 5, 'z_min', 0.6809, 0.0853);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.09286, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'area_m2', -1.482, 0.2682),
  ('chair_back', 6, 'aspect', 0.1462, 0.1251),
  ('chair_back', 6, 'behind', 0.5254, 0.2601),
  ('chair_back', 6, 'edge_free', 0.6056, 0.1545),
  ('chair_back', 6, 'edge_free_top', 0.9414, 0.1298),
  ('chair_back', 6, 'edge_joined', 0.2997, 0.1582),
  ('chair_back', 6, 'height', 0.8332, 0.07576),
  ('chair_back', 6, 'length', -0.5789, 0.1481),
  ('chair_back', 6, 'rectangularity', 0.8411, 0.06855),
  ('chair_back', 6, 'spread_length', -0.6689, 0.09979),
  ('chair_back', 6, 'spread_width', -0.832, 0.1409),
  ('chair_back', 6, 'tilt_deg', 80.79, 4.363),
  ('chair_back', 6, 'width', -0.7251, 0.1572),
  ('chair_back', 6, 'z_max', 1.048, 0.08803),
  ('chair_back', 6, 'z_min', 0.5091, 0.09795);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.08962, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'area_m2', -1.14, 0.2096),
  ('chair_back', 7, 'aspect', 0.651, 0.1311),
  ('chair_back', 7, 'behind', 0.6458, 0.1998),
  ('chair_back', 7, 'edge_free', 0.8377, 0.0884),
  ('chair_back', 7, 'edge_free_top', 0.9748, 0.04145),
  ('chair_back', 7, 'edge_joined', 0.1004, 0.08453),
  ('chair_back', 7, 'height', 0.7461, 0.06799),
  ('chair_back', 7, 'length', -0.0276, 0.1081),
  ('chair_back', 7, 'rectangularity', 0.6562, 0.09233),
  ('chair_back', 7, 'spread_length', -0.3609, 0.1468),
  ('chair_back', 7, 'spread_width', -0.8614, 0.1558),
  ('chair_back', 7, 'tilt_deg', 82.25, 3.275),
  ('chair_back', 7, 'width', -0.6787, 0.1112),
  ('chair_back', 7, 'z_max', 0.9962, 0.08239),
  ('chair_back', 7, 'z_min', 0.05549, 0.07133);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.06928, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'area_m2', -1.768, 0.1856),
  ('chair_back', 8, 'aspect', 0.2637, 0.18),
  ('chair_back', 8, 'behind', 0.7196, 0.08675),
  ('chair_back', 8, 'edge_free', 0.8262, 0.1439),
  ('chair_back', 8, 'edge_free_top', 0.9773, 0.04382),
  ('chair_back', 8, 'edge_joined', 0.07027, 0.08036),
  ('chair_back', 8, 'height', 0.7131, 0.04762),
  ('chair_back', 8, 'length', -0.6013, 0.1547),
  ('chair_back', 8, 'rectangularity', 0.7453, 0.07754),
  ('chair_back', 8, 'spread_length', -0.7756, 0.1304),
  ('chair_back', 8, 'spread_width', -1.104, 0.1098),
  ('chair_back', 8, 'tilt_deg', 79.19, 2.845),
  ('chair_back', 8, 'width', -0.865, 0.1414),
  ('chair_back', 8, 'z_max', 0.9001, 0.03805),
  ('chair_back', 8, 'z_min', 0.3776, 0.08367);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.04056, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'area_m2', -2.754, 0.2714),
  ('chair_back', 9, 'aspect', 0.8548, 0.1913),
  ('chair_back', 9, 'behind', 0.105, 0.1347),
  ('chair_back', 9, 'edge_free', 0.4641, 0.1938),
  ('chair_back', 9, 'edge_free_top', 0.6628, 0.303),
  ('chair_back', 9, 'edge_joined', 0.3792, 0.2402),
  ('chair_back', 9, 'height', 0.8748, 0.1089),
  ('chair_back', 9, 'length', -0.7577, 0.1395),
  ('chair_back', 9, 'rectangularity', 0.6903, 0.08938),
  ('chair_back', 9, 'spread_length', -0.8307, 0.1125),
  ('chair_back', 9, 'spread_width', -1.838, 0.1672),
  ('chair_back', 9, 'tilt_deg', 81.42, 2.463),
  ('chair_back', 9, 'width', -1.613, 0.1759),
  ('chair_back', 9, 'z_max', 1.062, 0.113),
  ('chair_back', 9, 'z_min', 0.6413, 0.1275);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 10, 0.03567, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 10, 'area_m2', -2.755, 0.3648),
  ('chair_back', 10, 'aspect', 0.4355, 0.2106),
  ('chair_back', 10, 'behind', 0.3882, 0.2669),
  ('chair_back', 10, 'edge_free', 0.364, 0.1482),
  ('chair_back', 10, 'edge_free_top', 0.2569, 0.1504),
  ('chair_back', 10, 'edge_joined', 0.07652, 0.1274),
  ('chair_back', 10, 'height', 0.6875, 0.2581),
  ('chair_back', 10, 'length', -0.9298, 0.2086),
  ('chair_back', 10, 'rectangularity', 0.6505, 0.1266),
  ('chair_back', 10, 'spread_length', -1.011, 0.1921),
  ('chair_back', 10, 'spread_width', -1.619, 0.1953),
  ('chair_back', 10, 'tilt_deg', 81.18, 4.529),
  ('chair_back', 10, 'width', -1.365, 0.188),
  ('chair_back', 10, 'z_max', 0.8471, 0.2464),
  ('chair_back', 10, 'z_min', 0.4955, 0.2719);

-- door: 82 examples
UPDATE object_class SET prior = 0.01195 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.301, 0.5253)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.7299, 0.2682)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.2254, 0.291)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.2082, 0.2929)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.3437, 0.4142)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_joined', 0.1923, 0.2484)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.151, 0.1868)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.6181, 0.2471)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8326, 0.1129)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4723, 0.276)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.2384, 0.3586)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.74, 0.7308)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1248, 0.343)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.048, 0.2672)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1644, 0.3238)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'door';
DELETE FROM class_density WHERE class = 'door';
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.3386, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'area_m2', 0.5014, 0.1244),
  ('door', 1, 'aspect', 0.8047, 0.1129),
  ('door', 1, 'behind', 0.007324, 0.0325),
  ('door', 1, 'edge_free', 0.006716, 0.03219),
  ('door', 1, 'edge_free_top', 0.01108, 0.04582),
  ('door', 1, 'edge_joined', 0.1126, 0.1521),
  ('door', 1, 'height', 1.114, 0.0816),
  ('door', 1, 'length', 0.7131, 0.03603),
  ('door', 1, 'rectangularity', 0.8908, 0.07714),
  ('door', 1, 'spread_length', 0.6212, 0.09067),
  ('door', 1, 'spread_width', -0.1806, 0.09193),
  ('door', 1, 'tilt_deg', 89.97, 0.45),
  ('door', 1, 'width', -0.09156, 0.114),
  ('door', 1, 'z_max', 2.051, 0.04823),
  ('door', 1, 'z_min', 0.008832, 0.03661);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.2618, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'area_m2', 0.568, 0.116),
  ('door', 2, 'aspect', 0.8109, 0.111),
  ('door', 2, 'behind', 0.5497, 0.1198),
  ('door', 2, 'edge_free', 0.4459, 0.218),
  ('door', 2, 'edge_free_top', 0.8096, 0.1493),
  ('door', 2, 'edge_joined', 0.2906, 0.2997),
  ('door', 2, 'height', 1.109, 0.08333),
  ('door', 2, 'length', 0.7793, 0.05608),
  ('door', 2, 'rectangularity', 0.839, 0.06705),
  ('door', 2, 'spread_length', 0.6026, 0.14),
  ('door', 2, 'spread_width', -0.1148, 0.1556),
  ('door', 2, 'tilt_deg', 89.97, 0.45),
  ('door', 2, 'width', -0.03166, 0.09884),
  ('door', 2, 'z_max', 2.177, 0.0952),
  ('door', 2, 'z_min', -0.002282, 0.0417);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.1314, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'area_m2', 0.1136, 0.6205),
  ('door', 3, 'aspect', 0.7195, 0.4464),
  ('door', 3, 'behind', 0.2812, 0.2652),
  ('door', 3, 'edge_free', 0.4337, 0.3291),
  ('door', 3, 'edge_free_top', 0.5541, 0.3166),
  ('door', 3, 'edge_joined', 0.2834, 0.2477),
  ('door', 3, 'height', 1.275, 0.1041),
  ('door', 3, 'length', 0.6142, 0.2102),
  ('door', 3, 'rectangularity', 0.6883, 0.1217),
  ('door', 3, 'spread_length', 0.3107, 0.2988),
  ('door', 3, 'spread_width', -0.3041, 0.4863),
  ('door', 3, 'tilt_deg', 89.93, 0.45),
  ('door', 3, 'width', -0.1052, 0.5405),
  ('door', 3, 'z_max', 2.211, 0.2453),
  ('door', 3, 'z_min', 0.3249, 0.233);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.1193, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'area_m2', 0.0736, 0.5023),
  ('door', 4, 'aspect', 0.6433, 0.2675),
  ('door', 4, 'behind', 0.06851, 0.1366),
  ('door', 4, 'edge_free', 0.04192, 0.07066),
  ('door', 4, 'edge_free_top', 0.04284, 0.08551),
  ('door', 4, 'edge_joined', 0.106, 0.09859),
  ('door', 4, 'height', 0.9875, 0.2888),
  ('door', 4, 'length', 0.4452, 0.1653),
  ('door', 4, 'rectangularity', 0.8463, 0.07951),
  ('door', 4, 'spread_length', 0.377, 0.1676),
  ('door', 4, 'spread_width', -0.3355, 0.4021),
  ('door', 4, 'tilt_deg', 88.76, 0.9457),
  ('door', 4, 'width', -0.1981, 0.3809),
  ('door', 4, 'z_max', 1.647, 0.4037),
  ('door', 4, 'z_min', 0.1994, 0.2102);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.09892, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'area_m2', -0.5958, 0.7225),
  ('door', 5, 'aspect', 0.4298, 0.268),
  ('door', 5, 'behind', 0.2449, 0.2851),
  ('door', 5, 'edge_free', 0.1655, 0.1641),
  ('door', 5, 'edge_free_top', 0.2504, 0.2306),
  ('door', 5, 'edge_joined', 0.1913, 0.1319),
  ('door', 5, 'height', 1.417, 0.1649),
  ('door', 5, 'length', 0.0374, 0.2969),
  ('door', 5, 'rectangularity', 0.7893, 0.0559),
  ('door', 5, 'spread_length', -0.0795, 0.2711),
  ('door', 5, 'spread_width', -0.5532, 0.448),
  ('door', 5, 'tilt_deg', 89.16, 1.147),
  ('door', 5, 'width', -0.3924, 0.4516),
  ('door', 5, 'z_max', 1.917, 0.268),
  ('door', 5, 'z_min', 0.9058, 0.1801);

-- window: 151 examples
UPDATE object_class SET prior = 0.02197 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', -0.004826, 0.6497)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.3374, 0.3341)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.02932, 0.0822)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.01064, 0.04603)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_joined', 0.1669, 0.2518)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.519, 0.1494)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.2672, 0.2664)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8408, 0.1434)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.2995, 0.2951)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.1416, 0.4733)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.65, 0.5367)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.07625, 0.3779)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.119, 0.1773)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 0.9574, 0.178)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'window';
DELETE FROM class_density WHERE class = 'window';
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.2627, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'area_m2', 0.4487, 0.1646),
  ('window', 1, 'aspect', 0.2022, 0.1236),
  ('window', 1, 'behind', 3.932e-07, 0.005),
  ('window', 1, 'edge_free', 0.001223, 0.008862),
  ('window', 1, 'edge_free_top', 0.0002488, 0.005),
  ('window', 1, 'edge_joined', 0.03745, 0.04867),
  ('window', 1, 'height', 1.542, 0.1023),
  ('window', 1, 'length', 0.3632, 0.08942),
  ('window', 1, 'rectangularity', 0.9299, 0.05928),
  ('window', 1, 'spread_length', 0.453, 0.09277),
  ('window', 1, 'spread_width', 0.1922, 0.1277),
  ('window', 1, 'tilt_deg', 89.68, 0.4807),
  ('window', 1, 'width', 0.161, 0.1212),
  ('window', 1, 'z_max', 2.205, 0.1217),
  ('window', 1, 'z_min', 0.8921, 0.0539);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1487, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'area_m2', 0.07339, 0.1932),
  ('window', 2, 'aspect', 0.3765, 0.1864),
  ('window', 2, 'behind', 6.946e-07, 0.005),
  ('window', 2, 'edge_free', 0.009432, 0.0202),
  ('window', 2, 'edge_free_top', 0.0004579, 0.00582),
  ('window', 2, 'edge_joined', 0.1274, 0.1428),
  ('window', 2, 'height', 1.509, 0.1014),
  ('window', 2, 'length', 0.3533, 0.06798),
  ('window', 2, 'rectangularity', 0.7879, 0.135),
  ('window', 2, 'spread_length', 0.3752, 0.1754),
  ('window', 2, 'spread_width', -0.05282, 0.1876),
  ('window', 2, 'tilt_deg', 89.84, 0.45),
  ('window', 2, 'width', -0.02322, 0.1815),
  ('window', 2, 'z_max', 2.256, 0.09095),
  ('window', 2, 'z_min', 0.8636, 0.04986);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.1205, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'area_m2', -0.09321, 0.1426),
  ('window', 3, 'aspect', 0.1118, 0.08003),
  ('window', 3, 'behind', 8.575e-07, 0.005),
  ('window', 3, 'edge_free', 0.001516, 0.01173),
  ('window', 3, 'edge_free_top', 0.0005708, 0.006414),
  ('window', 3, 'edge_joined', 0.1092, 0.1281),
  ('window', 3, 'height', 1.464, 0.1329),
  ('window', 3, 'length', 0.08079, 0.08146),
  ('window', 3, 'rectangularity', 0.8728, 0.08642),
  ('window', 3, 'spread_length', 0.1213, 0.0999),
  ('window', 3, 'spread_width', -0.1422, 0.1535),
  ('window', 3, 'tilt_deg', 89.26, 0.6562),
  ('window', 3, 'width', -0.03102, 0.09661),
  ('window', 3, 'z_max', 1.969, 0.08277),
  ('window', 3, 'z_min', 0.9412, 0.07826);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.119, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'area_m2', 0.1289, 0.177),
  ('window', 4, 'aspect', 0.1463, 0.08681),
  ('window', 4, 'behind', 8.678e-07, 0.005),
  ('window', 4, 'edge_free', 0.001534, 0.01179),
  ('window', 4, 'edge_free_top', 0.0005492, 0.006307),
  ('window', 4, 'edge_joined', 0.1214, 0.1215),
  ('window', 4, 'height', 1.462, 0.06263),
  ('window', 4, 'length', 0.1868, 0.08502),
  ('window', 4, 'rectangularity', 0.9086, 0.04812),
  ('window', 4, 'spread_length', 0.291, 0.0676),
  ('window', 4, 'spread_width', 0.0422, 0.1219),
  ('window', 4, 'tilt_deg', 89.69, 0.45),
  ('window', 4, 'width', 0.04047, 0.1079),
  ('window', 4, 'z_max', 2.057, 0.04729),
  ('window', 4, 'z_min', 0.9165, 0.05534);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.09584, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'area_m2', -1.032, 0.4484),
  ('window', 5, 'aspect', 0.9525, 0.3153),
  ('window', 5, 'behind', 1.078e-06, 0.005),
  ('window', 5, 'edge_free', 0.001906, 0.01296),
  ('window', 5, 'edge_free_top', 0.00109, 0.008385),
  ('window', 5, 'edge_joined', 0.1546, 0.2032),
  ('window', 5, 'height', 1.357, 0.1448),
  ('window', 5, 'length', 0.09714, 0.1752),
  ('window', 5, 'rectangularity', 0.769, 0.09586),
  ('window', 5, 'spread_length', 0.08246, 0.2163),
  ('window', 5, 'spread_width', -1.071, 0.3586),
  ('window', 5, 'tilt_deg', 89.23, 0.8257),
  ('window', 5, 'width', -0.8553, 0.3164),
  ('window', 5, 'z_max', 1.889, 0.2339),
  ('window', 5, 'z_min', 0.9122, 0.05598);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.09565, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'area_m2', -0.2978, 0.4814),
  ('window', 6, 'aspect', 0.2441, 0.1962),
  ('window', 6, 'behind', 0.0001642, 0.005),
  ('window', 6, 'edge_free', 0.1815, 0.1454),
  ('window', 6, 'edge_free_top', 0.1018, 0.09806),
  ('window', 6, 'edge_joined', 0.3521, 0.2932),
  ('window', 6, 'height', 1.586, 0.1456),
  ('window', 6, 'length', 0.2157, 0.1477),
  ('window', 6, 'rectangularity', 0.663, 0.1956),
  ('window', 6, 'spread_length', 0.2066, 0.173),
  ('window', 6, 'spread_width', -0.2345, 0.3018),
  ('window', 6, 'tilt_deg', 89.86, 0.45),
  ('window', 6, 'width', -0.02841, 0.2052),
  ('window', 6, 'z_max', 2.103, 0.1069),
  ('window', 6, 'z_min', 1.07, 0.1779);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.07169, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'area_m2', -0.7845, 0.5402),
  ('window', 7, 'aspect', 0.5332, 0.2254),
  ('window', 7, 'behind', 1.441e-06, 0.005),
  ('window', 7, 'edge_free', 0.1248, 0.1082),
  ('window', 7, 'edge_free_top', 0.002608, 0.009245),
  ('window', 7, 'edge_joined', 0.6882, 0.2291),
  ('window', 7, 'height', 1.755, 0.1002),
  ('window', 7, 'length', -0.003999, 0.2561),
  ('window', 7, 'rectangularity', 0.7943, 0.1011),
  ('window', 7, 'spread_length', -0.126, 0.2923),
  ('window', 7, 'spread_width', -0.7178, 0.2508),
  ('window', 7, 'tilt_deg', 89.8, 0.45),
  ('window', 7, 'width', -0.5372, 0.2671),
  ('window', 7, 'z_max', 2.121, 0.1441),
  ('window', 7, 'z_min', 1.449, 0.1097);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.03585, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'area_m2', 1.308, 0.2725),
  ('window', 8, 'aspect', 0.7842, 0.2831),
  ('window', 8, 'behind', 2.882e-06, 0.005),
  ('window', 8, 'edge_free', 0.01298, 0.02285),
  ('window', 8, 'edge_free_top', 0.003203, 0.0104),
  ('window', 8, 'edge_joined', 0.126, 0.1154),
  ('window', 8, 'height', 1.521, 0.04394),
  ('window', 8, 'length', 1.168, 0.1479),
  ('window', 8, 'rectangularity', 0.8058, 0.1354),
  ('window', 8, 'spread_length', 1.112, 0.1762),
  ('window', 8, 'spread_width', 0.3261, 0.1229),
  ('window', 8, 'tilt_deg', 89.89, 0.45),
  ('window', 8, 'width', 0.3834, 0.285),
  ('window', 8, 'z_max', 2.429, 0.3569),
  ('window', 8, 'z_min', 0.7925, 0.2297);

-- whiteboard: 76 examples
UPDATE object_class SET prior = 0.01104 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.1784, 0.7364)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4309, 0.2884)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.001057, 0.006658)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.04716, 0.08968)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.0587, 0.1013)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_joined', 0.7087, 0.2557)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.398, 0.1207)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.4224, 0.3701)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.7952, 0.1001)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.264, 0.3528)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.2679, 0.4184)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.61, 0.9164)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', -0.00589, 0.4448)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 2.004, 0.278)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.8323, 0.1922)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'whiteboard';
DELETE FROM class_density WHERE class = 'whiteboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.3006, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'area_m2', 0.6309, 0.2006),
  ('whiteboard', 1, 'aspect', 0.521, 0.1352),
  ('whiteboard', 1, 'behind', 6.998e-05, 0.005),
  ('whiteboard', 1, 'edge_free', 0.03825, 0.03837),
  ('whiteboard', 1, 'edge_free_top', 0.03719, 0.04318),
  ('whiteboard', 1, 'edge_joined', 0.84, 0.1068),
  ('whiteboard', 1, 'height', 1.413, 0.06704),
  ('whiteboard', 1, 'length', 0.6852, 0.1275),
  ('whiteboard', 1, 'rectangularity', 0.8085, 0.0788),
  ('whiteboard', 1, 'spread_length', 0.5181, 0.1332),
  ('whiteboard', 1, 'spread_width', -0.1286, 0.1158),
  ('whiteboard', 1, 'tilt_deg', 89.95, 0.45),
  ('whiteboard', 1, 'width', 0.1641, 0.1154),
  ('whiteboard', 1, 'z_max', 2.063, 0.1342),
  ('whiteboard', 1, 'z_min', 0.8611, 0.05553);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.1855, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'area_m2', -0.1211, 0.306),
  ('whiteboard', 2, 'aspect', 0.3157, 0.2077),
  ('whiteboard', 2, 'behind', 0.0001134, 0.005),
  ('whiteboard', 2, 'edge_free', 0.01554, 0.01917),
  ('whiteboard', 2, 'edge_free_top', 0.00835, 0.01793),
  ('whiteboard', 2, 'edge_joined', 0.7949, 0.1219),
  ('whiteboard', 2, 'height', 1.381, 0.08549),
  ('whiteboard', 2, 'length', 0.2292, 0.1292),
  ('whiteboard', 2, 'rectangularity', 0.7742, 0.08394),
  ('whiteboard', 2, 'spread_length', 0.0625, 0.1656),
  ('whiteboard', 2, 'spread_width', -0.4211, 0.1578),
  ('whiteboard', 2, 'tilt_deg', 89.94, 0.45),
  ('whiteboard', 2, 'width', -0.08653, 0.2615),
  ('whiteboard', 2, 'z_max', 2.005, 0.1024),
  ('whiteboard', 2, 'z_min', 0.886, 0.103);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.1623, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'area_m2', -0.8215, 0.7411),
  ('whiteboard', 3, 'aspect', 0.6149, 0.3853),
  ('whiteboard', 3, 'behind', 0.0001296, 0.005),
  ('whiteboard', 3, 'edge_free', 0.01125, 0.02432),
  ('whiteboard', 3, 'edge_free_top', 0.1113, 0.03562),
  ('whiteboard', 3, 'edge_joined', 0.4648, 0.2791),
  ('whiteboard', 3, 'height', 1.266, 0.1297),
  ('whiteboard', 3, 'length', 0.01445, 0.3309),
  ('whiteboard', 3, 'rectangularity', 0.7994, 0.09965),
  ('whiteboard', 3, 'spread_length', -0.1233, 0.3226),
  ('whiteboard', 3, 'spread_width', -0.7645, 0.4956),
  ('whiteboard', 3, 'tilt_deg', 88.17, 1.232),
  ('whiteboard', 3, 'width', -0.6005, 0.4807),
  ('whiteboard', 3, 'z_max', 1.619, 0.2011),
  ('whiteboard', 3, 'z_min', 0.8568, 0.1698);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.151, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'area_m2', 0.2933, 0.1626),
  ('whiteboard', 4, 'aspect', 0.1637, 0.09093),
  ('whiteboard', 4, 'behind', 0.01073, 0.02616),
  ('whiteboard', 4, 'edge_free', 0.03281, 0.02463),
  ('whiteboard', 4, 'edge_free_top', 0.03404, 0.03515),
  ('whiteboard', 4, 'edge_joined', 0.8299, 0.09209),
  ('whiteboard', 4, 'height', 1.498, 0.04775),
  ('whiteboard', 4, 'length', 0.3085, 0.09377),
  ('whiteboard', 4, 'rectangularity', 0.8533, 0.02697),
  ('whiteboard', 4, 'spread_length', 0.1954, 0.09769),
  ('whiteboard', 4, 'spread_width', -0.02018, 0.08725),
  ('whiteboard', 4, 'tilt_deg', 89.94, 0.45),
  ('whiteboard', 4, 'width', 0.1447, 0.08989),
  ('whiteboard', 4, 'z_max', 2.103, 0.08406),
  ('whiteboard', 4, 'z_min', 0.8827, 0.04801);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.0811, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'area_m2', 0.1809, 0.5772),
  ('whiteboard', 5, 'aspect', 0.5024, 0.2373),
  ('whiteboard', 5, 'behind', 0.0002594, 0.005),
  ('whiteboard', 5, 'edge_free', 0.2829, 0.08139),
  ('whiteboard', 5, 'edge_free_top', 0.3052, 0.07712),
  ('whiteboard', 5, 'edge_joined', 0.5628, 0.07809),
  ('whiteboard', 5, 'height', 1.44, 0.07187),
  ('whiteboard', 5, 'length', 0.4593, 0.194),
  ('whiteboard', 5, 'rectangularity', 0.7939, 0.05764),
  ('whiteboard', 5, 'spread_length', 0.3181, 0.1787),
  ('whiteboard', 5, 'spread_width', -0.2889, 0.3818),
  ('whiteboard', 5, 'tilt_deg', 89.71, 0.45),
  ('whiteboard', 5, 'width', -0.04311, 0.3661),
  ('whiteboard', 5, 'z_max', 2.029, 0.1017),
  ('whiteboard', 5, 'z_min', 0.8516, 0.08673);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.06952, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'area_m2', 1.1, 0.3943),
  ('whiteboard', 6, 'aspect', 0.4335, 0.09458),
  ('whiteboard', 6, 'behind', 0.0003026, 0.005),
  ('whiteboard', 6, 'edge_free', 0.01274, 0.02085),
  ('whiteboard', 6, 'edge_free_top', 0.03323, 0.04037),
  ('whiteboard', 6, 'edge_joined', 0.3868, 0.194),
  ('whiteboard', 6, 'height', 1.412, 0.1007),
  ('whiteboard', 6, 'length', 0.985, 0.2293),
  ('whiteboard', 6, 'rectangularity', 0.6576, 0.08568),
  ('whiteboard', 6, 'spread_length', 0.7145, 0.2257),
  ('whiteboard', 6, 'spread_width', 0.1827, 0.2639),
  ('whiteboard', 6, 'tilt_deg', 89.72, 0.45),
  ('whiteboard', 6, 'width', 0.5516, 0.2395),
  ('whiteboard', 6, 'z_max', 2.453, 0.406),
  ('whiteboard', 6, 'z_min', 0.39, 0.2629);

-- shelf: 356 examples
UPDATE object_class SET prior = 0.05195 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.488, 0.7971)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.9492, 0.4352)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.556, 0.3194)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3478, 0.1654)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4917, 0.3512)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_joined', 0.2822, 0.2392)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9555, 0.4728)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.08135, 0.5293)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.7011, 0.1258)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.234, 0.5306)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.23, 0.3826)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 55.79, 42.56)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.034, 0.3589)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.295, 0.6091)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5704, 0.5809)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'shelf';
DELETE FROM class_density WHERE class = 'shelf';
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.1499, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'area_m2', -1.504, 0.4448),
  ('shelf', 1, 'aspect', 0.8033, 0.2862),
  ('shelf', 1, 'behind', 0.743, 0.0904),
  ('shelf', 1, 'edge_free', 0.3333, 0.1113),
  ('shelf', 1, 'edge_free_top', 0.4917, 0.1108),
  ('shelf', 1, 'edge_joined', 0.5217, 0.1828),
  ('shelf', 1, 'height', 1.507, 0.4274),
  ('shelf', 1, 'length', -0.195, 0.2732),
  ('shelf', 1, 'rectangularity', 0.7463, 0.1257),
  ('shelf', 1, 'spread_length', -0.366, 0.2969),
  ('shelf', 1, 'spread_width', -1.105, 0.2953),
  ('shelf', 1, 'tilt_deg', 2.721, 3.758),
  ('shelf', 1, 'width', -0.9983, 0.1865),
  ('shelf', 1, 'z_max', 1.52, 0.4264),
  ('shelf', 1, 'z_min', 1.495, 0.4286);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.1434, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'area_m2', -1.881, 0.5307),
  ('shelf', 2, 'aspect', 0.8825, 0.368),
  ('shelf', 2, 'behind', 0.7141, 0.1056),
  ('shelf', 2, 'edge_free', 0.4322, 0.0711),
  ('shelf', 2, 'edge_free_top', 0.4917, 0.1108),
  ('shelf', 2, 'edge_joined', 0.2716, 0.1345),
  ('shelf', 2, 'height', 0.5527, 0.1403),
  ('shelf', 2, 'length', -0.281, 0.3695),
  ('shelf', 2, 'rectangularity', 0.658, 0.1173),
  ('shelf', 2, 'spread_length', -0.4085, 0.3751),
  ('shelf', 2, 'spread_width', -1.422, 0.2861),
  ('shelf', 2, 'tilt_deg', 3.902, 4.134),
  ('shelf', 2, 'width', -1.163, 0.2712),
  ('shelf', 2, 'z_max', 0.5691, 0.1432),
  ('shelf', 2, 'z_min', 0.5389, 0.1438);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.1242, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'area_m2', -1.024, 0.2622),
  ('shelf', 3, 'aspect', 1.087, 0.2372),
  ('shelf', 3, 'behind', 0.7409, 0.09737),
  ('shelf', 3, 'edge_free', 0.4315, 0.05751),
  ('shelf', 3, 'edge_free_top', 0.6444, 0.2248),
  ('shelf', 3, 'edge_joined', 0.2309, 0.1895),
  ('shelf', 3, 'height', 0.7271, 0.1375),
  ('shelf', 3, 'length', 0.2633, 0.1471),
  ('shelf', 3, 'rectangularity', 0.6395, 0.1107),
  ('shelf', 3, 'spread_length', 0.1177, 0.1784),
  ('shelf', 3, 'spread_width', -1.113, 0.1909),
  ('shelf', 3, 'tilt_deg', 89.02, 3.889),
  ('shelf', 3, 'width', -0.8237, 0.2074),
  ('shelf', 3, 'z_max', 1.313, 0.1892),
  ('shelf', 3, 'z_min', 0.02272, 0.0734);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.1137, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'area_m2', -0.585, 0.2681),
  ('shelf', 4, 'aspect', 1.503, 0.1674),
  ('shelf', 4, 'behind', 0.7133, 0.1242),
  ('shelf', 4, 'edge_free', 0.4366, 0.05543),
  ('shelf', 4, 'edge_free_top', 0.5947, 0.3147),
  ('shelf', 4, 'edge_joined', 0.1734, 0.1611),
  ('shelf', 4, 'height', 1.048, 0.1081),
  ('shelf', 4, 'length', 0.6389, 0.1146),
  ('shelf', 4, 'rectangularity', 0.706, 0.1011),
  ('shelf', 4, 'spread_length', 0.5049, 0.1518),
  ('shelf', 4, 'spread_width', -1.089, 0.1791),
  ('shelf', 4, 'tilt_deg', 89.09, 4.006),
  ('shelf', 4, 'width', -0.8643, 0.1584),
  ('shelf', 4, 'z_max', 1.929, 0.1956),
  ('shelf', 4, 'z_min', 0.02532, 0.06747);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.08386, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'area_m2', -1.631, 0.2995),
  ('shelf', 5, 'aspect', 0.5933, 0.2259),
  ('shelf', 5, 'behind', 0.6113, 0.2652),
  ('shelf', 5, 'edge_free', 0.3357, 0.1259),
  ('shelf', 5, 'edge_free_top', 0.5066, 0.303),
  ('shelf', 5, 'edge_joined', 0.192, 0.189),
  ('shelf', 5, 'height', 1.184, 0.2274),
  ('shelf', 5, 'length', -0.3059, 0.186),
  ('shelf', 5, 'rectangularity', 0.6655, 0.1233),
  ('shelf', 5, 'spread_length', -0.5691, 0.2604),
  ('shelf', 5, 'spread_width', -1.081, 0.1682),
  ('shelf', 5, 'tilt_deg', 88.45, 4.678),
  ('shelf', 5, 'width', -0.8992, 0.1399),
  ('shelf', 5, 'z_max', 1.537, 0.2609),
  ('shelf', 5, 'z_min', 0.8161, 0.2718);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.0799, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'area_m2', -1.56, 0.5316),
  ('shelf', 6, 'aspect', 1.242, 0.2486),
  ('shelf', 6, 'behind', 0.5479, 0.2965),
  ('shelf', 6, 'edge_free', 0.5179, 0.1881),
  ('shelf', 6, 'edge_free_top', 0.6432, 0.3078),
  ('shelf', 6, 'edge_joined', 0.04133, 0.0462),
  ('shelf', 6, 'height', 1.049, 0.2562),
  ('shelf', 6, 'length', 0.04291, 0.2972),
  ('shelf', 6, 'rectangularity', 0.6795, 0.119),
  ('shelf', 6, 'spread_length', -0.145, 0.3407),
  ('shelf', 6, 'spread_width', -1.423, 0.2721),
  ('shelf', 6, 'tilt_deg', 88.64, 4.76),
  ('shelf', 6, 'width', -1.199, 0.2536),
  ('shelf', 6, 'z_max', 1.568, 0.3205),
  ('shelf', 6, 'z_min', 0.4954, 0.3237);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.07554, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'area_m2', -1.29, 0.608),
  ('shelf', 7, 'aspect', 0.4086, 0.271),
  ('shelf', 7, 'behind', 0.1042, 0.1941),
  ('shelf', 7, 'edge_free', 0.09088, 0.09524),
  ('shelf', 7, 'edge_free_top', 0.09821, 0.1565),
  ('shelf', 7, 'edge_joined', 0.1848, 0.1769),
  ('shelf', 7, 'height', 0.9996, 0.3958),
  ('shelf', 7, 'length', -0.2541, 0.3387),
  ('shelf', 7, 'rectangularity', 0.7102, 0.1495),
  ('shelf', 7, 'spread_length', -0.3543, 0.3173),
  ('shelf', 7, 'spread_width', -0.864, 0.3927),
  ('shelf', 7, 'tilt_deg', 88.42, 4.899),
  ('shelf', 7, 'width', -0.6627, 0.3962),
  ('shelf', 7, 'z_max', 1.347, 0.4622),
  ('shelf', 7, 'z_min', 0.6143, 0.3191);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.07268, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'area_m2', -2.558, 0.8341),
  ('shelf', 8, 'aspect', 0.7427, 0.3886),
  ('shelf', 8, 'behind', 0.02313, 0.04305),
  ('shelf', 8, 'edge_free', 0.2636, 0.168),
  ('shelf', 8, 'edge_free_top', 0.2822, 0.1364),
  ('shelf', 8, 'edge_joined', 0.4077, 0.2598),
  ('shelf', 8, 'height', 0.1078, 0.06737),
  ('shelf', 8, 'length', -0.753, 0.5689),
  ('shelf', 8, 'rectangularity', 0.7395, 0.08006),
  ('shelf', 8, 'spread_length', -0.8291, 0.538),
  ('shelf', 8, 'spread_width', -1.635, 0.3509),
  ('shelf', 8, 'tilt_deg', 7.347, 14.74),
  ('shelf', 8, 'width', -1.496, 0.3514),
  ('shelf', 8, 'z_max', 0.1288, 0.08672),
  ('shelf', 8, 'z_min', 0.08595, 0.07454);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.05442, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'area_m2', -0.6523, 0.2373),
  ('shelf', 9, 'aspect', 1.294, 0.2035),
  ('shelf', 9, 'behind', 0.6412, 0.1989),
  ('shelf', 9, 'edge_free', 0.3234, 0.09981),
  ('shelf', 9, 'edge_free_top', 0.6099, 0.242),
  ('shelf', 9, 'edge_joined', 0.5393, 0.2055),
  ('shelf', 9, 'height', 1.124, 0.2028),
  ('shelf', 9, 'length', 0.4333, 0.2019),
  ('shelf', 9, 'rectangularity', 0.8008, 0.0488),
  ('shelf', 9, 'spread_length', 0.2201, 0.2192),
  ('shelf', 9, 'spread_width', -0.8907, 0.1177),
  ('shelf', 9, 'tilt_deg', 88.15, 5.718),
  ('shelf', 9, 'width', -0.8604, 0.1034),
  ('shelf', 9, 'z_max', 1.866, 0.2984),
  ('shelf', 9, 'z_min', 0.2913, 0.297);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.05243, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'area_m2', -2.779, 0.562),
  ('shelf', 10, 'aspect', 0.8624, 0.3958),
  ('shelf', 10, 'behind', 0.03795, 0.05846),
  ('shelf', 10, 'edge_free', 0.07418, 0.105),
  ('shelf', 10, 'edge_free_top', 0.09029, 0.1248),
  ('shelf', 10, 'edge_joined', 0.1978, 0.1702),
  ('shelf', 10, 'height', 1.252, 0.243),
  ('shelf', 10, 'length', -0.8061, 0.4528),
  ('shelf', 10, 'rectangularity', 0.7424, 0.07698),
  ('shelf', 10, 'spread_length', -0.9066, 0.463),
  ('shelf', 10, 'spread_width', -1.893, 0.178),
  ('shelf', 10, 'tilt_deg', 82.83, 18.75),
  ('shelf', 10, 'width', -1.668, 0.2319),
  ('shelf', 10, 'z_max', 1.373, 0.2309),
  ('shelf', 10, 'z_min', 1.118, 0.2756);

-- cabinet: 448 examples
UPDATE object_class SET prior = 0.06511 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.8089, 0.9444)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6179, 0.4221)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.5503, 0.2165)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.4508, 0.2764)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.7486, 0.3236)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_joined', 0.268, 0.3111)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7714, 0.3535)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.07113, 0.4979)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7331, 0.1323)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.09306, 0.4964)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7562, 0.5087)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 76.09, 31.98)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.551, 0.4738)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.232, 0.5811)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2283, 0.3472)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'cabinet';
DELETE FROM class_density WHERE class = 'cabinet';
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.1303, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'area_m2', -0.6991, 0.4303),
  ('cabinet', 1, 'aspect', 0.9142, 0.5316),
  ('cabinet', 1, 'behind', 0.4379, 0.2785),
  ('cabinet', 1, 'edge_free', 0.5722, 0.2806),
  ('cabinet', 1, 'edge_free_top', 0.7973, 0.308),
  ('cabinet', 1, 'edge_joined', 0.1847, 0.2343),
  ('cabinet', 1, 'height', 1.271, 0.178),
  ('cabinet', 1, 'length', 0.2613, 0.3128),
  ('cabinet', 1, 'rectangularity', 0.7461, 0.119),
  ('cabinet', 1, 'spread_length', 0.02524, 0.2816),
  ('cabinet', 1, 'spread_width', -0.8424, 0.401),
  ('cabinet', 1, 'tilt_deg', 89.53, 2.566),
  ('cabinet', 1, 'width', -0.6529, 0.4007),
  ('cabinet', 1, 'z_max', 1.854, 0.2971),
  ('cabinet', 1, 'z_min', 0.5371, 0.3293);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.1171, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'area_m2', 0.002917, 0.2286),
  ('cabinet', 2, 'aspect', 1.07, 0.2251),
  ('cabinet', 2, 'behind', 0.6065, 0.1595),
  ('cabinet', 2, 'edge_free', 0.3788, 0.2521),
  ('cabinet', 2, 'edge_free_top', 0.7595, 0.2322),
  ('cabinet', 2, 'edge_joined', 0.4672, 0.3253),
  ('cabinet', 2, 'height', 1.063, 0.1321),
  ('cabinet', 2, 'length', 0.654, 0.1156),
  ('cabinet', 2, 'rectangularity', 0.7982, 0.09822),
  ('cabinet', 2, 'spread_length', 0.4931, 0.1523),
  ('cabinet', 2, 'spread_width', -0.5904, 0.1852),
  ('cabinet', 2, 'tilt_deg', 89.71, 2.637),
  ('cabinet', 2, 'width', -0.4164, 0.1864),
  ('cabinet', 2, 'z_max', 1.966, 0.239),
  ('cabinet', 2, 'z_min', 0.03417, 0.099);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.1145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'area_m2', -1.159, 0.2172),
  ('cabinet', 3, 'aspect', 0.1911, 0.1456),
  ('cabinet', 3, 'behind', 0.628, 0.1206),
  ('cabinet', 3, 'edge_free', 0.4528, 0.1978),
  ('cabinet', 3, 'edge_free_top', 0.6259, 0.3131),
  ('cabinet', 3, 'edge_joined', 0.1517, 0.1759),
  ('cabinet', 3, 'height', 0.3267, 0.05099),
  ('cabinet', 3, 'length', -0.2815, 0.1265),
  ('cabinet', 3, 'rectangularity', 0.6741, 0.09689),
  ('cabinet', 3, 'spread_length', -0.4588, 0.1097),
  ('cabinet', 3, 'spread_width', -0.7801, 0.1404),
  ('cabinet', 3, 'tilt_deg', 89.29, 2.761),
  ('cabinet', 3, 'width', -0.4726, 0.1313),
  ('cabinet', 3, 'z_max', 0.6793, 0.08862),
  ('cabinet', 3, 'z_min', -0.009811, 0.03316);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.1112, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'area_m2', -2.075, 0.4148),
  ('cabinet', 4, 'aspect', 0.6393, 0.3751),
  ('cabinet', 4, 'behind', 0.4861, 0.2462),
  ('cabinet', 4, 'edge_free', 0.3555, 0.2622),
  ('cabinet', 4, 'edge_free_top', 0.5437, 0.3652),
  ('cabinet', 4, 'edge_joined', 0.145, 0.1827),
  ('cabinet', 4, 'height', 0.511, 0.2284),
  ('cabinet', 4, 'length', -0.4843, 0.2723),
  ('cabinet', 4, 'rectangularity', 0.6421, 0.1343),
  ('cabinet', 4, 'spread_length', -0.6459, 0.2749),
  ('cabinet', 4, 'spread_width', -1.411, 0.2697),
  ('cabinet', 4, 'tilt_deg', 88.75, 2.9),
  ('cabinet', 4, 'width', -1.124, 0.2827),
  ('cabinet', 4, 'z_max', 0.7417, 0.2413),
  ('cabinet', 4, 'z_min', 0.2483, 0.2348);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.1044, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'area_m2', 0.6216, 0.3669),
  ('cabinet', 5, 'aspect', 0.5333, 0.2541),
  ('cabinet', 5, 'behind', 0.4311, 0.1055),
  ('cabinet', 5, 'edge_free', 0.6963, 0.1271),
  ('cabinet', 5, 'edge_free_top', 0.9696, 0.05111),
  ('cabinet', 5, 'edge_joined', 0.04026, 0.05521),
  ('cabinet', 5, 'height', 1.02, 0.2084),
  ('cabinet', 5, 'length', 0.668, 0.1567),
  ('cabinet', 5, 'rectangularity', 0.8383, 0.07323),
  ('cabinet', 5, 'spread_length', 0.5614, 0.1546),
  ('cabinet', 5, 'spread_width', -0.02067, 0.2924),
  ('cabinet', 5, 'tilt_deg', 89.71, 2.781),
  ('cabinet', 5, 'width', 0.1347, 0.2688),
  ('cabinet', 5, 'z_max', 1.854, 0.3716),
  ('cabinet', 5, 'z_min', -0.002553, 0.04417);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.07996, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'area_m2', -2.299, 0.6837),
  ('cabinet', 6, 'aspect', 0.5102, 0.293),
  ('cabinet', 6, 'behind', 0.6631, 0.1542),
  ('cabinet', 6, 'edge_free', 0.3429, 0.2114),
  ('cabinet', 6, 'edge_free_top', 0.5595, 0.3078),
  ('cabinet', 6, 'edge_joined', 0.2646, 0.2117),
  ('cabinet', 6, 'height', 0.5817, 0.05778),
  ('cabinet', 6, 'length', -0.7221, 0.3481),
  ('cabinet', 6, 'rectangularity', 0.7202, 0.1188),
  ('cabinet', 6, 'spread_length', -0.8353, 0.3538),
  ('cabinet', 6, 'spread_width', -1.418, 0.3917),
  ('cabinet', 6, 'tilt_deg', 17.65, 31.74),
  ('cabinet', 6, 'width', -1.232, 0.3935),
  ('cabinet', 6, 'z_max', 0.6107, 0.06882),
  ('cabinet', 6, 'z_min', 0.5459, 0.0846);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.07895, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'area_m2', -0.8659, 0.4878),
  ('cabinet', 7, 'aspect', 0.6768, 0.3298),
  ('cabinet', 7, 'behind', 0.644, 0.2004),
  ('cabinet', 7, 'edge_free', 0.1739, 0.1389),
  ('cabinet', 7, 'edge_free_top', 0.7486, 0.1022),
  ('cabinet', 7, 'edge_joined', 0.7471, 0.1599),
  ('cabinet', 7, 'height', 0.9412, 0.1366),
  ('cabinet', 7, 'length', 0.07844, 0.3335),
  ('cabinet', 7, 'rectangularity', 0.7137, 0.08711),
  ('cabinet', 7, 'spread_length', -0.1209, 0.3034),
  ('cabinet', 7, 'spread_width', -0.6777, 0.2769),
  ('cabinet', 7, 'tilt_deg', 2.45, 3.712),
  ('cabinet', 7, 'width', -0.5984, 0.2181),
  ('cabinet', 7, 'z_max', 0.9565, 0.1441),
  ('cabinet', 7, 'z_min', 0.9246, 0.1375);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.07783, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'area_m2', -0.6716, 0.3742),
  ('cabinet', 8, 'aspect', 0.5366, 0.2363),
  ('cabinet', 8, 'behind', 0.6464, 0.175),
  ('cabinet', 8, 'edge_free', 0.2009, 0.1587),
  ('cabinet', 8, 'edge_free_top', 0.5116, 0.3235),
  ('cabinet', 8, 'edge_joined', 0.6154, 0.2892),
  ('cabinet', 8, 'height', 0.5262, 0.1401),
  ('cabinet', 8, 'length', 0.09502, 0.18),
  ('cabinet', 8, 'rectangularity', 0.7337, 0.1141),
  ('cabinet', 8, 'spread_length', -0.05093, 0.1932),
  ('cabinet', 8, 'spread_width', -0.6033, 0.2606),
  ('cabinet', 8, 'tilt_deg', 89.24, 3.358),
  ('cabinet', 8, 'width', -0.4416, 0.2371),
  ('cabinet', 8, 'z_max', 1.021, 0.2414),
  ('cabinet', 8, 'z_min', 0.002803, 0.0509);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.07072, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'area_m2', -0.139, 0.2032),
  ('cabinet', 9, 'aspect', 0.2425, 0.1452),
  ('cabinet', 9, 'behind', 0.5295, 0.09675),
  ('cabinet', 9, 'edge_free', 0.6575, 0.1007),
  ('cabinet', 9, 'edge_free_top', 0.9807, 0.04093),
  ('cabinet', 9, 'edge_joined', 0.08404, 0.1103),
  ('cabinet', 9, 'height', 0.5752, 0.1274),
  ('cabinet', 9, 'length', 0.1469, 0.1354),
  ('cabinet', 9, 'rectangularity', 0.8315, 0.07952),
  ('cabinet', 9, 'spread_length', 0.03629, 0.1478),
  ('cabinet', 9, 'spread_width', -0.2406, 0.1131),
  ('cabinet', 9, 'tilt_deg', 89.3, 3.459),
  ('cabinet', 9, 'width', -0.09559, 0.1109),
  ('cabinet', 9, 'z_max', 1.018, 0.1552),
  ('cabinet', 9, 'z_min', -0.002029, 0.04204);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.06512, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'area_m2', -1.003, 0.3689),
  ('cabinet', 10, 'aspect', 0.6426, 0.2745),
  ('cabinet', 10, 'behind', 0.496, 0.2329),
  ('cabinet', 10, 'edge_free', 0.6455, 0.1708),
  ('cabinet', 10, 'edge_free_top', 0.9491, 0.07821),
  ('cabinet', 10, 'edge_joined', 0.06675, 0.06486),
  ('cabinet', 10, 'height', 0.6169, 0.1632),
  ('cabinet', 10, 'length', 0.08414, 0.1599),
  ('cabinet', 10, 'rectangularity', 0.6083, 0.1417),
  ('cabinet', 10, 'spread_length', -0.1297, 0.2244),
  ('cabinet', 10, 'spread_width', -0.9085, 0.3051),
  ('cabinet', 10, 'tilt_deg', 89.03, 3.842),
  ('cabinet', 10, 'width', -0.5585, 0.22),
  ('cabinet', 10, 'z_max', 1.066, 0.177),
  ('cabinet', 10, 'z_min', 0.004132, 0.05288);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.16 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.486 WHERE name = 'aspect';
UPDATE feature SET weight = 0.423 WHERE name = 'behind';
UPDATE feature SET weight = 0.305 WHERE name = 'edge_free';
UPDATE feature SET weight = 0.355 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.377 WHERE name = 'edge_joined';
UPDATE feature SET weight = 0.292 WHERE name = 'height';
UPDATE feature SET weight = 0.0442 WHERE name = 'length';
UPDATE feature SET weight = 0.5 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.255 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.208 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.389 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.219 WHERE name = 'width';
UPDATE feature SET weight = 0.449 WHERE name = 'z_max';
UPDATE feature SET weight = 0.418 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.396 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0276 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0359 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.0739 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0167 WHERE name = 'table';
UPDATE object_class SET prior = 0.0385 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.17 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.0118 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0646 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.013 WHERE name = 'door';
UPDATE object_class SET prior = 0.0142 WHERE name = 'window';
UPDATE object_class SET prior = 0.0144 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0667 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.0566 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.98 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.0978 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 4.01 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 3.81 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.51 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 1.98 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.52 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 1.24 WHERE name = 'wall_square';
UPDATE class_constraint SET weight = 0.228 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 2.8 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.8 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.54 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.507 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 2.58 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.665 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 2.84 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 5.04 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.43 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.798 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.933 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 1.22 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.698 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.04 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 1.24 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 1.61 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.35 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.43 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.659 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 0.967 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.21 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.38 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 1430 planes of 24 paper-like rooms, seeds from 8001.
UPDATE setting SET value = '0.654' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.136' WHERE key = 'probability_offset';
