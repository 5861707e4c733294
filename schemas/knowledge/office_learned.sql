-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise.
-- Densities and Gaussians: 3347 planes of 42 paper-like rooms, seeds from 1, and 42 depth-camera frames, seeds from 101.
-- Priors and weights: 24 such rooms, seeds from 11, and 21 frames, seeds from 201.

-- unknown: 1479 examples
UPDATE object_class SET prior = 0.5197 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -2.008, 1.276)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6174, 0.496)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 0.9333, 0.6449)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.4959, 0.7355)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.6946, 0.1516)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.6601, 0.7515)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.343, 0.6411)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 62.56, 37.94)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.117, 0.6456)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.19, 0.8751)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.6695, 0.6921)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0154034, 0.003034),
  ('unknown', 'area_m2', 0.0154034, 0.0320723, 0.1434),
  ('unknown', 'area_m2', 0.0320723, 0.0351442, 0.1806),
  ('unknown', 'area_m2', 0.0351442, 0.0534815, 0.2298),
  ('unknown', 'area_m2', 0.0534815, 0.0752825, 0.3181),
  ('unknown', 'area_m2', 0.0752825, 0.0801846, 0.4673),
  ('unknown', 'area_m2', 0.0801846, 0.097749, 0.4051),
  ('unknown', 'area_m2', 0.097749, 0.128831, 0.4008),
  ('unknown', 'area_m2', 0.128831, 0.182948, 0.2277),
  ('unknown', 'area_m2', 0.182948, 0.202934, 0.3257),
  ('unknown', 'area_m2', 0.202934, 0.297805, 0.2839),
  ('unknown', 'area_m2', 0.297805, 0.417413, 0.2191),
  ('unknown', 'area_m2', 0.417413, 0.514603, 0.1819),
  ('unknown', 'area_m2', 0.514603, 0.952366, 0.1074),
  ('unknown', 'area_m2', 0.952366, 2.17291, 0.022),
  ('unknown', 'area_m2', 2.17291, 4.95769, 0.00697),
  ('unknown', 'area_m2', 4.95769, 11.3114, 0.003571),
  ('unknown', 'area_m2', 11.3114, 25.808, 0.01152),
  ('unknown', 'area_m2', 25.808, 100, 0.006975);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.11036, 1.061),
  ('unknown', 'aspect', 1.11036, 1.24062, 0.9984),
  ('unknown', 'aspect', 1.24062, 1.25181, 1.058),
  ('unknown', 'aspect', 1.25181, 1.37238, 1.108),
  ('unknown', 'aspect', 1.37238, 1.53935, 0.9598),
  ('unknown', 'aspect', 1.53935, 1.56704, 0.7844),
  ('unknown', 'aspect', 1.56704, 1.74936, 0.8823),
  ('unknown', 'aspect', 1.74936, 1.96164, 0.8376),
  ('unknown', 'aspect', 1.96164, 1.99565, 0.8697),
  ('unknown', 'aspect', 1.99565, 2.44883, 0.5375),
  ('unknown', 'aspect', 2.44883, 3.07396, 0.3286),
  ('unknown', 'aspect', 3.07396, 3.84802, 0.1695),
  ('unknown', 'aspect', 3.84802, 3.91073, 0.1206),
  ('unknown', 'aspect', 3.91073, 4.817, 0.1419),
  ('unknown', 'aspect', 4.817, 6.02998, 0.1892),
  ('unknown', 'aspect', 6.02998, 7.54841, 0.1176),
  ('unknown', 'aspect', 7.54841, 100, 0.00444);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, -0.00876863, 0.01241),
  ('unknown', 'height', -0.00876863, 0.223958, 0.4504),
  ('unknown', 'height', 0.223958, 0.305921, 0.6176),
  ('unknown', 'height', 0.305921, 0.407979, 0.5804),
  ('unknown', 'height', 0.407979, 0.567937, 0.697),
  ('unknown', 'height', 0.567937, 0.62061, 0.3797),
  ('unknown', 'height', 0.62061, 0.752764, 0.6907),
  ('unknown', 'height', 0.752764, 0.850661, 1.133),
  ('unknown', 'height', 0.850661, 0.935299, 0.8246),
  ('unknown', 'height', 0.935299, 1.01606, 0.5275),
  ('unknown', 'height', 1.01606, 1.24999, 0.336),
  ('unknown', 'height', 1.24999, 1.3665, 0.2678),
  ('unknown', 'height', 1.3665, 1.56468, 0.3078),
  ('unknown', 'height', 1.56468, 1.85241, 0.1745),
  ('unknown', 'height', 1.85241, 1.87937, 0.1177),
  ('unknown', 'height', 1.87937, 2.19406, 0.1375),
  ('unknown', 'height', 2.19406, 2.50875, 0.1224),
  ('unknown', 'height', 2.50875, 2.82343, 0.05911),
  ('unknown', 'height', 2.82343, 4, 0.007325);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.153774, 0.004243),
  ('unknown', 'length', 0.153774, 0.237512, 0.2213),
  ('unknown', 'length', 0.237512, 0.24109, 0.4343),
  ('unknown', 'length', 0.24109, 0.335222, 0.3382),
  ('unknown', 'length', 0.335222, 0.36685, 0.5041),
  ('unknown', 'length', 0.36685, 0.433479, 0.3973),
  ('unknown', 'length', 0.433479, 0.531149, 0.5563),
  ('unknown', 'length', 0.531149, 0.56662, 0.5707),
  ('unknown', 'length', 0.56662, 0.651815, 0.5218),
  ('unknown', 'length', 0.651815, 0.826396, 0.4729),
  ('unknown', 'length', 0.826396, 0.875175, 0.5161),
  ('unknown', 'length', 0.875175, 1.04609, 0.4572),
  ('unknown', 'length', 1.04609, 1.35176, 0.3805),
  ('unknown', 'length', 1.35176, 1.38579, 0.4481),
  ('unknown', 'length', 1.38579, 2.08786, 0.1848),
  ('unknown', 'length', 2.08786, 3.22481, 0.02024),
  ('unknown', 'length', 3.22481, 4.9809, 0.01736),
  ('unknown', 'length', 4.9809, 7.69326, 0.02379),
  ('unknown', 'length', 7.69326, 30, 0.007042);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.314859, 0.0296),
  ('unknown', 'rectangularity', 0.314859, 0.387873, 0.2788),
  ('unknown', 'rectangularity', 0.387873, 0.460886, 0.6849),
  ('unknown', 'rectangularity', 0.460886, 0.487298, 1.164),
  ('unknown', 'rectangularity', 0.487298, 0.533899, 1.273),
  ('unknown', 'rectangularity', 0.533899, 0.571568, 1.394),
  ('unknown', 'rectangularity', 0.571568, 0.606913, 1.857),
  ('unknown', 'rectangularity', 0.606913, 0.634905, 1.676),
  ('unknown', 'rectangularity', 0.634905, 0.679926, 2.213),
  ('unknown', 'rectangularity', 0.679926, 0.684344, 2.373),
  ('unknown', 'rectangularity', 0.684344, 0.733376, 2.24),
  ('unknown', 'rectangularity', 0.733376, 0.75294, 2.237),
  ('unknown', 'rectangularity', 0.75294, 0.783199, 2.278),
  ('unknown', 'rectangularity', 0.783199, 0.822631, 2.775),
  ('unknown', 'rectangularity', 0.822631, 0.825953, 2.185),
  ('unknown', 'rectangularity', 0.825953, 0.876318, 2.028),
  ('unknown', 'rectangularity', 0.876318, 0.898966, 1.614),
  ('unknown', 'rectangularity', 0.898966, 0.97198, 0.981),
  ('unknown', 'rectangularity', 0.97198, 1, 0.1969);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.144194, 0.002338),
  ('unknown', 'spread_length', 0.144194, 0.216564, 0.2588),
  ('unknown', 'spread_length', 0.216564, 0.221856, 0.3203),
  ('unknown', 'spread_length', 0.221856, 0.283516, 0.4221),
  ('unknown', 'spread_length', 0.283516, 0.338459, 0.6361),
  ('unknown', 'spread_length', 0.338459, 0.409815, 0.5656),
  ('unknown', 'spread_length', 0.409815, 0.525194, 0.4499),
  ('unknown', 'spread_length', 0.525194, 0.705857, 0.3697),
  ('unknown', 'spread_length', 0.705857, 0.808059, 0.4642),
  ('unknown', 'spread_length', 0.808059, 0.918712, 0.4035),
  ('unknown', 'spread_length', 0.918712, 1.24327, 0.3531),
  ('unknown', 'spread_length', 1.24327, 1.26224, 0.2649),
  ('unknown', 'spread_length', 1.26224, 1.91289, 0.1765),
  ('unknown', 'spread_length', 1.91289, 2.94316, 0.02084),
  ('unknown', 'spread_length', 2.94316, 4.52833, 0.01356),
  ('unknown', 'spread_length', 4.52833, 6.96725, 0.02669),
  ('unknown', 'spread_length', 6.96725, 40, 0.005935);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.107752, 0.0004213),
  ('unknown', 'spread_width', 0.107752, 0.110191, 0.168),
  ('unknown', 'spread_width', 0.110191, 0.135886, 0.5098),
  ('unknown', 'spread_width', 0.135886, 0.164404, 0.5819),
  ('unknown', 'spread_width', 0.164404, 0.192759, 0.6986),
  ('unknown', 'spread_width', 0.192759, 0.215512, 0.9906),
  ('unknown', 'spread_width', 0.215512, 0.242816, 0.9285),
  ('unknown', 'spread_width', 0.242816, 0.250841, 0.6298),
  ('unknown', 'spread_width', 0.250841, 0.287353, 0.6518),
  ('unknown', 'spread_width', 0.287353, 0.375807, 0.419),
  ('unknown', 'spread_width', 0.375807, 0.382723, 0.4061),
  ('unknown', 'spread_width', 0.382723, 0.563186, 0.2673),
  ('unknown', 'spread_width', 0.563186, 0.583944, 0.2003),
  ('unknown', 'spread_width', 0.583944, 0.890959, 0.1714),
  ('unknown', 'spread_width', 0.890959, 1.35939, 0.02396),
  ('unknown', 'spread_width', 1.35939, 2.07411, 0.007159),
  ('unknown', 'spread_width', 2.07411, 3.16459, 0.008639),
  ('unknown', 'spread_width', 3.16459, 4.82841, 0.01691),
  ('unknown', 'spread_width', 4.82841, 20, 0.006222);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 0.946936, 0.112),
  ('unknown', 'tilt_deg', 0.946936, 5.5156, 0.02518),
  ('unknown', 'tilt_deg', 5.5156, 10, 0.005751),
  ('unknown', 'tilt_deg', 10, 20, 0.002653),
  ('unknown', 'tilt_deg', 20, 30, 0.001201),
  ('unknown', 'tilt_deg', 30, 40, 0.00093),
  ('unknown', 'tilt_deg', 40, 50, 0.0008924),
  ('unknown', 'tilt_deg', 50, 60, 0.0007826),
  ('unknown', 'tilt_deg', 60, 70, 0.001279),
  ('unknown', 'tilt_deg', 70, 73.0273, 0.004039),
  ('unknown', 'tilt_deg', 73.0273, 80, 0.005639),
  ('unknown', 'tilt_deg', 80, 86.5582, 0.01061),
  ('unknown', 'tilt_deg', 86.5582, 88.864, 0.04955),
  ('unknown', 'tilt_deg', 88.864, 89.5436, 0.1908),
  ('unknown', 'tilt_deg', 89.5436, 89.8195, 0.5618),
  ('unknown', 'tilt_deg', 89.8195, 90, 0.8625);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.11536, 0.003357),
  ('unknown', 'width', 0.11536, 0.159876, 0.3201),
  ('unknown', 'width', 0.159876, 0.17617, 0.4131),
  ('unknown', 'width', 0.17617, 0.201993, 0.4915),
  ('unknown', 'width', 0.201993, 0.237521, 0.6946),
  ('unknown', 'width', 0.237521, 0.269033, 0.8046),
  ('unknown', 'width', 0.269033, 0.273421, 0.6644),
  ('unknown', 'width', 0.273421, 0.32426, 0.6295),
  ('unknown', 'width', 0.32426, 0.38183, 0.7071),
  ('unknown', 'width', 0.38183, 0.410846, 0.4745),
  ('unknown', 'width', 0.410846, 0.484138, 0.4737),
  ('unknown', 'width', 0.484138, 0.627413, 0.2915),
  ('unknown', 'width', 0.627413, 0.705391, 0.2825),
  ('unknown', 'width', 0.705391, 0.958138, 0.233),
  ('unknown', 'width', 0.958138, 1.46319, 0.03552),
  ('unknown', 'width', 1.46319, 2.23448, 0.01623),
  ('unknown', 'width', 2.23448, 3.41233, 0.008239),
  ('unknown', 'width', 3.41233, 5.21104, 0.01748),
  ('unknown', 'width', 5.21104, 12, 0.009888);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0152617, 0.0137),
  ('unknown', 'z_max', 0.0152617, 0.408454, 0.2632),
  ('unknown', 'z_max', 0.408454, 0.45801, 0.8221),
  ('unknown', 'z_max', 0.45801, 0.651419, 0.3551),
  ('unknown', 'z_max', 0.651419, 0.754921, 1.093),
  ('unknown', 'z_max', 0.754921, 0.842435, 1.289),
  ('unknown', 'z_max', 0.842435, 0.900759, 0.8061),
  ('unknown', 'z_max', 0.900759, 1.00166, 0.5952),
  ('unknown', 'z_max', 1.00166, 1.24827, 0.4504),
  ('unknown', 'z_max', 1.24827, 1.34351, 0.3264),
  ('unknown', 'z_max', 1.34351, 1.69887, 0.224),
  ('unknown', 'z_max', 1.69887, 1.78626, 0.2642),
  ('unknown', 'z_max', 1.78626, 2.18162, 0.228),
  ('unknown', 'z_max', 2.18162, 2.22901, 0.4189),
  ('unknown', 'z_max', 2.22901, 2.67175, 0.1303),
  ('unknown', 'z_max', 2.67175, 3.1145, 0.02738),
  ('unknown', 'z_max', 3.1145, 3.55725, 0.003863),
  ('unknown', 'z_max', 3.55725, 4, 0.04675);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.144508, 0.05851),
  ('unknown', 'z_min', -0.144508, -0.0141459, 0.751),
  ('unknown', 'z_min', -0.0141459, 0.0230506, 2.765),
  ('unknown', 'z_min', 0.0230506, 0.210984, 0.5339),
  ('unknown', 'z_min', 0.210984, 0.252, 0.3068),
  ('unknown', 'z_min', 0.252, 0.557492, 0.349),
  ('unknown', 'z_min', 0.557492, 0.566477, 0.2033),
  ('unknown', 'z_min', 0.566477, 0.726464, 0.6998),
  ('unknown', 'z_min', 0.726464, 0.789564, 1.75),
  ('unknown', 'z_min', 0.789564, 0.921969, 0.6593),
  ('unknown', 'z_min', 0.921969, 0.972417, 0.4598),
  ('unknown', 'z_min', 0.972417, 1.27746, 0.2188),
  ('unknown', 'z_min', 1.27746, 1.50737, 0.1939),
  ('unknown', 'z_min', 1.50737, 1.63295, 0.1133),
  ('unknown', 'z_min', 1.63295, 1.98845, 0.07548),
  ('unknown', 'z_min', 1.98845, 2.34394, 0.1049),
  ('unknown', 'z_min', 2.34394, 2.69943, 0.07075),
  ('unknown', 'z_min', 2.69943, 4, 0.007197);

-- floor: 87 examples
UPDATE object_class SET prior = 0.0306 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.306, 1.384)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4809, 0.3401)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.002031, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.173, 0.6407)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5964, 0.1443)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.9063, 0.5672)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.3397, 0.7156)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.4755, 0.616)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.6886, 0.7993)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.01142, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.006756, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'floor' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'area_m2', 0.002, 0.0932916, 0.001918),
  ('floor', 'area_m2', 0.0932916, 0.107452, 0.01975),
  ('floor', 'area_m2', 0.107452, 0.175511, 0.02982),
  ('floor', 'area_m2', 0.175511, 0.330191, 0.07948),
  ('floor', 'area_m2', 0.330191, 0.435012, 0.1381),
  ('floor', 'area_m2', 0.435012, 0.621194, 0.1362),
  ('floor', 'area_m2', 0.621194, 1.16866, 0.09492),
  ('floor', 'area_m2', 1.16866, 2.19862, 0.1272),
  ('floor', 'area_m2', 2.19862, 2.79498, 0.1823),
  ('floor', 'area_m2', 2.79498, 4.1363, 0.1945),
  ('floor', 'area_m2', 4.1363, 4.86863, 0.2258),
  ('floor', 'area_m2', 4.86863, 7.78168, 0.242),
  ('floor', 'area_m2', 7.78168, 9.13669, 0.6231),
  ('floor', 'area_m2', 9.13669, 10.9, 0.5433),
  ('floor', 'area_m2', 10.9, 13.8951, 0.437),
  ('floor', 'area_m2', 13.8951, 27.36, 0.1649),
  ('floor', 'area_m2', 27.36, 100, 0.01081);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'aspect', 1, 1.0652, 1.622),
  ('floor', 'aspect', 1.0652, 1.17376, 1.151),
  ('floor', 'aspect', 1.17376, 1.31804, 1.091),
  ('floor', 'aspect', 1.31804, 1.37771, 1.115),
  ('floor', 'aspect', 1.37771, 1.47316, 0.7271),
  ('floor', 'aspect', 1.47316, 1.6171, 0.8919),
  ('floor', 'aspect', 1.6171, 1.66314, 0.9539),
  ('floor', 'aspect', 1.66314, 1.88488, 0.9121),
  ('floor', 'aspect', 1.88488, 2.13831, 0.8422),
  ('floor', 'aspect', 2.13831, 2.2279, 1.082),
  ('floor', 'aspect', 2.2279, 2.32969, 1.423),
  ('floor', 'aspect', 2.32969, 2.61501, 0.3335),
  ('floor', 'aspect', 2.61501, 3.06939, 0.2383),
  ('floor', 'aspect', 3.06939, 3.60273, 0.1489),
  ('floor', 'aspect', 3.60273, 4.22874, 0.06395),
  ('floor', 'aspect', 4.22874, 100, 0.003844);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'height', -0.5, -0.0312212, 0.0274),
  ('floor', 'height', -0.0312212, -0.0216817, 3.433),
  ('floor', 'height', -0.0216817, -0.00187681, 19.04),
  ('floor', 'height', -0.00187681, 0.0127954, 27.26),
  ('floor', 'height', 0.0127954, 0.0274676, 8.99),
  ('floor', 'height', 0.0274676, 0.0421397, 1.385),
  ('floor', 'height', 0.0421397, 0.0568119, 0.303),
  ('floor', 'height', 0.0568119, 0.0714841, 0.2793),
  ('floor', 'height', 0.0714841, 0.0861563, 0.4489),
  ('floor', 'height', 0.0861563, 0.0960987, 0.4569),
  ('floor', 'height', 0.0960987, 4, 0.00138);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'length', 0.03, 0.484606, 0.002718),
  ('floor', 'length', 0.484606, 0.677773, 0.05779),
  ('floor', 'length', 0.677773, 0.947938, 0.07688),
  ('floor', 'length', 0.947938, 1.30865, 0.1764),
  ('floor', 'length', 1.30865, 1.85427, 0.2427),
  ('floor', 'length', 1.85427, 2.09301, 0.2894),
  ('floor', 'length', 2.09301, 2.59339, 0.3897),
  ('floor', 'length', 2.59339, 2.76805, 0.3463),
  ('floor', 'length', 2.76805, 3.60055, 0.4326),
  ('floor', 'length', 3.60055, 4.12831, 0.862),
  ('floor', 'length', 4.12831, 4.42161, 1.509),
  ('floor', 'length', 4.42161, 5.07294, 0.6884),
  ('floor', 'length', 5.07294, 6.37678, 0.5087),
  ('floor', 'length', 6.37678, 7.09505, 0.3789),
  ('floor', 'length', 7.09505, 8.43794, 0.3077),
  ('floor', 'length', 8.43794, 9.92319, 0.1126),
  ('floor', 'length', 9.92319, 30, 0.00582);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'rectangularity', 0, 0.250439, 0.03981),
  ('floor', 'rectangularity', 0.250439, 0.320569, 0.3676),
  ('floor', 'rectangularity', 0.320569, 0.3907, 0.8797),
  ('floor', 'rectangularity', 0.3907, 0.401853, 1.208),
  ('floor', 'rectangularity', 0.401853, 0.46083, 1.053),
  ('floor', 'rectangularity', 0.46083, 0.49351, 1.386),
  ('floor', 'rectangularity', 0.49351, 0.53096, 2.897),
  ('floor', 'rectangularity', 0.53096, 0.579303, 2.827),
  ('floor', 'rectangularity', 0.579303, 0.60109, 2.709),
  ('floor', 'rectangularity', 0.60109, 0.617959, 2.372),
  ('floor', 'rectangularity', 0.617959, 0.67122, 1.729),
  ('floor', 'rectangularity', 0.67122, 0.680901, 2.121),
  ('floor', 'rectangularity', 0.680901, 0.718641, 2.542),
  ('floor', 'rectangularity', 0.718641, 0.741351, 1.543),
  ('floor', 'rectangularity', 0.741351, 0.779337, 2.066),
  ('floor', 'rectangularity', 0.779337, 0.811481, 1.841),
  ('floor', 'rectangularity', 0.811481, 0.881611, 0.6543),
  ('floor', 'rectangularity', 0.881611, 1, 0.0873);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_length', 0.01, 0.480579, 0.00317),
  ('floor', 'spread_length', 0.480579, 0.633154, 0.08242),
  ('floor', 'spread_length', 0.633154, 0.834169, 0.1056),
  ('floor', 'spread_length', 0.834169, 1.099, 0.1614),
  ('floor', 'spread_length', 1.099, 1.12834, 0.2473),
  ('floor', 'spread_length', 1.12834, 1.44792, 0.2821),
  ('floor', 'spread_length', 1.44792, 1.74598, 0.2746),
  ('floor', 'spread_length', 1.74598, 1.9076, 0.2755),
  ('floor', 'spread_length', 1.9076, 2.40002, 0.4265),
  ('floor', 'spread_length', 2.40002, 2.51323, 0.795),
  ('floor', 'spread_length', 2.51323, 2.82511, 0.5648),
  ('floor', 'spread_length', 2.82511, 3.11154, 1.085),
  ('floor', 'spread_length', 3.11154, 3.31113, 1.041),
  ('floor', 'spread_length', 3.31113, 3.43, 1.071),
  ('floor', 'spread_length', 3.43, 3.76213, 1.187),
  ('floor', 'spread_length', 3.76213, 4.27786, 0.7846),
  ('floor', 'spread_length', 4.27786, 5.34907, 0.4438),
  ('floor', 'spread_length', 5.34907, 5.74733, 0.1185),
  ('floor', 'spread_length', 5.74733, 40, 0.006495);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_width', 0.003, 0.197587, 0.002259),
  ('floor', 'spread_width', 0.197587, 0.273429, 0.06264),
  ('floor', 'spread_width', 0.273429, 0.378383, 0.1358),
  ('floor', 'spread_width', 0.378383, 0.469761, 0.1874),
  ('floor', 'spread_width', 0.469761, 0.523623, 0.1951),
  ('floor', 'spread_width', 0.523623, 0.724611, 0.1903),
  ('floor', 'spread_width', 0.724611, 0.796875, 0.2092),
  ('floor', 'spread_width', 0.796875, 1.00275, 0.2409),
  ('floor', 'spread_width', 1.00275, 1.28139, 0.3119),
  ('floor', 'spread_width', 1.28139, 1.38764, 0.4147),
  ('floor', 'spread_width', 1.38764, 1.7681, 0.4008),
  ('floor', 'spread_width', 1.7681, 1.92028, 0.6004),
  ('floor', 'spread_width', 1.92028, 2.04437, 0.7323),
  ('floor', 'spread_width', 2.04437, 2.29344, 0.9516),
  ('floor', 'spread_width', 2.29344, 2.4557, 1.355),
  ('floor', 'spread_width', 2.4557, 2.65737, 0.9539),
  ('floor', 'spread_width', 2.65737, 3.38017, 0.5154),
  ('floor', 'spread_width', 3.38017, 3.67738, 0.117),
  ('floor', 'spread_width', 3.67738, 20, 0.008292);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'tilt_deg', 0, 0.212435, 1.7),
  ('floor', 'tilt_deg', 0.212435, 0.510577, 0.8292),
  ('floor', 'tilt_deg', 0.510577, 0.765866, 0.3717),
  ('floor', 'tilt_deg', 0.765866, 1.02115, 0.299),
  ('floor', 'tilt_deg', 1.02115, 1.27644, 0.2572),
  ('floor', 'tilt_deg', 1.27644, 1.49758, 0.2285),
  ('floor', 'tilt_deg', 1.49758, 1.78702, 0.2096),
  ('floor', 'tilt_deg', 1.78702, 1.91765, 0.1547),
  ('floor', 'tilt_deg', 1.91765, 2.04231, 0.1003),
  ('floor', 'tilt_deg', 2.04231, 2.2976, 0.03725),
  ('floor', 'tilt_deg', 2.2976, 90, 1.415e-05);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'width', 0.01, 0.271009, 0.00404),
  ('floor', 'width', 0.271009, 0.384118, 0.09867),
  ('floor', 'width', 0.384118, 0.544434, 0.1741),
  ('floor', 'width', 0.544434, 0.566995, 0.1758),
  ('floor', 'width', 0.566995, 0.77166, 0.1568),
  ('floor', 'width', 0.77166, 1.09372, 0.1609),
  ('floor', 'width', 1.09372, 1.14253, 0.2602),
  ('floor', 'width', 1.14253, 1.5502, 0.2636),
  ('floor', 'width', 1.5502, 1.89674, 0.2852),
  ('floor', 'width', 1.89674, 2.19719, 0.4997),
  ('floor', 'width', 2.19719, 2.33771, 0.3791),
  ('floor', 'width', 2.33771, 3.085, 0.4092),
  ('floor', 'width', 3.085, 3.36248, 1.061),
  ('floor', 'width', 3.36248, 3.78723, 0.8893),
  ('floor', 'width', 3.78723, 4.13216, 1.189),
  ('floor', 'width', 4.13216, 4.41396, 0.4585),
  ('floor', 'width', 4.41396, 6.25617, 0.2104),
  ('floor', 'width', 6.25617, 12, 0.02417);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_max', -0.5, -0.0249564, 0.03257),
  ('floor', 'z_max', -0.0249564, -0.0175799, 4.241),
  ('floor', 'z_max', -0.0175799, -0.00916539, 10.97),
  ('floor', 'z_max', -0.00916539, 5.183e-05, 20.56),
  ('floor', 'z_max', 5.183e-05, 0.00662565, 24.48),
  ('floor', 'z_max', 0.00662565, 0.0194328, 19.36),
  ('floor', 'z_max', 0.0194328, 0.0288786, 11.2),
  ('floor', 'z_max', 0.0288786, 0.0382077, 6.387),
  ('floor', 'z_max', 0.0382077, 0.0539988, 2.648),
  ('floor', 'z_max', 0.0539988, 0.0697898, 1.161),
  ('floor', 'z_max', 0.0697898, 0.0855809, 0.9362),
  ('floor', 'z_max', 0.0855809, 0.101372, 0.8596),
  ('floor', 'z_max', 0.101372, 0.117163, 0.4716),
  ('floor', 'z_max', 0.117163, 4, 0.0003392);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_min', -0.5, -0.0798558, 0.02328),
  ('floor', 'z_min', -0.0798558, -0.0610668, 0.2949),
  ('floor', 'z_min', -0.0610668, -0.0422779, 2.16),
  ('floor', 'z_min', -0.0422779, -0.0272273, 5.726),
  ('floor', 'z_min', -0.0272273, -0.0131403, 13.33),
  ('floor', 'z_min', -0.0131403, -0.00469987, 22.82),
  ('floor', 'z_min', -0.00469987, 0.0140891, 19.94),
  ('floor', 'z_min', 0.0140891, 0.0328781, 4.043),
  ('floor', 'z_min', 0.0328781, 0.0516671, 0.4023),
  ('floor', 'z_min', 0.0516671, 0.0704561, 0.3745),
  ('floor', 'z_min', 0.0704561, 0.0884797, 0.3902),
  ('floor', 'z_min', 0.0884797, 4, 0.001323);

