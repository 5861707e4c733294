-- Learned by the procedure of `make knowledge` (run over cached planes, not yet by the command itself) from 42 simulated paper-like rooms, seeds 1 to 7, range noise 1 cm.
-- Priors, Gaussians and densities of classes with enough examples replace the hand-set rows of office.sql.

-- unknown: 1221 examples
UPDATE object_class SET prior = 0.5483 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.957, 1.359)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6717, 0.5342)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 1.024, 0.6832)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.4417, 0.7597)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.6918, 0.1504)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.6052, 0.7736)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.345, 0.7203)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 65.37, 37.23)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.116, 0.7099)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.316, 0.9199)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7203, 0.7842)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0116356, 0.004157),
  ('unknown', 'area_m2', 0.0116356, 0.0273141, 0.1073),
  ('unknown', 'area_m2', 0.0273141, 0.0290384, 0.1915),
  ('unknown', 'area_m2', 0.0290384, 0.0496842, 0.2038),
  ('unknown', 'area_m2', 0.0496842, 0.0641185, 0.2315),
  ('unknown', 'area_m2', 0.0641185, 0.0765978, 0.3081),
  ('unknown', 'area_m2', 0.0765978, 0.102862, 0.3792),
  ('unknown', 'area_m2', 0.102862, 0.150515, 0.2853),
  ('unknown', 'area_m2', 0.150515, 0.231408, 0.2641),
  ('unknown', 'area_m2', 0.231408, 0.32458, 0.33),
  ('unknown', 'area_m2', 0.32458, 0.353327, 0.2394),
  ('unknown', 'area_m2', 0.353327, 0.58032, 0.1782),
  ('unknown', 'area_m2', 0.58032, 0.829417, 0.1215),
  ('unknown', 'area_m2', 0.829417, 1.94702, 0.03549),
  ('unknown', 'area_m2', 1.94702, 4.57052, 0.01265),
  ('unknown', 'area_m2', 4.57052, 10.7291, 0.009077),
  ('unknown', 'area_m2', 10.7291, 25.186, 0.01139),
  ('unknown', 'area_m2', 25.186, 100, 0.00709);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.10748, 1.1),
  ('unknown', 'aspect', 1.10748, 1.2492, 0.8975),
  ('unknown', 'aspect', 1.2492, 1.26138, 0.8013),
  ('unknown', 'aspect', 1.26138, 1.41626, 0.9009),
  ('unknown', 'aspect', 1.41626, 1.59108, 0.8858),
  ('unknown', 'aspect', 1.59108, 1.82448, 0.8769),
  ('unknown', 'aspect', 1.82448, 2.00696, 0.6676),
  ('unknown', 'aspect', 2.00696, 2.13597, 0.7211),
  ('unknown', 'aspect', 2.13597, 2.53154, 0.5025),
  ('unknown', 'aspect', 2.53154, 2.74924, 0.3413),
  ('unknown', 'aspect', 2.74924, 3.19324, 0.2672),
  ('unknown', 'aspect', 3.19324, 4.0279, 0.1712),
  ('unknown', 'aspect', 4.0279, 4.55504, 0.2411),
  ('unknown', 'aspect', 4.55504, 5.08071, 0.2447),
  ('unknown', 'aspect', 5.08071, 6.40872, 0.2093),
  ('unknown', 'aspect', 6.40872, 8.08384, 0.1152),
  ('unknown', 'aspect', 8.08384, 100, 0.004303);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0053911, 0.01006),
  ('unknown', 'height', 0.0053911, 0.23294, 0.4619),
  ('unknown', 'height', 0.23294, 0.322839, 0.505),
  ('unknown', 'height', 0.322839, 0.435241, 0.5579),
  ('unknown', 'height', 0.435241, 0.635693, 0.5752),
  ('unknown', 'height', 0.635693, 0.789441, 0.7091),
  ('unknown', 'height', 0.789441, 0.947296, 0.7123),
  ('unknown', 'height', 0.947296, 1.21417, 0.4141),
  ('unknown', 'height', 1.21417, 1.27518, 0.3135),
  ('unknown', 'height', 1.27518, 1.53229, 0.3657),
  ('unknown', 'height', 1.53229, 1.59263, 0.3197),
  ('unknown', 'height', 1.59263, 1.91008, 0.2238),
  ('unknown', 'height', 1.91008, 2.03206, 0.1671),
  ('unknown', 'height', 2.03206, 2.22753, 0.1776),
  ('unknown', 'height', 2.22753, 2.54498, 0.1393),
  ('unknown', 'height', 2.54498, 2.86243, 0.06767),
  ('unknown', 'height', 2.86243, 4, 0.008902);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.131681, 0.005457),
  ('unknown', 'length', 0.131681, 0.207187, 0.11),
  ('unknown', 'length', 0.207187, 0.262085, 0.2354),
  ('unknown', 'length', 0.262085, 0.32599, 0.3294),
  ('unknown', 'length', 0.32599, 0.352062, 0.5092),
  ('unknown', 'length', 0.352062, 0.451383, 0.4452),
  ('unknown', 'length', 0.451383, 0.512916, 0.5786),
  ('unknown', 'length', 0.512916, 0.551856, 0.4939),
  ('unknown', 'length', 0.551856, 0.704909, 0.4516),
  ('unknown', 'length', 0.704909, 0.807026, 0.5142),
  ('unknown', 'length', 0.807026, 0.885956, 0.4333),
  ('unknown', 'length', 0.885956, 1.15736, 0.4214),
  ('unknown', 'length', 1.15736, 1.26978, 0.4029),
  ('unknown', 'length', 1.26978, 1.4788, 0.4899),
  ('unknown', 'length', 1.4788, 1.99788, 0.1993),
  ('unknown', 'length', 1.99788, 3.14349, 0.0369),
  ('unknown', 'length', 3.14349, 4.94599, 0.02973),
  ('unknown', 'length', 4.94599, 7.78205, 0.02323),
  ('unknown', 'length', 7.78205, 30, 0.006766);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.302414, 0.03188),
  ('unknown', 'rectangularity', 0.302414, 0.376998, 0.1655),
  ('unknown', 'rectangularity', 0.376998, 0.451582, 0.6629),
  ('unknown', 'rectangularity', 0.451582, 0.489964, 1.014),
  ('unknown', 'rectangularity', 0.489964, 0.526166, 1.166),
  ('unknown', 'rectangularity', 0.526166, 0.570182, 1.635),
  ('unknown', 'rectangularity', 0.570182, 0.60075, 1.705),
  ('unknown', 'rectangularity', 0.60075, 0.631681, 1.843),
  ('unknown', 'rectangularity', 0.631681, 0.675334, 2.269),
  ('unknown', 'rectangularity', 0.675334, 0.682071, 1.839),
  ('unknown', 'rectangularity', 0.682071, 0.727684, 2.408),
  ('unknown', 'rectangularity', 0.727684, 0.749918, 2.077),
  ('unknown', 'rectangularity', 0.749918, 0.777265, 2.36),
  ('unknown', 'rectangularity', 0.777265, 0.81755, 2.788),
  ('unknown', 'rectangularity', 0.81755, 0.824502, 2.161),
  ('unknown', 'rectangularity', 0.824502, 0.875948, 1.878),
  ('unknown', 'rectangularity', 0.875948, 0.899086, 1.682),
  ('unknown', 'rectangularity', 0.899086, 0.97367, 0.8818),
  ('unknown', 'rectangularity', 0.97367, 1, 0.2161);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.13143, 0.002512),
  ('unknown', 'spread_length', 0.13143, 0.202805, 0.1785),
  ('unknown', 'spread_length', 0.202805, 0.222841, 0.2784),
  ('unknown', 'spread_length', 0.222841, 0.293559, 0.4058),
  ('unknown', 'spread_length', 0.293559, 0.31294, 0.5569),
  ('unknown', 'spread_length', 0.31294, 0.35282, 0.6397),
  ('unknown', 'spread_length', 0.35282, 0.429901, 0.5646),
  ('unknown', 'spread_length', 0.429901, 0.482885, 0.4703),
  ('unknown', 'spread_length', 0.482885, 0.581334, 0.303),
  ('unknown', 'spread_length', 0.581334, 0.745121, 0.3819),
  ('unknown', 'spread_length', 0.745121, 0.770507, 0.4936),
  ('unknown', 'spread_length', 0.770507, 0.987229, 0.4448),
  ('unknown', 'spread_length', 0.987229, 1.14977, 0.3576),
  ('unknown', 'spread_length', 1.14977, 1.33199, 0.3699),
  ('unknown', 'spread_length', 1.33199, 1.77416, 0.2109),
  ('unknown', 'spread_length', 1.77416, 2.73764, 0.04124),
  ('unknown', 'spread_length', 2.73764, 4.22434, 0.02804),
  ('unknown', 'spread_length', 4.22434, 6.51842, 0.02682),
  ('unknown', 'spread_length', 6.51842, 40, 0.005857);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.0793137, 0.001234),
  ('unknown', 'spread_width', 0.0793137, 0.0802922, 0.1325),
  ('unknown', 'spread_width', 0.0802922, 0.118905, 0.2698),
  ('unknown', 'spread_width', 0.118905, 0.124616, 0.2451),
  ('unknown', 'spread_width', 0.124616, 0.156016, 0.4464),
  ('unknown', 'spread_width', 0.156016, 0.192605, 0.5203),
  ('unknown', 'spread_width', 0.192605, 0.195793, 0.7071),
  ('unknown', 'spread_width', 0.195793, 0.215894, 1.016),
  ('unknown', 'spread_width', 0.215894, 0.249236, 0.7831),
  ('unknown', 'spread_width', 0.249236, 0.298184, 0.6064),
  ('unknown', 'spread_width', 0.298184, 0.307626, 0.4477),
  ('unknown', 'spread_width', 0.307626, 0.39805, 0.3853),
  ('unknown', 'spread_width', 0.39805, 0.483334, 0.3231),
  ('unknown', 'spread_width', 0.483334, 0.605851, 0.207),
  ('unknown', 'spread_width', 0.605851, 0.759403, 0.2538),
  ('unknown', 'spread_width', 0.759403, 1.19316, 0.04583),
  ('unknown', 'spread_width', 1.19316, 1.87466, 0.01597),
  ('unknown', 'spread_width', 1.87466, 2.94542, 0.01728),
  ('unknown', 'spread_width', 2.94542, 4.62777, 0.0223),
  ('unknown', 'spread_width', 4.62777, 20, 0.006178);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 0.836336, 0.1299),
  ('unknown', 'tilt_deg', 0.836336, 6.53423, 0.01912),
  ('unknown', 'tilt_deg', 6.53423, 10, 0.003513),
  ('unknown', 'tilt_deg', 10, 20, 0.001343),
  ('unknown', 'tilt_deg', 20, 30, 0.001248),
  ('unknown', 'tilt_deg', 30, 40, 0.00103),
  ('unknown', 'tilt_deg', 40, 50, 0.0006923),
  ('unknown', 'tilt_deg', 50, 60, 0.0006863),
  ('unknown', 'tilt_deg', 60, 70, 0.001086),
  ('unknown', 'tilt_deg', 70, 80, 0.003529),
  ('unknown', 'tilt_deg', 80, 82.0203, 0.005362),
  ('unknown', 'tilt_deg', 82.0203, 88.1169, 0.01869),
  ('unknown', 'tilt_deg', 88.1169, 89.3562, 0.09636),
  ('unknown', 'tilt_deg', 89.3562, 89.7283, 0.44),
  ('unknown', 'tilt_deg', 89.7283, 90, 0.9798);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.0930436, 0.003526),
  ('unknown', 'width', 0.0930436, 0.144286, 0.2061),
  ('unknown', 'width', 0.144286, 0.148418, 0.437),
  ('unknown', 'width', 0.148418, 0.196051, 0.4045),
  ('unknown', 'width', 0.196051, 0.22375, 0.5452),
  ('unknown', 'width', 0.22375, 0.23359, 0.852),
  ('unknown', 'width', 0.23359, 0.273135, 0.7208),
  ('unknown', 'width', 0.273135, 0.328498, 0.5824),
  ('unknown', 'width', 0.328498, 0.346977, 0.7085),
  ('unknown', 'width', 0.346977, 0.383219, 0.7573),
  ('unknown', 'width', 0.383219, 0.514259, 0.3771),
  ('unknown', 'width', 0.514259, 0.538069, 0.2535),
  ('unknown', 'width', 0.538069, 0.734397, 0.3201),
  ('unknown', 'width', 0.734397, 0.834404, 0.3378),
  ('unknown', 'width', 0.834404, 1.29394, 0.07345),
  ('unknown', 'width', 1.29394, 2.00656, 0.01931),
  ('unknown', 'width', 2.00656, 3.11165, 0.01773),
  ('unknown', 'width', 3.11165, 4.82534, 0.02443),
  ('unknown', 'width', 4.82534, 12, 0.01048);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.058628, 0.01357),
  ('unknown', 'z_max', 0.058628, 0.430171, 0.2981),
  ('unknown', 'z_max', 0.430171, 0.496558, 0.5139),
  ('unknown', 'z_max', 0.496558, 0.703413, 0.336),
  ('unknown', 'z_max', 0.703413, 0.787563, 1.323),
  ('unknown', 'z_max', 0.787563, 0.934488, 0.7243),
  ('unknown', 'z_max', 0.934488, 1.18097, 0.4599),
  ('unknown', 'z_max', 1.18097, 1.37242, 0.375),
  ('unknown', 'z_max', 1.37242, 1.54116, 0.2399),
  ('unknown', 'z_max', 1.54116, 1.81035, 0.2777),
  ('unknown', 'z_max', 1.81035, 1.97367, 0.2272),
  ('unknown', 'z_max', 1.97367, 2.24609, 0.4121),
  ('unknown', 'z_max', 2.24609, 2.68621, 0.1488),
  ('unknown', 'z_max', 2.68621, 3.12414, 0.03525),
  ('unknown', 'z_max', 3.12414, 3.56207, 0.01029),
  ('unknown', 'z_max', 3.56207, 4, 0.05726);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.13485, 0.08445),
  ('unknown', 'z_min', -0.13485, -0.0142708, 0.7355),
  ('unknown', 'z_min', -0.0142708, 0.0269298, 2.551),
  ('unknown', 'z_min', 0.0269298, 0.2303, 0.4506),
  ('unknown', 'z_min', 0.2303, 0.276409, 0.3526),
  ('unknown', 'z_min', 0.276409, 0.59545, 0.3262),
  ('unknown', 'z_min', 0.59545, 0.622602, 0.263),
  ('unknown', 'z_min', 0.622602, 0.750851, 0.8574),
  ('unknown', 'z_min', 0.750851, 0.880028, 0.8637),
  ('unknown', 'z_min', 0.880028, 0.9606, 0.5),
  ('unknown', 'z_min', 0.9606, 1.22641, 0.2751),
  ('unknown', 'z_min', 1.22641, 1.32575, 0.3517),
  ('unknown', 'z_min', 1.32575, 1.6909, 0.1778),
  ('unknown', 'z_min', 1.6909, 1.77692, 0.117),
  ('unknown', 'z_min', 1.77692, 2.05605, 0.09406),
  ('unknown', 'z_min', 2.05605, 2.4212, 0.1419),
  ('unknown', 'z_min', 2.4212, 2.78635, 0.06784),
  ('unknown', 'z_min', 2.78635, 4, 0.007042);

-- floor: 47 examples
UPDATE object_class SET prior = 0.02123 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 2.047, 0.6979)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4632, 0.3399)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', -6.868e-06, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.521, 0.3061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.6006, 0.1127)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 1.215, 0.2088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.6383, 0.4138)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.005984, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 1.057, 0.471)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.0001138, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.0001911, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'floor' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'area_m2', 0.002, 0.676356, 0.00283),
  ('floor', 'area_m2', 0.676356, 1.01199, 0.009391),
  ('floor', 'area_m2', 1.01199, 1.51419, 0.07308),
  ('floor', 'area_m2', 1.51419, 2.2656, 0.0895),
  ('floor', 'area_m2', 2.2656, 3.3899, 0.05704),
  ('floor', 'area_m2', 3.3899, 5.07212, 0.1113),
  ('floor', 'area_m2', 5.07212, 6.64338, 0.3945),
  ('floor', 'area_m2', 6.64338, 7.49661, 0.9095),
  ('floor', 'area_m2', 7.49661, 7.94239, 1.494),
  ('floor', 'area_m2', 7.94239, 9.29195, 0.6692),
  ('floor', 'area_m2', 9.29195, 10.5786, 0.7562),
  ('floor', 'area_m2', 10.5786, 11.3552, 1.267),
  ('floor', 'area_m2', 11.3552, 11.8644, 0.4306),
  ('floor', 'area_m2', 11.8644, 13.8126, 0.5476),
  ('floor', 'area_m2', 13.8126, 16.9902, 0.397),
  ('floor', 'area_m2', 16.9902, 25.4215, 0.1129),
  ('floor', 'area_m2', 25.4215, 100, 0.01534);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'aspect', 1, 1.02209, 1.437),
  ('floor', 'aspect', 1.02209, 1.06205, 2.198),
  ('floor', 'aspect', 1.06205, 1.17762, 0.8525),
  ('floor', 'aspect', 1.17762, 1.20634, 0.7606),
  ('floor', 'aspect', 1.20634, 1.3174, 1.368),
  ('floor', 'aspect', 1.3174, 1.38679, 1.357),
  ('floor', 'aspect', 1.38679, 1.43678, 0.6091),
  ('floor', 'aspect', 1.43678, 1.63311, 0.9256),
  ('floor', 'aspect', 1.63311, 1.75236, 1.472),
  ('floor', 'aspect', 1.75236, 1.92318, 0.866),
  ('floor', 'aspect', 1.92318, 2.06634, 0.5406),
  ('floor', 'aspect', 2.06634, 2.26478, 0.693),
  ('floor', 'aspect', 2.26478, 2.33554, 0.7388),
  ('floor', 'aspect', 2.33554, 2.66705, 0.4677),
  ('floor', 'aspect', 2.66705, 3.14077, 0.2371),
  ('floor', 'aspect', 3.14077, 3.69864, 0.1009),
  ('floor', 'aspect', 3.69864, 4.35559, 0.03466),
  ('floor', 'aspect', 4.35559, 100, 0.004891);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'height', -0.5, -0.0225936, 0.1045),
  ('floor', 'height', -0.0225936, -0.0125664, 11.37),
  ('floor', 'height', -0.0125664, -0.00253928, 25.54),
  ('floor', 'height', -0.00253928, 0.00748786, 30.28),
  ('floor', 'height', 0.00748786, 0.017515, 18.4),
  ('floor', 'height', 0.017515, 4, 0.02307);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'length', 0.03, 1.91134, 0.002448),
  ('floor', 'length', 1.91134, 2.26695, 0.1199),
  ('floor', 'length', 2.26695, 2.68873, 0.1725),
  ('floor', 'length', 2.68873, 3.18898, 0.2908),
  ('floor', 'length', 3.18898, 3.35565, 0.4194),
  ('floor', 'length', 3.35565, 3.7823, 0.6351),
  ('floor', 'length', 3.7823, 3.90909, 1.034),
  ('floor', 'length', 3.90909, 4.17742, 1.453),
  ('floor', 'length', 4.17742, 4.42813, 1.927),
  ('floor', 'length', 4.42813, 4.62438, 2.021),
  ('floor', 'length', 4.62438, 5.13956, 1.143),
  ('floor', 'length', 5.13956, 5.32065, 1.357),
  ('floor', 'length', 5.32065, 5.67327, 1.009),
  ('floor', 'length', 5.67327, 6.31058, 0.8102),
  ('floor', 'length', 6.31058, 6.45096, 0.7901),
  ('floor', 'length', 6.45096, 7.48468, 0.5056),
  ('floor', 'length', 7.48468, 8.33128, 0.2468),
  ('floor', 'length', 8.33128, 8.87724, 0.191),
  ('floor', 'length', 8.87724, 30, 0.01036);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'rectangularity', 0, 0.322014, 0.03866),
  ('floor', 'rectangularity', 0.322014, 0.386318, 0.3534),
  ('floor', 'rectangularity', 0.386318, 0.450622, 0.7362),
  ('floor', 'rectangularity', 0.450622, 0.494983, 0.9678),
  ('floor', 'rectangularity', 0.494983, 0.514926, 1.503),
  ('floor', 'rectangularity', 0.514926, 0.533632, 4.803),
  ('floor', 'rectangularity', 0.533632, 0.547245, 6.902),
  ('floor', 'rectangularity', 0.547245, 0.567826, 4.588),
  ('floor', 'rectangularity', 0.567826, 0.579229, 3.848),
  ('floor', 'rectangularity', 0.579229, 0.590784, 4.134),
  ('floor', 'rectangularity', 0.590784, 0.631505, 3.169),
  ('floor', 'rectangularity', 0.631505, 0.643533, 3.299),
  ('floor', 'rectangularity', 0.643533, 0.678095, 2.243),
  ('floor', 'rectangularity', 0.678095, 0.707837, 1.703),
  ('floor', 'rectangularity', 0.707837, 0.747843, 1.507),
  ('floor', 'rectangularity', 0.747843, 0.772141, 1.394),
  ('floor', 'rectangularity', 0.772141, 0.836444, 0.8082),
  ('floor', 'rectangularity', 0.836444, 0.900748, 0.329),
  ('floor', 'rectangularity', 0.900748, 1, 0.1062);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_length', 0.01, 1.62364, 0.002311),
  ('floor', 'spread_length', 1.62364, 1.84239, 0.1063),
  ('floor', 'spread_length', 1.84239, 2.09061, 0.07853),
  ('floor', 'spread_length', 2.09061, 2.37228, 0.0741),
  ('floor', 'spread_length', 2.37228, 2.69189, 0.4484),
  ('floor', 'spread_length', 2.69189, 2.74574, 1.67),
  ('floor', 'spread_length', 2.74574, 2.9716, 1.453),
  ('floor', 'spread_length', 2.9716, 3.05456, 1.217),
  ('floor', 'spread_length', 3.05456, 3.19696, 1.401),
  ('floor', 'spread_length', 3.19696, 3.33477, 2.197),
  ('floor', 'spread_length', 3.33477, 3.4661, 1.99),
  ('floor', 'spread_length', 3.4661, 3.58947, 1.893),
  ('floor', 'spread_length', 3.58947, 3.7289, 2.363),
  ('floor', 'spread_length', 3.7289, 3.93308, 1.844),
  ('floor', 'spread_length', 3.93308, 4.13218, 1.944),
  ('floor', 'spread_length', 4.13218, 4.46298, 0.9361),
  ('floor', 'spread_length', 4.46298, 5.0415, 0.3733),
  ('floor', 'spread_length', 5.0415, 40, 0.007609);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_width', 0.003, 0.411784, 0.003442),
  ('floor', 'spread_width', 0.411784, 0.522138, 0.001799),
  ('floor', 'spread_width', 0.522138, 0.662067, 0.05317),
  ('floor', 'spread_width', 0.662067, 0.839495, 0.195),
  ('floor', 'spread_width', 0.839495, 1.06447, 0.1066),
  ('floor', 'spread_width', 1.06447, 1.33383, 0.1652),
  ('floor', 'spread_width', 1.33383, 1.71146, 0.4483),
  ('floor', 'spread_width', 1.71146, 1.74009, 0.7205),
  ('floor', 'spread_width', 1.74009, 1.88694, 1.406),
  ('floor', 'spread_width', 1.88694, 2.01527, 1.401),
  ('floor', 'spread_width', 2.01527, 2.17012, 1.235),
  ('floor', 'spread_width', 2.17012, 2.30351, 1.72),
  ('floor', 'spread_width', 2.30351, 2.47076, 1.63),
  ('floor', 'spread_width', 2.47076, 2.65782, 1.328),
  ('floor', 'spread_width', 2.65782, 2.75169, 0.9204),
  ('floor', 'spread_width', 2.75169, 3.38795, 0.3127),
  ('floor', 'spread_width', 3.38795, 3.48912, 0.1906),
  ('floor', 'spread_width', 3.48912, 20, 0.01345);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'tilt_deg', 0, 0.165953, 2.938),
  ('floor', 'tilt_deg', 0.165953, 0.331907, 1.847),
  ('floor', 'tilt_deg', 0.331907, 0.49786, 0.7806),
  ('floor', 'tilt_deg', 0.49786, 90, 0.0008516);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'width', 0.01, 0.532091, 0.004011),
  ('floor', 'width', 0.532091, 0.700536, 0.01205),
  ('floor', 'width', 0.700536, 0.922307, 0.06003),
  ('floor', 'width', 0.922307, 1.21428, 0.14),
  ('floor', 'width', 1.21428, 1.59869, 0.1183),
  ('floor', 'width', 1.59869, 1.92125, 0.1657),
  ('floor', 'width', 1.92125, 2.1048, 0.2964),
  ('floor', 'width', 2.1048, 2.41669, 0.6224),
  ('floor', 'width', 2.41669, 2.77112, 0.7543),
  ('floor', 'width', 2.77112, 3.04979, 1.224),
  ('floor', 'width', 3.04979, 3.21583, 1.815),
  ('floor', 'width', 3.21583, 3.64838, 0.7437),
  ('floor', 'width', 3.64838, 3.91046, 1.503),
  ('floor', 'width', 3.91046, 4.42926, 0.9379),
  ('floor', 'width', 4.42926, 4.80336, 0.4161),
  ('floor', 'width', 4.80336, 6.29168, 0.2365),
  ('floor', 'width', 6.29168, 12, 0.0317);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_max', -0.5, -0.0224763, 0.1044),
  ('floor', 'z_max', -0.0224763, -0.012409, 11.4),
  ('floor', 'z_max', -0.012409, -0.00234175, 25.6),
  ('floor', 'z_max', -0.00234175, 0.00772552, 30.22),
  ('floor', 'z_max', 0.00772552, 0.0177928, 18.2),
  ('floor', 'z_max', 0.0177928, 4, 0.02264);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_min', -0.5, -0.0230972, 0.1007),
  ('floor', 'z_min', -0.0230972, -0.0129679, 11.06),
  ('floor', 'z_min', -0.0129679, -0.00283852, 25.31),
  ('floor', 'z_min', -0.00283852, 0.00729083, 30.29),
  ('floor', 'z_min', 0.00729083, 0.0174202, 18.35),
  ('floor', 'z_min', 0.0174202, 4, 0.02283);

