-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 13431 planes of 180 paper-like rooms, seeds from 1; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 36 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 5556 examples
UPDATE object_class SET prior = 0.4163 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.798, 1.15)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6918, 0.5627)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4834, 0.2906)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.4289, 0.3108)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.571, 0.41)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_joined', 0.3171, 0.3391)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 1.047, 0.6993)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.3787, 0.67)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.7236, 0.138)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.5337, 0.7019)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.276, 0.6048)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 61.51, 39.9)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.073, 0.5884)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.31, 0.9156)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7794, 0.7534)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0226034, 0.003406),
  ('unknown', 'area_m2', 0.0226034, 0.0498992, 0.1085),
  ('unknown', 'area_m2', 0.0498992, 0.0529746, 0.275),
  ('unknown', 'area_m2', 0.0529746, 0.071131, 0.3816),
  ('unknown', 'area_m2', 0.071131, 0.0918861, 0.4282),
  ('unknown', 'area_m2', 0.0918861, 0.110158, 0.4268),
  ('unknown', 'area_m2', 0.110158, 0.121395, 0.3538),
  ('unknown', 'area_m2', 0.121395, 0.169011, 0.337),
  ('unknown', 'area_m2', 0.169011, 0.23651, 0.3331),
  ('unknown', 'area_m2', 0.23651, 0.243184, 0.4164),
  ('unknown', 'area_m2', 0.243184, 0.310758, 0.393),
  ('unknown', 'area_m2', 0.310758, 0.508316, 0.2283),
  ('unknown', 'area_m2', 0.508316, 0.536854, 0.179),
  ('unknown', 'area_m2', 0.536854, 1.18516, 0.08332),
  ('unknown', 'area_m2', 1.18516, 2.61636, 0.00967),
  ('unknown', 'area_m2', 2.61636, 5.77588, 0.005807),
  ('unknown', 'area_m2', 5.77588, 12.7508, 0.007517),
  ('unknown', 'area_m2', 12.7508, 28.1488, 0.01102),
  ('unknown', 'area_m2', 28.1488, 100, 0.007168);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.11399, 1.024),
  ('unknown', 'aspect', 1.11399, 1.24683, 0.9931),
  ('unknown', 'aspect', 1.24683, 1.27346, 1.03),
  ('unknown', 'aspect', 1.27346, 1.39597, 0.9698),
  ('unknown', 'aspect', 1.39597, 1.58185, 0.8893),
  ('unknown', 'aspect', 1.58185, 1.6217, 0.8599),
  ('unknown', 'aspect', 1.6217, 1.83147, 0.7353),
  ('unknown', 'aspect', 1.83147, 2.06518, 0.6258),
  ('unknown', 'aspect', 2.06518, 2.20047, 0.5712),
  ('unknown', 'aspect', 2.20047, 2.62992, 0.4079),
  ('unknown', 'aspect', 2.62992, 2.99098, 0.2958),
  ('unknown', 'aspect', 2.99098, 3.34911, 0.2187),
  ('unknown', 'aspect', 3.34911, 4.26496, 0.2175),
  ('unknown', 'aspect', 4.26496, 5.00288, 0.2111),
  ('unknown', 'aspect', 5.00288, 5.43126, 0.3017),
  ('unknown', 'aspect', 5.43126, 6.91649, 0.2365),
  ('unknown', 'aspect', 6.91649, 8.80789, 0.0837),
  ('unknown', 'aspect', 8.80789, 100, 0.003838);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.0965323, 1.982),
  ('unknown', 'behind', 0.0965323, 0.178571, 0.3659),
  ('unknown', 'behind', 0.178571, 0.193065, 0.3759),
  ('unknown', 'behind', 0.193065, 0.289597, 0.4878),
  ('unknown', 'behind', 0.289597, 0.386129, 0.576),
  ('unknown', 'behind', 0.386129, 0.390488, 0.8383),
  ('unknown', 'behind', 0.390488, 0.482661, 0.8068),
  ('unknown', 'behind', 0.482661, 0.517397, 1.07),
  ('unknown', 'behind', 0.517397, 0.579194, 1.014),
  ('unknown', 'behind', 0.579194, 0.613072, 1.422),
  ('unknown', 'behind', 0.613072, 0.675726, 1.433),
  ('unknown', 'behind', 0.675726, 0.688492, 1.734),
  ('unknown', 'behind', 0.688492, 0.747882, 1.854),
  ('unknown', 'behind', 0.747882, 0.772258, 2.2),
  ('unknown', 'behind', 0.772258, 0.8, 2.07),
  ('unknown', 'behind', 0.8, 0.868791, 1.535),
  ('unknown', 'behind', 0.868791, 1, 0.04416);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free', 0, 0.10147, 2.185),
  ('unknown', 'edge_free', 0.10147, 0.111111, 0.7199),
  ('unknown', 'edge_free', 0.111111, 0.222222, 0.6552),
  ('unknown', 'edge_free', 0.222222, 0.264941, 0.7454),
  ('unknown', 'edge_free', 0.264941, 0.333333, 0.7857),
  ('unknown', 'edge_free', 0.333333, 0.387708, 1.051),
  ('unknown', 'edge_free', 0.387708, 0.444444, 1.202),
  ('unknown', 'edge_free', 0.444444, 0.475036, 1.405),
  ('unknown', 'edge_free', 0.475036, 0.555556, 1.317),
  ('unknown', 'edge_free', 0.555556, 0.562007, 0.8209),
  ('unknown', 'edge_free', 0.562007, 0.666667, 0.904),
  ('unknown', 'edge_free', 0.666667, 0.685607, 0.9181),
  ('unknown', 'edge_free', 0.685607, 0.777778, 0.7319),
  ('unknown', 'edge_free', 0.777778, 0.869909, 0.4668),
  ('unknown', 'edge_free', 0.869909, 0.888889, 0.3807),
  ('unknown', 'edge_free', 0.888889, 1, 0.9321);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free_top', 0, 0.111111, 2.445),
  ('unknown', 'edge_free_top', 0.111111, 0.222222, 0.3322),
  ('unknown', 'edge_free_top', 0.222222, 0.305217, 0.2884),
  ('unknown', 'edge_free_top', 0.305217, 0.333333, 0.325),
  ('unknown', 'edge_free_top', 0.333333, 0.444444, 0.3633),
  ('unknown', 'edge_free_top', 0.444444, 0.555556, 0.4091),
  ('unknown', 'edge_free_top', 0.555556, 0.599523, 0.3795),
  ('unknown', 'edge_free_top', 0.599523, 0.666667, 0.4936),
  ('unknown', 'edge_free_top', 0.666667, 0.777778, 0.6103),
  ('unknown', 'edge_free_top', 0.777778, 0.791421, 0.8412),
  ('unknown', 'edge_free_top', 0.791421, 0.888889, 0.7453),
  ('unknown', 'edge_free_top', 0.888889, 0.928174, 0.9912),
  ('unknown', 'edge_free_top', 0.928174, 1, 4.619);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_joined', 0, 0.00893376, 24.83),
  ('unknown', 'edge_joined', 0.00893376, 0.0469047, 2.957),
  ('unknown', 'edge_joined', 0.0469047, 0.111111, 1.465),
  ('unknown', 'edge_joined', 0.111111, 0.124626, 1.161),
  ('unknown', 'edge_joined', 0.124626, 0.222222, 0.9389),
  ('unknown', 'edge_joined', 0.222222, 0.242577, 0.9574),
  ('unknown', 'edge_joined', 0.242577, 0.333333, 0.7568),
  ('unknown', 'edge_joined', 0.333333, 0.406882, 0.5892),
  ('unknown', 'edge_joined', 0.406882, 0.444444, 0.5273),
  ('unknown', 'edge_joined', 0.444444, 0.555556, 0.5092),
  ('unknown', 'edge_joined', 0.555556, 0.631569, 0.4537),
  ('unknown', 'edge_joined', 0.631569, 0.666667, 0.4396),
  ('unknown', 'edge_joined', 0.666667, 0.777778, 0.4112),
  ('unknown', 'edge_joined', 0.777778, 0.888889, 0.4421),
  ('unknown', 'edge_joined', 0.888889, 1, 1.008);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0694891, 0.007823),
  ('unknown', 'height', 0.0694891, 0.231003, 0.6473),
  ('unknown', 'height', 0.231003, 0.392153, 0.4545),
  ('unknown', 'height', 0.392153, 0.434385, 0.8462),
  ('unknown', 'height', 0.434385, 0.665616, 0.5027),
  ('unknown', 'height', 0.665616, 0.714816, 0.4182),
  ('unknown', 'height', 0.714816, 0.834804, 0.7478),
  ('unknown', 'height', 0.834804, 0.962304, 0.8695),
  ('unknown', 'height', 0.962304, 1.03748, 0.5179),
  ('unknown', 'height', 1.03748, 1.25176, 0.3396),
  ('unknown', 'height', 1.25176, 1.36014, 0.3113),
  ('unknown', 'height', 1.36014, 1.55515, 0.3904),
  ('unknown', 'height', 1.55515, 1.68281, 0.3696),
  ('unknown', 'height', 1.68281, 2.00547, 0.1627),
  ('unknown', 'height', 2.00547, 2.08083, 0.1654),
  ('unknown', 'height', 2.08083, 2.32813, 0.1976),
  ('unknown', 'height', 2.32813, 2.6508, 0.1006),
  ('unknown', 'height', 2.6508, 2.97346, 0.0632),
  ('unknown', 'height', 2.97346, 4, 0.00897);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.19168, 0.004374),
  ('unknown', 'length', 0.19168, 0.289428, 0.1514),
  ('unknown', 'length', 0.289428, 0.321711, 0.3889),
  ('unknown', 'length', 0.321711, 0.39819, 0.5151),
  ('unknown', 'length', 0.39819, 0.437022, 0.6012),
  ('unknown', 'length', 0.437022, 0.47899, 0.6092),
  ('unknown', 'length', 0.47899, 0.576653, 0.5952),
  ('unknown', 'length', 0.576653, 0.659883, 0.559),
  ('unknown', 'length', 0.659883, 0.712629, 0.4762),
  ('unknown', 'length', 0.712629, 0.886588, 0.5058),
  ('unknown', 'length', 0.886588, 0.996394, 0.4913),
  ('unknown', 'length', 0.996394, 1.15368, 0.3699),
  ('unknown', 'length', 1.15368, 1.44625, 0.4901),
  ('unknown', 'length', 1.44625, 1.50451, 0.4039),
  ('unknown', 'length', 1.50451, 2.27174, 0.1483),
  ('unknown', 'length', 2.27174, 3.43022, 0.01881),
  ('unknown', 'length', 3.43022, 5.17947, 0.01816),
  ('unknown', 'length', 5.17947, 7.82077, 0.02297),
  ('unknown', 'length', 7.82077, 30, 0.007178);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.334271, 0.02858),
  ('unknown', 'rectangularity', 0.334271, 0.404162, 0.2022),
  ('unknown', 'rectangularity', 0.404162, 0.474053, 0.4024),
  ('unknown', 'rectangularity', 0.474053, 0.540702, 0.8794),
  ('unknown', 'rectangularity', 0.540702, 0.543944, 1.212),
  ('unknown', 'rectangularity', 0.543944, 0.613835, 1.468),
  ('unknown', 'rectangularity', 0.613835, 0.617219, 1.656),
  ('unknown', 'rectangularity', 0.617219, 0.676782, 1.865),
  ('unknown', 'rectangularity', 0.676782, 0.683727, 2.442),
  ('unknown', 'rectangularity', 0.683727, 0.721659, 2.48),
  ('unknown', 'rectangularity', 0.721659, 0.753618, 2.577),
  ('unknown', 'rectangularity', 0.753618, 0.764929, 2.644),
  ('unknown', 'rectangularity', 0.764929, 0.800472, 3.088),
  ('unknown', 'rectangularity', 0.800472, 0.823509, 2.839),
  ('unknown', 'rectangularity', 0.823509, 0.838622, 3.005),
  ('unknown', 'rectangularity', 0.838622, 0.884442, 2.449),
  ('unknown', 'rectangularity', 0.884442, 0.8934, 1.935),
  ('unknown', 'rectangularity', 0.8934, 0.963291, 1.243),
  ('unknown', 'rectangularity', 0.963291, 1, 0.1627);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.168906, 0.002539),
  ('unknown', 'spread_length', 0.168906, 0.257502, 0.1776),
  ('unknown', 'spread_length', 0.257502, 0.273006, 0.4916),
  ('unknown', 'spread_length', 0.273006, 0.32367, 0.6535),
  ('unknown', 'spread_length', 0.32367, 0.383575, 0.6535),
  ('unknown', 'spread_length', 0.383575, 0.392567, 0.4845),
  ('unknown', 'spread_length', 0.392567, 0.468416, 0.5633),
  ('unknown', 'spread_length', 0.468416, 0.598477, 0.4078),
  ('unknown', 'spread_length', 0.598477, 0.615034, 0.4216),
  ('unknown', 'spread_length', 0.615034, 0.776817, 0.4716),
  ('unknown', 'spread_length', 0.776817, 0.912392, 0.4617),
  ('unknown', 'spread_length', 0.912392, 1.01275, 0.374),
  ('unknown', 'spread_length', 1.01275, 1.3, 0.4377),
  ('unknown', 'spread_length', 1.3, 1.39096, 0.4067),
  ('unknown', 'spread_length', 1.39096, 2.12055, 0.1212),
  ('unknown', 'spread_length', 2.12055, 3.23283, 0.01575),
  ('unknown', 'spread_length', 3.23283, 4.92852, 0.0168),
  ('unknown', 'spread_length', 4.92852, 7.51364, 0.02408),
  ('unknown', 'spread_length', 7.51364, 40, 0.005758);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.110948, 0.0009255),
  ('unknown', 'spread_width', 0.110948, 0.157658, 0.3083),
  ('unknown', 'spread_width', 0.157658, 0.167418, 0.6229),
  ('unknown', 'spread_width', 0.167418, 0.186869, 0.6755),
  ('unknown', 'spread_width', 0.186869, 0.208638, 1.009),
  ('unknown', 'spread_width', 0.208638, 0.226785, 1.287),
  ('unknown', 'spread_width', 0.226785, 0.252632, 0.8676),
  ('unknown', 'spread_width', 0.252632, 0.259765, 0.7173),
  ('unknown', 'spread_width', 0.259765, 0.305967, 0.6779),
  ('unknown', 'spread_width', 0.305967, 0.381218, 0.4913),
  ('unknown', 'spread_width', 0.381218, 0.385526, 0.338),
  ('unknown', 'spread_width', 0.385526, 0.553479, 0.3071),
  ('unknown', 'spread_width', 0.553479, 0.575253, 0.248),
  ('unknown', 'spread_width', 0.575253, 0.868048, 0.1594),
  ('unknown', 'spread_width', 0.868048, 1.30987, 0.02012),
  ('unknown', 'spread_width', 1.30987, 1.97658, 0.01362),
  ('unknown', 'spread_width', 1.97658, 2.98263, 0.01271),
  ('unknown', 'spread_width', 2.98263, 4.50074, 0.01762),
  ('unknown', 'spread_width', 4.50074, 20, 0.006129);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 0.741558, 0.145),
  ('unknown', 'tilt_deg', 0.741558, 2.37471, 0.06917),
  ('unknown', 'tilt_deg', 2.37471, 10, 0.009873),
  ('unknown', 'tilt_deg', 10, 20, 0.00117),
  ('unknown', 'tilt_deg', 20, 30, 0.0002375),
  ('unknown', 'tilt_deg', 30, 40, 0.0001106),
  ('unknown', 'tilt_deg', 40, 50, 0.0001088),
  ('unknown', 'tilt_deg', 50, 60, 0.0001335),
  ('unknown', 'tilt_deg', 60, 70, 0.0005026),
  ('unknown', 'tilt_deg', 70, 75.3066, 0.002974),
  ('unknown', 'tilt_deg', 75.3066, 80, 0.004668),
  ('unknown', 'tilt_deg', 80, 88.2074, 0.01094),
  ('unknown', 'tilt_deg', 88.2074, 89.3855, 0.105),
  ('unknown', 'tilt_deg', 89.3855, 89.7565, 0.4764),
  ('unknown', 'tilt_deg', 89.7565, 90, 1.042);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.133688, 0.002735),
  ('unknown', 'width', 0.133688, 0.190629, 0.2931),
  ('unknown', 'width', 0.190629, 0.198532, 0.507),
  ('unknown', 'width', 0.198532, 0.223976, 0.7494),
  ('unknown', 'width', 0.223976, 0.250911, 0.988),
  ('unknown', 'width', 0.250911, 0.290158, 0.764),
  ('unknown', 'width', 0.290158, 0.294829, 0.7638),
  ('unknown', 'width', 0.294829, 0.331316, 0.843),
  ('unknown', 'width', 0.331316, 0.383039, 0.7584),
  ('unknown', 'width', 0.383039, 0.437835, 0.5467),
  ('unknown', 'width', 0.437835, 0.470309, 0.5429),
  ('unknown', 'width', 0.470309, 0.650204, 0.3118),
  ('unknown', 'width', 0.650204, 0.672281, 0.2726),
  ('unknown', 'width', 0.672281, 0.965582, 0.2034),
  ('unknown', 'width', 0.965582, 1.43393, 0.02974),
  ('unknown', 'width', 1.43393, 2.12945, 0.01315),
  ('unknown', 'width', 2.12945, 3.16233, 0.01361),
  ('unknown', 'width', 3.16233, 4.69621, 0.01731),
  ('unknown', 'width', 4.69621, 12, 0.009904);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0826149, 0.009515),
  ('unknown', 'z_max', 0.0826149, 0.431039, 0.3116),
  ('unknown', 'z_max', 0.431039, 0.51788, 0.4891),
  ('unknown', 'z_max', 0.51788, 0.696943, 0.3733),
  ('unknown', 'z_max', 0.696943, 0.795333, 1.094),
  ('unknown', 'z_max', 0.795333, 0.9364, 0.8001),
  ('unknown', 'z_max', 0.9364, 0.953145, 0.6849),
  ('unknown', 'z_max', 0.953145, 1.11219, 0.6298),
  ('unknown', 'z_max', 1.11219, 1.38841, 0.3291),
  ('unknown', 'z_max', 1.38841, 1.51421, 0.1575),
  ('unknown', 'z_max', 1.51421, 1.82367, 0.1932),
  ('unknown', 'z_max', 1.82367, 2.00385, 0.279),
  ('unknown', 'z_max', 2.00385, 2.25894, 0.4281),
  ('unknown', 'z_max', 2.25894, 2.26516, 0.3718),
  ('unknown', 'z_max', 2.26516, 2.6942, 0.1518),
  ('unknown', 'z_max', 2.6942, 3.12947, 0.04767),
  ('unknown', 'z_max', 3.12947, 3.56473, 0.01127),
  ('unknown', 'z_max', 3.56473, 4, 0.04899);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.129026, 0.0544),
  ('unknown', 'z_min', -0.129026, -0.0129915, 0.8041),
  ('unknown', 'z_min', -0.0129915, 0.0836741, 1.144),
  ('unknown', 'z_min', 0.0836741, 0.241948, 0.4758),
  ('unknown', 'z_min', 0.241948, 0.372682, 0.2583),
  ('unknown', 'z_min', 0.372682, 0.612922, 0.2992),
  ('unknown', 'z_min', 0.612922, 0.68377, 0.5662),
  ('unknown', 'z_min', 0.68377, 0.770171, 1.246),
  ('unknown', 'z_min', 0.770171, 0.914838, 0.7708),
  ('unknown', 'z_min', 0.914838, 0.983896, 0.4998),
  ('unknown', 'z_min', 0.983896, 1.21828, 0.3321),
  ('unknown', 'z_min', 1.21828, 1.35487, 0.3521),
  ('unknown', 'z_min', 1.35487, 1.72584, 0.1365),
  ('unknown', 'z_min', 1.72584, 1.91617, 0.0716),
  ('unknown', 'z_min', 1.91617, 2.09682, 0.09772),
  ('unknown', 'z_min', 2.09682, 2.46779, 0.1505),
  ('unknown', 'z_min', 2.46779, 2.83877, 0.07328),
  ('unknown', 'z_min', 2.83877, 4, 0.00883);
