-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise.
-- Densities and Gaussians: 5373 planes of 42 paper-like rooms, seeds from 1; 36 varied rooms, seeds from 301; 54 depth-camera frames, seeds from 101.
-- Priors and weights: 24 paper-like rooms, seeds from 11; 18 varied rooms, seeds from 401; 27 depth-camera frames, seeds from 201.

-- unknown: 2431 examples
UPDATE object_class SET prior = 0.5131 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.968, 1.227)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6312, 0.51)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 0.9699, 0.6614)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.4718, 0.7021)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.6962, 0.1518)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.6148, 0.7182)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.313, 0.6186)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 65.94, 36.07)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.106, 0.6237)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.226, 0.8364)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7007, 0.7036)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0153913, 0.00391),
  ('unknown', 'area_m2', 0.0153913, 0.0344073, 0.126),
  ('unknown', 'area_m2', 0.0344073, 0.0587122, 0.2156),
  ('unknown', 'area_m2', 0.0587122, 0.0769176, 0.3967),
  ('unknown', 'area_m2', 0.0769176, 0.102919, 0.3861),
  ('unknown', 'area_m2', 0.102919, 0.143205, 0.3343),
  ('unknown', 'area_m2', 0.143205, 0.17195, 0.2743),
  ('unknown', 'area_m2', 0.17195, 0.215824, 0.2752),
  ('unknown', 'area_m2', 0.215824, 0.308016, 0.3094),
  ('unknown', 'area_m2', 0.308016, 0.384394, 0.2414),
  ('unknown', 'area_m2', 0.384394, 0.534677, 0.1789),
  ('unknown', 'area_m2', 0.534677, 0.859314, 0.1291),
  ('unknown', 'area_m2', 0.859314, 1.921, 0.02734),
  ('unknown', 'area_m2', 1.921, 4.29441, 0.007401),
  ('unknown', 'area_m2', 4.29441, 9.60016, 0.005896),
  ('unknown', 'area_m2', 9.60016, 21.4612, 0.008763),
  ('unknown', 'area_m2', 21.4612, 100, 0.00599);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.11122, 1.045),
  ('unknown', 'aspect', 1.11122, 1.2339, 1.053),
  ('unknown', 'aspect', 1.2339, 1.26157, 0.992),
  ('unknown', 'aspect', 1.26157, 1.37831, 1.018),
  ('unknown', 'aspect', 1.37831, 1.5616, 0.9003),
  ('unknown', 'aspect', 1.5616, 1.59156, 0.8947),
  ('unknown', 'aspect', 1.59156, 1.76214, 0.9128),
  ('unknown', 'aspect', 1.76214, 2.00786, 0.795),
  ('unknown', 'aspect', 2.00786, 2.03821, 0.5703),
  ('unknown', 'aspect', 2.03821, 2.53306, 0.503),
  ('unknown', 'aspect', 2.53306, 3.19563, 0.2912),
  ('unknown', 'aspect', 3.19563, 4.03151, 0.1854),
  ('unknown', 'aspect', 4.03151, 4.10548, 0.1512),
  ('unknown', 'aspect', 4.10548, 5.08603, 0.156),
  ('unknown', 'aspect', 5.08603, 6.41639, 0.21),
  ('unknown', 'aspect', 6.41639, 8.09472, 0.07301),
  ('unknown', 'aspect', 8.09472, 100, 0.004254);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0454495, 0.01237),
  ('unknown', 'height', 0.0454495, 0.235456, 0.5575),
  ('unknown', 'height', 0.235456, 0.378134, 0.6008),
  ('unknown', 'height', 0.378134, 0.424814, 0.5851),
  ('unknown', 'height', 0.424814, 0.604522, 0.5967),
  ('unknown', 'height', 0.604522, 0.710819, 0.4646),
  ('unknown', 'height', 0.710819, 0.782901, 0.8375),
  ('unknown', 'height', 0.782901, 0.899934, 0.9601),
  ('unknown', 'height', 0.899934, 1.0435, 0.6167),
  ('unknown', 'height', 1.0435, 1.09972, 0.4072),
  ('unknown', 'height', 1.09972, 1.37619, 0.3667),
  ('unknown', 'height', 1.37619, 1.40862, 0.277),
  ('unknown', 'height', 1.40862, 1.70887, 0.3135),
  ('unknown', 'height', 1.70887, 1.81474, 0.1791),
  ('unknown', 'height', 1.81474, 2.04156, 0.1002),
  ('unknown', 'height', 2.04156, 2.37424, 0.1251),
  ('unknown', 'height', 2.37424, 2.70693, 0.06054),
  ('unknown', 'height', 2.70693, 3.03961, 0.04397),
  ('unknown', 'height', 3.03961, 4, 0.01139);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.150711, 0.004655),
  ('unknown', 'length', 0.150711, 0.229147, 0.1445),
  ('unknown', 'length', 0.229147, 0.267977, 0.2751),
  ('unknown', 'length', 0.267977, 0.348405, 0.3904),
  ('unknown', 'length', 0.348405, 0.353499, 0.5046),
  ('unknown', 'length', 0.353499, 0.452157, 0.4594),
  ('unknown', 'length', 0.452157, 0.529729, 0.6062),
  ('unknown', 'length', 0.529729, 0.544546, 0.5161),
  ('unknown', 'length', 0.544546, 0.664404, 0.5532),
  ('unknown', 'length', 0.664404, 0.805422, 0.5054),
  ('unknown', 'length', 0.805422, 0.829621, 0.5525),
  ('unknown', 'length', 0.829621, 1.05485, 0.4523),
  ('unknown', 'length', 1.05485, 1.2246, 0.3926),
  ('unknown', 'length', 1.2246, 1.37632, 0.4615),
  ('unknown', 'length', 1.37632, 1.86193, 0.234),
  ('unknown', 'length', 1.86193, 2.83095, 0.03061),
  ('unknown', 'length', 2.83095, 4.30429, 0.01888),
  ('unknown', 'length', 4.30429, 6.54442, 0.0219),
  ('unknown', 'length', 6.54442, 30, 0.006823);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.31034, 0.03294),
  ('unknown', 'rectangularity', 0.31034, 0.383144, 0.3052),
  ('unknown', 'rectangularity', 0.383144, 0.455948, 0.562),
  ('unknown', 'rectangularity', 0.455948, 0.492712, 1.023),
  ('unknown', 'rectangularity', 0.492712, 0.528752, 1.117),
  ('unknown', 'rectangularity', 0.528752, 0.57318, 1.603),
  ('unknown', 'rectangularity', 0.57318, 0.601556, 1.83),
  ('unknown', 'rectangularity', 0.601556, 0.638893, 1.572),
  ('unknown', 'rectangularity', 0.638893, 0.67436, 2.228),
  ('unknown', 'rectangularity', 0.67436, 0.689046, 2.147),
  ('unknown', 'rectangularity', 0.689046, 0.736263, 2.375),
  ('unknown', 'rectangularity', 0.736263, 0.747164, 2.378),
  ('unknown', 'rectangularity', 0.747164, 0.78123, 2.476),
  ('unknown', 'rectangularity', 0.78123, 0.819968, 2.565),
  ('unknown', 'rectangularity', 0.819968, 0.826204, 2.145),
  ('unknown', 'rectangularity', 0.826204, 0.878424, 2.095),
  ('unknown', 'rectangularity', 0.878424, 0.892772, 1.526),
  ('unknown', 'rectangularity', 0.892772, 0.965576, 1.154),
  ('unknown', 'rectangularity', 0.965576, 1, 0.171);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.144237, 0.002607),
  ('unknown', 'spread_length', 0.144237, 0.219756, 0.1883),
  ('unknown', 'spread_length', 0.219756, 0.23865, 0.3002),
  ('unknown', 'spread_length', 0.23865, 0.303446, 0.4667),
  ('unknown', 'spread_length', 0.303446, 0.334816, 0.6742),
  ('unknown', 'spread_length', 0.334816, 0.356442, 0.6844),
  ('unknown', 'spread_length', 0.356442, 0.441822, 0.5153),
  ('unknown', 'spread_length', 0.441822, 0.510117, 0.4633),
  ('unknown', 'spread_length', 0.510117, 0.575475, 0.3865),
  ('unknown', 'spread_length', 0.575475, 0.729882, 0.4652),
  ('unknown', 'spread_length', 0.729882, 0.777203, 0.5163),
  ('unknown', 'spread_length', 0.777203, 0.944464, 0.3991),
  ('unknown', 'spread_length', 0.944464, 1.18413, 0.4025),
  ('unknown', 'spread_length', 1.18413, 1.25581, 0.3643),
  ('unknown', 'spread_length', 1.25581, 1.80411, 0.2025),
  ('unknown', 'spread_length', 1.80411, 2.7487, 0.02709),
  ('unknown', 'spread_length', 2.7487, 4.18786, 0.01596),
  ('unknown', 'spread_length', 4.18786, 6.38053, 0.02164),
  ('unknown', 'spread_length', 6.38053, 40, 0.005468);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.107696, 0.0003645),
  ('unknown', 'spread_width', 0.107696, 0.110058, 0.1538),
  ('unknown', 'spread_width', 0.110058, 0.137267, 0.4852),
  ('unknown', 'spread_width', 0.137267, 0.161015, 0.5334),
  ('unknown', 'spread_width', 0.161015, 0.168655, 0.5368),
  ('unknown', 'spread_width', 0.168655, 0.200731, 0.6441),
  ('unknown', 'spread_width', 0.200731, 0.222188, 1.055),
  ('unknown', 'spread_width', 0.222188, 0.240732, 0.8756),
  ('unknown', 'spread_width', 0.240732, 0.261972, 0.5641),
  ('unknown', 'spread_width', 0.261972, 0.30753, 0.6681),
  ('unknown', 'spread_width', 0.30753, 0.359917, 0.4883),
  ('unknown', 'spread_width', 0.359917, 0.393689, 0.3859),
  ('unknown', 'spread_width', 0.393689, 0.538109, 0.3057),
  ('unknown', 'spread_width', 0.538109, 0.574462, 0.2407),
  ('unknown', 'spread_width', 0.574462, 0.804524, 0.2212),
  ('unknown', 'spread_width', 0.804524, 1.20284, 0.03499),
  ('unknown', 'spread_width', 1.20284, 1.79835, 0.009838),
  ('unknown', 'spread_width', 1.79835, 2.6887, 0.01258),
  ('unknown', 'spread_width', 2.6887, 4.01986, 0.01026),
  ('unknown', 'spread_width', 4.01986, 20, 0.005881);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 1.49639, 0.07271),
  ('unknown', 'tilt_deg', 1.49639, 10, 0.0115),
  ('unknown', 'tilt_deg', 10, 14.5784, 0.003417),
  ('unknown', 'tilt_deg', 14.5784, 20, 0.00268),
  ('unknown', 'tilt_deg', 20, 30, 0.001083),
  ('unknown', 'tilt_deg', 30, 40, 0.0006815),
  ('unknown', 'tilt_deg', 40, 50, 0.0006497),
  ('unknown', 'tilt_deg', 50, 60, 0.000706),
  ('unknown', 'tilt_deg', 60, 70, 0.001374),
  ('unknown', 'tilt_deg', 70, 79.7952, 0.005381),
  ('unknown', 'tilt_deg', 79.7952, 80, 0.006795),
  ('unknown', 'tilt_deg', 80, 86.8873, 0.01623),
  ('unknown', 'tilt_deg', 86.8873, 88.8234, 0.05842),
  ('unknown', 'tilt_deg', 88.8234, 89.5254, 0.1801),
  ('unknown', 'tilt_deg', 89.5254, 89.8182, 0.5405),
  ('unknown', 'tilt_deg', 89.8182, 90, 0.8502);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.115025, 0.003242),
  ('unknown', 'width', 0.115025, 0.162255, 0.2983),
  ('unknown', 'width', 0.162255, 0.171061, 0.5278),
  ('unknown', 'width', 0.171061, 0.205526, 0.4556),
  ('unknown', 'width', 0.205526, 0.238063, 0.7502),
  ('unknown', 'width', 0.238063, 0.254395, 0.8429),
  ('unknown', 'width', 0.254395, 0.279162, 0.6039),
  ('unknown', 'width', 0.279162, 0.337061, 0.5921),
  ('unknown', 'width', 0.337061, 0.378326, 0.7334),
  ('unknown', 'width', 0.378326, 0.397448, 0.5068),
  ('unknown', 'width', 0.397448, 0.494772, 0.5116),
  ('unknown', 'width', 0.494772, 0.562631, 0.2887),
  ('unknown', 'width', 0.562631, 0.704325, 0.3319),
  ('unknown', 'width', 0.704325, 0.836722, 0.3227),
  ('unknown', 'width', 0.836722, 1.24434, 0.06862),
  ('unknown', 'width', 1.24434, 1.85053, 0.0216),
  ('unknown', 'width', 1.85053, 2.75203, 0.01255),
  ('unknown', 'width', 2.75203, 4.09271, 0.0112),
  ('unknown', 'width', 4.09271, 12, 0.00918);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.136596, 0.0122),
  ('unknown', 'z_max', 0.136596, 0.412336, 0.3692),
  ('unknown', 'z_max', 0.412336, 0.565863, 0.4504),
  ('unknown', 'z_max', 0.565863, 0.673401, 0.4095),
  ('unknown', 'z_max', 0.673401, 0.786804, 0.9748),
  ('unknown', 'z_max', 0.786804, 0.908192, 0.9141),
  ('unknown', 'z_max', 0.908192, 0.99513, 0.6944),
  ('unknown', 'z_max', 0.99513, 1.07082, 0.6808),
  ('unknown', 'z_max', 1.07082, 1.31286, 0.4498),
  ('unknown', 'z_max', 1.31286, 1.4244, 0.2935),
  ('unknown', 'z_max', 1.4244, 1.7624, 0.2316),
  ('unknown', 'z_max', 1.7624, 1.85366, 0.2356),
  ('unknown', 'z_max', 1.85366, 2.1774, 0.2731),
  ('unknown', 'z_max', 2.1774, 2.28293, 0.3173),
  ('unknown', 'z_max', 2.28293, 2.7122, 0.08893),
  ('unknown', 'z_max', 2.7122, 3.14147, 0.03527),
  ('unknown', 'z_max', 3.14147, 3.57073, 0.01718),
  ('unknown', 'z_max', 3.57073, 4, 0.04625);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.127078, 0.0538),
  ('unknown', 'z_min', -0.127078, -0.0127003, 0.8184),
  ('unknown', 'z_min', -0.0127003, 0.0397705, 2.084),
  ('unknown', 'z_min', 0.0397705, 0.245844, 0.4811),
  ('unknown', 'z_min', 0.245844, 0.27641, 0.3517),
  ('unknown', 'z_min', 0.27641, 0.600495, 0.3509),
  ('unknown', 'z_min', 0.600495, 0.618766, 0.3848),
  ('unknown', 'z_min', 0.618766, 0.733284, 0.884),
  ('unknown', 'z_min', 0.733284, 0.851479, 0.9384),
  ('unknown', 'z_min', 0.851479, 0.991688, 0.6007),
  ('unknown', 'z_min', 0.991688, 1.0611, 0.3956),
  ('unknown', 'z_min', 1.0611, 1.36461, 0.2889),
  ('unknown', 'z_min', 1.36461, 1.47331, 0.2186),
  ('unknown', 'z_min', 1.47331, 1.73753, 0.08591),
  ('unknown', 'z_min', 1.73753, 2.11045, 0.05996),
  ('unknown', 'z_min', 2.11045, 2.48338, 0.09337),
  ('unknown', 'z_min', 2.48338, 2.8563, 0.05171),
  ('unknown', 'z_min', 2.8563, 4, 0.01042);

-- floor: 137 examples
UPDATE object_class SET prior = 0.02894 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.362, 1.465)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4566, 0.3247)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.002024, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.199, 0.6865)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5796, 0.126)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.9191, 0.6184)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.3713, 0.7651)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.7029, 0.9709)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.7368, 0.8293)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.01204, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.009536, 0.02276)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'floor' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'area_m2', 0.002, 0.0468251, 0.002857),
  ('floor', 'area_m2', 0.0468251, 0.0926812, 0.01715),
  ('floor', 'area_m2', 0.0926812, 0.183444, 0.02677),
  ('floor', 'area_m2', 0.183444, 0.363093, 0.07903),
  ('floor', 'area_m2', 0.363093, 0.430424, 0.101),
  ('floor', 'area_m2', 0.430424, 0.718671, 0.09964),
  ('floor', 'area_m2', 0.718671, 1.06565, 0.134),
  ('floor', 'area_m2', 1.06565, 1.42247, 0.1457),
  ('floor', 'area_m2', 1.42247, 2.8155, 0.08129),
  ('floor', 'area_m2', 2.8155, 4.11445, 0.123),
  ('floor', 'area_m2', 4.11445, 5.57274, 0.2363),
  ('floor', 'area_m2', 5.57274, 6.35168, 0.2059),
  ('floor', 'area_m2', 6.35168, 8.20177, 0.4374),
  ('floor', 'area_m2', 8.20177, 10.0703, 0.5373),
  ('floor', 'area_m2', 10.0703, 11.0301, 0.5948),
  ('floor', 'area_m2', 11.0301, 12.5255, 0.347),
  ('floor', 'area_m2', 12.5255, 14.5682, 0.6892),
  ('floor', 'area_m2', 14.5682, 21.832, 0.2553),
  ('floor', 'area_m2', 21.832, 100, 0.01011);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'aspect', 1, 1.06286, 1.82),
  ('floor', 'aspect', 1.06286, 1.16481, 1.088),
  ('floor', 'aspect', 1.16481, 1.32434, 1.021),
  ('floor', 'aspect', 1.32434, 1.35678, 1.809),
  ('floor', 'aspect', 1.35678, 1.41971, 1.214),
  ('floor', 'aspect', 1.41971, 1.58038, 0.9713),
  ('floor', 'aspect', 1.58038, 1.61319, 0.7405),
  ('floor', 'aspect', 1.61319, 1.82947, 0.8359),
  ('floor', 'aspect', 1.82947, 2.06614, 0.9404),
  ('floor', 'aspect', 2.06614, 2.14423, 0.6885),
  ('floor', 'aspect', 2.14423, 2.32141, 1.019),
  ('floor', 'aspect', 2.32141, 2.49761, 0.4366),
  ('floor', 'aspect', 2.49761, 2.90924, 0.2241),
  ('floor', 'aspect', 2.90924, 3.38871, 0.1696),
  ('floor', 'aspect', 3.38871, 3.94719, 0.07298),
  ('floor', 'aspect', 3.94719, 100, 0.003435);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'height', -0.5, -0.0375255, 0.0229),
  ('floor', 'height', -0.0375255, -0.0232801, 1.85),
  ('floor', 'height', -0.0232801, -0.00903464, 12.64),
  ('floor', 'height', -0.00903464, -0.000182895, 28.27),
  ('floor', 'height', -0.000182895, 0.0194562, 22.38),
  ('floor', 'height', 0.0194562, 0.0337017, 4.307),
  ('floor', 'height', 0.0337017, 0.0479471, 0.808),
  ('floor', 'height', 0.0479471, 0.0621926, 0.3985),
  ('floor', 'height', 0.0621926, 0.076438, 0.3299),
  ('floor', 'height', 0.076438, 0.0906835, 0.1999),
  ('floor', 'height', 0.0906835, 4, 0.001844);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'length', 0.03, 0.416027, 0.003928),
  ('floor', 'length', 0.416027, 0.586909, 0.03876),
  ('floor', 'length', 0.586909, 0.827981, 0.08821),
  ('floor', 'length', 0.827981, 1.16807, 0.1298),
  ('floor', 'length', 1.16807, 1.24196, 0.1668),
  ('floor', 'length', 1.24196, 1.64786, 0.243),
  ('floor', 'length', 1.64786, 2.00039, 0.2294),
  ('floor', 'length', 2.00039, 2.32471, 0.2408),
  ('floor', 'length', 2.32471, 3.27958, 0.2391),
  ('floor', 'length', 3.27958, 3.88505, 0.7144),
  ('floor', 'length', 3.88505, 4.24572, 1.115),
  ('floor', 'length', 4.24572, 4.62665, 1.113),
  ('floor', 'length', 4.62665, 4.75703, 0.6769),
  ('floor', 'length', 4.75703, 5.63538, 0.612),
  ('floor', 'length', 5.63538, 6.30403, 0.7864),
  ('floor', 'length', 6.30403, 6.52704, 0.6957),
  ('floor', 'length', 6.52704, 8.64095, 0.3089),
  ('floor', 'length', 8.64095, 9.20801, 0.1535),
  ('floor', 'length', 9.20801, 30, 0.01057);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'rectangularity', 0, 0.282247, 0.03929),
  ('floor', 'rectangularity', 0.282247, 0.348428, 0.2782),
  ('floor', 'rectangularity', 0.348428, 0.414609, 0.8846),
  ('floor', 'rectangularity', 0.414609, 0.431177, 1.395),
  ('floor', 'rectangularity', 0.431177, 0.480789, 1.968),
  ('floor', 'rectangularity', 0.480789, 0.518822, 3.322),
  ('floor', 'rectangularity', 0.518822, 0.54697, 3.016),
  ('floor', 'rectangularity', 0.54697, 0.58993, 3.198),
  ('floor', 'rectangularity', 0.58993, 0.613151, 3.615),
  ('floor', 'rectangularity', 0.613151, 0.624041, 2.912),
  ('floor', 'rectangularity', 0.624041, 0.679332, 1.888),
  ('floor', 'rectangularity', 0.679332, 0.745512, 1.548),
  ('floor', 'rectangularity', 0.745512, 0.753265, 1.303),
  ('floor', 'rectangularity', 0.753265, 0.811693, 1.112),
  ('floor', 'rectangularity', 0.811693, 0.877874, 0.5175),
  ('floor', 'rectangularity', 0.877874, 1, 0.08825);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_length', 0.01, 0.32905, 0.00235),
  ('floor', 'spread_length', 0.32905, 0.451742, 0.03863),
  ('floor', 'spread_length', 0.451742, 0.620183, 0.05843),
  ('floor', 'spread_length', 0.620183, 0.85143, 0.1252),
  ('floor', 'spread_length', 0.85143, 0.973287, 0.1777),
  ('floor', 'spread_length', 0.973287, 1.1689, 0.1891),
  ('floor', 'spread_length', 1.1689, 1.60475, 0.2657),
  ('floor', 'spread_length', 1.60475, 2.20311, 0.2108),
  ('floor', 'spread_length', 2.20311, 2.5755, 0.3456),
  ('floor', 'spread_length', 2.5755, 2.92703, 0.9127),
  ('floor', 'spread_length', 2.92703, 3.02458, 0.965),
  ('floor', 'spread_length', 3.02458, 3.26365, 0.9768),
  ('floor', 'spread_length', 3.26365, 3.58327, 1.106),
  ('floor', 'spread_length', 3.58327, 3.90895, 1.16),
  ('floor', 'spread_length', 3.90895, 4.15235, 1.291),
  ('floor', 'spread_length', 4.15235, 4.34392, 0.8732),
  ('floor', 'spread_length', 4.34392, 5.70063, 0.3598),
  ('floor', 'spread_length', 5.70063, 40, 0.008122);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_width', 0.003, 0.134918, 0.002393),
  ('floor', 'spread_width', 0.134918, 0.142179, 0.04127),
  ('floor', 'spread_width', 0.142179, 0.1939, 0.0441),
  ('floor', 'spread_width', 0.1939, 0.278666, 0.04081),
  ('floor', 'spread_width', 0.278666, 0.400489, 0.09606),
  ('floor', 'spread_width', 0.400489, 0.470798, 0.1794),
  ('floor', 'spread_width', 0.470798, 0.575568, 0.245),
  ('floor', 'spread_width', 0.575568, 0.738903, 0.269),
  ('floor', 'spread_width', 0.738903, 0.827187, 0.198),
  ('floor', 'spread_width', 0.827187, 1.1888, 0.1605),
  ('floor', 'spread_width', 1.1888, 1.54845, 0.1951),
  ('floor', 'spread_width', 1.54845, 1.70851, 0.4053),
  ('floor', 'spread_width', 1.70851, 1.86444, 0.7356),
  ('floor', 'spread_width', 1.86444, 2.11455, 0.8392),
  ('floor', 'spread_width', 2.11455, 2.35654, 0.9332),
  ('floor', 'spread_width', 2.35654, 2.45541, 1.336),
  ('floor', 'spread_width', 2.45541, 2.56397, 1.324),
  ('floor', 'spread_width', 2.56397, 2.74103, 1.429),
  ('floor', 'spread_width', 2.74103, 3.39008, 0.507),
  ('floor', 'spread_width', 3.39008, 3.52883, 0.1568),
  ('floor', 'spread_width', 3.52883, 20, 0.008794);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'tilt_deg', 0, 0.46008, 1.207),
  ('floor', 'tilt_deg', 0.46008, 0.92016, 0.2207),
  ('floor', 'tilt_deg', 0.92016, 1.38024, 0.1979),
  ('floor', 'tilt_deg', 1.38024, 1.52065, 0.1897),
  ('floor', 'tilt_deg', 1.52065, 1.84032, 0.1822),
  ('floor', 'tilt_deg', 1.84032, 2.12933, 0.1847),
  ('floor', 'tilt_deg', 2.12933, 2.3004, 0.1721),
  ('floor', 'tilt_deg', 2.3004, 2.76048, 0.1017),
  ('floor', 'tilt_deg', 2.76048, 3.22056, 0.03894),
  ('floor', 'tilt_deg', 3.22056, 3.68064, 0.01702),
  ('floor', 'tilt_deg', 3.68064, 4.06673, 0.01569),
  ('floor', 'tilt_deg', 4.06673, 90, 7.044e-05);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'width', 0.01, 0.198127, 0.003996),
  ('floor', 'width', 0.198127, 0.211532, 0.04958),
  ('floor', 'width', 0.211532, 0.289832, 0.05347),
  ('floor', 'width', 0.289832, 0.423984, 0.05475),
  ('floor', 'width', 0.423984, 0.62023, 0.1331),
  ('floor', 'width', 0.62023, 0.90731, 0.2617),
  ('floor', 'width', 0.90731, 1.0513, 0.1579),
  ('floor', 'width', 1.0513, 1.32727, 0.1542),
  ('floor', 'width', 1.32727, 1.94161, 0.1822),
  ('floor', 'width', 1.94161, 2.01103, 0.2494),
  ('floor', 'width', 2.01103, 2.71128, 0.4221),
  ('floor', 'width', 2.71128, 2.84031, 0.6118),
  ('floor', 'width', 2.84031, 3.14478, 0.6301),
  ('floor', 'width', 3.14478, 3.5023, 0.9559),
  ('floor', 'width', 3.5023, 3.923, 0.9657),
  ('floor', 'width', 3.923, 4.15498, 1.07),
  ('floor', 'width', 4.15498, 4.42148, 0.8287),
  ('floor', 'width', 4.42148, 6.07816, 0.318),
  ('floor', 'width', 6.07816, 12, 0.02107);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_max', -0.5, -0.022748, 0.04824),
  ('floor', 'z_max', -0.022748, -0.00657909, 9.663),
  ('floor', 'z_max', -0.00657909, 8.47714e-05, 21.55),
  ('floor', 'z_max', 8.47714e-05, 0.00958986, 23.61),
  ('floor', 'z_max', 0.00958986, 0.0192064, 17.82),
  ('floor', 'z_max', 0.0192064, 0.0257588, 11.8),
  ('floor', 'z_max', 0.0257588, 0.0327127, 8.302),
  ('floor', 'z_max', 0.0327127, 0.0419278, 5.521),
  ('floor', 'z_max', 0.0419278, 0.0580967, 2.961),
  ('floor', 'z_max', 0.0580967, 0.0742657, 1.407),
  ('floor', 'z_max', 0.0742657, 0.0904346, 0.5416),
  ('floor', 'z_max', 0.0904346, 0.106604, 0.3352),
  ('floor', 'z_max', 0.106604, 0.122773, 0.2023),
  ('floor', 'z_max', 0.122773, 4, 0.00188);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_min', -0.5, -0.12776, 0.01938),
  ('floor', 'z_min', -0.12776, -0.105266, 0.2381),
  ('floor', 'z_min', -0.105266, -0.082772, 0.3185),
  ('floor', 'z_min', -0.082772, -0.0602778, 0.95),
  ('floor', 'z_min', -0.0602778, -0.0377836, 3.023),
  ('floor', 'z_min', -0.0377836, -0.0190596, 7.818),
  ('floor', 'z_min', -0.0190596, -0.00646602, 17.97),
  ('floor', 'z_min', -0.00646602, -0.000273662, 23.99),
  ('floor', 'z_min', -0.000273662, 0.00720479, 22.06),
  ('floor', 'z_min', 0.00720479, 0.029699, 7.875),
  ('floor', 'z_min', 0.029699, 0.0521932, 0.6948),
  ('floor', 'z_min', 0.0521932, 0.0618993, 0.623),
  ('floor', 'z_min', 0.0618993, 0.0746874, 0.367),
  ('floor', 'z_min', 0.0746874, 4, 0.0003013);

