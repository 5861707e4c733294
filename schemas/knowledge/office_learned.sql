-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 17604 planes of 180 paper-like rooms, seeds from 1; 90 at 2 cm, seeds from 10101; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 60 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 7199 examples
UPDATE object_class SET prior = 0.3218 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.786, 1.212)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6737, 0.5555)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4751, 0.2927)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.4329, 0.313)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.5532, 0.4107)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_joined', 0.3268, 0.3317)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_unseen', 0.04957, 0.1084)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 1.042, 0.7044)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.3857, 0.7048)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.7298, 0.1389)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.5321, 0.7264)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.269, 0.6315)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 62.53, 39.44)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.062, 0.6225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.318, 0.9461)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7607, 0.7617)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0218695, 0.003387),
  ('unknown', 'area_m2', 0.0218695, 0.0488738, 0.124),
  ('unknown', 'area_m2', 0.0488738, 0.0496689, 0.2315),
  ('unknown', 'area_m2', 0.0496689, 0.0676401, 0.3605),
  ('unknown', 'area_m2', 0.0676401, 0.0896683, 0.3927),
  ('unknown', 'area_m2', 0.0896683, 0.109223, 0.3853),
  ('unknown', 'area_m2', 0.109223, 0.121105, 0.3364),
  ('unknown', 'area_m2', 0.121105, 0.171488, 0.3197),
  ('unknown', 'area_m2', 0.171488, 0.238972, 0.3327),
  ('unknown', 'area_m2', 0.238972, 0.244092, 0.3888),
  ('unknown', 'area_m2', 0.244092, 0.325953, 0.3577),
  ('unknown', 'area_m2', 0.325953, 0.545018, 0.2175),
  ('unknown', 'area_m2', 0.545018, 1.21907, 0.08625),
  ('unknown', 'area_m2', 1.21907, 2.72438, 0.01022),
  ('unknown', 'area_m2', 2.72438, 6.08843, 0.008127),
  ('unknown', 'area_m2', 6.08843, 13.6064, 0.009047),
  ('unknown', 'area_m2', 13.6064, 30.4076, 0.01239),
  ('unknown', 'area_m2', 30.4076, 100, 0.007664);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.10889, 1.073),
  ('unknown', 'aspect', 1.10889, 1.23891, 1.009),
  ('unknown', 'aspect', 1.23891, 1.27143, 1.04),
  ('unknown', 'aspect', 1.27143, 1.38033, 1.018),
  ('unknown', 'aspect', 1.38033, 1.55702, 0.9193),
  ('unknown', 'aspect', 1.55702, 1.61654, 0.8228),
  ('unknown', 'aspect', 1.61654, 1.77763, 0.8403),
  ('unknown', 'aspect', 1.77763, 2.05532, 0.6372),
  ('unknown', 'aspect', 2.05532, 2.12408, 0.5742),
  ('unknown', 'aspect', 2.12408, 2.61319, 0.408),
  ('unknown', 'aspect', 2.61319, 2.9041, 0.2545),
  ('unknown', 'aspect', 2.9041, 3.3225, 0.2226),
  ('unknown', 'aspect', 3.3225, 4.22432, 0.197),
  ('unknown', 'aspect', 4.22432, 4.86606, 0.2391),
  ('unknown', 'aspect', 4.86606, 5.37094, 0.2697),
  ('unknown', 'aspect', 5.37094, 6.82878, 0.2375),
  ('unknown', 'aspect', 6.82878, 8.68232, 0.07839),
  ('unknown', 'aspect', 8.68232, 100, 0.003597);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.096682, 2.071),
  ('unknown', 'behind', 0.096682, 0.151738, 0.4041),
  ('unknown', 'behind', 0.151738, 0.193364, 0.4303),
  ('unknown', 'behind', 0.193364, 0.290046, 0.4425),
  ('unknown', 'behind', 0.290046, 0.377358, 0.5765),
  ('unknown', 'behind', 0.377358, 0.386728, 0.8176),
  ('unknown', 'behind', 0.386728, 0.48341, 0.8684),
  ('unknown', 'behind', 0.48341, 0.501395, 1.066),
  ('unknown', 'behind', 0.501395, 0.580092, 0.9993),
  ('unknown', 'behind', 0.580092, 0.604562, 1.31),
  ('unknown', 'behind', 0.604562, 0.676774, 1.446),
  ('unknown', 'behind', 0.676774, 0.680725, 1.756),
  ('unknown', 'behind', 0.680725, 0.745899, 1.705),
  ('unknown', 'behind', 0.745899, 0.773456, 2.082),
  ('unknown', 'behind', 0.773456, 0.799604, 2.073),
  ('unknown', 'behind', 0.799604, 0.870138, 1.485),
  ('unknown', 'behind', 0.870138, 1, 0.04766);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free', 0, 0.108375, 2.051),
  ('unknown', 'edge_free', 0.108375, 0.222222, 0.686),
  ('unknown', 'edge_free', 0.222222, 0.263546, 0.7991),
  ('unknown', 'edge_free', 0.263546, 0.333333, 0.8052),
  ('unknown', 'edge_free', 0.333333, 0.386504, 1.024),
  ('unknown', 'edge_free', 0.386504, 0.444444, 1.213),
  ('unknown', 'edge_free', 0.444444, 0.476206, 1.296),
  ('unknown', 'edge_free', 0.476206, 0.555556, 1.209),
  ('unknown', 'edge_free', 0.555556, 0.571356, 0.9474),
  ('unknown', 'edge_free', 0.571356, 0.666667, 0.8938),
  ('unknown', 'edge_free', 0.666667, 0.698062, 0.8257),
  ('unknown', 'edge_free', 0.698062, 0.777778, 0.7506),
  ('unknown', 'edge_free', 0.777778, 0.883529, 0.4865),
  ('unknown', 'edge_free', 0.883529, 0.888889, 0.434),
  ('unknown', 'edge_free', 0.888889, 1, 0.9793);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free_top', 0, 0.111111, 2.513),
  ('unknown', 'edge_free_top', 0.111111, 0.222222, 0.4052),
  ('unknown', 'edge_free_top', 0.222222, 0.250018, 0.3448),
  ('unknown', 'edge_free_top', 0.250018, 0.333333, 0.3732),
  ('unknown', 'edge_free_top', 0.333333, 0.444444, 0.3464),
  ('unknown', 'edge_free_top', 0.444444, 0.542156, 0.4232),
  ('unknown', 'edge_free_top', 0.542156, 0.555556, 0.4762),
  ('unknown', 'edge_free_top', 0.555556, 0.666667, 0.4624),
  ('unknown', 'edge_free_top', 0.666667, 0.758585, 0.5789),
  ('unknown', 'edge_free_top', 0.758585, 0.777778, 0.6297),
  ('unknown', 'edge_free_top', 0.777778, 0.888889, 0.6817),
  ('unknown', 'edge_free_top', 0.888889, 0.914648, 0.9677),
  ('unknown', 'edge_free_top', 0.914648, 1, 3.884);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_joined', 0, 0.0202146, 10.97),
  ('unknown', 'edge_joined', 0.0202146, 0.0707928, 2.208),
  ('unknown', 'edge_joined', 0.0707928, 0.111111, 1.507),
  ('unknown', 'edge_joined', 0.111111, 0.153904, 1.154),
  ('unknown', 'edge_joined', 0.153904, 0.222222, 0.9769),
  ('unknown', 'edge_joined', 0.222222, 0.269096, 0.9688),
  ('unknown', 'edge_joined', 0.269096, 0.333333, 0.8027),
  ('unknown', 'edge_joined', 0.333333, 0.418687, 0.6975),
  ('unknown', 'edge_joined', 0.418687, 0.444444, 0.6041),
  ('unknown', 'edge_joined', 0.444444, 0.555556, 0.5489),
  ('unknown', 'edge_joined', 0.555556, 0.621166, 0.5428),
  ('unknown', 'edge_joined', 0.621166, 0.666667, 0.3839),
  ('unknown', 'edge_joined', 0.666667, 0.777778, 0.426),
  ('unknown', 'edge_joined', 0.777778, 0.881931, 0.4356),
  ('unknown', 'edge_joined', 0.881931, 0.888889, 0.5118),
  ('unknown', 'edge_joined', 0.888889, 1, 0.9662);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_unseen';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_unseen', 0, 0.0382638, 20.28),
  ('unknown', 'edge_unseen', 0.0382638, 0.0545762, 0.7638),
  ('unknown', 'edge_unseen', 0.0545762, 0.109152, 0.7689),
  ('unknown', 'edge_unseen', 0.109152, 0.163729, 0.7125),
  ('unknown', 'edge_unseen', 0.163729, 0.199459, 0.547),
  ('unknown', 'edge_unseen', 0.199459, 0.218305, 0.577),
  ('unknown', 'edge_unseen', 0.218305, 0.272881, 0.4683),
  ('unknown', 'edge_unseen', 0.272881, 0.327457, 0.4641),
  ('unknown', 'edge_unseen', 0.327457, 0.382034, 0.3861),
  ('unknown', 'edge_unseen', 0.382034, 0.43661, 0.2518),
  ('unknown', 'edge_unseen', 0.43661, 0.491186, 0.08926),
  ('unknown', 'edge_unseen', 0.491186, 1, 0.01874);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0722549, 0.008997),
  ('unknown', 'height', 0.0722549, 0.228853, 0.6685),
  ('unknown', 'height', 0.228853, 0.394874, 0.5017),
  ('unknown', 'height', 0.394874, 0.429762, 0.7931),
  ('unknown', 'height', 0.429762, 0.634506, 0.5481),
  ('unknown', 'height', 0.634506, 0.717494, 0.3705),
  ('unknown', 'height', 0.717494, 0.830649, 0.718),
  ('unknown', 'height', 0.830649, 0.9567, 0.8805),
  ('unknown', 'height', 0.9567, 1.04011, 0.5075),
  ('unknown', 'height', 1.04011, 1.25207, 0.3247),
  ('unknown', 'height', 1.25207, 1.36273, 0.3308),
  ('unknown', 'height', 1.36273, 1.55719, 0.3781),
  ('unknown', 'height', 1.55719, 1.68535, 0.3763),
  ('unknown', 'height', 1.68535, 2.00797, 0.1582),
  ('unknown', 'height', 2.00797, 2.08369, 0.1615),
  ('unknown', 'height', 2.08369, 2.33059, 0.1842),
  ('unknown', 'height', 2.33059, 2.65321, 0.1143),
  ('unknown', 'height', 2.65321, 2.97583, 0.06054),
  ('unknown', 'height', 2.97583, 4, 0.009134);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.187712, 0.004048),
  ('unknown', 'length', 0.187712, 0.285818, 0.1725),
  ('unknown', 'length', 0.285818, 0.310811, 0.3736),
  ('unknown', 'length', 0.310811, 0.376406, 0.5786),
  ('unknown', 'length', 0.376406, 0.435197, 0.5302),
  ('unknown', 'length', 0.435197, 0.460204, 0.6006),
  ('unknown', 'length', 0.460204, 0.565221, 0.5432),
  ('unknown', 'length', 0.565221, 0.662647, 0.5066),
  ('unknown', 'length', 0.662647, 0.714977, 0.4173),
  ('unknown', 'length', 0.714977, 0.889861, 0.5027),
  ('unknown', 'length', 0.889861, 1.00897, 0.4433),
  ('unknown', 'length', 1.00897, 1.16119, 0.3911),
  ('unknown', 'length', 1.16119, 1.4775, 0.4672),
  ('unknown', 'length', 1.4775, 1.5363, 0.4106),
  ('unknown', 'length', 1.5363, 2.33922, 0.1272),
  ('unknown', 'length', 2.33922, 3.56179, 0.02487),
  ('unknown', 'length', 3.56179, 5.42331, 0.02456),
  ('unknown', 'length', 5.42331, 8.25774, 0.02542),
  ('unknown', 'length', 8.25774, 30, 0.007217);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.330146, 0.02923),
  ('unknown', 'rectangularity', 0.330146, 0.400547, 0.2043),
  ('unknown', 'rectangularity', 0.400547, 0.470947, 0.3592),
  ('unknown', 'rectangularity', 0.470947, 0.541348, 0.8036),
  ('unknown', 'rectangularity', 0.541348, 0.54478, 1.352),
  ('unknown', 'rectangularity', 0.54478, 0.611748, 1.317),
  ('unknown', 'rectangularity', 0.611748, 0.626382, 1.632),
  ('unknown', 'rectangularity', 0.626382, 0.682149, 1.959),
  ('unknown', 'rectangularity', 0.682149, 0.729157, 2.394),
  ('unknown', 'rectangularity', 0.729157, 0.752549, 2.49),
  ('unknown', 'rectangularity', 0.752549, 0.770676, 2.961),
  ('unknown', 'rectangularity', 0.770676, 0.80695, 3.02),
  ('unknown', 'rectangularity', 0.80695, 0.822949, 2.802),
  ('unknown', 'rectangularity', 0.822949, 0.84619, 2.893),
  ('unknown', 'rectangularity', 0.84619, 0.890042, 2.541),
  ('unknown', 'rectangularity', 0.890042, 0.89335, 2.259),
  ('unknown', 'rectangularity', 0.89335, 0.96375, 1.371),
  ('unknown', 'rectangularity', 0.96375, 1, 0.1839);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.171526, 0.002657),
  ('unknown', 'spread_length', 0.171526, 0.262245, 0.2168),
  ('unknown', 'spread_length', 0.262245, 0.268091, 0.5364),
  ('unknown', 'spread_length', 0.268091, 0.319988, 0.6358),
  ('unknown', 'spread_length', 0.319988, 0.375682, 0.6788),
  ('unknown', 'spread_length', 0.375682, 0.400944, 0.5063),
  ('unknown', 'spread_length', 0.400944, 0.462789, 0.5505),
  ('unknown', 'spread_length', 0.462789, 0.612999, 0.3948),
  ('unknown', 'spread_length', 0.612999, 0.770275, 0.4782),
  ('unknown', 'spread_length', 0.770275, 0.937207, 0.4186),
  ('unknown', 'spread_length', 0.937207, 1.02794, 0.3396),
  ('unknown', 'spread_length', 1.02794, 1.32538, 0.434),
  ('unknown', 'spread_length', 1.32538, 1.43289, 0.3489),
  ('unknown', 'spread_length', 1.43289, 2.19073, 0.1045),
  ('unknown', 'spread_length', 2.19073, 3.34938, 0.02206),
  ('unknown', 'spread_length', 3.34938, 5.12084, 0.02283),
  ('unknown', 'spread_length', 5.12084, 7.82919, 0.02688),
  ('unknown', 'spread_length', 7.82919, 40, 0.005662);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.110125, 0.0005774),
  ('unknown', 'spread_width', 0.110125, 0.156155, 0.3144),
  ('unknown', 'spread_width', 0.156155, 0.167203, 0.5988),
  ('unknown', 'spread_width', 0.167203, 0.184834, 0.7),
  ('unknown', 'spread_width', 0.184834, 0.206677, 1.003),
  ('unknown', 'spread_width', 0.206677, 0.224441, 1.283),
  ('unknown', 'spread_width', 0.224441, 0.253865, 0.8136),
  ('unknown', 'spread_width', 0.253865, 0.259189, 0.7008),
  ('unknown', 'spread_width', 0.259189, 0.303123, 0.703),
  ('unknown', 'spread_width', 0.303123, 0.385443, 0.4522),
  ('unknown', 'spread_width', 0.385443, 0.575399, 0.2862),
  ('unknown', 'spread_width', 0.575399, 0.585217, 0.2517),
  ('unknown', 'spread_width', 0.585217, 0.888535, 0.1585),
  ('unknown', 'spread_width', 0.888535, 1.34906, 0.02481),
  ('unknown', 'spread_width', 1.34906, 2.04828, 0.01574),
  ('unknown', 'spread_width', 2.04828, 3.1099, 0.01421),
  ('unknown', 'spread_width', 3.1099, 4.72176, 0.02024),
  ('unknown', 'spread_width', 4.72176, 20, 0.006442);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 0.485395, 0.2149),
  ('unknown', 'tilt_deg', 0.485395, 2.11257, 0.07212),
  ('unknown', 'tilt_deg', 2.11257, 10, 0.007332),
  ('unknown', 'tilt_deg', 10, 20, 0.001247),
  ('unknown', 'tilt_deg', 20, 30, 0.0003747),
  ('unknown', 'tilt_deg', 30, 40, 0.0002363),
  ('unknown', 'tilt_deg', 40, 50, 0.0001815),
  ('unknown', 'tilt_deg', 50, 60, 0.0001754),
  ('unknown', 'tilt_deg', 60, 70, 0.0005408),
  ('unknown', 'tilt_deg', 70, 77.7332, 0.003538),
  ('unknown', 'tilt_deg', 77.7332, 80, 0.005205),
  ('unknown', 'tilt_deg', 80, 88.3156, 0.01207),
  ('unknown', 'tilt_deg', 88.3156, 89.4263, 0.1131),
  ('unknown', 'tilt_deg', 89.4263, 89.7682, 0.5252),
  ('unknown', 'tilt_deg', 89.7682, 90, 1.071);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.130248, 0.002548),
  ('unknown', 'width', 0.130248, 0.187845, 0.2874),
  ('unknown', 'width', 0.187845, 0.195453, 0.5023),
  ('unknown', 'width', 0.195453, 0.220626, 0.7449),
  ('unknown', 'width', 0.220626, 0.247829, 0.9497),
  ('unknown', 'width', 0.247829, 0.285285, 0.7898),
  ('unknown', 'width', 0.285285, 0.2933, 0.8021),
  ('unknown', 'width', 0.2933, 0.327569, 0.8094),
  ('unknown', 'width', 0.327569, 0.387615, 0.661),
  ('unknown', 'width', 0.387615, 0.440132, 0.4655),
  ('unknown', 'width', 0.440132, 0.495761, 0.4441),
  ('unknown', 'width', 0.495761, 0.660469, 0.3192),
  ('unknown', 'width', 0.660469, 0.700061, 0.3161),
  ('unknown', 'width', 0.700061, 0.991111, 0.197),
  ('unknown', 'width', 0.991111, 1.48728, 0.02838),
  ('unknown', 'width', 1.48728, 2.23184, 0.01763),
  ('unknown', 'width', 2.23184, 3.34913, 0.0178),
  ('unknown', 'width', 3.34913, 5.02577, 0.0196),
  ('unknown', 'width', 5.02577, 12, 0.01059);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0764832, 0.009973),
  ('unknown', 'z_max', 0.0764832, 0.430244, 0.3141),
  ('unknown', 'z_max', 0.430244, 0.512429, 0.5079),
  ('unknown', 'z_max', 0.512429, 0.693031, 0.3607),
  ('unknown', 'z_max', 0.693031, 0.794588, 1.075),
  ('unknown', 'z_max', 0.794588, 0.932526, 0.8081),
  ('unknown', 'z_max', 0.932526, 0.948376, 0.6732),
  ('unknown', 'z_max', 0.948376, 1.10709, 0.6256),
  ('unknown', 'z_max', 1.10709, 1.38432, 0.3071),
  ('unknown', 'z_max', 1.38432, 1.53636, 0.1824),
  ('unknown', 'z_max', 1.53636, 1.82027, 0.2081),
  ('unknown', 'z_max', 1.82027, 1.99966, 0.2778),
  ('unknown', 'z_max', 1.99966, 2.25621, 0.4043),
  ('unknown', 'z_max', 2.25621, 2.28875, 0.2967),
  ('unknown', 'z_max', 2.28875, 2.69216, 0.1519),
  ('unknown', 'z_max', 2.69216, 3.12811, 0.04844),
  ('unknown', 'z_max', 3.12811, 3.56405, 0.01118),
  ('unknown', 'z_max', 3.56405, 4, 0.05324);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.129613, 0.05901),
  ('unknown', 'z_min', -0.129613, -0.015829, 0.8345),
  ('unknown', 'z_min', -0.015829, 0.0422306, 1.83),
  ('unknown', 'z_min', 0.0422306, 0.240775, 0.4718),
  ('unknown', 'z_min', 0.240775, 0.30086, 0.2802),
  ('unknown', 'z_min', 0.30086, 0.611162, 0.2779),
  ('unknown', 'z_min', 0.611162, 0.668586, 0.4518),
  ('unknown', 'z_min', 0.668586, 0.765278, 1.115),
  ('unknown', 'z_min', 0.765278, 0.9067, 0.7922),
  ('unknown', 'z_min', 0.9067, 0.98155, 0.5458),
  ('unknown', 'z_min', 0.98155, 1.20757, 0.31),
  ('unknown', 'z_min', 1.20757, 1.35194, 0.3357),
  ('unknown', 'z_min', 1.35194, 1.72232, 0.1401),
  ('unknown', 'z_min', 1.72232, 1.91042, 0.06416),
  ('unknown', 'z_min', 1.91042, 2.09271, 0.0917),
  ('unknown', 'z_min', 2.09271, 2.4631, 0.1495),
  ('unknown', 'z_min', 2.4631, 2.83349, 0.08084),
  ('unknown', 'z_min', 2.83349, 4, 0.007781);