DELETE FROM class_kind WHERE class = 'unknown';
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.05393, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'area_m2', -2.572, 0.2416),
  ('unknown', 1, 'aspect', 0.3231, 0.2363),
  ('unknown', 1, 'behind', 0.6663, 0.1657),
  ('unknown', 1, 'edge_free', 0.482, 0.1473),
  ('unknown', 1, 'edge_free_top', 0.7917, 0.2188),
  ('unknown', 1, 'edge_joined', 0.1626, 0.1779),
  ('unknown', 1, 'height', 0.1782, 0.04056),
  ('unknown', 1, 'length', -0.8824, 0.1662),
  ('unknown', 1, 'rectangularity', 0.6284, 0.1235),
  ('unknown', 1, 'spread_length', -1.07, 0.1449),
  ('unknown', 1, 'spread_width', -1.601, 0.1931),
  ('unknown', 1, 'tilt_deg', 88.9, 2.067),
  ('unknown', 1, 'width', -1.205, 0.2117),
  ('unknown', 1, 'z_max', 0.3462, 0.06345),
  ('unknown', 1, 'z_min', -0.009123, 0.0325);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.05012, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'area_m2', -1.961, 0.3437),
  ('unknown', 2, 'aspect', 0.3675, 0.2513),
  ('unknown', 2, 'behind', 0.6557, 0.1671),
  ('unknown', 2, 'edge_free', 0.3856, 0.1879),
  ('unknown', 2, 'edge_free_top', 0.5807, 0.3194),
  ('unknown', 2, 'edge_joined', 0.2191, 0.2459),
  ('unknown', 2, 'height', 0.2379, 0.06522),
  ('unknown', 2, 'length', -0.4969, 0.1781),
  ('unknown', 2, 'rectangularity', 0.5748, 0.1635),
  ('unknown', 2, 'spread_length', -0.6684, 0.1918),
  ('unknown', 2, 'spread_width', -1.213, 0.2964),
  ('unknown', 2, 'tilt_deg', 89.29, 1.73),
  ('unknown', 2, 'width', -0.8644, 0.2076),
  ('unknown', 2, 'z_max', 0.5051, 0.1192),
  ('unknown', 2, 'z_min', -0.007508, 0.03663);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.0391, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'area_m2', -1.832, 0.4077),
  ('unknown', 3, 'aspect', 1.072, 0.5144),
  ('unknown', 3, 'behind', 0.662, 0.1934),
  ('unknown', 3, 'edge_free', 0.3151, 0.1892),
  ('unknown', 3, 'edge_free_top', 0.571, 0.1296),
  ('unknown', 3, 'edge_joined', 0.4991, 0.237),
  ('unknown', 3, 'height', 0.815, 0.2101),
  ('unknown', 3, 'length', -0.1677, 0.2906),
  ('unknown', 3, 'rectangularity', 0.6642, 0.1118),
  ('unknown', 3, 'spread_length', -0.2885, 0.3069),
  ('unknown', 3, 'spread_width', -1.452, 0.3553),
  ('unknown', 3, 'tilt_deg', 5.288, 5.129),
  ('unknown', 3, 'width', -1.24, 0.3682),
  ('unknown', 3, 'z_max', 0.8334, 0.216),
  ('unknown', 3, 'z_min', 0.8012, 0.2097);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.03898, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'area_m2', -2.607, 0.2774),
  ('unknown', 4, 'aspect', 0.5169, 0.3322),
  ('unknown', 4, 'behind', 0.6035, 0.1895),
  ('unknown', 4, 'edge_free', 0.5862, 0.09669),
  ('unknown', 4, 'edge_free_top', 0.9688, 0.05499),
  ('unknown', 4, 'edge_joined', 0.02917, 0.04235),
  ('unknown', 4, 'height', 0.864, 0.05724),
  ('unknown', 4, 'length', -0.8618, 0.2521),
  ('unknown', 4, 'rectangularity', 0.7009, 0.103),
  ('unknown', 4, 'spread_length', -1.202, 0.1597),
  ('unknown', 4, 'spread_width', -1.555, 0.2027),
  ('unknown', 4, 'tilt_deg', 84.06, 7.098),
  ('unknown', 4, 'width', -1.379, 0.2145),
  ('unknown', 4, 'z_max', 0.9879, 0.07704),
  ('unknown', 4, 'z_min', 0.7173, 0.05869);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.0384, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'area_m2', -1.342, 0.4165),
  ('unknown', 5, 'aspect', 0.9658, 0.4718),
  ('unknown', 5, 'behind', 0.7451, 0.08837),
  ('unknown', 5, 'edge_free', 0.105, 0.1019),
  ('unknown', 5, 'edge_free_top', 0.571, 0.1296),
  ('unknown', 5, 'edge_joined', 0.8455, 0.132),
  ('unknown', 5, 'height', 1.133, 0.2157),
  ('unknown', 5, 'length', -0.02834, 0.3528),
  ('unknown', 5, 'rectangularity', 0.7355, 0.1076),
  ('unknown', 5, 'spread_length', -0.1633, 0.34),
  ('unknown', 5, 'spread_width', -1.014, 0.2728),
  ('unknown', 5, 'tilt_deg', 2.927, 2.385),
  ('unknown', 5, 'width', -0.9942, 0.2411),
  ('unknown', 5, 'z_max', 1.145, 0.2194),
  ('unknown', 5, 'z_min', 1.122, 0.2144);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.03474, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'area_m2', -1.32, 0.2794),
  ('unknown', 6, 'aspect', 1.749, 0.2516),
  ('unknown', 6, 'behind', 0.5614, 0.2479),
  ('unknown', 6, 'edge_free', 0.2531, 0.1992),
  ('unknown', 6, 'edge_free_top', 0.01113, 0.0377),
  ('unknown', 6, 'edge_joined', 0.3847, 0.3351),
  ('unknown', 6, 'height', 1.505, 0.09786),
  ('unknown', 6, 'length', 0.336, 0.1298),
  ('unknown', 6, 'rectangularity', 0.7867, 0.06155),
  ('unknown', 6, 'spread_length', 0.1757, 0.1496),
  ('unknown', 6, 'spread_width', -1.539, 0.2692),
  ('unknown', 6, 'tilt_deg', 89.8, 1.759),
  ('unknown', 6, 'width', -1.413, 0.2268),
  ('unknown', 6, 'z_max', 2.24, 0.1607),
  ('unknown', 6, 'z_min', 0.8285, 0.1106);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.03329, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'area_m2', -2.596, 0.3098),
  ('unknown', 7, 'aspect', 0.3227, 0.2202),
  ('unknown', 7, 'behind', 0.3691, 0.2679),
  ('unknown', 7, 'edge_free', 0.5651, 0.2527),
  ('unknown', 7, 'edge_free_top', 0.571, 0.1296),
  ('unknown', 7, 'edge_joined', 0.3642, 0.2292),
  ('unknown', 7, 'height', 0.8865, 0.1157),
  ('unknown', 7, 'length', -1.01, 0.1853),
  ('unknown', 7, 'rectangularity', 0.7832, 0.1003),
  ('unknown', 7, 'spread_length', -1.129, 0.149),
  ('unknown', 7, 'spread_width', -1.492, 0.1993),
  ('unknown', 7, 'tilt_deg', 2.212, 2.687),
  ('unknown', 7, 'width', -1.333, 0.2234),
  ('unknown', 7, 'z_max', 0.894, 0.1213),
  ('unknown', 7, 'z_min', 0.8796, 0.1173);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.03082, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'area_m2', -2.405, 0.2861),
  ('unknown', 8, 'aspect', 0.4425, 0.2637),
  ('unknown', 8, 'behind', 0.6299, 0.2143),
  ('unknown', 8, 'edge_free', 0.3536, 0.1786),
  ('unknown', 8, 'edge_free_top', 0.5377, 0.3046),
  ('unknown', 8, 'edge_joined', 0.376, 0.2651),
  ('unknown', 8, 'height', 0.7975, 0.1488),
  ('unknown', 8, 'length', -0.7777, 0.2175),
  ('unknown', 8, 'rectangularity', 0.6715, 0.08766),
  ('unknown', 8, 'spread_length', -1.034, 0.2034),
  ('unknown', 8, 'spread_width', -1.419, 0.1897),
  ('unknown', 8, 'tilt_deg', 86.25, 5.885),
  ('unknown', 8, 'width', -1.22, 0.1876),
  ('unknown', 8, 'z_max', 0.9738, 0.1608),
  ('unknown', 8, 'z_min', 0.6097, 0.1646);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.03073, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'area_m2', -0.4744, 0.3095),
  ('unknown', 9, 'aspect', 0.4556, 0.2319),
  ('unknown', 9, 'behind', 0.4886, 0.112),
  ('unknown', 9, 'edge_free', 0.8795, 0.1269),
  ('unknown', 9, 'edge_free_top', 0.9914, 0.03),
  ('unknown', 9, 'edge_joined', 0.01993, 0.03498),
  ('unknown', 9, 'height', 0.4798, 0.05643),
  ('unknown', 9, 'length', 0.0762, 0.2262),
  ('unknown', 9, 'rectangularity', 0.8535, 0.1205),
  ('unknown', 9, 'spread_length', 0.007564, 0.2369),
  ('unknown', 9, 'spread_width', -0.4888, 0.1404),
  ('unknown', 9, 'tilt_deg', 89.71, 1.896),
  ('unknown', 9, 'width', -0.3794, 0.1203),
  ('unknown', 9, 'z_max', 0.7838, 0.07549),
  ('unknown', 9, 'z_min', 0.08503, 0.06403);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.03011, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'area_m2', -2.237, 0.2398),
  ('unknown', 10, 'aspect', 0.3353, 0.2045),
  ('unknown', 10, 'behind', 0.5714, 0.2713),
  ('unknown', 10, 'edge_free', 0.4732, 0.1909),
  ('unknown', 10, 'edge_free_top', 0.7406, 0.2306),
  ('unknown', 10, 'edge_joined', 0.2318, 0.2025),
  ('unknown', 10, 'height', 1.19, 0.1899),
  ('unknown', 10, 'length', -0.7538, 0.179),
  ('unknown', 10, 'rectangularity', 0.6814, 0.09844),
  ('unknown', 10, 'spread_length', -1.022, 0.1594),
  ('unknown', 10, 'spread_width', -1.358, 0.163),
  ('unknown', 10, 'tilt_deg', 88.36, 2.925),
  ('unknown', 10, 'width', -1.089, 0.1459),
  ('unknown', 10, 'z_max', 1.401, 0.2091),
  ('unknown', 10, 'z_min', 0.9676, 0.1934);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.03006, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'area_m2', -2.934, 0.3786),
  ('unknown', 11, 'aspect', 0.5147, 0.285),
  ('unknown', 11, 'behind', 0.5876, 0.2505),
  ('unknown', 11, 'edge_free', 0.5486, 0.1998),
  ('unknown', 11, 'edge_free_top', 0.7847, 0.2382),
  ('unknown', 11, 'edge_joined', 0.1268, 0.1399),
  ('unknown', 11, 'height', 0.3483, 0.1396),
  ('unknown', 11, 'length', -1.048, 0.2759),
  ('unknown', 11, 'rectangularity', 0.7342, 0.1147),
  ('unknown', 11, 'spread_length', -1.2, 0.2804),
  ('unknown', 11, 'spread_width', -1.756, 0.2114),
  ('unknown', 11, 'tilt_deg', 43.77, 40.91),
  ('unknown', 11, 'width', -1.563, 0.2083),
  ('unknown', 11, 'z_max', 0.4132, 0.149),
  ('unknown', 11, 'z_min', 0.2747, 0.1716);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.03003, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'area_m2', -1.452, 0.4117),
  ('unknown', 12, 'aspect', 0.5742, 0.3775),
  ('unknown', 12, 'behind', 0.4439, 0.2724),
  ('unknown', 12, 'edge_free', 0.3664, 0.2959),
  ('unknown', 12, 'edge_free_top', 0.4873, 0.3402),
  ('unknown', 12, 'edge_joined', 0.4131, 0.3355),
  ('unknown', 12, 'height', 1.328, 0.1871),
  ('unknown', 12, 'length', -0.2606, 0.2134),
  ('unknown', 12, 'rectangularity', 0.7101, 0.1149),
  ('unknown', 12, 'spread_length', -0.4563, 0.2394),
  ('unknown', 12, 'spread_width', -1.075, 0.3265),
  ('unknown', 12, 'tilt_deg', 88.41, 2.573),
  ('unknown', 12, 'width', -0.8349, 0.3195),
  ('unknown', 12, 'z_max', 1.695, 0.2416),
  ('unknown', 12, 'z_min', 0.9575, 0.2291);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.02665, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'area_m2', -0.8749, 0.2869),
  ('unknown', 13, 'aspect', 0.2367, 0.1674),
  ('unknown', 13, 'behind', 0.6101, 0.2078),
  ('unknown', 13, 'edge_free', 0.3813, 0.2085),
  ('unknown', 13, 'edge_free_top', 0.5389, 0.3466),
  ('unknown', 13, 'edge_joined', 0.327, 0.2724),
  ('unknown', 13, 'height', 0.4042, 0.09547),
  ('unknown', 13, 'length', -0.08922, 0.1602),
  ('unknown', 13, 'rectangularity', 0.6456, 0.1269),
  ('unknown', 13, 'spread_length', -0.2547, 0.1474),
  ('unknown', 13, 'spread_width', -0.6114, 0.1947),
  ('unknown', 13, 'tilt_deg', 89.42, 2.135),
  ('unknown', 13, 'width', -0.326, 0.1278),
  ('unknown', 13, 'z_max', 0.7707, 0.1031),
  ('unknown', 13, 'z_min', 0.006546, 0.06219);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.02633, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'area_m2', -1.625, 0.4185),
  ('unknown', 14, 'aspect', 0.9545, 0.3316),
  ('unknown', 14, 'behind', 0.5335, 0.2387),
  ('unknown', 14, 'edge_free', 0.3557, 0.2142),
  ('unknown', 14, 'edge_free_top', 0.4111, 0.3456),
  ('unknown', 14, 'edge_joined', 0.2136, 0.2611),
  ('unknown', 14, 'height', 0.5187, 0.1581),
  ('unknown', 14, 'length', -0.04645, 0.2377),
  ('unknown', 14, 'rectangularity', 0.5926, 0.1776),
  ('unknown', 14, 'spread_length', -0.166, 0.2688),
  ('unknown', 14, 'spread_width', -1.332, 0.3084),
  ('unknown', 14, 'tilt_deg', 88.87, 2.471),
  ('unknown', 14, 'width', -1.001, 0.295),
  ('unknown', 14, 'z_max', 0.8343, 0.2438),
  ('unknown', 14, 'z_min', 0.1612, 0.1861);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.02547, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'area_m2', -1.531, 0.4063),
  ('unknown', 15, 'aspect', 1.643, 0.2987),
  ('unknown', 15, 'behind', 0.6668, 0.09787),
  ('unknown', 15, 'edge_free', 0.1507, 0.1681),
  ('unknown', 15, 'edge_free_top', 0.571, 0.1296),
  ('unknown', 15, 'edge_joined', 0.7591, 0.2152),
  ('unknown', 15, 'height', 2.132, 0.1418),
  ('unknown', 15, 'length', 0.1894, 0.2662),
  ('unknown', 15, 'rectangularity', 0.7685, 0.06406),
  ('unknown', 15, 'spread_length', 0.05018, 0.2723),
  ('unknown', 15, 'spread_width', -1.525, 0.2435),
  ('unknown', 15, 'tilt_deg', 1.647, 2.431),
  ('unknown', 15, 'width', -1.454, 0.2277),
  ('unknown', 15, 'z_max', 2.137, 0.1469),
  ('unknown', 15, 'z_min', 2.128, 0.1434);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.02523, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'area_m2', -2.795, 0.1887),
  ('unknown', 16, 'aspect', 0.2706, 0.1469),
  ('unknown', 16, 'behind', 0.3912, 0.2017),
  ('unknown', 16, 'edge_free', 0.03688, 0.06687),
  ('unknown', 16, 'edge_free_top', 0.571, 0.1296),
  ('unknown', 16, 'edge_joined', 0.8693, 0.1157),
  ('unknown', 16, 'height', 0.7476, 0.06506),
  ('unknown', 16, 'length', -1.156, 0.1307),
  ('unknown', 16, 'rectangularity', 0.8123, 0.0663),
  ('unknown', 16, 'spread_length', -1.269, 0.1295),
  ('unknown', 16, 'spread_width', -1.581, 0.0923),
  ('unknown', 16, 'tilt_deg', 1.286, 2.296),
  ('unknown', 16, 'width', -1.427, 0.1218),
  ('unknown', 16, 'z_max', 0.7518, 0.07595),
  ('unknown', 16, 'z_min', 0.7435, 0.06806);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.02501, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'area_m2', -1.347, 0.1593),
  ('unknown', 17, 'aspect', 1.752, 0.1379),
  ('unknown', 17, 'behind', 0.2445, 0.2657),
  ('unknown', 17, 'edge_free', 0.9805, 0.03),
  ('unknown', 17, 'edge_free_top', 0.571, 0.1296),
  ('unknown', 17, 'edge_joined', 0.01778, 0.03),
  ('unknown', 17, 'height', 2.547, 0.2905),
  ('unknown', 17, 'length', 0.2683, 0.1282),
  ('unknown', 17, 'rectangularity', 0.8772, 0.03532),
  ('unknown', 17, 'spread_length', 0.2178, 0.1332),
  ('unknown', 17, 'spread_width', -1.567, 0.05324),
  ('unknown', 17, 'tilt_deg', 1.206, 2.223),
  ('unknown', 17, 'width', -1.483, 0.08224),
  ('unknown', 17, 'z_max', 2.55, 0.2932),
  ('unknown', 17, 'z_min', 2.543, 0.291);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.02458, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'area_m2', -0.4312, 0.6663),
  ('unknown', 18, 'aspect', 1.098, 0.6639),
  ('unknown', 18, 'behind', 0.5032, 0.2831),
  ('unknown', 18, 'edge_free', 0.3012, 0.225),
  ('unknown', 18, 'edge_free_top', 0.293, 0.2898),
  ('unknown', 18, 'edge_joined', 0.5171, 0.2977),
  ('unknown', 18, 'height', 1.125, 0.2804),
  ('unknown', 18, 'length', 0.575, 0.2538),
  ('unknown', 18, 'rectangularity', 0.6411, 0.1585),
  ('unknown', 18, 'spread_length', 0.4202, 0.2837),
  ('unknown', 18, 'spread_width', -0.7546, 0.6968),
  ('unknown', 18, 'tilt_deg', 75.88, 30.32),
  ('unknown', 18, 'width', -0.5226, 0.6266),
  ('unknown', 18, 'z_max', 1.789, 0.5534),
  ('unknown', 18, 'z_min', 0.3831, 0.4004);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.02275, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'area_m2', -3.121, 0.3189),
  ('unknown', 19, 'aspect', 0.4202, 0.2972),
  ('unknown', 19, 'behind', 0.4568, 0.2844),
  ('unknown', 19, 'edge_free', 0.6261, 0.1781),
  ('unknown', 19, 'edge_free_top', 0.9884, 0.0335),
  ('unknown', 19, 'edge_joined', 0.02792, 0.04759),
  ('unknown', 19, 'height', 1.048, 0.2179),
  ('unknown', 19, 'length', -1.201, 0.2444),
  ('unknown', 19, 'rectangularity', 0.7528, 0.1188),
  ('unknown', 19, 'spread_length', -1.38, 0.2038),
  ('unknown', 19, 'spread_width', -1.785, 0.1876),
  ('unknown', 19, 'tilt_deg', 88.17, 3.648),
  ('unknown', 19, 'width', -1.622, 0.2146),
  ('unknown', 19, 'z_max', 1.16, 0.2282),
  ('unknown', 19, 'z_min', 0.9132, 0.2241);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.02246, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'area_m2', -1.983, 0.3101),
  ('unknown', 20, 'aspect', 0.2463, 0.1723),
  ('unknown', 20, 'behind', 0.4497, 0.2744),
  ('unknown', 20, 'edge_free', 0.6899, 0.2324),
  ('unknown', 20, 'edge_free_top', 0.571, 0.1296),
  ('unknown', 20, 'edge_joined', 0.1717, 0.1745),
  ('unknown', 20, 'height', 0.3072, 0.1848),
  ('unknown', 20, 'length', -0.7051, 0.1909),
  ('unknown', 20, 'rectangularity', 0.7344, 0.1342),
  ('unknown', 20, 'spread_length', -0.8365, 0.1505),
  ('unknown', 20, 'spread_width', -1.148, 0.2087),
  ('unknown', 20, 'tilt_deg', 1.669, 2.866),
  ('unknown', 20, 'width', -0.9513, 0.222),
  ('unknown', 20, 'z_max', 0.3142, 0.1903),
  ('unknown', 20, 'z_min', 0.3005, 0.1858);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.02218, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'area_m2', -3.175, 0.3516),
  ('unknown', 21, 'aspect', 0.5439, 0.317),
  ('unknown', 21, 'behind', 0.4451, 0.2958),
  ('unknown', 21, 'edge_free', 0.3728, 0.2287),
  ('unknown', 21, 'edge_free_top', 0.4677, 0.3369),
  ('unknown', 21, 'edge_joined', 0.3362, 0.2965),
  ('unknown', 21, 'height', 1.019, 0.2539),
  ('unknown', 21, 'length', -1.155, 0.2651),
  ('unknown', 21, 'rectangularity', 0.7336, 0.108),
  ('unknown', 21, 'spread_length', -1.308, 0.2416),
  ('unknown', 21, 'spread_width', -1.884, 0.1935),
  ('unknown', 21, 'tilt_deg', 63.22, 34.5),
  ('unknown', 21, 'width', -1.699, 0.2307),
  ('unknown', 21, 'z_max', 1.12, 0.2683),
  ('unknown', 21, 'z_min', 0.9148, 0.2601);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.02158, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'area_m2', -1.397, 0.2437),
  ('unknown', 22, 'aspect', 0.4296, 0.2437),
  ('unknown', 22, 'behind', 0.007465, 0.03),
  ('unknown', 22, 'edge_free', 0.02218, 0.03748),
  ('unknown', 22, 'edge_free_top', 0.02356, 0.04863),
  ('unknown', 22, 'edge_joined', 0.9168, 0.1313),
  ('unknown', 22, 'height', 1.593, 0.1042),
  ('unknown', 22, 'length', -0.3752, 0.1918),
  ('unknown', 22, 'rectangularity', 0.8071, 0.05577),
  ('unknown', 22, 'spread_length', -0.5289, 0.2046),
  ('unknown', 22, 'spread_width', -1.05, 0.1759),
  ('unknown', 22, 'tilt_deg', 89.57, 2.248),
  ('unknown', 22, 'width', -0.8048, 0.155),
  ('unknown', 22, 'z_max', 1.91, 0.1661),
  ('unknown', 22, 'z_min', 1.307, 0.09366);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.01969, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'area_m2', -2.836, 0.4714),
  ('unknown', 23, 'aspect', 0.647, 0.3343),
  ('unknown', 23, 'behind', 0.4721, 0.2621),
  ('unknown', 23, 'edge_free', 0.2147, 0.1962),
  ('unknown', 23, 'edge_free_top', 0.0296, 0.05726),
  ('unknown', 23, 'edge_joined', 0.2293, 0.2889),
  ('unknown', 23, 'height', 0.3167, 0.1495),
  ('unknown', 23, 'length', -0.8918, 0.3579),
  ('unknown', 23, 'rectangularity', 0.6822, 0.1364),
  ('unknown', 23, 'spread_length', -1.021, 0.367),
  ('unknown', 23, 'spread_width', -1.759, 0.2398),
  ('unknown', 23, 'tilt_deg', 88.02, 3.431),
  ('unknown', 23, 'width', -1.539, 0.2453),
  ('unknown', 23, 'z_max', 0.4808, 0.1664),
  ('unknown', 23, 'z_min', 0.1444, 0.1613);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.01964, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'area_m2', -1.507, 0.2239),
  ('unknown', 24, 'aspect', 0.3015, 0.2032),
  ('unknown', 24, 'behind', 0.5128, 0.2512),
  ('unknown', 24, 'edge_free', 0.6364, 0.2072),
  ('unknown', 24, 'edge_free_top', 0.8336, 0.2218),
  ('unknown', 24, 'edge_joined', 0.1631, 0.1574),
  ('unknown', 24, 'height', 0.6878, 0.1815),
  ('unknown', 24, 'length', -0.4329, 0.1656),
  ('unknown', 24, 'rectangularity', 0.7216, 0.113),
  ('unknown', 24, 'spread_length', -0.5716, 0.1667),
  ('unknown', 24, 'spread_width', -0.9593, 0.1533),
  ('unknown', 24, 'tilt_deg', 84.71, 6.377),
  ('unknown', 24, 'width', -0.7345, 0.1295),
  ('unknown', 24, 'z_max', 0.9329, 0.1877),
  ('unknown', 24, 'z_min', 0.3431, 0.1938);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.01943, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'area_m2', -2.171, 0.3906),
  ('unknown', 25, 'aspect', 0.6301, 0.2807),
  ('unknown', 25, 'behind', 0.4639, 0.2337),
  ('unknown', 25, 'edge_free', 0.7534, 0.2151),
  ('unknown', 25, 'edge_free_top', 0.9896, 0.03135),
  ('unknown', 25, 'edge_joined', 0.01776, 0.03527),
  ('unknown', 25, 'height', 0.7086, 0.2558),
  ('unknown', 25, 'length', -0.5561, 0.2093),
  ('unknown', 25, 'rectangularity', 0.6668, 0.1363),
  ('unknown', 25, 'spread_length', -0.7583, 0.2633),
  ('unknown', 25, 'spread_width', -1.418, 0.2447),
  ('unknown', 25, 'tilt_deg', 86.52, 5.821),
  ('unknown', 25, 'width', -1.186, 0.2282),
  ('unknown', 25, 'z_max', 0.8991, 0.2563),
  ('unknown', 25, 'z_min', 0.4311, 0.2779);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.01892, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'area_m2', -2.452, 0.3746),
  ('unknown', 26, 'aspect', 0.6558, 0.3407),
  ('unknown', 26, 'behind', 0.6309, 0.2111),
  ('unknown', 26, 'edge_free', 0.3341, 0.1653),
  ('unknown', 26, 'edge_free_top', 0.5674, 0.3081),
  ('unknown', 26, 'edge_joined', 0.4183, 0.2348),
  ('unknown', 26, 'height', 1.951, 0.2142),
  ('unknown', 26, 'length', -0.6799, 0.2506),
  ('unknown', 26, 'rectangularity', 0.656, 0.1093),
  ('unknown', 26, 'spread_length', -0.9005, 0.2611),
  ('unknown', 26, 'spread_width', -1.551, 0.2687),
  ('unknown', 26, 'tilt_deg', 53.59, 41.75),
  ('unknown', 26, 'width', -1.336, 0.2485),
  ('unknown', 26, 'z_max', 2.079, 0.1848),
  ('unknown', 26, 'z_min', 1.818, 0.286);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.01848, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'area_m2', -1.289, 0.1495),
  ('unknown', 27, 'aspect', 1.724, 0.1453),
  ('unknown', 27, 'behind', 0.3497, 0.2814),
  ('unknown', 27, 'edge_free', 0.7621, 0.1164),
  ('unknown', 27, 'edge_free_top', 0.571, 0.1296),
  ('unknown', 27, 'edge_joined', 0.228, 0.1151),
  ('unknown', 27, 'height', 2.414, 0.2268),
  ('unknown', 27, 'length', 0.3004, 0.1153),
  ('unknown', 27, 'rectangularity', 0.8481, 0.04308),
  ('unknown', 27, 'spread_length', 0.2656, 0.1309),
  ('unknown', 27, 'spread_width', -1.52, 0.05469),
  ('unknown', 27, 'tilt_deg', 2.01, 2.606),
  ('unknown', 27, 'width', -1.423, 0.09887),
  ('unknown', 27, 'z_max', 2.419, 0.2308),
  ('unknown', 27, 'z_min', 2.407, 0.2287);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.01778, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'area_m2', -2.406, 0.5622),
  ('unknown', 28, 'aspect', 0.8991, 0.4177),
  ('unknown', 28, 'behind', 0.3122, 0.2754),
  ('unknown', 28, 'edge_free', 0.9622, 0.07413),
  ('unknown', 28, 'edge_free_top', 0.571, 0.1296),
  ('unknown', 28, 'edge_joined', 0.0226, 0.0458),
  ('unknown', 28, 'height', 2.477, 0.3021),
  ('unknown', 28, 'length', -0.6271, 0.451),
  ('unknown', 28, 'rectangularity', 0.7842, 0.1032),
  ('unknown', 28, 'spread_length', -0.7352, 0.4437),
  ('unknown', 28, 'spread_width', -1.647, 0.1507),
  ('unknown', 28, 'tilt_deg', 1.994, 3.049),
  ('unknown', 28, 'width', -1.526, 0.1225),
  ('unknown', 28, 'z_max', 2.483, 0.3057),
  ('unknown', 28, 'z_min', 2.471, 0.3029);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.01745, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'area_m2', -2.988, 0.3969),
  ('unknown', 29, 'aspect', 0.3494, 0.2151),
  ('unknown', 29, 'behind', 0.3864, 0.2872),
  ('unknown', 29, 'edge_free', 0.6255, 0.1712),
  ('unknown', 29, 'edge_free_top', 0.9477, 0.08427),
  ('unknown', 29, 'edge_joined', 0.05071, 0.08745),
  ('unknown', 29, 'height', 1.862, 0.1691),
  ('unknown', 29, 'length', -1.156, 0.2643),
  ('unknown', 29, 'rectangularity', 0.7362, 0.137),
  ('unknown', 29, 'spread_length', -1.35, 0.21),
  ('unknown', 29, 'spread_width', -1.709, 0.1985),
  ('unknown', 29, 'tilt_deg', 88.7, 2.794),
  ('unknown', 29, 'width', -1.506, 0.2776),
  ('unknown', 29, 'z_max', 1.99, 0.1749),
  ('unknown', 29, 'z_min', 1.707, 0.1871);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.01692, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'area_m2', -2.357, 0.3961),
  ('unknown', 30, 'aspect', 0.5671, 0.3913),
  ('unknown', 30, 'behind', 0.007229, 0.03),
  ('unknown', 30, 'edge_free', 0.01208, 0.03),
  ('unknown', 30, 'edge_free_top', 0.01076, 0.03584),
  ('unknown', 30, 'edge_joined', 0.8145, 0.2176),
  ('unknown', 30, 'height', 1.622, 0.2206),
  ('unknown', 30, 'length', -0.7514, 0.309),
  ('unknown', 30, 'rectangularity', 0.7551, 0.08045),
  ('unknown', 30, 'spread_length', -0.9102, 0.3236),
  ('unknown', 30, 'spread_width', -1.576, 0.2695),
  ('unknown', 30, 'tilt_deg', 89.16, 2.63),
  ('unknown', 30, 'width', -1.318, 0.2544),
  ('unknown', 30, 'z_max', 1.868, 0.2185),
  ('unknown', 30, 'z_min', 1.415, 0.2526);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.01655, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'area_m2', 3.34, 0.7147),
  ('unknown', 31, 'aspect', 0.3268, 0.2359),
  ('unknown', 31, 'behind', 0.00615, 0.03),
  ('unknown', 31, 'edge_free', 0.005425, 0.03),
  ('unknown', 31, 'edge_free_top', 0.00719, 0.03),
  ('unknown', 31, 'edge_joined', 0.04349, 0.07508),
  ('unknown', 31, 'height', 2.213, 0.7809),
  ('unknown', 31, 'length', 1.905, 0.3792),
  ('unknown', 31, 'rectangularity', 0.8761, 0.1048),
  ('unknown', 31, 'spread_length', 1.869, 0.3529),
  ('unknown', 31, 'spread_width', 1.523, 0.3492),
  ('unknown', 31, 'tilt_deg', 89.7, 2.534),
  ('unknown', 31, 'width', 1.578, 0.383),
  ('unknown', 31, 'z_max', 5.649, 2.029),
  ('unknown', 31, 'z_min', -0.8987, 1.248);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.0164, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'area_m2', -2.302, 0.297),
  ('unknown', 32, 'aspect', 1.524, 0.2568),
  ('unknown', 32, 'behind', 0.4607, 0.3191),
  ('unknown', 32, 'edge_free', 0.3305, 0.2655),
  ('unknown', 32, 'edge_free_top', 0.5166, 0.382),
  ('unknown', 32, 'edge_joined', 0.3448, 0.3363),
  ('unknown', 32, 'height', 0.8264, 0.4507),
  ('unknown', 32, 'length', -0.2207, 0.2059),
  ('unknown', 32, 'rectangularity', 0.7244, 0.1109),
  ('unknown', 32, 'spread_length', -0.3781, 0.2608),
  ('unknown', 32, 'spread_width', -1.955, 0.1676),
  ('unknown', 32, 'tilt_deg', 88.33, 4.096),
  ('unknown', 32, 'width', -1.745, 0.1678),
  ('unknown', 32, 'z_max', 1.123, 0.5328),
  ('unknown', 32, 'z_min', 0.5107, 0.4407);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.01537, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'area_m2', -0.3971, 0.3017),
  ('unknown', 33, 'aspect', 0.4172, 0.2366),
  ('unknown', 33, 'behind', 0.4117, 0.1712),
  ('unknown', 33, 'edge_free', 0.5883, 0.1703),
  ('unknown', 33, 'edge_free_top', 0.8469, 0.1516),
  ('unknown', 33, 'edge_joined', 0.1328, 0.1403),
  ('unknown', 33, 'height', 0.5884, 0.2007),
  ('unknown', 33, 'length', 0.16, 0.177),
  ('unknown', 33, 'rectangularity', 0.7496, 0.1073),
  ('unknown', 33, 'spread_length', 0.008928, 0.1754),
  ('unknown', 33, 'spread_width', -0.4782, 0.2261),
  ('unknown', 33, 'tilt_deg', 84.1, 7.293),
  ('unknown', 33, 'width', -0.2572, 0.193),
  ('unknown', 33, 'z_max', 1.004, 0.2694),
  ('unknown', 33, 'z_min', 0.06059, 0.1591);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.01343, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'area_m2', -3.568, 0.3055),
  ('unknown', 34, 'aspect', 0.2079, 0.1695),
  ('unknown', 34, 'behind', 0.2624, 0.2028),
  ('unknown', 34, 'edge_free', 0.3459, 0.331),
  ('unknown', 34, 'edge_free_top', 0.571, 0.1296),
  ('unknown', 34, 'edge_joined', 0.5328, 0.3509),
  ('unknown', 34, 'height', 0.7964, 0.09425),
  ('unknown', 34, 'length', -1.558, 0.1859),
  ('unknown', 34, 'rectangularity', 0.7883, 0.07828),
  ('unknown', 34, 'spread_length', -1.658, 0.1775),
  ('unknown', 34, 'spread_width', -1.891, 0.1367),
  ('unknown', 34, 'tilt_deg', 5.987, 6.787),
  ('unknown', 34, 'width', -1.766, 0.148),
  ('unknown', 34, 'z_max', 0.8103, 0.1099),
  ('unknown', 34, 'z_min', 0.7849, 0.09781);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.01343, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'area_m2', -0.7771, 0.1916),
  ('unknown', 35, 'aspect', 0.2219, 0.1518),
  ('unknown', 35, 'behind', 0.01013, 0.03),
  ('unknown', 35, 'edge_free', 0.0313, 0.04216),
  ('unknown', 35, 'edge_free_top', 0.02805, 0.04898),
  ('unknown', 35, 'edge_joined', 0.8897, 0.1104),
  ('unknown', 35, 'height', 1.649, 0.1033),
  ('unknown', 35, 'length', -0.1841, 0.1139),
  ('unknown', 35, 'rectangularity', 0.8322, 0.06045),
  ('unknown', 35, 'spread_length', -0.3226, 0.1258),
  ('unknown', 35, 'spread_width', -0.6197, 0.1508),
  ('unknown', 35, 'tilt_deg', 89.55, 2.81),
  ('unknown', 35, 'width', -0.406, 0.1274),
  ('unknown', 35, 'z_max', 2.036, 0.1408),
  ('unknown', 35, 'z_min', 1.297, 0.09539);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.01254, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'area_m2', -0.9054, 0.2977),
  ('unknown', 36, 'aspect', 1.147, 0.2503),
  ('unknown', 36, 'behind', 0.4467, 0.2431),
  ('unknown', 36, 'edge_free', 0.4992, 0.1577),
  ('unknown', 36, 'edge_free_top', 0.8544, 0.1961),
  ('unknown', 36, 'edge_joined', 0.0236, 0.04064),
  ('unknown', 36, 'height', 0.9466, 0.08707),
  ('unknown', 36, 'length', 0.2999, 0.1929),
  ('unknown', 36, 'rectangularity', 0.7124, 0.1288),
  ('unknown', 36, 'spread_length', 0.1552, 0.2393),
  ('unknown', 36, 'spread_width', -1.016, 0.1989),
  ('unknown', 36, 'tilt_deg', 89.01, 3.391),
  ('unknown', 36, 'width', -0.8473, 0.2003),
  ('unknown', 36, 'z_max', 1.149, 0.1157),
  ('unknown', 36, 'z_min', 0.6935, 0.08729);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.01216, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'area_m2', 1.731, 0.8264),
  ('unknown', 37, 'aspect', 1.14, 0.7063),
  ('unknown', 37, 'behind', 0.01027, 0.03),
  ('unknown', 37, 'edge_free', 0.0168, 0.05058),
  ('unknown', 37, 'edge_free_top', 0.0161, 0.04218),
  ('unknown', 37, 'edge_joined', 0.1659, 0.2215),
  ('unknown', 37, 'height', 1.625, 1.197),
  ('unknown', 37, 'length', 1.569, 0.5719),
  ('unknown', 37, 'rectangularity', 0.7841, 0.1536),
  ('unknown', 37, 'spread_length', 1.533, 0.5456),
  ('unknown', 37, 'spread_width', 0.3807, 0.5093),
  ('unknown', 37, 'tilt_deg', 89.51, 2.958),
  ('unknown', 37, 'width', 0.429, 0.5311),
  ('unknown', 37, 'z_max', 4.018, 2.686),
  ('unknown', 37, 'z_min', -0.5466, 1.472);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.01041, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'area_m2', -0.5717, 0.3292),
  ('unknown', 38, 'aspect', 0.4428, 0.1937),
  ('unknown', 38, 'behind', 0.0426, 0.08785),
  ('unknown', 38, 'edge_free', 0.8908, 0.1192),
  ('unknown', 38, 'edge_free_top', 0.9685, 0.07137),
  ('unknown', 38, 'edge_joined', 0.03418, 0.0612),
  ('unknown', 38, 'height', 1.652, 0.1128),
  ('unknown', 38, 'length', 0.03719, 0.2009),
  ('unknown', 38, 'rectangularity', 0.8258, 0.115),
  ('unknown', 38, 'spread_length', -0.03904, 0.199),
  ('unknown', 38, 'spread_width', -0.5687, 0.1597),
  ('unknown', 38, 'tilt_deg', 89.15, 3.32),
  ('unknown', 38, 'width', -0.4056, 0.1735),
  ('unknown', 38, 'z_max', 2.026, 0.1308),
  ('unknown', 38, 'z_min', 1.322, 0.1697);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.004964, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'area_m2', -1.066, 0.6013),
  ('unknown', 39, 'aspect', 1.623, 0.4502),
  ('unknown', 39, 'behind', 0.6117, 0.168),
  ('unknown', 39, 'edge_free', 0.3563, 0.1929),
  ('unknown', 39, 'edge_free_top', 0.04508, 0.0769),
  ('unknown', 39, 'edge_joined', 0.3926, 0.3224),
  ('unknown', 39, 'height', 2.885, 0.3794),
  ('unknown', 39, 'length', 0.4276, 0.4266),
  ('unknown', 39, 'rectangularity', 0.7494, 0.0887),
  ('unknown', 39, 'spread_length', 0.3337, 0.4069),
  ('unknown', 39, 'spread_width', -1.405, 0.3509),
  ('unknown', 39, 'tilt_deg', 75.23, 26.49),
  ('unknown', 39, 'width', -1.196, 0.2921),
  ('unknown', 39, 'z_max', 3.044, 0.404),
  ('unknown', 39, 'z_min', 2.752, 0.3646);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.003882, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'area_m2', -1.247, 0.2481),
  ('unknown', 40, 'aspect', 1.101, 0.2354),
  ('unknown', 40, 'behind', 0.6787, 0.06521),
  ('unknown', 40, 'edge_free', 0.7556, 0.06785),
  ('unknown', 40, 'edge_free_top', 0.6995, 0.1294),
  ('unknown', 40, 'edge_joined', 0.1944, 0.08231),
  ('unknown', 40, 'height', 2.326, 0.1984),
  ('unknown', 40, 'length', 0.2907, 0.1856),
  ('unknown', 40, 'rectangularity', 0.4986, 0.1084),
  ('unknown', 40, 'spread_length', 0.1991, 0.2218),
  ('unknown', 40, 'spread_width', -1.482, 0.1203),
  ('unknown', 40, 'tilt_deg', 7.354, 17.47),
  ('unknown', 40, 'width', -0.8108, 0.2234),
  ('unknown', 40, 'z_max', 2.36, 0.2444),
  ('unknown', 40, 'z_min', 2.305, 0.2051);

