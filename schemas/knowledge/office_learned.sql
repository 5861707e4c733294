-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise.
-- Densities and Gaussians: 5508 planes of 42 paper-like rooms, seeds from 1; 36 varied rooms, seeds from 301; 54 depth-camera frames, seeds from 101.
-- Priors and weights: 24 paper-like rooms, seeds from 11; 18 varied rooms, seeds from 401; 27 depth-camera frames, seeds from 201.

-- unknown: 2422 examples
UPDATE object_class SET prior = 0.5169 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -2.022, 1.248)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.619, 0.4986)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 0.9758, 0.6697)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.509, 0.7169)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.7012, 0.1495)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.6532, 0.7312)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.336, 0.6219)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 64.54, 36.83)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.131, 0.6282)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.224, 0.842)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7153, 0.7093)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0157469, 0.003407),
  ('unknown', 'area_m2', 0.0157469, 0.0311723, 0.1531),
  ('unknown', 'area_m2', 0.0311723, 0.0351354, 0.1793),
  ('unknown', 'area_m2', 0.0351354, 0.0506378, 0.2442),
  ('unknown', 'area_m2', 0.0506378, 0.0730138, 0.3044),
  ('unknown', 'area_m2', 0.0730138, 0.0783963, 0.3641),
  ('unknown', 'area_m2', 0.0783963, 0.0975881, 0.3852),
  ('unknown', 'area_m2', 0.0975881, 0.135244, 0.3436),
  ('unknown', 'area_m2', 0.135244, 0.174923, 0.2423),
  ('unknown', 'area_m2', 0.174923, 0.205969, 0.2914),
  ('unknown', 'area_m2', 0.205969, 0.303951, 0.2893),
  ('unknown', 'area_m2', 0.303951, 0.390299, 0.2308),
  ('unknown', 'area_m2', 0.390299, 0.52723, 0.1791),
  ('unknown', 'area_m2', 0.52723, 0.87086, 0.1244),
  ('unknown', 'area_m2', 0.87086, 1.94312, 0.02783),
  ('unknown', 'area_m2', 1.94312, 4.33561, 0.00595),
  ('unknown', 'area_m2', 4.33561, 9.67388, 0.00505),
  ('unknown', 'area_m2', 9.67388, 21.585, 0.008783),
  ('unknown', 'area_m2', 21.585, 100, 0.005992);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.10632, 1.099),
  ('unknown', 'aspect', 1.10632, 1.23201, 1.024),
  ('unknown', 'aspect', 1.23201, 1.25868, 0.8406),
  ('unknown', 'aspect', 1.25868, 1.37279, 1.07),
  ('unknown', 'aspect', 1.37279, 1.5485, 0.9174),
  ('unknown', 'aspect', 1.5485, 1.58427, 0.9441),
  ('unknown', 'aspect', 1.58427, 1.75889, 0.8752),
  ('unknown', 'aspect', 1.75889, 1.99409, 0.835),
  ('unknown', 'aspect', 1.99409, 2.01243, 0.6299),
  ('unknown', 'aspect', 2.01243, 2.48651, 0.5251),
  ('unknown', 'aspect', 2.48651, 2.50991, 0.4454),
  ('unknown', 'aspect', 2.50991, 3.15917, 0.3102),
  ('unknown', 'aspect', 3.15917, 3.87181, 0.1775),
  ('unknown', 'aspect', 3.87181, 3.97638, 0.1503),
  ('unknown', 'aspect', 3.97638, 5.00498, 0.1481),
  ('unknown', 'aspect', 5.00498, 6.29966, 0.2002),
  ('unknown', 'aspect', 6.29966, 7.92924, 0.07532),
  ('unknown', 'aspect', 7.92924, 100, 0.003797);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.00743053, 0.0122),
  ('unknown', 'height', 0.00743053, 0.22971, 0.4682),
  ('unknown', 'height', 0.22971, 0.344515, 0.59),
  ('unknown', 'height', 0.344515, 0.428369, 0.5532),
  ('unknown', 'height', 0.428369, 0.617451, 0.5761),
  ('unknown', 'height', 0.617451, 0.681599, 0.5205),
  ('unknown', 'height', 0.681599, 0.773898, 0.8341),
  ('unknown', 'height', 0.773898, 0.888014, 0.9719),
  ('unknown', 'height', 0.888014, 1.01868, 0.5793),
  ('unknown', 'height', 1.01868, 1.10937, 0.4081),
  ('unknown', 'height', 1.10937, 1.35577, 0.3288),
  ('unknown', 'height', 1.35577, 1.46082, 0.2869),
  ('unknown', 'height', 1.46082, 1.69285, 0.3496),
  ('unknown', 'height', 1.69285, 1.8647, 0.1681),
  ('unknown', 'height', 1.8647, 2.02994, 0.1141),
  ('unknown', 'height', 2.02994, 2.36702, 0.1364),
  ('unknown', 'height', 2.36702, 2.70411, 0.06332),
  ('unknown', 'height', 2.70411, 3.04119, 0.04257),
  ('unknown', 'height', 3.04119, 4, 0.01147);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.151083, 0.004438),
  ('unknown', 'length', 0.151083, 0.229706, 0.183),
  ('unknown', 'length', 0.229706, 0.24949, 0.3371),
  ('unknown', 'length', 0.24949, 0.33232, 0.3851),
  ('unknown', 'length', 0.33232, 0.349244, 0.5451),
  ('unknown', 'length', 0.349244, 0.42732, 0.4166),
  ('unknown', 'length', 0.42732, 0.524911, 0.5446),
  ('unknown', 'length', 0.524911, 0.53099, 0.5633),
  ('unknown', 'length', 0.53099, 0.649417, 0.5094),
  ('unknown', 'length', 0.649417, 0.807317, 0.4996),
  ('unknown', 'length', 0.807317, 1.02959, 0.4693),
  ('unknown', 'length', 1.02959, 1.22744, 0.3646),
  ('unknown', 'length', 1.22744, 1.37505, 0.4316),
  ('unknown', 'length', 1.37505, 1.8662, 0.2282),
  ('unknown', 'length', 1.8662, 2.83737, 0.03382),
  ('unknown', 'length', 2.83737, 4.31394, 0.01624),
  ('unknown', 'length', 4.31394, 6.5589, 0.02077),
  ('unknown', 'length', 6.5589, 30, 0.006834);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.309278, 0.03136),
  ('unknown', 'rectangularity', 0.309278, 0.382159, 0.2618),
  ('unknown', 'rectangularity', 0.382159, 0.455041, 0.5433),
  ('unknown', 'rectangularity', 0.455041, 0.501663, 0.9004),
  ('unknown', 'rectangularity', 0.501663, 0.527923, 1.261),
  ('unknown', 'rectangularity', 0.527923, 0.58057, 1.491),
  ('unknown', 'rectangularity', 0.58057, 0.600804, 1.698),
  ('unknown', 'rectangularity', 0.600804, 0.646895, 1.668),
  ('unknown', 'rectangularity', 0.646895, 0.673686, 2.246),
  ('unknown', 'rectangularity', 0.673686, 0.697451, 2.195),
  ('unknown', 'rectangularity', 0.697451, 0.740687, 2.564),
  ('unknown', 'rectangularity', 0.740687, 0.746568, 2.178),
  ('unknown', 'rectangularity', 0.746568, 0.783776, 2.646),
  ('unknown', 'rectangularity', 0.783776, 0.819449, 2.616),
  ('unknown', 'rectangularity', 0.819449, 0.826647, 2.416),
  ('unknown', 'rectangularity', 0.826647, 0.881419, 1.997),
  ('unknown', 'rectangularity', 0.881419, 0.892331, 1.532),
  ('unknown', 'rectangularity', 0.892331, 0.965212, 1.23),
  ('unknown', 'rectangularity', 0.965212, 1, 0.1669);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.143606, 0.002555),
  ('unknown', 'spread_length', 0.143606, 0.218868, 0.2387),
  ('unknown', 'spread_length', 0.218868, 0.221419, 0.3475),
  ('unknown', 'spread_length', 0.221419, 0.285603, 0.4282),
  ('unknown', 'spread_length', 0.285603, 0.333574, 0.6291),
  ('unknown', 'spread_length', 0.333574, 0.340998, 0.7032),
  ('unknown', 'spread_length', 0.340998, 0.420639, 0.5281),
  ('unknown', 'spread_length', 0.420639, 0.508395, 0.4677),
  ('unknown', 'spread_length', 0.508395, 0.544549, 0.3064),
  ('unknown', 'spread_length', 0.544549, 0.712172, 0.4152),
  ('unknown', 'spread_length', 0.712172, 0.774839, 0.5026),
  ('unknown', 'spread_length', 0.774839, 0.921095, 0.4032),
  ('unknown', 'spread_length', 0.921095, 1.18092, 0.3725),
  ('unknown', 'spread_length', 1.18092, 1.25151, 0.3447),
  ('unknown', 'spread_length', 1.25151, 1.79983, 0.2031),
  ('unknown', 'spread_length', 1.79983, 2.74309, 0.02557),
  ('unknown', 'spread_length', 2.74309, 4.18071, 0.01422),
  ('unknown', 'spread_length', 4.18071, 6.37177, 0.02173),
  ('unknown', 'spread_length', 6.37177, 40, 0.005488);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.107099, 0.0003059),
  ('unknown', 'spread_width', 0.107099, 0.110038, 0.1696),
  ('unknown', 'spread_width', 0.110038, 0.133287, 0.5475),
  ('unknown', 'spread_width', 0.133287, 0.160334, 0.5403),
  ('unknown', 'spread_width', 0.160334, 0.164835, 0.5334),
  ('unknown', 'spread_width', 0.164835, 0.195391, 0.6341),
  ('unknown', 'spread_width', 0.195391, 0.21813, 1.02),
  ('unknown', 'spread_width', 0.21813, 0.24003, 0.9037),
  ('unknown', 'spread_width', 0.24003, 0.249304, 0.5819),
  ('unknown', 'spread_width', 0.249304, 0.300284, 0.6046),
  ('unknown', 'spread_width', 0.300284, 0.359339, 0.4716),
  ('unknown', 'spread_width', 0.359339, 0.385451, 0.3706),
  ('unknown', 'spread_width', 0.385451, 0.537954, 0.2948),
  ('unknown', 'spread_width', 0.537954, 0.569372, 0.2478),
  ('unknown', 'spread_width', 0.569372, 0.805351, 0.2153),
  ('unknown', 'spread_width', 0.805351, 1.20566, 0.03495),
  ('unknown', 'spread_width', 1.20566, 1.80495, 0.009968),
  ('unknown', 'spread_width', 1.80495, 2.70212, 0.01082),
  ('unknown', 'spread_width', 2.70212, 4.04525, 0.01023),
  ('unknown', 'spread_width', 4.04525, 20, 0.005864);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 1.15037, 0.09435),
  ('unknown', 'tilt_deg', 1.15037, 10, 0.01275),
  ('unknown', 'tilt_deg', 10, 10.177, 0.003497),
  ('unknown', 'tilt_deg', 10.177, 20, 0.002923),
  ('unknown', 'tilt_deg', 20, 30, 0.001121),
  ('unknown', 'tilt_deg', 30, 40, 0.0008206),
  ('unknown', 'tilt_deg', 40, 50, 0.0007805),
  ('unknown', 'tilt_deg', 50, 60, 0.0007302),
  ('unknown', 'tilt_deg', 60, 70, 0.001459),
  ('unknown', 'tilt_deg', 70, 76.9349, 0.004936),
  ('unknown', 'tilt_deg', 76.9349, 80, 0.006453),
  ('unknown', 'tilt_deg', 80, 86.7289, 0.0138),
  ('unknown', 'tilt_deg', 86.7289, 88.7815, 0.05423),
  ('unknown', 'tilt_deg', 88.7815, 89.5176, 0.1742),
  ('unknown', 'tilt_deg', 89.5176, 89.8237, 0.5343),
  ('unknown', 'tilt_deg', 89.8237, 90, 0.8517);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.115992, 0.003017),
  ('unknown', 'width', 0.115992, 0.156523, 0.3459),
  ('unknown', 'width', 0.156523, 0.172447, 0.4353),
  ('unknown', 'width', 0.172447, 0.198786, 0.4861),
  ('unknown', 'width', 0.198786, 0.232708, 0.6998),
  ('unknown', 'width', 0.232708, 0.256379, 0.8202),
  ('unknown', 'width', 0.256379, 0.268476, 0.6818),
  ('unknown', 'width', 0.268476, 0.324705, 0.5762),
  ('unknown', 'width', 0.324705, 0.381161, 0.66),
  ('unknown', 'width', 0.381161, 0.388121, 0.4541),
  ('unknown', 'width', 0.388121, 0.48839, 0.4803),
  ('unknown', 'width', 0.48839, 0.566677, 0.311),
  ('unknown', 'width', 0.566677, 0.6987, 0.3048),
  ('unknown', 'width', 0.6987, 0.842485, 0.3307),
  ('unknown', 'width', 0.842485, 1.25253, 0.05781),
  ('unknown', 'width', 1.25253, 1.86215, 0.02355),
  ('unknown', 'width', 1.86215, 2.76848, 0.01197),
  ('unknown', 'width', 2.76848, 4.11594, 0.009525),
  ('unknown', 'width', 4.11594, 12, 0.009182);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0344314, 0.01219),
  ('unknown', 'z_max', 0.0344314, 0.406131, 0.2757),
  ('unknown', 'z_max', 0.406131, 0.47505, 0.6214),
  ('unknown', 'z_max', 0.47505, 0.673547, 0.3557),
  ('unknown', 'z_max', 0.673547, 0.776866, 1.08),
  ('unknown', 'z_max', 0.776866, 0.892009, 0.9477),
  ('unknown', 'z_max', 0.892009, 0.915669, 0.6291),
  ('unknown', 'z_max', 0.915669, 1.05804, 0.6799),
  ('unknown', 'z_max', 1.05804, 1.33047, 0.4101),
  ('unknown', 'z_max', 1.33047, 1.35629, 0.2656),
  ('unknown', 'z_max', 1.35629, 1.78215, 0.2478),
  ('unknown', 'z_max', 1.78215, 1.79691, 0.2874),
  ('unknown', 'z_max', 1.79691, 2.18262, 0.2721),
  ('unknown', 'z_max', 2.18262, 2.23753, 0.3973),
  ('unknown', 'z_max', 2.23753, 2.67814, 0.1058),
  ('unknown', 'z_max', 2.67814, 3.11876, 0.03671),
  ('unknown', 'z_max', 3.11876, 3.55938, 0.01688),
  ('unknown', 'z_max', 3.55938, 4, 0.04506);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.126624, 0.05061),
  ('unknown', 'z_min', -0.126624, -0.0122728, 0.8122),
  ('unknown', 'z_min', -0.0122728, 0.0533223, 1.717),
  ('unknown', 'z_min', 0.0533223, 0.246753, 0.4849),
  ('unknown', 'z_min', 0.246753, 0.287979, 0.3517),
  ('unknown', 'z_min', 0.287979, 0.620129, 0.331),
  ('unknown', 'z_min', 0.620129, 0.734246, 0.9851),
  ('unknown', 'z_min', 0.734246, 0.847891, 0.9909),
  ('unknown', 'z_min', 0.847891, 0.993505, 0.542),
  ('unknown', 'z_min', 0.993505, 1.09317, 0.315),
  ('unknown', 'z_min', 1.09317, 1.36688, 0.2739),
  ('unknown', 'z_min', 1.36688, 1.55925, 0.1817),
  ('unknown', 'z_min', 1.55925, 1.74026, 0.09874),
  ('unknown', 'z_min', 1.74026, 2.11363, 0.07434),
  ('unknown', 'z_min', 2.11363, 2.48701, 0.09527),
  ('unknown', 'z_min', 2.48701, 2.86039, 0.05138),
  ('unknown', 'z_min', 2.86039, 4, 0.01026);

-- floor: 137 examples
UPDATE object_class SET prior = 0.02926 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.361, 1.466)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.46, 0.3272)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.001815, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.199, 0.6847)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5816, 0.1295)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.9182, 0.6175)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.365, 0.7695)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.7044, 0.9631)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.7337, 0.8361)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.01183, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.009682, 0.0231)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'floor' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'area_m2', 0.002, 0.0465, 0.002865),
  ('floor', 'area_m2', 0.0465, 0.0921353, 0.01718),
  ('floor', 'area_m2', 0.0921353, 0.182557, 0.02732),
  ('floor', 'area_m2', 0.182557, 0.36172, 0.07198),
  ('floor', 'area_m2', 0.36172, 0.427042, 0.1068),
  ('floor', 'area_m2', 0.427042, 0.716713, 0.1168),
  ('floor', 'area_m2', 0.716713, 1.0592, 0.1248),
  ('floor', 'area_m2', 1.0592, 1.4201, 0.13),
  ('floor', 'area_m2', 1.4201, 2.81379, 0.0844),
  ('floor', 'area_m2', 2.81379, 4.10439, 0.1229),
  ('floor', 'area_m2', 4.10439, 5.57525, 0.2393),
  ('floor', 'area_m2', 5.57525, 6.38101, 0.1853),
  ('floor', 'area_m2', 6.38101, 8.20551, 0.4507),
  ('floor', 'area_m2', 8.20551, 10.0674, 0.5341),
  ('floor', 'area_m2', 10.0674, 11.0468, 0.5912),
  ('floor', 'area_m2', 11.0468, 12.5446, 0.3483),
  ('floor', 'area_m2', 12.5446, 14.5692, 0.6917),
  ('floor', 'area_m2', 14.5692, 21.8882, 0.2536),
  ('floor', 'area_m2', 21.8882, 100, 0.0101);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'aspect', 1, 1.06225, 1.808),
  ('floor', 'aspect', 1.06225, 1.16833, 0.962),
  ('floor', 'aspect', 1.16833, 1.18702, 0.9349),
  ('floor', 'aspect', 1.18702, 1.3255, 1.097),
  ('floor', 'aspect', 1.3255, 1.365, 1.743),
  ('floor', 'aspect', 1.365, 1.41971, 1.348),
  ('floor', 'aspect', 1.41971, 1.59478, 0.9376),
  ('floor', 'aspect', 1.59478, 1.80976, 0.8879),
  ('floor', 'aspect', 1.80976, 1.86324, 1.076),
  ('floor', 'aspect', 1.86324, 2.02524, 0.9382),
  ('floor', 'aspect', 2.02524, 2.17688, 0.7279),
  ('floor', 'aspect', 2.17688, 2.33152, 0.8596),
  ('floor', 'aspect', 2.33152, 2.54333, 0.3964),
  ('floor', 'aspect', 2.54333, 2.97145, 0.2106),
  ('floor', 'aspect', 2.97145, 3.47165, 0.1706),
  ('floor', 'aspect', 3.47165, 4.05605, 0.07907),
  ('floor', 'aspect', 4.05605, 100, 0.003361);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'height', -0.5, -0.0347053, 0.02613),
  ('floor', 'height', -0.0347053, -0.020875, 2.682),
  ('floor', 'height', -0.020875, -0.00704479, 15.79),
  ('floor', 'height', -0.00704479, -0.000138141, 29.96),
  ('floor', 'height', -0.000138141, 0.00678544, 30.52),
  ('floor', 'height', 0.00678544, 0.0206157, 17.11),
  ('floor', 'height', 0.0206157, 0.0344459, 3.475),
  ('floor', 'height', 0.0344459, 0.0482761, 0.6739),
  ('floor', 'height', 0.0482761, 0.0621064, 0.3957),
  ('floor', 'height', 0.0621064, 0.0759366, 0.3344),
  ('floor', 'height', 0.0759366, 0.0897668, 0.1898),
  ('floor', 'height', 0.0897668, 4, 0.001862);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'length', 0.03, 0.391406, 0.00379),
  ('floor', 'length', 0.391406, 0.555712, 0.0316),
  ('floor', 'length', 0.555712, 0.788991, 0.06336),
  ('floor', 'length', 0.788991, 1.1202, 0.1422),
  ('floor', 'length', 1.1202, 1.2359, 0.1807),
  ('floor', 'length', 1.2359, 1.59044, 0.2357),
  ('floor', 'length', 1.59044, 1.99515, 0.2356),
  ('floor', 'length', 1.99515, 2.25808, 0.2195),
  ('floor', 'length', 2.25808, 3.20599, 0.2335),
  ('floor', 'length', 3.20599, 3.30777, 0.3592),
  ('floor', 'length', 3.30777, 3.8851, 0.7407),
  ('floor', 'length', 3.8851, 4.24813, 1.097),
  ('floor', 'length', 4.24813, 4.55181, 1.279),
  ('floor', 'length', 4.55181, 4.67262, 0.7679),
  ('floor', 'length', 4.67262, 5.63547, 0.5878),
  ('floor', 'length', 5.63547, 6.30403, 0.7759),
  ('floor', 'length', 6.30403, 6.46259, 0.7099),
  ('floor', 'length', 6.46259, 8.63146, 0.3235),
  ('floor', 'length', 8.63146, 9.17548, 0.1561),
  ('floor', 'length', 9.17548, 30, 0.01083);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'rectangularity', 0, 0.281958, 0.03995),
  ('floor', 'rectangularity', 0.281958, 0.349831, 0.3212),
  ('floor', 'rectangularity', 0.349831, 0.417703, 1.007),
  ('floor', 'rectangularity', 0.417703, 0.425482, 1.527),
  ('floor', 'rectangularity', 0.425482, 0.485576, 1.724),
  ('floor', 'rectangularity', 0.485576, 0.492284, 2.873),
  ('floor', 'rectangularity', 0.492284, 0.522938, 3.081),
  ('floor', 'rectangularity', 0.522938, 0.551923, 3.833),
  ('floor', 'rectangularity', 0.551923, 0.590093, 3.046),
  ('floor', 'rectangularity', 0.590093, 0.621321, 3.11),
  ('floor', 'rectangularity', 0.621321, 0.627934, 2.452),
  ('floor', 'rectangularity', 0.627934, 0.681332, 2.022),
  ('floor', 'rectangularity', 0.681332, 0.689193, 1.722),
  ('floor', 'rectangularity', 0.689193, 0.75324, 1.414),
  ('floor', 'rectangularity', 0.75324, 0.824938, 1.032),
  ('floor', 'rectangularity', 0.824938, 0.89281, 0.4858),
  ('floor', 'rectangularity', 0.89281, 1, 0.09081);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_length', 0.01, 0.328333, 0.00234),
  ('floor', 'spread_length', 0.328333, 0.450877, 0.03831),
  ('floor', 'spread_length', 0.450877, 0.619158, 0.05121),
  ('floor', 'spread_length', 0.619158, 0.850246, 0.1298),
  ('floor', 'spread_length', 0.850246, 0.967811, 0.1911),
  ('floor', 'spread_length', 0.967811, 1.16758, 0.1811),
  ('floor', 'spread_length', 1.16758, 1.58491, 0.2808),
  ('floor', 'spread_length', 1.58491, 2.20178, 0.2048),
  ('floor', 'spread_length', 2.20178, 2.53752, 0.3496),
  ('floor', 'spread_length', 2.53752, 2.92611, 0.8391),
  ('floor', 'spread_length', 2.92611, 3.02356, 0.98),
  ('floor', 'spread_length', 3.02356, 3.26506, 0.9602),
  ('floor', 'spread_length', 3.26506, 3.58388, 1.11),
  ('floor', 'spread_length', 3.58388, 3.91104, 1.16),
  ('floor', 'spread_length', 3.91104, 4.15204, 1.293),
  ('floor', 'spread_length', 4.15204, 4.34924, 0.8673),
  ('floor', 'spread_length', 4.34924, 5.70171, 0.359),
  ('floor', 'spread_length', 5.70171, 40, 0.008121);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_width', 0.003, 0.136309, 0.002466),
  ('floor', 'spread_width', 0.136309, 0.142494, 0.04133),
  ('floor', 'spread_width', 0.142494, 0.19551, 0.04366),
  ('floor', 'spread_width', 0.19551, 0.280423, 0.04039),
  ('floor', 'spread_width', 0.280423, 0.402215, 0.1227),
  ('floor', 'spread_width', 0.402215, 0.446201, 0.1792),
  ('floor', 'spread_width', 0.446201, 0.576905, 0.2155),
  ('floor', 'spread_width', 0.576905, 0.765453, 0.2383),
  ('floor', 'spread_width', 0.765453, 0.827464, 0.1812),
  ('floor', 'spread_width', 0.827464, 1.18685, 0.169),
  ('floor', 'spread_width', 1.18685, 1.53737, 0.1979),
  ('floor', 'spread_width', 1.53737, 1.70231, 0.4444),
  ('floor', 'spread_width', 1.70231, 1.83801, 0.775),
  ('floor', 'spread_width', 1.83801, 2.10276, 0.7956),
  ('floor', 'spread_width', 2.10276, 2.36175, 0.8841),
  ('floor', 'spread_width', 2.36175, 2.44166, 1.343),
  ('floor', 'spread_width', 2.44166, 2.56259, 1.324),
  ('floor', 'spread_width', 2.56259, 2.744, 1.433),
  ('floor', 'spread_width', 2.744, 3.38017, 0.5059),
  ('floor', 'spread_width', 3.38017, 3.50211, 0.1633),
  ('floor', 'spread_width', 3.50211, 20, 0.009201);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'tilt_deg', 0, 0.45696, 1.202),
  ('floor', 'tilt_deg', 0.45696, 0.91392, 0.2253),
  ('floor', 'tilt_deg', 0.91392, 1.37088, 0.2032),
  ('floor', 'tilt_deg', 1.37088, 1.56348, 0.1896),
  ('floor', 'tilt_deg', 1.56348, 1.82784, 0.1869),
  ('floor', 'tilt_deg', 1.82784, 2.14429, 0.183),
  ('floor', 'tilt_deg', 2.14429, 2.2848, 0.172),
  ('floor', 'tilt_deg', 2.2848, 2.74176, 0.1095),
  ('floor', 'tilt_deg', 2.74176, 3.19872, 0.03969),
  ('floor', 'tilt_deg', 3.19872, 3.65568, 0.01299),
  ('floor', 'tilt_deg', 3.65568, 4.11264, 0.01338),
  ('floor', 'tilt_deg', 4.11264, 90, 7.537e-05);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'width', 0.01, 0.198028, 0.004039),
  ('floor', 'width', 0.198028, 0.211555, 0.0492),
  ('floor', 'width', 0.211555, 0.289671, 0.05264),
  ('floor', 'width', 0.289671, 0.423724, 0.06485),
  ('floor', 'width', 0.423724, 0.602606, 0.1431),
  ('floor', 'width', 0.602606, 0.619815, 0.1974),
  ('floor', 'width', 0.619815, 0.906651, 0.2339),
  ('floor', 'width', 0.906651, 1.09037, 0.1544),
  ('floor', 'width', 1.09037, 1.32623, 0.1528),
  ('floor', 'width', 1.32623, 1.93998, 0.1887),
  ('floor', 'width', 1.93998, 2.005, 0.3151),
  ('floor', 'width', 2.005, 2.71375, 0.4084),
  ('floor', 'width', 2.71375, 2.83776, 0.6358),
  ('floor', 'width', 2.83776, 3.14551, 0.633),
  ('floor', 'width', 3.14551, 3.5023, 0.9557),
  ('floor', 'width', 3.5023, 3.923, 0.9627),
  ('floor', 'width', 3.923, 4.15101, 1.081),
  ('floor', 'width', 4.15101, 4.42148, 0.8272),
  ('floor', 'width', 4.42148, 6.07201, 0.3187),
  ('floor', 'width', 6.07201, 12, 0.02127);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_max', -0.5, -0.0225707, 0.04966),
  ('floor', 'z_max', -0.0225707, -0.005411, 10.44),
  ('floor', 'z_max', -0.005411, 0.000297334, 22.24),
  ('floor', 'z_max', 0.000297334, 0.0117487, 23.22),
  ('floor', 'z_max', 0.0117487, 0.0184491, 17.46),
  ('floor', 'z_max', 0.0184491, 0.0289084, 11.43),
  ('floor', 'z_max', 0.0289084, 0.0460681, 5.648),
  ('floor', 'z_max', 0.0460681, 0.0632278, 1.924),
  ('floor', 'z_max', 0.0632278, 0.0803875, 0.9173),
  ('floor', 'z_max', 0.0803875, 0.0975472, 0.4323),
  ('floor', 'z_max', 0.0975472, 0.114707, 0.1665),
  ('floor', 'z_max', 0.114707, 0.131867, 0.2185),
  ('floor', 'z_max', 0.131867, 4, 0.002074);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_min', -0.5, -0.127496, 0.0188),
  ('floor', 'z_min', -0.127496, -0.105095, 0.2757),
  ('floor', 'z_min', -0.105095, -0.0826946, 0.3963),
  ('floor', 'z_min', -0.0826946, -0.0602938, 1.013),
  ('floor', 'z_min', -0.0602938, -0.0378931, 2.742),
  ('floor', 'z_min', -0.0378931, -0.018952, 7.84),
  ('floor', 'z_min', -0.018952, -0.00488358, 18.74),
  ('floor', 'z_min', -0.00488358, 0.00690846, 23.21),
  ('floor', 'z_min', 0.00690846, 0.0293092, 8.064),
  ('floor', 'z_min', 0.0293092, 0.05171, 0.6228),
  ('floor', 'z_min', 0.05171, 0.0741108, 0.286),
  ('floor', 'z_min', 0.0741108, 4, 0.001758);

