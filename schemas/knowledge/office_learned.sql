-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise.
-- Densities and Gaussians: 5230 planes of 42 paper-like rooms, seeds from 1; 36 varied rooms, seeds from 301; 54 depth-camera frames, seeds from 101.
-- Priors and weights: 24 paper-like rooms, seeds from 11; 18 varied rooms, seeds from 401; 27 depth-camera frames, seeds from 201.

-- unknown: 2316 examples
UPDATE object_class SET prior = 0.5037 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.938, 1.227)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6378, 0.5074)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 0.9691, 0.6747)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.4569, 0.6986)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.7009, 0.1511)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.603, 0.7173)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.304, 0.6243)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 66.24, 35.75)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.097, 0.6277)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.23, 0.8546)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.694, 0.7132)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0167849, 0.003672),
  ('unknown', 'area_m2', 0.0167849, 0.0366452, 0.132),
  ('unknown', 'area_m2', 0.0366452, 0.0587489, 0.2369),
  ('unknown', 'area_m2', 0.0587489, 0.0799299, 0.3622),
  ('unknown', 'area_m2', 0.0799299, 0.082556, 0.4921),
  ('unknown', 'area_m2', 0.082556, 0.105318, 0.39),
  ('unknown', 'area_m2', 0.105318, 0.149775, 0.3149),
  ('unknown', 'area_m2', 0.149775, 0.18309, 0.2764),
  ('unknown', 'area_m2', 0.18309, 0.218053, 0.3116),
  ('unknown', 'area_m2', 0.218053, 0.315617, 0.2966),
  ('unknown', 'area_m2', 0.315617, 0.40605, 0.2371),
  ('unknown', 'area_m2', 0.40605, 0.549434, 0.1803),
  ('unknown', 'area_m2', 0.549434, 0.900522, 0.1281),
  ('unknown', 'area_m2', 0.900522, 1.99714, 0.02463),
  ('unknown', 'area_m2', 1.99714, 4.42919, 0.006589),
  ('unknown', 'area_m2', 4.42919, 9.8229, 0.006261),
  ('unknown', 'area_m2', 9.8229, 21.7849, 0.009247),
  ('unknown', 'area_m2', 21.7849, 100, 0.006247);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.11446, 1.009),
  ('unknown', 'aspect', 1.11446, 1.24606, 1.003),
  ('unknown', 'aspect', 1.24606, 1.26007, 0.8402),
  ('unknown', 'aspect', 1.26007, 1.3874, 1.046),
  ('unknown', 'aspect', 1.3874, 1.57253, 0.908),
  ('unknown', 'aspect', 1.57253, 1.58778, 0.9313),
  ('unknown', 'aspect', 1.58778, 1.77636, 0.8878),
  ('unknown', 'aspect', 1.77636, 2.00072, 0.8008),
  ('unknown', 'aspect', 2.00072, 2.06112, 0.5352),
  ('unknown', 'aspect', 2.06112, 2.52105, 0.5142),
  ('unknown', 'aspect', 2.52105, 2.58589, 0.3855),
  ('unknown', 'aspect', 2.58589, 3.1767, 0.3017),
  ('unknown', 'aspect', 3.1767, 4.00287, 0.1948),
  ('unknown', 'aspect', 4.00287, 4.13269, 0.1417),
  ('unknown', 'aspect', 4.13269, 5.0439, 0.1692),
  ('unknown', 'aspect', 5.0439, 6.35568, 0.2144),
  ('unknown', 'aspect', 6.35568, 8.00861, 0.0723),
  ('unknown', 'aspect', 8.00861, 100, 0.004012);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0161615, 0.01276),
  ('unknown', 'height', 0.0161615, 0.226212, 0.491),
  ('unknown', 'height', 0.226212, 0.362809, 0.6209),
  ('unknown', 'height', 0.362809, 0.414673, 0.5341),
  ('unknown', 'height', 0.414673, 0.577797, 0.677),
  ('unknown', 'height', 0.577797, 0.709456, 0.4559),
  ('unknown', 'height', 0.709456, 0.776785, 0.7658),
  ('unknown', 'height', 0.776785, 0.893124, 0.9437),
  ('unknown', 'height', 0.893124, 1.0561, 0.5809),
  ('unknown', 'height', 1.0561, 1.09715, 0.4197),
  ('unknown', 'height', 1.09715, 1.40275, 0.3318),
  ('unknown', 'height', 1.40275, 1.43506, 0.2798),
  ('unknown', 'height', 1.43506, 1.7494, 0.3194),
  ('unknown', 'height', 1.7494, 1.82659, 0.1626),
  ('unknown', 'height', 1.82659, 2.09605, 0.09944),
  ('unknown', 'height', 2.09605, 2.44269, 0.1205),
  ('unknown', 'height', 2.44269, 2.78934, 0.05917),
  ('unknown', 'height', 2.78934, 3.13599, 0.03319),
  ('unknown', 'height', 3.13599, 4, 0.01165);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.160141, 0.004126),
  ('unknown', 'length', 0.160141, 0.242304, 0.1733),
  ('unknown', 'length', 0.242304, 0.276768, 0.2524),
  ('unknown', 'length', 0.276768, 0.354948, 0.4401),
  ('unknown', 'length', 0.354948, 0.366623, 0.4025),
  ('unknown', 'length', 0.366623, 0.452255, 0.4657),
  ('unknown', 'length', 0.452255, 0.554367, 0.552),
  ('unknown', 'length', 0.554367, 0.684888, 0.5259),
  ('unknown', 'length', 0.684888, 0.839339, 0.5435),
  ('unknown', 'length', 0.839339, 1.0554, 0.4841),
  ('unknown', 'length', 1.0554, 1.26998, 0.3933),
  ('unknown', 'length', 1.26998, 1.38626, 0.4421),
  ('unknown', 'length', 1.38626, 1.92157, 0.2139),
  ('unknown', 'length', 1.92157, 2.90747, 0.03219),
  ('unknown', 'length', 2.90747, 4.3992, 0.01893),
  ('unknown', 'length', 4.3992, 6.6563, 0.02274),
  ('unknown', 'length', 6.6563, 30, 0.007013);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.308966, 0.03167),
  ('unknown', 'rectangularity', 0.308966, 0.381853, 0.2603),
  ('unknown', 'rectangularity', 0.381853, 0.45474, 0.5622),
  ('unknown', 'rectangularity', 0.45474, 0.500145, 0.9227),
  ('unknown', 'rectangularity', 0.500145, 0.527628, 1.286),
  ('unknown', 'rectangularity', 0.527628, 0.578936, 1.466),
  ('unknown', 'rectangularity', 0.578936, 0.600515, 1.724),
  ('unknown', 'rectangularity', 0.600515, 0.644699, 1.678),
  ('unknown', 'rectangularity', 0.644699, 0.673402, 2.136),
  ('unknown', 'rectangularity', 0.673402, 0.695132, 2.231),
  ('unknown', 'rectangularity', 0.695132, 0.740702, 2.456),
  ('unknown', 'rectangularity', 0.740702, 0.746289, 2.096),
  ('unknown', 'rectangularity', 0.746289, 0.785386, 2.556),
  ('unknown', 'rectangularity', 0.785386, 0.819176, 2.563),
  ('unknown', 'rectangularity', 0.819176, 0.829433, 2.306),
  ('unknown', 'rectangularity', 0.829433, 0.88363, 2.049),
  ('unknown', 'rectangularity', 0.88363, 0.892064, 1.777),
  ('unknown', 'rectangularity', 0.892064, 0.964951, 1.25),
  ('unknown', 'rectangularity', 0.964951, 1, 0.162);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.14833, 0.002652),
  ('unknown', 'spread_length', 0.14833, 0.225292, 0.192),
  ('unknown', 'spread_length', 0.225292, 0.246091, 0.2676),
  ('unknown', 'spread_length', 0.246091, 0.306235, 0.5093),
  ('unknown', 'spread_length', 0.306235, 0.342186, 0.7128),
  ('unknown', 'spread_length', 0.342186, 0.358286, 0.6835),
  ('unknown', 'spread_length', 0.358286, 0.442981, 0.5278),
  ('unknown', 'spread_length', 0.442981, 0.519732, 0.3984),
  ('unknown', 'spread_length', 0.519732, 0.585721, 0.4082),
  ('unknown', 'spread_length', 0.585721, 0.744038, 0.4616),
  ('unknown', 'spread_length', 0.744038, 0.789398, 0.5906),
  ('unknown', 'spread_length', 0.789398, 0.948668, 0.4085),
  ('unknown', 'spread_length', 0.948668, 1.19898, 0.3923),
  ('unknown', 'spread_length', 1.19898, 1.2631, 0.3615),
  ('unknown', 'spread_length', 1.2631, 1.82108, 0.2005),
  ('unknown', 'spread_length', 1.82108, 2.76597, 0.0267),
  ('unknown', 'spread_length', 2.76597, 4.20111, 0.0165),
  ('unknown', 'spread_length', 4.20111, 6.38089, 0.02282),
  ('unknown', 'spread_length', 6.38089, 40, 0.005721);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.107549, 0.0003071),
  ('unknown', 'spread_width', 0.107549, 0.110039, 0.1446),
  ('unknown', 'spread_width', 0.110039, 0.137574, 0.4757),
  ('unknown', 'spread_width', 0.137574, 0.161419, 0.4947),
  ('unknown', 'spread_width', 0.161419, 0.171024, 0.5559),
  ('unknown', 'spread_width', 0.171024, 0.202597, 0.6671),
  ('unknown', 'spread_width', 0.202597, 0.221827, 1.17),
  ('unknown', 'spread_width', 0.221827, 0.242273, 0.8428),
  ('unknown', 'spread_width', 0.242273, 0.258619, 0.6065),
  ('unknown', 'spread_width', 0.258619, 0.308602, 0.6224),
  ('unknown', 'spread_width', 0.308602, 0.363626, 0.463),
  ('unknown', 'spread_width', 0.363626, 0.399159, 0.3994),
  ('unknown', 'spread_width', 0.399159, 0.545765, 0.3025),
  ('unknown', 'spread_width', 0.545765, 0.582395, 0.2554),
  ('unknown', 'spread_width', 0.582395, 0.819135, 0.2164),
  ('unknown', 'spread_width', 0.819135, 1.22943, 0.03335),
  ('unknown', 'spread_width', 1.22943, 1.84525, 0.01019),
  ('unknown', 'spread_width', 1.84525, 2.76953, 0.01319),
  ('unknown', 'spread_width', 2.76953, 4.15676, 0.01117),
  ('unknown', 'spread_width', 4.15676, 20, 0.005976);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 1.27517, 0.08441),
  ('unknown', 'tilt_deg', 1.27517, 10, 0.01051),
  ('unknown', 'tilt_deg', 10, 16.8628, 0.003182),
  ('unknown', 'tilt_deg', 16.8628, 20, 0.002414),
  ('unknown', 'tilt_deg', 20, 30, 0.001202),
  ('unknown', 'tilt_deg', 30, 40, 0.0008742),
  ('unknown', 'tilt_deg', 40, 50, 0.0008029),
  ('unknown', 'tilt_deg', 50, 60, 0.0007651),
  ('unknown', 'tilt_deg', 60, 70, 0.001567),
  ('unknown', 'tilt_deg', 70, 79.4511, 0.00582),
  ('unknown', 'tilt_deg', 79.4511, 80, 0.007883),
  ('unknown', 'tilt_deg', 80, 86.9945, 0.01523),
  ('unknown', 'tilt_deg', 86.9945, 88.9076, 0.06008),
  ('unknown', 'tilt_deg', 88.9076, 89.546, 0.194),
  ('unknown', 'tilt_deg', 89.546, 89.8426, 0.5802),
  ('unknown', 'tilt_deg', 89.8426, 90, 0.9045);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.117007, 0.003259),
  ('unknown', 'width', 0.117007, 0.164699, 0.3009),
  ('unknown', 'width', 0.164699, 0.175087, 0.4166),
  ('unknown', 'width', 0.175087, 0.208026, 0.5096),
  ('unknown', 'width', 0.208026, 0.241144, 0.7477),
  ('unknown', 'width', 0.241144, 0.261997, 0.8135),
  ('unknown', 'width', 0.261997, 0.280166, 0.6263),
  ('unknown', 'width', 0.280166, 0.336824, 0.6078),
  ('unknown', 'width', 0.336824, 0.392047, 0.6631),
  ('unknown', 'width', 0.392047, 0.398889, 0.4878),
  ('unknown', 'width', 0.398889, 0.496644, 0.5089),
  ('unknown', 'width', 0.496644, 0.586653, 0.2919),
  ('unknown', 'width', 0.586653, 0.710946, 0.3302),
  ('unknown', 'width', 0.710946, 0.877857, 0.3022),
  ('unknown', 'width', 0.877857, 1.31361, 0.04863),
  ('unknown', 'width', 1.31361, 1.96566, 0.02176),
  ('unknown', 'width', 1.96566, 2.94138, 0.01145),
  ('unknown', 'width', 2.94138, 4.40143, 0.01277),
  ('unknown', 'width', 4.40143, 12, 0.009279);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0702437, 0.01414),
  ('unknown', 'z_max', 0.0702437, 0.401792, 0.3073),
  ('unknown', 'z_max', 0.401792, 0.506883, 0.5416),
  ('unknown', 'z_max', 0.506883, 0.662329, 0.3563),
  ('unknown', 'z_max', 0.662329, 0.784112, 0.9188),
  ('unknown', 'z_max', 0.784112, 0.908148, 0.881),
  ('unknown', 'z_max', 0.908148, 0.943523, 0.6294),
  ('unknown', 'z_max', 0.943523, 1.06465, 0.7418),
  ('unknown', 'z_max', 1.06465, 1.30353, 0.4516),
  ('unknown', 'z_max', 1.30353, 1.38016, 0.2809),
  ('unknown', 'z_max', 1.38016, 1.78933, 0.2283),
  ('unknown', 'z_max', 1.78933, 1.8168, 0.2566),
  ('unknown', 'z_max', 1.8168, 2.19041, 0.2772),
  ('unknown', 'z_max', 2.19041, 2.25344, 0.3121),
  ('unknown', 'z_max', 2.25344, 2.69008, 0.1047),
  ('unknown', 'z_max', 2.69008, 3.12672, 0.03762),
  ('unknown', 'z_max', 3.12672, 3.56336, 0.0189),
  ('unknown', 'z_max', 3.56336, 4, 0.04804);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.126859, 0.05545),
  ('unknown', 'z_min', -0.126859, -0.0130288, 0.823),
  ('unknown', 'z_min', -0.0130288, 0.0245249, 2.831),
  ('unknown', 'z_min', 0.0245249, 0.246136, 0.5051),
  ('unknown', 'z_min', 0.246136, 0.571983, 0.3359),
  ('unknown', 'z_min', 0.571983, 0.619423, 0.3463),
  ('unknown', 'z_min', 0.619423, 0.724021, 0.9237),
  ('unknown', 'z_min', 0.724021, 0.846562, 0.9134),
  ('unknown', 'z_min', 0.846562, 0.992564, 0.5948),
  ('unknown', 'z_min', 0.992564, 1.05895, 0.3351),
  ('unknown', 'z_min', 1.05895, 1.3657, 0.2849),
  ('unknown', 'z_min', 1.3657, 1.49154, 0.2054),
  ('unknown', 'z_min', 1.49154, 1.73885, 0.08697),
  ('unknown', 'z_min', 1.73885, 2.11199, 0.05587),
  ('unknown', 'z_min', 2.11199, 2.48513, 0.09648),
  ('unknown', 'z_min', 2.48513, 2.85827, 0.05334),
  ('unknown', 'z_min', 2.85827, 4, 0.01084);

-- floor: 137 examples
UPDATE object_class SET prior = 0.02981 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.359, 1.468)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4616, 0.3272)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.001858, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.196, 0.6877)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5837, 0.1282)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.9178, 0.6185)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.363, 0.7731)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.7035, 0.963)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.7296, 0.8403)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.01184, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.009621, 0.023)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'floor' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'area_m2', 0.002, 0.046515, 0.002868),
  ('floor', 'area_m2', 0.046515, 0.092158, 0.01716),
  ('floor', 'area_m2', 0.092158, 0.182588, 0.02697),
  ('floor', 'area_m2', 0.182588, 0.361753, 0.07124),
  ('floor', 'area_m2', 0.361753, 0.427041, 0.1162),
  ('floor', 'area_m2', 0.427041, 0.716724, 0.1233),
  ('floor', 'area_m2', 0.716724, 1.05874, 0.1154),
  ('floor', 'area_m2', 1.05874, 1.42001, 0.1286),
  ('floor', 'area_m2', 1.42001, 2.8134, 0.08439),
  ('floor', 'area_m2', 2.8134, 4.10491, 0.1227),
  ('floor', 'area_m2', 4.10491, 5.57405, 0.2395),
  ('floor', 'area_m2', 5.57405, 6.38101, 0.1854),
  ('floor', 'area_m2', 6.38101, 8.20556, 0.451),
  ('floor', 'area_m2', 8.20556, 10.0699, 0.5335),
  ('floor', 'area_m2', 10.0699, 11.0436, 0.5929),
  ('floor', 'area_m2', 11.0436, 12.5183, 0.3477),
  ('floor', 'area_m2', 12.5183, 14.57, 0.6871),
  ('floor', 'area_m2', 14.57, 21.8802, 0.2539),
  ('floor', 'area_m2', 21.8802, 100, 0.01011);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'aspect', 1, 1.06225, 1.808),
  ('floor', 'aspect', 1.06225, 1.16797, 0.9701),
  ('floor', 'aspect', 1.16797, 1.18702, 0.9177),
  ('floor', 'aspect', 1.18702, 1.3255, 1.093),
  ('floor', 'aspect', 1.3255, 1.36415, 1.748),
  ('floor', 'aspect', 1.36415, 1.42343, 1.233),
  ('floor', 'aspect', 1.42343, 1.59328, 0.9111),
  ('floor', 'aspect', 1.59328, 1.62641, 0.7389),
  ('floor', 'aspect', 1.62641, 1.80976, 0.9562),
  ('floor', 'aspect', 1.80976, 1.86089, 1.23),
  ('floor', 'aspect', 1.86089, 2.02524, 0.9213),
  ('floor', 'aspect', 2.02524, 2.17346, 0.7189),
  ('floor', 'aspect', 2.17346, 2.33152, 0.8734),
  ('floor', 'aspect', 2.33152, 2.53853, 0.394),
  ('floor', 'aspect', 2.53853, 2.96492, 0.2103),
  ('floor', 'aspect', 2.96492, 3.46293, 0.1721),
  ('floor', 'aspect', 3.46293, 4.04458, 0.08033),
  ('floor', 'aspect', 4.04458, 100, 0.003403);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'height', -0.5, -0.0333758, 0.02799),
  ('floor', 'height', -0.0333758, -0.0196788, 3.219),
  ('floor', 'height', -0.0196788, -0.00598182, 17.4),
  ('floor', 'height', -0.00598182, -8.61651e-05, 30.51),
  ('floor', 'height', -8.61651e-05, 0.00771516, 30.11),
  ('floor', 'height', 0.00771516, 0.0214121, 15.92),
  ('floor', 'height', 0.0214121, 0.0351091, 3.144),
  ('floor', 'height', 0.0351091, 0.0488061, 0.6394),
  ('floor', 'height', 0.0488061, 0.0625031, 0.3941),
  ('floor', 'height', 0.0625031, 0.0762001, 0.3365),
  ('floor', 'height', 0.0762001, 0.089897, 0.1882),
  ('floor', 'height', 0.089897, 4, 0.001859);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'length', 0.03, 0.391406, 0.003791),
  ('floor', 'length', 0.391406, 0.555712, 0.03124),
  ('floor', 'length', 0.555712, 0.788991, 0.06148),
  ('floor', 'length', 0.788991, 1.1202, 0.154),
  ('floor', 'length', 1.1202, 1.20354, 0.2016),
  ('floor', 'length', 1.20354, 1.59044, 0.2296),
  ('floor', 'length', 1.59044, 1.99515, 0.2149),
  ('floor', 'length', 1.99515, 2.25808, 0.2176),
  ('floor', 'length', 2.25808, 3.20599, 0.2347),
  ('floor', 'length', 3.20599, 3.30777, 0.3589),
  ('floor', 'length', 3.30777, 3.88566, 0.7405),
  ('floor', 'length', 3.88566, 4.24813, 1.097),
  ('floor', 'length', 4.24813, 4.55181, 1.279),
  ('floor', 'length', 4.55181, 4.67262, 0.768),
  ('floor', 'length', 4.67262, 5.63547, 0.5875),
  ('floor', 'length', 5.63547, 6.30403, 0.7758),
  ('floor', 'length', 6.30403, 6.46259, 0.7098),
  ('floor', 'length', 6.46259, 8.63146, 0.3235),
  ('floor', 'length', 8.63146, 9.17548, 0.1561),
  ('floor', 'length', 9.17548, 30, 0.01086);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'rectangularity', 0, 0.283559, 0.04025),
  ('floor', 'rectangularity', 0.283559, 0.351077, 0.2871),
  ('floor', 'rectangularity', 0.351077, 0.418594, 0.9643),
  ('floor', 'rectangularity', 0.418594, 0.431291, 1.509),
  ('floor', 'rectangularity', 0.431291, 0.486111, 1.748),
  ('floor', 'rectangularity', 0.486111, 0.493961, 2.935),
  ('floor', 'rectangularity', 0.493961, 0.526055, 3.053),
  ('floor', 'rectangularity', 0.526055, 0.552453, 3.973),
  ('floor', 'rectangularity', 0.552453, 0.591539, 3.02),
  ('floor', 'rectangularity', 0.591539, 0.621146, 3.115),
  ('floor', 'rectangularity', 0.621146, 0.630473, 2.453),
  ('floor', 'rectangularity', 0.630473, 0.681394, 2.143),
  ('floor', 'rectangularity', 0.681394, 0.688663, 1.722),
  ('floor', 'rectangularity', 0.688663, 0.753213, 1.422),
  ('floor', 'rectangularity', 0.753213, 0.823698, 1.035),
  ('floor', 'rectangularity', 0.823698, 0.891215, 0.4955),
  ('floor', 'rectangularity', 0.891215, 1, 0.0938);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_length', 0.01, 0.327946, 0.002324),
  ('floor', 'spread_length', 0.327946, 0.45046, 0.03839),
  ('floor', 'spread_length', 0.45046, 0.618743, 0.05156),
  ('floor', 'spread_length', 0.618743, 0.849893, 0.1286),
  ('floor', 'spread_length', 0.849893, 0.972436, 0.1891),
  ('floor', 'spread_length', 0.972436, 1.1674, 0.2053),
  ('floor', 'spread_length', 1.1674, 1.58619, 0.2621),
  ('floor', 'spread_length', 1.58619, 2.20255, 0.2049),
  ('floor', 'spread_length', 2.20255, 2.58512, 0.3581),
  ('floor', 'spread_length', 2.58512, 2.92644, 0.9181),
  ('floor', 'spread_length', 2.92644, 3.02538, 0.9596),
  ('floor', 'spread_length', 3.02538, 3.26568, 0.9592),
  ('floor', 'spread_length', 3.26568, 3.58387, 1.121),
  ('floor', 'spread_length', 3.58387, 3.91006, 1.158),
  ('floor', 'spread_length', 3.91006, 4.1556, 1.292),
  ('floor', 'spread_length', 4.1556, 4.34407, 0.8638),
  ('floor', 'spread_length', 4.34407, 5.70804, 0.3577),
  ('floor', 'spread_length', 5.70804, 40, 0.008073);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_width', 0.003, 0.135185, 0.002392),
  ('floor', 'spread_width', 0.135185, 0.142494, 0.04118),
  ('floor', 'spread_width', 0.142494, 0.194235, 0.0438),
  ('floor', 'spread_width', 0.194235, 0.27908, 0.04013),
  ('floor', 'spread_width', 0.27908, 0.400986, 0.1204),
  ('floor', 'spread_width', 0.400986, 0.446213, 0.1728),
  ('floor', 'spread_width', 0.446213, 0.576142, 0.2341),
  ('floor', 'spread_width', 0.576142, 0.718251, 0.268),
  ('floor', 'spread_width', 0.718251, 0.827809, 0.1685),
  ('floor', 'spread_width', 0.827809, 1.18941, 0.1557),
  ('floor', 'spread_width', 1.18941, 1.54787, 0.1965),
  ('floor', 'spread_width', 1.54787, 1.70896, 0.4547),
  ('floor', 'spread_width', 1.70896, 1.84473, 0.7478),
  ('floor', 'spread_width', 1.84473, 2.10016, 0.8298),
  ('floor', 'spread_width', 2.10016, 2.36012, 0.8851),
  ('floor', 'spread_width', 2.36012, 2.45545, 1.33),
  ('floor', 'spread_width', 2.45545, 2.56259, 1.322),
  ('floor', 'spread_width', 2.56259, 2.74079, 1.432),
  ('floor', 'spread_width', 2.74079, 3.38364, 0.5088),
  ('floor', 'spread_width', 3.38364, 3.52803, 0.1571),
  ('floor', 'spread_width', 3.52803, 20, 0.008761);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'tilt_deg', 0, 0.455302, 1.206),
  ('floor', 'tilt_deg', 0.455302, 0.910604, 0.2251),
  ('floor', 'tilt_deg', 0.910604, 1.36591, 0.2042),
  ('floor', 'tilt_deg', 1.36591, 1.56405, 0.1885),
  ('floor', 'tilt_deg', 1.56405, 1.82121, 0.1857),
  ('floor', 'tilt_deg', 1.82121, 2.14429, 0.1844),
  ('floor', 'tilt_deg', 2.14429, 2.27651, 0.1724),
  ('floor', 'tilt_deg', 2.27651, 2.73181, 0.1109),
  ('floor', 'tilt_deg', 2.73181, 3.18711, 0.04044),
  ('floor', 'tilt_deg', 3.18711, 3.64242, 0.01388),
  ('floor', 'tilt_deg', 3.64242, 4.09772, 0.01343),
  ('floor', 'tilt_deg', 4.09772, 90, 7.555e-05);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'width', 0.01, 0.198028, 0.004043),
  ('floor', 'width', 0.198028, 0.211538, 0.04923),
  ('floor', 'width', 0.211538, 0.289671, 0.05256),
  ('floor', 'width', 0.289671, 0.423724, 0.06395),
  ('floor', 'width', 0.423724, 0.602608, 0.1468),
  ('floor', 'width', 0.602608, 0.619815, 0.2174),
  ('floor', 'width', 0.619815, 0.906651, 0.2514),
  ('floor', 'width', 0.906651, 1.03261, 0.1459),
  ('floor', 'width', 1.03261, 1.32623, 0.1302),
  ('floor', 'width', 1.32623, 1.93998, 0.1846),
  ('floor', 'width', 1.93998, 2.005, 0.3177),
  ('floor', 'width', 2.005, 2.71351, 0.4091),
  ('floor', 'width', 2.71351, 2.83776, 0.6353),
  ('floor', 'width', 2.83776, 3.14551, 0.6333),
  ('floor', 'width', 3.14551, 3.5023, 0.9557),
  ('floor', 'width', 3.5023, 3.923, 0.9626),
  ('floor', 'width', 3.923, 4.15101, 1.079),
  ('floor', 'width', 4.15101, 4.42148, 0.8289),
  ('floor', 'width', 4.42148, 6.07201, 0.3187),
  ('floor', 'width', 6.07201, 12, 0.02129);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_max', -0.5, -0.022501, 0.05019),
  ('floor', 'z_max', -0.022501, -0.00531989, 10.54),
  ('floor', 'z_max', -0.00531989, 0.0117751, 22.88),
  ('floor', 'z_max', 0.0117751, 0.0184491, 17.39),
  ('floor', 'z_max', 0.0184491, 0.0290423, 11.38),
  ('floor', 'z_max', 0.0290423, 0.0462233, 5.626),
  ('floor', 'z_max', 0.0462233, 0.0634044, 1.899),
  ('floor', 'z_max', 0.0634044, 0.0805855, 0.9201),
  ('floor', 'z_max', 0.0805855, 0.0977666, 0.4344),
  ('floor', 'z_max', 0.0977666, 0.114948, 0.1628),
  ('floor', 'z_max', 0.114948, 0.132129, 0.2185),
  ('floor', 'z_max', 0.132129, 4, 0.00208);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_min', -0.5, -0.126708, 0.01877),
  ('floor', 'z_min', -0.126708, -0.104404, 0.2789),
  ('floor', 'z_min', -0.104404, -0.0821004, 0.4003),
  ('floor', 'z_min', -0.0821004, -0.0597964, 1.027),
  ('floor', 'z_min', -0.0597964, -0.0374924, 2.793),
  ('floor', 'z_min', -0.0374924, -0.0190415, 7.878),
  ('floor', 'z_min', -0.0190415, -0.00488292, 18.72),
  ('floor', 'z_min', -0.00488292, 0.00711552, 23.17),
  ('floor', 'z_min', 0.00711552, 0.0294195, 7.945),
  ('floor', 'z_min', 0.0294195, 0.0517235, 0.6204),
  ('floor', 'z_min', 0.0517235, 0.0740275, 0.2841),
  ('floor', 'z_min', 0.0740275, 4, 0.001759);