-- floor: 410 examples
UPDATE object_class SET prior = 0.03072 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.051, 1.74)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4739, 0.3821)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_joined', 0.2416, 0.162)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.0005117, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.043, 0.8293)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5917, 0.1351)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.7916, 0.7571)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.1933, 0.9206)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.6831, 1.027)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.5638, 1.011)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.007726, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.006824, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'floor';
DELETE FROM class_density WHERE class = 'floor';
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.2424, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'area_m2', 2.51, 0.3017),
  ('floor', 1, 'aspect', 0.2535, 0.1581),
  ('floor', 1, 'behind', 0, 0.03),
  ('floor', 1, 'edge_free', 6.183e-08, 0.03),
  ('floor', 1, 'edge_free_top', 0, 0.3162),
  ('floor', 1, 'edge_joined', 0.2835, 0.1226),
  ('floor', 1, 'height', 5.905e-06, 0.0225),
  ('floor', 1, 'length', 1.705, 0.137),
  ('floor', 1, 'rectangularity', 0.5407, 0.1287),
  ('floor', 1, 'spread_length', 1.373, 0.1266),
  ('floor', 1, 'spread_width', 0.94, 0.1525),
  ('floor', 1, 'tilt_deg', 0.01117, 0.45),
  ('floor', 1, 'width', 1.451, 0.1367),
  ('floor', 1, 'z_max', 0.0002634, 0.0225),
  ('floor', 1, 'z_min', -0.0002902, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.1391, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'area_m2', 2.2, 0.2186),
  ('floor', 2, 'aspect', 0.1714, 0.1144),
  ('floor', 2, 'behind', 0, 0.03),
  ('floor', 2, 'edge_free', 5.285e-06, 0.03),
  ('floor', 2, 'edge_free_top', 0, 0.3162),
  ('floor', 2, 'edge_joined', 0.3399, 0.08882),
  ('floor', 2, 'height', 3.659e-05, 0.0225),
  ('floor', 2, 'length', 1.4, 0.1017),
  ('floor', 2, 'rectangularity', 0.6599, 0.0976),
  ('floor', 2, 'spread_length', 1.151, 0.1064),
  ('floor', 2, 'spread_width', 0.8379, 0.1417),
  ('floor', 2, 'tilt_deg', 0.04106, 0.45),
  ('floor', 2, 'width', 1.228, 0.1438),
  ('floor', 2, 'z_max', 0.000988, 0.0225),
  ('floor', 2, 'z_min', -0.001203, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.1056, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'area_m2', 1.972, 0.5036),
  ('floor', 3, 'aspect', 0.79, 0.1404),
  ('floor', 3, 'behind', 0, 0.03),
  ('floor', 3, 'edge_free', 1.292e-07, 0.03),
  ('floor', 3, 'edge_free_top', 0, 0.3162),
  ('floor', 3, 'edge_joined', 0.2458, 0.1233),
  ('floor', 3, 'height', 1.089e-05, 0.0225),
  ('floor', 3, 'length', 1.736, 0.2268),
  ('floor', 3, 'rectangularity', 0.5079, 0.1152),
  ('floor', 3, 'spread_length', 1.374, 0.1717),
  ('floor', 3, 'spread_width', 0.5743, 0.2118),
  ('floor', 3, 'tilt_deg', 0.05359, 0.45),
  ('floor', 3, 'width', 0.9462, 0.2391),
  ('floor', 3, 'z_max', 0.001012, 0.0225),
  ('floor', 3, 'z_min', -0.001357, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.1019, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'area_m2', -1.017, 0.3737),
  ('floor', 4, 'aspect', 0.7069, 0.3947),
  ('floor', 4, 'behind', 0, 0.03),
  ('floor', 4, 'edge_free', 1.34e-07, 0.03),
  ('floor', 4, 'edge_free_top', 0, 0.3162),
  ('floor', 4, 'edge_joined', 0.2111, 0.1874),
  ('floor', 4, 'height', 0.005295, 0.0225),
  ('floor', 4, 'length', 0.0627, 0.2436),
  ('floor', 4, 'rectangularity', 0.66, 0.1203),
  ('floor', 4, 'spread_length', -0.09263, 0.2372),
  ('floor', 4, 'spread_width', -0.8792, 0.2796),
  ('floor', 4, 'tilt_deg', 1.86, 0.977),
  ('floor', 4, 'width', -0.6442, 0.2785),
  ('floor', 4, 'z_max', 0.02047, 0.0225),
  ('floor', 4, 'z_min', -0.008364, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.09397, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'area_m2', 1.704, 0.2553),
  ('floor', 5, 'aspect', 0.316, 0.1741),
  ('floor', 5, 'behind', 0, 0.03),
  ('floor', 5, 'edge_free', 1.575e-07, 0.03),
  ('floor', 5, 'edge_free_top', 0, 0.3162),
  ('floor', 5, 'edge_joined', 0.1813, 0.06757),
  ('floor', 5, 'height', -0.0003468, 0.0225),
  ('floor', 5, 'length', 1.345, 0.1547),
  ('floor', 5, 'rectangularity', 0.5177, 0.0767),
  ('floor', 5, 'spread_length', 1.106, 0.1508),
  ('floor', 5, 'spread_width', 0.6238, 0.1485),
  ('floor', 5, 'tilt_deg', 0.1078, 0.45),
  ('floor', 5, 'width', 1.029, 0.1732),
  ('floor', 5, 'z_max', 0.002814, 0.0225),
  ('floor', 5, 'z_min', -0.002828, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.09008, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'area_m2', 0.05382, 0.3788),
  ('floor', 6, 'aspect', 0.7505, 0.449),
  ('floor', 6, 'behind', 0, 0.03),
  ('floor', 6, 'edge_free', 1.515e-07, 0.03),
  ('floor', 6, 'edge_free_top', 0, 0.3162),
  ('floor', 6, 'edge_joined', 0.1562, 0.1367),
  ('floor', 6, 'height', 0.002508, 0.0225),
  ('floor', 6, 'length', 0.637, 0.231),
  ('floor', 6, 'rectangularity', 0.6376, 0.1144),
  ('floor', 6, 'spread_length', 0.4691, 0.1969),
  ('floor', 6, 'spread_width', -0.3762, 0.3317),
  ('floor', 6, 'tilt_deg', 1.412, 0.806),
  ('floor', 6, 'width', -0.1135, 0.3369),
  ('floor', 6, 'z_max', 0.01946, 0.0225),
  ('floor', 6, 'z_min', -0.01589, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.08564, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'area_m2', -2.444, 0.6284),
  ('floor', 7, 'aspect', 0.6404, 0.3477),
  ('floor', 7, 'behind', 0, 0.03),
  ('floor', 7, 'edge_free', 1.594e-07, 0.03),
  ('floor', 7, 'edge_free_top', 0, 0.3162),
  ('floor', 7, 'edge_joined', 0.2926, 0.3033),
  ('floor', 7, 'height', 0.004375, 0.02301),
  ('floor', 7, 'length', -0.7006, 0.3696),
  ('floor', 7, 'rectangularity', 0.6858, 0.1383),
  ('floor', 7, 'spread_length', -0.8355, 0.3561),
  ('floor', 7, 'spread_width', -1.562, 0.3431),
  ('floor', 7, 'tilt_deg', 1.599, 0.8466),
  ('floor', 7, 'width', -1.341, 0.3479),
  ('floor', 7, 'z_max', 0.00977, 0.02382),
  ('floor', 7, 'z_min', -0.0009086, 0.02269);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.05995, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'area_m2', 1.226, 0.5501),
  ('floor', 8, 'aspect', 0.4447, 0.255),
  ('floor', 8, 'behind', 0, 0.03),
  ('floor', 8, 'edge_free', 8.15e-05, 0.03),
  ('floor', 8, 'edge_free_top', 0, 0.3162),
  ('floor', 8, 'edge_joined', 0.1552, 0.0696),
  ('floor', 8, 'height', 0.0034, 0.0225),
  ('floor', 8, 'length', 1.123, 0.2305),
  ('floor', 8, 'rectangularity', 0.5683, 0.07728),
  ('floor', 8, 'spread_length', 0.891, 0.1767),
  ('floor', 8, 'spread_width', 0.3458, 0.3323),
  ('floor', 8, 'tilt_deg', 1.488, 0.5966),
  ('floor', 8, 'width', 0.6787, 0.3219),
  ('floor', 8, 'z_max', 0.04089, 0.02698),
  ('floor', 8, 'z_min', -0.03601, 0.02444);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.03138, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'area_m2', -1.682, 0.7679),
  ('floor', 9, 'aspect', 1.046, 0.5937),
  ('floor', 9, 'behind', 0, 0.03),
  ('floor', 9, 'edge_free', 4.35e-07, 0.03),
  ('floor', 9, 'edge_free_top', 0, 0.3162),
  ('floor', 9, 'edge_joined', 0.06737, 0.09282),
  ('floor', 9, 'height', -0.2092, 0.3163),
  ('floor', 9, 'length', -0.03972, 0.496),
  ('floor', 9, 'rectangularity', 0.6027, 0.1598),
  ('floor', 9, 'spread_length', -0.1939, 0.4666),
  ('floor', 9, 'spread_width', -1.379, 0.4761),
  ('floor', 9, 'tilt_deg', 2.762, 1.151),
  ('floor', 9, 'width', -1.086, 0.5156),
  ('floor', 9, 'z_max', -0.1936, 0.3225),
  ('floor', 9, 'z_min', -0.2232, 0.3115);