-- ceiling: 48 examples
UPDATE object_class SET prior = 0.02168 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.842, 1.298)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.5529, 0.5064)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.719, 0.1978)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.376, 0.4598)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.7186, 0.1322)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.224, 0.4209)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.494, 0.786)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.01726, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.8161, 0.869)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.719, 0.1977)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.719, 0.1978)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'area_m2', 0.002, 0.0593127, 0.003793),
  ('ceiling', 'area_m2', 0.0593127, 0.118467, 0.02846),
  ('ceiling', 'area_m2', 0.118467, 0.236618, 0.006083),
  ('ceiling', 'area_m2', 0.236618, 0.472605, 0.03655),
  ('ceiling', 'area_m2', 0.472605, 0.94395, 0.06695),
  ('ceiling', 'area_m2', 0.94395, 1.27609, 0.0436),
  ('ceiling', 'area_m2', 1.27609, 1.88538, 0.03517),
  ('ceiling', 'area_m2', 1.88538, 3.76573, 0.04898),
  ('ceiling', 'area_m2', 3.76573, 6.07511, 0.2364),
  ('ceiling', 'area_m2', 6.07511, 7.34231, 0.5022),
  ('ceiling', 'area_m2', 7.34231, 8.4132, 0.7935),
  ('ceiling', 'area_m2', 8.4132, 8.85528, 1.384),
  ('ceiling', 'area_m2', 8.85528, 10.2122, 0.7024),
  ('ceiling', 'area_m2', 10.2122, 12.4535, 0.6001),
  ('ceiling', 'area_m2', 12.4535, 15.0228, 0.3844),
  ('ceiling', 'area_m2', 15.0228, 16.8097, 0.194),
  ('ceiling', 'area_m2', 16.8097, 28.1541, 0.1737),
  ('ceiling', 'area_m2', 28.1541, 30.0055, 0.1153),
  ('ceiling', 'area_m2', 30.0055, 100, 0.02802);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'aspect', 1, 1.06532, 1.648),
  ('ceiling', 'aspect', 1.06532, 1.15985, 1.277),
  ('ceiling', 'aspect', 1.15985, 1.27133, 1.209),
  ('ceiling', 'aspect', 1.27133, 1.46291, 0.7594),
  ('ceiling', 'aspect', 1.46291, 1.68167, 0.6253),
  ('ceiling', 'aspect', 1.68167, 1.77945, 0.735),
  ('ceiling', 'aspect', 1.77945, 1.89425, 1.401),
  ('ceiling', 'aspect', 1.89425, 2.18077, 0.627),
  ('ceiling', 'aspect', 2.18077, 2.29992, 0.4473),
  ('ceiling', 'aspect', 2.29992, 2.7146, 0.5808),
  ('ceiling', 'aspect', 2.7146, 2.828, 0.4926),
  ('ceiling', 'aspect', 2.828, 3.66732, 0.1886),
  ('ceiling', 'aspect', 3.66732, 4.75575, 0.1133),
  ('ceiling', 'aspect', 4.75575, 6.16721, 0.04552),
  ('ceiling', 'aspect', 6.16721, 7.99758, 0.03555),
  ('ceiling', 'aspect', 7.99758, 10.3712, 0.05749),
  ('ceiling', 'aspect', 10.3712, 100, 0.004605);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'height', -0.5, 2.39619, 0.003581),
  ('ceiling', 'height', 2.39619, 2.45257, 0.5812),
  ('ceiling', 'height', 2.45257, 2.47887, 1.956),
  ('ceiling', 'height', 2.47887, 2.4978, 3.862),
  ('ceiling', 'height', 2.4978, 2.56154, 1.953),
  ('ceiling', 'height', 2.56154, 2.59782, 0.9492),
  ('ceiling', 'height', 2.59782, 2.64421, 1.068),
  ('ceiling', 'height', 2.64421, 2.68383, 1.59),
  ('ceiling', 'height', 2.68383, 2.72688, 2.442),
  ('ceiling', 'height', 2.72688, 2.80432, 1.516),
  ('ceiling', 'height', 2.80432, 2.89223, 1.261),
  ('ceiling', 'height', 2.89223, 2.9749, 1.305),
  ('ceiling', 'height', 2.9749, 3.05757, 0.8109),
  ('ceiling', 'height', 3.05757, 3.07962, 0.6579),
  ('ceiling', 'height', 3.07962, 3.14024, 0.4699),
  ('ceiling', 'height', 3.14024, 4, 0.01113);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'length', 0.03, 0.722861, 0.005167),
  ('ceiling', 'length', 0.722861, 0.926279, 0.007985),
  ('ceiling', 'length', 0.926279, 1.18694, 0.05522),
  ('ceiling', 'length', 1.18694, 1.52095, 0.08331),
  ('ceiling', 'length', 1.52095, 1.89088, 0.2385),
  ('ceiling', 'length', 1.89088, 1.94896, 0.1359),
  ('ceiling', 'length', 1.94896, 2.49741, 0.09759),
  ('ceiling', 'length', 2.49741, 3.2002, 0.2015),
  ('ceiling', 'length', 3.2002, 3.64452, 0.5916),
  ('ceiling', 'length', 3.64452, 4.04381, 1.072),
  ('ceiling', 'length', 4.04381, 4.38555, 1.326),
  ('ceiling', 'length', 4.38555, 4.67168, 1.732),
  ('ceiling', 'length', 4.67168, 4.84579, 2.092),
  ('ceiling', 'length', 4.84579, 5.25474, 0.953),
  ('ceiling', 'length', 5.25474, 5.65168, 1.704),
  ('ceiling', 'length', 5.65168, 6.35166, 0.6646),
  ('ceiling', 'length', 6.35166, 6.73346, 0.4419),
  ('ceiling', 'length', 6.73346, 30, 0.02034);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'rectangularity', 0, 0.468725, 0.02684),
  ('ceiling', 'rectangularity', 0.468725, 0.492448, 0.6789),
  ('ceiling', 'rectangularity', 0.492448, 0.525939, 1.196),
  ('ceiling', 'rectangularity', 0.525939, 0.55673, 1.748),
  ('ceiling', 'rectangularity', 0.55673, 0.583153, 1.945),
  ('ceiling', 'rectangularity', 0.583153, 0.604974, 2.254),
  ('ceiling', 'rectangularity', 0.604974, 0.640368, 2.682),
  ('ceiling', 'rectangularity', 0.640368, 0.696321, 2.299),
  ('ceiling', 'rectangularity', 0.696321, 0.734492, 2.901),
  ('ceiling', 'rectangularity', 0.734492, 0.754796, 2.704),
  ('ceiling', 'rectangularity', 0.754796, 0.789605, 1.801),
  ('ceiling', 'rectangularity', 0.789605, 0.81201, 2.379),
  ('ceiling', 'rectangularity', 0.81201, 0.831033, 2.344),
  ('ceiling', 'rectangularity', 0.831033, 0.869225, 1.318),
  ('ceiling', 'rectangularity', 0.869225, 0.899703, 2.373),
  ('ceiling', 'rectangularity', 0.899703, 0.926439, 2.148),
  ('ceiling', 'rectangularity', 0.926439, 0.955365, 0.8549),
  ('ceiling', 'rectangularity', 0.955365, 0.983653, 0.5669),
  ('ceiling', 'rectangularity', 0.983653, 1, 0.3819);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_length', 0.01, 0.745015, 0.003862),
  ('ceiling', 'spread_length', 0.745015, 0.928833, 0.006041),
  ('ceiling', 'spread_length', 0.928833, 1.15801, 0.07337),
  ('ceiling', 'spread_length', 1.15801, 1.44372, 0.1931),
  ('ceiling', 'spread_length', 1.44372, 1.79993, 0.1592),
  ('ceiling', 'spread_length', 1.79993, 1.84427, 0.08908),
  ('ceiling', 'spread_length', 1.84427, 2.24403, 0.09367),
  ('ceiling', 'spread_length', 2.24403, 2.7977, 0.1885),
  ('ceiling', 'spread_length', 2.7977, 3.23076, 0.6458),
  ('ceiling', 'spread_length', 3.23076, 3.48798, 0.9093),
  ('ceiling', 'spread_length', 3.48798, 3.60312, 1.286),
  ('ceiling', 'spread_length', 3.60312, 3.8737, 1.782),
  ('ceiling', 'spread_length', 3.8737, 3.965, 2.833),
  ('ceiling', 'spread_length', 3.965, 4.10921, 2.519),
  ('ceiling', 'spread_length', 4.10921, 4.33499, 1.907),
  ('ceiling', 'spread_length', 4.33499, 4.54894, 1.762),
  ('ceiling', 'spread_length', 4.54894, 5.29885, 0.718),
  ('ceiling', 'spread_length', 5.29885, 5.4215, 0.2671),
  ('ceiling', 'spread_length', 5.4215, 40, 0.01706);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_width', 0.003, 0.0977417, 0.003041),
  ('ceiling', 'spread_width', 0.0977417, 0.148778, 0.05288),
  ('ceiling', 'spread_width', 0.148778, 0.226462, 0.04169),
  ('ceiling', 'spread_width', 0.226462, 0.344709, 0.02272),
  ('ceiling', 'spread_width', 0.344709, 0.5247, 0.06863),
  ('ceiling', 'spread_width', 0.5247, 0.798672, 0.1049),
  ('ceiling', 'spread_width', 0.798672, 1.2157, 0.1034),
  ('ceiling', 'spread_width', 1.2157, 1.55975, 0.4192),
  ('ceiling', 'spread_width', 1.55975, 1.73969, 0.8244),
  ('ceiling', 'spread_width', 1.73969, 1.85048, 1.204),
  ('ceiling', 'spread_width', 1.85048, 1.97358, 1.728),
  ('ceiling', 'spread_width', 1.97358, 2.17482, 1),
  ('ceiling', 'spread_width', 2.17482, 2.52226, 0.6868),
  ('ceiling', 'spread_width', 2.52226, 2.8167, 0.6243),
  ('ceiling', 'spread_width', 2.8167, 3.09382, 0.4939),
  ('ceiling', 'spread_width', 3.09382, 3.91436, 0.355),
  ('ceiling', 'spread_width', 3.91436, 4.28745, 0.188),
  ('ceiling', 'spread_width', 4.28745, 20, 0.01873);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'tilt_deg', 0, 0.147749, 2.95),
  ('ceiling', 'tilt_deg', 0.147749, 0.295498, 2.052),
  ('ceiling', 'tilt_deg', 0.295498, 0.443248, 1.033),
  ('ceiling', 'tilt_deg', 0.443248, 0.590997, 0.42),
  ('ceiling', 'tilt_deg', 0.590997, 90, 0.000518);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'width', 0.01, 0.103832, 0.004903),
  ('ceiling', 'width', 0.103832, 0.161358, 0.05126),
  ('ceiling', 'width', 0.161358, 0.250757, 0.03506),
  ('ceiling', 'width', 0.250757, 0.389685, 0.01672),
  ('ceiling', 'width', 0.389685, 0.605584, 0.07089),
  ('ceiling', 'width', 0.605584, 0.941099, 0.08669),
  ('ceiling', 'width', 0.941099, 1.00402, 0.087),
  ('ceiling', 'width', 1.00402, 1.4625, 0.07923),
  ('ceiling', 'width', 1.4625, 2.07666, 0.3474),
  ('ceiling', 'width', 2.07666, 2.2334, 1.198),
  ('ceiling', 'width', 2.2334, 2.84775, 0.4599),
  ('ceiling', 'width', 2.84775, 3.07052, 1.098),
  ('ceiling', 'width', 3.07052, 3.35732, 1.164),
  ('ceiling', 'width', 3.35732, 3.53198, 0.8595),
  ('ceiling', 'width', 3.53198, 3.83471, 0.7467),
  ('ceiling', 'width', 3.83471, 4.34564, 0.805),
  ('ceiling', 'width', 4.34564, 5.37692, 0.3963),
  ('ceiling', 'width', 5.37692, 5.48883, 0.1488),
  ('ceiling', 'width', 5.48883, 12, 0.04824);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_max', -0.5, 2.39627, 0.003574),
  ('ceiling', 'z_max', 2.39627, 2.45266, 0.5804),
  ('ceiling', 'z_max', 2.45266, 2.47896, 1.938),
  ('ceiling', 'z_max', 2.47896, 2.49805, 3.819),
  ('ceiling', 'z_max', 2.49805, 2.56164, 1.968),
  ('ceiling', 'z_max', 2.56164, 2.5981, 0.9509),
  ('ceiling', 'z_max', 2.5981, 2.64433, 1.067),
  ('ceiling', 'z_max', 2.64433, 2.68417, 1.589),
  ('ceiling', 'z_max', 2.68417, 2.72701, 2.448),
  ('ceiling', 'z_max', 2.72701, 2.80439, 1.517),
  ('ceiling', 'z_max', 2.80439, 2.89238, 1.26),
  ('ceiling', 'z_max', 2.89238, 2.97507, 1.306),
  ('ceiling', 'z_max', 2.97507, 3.05775, 0.8105),
  ('ceiling', 'z_max', 3.05775, 3.0798, 0.6577),
  ('ceiling', 'z_max', 3.0798, 3.14044, 0.4695),
  ('ceiling', 'z_max', 3.14044, 4, 0.01112);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_min', -0.5, 2.39611, 0.003586),
  ('ceiling', 'z_min', 2.39611, 2.45253, 0.5797),
  ('ceiling', 'z_min', 2.45253, 2.47878, 1.983),
  ('ceiling', 'z_min', 2.47878, 2.49754, 3.901),
  ('ceiling', 'z_min', 2.49754, 2.56145, 1.939),
  ('ceiling', 'z_min', 2.56145, 2.59767, 0.9482),
  ('ceiling', 'z_min', 2.59767, 2.64411, 1.069),
  ('ceiling', 'z_min', 2.64411, 2.68359, 1.589),
  ('ceiling', 'z_min', 2.68359, 2.72678, 2.441),
  ('ceiling', 'z_min', 2.72678, 2.80427, 1.514),
  ('ceiling', 'z_min', 2.80427, 2.89211, 1.262),
  ('ceiling', 'z_min', 2.89211, 2.97477, 1.304),
  ('ceiling', 'z_min', 2.97477, 3.05744, 0.8112),
  ('ceiling', 'z_min', 3.05744, 3.07944, 0.6584),
  ('ceiling', 'z_min', 3.07944, 3.1401, 0.4702),
  ('ceiling', 'z_min', 3.1401, 4, 0.01112);

-- wall: 213 examples
UPDATE object_class SET prior = 0.09621 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 1.347, 0.8865)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.5355, 0.4116)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.492, 0.2013)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 1.158, 0.3571)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6691, 0.1499)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.9857, 0.3691)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', 0.3585, 0.5907)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.97, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.6212, 0.573)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.716, 0.2155)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.1402, 0.3473)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'wall' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'area_m2', 0.002, 0.25361, 0.001826),
  ('wall', 'area_m2', 0.25361, 0.401539, 0.03608),
  ('wall', 'area_m2', 0.401539, 0.635755, 0.03724),
  ('wall', 'area_m2', 0.635755, 1.00659, 0.09008),
  ('wall', 'area_m2', 1.00659, 1.15362, 0.2077),
  ('wall', 'area_m2', 1.15362, 1.59372, 0.2121),
  ('wall', 'area_m2', 1.59372, 2.21202, 0.1482),
  ('wall', 'area_m2', 2.21202, 2.52334, 0.2536),
  ('wall', 'area_m2', 2.52334, 2.96075, 0.4688),
  ('wall', 'area_m2', 2.96075, 3.99518, 0.3361),
  ('wall', 'area_m2', 3.99518, 5.58804, 0.3769),
  ('wall', 'area_m2', 5.58804, 6.32555, 0.6942),
  ('wall', 'area_m2', 6.32555, 8.01928, 0.5475),
  ('wall', 'area_m2', 8.01928, 9.58885, 0.5824),
  ('wall', 'area_m2', 9.58885, 10.0152, 0.3871),
  ('wall', 'area_m2', 10.0152, 14.5713, 0.2355),
  ('wall', 'area_m2', 14.5713, 15.857, 0.04946),
  ('wall', 'area_m2', 15.857, 100, 0.00312);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'aspect', 1, 1.12918, 0.9301),
  ('wall', 'aspect', 1.12918, 1.27767, 0.8955),
  ('wall', 'aspect', 1.27767, 1.30776, 1.215),
  ('wall', 'aspect', 1.30776, 1.38577, 1.257),
  ('wall', 'aspect', 1.38577, 1.54, 1.144),
  ('wall', 'aspect', 1.54, 1.66636, 1.324),
  ('wall', 'aspect', 1.66636, 1.71025, 1.309),
  ('wall', 'aspect', 1.71025, 1.81922, 1.223),
  ('wall', 'aspect', 1.81922, 2.00832, 1.198),
  ('wall', 'aspect', 2.00832, 2.2366, 0.5424),
  ('wall', 'aspect', 2.2366, 2.57431, 0.3503),
  ('wall', 'aspect', 2.57431, 2.92494, 0.1729),
  ('wall', 'aspect', 2.92494, 3.82514, 0.1419),
  ('wall', 'aspect', 3.82514, 5.00237, 0.1073),
  ('wall', 'aspect', 5.00237, 6.54192, 0.04379),
  ('wall', 'aspect', 6.54192, 8.55529, 0.001047),
  ('wall', 'aspect', 8.55529, 11.1883, 0.004762),
  ('wall', 'aspect', 11.1883, 100, 0.005505);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'height', -0.5, 1.16696, 0.004789),
  ('wall', 'height', 1.16696, 1.27045, 1.046),
  ('wall', 'height', 1.27045, 1.2836, 1.095),
  ('wall', 'height', 1.2836, 1.34547, 1.553),
  ('wall', 'height', 1.34547, 1.38746, 2.499),
  ('wall', 'height', 1.38746, 1.40025, 1.219),
  ('wall', 'height', 1.40025, 1.43595, 2.371),
  ('wall', 'height', 1.43595, 1.49221, 2.194),
  ('wall', 'height', 1.49221, 1.5169, 2.57),
  ('wall', 'height', 1.5169, 1.53272, 2.486),
  ('wall', 'height', 1.53272, 1.60705, 1.578),
  ('wall', 'height', 1.60705, 1.63354, 1.384),
  ('wall', 'height', 1.63354, 1.69873, 1.114),
  ('wall', 'height', 1.69873, 1.75019, 0.5761),
  ('wall', 'height', 1.75019, 1.86684, 0.2663),
  ('wall', 'height', 1.86684, 1.98348, 0.1499),
  ('wall', 'height', 1.98348, 2.10013, 0.1286),
  ('wall', 'height', 2.10013, 2.21678, 0.09816),
  ('wall', 'height', 2.21678, 4, 0.005971);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'length', 0.03, 1.16114, 0.00263),
  ('wall', 'length', 1.16114, 1.40752, 0.0959),
  ('wall', 'length', 1.40752, 1.70618, 0.1015),
  ('wall', 'length', 1.70618, 2.06821, 0.1954),
  ('wall', 'length', 2.06821, 2.2007, 0.4848),
  ('wall', 'length', 2.2007, 2.47878, 1),
  ('wall', 'length', 2.47878, 2.63926, 1.576),
  ('wall', 'length', 2.63926, 2.97991, 0.9567),
  ('wall', 'length', 2.97991, 3.03903, 1.366),
  ('wall', 'length', 3.03903, 3.34063, 0.8923),
  ('wall', 'length', 3.34063, 3.68387, 0.6285),
  ('wall', 'length', 3.68387, 3.87782, 0.7621),
  ('wall', 'length', 3.87782, 4.42191, 0.8402),
  ('wall', 'length', 4.42191, 4.92311, 1.129),
  ('wall', 'length', 4.92311, 5.41308, 0.5837),
  ('wall', 'length', 5.41308, 6.32756, 0.2633),
  ('wall', 'length', 6.32756, 6.56167, 0.1135),
  ('wall', 'length', 6.56167, 30, 0.004421);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'rectangularity', 0, 0.292069, 0.025),
  ('wall', 'rectangularity', 0.292069, 0.370287, 0.1504),
  ('wall', 'rectangularity', 0.370287, 0.448506, 0.5779),
  ('wall', 'rectangularity', 0.448506, 0.478513, 1.582),
  ('wall', 'rectangularity', 0.478513, 0.526725, 1.49),
  ('wall', 'rectangularity', 0.526725, 0.548421, 1.853),
  ('wall', 'rectangularity', 0.548421, 0.601642, 2.021),
  ('wall', 'rectangularity', 0.601642, 0.642853, 2.641),
  ('wall', 'rectangularity', 0.642853, 0.679082, 3.021),
  ('wall', 'rectangularity', 0.679082, 0.739283, 1.921),
  ('wall', 'rectangularity', 0.739283, 0.761381, 1.35),
  ('wall', 'rectangularity', 0.761381, 0.790669, 2.784),
  ('wall', 'rectangularity', 0.790669, 0.8396, 1.731),
  ('wall', 'rectangularity', 0.8396, 0.867852, 1.066),
  ('wall', 'rectangularity', 0.867852, 0.917819, 1.072),
  ('wall', 'rectangularity', 0.917819, 0.98693, 0.6855),
  ('wall', 'rectangularity', 0.98693, 1, 0.5843);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_length', 0.01, 0.952758, 0.0023),
  ('wall', 'spread_length', 0.952758, 1.16559, 0.09725),
  ('wall', 'spread_length', 1.16559, 1.42598, 0.1298),
  ('wall', 'spread_length', 1.42598, 1.74453, 0.239),
  ('wall', 'spread_length', 1.74453, 2.11771, 0.6095),
  ('wall', 'spread_length', 2.11771, 2.2985, 1.356),
  ('wall', 'spread_length', 2.2985, 2.49158, 1.338),
  ('wall', 'spread_length', 2.49158, 2.611, 1.327),
  ('wall', 'spread_length', 2.611, 2.73415, 1.128),
  ('wall', 'spread_length', 2.73415, 3.19427, 0.6723),
  ('wall', 'spread_length', 3.19427, 3.78847, 0.7313),
  ('wall', 'spread_length', 3.78847, 3.90784, 1.212),
  ('wall', 'spread_length', 3.90784, 4.19184, 0.961),
  ('wall', 'spread_length', 4.19184, 4.78082, 0.4846),
  ('wall', 'spread_length', 4.78082, 5.8488, 0.1909),
  ('wall', 'spread_length', 5.8488, 40, 0.004022);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_width', 0.003, 0.178757, 0.002511),
  ('wall', 'spread_width', 0.178757, 0.246399, 0.02635),
  ('wall', 'spread_width', 0.246399, 0.339638, 0.05112),
  ('wall', 'spread_width', 0.339638, 0.468159, 0.1018),
  ('wall', 'spread_width', 0.468159, 0.645313, 0.1056),
  ('wall', 'spread_width', 0.645313, 0.689037, 0.1567),
  ('wall', 'spread_width', 0.689037, 0.889502, 0.3025),
  ('wall', 'spread_width', 0.889502, 1.05803, 0.2377),
  ('wall', 'spread_width', 1.05803, 1.22609, 0.3962),
  ('wall', 'spread_width', 1.22609, 1.364, 0.5674),
  ('wall', 'spread_width', 1.364, 1.61577, 0.6186),
  ('wall', 'spread_width', 1.61577, 1.69005, 0.8772),
  ('wall', 'spread_width', 1.69005, 1.78084, 1.266),
  ('wall', 'spread_width', 1.78084, 1.96015, 1.113),
  ('wall', 'spread_width', 1.96015, 2.27294, 0.7659),
  ('wall', 'spread_width', 2.27294, 2.32958, 0.8945),
  ('wall', 'spread_width', 2.32958, 2.5523, 0.9708),
  ('wall', 'spread_width', 2.5523, 3.02558, 0.5572),
  ('wall', 'spread_width', 3.02558, 3.2111, 0.127),
  ('wall', 'spread_width', 3.2111, 20, 0.003848);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'tilt_deg', 0, 89.1037, 8.582e-05),
  ('wall', 'tilt_deg', 89.1037, 89.3029, 0.04562),
  ('wall', 'tilt_deg', 89.3029, 89.5021, 0.1868),
  ('wall', 'tilt_deg', 89.5021, 89.7012, 0.834),
  ('wall', 'tilt_deg', 89.7012, 90, 2.611);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'width', 0.01, 0.204357, 0.003601),
  ('wall', 'width', 0.204357, 0.277666, 0.01616),
  ('wall', 'width', 0.277666, 0.377275, 0.02701),
  ('wall', 'width', 0.377275, 0.512616, 0.03803),
  ('wall', 'width', 0.512616, 0.696508, 0.09766),
  ('wall', 'width', 0.696508, 0.866847, 0.1881),
  ('wall', 'width', 0.866847, 0.94637, 0.2462),
  ('wall', 'width', 0.94637, 1.25404, 0.3379),
  ('wall', 'width', 1.25404, 1.28586, 0.3341),
  ('wall', 'width', 1.28586, 1.72845, 0.3672),
  ('wall', 'width', 1.72845, 1.74715, 0.3577),
  ('wall', 'width', 1.74715, 2.36853, 0.3563),
  ('wall', 'width', 2.36853, 2.52716, 1.468),
  ('wall', 'width', 2.52716, 2.70408, 1.903),
  ('wall', 'width', 2.70408, 2.80167, 2.546),
  ('wall', 'width', 2.80167, 2.95039, 2.172),
  ('wall', 'width', 2.95039, 3.11715, 1.665),
  ('wall', 'width', 3.11715, 3.22551, 0.5663),
  ('wall', 'width', 3.22551, 12, 0.007396);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_max', -0.5, 2.12969, 0.00425),
  ('wall', 'z_max', 2.12969, 2.23991, 0.04067),
  ('wall', 'z_max', 2.23991, 2.35014, 0.1214),
  ('wall', 'z_max', 2.35014, 2.46036, 0.4149),
  ('wall', 'z_max', 2.46036, 2.47389, 3.191),
  ('wall', 'z_max', 2.47389, 2.51067, 3.008),
  ('wall', 'z_max', 2.51067, 2.57058, 1.199),
  ('wall', 'z_max', 2.57058, 2.59547, 1.037),
  ('wall', 'z_max', 2.59547, 2.68081, 1.282),
  ('wall', 'z_max', 2.68081, 2.69094, 1.442),
  ('wall', 'z_max', 2.69094, 2.74647, 1.99),
  ('wall', 'z_max', 2.74647, 2.79103, 1.727),
  ('wall', 'z_max', 2.79103, 2.8087, 1.636),
  ('wall', 'z_max', 2.8087, 2.90126, 0.9654),
  ('wall', 'z_max', 2.90126, 2.91396, 1.579),
  ('wall', 'z_max', 2.91396, 2.9951, 1.418),
  ('wall', 'z_max', 2.9951, 3.01148, 1.497),
  ('wall', 'z_max', 3.01148, 3.1016, 0.7359),
  ('wall', 'z_max', 3.1016, 3.1217, 0.7862),
  ('wall', 'z_max', 3.1217, 4, 0.002557);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_min', -0.5, -0.0413925, 0.04398),
  ('wall', 'z_min', -0.0413925, -0.0210709, 7.129),
  ('wall', 'z_min', -0.0210709, -0.013654, 20.65),
  ('wall', 'z_min', -0.013654, -0.00618587, 23.17),
  ('wall', 'z_min', -0.00618587, 0.0556191, 4.332),
  ('wall', 'z_min', 0.0556191, 0.155376, 0.2262),
  ('wall', 'z_min', 0.155376, 0.352144, 0.1775),
  ('wall', 'z_min', 0.352144, 0.548912, 0.2997),
  ('wall', 'z_min', 0.548912, 0.590021, 0.3461),
  ('wall', 'z_min', 0.590021, 0.745681, 0.3192),
  ('wall', 'z_min', 0.745681, 0.942449, 0.1015),
  ('wall', 'z_min', 0.942449, 1.13922, 0.06982),
  ('wall', 'z_min', 1.13922, 1.33599, 0.02405),
  ('wall', 'z_min', 1.33599, 1.53275, 0.02266),
  ('wall', 'z_min', 1.53275, 1.72952, 0.04446),
  ('wall', 'z_min', 1.72952, 4, 0.003977);