-- ceiling: 96 examples
UPDATE object_class SET prior = 0.02032 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.938, 1.121)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4227, 0.3835)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.886, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.369, 0.4756)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.696, 0.1316)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.255, 0.4645)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.6573, 0.6707)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.02001, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.9419, 0.7256)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.887, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.886, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'area_m2', 0.002, 0.194259, 0.002558),
  ('ceiling', 'area_m2', 0.194259, 0.339883, 0.03645),
  ('ceiling', 'area_m2', 0.339883, 0.594672, 0.04072),
  ('ceiling', 'area_m2', 0.594672, 1.04046, 0.06926),
  ('ceiling', 'area_m2', 1.04046, 1.1366, 0.09309),
  ('ceiling', 'area_m2', 1.1366, 1.82043, 0.07846),
  ('ceiling', 'area_m2', 1.82043, 3.18509, 0.0877),
  ('ceiling', 'area_m2', 3.18509, 5.2194, 0.1272),
  ('ceiling', 'area_m2', 5.2194, 5.57276, 0.2121),
  ('ceiling', 'area_m2', 5.57276, 7.53758, 0.2926),
  ('ceiling', 'area_m2', 7.53758, 9.48386, 0.5016),
  ('ceiling', 'area_m2', 9.48386, 11.0962, 0.6102),
  ('ceiling', 'area_m2', 11.0962, 12.3758, 0.9881),
  ('ceiling', 'area_m2', 12.3758, 14.4771, 0.644),
  ('ceiling', 'area_m2', 14.4771, 17.0595, 0.5603),
  ('ceiling', 'area_m2', 17.0595, 18.339, 0.2123),
  ('ceiling', 'area_m2', 18.339, 28.154, 0.2372),
  ('ceiling', 'area_m2', 28.154, 29.8479, 0.05684),
  ('ceiling', 'area_m2', 29.8479, 100, 0.01226);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'aspect', 1, 1.04527, 2.239),
  ('ceiling', 'aspect', 1.04527, 1.14289, 1.344),
  ('ceiling', 'aspect', 1.14289, 1.2019, 1.71),
  ('ceiling', 'aspect', 1.2019, 1.36037, 1.036),
  ('ceiling', 'aspect', 1.36037, 1.44457, 1.697),
  ('ceiling', 'aspect', 1.44457, 1.57844, 1.311),
  ('ceiling', 'aspect', 1.57844, 1.73624, 0.8007),
  ('ceiling', 'aspect', 1.73624, 1.82332, 0.6692),
  ('ceiling', 'aspect', 1.82332, 2.08679, 0.693),
  ('ceiling', 'aspect', 2.08679, 2.19721, 0.4326),
  ('ceiling', 'aspect', 2.19721, 2.50812, 0.2199),
  ('ceiling', 'aspect', 2.50812, 3.01451, 0.1232),
  ('ceiling', 'aspect', 3.01451, 3.62315, 0.07438),
  ('ceiling', 'aspect', 3.62315, 4.35468, 0.1072),
  ('ceiling', 'aspect', 4.35468, 5.23391, 0.1215),
  ('ceiling', 'aspect', 5.23391, 100, 0.005439);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'height', -0.5, 2.29375, 0.005669),
  ('ceiling', 'height', 2.29375, 2.47337, 0.4749),
  ('ceiling', 'height', 2.47337, 2.51477, 2.721),
  ('ceiling', 'height', 2.51477, 2.65298, 0.6199),
  ('ceiling', 'height', 2.65298, 2.68274, 1.035),
  ('ceiling', 'height', 2.68274, 2.74921, 1.687),
  ('ceiling', 'height', 2.74921, 2.8326, 1.074),
  ('ceiling', 'height', 2.8326, 2.98177, 0.8363),
  ('ceiling', 'height', 2.98177, 3.01222, 0.6296),
  ('ceiling', 'height', 3.01222, 3.11019, 0.8933),
  ('ceiling', 'height', 3.11019, 3.19184, 0.6505),
  ('ceiling', 'height', 3.19184, 3.37146, 0.2784),
  ('ceiling', 'height', 3.37146, 3.40393, 0.3203),
  ('ceiling', 'height', 3.40393, 3.55108, 0.281),
  ('ceiling', 'height', 3.55108, 3.7307, 0.2131),
  ('ceiling', 'height', 3.7307, 3.89083, 0.1809),
  ('ceiling', 'height', 3.89083, 3.91031, 0.1453),
  ('ceiling', 'height', 3.91031, 4, 0.1294);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'length', 0.03, 0.736449, 0.003638),
  ('ceiling', 'length', 0.736449, 0.941999, 0.04381),
  ('ceiling', 'length', 0.941999, 1.20492, 0.04058),
  ('ceiling', 'length', 1.20492, 1.54123, 0.1337),
  ('ceiling', 'length', 1.54123, 1.92791, 0.1908),
  ('ceiling', 'length', 1.92791, 1.9714, 0.1635),
  ('ceiling', 'length', 1.9714, 2.52164, 0.1724),
  ('ceiling', 'length', 2.52164, 3.22545, 0.2861),
  ('ceiling', 'length', 3.22545, 3.37952, 0.3148),
  ('ceiling', 'length', 3.37952, 4.02342, 0.6739),
  ('ceiling', 'length', 4.02342, 4.12571, 1.093),
  ('ceiling', 'length', 4.12571, 4.42916, 1.195),
  ('ceiling', 'length', 4.42916, 4.70627, 1.632),
  ('ceiling', 'length', 4.70627, 5.02887, 1.538),
  ('ceiling', 'length', 5.02887, 5.27723, 1.121),
  ('ceiling', 'length', 5.27723, 5.4728, 1.298),
  ('ceiling', 'length', 5.4728, 6.02932, 1.172),
  ('ceiling', 'length', 6.02932, 6.75016, 0.8417),
  ('ceiling', 'length', 6.75016, 30, 0.01347);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'rectangularity', 0, 0.413639, 0.01924),
  ('ceiling', 'rectangularity', 0.413639, 0.424281, 0.2103),
  ('ceiling', 'rectangularity', 0.424281, 0.47553, 0.3858),
  ('ceiling', 'rectangularity', 0.47553, 0.524044, 1.575),
  ('ceiling', 'rectangularity', 0.524044, 0.537422, 2.525),
  ('ceiling', 'rectangularity', 0.537422, 0.577118, 2.032),
  ('ceiling', 'rectangularity', 0.577118, 0.599313, 1.745),
  ('ceiling', 'rectangularity', 0.599313, 0.632045, 2.116),
  ('ceiling', 'rectangularity', 0.632045, 0.661204, 3.494),
  ('ceiling', 'rectangularity', 0.661204, 0.715382, 2.402),
  ('ceiling', 'rectangularity', 0.715382, 0.723096, 3.142),
  ('ceiling', 'rectangularity', 0.723096, 0.754221, 2.515),
  ('ceiling', 'rectangularity', 0.754221, 0.784987, 1.377),
  ('ceiling', 'rectangularity', 0.784987, 0.825123, 2.256),
  ('ceiling', 'rectangularity', 0.825123, 0.846879, 2.83),
  ('ceiling', 'rectangularity', 0.846879, 0.862869, 1.85),
  ('ceiling', 'rectangularity', 0.862869, 0.90877, 1.31),
  ('ceiling', 'rectangularity', 0.90877, 0.953532, 0.7804),
  ('ceiling', 'rectangularity', 0.953532, 0.970662, 0.4751),
  ('ceiling', 'rectangularity', 0.970662, 1, 0.3217);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_length', 0.01, 0.711534, 0.003041),
  ('ceiling', 'spread_length', 0.711534, 0.902508, 0.06075),
  ('ceiling', 'spread_length', 0.902508, 1.14474, 0.03725),
  ('ceiling', 'spread_length', 1.14474, 1.45198, 0.1553),
  ('ceiling', 'spread_length', 1.45198, 1.66822, 0.2072),
  ('ceiling', 'spread_length', 1.66822, 1.84169, 0.1744),
  ('ceiling', 'spread_length', 1.84169, 2.336, 0.1498),
  ('ceiling', 'spread_length', 2.336, 2.96297, 0.307),
  ('ceiling', 'spread_length', 2.96297, 3.61051, 0.6554),
  ('ceiling', 'spread_length', 3.61051, 3.75822, 1.14),
  ('ceiling', 'spread_length', 3.75822, 3.89863, 1.632),
  ('ceiling', 'spread_length', 3.89863, 4.28031, 1.279),
  ('ceiling', 'spread_length', 4.28031, 4.45924, 1.957),
  ('ceiling', 'spread_length', 4.45924, 4.74157, 1.645),
  ('ceiling', 'spread_length', 4.74157, 5.12896, 1.369),
  ('ceiling', 'spread_length', 5.12896, 5.78827, 0.8317),
  ('ceiling', 'spread_length', 5.78827, 6.04635, 0.2772),
  ('ceiling', 'spread_length', 6.04635, 40, 0.008649);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_width', 0.003, 0.166633, 0.002846),
  ('ceiling', 'spread_width', 0.166633, 0.238072, 0.0194),
  ('ceiling', 'spread_width', 0.238072, 0.340138, 0.01897),
  ('ceiling', 'spread_width', 0.340138, 0.485961, 0.08587),
  ('ceiling', 'spread_width', 0.485961, 0.694301, 0.1425),
  ('ceiling', 'spread_width', 0.694301, 0.710457, 0.1433),
  ('ceiling', 'spread_width', 0.710457, 0.99196, 0.1556),
  ('ceiling', 'spread_width', 0.99196, 1.41723, 0.1589),
  ('ceiling', 'spread_width', 1.41723, 1.61015, 0.1702),
  ('ceiling', 'spread_width', 1.61015, 2.02482, 0.4717),
  ('ceiling', 'spread_width', 2.02482, 2.29496, 0.9592),
  ('ceiling', 'spread_width', 2.29496, 2.56824, 0.8603),
  ('ceiling', 'spread_width', 2.56824, 2.79336, 1.184),
  ('ceiling', 'spread_width', 2.79336, 2.8929, 1.242),
  ('ceiling', 'spread_width', 2.8929, 3.03662, 1.184),
  ('ceiling', 'spread_width', 3.03662, 3.32551, 1.24),
  ('ceiling', 'spread_width', 3.32551, 3.916, 0.5916),
  ('ceiling', 'spread_width', 3.916, 4.13314, 0.1385),
  ('ceiling', 'spread_width', 4.13314, 20, 0.0111);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'tilt_deg', 0, 0.15766, 3.043),
  ('ceiling', 'tilt_deg', 0.15766, 0.31532, 1.979),
  ('ceiling', 'tilt_deg', 0.31532, 0.465276, 0.8875),
  ('ceiling', 'tilt_deg', 0.465276, 0.630639, 0.3014),
  ('ceiling', 'tilt_deg', 0.630639, 90, 0.0002839);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'width', 0.01, 0.184447, 0.004144),
  ('ceiling', 'width', 0.184447, 0.26697, 0.01676),
  ('ceiling', 'width', 0.26697, 0.386413, 0.01105),
  ('ceiling', 'width', 0.386413, 0.559297, 0.08844),
  ('ceiling', 'width', 0.559297, 0.809529, 0.126),
  ('ceiling', 'width', 0.809529, 0.88179, 0.104),
  ('ceiling', 'width', 0.88179, 1.17172, 0.1449),
  ('ceiling', 'width', 1.17172, 1.69595, 0.1572),
  ('ceiling', 'width', 1.69595, 1.98797, 0.1852),
  ('ceiling', 'width', 1.98797, 2.45473, 0.3255),
  ('ceiling', 'width', 2.45473, 2.60769, 0.4751),
  ('ceiling', 'width', 2.60769, 3.30656, 0.521),
  ('ceiling', 'width', 3.30656, 3.55298, 1.217),
  ('ceiling', 'width', 3.55298, 3.86931, 1.302),
  ('ceiling', 'width', 3.86931, 4.13355, 1.71),
  ('ceiling', 'width', 4.13355, 4.55855, 1.139),
  ('ceiling', 'width', 4.55855, 5.14261, 0.7562),
  ('ceiling', 'width', 5.14261, 12, 0.03007);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_max', -0.5, 2.29384, 0.005658),
  ('ceiling', 'z_max', 2.29384, 2.47347, 0.4735),
  ('ceiling', 'z_max', 2.47347, 2.5153, 2.698),
  ('ceiling', 'z_max', 2.5153, 2.6531, 0.6222),
  ('ceiling', 'z_max', 2.6531, 2.68292, 1.032),
  ('ceiling', 'z_max', 2.68292, 2.7497, 1.686),
  ('ceiling', 'z_max', 2.7497, 2.83273, 1.074),
  ('ceiling', 'z_max', 2.83273, 2.98193, 0.8364),
  ('ceiling', 'z_max', 2.98193, 3.01235, 0.6299),
  ('ceiling', 'z_max', 3.01235, 3.11034, 0.8917),
  ('ceiling', 'z_max', 3.11034, 3.19198, 0.6523),
  ('ceiling', 'z_max', 3.19198, 3.37161, 0.2781),
  ('ceiling', 'z_max', 3.37161, 3.40422, 0.3199),
  ('ceiling', 'z_max', 3.40422, 3.55124, 0.281),
  ('ceiling', 'z_max', 3.55124, 3.73087, 0.2133),
  ('ceiling', 'z_max', 3.73087, 3.89171, 0.1808),
  ('ceiling', 'z_max', 3.89171, 3.9105, 0.1454),
  ('ceiling', 'z_max', 3.9105, 4, 0.1297);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_min', -0.5, 2.29368, 0.00568),
  ('ceiling', 'z_min', 2.29368, 2.47329, 0.4767),
  ('ceiling', 'z_min', 2.47329, 2.51428, 2.744),
  ('ceiling', 'z_min', 2.51428, 2.65291, 0.6175),
  ('ceiling', 'z_min', 2.65291, 2.68257, 1.04),
  ('ceiling', 'z_min', 2.68257, 2.74868, 1.687),
  ('ceiling', 'z_min', 2.74868, 2.83253, 1.076),
  ('ceiling', 'z_min', 2.83253, 2.98157, 0.8363),
  ('ceiling', 'z_min', 2.98157, 3.01214, 0.6295),
  ('ceiling', 'z_min', 3.01214, 3.11009, 0.8944),
  ('ceiling', 'z_min', 3.11009, 3.19176, 0.6489),
  ('ceiling', 'z_min', 3.19176, 3.37137, 0.2786),
  ('ceiling', 'z_min', 3.37137, 3.40366, 0.3207),
  ('ceiling', 'z_min', 3.40366, 3.55099, 0.281),
  ('ceiling', 'z_min', 3.55099, 3.7306, 0.213),
  ('ceiling', 'z_min', 3.7306, 3.89006, 0.1809),
  ('ceiling', 'z_min', 3.89006, 3.91022, 0.1452),
  ('ceiling', 'z_min', 3.91022, 4, 0.129);

-- wall: 503 examples
UPDATE object_class SET prior = 0.1064 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 1.105, 1.049)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.5647, 0.3994)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.412, 0.3654)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 1.046, 0.4677)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6786, 0.149)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.8818, 0.4708)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', 0.2296, 0.6485)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.58, 1.096)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.4771, 0.6518)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.549, 0.6762)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.1735, 0.3746)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'wall' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'area_m2', 0.002, 0.237217, 0.002191),
  ('wall', 'area_m2', 0.237217, 0.380805, 0.05582),
  ('wall', 'area_m2', 0.380805, 0.611306, 0.127),
  ('wall', 'area_m2', 0.611306, 0.655874, 0.161),
  ('wall', 'area_m2', 0.655874, 0.98133, 0.1542),
  ('wall', 'area_m2', 0.98133, 1.21704, 0.227),
  ('wall', 'area_m2', 1.21704, 1.57533, 0.2555),
  ('wall', 'area_m2', 1.57533, 1.94966, 0.2462),
  ('wall', 'area_m2', 1.94966, 2.52887, 0.2551),
  ('wall', 'area_m2', 2.52887, 2.98469, 0.2462),
  ('wall', 'area_m2', 2.98469, 4.0596, 0.2683),
  ('wall', 'area_m2', 4.0596, 4.47056, 0.3081),
  ('wall', 'area_m2', 4.47056, 5.91342, 0.4044),
  ('wall', 'area_m2', 5.91342, 6.51688, 0.4021),
  ('wall', 'area_m2', 6.51688, 7.68462, 0.4294),
  ('wall', 'area_m2', 7.68462, 10.054, 0.3983),
  ('wall', 'area_m2', 10.054, 10.4615, 0.2997),
  ('wall', 'area_m2', 10.4615, 16.7939, 0.2035),
  ('wall', 'area_m2', 16.7939, 100, 0.002595);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'aspect', 1, 1.1292, 0.931),
  ('wall', 'aspect', 1.1292, 1.21556, 0.7474),
  ('wall', 'aspect', 1.21556, 1.2774, 1.119),
  ('wall', 'aspect', 1.2774, 1.4054, 1.157),
  ('wall', 'aspect', 1.4054, 1.47759, 0.915),
  ('wall', 'aspect', 1.47759, 1.57203, 1.12),
  ('wall', 'aspect', 1.57203, 1.69298, 1.353),
  ('wall', 'aspect', 1.69298, 1.7961, 0.7892),
  ('wall', 'aspect', 1.7961, 1.93969, 0.9039),
  ('wall', 'aspect', 1.93969, 2.18328, 0.7739),
  ('wall', 'aspect', 2.18328, 2.23431, 0.6701),
  ('wall', 'aspect', 2.23431, 2.65391, 0.4787),
  ('wall', 'aspect', 2.65391, 2.89205, 0.4086),
  ('wall', 'aspect', 2.89205, 3.22599, 0.1794),
  ('wall', 'aspect', 3.22599, 3.9214, 0.1491),
  ('wall', 'aspect', 3.9214, 4.7667, 0.1582),
  ('wall', 'aspect', 4.7667, 5.79422, 0.089),
  ('wall', 'aspect', 5.79422, 100, 0.004432);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'height', -0.5, 0.296199, 0.01412),
  ('wall', 'height', 0.296199, 0.520263, 0.08763),
  ('wall', 'height', 0.520263, 0.744327, 0.134),
  ('wall', 'height', 0.744327, 0.968391, 0.207),
  ('wall', 'height', 0.968391, 0.982396, 0.1759),
  ('wall', 'height', 0.982396, 1.19245, 0.3048),
  ('wall', 'height', 1.19245, 1.23243, 1.234),
  ('wall', 'height', 1.23243, 1.32875, 1.151),
  ('wall', 'height', 1.32875, 1.39573, 1.606),
  ('wall', 'height', 1.39573, 1.41652, 1.343),
  ('wall', 'height', 1.41652, 1.46298, 1.787),
  ('wall', 'height', 1.46298, 1.53782, 1.487),
  ('wall', 'height', 1.53782, 1.6351, 1.195),
  ('wall', 'height', 1.6351, 1.80707, 0.6509),
  ('wall', 'height', 1.80707, 1.86465, 0.3018),
  ('wall', 'height', 1.86465, 2.08871, 0.2495),
  ('wall', 'height', 2.08871, 2.31277, 0.1049),
  ('wall', 'height', 2.31277, 4, 0.00664);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'length', 0.03, 0.730537, 0.002695),
  ('wall', 'length', 0.730537, 0.932335, 0.06594),
  ('wall', 'length', 0.932335, 1.18988, 0.09557),
  ('wall', 'length', 1.18988, 1.51204, 0.2597),
  ('wall', 'length', 1.51204, 1.93803, 0.3614),
  ('wall', 'length', 1.93803, 2.09098, 0.2809),
  ('wall', 'length', 2.09098, 2.47338, 0.6761),
  ('wall', 'length', 2.47338, 2.73013, 1.091),
  ('wall', 'length', 2.73013, 3.15661, 0.7479),
  ('wall', 'length', 3.15661, 3.732, 0.7155),
  ('wall', 'length', 3.732, 4.02857, 0.8981),
  ('wall', 'length', 4.02857, 4.2835, 0.7004),
  ('wall', 'length', 4.2835, 4.80206, 0.9136),
  ('wall', 'length', 4.80206, 5.14139, 0.5256),
  ('wall', 'length', 5.14139, 6.56161, 0.2875),
  ('wall', 'length', 6.56161, 30, 0.004615);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'rectangularity', 0, 0.329988, 0.02984),
  ('wall', 'rectangularity', 0.329988, 0.403091, 0.3305),
  ('wall', 'rectangularity', 0.403091, 0.476193, 0.9885),
  ('wall', 'rectangularity', 0.476193, 0.481035, 1.496),
  ('wall', 'rectangularity', 0.481035, 0.549296, 1.369),
  ('wall', 'rectangularity', 0.549296, 0.56138, 1.37),
  ('wall', 'rectangularity', 0.56138, 0.621899, 1.821),
  ('wall', 'rectangularity', 0.621899, 0.658355, 3.042),
  ('wall', 'rectangularity', 0.658355, 0.6955, 2.633),
  ('wall', 'rectangularity', 0.6955, 0.753783, 2.04),
  ('wall', 'rectangularity', 0.753783, 0.768603, 2.063),
  ('wall', 'rectangularity', 0.768603, 0.797804, 2.916),
  ('wall', 'rectangularity', 0.797804, 0.841705, 1.642),
  ('wall', 'rectangularity', 0.841705, 0.863218, 1.66),
  ('wall', 'rectangularity', 0.863218, 0.914807, 1.104),
  ('wall', 'rectangularity', 0.914807, 0.986859, 0.7403),
  ('wall', 'rectangularity', 0.986859, 1, 0.3643);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_length', 0.01, 0.658983, 0.002204),
  ('wall', 'spread_length', 0.658983, 0.839811, 0.07964),
  ('wall', 'spread_length', 0.839811, 1.07026, 0.1279),
  ('wall', 'spread_length', 1.07026, 1.2964, 0.2608),
  ('wall', 'spread_length', 1.2964, 1.36394, 0.3265),
  ('wall', 'spread_length', 1.36394, 1.67757, 0.4531),
  ('wall', 'spread_length', 1.67757, 1.73822, 0.3746),
  ('wall', 'spread_length', 1.73822, 2.07824, 0.5556),
  ('wall', 'spread_length', 2.07824, 2.21519, 0.7941),
  ('wall', 'spread_length', 2.21519, 2.37325, 0.9355),
  ('wall', 'spread_length', 2.37325, 2.65302, 0.9724),
  ('wall', 'spread_length', 2.65302, 2.82305, 0.7674),
  ('wall', 'spread_length', 2.82305, 3.14395, 0.5576),
  ('wall', 'spread_length', 3.14395, 3.59771, 0.7621),
  ('wall', 'spread_length', 3.59771, 3.67169, 0.4695),
  ('wall', 'spread_length', 3.67169, 4.19556, 0.8323),
  ('wall', 'spread_length', 4.19556, 4.58494, 0.5818),
  ('wall', 'spread_length', 4.58494, 5.84307, 0.2234),
  ('wall', 'spread_length', 5.84307, 40, 0.003734);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_width', 0.003, 0.221596, 0.00245),
  ('wall', 'spread_width', 0.221596, 0.300726, 0.04069),
  ('wall', 'spread_width', 0.300726, 0.408112, 0.1148),
  ('wall', 'spread_width', 0.408112, 0.500004, 0.2634),
  ('wall', 'spread_width', 0.500004, 0.553844, 0.3811),
  ('wall', 'spread_width', 0.553844, 0.699259, 0.2799),
  ('wall', 'spread_width', 0.699259, 0.751616, 0.2773),
  ('wall', 'spread_width', 0.751616, 1.01946, 0.3265),
  ('wall', 'spread_width', 1.01946, 1.26546, 0.5),
  ('wall', 'spread_width', 1.26546, 1.38425, 0.4389),
  ('wall', 'spread_width', 1.38425, 1.64658, 0.4153),
  ('wall', 'spread_width', 1.64658, 1.87855, 0.7271),
  ('wall', 'spread_width', 1.87855, 1.93411, 0.739),
  ('wall', 'spread_width', 1.93411, 2.21326, 0.7626),
  ('wall', 'spread_width', 2.21326, 2.54935, 0.7362),
  ('wall', 'spread_width', 2.54935, 2.60424, 0.685),
  ('wall', 'spread_width', 2.60424, 3.4597, 0.3536),
  ('wall', 'spread_width', 3.4597, 20, 0.003361);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'tilt_deg', 0, 83.7097, 0.0001018),
  ('wall', 'tilt_deg', 83.7097, 84.4086, 0.00655),
  ('wall', 'tilt_deg', 84.4086, 85.1075, 0.004148),
  ('wall', 'tilt_deg', 85.1075, 85.8065, 0.01441),
  ('wall', 'tilt_deg', 85.8065, 86.5054, 0.01761),
  ('wall', 'tilt_deg', 86.5054, 87.2043, 0.02479),
  ('wall', 'tilt_deg', 87.2043, 87.9032, 0.03649),
  ('wall', 'tilt_deg', 87.9032, 88.6022, 0.03921),
  ('wall', 'tilt_deg', 88.6022, 89.3011, 0.0827),
  ('wall', 'tilt_deg', 89.3011, 90, 1.193);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'width', 0.01, 0.277273, 0.003199),
  ('wall', 'width', 0.277273, 0.372768, 0.04202),
  ('wall', 'width', 0.372768, 0.501152, 0.08436),
  ('wall', 'width', 0.501152, 0.614134, 0.3067),
  ('wall', 'width', 0.614134, 0.673752, 0.3196),
  ('wall', 'width', 0.673752, 0.882722, 0.2963),
  ('wall', 'width', 0.882722, 0.905797, 0.2955),
  ('wall', 'width', 0.905797, 1.21776, 0.3275),
  ('wall', 'width', 1.21776, 1.25086, 0.335),
  ('wall', 'width', 1.25086, 1.63716, 0.412),
  ('wall', 'width', 1.63716, 1.68014, 0.2771),
  ('wall', 'width', 1.68014, 2.20102, 0.2289),
  ('wall', 'width', 2.20102, 2.39834, 0.4617),
  ('wall', 'width', 2.39834, 2.63471, 1.267),
  ('wall', 'width', 2.63471, 2.79984, 1.62),
  ('wall', 'width', 2.79984, 2.95906, 1.322),
  ('wall', 'width', 2.95906, 3.09219, 1.138),
  ('wall', 'width', 3.09219, 3.86776, 0.4373),
  ('wall', 'width', 3.86776, 3.97818, 0.1059),
  ('wall', 'width', 3.97818, 12, 0.004749);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_max', -0.5, 0.612562, 0.007798),
  ('wall', 'z_max', 0.612562, 0.973461, 0.04366),
  ('wall', 'z_max', 0.973461, 1.33436, 0.1082),
  ('wall', 'z_max', 1.33436, 1.49998, 0.3007),
  ('wall', 'z_max', 1.49998, 1.69526, 0.2126),
  ('wall', 'z_max', 1.69526, 2.05616, 0.1334),
  ('wall', 'z_max', 2.05616, 2.33107, 0.09054),
  ('wall', 'z_max', 2.33107, 2.41706, 0.4827),
  ('wall', 'z_max', 2.41706, 2.47991, 0.9945),
  ('wall', 'z_max', 2.47991, 2.5831, 1.099),
  ('wall', 'z_max', 2.5831, 2.72093, 0.8073),
  ('wall', 'z_max', 2.72093, 2.77796, 1.272),
  ('wall', 'z_max', 2.77796, 2.84451, 0.6144),
  ('wall', 'z_max', 2.84451, 2.99481, 0.7258),
  ('wall', 'z_max', 2.99481, 3.13886, 0.6349),
  ('wall', 'z_max', 3.13886, 3.21407, 0.1981),
  ('wall', 'z_max', 3.21407, 3.49976, 0.194),
  ('wall', 'z_max', 3.49976, 3.86066, 0.1342),
  ('wall', 'z_max', 3.86066, 4, 0.07736);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_min', -0.5, -0.105454, 0.03859),
  ('wall', 'z_min', -0.105454, -0.0167967, 2.532),
  ('wall', 'z_min', -0.0167967, -0.0110353, 18.7),
  ('wall', 'z_min', -0.0110353, 0.00393337, 16.72),
  ('wall', 'z_min', 0.00393337, 0.0985364, 1.407),
  ('wall', 'z_min', 0.0985364, 0.23352, 0.2947),
  ('wall', 'z_min', 0.23352, 0.302526, 0.2007),
  ('wall', 'z_min', 0.302526, 0.506516, 0.2294),
  ('wall', 'z_min', 0.506516, 0.694126, 0.3129),
  ('wall', 'z_min', 0.694126, 0.710506, 0.33),
  ('wall', 'z_min', 0.710506, 0.914496, 0.2196),
  ('wall', 'z_min', 0.914496, 1.11849, 0.1297),
  ('wall', 'z_min', 1.11849, 1.32248, 0.04832),
  ('wall', 'z_min', 1.32248, 1.52647, 0.01836),
  ('wall', 'z_min', 1.52647, 1.73046, 0.05165),
  ('wall', 'z_min', 1.73046, 4, 0.004106);