DELETE FROM class_kind WHERE class = 'unknown';
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.0253, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'area_m2', -2.634, 0.2967),
  ('unknown', 1, 'aspect', 0.3614, 0.2334),
  ('unknown', 1, 'behind', 0.629, 0.1574),
  ('unknown', 1, 'edge_free', 0.4868, 0.1293),
  ('unknown', 1, 'edge_free_top', 0.7651, 0.2161),
  ('unknown', 1, 'edge_joined', 0.1977, 0.1856),
  ('unknown', 1, 'edge_unseen', 0.003852, 0.03619),
  ('unknown', 1, 'height', 0.1896, 0.0225),
  ('unknown', 1, 'length', -0.9356, 0.1744),
  ('unknown', 1, 'rectangularity', 0.6863, 0.1526),
  ('unknown', 1, 'spread_length', -1.096, 0.1754),
  ('unknown', 1, 'spread_width', -1.669, 0.1901),
  ('unknown', 1, 'tilt_deg', 89.13, 1.989),
  ('unknown', 1, 'width', -1.281, 0.2727),
  ('unknown', 1, 'z_max', 0.3829, 0.04928),
  ('unknown', 1, 'z_min', -0.007585, 0.03995);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.02725, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'area_m2', -1.945, 0.3549),
  ('unknown', 2, 'aspect', 0.3056, 0.2419),
  ('unknown', 2, 'behind', 0.6501, 0.1997),
  ('unknown', 2, 'edge_free', 0.3884, 0.1348),
  ('unknown', 2, 'edge_free_top', 0.5515, 0.2716),
  ('unknown', 2, 'edge_joined', 0.3305, 0.2302),
  ('unknown', 2, 'edge_unseen', 0.005412, 0.03),
  ('unknown', 2, 'height', 0.2426, 0.05476),
  ('unknown', 2, 'length', -0.477, 0.1914),
  ('unknown', 2, 'rectangularity', 0.4705, 0.1279),
  ('unknown', 2, 'spread_length', -0.6234, 0.2072),
  ('unknown', 2, 'spread_width', -1.187, 0.3185),
  ('unknown', 2, 'tilt_deg', 88.94, 1.424),
  ('unknown', 2, 'width', -0.8118, 0.2397),
  ('unknown', 2, 'z_max', 0.5405, 0.1134),
  ('unknown', 2, 'z_min', -0.01465, 0.03062);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.02354, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'area_m2', -1.298, 0.1509),
  ('unknown', 3, 'aspect', 1.715, 0.1654),
  ('unknown', 3, 'behind', 0.2768, 0.2875),
  ('unknown', 3, 'edge_free', 0.8814, 0.1357),
  ('unknown', 3, 'edge_free_top', 0.5532, 0.1302),
  ('unknown', 3, 'edge_joined', 0.1094, 0.1288),
  ('unknown', 3, 'edge_unseen', 0.01174, 0.03245),
  ('unknown', 3, 'height', 2.514, 0.2794),
  ('unknown', 3, 'length', 0.2952, 0.11),
  ('unknown', 3, 'rectangularity', 0.8584, 0.04716),
  ('unknown', 3, 'spread_length', 0.2428, 0.1221),
  ('unknown', 3, 'spread_width', -1.552, 0.05294),
  ('unknown', 3, 'tilt_deg', 0.8281, 1.42),
  ('unknown', 3, 'width', -1.442, 0.1062),
  ('unknown', 3, 'z_max', 2.544, 0.3057),
  ('unknown', 3, 'z_min', 2.535, 0.2997);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.03254, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'area_m2', -2.646, 0.2563),
  ('unknown', 4, 'aspect', 0.49, 0.3407),
  ('unknown', 4, 'behind', 0.5847, 0.1943),
  ('unknown', 4, 'edge_free', 0.606, 0.1011),
  ('unknown', 4, 'edge_free_top', 0.9732, 0.04887),
  ('unknown', 4, 'edge_joined', 0.09117, 0.1107),
  ('unknown', 4, 'edge_unseen', 0.006397, 0.03345),
  ('unknown', 4, 'height', 0.8593, 0.03537),
  ('unknown', 4, 'length', -0.9662, 0.2525),
  ('unknown', 4, 'rectangularity', 0.735, 0.1053),
  ('unknown', 4, 'spread_length', -1.264, 0.1441),
  ('unknown', 4, 'spread_width', -1.528, 0.17),
  ('unknown', 4, 'tilt_deg', 82.96, 10.13),
  ('unknown', 4, 'width', -1.407, 0.1907),
  ('unknown', 4, 'z_max', 0.9704, 0.06455),
  ('unknown', 4, 'z_min', 0.7344, 0.0433);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.03235, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'area_m2', -1.567, 0.4937),
  ('unknown', 5, 'aspect', 0.865, 0.5193),
  ('unknown', 5, 'behind', 0.3886, 0.1857),
  ('unknown', 5, 'edge_free', 0.3324, 0.3324),
  ('unknown', 5, 'edge_free_top', 0.4322, 0.2894),
  ('unknown', 5, 'edge_joined', 0.386, 0.3183),
  ('unknown', 5, 'edge_unseen', 0.1086, 0.1031),
  ('unknown', 5, 'height', 1.387, 0.1564),
  ('unknown', 5, 'length', -0.1737, 0.2992),
  ('unknown', 5, 'rectangularity', 0.7201, 0.1069),
  ('unknown', 5, 'spread_length', -0.3923, 0.1746),
  ('unknown', 5, 'spread_width', -1.313, 0.512),
  ('unknown', 5, 'tilt_deg', 87.78, 1.254),
  ('unknown', 5, 'width', -1.059, 0.4623),
  ('unknown', 5, 'z_max', 1.734, 0.1259),
  ('unknown', 5, 'z_min', 0.929, 0.1164);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.05267, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'area_m2', -1.554, 0.5491),
  ('unknown', 6, 'aspect', 0.8705, 0.4173),
  ('unknown', 6, 'behind', 0.497, 0.1766),
  ('unknown', 6, 'edge_free', 0.4105, 0.2735),
  ('unknown', 6, 'edge_free_top', 0.3355, 0.2456),
  ('unknown', 6, 'edge_joined', 0.3241, 0.2773),
  ('unknown', 6, 'edge_unseen', 0.06924, 0.07117),
  ('unknown', 6, 'height', 0.5045, 0.1106),
  ('unknown', 6, 'length', -0.1914, 0.2438),
  ('unknown', 6, 'rectangularity', 0.6613, 0.1521),
  ('unknown', 6, 'spread_length', -0.2174, 0.3592),
  ('unknown', 6, 'spread_width', -1.225, 0.4511),
  ('unknown', 6, 'tilt_deg', 88.42, 0.9301),
  ('unknown', 6, 'width', -0.9229, 0.4473),
  ('unknown', 6, 'z_max', 0.7588, 0.1685),
  ('unknown', 6, 'z_min', 0.2321, 0.1554);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.03247, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'area_m2', -0.7611, 0.4015),
  ('unknown', 7, 'aspect', 0.2767, 0.2063),
  ('unknown', 7, 'behind', 0.6742, 0.1574),
  ('unknown', 7, 'edge_free', 0.4325, 0.2052),
  ('unknown', 7, 'edge_free_top', 0.3427, 0.1818),
  ('unknown', 7, 'edge_joined', 0.2975, 0.2072),
  ('unknown', 7, 'edge_unseen', 0.007759, 0.03323),
  ('unknown', 7, 'height', 0.4269, 0.09018),
  ('unknown', 7, 'length', -0.02786, 0.1878),
  ('unknown', 7, 'rectangularity', 0.65, 0.1123),
  ('unknown', 7, 'spread_length', -0.2188, 0.1289),
  ('unknown', 7, 'spread_width', -0.5698, 0.2454),
  ('unknown', 7, 'tilt_deg', 89.38, 1.595),
  ('unknown', 7, 'width', -0.2869, 0.09628),
  ('unknown', 7, 'z_max', 0.7394, 0.0487),
  ('unknown', 7, 'z_min', 0.01361, 0.06176);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.0357, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'area_m2', -0.3939, 0.2778),
  ('unknown', 8, 'aspect', 0.4779, 0.2392),
  ('unknown', 8, 'behind', 0.4417, 0.06708),
  ('unknown', 8, 'edge_free', 0.8845, 0.1249),
  ('unknown', 8, 'edge_free_top', 0.9905, 0.03912),
  ('unknown', 8, 'edge_joined', 0.03906, 0.0516),
  ('unknown', 8, 'edge_unseen', 0.05947, 0.104),
  ('unknown', 8, 'height', 0.4965, 0.03694),
  ('unknown', 8, 'length', 0.09005, 0.2301),
  ('unknown', 8, 'rectangularity', 0.818, 0.08108),
  ('unknown', 8, 'spread_length', 0.043, 0.2643),
  ('unknown', 8, 'spread_width', -0.4748, 0.0855),
  ('unknown', 8, 'tilt_deg', 89.6, 1.25),
  ('unknown', 8, 'width', -0.3474, 0.1519),
  ('unknown', 8, 'z_max', 0.7842, 0.06828),
  ('unknown', 8, 'z_min', 0.08419, 0.05079);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.03183, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'area_m2', -1.171, 0.2858),
  ('unknown', 9, 'aspect', 0.4002, 0.3127),
  ('unknown', 9, 'behind', 0.01074, 0.03049),
  ('unknown', 9, 'edge_free', 0.01818, 0.03843),
  ('unknown', 9, 'edge_free_top', 0.02561, 0.06982),
  ('unknown', 9, 'edge_joined', 0.9189, 0.08591),
  ('unknown', 9, 'edge_unseen', 0.04867, 0.1094),
  ('unknown', 9, 'height', 1.634, 0.08217),
  ('unknown', 9, 'length', -0.2951, 0.1634),
  ('unknown', 9, 'rectangularity', 0.8052, 0.06965),
  ('unknown', 9, 'spread_length', -0.4691, 0.1621),
  ('unknown', 9, 'spread_width', -0.9925, 0.2448),
  ('unknown', 9, 'tilt_deg', 89.83, 0.82),
  ('unknown', 9, 'width', -0.6882, 0.3217),
  ('unknown', 9, 'z_max', 1.981, 0.1574),
  ('unknown', 9, 'z_min', 1.332, 0.06376);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.03176, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'area_m2', -1.284, 0.2581),
  ('unknown', 10, 'aspect', 1.66, 0.2056),
  ('unknown', 10, 'behind', 0.5809, 0.247),
  ('unknown', 10, 'edge_free', 0.1968, 0.1847),
  ('unknown', 10, 'edge_free_top', 0.007941, 0.03),
  ('unknown', 10, 'edge_joined', 0.4037, 0.3014),
  ('unknown', 10, 'edge_unseen', 0.01962, 0.04109),
  ('unknown', 10, 'height', 1.507, 0.08375),
  ('unknown', 10, 'length', 0.32, 0.1395),
  ('unknown', 10, 'rectangularity', 0.7872, 0.06125),
  ('unknown', 10, 'spread_length', 0.1445, 0.1178),
  ('unknown', 10, 'spread_width', -1.534, 0.2361),
  ('unknown', 10, 'tilt_deg', 89.85, 0.9081),
  ('unknown', 10, 'width', -1.375, 0.2429),
  ('unknown', 10, 'z_max', 2.225, 0.1755),
  ('unknown', 10, 'z_min', 0.8386, 0.0803);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.03681, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'area_m2', -1.808, 0.3636),
  ('unknown', 11, 'aspect', 0.664, 0.3654),
  ('unknown', 11, 'behind', 0.6911, 0.119),
  ('unknown', 11, 'edge_free', 0.185, 0.1248),
  ('unknown', 11, 'edge_free_top', 0.5485, 0.1289),
  ('unknown', 11, 'edge_joined', 0.5881, 0.2506),
  ('unknown', 11, 'edge_unseen', 0.08896, 0.1007),
  ('unknown', 11, 'height', 0.8346, 0.2177),
  ('unknown', 11, 'length', -0.331, 0.3168),
  ('unknown', 11, 'rectangularity', 0.6742, 0.08368),
  ('unknown', 11, 'spread_length', -0.5279, 0.3086),
  ('unknown', 11, 'spread_width', -1.229, 0.22),
  ('unknown', 11, 'tilt_deg', 5.088, 1.581),
  ('unknown', 11, 'width', -1.078, 0.2663),
  ('unknown', 11, 'z_max', 0.8581, 0.2305),
  ('unknown', 11, 'z_min', 0.7958, 0.2443);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.04238, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'area_m2', -2.702, 0.4717),
  ('unknown', 12, 'aspect', 0.3436, 0.2476),
  ('unknown', 12, 'behind', 0.2664, 0.2418),
  ('unknown', 12, 'edge_free', 0.6573, 0.1679),
  ('unknown', 12, 'edge_free_top', 0.5566, 0.1342),
  ('unknown', 12, 'edge_joined', 0.3079, 0.1628),
  ('unknown', 12, 'edge_unseen', 0.003743, 0.03),
  ('unknown', 12, 'height', 0.8666, 0.117),
  ('unknown', 12, 'length', -1.075, 0.1892),
  ('unknown', 12, 'rectangularity', 0.818, 0.07539),
  ('unknown', 12, 'spread_length', -1.21, 0.1504),
  ('unknown', 12, 'spread_width', -1.527, 0.238),
  ('unknown', 12, 'tilt_deg', 0.7448, 1.125),
  ('unknown', 12, 'width', -1.433, 0.2886),
  ('unknown', 12, 'z_max', 0.8695, 0.1265),
  ('unknown', 12, 'z_min', 0.862, 0.1237);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.02238, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'area_m2', -3.178, 0.2906),
  ('unknown', 13, 'aspect', 0.3832, 0.2438),
  ('unknown', 13, 'behind', 0.4717, 0.1793),
  ('unknown', 13, 'edge_free', 0.6143, 0.1223),
  ('unknown', 13, 'edge_free_top', 0.9917, 0.03119),
  ('unknown', 13, 'edge_joined', 0.07112, 0.1106),
  ('unknown', 13, 'edge_unseen', 0.003217, 0.03),
  ('unknown', 13, 'height', 1.248, 0.5264),
  ('unknown', 13, 'length', -1.312, 0.2145),
  ('unknown', 13, 'rectangularity', 0.8209, 0.09495),
  ('unknown', 13, 'spread_length', -1.4, 0.1752),
  ('unknown', 13, 'spread_width', -1.78, 0.1896),
  ('unknown', 13, 'tilt_deg', 89.06, 1.581),
  ('unknown', 13, 'width', -1.661, 0.1935),
  ('unknown', 13, 'z_max', 1.341, 0.526),
  ('unknown', 13, 'z_min', 1.129, 0.5084);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.01508, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'area_m2', -1.955, 0.4544),
  ('unknown', 14, 'aspect', 0.5234, 0.2878),
  ('unknown', 14, 'behind', 0.366, 0.1266),
  ('unknown', 14, 'edge_free', 0.8411, 0.219),
  ('unknown', 14, 'edge_free_top', 0.9882, 0.03525),
  ('unknown', 14, 'edge_joined', 0.01111, 0.03),
  ('unknown', 14, 'edge_unseen', 0.1872, 0.1484),
  ('unknown', 14, 'height', 0.7875, 0.2497),
  ('unknown', 14, 'length', -0.5375, 0.2628),
  ('unknown', 14, 'rectangularity', 0.6372, 0.101),
  ('unknown', 14, 'spread_length', -0.7195, 0.3439),
  ('unknown', 14, 'spread_width', -1.25, 0.2718),
  ('unknown', 14, 'tilt_deg', 85.33, 8.048),
  ('unknown', 14, 'width', -1.025, 0.277),
  ('unknown', 14, 'z_max', 1.039, 0.2556),
  ('unknown', 14, 'z_min', 0.5465, 0.1304);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.02108, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'area_m2', -1.933, 0.245),
  ('unknown', 15, 'aspect', 0.5716, 0.246),
  ('unknown', 15, 'behind', 0.5563, 0.2758),
  ('unknown', 15, 'edge_free', 0.4042, 0.182),
  ('unknown', 15, 'edge_free_top', 0.6187, 0.2417),
  ('unknown', 15, 'edge_joined', 0.3335, 0.1647),
  ('unknown', 15, 'edge_unseen', 0.002887, 0.03),
  ('unknown', 15, 'height', 1.039, 0.1726),
  ('unknown', 15, 'length', -0.4997, 0.1729),
  ('unknown', 15, 'rectangularity', 0.6429, 0.09104),
  ('unknown', 15, 'spread_length', -0.7412, 0.2591),
  ('unknown', 15, 'spread_width', -1.298, 0.2353),
  ('unknown', 15, 'tilt_deg', 86.73, 6.435),
  ('unknown', 15, 'width', -1.012, 0.1807),
  ('unknown', 15, 'z_max', 1.401, 0.08293),
  ('unknown', 15, 'z_min', 0.7525, 0.2149);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.01617, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'area_m2', -1.511, 0.4671),
  ('unknown', 16, 'aspect', 1.614, 0.3234),
  ('unknown', 16, 'behind', 0.6569, 0.05718),
  ('unknown', 16, 'edge_free', 0.1497, 0.1678),
  ('unknown', 16, 'edge_free_top', 0.5544, 0.1283),
  ('unknown', 16, 'edge_joined', 0.7186, 0.2177),
  ('unknown', 16, 'edge_unseen', 0.03949, 0.0611),
  ('unknown', 16, 'height', 2.138, 0.1405),
  ('unknown', 16, 'length', 0.1986, 0.2783),
  ('unknown', 16, 'rectangularity', 0.7609, 0.06521),
  ('unknown', 16, 'spread_length', 0.01931, 0.4237),
  ('unknown', 16, 'spread_width', -1.551, 0.199),
  ('unknown', 16, 'tilt_deg', 1.054, 1.897),
  ('unknown', 16, 'width', -1.43, 0.2145),
  ('unknown', 16, 'z_max', 2.146, 0.1536),
  ('unknown', 16, 'z_min', 2.138, 0.1358);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.03433, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'area_m2', -2.508, 0.3507),
  ('unknown', 17, 'aspect', 0.4941, 0.2709),
  ('unknown', 17, 'behind', 0.5729, 0.2685),
  ('unknown', 17, 'edge_free', 0.4932, 0.1875),
  ('unknown', 17, 'edge_free_top', 0.6605, 0.2715),
  ('unknown', 17, 'edge_joined', 0.2737, 0.1603),
  ('unknown', 17, 'edge_unseen', 0.003797, 0.03),
  ('unknown', 17, 'height', 1.625, 0.264),
  ('unknown', 17, 'length', -0.8437, 0.2185),
  ('unknown', 17, 'rectangularity', 0.6659, 0.097),
  ('unknown', 17, 'spread_length', -1.099, 0.1876),
  ('unknown', 17, 'spread_width', -1.531, 0.2158),
  ('unknown', 17, 'tilt_deg', 88.47, 2.157),
  ('unknown', 17, 'width', -1.267, 0.2611),
  ('unknown', 17, 'z_max', 1.811, 0.2778),
  ('unknown', 17, 'z_min', 1.393, 0.2504);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.01845, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'area_m2', -2.915, 0.3382),
  ('unknown', 18, 'aspect', 0.6351, 0.2393),
  ('unknown', 18, 'behind', 0.3406, 0.1198),
  ('unknown', 18, 'edge_free', 0.268, 0.245),
  ('unknown', 18, 'edge_free_top', 0.2069, 0.2624),
  ('unknown', 18, 'edge_joined', 0.2801, 0.2863),
  ('unknown', 18, 'edge_unseen', 0.105, 0.1536),
  ('unknown', 18, 'height', 0.3023, 0.1513),
  ('unknown', 18, 'length', -0.9121, 0.2712),
  ('unknown', 18, 'rectangularity', 0.694, 0.1335),
  ('unknown', 18, 'spread_length', -1.114, 0.3165),
  ('unknown', 18, 'spread_width', -1.819, 0.2278),
  ('unknown', 18, 'tilt_deg', 86.96, 3.428),
  ('unknown', 18, 'width', -1.588, 0.2359),
  ('unknown', 18, 'z_max', 0.4702, 0.1113),
  ('unknown', 18, 'z_min', 0.1339, 0.1501);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.0244, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'area_m2', -2.422, 0.2352),
  ('unknown', 19, 'aspect', 0.3279, 0.2054),
  ('unknown', 19, 'behind', 0.6109, 0.1919),
  ('unknown', 19, 'edge_free', 0.3998, 0.1831),
  ('unknown', 19, 'edge_free_top', 0.5854, 0.2896),
  ('unknown', 19, 'edge_joined', 0.3292, 0.222),
  ('unknown', 19, 'edge_unseen', 0.006075, 0.03059),
  ('unknown', 19, 'height', 0.845, 0.1835),
  ('unknown', 19, 'length', -0.8992, 0.1471),
  ('unknown', 19, 'rectangularity', 0.6731, 0.04284),
  ('unknown', 19, 'spread_length', -1.151, 0.1158),
  ('unknown', 19, 'spread_width', -1.381, 0.1454),
  ('unknown', 19, 'tilt_deg', 89.39, 1.35),
  ('unknown', 19, 'width', -1.179, 0.137),
  ('unknown', 19, 'z_max', 1.041, 0.1843),
  ('unknown', 19, 'z_min', 0.6698, 0.2048);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.01933, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'area_m2', -2.997, 0.4503),
  ('unknown', 20, 'aspect', 0.5, 0.2954),
  ('unknown', 20, 'behind', 0.3665, 0.2557),
  ('unknown', 20, 'edge_free', 0.4473, 0.2786),
  ('unknown', 20, 'edge_free_top', 0.7055, 0.3242),
  ('unknown', 20, 'edge_joined', 0.3356, 0.2905),
  ('unknown', 20, 'edge_unseen', 0.2074, 0.145),
  ('unknown', 20, 'height', 0.9037, 0.1781),
  ('unknown', 20, 'length', -1.085, 0.2707),
  ('unknown', 20, 'rectangularity', 0.6995, 0.07105),
  ('unknown', 20, 'spread_length', -1.246, 0.2903),
  ('unknown', 20, 'spread_width', -1.769, 0.2427),
  ('unknown', 20, 'tilt_deg', 43.61, 24.82),
  ('unknown', 20, 'width', -1.563, 0.2823),
  ('unknown', 20, 'z_max', 0.9872, 0.2164),
  ('unknown', 20, 'z_min', 0.8046, 0.1926);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.02389, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'area_m2', -2.825, 0.1888),
  ('unknown', 21, 'aspect', 0.3023, 0.1663),
  ('unknown', 21, 'behind', 0.3143, 0.1994),
  ('unknown', 21, 'edge_free', 0.05944, 0.105),
  ('unknown', 21, 'edge_free_top', 0.5536, 0.1301),
  ('unknown', 21, 'edge_joined', 0.8519, 0.1319),
  ('unknown', 21, 'edge_unseen', 0.004965, 0.03),
  ('unknown', 21, 'height', 0.7496, 0.06339),
  ('unknown', 21, 'length', -1.153, 0.1425),
  ('unknown', 21, 'rectangularity', 0.8295, 0.07869),
  ('unknown', 21, 'spread_length', -1.275, 0.1163),
  ('unknown', 21, 'spread_width', -1.569, 0.0668),
  ('unknown', 21, 'tilt_deg', 0.3617, 0.8881),
  ('unknown', 21, 'width', -1.485, 0.1072),
  ('unknown', 21, 'z_max', 0.7501, 0.06761),
  ('unknown', 21, 'z_min', 0.7441, 0.05976);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.03063, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'area_m2', -0.4766, 0.6862),
  ('unknown', 22, 'aspect', 0.6397, 0.2584),
  ('unknown', 22, 'behind', 0.4986, 0.3038),
  ('unknown', 22, 'edge_free', 0.2818, 0.2339),
  ('unknown', 22, 'edge_free_top', 0.2987, 0.2397),
  ('unknown', 22, 'edge_joined', 0.6136, 0.1901),
  ('unknown', 22, 'edge_unseen', 0.002657, 0.03),
  ('unknown', 22, 'height', 1.045, 0.3292),
  ('unknown', 22, 'length', 0.5971, 0.2238),
  ('unknown', 22, 'rectangularity', 0.5581, 0.1659),
  ('unknown', 22, 'spread_length', 0.4998, 0.2066),
  ('unknown', 22, 'spread_width', -0.5603, 0.7472),
  ('unknown', 22, 'tilt_deg', 88.14, 0.8802),
  ('unknown', 22, 'width', -0.4067, 0.6216),
  ('unknown', 22, 'z_max', 1.995, 0.3466),
  ('unknown', 22, 'z_min', 0.1173, 0.1794);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.02182, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'area_m2', -3.575, 0.2988),
  ('unknown', 23, 'aspect', 0.2213, 0.1338),
  ('unknown', 23, 'behind', 0.3135, 0.2275),
  ('unknown', 23, 'edge_free', 0.3639, 0.2948),
  ('unknown', 23, 'edge_free_top', 0.3743, 0.3708),
  ('unknown', 23, 'edge_joined', 0.4983, 0.3273),
  ('unknown', 23, 'edge_unseen', 0.002529, 0.03),
  ('unknown', 23, 'height', 0.8193, 0.2569),
  ('unknown', 23, 'length', -1.536, 0.1645),
  ('unknown', 23, 'rectangularity', 0.7814, 0.05982),
  ('unknown', 23, 'spread_length', -1.669, 0.1903),
  ('unknown', 23, 'spread_width', -1.91, 0.1468),
  ('unknown', 23, 'tilt_deg', 25.01, 24.8),
  ('unknown', 23, 'width', -1.787, 0.1482),
  ('unknown', 23, 'z_max', 0.8234, 0.1806),
  ('unknown', 23, 'z_min', 0.7709, 0.1875);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.01663, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'area_m2', -2.275, 0.3769),
  ('unknown', 24, 'aspect', 0.5517, 0.2156),
  ('unknown', 24, 'behind', 0.7336, 0.07927),
  ('unknown', 24, 'edge_free', 0.6979, 0.1758),
  ('unknown', 24, 'edge_free_top', 0.5533, 0.1312),
  ('unknown', 24, 'edge_joined', 0.2544, 0.08771),
  ('unknown', 24, 'edge_unseen', 0.0008127, 0.03),
  ('unknown', 24, 'height', 0.3898, 0.09333),
  ('unknown', 24, 'length', -0.7642, 0.2441),
  ('unknown', 24, 'rectangularity', 0.7994, 0.1),
  ('unknown', 24, 'spread_length', -0.944, 0.1683),
  ('unknown', 24, 'spread_width', -1.5, 0.1338),
  ('unknown', 24, 'tilt_deg', 1.277, 2.26),
  ('unknown', 24, 'width', -1.249, 0.2849),
  ('unknown', 24, 'z_max', 0.3684, 0.07572),
  ('unknown', 24, 'z_min', 0.3522, 0.06729);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.02916, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'area_m2', -1.366, 0.4085),
  ('unknown', 25, 'aspect', 0.789, 0.3906),
  ('unknown', 25, 'behind', 0.7759, 0.07542),
  ('unknown', 25, 'edge_free', 0.2347, 0.1051),
  ('unknown', 25, 'edge_free_top', 0.5517, 0.1295),
  ('unknown', 25, 'edge_joined', 0.7273, 0.1119),
  ('unknown', 25, 'edge_unseen', 0.01143, 0.03621),
  ('unknown', 25, 'height', 1.198, 0.2546),
  ('unknown', 25, 'length', -0.03612, 0.3417),
  ('unknown', 25, 'rectangularity', 0.6641, 0.1264),
  ('unknown', 25, 'spread_length', -0.1695, 0.2441),
  ('unknown', 25, 'spread_width', -1.006, 0.374),
  ('unknown', 25, 'tilt_deg', 7.195, 2.381),
  ('unknown', 25, 'width', -0.8919, 0.2617),
  ('unknown', 25, 'z_max', 1.253, 0.2712),
  ('unknown', 25, 'z_min', 1.187, 0.2738);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.01989, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'area_m2', -2.051, 0.5098),
  ('unknown', 26, 'aspect', 1.076, 0.3734),
  ('unknown', 26, 'behind', 0.2527, 0.269),
  ('unknown', 26, 'edge_free', 0.9848, 0.03204),
  ('unknown', 26, 'edge_free_top', 0.5534, 0.1302),
  ('unknown', 26, 'edge_joined', 0.0128, 0.03117),
  ('unknown', 26, 'edge_unseen', 0.2154, 0.1183),
  ('unknown', 26, 'height', 2.493, 0.2552),
  ('unknown', 26, 'length', -0.3332, 0.4541),
  ('unknown', 26, 'rectangularity', 0.7894, 0.09406),
  ('unknown', 26, 'spread_length', -0.4868, 0.439),
  ('unknown', 26, 'spread_width', -1.606, 0.08584),
  ('unknown', 26, 'tilt_deg', 1.453, 1.969),
  ('unknown', 26, 'width', -1.488, 0.09433),
  ('unknown', 26, 'z_max', 2.53, 0.2629),
  ('unknown', 26, 'z_min', 2.517, 0.2612);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.03654, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'area_m2', -0.79, 0.5176),
  ('unknown', 27, 'aspect', 0.237, 0.1992),
  ('unknown', 27, 'behind', 0.4727, 0.1743),
  ('unknown', 27, 'edge_free', 0.6621, 0.1784),
  ('unknown', 27, 'edge_free_top', 0.8402, 0.1645),
  ('unknown', 27, 'edge_joined', 0.1461, 0.0932),
  ('unknown', 27, 'edge_unseen', 0.003658, 0.03),
  ('unknown', 27, 'height', 0.8629, 0.3202),
  ('unknown', 27, 'length', -0.07713, 0.246),
  ('unknown', 27, 'rectangularity', 0.7116, 0.09321),
  ('unknown', 27, 'spread_length', -0.2129, 0.2448),
  ('unknown', 27, 'spread_width', -0.6242, 0.3195),
  ('unknown', 27, 'tilt_deg', 77.45, 6.006),
  ('unknown', 27, 'width', -0.3617, 0.2436),
  ('unknown', 27, 'z_max', 1.264, 0.2538),
  ('unknown', 27, 'z_min', 0.2991, 0.291);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.009113, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'area_m2', -2.391, 0.3491),
  ('unknown', 28, 'aspect', 0.4755, 0.326),
  ('unknown', 28, 'behind', 0.0152, 0.04311),
  ('unknown', 28, 'edge_free', 0.03218, 0.03),
  ('unknown', 28, 'edge_free_top', 0.03007, 0.05933),
  ('unknown', 28, 'edge_joined', 0.8372, 0.1821),
  ('unknown', 28, 'edge_unseen', 0.07735, 0.1078),
  ('unknown', 28, 'height', 1.628, 0.2112),
  ('unknown', 28, 'length', -0.8411, 0.2508),
  ('unknown', 28, 'rectangularity', 0.7393, 0.06137),
  ('unknown', 28, 'spread_length', -1.007, 0.2059),
  ('unknown', 28, 'spread_width', -1.504, 0.2619),
  ('unknown', 28, 'tilt_deg', 88.87, 2.762),
  ('unknown', 28, 'width', -1.28, 0.2065),
  ('unknown', 28, 'z_max', 1.858, 0.1851),
  ('unknown', 28, 'z_min', 1.445, 0.2378);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.02977, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'area_m2', 3.27, 0.833),
  ('unknown', 29, 'aspect', 0.3372, 0.2265),
  ('unknown', 29, 'behind', 0.003412, 0.03),
  ('unknown', 29, 'edge_free', 0.006166, 0.03),
  ('unknown', 29, 'edge_free_top', 0.01015, 0.03),
  ('unknown', 29, 'edge_joined', 0.06097, 0.1054),
  ('unknown', 29, 'edge_unseen', 0.09127, 0.1268),
  ('unknown', 29, 'height', 2.204, 0.8503),
  ('unknown', 29, 'length', 1.961, 0.3624),
  ('unknown', 29, 'rectangularity', 0.8773, 0.1084),
  ('unknown', 29, 'spread_length', 1.802, 0.4651),
  ('unknown', 29, 'spread_width', 1.466, 0.4229),
  ('unknown', 29, 'tilt_deg', 89.82, 1.063),
  ('unknown', 29, 'width', 1.521, 0.4799),
  ('unknown', 29, 'z_max', 5.437, 2.341),
  ('unknown', 29, 'z_min', -0.8659, 1.329);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.01078, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'area_m2', -2.857, 0.559),
  ('unknown', 30, 'aspect', 0.6462, 0.2806),
  ('unknown', 30, 'behind', 0.5073, 0.3194),
  ('unknown', 30, 'edge_free', 0.436, 0.2793),
  ('unknown', 30, 'edge_free_top', 0.4558, 0.3986),
  ('unknown', 30, 'edge_joined', 0.3542, 0.2737),
  ('unknown', 30, 'edge_unseen', 0.1845, 0.1448),
  ('unknown', 30, 'height', 2.143, 0.5316),
  ('unknown', 30, 'length', -0.8892, 0.3784),
  ('unknown', 30, 'rectangularity', 0.6904, 0.1107),
  ('unknown', 30, 'spread_length', -1.041, 0.3557),
  ('unknown', 30, 'spread_width', -1.759, 0.2277),
  ('unknown', 30, 'tilt_deg', 32.23, 29.67),
  ('unknown', 30, 'width', -1.565, 0.2655),
  ('unknown', 30, 'z_max', 2.237, 0.5709),
  ('unknown', 30, 'z_min', 2.107, 0.6259);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.01237, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'area_m2', -2.986, 0.3079),
  ('unknown', 31, 'aspect', 0.5805, 0.251),
  ('unknown', 31, 'behind', 0.7536, 0.07637),
  ('unknown', 31, 'edge_free', 0.2421, 0.1384),
  ('unknown', 31, 'edge_free_top', 0.3137, 0.3065),
  ('unknown', 31, 'edge_joined', 0.4666, 0.2733),
  ('unknown', 31, 'edge_unseen', 0.001988, 0.03),
  ('unknown', 31, 'height', 0.9577, 0.3002),
  ('unknown', 31, 'length', -1.027, 0.2206),
  ('unknown', 31, 'rectangularity', 0.6878, 0.09563),
  ('unknown', 31, 'spread_length', -1.184, 0.2044),
  ('unknown', 31, 'spread_width', -1.729, 0.2049),
  ('unknown', 31, 'tilt_deg', 71.54, 25.76),
  ('unknown', 31, 'width', -1.582, 0.2219),
  ('unknown', 31, 'z_max', 1.09, 0.3339),
  ('unknown', 31, 'z_min', 0.8321, 0.3173);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.01853, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'area_m2', -2.877, 0.4097),
  ('unknown', 32, 'aspect', 0.5195, 0.2607),
  ('unknown', 32, 'behind', 0.4194, 0.2566),
  ('unknown', 32, 'edge_free', 0.5726, 0.2244),
  ('unknown', 32, 'edge_free_top', 0.9221, 0.1061),
  ('unknown', 32, 'edge_joined', 0.1819, 0.1733),
  ('unknown', 32, 'edge_unseen', 0.1619, 0.1566),
  ('unknown', 32, 'height', 0.2143, 0.1227),
  ('unknown', 32, 'length', -1.025, 0.2324),
  ('unknown', 32, 'rectangularity', 0.716, 0.1155),
  ('unknown', 32, 'spread_length', -1.183, 0.3009),
  ('unknown', 32, 'spread_width', -1.751, 0.2415),
  ('unknown', 32, 'tilt_deg', 34.18, 30.6),
  ('unknown', 32, 'width', -1.503, 0.2282),
  ('unknown', 32, 'z_max', 0.2484, 0.1554),
  ('unknown', 32, 'z_min', 0.1188, 0.1083);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.01792, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'area_m2', -1.391, 0.3729),
  ('unknown', 33, 'aspect', 1.68, 0.3037),
  ('unknown', 33, 'behind', 0.6926, 0.08468),
  ('unknown', 33, 'edge_free', 0.02226, 0.04336),
  ('unknown', 33, 'edge_free_top', 0.5532, 0.13),
  ('unknown', 33, 'edge_joined', 0.9024, 0.1175),
  ('unknown', 33, 'edge_unseen', 0.02595, 0.05221),
  ('unknown', 33, 'height', 0.8878, 0.08026),
  ('unknown', 33, 'length', 0.3112, 0.2653),
  ('unknown', 33, 'rectangularity', 0.7716, 0.06588),
  ('unknown', 33, 'spread_length', 0.1388, 0.3141),
  ('unknown', 33, 'spread_width', -1.477, 0.2328),
  ('unknown', 33, 'tilt_deg', 1.756, 2.287),
  ('unknown', 33, 'width', -1.395, 0.2029),
  ('unknown', 33, 'z_max', 0.8975, 0.07879),
  ('unknown', 33, 'z_min', 0.8837, 0.07991);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.01053, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'area_m2', -2.22, 0.3185),
  ('unknown', 34, 'aspect', 1.514, 0.3292),
  ('unknown', 34, 'behind', 0.5693, 0.276),
  ('unknown', 34, 'edge_free', 0.3538, 0.2224),
  ('unknown', 34, 'edge_free_top', 0.3947, 0.3942),
  ('unknown', 34, 'edge_joined', 0.3941, 0.3097),
  ('unknown', 34, 'edge_unseen', 0.005795, 0.03187),
  ('unknown', 34, 'height', 0.5949, 0.2546),
  ('unknown', 34, 'length', -0.1727, 0.2292),
  ('unknown', 34, 'rectangularity', 0.689, 0.08766),
  ('unknown', 34, 'spread_length', -0.242, 0.2396),
  ('unknown', 34, 'spread_width', -1.925, 0.1731),
  ('unknown', 34, 'tilt_deg', 60.48, 35.45),
  ('unknown', 34, 'width', -1.679, 0.2162),
  ('unknown', 34, 'z_max', 0.807, 0.2068),
  ('unknown', 34, 'z_min', 0.4225, 0.328);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.02305, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'area_m2', 1.886, 0.5755),
  ('unknown', 35, 'aspect', 1.111, 0.7783),
  ('unknown', 35, 'behind', 0.007598, 0.03),
  ('unknown', 35, 'edge_free', 0.008384, 0.03187),
  ('unknown', 35, 'edge_free_top', 0.01021, 0.03168),
  ('unknown', 35, 'edge_joined', 0.1338, 0.2014),
  ('unknown', 35, 'edge_unseen', 0.05824, 0.1011),
  ('unknown', 35, 'height', 1.52, 1.227),
  ('unknown', 35, 'length', 1.554, 0.4944),
  ('unknown', 35, 'rectangularity', 0.8152, 0.1387),
  ('unknown', 35, 'spread_length', 1.671, 0.3299),
  ('unknown', 35, 'spread_width', 0.5272, 0.4315),
  ('unknown', 35, 'tilt_deg', 89.76, 1.147),
  ('unknown', 35, 'width', 0.5624, 0.4543),
  ('unknown', 35, 'z_max', 3.967, 2.727),
  ('unknown', 35, 'z_min', -0.7601, 1.068);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.02394, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'area_m2', -0.9159, 0.2962),
  ('unknown', 36, 'aspect', 1.153, 0.2563),
  ('unknown', 36, 'behind', 0.4658, 0.2149),
  ('unknown', 36, 'edge_free', 0.5013, 0.1074),
  ('unknown', 36, 'edge_free_top', 0.8495, 0.1741),
  ('unknown', 36, 'edge_joined', 0.02865, 0.04587),
  ('unknown', 36, 'edge_unseen', 0.03239, 0.05729),
  ('unknown', 36, 'height', 0.9464, 0.07094),
  ('unknown', 36, 'length', 0.3084, 0.1856),
  ('unknown', 36, 'rectangularity', 0.6891, 0.1349),
  ('unknown', 36, 'spread_length', 0.172, 0.258),
  ('unknown', 36, 'spread_width', -1.033, 0.2051),
  ('unknown', 36, 'tilt_deg', 89.8, 1.05),
  ('unknown', 36, 'width', -0.8638, 0.1951),
  ('unknown', 36, 'z_max', 1.159, 0.09423),
  ('unknown', 36, 'z_min', 0.7032, 0.05653);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.006438, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'area_m2', 0.1597, 1.115),
  ('unknown', 37, 'aspect', 0.5438, 0.3725),
  ('unknown', 37, 'behind', 0.464, 0.2928),
  ('unknown', 37, 'edge_free', 0.3797, 0.2148),
  ('unknown', 37, 'edge_free_top', 0.4917, 0.3182),
  ('unknown', 37, 'edge_joined', 0.3934, 0.2471),
  ('unknown', 37, 'edge_unseen', 0.1162, 0.1588),
  ('unknown', 37, 'height', 1.036, 0.5911),
  ('unknown', 37, 'length', 0.6476, 0.5998),
  ('unknown', 37, 'rectangularity', 0.5657, 0.154),
  ('unknown', 37, 'spread_length', 0.5197, 0.6159),
  ('unknown', 37, 'spread_width', -0.2621, 0.5658),
  ('unknown', 37, 'tilt_deg', 47.04, 34.59),
  ('unknown', 37, 'width', 0.08386, 0.6497),
  ('unknown', 37, 'z_max', 1.53, 1.185),
  ('unknown', 37, 'z_min', 0.4288, 0.5114);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.01495, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'area_m2', -0.5201, 0.3205),
  ('unknown', 38, 'aspect', 0.4847, 0.107),
  ('unknown', 38, 'behind', 0.03993, 0.05114),
  ('unknown', 38, 'edge_free', 0.9061, 0.1065),
  ('unknown', 38, 'edge_free_top', 0.9747, 0.04948),
  ('unknown', 38, 'edge_joined', 0.03038, 0.05621),
  ('unknown', 38, 'edge_unseen', 0.115, 0.1279),
  ('unknown', 38, 'height', 1.665, 0.1039),
  ('unknown', 38, 'length', 0.06745, 0.2104),
  ('unknown', 38, 'rectangularity', 0.8635, 0.1083),
  ('unknown', 38, 'spread_length', -0.01783, 0.1827),
  ('unknown', 38, 'spread_width', -0.5426, 0.1365),
  ('unknown', 38, 'tilt_deg', 89.51, 2.004),
  ('unknown', 38, 'width', -0.3937, 0.1251),
  ('unknown', 38, 'z_max', 2.046, 0.1364),
  ('unknown', 38, 'z_min', 1.375, 0.0878);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.008741, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'area_m2', -1.809, 0.232),
  ('unknown', 39, 'aspect', 0.1923, 0.1401),
  ('unknown', 39, 'behind', 0.2583, 0.1357),
  ('unknown', 39, 'edge_free', 0.8208, 0.1172),
  ('unknown', 39, 'edge_free_top', 0.5533, 0.1298),
  ('unknown', 39, 'edge_joined', 0.01549, 0.03217),
  ('unknown', 39, 'edge_unseen', 0.01759, 0.06264),
  ('unknown', 39, 'height', 0.1126, 0.05616),
  ('unknown', 39, 'length', -0.5511, 0.1371),
  ('unknown', 39, 'rectangularity', 0.5995, 0.06931),
  ('unknown', 39, 'spread_length', -0.7553, 0.08129),
  ('unknown', 39, 'spread_width', -0.9911, 0.1395),
  ('unknown', 39, 'tilt_deg', 1.409, 2.692),
  ('unknown', 39, 'width', -0.7421, 0.1709),
  ('unknown', 39, 'z_max', 0.1167, 0.06388),
  ('unknown', 39, 'z_min', 0.1035, 0.05183);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.009461, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'area_m2', -1.053, 0.5328),
  ('unknown', 40, 'aspect', 1.482, 0.5463),
  ('unknown', 40, 'behind', 0.6422, 0.1189),
  ('unknown', 40, 'edge_free', 0.4195, 0.2576),
  ('unknown', 40, 'edge_free_top', 0.06696, 0.163),
  ('unknown', 40, 'edge_joined', 0.4282, 0.3143),
  ('unknown', 40, 'edge_unseen', 0.0865, 0.08589),
  ('unknown', 40, 'height', 2.634, 0.4104),
  ('unknown', 40, 'length', 0.4141, 0.4087),
  ('unknown', 40, 'rectangularity', 0.6735, 0.1608),
  ('unknown', 40, 'spread_length', 0.3714, 0.4191),
  ('unknown', 40, 'spread_width', -1.398, 0.3154),
  ('unknown', 40, 'tilt_deg', 48.92, 39.95),
  ('unknown', 40, 'width', -1.023, 0.2888),
  ('unknown', 40, 'z_max', 2.801, 0.461),
  ('unknown', 40, 'z_min', 2.61, 0.3304);

