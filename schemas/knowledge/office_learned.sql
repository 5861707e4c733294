-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 17224 planes of 180 paper-like rooms, seeds from 1; 90 at 2 cm, seeds from 10101; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 60 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 7123 examples
UPDATE object_class SET prior = 0.3403 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.721, 1.2)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6803, 0.5537)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4781, 0.2929)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.4367, 0.3099)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.5712, 0.4066)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_joined', 0.3116, 0.3302)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 1.046, 0.6998)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.3459, 0.6927)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.723, 0.1345)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.5053, 0.7238)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.24, 0.6323)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 62.12, 39.48)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.029, 0.6162)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.326, 0.9504)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7619, 0.7596)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0219458, 0.003333),
  ('unknown', 'area_m2', 0.0219458, 0.0490335, 0.1024),
  ('unknown', 'area_m2', 0.0490335, 0.0535885, 0.2332),
  ('unknown', 'area_m2', 0.0535885, 0.0739441, 0.3456),
  ('unknown', 'area_m2', 0.0739441, 0.097929, 0.3955),
  ('unknown', 'area_m2', 0.097929, 0.109556, 0.4174),
  ('unknown', 'area_m2', 0.109556, 0.130709, 0.3659),
  ('unknown', 'area_m2', 0.130709, 0.184153, 0.3216),
  ('unknown', 'area_m2', 0.184153, 0.24478, 0.338),
  ('unknown', 'area_m2', 0.24478, 0.254149, 0.4073),
  ('unknown', 'area_m2', 0.254149, 0.337391, 0.3881),
  ('unknown', 'area_m2', 0.337391, 0.546912, 0.2207),
  ('unknown', 'area_m2', 0.546912, 0.56724, 0.1459),
  ('unknown', 'area_m2', 0.56724, 1.22197, 0.08981),
  ('unknown', 'area_m2', 1.22197, 2.73024, 0.01134),
  ('unknown', 'area_m2', 2.73024, 6.10018, 0.008511),
  ('unknown', 'area_m2', 6.10018, 13.6296, 0.009181),
  ('unknown', 'area_m2', 13.6296, 30.4527, 0.01255),
  ('unknown', 'area_m2', 30.4527, 100, 0.007734);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.11116, 1.047),
  ('unknown', 'aspect', 1.11116, 1.24822, 0.9622),
  ('unknown', 'aspect', 1.24822, 1.26933, 1.02),
  ('unknown', 'aspect', 1.26933, 1.39371, 1.001),
  ('unknown', 'aspect', 1.39371, 1.56801, 0.938),
  ('unknown', 'aspect', 1.56801, 1.6112, 0.8559),
  ('unknown', 'aspect', 1.6112, 1.797, 0.8063),
  ('unknown', 'aspect', 1.797, 2.04514, 0.6325),
  ('unknown', 'aspect', 2.04514, 2.15548, 0.5682),
  ('unknown', 'aspect', 2.15548, 2.59596, 0.4125),
  ('unknown', 'aspect', 2.59596, 2.92832, 0.2874),
  ('unknown', 'aspect', 2.92832, 3.29512, 0.2361),
  ('unknown', 'aspect', 3.29512, 4.1826, 0.2034),
  ('unknown', 'aspect', 4.1826, 4.84014, 0.2335),
  ('unknown', 'aspect', 4.84014, 5.30909, 0.2645),
  ('unknown', 'aspect', 5.30909, 6.73899, 0.2388),
  ('unknown', 'aspect', 6.73899, 8.55399, 0.09068),
  ('unknown', 'aspect', 8.55399, 100, 0.003581);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.0964867, 2.062),
  ('unknown', 'behind', 0.0964867, 0.157976, 0.3689),
  ('unknown', 'behind', 0.157976, 0.192973, 0.4144),
  ('unknown', 'behind', 0.192973, 0.28946, 0.4656),
  ('unknown', 'behind', 0.28946, 0.381579, 0.5648),
  ('unknown', 'behind', 0.381579, 0.385947, 0.9135),
  ('unknown', 'behind', 0.385947, 0.482434, 0.8181),
  ('unknown', 'behind', 0.482434, 0.510158, 1.072),
  ('unknown', 'behind', 0.510158, 0.57892, 1.016),
  ('unknown', 'behind', 0.57892, 0.608134, 1.349),
  ('unknown', 'behind', 0.608134, 0.675407, 1.411),
  ('unknown', 'behind', 0.675407, 0.685714, 1.656),
  ('unknown', 'behind', 0.685714, 0.748428, 1.776),
  ('unknown', 'behind', 0.748428, 0.771894, 2.112),
  ('unknown', 'behind', 0.771894, 0.8, 2.192),
  ('unknown', 'behind', 0.8, 0.868381, 1.529),
  ('unknown', 'behind', 0.868381, 1, 0.04487);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free', 0, 0.111111, 1.931),
  ('unknown', 'edge_free', 0.111111, 0.124533, 0.5741),
  ('unknown', 'edge_free', 0.124533, 0.222222, 0.6904),
  ('unknown', 'edge_free', 0.222222, 0.281053, 0.7526),
  ('unknown', 'edge_free', 0.281053, 0.333333, 0.8754),
  ('unknown', 'edge_free', 0.333333, 0.393102, 1.089),
  ('unknown', 'edge_free', 0.393102, 0.444444, 1.256),
  ('unknown', 'edge_free', 0.444444, 0.477323, 1.414),
  ('unknown', 'edge_free', 0.477323, 0.555556, 1.27),
  ('unknown', 'edge_free', 0.555556, 0.566944, 0.991),
  ('unknown', 'edge_free', 0.566944, 0.666667, 0.9109),
  ('unknown', 'edge_free', 0.666667, 0.691095, 0.826),
  ('unknown', 'edge_free', 0.691095, 0.777778, 0.7145),
  ('unknown', 'edge_free', 0.777778, 0.88596, 0.4595),
  ('unknown', 'edge_free', 0.88596, 0.888889, 0.3594),
  ('unknown', 'edge_free', 0.888889, 1, 0.9883);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free_top', 0, 0.0132008, 16.85),
  ('unknown', 'edge_free_top', 0.0132008, 0.111111, 0.4113),
  ('unknown', 'edge_free_top', 0.111111, 0.222222, 0.3862),
  ('unknown', 'edge_free_top', 0.222222, 0.304496, 0.3266),
  ('unknown', 'edge_free_top', 0.304496, 0.333333, 0.3654),
  ('unknown', 'edge_free_top', 0.333333, 0.444444, 0.3549),
  ('unknown', 'edge_free_top', 0.444444, 0.555556, 0.4268),
  ('unknown', 'edge_free_top', 0.555556, 0.589109, 0.4189),
  ('unknown', 'edge_free_top', 0.589109, 0.666667, 0.4598),
  ('unknown', 'edge_free_top', 0.666667, 0.777778, 0.6031),
  ('unknown', 'edge_free_top', 0.777778, 0.788724, 0.7553),
  ('unknown', 'edge_free_top', 0.788724, 0.888889, 0.7899),
  ('unknown', 'edge_free_top', 0.888889, 0.920326, 1.053),
  ('unknown', 'edge_free_top', 0.920326, 1, 4.178);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_joined', 0, 0.0124794, 17.78),
  ('unknown', 'edge_joined', 0.0124794, 0.0524238, 2.77),
  ('unknown', 'edge_joined', 0.0524238, 0.111111, 1.572),
  ('unknown', 'edge_joined', 0.111111, 0.128461, 1.063),
  ('unknown', 'edge_joined', 0.128461, 0.222222, 0.9719),
  ('unknown', 'edge_joined', 0.222222, 0.244802, 0.9122),
  ('unknown', 'edge_joined', 0.244802, 0.333333, 0.7818),
  ('unknown', 'edge_joined', 0.333333, 0.394702, 0.6894),
  ('unknown', 'edge_joined', 0.394702, 0.444444, 0.5899),
  ('unknown', 'edge_joined', 0.444444, 0.555556, 0.5175),
  ('unknown', 'edge_joined', 0.555556, 0.604682, 0.5052),
  ('unknown', 'edge_joined', 0.604682, 0.666667, 0.4657),
  ('unknown', 'edge_joined', 0.666667, 0.777778, 0.3986),
  ('unknown', 'edge_joined', 0.777778, 0.862561, 0.4454),
  ('unknown', 'edge_joined', 0.862561, 0.888889, 0.4458),
  ('unknown', 'edge_joined', 0.888889, 1, 0.8927);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0720375, 0.009549),
  ('unknown', 'height', 0.0720375, 0.232199, 0.6476),
  ('unknown', 'height', 0.232199, 0.393322, 0.4731),
  ('unknown', 'height', 0.393322, 0.433183, 0.8208),
  ('unknown', 'height', 0.433183, 0.651317, 0.526),
  ('unknown', 'height', 0.651317, 0.714607, 0.4123),
  ('unknown', 'height', 0.714607, 0.830584, 0.7412),
  ('unknown', 'height', 0.830584, 0.960451, 0.8514),
  ('unknown', 'height', 0.960451, 1.03589, 0.4987),
  ('unknown', 'height', 1.03589, 1.25773, 0.3299),
  ('unknown', 'height', 1.25773, 1.35718, 0.3581),
  ('unknown', 'height', 1.35718, 1.55482, 0.3798),
  ('unknown', 'height', 1.55482, 1.67846, 0.3797),
  ('unknown', 'height', 1.67846, 1.99975, 0.1599),
  ('unknown', 'height', 1.99975, 2.0828, 0.1634),
  ('unknown', 'height', 2.0828, 2.32103, 0.1862),
  ('unknown', 'height', 2.32103, 2.64232, 0.1173),
  ('unknown', 'height', 2.64232, 2.9636, 0.06202),
  ('unknown', 'height', 2.9636, 4, 0.008846);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.190079, 0.004342),
  ('unknown', 'length', 0.190079, 0.289062, 0.1505),
  ('unknown', 'length', 0.289062, 0.323874, 0.358),
  ('unknown', 'length', 0.323874, 0.406602, 0.4836),
  ('unknown', 'length', 0.406602, 0.43959, 0.5773),
  ('unknown', 'length', 0.43959, 0.488955, 0.6066),
  ('unknown', 'length', 0.488955, 0.594806, 0.5724),
  ('unknown', 'length', 0.594806, 0.668505, 0.5415),
  ('unknown', 'length', 0.668505, 0.741434, 0.4696),
  ('unknown', 'length', 0.741434, 0.922567, 0.5126),
  ('unknown', 'length', 0.922567, 1.01663, 0.4798),
  ('unknown', 'length', 1.01663, 1.18854, 0.4101),
  ('unknown', 'length', 1.18854, 1.49631, 0.4786),
  ('unknown', 'length', 1.49631, 1.54603, 0.4176),
  ('unknown', 'length', 1.54603, 2.35112, 0.1352),
  ('unknown', 'length', 2.35112, 3.57545, 0.02519),
  ('unknown', 'length', 3.57545, 5.43736, 0.02526),
  ('unknown', 'length', 5.43736, 8.26884, 0.02567),
  ('unknown', 'length', 8.26884, 30, 0.007279);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.346965, 0.02799),
  ('unknown', 'rectangularity', 0.346965, 0.415476, 0.2176),
  ('unknown', 'rectangularity', 0.415476, 0.483987, 0.4296),
  ('unknown', 'rectangularity', 0.483987, 0.544408, 0.9282),
  ('unknown', 'rectangularity', 0.544408, 0.552498, 1.338),
  ('unknown', 'rectangularity', 0.552498, 0.620049, 1.499),
  ('unknown', 'rectangularity', 0.620049, 0.675641, 1.99),
  ('unknown', 'rectangularity', 0.675641, 0.68952, 2.563),
  ('unknown', 'rectangularity', 0.68952, 0.719456, 2.532),
  ('unknown', 'rectangularity', 0.719456, 0.758031, 2.592),
  ('unknown', 'rectangularity', 0.758031, 0.76213, 2.886),
  ('unknown', 'rectangularity', 0.76213, 0.79668, 3.216),
  ('unknown', 'rectangularity', 0.79668, 0.826542, 2.944),
  ('unknown', 'rectangularity', 0.826542, 0.834594, 2.875),
  ('unknown', 'rectangularity', 0.834594, 0.880025, 2.457),
  ('unknown', 'rectangularity', 0.880025, 0.895053, 1.823),
  ('unknown', 'rectangularity', 0.895053, 0.963564, 1.119),
  ('unknown', 'rectangularity', 0.963564, 1, 0.1699);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.164579, 0.002452),
  ('unknown', 'spread_length', 0.164579, 0.252758, 0.1596),
  ('unknown', 'spread_length', 0.252758, 0.273857, 0.4554),
  ('unknown', 'spread_length', 0.273857, 0.327208, 0.6167),
  ('unknown', 'spread_length', 0.327208, 0.388183, 0.612),
  ('unknown', 'spread_length', 0.388183, 0.395391, 0.4561),
  ('unknown', 'spread_length', 0.395391, 0.484516, 0.5405),
  ('unknown', 'spread_length', 0.484516, 0.596166, 0.406),
  ('unknown', 'spread_length', 0.596166, 0.635673, 0.4202),
  ('unknown', 'spread_length', 0.635673, 0.799584, 0.4819),
  ('unknown', 'spread_length', 0.799584, 0.915585, 0.4538),
  ('unknown', 'spread_length', 0.915585, 1.04774, 0.3729),
  ('unknown', 'spread_length', 1.04774, 1.33905, 0.4527),
  ('unknown', 'spread_length', 1.33905, 1.40614, 0.3873),
  ('unknown', 'spread_length', 1.40614, 2.15954, 0.1191),
  ('unknown', 'spread_length', 2.15954, 3.3166, 0.02304),
  ('unknown', 'spread_length', 3.3166, 5.09359, 0.0236),
  ('unknown', 'spread_length', 5.09359, 7.82267, 0.02718),
  ('unknown', 'spread_length', 7.82267, 40, 0.005719);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.110488, 0.0008006),
  ('unknown', 'spread_width', 0.110488, 0.158966, 0.3),
  ('unknown', 'spread_width', 0.158966, 0.167906, 0.5839),
  ('unknown', 'spread_width', 0.167906, 0.189721, 0.6456),
  ('unknown', 'spread_width', 0.189721, 0.211785, 1.006),
  ('unknown', 'spread_width', 0.211785, 0.23214, 1.199),
  ('unknown', 'spread_width', 0.23214, 0.255163, 0.7677),
  ('unknown', 'spread_width', 0.255163, 0.269245, 0.7228),
  ('unknown', 'spread_width', 0.269245, 0.3174, 0.6763),
  ('unknown', 'spread_width', 0.3174, 0.387766, 0.4625),
  ('unknown', 'spread_width', 0.387766, 0.407439, 0.3814),
  ('unknown', 'spread_width', 0.407439, 0.585914, 0.3054),
  ('unknown', 'spread_width', 0.585914, 0.895513, 0.1652),
  ('unknown', 'spread_width', 0.895513, 1.36089, 0.02604),
  ('unknown', 'spread_width', 1.36089, 2.06812, 0.0156),
  ('unknown', 'spread_width', 2.06812, 3.14287, 0.01453),
  ('unknown', 'spread_width', 3.14287, 4.77615, 0.02064),
  ('unknown', 'spread_width', 4.77615, 20, 0.006361);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 0.916743, 0.1193),
  ('unknown', 'tilt_deg', 0.916743, 2.76292, 0.06043),
  ('unknown', 'tilt_deg', 2.76292, 10, 0.009255),
  ('unknown', 'tilt_deg', 10, 20, 0.001159),
  ('unknown', 'tilt_deg', 20, 30, 0.0002681),
  ('unknown', 'tilt_deg', 30, 40, 0.0001599),
  ('unknown', 'tilt_deg', 40, 50, 0.0001173),
  ('unknown', 'tilt_deg', 50, 60, 0.0001197),
  ('unknown', 'tilt_deg', 60, 70, 0.0005191),
  ('unknown', 'tilt_deg', 70, 76.4213, 0.003466),
  ('unknown', 'tilt_deg', 76.4213, 80, 0.004876),
  ('unknown', 'tilt_deg', 80, 88.096, 0.01183),
  ('unknown', 'tilt_deg', 88.096, 89.3079, 0.0982),
  ('unknown', 'tilt_deg', 89.3079, 89.7254, 0.403),
  ('unknown', 'tilt_deg', 89.7254, 89.8865, 0.8866),
  ('unknown', 'tilt_deg', 89.8865, 90, 1.085);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.132491, 0.002596),
  ('unknown', 'width', 0.132491, 0.194657, 0.272),
  ('unknown', 'width', 0.194657, 0.198918, 0.4766),
  ('unknown', 'width', 0.198918, 0.229112, 0.7154),
  ('unknown', 'width', 0.229112, 0.259608, 0.8867),
  ('unknown', 'width', 0.259608, 0.298649, 0.7467),
  ('unknown', 'width', 0.298649, 0.342366, 0.8504),
  ('unknown', 'width', 0.342366, 0.40157, 0.7025),
  ('unknown', 'width', 0.40157, 0.448383, 0.5374),
  ('unknown', 'width', 0.448383, 0.503036, 0.4452),
  ('unknown', 'width', 0.503036, 0.673189, 0.3195),
  ('unknown', 'width', 0.673189, 0.715516, 0.3251),
  ('unknown', 'width', 0.715516, 1.01071, 0.1934),
  ('unknown', 'width', 1.01071, 1.51744, 0.02927),
  ('unknown', 'width', 1.51744, 2.27825, 0.01773),
  ('unknown', 'width', 2.27825, 3.42049, 0.01797),
  ('unknown', 'width', 3.42049, 5.13542, 0.01984),
  ('unknown', 'width', 5.13542, 12, 0.01051);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.111481, 0.01194),
  ('unknown', 'z_max', 0.111481, 0.430945, 0.334),
  ('unknown', 'z_max', 0.430945, 0.543539, 0.4406),
  ('unknown', 'z_max', 0.543539, 0.70008, 0.3815),
  ('unknown', 'z_max', 0.70008, 0.79618, 1.131),
  ('unknown', 'z_max', 0.79618, 0.940578, 0.7796),
  ('unknown', 'z_max', 0.940578, 0.975596, 0.6636),
  ('unknown', 'z_max', 0.975596, 1.12063, 0.6067),
  ('unknown', 'z_max', 1.12063, 1.40765, 0.3059),
  ('unknown', 'z_max', 1.40765, 1.54079, 0.1738),
  ('unknown', 'z_max', 1.54079, 1.83971, 0.2095),
  ('unknown', 'z_max', 1.83971, 2.01245, 0.2813),
  ('unknown', 'z_max', 2.01245, 2.27177, 0.4047),
  ('unknown', 'z_max', 2.27177, 2.29612, 0.2532),
  ('unknown', 'z_max', 2.29612, 2.70383, 0.1544),
  ('unknown', 'z_max', 2.70383, 3.13588, 0.04673),
  ('unknown', 'z_max', 3.13588, 3.56794, 0.0106),
  ('unknown', 'z_max', 3.56794, 4, 0.05352);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.130186, 0.05971),
  ('unknown', 'z_min', -0.130186, -0.0163246, 0.8547),
  ('unknown', 'z_min', -0.0163246, 0.0367586, 1.933),
  ('unknown', 'z_min', 0.0367586, 0.239627, 0.4409),
  ('unknown', 'z_min', 0.239627, 0.324336, 0.2493),
  ('unknown', 'z_min', 0.324336, 0.609441, 0.2978),
  ('unknown', 'z_min', 0.609441, 0.668498, 0.4761),
  ('unknown', 'z_min', 0.668498, 0.762825, 1.159),
  ('unknown', 'z_min', 0.762825, 0.905096, 0.7845),
  ('unknown', 'z_min', 0.905096, 0.979254, 0.488),
  ('unknown', 'z_min', 0.979254, 1.21643, 0.3126),
  ('unknown', 'z_min', 1.21643, 1.34907, 0.3572),
  ('unknown', 'z_min', 1.34907, 1.71888, 0.1438),
  ('unknown', 'z_min', 1.71888, 1.90238, 0.06421),
  ('unknown', 'z_min', 1.90238, 2.0887, 0.09023),
  ('unknown', 'z_min', 2.0887, 2.45851, 0.1489),
  ('unknown', 'z_min', 2.45851, 2.82832, 0.08139),
  ('unknown', 'z_min', 2.82832, 4, 0.007483);