-- ceiling: 46 examples
UPDATE object_class SET prior = 0.01629 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 2.14, 1.106)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.3731, 0.3946)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.728, 0.1965)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.456, 0.3933)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6886, 0.1336)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.337, 0.3767)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.772, 0.7026)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.01219, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 1.071, 0.7571)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.729, 0.1965)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.728, 0.1966)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'area_m2', 0.002, 0.0984579, 0.004424),
  ('ceiling', 'area_m2', 0.0984579, 0.186464, 0.0003535),
  ('ceiling', 'area_m2', 0.186464, 0.353133, 0.02406),
  ('ceiling', 'area_m2', 0.353133, 0.668778, 0.04326),
  ('ceiling', 'area_m2', 0.668778, 1.26656, 0.02711),
  ('ceiling', 'area_m2', 1.26656, 2.39866, 0.02716),
  ('ceiling', 'area_m2', 2.39866, 4.54269, 0.05852),
  ('ceiling', 'area_m2', 4.54269, 5.82006, 0.158),
  ('ceiling', 'area_m2', 5.82006, 7.60216, 0.3979),
  ('ceiling', 'area_m2', 7.60216, 8.60314, 0.5743),
  ('ceiling', 'area_m2', 8.60314, 10.5208, 0.6369),
  ('ceiling', 'area_m2', 10.5208, 11.7013, 0.7202),
  ('ceiling', 'area_m2', 11.7013, 12.5513, 1.363),
  ('ceiling', 'area_m2', 12.5513, 14.9457, 0.6462),
  ('ceiling', 'area_m2', 14.9457, 16.293, 0.4094),
  ('ceiling', 'area_m2', 16.293, 19.9572, 0.3668),
  ('ceiling', 'area_m2', 19.9572, 28.1545, 0.25),
  ('ceiling', 'area_m2', 28.1545, 30.8564, 0.1111),
  ('ceiling', 'area_m2', 30.8564, 100, 0.0272);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'aspect', 1, 1.04104, 2.575),
  ('ceiling', 'aspect', 1.04104, 1.11402, 1.581),
  ('ceiling', 'aspect', 1.11402, 1.16781, 1.892),
  ('ceiling', 'aspect', 1.16781, 1.23576, 1.709),
  ('ceiling', 'aspect', 1.23576, 1.28783, 0.8502),
  ('ceiling', 'aspect', 1.28783, 1.36421, 1.454),
  ('ceiling', 'aspect', 1.36421, 1.45736, 1.634),
  ('ceiling', 'aspect', 1.45736, 1.52709, 1.398),
  ('ceiling', 'aspect', 1.52709, 1.57017, 1.156),
  ('ceiling', 'aspect', 1.57017, 1.88712, 0.6011),
  ('ceiling', 'aspect', 1.88712, 2.07799, 0.3525),
  ('ceiling', 'aspect', 2.07799, 2.33201, 0.2201),
  ('ceiling', 'aspect', 2.33201, 2.8818, 0.1973),
  ('ceiling', 'aspect', 2.8818, 3.5612, 0.1018),
  ('ceiling', 'aspect', 3.5612, 4.40078, 0.07633),
  ('ceiling', 'aspect', 4.40078, 5.43829, 0.05507),
  ('ceiling', 'aspect', 5.43829, 6.7204, 0.005455),
  ('ceiling', 'aspect', 6.7204, 100, 0.006288);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'height', -0.5, 2.39603, 0.003278),
  ('ceiling', 'height', 2.39603, 2.45254, 0.589),
  ('ceiling', 'height', 2.45254, 2.47871, 1.968),
  ('ceiling', 'height', 2.47871, 2.49736, 3.232),
  ('ceiling', 'height', 2.49736, 2.5614, 1.718),
  ('ceiling', 'height', 2.5614, 2.62162, 1.018),
  ('ceiling', 'height', 2.62162, 2.64409, 1.105),
  ('ceiling', 'height', 2.64409, 2.69714, 1.919),
  ('ceiling', 'height', 2.69714, 2.72678, 2.427),
  ('ceiling', 'height', 2.72678, 2.75463, 1.498),
  ('ceiling', 'height', 2.75463, 2.80946, 1.607),
  ('ceiling', 'height', 2.80946, 2.89215, 1.304),
  ('ceiling', 'height', 2.89215, 2.97484, 1.362),
  ('ceiling', 'height', 2.97484, 3.05753, 0.8482),
  ('ceiling', 'height', 3.05753, 3.07962, 0.6868),
  ('ceiling', 'height', 3.07962, 3.14021, 0.4907),
  ('ceiling', 'height', 3.14021, 4, 0.01189);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'length', 0.03, 0.856988, 0.005145),
  ('ceiling', 'length', 0.856988, 1.07675, 0.0001801),
  ('ceiling', 'length', 1.07675, 1.35286, 0.004998),
  ('ceiling', 'length', 1.35286, 1.69978, 0.1568),
  ('ceiling', 'length', 1.69978, 2.13567, 0.09892),
  ('ceiling', 'length', 2.13567, 2.68332, 0.08622),
  ('ceiling', 'length', 2.68332, 3.37142, 0.2236),
  ('ceiling', 'length', 3.37142, 3.59583, 0.4625),
  ('ceiling', 'length', 3.59583, 4.05572, 0.8179),
  ('ceiling', 'length', 4.05572, 4.23596, 1.462),
  ('ceiling', 'length', 4.23596, 4.5861, 1.526),
  ('ceiling', 'length', 4.5861, 4.76331, 2.87),
  ('ceiling', 'length', 4.76331, 5.07652, 1.529),
  ('ceiling', 'length', 5.07652, 5.32221, 1.399),
  ('ceiling', 'length', 5.32221, 5.42085, 1.44),
  ('ceiling', 'length', 5.42085, 6.02341, 1.145),
  ('ceiling', 'length', 6.02341, 6.3577, 1.24),
  ('ceiling', 'length', 6.3577, 6.687, 0.5018),
  ('ceiling', 'length', 6.687, 30, 0.01843);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'rectangularity', 0, 0.455586, 0.02074),
  ('ceiling', 'rectangularity', 0.455586, 0.48805, 0.6625),
  ('ceiling', 'rectangularity', 0.48805, 0.513435, 1.75),
  ('ceiling', 'rectangularity', 0.513435, 0.526266, 3.493),
  ('ceiling', 'rectangularity', 0.526266, 0.565508, 2.679),
  ('ceiling', 'rectangularity', 0.565508, 0.624128, 1.956),
  ('ceiling', 'rectangularity', 0.624128, 0.654775, 3.35),
  ('ceiling', 'rectangularity', 0.654775, 0.686981, 2.482),
  ('ceiling', 'rectangularity', 0.686981, 0.699557, 2.303),
  ('ceiling', 'rectangularity', 0.699557, 0.727419, 3.178),
  ('ceiling', 'rectangularity', 0.727419, 0.74483, 2.62),
  ('ceiling', 'rectangularity', 0.74483, 0.802679, 1.405),
  ('ceiling', 'rectangularity', 0.802679, 0.812744, 1.809),
  ('ceiling', 'rectangularity', 0.812744, 0.860528, 1.541),
  ('ceiling', 'rectangularity', 0.860528, 0.891286, 1.451),
  ('ceiling', 'rectangularity', 0.891286, 0.918376, 1.787),
  ('ceiling', 'rectangularity', 0.918376, 0.955378, 0.9176),
  ('ceiling', 'rectangularity', 0.955378, 0.976225, 0.3778),
  ('ceiling', 'rectangularity', 0.976225, 1, 0.265);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_length', 0.01, 0.835444, 0.003897),
  ('ceiling', 'spread_length', 0.835444, 1.03991, 0.0002684),
  ('ceiling', 'spread_length', 1.03991, 1.29443, 0.03574),
  ('ceiling', 'spread_length', 1.29443, 1.61123, 0.1643),
  ('ceiling', 'spread_length', 1.61123, 2.00557, 0.07773),
  ('ceiling', 'spread_length', 2.00557, 2.49642, 0.08437),
  ('ceiling', 'spread_length', 2.49642, 3.1074, 0.2196),
  ('ceiling', 'spread_length', 3.1074, 3.35209, 0.5257),
  ('ceiling', 'spread_length', 3.35209, 3.48063, 1.708),
  ('ceiling', 'spread_length', 3.48063, 3.86792, 1.237),
  ('ceiling', 'spread_length', 3.86792, 4.03948, 2.175),
  ('ceiling', 'spread_length', 4.03948, 4.30781, 1.518),
  ('ceiling', 'spread_length', 4.30781, 4.45814, 2.3),
  ('ceiling', 'spread_length', 4.45814, 4.71208, 2.101),
  ('ceiling', 'spread_length', 4.71208, 4.81457, 2.232),
  ('ceiling', 'spread_length', 4.81457, 5.00179, 1.44),
  ('ceiling', 'spread_length', 5.00179, 5.78027, 0.5796),
  ('ceiling', 'spread_length', 5.78027, 5.99291, 0.339),
  ('ceiling', 'spread_length', 5.99291, 40, 0.01811);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_width', 0.003, 0.139594, 0.003612),
  ('ceiling', 'spread_width', 0.139594, 0.203411, 0.04719),
  ('ceiling', 'spread_width', 0.203411, 0.296401, 0.01044),
  ('ceiling', 'spread_width', 0.296401, 0.431903, 0.04608),
  ('ceiling', 'spread_width', 0.431903, 0.629351, 0.05985),
  ('ceiling', 'spread_width', 0.629351, 0.917063, 0.0437),
  ('ceiling', 'spread_width', 0.917063, 1.3363, 0.08556),
  ('ceiling', 'spread_width', 1.3363, 1.7487, 0.2007),
  ('ceiling', 'spread_width', 1.7487, 1.94721, 0.5385),
  ('ceiling', 'spread_width', 1.94721, 2.07328, 0.7567),
  ('ceiling', 'spread_width', 2.07328, 2.28619, 0.9842),
  ('ceiling', 'spread_width', 2.28619, 2.43515, 1.265),
  ('ceiling', 'spread_width', 2.43515, 2.74864, 0.9129),
  ('ceiling', 'spread_width', 2.74864, 2.83738, 1.681),
  ('ceiling', 'spread_width', 2.83738, 2.91997, 1.259),
  ('ceiling', 'spread_width', 2.91997, 3.13949, 1.241),
  ('ceiling', 'spread_width', 3.13949, 3.44245, 1.253),
  ('ceiling', 'spread_width', 3.44245, 3.91471, 0.6004),
  ('ceiling', 'spread_width', 3.91471, 4.13452, 0.2803),
  ('ceiling', 'spread_width', 4.13452, 20, 0.02695);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'tilt_deg', 0, 0.140087, 2.969),
  ('ceiling', 'tilt_deg', 0.140087, 0.280174, 2.135),
  ('ceiling', 'tilt_deg', 0.280174, 0.420261, 1.141),
  ('ceiling', 'tilt_deg', 0.420261, 0.560348, 0.4956),
  ('ceiling', 'tilt_deg', 0.560348, 90, 0.0006233);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'width', 0.01, 0.147968, 0.006128),
  ('ceiling', 'width', 0.147968, 0.220328, 0.03863),
  ('ceiling', 'width', 0.220328, 0.328074, 0.007524),
  ('ceiling', 'width', 0.328074, 0.488512, 0.03398),
  ('ceiling', 'width', 0.488512, 0.727408, 0.06824),
  ('ceiling', 'width', 0.727408, 1.08313, 0.03281),
  ('ceiling', 'width', 1.08313, 1.61281, 0.06395),
  ('ceiling', 'width', 1.61281, 2.07969, 0.1883),
  ('ceiling', 'width', 2.07969, 2.40152, 0.3617),
  ('ceiling', 'width', 2.40152, 3.03638, 0.3595),
  ('ceiling', 'width', 3.03638, 3.35463, 0.7732),
  ('ceiling', 'width', 3.35463, 3.55025, 1.592),
  ('ceiling', 'width', 3.55025, 3.85035, 1.469),
  ('ceiling', 'width', 3.85035, 4.00964, 2.178),
  ('ceiling', 'width', 4.00964, 4.32854, 1.145),
  ('ceiling', 'width', 4.32854, 4.55025, 2.008),
  ('ceiling', 'width', 4.55025, 5.32466, 0.5446),
  ('ceiling', 'width', 5.32466, 12, 0.0656);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_max', -0.5, 2.39618, 0.003273),
  ('ceiling', 'z_max', 2.39618, 2.45272, 0.5943),
  ('ceiling', 'z_max', 2.45272, 2.47886, 1.946),
  ('ceiling', 'z_max', 2.47886, 2.49741, 3.171),
  ('ceiling', 'z_max', 2.49741, 2.56155, 1.742),
  ('ceiling', 'z_max', 2.56155, 2.62166, 1.019),
  ('ceiling', 'z_max', 2.62166, 2.64424, 1.103),
  ('ceiling', 'z_max', 2.64424, 2.69732, 1.921),
  ('ceiling', 'z_max', 2.69732, 2.72693, 2.428),
  ('ceiling', 'z_max', 2.72693, 2.75482, 1.497),
  ('ceiling', 'z_max', 2.75482, 2.80962, 1.607),
  ('ceiling', 'z_max', 2.80962, 2.8923, 1.303),
  ('ceiling', 'z_max', 2.8923, 2.97499, 1.363),
  ('ceiling', 'z_max', 2.97499, 3.05768, 0.8474),
  ('ceiling', 'z_max', 3.05768, 3.0798, 0.6861),
  ('ceiling', 'z_max', 3.0798, 3.14037, 0.4903),
  ('ceiling', 'z_max', 3.14037, 4, 0.01189);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_min', -0.5, 2.39586, 0.003283),
  ('ceiling', 'z_min', 2.39586, 2.45226, 0.5816),
  ('ceiling', 'z_min', 2.45226, 2.47855, 1.99),
  ('ceiling', 'z_min', 2.47855, 2.4973, 3.286),
  ('ceiling', 'z_min', 2.4973, 2.56123, 1.694),
  ('ceiling', 'z_min', 2.56123, 2.62156, 1.017),
  ('ceiling', 'z_min', 2.62156, 2.64392, 1.107),
  ('ceiling', 'z_min', 2.64392, 2.69683, 1.918),
  ('ceiling', 'z_min', 2.69683, 2.7266, 2.429),
  ('ceiling', 'z_min', 2.7266, 2.75455, 1.496),
  ('ceiling', 'z_min', 2.75455, 2.80929, 1.607),
  ('ceiling', 'z_min', 2.80929, 2.89197, 1.305),
  ('ceiling', 'z_min', 2.89197, 2.97466, 1.361),
  ('ceiling', 'z_min', 2.97466, 3.05734, 0.8492),
  ('ceiling', 'z_min', 3.05734, 3.07943, 0.6869),
  ('ceiling', 'z_min', 3.07943, 3.14003, 0.4911),
  ('ceiling', 'z_min', 3.14003, 4, 0.0119);

-- wall: 288 examples
UPDATE object_class SET prior = 0.1016 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 0.9968, 1.123)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.5672, 0.4412)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.335, 0.3454)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 0.993, 0.4963)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6799, 0.1469)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.8392, 0.4947)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', 0.1743, 0.7107)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.8, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.4197, 0.7128)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.38, 0.6243)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.1634, 0.3614)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'wall' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'area_m2', 0.002, 0.0798189, 0.002158),
  ('wall', 'area_m2', 0.0798189, 0.142639, 0.01802),
  ('wall', 'area_m2', 0.142639, 0.254899, 0.02322),
  ('wall', 'area_m2', 0.254899, 0.455511, 0.1078),
  ('wall', 'area_m2', 0.455511, 0.618527, 0.0616),
  ('wall', 'area_m2', 0.618527, 0.814011, 0.1004),
  ('wall', 'area_m2', 0.814011, 1.1917, 0.2138),
  ('wall', 'area_m2', 1.1917, 1.45466, 0.2537),
  ('wall', 'area_m2', 1.45466, 1.86901, 0.2196),
  ('wall', 'area_m2', 1.86901, 2.59952, 0.2864),
  ('wall', 'area_m2', 2.59952, 2.8186, 0.3036),
  ('wall', 'area_m2', 2.8186, 4.01488, 0.314),
  ('wall', 'area_m2', 4.01488, 4.64541, 0.2781),
  ('wall', 'area_m2', 4.64541, 5.62028, 0.3826),
  ('wall', 'area_m2', 5.62028, 7.00794, 0.4752),
  ('wall', 'area_m2', 7.00794, 8.30147, 0.4016),
  ('wall', 'area_m2', 8.30147, 8.97169, 0.4812),
  ('wall', 'area_m2', 8.97169, 14.5619, 0.2268),
  ('wall', 'area_m2', 14.5619, 100, 0.004314);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'aspect', 1, 1.12412, 0.9721),
  ('wall', 'aspect', 1.12412, 1.27844, 0.8446),
  ('wall', 'aspect', 1.27844, 1.29391, 1.141),
  ('wall', 'aspect', 1.29391, 1.4058, 1.142),
  ('wall', 'aspect', 1.4058, 1.54884, 1.118),
  ('wall', 'aspect', 1.54884, 1.67422, 1.227),
  ('wall', 'aspect', 1.67422, 1.69457, 1.34),
  ('wall', 'aspect', 1.69457, 1.84813, 1.258),
  ('wall', 'aspect', 1.84813, 2.08479, 0.8918),
  ('wall', 'aspect', 2.08479, 2.16629, 0.5025),
  ('wall', 'aspect', 2.16629, 2.803, 0.36),
  ('wall', 'aspect', 2.803, 2.99792, 0.1492),
  ('wall', 'aspect', 2.99792, 3.62684, 0.1529),
  ('wall', 'aspect', 3.62684, 4.69283, 0.1448),
  ('wall', 'aspect', 4.69283, 6.07212, 0.08215),
  ('wall', 'aspect', 6.07212, 7.8568, 0.03272),
  ('wall', 'aspect', 7.8568, 10.166, 0.01511),
  ('wall', 'aspect', 10.166, 100, 0.004632);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'height', -0.5, 0.25414, 0.01185),
  ('wall', 'height', 0.25414, 0.47179, 0.05575),
  ('wall', 'height', 0.47179, 0.68944, 0.1443),
  ('wall', 'height', 0.68944, 0.871327, 0.3292),
  ('wall', 'height', 0.871327, 0.90709, 0.5791),
  ('wall', 'height', 0.90709, 1.12474, 0.3581),
  ('wall', 'height', 1.12474, 1.1592, 0.376),
  ('wall', 'height', 1.1592, 1.26804, 1.079),
  ('wall', 'height', 1.26804, 1.34239, 1.084),
  ('wall', 'height', 1.34239, 1.35604, 2.038),
  ('wall', 'height', 1.35604, 1.43013, 1.574),
  ('wall', 'height', 1.43013, 1.48903, 1.749),
  ('wall', 'height', 1.48903, 1.55103, 1.669),
  ('wall', 'height', 1.55103, 1.65957, 0.9906),
  ('wall', 'height', 1.65957, 1.77769, 0.4897),
  ('wall', 'height', 1.77769, 1.99534, 0.1564),
  ('wall', 'height', 1.99534, 2.21299, 0.08971),
  ('wall', 'height', 2.21299, 4, 0.004546);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'length', 0.03, 0.621739, 0.003286),
  ('wall', 'length', 0.621739, 0.806526, 0.07851),
  ('wall', 'length', 0.806526, 1.04623, 0.1056),
  ('wall', 'length', 1.04623, 1.35718, 0.1544),
  ('wall', 'length', 1.35718, 1.43639, 0.1985),
  ('wall', 'length', 1.43639, 1.76055, 0.3333),
  ('wall', 'length', 1.76055, 2.01996, 0.3776),
  ('wall', 'length', 2.01996, 2.28381, 0.538),
  ('wall', 'length', 2.28381, 2.4159, 0.7085),
  ('wall', 'length', 2.4159, 2.645, 1.24),
  ('wall', 'length', 2.645, 2.96258, 0.8532),
  ('wall', 'length', 2.96258, 3.52126, 0.7109),
  ('wall', 'length', 3.52126, 3.84308, 0.7429),
  ('wall', 'length', 3.84308, 4.10989, 0.6595),
  ('wall', 'length', 4.10989, 4.7165, 0.8078),
  ('wall', 'length', 4.7165, 4.98528, 0.701),
  ('wall', 'length', 4.98528, 6.32756, 0.272),
  ('wall', 'length', 6.32756, 6.46696, 0.0888),
  ('wall', 'length', 6.46696, 30, 0.004606);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'rectangularity', 0, 0.301314, 0.02689),
  ('wall', 'rectangularity', 0.301314, 0.377833, 0.1673),
  ('wall', 'rectangularity', 0.377833, 0.454353, 0.5322),
  ('wall', 'rectangularity', 0.454353, 0.492382, 1.389),
  ('wall', 'rectangularity', 0.492382, 0.530872, 1.249),
  ('wall', 'rectangularity', 0.530872, 0.569039, 1.604),
  ('wall', 'rectangularity', 0.569039, 0.607392, 2.357),
  ('wall', 'rectangularity', 0.607392, 0.616624, 2.273),
  ('wall', 'rectangularity', 0.616624, 0.656671, 2.802),
  ('wall', 'rectangularity', 0.656671, 0.683911, 2.536),
  ('wall', 'rectangularity', 0.683911, 0.69778, 2.682),
  ('wall', 'rectangularity', 0.69778, 0.74605, 2.288),
  ('wall', 'rectangularity', 0.74605, 0.760431, 1.835),
  ('wall', 'rectangularity', 0.760431, 0.795902, 2.441),
  ('wall', 'rectangularity', 0.795902, 0.83695, 1.461),
  ('wall', 'rectangularity', 0.83695, 0.86858, 1.62),
  ('wall', 'rectangularity', 0.86858, 0.913469, 1.08),
  ('wall', 'rectangularity', 0.913469, 0.986885, 0.7823),
  ('wall', 'rectangularity', 0.986885, 1, 0.4492);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_length', 0.01, 0.544549, 0.002709),
  ('wall', 'spread_length', 0.544549, 0.707802, 0.07976),
  ('wall', 'spread_length', 0.707802, 0.919996, 0.08651),
  ('wall', 'spread_length', 0.919996, 1.16662, 0.2076),
  ('wall', 'spread_length', 1.16662, 1.19581, 0.2002),
  ('wall', 'spread_length', 1.19581, 1.5543, 0.2888),
  ('wall', 'spread_length', 1.5543, 1.68206, 0.4837),
  ('wall', 'spread_length', 1.68206, 2.01976, 0.6112),
  ('wall', 'spread_length', 2.01976, 2.30336, 0.8262),
  ('wall', 'spread_length', 2.30336, 2.57563, 0.9991),
  ('wall', 'spread_length', 2.57563, 2.62594, 1.036),
  ('wall', 'spread_length', 2.62594, 3.05289, 0.6548),
  ('wall', 'spread_length', 3.05289, 3.41318, 0.86),
  ('wall', 'spread_length', 3.41318, 3.46928, 0.4614),
  ('wall', 'spread_length', 3.46928, 4.02687, 0.7427),
  ('wall', 'spread_length', 4.02687, 4.43643, 0.5428),
  ('wall', 'spread_length', 4.43643, 5.76644, 0.2006),
  ('wall', 'spread_length', 5.76644, 40, 0.003809);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_width', 0.003, 0.130316, 0.002273),
  ('wall', 'spread_width', 0.130316, 0.185815, 0.05208),
  ('wall', 'spread_width', 0.185815, 0.26495, 0.0711),
  ('wall', 'spread_width', 0.26495, 0.377787, 0.09895),
  ('wall', 'spread_width', 0.377787, 0.428403, 0.1562),
  ('wall', 'spread_width', 0.428403, 0.53868, 0.1724),
  ('wall', 'spread_width', 0.53868, 0.768092, 0.2244),
  ('wall', 'spread_width', 0.768092, 1.06598, 0.3392),
  ('wall', 'spread_width', 1.06598, 1.09521, 0.3895),
  ('wall', 'spread_width', 1.09521, 1.35301, 0.4909),
  ('wall', 'spread_width', 1.35301, 1.56163, 0.6958),
  ('wall', 'spread_width', 1.56163, 1.60452, 0.6044),
  ('wall', 'spread_width', 1.60452, 1.80158, 0.8409),
  ('wall', 'spread_width', 1.80158, 2.05327, 0.8812),
  ('wall', 'spread_width', 2.05327, 2.2267, 0.5377),
  ('wall', 'spread_width', 2.2267, 2.42021, 0.722),
  ('wall', 'spread_width', 2.42021, 3.02287, 0.471),
  ('wall', 'spread_width', 3.02287, 3.17501, 0.1035),
  ('wall', 'spread_width', 3.17501, 20, 0.003261);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'tilt_deg', 0, 87.7336, 8.819e-06),
  ('wall', 'tilt_deg', 87.7336, 87.9855, 0.01795),
  ('wall', 'tilt_deg', 87.9855, 88.2373, 0.04262),
  ('wall', 'tilt_deg', 88.2373, 88.4891, 0.05864),
  ('wall', 'tilt_deg', 88.4891, 88.7409, 0.085),
  ('wall', 'tilt_deg', 88.7409, 88.9927, 0.1109),
  ('wall', 'tilt_deg', 88.9927, 89.2445, 0.1357),
  ('wall', 'tilt_deg', 89.2445, 89.4964, 0.2593),
  ('wall', 'tilt_deg', 89.4964, 89.7482, 0.9262),
  ('wall', 'tilt_deg', 89.7482, 90, 2.332);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'width', 0.01, 0.154851, 0.0035),
  ('wall', 'width', 0.154851, 0.217617, 0.03876),
  ('wall', 'width', 0.217617, 0.305823, 0.05482),
  ('wall', 'width', 0.305823, 0.429783, 0.0981),
  ('wall', 'width', 0.429783, 0.557456, 0.1248),
  ('wall', 'width', 0.557456, 0.603988, 0.1459),
  ('wall', 'width', 0.603988, 0.848802, 0.1947),
  ('wall', 'width', 0.848802, 0.996433, 0.2626),
  ('wall', 'width', 0.996433, 1.19285, 0.455),
  ('wall', 'width', 1.19285, 1.28345, 0.3808),
  ('wall', 'width', 1.28345, 1.61591, 0.5006),
  ('wall', 'width', 1.61591, 1.67635, 0.3872),
  ('wall', 'width', 1.67635, 2.31303, 0.2937),
  ('wall', 'width', 2.31303, 2.35582, 0.3794),
  ('wall', 'width', 2.35582, 2.57415, 1.179),
  ('wall', 'width', 2.57415, 2.74087, 1.646),
  ('wall', 'width', 2.74087, 2.91958, 1.807),
  ('wall', 'width', 2.91958, 3.11716, 1.321),
  ('wall', 'width', 3.11716, 3.31071, 0.298),
  ('wall', 'width', 3.31071, 12, 0.004283);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_max', -0.5, 0.592839, 0.009402),
  ('wall', 'z_max', 0.592839, 0.875019, 0.05344),
  ('wall', 'z_max', 0.875019, 1.1572, 0.09305),
  ('wall', 'z_max', 1.1572, 1.43938, 0.1738),
  ('wall', 'z_max', 1.43938, 1.45371, 0.41),
  ('wall', 'z_max', 1.45371, 1.72156, 0.381),
  ('wall', 'z_max', 1.72156, 1.75784, 0.4001),
  ('wall', 'z_max', 1.75784, 2.00374, 0.1733),
  ('wall', 'z_max', 2.00374, 2.28592, 0.0682),
  ('wall', 'z_max', 2.28592, 2.47309, 0.3562),
  ('wall', 'z_max', 2.47309, 2.5176, 2.042),
  ('wall', 'z_max', 2.5176, 2.5681, 0.7841),
  ('wall', 'z_max', 2.5681, 2.64489, 0.9188),
  ('wall', 'z_max', 2.64489, 2.74628, 1.204),
  ('wall', 'z_max', 2.74628, 2.84993, 1.011),
  ('wall', 'z_max', 2.84993, 2.97483, 0.826),
  ('wall', 'z_max', 2.97483, 3.1016, 0.7783),
  ('wall', 'z_max', 3.1016, 3.13246, 0.4559),
  ('wall', 'z_max', 3.13246, 4, 0.005304);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_min', -0.5, -0.0791495, 0.04256),
  ('wall', 'z_min', -0.0791495, -0.017493, 3.913),
  ('wall', 'z_min', -0.017493, -0.0104872, 20.12),
  ('wall', 'z_min', -0.0104872, -0.004349, 19.26),
  ('wall', 'z_min', -0.004349, 0.121051, 1.783),
  ('wall', 'z_min', 0.121051, 0.21578, 0.2694),
  ('wall', 'z_min', 0.21578, 0.321252, 0.1021),
  ('wall', 'z_min', 0.321252, 0.521452, 0.3482),
  ('wall', 'z_min', 0.521452, 0.604652, 0.4199),
  ('wall', 'z_min', 0.604652, 0.721653, 0.3203),
  ('wall', 'z_min', 0.721653, 0.921853, 0.09892),
  ('wall', 'z_min', 0.921853, 1.12205, 0.1251),
  ('wall', 'z_min', 1.12205, 1.32225, 0.07467),
  ('wall', 'z_min', 1.32225, 1.52245, 0.01591),
  ('wall', 'z_min', 1.52245, 1.72266, 0.04453),
  ('wall', 'z_min', 1.72266, 4, 0.003405);