-- floor: 499 examples
UPDATE object_class SET prior = 0.0433 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.311, 1.578)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4648, 0.3742)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_joined', 0.2465, 0.1491)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_unseen', 0.2524, 0.1408)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.0009612, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.172, 0.7315)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5853, 0.1269)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.909, 0.6605)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.3208, 0.8368)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.5588, 0.9562)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.7026, 0.9241)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.007338, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.005216, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'floor';
DELETE FROM class_density WHERE class = 'floor';
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.2592, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'area_m2', 2.554, 0.2634),
  ('floor', 1, 'aspect', 0.2546, 0.1583),
  ('floor', 1, 'behind', -0.0007544, 0.03234),
  ('floor', 1, 'edge_free', -0.0001795, 0.0311),
  ('floor', 1, 'edge_free_top', -2.969e-05, 0.03032),
  ('floor', 1, 'edge_joined', 0.2829, 0.1153),
  ('floor', 1, 'edge_unseen', 0.1995, 0.1243),
  ('floor', 1, 'height', 1.954e-05, 0.02259),
  ('floor', 1, 'length', 1.705, 0.1379),
  ('floor', 1, 'rectangularity', 0.5537, 0.1255),
  ('floor', 1, 'spread_length', 1.372, 0.1231),
  ('floor', 1, 'spread_width', 0.9499, 0.1371),
  ('floor', 1, 'tilt_deg', 0.007917, 0.4583),
  ('floor', 1, 'width', 1.455, 0.1216),
  ('floor', 1, 'z_max', -0.000124, 0.02257),
  ('floor', 1, 'z_min', -8.976e-05, 0.02327);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.198, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'area_m2', 2.105, 0.2277),
  ('floor', 2, 'aspect', 0.188, 0.1178),
  ('floor', 2, 'behind', -0.0006701, 0.03158),
  ('floor', 2, 'edge_free', -0.0001352, 0.03078),
  ('floor', 2, 'edge_free_top', -7.068e-06, 0.03037),
  ('floor', 2, 'edge_joined', 0.2853, 0.1005),
  ('floor', 2, 'edge_unseen', 0.1957, 0.07634),
  ('floor', 2, 'height', 0.000401, 0.0225),
  ('floor', 2, 'length', 1.403, 0.1179),
  ('floor', 2, 'rectangularity', 0.6087, 0.1057),
  ('floor', 2, 'spread_length', 1.154, 0.1011),
  ('floor', 2, 'spread_width', 0.7922, 0.1364),
  ('floor', 2, 'tilt_deg', 0.01859, 0.4537),
  ('floor', 2, 'width', 1.217, 0.1242),
  ('floor', 2, 'z_max', 0.0006107, 0.0225),
  ('floor', 2, 'z_min', 2.261e-05, 0.02302);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.09536, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'area_m2', -1.308, 0.4493),
  ('floor', 3, 'aspect', 0.9462, 0.4644),
  ('floor', 3, 'behind', -0.004854, 0.03),
  ('floor', 3, 'edge_free', -0.001052, 0.03),
  ('floor', 3, 'edge_free_top', -7.955e-05, 0.03),
  ('floor', 3, 'edge_joined', 0.271, 0.2364),
  ('floor', 3, 'edge_unseen', 0.3349, 0.1638),
  ('floor', 3, 'height', 0.0009831, 0.0225),
  ('floor', 3, 'length', -0.01201, 0.3421),
  ('floor', 3, 'rectangularity', 0.6619, 0.1212),
  ('floor', 3, 'spread_length', -0.1549, 0.329),
  ('floor', 3, 'spread_width', -1.086, 0.2895),
  ('floor', 3, 'tilt_deg', 1.829, 0.9907),
  ('floor', 3, 'width', -0.8484, 0.2714),
  ('floor', 3, 'z_max', 0.01116, 0.02331),
  ('floor', 3, 'z_min', -0.01368, 0.02376);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.1288, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'area_m2', 2.147, 0.2866),
  ('floor', 4, 'aspect', 0.7513, 0.1482),
  ('floor', 4, 'behind', -0.0002177, 0.03174),
  ('floor', 4, 'edge_free', -0.0001708, 0.03057),
  ('floor', 4, 'edge_free_top', -3.091e-05, 0.03025),
  ('floor', 4, 'edge_joined', 0.2721, 0.1053),
  ('floor', 4, 'edge_unseen', 0.2847, 0.08387),
  ('floor', 4, 'height', 5.358e-05, 0.02258),
  ('floor', 4, 'length', 1.771, 0.188),
  ('floor', 4, 'rectangularity', 0.5313, 0.1065),
  ('floor', 4, 'spread_length', 1.389, 0.1535),
  ('floor', 4, 'spread_width', 0.65, 0.1487),
  ('floor', 4, 'tilt_deg', 0.02966, 0.4568),
  ('floor', 4, 'width', 1.026, 0.1852),
  ('floor', 4, 'z_max', 0.0006207, 0.02259),
  ('floor', 4, 'z_min', -0.0004232, 0.02257);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.08009, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'area_m2', 0.0908, 0.3497),
  ('floor', 5, 'aspect', 0.708, 0.41),
  ('floor', 5, 'behind', -0.003316, 0.03),
  ('floor', 5, 'edge_free', -0.0005957, 0.03),
  ('floor', 5, 'edge_free_top', -5.47e-05, 0.03015),
  ('floor', 5, 'edge_joined', 0.1876, 0.1542),
  ('floor', 5, 'edge_unseen', 0.3502, 0.1432),
  ('floor', 5, 'height', 0.002828, 0.02373),
  ('floor', 5, 'length', 0.6253, 0.2378),
  ('floor', 5, 'rectangularity', 0.6193, 0.1201),
  ('floor', 5, 'spread_length', 0.4882, 0.1521),
  ('floor', 5, 'spread_width', -0.308, 0.2567),
  ('floor', 5, 'tilt_deg', 1.428, 0.7881),
  ('floor', 5, 'width', -0.04306, 0.2719),
  ('floor', 5, 'z_max', 0.02234, 0.02697),
  ('floor', 5, 'z_min', -0.0161, 0.02595);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.07281, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'area_m2', 1.462, 0.3464),
  ('floor', 6, 'aspect', 0.5778, 0.2442),
  ('floor', 6, 'behind', -0.0002683, 0.03142),
  ('floor', 6, 'edge_free', -0.0001912, 0.0303),
  ('floor', 6, 'edge_free_top', -4.281e-05, 0.03028),
  ('floor', 6, 'edge_joined', 0.1387, 0.05762),
  ('floor', 6, 'edge_unseen', 0.2159, 0.06629),
  ('floor', 6, 'height', -4.5e-06, 0.0226),
  ('floor', 6, 'length', 1.383, 0.1759),
  ('floor', 6, 'rectangularity', 0.4954, 0.1083),
  ('floor', 6, 'spread_length', 1.11, 0.1664),
  ('floor', 6, 'spread_width', 0.4404, 0.1932),
  ('floor', 6, 'tilt_deg', 0.04359, 0.4529),
  ('floor', 6, 'width', 0.8106, 0.189),
  ('floor', 6, 'z_max', 0.0006066, 0.02273),
  ('floor', 6, 'z_min', -0.0004741, 0.02278);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.06292, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'area_m2', 1.38, 0.51),
  ('floor', 7, 'aspect', 0.3782, 0.2062),
  ('floor', 7, 'behind', -0.0002885, 0.03068),
  ('floor', 7, 'edge_free', -6.221e-05, 0.03038),
  ('floor', 7, 'edge_free_top', -5.466e-05, 0.03023),
  ('floor', 7, 'edge_joined', 0.1831, 0.09084),
  ('floor', 7, 'edge_unseen', 0.3568, 0.08733),
  ('floor', 7, 'height', 0.0003127, 0.02256),
  ('floor', 7, 'length', 1.159, 0.2284),
  ('floor', 7, 'rectangularity', 0.5777, 0.0785),
  ('floor', 7, 'spread_length', 0.9188, 0.1783),
  ('floor', 7, 'spread_width', 0.4543, 0.2861),
  ('floor', 7, 'tilt_deg', 1.335, 0.5956),
  ('floor', 7, 'width', 0.7821, 0.2737),
  ('floor', 7, 'z_max', 0.03478, 0.0225),
  ('floor', 7, 'z_min', -0.03724, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.03425, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'area_m2', -2.639, 0.5567),
  ('floor', 8, 'aspect', 0.9287, 0.4231),
  ('floor', 8, 'behind', -0.001173, 0.03092),
  ('floor', 8, 'edge_free', -0.001053, 0.03),
  ('floor', 8, 'edge_free_top', -0.0003269, 0.03),
  ('floor', 8, 'edge_joined', 0.05528, 0.05712),
  ('floor', 8, 'edge_unseen', 0.341, 0.1864),
  ('floor', 8, 'height', -0.1523, 0.2746),
  ('floor', 8, 'length', -0.6557, 0.4636),
  ('floor', 8, 'rectangularity', 0.6312, 0.1586),
  ('floor', 8, 'spread_length', -0.8269, 0.4355),
  ('floor', 8, 'spread_width', -1.727, 0.3185),
  ('floor', 8, 'tilt_deg', 2.298, 0.7723),
  ('floor', 8, 'width', -1.5, 0.3311),
  ('floor', 8, 'z_max', -0.2148, 0.2492),
  ('floor', 8, 'z_min', -0.1901, 0.2906);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.01861, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'area_m2', -0.5672, 0.8789),
  ('floor', 9, 'aspect', 0.7262, 0.3802),
  ('floor', 9, 'behind', -0.000844, 0.03),
  ('floor', 9, 'edge_free', -0.0001837, 0.03),
  ('floor', 9, 'edge_free_top', -1.632e-06, 0.03),
  ('floor', 9, 'edge_joined', 0.2612, 0.2191),
  ('floor', 9, 'edge_unseen', 0.3606, 0.09751),
  ('floor', 9, 'height', 0.06285, 0.03283),
  ('floor', 9, 'length', 0.3715, 0.4562),
  ('floor', 9, 'rectangularity', 0.5599, 0.1412),
  ('floor', 9, 'spread_length', 0.1906, 0.3942),
  ('floor', 9, 'spread_width', -0.6088, 0.477),
  ('floor', 9, 'tilt_deg', 11.58, 17.68),
  ('floor', 9, 'width', -0.3336, 0.5688),
  ('floor', 9, 'z_max', 0.1053, 0.03072),
  ('floor', 9, 'z_min', 0.02673, 0.04176);