-- table: 208 examples
UPDATE object_class SET prior = 0.04408 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.3674, 0.6599)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5442, 0.3058)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7423, 0.1282)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.2862, 0.3421)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.6905, 0.1298)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1443, 0.3283)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4564, 0.3828)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.7128, 0.5943)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2603, 0.3591)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7501, 0.1279)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7361, 0.1279)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'table' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'area_m2', 0.002, 0.0789862, 0.00224),
  ('table', 'area_m2', 0.0789862, 0.113906, 0.03543),
  ('table', 'area_m2', 0.113906, 0.164265, 0.05987),
  ('table', 'area_m2', 0.164265, 0.236888, 0.08318),
  ('table', 'area_m2', 0.236888, 0.310266, 0.1342),
  ('table', 'area_m2', 0.310266, 0.341617, 0.2171),
  ('table', 'area_m2', 0.341617, 0.435219, 0.4062),
  ('table', 'area_m2', 0.435219, 0.492648, 0.3573),
  ('table', 'area_m2', 0.492648, 0.587849, 0.3267),
  ('table', 'area_m2', 0.587849, 0.71045, 0.5454),
  ('table', 'area_m2', 0.71045, 0.727801, 0.4884),
  ('table', 'area_m2', 0.727801, 0.892784, 0.5561),
  ('table', 'area_m2', 0.892784, 1.02454, 0.8195),
  ('table', 'area_m2', 1.02454, 1.13219, 0.9994),
  ('table', 'area_m2', 1.13219, 1.33462, 0.6573),
  ('table', 'area_m2', 1.33462, 1.4775, 0.4997),
  ('table', 'area_m2', 1.4775, 2.13071, 0.1573),
  ('table', 'area_m2', 2.13071, 100, 0.002869);
DELETE FROM class_density WHERE class = 'table' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'aspect', 1, 1.15994, 0.7981),
  ('table', 'aspect', 1.15994, 1.191, 0.6277),
  ('table', 'aspect', 1.191, 1.35233, 0.6764),
  ('table', 'aspect', 1.35233, 1.41849, 1.011),
  ('table', 'aspect', 1.41849, 1.49873, 1.148),
  ('table', 'aspect', 1.49873, 1.67254, 1.028),
  ('table', 'aspect', 1.67254, 1.81018, 1.435),
  ('table', 'aspect', 1.81018, 1.95793, 1.361),
  ('table', 'aspect', 1.95793, 2.01211, 1.383),
  ('table', 'aspect', 2.01211, 2.10146, 1.645),
  ('table', 'aspect', 2.10146, 2.38362, 0.8703),
  ('table', 'aspect', 2.38362, 2.85415, 0.3525),
  ('table', 'aspect', 2.85415, 3.3993, 0.165),
  ('table', 'aspect', 3.3993, 4.04857, 0.03498),
  ('table', 'aspect', 4.04857, 4.82186, 0.03544),
  ('table', 'aspect', 4.82186, 100, 0.003616);
DELETE FROM class_density WHERE class = 'table' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'height', -0.5, 0.021323, 0.02236),
  ('table', 'height', 0.021323, 0.146589, 0.01581),
  ('table', 'height', 0.146589, 0.271856, 5.205e-05),
  ('table', 'height', 0.271856, 0.397122, 0.001489),
  ('table', 'height', 0.397122, 0.522388, 0.01723),
  ('table', 'height', 0.522388, 0.647654, 0.727),
  ('table', 'height', 0.647654, 0.687867, 3.213),
  ('table', 'height', 0.687867, 0.709164, 5.279),
  ('table', 'height', 0.709164, 0.72459, 6.159),
  ('table', 'height', 0.72459, 0.740129, 6.337),
  ('table', 'height', 0.740129, 0.764069, 5.046),
  ('table', 'height', 0.764069, 0.772921, 4.811),
  ('table', 'height', 0.772921, 0.783051, 4.572),
  ('table', 'height', 0.783051, 0.847446, 2.028),
  ('table', 'height', 0.847446, 0.898187, 0.8353),
  ('table', 'height', 0.898187, 1.02345, 0.3598),
  ('table', 'height', 1.02345, 1.14872, 0.2019),
  ('table', 'height', 1.14872, 4, 0.001659);
DELETE FROM class_density WHERE class = 'table' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'length', 0.03, 0.592651, 0.003695),
  ('table', 'length', 0.592651, 0.707561, 0.1425),
  ('table', 'length', 0.707561, 0.804648, 0.5239),
  ('table', 'length', 0.804648, 0.844751, 0.475),
  ('table', 'length', 0.844751, 1.00227, 0.5756),
  ('table', 'length', 1.00227, 1.2029, 0.6473),
  ('table', 'length', 1.2029, 1.29645, 1.39),
  ('table', 'length', 1.29645, 1.43755, 0.9173),
  ('table', 'length', 1.43755, 1.60683, 1.124),
  ('table', 'length', 1.60683, 1.71628, 1.318),
  ('table', 'length', 1.71628, 1.75249, 1.124),
  ('table', 'length', 1.75249, 1.96586, 0.9897),
  ('table', 'length', 1.96586, 2.04905, 0.7813),
  ('table', 'length', 2.04905, 2.44634, 0.2783),
  ('table', 'length', 2.44634, 2.92067, 0.0997),
  ('table', 'length', 2.92067, 30, 0.004033);
DELETE FROM class_density WHERE class = 'table' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'rectangularity', 0, 0.376473, 0.02814),
  ('table', 'rectangularity', 0.376473, 0.442683, 0.4603),
  ('table', 'rectangularity', 0.442683, 0.507259, 0.9535),
  ('table', 'rectangularity', 0.507259, 0.575102, 1.468),
  ('table', 'rectangularity', 0.575102, 0.591048, 1.351),
  ('table', 'rectangularity', 0.591048, 0.641311, 1.878),
  ('table', 'rectangularity', 0.641311, 0.647598, 2.62),
  ('table', 'rectangularity', 0.647598, 0.681592, 3.439),
  ('table', 'rectangularity', 0.681592, 0.70752, 2.472),
  ('table', 'rectangularity', 0.70752, 0.720049, 2.971),
  ('table', 'rectangularity', 0.720049, 0.762555, 2.737),
  ('table', 'rectangularity', 0.762555, 0.77373, 2.273),
  ('table', 'rectangularity', 0.77373, 0.794258, 4.091),
  ('table', 'rectangularity', 0.794258, 0.836162, 2.568),
  ('table', 'rectangularity', 0.836162, 0.906149, 1.041),
  ('table', 'rectangularity', 0.906149, 0.959661, 0.5652),
  ('table', 'rectangularity', 0.959661, 0.972358, 0.3368),
  ('table', 'rectangularity', 0.972358, 1, 0.2346);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_length', 0.01, 0.484453, 0.002829),
  ('table', 'spread_length', 0.484453, 0.578667, 0.1071),
  ('table', 'spread_length', 0.578667, 0.691204, 0.187),
  ('table', 'spread_length', 0.691204, 0.770727, 0.4594),
  ('table', 'spread_length', 0.770727, 0.825626, 0.8385),
  ('table', 'spread_length', 0.825626, 0.871995, 0.9185),
  ('table', 'spread_length', 0.871995, 0.98619, 0.8625),
  ('table', 'spread_length', 0.98619, 1.00967, 0.5356),
  ('table', 'spread_length', 1.00967, 1.15775, 0.8017),
  ('table', 'spread_length', 1.15775, 1.17798, 0.9016),
  ('table', 'spread_length', 1.17798, 1.2757, 1.253),
  ('table', 'spread_length', 1.2757, 1.36602, 1.39),
  ('table', 'spread_length', 1.36602, 1.40707, 1.049),
  ('table', 'spread_length', 1.40707, 1.51457, 1.112),
  ('table', 'spread_length', 1.51457, 1.64709, 1.363),
  ('table', 'spread_length', 1.64709, 1.68071, 0.9215),
  ('table', 'spread_length', 1.68071, 2.00756, 0.347),
  ('table', 'spread_length', 2.00756, 2.39798, 0.1229),
  ('table', 'spread_length', 2.39798, 40, 0.003715);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_width', 0.003, 0.162633, 0.002779),
  ('table', 'spread_width', 0.162633, 0.204853, 0.06065),
  ('table', 'spread_width', 0.204853, 0.258032, 0.07377),
  ('table', 'spread_width', 0.258032, 0.325017, 0.119),
  ('table', 'spread_width', 0.325017, 0.398466, 0.1929),
  ('table', 'spread_width', 0.398466, 0.409391, 0.2407),
  ('table', 'spread_width', 0.409391, 0.515668, 0.4446),
  ('table', 'spread_width', 0.515668, 0.623351, 0.6624),
  ('table', 'spread_width', 0.623351, 0.649535, 1.214),
  ('table', 'spread_width', 0.649535, 0.674304, 1.61),
  ('table', 'spread_width', 0.674304, 0.709727, 2.012),
  ('table', 'spread_width', 0.709727, 0.751466, 1.761),
  ('table', 'spread_width', 0.751466, 0.818154, 1.324),
  ('table', 'spread_width', 0.818154, 0.8938, 1.285),
  ('table', 'spread_width', 0.8938, 1.03055, 0.4737),
  ('table', 'spread_width', 1.03055, 1.29807, 0.1692),
  ('table', 'spread_width', 1.29807, 20, 0.003542);
DELETE FROM class_density WHERE class = 'table' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'tilt_deg', 0, 0.156508, 0.911),
  ('table', 'tilt_deg', 0.156508, 0.329258, 0.9238),
  ('table', 'tilt_deg', 0.329258, 0.469293, 0.88),
  ('table', 'tilt_deg', 0.469293, 0.586283, 0.779),
  ('table', 'tilt_deg', 0.586283, 0.70498, 0.6518),
  ('table', 'tilt_deg', 0.70498, 1.05747, 0.4378),
  ('table', 'tilt_deg', 1.05747, 1.40996, 0.3017),
  ('table', 'tilt_deg', 1.40996, 1.76245, 0.1921),
  ('table', 'tilt_deg', 1.76245, 2.11494, 0.1217),
  ('table', 'tilt_deg', 2.11494, 2.46743, 0.05255),
  ('table', 'tilt_deg', 2.46743, 2.81992, 0.01972),
  ('table', 'tilt_deg', 2.81992, 3.17241, 0.01341),
  ('table', 'tilt_deg', 3.17241, 90, 5.29e-05);
DELETE FROM class_density WHERE class = 'table' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'width', 0.01, 0.219712, 0.002899),
  ('table', 'width', 0.219712, 0.277665, 0.08221),
  ('table', 'width', 0.277665, 0.350904, 0.07046),
  ('table', 'width', 0.350904, 0.443462, 0.1475),
  ('table', 'width', 0.443462, 0.52915, 0.2189),
  ('table', 'width', 0.52915, 0.560434, 0.3344),
  ('table', 'width', 0.560434, 0.655363, 0.5524),
  ('table', 'width', 0.655363, 0.708259, 0.9838),
  ('table', 'width', 0.708259, 0.728718, 1.501),
  ('table', 'width', 0.728718, 0.794534, 1.239),
  ('table', 'width', 0.794534, 0.853421, 1.559),
  ('table', 'width', 0.853421, 0.895076, 1.794),
  ('table', 'width', 0.895076, 0.970444, 1.613),
  ('table', 'width', 0.970444, 1.05833, 1.154),
  ('table', 'width', 1.05833, 1.13117, 0.7124),
  ('table', 'width', 1.13117, 1.42954, 0.2238),
  ('table', 'width', 1.42954, 1.8066, 0.06059),
  ('table', 'width', 1.8066, 12, 0.004682);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_max', -0.5, 0.0340882, 0.02226),
  ('table', 'z_max', 0.0340882, 0.158176, 0.01409),
  ('table', 'z_max', 0.158176, 0.282263, 5.535e-05),
  ('table', 'z_max', 0.282263, 0.406351, 0.00153),
  ('table', 'z_max', 0.406351, 0.530438, 0.01732),
  ('table', 'z_max', 0.530438, 0.654525, 0.6296),
  ('table', 'z_max', 0.654525, 0.665546, 2.572),
  ('table', 'z_max', 0.665546, 0.69346, 4.035),
  ('table', 'z_max', 0.69346, 0.712088, 5.473),
  ('table', 'z_max', 0.712088, 0.730782, 5.642),
  ('table', 'z_max', 0.730782, 0.748319, 6.157),
  ('table', 'z_max', 0.748319, 0.768883, 5.267),
  ('table', 'z_max', 0.768883, 0.778613, 4.77),
  ('table', 'z_max', 0.778613, 0.789273, 4.326),
  ('table', 'z_max', 0.789273, 0.853819, 1.974),
  ('table', 'z_max', 0.853819, 0.9027, 0.8216),
  ('table', 'z_max', 0.9027, 1.02679, 0.3964),
  ('table', 'z_max', 1.02679, 1.15088, 0.2091),
  ('table', 'z_max', 1.15088, 4, 0.0021);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_min', -0.5, 0.0127318, 0.02253),
  ('table', 'z_min', 0.0127318, 0.138587, 0.01656),
  ('table', 'z_min', 0.138587, 0.264442, 4.83e-05),
  ('table', 'z_min', 0.264442, 0.390297, 0.001435),
  ('table', 'z_min', 0.390297, 0.516152, 0.01707),
  ('table', 'z_min', 0.516152, 0.642007, 0.7687),
  ('table', 'z_min', 0.642007, 0.683021, 3.014),
  ('table', 'z_min', 0.683021, 0.704462, 5.288),
  ('table', 'z_min', 0.704462, 0.720827, 5.987),
  ('table', 'z_min', 0.720827, 0.735257, 6.328),
  ('table', 'z_min', 0.735257, 0.76007, 5.022),
  ('table', 'z_min', 0.76007, 0.767862, 4.86),
  ('table', 'z_min', 0.767862, 0.778519, 4.812),
  ('table', 'z_min', 0.778519, 0.840676, 2.095),
  ('table', 'z_min', 0.840676, 0.893718, 0.8546),
  ('table', 'z_min', 0.893718, 1.01957, 0.3403),
  ('table', 'z_min', 1.01957, 1.14543, 0.1923),
  ('table', 'z_min', 1.14543, 4, 0.001631);