-- ceiling: 318 examples
UPDATE object_class SET prior = 0.02383 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.62, 1.594)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4036, 0.3678)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.01737, 0.07629)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.01583, 0.07232)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_joined', 0.4507, 0.2166)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.861, 0.3463)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.217, 0.7164)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6759, 0.1294)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.093, 0.71)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.5239, 0.8535)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.06569, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.8117, 0.9008)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.862, 0.3466)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.861, 0.3461)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'ceiling';
DELETE FROM class_density WHERE class = 'ceiling';
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.2332, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'area_m2', 2.673, 0.2677),
  ('ceiling', 1, 'aspect', 0.2223, 0.1373),
  ('ceiling', 1, 'behind', 0.000231, 0.03),
  ('ceiling', 1, 'edge_free', 0.0002007, 0.03),
  ('ceiling', 1, 'edge_free_top', 0, 0.3162),
  ('ceiling', 1, 'edge_joined', 0.5461, 0.1346),
  ('ceiling', 1, 'height', 2.831, 0.1216),
  ('ceiling', 1, 'length', 1.645, 0.1159),
  ('ceiling', 1, 'rectangularity', 0.6838, 0.119),
  ('ceiling', 1, 'spread_length', 1.532, 0.118),
  ('ceiling', 1, 'spread_width', 1.102, 0.137),
  ('ceiling', 1, 'tilt_deg', 0.004137, 0.45),
  ('ceiling', 1, 'width', 1.423, 0.122),
  ('ceiling', 1, 'z_max', 2.831, 0.1216),
  ('ceiling', 1, 'z_min', 2.831, 0.1216);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1787, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'area_m2', 2.594, 0.343),
  ('ceiling', 2, 'aspect', 0.2096, 0.1556),
  ('ceiling', 2, 'behind', 0.0003015, 0.03),
  ('ceiling', 2, 'edge_free', 0.000262, 0.03),
  ('ceiling', 2, 'edge_free_top', 0, 0.3162),
  ('ceiling', 2, 'edge_joined', 0.6291, 0.1563),
  ('ceiling', 2, 'height', 2.505, 0.06667),
  ('ceiling', 2, 'length', 1.586, 0.173),
  ('ceiling', 2, 'rectangularity', 0.7032, 0.1262),
  ('ceiling', 2, 'spread_length', 1.443, 0.1628),
  ('ceiling', 2, 'spread_width', 1.052, 0.1762),
  ('ceiling', 2, 'tilt_deg', 0.005315, 0.45),
  ('ceiling', 2, 'width', 1.377, 0.147),
  ('ceiling', 2, 'z_max', 2.505, 0.06666),
  ('ceiling', 2, 'z_min', 2.505, 0.06668);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.1387, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'area_m2', 2.108, 0.2872),
  ('ceiling', 3, 'aspect', 0.3999, 0.2804),
  ('ceiling', 3, 'behind', 0.0003883, 0.03),
  ('ceiling', 3, 'edge_free', 0.0003373, 0.03),
  ('ceiling', 3, 'edge_free_top', 0, 0.3162),
  ('ceiling', 3, 'edge_joined', 0.391, 0.1192),
  ('ceiling', 3, 'height', 3.01, 0.08164),
  ('ceiling', 3, 'length', 1.475, 0.1931),
  ('ceiling', 3, 'rectangularity', 0.6558, 0.13),
  ('ceiling', 3, 'spread_length', 1.355, 0.139),
  ('ceiling', 3, 'spread_width', 0.775, 0.1946),
  ('ceiling', 3, 'tilt_deg', 0.008237, 0.45),
  ('ceiling', 3, 'width', 1.076, 0.2139),
  ('ceiling', 3, 'z_max', 3.01, 0.08163),
  ('ceiling', 3, 'z_min', 3.01, 0.0817);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.1017, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'area_m2', -1.739, 0.9191),
  ('ceiling', 4, 'aspect', 0.6491, 0.4374),
  ('ceiling', 4, 'behind', 0.001392, 0.03),
  ('ceiling', 4, 'edge_free', 0.0008839, 0.03),
  ('ceiling', 4, 'edge_free_top', 0, 0.3162),
  ('ceiling', 4, 'edge_joined', 0.2623, 0.1466),
  ('ceiling', 4, 'height', 3.136, 0.3418),
  ('ceiling', 4, 'length', -0.2985, 0.5085),
  ('ceiling', 4, 'rectangularity', 0.6205, 0.1048),
  ('ceiling', 4, 'spread_length', -0.4367, 0.499),
  ('ceiling', 4, 'spread_width', -1.173, 0.4509),
  ('ceiling', 4, 'tilt_deg', 0.5513, 0.7373),
  ('ceiling', 4, 'width', -0.9476, 0.4676),
  ('ceiling', 4, 'z_max', 3.138, 0.3423),
  ('ceiling', 4, 'z_min', 3.134, 0.3415);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.0859, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'area_m2', 2.088, 0.3098),
  ('ceiling', 5, 'aspect', 0.3387, 0.232),
  ('ceiling', 5, 'behind', 0.0006271, 0.03),
  ('ceiling', 5, 'edge_free', 0.0005448, 0.03),
  ('ceiling', 5, 'edge_free_top', 0, 0.3162),
  ('ceiling', 5, 'edge_joined', 0.564, 0.1625),
  ('ceiling', 5, 'height', 2.658, 0.07242),
  ('ceiling', 5, 'length', 1.441, 0.1488),
  ('ceiling', 5, 'rectangularity', 0.6467, 0.1215),
  ('ceiling', 5, 'spread_length', 1.311, 0.1199),
  ('ceiling', 5, 'spread_width', 0.7903, 0.1913),
  ('ceiling', 5, 'tilt_deg', 0.00767, 0.45),
  ('ceiling', 5, 'width', 1.102, 0.2123),
  ('ceiling', 5, 'z_max', 2.658, 0.07245),
  ('ceiling', 5, 'z_min', 2.658, 0.07239);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.06374, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'area_m2', -0.7478, 0.6252),
  ('ceiling', 6, 'aspect', 0.9066, 0.4252),
  ('ceiling', 6, 'behind', 0.004444, 0.03),
  ('ceiling', 6, 'edge_free', 0.0007343, 0.03),
  ('ceiling', 6, 'edge_free_top', 0, 0.3162),
  ('ceiling', 6, 'edge_joined', 0.4102, 0.2392),
  ('ceiling', 6, 'height', 2.505, 0.06235),
  ('ceiling', 6, 'length', 0.2411, 0.3965),
  ('ceiling', 6, 'rectangularity', 0.7342, 0.1124),
  ('ceiling', 6, 'spread_length', 0.1488, 0.3758),
  ('ceiling', 6, 'spread_width', -0.8199, 0.3245),
  ('ceiling', 6, 'tilt_deg', 0.1484, 0.45),
  ('ceiling', 6, 'width', -0.6655, 0.3705),
  ('ceiling', 6, 'z_max', 2.505, 0.06239),
  ('ceiling', 6, 'z_min', 2.504, 0.06238);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.0547, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'area_m2', 1.403, 0.8882),
  ('ceiling', 7, 'aspect', 0.4955, 0.2696),
  ('ceiling', 7, 'behind', 0.0009848, 0.03),
  ('ceiling', 7, 'edge_free', 0.0008556, 0.03),
  ('ceiling', 7, 'edge_free_top', 0, 0.3162),
  ('ceiling', 7, 'edge_joined', 0.1427, 0.06685),
  ('ceiling', 7, 'height', 3.613, 0.152),
  ('ceiling', 7, 'length', 1.181, 0.4395),
  ('ceiling', 7, 'rectangularity', 0.6376, 0.09881),
  ('ceiling', 7, 'spread_length', 1.049, 0.4298),
  ('ceiling', 7, 'spread_width', 0.4259, 0.48),
  ('ceiling', 7, 'tilt_deg', 0.05743, 0.45),
  ('ceiling', 7, 'width', 0.6856, 0.5085),
  ('ceiling', 7, 'z_max', 3.614, 0.152),
  ('ceiling', 7, 'z_min', 3.612, 0.152);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.03834, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'area_m2', 2.386, 0.445),
  ('ceiling', 8, 'aspect', 0.3539, 0.2152),
  ('ceiling', 8, 'behind', 0.001405, 0.03),
  ('ceiling', 8, 'edge_free', 0.001221, 0.03),
  ('ceiling', 8, 'edge_free_top', 0, 0.3162),
  ('ceiling', 8, 'edge_joined', 0.2254, 0.06353),
  ('ceiling', 8, 'height', 3.252, 0.102),
  ('ceiling', 8, 'length', 1.612, 0.2361),
  ('ceiling', 8, 'rectangularity', 0.6334, 0.1324),
  ('ceiling', 8, 'spread_length', 1.489, 0.2082),
  ('ceiling', 8, 'spread_width', 0.922, 0.2382),
  ('ceiling', 8, 'tilt_deg', 0.0152, 0.45),
  ('ceiling', 8, 'width', 1.258, 0.3098),
  ('ceiling', 8, 'z_max', 3.253, 0.1021),
  ('ceiling', 8, 'z_min', 3.252, 0.1019);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.03766, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'area_m2', 0.791, 0.553),
  ('ceiling', 9, 'aspect', 0.956, 0.5218),
  ('ceiling', 9, 'behind', 0.3053, 0.06358),
  ('ceiling', 9, 'edge_free', 0.309, 0.07574),
  ('ceiling', 9, 'edge_free_top', 0, 0.3162),
  ('ceiling', 9, 'edge_joined', 0.3235, 0.1788),
  ('ceiling', 9, 'height', 3.048, 0.3315),
  ('ceiling', 9, 'length', 0.9897, 0.4388),
  ('ceiling', 9, 'rectangularity', 0.798, 0.07023),
  ('ceiling', 9, 'spread_length', 0.8683, 0.3931),
  ('ceiling', 9, 'spread_width', -0.1204, 0.3089),
  ('ceiling', 9, 'tilt_deg', 0.0518, 0.45),
  ('ceiling', 9, 'width', 0.03377, 0.2941),
  ('ceiling', 9, 'z_max', 3.048, 0.3316),
  ('ceiling', 9, 'z_min', 3.047, 0.3314);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 10, 0.01738, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 10, 'area_m2', 0.1565, 0.8978),
  ('ceiling', 10, 'aspect', 0.6685, 0.235),
  ('ceiling', 10, 'behind', 0.3121, 0.19),
  ('ceiling', 10, 'edge_free', 0.1898, 0.1376),
  ('ceiling', 10, 'edge_free_top', 0, 0.3162),
  ('ceiling', 10, 'edge_joined', 0.2892, 0.06601),
  ('ceiling', 10, 'height', 2.804, 0.08526),
  ('ceiling', 10, 'length', 0.6305, 0.3874),
  ('ceiling', 10, 'rectangularity', 0.6529, 0.06343),
  ('ceiling', 10, 'spread_length', 0.5039, 0.3818),
  ('ceiling', 10, 'spread_width', -0.3408, 0.4894),
  ('ceiling', 10, 'tilt_deg', 0.05403, 0.45),
  ('ceiling', 10, 'width', -0.03804, 0.5319),
  ('ceiling', 10, 'z_max', 2.805, 0.08531),
  ('ceiling', 10, 'z_min', 2.804, 0.0852);

-- wall: 2059 examples
UPDATE object_class SET prior = 0.1542 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 0.4853, 1.405)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.6657, 0.4832)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.1019, 0.1866)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.1284, 0.2262)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.1116, 0.2525)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_joined', 0.2182, 0.2522)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.361, 0.4901)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 0.8025, 0.6589)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6582, 0.1522)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.6306, 0.6685)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', -0.1166, 0.8548)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.31, 2.307)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.1324, 0.861)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.35, 0.798)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.2688, 0.5194)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'wall';
DELETE FROM class_density WHERE class = 'wall';
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.2105, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'area_m2', 1.965, 0.3443),
  ('wall', 1, 'aspect', 0.3898, 0.2128),
  ('wall', 1, 'behind', 0.002747, 0.03),
  ('wall', 1, 'edge_free', 0.004788, 0.03),
  ('wall', 1, 'edge_free_top', 0.001162, 0.03),
  ('wall', 1, 'edge_joined', 0.1485, 0.1453),
  ('wall', 1, 'height', 1.537, 0.1896),
  ('wall', 1, 'length', 1.412, 0.2112),
  ('wall', 1, 'rectangularity', 0.6401, 0.1286),
  ('wall', 1, 'spread_length', 1.244, 0.2268),
  ('wall', 1, 'spread_width', 0.7538, 0.1981),
  ('wall', 1, 'tilt_deg', 89.99, 0.45),
  ('wall', 1, 'width', 1.022, 0.1017),
  ('wall', 1, 'z_max', 2.83, 0.3016),
  ('wall', 1, 'z_min', -0.009509, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.1429, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'area_m2', 1.067, 0.448),
  ('wall', 2, 'aspect', 0.4954, 0.318),
  ('wall', 2, 'behind', 0.0009089, 0.03),
  ('wall', 2, 'edge_free', 0.007642, 0.03),
  ('wall', 2, 'edge_free_top', 0.006736, 0.03),
  ('wall', 2, 'edge_joined', 0.2982, 0.2501),
  ('wall', 2, 'height', 1.528, 0.2722),
  ('wall', 2, 'length', 1.026, 0.2553),
  ('wall', 2, 'rectangularity', 0.6367, 0.1696),
  ('wall', 2, 'spread_length', 0.8371, 0.262),
  ('wall', 2, 'spread_width', 0.2488, 0.2661),
  ('wall', 2, 'tilt_deg', 89.96, 0.45),
  ('wall', 2, 'width', 0.5303, 0.3294),
  ('wall', 2, 'z_max', 2.772, 0.3687),
  ('wall', 2, 'z_min', 0.261, 0.3548);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.1217, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'area_m2', 0.3878, 0.4977),
  ('wall', 3, 'aspect', 1.134, 0.5413),
  ('wall', 3, 'behind', 0.27, 0.241),
  ('wall', 3, 'edge_free', 0.2719, 0.238),
  ('wall', 3, 'edge_free_top', 0.201, 0.2209),
  ('wall', 3, 'edge_joined', 0.3016, 0.3062),
  ('wall', 3, 'height', 1.417, 0.192),
  ('wall', 3, 'length', 0.9868, 0.1515),
  ('wall', 3, 'rectangularity', 0.6604, 0.1617),
  ('wall', 3, 'spread_length', 0.7992, 0.2106),
  ('wall', 3, 'spread_width', -0.4199, 0.5493),
  ('wall', 3, 'tilt_deg', 89.98, 0.45),
  ('wall', 3, 'width', -0.1475, 0.5403),
  ('wall', 3, 'z_max', 2.763, 0.3306),
  ('wall', 3, 'z_min', 0.09499, 0.2015);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.09071, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'area_m2', 1.825, 0.3255),
  ('wall', 4, 'aspect', 0.3817, 0.215),
  ('wall', 4, 'behind', 0.1281, 0.119),
  ('wall', 4, 'edge_free', 0.1631, 0.1114),
  ('wall', 4, 'edge_free_top', 0.1046, 0.1527),
  ('wall', 4, 'edge_joined', 0.1041, 0.1107),
  ('wall', 4, 'height', 1.555, 0.2223),
  ('wall', 4, 'length', 1.395, 0.2159),
  ('wall', 4, 'rectangularity', 0.5704, 0.1191),
  ('wall', 4, 'spread_length', 1.261, 0.2207),
  ('wall', 4, 'spread_width', 0.8197, 0.1924),
  ('wall', 4, 'tilt_deg', 89.98, 0.45),
  ('wall', 4, 'width', 1.013, 0.1107),
  ('wall', 4, 'z_max', 2.852, 0.2911),
  ('wall', 4, 'z_min', -0.004406, 0.03811);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.085, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'area_m2', -1.868, 0.7693),
  ('wall', 5, 'aspect', 0.9151, 0.6288),
  ('wall', 5, 'behind', 0.00157, 0.03),
  ('wall', 5, 'edge_free', 0.002927, 0.03),
  ('wall', 5, 'edge_free_top', 0.001071, 0.03),
  ('wall', 5, 'edge_joined', 0.2084, 0.2983),
  ('wall', 5, 'height', 0.6545, 0.5121),
  ('wall', 5, 'length', -0.2998, 0.5521),
  ('wall', 5, 'rectangularity', 0.7192, 0.1436),
  ('wall', 5, 'spread_length', -0.4418, 0.5464),
  ('wall', 5, 'spread_width', -1.424, 0.4284),
  ('wall', 5, 'tilt_deg', 88.52, 1.75),
  ('wall', 5, 'width', -1.215, 0.4292),
  ('wall', 5, 'z_max', 0.9839, 0.6748),
  ('wall', 5, 'z_min', 0.3071, 0.4266);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.08267, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'area_m2', -0.4689, 0.5219),
  ('wall', 6, 'aspect', 0.8766, 0.518),
  ('wall', 6, 'behind', 0.129, 0.2019),
  ('wall', 6, 'edge_free', 0.117, 0.1885),
  ('wall', 6, 'edge_free_top', 0.006777, 0.03),
  ('wall', 6, 'edge_joined', 0.3924, 0.3061),
  ('wall', 6, 'height', 1.881, 0.5153),
  ('wall', 6, 'length', 0.3891, 0.3265),
  ('wall', 6, 'rectangularity', 0.7047, 0.1331),
  ('wall', 6, 'spread_length', 0.2078, 0.336),
  ('wall', 6, 'spread_width', -0.7024, 0.3951),
  ('wall', 6, 'tilt_deg', 89.92, 0.45),
  ('wall', 6, 'width', -0.4876, 0.4009),
  ('wall', 6, 'z_max', 2.638, 0.5139),
  ('wall', 6, 'z_min', 1.214, 0.6862);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.06957, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'area_m2', 0.1071, 0.49),
  ('wall', 7, 'aspect', 0.664, 0.3686),
  ('wall', 7, 'behind', 0.001133, 0.03),
  ('wall', 7, 'edge_free', 0.007434, 0.03),
  ('wall', 7, 'edge_free_top', 0.01661, 0.04772),
  ('wall', 7, 'edge_joined', 0.1795, 0.193),
  ('wall', 7, 'height', 0.9739, 0.3149),
  ('wall', 7, 'length', 0.5943, 0.3376),
  ('wall', 7, 'rectangularity', 0.6822, 0.1628),
  ('wall', 7, 'spread_length', 0.4607, 0.3377),
  ('wall', 7, 'spread_width', -0.284, 0.3223),
  ('wall', 7, 'tilt_deg', 87.97, 2.205),
  ('wall', 7, 'width', -0.0697, 0.3504),
  ('wall', 7, 'z_max', 1.575, 0.419),
  ('wall', 7, 'z_min', 0.1911, 0.3478);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.05929, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'area_m2', -0.4446, 0.4691),
  ('wall', 8, 'aspect', 0.9035, 0.4057),
  ('wall', 8, 'behind', 0.2263, 0.206),
  ('wall', 8, 'edge_free', 0.4453, 0.2903),
  ('wall', 8, 'edge_free_top', 0.4576, 0.4027),
  ('wall', 8, 'edge_joined', 0.08204, 0.1401),
  ('wall', 8, 'height', 1.041, 0.3294),
  ('wall', 8, 'length', 0.4665, 0.2945),
  ('wall', 8, 'rectangularity', 0.6463, 0.1634),
  ('wall', 8, 'spread_length', 0.2563, 0.3438),
  ('wall', 8, 'spread_width', -0.7485, 0.348),
  ('wall', 8, 'tilt_deg', 83.24, 12.68),
  ('wall', 8, 'width', -0.437, 0.3594),
  ('wall', 8, 'z_max', 1.667, 0.4304),
  ('wall', 8, 'z_min', 0.2962, 0.3866);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.05794, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'area_m2', -2.075, 0.6044),
  ('wall', 9, 'aspect', 0.8901, 0.491),
  ('wall', 9, 'behind', 0.3027, 0.2577),
  ('wall', 9, 'edge_free', 0.3372, 0.3299),
  ('wall', 9, 'edge_free_top', 0.3305, 0.3628),
  ('wall', 9, 'edge_joined', 0.2646, 0.3006),
  ('wall', 9, 'height', 1.197, 0.8909),
  ('wall', 9, 'length', -0.3934, 0.4289),
  ('wall', 9, 'rectangularity', 0.6843, 0.1255),
  ('wall', 9, 'spread_length', -0.5995, 0.4358),
  ('wall', 9, 'spread_width', -1.503, 0.3686),
  ('wall', 9, 'tilt_deg', 88.99, 1.286),
  ('wall', 9, 'width', -1.284, 0.3583),
  ('wall', 9, 'z_max', 1.48, 0.9006),
  ('wall', 9, 'z_min', 0.9111, 0.9329);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.02971, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'area_m2', 0.589, 0.3586),
  ('wall', 10, 'aspect', 0.2757, 0.1989),
  ('wall', 10, 'behind', 0.3425, 0.2023),
  ('wall', 10, 'edge_free', 0.5353, 0.2428),
  ('wall', 10, 'edge_free_top', 0.9087, 0.1143),
  ('wall', 10, 'edge_joined', 0.1668, 0.2223),
  ('wall', 10, 'height', 0.9834, 0.206),
  ('wall', 10, 'length', 0.5884, 0.1796),
  ('wall', 10, 'rectangularity', 0.7525, 0.1535),
  ('wall', 10, 'spread_length', 0.4309, 0.1822),
  ('wall', 10, 'spread_width', 0.05319, 0.2464),
  ('wall', 10, 'tilt_deg', 89.74, 0.5616),
  ('wall', 10, 'width', 0.3127, 0.222),
  ('wall', 10, 'z_max', 1.672, 0.3082),
  ('wall', 10, 'z_min', -0.00339, 0.06915);

-- table: 610 examples
UPDATE object_class SET prior = 0.04575 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.3926, 0.6644)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5582, 0.2958)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5247, 0.2124)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.4433, 0.2204)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_joined', 0.2911, 0.1977)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7277, 0.122)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.2631, 0.3361)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.7087, 0.1258)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1233, 0.3291)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4816, 0.3848)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.6171, 0.6082)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2971, 0.3573)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7341, 0.1222)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.723, 0.1218)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'table';
DELETE FROM class_density WHERE class = 'table';
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.1865, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'area_m2', 0.148, 0.1686),
  ('table', 1, 'aspect', 0.6615, 0.1529),
  ('table', 1, 'behind', 0.6283, 0.1375),
  ('table', 1, 'edge_free', 0.4671, 0.1785),
  ('table', 1, 'edge_free_top', 0, 0.3162),
  ('table', 1, 'edge_joined', 0.3096, 0.1673),
  ('table', 1, 'height', 0.7274, 0.0225),
  ('table', 1, 'length', 0.5468, 0.09975),
  ('table', 1, 'rectangularity', 0.7584, 0.08904),
  ('table', 1, 'spread_length', 0.3908, 0.131),
  ('table', 1, 'spread_width', -0.2526, 0.1343),
  ('table', 1, 'tilt_deg', 0.3493, 0.45),
  ('table', 1, 'width', -0.1147, 0.126),
  ('table', 1, 'z_max', 0.7318, 0.0225),
  ('table', 1, 'z_min', 0.7243, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.1366, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'area_m2', -0.7581, 0.2091),
  ('table', 2, 'aspect', 0.3136, 0.1861),
  ('table', 2, 'behind', 0.5059, 0.2232),
  ('table', 2, 'edge_free', 0.4515, 0.2147),
  ('table', 2, 'edge_free_top', 0, 0.3162),
  ('table', 2, 'edge_joined', 0.2993, 0.183),
  ('table', 2, 'height', 0.7424, 0.0648),
  ('table', 2, 'length', -0.05726, 0.1274),
  ('table', 2, 'rectangularity', 0.7296, 0.1153),
  ('table', 2, 'spread_length', -0.1458, 0.1101),
  ('table', 2, 'spread_width', -0.5591, 0.1567),
  ('table', 2, 'tilt_deg', 0.7331, 0.5549),
  ('table', 2, 'width', -0.3709, 0.1416),
  ('table', 2, 'z_max', 0.7486, 0.06563),
  ('table', 2, 'z_min', 0.7377, 0.06463);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.1201, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'area_m2', -0.0624, 0.3247),
  ('table', 3, 'aspect', 0.6372, 0.2477),
  ('table', 3, 'behind', 0.5337, 0.1619),
  ('table', 3, 'edge_free', 0.4695, 0.213),
  ('table', 3, 'edge_free_top', 0, 0.3162),
  ('table', 3, 'edge_joined', 0.259, 0.1855),
  ('table', 3, 'height', 0.7828, 0.02797),
  ('table', 3, 'length', 0.4764, 0.1675),
  ('table', 3, 'rectangularity', 0.7045, 0.149),
  ('table', 3, 'spread_length', 0.3167, 0.1554),
  ('table', 3, 'spread_width', -0.3495, 0.2167),
  ('table', 3, 'tilt_deg', 0.5706, 0.5919),
  ('table', 3, 'width', -0.1608, 0.1955),
  ('table', 3, 'z_max', 0.7903, 0.03194),
  ('table', 3, 'z_min', 0.7773, 0.02634);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.1182, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'area_m2', -0.1267, 0.2356),
  ('table', 4, 'aspect', 0.5815, 0.2211),
  ('table', 4, 'behind', 0.5201, 0.1625),
  ('table', 4, 'edge_free', 0.5216, 0.1864),
  ('table', 4, 'edge_free_top', 0, 0.3162),
  ('table', 4, 'edge_joined', 0.2044, 0.1392),
  ('table', 4, 'height', 0.6664, 0.02959),
  ('table', 4, 'length', 0.3898, 0.1503),
  ('table', 4, 'rectangularity', 0.7351, 0.1277),
  ('table', 4, 'spread_length', 0.259, 0.1457),
  ('table', 4, 'spread_width', -0.3388, 0.1487),
  ('table', 4, 'tilt_deg', 0.6851, 0.6314),
  ('table', 4, 'width', -0.1917, 0.1399),
  ('table', 4, 'z_max', 0.675, 0.02797),
  ('table', 4, 'z_min', 0.66, 0.03256);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.1129, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'area_m2', -0.2393, 0.2129),
  ('table', 5, 'aspect', 0.2995, 0.1552),
  ('table', 5, 'behind', 0.5826, 0.1921),
  ('table', 5, 'edge_free', 0.3592, 0.2),
  ('table', 5, 'edge_free_top', 0, 0.3162),
  ('table', 5, 'edge_joined', 0.3618, 0.1983),
  ('table', 5, 'height', 0.7359, 0.0225),
  ('table', 5, 'length', 0.2157, 0.1296),
  ('table', 5, 'rectangularity', 0.7012, 0.1131),
  ('table', 5, 'spread_length', 0.077, 0.1297),
  ('table', 5, 'spread_width', -0.2828, 0.1176),
  ('table', 5, 'tilt_deg', 0.3876, 0.45),
  ('table', 5, 'width', -0.08382, 0.106),
  ('table', 5, 'z_max', 0.7404, 0.02269),
  ('table', 5, 'z_min', 0.733, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.1032, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'area_m2', -1.203, 0.254),
  ('table', 6, 'aspect', 0.5328, 0.2681),
  ('table', 6, 'behind', 0.4153, 0.2281),
  ('table', 6, 'edge_free', 0.4263, 0.2385),
  ('table', 6, 'edge_free_top', 0, 0.3162),
  ('table', 6, 'edge_joined', 0.2802, 0.2295),
  ('table', 6, 'height', 0.7115, 0.03066),
  ('table', 6, 'length', -0.1325, 0.2056),
  ('table', 6, 'rectangularity', 0.6777, 0.1131),
  ('table', 6, 'spread_length', -0.279, 0.1977),
  ('table', 6, 'spread_width', -0.9099, 0.184),
  ('table', 6, 'tilt_deg', 0.766, 0.7208),
  ('table', 6, 'width', -0.6653, 0.1708),
  ('table', 6, 'z_max', 0.7172, 0.03145),
  ('table', 6, 'z_min', 0.7078, 0.03045);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.06492, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'area_m2', -1.851, 0.6495),
  ('table', 7, 'aspect', 1.021, 0.3508),
  ('table', 7, 'behind', 0.378, 0.2676),
  ('table', 7, 'edge_free', 0.493, 0.2784),
  ('table', 7, 'edge_free_top', 0, 0.3162),
  ('table', 7, 'edge_joined', 0.2014, 0.1659),
  ('table', 7, 'height', 0.7276, 0.05746),
  ('table', 7, 'length', -0.1757, 0.3981),
  ('table', 7, 'rectangularity', 0.6334, 0.1256),
  ('table', 7, 'spread_length', -0.3261, 0.4271),
  ('table', 7, 'spread_width', -1.437, 0.3092),
  ('table', 7, 'tilt_deg', 1.093, 1.108),
  ('table', 7, 'width', -1.197, 0.3374),
  ('table', 7, 'z_max', 0.7333, 0.05844),
  ('table', 7, 'z_min', 0.7234, 0.05714);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.04597, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'area_m2', 0.3849, 0.3694),
  ('table', 8, 'aspect', 0.5938, 0.3678),
  ('table', 8, 'behind', 0.6465, 0.08665),
  ('table', 8, 'edge_free', 0.4153, 0.1474),
  ('table', 8, 'edge_free_top', 0, 0.3162),
  ('table', 8, 'edge_joined', 0.3307, 0.161),
  ('table', 8, 'height', 0.6951, 0.0298),
  ('table', 8, 'length', 0.7154, 0.3079),
  ('table', 8, 'rectangularity', 0.6523, 0.1276),
  ('table', 8, 'spread_length', 0.5855, 0.2796),
  ('table', 8, 'spread_width', -0.05941, 0.2018),
  ('table', 8, 'tilt_deg', 0.4034, 0.45),
  ('table', 8, 'width', 0.1215, 0.2394),
  ('table', 8, 'z_max', 0.7016, 0.02852),
  ('table', 8, 'z_min', 0.6904, 0.03166);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.04484, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'area_m2', -0.2596, 0.5326),
  ('table', 9, 'aspect', 0.6714, 0.2624),
  ('table', 9, 'behind', 0.4537, 0.1838),
  ('table', 9, 'edge_free', 0.3086, 0.2221),
  ('table', 9, 'edge_free_top', 0, 0.3162),
  ('table', 9, 'edge_joined', 0.4898, 0.1949),
  ('table', 9, 'height', 1.008, 0.09318),
  ('table', 9, 'length', 0.4219, 0.2525),
  ('table', 9, 'rectangularity', 0.6605, 0.1109),
  ('table', 9, 'spread_length', 0.2478, 0.2532),
  ('table', 9, 'spread_width', -0.4398, 0.3157),
  ('table', 9, 'tilt_deg', 0.9698, 0.5527),
  ('table', 9, 'width', -0.2496, 0.2609),
  ('table', 9, 'z_max', 1.019, 0.09211),
  ('table', 9, 'z_min', 0.9974, 0.0951);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.01685, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'area_m2', -0.6881, 0.694),
  ('table', 10, 'aspect', 0.5022, 0.1453),
  ('table', 10, 'behind', 0.2056, 0.129),
  ('table', 10, 'edge_free', 0.2971, 0.1151),
  ('table', 10, 'edge_free_top', 0, 0.3162),
  ('table', 10, 'edge_joined', 0.1808, 0.1707),
  ('table', 10, 'height', 0.06688, 0.05972),
  ('table', 10, 'length', 0.1454, 0.331),
  ('table', 10, 'rectangularity', 0.6297, 0.08754),
  ('table', 10, 'spread_length', 0.01781, 0.3006),
  ('table', 10, 'spread_width', -0.6227, 0.418),
  ('table', 10, 'tilt_deg', 1.333, 0.6208),
  ('table', 10, 'width', -0.3568, 0.3879),
  ('table', 10, 'z_max', 0.07846, 0.0596),
  ('table', 10, 'z_min', 0.057, 0.06029);