-- ceiling: 96 examples
UPDATE object_class SET prior = 0.02093 WHERE name = 'ceiling';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.01738, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.9371, 0.7256)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.887, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.886, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'area_m2', 0.002, 0.190598, 0.002497),
  ('ceiling', 'area_m2', 0.190598, 0.334845, 0.03558),
  ('ceiling', 'area_m2', 0.334845, 0.58826, 0.04062),
  ('ceiling', 'area_m2', 0.58826, 1.03346, 0.06885),
  ('ceiling', 'area_m2', 1.03346, 1.13287, 0.09315),
  ('ceiling', 'area_m2', 1.13287, 1.8156, 0.07862),
  ('ceiling', 'area_m2', 1.8156, 3.18968, 0.08758),
  ('ceiling', 'area_m2', 3.18968, 5.21693, 0.1254),
  ('ceiling', 'area_m2', 5.21693, 5.60367, 0.2153),
  ('ceiling', 'area_m2', 5.60367, 7.33125, 0.3244),
  ('ceiling', 'area_m2', 7.33125, 9.50865, 0.452),
  ('ceiling', 'area_m2', 9.50865, 11.0964, 0.6113),
  ('ceiling', 'area_m2', 11.0964, 12.3718, 0.9861),
  ('ceiling', 'area_m2', 12.3718, 14.472, 0.6436),
  ('ceiling', 'area_m2', 14.472, 17.2951, 0.5319),
  ('ceiling', 'area_m2', 17.2951, 18.3388, 0.2218),
  ('ceiling', 'area_m2', 18.3388, 28.1523, 0.2371),
  ('ceiling', 'area_m2', 28.1523, 30.3844, 0.05451),
  ('ceiling', 'area_m2', 30.3844, 100, 0.01166);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'aspect', 1, 1.04527, 2.269),
  ('ceiling', 'aspect', 1.04527, 1.15695, 1.296),
  ('ceiling', 'aspect', 1.15695, 1.20194, 1.653),
  ('ceiling', 'aspect', 1.20194, 1.24224, 1.031),
  ('ceiling', 'aspect', 1.24224, 1.36583, 1.069),
  ('ceiling', 'aspect', 1.36583, 1.44466, 1.695),
  ('ceiling', 'aspect', 1.44466, 1.58075, 1.31),
  ('ceiling', 'aspect', 1.58075, 1.7364, 0.7916),
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
  ('ceiling', 'rectangularity', 0, 0.412808, 0.01897),
  ('ceiling', 'rectangularity', 0.412808, 0.424492, 0.2105),
  ('ceiling', 'rectangularity', 0.424492, 0.47488, 0.3815),
  ('ceiling', 'rectangularity', 0.47488, 0.525167, 1.578),
  ('ceiling', 'rectangularity', 0.525167, 0.536951, 2.517),
  ('ceiling', 'rectangularity', 0.536951, 0.577217, 2.054),
  ('ceiling', 'rectangularity', 0.577217, 0.599022, 1.748),
  ('ceiling', 'rectangularity', 0.599022, 0.631956, 2.098),
  ('ceiling', 'rectangularity', 0.631956, 0.661093, 3.496),
  ('ceiling', 'rectangularity', 0.661093, 0.715451, 2.393),
  ('ceiling', 'rectangularity', 0.715451, 0.723164, 3.018),
  ('ceiling', 'rectangularity', 0.723164, 0.766504, 1.99),
  ('ceiling', 'rectangularity', 0.766504, 0.785235, 1.301),
  ('ceiling', 'rectangularity', 0.785235, 0.824861, 2.343),
  ('ceiling', 'rectangularity', 0.824861, 0.847306, 2.721),
  ('ceiling', 'rectangularity', 0.847306, 0.865122, 1.884),
  ('ceiling', 'rectangularity', 0.865122, 0.909377, 1.402),
  ('ceiling', 'rectangularity', 0.909377, 0.955293, 0.8823),
  ('ceiling', 'rectangularity', 0.955293, 0.971448, 0.476),
  ('ceiling', 'rectangularity', 0.971448, 1, 0.2822);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_length', 0.01, 0.712981, 0.003063),
  ('ceiling', 'spread_length', 0.712981, 0.903963, 0.06051),
  ('ceiling', 'spread_length', 0.903963, 1.1461, 0.03792),
  ('ceiling', 'spread_length', 1.1461, 1.4531, 0.1565),
  ('ceiling', 'spread_length', 1.4531, 1.66473, 0.2065),
  ('ceiling', 'spread_length', 1.66473, 1.84234, 0.1746),
  ('ceiling', 'spread_length', 1.84234, 2.33584, 0.1499),
  ('ceiling', 'spread_length', 2.33584, 2.96152, 0.3065),
  ('ceiling', 'spread_length', 2.96152, 3.6109, 0.6586),
  ('ceiling', 'spread_length', 3.6109, 3.75481, 1.13),
  ('ceiling', 'spread_length', 3.75481, 3.89727, 1.628),
  ('ceiling', 'spread_length', 3.89727, 4.27775, 1.279),
  ('ceiling', 'spread_length', 4.27775, 4.45898, 1.949),
  ('ceiling', 'spread_length', 4.45898, 4.73926, 1.649),
  ('ceiling', 'spread_length', 4.73926, 5.12794, 1.364),
  ('ceiling', 'spread_length', 5.12794, 5.78033, 0.8369),
  ('ceiling', 'spread_length', 5.78033, 6.03579, 0.2845),
  ('ceiling', 'spread_length', 6.03579, 40, 0.008684);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_width', 0.003, 0.165573, 0.002851),
  ('ceiling', 'spread_width', 0.165573, 0.236671, 0.01937),
  ('ceiling', 'spread_width', 0.236671, 0.338299, 0.01818),
  ('ceiling', 'spread_width', 0.338299, 0.483567, 0.08546),
  ('ceiling', 'spread_width', 0.483567, 0.691213, 0.1427),
  ('ceiling', 'spread_width', 0.691213, 0.708781, 0.1426),
  ('ceiling', 'spread_width', 0.708781, 0.988025, 0.155),
  ('ceiling', 'spread_width', 0.988025, 1.41229, 0.1587),
  ('ceiling', 'spread_width', 1.41229, 1.60757, 0.1694),
  ('ceiling', 'spread_width', 1.60757, 2.01873, 0.4691),
  ('ceiling', 'spread_width', 2.01873, 2.29127, 0.9531),
  ('ceiling', 'spread_width', 2.29127, 2.56803, 0.8578),
  ('ceiling', 'spread_width', 2.56803, 2.7904, 1.19),
  ('ceiling', 'spread_width', 2.7904, 2.88559, 1.239),
  ('ceiling', 'spread_width', 2.88559, 3.03457, 1.179),
  ('ceiling', 'spread_width', 3.03457, 3.32181, 1.249),
  ('ceiling', 'spread_width', 3.32181, 3.91446, 0.5907),
  ('ceiling', 'spread_width', 3.91446, 4.12468, 0.1382),
  ('ceiling', 'spread_width', 4.12468, 20, 0.01122);
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
  ('ceiling', 'z_max', -0.5, 2.29378, 0.005656),
  ('ceiling', 'z_max', 2.29378, 2.47342, 0.4735),
  ('ceiling', 'z_max', 2.47342, 2.51529, 2.698),
  ('ceiling', 'z_max', 2.51529, 2.65307, 0.6214),
  ('ceiling', 'z_max', 2.65307, 2.68291, 1.032),
  ('ceiling', 'z_max', 2.68291, 2.74967, 1.687),
  ('ceiling', 'z_max', 2.74967, 2.83271, 1.074),
  ('ceiling', 'z_max', 2.83271, 2.98185, 0.8366),
  ('ceiling', 'z_max', 2.98185, 3.01235, 0.6298),
  ('ceiling', 'z_max', 3.01235, 3.11032, 0.8916),
  ('ceiling', 'z_max', 3.11032, 3.192, 0.6522),
  ('ceiling', 'z_max', 3.192, 3.37164, 0.2781),
  ('ceiling', 'z_max', 3.37164, 3.40419, 0.3199),
  ('ceiling', 'z_max', 3.40419, 3.55128, 0.2809),
  ('ceiling', 'z_max', 3.55128, 3.73093, 0.2133),
  ('ceiling', 'z_max', 3.73093, 3.89171, 0.1808),
  ('ceiling', 'z_max', 3.89171, 3.91057, 0.1454),
  ('ceiling', 'z_max', 3.91057, 4, 0.1297);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_min', -0.5, 2.29347, 0.00567),
  ('ceiling', 'z_min', 2.29347, 2.47312, 0.4749),
  ('ceiling', 'z_min', 2.47312, 2.51425, 2.738),
  ('ceiling', 'z_min', 2.51425, 2.65277, 0.6183),
  ('ceiling', 'z_min', 2.65277, 2.68257, 1.039),
  ('ceiling', 'z_min', 2.68257, 2.74867, 1.687),
  ('ceiling', 'z_min', 2.74867, 2.83242, 1.076),
  ('ceiling', 'z_min', 2.83242, 2.98149, 0.8365),
  ('ceiling', 'z_min', 2.98149, 3.01206, 0.6297),
  ('ceiling', 'z_min', 3.01206, 3.11007, 0.894),
  ('ceiling', 'z_min', 3.11007, 3.19171, 0.649),
  ('ceiling', 'z_min', 3.19171, 3.37136, 0.2786),
  ('ceiling', 'z_min', 3.37136, 3.40363, 0.3207),
  ('ceiling', 'z_min', 3.40363, 3.55101, 0.281),
  ('ceiling', 'z_min', 3.55101, 3.73066, 0.213),
  ('ceiling', 'z_min', 3.73066, 3.89005, 0.1809),
  ('ceiling', 'z_min', 3.89005, 3.9103, 0.1452),
  ('ceiling', 'z_min', 3.9103, 4, 0.129);

-- wall: 500 examples
UPDATE object_class SET prior = 0.1089 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 1.123, 1.027)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.5693, 0.4071)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.413, 0.3557)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 1.054, 0.4585)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6801, 0.1453)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.8888, 0.4645)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', 0.2359, 0.6446)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.54, 1.182)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.4822, 0.6493)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.557, 0.6674)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.1683, 0.3626)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'wall' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'area_m2', 0.002, 0.236308, 0.002329),
  ('wall', 'area_m2', 0.236308, 0.379783, 0.04519),
  ('wall', 'area_m2', 0.379783, 0.610369, 0.1033),
  ('wall', 'area_m2', 0.610369, 0.754229, 0.135),
  ('wall', 'area_m2', 0.754229, 0.980958, 0.1902),
  ('wall', 'area_m2', 0.980958, 1.24552, 0.2477),
  ('wall', 'area_m2', 1.24552, 1.57655, 0.2468),
  ('wall', 'area_m2', 1.57655, 1.97497, 0.242),
  ('wall', 'area_m2', 1.97497, 2.53376, 0.2784),
  ('wall', 'area_m2', 2.53376, 2.98484, 0.2657),
  ('wall', 'area_m2', 2.98484, 4.07214, 0.2644),
  ('wall', 'area_m2', 4.07214, 4.49843, 0.3035),
  ('wall', 'area_m2', 4.49843, 5.9315, 0.4047),
  ('wall', 'area_m2', 5.9315, 6.54456, 0.4123),
  ('wall', 'area_m2', 6.54456, 7.63146, 0.4445),
  ('wall', 'area_m2', 7.63146, 10.0445, 0.4032),
  ('wall', 'area_m2', 10.0445, 10.5181, 0.243),
  ('wall', 'area_m2', 10.5181, 16.9042, 0.2017),
  ('wall', 'area_m2', 16.9042, 100, 0.002448);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'aspect', 1, 1.12941, 0.9423),
  ('wall', 'aspect', 1.12941, 1.23954, 0.7115),
  ('wall', 'aspect', 1.23954, 1.27748, 1.352),
  ('wall', 'aspect', 1.27748, 1.40304, 1.17),
  ('wall', 'aspect', 1.40304, 1.53647, 0.9381),
  ('wall', 'aspect', 1.53647, 1.57485, 1.233),
  ('wall', 'aspect', 1.57485, 1.70499, 1.269),
  ('wall', 'aspect', 1.70499, 1.90452, 0.9289),
  ('wall', 'aspect', 1.90452, 1.93325, 1),
  ('wall', 'aspect', 1.93325, 2.2459, 0.7327),
  ('wall', 'aspect', 2.2459, 2.36073, 0.4762),
  ('wall', 'aspect', 2.36073, 2.92623, 0.4153),
  ('wall', 'aspect', 2.92623, 2.95944, 0.2474),
  ('wall', 'aspect', 2.95944, 3.62718, 0.181),
  ('wall', 'aspect', 3.62718, 4.49605, 0.1603),
  ('wall', 'aspect', 4.49605, 5.57305, 0.09355),
  ('wall', 'aspect', 5.57305, 6.90804, 0.03423),
  ('wall', 'aspect', 6.90804, 100, 0.003831);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'height', -0.5, 0.29378, 0.01344),
  ('wall', 'height', 0.29378, 0.514339, 0.07032),
  ('wall', 'height', 0.514339, 0.734898, 0.1223),
  ('wall', 'height', 0.734898, 0.955457, 0.2137),
  ('wall', 'height', 0.955457, 1.0257, 0.1979),
  ('wall', 'height', 1.0257, 1.17602, 0.3462),
  ('wall', 'height', 1.17602, 1.23246, 0.9879),
  ('wall', 'height', 1.23246, 1.3303, 1.159),
  ('wall', 'height', 1.3303, 1.39657, 1.581),
  ('wall', 'height', 1.39657, 1.45967, 1.716),
  ('wall', 'height', 1.45967, 1.537, 1.497),
  ('wall', 'height', 1.537, 1.61713, 1.182),
  ('wall', 'height', 1.61713, 1.6328, 1.201),
  ('wall', 'height', 1.6328, 1.80252, 0.678),
  ('wall', 'height', 1.80252, 1.83769, 0.2918),
  ('wall', 'height', 1.83769, 2.05825, 0.27),
  ('wall', 'height', 2.05825, 2.27881, 0.1217),
  ('wall', 'height', 2.27881, 4, 0.006126);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'length', 0.03, 0.731393, 0.002539),
  ('wall', 'length', 0.731393, 0.933266, 0.05701),
  ('wall', 'length', 0.933266, 1.19086, 0.08099),
  ('wall', 'length', 1.19086, 1.51955, 0.2372),
  ('wall', 'length', 1.51955, 1.56426, 0.4097),
  ('wall', 'length', 1.56426, 1.93896, 0.3987),
  ('wall', 'length', 1.93896, 2.1186, 0.2704),
  ('wall', 'length', 2.1186, 2.47414, 0.6974),
  ('wall', 'length', 2.47414, 2.7396, 1.092),
  ('wall', 'length', 2.7396, 3.15703, 0.7436),
  ('wall', 'length', 3.15703, 3.73341, 0.7383),
  ('wall', 'length', 3.73341, 4.02841, 0.8977),
  ('wall', 'length', 4.02841, 4.29839, 0.6973),
  ('wall', 'length', 4.29839, 4.79322, 0.9442),
  ('wall', 'length', 4.79322, 5.14029, 0.5349),
  ('wall', 'length', 5.14029, 6.55907, 0.2843),
  ('wall', 'length', 6.55907, 30, 0.004672);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'rectangularity', 0, 0.345685, 0.03473),
  ('wall', 'rectangularity', 0.345685, 0.416716, 0.3836),
  ('wall', 'rectangularity', 0.416716, 0.485899, 1.061),
  ('wall', 'rectangularity', 0.485899, 0.558778, 1.274),
  ('wall', 'rectangularity', 0.558778, 0.570187, 1.362),
  ('wall', 'rectangularity', 0.570187, 0.622439, 2.099),
  ('wall', 'rectangularity', 0.622439, 0.629809, 2.434),
  ('wall', 'rectangularity', 0.629809, 0.660981, 3.157),
  ('wall', 'rectangularity', 0.660981, 0.70084, 2.5),
  ('wall', 'rectangularity', 0.70084, 0.7048, 2.549),
  ('wall', 'rectangularity', 0.7048, 0.753022, 2.269),
  ('wall', 'rectangularity', 0.753022, 0.771871, 2.401),
  ('wall', 'rectangularity', 0.771871, 0.7943, 2.914),
  ('wall', 'rectangularity', 0.7943, 0.842902, 1.625),
  ('wall', 'rectangularity', 0.842902, 0.860998, 1.695),
  ('wall', 'rectangularity', 0.860998, 0.913933, 1.069),
  ('wall', 'rectangularity', 0.913933, 0.984964, 0.723),
  ('wall', 'rectangularity', 0.984964, 1, 0.3678);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_length', 0.01, 0.629153, 0.001999),
  ('wall', 'spread_length', 0.629153, 0.805774, 0.06058),
  ('wall', 'spread_length', 0.805774, 1.03198, 0.09598),
  ('wall', 'spread_length', 1.03198, 1.32168, 0.2536),
  ('wall', 'spread_length', 1.32168, 1.69271, 0.4328),
  ('wall', 'spread_length', 1.69271, 2.09567, 0.5403),
  ('wall', 'spread_length', 2.09567, 2.1679, 0.6422),
  ('wall', 'spread_length', 2.1679, 2.39206, 0.944),
  ('wall', 'spread_length', 2.39206, 2.66501, 0.9817),
  ('wall', 'spread_length', 2.66501, 2.77649, 0.8591),
  ('wall', 'spread_length', 2.77649, 3.14564, 0.6245),
  ('wall', 'spread_length', 3.14564, 3.55593, 0.7824),
  ('wall', 'spread_length', 3.55593, 3.67323, 0.4795),
  ('wall', 'spread_length', 3.67323, 4.19322, 0.839),
  ('wall', 'spread_length', 4.19322, 4.55418, 0.57),
  ('wall', 'spread_length', 4.55418, 5.83266, 0.2302),
  ('wall', 'spread_length', 5.83266, 40, 0.003798);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_width', 0.003, 0.218726, 0.002708),
  ('wall', 'spread_width', 0.218726, 0.297055, 0.03647),
  ('wall', 'spread_width', 0.297055, 0.403435, 0.1021),
  ('wall', 'spread_width', 0.403435, 0.507016, 0.2513),
  ('wall', 'spread_width', 0.507016, 0.54791, 0.3565),
  ('wall', 'spread_width', 0.54791, 0.724751, 0.2976),
  ('wall', 'spread_width', 0.724751, 0.744125, 0.2973),
  ('wall', 'spread_width', 0.744125, 1.01061, 0.3196),
  ('wall', 'spread_width', 1.01061, 1.03899, 0.3532),
  ('wall', 'spread_width', 1.03899, 1.27826, 0.5038),
  ('wall', 'spread_width', 1.27826, 1.37252, 0.4339),
  ('wall', 'spread_width', 1.37252, 1.64676, 0.4525),
  ('wall', 'spread_width', 1.64676, 1.86403, 0.7279),
  ('wall', 'spread_width', 1.86403, 1.93778, 0.7121),
  ('wall', 'spread_width', 1.93778, 2.21623, 0.7617),
  ('wall', 'spread_width', 2.21623, 2.53157, 0.752),
  ('wall', 'spread_width', 2.53157, 2.60019, 0.6618),
  ('wall', 'spread_width', 2.60019, 3.43816, 0.3591),
  ('wall', 'spread_width', 3.43816, 20, 0.003596);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'tilt_deg', 0, 83.4152, 0.000114),
  ('wall', 'tilt_deg', 83.4152, 84.1469, 0.007711),
  ('wall', 'tilt_deg', 84.1469, 84.8785, 0.004558),
  ('wall', 'tilt_deg', 84.8785, 85.6101, 0.01243),
  ('wall', 'tilt_deg', 85.6101, 86.3418, 0.01808),
  ('wall', 'tilt_deg', 86.3418, 87.0734, 0.02507),
  ('wall', 'tilt_deg', 87.0734, 87.8051, 0.03173),
  ('wall', 'tilt_deg', 87.8051, 88.5367, 0.04241),
  ('wall', 'tilt_deg', 88.5367, 89.2684, 0.07537),
  ('wall', 'tilt_deg', 89.2684, 90, 1.136);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'width', 0.01, 0.262791, 0.003152),
  ('wall', 'width', 0.262791, 0.355125, 0.03871),
  ('wall', 'width', 0.355125, 0.4799, 0.07805),
  ('wall', 'width', 0.4799, 0.625946, 0.241),
  ('wall', 'width', 0.625946, 0.648517, 0.2811),
  ('wall', 'width', 0.648517, 0.876378, 0.2943),
  ('wall', 'width', 0.876378, 0.911241, 0.3535),
  ('wall', 'width', 0.911241, 1.1843, 0.3314),
  ('wall', 'width', 1.1843, 1.27037, 0.3173),
  ('wall', 'width', 1.27037, 1.60041, 0.4659),
  ('wall', 'width', 1.60041, 1.68316, 0.2793),
  ('wall', 'width', 1.68316, 2.16273, 0.2375),
  ('wall', 'width', 2.16273, 2.39618, 0.4032),
  ('wall', 'width', 2.39618, 2.64385, 1.23),
  ('wall', 'width', 2.64385, 2.8022, 1.644),
  ('wall', 'width', 2.8022, 2.92262, 1.343),
  ('wall', 'width', 2.92262, 3.09863, 1.175),
  ('wall', 'width', 3.09863, 3.86776, 0.4344),
  ('wall', 'width', 3.86776, 3.94951, 0.1121),
  ('wall', 'width', 3.94951, 12, 0.005336);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_max', -0.5, 0.625106, 0.007928),
  ('wall', 'z_max', 0.625106, 0.984585, 0.03553),
  ('wall', 'z_max', 0.984585, 1.34407, 0.1015),
  ('wall', 'z_max', 1.34407, 1.50352, 0.3145),
  ('wall', 'z_max', 1.50352, 1.70355, 0.2266),
  ('wall', 'z_max', 1.70355, 2.06302, 0.1317),
  ('wall', 'z_max', 2.06302, 2.33277, 0.09558),
  ('wall', 'z_max', 2.33277, 2.4225, 0.4816),
  ('wall', 'z_max', 2.4225, 2.47997, 1.059),
  ('wall', 'z_max', 2.47997, 2.59371, 1.023),
  ('wall', 'z_max', 2.59371, 2.72186, 0.856),
  ('wall', 'z_max', 2.72186, 2.78198, 1.245),
  ('wall', 'z_max', 2.78198, 2.84601, 0.5937),
  ('wall', 'z_max', 2.84601, 2.99546, 0.7257),
  ('wall', 'z_max', 2.99546, 3.14146, 0.6364),
  ('wall', 'z_max', 3.14146, 3.24077, 0.1596),
  ('wall', 'z_max', 3.24077, 3.50094, 0.206),
  ('wall', 'z_max', 3.50094, 3.86042, 0.1353),
  ('wall', 'z_max', 3.86042, 4, 0.07776);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_min', -0.5, -0.129322, 0.0391),
  ('wall', 'z_min', -0.129322, -0.0167107, 1.977),
  ('wall', 'z_min', -0.0167107, -0.0110617, 18.79),
  ('wall', 'z_min', -0.0110617, 0.00419596, 16.72),
  ('wall', 'z_min', 0.00419596, 0.0755953, 1.784),
  ('wall', 'z_min', 0.0755953, 0.222937, 0.299),
  ('wall', 'z_min', 0.222937, 0.280512, 0.2383),
  ('wall', 'z_min', 0.280512, 0.485429, 0.2155),
  ('wall', 'z_min', 0.485429, 0.684254, 0.3112),
  ('wall', 'z_min', 0.684254, 0.690346, 0.309),
  ('wall', 'z_min', 0.690346, 0.895263, 0.2164),
  ('wall', 'z_min', 0.895263, 1.10018, 0.1662),
  ('wall', 'z_min', 1.10018, 1.3051, 0.05253),
  ('wall', 'z_min', 1.3051, 1.51001, 0.01473),
  ('wall', 'z_min', 1.51001, 1.71493, 0.04656),
  ('wall', 'z_min', 1.71493, 4, 0.003012);