-- ceiling: 429 examples
UPDATE object_class SET prior = 0.03158 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.631, 1.613)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4014, 0.3738)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.01204, 0.06121)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.01155, 0.06131)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_joined', 0.4423, 0.2148)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_unseen', 0.3097, 0.1487)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.834, 0.3132)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.22, 0.7382)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6761, 0.1238)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.097, 0.7318)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.5251, 0.8563)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.07097, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.8166, 0.9101)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.834, 0.3135)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.833, 0.313)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'ceiling';
DELETE FROM class_density WHERE class = 'ceiling';
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.2662, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'area_m2', 2.68, 0.2609),
  ('ceiling', 1, 'aspect', 0.2186, 0.1332),
  ('ceiling', 1, 'behind', 0.0001021, 0.03),
  ('ceiling', 1, 'edge_free', 0.0001845, 0.03),
  ('ceiling', 1, 'edge_free_top', 0.0001053, 0.3178),
  ('ceiling', 1, 'edge_joined', 0.5155, 0.1527),
  ('ceiling', 1, 'edge_unseen', 0.3073, 0.1274),
  ('ceiling', 1, 'height', 2.833, 0.126),
  ('ceiling', 1, 'length', 1.644, 0.1166),
  ('ceiling', 1, 'rectangularity', 0.691, 0.1159),
  ('ceiling', 1, 'spread_length', 1.529, 0.1158),
  ('ceiling', 1, 'spread_width', 1.097, 0.1397),
  ('ceiling', 1, 'tilt_deg', 0.001831, 0.45),
  ('ceiling', 1, 'width', 1.421, 0.1137),
  ('ceiling', 1, 'z_max', 2.831, 0.128),
  ('ceiling', 1, 'z_min', 2.832, 0.1284);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1813, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'area_m2', 2.591, 0.3245),
  ('ceiling', 2, 'aspect', 0.2104, 0.1503),
  ('ceiling', 2, 'behind', -1.65e-05, 0.03),
  ('ceiling', 2, 'edge_free', 0.000135, 0.03),
  ('ceiling', 2, 'edge_free_top', 0.0001231, 0.3168),
  ('ceiling', 2, 'edge_joined', 0.6029, 0.1686),
  ('ceiling', 2, 'edge_unseen', 0.3127, 0.127),
  ('ceiling', 2, 'height', 2.51, 0.06484),
  ('ceiling', 2, 'length', 1.593, 0.1714),
  ('ceiling', 2, 'rectangularity', 0.6878, 0.1154),
  ('ceiling', 2, 'spread_length', 1.453, 0.1569),
  ('ceiling', 2, 'spread_width', 1.051, 0.1658),
  ('ceiling', 2, 'tilt_deg', 0.002027, 0.45),
  ('ceiling', 2, 'width', 1.383, 0.1361),
  ('ceiling', 2, 'z_max', 2.509, 0.06832),
  ('ceiling', 2, 'z_min', 2.509, 0.06798);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.1489, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'area_m2', 2.051, 0.3064),
  ('ceiling', 3, 'aspect', 0.4299, 0.2923),
  ('ceiling', 3, 'behind', 0.0001863, 0.03),
  ('ceiling', 3, 'edge_free', 0.0001857, 0.03),
  ('ceiling', 3, 'edge_free_top', -2.879e-05, 0.3174),
  ('ceiling', 3, 'edge_joined', 0.3559, 0.1346),
  ('ceiling', 3, 'edge_unseen', 0.3198, 0.06622),
  ('ceiling', 3, 'height', 2.993, 0.08088),
  ('ceiling', 3, 'length', 1.465, 0.195),
  ('ceiling', 3, 'rectangularity', 0.6545, 0.1215),
  ('ceiling', 3, 'spread_length', 1.349, 0.1418),
  ('ceiling', 3, 'spread_width', 0.7174, 0.2126),
  ('ceiling', 3, 'tilt_deg', 0.002246, 0.45),
  ('ceiling', 3, 'width', 1.027, 0.2467),
  ('ceiling', 3, 'z_max', 2.994, 0.08235),
  ('ceiling', 3, 'z_min', 2.993, 0.08284);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.08541, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'area_m2', 2.072, 0.2805),
  ('ceiling', 4, 'aspect', 0.3591, 0.2489),
  ('ceiling', 4, 'behind', 0.0003226, 0.03),
  ('ceiling', 4, 'edge_free', 0.0003396, 0.03),
  ('ceiling', 4, 'edge_free_top', 0.0001057, 0.3166),
  ('ceiling', 4, 'edge_joined', 0.5238, 0.1709),
  ('ceiling', 4, 'edge_unseen', 0.3323, 0.07716),
  ('ceiling', 4, 'height', 2.654, 0.06906),
  ('ceiling', 4, 'length', 1.451, 0.1435),
  ('ceiling', 4, 'rectangularity', 0.6401, 0.1164),
  ('ceiling', 4, 'spread_length', 1.326, 0.1213),
  ('ceiling', 4, 'spread_width', 0.7665, 0.1705),
  ('ceiling', 4, 'tilt_deg', 0.01243, 0.45),
  ('ceiling', 4, 'width', 1.087, 0.2156),
  ('ceiling', 4, 'z_max', 2.655, 0.06844),
  ('ceiling', 4, 'z_min', 2.654, 0.0688);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.04389, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'area_m2', -0.7394, 0.6352),
  ('ceiling', 5, 'aspect', 0.9288, 0.2526),
  ('ceiling', 5, 'behind', 0.002241, 0.03),
  ('ceiling', 5, 'edge_free', 0.0003055, 0.03),
  ('ceiling', 5, 'edge_free_top', -6.378e-05, 0.3172),
  ('ceiling', 5, 'edge_joined', 0.2968, 0.1494),
  ('ceiling', 5, 'edge_unseen', 0.09022, 0.1187),
  ('ceiling', 5, 'height', 2.512, 0.03631),
  ('ceiling', 5, 'length', 0.3002, 0.4014),
  ('ceiling', 5, 'rectangularity', 0.7193, 0.111),
  ('ceiling', 5, 'spread_length', 0.1724, 0.4252),
  ('ceiling', 5, 'spread_width', -0.8208, 0.2292),
  ('ceiling', 5, 'tilt_deg', 0.1571, 0.4764),
  ('ceiling', 5, 'width', -0.6885, 0.3338),
  ('ceiling', 5, 'z_max', 2.511, 0.02885),
  ('ceiling', 5, 'z_min', 2.51, 0.03167);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.06445, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'area_m2', 2.126, 0.4875),
  ('ceiling', 6, 'aspect', 0.42, 0.2611),
  ('ceiling', 6, 'behind', 0.0004574, 0.03),
  ('ceiling', 6, 'edge_free', 0.0004715, 0.03),
  ('ceiling', 6, 'edge_free_top', 0.0001226, 0.3166),
  ('ceiling', 6, 'edge_joined', 0.1885, 0.06582),
  ('ceiling', 6, 'edge_unseen', 0.2791, 0.07366),
  ('ceiling', 6, 'height', 3.468, 0.2167),
  ('ceiling', 6, 'length', 1.519, 0.2516),
  ('ceiling', 6, 'rectangularity', 0.6239, 0.119),
  ('ceiling', 6, 'spread_length', 1.389, 0.2298),
  ('ceiling', 6, 'spread_width', 0.788, 0.2756),
  ('ceiling', 6, 'tilt_deg', 0.01821, 0.45),
  ('ceiling', 6, 'width', 1.095, 0.328),
  ('ceiling', 6, 'z_max', 3.478, 0.2251),
  ('ceiling', 6, 'z_min', 3.476, 0.2252);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.02893, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'area_m2', -2.211, 0.8553),
  ('ceiling', 7, 'aspect', 0.3675, 0.405),
  ('ceiling', 7, 'behind', 0.003428, 0.03471),
  ('ceiling', 7, 'edge_free', 0.004353, 0.0365),
  ('ceiling', 7, 'edge_free_top', -0.0006769, 0.3187),
  ('ceiling', 7, 'edge_joined', 0.4588, 0.2954),
  ('ceiling', 7, 'edge_unseen', 0.437, 0.1853),
  ('ceiling', 7, 'height', 2.78, 0.2536),
  ('ceiling', 7, 'length', -0.6778, 0.492),
  ('ceiling', 7, 'rectangularity', 0.6397, 0.09971),
  ('ceiling', 7, 'spread_length', -0.7535, 0.5061),
  ('ceiling', 7, 'spread_width', -1.299, 0.3888),
  ('ceiling', 7, 'tilt_deg', 0.5745, 0.6229),
  ('ceiling', 7, 'width', -1.082, 0.4683),
  ('ceiling', 7, 'z_max', 2.774, 0.2655),
  ('ceiling', 7, 'z_min', 2.787, 0.2514);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.03948, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'area_m2', -1.087, 0.6084),
  ('ceiling', 8, 'aspect', 0.5655, 0.4497),
  ('ceiling', 8, 'behind', 0.0008735, 0.03074),
  ('ceiling', 8, 'edge_free', 0.0005738, 0.03),
  ('ceiling', 8, 'edge_free_top', 0.0001021, 0.3166),
  ('ceiling', 8, 'edge_joined', 0.311, 0.1838),
  ('ceiling', 8, 'edge_unseen', 0.5465, 0.09479),
  ('ceiling', 8, 'height', 3.065, 0.06076),
  ('ceiling', 8, 'length', -0.03051, 0.3278),
  ('ceiling', 8, 'rectangularity', 0.6425, 0.09549),
  ('ceiling', 8, 'spread_length', -0.1544, 0.3307),
  ('ceiling', 8, 'spread_width', -0.86, 0.3739),
  ('ceiling', 8, 'tilt_deg', 0.1926, 0.45),
  ('ceiling', 8, 'width', -0.6107, 0.3656),
  ('ceiling', 8, 'z_max', 3.07, 0.05561),
  ('ceiling', 8, 'z_min', 3.068, 0.05596);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.05609, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'area_m2', 0.5141, 0.6979),
  ('ceiling', 9, 'aspect', 0.9164, 0.4566),
  ('ceiling', 9, 'behind', 0.3068, 0.1414),
  ('ceiling', 9, 'edge_free', 0.2778, 0.1363),
  ('ceiling', 9, 'edge_free_top', -0.0004513, 0.3188),
  ('ceiling', 9, 'edge_joined', 0.323, 0.1628),
  ('ceiling', 9, 'edge_unseen', 0.1833, 0.08854),
  ('ceiling', 9, 'height', 2.959, 0.3192),
  ('ceiling', 9, 'length', 0.8633, 0.4698),
  ('ceiling', 9, 'rectangularity', 0.7553, 0.1069),
  ('ceiling', 9, 'spread_length', 0.7318, 0.4206),
  ('ceiling', 9, 'spread_width', -0.2655, 0.3702),
  ('ceiling', 9, 'tilt_deg', 0.06103, 0.45),
  ('ceiling', 9, 'width', -0.08486, 0.3773),
  ('ceiling', 9, 'z_max', 2.932, 0.3353),
  ('ceiling', 9, 'z_min', 2.94, 0.3343);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 10, 0.03532, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 10, 'area_m2', -1.15, 1.173),
  ('ceiling', 10, 'aspect', 0.6012, 0.3579),
  ('ceiling', 10, 'behind', 0.0007912, 0.03),
  ('ceiling', 10, 'edge_free', 0.0007765, 0.03),
  ('ceiling', 10, 'edge_free_top', 9.495e-05, 0.3165),
  ('ceiling', 10, 'edge_joined', 0.1736, 0.1111),
  ('ceiling', 10, 'edge_unseen', 0.3952, 0.1428),
  ('ceiling', 10, 'height', 3.551, 0.1752),
  ('ceiling', 10, 'length', -0.01747, 0.6016),
  ('ceiling', 10, 'rectangularity', 0.6049, 0.07569),
  ('ceiling', 10, 'spread_length', -0.1402, 0.6218),
  ('ceiling', 10, 'spread_width', -0.8446, 0.5444),
  ('ceiling', 10, 'tilt_deg', 0.6772, 0.8624),
  ('ceiling', 10, 'width', -0.6236, 0.6001),
  ('ceiling', 10, 'z_max', 3.568, 0.1875),
  ('ceiling', 10, 'z_min', 3.562, 0.1863);

-- wall: 2699 examples
UPDATE object_class SET prior = 0.1796 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 0.4627, 1.49)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.6465, 0.4813)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.09673, 0.1856)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.1214, 0.2172)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.09539, 0.2273)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_joined', 0.2498, 0.2679)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_unseen', 0.1757, 0.1922)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.38, 0.4618)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 0.7794, 0.7243)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6604, 0.152)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.609, 0.7306)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', -0.1179, 0.8802)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.42, 2.122)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.1298, 0.8912)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.37, 0.7619)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.2964, 0.5389)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'wall';
DELETE FROM class_density WHERE class = 'wall';
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.1115, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'area_m2', 1.97, 0.3961),
  ('wall', 1, 'aspect', 0.4493, 0.2873),
  ('wall', 1, 'behind', -0.003627, 0.03),
  ('wall', 1, 'edge_free', 0.006059, 0.03),
  ('wall', 1, 'edge_free_top', -0.000539, 0.03),
  ('wall', 1, 'edge_joined', 0.1154, 0.115),
  ('wall', 1, 'edge_unseen', 0.0963, 0.1409),
  ('wall', 1, 'height', 1.564, 0.2136),
  ('wall', 1, 'length', 1.429, 0.2056),
  ('wall', 1, 'rectangularity', 0.7055, 0.0629),
  ('wall', 1, 'spread_length', 1.225, 0.2208),
  ('wall', 1, 'spread_width', 0.7221, 0.1387),
  ('wall', 1, 'tilt_deg', 90.08, 0.45),
  ('wall', 1, 'width', 1.046, 0.08039),
  ('wall', 1, 'z_max', 2.92, 0.388),
  ('wall', 1, 'z_min', -0.01456, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.09291, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'area_m2', 0.88, 0.3996),
  ('wall', 2, 'aspect', 0.5802, 0.5637),
  ('wall', 2, 'behind', -0.00664, 0.03),
  ('wall', 2, 'edge_free', 0.008476, 0.03),
  ('wall', 2, 'edge_free_top', 7.424e-05, 0.03),
  ('wall', 2, 'edge_joined', 0.2994, 0.1771),
  ('wall', 2, 'edge_unseen', 0.339, 0.1027),
  ('wall', 2, 'height', 1.531, 0.3059),
  ('wall', 2, 'length', 1.02, 0.2555),
  ('wall', 2, 'rectangularity', 0.6565, 0.1061),
  ('wall', 2, 'spread_length', 0.6398, 0.2468),
  ('wall', 2, 'spread_width', 0.115, 0.3563),
  ('wall', 2, 'tilt_deg', 90.19, 0.45),
  ('wall', 2, 'width', 0.4416, 0.4362),
  ('wall', 2, 'z_max', 2.712, 0.1483),
  ('wall', 2, 'z_min', 0.4595, 0.2184);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.1658, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'area_m2', -0.5334, 0.7756),
  ('wall', 3, 'aspect', 0.8654, 0.4574),
  ('wall', 3, 'behind', 0.1515, 0.2507),
  ('wall', 3, 'edge_free', 0.05123, 0.1198),
  ('wall', 3, 'edge_free_top', 0.003822, 0.03),
  ('wall', 3, 'edge_joined', 0.4178, 0.3368),
  ('wall', 3, 'edge_unseen', 0.2004, 0.2525),
  ('wall', 3, 'height', 1.931, 0.4341),
  ('wall', 3, 'length', 0.433, 0.3574),
  ('wall', 3, 'rectangularity', 0.6734, 0.1098),
  ('wall', 3, 'spread_length', 0.02852, 0.5509),
  ('wall', 3, 'spread_width', -0.7917, 0.3915),
  ('wall', 3, 'tilt_deg', 90.07, 0.45),
  ('wall', 3, 'width', -0.5693, 0.497),
  ('wall', 3, 'z_max', 2.803, 0.1858),
  ('wall', 3, 'z_min', 1.338, 0.5613);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.055, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'area_m2', 1.802, 0.3439),
  ('wall', 4, 'aspect', 0.3893, 0.2731),
  ('wall', 4, 'behind', 0.1588, 0.1374),
  ('wall', 4, 'edge_free', 0.1403, 0.09107),
  ('wall', 4, 'edge_free_top', 0.08074, 0.1099),
  ('wall', 4, 'edge_joined', 0.1134, 0.1241),
  ('wall', 4, 'edge_unseen', 0.1151, 0.134),
  ('wall', 4, 'height', 1.535, 0.2373),
  ('wall', 4, 'length', 1.382, 0.2133),
  ('wall', 4, 'rectangularity', 0.5288, 0.1058),
  ('wall', 4, 'spread_length', 1.246, 0.2182),
  ('wall', 4, 'spread_width', 0.7995, 0.1479),
  ('wall', 4, 'tilt_deg', 90.03, 0.4554),
  ('wall', 4, 'width', 1.025, 0.09416),
  ('wall', 4, 'z_max', 2.902, 0.3171),
  ('wall', 4, 'z_min', -0.01546, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.05093, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'area_m2', 0.66, 0.4042),
  ('wall', 5, 'aspect', 0.2123, 0.1538),
  ('wall', 5, 'behind', 0.4085, 0.1324),
  ('wall', 5, 'edge_free', 0.5023, 0.2629),
  ('wall', 5, 'edge_free_top', 0.6975, 0.2974),
  ('wall', 5, 'edge_joined', 0.1926, 0.1985),
  ('wall', 5, 'edge_unseen', 0.172, 0.1329),
  ('wall', 5, 'height', 1.216, 0.3169),
  ('wall', 5, 'length', 0.8528, 0.2678),
  ('wall', 5, 'rectangularity', 0.7419, 0.2002),
  ('wall', 5, 'spread_length', 0.5489, 0.142),
  ('wall', 5, 'spread_width', 0.1069, 0.3372),
  ('wall', 5, 'tilt_deg', 89.97, 0.45),
  ('wall', 5, 'width', 0.3773, 0.3006),
  ('wall', 5, 'z_max', 2.007, 0.8191),
  ('wall', 5, 'z_min', -0.04299, 0.1953);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.07098, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'area_m2', -0.958, 0.5313),
  ('wall', 6, 'aspect', 1.111, 0.4384),
  ('wall', 6, 'behind', 0.1108, 0.1892),
  ('wall', 6, 'edge_free', 0.4627, 0.4176),
  ('wall', 6, 'edge_free_top', 0.4231, 0.5385),
  ('wall', 6, 'edge_joined', 0.09329, 0.1789),
  ('wall', 6, 'edge_unseen', 0.4694, 0.1838),
  ('wall', 6, 'height', 1.179, 0.1874),
  ('wall', 6, 'length', 0.1363, 0.3139),
  ('wall', 6, 'rectangularity', 0.6779, 0.2558),
  ('wall', 6, 'spread_length', -0.2597, 0.2911),
  ('wall', 6, 'spread_width', -1.001, 0.295),
  ('wall', 6, 'tilt_deg', 90, 0.6678),
  ('wall', 6, 'width', -0.7615, 0.4374),
  ('wall', 6, 'z_max', 1.849, 0.3286),
  ('wall', 6, 'z_min', 0.3709, 0.2933);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.1139, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'area_m2', 0.2639, 0.4722),
  ('wall', 7, 'aspect', 1.316, 0.3229),
  ('wall', 7, 'behind', 0.1709, 0.2051),
  ('wall', 7, 'edge_free', 0.2711, 0.3548),
  ('wall', 7, 'edge_free_top', 0.06237, 0.09625),
  ('wall', 7, 'edge_joined', 0.1621, 0.2193),
  ('wall', 7, 'edge_unseen', 0.007896, 0.03),
  ('wall', 7, 'height', 1.405, 0.1226),
  ('wall', 7, 'length', 0.9985, 0.1289),
  ('wall', 7, 'rectangularity', 0.838, 0.1065),
  ('wall', 7, 'spread_length', 0.8696, 0.1855),
  ('wall', 7, 'spread_width', -0.7154, 0.4137),
  ('wall', 7, 'tilt_deg', 90.05, 0.45),
  ('wall', 7, 'width', -0.4297, 0.4271),
  ('wall', 7, 'z_max', 2.855, 0.2502),
  ('wall', 7, 'z_min', 0.009074, 0.06406);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.04989, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'area_m2', -2.656, 0.492),
  ('wall', 8, 'aspect', 0.4519, 0.512),
  ('wall', 8, 'behind', 0.02578, 0.1667),
  ('wall', 8, 'edge_free', 0.1574, 0.1334),
  ('wall', 8, 'edge_free_top', 0.2078, 0.1881),
  ('wall', 8, 'edge_joined', 0.5677, 0.3367),
  ('wall', 8, 'edge_unseen', 0.1149, 0.1778),
  ('wall', 8, 'height', 1.316, 0.8731),
  ('wall', 8, 'length', -0.8657, 0.4264),
  ('wall', 8, 'rectangularity', 0.7808, 0.07844),
  ('wall', 8, 'spread_length', -1.129, 0.355),
  ('wall', 8, 'spread_width', -1.675, 0.08679),
  ('wall', 8, 'tilt_deg', 89.53, 0.7984),
  ('wall', 8, 'width', -1.472, 0.1687),
  ('wall', 8, 'z_max', 1.322, 0.9869),
  ('wall', 8, 'z_min', 1.096, 1.002);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.1116, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'area_m2', -1.549, 1.07),
  ('wall', 9, 'aspect', 0.6128, 0.5258),
  ('wall', 9, 'behind', -0.00837, 0.03),
  ('wall', 9, 'edge_free', -0.0005521, 0.03),
  ('wall', 9, 'edge_free_top', 0.0001879, 0.03),
  ('wall', 9, 'edge_joined', 0.102, 0.1635),
  ('wall', 9, 'edge_unseen', 0.1569, 0.2142),
  ('wall', 9, 'height', 0.3945, 0.3106),
  ('wall', 9, 'length', -0.3436, 0.5115),
  ('wall', 9, 'rectangularity', 0.7655, 0.1638),
  ('wall', 9, 'spread_length', -0.2598, 0.551),
  ('wall', 9, 'spread_width', -1.15, 0.6866),
  ('wall', 9, 'tilt_deg', 88.39, 0.5028),
  ('wall', 9, 'width', -0.9644, 0.6598),
  ('wall', 9, 'z_max', 0.881, 0.4748),
  ('wall', 9, 'z_min', -0.0491, 0.03813);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.1275, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'area_m2', -0.008965, 0.4999),
  ('wall', 10, 'aspect', 0.8769, 0.3805),
  ('wall', 10, 'behind', 0.03837, 0.1249),
  ('wall', 10, 'edge_free', 0.1021, 0.1955),
  ('wall', 10, 'edge_free_top', 0.06833, 0.1326),
  ('wall', 10, 'edge_joined', 0.09014, 0.1234),
  ('wall', 10, 'edge_unseen', 0.3273, 0.1457),
  ('wall', 10, 'height', 1.029, 0.2773),
  ('wall', 10, 'length', 0.6138, 0.3153),
  ('wall', 10, 'rectangularity', 0.6337, 0.1468),
  ('wall', 10, 'spread_length', 0.5288, 0.2883),
  ('wall', 10, 'spread_width', -0.4791, 0.4017),
  ('wall', 10, 'tilt_deg', 76.98, 11.46),
  ('wall', 10, 'width', -0.1584, 0.3763),
  ('wall', 10, 'z_max', 1.581, 0.1774),
  ('wall', 10, 'z_min', 0.2922, 0.329);

-- table: 764 examples
UPDATE object_class SET prior = 0.02745 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.2702, 0.5894)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5529, 0.2732)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5346, 0.2072)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.4317, 0.2221)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_joined', 0.3109, 0.2074)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_unseen', 0.1088, 0.1462)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7302, 0.1184)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.327, 0.31)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.7045, 0.1312)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1842, 0.3152)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4184, 0.3314)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.3861, 0.5828)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2285, 0.3086)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7341, 0.1178)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7266, 0.1186)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'table';
DELETE FROM class_density WHERE class = 'table';
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.1008, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'area_m2', 0.1163, 0.1941),
  ('table', 1, 'aspect', 0.5417, 0.1756),
  ('table', 1, 'behind', 0.7094, 0.05035),
  ('table', 1, 'edge_free', 0.3515, 0.1781),
  ('table', 1, 'edge_free_top', -0.0002069, 0.3162),
  ('table', 1, 'edge_joined', 0.3964, 0.1494),
  ('table', 1, 'edge_unseen', 0.00809, 0.03343),
  ('table', 1, 'height', 0.7387, 0.0232),
  ('table', 1, 'length', 0.5176, 0.1382),
  ('table', 1, 'rectangularity', 0.7052, 0.06673),
  ('table', 1, 'spread_length', 0.3731, 0.1159),
  ('table', 1, 'spread_width', -0.2306, 0.1221),
  ('table', 1, 'tilt_deg', 0.09133, 0.45),
  ('table', 1, 'width', -0.05351, 0.1371),
  ('table', 1, 'z_max', 0.7396, 0.02295),
  ('table', 1, 'z_min', 0.7383, 0.02454);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.1356, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'area_m2', 0.01823, 0.2936),
  ('table', 2, 'aspect', 0.5945, 0.1693),
  ('table', 2, 'behind', 0.5572, 0.1045),
  ('table', 2, 'edge_free', 0.4536, 0.1449),
  ('table', 2, 'edge_free_top', -0.0007427, 0.3157),
  ('table', 2, 'edge_joined', 0.2828, 0.1623),
  ('table', 2, 'edge_unseen', 0.09497, 0.1081),
  ('table', 2, 'height', 0.6772, 0.02854),
  ('table', 2, 'length', 0.5094, 0.1771),
  ('table', 2, 'rectangularity', 0.7017, 0.1302),
  ('table', 2, 'spread_length', 0.3813, 0.2023),
  ('table', 2, 'spread_width', -0.2751, 0.1514),
  ('table', 2, 'tilt_deg', 0.3249, 0.4677),
  ('table', 2, 'width', -0.1114, 0.1571),
  ('table', 2, 'z_max', 0.6774, 0.0273),
  ('table', 2, 'z_min', 0.6687, 0.03155);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.1302, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'area_m2', -0.009646, 0.3594),
  ('table', 3, 'aspect', 0.6117, 0.2532),
  ('table', 3, 'behind', 0.4736, 0.1255),
  ('table', 3, 'edge_free', 0.5136, 0.2513),
  ('table', 3, 'edge_free_top', -0.0007782, 0.3154),
  ('table', 3, 'edge_joined', 0.2312, 0.166),
  ('table', 3, 'edge_unseen', 0.1324, 0.1344),
  ('table', 3, 'height', 0.7708, 0.02271),
  ('table', 3, 'length', 0.5412, 0.235),
  ('table', 3, 'rectangularity', 0.7155, 0.1623),
  ('table', 3, 'spread_length', 0.3211, 0.1847),
  ('table', 3, 'spread_width', -0.3373, 0.2062),
  ('table', 3, 'tilt_deg', 0.2283, 0.45),
  ('table', 3, 'width', -0.1519, 0.199),
  ('table', 3, 'z_max', 0.7765, 0.02674),
  ('table', 3, 'z_min', 0.7676, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.07185, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'area_m2', -0.3105, 0.2596),
  ('table', 4, 'aspect', 0.4137, 0.1759),
  ('table', 4, 'behind', 0.495, 0.2211),
  ('table', 4, 'edge_free', 0.4109, 0.2136),
  ('table', 4, 'edge_free_top', -0.0003471, 0.316),
  ('table', 4, 'edge_joined', 0.2604, 0.1683),
  ('table', 4, 'edge_unseen', 0.2203, 0.1541),
  ('table', 4, 'height', 0.7327, 0.02256),
  ('table', 4, 'length', 0.306, 0.1488),
  ('table', 4, 'rectangularity', 0.6189, 0.1479),
  ('table', 4, 'spread_length', 0.1714, 0.156),
  ('table', 4, 'spread_width', -0.3714, 0.1464),
  ('table', 4, 'tilt_deg', 0.2051, 0.45),
  ('table', 4, 'width', -0.1138, 0.1268),
  ('table', 4, 'z_max', 0.7364, 0.0225),
  ('table', 4, 'z_min', 0.7335, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.1166, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'area_m2', -1.376, 0.5598),
  ('table', 5, 'aspect', 0.772, 0.3539),
  ('table', 5, 'behind', 0.2367, 0.1871),
  ('table', 5, 'edge_free', 0.5311, 0.3112),
  ('table', 5, 'edge_free_top', -0.005947, 0.3108),
  ('table', 5, 'edge_joined', 0.2509, 0.2004),
  ('table', 5, 'edge_unseen', 0.3736, 0.1051),
  ('table', 5, 'height', 0.75, 0.0966),
  ('table', 5, 'length', -0.1267, 0.3322),
  ('table', 5, 'rectangularity', 0.6116, 0.1006),
  ('table', 5, 'spread_length', -0.2432, 0.3697),
  ('table', 5, 'spread_width', -1.019, 0.3228),
  ('table', 5, 'tilt_deg', 1.133, 1.424),
  ('table', 5, 'width', -0.8201, 0.4231),
  ('table', 5, 'z_max', 0.7409, 0.09445),
  ('table', 5, 'z_min', 0.7377, 0.09607);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.06366, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'area_m2', 0.1097, 0.1848),
  ('table', 6, 'aspect', 0.6144, 0.1699),
  ('table', 6, 'behind', 0.4744, 0.1884),
  ('table', 6, 'edge_free', 0.7088, 0.1356),
  ('table', 6, 'edge_free_top', -0.0001154, 0.316),
  ('table', 6, 'edge_joined', 0.1357, 0.08944),
  ('table', 6, 'edge_unseen', 0.0064, 0.03),
  ('table', 6, 'height', 0.7135, 0.02307),
  ('table', 6, 'length', 0.4646, 0.1452),
  ('table', 6, 'rectangularity', 0.8322, 0.08256),
  ('table', 6, 'spread_length', 0.3314, 0.1486),
  ('table', 6, 'spread_width', -0.2919, 0.1048),
  ('table', 6, 'tilt_deg', 0.1157, 0.45),
  ('table', 6, 'width', -0.1655, 0.1233),
  ('table', 6, 'z_max', 0.7151, 0.02375),
  ('table', 6, 'z_min', 0.7125, 0.02395);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.1136, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'area_m2', -0.9231, 0.2689),
  ('table', 7, 'aspect', 0.3887, 0.2115),
  ('table', 7, 'behind', 0.2961, 0.1537),
  ('table', 7, 'edge_free', 0.5041, 0.2283),
  ('table', 7, 'edge_free_top', -0.001611, 0.3139),
  ('table', 7, 'edge_joined', 0.2421, 0.1824),
  ('table', 7, 'edge_unseen', 0.137, 0.1795),
  ('table', 7, 'height', 0.692, 0.0269),
  ('table', 7, 'length', -0.09195, 0.1656),
  ('table', 7, 'rectangularity', 0.7058, 0.1397),
  ('table', 7, 'spread_length', -0.2229, 0.1519),
  ('table', 7, 'spread_width', -0.6815, 0.1571),
  ('table', 7, 'tilt_deg', 0.3356, 0.45),
  ('table', 7, 'width', -0.4804, 0.15),
  ('table', 7, 'z_max', 0.6945, 0.0266),
  ('table', 7, 'z_min', 0.6898, 0.02939);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.07627, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'area_m2', -0.4947, 0.2394),
  ('table', 8, 'aspect', 0.1858, 0.1339),
  ('table', 8, 'behind', 0.6896, 0.1131),
  ('table', 8, 'edge_free', 0.2703, 0.1198),
  ('table', 8, 'edge_free_top', -0.0008775, 0.3157),
  ('table', 8, 'edge_joined', 0.4309, 0.1479),
  ('table', 8, 'edge_unseen', 0.02569, 0.05262),
  ('table', 8, 'height', 0.7343, 0.05424),
  ('table', 8, 'length', 0.03707, 0.126),
  ('table', 8, 'rectangularity', 0.7256, 0.08186),
  ('table', 8, 'spread_length', -0.09547, 0.1194),
  ('table', 8, 'spread_width', -0.3515, 0.1292),
  ('table', 8, 'tilt_deg', 0.1781, 0.45),
  ('table', 8, 'width', -0.1598, 0.1083),
  ('table', 8, 'z_max', 0.7418, 0.06104),
  ('table', 8, 'z_min', 0.7322, 0.06715);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.1182, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'area_m2', -0.05389, 0.3309),
  ('table', 9, 'aspect', 0.4949, 0.1517),
  ('table', 9, 'behind', 0.4081, 0.2179),
  ('table', 9, 'edge_free', 0.2709, 0.1765),
  ('table', 9, 'edge_free_top', -0.003547, 0.3145),
  ('table', 9, 'edge_joined', 0.4929, 0.2192),
  ('table', 9, 'edge_unseen', 0.127, 0.1061),
  ('table', 9, 'height', 0.9475, 0.1328),
  ('table', 9, 'length', 0.4084, 0.2091),
  ('table', 9, 'rectangularity', 0.7093, 0.1278),
  ('table', 9, 'spread_length', 0.263, 0.2183),
  ('table', 9, 'spread_width', -0.2914, 0.2087),
  ('table', 9, 'tilt_deg', 0.403, 0.4517),
  ('table', 9, 'width', -0.1193, 0.1291),
  ('table', 9, 'z_max', 0.9693, 0.1248),
  ('table', 9, 'z_min', 0.9565, 0.1397);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.02324, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'area_m2', -0.6851, 0.593),
  ('table', 10, 'aspect', 0.5204, 0.1578),
  ('table', 10, 'behind', 0.2128, 0.1376),
  ('table', 10, 'edge_free', 0.2768, 0.1194),
  ('table', 10, 'edge_free_top', -0.000318, 0.3161),
  ('table', 10, 'edge_joined', 0.1858, 0.1657),
  ('table', 10, 'edge_unseen', 0.2016, 0.1125),
  ('table', 10, 'height', 0.05173, 0.05569),
  ('table', 10, 'length', 0.1467, 0.3181),
  ('table', 10, 'rectangularity', 0.6153, 0.08406),
  ('table', 10, 'spread_length', 0.02867, 0.3137),
  ('table', 10, 'spread_width', -0.612, 0.3507),
  ('table', 10, 'tilt_deg', 1.326, 0.4922),
  ('table', 10, 'width', -0.3395, 0.3048),
  ('table', 10, 'z_max', 0.03809, 0.03915),
  ('table', 10, 'z_min', 0.02135, 0.04168);