-- table: 128 examples
UPDATE object_class SET prior = 0.04526 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.3228, 0.6608)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5264, 0.2904)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7215, 0.07546)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.2948, 0.354)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.6974, 0.1381)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1366, 0.3504)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4459, 0.3661)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.6364, 0.5756)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2344, 0.3468)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7287, 0.07394)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7158, 0.07637)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'table' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'area_m2', 0.002, 0.0822095, 0.002922),
  ('table', 'area_m2', 0.0822095, 0.121559, 0.02559),
  ('table', 'area_m2', 0.121559, 0.179743, 0.04012),
  ('table', 'area_m2', 0.179743, 0.265776, 0.08942),
  ('table', 'area_m2', 0.265776, 0.349656, 0.1604),
  ('table', 'area_m2', 0.349656, 0.392989, 0.3578),
  ('table', 'area_m2', 0.392989, 0.449719, 0.5197),
  ('table', 'area_m2', 0.449719, 0.576367, 0.4405),
  ('table', 'area_m2', 0.576367, 0.723843, 0.5046),
  ('table', 'area_m2', 0.723843, 0.859232, 0.5797),
  ('table', 'area_m2', 0.859232, 0.885036, 0.3606),
  ('table', 'area_m2', 0.885036, 1.05855, 0.5649),
  ('table', 'area_m2', 1.05855, 1.22851, 0.7191),
  ('table', 'area_m2', 1.22851, 1.2705, 1.095),
  ('table', 'area_m2', 1.2705, 1.39039, 0.7741),
  ('table', 'area_m2', 1.39039, 1.87862, 0.2927),
  ('table', 'area_m2', 1.87862, 2.77782, 0.05916),
  ('table', 'area_m2', 2.77782, 100, 0.003406);
DELETE FROM class_density WHERE class = 'table' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'aspect', 1, 1.13702, 0.8667),
  ('table', 'aspect', 1.13702, 1.1641, 0.6388),
  ('table', 'aspect', 1.1641, 1.34767, 0.6648),
  ('table', 'aspect', 1.34767, 1.50541, 1.046),
  ('table', 'aspect', 1.50541, 1.57749, 1.69),
  ('table', 'aspect', 1.57749, 1.79832, 1.128),
  ('table', 'aspect', 1.79832, 1.83636, 1.382),
  ('table', 'aspect', 1.83636, 1.95119, 1.291),
  ('table', 'aspect', 1.95119, 2.1377, 1.227),
  ('table', 'aspect', 2.1377, 2.35414, 1.06),
  ('table', 'aspect', 2.35414, 2.48849, 0.5547),
  ('table', 'aspect', 2.48849, 2.89685, 0.3179),
  ('table', 'aspect', 2.89685, 3.37221, 0.0828),
  ('table', 'aspect', 3.37221, 3.92558, 0.06683),
  ('table', 'aspect', 3.92558, 100, 0.003221);
DELETE FROM class_density WHERE class = 'table' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'height', -0.5, 0.155259, 0.0218),
  ('table', 'height', 0.155259, 0.227913, 3.607e-11),
  ('table', 'height', 0.227913, 0.300568, 1.432e-08),
  ('table', 'height', 0.300568, 0.373222, 2.304e-06),
  ('table', 'height', 0.373222, 0.445877, 0.0001511),
  ('table', 'height', 0.445877, 0.518531, 0.00407),
  ('table', 'height', 0.518531, 0.591186, 0.04548),
  ('table', 'height', 0.591186, 0.66384, 0.5327),
  ('table', 'height', 0.66384, 0.68898, 3.656),
  ('table', 'height', 0.68898, 0.701418, 7.054),
  ('table', 'height', 0.701418, 0.715655, 8.702),
  ('table', 'height', 0.715655, 0.72494, 9.547),
  ('table', 'height', 0.72494, 0.735796, 9.961),
  ('table', 'height', 0.735796, 0.747593, 9.82),
  ('table', 'height', 0.747593, 0.757059, 9.276),
  ('table', 'height', 0.757059, 0.771377, 8.036),
  ('table', 'height', 0.771377, 0.809149, 2.881),
  ('table', 'height', 0.809149, 4, 0.004876);
DELETE FROM class_density WHERE class = 'table' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'length', 0.03, 0.579161, 0.005435),
  ('table', 'length', 0.579161, 0.702563, 0.1864),
  ('table', 'length', 0.702563, 0.850198, 0.2933),
  ('table', 'length', 0.850198, 0.983133, 0.7338),
  ('table', 'length', 0.983133, 1.03385, 0.9983),
  ('table', 'length', 1.03385, 1.20765, 0.449),
  ('table', 'length', 1.20765, 1.25413, 1.206),
  ('table', 'length', 1.25413, 1.30375, 1.548),
  ('table', 'length', 1.30375, 1.52135, 0.7459),
  ('table', 'length', 1.52135, 1.63372, 1.521),
  ('table', 'length', 1.63372, 1.74063, 1.675),
  ('table', 'length', 1.74063, 1.84551, 1.153),
  ('table', 'length', 1.84551, 1.89912, 1.379),
  ('table', 'length', 1.89912, 2.23873, 0.4854),
  ('table', 'length', 2.23873, 2.71574, 0.09067),
  ('table', 'length', 2.71574, 3.29438, 0.07315),
  ('table', 'length', 3.29438, 30, 0.005245);
DELETE FROM class_density WHERE class = 'table' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'rectangularity', 0, 0.319346, 0.03058),
  ('table', 'rectangularity', 0.319346, 0.393745, 0.1953),
  ('table', 'rectangularity', 0.393745, 0.468143, 0.5036),
  ('table', 'rectangularity', 0.468143, 0.513469, 1.055),
  ('table', 'rectangularity', 0.513469, 0.542541, 1.27),
  ('table', 'rectangularity', 0.542541, 0.603326, 1.374),
  ('table', 'rectangularity', 0.603326, 0.616939, 1.914),
  ('table', 'rectangularity', 0.616939, 0.665014, 1.864),
  ('table', 'rectangularity', 0.665014, 0.691338, 4.038),
  ('table', 'rectangularity', 0.691338, 0.72378, 3.273),
  ('table', 'rectangularity', 0.72378, 0.7599, 2.952),
  ('table', 'rectangularity', 0.7599, 0.765736, 3.337),
  ('table', 'rectangularity', 0.765736, 0.782773, 4.892),
  ('table', 'rectangularity', 0.782773, 0.840134, 1.69),
  ('table', 'rectangularity', 0.840134, 0.861878, 0.8206),
  ('table', 'rectangularity', 0.861878, 0.914533, 0.8391),
  ('table', 'rectangularity', 0.914533, 0.967594, 1.006),
  ('table', 'rectangularity', 0.967594, 0.988931, 0.67),
  ('table', 'rectangularity', 0.988931, 1, 0.5187);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_length', 0.01, 0.471543, 0.003879),
  ('table', 'spread_length', 0.471543, 0.57784, 0.1349),
  ('table', 'spread_length', 0.57784, 0.708098, 0.1507),
  ('table', 'spread_length', 0.708098, 0.782375, 0.5843),
  ('table', 'spread_length', 0.782375, 0.867112, 0.9028),
  ('table', 'spread_length', 0.867112, 0.971549, 0.9666),
  ('table', 'spread_length', 0.971549, 1.06332, 0.8056),
  ('table', 'spread_length', 1.06332, 1.13095, 0.6182),
  ('table', 'spread_length', 1.13095, 1.25554, 1.192),
  ('table', 'spread_length', 1.25554, 1.30302, 1.084),
  ('table', 'spread_length', 1.30302, 1.38017, 0.8341),
  ('table', 'spread_length', 1.38017, 1.54368, 1.121),
  ('table', 'spread_length', 1.54368, 1.59676, 1.468),
  ('table', 'spread_length', 1.59676, 1.65851, 1.462),
  ('table', 'spread_length', 1.65851, 1.9567, 0.4415),
  ('table', 'spread_length', 1.9567, 2.39779, 0.09156),
  ('table', 'spread_length', 2.39779, 2.93831, 0.05859),
  ('table', 'spread_length', 2.93831, 40, 0.00313);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_width', 0.003, 0.185816, 0.002483),
  ('table', 'spread_width', 0.185816, 0.232438, 0.05017),
  ('table', 'spread_width', 0.232438, 0.290757, 0.09534),
  ('table', 'spread_width', 0.290757, 0.363708, 0.1982),
  ('table', 'spread_width', 0.363708, 0.400219, 0.3443),
  ('table', 'spread_width', 0.400219, 0.454963, 0.3056),
  ('table', 'spread_width', 0.454963, 0.547812, 0.3997),
  ('table', 'spread_width', 0.547812, 0.569113, 0.9535),
  ('table', 'spread_width', 0.569113, 0.602902, 1.237),
  ('table', 'spread_width', 0.602902, 0.670627, 1.092),
  ('table', 'spread_width', 0.670627, 0.704329, 1.871),
  ('table', 'spread_width', 0.704329, 0.762276, 1.467),
  ('table', 'spread_width', 0.762276, 0.818289, 1.457),
  ('table', 'spread_width', 0.818289, 0.88574, 1.342),
  ('table', 'spread_width', 0.88574, 1.11395, 0.3838),
  ('table', 'spread_width', 1.11395, 1.39345, 0.1073),
  ('table', 'spread_width', 1.39345, 20, 0.004931);
DELETE FROM class_density WHERE class = 'table' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'tilt_deg', 0, 0.143044, 1.2),
  ('table', 'tilt_deg', 0.143044, 0.301032, 1.061),
  ('table', 'tilt_deg', 0.301032, 0.530887, 0.7859),
  ('table', 'tilt_deg', 0.530887, 0.781818, 0.5217),
  ('table', 'tilt_deg', 0.781818, 0.903096, 0.4235),
  ('table', 'tilt_deg', 0.903096, 1.04143, 0.3918),
  ('table', 'tilt_deg', 1.04143, 1.20413, 0.3531),
  ('table', 'tilt_deg', 1.20413, 1.46425, 0.2775),
  ('table', 'tilt_deg', 1.46425, 1.80619, 0.1779),
  ('table', 'tilt_deg', 1.80619, 2.10722, 0.0971),
  ('table', 'tilt_deg', 2.10722, 2.40825, 0.04992),
  ('table', 'tilt_deg', 2.40825, 2.53574, 0.03017),
  ('table', 'tilt_deg', 2.53574, 2.70929, 0.01866),
  ('table', 'tilt_deg', 2.70929, 90, 2.158e-05);
DELETE FROM class_density WHERE class = 'table' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'width', 0.01, 0.257596, 0.003115),
  ('table', 'width', 0.257596, 0.323298, 0.06294),
  ('table', 'width', 0.323298, 0.405759, 0.0931),
  ('table', 'width', 0.405759, 0.509252, 0.283),
  ('table', 'width', 0.509252, 0.52116, 0.3768),
  ('table', 'width', 0.52116, 0.639142, 0.4086),
  ('table', 'width', 0.639142, 0.668812, 0.6292),
  ('table', 'width', 0.668812, 0.748421, 1.028),
  ('table', 'width', 0.748421, 0.802161, 1.204),
  ('table', 'width', 0.802161, 0.857374, 2.106),
  ('table', 'width', 0.857374, 0.90088, 2.115),
  ('table', 'width', 0.90088, 0.971392, 1.213),
  ('table', 'width', 0.971392, 1.00676, 0.8078),
  ('table', 'width', 1.00676, 1.05921, 1.515),
  ('table', 'width', 1.05921, 1.26354, 0.3837),
  ('table', 'width', 1.26354, 1.58582, 0.1369),
  ('table', 'width', 1.58582, 1.9903, 0.08186),
  ('table', 'width', 1.9903, 12, 0.006063);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_max', -0.5, 0.175828, 0.02114),
  ('table', 'z_max', 0.175828, 0.2481, 4.757e-11),
  ('table', 'z_max', 0.2481, 0.320372, 1.975e-08),
  ('table', 'z_max', 0.320372, 0.392643, 3.233e-06),
  ('table', 'z_max', 0.392643, 0.464915, 0.0002101),
  ('table', 'z_max', 0.464915, 0.537186, 0.005469),
  ('table', 'z_max', 0.537186, 0.609458, 0.0576),
  ('table', 'z_max', 0.609458, 0.68173, 0.946),
  ('table', 'z_max', 0.68173, 0.694134, 4.61),
  ('table', 'z_max', 0.694134, 0.70963, 6.639),
  ('table', 'z_max', 0.70963, 0.721378, 8.044),
  ('table', 'z_max', 0.721378, 0.735027, 9.076),
  ('table', 'z_max', 0.735027, 0.743794, 10.45),
  ('table', 'z_max', 0.743794, 0.752042, 10.98),
  ('table', 'z_max', 0.752042, 0.762306, 10.22),
  ('table', 'z_max', 0.762306, 0.777774, 8.154),
  ('table', 'z_max', 0.777774, 0.826273, 2.216),
  ('table', 'z_max', 0.826273, 4, 0.004271);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_min', -0.5, 0.145677, 0.02213),
  ('table', 'z_min', 0.145677, 0.218492, 4.354e-11),
  ('table', 'z_min', 0.218492, 0.291307, 1.595e-08),
  ('table', 'z_min', 0.291307, 0.364122, 2.408e-06),
  ('table', 'z_min', 0.364122, 0.436937, 0.0001508),
  ('table', 'z_min', 0.436937, 0.509752, 0.003947),
  ('table', 'z_min', 0.509752, 0.582567, 0.04356),
  ('table', 'z_min', 0.582567, 0.655382, 0.5271),
  ('table', 'z_min', 0.655382, 0.685544, 3.516),
  ('table', 'z_min', 0.685544, 0.696962, 7.432),
  ('table', 'z_min', 0.696962, 0.707622, 9.161),
  ('table', 'z_min', 0.707622, 0.718838, 9.679),
  ('table', 'z_min', 0.718838, 0.728196, 9.494),
  ('table', 'z_min', 0.728196, 0.7395, 9.153),
  ('table', 'z_min', 0.7395, 0.753783, 8.742),
  ('table', 'z_min', 0.753783, 0.764056, 7.892),
  ('table', 'z_min', 0.764056, 0.793436, 4.312),
  ('table', 'z_min', 0.793436, 0.801011, 1.005),
  ('table', 'z_min', 0.801011, 4, 0.004438);