-- table: 75 examples
UPDATE object_class SET prior = 0.05122 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.2649, 0.6648)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.4922, 0.25)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.73, 0.031)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.3221, 0.3501)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.6795, 0.134)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1346, 0.3407)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4336, 0.3807)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.2844, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.1747, 0.3491)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7332, 0.03058)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.728, 0.03143)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'table' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'area_m2', 0.002, 0.0711429, 0.0029),
  ('table', 'area_m2', 0.0711429, 0.104359, 0.02556),
  ('table', 'area_m2', 0.104359, 0.153084, 0.02057),
  ('table', 'area_m2', 0.153084, 0.224559, 0.04354),
  ('table', 'area_m2', 0.224559, 0.329404, 0.1311),
  ('table', 'area_m2', 0.329404, 0.359585, 0.3065),
  ('table', 'area_m2', 0.359585, 0.483202, 0.3333),
  ('table', 'area_m2', 0.483202, 0.63096, 0.4613),
  ('table', 'area_m2', 0.63096, 0.708806, 0.5888),
  ('table', 'area_m2', 0.708806, 0.768026, 0.5333),
  ('table', 'area_m2', 0.768026, 1.02669, 0.396),
  ('table', 'area_m2', 1.02669, 1.16129, 0.857),
  ('table', 'area_m2', 1.16129, 1.30431, 0.9245),
  ('table', 'area_m2', 1.30431, 1.50739, 0.6791),
  ('table', 'area_m2', 1.50739, 2.23731, 0.2637),
  ('table', 'area_m2', 2.23731, 100, 0.003954);
DELETE FROM class_density WHERE class = 'table' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'aspect', 1, 1.1405, 0.7593),
  ('table', 'aspect', 1.1405, 1.30075, 0.614),
  ('table', 'aspect', 1.30075, 1.35028, 1.163),
  ('table', 'aspect', 1.35028, 1.48351, 1.14),
  ('table', 'aspect', 1.48351, 1.58072, 1.839),
  ('table', 'aspect', 1.58072, 1.69195, 1.515),
  ('table', 'aspect', 1.69195, 1.83254, 1.472),
  ('table', 'aspect', 1.83254, 1.92967, 1.772),
  ('table', 'aspect', 1.92967, 1.99562, 0.5866),
  ('table', 'aspect', 1.99562, 2.20079, 1.077),
  ('table', 'aspect', 2.20079, 2.51001, 0.5581),
  ('table', 'aspect', 2.51001, 2.86268, 0.1668),
  ('table', 'aspect', 2.86268, 3.2649, 0.05512),
  ('table', 'aspect', 3.2649, 100, 0.003594);
DELETE FROM class_density WHERE class = 'table' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'height', -0.5, 0.637686, 0.0009978),
  ('table', 'height', 0.637686, 0.655885, 0.675),
  ('table', 'height', 0.655885, 0.674085, 1.734),
  ('table', 'height', 0.674085, 0.692285, 4.781),
  ('table', 'height', 0.692285, 0.703627, 8.511),
  ('table', 'height', 0.703627, 0.710484, 9.469),
  ('table', 'height', 0.710484, 0.724814, 9.874),
  ('table', 'height', 0.724814, 0.736126, 10.38),
  ('table', 'height', 0.736126, 0.746883, 10.64),
  ('table', 'height', 0.746883, 0.756952, 10.24),
  ('table', 'height', 0.756952, 0.765083, 9.162),
  ('table', 'height', 0.765083, 0.779422, 6.982),
  ('table', 'height', 0.779422, 0.801482, 2.381),
  ('table', 'height', 0.801482, 4, 0.0009373);
DELETE FROM class_density WHERE class = 'table' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'length', 0.03, 0.55299, 0.005036),
  ('table', 'length', 0.55299, 0.668136, 0.1223),
  ('table', 'length', 0.668136, 0.80726, 0.21),
  ('table', 'length', 0.80726, 0.901302, 0.3392),
  ('table', 'length', 0.901302, 0.975352, 0.7756),
  ('table', 'length', 0.975352, 1.01052, 0.9848),
  ('table', 'length', 1.01052, 1.17845, 0.5005),
  ('table', 'length', 1.17845, 1.26897, 0.8196),
  ('table', 'length', 1.26897, 1.38692, 1.281),
  ('table', 'length', 1.38692, 1.42383, 0.6949),
  ('table', 'length', 1.42383, 1.57035, 1.002),
  ('table', 'length', 1.57035, 1.62574, 2.261),
  ('table', 'length', 1.62574, 1.72031, 0.8391),
  ('table', 'length', 1.72031, 1.80872, 1.367),
  ('table', 'length', 1.80872, 1.90624, 1.701),
  ('table', 'length', 1.90624, 2.07852, 0.8406),
  ('table', 'length', 2.07852, 2.51132, 0.1352),
  ('table', 'length', 2.51132, 3.03424, 0.1333),
  ('table', 'length', 3.03424, 30, 0.006099);
DELETE FROM class_density WHERE class = 'table' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'rectangularity', 0, 0.327386, 0.03864),
  ('table', 'rectangularity', 0.327386, 0.399198, 0.2244),
  ('table', 'rectangularity', 0.399198, 0.471011, 0.466),
  ('table', 'rectangularity', 0.471011, 0.502886, 1.457),
  ('table', 'rectangularity', 0.502886, 0.542824, 1.859),
  ('table', 'rectangularity', 0.542824, 0.560914, 2.019),
  ('table', 'rectangularity', 0.560914, 0.614636, 1.416),
  ('table', 'rectangularity', 0.614636, 0.645692, 1.405),
  ('table', 'rectangularity', 0.645692, 0.672815, 4.065),
  ('table', 'rectangularity', 0.672815, 0.686449, 3.139),
  ('table', 'rectangularity', 0.686449, 0.712416, 2.728),
  ('table', 'rectangularity', 0.712416, 0.745851, 3.102),
  ('table', 'rectangularity', 0.745851, 0.758261, 2.511),
  ('table', 'rectangularity', 0.758261, 0.786695, 2.709),
  ('table', 'rectangularity', 0.786695, 0.821415, 3.089),
  ('table', 'rectangularity', 0.821415, 0.830074, 1.591),
  ('table', 'rectangularity', 0.830074, 0.901887, 0.8799),
  ('table', 'rectangularity', 0.901887, 0.960752, 0.4625),
  ('table', 'rectangularity', 0.960752, 0.973699, 0.3654),
  ('table', 'rectangularity', 0.973699, 1, 0.3389);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_length', 0.01, 0.440775, 0.003381),
  ('table', 'spread_length', 0.440775, 0.530497, 0.1048),
  ('table', 'spread_length', 0.530497, 0.638481, 0.109),
  ('table', 'spread_length', 0.638481, 0.767885, 0.3732),
  ('table', 'spread_length', 0.767885, 0.869815, 0.8409),
  ('table', 'spread_length', 0.869815, 0.924866, 0.9336),
  ('table', 'spread_length', 0.924866, 0.985122, 0.8107),
  ('table', 'spread_length', 0.985122, 1.11313, 0.4924),
  ('table', 'spread_length', 1.11313, 1.18835, 1.172),
  ('table', 'spread_length', 1.18835, 1.25443, 1.792),
  ('table', 'spread_length', 1.25443, 1.33971, 0.9396),
  ('table', 'spread_length', 1.33971, 1.39175, 0.8241),
  ('table', 'spread_length', 1.39175, 1.50283, 1.428),
  ('table', 'spread_length', 1.50283, 1.61241, 1.359),
  ('table', 'spread_length', 1.61241, 1.94062, 0.5369),
  ('table', 'spread_length', 1.94062, 2.33564, 0.121),
  ('table', 'spread_length', 2.33564, 40, 0.003975);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_width', 0.003, 0.170022, 0.002027),
  ('table', 'spread_width', 0.170022, 0.214147, 0.07172),
  ('table', 'spread_width', 0.214147, 0.269723, 0.04776),
  ('table', 'spread_width', 0.269723, 0.339723, 0.1296),
  ('table', 'spread_width', 0.339723, 0.407727, 0.3089),
  ('table', 'spread_width', 0.407727, 0.42789, 0.3369),
  ('table', 'spread_width', 0.42789, 0.538938, 0.3238),
  ('table', 'spread_width', 0.538938, 0.565358, 0.5734),
  ('table', 'spread_width', 0.565358, 0.625793, 1.081),
  ('table', 'spread_width', 0.625793, 0.672698, 1.483),
  ('table', 'spread_width', 0.672698, 0.703896, 1.984),
  ('table', 'spread_width', 0.703896, 0.781352, 1.12),
  ('table', 'spread_width', 0.781352, 0.835875, 1.568),
  ('table', 'spread_width', 0.835875, 0.854974, 1.7),
  ('table', 'spread_width', 0.854974, 0.898755, 1.226),
  ('table', 'spread_width', 0.898755, 1.07686, 0.4484),
  ('table', 'spread_width', 1.07686, 1.35285, 0.164),
  ('table', 'spread_width', 1.35285, 20, 0.004411);
DELETE FROM class_density WHERE class = 'table' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'tilt_deg', 0, 0.126422, 1.873),
  ('table', 'tilt_deg', 0.126422, 0.242258, 1.717),
  ('table', 'tilt_deg', 0.242258, 0.400894, 1.387),
  ('table', 'tilt_deg', 0.400894, 0.659067, 0.809),
  ('table', 'tilt_deg', 0.659067, 0.823834, 0.3874),
  ('table', 'tilt_deg', 0.823834, 0.988601, 0.2207),
  ('table', 'tilt_deg', 0.988601, 1.15337, 0.1239),
  ('table', 'tilt_deg', 1.15337, 1.31813, 0.05994),
  ('table', 'tilt_deg', 1.31813, 1.4829, 0.02212),
  ('table', 'tilt_deg', 1.4829, 90, 1.42e-05);
DELETE FROM class_density WHERE class = 'table' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'width', 0.01, 0.242412, 0.003187),
  ('table', 'width', 0.242412, 0.301941, 0.05584),
  ('table', 'width', 0.301941, 0.376088, 0.02334),
  ('table', 'width', 0.376088, 0.468443, 0.1832),
  ('table', 'width', 0.468443, 0.563876, 0.275),
  ('table', 'width', 0.563876, 0.583477, 0.352),
  ('table', 'width', 0.583477, 0.726761, 0.5232),
  ('table', 'width', 0.726761, 0.818434, 0.907),
  ('table', 'width', 0.818434, 0.865299, 1.957),
  ('table', 'width', 0.865299, 0.90523, 2.334),
  ('table', 'width', 0.90523, 0.966355, 1.394),
  ('table', 'width', 0.966355, 1.03222, 1.734),
  ('table', 'width', 1.03222, 1.12753, 1.135),
  ('table', 'width', 1.12753, 1.40441, 0.3035),
  ('table', 'width', 1.40441, 1.65702, 0.2411),
  ('table', 'width', 1.65702, 1.74929, 0.1801),
  ('table', 'width', 1.74929, 12, 0.005398);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_max', -0.5, 0.640547, 0.0006919),
  ('table', 'z_max', 0.640547, 0.658802, 0.5123),
  ('table', 'z_max', 0.658802, 0.677057, 1.76),
  ('table', 'z_max', 0.677057, 0.694098, 4.746),
  ('table', 'z_max', 0.694098, 0.70911, 8.057),
  ('table', 'z_max', 0.70911, 0.719941, 9.783),
  ('table', 'z_max', 0.719941, 0.729379, 10.35),
  ('table', 'z_max', 0.729379, 0.741449, 10.46),
  ('table', 'z_max', 0.741449, 0.750075, 10.81),
  ('table', 'z_max', 0.750075, 0.758239, 10.69),
  ('table', 'z_max', 0.758239, 0.76833, 9.431),
  ('table', 'z_max', 0.76833, 0.783485, 6.695),
  ('table', 'z_max', 0.783485, 0.804839, 2.161),
  ('table', 'z_max', 0.804839, 4, 0.0008562);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_min', -0.5, 0.633437, 0.000958),
  ('table', 'z_min', 0.633437, 0.651915, 0.6441),
  ('table', 'z_min', 0.651915, 0.670392, 1.616),
  ('table', 'z_min', 0.670392, 0.688869, 4.517),
  ('table', 'z_min', 0.688869, 0.698925, 8.051),
  ('table', 'z_min', 0.698925, 0.707347, 9.022),
  ('table', 'z_min', 0.707347, 0.713667, 9.409),
  ('table', 'z_min', 0.713667, 0.723227, 9.869),
  ('table', 'z_min', 0.723227, 0.735062, 10.47),
  ('table', 'z_min', 0.735062, 0.744302, 10.62),
  ('table', 'z_min', 0.744302, 0.75571, 10.08),
  ('table', 'z_min', 0.75571, 0.762779, 9.092),
  ('table', 'z_min', 0.762779, 0.769168, 8.023),
  ('table', 'z_min', 0.769168, 0.777585, 6.402),
  ('table', 'z_min', 0.777585, 0.799734, 2.412),
  ('table', 'z_min', 0.799734, 4, 0.000958);

-- flat_screen: 59 examples
UPDATE object_class SET prior = 0.04053 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.69, 0.4602)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.4694, 0.2468)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.004, 0.04716)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.4677, 0.2723)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.7648, 0.1373)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7062, 0.2343)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.19, 0.2342)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 84.75, 3.639)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -0.9345, 0.2617)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.167, 0.07139)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7538, 0.08497)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'area_m2', 0.002, 0.0447068, 0.002567),
  ('flat_screen', 'area_m2', 0.0447068, 0.0475119, 0.07025),
  ('flat_screen', 'area_m2', 0.0475119, 0.0587371, 0.08185),
  ('flat_screen', 'area_m2', 0.0587371, 0.0771703, 0.0764),
  ('flat_screen', 'area_m2', 0.0771703, 0.101388, 0.1321),
  ('flat_screen', 'area_m2', 0.101388, 0.114162, 0.3577),
  ('flat_screen', 'area_m2', 0.114162, 0.133207, 0.5586),
  ('flat_screen', 'area_m2', 0.133207, 0.137662, 0.5569),
  ('flat_screen', 'area_m2', 0.137662, 0.170016, 0.5577),
  ('flat_screen', 'area_m2', 0.170016, 0.175011, 1.396),
  ('flat_screen', 'area_m2', 0.175011, 0.180527, 1.616),
  ('flat_screen', 'area_m2', 0.180527, 0.204616, 0.9332),
  ('flat_screen', 'area_m2', 0.204616, 0.229934, 0.9722),
  ('flat_screen', 'area_m2', 0.229934, 0.252698, 1.164),
  ('flat_screen', 'area_m2', 0.252698, 0.291683, 0.6552),
  ('flat_screen', 'area_m2', 0.291683, 0.302093, 0.4319),
  ('flat_screen', 'area_m2', 0.302093, 0.396898, 0.254),
  ('flat_screen', 'area_m2', 0.396898, 0.512995, 0.1083),
  ('flat_screen', 'area_m2', 0.512995, 100, 0.002238);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'aspect', 1, 1.01809, 0.3682),
  ('flat_screen', 'aspect', 1.01809, 1.14086, 0.4405),
  ('flat_screen', 'aspect', 1.14086, 1.22173, 0.8012),
  ('flat_screen', 'aspect', 1.22173, 1.30156, 1.478),
  ('flat_screen', 'aspect', 1.30156, 1.39638, 1.78),
  ('flat_screen', 'aspect', 1.39638, 1.48489, 1.632),
  ('flat_screen', 'aspect', 1.48489, 1.60399, 1.453),
  ('flat_screen', 'aspect', 1.60399, 1.69405, 1.825),
  ('flat_screen', 'aspect', 1.69405, 1.93261, 1.031),
  ('flat_screen', 'aspect', 1.93261, 2.10809, 1.17),
  ('flat_screen', 'aspect', 2.10809, 2.20491, 0.6276),
  ('flat_screen', 'aspect', 2.20491, 2.51549, 0.3053),
  ('flat_screen', 'aspect', 2.51549, 2.86982, 0.1717),
  ('flat_screen', 'aspect', 2.86982, 3.1902, 0.1516),
  ('flat_screen', 'aspect', 3.1902, 3.27406, 0.1226),
  ('flat_screen', 'aspect', 3.27406, 100, 0.002833);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'height', -0.5, 0.843075, 0.009983),
  ('flat_screen', 'height', 0.843075, 0.873969, 0.07421),
  ('flat_screen', 'height', 0.873969, 0.904862, 0.4781),
  ('flat_screen', 'height', 0.904862, 0.935756, 1.313),
  ('flat_screen', 'height', 0.935756, 0.955368, 3.205),
  ('flat_screen', 'height', 0.955368, 0.96665, 5.466),
  ('flat_screen', 'height', 0.96665, 0.972806, 6.968),
  ('flat_screen', 'height', 0.972806, 0.985573, 8.311),
  ('flat_screen', 'height', 0.985573, 0.995724, 8.777),
  ('flat_screen', 'height', 0.995724, 1.01034, 7.722),
  ('flat_screen', 'height', 1.01034, 1.02718, 7.212),
  ('flat_screen', 'height', 1.02718, 1.04137, 7.37),
  ('flat_screen', 'height', 1.04137, 1.05685, 5.955),
  ('flat_screen', 'height', 1.05685, 1.09022, 3.067),
  ('flat_screen', 'height', 1.09022, 1.11547, 0.9451),
  ('flat_screen', 'height', 1.11547, 1.12112, 0.4238),
  ('flat_screen', 'height', 1.12112, 4, 0.002313);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'length', 0.03, 0.356323, 0.005454),
  ('flat_screen', 'length', 0.356323, 0.371612, 0.2495),
  ('flat_screen', 'length', 0.371612, 0.410205, 0.4246),
  ('flat_screen', 'length', 0.410205, 0.449047, 0.5736),
  ('flat_screen', 'length', 0.449047, 0.472235, 0.5772),
  ('flat_screen', 'length', 0.472235, 0.529842, 0.7984),
  ('flat_screen', 'length', 0.529842, 0.543646, 2),
  ('flat_screen', 'length', 0.543646, 0.555235, 2.146),
  ('flat_screen', 'length', 0.555235, 0.595818, 1.482),
  ('flat_screen', 'length', 0.595818, 0.62512, 1.934),
  ('flat_screen', 'length', 0.62512, 0.6949, 1.247),
  ('flat_screen', 'length', 0.6949, 0.720494, 1.743),
  ('flat_screen', 'length', 0.720494, 0.747147, 1.211),
  ('flat_screen', 'length', 0.747147, 0.829446, 0.7764),
  ('flat_screen', 'length', 0.829446, 0.872314, 0.6098),
  ('flat_screen', 'length', 0.872314, 0.954872, 0.4246),
  ('flat_screen', 'length', 0.954872, 1.09927, 0.2904),
  ('flat_screen', 'length', 1.09927, 1.26549, 0.1758),
  ('flat_screen', 'length', 1.26549, 30, 0.003851);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'rectangularity', 0, 0.39996, 0.02879),
  ('flat_screen', 'rectangularity', 0.39996, 0.464677, 0.2902),
  ('flat_screen', 'rectangularity', 0.464677, 0.529393, 0.4045),
  ('flat_screen', 'rectangularity', 0.529393, 0.594109, 0.7299),
  ('flat_screen', 'rectangularity', 0.594109, 0.606336, 1.381),
  ('flat_screen', 'rectangularity', 0.606336, 0.651023, 2.371),
  ('flat_screen', 'rectangularity', 0.651023, 0.714708, 1.931),
  ('flat_screen', 'rectangularity', 0.714708, 0.723542, 2.992),
  ('flat_screen', 'rectangularity', 0.723542, 0.749867, 2.963),
  ('flat_screen', 'rectangularity', 0.749867, 0.788258, 2.164),
  ('flat_screen', 'rectangularity', 0.788258, 0.803836, 1.816),
  ('flat_screen', 'rectangularity', 0.803836, 0.852974, 1.866),
  ('flat_screen', 'rectangularity', 0.852974, 0.865416, 2.425),
  ('flat_screen', 'rectangularity', 0.865416, 0.895343, 3.387),
  ('flat_screen', 'rectangularity', 0.895343, 0.91769, 3.906),
  ('flat_screen', 'rectangularity', 0.91769, 0.950381, 2.491),
  ('flat_screen', 'rectangularity', 0.950381, 0.982407, 1.187),
  ('flat_screen', 'rectangularity', 0.982407, 1, 0.2683);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_length', 0.01, 0.305211, 0.002889),
  ('flat_screen', 'spread_length', 0.305211, 0.348219, 0.4793),
  ('flat_screen', 'spread_length', 0.348219, 0.358993, 1.041),
  ('flat_screen', 'spread_length', 0.358993, 0.397288, 0.9067),
  ('flat_screen', 'spread_length', 0.397288, 0.411573, 0.7194),
  ('flat_screen', 'spread_length', 0.411573, 0.452193, 1.195),
  ('flat_screen', 'spread_length', 0.452193, 0.492381, 1.421),
  ('flat_screen', 'spread_length', 0.492381, 0.517076, 2.219),
  ('flat_screen', 'spread_length', 0.517076, 0.530367, 3.2),
  ('flat_screen', 'spread_length', 0.530367, 0.554156, 2.503),
  ('flat_screen', 'spread_length', 0.554156, 0.590014, 1.245),
  ('flat_screen', 'spread_length', 0.590014, 0.632902, 0.7087),
  ('flat_screen', 'spread_length', 0.632902, 0.673154, 0.4333),
  ('flat_screen', 'spread_length', 0.673154, 0.76801, 0.3494),
  ('flat_screen', 'spread_length', 0.76801, 0.876232, 0.1437),
  ('flat_screen', 'spread_length', 0.876232, 0.943846, 0.1468),
  ('flat_screen', 'spread_length', 0.943846, 0.999704, 0.1439),
  ('flat_screen', 'spread_length', 0.999704, 40, 0.001664);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_width', 0.003, 0.125855, 0.002916),
  ('flat_screen', 'spread_width', 0.125855, 0.145282, 0.102),
  ('flat_screen', 'spread_width', 0.145282, 0.167707, 0.1205),
  ('flat_screen', 'spread_width', 0.167707, 0.193594, 0.1157),
  ('flat_screen', 'spread_width', 0.193594, 0.223476, 0.09598),
  ('flat_screen', 'spread_width', 0.223476, 0.255108, 0.4455),
  ('flat_screen', 'spread_width', 0.255108, 0.257971, 0.8493),
  ('flat_screen', 'spread_width', 0.257971, 0.280597, 1.428),
  ('flat_screen', 'spread_width', 0.280597, 0.294547, 2.211),
  ('flat_screen', 'spread_width', 0.294547, 0.305117, 2.204),
  ('flat_screen', 'spread_width', 0.305117, 0.323894, 1.957),
  ('flat_screen', 'spread_width', 0.323894, 0.338561, 2.149),
  ('flat_screen', 'spread_width', 0.338561, 0.343756, 1.659),
  ('flat_screen', 'spread_width', 0.343756, 0.359956, 1.886),
  ('flat_screen', 'spread_width', 0.359956, 0.373091, 2.505),
  ('flat_screen', 'spread_width', 0.373091, 0.396817, 1.393),
  ('flat_screen', 'spread_width', 0.396817, 0.458068, 0.2443),
  ('flat_screen', 'spread_width', 0.458068, 20, 0.004881);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'tilt_deg', 0, 78.2912, 0.0001504),
  ('flat_screen', 'tilt_deg', 78.2912, 78.6117, 0.0215),
  ('flat_screen', 'tilt_deg', 78.6117, 79.5922, 0.05443),
  ('flat_screen', 'tilt_deg', 79.5922, 80.0661, 0.06853),
  ('flat_screen', 'tilt_deg', 80.0661, 80.8932, 0.069),
  ('flat_screen', 'tilt_deg', 80.8932, 81.1765, 0.153),
  ('flat_screen', 'tilt_deg', 81.1765, 81.9673, 0.1334),
  ('flat_screen', 'tilt_deg', 81.9673, 82.1941, 0.08985),
  ('flat_screen', 'tilt_deg', 82.1941, 83.4951, 0.07261),
  ('flat_screen', 'tilt_deg', 83.4951, 83.6672, 0.07885),
  ('flat_screen', 'tilt_deg', 83.6672, 84.7961, 0.07084),
  ('flat_screen', 'tilt_deg', 84.7961, 85.6063, 0.0646),
  ('flat_screen', 'tilt_deg', 85.6063, 86.0971, 0.06386),
  ('flat_screen', 'tilt_deg', 86.0971, 87.398, 0.05308),
  ('flat_screen', 'tilt_deg', 87.398, 87.6175, 0.05556),
  ('flat_screen', 'tilt_deg', 87.6175, 88.699, 0.08097),
  ('flat_screen', 'tilt_deg', 88.699, 89.2074, 0.2104),
  ('flat_screen', 'tilt_deg', 89.2074, 89.7979, 0.1728),
  ('flat_screen', 'tilt_deg', 89.7979, 90, 0.09762);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'width', 0.01, 0.164901, 0.005031),
  ('flat_screen', 'width', 0.164901, 0.194701, 0.07623),
  ('flat_screen', 'width', 0.194701, 0.229885, 0.1602),
  ('flat_screen', 'width', 0.229885, 0.271427, 0.1766),
  ('flat_screen', 'width', 0.271427, 0.304055, 0.3637),
  ('flat_screen', 'width', 0.304055, 0.320477, 0.4009),
  ('flat_screen', 'width', 0.320477, 0.358148, 0.9178),
  ('flat_screen', 'width', 0.358148, 0.371584, 2.828),
  ('flat_screen', 'width', 0.371584, 0.37839, 2.721),
  ('flat_screen', 'width', 0.37839, 0.392321, 1.491),
  ('flat_screen', 'width', 0.392321, 0.419418, 1.587),
  ('flat_screen', 'width', 0.419418, 0.435229, 2.524),
  ('flat_screen', 'width', 0.435229, 0.446769, 2.742),
  ('flat_screen', 'width', 0.446769, 0.452509, 2.414),
  ('flat_screen', 'width', 0.452509, 0.471516, 2.372),
  ('flat_screen', 'width', 0.471516, 0.527505, 0.6032),
  ('flat_screen', 'width', 0.527505, 0.62283, 0.1783),
  ('flat_screen', 'width', 0.62283, 0.735381, 0.2056),
  ('flat_screen', 'width', 0.735381, 12, 0.005168);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_max', -0.5, 1.02146, 0.00602),
  ('flat_screen', 'z_max', 1.02146, 1.03687, 0.5408),
  ('flat_screen', 'z_max', 1.03687, 1.06647, 0.9391),
  ('flat_screen', 'z_max', 1.06647, 1.09437, 2.826),
  ('flat_screen', 'z_max', 1.09437, 1.11147, 5.06),
  ('flat_screen', 'z_max', 1.11147, 1.13089, 6.043),
  ('flat_screen', 'z_max', 1.13089, 1.14743, 6.241),
  ('flat_screen', 'z_max', 1.14743, 1.15648, 5.314),
  ('flat_screen', 'z_max', 1.15648, 1.1711, 5.346),
  ('flat_screen', 'z_max', 1.1711, 1.18573, 6.028),
  ('flat_screen', 'z_max', 1.18573, 1.20148, 5.558),
  ('flat_screen', 'z_max', 1.20148, 1.23035, 4.732),
  ('flat_screen', 'z_max', 1.23035, 1.24649, 2.443),
  ('flat_screen', 'z_max', 1.24649, 1.29149, 0.9169),
  ('flat_screen', 'z_max', 1.29149, 1.3365, 0.2302),
  ('flat_screen', 'z_max', 1.3365, 1.3815, 0.3258),
  ('flat_screen', 'z_max', 1.3815, 1.41455, 0.4186),
  ('flat_screen', 'z_max', 1.41455, 1.42651, 0.3548),
  ('flat_screen', 'z_max', 1.42651, 4, 0.00247);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_min', -0.5, 0.359151, 0.01639),
  ('flat_screen', 'z_min', 0.359151, 0.426511, 0.0001429),
  ('flat_screen', 'z_min', 0.426511, 0.493872, 0.002639),
  ('flat_screen', 'z_min', 0.493872, 0.561233, 0.02662),
  ('flat_screen', 'z_min', 0.561233, 0.628594, 0.147),
  ('flat_screen', 'z_min', 0.628594, 0.682833, 1.856),
  ('flat_screen', 'z_min', 0.682833, 0.695955, 5.151),
  ('flat_screen', 'z_min', 0.695955, 0.708155, 5.571),
  ('flat_screen', 'z_min', 0.708155, 0.7172, 6.186),
  ('flat_screen', 'z_min', 0.7172, 0.737998, 6.019),
  ('flat_screen', 'z_min', 0.737998, 0.752634, 7.572),
  ('flat_screen', 'z_min', 0.752634, 0.759055, 8.341),
  ('flat_screen', 'z_min', 0.759055, 0.801466, 3.88),
  ('flat_screen', 'z_min', 0.801466, 0.830677, 1.579),
  ('flat_screen', 'z_min', 0.830677, 0.869614, 1.722),
  ('flat_screen', 'z_min', 0.869614, 0.898037, 2.238),
  ('flat_screen', 'z_min', 0.898037, 0.956727, 0.699),
  ('flat_screen', 'z_min', 0.956727, 0.965398, 0.425),
  ('flat_screen', 'z_min', 0.965398, 4, 0.002072);