-- table: 214 examples
UPDATE object_class SET prior = 0.0467 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.3733, 0.6621)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5497, 0.3019)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7406, 0.1198)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.2837, 0.352)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.6929, 0.1298)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.129, 0.3363)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4647, 0.3807)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.6682, 0.5876)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2682, 0.3567)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.748, 0.12)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7344, 0.1193)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'table' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'area_m2', 0.002, 0.0831907, 0.002375),
  ('table', 'area_m2', 0.0831907, 0.119728, 0.03554),
  ('table', 'area_m2', 0.119728, 0.172311, 0.05956),
  ('table', 'area_m2', 0.172311, 0.24799, 0.1084),
  ('table', 'area_m2', 0.24799, 0.287416, 0.1533),
  ('table', 'area_m2', 0.287416, 0.356906, 0.2153),
  ('table', 'area_m2', 0.356906, 0.415892, 0.4281),
  ('table', 'area_m2', 0.415892, 0.513657, 0.3473),
  ('table', 'area_m2', 0.513657, 0.581875, 0.3546),
  ('table', 'area_m2', 0.581875, 0.703671, 0.5665),
  ('table', 'area_m2', 0.703671, 0.739253, 0.4946),
  ('table', 'area_m2', 0.739253, 0.89044, 0.4839),
  ('table', 'area_m2', 0.89044, 1.02791, 0.8052),
  ('table', 'area_m2', 1.02791, 1.06393, 1.072),
  ('table', 'area_m2', 1.06393, 1.15127, 0.8653),
  ('table', 'area_m2', 1.15127, 1.33616, 0.7061),
  ('table', 'area_m2', 1.33616, 1.5312, 0.3969),
  ('table', 'area_m2', 1.5312, 2.2037, 0.1406),
  ('table', 'area_m2', 2.2037, 100, 0.003003);
DELETE FROM class_density WHERE class = 'table' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'aspect', 1, 1.16475, 0.7355),
  ('table', 'aspect', 1.16475, 1.19432, 0.8276),
  ('table', 'aspect', 1.19432, 1.36982, 0.6798),
  ('table', 'aspect', 1.36982, 1.42639, 0.9345),
  ('table', 'aspect', 1.42639, 1.51515, 1.066),
  ('table', 'aspect', 1.51515, 1.69068, 1.157),
  ('table', 'aspect', 1.69068, 1.81461, 1.399),
  ('table', 'aspect', 1.81461, 1.95829, 1.434),
  ('table', 'aspect', 1.95829, 2.0346, 1.44),
  ('table', 'aspect', 2.0346, 2.13754, 1.325),
  ('table', 'aspect', 2.13754, 2.42995, 0.8159),
  ('table', 'aspect', 2.42995, 2.90214, 0.4166),
  ('table', 'aspect', 2.90214, 3.46607, 0.09366),
  ('table', 'aspect', 3.46607, 4.13959, 0.02629),
  ('table', 'aspect', 4.13959, 4.94398, 0.03158),
  ('table', 'aspect', 4.94398, 100, 0.003598);
DELETE FROM class_density WHERE class = 'table' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'height', -0.5, 0.0587154, 0.02372),
  ('table', 'height', 0.0587154, 0.176616, 0.0001877),
  ('table', 'height', 0.176616, 0.294517, 4.397e-05),
  ('table', 'height', 0.294517, 0.412418, 0.001347),
  ('table', 'height', 0.412418, 0.530319, 0.01648),
  ('table', 'height', 0.530319, 0.64822, 0.7499),
  ('table', 'height', 0.64822, 0.688289, 3.31),
  ('table', 'height', 0.688289, 0.708767, 5.405),
  ('table', 'height', 0.708767, 0.724016, 6.254),
  ('table', 'height', 0.724016, 0.738746, 6.373),
  ('table', 'height', 0.738746, 0.759146, 5.464),
  ('table', 'height', 0.759146, 0.766121, 4.995),
  ('table', 'height', 0.766121, 0.781327, 4.574),
  ('table', 'height', 0.781327, 0.83959, 2.195),
  ('table', 'height', 0.83959, 0.884022, 0.9943),
  ('table', 'height', 0.884022, 1.00192, 0.3997),
  ('table', 'height', 1.00192, 1.11982, 0.1824),
  ('table', 'height', 1.11982, 4, 0.002478);
DELETE FROM class_density WHERE class = 'table' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'length', 0.03, 0.560883, 0.003692),
  ('table', 'length', 0.560883, 0.673836, 0.1311),
  ('table', 'length', 0.673836, 0.802815, 0.4001),
  ('table', 'length', 0.802815, 0.972565, 0.4925),
  ('table', 'length', 0.972565, 0.993919, 1.063),
  ('table', 'length', 0.993919, 1.16842, 0.6359),
  ('table', 'length', 1.16842, 1.2029, 0.591),
  ('table', 'length', 1.2029, 1.30228, 1.29),
  ('table', 'length', 1.30228, 1.40373, 0.9272),
  ('table', 'length', 1.40373, 1.4535, 1.113),
  ('table', 'length', 1.4535, 1.62258, 1.056),
  ('table', 'length', 1.62258, 1.68642, 1.55),
  ('table', 'length', 1.68642, 1.75949, 1.204),
  ('table', 'length', 1.75949, 1.96076, 0.9841),
  ('table', 'length', 1.96076, 2.02603, 0.86),
  ('table', 'length', 2.02603, 2.43405, 0.3017),
  ('table', 'length', 2.43405, 2.92423, 0.105),
  ('table', 'length', 2.92423, 30, 0.004391);
DELETE FROM class_density WHERE class = 'table' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'rectangularity', 0, 0.378962, 0.02763),
  ('table', 'rectangularity', 0.378962, 0.444488, 0.4269),
  ('table', 'rectangularity', 0.444488, 0.509635, 1.075),
  ('table', 'rectangularity', 0.509635, 0.57554, 1.268),
  ('table', 'rectangularity', 0.57554, 0.60964, 1.042),
  ('table', 'rectangularity', 0.60964, 0.641067, 2.705),
  ('table', 'rectangularity', 0.641067, 0.64877, 2.025),
  ('table', 'rectangularity', 0.64877, 0.679062, 3.97),
  ('table', 'rectangularity', 0.679062, 0.706593, 2.334),
  ('table', 'rectangularity', 0.706593, 0.720626, 3.163),
  ('table', 'rectangularity', 0.720626, 0.755752, 3.028),
  ('table', 'rectangularity', 0.755752, 0.772119, 2.453),
  ('table', 'rectangularity', 0.772119, 0.795181, 3.168),
  ('table', 'rectangularity', 0.795181, 0.837645, 2.394),
  ('table', 'rectangularity', 0.837645, 0.843332, 1.636),
  ('table', 'rectangularity', 0.843332, 0.903171, 1.072),
  ('table', 'rectangularity', 0.903171, 0.960052, 0.6643),
  ('table', 'rectangularity', 0.960052, 0.968697, 0.3623),
  ('table', 'rectangularity', 0.968697, 1, 0.2346);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_length', 0.01, 0.484968, 0.003454),
  ('table', 'spread_length', 0.484968, 0.579419, 0.1455),
  ('table', 'spread_length', 0.579419, 0.692266, 0.2084),
  ('table', 'spread_length', 0.692266, 0.764313, 0.4322),
  ('table', 'spread_length', 0.764313, 0.827089, 0.8834),
  ('table', 'spread_length', 0.827089, 0.861999, 0.817),
  ('table', 'spread_length', 0.861999, 0.957542, 0.9692),
  ('table', 'spread_length', 0.957542, 0.988171, 0.6156),
  ('table', 'spread_length', 0.988171, 1.13326, 0.7247),
  ('table', 'spread_length', 1.13326, 1.18062, 0.9329),
  ('table', 'spread_length', 1.18062, 1.26718, 1.123),
  ('table', 'spread_length', 1.26718, 1.35767, 1.459),
  ('table', 'spread_length', 1.35767, 1.41056, 1.041),
  ('table', 'spread_length', 1.41056, 1.51132, 1.142),
  ('table', 'spread_length', 1.51132, 1.62283, 1.44),
  ('table', 'spread_length', 1.62283, 1.68528, 0.8707),
  ('table', 'spread_length', 1.68528, 2.0135, 0.3115),
  ('table', 'spread_length', 2.0135, 2.40564, 0.109),
  ('table', 'spread_length', 2.40564, 40, 0.003449);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_width', 0.003, 0.163097, 0.002887),
  ('table', 'spread_width', 0.163097, 0.20536, 0.05628),
  ('table', 'spread_width', 0.20536, 0.258574, 0.06501),
  ('table', 'spread_width', 0.258574, 0.325578, 0.1276),
  ('table', 'spread_width', 0.325578, 0.403539, 0.202),
  ('table', 'spread_width', 0.403539, 0.409945, 0.2817),
  ('table', 'spread_width', 0.409945, 0.509493, 0.4987),
  ('table', 'spread_width', 0.509493, 0.516173, 0.7265),
  ('table', 'spread_width', 0.516173, 0.605458, 0.6351),
  ('table', 'spread_width', 0.605458, 0.649929, 1.212),
  ('table', 'spread_width', 0.649929, 0.661215, 1.51),
  ('table', 'spread_width', 0.661215, 0.704927, 1.78),
  ('table', 'spread_width', 0.704927, 0.74881, 1.7),
  ('table', 'spread_width', 0.74881, 0.817437, 1.263),
  ('table', 'spread_width', 0.817437, 0.88976, 1.305),
  ('table', 'spread_width', 0.88976, 1.0304, 0.458),
  ('table', 'spread_width', 1.0304, 1.29741, 0.1536),
  ('table', 'spread_width', 1.29741, 20, 0.004284);
DELETE FROM class_density WHERE class = 'table' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'tilt_deg', 0, 0.13034, 1.046),
  ('table', 'tilt_deg', 0.13034, 0.304434, 1.016),
  ('table', 'tilt_deg', 0.304434, 0.518987, 0.8715),
  ('table', 'tilt_deg', 0.518987, 0.697063, 0.6478),
  ('table', 'tilt_deg', 0.697063, 1.04559, 0.4283),
  ('table', 'tilt_deg', 1.04559, 1.39413, 0.2786),
  ('table', 'tilt_deg', 1.39413, 1.74266, 0.1894),
  ('table', 'tilt_deg', 1.74266, 2.09119, 0.1139),
  ('table', 'tilt_deg', 2.09119, 2.43972, 0.04703),
  ('table', 'tilt_deg', 2.43972, 2.78825, 0.01893),
  ('table', 'tilt_deg', 2.78825, 3.13678, 0.0131),
  ('table', 'tilt_deg', 3.13678, 90, 5.527e-05);
DELETE FROM class_density WHERE class = 'table' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'width', 0.01, 0.220358, 0.002993),
  ('table', 'width', 0.220358, 0.278166, 0.07432),
  ('table', 'width', 0.278166, 0.351138, 0.0702),
  ('table', 'width', 0.351138, 0.443252, 0.135),
  ('table', 'width', 0.443252, 0.521264, 0.2721),
  ('table', 'width', 0.521264, 0.559532, 0.4482),
  ('table', 'width', 0.559532, 0.645521, 0.5244),
  ('table', 'width', 0.645521, 0.706316, 0.9405),
  ('table', 'width', 0.706316, 0.722242, 1.47),
  ('table', 'width', 0.722242, 0.78197, 1.347),
  ('table', 'width', 0.78197, 0.843537, 1.447),
  ('table', 'width', 0.843537, 0.891605, 1.777),
  ('table', 'width', 0.891605, 0.956535, 1.635),
  ('table', 'width', 0.956535, 1.05938, 1.043),
  ('table', 'width', 1.05938, 1.1255, 0.8024),
  ('table', 'width', 1.1255, 1.42076, 0.1949),
  ('table', 'width', 1.42076, 1.79347, 0.07522),
  ('table', 'width', 1.79347, 12, 0.004838);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_max', -0.5, 0.0715106, 0.0232),
  ('table', 'z_max', 0.0715106, 0.189944, 0.000113),
  ('table', 'z_max', 0.189944, 0.308378, 5.525e-05),
  ('table', 'z_max', 0.308378, 0.426812, 0.001615),
  ('table', 'z_max', 0.426812, 0.545246, 0.01877),
  ('table', 'z_max', 0.545246, 0.66368, 0.8317),
  ('table', 'z_max', 0.66368, 0.693393, 4.014),
  ('table', 'z_max', 0.693393, 0.71336, 5.444),
  ('table', 'z_max', 0.71336, 0.730305, 6.013),
  ('table', 'z_max', 0.730305, 0.747697, 6.288),
  ('table', 'z_max', 0.747697, 0.766785, 5.577),
  ('table', 'z_max', 0.766785, 0.782114, 4.813),
  ('table', 'z_max', 0.782114, 0.851244, 2.187),
  ('table', 'z_max', 0.851244, 0.900547, 0.8322),
  ('table', 'z_max', 0.900547, 1.01898, 0.3989),
  ('table', 'z_max', 1.01898, 1.13072, 0.1876),
  ('table', 'z_max', 1.13072, 1.13742, 0.2709),
  ('table', 'z_max', 1.13742, 4, 0.00143);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_min', -0.5, 0.0474232, 0.02416),
  ('table', 'z_min', 0.0474232, 0.164439, 0.0003982),
  ('table', 'z_min', 0.164439, 0.281455, 3.296e-05),
  ('table', 'z_min', 0.281455, 0.398472, 0.001072),
  ('table', 'z_min', 0.398472, 0.515488, 0.01403),
  ('table', 'z_min', 0.515488, 0.632504, 0.545),
  ('table', 'z_min', 0.632504, 0.644704, 3.009),
  ('table', 'z_min', 0.644704, 0.684086, 3.171),
  ('table', 'z_min', 0.684086, 0.704707, 5.36),
  ('table', 'z_min', 0.704707, 0.720196, 5.991),
  ('table', 'z_min', 0.720196, 0.735172, 6.342),
  ('table', 'z_min', 0.735172, 0.74952, 5.595),
  ('table', 'z_min', 0.74952, 0.756188, 5.016),
  ('table', 'z_min', 0.756188, 0.777835, 4.687),
  ('table', 'z_min', 0.777835, 0.832082, 2.311),
  ('table', 'z_min', 0.832082, 0.866536, 1.2),
  ('table', 'z_min', 0.866536, 0.983552, 0.4142),
  ('table', 'z_min', 0.983552, 1.10057, 0.1856),
  ('table', 'z_min', 1.10057, 4, 0.003178);

-- flat_screen: 178 examples
UPDATE object_class SET prior = 0.03891 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.814, 0.4396)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.4319, 0.2255)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.031, 0.1194)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.5615, 0.3011)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.7842, 0.1292)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7457, 0.2356)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.203, 0.1942)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.05, 3.579)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -0.9935, 0.2433)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.193, 0.1248)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7901, 0.1775)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'area_m2', 0.002, 0.0457207, 0.002957),
  ('flat_screen', 'area_m2', 0.0457207, 0.0585869, 0.05433),
  ('flat_screen', 'area_m2', 0.0585869, 0.0750737, 0.1093),
  ('flat_screen', 'area_m2', 0.0750737, 0.095773, 0.2731),
  ('flat_screen', 'area_m2', 0.095773, 0.117096, 0.5022),
  ('flat_screen', 'area_m2', 0.117096, 0.123272, 0.9558),
  ('flat_screen', 'area_m2', 0.123272, 0.137317, 0.6076),
  ('flat_screen', 'area_m2', 0.137317, 0.157559, 0.8223),
  ('flat_screen', 'area_m2', 0.157559, 0.176647, 0.967),
  ('flat_screen', 'area_m2', 0.176647, 0.202413, 0.7176),
  ('flat_screen', 'area_m2', 0.202413, 0.208058, 0.5348),
  ('flat_screen', 'area_m2', 0.208058, 0.238597, 0.8179),
  ('flat_screen', 'area_m2', 0.238597, 0.259374, 1.088),
  ('flat_screen', 'area_m2', 0.259374, 0.269406, 0.5852),
  ('flat_screen', 'area_m2', 0.269406, 0.332363, 0.3491),
  ('flat_screen', 'area_m2', 0.332363, 0.425893, 0.09845),
  ('flat_screen', 'area_m2', 0.425893, 100, 0.001684);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'aspect', 1, 1.12786, 0.5571),
  ('flat_screen', 'aspect', 1.12786, 1.18638, 0.7167),
  ('flat_screen', 'aspect', 1.18638, 1.27206, 1.508),
  ('flat_screen', 'aspect', 1.27206, 1.38234, 1.534),
  ('flat_screen', 'aspect', 1.38234, 1.4347, 1.521),
  ('flat_screen', 'aspect', 1.4347, 1.49059, 1.428),
  ('flat_screen', 'aspect', 1.49059, 1.58931, 1.82),
  ('flat_screen', 'aspect', 1.58931, 1.61814, 3.313),
  ('flat_screen', 'aspect', 1.61814, 1.63695, 3.217),
  ('flat_screen', 'aspect', 1.63695, 1.73524, 1.963),
  ('flat_screen', 'aspect', 1.73524, 1.82503, 0.787),
  ('flat_screen', 'aspect', 1.82503, 2.05837, 0.6171),
  ('flat_screen', 'aspect', 2.05837, 2.0893, 0.4249),
  ('flat_screen', 'aspect', 2.0893, 2.32154, 0.3961),
  ('flat_screen', 'aspect', 2.32154, 2.61837, 0.2983),
  ('flat_screen', 'aspect', 2.61837, 2.95314, 0.1383),
  ('flat_screen', 'aspect', 2.95314, 100, 0.002976);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'height', -0.5, 0.679012, 0.009014),
  ('flat_screen', 'height', 0.679012, 0.758725, 0.008358),
  ('flat_screen', 'height', 0.758725, 0.838438, 0.1961),
  ('flat_screen', 'height', 0.838438, 0.91815, 0.98),
  ('flat_screen', 'height', 0.91815, 0.92519, 1.832),
  ('flat_screen', 'height', 0.92519, 0.960674, 3.26),
  ('flat_screen', 'height', 0.960674, 0.984556, 4.554),
  ('flat_screen', 'height', 0.984556, 0.997863, 5.797),
  ('flat_screen', 'height', 0.997863, 1.01954, 5.77),
  ('flat_screen', 'height', 1.01954, 1.04107, 4.652),
  ('flat_screen', 'height', 1.04107, 1.07516, 3.489),
  ('flat_screen', 'height', 1.07516, 1.15729, 1.398),
  ('flat_screen', 'height', 1.15729, 1.16936, 0.8044),
  ('flat_screen', 'height', 1.16936, 1.237, 0.5252),
  ('flat_screen', 'height', 1.237, 1.31671, 0.3159),
  ('flat_screen', 'height', 1.31671, 1.39643, 0.5278),
  ('flat_screen', 'height', 1.39643, 4, 0.00347);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'length', 0.03, 0.284212, 0.004065),
  ('flat_screen', 'length', 0.284212, 0.333912, 0.1392),
  ('flat_screen', 'length', 0.333912, 0.392302, 0.4272),
  ('flat_screen', 'length', 0.392302, 0.40069, 0.6748),
  ('flat_screen', 'length', 0.40069, 0.447026, 0.9802),
  ('flat_screen', 'length', 0.447026, 0.460903, 1.105),
  ('flat_screen', 'length', 0.460903, 0.501755, 0.8642),
  ('flat_screen', 'length', 0.501755, 0.540093, 1.643),
  ('flat_screen', 'length', 0.540093, 0.586039, 1.358),
  ('flat_screen', 'length', 0.586039, 0.634994, 1.376),
  ('flat_screen', 'length', 0.634994, 0.717512, 0.8983),
  ('flat_screen', 'length', 0.717512, 0.74744, 0.9973),
  ('flat_screen', 'length', 0.74744, 0.839426, 0.5755),
  ('flat_screen', 'length', 0.839426, 0.878144, 0.4061),
  ('flat_screen', 'length', 0.878144, 1.0317, 0.3141),
  ('flat_screen', 'length', 1.0317, 1.21211, 0.1829),
  ('flat_screen', 'length', 1.21211, 30, 0.004022);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'rectangularity', 0, 0.465904, 0.02207),
  ('flat_screen', 'rectangularity', 0.465904, 0.525158, 0.2197),
  ('flat_screen', 'rectangularity', 0.525158, 0.584412, 0.914),
  ('flat_screen', 'rectangularity', 0.584412, 0.601576, 1.983),
  ('flat_screen', 'rectangularity', 0.601576, 0.643667, 0.9873),
  ('flat_screen', 'rectangularity', 0.643667, 0.674759, 2.111),
  ('flat_screen', 'rectangularity', 0.674759, 0.702921, 3.361),
  ('flat_screen', 'rectangularity', 0.702921, 0.70932, 2.355),
  ('flat_screen', 'rectangularity', 0.70932, 0.762175, 1.838),
  ('flat_screen', 'rectangularity', 0.762175, 0.770138, 2.296),
  ('flat_screen', 'rectangularity', 0.770138, 0.821429, 1.718),
  ('flat_screen', 'rectangularity', 0.821429, 0.832224, 2.274),
  ('flat_screen', 'rectangularity', 0.832224, 0.866895, 3.447),
  ('flat_screen', 'rectangularity', 0.866895, 0.880683, 3.907),
  ('flat_screen', 'rectangularity', 0.880683, 0.897552, 2.721),
  ('flat_screen', 'rectangularity', 0.897552, 0.939938, 1.944),
  ('flat_screen', 'rectangularity', 0.939938, 0.947492, 4.664),
  ('flat_screen', 'rectangularity', 0.947492, 0.982171, 2.751),
  ('flat_screen', 'rectangularity', 0.982171, 1, 0.6255);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_length', 0.01, 0.285092, 0.0028),
  ('flat_screen', 'spread_length', 0.285092, 0.327068, 0.1951),
  ('flat_screen', 'spread_length', 0.327068, 0.349557, 1.188),
  ('flat_screen', 'spread_length', 0.349557, 0.375225, 1.098),
  ('flat_screen', 'spread_length', 0.375225, 0.380763, 1.192),
  ('flat_screen', 'spread_length', 0.380763, 0.430472, 1.026),
  ('flat_screen', 'spread_length', 0.430472, 0.458168, 1.741),
  ('flat_screen', 'spread_length', 0.458168, 0.493853, 1.255),
  ('flat_screen', 'spread_length', 0.493853, 0.506579, 1.216),
  ('flat_screen', 'spread_length', 0.506579, 0.529732, 2.176),
  ('flat_screen', 'spread_length', 0.529732, 0.558702, 1.967),
  ('flat_screen', 'spread_length', 0.558702, 0.566566, 1.31),
  ('flat_screen', 'spread_length', 0.566566, 0.607769, 1.325),
  ('flat_screen', 'spread_length', 0.607769, 0.649985, 0.5719),
  ('flat_screen', 'spread_length', 0.649985, 0.745687, 0.313),
  ('flat_screen', 'spread_length', 0.745687, 0.855479, 0.1255),
  ('flat_screen', 'spread_length', 0.855479, 0.981437, 0.06585),
  ('flat_screen', 'spread_length', 0.981437, 40, 0.00245);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_width', 0.003, 0.149711, 0.00279),
  ('flat_screen', 'spread_width', 0.149711, 0.168461, 0.103),
  ('flat_screen', 'spread_width', 0.168461, 0.18956, 0.1737),
  ('flat_screen', 'spread_width', 0.18956, 0.213302, 0.1581),
  ('flat_screen', 'spread_width', 0.213302, 0.240017, 0.2777),
  ('flat_screen', 'spread_width', 0.240017, 0.246481, 0.5648),
  ('flat_screen', 'spread_width', 0.246481, 0.270078, 1.241),
  ('flat_screen', 'spread_width', 0.270078, 0.284129, 2.171),
  ('flat_screen', 'spread_width', 0.284129, 0.299994, 2.114),
  ('flat_screen', 'spread_width', 0.299994, 0.303904, 2.303),
  ('flat_screen', 'spread_width', 0.303904, 0.316652, 2.156),
  ('flat_screen', 'spread_width', 0.316652, 0.328926, 2.479),
  ('flat_screen', 'spread_width', 0.328926, 0.341966, 1.962),
  ('flat_screen', 'spread_width', 0.341966, 0.351515, 1.548),
  ('flat_screen', 'spread_width', 0.351515, 0.373094, 1.927),
  ('flat_screen', 'spread_width', 0.373094, 0.384796, 1.795),
  ('flat_screen', 'spread_width', 0.384796, 0.43299, 0.3253),
  ('flat_screen', 'spread_width', 0.43299, 20, 0.002957);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'tilt_deg', 0, 74.8943, 0.0001337),
  ('flat_screen', 'tilt_deg', 74.8943, 76.5727, 0.00476),
  ('flat_screen', 'tilt_deg', 76.5727, 78.2511, 0.00348),
  ('flat_screen', 'tilt_deg', 78.2511, 79.9295, 0.03794),
  ('flat_screen', 'tilt_deg', 79.9295, 80.3138, 0.05747),
  ('flat_screen', 'tilt_deg', 80.3138, 81.6079, 0.07845),
  ('flat_screen', 'tilt_deg', 81.6079, 81.779, 0.06936),
  ('flat_screen', 'tilt_deg', 81.779, 83.1769, 0.07302),
  ('flat_screen', 'tilt_deg', 83.1769, 84.7025, 0.07782),
  ('flat_screen', 'tilt_deg', 84.7025, 84.9648, 0.08493),
  ('flat_screen', 'tilt_deg', 84.9648, 85.9342, 0.09541),
  ('flat_screen', 'tilt_deg', 85.9342, 86.6432, 0.07872),
  ('flat_screen', 'tilt_deg', 86.6432, 87.5859, 0.05884),
  ('flat_screen', 'tilt_deg', 87.5859, 88.3216, 0.08449),
  ('flat_screen', 'tilt_deg', 88.3216, 88.7023, 0.1537),
  ('flat_screen', 'tilt_deg', 88.7023, 89.1604, 0.1968),
  ('flat_screen', 'tilt_deg', 89.1604, 90, 0.1422);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'width', 0.01, 0.179186, 0.003532),
  ('flat_screen', 'width', 0.179186, 0.20693, 0.09664),
  ('flat_screen', 'width', 0.20693, 0.238968, 0.1828),
  ('flat_screen', 'width', 0.238968, 0.274397, 0.4563),
  ('flat_screen', 'width', 0.274397, 0.306831, 0.9244),
  ('flat_screen', 'width', 0.306831, 0.318695, 0.6002),
  ('flat_screen', 'width', 0.318695, 0.348925, 1.144),
  ('flat_screen', 'width', 0.348925, 0.368038, 1.656),
  ('flat_screen', 'width', 0.368038, 0.371609, 1.959),
  ('flat_screen', 'width', 0.371609, 0.391412, 2.048),
  ('flat_screen', 'width', 0.391412, 0.416747, 1.674),
  ('flat_screen', 'width', 0.416747, 0.425021, 1.848),
  ('flat_screen', 'width', 0.425021, 0.442292, 1.873),
  ('flat_screen', 'width', 0.442292, 0.469781, 1.83),
  ('flat_screen', 'width', 0.469781, 0.490827, 0.9669),
  ('flat_screen', 'width', 0.490827, 0.566821, 0.2559),
  ('flat_screen', 'width', 0.566821, 0.654581, 0.1786),
  ('flat_screen', 'width', 0.654581, 12, 0.004142);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_max', -0.5, 0.860771, 0.007915),
  ('flat_screen', 'z_max', 0.860771, 0.941212, 0.01537),
  ('flat_screen', 'z_max', 0.941212, 1.02165, 0.3645),
  ('flat_screen', 'z_max', 1.02165, 1.08042, 1.334),
  ('flat_screen', 'z_max', 1.08042, 1.10209, 3.136),
  ('flat_screen', 'z_max', 1.10209, 1.11022, 4.179),
  ('flat_screen', 'z_max', 1.11022, 1.13755, 4.388),
  ('flat_screen', 'z_max', 1.13755, 1.15594, 4.808),
  ('flat_screen', 'z_max', 1.15594, 1.18074, 4.604),
  ('flat_screen', 'z_max', 1.18074, 1.20574, 4.486),
  ('flat_screen', 'z_max', 1.20574, 1.24085, 3.268),
  ('flat_screen', 'z_max', 1.24085, 1.26297, 1.448),
  ('flat_screen', 'z_max', 1.26297, 1.34341, 0.8833),
  ('flat_screen', 'z_max', 1.34341, 1.36099, 0.6721),
  ('flat_screen', 'z_max', 1.36099, 1.42385, 0.6676),
  ('flat_screen', 'z_max', 1.42385, 1.5043, 0.4552),
  ('flat_screen', 'z_max', 1.5043, 1.58277, 0.3826),
  ('flat_screen', 'z_max', 1.58277, 4, 0.00226);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_min', -0.5, -0.0281239, 0.01157),
  ('flat_screen', 'z_min', -0.0281239, -0.0190383, 0.155),
  ('flat_screen', 'z_min', -0.0190383, 0.112996, 0.09479),
  ('flat_screen', 'z_min', 0.112996, 0.254115, 0.01238),
  ('flat_screen', 'z_min', 0.254115, 0.395234, 0.005285),
  ('flat_screen', 'z_min', 0.395234, 0.536354, 0.02985),
  ('flat_screen', 'z_min', 0.536354, 0.664166, 0.7348),
  ('flat_screen', 'z_min', 0.664166, 0.677473, 3.365),
  ('flat_screen', 'z_min', 0.677473, 0.696365, 3.305),
  ('flat_screen', 'z_min', 0.696365, 0.733482, 3.17),
  ('flat_screen', 'z_min', 0.733482, 0.754687, 4.262),
  ('flat_screen', 'z_min', 0.754687, 0.801957, 2.77),
  ('flat_screen', 'z_min', 0.801957, 0.818593, 2.681),
  ('flat_screen', 'z_min', 0.818593, 0.840703, 2.657),
  ('flat_screen', 'z_min', 0.840703, 0.880797, 2.562),
  ('flat_screen', 'z_min', 0.880797, 0.959712, 1.353),
  ('flat_screen', 'z_min', 0.959712, 1.10083, 0.485),
  ('flat_screen', 'z_min', 1.10083, 1.24195, 0.3091),
  ('flat_screen', 'z_min', 1.24195, 4, 0.003215);