-- flat_screen: 483 examples
UPDATE object_class SET prior = 0.03625 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.867, 0.3822)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.3921, 0.206)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5848, 0.1371)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.7803, 0.1722)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.981, 0.06079)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_joined', 0.044, 0.08142)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.016, 0.1242)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.6238, 0.2453)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.8076, 0.1173)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7723, 0.2017)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.213, 0.1779)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.15, 3.356)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -1.016, 0.217)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.17, 0.1334)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.789, 0.1398)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'flat_screen';
DELETE FROM class_density WHERE class = 'flat_screen';
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.1861, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'area_m2', -1.554, 0.1232),
  ('flat_screen', 1, 'aspect', 0.3499, 0.1275),
  ('flat_screen', 1, 'behind', 0.5723, 0.1328),
  ('flat_screen', 1, 'edge_free', 0.7308, 0.08441),
  ('flat_screen', 1, 'edge_free_top', 0.994, 0.03),
  ('flat_screen', 1, 'edge_joined', 0.06191, 0.06426),
  ('flat_screen', 1, 'height', 0.9941, 0.05126),
  ('flat_screen', 1, 'length', -0.4935, 0.1139),
  ('flat_screen', 1, 'rectangularity', 0.8097, 0.0822),
  ('flat_screen', 1, 'spread_length', -0.6268, 0.08121),
  ('flat_screen', 1, 'spread_width', -1.084, 0.06481),
  ('flat_screen', 1, 'tilt_deg', 85.34, 3.134),
  ('flat_screen', 1, 'width', -0.8434, 0.07836),
  ('flat_screen', 1, 'z_max', 1.157, 0.05209),
  ('flat_screen', 1, 'z_min', 0.7245, 0.04869);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.1331, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'area_m2', -1.945, 0.1849),
  ('flat_screen', 2, 'aspect', 0.3546, 0.1653),
  ('flat_screen', 2, 'behind', 0.5983, 0.1262),
  ('flat_screen', 2, 'edge_free', 0.6805, 0.1453),
  ('flat_screen', 2, 'edge_free_top', 0.9447, 0.1057),
  ('flat_screen', 2, 'edge_joined', 0.03373, 0.03983),
  ('flat_screen', 2, 'height', 1.004, 0.05228),
  ('flat_screen', 2, 'length', -0.6322, 0.1372),
  ('flat_screen', 2, 'rectangularity', 0.7292, 0.1015),
  ('flat_screen', 2, 'spread_length', -0.8584, 0.1285),
  ('flat_screen', 2, 'spread_width', -1.243, 0.07786),
  ('flat_screen', 2, 'tilt_deg', 85.35, 3.349),
  ('flat_screen', 2, 'width', -0.9868, 0.1276),
  ('flat_screen', 2, 'z_max', 1.153, 0.05784),
  ('flat_screen', 2, 'z_min', 0.7604, 0.0572);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.121, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'area_m2', -1.773, 0.1344),
  ('flat_screen', 3, 'aspect', 0.5002, 0.0519),
  ('flat_screen', 3, 'behind', 0.5712, 0.1053),
  ('flat_screen', 3, 'edge_free', 0.9817, 0.03243),
  ('flat_screen', 3, 'edge_free_top', 0.9992, 0.03),
  ('flat_screen', 3, 'edge_joined', 0.003318, 0.03),
  ('flat_screen', 3, 'height', 1.026, 0.04037),
  ('flat_screen', 3, 'length', -0.5991, 0.07663),
  ('flat_screen', 3, 'rectangularity', 0.9294, 0.03153),
  ('flat_screen', 3, 'spread_length', -0.6433, 0.07095),
  ('flat_screen', 3, 'spread_width', -1.142, 0.07723),
  ('flat_screen', 3, 'tilt_deg', 85.11, 3.636),
  ('flat_screen', 3, 'width', -1.099, 0.0696),
  ('flat_screen', 3, 'z_max', 1.182, 0.04346),
  ('flat_screen', 3, 'z_min', 0.8482, 0.03899);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.09997, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'area_m2', -2.235, 0.1352),
  ('flat_screen', 4, 'aspect', 0.34, 0.1275),
  ('flat_screen', 4, 'behind', 0.5797, 0.08952),
  ('flat_screen', 4, 'edge_free', 0.9867, 0.03),
  ('flat_screen', 4, 'edge_free_top', 0.9996, 0.03),
  ('flat_screen', 4, 'edge_joined', 0.002558, 0.03),
  ('flat_screen', 4, 'height', 1.005, 0.04979),
  ('flat_screen', 4, 'length', -0.9051, 0.1087),
  ('flat_screen', 4, 'rectangularity', 0.9208, 0.04624),
  ('flat_screen', 4, 'spread_length', -0.9376, 0.1048),
  ('flat_screen', 4, 'spread_width', -1.292, 0.06814),
  ('flat_screen', 4, 'tilt_deg', 84.69, 3.341),
  ('flat_screen', 4, 'width', -1.245, 0.07298),
  ('flat_screen', 4, 'z_max', 1.141, 0.04934),
  ('flat_screen', 4, 'z_min', 0.8515, 0.0507);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.09823, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'area_m2', -1.859, 0.2987),
  ('flat_screen', 5, 'aspect', 0.3775, 0.1772),
  ('flat_screen', 5, 'behind', 0.5251, 0.1185),
  ('flat_screen', 5, 'edge_free', 0.8128, 0.1719),
  ('flat_screen', 5, 'edge_free_top', 0.996, 0.03),
  ('flat_screen', 5, 'edge_joined', 0.023, 0.0355),
  ('flat_screen', 5, 'height', 1.247, 0.1034),
  ('flat_screen', 5, 'length', -0.6385, 0.196),
  ('flat_screen', 5, 'rectangularity', 0.8224, 0.1007),
  ('flat_screen', 5, 'spread_length', -0.7602, 0.1858),
  ('flat_screen', 5, 'spread_width', -1.195, 0.143),
  ('flat_screen', 5, 'tilt_deg', 84.37, 3.069),
  ('flat_screen', 5, 'width', -1.016, 0.1825),
  ('flat_screen', 5, 'z_max', 1.405, 0.1072),
  ('flat_screen', 5, 'z_min', 1.027, 0.1165);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.09371, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'area_m2', -2.053, 0.142),
  ('flat_screen', 6, 'aspect', 0.1448, 0.1068),
  ('flat_screen', 6, 'behind', 0.6703, 0.06698),
  ('flat_screen', 6, 'edge_free', 0.7479, 0.05703),
  ('flat_screen', 6, 'edge_free_top', 0.9996, 0.03),
  ('flat_screen', 6, 'edge_joined', 0.03464, 0.03561),
  ('flat_screen', 6, 'height', 0.9565, 0.04533),
  ('flat_screen', 6, 'length', -0.8576, 0.1163),
  ('flat_screen', 6, 'rectangularity', 0.8281, 0.06877),
  ('flat_screen', 6, 'spread_length', -0.9773, 0.1038),
  ('flat_screen', 6, 'spread_width', -1.253, 0.05681),
  ('flat_screen', 6, 'tilt_deg', 85.67, 3.33),
  ('flat_screen', 6, 'width', -1.002, 0.06991),
  ('flat_screen', 6, 'z_max', 1.092, 0.04819),
  ('flat_screen', 6, 'z_min', 0.7167, 0.04709);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.08506, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'area_m2', -2.54, 0.3688),
  ('flat_screen', 7, 'aspect', 0.491, 0.3005),
  ('flat_screen', 7, 'behind', 0.5564, 0.2266),
  ('flat_screen', 7, 'edge_free', 0.7904, 0.1594),
  ('flat_screen', 7, 'edge_free_top', 0.9994, 0.03),
  ('flat_screen', 7, 'edge_joined', 0.0432, 0.08161),
  ('flat_screen', 7, 'height', 1.027, 0.06094),
  ('flat_screen', 7, 'length', -0.8553, 0.2377),
  ('flat_screen', 7, 'rectangularity', 0.7254, 0.1268),
  ('flat_screen', 7, 'spread_length', -0.9866, 0.2108),
  ('flat_screen', 7, 'spread_width', -1.586, 0.2497),
  ('flat_screen', 7, 'tilt_deg', 85.04, 3.556),
  ('flat_screen', 7, 'width', -1.346, 0.254),
  ('flat_screen', 7, 'z_max', 1.142, 0.06428),
  ('flat_screen', 7, 'z_min', 0.8252, 0.0725);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.07918, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'area_m2', -1.371, 0.1868),
  ('flat_screen', 8, 'aspect', 0.584, 0.2039),
  ('flat_screen', 8, 'behind', 0.6156, 0.1276),
  ('flat_screen', 8, 'edge_free', 0.6059, 0.1196),
  ('flat_screen', 8, 'edge_free_top', 0.9328, 0.09698),
  ('flat_screen', 8, 'edge_joined', 0.02291, 0.03),
  ('flat_screen', 8, 'height', 0.9712, 0.07509),
  ('flat_screen', 8, 'length', -0.2031, 0.1322),
  ('flat_screen', 8, 'rectangularity', 0.6881, 0.07221),
  ('flat_screen', 8, 'spread_length', -0.5828, 0.2126),
  ('flat_screen', 8, 'spread_width', -1.09, 0.1166),
  ('flat_screen', 8, 'tilt_deg', 85.16, 2.966),
  ('flat_screen', 8, 'width', -0.7871, 0.1595),
  ('flat_screen', 8, 'z_max', 1.191, 0.1168),
  ('flat_screen', 8, 'z_min', 0.6937, 0.128);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.04017, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'area_m2', -1.516, 0.2173),
  ('flat_screen', 9, 'aspect', 0.5079, 0.2194),
  ('flat_screen', 9, 'behind', 0.6038, 0.16),
  ('flat_screen', 9, 'edge_free', 0.5386, 0.1287),
  ('flat_screen', 9, 'edge_free_top', 0.9036, 0.09277),
  ('flat_screen', 9, 'edge_joined', 0.3585, 0.1556),
  ('flat_screen', 9, 'height', 0.9891, 0.0647),
  ('flat_screen', 9, 'length', -0.3345, 0.1385),
  ('flat_screen', 9, 'rectangularity', 0.7202, 0.09466),
  ('flat_screen', 9, 'spread_length', -0.5894, 0.1192),
  ('flat_screen', 9, 'spread_width', -1.079, 0.1352),
  ('flat_screen', 9, 'tilt_deg', 81.01, 16.37),
  ('flat_screen', 9, 'width', -0.8423, 0.1862),
  ('flat_screen', 9, 'z_max', 1.167, 0.1055),
  ('flat_screen', 9, 'z_min', 0.7426, 0.09474);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.01349, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'area_m2', -2.105, 0.2653),
  ('flat_screen', 10, 'aspect', 0.5451, 0.1797),
  ('flat_screen', 10, 'behind', 0.523, 0.1593),
  ('flat_screen', 10, 'edge_free', 0.7093, 0.1113),
  ('flat_screen', 10, 'edge_free_top', 0.9972, 0.03),
  ('flat_screen', 10, 'edge_joined', 0.1121, 0.1125),
  ('flat_screen', 10, 'height', 0.3875, 0.09221),
  ('flat_screen', 10, 'length', -0.6727, 0.1456),
  ('flat_screen', 10, 'rectangularity', 0.8185, 0.1051),
  ('flat_screen', 10, 'spread_length', -0.7952, 0.1079),
  ('flat_screen', 10, 'spread_width', -1.405, 0.1686),
  ('flat_screen', 10, 'tilt_deg', 86.09, 3.369),
  ('flat_screen', 10, 'width', -1.218, 0.2062),
  ('flat_screen', 10, 'z_max', 0.5209, 0.09436),
  ('flat_screen', 10, 'z_min', 0.1782, 0.114);

-- keyboard: 292 examples
UPDATE object_class SET prior = 0.02194 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.769, 0.3529)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.776, 0.304)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.2325, 0.1577)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.2629, 0.2073)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_joined', 0.6876, 0.2233)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7578, 0.1359)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.8966, 0.2758)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.824, 0.07887)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9702, 0.2732)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.831, 0.1253)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.744, 2.098)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.674, 0.1917)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7652, 0.1365)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7512, 0.1357)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'keyboard';
DELETE FROM class_density WHERE class = 'keyboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1755, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'area_m2', -2.621, 0.1005),
  ('keyboard', 1, 'aspect', 0.8472, 0.09292),
  ('keyboard', 1, 'behind', 0.2029, 0.1222),
  ('keyboard', 1, 'edge_free', 0.4568, 0.1609),
  ('keyboard', 1, 'edge_free_top', 0, 0.3162),
  ('keyboard', 1, 'edge_joined', 0.5078, 0.1605),
  ('keyboard', 1, 'height', 0.7581, 0.03658),
  ('keyboard', 1, 'length', -0.7882, 0.05845),
  ('keyboard', 1, 'rectangularity', 0.8229, 0.05877),
  ('keyboard', 1, 'spread_length', -0.8476, 0.06962),
  ('keyboard', 1, 'spread_width', -1.789, 0.07937),
  ('keyboard', 1, 'tilt_deg', 4.997, 1.567),
  ('keyboard', 1, 'width', -1.635, 0.07549),
  ('keyboard', 1, 'z_max', 0.7678, 0.03705),
  ('keyboard', 1, 'z_min', 0.7498, 0.03648);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.1649, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'area_m2', -2.955, 0.1846),
  ('keyboard', 2, 'aspect', 0.5164, 0.2043),
  ('keyboard', 2, 'behind', 0.2474, 0.1687),
  ('keyboard', 2, 'edge_free', 0.2534, 0.1825),
  ('keyboard', 2, 'edge_free_top', 0, 0.3162),
  ('keyboard', 2, 'edge_joined', 0.6854, 0.2135),
  ('keyboard', 2, 'height', 0.7536, 0.04107),
  ('keyboard', 2, 'length', -1.113, 0.08658),
  ('keyboard', 2, 'rectangularity', 0.8115, 0.07428),
  ('keyboard', 2, 'spread_length', -1.197, 0.08647),
  ('keyboard', 2, 'spread_width', -1.808, 0.121),
  ('keyboard', 2, 'tilt_deg', 3.898, 2.089),
  ('keyboard', 2, 'width', -1.629, 0.1876),
  ('keyboard', 2, 'z_max', 0.7613, 0.04172),
  ('keyboard', 2, 'z_min', 0.747, 0.04114);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.1256, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'area_m2', -2.613, 0.1219),
  ('keyboard', 3, 'aspect', 1.093, 0.1222),
  ('keyboard', 3, 'behind', 0.2996, 0.159),
  ('keyboard', 3, 'edge_free', 0.2336, 0.1646),
  ('keyboard', 3, 'edge_free_top', 0, 0.3162),
  ('keyboard', 3, 'edge_joined', 0.7194, 0.1661),
  ('keyboard', 3, 'height', 0.7584, 0.02681),
  ('keyboard', 3, 'length', -0.6474, 0.09828),
  ('keyboard', 3, 'rectangularity', 0.8005, 0.05937),
  ('keyboard', 3, 'spread_length', -0.7593, 0.06913),
  ('keyboard', 3, 'spread_width', -1.91, 0.09318),
  ('keyboard', 3, 'tilt_deg', 2.958, 1.499),
  ('keyboard', 3, 'width', -1.74, 0.1049),
  ('keyboard', 3, 'z_max', 0.7636, 0.0264),
  ('keyboard', 3, 'z_min', 0.7539, 0.0271);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.1159, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'area_m2', -2.738, 0.1013),
  ('keyboard', 4, 'aspect', 1.037, 0.09135),
  ('keyboard', 4, 'behind', 0.15, 0.1301),
  ('keyboard', 4, 'edge_free', 0.4022, 0.112),
  ('keyboard', 4, 'edge_free_top', 0, 0.3162),
  ('keyboard', 4, 'edge_joined', 0.574, 0.1171),
  ('keyboard', 4, 'height', 0.8013, 0.1544),
  ('keyboard', 4, 'length', -0.8046, 0.04929),
  ('keyboard', 4, 'rectangularity', 0.9138, 0.04447),
  ('keyboard', 4, 'spread_length', -0.8313, 0.05617),
  ('keyboard', 4, 'spread_width', -1.875, 0.08002),
  ('keyboard', 4, 'tilt_deg', 4.898, 1.634),
  ('keyboard', 4, 'width', -1.842, 0.08256),
  ('keyboard', 4, 'z_max', 0.8108, 0.1549),
  ('keyboard', 4, 'z_min', 0.7929, 0.1543);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.08966, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'area_m2', -2.574, 0.09712),
  ('keyboard', 5, 'aspect', 0.8372, 0.1205),
  ('keyboard', 5, 'behind', 0.2636, 0.129),
  ('keyboard', 5, 'edge_free', 0.02314, 0.03508),
  ('keyboard', 5, 'edge_free_top', 0, 0.3162),
  ('keyboard', 5, 'edge_joined', 0.9399, 0.06836),
  ('keyboard', 5, 'height', 0.7547, 0.04),
  ('keyboard', 5, 'length', -0.77, 0.07758),
  ('keyboard', 5, 'rectangularity', 0.8234, 0.05522),
  ('keyboard', 5, 'spread_length', -0.8369, 0.07614),
  ('keyboard', 5, 'spread_width', -1.774, 0.06769),
  ('keyboard', 5, 'tilt_deg', 1.6, 0.9924),
  ('keyboard', 5, 'width', -1.607, 0.09001),
  ('keyboard', 5, 'z_max', 0.7585, 0.0398),
  ('keyboard', 5, 'z_min', 0.7517, 0.0402);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.08783, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'area_m2', -2.297, 0.1471),
  ('keyboard', 6, 'aspect', 0.661, 0.1266),
  ('keyboard', 6, 'behind', 0.2638, 0.08851),
  ('keyboard', 6, 'edge_free', 0.2019, 0.1623),
  ('keyboard', 6, 'edge_free_top', 0, 0.3162),
  ('keyboard', 6, 'edge_joined', 0.7749, 0.1572),
  ('keyboard', 6, 'height', 0.7307, 0.04806),
  ('keyboard', 6, 'length', -0.6814, 0.1072),
  ('keyboard', 6, 'rectangularity', 0.7628, 0.04656),
  ('keyboard', 6, 'spread_length', -0.8028, 0.07321),
  ('keyboard', 6, 'spread_width', -1.681, 0.09743),
  ('keyboard', 6, 'tilt_deg', 3.091, 1.867),
  ('keyboard', 6, 'width', -1.342, 0.09606),
  ('keyboard', 6, 'z_max', 0.7382, 0.04858),
  ('keyboard', 6, 'z_min', 0.7228, 0.04899);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.08212, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'area_m2', -3.516, 0.2941),
  ('keyboard', 7, 'aspect', 0.2491, 0.1758),
  ('keyboard', 7, 'behind', 0.2618, 0.1417),
  ('keyboard', 7, 'edge_free', 0.2033, 0.1718),
  ('keyboard', 7, 'edge_free_top', 0, 0.3162),
  ('keyboard', 7, 'edge_joined', 0.6583, 0.2501),
  ('keyboard', 7, 'height', 0.7501, 0.03596),
  ('keyboard', 7, 'length', -1.509, 0.1584),
  ('keyboard', 7, 'rectangularity', 0.7817, 0.06292),
  ('keyboard', 7, 'spread_length', -1.599, 0.1179),
  ('keyboard', 7, 'spread_width', -1.925, 0.1438),
  ('keyboard', 7, 'tilt_deg', 4.061, 2.045),
  ('keyboard', 7, 'width', -1.758, 0.1682),
  ('keyboard', 7, 'z_max', 0.7577, 0.03804),
  ('keyboard', 7, 'z_min', 0.744, 0.03533);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.06116, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'area_m2', -2.916, 0.2458),
  ('keyboard', 8, 'aspect', 0.9362, 0.1654),
  ('keyboard', 8, 'behind', 0.2089, 0.1252),
  ('keyboard', 8, 'edge_free', 0.06832, 0.07843),
  ('keyboard', 8, 'edge_free_top', 0, 0.3162),
  ('keyboard', 8, 'edge_joined', 0.8901, 0.1058),
  ('keyboard', 8, 'height', 0.8643, 0.06213),
  ('keyboard', 8, 'length', -0.909, 0.1836),
  ('keyboard', 8, 'rectangularity', 0.857, 0.09257),
  ('keyboard', 8, 'spread_length', -0.951, 0.183),
  ('keyboard', 8, 'spread_width', -1.909, 0.1054),
  ('keyboard', 8, 'tilt_deg', 2.541, 1.202),
  ('keyboard', 8, 'width', -1.845, 0.09651),
  ('keyboard', 8, 'z_max', 0.8696, 0.06191),
  ('keyboard', 8, 'z_min', 0.8597, 0.06268);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.02524, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'area_m2', -2.901, 0.3301),
  ('keyboard', 9, 'aspect', 0.5589, 0.148),
  ('keyboard', 9, 'behind', 0.2529, 0.2485),
  ('keyboard', 9, 'edge_free', 0.3757, 0.1391),
  ('keyboard', 9, 'edge_free_top', 0, 0.3162),
  ('keyboard', 9, 'edge_joined', 0.5472, 0.1809),
  ('keyboard', 9, 'height', 1.008, 0.08246),
  ('keyboard', 9, 'length', -1.055, 0.1909),
  ('keyboard', 9, 'rectangularity', 0.8023, 0.09766),
  ('keyboard', 9, 'spread_length', -1.13, 0.2175),
  ('keyboard', 9, 'spread_width', -1.772, 0.07614),
  ('keyboard', 9, 'tilt_deg', 6.193, 2.492),
  ('keyboard', 9, 'width', -1.614, 0.1755),
  ('keyboard', 9, 'z_max', 1.022, 0.08038),
  ('keyboard', 9, 'z_min', 0.9976, 0.08662);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.02202, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'area_m2', -2.934, 0.3512),
  ('keyboard', 10, 'aspect', 0.9804, 0.3589),
  ('keyboard', 10, 'behind', 0.0999, 0.09243),
  ('keyboard', 10, 'edge_free', 0.1316, 0.1402),
  ('keyboard', 10, 'edge_free_top', 0, 0.3162),
  ('keyboard', 10, 'edge_joined', 0.8477, 0.1368),
  ('keyboard', 10, 'height', 0.1326, 0.08537),
  ('keyboard', 10, 'length', -0.9252, 0.3309),
  ('keyboard', 10, 'rectangularity', 0.9049, 0.04627),
  ('keyboard', 10, 'spread_length', -0.9427, 0.3189),
  ('keyboard', 10, 'spread_width', -1.952, 0.04402),
  ('keyboard', 10, 'tilt_deg', 2.558, 1.229),
  ('keyboard', 10, 'width', -1.906, 0.0632),
  ('keyboard', 10, 'z_max', 0.138, 0.08569),
  ('keyboard', 10, 'z_min', 0.1276, 0.08519);