-- keyboard: 40 examples
UPDATE object_class SET prior = 0.05523 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.415, 0.7009)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.5536, 0.33)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7619, 0.03039)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.7238, 0.4212)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.6732, 0.1435)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.8737, 0.4085)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.609, 0.4289)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 2.059, 1.533)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.272, 0.4737)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7683, 0.03085)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7579, 0.03089)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'area_m2', 0.002, 0.0145386, 0.005961),
  ('keyboard', 'area_m2', 0.0145386, 0.0207444, 0.05957),
  ('keyboard', 'area_m2', 0.0207444, 0.0295993, 0.1352),
  ('keyboard', 'area_m2', 0.0295993, 0.0335046, 0.2017),
  ('keyboard', 'area_m2', 0.0335046, 0.042234, 0.235),
  ('keyboard', 'area_m2', 0.042234, 0.0527044, 0.2768),
  ('keyboard', 'area_m2', 0.0527044, 0.0602618, 0.2904),
  ('keyboard', 'area_m2', 0.0602618, 0.0730814, 0.4284),
  ('keyboard', 'area_m2', 0.0730814, 0.0845418, 0.6937),
  ('keyboard', 'area_m2', 0.0845418, 0.1116, 0.4432),
  ('keyboard', 'area_m2', 0.1116, 0.122688, 0.509),
  ('keyboard', 'area_m2', 0.122688, 0.13227, 0.6707),
  ('keyboard', 'area_m2', 0.13227, 0.150681, 0.8112),
  ('keyboard', 'area_m2', 0.150681, 0.175052, 0.6056),
  ('keyboard', 'area_m2', 0.175052, 0.249783, 0.2151),
  ('keyboard', 'area_m2', 0.249783, 0.313455, 0.1439),
  ('keyboard', 'area_m2', 0.313455, 0.356404, 0.09353),
  ('keyboard', 'area_m2', 0.356404, 100, 0.002887);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'aspect', 1, 1.04849, 0.7017),
  ('keyboard', 'aspect', 1.04849, 1.10609, 1.184),
  ('keyboard', 'aspect', 1.10609, 1.14266, 1.298),
  ('keyboard', 'aspect', 1.14266, 1.18891, 1.239),
  ('keyboard', 'aspect', 1.18891, 1.30568, 0.8289),
  ('keyboard', 'aspect', 1.30568, 1.4458, 0.592),
  ('keyboard', 'aspect', 1.4458, 1.49195, 0.5985),
  ('keyboard', 'aspect', 1.49195, 1.7048, 0.7478),
  ('keyboard', 'aspect', 1.7048, 1.89075, 1.035),
  ('keyboard', 'aspect', 1.89075, 1.94801, 0.8303),
  ('keyboard', 'aspect', 1.94801, 2.1996, 0.9482),
  ('keyboard', 'aspect', 2.1996, 2.49677, 1.491),
  ('keyboard', 'aspect', 2.49677, 2.90634, 0.4265),
  ('keyboard', 'aspect', 2.90634, 3.04121, 0.3418),
  ('keyboard', 'aspect', 3.04121, 3.32096, 0.2588),
  ('keyboard', 'aspect', 3.32096, 100, 0.00482);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'height', -0.5, 0.691746, 0.003),
  ('keyboard', 'height', 0.691746, 0.707375, 1.526),
  ('keyboard', 'height', 0.707375, 0.723004, 5.872),
  ('keyboard', 'height', 0.723004, 0.733721, 9.486),
  ('keyboard', 'height', 0.733721, 0.742964, 10.28),
  ('keyboard', 'height', 0.742964, 0.754261, 10.34),
  ('keyboard', 'height', 0.754261, 0.764595, 10.35),
  ('keyboard', 'height', 0.764595, 0.779899, 9.365),
  ('keyboard', 'height', 0.779899, 0.795308, 8.865),
  ('keyboard', 'height', 0.795308, 0.801147, 8.652),
  ('keyboard', 'height', 0.801147, 0.810082, 7.268),
  ('keyboard', 'height', 0.810082, 0.816776, 4.879),
  ('keyboard', 'height', 0.816776, 0.832405, 1.821),
  ('keyboard', 'height', 0.832405, 4, 0.001231);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'length', 0.03, 0.184459, 0.009152),
  ('keyboard', 'length', 0.184459, 0.195137, 0.2034),
  ('keyboard', 'length', 0.195137, 0.226249, 0.2838),
  ('keyboard', 'length', 0.226249, 0.255271, 0.2655),
  ('keyboard', 'length', 0.255271, 0.277506, 0.2275),
  ('keyboard', 'length', 0.277506, 0.340377, 0.329),
  ('keyboard', 'length', 0.340377, 0.364758, 0.4327),
  ('keyboard', 'length', 0.364758, 0.417491, 0.3839),
  ('keyboard', 'length', 0.417491, 0.464399, 0.9525),
  ('keyboard', 'length', 0.464399, 0.482256, 2.41),
  ('keyboard', 'length', 0.482256, 0.500636, 2.269),
  ('keyboard', 'length', 0.500636, 0.512075, 1.325),
  ('keyboard', 'length', 0.512075, 0.590013, 0.628),
  ('keyboard', 'length', 0.590013, 0.623578, 1.508),
  ('keyboard', 'length', 0.623578, 0.770384, 0.5952),
  ('keyboard', 'length', 0.770384, 0.80701, 0.3355),
  ('keyboard', 'length', 0.80701, 0.944918, 0.321),
  ('keyboard', 'length', 0.944918, 1.15899, 0.2012),
  ('keyboard', 'length', 1.15899, 30, 0.005287);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'rectangularity', 0, 0.3433, 0.03006),
  ('keyboard', 'rectangularity', 0.3433, 0.37262, 0.2645),
  ('keyboard', 'rectangularity', 0.37262, 0.411907, 0.3532),
  ('keyboard', 'rectangularity', 0.411907, 0.480513, 0.6869),
  ('keyboard', 'rectangularity', 0.480513, 0.49929, 2.164),
  ('keyboard', 'rectangularity', 0.49929, 0.547785, 2.216),
  ('keyboard', 'rectangularity', 0.547785, 0.606582, 1.675),
  ('keyboard', 'rectangularity', 0.606582, 0.617726, 2.63),
  ('keyboard', 'rectangularity', 0.617726, 0.647421, 2.82),
  ('keyboard', 'rectangularity', 0.647421, 0.686333, 2.663),
  ('keyboard', 'rectangularity', 0.686333, 0.737077, 2.215),
  ('keyboard', 'rectangularity', 0.737077, 0.754939, 1.879),
  ('keyboard', 'rectangularity', 0.754939, 0.79548, 2.14),
  ('keyboard', 'rectangularity', 0.79548, 0.823546, 2.111),
  ('keyboard', 'rectangularity', 0.823546, 0.867793, 1.508),
  ('keyboard', 'rectangularity', 0.867793, 0.892152, 1.273),
  ('keyboard', 'rectangularity', 0.892152, 0.921426, 1.11),
  ('keyboard', 'rectangularity', 0.921426, 0.960759, 0.6511),
  ('keyboard', 'rectangularity', 0.960759, 1, 0.2523);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_length', 0.01, 0.147426, 0.002869),
  ('keyboard', 'spread_length', 0.147426, 0.16138, 0.1659),
  ('keyboard', 'spread_length', 0.16138, 0.180543, 0.2966),
  ('keyboard', 'spread_length', 0.180543, 0.207824, 0.2876),
  ('keyboard', 'spread_length', 0.207824, 0.221099, 0.189),
  ('keyboard', 'spread_length', 0.221099, 0.270765, 0.2157),
  ('keyboard', 'spread_length', 0.270765, 0.32574, 0.4065),
  ('keyboard', 'spread_length', 0.32574, 0.406074, 0.4473),
  ('keyboard', 'spread_length', 0.406074, 0.425061, 1.409),
  ('keyboard', 'spread_length', 0.425061, 0.451883, 2.611),
  ('keyboard', 'spread_length', 0.451883, 0.474908, 2.146),
  ('keyboard', 'spread_length', 0.474908, 0.497292, 0.9775),
  ('keyboard', 'spread_length', 0.497292, 0.539085, 0.7379),
  ('keyboard', 'spread_length', 0.539085, 0.609, 0.7236),
  ('keyboard', 'spread_length', 0.609, 0.643545, 0.5077),
  ('keyboard', 'spread_length', 0.643545, 0.745801, 0.3868),
  ('keyboard', 'spread_length', 0.745801, 0.826547, 0.3242),
  ('keyboard', 'spread_length', 0.826547, 0.913333, 0.198),
  ('keyboard', 'spread_length', 0.913333, 40, 0.003334);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_width', 0.003, 0.0811903, 0.004078),
  ('keyboard', 'spread_width', 0.0811903, 0.0855814, 0.09187),
  ('keyboard', 'spread_width', 0.0855814, 0.0998351, 0.1226),
  ('keyboard', 'spread_width', 0.0998351, 0.122761, 0.2254),
  ('keyboard', 'spread_width', 0.122761, 0.133371, 0.505),
  ('keyboard', 'spread_width', 0.133371, 0.150953, 0.8619),
  ('keyboard', 'spread_width', 0.150953, 0.158644, 2.23),
  ('keyboard', 'spread_width', 0.158644, 0.16564, 1.943),
  ('keyboard', 'spread_width', 0.16564, 0.176439, 1.494),
  ('keyboard', 'spread_width', 0.176439, 0.185618, 1.109),
  ('keyboard', 'spread_width', 0.185618, 0.199707, 0.5934),
  ('keyboard', 'spread_width', 0.199707, 0.228244, 0.3121),
  ('keyboard', 'spread_width', 0.228244, 0.280658, 0.2788),
  ('keyboard', 'spread_width', 0.280658, 0.329599, 0.5335),
  ('keyboard', 'spread_width', 0.329599, 0.34511, 0.8338),
  ('keyboard', 'spread_width', 0.34511, 0.363728, 0.8109),
  ('keyboard', 'spread_width', 0.363728, 0.424362, 0.4783),
  ('keyboard', 'spread_width', 0.424362, 0.485576, 0.1618),
  ('keyboard', 'spread_width', 0.485576, 0.521813, 0.09973),
  ('keyboard', 'spread_width', 0.521813, 20, 0.002789);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'tilt_deg', 0, 0.522037, 0.2263),
  ('keyboard', 'tilt_deg', 0.522037, 0.738331, 0.2945),
  ('keyboard', 'tilt_deg', 0.738331, 0.853892, 0.3009),
  ('keyboard', 'tilt_deg', 0.853892, 1.38823, 0.2773),
  ('keyboard', 'tilt_deg', 1.38823, 1.55688, 0.3556),
  ('keyboard', 'tilt_deg', 1.55688, 1.8002, 0.3664),
  ('keyboard', 'tilt_deg', 1.8002, 2.21499, 0.2786),
  ('keyboard', 'tilt_deg', 2.21499, 2.72507, 0.2341),
  ('keyboard', 'tilt_deg', 2.72507, 2.95332, 0.1742),
  ('keyboard', 'tilt_deg', 2.95332, 3.69166, 0.07986),
  ('keyboard', 'tilt_deg', 3.69166, 4.42999, 0.06252),
  ('keyboard', 'tilt_deg', 4.42999, 4.59125, 0.066),
  ('keyboard', 'tilt_deg', 4.59125, 5.16832, 0.06649),
  ('keyboard', 'tilt_deg', 5.16832, 5.90665, 0.04358),
  ('keyboard', 'tilt_deg', 5.90665, 6.64498, 0.0193),
  ('keyboard', 'tilt_deg', 6.64498, 90, 0.0001297);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'width', 0.01, 0.102375, 0.006588),
  ('keyboard', 'width', 0.102375, 0.126446, 0.06048),
  ('keyboard', 'width', 0.126446, 0.156177, 0.2341),
  ('keyboard', 'width', 0.156177, 0.1692, 0.6968),
  ('keyboard', 'width', 0.1692, 0.189612, 0.7315),
  ('keyboard', 'width', 0.189612, 0.198701, 1.549),
  ('keyboard', 'width', 0.198701, 0.22006, 1.291),
  ('keyboard', 'width', 0.22006, 0.238254, 0.6428),
  ('keyboard', 'width', 0.238254, 0.271362, 0.4614),
  ('keyboard', 'width', 0.271362, 0.294274, 0.3313),
  ('keyboard', 'width', 0.294274, 0.363465, 0.3312),
  ('keyboard', 'width', 0.363465, 0.394314, 0.5963),
  ('keyboard', 'width', 0.394314, 0.445765, 0.8278),
  ('keyboard', 'width', 0.445765, 0.537266, 0.6662),
  ('keyboard', 'width', 0.537266, 0.55448, 0.5326),
  ('keyboard', 'width', 0.55448, 0.622442, 0.4456),
  ('keyboard', 'width', 0.622442, 0.684853, 0.1923),
  ('keyboard', 'width', 0.684853, 12, 0.003469);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_max', -0.5, 0.700362, 0.003743),
  ('keyboard', 'z_max', 0.700362, 0.716411, 1.891),
  ('keyboard', 'z_max', 0.716411, 0.722196, 5.236),
  ('keyboard', 'z_max', 0.722196, 0.731213, 8.251),
  ('keyboard', 'z_max', 0.731213, 0.737403, 10.34),
  ('keyboard', 'z_max', 0.737403, 0.744571, 10.56),
  ('keyboard', 'z_max', 0.744571, 0.763738, 9.66),
  ('keyboard', 'z_max', 0.763738, 0.769586, 9.762),
  ('keyboard', 'z_max', 0.769586, 0.780607, 9.502),
  ('keyboard', 'z_max', 0.780607, 0.787548, 9.212),
  ('keyboard', 'z_max', 0.787548, 0.796656, 9.33),
  ('keyboard', 'z_max', 0.796656, 0.806771, 8.834),
  ('keyboard', 'z_max', 0.806771, 0.812704, 7.32),
  ('keyboard', 'z_max', 0.812704, 0.823038, 5.153),
  ('keyboard', 'z_max', 0.823038, 0.828753, 3.081),
  ('keyboard', 'z_max', 0.828753, 0.844802, 1.167),
  ('keyboard', 'z_max', 0.844802, 4, 0.0007915);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_min', -0.5, 0.683975, 0.002474),
  ('keyboard', 'z_min', 0.683975, 0.700152, 1.25),
  ('keyboard', 'z_min', 0.700152, 0.716328, 4.83),
  ('keyboard', 'z_min', 0.716328, 0.730361, 8.8),
  ('keyboard', 'z_min', 0.730361, 0.741216, 10.49),
  ('keyboard', 'z_min', 0.741216, 0.74868, 10.79),
  ('keyboard', 'z_min', 0.74868, 0.759964, 10.45),
  ('keyboard', 'z_min', 0.759964, 0.777039, 9.046),
  ('keyboard', 'z_min', 0.777039, 0.790365, 8.574),
  ('keyboard', 'z_min', 0.790365, 0.797208, 8.562),
  ('keyboard', 'z_min', 0.797208, 0.807061, 7.24),
  ('keyboard', 'z_min', 0.807061, 0.813384, 4.87),
  ('keyboard', 'z_min', 0.813384, 0.829561, 1.828),
  ('keyboard', 'z_min', 0.829561, 4, 0.001206);