-- flat_screen: 607 examples
UPDATE object_class SET prior = 0.03806 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.861, 0.3787)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.3775, 0.1998)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5883, 0.1343)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.7772, 0.1704)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.9761, 0.0709)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_joined', 0.0711, 0.1084)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_unseen', 0.05664, 0.1109)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.017, 0.09416)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.6277, 0.2464)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.8039, 0.1128)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7736, 0.2043)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.208, 0.1742)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.22, 3.284)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -1.006, 0.2148)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.174, 0.1045)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7826, 0.1315)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'flat_screen';
DELETE FROM class_density WHERE class = 'flat_screen';
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.224, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'area_m2', -1.451, 0.2468),
  ('flat_screen', 1, 'aspect', 0.5582, 0.1629),
  ('flat_screen', 1, 'behind', 0.6227, 0.06994),
  ('flat_screen', 1, 'edge_free', 0.5935, 0.112),
  ('flat_screen', 1, 'edge_free_top', 0.898, 0.1208),
  ('flat_screen', 1, 'edge_joined', 0.1763, 0.1905),
  ('flat_screen', 1, 'edge_unseen', 0.01139, 0.03236),
  ('flat_screen', 1, 'height', 0.9832, 0.05197),
  ('flat_screen', 1, 'length', -0.3523, 0.1919),
  ('flat_screen', 1, 'rectangularity', 0.6901, 0.06587),
  ('flat_screen', 1, 'spread_length', -0.5872, 0.2292),
  ('flat_screen', 1, 'spread_width', -1.106, 0.09497),
  ('flat_screen', 1, 'tilt_deg', 83.78, 2.243),
  ('flat_screen', 1, 'width', -0.8051, 0.1256),
  ('flat_screen', 1, 'z_max', 1.161, 0.09704),
  ('flat_screen', 1, 'z_min', 0.7221, 0.06002);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.1514, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'area_m2', -1.551, 0.0983),
  ('flat_screen', 2, 'aspect', 0.3424, 0.09252),
  ('flat_screen', 2, 'behind', 0.5589, 0.09987),
  ('flat_screen', 2, 'edge_free', 0.7567, 0.08399),
  ('flat_screen', 2, 'edge_free_top', 0.9961, 0.03044),
  ('flat_screen', 2, 'edge_joined', 0.0709, 0.04824),
  ('flat_screen', 2, 'edge_unseen', 0.007414, 0.03053),
  ('flat_screen', 2, 'height', 1.014, 0.04651),
  ('flat_screen', 2, 'length', -0.5284, 0.09598),
  ('flat_screen', 2, 'rectangularity', 0.8303, 0.05932),
  ('flat_screen', 2, 'spread_length', -0.6084, 0.06289),
  ('flat_screen', 2, 'spread_width', -1.074, 0.05197),
  ('flat_screen', 2, 'tilt_deg', 85.41, 2.838),
  ('flat_screen', 2, 'width', -0.8347, 0.07627),
  ('flat_screen', 2, 'z_max', 1.168, 0.0644),
  ('flat_screen', 2, 'z_min', 0.7397, 0.04788);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.08669, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'area_m2', -2.004, 0.1312),
  ('flat_screen', 3, 'aspect', 0.1721, 0.1309),
  ('flat_screen', 3, 'behind', 0.6662, 0.0405),
  ('flat_screen', 3, 'edge_free', 0.7641, 0.07078),
  ('flat_screen', 3, 'edge_free_top', 1.004, 0.03),
  ('flat_screen', 3, 'edge_joined', 0.05604, 0.0346),
  ('flat_screen', 3, 'edge_unseen', 0.003497, 0.03),
  ('flat_screen', 3, 'height', 0.9666, 0.03345),
  ('flat_screen', 3, 'length', -0.8229, 0.1242),
  ('flat_screen', 3, 'rectangularity', 0.8225, 0.05279),
  ('flat_screen', 3, 'spread_length', -0.9208, 0.08471),
  ('flat_screen', 3, 'spread_width', -1.245, 0.0584),
  ('flat_screen', 3, 'tilt_deg', 84.84, 2.473),
  ('flat_screen', 3, 'width', -0.9904, 0.05316),
  ('flat_screen', 3, 'z_max', 1.081, 0.04593),
  ('flat_screen', 3, 'z_min', 0.7122, 0.04211);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.088, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'area_m2', -1.772, 0.1264),
  ('flat_screen', 4, 'aspect', 0.4983, 0.04244),
  ('flat_screen', 4, 'behind', 0.5763, 0.1018),
  ('flat_screen', 4, 'edge_free', 0.9847, 0.03),
  ('flat_screen', 4, 'edge_free_top', 0.9985, 0.03),
  ('flat_screen', 4, 'edge_joined', 0.003525, 0.03),
  ('flat_screen', 4, 'edge_unseen', 0.04157, 0.07761),
  ('flat_screen', 4, 'height', 1.03, 0.04139),
  ('flat_screen', 4, 'length', -0.5992, 0.06911),
  ('flat_screen', 4, 'rectangularity', 0.9314, 0.03139),
  ('flat_screen', 4, 'spread_length', -0.6471, 0.06018),
  ('flat_screen', 4, 'spread_width', -1.144, 0.07727),
  ('flat_screen', 4, 'tilt_deg', 84.93, 3.567),
  ('flat_screen', 4, 'width', -1.1, 0.06852),
  ('flat_screen', 4, 'z_max', 1.189, 0.04466),
  ('flat_screen', 4, 'z_min', 0.8542, 0.04202);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.08846, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'area_m2', -1.835, 0.1229),
  ('flat_screen', 5, 'aspect', 0.3461, 0.1561),
  ('flat_screen', 5, 'behind', 0.5641, 0.1253),
  ('flat_screen', 5, 'edge_free', 0.7203, 0.1214),
  ('flat_screen', 5, 'edge_free_top', 0.998, 0.03),
  ('flat_screen', 5, 'edge_joined', 0.04938, 0.03481),
  ('flat_screen', 5, 'edge_unseen', 0.07271, 0.1041),
  ('flat_screen', 5, 'height', 1.014, 0.0333),
  ('flat_screen', 5, 'length', -0.5963, 0.1292),
  ('flat_screen', 5, 'rectangularity', 0.7297, 0.1031),
  ('flat_screen', 5, 'spread_length', -0.7931, 0.1251),
  ('flat_screen', 5, 'spread_width', -1.222, 0.07194),
  ('flat_screen', 5, 'tilt_deg', 83.93, 2.197),
  ('flat_screen', 5, 'width', -0.9372, 0.06839),
  ('flat_screen', 5, 'z_max', 1.15, 0.03979),
  ('flat_screen', 5, 'z_min', 0.754, 0.03551);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.07299, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'area_m2', -2.23, 0.1512),
  ('flat_screen', 6, 'aspect', 0.2783, 0.17),
  ('flat_screen', 6, 'behind', 0.5677, 0.0975),
  ('flat_screen', 6, 'edge_free', 0.8505, 0.1131),
  ('flat_screen', 6, 'edge_free_top', 0.9966, 0.03),
  ('flat_screen', 6, 'edge_joined', 0.05421, 0.06735),
  ('flat_screen', 6, 'edge_unseen', 0.1237, 0.1355),
  ('flat_screen', 6, 'height', 1.046, 0.042),
  ('flat_screen', 6, 'length', -0.882, 0.1303),
  ('flat_screen', 6, 'rectangularity', 0.8263, 0.05919),
  ('flat_screen', 6, 'spread_length', -1.006, 0.0847),
  ('flat_screen', 6, 'spread_width', -1.312, 0.0585),
  ('flat_screen', 6, 'tilt_deg', 84.74, 2.275),
  ('flat_screen', 6, 'width', -1.15, 0.1206),
  ('flat_screen', 6, 'z_max', 1.181, 0.04357),
  ('flat_screen', 6, 'z_min', 0.844, 0.06137);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.1072, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'area_m2', -1.775, 0.2566),
  ('flat_screen', 7, 'aspect', 0.3955, 0.2083),
  ('flat_screen', 7, 'behind', 0.5057, 0.08361),
  ('flat_screen', 7, 'edge_free', 0.8456, 0.1619),
  ('flat_screen', 7, 'edge_free_top', 0.9981, 0.03),
  ('flat_screen', 7, 'edge_joined', 0.02138, 0.03),
  ('flat_screen', 7, 'edge_unseen', 0.08926, 0.1508),
  ('flat_screen', 7, 'height', 1.242, 0.1152),
  ('flat_screen', 7, 'length', -0.591, 0.1982),
  ('flat_screen', 7, 'rectangularity', 0.8175, 0.1315),
  ('flat_screen', 7, 'spread_length', -0.6821, 0.1249),
  ('flat_screen', 7, 'spread_width', -1.136, 0.08709),
  ('flat_screen', 7, 'tilt_deg', 82.99, 2.23),
  ('flat_screen', 7, 'width', -0.9801, 0.1913),
  ('flat_screen', 7, 'z_max', 1.406, 0.09695),
  ('flat_screen', 7, 'z_min', 1.049, 0.1325);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.03648, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'area_m2', -1.825, 0.4792),
  ('flat_screen', 8, 'aspect', 0.5999, 0.1472),
  ('flat_screen', 8, 'behind', 0.5233, 0.1782),
  ('flat_screen', 8, 'edge_free', 0.5852, 0.1454),
  ('flat_screen', 8, 'edge_free_top', 0.8789, 0.1675),
  ('flat_screen', 8, 'edge_joined', 0.201, 0.2185),
  ('flat_screen', 8, 'edge_unseen', 0.07377, 0.1104),
  ('flat_screen', 8, 'height', 0.8998, 0.3329),
  ('flat_screen', 8, 'length', -0.5331, 0.348),
  ('flat_screen', 8, 'rectangularity', 0.7287, 0.2355),
  ('flat_screen', 8, 'spread_length', -0.7761, 0.1772),
  ('flat_screen', 8, 'spread_width', -1.202, 0.2745),
  ('flat_screen', 8, 'tilt_deg', 84.8, 1.684),
  ('flat_screen', 8, 'width', -0.9552, 0.3978),
  ('flat_screen', 8, 'z_max', 1.09, 0.6034),
  ('flat_screen', 8, 'z_min', 0.5477, 0.3943);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.04858, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'area_m2', -2.185, 0.1229),
  ('flat_screen', 9, 'aspect', 0.391, 0.1018),
  ('flat_screen', 9, 'behind', 0.5845, 0.08966),
  ('flat_screen', 9, 'edge_free', 0.9903, 0.03),
  ('flat_screen', 9, 'edge_free_top', 0.9994, 0.03),
  ('flat_screen', 9, 'edge_joined', 0.002126, 0.03),
  ('flat_screen', 9, 'edge_unseen', 0.02361, 0.0546),
  ('flat_screen', 9, 'height', 0.9872, 0.04872),
  ('flat_screen', 9, 'length', -0.8686, 0.1002),
  ('flat_screen', 9, 'rectangularity', 0.9408, 0.0305),
  ('flat_screen', 9, 'spread_length', -0.9067, 0.1075),
  ('flat_screen', 9, 'spread_width', -1.281, 0.04886),
  ('flat_screen', 9, 'tilt_deg', 83.99, 3.175),
  ('flat_screen', 9, 'width', -1.252, 0.06228),
  ('flat_screen', 9, 'z_max', 1.123, 0.05661),
  ('flat_screen', 9, 'z_min', 0.8391, 0.05023);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.04624, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'area_m2', -2.688, 0.4309),
  ('flat_screen', 10, 'aspect', 0.6368, 0.2902),
  ('flat_screen', 10, 'behind', 0.5699, 0.1835),
  ('flat_screen', 10, 'edge_free', 0.8346, 0.1874),
  ('flat_screen', 10, 'edge_free_top', 0.9995, 0.03),
  ('flat_screen', 10, 'edge_joined', 0.02863, 0.05454),
  ('flat_screen', 10, 'edge_unseen', 0.2881, 0.09499),
  ('flat_screen', 10, 'height', 1.047, 0.04773),
  ('flat_screen', 10, 'length', -0.8572, 0.2736),
  ('flat_screen', 10, 'rectangularity', 0.7213, 0.1106),
  ('flat_screen', 10, 'spread_length', -0.9932, 0.172),
  ('flat_screen', 10, 'spread_width', -1.722, 0.245),
  ('flat_screen', 10, 'tilt_deg', 83.96, 1.983),
  ('flat_screen', 10, 'width', -1.459, 0.2836),
  ('flat_screen', 10, 'z_max', 1.135, 0.05368),
  ('flat_screen', 10, 'z_min', 0.8388, 0.06756);

-- keyboard: 393 examples
UPDATE object_class SET prior = 0.05693 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.748, 0.367)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7581, 0.3038)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.249, 0.1617)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.2523, 0.2058)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_joined', 0.7002, 0.223)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_unseen', 0.03885, 0.09482)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7615, 0.1224)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.8897, 0.2773)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8158, 0.0797)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9757, 0.2731)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.825, 0.126)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.281, 2.015)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.649, 0.2056)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.768, 0.1226)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7555, 0.1227)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'keyboard';
DELETE FROM class_density WHERE class = 'keyboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1443, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'area_m2', -2.313, 0.1037),
  ('keyboard', 1, 'aspect', 0.7479, 0.1649),
  ('keyboard', 1, 'behind', 0.2521, 0.08996),
  ('keyboard', 1, 'edge_free', 0.231, 0.1557),
  ('keyboard', 1, 'edge_free_top', -0.003204, 0.3133),
  ('keyboard', 1, 'edge_joined', 0.7703, 0.1452),
  ('keyboard', 1, 'edge_unseen', 0.002377, 0.03),
  ('keyboard', 1, 'height', 0.7452, 0.03968),
  ('keyboard', 1, 'length', -0.6379, 0.1195),
  ('keyboard', 1, 'rectangularity', 0.7563, 0.04424),
  ('keyboard', 1, 'spread_length', -0.7689, 0.07645),
  ('keyboard', 1, 'spread_width', -1.743, 0.07367),
  ('keyboard', 1, 'tilt_deg', 3.207, 1.137),
  ('keyboard', 1, 'width', -1.389, 0.1125),
  ('keyboard', 1, 'z_max', 0.7466, 0.03822),
  ('keyboard', 1, 'z_min', 0.7397, 0.0498);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.1508, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'area_m2', -2.739, 0.1098),
  ('keyboard', 2, 'aspect', 1.05, 0.08712),
  ('keyboard', 2, 'behind', 0.2115, 0.1048),
  ('keyboard', 2, 'edge_free', 0.365, 0.1449),
  ('keyboard', 2, 'edge_free_top', -0.009802, 0.3033),
  ('keyboard', 2, 'edge_joined', 0.5968, 0.1306),
  ('keyboard', 2, 'edge_unseen', 0.003471, 0.03),
  ('keyboard', 2, 'height', 0.7501, 0.06353),
  ('keyboard', 2, 'length', -0.7695, 0.08643),
  ('keyboard', 2, 'rectangularity', 0.8865, 0.04874),
  ('keyboard', 2, 'spread_length', -0.8201, 0.04887),
  ('keyboard', 2, 'spread_width', -1.899, 0.07246),
  ('keyboard', 2, 'tilt_deg', 4.538, 1.658),
  ('keyboard', 2, 'width', -1.826, 0.07726),
  ('keyboard', 2, 'z_max', 0.757, 0.06579),
  ('keyboard', 2, 'z_min', 0.7496, 0.0619);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.1157, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'area_m2', -2.634, 0.07835),
  ('keyboard', 3, 'aspect', 0.96, 0.09403),
  ('keyboard', 3, 'behind', 0.2715, 0.1268),
  ('keyboard', 3, 'edge_free', 0.06962, 0.07196),
  ('keyboard', 3, 'edge_free_top', -0.001526, 0.3144),
  ('keyboard', 3, 'edge_joined', 0.9093, 0.07762),
  ('keyboard', 3, 'edge_unseen', 0.005303, 0.03071),
  ('keyboard', 3, 'height', 0.758, 0.0338),
  ('keyboard', 3, 'length', -0.7528, 0.07304),
  ('keyboard', 3, 'rectangularity', 0.8462, 0.05922),
  ('keyboard', 3, 'spread_length', -0.8145, 0.04147),
  ('keyboard', 3, 'spread_width', -1.835, 0.07422),
  ('keyboard', 3, 'tilt_deg', 2.186, 1.07),
  ('keyboard', 3, 'width', -1.703, 0.08194),
  ('keyboard', 3, 'z_max', 0.7641, 0.03359),
  ('keyboard', 3, 'z_min', 0.7582, 0.0332);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.1206, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'area_m2', -2.573, 0.07512),
  ('keyboard', 4, 'aspect', 0.8454, 0.0803),
  ('keyboard', 4, 'behind', 0.2244, 0.1007),
  ('keyboard', 4, 'edge_free', 0.4778, 0.0842),
  ('keyboard', 4, 'edge_free_top', -0.00472, 0.3063),
  ('keyboard', 4, 'edge_joined', 0.4886, 0.09004),
  ('keyboard', 4, 'edge_unseen', 0.001446, 0.03035),
  ('keyboard', 4, 'height', 0.7662, 0.03047),
  ('keyboard', 4, 'length', -0.7739, 0.06502),
  ('keyboard', 4, 'rectangularity', 0.8359, 0.03655),
  ('keyboard', 4, 'spread_length', -0.8381, 0.06148),
  ('keyboard', 4, 'spread_width', -1.77, 0.06572),
  ('keyboard', 4, 'tilt_deg', 4.831, 1.339),
  ('keyboard', 4, 'width', -1.616, 0.05486),
  ('keyboard', 4, 'z_max', 0.7769, 0.03025),
  ('keyboard', 4, 'z_min', 0.7604, 0.03327);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.09464, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'area_m2', -2.885, 0.1906),
  ('keyboard', 5, 'aspect', 0.5428, 0.1939),
  ('keyboard', 5, 'behind', 0.2549, 0.09005),
  ('keyboard', 5, 'edge_free', 0.3684, 0.1017),
  ('keyboard', 5, 'edge_free_top', -0.005004, 0.3102),
  ('keyboard', 5, 'edge_joined', 0.5395, 0.1282),
  ('keyboard', 5, 'edge_unseen', 0.002881, 0.03179),
  ('keyboard', 5, 'height', 0.7607, 0.04981),
  ('keyboard', 5, 'length', -1.092, 0.1085),
  ('keyboard', 5, 'rectangularity', 0.8054, 0.06601),
  ('keyboard', 5, 'spread_length', -1.159, 0.06374),
  ('keyboard', 5, 'spread_width', -1.789, 0.07515),
  ('keyboard', 5, 'tilt_deg', 5.456, 1.176),
  ('keyboard', 5, 'width', -1.591, 0.2077),
  ('keyboard', 5, 'z_max', 0.765, 0.04333),
  ('keyboard', 5, 'z_min', 0.7552, 0.05355);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.09105, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'area_m2', -2.924, 0.1565),
  ('keyboard', 6, 'aspect', 0.6867, 0.1667),
  ('keyboard', 6, 'behind', 0.2817, 0.08357),
  ('keyboard', 6, 'edge_free', 0.0139, 0.03),
  ('keyboard', 6, 'edge_free_top', -7.012e-05, 0.3171),
  ('keyboard', 6, 'edge_joined', 0.9785, 0.03724),
  ('keyboard', 6, 'edge_unseen', 0.0572, 0.109),
  ('keyboard', 6, 'height', 0.7661, 0.04799),
  ('keyboard', 6, 'length', -1.029, 0.1495),
  ('keyboard', 6, 'rectangularity', 0.847, 0.04548),
  ('keyboard', 6, 'spread_length', -1.09, 0.08092),
  ('keyboard', 6, 'spread_width', -1.82, 0.07091),
  ('keyboard', 6, 'tilt_deg', 1.679, 0.45),
  ('keyboard', 6, 'width', -1.697, 0.1206),
  ('keyboard', 6, 'z_max', 0.7604, 0.04311),
  ('keyboard', 6, 'z_min', 0.7656, 0.05567);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.07669, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'area_m2', -3.502, 0.3258),
  ('keyboard', 7, 'aspect', 0.2832, 0.1608),
  ('keyboard', 7, 'behind', 0.3131, 0.1169),
  ('keyboard', 7, 'edge_free', 0.2002, 0.1359),
  ('keyboard', 7, 'edge_free_top', -0.003741, 0.3177),
  ('keyboard', 7, 'edge_joined', 0.6237, 0.2354),
  ('keyboard', 7, 'edge_unseen', 0.1973, 0.0791),
  ('keyboard', 7, 'height', 0.7634, 0.04384),
  ('keyboard', 7, 'length', -1.494, 0.1576),
  ('keyboard', 7, 'rectangularity', 0.7656, 0.06238),
  ('keyboard', 7, 'spread_length', -1.588, 0.07641),
  ('keyboard', 7, 'spread_width', -1.963, 0.1586),
  ('keyboard', 7, 'tilt_deg', 3.876, 0.9896),
  ('keyboard', 7, 'width', -1.762, 0.1917),
  ('keyboard', 7, 'z_max', 0.7532, 0.03513),
  ('keyboard', 7, 'z_min', 0.7733, 0.04081);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.07614, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'area_m2', -2.901, 0.2672),
  ('keyboard', 8, 'aspect', 0.8769, 0.1881),
  ('keyboard', 8, 'behind', 0.1594, 0.1522),
  ('keyboard', 8, 'edge_free', 0.2493, 0.2069),
  ('keyboard', 8, 'edge_free_top', -0.01531, 0.3061),
  ('keyboard', 8, 'edge_joined', 0.7103, 0.2162),
  ('keyboard', 8, 'edge_unseen', 0.1054, 0.1175),
  ('keyboard', 8, 'height', 0.9657, 0.1499),
  ('keyboard', 8, 'length', -0.9154, 0.1968),
  ('keyboard', 8, 'rectangularity', 0.8607, 0.09623),
  ('keyboard', 8, 'spread_length', -0.9776, 0.1925),
  ('keyboard', 8, 'spread_width', -1.879, 0.07714),
  ('keyboard', 8, 'tilt_deg', 3.826, 1.353),
  ('keyboard', 8, 'width', -1.793, 0.08841),
  ('keyboard', 8, 'z_max', 0.9825, 0.1226),
  ('keyboard', 8, 'z_min', 1.01, 0.11);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.05193, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'area_m2', -2.647, 0.1434),
  ('keyboard', 9, 'aspect', 0.4446, 0.1949),
  ('keyboard', 9, 'behind', 0.2048, 0.09596),
  ('keyboard', 9, 'edge_free', 0.1771, 0.08075),
  ('keyboard', 9, 'edge_free_top', -0.001409, 0.3166),
  ('keyboard', 9, 'edge_joined', 0.7693, 0.07389),
  ('keyboard', 9, 'edge_unseen', 0.1171, 0.117),
  ('keyboard', 9, 'height', 0.7566, 0.03621),
  ('keyboard', 9, 'length', -0.9437, 0.1368),
  ('keyboard', 9, 'rectangularity', 0.7443, 0.06346),
  ('keyboard', 9, 'spread_length', -1.129, 0.1465),
  ('keyboard', 9, 'spread_width', -1.76, 0.07018),
  ('keyboard', 9, 'tilt_deg', 2.675, 0.6669),
  ('keyboard', 9, 'width', -1.403, 0.1164),
  ('keyboard', 9, 'z_max', 0.7595, 0.03351),
  ('keyboard', 9, 'z_min', 0.7523, 0.03976);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.02815, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'area_m2', -2.948, 0.3807),
  ('keyboard', 10, 'aspect', 1.004, 0.4361),
  ('keyboard', 10, 'behind', 0.1111, 0.0967),
  ('keyboard', 10, 'edge_free', 0.1386, 0.1557),
  ('keyboard', 10, 'edge_free_top', -0.001613, 0.3203),
  ('keyboard', 10, 'edge_joined', 0.8527, 0.1452),
  ('keyboard', 10, 'edge_unseen', 0.1217, 0.167),
  ('keyboard', 10, 'height', 0.1306, 0.08816),
  ('keyboard', 10, 'length', -0.9252, 0.3316),
  ('keyboard', 10, 'rectangularity', 0.9115, 0.04497),
  ('keyboard', 10, 'spread_length', -0.9591, 0.3979),
  ('keyboard', 10, 'spread_width', -1.959, 0.04402),
  ('keyboard', 10, 'tilt_deg', 2.471, 1.138),
  ('keyboard', 10, 'width', -1.906, 0.05891),
  ('keyboard', 10, 'z_max', 0.1199, 0.08743),
  ('keyboard', 10, 'z_min', 0.1275, 0.08306);