-- ceiling: 96 examples
UPDATE object_class SET prior = 0.02055 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.935, 1.121)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4277, 0.3826)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.886, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.369, 0.4756)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6976, 0.1331)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.254, 0.4645)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.6564, 0.6715)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.01737, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.9371, 0.7256)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.887, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.886, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'area_m2', 0.002, 0.190479, 0.002496),
  ('ceiling', 'area_m2', 0.190479, 0.334687, 0.03555),
  ('ceiling', 'area_m2', 0.334687, 0.588071, 0.04061),
  ('ceiling', 'area_m2', 0.588071, 1.03329, 0.06883),
  ('ceiling', 'area_m2', 1.03329, 1.13287, 0.09316),
  ('ceiling', 'area_m2', 1.13287, 1.81557, 0.07866),
  ('ceiling', 'area_m2', 1.81557, 3.1901, 0.08754),
  ('ceiling', 'area_m2', 3.1901, 5.21808, 0.1255),
  ('ceiling', 'area_m2', 5.21808, 5.60526, 0.2153),
  ('ceiling', 'area_m2', 5.60526, 7.33232, 0.3244),
  ('ceiling', 'area_m2', 7.33232, 9.50866, 0.4523),
  ('ceiling', 'area_m2', 9.50866, 11.0964, 0.6129),
  ('ceiling', 'area_m2', 11.0964, 12.3717, 0.9837),
  ('ceiling', 'area_m2', 12.3717, 14.472, 0.6448),
  ('ceiling', 'area_m2', 14.472, 17.3053, 0.5299),
  ('ceiling', 'area_m2', 17.3053, 18.3383, 0.2219),
  ('ceiling', 'area_m2', 18.3383, 28.1545, 0.237),
  ('ceiling', 'area_m2', 28.1545, 30.4067, 0.0545),
  ('ceiling', 'area_m2', 30.4067, 100, 0.01165);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'aspect', 1, 1.04527, 2.269),
  ('ceiling', 'aspect', 1.04527, 1.15695, 1.296),
  ('ceiling', 'aspect', 1.15695, 1.20194, 1.653),
  ('ceiling', 'aspect', 1.20194, 1.24224, 1.031),
  ('ceiling', 'aspect', 1.24224, 1.36583, 1.069),
  ('ceiling', 'aspect', 1.36583, 1.44466, 1.695),
  ('ceiling', 'aspect', 1.44466, 1.58075, 1.31),
  ('ceiling', 'aspect', 1.58075, 1.7364, 0.7915),
  ('ceiling', 'aspect', 1.7364, 1.82352, 0.8201),
  ('ceiling', 'aspect', 1.82352, 2.08704, 0.7049),
  ('ceiling', 'aspect', 2.08704, 2.19721, 0.4358),
  ('ceiling', 'aspect', 2.19721, 2.5085, 0.225),
  ('ceiling', 'aspect', 2.5085, 3.01507, 0.124),
  ('ceiling', 'aspect', 3.01507, 3.62394, 0.07407),
  ('ceiling', 'aspect', 3.62394, 4.35575, 0.1073),
  ('ceiling', 'aspect', 4.35575, 5.23536, 0.122),
  ('ceiling', 'aspect', 5.23536, 100, 0.005415);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'height', -0.5, 2.2936, 0.005663),
  ('ceiling', 'height', 2.2936, 2.47324, 0.4739),
  ('ceiling', 'height', 2.47324, 2.51475, 2.718),
  ('ceiling', 'height', 2.51475, 2.65288, 0.62),
  ('ceiling', 'height', 2.65288, 2.68273, 1.034),
  ('ceiling', 'height', 2.68273, 2.74919, 1.688),
  ('ceiling', 'height', 2.74919, 2.83253, 1.074),
  ('ceiling', 'height', 2.83253, 2.98168, 0.8365),
  ('ceiling', 'height', 2.98168, 3.01217, 0.6296),
  ('ceiling', 'height', 3.01217, 3.11017, 0.893),
  ('ceiling', 'height', 3.11017, 3.19181, 0.6505),
  ('ceiling', 'height', 3.19181, 3.37146, 0.2784),
  ('ceiling', 'height', 3.37146, 3.40391, 0.3203),
  ('ceiling', 'height', 3.40391, 3.5511, 0.281),
  ('ceiling', 'height', 3.5511, 3.73074, 0.2131),
  ('ceiling', 'height', 3.73074, 3.89083, 0.1809),
  ('ceiling', 'height', 3.89083, 3.91039, 0.1453),
  ('ceiling', 'height', 3.91039, 4, 0.1293);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'length', 0.03, 0.735134, 0.003619),
  ('ceiling', 'length', 0.735134, 0.940629, 0.04361),
  ('ceiling', 'length', 0.940629, 1.20357, 0.04041),
  ('ceiling', 'length', 1.20357, 1.54, 0.1332),
  ('ceiling', 'length', 1.54, 1.92791, 0.1911),
  ('ceiling', 'length', 1.92791, 1.97049, 0.1634),
  ('ceiling', 'length', 1.97049, 2.5213, 0.1721),
  ('ceiling', 'length', 2.5213, 3.22609, 0.2863),
  ('ceiling', 'length', 3.22609, 3.37952, 0.3127),
  ('ceiling', 'length', 3.37952, 4.02081, 0.6749),
  ('ceiling', 'length', 4.02081, 4.12789, 1.086),
  ('ceiling', 'length', 4.12789, 4.42916, 1.187),
  ('ceiling', 'length', 4.42916, 4.70484, 1.623),
  ('ceiling', 'length', 4.70484, 5.02887, 1.555),
  ('ceiling', 'length', 5.02887, 5.28178, 1.128),
  ('ceiling', 'length', 5.28178, 5.4736, 1.295),
  ('ceiling', 'length', 5.4736, 6.0331, 1.166),
  ('ceiling', 'length', 6.0331, 6.75821, 0.836),
  ('ceiling', 'length', 6.75821, 30, 0.01338);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'rectangularity', 0, 0.412984, 0.01904),
  ('ceiling', 'rectangularity', 0.412984, 0.424492, 0.2105),
  ('ceiling', 'rectangularity', 0.424492, 0.475017, 0.3817),
  ('ceiling', 'rectangularity', 0.475017, 0.525057, 1.58),
  ('ceiling', 'rectangularity', 0.525057, 0.537049, 2.521),
  ('ceiling', 'rectangularity', 0.537049, 0.577248, 2.048),
  ('ceiling', 'rectangularity', 0.577248, 0.599082, 1.748),
  ('ceiling', 'rectangularity', 0.599082, 0.632005, 2.091),
  ('ceiling', 'rectangularity', 0.632005, 0.661114, 3.515),
  ('ceiling', 'rectangularity', 0.661114, 0.715451, 2.388),
  ('ceiling', 'rectangularity', 0.715451, 0.723147, 3.001),
  ('ceiling', 'rectangularity', 0.723147, 0.76648, 1.996),
  ('ceiling', 'rectangularity', 0.76648, 0.785179, 1.296),
  ('ceiling', 'rectangularity', 0.785179, 0.824861, 2.311),
  ('ceiling', 'rectangularity', 0.824861, 0.847212, 2.8),
  ('ceiling', 'rectangularity', 0.847212, 0.865122, 1.873),
  ('ceiling', 'rectangularity', 0.865122, 0.909244, 1.397),
  ('ceiling', 'rectangularity', 0.909244, 0.955378, 0.8833),
  ('ceiling', 'rectangularity', 0.955378, 0.971277, 0.4747),
  ('ceiling', 'rectangularity', 0.971277, 1, 0.2818);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_length', 0.01, 0.712981, 0.003063),
  ('ceiling', 'spread_length', 0.712981, 0.903961, 0.06051),
  ('ceiling', 'spread_length', 0.903961, 1.1461, 0.03791),
  ('ceiling', 'spread_length', 1.1461, 1.4531, 0.1565),
  ('ceiling', 'spread_length', 1.4531, 1.66473, 0.2065),
  ('ceiling', 'spread_length', 1.66473, 1.84233, 0.1746),
  ('ceiling', 'spread_length', 1.84233, 2.33582, 0.1498),
  ('ceiling', 'spread_length', 2.33582, 2.96149, 0.3065),
  ('ceiling', 'spread_length', 2.96149, 3.61044, 0.6587),
  ('ceiling', 'spread_length', 3.61044, 3.75477, 1.13),
  ('ceiling', 'spread_length', 3.75477, 3.89731, 1.628),
  ('ceiling', 'spread_length', 3.89731, 4.27775, 1.278),
  ('ceiling', 'spread_length', 4.27775, 4.45892, 1.947),
  ('ceiling', 'spread_length', 4.45892, 4.7391, 1.653),
  ('ceiling', 'spread_length', 4.7391, 5.12794, 1.362),
  ('ceiling', 'spread_length', 5.12794, 5.78027, 0.8373),
  ('ceiling', 'spread_length', 5.78027, 6.03569, 0.2847),
  ('ceiling', 'spread_length', 6.03569, 40, 0.008685);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_width', 0.003, 0.1656, 0.002852),
  ('ceiling', 'spread_width', 0.1656, 0.236702, 0.01937),
  ('ceiling', 'spread_width', 0.236702, 0.338334, 0.01819),
  ('ceiling', 'spread_width', 0.338334, 0.483602, 0.08547),
  ('ceiling', 'spread_width', 0.483602, 0.691244, 0.1426),
  ('ceiling', 'spread_width', 0.691244, 0.708781, 0.1426),
  ('ceiling', 'spread_width', 0.708781, 0.98804, 0.155),
  ('ceiling', 'spread_width', 0.98804, 1.41227, 0.1587),
  ('ceiling', 'spread_width', 1.41227, 1.60747, 0.1692),
  ('ceiling', 'spread_width', 1.60747, 2.01865, 0.4691),
  ('ceiling', 'spread_width', 2.01865, 2.29153, 0.9525),
  ('ceiling', 'spread_width', 2.29153, 2.56823, 0.8584),
  ('ceiling', 'spread_width', 2.56823, 2.79001, 1.189),
  ('ceiling', 'spread_width', 2.79001, 2.88539, 1.238),
  ('ceiling', 'spread_width', 2.88539, 3.03302, 1.186),
  ('ceiling', 'spread_width', 3.03302, 3.32073, 1.247),
  ('ceiling', 'spread_width', 3.32073, 3.91471, 0.5913),
  ('ceiling', 'spread_width', 3.91471, 4.12427, 0.1384),
  ('ceiling', 'spread_width', 4.12427, 20, 0.01124);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'tilt_deg', 0, 0.136953, 3.121),
  ('ceiling', 'tilt_deg', 0.136953, 0.273907, 2.241),
  ('ceiling', 'tilt_deg', 0.273907, 0.41086, 1.175),
  ('ceiling', 'tilt_deg', 0.41086, 0.547813, 0.4743),
  ('ceiling', 'tilt_deg', 0.547813, 90, 0.0004464);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'width', 0.01, 0.184517, 0.004173),
  ('ceiling', 'width', 0.184517, 0.267056, 0.0162),
  ('ceiling', 'width', 0.267056, 0.386518, 0.01329),
  ('ceiling', 'width', 0.386518, 0.559418, 0.08781),
  ('ceiling', 'width', 0.559418, 0.809661, 0.1249),
  ('ceiling', 'width', 0.809661, 0.881789, 0.1087),
  ('ceiling', 'width', 0.881789, 1.17185, 0.1447),
  ('ceiling', 'width', 1.17185, 1.69604, 0.1548),
  ('ceiling', 'width', 1.69604, 1.98798, 0.209),
  ('ceiling', 'width', 1.98798, 2.45473, 0.3528),
  ('ceiling', 'width', 2.45473, 2.60132, 0.4853),
  ('ceiling', 'width', 2.60132, 3.30656, 0.4935),
  ('ceiling', 'width', 3.30656, 3.5528, 1.178),
  ('ceiling', 'width', 3.5528, 3.86931, 1.3),
  ('ceiling', 'width', 3.86931, 4.13239, 1.715),
  ('ceiling', 'width', 4.13239, 4.55855, 1.142),
  ('ceiling', 'width', 4.55855, 5.14206, 0.7539),
  ('ceiling', 'width', 5.14206, 12, 0.02979);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_max', -0.5, 2.29378, 0.005655),
  ('ceiling', 'z_max', 2.29378, 2.47342, 0.4736),
  ('ceiling', 'z_max', 2.47342, 2.51529, 2.698),
  ('ceiling', 'z_max', 2.51529, 2.65307, 0.6214),
  ('ceiling', 'z_max', 2.65307, 2.68292, 1.032),
  ('ceiling', 'z_max', 2.68292, 2.74967, 1.687),
  ('ceiling', 'z_max', 2.74967, 2.83271, 1.074),
  ('ceiling', 'z_max', 2.83271, 2.98185, 0.8366),
  ('ceiling', 'z_max', 2.98185, 3.01235, 0.6297),
  ('ceiling', 'z_max', 3.01235, 3.11032, 0.8916),
  ('ceiling', 'z_max', 3.11032, 3.192, 0.6522),
  ('ceiling', 'z_max', 3.192, 3.37164, 0.2781),
  ('ceiling', 'z_max', 3.37164, 3.40419, 0.3199),
  ('ceiling', 'z_max', 3.40419, 3.55128, 0.2809),
  ('ceiling', 'z_max', 3.55128, 3.73092, 0.2133),
  ('ceiling', 'z_max', 3.73092, 3.89171, 0.1808),
  ('ceiling', 'z_max', 3.89171, 3.91057, 0.1454),
  ('ceiling', 'z_max', 3.91057, 4, 0.1297);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_min', -0.5, 2.29348, 0.005671),
  ('ceiling', 'z_min', 2.29348, 2.47312, 0.4749),
  ('ceiling', 'z_min', 2.47312, 2.51425, 2.738),
  ('ceiling', 'z_min', 2.51425, 2.65277, 0.6183),
  ('ceiling', 'z_min', 2.65277, 2.68257, 1.039),
  ('ceiling', 'z_min', 2.68257, 2.74867, 1.687),
  ('ceiling', 'z_min', 2.74867, 2.83242, 1.076),
  ('ceiling', 'z_min', 2.83242, 2.98149, 0.8365),
  ('ceiling', 'z_min', 2.98149, 3.01207, 0.6297),
  ('ceiling', 'z_min', 3.01207, 3.11007, 0.894),
  ('ceiling', 'z_min', 3.11007, 3.19171, 0.649),
  ('ceiling', 'z_min', 3.19171, 3.37136, 0.2786),
  ('ceiling', 'z_min', 3.37136, 3.40363, 0.3207),
  ('ceiling', 'z_min', 3.40363, 3.55101, 0.281),
  ('ceiling', 'z_min', 3.55101, 3.73065, 0.213),
  ('ceiling', 'z_min', 3.73065, 3.89005, 0.1809),
  ('ceiling', 'z_min', 3.89005, 3.9103, 0.1452),
  ('ceiling', 'z_min', 3.9103, 4, 0.129);

-- wall: 497 examples
UPDATE object_class SET prior = 0.1063 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 1.116, 1.031)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.5658, 0.4077)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.413, 0.3571)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 1.049, 0.4648)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6803, 0.1458)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.8823, 0.4682)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', 0.2319, 0.6428)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.54, 1.176)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.4805, 0.6485)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.555, 0.6699)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.1699, 0.3629)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'wall' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'area_m2', 0.002, 0.237532, 0.002374),
  ('wall', 'area_m2', 0.237532, 0.381324, 0.04683),
  ('wall', 'area_m2', 0.381324, 0.61216, 0.09903),
  ('wall', 'area_m2', 0.61216, 0.755745, 0.1364),
  ('wall', 'area_m2', 0.755745, 0.982733, 0.2266),
  ('wall', 'area_m2', 0.982733, 1.21547, 0.2313),
  ('wall', 'area_m2', 1.21547, 1.57763, 0.242),
  ('wall', 'area_m2', 1.57763, 1.97057, 0.2422),
  ('wall', 'area_m2', 1.97057, 2.53266, 0.2781),
  ('wall', 'area_m2', 2.53266, 2.97195, 0.2582),
  ('wall', 'area_m2', 2.97195, 4.06582, 0.2556),
  ('wall', 'area_m2', 4.06582, 4.46729, 0.3201),
  ('wall', 'area_m2', 4.46729, 5.89342, 0.4067),
  ('wall', 'area_m2', 5.89342, 6.52708, 0.4125),
  ('wall', 'area_m2', 6.52708, 7.59561, 0.4342),
  ('wall', 'area_m2', 7.59561, 9.99299, 0.4083),
  ('wall', 'area_m2', 9.99299, 10.4783, 0.2451),
  ('wall', 'area_m2', 10.4783, 16.8213, 0.2008),
  ('wall', 'area_m2', 16.8213, 100, 0.002561);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'aspect', 1, 1.12588, 0.9719),
  ('wall', 'aspect', 1.12588, 1.24047, 0.7537),
  ('wall', 'aspect', 1.24047, 1.27281, 1.29),
  ('wall', 'aspect', 1.27281, 1.39527, 1.166),
  ('wall', 'aspect', 1.39527, 1.53877, 0.9601),
  ('wall', 'aspect', 1.53877, 1.56551, 1.149),
  ('wall', 'aspect', 1.56551, 1.69833, 1.305),
  ('wall', 'aspect', 1.69833, 1.90881, 0.9081),
  ('wall', 'aspect', 1.90881, 1.93155, 0.8524),
  ('wall', 'aspect', 1.93155, 2.23591, 0.7463),
  ('wall', 'aspect', 2.23591, 2.36782, 0.4934),
  ('wall', 'aspect', 2.36782, 2.92194, 0.4175),
  ('wall', 'aspect', 2.92194, 3.64355, 0.1786),
  ('wall', 'aspect', 3.64355, 4.51972, 0.1539),
  ('wall', 'aspect', 4.51972, 5.60659, 0.09268),
  ('wall', 'aspect', 5.60659, 6.95483, 0.03334),
  ('wall', 'aspect', 6.95483, 100, 0.00382);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'height', -0.5, 0.29425, 0.01306),
  ('wall', 'height', 0.29425, 0.514788, 0.07355),
  ('wall', 'height', 0.514788, 0.735326, 0.1336),
  ('wall', 'height', 0.735326, 0.955864, 0.2098),
  ('wall', 'height', 0.955864, 1.02875, 0.1768),
  ('wall', 'height', 1.02875, 1.1764, 0.335),
  ('wall', 'height', 1.1764, 1.23274, 1.015),
  ('wall', 'height', 1.23274, 1.33123, 1.111),
  ('wall', 'height', 1.33123, 1.39694, 1.617),
  ('wall', 'height', 1.39694, 1.40612, 1.281),
  ('wall', 'height', 1.40612, 1.45861, 1.916),
  ('wall', 'height', 1.45861, 1.53783, 1.462),
  ('wall', 'height', 1.53783, 1.61748, 1.193),
  ('wall', 'height', 1.61748, 1.63432, 1.127),
  ('wall', 'height', 1.63432, 1.80535, 0.6602),
  ('wall', 'height', 1.80535, 1.83802, 0.2946),
  ('wall', 'height', 1.83802, 2.05855, 0.2731),
  ('wall', 'height', 2.05855, 2.27909, 0.1225),
  ('wall', 'height', 2.27909, 4, 0.006056);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'length', 0.03, 0.730767, 0.002484),
  ('wall', 'length', 0.730767, 0.932599, 0.06267),
  ('wall', 'length', 0.932599, 1.19018, 0.1002),
  ('wall', 'length', 1.19018, 1.51889, 0.2372),
  ('wall', 'length', 1.51889, 1.55911, 0.3646),
  ('wall', 'length', 1.55911, 1.9384, 0.3855),
  ('wall', 'length', 1.9384, 2.09504, 0.277),
  ('wall', 'length', 2.09504, 2.47377, 0.6768),
  ('wall', 'length', 2.47377, 2.73257, 1.09),
  ('wall', 'length', 2.73257, 3.157, 0.7461),
  ('wall', 'length', 3.157, 3.732, 0.7307),
  ('wall', 'length', 3.732, 4.02894, 0.8772),
  ('wall', 'length', 4.02894, 4.2922, 0.7052),
  ('wall', 'length', 4.2922, 4.79877, 0.9248),
  ('wall', 'length', 4.79877, 5.1417, 0.5139),
  ('wall', 'length', 5.1417, 6.5618, 0.2917),
  ('wall', 'length', 6.5618, 30, 0.004661);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'rectangularity', 0, 0.34479, 0.03341),
  ('wall', 'rectangularity', 0.34479, 0.415943, 0.3785),
  ('wall', 'rectangularity', 0.415943, 0.48532, 1.067),
  ('wall', 'rectangularity', 0.48532, 0.558249, 1.368),
  ('wall', 'rectangularity', 0.558249, 0.565469, 1.32),
  ('wall', 'rectangularity', 0.565469, 0.621538, 1.98),
  ('wall', 'rectangularity', 0.621538, 0.629402, 2.123),
  ('wall', 'rectangularity', 0.629402, 0.661622, 3.065),
  ('wall', 'rectangularity', 0.661622, 0.700555, 2.509),
  ('wall', 'rectangularity', 0.700555, 0.704787, 2.535),
  ('wall', 'rectangularity', 0.704787, 0.755411, 2.151),
  ('wall', 'rectangularity', 0.755411, 0.771708, 2.58),
  ('wall', 'rectangularity', 0.771708, 0.796739, 2.807),
  ('wall', 'rectangularity', 0.796739, 0.842861, 1.706),
  ('wall', 'rectangularity', 0.842861, 0.860851, 1.683),
  ('wall', 'rectangularity', 0.860851, 0.914014, 1.053),
  ('wall', 'rectangularity', 0.914014, 0.985167, 0.7257),
  ('wall', 'rectangularity', 0.985167, 1, 0.3748);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_length', 0.01, 0.626991, 0.002067),
  ('wall', 'spread_length', 0.626991, 0.804177, 0.06057),
  ('wall', 'spread_length', 0.804177, 1.03144, 0.1148),
  ('wall', 'spread_length', 1.03144, 1.30139, 0.2478),
  ('wall', 'spread_length', 1.30139, 1.32292, 0.2892),
  ('wall', 'spread_length', 1.32292, 1.67739, 0.4384),
  ('wall', 'spread_length', 1.67739, 2.09262, 0.512),
  ('wall', 'spread_length', 2.09262, 2.17628, 0.6921),
  ('wall', 'spread_length', 2.17628, 2.3905, 0.9711),
  ('wall', 'spread_length', 2.3905, 2.64932, 1.023),
  ('wall', 'spread_length', 2.64932, 2.79129, 0.827),
  ('wall', 'spread_length', 2.79129, 3.14308, 0.5867),
  ('wall', 'spread_length', 3.14308, 3.5801, 0.767),
  ('wall', 'spread_length', 3.5801, 3.65114, 0.5039),
  ('wall', 'spread_length', 3.65114, 4.17602, 0.8241),
  ('wall', 'spread_length', 4.17602, 4.59183, 0.5265),
  ('wall', 'spread_length', 4.59183, 5.88947, 0.2197),
  ('wall', 'spread_length', 5.88947, 40, 0.00354);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_width', 0.003, 0.217194, 0.002692),
  ('wall', 'spread_width', 0.217194, 0.295245, 0.03681),
  ('wall', 'spread_width', 0.295245, 0.401343, 0.09466),
  ('wall', 'spread_width', 0.401343, 0.512132, 0.2463),
  ('wall', 'spread_width', 0.512132, 0.545569, 0.4067),
  ('wall', 'spread_width', 0.545569, 0.725771, 0.2967),
  ('wall', 'spread_width', 0.725771, 0.741624, 0.2999),
  ('wall', 'spread_width', 0.741624, 1.00813, 0.3269),
  ('wall', 'spread_width', 1.00813, 1.27408, 0.4841),
  ('wall', 'spread_width', 1.27408, 1.37041, 0.4419),
  ('wall', 'spread_width', 1.37041, 1.62455, 0.4659),
  ('wall', 'spread_width', 1.62455, 1.86288, 0.7374),
  ('wall', 'spread_width', 1.86288, 1.90152, 0.7007),
  ('wall', 'spread_width', 1.90152, 2.20538, 0.737),
  ('wall', 'spread_width', 2.20538, 2.53232, 0.7006),
  ('wall', 'spread_width', 2.53232, 2.60353, 0.6645),
  ('wall', 'spread_width', 2.60353, 3.44233, 0.3578),
  ('wall', 'spread_width', 3.44233, 20, 0.003552);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'tilt_deg', 0, 83.4181, 0.0001005),
  ('wall', 'tilt_deg', 83.4181, 84.1494, 0.007247),
  ('wall', 'tilt_deg', 84.1494, 84.8807, 0.005773),
  ('wall', 'tilt_deg', 84.8807, 85.6121, 0.01361),
  ('wall', 'tilt_deg', 85.6121, 86.3434, 0.01888),
  ('wall', 'tilt_deg', 86.3434, 87.0747, 0.02376),
  ('wall', 'tilt_deg', 87.0747, 87.806, 0.03317),
  ('wall', 'tilt_deg', 87.806, 88.5374, 0.03976),
  ('wall', 'tilt_deg', 88.5374, 89.2687, 0.07551),
  ('wall', 'tilt_deg', 89.2687, 89.8358, 0.7269),
  ('wall', 'tilt_deg', 89.8358, 90, 2.559);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'width', 0.01, 0.261293, 0.003132),
  ('wall', 'width', 0.261293, 0.353525, 0.03716),
  ('wall', 'width', 0.353525, 0.478312, 0.07351),
  ('wall', 'width', 0.478312, 0.628716, 0.2418),
  ('wall', 'width', 0.628716, 0.647147, 0.2977),
  ('wall', 'width', 0.647147, 0.875578, 0.2873),
  ('wall', 'width', 0.875578, 0.915023, 0.3777),
  ('wall', 'width', 0.915023, 1.18464, 0.3511),
  ('wall', 'width', 1.18464, 1.25282, 0.3295),
  ('wall', 'width', 1.25282, 1.6028, 0.4431),
  ('wall', 'width', 1.6028, 1.68197, 0.265),
  ('wall', 'width', 1.68197, 2.16855, 0.2402),
  ('wall', 'width', 2.16855, 2.39478, 0.4077),
  ('wall', 'width', 2.39478, 2.63558, 1.233),
  ('wall', 'width', 2.63558, 2.79928, 1.635),
  ('wall', 'width', 2.79928, 2.93401, 1.294),
  ('wall', 'width', 2.93401, 3.10154, 1.155),
  ('wall', 'width', 3.10154, 3.86776, 0.4334),
  ('wall', 'width', 3.86776, 3.96966, 0.1087),
  ('wall', 'width', 3.96966, 12, 0.004955);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_max', -0.5, 0.624374, 0.007912),
  ('wall', 'z_max', 0.624374, 0.984085, 0.03527),
  ('wall', 'z_max', 0.984085, 1.3438, 0.1071),
  ('wall', 'z_max', 1.3438, 1.49934, 0.3243),
  ('wall', 'z_max', 1.49934, 1.70351, 0.2169),
  ('wall', 'z_max', 1.70351, 2.06322, 0.128),
  ('wall', 'z_max', 2.06322, 2.33427, 0.09535),
  ('wall', 'z_max', 2.33427, 2.42293, 0.4848),
  ('wall', 'z_max', 2.42293, 2.47997, 1.071),
  ('wall', 'z_max', 2.47997, 2.59303, 1.031),
  ('wall', 'z_max', 2.59303, 2.72243, 0.8629),
  ('wall', 'z_max', 2.72243, 2.78264, 1.246),
  ('wall', 'z_max', 2.78264, 2.8416, 0.5867),
  ('wall', 'z_max', 2.8416, 2.99558, 0.7065),
  ('wall', 'z_max', 2.99558, 3.14235, 0.6355),
  ('wall', 'z_max', 3.14235, 3.2675, 0.1397),
  ('wall', 'z_max', 3.2675, 3.50206, 0.222),
  ('wall', 'z_max', 3.50206, 3.86178, 0.136),
  ('wall', 'z_max', 3.86178, 4, 0.07794);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_min', -0.5, -0.0945752, 0.0393),
  ('wall', 'z_min', -0.0945752, -0.0166929, 2.837),
  ('wall', 'z_min', -0.0166929, -0.0110071, 18.85),
  ('wall', 'z_min', -0.0110071, 0.00419596, 16.76),
  ('wall', 'z_min', 0.00419596, 0.106503, 1.307),
  ('wall', 'z_min', 0.106503, 0.228664, 0.3035),
  ('wall', 'z_min', 0.228664, 0.307581, 0.2118),
  ('wall', 'z_min', 0.307581, 0.50866, 0.2236),
  ('wall', 'z_min', 0.50866, 0.68256, 0.3282),
  ('wall', 'z_min', 0.68256, 0.709738, 0.3119),
  ('wall', 'z_min', 0.709738, 0.910816, 0.2072),
  ('wall', 'z_min', 0.910816, 1.11189, 0.1635),
  ('wall', 'z_min', 1.11189, 1.31297, 0.04519),
  ('wall', 'z_min', 1.31297, 1.51405, 0.01522),
  ('wall', 'z_min', 1.51405, 1.71513, 0.04876),
  ('wall', 'z_min', 1.71513, 4, 0.002896);