-- chair_seat: 47 examples
UPDATE object_class SET prior = 0.02168 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.054, 0.6217)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.2896, 0.3043)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4677, 0.03145)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7254, 0.2444)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7486, 0.1521)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7972, 0.2526)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.218, 0.4031)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 0.8371, 1.093)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.019, 0.3987)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4708, 0.03164)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4654, 0.03161)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'area_m2', 0.002, 0.0171986, 0.007658),
  ('chair_seat', 'area_m2', 0.0171986, 0.0236217, 0.006409),
  ('chair_seat', 'area_m2', 0.0236217, 0.0324437, 0.05845),
  ('chair_seat', 'area_m2', 0.0324437, 0.0445605, 0.1645),
  ('chair_seat', 'area_m2', 0.0445605, 0.0467177, 0.1787),
  ('chair_seat', 'area_m2', 0.0467177, 0.0612026, 0.1786),
  ('chair_seat', 'area_m2', 0.0612026, 0.0840599, 0.2062),
  ('chair_seat', 'area_m2', 0.0840599, 0.0919625, 0.2875),
  ('chair_seat', 'area_m2', 0.0919625, 0.115454, 0.3873),
  ('chair_seat', 'area_m2', 0.115454, 0.125615, 0.4328),
  ('chair_seat', 'area_m2', 0.125615, 0.150894, 0.6719),
  ('chair_seat', 'area_m2', 0.150894, 0.158572, 0.7135),
  ('chair_seat', 'area_m2', 0.158572, 0.173518, 0.8268),
  ('chair_seat', 'area_m2', 0.173518, 0.187711, 1.091),
  ('chair_seat', 'area_m2', 0.187711, 0.199497, 1.436),
  ('chair_seat', 'area_m2', 0.199497, 0.217795, 0.7748),
  ('chair_seat', 'area_m2', 0.217795, 0.225339, 1.081),
  ('chair_seat', 'area_m2', 0.225339, 0.287566, 0.4056),
  ('chair_seat', 'area_m2', 0.287566, 0.299135, 0.1085),
  ('chair_seat', 'area_m2', 0.299135, 100, 0.004111);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'aspect', 1, 1.05806, 1.939),
  ('chair_seat', 'aspect', 1.05806, 1.09165, 3.165),
  ('chair_seat', 'aspect', 1.09165, 1.14372, 2.645),
  ('chair_seat', 'aspect', 1.14372, 1.16498, 3.906),
  ('chair_seat', 'aspect', 1.16498, 1.24242, 1.948),
  ('chair_seat', 'aspect', 1.24242, 1.33934, 1.406),
  ('chair_seat', 'aspect', 1.33934, 1.464, 1.133),
  ('chair_seat', 'aspect', 1.464, 1.5531, 0.7887),
  ('chair_seat', 'aspect', 1.5531, 1.78569, 0.5748),
  ('chair_seat', 'aspect', 1.78569, 2.08289, 0.3369),
  ('chair_seat', 'aspect', 2.08289, 2.41212, 0.1065),
  ('chair_seat', 'aspect', 2.41212, 2.79339, 0.1633),
  ('chair_seat', 'aspect', 2.79339, 3.23493, 0.1131),
  ('chair_seat', 'aspect', 3.23493, 3.65665, 0.1432),
  ('chair_seat', 'aspect', 3.65665, 3.74626, 0.1399),
  ('chair_seat', 'aspect', 3.74626, 100, 0.002702);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'height', -0.5, 0.397381, 0.004829),
  ('chair_seat', 'height', 0.397381, 0.413164, 2.026),
  ('chair_seat', 'height', 0.413164, 0.419583, 5.404),
  ('chair_seat', 'height', 0.419583, 0.42571, 7.638),
  ('chair_seat', 'height', 0.42571, 0.434898, 9.289),
  ('chair_seat', 'height', 0.434898, 0.444235, 9.186),
  ('chair_seat', 'height', 0.444235, 0.460514, 7.977),
  ('chair_seat', 'height', 0.460514, 0.476297, 9.115),
  ('chair_seat', 'height', 0.476297, 0.485188, 10.38),
  ('chair_seat', 'height', 0.485188, 0.49208, 10.41),
  ('chair_seat', 'height', 0.49208, 0.499735, 10.21),
  ('chair_seat', 'height', 0.499735, 0.507864, 9.419),
  ('chair_seat', 'height', 0.507864, 0.517793, 6.937),
  ('chair_seat', 'height', 0.517793, 0.523647, 4.074),
  ('chair_seat', 'height', 0.523647, 0.53943, 1.424),
  ('chair_seat', 'height', 0.53943, 4, 0.0009599);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'length', 0.03, 0.208332, 0.008763),
  ('chair_seat', 'length', 0.208332, 0.242688, 0.006629),
  ('chair_seat', 'length', 0.242688, 0.282709, 0.1869),
  ('chair_seat', 'length', 0.282709, 0.329329, 0.3078),
  ('chair_seat', 'length', 0.329329, 0.383638, 0.2279),
  ('chair_seat', 'length', 0.383638, 0.387765, 0.3893),
  ('chair_seat', 'length', 0.387765, 0.446902, 0.7402),
  ('chair_seat', 'length', 0.446902, 0.483401, 1.914),
  ('chair_seat', 'length', 0.483401, 0.490793, 4.013),
  ('chair_seat', 'length', 0.490793, 0.510114, 2.975),
  ('chair_seat', 'length', 0.510114, 0.520599, 2.116),
  ('chair_seat', 'length', 0.520599, 0.535874, 2.527),
  ('chair_seat', 'length', 0.535874, 0.548, 3.277),
  ('chair_seat', 'length', 0.548, 0.583121, 1.78),
  ('chair_seat', 'length', 0.583121, 0.60645, 0.9159),
  ('chair_seat', 'length', 0.60645, 0.706457, 0.3329),
  ('chair_seat', 'length', 0.706457, 0.807863, 0.251),
  ('chair_seat', 'length', 0.807863, 0.822957, 0.2674),
  ('chair_seat', 'length', 0.822957, 30, 0.003083);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'rectangularity', 0, 0.361417, 0.03611),
  ('chair_seat', 'rectangularity', 0.361417, 0.42887, 0.3263),
  ('chair_seat', 'rectangularity', 0.42887, 0.496323, 0.6081),
  ('chair_seat', 'rectangularity', 0.496323, 0.530311, 0.9232),
  ('chair_seat', 'rectangularity', 0.530311, 0.563776, 1.11),
  ('chair_seat', 'rectangularity', 0.563776, 0.622198, 1.275),
  ('chair_seat', 'rectangularity', 0.622198, 0.631229, 1.473),
  ('chair_seat', 'rectangularity', 0.631229, 0.693722, 1.62),
  ('chair_seat', 'rectangularity', 0.693722, 0.766135, 1.443),
  ('chair_seat', 'rectangularity', 0.766135, 0.779755, 2.491),
  ('chair_seat', 'rectangularity', 0.779755, 0.807957, 3.653),
  ('chair_seat', 'rectangularity', 0.807957, 0.833588, 3.499),
  ('chair_seat', 'rectangularity', 0.833588, 0.881536, 2.427),
  ('chair_seat', 'rectangularity', 0.881536, 0.901041, 3.293),
  ('chair_seat', 'rectangularity', 0.901041, 0.942646, 2.742),
  ('chair_seat', 'rectangularity', 0.942646, 0.968494, 1.146),
  ('chair_seat', 'rectangularity', 0.968494, 1, 0.3472);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_length', 0.01, 0.146632, 0.006312),
  ('chair_seat', 'spread_length', 0.146632, 0.172193, 8.307e-05),
  ('chair_seat', 'spread_length', 0.172193, 0.20221, 0.0008758),
  ('chair_seat', 'spread_length', 0.20221, 0.237459, 0.04267),
  ('chair_seat', 'spread_length', 0.237459, 0.278853, 0.2209),
  ('chair_seat', 'spread_length', 0.278853, 0.327464, 0.3241),
  ('chair_seat', 'spread_length', 0.327464, 0.331761, 0.3765),
  ('chair_seat', 'spread_length', 0.331761, 0.384547, 0.322),
  ('chair_seat', 'spread_length', 0.384547, 0.440047, 0.9081),
  ('chair_seat', 'spread_length', 0.440047, 0.451582, 2.922),
  ('chair_seat', 'spread_length', 0.451582, 0.471462, 2.762),
  ('chair_seat', 'spread_length', 0.471462, 0.48205, 3.094),
  ('chair_seat', 'spread_length', 0.48205, 0.505619, 2.591),
  ('chair_seat', 'spread_length', 0.505619, 0.528042, 2.277),
  ('chair_seat', 'spread_length', 0.528042, 0.545284, 2.56),
  ('chair_seat', 'spread_length', 0.545284, 0.603258, 1.055),
  ('chair_seat', 'spread_length', 0.603258, 0.622746, 0.3923),
  ('chair_seat', 'spread_length', 0.622746, 40, 0.006367);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_width', 0.003, 0.0979881, 0.003812),
  ('chair_seat', 'spread_width', 0.0979881, 0.116287, 0.1224),
  ('chair_seat', 'spread_width', 0.116287, 0.138004, 0.2152),
  ('chair_seat', 'spread_width', 0.138004, 0.157518, 0.3193),
  ('chair_seat', 'spread_width', 0.157518, 0.163776, 0.355),
  ('chair_seat', 'spread_width', 0.163776, 0.194361, 0.3281),
  ('chair_seat', 'spread_width', 0.194361, 0.230658, 0.2894),
  ('chair_seat', 'spread_width', 0.230658, 0.273734, 0.3669),
  ('chair_seat', 'spread_width', 0.273734, 0.314861, 0.5896),
  ('chair_seat', 'spread_width', 0.314861, 0.324854, 1.46),
  ('chair_seat', 'spread_width', 0.324854, 0.331876, 1.858),
  ('chair_seat', 'spread_width', 0.331876, 0.356372, 1.664),
  ('chair_seat', 'spread_width', 0.356372, 0.380055, 1.541),
  ('chair_seat', 'spread_width', 0.380055, 0.38552, 1.609),
  ('chair_seat', 'spread_width', 0.38552, 0.396216, 2.268),
  ('chair_seat', 'spread_width', 0.396216, 0.412095, 2.337),
  ('chair_seat', 'spread_width', 0.412095, 0.441017, 1.373),
  ('chair_seat', 'spread_width', 0.441017, 0.457516, 0.4856),
  ('chair_seat', 'spread_width', 0.457516, 20, 0.008204);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'tilt_deg', 0, 0.20732, 0.84),
  ('chair_seat', 'tilt_deg', 0.20732, 0.329578, 0.9359),
  ('chair_seat', 'tilt_deg', 0.329578, 0.539967, 0.9474),
  ('chair_seat', 'tilt_deg', 0.539967, 0.652866, 0.8431),
  ('chair_seat', 'tilt_deg', 0.652866, 1.12931, 0.4572),
  ('chair_seat', 'tilt_deg', 1.12931, 1.69396, 0.09083),
  ('chair_seat', 'tilt_deg', 1.69396, 2.21243, 0.0588),
  ('chair_seat', 'tilt_deg', 2.21243, 2.82327, 0.06895),
  ('chair_seat', 'tilt_deg', 2.82327, 3.38792, 0.03472),
  ('chair_seat', 'tilt_deg', 3.38792, 3.95258, 0.01887),
  ('chair_seat', 'tilt_deg', 3.95258, 4.51723, 0.04658),
  ('chair_seat', 'tilt_deg', 4.51723, 5.01744, 0.02029),
  ('chair_seat', 'tilt_deg', 5.01744, 90, 9.991e-05);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'width', 0.01, 0.12715, 0.00655),
  ('chair_seat', 'width', 0.12715, 0.150149, 0.2383),
  ('chair_seat', 'width', 0.150149, 0.177308, 0.1874),
  ('chair_seat', 'width', 0.177308, 0.19455, 0.2622),
  ('chair_seat', 'width', 0.19455, 0.209379, 0.3179),
  ('chair_seat', 'width', 0.209379, 0.247251, 0.2995),
  ('chair_seat', 'width', 0.247251, 0.291974, 0.3102),
  ('chair_seat', 'width', 0.291974, 0.304645, 0.3807),
  ('chair_seat', 'width', 0.304645, 0.344786, 0.4673),
  ('chair_seat', 'width', 0.344786, 0.395954, 0.5251),
  ('chair_seat', 'width', 0.395954, 0.407151, 0.8719),
  ('chair_seat', 'width', 0.407151, 0.424503, 2.029),
  ('chair_seat', 'width', 0.424503, 0.435071, 3.128),
  ('chair_seat', 'width', 0.435071, 0.449805, 3.144),
  ('chair_seat', 'width', 0.449805, 0.465578, 2.578),
  ('chair_seat', 'width', 0.465578, 0.480796, 1.75),
  ('chair_seat', 'width', 0.480796, 0.48862, 1.785),
  ('chair_seat', 'width', 0.48862, 0.56338, 0.8205),
  ('chair_seat', 'width', 0.56338, 12, 0.01159);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_max', -0.5, 0.398675, 0.004244),
  ('chair_seat', 'z_max', 0.398675, 0.414546, 1.815),
  ('chair_seat', 'z_max', 0.414546, 0.420228, 4.781),
  ('chair_seat', 'z_max', 0.420228, 0.426612, 6.838),
  ('chair_seat', 'z_max', 0.426612, 0.439076, 8.909),
  ('chair_seat', 'z_max', 0.439076, 0.446289, 9.078),
  ('chair_seat', 'z_max', 0.446289, 0.462161, 8.065),
  ('chair_seat', 'z_max', 0.462161, 0.468217, 8.196),
  ('chair_seat', 'z_max', 0.468217, 0.478032, 9.136),
  ('chair_seat', 'z_max', 0.478032, 0.491492, 10.2),
  ('chair_seat', 'z_max', 0.491492, 0.503517, 10.44),
  ('chair_seat', 'z_max', 0.503517, 0.509775, 9.772),
  ('chair_seat', 'z_max', 0.509775, 0.519084, 7.603),
  ('chair_seat', 'z_max', 0.519084, 0.525646, 4.565),
  ('chair_seat', 'z_max', 0.525646, 0.541518, 1.538),
  ('chair_seat', 'z_max', 0.541518, 4, 0.001051);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_min', -0.5, 0.396125, 0.005536),
  ('chair_seat', 'z_min', 0.396125, 0.411903, 2.289),
  ('chair_seat', 'z_min', 0.411903, 0.418247, 5.886),
  ('chair_seat', 'z_min', 0.418247, 0.427682, 8.397),
  ('chair_seat', 'z_min', 0.427682, 0.442467, 9.156),
  ('chair_seat', 'z_min', 0.442467, 0.45924, 8.023),
  ('chair_seat', 'z_min', 0.45924, 0.474292, 9.494),
  ('chair_seat', 'z_min', 0.474292, 0.482116, 10.33),
  ('chair_seat', 'z_min', 0.482116, 0.490797, 9.971),
  ('chair_seat', 'z_min', 0.490797, 0.497552, 9.699),
  ('chair_seat', 'z_min', 0.497552, 0.504952, 9.202),
  ('chair_seat', 'z_min', 0.504952, 0.51698, 6.863),
  ('chair_seat', 'z_min', 0.51698, 0.538133, 2.023),
  ('chair_seat', 'z_min', 0.538133, 4, 0.0009269);

-- chair_back: 47 examples
UPDATE object_class SET prior = 0.02168 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.69, 0.5401)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3678, 0.2789)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8199, 0.07993)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.527, 0.2425)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7773, 0.13)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6799, 0.2423)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.129, 0.3676)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 79.92, 3.553)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9003, 0.3051)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.032, 0.09266)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4518, 0.1322)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'area_m2', 0.002, 0.0333315, 0.005092),
  ('chair_back', 'area_m2', 0.0333315, 0.045632, 0.04163),
  ('chair_back', 'area_m2', 0.045632, 0.0624718, 0.08093),
  ('chair_back', 'area_m2', 0.0624718, 0.0855261, 0.1477),
  ('chair_back', 'area_m2', 0.0855261, 0.0887265, 0.2328),
  ('chair_back', 'area_m2', 0.0887265, 0.117088, 0.2356),
  ('chair_back', 'area_m2', 0.117088, 0.155534, 0.3098),
  ('chair_back', 'area_m2', 0.155534, 0.160298, 0.418),
  ('chair_back', 'area_m2', 0.160298, 0.177467, 0.8315),
  ('chair_back', 'area_m2', 0.177467, 0.194235, 1.023),
  ('chair_back', 'area_m2', 0.194235, 0.215045, 0.9911),
  ('chair_back', 'area_m2', 0.215045, 0.219454, 1.221),
  ('chair_back', 'area_m2', 0.219454, 0.235587, 1.409),
  ('chair_back', 'area_m2', 0.235587, 0.250851, 1.457),
  ('chair_back', 'area_m2', 0.250851, 0.290951, 0.6651),
  ('chair_back', 'area_m2', 0.290951, 0.30044, 0.4789),
  ('chair_back', 'area_m2', 0.30044, 0.411314, 0.2138),
  ('chair_back', 'area_m2', 0.411314, 0.563103, 0.1107),
  ('chair_back', 'area_m2', 0.563103, 100, 0.003164);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'aspect', 1, 1.06752, 1.522),
  ('chair_back', 'aspect', 1.06752, 1.1156, 2.552),
  ('chair_back', 'aspect', 1.1156, 1.13582, 3.449),
  ('chair_back', 'aspect', 1.13582, 1.29009, 1.096),
  ('chair_back', 'aspect', 1.29009, 1.31567, 0.7038),
  ('chair_back', 'aspect', 1.31567, 1.45332, 1.122),
  ('chair_back', 'aspect', 1.45332, 1.61255, 1.172),
  ('chair_back', 'aspect', 1.61255, 1.66434, 0.7105),
  ('chair_back', 'aspect', 1.66434, 1.80949, 0.831),
  ('chair_back', 'aspect', 1.80949, 1.8904, 0.826),
  ('chair_back', 'aspect', 1.8904, 2.13795, 0.8956),
  ('chair_back', 'aspect', 2.13795, 2.4388, 0.5904),
  ('chair_back', 'aspect', 2.4388, 2.77004, 0.03428),
  ('chair_back', 'aspect', 2.77004, 3.14628, 0.01877),
  ('chair_back', 'aspect', 3.14628, 100, 0.004766);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'height', -0.5, 0.615642, 0.00967),
  ('chair_back', 'height', 0.615642, 0.626978, 0.4787),
  ('chair_back', 'height', 0.626978, 0.658915, 0.6313),
  ('chair_back', 'height', 0.658915, 0.702187, 0.7396),
  ('chair_back', 'height', 0.702187, 0.727273, 2.177),
  ('chair_back', 'height', 0.727273, 0.745459, 3.6),
  ('chair_back', 'height', 0.745459, 0.753116, 3.776),
  ('chair_back', 'height', 0.753116, 0.788731, 2.92),
  ('chair_back', 'height', 0.788731, 0.798068, 4.04),
  ('chair_back', 'height', 0.798068, 0.813934, 5.445),
  ('chair_back', 'height', 0.813934, 0.832004, 5.322),
  ('chair_back', 'height', 0.832004, 0.855333, 5.328),
  ('chair_back', 'height', 0.855333, 0.870842, 5.617),
  ('chair_back', 'height', 0.870842, 0.917291, 2.8),
  ('chair_back', 'height', 0.917291, 0.96182, 1.859),
  ('chair_back', 'height', 0.96182, 0.995849, 0.5921),
  ('chair_back', 'height', 0.995849, 1.00509, 0.4049),
  ('chair_back', 'height', 1.00509, 4, 0.003417);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'length', 0.03, 0.33466, 0.005989),
  ('chair_back', 'length', 0.33466, 0.353344, 0.2136),
  ('chair_back', 'length', 0.353344, 0.378441, 0.2744),
  ('chair_back', 'length', 0.378441, 0.427949, 0.4187),
  ('chair_back', 'length', 0.427949, 0.444986, 0.8066),
  ('chair_back', 'length', 0.444986, 0.483934, 1.033),
  ('chair_back', 'length', 0.483934, 0.536292, 1.12),
  ('chair_back', 'length', 0.536292, 0.547243, 1.373),
  ('chair_back', 'length', 0.547243, 0.571554, 1.915),
  ('chair_back', 'length', 0.571554, 0.618835, 1.52),
  ('chair_back', 'length', 0.618835, 0.661595, 1.596),
  ('chair_back', 'length', 0.661595, 0.699792, 0.8618),
  ('chair_back', 'length', 0.699792, 0.737247, 1.202),
  ('chair_back', 'length', 0.737247, 0.783653, 1.687),
  ('chair_back', 'length', 0.783653, 0.894864, 0.6708),
  ('chair_back', 'length', 0.894864, 1.01193, 0.1277),
  ('chair_back', 'length', 1.01193, 30, 0.003898);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'rectangularity', 0, 0.4439, 0.02609),
  ('chair_back', 'rectangularity', 0.4439, 0.459144, 0.2768),
  ('chair_back', 'rectangularity', 0.459144, 0.503324, 0.3341),
  ('chair_back', 'rectangularity', 0.503324, 0.562747, 0.4463),
  ('chair_back', 'rectangularity', 0.562747, 0.607808, 1.465),
  ('chair_back', 'rectangularity', 0.607808, 0.622171, 4.653),
  ('chair_back', 'rectangularity', 0.622171, 0.638048, 1.606),
  ('chair_back', 'rectangularity', 0.638048, 0.681595, 0.5456),
  ('chair_back', 'rectangularity', 0.681595, 0.741018, 1.359),
  ('chair_back', 'rectangularity', 0.741018, 0.752518, 2.423),
  ('chair_back', 'rectangularity', 0.752518, 0.786424, 3.485),
  ('chair_back', 'rectangularity', 0.786424, 0.800442, 4.226),
  ('chair_back', 'rectangularity', 0.800442, 0.817714, 2.437),
  ('chair_back', 'rectangularity', 0.817714, 0.856587, 2.691),
  ('chair_back', 'rectangularity', 0.856587, 0.881975, 4.539),
  ('chair_back', 'rectangularity', 0.881975, 0.919289, 2.419),
  ('chair_back', 'rectangularity', 0.919289, 0.955765, 2.294),
  ('chair_back', 'rectangularity', 0.955765, 0.978713, 1.327),
  ('chair_back', 'rectangularity', 0.978713, 1, 0.3987);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_length', 0.01, 0.255224, 0.00363),
  ('chair_back', 'spread_length', 0.255224, 0.297145, 0.126),
  ('chair_back', 'spread_length', 0.297145, 0.345951, 0.2706),
  ('chair_back', 'spread_length', 0.345951, 0.402525, 0.3603),
  ('chair_back', 'spread_length', 0.402525, 0.440052, 1.25),
  ('chair_back', 'spread_length', 0.440052, 0.464517, 2.12),
  ('chair_back', 'spread_length', 0.464517, 0.48726, 1.987),
  ('chair_back', 'spread_length', 0.48726, 0.521351, 1.62),
  ('chair_back', 'spread_length', 0.521351, 0.545952, 1.53),
  ('chair_back', 'spread_length', 0.545952, 0.562526, 1.442),
  ('chair_back', 'spread_length', 0.562526, 0.60324, 1.476),
  ('chair_back', 'spread_length', 0.60324, 0.635625, 1.084),
  ('chair_back', 'spread_length', 0.635625, 0.681555, 0.787),
  ('chair_back', 'spread_length', 0.681555, 0.740026, 0.9187),
  ('chair_back', 'spread_length', 0.740026, 0.861576, 0.1239),
  ('chair_back', 'spread_length', 0.861576, 1.00309, 0.01918),
  ('chair_back', 'spread_length', 1.00309, 40, 0.004592);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_width', 0.003, 0.126385, 0.003652),
  ('chair_back', 'spread_width', 0.126385, 0.130787, 0.1135),
  ('chair_back', 'spread_width', 0.130787, 0.151641, 0.1489),
  ('chair_back', 'spread_width', 0.151641, 0.181944, 0.1796),
  ('chair_back', 'spread_width', 0.181944, 0.214361, 0.4012),
  ('chair_back', 'spread_width', 0.214361, 0.218302, 0.6139),
  ('chair_back', 'spread_width', 0.218302, 0.249706, 0.669),
  ('chair_back', 'spread_width', 0.249706, 0.261926, 1.399),
  ('chair_back', 'spread_width', 0.261926, 0.274792, 0.658),
  ('chair_back', 'spread_width', 0.274792, 0.314268, 0.4912),
  ('chair_back', 'spread_width', 0.314268, 0.325817, 1.549),
  ('chair_back', 'spread_width', 0.325817, 0.369845, 0.9783),
  ('chair_back', 'spread_width', 0.369845, 0.377069, 1.164),
  ('chair_back', 'spread_width', 0.377069, 0.398636, 1.178),
  ('chair_back', 'spread_width', 0.398636, 0.446296, 0.9642),
  ('chair_back', 'spread_width', 0.446296, 0.47763, 1.347),
  ('chair_back', 'spread_width', 0.47763, 0.54283, 0.6948),
  ('chair_back', 'spread_width', 0.54283, 0.651306, 0.1241),
  ('chair_back', 'spread_width', 0.651306, 20, 0.004896);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'tilt_deg', 0, 73.3753, 0.0001896),
  ('chair_back', 'tilt_deg', 73.3753, 73.68, 0.01478),
  ('chair_back', 'tilt_deg', 73.68, 74.9616, 0.03172),
  ('chair_back', 'tilt_deg', 74.9616, 75.7834, 0.05944),
  ('chair_back', 'tilt_deg', 75.7834, 76.548, 0.06131),
  ('chair_back', 'tilt_deg', 76.548, 77.1343, 0.1265),
  ('chair_back', 'tilt_deg', 77.1343, 78.1065, 0.1151),
  ('chair_back', 'tilt_deg', 78.1065, 78.7265, 0.1508),
  ('chair_back', 'tilt_deg', 78.7265, 79.7207, 0.07953),
  ('chair_back', 'tilt_deg', 79.7207, 80.0983, 0.1143),
  ('chair_back', 'tilt_deg', 80.0983, 80.6338, 0.1718),
  ('chair_back', 'tilt_deg', 80.6338, 81.307, 0.08863),
  ('chair_back', 'tilt_deg', 81.307, 81.8997, 0.06729),
  ('chair_back', 'tilt_deg', 81.8997, 82.8933, 0.04508),
  ('chair_back', 'tilt_deg', 82.8933, 84.4797, 0.03515),
  ('chair_back', 'tilt_deg', 84.4797, 85.8145, 0.0403),
  ('chair_back', 'tilt_deg', 85.8145, 86.066, 0.05969),
  ('chair_back', 'tilt_deg', 86.066, 87.0702, 0.05947),
  ('chair_back', 'tilt_deg', 87.0702, 87.6524, 0.02756),
  ('chair_back', 'tilt_deg', 87.6524, 90, 0.002881);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'width', 0.01, 0.178383, 0.004805),
  ('chair_back', 'width', 0.178383, 0.211897, 0.1897),
  ('chair_back', 'width', 0.211897, 0.251707, 0.231),
  ('chair_back', 'width', 0.251707, 0.280094, 0.2924),
  ('chair_back', 'width', 0.280094, 0.298997, 0.4741),
  ('chair_back', 'width', 0.298997, 0.342529, 0.755),
  ('chair_back', 'width', 0.342529, 0.355171, 1.054),
  ('chair_back', 'width', 0.355171, 0.421899, 0.5389),
  ('chair_back', 'width', 0.421899, 0.42754, 2.34),
  ('chair_back', 'width', 0.42754, 0.435582, 3.673),
  ('chair_back', 'width', 0.435582, 0.441911, 4.125),
  ('chair_back', 'width', 0.441911, 0.462984, 2.759),
  ('chair_back', 'width', 0.462984, 0.477182, 2.829),
  ('chair_back', 'width', 0.477182, 0.501164, 1.907),
  ('chair_back', 'width', 0.501164, 0.511999, 0.6748),
  ('chair_back', 'width', 0.511999, 0.59532, 0.3935),
  ('chair_back', 'width', 0.59532, 0.707167, 0.2637),
  ('chair_back', 'width', 0.707167, 0.840026, 0.08798),
  ('chair_back', 'width', 0.840026, 12, 0.006433);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_max', -0.5, 0.789197, 0.009014),
  ('chair_back', 'z_max', 0.789197, 0.839175, 0.4507),
  ('chair_back', 'z_max', 0.839175, 0.889154, 0.5969),
  ('chair_back', 'z_max', 0.889154, 0.929187, 1.432),
  ('chair_back', 'z_max', 0.929187, 0.939132, 2.375),
  ('chair_back', 'z_max', 0.939132, 0.960921, 3.515),
  ('chair_back', 'z_max', 0.960921, 0.98911, 3.783),
  ('chair_back', 'z_max', 0.98911, 1.02127, 3.727),
  ('chair_back', 'z_max', 1.02127, 1.03909, 3.656),
  ('chair_back', 'z_max', 1.03909, 1.05487, 3.249),
  ('chair_back', 'z_max', 1.05487, 1.07988, 4.358),
  ('chair_back', 'z_max', 1.07988, 1.08907, 4.74),
  ('chair_back', 'z_max', 1.08907, 1.09913, 4.345),
  ('chair_back', 'z_max', 1.09913, 1.13904, 2.7),
  ('chair_back', 'z_max', 1.13904, 1.14902, 2.374),
  ('chair_back', 'z_max', 1.14902, 1.18902, 1.859),
  ('chair_back', 'z_max', 1.18902, 1.239, 0.405),
  ('chair_back', 'z_max', 1.239, 4, 0.004798);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_min', -0.5, 0.194113, 0.01744),
  ('chair_back', 'z_min', 0.194113, 0.23107, 0.5332),
  ('chair_back', 'z_min', 0.23107, 0.25816, 0.6835),
  ('chair_back', 'z_min', 0.25816, 0.312898, 1.339),
  ('chair_back', 'z_min', 0.312898, 0.353565, 3.01),
  ('chair_back', 'z_min', 0.353565, 0.370172, 4.02),
  ('chair_back', 'z_min', 0.370172, 0.386252, 3.553),
  ('chair_back', 'z_min', 0.386252, 0.401218, 3.574),
  ('chair_back', 'z_min', 0.401218, 0.434869, 3.4),
  ('chair_back', 'z_min', 0.434869, 0.450298, 1.905),
  ('chair_back', 'z_min', 0.450298, 0.509767, 1.652),
  ('chair_back', 'z_min', 0.509767, 0.574707, 1.676),
  ('chair_back', 'z_min', 0.574707, 0.622038, 1.984),
  ('chair_back', 'z_min', 0.622038, 0.642437, 1.857),
  ('chair_back', 'z_min', 0.642437, 0.706483, 1.026),
  ('chair_back', 'z_min', 0.706483, 0.74742, 0.3327),
  ('chair_back', 'z_min', 0.74742, 0.770529, 0.244),
  ('chair_back', 'z_min', 0.770529, 4, 0.002768);