-- keyboard: 115 examples
UPDATE object_class SET prior = 0.02519 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.777, 0.38)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.771, 0.3042)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7833, 0.1039)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.9072, 0.2662)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8317, 0.07901)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.97, 0.2807)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.837, 0.1341)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.882, 2.116)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.68, 0.2163)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7911, 0.105)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7759, 0.1029)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'area_m2', 0.002, 0.016951, 0.003446),
  ('keyboard', 'area_m2', 0.016951, 0.0215138, 0.0772),
  ('keyboard', 'area_m2', 0.0215138, 0.0273047, 0.05747),
  ('keyboard', 'area_m2', 0.0273047, 0.0346544, 0.1676),
  ('keyboard', 'area_m2', 0.0346544, 0.0419219, 0.2263),
  ('keyboard', 'area_m2', 0.0419219, 0.0439824, 0.3765),
  ('keyboard', 'area_m2', 0.0439824, 0.0515737, 0.5382),
  ('keyboard', 'area_m2', 0.0515737, 0.0558213, 0.8775),
  ('keyboard', 'area_m2', 0.0558213, 0.0580935, 1.442),
  ('keyboard', 'area_m2', 0.0580935, 0.0627203, 1.342),
  ('keyboard', 'area_m2', 0.0627203, 0.0679057, 1.289),
  ('keyboard', 'area_m2', 0.0679057, 0.0708468, 1.011),
  ('keyboard', 'area_m2', 0.0708468, 0.0748595, 1.217),
  ('keyboard', 'area_m2', 0.0748595, 0.0809519, 1.331),
  ('keyboard', 'area_m2', 0.0809519, 0.0899168, 1.075),
  ('keyboard', 'area_m2', 0.0899168, 0.11412, 0.3422),
  ('keyboard', 'area_m2', 0.11412, 0.144838, 0.101),
  ('keyboard', 'area_m2', 0.144838, 100, 0.001366);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'aspect', 1, 1.16094, 0.2986),
  ('keyboard', 'aspect', 1.16094, 1.34252, 0.2909),
  ('keyboard', 'aspect', 1.34252, 1.43577, 0.2943),
  ('keyboard', 'aspect', 1.43577, 1.55249, 0.3521),
  ('keyboard', 'aspect', 1.55249, 1.74488, 0.7724),
  ('keyboard', 'aspect', 1.74488, 1.79531, 0.8319),
  ('keyboard', 'aspect', 1.79531, 1.94446, 1.13),
  ('keyboard', 'aspect', 1.94446, 2.07611, 1.266),
  ('keyboard', 'aspect', 2.07611, 2.11144, 1.162),
  ('keyboard', 'aspect', 2.11144, 2.2983, 1.279),
  ('keyboard', 'aspect', 2.2983, 2.40082, 1.02),
  ('keyboard', 'aspect', 2.40082, 2.59679, 1.089),
  ('keyboard', 'aspect', 2.59679, 2.77631, 1.172),
  ('keyboard', 'aspect', 2.77631, 3.0593, 1.285),
  ('keyboard', 'aspect', 3.0593, 3.21054, 0.9328),
  ('keyboard', 'aspect', 3.21054, 3.71268, 0.4091),
  ('keyboard', 'aspect', 3.71268, 100, 0.004031);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'height', -0.5, 0.616826, 0.01324),
  ('keyboard', 'height', 0.616826, 0.677239, 1.38),
  ('keyboard', 'height', 0.677239, 0.68529, 1.881),
  ('keyboard', 'height', 0.68529, 0.716664, 3.619),
  ('keyboard', 'height', 0.716664, 0.732787, 6.223),
  ('keyboard', 'height', 0.732787, 0.751352, 5.983),
  ('keyboard', 'height', 0.751352, 0.76628, 5.709),
  ('keyboard', 'height', 0.76628, 0.795518, 4.77),
  ('keyboard', 'height', 0.795518, 0.81976, 4.256),
  ('keyboard', 'height', 0.81976, 0.858479, 1.853),
  ('keyboard', 'height', 0.858479, 0.895971, 1.166),
  ('keyboard', 'height', 0.895971, 0.918892, 0.9381),
  ('keyboard', 'height', 0.918892, 0.979305, 0.6463),
  ('keyboard', 'height', 0.979305, 1.03972, 0.2646),
  ('keyboard', 'height', 1.03972, 1.10013, 0.1845),
  ('keyboard', 'height', 1.10013, 1.16054, 0.3587),
  ('keyboard', 'height', 1.16054, 4, 0.003183);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'length', 0.03, 0.168294, 0.007286),
  ('keyboard', 'length', 0.168294, 0.192591, 0.1302),
  ('keyboard', 'length', 0.192591, 0.220397, 0.1913),
  ('keyboard', 'length', 0.220397, 0.252217, 0.1505),
  ('keyboard', 'length', 0.252217, 0.28863, 0.1442),
  ('keyboard', 'length', 0.28863, 0.303861, 0.5012),
  ('keyboard', 'length', 0.303861, 0.330302, 1.025),
  ('keyboard', 'length', 0.330302, 0.340808, 0.813),
  ('keyboard', 'length', 0.340808, 0.377989, 0.5198),
  ('keyboard', 'length', 0.377989, 0.421249, 0.658),
  ('keyboard', 'length', 0.421249, 0.432562, 2.271),
  ('keyboard', 'length', 0.432562, 0.438817, 3.212),
  ('keyboard', 'length', 0.438817, 0.45192, 3.684),
  ('keyboard', 'length', 0.45192, 0.462594, 3.908),
  ('keyboard', 'length', 0.462594, 0.474808, 3.534),
  ('keyboard', 'length', 0.474808, 0.495013, 2.398),
  ('keyboard', 'length', 0.495013, 0.504161, 1.506),
  ('keyboard', 'length', 0.504161, 0.566481, 0.8236),
  ('keyboard', 'length', 0.566481, 30, 0.005258);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'rectangularity', 0, 0.64702, 0.01522),
  ('keyboard', 'rectangularity', 0.64702, 0.684162, 0.6478),
  ('keyboard', 'rectangularity', 0.684162, 0.721304, 1.415),
  ('keyboard', 'rectangularity', 0.721304, 0.733409, 2.21),
  ('keyboard', 'rectangularity', 0.733409, 0.758447, 3.48),
  ('keyboard', 'rectangularity', 0.758447, 0.762197, 3.194),
  ('keyboard', 'rectangularity', 0.762197, 0.795589, 3.408),
  ('keyboard', 'rectangularity', 0.795589, 0.82349, 4.374),
  ('keyboard', 'rectangularity', 0.82349, 0.832731, 7.443),
  ('keyboard', 'rectangularity', 0.832731, 0.838657, 6.18),
  ('keyboard', 'rectangularity', 0.838657, 0.869874, 3.558),
  ('keyboard', 'rectangularity', 0.869874, 0.89113, 5.246),
  ('keyboard', 'rectangularity', 0.89113, 0.907016, 2.275),
  ('keyboard', 'rectangularity', 0.907016, 0.940135, 1.97),
  ('keyboard', 'rectangularity', 0.940135, 0.944158, 2.474),
  ('keyboard', 'rectangularity', 0.944158, 0.967191, 3.819),
  ('keyboard', 'rectangularity', 0.967191, 0.9813, 1.581),
  ('keyboard', 'rectangularity', 0.9813, 1, 0.1206);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_length', 0.01, 0.150565, 0.003057),
  ('keyboard', 'spread_length', 0.150565, 0.15514, 0.1265),
  ('keyboard', 'spread_length', 0.15514, 0.172364, 0.1786),
  ('keyboard', 'spread_length', 0.172364, 0.19732, 0.2023),
  ('keyboard', 'spread_length', 0.19732, 0.225889, 0.107),
  ('keyboard', 'spread_length', 0.225889, 0.258595, 0.08831),
  ('keyboard', 'spread_length', 0.258595, 0.286029, 0.3164),
  ('keyboard', 'spread_length', 0.286029, 0.296036, 1.114),
  ('keyboard', 'spread_length', 0.296036, 0.313584, 1.352),
  ('keyboard', 'spread_length', 0.313584, 0.338897, 0.7586),
  ('keyboard', 'spread_length', 0.338897, 0.387965, 0.3717),
  ('keyboard', 'spread_length', 0.387965, 0.397266, 0.7537),
  ('keyboard', 'spread_length', 0.397266, 0.417342, 1.994),
  ('keyboard', 'spread_length', 0.417342, 0.432376, 2.848),
  ('keyboard', 'spread_length', 0.432376, 0.444137, 2.767),
  ('keyboard', 'spread_length', 0.444137, 0.449184, 3.161),
  ('keyboard', 'spread_length', 0.449184, 0.46061, 3.799),
  ('keyboard', 'spread_length', 0.46061, 0.47291, 3.93),
  ('keyboard', 'spread_length', 0.47291, 0.508441, 1.556),
  ('keyboard', 'spread_length', 0.508441, 40, 0.004474);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_width', 0.003, 0.108757, 0.001101),
  ('keyboard', 'spread_width', 0.108757, 0.111825, 0.1615),
  ('keyboard', 'spread_width', 0.111825, 0.118007, 0.2568),
  ('keyboard', 'spread_width', 0.118007, 0.128044, 0.4659),
  ('keyboard', 'spread_width', 0.128044, 0.138934, 0.802),
  ('keyboard', 'spread_width', 0.138934, 0.144373, 2.368),
  ('keyboard', 'spread_width', 0.144373, 0.149842, 2.887),
  ('keyboard', 'spread_width', 0.149842, 0.156746, 2.91),
  ('keyboard', 'spread_width', 0.156746, 0.162256, 3.278),
  ('keyboard', 'spread_width', 0.162256, 0.166654, 3.366),
  ('keyboard', 'spread_width', 0.166654, 0.177484, 2.016),
  ('keyboard', 'spread_width', 0.177484, 0.18914, 1.563),
  ('keyboard', 'spread_width', 0.18914, 0.19258, 1.584),
  ('keyboard', 'spread_width', 0.19258, 0.208959, 0.7312),
  ('keyboard', 'spread_width', 0.208959, 0.226731, 0.2054),
  ('keyboard', 'spread_width', 0.226731, 20, 0.002294);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'tilt_deg', 0, 0.141763, 0.04504),
  ('keyboard', 'tilt_deg', 0.141763, 0.895136, 0.1021),
  ('keyboard', 'tilt_deg', 0.895136, 1.07716, 0.1482),
  ('keyboard', 'tilt_deg', 1.07716, 1.71167, 0.1659),
  ('keyboard', 'tilt_deg', 1.71167, 2.67833, 0.1223),
  ('keyboard', 'tilt_deg', 2.67833, 3.58054, 0.1177),
  ('keyboard', 'tilt_deg', 3.58054, 4.3642, 0.1424),
  ('keyboard', 'tilt_deg', 4.3642, 5.08425, 0.1633),
  ('keyboard', 'tilt_deg', 5.08425, 5.37082, 0.1657),
  ('keyboard', 'tilt_deg', 5.37082, 5.85962, 0.143),
  ('keyboard', 'tilt_deg', 5.85962, 6.26595, 0.1595),
  ('keyboard', 'tilt_deg', 6.26595, 6.65035, 0.1027),
  ('keyboard', 'tilt_deg', 6.65035, 7.16109, 0.1028),
  ('keyboard', 'tilt_deg', 7.16109, 8.05622, 0.05009),
  ('keyboard', 'tilt_deg', 8.05622, 90, 0.0001448);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'width', 0.01, 0.124384, 0.004164),
  ('keyboard', 'width', 0.124384, 0.141092, 0.428),
  ('keyboard', 'width', 0.141092, 0.147667, 1.288),
  ('keyboard', 'width', 0.147667, 0.153878, 2.377),
  ('keyboard', 'width', 0.153878, 0.160044, 2.141),
  ('keyboard', 'width', 0.160044, 0.162552, 1.628),
  ('keyboard', 'width', 0.162552, 0.178209, 1.297),
  ('keyboard', 'width', 0.178209, 0.181541, 1.439),
  ('keyboard', 'width', 0.181541, 0.188492, 1.749),
  ('keyboard', 'width', 0.188492, 0.199758, 1.846),
  ('keyboard', 'width', 0.199758, 0.205926, 1.659),
  ('keyboard', 'width', 0.205926, 0.219437, 1.285),
  ('keyboard', 'width', 0.219437, 0.233587, 1.101),
  ('keyboard', 'width', 0.233587, 0.242157, 0.9225),
  ('keyboard', 'width', 0.242157, 0.264963, 0.6304),
  ('keyboard', 'width', 0.264963, 0.300553, 0.2831),
  ('keyboard', 'width', 0.300553, 0.340924, 0.0663),
  ('keyboard', 'width', 0.340924, 0.386718, 0.03811),
  ('keyboard', 'width', 0.386718, 12, 0.003189);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_max', -0.5, 0.625795, 0.01268),
  ('keyboard', 'z_max', 0.625795, 0.686574, 1.564),
  ('keyboard', 'z_max', 0.686574, 0.722784, 3.198),
  ('keyboard', 'z_max', 0.722784, 0.73846, 6.242),
  ('keyboard', 'z_max', 0.73846, 0.747353, 6.044),
  ('keyboard', 'z_max', 0.747353, 0.761379, 5.658),
  ('keyboard', 'z_max', 0.761379, 0.775959, 5.443),
  ('keyboard', 'z_max', 0.775959, 0.803807, 4.354),
  ('keyboard', 'z_max', 0.803807, 0.82807, 4.257),
  ('keyboard', 'z_max', 0.82807, 0.868911, 2.064),
  ('keyboard', 'z_max', 0.868911, 0.903929, 1.076),
  ('keyboard', 'z_max', 0.903929, 0.92969, 0.8715),
  ('keyboard', 'z_max', 0.92969, 0.990469, 0.6096),
  ('keyboard', 'z_max', 0.990469, 1.05125, 0.2816),
  ('keyboard', 'z_max', 1.05125, 1.11203, 0.1885),
  ('keyboard', 'z_max', 1.11203, 1.17281, 0.3451),
  ('keyboard', 'z_max', 1.17281, 4, 0.003187);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_min', -0.5, 0.605324, 0.01363),
  ('keyboard', 'z_min', 0.605324, 0.665723, 1.147),
  ('keyboard', 'z_min', 0.665723, 0.680124, 2.151),
  ('keyboard', 'z_min', 0.680124, 0.710555, 3.753),
  ('keyboard', 'z_min', 0.710555, 0.724962, 5.904),
  ('keyboard', 'z_min', 0.724962, 0.744873, 6.027),
  ('keyboard', 'z_min', 0.744873, 0.76311, 5.91),
  ('keyboard', 'z_min', 0.76311, 0.785086, 5.328),
  ('keyboard', 'z_min', 0.785086, 0.8102, 4.175),
  ('keyboard', 'z_min', 0.8102, 0.846919, 1.796),
  ('keyboard', 'z_min', 0.846919, 0.889837, 1.232),
  ('keyboard', 'z_min', 0.889837, 0.907318, 0.9923),
  ('keyboard', 'z_min', 0.907318, 0.967716, 0.7004),
  ('keyboard', 'z_min', 0.967716, 1.02812, 0.246),
  ('keyboard', 'z_min', 1.02812, 1.08851, 0.1791),
  ('keyboard', 'z_min', 1.08851, 1.14891, 0.3648),
  ('keyboard', 'z_min', 1.14891, 4, 0.003332);