DELETE FROM class_kind WHERE class = 'unknown';
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.02141, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'area_m2', -2.43, 0.2485),
  ('unknown', 1, 'aspect', 0.249, 0.1992),
  ('unknown', 1, 'behind', 0.6622, 0.1446),
  ('unknown', 1, 'edge_free', 0.5076, 0.1118),
  ('unknown', 1, 'edge_free_top', 0.8321, 0.1436),
  ('unknown', 1, 'edge_joined', 0.1479, 0.1548),
  ('unknown', 1, 'height', 0.1867, 0.0225),
  ('unknown', 1, 'length', -0.8372, 0.1578),
  ('unknown', 1, 'rectangularity', 0.5893, 0.1163),
  ('unknown', 1, 'spread_length', -1.027, 0.1306),
  ('unknown', 1, 'spread_width', -1.541, 0.2027),
  ('unknown', 1, 'tilt_deg', 88.96, 2.024),
  ('unknown', 1, 'width', -1.07, 0.1744),
  ('unknown', 1, 'z_max', 0.3797, 0.04936),
  ('unknown', 1, 'z_min', -0.01748, 0.02253);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.02624, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'area_m2', -1.298, 0.1503),
  ('unknown', 2, 'aspect', 1.695, 0.1806),
  ('unknown', 2, 'behind', 0.2657, 0.2853),
  ('unknown', 2, 'edge_free', 0.9091, 0.1186),
  ('unknown', 2, 'edge_free_top', 0.5712, 0.1287),
  ('unknown', 2, 'edge_joined', 0.08241, 0.1099),
  ('unknown', 2, 'height', 2.522, 0.2722),
  ('unknown', 2, 'length', 0.2884, 0.1122),
  ('unknown', 2, 'rectangularity', 0.85, 0.05074),
  ('unknown', 2, 'spread_length', 0.2345, 0.1323),
  ('unknown', 2, 'spread_width', -1.543, 0.05739),
  ('unknown', 2, 'tilt_deg', 1.44, 1.615),
  ('unknown', 2, 'width', -1.428, 0.1175),
  ('unknown', 2, 'z_max', 2.545, 0.3007),
  ('unknown', 2, 'z_min', 2.533, 0.2909);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.02475, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'area_m2', -1.819, 0.3605),
  ('unknown', 3, 'aspect', 0.3617, 0.1909),
  ('unknown', 3, 'behind', 0.624, 0.1841),
  ('unknown', 3, 'edge_free', 0.4072, 0.1704),
  ('unknown', 3, 'edge_free_top', 0.5922, 0.2607),
  ('unknown', 3, 'edge_joined', 0.2696, 0.2346),
  ('unknown', 3, 'height', 0.2331, 0.05317),
  ('unknown', 3, 'length', -0.4535, 0.1733),
  ('unknown', 3, 'rectangularity', 0.5412, 0.1511),
  ('unknown', 3, 'spread_length', -0.6542, 0.1827),
  ('unknown', 3, 'spread_width', -1.095, 0.2127),
  ('unknown', 3, 'tilt_deg', 88.57, 1.281),
  ('unknown', 3, 'width', -0.7885, 0.191),
  ('unknown', 3, 'z_max', 0.4954, 0.07571),
  ('unknown', 3, 'z_min', -0.01181, 0.04004);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.03985, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'area_m2', -1.388, 0.5382),
  ('unknown', 4, 'aspect', 0.3921, 0.2651),
  ('unknown', 4, 'behind', 0.007619, 0.03),
  ('unknown', 4, 'edge_free', 0.01936, 0.0362),
  ('unknown', 4, 'edge_free_top', 0.0377, 0.06989),
  ('unknown', 4, 'edge_joined', 0.893, 0.1266),
  ('unknown', 4, 'height', 1.631, 0.08874),
  ('unknown', 4, 'length', -0.3896, 0.2396),
  ('unknown', 4, 'rectangularity', 0.8283, 0.07168),
  ('unknown', 4, 'spread_length', -0.5811, 0.2491),
  ('unknown', 4, 'spread_width', -1.092, 0.2992),
  ('unknown', 4, 'tilt_deg', 89.66, 0.9219),
  ('unknown', 4, 'width', -0.8011, 0.3487),
  ('unknown', 4, 'z_max', 1.976, 0.168),
  ('unknown', 4, 'z_min', 1.339, 0.06744);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.03797, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'area_m2', -2.479, 0.311),
  ('unknown', 5, 'aspect', 0.4637, 0.2565),
  ('unknown', 5, 'behind', 0.5929, 0.2973),
  ('unknown', 5, 'edge_free', 0.7398, 0.09925),
  ('unknown', 5, 'edge_free_top', 0.5725, 0.1272),
  ('unknown', 5, 'edge_joined', 0.3019, 0.1367),
  ('unknown', 5, 'height', 0.6459, 0.3142),
  ('unknown', 5, 'length', -0.9056, 0.1466),
  ('unknown', 5, 'rectangularity', 0.8091, 0.08904),
  ('unknown', 5, 'spread_length', -1.08, 0.149),
  ('unknown', 5, 'spread_width', -1.472, 0.2016),
  ('unknown', 5, 'tilt_deg', 1.118, 1.577),
  ('unknown', 5, 'width', -1.335, 0.2255),
  ('unknown', 5, 'z_max', 0.6238, 0.3315),
  ('unknown', 5, 'z_min', 0.6209, 0.3317);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.03222, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'area_m2', -2.884, 0.2604),
  ('unknown', 6, 'aspect', 0.565, 0.2426),
  ('unknown', 6, 'behind', 0.496, 0.2012),
  ('unknown', 6, 'edge_free', 0.3308, 0.2595),
  ('unknown', 6, 'edge_free_top', 0.488, 0.4233),
  ('unknown', 6, 'edge_joined', 0.2017, 0.2177),
  ('unknown', 6, 'height', 0.2231, 0.08153),
  ('unknown', 6, 'length', -0.9592, 0.2814),
  ('unknown', 6, 'rectangularity', 0.6739, 0.131),
  ('unknown', 6, 'spread_length', -1.193, 0.2941),
  ('unknown', 6, 'spread_width', -1.783, 0.2073),
  ('unknown', 6, 'tilt_deg', 86.67, 4.204),
  ('unknown', 6, 'width', -1.525, 0.2035),
  ('unknown', 6, 'z_max', 0.3993, 0.06833),
  ('unknown', 6, 'z_min', 0.05086, 0.105);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.02897, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'area_m2', -2.64, 0.2603),
  ('unknown', 7, 'aspect', 0.5977, 0.3192),
  ('unknown', 7, 'behind', 0.5901, 0.1722),
  ('unknown', 7, 'edge_free', 0.5966, 0.08918),
  ('unknown', 7, 'edge_free_top', 0.9757, 0.04734),
  ('unknown', 7, 'edge_joined', 0.03422, 0.04771),
  ('unknown', 7, 'height', 0.8527, 0.04589),
  ('unknown', 7, 'length', -0.8742, 0.2914),
  ('unknown', 7, 'rectangularity', 0.6871, 0.08426),
  ('unknown', 7, 'spread_length', -1.28, 0.1394),
  ('unknown', 7, 'spread_width', -1.557, 0.1528),
  ('unknown', 7, 'tilt_deg', 82.52, 8.942),
  ('unknown', 7, 'width', -1.403, 0.1561),
  ('unknown', 7, 'z_max', 0.9617, 0.05674),
  ('unknown', 7, 'z_min', 0.727, 0.05624);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.04025, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'area_m2', -2.817, 0.2605),
  ('unknown', 8, 'aspect', 0.2746, 0.1434),
  ('unknown', 8, 'behind', 0.2703, 0.1935),
  ('unknown', 8, 'edge_free', 0.2667, 0.3118),
  ('unknown', 8, 'edge_free_top', 0.5719, 0.1288),
  ('unknown', 8, 'edge_joined', 0.6646, 0.2649),
  ('unknown', 8, 'height', 0.7717, 0.07296),
  ('unknown', 8, 'length', -1.154, 0.1633),
  ('unknown', 8, 'rectangularity', 0.8123, 0.06592),
  ('unknown', 8, 'spread_length', -1.268, 0.1229),
  ('unknown', 8, 'spread_width', -1.549, 0.07199),
  ('unknown', 8, 'tilt_deg', 0.7055, 0.6246),
  ('unknown', 8, 'width', -1.49, 0.1582),
  ('unknown', 8, 'z_max', 0.7818, 0.08382),
  ('unknown', 8, 'z_min', 0.7721, 0.07895);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.03514, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'area_m2', -1.257, 0.2411),
  ('unknown', 9, 'aspect', 1.709, 0.2251),
  ('unknown', 9, 'behind', 0.6126, 0.2088),
  ('unknown', 9, 'edge_free', 0.226, 0.1991),
  ('unknown', 9, 'edge_free_top', 0.0125, 0.03749),
  ('unknown', 9, 'edge_joined', 0.3871, 0.3198),
  ('unknown', 9, 'height', 1.51, 0.08614),
  ('unknown', 9, 'length', 0.3504, 0.125),
  ('unknown', 9, 'rectangularity', 0.7746, 0.05266),
  ('unknown', 9, 'spread_length', 0.169, 0.157),
  ('unknown', 9, 'spread_width', -1.514, 0.2412),
  ('unknown', 9, 'tilt_deg', 89.85, 0.9041),
  ('unknown', 9, 'width', -1.363, 0.229),
  ('unknown', 9, 'z_max', 2.276, 0.1536),
  ('unknown', 9, 'z_min', 0.8218, 0.09053);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.04283, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'area_m2', -3.51, 0.3445),
  ('unknown', 10, 'aspect', 0.3389, 0.2628),
  ('unknown', 10, 'behind', 0.308, 0.2355),
  ('unknown', 10, 'edge_free', 0.3655, 0.2988),
  ('unknown', 10, 'edge_free_top', 0.4307, 0.351),
  ('unknown', 10, 'edge_joined', 0.4492, 0.3051),
  ('unknown', 10, 'height', 0.7515, 0.3344),
  ('unknown', 10, 'length', -1.465, 0.2333),
  ('unknown', 10, 'rectangularity', 0.789, 0.05786),
  ('unknown', 10, 'spread_length', -1.618, 0.2322),
  ('unknown', 10, 'spread_width', -1.932, 0.1505),
  ('unknown', 10, 'tilt_deg', 22.29, 25.18),
  ('unknown', 10, 'width', -1.792, 0.1681),
  ('unknown', 10, 'z_max', 0.786, 0.3709),
  ('unknown', 10, 'z_min', 0.7111, 0.3435);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.02384, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'area_m2', -2.262, 0.1922),
  ('unknown', 11, 'aspect', 0.4388, 0.2425),
  ('unknown', 11, 'behind', 0.5897, 0.2111),
  ('unknown', 11, 'edge_free', 0.4451, 0.1422),
  ('unknown', 11, 'edge_free_top', 0.7524, 0.2335),
  ('unknown', 11, 'edge_joined', 0.296, 0.1682),
  ('unknown', 11, 'height', 0.8706, 0.03965),
  ('unknown', 11, 'length', -0.7109, 0.1708),
  ('unknown', 11, 'rectangularity', 0.6707, 0.06112),
  ('unknown', 11, 'spread_length', -1.092, 0.1432),
  ('unknown', 11, 'spread_width', -1.32, 0.1623),
  ('unknown', 11, 'tilt_deg', 88.15, 7.069),
  ('unknown', 11, 'width', -1.136, 0.1107),
  ('unknown', 11, 'z_max', 1.076, 0.1232),
  ('unknown', 11, 'z_min', 0.7021, 0.09726);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.03186, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'area_m2', -1.918, 0.3352),
  ('unknown', 12, 'aspect', 0.6435, 0.2917),
  ('unknown', 12, 'behind', 0.5671, 0.2731),
  ('unknown', 12, 'edge_free', 0.4195, 0.2022),
  ('unknown', 12, 'edge_free_top', 0.6282, 0.2241),
  ('unknown', 12, 'edge_joined', 0.3246, 0.151),
  ('unknown', 12, 'height', 1.238, 0.1431),
  ('unknown', 12, 'length', -0.4775, 0.2048),
  ('unknown', 12, 'rectangularity', 0.6883, 0.08886),
  ('unknown', 12, 'spread_length', -0.63, 0.2583),
  ('unknown', 12, 'spread_width', -1.268, 0.3456),
  ('unknown', 12, 'tilt_deg', 87.4, 2.209),
  ('unknown', 12, 'width', -1.059, 0.2489),
  ('unknown', 12, 'z_max', 1.564, 0.136),
  ('unknown', 12, 'z_min', 0.9097, 0.1748);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.03172, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'area_m2', -1.314, 0.4781),
  ('unknown', 13, 'aspect', 0.7075, 0.2703),
  ('unknown', 13, 'behind', 0.7597, 0.1071),
  ('unknown', 13, 'edge_free', 0.1867, 0.1312),
  ('unknown', 13, 'edge_free_top', 0.5693, 0.1312),
  ('unknown', 13, 'edge_joined', 0.7628, 0.1315),
  ('unknown', 13, 'height', 1.249, 0.2435),
  ('unknown', 13, 'length', -0.1175, 0.3103),
  ('unknown', 13, 'rectangularity', 0.7047, 0.1001),
  ('unknown', 13, 'spread_length', -0.1979, 0.2841),
  ('unknown', 13, 'spread_width', -0.8698, 0.2062),
  ('unknown', 13, 'tilt_deg', 4.037, 0.9622),
  ('unknown', 13, 'width', -0.8567, 0.1287),
  ('unknown', 13, 'z_max', 1.267, 0.262),
  ('unknown', 13, 'z_min', 1.235, 0.2606);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.01949, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'area_m2', -1.439, 0.4737),
  ('unknown', 14, 'aspect', 1.63, 0.2699),
  ('unknown', 14, 'behind', 0.648, 0.07233),
  ('unknown', 14, 'edge_free', 0.2222, 0.2171),
  ('unknown', 14, 'edge_free_top', 0.5711, 0.1266),
  ('unknown', 14, 'edge_joined', 0.6712, 0.2176),
  ('unknown', 14, 'height', 2.138, 0.1495),
  ('unknown', 14, 'length', 0.2436, 0.273),
  ('unknown', 14, 'rectangularity', 0.7587, 0.05428),
  ('unknown', 14, 'spread_length', 0.09435, 0.3628),
  ('unknown', 14, 'spread_width', -1.522, 0.2229),
  ('unknown', 14, 'tilt_deg', 1.757, 2.161),
  ('unknown', 14, 'width', -1.412, 0.2515),
  ('unknown', 14, 'z_max', 2.141, 0.1657),
  ('unknown', 14, 'z_min', 2.129, 0.1572);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.03524, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'area_m2', -0.989, 0.3677),
  ('unknown', 15, 'aspect', 1.17, 0.2616),
  ('unknown', 15, 'behind', 0.4999, 0.2077),
  ('unknown', 15, 'edge_free', 0.475, 0.138),
  ('unknown', 15, 'edge_free_top', 0.6419, 0.3453),
  ('unknown', 15, 'edge_joined', 0.1855, 0.2592),
  ('unknown', 15, 'height', 0.89, 0.1602),
  ('unknown', 15, 'length', 0.2679, 0.2009),
  ('unknown', 15, 'rectangularity', 0.6698, 0.1189),
  ('unknown', 15, 'spread_length', 0.1728, 0.2405),
  ('unknown', 15, 'spread_width', -1.052, 0.2248),
  ('unknown', 15, 'tilt_deg', 89.37, 1.065),
  ('unknown', 15, 'width', -0.8549, 0.1981),
  ('unknown', 15, 'z_max', 1.153, 0.1378),
  ('unknown', 15, 'z_min', 0.6556, 0.1087);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.01781, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'area_m2', -2.196, 0.5306),
  ('unknown', 16, 'aspect', 0.5713, 0.2551),
  ('unknown', 16, 'behind', 0.4845, 0.3449),
  ('unknown', 16, 'edge_free', 0.2947, 0.213),
  ('unknown', 16, 'edge_free_top', 0.3536, 0.3045),
  ('unknown', 16, 'edge_joined', 0.4622, 0.1887),
  ('unknown', 16, 'height', 1.783, 0.1755),
  ('unknown', 16, 'length', -0.6447, 0.282),
  ('unknown', 16, 'rectangularity', 0.6635, 0.1134),
  ('unknown', 16, 'spread_length', -0.8712, 0.2248),
  ('unknown', 16, 'spread_width', -1.439, 0.3218),
  ('unknown', 16, 'tilt_deg', 88.93, 2.3),
  ('unknown', 16, 'width', -1.178, 0.3369),
  ('unknown', 16, 'z_max', 2.04, 0.1645),
  ('unknown', 16, 'z_min', 1.543, 0.1916);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.0223, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'area_m2', -2.676, 0.3337),
  ('unknown', 17, 'aspect', 0.5884, 0.3095),
  ('unknown', 17, 'behind', 0.4852, 0.2989),
  ('unknown', 17, 'edge_free', 0.5316, 0.2304),
  ('unknown', 17, 'edge_free_top', 0.4889, 0.2939),
  ('unknown', 17, 'edge_joined', 0.2034, 0.2265),
  ('unknown', 17, 'height', 0.5616, 0.1046),
  ('unknown', 17, 'length', -0.8864, 0.1955),
  ('unknown', 17, 'rectangularity', 0.6758, 0.07543),
  ('unknown', 17, 'spread_length', -1.094, 0.1498),
  ('unknown', 17, 'spread_width', -1.668, 0.3144),
  ('unknown', 17, 'tilt_deg', 86.86, 3.816),
  ('unknown', 17, 'width', -1.406, 0.2774),
  ('unknown', 17, 'z_max', 0.7332, 0.08997),
  ('unknown', 17, 'z_min', 0.3819, 0.1156);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.02543, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'area_m2', -0.3141, 0.2233),
  ('unknown', 18, 'aspect', 0.4917, 0.244),
  ('unknown', 18, 'behind', 0.4485, 0.06213),
  ('unknown', 18, 'edge_free', 0.898, 0.1209),
  ('unknown', 18, 'edge_free_top', 0.9938, 0.03288),
  ('unknown', 18, 'edge_joined', 0.02864, 0.04111),
  ('unknown', 18, 'height', 0.495, 0.03321),
  ('unknown', 18, 'length', 0.147, 0.2055),
  ('unknown', 18, 'rectangularity', 0.8705, 0.06939),
  ('unknown', 18, 'spread_length', 0.1147, 0.2122),
  ('unknown', 18, 'spread_width', -0.4488, 0.07232),
  ('unknown', 18, 'tilt_deg', 89.69, 1.311),
  ('unknown', 18, 'width', -0.3373, 0.1402),
  ('unknown', 18, 'z_max', 0.7881, 0.06692),
  ('unknown', 18, 'z_min', 0.07985, 0.05372);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.02178, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'area_m2', -0.7739, 0.3236),
  ('unknown', 19, 'aspect', 0.3103, 0.1487),
  ('unknown', 19, 'behind', 0.5289, 0.2166),
  ('unknown', 19, 'edge_free', 0.689, 0.09922),
  ('unknown', 19, 'edge_free_top', 0.9434, 0.08582),
  ('unknown', 19, 'edge_joined', 0.1449, 0.114),
  ('unknown', 19, 'height', 0.4717, 0.05846),
  ('unknown', 19, 'length', -0.09411, 0.1768),
  ('unknown', 19, 'rectangularity', 0.7363, 0.06104),
  ('unknown', 19, 'spread_length', -0.2553, 0.1294),
  ('unknown', 19, 'spread_width', -0.5934, 0.2334),
  ('unknown', 19, 'tilt_deg', 88.33, 3.605),
  ('unknown', 19, 'width', -0.3576, 0.1597),
  ('unknown', 19, 'z_max', 0.745, 0.05814),
  ('unknown', 19, 'z_min', 0.03543, 0.08063);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.03404, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'area_m2', -1.923, 0.4062),
  ('unknown', 20, 'aspect', 0.9955, 0.4043),
  ('unknown', 20, 'behind', 0.5255, 0.1815),
  ('unknown', 20, 'edge_free', 0.2894, 0.2025),
  ('unknown', 20, 'edge_free_top', 0.2831, 0.2539),
  ('unknown', 20, 'edge_joined', 0.2388, 0.3109),
  ('unknown', 20, 'height', 0.4594, 0.1011),
  ('unknown', 20, 'length', -0.2277, 0.2263),
  ('unknown', 20, 'rectangularity', 0.649, 0.1757),
  ('unknown', 20, 'spread_length', -0.2035, 0.2943),
  ('unknown', 20, 'spread_width', -1.49, 0.3577),
  ('unknown', 20, 'tilt_deg', 88.81, 1.551),
  ('unknown', 20, 'width', -1.162, 0.383),
  ('unknown', 20, 'z_max', 0.7282, 0.1669),
  ('unknown', 20, 'z_min', 0.2081, 0.09762);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.01933, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'area_m2', -2.918, 0.2912),
  ('unknown', 21, 'aspect', 0.4883, 0.338),
  ('unknown', 21, 'behind', 0.4822, 0.2103),
  ('unknown', 21, 'edge_free', 0.3764, 0.1883),
  ('unknown', 21, 'edge_free_top', 0.5109, 0.3552),
  ('unknown', 21, 'edge_joined', 0.3718, 0.2059),
  ('unknown', 21, 'height', 1.135, 0.2413),
  ('unknown', 21, 'length', -1.067, 0.2177),
  ('unknown', 21, 'rectangularity', 0.7309, 0.08171),
  ('unknown', 21, 'spread_length', -1.278, 0.1691),
  ('unknown', 21, 'spread_width', -1.732, 0.2447),
  ('unknown', 21, 'tilt_deg', 88.7, 1.978),
  ('unknown', 21, 'width', -1.531, 0.2383),
  ('unknown', 21, 'z_max', 1.294, 0.2691),
  ('unknown', 21, 'z_min', 1.006, 0.2058);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.02725, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'area_m2', -1.638, 0.2333),
  ('unknown', 22, 'aspect', 0.6066, 0.2541),
  ('unknown', 22, 'behind', 0.7589, 0.0822),
  ('unknown', 22, 'edge_free', 0.3371, 0.1406),
  ('unknown', 22, 'edge_free_top', 0.5713, 0.1273),
  ('unknown', 22, 'edge_joined', 0.4316, 0.1559),
  ('unknown', 22, 'height', 0.6811, 0.2021),
  ('unknown', 22, 'length', -0.2954, 0.2487),
  ('unknown', 22, 'rectangularity', 0.6557, 0.09111),
  ('unknown', 22, 'spread_length', -0.3914, 0.2645),
  ('unknown', 22, 'spread_width', -1.145, 0.1793),
  ('unknown', 22, 'tilt_deg', 5.805, 1.669),
  ('unknown', 22, 'width', -0.9084, 0.1633),
  ('unknown', 22, 'z_max', 0.7008, 0.1837),
  ('unknown', 22, 'z_min', 0.6621, 0.2025);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.01247, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'area_m2', -2.79, 0.4448),
  ('unknown', 23, 'aspect', 0.4167, 0.3694),
  ('unknown', 23, 'behind', 0.4256, 0.2729),
  ('unknown', 23, 'edge_free', 0.641, 0.1298),
  ('unknown', 23, 'edge_free_top', 0.9845, 0.03769),
  ('unknown', 23, 'edge_joined', 0.02394, 0.03557),
  ('unknown', 23, 'height', 1.205, 0.1473),
  ('unknown', 23, 'length', -1.016, 0.322),
  ('unknown', 23, 'rectangularity', 0.7216, 0.09496),
  ('unknown', 23, 'spread_length', -1.317, 0.1943),
  ('unknown', 23, 'spread_width', -1.652, 0.2349),
  ('unknown', 23, 'tilt_deg', 88.78, 3.15),
  ('unknown', 23, 'width', -1.45, 0.293),
  ('unknown', 23, 'z_max', 1.367, 0.1819),
  ('unknown', 23, 'z_min', 1.055, 0.1244);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.02963, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'area_m2', -0.9207, 0.3934),
  ('unknown', 24, 'aspect', 0.3042, 0.2458),
  ('unknown', 24, 'behind', 0.6529, 0.2098),
  ('unknown', 24, 'edge_free', 0.2884, 0.1239),
  ('unknown', 24, 'edge_free_top', 0.2842, 0.1258),
  ('unknown', 24, 'edge_joined', 0.3707, 0.3366),
  ('unknown', 24, 'height', 0.4072, 0.1176),
  ('unknown', 24, 'length', -0.04681, 0.189),
  ('unknown', 24, 'rectangularity', 0.5656, 0.1006),
  ('unknown', 24, 'spread_length', -0.1931, 0.2192),
  ('unknown', 24, 'spread_width', -0.6361, 0.2818),
  ('unknown', 24, 'tilt_deg', 89.25, 1.658),
  ('unknown', 24, 'width', -0.3358, 0.1743),
  ('unknown', 24, 'z_max', 0.7453, 0.04963),
  ('unknown', 24, 'z_min', 0.00423, 0.05017);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.02079, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'area_m2', -0.6479, 0.3643),
  ('unknown', 25, 'aspect', 0.4113, 0.1884),
  ('unknown', 25, 'behind', 0.1914, 0.1528),
  ('unknown', 25, 'edge_free', 0.875, 0.1009),
  ('unknown', 25, 'edge_free_top', 0.9128, 0.1274),
  ('unknown', 25, 'edge_joined', 0.04879, 0.06758),
  ('unknown', 25, 'height', 1.547, 0.2058),
  ('unknown', 25, 'length', -0.008731, 0.2349),
  ('unknown', 25, 'rectangularity', 0.7698, 0.1587),
  ('unknown', 25, 'spread_length', -0.09562, 0.2622),
  ('unknown', 25, 'spread_width', -0.6122, 0.1917),
  ('unknown', 25, 'tilt_deg', 88.39, 1.581),
  ('unknown', 25, 'width', -0.37, 0.1586),
  ('unknown', 25, 'z_max', 1.929, 0.1941),
  ('unknown', 25, 'z_min', 1.303, 0.1594);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.02022, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'area_m2', -1.449, 0.2029),
  ('unknown', 26, 'aspect', 0.262, 0.2021),
  ('unknown', 26, 'behind', 0.5817, 0.2664),
  ('unknown', 26, 'edge_free', 0.6091, 0.1628),
  ('unknown', 26, 'edge_free_top', 0.8242, 0.2186),
  ('unknown', 26, 'edge_joined', 0.2784, 0.1154),
  ('unknown', 26, 'height', 0.7696, 0.1519),
  ('unknown', 26, 'length', -0.3956, 0.1655),
  ('unknown', 26, 'rectangularity', 0.7143, 0.0944),
  ('unknown', 26, 'spread_length', -0.4875, 0.1998),
  ('unknown', 26, 'spread_width', -0.9206, 0.1239),
  ('unknown', 26, 'tilt_deg', 78.72, 7.367),
  ('unknown', 26, 'width', -0.6962, 0.1654),
  ('unknown', 26, 'z_max', 1.082, 0.1819),
  ('unknown', 26, 'z_min', 0.4315, 0.1136);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.01078, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'area_m2', -1.733, 0.3211),
  ('unknown', 27, 'aspect', 0.5205, 0.3206),
  ('unknown', 27, 'behind', 0.3741, 0.1243),
  ('unknown', 27, 'edge_free', 0.8615, 0.1734),
  ('unknown', 27, 'edge_free_top', 0.9844, 0.03743),
  ('unknown', 27, 'edge_joined', 0.01076, 0.03),
  ('unknown', 27, 'height', 0.672, 0.2001),
  ('unknown', 27, 'length', -0.42, 0.1953),
  ('unknown', 27, 'rectangularity', 0.6502, 0.09692),
  ('unknown', 27, 'spread_length', -0.5735, 0.2958),
  ('unknown', 27, 'spread_width', -1.135, 0.2216),
  ('unknown', 27, 'tilt_deg', 85.91, 6.464),
  ('unknown', 27, 'width', -0.9132, 0.2423),
  ('unknown', 27, 'z_max', 0.9408, 0.2533),
  ('unknown', 27, 'z_min', 0.4294, 0.1439);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.02261, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'area_m2', -2.18, 0.3991),
  ('unknown', 28, 'aspect', 1.084, 0.2844),
  ('unknown', 28, 'behind', 0.5839, 0.2887),
  ('unknown', 28, 'edge_free', 0.3722, 0.203),
  ('unknown', 28, 'edge_free_top', 0.4333, 0.3445),
  ('unknown', 28, 'edge_joined', 0.4461, 0.2475),
  ('unknown', 28, 'height', 0.8615, 0.4292),
  ('unknown', 28, 'length', -0.2919, 0.2822),
  ('unknown', 28, 'rectangularity', 0.6587, 0.0954),
  ('unknown', 28, 'spread_length', -0.3807, 0.3156),
  ('unknown', 28, 'spread_width', -1.713, 0.2257),
  ('unknown', 28, 'tilt_deg', 17.18, 5.515),
  ('unknown', 28, 'width', -1.436, 0.2915),
  ('unknown', 28, 'z_max', 0.919, 0.4699),
  ('unknown', 28, 'z_min', 0.8128, 0.4417);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.02172, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'area_m2', -0.2818, 0.7488),
  ('unknown', 29, 'aspect', 0.8815, 0.5347),
  ('unknown', 29, 'behind', 0.5978, 0.3077),
  ('unknown', 29, 'edge_free', 0.2638, 0.2288),
  ('unknown', 29, 'edge_free_top', 0.2657, 0.1885),
  ('unknown', 29, 'edge_joined', 0.6469, 0.1846),
  ('unknown', 29, 'height', 1.145, 0.2511),
  ('unknown', 29, 'length', 0.6995, 0.185),
  ('unknown', 29, 'rectangularity', 0.5267, 0.175),
  ('unknown', 29, 'spread_length', 0.547, 0.1924),
  ('unknown', 29, 'spread_width', -0.4584, 0.7645),
  ('unknown', 29, 'tilt_deg', 88.64, 0.8884),
  ('unknown', 29, 'width', -0.3221, 0.6172),
  ('unknown', 29, 'z_max', 2.116, 0.2766),
  ('unknown', 29, 'z_min', 0.1196, 0.1815);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.02078, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'area_m2', -1.429, 0.371),
  ('unknown', 30, 'aspect', 1.614, 0.3486),
  ('unknown', 30, 'behind', 0.6911, 0.09434),
  ('unknown', 30, 'edge_free', 0.09994, 0.1349),
  ('unknown', 30, 'edge_free_top', 0.572, 0.1277),
  ('unknown', 30, 'edge_joined', 0.8235, 0.157),
  ('unknown', 30, 'height', 0.8908, 0.08425),
  ('unknown', 30, 'length', 0.2636, 0.3032),
  ('unknown', 30, 'rectangularity', 0.7475, 0.06991),
  ('unknown', 30, 'spread_length', 0.08465, 0.3885),
  ('unknown', 30, 'spread_width', -1.403, 0.2229),
  ('unknown', 30, 'tilt_deg', 2.543, 2.305),
  ('unknown', 30, 'width', -1.375, 0.2028),
  ('unknown', 30, 'z_max', 0.9001, 0.09057),
  ('unknown', 30, 'z_min', 0.8798, 0.08896);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.0172, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'area_m2', -2.236, 0.5029),
  ('unknown', 31, 'aspect', 0.9894, 0.3495),
  ('unknown', 31, 'behind', 0.2551, 0.2722),
  ('unknown', 31, 'edge_free', 0.9878, 0.03),
  ('unknown', 31, 'edge_free_top', 0.5713, 0.1285),
  ('unknown', 31, 'edge_joined', 0.009854, 0.03),
  ('unknown', 31, 'height', 2.509, 0.2688),
  ('unknown', 31, 'length', -0.4971, 0.4175),
  ('unknown', 31, 'rectangularity', 0.7731, 0.09811),
  ('unknown', 31, 'spread_length', -0.6315, 0.4038),
  ('unknown', 31, 'spread_width', -1.622, 0.1061),
  ('unknown', 31, 'tilt_deg', 1.714, 2.148),
  ('unknown', 31, 'width', -1.5, 0.1033),
  ('unknown', 31, 'z_max', 2.549, 0.2712),
  ('unknown', 31, 'z_min', 2.536, 0.2682);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.01326, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'area_m2', -1.752, 0.8846),
  ('unknown', 32, 'aspect', 1.173, 0.5689),
  ('unknown', 32, 'behind', 0.5574, 0.1994),
  ('unknown', 32, 'edge_free', 0.5233, 0.2402),
  ('unknown', 32, 'edge_free_top', 0.2172, 0.3442),
  ('unknown', 32, 'edge_joined', 0.2996, 0.2576),
  ('unknown', 32, 'height', 2.472, 0.3789),
  ('unknown', 32, 'length', -0.09026, 0.673),
  ('unknown', 32, 'rectangularity', 0.638, 0.1543),
  ('unknown', 32, 'spread_length', -0.1544, 0.7096),
  ('unknown', 32, 'spread_width', -1.552, 0.3103),
  ('unknown', 32, 'tilt_deg', 30.79, 39.63),
  ('unknown', 32, 'width', -1.202, 0.3728),
  ('unknown', 32, 'z_max', 2.571, 0.405),
  ('unknown', 32, 'z_min', 2.46, 0.2821);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.01029, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'area_m2', -2.972, 0.3881),
  ('unknown', 33, 'aspect', 0.3448, 0.2014),
  ('unknown', 33, 'behind', 0.4624, 0.2371),
  ('unknown', 33, 'edge_free', 0.634, 0.148),
  ('unknown', 33, 'edge_free_top', 0.9628, 0.06593),
  ('unknown', 33, 'edge_joined', 0.06313, 0.1073),
  ('unknown', 33, 'height', 1.862, 0.1739),
  ('unknown', 33, 'length', -1.157, 0.2651),
  ('unknown', 33, 'rectangularity', 0.7338, 0.1432),
  ('unknown', 33, 'spread_length', -1.339, 0.1809),
  ('unknown', 33, 'spread_width', -1.701, 0.2085),
  ('unknown', 33, 'tilt_deg', 88.76, 2.418),
  ('unknown', 33, 'width', -1.495, 0.2535),
  ('unknown', 33, 'z_max', 1.997, 0.1732),
  ('unknown', 33, 'z_min', 1.698, 0.1864);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.02146, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'area_m2', -0.3241, 0.2787),
  ('unknown', 34, 'aspect', 0.4136, 0.236),
  ('unknown', 34, 'behind', 0.4611, 0.1498),
  ('unknown', 34, 'edge_free', 0.5471, 0.1941),
  ('unknown', 34, 'edge_free_top', 0.7956, 0.1781),
  ('unknown', 34, 'edge_joined', 0.176, 0.1801),
  ('unknown', 34, 'height', 0.6018, 0.1677),
  ('unknown', 34, 'length', 0.2223, 0.1528),
  ('unknown', 34, 'rectangularity', 0.7319, 0.1042),
  ('unknown', 34, 'spread_length', 0.02596, 0.1426),
  ('unknown', 34, 'spread_width', -0.4269, 0.2326),
  ('unknown', 34, 'tilt_deg', 81.44, 4.203),
  ('unknown', 34, 'width', -0.2162, 0.1971),
  ('unknown', 34, 'z_max', 1.076, 0.268),
  ('unknown', 34, 'z_min', 0.02342, 0.0683);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.008384, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'area_m2', -2.105, 0.3355),
  ('unknown', 35, 'aspect', 1.529, 0.3),
  ('unknown', 35, 'behind', 0.4507, 0.2799),
  ('unknown', 35, 'edge_free', 0.3045, 0.2534),
  ('unknown', 35, 'edge_free_top', 0.3919, 0.3604),
  ('unknown', 35, 'edge_joined', 0.3784, 0.3239),
  ('unknown', 35, 'height', 0.9661, 0.4256),
  ('unknown', 35, 'length', -0.1106, 0.2323),
  ('unknown', 35, 'rectangularity', 0.7319, 0.09897),
  ('unknown', 35, 'spread_length', -0.3037, 0.2469),
  ('unknown', 35, 'spread_width', -1.906, 0.2062),
  ('unknown', 35, 'tilt_deg', 88.85, 3.243),
  ('unknown', 35, 'width', -1.662, 0.2361),
  ('unknown', 35, 'z_max', 1.381, 0.4434),
  ('unknown', 35, 'z_min', 0.6681, 0.2958);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.02551, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'area_m2', 2.625, 0.5868),
  ('unknown', 36, 'aspect', 0.3751, 0.2336),
  ('unknown', 36, 'behind', 0.004615, 0.03),
  ('unknown', 36, 'edge_free', 0.003236, 0.03),
  ('unknown', 36, 'edge_free_top', 0.005665, 0.03),
  ('unknown', 36, 'edge_joined', 0.01789, 0.04235),
  ('unknown', 36, 'height', 1.77, 0.7396),
  ('unknown', 36, 'length', 1.581, 0.2913),
  ('unknown', 36, 'rectangularity', 0.9167, 0.05477),
  ('unknown', 36, 'spread_length', 1.527, 0.3585),
  ('unknown', 36, 'spread_width', 1.124, 0.4054),
  ('unknown', 36, 'tilt_deg', 89.77, 1.19),
  ('unknown', 36, 'width', 1.133, 0.4231),
  ('unknown', 36, 'z_max', 3.782, 1.377),
  ('unknown', 36, 'z_min', -0.281, 0.7803);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.01463, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'area_m2', -1.834, 0.2196),
  ('unknown', 37, 'aspect', 0.2244, 0.1814),
  ('unknown', 37, 'behind', 0.3053, 0.2339),
  ('unknown', 37, 'edge_free', 0.836, 0.12),
  ('unknown', 37, 'edge_free_top', 0.5706, 0.1272),
  ('unknown', 37, 'edge_joined', 0.08042, 0.1087),
  ('unknown', 37, 'height', 0.244, 0.1699),
  ('unknown', 37, 'length', -0.646, 0.1703),
  ('unknown', 37, 'rectangularity', 0.7038, 0.1238),
  ('unknown', 37, 'spread_length', -0.7849, 0.1123),
  ('unknown', 37, 'spread_width', -1.053, 0.169),
  ('unknown', 37, 'tilt_deg', 1.416, 2.436),
  ('unknown', 37, 'width', -0.8653, 0.216),
  ('unknown', 37, 'z_max', 0.2035, 0.1239),
  ('unknown', 37, 'z_min', 0.1942, 0.1052);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.01301, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'area_m2', 3.59, 0.7551),
  ('unknown', 38, 'aspect', 0.6755, 0.5986),
  ('unknown', 38, 'behind', 0.005525, 0.03),
  ('unknown', 38, 'edge_free', 0.01145, 0.03),
  ('unknown', 38, 'edge_free_top', 0.0157, 0.03777),
  ('unknown', 38, 'edge_joined', 0.1286, 0.1416),
  ('unknown', 38, 'height', 2.593, 0.9914),
  ('unknown', 38, 'length', 2.235, 0.239),
  ('unknown', 38, 'rectangularity', 0.7892, 0.1361),
  ('unknown', 38, 'spread_length', 2.15, 0.249),
  ('unknown', 38, 'spread_width', 1.507, 0.5621),
  ('unknown', 38, 'tilt_deg', 89.77, 1.869),
  ('unknown', 38, 'width', 1.59, 0.5934),
  ('unknown', 38, 'z_max', 7.531, 1.849),
  ('unknown', 38, 'z_min', -1.507, 1.464);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.009958, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'area_m2', -0.09387, 0.6363),
  ('unknown', 39, 'aspect', 0.6443, 0.4369),
  ('unknown', 39, 'behind', 0.6515, 0.1265),
  ('unknown', 39, 'edge_free', 0.219, 0.1699),
  ('unknown', 39, 'edge_free_top', 0.2849, 0.2154),
  ('unknown', 39, 'edge_joined', 0.6349, 0.2058),
  ('unknown', 39, 'height', 0.8315, 0.2499),
  ('unknown', 39, 'length', 0.4889, 0.4616),
  ('unknown', 39, 'rectangularity', 0.6395, 0.1123),
  ('unknown', 39, 'spread_length', 0.4179, 0.5254),
  ('unknown', 39, 'spread_width', -0.2973, 0.3386),
  ('unknown', 39, 'tilt_deg', 24.71, 33.16),
  ('unknown', 39, 'width', -0.1008, 0.3243),
  ('unknown', 39, 'z_max', 0.9443, 0.3196),
  ('unknown', 39, 'z_min', 0.6107, 0.2702);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.01754, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'area_m2', 1.512, 0.5011),
  ('unknown', 40, 'aspect', 1.045, 0.8752),
  ('unknown', 40, 'behind', 0.0236, 0.03021),
  ('unknown', 40, 'edge_free', 0.1451, 0.2137),
  ('unknown', 40, 'edge_free_top', 0.1733, 0.2621),
  ('unknown', 40, 'edge_joined', 0.2727, 0.2456),
  ('unknown', 40, 'height', 1.378, 1.222),
  ('unknown', 40, 'length', 1.434, 0.4426),
  ('unknown', 40, 'rectangularity', 0.6853, 0.1353),
  ('unknown', 40, 'spread_length', 1.535, 0.2994),
  ('unknown', 40, 'spread_width', 0.2615, 0.5124),
  ('unknown', 40, 'tilt_deg', 89.56, 1.592),
  ('unknown', 40, 'width', 0.471, 0.5722),
  ('unknown', 40, 'z_max', 3.293, 2.3),
  ('unknown', 40, 'z_min', -0.5736, 0.9805);