-- door: 33 examples
UPDATE object_class SET prior = 0.015 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.4436, 0.3444)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.7975, 0.2554)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.168, 0.1211)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.7068, 0.1174)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8426, 0.1128)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.5155, 0.2109)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.1951, 0.2937)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.99, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.08809, 0.2748)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.121, 0.1045)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.0847, 0.1857)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'door' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'area_m2', 0.002, 0.306689, 0.004416),
  ('door', 'area_m2', 0.306689, 0.383876, 2.695e-05),
  ('door', 'area_m2', 0.383876, 0.48049, 0.0003491),
  ('door', 'area_m2', 0.48049, 0.60142, 0.003011),
  ('door', 'area_m2', 0.60142, 0.752785, 0.018),
  ('door', 'area_m2', 0.752785, 0.942246, 0.1228),
  ('door', 'area_m2', 0.942246, 1.17939, 0.332),
  ('door', 'area_m2', 1.17939, 1.24706, 0.7123),
  ('door', 'area_m2', 1.24706, 1.38292, 0.9298),
  ('door', 'area_m2', 1.38292, 1.47622, 0.7373),
  ('door', 'area_m2', 1.47622, 1.57647, 1.188),
  ('door', 'area_m2', 1.57647, 1.64488, 1.754),
  ('door', 'area_m2', 1.64488, 1.74365, 2.013),
  ('door', 'area_m2', 1.74365, 1.77876, 2.664),
  ('door', 'area_m2', 1.77876, 1.84775, 2.084),
  ('door', 'area_m2', 1.84775, 1.91186, 1.549),
  ('door', 'area_m2', 1.91186, 2.00952, 1.571),
  ('door', 'area_m2', 2.00952, 2.20176, 1.002),
  ('door', 'area_m2', 2.20176, 2.3128, 0.4827),
  ('door', 'area_m2', 2.3128, 100, 0.01013);
DELETE FROM class_density WHERE class = 'door' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'aspect', 1, 1.40084, 0.04816),
  ('door', 'aspect', 1.40084, 1.46276, 0.2519),
  ('door', 'aspect', 1.46276, 1.6567, 0.5511),
  ('door', 'aspect', 1.6567, 1.71554, 1.036),
  ('door', 'aspect', 1.71554, 1.85616, 1.197),
  ('door', 'aspect', 1.85616, 1.95931, 1.182),
  ('door', 'aspect', 1.95931, 2.06591, 1.414),
  ('door', 'aspect', 2.06591, 2.22394, 1.267),
  ('door', 'aspect', 2.22394, 2.29399, 2.718),
  ('door', 'aspect', 2.29399, 2.35067, 4.359),
  ('door', 'aspect', 2.35067, 2.40802, 3.786),
  ('door', 'aspect', 2.40802, 2.55523, 1.688),
  ('door', 'aspect', 2.55523, 2.74042, 0.8302),
  ('door', 'aspect', 2.74042, 3.24096, 0.2294),
  ('door', 'aspect', 3.24096, 3.83293, 0.1271),
  ('door', 'aspect', 3.83293, 4.53303, 0.1059),
  ('door', 'aspect', 4.53303, 5.361, 0.008621),
  ('door', 'aspect', 5.361, 6.3402, 0.007233),
  ('door', 'aspect', 6.3402, 100, 0.007643);
DELETE FROM class_density WHERE class = 'door' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'height', -0.5, 1.00806, 0.01765),
  ('door', 'height', 1.00806, 1.02734, 1.271),
  ('door', 'height', 1.02734, 1.05018, 4.44),
  ('door', 'height', 1.05018, 1.05795, 6.938),
  ('door', 'height', 1.05795, 1.07592, 5.625),
  ('door', 'height', 1.07592, 1.10045, 2.626),
  ('door', 'height', 1.10045, 1.11483, 3.15),
  ('door', 'height', 1.11483, 1.14051, 3.906),
  ('door', 'height', 1.14051, 1.14664, 2.803),
  ('door', 'height', 1.14664, 1.19283, 2.014),
  ('door', 'height', 1.19283, 1.20963, 1.824),
  ('door', 'height', 1.20963, 1.23902, 1.765),
  ('door', 'height', 1.23902, 1.28522, 1.662),
  ('door', 'height', 1.28522, 1.33141, 1.622),
  ('door', 'height', 1.33141, 1.34869, 1.679),
  ('door', 'height', 1.34869, 1.3776, 1.584),
  ('door', 'height', 1.3776, 1.40269, 1.24),
  ('door', 'height', 1.40269, 1.4238, 0.8171),
  ('door', 'height', 1.4238, 4, 0.005766);
DELETE FROM class_density WHERE class = 'door' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'length', 0.03, 1.46156, 0.002362),
  ('door', 'length', 1.46156, 1.54363, 0.3766),
  ('door', 'length', 1.54363, 1.6303, 0.9671),
  ('door', 'length', 1.6303, 1.65174, 1.104),
  ('door', 'length', 1.65174, 1.72184, 1.007),
  ('door', 'length', 1.72184, 1.81852, 0.7539),
  ('door', 'length', 1.81852, 1.92063, 0.7726),
  ('door', 'length', 1.92063, 2.01482, 2.482),
  ('door', 'length', 2.01482, 2.05765, 5.502),
  ('door', 'length', 2.05765, 2.09569, 5.417),
  ('door', 'length', 2.09569, 2.14237, 4.501),
  ('door', 'length', 2.14237, 2.19285, 4.084),
  ('door', 'length', 2.19285, 2.26267, 3.342),
  ('door', 'length', 2.26267, 2.31008, 3.178),
  ('door', 'length', 2.31008, 2.38971, 1.648),
  ('door', 'length', 2.38971, 30, 0.009155);
DELETE FROM class_density WHERE class = 'door' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'rectangularity', 0, 0.598361, 0.01181),
  ('door', 'rectangularity', 0.598361, 0.61736, 1.03),
  ('door', 'rectangularity', 0.61736, 0.642848, 2.377),
  ('door', 'rectangularity', 0.642848, 0.687335, 1.214),
  ('door', 'rectangularity', 0.687335, 0.731822, 0.7432),
  ('door', 'rectangularity', 0.731822, 0.77631, 1.426),
  ('door', 'rectangularity', 0.77631, 0.786428, 2.525),
  ('door', 'rectangularity', 0.786428, 0.813977, 2.989),
  ('door', 'rectangularity', 0.813977, 0.820797, 2.842),
  ('door', 'rectangularity', 0.820797, 0.850277, 3.581),
  ('door', 'rectangularity', 0.850277, 0.865284, 4.029),
  ('door', 'rectangularity', 0.865284, 0.877122, 3.644),
  ('door', 'rectangularity', 0.877122, 0.893506, 5.141),
  ('door', 'rectangularity', 0.893506, 0.909772, 3.047),
  ('door', 'rectangularity', 0.909772, 0.949589, 1.866),
  ('door', 'rectangularity', 0.949589, 0.968689, 6.108),
  ('door', 'rectangularity', 0.968689, 0.976947, 8.836),
  ('door', 'rectangularity', 0.976947, 1, 1.22);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_length', 0.01, 0.936006, 0.003097),
  ('door', 'spread_length', 0.936006, 1.02567, 0.1496),
  ('door', 'spread_length', 1.02567, 1.12393, 0.2926),
  ('door', 'spread_length', 1.12393, 1.23159, 0.5151),
  ('door', 'spread_length', 1.23159, 1.34957, 0.8191),
  ('door', 'spread_length', 1.34957, 1.41172, 0.9503),
  ('door', 'spread_length', 1.41172, 1.47885, 0.8636),
  ('door', 'spread_length', 1.47885, 1.61057, 1.262),
  ('door', 'spread_length', 1.61057, 1.68147, 2.142),
  ('door', 'spread_length', 1.68147, 1.77576, 0.9763),
  ('door', 'spread_length', 1.77576, 1.91274, 1.352),
  ('door', 'spread_length', 1.91274, 1.94587, 2.851),
  ('door', 'spread_length', 1.94587, 1.97561, 4.149),
  ('door', 'spread_length', 1.97561, 2.00745, 5.082),
  ('door', 'spread_length', 2.00745, 2.04656, 4.636),
  ('door', 'spread_length', 2.04656, 2.13227, 1.687),
  ('door', 'spread_length', 2.13227, 40, 0.01194);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_width', 0.003, 0.22643, 0.00514),
  ('door', 'spread_width', 0.22643, 0.275097, 0.0001237),
  ('door', 'spread_width', 0.275097, 0.334223, 0.00135),
  ('door', 'spread_width', 0.334223, 0.406057, 0.03538),
  ('door', 'spread_width', 0.406057, 0.493331, 0.1354),
  ('door', 'spread_width', 0.493331, 0.599362, 0.2468),
  ('door', 'spread_width', 0.599362, 0.728182, 0.2991),
  ('door', 'spread_width', 0.728182, 0.764439, 0.7302),
  ('door', 'spread_width', 0.764439, 0.80938, 2.109),
  ('door', 'spread_width', 0.80938, 0.819838, 3.8),
  ('door', 'spread_width', 0.819838, 0.839559, 3.69),
  ('door', 'spread_width', 0.839559, 0.872194, 2.9),
  ('door', 'spread_width', 0.872194, 0.884689, 2.751),
  ('door', 'spread_width', 0.884689, 0.897862, 2.376),
  ('door', 'spread_width', 0.897862, 0.939225, 2.454),
  ('door', 'spread_width', 0.939225, 0.956043, 2.978),
  ('door', 'spread_width', 0.956043, 1.07483, 0.7315),
  ('door', 'spread_width', 1.07483, 1.29814, 0.4462),
  ('door', 'spread_width', 1.29814, 20, 0.009993);
DELETE FROM class_density WHERE class = 'door' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'tilt_deg', 0, 89.5109, 0.001073),
  ('door', 'tilt_deg', 89.5109, 89.6739, 0.8448),
  ('door', 'tilt_deg', 89.6739, 89.837, 1.852),
  ('door', 'tilt_deg', 89.837, 90, 2.847);
DELETE FROM class_density WHERE class = 'door' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'width', 0.01, 0.26855, 0.006754),
  ('door', 'width', 0.26855, 0.325527, 0.0001108),
  ('door', 'width', 0.325527, 0.394593, 0.001403),
  ('door', 'width', 0.394593, 0.478311, 0.01124),
  ('door', 'width', 0.478311, 0.579792, 0.1691),
  ('door', 'width', 0.579792, 0.702804, 0.1663),
  ('door', 'width', 0.702804, 0.828702, 0.5808),
  ('door', 'width', 0.828702, 0.851915, 1.534),
  ('door', 'width', 0.851915, 0.872431, 2.295),
  ('door', 'width', 0.872431, 0.896034, 3.657),
  ('door', 'width', 0.896034, 0.909163, 3.882),
  ('door', 'width', 0.909163, 0.951653, 2.847),
  ('door', 'width', 0.951653, 0.972141, 3.712),
  ('door', 'width', 0.972141, 0.995889, 3.28),
  ('door', 'width', 0.995889, 1.03266, 1.633),
  ('door', 'width', 1.03266, 1.14496, 0.6917),
  ('door', 'width', 1.14496, 1.25176, 0.6662),
  ('door', 'width', 1.25176, 1.49967, 0.3574),
  ('door', 'width', 1.49967, 1.51734, 0.3452),
  ('door', 'width', 1.51734, 12, 0.008267);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_max', -0.5, 1.86661, 0.006549),
  ('door', 'z_max', 1.86661, 1.91741, 0.2308),
  ('door', 'z_max', 1.91741, 1.9682, 0.4345),
  ('door', 'z_max', 1.9682, 2.019, 1.832),
  ('door', 'z_max', 2.019, 2.03559, 4.913),
  ('door', 'z_max', 2.03559, 2.05093, 4.871),
  ('door', 'z_max', 2.05093, 2.0698, 3),
  ('door', 'z_max', 2.0698, 2.09018, 3.698),
  ('door', 'z_max', 2.09018, 2.12059, 3.435),
  ('door', 'z_max', 2.12059, 2.1589, 3.06),
  ('door', 'z_max', 2.1589, 2.17139, 2.634),
  ('door', 'z_max', 2.17139, 2.22219, 1.794),
  ('door', 'z_max', 2.22219, 2.23918, 2.202),
  ('door', 'z_max', 2.23918, 2.25904, 3.329),
  ('door', 'z_max', 2.25904, 2.27298, 2.519),
  ('door', 'z_max', 2.27298, 2.298, 1.768),
  ('door', 'z_max', 2.298, 2.32378, 1.043),
  ('door', 'z_max', 2.32378, 4, 0.008315);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_min', -0.5, -0.0366182, 0.1519),
  ('door', 'z_min', -0.0366182, -0.0156686, 4.039),
  ('door', 'z_min', -0.0156686, -0.00773114, 12.73),
  ('door', 'z_min', -0.00773114, 0.00305093, 17.13),
  ('door', 'z_min', 0.00305093, 0.0120441, 14.76),
  ('door', 'z_min', 0.0120441, 0.0382214, 4.261),
  ('door', 'z_min', 0.0382214, 0.113061, 0.8629),
  ('door', 'z_min', 0.113061, 0.1879, 0.535),
  ('door', 'z_min', 0.1879, 0.26274, 0.4361),
  ('door', 'z_min', 0.26274, 0.337579, 0.5826),
  ('door', 'z_min', 0.337579, 0.405393, 0.4997),
  ('door', 'z_min', 0.405393, 0.412419, 0.1903),
  ('door', 'z_min', 0.412419, 0.487259, 0.4072),
  ('door', 'z_min', 0.487259, 0.562098, 0.5958),
  ('door', 'z_min', 0.562098, 0.636938, 0.05084),
  ('door', 'z_min', 0.636938, 4, 0.005977);

-- window: 45 examples
UPDATE object_class SET prior = 0.02049 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', 0.1894, 0.4327)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.2548, 0.2255)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.557, 0.135)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.2788, 0.1617)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.9025, 0.1033)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.3442, 0.2046)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', 0.01682, 0.3348)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.55, 0.5826)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', 0.02256, 0.2703)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.179, 0.152)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 0.9491, 0.171)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'window' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'area_m2', 0.002, 0.310654, 0.002613),
  ('window', 'area_m2', 0.310654, 0.386759, 0.0549),
  ('window', 'area_m2', 0.386759, 0.481509, 0.08838),
  ('window', 'area_m2', 0.481509, 0.59947, 0.141),
  ('window', 'area_m2', 0.59947, 0.745261, 0.1941),
  ('window', 'area_m2', 0.745261, 0.929169, 0.4674),
  ('window', 'area_m2', 0.929169, 0.957741, 1.231),
  ('window', 'area_m2', 0.957741, 1.03651, 1.172),
  ('window', 'area_m2', 1.03651, 1.1568, 0.8072),
  ('window', 'area_m2', 1.1568, 1.4402, 0.5797),
  ('window', 'area_m2', 1.4402, 1.56344, 1.483),
  ('window', 'area_m2', 1.56344, 1.68458, 1.085),
  ('window', 'area_m2', 1.68458, 1.79302, 0.6101),
  ('window', 'area_m2', 1.79302, 1.93836, 0.9712),
  ('window', 'area_m2', 1.93836, 2.11313, 0.9631),
  ('window', 'area_m2', 2.11313, 2.23228, 0.2837),
  ('window', 'area_m2', 2.23228, 100, 0.00484);
DELETE FROM class_density WHERE class = 'window' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'aspect', 1, 1.03405, 2.981),
  ('window', 'aspect', 1.03405, 1.0862, 2.309),
  ('window', 'aspect', 1.0862, 1.11928, 3.175),
  ('window', 'aspect', 1.11928, 1.13185, 3.761),
  ('window', 'aspect', 1.13185, 1.17458, 2.076),
  ('window', 'aspect', 1.17458, 1.25887, 1.355),
  ('window', 'aspect', 1.25887, 1.28109, 1.237),
  ('window', 'aspect', 1.28109, 1.36946, 1.61),
  ('window', 'aspect', 1.36946, 1.43223, 2.146),
  ('window', 'aspect', 1.43223, 1.45001, 1.709),
  ('window', 'aspect', 1.45001, 1.6412, 0.8101),
  ('window', 'aspect', 1.6412, 1.68992, 0.5932),
  ('window', 'aspect', 1.68992, 1.8576, 0.4652),
  ('window', 'aspect', 1.8576, 2.10253, 0.2849),
  ('window', 'aspect', 2.10253, 2.37975, 0.1193),
  ('window', 'aspect', 2.37975, 2.69353, 0.02182),
  ('window', 'aspect', 2.69353, 3.04868, 0.002316),
  ('window', 'aspect', 3.04868, 100, 0.004994);
DELETE FROM class_density WHERE class = 'window' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'height', -0.5, 1.35069, 0.01038),
  ('window', 'height', 1.35069, 1.36397, 0.5032),
  ('window', 'height', 1.36397, 1.42213, 1.901),
  ('window', 'height', 1.42213, 1.44327, 4.244),
  ('window', 'height', 1.44327, 1.45819, 5.014),
  ('window', 'height', 1.45819, 1.49379, 3.096),
  ('window', 'height', 1.49379, 1.50473, 1.811),
  ('window', 'height', 1.50473, 1.56533, 1.51),
  ('window', 'height', 1.56533, 1.58381, 2.439),
  ('window', 'height', 1.58381, 1.6099, 3.4),
  ('window', 'height', 1.6099, 1.63688, 2.562),
  ('window', 'height', 1.63688, 1.64965, 2.972),
  ('window', 'height', 1.64965, 1.67747, 3.438),
  ('window', 'height', 1.67747, 1.70843, 1.339),
  ('window', 'height', 1.70843, 1.77997, 0.594),
  ('window', 'height', 1.77997, 1.85152, 0.2865),
  ('window', 'height', 1.85152, 1.92307, 0.1671),
  ('window', 'height', 1.92307, 1.99462, 0.1708),
  ('window', 'height', 1.99462, 4, 0.006197);
DELETE FROM class_density WHERE class = 'window' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'length', 0.03, 0.890975, 0.003302),
  ('window', 'length', 0.890975, 0.917697, 0.2216),
  ('window', 'length', 0.917697, 0.957286, 0.2695),
  ('window', 'length', 0.957286, 1.02853, 0.5318),
  ('window', 'length', 1.02853, 1.05652, 1.151),
  ('window', 'length', 1.05652, 1.10508, 1.747),
  ('window', 'length', 1.10508, 1.1164, 2.209),
  ('window', 'length', 1.1164, 1.18733, 1.382),
  ('window', 'length', 1.18733, 1.25164, 1.148),
  ('window', 'length', 1.25164, 1.2757, 1.628),
  ('window', 'length', 1.2757, 1.32613, 2.092),
  ('window', 'length', 1.32613, 1.37064, 2.14),
  ('window', 'length', 1.37064, 1.40567, 1.816),
  ('window', 'length', 1.40567, 1.47265, 1.926),
  ('window', 'length', 1.47265, 1.48831, 3.499),
  ('window', 'length', 1.48831, 1.51288, 3.916),
  ('window', 'length', 1.51288, 1.5819, 2.547),
  ('window', 'length', 1.5819, 1.63674, 2.108),
  ('window', 'length', 1.63674, 1.70001, 0.9744),
  ('window', 'length', 1.70001, 30, 0.004636);
DELETE FROM class_density WHERE class = 'window' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'rectangularity', 0, 0.570183, 0.02097),
  ('window', 'rectangularity', 0.570183, 0.617941, 0.418),
  ('window', 'rectangularity', 0.617941, 0.665698, 0.4332),
  ('window', 'rectangularity', 0.665698, 0.713456, 0.4363),
  ('window', 'rectangularity', 0.713456, 0.761213, 0.7127),
  ('window', 'rectangularity', 0.761213, 0.767693, 0.8393),
  ('window', 'rectangularity', 0.767693, 0.80897, 0.9338),
  ('window', 'rectangularity', 0.80897, 0.856728, 1.82),
  ('window', 'rectangularity', 0.856728, 0.862246, 3.241),
  ('window', 'rectangularity', 0.862246, 0.898977, 3.177),
  ('window', 'rectangularity', 0.898977, 0.904485, 2.639),
  ('window', 'rectangularity', 0.904485, 0.936005, 3.329),
  ('window', 'rectangularity', 0.936005, 0.952243, 4.815),
  ('window', 'rectangularity', 0.952243, 0.957051, 4.439),
  ('window', 'rectangularity', 0.957051, 0.969415, 9.347),
  ('window', 'rectangularity', 0.969415, 0.9739, 20.67),
  ('window', 'rectangularity', 0.9739, 0.985758, 14.18),
  ('window', 'rectangularity', 0.985758, 1, 2.219);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_length', 0.01, 0.776101, 0.002486),
  ('window', 'spread_length', 0.776101, 0.78892, 0.1552),
  ('window', 'spread_length', 0.78892, 0.861036, 0.2001),
  ('window', 'spread_length', 0.861036, 0.955266, 0.2262),
  ('window', 'spread_length', 0.955266, 1.05981, 0.2634),
  ('window', 'spread_length', 1.05981, 1.13715, 0.6972),
  ('window', 'spread_length', 1.13715, 1.17579, 1.636),
  ('window', 'spread_length', 1.17579, 1.19641, 1.712),
  ('window', 'spread_length', 1.19641, 1.30447, 1.236),
  ('window', 'spread_length', 1.30447, 1.33353, 1.542),
  ('window', 'spread_length', 1.33353, 1.43562, 1.511),
  ('window', 'spread_length', 1.43562, 1.52215, 1.831),
  ('window', 'spread_length', 1.52215, 1.59218, 2.159),
  ('window', 'spread_length', 1.59218, 1.65568, 2.326),
  ('window', 'spread_length', 1.65568, 1.75917, 1.952),
  ('window', 'spread_length', 1.75917, 1.90791, 1.156),
  ('window', 'spread_length', 1.90791, 1.97627, 0.3161),
  ('window', 'spread_length', 1.97627, 40, 0.00463);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_width', 0.003, 0.329969, 0.003368),
  ('window', 'spread_width', 0.329969, 0.396536, 0.0238),
  ('window', 'spread_width', 0.396536, 0.476533, 0.1104),
  ('window', 'spread_width', 0.476533, 0.572667, 0.2144),
  ('window', 'spread_width', 0.572667, 0.684433, 0.2482),
  ('window', 'spread_width', 0.684433, 0.82703, 0.3326),
  ('window', 'spread_width', 0.82703, 0.904355, 0.8228),
  ('window', 'spread_width', 0.904355, 0.975296, 1.416),
  ('window', 'spread_width', 0.975296, 0.993873, 1.138),
  ('window', 'spread_width', 0.993873, 1.05593, 1.295),
  ('window', 'spread_width', 1.05593, 1.11626, 1.675),
  ('window', 'spread_width', 1.11626, 1.19437, 1.498),
  ('window', 'spread_width', 1.19437, 1.29162, 1.346),
  ('window', 'spread_width', 1.29162, 1.38416, 1.307),
  ('window', 'spread_width', 1.38416, 1.43532, 1.058),
  ('window', 'spread_width', 1.43532, 1.64627, 0.5316),
  ('window', 'spread_width', 1.64627, 1.72488, 0.2435),
  ('window', 'spread_width', 1.72488, 20, 0.008022);