-- chair_seat: 471 examples
UPDATE object_class SET prior = 0.008922 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -1.976, 0.4766)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.2769, 0.2752)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6667, 0.1565)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.6261, 0.1954)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_joined', 0.08577, 0.1063)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_unseen', 0.04417, 0.105)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4691, 0.03002)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.6974, 0.1625)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7514, 0.1289)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7604, 0.1573)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.178, 0.3359)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 0.625, 0.7077)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -0.9739, 0.3146)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4716, 0.03011)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4669, 0.03021)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_seat';
DELETE FROM class_density WHERE class = 'chair_seat';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.1409, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'area_m2', -1.621, 0.1064),
  ('chair_seat', 1, 'aspect', 0.1214, 0.07826),
  ('chair_seat', 1, 'behind', 0.6966, 0.09398),
  ('chair_seat', 1, 'edge_free', 0.7831, 0.1103),
  ('chair_seat', 1, 'edge_free_top', -0.0003726, 0.3154),
  ('chair_seat', 1, 'edge_joined', 0.05946, 0.07422),
  ('chair_seat', 1, 'edge_unseen', 0.006744, 0.03091),
  ('chair_seat', 1, 'height', 0.4452, 0.0225),
  ('chair_seat', 1, 'length', -0.6701, 0.07841),
  ('chair_seat', 1, 'rectangularity', 0.8494, 0.06826),
  ('chair_seat', 1, 'spread_length', -0.7243, 0.05617),
  ('chair_seat', 1, 'spread_width', -0.9211, 0.07271),
  ('chair_seat', 1, 'tilt_deg', 0.391, 0.4614),
  ('chair_seat', 1, 'width', -0.7873, 0.0719),
  ('chair_seat', 1, 'z_max', 0.4501, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4457, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.1297, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'area_m2', -1.61, 0.1306),
  ('chair_seat', 2, 'aspect', 0.1236, 0.1015),
  ('chair_seat', 2, 'behind', 0.6594, 0.08193),
  ('chair_seat', 2, 'edge_free', 0.7664, 0.117),
  ('chair_seat', 2, 'edge_free_top', -0.0002704, 0.3157),
  ('chair_seat', 2, 'edge_joined', 0.05778, 0.07173),
  ('chair_seat', 2, 'edge_unseen', 0.002647, 0.03195),
  ('chair_seat', 2, 'height', 0.4938, 0.0225),
  ('chair_seat', 2, 'length', -0.6569, 0.09423),
  ('chair_seat', 2, 'rectangularity', 0.8367, 0.06083),
  ('chair_seat', 2, 'spread_length', -0.718, 0.06418),
  ('chair_seat', 2, 'spread_width', -0.9219, 0.08582),
  ('chair_seat', 2, 'tilt_deg', 0.4386, 0.4686),
  ('chair_seat', 2, 'width', -0.7833, 0.07628),
  ('chair_seat', 2, 'z_max', 0.4932, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4896, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.1235, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'area_m2', -1.811, 0.157),
  ('chair_seat', 3, 'aspect', 0.2131, 0.1931),
  ('chair_seat', 3, 'behind', 0.7176, 0.09089),
  ('chair_seat', 3, 'edge_free', 0.4939, 0.09718),
  ('chair_seat', 3, 'edge_free_top', -0.0007532, 0.3152),
  ('chair_seat', 3, 'edge_joined', 0.1971, 0.1143),
  ('chair_seat', 3, 'edge_unseen', 0.003098, 0.03),
  ('chair_seat', 3, 'height', 0.462, 0.0225),
  ('chair_seat', 3, 'length', -0.6341, 0.1324),
  ('chair_seat', 3, 'rectangularity', 0.728, 0.08878),
  ('chair_seat', 3, 'spread_length', -0.6965, 0.06186),
  ('chair_seat', 3, 'spread_width', -1.036, 0.09683),
  ('chair_seat', 3, 'tilt_deg', 0.3935, 0.45),
  ('chair_seat', 3, 'width', -0.8393, 0.1205),
  ('chair_seat', 3, 'z_max', 0.4639, 0.0225),
  ('chair_seat', 3, 'z_min', 0.4617, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.146, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'area_m2', -2.033, 0.232),
  ('chair_seat', 4, 'aspect', 0.1979, 0.1524),
  ('chair_seat', 4, 'behind', 0.6642, 0.08517),
  ('chair_seat', 4, 'edge_free', 0.5653, 0.1364),
  ('chair_seat', 4, 'edge_free_top', -0.0005518, 0.3156),
  ('chair_seat', 4, 'edge_joined', 0.06904, 0.08597),
  ('chair_seat', 4, 'edge_unseen', 0.06599, 0.09569),
  ('chair_seat', 4, 'height', 0.4991, 0.0225),
  ('chair_seat', 4, 'length', -0.683, 0.1252),
  ('chair_seat', 4, 'rectangularity', 0.6523, 0.09762),
  ('chair_seat', 4, 'spread_length', -0.7229, 0.1237),
  ('chair_seat', 4, 'spread_width', -1.2, 0.1234),
  ('chair_seat', 4, 'tilt_deg', 0.5314, 0.4988),
  ('chair_seat', 4, 'width', -0.8904, 0.1055),
  ('chair_seat', 4, 'z_max', 0.5036, 0.0225),
  ('chair_seat', 4, 'z_min', 0.4988, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.1409, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'area_m2', -2.582, 0.2716),
  ('chair_seat', 5, 'aspect', 0.7753, 0.2203),
  ('chair_seat', 5, 'behind', 0.7338, 0.07851),
  ('chair_seat', 5, 'edge_free', 0.4219, 0.173),
  ('chair_seat', 5, 'edge_free_top', -0.001595, 0.3157),
  ('chair_seat', 5, 'edge_joined', 0.07381, 0.08076),
  ('chair_seat', 5, 'edge_unseen', 0.009289, 0.03084),
  ('chair_seat', 5, 'height', 0.4745, 0.02575),
  ('chair_seat', 5, 'length', -0.7235, 0.1089),
  ('chair_seat', 5, 'rectangularity', 0.712, 0.1051),
  ('chair_seat', 5, 'spread_length', -0.7606, 0.0899),
  ('chair_seat', 5, 'spread_width', -1.731, 0.2201),
  ('chair_seat', 5, 'tilt_deg', 1.054, 0.951),
  ('chair_seat', 5, 'width', -1.496, 0.2572),
  ('chair_seat', 5, 'z_max', 0.4837, 0.0225),
  ('chair_seat', 5, 'z_min', 0.4791, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.1431, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'area_m2', -2.509, 0.4126),
  ('chair_seat', 6, 'aspect', 0.5476, 0.2646),
  ('chair_seat', 6, 'behind', 0.4122, 0.2948),
  ('chair_seat', 6, 'edge_free', 0.5661, 0.2044),
  ('chair_seat', 6, 'edge_free_top', -0.001482, 0.315),
  ('chair_seat', 6, 'edge_joined', 0.1063, 0.1203),
  ('chair_seat', 6, 'edge_unseen', 0.2312, 0.1986),
  ('chair_seat', 6, 'height', 0.4784, 0.02753),
  ('chair_seat', 6, 'length', -0.8029, 0.2202),
  ('chair_seat', 6, 'rectangularity', 0.7002, 0.1282),
  ('chair_seat', 6, 'spread_length', -0.8765, 0.251),
  ('chair_seat', 6, 'spread_width', -1.56, 0.2682),
  ('chair_seat', 6, 'tilt_deg', 0.8341, 0.5803),
  ('chair_seat', 6, 'width', -1.333, 0.216),
  ('chair_seat', 6, 'z_max', 0.4848, 0.02485),
  ('chair_seat', 6, 'z_min', 0.4782, 0.02748);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.0531, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'area_m2', -2.123, 0.1884),
  ('chair_seat', 7, 'aspect', 0.1051, 0.07214),
  ('chair_seat', 7, 'behind', 0.7055, 0.1203),
  ('chair_seat', 7, 'edge_free', 0.5986, 0.08357),
  ('chair_seat', 7, 'edge_free_top', -1.513e-06, 0.3161),
  ('chair_seat', 7, 'edge_joined', 0.02489, 0.03007),
  ('chair_seat', 7, 'edge_unseen', 0.04603, 0.09161),
  ('chair_seat', 7, 'height', 0.4432, 0.0225),
  ('chair_seat', 7, 'length', -0.7374, 0.06101),
  ('chair_seat', 7, 'rectangularity', 0.5911, 0.09125),
  ('chair_seat', 7, 'spread_length', -0.7235, 0.09034),
  ('chair_seat', 7, 'spread_width', -1.195, 0.08286),
  ('chair_seat', 7, 'tilt_deg', 0.5096, 0.5391),
  ('chair_seat', 7, 'width', -0.8475, 0.06739),
  ('chair_seat', 7, 'z_max', 0.4445, 0.0225),
  ('chair_seat', 7, 'z_min', 0.4406, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.04697, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'area_m2', -3.228, 0.3852),
  ('chair_seat', 8, 'aspect', 0.5038, 0.2297),
  ('chair_seat', 8, 'behind', 0.3656, 0.3635),
  ('chair_seat', 8, 'edge_free', 0.4636, 0.1885),
  ('chair_seat', 8, 'edge_free_top', -0.0031, 0.3134),
  ('chair_seat', 8, 'edge_joined', 0.01369, 0.03),
  ('chair_seat', 8, 'edge_unseen', 0.1833, 0.1711),
  ('chair_seat', 8, 'height', 0.4339, 0.1452),
  ('chair_seat', 8, 'length', -1.128, 0.2515),
  ('chair_seat', 8, 'rectangularity', 0.6726, 0.06456),
  ('chair_seat', 8, 'spread_length', -1.276, 0.3223),
  ('chair_seat', 8, 'spread_width', -1.922, 0.1446),
  ('chair_seat', 8, 'tilt_deg', 2.81, 2.055),
  ('chair_seat', 8, 'width', -1.674, 0.1662),
  ('chair_seat', 8, 'z_max', 0.4465, 0.1233),
  ('chair_seat', 8, 'z_min', 0.4448, 0.1213);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.0258, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'area_m2', -1.645, 0.4797),
  ('chair_seat', 9, 'aspect', 0.5143, 0.2124),
  ('chair_seat', 9, 'behind', 0.7401, 0.1147),
  ('chair_seat', 9, 'edge_free', 0.5847, 0.08407),
  ('chair_seat', 9, 'edge_free_top', -1.772e-06, 0.3162),
  ('chair_seat', 9, 'edge_joined', 0.009701, 0.03),
  ('chair_seat', 9, 'edge_unseen', 0.0353, 0.06103),
  ('chair_seat', 9, 'height', 0.4396, 0.0225),
  ('chair_seat', 9, 'length', -0.4339, 0.3224),
  ('chair_seat', 9, 'rectangularity', 0.7794, 0.08379),
  ('chair_seat', 9, 'spread_length', -0.5649, 0.3198),
  ('chair_seat', 9, 'spread_width', -1.121, 0.1822),
  ('chair_seat', 9, 'tilt_deg', 0.5599, 0.45),
  ('chair_seat', 9, 'width', -0.9591, 0.1885),
  ('chair_seat', 9, 'z_max', 0.4435, 0.0225),
  ('chair_seat', 9, 'z_min', 0.4372, 0.0225);

-- chair_back: 510 examples
UPDATE object_class SET prior = 0.04628 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.701, 0.5427)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3765, 0.2706)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.5891, 0.2773)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.7892, 0.1961)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9459, 0.1627)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_joined', 0.1234, 0.1645)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_unseen', 0.06879, 0.15)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8146, 0.07837)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5275, 0.26)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7774, 0.1224)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6962, 0.2191)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.107, 0.3563)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.49, 3.834)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9067, 0.3011)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.025, 0.08909)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4409, 0.156)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_back';
DELETE FROM class_density WHERE class = 'chair_back';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1063, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'area_m2', -1.371, 0.125),
  ('chair_back', 1, 'aspect', 0.155, 0.07802),
  ('chair_back', 1, 'behind', 0.7494, 0.06868),
  ('chair_back', 1, 'edge_free', 0.8843, 0.0819),
  ('chair_back', 1, 'edge_free_top', 0.9989, 0.03115),
  ('chair_back', 1, 'edge_joined', 0.03684, 0.05013),
  ('chair_back', 1, 'edge_unseen', 0.00344, 0.03217),
  ('chair_back', 1, 'height', 0.7894, 0.07377),
  ('chair_back', 1, 'length', -0.5319, 0.09145),
  ('chair_back', 1, 'rectangularity', 0.8985, 0.03242),
  ('chair_back', 1, 'spread_length', -0.692, 0.05404),
  ('chair_back', 1, 'spread_width', -0.818, 0.08743),
  ('chair_back', 1, 'tilt_deg', 81.2, 2.636),
  ('chair_back', 1, 'width', -0.6891, 0.08137),
  ('chair_back', 1, 'z_max', 1.01, 0.09315),
  ('chair_back', 1, 'z_min', 0.4291, 0.103);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.1537, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'area_m2', -1.745, 0.1755),
  ('chair_back', 2, 'aspect', 0.1517, 0.131),
  ('chair_back', 2, 'behind', 0.4071, 0.3832),
  ('chair_back', 2, 'edge_free', 0.7981, 0.1546),
  ('chair_back', 2, 'edge_free_top', 0.9985, 0.0304),
  ('chair_back', 2, 'edge_joined', 0.1261, 0.1706),
  ('chair_back', 2, 'edge_unseen', 0.08282, 0.1152),
  ('chair_back', 2, 'height', 0.7875, 0.05623),
  ('chair_back', 2, 'length', -0.6867, 0.08751),
  ('chair_back', 2, 'rectangularity', 0.8445, 0.1018),
  ('chair_back', 2, 'spread_length', -0.7617, 0.04341),
  ('chair_back', 2, 'spread_width', -1.025, 0.1432),
  ('chair_back', 2, 'tilt_deg', 80.64, 2.754),
  ('chair_back', 2, 'width', -0.8688, 0.09633),
  ('chair_back', 2, 'z_max', 0.9439, 0.04776),
  ('chair_back', 2, 'z_min', 0.4905, 0.09226);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.1095, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'area_m2', -1.396, 0.1783),
  ('chair_back', 3, 'aspect', 0.2246, 0.1498),
  ('chair_back', 3, 'behind', 0.749, 0.1015),
  ('chair_back', 3, 'edge_free', 0.5426, 0.1049),
  ('chair_back', 3, 'edge_free_top', 0.8264, 0.2331),
  ('chair_back', 3, 'edge_joined', 0.3802, 0.1839),
  ('chair_back', 3, 'edge_unseen', 0.002561, 0.03114),
  ('chair_back', 3, 'height', 0.8085, 0.05282),
  ('chair_back', 3, 'length', -0.4883, 0.1271),
  ('chair_back', 3, 'rectangularity', 0.8094, 0.0681),
  ('chair_back', 3, 'spread_length', -0.651, 0.1064),
  ('chair_back', 3, 'spread_width', -0.8105, 0.07662),
  ('chair_back', 3, 'tilt_deg', 79.53, 2.709),
  ('chair_back', 3, 'width', -0.699, 0.1075),
  ('chair_back', 3, 'z_max', 1.022, 0.06014),
  ('chair_back', 3, 'z_min', 0.4044, 0.05022);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.1102, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'area_m2', -1.888, 0.1854),
  ('chair_back', 4, 'aspect', 0.6574, 0.2415),
  ('chair_back', 4, 'behind', 0.7555, 0.07208),
  ('chair_back', 4, 'edge_free', 0.7673, 0.1196),
  ('chair_back', 4, 'edge_free_top', 0.9904, 0.0322),
  ('chair_back', 4, 'edge_joined', 0.1276, 0.08392),
  ('chair_back', 4, 'edge_unseen', 0.001153, 0.03),
  ('chair_back', 4, 'height', 0.7997, 0.07059),
  ('chair_back', 4, 'length', -0.473, 0.1313),
  ('chair_back', 4, 'rectangularity', 0.7437, 0.1263),
  ('chair_back', 4, 'spread_length', -0.6361, 0.109),
  ('chair_back', 4, 'spread_width', -1.405, 0.1407),
  ('chair_back', 4, 'tilt_deg', 80.42, 2.559),
  ('chair_back', 4, 'width', -1.107, 0.1537),
  ('chair_back', 4, 'z_max', 1.036, 0.09684),
  ('chair_back', 4, 'z_min', 0.4142, 0.07481);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.1066, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'area_m2', -1.19, 0.1505),
  ('chair_back', 5, 'aspect', 0.4519, 0.1151),
  ('chair_back', 5, 'behind', 0.5041, 0.2642),
  ('chair_back', 5, 'edge_free', 0.9849, 0.03011),
  ('chair_back', 5, 'edge_free_top', 0.9979, 0.03027),
  ('chair_back', 5, 'edge_joined', 0.01104, 0.03045),
  ('chair_back', 5, 'edge_unseen', 0.01611, 0.04419),
  ('chair_back', 5, 'height', 0.8204, 0.04953),
  ('chair_back', 5, 'length', -0.3061, 0.1018),
  ('chair_back', 5, 'rectangularity', 0.8742, 0.06292),
  ('chair_back', 5, 'spread_length', -0.4918, 0.06387),
  ('chair_back', 5, 'spread_width', -0.8623, 0.1356),
  ('chair_back', 5, 'tilt_deg', 80.71, 3.115),
  ('chair_back', 5, 'width', -0.7471, 0.08954),
  ('chair_back', 5, 'z_max', 1.07, 0.05905),
  ('chair_back', 5, 'z_min', 0.3425, 0.05737);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.09152, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'area_m2', -1.46, 0.1296),
  ('chair_back', 6, 'aspect', 0.5374, 0.1333),
  ('chair_back', 6, 'behind', 0.4407, 0.2767),
  ('chair_back', 6, 'edge_free', 0.8511, 0.09559),
  ('chair_back', 6, 'edge_free_top', 0.9958, 0.03),
  ('chair_back', 6, 'edge_joined', 0.1056, 0.098),
  ('chair_back', 6, 'edge_unseen', 0.1009, 0.1376),
  ('chair_back', 6, 'height', 0.8581, 0.04356),
  ('chair_back', 6, 'length', -0.3086, 0.09789),
  ('chair_back', 6, 'rectangularity', 0.7385, 0.08945),
  ('chair_back', 6, 'spread_length', -0.5468, 0.07382),
  ('chair_back', 6, 'spread_width', -1.132, 0.1741),
  ('chair_back', 6, 'tilt_deg', 80.57, 2.558),
  ('chair_back', 6, 'width', -0.8407, 0.1011),
  ('chair_back', 6, 'z_max', 1.101, 0.04989),
  ('chair_back', 6, 'z_min', 0.3776, 0.07109);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.06808, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'area_m2', -2.711, 0.4884),
  ('chair_back', 7, 'aspect', 0.3528, 0.2253),
  ('chair_back', 7, 'behind', 0.0626, 0.157),
  ('chair_back', 7, 'edge_free', 0.9732, 0.08228),
  ('chair_back', 7, 'edge_free_top', 0.9972, 0.0306),
  ('chair_back', 7, 'edge_joined', 0.01569, 0.06107),
  ('chair_back', 7, 'edge_unseen', 0.4773, 0.142),
  ('chair_back', 7, 'height', 0.8371, 0.2921),
  ('chair_back', 7, 'length', -0.8746, 0.2437),
  ('chair_back', 7, 'rectangularity', 0.6149, 0.06845),
  ('chair_back', 7, 'spread_length', -1.115, 0.2344),
  ('chair_back', 7, 'spread_width', -1.654, 0.2952),
  ('chair_back', 7, 'tilt_deg', 80.5, 2.348),
  ('chair_back', 7, 'width', -1.345, 0.3153),
  ('chair_back', 7, 'z_max', 1.009, 0.1005),
  ('chair_back', 7, 'z_min', 0.5909, 0.1288);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.04796, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'area_m2', -2.384, 0.5613),
  ('chair_back', 8, 'aspect', 0.6529, 0.3044),
  ('chair_back', 8, 'behind', 0.5233, 0.4277),
  ('chair_back', 8, 'edge_free', 0.4895, 0.1897),
  ('chair_back', 8, 'edge_free_top', 0.5385, 0.3124),
  ('chair_back', 8, 'edge_joined', 0.2101, 0.2455),
  ('chair_back', 8, 'edge_unseen', 0.1364, 0.1897),
  ('chair_back', 8, 'height', 0.8269, 0.08602),
  ('chair_back', 8, 'length', -0.6785, 0.2576),
  ('chair_back', 8, 'rectangularity', 0.6805, 0.1555),
  ('chair_back', 8, 'spread_length', -0.8191, 0.1812),
  ('chair_back', 8, 'spread_width', -1.611, 0.3457),
  ('chair_back', 8, 'tilt_deg', 80.02, 2.534),
  ('chair_back', 8, 'width', -1.29, 0.3461),
  ('chair_back', 8, 'z_max', 1.056, 0.09691),
  ('chair_back', 8, 'z_min', 0.5376, 0.09194);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.07408, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'area_m2', -2.619, 0.3216),
  ('chair_back', 9, 'aspect', 0.5295, 0.3592),
  ('chair_back', 9, 'behind', 0.6428, 0.2916),
  ('chair_back', 9, 'edge_free', 0.6309, 0.1121),
  ('chair_back', 9, 'edge_free_top', 0.9973, 0.03),
  ('chair_back', 9, 'edge_joined', 0.0941, 0.1321),
  ('chair_back', 9, 'edge_unseen', 0.001864, 0.03),
  ('chair_back', 9, 'height', 0.8417, 0.05771),
  ('chair_back', 9, 'length', -0.8629, 0.2099),
  ('chair_back', 9, 'rectangularity', 0.786, 0.1246),
  ('chair_back', 9, 'spread_length', -0.9265, 0.1315),
  ('chair_back', 9, 'spread_width', -1.731, 0.2352),
  ('chair_back', 9, 'tilt_deg', 80.33, 2.517),
  ('chair_back', 9, 'width', -1.425, 0.2434),
  ('chair_back', 9, 'z_max', 1.023, 0.06344),
  ('chair_back', 9, 'z_min', 0.5944, 0.03406);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 10, 0.082, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 10, 'area_m2', -1.125, 0.2145),
  ('chair_back', 10, 'aspect', 0.6278, 0.2833),
  ('chair_back', 10, 'behind', 0.7369, 0.07278),
  ('chair_back', 10, 'edge_free', 0.7633, 0.1597),
  ('chair_back', 10, 'edge_free_top', 0.964, 0.05907),
  ('chair_back', 10, 'edge_joined', 0.1532, 0.1458),
  ('chair_back', 10, 'edge_unseen', 0.009602, 0.03),
  ('chair_back', 10, 'height', 0.758, 0.06197),
  ('chair_back', 10, 'length', -0.02493, 0.1679),
  ('chair_back', 10, 'rectangularity', 0.6243, 0.09779),
  ('chair_back', 10, 'spread_length', -0.4271, 0.1285),
  ('chair_back', 10, 'spread_width', -0.8418, 0.1893),
  ('chair_back', 10, 'tilt_deg', 80.31, 2.911),
  ('chair_back', 10, 'width', -0.6278, 0.2299),
  ('chair_back', 10, 'z_max', 1.014, 0.08372),
  ('chair_back', 10, 'z_min', 0.06414, 0.09886);