-- flat_screen: 178 examples
UPDATE object_class SET prior = 0.03777 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.824, 0.4265)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.4144, 0.218)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.031, 0.1198)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.5775, 0.2854)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.7885, 0.1241)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7512, 0.2287)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.207, 0.1863)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.12, 3.515)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -0.9929, 0.2354)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.192, 0.1256)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7948, 0.1627)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'area_m2', 0.002, 0.0445886, 0.002605),
  ('flat_screen', 'area_m2', 0.0445886, 0.0569092, 0.05518),
  ('flat_screen', 'area_m2', 0.0569092, 0.0726342, 0.07527),
  ('flat_screen', 'area_m2', 0.0726342, 0.0927043, 0.2344),
  ('flat_screen', 'area_m2', 0.0927043, 0.0966933, 0.3098),
  ('flat_screen', 'area_m2', 0.0966933, 0.116716, 0.5729),
  ('flat_screen', 'area_m2', 0.116716, 0.135578, 0.7843),
  ('flat_screen', 'area_m2', 0.135578, 0.151014, 0.8927),
  ('flat_screen', 'area_m2', 0.151014, 0.156352, 0.5127),
  ('flat_screen', 'area_m2', 0.156352, 0.180685, 0.8038),
  ('flat_screen', 'area_m2', 0.180685, 0.192742, 0.9852),
  ('flat_screen', 'area_m2', 0.192742, 0.207726, 0.5601),
  ('flat_screen', 'area_m2', 0.207726, 0.233109, 0.9836),
  ('flat_screen', 'area_m2', 0.233109, 0.246, 1.093),
  ('flat_screen', 'area_m2', 0.246, 0.258248, 0.8428),
  ('flat_screen', 'area_m2', 0.258248, 0.313974, 0.3926),
  ('flat_screen', 'area_m2', 0.313974, 0.40073, 0.1213),
  ('flat_screen', 'area_m2', 0.40073, 100, 0.001657);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'aspect', 1, 1.12762, 0.6908),
  ('flat_screen', 'aspect', 1.12762, 1.17866, 0.5176),
  ('flat_screen', 'aspect', 1.17866, 1.27153, 1.161),
  ('flat_screen', 'aspect', 1.27153, 1.28669, 2.335),
  ('flat_screen', 'aspect', 1.28669, 1.3734, 1.802),
  ('flat_screen', 'aspect', 1.3734, 1.43381, 2.002),
  ('flat_screen', 'aspect', 1.43381, 1.4466, 2.215),
  ('flat_screen', 'aspect', 1.4466, 1.53626, 1.677),
  ('flat_screen', 'aspect', 1.53626, 1.6168, 2.119),
  ('flat_screen', 'aspect', 1.6168, 1.69991, 2.182),
  ('flat_screen', 'aspect', 1.69991, 1.82314, 1.098),
  ('flat_screen', 'aspect', 1.82314, 1.9536, 0.6312),
  ('flat_screen', 'aspect', 1.9536, 2.05581, 0.4849),
  ('flat_screen', 'aspect', 2.05581, 2.31818, 0.3532),
  ('flat_screen', 'aspect', 2.31818, 2.61404, 0.2164),
  ('flat_screen', 'aspect', 2.61404, 2.94765, 0.0969),
  ('flat_screen', 'aspect', 2.94765, 100, 0.003195);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'height', -0.5, 0.673955, 0.009044),
  ('flat_screen', 'height', 0.673955, 0.754286, 0.007949),
  ('flat_screen', 'height', 0.754286, 0.834616, 0.2002),
  ('flat_screen', 'height', 0.834616, 0.914947, 0.8948),
  ('flat_screen', 'height', 0.914947, 0.928776, 1.945),
  ('flat_screen', 'height', 0.928776, 0.960193, 3.258),
  ('flat_screen', 'height', 0.960193, 0.984237, 4.721),
  ('flat_screen', 'height', 0.984237, 0.995277, 5.691),
  ('flat_screen', 'height', 0.995277, 1.02153, 5.576),
  ('flat_screen', 'height', 1.02153, 1.04107, 4.75),
  ('flat_screen', 'height', 1.04107, 1.07561, 3.459),
  ('flat_screen', 'height', 1.07561, 1.15594, 1.412),
  ('flat_screen', 'height', 1.15594, 1.16834, 0.824),
  ('flat_screen', 'height', 1.16834, 1.23627, 0.5309),
  ('flat_screen', 'height', 1.23627, 1.3166, 0.3218),
  ('flat_screen', 'height', 1.3166, 1.39693, 0.5257),
  ('flat_screen', 'height', 1.39693, 4, 0.00334);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'length', 0.03, 0.285949, 0.004086),
  ('flat_screen', 'length', 0.285949, 0.333206, 0.137),
  ('flat_screen', 'length', 0.333206, 0.388274, 0.4685),
  ('flat_screen', 'length', 0.388274, 0.446837, 0.8745),
  ('flat_screen', 'length', 0.446837, 0.500457, 0.9628),
  ('flat_screen', 'length', 0.500457, 0.527216, 1.605),
  ('flat_screen', 'length', 0.527216, 0.573603, 1.572),
  ('flat_screen', 'length', 0.573603, 0.614346, 1.242),
  ('flat_screen', 'length', 0.614346, 0.626683, 1.223),
  ('flat_screen', 'length', 0.626683, 0.698643, 1.068),
  ('flat_screen', 'length', 0.698643, 0.715877, 1.184),
  ('flat_screen', 'length', 0.715877, 0.803377, 0.7494),
  ('flat_screen', 'length', 0.803377, 0.834187, 0.4803),
  ('flat_screen', 'length', 0.834187, 0.97205, 0.345),
  ('flat_screen', 'length', 0.97205, 1.1327, 0.1755),
  ('flat_screen', 'length', 1.1327, 30, 0.003489);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'rectangularity', 0, 0.467712, 0.02002),
  ('flat_screen', 'rectangularity', 0.467712, 0.526855, 0.2669),
  ('flat_screen', 'rectangularity', 0.526855, 0.585998, 0.7568),
  ('flat_screen', 'rectangularity', 0.585998, 0.617907, 0.948),
  ('flat_screen', 'rectangularity', 0.617907, 0.645141, 1.084),
  ('flat_screen', 'rectangularity', 0.645141, 0.685189, 2.293),
  ('flat_screen', 'rectangularity', 0.685189, 0.704284, 3.376),
  ('flat_screen', 'rectangularity', 0.704284, 0.725088, 2.44),
  ('flat_screen', 'rectangularity', 0.725088, 0.763427, 1.75),
  ('flat_screen', 'rectangularity', 0.763427, 0.781651, 2.062),
  ('flat_screen', 'rectangularity', 0.781651, 0.822571, 2.447),
  ('flat_screen', 'rectangularity', 0.822571, 0.828577, 3.009),
  ('flat_screen', 'rectangularity', 0.828577, 0.866895, 3.08),
  ('flat_screen', 'rectangularity', 0.866895, 0.881714, 3.745),
  ('flat_screen', 'rectangularity', 0.881714, 0.898588, 2.758),
  ('flat_screen', 'rectangularity', 0.898588, 0.940857, 2.432),
  ('flat_screen', 'rectangularity', 0.940857, 0.98263, 2.497),
  ('flat_screen', 'rectangularity', 0.98263, 1, 0.7608);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_length', 0.01, 0.285092, 0.002787),
  ('flat_screen', 'spread_length', 0.285092, 0.323776, 0.1977),
  ('flat_screen', 'spread_length', 0.323776, 0.349784, 1.083),
  ('flat_screen', 'spread_length', 0.349784, 0.367709, 1.279),
  ('flat_screen', 'spread_length', 0.367709, 0.380542, 0.8999),
  ('flat_screen', 'spread_length', 0.380542, 0.417604, 0.928),
  ('flat_screen', 'spread_length', 0.417604, 0.431393, 1.391),
  ('flat_screen', 'spread_length', 0.431393, 0.457898, 1.657),
  ('flat_screen', 'spread_length', 0.457898, 0.474268, 1.537),
  ('flat_screen', 'spread_length', 0.474268, 0.502659, 1.12),
  ('flat_screen', 'spread_length', 0.502659, 0.526858, 2.118),
  ('flat_screen', 'spread_length', 0.526858, 0.538621, 2.449),
  ('flat_screen', 'spread_length', 0.538621, 0.554248, 1.823),
  ('flat_screen', 'spread_length', 0.554248, 0.603409, 1.368),
  ('flat_screen', 'spread_length', 0.603409, 0.611706, 0.9267),
  ('flat_screen', 'spread_length', 0.611706, 0.694708, 0.4456),
  ('flat_screen', 'spread_length', 0.694708, 0.788973, 0.1868),
  ('flat_screen', 'spread_length', 0.788973, 0.896028, 0.09273),
  ('flat_screen', 'spread_length', 0.896028, 40, 0.002804);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_width', 0.003, 0.150319, 0.002739),
  ('flat_screen', 'spread_width', 0.150319, 0.168023, 0.08861),
  ('flat_screen', 'spread_width', 0.168023, 0.187811, 0.1483),
  ('flat_screen', 'spread_width', 0.187811, 0.209931, 0.1638),
  ('flat_screen', 'spread_width', 0.209931, 0.234655, 0.2649),
  ('flat_screen', 'spread_width', 0.234655, 0.248331, 0.4862),
  ('flat_screen', 'spread_width', 0.248331, 0.262291, 0.9798),
  ('flat_screen', 'spread_width', 0.262291, 0.269935, 2.104),
  ('flat_screen', 'spread_width', 0.269935, 0.283953, 2.164),
  ('flat_screen', 'spread_width', 0.283953, 0.293182, 2.101),
  ('flat_screen', 'spread_width', 0.293182, 0.299264, 2.277),
  ('flat_screen', 'spread_width', 0.299264, 0.315662, 2.199),
  ('flat_screen', 'spread_width', 0.315662, 0.327012, 2.697),
  ('flat_screen', 'spread_width', 0.327012, 0.34873, 1.853),
  ('flat_screen', 'spread_width', 0.34873, 0.366307, 1.857),
  ('flat_screen', 'spread_width', 0.366307, 0.409448, 1.06),
  ('flat_screen', 'spread_width', 0.409448, 20, 0.002332);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'tilt_deg', 0, 74.8242, 0.0001241),
  ('flat_screen', 'tilt_deg', 74.8242, 76.5104, 0.003255),
  ('flat_screen', 'tilt_deg', 76.5104, 78.1966, 0.002619),
  ('flat_screen', 'tilt_deg', 78.1966, 79.8828, 0.03367),
  ('flat_screen', 'tilt_deg', 79.8828, 80.4891, 0.06085),
  ('flat_screen', 'tilt_deg', 80.4891, 81.569, 0.08142),
  ('flat_screen', 'tilt_deg', 81.569, 81.913, 0.06615),
  ('flat_screen', 'tilt_deg', 81.913, 83.2552, 0.06715),
  ('flat_screen', 'tilt_deg', 83.2552, 83.4551, 0.08669),
  ('flat_screen', 'tilt_deg', 83.4551, 84.7081, 0.08445),
  ('flat_screen', 'tilt_deg', 84.7081, 84.9414, 0.08883),
  ('flat_screen', 'tilt_deg', 84.9414, 85.8864, 0.1048),
  ('flat_screen', 'tilt_deg', 85.8864, 86.6276, 0.08573),
  ('flat_screen', 'tilt_deg', 86.6276, 87.7485, 0.05096),
  ('flat_screen', 'tilt_deg', 87.7485, 88.3138, 0.09097),
  ('flat_screen', 'tilt_deg', 88.3138, 88.6907, 0.1637),
  ('flat_screen', 'tilt_deg', 88.6907, 89.1917, 0.1764),
  ('flat_screen', 'tilt_deg', 89.1917, 90, 0.15);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'width', 0.01, 0.181045, 0.003027),
  ('flat_screen', 'width', 0.181045, 0.208747, 0.0767),
  ('flat_screen', 'width', 0.208747, 0.240687, 0.1789),
  ('flat_screen', 'width', 0.240687, 0.27491, 0.4913),
  ('flat_screen', 'width', 0.27491, 0.277515, 1.266),
  ('flat_screen', 'width', 0.277515, 0.306847, 0.9441),
  ('flat_screen', 'width', 0.306847, 0.319977, 0.6556),
  ('flat_screen', 'width', 0.319977, 0.348946, 1.164),
  ('flat_screen', 'width', 0.348946, 0.368936, 1.774),
  ('flat_screen', 'width', 0.368936, 0.39184, 1.869),
  ('flat_screen', 'width', 0.39184, 0.417526, 1.671),
  ('flat_screen', 'width', 0.417526, 0.425387, 1.96),
  ('flat_screen', 'width', 0.425387, 0.439663, 2.109),
  ('flat_screen', 'width', 0.439663, 0.467735, 1.897),
  ('flat_screen', 'width', 0.467735, 0.490475, 1.004),
  ('flat_screen', 'width', 0.490475, 0.565522, 0.2012),
  ('flat_screen', 'width', 0.565522, 0.652052, 0.1672),
  ('flat_screen', 'width', 0.652052, 12, 0.004513);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_max', -0.5, 0.849343, 0.007951),
  ('flat_screen', 'z_max', 0.849343, 0.931062, 0.01342),
  ('flat_screen', 'z_max', 0.931062, 1.01278, 0.3369),
  ('flat_screen', 'z_max', 1.01278, 1.07468, 1.192),
  ('flat_screen', 'z_max', 1.07468, 1.0945, 2.394),
  ('flat_screen', 'z_max', 1.0945, 1.11127, 3.922),
  ('flat_screen', 'z_max', 1.11127, 1.13462, 4.534),
  ('flat_screen', 'z_max', 1.13462, 1.15703, 4.7),
  ('flat_screen', 'z_max', 1.15703, 1.17622, 4.738),
  ('flat_screen', 'z_max', 1.17622, 1.20579, 4.339),
  ('flat_screen', 'z_max', 1.20579, 1.24459, 3.056),
  ('flat_screen', 'z_max', 1.24459, 1.25794, 1.396),
  ('flat_screen', 'z_max', 1.25794, 1.33966, 0.9949),
  ('flat_screen', 'z_max', 1.33966, 1.35064, 0.696),
  ('flat_screen', 'z_max', 1.35064, 1.42138, 0.6254),
  ('flat_screen', 'z_max', 1.42138, 1.5031, 0.4507),
  ('flat_screen', 'z_max', 1.5031, 1.58288, 0.3821),
  ('flat_screen', 'z_max', 1.58288, 4, 0.002276);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_min', -0.5, 0.0481933, 0.01896),
  ('flat_screen', 'z_min', 0.0481933, 0.180948, 0.04032),
  ('flat_screen', 'z_min', 0.180948, 0.313704, 0.001071),
  ('flat_screen', 'z_min', 0.313704, 0.446459, 0.006938),
  ('flat_screen', 'z_min', 0.446459, 0.579214, 0.06314),
  ('flat_screen', 'z_min', 0.579214, 0.669827, 1.114),
  ('flat_screen', 'z_min', 0.669827, 0.698522, 3.374),
  ('flat_screen', 'z_min', 0.698522, 0.711969, 3.192),
  ('flat_screen', 'z_min', 0.711969, 0.733548, 3.44),
  ('flat_screen', 'z_min', 0.733548, 0.756559, 4.199),
  ('flat_screen', 'z_min', 0.756559, 0.799394, 2.931),
  ('flat_screen', 'z_min', 0.799394, 0.834994, 2.72),
  ('flat_screen', 'z_min', 0.834994, 0.844724, 2.823),
  ('flat_screen', 'z_min', 0.844724, 0.874836, 2.603),
  ('flat_screen', 'z_min', 0.874836, 0.964382, 1.327),
  ('flat_screen', 'z_min', 0.964382, 0.977479, 0.6112),
  ('flat_screen', 'z_min', 0.977479, 1.11023, 0.4566),
  ('flat_screen', 'z_min', 1.11023, 1.24299, 0.2944),
  ('flat_screen', 'z_min', 1.24299, 4, 0.003092);

-- keyboard: 110 examples
UPDATE object_class SET prior = 0.0234 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.76, 0.3499)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.8165, 0.2793)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7806, 0.1009)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.8756, 0.2461)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8315, 0.08168)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9324, 0.2523)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.836, 0.1453)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 4.008, 2.352)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.695, 0.2119)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.789, 0.102)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7729, 0.1003)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'area_m2', 0.002, 0.0161329, 0.004996),
  ('keyboard', 'area_m2', 0.0161329, 0.0204451, 0.04344),
  ('keyboard', 'area_m2', 0.0204451, 0.02591, 0.03812),
  ('keyboard', 'area_m2', 0.02591, 0.0328357, 0.05136),
  ('keyboard', 'area_m2', 0.0328357, 0.0411545, 0.2893),
  ('keyboard', 'area_m2', 0.0411545, 0.0527354, 0.4574),
  ('keyboard', 'area_m2', 0.0527354, 0.0536253, 0.5691),
  ('keyboard', 'area_m2', 0.0536253, 0.060418, 0.9357),
  ('keyboard', 'area_m2', 0.060418, 0.0664078, 1.337),
  ('keyboard', 'area_m2', 0.0664078, 0.0696024, 1.909),
  ('keyboard', 'area_m2', 0.0696024, 0.0742111, 1.615),
  ('keyboard', 'area_m2', 0.0742111, 0.0800037, 1.597),
  ('keyboard', 'area_m2', 0.0800037, 0.0846952, 1.507),
  ('keyboard', 'area_m2', 0.0846952, 0.0867726, 0.8024),
  ('keyboard', 'area_m2', 0.0867726, 0.107334, 0.3795),
  ('keyboard', 'area_m2', 0.107334, 0.136024, 0.08521),
  ('keyboard', 'area_m2', 0.136024, 100, 0.001876);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'aspect', 1, 1.17579, 0.154),
  ('keyboard', 'aspect', 1.17579, 1.38249, 0.1911),
  ('keyboard', 'aspect', 1.38249, 1.62552, 0.3687),
  ('keyboard', 'aspect', 1.62552, 1.87206, 0.7796),
  ('keyboard', 'aspect', 1.87206, 1.91128, 1.265),
  ('keyboard', 'aspect', 1.91128, 2.0187, 1.455),
  ('keyboard', 'aspect', 2.0187, 2.24621, 1.036),
  ('keyboard', 'aspect', 2.24621, 2.37718, 1.775),
  ('keyboard', 'aspect', 2.37718, 2.5551, 1.759),
  ('keyboard', 'aspect', 2.5551, 2.64232, 0.7688),
  ('keyboard', 'aspect', 2.64232, 2.8639, 1.044),
  ('keyboard', 'aspect', 2.8639, 3.10683, 1.192),
  ('keyboard', 'aspect', 3.10683, 3.65299, 0.62),
  ('keyboard', 'aspect', 3.65299, 4.2853, 0.09359),
  ('keyboard', 'aspect', 4.2853, 100, 0.002545);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'height', -0.5, 0.615932, 0.01503),
  ('keyboard', 'height', 0.615932, 0.676555, 1.263),
  ('keyboard', 'height', 0.676555, 0.685748, 2.02),
  ('keyboard', 'height', 0.685748, 0.716025, 3.699),
  ('keyboard', 'height', 0.716025, 0.733132, 5.915),
  ('keyboard', 'height', 0.733132, 0.753318, 6.055),
  ('keyboard', 'height', 0.753318, 0.765665, 6.01),
  ('keyboard', 'height', 0.765665, 0.795399, 4.924),
  ('keyboard', 'height', 0.795399, 0.808303, 5.33),
  ('keyboard', 'height', 0.808303, 0.858424, 2.299),
  ('keyboard', 'height', 0.858424, 0.878583, 1.162),
  ('keyboard', 'height', 0.878583, 0.919047, 0.9287),
  ('keyboard', 'height', 0.919047, 0.97967, 0.6031),
  ('keyboard', 'height', 0.97967, 1.04029, 0.2226),
  ('keyboard', 'height', 1.04029, 1.10092, 0.1047),
  ('keyboard', 'height', 1.10092, 1.16154, 0.3541),
  ('keyboard', 'height', 1.16154, 4, 0.003228);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'length', 0.03, 0.1611, 0.006418),
  ('keyboard', 'length', 0.1611, 0.188868, 0.04599),
  ('keyboard', 'length', 0.188868, 0.221423, 0.1551),
  ('keyboard', 'length', 0.221423, 0.259589, 0.0674),
  ('keyboard', 'length', 0.259589, 0.304334, 0.2769),
  ('keyboard', 'length', 0.304334, 0.310183, 0.7664),
  ('keyboard', 'length', 0.310183, 0.356791, 0.727),
  ('keyboard', 'length', 0.356791, 0.361431, 0.6714),
  ('keyboard', 'length', 0.361431, 0.418289, 0.4841),
  ('keyboard', 'length', 0.418289, 0.434697, 2.12),
  ('keyboard', 'length', 0.434697, 0.446599, 3.506),
  ('keyboard', 'length', 0.446599, 0.456016, 4.134),
  ('keyboard', 'length', 0.456016, 0.468482, 4.288),
  ('keyboard', 'length', 0.468482, 0.477229, 4.062),
  ('keyboard', 'length', 0.477229, 0.490389, 3.353),
  ('keyboard', 'length', 0.490389, 0.574915, 0.8515),
  ('keyboard', 'length', 0.574915, 0.674012, 0.08367),
  ('keyboard', 'length', 0.674012, 30, 0.003547);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'rectangularity', 0, 0.614281, 0.01937),
  ('keyboard', 'rectangularity', 0.614281, 0.656104, 0.3354),
  ('keyboard', 'rectangularity', 0.656104, 0.697927, 0.9066),
  ('keyboard', 'rectangularity', 0.697927, 0.723175, 1.611),
  ('keyboard', 'rectangularity', 0.723175, 0.73975, 2.26),
  ('keyboard', 'rectangularity', 0.73975, 0.774403, 2.37),
  ('keyboard', 'rectangularity', 0.774403, 0.781573, 4.245),
  ('keyboard', 'rectangularity', 0.781573, 0.801073, 4.661),
  ('keyboard', 'rectangularity', 0.801073, 0.823396, 3.951),
  ('keyboard', 'rectangularity', 0.823396, 0.82881, 4.437),
  ('keyboard', 'rectangularity', 0.82881, 0.846169, 5.658),
  ('keyboard', 'rectangularity', 0.846169, 0.865219, 4.868),
  ('keyboard', 'rectangularity', 0.865219, 0.891195, 4.769),
  ('keyboard', 'rectangularity', 0.891195, 0.907042, 3.165),
  ('keyboard', 'rectangularity', 0.907042, 0.946683, 1.913),
  ('keyboard', 'rectangularity', 0.946683, 0.979079, 2.703),
  ('keyboard', 'rectangularity', 0.979079, 0.990688, 0.8804),
  ('keyboard', 'rectangularity', 0.990688, 1, 0.398);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_length', 0.01, 0.140479, 0.003088),
  ('keyboard', 'spread_length', 0.140479, 0.164561, 0.05248),
  ('keyboard', 'spread_length', 0.164561, 0.192771, 0.08783),
  ('keyboard', 'spread_length', 0.192771, 0.225817, 0.08636),
  ('keyboard', 'spread_length', 0.225817, 0.264529, 0.1368),
  ('keyboard', 'spread_length', 0.264529, 0.299712, 0.4667),
  ('keyboard', 'spread_length', 0.299712, 0.309877, 1.488),
  ('keyboard', 'spread_length', 0.309877, 0.333294, 0.7868),
  ('keyboard', 'spread_length', 0.333294, 0.362998, 0.3543),
  ('keyboard', 'spread_length', 0.362998, 0.412231, 0.822),
  ('keyboard', 'spread_length', 0.412231, 0.425227, 2.947),
  ('keyboard', 'spread_length', 0.425227, 0.435628, 3.628),
  ('keyboard', 'spread_length', 0.435628, 0.453018, 3.966),
  ('keyboard', 'spread_length', 0.453018, 0.45832, 4.59),
  ('keyboard', 'spread_length', 0.45832, 0.47119, 4.059),
  ('keyboard', 'spread_length', 0.47119, 0.498122, 1.612),
  ('keyboard', 'spread_length', 0.498122, 0.583515, 0.1778),
  ('keyboard', 'spread_length', 0.583515, 40, 0.00387);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_width', 0.003, 0.106429, 0.001488),
  ('keyboard', 'spread_width', 0.106429, 0.110677, 0.2429),
  ('keyboard', 'spread_width', 0.110677, 0.117036, 0.3087),
  ('keyboard', 'spread_width', 0.117036, 0.1287, 0.4141),
  ('keyboard', 'spread_width', 0.1287, 0.13528, 0.8224),
  ('keyboard', 'spread_width', 0.13528, 0.141527, 1.452),
  ('keyboard', 'spread_width', 0.141527, 0.14436, 2.261),
  ('keyboard', 'spread_width', 0.14436, 0.151344, 2.507),
  ('keyboard', 'spread_width', 0.151344, 0.155632, 2.828),
  ('keyboard', 'spread_width', 0.155632, 0.162238, 3.129),
  ('keyboard', 'spread_width', 0.162238, 0.168816, 2.917),
  ('keyboard', 'spread_width', 0.168816, 0.171142, 2.719),
  ('keyboard', 'spread_width', 0.171142, 0.176214, 2.213),
  ('keyboard', 'spread_width', 0.176214, 0.187404, 1.813),
  ('keyboard', 'spread_width', 0.187404, 0.206955, 0.9187),
  ('keyboard', 'spread_width', 0.206955, 0.227581, 0.07876),
  ('keyboard', 'spread_width', 0.227581, 0.250262, 0.1201),
  ('keyboard', 'spread_width', 0.250262, 20, 0.002341);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'tilt_deg', 0, 0.252684, 0.02684),
  ('keyboard', 'tilt_deg', 0.252684, 1.21441, 0.1184),
  ('keyboard', 'tilt_deg', 1.21441, 1.64426, 0.2067),
  ('keyboard', 'tilt_deg', 1.64426, 2.46671, 0.1215),
  ('keyboard', 'tilt_deg', 2.46671, 2.60196, 0.1442),
  ('keyboard', 'tilt_deg', 2.60196, 3.33702, 0.1518),
  ('keyboard', 'tilt_deg', 3.33702, 3.67578, 0.09793),
  ('keyboard', 'tilt_deg', 3.67578, 4.25283, 0.1369),
  ('keyboard', 'tilt_deg', 4.25283, 4.88484, 0.1405),
  ('keyboard', 'tilt_deg', 4.88484, 5.19237, 0.1061),
  ('keyboard', 'tilt_deg', 5.19237, 5.96057, 0.1289),
  ('keyboard', 'tilt_deg', 5.96057, 6.0939, 0.1259),
  ('keyboard', 'tilt_deg', 6.0939, 6.85585, 0.1213),
  ('keyboard', 'tilt_deg', 6.85585, 7.30297, 0.1067),
  ('keyboard', 'tilt_deg', 7.30297, 8.51203, 0.02917),
  ('keyboard', 'tilt_deg', 8.51203, 9.72109, 0.01261),
  ('keyboard', 'tilt_deg', 9.72109, 10.9223, 0.0102),
  ('keyboard', 'tilt_deg', 10.9223, 90, 9.069e-05);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'width', 0.01, 0.123943, 0.003711),
  ('keyboard', 'width', 0.123943, 0.139351, 0.5916),
  ('keyboard', 'width', 0.139351, 0.144871, 1.031),
  ('keyboard', 'width', 0.144871, 0.152383, 2.032),
  ('keyboard', 'width', 0.152383, 0.156674, 1.994),
  ('keyboard', 'width', 0.156674, 0.162777, 1.406),
  ('keyboard', 'width', 0.162777, 0.17564, 1.449),
  ('keyboard', 'width', 0.17564, 0.188096, 1.784),
  ('keyboard', 'width', 0.188096, 0.198049, 1.958),
  ('keyboard', 'width', 0.198049, 0.213323, 1.555),
  ('keyboard', 'width', 0.213323, 0.222669, 0.9409),
  ('keyboard', 'width', 0.222669, 0.241267, 0.7859),
  ('keyboard', 'width', 0.241267, 0.25035, 0.6823),
  ('keyboard', 'width', 0.25035, 0.281472, 0.5431),
  ('keyboard', 'width', 0.281472, 0.316463, 0.1042),
  ('keyboard', 'width', 0.316463, 0.355804, 0.03953),
  ('keyboard', 'width', 0.355804, 12, 0.00327);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_max', -0.5, 0.62483, 0.01426),
  ('keyboard', 'z_max', 0.62483, 0.685913, 1.378),
  ('keyboard', 'z_max', 0.685913, 0.692765, 1.973),
  ('keyboard', 'z_max', 0.692765, 0.723931, 3.706),
  ('keyboard', 'z_max', 0.723931, 0.739278, 5.705),
  ('keyboard', 'z_max', 0.739278, 0.746995, 5.79),
  ('keyboard', 'z_max', 0.746995, 0.762066, 5.822),
  ('keyboard', 'z_max', 0.762066, 0.776805, 5.806),
  ('keyboard', 'z_max', 0.776805, 0.799481, 4.86),
  ('keyboard', 'z_max', 0.799481, 0.808078, 5.228),
  ('keyboard', 'z_max', 0.808078, 0.820733, 4.745),
  ('keyboard', 'z_max', 0.820733, 0.86916, 2.215),
  ('keyboard', 'z_max', 0.86916, 0.884646, 1.111),
  ('keyboard', 'z_max', 0.884646, 0.930243, 0.8541),
  ('keyboard', 'z_max', 0.930243, 0.991325, 0.5926),
  ('keyboard', 'z_max', 0.991325, 1.05241, 0.2291),
  ('keyboard', 'z_max', 1.05241, 1.11349, 0.09985),
  ('keyboard', 'z_max', 1.11349, 1.17457, 0.3507),
  ('keyboard', 'z_max', 1.17457, 4, 0.003159);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_min', -0.5, 0.604629, 0.01504),
  ('keyboard', 'z_min', 0.604629, 0.665164, 1.079),
  ('keyboard', 'z_min', 0.665164, 0.679109, 2.349),
  ('keyboard', 'z_min', 0.679109, 0.708191, 3.771),
  ('keyboard', 'z_min', 0.708191, 0.725698, 5.447),
  ('keyboard', 'z_min', 0.725698, 0.744629, 6.093),
  ('keyboard', 'z_min', 0.744629, 0.760606, 6.11),
  ('keyboard', 'z_min', 0.760606, 0.785563, 5.221),
  ('keyboard', 'z_min', 0.785563, 0.803075, 5.012),
  ('keyboard', 'z_min', 0.803075, 0.846768, 2.147),
  ('keyboard', 'z_min', 0.846768, 0.873772, 1.205),
  ('keyboard', 'z_min', 0.873772, 0.907302, 1.04),
  ('keyboard', 'z_min', 0.907302, 0.967837, 0.6129),
  ('keyboard', 'z_min', 0.967837, 1.02837, 0.2195),
  ('keyboard', 'z_min', 1.02837, 1.08891, 0.1059),
  ('keyboard', 'z_min', 1.08891, 1.14944, 0.3512),
  ('keyboard', 'z_min', 1.14944, 4, 0.003481);