-- floor: 503 examples
UPDATE object_class SET prior = 0.04728 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.286, 1.606)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4636, 0.3749)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_joined', 0.2399, 0.1577)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.001143, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.155, 0.755)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5886, 0.1286)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.8942, 0.6842)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.3067, 0.851)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.5724, 0.9777)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.6882, 0.9398)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.007337, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.005432, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'floor';
DELETE FROM class_density WHERE class = 'floor';
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.2502, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'area_m2', 2.568, 0.266),
  ('floor', 1, 'aspect', 0.2786, 0.1749),
  ('floor', 1, 'behind', -0.0004699, 0.03233),
  ('floor', 1, 'edge_free', -0.0001603, 0.03111),
  ('floor', 1, 'edge_free_top', -3.215e-05, 0.03021),
  ('floor', 1, 'edge_joined', 0.2798, 0.1162),
  ('floor', 1, 'height', 5.292e-05, 0.0225),
  ('floor', 1, 'length', 1.726, 0.1358),
  ('floor', 1, 'rectangularity', 0.5541, 0.1269),
  ('floor', 1, 'spread_length', 1.387, 0.1235),
  ('floor', 1, 'spread_width', 0.9494, 0.1416),
  ('floor', 1, 'tilt_deg', 0.007563, 0.4583),
  ('floor', 1, 'width', 1.451, 0.1307),
  ('floor', 1, 'z_max', 1.811e-05, 0.0225),
  ('floor', 1, 'z_min', -0.0001261, 0.02284);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.18, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'area_m2', 2.21, 0.1967),
  ('floor', 2, 'aspect', 0.1666, 0.1049),
  ('floor', 2, 'behind', -0.0003299, 0.03127),
  ('floor', 2, 'edge_free', -8.708e-05, 0.03065),
  ('floor', 2, 'edge_free_top', -8.093e-06, 0.0302),
  ('floor', 2, 'edge_joined', 0.2895, 0.09659),
  ('floor', 2, 'height', 0.0004973, 0.0225),
  ('floor', 2, 'length', 1.441, 0.1053),
  ('floor', 2, 'rectangularity', 0.6137, 0.1107),
  ('floor', 2, 'spread_length', 1.165, 0.1035),
  ('floor', 2, 'spread_width', 0.8468, 0.1158),
  ('floor', 2, 'tilt_deg', 0.0515, 0.4515),
  ('floor', 2, 'width', 1.274, 0.1099),
  ('floor', 2, 'z_max', 0.001827, 0.0225),
  ('floor', 2, 'z_min', -0.00121, 0.02256);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.125, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'area_m2', 1.742, 0.2308),
  ('floor', 3, 'aspect', 0.3665, 0.1879),
  ('floor', 3, 'behind', -0.0003012, 0.03156),
  ('floor', 3, 'edge_free', -0.0002048, 0.03072),
  ('floor', 3, 'edge_free_top', -4.415e-05, 0.03034),
  ('floor', 3, 'edge_joined', 0.2064, 0.09856),
  ('floor', 3, 'height', -0.0002122, 0.02255),
  ('floor', 3, 'length', 1.354, 0.1407),
  ('floor', 3, 'rectangularity', 0.5564, 0.09584),
  ('floor', 3, 'spread_length', 1.11, 0.1283),
  ('floor', 3, 'spread_width', 0.6009, 0.1394),
  ('floor', 3, 'tilt_deg', 0.1087, 0.4535),
  ('floor', 3, 'width', 0.9894, 0.1554),
  ('floor', 3, 'z_max', 0.002842, 0.02253),
  ('floor', 3, 'z_min', -0.002946, 0.02307);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.1102, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'area_m2', 2.077, 0.3157),
  ('floor', 4, 'aspect', 0.801, 0.1401),
  ('floor', 4, 'behind', -0.0001444, 0.03139),
  ('floor', 4, 'edge_free', -0.0001365, 0.03061),
  ('floor', 4, 'edge_free_top', -2.879e-05, 0.03015),
  ('floor', 4, 'edge_joined', 0.2258, 0.0937),
  ('floor', 4, 'height', 1.132e-05, 0.02253),
  ('floor', 4, 'length', 1.785, 0.1739),
  ('floor', 4, 'rectangularity', 0.5069, 0.09385),
  ('floor', 4, 'spread_length', 1.404, 0.1375),
  ('floor', 4, 'spread_width', 0.5825, 0.2006),
  ('floor', 4, 'tilt_deg', 0.02505, 0.4548),
  ('floor', 4, 'width', 0.9876, 0.2061),
  ('floor', 4, 'z_max', 0.0003417, 0.0225),
  ('floor', 4, 'z_min', -0.0002593, 0.02254);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.06765, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'area_m2', -1.956, 0.7898),
  ('floor', 5, 'aspect', 1.073, 0.3873),
  ('floor', 5, 'behind', -0.004177, 0.03),
  ('floor', 5, 'edge_free', 0.001168, 0.03212),
  ('floor', 5, 'edge_free_top', -8.305e-05, 0.03),
  ('floor', 5, 'edge_joined', 0.2559, 0.2938),
  ('floor', 5, 'height', 0.001075, 0.02608),
  ('floor', 5, 'length', -0.2935, 0.5806),
  ('floor', 5, 'rectangularity', 0.6758, 0.09829),
  ('floor', 5, 'spread_length', -0.3953, 0.5704),
  ('floor', 5, 'spread_width', -1.44, 0.2938),
  ('floor', 5, 'tilt_deg', 1.725, 0.8638),
  ('floor', 5, 'width', -1.236, 0.3059),
  ('floor', 5, 'z_max', -0.0003408, 0.0225),
  ('floor', 5, 'z_min', -0.014, 0.0257);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.07399, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'area_m2', 0.09781, 0.35),
  ('floor', 6, 'aspect', 0.6953, 0.4055),
  ('floor', 6, 'behind', -0.002788, 0.03),
  ('floor', 6, 'edge_free', -0.0005016, 0.03),
  ('floor', 6, 'edge_free_top', -9.82e-05, 0.03011),
  ('floor', 6, 'edge_joined', 0.18, 0.1599),
  ('floor', 6, 'height', 0.004662, 0.02366),
  ('floor', 6, 'length', 0.6351, 0.2187),
  ('floor', 6, 'rectangularity', 0.6165, 0.1195),
  ('floor', 6, 'spread_length', 0.4923, 0.1394),
  ('floor', 6, 'spread_width', -0.3037, 0.255),
  ('floor', 6, 'tilt_deg', 1.516, 0.8601),
  ('floor', 6, 'width', -0.03, 0.2626),
  ('floor', 6, 'z_max', 0.02611, 0.02911),
  ('floor', 6, 'z_min', -0.01513, 0.02555);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.05775, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'area_m2', -0.9884, 0.3654),
  ('floor', 7, 'aspect', 0.6412, 0.3634),
  ('floor', 7, 'behind', -0.004878, 0.03),
  ('floor', 7, 'edge_free', -0.0004086, 0.03),
  ('floor', 7, 'edge_free_top', -5.064e-05, 0.0302),
  ('floor', 7, 'edge_joined', 0.1695, 0.1242),
  ('floor', 7, 'height', 0.004012, 0.0225),
  ('floor', 7, 'length', 0.0523, 0.2404),
  ('floor', 7, 'rectangularity', 0.6324, 0.1614),
  ('floor', 7, 'spread_length', -0.1288, 0.1891),
  ('floor', 7, 'spread_width', -0.8157, 0.2339),
  ('floor', 7, 'tilt_deg', 1.942, 0.9921),
  ('floor', 7, 'width', -0.5749, 0.2058),
  ('floor', 7, 'z_max', 0.01923, 0.0233),
  ('floor', 7, 'z_min', -0.0109, 0.02494);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.05841, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'area_m2', 1.15, 0.5029),
  ('floor', 8, 'aspect', 0.4828, 0.2439),
  ('floor', 8, 'behind', -0.0002705, 0.0309),
  ('floor', 8, 'edge_free', -0.0002471, 0.0303),
  ('floor', 8, 'edge_free_top', -0.0001169, 0.03005),
  ('floor', 8, 'edge_joined', 0.1388, 0.06798),
  ('floor', 8, 'height', 0.001549, 0.0225),
  ('floor', 8, 'length', 1.133, 0.24),
  ('floor', 8, 'rectangularity', 0.5499, 0.1195),
  ('floor', 8, 'spread_length', 0.907, 0.1908),
  ('floor', 8, 'spread_width', 0.3467, 0.2733),
  ('floor', 8, 'tilt_deg', 1.146, 0.7303),
  ('floor', 8, 'width', 0.6515, 0.2504),
  ('floor', 8, 'z_max', 0.0283, 0.02365),
  ('floor', 8, 'z_min', -0.02958, 0.02569);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.02686, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'area_m2', -1.717, 0.8196),
  ('floor', 9, 'aspect', 0.963, 0.4844),
  ('floor', 9, 'behind', -0.001387, 0.03),
  ('floor', 9, 'edge_free', 0.004814, 0.03),
  ('floor', 9, 'edge_free_top', -6.011e-05, 0.03016),
  ('floor', 9, 'edge_joined', 0.1709, 0.231),
  ('floor', 9, 'height', -0.3142, 0.335),
  ('floor', 9, 'length', -0.1586, 0.4824),
  ('floor', 9, 'rectangularity', 0.6859, 0.1489),
  ('floor', 9, 'spread_length', -0.2907, 0.4532),
  ('floor', 9, 'spread_width', -1.37, 0.4894),
  ('floor', 9, 'tilt_deg', 8.012, 13.3),
  ('floor', 9, 'width', -1.118, 0.5304),
  ('floor', 9, 'z_max', -0.3258, 0.336),
  ('floor', 9, 'z_min', -0.3477, 0.329);