-- table: 214 examples
UPDATE object_class SET prior = 0.04584 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.3702, 0.6776)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5546, 0.3206)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7395, 0.1199)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.2862, 0.3488)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.6932, 0.129)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1353, 0.3362)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4679, 0.4008)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.6398, 0.59)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2666, 0.3652)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7468, 0.1201)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7336, 0.1195)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'table' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'area_m2', 0.002, 0.0776479, 0.002857),
  ('table', 'area_m2', 0.0776479, 0.113278, 0.03577),
  ('table', 'area_m2', 0.113278, 0.165257, 0.05464),
  ('table', 'area_m2', 0.165257, 0.241088, 0.09297),
  ('table', 'area_m2', 0.241088, 0.301113, 0.1384),
  ('table', 'area_m2', 0.301113, 0.351716, 0.2149),
  ('table', 'area_m2', 0.351716, 0.424321, 0.4115),
  ('table', 'area_m2', 0.424321, 0.513106, 0.3564),
  ('table', 'area_m2', 0.513106, 0.584051, 0.3438),
  ('table', 'area_m2', 0.584051, 0.712047, 0.5581),
  ('table', 'area_m2', 0.712047, 0.748553, 0.4885),
  ('table', 'area_m2', 0.748553, 0.891251, 0.5294),
  ('table', 'area_m2', 0.891251, 1.02613, 0.7939),
  ('table', 'area_m2', 1.02613, 1.09204, 1.068),
  ('table', 'area_m2', 1.09204, 1.14936, 0.7133),
  ('table', 'area_m2', 1.14936, 1.34807, 0.6744),
  ('table', 'area_m2', 1.34807, 1.59314, 0.3526),
  ('table', 'area_m2', 1.59314, 2.32418, 0.1201),
  ('table', 'area_m2', 2.32418, 100, 0.003365);
DELETE FROM class_density WHERE class = 'table' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'aspect', 1, 1.16475, 0.7438),
  ('table', 'aspect', 1.16475, 1.21469, 0.9384),
  ('table', 'aspect', 1.21469, 1.36903, 0.6244),
  ('table', 'aspect', 1.36903, 1.47547, 0.922),
  ('table', 'aspect', 1.47547, 1.51435, 1.38),
  ('table', 'aspect', 1.51435, 1.67336, 1.095),
  ('table', 'aspect', 1.67336, 1.79223, 1.454),
  ('table', 'aspect', 1.79223, 1.961, 1.373),
  ('table', 'aspect', 1.961, 2.11838, 1.449),
  ('table', 'aspect', 2.11838, 2.177, 1.154),
  ('table', 'aspect', 2.177, 2.47646, 0.6267),
  ('table', 'aspect', 2.47646, 2.64438, 0.4576),
  ('table', 'aspect', 2.64438, 3.21209, 0.2365),
  ('table', 'aspect', 3.21209, 3.90169, 0.05746),
  ('table', 'aspect', 3.90169, 4.73934, 0.03621),
  ('table', 'aspect', 4.73934, 5.75682, 0.03937),
  ('table', 'aspect', 5.75682, 100, 0.003093);
DELETE FROM class_density WHERE class = 'table' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'height', -0.5, 0.0587027, 0.02372),
  ('table', 'height', 0.0587027, 0.176601, 0.0002086),
  ('table', 'height', 0.176601, 0.2945, 4.602e-05),
  ('table', 'height', 0.2945, 0.412398, 0.001391),
  ('table', 'height', 0.412398, 0.530297, 0.01682),
  ('table', 'height', 0.530297, 0.648195, 0.7667),
  ('table', 'height', 0.648195, 0.687149, 3.372),
  ('table', 'height', 0.687149, 0.705974, 5.491),
  ('table', 'height', 0.705974, 0.722337, 6.16),
  ('table', 'height', 0.722337, 0.737703, 6.298),
  ('table', 'height', 0.737703, 0.759075, 5.284),
  ('table', 'height', 0.759075, 0.766094, 4.888),
  ('table', 'height', 0.766094, 0.779934, 4.663),
  ('table', 'height', 0.779934, 0.839271, 2.195),
  ('table', 'height', 0.839271, 0.883992, 0.9918),
  ('table', 'height', 0.883992, 1.00189, 0.3974),
  ('table', 'height', 1.00189, 1.11979, 0.1825),
  ('table', 'height', 1.11979, 4, 0.002483);
DELETE FROM class_density WHERE class = 'table' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'length', 0.03, 0.581683, 0.003631),
  ('table', 'length', 0.581683, 0.696632, 0.1427),
  ('table', 'length', 0.696632, 0.809828, 0.4358),
  ('table', 'length', 0.809828, 0.834296, 0.4727),
  ('table', 'length', 0.834296, 0.993919, 0.6083),
  ('table', 'length', 0.993919, 1.19662, 0.6295),
  ('table', 'length', 1.19662, 1.30179, 1.293),
  ('table', 'length', 1.30179, 1.43308, 0.9419),
  ('table', 'length', 1.43308, 1.45265, 1.081),
  ('table', 'length', 1.45265, 1.61883, 1.066),
  ('table', 'length', 1.61883, 1.71628, 1.48),
  ('table', 'length', 1.71628, 1.7477, 1.085),
  ('table', 'length', 1.7477, 1.9603, 0.9738),
  ('table', 'length', 1.9603, 2.05544, 0.7664),
  ('table', 'length', 2.05544, 2.46163, 0.2473),
  ('table', 'length', 2.46163, 2.94808, 0.1031),
  ('table', 'length', 2.94808, 30, 0.005775);
DELETE FROM class_density WHERE class = 'table' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'rectangularity', 0, 0.377504, 0.02844),
  ('table', 'rectangularity', 0.377504, 0.443054, 0.4179),
  ('table', 'rectangularity', 0.443054, 0.508604, 0.8817),
  ('table', 'rectangularity', 0.508604, 0.522146, 1.519),
  ('table', 'rectangularity', 0.522146, 0.574153, 1.415),
  ('table', 'rectangularity', 0.574153, 0.609568, 1.058),
  ('table', 'rectangularity', 0.609568, 0.639703, 2.976),
  ('table', 'rectangularity', 0.639703, 0.648011, 1.705),
  ('table', 'rectangularity', 0.648011, 0.67505, 3.976),
  ('table', 'rectangularity', 0.67505, 0.705253, 2.507),
  ('table', 'rectangularity', 0.705253, 0.720809, 2.57),
  ('table', 'rectangularity', 0.720809, 0.756956, 2.895),
  ('table', 'rectangularity', 0.756956, 0.770802, 2.302),
  ('table', 'rectangularity', 0.770802, 0.795656, 3.469),
  ('table', 'rectangularity', 0.795656, 0.836352, 2.386),
  ('table', 'rectangularity', 0.836352, 0.843309, 1.835),
  ('table', 'rectangularity', 0.843309, 0.901902, 1.112),
  ('table', 'rectangularity', 0.901902, 0.960055, 0.6495),
  ('table', 'rectangularity', 0.960055, 0.967451, 0.3571),
  ('table', 'rectangularity', 0.967451, 1, 0.2232);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_length', 0.01, 0.487513, 0.003211),
  ('table', 'spread_length', 0.487513, 0.584614, 0.1228),
  ('table', 'spread_length', 0.584614, 0.701054, 0.2198),
  ('table', 'spread_length', 0.701054, 0.765831, 0.4347),
  ('table', 'spread_length', 0.765831, 0.840686, 0.9366),
  ('table', 'spread_length', 0.840686, 0.86091, 0.9227),
  ('table', 'spread_length', 0.86091, 0.972335, 0.9149),
  ('table', 'spread_length', 0.972335, 1.00813, 0.5484),
  ('table', 'spread_length', 1.00813, 1.13762, 0.7445),
  ('table', 'spread_length', 1.13762, 1.20892, 0.9456),
  ('table', 'spread_length', 1.20892, 1.27375, 1.207),
  ('table', 'spread_length', 1.27375, 1.3502, 1.565),
  ('table', 'spread_length', 1.3502, 1.44971, 1.057),
  ('table', 'spread_length', 1.44971, 1.5084, 1.21),
  ('table', 'spread_length', 1.5084, 1.63614, 1.298),
  ('table', 'spread_length', 1.63614, 1.73846, 0.6143),
  ('table', 'spread_length', 1.73846, 2.08471, 0.2749),
  ('table', 'spread_length', 2.08471, 2.49993, 0.09186),
  ('table', 'spread_length', 2.49993, 40, 0.004367);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_width', 0.003, 0.131845, 0.002413),
  ('table', 'spread_width', 0.131845, 0.1701, 0.03411),
  ('table', 'spread_width', 0.1701, 0.219455, 0.05666),
  ('table', 'spread_width', 0.219455, 0.283131, 0.08534),
  ('table', 'spread_width', 0.283131, 0.365282, 0.1618),
  ('table', 'spread_width', 0.365282, 0.394777, 0.2136),
  ('table', 'spread_width', 0.394777, 0.471269, 0.3401),
  ('table', 'spread_width', 0.471269, 0.513519, 0.5991),
  ('table', 'spread_width', 0.513519, 0.608009, 0.6637),
  ('table', 'spread_width', 0.608009, 0.670696, 1.203),
  ('table', 'spread_width', 0.670696, 0.706229, 1.911),
  ('table', 'spread_width', 0.706229, 0.747382, 1.904),
  ('table', 'spread_width', 0.747382, 0.784424, 1.108),
  ('table', 'spread_width', 0.784424, 0.818121, 1.416),
  ('table', 'spread_width', 0.818121, 0.889733, 1.326),
  ('table', 'spread_width', 0.889733, 1.01203, 0.5067),
  ('table', 'spread_width', 1.01203, 1.30567, 0.151),
  ('table', 'spread_width', 1.30567, 20, 0.004305);
DELETE FROM class_density WHERE class = 'table' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'tilt_deg', 0, 0.168187, 1.16),
  ('table', 'tilt_deg', 0.168187, 0.34884, 1.028),
  ('table', 'tilt_deg', 0.34884, 0.501679, 0.825),
  ('table', 'tilt_deg', 0.501679, 0.69768, 0.6187),
  ('table', 'tilt_deg', 0.69768, 1.03478, 0.4209),
  ('table', 'tilt_deg', 1.03478, 1.39536, 0.2776),
  ('table', 'tilt_deg', 1.39536, 1.7442, 0.1812),
  ('table', 'tilt_deg', 1.7442, 2.09304, 0.1021),
  ('table', 'tilt_deg', 2.09304, 2.44188, 0.04379),
  ('table', 'tilt_deg', 2.44188, 2.79072, 0.01838),
  ('table', 'tilt_deg', 2.79072, 3.13956, 0.0131),
  ('table', 'tilt_deg', 3.13956, 90, 5.509e-05);
DELETE FROM class_density WHERE class = 'table' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'width', 0.01, 0.217699, 0.004141),
  ('table', 'width', 0.217699, 0.275147, 0.0752),
  ('table', 'width', 0.275147, 0.347755, 0.06982),
  ('table', 'width', 0.347755, 0.439523, 0.1297),
  ('table', 'width', 0.439523, 0.527622, 0.2424),
  ('table', 'width', 0.527622, 0.555507, 0.3618),
  ('table', 'width', 0.555507, 0.651467, 0.5278),
  ('table', 'width', 0.651467, 0.702099, 0.9709),
  ('table', 'width', 0.702099, 0.722432, 1.474),
  ('table', 'width', 0.722432, 0.782849, 1.305),
  ('table', 'width', 0.782849, 0.846823, 1.5),
  ('table', 'width', 0.846823, 0.887374, 1.759),
  ('table', 'width', 0.887374, 0.903217, 1.77),
  ('table', 'width', 0.903217, 0.962309, 1.542),
  ('table', 'width', 0.962309, 1.06411, 1.061),
  ('table', 'width', 1.06411, 1.12154, 0.8262),
  ('table', 'width', 1.12154, 1.4175, 0.2134),
  ('table', 'width', 1.4175, 1.79156, 0.07619),
  ('table', 'width', 1.79156, 12, 0.004886);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_max', -0.5, 0.0713552, 0.02321),
  ('table', 'z_max', 0.0713552, 0.189806, 0.0001057),
  ('table', 'z_max', 0.189806, 0.308256, 5.783e-05),
  ('table', 'z_max', 0.308256, 0.426707, 0.001669),
  ('table', 'z_max', 0.426707, 0.545157, 0.01917),
  ('table', 'z_max', 0.545157, 0.663608, 0.854),
  ('table', 'z_max', 0.663608, 0.693184, 4.146),
  ('table', 'z_max', 0.693184, 0.711346, 5.61),
  ('table', 'z_max', 0.711346, 0.729475, 6.016),
  ('table', 'z_max', 0.729475, 0.746367, 6.169),
  ('table', 'z_max', 0.746367, 0.765032, 5.472),
  ('table', 'z_max', 0.765032, 0.782058, 4.831),
  ('table', 'z_max', 0.782058, 0.850332, 2.125),
  ('table', 'z_max', 0.850332, 0.900509, 0.8388),
  ('table', 'z_max', 0.900509, 1.01896, 0.3962),
  ('table', 'z_max', 1.01896, 1.13072, 0.1875),
  ('table', 'z_max', 1.13072, 1.13741, 0.2718),
  ('table', 'z_max', 1.13741, 4, 0.001421);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_min', -0.5, 0.0474235, 0.02416),
  ('table', 'z_min', 0.0474235, 0.164435, 0.0004233),
  ('table', 'z_min', 0.164435, 0.281447, 3.454e-05),
  ('table', 'z_min', 0.281447, 0.39846, 0.001107),
  ('table', 'z_min', 0.39846, 0.515472, 0.01431),
  ('table', 'z_min', 0.515472, 0.632484, 0.5471),
  ('table', 'z_min', 0.632484, 0.644704, 3.127),
  ('table', 'z_min', 0.644704, 0.683043, 3.252),
  ('table', 'z_min', 0.683043, 0.702114, 5.428),
  ('table', 'z_min', 0.702114, 0.72007, 5.914),
  ('table', 'z_min', 0.72007, 0.734043, 6.279),
  ('table', 'z_min', 0.734043, 0.749496, 5.325),
  ('table', 'z_min', 0.749496, 0.756188, 4.761),
  ('table', 'z_min', 0.756188, 0.7776, 4.728),
  ('table', 'z_min', 0.7776, 0.831886, 2.287),
  ('table', 'z_min', 0.831886, 0.866508, 1.2),
  ('table', 'z_min', 0.866508, 0.98352, 0.4144),
  ('table', 'z_min', 0.98352, 1.10053, 0.1862),
  ('table', 'z_min', 1.10053, 4, 0.00318);