-- chair_seat: 142 examples
UPDATE object_class SET prior = 0.0302 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.084, 0.5566)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.3191, 0.3074)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4732, 0.03349)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7257, 0.1915)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.747, 0.1404)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7638, 0.1883)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.234, 0.3907)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 1.208, 1.004)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.047, 0.3688)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4783, 0.03357)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4694, 0.03377)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'area_m2', 0.002, 0.0274431, 0.003945),
  ('chair_seat', 'area_m2', 0.0274431, 0.0355341, 0.09889),
  ('chair_seat', 'area_m2', 0.0355341, 0.0460105, 0.1667),
  ('chair_seat', 'area_m2', 0.0460105, 0.0574185, 0.1585),
  ('chair_seat', 'area_m2', 0.0574185, 0.0595757, 0.2158),
  ('chair_seat', 'area_m2', 0.0595757, 0.0771403, 0.2938),
  ('chair_seat', 'area_m2', 0.0771403, 0.0855618, 0.3411),
  ('chair_seat', 'area_m2', 0.0855618, 0.0998834, 0.4248),
  ('chair_seat', 'area_m2', 0.0998834, 0.107092, 0.631),
  ('chair_seat', 'area_m2', 0.107092, 0.129332, 0.4281),
  ('chair_seat', 'area_m2', 0.129332, 0.139143, 0.3441),
  ('chair_seat', 'area_m2', 0.139143, 0.1635, 0.7705),
  ('chair_seat', 'area_m2', 0.1635, 0.167463, 0.9303),
  ('chair_seat', 'area_m2', 0.167463, 0.178779, 0.9893),
  ('chair_seat', 'area_m2', 0.178779, 0.194573, 1.287),
  ('chair_seat', 'area_m2', 0.194573, 0.213879, 1.123),
  ('chair_seat', 'area_m2', 0.213879, 0.280764, 0.4127),
  ('chair_seat', 'area_m2', 0.280764, 100, 0.002106);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'aspect', 1, 1.04475, 2.58),
  ('chair_seat', 'aspect', 1.04475, 1.08995, 2.525),
  ('chair_seat', 'aspect', 1.08995, 1.12908, 2.876),
  ('chair_seat', 'aspect', 1.12908, 1.15422, 3.171),
  ('chair_seat', 'aspect', 1.15422, 1.1683, 3.235),
  ('chair_seat', 'aspect', 1.1683, 1.24711, 1.626),
  ('chair_seat', 'aspect', 1.24711, 1.33222, 1.148),
  ('chair_seat', 'aspect', 1.33222, 1.40302, 0.7412),
  ('chair_seat', 'aspect', 1.40302, 1.53767, 0.5271),
  ('chair_seat', 'aspect', 1.53767, 1.75206, 0.6109),
  ('chair_seat', 'aspect', 1.75206, 1.77481, 0.6778),
  ('chair_seat', 'aspect', 1.77481, 2.04851, 0.6034),
  ('chair_seat', 'aspect', 2.04851, 2.11663, 0.4834),
  ('chair_seat', 'aspect', 2.11663, 2.36443, 0.3396),
  ('chair_seat', 'aspect', 2.36443, 2.72906, 0.2203),
  ('chair_seat', 'aspect', 2.72906, 3.14993, 0.1385),
  ('chair_seat', 'aspect', 3.14993, 3.63571, 0.06785),
  ('chair_seat', 'aspect', 3.63571, 100, 0.003425);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'height', -0.5, 0.386359, 0.008294),
  ('chair_seat', 'height', 0.386359, 0.406899, 0.9238),
  ('chair_seat', 'height', 0.406899, 0.425562, 4.577),
  ('chair_seat', 'height', 0.425562, 0.438373, 6.817),
  ('chair_seat', 'height', 0.438373, 0.447979, 6.887),
  ('chair_seat', 'height', 0.447979, 0.458371, 7.41),
  ('chair_seat', 'height', 0.458371, 0.46852, 8.559),
  ('chair_seat', 'height', 0.46852, 0.481605, 9.599),
  ('chair_seat', 'height', 0.481605, 0.48906, 10.12),
  ('chair_seat', 'height', 0.48906, 0.503156, 10.53),
  ('chair_seat', 'height', 0.503156, 0.5096, 10),
  ('chair_seat', 'height', 0.5096, 0.530141, 5.923),
  ('chair_seat', 'height', 0.530141, 0.550681, 1.078),
  ('chair_seat', 'height', 0.550681, 0.571221, 0.2691),
  ('chair_seat', 'height', 0.571221, 4, 0.002208);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'length', 0.03, 0.260542, 0.003882),
  ('chair_seat', 'length', 0.260542, 0.296433, 0.1299),
  ('chair_seat', 'length', 0.296433, 0.337268, 0.309),
  ('chair_seat', 'length', 0.337268, 0.383728, 0.2442),
  ('chair_seat', 'length', 0.383728, 0.398368, 0.4035),
  ('chair_seat', 'length', 0.398368, 0.436588, 1.02),
  ('chair_seat', 'length', 0.436588, 0.443056, 1.787),
  ('chair_seat', 'length', 0.443056, 0.471773, 1.944),
  ('chair_seat', 'length', 0.471773, 0.482826, 3.647),
  ('chair_seat', 'length', 0.482826, 0.49673, 3.768),
  ('chair_seat', 'length', 0.49673, 0.510674, 3.595),
  ('chair_seat', 'length', 0.510674, 0.535375, 2.567),
  ('chair_seat', 'length', 0.535375, 0.565156, 1.763),
  ('chair_seat', 'length', 0.565156, 0.583392, 0.9308),
  ('chair_seat', 'length', 0.583392, 0.643009, 0.589),
  ('chair_seat', 'length', 0.643009, 0.731586, 0.1757),
  ('chair_seat', 'length', 0.731586, 0.832365, 0.1533),
  ('chair_seat', 'length', 0.832365, 30, 0.002661);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'rectangularity', 0, 0.402569, 0.02966),
  ('chair_seat', 'rectangularity', 0.402569, 0.466466, 0.381),
  ('chair_seat', 'rectangularity', 0.466466, 0.530363, 0.8869),
  ('chair_seat', 'rectangularity', 0.530363, 0.543048, 1.652),
  ('chair_seat', 'rectangularity', 0.543048, 0.59426, 1.206),
  ('chair_seat', 'rectangularity', 0.59426, 0.636803, 0.956),
  ('chair_seat', 'rectangularity', 0.636803, 0.658157, 1.655),
  ('chair_seat', 'rectangularity', 0.658157, 0.69807, 2.398),
  ('chair_seat', 'rectangularity', 0.69807, 0.722054, 1.826),
  ('chair_seat', 'rectangularity', 0.722054, 0.760048, 1.535),
  ('chair_seat', 'rectangularity', 0.760048, 0.78595, 2.025),
  ('chair_seat', 'rectangularity', 0.78595, 0.795036, 5.837),
  ('chair_seat', 'rectangularity', 0.795036, 0.823294, 3.715),
  ('chair_seat', 'rectangularity', 0.823294, 0.849847, 2.78),
  ('chair_seat', 'rectangularity', 0.849847, 0.865149, 3.439),
  ('chair_seat', 'rectangularity', 0.865149, 0.905505, 2.311),
  ('chair_seat', 'rectangularity', 0.905505, 0.913744, 2.581),
  ('chair_seat', 'rectangularity', 0.913744, 0.957796, 1.805),
  ('chair_seat', 'rectangularity', 0.957796, 0.977641, 0.786),
  ('chair_seat', 'rectangularity', 0.977641, 1, 0.1748);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_length', 0.01, 0.233894, 0.0009573),
  ('chair_seat', 'spread_length', 0.233894, 0.24264, 0.1695),
  ('chair_seat', 'spread_length', 0.24264, 0.263974, 0.1806),
  ('chair_seat', 'spread_length', 0.263974, 0.297923, 0.1671),
  ('chair_seat', 'spread_length', 0.297923, 0.336238, 0.233),
  ('chair_seat', 'spread_length', 0.336238, 0.370277, 0.4142),
  ('chair_seat', 'spread_length', 0.370277, 0.379481, 0.3743),
  ('chair_seat', 'spread_length', 0.379481, 0.428285, 0.6458),
  ('chair_seat', 'spread_length', 0.428285, 0.439511, 1.637),
  ('chair_seat', 'spread_length', 0.439511, 0.458408, 2.18),
  ('chair_seat', 'spread_length', 0.458408, 0.478447, 3.07),
  ('chair_seat', 'spread_length', 0.478447, 0.489833, 3.573),
  ('chair_seat', 'spread_length', 0.489833, 0.505579, 3.437),
  ('chair_seat', 'spread_length', 0.505579, 0.523098, 3.151),
  ('chair_seat', 'spread_length', 0.523098, 0.54553, 2.246),
  ('chair_seat', 'spread_length', 0.54553, 0.551605, 1.843),
  ('chair_seat', 'spread_length', 0.551605, 0.615689, 0.8349),
  ('chair_seat', 'spread_length', 0.615689, 0.694871, 0.1482),
  ('chair_seat', 'spread_length', 0.694871, 40, 0.002428);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_width', 0.003, 0.114074, 0.003125),
  ('chair_seat', 'spread_width', 0.114074, 0.134371, 0.2082),
  ('chair_seat', 'spread_width', 0.134371, 0.15828, 0.3411),
  ('chair_seat', 'spread_width', 0.15828, 0.161193, 0.5186),
  ('chair_seat', 'spread_width', 0.161193, 0.186444, 0.5782),
  ('chair_seat', 'spread_width', 0.186444, 0.196385, 0.4737),
  ('chair_seat', 'spread_width', 0.196385, 0.219619, 0.324),
  ('chair_seat', 'spread_width', 0.219619, 0.258696, 0.4287),
  ('chair_seat', 'spread_width', 0.258696, 0.266985, 0.5199),
  ('chair_seat', 'spread_width', 0.266985, 0.304727, 0.4908),
  ('chair_seat', 'spread_width', 0.304727, 0.328682, 0.7101),
  ('chair_seat', 'spread_width', 0.328682, 0.355457, 1.391),
  ('chair_seat', 'spread_width', 0.355457, 0.377931, 1.644),
  ('chair_seat', 'spread_width', 0.377931, 0.399484, 1.886),
  ('chair_seat', 'spread_width', 0.399484, 0.422818, 1.635),
  ('chair_seat', 'spread_width', 0.422818, 0.480258, 0.8998),
  ('chair_seat', 'spread_width', 0.480258, 0.498052, 0.2061),
  ('chair_seat', 'spread_width', 0.498052, 20, 0.002627);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'tilt_deg', 0, 0.375407, 0.429),
  ('chair_seat', 'tilt_deg', 0.375407, 0.506548, 0.6113),
  ('chair_seat', 'tilt_deg', 0.506548, 0.772857, 0.669),
  ('chair_seat', 'tilt_deg', 0.772857, 0.935459, 0.5973),
  ('chair_seat', 'tilt_deg', 0.935459, 1.07927, 0.4885),
  ('chair_seat', 'tilt_deg', 1.07927, 1.61891, 0.2835),
  ('chair_seat', 'tilt_deg', 1.61891, 1.75171, 0.2072),
  ('chair_seat', 'tilt_deg', 1.75171, 2.15855, 0.1929),
  ('chair_seat', 'tilt_deg', 2.15855, 2.50859, 0.1234),
  ('chair_seat', 'tilt_deg', 2.50859, 2.69819, 0.07654),
  ('chair_seat', 'tilt_deg', 2.69819, 3.23782, 0.05997),
  ('chair_seat', 'tilt_deg', 3.23782, 3.77746, 0.04597),
  ('chair_seat', 'tilt_deg', 3.77746, 4.3171, 0.04046),
  ('chair_seat', 'tilt_deg', 4.3171, 4.85673, 0.01912),
  ('chair_seat', 'tilt_deg', 4.85673, 90, 8.539e-05);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'width', 0.01, 0.138116, 0.004316),
  ('chair_seat', 'width', 0.138116, 0.142183, 0.1488),
  ('chair_seat', 'width', 0.142183, 0.161471, 0.2269),
  ('chair_seat', 'width', 0.161471, 0.188776, 0.3604),
  ('chair_seat', 'width', 0.188776, 0.192765, 0.4224),
  ('chair_seat', 'width', 0.192765, 0.220698, 0.4102),
  ('chair_seat', 'width', 0.220698, 0.258018, 0.362),
  ('chair_seat', 'width', 0.258018, 0.263239, 0.3835),
  ('chair_seat', 'width', 0.263239, 0.301649, 0.4163),
  ('chair_seat', 'width', 0.301649, 0.352658, 0.3934),
  ('chair_seat', 'width', 0.352658, 0.408632, 0.8324),
  ('chair_seat', 'width', 0.408632, 0.422749, 2.51),
  ('chair_seat', 'width', 0.422749, 0.439304, 2.876),
  ('chair_seat', 'width', 0.439304, 0.46271, 2.161),
  ('chair_seat', 'width', 0.46271, 0.482011, 2.162),
  ('chair_seat', 'width', 0.482011, 0.563519, 0.7657),
  ('chair_seat', 'width', 0.563519, 12, 0.004564);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_max', -0.5, 0.392973, 0.008326),
  ('chair_seat', 'z_max', 0.392973, 0.413409, 0.9874),
  ('chair_seat', 'z_max', 0.413409, 0.431497, 4.864),
  ('chair_seat', 'z_max', 0.431497, 0.441956, 7.08),
  ('chair_seat', 'z_max', 0.441956, 0.454282, 7.096),
  ('chair_seat', 'z_max', 0.454282, 0.46148, 7.625),
  ('chair_seat', 'z_max', 0.46148, 0.474719, 8.713),
  ('chair_seat', 'z_max', 0.474719, 0.484568, 9.208),
  ('chair_seat', 'z_max', 0.484568, 0.495156, 9.373),
  ('chair_seat', 'z_max', 0.495156, 0.500804, 10.12),
  ('chair_seat', 'z_max', 0.500804, 0.509315, 10.64),
  ('chair_seat', 'z_max', 0.509315, 0.515592, 10.03),
  ('chair_seat', 'z_max', 0.515592, 0.536029, 5.761),
  ('chair_seat', 'z_max', 0.536029, 0.556465, 1.038),
  ('chair_seat', 'z_max', 0.556465, 0.576902, 0.2653),
  ('chair_seat', 'z_max', 0.576902, 4, 0.002251);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_min', -0.5, 0.378421, 0.008199),
  ('chair_seat', 'z_min', 0.378421, 0.399429, 0.7241),
  ('chair_seat', 'z_min', 0.399429, 0.420437, 3.849),
  ('chair_seat', 'z_min', 0.420437, 0.435856, 6.642),
  ('chair_seat', 'z_min', 0.435856, 0.454933, 7.197),
  ('chair_seat', 'z_min', 0.454933, 0.462454, 8.358),
  ('chair_seat', 'z_min', 0.462454, 0.468179, 9.222),
  ('chair_seat', 'z_min', 0.468179, 0.477836, 9.952),
  ('chair_seat', 'z_min', 0.477836, 0.483462, 10.21),
  ('chair_seat', 'z_min', 0.483462, 0.491257, 10.27),
  ('chair_seat', 'z_min', 0.491257, 0.500115, 10.4),
  ('chair_seat', 'z_min', 0.500115, 0.507861, 9.737),
  ('chair_seat', 'z_min', 0.507861, 0.525478, 5.783),
  ('chair_seat', 'z_min', 0.525478, 0.546486, 1.184),
  ('chair_seat', 'z_min', 0.546486, 0.567495, 0.2804),
  ('chair_seat', 'z_min', 0.567495, 4, 0.002187);

-- chair_back: 131 examples
UPDATE object_class SET prior = 0.02789 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.76, 0.5767)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3771, 0.2684)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8225, 0.09478)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5505, 0.2892)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7696, 0.1425)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6907, 0.2453)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.132, 0.3798)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 81.01, 3.702)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9288, 0.3154)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.026, 0.0998)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4583, 0.1876)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'area_m2', 0.002, 0.0286125, 0.002456),
  ('chair_back', 'area_m2', 0.0286125, 0.0294245, 0.04683),
  ('chair_back', 'area_m2', 0.0294245, 0.0390585, 0.06704),
  ('chair_back', 'area_m2', 0.0390585, 0.0533181, 0.1016),
  ('chair_back', 'area_m2', 0.0533181, 0.0727837, 0.147),
  ('chair_back', 'area_m2', 0.0727837, 0.0766887, 0.1394),
  ('chair_back', 'area_m2', 0.0766887, 0.0993559, 0.1595),
  ('chair_back', 'area_m2', 0.0993559, 0.124153, 0.3183),
  ('chair_back', 'area_m2', 0.124153, 0.135629, 0.3987),
  ('chair_back', 'area_m2', 0.135629, 0.159553, 0.5201),
  ('chair_back', 'area_m2', 0.159553, 0.185145, 0.6234),
  ('chair_back', 'area_m2', 0.185145, 0.206286, 1.168),
  ('chair_back', 'area_m2', 0.206286, 0.226081, 1.125),
  ('chair_back', 'area_m2', 0.226081, 0.252739, 0.8684),
  ('chair_back', 'area_m2', 0.252739, 0.299679, 0.6824),
  ('chair_back', 'area_m2', 0.299679, 0.34501, 0.3277),
  ('chair_back', 'area_m2', 0.34501, 0.433003, 0.2429),
  ('chair_back', 'area_m2', 0.433003, 0.470967, 0.1293),
  ('chair_back', 'area_m2', 0.470967, 100, 0.001718);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'aspect', 1, 1.07853, 1.448),
  ('chair_back', 'aspect', 1.07853, 1.13068, 2.241),
  ('chair_back', 'aspect', 1.13068, 1.23997, 1.238),
  ('chair_back', 'aspect', 1.23997, 1.28991, 1.567),
  ('chair_back', 'aspect', 1.28991, 1.34104, 1.37),
  ('chair_back', 'aspect', 1.34104, 1.45677, 1.221),
  ('chair_back', 'aspect', 1.45677, 1.61016, 1.258),
  ('chair_back', 'aspect', 1.61016, 1.66387, 1.205),
  ('chair_back', 'aspect', 1.66387, 1.81684, 0.7045),
  ('chair_back', 'aspect', 1.81684, 1.88973, 0.6996),
  ('chair_back', 'aspect', 1.88973, 2.07431, 0.9684),
  ('chair_back', 'aspect', 2.07431, 2.14625, 0.723),
  ('chair_back', 'aspect', 2.14625, 2.43758, 0.3321),
  ('chair_back', 'aspect', 2.43758, 2.76847, 0.1404),
  ('chair_back', 'aspect', 2.76847, 3.14427, 0.1016),
  ('chair_back', 'aspect', 3.14427, 100, 0.003281);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'height', -0.5, 0.597148, 0.009996),
  ('chair_back', 'height', 0.597148, 0.649282, 0.4329),
  ('chair_back', 'height', 0.649282, 0.701416, 1.41),
  ('chair_back', 'height', 0.701416, 0.708077, 1.81),
  ('chair_back', 'height', 0.708077, 0.75355, 2.611),
  ('chair_back', 'height', 0.75355, 0.782043, 3.513),
  ('chair_back', 'height', 0.782043, 0.805683, 3.932),
  ('chair_back', 'height', 0.805683, 0.827524, 5.275),
  ('chair_back', 'height', 0.827524, 0.857817, 3.376),
  ('chair_back', 'height', 0.857817, 0.898913, 3.228),
  ('chair_back', 'height', 0.898913, 0.909951, 3.057),
  ('chair_back', 'height', 0.909951, 0.94145, 2.358),
  ('chair_back', 'height', 0.94145, 0.962085, 1.867),
  ('chair_back', 'height', 0.962085, 1.01422, 0.858),
  ('chair_back', 'height', 1.01422, 1.06635, 0.3704),
  ('chair_back', 'height', 1.06635, 4, 0.002858);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'length', 0.03, 0.239152, 0.004662),
  ('chair_back', 'length', 0.239152, 0.286386, 0.06537),
  ('chair_back', 'length', 0.286386, 0.34295, 0.1491),
  ('chair_back', 'length', 0.34295, 0.410686, 0.2071),
  ('chair_back', 'length', 0.410686, 0.434547, 0.6154),
  ('chair_back', 'length', 0.434547, 0.48616, 1.012),
  ('chair_back', 'length', 0.48616, 0.512897, 1.864),
  ('chair_back', 'length', 0.512897, 0.542087, 1.909),
  ('chair_back', 'length', 0.542087, 0.588935, 1.118),
  ('chair_back', 'length', 0.588935, 0.605604, 0.9808),
  ('chair_back', 'length', 0.605604, 0.643415, 1.644),
  ('chair_back', 'length', 0.643415, 0.705254, 1.089),
  ('chair_back', 'length', 0.705254, 0.771597, 1.364),
  ('chair_back', 'length', 0.771597, 0.844548, 0.4797),
  ('chair_back', 'length', 0.844548, 1.01135, 0.1835),
  ('chair_back', 'length', 1.01135, 1.21111, 0.1567),
  ('chair_back', 'length', 1.21111, 30, 0.004253);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'rectangularity', 0, 0.399598, 0.02801),
  ('chair_back', 'rectangularity', 0.399598, 0.466309, 0.3037),
  ('chair_back', 'rectangularity', 0.466309, 0.533021, 0.5916),
  ('chair_back', 'rectangularity', 0.533021, 0.565456, 1.331),
  ('chair_back', 'rectangularity', 0.565456, 0.599732, 1.243),
  ('chair_back', 'rectangularity', 0.599732, 0.666065, 1.063),
  ('chair_back', 'rectangularity', 0.666065, 0.728048, 1.859),
  ('chair_back', 'rectangularity', 0.728048, 0.773708, 2.342),
  ('chair_back', 'rectangularity', 0.773708, 0.799866, 2.669),
  ('chair_back', 'rectangularity', 0.799866, 0.823863, 2.202),
  ('chair_back', 'rectangularity', 0.823863, 0.860647, 2.718),
  ('chair_back', 'rectangularity', 0.860647, 0.885282, 4.139),
  ('chair_back', 'rectangularity', 0.885282, 0.925127, 2.701),
  ('chair_back', 'rectangularity', 0.925127, 0.933289, 2.672),
  ('chair_back', 'rectangularity', 0.933289, 0.98555, 1.582),
  ('chair_back', 'rectangularity', 0.98555, 1, 0.9667);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_length', 0.01, 0.226465, 0.002629),
  ('chair_back', 'spread_length', 0.226465, 0.265162, 0.1191),
  ('chair_back', 'spread_length', 0.265162, 0.310471, 0.1525),
  ('chair_back', 'spread_length', 0.310471, 0.363523, 0.261),
  ('chair_back', 'spread_length', 0.363523, 0.40828, 0.2408),
  ('chair_back', 'spread_length', 0.40828, 0.42564, 0.836),
  ('chair_back', 'spread_length', 0.42564, 0.449051, 1.533),
  ('chair_back', 'spread_length', 0.449051, 0.467886, 2.447),
  ('chair_back', 'spread_length', 0.467886, 0.492545, 2.394),
  ('chair_back', 'spread_length', 0.492545, 0.498371, 2.391),
  ('chair_back', 'spread_length', 0.498371, 0.510735, 2.354),
  ('chair_back', 'spread_length', 0.510735, 0.542083, 1.84),
  ('chair_back', 'spread_length', 0.542083, 0.58353, 1.426),
  ('chair_back', 'spread_length', 0.58353, 0.637234, 1.287),
  ('chair_back', 'spread_length', 0.637234, 0.68324, 0.6012),
  ('chair_back', 'spread_length', 0.68324, 0.799988, 0.3265),
  ('chair_back', 'spread_length', 0.799988, 0.924139, 0.1634),
  ('chair_back', 'spread_length', 0.924139, 0.936685, 0.1385),
  ('chair_back', 'spread_length', 0.936685, 40, 0.001823);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_width', 0.003, 0.117052, 0.003306),
  ('chair_back', 'spread_width', 0.117052, 0.119809, 0.1267),
  ('chair_back', 'spread_width', 0.119809, 0.139308, 0.1707),
  ('chair_back', 'spread_width', 0.139308, 0.165796, 0.215),
  ('chair_back', 'spread_width', 0.165796, 0.185676, 0.2692),
  ('chair_back', 'spread_width', 0.185676, 0.197321, 0.2921),
  ('chair_back', 'spread_width', 0.197321, 0.23484, 0.3204),
  ('chair_back', 'spread_width', 0.23484, 0.248945, 0.688),
  ('chair_back', 'spread_width', 0.248945, 0.279492, 0.8934),
  ('chair_back', 'spread_width', 0.279492, 0.285999, 0.5708),
  ('chair_back', 'spread_width', 0.285999, 0.332276, 0.697),
  ('chair_back', 'spread_width', 0.332276, 0.376596, 0.9207),
  ('chair_back', 'spread_width', 0.376596, 0.395882, 1.393),
  ('chair_back', 'spread_width', 0.395882, 0.405613, 1.406),
  ('chair_back', 'spread_width', 0.405613, 0.439518, 1.376),
  ('chair_back', 'spread_width', 0.439518, 0.471156, 1.227),
  ('chair_back', 'spread_width', 0.471156, 0.560742, 0.7499),
  ('chair_back', 'spread_width', 0.560742, 20, 0.003167);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'tilt_deg', 0, 73.0684, 0.0001462),
  ('chair_back', 'tilt_deg', 73.0684, 74.818, 0.02006),
  ('chair_back', 'tilt_deg', 74.818, 76.2561, 0.04615),
  ('chair_back', 'tilt_deg', 76.2561, 76.5676, 0.06879),
  ('chair_back', 'tilt_deg', 76.5676, 77.7567, 0.07114),
  ('chair_back', 'tilt_deg', 77.7567, 78.3171, 0.09748),
  ('chair_back', 'tilt_deg', 78.3171, 79.0837, 0.07917),
  ('chair_back', 'tilt_deg', 79.0837, 80.0667, 0.08633),
  ('chair_back', 'tilt_deg', 80.0667, 80.3192, 0.08093),
  ('chair_back', 'tilt_deg', 80.3192, 81.7598, 0.08688),
  ('chair_back', 'tilt_deg', 81.7598, 83.1813, 0.07259),
  ('chair_back', 'tilt_deg', 83.1813, 83.5658, 0.09884),
  ('chair_back', 'tilt_deg', 83.5658, 84.3742, 0.09194),
  ('chair_back', 'tilt_deg', 84.3742, 85.3154, 0.09119),
  ('chair_back', 'tilt_deg', 85.3154, 85.6902, 0.07057),
  ('chair_back', 'tilt_deg', 85.6902, 87.065, 0.05062),
  ('chair_back', 'tilt_deg', 87.065, 88.8145, 0.01704),
  ('chair_back', 'tilt_deg', 88.8145, 90, 0.007495);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'width', 0.01, 0.1535, 0.003552),
  ('chair_back', 'width', 0.1535, 0.184384, 0.1306),
  ('chair_back', 'width', 0.184384, 0.221482, 0.239),
  ('chair_back', 'width', 0.221482, 0.259319, 0.2327),
  ('chair_back', 'width', 0.259319, 0.266044, 0.3218),
  ('chair_back', 'width', 0.266044, 0.319572, 0.4894),
  ('chair_back', 'width', 0.319572, 0.33009, 0.5866),
  ('chair_back', 'width', 0.33009, 0.383869, 0.6271),
  ('chair_back', 'width', 0.383869, 0.392652, 0.9107),
  ('chair_back', 'width', 0.392652, 0.424012, 1.524),
  ('chair_back', 'width', 0.424012, 0.441845, 2.523),
  ('chair_back', 'width', 0.441845, 0.461103, 2.237),
  ('chair_back', 'width', 0.461103, 0.477592, 2.837),
  ('chair_back', 'width', 0.477592, 0.520262, 1.358),
  ('chair_back', 'width', 0.520262, 0.553876, 0.8604),
  ('chair_back', 'width', 0.553876, 0.665316, 0.2146),
  ('chair_back', 'width', 0.665316, 0.799176, 0.09538),
  ('chair_back', 'width', 0.799176, 12, 0.003907);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_max', -0.5, 0.771676, 0.0107),
  ('chair_back', 'z_max', 0.771676, 0.821894, 0.5041),
  ('chair_back', 'z_max', 0.821894, 0.872113, 0.8539),
  ('chair_back', 'z_max', 0.872113, 0.895642, 1.058),
  ('chair_back', 'z_max', 0.895642, 0.922331, 1.356),
  ('chair_back', 'z_max', 0.922331, 0.957691, 2.545),
  ('chair_back', 'z_max', 0.957691, 0.972549, 3.272),
  ('chair_back', 'z_max', 0.972549, 0.989669, 3.633),
  ('chair_back', 'z_max', 0.989669, 1.01307, 4.076),
  ('chair_back', 'z_max', 1.01307, 1.02277, 3.494),
  ('chair_back', 'z_max', 1.02277, 1.04847, 3.432),
  ('chair_back', 'z_max', 1.04847, 1.07299, 3.804),
  ('chair_back', 'z_max', 1.07299, 1.10406, 3.908),
  ('chair_back', 'z_max', 1.10406, 1.1232, 2.593),
  ('chair_back', 'z_max', 1.1232, 1.15328, 2.043),
  ('chair_back', 'z_max', 1.15328, 1.17342, 2.41),
  ('chair_back', 'z_max', 1.17342, 1.21921, 1.204),
  ('chair_back', 'z_max', 1.21921, 4, 0.003371);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_min', -0.5, -0.0704876, 0.0403),
  ('chair_back', 'z_min', -0.0704876, 0.032046, 0.3445),
  ('chair_back', 'z_min', 0.032046, 0.13458, 0.1499),
  ('chair_back', 'z_min', 0.13458, 0.237113, 0.1642),
  ('chair_back', 'z_min', 0.237113, 0.301568, 0.6054),
  ('chair_back', 'z_min', 0.301568, 0.339647, 1.682),
  ('chair_back', 'z_min', 0.339647, 0.363038, 1.846),
  ('chair_back', 'z_min', 0.363038, 0.402835, 2.832),
  ('chair_back', 'z_min', 0.402835, 0.423772, 4.32),
  ('chair_back', 'z_min', 0.423772, 0.442181, 2.593),
  ('chair_back', 'z_min', 0.442181, 0.479013, 1.881),
  ('chair_back', 'z_min', 0.479013, 0.539325, 1.94),
  ('chair_back', 'z_min', 0.539325, 0.601363, 1.599),
  ('chair_back', 'z_min', 0.601363, 0.647248, 2.004),
  ('chair_back', 'z_min', 0.647248, 0.655699, 2.072),
  ('chair_back', 'z_min', 0.655699, 0.749782, 0.7786),
  ('chair_back', 'z_min', 0.749782, 0.852315, 0.3699),
  ('chair_back', 'z_min', 0.852315, 4, 0.003785);