-- ceiling: 427 examples
UPDATE object_class SET prior = 0.04202 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.657, 1.582)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4004, 0.3719)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.0126, 0.06424)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.01156, 0.06133)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_joined', 0.4247, 0.2099)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.834, 0.3139)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.234, 0.7147)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.675, 0.1231)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.109, 0.7127)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.5368, 0.8431)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.07635, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.8319, 0.8895)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.835, 0.3141)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.834, 0.3137)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'ceiling';
DELETE FROM class_density WHERE class = 'ceiling';
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.1871, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'area_m2', 2.592, 0.321),
  ('ceiling', 1, 'aspect', 0.2076, 0.1486),
  ('ceiling', 1, 'behind', -2.437e-05, 0.03),
  ('ceiling', 1, 'edge_free', 0.0001234, 0.03),
  ('ceiling', 1, 'edge_free_top', 0.0001248, 0.3169),
  ('ceiling', 1, 'edge_joined', 0.588, 0.1652),
  ('ceiling', 1, 'height', 2.512, 0.06577),
  ('ceiling', 1, 'length', 1.593, 0.169),
  ('ceiling', 1, 'rectangularity', 0.6887, 0.1142),
  ('ceiling', 1, 'spread_length', 1.454, 0.1547),
  ('ceiling', 1, 'spread_width', 1.051, 0.1656),
  ('ceiling', 1, 'tilt_deg', -0.001007, 0.45),
  ('ceiling', 1, 'width', 1.384, 0.1341),
  ('ceiling', 1, 'z_max', 2.511, 0.06882),
  ('ceiling', 1, 'z_min', 2.512, 0.06862);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1941, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'area_m2', 2.633, 0.2668),
  ('ceiling', 2, 'aspect', 0.2125, 0.1461),
  ('ceiling', 2, 'behind', 0.0001364, 0.03),
  ('ceiling', 2, 'edge_free', 0.000271, 0.03),
  ('ceiling', 2, 'edge_free_top', 0.0001301, 0.3166),
  ('ceiling', 2, 'edge_joined', 0.5167, 0.1519),
  ('ceiling', 2, 'height', 2.755, 0.06946),
  ('ceiling', 2, 'length', 1.626, 0.1191),
  ('ceiling', 2, 'rectangularity', 0.6883, 0.1177),
  ('ceiling', 2, 'spread_length', 1.514, 0.1175),
  ('ceiling', 2, 'spread_width', 1.072, 0.1475),
  ('ceiling', 2, 'tilt_deg', 0.03011, 0.5283),
  ('ceiling', 2, 'width', 1.402, 0.1189),
  ('ceiling', 2, 'z_max', 2.754, 0.06967),
  ('ceiling', 2, 'z_min', 2.753, 0.07044);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.1397, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'area_m2', 2.029, 0.2789),
  ('ceiling', 3, 'aspect', 0.4578, 0.2948),
  ('ceiling', 3, 'behind', 0.0001916, 0.03),
  ('ceiling', 3, 'edge_free', 0.0001787, 0.03),
  ('ceiling', 3, 'edge_free_top', -0.0002134, 0.3178),
  ('ceiling', 3, 'edge_joined', 0.3325, 0.1282),
  ('ceiling', 3, 'height', 2.992, 0.0827),
  ('ceiling', 3, 'length', 1.47, 0.1941),
  ('ceiling', 3, 'rectangularity', 0.6517, 0.1257),
  ('ceiling', 3, 'spread_length', 1.347, 0.1362),
  ('ceiling', 3, 'spread_width', 0.7038, 0.1986),
  ('ceiling', 3, 'tilt_deg', 0.00805, 0.45),
  ('ceiling', 3, 'width', 1.006, 0.2299),
  ('ceiling', 3, 'z_max', 2.993, 0.08378),
  ('ceiling', 3, 'z_min', 2.993, 0.08429);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.1037, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'area_m2', 2.674, 0.288),
  ('ceiling', 4, 'aspect', 0.2132, 0.1328),
  ('ceiling', 4, 'behind', 0.0002974, 0.03),
  ('ceiling', 4, 'edge_free', 0.0002617, 0.03),
  ('ceiling', 4, 'edge_free_top', 0.0001425, 0.3165),
  ('ceiling', 4, 'edge_joined', 0.4558, 0.1485),
  ('ceiling', 4, 'height', 2.986, 0.07228),
  ('ceiling', 4, 'length', 1.633, 0.1404),
  ('ceiling', 4, 'rectangularity', 0.6966, 0.1233),
  ('ceiling', 4, 'spread_length', 1.519, 0.1304),
  ('ceiling', 4, 'spread_width', 1.09, 0.1521),
  ('ceiling', 4, 'tilt_deg', 0.005391, 0.45),
  ('ceiling', 4, 'width', 1.419, 0.1259),
  ('ceiling', 4, 'z_max', 2.986, 0.07279),
  ('ceiling', 4, 'z_min', 2.986, 0.07273);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.07382, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'area_m2', -1.73, 0.9616),
  ('ceiling', 5, 'aspect', 0.5077, 0.4524),
  ('ceiling', 5, 'behind', 0.003099, 0.03265),
  ('ceiling', 5, 'edge_free', 0.00248, 0.03201),
  ('ceiling', 5, 'edge_free_top', -0.0004952, 0.3208),
  ('ceiling', 5, 'edge_joined', 0.2592, 0.2096),
  ('ceiling', 5, 'height', 3.166, 0.3998),
  ('ceiling', 5, 'length', -0.3501, 0.5638),
  ('ceiling', 5, 'rectangularity', 0.5982, 0.07747),
  ('ceiling', 5, 'spread_length', -0.42, 0.5469),
  ('ceiling', 5, 'spread_width', -1.109, 0.4261),
  ('ceiling', 5, 'tilt_deg', 0.4801, 0.684),
  ('ceiling', 5, 'width', -0.8518, 0.4558),
  ('ceiling', 5, 'z_max', 3.205, 0.444),
  ('ceiling', 5, 'z_min', 3.23, 0.3865);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.07131, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'area_m2', 2.02, 0.2552),
  ('ceiling', 6, 'aspect', 0.3987, 0.25),
  ('ceiling', 6, 'behind', 0.0004008, 0.03),
  ('ceiling', 6, 'edge_free', 0.000382, 0.03),
  ('ceiling', 6, 'edge_free_top', 0.0001002, 0.3168),
  ('ceiling', 6, 'edge_joined', 0.5045, 0.1669),
  ('ceiling', 6, 'height', 2.648, 0.07238),
  ('ceiling', 6, 'length', 1.443, 0.1476),
  ('ceiling', 6, 'rectangularity', 0.642, 0.1219),
  ('ceiling', 6, 'spread_length', 1.308, 0.1226),
  ('ceiling', 6, 'spread_width', 0.732, 0.164),
  ('ceiling', 6, 'tilt_deg', 0.01348, 0.4527),
  ('ceiling', 6, 'width', 1.04, 0.2047),
  ('ceiling', 6, 'z_max', 2.648, 0.07213),
  ('ceiling', 6, 'z_min', 2.648, 0.07208);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.04194, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'area_m2', -0.762, 0.6381),
  ('ceiling', 7, 'aspect', 0.8813, 0.2683),
  ('ceiling', 7, 'behind', 0.002513, 0.03079),
  ('ceiling', 7, 'edge_free', 0.0002864, 0.03),
  ('ceiling', 7, 'edge_free_top', -5.657e-05, 0.3171),
  ('ceiling', 7, 'edge_joined', 0.3064, 0.1742),
  ('ceiling', 7, 'height', 2.511, 0.0356),
  ('ceiling', 7, 'length', 0.2766, 0.4307),
  ('ceiling', 7, 'rectangularity', 0.6989, 0.08711),
  ('ceiling', 7, 'spread_length', 0.1593, 0.4532),
  ('ceiling', 7, 'spread_width', -0.8144, 0.2294),
  ('ceiling', 7, 'tilt_deg', 0.1551, 0.45),
  ('ceiling', 7, 'width', -0.6875, 0.3305),
  ('ceiling', 7, 'z_max', 2.51, 0.03045),
  ('ceiling', 7, 'z_min', 2.51, 0.03168);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.06744, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'area_m2', 2.064, 0.5514),
  ('ceiling', 8, 'aspect', 0.415, 0.2618),
  ('ceiling', 8, 'behind', 0.0004454, 0.03),
  ('ceiling', 8, 'edge_free', 0.0004382, 0.03),
  ('ceiling', 8, 'edge_free_top', 3.784e-05, 0.3171),
  ('ceiling', 8, 'edge_joined', 0.1787, 0.0691),
  ('ceiling', 8, 'height', 3.479, 0.2142),
  ('ceiling', 8, 'length', 1.485, 0.2925),
  ('ceiling', 8, 'rectangularity', 0.6231, 0.1193),
  ('ceiling', 8, 'spread_length', 1.357, 0.2678),
  ('ceiling', 8, 'spread_width', 0.7614, 0.2934),
  ('ceiling', 8, 'tilt_deg', 0.02368, 0.45),
  ('ceiling', 8, 'width', 1.067, 0.3431),
  ('ceiling', 8, 'z_max', 3.488, 0.218),
  ('ceiling', 8, 'z_min', 3.486, 0.2194);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.04263, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'area_m2', 0.7085, 0.5521),
  ('ceiling', 9, 'aspect', 0.8699, 0.4826),
  ('ceiling', 9, 'behind', 0.3431, 0.09517),
  ('ceiling', 9, 'edge_free', 0.3304, 0.08803),
  ('ceiling', 9, 'edge_free_top', -0.0002787, 0.3177),
  ('ceiling', 9, 'edge_joined', 0.3171, 0.1673),
  ('ceiling', 9, 'height', 2.989, 0.346),
  ('ceiling', 9, 'length', 0.9458, 0.4211),
  ('ceiling', 9, 'rectangularity', 0.7566, 0.1135),
  ('ceiling', 9, 'spread_length', 0.8109, 0.3728),
  ('ceiling', 9, 'spread_width', -0.1499, 0.296),
  ('ceiling', 9, 'tilt_deg', 0.04099, 0.45),
  ('ceiling', 9, 'width', 0.0442, 0.2758),
  ('ceiling', 9, 'z_max', 2.966, 0.3624),
  ('ceiling', 9, 'z_min', 2.969, 0.3616);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 10, 0.02824, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 10, 'area_m2', -0.1357, 0.7596),
  ('ceiling', 10, 'aspect', 0.7073, 0.3633),
  ('ceiling', 10, 'behind', 0.06421, 0.1433),
  ('ceiling', 10, 'edge_free', 0.02491, 0.05249),
  ('ceiling', 10, 'edge_free_top', 9.449e-05, 0.3168),
  ('ceiling', 10, 'edge_joined', 0.3347, 0.114),
  ('ceiling', 10, 'height', 2.961, 0.1157),
  ('ceiling', 10, 'length', 0.4571, 0.3998),
  ('ceiling', 10, 'rectangularity', 0.7146, 0.04299),
  ('ceiling', 10, 'spread_length', 0.344, 0.3874),
  ('ceiling', 10, 'spread_width', -0.4899, 0.4075),
  ('ceiling', 10, 'tilt_deg', 0.1, 0.45),
  ('ceiling', 10, 'width', -0.258, 0.4355),
  ('ceiling', 10, 'z_max', 2.96, 0.1188),
  ('ceiling', 10, 'z_min', 2.959, 0.1191);

-- wall: 2680 examples
UPDATE object_class SET prior = 0.1668 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 0.4907, 1.467)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.642, 0.4691)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.0971, 0.1851)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.1217, 0.2169)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.1016, 0.2335)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_joined', 0.2346, 0.2623)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.375, 0.4626)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 0.7929, 0.7061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6572, 0.1508)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.6218, 0.7136)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', -0.1046, 0.8717)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.36, 2.345)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.1477, 0.8797)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.368, 0.7672)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.2859, 0.5282)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'wall';
DELETE FROM class_density WHERE class = 'wall';
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.1318, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'area_m2', 1.952, 0.4561),
  ('wall', 1, 'aspect', 0.4942, 0.3029),
  ('wall', 1, 'behind', -0.00345, 0.03),
  ('wall', 1, 'edge_free', 0.008371, 0.03088),
  ('wall', 1, 'edge_free_top', 0.002719, 0.0334),
  ('wall', 1, 'edge_joined', 0.08644, 0.1036),
  ('wall', 1, 'height', 1.566, 0.2447),
  ('wall', 1, 'length', 1.408, 0.2165),
  ('wall', 1, 'rectangularity', 0.6764, 0.1492),
  ('wall', 1, 'spread_length', 1.149, 0.2131),
  ('wall', 1, 'spread_width', 0.734, 0.1377),
  ('wall', 1, 'tilt_deg', 90.08, 0.45),
  ('wall', 1, 'width', 1.056, 0.0858),
  ('wall', 1, 'z_max', 2.978, 0.3492),
  ('wall', 1, 'z_min', -0.01427, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.07283, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'area_m2', 1.057, 0.3608),
  ('wall', 2, 'aspect', 0.4526, 0.3793),
  ('wall', 2, 'behind', -0.00814, 0.03),
  ('wall', 2, 'edge_free', 0.01287, 0.03505),
  ('wall', 2, 'edge_free_top', 0.006354, 0.03935),
  ('wall', 2, 'edge_joined', 0.2633, 0.2062),
  ('wall', 2, 'height', 1.53, 0.3652),
  ('wall', 2, 'length', 1.044, 0.246),
  ('wall', 2, 'rectangularity', 0.6313, 0.1209),
  ('wall', 2, 'spread_length', 0.6766, 0.1665),
  ('wall', 2, 'spread_width', 0.2457, 0.2293),
  ('wall', 2, 'tilt_deg', 90.26, 0.45),
  ('wall', 2, 'width', 0.5953, 0.295),
  ('wall', 2, 'z_max', 2.7, 0.1435),
  ('wall', 2, 'z_min', 0.3267, 0.4265);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.1312, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'area_m2', 0.003679, 0.4165),
  ('wall', 3, 'aspect', 1.06, 0.4802),
  ('wall', 3, 'behind', -0.001729, 0.03),
  ('wall', 3, 'edge_free', 0.000738, 0.03),
  ('wall', 3, 'edge_free_top', -0.02225, 0.03),
  ('wall', 3, 'edge_joined', 0.1252, 0.1793),
  ('wall', 3, 'height', 1.265, 0.5217),
  ('wall', 3, 'length', 0.5729, 0.3245),
  ('wall', 3, 'rectangularity', 0.6836, 0.09052),
  ('wall', 3, 'spread_length', 0.1538, 0.4639),
  ('wall', 3, 'spread_width', -0.4963, 0.2167),
  ('wall', 3, 'tilt_deg', 88.53, 2.073),
  ('wall', 3, 'width', -0.3889, 0.6001),
  ('wall', 3, 'z_max', 2.081, 0.7618),
  ('wall', 3, 'z_min', 0.2521, 0.2338);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.1192, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'area_m2', 0.3457, 0.4078),
  ('wall', 4, 'aspect', 1.254, 0.3792),
  ('wall', 4, 'behind', 0.263, 0.182),
  ('wall', 4, 'edge_free', 0.402, 0.336),
  ('wall', 4, 'edge_free_top', 0.158, 0.1339),
  ('wall', 4, 'edge_joined', 0.1931, 0.2155),
  ('wall', 4, 'height', 1.443, 0.1444),
  ('wall', 4, 'length', 0.9739, 0.1699),
  ('wall', 4, 'rectangularity', 0.6709, 0.1864),
  ('wall', 4, 'spread_length', 0.7694, 0.2622),
  ('wall', 4, 'spread_width', -0.6222, 0.3988),
  ('wall', 4, 'tilt_deg', 90.09, 0.45),
  ('wall', 4, 'width', -0.1805, 0.4645),
  ('wall', 4, 'z_max', 2.734, 0.185),
  ('wall', 4, 'z_min', 0.1465, 0.2735);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.1847, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'area_m2', -0.9473, 0.6772),
  ('wall', 5, 'aspect', 0.7286, 0.3751),
  ('wall', 5, 'behind', 0.2146, 0.1905),
  ('wall', 5, 'edge_free', 0.1333, 0.2915),
  ('wall', 5, 'edge_free_top', 0.003855, 0.03),
  ('wall', 5, 'edge_joined', 0.3514, 0.36),
  ('wall', 5, 'height', 1.87, 0.4621),
  ('wall', 5, 'length', 0.1881, 0.4481),
  ('wall', 5, 'rectangularity', 0.6773, 0.1493),
  ('wall', 5, 'spread_length', -0.2759, 0.4924),
  ('wall', 5, 'spread_width', -0.9222, 0.3086),
  ('wall', 5, 'tilt_deg', 89.94, 0.45),
  ('wall', 5, 'width', -0.7374, 0.4896),
  ('wall', 5, 'z_max', 2.873, 0.2198),
  ('wall', 5, 'z_min', 1.164, 0.6202);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.05728, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'area_m2', 1.78, 0.3642),
  ('wall', 6, 'aspect', 0.3732, 0.2647),
  ('wall', 6, 'behind', 0.1562, 0.1437),
  ('wall', 6, 'edge_free', 0.1487, 0.08856),
  ('wall', 6, 'edge_free_top', 0.09484, 0.1263),
  ('wall', 6, 'edge_joined', 0.1154, 0.1344),
  ('wall', 6, 'height', 1.528, 0.2556),
  ('wall', 6, 'length', 1.376, 0.2115),
  ('wall', 6, 'rectangularity', 0.5364, 0.1078),
  ('wall', 6, 'spread_length', 1.232, 0.2191),
  ('wall', 6, 'spread_width', 0.7946, 0.1599),
  ('wall', 6, 'tilt_deg', 90.02, 0.45),
  ('wall', 6, 'width', 1.018, 0.099),
  ('wall', 6, 'z_max', 2.896, 0.3462),
  ('wall', 6, 'z_min', -0.01196, 0.02592);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.117, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'area_m2', -0.9833, 0.9042),
  ('wall', 7, 'aspect', 1.163, 0.3001),
  ('wall', 7, 'behind', 0.1953, 0.175),
  ('wall', 7, 'edge_free', 0.4455, 0.3959),
  ('wall', 7, 'edge_free_top', 0.4004, 0.4264),
  ('wall', 7, 'edge_joined', 0.03856, 0.1043),
  ('wall', 7, 'height', 0.8494, 0.446),
  ('wall', 7, 'length', 0.1941, 0.5734),
  ('wall', 7, 'rectangularity', 0.6115, 0.2279),
  ('wall', 7, 'spread_length', 0.009327, 0.6509),
  ('wall', 7, 'spread_width', -1.035, 0.4424),
  ('wall', 7, 'tilt_deg', 85.44, 13.58),
  ('wall', 7, 'width', -0.7585, 0.6475),
  ('wall', 7, 'z_max', 1.612, 0.297),
  ('wall', 7, 'z_min', 0.2157, 0.372);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.08114, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'area_m2', -1.908, 0.9404),
  ('wall', 8, 'aspect', 0.6813, 0.525),
  ('wall', 8, 'behind', -0.007918, 0.03),
  ('wall', 8, 'edge_free', -0.02066, 0.03),
  ('wall', 8, 'edge_free_top', -0.005439, 0.03),
  ('wall', 8, 'edge_joined', 0.1121, 0.1809),
  ('wall', 8, 'height', 0.2903, 0.1991),
  ('wall', 8, 'length', -0.428, 0.4859),
  ('wall', 8, 'rectangularity', 0.7669, 0.1157),
  ('wall', 8, 'spread_length', -0.5035, 0.5182),
  ('wall', 8, 'spread_width', -1.345, 0.5543),
  ('wall', 8, 'tilt_deg', 88.41, 0.45),
  ('wall', 8, 'width', -1.163, 0.5575),
  ('wall', 8, 'z_max', 0.5966, 0.2594),
  ('wall', 8, 'z_min', -0.03713, 0.02907);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.02578, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'area_m2', -2.637, 0.6654),
  ('wall', 9, 'aspect', 0.4613, 0.3225),
  ('wall', 9, 'behind', 0.001858, 0.03),
  ('wall', 9, 'edge_free', 0.1066, 0.1466),
  ('wall', 9, 'edge_free_top', 0.1977, 0.1777),
  ('wall', 9, 'edge_joined', 0.7412, 0.2313),
  ('wall', 9, 'height', 1.417, 0.499),
  ('wall', 9, 'length', -0.9224, 0.436),
  ('wall', 9, 'rectangularity', 0.8035, 0.1337),
  ('wall', 9, 'spread_length', -1.024, 0.4358),
  ('wall', 9, 'spread_width', -1.592, 0.1258),
  ('wall', 9, 'tilt_deg', 89.71, 1.338),
  ('wall', 9, 'width', -1.489, 0.1687),
  ('wall', 9, 'z_max', 1.508, 0.1811),
  ('wall', 9, 'z_min', 1.126, 0.69);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.02902, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'area_m2', 0.5854, 0.4167),
  ('wall', 10, 'aspect', 0.1778, 0.1464),
  ('wall', 10, 'behind', 0.3198, 0.2215),
  ('wall', 10, 'edge_free', 0.5356, 0.2903),
  ('wall', 10, 'edge_free_top', 0.9349, 0.07405),
  ('wall', 10, 'edge_joined', 0.1379, 0.2059),
  ('wall', 10, 'height', 0.9951, 0.1894),
  ('wall', 10, 'length', 0.5953, 0.1909),
  ('wall', 10, 'rectangularity', 0.7624, 0.207),
  ('wall', 10, 'spread_length', 0.473, 0.1915),
  ('wall', 10, 'spread_width', 0.06113, 0.2684),
  ('wall', 10, 'tilt_deg', 89.75, 0.6356),
  ('wall', 10, 'width', 0.3393, 0.2476),
  ('wall', 10, 'z_max', 1.537, 0.2942),
  ('wall', 10, 'z_min', -0.02727, 0.07035);

-- table: 748 examples
UPDATE object_class SET prior = 0.02377 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.2574, 0.5895)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5463, 0.2729)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5341, 0.2079)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.4537, 0.2114)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_joined', 0.2796, 0.1891)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7276, 0.1156)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.3293, 0.317)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.7047, 0.1289)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1873, 0.3151)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4039, 0.3368)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.6032, 0.6319)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2194, 0.3084)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7339, 0.1158)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7228, 0.1156)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'table';
DELETE FROM class_density WHERE class = 'table';
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.1534, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'area_m2', 0.1361, 0.1921),
  ('table', 1, 'aspect', 0.5975, 0.1565),
  ('table', 1, 'behind', 0.5079, 0.1591),
  ('table', 1, 'edge_free', 0.5639, 0.1472),
  ('table', 1, 'edge_free_top', -0.0004376, 0.3157),
  ('table', 1, 'edge_joined', 0.2129, 0.1342),
  ('table', 1, 'height', 0.703, 0.02332),
  ('table', 1, 'length', 0.5221, 0.113),
  ('table', 1, 'rectangularity', 0.7654, 0.0978),
  ('table', 1, 'spread_length', 0.3918, 0.1376),
  ('table', 1, 'spread_width', -0.2525, 0.1204),
  ('table', 1, 'tilt_deg', 0.3, 0.45),
  ('table', 1, 'width', -0.09643, 0.127),
  ('table', 1, 'z_max', 0.7052, 0.0225),
  ('table', 1, 'z_min', 0.6996, 0.02563);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.07753, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'area_m2', 0.2112, 0.2306),
  ('table', 2, 'aspect', 0.5571, 0.1333),
  ('table', 2, 'behind', 0.703, 0.05531),
  ('table', 2, 'edge_free', 0.3607, 0.138),
  ('table', 2, 'edge_free_top', -0.0001157, 0.3162),
  ('table', 2, 'edge_joined', 0.3918, 0.141),
  ('table', 2, 'height', 0.7448, 0.02348),
  ('table', 2, 'length', 0.5714, 0.1758),
  ('table', 2, 'rectangularity', 0.7025, 0.07528),
  ('table', 2, 'spread_length', 0.4285, 0.1472),
  ('table', 2, 'spread_width', -0.1691, 0.1444),
  ('table', 2, 'tilt_deg', 0.3591, 0.45),
  ('table', 2, 'width', -0.01585, 0.1582),
  ('table', 2, 'z_max', 0.7489, 0.02461),
  ('table', 2, 'z_min', 0.7437, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.1376, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'area_m2', -0.3842, 0.231),
  ('table', 3, 'aspect', 0.2534, 0.1521),
  ('table', 3, 'behind', 0.5419, 0.2744),
  ('table', 3, 'edge_free', 0.383, 0.1841),
  ('table', 3, 'edge_free_top', -0.0009271, 0.3151),
  ('table', 3, 'edge_joined', 0.3016, 0.1617),
  ('table', 3, 'height', 0.7328, 0.02834),
  ('table', 3, 'length', 0.1618, 0.1467),
  ('table', 3, 'rectangularity', 0.6563, 0.1737),
  ('table', 3, 'spread_length', 0.005346, 0.1176),
  ('table', 3, 'spread_width', -0.3378, 0.0902),
  ('table', 3, 'tilt_deg', 0.4106, 0.45),
  ('table', 3, 'width', -0.1138, 0.1018),
  ('table', 3, 'z_max', 0.7402, 0.03344),
  ('table', 3, 'z_min', 0.7357, 0.02425);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.121, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'area_m2', -0.08007, 0.269),
  ('table', 4, 'aspect', 0.5927, 0.1904),
  ('table', 4, 'behind', 0.4711, 0.1393),
  ('table', 4, 'edge_free', 0.578, 0.2392),
  ('table', 4, 'edge_free_top', -0.0006182, 0.3155),
  ('table', 4, 'edge_joined', 0.1653, 0.1284),
  ('table', 4, 'height', 0.7682, 0.02436),
  ('table', 4, 'length', 0.4543, 0.1591),
  ('table', 4, 'rectangularity', 0.716, 0.1578),
  ('table', 4, 'spread_length', 0.3091, 0.1728),
  ('table', 4, 'spread_width', -0.3714, 0.1836),
  ('table', 4, 'tilt_deg', 0.4085, 0.45),
  ('table', 4, 'width', -0.2, 0.1247),
  ('table', 4, 'z_max', 0.7757, 0.02996),
  ('table', 4, 'z_min', 0.766, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.1459, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'area_m2', -0.9308, 0.2523),
  ('table', 5, 'aspect', 0.3705, 0.217),
  ('table', 5, 'behind', 0.2944, 0.1841),
  ('table', 5, 'edge_free', 0.5509, 0.2233),
  ('table', 5, 'edge_free_top', -0.00205, 0.313),
  ('table', 5, 'edge_joined', 0.1863, 0.1315),
  ('table', 5, 'height', 0.6927, 0.02994),
  ('table', 5, 'length', -0.09077, 0.1655),
  ('table', 5, 'rectangularity', 0.7032, 0.1311),
  ('table', 5, 'spread_length', -0.2353, 0.1615),
  ('table', 5, 'spread_width', -0.6984, 0.1877),
  ('table', 5, 'tilt_deg', 0.5978, 0.45),
  ('table', 5, 'width', -0.48, 0.1353),
  ('table', 5, 'z_max', 0.6982, 0.03041),
  ('table', 5, 'z_min', 0.6907, 0.03313);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.08217, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'area_m2', -1.579, 0.5916),
  ('table', 6, 'aspect', 0.8501, 0.1934),
  ('table', 6, 'behind', 0.2963, 0.2185),
  ('table', 6, 'edge_free', 0.5508, 0.3187),
  ('table', 6, 'edge_free_top', -0.003437, 0.3125),
  ('table', 6, 'edge_joined', 0.2007, 0.1997),
  ('table', 6, 'height', 0.7223, 0.05246),
  ('table', 6, 'length', -0.1551, 0.3889),
  ('table', 6, 'rectangularity', 0.6222, 0.1083),
  ('table', 6, 'spread_length', -0.3169, 0.452),
  ('table', 6, 'spread_width', -1.231, 0.2457),
  ('table', 6, 'tilt_deg', 1.234, 1.423),
  ('table', 6, 'width', -0.9911, 0.3704),
  ('table', 6, 'z_max', 0.7296, 0.05916),
  ('table', 6, 'z_min', 0.7167, 0.05371);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.08142, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'area_m2', -0.07867, 0.3261),
  ('table', 7, 'aspect', 0.6311, 0.2838),
  ('table', 7, 'behind', 0.5566, 0.1626),
  ('table', 7, 'edge_free', 0.4679, 0.1761),
  ('table', 7, 'edge_free_top', -0.0002801, 0.3159),
  ('table', 7, 'edge_joined', 0.2123, 0.1432),
  ('table', 7, 'height', 0.6452, 0.02263),
  ('table', 7, 'length', 0.4521, 0.2231),
  ('table', 7, 'rectangularity', 0.7012, 0.1377),
  ('table', 7, 'spread_length', 0.3247, 0.2506),
  ('table', 7, 'spread_width', -0.2887, 0.1747),
  ('table', 7, 'tilt_deg', 0.8221, 0.6263),
  ('table', 7, 'width', -0.158, 0.1433),
  ('table', 7, 'z_max', 0.6529, 0.0225),
  ('table', 7, 'z_min', 0.6343, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.06969, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'area_m2', 0.05537, 0.2386),
  ('table', 8, 'aspect', 0.5689, 0.2849),
  ('table', 8, 'behind', 0.4771, 0.1467),
  ('table', 8, 'edge_free', 0.3012, 0.1207),
  ('table', 8, 'edge_free_top', -0.001098, 0.3155),
  ('table', 8, 'edge_joined', 0.4663, 0.1539),
  ('table', 8, 'height', 0.9261, 0.1245),
  ('table', 8, 'length', 0.5071, 0.1977),
  ('table', 8, 'rectangularity', 0.716, 0.1419),
  ('table', 8, 'spread_length', 0.3485, 0.2121),
  ('table', 8, 'spread_width', -0.2413, 0.1511),
  ('table', 8, 'tilt_deg', 0.8478, 0.5355),
  ('table', 8, 'width', -0.09516, 0.1337),
  ('table', 8, 'z_max', 0.9385, 0.1263),
  ('table', 8, 'z_min', 0.9162, 0.1321);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.05608, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'area_m2', -0.92, 0.3427),
  ('table', 9, 'aspect', 0.3637, 0.2563),
  ('table', 9, 'behind', 0.2794, 0.1959),
  ('table', 9, 'edge_free', 0.4608, 0.2322),
  ('table', 9, 'edge_free_top', -0.004052, 0.312),
  ('table', 9, 'edge_joined', 0.2835, 0.1599),
  ('table', 9, 'height', 0.8685, 0.1387),
  ('table', 9, 'length', -0.04294, 0.1971),
  ('table', 9, 'rectangularity', 0.6527, 0.1432),
  ('table', 9, 'spread_length', -0.1444, 0.2359),
  ('table', 9, 'spread_width', -0.6851, 0.2522),
  ('table', 9, 'tilt_deg', 0.9907, 0.8807),
  ('table', 9, 'width', -0.4219, 0.2197),
  ('table', 9, 'z_max', 0.875, 0.1411),
  ('table', 9, 'z_min', 0.8668, 0.1488);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.02511, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'area_m2', -0.6731, 0.6012),
  ('table', 10, 'aspect', 0.5211, 0.1483),
  ('table', 10, 'behind', 0.2208, 0.1357),
  ('table', 10, 'edge_free', 0.2909, 0.123),
  ('table', 10, 'edge_free_top', -0.0003855, 0.316),
  ('table', 10, 'edge_joined', 0.1509, 0.1546),
  ('table', 10, 'height', 0.04966, 0.05501),
  ('table', 10, 'length', 0.1574, 0.304),
  ('table', 10, 'rectangularity', 0.6175, 0.08404),
  ('table', 10, 'spread_length', 0.04817, 0.305),
  ('table', 10, 'spread_width', -0.594, 0.3586),
  ('table', 10, 'tilt_deg', 1.395, 0.5527),
  ('table', 10, 'width', -0.3258, 0.2947),
  ('table', 10, 'z_max', 0.03888, 0.03917),
  ('table', 10, 'z_min', 0.01551, 0.03291);