-- flat_screen: 176 examples
UPDATE object_class SET prior = 0.03776 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.796, 0.442)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.4287, 0.2239)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.031, 0.1199)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.5518, 0.3089)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.7827, 0.1313)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7406, 0.2387)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.196, 0.1925)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.08, 3.513)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -0.9827, 0.2416)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.195, 0.129)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7861, 0.1792)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'area_m2', 0.002, 0.0455965, 0.002951),
  ('flat_screen', 'area_m2', 0.0455965, 0.0587429, 0.05592),
  ('flat_screen', 'area_m2', 0.0587429, 0.0756796, 0.09579),
  ('flat_screen', 'area_m2', 0.0756796, 0.0966379, 0.2498),
  ('flat_screen', 'area_m2', 0.0966379, 0.117989, 0.5382),
  ('flat_screen', 'area_m2', 0.117989, 0.12561, 0.7642),
  ('flat_screen', 'area_m2', 0.12561, 0.139843, 0.6724),
  ('flat_screen', 'area_m2', 0.139843, 0.160904, 0.783),
  ('flat_screen', 'area_m2', 0.160904, 0.178077, 1.052),
  ('flat_screen', 'area_m2', 0.178077, 0.208484, 0.6847),
  ('flat_screen', 'area_m2', 0.208484, 0.240509, 0.8219),
  ('flat_screen', 'area_m2', 0.240509, 0.268594, 0.8787),
  ('flat_screen', 'area_m2', 0.268594, 0.273538, 0.5376),
  ('flat_screen', 'area_m2', 0.273538, 0.346035, 0.3562),
  ('flat_screen', 'area_m2', 0.346035, 0.445803, 0.08072),
  ('flat_screen', 'area_m2', 0.445803, 100, 0.002005);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'aspect', 1, 1.12776, 0.5657),
  ('flat_screen', 'aspect', 1.12776, 1.1906, 0.7213),
  ('flat_screen', 'aspect', 1.1906, 1.27184, 1.564),
  ('flat_screen', 'aspect', 1.27184, 1.37948, 1.518),
  ('flat_screen', 'aspect', 1.37948, 1.43432, 1.585),
  ('flat_screen', 'aspect', 1.43432, 1.46049, 2.196),
  ('flat_screen', 'aspect', 1.46049, 1.58902, 1.537),
  ('flat_screen', 'aspect', 1.58902, 1.61756, 3.443),
  ('flat_screen', 'aspect', 1.61756, 1.63559, 3.349),
  ('flat_screen', 'aspect', 1.63559, 1.72359, 2.061),
  ('flat_screen', 'aspect', 1.72359, 1.82422, 0.8228),
  ('flat_screen', 'aspect', 1.82422, 2.05728, 0.6249),
  ('flat_screen', 'aspect', 2.05728, 2.32011, 0.3905),
  ('flat_screen', 'aspect', 2.32011, 2.61651, 0.2812),
  ('flat_screen', 'aspect', 2.61651, 2.95079, 0.131),
  ('flat_screen', 'aspect', 2.95079, 100, 0.002949);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'height', -0.5, 0.666089, 0.009188),
  ('flat_screen', 'height', 0.666089, 0.74725, 0.006407),
  ('flat_screen', 'height', 0.74725, 0.82841, 0.1278),
  ('flat_screen', 'height', 0.82841, 0.909571, 0.8783),
  ('flat_screen', 'height', 0.909571, 0.924582, 1.587),
  ('flat_screen', 'height', 0.924582, 0.960948, 3.278),
  ('flat_screen', 'height', 0.960948, 0.98424, 4.585),
  ('flat_screen', 'height', 0.98424, 0.990731, 5.541),
  ('flat_screen', 'height', 0.990731, 1.00091, 6.084),
  ('flat_screen', 'height', 1.00091, 1.01931, 5.552),
  ('flat_screen', 'height', 1.01931, 1.04155, 4.504),
  ('flat_screen', 'height', 1.04155, 1.07189, 3.67),
  ('flat_screen', 'height', 1.07189, 1.15305, 1.5),
  ('flat_screen', 'height', 1.15305, 1.17098, 0.7433),
  ('flat_screen', 'height', 1.17098, 1.23421, 0.5215),
  ('flat_screen', 'height', 1.23421, 1.31537, 0.3129),
  ('flat_screen', 'height', 1.31537, 1.39653, 0.5325),
  ('flat_screen', 'height', 1.39653, 4, 0.003473);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'length', 0.03, 0.282466, 0.004011),
  ('flat_screen', 'length', 0.282466, 0.335576, 0.142),
  ('flat_screen', 'length', 0.335576, 0.398673, 0.4462),
  ('flat_screen', 'length', 0.398673, 0.44784, 0.9223),
  ('flat_screen', 'length', 0.44784, 0.473633, 0.8755),
  ('flat_screen', 'length', 0.473633, 0.505824, 0.9489),
  ('flat_screen', 'length', 0.505824, 0.542282, 1.67),
  ('flat_screen', 'length', 0.542282, 0.562688, 1.569),
  ('flat_screen', 'length', 0.562688, 0.590655, 1.24),
  ('flat_screen', 'length', 0.590655, 0.641664, 1.294),
  ('flat_screen', 'length', 0.641664, 0.668488, 0.8523),
  ('flat_screen', 'length', 0.668488, 0.723171, 0.9003),
  ('flat_screen', 'length', 0.723171, 0.79418, 0.8315),
  ('flat_screen', 'length', 0.79418, 0.84053, 0.4921),
  ('flat_screen', 'length', 0.84053, 0.943506, 0.3644),
  ('flat_screen', 'length', 0.943506, 1.12091, 0.2816),
  ('flat_screen', 'length', 1.12091, 1.33167, 0.1154),
  ('flat_screen', 'length', 1.33167, 30, 0.002379);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'rectangularity', 0, 0.451148, 0.02387),
  ('flat_screen', 'rectangularity', 0.451148, 0.511917, 0.2248),
  ('flat_screen', 'rectangularity', 0.511917, 0.572685, 0.6148),
  ('flat_screen', 'rectangularity', 0.572685, 0.592187, 2.019),
  ('flat_screen', 'rectangularity', 0.592187, 0.633454, 1.246),
  ('flat_screen', 'rectangularity', 0.633454, 0.674272, 1.593),
  ('flat_screen', 'rectangularity', 0.674272, 0.694222, 3.42),
  ('flat_screen', 'rectangularity', 0.694222, 0.712324, 2.639),
  ('flat_screen', 'rectangularity', 0.712324, 0.75499, 1.846),
  ('flat_screen', 'rectangularity', 0.75499, 0.773027, 1.836),
  ('flat_screen', 'rectangularity', 0.773027, 0.815759, 1.704),
  ('flat_screen', 'rectangularity', 0.815759, 0.832214, 2.353),
  ('flat_screen', 'rectangularity', 0.832214, 0.866328, 3.496),
  ('flat_screen', 'rectangularity', 0.866328, 0.876527, 4.23),
  ('flat_screen', 'rectangularity', 0.876527, 0.896902, 3.014),
  ('flat_screen', 'rectangularity', 0.896902, 0.937296, 1.722),
  ('flat_screen', 'rectangularity', 0.937296, 0.94767, 4.323),
  ('flat_screen', 'rectangularity', 0.94767, 0.982171, 2.711),
  ('flat_screen', 'rectangularity', 0.982171, 1, 0.6331);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_length', 0.01, 0.285082, 0.002834),
  ('flat_screen', 'spread_length', 0.285082, 0.327616, 0.2),
  ('flat_screen', 'spread_length', 0.327616, 0.350324, 1.178),
  ('flat_screen', 'spread_length', 0.350324, 0.376496, 1.062),
  ('flat_screen', 'spread_length', 0.376496, 0.381976, 1.244),
  ('flat_screen', 'spread_length', 0.381976, 0.431703, 1.02),
  ('flat_screen', 'spread_length', 0.431703, 0.458739, 1.74),
  ('flat_screen', 'spread_length', 0.458739, 0.497223, 1.231),
  ('flat_screen', 'spread_length', 0.497223, 0.508411, 1.334),
  ('flat_screen', 'spread_length', 0.508411, 0.532376, 2.116),
  ('flat_screen', 'spread_length', 0.532376, 0.570486, 1.75),
  ('flat_screen', 'spread_length', 0.570486, 0.617835, 1.244),
  ('flat_screen', 'spread_length', 0.617835, 0.656662, 0.5398),
  ('flat_screen', 'spread_length', 0.656662, 0.754635, 0.3219),
  ('flat_screen', 'spread_length', 0.754635, 0.867226, 0.121),
  ('flat_screen', 'spread_length', 0.867226, 0.996616, 0.06704),
  ('flat_screen', 'spread_length', 0.996616, 40, 0.002279);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_width', 0.003, 0.149197, 0.002764),
  ('flat_screen', 'spread_width', 0.149197, 0.170075, 0.08589),
  ('flat_screen', 'spread_width', 0.170075, 0.193875, 0.1504),
  ('flat_screen', 'spread_width', 0.193875, 0.221006, 0.1477),
  ('flat_screen', 'spread_width', 0.221006, 0.250021, 0.4018),
  ('flat_screen', 'spread_width', 0.250021, 0.272474, 1.413),
  ('flat_screen', 'spread_width', 0.272474, 0.283995, 2.364),
  ('flat_screen', 'spread_width', 0.283995, 0.287188, 1.986),
  ('flat_screen', 'spread_width', 0.287188, 0.300178, 2.098),
  ('flat_screen', 'spread_width', 0.300178, 0.318732, 2.241),
  ('flat_screen', 'spread_width', 0.318732, 0.327377, 2.608),
  ('flat_screen', 'spread_width', 0.327377, 0.349088, 1.916),
  ('flat_screen', 'spread_width', 0.349088, 0.370734, 1.84),
  ('flat_screen', 'spread_width', 0.370734, 0.425413, 0.7192),
  ('flat_screen', 'spread_width', 0.425413, 0.484944, 0.0748),
  ('flat_screen', 'spread_width', 0.484944, 20, 0.00223);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'tilt_deg', 0, 75.2558, 0.000133),
  ('flat_screen', 'tilt_deg', 75.2558, 76.894, 0.003007),
  ('flat_screen', 'tilt_deg', 76.894, 78.5323, 0.003203),
  ('flat_screen', 'tilt_deg', 78.5323, 80.1705, 0.04692),
  ('flat_screen', 'tilt_deg', 80.1705, 80.4832, 0.04764),
  ('flat_screen', 'tilt_deg', 80.4832, 81.8088, 0.0839),
  ('flat_screen', 'tilt_deg', 81.8088, 83.2455, 0.07359),
  ('flat_screen', 'tilt_deg', 83.2455, 83.447, 0.08737),
  ('flat_screen', 'tilt_deg', 83.447, 84.7014, 0.07779),
  ('flat_screen', 'tilt_deg', 84.7014, 85.0853, 0.08643),
  ('flat_screen', 'tilt_deg', 85.0853, 85.9316, 0.09716),
  ('flat_screen', 'tilt_deg', 85.9316, 86.7235, 0.07857),
  ('flat_screen', 'tilt_deg', 86.7235, 87.6081, 0.0551),
  ('flat_screen', 'tilt_deg', 87.6081, 88.3618, 0.08654),
  ('flat_screen', 'tilt_deg', 88.3618, 88.729, 0.1546),
  ('flat_screen', 'tilt_deg', 88.729, 89.1825, 0.1994),
  ('flat_screen', 'tilt_deg', 89.1825, 90, 0.1433);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'width', 0.01, 0.179433, 0.002987),
  ('flat_screen', 'width', 0.179433, 0.20834, 0.07537),
  ('flat_screen', 'width', 0.20834, 0.241903, 0.1875),
  ('flat_screen', 'width', 0.241903, 0.275419, 0.4658),
  ('flat_screen', 'width', 0.275419, 0.280874, 1.217),
  ('flat_screen', 'width', 0.280874, 0.313134, 0.7707),
  ('flat_screen', 'width', 0.313134, 0.326123, 0.7195),
  ('flat_screen', 'width', 0.326123, 0.354112, 1.271),
  ('flat_screen', 'width', 0.354112, 0.373708, 1.853),
  ('flat_screen', 'width', 0.373708, 0.378662, 2.142),
  ('flat_screen', 'width', 0.378662, 0.394615, 1.952),
  ('flat_screen', 'width', 0.394615, 0.419207, 1.708),
  ('flat_screen', 'width', 0.419207, 0.439665, 1.894),
  ('flat_screen', 'width', 0.439665, 0.443922, 1.991),
  ('flat_screen', 'width', 0.443922, 0.470884, 1.833),
  ('flat_screen', 'width', 0.470884, 0.510496, 0.6988),
  ('flat_screen', 'width', 0.510496, 0.592737, 0.1934),
  ('flat_screen', 'width', 0.592737, 0.688228, 0.1563),
  ('flat_screen', 'width', 0.688228, 12, 0.004235);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_max', -0.5, 0.850191, 0.008055),
  ('flat_screen', 'z_max', 0.850191, 0.932445, 0.01375),
  ('flat_screen', 'z_max', 0.932445, 1.0147, 0.2945),
  ('flat_screen', 'z_max', 1.0147, 1.07872, 1.266),
  ('flat_screen', 'z_max', 1.07872, 1.09695, 2.899),
  ('flat_screen', 'z_max', 1.09695, 1.11017, 4.064),
  ('flat_screen', 'z_max', 1.11017, 1.13568, 4.343),
  ('flat_screen', 'z_max', 1.13568, 1.15619, 4.684),
  ('flat_screen', 'z_max', 1.15619, 1.17921, 4.592),
  ('flat_screen', 'z_max', 1.17921, 1.20589, 4.38),
  ('flat_screen', 'z_max', 1.20589, 1.24998, 2.848),
  ('flat_screen', 'z_max', 1.24998, 1.26146, 1.251),
  ('flat_screen', 'z_max', 1.26146, 1.34372, 0.8959),
  ('flat_screen', 'z_max', 1.34372, 1.38724, 0.6649),
  ('flat_screen', 'z_max', 1.38724, 1.42597, 0.6931),
  ('flat_screen', 'z_max', 1.42597, 1.50823, 0.4587),
  ('flat_screen', 'z_max', 1.50823, 1.59048, 0.3689),
  ('flat_screen', 'z_max', 1.59048, 4, 0.003832);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_min', -0.5, -0.0284, 0.01171),
  ('flat_screen', 'z_min', -0.0284, -0.0190414, 0.1541),
  ('flat_screen', 'z_min', -0.0190414, 0.112783, 0.09559),
  ('flat_screen', 'z_min', 0.112783, 0.253966, 0.01281),
  ('flat_screen', 'z_min', 0.253966, 0.395148, 0.01066),
  ('flat_screen', 'z_min', 0.395148, 0.536331, 0.06448),
  ('flat_screen', 'z_min', 0.536331, 0.6634, 0.7271),
  ('flat_screen', 'z_min', 0.6634, 0.677514, 3.396),
  ('flat_screen', 'z_min', 0.677514, 0.694026, 3.392),
  ('flat_screen', 'z_min', 0.694026, 0.732564, 3.186),
  ('flat_screen', 'z_min', 0.732564, 0.75348, 4.283),
  ('flat_screen', 'z_min', 0.75348, 0.794702, 2.85),
  ('flat_screen', 'z_min', 0.794702, 0.818697, 2.512),
  ('flat_screen', 'z_min', 0.818697, 0.834194, 2.535),
  ('flat_screen', 'z_min', 0.834194, 0.880206, 2.521),
  ('flat_screen', 'z_min', 0.880206, 0.958636, 1.389),
  ('flat_screen', 'z_min', 0.958636, 1.10106, 0.4585),
  ('flat_screen', 'z_min', 1.10106, 1.24225, 0.3054),
  ('flat_screen', 'z_min', 1.24225, 4, 0.003237);

-- keyboard: 115 examples
UPDATE object_class SET prior = 0.02473 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.78, 0.3791)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7704, 0.306)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7834, 0.1039)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.9096, 0.265)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.832, 0.07663)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9751, 0.2807)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.839, 0.1337)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.826, 2.168)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.682, 0.2161)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7911, 0.105)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.776, 0.1029)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'area_m2', 0.002, 0.0169243, 0.00338),
  ('keyboard', 'area_m2', 0.0169243, 0.0214842, 0.0775),
  ('keyboard', 'area_m2', 0.0214842, 0.0272728, 0.05744),
  ('keyboard', 'area_m2', 0.0272728, 0.0346209, 0.1697),
  ('keyboard', 'area_m2', 0.0346209, 0.0419219, 0.2282),
  ('keyboard', 'area_m2', 0.0419219, 0.0439489, 0.3889),
  ('keyboard', 'area_m2', 0.0439489, 0.0520844, 0.5226),
  ('keyboard', 'area_m2', 0.0520844, 0.0557901, 0.9944),
  ('keyboard', 'area_m2', 0.0557901, 0.0580935, 1.448),
  ('keyboard', 'area_m2', 0.0580935, 0.0619448, 1.446),
  ('keyboard', 'area_m2', 0.0619448, 0.0675064, 1.261),
  ('keyboard', 'area_m2', 0.0675064, 0.0708218, 0.9773),
  ('keyboard', 'area_m2', 0.0708218, 0.0743428, 1.25),
  ('keyboard', 'area_m2', 0.0743428, 0.0803767, 1.348),
  ('keyboard', 'area_m2', 0.0803767, 0.0899034, 0.9929),
  ('keyboard', 'area_m2', 0.0899034, 0.114126, 0.3584),
  ('keyboard', 'area_m2', 0.114126, 0.144875, 0.09467),
  ('keyboard', 'area_m2', 0.144875, 100, 0.001405);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'aspect', 1, 1.15908, 0.2926),
  ('keyboard', 'aspect', 1.15908, 1.34348, 0.2992),
  ('keyboard', 'aspect', 1.34348, 1.42089, 0.312),
  ('keyboard', 'aspect', 1.42089, 1.5572, 0.3548),
  ('keyboard', 'aspect', 1.5572, 1.75107, 0.7866),
  ('keyboard', 'aspect', 1.75107, 1.80493, 0.8166),
  ('keyboard', 'aspect', 1.80493, 1.9362, 1.163),
  ('keyboard', 'aspect', 1.9362, 2.09207, 1.253),
  ('keyboard', 'aspect', 2.09207, 2.33583, 1.141),
  ('keyboard', 'aspect', 2.33583, 2.42489, 1.075),
  ('keyboard', 'aspect', 2.42489, 2.58794, 1.194),
  ('keyboard', 'aspect', 2.58794, 2.8091, 1.171),
  ('keyboard', 'aspect', 2.8091, 3.06717, 1.245),
  ('keyboard', 'aspect', 3.06717, 3.25778, 0.8406),
  ('keyboard', 'aspect', 3.25778, 3.77605, 0.3726),
  ('keyboard', 'aspect', 3.77605, 100, 0.003694);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'height', -0.5, 0.616826, 0.01327),
  ('keyboard', 'height', 0.616826, 0.677239, 1.373),
  ('keyboard', 'height', 0.677239, 0.685295, 1.883),
  ('keyboard', 'height', 0.685295, 0.716664, 3.612),
  ('keyboard', 'height', 0.716664, 0.732787, 6.211),
  ('keyboard', 'height', 0.732787, 0.751409, 5.972),
  ('keyboard', 'height', 0.751409, 0.76628, 5.749),
  ('keyboard', 'height', 0.76628, 0.795488, 4.756),
  ('keyboard', 'height', 0.795488, 0.81976, 4.268),
  ('keyboard', 'height', 0.81976, 0.858479, 1.872),
  ('keyboard', 'height', 0.858479, 0.895998, 1.16),
  ('keyboard', 'height', 0.895998, 0.918892, 0.937),
  ('keyboard', 'height', 0.918892, 0.979305, 0.6472),
  ('keyboard', 'height', 0.979305, 1.03972, 0.2649),
  ('keyboard', 'height', 1.03972, 1.10013, 0.1854),
  ('keyboard', 'height', 1.10013, 1.16054, 0.3573),
  ('keyboard', 'height', 1.16054, 4, 0.003199);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'length', 0.03, 0.168294, 0.007276),
  ('keyboard', 'length', 0.168294, 0.192591, 0.1301),
  ('keyboard', 'length', 0.192591, 0.220397, 0.1898),
  ('keyboard', 'length', 0.220397, 0.252216, 0.1498),
  ('keyboard', 'length', 0.252216, 0.28863, 0.1623),
  ('keyboard', 'length', 0.28863, 0.303863, 0.5669),
  ('keyboard', 'length', 0.303863, 0.330301, 0.8929),
  ('keyboard', 'length', 0.330301, 0.341137, 0.8614),
  ('keyboard', 'length', 0.341137, 0.377989, 0.6016),
  ('keyboard', 'length', 0.377989, 0.419722, 0.6571),
  ('keyboard', 'length', 0.419722, 0.432561, 2.18),
  ('keyboard', 'length', 0.432561, 0.438376, 3.117),
  ('keyboard', 'length', 0.438376, 0.45192, 3.517),
  ('keyboard', 'length', 0.45192, 0.462594, 3.868),
  ('keyboard', 'length', 0.462594, 0.473819, 3.752),
  ('keyboard', 'length', 0.473819, 0.495012, 2.33),
  ('keyboard', 'length', 0.495012, 0.503849, 1.687),
  ('keyboard', 'length', 0.503849, 0.56648, 0.7954),
  ('keyboard', 'length', 0.56648, 30, 0.005205);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'rectangularity', 0, 0.670359, 0.02056),
  ('keyboard', 'rectangularity', 0.670359, 0.704744, 1.157),
  ('keyboard', 'rectangularity', 0.704744, 0.735727, 2.054),
  ('keyboard', 'rectangularity', 0.735727, 0.739129, 3.17),
  ('keyboard', 'rectangularity', 0.739129, 0.767143, 3.213),
  ('keyboard', 'rectangularity', 0.767143, 0.773514, 2.778),
  ('keyboard', 'rectangularity', 0.773514, 0.798955, 3.823),
  ('keyboard', 'rectangularity', 0.798955, 0.807899, 5.419),
  ('keyboard', 'rectangularity', 0.807899, 0.821512, 4.362),
  ('keyboard', 'rectangularity', 0.821512, 0.842283, 5.694),
  ('keyboard', 'rectangularity', 0.842283, 0.864456, 4.405),
  ('keyboard', 'rectangularity', 0.864456, 0.876668, 5.813),
  ('keyboard', 'rectangularity', 0.876668, 0.887276, 4.856),
  ('keyboard', 'rectangularity', 0.887276, 0.911053, 1.97),
  ('keyboard', 'rectangularity', 0.911053, 0.940135, 1.812),
  ('keyboard', 'rectangularity', 0.940135, 0.945438, 2.44),
  ('keyboard', 'rectangularity', 0.945438, 0.967015, 3.906),
  ('keyboard', 'rectangularity', 0.967015, 0.979823, 1.678),
  ('keyboard', 'rectangularity', 0.979823, 1, 0.1214);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_length', 0.01, 0.150565, 0.003074),
  ('keyboard', 'spread_length', 0.150565, 0.15514, 0.128),
  ('keyboard', 'spread_length', 0.15514, 0.172364, 0.1824),
  ('keyboard', 'spread_length', 0.172364, 0.197319, 0.2044),
  ('keyboard', 'spread_length', 0.197319, 0.225888, 0.1039),
  ('keyboard', 'spread_length', 0.225888, 0.258592, 0.09666),
  ('keyboard', 'spread_length', 0.258592, 0.285669, 0.3412),
  ('keyboard', 'spread_length', 0.285669, 0.296032, 1.147),
  ('keyboard', 'spread_length', 0.296032, 0.313058, 1.366),
  ('keyboard', 'spread_length', 0.313058, 0.338892, 0.7296),
  ('keyboard', 'spread_length', 0.338892, 0.387958, 0.4142),
  ('keyboard', 'spread_length', 0.387958, 0.413938, 1.623),
  ('keyboard', 'spread_length', 0.413938, 0.430698, 2.762),
  ('keyboard', 'spread_length', 0.430698, 0.444128, 2.623),
  ('keyboard', 'spread_length', 0.444128, 0.448994, 3.054),
  ('keyboard', 'spread_length', 0.448994, 0.459483, 3.631),
  ('keyboard', 'spread_length', 0.459483, 0.472067, 3.857),
  ('keyboard', 'spread_length', 0.472067, 0.50843, 1.529),
  ('keyboard', 'spread_length', 0.50843, 40, 0.004253);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_width', 0.003, 0.108757, 0.001082),
  ('keyboard', 'spread_width', 0.108757, 0.111755, 0.1591),
  ('keyboard', 'spread_width', 0.111755, 0.118007, 0.2414),
  ('keyboard', 'spread_width', 0.118007, 0.128043, 0.4795),
  ('keyboard', 'spread_width', 0.128043, 0.138932, 0.8193),
  ('keyboard', 'spread_width', 0.138932, 0.144621, 2.486),
  ('keyboard', 'spread_width', 0.144621, 0.149097, 3.223),
  ('keyboard', 'spread_width', 0.149097, 0.150748, 2.87),
  ('keyboard', 'spread_width', 0.150748, 0.157314, 2.682),
  ('keyboard', 'spread_width', 0.157314, 0.162256, 3.288),
  ('keyboard', 'spread_width', 0.162256, 0.166183, 3.442),
  ('keyboard', 'spread_width', 0.166183, 0.17387, 2.476),
  ('keyboard', 'spread_width', 0.17387, 0.177479, 1.384),
  ('keyboard', 'spread_width', 0.177479, 0.18914, 1.42),
  ('keyboard', 'spread_width', 0.18914, 0.192573, 1.631),
  ('keyboard', 'spread_width', 0.192573, 0.20895, 0.7034),
  ('keyboard', 'spread_width', 0.20895, 0.22672, 0.2076),
  ('keyboard', 'spread_width', 0.22672, 20, 0.002279);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'tilt_deg', 0, 0.252719, 0.05945),
  ('keyboard', 'tilt_deg', 0.252719, 0.915143, 0.1184),
  ('keyboard', 'tilt_deg', 0.915143, 1.07487, 0.1567),
  ('keyboard', 'tilt_deg', 1.07487, 1.68309, 0.1721),
  ('keyboard', 'tilt_deg', 1.68309, 1.83029, 0.1825),
  ('keyboard', 'tilt_deg', 1.83029, 2.45993, 0.1288),
  ('keyboard', 'tilt_deg', 2.45993, 2.74543, 0.1238),
  ('keyboard', 'tilt_deg', 2.74543, 3.46605, 0.1064),
  ('keyboard', 'tilt_deg', 3.46605, 3.66057, 0.08053),
  ('keyboard', 'tilt_deg', 3.66057, 4.31476, 0.152),
  ('keyboard', 'tilt_deg', 4.31476, 4.57572, 0.1604),
  ('keyboard', 'tilt_deg', 4.57572, 5.02843, 0.1449),
  ('keyboard', 'tilt_deg', 5.02843, 5.49086, 0.1335),
  ('keyboard', 'tilt_deg', 5.49086, 5.92577, 0.1496),
  ('keyboard', 'tilt_deg', 5.92577, 6.406, 0.1546),
  ('keyboard', 'tilt_deg', 6.406, 6.67159, 0.09513),
  ('keyboard', 'tilt_deg', 6.67159, 7.32114, 0.09422),
  ('keyboard', 'tilt_deg', 7.32114, 8.23629, 0.0375),
  ('keyboard', 'tilt_deg', 8.23629, 90, 0.0001517);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'width', 0.01, 0.124997, 0.004451),
  ('keyboard', 'width', 0.124997, 0.141632, 0.4502),
  ('keyboard', 'width', 0.141632, 0.147667, 1.337),
  ('keyboard', 'width', 0.147667, 0.153878, 2.394),
  ('keyboard', 'width', 0.153878, 0.160481, 2.087),
  ('keyboard', 'width', 0.160481, 0.162552, 1.417),
  ('keyboard', 'width', 0.162552, 0.176316, 1.503),
  ('keyboard', 'width', 0.176316, 0.181839, 1.428),
  ('keyboard', 'width', 0.181839, 0.188562, 1.578),
  ('keyboard', 'width', 0.188562, 0.199758, 1.849),
  ('keyboard', 'width', 0.199758, 0.206039, 1.431),
  ('keyboard', 'width', 0.206039, 0.221128, 1.261),
  ('keyboard', 'width', 0.221128, 0.23346, 1.125),
  ('keyboard', 'width', 0.23346, 0.242157, 0.8152),
  ('keyboard', 'width', 0.242157, 0.26453, 0.6514),
  ('keyboard', 'width', 0.26453, 0.299735, 0.2897),
  ('keyboard', 'width', 0.299735, 0.339625, 0.06592),
  ('keyboard', 'width', 0.339625, 0.384825, 0.03447),
  ('keyboard', 'width', 0.384825, 12, 0.003347);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_max', -0.5, 0.625795, 0.01268),
  ('keyboard', 'z_max', 0.625795, 0.686574, 1.57),
  ('keyboard', 'z_max', 0.686574, 0.723861, 3.231),
  ('keyboard', 'z_max', 0.723861, 0.738672, 6.282),
  ('keyboard', 'z_max', 0.738672, 0.747353, 6.12),
  ('keyboard', 'z_max', 0.747353, 0.761157, 5.711),
  ('keyboard', 'z_max', 0.761157, 0.775959, 5.433),
  ('keyboard', 'z_max', 0.775959, 0.803807, 4.362),
  ('keyboard', 'z_max', 0.803807, 0.82807, 4.268),
  ('keyboard', 'z_max', 0.82807, 0.868911, 2.045),
  ('keyboard', 'z_max', 0.868911, 0.903911, 1.081),
  ('keyboard', 'z_max', 0.903911, 0.92969, 0.8738),
  ('keyboard', 'z_max', 0.92969, 0.990469, 0.6082),
  ('keyboard', 'z_max', 0.990469, 1.05125, 0.2817),
  ('keyboard', 'z_max', 1.05125, 1.11203, 0.1881),
  ('keyboard', 'z_max', 1.11203, 1.17281, 0.3456),
  ('keyboard', 'z_max', 1.17281, 4, 0.003182);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_min', -0.5, 0.605324, 0.01374),
  ('keyboard', 'z_min', 0.605324, 0.665723, 1.132),
  ('keyboard', 'z_min', 0.665723, 0.680108, 2.168),
  ('keyboard', 'z_min', 0.680108, 0.709652, 3.735),
  ('keyboard', 'z_min', 0.709652, 0.725787, 5.929),
  ('keyboard', 'z_min', 0.725787, 0.745082, 5.963),
  ('keyboard', 'z_min', 0.745082, 0.763649, 5.878),
  ('keyboard', 'z_min', 0.763649, 0.785086, 5.237),
  ('keyboard', 'z_min', 0.785086, 0.8102, 4.199),
  ('keyboard', 'z_min', 0.8102, 0.846919, 1.852),
  ('keyboard', 'z_min', 0.846919, 0.889864, 1.221),
  ('keyboard', 'z_min', 0.889864, 0.907318, 0.9999),
  ('keyboard', 'z_min', 0.907318, 0.967716, 0.6984),
  ('keyboard', 'z_min', 0.967716, 1.02812, 0.2463),
  ('keyboard', 'z_min', 1.02812, 1.08851, 0.1811),
  ('keyboard', 'z_min', 1.08851, 1.14891, 0.3614),
  ('keyboard', 'z_min', 1.14891, 4, 0.003376);