-- door: 61 examples
UPDATE object_class SET prior = 0.01296 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.2905, 0.5534)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.777, 0.2401)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.139, 0.1898)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.6304, 0.2532)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8411, 0.1047)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4745, 0.2652)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.2671, 0.3636)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.82, 0.6026)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1604, 0.336)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.045, 0.2628)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1318, 0.2879)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'door' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'area_m2', 0.002, 0.120331, 0.003344),
  ('door', 'area_m2', 0.120331, 0.166998, 0.001692),
  ('door', 'area_m2', 0.166998, 0.231764, 0.03925),
  ('door', 'area_m2', 0.231764, 0.321648, 0.01847),
  ('door', 'area_m2', 0.321648, 0.446392, 0.1046),
  ('door', 'area_m2', 0.446392, 0.619515, 0.04523),
  ('door', 'area_m2', 0.619515, 0.85591, 0.1589),
  ('door', 'area_m2', 0.85591, 1.19322, 0.283),
  ('door', 'area_m2', 1.19322, 1.24903, 0.6193),
  ('door', 'area_m2', 1.24903, 1.39846, 0.9615),
  ('door', 'area_m2', 1.39846, 1.55054, 0.9698),
  ('door', 'area_m2', 1.55054, 1.65599, 1.627),
  ('door', 'area_m2', 1.65599, 1.74349, 1.978),
  ('door', 'area_m2', 1.74349, 1.80755, 2.177),
  ('door', 'area_m2', 1.80755, 1.92929, 1.612),
  ('door', 'area_m2', 1.92929, 2.19967, 0.7649),
  ('door', 'area_m2', 2.19967, 2.29822, 0.2324),
  ('door', 'area_m2', 2.29822, 100, 0.008547);
DELETE FROM class_density WHERE class = 'door' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'aspect', 1, 1.19176, 0.05623),
  ('door', 'aspect', 1.19176, 1.23604, 0.2148),
  ('door', 'aspect', 1.23604, 1.4048, 0.2979),
  ('door', 'aspect', 1.4048, 1.65592, 0.3063),
  ('door', 'aspect', 1.65592, 1.72278, 0.4891),
  ('door', 'aspect', 1.72278, 1.86052, 1.281),
  ('door', 'aspect', 1.86052, 1.95194, 1.186),
  ('door', 'aspect', 1.95194, 2.05435, 1.375),
  ('door', 'aspect', 2.05435, 2.19873, 1.528),
  ('door', 'aspect', 2.19873, 2.288, 2.585),
  ('door', 'aspect', 2.288, 2.36323, 3.034),
  ('door', 'aspect', 2.36323, 2.44117, 3.133),
  ('door', 'aspect', 2.44117, 2.64814, 1.356),
  ('door', 'aspect', 2.64814, 2.71217, 0.7748),
  ('door', 'aspect', 2.71217, 3.197, 0.4358),
  ('door', 'aspect', 3.197, 3.7685, 0.09522),
  ('door', 'aspect', 3.7685, 4.44216, 0.06933),
  ('door', 'aspect', 4.44216, 5.23625, 0.005548),
  ('door', 'aspect', 5.23625, 100, 0.004651);
DELETE FROM class_density WHERE class = 'door' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'height', -0.5, 0.465227, 0.01395),
  ('door', 'height', 0.465227, 0.59974, 0.05828),
  ('door', 'height', 0.59974, 0.734253, 0.1112),
  ('door', 'height', 0.734253, 0.868765, 0.2233),
  ('door', 'height', 0.868765, 1.00328, 0.3578),
  ('door', 'height', 1.00328, 1.02405, 1.573),
  ('door', 'height', 1.02405, 1.05363, 3.866),
  ('door', 'height', 1.05363, 1.06665, 5.773),
  ('door', 'height', 1.06665, 1.09959, 3.325),
  ('door', 'height', 1.09959, 1.13558, 2.856),
  ('door', 'height', 1.13558, 1.20022, 1.6),
  ('door', 'height', 1.20022, 1.2723, 1.56),
  ('door', 'height', 1.2723, 1.28355, 1.681),
  ('door', 'height', 1.28355, 1.3481, 1.566),
  ('door', 'height', 1.3481, 1.40682, 1.013),
  ('door', 'height', 1.40682, 1.54133, 0.2372),
  ('door', 'height', 1.54133, 1.67584, 0.0743),
  ('door', 'height', 1.67584, 4, 0.005937);
DELETE FROM class_density WHERE class = 'door' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'length', 0.03, 0.626687, 0.004508),
  ('door', 'length', 0.626687, 0.729244, 0.0001595),
  ('door', 'length', 0.729244, 0.848583, 0.02029),
  ('door', 'length', 0.848583, 0.987452, 0.1054),
  ('door', 'length', 0.987452, 1.14905, 0.2222),
  ('door', 'length', 1.14905, 1.33709, 0.1185),
  ('door', 'length', 1.33709, 1.47097, 0.4156),
  ('door', 'length', 1.47097, 1.5559, 0.8447),
  ('door', 'length', 1.5559, 1.68357, 0.9561),
  ('door', 'length', 1.68357, 1.81052, 0.7507),
  ('door', 'length', 1.81052, 2.00351, 1.042),
  ('door', 'length', 2.00351, 2.03729, 4.758),
  ('door', 'length', 2.03729, 2.06764, 5.659),
  ('door', 'length', 2.06764, 2.1019, 5.117),
  ('door', 'length', 2.1019, 2.1945, 2.6),
  ('door', 'length', 2.1945, 2.29776, 2.307),
  ('door', 'length', 2.29776, 2.40623, 1.989),
  ('door', 'length', 2.40623, 2.45158, 0.477),
  ('door', 'length', 2.45158, 30, 0.01073);
DELETE FROM class_density WHERE class = 'door' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'rectangularity', 0, 0.54556, 0.02503),
  ('door', 'rectangularity', 0.54556, 0.594893, 0.3504),
  ('door', 'rectangularity', 0.594893, 0.644227, 0.6212),
  ('door', 'rectangularity', 0.644227, 0.69356, 0.5853),
  ('door', 'rectangularity', 0.69356, 0.732524, 1.126),
  ('door', 'rectangularity', 0.732524, 0.742894, 2.579),
  ('door', 'rectangularity', 0.742894, 0.766071, 2.643),
  ('door', 'rectangularity', 0.766071, 0.792227, 3.47),
  ('door', 'rectangularity', 0.792227, 0.797298, 4.541),
  ('door', 'rectangularity', 0.797298, 0.84156, 2.399),
  ('door', 'rectangularity', 0.84156, 0.850099, 1.929),
  ('door', 'rectangularity', 0.850099, 0.881016, 3.527),
  ('door', 'rectangularity', 0.881016, 0.890894, 8.851),
  ('door', 'rectangularity', 0.890894, 0.929755, 2.923),
  ('door', 'rectangularity', 0.929755, 0.940227, 2.064),
  ('door', 'rectangularity', 0.940227, 0.963092, 4.575),
  ('door', 'rectangularity', 0.963092, 0.976188, 6.72),
  ('door', 'rectangularity', 0.976188, 0.989561, 0.9364),
  ('door', 'rectangularity', 0.989561, 1, 0.4241);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_length', 0.01, 0.628878, 0.003316),
  ('door', 'spread_length', 0.628878, 0.720071, 0.001621),
  ('door', 'spread_length', 0.720071, 0.824488, 0.0271),
  ('door', 'spread_length', 0.824488, 0.944046, 0.2179),
  ('door', 'spread_length', 0.944046, 1.08094, 0.4621),
  ('door', 'spread_length', 1.08094, 1.23769, 0.4656),
  ('door', 'spread_length', 1.23769, 1.38781, 0.6535),
  ('door', 'spread_length', 1.38781, 1.41716, 0.8328),
  ('door', 'spread_length', 1.41716, 1.60794, 0.9134),
  ('door', 'spread_length', 1.60794, 1.66191, 2.093),
  ('door', 'spread_length', 1.66191, 1.85789, 1.196),
  ('door', 'spread_length', 1.85789, 1.96329, 2.461),
  ('door', 'spread_length', 1.96329, 1.99589, 4.69),
  ('door', 'spread_length', 1.99589, 2.0175, 5.024),
  ('door', 'spread_length', 2.0175, 2.04098, 4.445),
  ('door', 'spread_length', 2.04098, 2.12739, 1.762),
  ('door', 'spread_length', 2.12739, 40, 0.008746);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_width', 0.003, 0.175299, 0.001472),
  ('door', 'spread_width', 0.175299, 0.180444, 0.1785),
  ('door', 'spread_width', 0.180444, 0.218556, 0.08496),
  ('door', 'spread_width', 0.218556, 0.272487, 0.00153),
  ('door', 'spread_width', 0.272487, 0.339726, 0.09014),
  ('door', 'spread_width', 0.339726, 0.423558, 0.1048),
  ('door', 'spread_width', 0.423558, 0.528075, 0.189),
  ('door', 'spread_width', 0.528075, 0.565153, 0.3063),
  ('door', 'spread_width', 0.565153, 0.658384, 0.3944),
  ('door', 'spread_width', 0.658384, 0.761263, 0.5634),
  ('door', 'spread_width', 0.761263, 0.80979, 2.046),
  ('door', 'spread_width', 0.80979, 0.819678, 3.658),
  ('door', 'spread_width', 0.819678, 0.850863, 3.113),
  ('door', 'spread_width', 0.850863, 0.885872, 2.38),
  ('door', 'spread_width', 0.885872, 0.933473, 2.274),
  ('door', 'spread_width', 0.933473, 0.953532, 2.793),
  ('door', 'spread_width', 0.953532, 1.0234, 1.053),
  ('door', 'spread_width', 1.0234, 1.27594, 0.3002),
  ('door', 'spread_width', 1.27594, 20, 0.00822);
DELETE FROM class_density WHERE class = 'door' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'tilt_deg', 0, 87.0303, 9.68e-06),
  ('door', 'tilt_deg', 87.0303, 87.3602, 0.03324),
  ('door', 'tilt_deg', 87.3602, 87.4734, 0.07351),
  ('door', 'tilt_deg', 87.4734, 87.6902, 0.07968),
  ('door', 'tilt_deg', 87.6902, 88.0202, 0.04505),
  ('door', 'tilt_deg', 88.0202, 88.3501, 0.0116),
  ('door', 'tilt_deg', 88.3501, 88.6801, 0.01391),
  ('door', 'tilt_deg', 88.6801, 89.0101, 0.03998),
  ('door', 'tilt_deg', 89.0101, 89.3401, 0.1006),
  ('door', 'tilt_deg', 89.3401, 89.67, 0.5042),
  ('door', 'tilt_deg', 89.67, 90, 2.202);
DELETE FROM class_density WHERE class = 'door' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'width', 0.01, 0.209186, 0.003201),
  ('door', 'width', 0.209186, 0.257181, 0.08552),
  ('door', 'width', 0.257181, 0.316188, 0.001462),
  ('door', 'width', 0.316188, 0.388733, 0.1254),
  ('door', 'width', 0.388733, 0.477922, 0.04087),
  ('door', 'width', 0.477922, 0.587574, 0.1429),
  ('door', 'width', 0.587574, 0.722385, 0.2791),
  ('door', 'width', 0.722385, 0.82731, 0.8289),
  ('door', 'width', 0.82731, 0.867632, 2.252),
  ('door', 'width', 0.867632, 0.888126, 3.086),
  ('door', 'width', 0.888126, 0.918094, 3.327),
  ('door', 'width', 0.918094, 0.958226, 2.269),
  ('door', 'width', 0.958226, 0.992908, 2.88),
  ('door', 'width', 0.992908, 1.09189, 1.215),
  ('door', 'width', 1.09189, 1.34241, 0.5195),
  ('door', 'width', 1.34241, 12, 0.01207);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_max', -0.5, 0.865008, 0.01004),
  ('door', 'z_max', 0.865008, 1.03021, 0.002591),
  ('door', 'z_max', 1.03021, 1.19541, 0.07657),
  ('door', 'z_max', 1.19541, 1.36061, 0.01988),
  ('door', 'z_max', 1.36061, 1.52582, 0.1769),
  ('door', 'z_max', 1.52582, 1.69102, 0.1446),
  ('door', 'z_max', 1.69102, 1.85622, 0.2554),
  ('door', 'z_max', 1.85622, 1.91636, 0.3812),
  ('door', 'z_max', 1.91636, 2.01807, 1.278),
  ('door', 'z_max', 2.01807, 2.04233, 4.333),
  ('door', 'z_max', 2.04233, 2.05262, 4.548),
  ('door', 'z_max', 2.05262, 2.09055, 3.356),
  ('door', 'z_max', 2.09055, 2.12365, 2.863),
  ('door', 'z_max', 2.12365, 2.18662, 1.4),
  ('door', 'z_max', 2.18662, 2.19663, 1.067),
  ('door', 'z_max', 2.19663, 2.2838, 1.501),
  ('door', 'z_max', 2.2838, 2.33395, 1.698),
  ('door', 'z_max', 2.33395, 2.35182, 0.5028),
  ('door', 'z_max', 2.35182, 4, 0.01454);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_min', -0.5, -0.0619063, 0.1215),
  ('door', 'z_min', -0.0619063, -0.00778561, 3.654),
  ('door', 'z_min', -0.00778561, 0.00229286, 18.32),
  ('door', 'z_min', 0.00229286, 0.0825846, 3.479),
  ('door', 'z_min', 0.0825846, 0.123081, 0.2265),
  ('door', 'z_min', 0.123081, 0.227076, 0.4859),
  ('door', 'z_min', 0.227076, 0.371567, 0.3089),
  ('door', 'z_min', 0.371567, 0.513773, 0.4796),
  ('door', 'z_min', 0.513773, 0.660548, 0.3758),
  ('door', 'z_min', 0.660548, 0.805039, 0.1021),
  ('door', 'z_min', 0.805039, 0.94953, 0.008495),
  ('door', 'z_min', 0.94953, 1.09402, 0.1323),
  ('door', 'z_min', 1.09402, 1.23851, 0.05972),
  ('door', 'z_min', 1.23851, 4, 0.004964);

-- window: 109 examples
UPDATE object_class SET prior = 0.02312 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', -0.01385, 0.6092)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.3436, 0.3308)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.529, 0.1592)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.2649, 0.2231)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8459, 0.1483)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.2964, 0.2639)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.1283, 0.443)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.65, 0.5546)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.07741, 0.3678)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.12, 0.1969)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 0.9729, 0.185)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'window' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'area_m2', 0.002, 0.12792, 0.00197),
  ('window', 'area_m2', 0.12792, 0.186891, 0.06235),
  ('window', 'area_m2', 0.186891, 0.273048, 0.02832),
  ('window', 'area_m2', 0.273048, 0.398924, 0.1286),
  ('window', 'area_m2', 0.398924, 0.451694, 0.1901),
  ('window', 'area_m2', 0.451694, 0.582828, 0.1695),
  ('window', 'area_m2', 0.582828, 0.770535, 0.2558),
  ('window', 'area_m2', 0.770535, 0.851511, 0.5148),
  ('window', 'area_m2', 0.851511, 0.931132, 0.7303),
  ('window', 'area_m2', 0.931132, 1.02679, 1.172),
  ('window', 'area_m2', 1.02679, 1.14155, 0.8998),
  ('window', 'area_m2', 1.14155, 1.24406, 0.6689),
  ('window', 'area_m2', 1.24406, 1.34641, 0.7178),
  ('window', 'area_m2', 1.34641, 1.53945, 0.8448),
  ('window', 'area_m2', 1.53945, 1.68273, 0.9951),
  ('window', 'area_m2', 1.68273, 1.81757, 0.4704),
  ('window', 'area_m2', 1.81757, 2.65547, 0.1844),
  ('window', 'area_m2', 2.65547, 3.87964, 0.02553),
  ('window', 'area_m2', 3.87964, 100, 0.003676);
DELETE FROM class_density WHERE class = 'window' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'aspect', 1, 1.05524, 2.164),
  ('window', 'aspect', 1.05524, 1.09998, 2.466),
  ('window', 'aspect', 1.09998, 1.13208, 3.201),
  ('window', 'aspect', 1.13208, 1.18383, 1.594),
  ('window', 'aspect', 1.18383, 1.24532, 1.146),
  ('window', 'aspect', 1.24532, 1.32487, 1.428),
  ('window', 'aspect', 1.32487, 1.40145, 1.854),
  ('window', 'aspect', 1.40145, 1.41517, 1.946),
  ('window', 'aspect', 1.41517, 1.65907, 0.7558),
  ('window', 'aspect', 1.65907, 1.6774, 0.465),
  ('window', 'aspect', 1.6774, 1.96405, 0.4199),
  ('window', 'aspect', 1.96405, 2.15817, 0.3801),
  ('window', 'aspect', 2.15817, 2.3251, 0.3257),
  ('window', 'aspect', 2.3251, 2.75252, 0.2611),
  ('window', 'aspect', 2.75252, 3.25851, 0.1473),
  ('window', 'aspect', 3.25851, 3.85751, 0.03138),
  ('window', 'aspect', 3.85751, 4.52271, 0.0849),
  ('window', 'aspect', 4.52271, 4.56662, 0.09528),
  ('window', 'aspect', 4.56662, 100, 0.002614);
DELETE FROM class_density WHERE class = 'window' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'height', -0.5, 1.08706, 0.007249),
  ('window', 'height', 1.08706, 1.18895, 0.1721),
  ('window', 'height', 1.18895, 1.29083, 0.2847),
  ('window', 'height', 1.29083, 1.37781, 0.6499),
  ('window', 'height', 1.37781, 1.39272, 1.393),
  ('window', 'height', 1.39272, 1.42717, 2.76),
  ('window', 'height', 1.42717, 1.45988, 3.519),
  ('window', 'height', 1.45988, 1.49459, 3.07),
  ('window', 'height', 1.49459, 1.53588, 2.422),
  ('window', 'height', 1.53588, 1.58688, 1.951),
  ('window', 'height', 1.58688, 1.59649, 2.053),
  ('window', 'height', 1.59649, 1.6344, 2.385),
  ('window', 'height', 1.6344, 1.69838, 1.626),
  ('window', 'height', 1.69838, 1.72028, 1.11),
  ('window', 'height', 1.72028, 1.80026, 0.8387),
  ('window', 'height', 1.80026, 1.90215, 0.1949),
  ('window', 'height', 1.90215, 2.00403, 0.1462),
  ('window', 'height', 2.00403, 4, 0.004058);
DELETE FROM class_density WHERE class = 'window' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'length', 0.03, 0.673273, 0.003659),
  ('window', 'length', 0.673273, 0.811383, 0.06765),
  ('window', 'length', 0.811383, 0.977823, 0.2168),
  ('window', 'length', 0.977823, 1.04338, 0.7207),
  ('window', 'length', 1.04338, 1.12243, 1.471),
  ('window', 'length', 1.12243, 1.1784, 1.564),
  ('window', 'length', 1.1784, 1.19421, 2.208),
  ('window', 'length', 1.19421, 1.27034, 1.856),
  ('window', 'length', 1.27034, 1.33707, 2.039),
  ('window', 'length', 1.33707, 1.40885, 2.106),
  ('window', 'length', 1.40885, 1.48809, 1.995),
  ('window', 'length', 1.48809, 1.61497, 1.599),
  ('window', 'length', 1.61497, 1.71145, 1.344),
  ('window', 'length', 1.71145, 2.06252, 0.05396),
  ('window', 'length', 2.06252, 2.4856, 0.009528),
  ('window', 'length', 2.4856, 2.99548, 0.0009818),
  ('window', 'length', 2.99548, 3.60995, 0.02664),
  ('window', 'length', 3.60995, 30, 0.005461);
DELETE FROM class_density WHERE class = 'window' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'rectangularity', 0, 0.209119, 0.05124),
  ('window', 'rectangularity', 0.209119, 0.296901, 0.06712),
  ('window', 'rectangularity', 0.296901, 0.384682, 0.05639),
  ('window', 'rectangularity', 0.384682, 0.472464, 0.06409),
  ('window', 'rectangularity', 0.472464, 0.560246, 0.1941),
  ('window', 'rectangularity', 0.560246, 0.648028, 0.4695),
  ('window', 'rectangularity', 0.648028, 0.676139, 1.052),
  ('window', 'rectangularity', 0.676139, 0.735809, 1.199),
  ('window', 'rectangularity', 0.735809, 0.769121, 1.395),
  ('window', 'rectangularity', 0.769121, 0.823591, 1.682),
  ('window', 'rectangularity', 0.823591, 0.836917, 2.494),
  ('window', 'rectangularity', 0.836917, 0.86527, 3.626),
  ('window', 'rectangularity', 0.86527, 0.90623, 2.76),
  ('window', 'rectangularity', 0.90623, 0.911373, 3.278),
  ('window', 'rectangularity', 0.911373, 0.942949, 2.524),
  ('window', 'rectangularity', 0.942949, 0.964951, 5.558),
  ('window', 'rectangularity', 0.964951, 0.971921, 13.96),
  ('window', 'rectangularity', 0.971921, 0.984167, 8.126),
  ('window', 'rectangularity', 0.984167, 1, 0.6715);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_length', 0.01, 0.483694, 0.00262),
  ('window', 'spread_length', 0.483694, 0.588177, 0.03424),
  ('window', 'spread_length', 0.588177, 0.715229, 0.05409),
  ('window', 'spread_length', 0.715229, 0.869725, 0.1624),
  ('window', 'spread_length', 0.869725, 1.05307, 0.3373),
  ('window', 'spread_length', 1.05307, 1.16922, 1.079),
  ('window', 'spread_length', 1.16922, 1.25521, 1.475),
  ('window', 'spread_length', 1.25521, 1.28604, 1.244),
  ('window', 'spread_length', 1.28604, 1.32917, 2.075),
  ('window', 'spread_length', 1.32917, 1.44462, 1.46),
  ('window', 'spread_length', 1.44462, 1.52705, 1.897),
  ('window', 'spread_length', 1.52705, 1.56384, 2.203),
  ('window', 'spread_length', 1.56384, 1.61296, 1.857),
  ('window', 'spread_length', 1.61296, 1.72013, 1.706),
  ('window', 'spread_length', 1.72013, 1.90165, 0.7003),
  ('window', 'spread_length', 1.90165, 2.31242, 0.1256),
  ('window', 'spread_length', 2.31242, 2.81193, 0.03465),
  ('window', 'spread_length', 2.81193, 40, 0.0045);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_width', 0.003, 0.203042, 0.002772),
  ('window', 'spread_width', 0.203042, 0.255767, 0.05876),
  ('window', 'spread_width', 0.255767, 0.322183, 0.06366),
  ('window', 'spread_width', 0.322183, 0.405845, 0.1843),
  ('window', 'spread_width', 0.405845, 0.421143, 0.2418),
  ('window', 'spread_width', 0.421143, 0.511233, 0.2051),
  ('window', 'spread_width', 0.511233, 0.643988, 0.2745),
  ('window', 'spread_width', 0.643988, 0.706996, 0.397),
  ('window', 'spread_width', 0.706996, 0.811215, 0.4416),
  ('window', 'spread_width', 0.811215, 0.896285, 0.7252),
  ('window', 'spread_width', 0.896285, 0.984475, 1.14),
  ('window', 'spread_width', 0.984475, 1.02187, 1.757),
  ('window', 'spread_width', 1.02187, 1.0393, 1.5),
  ('window', 'spread_width', 1.0393, 1.11672, 1.408),
  ('window', 'spread_width', 1.11672, 1.19274, 1.668),
  ('window', 'spread_width', 1.19274, 1.28722, 1.143),
  ('window', 'spread_width', 1.28722, 1.32144, 0.9263),
  ('window', 'spread_width', 1.32144, 1.62148, 0.4782),
  ('window', 'spread_width', 1.62148, 20, 0.006821);