-- chair_seat: 139 examples
UPDATE object_class SET prior = 0.03046 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.067, 0.5543)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.3119, 0.2966)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4731, 0.03377)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7228, 0.1934)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7487, 0.1396)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7656, 0.1859)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.223, 0.3865)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 1.111, 0.9374)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.035, 0.3625)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4779, 0.03387)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4695, 0.03411)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'area_m2', 0.002, 0.0252938, 0.003526),
  ('chair_seat', 'area_m2', 0.0252938, 0.0331273, 0.07678),
  ('chair_seat', 'area_m2', 0.0331273, 0.0433868, 0.1306),
  ('chair_seat', 'area_m2', 0.0433868, 0.0568237, 0.141),
  ('chair_seat', 'area_m2', 0.0568237, 0.0596666, 0.1745),
  ('chair_seat', 'area_m2', 0.0596666, 0.0744221, 0.2885),
  ('chair_seat', 'area_m2', 0.0744221, 0.086141, 0.3531),
  ('chair_seat', 'area_m2', 0.086141, 0.0974706, 0.3745),
  ('chair_seat', 'area_m2', 0.0974706, 0.107811, 0.5901),
  ('chair_seat', 'area_m2', 0.107811, 0.127657, 0.4268),
  ('chair_seat', 'area_m2', 0.127657, 0.145249, 0.4433),
  ('chair_seat', 'area_m2', 0.145249, 0.165141, 0.7899),
  ('chair_seat', 'area_m2', 0.165141, 0.183685, 1.108),
  ('chair_seat', 'area_m2', 0.183685, 0.194073, 1.513),
  ('chair_seat', 'area_m2', 0.194073, 0.21621, 1.083),
  ('chair_seat', 'area_m2', 0.21621, 0.286409, 0.3791),
  ('chair_seat', 'area_m2', 0.286409, 100, 0.002022);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'aspect', 1, 1.03602, 3.015),
  ('chair_seat', 'aspect', 1.03602, 1.08416, 2.343),
  ('chair_seat', 'aspect', 1.08416, 1.12598, 2.816),
  ('chair_seat', 'aspect', 1.12598, 1.14107, 2.422),
  ('chair_seat', 'aspect', 1.14107, 1.16903, 3.264),
  ('chair_seat', 'aspect', 1.16903, 1.25237, 1.66),
  ('chair_seat', 'aspect', 1.25237, 1.30204, 1.122),
  ('chair_seat', 'aspect', 1.30204, 1.3863, 0.9973),
  ('chair_seat', 'aspect', 1.3863, 1.48572, 0.6318),
  ('chair_seat', 'aspect', 1.48572, 1.69531, 0.4178),
  ('chair_seat', 'aspect', 1.69531, 1.76929, 0.5594),
  ('chair_seat', 'aspect', 1.76929, 1.93447, 0.7355),
  ('chair_seat', 'aspect', 1.93447, 2.09255, 0.6587),
  ('chair_seat', 'aspect', 2.09255, 2.20736, 0.4044),
  ('chair_seat', 'aspect', 2.20736, 2.51875, 0.288),
  ('chair_seat', 'aspect', 2.51875, 2.87407, 0.1965),
  ('chair_seat', 'aspect', 2.87407, 3.27952, 0.09057),
  ('chair_seat', 'aspect', 3.27952, 100, 0.003183);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'height', -0.5, 0.384627, 0.008427),
  ('chair_seat', 'height', 0.384627, 0.405421, 0.8476),
  ('chair_seat', 'height', 0.405421, 0.425946, 4.339),
  ('chair_seat', 'height', 0.425946, 0.437725, 6.854),
  ('chair_seat', 'height', 0.437725, 0.447009, 6.986),
  ('chair_seat', 'height', 0.447009, 0.458507, 7.581),
  ('chair_seat', 'height', 0.458507, 0.467803, 8.763),
  ('chair_seat', 'height', 0.467803, 0.481591, 9.291),
  ('chair_seat', 'height', 0.481591, 0.488597, 9.622),
  ('chair_seat', 'height', 0.488597, 0.494778, 10.19),
  ('chair_seat', 'height', 0.494778, 0.503396, 10.67),
  ('chair_seat', 'height', 0.503396, 0.509392, 10.17),
  ('chair_seat', 'height', 0.509392, 0.530186, 5.981),
  ('chair_seat', 'height', 0.530186, 0.55098, 1.089),
  ('chair_seat', 'height', 0.55098, 0.571774, 0.2698),
  ('chair_seat', 'height', 0.571774, 4, 0.002212);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'length', 0.03, 0.256938, 0.003563),
  ('chair_seat', 'length', 0.256938, 0.292513, 0.1527),
  ('chair_seat', 'length', 0.292513, 0.333012, 0.2396),
  ('chair_seat', 'length', 0.333012, 0.379119, 0.2243),
  ('chair_seat', 'length', 0.379119, 0.40214, 0.4205),
  ('chair_seat', 'length', 0.40214, 0.43161, 0.9965),
  ('chair_seat', 'length', 0.43161, 0.443521, 1.632),
  ('chair_seat', 'length', 0.443521, 0.47176, 1.892),
  ('chair_seat', 'length', 0.47176, 0.485256, 3.562),
  ('chair_seat', 'length', 0.485256, 0.491368, 3.819),
  ('chair_seat', 'length', 0.491368, 0.500918, 3.617),
  ('chair_seat', 'length', 0.500918, 0.513102, 3.476),
  ('chair_seat', 'length', 0.513102, 0.540809, 2.461),
  ('chair_seat', 'length', 0.540809, 0.5594, 2.13),
  ('chair_seat', 'length', 0.5594, 0.576343, 1.24),
  ('chair_seat', 'length', 0.576343, 0.636852, 0.5813),
  ('chair_seat', 'length', 0.636852, 0.725027, 0.1994),
  ('chair_seat', 'length', 0.725027, 0.82541, 0.1749),
  ('chair_seat', 'length', 0.82541, 30, 0.002642);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'rectangularity', 0, 0.371315, 0.02333),
  ('chair_seat', 'rectangularity', 0.371315, 0.438814, 0.2879),
  ('chair_seat', 'rectangularity', 0.438814, 0.506313, 0.4674),
  ('chair_seat', 'rectangularity', 0.506313, 0.552837, 1.063),
  ('chair_seat', 'rectangularity', 0.552837, 0.573812, 1.301),
  ('chair_seat', 'rectangularity', 0.573812, 0.641311, 1.206),
  ('chair_seat', 'rectangularity', 0.641311, 0.698467, 2.176),
  ('chair_seat', 'rectangularity', 0.698467, 0.70881, 1.773),
  ('chair_seat', 'rectangularity', 0.70881, 0.768967, 1.484),
  ('chair_seat', 'rectangularity', 0.768967, 0.776309, 2.304),
  ('chair_seat', 'rectangularity', 0.776309, 0.797317, 4.708),
  ('chair_seat', 'rectangularity', 0.797317, 0.824346, 3.509),
  ('chair_seat', 'rectangularity', 0.824346, 0.843809, 2.667),
  ('chair_seat', 'rectangularity', 0.843809, 0.858844, 4.055),
  ('chair_seat', 'rectangularity', 0.858844, 0.906723, 2.261),
  ('chair_seat', 'rectangularity', 0.906723, 0.957852, 1.965),
  ('chair_seat', 'rectangularity', 0.957852, 0.978807, 0.7117),
  ('chair_seat', 'rectangularity', 0.978807, 1, 0.1479);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_length', 0.01, 0.233952, 0.00102),
  ('chair_seat', 'spread_length', 0.233952, 0.242618, 0.1758),
  ('chair_seat', 'spread_length', 0.242618, 0.262647, 0.185),
  ('chair_seat', 'spread_length', 0.262647, 0.294862, 0.161),
  ('chair_seat', 'spread_length', 0.294862, 0.331028, 0.2199),
  ('chair_seat', 'spread_length', 0.331028, 0.37163, 0.3736),
  ('chair_seat', 'spread_length', 0.37163, 0.378349, 0.3509),
  ('chair_seat', 'spread_length', 0.378349, 0.417211, 0.5431),
  ('chair_seat', 'spread_length', 0.417211, 0.437428, 1.474),
  ('chair_seat', 'spread_length', 0.437428, 0.461292, 2.106),
  ('chair_seat', 'spread_length', 0.461292, 0.468384, 2.72),
  ('chair_seat', 'spread_length', 0.468384, 0.477781, 3.162),
  ('chair_seat', 'spread_length', 0.477781, 0.491665, 3.427),
  ('chair_seat', 'spread_length', 0.491665, 0.507278, 3.617),
  ('chair_seat', 'spread_length', 0.507278, 0.524167, 3.163),
  ('chair_seat', 'spread_length', 0.524167, 0.54537, 2.519),
  ('chair_seat', 'spread_length', 0.54537, 0.590329, 1.129),
  ('chair_seat', 'spread_length', 0.590329, 0.662735, 0.2418),
  ('chair_seat', 'spread_length', 0.662735, 40, 0.002676);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_width', 0.003, 0.113685, 0.002714),
  ('chair_seat', 'spread_width', 0.113685, 0.133876, 0.1752),
  ('chair_seat', 'spread_width', 0.133876, 0.157653, 0.3658),
  ('chair_seat', 'spread_width', 0.157653, 0.161502, 0.5552),
  ('chair_seat', 'spread_width', 0.161502, 0.185653, 0.5459),
  ('chair_seat', 'spread_width', 0.185653, 0.208261, 0.3225),
  ('chair_seat', 'spread_width', 0.208261, 0.218626, 0.2909),
  ('chair_seat', 'spread_width', 0.218626, 0.257455, 0.433),
  ('chair_seat', 'spread_width', 0.257455, 0.267246, 0.5702),
  ('chair_seat', 'spread_width', 0.267246, 0.30318, 0.4891),
  ('chair_seat', 'spread_width', 0.30318, 0.332, 0.8127),
  ('chair_seat', 'spread_width', 0.332, 0.357026, 1.256),
  ('chair_seat', 'spread_width', 0.357026, 0.361855, 1.357),
  ('chair_seat', 'spread_width', 0.361855, 0.381148, 1.931),
  ('chair_seat', 'spread_width', 0.381148, 0.39804, 2.169),
  ('chair_seat', 'spread_width', 0.39804, 0.420436, 1.604),
  ('chair_seat', 'spread_width', 0.420436, 0.427826, 1.336),
  ('chair_seat', 'spread_width', 0.427826, 0.479198, 0.887),
  ('chair_seat', 'spread_width', 0.479198, 0.495107, 0.2304),
  ('chair_seat', 'spread_width', 0.495107, 20, 0.002803);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'tilt_deg', 0, 0.24875, 0.5399),
  ('chair_seat', 'tilt_deg', 0.24875, 0.394616, 0.6288),
  ('chair_seat', 'tilt_deg', 0.394616, 0.518032, 0.6647),
  ('chair_seat', 'tilt_deg', 0.518032, 0.656991, 0.6503),
  ('chair_seat', 'tilt_deg', 0.656991, 0.875685, 0.5634),
  ('chair_seat', 'tilt_deg', 0.875685, 1.03606, 0.439),
  ('chair_seat', 'tilt_deg', 1.03606, 1.5541, 0.2709),
  ('chair_seat', 'tilt_deg', 1.5541, 1.73405, 0.2224),
  ('chair_seat', 'tilt_deg', 1.73405, 2.07213, 0.2023),
  ('chair_seat', 'tilt_deg', 2.07213, 2.33458, 0.1535),
  ('chair_seat', 'tilt_deg', 2.33458, 2.59016, 0.1042),
  ('chair_seat', 'tilt_deg', 2.59016, 3.10819, 0.07935),
  ('chair_seat', 'tilt_deg', 3.10819, 3.62622, 0.05741),
  ('chair_seat', 'tilt_deg', 3.62622, 4.14425, 0.01609),
  ('chair_seat', 'tilt_deg', 4.14425, 4.66229, 0.008046),
  ('chair_seat', 'tilt_deg', 4.66229, 90, 0.0001051);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'width', 0.01, 0.140468, 0.004586),
  ('chair_seat', 'width', 0.140468, 0.142181, 0.1891),
  ('chair_seat', 'width', 0.142181, 0.163938, 0.2736),
  ('chair_seat', 'width', 0.163938, 0.19133, 0.2798),
  ('chair_seat', 'width', 0.19133, 0.199717, 0.3346),
  ('chair_seat', 'width', 0.199717, 0.223299, 0.3874),
  ('chair_seat', 'width', 0.223299, 0.26061, 0.397),
  ('chair_seat', 'width', 0.26061, 0.304154, 0.3812),
  ('chair_seat', 'width', 0.304154, 0.354974, 0.4088),
  ('chair_seat', 'width', 0.354974, 0.360091, 0.4606),
  ('chair_seat', 'width', 0.360091, 0.410523, 0.9203),
  ('chair_seat', 'width', 0.410523, 0.414286, 2.556),
  ('chair_seat', 'width', 0.414286, 0.424482, 2.97),
  ('chair_seat', 'width', 0.424482, 0.442009, 2.847),
  ('chair_seat', 'width', 0.442009, 0.461601, 2.254),
  ('chair_seat', 'width', 0.461601, 0.483508, 2.046),
  ('chair_seat', 'width', 0.483508, 0.487964, 1.608),
  ('chair_seat', 'width', 0.487964, 0.563379, 0.7156),
  ('chair_seat', 'width', 0.563379, 12, 0.004644);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_max', -0.5, 0.39058, 0.008353),
  ('chair_seat', 'z_max', 0.39058, 0.411325, 0.8546),
  ('chair_seat', 'z_max', 0.411325, 0.431282, 4.609),
  ('chair_seat', 'z_max', 0.431282, 0.441061, 7.072),
  ('chair_seat', 'z_max', 0.441061, 0.452813, 7.192),
  ('chair_seat', 'z_max', 0.452813, 0.460475, 7.617),
  ('chair_seat', 'z_max', 0.460475, 0.473557, 8.668),
  ('chair_seat', 'z_max', 0.473557, 0.484441, 8.98),
  ('chair_seat', 'z_max', 0.484441, 0.494301, 8.978),
  ('chair_seat', 'z_max', 0.494301, 0.501549, 9.997),
  ('chair_seat', 'z_max', 0.501549, 0.508904, 10.85),
  ('chair_seat', 'z_max', 0.508904, 0.515045, 10.37),
  ('chair_seat', 'z_max', 0.515045, 0.535789, 5.826),
  ('chair_seat', 'z_max', 0.535789, 0.556534, 1.018),
  ('chair_seat', 'z_max', 0.556534, 0.577278, 0.2675),
  ('chair_seat', 'z_max', 0.577278, 4, 0.002254);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_min', -0.5, 0.377631, 0.008416),
  ('chair_seat', 'z_min', 0.377631, 0.398835, 0.7305),
  ('chair_seat', 'z_min', 0.398835, 0.42004, 3.634),
  ('chair_seat', 'z_min', 0.42004, 0.435312, 6.629),
  ('chair_seat', 'z_min', 0.435312, 0.441244, 7.008),
  ('chair_seat', 'z_min', 0.441244, 0.457007, 7.677),
  ('chair_seat', 'z_min', 0.457007, 0.464689, 9.028),
  ('chair_seat', 'z_min', 0.464689, 0.477876, 9.451),
  ('chair_seat', 'z_min', 0.477876, 0.483653, 9.574),
  ('chair_seat', 'z_min', 0.483653, 0.491618, 9.918),
  ('chair_seat', 'z_min', 0.491618, 0.49987, 10.32),
  ('chair_seat', 'z_min', 0.49987, 0.507973, 9.722),
  ('chair_seat', 'z_min', 0.507973, 0.526062, 5.793),
  ('chair_seat', 'z_min', 0.526062, 0.547266, 1.218),
  ('chair_seat', 'z_min', 0.547266, 0.568471, 0.2781),
  ('chair_seat', 'z_min', 0.568471, 4, 0.00219);

-- chair_back: 129 examples
UPDATE object_class SET prior = 0.0283 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.759, 0.5458)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3566, 0.2588)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.825, 0.09407)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.568, 0.2652)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7842, 0.1343)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.7035, 0.2379)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.121, 0.366)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.8, 3.617)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9291, 0.302)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.029, 0.1006)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4746, 0.1708)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'area_m2', 0.002, 0.0352458, 0.003734),
  ('chair_back', 'area_m2', 0.0352458, 0.0470752, 0.1035),
  ('chair_back', 'area_m2', 0.0470752, 0.0628748, 0.1459),
  ('chair_back', 'area_m2', 0.0628748, 0.0787977, 0.1392),
  ('chair_back', 'area_m2', 0.0787977, 0.0839772, 0.1397),
  ('chair_back', 'area_m2', 0.0839772, 0.112162, 0.1729),
  ('chair_back', 'area_m2', 0.112162, 0.127292, 0.3467),
  ('chair_back', 'area_m2', 0.127292, 0.149807, 0.3917),
  ('chair_back', 'area_m2', 0.149807, 0.168434, 0.6226),
  ('chair_back', 'area_m2', 0.168434, 0.191893, 0.8373),
  ('chair_back', 'area_m2', 0.191893, 0.200085, 1.623),
  ('chair_back', 'area_m2', 0.200085, 0.222827, 1.201),
  ('chair_back', 'area_m2', 0.222827, 0.245524, 1.114),
  ('chair_back', 'area_m2', 0.245524, 0.267239, 0.8388),
  ('chair_back', 'area_m2', 0.267239, 0.287449, 0.5844),
  ('chair_back', 'area_m2', 0.287449, 0.356932, 0.3376),
  ('chair_back', 'area_m2', 0.356932, 0.476727, 0.107),
  ('chair_back', 'area_m2', 0.476727, 100, 0.00262);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'aspect', 1, 1.06563, 1.691),
  ('chair_back', 'aspect', 1.06563, 1.12842, 1.992),
  ('chair_back', 'aspect', 1.12842, 1.19611, 1.758),
  ('chair_back', 'aspect', 1.19611, 1.27886, 1.34),
  ('chair_back', 'aspect', 1.27886, 1.29872, 1.259),
  ('chair_back', 'aspect', 1.29872, 1.44622, 0.988),
  ('chair_back', 'aspect', 1.44622, 1.58167, 1.423),
  ('chair_back', 'aspect', 1.58167, 1.63548, 0.8228),
  ('chair_back', 'aspect', 1.63548, 1.75565, 1.088),
  ('chair_back', 'aspect', 1.75565, 1.84952, 1.099),
  ('chair_back', 'aspect', 1.84952, 2.01583, 0.7673),
  ('chair_back', 'aspect', 2.01583, 2.09156, 0.5815),
  ('chair_back', 'aspect', 2.09156, 2.36527, 0.3617),
  ('chair_back', 'aspect', 2.36527, 2.67481, 0.1601),
  ('chair_back', 'aspect', 2.67481, 3.02485, 0.07171),
  ('chair_back', 'aspect', 3.02485, 100, 0.003135);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'height', -0.5, 0.596051, 0.009998),
  ('chair_back', 'height', 0.596051, 0.648308, 0.4042),
  ('chair_back', 'height', 0.648308, 0.700565, 1.428),
  ('chair_back', 'height', 0.700565, 0.752822, 2.064),
  ('chair_back', 'height', 0.752822, 0.790256, 3.454),
  ('chair_back', 'height', 0.790256, 0.805079, 4.257),
  ('chair_back', 'height', 0.805079, 0.812288, 5.396),
  ('chair_back', 'height', 0.812288, 0.833681, 4.835),
  ('chair_back', 'height', 0.833681, 0.857336, 3.772),
  ('chair_back', 'height', 0.857336, 0.898898, 3.457),
  ('chair_back', 'height', 0.898898, 0.909592, 3.192),
  ('chair_back', 'height', 0.909592, 0.940418, 2.444),
  ('chair_back', 'height', 0.940418, 0.961849, 1.626),
  ('chair_back', 'height', 0.961849, 1.01411, 0.8223),
  ('chair_back', 'height', 1.01411, 1.06636, 0.4142),
  ('chair_back', 'height', 1.06636, 4, 0.003019);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'length', 0.03, 0.279353, 0.005697),
  ('chair_back', 'length', 0.279353, 0.326679, 0.1376),
  ('chair_back', 'length', 0.326679, 0.382023, 0.2125),
  ('chair_back', 'length', 0.382023, 0.434379, 0.472),
  ('chair_back', 'length', 0.434379, 0.446743, 1.146),
  ('chair_back', 'length', 0.446743, 0.476539, 0.9418),
  ('chair_back', 'length', 0.476539, 0.511626, 1.658),
  ('chair_back', 'length', 0.511626, 0.522427, 1.985),
  ('chair_back', 'length', 0.522427, 0.541883, 1.882),
  ('chair_back', 'length', 0.541883, 0.574346, 1.888),
  ('chair_back', 'length', 0.574346, 0.610934, 0.8288),
  ('chair_back', 'length', 0.610934, 0.63745, 1.378),
  ('chair_back', 'length', 0.63745, 0.700293, 1.128),
  ('chair_back', 'length', 0.700293, 0.714435, 1.278),
  ('chair_back', 'length', 0.714435, 0.759345, 1.448),
  ('chair_back', 'length', 0.759345, 0.83547, 0.5699),
  ('chair_back', 'length', 0.83547, 0.97701, 0.1584),
  ('chair_back', 'length', 0.97701, 1.12874, 0.1559),
  ('chair_back', 'length', 1.12874, 1.14253, 0.1171),
  ('chair_back', 'length', 1.14253, 30, 0.002509);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'rectangularity', 0, 0.406816, 0.02585),
  ('chair_back', 'rectangularity', 0.406816, 0.472725, 0.2657),
  ('chair_back', 'rectangularity', 0.472725, 0.538635, 0.5375),
  ('chair_back', 'rectangularity', 0.538635, 0.594186, 0.8451),
  ('chair_back', 'rectangularity', 0.594186, 0.604544, 1.004),
  ('chair_back', 'rectangularity', 0.604544, 0.670453, 1.249),
  ('chair_back', 'rectangularity', 0.670453, 0.684145, 1.266),
  ('chair_back', 'rectangularity', 0.684145, 0.736363, 1.463),
  ('chair_back', 'rectangularity', 0.736363, 0.749835, 2.811),
  ('chair_back', 'rectangularity', 0.749835, 0.785296, 2.845),
  ('chair_back', 'rectangularity', 0.785296, 0.802272, 2.667),
  ('chair_back', 'rectangularity', 0.802272, 0.830171, 2.855),
  ('chair_back', 'rectangularity', 0.830171, 0.865934, 2.983),
  ('chair_back', 'rectangularity', 0.865934, 0.890773, 4.057),
  ('chair_back', 'rectangularity', 0.890773, 0.926169, 3.303),
  ('chair_back', 'rectangularity', 0.926169, 0.934091, 2.387),
  ('chair_back', 'rectangularity', 0.934091, 0.986462, 1.632),
  ('chair_back', 'rectangularity', 0.986462, 1, 0.7953);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_length', 0.01, 0.246195, 0.003237),
  ('chair_back', 'spread_length', 0.246195, 0.286515, 0.169),
  ('chair_back', 'spread_length', 0.286515, 0.333438, 0.2487),
  ('chair_back', 'spread_length', 0.333438, 0.367158, 0.346),
  ('chair_back', 'spread_length', 0.367158, 0.388046, 0.2244),
  ('chair_back', 'spread_length', 0.388046, 0.444366, 0.8502),
  ('chair_back', 'spread_length', 0.444366, 0.451597, 2.297),
  ('chair_back', 'spread_length', 0.451597, 0.465276, 2.558),
  ('chair_back', 'spread_length', 0.465276, 0.484296, 2.354),
  ('chair_back', 'spread_length', 0.484296, 0.506038, 2.322),
  ('chair_back', 'spread_length', 0.506038, 0.525557, 2.355),
  ('chair_back', 'spread_length', 0.525557, 0.53227, 2.042),
  ('chair_back', 'spread_length', 0.53227, 0.577031, 1.42),
  ('chair_back', 'spread_length', 0.577031, 0.611628, 1.25),
  ('chair_back', 'spread_length', 0.611628, 0.635248, 0.9448),
  ('chair_back', 'spread_length', 0.635248, 0.711796, 0.5562),
  ('chair_back', 'spread_length', 0.711796, 0.828369, 0.2087),
  ('chair_back', 'spread_length', 0.828369, 0.964033, 0.07934),
  ('chair_back', 'spread_length', 0.964033, 40, 0.002772);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_width', 0.003, 0.113844, 0.002466),
  ('chair_back', 'spread_width', 0.113844, 0.116433, 0.09339),
  ('chair_back', 'spread_width', 0.116433, 0.136754, 0.129),
  ('chair_back', 'spread_width', 0.136754, 0.164274, 0.1732),
  ('chair_back', 'spread_width', 0.164274, 0.197332, 0.2334),
  ('chair_back', 'spread_width', 0.197332, 0.202031, 0.2803),
  ('chair_back', 'spread_width', 0.202031, 0.237042, 0.3212),
  ('chair_back', 'spread_width', 0.237042, 0.254539, 0.87),
  ('chair_back', 'spread_width', 0.254539, 0.284743, 0.8829),
  ('chair_back', 'spread_width', 0.284743, 0.290617, 0.6717),
  ('chair_back', 'spread_width', 0.290617, 0.328798, 0.8216),
  ('chair_back', 'spread_width', 0.328798, 0.342044, 0.8754),
  ('chair_back', 'spread_width', 0.342044, 0.375678, 0.9641),
  ('chair_back', 'spread_width', 0.375678, 0.40671, 1.221),
  ('chair_back', 'spread_width', 0.40671, 0.441305, 1.365),
  ('chair_back', 'spread_width', 0.441305, 0.47891, 1.316),
  ('chair_back', 'spread_width', 0.47891, 0.493558, 1.214),
  ('chair_back', 'spread_width', 0.493558, 0.59288, 0.3816),
  ('chair_back', 'spread_width', 0.59288, 20, 0.003461);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'tilt_deg', 0, 73.0001, 0.0001514),
  ('chair_back', 'tilt_deg', 73.0001, 74.6392, 0.01999),
  ('chair_back', 'tilt_deg', 74.6392, 76.0868, 0.04714),
  ('chair_back', 'tilt_deg', 76.0868, 76.2782, 0.06721),
  ('chair_back', 'tilt_deg', 76.2782, 77.8023, 0.06346),
  ('chair_back', 'tilt_deg', 77.8023, 78.9064, 0.101),
  ('chair_back', 'tilt_deg', 78.9064, 79.5563, 0.07764),
  ('chair_back', 'tilt_deg', 79.5563, 80.1528, 0.1017),
  ('chair_back', 'tilt_deg', 80.1528, 81.1954, 0.1063),
  ('chair_back', 'tilt_deg', 81.1954, 82.8345, 0.06806),
  ('chair_back', 'tilt_deg', 82.8345, 84.3785, 0.07899),
  ('chair_back', 'tilt_deg', 84.3785, 85.3513, 0.09886),
  ('chair_back', 'tilt_deg', 85.3513, 86.1126, 0.06084),
  ('chair_back', 'tilt_deg', 86.1126, 87.1005, 0.05135),
  ('chair_back', 'tilt_deg', 87.1005, 87.7516, 0.0213),
  ('chair_back', 'tilt_deg', 87.7516, 90, 0.001909);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'width', 0.01, 0.172487, 0.003869),
  ('chair_back', 'width', 0.172487, 0.205341, 0.2342),
  ('chair_back', 'width', 0.205341, 0.244454, 0.2647),
  ('chair_back', 'width', 0.244454, 0.258647, 0.3217),
  ('chair_back', 'width', 0.258647, 0.291017, 0.4091),
  ('chair_back', 'width', 0.291017, 0.338262, 0.4737),
  ('chair_back', 'width', 0.338262, 0.346449, 0.7448),
  ('chair_back', 'width', 0.346449, 0.393422, 0.762),
  ('chair_back', 'width', 0.393422, 0.41244, 1.294),
  ('chair_back', 'width', 0.41244, 0.423931, 2.027),
  ('chair_back', 'width', 0.423931, 0.440123, 2.759),
  ('chair_back', 'width', 0.440123, 0.460332, 2.251),
  ('chair_back', 'width', 0.460332, 0.47906, 2.576),
  ('chair_back', 'width', 0.47906, 0.491001, 2.249),
  ('chair_back', 'width', 0.491001, 0.514923, 1.281),
  ('chair_back', 'width', 0.514923, 0.584525, 0.5065),
  ('chair_back', 'width', 0.584525, 0.695864, 0.1437),
  ('chair_back', 'width', 0.695864, 0.82841, 0.05598),
  ('chair_back', 'width', 0.82841, 12, 0.003844);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_max', -0.5, 0.771411, 0.009729),
  ('chair_back', 'z_max', 0.771411, 0.824616, 0.4312),
  ('chair_back', 'z_max', 0.824616, 0.877821, 0.8626),
  ('chair_back', 'z_max', 0.877821, 0.8991, 1.202),
  ('chair_back', 'z_max', 0.8991, 0.931027, 1.78),
  ('chair_back', 'z_max', 0.931027, 0.954005, 2.56),
  ('chair_back', 'z_max', 0.954005, 0.984232, 2.861),
  ('chair_back', 'z_max', 0.984232, 0.993321, 4.115),
  ('chair_back', 'z_max', 0.993321, 1.01372, 4.282),
  ('chair_back', 'z_max', 1.01372, 1.03744, 3.533),
  ('chair_back', 'z_max', 1.03744, 1.05043, 3.761),
  ('chair_back', 'z_max', 1.05043, 1.07791, 3.747),
  ('chair_back', 'z_max', 1.07791, 1.09064, 3.573),
  ('chair_back', 'z_max', 1.09064, 1.10564, 3.506),
  ('chair_back', 'z_max', 1.10564, 1.14385, 2.302),
  ('chair_back', 'z_max', 1.14385, 1.1556, 2.266),
  ('chair_back', 'z_max', 1.1556, 1.19705, 2.041),
  ('chair_back', 'z_max', 1.19705, 1.24589, 0.5257),
  ('chair_back', 'z_max', 1.24589, 4, 0.002828);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_min', -0.5, -0.0601699, 0.03052),
  ('chair_back', 'z_min', -0.0601699, 0.0401697, 0.1869),
  ('chair_back', 'z_min', 0.0401697, 0.140509, 0.1131),
  ('chair_back', 'z_min', 0.140509, 0.240849, 0.1376),
  ('chair_back', 'z_min', 0.240849, 0.317688, 0.71),
  ('chair_back', 'z_min', 0.317688, 0.341188, 1.404),
  ('chair_back', 'z_min', 0.341188, 0.376254, 2.326),
  ('chair_back', 'z_min', 0.376254, 0.40581, 3.468),
  ('chair_back', 'z_min', 0.40581, 0.434642, 3.853),
  ('chair_back', 'z_min', 0.434642, 0.441528, 2.821),
  ('chair_back', 'z_min', 0.441528, 0.486855, 2.111),
  ('chair_back', 'z_min', 0.486855, 0.541867, 2.069),
  ('chair_back', 'z_min', 0.541867, 0.614169, 1.537),
  ('chair_back', 'z_min', 0.614169, 0.642207, 2.088),
  ('chair_back', 'z_min', 0.642207, 0.655536, 2.455),
  ('chair_back', 'z_min', 0.655536, 0.742547, 0.8147),
  ('chair_back', 'z_min', 0.742547, 0.842886, 0.4244),
  ('chair_back', 'z_min', 0.842886, 4, 0.004817);