-- door: 314 examples
UPDATE object_class SET prior = 0.01753 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.1522, 0.7421)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.8151, 0.2991)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.1577, 0.2483)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.1472, 0.242)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.2277, 0.3725)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_joined', 0.3725, 0.3392)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_unseen', 0.1035, 0.1692)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.134, 0.1994)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.599, 0.3468)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8113, 0.1312)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.442, 0.3604)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.3672, 0.4578)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.17, 3.054)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.2197, 0.397)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.014, 0.3144)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1385, 0.3004)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'door';
DELETE FROM class_density WHERE class = 'door';
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.1852, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'area_m2', 0.5572, 0.08706),
  ('door', 1, 'aspect', 0.7737, 0.07892),
  ('door', 1, 'behind', -0.008586, 0.03),
  ('door', 1, 'edge_free', -0.0006973, 0.03135),
  ('door', 1, 'edge_free_top', 0.002037, 0.03269),
  ('door', 1, 'edge_joined', 0.4373, 0.315),
  ('door', 1, 'edge_unseen', 0.007821, 0.03322),
  ('door', 1, 'height', 1.077, 0.06399),
  ('door', 1, 'length', 0.7181, 0.03454),
  ('door', 1, 'rectangularity', 0.9058, 0.06911),
  ('door', 1, 'spread_length', 0.6422, 0.04555),
  ('door', 1, 'spread_width', -0.1403, 0.0566),
  ('door', 1, 'tilt_deg', 89.99, 0.4611),
  ('door', 1, 'width', -0.07162, 0.07318),
  ('door', 1, 'z_max', 2.046, 0.04672),
  ('door', 1, 'z_min', 0.003277, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1552, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'area_m2', 0.5832, 0.1225),
  ('door', 2, 'aspect', 0.8432, 0.07577),
  ('door', 2, 'behind', 0.5253, 0.1351),
  ('door', 2, 'edge_free', 0.394, 0.1429),
  ('door', 2, 'edge_free_top', 0.7894, 0.1782),
  ('door', 2, 'edge_joined', 0.329, 0.3083),
  ('door', 2, 'edge_unseen', 0.004044, 0.03),
  ('door', 2, 'height', 1.078, 0.04108),
  ('door', 2, 'length', 0.7988, 0.07638),
  ('door', 2, 'rectangularity', 0.8307, 0.04859),
  ('door', 2, 'spread_length', 0.6748, 0.04147),
  ('door', 2, 'spread_width', -0.1238, 0.09508),
  ('door', 2, 'tilt_deg', 89.98, 0.45),
  ('door', 2, 'width', -0.02522, 0.09384),
  ('door', 2, 'z_max', 2.202, 0.1225),
  ('door', 2, 'z_min', -0.007913, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.0977, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'area_m2', 0.2969, 0.1559),
  ('door', 3, 'aspect', 0.8594, 0.1364),
  ('door', 3, 'behind', -0.001699, 0.03),
  ('door', 3, 'edge_free', 0.001908, 0.03),
  ('door', 3, 'edge_free_top', 0.005117, 0.03416),
  ('door', 3, 'edge_joined', 0.3283, 0.2963),
  ('door', 3, 'edge_unseen', 0.25, 0.2092),
  ('door', 3, 'height', 1.221, 0.1034),
  ('door', 3, 'length', 0.7064, 0.05191),
  ('door', 3, 'rectangularity', 0.777, 0.1055),
  ('door', 3, 'spread_length', 0.4491, 0.1253),
  ('door', 3, 'spread_width', -0.2652, 0.1351),
  ('door', 3, 'tilt_deg', 89.96, 0.45),
  ('door', 3, 'width', -0.1523, 0.1327),
  ('door', 3, 'z_max', 2.06, 0.03998),
  ('door', 3, 'z_min', 0.04219, 0.0893);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.1212, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'area_m2', 0.1618, 0.4896),
  ('door', 4, 'aspect', 0.4994, 0.2047),
  ('door', 4, 'behind', -0.000879, 0.03),
  ('door', 4, 'edge_free', -0.00288, 0.03),
  ('door', 4, 'edge_free_top', 0.006733, 0.03374),
  ('door', 4, 'edge_joined', 0.4269, 0.3238),
  ('door', 4, 'edge_unseen', 0.1978, 0.2281),
  ('door', 4, 'height', 1.301, 0.1719),
  ('door', 4, 'length', 0.5003, 0.2538),
  ('door', 4, 'rectangularity', 0.7329, 0.1438),
  ('door', 4, 'spread_length', 0.1571, 0.302),
  ('door', 4, 'spread_width', -0.2068, 0.1303),
  ('door', 4, 'tilt_deg', 89.9, 0.6191),
  ('door', 4, 'width', -0.07826, 0.1144),
  ('door', 4, 'z_max', 2.058, 0.05803),
  ('door', 4, 'z_min', 0.3247, 0.1944);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.1176, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'area_m2', 0.2684, 0.2197),
  ('door', 5, 'aspect', 0.7488, 0.09409),
  ('door', 5, 'behind', 0.4784, 0.1177),
  ('door', 5, 'edge_free', 0.5395, 0.252),
  ('door', 5, 'edge_free_top', 0.7721, 0.2158),
  ('door', 5, 'edge_joined', 0.2234, 0.2535),
  ('door', 5, 'edge_unseen', 0.2061, 0.1842),
  ('door', 5, 'height', 1.289, 0.08952),
  ('door', 5, 'length', 0.6801, 0.1291),
  ('door', 5, 'rectangularity', 0.7253, 0.1167),
  ('door', 5, 'spread_length', 0.2795, 0.1453),
  ('door', 5, 'spread_width', -0.1743, 0.09701),
  ('door', 5, 'tilt_deg', 89.97, 0.45),
  ('door', 5, 'width', -0.07394, 0.0673),
  ('door', 5, 'z_max', 2.184, 0.09317),
  ('door', 5, 'z_min', 0.2367, 0.3012);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.08109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'area_m2', -0.4253, 0.3922),
  ('door', 6, 'aspect', 1.385, 0.2054),
  ('door', 6, 'behind', 0.1091, 0.1595),
  ('door', 6, 'edge_free', 0.1528, 0.2688),
  ('door', 6, 'edge_free_top', 0.3005, 0.3943),
  ('door', 6, 'edge_joined', 0.2548, 0.254),
  ('door', 6, 'edge_unseen', 0.3493, 0.1245),
  ('door', 6, 'height', 1.115, 0.1222),
  ('door', 6, 'length', 0.6625, 0.1352),
  ('door', 6, 'rectangularity', 0.7135, 0.1242),
  ('door', 6, 'spread_length', 0.6012, 0.1468),
  ('door', 6, 'spread_width', -1.103, 0.3585),
  ('door', 6, 'tilt_deg', 89.21, 1.526),
  ('door', 6, 'width', -0.7937, 0.3586),
  ('door', 6, 'z_max', 2.044, 0.09982),
  ('door', 6, 'z_min', 0.05283, 0.1227);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.04863, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'area_m2', -2.267, 0.5984),
  ('door', 7, 'aspect', 1.014, 0.3562),
  ('door', 7, 'behind', 0.01965, 0.1079),
  ('door', 7, 'edge_free', 0.2531, 0.3133),
  ('door', 7, 'edge_free_top', 0.2197, 0.3691),
  ('door', 7, 'edge_joined', 0.5941, 0.2927),
  ('door', 7, 'edge_unseen', 0.07797, 0.1096),
  ('door', 7, 'height', 1.215, 0.3324),
  ('door', 7, 'length', -0.5203, 0.4087),
  ('door', 7, 'rectangularity', 0.7656, 0.06671),
  ('door', 7, 'spread_length', -0.6264, 0.4061),
  ('door', 7, 'spread_width', -1.671, 0.2552),
  ('door', 7, 'tilt_deg', 88.13, 2.899),
  ('door', 7, 'width', -1.446, 0.1611),
  ('door', 7, 'z_max', 1.518, 0.3208),
  ('door', 7, 'z_min', 0.8313, 0.4206);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.06529, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'area_m2', -0.2705, 0.2162),
  ('door', 8, 'aspect', 0.9146, 0.3964),
  ('door', 8, 'behind', 0.2521, 0.09974),
  ('door', 8, 'edge_free', 0.3162, 0.07846),
  ('door', 8, 'edge_free_top', 0.04456, 0.08433),
  ('door', 8, 'edge_joined', 0.05187, 0.0711),
  ('door', 8, 'edge_unseen', 0.08591, 0.1043),
  ('door', 8, 'height', 0.9392, 0.2429),
  ('door', 8, 'length', 0.6456, 0.2248),
  ('door', 8, 'rectangularity', 0.6041, 0.1209),
  ('door', 8, 'spread_length', 0.5256, 0.2167),
  ('door', 8, 'spread_width', -0.9515, 0.2654),
  ('door', 8, 'tilt_deg', 74.74, 3.322),
  ('door', 8, 'width', -0.3553, 0.1646),
  ('door', 8, 'z_max', 1.545, 0.469),
  ('door', 8, 'z_min', 0.1382, 0.2522);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.04404, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'area_m2', -0.296, 0.3643),
  ('door', 9, 'aspect', 0.3102, 0.1301),
  ('door', 9, 'behind', 0.5632, 0.1643),
  ('door', 9, 'edge_free', 0.2056, 0.1708),
  ('door', 9, 'edge_free_top', 0.3513, 0.2643),
  ('door', 9, 'edge_joined', 0.6243, 0.2762),
  ('door', 9, 'edge_unseen', 0.2248, 0.09342),
  ('door', 9, 'height', 1.341, 0.1403),
  ('door', 9, 'length', 0.1884, 0.1998),
  ('door', 9, 'rectangularity', 0.7057, 0.1182),
  ('door', 9, 'spread_length', -0.005765, 0.1616),
  ('door', 9, 'spread_width', -0.349, 0.2846),
  ('door', 9, 'tilt_deg', 89.18, 1.401),
  ('door', 9, 'width', -0.129, 0.1193),
  ('door', 9, 'z_max', 1.977, 0.265),
  ('door', 9, 'z_min', 0.725, 0.2344);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.03414, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'area_m2', -1.301, 0.6584),
  ('door', 10, 'aspect', 0.8238, 0.3126),
  ('door', 10, 'behind', 0.04615, 0.1291),
  ('door', 10, 'edge_free', 0.1087, 0.127),
  ('door', 10, 'edge_free_top', 0.1015, 0.1571),
  ('door', 10, 'edge_joined', 0.2598, 0.162),
  ('door', 10, 'edge_unseen', 0.1269, 0.151),
  ('door', 10, 'height', 0.5098, 0.1908),
  ('door', 10, 'length', -0.1029, 0.3245),
  ('door', 10, 'rectangularity', 0.8034, 0.1125),
  ('door', 10, 'spread_length', -0.1363, 0.3013),
  ('door', 10, 'spread_width', -1.061, 0.2457),
  ('door', 10, 'tilt_deg', 89.25, 0.8217),
  ('door', 10, 'width', -0.9332, 0.2429),
  ('door', 10, 'z_max', 0.8983, 0.2915),
  ('door', 10, 'z_min', 0.04424, 0.06278);

-- window: 657 examples
UPDATE object_class SET prior = 0.02711 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', -0.3659, 0.7967)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.4642, 0.4056)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 0.002499, 0.02383)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.07998, 0.1518)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.06827, 0.194)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_joined', 0.402, 0.3564)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_unseen', 0.1507, 0.1717)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.492, 0.2131)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.1709, 0.3462)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8028, 0.143)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.1522, 0.386)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.4068, 0.56)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.72, 0.4841)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.2965, 0.4849)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.023, 0.2812)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 1.025, 0.2243)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'window';
DELETE FROM class_density WHERE class = 'window';
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.1612, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'area_m2', -0.06422, 0.1389),
  ('window', 1, 'aspect', 0.2833, 0.19),
  ('window', 1, 'behind', -0.003433, 0.03),
  ('window', 1, 'edge_free', 0.01158, 0.04103),
  ('window', 1, 'edge_free_top', 0.001136, 0.03),
  ('window', 1, 'edge_joined', 0.5496, 0.4168),
  ('window', 1, 'edge_unseen', 0.1509, 0.05408),
  ('window', 1, 'height', 1.446, 0.1411),
  ('window', 1, 'length', 0.219, 0.1241),
  ('window', 1, 'rectangularity', 0.8921, 0.05048),
  ('window', 1, 'spread_length', 0.2276, 0.1164),
  ('window', 1, 'spread_width', -0.1749, 0.1488),
  ('window', 1, 'tilt_deg', 89.51, 0.45),
  ('window', 1, 'width', -0.1336, 0.09477),
  ('window', 1, 'z_max', 2.076, 0.1935),
  ('window', 1, 'z_min', 0.9578, 0.06383);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1337, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'area_m2', 0.2897, 0.1518),
  ('window', 2, 'aspect', 0.1562, 0.1038),
  ('window', 2, 'behind', -0.0009381, 0.03),
  ('window', 2, 'edge_free', -0.005842, 0.03),
  ('window', 2, 'edge_free_top', -0.001539, 0.03041),
  ('window', 2, 'edge_joined', 0.02899, 0.04445),
  ('window', 2, 'edge_unseen', 0.01011, 0.04023),
  ('window', 2, 'height', 1.521, 0.08941),
  ('window', 2, 'length', 0.3263, 0.1081),
  ('window', 2, 'rectangularity', 0.9007, 0.0896),
  ('window', 2, 'spread_length', 0.4688, 0.07453),
  ('window', 2, 'spread_width', 0.2522, 0.1069),
  ('window', 2, 'tilt_deg', 89.81, 0.45),
  ('window', 2, 'width', 0.09703, 0.09575),
  ('window', 2, 'z_max', 2.122, 0.1136),
  ('window', 2, 'z_min', 0.8963, 0.0493);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.07446, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'area_m2', -0.7252, 0.2774),
  ('window', 3, 'aspect', 0.3936, 0.2801),
  ('window', 3, 'behind', -0.006228, 0.03),
  ('window', 3, 'edge_free', 0.0009302, 0.03),
  ('window', 3, 'edge_free_top', 0.0006092, 0.03),
  ('window', 3, 'edge_joined', 0.7329, 0.2626),
  ('window', 3, 'edge_unseen', 0.3484, 0.2195),
  ('window', 3, 'height', 1.384, 0.1837),
  ('window', 3, 'length', 0.004471, 0.1742),
  ('window', 3, 'rectangularity', 0.7949, 0.1811),
  ('window', 3, 'spread_length', -0.02238, 0.1745),
  ('window', 3, 'spread_width', -0.5986, 0.2309),
  ('window', 3, 'tilt_deg', 89.58, 0.45),
  ('window', 3, 'width', -0.4719, 0.1972),
  ('window', 3, 'z_max', 1.853, 0.2653),
  ('window', 3, 'z_min', 0.9959, 0.06193);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.1506, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'area_m2', -0.5735, 0.3965),
  ('window', 4, 'aspect', 0.5639, 0.2941),
  ('window', 4, 'behind', -0.006869, 0.03),
  ('window', 4, 'edge_free', 0.1774, 0.1086),
  ('window', 4, 'edge_free_top', 0.01143, 0.03),
  ('window', 4, 'edge_joined', 0.4377, 0.2639),
  ('window', 4, 'edge_unseen', 0.1933, 0.09305),
  ('window', 4, 'height', 1.844, 0.1164),
  ('window', 4, 'length', 0.1032, 0.2433),
  ('window', 4, 'rectangularity', 0.8092, 0.07465),
  ('window', 4, 'spread_length', 0.1635, 0.1505),
  ('window', 4, 'spread_width', -0.6658, 0.2615),
  ('window', 4, 'tilt_deg', 89.78, 0.45),
  ('window', 4, 'width', -0.5011, 0.2766),
  ('window', 4, 'z_max', 2.157, 0.1289),
  ('window', 4, 'z_min', 1.534, 0.202);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.11, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'area_m2', -0.05434, 0.2714),
  ('window', 5, 'aspect', 0.1985, 0.1518),
  ('window', 5, 'behind', -0.001338, 0.03),
  ('window', 5, 'edge_free', 0.0935, 0.1107),
  ('window', 5, 'edge_free_top', 0.02457, 0.06378),
  ('window', 5, 'edge_joined', 0.1746, 0.1742),
  ('window', 5, 'edge_unseen', 0.1375, 0.1385),
  ('window', 5, 'height', 1.583, 0.1358),
  ('window', 5, 'length', 0.3461, 0.105),
  ('window', 5, 'rectangularity', 0.6609, 0.2486),
  ('window', 5, 'spread_length', 0.4206, 0.1735),
  ('window', 5, 'spread_width', 0.09646, 0.1659),
  ('window', 5, 'tilt_deg', 89.69, 0.4818),
  ('window', 5, 'width', 0.1079, 0.09904),
  ('window', 5, 'z_max', 2.215, 0.1036),
  ('window', 5, 'z_min', 0.937, 0.07265);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.08561, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'area_m2', -0.3995, 0.392),
  ('window', 6, 'aspect', 0.3703, 0.246),
  ('window', 6, 'behind', -0.006963, 0.03),
  ('window', 6, 'edge_free', 0.3922, 0.2503),
  ('window', 6, 'edge_free_top', 0.4543, 0.3673),
  ('window', 6, 'edge_joined', 0.4593, 0.2374),
  ('window', 6, 'edge_unseen', 0.09274, 0.116),
  ('window', 6, 'height', 1.456, 0.1254),
  ('window', 6, 'length', 0.1102, 0.1787),
  ('window', 6, 'rectangularity', 0.8069, 0.07624),
  ('window', 6, 'spread_length', 0.07604, 0.163),
  ('window', 6, 'spread_width', -0.4018, 0.2603),
  ('window', 6, 'tilt_deg', 89.72, 0.45),
  ('window', 6, 'width', -0.287, 0.2321),
  ('window', 6, 'z_max', 1.999, 0.1356),
  ('window', 6, 'z_min', 1.026, 0.06375);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.1281, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'area_m2', -1.247, 0.4486),
  ('window', 7, 'aspect', 1.236, 0.3126),
  ('window', 7, 'behind', -0.003078, 0.03),
  ('window', 7, 'edge_free', 0.001176, 0.04509),
  ('window', 7, 'edge_free_top', 0.01028, 0.04115),
  ('window', 7, 'edge_joined', 0.3467, 0.2002),
  ('window', 7, 'edge_unseen', 0.1356, 0.1592),
  ('window', 7, 'height', 1.217, 0.1798),
  ('window', 7, 'length', 0.1658, 0.1673),
  ('window', 7, 'rectangularity', 0.7635, 0.1394),
  ('window', 7, 'spread_length', 0.2016, 0.1309),
  ('window', 7, 'spread_width', -1.276, 0.4427),
  ('window', 7, 'tilt_deg', 88.84, 0.7257),
  ('window', 7, 'width', -1.095, 0.2645),
  ('window', 7, 'z_max', 1.518, 0.4051),
  ('window', 7, 'z_min', 0.9212, 0.04236);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.04295, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'area_m2', -2.027, 0.3852),
  ('window', 8, 'aspect', 0.4692, 0.3125),
  ('window', 8, 'behind', -0.02439, 0.108),
  ('window', 8, 'edge_free', 0.04385, 0.06836),
  ('window', 8, 'edge_free_top', 0.003463, 0.03),
  ('window', 8, 'edge_joined', 0.6821, 0.1806),
  ('window', 8, 'edge_unseen', 0.3289, 0.236),
  ('window', 8, 'height', 1.458, 0.2767),
  ('window', 8, 'length', -0.5106, 0.3573),
  ('window', 8, 'rectangularity', 0.6807, 0.07619),
  ('window', 8, 'spread_length', -0.5565, 0.1943),
  ('window', 8, 'spread_width', -1.203, 0.2771),
  ('window', 8, 'tilt_deg', 89.68, 0.45),
  ('window', 8, 'width', -1.092, 0.2353),
  ('window', 8, 'z_max', 1.758, 0.374),
  ('window', 8, 'z_min', 1.229, 0.2067);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.02556, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'area_m2', -1.412, 0.7795),
  ('window', 9, 'aspect', 1.037, 0.4729),
  ('window', 9, 'behind', 0.009329, 0.1444),
  ('window', 9, 'edge_free', 0.315, 0.1553),
  ('window', 9, 'edge_free_top', 0.4237, 0.2261),
  ('window', 9, 'edge_joined', 0.266, 0.1773),
  ('window', 9, 'edge_unseen', 0.09149, 0.1164),
  ('window', 9, 'height', 1.211, 0.2569),
  ('window', 9, 'length', -0.02329, 0.5058),
  ('window', 9, 'rectangularity', 0.6641, 0.1621),
  ('window', 9, 'spread_length', 0.05241, 0.4198),
  ('window', 9, 'spread_width', -1.166, 0.5227),
  ('window', 9, 'tilt_deg', 87.6, 6.928),
  ('window', 9, 'width', -0.9634, 0.4645),
  ('window', 9, 'z_max', 1.57, 0.5587),
  ('window', 9, 'z_min', 0.8976, 0.1641);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.03776, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'area_m2', 1.312, 0.4414),
  ('window', 10, 'aspect', 0.9116, 0.2627),
  ('window', 10, 'behind', -0.0007031, 0.03),
  ('window', 10, 'edge_free', 0.004914, 0.03025),
  ('window', 10, 'edge_free_top', 0.006044, 0.03),
  ('window', 10, 'edge_joined', 0.2155, 0.24),
  ('window', 10, 'edge_unseen', 0.1325, 0.1092),
  ('window', 10, 'height', 1.483, 0.07577),
  ('window', 10, 'length', 1.233, 0.2482),
  ('window', 10, 'rectangularity', 0.7452, 0.1982),
  ('window', 10, 'spread_length', 1.2, 0.1812),
  ('window', 10, 'spread_width', 0.2454, 0.1893),
  ('window', 10, 'tilt_deg', 89.87, 0.45),
  ('window', 10, 'width', 0.373, 0.2819),
  ('window', 10, 'z_max', 2.341, 0.2438),
  ('window', 10, 'z_min', 0.8193, 0.2337);

-- whiteboard: 263 examples
UPDATE object_class SET prior = 0.01221 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', -0.004743, 0.907)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4603, 0.3206)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.01602, 0.09056)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.03318, 0.07494)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.03804, 0.08136)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_joined', 0.7769, 0.198)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_unseen', 0.1611, 0.1885)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.399, 0.1513)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.3386, 0.439)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.8182, 0.1019)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.1971, 0.4463)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.3485, 0.4997)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.74, 0.7506)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', -0.1278, 0.5033)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 1.943, 0.246)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.8756, 0.1937)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'whiteboard';
DELETE FROM class_density WHERE class = 'whiteboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.3342, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'area_m2', 0.6689, 0.1459),
  ('whiteboard', 1, 'aspect', 0.5771, 0.151),
  ('whiteboard', 1, 'behind', -0.0006257, 0.03),
  ('whiteboard', 1, 'edge_free', 0.03275, 0.03),
  ('whiteboard', 1, 'edge_free_top', 0.03509, 0.03787),
  ('whiteboard', 1, 'edge_joined', 0.8555, 0.09906),
  ('whiteboard', 1, 'edge_unseen', 0.07794, 0.1055),
  ('whiteboard', 1, 'height', 1.427, 0.06475),
  ('whiteboard', 1, 'length', 0.6782, 0.1346),
  ('whiteboard', 1, 'rectangularity', 0.8423, 0.07896),
  ('whiteboard', 1, 'spread_length', 0.5114, 0.115),
  ('whiteboard', 1, 'spread_width', -0.1309, 0.1112),
  ('whiteboard', 1, 'tilt_deg', 90.08, 0.45),
  ('whiteboard', 1, 'width', 0.1362, 0.07817),
  ('whiteboard', 1, 'z_max', 2.007, 0.102),
  ('whiteboard', 1, 'z_min', 0.8845, 0.06998);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.207, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'area_m2', 0.2521, 0.1535),
  ('whiteboard', 2, 'aspect', 0.187, 0.08581),
  ('whiteboard', 2, 'behind', 0.002407, 0.03649),
  ('whiteboard', 2, 'edge_free', 0.02536, 0.03),
  ('whiteboard', 2, 'edge_free_top', 0.02688, 0.03282),
  ('whiteboard', 2, 'edge_joined', 0.8074, 0.1006),
  ('whiteboard', 2, 'edge_unseen', 0.01259, 0.04755),
  ('whiteboard', 2, 'height', 1.478, 0.06607),
  ('whiteboard', 2, 'length', 0.2626, 0.1085),
  ('whiteboard', 2, 'rectangularity', 0.881, 0.03905),
  ('whiteboard', 2, 'spread_length', 0.1549, 0.09283),
  ('whiteboard', 2, 'spread_width', -0.05273, 0.08391),
  ('whiteboard', 2, 'tilt_deg', 90.17, 0.45),
  ('whiteboard', 2, 'width', 0.1002, 0.05635),
  ('whiteboard', 2, 'z_max', 2.006, 0.09283),
  ('whiteboard', 2, 'z_min', 0.9068, 0.04519);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.1026, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'area_m2', -0.4036, 0.2971),
  ('whiteboard', 3, 'aspect', 0.3821, 0.3075),
  ('whiteboard', 3, 'behind', -0.002914, 0.03),
  ('whiteboard', 3, 'edge_free', 0.01724, 0.03878),
  ('whiteboard', 3, 'edge_free_top', 0.01107, 0.03186),
  ('whiteboard', 3, 'edge_joined', 0.7706, 0.1532),
  ('whiteboard', 3, 'edge_unseen', 0.3622, 0.2197),
  ('whiteboard', 3, 'height', 1.353, 0.09485),
  ('whiteboard', 3, 'length', 0.09472, 0.1376),
  ('whiteboard', 3, 'rectangularity', 0.7898, 0.0583),
  ('whiteboard', 3, 'spread_length', -0.1173, 0.1102),
  ('whiteboard', 3, 'spread_width', -0.5453, 0.1113),
  ('whiteboard', 3, 'tilt_deg', 89.9, 0.6776),
  ('whiteboard', 3, 'width', -0.2678, 0.2639),
  ('whiteboard', 3, 'z_max', 1.981, 0.1328),
  ('whiteboard', 3, 'z_min', 0.8779, 0.04476);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.09616, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'area_m2', 0.6648, 0.2797),
  ('whiteboard', 4, 'aspect', 0.5619, 0.2285),
  ('whiteboard', 4, 'behind', -0.001351, 0.03),
  ('whiteboard', 4, 'edge_free', 0.01917, 0.03),
  ('whiteboard', 4, 'edge_free_top', 0.02382, 0.03),
  ('whiteboard', 4, 'edge_joined', 0.6725, 0.08736),
  ('whiteboard', 4, 'edge_unseen', 0.2424, 0.1967),
  ('whiteboard', 4, 'height', 1.419, 0.07994),
  ('whiteboard', 4, 'length', 0.7618, 0.2254),
  ('whiteboard', 4, 'rectangularity', 0.6824, 0.07536),
  ('whiteboard', 4, 'spread_length', 0.621, 0.1867),
  ('whiteboard', 4, 'spread_width', -0.1989, 0.2559),
  ('whiteboard', 4, 'tilt_deg', 89.94, 0.5599),
  ('whiteboard', 4, 'width', 0.2534, 0.143),
  ('whiteboard', 4, 'z_max', 2.09, 0.08021),
  ('whiteboard', 4, 'z_min', 0.7668, 0.2654);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.04912, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'area_m2', -1.793, 0.5609),
  ('whiteboard', 5, 'aspect', 0.9328, 0.3251),
  ('whiteboard', 5, 'behind', -0.002817, 0.03),
  ('whiteboard', 5, 'edge_free', 0.03468, 0.08562),
  ('whiteboard', 5, 'edge_free_top', 0.04902, 0.04924),
  ('whiteboard', 5, 'edge_joined', 0.8159, 0.2412),
  ('whiteboard', 5, 'edge_unseen', 0.3341, 0.1119),
  ('whiteboard', 5, 'height', 1.436, 0.2349),
  ('whiteboard', 5, 'length', -0.2803, 0.2717),
  ('whiteboard', 5, 'rectangularity', 0.7437, 0.05767),
  ('whiteboard', 5, 'spread_length', -0.5496, 0.3108),
  ('whiteboard', 5, 'spread_width', -1.384, 0.3544),
  ('whiteboard', 5, 'tilt_deg', 89.48, 1.123),
  ('whiteboard', 5, 'width', -1.191, 0.4273),
  ('whiteboard', 5, 'z_max', 1.867, 0.2172),
  ('whiteboard', 5, 'z_min', 1.045, 0.1427);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.044, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'area_m2', 0.2509, 0.3937),
  ('whiteboard', 6, 'aspect', 0.3901, 0.3175),
  ('whiteboard', 6, 'behind', 0.003318, 0.03),
  ('whiteboard', 6, 'edge_free', 0.2549, 0.2388),
  ('whiteboard', 6, 'edge_free_top', 0.3164, 0.1666),
  ('whiteboard', 6, 'edge_joined', 0.4372, 0.1587),
  ('whiteboard', 6, 'edge_unseen', 0.129, 0.1352),
  ('whiteboard', 6, 'height', 1.337, 0.1118),
  ('whiteboard', 6, 'length', 0.4577, 0.2991),
  ('whiteboard', 6, 'rectangularity', 0.7389, 0.09794),
  ('whiteboard', 6, 'spread_length', 0.3474, 0.3837),
  ('whiteboard', 6, 'spread_width', -0.2508, 0.2562),
  ('whiteboard', 6, 'tilt_deg', 89.47, 1.039),
  ('whiteboard', 6, 'width', 0.08335, 0.2147),
  ('whiteboard', 6, 'z_max', 1.892, 0.1577),
  ('whiteboard', 6, 'z_min', 0.7307, 0.1412);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.05603, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'area_m2', -0.1974, 0.3251),
  ('whiteboard', 7, 'aspect', 0.9829, 0.388),
  ('whiteboard', 7, 'behind', 0.0005102, 0.03),
  ('whiteboard', 7, 'edge_free', 0.007154, 0.03),
  ('whiteboard', 7, 'edge_free_top', 0.06849, 0.03),
  ('whiteboard', 7, 'edge_joined', 0.5157, 0.1539),
  ('whiteboard', 7, 'edge_unseen', 0.3968, 0.05962),
  ('whiteboard', 7, 'height', 0.9545, 0.2272),
  ('whiteboard', 7, 'length', 0.4609, 0.1401),
  ('whiteboard', 7, 'rectangularity', 0.7886, 0.08653),
  ('whiteboard', 7, 'spread_length', 0.3426, 0.1388),
  ('whiteboard', 7, 'spread_width', -0.6207, 0.3273),
  ('whiteboard', 7, 'tilt_deg', 87.92, 0.8103),
  ('whiteboard', 7, 'width', -0.4453, 0.3292),
  ('whiteboard', 7, 'z_max', 1.264, 0.2285),
  ('whiteboard', 7, 'z_min', 0.4852, 0.3323);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.03092, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'area_m2', -2.393, 0.5528),
  ('whiteboard', 8, 'aspect', 0.3864, 0.1521),
  ('whiteboard', 8, 'behind', -0.00141, 0.03),
  ('whiteboard', 8, 'edge_free', 0.06414, 0.166),
  ('whiteboard', 8, 'edge_free_top', 0.002752, 0.03),
  ('whiteboard', 8, 'edge_joined', 0.8062, 0.1954),
  ('whiteboard', 8, 'edge_unseen', 0.3109, 0.1029),
  ('whiteboard', 8, 'height', 1.208, 0.1305),
  ('whiteboard', 8, 'length', -0.8957, 0.2995),
  ('whiteboard', 8, 'rectangularity', 0.811, 0.04526),
  ('whiteboard', 8, 'spread_length', -1.038, 0.357),
  ('whiteboard', 8, 'spread_width', -1.501, 0.2664),
  ('whiteboard', 8, 'tilt_deg', 89.24, 1.491),
  ('whiteboard', 8, 'width', -1.278, 0.2952),
  ('whiteboard', 8, 'z_max', 1.393, 0.1889),
  ('whiteboard', 8, 'z_min', 0.9178, 0.07226);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 9, 0.02992, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 9, 'area_m2', -0.3789, 0.8318),
  ('whiteboard', 9, 'aspect', 0.4399, 0.2556),
  ('whiteboard', 9, 'behind', 0.5608, 0.1924),
  ('whiteboard', 9, 'edge_free', 0.0197, 0.03071),
  ('whiteboard', 9, 'edge_free_top', 0.01395, 0.03062),
  ('whiteboard', 9, 'edge_joined', 0.8618, 0.09713),
  ('whiteboard', 9, 'edge_unseen', 0.02243, 0.04234),
  ('whiteboard', 9, 'height', 1.435, 0.1981),
  ('whiteboard', 9, 'length', 0.287, 0.4867),
  ('whiteboard', 9, 'rectangularity', 0.6631, 0.2859),
  ('whiteboard', 9, 'spread_length', 0.2644, 0.533),
  ('whiteboard', 9, 'spread_width', -0.2501, 0.4286),
  ('whiteboard', 9, 'tilt_deg', 72.59, 29.93),
  ('whiteboard', 9, 'width', -0.09719, 0.4681),
  ('whiteboard', 9, 'z_max', 1.997, 0.6358),
  ('whiteboard', 9, 'z_min', 0.9785, 0.1394);