DELETE FROM class_density WHERE class = 'window' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'tilt_deg', 0, 87.2493, 8.396e-05),
  ('window', 'tilt_deg', 87.2493, 87.555, 0.01327),
  ('window', 'tilt_deg', 87.555, 87.8606, 0.03011),
  ('window', 'tilt_deg', 87.8606, 88.1662, 0.05106),
  ('window', 'tilt_deg', 88.1662, 88.4719, 0.09231),
  ('window', 'tilt_deg', 88.4719, 88.7775, 0.1398),
  ('window', 'tilt_deg', 88.7775, 89.0831, 0.1542),
  ('window', 'tilt_deg', 89.0831, 89.3887, 0.1983),
  ('window', 'tilt_deg', 89.3887, 89.6484, 0.5939),
  ('window', 'tilt_deg', 89.6484, 89.7991, 1.38),
  ('window', 'tilt_deg', 89.7991, 90, 2.106);
DELETE FROM class_density WHERE class = 'window' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'width', 0.01, 0.276666, 0.003409),
  ('window', 'width', 0.276666, 0.334008, 0.0888),
  ('window', 'width', 0.334008, 0.403235, 0.135),
  ('window', 'width', 0.403235, 0.486811, 0.1436),
  ('window', 'width', 0.486811, 0.587708, 0.2237),
  ('window', 'width', 0.587708, 0.709518, 0.3861),
  ('window', 'width', 0.709518, 0.8129, 0.3252),
  ('window', 'width', 0.8129, 0.856574, 0.4056),
  ('window', 'width', 0.856574, 0.950861, 0.7798),
  ('window', 'width', 0.950861, 1.00714, 1.886),
  ('window', 'width', 1.00714, 1.03411, 2.125),
  ('window', 'width', 1.03411, 1.0645, 2.14),
  ('window', 'width', 1.0645, 1.10093, 2.734),
  ('window', 'width', 1.10093, 1.18295, 1.759),
  ('window', 'width', 1.18295, 1.24844, 0.9277),
  ('window', 'width', 1.24844, 1.29332, 1.348),
  ('window', 'width', 1.29332, 1.45541, 0.7537),
  ('window', 'width', 1.45541, 1.5072, 0.282),
  ('window', 'width', 1.5072, 12, 0.007841);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_max', -0.5, 1.32185, 0.006219),
  ('window', 'z_max', 1.32185, 1.44515, 0.04272),
  ('window', 'z_max', 1.44515, 1.56845, 0.05947),
  ('window', 'z_max', 1.56845, 1.69175, 0.07881),
  ('window', 'z_max', 1.69175, 1.81506, 0.04777),
  ('window', 'z_max', 1.81506, 1.93836, 0.5309),
  ('window', 'z_max', 1.93836, 1.94797, 2.615),
  ('window', 'z_max', 1.94797, 1.99291, 2.269),
  ('window', 'z_max', 1.99291, 2.04766, 2.061),
  ('window', 'z_max', 2.04766, 2.06166, 2.575),
  ('window', 'z_max', 2.06166, 2.08882, 2.346),
  ('window', 'z_max', 2.08882, 2.1549, 1.7),
  ('window', 'z_max', 2.1549, 2.18496, 1.665),
  ('window', 'z_max', 2.18496, 2.21352, 1.428),
  ('window', 'z_max', 2.21352, 2.26469, 2.31),
  ('window', 'z_max', 2.26469, 2.30826, 1.627),
  ('window', 'z_max', 2.30826, 2.36658, 0.8398),
  ('window', 'z_max', 2.36658, 2.43157, 1.576),
  ('window', 'z_max', 2.43157, 4, 0.007406);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_min', -0.5, 0.795786, 0.01381),
  ('window', 'z_min', 0.795786, 0.815866, 1.531),
  ('window', 'z_min', 0.815866, 0.829972, 4.513),
  ('window', 'z_min', 0.829972, 0.849885, 5.325),
  ('window', 'z_min', 0.849885, 0.87785, 4.076),
  ('window', 'z_min', 0.87785, 0.886881, 3.151),
  ('window', 'z_min', 0.886881, 0.910472, 3.556),
  ('window', 'z_min', 0.910472, 0.929932, 4.221),
  ('window', 'z_min', 0.929932, 0.962843, 3.853),
  ('window', 'z_min', 0.962843, 0.977976, 4.715),
  ('window', 'z_min', 0.977976, 0.984495, 4.59),
  ('window', 'z_min', 0.984495, 1.06907, 0.9816),
  ('window', 'z_min', 1.06907, 1.16017, 0.2637),
  ('window', 'z_min', 1.16017, 1.25126, 0.3127),
  ('window', 'z_min', 1.25126, 1.27164, 0.3578),
  ('window', 'z_min', 1.27164, 1.34236, 0.3569),
  ('window', 'z_min', 1.34236, 1.43345, 0.2665),
  ('window', 'z_min', 1.43345, 1.52455, 0.2935),
  ('window', 'z_min', 1.52455, 1.61564, 0.167),
  ('window', 'z_min', 1.61564, 4, 0.004541);

-- whiteboard: 59 examples
UPDATE object_class SET prior = 0.01247 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.2401, 0.6951)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.423, 0.3203)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.388, 0.1462)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.4668, 0.3401)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.775, 0.1138)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.3246, 0.3307)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.236, 0.393)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.63, 0.9257)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', 0.0426, 0.4002)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 2.01, 0.2559)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.7801, 0.2461)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'area_m2', 0.002, 0.150172, 0.002958),
  ('whiteboard', 'area_m2', 0.150172, 0.226603, 0.05419),
  ('whiteboard', 'area_m2', 0.226603, 0.341934, 0.07785),
  ('whiteboard', 'area_m2', 0.341934, 0.515962, 0.08196),
  ('whiteboard', 'area_m2', 0.515962, 0.598068, 0.1461),
  ('whiteboard', 'area_m2', 0.598068, 0.778563, 0.1907),
  ('whiteboard', 'area_m2', 0.778563, 0.934023, 0.3379),
  ('whiteboard', 'area_m2', 0.934023, 1.10119, 0.6417),
  ('whiteboard', 'area_m2', 1.10119, 1.17482, 0.6672),
  ('whiteboard', 'area_m2', 1.17482, 1.31937, 0.7664),
  ('whiteboard', 'area_m2', 1.31937, 1.48359, 0.8015),
  ('whiteboard', 'area_m2', 1.48359, 1.73692, 0.6422),
  ('whiteboard', 'area_m2', 1.73692, 2.09853, 0.5534),
  ('whiteboard', 'area_m2', 2.09853, 2.56441, 0.5904),
  ('whiteboard', 'area_m2', 2.56441, 2.67499, 0.4396),
  ('whiteboard', 'area_m2', 2.67499, 4.03643, 0.1442),
  ('whiteboard', 'area_m2', 4.03643, 6.09078, 0.04151),
  ('whiteboard', 'area_m2', 6.09078, 100, 0.005292);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'aspect', 1, 1.0228, 0.868),
  ('whiteboard', 'aspect', 1.0228, 1.06793, 1.883),
  ('whiteboard', 'aspect', 1.06793, 1.11991, 2.264),
  ('whiteboard', 'aspect', 1.11991, 1.16999, 0.9315),
  ('whiteboard', 'aspect', 1.16999, 1.27364, 0.8255),
  ('whiteboard', 'aspect', 1.27364, 1.36888, 1.185),
  ('whiteboard', 'aspect', 1.36888, 1.4334, 0.6912),
  ('whiteboard', 'aspect', 1.4334, 1.52939, 1.762),
  ('whiteboard', 'aspect', 1.52939, 1.60158, 1.636),
  ('whiteboard', 'aspect', 1.60158, 1.6787, 0.9035),
  ('whiteboard', 'aspect', 1.6787, 1.87383, 0.8514),
  ('whiteboard', 'aspect', 1.87383, 1.92377, 0.8259),
  ('whiteboard', 'aspect', 1.92377, 2.17354, 0.7662),
  ('whiteboard', 'aspect', 2.17354, 2.56504, 0.3872),
  ('whiteboard', 'aspect', 2.56504, 3.00108, 0.09615),
  ('whiteboard', 'aspect', 3.00108, 3.51123, 0.08453),
  ('whiteboard', 'aspect', 3.51123, 4.10811, 0.1081),
  ('whiteboard', 'aspect', 4.10811, 100, 0.004061);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'height', -0.5, 0.797241, 0.009856),
  ('whiteboard', 'height', 0.797241, 0.88786, 0.116),
  ('whiteboard', 'height', 0.88786, 0.978479, 0.05777),
  ('whiteboard', 'height', 0.978479, 1.0691, 0.06141),
  ('whiteboard', 'height', 1.0691, 1.15972, 0.3094),
  ('whiteboard', 'height', 1.15972, 1.24436, 0.7322),
  ('whiteboard', 'height', 1.24436, 1.25034, 0.927),
  ('whiteboard', 'height', 1.25034, 1.32289, 1.647),
  ('whiteboard', 'height', 1.32289, 1.34096, 1.991),
  ('whiteboard', 'height', 1.34096, 1.37657, 2.142),
  ('whiteboard', 'height', 1.37657, 1.39377, 4.372),
  ('whiteboard', 'height', 1.39377, 1.4277, 3.485),
  ('whiteboard', 'height', 1.4277, 1.4519, 4.256),
  ('whiteboard', 'height', 1.4519, 1.48834, 3.389),
  ('whiteboard', 'height', 1.48834, 1.51568, 3.183),
  ('whiteboard', 'height', 1.51568, 1.52219, 2.209),
  ('whiteboard', 'height', 1.52219, 1.60681, 1.112),
  ('whiteboard', 'height', 1.60681, 1.61281, 0.5083),
  ('whiteboard', 'height', 1.61281, 4, 0.008408);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'length', 0.03, 0.746051, 0.004156),
  ('whiteboard', 'length', 0.746051, 0.908646, 0.08859),
  ('whiteboard', 'length', 0.908646, 1.10668, 0.3195),
  ('whiteboard', 'length', 1.10668, 1.14502, 1.183),
  ('whiteboard', 'length', 1.14502, 1.21506, 1.486),
  ('whiteboard', 'length', 1.21506, 1.29671, 1.693),
  ('whiteboard', 'length', 1.29671, 1.34787, 1.909),
  ('whiteboard', 'length', 1.34787, 1.37515, 1.165),
  ('whiteboard', 'length', 1.37515, 1.63188, 0.7533),
  ('whiteboard', 'length', 1.63188, 1.89062, 0.7872),
  ('whiteboard', 'length', 1.89062, 1.9994, 1.367),
  ('whiteboard', 'length', 1.9994, 2.07595, 0.7365),
  ('whiteboard', 'length', 2.07595, 2.38465, 0.7197),
  ('whiteboard', 'length', 2.38465, 2.43516, 0.8484),
  ('whiteboard', 'length', 2.43516, 2.96588, 0.3225),
  ('whiteboard', 'length', 2.96588, 3.61227, 0.0783),
  ('whiteboard', 'length', 3.61227, 4.39953, 0.06941),
  ('whiteboard', 'length', 4.39953, 30, 0.005811);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'rectangularity', 0, 0.467082, 0.02795),
  ('whiteboard', 'rectangularity', 0.467082, 0.519602, 0.5074),
  ('whiteboard', 'rectangularity', 0.519602, 0.572123, 0.7222),
  ('whiteboard', 'rectangularity', 0.572123, 0.613177, 0.7944),
  ('whiteboard', 'rectangularity', 0.613177, 0.624644, 1.024),
  ('whiteboard', 'rectangularity', 0.624644, 0.677165, 1.426),
  ('whiteboard', 'rectangularity', 0.677165, 0.70015, 1.61),
  ('whiteboard', 'rectangularity', 0.70015, 0.729686, 1.605),
  ('whiteboard', 'rectangularity', 0.729686, 0.75176, 2.847),
  ('whiteboard', 'rectangularity', 0.75176, 0.782207, 2.768),
  ('whiteboard', 'rectangularity', 0.782207, 0.797319, 2.771),
  ('whiteboard', 'rectangularity', 0.797319, 0.82529, 3.741),
  ('whiteboard', 'rectangularity', 0.82529, 0.834728, 7.74),
  ('whiteboard', 'rectangularity', 0.834728, 0.872792, 3.364),
  ('whiteboard', 'rectangularity', 0.872792, 0.885093, 7.778),
  ('whiteboard', 'rectangularity', 0.885093, 0.92151, 2.796),
  ('whiteboard', 'rectangularity', 0.92151, 0.93977, 0.6881),
  ('whiteboard', 'rectangularity', 0.93977, 1, 0.2305);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_length', 0.01, 0.608334, 0.00342),
  ('whiteboard', 'spread_length', 0.608334, 0.73965, 0.06677),
  ('whiteboard', 'spread_length', 0.73965, 0.899313, 0.2568),
  ('whiteboard', 'spread_length', 0.899313, 0.967459, 0.5424),
  ('whiteboard', 'spread_length', 0.967459, 1.08973, 1.003),
  ('whiteboard', 'spread_length', 1.08973, 1.13913, 1.868),
  ('whiteboard', 'spread_length', 1.13913, 1.25858, 1.06),
  ('whiteboard', 'spread_length', 1.25858, 1.32947, 1.005),
  ('whiteboard', 'spread_length', 1.32947, 1.42713, 1.099),
  ('whiteboard', 'spread_length', 1.42713, 1.60419, 1.021),
  ('whiteboard', 'spread_length', 1.60419, 1.85693, 0.7076),
  ('whiteboard', 'spread_length', 1.85693, 1.96539, 1.501),
  ('whiteboard', 'spread_length', 1.96539, 2.00343, 1.023),
  ('whiteboard', 'spread_length', 2.00343, 2.38964, 0.4014),
  ('whiteboard', 'spread_length', 2.38964, 2.90547, 0.09388),
  ('whiteboard', 'spread_length', 2.90547, 3.30432, 0.08577),
  ('whiteboard', 'spread_length', 3.30432, 3.53265, 0.08583),
  ('whiteboard', 'spread_length', 3.53265, 40, 0.003556);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_width', 0.003, 0.176214, 0.003282),
  ('whiteboard', 'spread_width', 0.176214, 0.226066, 0.05052),
  ('whiteboard', 'spread_width', 0.226066, 0.290022, 0.06713),
  ('whiteboard', 'spread_width', 0.290022, 0.372072, 0.04495),
  ('whiteboard', 'spread_width', 0.372072, 0.477335, 0.1549),
  ('whiteboard', 'spread_width', 0.477335, 0.579491, 0.2188),
  ('whiteboard', 'spread_width', 0.579491, 0.612378, 0.3245),
  ('whiteboard', 'spread_width', 0.612378, 0.715262, 0.7051),
  ('whiteboard', 'spread_width', 0.715262, 0.771836, 1.221),
  ('whiteboard', 'spread_width', 0.771836, 0.785625, 1.803),
  ('whiteboard', 'spread_width', 0.785625, 0.843448, 1.233),
  ('whiteboard', 'spread_width', 0.843448, 0.883697, 1.756),
  ('whiteboard', 'spread_width', 0.883697, 0.928389, 1.97),
  ('whiteboard', 'spread_width', 0.928389, 1.00789, 1.51),
  ('whiteboard', 'spread_width', 1.00789, 1.08389, 1.222),
  ('whiteboard', 'spread_width', 1.08389, 1.29303, 0.5152),
  ('whiteboard', 'spread_width', 1.29303, 1.65883, 0.09704),
  ('whiteboard', 'spread_width', 1.65883, 20, 0.007351);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'tilt_deg', 0, 85.0724, 9.42e-06),
  ('whiteboard', 'tilt_deg', 85.0724, 85.4582, 0.02754),
  ('whiteboard', 'tilt_deg', 85.4582, 85.6199, 0.04722),
  ('whiteboard', 'tilt_deg', 85.6199, 86.1674, 0.01654),
  ('whiteboard', 'tilt_deg', 86.1674, 86.7149, 0.0004082),
  ('whiteboard', 'tilt_deg', 86.7149, 87.2625, 0.009954),
  ('whiteboard', 'tilt_deg', 87.2625, 87.81, 0.02703),
  ('whiteboard', 'tilt_deg', 87.81, 88.3575, 0.06247),
  ('whiteboard', 'tilt_deg', 88.3575, 88.905, 0.09551),
  ('whiteboard', 'tilt_deg', 88.905, 89.0494, 0.1463),
  ('whiteboard', 'tilt_deg', 89.0494, 89.4525, 0.2001),
  ('whiteboard', 'tilt_deg', 89.4525, 90, 1.394);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'width', 0.01, 0.248701, 0.00439),
  ('whiteboard', 'width', 0.248701, 0.319701, 0.04987),
  ('whiteboard', 'width', 0.319701, 0.41097, 0.07282),
  ('whiteboard', 'width', 0.41097, 0.528294, 0.1325),
  ('whiteboard', 'width', 0.528294, 0.679112, 0.1437),
  ('whiteboard', 'width', 0.679112, 0.745902, 0.1895),
  ('whiteboard', 'width', 0.745902, 0.872986, 0.3443),
  ('whiteboard', 'width', 0.872986, 0.985895, 0.615),
  ('whiteboard', 'width', 0.985895, 1.05722, 1.418),
  ('whiteboard', 'width', 1.05722, 1.09403, 2.717),
  ('whiteboard', 'width', 1.09403, 1.12221, 2.077),
  ('whiteboard', 'width', 1.12221, 1.15541, 2.297),
  ('whiteboard', 'width', 1.15541, 1.1872, 2.991),
  ('whiteboard', 'width', 1.1872, 1.27538, 1.581),
  ('whiteboard', 'width', 1.27538, 1.34409, 1.696),
  ('whiteboard', 'width', 1.34409, 1.44258, 0.5434),
  ('whiteboard', 'width', 1.44258, 1.85441, 0.214),
  ('whiteboard', 'width', 1.85441, 2.38381, 0.136),
  ('whiteboard', 'width', 2.38381, 12, 0.01075);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_max', -0.5, 1.21874, 0.005126),
  ('whiteboard', 'z_max', 1.21874, 1.39314, 0.1165),
  ('whiteboard', 'z_max', 1.39314, 1.56754, 0.1375),
  ('whiteboard', 'z_max', 1.56754, 1.73874, 0.383),
  ('whiteboard', 'z_max', 1.73874, 1.89754, 0.8194),
  ('whiteboard', 'z_max', 1.89754, 1.91634, 1.755),
  ('whiteboard', 'z_max', 1.91634, 1.94787, 2.025),
  ('whiteboard', 'z_max', 1.94787, 2.0048, 1.754),
  ('whiteboard', 'z_max', 2.0048, 2.05438, 1.881),
  ('whiteboard', 'z_max', 2.05438, 2.09073, 2.7),
  ('whiteboard', 'z_max', 2.09073, 2.14187, 2.691),
  ('whiteboard', 'z_max', 2.14187, 2.20488, 1.405),
  ('whiteboard', 'z_max', 2.20488, 2.26513, 0.8027),
  ('whiteboard', 'z_max', 2.26513, 2.43953, 0.2312),
  ('whiteboard', 'z_max', 2.43953, 2.61393, 0.1122),
  ('whiteboard', 'z_max', 2.61393, 2.78833, 0.1034),
  ('whiteboard', 'z_max', 2.78833, 4, 0.008741);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_min', -0.5, -0.0456447, 0.02125),
  ('whiteboard', 'z_min', -0.0456447, 0.0758772, 0.3777),
  ('whiteboard', 'z_min', 0.0758772, 0.197399, 0.04008),
  ('whiteboard', 'z_min', 0.197399, 0.318921, 0.1244),
  ('whiteboard', 'z_min', 0.318921, 0.440443, 0.08475),
  ('whiteboard', 'z_min', 0.440443, 0.561965, 0.2526),
  ('whiteboard', 'z_min', 0.561965, 0.631572, 0.4061),
  ('whiteboard', 'z_min', 0.631572, 0.683487, 0.6309),
  ('whiteboard', 'z_min', 0.683487, 0.794941, 1.112),
  ('whiteboard', 'z_min', 0.794941, 0.80446, 5.969),
  ('whiteboard', 'z_min', 0.80446, 0.828713, 4.444),
  ('whiteboard', 'z_min', 0.828713, 0.853777, 3.73),
  ('whiteboard', 'z_min', 0.853777, 0.874669, 4.499),
  ('whiteboard', 'z_min', 0.874669, 0.909897, 2.718),
  ('whiteboard', 'z_min', 0.909897, 0.926531, 2.85),
  ('whiteboard', 'z_min', 0.926531, 0.951547, 2.178),
  ('whiteboard', 'z_min', 0.951547, 1.04805, 1.208),
  ('whiteboard', 'z_min', 1.04805, 4, 0.01091);