-- door: 61 examples
UPDATE object_class SET prior = 0.01335 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.2935, 0.5606)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.7772, 0.2519)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.143, 0.1857)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.6368, 0.2527)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8356, 0.1093)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4793, 0.2657)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.2675, 0.3631)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.82, 0.6005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1555, 0.3481)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.056, 0.2592)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.132, 0.2874)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'door' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'area_m2', 0.002, 0.120955, 0.00334),
  ('door', 'area_m2', 0.120955, 0.170329, 0.003504),
  ('door', 'area_m2', 0.170329, 0.239856, 0.03605),
  ('door', 'area_m2', 0.239856, 0.337765, 0.02366),
  ('door', 'area_m2', 0.337765, 0.475639, 0.1053),
  ('door', 'area_m2', 0.475639, 0.669794, 0.0512),
  ('door', 'area_m2', 0.669794, 0.817656, 0.1997),
  ('door', 'area_m2', 0.817656, 0.943201, 0.3009),
  ('door', 'area_m2', 0.943201, 1.24061, 0.3337),
  ('door', 'area_m2', 1.24061, 1.32821, 0.8588),
  ('door', 'area_m2', 1.32821, 1.4022, 0.9167),
  ('door', 'area_m2', 1.4022, 1.57682, 0.9137),
  ('door', 'area_m2', 1.57682, 1.6686, 1.619),
  ('door', 'area_m2', 1.6686, 1.76419, 2.012),
  ('door', 'area_m2', 1.76419, 1.82082, 2.086),
  ('door', 'area_m2', 1.82082, 1.87038, 1.635),
  ('door', 'area_m2', 1.87038, 1.97403, 1.374),
  ('door', 'area_m2', 1.97403, 2.63387, 0.3558),
  ('door', 'area_m2', 2.63387, 100, 0.008533);
DELETE FROM class_density WHERE class = 'door' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'aspect', 1, 1.19781, 0.06877),
  ('door', 'aspect', 1.19781, 1.23604, 0.2507),
  ('door', 'aspect', 1.23604, 1.41081, 0.3504),
  ('door', 'aspect', 1.41081, 1.62261, 0.3742),
  ('door', 'aspect', 1.62261, 1.66169, 0.5227),
  ('door', 'aspect', 1.66169, 1.86657, 0.8373),
  ('door', 'aspect', 1.86657, 1.95717, 0.8608),
  ('door', 'aspect', 1.95717, 2.06076, 1.628),
  ('door', 'aspect', 2.06076, 2.23885, 1.317),
  ('door', 'aspect', 2.23885, 2.29491, 3.526),
  ('door', 'aspect', 2.29491, 2.39331, 2.965),
  ('door', 'aspect', 2.39331, 2.4442, 3.605),
  ('door', 'aspect', 2.4442, 2.63663, 1.523),
  ('door', 'aspect', 2.63663, 2.71511, 0.6401),
  ('door', 'aspect', 2.71511, 3.19792, 0.3717),
  ('door', 'aspect', 3.19792, 3.76659, 0.1653),
  ('door', 'aspect', 3.76659, 4.43637, 0.07813),
  ('door', 'aspect', 4.43637, 5.22525, 0.00664),
  ('door', 'aspect', 5.22525, 100, 0.004655);
DELETE FROM class_density WHERE class = 'door' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'height', -0.5, 0.468259, 0.01403),
  ('door', 'height', 0.468259, 0.60203, 0.05841),
  ('door', 'height', 0.60203, 0.735801, 0.1111),
  ('door', 'height', 0.735801, 0.869572, 0.1393),
  ('door', 'height', 0.869572, 1.00334, 0.3298),
  ('door', 'height', 1.00334, 1.02782, 1.758),
  ('door', 'height', 1.02782, 1.05461, 4.121),
  ('door', 'height', 1.05461, 1.06735, 5.863),
  ('door', 'height', 1.06735, 1.09953, 3.638),
  ('door', 'height', 1.09953, 1.13504, 2.864),
  ('door', 'height', 1.13504, 1.20057, 1.665),
  ('door', 'height', 1.20057, 1.27088, 1.517),
  ('door', 'height', 1.27088, 1.28403, 1.665),
  ('door', 'height', 1.28403, 1.34231, 1.654),
  ('door', 'height', 1.34231, 1.40466, 1.029),
  ('door', 'height', 1.40466, 1.53843, 0.2381),
  ('door', 'height', 1.53843, 1.6722, 0.07595),
  ('door', 'height', 1.6722, 4, 0.005961);
DELETE FROM class_density WHERE class = 'door' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'length', 0.03, 0.625832, 0.00451),
  ('door', 'length', 0.625832, 0.731499, 0.0001469),
  ('door', 'length', 0.731499, 0.855007, 0.02252),
  ('door', 'length', 0.855007, 0.999369, 0.1002),
  ('door', 'length', 0.999369, 1.1681, 0.2279),
  ('door', 'length', 1.1681, 1.36533, 0.1272),
  ('door', 'length', 1.36533, 1.47101, 0.4514),
  ('door', 'length', 1.47101, 1.59586, 0.7783),
  ('door', 'length', 1.59586, 1.69887, 0.8709),
  ('door', 'length', 1.69887, 1.86531, 0.6642),
  ('door', 'length', 1.86531, 2.01439, 1.488),
  ('door', 'length', 2.01439, 2.04234, 5.431),
  ('door', 'length', 2.04234, 2.06764, 6.028),
  ('door', 'length', 2.06764, 2.09707, 5.378),
  ('door', 'length', 2.09707, 2.18025, 2.859),
  ('door', 'length', 2.18025, 2.30255, 2.142),
  ('door', 'length', 2.30255, 2.54771, 1.028),
  ('door', 'length', 2.54771, 30, 0.01073);
DELETE FROM class_density WHERE class = 'door' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'rectangularity', 0, 0.543409, 0.027),
  ('door', 'rectangularity', 0.543409, 0.592852, 0.4404),
  ('door', 'rectangularity', 0.592852, 0.642296, 0.7515),
  ('door', 'rectangularity', 0.642296, 0.685251, 0.7414),
  ('door', 'rectangularity', 0.685251, 0.69174, 0.6901),
  ('door', 'rectangularity', 0.69174, 0.741183, 1.214),
  ('door', 'rectangularity', 0.741183, 0.76626, 2.523),
  ('door', 'rectangularity', 0.76626, 0.790627, 3.086),
  ('door', 'rectangularity', 0.790627, 0.799268, 4.332),
  ('door', 'rectangularity', 0.799268, 0.824773, 4.082),
  ('door', 'rectangularity', 0.824773, 0.84007, 1.898),
  ('door', 'rectangularity', 0.84007, 0.88116, 2.38),
  ('door', 'rectangularity', 0.88116, 0.889514, 7.41),
  ('door', 'rectangularity', 0.889514, 0.893896, 7.308),
  ('door', 'rectangularity', 0.893896, 0.929421, 2.716),
  ('door', 'rectangularity', 0.929421, 0.938957, 2.162),
  ('door', 'rectangularity', 0.938957, 0.963646, 4.291),
  ('door', 'rectangularity', 0.963646, 0.977171, 6.652),
  ('door', 'rectangularity', 0.977171, 0.988401, 1.006),
  ('door', 'rectangularity', 0.988401, 1, 0.4303);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_length', 0.01, 0.627513, 0.003317),
  ('door', 'spread_length', 0.627513, 0.718766, 0.001744),
  ('door', 'spread_length', 0.718766, 0.823287, 0.02987),
  ('door', 'spread_length', 0.823287, 0.943009, 0.2121),
  ('door', 'spread_length', 0.943009, 1.08014, 0.4453),
  ('door', 'spread_length', 1.08014, 1.23721, 0.4754),
  ('door', 'spread_length', 1.23721, 1.39028, 0.6303),
  ('door', 'spread_length', 1.39028, 1.41713, 0.7568),
  ('door', 'spread_length', 1.41713, 1.60866, 0.8492),
  ('door', 'spread_length', 1.60866, 1.68851, 1.969),
  ('door', 'spread_length', 1.68851, 1.85925, 1.093),
  ('door', 'spread_length', 1.85925, 1.96187, 2.677),
  ('door', 'spread_length', 1.96187, 1.99682, 4.855),
  ('door', 'spread_length', 1.99682, 2.01851, 5.077),
  ('door', 'spread_length', 2.01851, 2.04531, 4.312),
  ('door', 'spread_length', 2.04531, 2.12961, 1.598),
  ('door', 'spread_length', 2.12961, 40, 0.00888);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_width', 0.003, 0.176903, 0.001547),
  ('door', 'spread_width', 0.176903, 0.180852, 0.1725),
  ('door', 'spread_width', 0.180852, 0.220153, 0.08807),
  ('door', 'spread_width', 0.220153, 0.273979, 0.001594),
  ('door', 'spread_width', 0.273979, 0.340964, 0.08318),
  ('door', 'spread_width', 0.340964, 0.424326, 0.1346),
  ('door', 'spread_width', 0.424326, 0.528069, 0.169),
  ('door', 'spread_width', 0.528069, 0.565498, 0.3192),
  ('door', 'spread_width', 0.565498, 0.657176, 0.3937),
  ('door', 'spread_width', 0.657176, 0.755326, 0.5345),
  ('door', 'spread_width', 0.755326, 0.807356, 2),
  ('door', 'spread_width', 0.807356, 0.817849, 3.447),
  ('door', 'spread_width', 0.817849, 0.852253, 2.851),
  ('door', 'spread_width', 0.852253, 0.885531, 2.359),
  ('door', 'spread_width', 0.885531, 0.935962, 2.323),
  ('door', 'spread_width', 0.935962, 0.952707, 2.953),
  ('door', 'spread_width', 0.952707, 1.0178, 1.142),
  ('door', 'spread_width', 1.0178, 1.26665, 0.3019),
  ('door', 'spread_width', 1.26665, 20, 0.008746);
DELETE FROM class_density WHERE class = 'door' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'tilt_deg', 0, 87.0314, 1.032e-05),
  ('door', 'tilt_deg', 87.0314, 87.3612, 0.03381),
  ('door', 'tilt_deg', 87.3612, 87.6911, 0.07464),
  ('door', 'tilt_deg', 87.6911, 88.0209, 0.0446),
  ('door', 'tilt_deg', 88.0209, 88.3508, 0.01394),
  ('door', 'tilt_deg', 88.3508, 88.6806, 0.01408),
  ('door', 'tilt_deg', 88.6806, 89.0105, 0.0401),
  ('door', 'tilt_deg', 89.0105, 89.3403, 0.105),
  ('door', 'tilt_deg', 89.3403, 89.6702, 0.5106),
  ('door', 'tilt_deg', 89.6702, 90, 2.192);
DELETE FROM class_density WHERE class = 'door' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'width', 0.01, 0.211688, 0.003495),
  ('door', 'width', 0.211688, 0.267, 0.07231),
  ('door', 'width', 0.267, 0.336764, 0.00637),
  ('door', 'width', 0.336764, 0.424757, 0.1064),
  ('door', 'width', 0.424757, 0.535742, 0.1207),
  ('door', 'width', 0.535742, 0.667417, 0.2525),
  ('door', 'width', 0.667417, 0.675726, 0.2955),
  ('door', 'width', 0.675726, 0.821529, 0.6165),
  ('door', 'width', 0.821529, 0.852286, 2.043),
  ('door', 'width', 0.852286, 0.863179, 2.318),
  ('door', 'width', 0.863179, 0.892953, 2.812),
  ('door', 'width', 0.892953, 0.918929, 3.058),
  ('door', 'width', 0.918929, 0.956257, 2.586),
  ('door', 'width', 0.956257, 0.983536, 2.868),
  ('door', 'width', 0.983536, 1.07498, 1.372),
  ('door', 'width', 1.07498, 1.09641, 0.5065),
  ('door', 'width', 1.09641, 1.35586, 0.3918),
  ('door', 'width', 1.35586, 1.71013, 0.1498),
  ('door', 'width', 1.71013, 12, 0.009003);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_max', -0.5, 0.865073, 0.01004),
  ('door', 'z_max', 0.865073, 1.04085, 0.003714),
  ('door', 'z_max', 1.04085, 1.21663, 0.07339),
  ('door', 'z_max', 1.21663, 1.39241, 0.04044),
  ('door', 'z_max', 1.39241, 1.56819, 0.1395),
  ('door', 'z_max', 1.56819, 1.74397, 0.08856),
  ('door', 'z_max', 1.74397, 1.91975, 0.3336),
  ('door', 'z_max', 1.91975, 1.96653, 0.4959),
  ('door', 'z_max', 1.96653, 2.01987, 2.136),
  ('door', 'z_max', 2.01987, 2.04252, 4.765),
  ('door', 'z_max', 2.04252, 2.0526, 4.805),
  ('door', 'z_max', 2.0526, 2.09049, 3.38),
  ('door', 'z_max', 2.09049, 2.12365, 2.844),
  ('door', 'z_max', 2.12365, 2.21675, 1.256),
  ('door', 'z_max', 2.21675, 2.27131, 1.15),
  ('door', 'z_max', 2.27131, 2.28756, 2.598),
  ('door', 'z_max', 2.28756, 2.44709, 0.657),
  ('door', 'z_max', 2.44709, 4, 0.01569);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_min', -0.5, -0.0667563, 0.1233),
  ('door', 'z_min', -0.0667563, -0.00791193, 3.232),
  ('door', 'z_min', -0.00791193, -0.002034, 17.2),
  ('door', 'z_min', -0.002034, 0.00487679, 18.03),
  ('door', 'z_min', 0.00487679, 0.0782535, 3.326),
  ('door', 'z_min', 0.0782535, 0.103913, 0.2551),
  ('door', 'z_min', 0.103913, 0.223263, 0.4494),
  ('door', 'z_min', 0.223263, 0.368273, 0.3039),
  ('door', 'z_min', 0.368273, 0.513283, 0.48),
  ('door', 'z_min', 0.513283, 0.658293, 0.3687),
  ('door', 'z_min', 0.658293, 0.803302, 0.1145),
  ('door', 'z_min', 0.803302, 0.948312, 0.008535),
  ('door', 'z_min', 0.948312, 1.09332, 0.1306),
  ('door', 'z_min', 1.09332, 1.23833, 0.06077),
  ('door', 'z_min', 1.23833, 4, 0.004964);

-- window: 98 examples
UPDATE object_class SET prior = 0.02144 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', 0.03036, 0.6279)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.3464, 0.3515)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.533, 0.1461)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.2867, 0.2433)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8467, 0.1549)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.317, 0.2461)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.1089, 0.4494)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.62, 0.5558)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.06137, 0.3918)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.126, 0.1812)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 0.9693, 0.185)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'window' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'area_m2', 0.002, 0.116059, 0.002748),
  ('window', 'area_m2', 0.116059, 0.177118, 0.01775),
  ('window', 'area_m2', 0.177118, 0.270298, 0.0485),
  ('window', 'area_m2', 0.270298, 0.412501, 0.1306),
  ('window', 'area_m2', 0.412501, 0.459619, 0.158),
  ('window', 'area_m2', 0.459619, 0.629515, 0.1784),
  ('window', 'area_m2', 0.629515, 0.784216, 0.2685),
  ('window', 'area_m2', 0.784216, 0.960699, 0.5688),
  ('window', 'area_m2', 0.960699, 1.04669, 1.259),
  ('window', 'area_m2', 1.04669, 1.15897, 1.034),
  ('window', 'area_m2', 1.15897, 1.35303, 0.6794),
  ('window', 'area_m2', 1.35303, 1.46612, 0.7135),
  ('window', 'area_m2', 1.46612, 1.56214, 0.8668),
  ('window', 'area_m2', 1.56214, 1.84231, 0.6592),
  ('window', 'area_m2', 1.84231, 2.23743, 0.3959),
  ('window', 'area_m2', 2.23743, 3.41454, 0.03305),
  ('window', 'area_m2', 3.41454, 5.2109, 0.03773),
  ('window', 'area_m2', 5.2109, 100, 0.003964);
DELETE FROM class_density WHERE class = 'window' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'aspect', 1, 1.05342, 2.263),
  ('window', 'aspect', 1.05342, 1.09747, 2.524),
  ('window', 'aspect', 1.09747, 1.13265, 3.097),
  ('window', 'aspect', 1.13265, 1.17622, 1.779),
  ('window', 'aspect', 1.17622, 1.23776, 1.166),
  ('window', 'aspect', 1.23776, 1.31172, 1.54),
  ('window', 'aspect', 1.31172, 1.38349, 1.697),
  ('window', 'aspect', 1.38349, 1.62728, 0.861),
  ('window', 'aspect', 1.62728, 1.91403, 0.4096),
  ('window', 'aspect', 1.91403, 2.25132, 0.2552),
  ('window', 'aspect', 2.25132, 2.46757, 0.2231),
  ('window', 'aspect', 2.46757, 2.64804, 0.2355),
  ('window', 'aspect', 2.64804, 3.11467, 0.2376),
  ('window', 'aspect', 3.11467, 3.66352, 0.16),
  ('window', 'aspect', 3.66352, 4.3091, 0.09504),
  ('window', 'aspect', 4.3091, 100, 0.003207);
DELETE FROM class_density WHERE class = 'window' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'height', -0.5, 1.10818, 0.007247),
  ('window', 'height', 1.10818, 1.20708, 0.1021),
  ('window', 'height', 1.20708, 1.30598, 0.1723),
  ('window', 'height', 1.30598, 1.40201, 0.9674),
  ('window', 'height', 1.40201, 1.43495, 2.896),
  ('window', 'height', 1.43495, 1.46184, 3.844),
  ('window', 'height', 1.46184, 1.49458, 3.582),
  ('window', 'height', 1.49458, 1.50378, 3.24),
  ('window', 'height', 1.50378, 1.52564, 2.953),
  ('window', 'height', 1.52564, 1.58565, 1.835),
  ('window', 'height', 1.58565, 1.60268, 2.5),
  ('window', 'height', 1.60268, 1.6401, 2.065),
  ('window', 'height', 1.6401, 1.69601, 2.124),
  ('window', 'height', 1.69601, 1.80049, 0.6906),
  ('window', 'height', 1.80049, 1.89939, 0.1276),
  ('window', 'height', 1.89939, 1.99829, 0.1566),
  ('window', 'height', 1.99829, 4, 0.004466);
DELETE FROM class_density WHERE class = 'window' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'length', 0.03, 0.801698, 0.004016),
  ('window', 'length', 0.801698, 0.955703, 0.1968),
  ('window', 'length', 0.955703, 1.05501, 0.6694),
  ('window', 'length', 1.05501, 1.13929, 1.341),
  ('window', 'length', 1.13929, 1.15715, 1.338),
  ('window', 'length', 1.15715, 1.22541, 1.882),
  ('window', 'length', 1.22541, 1.27872, 2.203),
  ('window', 'length', 1.27872, 1.33691, 2.154),
  ('window', 'length', 1.33691, 1.35815, 2.522),
  ('window', 'length', 1.35815, 1.39756, 2.515),
  ('window', 'length', 1.39756, 1.48581, 1.85),
  ('window', 'length', 1.48581, 1.61905, 1.319),
  ('window', 'length', 1.61905, 1.93007, 0.5248),
  ('window', 'length', 1.93007, 2.30083, 0.0319),
  ('window', 'length', 2.30083, 2.74282, 0.006731),
  ('window', 'length', 2.74282, 3.26971, 0.002412),
  ('window', 'length', 3.26971, 3.89782, 0.07774),
  ('window', 'length', 3.89782, 30, 0.006543);
DELETE FROM class_density WHERE class = 'window' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'rectangularity', 0, 0.19753, 0.05213),
  ('window', 'rectangularity', 0.19753, 0.286694, 0.08284),
  ('window', 'rectangularity', 0.286694, 0.375857, 0.04568),
  ('window', 'rectangularity', 0.375857, 0.46502, 0.1027),
  ('window', 'rectangularity', 0.46502, 0.554184, 0.1877),
  ('window', 'rectangularity', 0.554184, 0.643347, 0.4499),
  ('window', 'rectangularity', 0.643347, 0.66746, 1.012),
  ('window', 'rectangularity', 0.66746, 0.73251, 1.105),
  ('window', 'rectangularity', 0.73251, 0.769031, 1.289),
  ('window', 'rectangularity', 0.769031, 0.821673, 1.717),
  ('window', 'rectangularity', 0.821673, 0.837425, 2.206),
  ('window', 'rectangularity', 0.837425, 0.863438, 3.878),
  ('window', 'rectangularity', 0.863438, 0.910604, 2.328),
  ('window', 'rectangularity', 0.910604, 0.950669, 2.947),
  ('window', 'rectangularity', 0.950669, 0.967612, 6.403),
  ('window', 'rectangularity', 0.967612, 0.973776, 14.77),
  ('window', 'rectangularity', 0.973776, 0.985407, 8.653),
  ('window', 'rectangularity', 0.985407, 1, 1.011);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_length', 0.01, 0.698836, 0.002859),
  ('window', 'spread_length', 0.698836, 0.818997, 0.1668),
  ('window', 'spread_length', 0.818997, 0.959818, 0.2861),
  ('window', 'spread_length', 0.959818, 1.05364, 0.4296),
  ('window', 'spread_length', 1.05364, 1.12485, 0.6716),
  ('window', 'spread_length', 1.12485, 1.18374, 1.175),
  ('window', 'spread_length', 1.18374, 1.29764, 1.396),
  ('window', 'spread_length', 1.29764, 1.31826, 2.39),
  ('window', 'spread_length', 1.31826, 1.3458, 2.515),
  ('window', 'spread_length', 1.3458, 1.43737, 1.538),
  ('window', 'spread_length', 1.43737, 1.5375, 1.79),
  ('window', 'spread_length', 1.5375, 1.61439, 2.229),
  ('window', 'spread_length', 1.61439, 1.70479, 1.811),
  ('window', 'spread_length', 1.70479, 1.81057, 0.9342),
  ('window', 'spread_length', 1.81057, 2.12189, 0.2194),
  ('window', 'spread_length', 2.12189, 2.48674, 0.0472),
  ('window', 'spread_length', 2.48674, 2.91432, 0.08604),
  ('window', 'spread_length', 2.91432, 40, 0.004843);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_width', 0.003, 0.170761, 0.00289),
  ('window', 'spread_width', 0.170761, 0.219254, 0.0468),
  ('window', 'spread_width', 0.219254, 0.281518, 0.03418),
  ('window', 'spread_width', 0.281518, 0.361463, 0.07882),
  ('window', 'spread_width', 0.361463, 0.464111, 0.184),
  ('window', 'spread_width', 0.464111, 0.523686, 0.1939),
  ('window', 'spread_width', 0.523686, 0.595909, 0.2521),
  ('window', 'spread_width', 0.595909, 0.74606, 0.3493),
  ('window', 'spread_width', 0.74606, 0.765135, 0.4175),
  ('window', 'spread_width', 0.765135, 0.902607, 0.6844),
  ('window', 'spread_width', 0.902607, 0.982418, 0.9591),
  ('window', 'spread_width', 0.982418, 0.997239, 1.537),
  ('window', 'spread_width', 0.997239, 1.06563, 1.684),
  ('window', 'spread_width', 1.06563, 1.11663, 1.855),
  ('window', 'spread_width', 1.11663, 1.18946, 1.693),
  ('window', 'spread_width', 1.18946, 1.26141, 1.007),
  ('window', 'spread_width', 1.26141, 1.3324, 1.01),
  ('window', 'spread_width', 1.3324, 1.61962, 0.5144),
  ('window', 'spread_width', 1.61962, 20, 0.00784);
DELETE FROM class_density WHERE class = 'window' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'tilt_deg', 0, 87.5766, 0.0001042),
  ('window', 'tilt_deg', 87.5766, 87.8458, 0.01071),
  ('window', 'tilt_deg', 87.8458, 88.1151, 0.05069),
  ('window', 'tilt_deg', 88.1151, 88.3844, 0.1154),
  ('window', 'tilt_deg', 88.3844, 88.6536, 0.1664),
  ('window', 'tilt_deg', 88.6536, 88.9229, 0.1996),
  ('window', 'tilt_deg', 88.9229, 89.1922, 0.1924),
  ('window', 'tilt_deg', 89.1922, 89.3919, 0.2174),
  ('window', 'tilt_deg', 89.3919, 89.7307, 0.688),
  ('window', 'tilt_deg', 89.7307, 89.8777, 1.7),
  ('window', 'tilt_deg', 89.8777, 90, 2.18);