-- chair_seat: 372 examples
UPDATE object_class SET prior = 0.02795 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.03, 0.4975)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.2835, 0.2691)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6582, 0.1659)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.6268, 0.1962)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_joined', 0.08, 0.1011)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.469, 0.03081)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7137, 0.1637)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7433, 0.1316)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7674, 0.1701)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.201, 0.3436)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 0.939, 0.9045)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.001, 0.3249)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4731, 0.03093)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4659, 0.03102)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_seat';
DELETE FROM class_density WHERE class = 'chair_seat';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.1559, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'area_m2', -1.638, 0.0987),
  ('chair_seat', 1, 'aspect', 0.1265, 0.0709),
  ('chair_seat', 1, 'behind', 0.6982, 0.08078),
  ('chair_seat', 1, 'edge_free', 0.8057, 0.1048),
  ('chair_seat', 1, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 1, 'edge_joined', 0.04255, 0.05526),
  ('chair_seat', 1, 'height', 0.4409, 0.0225),
  ('chair_seat', 1, 'length', -0.6755, 0.07349),
  ('chair_seat', 1, 'rectangularity', 0.8541, 0.0613),
  ('chair_seat', 1, 'spread_length', -0.7338, 0.06413),
  ('chair_seat', 1, 'spread_width', -0.9226, 0.08258),
  ('chair_seat', 1, 'tilt_deg', 0.5011, 0.45),
  ('chair_seat', 1, 'width', -0.802, 0.06563),
  ('chair_seat', 1, 'z_max', 0.4437, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4389, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.1425, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'area_m2', -1.958, 0.2634),
  ('chair_seat', 2, 'aspect', 0.1997, 0.1401),
  ('chair_seat', 2, 'behind', 0.6712, 0.09757),
  ('chair_seat', 2, 'edge_free', 0.5677, 0.1256),
  ('chair_seat', 2, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 2, 'edge_joined', 0.08415, 0.09671),
  ('chair_seat', 2, 'height', 0.5028, 0.0225),
  ('chair_seat', 2, 'length', -0.6612, 0.1391),
  ('chair_seat', 2, 'rectangularity', 0.657, 0.1083),
  ('chair_seat', 2, 'spread_length', -0.6955, 0.1074),
  ('chair_seat', 2, 'spread_width', -1.153, 0.1531),
  ('chair_seat', 2, 'tilt_deg', 0.8575, 0.6447),
  ('chair_seat', 2, 'width', -0.8609, 0.1207),
  ('chair_seat', 2, 'z_max', 0.5071, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4996, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.142, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'area_m2', -1.943, 0.239),
  ('chair_seat', 3, 'aspect', 0.2166, 0.1551),
  ('chair_seat', 3, 'behind', 0.7341, 0.08062),
  ('chair_seat', 3, 'edge_free', 0.5685, 0.1005),
  ('chair_seat', 3, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 3, 'edge_joined', 0.0771, 0.08794),
  ('chair_seat', 3, 'height', 0.4459, 0.0225),
  ('chair_seat', 3, 'length', -0.6307, 0.1358),
  ('chair_seat', 3, 'rectangularity', 0.6376, 0.1024),
  ('chair_seat', 3, 'spread_length', -0.7006, 0.08989),
  ('chair_seat', 3, 'spread_width', -1.122, 0.1243),
  ('chair_seat', 3, 'tilt_deg', 0.5432, 0.45),
  ('chair_seat', 3, 'width', -0.8473, 0.09128),
  ('chair_seat', 3, 'z_max', 0.4488, 0.0225),
  ('chair_seat', 3, 'z_min', 0.4438, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.1313, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'area_m2', -1.641, 0.125),
  ('chair_seat', 4, 'aspect', 0.128, 0.08195),
  ('chair_seat', 4, 'behind', 0.6223, 0.1067),
  ('chair_seat', 4, 'edge_free', 0.835, 0.08064),
  ('chair_seat', 4, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 4, 'edge_joined', 0.03599, 0.05103),
  ('chair_seat', 4, 'height', 0.4927, 0.0225),
  ('chair_seat', 4, 'length', -0.6755, 0.06766),
  ('chair_seat', 4, 'rectangularity', 0.8528, 0.05249),
  ('chair_seat', 4, 'spread_length', -0.7299, 0.06892),
  ('chair_seat', 4, 'spread_width', -0.947, 0.1081),
  ('chair_seat', 4, 'tilt_deg', 0.6172, 0.5703),
  ('chair_seat', 4, 'width', -0.8034, 0.08364),
  ('chair_seat', 4, 'z_max', 0.4961, 0.0225),
  ('chair_seat', 4, 'z_min', 0.4903, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.09467, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'area_m2', -2.418, 0.1912),
  ('chair_seat', 5, 'aspect', 0.6933, 0.1369),
  ('chair_seat', 5, 'behind', 0.6276, 0.1635),
  ('chair_seat', 5, 'edge_free', 0.5211, 0.2216),
  ('chair_seat', 5, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 5, 'edge_joined', 0.06686, 0.09735),
  ('chair_seat', 5, 'height', 0.4854, 0.0225),
  ('chair_seat', 5, 'length', -0.6788, 0.1012),
  ('chair_seat', 5, 'rectangularity', 0.7062, 0.129),
  ('chair_seat', 5, 'spread_length', -0.7335, 0.103),
  ('chair_seat', 5, 'spread_width', -1.586, 0.1239),
  ('chair_seat', 5, 'tilt_deg', 0.956, 0.6074),
  ('chair_seat', 5, 'width', -1.372, 0.1418),
  ('chair_seat', 5, 'z_max', 0.4889, 0.0225),
  ('chair_seat', 5, 'z_min', 0.4823, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.08667, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'area_m2', -2.227, 0.2405),
  ('chair_seat', 6, 'aspect', 0.3335, 0.1881),
  ('chair_seat', 6, 'behind', 0.6426, 0.1939),
  ('chair_seat', 6, 'edge_free', 0.4853, 0.1747),
  ('chair_seat', 6, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 6, 'edge_joined', 0.1059, 0.1126),
  ('chair_seat', 6, 'height', 0.4454, 0.0225),
  ('chair_seat', 6, 'length', -0.7707, 0.1259),
  ('chair_seat', 6, 'rectangularity', 0.7163, 0.1255),
  ('chair_seat', 6, 'spread_length', -0.8204, 0.101),
  ('chair_seat', 6, 'spread_width', -1.32, 0.1641),
  ('chair_seat', 6, 'tilt_deg', 1.783, 1.291),
  ('chair_seat', 6, 'width', -1.104, 0.1252),
  ('chair_seat', 6, 'z_max', 0.4529, 0.0225),
  ('chair_seat', 6, 'z_min', 0.4401, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.08545, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'area_m2', -1.707, 0.1317),
  ('chair_seat', 7, 'aspect', 0.1047, 0.06976),
  ('chair_seat', 7, 'behind', 0.6951, 0.08206),
  ('chair_seat', 7, 'edge_free', 0.5569, 0.1014),
  ('chair_seat', 7, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 7, 'edge_joined', 0.2212, 0.09758),
  ('chair_seat', 7, 'height', 0.4735, 0.0225),
  ('chair_seat', 7, 'length', -0.6987, 0.0572),
  ('chair_seat', 7, 'rectangularity', 0.8179, 0.06772),
  ('chair_seat', 7, 'spread_length', -0.6978, 0.06763),
  ('chair_seat', 7, 'spread_width', -0.9384, 0.09087),
  ('chair_seat', 7, 'tilt_deg', 0.9959, 0.5955),
  ('chair_seat', 7, 'width', -0.8034, 0.07446),
  ('chair_seat', 7, 'z_max', 0.4789, 0.0225),
  ('chair_seat', 7, 'z_min', 0.4697, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.04953, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'area_m2', -2.972, 0.3141),
  ('chair_seat', 8, 'aspect', 0.7586, 0.3715),
  ('chair_seat', 8, 'behind', 0.7507, 0.07065),
  ('chair_seat', 8, 'edge_free', 0.4861, 0.1097),
  ('chair_seat', 8, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 8, 'edge_joined', 0.1258, 0.09801),
  ('chair_seat', 8, 'height', 0.4742, 0.02536),
  ('chair_seat', 8, 'length', -0.9666, 0.2601),
  ('chair_seat', 8, 'rectangularity', 0.7631, 0.09312),
  ('chair_seat', 8, 'spread_length', -0.9942, 0.2786),
  ('chair_seat', 8, 'spread_width', -1.867, 0.223),
  ('chair_seat', 8, 'tilt_deg', 1.501, 0.6203),
  ('chair_seat', 8, 'width', -1.725, 0.2374),
  ('chair_seat', 8, 'z_max', 0.478, 0.02524),
  ('chair_seat', 8, 'z_min', 0.4712, 0.02566);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.04682, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'area_m2', -3.223, 0.3382),
  ('chair_seat', 9, 'aspect', 0.5704, 0.2425),
  ('chair_seat', 9, 'behind', 0.394, 0.295),
  ('chair_seat', 9, 'edge_free', 0.5439, 0.2296),
  ('chair_seat', 9, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 9, 'edge_joined', 0.02129, 0.03),
  ('chair_seat', 9, 'height', 0.4606, 0.03647),
  ('chair_seat', 9, 'length', -1.096, 0.2479),
  ('chair_seat', 9, 'rectangularity', 0.6385, 0.08338),
  ('chair_seat', 9, 'spread_length', -1.273, 0.2383),
  ('chair_seat', 9, 'spread_width', -1.887, 0.1781),
  ('chair_seat', 9, 'tilt_deg', 2.702, 1.862),
  ('chair_seat', 9, 'width', -1.667, 0.162),
  ('chair_seat', 9, 'z_max', 0.4669, 0.03661),
  ('chair_seat', 9, 'z_min', 0.455, 0.0374);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 10, 0.01513, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 10, 'area_m2', -2.555, 0.1601),
  ('chair_seat', 10, 'aspect', 0.4645, 0.1038),
  ('chair_seat', 10, 'behind', 0.3192, 0.2443),
  ('chair_seat', 10, 'edge_free', 0.6384, 0.1855),
  ('chair_seat', 10, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 10, 'edge_joined', 0.02087, 0.03),
  ('chair_seat', 10, 'height', 0.3714, 0.2364),
  ('chair_seat', 10, 'length', -0.8443, 0.05991),
  ('chair_seat', 10, 'rectangularity', 0.6721, 0.03251),
  ('chair_seat', 10, 'spread_length', -0.9421, 0.1059),
  ('chair_seat', 10, 'spread_width', -1.554, 0.1303),
  ('chair_seat', 10, 'tilt_deg', 1.032, 0.863),
  ('chair_seat', 10, 'width', -1.309, 0.1135),
  ('chair_seat', 10, 'z_max', 0.3756, 0.2379),
  ('chair_seat', 10, 'z_min', 0.3675, 0.2354);

-- chair_back: 384 examples
UPDATE object_class SET prior = 0.02885 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.74, 0.5464)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3876, 0.2702)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.559, 0.2939)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.8054, 0.1832)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9524, 0.1547)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_joined', 0.1013, 0.1387)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.815, 0.07937)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5415, 0.2638)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7769, 0.1217)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6961, 0.2243)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.131, 0.3623)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.55, 3.842)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9317, 0.3037)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.023, 0.09023)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4451, 0.1624)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_back';
DELETE FROM class_density WHERE class = 'chair_back';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1541, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'area_m2', -1.67, 0.1676),
  ('chair_back', 1, 'aspect', 0.1645, 0.09681),
  ('chair_back', 1, 'behind', 0.4935, 0.3036),
  ('chair_back', 1, 'edge_free', 0.905, 0.1126),
  ('chair_back', 1, 'edge_free_top', 0.9988, 0.03),
  ('chair_back', 1, 'edge_joined', 0.02071, 0.0356),
  ('chair_back', 1, 'height', 0.7795, 0.07822),
  ('chair_back', 1, 'length', -0.6652, 0.08829),
  ('chair_back', 1, 'rectangularity', 0.8439, 0.08474),
  ('chair_back', 1, 'spread_length', -0.7659, 0.06178),
  ('chair_back', 1, 'spread_width', -0.983, 0.1249),
  ('chair_back', 1, 'tilt_deg', 80.68, 3.858),
  ('chair_back', 1, 'width', -0.8297, 0.09859),
  ('chair_back', 1, 'z_max', 0.9593, 0.07596),
  ('chair_back', 1, 'z_min', 0.4776, 0.1082);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.1412, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'area_m2', -1.766, 0.2071),
  ('chair_back', 2, 'aspect', 0.5998, 0.1695),
  ('chair_back', 2, 'behind', 0.7132, 0.0985),
  ('chair_back', 2, 'edge_free', 0.8166, 0.09321),
  ('chair_back', 2, 'edge_free_top', 0.9922, 0.03),
  ('chair_back', 2, 'edge_joined', 0.1119, 0.07772),
  ('chair_back', 2, 'height', 0.8292, 0.06384),
  ('chair_back', 2, 'length', -0.4255, 0.128),
  ('chair_back', 2, 'rectangularity', 0.735, 0.08351),
  ('chair_back', 2, 'spread_length', -0.605, 0.107),
  ('chair_back', 2, 'spread_width', -1.307, 0.1653),
  ('chair_back', 2, 'tilt_deg', 80.2, 3.247),
  ('chair_back', 2, 'width', -1.025, 0.1508),
  ('chair_back', 2, 'z_max', 1.062, 0.07897),
  ('chair_back', 2, 'z_min', 0.4356, 0.06766);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.1248, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'area_m2', -1.267, 0.1827),
  ('chair_back', 3, 'aspect', 0.4417, 0.1018),
  ('chair_back', 3, 'behind', 0.4949, 0.2894),
  ('chair_back', 3, 'edge_free', 0.9717, 0.04066),
  ('chair_back', 3, 'edge_free_top', 0.9975, 0.03),
  ('chair_back', 3, 'edge_joined', 0.02214, 0.0353),
  ('chair_back', 3, 'height', 0.8206, 0.05289),
  ('chair_back', 3, 'length', -0.3283, 0.09454),
  ('chair_back', 3, 'rectangularity', 0.8487, 0.07967),
  ('chair_back', 3, 'spread_length', -0.509, 0.09725),
  ('chair_back', 3, 'spread_width', -0.918, 0.1677),
  ('chair_back', 3, 'tilt_deg', 81.14, 4.017),
  ('chair_back', 3, 'width', -0.77, 0.09077),
  ('chair_back', 3, 'z_max', 1.065, 0.05709),
  ('chair_back', 3, 'z_min', 0.3556, 0.05602);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.116, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'area_m2', -1.307, 0.1245),
  ('chair_back', 4, 'aspect', 0.2283, 0.113),
  ('chair_back', 4, 'behind', 0.747, 0.08213),
  ('chair_back', 4, 'edge_free', 0.7505, 0.1474),
  ('chair_back', 4, 'edge_free_top', 0.9869, 0.03201),
  ('chair_back', 4, 'edge_joined', 0.1825, 0.149),
  ('chair_back', 4, 'height', 0.8098, 0.05691),
  ('chair_back', 4, 'length', -0.4401, 0.08898),
  ('chair_back', 4, 'rectangularity', 0.8226, 0.06199),
  ('chair_back', 4, 'spread_length', -0.6114, 0.08956),
  ('chair_back', 4, 'spread_width', -0.7934, 0.08758),
  ('chair_back', 4, 'tilt_deg', 78.38, 2.7),
  ('chair_back', 4, 'width', -0.6684, 0.08359),
  ('chair_back', 4, 'z_max', 1.035, 0.06446),
  ('chair_back', 4, 'z_min', 0.405, 0.04394);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.1126, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'area_m2', -2.606, 0.4356),
  ('chair_back', 5, 'aspect', 0.4576, 0.3226),
  ('chair_back', 5, 'behind', 0.3662, 0.3384),
  ('chair_back', 5, 'edge_free', 0.84, 0.1847),
  ('chair_back', 5, 'edge_free_top', 0.9955, 0.03),
  ('chair_back', 5, 'edge_joined', 0.009007, 0.03),
  ('chair_back', 5, 'height', 0.8854, 0.07438),
  ('chair_back', 5, 'length', -0.8829, 0.2172),
  ('chair_back', 5, 'rectangularity', 0.6936, 0.1252),
  ('chair_back', 5, 'spread_length', -1.005, 0.2392),
  ('chair_back', 5, 'spread_width', -1.616, 0.2731),
  ('chair_back', 5, 'tilt_deg', 80.71, 3.804),
  ('chair_back', 5, 'width', -1.341, 0.2953),
  ('chair_back', 5, 'z_max', 1.025, 0.06817),
  ('chair_back', 5, 'z_min', 0.6475, 0.08573);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.08861, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'area_m2', -1.678, 0.2546),
  ('chair_back', 6, 'aspect', 0.3292, 0.2107),
  ('chair_back', 6, 'behind', 0.4981, 0.3093),
  ('chair_back', 6, 'edge_free', 0.5549, 0.1408),
  ('chair_back', 6, 'edge_free_top', 0.7776, 0.2571),
  ('chair_back', 6, 'edge_joined', 0.2499, 0.1875),
  ('chair_back', 6, 'height', 0.797, 0.06002),
  ('chair_back', 6, 'length', -0.52, 0.1736),
  ('chair_back', 6, 'rectangularity', 0.746, 0.1172),
  ('chair_back', 6, 'spread_length', -0.6482, 0.1645),
  ('chair_back', 6, 'spread_width', -1.115, 0.2098),
  ('chair_back', 6, 'tilt_deg', 79.96, 3.785),
  ('chair_back', 6, 'width', -0.8492, 0.1786),
  ('chair_back', 6, 'z_max', 1.022, 0.09081),
  ('chair_back', 6, 'z_min', 0.4505, 0.08602);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.06573, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'area_m2', -1.472, 0.1194),
  ('chair_back', 7, 'aspect', 0.1062, 0.06824),
  ('chair_back', 7, 'behind', 0.6295, 0.2065),
  ('chair_back', 7, 'edge_free', 0.795, 0.1053),
  ('chair_back', 7, 'edge_free_top', 0.9932, 0.03),
  ('chair_back', 7, 'edge_joined', 0.1419, 0.1066),
  ('chair_back', 7, 'height', 0.8606, 0.05318),
  ('chair_back', 7, 'length', -0.622, 0.06345),
  ('chair_back', 7, 'rectangularity', 0.8873, 0.03879),
  ('chair_back', 7, 'spread_length', -0.6948, 0.06225),
  ('chair_back', 7, 'spread_width', -0.8116, 0.09201),
  ('chair_back', 7, 'tilt_deg', 83.02, 3.421),
  ('chair_back', 7, 'width', -0.7282, 0.06665),
  ('chair_back', 7, 'z_max', 1.075, 0.06553),
  ('chair_back', 7, 'z_min', 0.5509, 0.05598);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.05961, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'area_m2', -2.684, 0.286),
  ('chair_back', 8, 'aspect', 0.6672, 0.3051),
  ('chair_back', 8, 'behind', 0.4716, 0.3169),
  ('chair_back', 8, 'edge_free', 0.553, 0.1876),
  ('chair_back', 8, 'edge_free_top', 0.6507, 0.3323),
  ('chair_back', 8, 'edge_joined', 0.2468, 0.2006),
  ('chair_back', 8, 'height', 0.8153, 0.08084),
  ('chair_back', 8, 'length', -0.8142, 0.2159),
  ('chair_back', 8, 'rectangularity', 0.6948, 0.1302),
  ('chair_back', 8, 'spread_length', -0.9276, 0.2434),
  ('chair_back', 8, 'spread_width', -1.764, 0.2058),
  ('chair_back', 8, 'tilt_deg', 79.81, 3.623),
  ('chair_back', 8, 'width', -1.481, 0.2564),
  ('chair_back', 8, 'z_max', 1.002, 0.09481),
  ('chair_back', 8, 'z_min', 0.5703, 0.08651);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.05799, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'area_m2', -1.231, 0.2067),
  ('chair_back', 9, 'aspect', 0.6925, 0.1573),
  ('chair_back', 9, 'behind', 0.6017, 0.2181),
  ('chair_back', 9, 'edge_free', 0.8541, 0.1001),
  ('chair_back', 9, 'edge_free_top', 0.976, 0.04043),
  ('chair_back', 9, 'edge_joined', 0.06935, 0.06519),
  ('chair_back', 9, 'height', 0.7599, 0.07798),
  ('chair_back', 9, 'length', -0.02039, 0.1151),
  ('chair_back', 9, 'rectangularity', 0.6163, 0.09102),
  ('chair_back', 9, 'spread_length', -0.3996, 0.1328),
  ('chair_back', 9, 'spread_width', -0.8955, 0.1416),
  ('chair_back', 9, 'tilt_deg', 82.62, 3.195),
  ('chair_back', 9, 'width', -0.7129, 0.1227),
  ('chair_back', 9, 'z_max', 1.002, 0.09275),
  ('chair_back', 9, 'z_min', 0.05359, 0.0722);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 10, 0.02936, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 10, 'area_m2', -2.301, 0.4085),
  ('chair_back', 10, 'aspect', 0.3337, 0.2049),
  ('chair_back', 10, 'behind', 0.5523, 0.2507),
  ('chair_back', 10, 'edge_free', 0.7641, 0.1624),
  ('chair_back', 10, 'edge_free_top', 0.9951, 0.03),
  ('chair_back', 10, 'edge_joined', 0.09764, 0.1202),
  ('chair_back', 10, 'height', 0.5776, 0.287),
  ('chair_back', 10, 'length', -0.855, 0.1646),
  ('chair_back', 10, 'rectangularity', 0.7774, 0.06927),
  ('chair_back', 10, 'spread_length', -0.9979, 0.1709),
  ('chair_back', 10, 'spread_width', -1.387, 0.2756),
  ('chair_back', 10, 'tilt_deg', 80.33, 2.627),
  ('chair_back', 10, 'width', -1.189, 0.2354),
  ('chair_back', 10, 'z_max', 0.7344, 0.2896),
  ('chair_back', 10, 'z_min', 0.3303, 0.2741);