-- flat_screen: 102 examples
UPDATE object_class SET prior = 0.03618 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.809, 0.4548)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.4367, 0.2227)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 0.9966, 0.05652)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.5549, 0.2835)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.7862, 0.1326)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7518, 0.2154)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.228, 0.2336)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 84.43, 4.064)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -0.996, 0.2566)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.155, 0.07516)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7558, 0.1272)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'area_m2', 0.002, 0.0412984, 0.004411),
  ('flat_screen', 'area_m2', 0.0412984, 0.0537557, 0.07261),
  ('flat_screen', 'area_m2', 0.0537557, 0.0699705, 0.07698),
  ('flat_screen', 'area_m2', 0.0699705, 0.0910765, 0.1664),
  ('flat_screen', 'area_m2', 0.0910765, 0.095914, 0.2884),
  ('flat_screen', 'area_m2', 0.095914, 0.118549, 0.4143),
  ('flat_screen', 'area_m2', 0.118549, 0.122547, 0.7183),
  ('flat_screen', 'area_m2', 0.122547, 0.144907, 0.7174),
  ('flat_screen', 'area_m2', 0.144907, 0.154308, 0.6434),
  ('flat_screen', 'area_m2', 0.154308, 0.167292, 0.9855),
  ('flat_screen', 'area_m2', 0.167292, 0.174959, 1.888),
  ('flat_screen', 'area_m2', 0.174959, 0.198224, 0.9595),
  ('flat_screen', 'area_m2', 0.198224, 0.234621, 0.6526),
  ('flat_screen', 'area_m2', 0.234621, 0.261439, 0.693),
  ('flat_screen', 'area_m2', 0.261439, 0.277843, 0.5911),
  ('flat_screen', 'area_m2', 0.277843, 0.340299, 0.3954),
  ('flat_screen', 'area_m2', 0.340299, 0.397919, 0.1233),
  ('flat_screen', 'area_m2', 0.397919, 0.442947, 0.0558),
  ('flat_screen', 'area_m2', 0.442947, 100, 0.001049);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'aspect', 1, 1.13792, 0.4302),
  ('flat_screen', 'aspect', 1.13792, 1.20176, 1.103),
  ('flat_screen', 'aspect', 1.20176, 1.28729, 1.471),
  ('flat_screen', 'aspect', 1.28729, 1.39298, 1.365),
  ('flat_screen', 'aspect', 1.39298, 1.4623, 2.219),
  ('flat_screen', 'aspect', 1.4623, 1.56693, 1.712),
  ('flat_screen', 'aspect', 1.56693, 1.62727, 2.897),
  ('flat_screen', 'aspect', 1.62727, 1.67666, 1.856),
  ('flat_screen', 'aspect', 1.67666, 1.79431, 0.9049),
  ('flat_screen', 'aspect', 1.79431, 1.90791, 0.8947),
  ('flat_screen', 'aspect', 1.90791, 2.0245, 0.8616),
  ('flat_screen', 'aspect', 2.0245, 2.17104, 0.6271),
  ('flat_screen', 'aspect', 2.17104, 2.47047, 0.2825),
  ('flat_screen', 'aspect', 2.47047, 2.8112, 0.1191),
  ('flat_screen', 'aspect', 2.8112, 3.1898, 0.1116),
  ('flat_screen', 'aspect', 3.1898, 100, 0.002065);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'height', -0.5, 0.792158, 0.007726),
  ('flat_screen', 'height', 0.792158, 0.830551, 0.1653),
  ('flat_screen', 'height', 0.830551, 0.868943, 0.2628),
  ('flat_screen', 'height', 0.868943, 0.907335, 0.8117),
  ('flat_screen', 'height', 0.907335, 0.942662, 2.266),
  ('flat_screen', 'height', 0.942662, 0.960673, 5.573),
  ('flat_screen', 'height', 0.960673, 0.975127, 6.727),
  ('flat_screen', 'height', 0.975127, 0.98412, 7.386),
  ('flat_screen', 'height', 0.98412, 1.00509, 7.741),
  ('flat_screen', 'height', 1.00509, 1.01848, 6.853),
  ('flat_screen', 'height', 1.01848, 1.04077, 5.49),
  ('flat_screen', 'height', 1.04077, 1.0609, 4.368),
  ('flat_screen', 'height', 1.0609, 1.06766, 3.435),
  ('flat_screen', 'height', 1.06766, 1.0993, 2.746),
  ('flat_screen', 'height', 1.0993, 1.12552, 0.5942),
  ('flat_screen', 'height', 1.12552, 1.13769, 0.3341),
  ('flat_screen', 'height', 1.13769, 4, 0.001474);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'length', 0.03, 0.303372, 0.005288),
  ('flat_screen', 'length', 0.303372, 0.352819, 0.1118),
  ('flat_screen', 'length', 0.352819, 0.401834, 0.6482),
  ('flat_screen', 'length', 0.401834, 0.410325, 0.868),
  ('flat_screen', 'length', 0.410325, 0.473059, 0.7088),
  ('flat_screen', 'length', 0.473059, 0.516958, 1.232),
  ('flat_screen', 'length', 0.516958, 0.538683, 2.305),
  ('flat_screen', 'length', 0.538683, 0.554984, 1.834),
  ('flat_screen', 'length', 0.554984, 0.588566, 1.305),
  ('flat_screen', 'length', 0.588566, 0.61526, 2.087),
  ('flat_screen', 'length', 0.61526, 0.645441, 0.9137),
  ('flat_screen', 'length', 0.645441, 0.703029, 0.7366),
  ('flat_screen', 'length', 0.703029, 0.750642, 1.035),
  ('flat_screen', 'length', 0.750642, 0.82707, 0.5698),
  ('flat_screen', 'length', 0.82707, 0.872989, 0.3656),
  ('flat_screen', 'length', 0.872989, 1.01528, 0.3147),
  ('flat_screen', 'length', 1.01528, 1.10468, 0.2644),
  ('flat_screen', 'length', 1.10468, 1.18076, 0.1735),
  ('flat_screen', 'length', 1.18076, 30, 0.002627);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'rectangularity', 0, 0.451421, 0.02362),
  ('flat_screen', 'rectangularity', 0.451421, 0.512374, 0.1731),
  ('flat_screen', 'rectangularity', 0.512374, 0.573327, 0.9807),
  ('flat_screen', 'rectangularity', 0.573327, 0.589262, 1.512),
  ('flat_screen', 'rectangularity', 0.589262, 0.63428, 1.401),
  ('flat_screen', 'rectangularity', 0.63428, 0.681012, 1.233),
  ('flat_screen', 'rectangularity', 0.681012, 0.695234, 1.486),
  ('flat_screen', 'rectangularity', 0.695234, 0.741758, 2.055),
  ('flat_screen', 'rectangularity', 0.741758, 0.756187, 3.727),
  ('flat_screen', 'rectangularity', 0.756187, 0.765937, 3.858),
  ('flat_screen', 'rectangularity', 0.765937, 0.81714, 1.881),
  ('flat_screen', 'rectangularity', 0.81714, 0.83953, 1.604),
  ('flat_screen', 'rectangularity', 0.83953, 0.873258, 3.201),
  ('flat_screen', 'rectangularity', 0.873258, 0.899128, 3.921),
  ('flat_screen', 'rectangularity', 0.899128, 0.939047, 2.326),
  ('flat_screen', 'rectangularity', 0.939047, 0.980182, 2.763),
  ('flat_screen', 'rectangularity', 0.980182, 1, 0.9072);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_length', 0.01, 0.297441, 0.004034),
  ('flat_screen', 'spread_length', 0.297441, 0.331193, 0.2149),
  ('flat_screen', 'spread_length', 0.331193, 0.352972, 1.285),
  ('flat_screen', 'spread_length', 0.352972, 0.368775, 1.445),
  ('flat_screen', 'spread_length', 0.368775, 0.380851, 0.962),
  ('flat_screen', 'spread_length', 0.380851, 0.410621, 0.9049),
  ('flat_screen', 'spread_length', 0.410621, 0.430869, 1.186),
  ('flat_screen', 'spread_length', 0.430869, 0.457216, 1.543),
  ('flat_screen', 'spread_length', 0.457216, 0.466567, 1.097),
  ('flat_screen', 'spread_length', 0.466567, 0.509099, 1.407),
  ('flat_screen', 'spread_length', 0.509099, 0.525875, 2.799),
  ('flat_screen', 'spread_length', 0.525875, 0.548432, 2.522),
  ('flat_screen', 'spread_length', 0.548432, 0.566868, 1.494),
  ('flat_screen', 'spread_length', 0.566868, 0.597165, 1.123),
  ('flat_screen', 'spread_length', 0.597165, 0.631193, 0.761),
  ('flat_screen', 'spread_length', 0.631193, 0.702817, 0.3822),
  ('flat_screen', 'spread_length', 0.702817, 0.782569, 0.2109),
  ('flat_screen', 'spread_length', 0.782569, 40, 0.003781);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_width', 0.003, 0.116165, 0.001846),
  ('flat_screen', 'spread_width', 0.116165, 0.133796, 0.09464),
  ('flat_screen', 'spread_width', 0.133796, 0.154102, 0.07199),
  ('flat_screen', 'spread_width', 0.154102, 0.177491, 0.1715),
  ('flat_screen', 'spread_width', 0.177491, 0.204429, 0.1032),
  ('flat_screen', 'spread_width', 0.204429, 0.235456, 0.3287),
  ('flat_screen', 'spread_width', 0.235456, 0.270625, 1.016),
  ('flat_screen', 'spread_width', 0.270625, 0.279685, 2.652),
  ('flat_screen', 'spread_width', 0.279685, 0.296262, 2.035),
  ('flat_screen', 'spread_width', 0.296262, 0.312351, 1.652),
  ('flat_screen', 'spread_width', 0.312351, 0.318728, 2.293),
  ('flat_screen', 'spread_width', 0.318728, 0.32424, 2.952),
  ('flat_screen', 'spread_width', 0.32424, 0.345391, 1.972),
  ('flat_screen', 'spread_width', 0.345391, 0.359757, 1.457),
  ('flat_screen', 'spread_width', 0.359757, 0.36879, 2.165),
  ('flat_screen', 'spread_width', 0.36879, 0.414359, 0.8489),
  ('flat_screen', 'spread_width', 0.414359, 20, 0.004543);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'tilt_deg', 0, 70.979, 0.0001169),
  ('flat_screen', 'tilt_deg', 70.979, 71.684, 0.007021),
  ('flat_screen', 'tilt_deg', 71.684, 73.0925, 0.006378),
  ('flat_screen', 'tilt_deg', 73.0925, 75.2059, 0.002417),
  ('flat_screen', 'tilt_deg', 75.2059, 77.3193, 0.001923),
  ('flat_screen', 'tilt_deg', 77.3193, 79.4328, 0.02003),
  ('flat_screen', 'tilt_deg', 79.4328, 80.2494, 0.04539),
  ('flat_screen', 'tilt_deg', 80.2494, 81.2955, 0.107),
  ('flat_screen', 'tilt_deg', 81.2955, 81.5462, 0.1686),
  ('flat_screen', 'tilt_deg', 81.5462, 82.1673, 0.09891),
  ('flat_screen', 'tilt_deg', 82.1673, 83.3319, 0.0905),
  ('flat_screen', 'tilt_deg', 83.3319, 83.6597, 0.08271),
  ('flat_screen', 'tilt_deg', 83.6597, 85.6099, 0.06029),
  ('flat_screen', 'tilt_deg', 85.6099, 87.3852, 0.06012),
  ('flat_screen', 'tilt_deg', 87.3852, 87.8866, 0.07438),
  ('flat_screen', 'tilt_deg', 87.8866, 88.3426, 0.1133),
  ('flat_screen', 'tilt_deg', 88.3426, 89.2357, 0.1393),
  ('flat_screen', 'tilt_deg', 89.2357, 90, 0.1353);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'width', 0.01, 0.160223, 0.004053),
  ('flat_screen', 'width', 0.160223, 0.187927, 0.1126),
  ('flat_screen', 'width', 0.187927, 0.220422, 0.1205),
  ('flat_screen', 'width', 0.220422, 0.258536, 0.1389),
  ('flat_screen', 'width', 0.258536, 0.277221, 0.6301),
  ('flat_screen', 'width', 0.277221, 0.30324, 0.8733),
  ('flat_screen', 'width', 0.30324, 0.322828, 0.7868),
  ('flat_screen', 'width', 0.322828, 0.354895, 1.11),
  ('flat_screen', 'width', 0.354895, 0.371888, 2.296),
  ('flat_screen', 'width', 0.371888, 0.391049, 2.175),
  ('flat_screen', 'width', 0.391049, 0.417174, 1.528),
  ('flat_screen', 'width', 0.417174, 0.436459, 2.251),
  ('flat_screen', 'width', 0.436459, 0.467812, 1.552),
  ('flat_screen', 'width', 0.467812, 0.489308, 1.113),
  ('flat_screen', 'width', 0.489308, 0.573915, 0.2577),
  ('flat_screen', 'width', 0.573915, 0.673152, 0.1437),
  ('flat_screen', 'width', 0.673152, 12, 0.004829);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_max', -0.5, 0.984722, 0.007904),
  ('flat_screen', 'z_max', 0.984722, 1.03295, 0.3577),
  ('flat_screen', 'z_max', 1.03295, 1.07528, 2.251),
  ('flat_screen', 'z_max', 1.07528, 1.08117, 4.571),
  ('flat_screen', 'z_max', 1.08117, 1.0955, 4.824),
  ('flat_screen', 'z_max', 1.0955, 1.1184, 4.694),
  ('flat_screen', 'z_max', 1.1184, 1.1294, 5.297),
  ('flat_screen', 'z_max', 1.1294, 1.13836, 6.397),
  ('flat_screen', 'z_max', 1.13836, 1.1534, 6.036),
  ('flat_screen', 'z_max', 1.1534, 1.17668, 5.05),
  ('flat_screen', 'z_max', 1.17668, 1.20306, 4.726),
  ('flat_screen', 'z_max', 1.20306, 1.22585, 3.916),
  ('flat_screen', 'z_max', 1.22585, 1.23234, 2.625),
  ('flat_screen', 'z_max', 1.23234, 1.27408, 1.42),
  ('flat_screen', 'z_max', 1.27408, 1.3223, 0.4547),
  ('flat_screen', 'z_max', 1.3223, 1.37053, 0.2521),
  ('flat_screen', 'z_max', 1.37053, 1.41434, 0.3649),
  ('flat_screen', 'z_max', 1.41434, 4, 0.003076);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_min', -0.5, 0.000419565, 0.01752),
  ('flat_screen', 'z_min', 0.000419565, 0.106492, 0.08265),
  ('flat_screen', 'z_min', 0.106492, 0.212564, 0.0001153),
  ('flat_screen', 'z_min', 0.212564, 0.318636, 0.0002821),
  ('flat_screen', 'z_min', 0.318636, 0.424708, 0.004292),
  ('flat_screen', 'z_min', 0.424708, 0.53078, 0.03437),
  ('flat_screen', 'z_min', 0.53078, 0.636852, 0.2431),
  ('flat_screen', 'z_min', 0.636852, 0.681297, 1.893),
  ('flat_screen', 'z_min', 0.681297, 0.711378, 4.302),
  ('flat_screen', 'z_min', 0.711378, 0.72117, 6.102),
  ('flat_screen', 'z_min', 0.72117, 0.742924, 5.277),
  ('flat_screen', 'z_min', 0.742924, 0.764991, 5.177),
  ('flat_screen', 'z_min', 0.764991, 0.804157, 3.028),
  ('flat_screen', 'z_min', 0.804157, 0.828579, 3.571),
  ('flat_screen', 'z_min', 0.828579, 0.848996, 2.331),
  ('flat_screen', 'z_min', 0.848996, 0.871893, 2.815),
  ('flat_screen', 'z_min', 0.871893, 0.955068, 1.441),
  ('flat_screen', 'z_min', 0.955068, 4, 0.004095);

-- keyboard: 68 examples
UPDATE object_class SET prior = 0.0242 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.851, 0.445)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7467, 0.3169)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7556, 0.0448)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.9518, 0.3207)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8272, 0.0814)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -1.041, 0.3315)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.853, 0.1322)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.882, 2.117)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.703, 0.1965)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7632, 0.04612)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7486, 0.04413)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'area_m2', 0.002, 0.0166019, 0.004953),
  ('keyboard', 'area_m2', 0.0166019, 0.017786, 0.1093),
  ('keyboard', 'area_m2', 0.017786, 0.0209723, 0.1422),
  ('keyboard', 'area_m2', 0.0209723, 0.0264932, 0.1621),
  ('keyboard', 'area_m2', 0.0264932, 0.0301927, 0.2183),
  ('keyboard', 'area_m2', 0.0301927, 0.0334674, 0.2381),
  ('keyboard', 'area_m2', 0.0334674, 0.0422776, 0.2329),
  ('keyboard', 'area_m2', 0.0422776, 0.0463381, 0.4971),
  ('keyboard', 'area_m2', 0.0463381, 0.053407, 0.7977),
  ('keyboard', 'area_m2', 0.053407, 0.0608804, 0.9063),
  ('keyboard', 'area_m2', 0.0608804, 0.0661066, 1.216),
  ('keyboard', 'area_m2', 0.0661066, 0.0739927, 0.9546),
  ('keyboard', 'area_m2', 0.0739927, 0.0803149, 1.207),
  ('keyboard', 'area_m2', 0.0803149, 0.0852263, 1.109),
  ('keyboard', 'area_m2', 0.0852263, 0.089427, 0.8537),
  ('keyboard', 'area_m2', 0.089427, 0.107662, 0.4584),
  ('keyboard', 'area_m2', 0.107662, 0.136003, 0.0969),
  ('keyboard', 'area_m2', 0.136003, 100, 0.002167);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'aspect', 1, 1.15699, 0.3922),
  ('keyboard', 'aspect', 1.15699, 1.33862, 0.3494),
  ('keyboard', 'aspect', 1.33862, 1.37908, 0.4121),
  ('keyboard', 'aspect', 1.37908, 1.54877, 0.46),
  ('keyboard', 'aspect', 1.54877, 1.68513, 0.5838),
  ('keyboard', 'aspect', 1.68513, 1.7919, 0.7333),
  ('keyboard', 'aspect', 1.7919, 1.95102, 0.8435),
  ('keyboard', 'aspect', 1.95102, 2.07321, 1.325),
  ('keyboard', 'aspect', 2.07321, 2.35166, 1.116),
  ('keyboard', 'aspect', 2.35166, 2.39868, 1.086),
  ('keyboard', 'aspect', 2.39868, 2.54496, 1.625),
  ('keyboard', 'aspect', 2.54496, 2.76328, 1.214),
  ('keyboard', 'aspect', 2.76328, 2.94396, 1.545),
  ('keyboard', 'aspect', 2.94396, 3.21092, 0.8467),
  ('keyboard', 'aspect', 3.21092, 3.56842, 0.2874),
  ('keyboard', 'aspect', 3.56842, 3.715, 0.1805),
  ('keyboard', 'aspect', 3.715, 100, 0.003795);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'height', -0.5, 0.466645, 0.01293),
  ('keyboard', 'height', 0.466645, 0.509345, 6.767e-08),
  ('keyboard', 'height', 0.509345, 0.552045, 9.635e-06),
  ('keyboard', 'height', 0.552045, 0.594744, 0.0005696),
  ('keyboard', 'height', 0.594744, 0.637444, 0.01409),
  ('keyboard', 'height', 0.637444, 0.680144, 0.1501),
  ('keyboard', 'height', 0.680144, 0.721137, 3.184),
  ('keyboard', 'height', 0.721137, 0.731761, 9.194),
  ('keyboard', 'height', 0.731761, 0.740744, 10.04),
  ('keyboard', 'height', 0.740744, 0.754109, 10.36),
  ('keyboard', 'height', 0.754109, 0.761038, 10.54),
  ('keyboard', 'height', 0.761038, 0.768374, 9.909),
  ('keyboard', 'height', 0.768374, 0.789062, 7.842),
  ('keyboard', 'height', 0.789062, 0.800545, 7.29),
  ('keyboard', 'height', 0.800545, 0.808243, 6.203),
  ('keyboard', 'height', 0.808243, 0.839556, 2.304),
  ('keyboard', 'height', 0.839556, 0.850942, 0.594),
  ('keyboard', 'height', 0.850942, 4, 0.001675);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'length', 0.03, 0.155676, 0.008531),
  ('keyboard', 'length', 0.155676, 0.180557, 0.1655),
  ('keyboard', 'length', 0.180557, 0.209416, 0.306),
  ('keyboard', 'length', 0.209416, 0.219214, 0.2945),
  ('keyboard', 'length', 0.219214, 0.242887, 0.2087),
  ('keyboard', 'length', 0.242887, 0.281707, 0.1751),
  ('keyboard', 'length', 0.281707, 0.326732, 0.5915),
  ('keyboard', 'length', 0.326732, 0.359381, 1.178),
  ('keyboard', 'length', 0.359381, 0.378953, 0.4226),
  ('keyboard', 'length', 0.378953, 0.429061, 0.8067),
  ('keyboard', 'length', 0.429061, 0.439521, 2.438),
  ('keyboard', 'length', 0.439521, 0.446667, 2.973),
  ('keyboard', 'length', 0.446667, 0.459564, 3.088),
  ('keyboard', 'length', 0.459564, 0.481338, 2.31),
  ('keyboard', 'length', 0.481338, 0.509711, 1.721),
  ('keyboard', 'length', 0.509711, 0.591245, 0.7436),
  ('keyboard', 'length', 0.591245, 30, 0.00569);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'rectangularity', 0, 0.607945, 0.02154),
  ('keyboard', 'rectangularity', 0.607945, 0.648809, 0.1946),
  ('keyboard', 'rectangularity', 0.648809, 0.689672, 0.7937),
  ('keyboard', 'rectangularity', 0.689672, 0.71666, 2.019),
  ('keyboard', 'rectangularity', 0.71666, 0.730536, 2.79),
  ('keyboard', 'rectangularity', 0.730536, 0.759489, 2.861),
  ('keyboard', 'rectangularity', 0.759489, 0.771399, 2.367),
  ('keyboard', 'rectangularity', 0.771399, 0.803333, 2.804),
  ('keyboard', 'rectangularity', 0.803333, 0.812263, 5.395),
  ('keyboard', 'rectangularity', 0.812263, 0.827678, 4.271),
  ('keyboard', 'rectangularity', 0.827678, 0.850566, 4.843),
  ('keyboard', 'rectangularity', 0.850566, 0.871541, 4.901),
  ('keyboard', 'rectangularity', 0.871541, 0.883133, 7.749),
  ('keyboard', 'rectangularity', 0.883133, 0.89399, 2.167),
  ('keyboard', 'rectangularity', 0.89399, 0.93241, 2.857),
  ('keyboard', 'rectangularity', 0.93241, 0.962503, 2.755),
  ('keyboard', 'rectangularity', 0.962503, 0.975717, 0.873),
  ('keyboard', 'rectangularity', 0.975717, 1, 0.3105);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_length', 0.01, 0.145345, 0.006389),
  ('keyboard', 'spread_length', 0.145345, 0.167208, 0.2266),
  ('keyboard', 'spread_length', 0.167208, 0.192359, 0.2885),
  ('keyboard', 'spread_length', 0.192359, 0.221293, 0.2092),
  ('keyboard', 'spread_length', 0.221293, 0.25458, 0.1577),
  ('keyboard', 'spread_length', 0.25458, 0.292874, 0.6458),
  ('keyboard', 'spread_length', 0.292874, 0.324627, 1.151),
  ('keyboard', 'spread_length', 0.324627, 0.336928, 0.784),
  ('keyboard', 'spread_length', 0.336928, 0.387609, 0.5602),
  ('keyboard', 'spread_length', 0.387609, 0.393964, 0.7372),
  ('keyboard', 'spread_length', 0.393964, 0.416658, 1.722),
  ('keyboard', 'spread_length', 0.416658, 0.437895, 2.273),
  ('keyboard', 'spread_length', 0.437895, 0.445913, 2.06),
  ('keyboard', 'spread_length', 0.445913, 0.457485, 2.175),
  ('keyboard', 'spread_length', 0.457485, 0.476041, 2.772),
  ('keyboard', 'spread_length', 0.476041, 0.512279, 1.253),
  ('keyboard', 'spread_length', 0.512279, 40, 0.005946);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_width', 0.003, 0.113762, 0.002765),
  ('keyboard', 'spread_width', 0.113762, 0.12275, 0.3896),
  ('keyboard', 'spread_width', 0.12275, 0.132447, 0.7625),
  ('keyboard', 'spread_width', 0.132447, 0.135046, 0.9398),
  ('keyboard', 'spread_width', 0.135046, 0.141834, 2.063),
  ('keyboard', 'spread_width', 0.141834, 0.14799, 2.986),
  ('keyboard', 'spread_width', 0.14799, 0.152472, 3.054),
  ('keyboard', 'spread_width', 0.152472, 0.154202, 2.835),
  ('keyboard', 'spread_width', 0.154202, 0.159156, 2.599),
  ('keyboard', 'spread_width', 0.159156, 0.165653, 2.905),
  ('keyboard', 'spread_width', 0.165653, 0.17237, 2.724),
  ('keyboard', 'spread_width', 0.17237, 0.179529, 1.889),
  ('keyboard', 'spread_width', 0.179529, 0.183312, 1.478),
  ('keyboard', 'spread_width', 0.183312, 0.193713, 1.027),
  ('keyboard', 'spread_width', 0.193713, 0.209017, 0.4815),
  ('keyboard', 'spread_width', 0.209017, 0.217257, 0.306),
  ('keyboard', 'spread_width', 0.217257, 0.22553, 0.2235),
  ('keyboard', 'spread_width', 0.22553, 20, 0.001135);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'tilt_deg', 0, 0.252719, 0.05408),
  ('keyboard', 'tilt_deg', 0.252719, 0.934526, 0.1068),
  ('keyboard', 'tilt_deg', 0.934526, 1.11693, 0.1645),
  ('keyboard', 'tilt_deg', 1.11693, 1.78768, 0.1556),
  ('keyboard', 'tilt_deg', 1.78768, 2.65965, 0.114),
  ('keyboard', 'tilt_deg', 2.65965, 3.7381, 0.1221),
  ('keyboard', 'tilt_deg', 3.7381, 4.13053, 0.2178),
  ('keyboard', 'tilt_deg', 4.13053, 4.67263, 0.1549),
  ('keyboard', 'tilt_deg', 4.67263, 5.00967, 0.1317),
  ('keyboard', 'tilt_deg', 5.00967, 5.60715, 0.1476),
  ('keyboard', 'tilt_deg', 5.60715, 6.54168, 0.1405),
  ('keyboard', 'tilt_deg', 6.54168, 7.4762, 0.07838),
  ('keyboard', 'tilt_deg', 7.4762, 8.41073, 0.03305),
  ('keyboard', 'tilt_deg', 8.41073, 90, 0.0001289);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'width', 0.01, 0.122922, 0.004536),
  ('keyboard', 'width', 0.122922, 0.13776, 0.336),
  ('keyboard', 'width', 0.13776, 0.146699, 1.005),
  ('keyboard', 'width', 0.146699, 0.154389, 1.81),
  ('keyboard', 'width', 0.154389, 0.163863, 2.084),
  ('keyboard', 'width', 0.163863, 0.17026, 2.497),
  ('keyboard', 'width', 0.17026, 0.173025, 2.704),
  ('keyboard', 'width', 0.173025, 0.180575, 1.856),
  ('keyboard', 'width', 0.180575, 0.19391, 1.285),
  ('keyboard', 'width', 0.19391, 0.198023, 1.623),
  ('keyboard', 'width', 0.198023, 0.209594, 1.749),
  ('keyboard', 'width', 0.209594, 0.217316, 1.285),
  ('keyboard', 'width', 0.217316, 0.23032, 1.035),
  ('keyboard', 'width', 0.23032, 0.243548, 0.7538),
  ('keyboard', 'width', 0.243548, 0.272946, 0.3485),
  ('keyboard', 'width', 0.272946, 0.305893, 0.1864),
  ('keyboard', 'width', 0.305893, 0.342817, 0.04131),
  ('keyboard', 'width', 0.342817, 12, 0.003578);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_max', -0.5, 0.471316, 0.01287),
  ('keyboard', 'z_max', 0.471316, 0.514962, 1.263e-07),
  ('keyboard', 'z_max', 0.514962, 0.558608, 1.565e-05),
  ('keyboard', 'z_max', 0.558608, 0.602253, 0.0008164),
  ('keyboard', 'z_max', 0.602253, 0.645899, 0.01805),
  ('keyboard', 'z_max', 0.645899, 0.689544, 0.1793),
  ('keyboard', 'z_max', 0.689544, 0.724891, 3.165),
  ('keyboard', 'z_max', 0.724891, 0.73319, 8.448),
  ('keyboard', 'z_max', 0.73319, 0.745728, 9.295),
  ('keyboard', 'z_max', 0.745728, 0.763215, 9.753),
  ('keyboard', 'z_max', 0.763215, 0.776715, 10.22),
  ('keyboard', 'z_max', 0.776715, 0.799001, 7.464),
  ('keyboard', 'z_max', 0.799001, 0.809826, 6.933),
  ('keyboard', 'z_max', 0.809826, 0.820481, 5.54),
  ('keyboard', 'z_max', 0.820481, 0.851112, 1.917),
  ('keyboard', 'z_max', 0.851112, 0.864126, 0.5937),
  ('keyboard', 'z_max', 0.864126, 4, 0.001597);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_min', -0.5, 0.458714, 0.01304),
  ('keyboard', 'z_min', 0.458714, 0.50102, 3.578e-08),
  ('keyboard', 'z_min', 0.50102, 0.543325, 5.811e-06),
  ('keyboard', 'z_min', 0.543325, 0.585631, 0.0003876),
  ('keyboard', 'z_min', 0.585631, 0.627936, 0.0107),
  ('keyboard', 'z_min', 0.627936, 0.670242, 0.125),
  ('keyboard', 'z_min', 0.670242, 0.712547, 2.613),
  ('keyboard', 'z_min', 0.712547, 0.725579, 8.952),
  ('keyboard', 'z_min', 0.725579, 0.733567, 10.38),
  ('keyboard', 'z_min', 0.733567, 0.744234, 10.65),
  ('keyboard', 'z_min', 0.744234, 0.754853, 10.54),
  ('keyboard', 'z_min', 0.754853, 0.763684, 9.951),
  ('keyboard', 'z_min', 0.763684, 0.78109, 8.289),
  ('keyboard', 'z_min', 0.78109, 0.790256, 7.491),
  ('keyboard', 'z_min', 0.790256, 0.797158, 6.666),
  ('keyboard', 'z_min', 0.797158, 0.82788, 2.81),
  ('keyboard', 'z_min', 0.82788, 0.839464, 0.6333),
  ('keyboard', 'z_min', 0.839464, 4, 0.001764);