-- shelf: 246 examples
UPDATE object_class SET prior = 0.05241 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.495, 0.7672)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.9763, 0.4565)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9502, 0.5013)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.06698, 0.532)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6978, 0.1342)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.2306, 0.5265)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.224, 0.3541)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 54.31, 42.94)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.047, 0.3226)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.289, 0.6451)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5767, 0.5906)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'area_m2', 0.002, 0.0193658, 0.00377),
  ('shelf', 'area_m2', 0.0193658, 0.0295494, 0.03406),
  ('shelf', 'area_m2', 0.0295494, 0.0450881, 0.06405),
  ('shelf', 'area_m2', 0.0450881, 0.0687979, 0.08375),
  ('shelf', 'area_m2', 0.0687979, 0.0935081, 0.1004),
  ('shelf', 'area_m2', 0.0935081, 0.104976, 0.2091),
  ('shelf', 'area_m2', 0.104976, 0.135919, 0.3071),
  ('shelf', 'area_m2', 0.135919, 0.160177, 0.2511),
  ('shelf', 'area_m2', 0.160177, 0.191073, 0.4568),
  ('shelf', 'area_m2', 0.191073, 0.232591, 0.5632),
  ('shelf', 'area_m2', 0.232591, 0.244408, 0.6403),
  ('shelf', 'area_m2', 0.244408, 0.281114, 0.5095),
  ('shelf', 'area_m2', 0.281114, 0.325174, 0.7466),
  ('shelf', 'area_m2', 0.325174, 0.37293, 0.6588),
  ('shelf', 'area_m2', 0.37293, 0.393313, 0.4378),
  ('shelf', 'area_m2', 0.393313, 0.520095, 0.3885),
  ('shelf', 'area_m2', 0.520095, 0.569037, 0.38),
  ('shelf', 'area_m2', 0.569037, 0.868268, 0.1652),
  ('shelf', 'area_m2', 0.868268, 100, 0.002084);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'aspect', 1, 1.23476, 0.2432),
  ('shelf', 'aspect', 1.23476, 1.43536, 0.3757),
  ('shelf', 'aspect', 1.43536, 1.52464, 0.4725),
  ('shelf', 'aspect', 1.52464, 1.82763, 0.4725),
  ('shelf', 'aspect', 1.82763, 1.88257, 0.5237),
  ('shelf', 'aspect', 1.88257, 2.12726, 0.7879),
  ('shelf', 'aspect', 2.12726, 2.32453, 0.6908),
  ('shelf', 'aspect', 2.32453, 2.57097, 0.5657),
  ('shelf', 'aspect', 2.57097, 2.86364, 0.948),
  ('shelf', 'aspect', 2.86364, 3.31003, 0.7599),
  ('shelf', 'aspect', 3.31003, 3.54408, 1.174),
  ('shelf', 'aspect', 3.54408, 3.83745, 0.4452),
  ('shelf', 'aspect', 3.83745, 4.3761, 0.4362),
  ('shelf', 'aspect', 4.3761, 4.96187, 0.3904),
  ('shelf', 'aspect', 4.96187, 5.40345, 0.4427),
  ('shelf', 'aspect', 5.40345, 6.67198, 0.3332),
  ('shelf', 'aspect', 6.67198, 100, 0.002091);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'height', -0.5, 0.00149673, 0.002753),
  ('shelf', 'height', 0.00149673, 0.0526229, 0.1387),
  ('shelf', 'height', 0.0526229, 0.244826, 0.4606),
  ('shelf', 'height', 0.244826, 0.382427, 0.1564),
  ('shelf', 'height', 0.382427, 0.488155, 0.6589),
  ('shelf', 'height', 0.488155, 0.535417, 0.6893),
  ('shelf', 'height', 0.535417, 0.731484, 0.529),
  ('shelf', 'height', 0.731484, 0.888323, 0.726),
  ('shelf', 'height', 0.888323, 0.974813, 0.8767),
  ('shelf', 'height', 0.974813, 1.01602, 0.9501),
  ('shelf', 'height', 1.01602, 1.12575, 1.016),
  ('shelf', 'height', 1.12575, 1.21814, 0.768),
  ('shelf', 'height', 1.21814, 1.29542, 0.5525),
  ('shelf', 'height', 1.29542, 1.46147, 0.473),
  ('shelf', 'height', 1.46147, 1.58127, 0.2678),
  ('shelf', 'height', 1.58127, 1.7048, 0.2176),
  ('shelf', 'height', 1.7048, 1.94813, 0.184),
  ('shelf', 'height', 1.94813, 2.15804, 0.1306),
  ('shelf', 'height', 2.15804, 2.19146, 0.0859),
  ('shelf', 'height', 2.19146, 4, 0.00499);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'length', 0.03, 0.204539, 0.005943),
  ('shelf', 'length', 0.204539, 0.268993, 0.08409),
  ('shelf', 'length', 0.268993, 0.353759, 0.101),
  ('shelf', 'length', 0.353759, 0.465235, 0.1195),
  ('shelf', 'length', 0.465235, 0.495395, 0.2415),
  ('shelf', 'length', 0.495395, 0.611841, 0.359),
  ('shelf', 'length', 0.611841, 0.643308, 0.7014),
  ('shelf', 'length', 0.643308, 0.792952, 0.5557),
  ('shelf', 'length', 0.792952, 0.934288, 0.6653),
  ('shelf', 'length', 0.934288, 1.0582, 0.8255),
  ('shelf', 'length', 1.0582, 1.21414, 0.8807),
  ('shelf', 'length', 1.21414, 1.39167, 0.6797),
  ('shelf', 'length', 1.39167, 1.42204, 0.5368),
  ('shelf', 'length', 1.42204, 1.72439, 0.5659),
  ('shelf', 'length', 1.72439, 1.83021, 0.3231),
  ('shelf', 'length', 1.83021, 2.25157, 0.4018),
  ('shelf', 'length', 2.25157, 2.40694, 0.1524),
  ('shelf', 'length', 2.40694, 30, 0.00147);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'rectangularity', 0, 0.407274, 0.02261),
  ('shelf', 'rectangularity', 0.407274, 0.46785, 0.7323),
  ('shelf', 'rectangularity', 0.46785, 0.518955, 1.128),
  ('shelf', 'rectangularity', 0.518955, 0.528426, 1.508),
  ('shelf', 'rectangularity', 0.528426, 0.575217, 2.073),
  ('shelf', 'rectangularity', 0.575217, 0.589002, 2.726),
  ('shelf', 'rectangularity', 0.589002, 0.63427, 1.625),
  ('shelf', 'rectangularity', 0.63427, 0.649578, 2.018),
  ('shelf', 'rectangularity', 0.649578, 0.688263, 2.048),
  ('shelf', 'rectangularity', 0.688263, 0.710154, 2.16),
  ('shelf', 'rectangularity', 0.710154, 0.733759, 2.653),
  ('shelf', 'rectangularity', 0.733759, 0.77073, 2.518),
  ('shelf', 'rectangularity', 0.77073, 0.783805, 1.69),
  ('shelf', 'rectangularity', 0.783805, 0.817278, 3.293),
  ('shelf', 'rectangularity', 0.817278, 0.831306, 2.229),
  ('shelf', 'rectangularity', 0.831306, 0.857097, 3.039),
  ('shelf', 'rectangularity', 0.857097, 0.891882, 1.721),
  ('shelf', 'rectangularity', 0.891882, 0.950791, 0.7087),
  ('shelf', 'rectangularity', 0.950791, 1, 0.1957);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_length', 0.01, 0.185683, 0.003457),
  ('shelf', 'spread_length', 0.185683, 0.242961, 0.07551),
  ('shelf', 'spread_length', 0.242961, 0.317906, 0.1156),
  ('shelf', 'spread_length', 0.317906, 0.402162, 0.2044),
  ('shelf', 'spread_length', 0.402162, 0.415969, 0.2456),
  ('shelf', 'spread_length', 0.415969, 0.544282, 0.3317),
  ('shelf', 'spread_length', 0.544282, 0.563631, 0.5651),
  ('shelf', 'spread_length', 0.563631, 0.652353, 0.7634),
  ('shelf', 'spread_length', 0.652353, 0.712175, 0.6953),
  ('shelf', 'spread_length', 0.712175, 0.75176, 0.9088),
  ('shelf', 'spread_length', 0.75176, 0.913179, 0.5634),
  ('shelf', 'spread_length', 0.913179, 0.931857, 0.6783),
  ('shelf', 'spread_length', 0.931857, 1.05783, 0.7365),
  ('shelf', 'spread_length', 1.05783, 1.2193, 0.8192),
  ('shelf', 'spread_length', 1.2193, 1.4647, 0.5652),
  ('shelf', 'spread_length', 1.4647, 1.59542, 0.3103),
  ('shelf', 'spread_length', 1.59542, 2.08755, 0.3012),
  ('shelf', 'spread_length', 2.08755, 40, 0.002464);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_width', 0.003, 0.112485, 0.002576),
  ('shelf', 'spread_width', 0.112485, 0.137939, 0.1535),
  ('shelf', 'spread_width', 0.137939, 0.169154, 0.1804),
  ('shelf', 'spread_width', 0.169154, 0.185471, 0.3912),
  ('shelf', 'spread_width', 0.185471, 0.207432, 0.5614),
  ('shelf', 'spread_width', 0.207432, 0.2281, 0.4602),
  ('shelf', 'spread_width', 0.2281, 0.254373, 0.5785),
  ('shelf', 'spread_width', 0.254373, 0.274169, 0.7393),
  ('shelf', 'spread_width', 0.274169, 0.297674, 1.354),
  ('shelf', 'spread_width', 0.297674, 0.311936, 1.157),
  ('shelf', 'spread_width', 0.311936, 0.324311, 1.424),
  ('shelf', 'spread_width', 0.324311, 0.346019, 1.628),
  ('shelf', 'spread_width', 0.346019, 0.382161, 1.137),
  ('shelf', 'spread_width', 0.382161, 0.42427, 0.9792),
  ('shelf', 'spread_width', 0.42427, 0.469087, 0.6769),
  ('shelf', 'spread_width', 0.469087, 0.575239, 0.15),
  ('shelf', 'spread_width', 0.575239, 0.705411, 0.05858),
  ('shelf', 'spread_width', 0.705411, 20, 0.002783);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'tilt_deg', 0, 1.06064, 0.104),
  ('shelf', 'tilt_deg', 1.06064, 1.79339, 0.1388),
  ('shelf', 'tilt_deg', 1.79339, 3.51677, 0.0625),
  ('shelf', 'tilt_deg', 3.51677, 10, 0.01028),
  ('shelf', 'tilt_deg', 10, 20, 0.0005537),
  ('shelf', 'tilt_deg', 20, 30, 0.0004488),
  ('shelf', 'tilt_deg', 30, 40, 0.0004868),
  ('shelf', 'tilt_deg', 40, 50, 0.0005257),
  ('shelf', 'tilt_deg', 50, 60, 0.0005616),
  ('shelf', 'tilt_deg', 60, 70, 0.0006733),
  ('shelf', 'tilt_deg', 70, 80, 0.001082),
  ('shelf', 'tilt_deg', 80, 88.2034, 0.004455),
  ('shelf', 'tilt_deg', 88.2034, 89.7113, 0.1312),
  ('shelf', 'tilt_deg', 89.7113, 90, 1.164);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'width', 0.01, 0.127253, 0.003229),
  ('shelf', 'width', 0.127253, 0.155929, 0.1149),
  ('shelf', 'width', 0.155929, 0.191067, 0.1753),
  ('shelf', 'width', 0.191067, 0.234123, 0.1993),
  ('shelf', 'width', 0.234123, 0.240369, 0.2168),
  ('shelf', 'width', 0.240369, 0.286881, 0.358),
  ('shelf', 'width', 0.286881, 0.305413, 0.873),
  ('shelf', 'width', 0.305413, 0.330365, 1.356),
  ('shelf', 'width', 0.330365, 0.351528, 1.582),
  ('shelf', 'width', 0.351528, 0.371913, 1.929),
  ('shelf', 'width', 0.371913, 0.408056, 1.366),
  ('shelf', 'width', 0.408056, 0.429382, 1.894),
  ('shelf', 'width', 0.429382, 0.477589, 1.166),
  ('shelf', 'width', 0.477589, 0.527808, 0.4697),
  ('shelf', 'width', 0.527808, 0.646747, 0.1811),
  ('shelf', 'width', 0.646747, 0.792487, 0.06582),
  ('shelf', 'width', 0.792487, 12, 0.004003);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_max', -0.5, -0.0105078, 0.002078),
  ('shelf', 'z_max', -0.0105078, 0.0695236, 0.3469),
  ('shelf', 'z_max', 0.0695236, 0.249143, 0.3412),
  ('shelf', 'z_max', 0.249143, 0.414541, 0.1517),
  ('shelf', 'z_max', 0.414541, 0.508793, 0.6385),
  ('shelf', 'z_max', 0.508793, 0.622576, 0.38),
  ('shelf', 'z_max', 0.622576, 0.768443, 0.2158),
  ('shelf', 'z_max', 0.768443, 1.02809, 0.2669),
  ('shelf', 'z_max', 1.02809, 1.06333, 0.5181),
  ('shelf', 'z_max', 1.06333, 1.28774, 0.4279),
  ('shelf', 'z_max', 1.28774, 1.53243, 0.5073),
  ('shelf', 'z_max', 1.53243, 1.68628, 0.7524),
  ('shelf', 'z_max', 1.68628, 1.80705, 0.6807),
  ('shelf', 'z_max', 1.80705, 1.85938, 0.498),
  ('shelf', 'z_max', 1.85938, 2.04431, 0.564),
  ('shelf', 'z_max', 2.04431, 2.0667, 0.4445),
  ('shelf', 'z_max', 2.0667, 2.32635, 0.3662),
  ('shelf', 'z_max', 2.32635, 4, 0.005298);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_min', -0.5, -0.0744377, 0.01439),
  ('shelf', 'z_min', -0.0744377, -0.0424996, 0.08928),
  ('shelf', 'z_min', -0.0424996, -0.00522146, 2.51),
  ('shelf', 'z_min', -0.00522146, 0.0331895, 3.059),
  ('shelf', 'z_min', 0.0331895, 0.0888, 1.954),
  ('shelf', 'z_min', 0.0888, 0.175956, 0.4938),
  ('shelf', 'z_min', 0.175956, 0.404236, 0.3219),
  ('shelf', 'z_min', 0.404236, 0.426349, 1.125),
  ('shelf', 'z_min', 0.426349, 0.494774, 1.11),
  ('shelf', 'z_min', 0.494774, 0.676742, 0.427),
  ('shelf', 'z_min', 0.676742, 0.76319, 0.4627),
  ('shelf', 'z_min', 0.76319, 0.927135, 0.5881),
  ('shelf', 'z_min', 0.927135, 0.953956, 0.4628),
  ('shelf', 'z_min', 0.953956, 1.17753, 0.4287),
  ('shelf', 'z_min', 1.17753, 1.42792, 0.07796),
  ('shelf', 'z_min', 1.42792, 1.53662, 0.09613),
  ('shelf', 'z_min', 1.53662, 1.67832, 0.1361),
  ('shelf', 'z_min', 1.67832, 1.92871, 0.1616),
  ('shelf', 'z_min', 1.92871, 2.15382, 0.1324),
  ('shelf', 'z_min', 2.15382, 2.1791, 0.08873),
  ('shelf', 'z_min', 2.1791, 4, 0.005432);

-- cabinet: 316 examples
UPDATE object_class SET prior = 0.06692 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.845, 0.9736)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6282, 0.4152)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7532, 0.3479)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.07344, 0.5202)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7133, 0.1449)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1095, 0.5162)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7774, 0.5135)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 75.77, 32.26)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.5583, 0.4831)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.209, 0.5731)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2155, 0.3278)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'area_m2', 0.002, 0.0273029, 0.003738),
  ('cabinet', 'area_m2', 0.0273029, 0.0467645, 0.03621),
  ('cabinet', 'area_m2', 0.0467645, 0.0800984, 0.06442),
  ('cabinet', 'area_m2', 0.0800984, 0.121794, 0.1147),
  ('cabinet', 'area_m2', 0.121794, 0.137193, 0.1452),
  ('cabinet', 'area_m2', 0.137193, 0.222175, 0.1907),
  ('cabinet', 'area_m2', 0.222175, 0.234984, 0.2607),
  ('cabinet', 'area_m2', 0.234984, 0.322884, 0.3103),
  ('cabinet', 'area_m2', 0.322884, 0.388923, 0.598),
  ('cabinet', 'area_m2', 0.388923, 0.402481, 0.4778),
  ('cabinet', 'area_m2', 0.402481, 0.531377, 0.3463),
  ('cabinet', 'area_m2', 0.531377, 0.68937, 0.369),
  ('cabinet', 'area_m2', 0.68937, 0.724632, 0.3465),
  ('cabinet', 'area_m2', 0.724632, 0.971379, 0.3611),
  ('cabinet', 'area_m2', 0.971379, 1.18075, 0.4027),
  ('cabinet', 'area_m2', 1.18075, 1.34197, 0.2712),
  ('cabinet', 'area_m2', 1.34197, 2.0224, 0.1882),
  ('cabinet', 'area_m2', 2.0224, 3.46397, 0.04651),
  ('cabinet', 'area_m2', 3.46397, 100, 0.00209);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'aspect', 1, 1.15612, 0.7889),
  ('cabinet', 'aspect', 1.15612, 1.21557, 1.361),
  ('cabinet', 'aspect', 1.21557, 1.26291, 1.01),
  ('cabinet', 'aspect', 1.26291, 1.44999, 0.78),
  ('cabinet', 'aspect', 1.44999, 1.47761, 0.5134),
  ('cabinet', 'aspect', 1.47761, 1.66427, 0.9057),
  ('cabinet', 'aspect', 1.66427, 1.79613, 0.696),
  ('cabinet', 'aspect', 1.79613, 1.98089, 0.5702),
  ('cabinet', 'aspect', 1.98089, 2.18333, 1.038),
  ('cabinet', 'aspect', 2.18333, 2.21771, 0.7264),
  ('cabinet', 'aspect', 2.21771, 2.63169, 0.658),
  ('cabinet', 'aspect', 2.63169, 3.1473, 0.6067),
  ('cabinet', 'aspect', 3.1473, 3.2261, 0.404),
  ('cabinet', 'aspect', 3.2261, 3.92155, 0.2458),
  ('cabinet', 'aspect', 3.92155, 4.76691, 0.1344),
  ('cabinet', 'aspect', 4.76691, 5.79451, 0.07322),
  ('cabinet', 'aspect', 5.79451, 100, 0.00444);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'height', -0.5, 0.151207, 0.01174),
  ('cabinet', 'height', 0.151207, 0.303304, 0.5263),
  ('cabinet', 'height', 0.303304, 0.315362, 1.63),
  ('cabinet', 'height', 0.315362, 0.452607, 0.8284),
  ('cabinet', 'height', 0.452607, 0.555016, 1.082),
  ('cabinet', 'height', 0.555016, 0.607498, 2.144),
  ('cabinet', 'height', 0.607498, 0.759594, 0.638),
  ('cabinet', 'height', 0.759594, 0.787093, 0.4585),
  ('cabinet', 'height', 0.787093, 0.911691, 0.5578),
  ('cabinet', 'height', 0.911691, 0.946307, 1.357),
  ('cabinet', 'height', 0.946307, 1.05411, 0.9764),
  ('cabinet', 'height', 1.05411, 1.21588, 0.6406),
  ('cabinet', 'height', 1.21588, 1.2336, 0.6199),
  ('cabinet', 'height', 1.2336, 1.36798, 0.48),
  ('cabinet', 'height', 1.36798, 1.49817, 0.2687),
  ('cabinet', 'height', 1.49817, 1.52008, 0.1438),
  ('cabinet', 'height', 1.52008, 4, 0.002825);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'length', 0.03, 0.219727, 0.003815),
  ('cabinet', 'length', 0.219727, 0.290223, 0.03762),
  ('cabinet', 'length', 0.290223, 0.383337, 0.06543),
  ('cabinet', 'length', 0.383337, 0.506326, 0.1505),
  ('cabinet', 'length', 0.506326, 0.576463, 0.2786),
  ('cabinet', 'length', 0.576463, 0.668774, 0.429),
  ('cabinet', 'length', 0.668774, 0.722751, 0.5902),
  ('cabinet', 'length', 0.722751, 0.854667, 0.6307),
  ('cabinet', 'length', 0.854667, 0.883342, 0.6273),
  ('cabinet', 'length', 0.883342, 1.0109, 0.6732),
  ('cabinet', 'length', 1.0109, 1.16675, 0.6701),
  ('cabinet', 'length', 1.16675, 1.20167, 0.636),
  ('cabinet', 'length', 1.20167, 1.49288, 0.4971),
  ('cabinet', 'length', 1.49288, 1.54109, 0.3522),
  ('cabinet', 'length', 1.54109, 1.76103, 0.8019),
  ('cabinet', 'length', 1.76103, 1.95641, 0.9973),
  ('cabinet', 'length', 1.95641, 2.03553, 0.7777),
  ('cabinet', 'length', 2.03553, 2.68507, 0.273),
  ('cabinet', 'length', 2.68507, 30, 0.00277);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'rectangularity', 0, 0.341073, 0.02266),
  ('cabinet', 'rectangularity', 0.341073, 0.41254, 0.2755),
  ('cabinet', 'rectangularity', 0.41254, 0.484008, 0.6415),
  ('cabinet', 'rectangularity', 0.484008, 0.527288, 0.875),
  ('cabinet', 'rectangularity', 0.527288, 0.555476, 1.337),
  ('cabinet', 'rectangularity', 0.555476, 0.600622, 1.674),
  ('cabinet', 'rectangularity', 0.600622, 0.626944, 2.219),
  ('cabinet', 'rectangularity', 0.626944, 0.648324, 2.41),
  ('cabinet', 'rectangularity', 0.648324, 0.697809, 2.369),
  ('cabinet', 'rectangularity', 0.697809, 0.749489, 2.02),
  ('cabinet', 'rectangularity', 0.749489, 0.76988, 1.789),
  ('cabinet', 'rectangularity', 0.76988, 0.79944, 2.603),
  ('cabinet', 'rectangularity', 0.79944, 0.836338, 2.903),
  ('cabinet', 'rectangularity', 0.836338, 0.841348, 3.091),
  ('cabinet', 'rectangularity', 0.841348, 0.898656, 1.762),
  ('cabinet', 'rectangularity', 0.898656, 0.912816, 1.982),
  ('cabinet', 'rectangularity', 0.912816, 0.979775, 1.068),
  ('cabinet', 'rectangularity', 0.979775, 1, 0.3679);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_length', 0.01, 0.2148, 0.003009),
  ('cabinet', 'spread_length', 0.2148, 0.277856, 0.04456),
  ('cabinet', 'spread_length', 0.277856, 0.359422, 0.0653),
  ('cabinet', 'spread_length', 0.359422, 0.464931, 0.268),
  ('cabinet', 'spread_length', 0.464931, 0.601414, 0.4519),
  ('cabinet', 'spread_length', 0.601414, 0.693677, 0.798),
  ('cabinet', 'spread_length', 0.693677, 0.777961, 0.7189),
  ('cabinet', 'spread_length', 0.777961, 0.82733, 0.3402),
  ('cabinet', 'spread_length', 0.82733, 0.993374, 0.644),
  ('cabinet', 'spread_length', 0.993374, 1.19262, 0.5794),
  ('cabinet', 'spread_length', 1.19262, 1.30175, 0.5125),
  ('cabinet', 'spread_length', 1.30175, 1.49349, 0.4901),
  ('cabinet', 'spread_length', 1.49349, 1.68388, 0.7513),
  ('cabinet', 'spread_length', 1.68388, 1.72702, 0.8672),
  ('cabinet', 'spread_length', 1.72702, 2.17819, 0.4426),
  ('cabinet', 'spread_length', 2.17819, 40, 0.003172);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_width', 0.003, 0.114726, 0.002301),
  ('cabinet', 'spread_width', 0.114726, 0.152231, 0.1085),
  ('cabinet', 'spread_width', 0.152231, 0.201997, 0.1319),
  ('cabinet', 'spread_width', 0.201997, 0.230536, 0.2276),
  ('cabinet', 'spread_width', 0.230536, 0.268033, 0.2752),
  ('cabinet', 'spread_width', 0.268033, 0.330222, 0.3655),
  ('cabinet', 'spread_width', 0.330222, 0.355656, 0.4526),
  ('cabinet', 'spread_width', 0.355656, 0.396546, 0.6612),
  ('cabinet', 'spread_width', 0.396546, 0.46066, 0.7793),
  ('cabinet', 'spread_width', 0.46066, 0.471925, 0.8952),
  ('cabinet', 'spread_width', 0.471925, 0.516444, 1.03),
  ('cabinet', 'spread_width', 0.516444, 0.567406, 1.09),
  ('cabinet', 'spread_width', 0.567406, 0.626203, 0.8076),
  ('cabinet', 'spread_width', 0.626203, 0.663906, 0.5192),
  ('cabinet', 'spread_width', 0.663906, 0.800314, 0.5928),
  ('cabinet', 'spread_width', 0.800314, 0.830917, 0.6751),
  ('cabinet', 'spread_width', 0.830917, 1.10255, 0.1954),
  ('cabinet', 'spread_width', 1.10255, 1.46299, 0.0891),
  ('cabinet', 'spread_width', 1.46299, 20, 0.003747);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'tilt_deg', 0, 0.655047, 0.1569),
  ('cabinet', 'tilt_deg', 0.655047, 10, 0.005056),
  ('cabinet', 'tilt_deg', 10, 20, 9.65e-05),
  ('cabinet', 'tilt_deg', 20, 30, 0.0001581),
  ('cabinet', 'tilt_deg', 30, 40, 0.0002512),
  ('cabinet', 'tilt_deg', 40, 50, 0.000372),
  ('cabinet', 'tilt_deg', 50, 60, 0.000509),
  ('cabinet', 'tilt_deg', 60, 70, 0.0006429),
  ('cabinet', 'tilt_deg', 70, 80, 0.001022),
  ('cabinet', 'tilt_deg', 80, 88.5368, 0.008492),
  ('cabinet', 'tilt_deg', 88.5368, 89.7086, 0.2019),
  ('cabinet', 'tilt_deg', 89.7086, 89.8871, 1.532),
  ('cabinet', 'tilt_deg', 89.8871, 90, 2.098);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'width', 0.01, 0.138403, 0.00257),
  ('cabinet', 'width', 0.138403, 0.182601, 0.07853),
  ('cabinet', 'width', 0.182601, 0.240914, 0.1476),
  ('cabinet', 'width', 0.240914, 0.317848, 0.161),
  ('cabinet', 'width', 0.317848, 0.419351, 0.3704),
  ('cabinet', 'width', 0.419351, 0.516577, 0.5852),
  ('cabinet', 'width', 0.516577, 0.553268, 0.6771),
  ('cabinet', 'width', 0.553268, 0.577941, 1.437),
  ('cabinet', 'width', 0.577941, 0.613715, 1.786),
  ('cabinet', 'width', 0.613715, 0.674857, 1.134),
  ('cabinet', 'width', 0.674857, 0.72995, 0.5782),
  ('cabinet', 'width', 0.72995, 0.834218, 0.5113),
  ('cabinet', 'width', 0.834218, 0.963055, 0.6661),
  ('cabinet', 'width', 0.963055, 0.986091, 0.5924),
  ('cabinet', 'width', 0.986091, 1.2706, 0.311),
  ('cabinet', 'width', 1.2706, 1.67636, 0.09727),
  ('cabinet', 'width', 1.67636, 12, 0.004091);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_max', -0.5, 0.312129, 0.0106),
  ('cabinet', 'z_max', 0.312129, 0.558247, 0.09276),
  ('cabinet', 'z_max', 0.558247, 0.581101, 3.101),
  ('cabinet', 'z_max', 0.581101, 0.67861, 1.238),
  ('cabinet', 'z_max', 0.67861, 0.791867, 0.9757),
  ('cabinet', 'z_max', 0.791867, 0.956917, 0.6373),
  ('cabinet', 'z_max', 0.956917, 1.05048, 0.7058),
  ('cabinet', 'z_max', 1.05048, 1.10923, 0.7662),
  ('cabinet', 'z_max', 1.10923, 1.2966, 0.4054),
  ('cabinet', 'z_max', 1.2966, 1.54272, 0.1464),
  ('cabinet', 'z_max', 1.54272, 1.61222, 0.1748),
  ('cabinet', 'z_max', 1.61222, 1.78884, 0.5042),
  ('cabinet', 'z_max', 1.78884, 1.81748, 0.5677),
  ('cabinet', 'z_max', 1.81748, 1.99422, 0.6345),
  ('cabinet', 'z_max', 1.99422, 2.03496, 0.3408),
  ('cabinet', 'z_max', 2.03496, 2.28107, 0.2697),
  ('cabinet', 'z_max', 2.28107, 2.52719, 0.08165),
  ('cabinet', 'z_max', 2.52719, 4, 0.005622);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_min', -0.5, -0.0534967, 0.02616),
  ('cabinet', 'z_min', -0.0534967, -0.0179283, 5.106),
  ('cabinet', 'z_min', -0.0179283, -0.0106323, 15.53),
  ('cabinet', 'z_min', -0.0106323, 0.0112758, 10.2),
  ('cabinet', 'z_min', 0.0112758, 0.0809534, 0.8692),
  ('cabinet', 'z_min', 0.0809534, 0.211675, 0.4916),
  ('cabinet', 'z_min', 0.211675, 0.349853, 0.349),
  ('cabinet', 'z_min', 0.349853, 0.484304, 0.4347),
  ('cabinet', 'z_min', 0.484304, 0.523277, 0.3436),
  ('cabinet', 'z_min', 0.523277, 0.618754, 1.023),
  ('cabinet', 'z_min', 0.618754, 0.694383, 0.3081),
  ('cabinet', 'z_min', 0.694383, 0.753204, 0.2834),
  ('cabinet', 'z_min', 0.753204, 0.887654, 0.2211),
  ('cabinet', 'z_min', 0.887654, 1.0221, 0.1918),
  ('cabinet', 'z_min', 1.0221, 1.15655, 0.1405),
  ('cabinet', 'z_min', 1.15655, 4, 0.004609);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.0601 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.532 WHERE name = 'aspect';
UPDATE feature SET weight = 0.3 WHERE name = 'height';
UPDATE feature SET weight = 0 WHERE name = 'length';
UPDATE feature SET weight = 0.321 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.287 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.248 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.455 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.223 WHERE name = 'width';
UPDATE feature SET weight = 0.578 WHERE name = 'z_max';
UPDATE feature SET weight = 0.341 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.331 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0514 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0277 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.13 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0341 WHERE name = 'table';
UPDATE object_class SET prior = 0.0611 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.116 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.00788 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0652 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0129 WHERE name = 'door';
UPDATE object_class SET prior = 0.0209 WHERE name = 'window';
UPDATE object_class SET prior = 0.0215 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0669 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.0532 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 3.04 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.419 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 4.15 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 1.5 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.56 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 2.77 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.78 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.56 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.929 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.58 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.869 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 2.61 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 5.07 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.18 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.681 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.83 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 1.51 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.66 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.01 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 0.706 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 1.26 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.08 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.02 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.827 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.02 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.22 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 0.0474 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.73 WHERE name = 'cabinet_not_on_table';