-- door: 236 examples
UPDATE object_class SET prior = 0.0177 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.1836, 0.611)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.8272, 0.3045)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.1719, 0.2552)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.154, 0.2467)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.2421, 0.3851)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_joined', 0.344, 0.3455)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.134, 0.2016)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.6233, 0.2754)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.808, 0.1343)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.462, 0.3123)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.3434, 0.4017)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 88.93, 3.578)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.2083, 0.3393)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.008, 0.3057)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1214, 0.2693)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'door';
DELETE FROM class_density WHERE class = 'door';
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.3018, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'area_m2', 0.5482, 0.09176),
  ('door', 1, 'aspect', 0.8004, 0.08653),
  ('door', 1, 'behind', 0.002201, 0.03),
  ('door', 1, 'edge_free', 0.00198, 0.03),
  ('door', 1, 'edge_free_top', 0.003097, 0.03),
  ('door', 1, 'edge_joined', 0.3651, 0.353),
  ('door', 1, 'height', 1.094, 0.07717),
  ('door', 1, 'length', 0.7162, 0.03454),
  ('door', 1, 'rectangularity', 0.9214, 0.05169),
  ('door', 1, 'spread_length', 0.6218, 0.09244),
  ('door', 1, 'spread_width', -0.1535, 0.07362),
  ('door', 1, 'tilt_deg', 89.97, 0.45),
  ('door', 1, 'width', -0.08417, 0.08236),
  ('door', 1, 'z_max', 2.048, 0.04699),
  ('door', 1, 'z_min', 0.001825, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1479, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'area_m2', 0.5029, 0.1705),
  ('door', 2, 'aspect', 0.8273, 0.0862),
  ('door', 2, 'behind', 0.4659, 0.1393),
  ('door', 2, 'edge_free', 0.5214, 0.1443),
  ('door', 2, 'edge_free_top', 0.8982, 0.09062),
  ('door', 2, 'edge_joined', 0.1406, 0.1468),
  ('door', 2, 'height', 1.138, 0.08553),
  ('door', 2, 'length', 0.7861, 0.05452),
  ('door', 2, 'rectangularity', 0.7934, 0.1018),
  ('door', 2, 'spread_length', 0.5489, 0.1769),
  ('door', 2, 'spread_width', -0.1719, 0.1248),
  ('door', 2, 'tilt_deg', 89.95, 0.45),
  ('door', 2, 'width', -0.0412, 0.08614),
  ('door', 2, 'z_max', 2.182, 0.1013),
  ('door', 2, 'z_min', -0.006663, 0.02885);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.1463, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'area_m2', 0.2503, 0.1319),
  ('door', 3, 'aspect', 0.8298, 0.1429),
  ('door', 3, 'behind', 0.00454, 0.03),
  ('door', 3, 'edge_free', 0.004084, 0.03),
  ('door', 3, 'edge_free_top', 0.006394, 0.03849),
  ('door', 3, 'edge_joined', 0.4076, 0.3042),
  ('door', 3, 'height', 1.244, 0.1014),
  ('door', 3, 'length', 0.6734, 0.09457),
  ('door', 3, 'rectangularity', 0.7746, 0.1094),
  ('door', 3, 'spread_length', 0.4467, 0.1761),
  ('door', 3, 'spread_width', -0.2726, 0.115),
  ('door', 3, 'tilt_deg', 89.95, 0.45),
  ('door', 3, 'width', -0.1564, 0.1236),
  ('door', 3, 'z_max', 2.067, 0.06922),
  ('door', 3, 'z_min', 0.1007, 0.1449);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.08522, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'area_m2', -1.123, 1.047),
  ('door', 4, 'aspect', 0.7851, 0.4361),
  ('door', 4, 'behind', 0.09882, 0.1916),
  ('door', 4, 'edge_free', 0.05469, 0.1116),
  ('door', 4, 'edge_free_top', 0.022, 0.06754),
  ('door', 4, 'edge_joined', 0.3741, 0.2832),
  ('door', 4, 'height', 0.9477, 0.4266),
  ('door', 4, 'length', -0.005623, 0.5446),
  ('door', 4, 'rectangularity', 0.7335, 0.1199),
  ('door', 4, 'spread_length', -0.1095, 0.5167),
  ('door', 4, 'spread_width', -0.9932, 0.5574),
  ('door', 4, 'tilt_deg', 88.55, 1.535),
  ('door', 4, 'width', -0.7907, 0.5765),
  ('door', 4, 'z_max', 1.45, 0.5875),
  ('door', 4, 'z_min', 0.393, 0.4487);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.06551, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'area_m2', -0.04285, 0.1846),
  ('door', 5, 'aspect', 0.4584, 0.1942),
  ('door', 5, 'behind', 0.3376, 0.2801),
  ('door', 5, 'edge_free', 0.3208, 0.3035),
  ('door', 5, 'edge_free_top', 0.457, 0.343),
  ('door', 5, 'edge_joined', 0.3338, 0.2842),
  ('door', 5, 'height', 1.426, 0.08491),
  ('door', 5, 'length', 0.3392, 0.1748),
  ('door', 5, 'rectangularity', 0.7757, 0.09054),
  ('door', 5, 'spread_length', 0.1187, 0.178),
  ('door', 5, 'spread_width', -0.2224, 0.1361),
  ('door', 5, 'tilt_deg', 89.54, 1.064),
  ('door', 5, 'width', -0.1192, 0.08862),
  ('door', 5, 'z_max', 2.124, 0.1016),
  ('door', 5, 'z_min', 0.6901, 0.1893);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.06061, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'area_m2', 0.5127, 0.1477),
  ('door', 6, 'aspect', 0.7992, 0.1149),
  ('door', 6, 'behind', 0.6058, 0.1195),
  ('door', 6, 'edge_free', 0.1607, 0.1272),
  ('door', 6, 'edge_free_top', 0.4792, 0.1618),
  ('door', 6, 'edge_joined', 0.7239, 0.2193),
  ('door', 6, 'height', 1.073, 0.07694),
  ('door', 6, 'length', 0.7773, 0.06327),
  ('door', 6, 'rectangularity', 0.7894, 0.07528),
  ('door', 6, 'spread_length', 0.6564, 0.1384),
  ('door', 6, 'spread_width', -0.03541, 0.1723),
  ('door', 6, 'tilt_deg', 89.11, 1.823),
  ('door', 6, 'width', -0.02187, 0.1187),
  ('door', 6, 'z_max', 2.158, 0.1067),
  ('door', 6, 'z_min', 0.002973, 0.04268);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.05024, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'area_m2', -0.3831, 0.4269),
  ('door', 7, 'aspect', 1.546, 0.3316),
  ('door', 7, 'behind', 0.1083, 0.1465),
  ('door', 7, 'edge_free', 0.2601, 0.3146),
  ('door', 7, 'edge_free_top', 0.4358, 0.3917),
  ('door', 7, 'edge_joined', 0.1597, 0.1497),
  ('door', 7, 'height', 1.114, 0.07213),
  ('door', 7, 'length', 0.7073, 0.1071),
  ('door', 7, 'rectangularity', 0.7885, 0.113),
  ('door', 7, 'spread_length', 0.5481, 0.1575),
  ('door', 7, 'spread_width', -1.002, 0.3415),
  ('door', 7, 'tilt_deg', 89.89, 0.5926),
  ('door', 7, 'width', -0.8391, 0.3759),
  ('door', 7, 'z_max', 2.084, 0.1236),
  ('door', 7, 'z_min', 0.04255, 0.1007);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.03832, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'area_m2', -0.1589, 0.1531),
  ('door', 8, 'aspect', 1.277, 0.1479),
  ('door', 8, 'behind', 0.2196, 0.1363),
  ('door', 8, 'edge_free', 0.3146, 0.1563),
  ('door', 8, 'edge_free_top', 0.07412, 0.1012),
  ('door', 8, 'edge_joined', 0.0718, 0.08466),
  ('door', 8, 'height', 1.078, 0.1137),
  ('door', 8, 'length', 0.7871, 0.1015),
  ('door', 8, 'rectangularity', 0.6429, 0.08106),
  ('door', 8, 'spread_length', 0.7193, 0.107),
  ('door', 8, 'spread_width', -1.086, 0.1733),
  ('door', 8, 'tilt_deg', 79.2, 2.876),
  ('door', 8, 'width', -0.4902, 0.1408),
  ('door', 8, 'z_max', 1.971, 0.1686),
  ('door', 8, 'z_min', 0.008918, 0.05278);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.03089, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'area_m2', -0.1897, 0.1953),
  ('door', 9, 'aspect', 0.4886, 0.1315),
  ('door', 9, 'behind', 0.1899, 0.2478),
  ('door', 9, 'edge_free', 0.03391, 0.05494),
  ('door', 9, 'edge_free_top', 0.06561, 0.1017),
  ('door', 9, 'edge_joined', 0.8621, 0.1011),
  ('door', 9, 'height', 1.309, 0.1055),
  ('door', 9, 'length', 0.4064, 0.1013),
  ('door', 9, 'rectangularity', 0.6076, 0.06985),
  ('door', 9, 'spread_length', -0.009499, 0.1013),
  ('door', 9, 'spread_width', -0.3133, 0.1097),
  ('door', 9, 'tilt_deg', 89.83, 0.7125),
  ('door', 9, 'width', -0.0822, 0.09721),
  ('door', 9, 'z_max', 2.002, 0.14),
  ('door', 9, 'z_min', 0.4346, 0.1841);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.02317, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'area_m2', -0.3369, 0.2303),
  ('door', 10, 'aspect', 0.6063, 0.1492),
  ('door', 10, 'behind', 0.2655, 0.07847),
  ('door', 10, 'edge_free', 0.2716, 0.06626),
  ('door', 10, 'edge_free_top', 0.04841, 0.09247),
  ('door', 10, 'edge_joined', 0.06149, 0.0841),
  ('door', 10, 'height', 0.8015, 0.2065),
  ('door', 10, 'length', 0.4084, 0.1235),
  ('door', 10, 'rectangularity', 0.6069, 0.1289),
  ('door', 10, 'spread_length', 0.3215, 0.08296),
  ('door', 10, 'spread_width', -0.6213, 0.1358),
  ('door', 10, 'tilt_deg', 73.44, 2.9),
  ('door', 10, 'width', -0.198, 0.08541),
  ('door', 10, 'z_max', 1.279, 0.2411),
  ('door', 10, 'z_min', 0.2801, 0.2236);

-- window: 520 examples
UPDATE object_class SET prior = 0.03897 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', -0.4188, 0.7921)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.4896, 0.4184)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.07886, 0.1475)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.06337, 0.1882)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_joined', 0.3833, 0.3491)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.491, 0.2215)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.1567, 0.3327)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8018, 0.1446)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.1455, 0.3789)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.4482, 0.5844)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.68, 0.5746)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.3355, 0.4972)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.008, 0.2869)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 1.034, 0.228)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'window';
DELETE FROM class_density WHERE class = 'window';
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.1654, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'area_m2', -0.04122, 0.2221),
  ('window', 1, 'aspect', 0.3214, 0.2037),
  ('window', 1, 'behind', 3.48e-05, 0.03),
  ('window', 1, 'edge_free', 0.008493, 0.03),
  ('window', 1, 'edge_free_top', 0.002472, 0.03),
  ('window', 1, 'edge_joined', 0.5381, 0.3654),
  ('window', 1, 'height', 1.429, 0.1227),
  ('window', 1, 'length', 0.2088, 0.1313),
  ('window', 1, 'rectangularity', 0.8743, 0.06297),
  ('window', 1, 'spread_length', 0.198, 0.1525),
  ('window', 1, 'spread_width', -0.2106, 0.161),
  ('window', 1, 'tilt_deg', 89.8, 0.45),
  ('window', 1, 'width', -0.1126, 0.1702),
  ('window', 1, 'z_max', 2.029, 0.1832),
  ('window', 1, 'z_min', 0.9461, 0.08141);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1567, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'area_m2', 0.3539, 0.2177),
  ('window', 2, 'aspect', 0.1872, 0.1291),
  ('window', 2, 'behind', 3.664e-05, 0.03),
  ('window', 2, 'edge_free', 0.00136, 0.03),
  ('window', 2, 'edge_free_top', 0.0009519, 0.03),
  ('window', 2, 'edge_joined', 0.04807, 0.07791),
  ('window', 2, 'height', 1.537, 0.09113),
  ('window', 2, 'length', 0.3295, 0.1117),
  ('window', 2, 'rectangularity', 0.895, 0.09428),
  ('window', 2, 'spread_length', 0.4494, 0.1082),
  ('window', 2, 'spread_width', 0.2123, 0.1281),
  ('window', 2, 'tilt_deg', 89.86, 0.45),
  ('window', 2, 'width', 0.1423, 0.1236),
  ('window', 2, 'z_max', 2.188, 0.1211),
  ('window', 2, 'z_min', 0.9009, 0.05995);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.1178, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'area_m2', -0.06461, 0.3622),
  ('window', 3, 'aspect', 0.2528, 0.1676),
  ('window', 3, 'behind', 0.000101, 0.03),
  ('window', 3, 'edge_free', 0.1155, 0.1151),
  ('window', 3, 'edge_free_top', 0.03462, 0.06743),
  ('window', 3, 'edge_joined', 0.2999, 0.3104),
  ('window', 3, 'height', 1.567, 0.1718),
  ('window', 3, 'length', 0.2939, 0.13),
  ('window', 3, 'rectangularity', 0.7095, 0.2067),
  ('window', 3, 'spread_length', 0.3037, 0.2023),
  ('window', 3, 'spread_width', -0.07865, 0.2242),
  ('window', 3, 'tilt_deg', 89.73, 0.4838),
  ('window', 3, 'width', 0.04114, 0.1428),
  ('window', 3, 'z_max', 2.175, 0.1497),
  ('window', 3, 'z_min', 0.9969, 0.131);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.115, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'area_m2', -0.5845, 0.3873),
  ('window', 4, 'aspect', 0.5728, 0.3009),
  ('window', 4, 'behind', 5.07e-05, 0.03),
  ('window', 4, 'edge_free', 0.1543, 0.1174),
  ('window', 4, 'edge_free_top', 0.005591, 0.03),
  ('window', 4, 'edge_joined', 0.4012, 0.2904),
  ('window', 4, 'height', 1.792, 0.1257),
  ('window', 4, 'length', 0.09143, 0.2286),
  ('window', 4, 'rectangularity', 0.8277, 0.08067),
  ('window', 4, 'spread_length', 0.008349, 0.2428),
  ('window', 4, 'spread_width', -0.6459, 0.2587),
  ('window', 4, 'tilt_deg', 89.85, 0.45),
  ('window', 4, 'width', -0.4814, 0.2371),
  ('window', 4, 'z_max', 2.142, 0.1373),
  ('window', 4, 'z_min', 1.465, 0.1617);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.1145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'area_m2', -0.8068, 0.3038),
  ('window', 5, 'aspect', 0.3974, 0.2551),
  ('window', 5, 'behind', 5.012e-05, 0.03),
  ('window', 5, 'edge_free', 0.004511, 0.03),
  ('window', 5, 'edge_free_top', 0.002427, 0.03),
  ('window', 5, 'edge_joined', 0.7241, 0.2646),
  ('window', 5, 'height', 1.404, 0.1411),
  ('window', 5, 'length', -0.05899, 0.176),
  ('window', 5, 'rectangularity', 0.761, 0.1293),
  ('window', 5, 'spread_length', -0.129, 0.1988),
  ('window', 5, 'spread_width', -0.6434, 0.2105),
  ('window', 5, 'tilt_deg', 89.76, 0.45),
  ('window', 5, 'width', -0.4564, 0.2152),
  ('window', 5, 'z_max', 1.878, 0.2131),
  ('window', 5, 'z_min', 0.9955, 0.08881);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.09936, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'area_m2', -1.304, 0.4911),
  ('window', 6, 'aspect', 1.218, 0.3399),
  ('window', 6, 'behind', 5.777e-05, 0.03),
  ('window', 6, 'edge_free', 0.004048, 0.03),
  ('window', 6, 'edge_free_top', 0.007254, 0.03),
  ('window', 6, 'edge_joined', 0.3507, 0.2747),
  ('window', 6, 'height', 1.266, 0.1903),
  ('window', 6, 'length', 0.1143, 0.1964),
  ('window', 6, 'rectangularity', 0.7459, 0.1373),
  ('window', 6, 'spread_length', 0.0599, 0.2316),
  ('window', 6, 'spread_width', -1.306, 0.3888),
  ('window', 6, 'tilt_deg', 89.19, 0.8841),
  ('window', 6, 'width', -1.104, 0.3118),
  ('window', 6, 'z_max', 1.702, 0.3638),
  ('window', 6, 'z_min', 0.9199, 0.05769);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.0865, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'area_m2', -0.62, 0.4239),
  ('window', 7, 'aspect', 0.5075, 0.3437),
  ('window', 7, 'behind', 0.0004359, 0.03),
  ('window', 7, 'edge_free', 0.3674, 0.2211),
  ('window', 7, 'edge_free_top', 0.5343, 0.2883),
  ('window', 7, 'edge_joined', 0.3461, 0.2218),
  ('window', 7, 'height', 1.39, 0.1791),
  ('window', 7, 'length', 0.07216, 0.198),
  ('window', 7, 'rectangularity', 0.7876, 0.12),
  ('window', 7, 'spread_length', 0.058, 0.1971),
  ('window', 7, 'spread_width', -0.5595, 0.3033),
  ('window', 7, 'tilt_deg', 89.69, 0.45),
  ('window', 7, 'width', -0.4353, 0.3221),
  ('window', 7, 'z_max', 1.887, 0.2666),
  ('window', 7, 'z_min', 0.9922, 0.09696);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.04628, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'area_m2', -2.242, 0.5184),
  ('window', 8, 'aspect', 0.5189, 0.3001),
  ('window', 8, 'behind', 0.03043, 0.1429),
  ('window', 8, 'edge_free', 0.1023, 0.1401),
  ('window', 8, 'edge_free_top', 0.06827, 0.1605),
  ('window', 8, 'edge_joined', 0.594, 0.2885),
  ('window', 8, 'height', 1.454, 0.3525),
  ('window', 8, 'length', -0.6875, 0.2704),
  ('window', 8, 'rectangularity', 0.7167, 0.1064),
  ('window', 8, 'spread_length', -0.8, 0.2805),
  ('window', 8, 'spread_width', -1.418, 0.3615),
  ('window', 8, 'tilt_deg', 89, 1.59),
  ('window', 8, 'width', -1.206, 0.3261),
  ('window', 8, 'z_max', 1.696, 0.3573),
  ('window', 8, 'z_min', 1.269, 0.3511);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.02868, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'area_m2', 1.144, 0.3804),
  ('window', 9, 'aspect', 0.9689, 0.3107),
  ('window', 9, 'behind', 0.0002002, 0.03),
  ('window', 9, 'edge_free', 0.04363, 0.1242),
  ('window', 9, 'edge_free_top', 0.03749, 0.1127),
  ('window', 9, 'edge_joined', 0.2826, 0.3049),
  ('window', 9, 'height', 1.515, 0.07675),
  ('window', 9, 'length', 1.21, 0.2446),
  ('window', 9, 'rectangularity', 0.7665, 0.1772),
  ('window', 9, 'spread_length', 1.189, 0.204),
  ('window', 9, 'spread_width', 0.1895, 0.2536),
  ('window', 9, 'tilt_deg', 89.87, 0.45),
  ('window', 9, 'width', 0.2415, 0.2328),
  ('window', 9, 'z_max', 2.212, 0.2094),
  ('window', 9, 'z_min', 0.8619, 0.1718);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.01981, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'area_m2', -1.441, 0.4366),
  ('window', 10, 'aspect', 1.355, 0.3178),
  ('window', 10, 'behind', 0.07825, 0.1489),
  ('window', 10, 'edge_free', 0.212, 0.1729),
  ('window', 10, 'edge_free_top', 0.09051, 0.1392),
  ('window', 10, 'edge_joined', 0.1735, 0.1305),
  ('window', 10, 'height', 1.584, 0.3336),
  ('window', 10, 'length', 0.1769, 0.1356),
  ('window', 10, 'rectangularity', 0.6607, 0.1163),
  ('window', 10, 'spread_length', 0.1528, 0.1242),
  ('window', 10, 'spread_width', -1.448, 0.3682),
  ('window', 10, 'tilt_deg', 87.26, 4.038),
  ('window', 10, 'width', -1.178, 0.3417),
  ('window', 10, 'z_max', 1.905, 0.3548),
  ('window', 10, 'z_min', 1.192, 0.4111);

-- whiteboard: 202 examples
UPDATE object_class SET prior = 0.01513 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.01331, 0.8833)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4399, 0.3222)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.001636, 0.01215)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.0228, 0.04036)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.02395, 0.03891)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_joined', 0.7852, 0.194)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.395, 0.165)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.338, 0.4236)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.8081, 0.08189)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.1753, 0.4325)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.3536, 0.4783)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.76, 0.6597)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', -0.1052, 0.4812)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 1.958, 0.2586)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.8643, 0.177)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'whiteboard';
DELETE FROM class_density WHERE class = 'whiteboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.2039, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'area_m2', 0.2952, 0.1416),
  ('whiteboard', 1, 'aspect', 0.1616, 0.1018),
  ('whiteboard', 1, 'behind', 0.003038, 0.03),
  ('whiteboard', 1, 'edge_free', 0.02273, 0.03),
  ('whiteboard', 1, 'edge_free_top', 0.02007, 0.03182),
  ('whiteboard', 1, 'edge_joined', 0.852, 0.1088),
  ('whiteboard', 1, 'height', 1.477, 0.06283),
  ('whiteboard', 1, 'length', 0.3118, 0.09474),
  ('whiteboard', 1, 'rectangularity', 0.8485, 0.05636),
  ('whiteboard', 1, 'spread_length', 0.1959, 0.1065),
  ('whiteboard', 1, 'spread_width', -0.04901, 0.09565),
  ('whiteboard', 1, 'tilt_deg', 89.97, 0.45),
  ('whiteboard', 1, 'width', 0.1502, 0.08716),
  ('whiteboard', 1, 'z_max', 2.081, 0.09222),
  ('whiteboard', 1, 'z_min', 0.8682, 0.05716);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.1901, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'area_m2', 0.5557, 0.2177),
  ('whiteboard', 2, 'aspect', 0.5489, 0.1363),
  ('whiteboard', 2, 'behind', 9.895e-05, 0.03),
  ('whiteboard', 2, 'edge_free', 0.01771, 0.03),
  ('whiteboard', 2, 'edge_free_top', 0.02079, 0.03),
  ('whiteboard', 2, 'edge_joined', 0.7641, 0.1165),
  ('whiteboard', 2, 'height', 1.406, 0.07408),
  ('whiteboard', 2, 'length', 0.6853, 0.1442),
  ('whiteboard', 2, 'rectangularity', 0.7706, 0.07512),
  ('whiteboard', 2, 'spread_length', 0.4694, 0.1506),
  ('whiteboard', 2, 'spread_width', -0.2144, 0.1657),
  ('whiteboard', 2, 'tilt_deg', 89.97, 0.45),
  ('whiteboard', 2, 'width', 0.1364, 0.1074),
  ('whiteboard', 2, 'z_max', 2.025, 0.1143),
  ('whiteboard', 2, 'z_min', 0.857, 0.06327);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.1568, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'area_m2', 0.7873, 0.1517),
  ('whiteboard', 3, 'aspect', 0.5098, 0.1508),
  ('whiteboard', 3, 'behind', 0.00728, 0.04015),
  ('whiteboard', 3, 'edge_free', 0.03292, 0.03437),
  ('whiteboard', 3, 'edge_free_top', 0.04268, 0.05443),
  ('whiteboard', 3, 'edge_joined', 0.8771, 0.08804),
  ('whiteboard', 3, 'height', 1.457, 0.06494),
  ('whiteboard', 3, 'length', 0.713, 0.1297),
  ('whiteboard', 3, 'rectangularity', 0.8798, 0.03),
  ('whiteboard', 3, 'spread_length', 0.5793, 0.1139),
  ('whiteboard', 3, 'spread_width', -0.01062, 0.1085),
  ('whiteboard', 3, 'tilt_deg', 89.98, 0.45),
  ('whiteboard', 3, 'width', 0.2032, 0.07615),
  ('whiteboard', 3, 'z_max', 2.094, 0.07422),
  ('whiteboard', 3, 'z_min', 0.8553, 0.06548);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.1018, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'area_m2', 0.01028, 0.1819),
  ('whiteboard', 4, 'aspect', 0.1522, 0.1044),
  ('whiteboard', 4, 'behind', 0.02059, 0.0889),
  ('whiteboard', 4, 'edge_free', 0.01679, 0.03),
  ('whiteboard', 4, 'edge_free_top', 0.02212, 0.03332),
  ('whiteboard', 4, 'edge_joined', 0.8005, 0.1242),
  ('whiteboard', 4, 'height', 1.39, 0.1026),
  ('whiteboard', 4, 'length', 0.2166, 0.09911),
  ('whiteboard', 4, 'rectangularity', 0.7668, 0.07202),
  ('whiteboard', 4, 'spread_length', 0.0575, 0.1352),
  ('whiteboard', 4, 'spread_width', -0.2861, 0.1264),
  ('whiteboard', 4, 'tilt_deg', 89.97, 0.45),
  ('whiteboard', 4, 'width', 0.06438, 0.1224),
  ('whiteboard', 4, 'z_max', 2.018, 0.1041),
  ('whiteboard', 4, 'z_min', 0.8759, 0.05366);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.07222, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'area_m2', -0.5949, 0.2554),
  ('whiteboard', 5, 'aspect', 0.5973, 0.2048),
  ('whiteboard', 5, 'behind', 0.0002605, 0.03),
  ('whiteboard', 5, 'edge_free', 0.01248, 0.03),
  ('whiteboard', 5, 'edge_free_top', 0.01513, 0.03),
  ('whiteboard', 5, 'edge_joined', 0.7503, 0.184),
  ('whiteboard', 5, 'height', 1.455, 0.09567),
  ('whiteboard', 5, 'length', 0.1343, 0.09975),
  ('whiteboard', 5, 'rectangularity', 0.7726, 0.08402),
  ('whiteboard', 5, 'spread_length', -0.07879, 0.1246),
  ('whiteboard', 5, 'spread_width', -0.6423, 0.2002),
  ('whiteboard', 5, 'tilt_deg', 89.91, 0.45),
  ('whiteboard', 5, 'width', -0.463, 0.1728),
  ('whiteboard', 5, 'z_max', 2.018, 0.1164),
  ('whiteboard', 5, 'z_min', 0.9336, 0.1597);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.06344, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'area_m2', 0.1614, 0.4741),
  ('whiteboard', 6, 'aspect', 0.7101, 0.4541),
  ('whiteboard', 6, 'behind', 0.0002965, 0.03),
  ('whiteboard', 6, 'edge_free', 0.07542, 0.1822),
  ('whiteboard', 6, 'edge_free_top', 0.1201, 0.1652),
  ('whiteboard', 6, 'edge_joined', 0.4401, 0.1958),
  ('whiteboard', 6, 'height', 1.085, 0.2894),
  ('whiteboard', 6, 'length', 0.5595, 0.2359),
  ('whiteboard', 6, 'rectangularity', 0.7844, 0.06432),
  ('whiteboard', 6, 'spread_length', 0.4308, 0.248),
  ('whiteboard', 6, 'spread_width', -0.32, 0.4179),
  ('whiteboard', 6, 'tilt_deg', 88.56, 1.012),
  ('whiteboard', 6, 'width', -0.1506, 0.4013),
  ('whiteboard', 6, 'z_max', 1.592, 0.4654),
  ('whiteboard', 6, 'z_min', 0.4471, 0.2659);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.0589, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'area_m2', -1.934, 0.4391),
  ('whiteboard', 7, 'aspect', 0.3467, 0.2209),
  ('whiteboard', 7, 'behind', 0.0003193, 0.03),
  ('whiteboard', 7, 'edge_free', 0.02566, 0.06036),
  ('whiteboard', 7, 'edge_free_top', 0.01752, 0.03135),
  ('whiteboard', 7, 'edge_joined', 0.6996, 0.211),
  ('whiteboard', 7, 'height', 1.354, 0.231),
  ('whiteboard', 7, 'length', -0.6403, 0.205),
  ('whiteboard', 7, 'rectangularity', 0.7406, 0.06975),
  ('whiteboard', 7, 'spread_length', -0.8544, 0.2194),
  ('whiteboard', 7, 'spread_width', -1.227, 0.3162),
  ('whiteboard', 7, 'tilt_deg', 89.51, 0.5402),
  ('whiteboard', 7, 'width', -0.987, 0.2704),
  ('whiteboard', 7, 'z_max', 1.617, 0.2464),
  ('whiteboard', 7, 'z_min', 1.11, 0.2664);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.05788, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'area_m2', -0.9486, 0.5242),
  ('whiteboard', 8, 'aspect', 0.5078, 0.3134),
  ('whiteboard', 8, 'behind', 0.000325, 0.03),
  ('whiteboard', 8, 'edge_free', 0.03301, 0.06857),
  ('whiteboard', 8, 'edge_free_top', 0.00671, 0.03),
  ('whiteboard', 8, 'edge_joined', 0.6806, 0.2861),
  ('whiteboard', 8, 'height', 1.215, 0.08451),
  ('whiteboard', 8, 'length', -0.1399, 0.327),
  ('whiteboard', 8, 'rectangularity', 0.8527, 0.03793),
  ('whiteboard', 8, 'spread_length', -0.2614, 0.3274),
  ('whiteboard', 8, 'spread_width', -0.8183, 0.2875),
  ('whiteboard', 8, 'tilt_deg', 88.47, 1.249),
  ('whiteboard', 8, 'width', -0.6477, 0.2774),
  ('whiteboard', 8, 'z_max', 1.527, 0.1501),
  ('whiteboard', 8, 'z_min', 0.877, 0.06032);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 9, 0.04498, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 9, 'area_m2', -1.691, 0.3654),
  ('whiteboard', 9, 'aspect', 1.111, 0.2315),
  ('whiteboard', 9, 'behind', 0.0004182, 0.03),
  ('whiteboard', 9, 'edge_free', 0.005786, 0.03),
  ('whiteboard', 9, 'edge_free_top', 0.005297, 0.03),
  ('whiteboard', 9, 'edge_joined', 0.9671, 0.04452),
  ('whiteboard', 9, 'height', 1.424, 0.1383),
  ('whiteboard', 9, 'length', -0.1375, 0.1559),
  ('whiteboard', 9, 'rectangularity', 0.7387, 0.03433),
  ('whiteboard', 9, 'spread_length', -0.344, 0.1391),
  ('whiteboard', 9, 'spread_width', -1.478, 0.2443),
  ('whiteboard', 9, 'tilt_deg', 89.89, 0.45),
  ('whiteboard', 9, 'width', -1.248, 0.2791),
  ('whiteboard', 9, 'z_max', 1.922, 0.1572),
  ('whiteboard', 9, 'z_min', 1.058, 0.1591);