-- chair_seat: 76 examples
UPDATE object_class SET prior = 0.02711 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.06, 0.4993)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.2808, 0.304)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4691, 0.04115)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7323, 0.1827)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7462, 0.1507)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7722, 0.1679)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.211, 0.3504)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 0.9667, 0.8971)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.014, 0.3523)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.473, 0.04138)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4661, 0.04126)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'area_m2', 0.002, 0.0307657, 0.004186),
  ('chair_seat', 'area_m2', 0.0307657, 0.0396078, 0.08627),
  ('chair_seat', 'area_m2', 0.0396078, 0.0509912, 0.161),
  ('chair_seat', 'area_m2', 0.0509912, 0.0599302, 0.1879),
  ('chair_seat', 'area_m2', 0.0599302, 0.0656461, 0.2046),
  ('chair_seat', 'area_m2', 0.0656461, 0.0845129, 0.2696),
  ('chair_seat', 'area_m2', 0.0845129, 0.0902064, 0.3651),
  ('chair_seat', 'area_m2', 0.0902064, 0.108802, 0.4856),
  ('chair_seat', 'area_m2', 0.108802, 0.117089, 0.599),
  ('chair_seat', 'area_m2', 0.117089, 0.13851, 0.7265),
  ('chair_seat', 'area_m2', 0.13851, 0.149411, 1.246),
  ('chair_seat', 'area_m2', 0.149411, 0.174043, 0.826),
  ('chair_seat', 'area_m2', 0.174043, 0.180329, 1.357),
  ('chair_seat', 'area_m2', 0.180329, 0.188391, 0.969),
  ('chair_seat', 'area_m2', 0.188391, 0.214856, 0.7814),
  ('chair_seat', 'area_m2', 0.214856, 0.232155, 0.5622),
  ('chair_seat', 'area_m2', 0.232155, 0.286248, 0.2693),
  ('chair_seat', 'area_m2', 0.286248, 0.298877, 0.0865),
  ('chair_seat', 'area_m2', 0.298877, 100, 0.001848);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'aspect', 1, 1.04288, 2.639),
  ('chair_seat', 'aspect', 1.04288, 1.06738, 4.154),
  ('chair_seat', 'aspect', 1.06738, 1.09109, 4.231),
  ('chair_seat', 'aspect', 1.09109, 1.14945, 2.143),
  ('chair_seat', 'aspect', 1.14945, 1.18053, 3.974),
  ('chair_seat', 'aspect', 1.18053, 1.31026, 1.155),
  ('chair_seat', 'aspect', 1.31026, 1.32122, 0.9353),
  ('chair_seat', 'aspect', 1.32122, 1.51867, 0.7732),
  ('chair_seat', 'aspect', 1.51867, 1.54851, 0.4703),
  ('chair_seat', 'aspect', 1.54851, 1.74563, 0.4379),
  ('chair_seat', 'aspect', 1.74563, 1.94927, 0.5581),
  ('chair_seat', 'aspect', 1.94927, 2.00651, 0.4996),
  ('chair_seat', 'aspect', 2.00651, 2.30637, 0.2816),
  ('chair_seat', 'aspect', 2.30637, 2.65105, 0.1532),
  ('chair_seat', 'aspect', 2.65105, 3.04723, 0.134),
  ('chair_seat', 'aspect', 3.04723, 3.50263, 0.1241),
  ('chair_seat', 'aspect', 3.50263, 100, 0.003598);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'height', -0.5, 0.218498, 0.01582),
  ('chair_seat', 'height', 0.218498, 0.255253, 3.766e-07),
  ('chair_seat', 'height', 0.255253, 0.292008, 3.097e-05),
  ('chair_seat', 'height', 0.292008, 0.328764, 0.001177),
  ('chair_seat', 'height', 0.328764, 0.365519, 0.02083),
  ('chair_seat', 'height', 0.365519, 0.402274, 0.3565),
  ('chair_seat', 'height', 0.402274, 0.429975, 4.324),
  ('chair_seat', 'height', 0.429975, 0.439029, 7.988),
  ('chair_seat', 'height', 0.439029, 0.454387, 8.104),
  ('chair_seat', 'height', 0.454387, 0.470078, 8.315),
  ('chair_seat', 'height', 0.470078, 0.475784, 9.119),
  ('chair_seat', 'height', 0.475784, 0.490664, 9.525),
  ('chair_seat', 'height', 0.490664, 0.503369, 9.948),
  ('chair_seat', 'height', 0.503369, 0.509891, 9.547),
  ('chair_seat', 'height', 0.509891, 0.549295, 3.439),
  ('chair_seat', 'height', 0.549295, 4, 0.002825);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'length', 0.03, 0.257349, 0.002276),
  ('chair_seat', 'length', 0.257349, 0.265532, 0.2104),
  ('chair_seat', 'length', 0.265532, 0.291625, 0.2257),
  ('chair_seat', 'length', 0.291625, 0.330467, 0.1223),
  ('chair_seat', 'length', 0.330467, 0.374482, 0.1023),
  ('chair_seat', 'length', 0.374482, 0.421455, 0.686),
  ('chair_seat', 'length', 0.421455, 0.442766, 1.893),
  ('chair_seat', 'length', 0.442766, 0.468878, 2.251),
  ('chair_seat', 'length', 0.468878, 0.480879, 4.005),
  ('chair_seat', 'length', 0.480879, 0.49012, 4.676),
  ('chair_seat', 'length', 0.49012, 0.501332, 3.886),
  ('chair_seat', 'length', 0.501332, 0.533483, 2.086),
  ('chair_seat', 'length', 0.533483, 0.544927, 2.335),
  ('chair_seat', 'length', 0.544927, 0.554028, 2.475),
  ('chair_seat', 'length', 0.554028, 0.617506, 0.7289),
  ('chair_seat', 'length', 0.617506, 0.699752, 0.1736),
  ('chair_seat', 'length', 0.699752, 0.78019, 0.2318),
  ('chair_seat', 'length', 0.78019, 0.792952, 0.2557),
  ('chair_seat', 'length', 0.792952, 30, 0.002026);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'rectangularity', 0, 0.34046, 0.02686),
  ('chair_seat', 'rectangularity', 0.34046, 0.354945, 0.2186),
  ('chair_seat', 'rectangularity', 0.354945, 0.413263, 0.3155),
  ('chair_seat', 'rectangularity', 0.413263, 0.486066, 0.3993),
  ('chair_seat', 'rectangularity', 0.486066, 0.558869, 0.6088),
  ('chair_seat', 'rectangularity', 0.558869, 0.57457, 1.651),
  ('chair_seat', 'rectangularity', 0.57457, 0.624984, 1.842),
  ('chair_seat', 'rectangularity', 0.624984, 0.663076, 2.35),
  ('chair_seat', 'rectangularity', 0.663076, 0.704474, 2.066),
  ('chair_seat', 'rectangularity', 0.704474, 0.766278, 1.202),
  ('chair_seat', 'rectangularity', 0.766278, 0.777277, 2.346),
  ('chair_seat', 'rectangularity', 0.777277, 0.801514, 2.745),
  ('chair_seat', 'rectangularity', 0.801514, 0.844922, 2.94),
  ('chair_seat', 'rectangularity', 0.844922, 0.884529, 2.427),
  ('chair_seat', 'rectangularity', 0.884529, 0.915867, 3.034),
  ('chair_seat', 'rectangularity', 0.915867, 0.971016, 1.804),
  ('chair_seat', 'rectangularity', 0.971016, 1, 0.5903);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_length', 0.01, 0.244422, 0.002226),
  ('chair_seat', 'spread_length', 0.244422, 0.27061, 0.1525),
  ('chair_seat', 'spread_length', 0.27061, 0.299604, 0.1966),
  ('chair_seat', 'spread_length', 0.299604, 0.331704, 0.1821),
  ('chair_seat', 'spread_length', 0.331704, 0.367243, 0.1993),
  ('chair_seat', 'spread_length', 0.367243, 0.405742, 0.4706),
  ('chair_seat', 'spread_length', 0.405742, 0.439451, 1.586),
  ('chair_seat', 'spread_length', 0.439451, 0.448207, 3.759),
  ('chair_seat', 'spread_length', 0.448207, 0.466141, 3.537),
  ('chair_seat', 'spread_length', 0.466141, 0.477284, 3.619),
  ('chair_seat', 'spread_length', 0.477284, 0.488836, 3.374),
  ('chair_seat', 'spread_length', 0.488836, 0.498383, 2.346),
  ('chair_seat', 'spread_length', 0.498383, 0.520263, 2.129),
  ('chair_seat', 'spread_length', 0.520263, 0.544732, 2.276),
  ('chair_seat', 'spread_length', 0.544732, 0.551781, 2.218),
  ('chair_seat', 'spread_length', 0.551781, 0.592764, 1.075),
  ('chair_seat', 'spread_length', 0.592764, 0.6109, 0.2904),
  ('chair_seat', 'spread_length', 0.6109, 40, 0.002436);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_width', 0.003, 0.122206, 0.003726),
  ('chair_seat', 'spread_width', 0.122206, 0.128228, 0.1902),
  ('chair_seat', 'spread_width', 0.128228, 0.141686, 0.2696),
  ('chair_seat', 'spread_width', 0.141686, 0.16427, 0.3236),
  ('chair_seat', 'spread_width', 0.16427, 0.168979, 0.3125),
  ('chair_seat', 'spread_width', 0.168979, 0.190455, 0.2966),
  ('chair_seat', 'spread_width', 0.190455, 0.220813, 0.4205),
  ('chair_seat', 'spread_width', 0.220813, 0.22355, 0.5407),
  ('chair_seat', 'spread_width', 0.22355, 0.25601, 0.484),
  ('chair_seat', 'spread_width', 0.25601, 0.296818, 0.4736),
  ('chair_seat', 'spread_width', 0.296818, 0.32878, 1.161),
  ('chair_seat', 'spread_width', 0.32878, 0.34413, 1.982),
  ('chair_seat', 'spread_width', 0.34413, 0.365681, 1.796),
  ('chair_seat', 'spread_width', 0.365681, 0.390478, 1.642),
  ('chair_seat', 'spread_width', 0.390478, 0.398984, 2.279),
  ('chair_seat', 'spread_width', 0.398984, 0.409039, 1.783),
  ('chair_seat', 'spread_width', 0.409039, 0.441326, 1.253),
  ('chair_seat', 'spread_width', 0.441326, 0.462581, 0.5065),
  ('chair_seat', 'spread_width', 0.462581, 20, 0.003968);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'tilt_deg', 0, 0.224465, 0.6107),
  ('chair_seat', 'tilt_deg', 0.224465, 0.357423, 0.6882),
  ('chair_seat', 'tilt_deg', 0.357423, 0.498603, 0.7216),
  ('chair_seat', 'tilt_deg', 0.498603, 0.775566, 0.6656),
  ('chair_seat', 'tilt_deg', 0.775566, 0.972657, 0.5095),
  ('chair_seat', 'tilt_deg', 0.972657, 1.18687, 0.3826),
  ('chair_seat', 'tilt_deg', 1.18687, 1.33608, 0.3073),
  ('chair_seat', 'tilt_deg', 1.33608, 1.7803, 0.2316),
  ('chair_seat', 'tilt_deg', 1.7803, 1.96538, 0.2093),
  ('chair_seat', 'tilt_deg', 1.96538, 2.37373, 0.1468),
  ('chair_seat', 'tilt_deg', 2.37373, 2.96717, 0.04515),
  ('chair_seat', 'tilt_deg', 2.96717, 3.5606, 0.009506),
  ('chair_seat', 'tilt_deg', 3.5606, 4.15403, 0.0007308),
  ('chair_seat', 'tilt_deg', 4.15403, 4.74747, 0.01104),
  ('chair_seat', 'tilt_deg', 4.74747, 5.3409, 0.01313),
  ('chair_seat', 'tilt_deg', 5.3409, 90, 9.735e-05);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'width', 0.01, 0.133859, 0.004882),
  ('chair_seat', 'width', 0.133859, 0.137188, 0.1491),
  ('chair_seat', 'width', 0.137188, 0.157624, 0.1805),
  ('chair_seat', 'width', 0.157624, 0.18561, 0.1834),
  ('chair_seat', 'width', 0.18561, 0.217397, 0.2812),
  ('chair_seat', 'width', 0.217397, 0.257369, 0.401),
  ('chair_seat', 'width', 0.257369, 0.29968, 0.4016),
  ('chair_seat', 'width', 0.29968, 0.35687, 0.4486),
  ('chair_seat', 'width', 0.35687, 0.390675, 0.5292),
  ('chair_seat', 'width', 0.390675, 0.417819, 1.726),
  ('chair_seat', 'width', 0.417819, 0.429257, 3.108),
  ('chair_seat', 'width', 0.429257, 0.442571, 3.284),
  ('chair_seat', 'width', 0.442571, 0.452422, 3.624),
  ('chair_seat', 'width', 0.452422, 0.480365, 2.034),
  ('chair_seat', 'width', 0.480365, 0.49484, 1.148),
  ('chair_seat', 'width', 0.49484, 0.563358, 0.5295),
  ('chair_seat', 'width', 0.563358, 0.582696, 0.1904),
  ('chair_seat', 'width', 0.582696, 12, 0.005987);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_max', -0.5, 0.222333, 0.01573),
  ('chair_seat', 'z_max', 0.222333, 0.259706, 4.657e-07),
  ('chair_seat', 'z_max', 0.259706, 0.297079, 3.858e-05),
  ('chair_seat', 'z_max', 0.297079, 0.334452, 0.001453),
  ('chair_seat', 'z_max', 0.334452, 0.371824, 0.02509),
  ('chair_seat', 'z_max', 0.371824, 0.409197, 0.5134),
  ('chair_seat', 'z_max', 0.409197, 0.432509, 4.65),
  ('chair_seat', 'z_max', 0.432509, 0.441061, 7.701),
  ('chair_seat', 'z_max', 0.441061, 0.45751, 7.949),
  ('chair_seat', 'z_max', 0.45751, 0.474399, 7.999),
  ('chair_seat', 'z_max', 0.474399, 0.483943, 8.844),
  ('chair_seat', 'z_max', 0.483943, 0.495563, 9.838),
  ('chair_seat', 'z_max', 0.495563, 0.505678, 10.64),
  ('chair_seat', 'z_max', 0.505678, 0.51243, 10.13),
  ('chair_seat', 'z_max', 0.51243, 0.521315, 8.022),
  ('chair_seat', 'z_max', 0.521315, 0.558688, 1.875),
  ('chair_seat', 'z_max', 0.558688, 4, 0.003542);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_min', -0.5, 0.214171, 0.01591),
  ('chair_seat', 'z_min', 0.214171, 0.250836, 3.344e-07),
  ('chair_seat', 'z_min', 0.250836, 0.2875, 2.747e-05),
  ('chair_seat', 'z_min', 0.2875, 0.324164, 0.001051),
  ('chair_seat', 'z_min', 0.324164, 0.360829, 0.01886),
  ('chair_seat', 'z_min', 0.360829, 0.397493, 0.3047),
  ('chair_seat', 'z_min', 0.397493, 0.426859, 4.034),
  ('chair_seat', 'z_min', 0.426859, 0.434158, 8.079),
  ('chair_seat', 'z_min', 0.434158, 0.451886, 8.185),
  ('chair_seat', 'z_min', 0.451886, 0.465115, 8.386),
  ('chair_seat', 'z_min', 0.465115, 0.470822, 9.202),
  ('chair_seat', 'z_min', 0.470822, 0.487623, 9.401),
  ('chair_seat', 'z_min', 0.487623, 0.500563, 9.56),
  ('chair_seat', 'z_min', 0.500563, 0.507486, 9.341),
  ('chair_seat', 'z_min', 0.507486, 0.535699, 4.608),
  ('chair_seat', 'z_min', 0.535699, 0.544151, 0.8496),
  ('chair_seat', 'z_min', 0.544151, 4, 0.002096);

-- chair_back: 75 examples
UPDATE object_class SET prior = 0.02676 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.674, 0.525)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3483, 0.2456)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8276, 0.08023)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5335, 0.234)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7951, 0.1453)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6647, 0.2154)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.084, 0.3452)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.92, 3.767)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.8891, 0.2649)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.044, 0.09145)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4734, 0.1314)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'area_m2', 0.002, 0.0354546, 0.004025),
  ('chair_back', 'area_m2', 0.0354546, 0.0476755, 0.04071),
  ('chair_back', 'area_m2', 0.0476755, 0.0641087, 0.1021),
  ('chair_back', 'area_m2', 0.0641087, 0.0854458, 0.188),
  ('chair_back', 'area_m2', 0.0854458, 0.115921, 0.1996),
  ('chair_back', 'area_m2', 0.115921, 0.155487, 0.2653),
  ('chair_back', 'area_m2', 0.155487, 0.177845, 0.7401),
  ('chair_back', 'area_m2', 0.177845, 0.204931, 0.7892),
  ('chair_back', 'area_m2', 0.204931, 0.209607, 0.927),
  ('chair_back', 'area_m2', 0.209607, 0.228237, 1.105),
  ('chair_back', 'area_m2', 0.228237, 0.241914, 1.529),
  ('chair_back', 'area_m2', 0.241914, 0.267039, 1.173),
  ('chair_back', 'area_m2', 0.267039, 0.281857, 0.9596),
  ('chair_back', 'area_m2', 0.281857, 0.295569, 0.9105),
  ('chair_back', 'area_m2', 0.295569, 0.37901, 0.3155),
  ('chair_back', 'area_m2', 0.37901, 0.509651, 0.1115),
  ('chair_back', 'area_m2', 0.509651, 100, 0.002944);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'aspect', 1, 1.06242, 1.721),
  ('chair_back', 'aspect', 1.06242, 1.11713, 2.282),
  ('chair_back', 'aspect', 1.11713, 1.2029, 1.462),
  ('chair_back', 'aspect', 1.2029, 1.25033, 0.9382),
  ('chair_back', 'aspect', 1.25033, 1.32491, 1.19),
  ('chair_back', 'aspect', 1.32491, 1.3981, 1.152),
  ('chair_back', 'aspect', 1.3981, 1.44454, 1.785),
  ('chair_back', 'aspect', 1.44454, 1.56333, 1.141),
  ('chair_back', 'aspect', 1.56333, 1.61764, 1.14),
  ('chair_back', 'aspect', 1.61764, 1.73809, 1.465),
  ('chair_back', 'aspect', 1.73809, 1.95468, 0.8272),
  ('chair_back', 'aspect', 1.95468, 2.18569, 0.5769),
  ('chair_back', 'aspect', 2.18569, 2.444, 0.3008),
  ('chair_back', 'aspect', 2.444, 2.73283, 0.05254),
  ('chair_back', 'aspect', 2.73283, 100, 0.003379);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'height', -0.5, 0.629197, 0.009465),
  ('chair_back', 'height', 0.629197, 0.673466, 0.4321),
  ('chair_back', 'height', 0.673466, 0.717736, 1.017),
  ('chair_back', 'height', 0.717736, 0.732682, 2.547),
  ('chair_back', 'height', 0.732682, 0.761447, 3.647),
  ('chair_back', 'height', 0.761447, 0.797734, 3.534),
  ('chair_back', 'height', 0.797734, 0.806275, 6.075),
  ('chair_back', 'height', 0.806275, 0.812182, 6.46),
  ('chair_back', 'height', 0.812182, 0.830566, 5.406),
  ('chair_back', 'height', 0.830566, 0.850545, 4.418),
  ('chair_back', 'height', 0.850545, 0.857482, 5.391),
  ('chair_back', 'height', 0.857482, 0.883947, 4.438),
  ('chair_back', 'height', 0.883947, 0.894814, 2.755),
  ('chair_back', 'height', 0.894814, 0.932975, 2.159),
  ('chair_back', 'height', 0.932975, 0.939084, 1.968),
  ('chair_back', 'height', 0.939084, 0.983353, 1.306),
  ('chair_back', 'height', 0.983353, 1.02489, 0.6555),
  ('chair_back', 'height', 1.02489, 4, 0.004036);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'length', 0.03, 0.333593, 0.004509),
  ('chair_back', 'length', 0.333593, 0.380437, 0.1915),
  ('chair_back', 'length', 0.380437, 0.433859, 0.4798),
  ('chair_back', 'length', 0.433859, 0.491283, 0.9734),
  ('chair_back', 'length', 0.491283, 0.528792, 1.383),
  ('chair_back', 'length', 0.528792, 0.56161, 2.098),
  ('chair_back', 'length', 0.56161, 0.593234, 1.725),
  ('chair_back', 'length', 0.593234, 0.643495, 1.16),
  ('chair_back', 'length', 0.643495, 0.718034, 1.309),
  ('chair_back', 'length', 0.718034, 0.733856, 1.901),
  ('chair_back', 'length', 0.733856, 0.767262, 1.436),
  ('chair_back', 'length', 0.767262, 0.836905, 0.7947),
  ('chair_back', 'length', 0.836905, 0.954425, 0.1752),
  ('chair_back', 'length', 0.954425, 1.04743, 0.1059),
  ('chair_back', 'length', 1.04743, 1.08845, 0.1087),
  ('chair_back', 'length', 1.08845, 30, 0.002439);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'rectangularity', 0, 0.327384, 0.03541),
  ('chair_back', 'rectangularity', 0.327384, 0.402119, 0.1578),
  ('chair_back', 'rectangularity', 0.402119, 0.476854, 0.1604),
  ('chair_back', 'rectangularity', 0.476854, 0.551589, 0.3601),
  ('chair_back', 'rectangularity', 0.551589, 0.597615, 1.043),
  ('chair_back', 'rectangularity', 0.597615, 0.626324, 1.274),
  ('chair_back', 'rectangularity', 0.626324, 0.701059, 0.969),
  ('chair_back', 'rectangularity', 0.701059, 0.712502, 1.277),
  ('chair_back', 'rectangularity', 0.712502, 0.762912, 2.224),
  ('chair_back', 'rectangularity', 0.762912, 0.775795, 3.218),
  ('chair_back', 'rectangularity', 0.775795, 0.803093, 2.821),
  ('chair_back', 'rectangularity', 0.803093, 0.85053, 2.119),
  ('chair_back', 'rectangularity', 0.85053, 0.885477, 3.397),
  ('chair_back', 'rectangularity', 0.885477, 0.911745, 3.681),
  ('chair_back', 'rectangularity', 0.911745, 0.925265, 2.918),
  ('chair_back', 'rectangularity', 0.925265, 0.946267, 2.771),
  ('chair_back', 'rectangularity', 0.946267, 0.985413, 2.689),
  ('chair_back', 'rectangularity', 0.985413, 1, 1.142);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_length', 0.01, 0.259824, 0.002705),
  ('chair_back', 'spread_length', 0.259824, 0.296565, 0.1063),
  ('chair_back', 'spread_length', 0.296565, 0.338502, 0.1812),
  ('chair_back', 'spread_length', 0.338502, 0.386368, 0.2773),
  ('chair_back', 'spread_length', 0.386368, 0.43116, 0.5401),
  ('chair_back', 'spread_length', 0.43116, 0.441004, 1.575),
  ('chair_back', 'spread_length', 0.441004, 0.457403, 2.078),
  ('chair_back', 'spread_length', 0.457403, 0.468048, 2.982),
  ('chair_back', 'spread_length', 0.468048, 0.497949, 2.129),
  ('chair_back', 'spread_length', 0.497949, 0.542181, 1.477),
  ('chair_back', 'spread_length', 0.542181, 0.56799, 1.808),
  ('chair_back', 'spread_length', 0.56799, 0.608635, 1.565),
  ('chair_back', 'spread_length', 0.608635, 0.655788, 1.316),
  ('chair_back', 'spread_length', 0.655788, 0.669893, 0.971),
  ('chair_back', 'spread_length', 0.669893, 0.748521, 0.7776),
  ('chair_back', 'spread_length', 0.748521, 0.854368, 0.07204),
  ('chair_back', 'spread_length', 0.854368, 40, 0.00332);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_width', 0.003, 0.121219, 0.002834),
  ('chair_back', 'spread_width', 0.121219, 0.14479, 0.0955),
  ('chair_back', 'spread_width', 0.14479, 0.172945, 0.08818),
  ('chair_back', 'spread_width', 0.172945, 0.206574, 0.2738),
  ('chair_back', 'spread_width', 0.206574, 0.214271, 0.6584),
  ('chair_back', 'spread_width', 0.214271, 0.246743, 0.4757),
  ('chair_back', 'spread_width', 0.246743, 0.259268, 0.8035),
  ('chair_back', 'spread_width', 0.259268, 0.294723, 0.7334),
  ('chair_back', 'spread_width', 0.294723, 0.30739, 0.7105),
  ('chair_back', 'spread_width', 0.30739, 0.349912, 0.8998),
  ('chair_back', 'spread_width', 0.349912, 0.390976, 0.8619),
  ('chair_back', 'spread_width', 0.390976, 0.420486, 1.467),
  ('chair_back', 'spread_width', 0.420486, 0.46164, 1.459),
  ('chair_back', 'spread_width', 0.46164, 0.473853, 2.391),
  ('chair_back', 'spread_width', 0.473853, 0.50225, 1.301),
  ('chair_back', 'spread_width', 0.50225, 0.599913, 0.249),
  ('chair_back', 'spread_width', 0.599913, 20, 0.004474);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'tilt_deg', 0, 72.5167, 0.0001197),
  ('chair_back', 'tilt_deg', 72.5167, 72.7507, 0.007386),
  ('chair_back', 'tilt_deg', 72.7507, 74.2429, 0.01353),
  ('chair_back', 'tilt_deg', 74.2429, 75.9691, 0.04144),
  ('chair_back', 'tilt_deg', 75.9691, 77.6952, 0.05465),
  ('chair_back', 'tilt_deg', 77.6952, 78.0685, 0.115),
  ('chair_back', 'tilt_deg', 78.0685, 78.7653, 0.1208),
  ('chair_back', 'tilt_deg', 78.7653, 79.4214, 0.05732),
  ('chair_back', 'tilt_deg', 79.4214, 80.2755, 0.1057),
  ('chair_back', 'tilt_deg', 80.2755, 80.9245, 0.1471),
  ('chair_back', 'tilt_deg', 80.9245, 82.1784, 0.08131),
  ('chair_back', 'tilt_deg', 82.1784, 82.8737, 0.04389),
  ('chair_back', 'tilt_deg', 82.8737, 84.5272, 0.06342),
  ('chair_back', 'tilt_deg', 84.5272, 86.0954, 0.06153),
  ('chair_back', 'tilt_deg', 86.0954, 86.326, 0.07474),
  ('chair_back', 'tilt_deg', 86.326, 87.219, 0.07555),
  ('chair_back', 'tilt_deg', 87.219, 88.0522, 0.03462),
  ('chair_back', 'tilt_deg', 88.0522, 90, 0.002903);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'width', 0.01, 0.178362, 0.002636),
  ('chair_back', 'width', 0.178362, 0.208936, 0.1691),
  ('chair_back', 'width', 0.208936, 0.244752, 0.1656),
  ('chair_back', 'width', 0.244752, 0.286706, 0.3291),
  ('chair_back', 'width', 0.286706, 0.335853, 0.4551),
  ('chair_back', 'width', 0.335853, 0.362995, 0.607),
  ('chair_back', 'width', 0.362995, 0.393424, 0.5263),
  ('chair_back', 'width', 0.393424, 0.424449, 1.375),
  ('chair_back', 'width', 0.424449, 0.434116, 3.633),
  ('chair_back', 'width', 0.434116, 0.443723, 3.644),
  ('chair_back', 'width', 0.443723, 0.460864, 2.76),
  ('chair_back', 'width', 0.460864, 0.467518, 2.967),
  ('chair_back', 'width', 0.467518, 0.477025, 3.536),
  ('chair_back', 'width', 0.477025, 0.494975, 2.814),
  ('chair_back', 'width', 0.494975, 0.539865, 0.8324),
  ('chair_back', 'width', 0.539865, 0.632407, 0.2009),
  ('chair_back', 'width', 0.632407, 0.740813, 0.1262),
  ('chair_back', 'width', 0.740813, 12, 0.004879);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_max', -0.5, 0.800614, 0.007727),
  ('chair_back', 'z_max', 0.800614, 0.853131, 0.3619),
  ('chair_back', 'z_max', 0.853131, 0.905648, 0.622),
  ('chair_back', 'z_max', 0.905648, 0.936994, 1.573),
  ('chair_back', 'z_max', 0.936994, 0.958165, 3.24),
  ('chair_back', 'z_max', 0.958165, 0.967064, 3.869),
  ('chair_back', 'z_max', 0.967064, 1.0081, 3.193),
  ('chair_back', 'z_max', 1.0081, 1.02888, 4.436),
  ('chair_back', 'z_max', 1.02888, 1.05735, 3.816),
  ('chair_back', 'z_max', 1.05735, 1.0632, 3.816),
  ('chair_back', 'z_max', 1.0632, 1.08716, 4.028),
  ('chair_back', 'z_max', 1.08716, 1.11572, 3.89),
  ('chair_back', 'z_max', 1.11572, 1.15719, 2.711),
  ('chair_back', 'z_max', 1.15719, 1.16823, 2.648),
  ('chair_back', 'z_max', 1.16823, 1.22075, 1.136),
  ('chair_back', 'z_max', 1.22075, 1.26452, 0.2882),
  ('chair_back', 'z_max', 1.26452, 1.27327, 0.266),
  ('chair_back', 'z_max', 1.27327, 4, 0.002904);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_min', -0.5, 0.210248, 0.01901),
  ('chair_back', 'z_min', 0.210248, 0.280826, 0.2454),
  ('chair_back', 'z_min', 0.280826, 0.329875, 1.643),
  ('chair_back', 'z_min', 0.329875, 0.351405, 2.883),
  ('chair_back', 'z_min', 0.351405, 0.365698, 3.522),
  ('chair_back', 'z_min', 0.365698, 0.396703, 3.224),
  ('chair_back', 'z_min', 0.396703, 0.420038, 4.765),
  ('chair_back', 'z_min', 0.420038, 0.44584, 3.868),
  ('chair_back', 'z_min', 0.44584, 0.492563, 1.391),
  ('chair_back', 'z_min', 0.492563, 0.52825, 1.646),
  ('chair_back', 'z_min', 0.52825, 0.563142, 1.841),
  ('chair_back', 'z_min', 0.563142, 0.591328, 1.975),
  ('chair_back', 'z_min', 0.591328, 0.63372, 2.234),
  ('chair_back', 'z_min', 0.63372, 0.642212, 1.924),
  ('chair_back', 'z_min', 0.642212, 0.704299, 1.006),
  ('chair_back', 'z_min', 0.704299, 0.774878, 0.3439),
  ('chair_back', 'z_min', 0.774878, 0.823351, 0.2512),
  ('chair_back', 'z_min', 0.823351, 0.845457, 0.2008),
  ('chair_back', 'z_min', 0.845457, 4, 0.00226);