-- flat_screen: 598 examples
UPDATE object_class SET prior = 0.03885 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.82, 0.3872)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.3864, 0.2086)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5919, 0.1343)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.7664, 0.1695)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.979, 0.06384)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_joined', 0.04801, 0.08474)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.017, 0.09526)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.5988, 0.2592)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.7995, 0.1153)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7633, 0.2073)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.198, 0.1742)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.17, 3.296)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -0.9851, 0.2159)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.175, 0.1055)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7761, 0.1336)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'flat_screen';
DELETE FROM class_density WHERE class = 'flat_screen';
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.2246, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'area_m2', -1.928, 0.1304),
  ('flat_screen', 1, 'aspect', 0.2449, 0.204),
  ('flat_screen', 1, 'behind', 0.64, 0.06246),
  ('flat_screen', 1, 'edge_free', 0.7257, 0.07683),
  ('flat_screen', 1, 'edge_free_top', 0.9981, 0.03),
  ('flat_screen', 1, 'edge_joined', 0.042, 0.04139),
  ('flat_screen', 1, 'height', 0.9925, 0.0338),
  ('flat_screen', 1, 'length', -0.7121, 0.1728),
  ('flat_screen', 1, 'rectangularity', 0.7632, 0.09355),
  ('flat_screen', 1, 'spread_length', -0.9178, 0.09664),
  ('flat_screen', 1, 'spread_width', -1.252, 0.05675),
  ('flat_screen', 1, 'tilt_deg', 84.03, 1.946),
  ('flat_screen', 1, 'width', -0.9537, 0.06251),
  ('flat_screen', 1, 'z_max', 1.114, 0.05941),
  ('flat_screen', 1, 'z_min', 0.7156, 0.03252);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.1549, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'area_m2', -1.532, 0.1254),
  ('flat_screen', 2, 'aspect', 0.3279, 0.1011),
  ('flat_screen', 2, 'behind', 0.556, 0.105),
  ('flat_screen', 2, 'edge_free', 0.7338, 0.07493),
  ('flat_screen', 2, 'edge_free_top', 0.9946, 0.03077),
  ('flat_screen', 2, 'edge_joined', 0.05795, 0.0582),
  ('flat_screen', 2, 'height', 1.007, 0.04324),
  ('flat_screen', 2, 'length', -0.5203, 0.09297),
  ('flat_screen', 2, 'rectangularity', 0.8437, 0.04228),
  ('flat_screen', 2, 'spread_length', -0.6214, 0.07498),
  ('flat_screen', 2, 'spread_width', -1.078, 0.0577),
  ('flat_screen', 2, 'tilt_deg', 85.57, 3.029),
  ('flat_screen', 2, 'width', -0.8232, 0.07629),
  ('flat_screen', 2, 'z_max', 1.161, 0.05755),
  ('flat_screen', 2, 'z_min', 0.7261, 0.04178);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.1813, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'area_m2', -1.387, 0.1775),
  ('flat_screen', 3, 'aspect', 0.6045, 0.1532),
  ('flat_screen', 3, 'behind', 0.6446, 0.07838),
  ('flat_screen', 3, 'edge_free', 0.6124, 0.03908),
  ('flat_screen', 3, 'edge_free_top', 0.9572, 0.07468),
  ('flat_screen', 3, 'edge_joined', 0.07226, 0.07968),
  ('flat_screen', 3, 'height', 0.972, 0.04886),
  ('flat_screen', 3, 'length', -0.2246, 0.1083),
  ('flat_screen', 3, 'rectangularity', 0.6807, 0.05346),
  ('flat_screen', 3, 'spread_length', -0.6109, 0.0891),
  ('flat_screen', 3, 'spread_width', -1.071, 0.09514),
  ('flat_screen', 3, 'tilt_deg', 84.02, 2.3),
  ('flat_screen', 3, 'width', -0.8003, 0.1059),
  ('flat_screen', 3, 'z_max', 1.129, 0.07094),
  ('flat_screen', 3, 'z_min', 0.6903, 0.05413);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.0914, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'area_m2', -1.771, 0.1335),
  ('flat_screen', 4, 'aspect', 0.5, 0.04962),
  ('flat_screen', 4, 'behind', 0.5844, 0.1033),
  ('flat_screen', 4, 'edge_free', 0.9834, 0.03063),
  ('flat_screen', 4, 'edge_free_top', 0.9991, 0.03),
  ('flat_screen', 4, 'edge_joined', 0.003285, 0.03),
  ('flat_screen', 4, 'height', 1.03, 0.04205),
  ('flat_screen', 4, 'length', -0.5948, 0.07694),
  ('flat_screen', 4, 'rectangularity', 0.9244, 0.03807),
  ('flat_screen', 4, 'spread_length', -0.6459, 0.0615),
  ('flat_screen', 4, 'spread_width', -1.144, 0.07869),
  ('flat_screen', 4, 'tilt_deg', 85.08, 3.525),
  ('flat_screen', 4, 'width', -1.097, 0.07394),
  ('flat_screen', 4, 'z_max', 1.186, 0.04657),
  ('flat_screen', 4, 'z_min', 0.8505, 0.04245);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.06581, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'area_m2', -2.23, 0.1444),
  ('flat_screen', 5, 'aspect', 0.3492, 0.1325),
  ('flat_screen', 5, 'behind', 0.5914, 0.08447),
  ('flat_screen', 5, 'edge_free', 0.9886, 0.03),
  ('flat_screen', 5, 'edge_free_top', 0.9976, 0.03),
  ('flat_screen', 5, 'edge_joined', 0.004563, 0.03054),
  ('flat_screen', 5, 'height', 1.016, 0.04916),
  ('flat_screen', 5, 'length', -0.8953, 0.1203),
  ('flat_screen', 5, 'rectangularity', 0.9066, 0.06804),
  ('flat_screen', 5, 'spread_length', -0.9475, 0.09836),
  ('flat_screen', 5, 'spread_width', -1.299, 0.06118),
  ('flat_screen', 5, 'tilt_deg', 84.66, 3.086),
  ('flat_screen', 5, 'width', -1.241, 0.08815),
  ('flat_screen', 5, 'z_max', 1.151, 0.05305),
  ('flat_screen', 5, 'z_min', 0.8588, 0.04083);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.05229, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'area_m2', -2.607, 0.4128),
  ('flat_screen', 6, 'aspect', 0.5397, 0.3491),
  ('flat_screen', 6, 'behind', 0.5667, 0.1884),
  ('flat_screen', 6, 'edge_free', 0.8174, 0.1466),
  ('flat_screen', 6, 'edge_free_top', 1.001, 0.03),
  ('flat_screen', 6, 'edge_joined', 0.03148, 0.06983),
  ('flat_screen', 6, 'height', 1.066, 0.05954),
  ('flat_screen', 6, 'length', -0.8728, 0.2601),
  ('flat_screen', 6, 'rectangularity', 0.7418, 0.1543),
  ('flat_screen', 6, 'spread_length', -0.9976, 0.1301),
  ('flat_screen', 6, 'spread_width', -1.648, 0.2751),
  ('flat_screen', 6, 'tilt_deg', 83.89, 1.807),
  ('flat_screen', 6, 'width', -1.404, 0.2962),
  ('flat_screen', 6, 'z_max', 1.144, 0.05594),
  ('flat_screen', 6, 'z_min', 0.8438, 0.07157);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.08421, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'area_m2', -1.632, 0.1315),
  ('flat_screen', 7, 'aspect', 0.4024, 0.1668),
  ('flat_screen', 7, 'behind', 0.4931, 0.1041),
  ('flat_screen', 7, 'edge_free', 0.7773, 0.1443),
  ('flat_screen', 7, 'edge_free_top', 0.9945, 0.03),
  ('flat_screen', 7, 'edge_joined', 0.0194, 0.03),
  ('flat_screen', 7, 'height', 1.217, 0.1286),
  ('flat_screen', 7, 'length', -0.5007, 0.1452),
  ('flat_screen', 7, 'rectangularity', 0.7939, 0.1023),
  ('flat_screen', 7, 'spread_length', -0.61, 0.07706),
  ('flat_screen', 7, 'spread_width', -1.103, 0.07856),
  ('flat_screen', 7, 'tilt_deg', 83.8, 2.654),
  ('flat_screen', 7, 'width', -0.8897, 0.1182),
  ('flat_screen', 7, 'z_max', 1.387, 0.1045),
  ('flat_screen', 7, 'z_min', 0.996, 0.1309);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.04617, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'area_m2', -1.494, 0.3858),
  ('flat_screen', 8, 'aspect', 0.4686, 0.2929),
  ('flat_screen', 8, 'behind', 0.6064, 0.128),
  ('flat_screen', 8, 'edge_free', 0.5184, 0.09499),
  ('flat_screen', 8, 'edge_free_top', 0.7791, 0.09457),
  ('flat_screen', 8, 'edge_joined', 0.1681, 0.2363),
  ('flat_screen', 8, 'height', 1.025, 0.0551),
  ('flat_screen', 8, 'length', -0.3671, 0.3388),
  ('flat_screen', 8, 'rectangularity', 0.6744, 0.1571),
  ('flat_screen', 8, 'spread_length', -0.5007, 0.2826),
  ('flat_screen', 8, 'spread_width', -1.104, 0.1593),
  ('flat_screen', 8, 'tilt_deg', 81.22, 8.017),
  ('flat_screen', 8, 'width', -0.6706, 0.1836),
  ('flat_screen', 8, 'z_max', 1.283, 0.1503),
  ('flat_screen', 8, 'z_min', 0.7626, 0.06341);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.03842, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'area_m2', -2.057, 0.1373),
  ('flat_screen', 9, 'aspect', 0.3949, 0.1418),
  ('flat_screen', 9, 'behind', 0.5341, 0.07827),
  ('flat_screen', 9, 'edge_free', 0.8379, 0.1699),
  ('flat_screen', 9, 'edge_free_top', 0.9965, 0.03),
  ('flat_screen', 9, 'edge_joined', 0.01705, 0.03),
  ('flat_screen', 9, 'height', 1.216, 0.1005),
  ('flat_screen', 9, 'length', -0.7531, 0.1465),
  ('flat_screen', 9, 'rectangularity', 0.8444, 0.1043),
  ('flat_screen', 9, 'spread_length', -0.9173, 0.1065),
  ('flat_screen', 9, 'spread_width', -1.261, 0.06376),
  ('flat_screen', 9, 'tilt_deg', 83.76, 1.849),
  ('flat_screen', 9, 'width', -1.132, 0.1572),
  ('flat_screen', 9, 'z_max', 1.36, 0.09361),
  ('flat_screen', 9, 'z_min', 1.043, 0.116);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.0109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'area_m2', -1.896, 0.4255),
  ('flat_screen', 10, 'aspect', 0.6278, 0.1203),
  ('flat_screen', 10, 'behind', 0.5497, 0.1942),
  ('flat_screen', 10, 'edge_free', 0.7106, 0.1098),
  ('flat_screen', 10, 'edge_free_top', 0.9967, 0.03),
  ('flat_screen', 10, 'edge_joined', 0.103, 0.1231),
  ('flat_screen', 10, 'height', 0.4886, 0.2294),
  ('flat_screen', 10, 'length', -0.4757, 0.3576),
  ('flat_screen', 10, 'rectangularity', 0.759, 0.2051),
  ('flat_screen', 10, 'spread_length', -0.6525, 0.2824),
  ('flat_screen', 10, 'spread_width', -1.257, 0.2946),
  ('flat_screen', 10, 'tilt_deg', 86.41, 2.458),
  ('flat_screen', 10, 'width', -1.078, 0.3498),
  ('flat_screen', 10, 'z_max', 0.6248, 0.3353),
  ('flat_screen', 10, 'z_min', 0.1142, 0.09784);

-- keyboard: 389 examples
UPDATE object_class SET prior = 0.05973 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.706, 0.3826)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7407, 0.3022)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.2458, 0.1628)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.2701, 0.2051)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_joined', 0.6795, 0.2208)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7591, 0.1196)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.8756, 0.278)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8125, 0.07862)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9689, 0.2781)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.811, 0.1292)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.515, 2.126)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.618, 0.215)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7664, 0.1201)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7525, 0.1194)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'keyboard';
DELETE FROM class_density WHERE class = 'keyboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1719, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'area_m2', -2.852, 0.1723),
  ('keyboard', 1, 'aspect', 0.5948, 0.1489),
  ('keyboard', 1, 'behind', 0.2372, 0.06672),
  ('keyboard', 1, 'edge_free', 0.2046, 0.1915),
  ('keyboard', 1, 'edge_free_top', -0.001976, 0.3145),
  ('keyboard', 1, 'edge_joined', 0.7575, 0.2062),
  ('keyboard', 1, 'height', 0.7547, 0.04588),
  ('keyboard', 1, 'length', -1.059, 0.09211),
  ('keyboard', 1, 'rectangularity', 0.8243, 0.06225),
  ('keyboard', 1, 'spread_length', -1.176, 0.04763),
  ('keyboard', 1, 'spread_width', -1.787, 0.07175),
  ('keyboard', 1, 'tilt_deg', 4.744, 1.313),
  ('keyboard', 1, 'width', -1.564, 0.2068),
  ('keyboard', 1, 'z_max', 0.7517, 0.03834),
  ('keyboard', 1, 'z_min', 0.7504, 0.0543);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.1168, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'area_m2', -2.225, 0.1304),
  ('keyboard', 2, 'aspect', 0.7127, 0.1449),
  ('keyboard', 2, 'behind', 0.239, 0.1017),
  ('keyboard', 2, 'edge_free', 0.3193, 0.1042),
  ('keyboard', 2, 'edge_free_top', -0.002962, 0.3143),
  ('keyboard', 2, 'edge_joined', 0.7145, 0.127),
  ('keyboard', 2, 'height', 0.7449, 0.04017),
  ('keyboard', 2, 'length', -0.6241, 0.125),
  ('keyboard', 2, 'rectangularity', 0.7497, 0.03809),
  ('keyboard', 2, 'spread_length', -0.7809, 0.0902),
  ('keyboard', 2, 'spread_width', -1.711, 0.07306),
  ('keyboard', 2, 'tilt_deg', 3.338, 1.795),
  ('keyboard', 2, 'width', -1.322, 0.08411),
  ('keyboard', 2, 'z_max', 0.7481, 0.03641),
  ('keyboard', 2, 'z_min', 0.7402, 0.04585);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.1343, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'area_m2', -2.544, 0.09146),
  ('keyboard', 3, 'aspect', 0.8244, 0.08936),
  ('keyboard', 3, 'behind', 0.2298, 0.09514),
  ('keyboard', 3, 'edge_free', 0.4547, 0.09804),
  ('keyboard', 3, 'edge_free_top', -0.00431, 0.3067),
  ('keyboard', 3, 'edge_joined', 0.5228, 0.09792),
  ('keyboard', 3, 'height', 0.7652, 0.02846),
  ('keyboard', 3, 'length', -0.7673, 0.06744),
  ('keyboard', 3, 'rectangularity', 0.8345, 0.03712),
  ('keyboard', 3, 'spread_length', -0.8374, 0.05635),
  ('keyboard', 3, 'spread_width', -1.76, 0.06854),
  ('keyboard', 3, 'tilt_deg', 5.079, 1.343),
  ('keyboard', 3, 'width', -1.595, 0.06947),
  ('keyboard', 3, 'z_max', 0.7754, 0.02899),
  ('keyboard', 3, 'z_min', 0.7585, 0.03074);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.1099, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'area_m2', -2.642, 0.1104),
  ('keyboard', 4, 'aspect', 1.046, 0.111),
  ('keyboard', 4, 'behind', 0.2568, 0.09731),
  ('keyboard', 4, 'edge_free', 0.1761, 0.1402),
  ('keyboard', 4, 'edge_free_top', -0.002475, 0.3114),
  ('keyboard', 4, 'edge_joined', 0.7812, 0.1532),
  ('keyboard', 4, 'height', 0.7765, 0.03145),
  ('keyboard', 4, 'length', -0.6918, 0.1026),
  ('keyboard', 4, 'rectangularity', 0.821, 0.06236),
  ('keyboard', 4, 'spread_length', -0.7868, 0.06868),
  ('keyboard', 4, 'spread_width', -1.891, 0.08725),
  ('keyboard', 4, 'tilt_deg', 2.713, 0.9711),
  ('keyboard', 4, 'width', -1.743, 0.08234),
  ('keyboard', 4, 'z_max', 0.7799, 0.02964),
  ('keyboard', 4, 'z_min', 0.7753, 0.02725);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.1389, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'area_m2', -2.736, 0.1003),
  ('keyboard', 5, 'aspect', 1.024, 0.0742),
  ('keyboard', 5, 'behind', 0.1871, 0.1071),
  ('keyboard', 5, 'edge_free', 0.4263, 0.1477),
  ('keyboard', 5, 'edge_free_top', -0.01311, 0.2877),
  ('keyboard', 5, 'edge_joined', 0.5531, 0.1413),
  ('keyboard', 5, 'height', 0.7421, 0.07233),
  ('keyboard', 5, 'length', -0.7886, 0.05938),
  ('keyboard', 5, 'rectangularity', 0.8928, 0.05452),
  ('keyboard', 5, 'spread_length', -0.8292, 0.04147),
  ('keyboard', 5, 'spread_width', -1.873, 0.06848),
  ('keyboard', 5, 'tilt_deg', 5.179, 1.433),
  ('keyboard', 5, 'width', -1.813, 0.0786),
  ('keyboard', 5, 'z_max', 0.7463, 0.06757),
  ('keyboard', 5, 'z_min', 0.7393, 0.06244);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.08138, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'area_m2', -2.495, 0.128),
  ('keyboard', 6, 'aspect', 0.7665, 0.1198),
  ('keyboard', 6, 'behind', 0.308, 0.0981),
  ('keyboard', 6, 'edge_free', 0.03058, 0.04144),
  ('keyboard', 6, 'edge_free_top', -0.0006563, 0.3169),
  ('keyboard', 6, 'edge_joined', 0.9501, 0.06353),
  ('keyboard', 6, 'height', 0.7398, 0.0344),
  ('keyboard', 6, 'length', -0.7615, 0.08289),
  ('keyboard', 6, 'rectangularity', 0.8318, 0.03),
  ('keyboard', 6, 'spread_length', -0.8412, 0.07083),
  ('keyboard', 6, 'spread_width', -1.745, 0.0471),
  ('keyboard', 6, 'tilt_deg', 1.525, 0.8861),
  ('keyboard', 6, 'width', -1.519, 0.1132),
  ('keyboard', 6, 'z_max', 0.7395, 0.03688),
  ('keyboard', 6, 'z_min', 0.7365, 0.04081);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.05831, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'area_m2', -3.656, 0.1751),
  ('keyboard', 7, 'aspect', 0.341, 0.1269),
  ('keyboard', 7, 'behind', 0.3174, 0.1473),
  ('keyboard', 7, 'edge_free', 0.2131, 0.1136),
  ('keyboard', 7, 'edge_free_top', -0.002763, 0.3145),
  ('keyboard', 7, 'edge_joined', 0.6758, 0.2819),
  ('keyboard', 7, 'height', 0.7504, 0.04528),
  ('keyboard', 7, 'length', -1.518, 0.133),
  ('keyboard', 7, 'rectangularity', 0.7343, 0.04733),
  ('keyboard', 7, 'spread_length', -1.627, 0.05223),
  ('keyboard', 7, 'spread_width', -2.055, 0.04402),
  ('keyboard', 7, 'tilt_deg', 4.266, 0.8755),
  ('keyboard', 7, 'width', -1.838, 0.1132),
  ('keyboard', 7, 'z_max', 0.7521, 0.02699),
  ('keyboard', 7, 'z_min', 0.7464, 0.05791);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.05497, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'area_m2', -2.834, 0.2921),
  ('keyboard', 8, 'aspect', 0.9149, 0.1817),
  ('keyboard', 8, 'behind', 0.1176, 0.1363),
  ('keyboard', 8, 'edge_free', 0.2522, 0.1302),
  ('keyboard', 8, 'edge_free_top', -0.005964, 0.3102),
  ('keyboard', 8, 'edge_joined', 0.7024, 0.1533),
  ('keyboard', 8, 'height', 1.018, 0.09468),
  ('keyboard', 8, 'length', -0.8986, 0.1674),
  ('keyboard', 8, 'rectangularity', 0.8778, 0.1035),
  ('keyboard', 8, 'spread_length', -0.8648, 0.1305),
  ('keyboard', 8, 'spread_width', -1.845, 0.1117),
  ('keyboard', 8, 'tilt_deg', 4.716, 2.001),
  ('keyboard', 8, 'width', -1.77, 0.1541),
  ('keyboard', 8, 'z_max', 1.029, 0.08064),
  ('keyboard', 8, 'z_min', 1.025, 0.08108);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.05578, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'area_m2', -3.148, 0.09942),
  ('keyboard', 9, 'aspect', 0.2644, 0.154),
  ('keyboard', 9, 'behind', 0.2739, 0.1235),
  ('keyboard', 9, 'edge_free', 0.2579, 0.1275),
  ('keyboard', 9, 'edge_free_top', -0.003889, 0.3149),
  ('keyboard', 9, 'edge_joined', 0.6156, 0.1617),
  ('keyboard', 9, 'height', 0.7693, 0.03023),
  ('keyboard', 9, 'length', -1.326, 0.1123),
  ('keyboard', 9, 'rectangularity', 0.7863, 0.07425),
  ('keyboard', 9, 'spread_length', -1.46, 0.08198),
  ('keyboard', 9, 'spread_width', -1.791, 0.06366),
  ('keyboard', 9, 'tilt_deg', 4.736, 1.206),
  ('keyboard', 9, 'width', -1.581, 0.08388),
  ('keyboard', 9, 'z_max', 0.7777, 0.0225),
  ('keyboard', 9, 'z_min', 0.7631, 0.03118);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.02774, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'area_m2', -2.931, 0.3648),
  ('keyboard', 10, 'aspect', 0.9855, 0.4323),
  ('keyboard', 10, 'behind', 0.1362, 0.08014),
  ('keyboard', 10, 'edge_free', 0.1338, 0.1527),
  ('keyboard', 10, 'edge_free_top', -0.001101, 0.3228),
  ('keyboard', 10, 'edge_joined', 0.8551, 0.1339),
  ('keyboard', 10, 'height', 0.1309, 0.08923),
  ('keyboard', 10, 'length', -0.9252, 0.3381),
  ('keyboard', 10, 'rectangularity', 0.918, 0.04626),
  ('keyboard', 10, 'spread_length', -0.9458, 0.3368),
  ('keyboard', 10, 'spread_width', -1.953, 0.04402),
  ('keyboard', 10, 'tilt_deg', 2.472, 1.172),
  ('keyboard', 10, 'width', -1.902, 0.06117),
  ('keyboard', 10, 'z_max', 0.1267, 0.09664),
  ('keyboard', 10, 'z_min', 0.128, 0.08852);