-- chair_seat: 139 examples
UPDATE object_class SET prior = 0.0299 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.067, 0.5543)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.3135, 0.2956)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4731, 0.03376)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.722, 0.1931)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7487, 0.1397)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7649, 0.1864)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.223, 0.3864)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 1.111, 0.9372)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.036, 0.3622)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4779, 0.03386)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4695, 0.03413)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'area_m2', 0.002, 0.0253221, 0.003548),
  ('chair_seat', 'area_m2', 0.0253221, 0.0331561, 0.07696),
  ('chair_seat', 'area_m2', 0.0331561, 0.0434138, 0.1307),
  ('chair_seat', 'area_m2', 0.0434138, 0.056845, 0.141),
  ('chair_seat', 'area_m2', 0.056845, 0.0596666, 0.1746),
  ('chair_seat', 'area_m2', 0.0596666, 0.0744313, 0.2885),
  ('chair_seat', 'area_m2', 0.0744313, 0.086141, 0.3544),
  ('chair_seat', 'area_m2', 0.086141, 0.0974585, 0.3741),
  ('chair_seat', 'area_m2', 0.0974585, 0.107811, 0.5847),
  ('chair_seat', 'area_m2', 0.107811, 0.12761, 0.4306),
  ('chair_seat', 'area_m2', 0.12761, 0.145249, 0.4409),
  ('chair_seat', 'area_m2', 0.145249, 0.165379, 0.7883),
  ('chair_seat', 'area_m2', 0.165379, 0.183685, 1.114),
  ('chair_seat', 'area_m2', 0.183685, 0.194073, 1.515),
  ('chair_seat', 'area_m2', 0.194073, 0.21621, 1.083),
  ('chair_seat', 'area_m2', 0.21621, 0.286248, 0.38),
  ('chair_seat', 'area_m2', 0.286248, 100, 0.002027);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'aspect', 1, 1.03974, 2.808),
  ('chair_seat', 'aspect', 1.03974, 1.08709, 2.36),
  ('chair_seat', 'aspect', 1.08709, 1.12829, 2.774),
  ('chair_seat', 'aspect', 1.12829, 1.14135, 2.449),
  ('chair_seat', 'aspect', 1.14135, 1.17089, 3.272),
  ('chair_seat', 'aspect', 1.17089, 1.25981, 1.576),
  ('chair_seat', 'aspect', 1.25981, 1.30268, 1.251),
  ('chair_seat', 'aspect', 1.30268, 1.3863, 1.041),
  ('chair_seat', 'aspect', 1.3863, 1.48681, 0.6276),
  ('chair_seat', 'aspect', 1.48681, 1.69697, 0.4187),
  ('chair_seat', 'aspect', 1.69697, 1.76929, 0.5612),
  ('chair_seat', 'aspect', 1.76929, 1.93684, 0.7366),
  ('chair_seat', 'aspect', 1.93684, 2.09253, 0.6568),
  ('chair_seat', 'aspect', 2.09253, 2.21061, 0.4027),
  ('chair_seat', 'aspect', 2.21061, 2.52308, 0.2869),
  ('chair_seat', 'aspect', 2.52308, 2.87971, 0.1948),
  ('chair_seat', 'aspect', 2.87971, 3.28676, 0.08953),
  ('chair_seat', 'aspect', 3.28676, 100, 0.003142);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'height', -0.5, 0.384627, 0.008428),
  ('chair_seat', 'height', 0.384627, 0.405421, 0.8491),
  ('chair_seat', 'height', 0.405421, 0.425946, 4.33),
  ('chair_seat', 'height', 0.425946, 0.437725, 6.844),
  ('chair_seat', 'height', 0.437725, 0.447009, 7),
  ('chair_seat', 'height', 0.447009, 0.458507, 7.593),
  ('chair_seat', 'height', 0.458507, 0.467803, 8.771),
  ('chair_seat', 'height', 0.467803, 0.481591, 9.309),
  ('chair_seat', 'height', 0.481591, 0.488597, 9.631),
  ('chair_seat', 'height', 0.488597, 0.494778, 10.18),
  ('chair_seat', 'height', 0.494778, 0.503396, 10.65),
  ('chair_seat', 'height', 0.503396, 0.509392, 10.15),
  ('chair_seat', 'height', 0.509392, 0.530186, 5.978),
  ('chair_seat', 'height', 0.530186, 0.55098, 1.093),
  ('chair_seat', 'height', 0.55098, 0.571774, 0.2699),
  ('chair_seat', 'height', 0.571774, 4, 0.002212);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'length', 0.03, 0.256938, 0.003542),
  ('chair_seat', 'length', 0.256938, 0.292513, 0.1526),
  ('chair_seat', 'length', 0.292513, 0.333013, 0.2402),
  ('chair_seat', 'length', 0.333013, 0.379121, 0.2233),
  ('chair_seat', 'length', 0.379121, 0.40214, 0.4308),
  ('chair_seat', 'length', 0.40214, 0.431613, 0.9722),
  ('chair_seat', 'length', 0.431613, 0.444922, 1.383),
  ('chair_seat', 'length', 0.444922, 0.47248, 1.977),
  ('chair_seat', 'length', 0.47248, 0.485816, 3.706),
  ('chair_seat', 'length', 0.485816, 0.491372, 3.956),
  ('chair_seat', 'length', 0.491372, 0.500918, 3.691),
  ('chair_seat', 'length', 0.500918, 0.513122, 3.486),
  ('chair_seat', 'length', 0.513122, 0.540809, 2.461),
  ('chair_seat', 'length', 0.540809, 0.559405, 2.129),
  ('chair_seat', 'length', 0.559405, 0.576343, 1.237),
  ('chair_seat', 'length', 0.576343, 0.636858, 0.5841),
  ('chair_seat', 'length', 0.636858, 0.725035, 0.1981),
  ('chair_seat', 'length', 0.725035, 0.825421, 0.1762),
  ('chair_seat', 'length', 0.825421, 30, 0.00262);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'rectangularity', 0, 0.370504, 0.0231),
  ('chair_seat', 'rectangularity', 0.370504, 0.438094, 0.2866),
  ('chair_seat', 'rectangularity', 0.438094, 0.505683, 0.4641),
  ('chair_seat', 'rectangularity', 0.505683, 0.552388, 1.047),
  ('chair_seat', 'rectangularity', 0.552388, 0.573272, 1.293),
  ('chair_seat', 'rectangularity', 0.573272, 0.640861, 1.216),
  ('chair_seat', 'rectangularity', 0.640861, 0.698467, 2.155),
  ('chair_seat', 'rectangularity', 0.698467, 0.70845, 1.761),
  ('chair_seat', 'rectangularity', 0.70845, 0.768967, 1.496),
  ('chair_seat', 'rectangularity', 0.768967, 0.776039, 2.16),
  ('chair_seat', 'rectangularity', 0.776039, 0.797317, 4.685),
  ('chair_seat', 'rectangularity', 0.797317, 0.824346, 3.543),
  ('chair_seat', 'rectangularity', 0.824346, 0.843629, 2.643),
  ('chair_seat', 'rectangularity', 0.843629, 0.858844, 4.062),
  ('chair_seat', 'rectangularity', 0.858844, 0.906723, 2.262),
  ('chair_seat', 'rectangularity', 0.906723, 0.957852, 1.965),
  ('chair_seat', 'rectangularity', 0.957852, 0.978807, 0.7119),
  ('chair_seat', 'rectangularity', 0.978807, 1, 0.1481);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_length', 0.01, 0.233952, 0.001027),
  ('chair_seat', 'spread_length', 0.233952, 0.242618, 0.1755),
  ('chair_seat', 'spread_length', 0.242618, 0.262647, 0.1849),
  ('chair_seat', 'spread_length', 0.262647, 0.294862, 0.1611),
  ('chair_seat', 'spread_length', 0.294862, 0.331028, 0.2201),
  ('chair_seat', 'spread_length', 0.331028, 0.37163, 0.375),
  ('chair_seat', 'spread_length', 0.37163, 0.378349, 0.3578),
  ('chair_seat', 'spread_length', 0.378349, 0.417211, 0.5399),
  ('chair_seat', 'spread_length', 0.417211, 0.437428, 1.444),
  ('chair_seat', 'spread_length', 0.437428, 0.461292, 2.13),
  ('chair_seat', 'spread_length', 0.461292, 0.468384, 2.76),
  ('chair_seat', 'spread_length', 0.468384, 0.477107, 3.151),
  ('chair_seat', 'spread_length', 0.477107, 0.491665, 3.366),
  ('chair_seat', 'spread_length', 0.491665, 0.507278, 3.587),
  ('chair_seat', 'spread_length', 0.507278, 0.524167, 3.171),
  ('chair_seat', 'spread_length', 0.524167, 0.546275, 2.419),
  ('chair_seat', 'spread_length', 0.546275, 0.590329, 1.16),
  ('chair_seat', 'spread_length', 0.590329, 0.662735, 0.2525),
  ('chair_seat', 'spread_length', 0.662735, 40, 0.002688);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_width', 0.003, 0.113685, 0.002714),
  ('chair_seat', 'spread_width', 0.113685, 0.133876, 0.1752),
  ('chair_seat', 'spread_width', 0.133876, 0.157653, 0.3659),
  ('chair_seat', 'spread_width', 0.157653, 0.161502, 0.5568),
  ('chair_seat', 'spread_width', 0.161502, 0.185653, 0.5483),
  ('chair_seat', 'spread_width', 0.185653, 0.208291, 0.3249),
  ('chair_seat', 'spread_width', 0.208291, 0.218626, 0.2941),
  ('chair_seat', 'spread_width', 0.218626, 0.257455, 0.4082),
  ('chair_seat', 'spread_width', 0.257455, 0.267318, 0.5327),
  ('chair_seat', 'spread_width', 0.267318, 0.30318, 0.5159),
  ('chair_seat', 'spread_width', 0.30318, 0.332, 0.8227),
  ('chair_seat', 'spread_width', 0.332, 0.357026, 1.238),
  ('chair_seat', 'spread_width', 0.357026, 0.361855, 1.268),
  ('chair_seat', 'spread_width', 0.361855, 0.378822, 1.941),
  ('chair_seat', 'spread_width', 0.378822, 0.399325, 2.128),
  ('chair_seat', 'spread_width', 0.399325, 0.420436, 1.659),
  ('chair_seat', 'spread_width', 0.420436, 0.426155, 1.415),
  ('chair_seat', 'spread_width', 0.426155, 0.479198, 0.8781),
  ('chair_seat', 'spread_width', 0.479198, 0.495107, 0.2257),
  ('chair_seat', 'spread_width', 0.495107, 20, 0.002903);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'tilt_deg', 0, 0.248663, 0.531),
  ('chair_seat', 'tilt_deg', 0.248663, 0.400822, 0.6317),
  ('chair_seat', 'tilt_deg', 0.400822, 0.518032, 0.6771),
  ('chair_seat', 'tilt_deg', 0.518032, 0.657747, 0.6692),
  ('chair_seat', 'tilt_deg', 0.657747, 0.85888, 0.5845),
  ('chair_seat', 'tilt_deg', 0.85888, 1.03606, 0.4396),
  ('chair_seat', 'tilt_deg', 1.03606, 1.5541, 0.259),
  ('chair_seat', 'tilt_deg', 1.5541, 1.73405, 0.2277),
  ('chair_seat', 'tilt_deg', 1.73405, 2.07213, 0.2045),
  ('chair_seat', 'tilt_deg', 2.07213, 2.33458, 0.1535),
  ('chair_seat', 'tilt_deg', 2.33458, 2.59016, 0.1038),
  ('chair_seat', 'tilt_deg', 2.59016, 3.10819, 0.07926),
  ('chair_seat', 'tilt_deg', 3.10819, 3.62622, 0.05779),
  ('chair_seat', 'tilt_deg', 3.62622, 4.14425, 0.01611),
  ('chair_seat', 'tilt_deg', 4.14425, 4.66229, 0.008046),
  ('chair_seat', 'tilt_deg', 4.66229, 90, 0.0001051);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'width', 0.01, 0.140395, 0.004552),
  ('chair_seat', 'width', 0.140395, 0.142181, 0.1887),
  ('chair_seat', 'width', 0.142181, 0.163872, 0.2735),
  ('chair_seat', 'width', 0.163872, 0.191275, 0.2797),
  ('chair_seat', 'width', 0.191275, 0.199717, 0.3344),
  ('chair_seat', 'width', 0.199717, 0.22326, 0.3874),
  ('chair_seat', 'width', 0.22326, 0.260594, 0.3972),
  ('chair_seat', 'width', 0.260594, 0.304172, 0.3806),
  ('chair_seat', 'width', 0.304172, 0.355036, 0.4158),
  ('chair_seat', 'width', 0.355036, 0.360091, 0.5032),
  ('chair_seat', 'width', 0.360091, 0.409946, 0.9404),
  ('chair_seat', 'width', 0.409946, 0.414406, 2.467),
  ('chair_seat', 'width', 0.414406, 0.424482, 2.839),
  ('chair_seat', 'width', 0.424482, 0.442009, 2.782),
  ('chair_seat', 'width', 0.442009, 0.461601, 2.283),
  ('chair_seat', 'width', 0.461601, 0.483704, 2.026),
  ('chair_seat', 'width', 0.483704, 0.563358, 0.7666),
  ('chair_seat', 'width', 0.563358, 12, 0.004629);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_max', -0.5, 0.39058, 0.008352),
  ('chair_seat', 'z_max', 0.39058, 0.411325, 0.8544),
  ('chair_seat', 'z_max', 0.411325, 0.431282, 4.618),
  ('chair_seat', 'z_max', 0.431282, 0.441061, 7.075),
  ('chair_seat', 'z_max', 0.441061, 0.452813, 7.185),
  ('chair_seat', 'z_max', 0.452813, 0.460475, 7.614),
  ('chair_seat', 'z_max', 0.460475, 0.473557, 8.681),
  ('chair_seat', 'z_max', 0.473557, 0.484441, 9.017),
  ('chair_seat', 'z_max', 0.484441, 0.494301, 8.989),
  ('chair_seat', 'z_max', 0.494301, 0.501549, 9.96),
  ('chair_seat', 'z_max', 0.501549, 0.508904, 10.8),
  ('chair_seat', 'z_max', 0.508904, 0.515045, 10.36),
  ('chair_seat', 'z_max', 0.515045, 0.535789, 5.826),
  ('chair_seat', 'z_max', 0.535789, 0.556534, 1.014),
  ('chair_seat', 'z_max', 0.556534, 0.577278, 0.2674),
  ('chair_seat', 'z_max', 0.577278, 4, 0.002253);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_min', -0.5, 0.377631, 0.008418),
  ('chair_seat', 'z_min', 0.377631, 0.398835, 0.7349),
  ('chair_seat', 'z_min', 0.398835, 0.42004, 3.643),
  ('chair_seat', 'z_min', 0.42004, 0.435312, 6.604),
  ('chair_seat', 'z_min', 0.435312, 0.441244, 7.018),
  ('chair_seat', 'z_min', 0.441244, 0.457007, 7.689),
  ('chair_seat', 'z_min', 0.457007, 0.464689, 9.023),
  ('chair_seat', 'z_min', 0.464689, 0.477876, 9.455),
  ('chair_seat', 'z_min', 0.477876, 0.483653, 9.592),
  ('chair_seat', 'z_min', 0.483653, 0.491618, 9.934),
  ('chair_seat', 'z_min', 0.491618, 0.499995, 10.31),
  ('chair_seat', 'z_min', 0.499995, 0.507973, 9.674),
  ('chair_seat', 'z_min', 0.507973, 0.526062, 5.779),
  ('chair_seat', 'z_min', 0.526062, 0.547266, 1.229),
  ('chair_seat', 'z_min', 0.547266, 0.568471, 0.2784),
  ('chair_seat', 'z_min', 0.568471, 4, 0.00219);

-- chair_back: 129 examples
UPDATE object_class SET prior = 0.02777 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.764, 0.5553)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3593, 0.2587)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8253, 0.09442)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5691, 0.2704)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7834, 0.1337)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.7051, 0.2413)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.124, 0.3688)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.79, 3.614)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9324, 0.3071)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.029, 0.1006)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4747, 0.1715)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'area_m2', 0.002, 0.0348631, 0.003841),
  ('chair_back', 'area_m2', 0.0348631, 0.0466262, 0.1185),
  ('chair_back', 'area_m2', 0.0466262, 0.0623584, 0.1466),
  ('chair_back', 'area_m2', 0.0623584, 0.0787977, 0.1215),
  ('chair_back', 'area_m2', 0.0787977, 0.0833987, 0.1257),
  ('chair_back', 'area_m2', 0.0833987, 0.111538, 0.1672),
  ('chair_back', 'area_m2', 0.111538, 0.127292, 0.3436),
  ('chair_back', 'area_m2', 0.127292, 0.149172, 0.3979),
  ('chair_back', 'area_m2', 0.149172, 0.168434, 0.6061),
  ('chair_back', 'area_m2', 0.168434, 0.191893, 0.8348),
  ('chair_back', 'area_m2', 0.191893, 0.199505, 1.607),
  ('chair_back', 'area_m2', 0.199505, 0.22238, 1.251),
  ('chair_back', 'area_m2', 0.22238, 0.245524, 1.076),
  ('chair_back', 'area_m2', 0.245524, 0.266819, 0.8464),
  ('chair_back', 'area_m2', 0.266819, 0.287376, 0.5813),
  ('chair_back', 'area_m2', 0.287376, 0.356847, 0.3384),
  ('chair_back', 'area_m2', 0.356847, 0.47725, 0.1071),
  ('chair_back', 'area_m2', 0.47725, 100, 0.002625);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'aspect', 1, 1.07633, 1.542),
  ('chair_back', 'aspect', 1.07633, 1.1294, 2.148),
  ('chair_back', 'aspect', 1.1294, 1.2029, 1.694),
  ('chair_back', 'aspect', 1.2029, 1.2791, 1.488),
  ('chair_back', 'aspect', 1.2791, 1.29872, 1.208),
  ('chair_back', 'aspect', 1.29872, 1.44663, 0.9817),
  ('chair_back', 'aspect', 1.44663, 1.58167, 1.428),
  ('chair_back', 'aspect', 1.58167, 1.6361, 0.8221),
  ('chair_back', 'aspect', 1.6361, 1.76596, 1.035),
  ('chair_back', 'aspect', 1.76596, 1.85039, 1.017),
  ('chair_back', 'aspect', 1.85039, 2.02148, 0.7968),
  ('chair_back', 'aspect', 2.02148, 2.09274, 0.6405),
  ('chair_back', 'aspect', 2.09274, 2.36684, 0.3857),
  ('chair_back', 'aspect', 2.36684, 2.67683, 0.156),
  ('chair_back', 'aspect', 2.67683, 3.02743, 0.07125),
  ('chair_back', 'aspect', 3.02743, 100, 0.003125);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'height', -0.5, 0.596051, 0.01002),
  ('chair_back', 'height', 0.596051, 0.648308, 0.4039),
  ('chair_back', 'height', 0.648308, 0.700565, 1.428),
  ('chair_back', 'height', 0.700565, 0.752822, 2.031),
  ('chair_back', 'height', 0.752822, 0.790256, 3.484),
  ('chair_back', 'height', 0.790256, 0.805079, 4.262),
  ('chair_back', 'height', 0.805079, 0.812288, 5.304),
  ('chair_back', 'height', 0.812288, 0.834915, 4.709),
  ('chair_back', 'height', 0.834915, 0.857336, 3.899),
  ('chair_back', 'height', 0.857336, 0.898898, 3.454),
  ('chair_back', 'height', 0.898898, 0.909592, 3.199),
  ('chair_back', 'height', 0.909592, 0.9422, 2.369),
  ('chair_back', 'height', 0.9422, 0.961849, 1.562),
  ('chair_back', 'height', 0.961849, 1.01411, 0.8268),
  ('chair_back', 'height', 1.01411, 1.06636, 0.4502),
  ('chair_back', 'height', 1.06636, 4, 0.003048);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'length', 0.03, 0.246982, 0.004895),
  ('chair_back', 'length', 0.246982, 0.292827, 0.06204),
  ('chair_back', 'length', 0.292827, 0.347181, 0.1464),
  ('chair_back', 'length', 0.347181, 0.411624, 0.2679),
  ('chair_back', 'length', 0.411624, 0.434379, 0.6911),
  ('chair_back', 'length', 0.434379, 0.476539, 1.004),
  ('chair_back', 'length', 0.476539, 0.48803, 1.011),
  ('chair_back', 'length', 0.48803, 0.511626, 1.982),
  ('chair_back', 'length', 0.511626, 0.542207, 1.846),
  ('chair_back', 'length', 0.542207, 0.575684, 1.821),
  ('chair_back', 'length', 0.575684, 0.637448, 1.108),
  ('chair_back', 'length', 0.637448, 0.686021, 1.182),
  ('chair_back', 'length', 0.686021, 0.700382, 0.9317),
  ('chair_back', 'length', 0.700382, 0.759347, 1.407),
  ('chair_back', 'length', 0.759347, 0.813359, 0.6672),
  ('chair_back', 'length', 0.813359, 0.964335, 0.1854),
  ('chair_back', 'length', 0.964335, 1.12875, 0.1562),
  ('chair_back', 'length', 1.12875, 1.14333, 0.1173),
  ('chair_back', 'length', 1.14333, 30, 0.002501);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'rectangularity', 0, 0.406894, 0.02585),
  ('chair_back', 'rectangularity', 0.406894, 0.472795, 0.2663),
  ('chair_back', 'rectangularity', 0.472795, 0.538695, 0.5377),
  ('chair_back', 'rectangularity', 0.538695, 0.594186, 0.8453),
  ('chair_back', 'rectangularity', 0.594186, 0.604596, 1.005),
  ('chair_back', 'rectangularity', 0.604596, 0.670497, 1.251),
  ('chair_back', 'rectangularity', 0.670497, 0.684145, 1.287),
  ('chair_back', 'rectangularity', 0.684145, 0.736397, 1.484),
  ('chair_back', 'rectangularity', 0.736397, 0.749835, 2.738),
  ('chair_back', 'rectangularity', 0.749835, 0.785296, 2.854),
  ('chair_back', 'rectangularity', 0.785296, 0.802298, 2.613),
  ('chair_back', 'rectangularity', 0.802298, 0.829342, 2.899),
  ('chair_back', 'rectangularity', 0.829342, 0.865934, 3.021),
  ('chair_back', 'rectangularity', 0.865934, 0.889886, 4.366),
  ('chair_back', 'rectangularity', 0.889886, 0.924287, 3.19),
  ('chair_back', 'rectangularity', 0.924287, 0.934099, 2.501),
  ('chair_back', 'rectangularity', 0.934099, 0.986462, 1.527),
  ('chair_back', 'rectangularity', 0.986462, 1, 0.8365);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_length', 0.01, 0.237047, 0.002848),
  ('chair_back', 'spread_length', 0.237047, 0.27702, 0.165),
  ('chair_back', 'spread_length', 0.27702, 0.323735, 0.1866),
  ('chair_back', 'spread_length', 0.323735, 0.367158, 0.3504),
  ('chair_back', 'spread_length', 0.367158, 0.378326, 0.2397),
  ('chair_back', 'spread_length', 0.378326, 0.442124, 0.683),
  ('chair_back', 'spread_length', 0.442124, 0.465276, 2.457),
  ('chair_back', 'spread_length', 0.465276, 0.484796, 2.372),
  ('chair_back', 'spread_length', 0.484796, 0.506038, 2.316),
  ('chair_back', 'spread_length', 0.506038, 0.516679, 2.482),
  ('chair_back', 'spread_length', 0.516679, 0.532786, 2.131),
  ('chair_back', 'spread_length', 0.532786, 0.574959, 1.456),
  ('chair_back', 'spread_length', 0.574959, 0.603807, 1.127),
  ('chair_back', 'spread_length', 0.603807, 0.625552, 1.27),
  ('chair_back', 'spread_length', 0.625552, 0.705628, 0.5864),
  ('chair_back', 'spread_length', 0.705628, 0.824618, 0.2235),
  ('chair_back', 'spread_length', 0.824618, 0.963674, 0.07992),
  ('chair_back', 'spread_length', 0.963674, 40, 0.002743);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_width', 0.003, 0.11338, 0.002386),
  ('chair_back', 'spread_width', 0.11338, 0.116433, 0.0917),
  ('chair_back', 'spread_width', 0.116433, 0.136306, 0.126),
  ('chair_back', 'spread_width', 0.136306, 0.163867, 0.18),
  ('chair_back', 'spread_width', 0.163867, 0.195912, 0.2629),
  ('chair_back', 'spread_width', 0.195912, 0.236836, 0.3186),
  ('chair_back', 'spread_width', 0.236836, 0.254539, 0.7926),
  ('chair_back', 'spread_width', 0.254539, 0.284724, 0.8613),
  ('chair_back', 'spread_width', 0.284724, 0.290528, 0.6807),
  ('chair_back', 'spread_width', 0.290528, 0.328708, 0.8392),
  ('chair_back', 'spread_width', 0.328708, 0.342296, 0.8655),
  ('chair_back', 'spread_width', 0.342296, 0.375678, 0.9445),
  ('chair_back', 'spread_width', 0.375678, 0.40671, 1.219),
  ('chair_back', 'spread_width', 0.40671, 0.441305, 1.379),
  ('chair_back', 'spread_width', 0.441305, 0.47891, 1.307),
  ('chair_back', 'spread_width', 0.47891, 0.494717, 1.185),
  ('chair_back', 'spread_width', 0.494717, 0.59475, 0.3694),
  ('chair_back', 'spread_width', 0.59475, 20, 0.003387);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'tilt_deg', 0, 73.0037, 0.0001475),
  ('chair_back', 'tilt_deg', 73.0037, 74.642, 0.02087),
  ('chair_back', 'tilt_deg', 74.642, 76.0868, 0.04744),
  ('chair_back', 'tilt_deg', 76.0868, 76.2802, 0.06265),
  ('chair_back', 'tilt_deg', 76.2802, 77.8023, 0.06446),
  ('chair_back', 'tilt_deg', 77.8023, 78.9064, 0.09859),
  ('chair_back', 'tilt_deg', 78.9064, 79.5567, 0.07763),
  ('chair_back', 'tilt_deg', 79.5567, 80.2411, 0.09638),
  ('chair_back', 'tilt_deg', 80.2411, 81.195, 0.1093),
  ('chair_back', 'tilt_deg', 81.195, 82.8332, 0.06981),
  ('chair_back', 'tilt_deg', 82.8332, 84.411, 0.07827),
  ('chair_back', 'tilt_deg', 84.411, 85.3074, 0.1066),
  ('chair_back', 'tilt_deg', 85.3074, 86.1097, 0.05515),
  ('chair_back', 'tilt_deg', 86.1097, 87.1005, 0.05133),
  ('chair_back', 'tilt_deg', 87.1005, 87.748, 0.02137),
  ('chair_back', 'tilt_deg', 87.748, 90, 0.001914);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'width', 0.01, 0.172487, 0.003947),
  ('chair_back', 'width', 0.172487, 0.205341, 0.2596),
  ('chair_back', 'width', 0.205341, 0.244454, 0.2805),
  ('chair_back', 'width', 0.244454, 0.25449, 0.3127),
  ('chair_back', 'width', 0.25449, 0.291017, 0.3902),
  ('chair_back', 'width', 0.291017, 0.338262, 0.4437),
  ('chair_back', 'width', 0.338262, 0.346449, 0.729),
  ('chair_back', 'width', 0.346449, 0.393422, 0.7569),
  ('chair_back', 'width', 0.393422, 0.41244, 1.292),
  ('chair_back', 'width', 0.41244, 0.423931, 2.021),
  ('chair_back', 'width', 0.423931, 0.440123, 2.759),
  ('chair_back', 'width', 0.440123, 0.460332, 2.251),
  ('chair_back', 'width', 0.460332, 0.47906, 2.575),
  ('chair_back', 'width', 0.47906, 0.491, 2.247),
  ('chair_back', 'width', 0.491, 0.514918, 1.28),
  ('chair_back', 'width', 0.514918, 0.584524, 0.506),
  ('chair_back', 'width', 0.584524, 0.695863, 0.1439),
  ('chair_back', 'width', 0.695863, 0.828409, 0.05638),
  ('chair_back', 'width', 0.828409, 12, 0.003863);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_max', -0.5, 0.771411, 0.009739),
  ('chair_back', 'z_max', 0.771411, 0.824619, 0.4309),
  ('chair_back', 'z_max', 0.824619, 0.877826, 0.8623),
  ('chair_back', 'z_max', 0.877826, 0.8991, 1.199),
  ('chair_back', 'z_max', 0.8991, 0.931033, 1.78),
  ('chair_back', 'z_max', 0.931033, 0.954005, 2.562),
  ('chair_back', 'z_max', 0.954005, 0.98424, 2.861),
  ('chair_back', 'z_max', 0.98424, 0.993321, 4.116),
  ('chair_back', 'z_max', 0.993321, 1.01372, 4.283),
  ('chair_back', 'z_max', 1.01372, 1.03745, 3.533),
  ('chair_back', 'z_max', 1.03745, 1.05043, 3.761),
  ('chair_back', 'z_max', 1.05043, 1.07786, 3.747),
  ('chair_back', 'z_max', 1.07786, 1.09065, 3.566),
  ('chair_back', 'z_max', 1.09065, 1.10566, 3.503),
  ('chair_back', 'z_max', 1.10566, 1.14386, 2.307),
  ('chair_back', 'z_max', 1.14386, 1.1556, 2.264),
  ('chair_back', 'z_max', 1.1556, 1.19707, 2.04),
  ('chair_back', 'z_max', 1.19707, 1.24593, 0.5252),
  ('chair_back', 'z_max', 1.24593, 4, 0.002827);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_min', -0.5, -0.0588705, 0.03091),
  ('chair_back', 'z_min', -0.0588705, 0.0442838, 0.1853),
  ('chair_back', 'z_min', 0.0442838, 0.147438, 0.1141),
  ('chair_back', 'z_min', 0.147438, 0.250592, 0.1452),
  ('chair_back', 'z_min', 0.250592, 0.317688, 0.7822),
  ('chair_back', 'z_min', 0.317688, 0.353747, 1.629),
  ('chair_back', 'z_min', 0.353747, 0.376246, 2.476),
  ('chair_back', 'z_min', 0.376246, 0.40581, 3.465),
  ('chair_back', 'z_min', 0.40581, 0.434638, 3.855),
  ('chair_back', 'z_min', 0.434638, 0.456901, 2.307),
  ('chair_back', 'z_min', 0.456901, 0.486157, 2.129),
  ('chair_back', 'z_min', 0.486157, 0.545813, 2.022),
  ('chair_back', 'z_min', 0.545813, 0.560055, 1.391),
  ('chair_back', 'z_min', 0.560055, 0.612229, 1.695),
  ('chair_back', 'z_min', 0.612229, 0.655129, 2.169),
  ('chair_back', 'z_min', 0.655129, 0.66321, 1.811),
  ('chair_back', 'z_min', 0.66321, 0.766364, 0.6022),
  ('chair_back', 'z_min', 0.766364, 0.854871, 0.3807),
  ('chair_back', 'z_min', 0.854871, 0.869518, 0.2603),
  ('chair_back', 'z_min', 0.869518, 4, 0.00325);