-- door: 35 examples
UPDATE object_class SET prior = 0.01245 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.3942, 0.4226)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.7742, 0.2852)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.174, 0.1252)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.6881, 0.1755)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8286, 0.1245)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4816, 0.2503)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.222, 0.3041)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.98, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.08871, 0.2858)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.106, 0.1813)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1242, 0.2426)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'door' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'area_m2', 0.002, 0.270478, 0.004334),
  ('door', 'area_m2', 0.270478, 0.352299, 0.0003558),
  ('door', 'area_m2', 0.352299, 0.458872, 0.002758),
  ('door', 'area_m2', 0.458872, 0.597683, 0.07293),
  ('door', 'area_m2', 0.597683, 0.778485, 0.1462),
  ('door', 'area_m2', 0.778485, 1.01398, 0.2042),
  ('door', 'area_m2', 1.01398, 1.03147, 0.3068),
  ('door', 'area_m2', 1.03147, 1.30214, 0.536),
  ('door', 'area_m2', 1.30214, 1.32072, 0.8755),
  ('door', 'area_m2', 1.32072, 1.53917, 0.766),
  ('door', 'area_m2', 1.53917, 1.63019, 1.56),
  ('door', 'area_m2', 1.63019, 1.72024, 1.67),
  ('door', 'area_m2', 1.72024, 1.7683, 2.419),
  ('door', 'area_m2', 1.7683, 1.89283, 1.826),
  ('door', 'area_m2', 1.89283, 1.99578, 1.502),
  ('door', 'area_m2', 1.99578, 2.24062, 0.7238),
  ('door', 'area_m2', 2.24062, 2.91843, 0.1636),
  ('door', 'area_m2', 2.91843, 100, 0.008302);
DELETE FROM class_density WHERE class = 'door' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'aspect', 1, 1.06303, 0.1968),
  ('door', 'aspect', 1.06303, 1.29278, 0.17),
  ('door', 'aspect', 1.29278, 1.57218, 0.2823),
  ('door', 'aspect', 1.57218, 1.69398, 0.5857),
  ('door', 'aspect', 1.69398, 1.86257, 1.081),
  ('door', 'aspect', 1.86257, 1.91197, 1.062),
  ('door', 'aspect', 1.91197, 2.03612, 1.347),
  ('door', 'aspect', 2.03612, 2.22301, 1.269),
  ('door', 'aspect', 2.22301, 2.29081, 2.946),
  ('door', 'aspect', 2.29081, 2.32519, 4.019),
  ('door', 'aspect', 2.32519, 2.42349, 2.923),
  ('door', 'aspect', 2.42349, 2.54618, 2.124),
  ('door', 'aspect', 2.54618, 2.82772, 0.6423),
  ('door', 'aspect', 2.82772, 3.43887, 0.1652),
  ('door', 'aspect', 3.43887, 4.18209, 0.1323),
  ('door', 'aspect', 4.18209, 5.08595, 0.03947),
  ('door', 'aspect', 5.08595, 6.18515, 0.004609),
  ('door', 'aspect', 6.18515, 100, 0.007457);
DELETE FROM class_density WHERE class = 'door' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'height', -0.5, 1.00562, 0.01611),
  ('door', 'height', 1.00562, 1.02654, 1.102),
  ('door', 'height', 1.02654, 1.05187, 4.312),
  ('door', 'height', 1.05187, 1.05964, 6.741),
  ('door', 'height', 1.05964, 1.08269, 4.445),
  ('door', 'height', 1.08269, 1.10454, 2.379),
  ('door', 'height', 1.10454, 1.11822, 3.932),
  ('door', 'height', 1.11822, 1.14175, 4.125),
  ('door', 'height', 1.14175, 1.154, 2.613),
  ('door', 'height', 1.154, 1.20347, 1.836),
  ('door', 'height', 1.20347, 1.21708, 1.709),
  ('door', 'height', 1.21708, 1.25293, 1.609),
  ('door', 'height', 1.25293, 1.29634, 1.564),
  ('door', 'height', 1.29634, 1.35143, 1.7),
  ('door', 'height', 1.35143, 1.40131, 1.426),
  ('door', 'height', 1.40131, 1.43862, 0.8143),
  ('door', 'height', 1.43862, 1.45077, 0.4494),
  ('door', 'height', 1.45077, 4, 0.005305);
DELETE FROM class_density WHERE class = 'door' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'length', 0.03, 0.957296, 0.006145),
  ('door', 'length', 0.957296, 1.06779, 0.0004212),
  ('door', 'length', 1.06779, 1.19105, 0.003582),
  ('door', 'length', 1.19105, 1.32853, 0.02136),
  ('door', 'length', 1.32853, 1.48187, 0.1958),
  ('door', 'length', 1.48187, 1.6059, 0.7638),
  ('door', 'length', 1.6059, 1.65292, 1.327),
  ('door', 'length', 1.65292, 1.84371, 0.9982),
  ('door', 'length', 1.84371, 2.02549, 1.583),
  ('door', 'length', 2.02549, 2.04719, 4.963),
  ('door', 'length', 2.04719, 2.09556, 4.821),
  ('door', 'length', 2.09556, 2.148, 3.623),
  ('door', 'length', 2.148, 2.25512, 2.47),
  ('door', 'length', 2.25512, 2.29391, 3.448),
  ('door', 'length', 2.29391, 2.54771, 1.258),
  ('door', 'length', 2.54771, 30, 0.01256);
DELETE FROM class_density WHERE class = 'door' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'rectangularity', 0, 0.525139, 0.02551),
  ('door', 'rectangularity', 0.525139, 0.577862, 0.2485),
  ('door', 'rectangularity', 0.577862, 0.629376, 1.363),
  ('door', 'rectangularity', 0.629376, 0.683308, 1.238),
  ('door', 'rectangularity', 0.683308, 0.736031, 0.7574),
  ('door', 'rectangularity', 0.736031, 0.763955, 1.935),
  ('door', 'rectangularity', 0.763955, 0.788754, 3.673),
  ('door', 'rectangularity', 0.788754, 0.825517, 2.808),
  ('door', 'rectangularity', 0.825517, 0.841477, 2.67),
  ('door', 'rectangularity', 0.841477, 0.864512, 3.062),
  ('door', 'rectangularity', 0.864512, 0.889999, 3.705),
  ('door', 'rectangularity', 0.889999, 0.946924, 1.833),
  ('door', 'rectangularity', 0.946924, 0.953801, 3.954),
  ('door', 'rectangularity', 0.953801, 0.967396, 7.538),
  ('door', 'rectangularity', 0.967396, 0.976719, 8.671),
  ('door', 'rectangularity', 0.976719, 1, 1.11);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_length', 0.01, 0.803428, 0.003238),
  ('door', 'spread_length', 0.803428, 0.895518, 0.1422),
  ('door', 'spread_length', 0.895518, 0.998163, 0.1974),
  ('door', 'spread_length', 0.998163, 1.11257, 0.3944),
  ('door', 'spread_length', 1.11257, 1.1571, 0.5659),
  ('door', 'spread_length', 1.1571, 1.2401, 0.6495),
  ('door', 'spread_length', 1.2401, 1.34436, 0.8228),
  ('door', 'spread_length', 1.34436, 1.38224, 0.9124),
  ('door', 'spread_length', 1.38224, 1.54067, 0.8081),
  ('door', 'spread_length', 1.54067, 1.58638, 1.342),
  ('door', 'spread_length', 1.58638, 1.64433, 2.25),
  ('door', 'spread_length', 1.64433, 1.71727, 1.346),
  ('door', 'spread_length', 1.71727, 1.85079, 0.868),
  ('door', 'spread_length', 1.85079, 1.9141, 1.443),
  ('door', 'spread_length', 1.9141, 1.96366, 2.99),
  ('door', 'spread_length', 1.96366, 2.00678, 4.593),
  ('door', 'spread_length', 2.00678, 2.04951, 4.38),
  ('door', 'spread_length', 2.04951, 2.1335, 1.573),
  ('door', 'spread_length', 2.1335, 40, 0.01225);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_width', 0.003, 0.229025, 0.004909),
  ('door', 'spread_width', 0.229025, 0.277847, 0.0003036),
  ('door', 'spread_width', 0.277847, 0.337076, 0.002594),
  ('door', 'spread_width', 0.337076, 0.408931, 0.06849),
  ('door', 'spread_width', 0.408931, 0.496104, 0.2299),
  ('door', 'spread_width', 0.496104, 0.601859, 0.2563),
  ('door', 'spread_width', 0.601859, 0.654245, 0.2875),
  ('door', 'spread_width', 0.654245, 0.730158, 0.4759),
  ('door', 'spread_width', 0.730158, 0.786972, 1.238),
  ('door', 'spread_width', 0.786972, 0.811598, 3.036),
  ('door', 'spread_width', 0.811598, 0.821587, 3.394),
  ('door', 'spread_width', 0.821587, 0.864478, 2.693),
  ('door', 'spread_width', 0.864478, 0.885807, 2.554),
  ('door', 'spread_width', 0.885807, 0.938958, 2.32),
  ('door', 'spread_width', 0.938958, 0.95246, 2.888),
  ('door', 'spread_width', 0.95246, 1.07464, 0.7725),
  ('door', 'spread_width', 1.07464, 1.29861, 0.3839),
  ('door', 'spread_width', 1.29861, 20, 0.009234);
DELETE FROM class_density WHERE class = 'door' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'tilt_deg', 0, 89.2616, 0.0003111),
  ('door', 'tilt_deg', 89.2616, 89.4257, 0.2193),
  ('door', 'tilt_deg', 89.4257, 89.5898, 0.5407),
  ('door', 'tilt_deg', 89.5898, 89.7539, 1.295),
  ('door', 'tilt_deg', 89.7539, 90, 2.58);
DELETE FROM class_density WHERE class = 'door' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'width', 0.01, 0.272047, 0.006442),
  ('door', 'width', 0.272047, 0.336768, 0.0002676),
  ('door', 'width', 0.336768, 0.416887, 0.003274),
  ('door', 'width', 0.416887, 0.516067, 0.05146),
  ('door', 'width', 0.516067, 0.638841, 0.1697),
  ('door', 'width', 0.638841, 0.790825, 0.4484),
  ('door', 'width', 0.790825, 0.799077, 0.9527),
  ('door', 'width', 0.799077, 0.857944, 1.402),
  ('door', 'width', 0.857944, 0.887875, 2.818),
  ('door', 'width', 0.887875, 0.905493, 3.558),
  ('door', 'width', 0.905493, 0.944778, 2.785),
  ('door', 'width', 0.944778, 0.966717, 3.266),
  ('door', 'width', 0.966717, 0.978966, 3.07),
  ('door', 'width', 0.978966, 1.00189, 2.655),
  ('door', 'width', 1.00189, 1.14229, 0.8952),
  ('door', 'width', 1.14229, 1.21187, 0.6302),
  ('door', 'width', 1.21187, 1.50018, 0.3468),
  ('door', 'width', 1.50018, 1.85708, 0.06995),
  ('door', 'width', 1.85708, 12, 0.01179);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_max', -0.5, 1.50412, 0.006432),
  ('door', 'z_max', 1.50412, 1.61607, 0.1503),
  ('door', 'z_max', 1.61607, 1.72802, 0.1465),
  ('door', 'z_max', 1.72802, 1.83998, 0.2096),
  ('door', 'z_max', 1.83998, 1.95193, 0.4135),
  ('door', 'z_max', 1.95193, 1.99962, 0.9471),
  ('door', 'z_max', 1.99962, 2.02744, 3.366),
  ('door', 'z_max', 2.02744, 2.04533, 4.777),
  ('door', 'z_max', 2.04533, 2.06388, 3.523),
  ('door', 'z_max', 2.06388, 2.08456, 2.358),
  ('door', 'z_max', 2.08456, 2.12162, 2.695),
  ('door', 'z_max', 2.12162, 2.17583, 1.987),
  ('door', 'z_max', 2.17583, 2.25902, 1.336),
  ('door', 'z_max', 2.25902, 2.28779, 2.562),
  ('door', 'z_max', 2.28779, 2.39974, 1.061),
  ('door', 'z_max', 2.39974, 2.51169, 0.1396),
  ('door', 'z_max', 2.51169, 4, 0.01268);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_min', -0.5, -0.036529, 0.1439),
  ('door', 'z_min', -0.036529, -0.0156839, 3.745),
  ('door', 'z_min', -0.0156839, -0.0077261, 12),
  ('door', 'z_min', -0.0077261, -0.000796525, 16.03),
  ('door', 'z_min', -0.000796525, 0.00687724, 16.12),
  ('door', 'z_min', 0.00687724, 0.0623297, 3.491),
  ('door', 'z_min', 0.0623297, 0.158747, 0.4976),
  ('door', 'z_min', 0.158747, 0.260047, 0.3988),
  ('door', 'z_min', 0.260047, 0.358906, 0.5338),
  ('door', 'z_min', 0.358906, 0.457764, 0.6162),
  ('door', 'z_min', 0.457764, 0.50976, 0.4701),
  ('door', 'z_min', 0.50976, 0.556623, 0.6368),
  ('door', 'z_min', 0.556623, 0.655482, 0.2199),
  ('door', 'z_min', 0.655482, 0.754341, 0.3117),
  ('door', 'z_min', 0.754341, 0.853199, 0.008705),
  ('door', 'z_min', 0.853199, 4, 0.006869);

-- window: 48 examples
UPDATE object_class SET prior = 0.0171 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', 0.2087, 0.5948)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.3418, 0.3814)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.536, 0.1424)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.3363, 0.3074)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8933, 0.106)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.3695, 0.2631)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.03318, 0.4256)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.58, 0.5574)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.004928, 0.3417)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.151, 0.1924)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 0.9447, 0.1667)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'window' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'area_m2', 0.002, 0.201603, 0.003002),
  ('window', 'area_m2', 0.201603, 0.294778, 0.04039),
  ('window', 'area_m2', 0.294778, 0.431015, 0.06013),
  ('window', 'area_m2', 0.431015, 0.630217, 0.1397),
  ('window', 'area_m2', 0.630217, 0.726225, 0.2011),
  ('window', 'area_m2', 0.726225, 0.921484, 0.3033),
  ('window', 'area_m2', 0.921484, 0.961886, 1.419),
  ('window', 'area_m2', 0.961886, 1.00862, 1.622),
  ('window', 'area_m2', 1.00862, 1.0926, 1.12),
  ('window', 'area_m2', 1.0926, 1.34737, 0.5068),
  ('window', 'area_m2', 1.34737, 1.44643, 0.6695),
  ('window', 'area_m2', 1.44643, 1.52242, 1.4),
  ('window', 'area_m2', 1.52242, 1.78296, 0.6547),
  ('window', 'area_m2', 1.78296, 1.97008, 0.7897),
  ('window', 'area_m2', 1.97008, 2.01909, 0.9533),
  ('window', 'area_m2', 2.01909, 2.88058, 0.2013),
  ('window', 'area_m2', 2.88058, 4.2119, 0.07169),
  ('window', 'area_m2', 4.2119, 6.15851, 0.06232),
  ('window', 'area_m2', 6.15851, 100, 0.004747);
DELETE FROM class_density WHERE class = 'window' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'aspect', 1, 1.03729, 2.789),
  ('window', 'aspect', 1.03729, 1.06598, 3.555),
  ('window', 'aspect', 1.06598, 1.11605, 2.433),
  ('window', 'aspect', 1.11605, 1.18768, 1.67),
  ('window', 'aspect', 1.18768, 1.31967, 0.996),
  ('window', 'aspect', 1.31967, 1.39103, 1.941),
  ('window', 'aspect', 1.39103, 1.43472, 1.605),
  ('window', 'aspect', 1.43472, 1.62757, 0.6601),
  ('window', 'aspect', 1.62757, 1.7185, 0.6041),
  ('window', 'aspect', 1.7185, 2.05841, 0.4133),
  ('window', 'aspect', 2.05841, 2.46555, 0.1481),
  ('window', 'aspect', 2.46555, 2.61959, 0.15),
  ('window', 'aspect', 2.61959, 2.95323, 0.2164),
  ('window', 'aspect', 2.95323, 3.53737, 0.217),
  ('window', 'aspect', 3.53737, 4.23704, 0.09854),
  ('window', 'aspect', 4.23704, 5.07511, 0.01486),
  ('window', 'aspect', 5.07511, 100, 0.005503);
DELETE FROM class_density WHERE class = 'window' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'height', -0.5, 1.11439, 0.01051),
  ('window', 'height', 1.11439, 1.2121, 0.02032),
  ('window', 'height', 1.2121, 1.30981, 0.09976),
  ('window', 'height', 1.30981, 1.40752, 0.7749),
  ('window', 'height', 1.40752, 1.42579, 2.517),
  ('window', 'height', 1.42579, 1.44625, 4.367),
  ('window', 'height', 1.44625, 1.46424, 5.844),
  ('window', 'height', 1.46424, 1.47139, 6.237),
  ('window', 'height', 1.47139, 1.50523, 3.742),
  ('window', 'height', 1.50523, 1.51644, 1.943),
  ('window', 'height', 1.51644, 1.59148, 1.692),
  ('window', 'height', 1.59148, 1.60294, 2.361),
  ('window', 'height', 1.60294, 1.64866, 2.001),
  ('window', 'height', 1.64866, 1.67095, 3.585),
  ('window', 'height', 1.67095, 1.70066, 1.84),
  ('window', 'height', 1.70066, 1.79837, 0.3772),
  ('window', 'height', 1.79837, 1.89608, 0.1644),
  ('window', 'height', 1.89608, 1.99379, 0.17),
  ('window', 'height', 1.99379, 4, 0.006255);
DELETE FROM class_density WHERE class = 'window' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'length', 0.03, 0.896759, 0.00659),
  ('window', 'length', 0.896759, 0.92494, 0.285),
  ('window', 'length', 0.92494, 1.05748, 0.6988),
  ('window', 'length', 1.05748, 1.13739, 1.527),
  ('window', 'length', 1.13739, 1.25162, 1.137),
  ('window', 'length', 1.25162, 1.27299, 1.499),
  ('window', 'length', 1.27299, 1.32279, 1.888),
  ('window', 'length', 1.32279, 1.39191, 1.956),
  ('window', 'length', 1.39191, 1.48535, 1.831),
  ('window', 'length', 1.48535, 1.5167, 2.476),
  ('window', 'length', 1.5167, 1.53837, 1.803),
  ('window', 'length', 1.53837, 1.62179, 1.784),
  ('window', 'length', 1.62179, 1.80706, 0.7084),
  ('window', 'length', 1.80706, 2.15302, 0.1397),
  ('window', 'length', 2.15302, 2.5652, 0.06426),
  ('window', 'length', 2.5652, 3.0563, 0.02301),
  ('window', 'length', 3.0563, 3.64142, 0.07707),
  ('window', 'length', 3.64142, 4.33856, 0.1382),
  ('window', 'length', 4.33856, 30, 0.0068);
DELETE FROM class_density WHERE class = 'window' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'rectangularity', 0, 0.576398, 0.02151),
  ('window', 'rectangularity', 0.576398, 0.623465, 0.4486),
  ('window', 'rectangularity', 0.623465, 0.670532, 0.5314),
  ('window', 'rectangularity', 0.670532, 0.717599, 0.6323),
  ('window', 'rectangularity', 0.717599, 0.755707, 0.8154),
  ('window', 'rectangularity', 0.755707, 0.764666, 0.9673),
  ('window', 'rectangularity', 0.764666, 0.811732, 1.122),
  ('window', 'rectangularity', 0.811732, 0.841818, 2.067),
  ('window', 'rectangularity', 0.841818, 0.858799, 3.727),
  ('window', 'rectangularity', 0.858799, 0.87094, 3.611),
  ('window', 'rectangularity', 0.87094, 0.905866, 2.355),
  ('window', 'rectangularity', 0.905866, 0.934812, 2.508),
  ('window', 'rectangularity', 0.934812, 0.952933, 4.875),
  ('window', 'rectangularity', 0.952933, 0.969157, 8.261),
  ('window', 'rectangularity', 0.969157, 0.975304, 23.5),
  ('window', 'rectangularity', 0.975304, 0.985423, 9.704),
  ('window', 'rectangularity', 0.985423, 1, 2.057);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_length', 0.01, 0.786305, 0.002939),
  ('window', 'spread_length', 0.786305, 0.931542, 0.2276),
  ('window', 'spread_length', 0.931542, 1.1036, 0.2772),
  ('window', 'spread_length', 1.1036, 1.15299, 1.042),
  ('window', 'spread_length', 1.15299, 1.24113, 1.331),
  ('window', 'spread_length', 1.24113, 1.30745, 1.846),
  ('window', 'spread_length', 1.30745, 1.42123, 1.499),
  ('window', 'spread_length', 1.42123, 1.49297, 1.753),
  ('window', 'spread_length', 1.49297, 1.54895, 2.019),
  ('window', 'spread_length', 1.54895, 1.57154, 2.204),
  ('window', 'spread_length', 1.57154, 1.65192, 2.246),
  ('window', 'spread_length', 1.65192, 1.7332, 1.838),
  ('window', 'spread_length', 1.7332, 1.83505, 0.7956),
  ('window', 'spread_length', 1.83505, 2.17399, 0.2144),
  ('window', 'spread_length', 2.17399, 2.57555, 0.09807),
  ('window', 'spread_length', 2.57555, 3.05127, 0.148),
  ('window', 'spread_length', 3.05127, 3.61487, 0.02495),
  ('window', 'spread_length', 3.61487, 40, 0.006734);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_width', 0.003, 0.191482, 0.003981),
  ('window', 'spread_width', 0.191482, 0.244059, 0.004749),
  ('window', 'spread_width', 0.244059, 0.311074, 0.06718),
  ('window', 'spread_width', 0.311074, 0.396488, 0.07761),
  ('window', 'spread_width', 0.396488, 0.505357, 0.09767),
  ('window', 'spread_width', 0.505357, 0.62129, 0.2556),
  ('window', 'spread_width', 0.62129, 0.644118, 0.3275),
  ('window', 'spread_width', 0.644118, 0.820981, 0.3572),
  ('window', 'spread_width', 0.820981, 0.885885, 0.6533),
  ('window', 'spread_width', 0.885885, 0.971835, 1.033),
  ('window', 'spread_width', 0.971835, 1.04641, 1.291),
  ('window', 'spread_width', 1.04641, 1.11224, 1.551),
  ('window', 'spread_width', 1.11224, 1.20413, 1.461),
  ('window', 'spread_width', 1.20413, 1.28056, 1.431),
  ('window', 'spread_width', 1.28056, 1.33373, 1.454),
  ('window', 'spread_width', 1.33373, 1.3676, 1.34),
  ('window', 'spread_width', 1.3676, 1.6554, 0.569),
  ('window', 'spread_width', 1.6554, 1.69995, 0.1988),
  ('window', 'spread_width', 1.69995, 20, 0.01057);
DELETE FROM class_density WHERE class = 'window' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'tilt_deg', 0, 87.703, 1.37e-05),
  ('window', 'tilt_deg', 87.703, 87.9582, 0.02897),
  ('window', 'tilt_deg', 87.9582, 88.2134, 0.08368),
  ('window', 'tilt_deg', 88.2134, 88.4686, 0.1432),
  ('window', 'tilt_deg', 88.4686, 88.6705, 0.1974),
  ('window', 'tilt_deg', 88.6705, 88.9791, 0.2395),
  ('window', 'tilt_deg', 88.9791, 89.1817, 0.2521),
  ('window', 'tilt_deg', 89.1817, 89.4895, 0.3586),
  ('window', 'tilt_deg', 89.4895, 89.6176, 0.6781),
  ('window', 'tilt_deg', 89.6176, 89.7448, 1.066),
  ('window', 'tilt_deg', 89.7448, 89.8627, 1.52),
  ('window', 'tilt_deg', 89.8627, 90, 1.869);