-- chair_seat: 464 examples
UPDATE object_class SET prior = 0.009073 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -1.966, 0.4917)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.2778, 0.2692)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6667, 0.1575)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.6391, 0.1931)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_joined', 0.07025, 0.09208)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4685, 0.03041)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.6895, 0.1718)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7474, 0.1253)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7548, 0.1642)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.172, 0.3387)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 1.019, 0.9652)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -0.9676, 0.3195)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4731, 0.03064)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.465, 0.03064)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_seat';
DELETE FROM class_density WHERE class = 'chair_seat';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.131, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'area_m2', -1.627, 0.1252),
  ('chair_seat', 1, 'aspect', 0.1147, 0.08874),
  ('chair_seat', 1, 'behind', 0.6425, 0.09538),
  ('chair_seat', 1, 'edge_free', 0.7607, 0.1346),
  ('chair_seat', 1, 'edge_free_top', -0.0002012, 0.3157),
  ('chair_seat', 1, 'edge_joined', 0.06029, 0.07707),
  ('chair_seat', 1, 'height', 0.4912, 0.0225),
  ('chair_seat', 1, 'length', -0.671, 0.07218),
  ('chair_seat', 1, 'rectangularity', 0.8384, 0.06476),
  ('chair_seat', 1, 'spread_length', -0.7195, 0.06835),
  ('chair_seat', 1, 'spread_width', -0.9303, 0.08838),
  ('chair_seat', 1, 'tilt_deg', 0.7575, 0.5462),
  ('chair_seat', 1, 'width', -0.7878, 0.07102),
  ('chair_seat', 1, 'z_max', 0.4939, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4866, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.1047, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'area_m2', -1.615, 0.1028),
  ('chair_seat', 2, 'aspect', 0.1128, 0.06808),
  ('chair_seat', 2, 'behind', 0.6901, 0.08958),
  ('chair_seat', 2, 'edge_free', 0.8057, 0.1116),
  ('chair_seat', 2, 'edge_free_top', -9.521e-05, 0.3159),
  ('chair_seat', 2, 'edge_joined', 0.0355, 0.04836),
  ('chair_seat', 2, 'height', 0.4426, 0.0225),
  ('chair_seat', 2, 'length', -0.6651, 0.0709),
  ('chair_seat', 2, 'rectangularity', 0.8539, 0.06484),
  ('chair_seat', 2, 'spread_length', -0.7221, 0.05516),
  ('chair_seat', 2, 'spread_width', -0.9159, 0.07192),
  ('chair_seat', 2, 'tilt_deg', 0.6055, 0.45),
  ('chair_seat', 2, 'width', -0.7853, 0.06609),
  ('chair_seat', 2, 'z_max', 0.4483, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4427, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.08822, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'area_m2', -1.979, 0.1804),
  ('chair_seat', 3, 'aspect', 0.1195, 0.0675),
  ('chair_seat', 3, 'behind', 0.7245, 0.0956),
  ('chair_seat', 3, 'edge_free', 0.5604, 0.08808),
  ('chair_seat', 3, 'edge_free_top', -0.0001847, 0.3159),
  ('chair_seat', 3, 'edge_joined', 0.09463, 0.09531),
  ('chair_seat', 3, 'height', 0.4512, 0.0225),
  ('chair_seat', 3, 'length', -0.7103, 0.06279),
  ('chair_seat', 3, 'rectangularity', 0.6677, 0.1065),
  ('chair_seat', 3, 'spread_length', -0.7068, 0.06875),
  ('chair_seat', 3, 'spread_width', -1.11, 0.08567),
  ('chair_seat', 3, 'tilt_deg', 0.6482, 0.45),
  ('chair_seat', 3, 'width', -0.8502, 0.06041),
  ('chair_seat', 3, 'z_max', 0.457, 0.0225),
  ('chair_seat', 3, 'z_min', 0.4513, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.1215, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'area_m2', -1.545, 0.1327),
  ('chair_seat', 4, 'aspect', 0.2155, 0.1405),
  ('chair_seat', 4, 'behind', 0.715, 0.09522),
  ('chair_seat', 4, 'edge_free', 0.648, 0.1556),
  ('chair_seat', 4, 'edge_free_top', -0.0002111, 0.3158),
  ('chair_seat', 4, 'edge_joined', 0.1086, 0.1117),
  ('chair_seat', 4, 'height', 0.4658, 0.02464),
  ('chair_seat', 4, 'length', -0.5121, 0.1098),
  ('chair_seat', 4, 'rectangularity', 0.7443, 0.06159),
  ('chair_seat', 4, 'spread_length', -0.6478, 0.04715),
  ('chair_seat', 4, 'spread_width', -0.9291, 0.09505),
  ('chair_seat', 4, 'tilt_deg', 1.156, 0.9466),
  ('chair_seat', 4, 'width', -0.7248, 0.09825),
  ('chair_seat', 4, 'z_max', 0.4724, 0.02412),
  ('chair_seat', 4, 'z_min', 0.4615, 0.02483);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.1145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'area_m2', -1.998, 0.2441),
  ('chair_seat', 5, 'aspect', 0.2298, 0.1742),
  ('chair_seat', 5, 'behind', 0.6869, 0.07666),
  ('chair_seat', 5, 'edge_free', 0.6298, 0.1009),
  ('chair_seat', 5, 'edge_free_top', -0.0002676, 0.3158),
  ('chair_seat', 5, 'edge_joined', 0.01994, 0.03041),
  ('chair_seat', 5, 'height', 0.5001, 0.0225),
  ('chair_seat', 5, 'length', -0.6483, 0.1374),
  ('chair_seat', 5, 'rectangularity', 0.637, 0.1141),
  ('chair_seat', 5, 'spread_length', -0.6887, 0.1106),
  ('chair_seat', 5, 'spread_width', -1.201, 0.1481),
  ('chair_seat', 5, 'tilt_deg', 0.7485, 0.5242),
  ('chair_seat', 5, 'width', -0.8713, 0.1045),
  ('chair_seat', 5, 'z_max', 0.5043, 0.0225),
  ('chair_seat', 5, 'z_min', 0.498, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.1767, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'area_m2', -3.129, 0.3709),
  ('chair_seat', 6, 'aspect', 0.6193, 0.3291),
  ('chair_seat', 6, 'behind', 0.4477, 0.3425),
  ('chair_seat', 6, 'edge_free', 0.4584, 0.1517),
  ('chair_seat', 6, 'edge_free_top', -0.00358, 0.3149),
  ('chair_seat', 6, 'edge_joined', 0.07856, 0.09703),
  ('chair_seat', 6, 'height', 0.4749, 0.03555),
  ('chair_seat', 6, 'length', -1.033, 0.2829),
  ('chair_seat', 6, 'rectangularity', 0.6837, 0.07811),
  ('chair_seat', 6, 'spread_length', -1.141, 0.3182),
  ('chair_seat', 6, 'spread_width', -1.926, 0.1825),
  ('chair_seat', 6, 'tilt_deg', 2.783, 1.253),
  ('chair_seat', 6, 'width', -1.711, 0.2184),
  ('chair_seat', 6, 'z_max', 0.4886, 0.02839),
  ('chair_seat', 6, 'z_min', 0.4755, 0.03873);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.08846, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'area_m2', -2.453, 0.2119),
  ('chair_seat', 7, 'aspect', 0.7127, 0.1792),
  ('chair_seat', 7, 'behind', 0.6513, 0.1581),
  ('chair_seat', 7, 'edge_free', 0.5508, 0.1455),
  ('chair_seat', 7, 'edge_free_top', -0.0003108, 0.316),
  ('chair_seat', 7, 'edge_joined', 0.01391, 0.03),
  ('chair_seat', 7, 'height', 0.4792, 0.0225),
  ('chair_seat', 7, 'length', -0.6762, 0.1261),
  ('chair_seat', 7, 'rectangularity', 0.6778, 0.1207),
  ('chair_seat', 7, 'spread_length', -0.7221, 0.1218),
  ('chair_seat', 7, 'spread_width', -1.639, 0.1372),
  ('chair_seat', 7, 'tilt_deg', 1.15, 0.7684),
  ('chair_seat', 7, 'width', -1.381, 0.1329),
  ('chair_seat', 7, 'z_max', 0.4884, 0.0225),
  ('chair_seat', 7, 'z_min', 0.4811, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.0786, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'area_m2', -2.149, 0.2283),
  ('chair_seat', 8, 'aspect', 0.3613, 0.2401),
  ('chair_seat', 8, 'behind', 0.6568, 0.1313),
  ('chair_seat', 8, 'edge_free', 0.3643, 0.1254),
  ('chair_seat', 8, 'edge_free_top', -0.0004513, 0.316),
  ('chair_seat', 8, 'edge_joined', 0.2002, 0.07555),
  ('chair_seat', 8, 'height', 0.4882, 0.02499),
  ('chair_seat', 8, 'length', -0.7228, 0.1266),
  ('chair_seat', 8, 'rectangularity', 0.7198, 0.09727),
  ('chair_seat', 8, 'spread_length', -0.7544, 0.1056),
  ('chair_seat', 8, 'spread_width', -1.267, 0.1869),
  ('chair_seat', 8, 'tilt_deg', 1.882, 1.252),
  ('chair_seat', 8, 'width', -1.081, 0.1758),
  ('chair_seat', 8, 'z_max', 0.4991, 0.0242),
  ('chair_seat', 8, 'z_min', 0.4851, 0.02535);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.0297, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'area_m2', -1.951, 0.5027),
  ('chair_seat', 9, 'aspect', 0.3598, 0.2032),
  ('chair_seat', 9, 'behind', 0.6912, 0.1666),
  ('chair_seat', 9, 'edge_free', 0.5619, 0.08425),
  ('chair_seat', 9, 'edge_free_top', -0.0001704, 0.3159),
  ('chair_seat', 9, 'edge_joined', 0.01509, 0.03489),
  ('chair_seat', 9, 'height', 0.4374, 0.02345),
  ('chair_seat', 9, 'length', -0.5988, 0.3354),
  ('chair_seat', 9, 'rectangularity', 0.7279, 0.1641),
  ('chair_seat', 9, 'spread_length', -0.6656, 0.256),
  ('chair_seat', 9, 'spread_width', -1.206, 0.1528),
  ('chair_seat', 9, 'tilt_deg', 1.411, 0.9901),
  ('chair_seat', 9, 'width', -1.022, 0.1326),
  ('chair_seat', 9, 'z_max', 0.4455, 0.0225),
  ('chair_seat', 9, 'z_min', 0.4335, 0.02647);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 10, 0.01661, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 10, 'area_m2', -2.405, 0.243),
  ('chair_seat', 10, 'aspect', 0.4212, 0.09409),
  ('chair_seat', 10, 'behind', 0.1994, 0.2255),
  ('chair_seat', 10, 'edge_free', 0.6909, 0.2375),
  ('chair_seat', 10, 'edge_free_top', -0.001268, 0.3143),
  ('chair_seat', 10, 'edge_joined', 0.02285, 0.03),
  ('chair_seat', 10, 'height', 0.4085, 0.2135),
  ('chair_seat', 10, 'length', -0.8197, 0.07792),
  ('chair_seat', 10, 'rectangularity', 0.7095, 0.05914),
  ('chair_seat', 10, 'spread_length', -0.8839, 0.147),
  ('chair_seat', 10, 'spread_width', -1.471, 0.1589),
  ('chair_seat', 10, 'tilt_deg', 0.9969, 0.7427),
  ('chair_seat', 10, 'width', -1.241, 0.1328),
  ('chair_seat', 10, 'z_max', 0.4198, 0.1977),
  ('chair_seat', 10, 'z_min', 0.4182, 0.1894);

-- chair_back: 475 examples
UPDATE object_class SET prior = 0.04799 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.688, 0.5462)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3735, 0.2588)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.5799, 0.2803)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.8128, 0.181)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9575, 0.1475)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_joined', 0.09396, 0.1301)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8158, 0.0793)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5237, 0.2666)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7791, 0.1197)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6857, 0.2328)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.112, 0.3546)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.52, 3.798)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.8998, 0.2989)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.026, 0.0889)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4386, 0.1599)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_back';
DELETE FROM class_density WHERE class = 'chair_back';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1255, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'area_m2', -1.447, 0.09172),
  ('chair_back', 1, 'aspect', 0.1275, 0.06961),
  ('chair_back', 1, 'behind', 0.7383, 0.08222),
  ('chair_back', 1, 'edge_free', 0.8673, 0.0408),
  ('chair_back', 1, 'edge_free_top', 0.9972, 0.03),
  ('chair_back', 1, 'edge_joined', 0.071, 0.08903),
  ('chair_back', 1, 'height', 0.7989, 0.07476),
  ('chair_back', 1, 'length', -0.5827, 0.06634),
  ('chair_back', 1, 'rectangularity', 0.873, 0.08754),
  ('chair_back', 1, 'spread_length', -0.718, 0.04147),
  ('chair_back', 1, 'spread_width', -0.8383, 0.09358),
  ('chair_back', 1, 'tilt_deg', 81.44, 2.565),
  ('chair_back', 1, 'width', -0.7116, 0.0779),
  ('chair_back', 1, 'z_max', 1.002, 0.08834),
  ('chair_back', 1, 'z_min', 0.4517, 0.1072);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.1538, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'area_m2', -1.801, 0.1678),
  ('chair_back', 2, 'aspect', 0.1977, 0.1402),
  ('chair_back', 2, 'behind', 0.3715, 0.3579),
  ('chair_back', 2, 'edge_free', 0.8203, 0.1574),
  ('chair_back', 2, 'edge_free_top', 1, 0.03),
  ('chair_back', 2, 'edge_joined', 0.06427, 0.09095),
  ('chair_back', 2, 'height', 0.7931, 0.06387),
  ('chair_back', 2, 'length', -0.6971, 0.09803),
  ('chair_back', 2, 'rectangularity', 0.823, 0.1055),
  ('chair_back', 2, 'spread_length', -0.7553, 0.0559),
  ('chair_back', 2, 'spread_width', -1.091, 0.1411),
  ('chair_back', 2, 'tilt_deg', 80.76, 2.717),
  ('chair_back', 2, 'width', -0.8948, 0.08078),
  ('chair_back', 2, 'z_max', 0.9457, 0.0424),
  ('chair_back', 2, 'z_min', 0.4872, 0.09243);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.1145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'area_m2', -1.182, 0.1458),
  ('chair_back', 3, 'aspect', 0.399, 0.1458),
  ('chair_back', 3, 'behind', 0.511, 0.2663),
  ('chair_back', 3, 'edge_free', 0.9866, 0.0321),
  ('chair_back', 3, 'edge_free_top', 0.9999, 0.03),
  ('chair_back', 3, 'edge_joined', 0.009155, 0.03217),
  ('chair_back', 3, 'height', 0.8135, 0.05383),
  ('chair_back', 3, 'length', -0.3423, 0.1192),
  ('chair_back', 3, 'rectangularity', 0.8738, 0.0789),
  ('chair_back', 3, 'spread_length', -0.5266, 0.08554),
  ('chair_back', 3, 'spread_width', -0.8221, 0.1212),
  ('chair_back', 3, 'tilt_deg', 80.95, 2.883),
  ('chair_back', 3, 'width', -0.7129, 0.09318),
  ('chair_back', 3, 'z_max', 1.058, 0.06755),
  ('chair_back', 3, 'z_min', 0.3441, 0.04992);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.1728, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'area_m2', -2.786, 0.3755),
  ('chair_back', 4, 'aspect', 0.3958, 0.305),
  ('chair_back', 4, 'behind', 0.2492, 0.4136),
  ('chair_back', 4, 'edge_free', 0.8332, 0.2661),
  ('chair_back', 4, 'edge_free_top', 0.9988, 0.03),
  ('chair_back', 4, 'edge_joined', 0.03997, 0.09923),
  ('chair_back', 4, 'height', 0.8853, 0.07839),
  ('chair_back', 4, 'length', -0.9499, 0.1847),
  ('chair_back', 4, 'rectangularity', 0.6929, 0.1232),
  ('chair_back', 4, 'spread_length', -1.056, 0.2536),
  ('chair_back', 4, 'spread_width', -1.796, 0.1808),
  ('chair_back', 4, 'tilt_deg', 80.41, 2.484),
  ('chair_back', 4, 'width', -1.476, 0.2437),
  ('chair_back', 4, 'z_max', 1.047, 0.06996),
  ('chair_back', 4, 'z_min', 0.618, 0.02483);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.1125, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'area_m2', -1.488, 0.1112),
  ('chair_back', 5, 'aspect', 0.5096, 0.09656),
  ('chair_back', 5, 'behind', 0.4803, 0.3044),
  ('chair_back', 5, 'edge_free', 0.8592, 0.1043),
  ('chair_back', 5, 'edge_free_top', 0.9966, 0.03),
  ('chair_back', 5, 'edge_joined', 0.08609, 0.09093),
  ('chair_back', 5, 'height', 0.8354, 0.0456),
  ('chair_back', 5, 'length', -0.3387, 0.08247),
  ('chair_back', 5, 'rectangularity', 0.7503, 0.08708),
  ('chair_back', 5, 'spread_length', -0.5482, 0.08412),
  ('chair_back', 5, 'spread_width', -1.146, 0.1178),
  ('chair_back', 5, 'tilt_deg', 80.74, 2.47),
  ('chair_back', 5, 'width', -0.8482, 0.08745),
  ('chair_back', 5, 'z_max', 1.074, 0.06162),
  ('chair_back', 5, 'z_min', 0.3781, 0.065);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.09664, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'area_m2', -1.889, 0.1388),
  ('chair_back', 6, 'aspect', 0.6482, 0.1774),
  ('chair_back', 6, 'behind', 0.7482, 0.0672),
  ('chair_back', 6, 'edge_free', 0.7738, 0.1242),
  ('chair_back', 6, 'edge_free_top', 0.986, 0.03928),
  ('chair_back', 6, 'edge_joined', 0.1232, 0.08784),
  ('chair_back', 6, 'height', 0.8257, 0.08612),
  ('chair_back', 6, 'length', -0.4552, 0.1553),
  ('chair_back', 6, 'rectangularity', 0.7325, 0.1364),
  ('chair_back', 6, 'spread_length', -0.6192, 0.1295),
  ('chair_back', 6, 'spread_width', -1.425, 0.0991),
  ('chair_back', 6, 'tilt_deg', 80.27, 2.483),
  ('chair_back', 6, 'width', -1.097, 0.1231),
  ('chair_back', 6, 'z_max', 1.072, 0.07971),
  ('chair_back', 6, 'z_min', 0.4346, 0.07329);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.05976, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'area_m2', -1.266, 0.1467),
  ('chair_back', 7, 'aspect', 0.2812, 0.1409),
  ('chair_back', 7, 'behind', 0.7085, 0.0422),
  ('chair_back', 7, 'edge_free', 0.6754, 0.1459),
  ('chair_back', 7, 'edge_free_top', 0.98, 0.04263),
  ('chair_back', 7, 'edge_joined', 0.1817, 0.1409),
  ('chair_back', 7, 'height', 0.829, 0.05544),
  ('chair_back', 7, 'length', -0.3844, 0.07475),
  ('chair_back', 7, 'rectangularity', 0.7851, 0.0723),
  ('chair_back', 7, 'spread_length', -0.5905, 0.05534),
  ('chair_back', 7, 'spread_width', -0.8065, 0.1079),
  ('chair_back', 7, 'tilt_deg', 78.5, 1.863),
  ('chair_back', 7, 'width', -0.6576, 0.1039),
  ('chair_back', 7, 'z_max', 1.071, 0.0503),
  ('chair_back', 7, 'z_min', 0.4004, 0.02826);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.04761, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'area_m2', -2.223, 0.6612),
  ('chair_back', 8, 'aspect', 0.4261, 0.3283),
  ('chair_back', 8, 'behind', 0.4543, 0.4319),
  ('chair_back', 8, 'edge_free', 0.4884, 0.193),
  ('chair_back', 8, 'edge_free_top', 0.5153, 0.3076),
  ('chair_back', 8, 'edge_joined', 0.2411, 0.2881),
  ('chair_back', 8, 'height', 0.7752, 0.1811),
  ('chair_back', 8, 'length', -0.7135, 0.2546),
  ('chair_back', 8, 'rectangularity', 0.7445, 0.1245),
  ('chair_back', 8, 'spread_length', -0.8462, 0.2579),
  ('chair_back', 8, 'spread_width', -1.449, 0.4878),
  ('chair_back', 8, 'tilt_deg', 78.97, 2.466),
  ('chair_back', 8, 'width', -1.165, 0.473),
  ('chair_back', 8, 'z_max', 1.017, 0.1128),
  ('chair_back', 8, 'z_min', 0.4466, 0.1196);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.0669, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'area_m2', -1.106, 0.1913),
  ('chair_back', 9, 'aspect', 0.6972, 0.217),
  ('chair_back', 9, 'behind', 0.7033, 0.1287),
  ('chair_back', 9, 'edge_free', 0.8, 0.09616),
  ('chair_back', 9, 'edge_free_top', 0.9537, 0.05593),
  ('chair_back', 9, 'edge_joined', 0.1059, 0.08266),
  ('chair_back', 9, 'height', 0.7709, 0.06716),
  ('chair_back', 9, 'length', 0.003479, 0.1371),
  ('chair_back', 9, 'rectangularity', 0.6284, 0.09825),
  ('chair_back', 9, 'spread_length', -0.3983, 0.1265),
  ('chair_back', 9, 'spread_width', -0.9141, 0.1914),
  ('chair_back', 9, 'tilt_deg', 80.76, 2.608),
  ('chair_back', 9, 'width', -0.6419, 0.1817),
  ('chair_back', 9, 'z_max', 1.016, 0.08915),
  ('chair_back', 9, 'z_min', 0.04055, 0.07682);