-- door: 61 examples
UPDATE object_class SET prior = 0.01311 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.2932, 0.5619)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.7776, 0.2521)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.143, 0.1859)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.6369, 0.2529)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8359, 0.108)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4792, 0.2653)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.2687, 0.3623)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.82, 0.5967)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1558, 0.3485)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.057, 0.2596)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.132, 0.2874)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'door' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'area_m2', 0.002, 0.120758, 0.003341),
  ('door', 'area_m2', 0.120758, 0.170354, 0.003632),
  ('door', 'area_m2', 0.170354, 0.240318, 0.03585),
  ('door', 'area_m2', 0.240318, 0.339017, 0.02732),
  ('door', 'area_m2', 0.339017, 0.478251, 0.102),
  ('door', 'area_m2', 0.478251, 0.674669, 0.05224),
  ('door', 'area_m2', 0.674669, 0.817027, 0.2033),
  ('door', 'area_m2', 0.817027, 0.951756, 0.3008),
  ('door', 'area_m2', 0.951756, 1.24036, 0.3328),
  ('door', 'area_m2', 1.24036, 1.34264, 0.871),
  ('door', 'area_m2', 1.34264, 1.40163, 0.9354),
  ('door', 'area_m2', 1.40163, 1.57682, 0.9072),
  ('door', 'area_m2', 1.57682, 1.66792, 1.627),
  ('door', 'area_m2', 1.66792, 1.76419, 1.999),
  ('door', 'area_m2', 1.76419, 1.8205, 2.088),
  ('door', 'area_m2', 1.8205, 1.89407, 1.573),
  ('door', 'area_m2', 1.89407, 1.97403, 1.361),
  ('door', 'area_m2', 1.97403, 2.67196, 0.3392),
  ('door', 'area_m2', 2.67196, 100, 0.008493);
DELETE FROM class_density WHERE class = 'door' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'aspect', 1, 1.19781, 0.06904),
  ('door', 'aspect', 1.19781, 1.23604, 0.2504),
  ('door', 'aspect', 1.23604, 1.41138, 0.3497),
  ('door', 'aspect', 1.41138, 1.63171, 0.3733),
  ('door', 'aspect', 1.63171, 1.66302, 0.5379),
  ('door', 'aspect', 1.66302, 1.87623, 0.8383),
  ('door', 'aspect', 1.87623, 1.95953, 0.8745),
  ('door', 'aspect', 1.95953, 2.06076, 1.651),
  ('door', 'aspect', 2.06076, 2.23885, 1.318),
  ('door', 'aspect', 2.23885, 2.29491, 3.53),
  ('door', 'aspect', 2.29491, 2.39331, 2.955),
  ('door', 'aspect', 2.39331, 2.4442, 3.592),
  ('door', 'aspect', 2.4442, 2.63547, 1.545),
  ('door', 'aspect', 2.63547, 2.72058, 0.6172),
  ('door', 'aspect', 2.72058, 3.20565, 0.3643),
  ('door', 'aspect', 3.20565, 3.7772, 0.1647),
  ('door', 'aspect', 3.7772, 4.45067, 0.07799),
  ('door', 'aspect', 4.45067, 5.2442, 0.006227),
  ('door', 'aspect', 5.2442, 100, 0.00466);
DELETE FROM class_density WHERE class = 'door' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'height', -0.5, 0.46828, 0.01404),
  ('door', 'height', 0.46828, 0.602049, 0.05825),
  ('door', 'height', 0.602049, 0.735817, 0.1096),
  ('door', 'height', 0.735817, 0.869586, 0.1481),
  ('door', 'height', 0.869586, 1.00335, 0.3257),
  ('door', 'height', 1.00335, 1.02782, 1.756),
  ('door', 'height', 1.02782, 1.05452, 4.133),
  ('door', 'height', 1.05452, 1.06735, 5.905),
  ('door', 'height', 1.06735, 1.0978, 3.706),
  ('door', 'height', 1.0978, 1.13504, 2.793),
  ('door', 'height', 1.13504, 1.20059, 1.676),
  ('door', 'height', 1.20059, 1.27089, 1.526),
  ('door', 'height', 1.27089, 1.28398, 1.647),
  ('door', 'height', 1.28398, 1.34578, 1.61),
  ('door', 'height', 1.34578, 1.40466, 1.036),
  ('door', 'height', 1.40466, 1.53843, 0.2343),
  ('door', 'height', 1.53843, 1.6722, 0.07599),
  ('door', 'height', 1.6722, 4, 0.005964);
DELETE FROM class_density WHERE class = 'door' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'length', 0.03, 0.625832, 0.00451),
  ('door', 'length', 0.625832, 0.731499, 0.0001476),
  ('door', 'length', 0.731499, 0.855007, 0.02253),
  ('door', 'length', 0.855007, 0.999369, 0.1015),
  ('door', 'length', 0.999369, 1.1681, 0.2273),
  ('door', 'length', 1.1681, 1.36533, 0.1289),
  ('door', 'length', 1.36533, 1.471, 0.4398),
  ('door', 'length', 1.471, 1.59586, 0.7571),
  ('door', 'length', 1.59586, 1.69887, 0.9099),
  ('door', 'length', 1.69887, 1.86531, 0.6727),
  ('door', 'length', 1.86531, 2.01439, 1.479),
  ('door', 'length', 2.01439, 2.04098, 5.415),
  ('door', 'length', 2.04098, 2.06764, 6.019),
  ('door', 'length', 2.06764, 2.09707, 5.363),
  ('door', 'length', 2.09707, 2.18025, 2.852),
  ('door', 'length', 2.18025, 2.30255, 2.101),
  ('door', 'length', 2.30255, 2.54771, 1.051),
  ('door', 'length', 2.54771, 30, 0.01075);
DELETE FROM class_density WHERE class = 'door' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'rectangularity', 0, 0.552428, 0.02841),
  ('door', 'rectangularity', 0.552428, 0.601304, 0.4709),
  ('door', 'rectangularity', 0.601304, 0.65018, 0.7984),
  ('door', 'rectangularity', 0.65018, 0.686617, 0.7584),
  ('door', 'rectangularity', 0.686617, 0.699056, 0.7127),
  ('door', 'rectangularity', 0.699056, 0.747931, 1.407),
  ('door', 'rectangularity', 0.747931, 0.76626, 2.784),
  ('door', 'rectangularity', 0.76626, 0.796807, 3.54),
  ('door', 'rectangularity', 0.796807, 0.822261, 3.931),
  ('door', 'rectangularity', 0.822261, 0.845683, 1.987),
  ('door', 'rectangularity', 0.845683, 0.880462, 2.511),
  ('door', 'rectangularity', 0.880462, 0.893896, 7.006),
  ('door', 'rectangularity', 0.893896, 0.929421, 2.733),
  ('door', 'rectangularity', 0.929421, 0.943434, 2.168),
  ('door', 'rectangularity', 0.943434, 0.963647, 4.804),
  ('door', 'rectangularity', 0.963647, 0.976719, 6.736),
  ('door', 'rectangularity', 0.976719, 0.99231, 0.9065),
  ('door', 'rectangularity', 0.99231, 1, 0.3918);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_length', 0.01, 0.627674, 0.003317),
  ('door', 'spread_length', 0.627674, 0.718994, 0.001858),
  ('door', 'spread_length', 0.718994, 0.823601, 0.03113),
  ('door', 'spread_length', 0.823601, 0.943428, 0.1962),
  ('door', 'spread_length', 0.943428, 1.08069, 0.451),
  ('door', 'spread_length', 1.08069, 1.23792, 0.4995),
  ('door', 'spread_length', 1.23792, 1.3918, 0.6175),
  ('door', 'spread_length', 1.3918, 1.41802, 0.7504),
  ('door', 'spread_length', 1.41802, 1.60866, 0.8516),
  ('door', 'spread_length', 1.60866, 1.68605, 1.996),
  ('door', 'spread_length', 1.68605, 1.86066, 1.105),
  ('door', 'spread_length', 1.86066, 1.96187, 2.683),
  ('door', 'spread_length', 1.96187, 1.99614, 4.852),
  ('door', 'spread_length', 1.99614, 2.04951, 4.548),
  ('door', 'spread_length', 2.04951, 2.13136, 1.472),
  ('door', 'spread_length', 2.13136, 40, 0.008787);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_width', 0.003, 0.17587, 0.001676),
  ('door', 'spread_width', 0.17587, 0.178224, 0.163),
  ('door', 'spread_width', 0.178224, 0.218966, 0.08955),
  ('door', 'spread_width', 0.218966, 0.272623, 0.001525),
  ('door', 'spread_width', 0.272623, 0.339429, 0.07621),
  ('door', 'spread_width', 0.339429, 0.422606, 0.1372),
  ('door', 'spread_width', 0.422606, 0.526164, 0.1689),
  ('door', 'spread_width', 0.526164, 0.565352, 0.3155),
  ('door', 'spread_width', 0.565352, 0.655099, 0.3916),
  ('door', 'spread_width', 0.655099, 0.757439, 0.5298),
  ('door', 'spread_width', 0.757439, 0.800449, 1.959),
  ('door', 'spread_width', 0.800449, 0.81563, 3.352),
  ('door', 'spread_width', 0.81563, 0.852358, 2.826),
  ('door', 'spread_width', 0.852358, 0.885531, 2.359),
  ('door', 'spread_width', 0.885531, 0.935124, 2.33),
  ('door', 'spread_width', 0.935124, 0.952723, 2.922),
  ('door', 'spread_width', 0.952723, 1.0155, 1.163),
  ('door', 'spread_width', 1.0155, 1.26434, 0.3008),
  ('door', 'spread_width', 1.26434, 20, 0.00864);
DELETE FROM class_density WHERE class = 'door' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'tilt_deg', 0, 87.0444, 1.031e-05),
  ('door', 'tilt_deg', 87.0444, 87.3728, 0.03333),
  ('door', 'tilt_deg', 87.3728, 87.7012, 0.07509),
  ('door', 'tilt_deg', 87.7012, 88.0296, 0.04564),
  ('door', 'tilt_deg', 88.0296, 88.358, 0.01364),
  ('door', 'tilt_deg', 88.358, 88.6864, 0.01396),
  ('door', 'tilt_deg', 88.6864, 89.0148, 0.04008),
  ('door', 'tilt_deg', 89.0148, 89.3432, 0.1058),
  ('door', 'tilt_deg', 89.3432, 89.6716, 0.5165),
  ('door', 'tilt_deg', 89.6716, 90, 2.198);
DELETE FROM class_density WHERE class = 'door' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'width', 0.01, 0.210923, 0.00363),
  ('door', 'width', 0.210923, 0.266142, 0.07046),
  ('door', 'width', 0.266142, 0.335817, 0.005907),
  ('door', 'width', 0.335817, 0.423733, 0.1055),
  ('door', 'width', 0.423733, 0.534666, 0.1246),
  ('door', 'width', 0.534666, 0.667417, 0.2477),
  ('door', 'width', 0.667417, 0.674639, 0.2951),
  ('door', 'width', 0.674639, 0.821529, 0.6137),
  ('door', 'width', 0.821529, 0.851258, 2.037),
  ('door', 'width', 0.851258, 0.863179, 2.311),
  ('door', 'width', 0.863179, 0.892953, 2.822),
  ('door', 'width', 0.892953, 0.918929, 3.053),
  ('door', 'width', 0.918929, 0.956256, 2.579),
  ('door', 'width', 0.956256, 0.983536, 2.868),
  ('door', 'width', 0.983536, 1.07411, 1.381),
  ('door', 'width', 1.07411, 1.09641, 0.502),
  ('door', 'width', 1.09641, 1.35531, 0.392),
  ('door', 'width', 1.35531, 1.71013, 0.15),
  ('door', 'width', 1.71013, 12, 0.009011);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_max', -0.5, 0.867545, 0.01002),
  ('door', 'z_max', 0.867545, 1.04278, 0.004056),
  ('door', 'z_max', 1.04278, 1.21801, 0.0734),
  ('door', 'z_max', 1.21801, 1.39324, 0.04113),
  ('door', 'z_max', 1.39324, 1.56847, 0.1394),
  ('door', 'z_max', 1.56847, 1.7437, 0.08839),
  ('door', 'z_max', 1.7437, 1.91893, 0.3327),
  ('door', 'z_max', 1.91893, 1.96653, 0.4937),
  ('door', 'z_max', 1.96653, 2.01987, 2.138),
  ('door', 'z_max', 2.01987, 2.04154, 4.804),
  ('door', 'z_max', 2.04154, 2.0526, 4.792),
  ('door', 'z_max', 2.0526, 2.09049, 3.355),
  ('door', 'z_max', 2.09049, 2.12365, 2.844),
  ('door', 'z_max', 2.12365, 2.21675, 1.229),
  ('door', 'z_max', 2.21675, 2.26939, 1.047),
  ('door', 'z_max', 2.26939, 2.29025, 2.561),
  ('door', 'z_max', 2.29025, 2.44462, 0.6706),
  ('door', 'z_max', 2.44462, 4, 0.01587);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_min', -0.5, -0.0667445, 0.1233),
  ('door', 'z_min', -0.0667445, -0.00791195, 3.233),
  ('door', 'z_min', -0.00791195, -0.002034, 17.2),
  ('door', 'z_min', -0.002034, 0.00487689, 18.03),
  ('door', 'z_min', 0.00487689, 0.078264, 3.325),
  ('door', 'z_min', 0.078264, 0.103911, 0.2551),
  ('door', 'z_min', 0.103911, 0.223272, 0.4494),
  ('door', 'z_min', 0.223272, 0.368281, 0.304),
  ('door', 'z_min', 0.368281, 0.513289, 0.48),
  ('door', 'z_min', 0.513289, 0.658298, 0.3687),
  ('door', 'z_min', 0.658298, 0.803306, 0.1145),
  ('door', 'z_min', 0.803306, 0.948315, 0.008535),
  ('door', 'z_min', 0.948315, 1.09332, 0.1306),
  ('door', 'z_min', 1.09332, 1.23833, 0.06076),
  ('door', 'z_min', 1.23833, 4, 0.004964);

-- window: 97 examples
UPDATE object_class SET prior = 0.02083 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', 0.02634, 0.6317)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.3444, 0.351)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.533, 0.1467)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.2829, 0.2455)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.848, 0.1548)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.3174, 0.248)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.1023, 0.4526)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.61, 0.5695)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.06315, 0.3923)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.13, 0.1817)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 0.9669, 0.1852)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'window' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'area_m2', 0.002, 0.115016, 0.002734),
  ('window', 'area_m2', 0.115016, 0.175763, 0.01815),
  ('window', 'area_m2', 0.175763, 0.268594, 0.04751),
  ('window', 'area_m2', 0.268594, 0.410454, 0.1339),
  ('window', 'area_m2', 0.410454, 0.45231, 0.1637),
  ('window', 'area_m2', 0.45231, 0.627239, 0.1887),
  ('window', 'area_m2', 0.627239, 0.78385, 0.247),
  ('window', 'area_m2', 0.78385, 0.958521, 0.5695),
  ('window', 'area_m2', 0.958521, 1.05093, 1.151),
  ('window', 'area_m2', 1.05093, 1.17048, 1.032),
  ('window', 'area_m2', 1.17048, 1.35208, 0.7327),
  ('window', 'area_m2', 1.35208, 1.46477, 0.7386),
  ('window', 'area_m2', 1.46477, 1.54971, 0.8964),
  ('window', 'area_m2', 1.54971, 1.86724, 0.5875),
  ('window', 'area_m2', 1.86724, 2.23841, 0.4049),
  ('window', 'area_m2', 2.23841, 3.42064, 0.03264),
  ('window', 'area_m2', 3.42064, 5.22728, 0.03808),
  ('window', 'area_m2', 5.22728, 100, 0.003973);
DELETE FROM class_density WHERE class = 'window' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'aspect', 1, 1.05251, 2.249),
  ('window', 'aspect', 1.05251, 1.09711, 2.503),
  ('window', 'aspect', 1.09711, 1.133, 2.988),
  ('window', 'aspect', 1.133, 1.17627, 2),
  ('window', 'aspect', 1.17627, 1.22987, 1.072),
  ('window', 'aspect', 1.22987, 1.31018, 1.597),
  ('window', 'aspect', 1.31018, 1.38361, 1.649),
  ('window', 'aspect', 1.38361, 1.6275, 0.8484),
  ('window', 'aspect', 1.6275, 1.91438, 0.4299),
  ('window', 'aspect', 1.91438, 2.25183, 0.228),
  ('window', 'aspect', 2.25183, 2.46993, 0.2282),
  ('window', 'aspect', 2.46993, 2.64876, 0.2364),
  ('window', 'aspect', 2.64876, 3.11565, 0.2294),
  ('window', 'aspect', 3.11565, 3.66485, 0.1601),
  ('window', 'aspect', 3.66485, 4.31085, 0.09599),
  ('window', 'aspect', 4.31085, 100, 0.003231);
DELETE FROM class_density WHERE class = 'window' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'height', -0.5, 1.10698, 0.007462),
  ('window', 'height', 1.10698, 1.2058, 0.1263),
  ('window', 'height', 1.2058, 1.30462, 0.1418),
  ('window', 'height', 1.30462, 1.40242, 0.9378),
  ('window', 'height', 1.40242, 1.43907, 2.714),
  ('window', 'height', 1.43907, 1.46358, 4.278),
  ('window', 'height', 1.46358, 1.49278, 3.884),
  ('window', 'height', 1.49278, 1.50225, 3.07),
  ('window', 'height', 1.50225, 1.52668, 2.779),
  ('window', 'height', 1.52668, 1.58935, 1.838),
  ('window', 'height', 1.58935, 1.60107, 2.81),
  ('window', 'height', 1.60107, 1.64454, 1.96),
  ('window', 'height', 1.64454, 1.69662, 2.175),
  ('window', 'height', 1.69662, 1.7987, 0.6879),
  ('window', 'height', 1.7987, 1.89752, 0.1351),
  ('window', 'height', 1.89752, 1.99633, 0.1583),
  ('window', 'height', 1.99633, 4, 0.004623);
DELETE FROM class_density WHERE class = 'window' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'length', 0.03, 0.797317, 0.004026),
  ('window', 'length', 0.797317, 0.951267, 0.2378),
  ('window', 'length', 0.951267, 1.05382, 0.5959),
  ('window', 'length', 1.05382, 1.13494, 1.333),
  ('window', 'length', 1.13494, 1.15198, 1.269),
  ('window', 'length', 1.15198, 1.21266, 2.038),
  ('window', 'length', 1.21266, 1.27061, 2.102),
  ('window', 'length', 1.27061, 1.34245, 1.904),
  ('window', 'length', 1.34245, 1.39791, 2.567),
  ('window', 'length', 1.39791, 1.48672, 1.925),
  ('window', 'length', 1.48672, 1.61553, 1.458),
  ('window', 'length', 1.61553, 1.92747, 0.4552),
  ('window', 'length', 1.92747, 2.29963, 0.03219),
  ('window', 'length', 2.29963, 2.74365, 0.006865),
  ('window', 'length', 2.74365, 3.27341, 0.002575),
  ('window', 'length', 3.27341, 3.90545, 0.07888),
  ('window', 'length', 3.90545, 30, 0.006529);
DELETE FROM class_density WHERE class = 'window' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'rectangularity', 0, 0.194123, 0.05137),
  ('window', 'rectangularity', 0.194123, 0.283665, 0.08755),
  ('window', 'rectangularity', 0.283665, 0.373207, 0.04292),
  ('window', 'rectangularity', 0.373207, 0.462748, 0.1023),
  ('window', 'rectangularity', 0.462748, 0.55229, 0.189),
  ('window', 'rectangularity', 0.55229, 0.641832, 0.4006),
  ('window', 'rectangularity', 0.641832, 0.68272, 0.9819),
  ('window', 'rectangularity', 0.68272, 0.731374, 1.211),
  ('window', 'rectangularity', 0.731374, 0.767154, 1.27),
  ('window', 'rectangularity', 0.767154, 0.820916, 1.623),
  ('window', 'rectangularity', 0.820916, 0.838258, 2.312),
  ('window', 'rectangularity', 0.838258, 0.87094, 3.202),
  ('window', 'rectangularity', 0.87094, 0.910276, 2.62),
  ('window', 'rectangularity', 0.910276, 0.952106, 2.989),
  ('window', 'rectangularity', 0.952106, 0.967616, 6.982),
  ('window', 'rectangularity', 0.967616, 0.973161, 15.19),
  ('window', 'rectangularity', 0.973161, 0.985423, 8.491),
  ('window', 'rectangularity', 0.985423, 1, 1.038);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_length', 0.01, 0.696888, 0.002899),
  ('window', 'spread_length', 0.696888, 0.817838, 0.169),
  ('window', 'spread_length', 0.817838, 0.959779, 0.2786),
  ('window', 'spread_length', 0.959779, 1.05002, 0.4275),
  ('window', 'spread_length', 1.05002, 1.12635, 0.8332),
  ('window', 'spread_length', 1.12635, 1.17042, 1.108),
  ('window', 'spread_length', 1.17042, 1.30045, 1.252),
  ('window', 'spread_length', 1.30045, 1.32184, 2.545),
  ('window', 'spread_length', 1.32184, 1.33673, 2.525),
  ('window', 'spread_length', 1.33673, 1.45337, 1.533),
  ('window', 'spread_length', 1.45337, 1.52271, 2.111),
  ('window', 'spread_length', 1.52271, 1.55125, 2.329),
  ('window', 'spread_length', 1.55125, 1.61389, 1.997),
  ('window', 'spread_length', 1.61389, 1.7033, 1.923),
  ('window', 'spread_length', 1.7033, 1.82048, 0.8291),
  ('window', 'spread_length', 1.82048, 2.13644, 0.2082),
  ('window', 'spread_length', 2.13644, 2.50723, 0.04744),
  ('window', 'spread_length', 2.50723, 2.94238, 0.0853),
  ('window', 'spread_length', 2.94238, 40, 0.00482);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_width', 0.003, 0.168573, 0.00282),
  ('window', 'spread_width', 0.168573, 0.216976, 0.04669),
  ('window', 'spread_width', 0.216976, 0.279278, 0.0344),
  ('window', 'spread_width', 0.279278, 0.359468, 0.0765),
  ('window', 'spread_width', 0.359468, 0.462684, 0.1853),
  ('window', 'spread_width', 0.462684, 0.522584, 0.2006),
  ('window', 'spread_width', 0.522584, 0.595537, 0.2592),
  ('window', 'spread_width', 0.595537, 0.764224, 0.3188),
  ('window', 'spread_width', 0.764224, 0.918664, 0.6158),
  ('window', 'spread_width', 0.918664, 0.986637, 1.189),
  ('window', 'spread_width', 0.986637, 1.00136, 1.729),
  ('window', 'spread_width', 1.00136, 1.07207, 1.574),
  ('window', 'spread_width', 1.07207, 1.11691, 1.984),
  ('window', 'spread_width', 1.11691, 1.2004, 1.612),
  ('window', 'spread_width', 1.2004, 1.26994, 1.103),
  ('window', 'spread_width', 1.26994, 1.34484, 1.016),
  ('window', 'spread_width', 1.34484, 1.63458, 0.498),
  ('window', 'spread_width', 1.63458, 20, 0.00723);