DELETE FROM class_density WHERE class = 'window' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'width', 0.01, 0.19065, 0.003932),
  ('window', 'width', 0.19065, 0.239982, 0.02895),
  ('window', 'width', 0.239982, 0.302079, 0.03297),
  ('window', 'width', 0.302079, 0.380244, 0.05421),
  ('window', 'width', 0.380244, 0.478634, 0.1226),
  ('window', 'width', 0.478634, 0.590035, 0.2426),
  ('window', 'width', 0.590035, 0.602484, 0.3122),
  ('window', 'width', 0.602484, 0.758382, 0.3388),
  ('window', 'width', 0.758382, 0.835617, 0.3753),
  ('window', 'width', 0.835617, 0.954618, 0.6704),
  ('window', 'width', 0.954618, 0.983439, 1.402),
  ('window', 'width', 0.983439, 1.02612, 2.153),
  ('window', 'width', 1.02612, 1.08369, 2.134),
  ('window', 'width', 1.08369, 1.1168, 2.705),
  ('window', 'width', 1.1168, 1.19653, 1.493),
  ('window', 'width', 1.19653, 1.29983, 1.314),
  ('window', 'width', 1.29983, 1.51245, 0.7008),
  ('window', 'width', 1.51245, 12, 0.01135);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_max', -0.5, 1.35031, 0.004645),
  ('window', 'z_max', 1.35031, 1.47072, 0.07251),
  ('window', 'z_max', 1.47072, 1.59113, 0.008491),
  ('window', 'z_max', 1.59113, 1.71155, 0.008613),
  ('window', 'z_max', 1.71155, 1.83196, 0.04727),
  ('window', 'z_max', 1.83196, 1.95091, 0.8252),
  ('window', 'z_max', 1.95091, 1.99674, 2.277),
  ('window', 'z_max', 1.99674, 2.05135, 2.087),
  ('window', 'z_max', 2.05135, 2.07278, 2.79),
  ('window', 'z_max', 2.07278, 2.09028, 2.062),
  ('window', 'z_max', 2.09028, 2.15781, 1.778),
  ('window', 'z_max', 2.15781, 2.1932, 1.644),
  ('window', 'z_max', 2.1932, 2.21328, 1.668),
  ('window', 'z_max', 2.21328, 2.26374, 2.35),
  ('window', 'z_max', 2.26374, 2.31361, 1.868),
  ('window', 'z_max', 2.31361, 2.34141, 0.7757),
  ('window', 'z_max', 2.34141, 2.43402, 1.137),
  ('window', 'z_max', 2.43402, 4, 0.00779);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_min', -0.5, 0.791531, 0.02066),
  ('window', 'z_min', 0.791531, 0.826868, 2.755),
  ('window', 'z_min', 0.826868, 0.846734, 5.635),
  ('window', 'z_min', 0.846734, 0.866038, 4.319),
  ('window', 'z_min', 0.866038, 0.878254, 2.982),
  ('window', 'z_min', 0.878254, 0.911757, 2.849),
  ('window', 'z_min', 0.911757, 0.929805, 4.158),
  ('window', 'z_min', 0.929805, 0.957761, 4.048),
  ('window', 'z_min', 0.957761, 0.964977, 4.696),
  ('window', 'z_min', 0.964977, 0.983472, 4.639),
  ('window', 'z_min', 0.983472, 1.0517, 1.141),
  ('window', 'z_min', 1.0517, 1.13842, 0.2247),
  ('window', 'z_min', 1.13842, 1.22515, 0.2919),
  ('window', 'z_min', 1.22515, 1.27183, 0.2926),
  ('window', 'z_min', 1.27183, 1.31187, 0.3247),
  ('window', 'z_min', 1.31187, 1.39859, 0.2435),
  ('window', 'z_min', 1.39859, 1.48531, 0.4556),
  ('window', 'z_min', 1.48531, 1.57204, 0.228),
  ('window', 'z_min', 1.57204, 4, 0.004607);

-- whiteboard: 55 examples
UPDATE object_class SET prior = 0.01198 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.334, 0.6332)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4413, 0.313)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.396, 0.1391)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.5107, 0.3235)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.7899, 0.1084)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.3629, 0.3036)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.1824, 0.3581)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.59, 1.204)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', 0.06955, 0.3705)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 2.032, 0.2755)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.7914, 0.2369)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'area_m2', 0.002, 0.159269, 0.003222),
  ('whiteboard', 'area_m2', 0.159269, 0.239993, 0.01984),
  ('whiteboard', 'area_m2', 0.239993, 0.36163, 0.05481),
  ('whiteboard', 'area_m2', 0.36163, 0.544919, 0.06954),
  ('whiteboard', 'area_m2', 0.544919, 0.755856, 0.1728),
  ('whiteboard', 'area_m2', 0.755856, 0.821105, 0.2971),
  ('whiteboard', 'area_m2', 0.821105, 1.01167, 0.444),
  ('whiteboard', 'area_m2', 1.01167, 1.20056, 0.5736),
  ('whiteboard', 'area_m2', 1.20056, 1.37184, 0.7186),
  ('whiteboard', 'area_m2', 1.37184, 1.59552, 0.7239),
  ('whiteboard', 'area_m2', 1.59552, 1.86437, 0.5667),
  ('whiteboard', 'area_m2', 1.86437, 1.93665, 0.7855),
  ('whiteboard', 'area_m2', 1.93665, 2.21253, 0.8908),
  ('whiteboard', 'area_m2', 2.21253, 2.61791, 0.6186),
  ('whiteboard', 'area_m2', 2.61791, 2.80931, 0.4012),
  ('whiteboard', 'area_m2', 2.80931, 4.23318, 0.1235),
  ('whiteboard', 'area_m2', 4.23318, 6.37872, 0.03829),
  ('whiteboard', 'area_m2', 6.37872, 100, 0.005124);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'aspect', 1, 1.0539, 1.923),
  ('whiteboard', 'aspect', 1.0539, 1.17863, 1.014),
  ('whiteboard', 'aspect', 1.17863, 1.30694, 1.133),
  ('whiteboard', 'aspect', 1.30694, 1.38917, 0.5856),
  ('whiteboard', 'aspect', 1.38917, 1.50835, 0.9288),
  ('whiteboard', 'aspect', 1.50835, 1.57786, 2.239),
  ('whiteboard', 'aspect', 1.57786, 1.63732, 0.9238),
  ('whiteboard', 'aspect', 1.63732, 1.75491, 1.046),
  ('whiteboard', 'aspect', 1.75491, 1.86391, 1.666),
  ('whiteboard', 'aspect', 1.86391, 1.9298, 1.138),
  ('whiteboard', 'aspect', 1.9298, 2.18564, 0.8073),
  ('whiteboard', 'aspect', 2.18564, 2.27452, 0.7094),
  ('whiteboard', 'aspect', 2.27452, 2.68082, 0.2338),
  ('whiteboard', 'aspect', 2.68082, 3.15969, 0.06011),
  ('whiteboard', 'aspect', 3.15969, 3.72411, 0.04759),
  ('whiteboard', 'aspect', 3.72411, 4.25001, 0.08749),
  ('whiteboard', 'aspect', 4.25001, 4.38935, 0.08685),
  ('whiteboard', 'aspect', 4.38935, 100, 0.003038);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'height', -0.5, 0.837274, 0.01083),
  ('whiteboard', 'height', 0.837274, 0.923738, 0.04239),
  ('whiteboard', 'height', 0.923738, 1.0102, 0.1153),
  ('whiteboard', 'height', 1.0102, 1.09666, 0.06574),
  ('whiteboard', 'height', 1.09666, 1.18313, 0.3605),
  ('whiteboard', 'height', 1.18313, 1.22935, 0.9109),
  ('whiteboard', 'height', 1.22935, 1.26959, 1.18),
  ('whiteboard', 'height', 1.26959, 1.32829, 1.621),
  ('whiteboard', 'height', 1.32829, 1.35606, 1.654),
  ('whiteboard', 'height', 1.35606, 1.38466, 2.43),
  ('whiteboard', 'height', 1.38466, 1.41447, 3.422),
  ('whiteboard', 'height', 1.41447, 1.43544, 4.411),
  ('whiteboard', 'height', 1.43544, 1.44252, 4.011),
  ('whiteboard', 'height', 1.44252, 1.46646, 3.406),
  ('whiteboard', 'height', 1.46646, 1.48757, 4.085),
  ('whiteboard', 'height', 1.48757, 1.52841, 2.97),
  ('whiteboard', 'height', 1.52841, 1.60683, 1.295),
  ('whiteboard', 'height', 1.60683, 1.61545, 0.4338),
  ('whiteboard', 'height', 1.61545, 4, 0.007361);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'length', 0.03, 0.920466, 0.004665),
  ('whiteboard', 'length', 0.920466, 1.09607, 0.195),
  ('whiteboard', 'length', 1.09607, 1.17847, 1.079),
  ('whiteboard', 'length', 1.17847, 1.26808, 1.503),
  ('whiteboard', 'length', 1.26808, 1.30244, 2.397),
  ('whiteboard', 'length', 1.30244, 1.49515, 0.9373),
  ('whiteboard', 'length', 1.49515, 1.55418, 0.4673),
  ('whiteboard', 'length', 1.55418, 1.69916, 1.053),
  ('whiteboard', 'length', 1.69916, 1.85069, 0.6398),
  ('whiteboard', 'length', 1.85069, 1.95474, 1.135),
  ('whiteboard', 'length', 1.95474, 2.17458, 1.019),
  ('whiteboard', 'length', 2.17458, 2.34799, 1.078),
  ('whiteboard', 'length', 2.34799, 2.6242, 0.8569),
  ('whiteboard', 'length', 2.6242, 3.12484, 0.1107),
  ('whiteboard', 'length', 3.12484, 3.721, 0.0551),
  ('whiteboard', 'length', 3.721, 4.43089, 0.07256),
  ('whiteboard', 'length', 4.43089, 30, 0.005884);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'rectangularity', 0, 0.464167, 0.02012),
  ('whiteboard', 'rectangularity', 0.464167, 0.51898, 0.3221),
  ('whiteboard', 'rectangularity', 0.51898, 0.573793, 0.5322),
  ('whiteboard', 'rectangularity', 0.573793, 0.628606, 0.9484),
  ('whiteboard', 'rectangularity', 0.628606, 0.683419, 1.114),
  ('whiteboard', 'rectangularity', 0.683419, 0.719834, 1.53),
  ('whiteboard', 'rectangularity', 0.719834, 0.738232, 1.926),
  ('whiteboard', 'rectangularity', 0.738232, 0.783626, 2.203),
  ('whiteboard', 'rectangularity', 0.783626, 0.793045, 3.091),
  ('whiteboard', 'rectangularity', 0.793045, 0.810918, 3.886),
  ('whiteboard', 'rectangularity', 0.810918, 0.83818, 4.622),
  ('whiteboard', 'rectangularity', 0.83818, 0.847859, 7.103),
  ('whiteboard', 'rectangularity', 0.847859, 0.863512, 6.743),
  ('whiteboard', 'rectangularity', 0.863512, 0.902672, 3.608),
  ('whiteboard', 'rectangularity', 0.902672, 0.944222, 1.825),
  ('whiteboard', 'rectangularity', 0.944222, 0.957485, 0.7284),
  ('whiteboard', 'rectangularity', 0.957485, 1, 0.3278);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_length', 0.01, 0.772663, 0.002877),
  ('whiteboard', 'spread_length', 0.772663, 0.91425, 0.2308),
  ('whiteboard', 'spread_length', 0.91425, 1.03771, 0.5325),
  ('whiteboard', 'spread_length', 1.03771, 1.08178, 1.051),
  ('whiteboard', 'spread_length', 1.08178, 1.12405, 1.776),
  ('whiteboard', 'spread_length', 1.12405, 1.19934, 1.524),
  ('whiteboard', 'spread_length', 1.19934, 1.28001, 0.9901),
  ('whiteboard', 'spread_length', 1.28001, 1.33731, 0.9377),
  ('whiteboard', 'spread_length', 1.33731, 1.46678, 1.276),
  ('whiteboard', 'spread_length', 1.46678, 1.51457, 1.22),
  ('whiteboard', 'spread_length', 1.51457, 1.62266, 0.9537),
  ('whiteboard', 'spread_length', 1.62266, 1.7921, 0.8818),
  ('whiteboard', 'spread_length', 1.7921, 1.85228, 1.08),
  ('whiteboard', 'spread_length', 1.85228, 2.01687, 1.22),
  ('whiteboard', 'spread_length', 2.01687, 2.1205, 0.6221),
  ('whiteboard', 'spread_length', 2.1205, 2.50907, 0.2661),
  ('whiteboard', 'spread_length', 2.50907, 2.96884, 0.08562),
  ('whiteboard', 'spread_length', 2.96884, 3.32297, 0.09785),
  ('whiteboard', 'spread_length', 3.32297, 3.51286, 0.09346),
  ('whiteboard', 'spread_length', 3.51286, 40, 0.003534);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_width', 0.003, 0.182413, 0.003596),
  ('whiteboard', 'spread_width', 0.182413, 0.233558, 0.02497),
  ('whiteboard', 'spread_width', 0.233558, 0.299044, 0.03751),
  ('whiteboard', 'spread_width', 0.299044, 0.382891, 0.04387),
  ('whiteboard', 'spread_width', 0.382891, 0.490248, 0.09531),
  ('whiteboard', 'spread_width', 0.490248, 0.627705, 0.2318),
  ('whiteboard', 'spread_width', 0.627705, 0.657734, 0.4849),
  ('whiteboard', 'spread_width', 0.657734, 0.761749, 0.8489),
  ('whiteboard', 'spread_width', 0.761749, 0.784535, 2.204),
  ('whiteboard', 'spread_width', 0.784535, 0.803703, 1.968),
  ('whiteboard', 'spread_width', 0.803703, 0.851707, 1.175),
  ('whiteboard', 'spread_width', 0.851707, 0.914666, 1.785),
  ('whiteboard', 'spread_width', 0.914666, 0.953767, 2.03),
  ('whiteboard', 'spread_width', 0.953767, 1.02572, 1.352),
  ('whiteboard', 'spread_width', 1.02572, 1.1057, 1.378),
  ('whiteboard', 'spread_width', 1.1057, 1.31758, 0.4729),
  ('whiteboard', 'spread_width', 1.31758, 1.687, 0.1414),
  ('whiteboard', 'spread_width', 1.687, 20, 0.007386);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'tilt_deg', 0, 83.0673, 0.0001797),
  ('whiteboard', 'tilt_deg', 83.0673, 83.8376, 2.065e-07),
  ('whiteboard', 'tilt_deg', 83.8376, 84.6079, 4.276e-06),
  ('whiteboard', 'tilt_deg', 84.6079, 85.3782, 0.005906),
  ('whiteboard', 'tilt_deg', 85.3782, 86.1485, 0.033),
  ('whiteboard', 'tilt_deg', 86.1485, 86.9188, 0.003375),
  ('whiteboard', 'tilt_deg', 86.9188, 87.6891, 0.0136),
  ('whiteboard', 'tilt_deg', 87.6891, 88.4594, 0.05552),
  ('whiteboard', 'tilt_deg', 88.4594, 89.2297, 0.1199),
  ('whiteboard', 'tilt_deg', 89.2297, 90, 1.048);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'width', 0.01, 0.252031, 0.004626),
  ('whiteboard', 'width', 0.252031, 0.324007, 0.03164),
  ('whiteboard', 'width', 0.324007, 0.416539, 0.03609),
  ('whiteboard', 'width', 0.416539, 0.535497, 0.08274),
  ('whiteboard', 'width', 0.535497, 0.688427, 0.1418),
  ('whiteboard', 'width', 0.688427, 0.80174, 0.3401),
  ('whiteboard', 'width', 0.80174, 0.885032, 0.5037),
  ('whiteboard', 'width', 0.885032, 1.00371, 0.5885),
  ('whiteboard', 'width', 1.00371, 1.05325, 1.672),
  ('whiteboard', 'width', 1.05325, 1.10983, 2.372),
  ('whiteboard', 'width', 1.10983, 1.13778, 2.77),
  ('whiteboard', 'width', 1.13778, 1.23255, 1.684),
  ('whiteboard', 'width', 1.23255, 1.28489, 2.072),
  ('whiteboard', 'width', 1.28489, 1.36963, 1.494),
  ('whiteboard', 'width', 1.36963, 1.46272, 0.5004),
  ('whiteboard', 'width', 1.46272, 1.88045, 0.2601),
  ('whiteboard', 'width', 1.88045, 2.41748, 0.1213),
  ('whiteboard', 'width', 2.41748, 12, 0.01084);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_max', -0.5, 1.22158, 0.005375),
  ('whiteboard', 'z_max', 1.22158, 1.41196, 0.1143),
  ('whiteboard', 'z_max', 1.41196, 1.60234, 0.1654),
  ('whiteboard', 'z_max', 1.60234, 1.79272, 0.3515),
  ('whiteboard', 'z_max', 1.79272, 1.89976, 1.033),
  ('whiteboard', 'z_max', 1.89976, 1.94982, 1.658),
  ('whiteboard', 'z_max', 1.94982, 1.98311, 1.562),
  ('whiteboard', 'z_max', 1.98311, 2.03223, 1.968),
  ('whiteboard', 'z_max', 2.03223, 2.08538, 1.822),
  ('whiteboard', 'z_max', 2.08538, 2.09939, 3.86),
  ('whiteboard', 'z_max', 2.09939, 2.145, 2.939),
  ('whiteboard', 'z_max', 2.145, 2.17349, 2.206),
  ('whiteboard', 'z_max', 2.17349, 2.23891, 0.7718),
  ('whiteboard', 'z_max', 2.23891, 2.36387, 0.3942),
  ('whiteboard', 'z_max', 2.36387, 2.55425, 0.2177),
  ('whiteboard', 'z_max', 2.55425, 2.74464, 0.05659),
  ('whiteboard', 'z_max', 2.74464, 2.93502, 0.0944),
  ('whiteboard', 'z_max', 2.93502, 4, 0.009973);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_min', -0.5, -0.029586, 0.01861),
  ('whiteboard', 'z_min', -0.029586, -0.0081798, 0.4004),
  ('whiteboard', 'z_min', -0.0081798, 0.0991421, 0.2565),
  ('whiteboard', 'z_min', 0.0991421, 0.22787, 0.07179),
  ('whiteboard', 'z_min', 0.22787, 0.356598, 0.08999),
  ('whiteboard', 'z_min', 0.356598, 0.485327, 0.1836),
  ('whiteboard', 'z_min', 0.485327, 0.607462, 0.3823),
  ('whiteboard', 'z_min', 0.607462, 0.614055, 0.4778),
  ('whiteboard', 'z_min', 0.614055, 0.742783, 0.6984),
  ('whiteboard', 'z_min', 0.742783, 0.763683, 1.209),
  ('whiteboard', 'z_min', 0.763683, 0.807255, 2.62),
  ('whiteboard', 'z_min', 0.807255, 0.829747, 4.329),
  ('whiteboard', 'z_min', 0.829747, 0.851922, 3.779),
  ('whiteboard', 'z_min', 0.851922, 0.871511, 3.683),
  ('whiteboard', 'z_min', 0.871511, 0.899975, 2.217),
  ('whiteboard', 'z_min', 0.899975, 0.932745, 2.792),
  ('whiteboard', 'z_min', 0.932745, 0.958684, 3.06),
  ('whiteboard', 'z_min', 0.958684, 1.00024, 1.543),
  ('whiteboard', 'z_min', 1.00024, 1.12897, 0.4186),
  ('whiteboard', 'z_min', 1.12897, 4, 0.009133);