-- door: 305 examples
UPDATE object_class SET prior = 0.01997 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.2076, 0.6645)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.807, 0.2981)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.1547, 0.2455)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.1459, 0.2383)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.2299, 0.3747)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_joined', 0.3623, 0.3335)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.132, 0.1955)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.6239, 0.3117)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8092, 0.1292)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4613, 0.3363)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.3314, 0.4184)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.22, 2.921)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1891, 0.3665)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.027, 0.3119)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1185, 0.2699)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'door';
DELETE FROM class_density WHERE class = 'door';
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.2219, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'area_m2', 0.5572, 0.08785),
  ('door', 1, 'aspect', 0.7741, 0.08195),
  ('door', 1, 'behind', -0.009707, 0.03),
  ('door', 1, 'edge_free', -0.002063, 0.03),
  ('door', 1, 'edge_free_top', 0.001517, 0.03),
  ('door', 1, 'edge_joined', 0.446, 0.3343),
  ('door', 1, 'height', 1.084, 0.07292),
  ('door', 1, 'length', 0.718, 0.03454),
  ('door', 1, 'rectangularity', 0.9009, 0.09411),
  ('door', 1, 'spread_length', 0.6325, 0.05128),
  ('door', 1, 'spread_width', -0.1436, 0.06615),
  ('door', 1, 'tilt_deg', 89.98, 0.45),
  ('door', 1, 'width', -0.06731, 0.0814),
  ('door', 1, 'z_max', 2.051, 0.0469),
  ('door', 1, 'z_min', 0.006078, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1188, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'area_m2', 0.6099, 0.1236),
  ('door', 2, 'aspect', 0.843, 0.08174),
  ('door', 2, 'behind', 0.5241, 0.1426),
  ('door', 2, 'edge_free', 0.3696, 0.1291),
  ('door', 2, 'edge_free_top', 0.7557, 0.1643),
  ('door', 2, 'edge_joined', 0.3678, 0.3178),
  ('door', 2, 'height', 1.066, 0.027),
  ('door', 2, 'length', 0.8183, 0.07864),
  ('door', 2, 'rectangularity', 0.8157, 0.04669),
  ('door', 2, 'spread_length', 0.6888, 0.04147),
  ('door', 2, 'spread_width', -0.08376, 0.1091),
  ('door', 2, 'tilt_deg', 89.98, 0.45),
  ('door', 2, 'width', 0.006264, 0.1152),
  ('door', 2, 'z_max', 2.235, 0.1226),
  ('door', 2, 'z_min', -0.006463, 0.02257);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.1638, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'area_m2', 0.2413, 0.1377),
  ('door', 3, 'aspect', 0.8522, 0.1922),
  ('door', 3, 'behind', -0.002321, 0.03),
  ('door', 3, 'edge_free', -0.0002217, 0.03),
  ('door', 3, 'edge_free_top', 0.003309, 0.03),
  ('door', 3, 'edge_joined', 0.34, 0.2982),
  ('door', 3, 'height', 1.246, 0.09765),
  ('door', 3, 'length', 0.6692, 0.08618),
  ('door', 3, 'rectangularity', 0.7632, 0.1201),
  ('door', 3, 'spread_length', 0.4152, 0.1282),
  ('door', 3, 'spread_width', -0.2669, 0.1272),
  ('door', 3, 'tilt_deg', 89.96, 0.45),
  ('door', 3, 'width', -0.1565, 0.114),
  ('door', 3, 'z_max', 2.056, 0.03952),
  ('door', 3, 'z_min', 0.1392, 0.1426);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.06627, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'area_m2', 0.4188, 0.1865),
  ('door', 4, 'aspect', 0.8209, 0.0812),
  ('door', 4, 'behind', 0.4255, 0.1041),
  ('door', 4, 'edge_free', 0.528, 0.1642),
  ('door', 4, 'edge_free_top', 0.888, 0.1174),
  ('door', 4, 'edge_joined', 0.1485, 0.1547),
  ('door', 4, 'height', 1.213, 0.06161),
  ('door', 4, 'length', 0.7689, 0.05971),
  ('door', 4, 'rectangularity', 0.7461, 0.1391),
  ('door', 4, 'spread_length', 0.3971, 0.1138),
  ('door', 4, 'spread_width', -0.1934, 0.1081),
  ('door', 4, 'tilt_deg', 89.97, 0.45),
  ('door', 4, 'width', -0.04758, 0.08051),
  ('door', 4, 'z_max', 2.171, 0.08741),
  ('door', 4, 'z_min', -0.001339, 0.02344);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.09426, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'area_m2', -0.2541, 0.2209),
  ('door', 5, 'aspect', 1.359, 0.1993),
  ('door', 5, 'behind', 0.1498, 0.154),
  ('door', 5, 'edge_free', 0.2173, 0.2394),
  ('door', 5, 'edge_free_top', 0.2303, 0.3783),
  ('door', 5, 'edge_joined', 0.1628, 0.1968),
  ('door', 5, 'height', 1.089, 0.1108),
  ('door', 5, 'length', 0.77, 0.08293),
  ('door', 5, 'rectangularity', 0.6775, 0.08675),
  ('door', 5, 'spread_length', 0.6738, 0.131),
  ('door', 5, 'spread_width', -1.077, 0.277),
  ('door', 5, 'tilt_deg', 83.55, 3.628),
  ('door', 5, 'width', -0.6522, 0.292),
  ('door', 5, 'z_max', 2.035, 0.1454),
  ('door', 5, 'z_min', 0.008505, 0.02378);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.08306, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'area_m2', -0.09718, 0.1664),
  ('door', 6, 'aspect', 0.4294, 0.1654),
  ('door', 6, 'behind', 0.01686, 0.1069),
  ('door', 6, 'edge_free', 0.004128, 0.03),
  ('door', 6, 'edge_free_top', 0.01725, 0.05793),
  ('door', 6, 'edge_joined', 0.4742, 0.3272),
  ('door', 6, 'height', 1.414, 0.0874),
  ('door', 6, 'length', 0.3355, 0.1377),
  ('door', 6, 'rectangularity', 0.7185, 0.1458),
  ('door', 6, 'spread_length', -0.01783, 0.1328),
  ('door', 6, 'spread_width', -0.2741, 0.08602),
  ('door', 6, 'tilt_deg', 89.96, 0.45),
  ('door', 6, 'width', -0.09222, 0.06308),
  ('door', 6, 'z_max', 2.071, 0.05311),
  ('door', 6, 'z_min', 0.5838, 0.1941);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.06463, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'area_m2', -0.6745, 0.327),
  ('door', 7, 'aspect', 0.6667, 0.3292),
  ('door', 7, 'behind', 0.1712, 0.1997),
  ('door', 7, 'edge_free', 0.1264, 0.1628),
  ('door', 7, 'edge_free_top', 0.01198, 0.05069),
  ('door', 7, 'edge_joined', 0.2735, 0.2373),
  ('door', 7, 'height', 0.8382, 0.3559),
  ('door', 7, 'length', 0.2034, 0.2519),
  ('door', 7, 'rectangularity', 0.725, 0.1578),
  ('door', 7, 'spread_length', 0.1077, 0.2319),
  ('door', 7, 'spread_width', -0.8129, 0.1935),
  ('door', 7, 'tilt_deg', 82.53, 8.727),
  ('door', 7, 'width', -0.5036, 0.2721),
  ('door', 7, 'z_max', 1.223, 0.4163),
  ('door', 7, 'z_min', 0.2584, 0.2939);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.03984, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'area_m2', -2.138, 0.5593),
  ('door', 8, 'aspect', 0.9206, 0.5419),
  ('door', 8, 'behind', 0.01285, 0.03922),
  ('door', 8, 'edge_free', 0.3186, 0.1321),
  ('door', 8, 'edge_free_top', 0.1132, 0.1537),
  ('door', 8, 'edge_joined', 0.3667, 0.232),
  ('door', 8, 'height', 0.9483, 0.4232),
  ('door', 8, 'length', -0.4326, 0.4868),
  ('door', 8, 'rectangularity', 0.7287, 0.08578),
  ('door', 8, 'spread_length', -0.5561, 0.4165),
  ('door', 8, 'spread_width', -1.556, 0.2195),
  ('door', 8, 'tilt_deg', 87.93, 2.289),
  ('door', 8, 'width', -1.399, 0.1873),
  ('door', 8, 'z_max', 1.285, 0.4682),
  ('door', 8, 'z_min', 0.5146, 0.4016);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.077, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'area_m2', 0.08, 0.1943),
  ('door', 9, 'aspect', 0.5458, 0.2097),
  ('door', 9, 'behind', 0.5644, 0.09566),
  ('door', 9, 'edge_free', 0.4187, 0.2617),
  ('door', 9, 'edge_free_top', 0.663, 0.1575),
  ('door', 9, 'edge_joined', 0.3752, 0.3238),
  ('door', 9, 'height', 1.387, 0.07272),
  ('door', 9, 'length', 0.4828, 0.1876),
  ('door', 9, 'rectangularity', 0.7333, 0.09869),
  ('door', 9, 'spread_length', 0.1418, 0.1942),
  ('door', 9, 'spread_width', -0.1629, 0.1223),
  ('door', 9, 'tilt_deg', 89.81, 0.6823),
  ('door', 9, 'width', -0.08613, 0.07641),
  ('door', 9, 'z_max', 2.197, 0.1481),
  ('door', 9, 'z_min', 0.5923, 0.2197);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.02052, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'area_m2', 0.7302, 0.3352),
  ('door', 10, 'aspect', 0.4937, 0.1963),
  ('door', 10, 'behind', 0.01392, 0.04739),
  ('door', 10, 'edge_free', 0.007376, 0.03109),
  ('door', 10, 'edge_free_top', 0.01868, 0.05923),
  ('door', 10, 'edge_joined', 0.5669, 0.2369),
  ('door', 10, 'height', 1.131, 0.1439),
  ('door', 10, 'length', 0.8402, 0.1733),
  ('door', 10, 'rectangularity', 0.6198, 0.07387),
  ('door', 10, 'spread_length', 0.5692, 0.178),
  ('door', 10, 'spread_width', 0.06148, 0.2175),
  ('door', 10, 'tilt_deg', 89.65, 0.8151),
  ('door', 10, 'width', 0.3518, 0.2698),
  ('door', 10, 'z_max', 2.338, 0.3195),
  ('door', 10, 'z_min', 0.0594, 0.08339);

-- window: 662 examples
UPDATE object_class SET prior = 0.02271 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', -0.3427, 0.7842)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.4501, 0.3941)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 2.731e-05, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.08088, 0.1533)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.06975, 0.1979)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_joined', 0.3905, 0.3574)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.493, 0.2127)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.1746, 0.345)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.802, 0.1431)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.1576, 0.3804)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.389, 0.5522)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.7, 0.5215)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.2782, 0.4741)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.028, 0.2758)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 1.022, 0.2229)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'window';
DELETE FROM class_density WHERE class = 'window';
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.1583, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'area_m2', -0.08992, 0.1582),
  ('window', 1, 'aspect', 0.2587, 0.1792),
  ('window', 1, 'behind', -0.003792, 0.03),
  ('window', 1, 'edge_free', 0.007945, 0.04074),
  ('window', 1, 'edge_free_top', 0.001593, 0.03),
  ('window', 1, 'edge_joined', 0.5478, 0.4574),
  ('window', 1, 'height', 1.434, 0.1312),
  ('window', 1, 'length', 0.1857, 0.1132),
  ('window', 1, 'rectangularity', 0.8771, 0.06206),
  ('window', 1, 'spread_length', 0.2018, 0.1258),
  ('window', 1, 'spread_width', -0.1876, 0.1672),
  ('window', 1, 'tilt_deg', 89.54, 0.45),
  ('window', 1, 'width', -0.1258, 0.09943),
  ('window', 1, 'z_max', 2.067, 0.1609),
  ('window', 1, 'z_min', 0.9634, 0.06024);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1288, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'area_m2', -1.015, 0.6144),
  ('window', 2, 'aspect', 0.486, 0.3207),
  ('window', 2, 'behind', -0.007173, 0.03),
  ('window', 2, 'edge_free', -0.002673, 0.03),
  ('window', 2, 'edge_free_top', -0.002844, 0.03),
  ('window', 2, 'edge_joined', 0.6542, 0.3589),
  ('window', 2, 'height', 1.31, 0.1971),
  ('window', 2, 'length', -0.06667, 0.3106),
  ('window', 2, 'rectangularity', 0.7843, 0.101),
  ('window', 2, 'spread_length', -0.02963, 0.3701),
  ('window', 2, 'spread_width', -0.7398, 0.2455),
  ('window', 2, 'tilt_deg', 89.46, 0.45),
  ('window', 2, 'width', -0.6644, 0.227),
  ('window', 2, 'z_max', 1.703, 0.3287),
  ('window', 2, 'z_min', 0.9825, 0.06955);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.1796, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'area_m2', 0.3235, 0.166),
  ('window', 3, 'aspect', 0.1571, 0.116),
  ('window', 3, 'behind', -0.000624, 0.03),
  ('window', 3, 'edge_free', -0.002277, 0.03),
  ('window', 3, 'edge_free_top', 0.0001562, 0.03),
  ('window', 3, 'edge_joined', 0.02075, 0.03525),
  ('window', 3, 'height', 1.523, 0.1027),
  ('window', 3, 'length', 0.3249, 0.09238),
  ('window', 3, 'rectangularity', 0.8929, 0.1093),
  ('window', 3, 'spread_length', 0.48, 0.07337),
  ('window', 3, 'spread_width', 0.2537, 0.1077),
  ('window', 3, 'tilt_deg', 89.75, 0.45),
  ('window', 3, 'width', 0.1181, 0.09994),
  ('window', 3, 'z_max', 2.151, 0.1156),
  ('window', 3, 'z_min', 0.896, 0.04433);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.1209, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'area_m2', -0.6294, 0.4299),
  ('window', 4, 'aspect', 0.6252, 0.2947),
  ('window', 4, 'behind', -0.005898, 0.03),
  ('window', 4, 'edge_free', 0.164, 0.1194),
  ('window', 4, 'edge_free_top', 0.007893, 0.03),
  ('window', 4, 'edge_joined', 0.4473, 0.2972),
  ('window', 4, 'height', 1.847, 0.1212),
  ('window', 4, 'length', 0.09544, 0.2504),
  ('window', 4, 'rectangularity', 0.7878, 0.0779),
  ('window', 4, 'spread_length', 0.06381, 0.3031),
  ('window', 4, 'spread_width', -0.7344, 0.2359),
  ('window', 4, 'tilt_deg', 89.74, 0.45),
  ('window', 4, 'width', -0.5477, 0.2602),
  ('window', 4, 'z_max', 2.149, 0.1291),
  ('window', 4, 'z_min', 1.596, 0.145);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.09256, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'area_m2', -0.03918, 0.3195),
  ('window', 5, 'aspect', 0.2441, 0.1391),
  ('window', 5, 'behind', -0.001009, 0.03),
  ('window', 5, 'edge_free', 0.09774, 0.1184),
  ('window', 5, 'edge_free_top', 0.008085, 0.03),
  ('window', 5, 'edge_joined', 0.257, 0.2523),
  ('window', 5, 'height', 1.61, 0.1657),
  ('window', 5, 'length', 0.3338, 0.09522),
  ('window', 5, 'rectangularity', 0.6711, 0.2471),
  ('window', 5, 'spread_length', 0.4033, 0.1784),
  ('window', 5, 'spread_width', 0.04793, 0.1806),
  ('window', 5, 'tilt_deg', 89.7, 0.45),
  ('window', 5, 'width', 0.07836, 0.09003),
  ('window', 5, 'z_max', 2.222, 0.09744),
  ('window', 5, 'z_min', 0.9994, 0.113);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.07106, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'area_m2', -0.1702, 0.2238),
  ('window', 6, 'aspect', 0.2917, 0.1847),
  ('window', 6, 'behind', -0.003898, 0.03),
  ('window', 6, 'edge_free', 0.2851, 0.1745),
  ('window', 6, 'edge_free_top', 0.3705, 0.361),
  ('window', 6, 'edge_joined', 0.4785, 0.2564),
  ('window', 6, 'height', 1.461, 0.1255),
  ('window', 6, 'length', 0.171, 0.1421),
  ('window', 6, 'rectangularity', 0.8273, 0.07456),
  ('window', 6, 'spread_length', 0.1481, 0.1632),
  ('window', 6, 'spread_width', -0.2495, 0.2006),
  ('window', 6, 'tilt_deg', 89.74, 0.45),
  ('window', 6, 'width', -0.1353, 0.1495),
  ('window', 6, 'z_max', 2.047, 0.1586),
  ('window', 6, 'z_min', 1.006, 0.0802);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.09396, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'area_m2', -1.48, 0.3595),
  ('window', 7, 'aspect', 1.435, 0.287),
  ('window', 7, 'behind', -0.001626, 0.03),
  ('window', 7, 'edge_free', 0.04195, 0.09177),
  ('window', 7, 'edge_free_top', 0.08745, 0.1682),
  ('window', 7, 'edge_joined', 0.2685, 0.1759),
  ('window', 7, 'height', 1.219, 0.2099),
  ('window', 7, 'length', 0.1539, 0.128),
  ('window', 7, 'rectangularity', 0.7231, 0.1465),
  ('window', 7, 'spread_length', 0.162, 0.1261),
  ('window', 7, 'spread_width', -1.532, 0.3624),
  ('window', 7, 'tilt_deg', 88.69, 0.8847),
  ('window', 7, 'width', -1.295, 0.2507),
  ('window', 7, 'z_max', 1.563, 0.3854),
  ('window', 7, 'z_min', 0.9125, 0.04111);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.02219, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'area_m2', -2.007, 0.8585),
  ('window', 8, 'aspect', 0.7065, 0.3013),
  ('window', 8, 'behind', 0.04337, 0.1727),
  ('window', 8, 'edge_free', 0.1765, 0.2295),
  ('window', 8, 'edge_free_top', 0.1336, 0.2218),
  ('window', 8, 'edge_joined', 0.4444, 0.3399),
  ('window', 8, 'height', 1.447, 0.3393),
  ('window', 8, 'length', -0.5177, 0.4768),
  ('window', 8, 'rectangularity', 0.6926, 0.08941),
  ('window', 8, 'spread_length', -0.5132, 0.571),
  ('window', 8, 'spread_width', -1.33, 0.5147),
  ('window', 8, 'tilt_deg', 87.12, 7.771),
  ('window', 8, 'width', -1.118, 0.5364),
  ('window', 8, 'z_max', 1.788, 0.6306),
  ('window', 8, 'z_min', 1.021, 0.5426);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.04029, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'area_m2', -0.9772, 0.3103),
  ('window', 9, 'aspect', 0.4257, 0.269),
  ('window', 9, 'behind', -0.002959, 0.03),
  ('window', 9, 'edge_free', 0.4723, 0.2723),
  ('window', 9, 'edge_free_top', 0.6142, 0.2274),
  ('window', 9, 'edge_joined', 0.3122, 0.2111),
  ('window', 9, 'height', 1.419, 0.1811),
  ('window', 9, 'length', -0.05191, 0.2105),
  ('window', 9, 'rectangularity', 0.69, 0.1606),
  ('window', 9, 'spread_length', -0.02243, 0.147),
  ('window', 9, 'spread_width', -0.6646, 0.1744),
  ('window', 9, 'tilt_deg', 89.61, 0.4949),
  ('window', 9, 'width', -0.5145, 0.177),
  ('window', 9, 'z_max', 1.914, 0.1541),
  ('window', 9, 'z_min', 1.043, 0.06759);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.04232, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'area_m2', 1.302, 0.4394),
  ('window', 10, 'aspect', 0.889, 0.2971),
  ('window', 10, 'behind', -0.001321, 0.03),
  ('window', 10, 'edge_free', 0.01314, 0.0794),
  ('window', 10, 'edge_free_top', 0.01503, 0.07221),
  ('window', 10, 'edge_joined', 0.1933, 0.1957),
  ('window', 10, 'height', 1.482, 0.08427),
  ('window', 10, 'length', 1.246, 0.2724),
  ('window', 10, 'rectangularity', 0.7444, 0.2094),
  ('window', 10, 'spread_length', 1.196, 0.1944),
  ('window', 10, 'spread_width', 0.2508, 0.1906),
  ('window', 10, 'tilt_deg', 89.86, 0.45),
  ('window', 10, 'width', 0.3809, 0.2823),
  ('window', 10, 'z_max', 2.346, 0.2512),
  ('window', 10, 'z_min', 0.8008, 0.2704);

-- whiteboard: 261 examples
UPDATE object_class SET prior = 0.01367 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.01341, 0.8878)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.466, 0.3213)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.01439, 0.08672)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.02827, 0.05352)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.03146, 0.05569)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_joined', 0.7769, 0.1993)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.402, 0.1535)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.3477, 0.4302)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.8206, 0.1004)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.2025, 0.4392)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.3454, 0.4955)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.61, 1.614)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', -0.1231, 0.4974)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 1.948, 0.242)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.8756, 0.1979)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'whiteboard';
DELETE FROM class_density WHERE class = 'whiteboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.2813, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'area_m2', 0.7238, 0.1376),
  ('whiteboard', 1, 'aspect', 0.6131, 0.1439),
  ('whiteboard', 1, 'behind', -0.0003979, 0.03),
  ('whiteboard', 1, 'edge_free', 0.02918, 0.03),
  ('whiteboard', 1, 'edge_free_top', 0.02421, 0.0324),
  ('whiteboard', 1, 'edge_joined', 0.8347, 0.1142),
  ('whiteboard', 1, 'height', 1.423, 0.06109),
  ('whiteboard', 1, 'length', 0.7471, 0.09574),
  ('whiteboard', 1, 'rectangularity', 0.8259, 0.09897),
  ('whiteboard', 1, 'spread_length', 0.5659, 0.0995),
  ('whiteboard', 1, 'spread_width', -0.1396, 0.1147),
  ('whiteboard', 1, 'tilt_deg', 90.04, 0.45),
  ('whiteboard', 1, 'width', 0.1518, 0.08311),
  ('whiteboard', 1, 'z_max', 2.024, 0.1015),
  ('whiteboard', 1, 'z_min', 0.8797, 0.07297);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.144, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'area_m2', 0.2042, 0.1402),
  ('whiteboard', 2, 'aspect', 0.1515, 0.0779),
  ('whiteboard', 2, 'behind', 0.003504, 0.03623),
  ('whiteboard', 2, 'edge_free', 0.02439, 0.03),
  ('whiteboard', 2, 'edge_free_top', 0.02647, 0.03508),
  ('whiteboard', 2, 'edge_joined', 0.8035, 0.08616),
  ('whiteboard', 2, 'height', 1.49, 0.06056),
  ('whiteboard', 2, 'length', 0.2295, 0.07709),
  ('whiteboard', 2, 'rectangularity', 0.8882, 0.03352),
  ('whiteboard', 2, 'spread_length', 0.1217, 0.07281),
  ('whiteboard', 2, 'spread_width', -0.05105, 0.07828),
  ('whiteboard', 2, 'tilt_deg', 90.18, 0.45),
  ('whiteboard', 2, 'width', 0.09286, 0.05137),
  ('whiteboard', 2, 'z_max', 2.024, 0.08818),
  ('whiteboard', 2, 'z_min', 0.9141, 0.04633);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.1408, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'area_m2', 0.4349, 0.1118),
  ('whiteboard', 3, 'aspect', 0.3832, 0.1133),
  ('whiteboard', 3, 'behind', 3.711e-05, 0.03),
  ('whiteboard', 3, 'edge_free', 0.03092, 0.0316),
  ('whiteboard', 3, 'edge_free_top', 0.04094, 0.05277),
  ('whiteboard', 3, 'edge_joined', 0.7824, 0.115),
  ('whiteboard', 3, 'height', 1.439, 0.0744),
  ('whiteboard', 3, 'length', 0.4826, 0.07612),
  ('whiteboard', 3, 'rectangularity', 0.8342, 0.08642),
  ('whiteboard', 3, 'spread_length', 0.3407, 0.06445),
  ('whiteboard', 3, 'spread_width', -0.1416, 0.128),
  ('whiteboard', 3, 'tilt_deg', 90.12, 0.4909),
  ('whiteboard', 3, 'width', 0.1369, 0.08931),
  ('whiteboard', 3, 'z_max', 2.02, 0.09864),
  ('whiteboard', 3, 'z_min', 0.8914, 0.06224);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.1156, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'area_m2', -0.4279, 0.32),
  ('whiteboard', 4, 'aspect', 0.4, 0.297),
  ('whiteboard', 4, 'behind', -0.004364, 0.03),
  ('whiteboard', 4, 'edge_free', 0.02409, 0.03),
  ('whiteboard', 4, 'edge_free_top', 0.01395, 0.0328),
  ('whiteboard', 4, 'edge_joined', 0.7441, 0.1742),
  ('whiteboard', 4, 'height', 1.347, 0.1028),
  ('whiteboard', 4, 'length', 0.1162, 0.1378),
  ('whiteboard', 4, 'rectangularity', 0.7818, 0.05918),
  ('whiteboard', 4, 'spread_length', -0.1344, 0.1049),
  ('whiteboard', 4, 'spread_width', -0.5725, 0.1414),
  ('whiteboard', 4, 'tilt_deg', 89.88, 0.8181),
  ('whiteboard', 4, 'width', -0.2816, 0.2702),
  ('whiteboard', 4, 'z_max', 1.997, 0.1225),
  ('whiteboard', 4, 'z_min', 0.8669, 0.04529);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.07559, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'area_m2', -1.955, 0.4869),
  ('whiteboard', 5, 'aspect', 0.7443, 0.4104),
  ('whiteboard', 5, 'behind', -0.00641, 0.03),
  ('whiteboard', 5, 'edge_free', 0.03366, 0.108),
  ('whiteboard', 5, 'edge_free_top', 0.0215, 0.05189),
  ('whiteboard', 5, 'edge_joined', 0.8465, 0.2694),
  ('whiteboard', 5, 'height', 1.387, 0.2598),
  ('whiteboard', 5, 'length', -0.484, 0.3317),
  ('whiteboard', 5, 'rectangularity', 0.783, 0.07252),
  ('whiteboard', 5, 'spread_length', -0.73, 0.3141),
  ('whiteboard', 5, 'spread_width', -1.436, 0.3059),
  ('whiteboard', 5, 'tilt_deg', 89.75, 1.132),
  ('whiteboard', 5, 'width', -1.236, 0.3624),
  ('whiteboard', 5, 'z_max', 1.758, 0.3122),
  ('whiteboard', 5, 'z_min', 0.9963, 0.1344);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.06355, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'area_m2', 0.7749, 0.3121),
  ('whiteboard', 6, 'aspect', 0.6204, 0.2319),
  ('whiteboard', 6, 'behind', 0.00194, 0.03),
  ('whiteboard', 6, 'edge_free', 0.02122, 0.03),
  ('whiteboard', 6, 'edge_free_top', 0.04423, 0.04982),
  ('whiteboard', 6, 'edge_joined', 0.5808, 0.1374),
  ('whiteboard', 6, 'height', 1.449, 0.1024),
  ('whiteboard', 6, 'length', 0.8776, 0.19),
  ('whiteboard', 6, 'rectangularity', 0.6704, 0.07828),
  ('whiteboard', 6, 'spread_length', 0.7024, 0.1722),
  ('whiteboard', 6, 'spread_width', -0.08758, 0.3187),
  ('whiteboard', 6, 'tilt_deg', 89.7, 1.087),
  ('whiteboard', 6, 'width', 0.2977, 0.1728),
  ('whiteboard', 6, 'z_max', 2.1, 0.08736),
  ('whiteboard', 6, 'z_min', 0.6078, 0.3375);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.06469, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'area_m2', -0.07393, 0.3442),
  ('whiteboard', 7, 'aspect', 0.9459, 0.4117),
  ('whiteboard', 7, 'behind', -0.00022, 0.03),
  ('whiteboard', 7, 'edge_free', 0.01503, 0.03394),
  ('whiteboard', 7, 'edge_free_top', 0.06022, 0.03),
  ('whiteboard', 7, 'edge_joined', 0.4796, 0.1596),
  ('whiteboard', 7, 'height', 0.9797, 0.2354),
  ('whiteboard', 7, 'length', 0.5247, 0.2208),
  ('whiteboard', 7, 'rectangularity', 0.7876, 0.07583),
  ('whiteboard', 7, 'spread_length', 0.4442, 0.2531),
  ('whiteboard', 7, 'spread_width', -0.5418, 0.3307),
  ('whiteboard', 7, 'tilt_deg', 87.94, 0.7661),
  ('whiteboard', 7, 'width', -0.365, 0.3113),
  ('whiteboard', 7, 'z_max', 1.293, 0.24),
  ('whiteboard', 7, 'z_min', 0.4977, 0.3027);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.03202, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'area_m2', -0.1988, 0.8787),
  ('whiteboard', 8, 'aspect', 0.5366, 0.2063),
  ('whiteboard', 8, 'behind', 0.4902, 0.2093),
  ('whiteboard', 8, 'edge_free', 0.06093, 0.08058),
  ('whiteboard', 8, 'edge_free_top', 0.06839, 0.1038),
  ('whiteboard', 8, 'edge_joined', 0.7952, 0.1703),
  ('whiteboard', 8, 'height', 1.44, 0.2038),
  ('whiteboard', 8, 'length', 0.439, 0.5044),
  ('whiteboard', 8, 'rectangularity', 0.6708, 0.2713),
  ('whiteboard', 8, 'spread_length', 0.356, 0.5833),
  ('whiteboard', 8, 'spread_width', -0.2557, 0.4972),
  ('whiteboard', 8, 'tilt_deg', 61.65, 33.11),
  ('whiteboard', 8, 'width', -0.06219, 0.505),
  ('whiteboard', 8, 'z_max', 1.98, 0.621),
  ('whiteboard', 8, 'z_min', 0.928, 0.2847);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 9, 0.03248, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 9, 'area_m2', -0.02749, 0.1819),
  ('whiteboard', 9, 'aspect', 0.2232, 0.1019),
  ('whiteboard', 9, 'behind', 0.001065, 0.03),
  ('whiteboard', 9, 'edge_free', 0.204, 0.2613),
  ('whiteboard', 9, 'edge_free_top', 0.2159, 0.1816),
  ('whiteboard', 9, 'edge_joined', 0.6582, 0.2174),
  ('whiteboard', 9, 'height', 1.374, 0.03843),
  ('whiteboard', 9, 'length', 0.2207, 0.09328),
  ('whiteboard', 9, 'rectangularity', 0.7848, 0.04888),
  ('whiteboard', 9, 'spread_length', 0.08364, 0.09178),
  ('whiteboard', 9, 'spread_width', -0.336, 0.1187),
  ('whiteboard', 9, 'tilt_deg', 89.87, 1.303),
  ('whiteboard', 9, 'width', -0.0006256, 0.1101),
  ('whiteboard', 9, 'z_max', 1.92, 0.07792),
  ('whiteboard', 9, 'z_min', 0.8382, 0.04747);