DELETE FROM class_density WHERE class = 'window' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'tilt_deg', 0, 87.4494, 9.451e-05),
  ('window', 'tilt_deg', 87.4494, 87.7328, 0.01241),
  ('window', 'tilt_deg', 87.7328, 88.0162, 0.03945),
  ('window', 'tilt_deg', 88.0162, 88.2996, 0.09049),
  ('window', 'tilt_deg', 88.2996, 88.583, 0.1486),
  ('window', 'tilt_deg', 88.583, 88.6992, 0.1866),
  ('window', 'tilt_deg', 88.6992, 88.8664, 0.2034),
  ('window', 'tilt_deg', 88.8664, 89.1498, 0.1992),
  ('window', 'tilt_deg', 89.1498, 89.3405, 0.207),
  ('window', 'tilt_deg', 89.3405, 89.7166, 0.6096),
  ('window', 'tilt_deg', 89.7166, 89.8814, 1.654),
  ('window', 'tilt_deg', 89.8814, 90, 2.157);
DELETE FROM class_density WHERE class = 'window' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'width', 0.01, 0.190149, 0.003931),
  ('window', 'width', 0.190149, 0.239421, 0.02961),
  ('window', 'width', 0.239421, 0.301462, 0.03292),
  ('window', 'width', 0.301462, 0.379579, 0.05461),
  ('window', 'width', 0.379579, 0.477937, 0.1231),
  ('window', 'width', 0.477937, 0.586144, 0.2485),
  ('window', 'width', 0.586144, 0.601783, 0.3244),
  ('window', 'width', 0.601783, 0.757721, 0.302),
  ('window', 'width', 0.757721, 0.842332, 0.4046),
  ('window', 'width', 0.842332, 0.954067, 0.734),
  ('window', 'width', 0.954067, 0.981617, 1.383),
  ('window', 'width', 0.981617, 1.02568, 2.157),
  ('window', 'width', 1.02568, 1.08297, 2.196),
  ('window', 'width', 1.08297, 1.10854, 3.031),
  ('window', 'width', 1.10854, 1.19372, 1.515),
  ('window', 'width', 1.19372, 1.3002, 1.202),
  ('window', 'width', 1.3002, 1.51244, 0.7096),
  ('window', 'width', 1.51244, 12, 0.01142);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_max', -0.5, 1.34649, 0.004482),
  ('window', 'z_max', 1.34649, 1.46775, 0.07513),
  ('window', 'z_max', 1.46775, 1.58901, 0.009222),
  ('window', 'z_max', 1.58901, 1.71026, 0.008279),
  ('window', 'z_max', 1.71026, 1.83152, 0.04687),
  ('window', 'z_max', 1.83152, 1.95221, 0.8047),
  ('window', 'z_max', 1.95221, 1.99751, 2.288),
  ('window', 'z_max', 1.99751, 2.05751, 2.058),
  ('window', 'z_max', 2.05751, 2.07403, 2.22),
  ('window', 'z_max', 2.07403, 2.10976, 1.97),
  ('window', 'z_max', 2.10976, 2.16186, 1.842),
  ('window', 'z_max', 2.16186, 2.19529, 1.573),
  ('window', 'z_max', 2.19529, 2.23891, 1.761),
  ('window', 'z_max', 2.23891, 2.26804, 3.01),
  ('window', 'z_max', 2.26804, 2.31654, 1.892),
  ('window', 'z_max', 2.31654, 2.34207, 1.011),
  ('window', 'z_max', 2.34207, 2.4378, 1.045),
  ('window', 'z_max', 2.4378, 4, 0.008193);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_min', -0.5, 0.790953, 0.02101),
  ('window', 'z_min', 0.790953, 0.826867, 2.742),
  ('window', 'z_min', 0.826867, 0.846508, 5.615),
  ('window', 'z_min', 0.846508, 0.864742, 4.433),
  ('window', 'z_min', 0.864742, 0.878674, 3.136),
  ('window', 'z_min', 0.878674, 0.911208, 2.871),
  ('window', 'z_min', 0.911208, 0.929434, 4.187),
  ('window', 'z_min', 0.929434, 0.957962, 4.067),
  ('window', 'z_min', 0.957962, 0.966395, 4.773),
  ('window', 'z_min', 0.966395, 0.98197, 4.725),
  ('window', 'z_min', 0.98197, 1.05412, 1.187),
  ('window', 'z_min', 1.05412, 1.14184, 0.2272),
  ('window', 'z_min', 1.14184, 1.21829, 0.2908),
  ('window', 'z_min', 1.21829, 1.22956, 0.2122),
  ('window', 'z_min', 1.22956, 1.31728, 0.2251),
  ('window', 'z_min', 1.31728, 1.405, 0.2402),
  ('window', 'z_min', 1.405, 1.49272, 0.4264),
  ('window', 'z_min', 1.49272, 1.58044, 0.2204),
  ('window', 'z_min', 1.58044, 4, 0.00506);

-- whiteboard: 43 examples
UPDATE object_class SET prior = 0.00921 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.2773, 0.8451)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4093, 0.3132)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.396, 0.2136)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.4812, 0.4289)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.7641, 0.1112)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.3408, 0.3905)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.1646, 0.4661)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.56, 1.006)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', 0.07646, 0.4952)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 2.037, 0.3914)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.7072, 0.3603)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'area_m2', 0.002, 0.129662, 0.003544),
  ('whiteboard', 'area_m2', 0.129662, 0.213015, 0.03144),
  ('whiteboard', 'area_m2', 0.213015, 0.34995, 0.09225),
  ('whiteboard', 'area_m2', 0.34995, 0.574913, 0.0979),
  ('whiteboard', 'area_m2', 0.574913, 0.824457, 0.3299),
  ('whiteboard', 'area_m2', 0.824457, 0.944492, 0.5079),
  ('whiteboard', 'area_m2', 0.944492, 1.01035, 0.3696),
  ('whiteboard', 'area_m2', 1.01035, 1.19289, 0.6747),
  ('whiteboard', 'area_m2', 1.19289, 1.45609, 0.5396),
  ('whiteboard', 'area_m2', 1.45609, 1.55165, 0.5419),
  ('whiteboard', 'area_m2', 1.55165, 1.77983, 0.5219),
  ('whiteboard', 'area_m2', 1.77983, 2.17258, 0.486),
  ('whiteboard', 'area_m2', 2.17258, 2.54912, 0.4188),
  ('whiteboard', 'area_m2', 2.54912, 2.80729, 0.328),
  ('whiteboard', 'area_m2', 2.80729, 4.18781, 0.1466),
  ('whiteboard', 'area_m2', 4.18781, 6.87993, 0.0759),
  ('whiteboard', 'area_m2', 6.87993, 10.8635, 0.0682),
  ('whiteboard', 'area_m2', 10.8635, 100, 0.006164);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'aspect', 1, 1.08078, 1.518),
  ('whiteboard', 'aspect', 1.08078, 1.17348, 1.372),
  ('whiteboard', 'aspect', 1.17348, 1.2722, 1.264),
  ('whiteboard', 'aspect', 1.2722, 1.38377, 1.022),
  ('whiteboard', 'aspect', 1.38377, 1.43526, 0.7437),
  ('whiteboard', 'aspect', 1.43526, 1.57163, 1.224),
  ('whiteboard', 'aspect', 1.57163, 1.6232, 2.659),
  ('whiteboard', 'aspect', 1.6232, 1.74639, 1.502),
  ('whiteboard', 'aspect', 1.74639, 1.91482, 1.117),
  ('whiteboard', 'aspect', 1.91482, 2.25248, 0.3859),
  ('whiteboard', 'aspect', 2.25248, 2.64968, 0.1855),
  ('whiteboard', 'aspect', 2.64968, 3.11692, 0.07785),
  ('whiteboard', 'aspect', 3.11692, 3.66655, 0.05235),
  ('whiteboard', 'aspect', 3.66655, 4.18353, 0.1117),
  ('whiteboard', 'aspect', 4.18353, 4.31311, 0.1164),
  ('whiteboard', 'aspect', 4.31311, 100, 0.003833);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'height', -0.5, 0.503039, 0.01785),
  ('whiteboard', 'height', 0.503039, 0.631386, 0.005185),
  ('whiteboard', 'height', 0.631386, 0.759734, 0.08052),
  ('whiteboard', 'height', 0.759734, 0.888081, 0.08339),
  ('whiteboard', 'height', 0.888081, 1.01643, 0.1533),
  ('whiteboard', 'height', 1.01643, 1.14478, 0.2221),
  ('whiteboard', 'height', 1.14478, 1.22975, 0.5776),
  ('whiteboard', 'height', 1.22975, 1.27312, 1.013),
  ('whiteboard', 'height', 1.27312, 1.33018, 1.632),
  ('whiteboard', 'height', 1.33018, 1.40147, 1.334),
  ('whiteboard', 'height', 1.40147, 1.41174, 1.432),
  ('whiteboard', 'height', 1.41174, 1.45044, 2.818),
  ('whiteboard', 'height', 1.45044, 1.46735, 4.339),
  ('whiteboard', 'height', 1.46735, 1.49737, 3.09),
  ('whiteboard', 'height', 1.49737, 1.51614, 4.104),
  ('whiteboard', 'height', 1.51614, 1.52982, 4.141),
  ('whiteboard', 'height', 1.52982, 1.55909, 2.437),
  ('whiteboard', 'height', 1.55909, 1.63023, 1.26),
  ('whiteboard', 'height', 1.63023, 1.65817, 0.5668),
  ('whiteboard', 'height', 1.65817, 4, 0.01309);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'length', 0.03, 0.712051, 0.006085),
  ('whiteboard', 'length', 0.712051, 0.772611, 0.1642),
  ('whiteboard', 'length', 0.772611, 0.88427, 0.1912),
  ('whiteboard', 'length', 0.88427, 1.09814, 0.2818),
  ('whiteboard', 'length', 1.09814, 1.19225, 1.302),
  ('whiteboard', 'length', 1.19225, 1.25947, 1.82),
  ('whiteboard', 'length', 1.25947, 1.33559, 1.636),
  ('whiteboard', 'length', 1.33559, 1.62575, 0.6028),
  ('whiteboard', 'length', 1.62575, 1.69358, 0.8271),
  ('whiteboard', 'length', 1.69358, 1.88097, 0.9048),
  ('whiteboard', 'length', 1.88097, 2.08083, 0.9486),
  ('whiteboard', 'length', 2.08083, 2.61188, 0.4671),
  ('whiteboard', 'length', 2.61188, 3.2436, 0.2241),
  ('whiteboard', 'length', 3.2436, 4.02811, 0.1618),
  ('whiteboard', 'length', 4.02811, 4.59908, 0.1678),
  ('whiteboard', 'length', 4.59908, 5.00236, 0.1256),
  ('whiteboard', 'length', 5.00236, 30, 0.006698);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'rectangularity', 0, 0.466996, 0.02921),
  ('whiteboard', 'rectangularity', 0.466996, 0.520902, 0.3599),
  ('whiteboard', 'rectangularity', 0.520902, 0.574809, 0.6242),
  ('whiteboard', 'rectangularity', 0.574809, 0.614502, 1.262),
  ('whiteboard', 'rectangularity', 0.614502, 0.628715, 1.676),
  ('whiteboard', 'rectangularity', 0.628715, 0.669359, 1.909),
  ('whiteboard', 'rectangularity', 0.669359, 0.682621, 2.021),
  ('whiteboard', 'rectangularity', 0.682621, 0.736528, 1.827),
  ('whiteboard', 'rectangularity', 0.736528, 0.755586, 1.923),
  ('whiteboard', 'rectangularity', 0.755586, 0.790434, 2.01),
  ('whiteboard', 'rectangularity', 0.790434, 0.79995, 4.524),
  ('whiteboard', 'rectangularity', 0.79995, 0.808689, 9.003),
  ('whiteboard', 'rectangularity', 0.808689, 0.833333, 4.776),
  ('whiteboard', 'rectangularity', 0.833333, 0.844341, 5.362),
  ('whiteboard', 'rectangularity', 0.844341, 0.867326, 5.207),
  ('whiteboard', 'rectangularity', 0.867326, 0.898247, 2.469),
  ('whiteboard', 'rectangularity', 0.898247, 0.942809, 0.6791),
  ('whiteboard', 'rectangularity', 0.942809, 0.952153, 0.6004),
  ('whiteboard', 'rectangularity', 0.952153, 1, 0.4055);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_length', 0.01, 0.610418, 0.003057),
  ('whiteboard', 'spread_length', 0.610418, 0.639794, 0.1149),
  ('whiteboard', 'spread_length', 0.639794, 0.749269, 0.1713),
  ('whiteboard', 'spread_length', 0.749269, 0.919705, 0.2692),
  ('whiteboard', 'spread_length', 0.919705, 0.971697, 0.5133),
  ('whiteboard', 'spread_length', 0.971697, 1.08302, 0.973),
  ('whiteboard', 'spread_length', 1.08302, 1.12891, 1.953),
  ('whiteboard', 'spread_length', 1.12891, 1.24623, 1.223),
  ('whiteboard', 'spread_length', 1.24623, 1.35254, 1.256),
  ('whiteboard', 'spread_length', 1.35254, 1.57093, 0.7648),
  ('whiteboard', 'spread_length', 1.57093, 1.70091, 0.8381),
  ('whiteboard', 'spread_length', 1.70091, 1.75604, 0.894),
  ('whiteboard', 'spread_length', 1.75604, 2.08781, 0.5859),
  ('whiteboard', 'spread_length', 2.08781, 2.3493, 0.3086),
  ('whiteboard', 'spread_length', 2.3493, 2.56273, 0.2414),
  ('whiteboard', 'spread_length', 2.56273, 3.14567, 0.2257),
  ('whiteboard', 'spread_length', 3.14567, 3.51623, 0.2036),
  ('whiteboard', 'spread_length', 3.51623, 3.86122, 0.1418),
  ('whiteboard', 'spread_length', 3.86122, 40, 0.004584);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_width', 0.003, 0.161495, 0.003979),
  ('whiteboard', 'spread_width', 0.161495, 0.214891, 0.02241),
  ('whiteboard', 'spread_width', 0.214891, 0.285942, 0.05418),
  ('whiteboard', 'spread_width', 0.285942, 0.380484, 0.09858),
  ('whiteboard', 'spread_width', 0.380484, 0.506286, 0.126),
  ('whiteboard', 'spread_width', 0.506286, 0.615344, 0.2405),
  ('whiteboard', 'spread_width', 0.615344, 0.673682, 0.6426),
  ('whiteboard', 'spread_width', 0.673682, 0.705795, 1.033),
  ('whiteboard', 'spread_width', 0.705795, 0.777395, 1.074),
  ('whiteboard', 'spread_width', 0.777395, 0.867341, 0.9046),
  ('whiteboard', 'spread_width', 0.867341, 0.896426, 1.136),
  ('whiteboard', 'spread_width', 0.896426, 0.949112, 1.194),
  ('whiteboard', 'spread_width', 0.949112, 1.01928, 1.233),
  ('whiteboard', 'spread_width', 1.01928, 1.08888, 1.533),
  ('whiteboard', 'spread_width', 1.08888, 1.19282, 1.194),
  ('whiteboard', 'spread_width', 1.19282, 1.5872, 0.2283),
  ('whiteboard', 'spread_width', 1.5872, 1.98692, 0.1972),
  ('whiteboard', 'spread_width', 1.98692, 2.11199, 0.177),
  ('whiteboard', 'spread_width', 2.11199, 20, 0.008032);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'tilt_deg', 0, 85.1118, 9.591e-06),
  ('whiteboard', 'tilt_deg', 85.1118, 85.5495, 0.03754),
  ('whiteboard', 'tilt_deg', 85.5495, 86.1981, 0.02948),
  ('whiteboard', 'tilt_deg', 86.1981, 86.7412, 0.001056),
  ('whiteboard', 'tilt_deg', 86.7412, 87.2843, 0.004071),
  ('whiteboard', 'tilt_deg', 87.2843, 87.8275, 0.02816),
  ('whiteboard', 'tilt_deg', 87.8275, 88.3706, 0.08594),
  ('whiteboard', 'tilt_deg', 88.3706, 88.9137, 0.1151),
  ('whiteboard', 'tilt_deg', 88.9137, 89.4569, 0.2232),
  ('whiteboard', 'tilt_deg', 89.4569, 89.735, 0.7667),
  ('whiteboard', 'tilt_deg', 89.735, 90, 1.894);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'width', 0.01, 0.217079, 0.005033),
  ('whiteboard', 'width', 0.217079, 0.292941, 0.02325),
  ('whiteboard', 'width', 0.292941, 0.395316, 0.06714),
  ('whiteboard', 'width', 0.395316, 0.533467, 0.141),
  ('whiteboard', 'width', 0.533467, 0.689779, 0.2076),
  ('whiteboard', 'width', 0.689779, 0.719898, 0.3569),
  ('whiteboard', 'width', 0.719898, 0.883453, 0.4923),
  ('whiteboard', 'width', 0.883453, 0.971481, 0.7957),
  ('whiteboard', 'width', 0.971481, 1.08917, 1.104),
  ('whiteboard', 'width', 1.08917, 1.15871, 1.615),
  ('whiteboard', 'width', 1.15871, 1.24876, 1.574),
  ('whiteboard', 'width', 1.24876, 1.31099, 1.153),
  ('whiteboard', 'width', 1.31099, 1.73102, 0.4782),
  ('whiteboard', 'width', 1.73102, 2.3874, 0.2244),
  ('whiteboard', 'width', 2.3874, 2.93423, 0.1804),
  ('whiteboard', 'width', 2.93423, 3.22172, 0.1809),
  ('whiteboard', 'width', 3.22172, 12, 0.008385);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_max', -0.5, 0.943186, 0.01172),
  ('whiteboard', 'z_max', 0.943186, 1.17197, 0.04403),
  ('whiteboard', 'z_max', 1.17197, 1.40076, 0.157),
  ('whiteboard', 'z_max', 1.40076, 1.62955, 0.2001),
  ('whiteboard', 'z_max', 1.62955, 1.67332, 0.3947),
  ('whiteboard', 'z_max', 1.67332, 1.85834, 0.5717),
  ('whiteboard', 'z_max', 1.85834, 1.87247, 1.619),
  ('whiteboard', 'z_max', 1.87247, 1.89977, 2.422),
  ('whiteboard', 'z_max', 1.89977, 2.00746, 1.168),
  ('whiteboard', 'z_max', 2.00746, 2.06573, 1.624),
  ('whiteboard', 'z_max', 2.06573, 2.08712, 2.095),
  ('whiteboard', 'z_max', 2.08712, 2.14878, 2.479),
  ('whiteboard', 'z_max', 2.14878, 2.31591, 0.5984),
  ('whiteboard', 'z_max', 2.31591, 2.4648, 0.2605),
  ('whiteboard', 'z_max', 2.4648, 2.5447, 0.2608),
  ('whiteboard', 'z_max', 2.5447, 2.77349, 0.1373),
  ('whiteboard', 'z_max', 2.77349, 2.96356, 0.2688),
  ('whiteboard', 'z_max', 2.96356, 3.00227, 0.2036),
  ('whiteboard', 'z_max', 3.00227, 4, 0.01124);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_min', -0.5, -0.461498, 0.1992),
  ('whiteboard', 'z_min', -0.461498, -0.277574, 0.06071),
  ('whiteboard', 'z_min', -0.277574, -0.0936506, 0.06202),
  ('whiteboard', 'z_min', -0.0936506, 0.0109968, 0.445),
  ('whiteboard', 'z_min', 0.0109968, 0.0902728, 0.426),
  ('whiteboard', 'z_min', 0.0902728, 0.274196, 0.203),
  ('whiteboard', 'z_min', 0.274196, 0.45812, 0.2382),
  ('whiteboard', 'z_min', 0.45812, 0.626824, 0.4489),
  ('whiteboard', 'z_min', 0.626824, 0.642043, 0.5372),
  ('whiteboard', 'z_min', 0.642043, 0.797658, 0.8882),
  ('whiteboard', 'z_min', 0.797658, 0.812864, 3.704),
  ('whiteboard', 'z_min', 0.812864, 0.825967, 2.566),
  ('whiteboard', 'z_min', 0.825967, 0.853359, 2.746),
  ('whiteboard', 'z_min', 0.853359, 0.889653, 2.96),
  ('whiteboard', 'z_min', 0.889653, 0.929667, 1.731),
  ('whiteboard', 'z_min', 0.929667, 0.969807, 2.389),
  ('whiteboard', 'z_min', 0.969807, 1.00989, 1.576),
  ('whiteboard', 'z_min', 1.00989, 1.19381, 0.2989),
  ('whiteboard', 'z_min', 1.19381, 4, 0.01079);