-- shelf: 1293 examples
UPDATE object_class SET prior = 0.09076 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.587, 0.7705)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.9017, 0.4366)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5748, 0.3175)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3009, 0.1782)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4196, 0.3451)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_joined', 0.365, 0.2848)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_unseen', 0.05014, 0.1055)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9246, 0.4844)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.1513, 0.5178)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.698, 0.1307)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.2881, 0.5133)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.262, 0.3737)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 46.99, 44.17)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.058, 0.3441)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.191, 0.6065)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.6182, 0.5832)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'shelf';
DELETE FROM class_density WHERE class = 'shelf';
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.181, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'area_m2', -1.437, 0.4304),
  ('shelf', 1, 'aspect', 0.9272, 0.3957),
  ('shelf', 1, 'behind', 0.8001, 0.1652),
  ('shelf', 1, 'edge_free', 0.3673, 0.1051),
  ('shelf', 1, 'edge_free_top', 0.5063, 0.3431),
  ('shelf', 1, 'edge_joined', 0.1889, 0.3114),
  ('shelf', 1, 'edge_unseen', 0.1009, 0.1183),
  ('shelf', 1, 'height', 1.126, 0.2006),
  ('shelf', 1, 'length', 0.1258, 0.2776),
  ('shelf', 1, 'rectangularity', 0.738, 0.1492),
  ('shelf', 1, 'spread_length', -0.2656, 0.3301),
  ('shelf', 1, 'spread_width', -1.122, 0.1649),
  ('shelf', 1, 'tilt_deg', 90.16, 0.45),
  ('shelf', 1, 'width', -0.954, 0.128),
  ('shelf', 1, 'z_max', 1.677, 0.2273),
  ('shelf', 1, 'z_min', 0.3579, 0.2594);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.1713, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'area_m2', -1.396, 0.4298),
  ('shelf', 2, 'aspect', 0.833, 0.1611),
  ('shelf', 2, 'behind', 0.7587, 0.1038),
  ('shelf', 2, 'edge_free', 0.285, 0.1226),
  ('shelf', 2, 'edge_free_top', 0.4208, 0.1039),
  ('shelf', 2, 'edge_joined', 0.61, 0.2698),
  ('shelf', 2, 'edge_unseen', 0.03296, 0.08927),
  ('shelf', 2, 'height', 1.658, 0.2553),
  ('shelf', 2, 'length', -0.1129, 0.2274),
  ('shelf', 2, 'rectangularity', 0.7787, 0.1289),
  ('shelf', 2, 'spread_length', -0.3662, 0.2512),
  ('shelf', 2, 'spread_width', -1.018, 0.09896),
  ('shelf', 2, 'tilt_deg', 0.3496, 0.45),
  ('shelf', 2, 'width', -0.9218, 0.1121),
  ('shelf', 2, 'z_max', 1.628, 0.2607),
  ('shelf', 2, 'z_min', 1.644, 0.2519);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.1109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'area_m2', -0.6098, 0.352),
  ('shelf', 3, 'aspect', 1.557, 0.1226),
  ('shelf', 3, 'behind', 0.7478, 0.1096),
  ('shelf', 3, 'edge_free', 0.3854, 0.07207),
  ('shelf', 3, 'edge_free_top', 0.5041, 0.2627),
  ('shelf', 3, 'edge_joined', 0.2565, 0.1879),
  ('shelf', 3, 'edge_unseen', 0.01102, 0.03),
  ('shelf', 3, 'height', 1.007, 0.1101),
  ('shelf', 3, 'length', 0.6106, 0.1321),
  ('shelf', 3, 'rectangularity', 0.725, 0.1163),
  ('shelf', 3, 'spread_length', 0.4643, 0.1258),
  ('shelf', 3, 'spread_width', -1.06, 0.1463),
  ('shelf', 3, 'tilt_deg', 89.9, 1.61),
  ('shelf', 3, 'width', -0.9133, 0.1193),
  ('shelf', 3, 'z_max', 1.97, 0.1413),
  ('shelf', 3, 'z_min', 0.07181, 0.1135);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.09836, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'area_m2', -1.703, 0.3941),
  ('shelf', 4, 'aspect', 1.065, 0.3989),
  ('shelf', 4, 'behind', 0.7161, 0.1283),
  ('shelf', 4, 'edge_free', 0.3933, 0.06059),
  ('shelf', 4, 'edge_free_top', 0.4193, 0.1074),
  ('shelf', 4, 'edge_joined', 0.4043, 0.1052),
  ('shelf', 4, 'edge_unseen', 0.01184, 0.03804),
  ('shelf', 4, 'height', 0.4699, 0.06166),
  ('shelf', 4, 'length', -0.1806, 0.2521),
  ('shelf', 4, 'rectangularity', 0.6958, 0.108),
  ('shelf', 4, 'spread_length', -0.2563, 0.1306),
  ('shelf', 4, 'spread_width', -1.352, 0.201),
  ('shelf', 4, 'tilt_deg', 2.016, 1.26),
  ('shelf', 4, 'width', -1.083, 0.1822),
  ('shelf', 4, 'z_max', 0.4743, 0.05753),
  ('shelf', 4, 'z_min', 0.4783, 0.06556);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.07102, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'area_m2', -1.569, 0.3959),
  ('shelf', 5, 'aspect', 0.9121, 0.2784),
  ('shelf', 5, 'behind', 0.8277, 0.06978),
  ('shelf', 5, 'edge_free', 0.3111, 0.136),
  ('shelf', 5, 'edge_free_top', 0.4175, 0.1054),
  ('shelf', 5, 'edge_joined', 0.5861, 0.233),
  ('shelf', 5, 'edge_unseen', 0.03444, 0.07712),
  ('shelf', 5, 'height', 0.8991, 0.1454),
  ('shelf', 5, 'length', -0.08189, 0.2128),
  ('shelf', 5, 'rectangularity', 0.733, 0.1409),
  ('shelf', 5, 'spread_length', -0.3446, 0.2002),
  ('shelf', 5, 'spread_width', -1.302, 0.2752),
  ('shelf', 5, 'tilt_deg', 0.7823, 0.6772),
  ('shelf', 5, 'width', -0.9665, 0.1393),
  ('shelf', 5, 'z_max', 0.8714, 0.1363),
  ('shelf', 5, 'z_min', 0.914, 0.1393);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.06911, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'area_m2', -2.727, 0.2445),
  ('shelf', 6, 'aspect', 0.7503, 0.592),
  ('shelf', 6, 'behind', 0.5892, 0.1976),
  ('shelf', 6, 'edge_free', 0.3, 0.1351),
  ('shelf', 6, 'edge_free_top', 0.429, 0.3125),
  ('shelf', 6, 'edge_joined', 0.3414, 0.2444),
  ('shelf', 6, 'edge_unseen', 0.2547, 0.1029),
  ('shelf', 6, 'height', 0.8062, 0.5123),
  ('shelf', 6, 'length', -0.7771, 0.3462),
  ('shelf', 6, 'rectangularity', 0.6149, 0.09325),
  ('shelf', 6, 'spread_length', -0.9007, 0.2175),
  ('shelf', 6, 'spread_width', -1.817, 0.2258),
  ('shelf', 6, 'tilt_deg', 8.818, 18.74),
  ('shelf', 6, 'width', -1.531, 0.2688),
  ('shelf', 6, 'z_max', 0.7448, 0.4807),
  ('shelf', 6, 'z_min', 0.7285, 0.5294);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.07286, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'area_m2', -2.438, 0.7605),
  ('shelf', 7, 'aspect', 0.3378, 0.4282),
  ('shelf', 7, 'behind', 0.01123, 0.03),
  ('shelf', 7, 'edge_free', 0.02013, 0.05216),
  ('shelf', 7, 'edge_free_top', 0.01004, 0.03),
  ('shelf', 7, 'edge_joined', 0.07024, 0.06177),
  ('shelf', 7, 'edge_unseen', -0.001061, 0.03),
  ('shelf', 7, 'height', 0.9637, 0.5017),
  ('shelf', 7, 'length', -0.6109, 0.5453),
  ('shelf', 7, 'rectangularity', 0.7104, 0.1647),
  ('shelf', 7, 'spread_length', -0.6235, 0.5359),
  ('shelf', 7, 'spread_width', -1.348, 0.7613),
  ('shelf', 7, 'tilt_deg', 89.43, 0.852),
  ('shelf', 7, 'width', -1.23, 0.7632),
  ('shelf', 7, 'z_max', 1.044, 0.5641),
  ('shelf', 7, 'z_min', 0.5009, 0.2912);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.1063, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'area_m2', -1.176, 0.2441),
  ('shelf', 8, 'aspect', 1.162, 0.1966),
  ('shelf', 8, 'behind', 0.7972, 0.08316),
  ('shelf', 8, 'edge_free', 0.437, 0.04551),
  ('shelf', 8, 'edge_free_top', 0.5816, 0.3043),
  ('shelf', 8, 'edge_joined', 0.2017, 0.195),
  ('shelf', 8, 'edge_unseen', 0.006125, 0.03),
  ('shelf', 8, 'height', 0.6585, 0.1583),
  ('shelf', 8, 'length', 0.2057, 0.135),
  ('shelf', 8, 'rectangularity', 0.7143, 0.114),
  ('shelf', 8, 'spread_length', 0.04768, 0.1245),
  ('shelf', 8, 'spread_width', -1.144, 0.1437),
  ('shelf', 8, 'tilt_deg', 90.14, 0.6748),
  ('shelf', 8, 'width', -0.9251, 0.1322),
  ('shelf', 8, 'z_max', 1.208, 0.2387),
  ('shelf', 8, 'z_min', 0.03339, 0.02745);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.03524, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'area_m2', -2.03, 0.2705),
  ('shelf', 9, 'aspect', 0.3541, 0.1259),
  ('shelf', 9, 'behind', 0.6746, 0.1744),
  ('shelf', 9, 'edge_free', 0.2933, 0.1634),
  ('shelf', 9, 'edge_free_top', 0.3936, 0.341),
  ('shelf', 9, 'edge_joined', 0.4223, 0.3163),
  ('shelf', 9, 'edge_unseen', 0.1898, 0.1085),
  ('shelf', 9, 'height', 0.9664, 0.4812),
  ('shelf', 9, 'length', -0.6172, 0.1954),
  ('shelf', 9, 'rectangularity', 0.6568, 0.07803),
  ('shelf', 9, 'spread_length', -0.8447, 0.1473),
  ('shelf', 9, 'spread_width', -1.235, 0.1536),
  ('shelf', 9, 'tilt_deg', 26.44, 41.57),
  ('shelf', 9, 'width', -1.02, 0.1118),
  ('shelf', 9, 'z_max', 0.9817, 0.5306),
  ('shelf', 9, 'z_min', 0.8254, 0.6332);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.03385, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'area_m2', -2.294, 0.7859),
  ('shelf', 10, 'aspect', 0.7488, 0.361),
  ('shelf', 10, 'behind', -0.00507, 0.03),
  ('shelf', 10, 'edge_free', 0.1885, 0.1373),
  ('shelf', 10, 'edge_free_top', 0.4189, 0.1085),
  ('shelf', 10, 'edge_joined', 0.4236, 0.208),
  ('shelf', 10, 'edge_unseen', 0.0321, 0.08476),
  ('shelf', 10, 'height', 0.08344, 0.02972),
  ('shelf', 10, 'length', -0.6707, 0.472),
  ('shelf', 10, 'rectangularity', 0.7387, 0.08681),
  ('shelf', 10, 'spread_length', -0.6412, 0.5168),
  ('shelf', 10, 'spread_width', -1.472, 0.2423),
  ('shelf', 10, 'tilt_deg', 0.6608, 1.877),
  ('shelf', 10, 'width', -1.309, 0.3382),
  ('shelf', 10, 'z_max', 0.08722, 0.0225),
  ('shelf', 10, 'z_min', 0.08306, 0.0225);

-- cabinet: 1416 examples
UPDATE object_class SET prior = 0.09851 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.8252, 0.9345)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6569, 0.4239)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.4883, 0.2439)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.3739, 0.2751)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.7359, 0.3318)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_joined', 0.2961, 0.3142)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_unseen', 0.08467, 0.1606)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.8052, 0.3641)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.07641, 0.486)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7428, 0.1316)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.098, 0.4948)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7846, 0.5113)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 75.51, 32.71)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.585, 0.4806)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.268, 0.5827)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2603, 0.3734)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'cabinet';
DELETE FROM class_density WHERE class = 'cabinet';
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.1346, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'area_m2', -0.836, 0.4636),
  ('cabinet', 1, 'aspect', 0.4307, 0.229),
  ('cabinet', 1, 'behind', 0.5814, 0.1892),
  ('cabinet', 1, 'edge_free', 0.3145, 0.3562),
  ('cabinet', 1, 'edge_free_top', 0.8338, 0.1742),
  ('cabinet', 1, 'edge_joined', 0.378, 0.3265),
  ('cabinet', 1, 'edge_unseen', 0.2897, 0.23),
  ('cabinet', 1, 'height', 1.035, 0.3552),
  ('cabinet', 1, 'length', -0.001924, 0.2701),
  ('cabinet', 1, 'rectangularity', 0.7026, 0.1536),
  ('cabinet', 1, 'spread_length', -0.2375, 0.2133),
  ('cabinet', 1, 'spread_width', -0.6386, 0.1629),
  ('cabinet', 1, 'tilt_deg', 90.27, 0.45),
  ('cabinet', 1, 'width', -0.5044, 0.1588),
  ('cabinet', 1, 'z_max', 1.675, 0.3683),
  ('cabinet', 1, 'z_min', 0.2688, 0.3739);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.104, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'area_m2', -0.1725, 0.3031),
  ('cabinet', 2, 'aspect', 1.046, 0.4015),
  ('cabinet', 2, 'behind', 0.5061, 0.1895),
  ('cabinet', 2, 'edge_free', 0.1191, 0.06605),
  ('cabinet', 2, 'edge_free_top', 0.7415, 0.1672),
  ('cabinet', 2, 'edge_joined', 0.5305, 0.306),
  ('cabinet', 2, 'edge_unseen', 0.001966, 0.03),
  ('cabinet', 2, 'height', 1.05, 0.2333),
  ('cabinet', 2, 'length', 0.5947, 0.1948),
  ('cabinet', 2, 'rectangularity', 0.8008, 0.06701),
  ('cabinet', 2, 'spread_length', 0.3844, 0.2558),
  ('cabinet', 2, 'spread_width', -0.5641, 0.1797),
  ('cabinet', 2, 'tilt_deg', 90.23, 0.5545),
  ('cabinet', 2, 'width', -0.4813, 0.1167),
  ('cabinet', 2, 'z_max', 2.008, 0.1986),
  ('cabinet', 2, 'z_min', 0.07226, 0.1901);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.1379, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'area_m2', 0.2634, 0.4638),
  ('cabinet', 3, 'aspect', 0.8918, 0.3769),
  ('cabinet', 3, 'behind', 0.3735, 0.1794),
  ('cabinet', 3, 'edge_free', 0.5122, 0.172),
  ('cabinet', 3, 'edge_free_top', 0.9782, 0.04031),
  ('cabinet', 3, 'edge_joined', 0.04339, 0.05681),
  ('cabinet', 3, 'edge_unseen', -0.0003919, 0.03),
  ('cabinet', 3, 'height', 1.029, 0.09002),
  ('cabinet', 3, 'length', 0.6109, 0.08286),
  ('cabinet', 3, 'rectangularity', 0.9026, 0.06751),
  ('cabinet', 3, 'spread_length', 0.5222, 0.08864),
  ('cabinet', 3, 'spread_width', -0.3465, 0.1995),
  ('cabinet', 3, 'tilt_deg', 90.09, 0.7439),
  ('cabinet', 3, 'width', -0.2174, 0.277),
  ('cabinet', 3, 'z_max', 1.806, 0.09746),
  ('cabinet', 3, 'z_min', 0.02071, 0.0677);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.08973, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'area_m2', -0.3401, 0.4116),
  ('cabinet', 4, 'aspect', 0.5628, 0.2763),
  ('cabinet', 4, 'behind', 0.5247, 0.1383),
  ('cabinet', 4, 'edge_free', 0.3916, 0.2036),
  ('cabinet', 4, 'edge_free_top', 0.9644, 0.06548),
  ('cabinet', 4, 'edge_joined', 0.07319, 0.124),
  ('cabinet', 4, 'edge_unseen', 0.02462, 0.1084),
  ('cabinet', 4, 'height', 0.581, 0.1341),
  ('cabinet', 4, 'length', 0.149, 0.1555),
  ('cabinet', 4, 'rectangularity', 0.8725, 0.114),
  ('cabinet', 4, 'spread_length', -0.0138, 0.138),
  ('cabinet', 4, 'spread_width', -0.419, 0.4114),
  ('cabinet', 4, 'tilt_deg', 90.22, 0.45),
  ('cabinet', 4, 'width', -0.2962, 0.3065),
  ('cabinet', 4, 'z_max', 1.098, 0.1383),
  ('cabinet', 4, 'z_min', -0.002966, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.09891, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'area_m2', -1.181, 0.2518),
  ('cabinet', 5, 'aspect', 0.3506, 0.3672),
  ('cabinet', 5, 'behind', 0.6078, 0.097),
  ('cabinet', 5, 'edge_free', 0.2225, 0.227),
  ('cabinet', 5, 'edge_free_top', 0.6007, 0.2908),
  ('cabinet', 5, 'edge_joined', 0.2311, 0.3007),
  ('cabinet', 5, 'edge_unseen', 0.0002311, 0.03),
  ('cabinet', 5, 'height', 0.3404, 0.03678),
  ('cabinet', 5, 'length', -0.2633, 0.1655),
  ('cabinet', 5, 'rectangularity', 0.6641, 0.07572),
  ('cabinet', 5, 'spread_length', -0.5222, 0.05165),
  ('cabinet', 5, 'spread_width', -0.8726, 0.2795),
  ('cabinet', 5, 'tilt_deg', 90.08, 0.5115),
  ('cabinet', 5, 'width', -0.5266, 0.1228),
  ('cabinet', 5, 'z_max', 0.7347, 0.1062),
  ('cabinet', 5, 'z_min', -0.01684, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.07171, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'area_m2', -2.32, 0.7455),
  ('cabinet', 6, 'aspect', 0.8292, 0.9537),
  ('cabinet', 6, 'behind', 0.4024, 0.232),
  ('cabinet', 6, 'edge_free', 0.07999, 0.1153),
  ('cabinet', 6, 'edge_free_top', 0.2085, 0.3443),
  ('cabinet', 6, 'edge_joined', 0.1415, 0.1597),
  ('cabinet', 6, 'edge_unseen', 0.07634, 0.1459),
  ('cabinet', 6, 'height', 0.4062, 0.2389),
  ('cabinet', 6, 'length', -0.5325, 0.4267),
  ('cabinet', 6, 'rectangularity', 0.6591, 0.1121),
  ('cabinet', 6, 'spread_length', -0.5425, 0.4393),
  ('cabinet', 6, 'spread_width', -1.59, 0.214),
  ('cabinet', 6, 'tilt_deg', 89.48, 0.9834),
  ('cabinet', 6, 'width', -1.35, 0.3149),
  ('cabinet', 6, 'z_max', 0.7222, 0.4402),
  ('cabinet', 6, 'z_min', 0.09943, 0.1745);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.159, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'area_m2', -0.2985, 0.7104),
  ('cabinet', 7, 'aspect', 0.8099, 0.3657),
  ('cabinet', 7, 'behind', 0.1936, 0.08141),
  ('cabinet', 7, 'edge_free', 0.5589, 0.2476),
  ('cabinet', 7, 'edge_free_top', 0.9798, 0.03722),
  ('cabinet', 7, 'edge_joined', 0.04818, 0.09376),
  ('cabinet', 7, 'edge_unseen', 0.2548, 0.2713),
  ('cabinet', 7, 'height', 1.277, 0.1006),
  ('cabinet', 7, 'length', 0.4363, 0.2422),
  ('cabinet', 7, 'rectangularity', 0.7709, 0.09834),
  ('cabinet', 7, 'spread_length', -0.00401, 0.3905),
  ('cabinet', 7, 'spread_width', -0.6033, 0.6044),
  ('cabinet', 7, 'tilt_deg', 90.22, 0.45),
  ('cabinet', 7, 'width', -0.4482, 0.5369),
  ('cabinet', 7, 'z_max', 1.933, 0.1232),
  ('cabinet', 7, 'z_min', 0.3779, 0.2109);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.0963, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'area_m2', -0.7937, 0.3031),
  ('cabinet', 8, 'aspect', 0.6772, 0.2733),
  ('cabinet', 8, 'behind', 0.6831, 0.1102),
  ('cabinet', 8, 'edge_free', 0.1413, 0.1367),
  ('cabinet', 8, 'edge_free_top', 0.7362, 0.1031),
  ('cabinet', 8, 'edge_joined', 0.7829, 0.1239),
  ('cabinet', 8, 'edge_unseen', 0.07822, 0.1635),
  ('cabinet', 8, 'height', 0.9268, 0.1578),
  ('cabinet', 8, 'length', 0.07794, 0.3066),
  ('cabinet', 8, 'rectangularity', 0.6959, 0.08742),
  ('cabinet', 8, 'spread_length', -0.2479, 0.2609),
  ('cabinet', 8, 'spread_width', -0.6318, 0.09262),
  ('cabinet', 8, 'tilt_deg', -0.1833, 0.45),
  ('cabinet', 8, 'width', -0.5578, 0.08647),
  ('cabinet', 8, 'z_max', 0.8903, 0.1529),
  ('cabinet', 8, 'z_min', 0.9357, 0.1574);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.03044, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'area_m2', -2.292, 0.6119),
  ('cabinet', 9, 'aspect', 0.5567, 0.3271),
  ('cabinet', 9, 'behind', 0.7271, 0.1675),
  ('cabinet', 9, 'edge_free', 0.218, 0.1683),
  ('cabinet', 9, 'edge_free_top', 0.7371, 0.104),
  ('cabinet', 9, 'edge_joined', 0.2076, 0.1045),
  ('cabinet', 9, 'edge_unseen', 0.008413, 0.04118),
  ('cabinet', 9, 'height', 0.5827, 0.0225),
  ('cabinet', 9, 'length', -0.6459, 0.2254),
  ('cabinet', 9, 'rectangularity', 0.7143, 0.08426),
  ('cabinet', 9, 'spread_length', -0.8973, 0.2072),
  ('cabinet', 9, 'spread_width', -1.465, 0.4726),
  ('cabinet', 9, 'tilt_deg', 0.9738, 1.789),
  ('cabinet', 9, 'width', -1.255, 0.5359),
  ('cabinet', 9, 'z_max', 0.5819, 0.0225),
  ('cabinet', 9, 'z_min', 0.5809, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.02743, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'area_m2', -2.402, 0.4557),
  ('cabinet', 10, 'aspect', 0.6592, 0.3084),
  ('cabinet', 10, 'behind', 0.2016, 0.2069),
  ('cabinet', 10, 'edge_free', 0.6616, 0.3229),
  ('cabinet', 10, 'edge_free_top', 0.9732, 0.05568),
  ('cabinet', 10, 'edge_joined', 0.2346, 0.2427),
  ('cabinet', 10, 'edge_unseen', 0.408, 0.1092),
  ('cabinet', 10, 'height', 0.8625, 0.2565),
  ('cabinet', 10, 'length', -0.6675, 0.3097),
  ('cabinet', 10, 'rectangularity', 0.5939, 0.07309),
  ('cabinet', 10, 'spread_length', -0.8869, 0.3121),
  ('cabinet', 10, 'spread_width', -1.591, 0.2448),
  ('cabinet', 10, 'tilt_deg', 57.57, 53.52),
  ('cabinet', 10, 'width', -1.242, 0.2176),
  ('cabinet', 10, 'z_max', 1.015, 0.1924),
  ('cabinet', 10, 'z_min', 0.7062, 0.4071);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.0377 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.393 WHERE name = 'aspect';
UPDATE feature SET weight = 0.49 WHERE name = 'behind';
UPDATE feature SET weight = 0.484 WHERE name = 'edge_free';
UPDATE feature SET weight = 0.294 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.208 WHERE name = 'edge_joined';
UPDATE feature SET weight = 0.265 WHERE name = 'edge_unseen';
UPDATE feature SET weight = 0.196 WHERE name = 'height';
UPDATE feature SET weight = 0 WHERE name = 'length';
UPDATE feature SET weight = 0.5 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.347 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.222 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.5 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.189 WHERE name = 'width';
UPDATE feature SET weight = 0.476 WHERE name = 'z_max';
UPDATE feature SET weight = 0.444 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.178 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0493 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0272 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.186 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0127 WHERE name = 'table';
UPDATE object_class SET prior = 0.0277 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.229 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.00292 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0378 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0116 WHERE name = 'door';
UPDATE object_class SET prior = 0.0284 WHERE name = 'window';
UPDATE object_class SET prior = 0.00857 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.083 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.118 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.72 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.555 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 1.58 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.51 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 2.5 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.51 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 0.0294 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.0847 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.756 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 0.527 WHERE name = 'wall_in_one_plane';
UPDATE class_constraint SET weight = 0.881 WHERE name = 'cabinet_off_wall';
UPDATE class_constraint SET weight = 1.03 WHERE name = 'window_off_wall';
UPDATE class_constraint SET weight = 2.11 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.86 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.91 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.663 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.37 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 3.46 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 3.9 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.69 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.789 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.02 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 1.18 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.914 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 1.57 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.29 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 3.56 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.75 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.37 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.518 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.37 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.77 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.69 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.256 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 0.998 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2446 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.825' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.254' WHERE key = 'probability_offset';