DELETE FROM class_density WHERE class = 'window' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'tilt_deg', 0, 87.6831, 1.335e-05),
  ('window', 'tilt_deg', 87.6831, 87.9405, 0.03149),
  ('window', 'tilt_deg', 87.9405, 88.0684, 0.07707),
  ('window', 'tilt_deg', 88.0684, 88.1979, 0.1112),
  ('window', 'tilt_deg', 88.1979, 88.4554, 0.1524),
  ('window', 'tilt_deg', 88.4554, 88.6625, 0.2054),
  ('window', 'tilt_deg', 88.6625, 88.9703, 0.253),
  ('window', 'tilt_deg', 88.9703, 89.1193, 0.2737),
  ('window', 'tilt_deg', 89.1193, 89.4851, 0.3562),
  ('window', 'tilt_deg', 89.4851, 89.6128, 0.6247),
  ('window', 'tilt_deg', 89.6128, 89.7426, 0.9933),
  ('window', 'tilt_deg', 89.7426, 89.8696, 1.474),
  ('window', 'tilt_deg', 89.8696, 90, 1.839);
DELETE FROM class_density WHERE class = 'window' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'width', 0.01, 0.390534, 0.004254),
  ('window', 'width', 0.390534, 0.455, 0.02531),
  ('window', 'width', 0.455, 0.530107, 0.09144),
  ('window', 'width', 0.530107, 0.617612, 0.1856),
  ('window', 'width', 0.617612, 0.719562, 0.2008),
  ('window', 'width', 0.719562, 0.80776, 0.4343),
  ('window', 'width', 0.80776, 0.83834, 0.8816),
  ('window', 'width', 0.83834, 0.88825, 1.008),
  ('window', 'width', 0.88825, 0.957775, 1.35),
  ('window', 'width', 0.957775, 0.976726, 1.508),
  ('window', 'width', 0.976726, 1.04139, 1.563),
  ('window', 'width', 1.04139, 1.08331, 2.446),
  ('window', 'width', 1.08331, 1.13795, 1.23),
  ('window', 'width', 1.13795, 1.19802, 0.9874),
  ('window', 'width', 1.19802, 1.28183, 1.826),
  ('window', 'width', 1.28183, 1.3258, 2.71),
  ('window', 'width', 1.3258, 1.45541, 0.7085),
  ('window', 'width', 1.45541, 1.54465, 0.4222),
  ('window', 'width', 1.54465, 12, 0.01017);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_max', -0.5, 1.90612, 0.003227),
  ('window', 'z_max', 1.90612, 1.93531, 0.904),
  ('window', 'z_max', 1.93531, 1.95692, 2.942),
  ('window', 'z_max', 1.95692, 1.96486, 2.542),
  ('window', 'z_max', 1.96486, 2.02359, 1.161),
  ('window', 'z_max', 2.02359, 2.05869, 1.496),
  ('window', 'z_max', 2.05869, 2.08233, 2.493),
  ('window', 'z_max', 2.08233, 2.14106, 1.998),
  ('window', 'z_max', 2.14106, 2.1538, 2.463),
  ('window', 'z_max', 2.1538, 2.19979, 1.968),
  ('window', 'z_max', 2.19979, 2.21197, 1.576),
  ('window', 'z_max', 2.21197, 2.25853, 2.149),
  ('window', 'z_max', 2.25853, 2.31726, 2.025),
  ('window', 'z_max', 2.31726, 2.33638, 1.192),
  ('window', 'z_max', 2.33638, 2.376, 1.892),
  ('window', 'z_max', 2.376, 2.4053, 2.845),
  ('window', 'z_max', 2.4053, 2.43473, 1.138),
  ('window', 'z_max', 2.43473, 4, 0.006658);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_min', -0.5, 0.794361, 0.03062),
  ('window', 'z_min', 0.794361, 0.815782, 1.86),
  ('window', 'z_min', 0.815782, 0.829545, 4.644),
  ('window', 'z_min', 0.829545, 0.856034, 4.469),
  ('window', 'z_min', 0.856034, 0.864569, 4.668),
  ('window', 'z_min', 0.864569, 0.892766, 3.418),
  ('window', 'z_min', 0.892766, 0.907361, 3.979),
  ('window', 'z_min', 0.907361, 0.920065, 4.822),
  ('window', 'z_min', 0.920065, 0.956869, 3.624),
  ('window', 'z_min', 0.956869, 0.969581, 5.22),
  ('window', 'z_min', 0.969581, 0.985331, 4.92),
  ('window', 'z_min', 0.985331, 0.991171, 3.839),
  ('window', 'z_min', 0.991171, 1.08958, 0.7193),
  ('window', 'z_min', 1.08958, 1.18798, 0.4202),
  ('window', 'z_min', 1.18798, 1.28639, 0.1343),
  ('window', 'z_min', 1.28639, 1.38479, 0.1537),
  ('window', 'z_min', 1.38479, 1.4832, 0.08094),
  ('window', 'z_min', 1.4832, 1.5816, 0.1533),
  ('window', 'z_min', 1.5816, 1.68001, 0.02306),
  ('window', 'z_min', 1.68001, 4, 0.007424);

-- whiteboard: 23 examples
UPDATE object_class SET prior = 0.01039 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.564, 0.9165)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.3061, 0.2354)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.471, 0.1086)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.5809, 0.4672)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.7607, 0.1158)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.4207, 0.3907)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.001492, 0.4299)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.89, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', 0.2717, 0.4919)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 2.24, 0.3733)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.6705, 0.375)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'area_m2', 0.002, 0.23601, 0.003541),
  ('whiteboard', 'area_m2', 0.23601, 0.26704, 0.06248),
  ('whiteboard', 'area_m2', 0.26704, 0.366651, 0.08116),
  ('whiteboard', 'area_m2', 0.366651, 0.569607, 0.09079),
  ('whiteboard', 'area_m2', 0.569607, 0.823778, 0.1997),
  ('whiteboard', 'area_m2', 0.823778, 0.884908, 0.5817),
  ('whiteboard', 'area_m2', 0.884908, 0.940819, 0.4795),
  ('whiteboard', 'area_m2', 0.940819, 1.19125, 0.4552),
  ('whiteboard', 'area_m2', 1.19125, 1.37474, 0.629),
  ('whiteboard', 'area_m2', 1.37474, 1.73268, 0.4663),
  ('whiteboard', 'area_m2', 1.73268, 2.09368, 0.4954),
  ('whiteboard', 'area_m2', 2.09368, 3.31793, 0.278),
  ('whiteboard', 'area_m2', 3.31793, 5.15453, 0.1706),
  ('whiteboard', 'area_m2', 5.15453, 6.51959, 0.2317),
  ('whiteboard', 'area_m2', 6.51959, 8.00778, 0.2224),
  ('whiteboard', 'area_m2', 8.00778, 10.8693, 0.1265),
  ('whiteboard', 'area_m2', 10.8693, 12.4404, 0.06421),
  ('whiteboard', 'area_m2', 12.4404, 100, 0.007259);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'aspect', 1, 1.04266, 2.4),
  ('whiteboard', 'aspect', 1.04266, 1.08916, 2.147),
  ('whiteboard', 'aspect', 1.08916, 1.10791, 1.676),
  ('whiteboard', 'aspect', 1.10791, 1.19609, 1.179),
  ('whiteboard', 'aspect', 1.19609, 1.22747, 1.26),
  ('whiteboard', 'aspect', 1.22747, 1.25507, 3.369),
  ('whiteboard', 'aspect', 1.25507, 1.296, 2.731),
  ('whiteboard', 'aspect', 1.296, 1.35994, 1.191),
  ('whiteboard', 'aspect', 1.35994, 1.50669, 0.7281),
  ('whiteboard', 'aspect', 1.50669, 1.55625, 1.559),
  ('whiteboard', 'aspect', 1.55625, 1.63134, 1.855),
  ('whiteboard', 'aspect', 1.63134, 1.66929, 1.491),
  ('whiteboard', 'aspect', 1.66929, 1.82804, 0.8321),
  ('whiteboard', 'aspect', 1.82804, 2.04901, 0.5596),
  ('whiteboard', 'aspect', 2.04901, 2.27013, 0.1869),
  ('whiteboard', 'aspect', 2.27013, 2.51511, 0.1207),
  ('whiteboard', 'aspect', 2.51511, 100, 0.004592);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'height', -0.5, 1.18379, 0.007602),
  ('whiteboard', 'height', 1.18379, 1.1994, 0.3926),
  ('whiteboard', 'height', 1.1994, 1.23567, 0.5082),
  ('whiteboard', 'height', 1.23567, 1.28756, 0.6619),
  ('whiteboard', 'height', 1.28756, 1.33945, 1.051),
  ('whiteboard', 'height', 1.33945, 1.39134, 1.559),
  ('whiteboard', 'height', 1.39134, 1.40933, 1.96),
  ('whiteboard', 'height', 1.40933, 1.44322, 2.755),
  ('whiteboard', 'height', 1.44322, 1.48024, 4.013),
  ('whiteboard', 'height', 1.48024, 1.49511, 4.963),
  ('whiteboard', 'height', 1.49511, 1.51295, 5.158),
  ('whiteboard', 'height', 1.51295, 1.547, 2.726),
  ('whiteboard', 'height', 1.547, 1.56412, 2.269),
  ('whiteboard', 'height', 1.56412, 1.58836, 3.202),
  ('whiteboard', 'height', 1.58836, 1.59888, 3.31),
  ('whiteboard', 'height', 1.59888, 1.62596, 2.254),
  ('whiteboard', 'height', 1.62596, 1.65077, 0.9838),
  ('whiteboard', 'height', 1.65077, 4, 0.00866);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'length', 0.03, 0.819125, 0.005566),
  ('whiteboard', 'length', 0.819125, 0.963211, 0.171),
  ('whiteboard', 'length', 0.963211, 1.01366, 0.2291),
  ('whiteboard', 'length', 1.01366, 1.1797, 0.5663),
  ('whiteboard', 'length', 1.1797, 1.24708, 2.778),
  ('whiteboard', 'length', 1.24708, 1.44929, 0.8068),
  ('whiteboard', 'length', 1.44929, 1.55231, 0.6118),
  ('whiteboard', 'length', 1.55231, 1.63342, 0.6733),
  ('whiteboard', 'length', 1.63342, 1.92097, 0.6517),
  ('whiteboard', 'length', 1.92097, 2.08403, 0.6261),
  ('whiteboard', 'length', 2.08403, 2.37718, 0.615),
  ('whiteboard', 'length', 2.37718, 2.49941, 0.5861),
  ('whiteboard', 'length', 2.49941, 2.94174, 0.4665),
  ('whiteboard', 'length', 2.94174, 3.55208, 0.2989),
  ('whiteboard', 'length', 3.55208, 4.50494, 0.2615),
  ('whiteboard', 'length', 4.50494, 5.57483, 0.1582),
  ('whiteboard', 'length', 5.57483, 30, 0.005476);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'rectangularity', 0, 0.508127, 0.03886),
  ('whiteboard', 'rectangularity', 0.508127, 0.554426, 0.3537),
  ('whiteboard', 'rectangularity', 0.554426, 0.600725, 1.201),
  ('whiteboard', 'rectangularity', 0.600725, 0.609907, 2.599),
  ('whiteboard', 'rectangularity', 0.609907, 0.643414, 2.923),
  ('whiteboard', 'rectangularity', 0.643414, 0.691708, 2.234),
  ('whiteboard', 'rectangularity', 0.691708, 0.739623, 1.398),
  ('whiteboard', 'rectangularity', 0.739623, 0.785923, 1.764),
  ('whiteboard', 'rectangularity', 0.785923, 0.796467, 3.618),
  ('whiteboard', 'rectangularity', 0.796467, 0.807547, 6.846),
  ('whiteboard', 'rectangularity', 0.807547, 0.832222, 2.795),
  ('whiteboard', 'rectangularity', 0.832222, 0.843974, 3.96),
  ('whiteboard', 'rectangularity', 0.843974, 0.855216, 6.329),
  ('whiteboard', 'rectangularity', 0.855216, 0.876635, 3.911),
  ('whiteboard', 'rectangularity', 0.876635, 0.912145, 2.791),
  ('whiteboard', 'rectangularity', 0.912145, 0.924821, 1.088),
  ('whiteboard', 'rectangularity', 0.924821, 1, 0.4334);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_length', 0.01, 0.819148, 0.007646),
  ('whiteboard', 'spread_length', 0.819148, 0.88799, 0.342),
  ('whiteboard', 'spread_length', 0.88799, 0.96983, 0.4466),
  ('whiteboard', 'spread_length', 0.96983, 1.03513, 0.4332),
  ('whiteboard', 'spread_length', 1.03513, 1.14823, 0.9962),
  ('whiteboard', 'spread_length', 1.14823, 1.19672, 2.073),
  ('whiteboard', 'spread_length', 1.19672, 1.29654, 1.158),
  ('whiteboard', 'spread_length', 1.29654, 1.35945, 0.864),
  ('whiteboard', 'spread_length', 1.35945, 1.48915, 0.7203),
  ('whiteboard', 'spread_length', 1.48915, 1.60952, 0.7725),
  ('whiteboard', 'spread_length', 1.60952, 1.68354, 1.37),
  ('whiteboard', 'spread_length', 1.68354, 1.8023, 1.403),
  ('whiteboard', 'spread_length', 1.8023, 1.90559, 0.5434),
  ('whiteboard', 'spread_length', 1.90559, 2.25612, 0.3774),
  ('whiteboard', 'spread_length', 2.25612, 2.67113, 0.3624),
  ('whiteboard', 'spread_length', 2.67113, 3.16248, 0.3172),
  ('whiteboard', 'spread_length', 3.16248, 3.51804, 0.2499),
  ('whiteboard', 'spread_length', 3.51804, 3.74422, 0.1839),
  ('whiteboard', 'spread_length', 3.74422, 40, 0.007863);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_width', 0.003, 0.332687, 0.002637),
  ('whiteboard', 'spread_width', 0.332687, 0.366149, 0.1503),
  ('whiteboard', 'spread_width', 0.366149, 0.410017, 0.1813),
  ('whiteboard', 'spread_width', 0.410017, 0.505321, 0.1338),
  ('whiteboard', 'spread_width', 0.505321, 0.622777, 0.1437),
  ('whiteboard', 'spread_width', 0.622777, 0.722097, 0.4142),
  ('whiteboard', 'spread_width', 0.722097, 0.767535, 0.7345),
  ('whiteboard', 'spread_width', 0.767535, 0.792837, 0.7936),
  ('whiteboard', 'spread_width', 0.792837, 0.919687, 0.9436),
  ('whiteboard', 'spread_width', 0.919687, 0.94594, 2.56),
  ('whiteboard', 'spread_width', 0.94594, 1.09043, 1.359),
  ('whiteboard', 'spread_width', 1.09043, 1.16581, 0.8372),
  ('whiteboard', 'spread_width', 1.16581, 1.403, 0.3926),
  ('whiteboard', 'spread_width', 1.403, 1.76729, 0.5094),
  ('whiteboard', 'spread_width', 1.76729, 1.98687, 0.6246),
  ('whiteboard', 'spread_width', 1.98687, 2.18236, 0.239),
  ('whiteboard', 'spread_width', 2.18236, 20, 0.007068);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'tilt_deg', 0, 88.811, 6.388e-05),
  ('whiteboard', 'tilt_deg', 88.811, 88.9431, 0.05853),
  ('whiteboard', 'tilt_deg', 88.9431, 89.0752, 0.1047),
  ('whiteboard', 'tilt_deg', 89.0752, 89.2074, 0.1626),
  ('whiteboard', 'tilt_deg', 89.2074, 89.3395, 0.2456),
  ('whiteboard', 'tilt_deg', 89.3395, 89.4716, 0.4055),
  ('whiteboard', 'tilt_deg', 89.4716, 89.6037, 0.7339),
  ('whiteboard', 'tilt_deg', 89.6037, 89.7358, 1.298),
  ('whiteboard', 'tilt_deg', 89.7358, 89.8679, 2),
  ('whiteboard', 'tilt_deg', 89.8679, 90, 2.518);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'width', 0.01, 0.444588, 0.005926),
  ('whiteboard', 'width', 0.444588, 0.455576, 0.1608),
  ('whiteboard', 'width', 0.455576, 0.55089, 0.1754),
  ('whiteboard', 'width', 0.55089, 0.682608, 0.132),
  ('whiteboard', 'width', 0.682608, 0.845821, 0.1533),
  ('whiteboard', 'width', 0.845821, 0.998046, 0.4126),
  ('whiteboard', 'width', 0.998046, 1.03881, 1.637),
  ('whiteboard', 'width', 1.03881, 1.1212, 1.218),
  ('whiteboard', 'width', 1.1212, 1.17018, 2.217),
  ('whiteboard', 'width', 1.17018, 1.19666, 2.93),
  ('whiteboard', 'width', 1.19666, 1.24476, 1.991),
  ('whiteboard', 'width', 1.24476, 1.29865, 1.029),
  ('whiteboard', 'width', 1.29865, 1.60916, 0.4045),
  ('whiteboard', 'width', 1.60916, 1.90706, 0.3057),
  ('whiteboard', 'width', 1.90706, 1.99391, 0.2743),
  ('whiteboard', 'width', 1.99391, 2.47066, 0.2566),
  ('whiteboard', 'width', 2.47066, 2.81189, 0.4917),
  ('whiteboard', 'width', 2.81189, 2.93426, 1.443),
  ('whiteboard', 'width', 2.93426, 3.06139, 0.5453),
  ('whiteboard', 'width', 3.06139, 12, 0.01155);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_max', -0.5, 1.72529, 0.01344),
  ('whiteboard', 'z_max', 1.72529, 1.80514, 0.4844),
  ('whiteboard', 'z_max', 1.80514, 1.8712, 0.9675),
  ('whiteboard', 'z_max', 1.8712, 2.00788, 0.9042),
  ('whiteboard', 'z_max', 2.00788, 2.03117, 2.733),
  ('whiteboard', 'z_max', 2.03117, 2.06592, 2.285),
  ('whiteboard', 'z_max', 2.06592, 2.12049, 1.629),
  ('whiteboard', 'z_max', 2.12049, 2.16302, 1.951),
  ('whiteboard', 'z_max', 2.16302, 2.19474, 0.7612),
  ('whiteboard', 'z_max', 2.19474, 2.30893, 0.602),
  ('whiteboard', 'z_max', 2.30893, 2.45484, 0.4953),
  ('whiteboard', 'z_max', 2.45484, 2.50315, 0.4452),
  ('whiteboard', 'z_max', 2.50315, 2.60074, 0.3645),
  ('whiteboard', 'z_max', 2.60074, 2.74665, 0.3115),
  ('whiteboard', 'z_max', 2.74665, 2.83785, 0.5936),
  ('whiteboard', 'z_max', 2.83785, 2.89256, 0.665),
  ('whiteboard', 'z_max', 2.89256, 2.96358, 0.531),
  ('whiteboard', 'z_max', 2.96358, 3.03847, 0.2924),
  ('whiteboard', 'z_max', 3.03847, 4, 0.01161);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_min', -0.5, -0.0450873, 0.02193),
  ('whiteboard', 'z_min', -0.0450873, -0.0165188, 1.715),
  ('whiteboard', 'z_min', -0.0165188, 0.0736619, 1.142),
  ('whiteboard', 'z_min', 0.0736619, 0.192411, 0.1312),
  ('whiteboard', 'z_min', 0.192411, 0.31116, 0.1957),
  ('whiteboard', 'z_min', 0.31116, 0.42991, 0.2645),
  ('whiteboard', 'z_min', 0.42991, 0.548659, 0.3301),
  ('whiteboard', 'z_min', 0.548659, 0.594868, 0.4079),
  ('whiteboard', 'z_min', 0.594868, 0.667408, 0.5343),
  ('whiteboard', 'z_min', 0.667408, 0.781624, 0.96),
  ('whiteboard', 'z_min', 0.781624, 0.803993, 2.666),
  ('whiteboard', 'z_min', 0.803993, 0.863685, 1.791),
  ('whiteboard', 'z_min', 0.863685, 0.88769, 2.584),
  ('whiteboard', 'z_min', 0.88769, 0.904907, 2.996),
  ('whiteboard', 'z_min', 0.904907, 0.91598, 3.457),
  ('whiteboard', 'z_min', 0.91598, 0.938066, 3.645),
  ('whiteboard', 'z_min', 0.938066, 1.00792, 1.217),
  ('whiteboard', 'z_min', 1.00792, 1.02366, 0.549),
  ('whiteboard', 'z_min', 1.02366, 4, 0.0231);