-- shelf: 239 examples
UPDATE object_class SET prior = 0.05151 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.402, 0.7369)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.996, 0.455)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9538, 0.4898)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.001198, 0.5017)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6834, 0.1351)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.1767, 0.5048)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.191, 0.3538)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 53.35, 43.25)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.001, 0.3448)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.319, 0.6451)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5629, 0.5909)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'area_m2', 0.002, 0.0269073, 0.003956),
  ('shelf', 'area_m2', 0.0269073, 0.0408742, 0.04199),
  ('shelf', 'area_m2', 0.0408742, 0.0620911, 0.07742),
  ('shelf', 'area_m2', 0.0620911, 0.0943211, 0.08814),
  ('shelf', 'area_m2', 0.0943211, 0.10078, 0.1538),
  ('shelf', 'area_m2', 0.10078, 0.143281, 0.3047),
  ('shelf', 'area_m2', 0.143281, 0.153128, 0.2297),
  ('shelf', 'area_m2', 0.153128, 0.199857, 0.3889),
  ('shelf', 'area_m2', 0.199857, 0.217655, 0.5278),
  ('shelf', 'area_m2', 0.217655, 0.243575, 0.6304),
  ('shelf', 'area_m2', 0.243575, 0.298848, 0.5247),
  ('shelf', 'area_m2', 0.298848, 0.330635, 0.7813),
  ('shelf', 'area_m2', 0.330635, 0.343373, 0.7949),
  ('shelf', 'area_m2', 0.343373, 0.423076, 0.5344),
  ('shelf', 'area_m2', 0.423076, 0.502259, 0.3837),
  ('shelf', 'area_m2', 0.502259, 0.580408, 0.3356),
  ('shelf', 'area_m2', 0.580408, 0.762971, 0.2485),
  ('shelf', 'area_m2', 0.762971, 1.15901, 0.07946),
  ('shelf', 'area_m2', 1.15901, 100, 0.00165);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'aspect', 1, 1.23509, 0.245),
  ('shelf', 'aspect', 1.23509, 1.52546, 0.2653),
  ('shelf', 'aspect', 1.52546, 1.87224, 0.5534),
  ('shelf', 'aspect', 1.87224, 2.12487, 0.8958),
  ('shelf', 'aspect', 2.12487, 2.32702, 0.6192),
  ('shelf', 'aspect', 2.32702, 2.57521, 0.5803),
  ('shelf', 'aspect', 2.57521, 2.87408, 0.6868),
  ('shelf', 'aspect', 2.87408, 2.96947, 0.9952),
  ('shelf', 'aspect', 2.96947, 3.37896, 0.8475),
  ('shelf', 'aspect', 3.37896, 3.54976, 1.05),
  ('shelf', 'aspect', 3.54976, 3.96961, 0.5059),
  ('shelf', 'aspect', 3.96961, 4.38428, 0.5388),
  ('shelf', 'aspect', 4.38428, 4.96389, 0.4286),
  ('shelf', 'aspect', 4.96389, 5.415, 0.5468),
  ('shelf', 'aspect', 5.415, 6.68803, 0.3064),
  ('shelf', 'aspect', 6.68803, 100, 0.002106);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'height', -0.5, -0.00418763, 0.002454),
  ('shelf', 'height', -0.00418763, 0.051472, 0.1386),
  ('shelf', 'height', 0.051472, 0.239931, 0.3993),
  ('shelf', 'height', 0.239931, 0.394351, 0.1882),
  ('shelf', 'height', 0.394351, 0.48405, 0.7172),
  ('shelf', 'height', 0.48405, 0.537635, 0.7181),
  ('shelf', 'height', 0.537635, 0.728168, 0.5078),
  ('shelf', 'height', 0.728168, 0.759131, 0.6567),
  ('shelf', 'height', 0.759131, 0.913421, 0.7452),
  ('shelf', 'height', 0.913421, 0.972287, 1.015),
  ('shelf', 'height', 0.972287, 1.00999, 1.153),
  ('shelf', 'height', 1.00999, 1.11948, 1.034),
  ('shelf', 'height', 1.11948, 1.21641, 0.8038),
  ('shelf', 'height', 1.21641, 1.26809, 0.5898),
  ('shelf', 'height', 1.26809, 1.46052, 0.4882),
  ('shelf', 'height', 1.46052, 1.55074, 0.2746),
  ('shelf', 'height', 1.55074, 1.70464, 0.177),
  ('shelf', 'height', 1.70464, 1.94876, 0.1647),
  ('shelf', 'height', 1.94876, 2.15774, 0.1374),
  ('shelf', 'height', 2.15774, 2.19288, 0.09056),
  ('shelf', 'height', 2.19288, 4, 0.004967);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'length', 0.03, 0.231347, 0.005022),
  ('shelf', 'length', 0.231347, 0.300006, 0.08057),
  ('shelf', 'length', 0.300006, 0.389041, 0.08128),
  ('shelf', 'length', 0.389041, 0.504499, 0.1234),
  ('shelf', 'length', 0.504499, 0.548844, 0.3089),
  ('shelf', 'length', 0.548844, 0.654222, 0.429),
  ('shelf', 'length', 0.654222, 0.691252, 0.5932),
  ('shelf', 'length', 0.691252, 0.846027, 0.5815),
  ('shelf', 'length', 0.846027, 0.958215, 0.8245),
  ('shelf', 'length', 0.958215, 1.10016, 0.6567),
  ('shelf', 'length', 1.10016, 1.13436, 0.7575),
  ('shelf', 'length', 1.13436, 1.26566, 1.042),
  ('shelf', 'length', 1.26566, 1.42666, 0.5795),
  ('shelf', 'length', 1.42666, 1.50358, 0.8242),
  ('shelf', 'length', 1.50358, 1.85006, 0.5162),
  ('shelf', 'length', 1.85006, 2.27205, 0.4962),
  ('shelf', 'length', 2.27205, 2.39912, 0.1465),
  ('shelf', 'length', 2.39912, 30, 0.001479);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'rectangularity', 0, 0.398245, 0.01703),
  ('shelf', 'rectangularity', 0.398245, 0.405205, 0.3049),
  ('shelf', 'rectangularity', 0.405205, 0.460201, 0.6384),
  ('shelf', 'rectangularity', 0.460201, 0.509985, 1.449),
  ('shelf', 'rectangularity', 0.509985, 0.522157, 2.135),
  ('shelf', 'rectangularity', 0.522157, 0.561964, 2.091),
  ('shelf', 'rectangularity', 0.561964, 0.584113, 2.689),
  ('shelf', 'rectangularity', 0.584113, 0.603925, 2.537),
  ('shelf', 'rectangularity', 0.603925, 0.646068, 1.735),
  ('shelf', 'rectangularity', 0.646068, 0.663728, 1.76),
  ('shelf', 'rectangularity', 0.663728, 0.708024, 1.955),
  ('shelf', 'rectangularity', 0.708024, 0.721155, 2.315),
  ('shelf', 'rectangularity', 0.721155, 0.760532, 2.905),
  ('shelf', 'rectangularity', 0.760532, 0.76998, 2.764),
  ('shelf', 'rectangularity', 0.76998, 0.800322, 2.516),
  ('shelf', 'rectangularity', 0.800322, 0.831936, 2.196),
  ('shelf', 'rectangularity', 0.831936, 0.851085, 2.269),
  ('shelf', 'rectangularity', 0.851085, 0.893892, 1.555),
  ('shelf', 'rectangularity', 0.893892, 0.953747, 0.641),
  ('shelf', 'rectangularity', 0.953747, 1, 0.1944);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_length', 0.01, 0.214457, 0.003526),
  ('shelf', 'spread_length', 0.214457, 0.276971, 0.08547),
  ('shelf', 'spread_length', 0.276971, 0.357707, 0.1224),
  ('shelf', 'spread_length', 0.357707, 0.450662, 0.2114),
  ('shelf', 'spread_length', 0.450662, 0.461978, 0.2631),
  ('shelf', 'spread_length', 0.461978, 0.593506, 0.4213),
  ('shelf', 'spread_length', 0.593506, 0.676126, 0.8),
  ('shelf', 'spread_length', 0.676126, 0.770564, 0.7791),
  ('shelf', 'spread_length', 0.770564, 0.963519, 0.5633),
  ('shelf', 'spread_length', 0.963519, 0.995182, 0.6458),
  ('shelf', 'spread_length', 0.995182, 1.08572, 1.038),
  ('shelf', 'spread_length', 1.08572, 1.24999, 0.7829),
  ('shelf', 'spread_length', 1.24999, 1.28528, 0.7066),
  ('shelf', 'spread_length', 1.28528, 1.57558, 0.4279),
  ('shelf', 'spread_length', 1.57558, 1.65993, 0.4096),
  ('shelf', 'spread_length', 1.65993, 2.14143, 0.3423),
  ('shelf', 'spread_length', 2.14143, 40, 0.002119);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_width', 0.003, 0.113591, 0.002568),
  ('shelf', 'spread_width', 0.113591, 0.140284, 0.1294),
  ('shelf', 'spread_width', 0.140284, 0.173249, 0.174),
  ('shelf', 'spread_width', 0.173249, 0.189443, 0.4149),
  ('shelf', 'spread_width', 0.189443, 0.213961, 0.4265),
  ('shelf', 'spread_width', 0.213961, 0.24371, 0.4802),
  ('shelf', 'spread_width', 0.24371, 0.26424, 0.7127),
  ('shelf', 'spread_width', 0.26424, 0.280782, 0.8952),
  ('shelf', 'spread_width', 0.280782, 0.304418, 1.345),
  ('shelf', 'spread_width', 0.304418, 0.326334, 1.254),
  ('shelf', 'spread_width', 0.326334, 0.330987, 1.843),
  ('shelf', 'spread_width', 0.330987, 0.351506, 1.717),
  ('shelf', 'spread_width', 0.351506, 0.394149, 1.047),
  ('shelf', 'spread_width', 0.394149, 0.403019, 1.068),
  ('shelf', 'spread_width', 0.403019, 0.436824, 1.056),
  ('shelf', 'spread_width', 0.436824, 0.497724, 0.4686),
  ('shelf', 'spread_width', 0.497724, 0.614684, 0.1034),
  ('shelf', 'spread_width', 0.614684, 0.759129, 0.08165),
  ('shelf', 'spread_width', 0.759129, 20, 0.002722);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'tilt_deg', 0, 0.869741, 0.1197),
  ('shelf', 'tilt_deg', 0.869741, 1.72911, 0.1303),
  ('shelf', 'tilt_deg', 1.72911, 3.1874, 0.07519),
  ('shelf', 'tilt_deg', 3.1874, 10, 0.01026),
  ('shelf', 'tilt_deg', 10, 20, 0.0007479),
  ('shelf', 'tilt_deg', 20, 30, 0.0004694),
  ('shelf', 'tilt_deg', 30, 40, 0.0005045),
  ('shelf', 'tilt_deg', 40, 50, 0.0005402),
  ('shelf', 'tilt_deg', 50, 60, 0.0005714),
  ('shelf', 'tilt_deg', 60, 70, 0.0005951),
  ('shelf', 'tilt_deg', 70, 80, 0.0006406),
  ('shelf', 'tilt_deg', 80, 88.1894, 0.003891),
  ('shelf', 'tilt_deg', 88.1894, 89.6858, 0.1199),
  ('shelf', 'tilt_deg', 89.6858, 90, 1.121);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'width', 0.01, 0.123453, 0.002518),
  ('shelf', 'width', 0.123453, 0.157074, 0.08528),
  ('shelf', 'width', 0.157074, 0.199852, 0.1488),
  ('shelf', 'width', 0.199852, 0.254281, 0.1887),
  ('shelf', 'width', 0.254281, 0.266111, 0.2199),
  ('shelf', 'width', 0.266111, 0.312649, 0.6405),
  ('shelf', 'width', 0.312649, 0.323532, 1.124),
  ('shelf', 'width', 0.323532, 0.34148, 1.496),
  ('shelf', 'width', 0.34148, 0.361683, 1.886),
  ('shelf', 'width', 0.361683, 0.385747, 1.591),
  ('shelf', 'width', 0.385747, 0.411644, 1.404),
  ('shelf', 'width', 0.411644, 0.417888, 1.629),
  ('shelf', 'width', 0.417888, 0.438137, 2.127),
  ('shelf', 'width', 0.438137, 0.484209, 1.139),
  ('shelf', 'width', 0.484209, 0.523751, 0.4268),
  ('shelf', 'width', 0.523751, 0.666391, 0.1962),
  ('shelf', 'width', 0.666391, 0.847877, 0.03433),
  ('shelf', 'width', 0.847877, 1.07879, 0.07911),
  ('shelf', 'width', 1.07879, 12, 0.004203);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_max', -0.5, -0.00172484, 0.001935),
  ('shelf', 'z_max', -0.00172484, 0.0662214, 0.3288),
  ('shelf', 'z_max', 0.0662214, 0.258419, 0.2851),
  ('shelf', 'z_max', 0.258419, 0.432982, 0.2235),
  ('shelf', 'z_max', 0.432982, 0.518563, 0.6634),
  ('shelf', 'z_max', 0.518563, 0.648741, 0.3432),
  ('shelf', 'z_max', 0.648741, 0.778707, 0.2027),
  ('shelf', 'z_max', 0.778707, 1.03885, 0.2591),
  ('shelf', 'z_max', 1.03885, 1.09347, 0.4087),
  ('shelf', 'z_max', 1.09347, 1.29899, 0.4031),
  ('shelf', 'z_max', 1.29899, 1.38817, 0.4163),
  ('shelf', 'z_max', 1.38817, 1.55914, 0.5217),
  ('shelf', 'z_max', 1.55914, 1.58515, 0.7647),
  ('shelf', 'z_max', 1.58515, 1.69436, 0.8873),
  ('shelf', 'z_max', 1.69436, 1.81928, 0.6749),
  ('shelf', 'z_max', 1.81928, 1.88478, 0.5843),
  ('shelf', 'z_max', 1.88478, 2.07943, 0.5024),
  ('shelf', 'z_max', 2.07943, 2.09845, 0.5549),
  ('shelf', 'z_max', 2.09845, 2.33957, 0.4105),
  ('shelf', 'z_max', 2.33957, 4, 0.005708);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_min', -0.5, -0.069741, 0.01568),
  ('shelf', 'z_min', -0.069741, -0.0433378, 0.1032),
  ('shelf', 'z_min', -0.0433378, -0.00584269, 2.586),
  ('shelf', 'z_min', -0.00584269, 0.0228202, 3.763),
  ('shelf', 'z_min', 0.0228202, 0.0722431, 1.863),
  ('shelf', 'z_min', 0.0722431, 0.179579, 0.7211),
  ('shelf', 'z_min', 0.179579, 0.383045, 0.2644),
  ('shelf', 'z_min', 0.383045, 0.428898, 1.108),
  ('shelf', 'z_min', 0.428898, 0.485067, 1.097),
  ('shelf', 'z_min', 0.485067, 0.678218, 0.4953),
  ('shelf', 'z_min', 0.678218, 0.72587, 0.3464),
  ('shelf', 'z_min', 0.72587, 0.927242, 0.5638),
  ('shelf', 'z_min', 0.927242, 1.17686, 0.3569),
  ('shelf', 'z_min', 1.17686, 1.42618, 0.09743),
  ('shelf', 'z_min', 1.42618, 1.6755, 0.1183),
  ('shelf', 'z_min', 1.6755, 1.92482, 0.1518),
  ('shelf', 'z_min', 1.92482, 2.15349, 0.1365),
  ('shelf', 'z_min', 2.15349, 2.17414, 0.09246),
  ('shelf', 'z_min', 2.17414, 4, 0.005756);

-- cabinet: 310 examples
UPDATE object_class SET prior = 0.06638 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.842, 0.9723)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6166, 0.4169)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7493, 0.3463)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.06471, 0.5221)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7181, 0.1381)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1231, 0.5248)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7827, 0.5109)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 76.05, 32.02)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.5552, 0.4818)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.203, 0.5703)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2118, 0.3228)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'area_m2', 0.002, 0.0266725, 0.003446),
  ('cabinet', 'area_m2', 0.0266725, 0.0458848, 0.02822),
  ('cabinet', 'area_m2', 0.0458848, 0.0789359, 0.06433),
  ('cabinet', 'area_m2', 0.0789359, 0.11996, 0.1179),
  ('cabinet', 'area_m2', 0.11996, 0.135794, 0.146),
  ('cabinet', 'area_m2', 0.135794, 0.220986, 0.1992),
  ('cabinet', 'area_m2', 0.220986, 0.233607, 0.2786),
  ('cabinet', 'area_m2', 0.233607, 0.3223, 0.2952),
  ('cabinet', 'area_m2', 0.3223, 0.380174, 0.6481),
  ('cabinet', 'area_m2', 0.380174, 0.401875, 0.6464),
  ('cabinet', 'area_m2', 0.401875, 0.501224, 0.3515),
  ('cabinet', 'area_m2', 0.501224, 0.691348, 0.3213),
  ('cabinet', 'area_m2', 0.691348, 0.717663, 0.3073),
  ('cabinet', 'area_m2', 0.717663, 0.978495, 0.3411),
  ('cabinet', 'area_m2', 0.978495, 1.18933, 0.3985),
  ('cabinet', 'area_m2', 1.18933, 1.36201, 0.2503),
  ('cabinet', 'area_m2', 1.36201, 2.04601, 0.2014),
  ('cabinet', 'area_m2', 2.04601, 3.51976, 0.04484),
  ('cabinet', 'area_m2', 3.51976, 100, 0.002042);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'aspect', 1, 1.14301, 0.8382),
  ('cabinet', 'aspect', 1.14301, 1.2176, 1.107),
  ('cabinet', 'aspect', 1.2176, 1.26108, 1.05),
  ('cabinet', 'aspect', 1.26108, 1.41839, 0.9373),
  ('cabinet', 'aspect', 1.41839, 1.48254, 0.5895),
  ('cabinet', 'aspect', 1.48254, 1.62623, 0.9227),
  ('cabinet', 'aspect', 1.62623, 1.80514, 0.8006),
  ('cabinet', 'aspect', 1.80514, 1.9004, 0.564),
  ('cabinet', 'aspect', 1.9004, 2.13595, 0.9513),
  ('cabinet', 'aspect', 2.13595, 2.19794, 0.5373),
  ('cabinet', 'aspect', 2.19794, 2.48641, 0.7344),
  ('cabinet', 'aspect', 2.48641, 2.67621, 0.4896),
  ('cabinet', 'aspect', 2.67621, 3.18354, 0.4347),
  ('cabinet', 'aspect', 3.18354, 3.25854, 0.3751),
  ('cabinet', 'aspect', 3.25854, 3.96759, 0.3277),
  ('cabinet', 'aspect', 3.96759, 4.83093, 0.103),
  ('cabinet', 'aspect', 4.83093, 5.88213, 0.06227),
  ('cabinet', 'aspect', 5.88213, 100, 0.004445);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'height', -0.5, 0.154647, 0.01267),
  ('cabinet', 'height', 0.154647, 0.306987, 0.5811),
  ('cabinet', 'height', 0.306987, 0.446145, 0.9086),
  ('cabinet', 'height', 0.446145, 0.459328, 0.7037),
  ('cabinet', 'height', 0.459328, 0.552031, 1.033),
  ('cabinet', 'height', 0.552031, 0.596494, 2.466),
  ('cabinet', 'height', 0.596494, 0.611668, 1.106),
  ('cabinet', 'height', 0.611668, 0.764009, 0.5768),
  ('cabinet', 'height', 0.764009, 0.78247, 0.4657),
  ('cabinet', 'height', 0.78247, 0.916349, 0.5846),
  ('cabinet', 'height', 0.916349, 0.942501, 1.407),
  ('cabinet', 'height', 0.942501, 1.0478, 1.06),
  ('cabinet', 'height', 1.0478, 1.06869, 0.8923),
  ('cabinet', 'height', 1.06869, 1.22103, 0.6008),
  ('cabinet', 'height', 1.22103, 1.37337, 0.4692),
  ('cabinet', 'height', 1.37337, 1.49767, 0.2352),
  ('cabinet', 'height', 1.49767, 1.52571, 0.1401),
  ('cabinet', 'height', 1.52571, 4, 0.002962);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'length', 0.03, 0.219656, 0.004011),
  ('cabinet', 'length', 0.219656, 0.290251, 0.04105),
  ('cabinet', 'length', 0.290251, 0.383535, 0.06678),
  ('cabinet', 'length', 0.383535, 0.506799, 0.1435),
  ('cabinet', 'length', 0.506799, 0.59106, 0.2637),
  ('cabinet', 'length', 0.59106, 0.66968, 0.5151),
  ('cabinet', 'length', 0.66968, 0.727929, 0.515),
  ('cabinet', 'length', 0.727929, 0.839279, 0.7817),
  ('cabinet', 'length', 0.839279, 0.884908, 0.6312),
  ('cabinet', 'length', 0.884908, 1.00595, 0.5687),
  ('cabinet', 'length', 1.00595, 1.16931, 0.6502),
  ('cabinet', 'length', 1.16931, 1.19078, 0.6348),
  ('cabinet', 'length', 1.19078, 1.47647, 0.5391),
  ('cabinet', 'length', 1.47647, 1.54511, 0.3707),
  ('cabinet', 'length', 1.54511, 1.7497, 0.7518),
  ('cabinet', 'length', 1.7497, 1.97081, 0.9368),
  ('cabinet', 'length', 1.97081, 2.04169, 0.7517),
  ('cabinet', 'length', 2.04169, 2.68507, 0.2777),
  ('cabinet', 'length', 2.68507, 30, 0.00281);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'rectangularity', 0, 0.359408, 0.02315),
  ('cabinet', 'rectangularity', 0.359408, 0.429544, 0.2546),
  ('cabinet', 'rectangularity', 0.429544, 0.49968, 0.5327),
  ('cabinet', 'rectangularity', 0.49968, 0.539103, 1.113),
  ('cabinet', 'rectangularity', 0.539103, 0.569816, 1.377),
  ('cabinet', 'rectangularity', 0.569816, 0.604553, 2.185),
  ('cabinet', 'rectangularity', 0.604553, 0.639952, 2.04),
  ('cabinet', 'rectangularity', 0.639952, 0.658285, 1.916),
  ('cabinet', 'rectangularity', 0.658285, 0.699576, 2.699),
  ('cabinet', 'rectangularity', 0.699576, 0.710088, 2.106),
  ('cabinet', 'rectangularity', 0.710088, 0.749538, 2.166),
  ('cabinet', 'rectangularity', 0.749538, 0.780225, 2.354),
  ('cabinet', 'rectangularity', 0.780225, 0.796299, 2.654),
  ('cabinet', 'rectangularity', 0.796299, 0.834654, 2.924),
  ('cabinet', 'rectangularity', 0.834654, 0.850361, 2.89),
  ('cabinet', 'rectangularity', 0.850361, 0.885479, 1.83),
  ('cabinet', 'rectangularity', 0.885479, 0.920497, 1.346),
  ('cabinet', 'rectangularity', 0.920497, 0.976725, 0.9297),
  ('cabinet', 'rectangularity', 0.976725, 0.990633, 0.5449),
  ('cabinet', 'rectangularity', 0.990633, 1, 0.4606);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_length', 0.01, 0.194661, 0.002374),
  ('cabinet', 'spread_length', 0.194661, 0.254718, 0.03676),
  ('cabinet', 'spread_length', 0.254718, 0.333303, 0.04283),
  ('cabinet', 'spread_length', 0.333303, 0.436134, 0.2592),
  ('cabinet', 'spread_length', 0.436134, 0.450728, 0.2839),
  ('cabinet', 'spread_length', 0.450728, 0.570689, 0.3591),
  ('cabinet', 'spread_length', 0.570689, 0.591471, 0.8037),
  ('cabinet', 'spread_length', 0.591471, 0.675037, 0.8623),
  ('cabinet', 'spread_length', 0.675037, 0.746757, 0.8412),
  ('cabinet', 'spread_length', 0.746757, 0.804616, 0.348),
  ('cabinet', 'spread_length', 0.804616, 0.968765, 0.5948),
  ('cabinet', 'spread_length', 0.968765, 1.18694, 0.5453),
  ('cabinet', 'spread_length', 1.18694, 1.27861, 0.5631),
  ('cabinet', 'spread_length', 1.27861, 1.51301, 0.4153),
  ('cabinet', 'spread_length', 1.51301, 1.67309, 0.7918),
  ('cabinet', 'spread_length', 1.67309, 1.72831, 0.9269),
  ('cabinet', 'spread_length', 1.72831, 2.18927, 0.4331),
  ('cabinet', 'spread_length', 2.18927, 40, 0.003124);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_width', 0.003, 0.122178, 0.003028),
  ('cabinet', 'spread_width', 0.122178, 0.161055, 0.116),
  ('cabinet', 'spread_width', 0.161055, 0.212303, 0.138),
  ('cabinet', 'spread_width', 0.212303, 0.232705, 0.3313),
  ('cabinet', 'spread_width', 0.232705, 0.279859, 0.2941),
  ('cabinet', 'spread_width', 0.279859, 0.329876, 0.3645),
  ('cabinet', 'spread_width', 0.329876, 0.368911, 0.6193),
  ('cabinet', 'spread_width', 0.368911, 0.389922, 0.686),
  ('cabinet', 'spread_width', 0.389922, 0.452163, 0.7497),
  ('cabinet', 'spread_width', 0.452163, 0.4863, 0.9536),
  ('cabinet', 'spread_width', 0.4863, 0.509549, 0.9093),
  ('cabinet', 'spread_width', 0.509549, 0.55998, 1.053),
  ('cabinet', 'spread_width', 0.55998, 0.641042, 0.8424),
  ('cabinet', 'spread_width', 0.641042, 0.652893, 0.3353),
  ('cabinet', 'spread_width', 0.652893, 0.803232, 0.5162),
  ('cabinet', 'spread_width', 0.803232, 0.845024, 0.574),
  ('cabinet', 'spread_width', 0.845024, 1.11391, 0.1947),
  ('cabinet', 'spread_width', 1.11391, 1.46836, 0.08978),
  ('cabinet', 'spread_width', 1.46836, 20, 0.003753);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'tilt_deg', 0, 0.565371, 0.1775),
  ('cabinet', 'tilt_deg', 0.565371, 10, 0.0049),
  ('cabinet', 'tilt_deg', 10, 20, 9.463e-05),
  ('cabinet', 'tilt_deg', 20, 30, 0.000157),
  ('cabinet', 'tilt_deg', 30, 40, 0.0002522),
  ('cabinet', 'tilt_deg', 40, 50, 0.0003765),
  ('cabinet', 'tilt_deg', 50, 60, 0.0005184),
  ('cabinet', 'tilt_deg', 60, 70, 0.000658),
  ('cabinet', 'tilt_deg', 70, 80, 0.0007837),
  ('cabinet', 'tilt_deg', 80, 88.6687, 0.009439),
  ('cabinet', 'tilt_deg', 88.6687, 89.7242, 0.2363),
  ('cabinet', 'tilt_deg', 89.7242, 90, 1.79);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'width', 0.01, 0.142996, 0.002553),
  ('cabinet', 'width', 0.142996, 0.188248, 0.081),
  ('cabinet', 'width', 0.188248, 0.24782, 0.1523),
  ('cabinet', 'width', 0.24782, 0.322655, 0.1612),
  ('cabinet', 'width', 0.322655, 0.420924, 0.4008),
  ('cabinet', 'width', 0.420924, 0.429489, 0.3793),
  ('cabinet', 'width', 0.429489, 0.506631, 0.6856),
  ('cabinet', 'width', 0.506631, 0.565404, 0.7313),
  ('cabinet', 'width', 0.565404, 0.576594, 1.321),
  ('cabinet', 'width', 0.576594, 0.616305, 1.679),
  ('cabinet', 'width', 0.616305, 0.666501, 1.282),
  ('cabinet', 'width', 0.666501, 0.744332, 0.5267),
  ('cabinet', 'width', 0.744332, 0.823737, 0.5663),
  ('cabinet', 'width', 0.823737, 0.979882, 0.5488),
  ('cabinet', 'width', 0.979882, 1.00604, 0.7092),
  ('cabinet', 'width', 1.00604, 1.28998, 0.2985),
  ('cabinet', 'width', 1.28998, 1.6982, 0.1029),
  ('cabinet', 'width', 1.6982, 12, 0.004451);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_max', -0.5, 0.310976, 0.01064),
  ('cabinet', 'z_max', 0.310976, 0.558253, 0.09794),
  ('cabinet', 'z_max', 0.558253, 0.581179, 3.016),
  ('cabinet', 'z_max', 0.581179, 0.688453, 1.119),
  ('cabinet', 'z_max', 0.688453, 0.790567, 1.119),
  ('cabinet', 'z_max', 0.790567, 0.951993, 0.6323),
  ('cabinet', 'z_max', 0.951993, 1.05281, 0.7467),
  ('cabinet', 'z_max', 1.05281, 1.10528, 0.6889),
  ('cabinet', 'z_max', 1.10528, 1.30009, 0.4133),
  ('cabinet', 'z_max', 1.30009, 1.51341, 0.1593),
  ('cabinet', 'z_max', 1.51341, 1.54736, 0.1265),
  ('cabinet', 'z_max', 1.54736, 1.79464, 0.3876),
  ('cabinet', 'z_max', 1.79464, 1.81981, 0.4983),
  ('cabinet', 'z_max', 1.81981, 1.99419, 0.6728),
  ('cabinet', 'z_max', 1.99419, 2.04192, 0.3436),
  ('cabinet', 'z_max', 2.04192, 2.2892, 0.2561),
  ('cabinet', 'z_max', 2.2892, 2.53647, 0.07258),
  ('cabinet', 'z_max', 2.53647, 4, 0.005459);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_min', -0.5, -0.0527362, 0.03344),
  ('cabinet', 'z_min', -0.0527362, -0.0180783, 5.047),
  ('cabinet', 'z_min', -0.0180783, -0.010611, 15.42),
  ('cabinet', 'z_min', -0.010611, 0.0125324, 9.772),
  ('cabinet', 'z_min', 0.0125324, 0.0816468, 0.8713),
  ('cabinet', 'z_min', 0.0816468, 0.204684, 0.5076),
  ('cabinet', 'z_min', 0.204684, 0.21603, 0.4548),
  ('cabinet', 'z_min', 0.21603, 0.350413, 0.3701),
  ('cabinet', 'z_min', 0.350413, 0.484796, 0.4021),
  ('cabinet', 'z_min', 0.484796, 0.513124, 0.3786),
  ('cabinet', 'z_min', 0.513124, 0.619179, 0.9811),
  ('cabinet', 'z_min', 0.619179, 0.668801, 0.3384),
  ('cabinet', 'z_min', 0.668801, 0.753562, 0.2755),
  ('cabinet', 'z_min', 0.753562, 0.887945, 0.2129),
  ('cabinet', 'z_min', 0.887945, 1.02233, 0.1801),
  ('cabinet', 'z_min', 1.02233, 1.15671, 0.1289),
  ('cabinet', 'z_min', 1.15671, 4, 0.004283);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.547 WHERE name = 'aspect';
UPDATE feature SET weight = 0.299 WHERE name = 'height';
UPDATE feature SET weight = 0.0117 WHERE name = 'length';
UPDATE feature SET weight = 0.326 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.317 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.271 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.426 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.257 WHERE name = 'width';
UPDATE feature SET weight = 0.559 WHERE name = 'z_max';
UPDATE feature SET weight = 0.312 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.326 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.079 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0436 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.107 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0444 WHERE name = 'table';
UPDATE object_class SET prior = 0.0536 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.0912 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.0108 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0655 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0153 WHERE name = 'door';
UPDATE object_class SET prior = 0.0245 WHERE name = 'window';
UPDATE object_class SET prior = 0.0148 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0716 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.0523 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 3.12 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.498 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 3.67 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.51 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 0.34 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.61 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 2.9 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.84 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.56 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.923 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.62 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.287 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 2.49 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 5.13 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.42 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.643 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.694 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 1.52 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.512 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.01 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 0.819 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 1.51 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.42 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 0.549 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.177 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 0.985 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.34 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 0.0926 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.64 WHERE name = 'cabinet_not_on_table';