DELETE FROM class_density WHERE class = 'window' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'width', 0.01, 0.255661, 0.004732),
  ('window', 'width', 0.255661, 0.312988, 0.02212),
  ('window', 'width', 0.312988, 0.38317, 0.0575),
  ('window', 'width', 0.38317, 0.469088, 0.05891),
  ('window', 'width', 0.469088, 0.574272, 0.1197),
  ('window', 'width', 0.574272, 0.703042, 0.2144),
  ('window', 'width', 0.703042, 0.77334, 0.3121),
  ('window', 'width', 0.77334, 0.860685, 0.7517),
  ('window', 'width', 0.860685, 0.888016, 1.133),
  ('window', 'width', 0.888016, 0.952877, 1.386),
  ('window', 'width', 0.952877, 1.00314, 1.799),
  ('window', 'width', 1.00314, 1.05368, 1.615),
  ('window', 'width', 1.05368, 1.085, 1.32),
  ('window', 'width', 1.085, 1.19801, 1.061),
  ('window', 'width', 1.19801, 1.28088, 1.669),
  ('window', 'width', 1.28088, 1.31165, 2.745),
  ('window', 'width', 1.31165, 1.51244, 0.7801),
  ('window', 'width', 1.51244, 1.57919, 0.3859),
  ('window', 'width', 1.57919, 12, 0.01257);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_max', -0.5, 1.37181, 0.008906),
  ('window', 'z_max', 1.37181, 1.49323, 0.0004835),
  ('window', 'z_max', 1.49323, 1.61464, 0.006154),
  ('window', 'z_max', 1.61464, 1.73605, 0.06684),
  ('window', 'z_max', 1.73605, 1.85747, 0.1558),
  ('window', 'z_max', 1.85747, 1.95649, 0.8536),
  ('window', 'z_max', 1.95649, 1.97888, 2.063),
  ('window', 'z_max', 1.97888, 2.02432, 1.244),
  ('window', 'z_max', 2.02432, 2.08199, 2.007),
  ('window', 'z_max', 2.08199, 2.1003, 2.166),
  ('window', 'z_max', 2.1003, 2.1454, 1.783),
  ('window', 'z_max', 2.1454, 2.20685, 1.812),
  ('window', 'z_max', 2.20685, 2.22171, 1.402),
  ('window', 'z_max', 2.22171, 2.25712, 2.044),
  ('window', 'z_max', 2.25712, 2.2937, 2.595),
  ('window', 'z_max', 2.2937, 2.34313, 1.293),
  ('window', 'z_max', 2.34313, 2.37656, 1.611),
  ('window', 'z_max', 2.37656, 2.44965, 1.293),
  ('window', 'z_max', 2.44965, 2.46454, 0.3144),
  ('window', 'z_max', 2.46454, 4, 0.01042);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_min', -0.5, 0.76238, 0.02913),
  ('window', 'z_min', 0.76238, 0.824762, 1.584),
  ('window', 'z_min', 0.824762, 0.852601, 4.068),
  ('window', 'z_min', 0.852601, 0.862114, 3.952),
  ('window', 'z_min', 0.862114, 0.87153, 4.168),
  ('window', 'z_min', 0.87153, 0.910671, 3.825),
  ('window', 'z_min', 0.910671, 0.954212, 4.178),
  ('window', 'z_min', 0.954212, 0.961848, 4.678),
  ('window', 'z_min', 0.961848, 0.984462, 4.892),
  ('window', 'z_min', 0.984462, 1.06158, 1.056),
  ('window', 'z_min', 1.06158, 1.16132, 0.3871),
  ('window', 'z_min', 1.16132, 1.26105, 0.2063),
  ('window', 'z_min', 1.26105, 1.36078, 0.1045),
  ('window', 'z_min', 1.36078, 1.46052, 0.1185),
  ('window', 'z_min', 1.46052, 1.56025, 0.1034),
  ('window', 'z_min', 1.56025, 1.65998, 0.07376),
  ('window', 'z_min', 1.65998, 4, 0.006785);

-- whiteboard: 29 examples
UPDATE object_class SET prior = 0.01024 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.1998, 1.167)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4249, 0.2429)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.375, 0.2099)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.4816, 0.6032)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.7301, 0.1317)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.3233, 0.5867)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.189, 0.6066)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.57, 0.6471)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', 0.05447, 0.6331)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 2.012, 0.468)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.6502, 0.3906)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'area_m2', 0.002, 0.0415769, 0.00363),
  ('whiteboard', 'area_m2', 0.0415769, 0.0467433, 0.04744),
  ('whiteboard', 'area_m2', 0.0467433, 0.0781298, 0.05309),
  ('whiteboard', 'area_m2', 0.0781298, 0.146819, 0.02538),
  ('whiteboard', 'area_m2', 0.146819, 0.275897, 0.06788),
  ('whiteboard', 'area_m2', 0.275897, 0.317749, 0.1087),
  ('whiteboard', 'area_m2', 0.317749, 0.518456, 0.09465),
  ('whiteboard', 'area_m2', 0.518456, 0.823441, 0.2343),
  ('whiteboard', 'area_m2', 0.823441, 0.974265, 0.486),
  ('whiteboard', 'area_m2', 0.974265, 1.45305, 0.3679),
  ('whiteboard', 'area_m2', 1.45305, 1.56429, 0.8068),
  ('whiteboard', 'area_m2', 1.56429, 1.76236, 0.6789),
  ('whiteboard', 'area_m2', 1.76236, 2.08252, 0.5722),
  ('whiteboard', 'area_m2', 2.08252, 3.08631, 0.2801),
  ('whiteboard', 'area_m2', 3.08631, 3.44039, 0.1417),
  ('whiteboard', 'area_m2', 3.44039, 6.46506, 0.09377),
  ('whiteboard', 'area_m2', 6.46506, 10.8635, 0.09927),
  ('whiteboard', 'area_m2', 10.8635, 12.1489, 0.06906),
  ('whiteboard', 'area_m2', 12.1489, 100, 0.00877);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'aspect', 1, 1.08123, 0.681),
  ('whiteboard', 'aspect', 1.08123, 1.14984, 0.8874),
  ('whiteboard', 'aspect', 1.14984, 1.17048, 0.9232),
  ('whiteboard', 'aspect', 1.17048, 1.26345, 1.345),
  ('whiteboard', 'aspect', 1.26345, 1.29113, 3.318),
  ('whiteboard', 'aspect', 1.29113, 1.48122, 1.021),
  ('whiteboard', 'aspect', 1.48122, 1.59861, 1.544),
  ('whiteboard', 'aspect', 1.59861, 1.68117, 1.781),
  ('whiteboard', 'aspect', 1.68117, 1.75246, 2.473),
  ('whiteboard', 'aspect', 1.75246, 1.89718, 1.357),
  ('whiteboard', 'aspect', 1.89718, 2.16568, 0.5236),
  ('whiteboard', 'aspect', 2.16568, 2.45802, 0.2174),
  ('whiteboard', 'aspect', 2.45802, 2.78983, 0.1475),
  ('whiteboard', 'aspect', 2.78983, 3.15592, 0.1175),
  ('whiteboard', 'aspect', 3.15592, 100, 0.003786);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'height', -0.5, 0.918544, 0.009824),
  ('whiteboard', 'height', 0.918544, 0.9485, 0.4452),
  ('whiteboard', 'height', 0.9485, 1.00225, 0.7674),
  ('whiteboard', 'height', 1.00225, 1.03137, 0.9647),
  ('whiteboard', 'height', 1.03137, 1.08596, 0.8828),
  ('whiteboard', 'height', 1.08596, 1.16966, 0.67),
  ('whiteboard', 'height', 1.16966, 1.25337, 0.7442),
  ('whiteboard', 'height', 1.25337, 1.33512, 1.252),
  ('whiteboard', 'height', 1.33512, 1.42078, 1.214),
  ('whiteboard', 'height', 1.42078, 1.44584, 1.925),
  ('whiteboard', 'height', 1.44584, 1.4716, 2.283),
  ('whiteboard', 'height', 1.4716, 1.50448, 2.632),
  ('whiteboard', 'height', 1.50448, 1.54449, 2.935),
  ('whiteboard', 'height', 1.54449, 1.57439, 2.746),
  ('whiteboard', 'height', 1.57439, 1.58819, 2.325),
  ('whiteboard', 'height', 1.58819, 1.63023, 1.217),
  ('whiteboard', 'height', 1.63023, 1.67189, 0.6549),
  ('whiteboard', 'height', 1.67189, 4, 0.0115);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'length', 0.03, 0.293769, 0.005435),
  ('whiteboard', 'length', 0.293769, 0.315197, 0.07051),
  ('whiteboard', 'length', 0.315197, 0.40427, 0.08325),
  ('whiteboard', 'length', 0.40427, 0.556336, 0.06874),
  ('whiteboard', 'length', 0.556336, 0.7656, 0.09988),
  ('whiteboard', 'length', 0.7656, 1.05358, 0.1709),
  ('whiteboard', 'length', 1.05358, 1.10158, 0.5728),
  ('whiteboard', 'length', 1.10158, 1.18898, 1.071),
  ('whiteboard', 'length', 1.18898, 1.27475, 1.287),
  ('whiteboard', 'length', 1.27475, 1.44988, 0.5858),
  ('whiteboard', 'length', 1.44988, 1.60386, 0.5063),
  ('whiteboard', 'length', 1.60386, 1.74415, 0.9646),
  ('whiteboard', 'length', 1.74415, 1.99525, 0.767),
  ('whiteboard', 'length', 1.99525, 2.438, 0.5649),
  ('whiteboard', 'length', 2.438, 2.74576, 0.4971),
  ('whiteboard', 'length', 2.74576, 3.06553, 0.3828),
  ('whiteboard', 'length', 3.06553, 3.77857, 0.2616),
  ('whiteboard', 'length', 3.77857, 4.59908, 0.1884),
  ('whiteboard', 'length', 4.59908, 5.19987, 0.1401),
  ('whiteboard', 'length', 5.19987, 30, 0.01293);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'rectangularity', 0, 0.386938, 0.02751),
  ('whiteboard', 'rectangularity', 0.386938, 0.424486, 0.329),
  ('whiteboard', 'rectangularity', 0.424486, 0.451945, 0.4572),
  ('whiteboard', 'rectangularity', 0.451945, 0.516953, 0.5952),
  ('whiteboard', 'rectangularity', 0.516953, 0.564346, 0.8999),
  ('whiteboard', 'rectangularity', 0.564346, 0.581961, 1.255),
  ('whiteboard', 'rectangularity', 0.581961, 0.62831, 1.873),
  ('whiteboard', 'rectangularity', 0.62831, 0.646969, 2.355),
  ('whiteboard', 'rectangularity', 0.646969, 0.670884, 2.396),
  ('whiteboard', 'rectangularity', 0.670884, 0.711976, 2.051),
  ('whiteboard', 'rectangularity', 0.711976, 0.746902, 1.947),
  ('whiteboard', 'rectangularity', 0.746902, 0.776984, 2.325),
  ('whiteboard', 'rectangularity', 0.776984, 0.791812, 2.103),
  ('whiteboard', 'rectangularity', 0.791812, 0.808261, 5.681),
  ('whiteboard', 'rectangularity', 0.808261, 0.841992, 3.001),
  ('whiteboard', 'rectangularity', 0.841992, 0.865839, 3.485),
  ('whiteboard', 'rectangularity', 0.865839, 0.907, 2.342),
  ('whiteboard', 'rectangularity', 0.907, 0.942809, 0.5461),
  ('whiteboard', 'rectangularity', 0.942809, 0.972007, 0.4924),
  ('whiteboard', 'rectangularity', 0.972007, 1, 0.4078);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_length', 0.01, 0.249548, 0.0029),
  ('whiteboard', 'spread_length', 0.249548, 0.267179, 0.07856),
  ('whiteboard', 'spread_length', 0.267179, 0.339198, 0.09748),
  ('whiteboard', 'spread_length', 0.339198, 0.461056, 0.06418),
  ('whiteboard', 'spread_length', 0.461056, 0.626691, 0.09156),
  ('whiteboard', 'spread_length', 0.626691, 0.851832, 0.1844),
  ('whiteboard', 'spread_length', 0.851832, 0.891123, 0.2871),
  ('whiteboard', 'spread_length', 0.891123, 1.09231, 0.5812),
  ('whiteboard', 'spread_length', 1.09231, 1.15785, 1.119),
  ('whiteboard', 'spread_length', 1.15785, 1.27828, 1.086),
  ('whiteboard', 'spread_length', 1.27828, 1.52016, 0.5884),
  ('whiteboard', 'spread_length', 1.52016, 1.57382, 0.6442),
  ('whiteboard', 'spread_length', 1.57382, 1.70513, 1.093),
  ('whiteboard', 'spread_length', 1.70513, 1.9064, 0.8825),
  ('whiteboard', 'spread_length', 1.9064, 2.13922, 0.3635),
  ('whiteboard', 'spread_length', 2.13922, 2.87396, 0.2724),
  ('whiteboard', 'spread_length', 2.87396, 3.51623, 0.4001),
  ('whiteboard', 'spread_length', 3.51623, 3.95234, 0.2133),
  ('whiteboard', 'spread_length', 3.95234, 40, 0.006654);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_width', 0.003, 0.133193, 0.001674),
  ('whiteboard', 'spread_width', 0.133193, 0.157853, 0.1045),
  ('whiteboard', 'spread_width', 0.157853, 0.18311, 0.1185),
  ('whiteboard', 'spread_width', 0.18311, 0.251735, 0.04575),
  ('whiteboard', 'spread_width', 0.251735, 0.346078, 0.09323),
  ('whiteboard', 'spread_width', 0.346078, 0.393804, 0.202),
  ('whiteboard', 'spread_width', 0.393804, 0.475779, 0.2022),
  ('whiteboard', 'spread_width', 0.475779, 0.654089, 0.3622),
  ('whiteboard', 'spread_width', 0.654089, 0.80008, 0.5317),
  ('whiteboard', 'spread_width', 0.80008, 0.899225, 0.7077),
  ('whiteboard', 'spread_width', 0.899225, 0.97265, 1.365),
  ('whiteboard', 'spread_width', 0.97265, 1.07125, 1.076),
  ('whiteboard', 'spread_width', 1.07125, 1.23623, 1.012),
  ('whiteboard', 'spread_width', 1.23623, 1.38823, 0.3071),
  ('whiteboard', 'spread_width', 1.38823, 1.69954, 0.2933),
  ('whiteboard', 'spread_width', 1.69954, 1.98692, 0.2681),
  ('whiteboard', 'spread_width', 1.98692, 2.33648, 0.1949),
  ('whiteboard', 'spread_width', 2.33648, 20, 0.009454);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'tilt_deg', 0, 87.3714, 3.201e-05),
  ('whiteboard', 'tilt_deg', 87.3714, 87.6467, 0.03608),
  ('whiteboard', 'tilt_deg', 87.6467, 87.9555, 0.04816),
  ('whiteboard', 'tilt_deg', 87.9555, 88.2476, 0.09413),
  ('whiteboard', 'tilt_deg', 88.2476, 88.5396, 0.1797),
  ('whiteboard', 'tilt_deg', 88.5396, 88.8317, 0.1936),
  ('whiteboard', 'tilt_deg', 88.8317, 89.1238, 0.2273),
  ('whiteboard', 'tilt_deg', 89.1238, 89.4159, 0.3119),
  ('whiteboard', 'tilt_deg', 89.4159, 89.7079, 0.6854),
  ('whiteboard', 'tilt_deg', 89.7079, 90, 1.637);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'width', 0.01, 0.173216, 0.003524),
  ('whiteboard', 'width', 0.173216, 0.182616, 0.0901),
  ('whiteboard', 'width', 0.182616, 0.239938, 0.1052),
  ('whiteboard', 'width', 0.239938, 0.332363, 0.04748),
  ('whiteboard', 'width', 0.332363, 0.460388, 0.1182),
  ('whiteboard', 'width', 0.460388, 0.507593, 0.2252),
  ('whiteboard', 'width', 0.507593, 0.63773, 0.2554),
  ('whiteboard', 'width', 0.63773, 0.775743, 0.3414),
  ('whiteboard', 'width', 0.775743, 0.883383, 0.3011),
  ('whiteboard', 'width', 0.883383, 1.0084, 0.685),
  ('whiteboard', 'width', 1.0084, 1.11274, 1.006),
  ('whiteboard', 'width', 1.11274, 1.19243, 1.069),
  ('whiteboard', 'width', 1.19243, 1.33984, 1.01),
  ('whiteboard', 'width', 1.33984, 1.47096, 0.9175),
  ('whiteboard', 'width', 1.47096, 1.69502, 0.614),
  ('whiteboard', 'width', 1.69502, 1.87033, 0.2189),
  ('whiteboard', 'width', 1.87033, 2.34793, 0.1795),
  ('whiteboard', 'width', 2.34793, 2.93423, 0.2323),
  ('whiteboard', 'width', 2.93423, 3.25236, 0.2234),
  ('whiteboard', 'width', 3.25236, 12, 0.0191);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_max', -0.5, 0.962671, 0.006545),
  ('whiteboard', 'z_max', 0.962671, 1.04638, 0.1105),
  ('whiteboard', 'z_max', 1.04638, 1.19985, 0.1657),
  ('whiteboard', 'z_max', 1.19985, 1.43703, 0.2928),
  ('whiteboard', 'z_max', 1.43703, 1.52578, 0.4365),
  ('whiteboard', 'z_max', 1.52578, 1.67421, 0.4743),
  ('whiteboard', 'z_max', 1.67421, 1.87489, 0.5859),
  ('whiteboard', 'z_max', 1.87489, 1.91139, 0.7191),
  ('whiteboard', 'z_max', 1.91139, 1.9985, 1.09),
  ('whiteboard', 'z_max', 1.9985, 2.09755, 1.726),
  ('whiteboard', 'z_max', 2.09755, 2.14857, 1.485),
  ('whiteboard', 'z_max', 2.14857, 2.38575, 0.4824),
  ('whiteboard', 'z_max', 2.38575, 2.62293, 0.2189),
  ('whiteboard', 'z_max', 2.62293, 2.77654, 0.2056),
  ('whiteboard', 'z_max', 2.77654, 2.86011, 0.3104),
  ('whiteboard', 'z_max', 2.86011, 2.96356, 0.3243),
  ('whiteboard', 'z_max', 2.96356, 3.09729, 0.1926),
  ('whiteboard', 'z_max', 3.09729, 4, 0.009363);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_min', -0.5, -0.0648619, 0.02274),
  ('whiteboard', 'z_min', -0.0648619, -0.0324386, 0.5693),
  ('whiteboard', 'z_min', -0.0324386, -0.0109633, 3.375),
  ('whiteboard', 'z_min', -0.0109633, 0.0734798, 0.904),
  ('whiteboard', 'z_min', 0.0734798, 0.196638, 0.2379),
  ('whiteboard', 'z_min', 0.196638, 0.211821, 0.1638),
  ('whiteboard', 'z_min', 0.211821, 0.350163, 0.192),
  ('whiteboard', 'z_min', 0.350163, 0.488505, 0.2789),
  ('whiteboard', 'z_min', 0.488505, 0.626847, 0.5372),
  ('whiteboard', 'z_min', 0.626847, 0.687704, 0.7344),
  ('whiteboard', 'z_min', 0.687704, 0.765188, 0.8303),
  ('whiteboard', 'z_min', 0.765188, 0.806643, 1.157),
  ('whiteboard', 'z_min', 0.806643, 0.855759, 2.106),
  ('whiteboard', 'z_min', 0.855759, 0.882395, 2.616),
  ('whiteboard', 'z_min', 0.882395, 0.90353, 1.967),
  ('whiteboard', 'z_min', 0.90353, 0.932023, 1.645),
  ('whiteboard', 'z_min', 0.932023, 0.964743, 2.468),
  ('whiteboard', 'z_min', 0.964743, 1.04187, 1.075),
  ('whiteboard', 'z_min', 1.04187, 1.18021, 0.2153),
  ('whiteboard', 'z_min', 1.18021, 4, 0.01403);