-- shelf: 133 examples
UPDATE object_class SET prior = 0.06073 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.259, 0.6405)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 1.025, 0.4261)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 1.012, 0.4838)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', 0.08503, 0.4259)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6841, 0.1239)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.1091, 0.4519)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.161, 0.3225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 54.03, 43.52)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -0.9438, 0.3138)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.399, 0.6096)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5793, 0.6419)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'area_m2', 0.002, 0.0474906, 0.00312),
  ('shelf', 'area_m2', 0.0474906, 0.0678858, 0.04049),
  ('shelf', 'area_m2', 0.0678858, 0.0970398, 0.08408),
  ('shelf', 'area_m2', 0.0970398, 0.124729, 0.2408),
  ('shelf', 'area_m2', 0.124729, 0.138714, 0.46),
  ('shelf', 'area_m2', 0.138714, 0.176753, 0.2405),
  ('shelf', 'area_m2', 0.176753, 0.198286, 0.322),
  ('shelf', 'area_m2', 0.198286, 0.23465, 0.4606),
  ('shelf', 'area_m2', 0.23465, 0.283441, 0.5639),
  ('shelf', 'area_m2', 0.283441, 0.319597, 0.948),
  ('shelf', 'area_m2', 0.319597, 0.358151, 0.8885),
  ('shelf', 'area_m2', 0.358151, 0.405166, 0.5672),
  ('shelf', 'area_m2', 0.405166, 0.466803, 0.3765),
  ('shelf', 'area_m2', 0.466803, 0.579168, 0.3322),
  ('shelf', 'area_m2', 0.579168, 0.633449, 0.4385),
  ('shelf', 'area_m2', 0.633449, 0.827895, 0.2654),
  ('shelf', 'area_m2', 0.827895, 1.18344, 0.06979),
  ('shelf', 'area_m2', 1.18344, 100, 0.002634);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'aspect', 1, 1.07143, 0.2038),
  ('shelf', 'aspect', 1.07143, 1.23042, 0.2596),
  ('shelf', 'aspect', 1.23042, 1.51394, 0.2498),
  ('shelf', 'aspect', 1.51394, 1.60117, 0.2388),
  ('shelf', 'aspect', 1.60117, 1.86278, 0.3159),
  ('shelf', 'aspect', 1.86278, 2.08494, 0.6142),
  ('shelf', 'aspect', 2.08494, 2.292, 0.7805),
  ('shelf', 'aspect', 2.292, 2.43254, 0.6661),
  ('shelf', 'aspect', 2.43254, 2.71034, 0.9335),
  ('shelf', 'aspect', 2.71034, 2.82013, 0.7843),
  ('shelf', 'aspect', 2.82013, 3.01943, 1.155),
  ('shelf', 'aspect', 3.01943, 3.33755, 1.039),
  ('shelf', 'aspect', 3.33755, 3.46995, 0.7643),
  ('shelf', 'aspect', 3.46995, 3.97985, 0.6552),
  ('shelf', 'aspect', 3.97985, 4.2695, 0.6655),
  ('shelf', 'aspect', 4.2695, 4.75538, 0.5823),
  ('shelf', 'aspect', 4.75538, 5.25328, 0.4895),
  ('shelf', 'aspect', 5.25328, 6.22068, 0.2848),
  ('shelf', 'aspect', 6.22068, 6.46375, 0.1208),
  ('shelf', 'aspect', 6.46375, 100, 0.003151);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'height', -0.5, 0.00370115, 0.03332),
  ('shelf', 'height', 0.00370115, 0.0680949, 0.1455),
  ('shelf', 'height', 0.0680949, 0.248166, 0.1242),
  ('shelf', 'height', 0.248166, 0.48054, 0.28),
  ('shelf', 'height', 0.48054, 0.666289, 0.5793),
  ('shelf', 'height', 0.666289, 0.737096, 0.7941),
  ('shelf', 'height', 0.737096, 0.774445, 1.415),
  ('shelf', 'height', 0.774445, 0.925108, 0.807),
  ('shelf', 'height', 0.925108, 0.981561, 1.192),
  ('shelf', 'height', 0.981561, 1.0342, 0.675),
  ('shelf', 'height', 1.0342, 1.13298, 1.083),
  ('shelf', 'height', 1.13298, 1.22603, 0.7805),
  ('shelf', 'height', 1.22603, 1.32877, 0.4711),
  ('shelf', 'height', 1.32877, 1.47049, 0.365),
  ('shelf', 'height', 1.47049, 1.68507, 0.2665),
  ('shelf', 'height', 1.68507, 1.71496, 0.2244),
  ('shelf', 'height', 1.71496, 1.95942, 0.2018),
  ('shelf', 'height', 1.95942, 2.15691, 0.1775),
  ('shelf', 'height', 2.15691, 2.20389, 0.1247),
  ('shelf', 'height', 2.20389, 4, 0.006396);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'length', 0.03, 0.366301, 0.003971),
  ('shelf', 'length', 0.366301, 0.453339, 0.04129),
  ('shelf', 'length', 0.453339, 0.56106, 0.2668),
  ('shelf', 'length', 0.56106, 0.636853, 0.3691),
  ('shelf', 'length', 0.636853, 0.694377, 0.4481),
  ('shelf', 'length', 0.694377, 0.777549, 0.5188),
  ('shelf', 'length', 0.777549, 0.859373, 0.5832),
  ('shelf', 'length', 0.859373, 0.920399, 0.7486),
  ('shelf', 'length', 0.920399, 1.03853, 1.034),
  ('shelf', 'length', 1.03853, 1.06357, 0.6915),
  ('shelf', 'length', 1.06357, 1.157, 1.029),
  ('shelf', 'length', 1.157, 1.3163, 0.7963),
  ('shelf', 'length', 1.3163, 1.50279, 0.8342),
  ('shelf', 'length', 1.50279, 1.62907, 0.5588),
  ('shelf', 'length', 1.62907, 1.98293, 0.3934),
  ('shelf', 'length', 1.98293, 2.29519, 0.5848),
  ('shelf', 'length', 2.29519, 2.49524, 0.2206),
  ('shelf', 'length', 2.49524, 30, 0.001156);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'rectangularity', 0, 0.414401, 0.01535),
  ('shelf', 'rectangularity', 0.414401, 0.42681, 0.559),
  ('shelf', 'rectangularity', 0.42681, 0.470156, 1.172),
  ('shelf', 'rectangularity', 0.470156, 0.52591, 0.9343),
  ('shelf', 'rectangularity', 0.52591, 0.578618, 2.011),
  ('shelf', 'rectangularity', 0.578618, 0.624899, 2.412),
  ('shelf', 'rectangularity', 0.624899, 0.637419, 2.888),
  ('shelf', 'rectangularity', 0.637419, 0.673507, 2.138),
  ('shelf', 'rectangularity', 0.673507, 0.693174, 3.181),
  ('shelf', 'rectangularity', 0.693174, 0.714908, 2.219),
  ('shelf', 'rectangularity', 0.714908, 0.748929, 2.203),
  ('shelf', 'rectangularity', 0.748929, 0.761383, 3.42),
  ('shelf', 'rectangularity', 0.761383, 0.792624, 3.279),
  ('shelf', 'rectangularity', 0.792624, 0.804683, 2.551),
  ('shelf', 'rectangularity', 0.804683, 0.827699, 3.027),
  ('shelf', 'rectangularity', 0.827699, 0.860438, 1.657),
  ('shelf', 'rectangularity', 0.860438, 0.916193, 1.042),
  ('shelf', 'rectangularity', 0.916193, 1, 0.1111);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_length', 0.01, 0.28053, 0.002517),
  ('shelf', 'spread_length', 0.28053, 0.352945, 0.09169),
  ('shelf', 'spread_length', 0.352945, 0.444053, 0.1719),
  ('shelf', 'spread_length', 0.444053, 0.536411, 0.2333),
  ('shelf', 'spread_length', 0.536411, 0.558679, 0.3072),
  ('shelf', 'spread_length', 0.558679, 0.638439, 0.7126),
  ('shelf', 'spread_length', 0.638439, 0.702895, 1.183),
  ('shelf', 'spread_length', 0.702895, 0.822626, 0.712),
  ('shelf', 'spread_length', 0.822626, 0.884338, 0.4349),
  ('shelf', 'spread_length', 0.884338, 0.995784, 0.704),
  ('shelf', 'spread_length', 0.995784, 1.11262, 0.9249),
  ('shelf', 'spread_length', 1.11262, 1.32342, 0.6813),
  ('shelf', 'spread_length', 1.32342, 1.39983, 0.626),
  ('shelf', 'spread_length', 1.39983, 1.57356, 0.5709),
  ('shelf', 'spread_length', 1.57356, 1.76117, 0.4206),
  ('shelf', 'spread_length', 1.76117, 2.11597, 0.2819),
  ('shelf', 'spread_length', 2.11597, 2.21579, 0.1563),
  ('shelf', 'spread_length', 2.21579, 40, 0.003309);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_width', 0.003, 0.138571, 0.002584),
  ('shelf', 'spread_width', 0.138571, 0.166974, 0.1517),
  ('shelf', 'spread_width', 0.166974, 0.2012, 0.2921),
  ('shelf', 'spread_width', 0.2012, 0.213235, 0.4631),
  ('shelf', 'spread_width', 0.213235, 0.24244, 0.6223),
  ('shelf', 'spread_width', 0.24244, 0.248382, 0.8226),
  ('shelf', 'spread_width', 0.248382, 0.282138, 0.8989),
  ('shelf', 'spread_width', 0.282138, 0.292134, 1.693),
  ('shelf', 'spread_width', 0.292134, 0.300182, 1.713),
  ('shelf', 'spread_width', 0.300182, 0.332385, 1.106),
  ('shelf', 'spread_width', 0.332385, 0.352013, 1.489),
  ('shelf', 'spread_width', 0.352013, 0.36564, 0.9961),
  ('shelf', 'spread_width', 0.36564, 0.390634, 1.503),
  ('shelf', 'spread_width', 0.390634, 0.420086, 1.397),
  ('shelf', 'spread_width', 0.420086, 0.51111, 0.3593),
  ('shelf', 'spread_width', 0.51111, 0.615873, 0.08596),
  ('shelf', 'spread_width', 0.615873, 0.742111, 0.1217),
  ('shelf', 'spread_width', 0.742111, 20, 0.004409);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'tilt_deg', 0, 0.161705, 0.07823),
  ('shelf', 'tilt_deg', 0.161705, 0.798975, 0.1525),
  ('shelf', 'tilt_deg', 0.798975, 1.19228, 0.2208),
  ('shelf', 'tilt_deg', 1.19228, 2.62189, 0.0822),
  ('shelf', 'tilt_deg', 2.62189, 10, 0.00866),
  ('shelf', 'tilt_deg', 10, 20, 0.0009152),
  ('shelf', 'tilt_deg', 20, 30, 0.0008053),
  ('shelf', 'tilt_deg', 30, 40, 0.0008687),
  ('shelf', 'tilt_deg', 40, 50, 0.0009337),
  ('shelf', 'tilt_deg', 50, 60, 0.0009917),
  ('shelf', 'tilt_deg', 60, 70, 0.001037),
  ('shelf', 'tilt_deg', 70, 80, 0.001066),
  ('shelf', 'tilt_deg', 80, 89.4762, 0.006384),
  ('shelf', 'tilt_deg', 89.4762, 89.8639, 0.7363),
  ('shelf', 'tilt_deg', 89.8639, 90, 1.541);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'width', 0.01, 0.177433, 0.00287),
  ('shelf', 'width', 0.177433, 0.222531, 0.1121),
  ('shelf', 'width', 0.222531, 0.279092, 0.2362),
  ('shelf', 'width', 0.279092, 0.302133, 0.5067),
  ('shelf', 'width', 0.302133, 0.323223, 1.434),
  ('shelf', 'width', 0.323223, 0.346406, 1.724),
  ('shelf', 'width', 0.346406, 0.362107, 2.369),
  ('shelf', 'width', 0.362107, 0.386416, 1.541),
  ('shelf', 'width', 0.386416, 0.424802, 1.35),
  ('shelf', 'width', 0.424802, 0.438996, 2.003),
  ('shelf', 'width', 0.438996, 0.451074, 1.049),
  ('shelf', 'width', 0.451074, 0.523299, 0.7653),
  ('shelf', 'width', 0.523299, 0.550575, 0.6929),
  ('shelf', 'width', 0.550575, 0.690515, 0.1592),
  ('shelf', 'width', 0.690515, 0.866023, 0.05932),
  ('shelf', 'width', 0.866023, 1.08614, 0.04503),
  ('shelf', 'width', 1.08614, 1.3622, 0.04612),
  ('shelf', 'width', 1.3622, 12, 0.00463);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_max', -0.5, -0.0291838, 0.03242),
  ('shelf', 'z_max', -0.0291838, 0.0703584, 0.09967),
  ('shelf', 'z_max', 0.0703584, 0.235072, 0.09606),
  ('shelf', 'z_max', 0.235072, 0.496635, 0.2437),
  ('shelf', 'z_max', 0.496635, 0.763583, 0.3107),
  ('shelf', 'z_max', 0.763583, 0.893961, 0.2422),
  ('shelf', 'z_max', 0.893961, 1.02784, 0.2942),
  ('shelf', 'z_max', 1.02784, 1.19947, 0.45),
  ('shelf', 'z_max', 1.19947, 1.29209, 0.3975),
  ('shelf', 'z_max', 1.29209, 1.42942, 0.5684),
  ('shelf', 'z_max', 1.42942, 1.55635, 0.6058),
  ('shelf', 'z_max', 1.55635, 1.60005, 0.8435),
  ('shelf', 'z_max', 1.60005, 1.74235, 0.7894),
  ('shelf', 'z_max', 1.74235, 1.8206, 0.8909),
  ('shelf', 'z_max', 1.8206, 1.93498, 0.2641),
  ('shelf', 'z_max', 1.93498, 2.08486, 0.4994),
  ('shelf', 'z_max', 2.08486, 2.13509, 0.7546),
  ('shelf', 'z_max', 2.13509, 2.34912, 0.4704),
  ('shelf', 'z_max', 2.34912, 4, 0.005928);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_min', -0.5, -0.0539074, 0.02849),
  ('shelf', 'z_min', -0.0539074, -0.0186275, 1.472),
  ('shelf', 'z_min', -0.0186275, -0.00824947, 7.272),
  ('shelf', 'z_min', -0.00824947, 0.0662915, 2.494),
  ('shelf', 'z_min', 0.0662915, 0.193534, 0.5171),
  ('shelf', 'z_min', 0.193534, 0.400932, 0.2321),
  ('shelf', 'z_min', 0.400932, 0.440975, 0.9578),
  ('shelf', 'z_min', 0.440975, 0.474887, 1.792),
  ('shelf', 'z_min', 0.474887, 0.688416, 0.5107),
  ('shelf', 'z_min', 0.688416, 0.730237, 0.2865),
  ('shelf', 'z_min', 0.730237, 0.881182, 0.6994),
  ('shelf', 'z_min', 0.881182, 0.935857, 0.4265),
  ('shelf', 'z_min', 0.935857, 1.1833, 0.1727),
  ('shelf', 'z_min', 1.1833, 1.43074, 0.09401),
  ('shelf', 'z_min', 1.43074, 1.64515, 0.1681),
  ('shelf', 'z_min', 1.64515, 1.67818, 0.1997),
  ('shelf', 'z_min', 1.67818, 1.92562, 0.1913),
  ('shelf', 'z_min', 1.92562, 2.15265, 0.1528),
  ('shelf', 'z_min', 2.15265, 2.17306, 0.116),
  ('shelf', 'z_min', 2.17306, 4, 0.009818);

-- cabinet: 184 examples
UPDATE object_class SET prior = 0.083 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.7672, 0.8814)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6272, 0.4124)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7833, 0.3358)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.1163, 0.463)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7025, 0.1208)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.07809, 0.486)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7692, 0.4761)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 76.78, 31.73)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.5124, 0.4586)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.257, 0.5584)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.1971, 0.3388)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'area_m2', 0.002, 0.0366778, 0.002621),
  ('cabinet', 'area_m2', 0.0366778, 0.0578261, 0.03277),
  ('cabinet', 'area_m2', 0.0578261, 0.0911684, 0.08023),
  ('cabinet', 'area_m2', 0.0911684, 0.138103, 0.107),
  ('cabinet', 'area_m2', 0.138103, 0.143736, 0.1085),
  ('cabinet', 'area_m2', 0.143736, 0.226613, 0.2258),
  ('cabinet', 'area_m2', 0.226613, 0.242022, 0.1687),
  ('cabinet', 'area_m2', 0.242022, 0.356654, 0.2915),
  ('cabinet', 'area_m2', 0.356654, 0.428115, 0.6014),
  ('cabinet', 'area_m2', 0.428115, 0.563284, 0.3585),
  ('cabinet', 'area_m2', 0.563284, 0.586564, 0.4065),
  ('cabinet', 'area_m2', 0.586564, 0.758112, 0.4315),
  ('cabinet', 'area_m2', 0.758112, 0.888071, 0.3381),
  ('cabinet', 'area_m2', 0.888071, 0.973888, 0.507),
  ('cabinet', 'area_m2', 0.973888, 1.27421, 0.4336),
  ('cabinet', 'area_m2', 1.27421, 1.40013, 0.2739),
  ('cabinet', 'area_m2', 1.40013, 2.20744, 0.1707),
  ('cabinet', 'area_m2', 2.20744, 100, 0.002504);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'aspect', 1, 1.15596, 0.8073),
  ('cabinet', 'aspect', 1.15596, 1.22354, 0.8798),
  ('cabinet', 'aspect', 1.22354, 1.2871, 1.001),
  ('cabinet', 'aspect', 1.2871, 1.47621, 0.8068),
  ('cabinet', 'aspect', 1.47621, 1.62263, 1.191),
  ('cabinet', 'aspect', 1.62263, 1.83169, 0.6798),
  ('cabinet', 'aspect', 1.83169, 1.9197, 0.6932),
  ('cabinet', 'aspect', 1.9197, 2.24114, 0.6714),
  ('cabinet', 'aspect', 2.24114, 2.29349, 0.5161),
  ('cabinet', 'aspect', 2.29349, 2.57616, 0.8572),
  ('cabinet', 'aspect', 2.57616, 2.74212, 0.8256),
  ('cabinet', 'aspect', 2.74212, 3.18077, 0.464),
  ('cabinet', 'aspect', 3.18077, 3.35509, 0.3257),
  ('cabinet', 'aspect', 3.35509, 4.10508, 0.2541),
  ('cabinet', 'aspect', 4.10508, 5.02272, 0.08379),
  ('cabinet', 'aspect', 5.02272, 6.14549, 0.05353),
  ('cabinet', 'aspect', 6.14549, 100, 0.004266);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'height', -0.5, 0.148738, 0.007177),
  ('cabinet', 'height', 0.148738, 0.172804, 0.1234),
  ('cabinet', 'height', 0.172804, 0.296886, 0.6036),
  ('cabinet', 'height', 0.296886, 0.321619, 1.262),
  ('cabinet', 'height', 0.321619, 0.445034, 0.7941),
  ('cabinet', 'height', 0.445034, 0.486652, 0.3004),
  ('cabinet', 'height', 0.486652, 0.579993, 0.9585),
  ('cabinet', 'height', 0.579993, 0.735324, 0.8887),
  ('cabinet', 'height', 0.735324, 0.889478, 0.6181),
  ('cabinet', 'height', 0.889478, 0.958933, 1.727),
  ('cabinet', 'height', 0.958933, 1.03763, 1.106),
  ('cabinet', 'height', 1.03763, 1.07091, 0.849),
  ('cabinet', 'height', 1.07091, 1.18577, 0.721),
  ('cabinet', 'height', 1.18577, 1.2333, 0.5899),
  ('cabinet', 'height', 1.2333, 1.33392, 0.6515),
  ('cabinet', 'height', 1.33392, 1.48207, 0.2275),
  ('cabinet', 'height', 1.48207, 4, 0.003041);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'length', 0.03, 0.369251, 0.004408),
  ('cabinet', 'length', 0.369251, 0.452721, 0.1138),
  ('cabinet', 'length', 0.452721, 0.555061, 0.2474),
  ('cabinet', 'length', 0.555061, 0.592508, 0.383),
  ('cabinet', 'length', 0.592508, 0.680535, 0.3046),
  ('cabinet', 'length', 0.680535, 0.775726, 0.5184),
  ('cabinet', 'length', 0.775726, 0.834373, 0.8673),
  ('cabinet', 'length', 0.834373, 0.886578, 0.7373),
  ('cabinet', 'length', 0.886578, 1.02299, 0.6593),
  ('cabinet', 'length', 1.02299, 1.08368, 0.4727),
  ('cabinet', 'length', 1.08368, 1.25424, 0.7341),
  ('cabinet', 'length', 1.25424, 1.53776, 0.519),
  ('cabinet', 'length', 1.53776, 1.58467, 0.2321),
  ('cabinet', 'length', 1.58467, 1.80543, 0.9324),
  ('cabinet', 'length', 1.80543, 1.88538, 1.7),
  ('cabinet', 'length', 1.88538, 1.92214, 1.337),
  ('cabinet', 'length', 1.92214, 2.27548, 0.598),
  ('cabinet', 'length', 2.27548, 30, 0.003359);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'rectangularity', 0, 0.397434, 0.02912),
  ('cabinet', 'rectangularity', 0.397434, 0.459411, 0.4466),
  ('cabinet', 'rectangularity', 0.459411, 0.521388, 0.7849),
  ('cabinet', 'rectangularity', 0.521388, 0.543287, 1.053),
  ('cabinet', 'rectangularity', 0.543287, 0.583364, 1.305),
  ('cabinet', 'rectangularity', 0.583364, 0.609487, 2.086),
  ('cabinet', 'rectangularity', 0.609487, 0.645341, 2.757),
  ('cabinet', 'rectangularity', 0.645341, 0.652197, 2.512),
  ('cabinet', 'rectangularity', 0.652197, 0.695738, 2.543),
  ('cabinet', 'rectangularity', 0.695738, 0.707318, 2.788),
  ('cabinet', 'rectangularity', 0.707318, 0.73154, 3.402),
  ('cabinet', 'rectangularity', 0.73154, 0.765837, 3.272),
  ('cabinet', 'rectangularity', 0.765837, 0.810924, 2.554),
  ('cabinet', 'rectangularity', 0.810924, 0.831271, 2.943),
  ('cabinet', 'rectangularity', 0.831271, 0.840245, 3.844),
  ('cabinet', 'rectangularity', 0.840245, 0.893248, 1.565),
  ('cabinet', 'rectangularity', 0.893248, 0.953838, 0.4535),
  ('cabinet', 'rectangularity', 0.953838, 1, 0.1852);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_length', 0.01, 0.343865, 0.002691),
  ('cabinet', 'spread_length', 0.343865, 0.419823, 0.2784),
  ('cabinet', 'spread_length', 0.419823, 0.490013, 0.3105),
  ('cabinet', 'spread_length', 0.490013, 0.512559, 0.2978),
  ('cabinet', 'spread_length', 0.512559, 0.623233, 0.5151),
  ('cabinet', 'spread_length', 0.623233, 0.695016, 1.004),
  ('cabinet', 'spread_length', 0.695016, 0.764014, 0.7401),
  ('cabinet', 'spread_length', 0.764014, 0.842256, 0.4315),
  ('cabinet', 'spread_length', 0.842256, 0.932781, 0.4082),
  ('cabinet', 'spread_length', 0.932781, 1.0177, 0.6736),
  ('cabinet', 'spread_length', 1.0177, 1.13883, 0.5545),
  ('cabinet', 'spread_length', 1.13883, 1.22168, 0.8013),
  ('cabinet', 'spread_length', 1.22168, 1.39039, 0.4375),
  ('cabinet', 'spread_length', 1.39039, 1.55999, 0.4902),
  ('cabinet', 'spread_length', 1.55999, 1.69752, 1.15),
  ('cabinet', 'spread_length', 1.69752, 2.05678, 0.5987),
  ('cabinet', 'spread_length', 2.05678, 40, 0.002418);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_width', 0.003, 0.0982992, 0.002221),
  ('cabinet', 'spread_width', 0.0982992, 0.129017, 0.07258),
  ('cabinet', 'spread_width', 0.129017, 0.169333, 0.05674),
  ('cabinet', 'spread_width', 0.169333, 0.222248, 0.1174),
  ('cabinet', 'spread_width', 0.222248, 0.245683, 0.3175),
  ('cabinet', 'spread_width', 0.245683, 0.291699, 0.2038),
  ('cabinet', 'spread_width', 0.291699, 0.349032, 0.4508),
  ('cabinet', 'spread_width', 0.349032, 0.382852, 0.6359),
  ('cabinet', 'spread_width', 0.382852, 0.413734, 0.6967),
  ('cabinet', 'spread_width', 0.413734, 0.473933, 0.827),
  ('cabinet', 'spread_width', 0.473933, 0.50249, 0.8879),
  ('cabinet', 'spread_width', 0.50249, 0.533492, 0.9287),
  ('cabinet', 'spread_width', 0.533492, 0.579597, 1.34),
  ('cabinet', 'spread_width', 0.579597, 0.642005, 1.114),
  ('cabinet', 'spread_width', 0.642005, 0.659513, 0.511),
  ('cabinet', 'spread_width', 0.659513, 0.789275, 0.5518),
  ('cabinet', 'spread_width', 0.789275, 0.865605, 0.6569),
  ('cabinet', 'spread_width', 0.865605, 1.1361, 0.126),
  ('cabinet', 'spread_width', 1.1361, 20, 0.004158);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'tilt_deg', 0, 0.39963, 0.235),
  ('cabinet', 'tilt_deg', 0.39963, 10, 0.004667),
  ('cabinet', 'tilt_deg', 10, 20, 0.0001457),
  ('cabinet', 'tilt_deg', 20, 30, 0.000247),
  ('cabinet', 'tilt_deg', 30, 40, 0.0004036),
  ('cabinet', 'tilt_deg', 40, 50, 0.0006111),
  ('cabinet', 'tilt_deg', 50, 60, 0.0008509),
  ('cabinet', 'tilt_deg', 60, 70, 0.001089),
  ('cabinet', 'tilt_deg', 70, 80, 0.001283),
  ('cabinet', 'tilt_deg', 80, 89.7716, 0.03079),
  ('cabinet', 'tilt_deg', 89.7716, 90, 2.251);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'width', 0.01, 0.129555, 0.0031),
  ('cabinet', 'width', 0.129555, 0.170164, 0.05526),
  ('cabinet', 'width', 0.170164, 0.223503, 0.08343),
  ('cabinet', 'width', 0.223503, 0.293561, 0.1324),
  ('cabinet', 'width', 0.293561, 0.357431, 0.1531),
  ('cabinet', 'width', 0.357431, 0.38558, 0.3039),
  ('cabinet', 'width', 0.38558, 0.471086, 0.458),
  ('cabinet', 'width', 0.471086, 0.506442, 0.59),
  ('cabinet', 'width', 0.506442, 0.558439, 0.6885),
  ('cabinet', 'width', 0.558439, 0.601429, 1.436),
  ('cabinet', 'width', 0.601429, 0.64621, 1.57),
  ('cabinet', 'width', 0.64621, 0.665189, 1.37),
  ('cabinet', 'width', 0.665189, 0.729673, 0.853),
  ('cabinet', 'width', 0.729673, 0.836157, 0.7324),
  ('cabinet', 'width', 0.836157, 0.873697, 0.7211),
  ('cabinet', 'width', 0.873697, 1.00635, 0.5584),
  ('cabinet', 'width', 1.00635, 1.14756, 0.5115),
  ('cabinet', 'width', 1.14756, 1.46649, 0.1615),
  ('cabinet', 'width', 1.46649, 1.50727, 0.06033),
  ('cabinet', 'width', 1.50727, 12, 0.003194);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_max', -0.5, 0.329532, 0.01001),
  ('cabinet', 'z_max', 0.329532, 0.548476, 0.1031),
  ('cabinet', 'z_max', 0.548476, 0.58511, 1.909),
  ('cabinet', 'z_max', 0.58511, 0.722101, 0.92),
  ('cabinet', 'z_max', 0.722101, 0.76742, 1.641),
  ('cabinet', 'z_max', 0.76742, 0.819514, 0.5912),
  ('cabinet', 'z_max', 0.819514, 0.986364, 0.5421),
  ('cabinet', 'z_max', 0.986364, 1.01895, 0.588),
  ('cabinet', 'z_max', 1.01895, 1.20531, 0.4596),
  ('cabinet', 'z_max', 1.20531, 1.24718, 0.4713),
  ('cabinet', 'z_max', 1.24718, 1.42425, 0.2686),
  ('cabinet', 'z_max', 1.42425, 1.6432, 0.1466),
  ('cabinet', 'z_max', 1.6432, 1.71664, 0.5432),
  ('cabinet', 'z_max', 1.71664, 1.83919, 0.9592),
  ('cabinet', 'z_max', 1.83919, 1.86214, 1.099),
  ('cabinet', 'z_max', 1.86214, 1.96825, 0.7976),
  ('cabinet', 'z_max', 1.96825, 2.08108, 0.4609),
  ('cabinet', 'z_max', 2.08108, 2.24878, 0.2387),
  ('cabinet', 'z_max', 2.24878, 2.30003, 0.1103),
  ('cabinet', 'z_max', 2.30003, 4, 0.004909);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_min', -0.5, -0.0511879, 0.03491),
  ('cabinet', 'z_min', -0.0511879, -0.0303648, 3.1),
  ('cabinet', 'z_min', -0.0303648, -0.0202743, 13.02),
  ('cabinet', 'z_min', -0.0202743, -0.0135664, 18.66),
  ('cabinet', 'z_min', -0.0135664, 0.0111637, 11.77),
  ('cabinet', 'z_min', 0.0111637, 0.0826835, 0.5168),
  ('cabinet', 'z_min', 0.0826835, 0.216555, 0.1929),
  ('cabinet', 'z_min', 0.216555, 0.350426, 0.1862),
  ('cabinet', 'z_min', 0.350426, 0.484297, 0.2841),
  ('cabinet', 'z_min', 0.484297, 0.538798, 0.3818),
  ('cabinet', 'z_min', 0.538798, 0.618169, 1.062),
  ('cabinet', 'z_min', 0.618169, 0.719479, 0.3772),
  ('cabinet', 'z_min', 0.719479, 0.75204, 0.329),
  ('cabinet', 'z_min', 0.75204, 0.885911, 0.2581),
  ('cabinet', 'z_min', 0.885911, 1.01978, 0.1947),
  ('cabinet', 'z_min', 1.01978, 1.15365, 0.146),
  ('cabinet', 'z_min', 1.15365, 4, 0.004294);