-- shelf: 241 examples
UPDATE object_class SET prior = 0.05291 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.456, 0.7348)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.988, 0.4542)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9538, 0.4938)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.03979, 0.5113)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6959, 0.133)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.2105, 0.509)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.218, 0.3457)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 53.33, 43.22)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.033, 0.3177)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.299, 0.6401)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5758, 0.5878)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'area_m2', 0.002, 0.0216125, 0.003773),
  ('shelf', 'area_m2', 0.0216125, 0.0326617, 0.03148),
  ('shelf', 'area_m2', 0.0326617, 0.0493596, 0.0617),
  ('shelf', 'area_m2', 0.0493596, 0.0745941, 0.0647),
  ('shelf', 'area_m2', 0.0745941, 0.0990154, 0.1371),
  ('shelf', 'area_m2', 0.0990154, 0.11273, 0.239),
  ('shelf', 'area_m2', 0.11273, 0.138332, 0.3534),
  ('shelf', 'area_m2', 0.138332, 0.170361, 0.2584),
  ('shelf', 'area_m2', 0.170361, 0.196791, 0.5006),
  ('shelf', 'area_m2', 0.196791, 0.235261, 0.5717),
  ('shelf', 'area_m2', 0.235261, 0.257456, 0.6282),
  ('shelf', 'area_m2', 0.257456, 0.288945, 0.4937),
  ('shelf', 'area_m2', 0.288945, 0.335393, 0.7556),
  ('shelf', 'area_m2', 0.335393, 0.389078, 0.611),
  ('shelf', 'area_m2', 0.389078, 0.406102, 0.4107),
  ('shelf', 'area_m2', 0.406102, 0.530566, 0.3963),
  ('shelf', 'area_m2', 0.530566, 0.587989, 0.346),
  ('shelf', 'area_m2', 0.587989, 0.888592, 0.1711),
  ('shelf', 'area_m2', 0.888592, 100, 0.001882);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'aspect', 1, 1.23497, 0.2379),
  ('shelf', 'aspect', 1.23497, 1.48121, 0.3137),
  ('shelf', 'aspect', 1.48121, 1.52515, 0.4105),
  ('shelf', 'aspect', 1.52515, 1.84228, 0.5313),
  ('shelf', 'aspect', 1.84228, 1.88351, 0.519),
  ('shelf', 'aspect', 1.88351, 2.10659, 0.8872),
  ('shelf', 'aspect', 2.10659, 2.32608, 0.6159),
  ('shelf', 'aspect', 2.32608, 2.57941, 0.5823),
  ('shelf', 'aspect', 2.57941, 2.87264, 0.7937),
  ('shelf', 'aspect', 2.87264, 2.93573, 0.9929),
  ('shelf', 'aspect', 2.93573, 3.32985, 0.8714),
  ('shelf', 'aspect', 3.32985, 3.54762, 0.9271),
  ('shelf', 'aspect', 3.54762, 3.97388, 0.4516),
  ('shelf', 'aspect', 3.97388, 4.3812, 0.5742),
  ('shelf', 'aspect', 4.3812, 4.98549, 0.3859),
  ('shelf', 'aspect', 4.98549, 5.41064, 0.5499),
  ('shelf', 'aspect', 5.41064, 6.68198, 0.3081),
  ('shelf', 'aspect', 6.68198, 100, 0.002092);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'height', -0.5, -0.00403624, 0.002531),
  ('shelf', 'height', -0.00403624, 0.051472, 0.1381),
  ('shelf', 'height', 0.051472, 0.240027, 0.3967),
  ('shelf', 'height', 0.240027, 0.397359, 0.2048),
  ('shelf', 'height', 0.397359, 0.484089, 0.742),
  ('shelf', 'height', 0.484089, 0.537299, 0.7069),
  ('shelf', 'height', 0.537299, 0.728152, 0.5558),
  ('shelf', 'height', 0.728152, 0.74694, 0.7471),
  ('shelf', 'height', 0.74694, 0.896797, 0.7154),
  ('shelf', 'height', 0.896797, 0.972215, 0.9111),
  ('shelf', 'height', 0.972215, 1.01252, 0.9402),
  ('shelf', 'height', 1.01252, 1.12759, 0.9611),
  ('shelf', 'height', 1.12759, 1.21628, 0.7745),
  ('shelf', 'height', 1.21628, 1.28736, 0.6402),
  ('shelf', 'height', 1.28736, 1.46034, 0.4831),
  ('shelf', 'height', 1.46034, 1.5566, 0.3058),
  ('shelf', 'height', 1.5566, 1.7044, 0.2056),
  ('shelf', 'height', 1.7044, 1.94847, 0.1628),
  ('shelf', 'height', 1.94847, 2.15778, 0.1331),
  ('shelf', 'height', 2.15778, 2.19253, 0.08927),
  ('shelf', 'height', 2.19253, 4, 0.005157);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'length', 0.03, 0.213229, 0.005586),
  ('shelf', 'length', 0.213229, 0.279095, 0.06994),
  ('shelf', 'length', 0.279095, 0.365307, 0.09495),
  ('shelf', 'length', 0.365307, 0.47815, 0.1118),
  ('shelf', 'length', 0.47815, 0.528306, 0.266),
  ('shelf', 'length', 0.528306, 0.625851, 0.4179),
  ('shelf', 'length', 0.625851, 0.681427, 0.5412),
  ('shelf', 'length', 0.681427, 0.815313, 0.5742),
  ('shelf', 'length', 0.815313, 0.946932, 0.7639),
  ('shelf', 'length', 0.946932, 1.07222, 0.8037),
  ('shelf', 'length', 1.07222, 1.21957, 0.9436),
  ('shelf', 'length', 1.21957, 1.40343, 0.6439),
  ('shelf', 'length', 1.40343, 1.44087, 0.6444),
  ('shelf', 'length', 1.44087, 1.76413, 0.5372),
  ('shelf', 'length', 1.76413, 1.83694, 0.3003),
  ('shelf', 'length', 1.83694, 2.27205, 0.433),
  ('shelf', 'length', 2.27205, 2.40437, 0.145),
  ('shelf', 'length', 2.40437, 30, 0.001559);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'rectangularity', 0, 0.399035, 0.01889),
  ('shelf', 'rectangularity', 0.399035, 0.405205, 0.3015),
  ('shelf', 'rectangularity', 0.405205, 0.460827, 0.5413),
  ('shelf', 'rectangularity', 0.460827, 0.514627, 1.243),
  ('shelf', 'rectangularity', 0.514627, 0.522618, 1.604),
  ('shelf', 'rectangularity', 0.522618, 0.576876, 1.923),
  ('shelf', 'rectangularity', 0.576876, 0.58441, 2.553),
  ('shelf', 'rectangularity', 0.58441, 0.624889, 2.15),
  ('shelf', 'rectangularity', 0.624889, 0.646201, 1.797),
  ('shelf', 'rectangularity', 0.646201, 0.685984, 1.964),
  ('shelf', 'rectangularity', 0.685984, 0.707992, 1.966),
  ('shelf', 'rectangularity', 0.707992, 0.732323, 2.731),
  ('shelf', 'rectangularity', 0.732323, 0.769784, 2.863),
  ('shelf', 'rectangularity', 0.769784, 0.807451, 2.999),
  ('shelf', 'rectangularity', 0.807451, 0.831575, 2.152),
  ('shelf', 'rectangularity', 0.831575, 0.855768, 2.214),
  ('shelf', 'rectangularity', 0.855768, 0.893367, 1.765),
  ('shelf', 'rectangularity', 0.893367, 0.953747, 0.7391),
  ('shelf', 'rectangularity', 0.953747, 1, 0.1596);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_length', 0.01, 0.204044, 0.003751),
  ('shelf', 'spread_length', 0.204044, 0.264253, 0.08089),
  ('shelf', 'spread_length', 0.264253, 0.342228, 0.1205),
  ('shelf', 'spread_length', 0.342228, 0.422919, 0.214),
  ('shelf', 'spread_length', 0.422919, 0.443212, 0.2847),
  ('shelf', 'spread_length', 0.443212, 0.571106, 0.3855),
  ('shelf', 'spread_length', 0.571106, 0.662506, 0.7917),
  ('shelf', 'spread_length', 0.662506, 0.743369, 0.8604),
  ('shelf', 'spread_length', 0.743369, 0.762685, 0.6703),
  ('shelf', 'spread_length', 0.762685, 0.921831, 0.5379),
  ('shelf', 'spread_length', 0.921831, 0.962721, 0.6096),
  ('shelf', 'spread_length', 0.962721, 1.07097, 0.867),
  ('shelf', 'spread_length', 1.07097, 1.222, 0.8118),
  ('shelf', 'spread_length', 1.222, 1.2468, 0.7805),
  ('shelf', 'spread_length', 1.2468, 1.51042, 0.464),
  ('shelf', 'spread_length', 1.51042, 1.6147, 0.3253),
  ('shelf', 'spread_length', 1.6147, 2.09117, 0.3289),
  ('shelf', 'spread_length', 2.09117, 40, 0.002403);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_width', 0.003, 0.114006, 0.002847),
  ('shelf', 'spread_width', 0.114006, 0.139428, 0.1354),
  ('shelf', 'spread_width', 0.139428, 0.17052, 0.1834),
  ('shelf', 'spread_width', 0.17052, 0.184539, 0.4353),
  ('shelf', 'spread_width', 0.184539, 0.208545, 0.485),
  ('shelf', 'spread_width', 0.208545, 0.239717, 0.4592),
  ('shelf', 'spread_width', 0.239717, 0.255049, 0.8683),
  ('shelf', 'spread_width', 0.255049, 0.275246, 0.7212),
  ('shelf', 'spread_width', 0.275246, 0.298075, 1.356),
  ('shelf', 'spread_width', 0.298075, 0.311924, 1.042),
  ('shelf', 'spread_width', 0.311924, 0.328565, 1.348),
  ('shelf', 'spread_width', 0.328565, 0.346457, 1.803),
  ('shelf', 'spread_width', 0.346457, 0.381482, 1.109),
  ('shelf', 'spread_width', 0.381482, 0.423181, 1.106),
  ('shelf', 'spread_width', 0.423181, 0.46655, 0.6481),
  ('shelf', 'spread_width', 0.46655, 0.570588, 0.1665),
  ('shelf', 'spread_width', 0.570588, 0.697827, 0.05214),
  ('shelf', 'spread_width', 0.697827, 20, 0.002744);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'tilt_deg', 0, 0.878206, 0.1178),
  ('shelf', 'tilt_deg', 0.878206, 1.74026, 0.1296),
  ('shelf', 'tilt_deg', 1.74026, 3.31527, 0.06952),
  ('shelf', 'tilt_deg', 3.31527, 10, 0.01073),
  ('shelf', 'tilt_deg', 10, 20, 0.000748),
  ('shelf', 'tilt_deg', 20, 30, 0.0004658),
  ('shelf', 'tilt_deg', 30, 40, 0.0005006),
  ('shelf', 'tilt_deg', 40, 50, 0.000536),
  ('shelf', 'tilt_deg', 50, 60, 0.0005668),
  ('shelf', 'tilt_deg', 60, 70, 0.0005903),
  ('shelf', 'tilt_deg', 70, 80, 0.0006373),
  ('shelf', 'tilt_deg', 80, 88.0898, 0.003928),
  ('shelf', 'tilt_deg', 88.0898, 89.7295, 0.1247),
  ('shelf', 'tilt_deg', 89.7295, 90, 1.209);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'width', 0.01, 0.123427, 0.002703),
  ('shelf', 'width', 0.123427, 0.151968, 0.09901),
  ('shelf', 'width', 0.151968, 0.18711, 0.1142),
  ('shelf', 'width', 0.18711, 0.230378, 0.2142),
  ('shelf', 'width', 0.230378, 0.24908, 0.2236),
  ('shelf', 'width', 0.24908, 0.283651, 0.3303),
  ('shelf', 'width', 0.283651, 0.308279, 0.8925),
  ('shelf', 'width', 0.308279, 0.336472, 1.245),
  ('shelf', 'width', 0.336472, 0.349243, 1.893),
  ('shelf', 'width', 0.349243, 0.356445, 1.814),
  ('shelf', 'width', 0.356445, 0.381644, 1.695),
  ('shelf', 'width', 0.381644, 0.411407, 1.371),
  ('shelf', 'width', 0.411407, 0.430003, 1.856),
  ('shelf', 'width', 0.430003, 0.435868, 2.149),
  ('shelf', 'width', 0.435868, 0.481353, 1.165),
  ('shelf', 'width', 0.481353, 0.529438, 0.4446),
  ('shelf', 'width', 0.529438, 0.651866, 0.2072),
  ('shelf', 'width', 0.651866, 0.802606, 0.05212),
  ('shelf', 'width', 0.802606, 12, 0.004152);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_max', -0.5, -0.00733865, 0.001968),
  ('shelf', 'z_max', -0.00733865, 0.0657923, 0.2893),
  ('shelf', 'z_max', 0.0657923, 0.253875, 0.2946),
  ('shelf', 'z_max', 0.253875, 0.425992, 0.2121),
  ('shelf', 'z_max', 0.425992, 0.515089, 0.6817),
  ('shelf', 'z_max', 0.515089, 0.622255, 0.3956),
  ('shelf', 'z_max', 0.622255, 0.776304, 0.2306),
  ('shelf', 'z_max', 0.776304, 1.03752, 0.261),
  ('shelf', 'z_max', 1.03752, 1.07215, 0.4069),
  ('shelf', 'z_max', 1.07215, 1.29873, 0.408),
  ('shelf', 'z_max', 1.29873, 1.34604, 0.375),
  ('shelf', 'z_max', 1.34604, 1.55069, 0.5436),
  ('shelf', 'z_max', 1.55069, 1.69247, 0.8309),
  ('shelf', 'z_max', 1.69247, 1.82116, 0.6499),
  ('shelf', 'z_max', 1.82116, 1.86216, 0.5425),
  ('shelf', 'z_max', 1.86216, 2.04111, 0.5658),
  ('shelf', 'z_max', 2.04111, 2.08237, 0.4375),
  ('shelf', 'z_max', 2.08237, 2.34359, 0.3507),
  ('shelf', 'z_max', 2.34359, 4, 0.005433);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_min', -0.5, -0.0697527, 0.01494),
  ('shelf', 'z_min', -0.0697527, -0.0433373, 0.1019),
  ('shelf', 'z_min', -0.0433373, -0.00583058, 2.566),
  ('shelf', 'z_min', -0.00583058, 0.0250437, 3.569),
  ('shelf', 'z_min', 0.0250437, 0.0902063, 1.763),
  ('shelf', 'z_min', 0.0902063, 0.179532, 0.456),
  ('shelf', 'z_min', 0.179532, 0.406798, 0.3166),
  ('shelf', 'z_min', 0.406798, 0.428816, 1.262),
  ('shelf', 'z_min', 0.428816, 0.498165, 1.106),
  ('shelf', 'z_min', 0.498165, 0.678101, 0.454),
  ('shelf', 'z_min', 0.678101, 0.752313, 0.4579),
  ('shelf', 'z_min', 0.752313, 0.927386, 0.5167),
  ('shelf', 'z_min', 0.927386, 0.952675, 0.4453),
  ('shelf', 'z_min', 0.952675, 1.17667, 0.4786),
  ('shelf', 'z_min', 1.17667, 1.42595, 0.07683),
  ('shelf', 'z_min', 1.42595, 1.67524, 0.1121),
  ('shelf', 'z_min', 1.67524, 1.92452, 0.15),
  ('shelf', 'z_min', 1.92452, 2.1537, 0.1354),
  ('shelf', 'z_min', 2.1537, 2.17381, 0.09176),
  ('shelf', 'z_min', 2.17381, 4, 0.005731);

-- cabinet: 309 examples
UPDATE object_class SET prior = 0.06742 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.8387, 0.9737)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6148, 0.415)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7493, 0.3468)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.06613, 0.5224)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7173, 0.1386)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1227, 0.5254)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7784, 0.5112)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 76.04, 32.07)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.552, 0.4817)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.203, 0.5717)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.211, 0.323)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'area_m2', 0.002, 0.0267466, 0.003478),
  ('cabinet', 'area_m2', 0.0267466, 0.045993, 0.02832),
  ('cabinet', 'area_m2', 0.045993, 0.0790889, 0.06469),
  ('cabinet', 'area_m2', 0.0790889, 0.119844, 0.1184),
  ('cabinet', 'area_m2', 0.119844, 0.136, 0.1469),
  ('cabinet', 'area_m2', 0.136, 0.220888, 0.1987),
  ('cabinet', 'area_m2', 0.220888, 0.233864, 0.27),
  ('cabinet', 'area_m2', 0.233864, 0.322316, 0.2917),
  ('cabinet', 'area_m2', 0.322316, 0.380793, 0.6445),
  ('cabinet', 'area_m2', 0.380793, 0.402148, 0.6033),
  ('cabinet', 'area_m2', 0.402148, 0.515711, 0.3372),
  ('cabinet', 'area_m2', 0.515711, 0.691527, 0.342),
  ('cabinet', 'area_m2', 0.691527, 0.722761, 0.3115),
  ('cabinet', 'area_m2', 0.722761, 0.982601, 0.3435),
  ('cabinet', 'area_m2', 0.982601, 1.18914, 0.3976),
  ('cabinet', 'area_m2', 1.18914, 1.36209, 0.2508),
  ('cabinet', 'area_m2', 1.36209, 2.04483, 0.2028),
  ('cabinet', 'area_m2', 2.04483, 3.51625, 0.04505),
  ('cabinet', 'area_m2', 3.51625, 100, 0.002057);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'aspect', 1, 1.15149, 0.8227),
  ('cabinet', 'aspect', 1.15149, 1.21767, 1.203),
  ('cabinet', 'aspect', 1.21767, 1.26059, 1.037),
  ('cabinet', 'aspect', 1.26059, 1.41712, 0.9413),
  ('cabinet', 'aspect', 1.41712, 1.48271, 0.5956),
  ('cabinet', 'aspect', 1.48271, 1.62504, 0.9265),
  ('cabinet', 'aspect', 1.62504, 1.80545, 0.8039),
  ('cabinet', 'aspect', 1.80545, 1.89369, 0.5834),
  ('cabinet', 'aspect', 1.89369, 2.12524, 0.9384),
  ('cabinet', 'aspect', 2.12524, 2.19843, 0.6023),
  ('cabinet', 'aspect', 2.19843, 2.47217, 0.7238),
  ('cabinet', 'aspect', 2.47217, 2.67695, 0.5259),
  ('cabinet', 'aspect', 2.67695, 3.17281, 0.4416),
  ('cabinet', 'aspect', 3.17281, 3.25963, 0.4052),
  ('cabinet', 'aspect', 3.25963, 3.96915, 0.284),
  ('cabinet', 'aspect', 3.96915, 4.83309, 0.1217),
  ('cabinet', 'aspect', 4.83309, 5.88509, 0.06278),
  ('cabinet', 'aspect', 5.88509, 100, 0.004446);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'height', -0.5, 0.153999, 0.01261),
  ('cabinet', 'height', 0.153999, 0.306497, 0.5765),
  ('cabinet', 'height', 0.306497, 0.445821, 0.9159),
  ('cabinet', 'height', 0.445821, 0.458995, 0.699),
  ('cabinet', 'height', 0.458995, 0.551946, 1.035),
  ('cabinet', 'height', 0.551946, 0.59856, 2.386),
  ('cabinet', 'height', 0.59856, 0.611493, 0.984),
  ('cabinet', 'height', 0.611493, 0.763992, 0.5933),
  ('cabinet', 'height', 0.763992, 0.783216, 0.4335),
  ('cabinet', 'height', 0.783216, 0.91649, 0.5882),
  ('cabinet', 'height', 0.91649, 0.944305, 1.364),
  ('cabinet', 'height', 0.944305, 1.04783, 1.052),
  ('cabinet', 'height', 1.04783, 1.06899, 0.8945),
  ('cabinet', 'height', 1.06899, 1.22149, 0.6009),
  ('cabinet', 'height', 1.22149, 1.37398, 0.4721),
  ('cabinet', 'height', 1.37398, 1.49772, 0.2345),
  ('cabinet', 'height', 1.49772, 1.52648, 0.1402),
  ('cabinet', 'height', 1.52648, 4, 0.002922);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'length', 0.03, 0.219653, 0.004025),
  ('cabinet', 'length', 0.219653, 0.290264, 0.04116),
  ('cabinet', 'length', 0.290264, 0.383573, 0.06696),
  ('cabinet', 'length', 0.383573, 0.506878, 0.143),
  ('cabinet', 'length', 0.506878, 0.590074, 0.2641),
  ('cabinet', 'length', 0.590074, 0.66982, 0.5099),
  ('cabinet', 'length', 0.66982, 0.726518, 0.5054),
  ('cabinet', 'length', 0.726518, 0.837404, 0.7685),
  ('cabinet', 'length', 0.837404, 0.885143, 0.6243),
  ('cabinet', 'length', 0.885143, 1.01122, 0.5846),
  ('cabinet', 'length', 1.01122, 1.16968, 0.6616),
  ('cabinet', 'length', 1.16968, 1.19473, 0.5914),
  ('cabinet', 'length', 1.19473, 1.47617, 0.5376),
  ('cabinet', 'length', 1.47617, 1.5457, 0.3596),
  ('cabinet', 'length', 1.5457, 1.75095, 0.7576),
  ('cabinet', 'length', 1.75095, 1.97151, 0.9221),
  ('cabinet', 'length', 1.97151, 2.04258, 0.8163),
  ('cabinet', 'length', 2.04258, 2.68507, 0.2772),
  ('cabinet', 'length', 2.68507, 30, 0.002824);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'rectangularity', 0, 0.358581, 0.02346),
  ('cabinet', 'rectangularity', 0.358581, 0.428818, 0.2567),
  ('cabinet', 'rectangularity', 0.428818, 0.499056, 0.5114),
  ('cabinet', 'rectangularity', 0.499056, 0.541811, 1.179),
  ('cabinet', 'rectangularity', 0.541811, 0.569294, 1.413),
  ('cabinet', 'rectangularity', 0.569294, 0.604576, 2.18),
  ('cabinet', 'rectangularity', 0.604576, 0.639532, 2.077),
  ('cabinet', 'rectangularity', 0.639532, 0.65582, 1.918),
  ('cabinet', 'rectangularity', 0.65582, 0.699165, 2.628),
  ('cabinet', 'rectangularity', 0.699165, 0.70977, 2.275),
  ('cabinet', 'rectangularity', 0.70977, 0.74836, 2.135),
  ('cabinet', 'rectangularity', 0.74836, 0.780008, 2.231),
  ('cabinet', 'rectangularity', 0.780008, 0.795439, 2.699),
  ('cabinet', 'rectangularity', 0.795439, 0.834716, 2.871),
  ('cabinet', 'rectangularity', 0.834716, 0.850246, 3.034),
  ('cabinet', 'rectangularity', 0.850246, 0.886587, 1.782),
  ('cabinet', 'rectangularity', 0.886587, 0.920483, 1.352),
  ('cabinet', 'rectangularity', 0.920483, 0.977305, 0.9315),
  ('cabinet', 'rectangularity', 0.977305, 0.990721, 0.544),
  ('cabinet', 'rectangularity', 0.990721, 1, 0.4636);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_length', 0.01, 0.193934, 0.002347),
  ('cabinet', 'spread_length', 0.193934, 0.25394, 0.0368),
  ('cabinet', 'spread_length', 0.25394, 0.332511, 0.04276),
  ('cabinet', 'spread_length', 0.332511, 0.435393, 0.2568),
  ('cabinet', 'spread_length', 0.435393, 0.449812, 0.2918),
  ('cabinet', 'spread_length', 0.449812, 0.570108, 0.35),
  ('cabinet', 'spread_length', 0.570108, 0.591258, 0.8501),
  ('cabinet', 'spread_length', 0.591258, 0.676089, 0.8399),
  ('cabinet', 'spread_length', 0.676089, 0.746505, 0.8502),
  ('cabinet', 'spread_length', 0.746505, 0.800247, 0.3654),
  ('cabinet', 'spread_length', 0.800247, 0.964261, 0.5957),
  ('cabinet', 'spread_length', 0.964261, 1.18806, 0.5394),
  ('cabinet', 'spread_length', 1.18806, 1.27992, 0.5315),
  ('cabinet', 'spread_length', 1.27992, 1.50719, 0.4439),
  ('cabinet', 'spread_length', 1.50719, 1.67595, 0.7245),
  ('cabinet', 'spread_length', 1.67595, 1.72808, 0.9728),
  ('cabinet', 'spread_length', 1.72808, 2.1945, 0.4405),
  ('cabinet', 'spread_length', 2.1945, 40, 0.003093);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_width', 0.003, 0.122145, 0.00304),
  ('cabinet', 'spread_width', 0.122145, 0.161018, 0.1163),
  ('cabinet', 'spread_width', 0.161018, 0.212263, 0.1372),
  ('cabinet', 'spread_width', 0.212263, 0.233717, 0.311),
  ('cabinet', 'spread_width', 0.233717, 0.279816, 0.2875),
  ('cabinet', 'spread_width', 0.279816, 0.328625, 0.374),
  ('cabinet', 'spread_width', 0.328625, 0.368869, 0.5855),
  ('cabinet', 'spread_width', 0.368869, 0.39067, 0.6451),
  ('cabinet', 'spread_width', 0.39067, 0.452497, 0.7759),
  ('cabinet', 'spread_width', 0.452497, 0.486263, 0.9805),
  ('cabinet', 'spread_width', 0.486263, 0.513247, 0.8776),
  ('cabinet', 'spread_width', 0.513247, 0.560805, 1.047),
  ('cabinet', 'spread_width', 0.560805, 0.641018, 0.8377),
  ('cabinet', 'spread_width', 0.641018, 0.661527, 0.3382),
  ('cabinet', 'spread_width', 0.661527, 0.804331, 0.5488),
  ('cabinet', 'spread_width', 0.804331, 0.845025, 0.5787),
  ('cabinet', 'spread_width', 0.845025, 1.11396, 0.196),
  ('cabinet', 'spread_width', 1.11396, 1.46848, 0.09077),
  ('cabinet', 'spread_width', 1.46848, 20, 0.003739);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'tilt_deg', 0, 0.56248, 0.1786),
  ('cabinet', 'tilt_deg', 0.56248, 10, 0.004938),
  ('cabinet', 'tilt_deg', 10, 20, 9.548e-05),
  ('cabinet', 'tilt_deg', 20, 30, 0.0001581),
  ('cabinet', 'tilt_deg', 30, 40, 0.0002535),
  ('cabinet', 'tilt_deg', 40, 50, 0.0003781),
  ('cabinet', 'tilt_deg', 50, 60, 0.00052),
  ('cabinet', 'tilt_deg', 60, 70, 0.0006596),
  ('cabinet', 'tilt_deg', 70, 80, 0.0008304),
  ('cabinet', 'tilt_deg', 80, 88.7307, 0.009378),
  ('cabinet', 'tilt_deg', 88.7307, 89.7214, 0.2467),
  ('cabinet', 'tilt_deg', 89.7214, 90, 1.786);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'width', 0.01, 0.14561, 0.002848),
  ('cabinet', 'width', 0.14561, 0.191307, 0.08562),
  ('cabinet', 'width', 0.191307, 0.251347, 0.1558),
  ('cabinet', 'width', 0.251347, 0.32546, 0.1572),
  ('cabinet', 'width', 0.32546, 0.425167, 0.4017),
  ('cabinet', 'width', 0.425167, 0.433867, 0.3521),
  ('cabinet', 'width', 0.433867, 0.507683, 0.7061),
  ('cabinet', 'width', 0.507683, 0.570031, 0.7733),
  ('cabinet', 'width', 0.570031, 0.615168, 1.688),
  ('cabinet', 'width', 0.615168, 0.673298, 1.166),
  ('cabinet', 'width', 0.673298, 0.748928, 0.5094),
  ('cabinet', 'width', 0.748928, 0.834367, 0.5839),
  ('cabinet', 'width', 0.834367, 0.98397, 0.5405),
  ('cabinet', 'width', 0.98397, 1.01232, 0.7693),
  ('cabinet', 'width', 1.01232, 1.29278, 0.2939),
  ('cabinet', 'width', 1.29278, 1.6985, 0.1028),
  ('cabinet', 'width', 1.6985, 12, 0.004454);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_max', -0.5, 0.314427, 0.01093),
  ('cabinet', 'z_max', 0.314427, 0.561024, 0.1113),
  ('cabinet', 'z_max', 0.561024, 0.581077, 3.271),
  ('cabinet', 'z_max', 0.581077, 0.68655, 1.137),
  ('cabinet', 'z_max', 0.68655, 0.790222, 1.116),
  ('cabinet', 'z_max', 0.790222, 0.807621, 0.6747),
  ('cabinet', 'z_max', 0.807621, 0.950333, 0.6222),
  ('cabinet', 'z_max', 0.950333, 1.05422, 0.7439),
  ('cabinet', 'z_max', 1.05422, 1.1042, 0.7454),
  ('cabinet', 'z_max', 1.1042, 1.30081, 0.39),
  ('cabinet', 'z_max', 1.30081, 1.52289, 0.1583),
  ('cabinet', 'z_max', 1.52289, 1.54741, 0.1297),
  ('cabinet', 'z_max', 1.54741, 1.79401, 0.3895),
  ('cabinet', 'z_max', 1.79401, 1.82141, 0.5107),
  ('cabinet', 'z_max', 1.82141, 1.99447, 0.6711),
  ('cabinet', 'z_max', 1.99447, 2.0406, 0.3558),
  ('cabinet', 'z_max', 2.0406, 2.2872, 0.2549),
  ('cabinet', 'z_max', 2.2872, 2.5338, 0.07641),
  ('cabinet', 'z_max', 2.5338, 4, 0.005554);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_min', -0.5, -0.0527514, 0.03296),
  ('cabinet', 'z_min', -0.0527514, -0.0180794, 5.071),
  ('cabinet', 'z_min', -0.0180794, -0.0106167, 15.48),
  ('cabinet', 'z_min', -0.0106167, 0.0113984, 10.11),
  ('cabinet', 'z_min', 0.0113984, 0.0816379, 0.9187),
  ('cabinet', 'z_min', 0.0816379, 0.204284, 0.5097),
  ('cabinet', 'z_min', 0.204284, 0.216027, 0.4573),
  ('cabinet', 'z_min', 0.216027, 0.350417, 0.378),
  ('cabinet', 'z_min', 0.350417, 0.484806, 0.3724),
  ('cabinet', 'z_min', 0.484806, 0.51647, 0.3704),
  ('cabinet', 'z_min', 0.51647, 0.619195, 1.007),
  ('cabinet', 'z_min', 0.619195, 0.668967, 0.3398),
  ('cabinet', 'z_min', 0.668967, 0.753585, 0.2764),
  ('cabinet', 'z_min', 0.753585, 0.887974, 0.2134),
  ('cabinet', 'z_min', 0.887974, 1.02236, 0.1806),
  ('cabinet', 'z_min', 1.02236, 1.15675, 0.1293),
  ('cabinet', 'z_min', 1.15675, 4, 0.004296);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.0621 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.518 WHERE name = 'aspect';
UPDATE feature SET weight = 0.304 WHERE name = 'height';
UPDATE feature SET weight = 0 WHERE name = 'length';
UPDATE feature SET weight = 0.424 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.287 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.247 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.44 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.218 WHERE name = 'width';
UPDATE feature SET weight = 0.531 WHERE name = 'z_max';
UPDATE feature SET weight = 0.341 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.306 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0732 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0417 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.139 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0373 WHERE name = 'table';
UPDATE object_class SET prior = 0.0585 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.0849 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.0101 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0643 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0161 WHERE name = 'door';
UPDATE object_class SET prior = 0.0236 WHERE name = 'window';
UPDATE object_class SET prior = 0.0224 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0714 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.0517 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 3.06 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.55 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 2.49 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 4.01 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 3.66 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 0.271 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.65 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 2.9 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.79 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.74 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.841 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.4 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.637 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 2.82 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 5.08 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.43 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.577 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.801 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 1.51 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.528 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.01 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 0.868 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 1.23 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.21 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 0.621 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.266 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.02 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.28 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 0.0575 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.64 WHERE name = 'cabinet_not_on_table';