-- shelf: 1131 examples
UPDATE object_class SET prior = 0.07163 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.548, 0.7916)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.8926, 0.4407)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5515, 0.3272)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3325, 0.1735)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4463, 0.3529)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_joined', 0.2935, 0.2409)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.907, 0.4973)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.1339, 0.5364)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6954, 0.1302)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.272, 0.5303)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.239, 0.3825)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 51.83, 43.33)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.032, 0.3572)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.205, 0.6313)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5703, 0.5851)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'shelf';
DELETE FROM class_density WHERE class = 'shelf';
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.1765, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'area_m2', -1.447, 0.44),
  ('shelf', 1, 'aspect', 0.898, 0.3903),
  ('shelf', 1, 'behind', 0.8002, 0.1544),
  ('shelf', 1, 'edge_free', 0.3632, 0.09565),
  ('shelf', 1, 'edge_free_top', 0.4508, 0.3913),
  ('shelf', 1, 'edge_joined', 0.1018, 0.1737),
  ('shelf', 1, 'height', 1.143, 0.2333),
  ('shelf', 1, 'length', -0.03277, 0.3263),
  ('shelf', 1, 'rectangularity', 0.7374, 0.1439),
  ('shelf', 1, 'spread_length', -0.3188, 0.3349),
  ('shelf', 1, 'spread_width', -1.114, 0.1955),
  ('shelf', 1, 'tilt_deg', 90.19, 0.45),
  ('shelf', 1, 'width', -0.9388, 0.1274),
  ('shelf', 1, 'z_max', 1.715, 0.2498),
  ('shelf', 1, 'z_min', 0.4221, 0.2747);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.1433, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'area_m2', -0.5539, 0.2787),
  ('shelf', 2, 'aspect', 1.49, 0.1578),
  ('shelf', 2, 'behind', 0.7473, 0.1168),
  ('shelf', 2, 'edge_free', 0.3943, 0.06121),
  ('shelf', 2, 'edge_free_top', 0.552, 0.2655),
  ('shelf', 2, 'edge_joined', 0.2495, 0.19),
  ('shelf', 2, 'height', 1.002, 0.1127),
  ('shelf', 2, 'length', 0.6193, 0.1265),
  ('shelf', 2, 'rectangularity', 0.6811, 0.09857),
  ('shelf', 2, 'spread_length', 0.4783, 0.1099),
  ('shelf', 2, 'spread_width', -1.056, 0.1546),
  ('shelf', 2, 'tilt_deg', 89.98, 1.336),
  ('shelf', 2, 'width', -0.847, 0.1679),
  ('shelf', 2, 'z_max', 1.997, 0.142),
  ('shelf', 2, 'z_min', 0.061, 0.1273);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.1141, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'area_m2', -1.393, 0.4529),
  ('shelf', 3, 'aspect', 0.7275, 0.2924),
  ('shelf', 3, 'behind', 0.7182, 0.1146),
  ('shelf', 3, 'edge_free', 0.3418, 0.106),
  ('shelf', 3, 'edge_free_top', 0.447, 0.1036),
  ('shelf', 3, 'edge_joined', 0.4914, 0.2323),
  ('shelf', 3, 'height', 1.745, 0.2012),
  ('shelf', 3, 'length', -0.1707, 0.2853),
  ('shelf', 3, 'rectangularity', 0.8048, 0.1022),
  ('shelf', 3, 'spread_length', -0.3827, 0.2395),
  ('shelf', 3, 'spread_width', -1.011, 0.1395),
  ('shelf', 3, 'tilt_deg', 1.202, 0.643),
  ('shelf', 3, 'width', -0.9472, 0.1633),
  ('shelf', 3, 'z_max', 1.725, 0.201),
  ('shelf', 3, 'z_min', 1.736, 0.1937);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.1004, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'area_m2', -1.714, 0.4619),
  ('shelf', 4, 'aspect', 0.9592, 0.3767),
  ('shelf', 4, 'behind', 0.6519, 0.09609),
  ('shelf', 4, 'edge_free', 0.4263, 0.06278),
  ('shelf', 4, 'edge_free_top', 0.4457, 0.1104),
  ('shelf', 4, 'edge_joined', 0.317, 0.101),
  ('shelf', 4, 'height', 0.4799, 0.07245),
  ('shelf', 4, 'length', -0.1937, 0.3201),
  ('shelf', 4, 'rectangularity', 0.6736, 0.1188),
  ('shelf', 4, 'spread_length', -0.2456, 0.1383),
  ('shelf', 4, 'spread_width', -1.326, 0.2839),
  ('shelf', 4, 'tilt_deg', 2.935, 1.298),
  ('shelf', 4, 'width', -1.091, 0.1855),
  ('shelf', 4, 'z_max', 0.489, 0.07203),
  ('shelf', 4, 'z_min', 0.4933, 0.07413);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.1033, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'area_m2', -2.311, 0.8032),
  ('shelf', 5, 'aspect', 0.3291, 0.3768),
  ('shelf', 5, 'behind', 0.01102, 0.03),
  ('shelf', 5, 'edge_free', 0.02504, 0.05339),
  ('shelf', 5, 'edge_free_top', 0.005407, 0.03),
  ('shelf', 5, 'edge_joined', 0.08219, 0.0744),
  ('shelf', 5, 'height', 0.8801, 0.4257),
  ('shelf', 5, 'length', -0.6581, 0.5277),
  ('shelf', 5, 'rectangularity', 0.7214, 0.1769),
  ('shelf', 5, 'spread_length', -0.6432, 0.5467),
  ('shelf', 5, 'spread_width', -1.337, 0.7282),
  ('shelf', 5, 'tilt_deg', 89.59, 1.039),
  ('shelf', 5, 'width', -1.26, 0.7443),
  ('shelf', 5, 'z_max', 0.9358, 0.5164),
  ('shelf', 5, 'z_min', 0.5647, 0.3806);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.133, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'area_m2', -1.105, 0.266),
  ('shelf', 6, 'aspect', 1.166, 0.2144),
  ('shelf', 6, 'behind', 0.7714, 0.07388),
  ('shelf', 6, 'edge_free', 0.4321, 0.04078),
  ('shelf', 6, 'edge_free_top', 0.6348, 0.3182),
  ('shelf', 6, 'edge_joined', 0.183, 0.2057),
  ('shelf', 6, 'height', 0.6774, 0.1605),
  ('shelf', 6, 'length', 0.2425, 0.1391),
  ('shelf', 6, 'rectangularity', 0.6464, 0.1069),
  ('shelf', 6, 'spread_length', 0.04449, 0.1288),
  ('shelf', 6, 'spread_width', -1.158, 0.1974),
  ('shelf', 6, 'tilt_deg', 90.12, 0.5791),
  ('shelf', 6, 'width', -0.8738, 0.1518),
  ('shelf', 6, 'z_max', 1.282, 0.2218),
  ('shelf', 6, 'z_min', 0.02873, 0.03458);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.03505, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'area_m2', -2.294, 0.7387),
  ('shelf', 7, 'aspect', 0.6725, 0.463),
  ('shelf', 7, 'behind', -0.008079, 0.03),
  ('shelf', 7, 'edge_free', 0.2006, 0.1445),
  ('shelf', 7, 'edge_free_top', 0.446, 0.1117),
  ('shelf', 7, 'edge_joined', 0.4172, 0.2162),
  ('shelf', 7, 'height', 0.08198, 0.0225),
  ('shelf', 7, 'length', -0.6731, 0.5096),
  ('shelf', 7, 'rectangularity', 0.7467, 0.09085),
  ('shelf', 7, 'spread_length', -0.5707, 0.4393),
  ('shelf', 7, 'spread_width', -1.463, 0.1853),
  ('shelf', 7, 'tilt_deg', 1.217, 1.89),
  ('shelf', 7, 'width', -1.185, 0.1796),
  ('shelf', 7, 'z_max', 0.08541, 0.0384),
  ('shelf', 7, 'z_min', 0.07915, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.04423, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'area_m2', -2.608, 0.3646),
  ('shelf', 8, 'aspect', 0.6549, 0.7043),
  ('shelf', 8, 'behind', 0.5483, 0.2415),
  ('shelf', 8, 'edge_free', 0.3501, 0.1446),
  ('shelf', 8, 'edge_free_top', 0.5677, 0.3514),
  ('shelf', 8, 'edge_joined', 0.3023, 0.3008),
  ('shelf', 8, 'height', 1.107, 0.3311),
  ('shelf', 8, 'length', -0.7221, 0.3053),
  ('shelf', 8, 'rectangularity', 0.559, 0.1085),
  ('shelf', 8, 'spread_length', -0.8923, 0.2428),
  ('shelf', 8, 'spread_width', -1.748, 0.2565),
  ('shelf', 8, 'tilt_deg', 13.05, 20.67),
  ('shelf', 8, 'width', -1.385, 0.3087),
  ('shelf', 8, 'z_max', 1.17, 0.405),
  ('shelf', 8, 'z_min', 1.026, 0.3659);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.0678, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'area_m2', -1.345, 0.288),
  ('shelf', 9, 'aspect', 0.9772, 0.1874),
  ('shelf', 9, 'behind', 0.7984, 0.0745),
  ('shelf', 9, 'edge_free', 0.3844, 0.07017),
  ('shelf', 9, 'edge_free_top', 0.4447, 0.1083),
  ('shelf', 9, 'edge_joined', 0.4558, 0.1351),
  ('shelf', 9, 'height', 0.8736, 0.1172),
  ('shelf', 9, 'length', -0.03713, 0.1954),
  ('shelf', 9, 'rectangularity', 0.7458, 0.09055),
  ('shelf', 9, 'spread_length', -0.3188, 0.2316),
  ('shelf', 9, 'spread_width', -1.185, 0.3032),
  ('shelf', 9, 'tilt_deg', 2.074, 0.7007),
  ('shelf', 9, 'width', -0.9177, 0.1251),
  ('shelf', 9, 'z_max', 0.8556, 0.1119),
  ('shelf', 9, 'z_min', 0.8623, 0.114);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.03238, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'area_m2', -2.51, 0.4309),
  ('shelf', 10, 'aspect', 0.6681, 0.2993),
  ('shelf', 10, 'behind', 0.6527, 0.2203),
  ('shelf', 10, 'edge_free', 0.2514, 0.09523),
  ('shelf', 10, 'edge_free_top', 0.223, 0.1698),
  ('shelf', 10, 'edge_joined', 0.3149, 0.3115),
  ('shelf', 10, 'height', 0.2861, 0.1745),
  ('shelf', 10, 'length', -0.7567, 0.2534),
  ('shelf', 10, 'rectangularity', 0.696, 0.05491),
  ('shelf', 10, 'spread_length', -0.9268, 0.1344),
  ('shelf', 10, 'spread_width', -1.56, 0.2517),
  ('shelf', 10, 'tilt_deg', 57.44, 45.28),
  ('shelf', 10, 'width', -1.395, 0.2835),
  ('shelf', 10, 'z_max', 0.3789, 0.1187),
  ('shelf', 10, 'z_min', 0.132, 0.2274);

-- cabinet: 1374 examples
UPDATE object_class SET prior = 0.09623 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.7972, 0.9306)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6416, 0.4165)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.486, 0.2439)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.3859, 0.2696)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.7655, 0.307)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_joined', 0.2646, 0.3026)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7992, 0.365)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.09041, 0.4823)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7306, 0.1276)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.08672, 0.4891)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7653, 0.5082)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 76.24, 31.94)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.5553, 0.4808)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.268, 0.582)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2471, 0.3646)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'cabinet';
DELETE FROM class_density WHERE class = 'cabinet';
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.08023, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'area_m2', -2.306, 0.8358),
  ('cabinet', 1, 'aspect', 0.7845, 0.9366),
  ('cabinet', 1, 'behind', 0.4254, 0.2715),
  ('cabinet', 1, 'edge_free', 0.08153, 0.1453),
  ('cabinet', 1, 'edge_free_top', 0.4186, 0.4695),
  ('cabinet', 1, 'edge_joined', 0.09536, 0.1636),
  ('cabinet', 1, 'height', 0.4616, 0.3394),
  ('cabinet', 1, 'length', -0.5271, 0.5365),
  ('cabinet', 1, 'rectangularity', 0.643, 0.1071),
  ('cabinet', 1, 'spread_length', -0.6516, 0.4865),
  ('cabinet', 1, 'spread_width', -1.609, 0.2221),
  ('cabinet', 1, 'tilt_deg', 89.82, 1.109),
  ('cabinet', 1, 'width', -1.313, 0.2931),
  ('cabinet', 1, 'z_max', 0.7177, 0.3417),
  ('cabinet', 1, 'z_min', 0.1287, 0.1698);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.08694, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'area_m2', -1.149, 0.2594),
  ('cabinet', 2, 'aspect', 0.3523, 0.3472),
  ('cabinet', 2, 'behind', 0.5699, 0.1168),
  ('cabinet', 2, 'edge_free', 0.2651, 0.2751),
  ('cabinet', 2, 'edge_free_top', 0.6176, 0.4287),
  ('cabinet', 2, 'edge_joined', 0.1925, 0.2748),
  ('cabinet', 2, 'height', 0.3353, 0.03471),
  ('cabinet', 2, 'length', -0.2302, 0.1462),
  ('cabinet', 2, 'rectangularity', 0.6734, 0.08667),
  ('cabinet', 2, 'spread_length', -0.5012, 0.07668),
  ('cabinet', 2, 'spread_width', -0.7784, 0.1558),
  ('cabinet', 2, 'tilt_deg', 90.19, 0.45),
  ('cabinet', 2, 'width', -0.4797, 0.1295),
  ('cabinet', 2, 'z_max', 0.7272, 0.1221),
  ('cabinet', 2, 'z_min', -0.01679, 0.02476);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.1386, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'area_m2', 0.0444, 0.1487),
  ('cabinet', 3, 'aspect', 1.097, 0.1947),
  ('cabinet', 3, 'behind', 0.514, 0.1544),
  ('cabinet', 3, 'edge_free', 0.2531, 0.3754),
  ('cabinet', 3, 'edge_free_top', 0.8469, 0.1682),
  ('cabinet', 3, 'edge_joined', 0.4015, 0.4166),
  ('cabinet', 3, 'height', 1.04, 0.1129),
  ('cabinet', 3, 'length', 0.6533, 0.1008),
  ('cabinet', 3, 'rectangularity', 0.8329, 0.06988),
  ('cabinet', 3, 'spread_length', 0.5157, 0.06407),
  ('cabinet', 3, 'spread_width', -0.5489, 0.1384),
  ('cabinet', 3, 'tilt_deg', 90.18, 0.6983),
  ('cabinet', 3, 'width', -0.4053, 0.1582),
  ('cabinet', 3, 'z_max', 1.935, 0.209),
  ('cabinet', 3, 'z_min', 0.0234, 0.05352);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.16, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'area_m2', -0.5039, 0.4815),
  ('cabinet', 4, 'aspect', 0.563, 0.2686),
  ('cabinet', 4, 'behind', 0.5515, 0.183),
  ('cabinet', 4, 'edge_free', 0.2492, 0.1138),
  ('cabinet', 4, 'edge_free_top', 0.8365, 0.1513),
  ('cabinet', 4, 'edge_joined', 0.3188, 0.2263),
  ('cabinet', 4, 'height', 1.256, 0.269),
  ('cabinet', 4, 'length', 0.2563, 0.3838),
  ('cabinet', 4, 'rectangularity', 0.7542, 0.1465),
  ('cabinet', 4, 'spread_length', -0.1849, 0.3297),
  ('cabinet', 4, 'spread_width', -0.5784, 0.1595),
  ('cabinet', 4, 'tilt_deg', 90.27, 0.45),
  ('cabinet', 4, 'width', -0.4999, 0.1351),
  ('cabinet', 4, 'z_max', 1.982, 0.142),
  ('cabinet', 4, 'z_min', 0.449, 0.285);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.1011, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'area_m2', -0.755, 0.5663),
  ('cabinet', 5, 'aspect', 0.7259, 0.4906),
  ('cabinet', 5, 'behind', 0.1584, 0.08933),
  ('cabinet', 5, 'edge_free', 0.5557, 0.4239),
  ('cabinet', 5, 'edge_free_top', 0.9923, 0.03),
  ('cabinet', 5, 'edge_joined', 0.006913, 0.03),
  ('cabinet', 5, 'height', 1.182, 0.2194),
  ('cabinet', 5, 'length', 0.1758, 0.3771),
  ('cabinet', 5, 'rectangularity', 0.7458, 0.1053),
  ('cabinet', 5, 'spread_length', -0.231, 0.5646),
  ('cabinet', 5, 'spread_width', -0.8918, 0.4866),
  ('cabinet', 5, 'tilt_deg', 90.23, 0.45),
  ('cabinet', 5, 'width', -0.7174, 0.4357),
  ('cabinet', 5, 'z_max', 1.832, 0.4625),
  ('cabinet', 5, 'z_min', 0.3872, 0.1439);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.1223, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'area_m2', 0.4634, 0.2035),
  ('cabinet', 6, 'aspect', 0.5941, 0.269),
  ('cabinet', 6, 'behind', 0.2289, 0.08085),
  ('cabinet', 6, 'edge_free', 0.5879, 0.1902),
  ('cabinet', 6, 'edge_free_top', 0.9753, 0.03768),
  ('cabinet', 6, 'edge_joined', 0.04031, 0.06317),
  ('cabinet', 6, 'height', 1.089, 0.1363),
  ('cabinet', 6, 'length', 0.6287, 0.09101),
  ('cabinet', 6, 'rectangularity', 0.8508, 0.09275),
  ('cabinet', 6, 'spread_length', 0.4629, 0.2349),
  ('cabinet', 6, 'spread_width', -0.1419, 0.2819),
  ('cabinet', 6, 'tilt_deg', 90.22, 0.6311),
  ('cabinet', 6, 'width', 0.02274, 0.1674),
  ('cabinet', 6, 'z_max', 1.851, 0.1188),
  ('cabinet', 6, 'z_min', 0.003094, 0.06144);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.08737, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'area_m2', -0.945, 0.4427),
  ('cabinet', 7, 'aspect', 0.7027, 0.2168),
  ('cabinet', 7, 'behind', 0.6693, 0.1067),
  ('cabinet', 7, 'edge_free', 0.1274, 0.2005),
  ('cabinet', 7, 'edge_free_top', 0.7659, 0.09542),
  ('cabinet', 7, 'edge_joined', 0.7328, 0.1492),
  ('cabinet', 7, 'height', 0.9176, 0.1423),
  ('cabinet', 7, 'length', -0.004359, 0.3929),
  ('cabinet', 7, 'rectangularity', 0.6902, 0.0815),
  ('cabinet', 7, 'spread_length', -0.2994, 0.2512),
  ('cabinet', 7, 'spread_width', -0.596, 0.1321),
  ('cabinet', 7, 'tilt_deg', 0.1393, 0.45),
  ('cabinet', 7, 'width', -0.5606, 0.09621),
  ('cabinet', 7, 'z_max', 0.8798, 0.1131),
  ('cabinet', 7, 'z_min', 0.9333, 0.1471);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.04773, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'area_m2', -0.1235, 0.3217),
  ('cabinet', 8, 'aspect', 0.2925, 0.2263),
  ('cabinet', 8, 'behind', 0.5007, 0.1299),
  ('cabinet', 8, 'edge_free', 0.5549, 0.1062),
  ('cabinet', 8, 'edge_free_top', 0.9735, 0.04176),
  ('cabinet', 8, 'edge_joined', 0.06638, 0.1038),
  ('cabinet', 8, 'height', 0.5658, 0.1454),
  ('cabinet', 8, 'length', 0.178, 0.1589),
  ('cabinet', 8, 'rectangularity', 0.8558, 0.08705),
  ('cabinet', 8, 'spread_length', 0.05762, 0.1234),
  ('cabinet', 8, 'spread_width', -0.2068, 0.1607),
  ('cabinet', 8, 'tilt_deg', 90.26, 0.6661),
  ('cabinet', 8, 'width', -0.1039, 0.2361),
  ('cabinet', 8, 'z_max', 1.088, 0.1217),
  ('cabinet', 8, 'z_min', -0.0003098, 0.02891);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.08365, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'area_m2', -0.6872, 0.314),
  ('cabinet', 9, 'aspect', 0.5575, 0.2305),
  ('cabinet', 9, 'behind', 0.512, 0.1331),
  ('cabinet', 9, 'edge_free', 0.2689, 0.4089),
  ('cabinet', 9, 'edge_free_top', 0.86, 0.1272),
  ('cabinet', 9, 'edge_joined', 0.3534, 0.4052),
  ('cabinet', 9, 'height', 0.6302, 0.104),
  ('cabinet', 9, 'length', 0.1554, 0.1761),
  ('cabinet', 9, 'rectangularity', 0.7293, 0.1381),
  ('cabinet', 9, 'spread_length', -0.09626, 0.1624),
  ('cabinet', 9, 'spread_width', -0.7133, 0.3313),
  ('cabinet', 9, 'tilt_deg', 90.19, 0.45),
  ('cabinet', 9, 'width', -0.5229, 0.1982),
  ('cabinet', 9, 'z_max', 1.19, 0.1616),
  ('cabinet', 9, 'z_min', -0.007062, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.04201, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'area_m2', -2.249, 0.5896),
  ('cabinet', 10, 'aspect', 0.5705, 0.2032),
  ('cabinet', 10, 'behind', 0.7227, 0.1602),
  ('cabinet', 10, 'edge_free', 0.2364, 0.1707),
  ('cabinet', 10, 'edge_free_top', 0.7656, 0.09618),
  ('cabinet', 10, 'edge_joined', 0.1738, 0.09681),
  ('cabinet', 10, 'height', 0.5825, 0.0225),
  ('cabinet', 10, 'length', -0.6568, 0.2127),
  ('cabinet', 10, 'rectangularity', 0.7351, 0.1167),
  ('cabinet', 10, 'spread_length', -0.879, 0.2322),
  ('cabinet', 10, 'spread_width', -1.469, 0.4201),
  ('cabinet', 10, 'tilt_deg', 0.821, 1.68),
  ('cabinet', 10, 'width', -1.273, 0.4744),
  ('cabinet', 10, 'z_max', 0.5849, 0.0225),
  ('cabinet', 10, 'z_min', 0.5785, 0.0225);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.0334 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.328 WHERE name = 'aspect';
UPDATE feature SET weight = 0.334 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.251 WHERE name = 'edge_joined';
UPDATE feature SET weight = 0.234 WHERE name = 'height';
UPDATE feature SET weight = 0.037 WHERE name = 'length';
UPDATE feature SET weight = 0.5 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.385 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.151 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.5 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.271 WHERE name = 'width';
UPDATE feature SET weight = 0.426 WHERE name = 'z_max';
UPDATE feature SET weight = 0.445 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.203 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0478 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0424 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.148 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0116 WHERE name = 'table';
UPDATE object_class SET prior = 0.027 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.251 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.00353 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0426 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0151 WHERE name = 'door';
UPDATE object_class SET prior = 0.013 WHERE name = 'window';
UPDATE object_class SET prior = 0.0101 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0699 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.115 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.95 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.455 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 1.23 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.24 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 2.72 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.51 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 0.0948 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 0.52 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.245 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.735 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 1.19 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 2.06 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.47 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.611 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.64 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 3.02 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 4.12 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.56 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.46 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.02 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 1.12 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.574 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 1.54 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.24 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 2.69 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 0.544 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.53 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.365 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.21 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.72 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.58 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.105 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 0.926 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2394 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.870' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.209' WHERE key = 'probability_offset';