-- shelf: 149 examples
UPDATE object_class SET prior = 0.05317 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.343, 0.6889)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 1.011, 0.4203)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9911, 0.4652)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', 0.03506, 0.4596)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6851, 0.1373)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.1607, 0.4702)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.178, 0.3221)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 53.25, 43.47)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -0.9778, 0.3028)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.363, 0.5959)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5869, 0.6065)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'area_m2', 0.002, 0.0356569, 0.004214),
  ('shelf', 'area_m2', 0.0356569, 0.0525977, 0.05678),
  ('shelf', 'area_m2', 0.0525977, 0.0775872, 0.05379),
  ('shelf', 'area_m2', 0.0775872, 0.113222, 0.1548),
  ('shelf', 'area_m2', 0.113222, 0.160507, 0.3294),
  ('shelf', 'area_m2', 0.160507, 0.168825, 0.2423),
  ('shelf', 'area_m2', 0.168825, 0.218792, 0.3687),
  ('shelf', 'area_m2', 0.218792, 0.249035, 0.6541),
  ('shelf', 'area_m2', 0.249035, 0.264303, 0.53),
  ('shelf', 'area_m2', 0.264303, 0.315566, 0.5953),
  ('shelf', 'area_m2', 0.315566, 0.354896, 0.9053),
  ('shelf', 'area_m2', 0.354896, 0.367353, 0.6906),
  ('shelf', 'area_m2', 0.367353, 0.423973, 0.6328),
  ('shelf', 'area_m2', 0.423973, 0.541885, 0.3494),
  ('shelf', 'area_m2', 0.541885, 0.580408, 0.3153),
  ('shelf', 'area_m2', 0.580408, 0.799338, 0.2583),
  ('shelf', 'area_m2', 0.799338, 1.17911, 0.06007),
  ('shelf', 'area_m2', 1.17911, 100, 0.001695);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'aspect', 1, 1.06377, 0.1863),
  ('shelf', 'aspect', 1.06377, 1.23089, 0.1822),
  ('shelf', 'aspect', 1.23089, 1.51509, 0.1889),
  ('shelf', 'aspect', 1.51509, 1.66639, 0.473),
  ('shelf', 'aspect', 1.66639, 1.86491, 0.525),
  ('shelf', 'aspect', 1.86491, 2.05331, 0.5198),
  ('shelf', 'aspect', 2.05331, 2.26889, 1.04),
  ('shelf', 'aspect', 2.26889, 2.6014, 0.7737),
  ('shelf', 'aspect', 2.6014, 2.82552, 0.77),
  ('shelf', 'aspect', 2.82552, 2.94651, 1.108),
  ('shelf', 'aspect', 2.94651, 3.26328, 1.091),
  ('shelf', 'aspect', 3.26328, 3.4779, 1.005),
  ('shelf', 'aspect', 3.4779, 3.87873, 0.5837),
  ('shelf', 'aspect', 3.87873, 4.28092, 0.4724),
  ('shelf', 'aspect', 4.28092, 4.90871, 0.3799),
  ('shelf', 'aspect', 4.90871, 5.26934, 0.474),
  ('shelf', 'aspect', 5.26934, 6.22045, 0.3952),
  ('shelf', 'aspect', 6.22045, 6.48598, 0.1474),
  ('shelf', 'aspect', 6.48598, 100, 0.002123);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'height', -0.5, 0.0024441, 0.02152),
  ('shelf', 'height', 0.0024441, 0.0671596, 0.09934),
  ('shelf', 'height', 0.0671596, 0.247167, 0.09932),
  ('shelf', 'height', 0.247167, 0.472935, 0.359),
  ('shelf', 'height', 0.472935, 0.491891, 1.002),
  ('shelf', 'height', 0.491891, 0.616204, 0.6752),
  ('shelf', 'height', 0.616204, 0.736614, 0.6231),
  ('shelf', 'height', 0.736614, 0.76547, 1.102),
  ('shelf', 'height', 0.76547, 0.919018, 0.825),
  ('shelf', 'height', 0.919018, 0.981337, 0.8974),
  ('shelf', 'height', 0.981337, 1.02697, 0.9093),
  ('shelf', 'height', 1.02697, 1.11152, 1.339),
  ('shelf', 'height', 1.11152, 1.22606, 0.9107),
  ('shelf', 'height', 1.22606, 1.47078, 0.3509),
  ('shelf', 'height', 1.47078, 1.63161, 0.2209),
  ('shelf', 'height', 1.63161, 1.71551, 0.2139),
  ('shelf', 'height', 1.71551, 1.96023, 0.1895),
  ('shelf', 'height', 1.96023, 2.15774, 0.1605),
  ('shelf', 'height', 2.15774, 2.20495, 0.1114),
  ('shelf', 'height', 2.20495, 4, 0.005441);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'length', 0.03, 0.272674, 0.004578),
  ('shelf', 'length', 0.272674, 0.347473, 0.05099),
  ('shelf', 'length', 0.347473, 0.442791, 0.05991),
  ('shelf', 'length', 0.442791, 0.564256, 0.2657),
  ('shelf', 'length', 0.564256, 0.71904, 0.4491),
  ('shelf', 'length', 0.71904, 0.883043, 0.6369),
  ('shelf', 'length', 0.883043, 0.916285, 0.6764),
  ('shelf', 'length', 0.916285, 0.974005, 1.262),
  ('shelf', 'length', 0.974005, 1.13396, 0.7115),
  ('shelf', 'length', 1.13396, 1.16764, 1.016),
  ('shelf', 'length', 1.16764, 1.30066, 0.8117),
  ('shelf', 'length', 1.30066, 1.48794, 0.7474),
  ('shelf', 'length', 1.48794, 1.87404, 0.5019),
  ('shelf', 'length', 1.87404, 2.25157, 0.5336),
  ('shelf', 'length', 2.25157, 2.41623, 0.1857),
  ('shelf', 'length', 2.41623, 30, 0.001549);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'rectangularity', 0, 0.346001, 0.0299),
  ('shelf', 'rectangularity', 0.346001, 0.412812, 0.3019),
  ('shelf', 'rectangularity', 0.412812, 0.479623, 0.6884),
  ('shelf', 'rectangularity', 0.479623, 0.50252, 1.5),
  ('shelf', 'rectangularity', 0.50252, 0.546434, 1.926),
  ('shelf', 'rectangularity', 0.546434, 0.55968, 1.874),
  ('shelf', 'rectangularity', 0.55968, 0.61233, 2.108),
  ('shelf', 'rectangularity', 0.61233, 0.680056, 1.572),
  ('shelf', 'rectangularity', 0.680056, 0.733018, 2.267),
  ('shelf', 'rectangularity', 0.733018, 0.746867, 2.994),
  ('shelf', 'rectangularity', 0.746867, 0.767904, 3.212),
  ('shelf', 'rectangularity', 0.767904, 0.803418, 3.158),
  ('shelf', 'rectangularity', 0.803418, 0.813678, 3.455),
  ('shelf', 'rectangularity', 0.813678, 0.847274, 2.3),
  ('shelf', 'rectangularity', 0.847274, 0.880489, 2.002),
  ('shelf', 'rectangularity', 0.880489, 0.9473, 0.4986),
  ('shelf', 'rectangularity', 0.9473, 1, 0.1609);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_length', 0.01, 0.248143, 0.003215),
  ('shelf', 'spread_length', 0.248143, 0.315634, 0.08012),
  ('shelf', 'spread_length', 0.315634, 0.401481, 0.1719),
  ('shelf', 'spread_length', 0.401481, 0.465585, 0.2497),
  ('shelf', 'spread_length', 0.465585, 0.510677, 0.2943),
  ('shelf', 'spread_length', 0.510677, 0.627415, 0.4527),
  ('shelf', 'spread_length', 0.627415, 0.649573, 1.063),
  ('shelf', 'spread_length', 0.649573, 0.682829, 1.28),
  ('shelf', 'spread_length', 0.682829, 0.766919, 1.033),
  ('shelf', 'spread_length', 0.766919, 0.826246, 0.4834),
  ('shelf', 'spread_length', 0.826246, 0.95235, 0.5075),
  ('shelf', 'spread_length', 0.95235, 1.05097, 0.7774),
  ('shelf', 'spread_length', 1.05097, 1.08751, 0.8971),
  ('shelf', 'spread_length', 1.08751, 1.24526, 0.802),
  ('shelf', 'spread_length', 1.24526, 1.33682, 0.6568),
  ('shelf', 'spread_length', 1.33682, 1.54098, 0.4988),
  ('shelf', 'spread_length', 1.54098, 1.70041, 0.4531),
  ('shelf', 'spread_length', 1.70041, 2.14143, 0.2383),
  ('shelf', 'spread_length', 2.14143, 40, 0.003363);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_width', 0.003, 0.12663, 0.003085),
  ('shelf', 'spread_width', 0.12663, 0.153682, 0.1018),
  ('shelf', 'spread_width', 0.153682, 0.186513, 0.2035),
  ('shelf', 'spread_width', 0.186513, 0.210033, 0.4147),
  ('shelf', 'spread_width', 0.210033, 0.226358, 0.5248),
  ('shelf', 'spread_width', 0.226358, 0.250594, 0.6757),
  ('shelf', 'spread_width', 0.250594, 0.274716, 0.9311),
  ('shelf', 'spread_width', 0.274716, 0.281308, 1.216),
  ('shelf', 'spread_width', 0.281308, 0.299414, 1.642),
  ('shelf', 'spread_width', 0.299414, 0.330527, 1.186),
  ('shelf', 'spread_width', 0.330527, 0.351899, 1.532),
  ('shelf', 'spread_width', 0.351899, 0.385838, 1.221),
  ('shelf', 'spread_width', 0.385838, 0.404629, 1.169),
  ('shelf', 'spread_width', 0.404629, 0.427412, 1.092),
  ('shelf', 'spread_width', 0.427412, 0.491071, 0.4438),
  ('shelf', 'spread_width', 0.491071, 0.595979, 0.1193),
  ('shelf', 'spread_width', 0.595979, 0.723299, 0.09238),
  ('shelf', 'spread_width', 0.723299, 20, 0.003486);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'tilt_deg', 0, 0.152267, 0.05871),
  ('shelf', 'tilt_deg', 0.152267, 0.901034, 0.1165),
  ('shelf', 'tilt_deg', 0.901034, 1.80044, 0.1232),
  ('shelf', 'tilt_deg', 1.80044, 2.77917, 0.1037),
  ('shelf', 'tilt_deg', 2.77917, 10, 0.01153),
  ('shelf', 'tilt_deg', 10, 20, 0.0006942),
  ('shelf', 'tilt_deg', 20, 30, 0.0007339),
  ('shelf', 'tilt_deg', 30, 40, 0.0007873),
  ('shelf', 'tilt_deg', 40, 50, 0.0008416),
  ('shelf', 'tilt_deg', 50, 60, 0.0008891),
  ('shelf', 'tilt_deg', 60, 70, 0.0009254),
  ('shelf', 'tilt_deg', 70, 80, 0.0009487),
  ('shelf', 'tilt_deg', 80, 89.2724, 0.00541),
  ('shelf', 'tilt_deg', 89.2724, 89.8063, 0.4529),
  ('shelf', 'tilt_deg', 89.8063, 90, 1.333);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'width', 0.01, 0.15053, 0.004027),
  ('shelf', 'width', 0.15053, 0.188148, 0.07637),
  ('shelf', 'width', 0.188148, 0.235168, 0.1234),
  ('shelf', 'width', 0.235168, 0.285433, 0.299),
  ('shelf', 'width', 0.285433, 0.293937, 0.6267),
  ('shelf', 'width', 0.293937, 0.320351, 1.116),
  ('shelf', 'width', 0.320351, 0.342315, 1.616),
  ('shelf', 'width', 0.342315, 0.360952, 2.158),
  ('shelf', 'width', 0.360952, 0.367394, 2.6),
  ('shelf', 'width', 0.367394, 0.384205, 1.472),
  ('shelf', 'width', 0.384205, 0.413713, 1.305),
  ('shelf', 'width', 0.413713, 0.437886, 2.036),
  ('shelf', 'width', 0.437886, 0.459208, 1.265),
  ('shelf', 'width', 0.459208, 0.489505, 0.708),
  ('shelf', 'width', 0.489505, 0.573968, 0.3646),
  ('shelf', 'width', 0.573968, 0.717406, 0.138),
  ('shelf', 'width', 0.717406, 0.89669, 0.0458),
  ('shelf', 'width', 0.89669, 1.12078, 0.05143),
  ('shelf', 'width', 1.12078, 12, 0.004515);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_max', -0.5, -0.0127988, 0.02231),
  ('shelf', 'z_max', -0.0127988, 0.0703132, 0.0678),
  ('shelf', 'z_max', 0.0703132, 0.249162, 0.06496),
  ('shelf', 'z_max', 0.249162, 0.489725, 0.3303),
  ('shelf', 'z_max', 0.489725, 0.511122, 0.6798),
  ('shelf', 'z_max', 0.511122, 0.773083, 0.3274),
  ('shelf', 'z_max', 0.773083, 0.823936, 0.2941),
  ('shelf', 'z_max', 0.823936, 1.03504, 0.2929),
  ('shelf', 'z_max', 1.03504, 1.15876, 0.4288),
  ('shelf', 'z_max', 1.15876, 1.297, 0.4869),
  ('shelf', 'z_max', 1.297, 1.39693, 0.4869),
  ('shelf', 'z_max', 1.39693, 1.55896, 0.6423),
  ('shelf', 'z_max', 1.55896, 1.69201, 0.8679),
  ('shelf', 'z_max', 1.69201, 1.82093, 0.753),
  ('shelf', 'z_max', 1.82093, 1.8511, 0.3647),
  ('shelf', 'z_max', 1.8511, 2.08289, 0.3296),
  ('shelf', 'z_max', 2.08289, 2.13538, 0.6096),
  ('shelf', 'z_max', 2.13538, 2.34485, 0.4788),
  ('shelf', 'z_max', 2.34485, 4, 0.006024);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_min', -0.5, -0.080084, 0.02294),
  ('shelf', 'z_min', -0.080084, -0.0237425, 0.4336),
  ('shelf', 'z_min', -0.0237425, -0.0061485, 4.717),
  ('shelf', 'z_min', -0.0061485, 0.0185899, 3.869),
  ('shelf', 'z_min', 0.0185899, 0.150015, 0.942),
  ('shelf', 'z_min', 0.150015, 0.172802, 0.359),
  ('shelf', 'z_min', 0.172802, 0.41276, 0.3649),
  ('shelf', 'z_min', 0.41276, 0.493303, 1.393),
  ('shelf', 'z_min', 0.493303, 0.678576, 0.5677),
  ('shelf', 'z_min', 0.678576, 0.70533, 0.4173),
  ('shelf', 'z_min', 0.70533, 0.86058, 0.6595),
  ('shelf', 'z_min', 0.86058, 0.931462, 0.4759),
  ('shelf', 'z_min', 0.931462, 1.18435, 0.193),
  ('shelf', 'z_min', 1.18435, 1.43724, 0.09963),
  ('shelf', 'z_min', 1.43724, 1.58987, 0.1439),
  ('shelf', 'z_min', 1.58987, 1.69012, 0.1761),
  ('shelf', 'z_min', 1.69012, 1.94301, 0.1711),
  ('shelf', 'z_min', 1.94301, 2.15349, 0.1338),
  ('shelf', 'z_min', 2.15349, 2.19589, 0.09793),
  ('shelf', 'z_min', 2.19589, 4, 0.007689);

-- cabinet: 225 examples
UPDATE object_class SET prior = 0.07935 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.9347, 0.9354)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6196, 0.4288)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7484, 0.3444)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.02025, 0.5067)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7175, 0.1329)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1586, 0.5105)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.8495, 0.5024)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 76.72, 31.67)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.6038, 0.4807)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.196, 0.5564)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2249, 0.3359)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'area_m2', 0.002, 0.0298115, 0.003738),
  ('cabinet', 'area_m2', 0.0298115, 0.0480519, 0.03748),
  ('cabinet', 'area_m2', 0.0480519, 0.0774529, 0.07457),
  ('cabinet', 'area_m2', 0.0774529, 0.119768, 0.1068),
  ('cabinet', 'area_m2', 0.119768, 0.124843, 0.1865),
  ('cabinet', 'area_m2', 0.124843, 0.19307, 0.2441),
  ('cabinet', 'area_m2', 0.19307, 0.20123, 0.3363),
  ('cabinet', 'area_m2', 0.20123, 0.306075, 0.2247),
  ('cabinet', 'area_m2', 0.306075, 0.324354, 0.3463),
  ('cabinet', 'area_m2', 0.324354, 0.374435, 0.7044),
  ('cabinet', 'area_m2', 0.374435, 0.459021, 0.4974),
  ('cabinet', 'area_m2', 0.459021, 0.522813, 0.2996),
  ('cabinet', 'area_m2', 0.522813, 0.649779, 0.3437),
  ('cabinet', 'area_m2', 0.649779, 0.842701, 0.3706),
  ('cabinet', 'area_m2', 0.842701, 0.894212, 0.2917),
  ('cabinet', 'area_m2', 0.894212, 1.2331, 0.3503),
  ('cabinet', 'area_m2', 1.2331, 1.35832, 0.2568),
  ('cabinet', 'area_m2', 1.35832, 2.18941, 0.1511),
  ('cabinet', 'area_m2', 2.18941, 100, 0.002118);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'aspect', 1, 1.11959, 1.033),
  ('cabinet', 'aspect', 1.11959, 1.21578, 0.9308),
  ('cabinet', 'aspect', 1.21578, 1.24794, 1.107),
  ('cabinet', 'aspect', 1.24794, 1.40817, 0.9069),
  ('cabinet', 'aspect', 1.40817, 1.47812, 0.557),
  ('cabinet', 'aspect', 1.47812, 1.61516, 0.915),
  ('cabinet', 'aspect', 1.61516, 1.79708, 0.6964),
  ('cabinet', 'aspect', 1.79708, 1.93223, 0.5605),
  ('cabinet', 'aspect', 1.93223, 2.18485, 0.7549),
  ('cabinet', 'aspect', 2.18485, 2.30816, 0.3574),
  ('cabinet', 'aspect', 2.30816, 2.6563, 0.7791),
  ('cabinet', 'aspect', 2.6563, 3.16044, 0.6223),
  ('cabinet', 'aspect', 3.16044, 3.22948, 0.5316),
  ('cabinet', 'aspect', 3.22948, 3.92635, 0.2648),
  ('cabinet', 'aspect', 3.92635, 4.77358, 0.135),
  ('cabinet', 'aspect', 4.77358, 5.80363, 0.06615),
  ('cabinet', 'aspect', 5.80363, 100, 0.00439);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'height', -0.5, 0.137546, 0.01035),
  ('cabinet', 'height', 0.137546, 0.2943, 0.513),
  ('cabinet', 'height', 0.2943, 0.396437, 1.331),
  ('cabinet', 'height', 0.396437, 0.451053, 0.6693),
  ('cabinet', 'height', 0.451053, 0.574252, 0.7465),
  ('cabinet', 'height', 0.574252, 0.607807, 2.297),
  ('cabinet', 'height', 0.607807, 0.638322, 0.7215),
  ('cabinet', 'height', 0.638322, 0.76456, 0.5792),
  ('cabinet', 'height', 0.76456, 0.847551, 0.4506),
  ('cabinet', 'height', 0.847551, 0.921314, 0.8502),
  ('cabinet', 'height', 0.921314, 0.950251, 1.473),
  ('cabinet', 'height', 0.950251, 1.04778, 1.154),
  ('cabinet', 'height', 1.04778, 1.07807, 0.9238),
  ('cabinet', 'height', 1.07807, 1.2166, 0.623),
  ('cabinet', 'height', 1.2166, 1.23482, 0.5971),
  ('cabinet', 'height', 1.23482, 1.39157, 0.4711),
  ('cabinet', 'height', 1.39157, 1.54833, 0.08768),
  ('cabinet', 'height', 1.54833, 4, 0.003343);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'length', 0.03, 0.257762, 0.004429),
  ('cabinet', 'length', 0.257762, 0.328886, 0.06025),
  ('cabinet', 'length', 0.328886, 0.419636, 0.09801),
  ('cabinet', 'length', 0.419636, 0.515704, 0.3232),
  ('cabinet', 'length', 0.515704, 0.535427, 0.4529),
  ('cabinet', 'length', 0.535427, 0.683168, 0.2768),
  ('cabinet', 'length', 0.683168, 0.723404, 0.4539),
  ('cabinet', 'length', 0.723404, 0.812874, 0.8895),
  ('cabinet', 'length', 0.812874, 0.871675, 1.063),
  ('cabinet', 'length', 0.871675, 0.976961, 0.4414),
  ('cabinet', 'length', 0.976961, 1.1122, 0.5881),
  ('cabinet', 'length', 1.1122, 1.16187, 0.6303),
  ('cabinet', 'length', 1.16187, 1.36762, 0.689),
  ('cabinet', 'length', 1.36762, 1.41909, 0.3765),
  ('cabinet', 'length', 1.41909, 1.6823, 0.5741),
  ('cabinet', 'length', 1.6823, 1.81066, 0.886),
  ('cabinet', 'length', 1.81066, 1.88757, 1.025),
  ('cabinet', 'length', 1.88757, 2.2478, 0.5807),
  ('cabinet', 'length', 2.2478, 2.31027, 0.1348),
  ('cabinet', 'length', 2.31027, 30, 0.002312);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'rectangularity', 0, 0.384737, 0.03074),
  ('cabinet', 'rectangularity', 0.384737, 0.45238, 0.3803),
  ('cabinet', 'rectangularity', 0.45238, 0.520023, 0.7063),
  ('cabinet', 'rectangularity', 0.520023, 0.537101, 1.161),
  ('cabinet', 'rectangularity', 0.537101, 0.587666, 1.282),
  ('cabinet', 'rectangularity', 0.587666, 0.617133, 1.825),
  ('cabinet', 'rectangularity', 0.617133, 0.655308, 1.833),
  ('cabinet', 'rectangularity', 0.655308, 0.671965, 2.485),
  ('cabinet', 'rectangularity', 0.671965, 0.700985, 3.485),
  ('cabinet', 'rectangularity', 0.700985, 0.722951, 2.919),
  ('cabinet', 'rectangularity', 0.722951, 0.740122, 3.319),
  ('cabinet', 'rectangularity', 0.740122, 0.787711, 2.241),
  ('cabinet', 'rectangularity', 0.787711, 0.819697, 3.551),
  ('cabinet', 'rectangularity', 0.819697, 0.858237, 2.348),
  ('cabinet', 'rectangularity', 0.858237, 0.869358, 1.807),
  ('cabinet', 'rectangularity', 0.869358, 0.92588, 0.9466),
  ('cabinet', 'rectangularity', 0.92588, 0.976725, 0.8481),
  ('cabinet', 'rectangularity', 0.976725, 0.993523, 0.6699),
  ('cabinet', 'rectangularity', 0.993523, 1, 0.6041);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_length', 0.01, 0.240762, 0.002806),
  ('cabinet', 'spread_length', 0.240762, 0.306226, 0.05152),
  ('cabinet', 'spread_length', 0.306226, 0.38949, 0.1872),
  ('cabinet', 'spread_length', 0.38949, 0.426815, 0.4773),
  ('cabinet', 'spread_length', 0.426815, 0.495394, 0.306),
  ('cabinet', 'spread_length', 0.495394, 0.589401, 0.4201),
  ('cabinet', 'spread_length', 0.589401, 0.630094, 0.998),
  ('cabinet', 'spread_length', 0.630094, 0.663422, 0.7862),
  ('cabinet', 'spread_length', 0.663422, 0.732782, 0.9503),
  ('cabinet', 'spread_length', 0.732782, 0.80142, 0.5114),
  ('cabinet', 'spread_length', 0.80142, 0.908753, 0.5476),
  ('cabinet', 'spread_length', 0.908753, 1.01933, 0.6253),
  ('cabinet', 'spread_length', 1.01933, 1.14289, 0.4822),
  ('cabinet', 'spread_length', 1.14289, 1.29649, 0.5914),
  ('cabinet', 'spread_length', 1.29649, 1.4414, 0.2976),
  ('cabinet', 'spread_length', 1.4414, 1.64901, 0.7277),
  ('cabinet', 'spread_length', 1.64901, 2.09739, 0.4844),
  ('cabinet', 'spread_length', 2.09739, 40, 0.002581);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_width', 0.003, 0.108179, 0.00215),
  ('cabinet', 'spread_width', 0.108179, 0.111872, 0.07762),
  ('cabinet', 'spread_width', 0.111872, 0.140256, 0.1267),
  ('cabinet', 'spread_width', 0.140256, 0.181844, 0.1276),
  ('cabinet', 'spread_width', 0.181844, 0.226685, 0.1993),
  ('cabinet', 'spread_width', 0.226685, 0.235764, 0.3182),
  ('cabinet', 'spread_width', 0.235764, 0.304606, 0.3819),
  ('cabinet', 'spread_width', 0.304606, 0.373029, 0.5437),
  ('cabinet', 'spread_width', 0.373029, 0.396308, 0.6479),
  ('cabinet', 'spread_width', 0.396308, 0.438407, 0.7817),
  ('cabinet', 'spread_width', 0.438407, 0.489267, 0.9304),
  ('cabinet', 'spread_width', 0.489267, 0.513819, 0.736),
  ('cabinet', 'spread_width', 0.513819, 0.557216, 0.9711),
  ('cabinet', 'spread_width', 0.557216, 0.604593, 1.208),
  ('cabinet', 'spread_width', 0.604593, 0.666175, 0.496),
  ('cabinet', 'spread_width', 0.666175, 0.782427, 0.4421),
  ('cabinet', 'spread_width', 0.782427, 0.863706, 0.7241),
  ('cabinet', 'spread_width', 0.863706, 1.11981, 0.1087),
  ('cabinet', 'spread_width', 1.11981, 20, 0.003752);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'tilt_deg', 0, 0.839916, 0.1282),
  ('cabinet', 'tilt_deg', 0.839916, 10, 0.003529),
  ('cabinet', 'tilt_deg', 10, 20, 0.00012),
  ('cabinet', 'tilt_deg', 20, 30, 0.0002038),
  ('cabinet', 'tilt_deg', 30, 40, 0.0003334),
  ('cabinet', 'tilt_deg', 40, 50, 0.0005052),
  ('cabinet', 'tilt_deg', 50, 60, 0.0007038),
  ('cabinet', 'tilt_deg', 60, 70, 0.0009013),
  ('cabinet', 'tilt_deg', 70, 80, 0.001062),
  ('cabinet', 'tilt_deg', 80, 89.4097, 0.01135),
  ('cabinet', 'tilt_deg', 89.4097, 89.7661, 0.7242),
  ('cabinet', 'tilt_deg', 89.7661, 90, 1.953);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'width', 0.01, 0.133368, 0.003494),
  ('cabinet', 'width', 0.133368, 0.174004, 0.1001),
  ('cabinet', 'width', 0.174004, 0.22702, 0.1234),
  ('cabinet', 'width', 0.22702, 0.268974, 0.1802),
  ('cabinet', 'width', 0.268974, 0.296189, 0.1657),
  ('cabinet', 'width', 0.296189, 0.386434, 0.2742),
  ('cabinet', 'width', 0.386434, 0.401584, 0.7784),
  ('cabinet', 'width', 0.401584, 0.494343, 0.5643),
  ('cabinet', 'width', 0.494343, 0.504174, 1.037),
  ('cabinet', 'width', 0.504174, 0.576707, 0.676),
  ('cabinet', 'width', 0.576707, 0.620431, 1.571),
  ('cabinet', 'width', 0.620431, 0.657789, 1.503),
  ('cabinet', 'width', 0.657789, 0.785449, 0.7171),
  ('cabinet', 'width', 0.785449, 0.858207, 0.8934),
  ('cabinet', 'width', 0.858207, 0.917177, 0.5018),
  ('cabinet', 'width', 0.917177, 1.11969, 0.3689),
  ('cabinet', 'width', 1.11969, 1.46084, 0.1125),
  ('cabinet', 'width', 1.46084, 12, 0.003663);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_max', -0.5, 0.325118, 0.01203),
  ('cabinet', 'z_max', 0.325118, 0.545721, 0.109),
  ('cabinet', 'z_max', 0.545721, 0.584318, 1.933),
  ('cabinet', 'z_max', 0.584318, 0.649457, 1.665),
  ('cabinet', 'z_max', 0.649457, 0.748878, 1.101),
  ('cabinet', 'z_max', 0.748878, 0.766324, 1.253),
  ('cabinet', 'z_max', 0.766324, 0.940604, 0.5265),
  ('cabinet', 'z_max', 0.940604, 0.986927, 0.8625),
  ('cabinet', 'z_max', 0.986927, 1.14634, 0.4606),
  ('cabinet', 'z_max', 1.14634, 1.20753, 0.3971),
  ('cabinet', 'z_max', 1.20753, 1.42813, 0.2339),
  ('cabinet', 'z_max', 1.42813, 1.62897, 0.214),
  ('cabinet', 'z_max', 1.62897, 1.64874, 0.4809),
  ('cabinet', 'z_max', 1.64874, 1.81387, 0.5867),
  ('cabinet', 'z_max', 1.81387, 1.86934, 0.7868),
  ('cabinet', 'z_max', 1.86934, 1.93581, 1.001),
  ('cabinet', 'z_max', 1.93581, 2.08994, 0.4551),
  ('cabinet', 'z_max', 2.08994, 2.29896, 0.1536),
  ('cabinet', 'z_max', 2.29896, 4, 0.005188);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_min', -0.5, -0.0513199, 0.03037),
  ('cabinet', 'z_min', -0.0513199, -0.0194203, 5.547),
  ('cabinet', 'z_min', -0.0194203, -0.0120991, 15.15),
  ('cabinet', 'z_min', -0.0120991, 0.0503667, 3.888),
  ('cabinet', 'z_min', 0.0503667, 0.084255, 0.915),
  ('cabinet', 'z_min', 0.084255, 0.21983, 0.6057),
  ('cabinet', 'z_min', 0.21983, 0.245869, 0.318),
  ('cabinet', 'z_min', 0.245869, 0.355405, 0.2758),
  ('cabinet', 'z_min', 0.355405, 0.490979, 0.2799),
  ('cabinet', 'z_min', 0.490979, 0.574234, 0.722),
  ('cabinet', 'z_min', 0.574234, 0.626554, 1.302),
  ('cabinet', 'z_min', 0.626554, 0.713127, 0.4073),
  ('cabinet', 'z_min', 0.713127, 0.762129, 0.2953),
  ('cabinet', 'z_min', 0.762129, 0.897704, 0.2386),
  ('cabinet', 'z_min', 0.897704, 1.03328, 0.179),
  ('cabinet', 'z_min', 1.03328, 1.16885, 0.1266),
  ('cabinet', 'z_min', 1.16885, 4, 0.005089);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.521 WHERE name = 'aspect';
UPDATE feature SET weight = 0.253 WHERE name = 'height';
UPDATE feature SET weight = 0 WHERE name = 'length';
UPDATE feature SET weight = 0.212 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.453 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.318 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.394 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.0638 WHERE name = 'width';
UPDATE feature SET weight = 0.601 WHERE name = 'z_max';
UPDATE feature SET weight = 0.401 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.371 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0453 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0339 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.0943 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0296 WHERE name = 'table';
UPDATE object_class SET prior = 0.044 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.0608 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.0192 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0793 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0155 WHERE name = 'door';
UPDATE object_class SET prior = 0.0224 WHERE name = 'window';
UPDATE object_class SET prior = 0.0119 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.092 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.0811 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 3.01 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.76 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 3.97 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 2.52 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.51 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 2.77 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.3 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.05 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.686 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.34 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 3.05 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 4.91 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 0.972 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.779 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.842 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 1.58 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.373 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 0.223 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 1.69 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.64 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 2.2 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 1.67 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 0.913 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.53 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 0.295 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.56 WHERE name = 'cabinet_not_on_table';