-- shelf: 890 examples
UPDATE object_class SET prior = 0.06682 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.62, 0.8015)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.8984, 0.4416)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5444, 0.3299)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3258, 0.1813)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4252, 0.3566)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_joined', 0.2923, 0.2446)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9151, 0.4965)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.1673, 0.5391)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6953, 0.1317)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.3062, 0.5351)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.274, 0.3868)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 52.16, 43.32)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.07, 0.3577)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.196, 0.6211)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5886, 0.5807)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'shelf';
DELETE FROM class_density WHERE class = 'shelf';
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.1846, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'area_m2', -1.636, 0.5894),
  ('shelf', 1, 'aspect', 0.8367, 0.455),
  ('shelf', 1, 'behind', 0.5782, 0.2973),
  ('shelf', 1, 'edge_free', 0.4092, 0.197),
  ('shelf', 1, 'edge_free_top', 0.5464, 0.3459),
  ('shelf', 1, 'edge_joined', 0.1981, 0.2369),
  ('shelf', 1, 'height', 1.065, 0.3189),
  ('shelf', 1, 'length', -0.1946, 0.3842),
  ('shelf', 1, 'rectangularity', 0.6788, 0.1353),
  ('shelf', 1, 'spread_length', -0.3926, 0.4004),
  ('shelf', 1, 'spread_width', -1.259, 0.3629),
  ('shelf', 1, 'tilt_deg', 89.3, 2.462),
  ('shelf', 1, 'width', -1.031, 0.3298),
  ('shelf', 1, 'z_max', 1.459, 0.3806),
  ('shelf', 1, 'z_min', 0.6073, 0.3578);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.1261, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'area_m2', -0.6361, 0.2864),
  ('shelf', 2, 'aspect', 1.472, 0.1823),
  ('shelf', 2, 'behind', 0.6805, 0.19),
  ('shelf', 2, 'edge_free', 0.4075, 0.0776),
  ('shelf', 2, 'edge_free_top', 0.551, 0.2854),
  ('shelf', 2, 'edge_joined', 0.263, 0.2309),
  ('shelf', 2, 'height', 1.041, 0.1146),
  ('shelf', 2, 'length', 0.6054, 0.1336),
  ('shelf', 2, 'rectangularity', 0.7, 0.1264),
  ('shelf', 2, 'spread_length', 0.4629, 0.1583),
  ('shelf', 2, 'spread_width', -1.084, 0.1937),
  ('shelf', 2, 'tilt_deg', 89.59, 2.509),
  ('shelf', 2, 'width', -0.8664, 0.1765),
  ('shelf', 2, 'z_max', 1.902, 0.2001),
  ('shelf', 2, 'z_min', 0.06057, 0.1195);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.1211, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'area_m2', -2.25, 0.9619),
  ('shelf', 3, 'aspect', 0.5929, 0.3983),
  ('shelf', 3, 'behind', 0.005331, 0.03),
  ('shelf', 3, 'edge_free', 0.0113, 0.03),
  ('shelf', 3, 'edge_free_top', 0.007578, 0.03),
  ('shelf', 3, 'edge_joined', 0.1103, 0.1409),
  ('shelf', 3, 'height', 0.9231, 0.4709),
  ('shelf', 3, 'length', -0.6603, 0.5253),
  ('shelf', 3, 'rectangularity', 0.7291, 0.1339),
  ('shelf', 3, 'spread_length', -0.7423, 0.5246),
  ('shelf', 3, 'spread_width', -1.443, 0.5544),
  ('shelf', 3, 'tilt_deg', 89, 2.744),
  ('shelf', 3, 'width', -1.253, 0.5567),
  ('shelf', 3, 'z_max', 1.123, 0.5428),
  ('shelf', 3, 'z_min', 0.6932, 0.4403);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.1054, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'area_m2', -1.378, 0.3508),
  ('shelf', 4, 'aspect', 0.7831, 0.2798),
  ('shelf', 4, 'behind', 0.7487, 0.08722),
  ('shelf', 4, 'edge_free', 0.3188, 0.1054),
  ('shelf', 4, 'edge_free_top', 0.4252, 0.1127),
  ('shelf', 4, 'edge_joined', 0.547, 0.1898),
  ('shelf', 4, 'height', 1.75, 0.2008),
  ('shelf', 4, 'length', -0.1744, 0.2546),
  ('shelf', 4, 'rectangularity', 0.7928, 0.1143),
  ('shelf', 4, 'spread_length', -0.2953, 0.2706),
  ('shelf', 4, 'spread_width', -1.005, 0.2036),
  ('shelf', 4, 'tilt_deg', 2.077, 2.826),
  ('shelf', 4, 'width', -0.9575, 0.143),
  ('shelf', 4, 'z_max', 1.757, 0.2017),
  ('shelf', 4, 'z_min', 1.74, 0.2024);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.09923, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'area_m2', -1.697, 0.376),
  ('shelf', 5, 'aspect', 0.956, 0.3272),
  ('shelf', 5, 'behind', 0.7515, 0.06342),
  ('shelf', 5, 'edge_free', 0.4211, 0.06081),
  ('shelf', 5, 'edge_free_top', 0.4252, 0.1127),
  ('shelf', 5, 'edge_joined', 0.287, 0.1242),
  ('shelf', 5, 'height', 0.465, 0.06803),
  ('shelf', 5, 'length', -0.1437, 0.2452),
  ('shelf', 5, 'rectangularity', 0.6461, 0.117),
  ('shelf', 5, 'spread_length', -0.2639, 0.2516),
  ('shelf', 5, 'spread_width', -1.371, 0.2836),
  ('shelf', 5, 'tilt_deg', 3.258, 3.345),
  ('shelf', 5, 'width', -1.1, 0.2438),
  ('shelf', 5, 'z_max', 0.4781, 0.0722),
  ('shelf', 5, 'z_min', 0.4554, 0.07076);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.09399, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'area_m2', -1.051, 0.2701),
  ('shelf', 6, 'aspect', 1.112, 0.2156),
  ('shelf', 6, 'behind', 0.7614, 0.07854),
  ('shelf', 6, 'edge_free', 0.3943, 0.09996),
  ('shelf', 6, 'edge_free_top', 0.6109, 0.2247),
  ('shelf', 6, 'edge_joined', 0.2794, 0.2525),
  ('shelf', 6, 'height', 0.7276, 0.1607),
  ('shelf', 6, 'length', 0.2611, 0.1385),
  ('shelf', 6, 'rectangularity', 0.6434, 0.123),
  ('shelf', 6, 'spread_length', 0.1144, 0.1627),
  ('shelf', 6, 'spread_width', -1.101, 0.2059),
  ('shelf', 6, 'tilt_deg', 89.37, 2.937),
  ('shelf', 6, 'width', -0.8511, 0.181),
  ('shelf', 6, 'z_max', 1.308, 0.1854),
  ('shelf', 6, 'z_min', 0.01538, 0.06199);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.06662, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'area_m2', -2.314, 0.7035),
  ('shelf', 7, 'aspect', 0.5679, 0.3946),
  ('shelf', 7, 'behind', 0.008628, 0.03),
  ('shelf', 7, 'edge_free', 0.2301, 0.1815),
  ('shelf', 7, 'edge_free_top', 0.4252, 0.1127),
  ('shelf', 7, 'edge_joined', 0.3688, 0.2376),
  ('shelf', 7, 'height', 0.08335, 0.0418),
  ('shelf', 7, 'length', -0.7056, 0.466),
  ('shelf', 7, 'rectangularity', 0.7229, 0.09556),
  ('shelf', 7, 'spread_length', -0.7838, 0.4699),
  ('shelf', 7, 'spread_width', -1.47, 0.3347),
  ('shelf', 7, 'tilt_deg', 2.041, 3.59),
  ('shelf', 7, 'width', -1.273, 0.3604),
  ('shelf', 7, 'z_max', 0.09172, 0.05225),
  ('shelf', 7, 'z_min', 0.07443, 0.04716);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.06454, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'area_m2', -2.496, 0.386),
  ('shelf', 8, 'aspect', 0.744, 0.4055),
  ('shelf', 8, 'behind', 0.5887, 0.1913),
  ('shelf', 8, 'edge_free', 0.4072, 0.1373),
  ('shelf', 8, 'edge_free_top', 0.4252, 0.1127),
  ('shelf', 8, 'edge_joined', 0.2877, 0.1436),
  ('shelf', 8, 'height', 0.9639, 0.4822),
  ('shelf', 8, 'length', -0.6376, 0.2769),
  ('shelf', 8, 'rectangularity', 0.6324, 0.1141),
  ('shelf', 8, 'spread_length', -0.752, 0.2798),
  ('shelf', 8, 'spread_width', -1.656, 0.2871),
  ('shelf', 8, 'tilt_deg', 3.587, 4.163),
  ('shelf', 8, 'width', -1.382, 0.2968),
  ('shelf', 8, 'z_max', 0.9759, 0.4816),
  ('shelf', 8, 'z_min', 0.9529, 0.4832);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.06253, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'area_m2', -1.354, 0.3384),
  ('shelf', 9, 'aspect', 0.9089, 0.2879),
  ('shelf', 9, 'behind', 0.7588, 0.1011),
  ('shelf', 9, 'edge_free', 0.3558, 0.08859),
  ('shelf', 9, 'edge_free_top', 0.4252, 0.1127),
  ('shelf', 9, 'edge_joined', 0.5172, 0.1571),
  ('shelf', 9, 'height', 0.8871, 0.1148),
  ('shelf', 9, 'length', -0.03195, 0.2242),
  ('shelf', 9, 'rectangularity', 0.6954, 0.1213),
  ('shelf', 9, 'spread_length', -0.2141, 0.2586),
  ('shelf', 9, 'spread_width', -1.103, 0.2927),
  ('shelf', 9, 'tilt_deg', 2.936, 3.811),
  ('shelf', 9, 'width', -0.9408, 0.1908),
  ('shelf', 9, 'z_max', 0.9007, 0.1194),
  ('shelf', 9, 'z_min', 0.8758, 0.1174);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.02584, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'area_m2', -2.804, 0.5061),
  ('shelf', 10, 'aspect', 0.7261, 0.383),
  ('shelf', 10, 'behind', 0.5052, 0.2925),
  ('shelf', 10, 'edge_free', 0.2383, 0.1519),
  ('shelf', 10, 'edge_free_top', 0.229, 0.1663),
  ('shelf', 10, 'edge_joined', 0.2793, 0.2786),
  ('shelf', 10, 'height', 0.2949, 0.1449),
  ('shelf', 10, 'length', -0.8451, 0.3675),
  ('shelf', 10, 'rectangularity', 0.6838, 0.07546),
  ('shelf', 10, 'spread_length', -1.035, 0.3258),
  ('shelf', 10, 'spread_width', -1.763, 0.2296),
  ('shelf', 10, 'tilt_deg', 57.86, 38.11),
  ('shelf', 10, 'width', -1.571, 0.2219),
  ('shelf', 10, 'z_max', 0.4139, 0.161),
  ('shelf', 10, 'z_min', 0.1626, 0.1894);

-- cabinet: 1008 examples
UPDATE object_class SET prior = 0.07557 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.8826, 0.9695)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6559, 0.4307)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.4886, 0.244)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.3729, 0.2725)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.744, 0.3226)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_joined', 0.2713, 0.3072)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7834, 0.3699)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.05551, 0.4959)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7314, 0.1312)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1137, 0.5005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.8071, 0.5233)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 75, 33.09)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.6042, 0.4944)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.235, 0.5955)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2514, 0.3598)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'cabinet';
DELETE FROM class_density WHERE class = 'cabinet';
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.1406, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'area_m2', -0.6813, 0.5882),
  ('cabinet', 1, 'aspect', 0.8582, 0.533),
  ('cabinet', 1, 'behind', 0.2917, 0.2324),
  ('cabinet', 1, 'edge_free', 0.5283, 0.3114),
  ('cabinet', 1, 'edge_free_top', 0.9524, 0.07835),
  ('cabinet', 1, 'edge_joined', 0.06718, 0.1037),
  ('cabinet', 1, 'height', 1.173, 0.2928),
  ('cabinet', 1, 'length', 0.2584, 0.3227),
  ('cabinet', 1, 'rectangularity', 0.7292, 0.1488),
  ('cabinet', 1, 'spread_length', 0.0473, 0.3578),
  ('cabinet', 1, 'spread_width', -0.8194, 0.4635),
  ('cabinet', 1, 'tilt_deg', 89.68, 1.814),
  ('cabinet', 1, 'width', -0.5998, 0.4443),
  ('cabinet', 1, 'z_max', 1.758, 0.4316),
  ('cabinet', 1, 'z_min', 0.4495, 0.3476);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.1185, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'area_m2', -1.137, 0.2238),
  ('cabinet', 2, 'aspect', 0.2548, 0.189),
  ('cabinet', 2, 'behind', 0.5976, 0.1601),
  ('cabinet', 2, 'edge_free', 0.3764, 0.2194),
  ('cabinet', 2, 'edge_free_top', 0.6216, 0.3283),
  ('cabinet', 2, 'edge_joined', 0.2283, 0.2645),
  ('cabinet', 2, 'height', 0.3535, 0.07358),
  ('cabinet', 2, 'length', -0.2333, 0.1517),
  ('cabinet', 2, 'rectangularity', 0.6683, 0.102),
  ('cabinet', 2, 'spread_length', -0.4218, 0.1333),
  ('cabinet', 2, 'spread_width', -0.785, 0.1589),
  ('cabinet', 2, 'tilt_deg', 89.64, 1.894),
  ('cabinet', 2, 'width', -0.4881, 0.1427),
  ('cabinet', 2, 'z_max', 0.7144, 0.1143),
  ('cabinet', 2, 'z_min', -0.01077, 0.0246);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.1132, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'area_m2', -2.24, 0.619),
  ('cabinet', 3, 'aspect', 0.7845, 0.481),
  ('cabinet', 3, 'behind', 0.5396, 0.2223),
  ('cabinet', 3, 'edge_free', 0.2067, 0.1839),
  ('cabinet', 3, 'edge_free_top', 0.3682, 0.3377),
  ('cabinet', 3, 'edge_joined', 0.1911, 0.2076),
  ('cabinet', 3, 'height', 0.3335, 0.1681),
  ('cabinet', 3, 'length', -0.498, 0.4234),
  ('cabinet', 3, 'rectangularity', 0.6447, 0.1214),
  ('cabinet', 3, 'spread_length', -0.6756, 0.4053),
  ('cabinet', 3, 'spread_width', -1.553, 0.3168),
  ('cabinet', 3, 'tilt_deg', 89.1, 2.195),
  ('cabinet', 3, 'width', -1.283, 0.3495),
  ('cabinet', 3, 'z_max', 0.5668, 0.2262),
  ('cabinet', 3, 'z_min', 0.08359, 0.1454);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.1066, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'area_m2', -0.02605, 0.2155),
  ('cabinet', 4, 'aspect', 1.111, 0.2263),
  ('cabinet', 4, 'behind', 0.4934, 0.2188),
  ('cabinet', 4, 'edge_free', 0.2894, 0.2536),
  ('cabinet', 4, 'edge_free_top', 0.7797, 0.2265),
  ('cabinet', 4, 'edge_joined', 0.4309, 0.3261),
  ('cabinet', 4, 'height', 1.037, 0.1119),
  ('cabinet', 4, 'length', 0.6548, 0.1042),
  ('cabinet', 4, 'rectangularity', 0.8046, 0.09305),
  ('cabinet', 4, 'spread_length', 0.5176, 0.1179),
  ('cabinet', 4, 'spread_width', -0.6289, 0.1928),
  ('cabinet', 4, 'tilt_deg', 89.82, 1.958),
  ('cabinet', 4, 'width', -0.456, 0.1954),
  ('cabinet', 4, 'z_max', 1.947, 0.199),
  ('cabinet', 4, 'z_min', 0.01854, 0.06284);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.09812, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'area_m2', -0.325, 0.3337),
  ('cabinet', 5, 'aspect', 0.3521, 0.2265),
  ('cabinet', 5, 'behind', 0.4765, 0.1441),
  ('cabinet', 5, 'edge_free', 0.5415, 0.1861),
  ('cabinet', 5, 'edge_free_top', 0.956, 0.06776),
  ('cabinet', 5, 'edge_joined', 0.1005, 0.1513),
  ('cabinet', 5, 'height', 0.5814, 0.1257),
  ('cabinet', 5, 'length', 0.1372, 0.1542),
  ('cabinet', 5, 'rectangularity', 0.7908, 0.1151),
  ('cabinet', 5, 'spread_length', 0.0202, 0.1506),
  ('cabinet', 5, 'spread_width', -0.3934, 0.2555),
  ('cabinet', 5, 'tilt_deg', 89.66, 2.165),
  ('cabinet', 5, 'width', -0.215, 0.207),
  ('cabinet', 5, 'z_max', 1.028, 0.1646),
  ('cabinet', 5, 'z_min', -0.003886, 0.03134);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.09715, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'area_m2', 0.4975, 0.3126),
  ('cabinet', 6, 'aspect', 0.6029, 0.2335),
  ('cabinet', 6, 'behind', 0.2999, 0.1639),
  ('cabinet', 6, 'edge_free', 0.5706, 0.1896),
  ('cabinet', 6, 'edge_free_top', 0.9636, 0.05621),
  ('cabinet', 6, 'edge_joined', 0.03733, 0.05291),
  ('cabinet', 6, 'height', 1.049, 0.1571),
  ('cabinet', 6, 'length', 0.6433, 0.1074),
  ('cabinet', 6, 'rectangularity', 0.8365, 0.09575),
  ('cabinet', 6, 'spread_length', 0.4958, 0.1807),
  ('cabinet', 6, 'spread_width', -0.1225, 0.2653),
  ('cabinet', 6, 'tilt_deg', 89.83, 2.035),
  ('cabinet', 6, 'width', 0.04041, 0.2429),
  ('cabinet', 6, 'z_max', 1.875, 0.2494),
  ('cabinet', 6, 'z_min', -0.001621, 0.03664);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.09366, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'area_m2', -0.6889, 0.4487),
  ('cabinet', 7, 'aspect', 0.6702, 0.3448),
  ('cabinet', 7, 'behind', 0.5245, 0.2647),
  ('cabinet', 7, 'edge_free', 0.1735, 0.1358),
  ('cabinet', 7, 'edge_free_top', 0.5584, 0.3011),
  ('cabinet', 7, 'edge_joined', 0.5605, 0.2824),
  ('cabinet', 7, 'height', 0.9805, 0.4117),
  ('cabinet', 7, 'length', 0.1494, 0.2788),
  ('cabinet', 7, 'rectangularity', 0.7381, 0.1145),
  ('cabinet', 7, 'spread_length', -0.04817, 0.256),
  ('cabinet', 7, 'spread_width', -0.6717, 0.2905),
  ('cabinet', 7, 'tilt_deg', 89.53, 2.3),
  ('cabinet', 7, 'width', -0.5208, 0.271),
  ('cabinet', 7, 'z_max', 1.514, 0.4666),
  ('cabinet', 7, 'z_min', 0.3684, 0.4515);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.08412, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'area_m2', -0.9135, 0.4002),
  ('cabinet', 8, 'aspect', 0.6041, 0.3079),
  ('cabinet', 8, 'behind', 0.6669, 0.1595),
  ('cabinet', 8, 'edge_free', 0.1691, 0.1241),
  ('cabinet', 8, 'edge_free_top', 0.744, 0.102),
  ('cabinet', 8, 'edge_joined', 0.761, 0.157),
  ('cabinet', 8, 'height', 0.9097, 0.1394),
  ('cabinet', 8, 'length', 0.02991, 0.2984),
  ('cabinet', 8, 'rectangularity', 0.697, 0.08608),
  ('cabinet', 8, 'spread_length', -0.1505, 0.2804),
  ('cabinet', 8, 'spread_width', -0.667, 0.2074),
  ('cabinet', 8, 'tilt_deg', 1.271, 2.366),
  ('cabinet', 8, 'width', -0.5742, 0.1508),
  ('cabinet', 8, 'z_max', 0.9175, 0.1434),
  ('cabinet', 8, 'z_min', 0.9015, 0.1392);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.06333, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'area_m2', -2.225, 0.5469),
  ('cabinet', 9, 'aspect', 0.5549, 0.3472),
  ('cabinet', 9, 'behind', 0.6902, 0.1437),
  ('cabinet', 9, 'edge_free', 0.3381, 0.1995),
  ('cabinet', 9, 'edge_free_top', 0.744, 0.102),
  ('cabinet', 9, 'edge_joined', 0.2578, 0.1747),
  ('cabinet', 9, 'height', 0.5834, 0.02974),
  ('cabinet', 9, 'length', -0.6732, 0.2388),
  ('cabinet', 9, 'rectangularity', 0.7346, 0.1183),
  ('cabinet', 9, 'spread_length', -0.8008, 0.2534),
  ('cabinet', 9, 'spread_width', -1.416, 0.3977),
  ('cabinet', 9, 'tilt_deg', 1.856, 2.814),
  ('cabinet', 9, 'width', -1.228, 0.407),
  ('cabinet', 9, 'z_max', 0.5926, 0.04709),
  ('cabinet', 9, 'z_min', 0.573, 0.02944);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.03479, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'area_m2', -2.423, 0.5322),
  ('cabinet', 10, 'aspect', 0.6992, 0.2877),
  ('cabinet', 10, 'behind', 0.4037, 0.2796),
  ('cabinet', 10, 'edge_free', 0.6081, 0.3002),
  ('cabinet', 10, 'edge_free_top', 0.8816, 0.1929),
  ('cabinet', 10, 'edge_joined', 0.2032, 0.2077),
  ('cabinet', 10, 'height', 0.767, 0.193),
  ('cabinet', 10, 'length', -0.5925, 0.2627),
  ('cabinet', 10, 'rectangularity', 0.5953, 0.1045),
  ('cabinet', 10, 'spread_length', -0.7728, 0.2407),
  ('cabinet', 10, 'spread_width', -1.56, 0.2562),
  ('cabinet', 10, 'tilt_deg', 64.07, 37.64),
  ('cabinet', 10, 'width', -1.292, 0.2892),
  ('cabinet', 10, 'z_max', 0.8989, 0.2164),
  ('cabinet', 10, 'z_min', 0.584, 0.2543);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.0865 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.356 WHERE name = 'aspect';
UPDATE feature SET weight = 0.38 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.219 WHERE name = 'edge_joined';
UPDATE feature SET weight = 0.156 WHERE name = 'height';
UPDATE feature SET weight = 0.0157 WHERE name = 'length';
UPDATE feature SET weight = 0.5 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.365 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.231 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.319 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.246 WHERE name = 'width';
UPDATE feature SET weight = 0.481 WHERE name = 'z_max';
UPDATE feature SET weight = 0.44 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.278 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0551 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0332 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.129 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0193 WHERE name = 'table';
UPDATE object_class SET prior = 0.0318 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.163 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.00695 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0542 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.017 WHERE name = 'door';
UPDATE object_class SET prior = 0.0158 WHERE name = 'window';
UPDATE object_class SET prior = 0.0103 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0762 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.11 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.96 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.377 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 1.73 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.79 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 3.52 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 0.143 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 0.899 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.223 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.765 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 2.23 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.79 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.08 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.497 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.86 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.705 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 2.85 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 4.48 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.43 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.306 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.532 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.01 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 1.29 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.621 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.11 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.06 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 2.26 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 0.902 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.6 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.448 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.28 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.6 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.57 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.06 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2346 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.824' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.235' WHERE key = 'probability_offset';
