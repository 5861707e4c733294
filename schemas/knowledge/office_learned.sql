-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 17604 planes of 180 paper-like rooms, seeds from 1; 90 at 2 cm, seeds from 10101; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 60 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 7199 examples
UPDATE object_class SET prior = 0.3263 WHERE name = 'unknown';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.02564, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'area_m2', -2.633, 0.3014),
  ('unknown', 1, 'aspect', 0.3641, 0.2383),
  ('unknown', 1, 'behind', 0.6294, 0.1601),
  ('unknown', 1, 'edge_free', 0.4873, 0.1296),
  ('unknown', 1, 'edge_free_top', 0.7624, 0.211),
  ('unknown', 1, 'edge_joined', 0.1968, 0.1848),
  ('unknown', 1, 'edge_unseen', 0.003916, 0.036),
  ('unknown', 1, 'height', 0.1901, 0.0225),
  ('unknown', 1, 'length', -0.9358, 0.1758),
  ('unknown', 1, 'rectangularity', 0.6837, 0.1547),
  ('unknown', 1, 'spread_length', -1.091, 0.1728),
  ('unknown', 1, 'spread_width', -1.667, 0.1924),
  ('unknown', 1, 'tilt_deg', 89.11, 2.031),
  ('unknown', 1, 'width', -1.281, 0.2728),
  ('unknown', 1, 'z_max', 0.3838, 0.0491),
  ('unknown', 1, 'z_min', -0.007776, 0.03992);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.02746, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'area_m2', -1.943, 0.3606),
  ('unknown', 2, 'aspect', 0.3082, 0.2421),
  ('unknown', 2, 'behind', 0.6468, 0.1965),
  ('unknown', 2, 'edge_free', 0.3893, 0.137),
  ('unknown', 2, 'edge_free_top', 0.5593, 0.2751),
  ('unknown', 2, 'edge_joined', 0.3364, 0.2253),
  ('unknown', 2, 'edge_unseen', 0.005725, 0.03),
  ('unknown', 2, 'height', 0.2426, 0.05436),
  ('unknown', 2, 'length', -0.4756, 0.1919),
  ('unknown', 2, 'rectangularity', 0.4718, 0.129),
  ('unknown', 2, 'spread_length', -0.6227, 0.2099),
  ('unknown', 2, 'spread_width', -1.184, 0.3193),
  ('unknown', 2, 'tilt_deg', 88.91, 1.444),
  ('unknown', 2, 'width', -0.8115, 0.242),
  ('unknown', 2, 'z_max', 0.5396, 0.1114),
  ('unknown', 2, 'z_min', -0.0149, 0.03147);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.02417, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'area_m2', -1.299, 0.1514),
  ('unknown', 3, 'aspect', 1.715, 0.1655),
  ('unknown', 3, 'behind', 0.2766, 0.2879),
  ('unknown', 3, 'edge_free', 0.8815, 0.1358),
  ('unknown', 3, 'edge_free_top', 0.5532, 0.1302),
  ('unknown', 3, 'edge_joined', 0.1097, 0.1287),
  ('unknown', 3, 'edge_unseen', 0.01181, 0.03257),
  ('unknown', 3, 'height', 2.514, 0.2811),
  ('unknown', 3, 'length', 0.2951, 0.1101),
  ('unknown', 3, 'rectangularity', 0.8584, 0.04707),
  ('unknown', 3, 'spread_length', 0.2425, 0.122),
  ('unknown', 3, 'spread_width', -1.552, 0.05295),
  ('unknown', 3, 'tilt_deg', 0.828, 1.43),
  ('unknown', 3, 'width', -1.442, 0.106),
  ('unknown', 3, 'z_max', 2.546, 0.3078),
  ('unknown', 3, 'z_min', 2.537, 0.3042);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.03341, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'area_m2', -2.641, 0.2593),
  ('unknown', 4, 'aspect', 0.49, 0.338),
  ('unknown', 4, 'behind', 0.5832, 0.1947),
  ('unknown', 4, 'edge_free', 0.6051, 0.1016),
  ('unknown', 4, 'edge_free_top', 0.973, 0.0485),
  ('unknown', 4, 'edge_joined', 0.09269, 0.1103),
  ('unknown', 4, 'edge_unseen', 0.006486, 0.03323),
  ('unknown', 4, 'height', 0.859, 0.03519),
  ('unknown', 4, 'length', -0.9645, 0.259),
  ('unknown', 4, 'rectangularity', 0.7345, 0.1046),
  ('unknown', 4, 'spread_length', -1.263, 0.1433),
  ('unknown', 4, 'spread_width', -1.525, 0.1736),
  ('unknown', 4, 'tilt_deg', 83.05, 10.2),
  ('unknown', 4, 'width', -1.404, 0.1941),
  ('unknown', 4, 'z_max', 0.9708, 0.06561),
  ('unknown', 4, 'z_min', 0.7343, 0.04396);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.03068, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'area_m2', -1.577, 0.4986),
  ('unknown', 5, 'aspect', 0.8694, 0.5361),
  ('unknown', 5, 'behind', 0.3909, 0.1814),
  ('unknown', 5, 'edge_free', 0.3286, 0.3394),
  ('unknown', 5, 'edge_free_top', 0.4266, 0.2929),
  ('unknown', 5, 'edge_joined', 0.3803, 0.3201),
  ('unknown', 5, 'edge_unseen', 0.1127, 0.1033),
  ('unknown', 5, 'height', 1.387, 0.1526),
  ('unknown', 5, 'length', -0.1723, 0.2925),
  ('unknown', 5, 'rectangularity', 0.721, 0.1062),
  ('unknown', 5, 'spread_length', -0.391, 0.1763),
  ('unknown', 5, 'spread_width', -1.317, 0.5014),
  ('unknown', 5, 'tilt_deg', 87.78, 1.236),
  ('unknown', 5, 'width', -1.062, 0.4609),
  ('unknown', 5, 'z_max', 1.739, 0.1179),
  ('unknown', 5, 'z_min', 0.9339, 0.1186);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.05264, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'area_m2', -1.566, 0.5512),
  ('unknown', 6, 'aspect', 0.8687, 0.4139),
  ('unknown', 6, 'behind', 0.4974, 0.1768),
  ('unknown', 6, 'edge_free', 0.4133, 0.2732),
  ('unknown', 6, 'edge_free_top', 0.329, 0.2496),
  ('unknown', 6, 'edge_joined', 0.325, 0.2747),
  ('unknown', 6, 'edge_unseen', 0.06937, 0.07153),
  ('unknown', 6, 'height', 0.5016, 0.111),
  ('unknown', 6, 'length', -0.1865, 0.2532),
  ('unknown', 6, 'rectangularity', 0.6637, 0.151),
  ('unknown', 6, 'spread_length', -0.2184, 0.3589),
  ('unknown', 6, 'spread_width', -1.225, 0.4503),
  ('unknown', 6, 'tilt_deg', 88.42, 0.945),
  ('unknown', 6, 'width', -0.923, 0.4423),
  ('unknown', 6, 'z_max', 0.7552, 0.1681),
  ('unknown', 6, 'z_min', 0.2309, 0.1539);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.0337, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'area_m2', -0.7636, 0.4059),
  ('unknown', 7, 'aspect', 0.2746, 0.2066),
  ('unknown', 7, 'behind', 0.67, 0.1622),
  ('unknown', 7, 'edge_free', 0.438, 0.2007),
  ('unknown', 7, 'edge_free_top', 0.3331, 0.1776),
  ('unknown', 7, 'edge_joined', 0.2899, 0.1995),
  ('unknown', 7, 'edge_unseen', 0.007558, 0.03224),
  ('unknown', 7, 'height', 0.4269, 0.08873),
  ('unknown', 7, 'length', -0.02805, 0.1884),
  ('unknown', 7, 'rectangularity', 0.651, 0.1117),
  ('unknown', 7, 'spread_length', -0.2187, 0.128),
  ('unknown', 7, 'spread_width', -0.5685, 0.2467),
  ('unknown', 7, 'tilt_deg', 89.34, 1.621),
  ('unknown', 7, 'width', -0.2886, 0.09966),
  ('unknown', 7, 'z_max', 0.7392, 0.04861),
  ('unknown', 7, 'z_min', 0.01369, 0.06067);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.03529, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'area_m2', -0.3901, 0.2743),
  ('unknown', 8, 'aspect', 0.4803, 0.2392),
  ('unknown', 8, 'behind', 0.4418, 0.06713),
  ('unknown', 8, 'edge_free', 0.8836, 0.124),
  ('unknown', 8, 'edge_free_top', 0.9902, 0.04158),
  ('unknown', 8, 'edge_joined', 0.04103, 0.0516),
  ('unknown', 8, 'edge_unseen', 0.06051, 0.1031),
  ('unknown', 8, 'height', 0.4972, 0.03704),
  ('unknown', 8, 'length', 0.09178, 0.231),
  ('unknown', 8, 'rectangularity', 0.8174, 0.08058),
  ('unknown', 8, 'spread_length', 0.04861, 0.2599),
  ('unknown', 8, 'spread_width', -0.4752, 0.08527),
  ('unknown', 8, 'tilt_deg', 89.6, 1.293),
  ('unknown', 8, 'width', -0.3468, 0.1505),
  ('unknown', 8, 'z_max', 0.784, 0.06877),
  ('unknown', 8, 'z_min', 0.08312, 0.0515);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.03087, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'area_m2', -1.178, 0.2805),
  ('unknown', 9, 'aspect', 0.3899, 0.3124),
  ('unknown', 9, 'behind', 0.01194, 0.03145),
  ('unknown', 9, 'edge_free', 0.01806, 0.03769),
  ('unknown', 9, 'edge_free_top', 0.02478, 0.0696),
  ('unknown', 9, 'edge_joined', 0.9198, 0.08727),
  ('unknown', 9, 'edge_unseen', 0.04667, 0.1092),
  ('unknown', 9, 'height', 1.632, 0.08295),
  ('unknown', 9, 'length', -0.2932, 0.1511),
  ('unknown', 9, 'rectangularity', 0.8062, 0.069),
  ('unknown', 9, 'spread_length', -0.4562, 0.1563),
  ('unknown', 9, 'spread_width', -1.003, 0.2373),
  ('unknown', 9, 'tilt_deg', 89.83, 0.8848),
  ('unknown', 9, 'width', -0.6944, 0.3205),
  ('unknown', 9, 'z_max', 1.981, 0.158),
  ('unknown', 9, 'z_min', 1.332, 0.06433);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.03137, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'area_m2', -1.288, 0.2604),
  ('unknown', 10, 'aspect', 1.658, 0.2046),
  ('unknown', 10, 'behind', 0.584, 0.242),
  ('unknown', 10, 'edge_free', 0.1998, 0.1876),
  ('unknown', 10, 'edge_free_top', 0.007647, 0.03),
  ('unknown', 10, 'edge_joined', 0.4066, 0.2977),
  ('unknown', 10, 'edge_unseen', 0.0194, 0.04096),
  ('unknown', 10, 'height', 1.506, 0.08334),
  ('unknown', 10, 'length', 0.3206, 0.1377),
  ('unknown', 10, 'rectangularity', 0.7871, 0.06138),
  ('unknown', 10, 'spread_length', 0.143, 0.1184),
  ('unknown', 10, 'spread_width', -1.534, 0.2343),
  ('unknown', 10, 'tilt_deg', 89.84, 0.9773),
  ('unknown', 10, 'width', -1.381, 0.2422),
  ('unknown', 10, 'z_max', 2.222, 0.1745),
  ('unknown', 10, 'z_min', 0.8378, 0.08142);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.03749, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'area_m2', -1.809, 0.3591),
  ('unknown', 11, 'aspect', 0.6724, 0.3642),
  ('unknown', 11, 'behind', 0.6911, 0.12),
  ('unknown', 11, 'edge_free', 0.1857, 0.124),
  ('unknown', 11, 'edge_free_top', 0.5473, 0.127),
  ('unknown', 11, 'edge_joined', 0.5869, 0.2524),
  ('unknown', 11, 'edge_unseen', 0.08889, 0.1007),
  ('unknown', 11, 'height', 0.8337, 0.2163),
  ('unknown', 11, 'length', -0.3337, 0.3125),
  ('unknown', 11, 'rectangularity', 0.6735, 0.08354),
  ('unknown', 11, 'spread_length', -0.5282, 0.311),
  ('unknown', 11, 'spread_width', -1.231, 0.2208),
  ('unknown', 11, 'tilt_deg', 5.144, 1.588),
  ('unknown', 11, 'width', -1.081, 0.2675),
  ('unknown', 11, 'z_max', 0.86, 0.2291),
  ('unknown', 11, 'z_min', 0.7917, 0.2417);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.04349, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'area_m2', -2.705, 0.4752),
  ('unknown', 12, 'aspect', 0.343, 0.2466),
  ('unknown', 12, 'behind', 0.2665, 0.24),
  ('unknown', 12, 'edge_free', 0.6583, 0.1668),
  ('unknown', 12, 'edge_free_top', 0.5569, 0.1345),
  ('unknown', 12, 'edge_joined', 0.308, 0.1652),
  ('unknown', 12, 'edge_unseen', 0.003697, 0.03),
  ('unknown', 12, 'height', 0.8663, 0.1179),
  ('unknown', 12, 'length', -1.077, 0.1931),
  ('unknown', 12, 'rectangularity', 0.8181, 0.07513),
  ('unknown', 12, 'spread_length', -1.21, 0.1504),
  ('unknown', 12, 'spread_width', -1.527, 0.2379),
  ('unknown', 12, 'tilt_deg', 0.7426, 1.117),
  ('unknown', 12, 'width', -1.432, 0.2866),
  ('unknown', 12, 'z_max', 0.8688, 0.1266),
  ('unknown', 12, 'z_min', 0.8616, 0.1246);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.02226, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'area_m2', -3.178, 0.2924),
  ('unknown', 13, 'aspect', 0.3779, 0.2395),
  ('unknown', 13, 'behind', 0.4736, 0.1829),
  ('unknown', 13, 'edge_free', 0.6129, 0.1229),
  ('unknown', 13, 'edge_free_top', 0.9917, 0.03138),
  ('unknown', 13, 'edge_joined', 0.07028, 0.1098),
  ('unknown', 13, 'edge_unseen', 0.003181, 0.03),
  ('unknown', 13, 'height', 1.244, 0.5223),
  ('unknown', 13, 'length', -1.31, 0.2131),
  ('unknown', 13, 'rectangularity', 0.8221, 0.09228),
  ('unknown', 13, 'spread_length', -1.402, 0.1747),
  ('unknown', 13, 'spread_width', -1.779, 0.1885),
  ('unknown', 13, 'tilt_deg', 89.06, 1.596),
  ('unknown', 13, 'width', -1.663, 0.1922),
  ('unknown', 13, 'z_max', 1.346, 0.5211),
  ('unknown', 13, 'z_min', 1.133, 0.5034);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.01503, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'area_m2', -1.956, 0.4485),
  ('unknown', 14, 'aspect', 0.5232, 0.286),
  ('unknown', 14, 'behind', 0.3771, 0.132),
  ('unknown', 14, 'edge_free', 0.8404, 0.2188),
  ('unknown', 14, 'edge_free_top', 0.9874, 0.03609),
  ('unknown', 14, 'edge_joined', 0.01176, 0.03),
  ('unknown', 14, 'edge_unseen', 0.1838, 0.1501),
  ('unknown', 14, 'height', 0.7847, 0.2507),
  ('unknown', 14, 'length', -0.536, 0.2601),
  ('unknown', 14, 'rectangularity', 0.6381, 0.09978),
  ('unknown', 14, 'spread_length', -0.7261, 0.3422),
  ('unknown', 14, 'spread_width', -1.247, 0.275),
  ('unknown', 14, 'tilt_deg', 85, 8.133),
  ('unknown', 14, 'width', -1.029, 0.277),
  ('unknown', 14, 'z_max', 1.04, 0.2535),
  ('unknown', 14, 'z_min', 0.5495, 0.1258);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.02144, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'area_m2', -1.924, 0.1889),
  ('unknown', 15, 'aspect', 0.5691, 0.2614),
  ('unknown', 15, 'behind', 0.5395, 0.2721),
  ('unknown', 15, 'edge_free', 0.4124, 0.1684),
  ('unknown', 15, 'edge_free_top', 0.623, 0.232),
  ('unknown', 15, 'edge_joined', 0.3291, 0.1265),
  ('unknown', 15, 'edge_unseen', 0.003774, 0.03),
  ('unknown', 15, 'height', 1.04, 0.1748),
  ('unknown', 15, 'length', -0.4998, 0.172),
  ('unknown', 15, 'rectangularity', 0.6504, 0.09577),
  ('unknown', 15, 'spread_length', -0.7444, 0.2623),
  ('unknown', 15, 'spread_width', -1.302, 0.2494),
  ('unknown', 15, 'tilt_deg', 88.45, 2.923),
  ('unknown', 15, 'width', -1.014, 0.1924),
  ('unknown', 15, 'z_max', 1.396, 0.1004),
  ('unknown', 15, 'z_min', 0.7581, 0.2181);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.01628, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'area_m2', -1.514, 0.4653),
  ('unknown', 16, 'aspect', 1.613, 0.3174),
  ('unknown', 16, 'behind', 0.6546, 0.05681),
  ('unknown', 16, 'edge_free', 0.1535, 0.1758),
  ('unknown', 16, 'edge_free_top', 0.5544, 0.1281),
  ('unknown', 16, 'edge_joined', 0.7223, 0.215),
  ('unknown', 16, 'edge_unseen', 0.03964, 0.06106),
  ('unknown', 16, 'height', 2.138, 0.1409),
  ('unknown', 16, 'length', 0.1988, 0.2818),
  ('unknown', 16, 'rectangularity', 0.7602, 0.06517),
  ('unknown', 16, 'spread_length', 0.01813, 0.4177),
  ('unknown', 16, 'spread_width', -1.552, 0.199),
  ('unknown', 16, 'tilt_deg', 1.049, 1.922),
  ('unknown', 16, 'width', -1.431, 0.2129),
  ('unknown', 16, 'z_max', 2.145, 0.1536),
  ('unknown', 16, 'z_min', 2.138, 0.1359);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.03394, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'area_m2', -2.507, 0.3465),
  ('unknown', 17, 'aspect', 0.4982, 0.2758),
  ('unknown', 17, 'behind', 0.5726, 0.269),
  ('unknown', 17, 'edge_free', 0.4924, 0.1889),
  ('unknown', 17, 'edge_free_top', 0.6552, 0.2782),
  ('unknown', 17, 'edge_joined', 0.2727, 0.1593),
  ('unknown', 17, 'edge_unseen', 0.003836, 0.03),
  ('unknown', 17, 'height', 1.623, 0.2617),
  ('unknown', 17, 'length', -0.8421, 0.218),
  ('unknown', 17, 'rectangularity', 0.6654, 0.09636),
  ('unknown', 17, 'spread_length', -1.107, 0.1837),
  ('unknown', 17, 'spread_width', -1.533, 0.2165),
  ('unknown', 17, 'tilt_deg', 88.47, 2.191),
  ('unknown', 17, 'width', -1.268, 0.2616),
  ('unknown', 17, 'z_max', 1.811, 0.2765),
  ('unknown', 17, 'z_min', 1.389, 0.2435);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.01806, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'area_m2', -2.914, 0.3322),
  ('unknown', 18, 'aspect', 0.6355, 0.2385),
  ('unknown', 18, 'behind', 0.3398, 0.1184),
  ('unknown', 18, 'edge_free', 0.2726, 0.2441),
  ('unknown', 18, 'edge_free_top', 0.2062, 0.2608),
  ('unknown', 18, 'edge_joined', 0.2805, 0.2866),
  ('unknown', 18, 'edge_unseen', 0.1062, 0.1544),
  ('unknown', 18, 'height', 0.3032, 0.1511),
  ('unknown', 18, 'length', -0.914, 0.2724),
  ('unknown', 18, 'rectangularity', 0.6933, 0.1354),
  ('unknown', 18, 'spread_length', -1.11, 0.3095),
  ('unknown', 18, 'spread_width', -1.819, 0.2289),
  ('unknown', 18, 'tilt_deg', 86.95, 3.523),
  ('unknown', 18, 'width', -1.589, 0.2339),
  ('unknown', 18, 'z_max', 0.4751, 0.115),
  ('unknown', 18, 'z_min', 0.1393, 0.1477);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.02342, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'area_m2', -2.423, 0.2267),
  ('unknown', 19, 'aspect', 0.3233, 0.2017),
  ('unknown', 19, 'behind', 0.6188, 0.1916),
  ('unknown', 19, 'edge_free', 0.3997, 0.1858),
  ('unknown', 19, 'edge_free_top', 0.5827, 0.2923),
  ('unknown', 19, 'edge_joined', 0.3291, 0.2309),
  ('unknown', 19, 'edge_unseen', 0.006178, 0.0312),
  ('unknown', 19, 'height', 0.8417, 0.1831),
  ('unknown', 19, 'length', -0.8977, 0.1492),
  ('unknown', 19, 'rectangularity', 0.6726, 0.04258),
  ('unknown', 19, 'spread_length', -1.153, 0.1119),
  ('unknown', 19, 'spread_width', -1.386, 0.1416),
  ('unknown', 19, 'tilt_deg', 89.36, 1.409),
  ('unknown', 19, 'width', -1.18, 0.1369),
  ('unknown', 19, 'z_max', 1.035, 0.1811),
  ('unknown', 19, 'z_min', 0.6674, 0.2029);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.01933, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'area_m2', -3, 0.4418),
  ('unknown', 20, 'aspect', 0.5001, 0.2941),
  ('unknown', 20, 'behind', 0.3682, 0.2524),
  ('unknown', 20, 'edge_free', 0.4504, 0.2792),
  ('unknown', 20, 'edge_free_top', 0.711, 0.3159),
  ('unknown', 20, 'edge_joined', 0.3362, 0.2868),
  ('unknown', 20, 'edge_unseen', 0.2075, 0.1447),
  ('unknown', 20, 'height', 0.9045, 0.1791),
  ('unknown', 20, 'length', -1.084, 0.272),
  ('unknown', 20, 'rectangularity', 0.6983, 0.072),
  ('unknown', 20, 'spread_length', -1.254, 0.281),
  ('unknown', 20, 'spread_width', -1.77, 0.2408),
  ('unknown', 20, 'tilt_deg', 43.9, 25.57),
  ('unknown', 20, 'width', -1.564, 0.2784),
  ('unknown', 20, 'z_max', 0.9879, 0.2176),
  ('unknown', 20, 'z_min', 0.8068, 0.1919);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.02482, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'area_m2', -2.826, 0.1888),
  ('unknown', 21, 'aspect', 0.3027, 0.1672),
  ('unknown', 21, 'behind', 0.3137, 0.1991),
  ('unknown', 21, 'edge_free', 0.05833, 0.1045),
  ('unknown', 21, 'edge_free_top', 0.5536, 0.1302),
  ('unknown', 21, 'edge_joined', 0.8508, 0.1341),
  ('unknown', 21, 'edge_unseen', 0.004964, 0.03),
  ('unknown', 21, 'height', 0.75, 0.06325),
  ('unknown', 21, 'length', -1.155, 0.1418),
  ('unknown', 21, 'rectangularity', 0.8295, 0.07876),
  ('unknown', 21, 'spread_length', -1.274, 0.1167),
  ('unknown', 21, 'spread_width', -1.569, 0.06737),
  ('unknown', 21, 'tilt_deg', 0.3364, 0.8618),
  ('unknown', 21, 'width', -1.484, 0.1103),
  ('unknown', 21, 'z_max', 0.7514, 0.06772),
  ('unknown', 21, 'z_min', 0.7438, 0.0588);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.02926, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'area_m2', -0.4741, 0.6919),
  ('unknown', 22, 'aspect', 0.6484, 0.2548),
  ('unknown', 22, 'behind', 0.5154, 0.3056),
  ('unknown', 22, 'edge_free', 0.2852, 0.2376),
  ('unknown', 22, 'edge_free_top', 0.3099, 0.2434),
  ('unknown', 22, 'edge_joined', 0.613, 0.1896),
  ('unknown', 22, 'edge_unseen', 0.002644, 0.03),
  ('unknown', 22, 'height', 1.056, 0.3284),
  ('unknown', 22, 'length', 0.5964, 0.2235),
  ('unknown', 22, 'rectangularity', 0.5614, 0.1642),
  ('unknown', 22, 'spread_length', 0.5054, 0.199),
  ('unknown', 22, 'spread_width', -0.5606, 0.754),
  ('unknown', 22, 'tilt_deg', 88.13, 0.8676),
  ('unknown', 22, 'width', -0.4105, 0.6239),
  ('unknown', 22, 'z_max', 1.996, 0.3409),
  ('unknown', 22, 'z_min', 0.1135, 0.1758);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.02188, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'area_m2', -3.576, 0.3006),
  ('unknown', 23, 'aspect', 0.221, 0.1342),
  ('unknown', 23, 'behind', 0.3148, 0.2259),
  ('unknown', 23, 'edge_free', 0.3662, 0.2922),
  ('unknown', 23, 'edge_free_top', 0.3727, 0.3753),
  ('unknown', 23, 'edge_joined', 0.4967, 0.3284),
  ('unknown', 23, 'edge_unseen', 0.00252, 0.03),
  ('unknown', 23, 'height', 0.8181, 0.2551),
  ('unknown', 23, 'length', -1.537, 0.1666),
  ('unknown', 23, 'rectangularity', 0.7815, 0.05946),
  ('unknown', 23, 'spread_length', -1.669, 0.1905),
  ('unknown', 23, 'spread_width', -1.91, 0.1482),
  ('unknown', 23, 'tilt_deg', 25.01, 24.59),
  ('unknown', 23, 'width', -1.786, 0.1465),
  ('unknown', 23, 'z_max', 0.8269, 0.1886),
  ('unknown', 23, 'z_min', 0.7729, 0.1864);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.01753, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'area_m2', -2.277, 0.3743),
  ('unknown', 24, 'aspect', 0.5481, 0.2167),
  ('unknown', 24, 'behind', 0.7338, 0.07922),
  ('unknown', 24, 'edge_free', 0.6999, 0.1727),
  ('unknown', 24, 'edge_free_top', 0.5532, 0.1316),
  ('unknown', 24, 'edge_joined', 0.2603, 0.09166),
  ('unknown', 24, 'edge_unseen', 0.0008167, 0.03),
  ('unknown', 24, 'height', 0.3889, 0.09113),
  ('unknown', 24, 'length', -0.7642, 0.2445),
  ('unknown', 24, 'rectangularity', 0.7999, 0.1013),
  ('unknown', 24, 'spread_length', -0.9421, 0.1697),
  ('unknown', 24, 'spread_width', -1.499, 0.1362),
  ('unknown', 24, 'tilt_deg', 1.289, 2.309),
  ('unknown', 24, 'width', -1.249, 0.2842),
  ('unknown', 24, 'z_max', 0.3767, 0.09156),
  ('unknown', 24, 'z_min', 0.3503, 0.06325);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.02946, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'area_m2', -1.358, 0.4059),
  ('unknown', 25, 'aspect', 0.7967, 0.3965),
  ('unknown', 25, 'behind', 0.7761, 0.07603),
  ('unknown', 25, 'edge_free', 0.2355, 0.1078),
  ('unknown', 25, 'edge_free_top', 0.5516, 0.1293),
  ('unknown', 25, 'edge_joined', 0.7278, 0.1028),
  ('unknown', 25, 'edge_unseen', 0.01156, 0.03643),
  ('unknown', 25, 'height', 1.194, 0.2528),
  ('unknown', 25, 'length', -0.03892, 0.3377),
  ('unknown', 25, 'rectangularity', 0.6629, 0.1269),
  ('unknown', 25, 'spread_length', -0.1707, 0.2452),
  ('unknown', 25, 'spread_width', -1.004, 0.3747),
  ('unknown', 25, 'tilt_deg', 7.013, 2.272),
  ('unknown', 25, 'width', -0.891, 0.2604),
  ('unknown', 25, 'z_max', 1.249, 0.2669),
  ('unknown', 25, 'z_min', 1.182, 0.2741);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.01958, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'area_m2', -2.054, 0.5078),
  ('unknown', 26, 'aspect', 1.078, 0.3738),
  ('unknown', 26, 'behind', 0.2513, 0.269),
  ('unknown', 26, 'edge_free', 0.9848, 0.03203),
  ('unknown', 26, 'edge_free_top', 0.5534, 0.1302),
  ('unknown', 26, 'edge_joined', 0.01289, 0.03128),
  ('unknown', 26, 'edge_unseen', 0.2156, 0.1181),
  ('unknown', 26, 'height', 2.493, 0.2562),
  ('unknown', 26, 'length', -0.3344, 0.4503),
  ('unknown', 26, 'rectangularity', 0.7898, 0.09349),
  ('unknown', 26, 'spread_length', -0.4843, 0.4355),
  ('unknown', 26, 'spread_width', -1.606, 0.08557),
  ('unknown', 26, 'tilt_deg', 1.451, 1.978),
  ('unknown', 26, 'width', -1.488, 0.09389),
  ('unknown', 26, 'z_max', 2.528, 0.2652),
  ('unknown', 26, 'z_min', 2.519, 0.2621);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.03738, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'area_m2', -0.7941, 0.526),
  ('unknown', 27, 'aspect', 0.2459, 0.2024),
  ('unknown', 27, 'behind', 0.4774, 0.1751),
  ('unknown', 27, 'edge_free', 0.6596, 0.1747),
  ('unknown', 27, 'edge_free_top', 0.8405, 0.1609),
  ('unknown', 27, 'edge_joined', 0.1479, 0.09442),
  ('unknown', 27, 'edge_unseen', 0.003256, 0.03),
  ('unknown', 27, 'height', 0.8648, 0.3206),
  ('unknown', 27, 'length', -0.07709, 0.2543),
  ('unknown', 27, 'rectangularity', 0.7053, 0.09602),
  ('unknown', 27, 'spread_length', -0.2154, 0.2471),
  ('unknown', 27, 'spread_width', -0.6313, 0.3302),
  ('unknown', 27, 'tilt_deg', 77.29, 5.882),
  ('unknown', 27, 'width', -0.3663, 0.2474),
  ('unknown', 27, 'z_max', 1.271, 0.2482),
  ('unknown', 27, 'z_min', 0.3006, 0.2886);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.009518, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'area_m2', -2.385, 0.3356),
  ('unknown', 28, 'aspect', 0.467, 0.3294),
  ('unknown', 28, 'behind', 0.01408, 0.04241),
  ('unknown', 28, 'edge_free', 0.03291, 0.03),
  ('unknown', 28, 'edge_free_top', 0.03128, 0.06088),
  ('unknown', 28, 'edge_joined', 0.8343, 0.184),
  ('unknown', 28, 'edge_unseen', 0.0735, 0.1079),
  ('unknown', 28, 'height', 1.621, 0.2104),
  ('unknown', 28, 'length', -0.8389, 0.2434),
  ('unknown', 28, 'rectangularity', 0.7414, 0.06253),
  ('unknown', 28, 'spread_length', -1.012, 0.1995),
  ('unknown', 28, 'spread_width', -1.505, 0.2559),
  ('unknown', 28, 'tilt_deg', 88.89, 2.683),
  ('unknown', 28, 'width', -1.27, 0.2111),
  ('unknown', 28, 'z_max', 1.849, 0.1795),
  ('unknown', 28, 'z_min', 1.434, 0.2261);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.02828, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'area_m2', 3.26, 0.8462),
  ('unknown', 29, 'aspect', 0.3458, 0.2253),
  ('unknown', 29, 'behind', 0.002953, 0.03),
  ('unknown', 29, 'edge_free', 0.006199, 0.03),
  ('unknown', 29, 'edge_free_top', 0.009467, 0.03),
  ('unknown', 29, 'edge_joined', 0.05972, 0.102),
  ('unknown', 29, 'edge_unseen', 0.08939, 0.1258),
  ('unknown', 29, 'height', 2.196, 0.8286),
  ('unknown', 29, 'length', 1.954, 0.3756),
  ('unknown', 29, 'rectangularity', 0.8735, 0.1115),
  ('unknown', 29, 'spread_length', 1.807, 0.4712),
  ('unknown', 29, 'spread_width', 1.468, 0.4219),
  ('unknown', 29, 'tilt_deg', 89.82, 1.131),
  ('unknown', 29, 'width', 1.524, 0.4783),
  ('unknown', 29, 'z_max', 5.468, 2.391),
  ('unknown', 29, 'z_min', -0.871, 1.345);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.01085, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'area_m2', -2.86, 0.557),
  ('unknown', 30, 'aspect', 0.6447, 0.2732),
  ('unknown', 30, 'behind', 0.5081, 0.319),
  ('unknown', 30, 'edge_free', 0.4366, 0.2815),
  ('unknown', 30, 'edge_free_top', 0.4571, 0.3993),
  ('unknown', 30, 'edge_joined', 0.3545, 0.272),
  ('unknown', 30, 'edge_unseen', 0.1845, 0.1446),
  ('unknown', 30, 'height', 2.143, 0.5312),
  ('unknown', 30, 'length', -0.891, 0.3769),
  ('unknown', 30, 'rectangularity', 0.6907, 0.1113),
  ('unknown', 30, 'spread_length', -1.045, 0.3521),
  ('unknown', 30, 'spread_width', -1.76, 0.2293),
  ('unknown', 30, 'tilt_deg', 31.73, 29.86),
  ('unknown', 30, 'width', -1.566, 0.2631),
  ('unknown', 30, 'z_max', 2.238, 0.5732),
  ('unknown', 30, 'z_min', 2.114, 0.6382);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.01293, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'area_m2', -2.983, 0.3148),
  ('unknown', 31, 'aspect', 0.5793, 0.2486),
  ('unknown', 31, 'behind', 0.7536, 0.07591),
  ('unknown', 31, 'edge_free', 0.2428, 0.1386),
  ('unknown', 31, 'edge_free_top', 0.3145, 0.3065),
  ('unknown', 31, 'edge_joined', 0.4681, 0.2718),
  ('unknown', 31, 'edge_unseen', 0.001957, 0.03),
  ('unknown', 31, 'height', 0.9602, 0.3007),
  ('unknown', 31, 'length', -1.026, 0.2218),
  ('unknown', 31, 'rectangularity', 0.6881, 0.09511),
  ('unknown', 31, 'spread_length', -1.183, 0.204),
  ('unknown', 31, 'spread_width', -1.726, 0.2081),
  ('unknown', 31, 'tilt_deg', 72.02, 25.39),
  ('unknown', 31, 'width', -1.58, 0.2238),
  ('unknown', 31, 'z_max', 1.095, 0.331),
  ('unknown', 31, 'z_min', 0.834, 0.3166);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.01874, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'area_m2', -2.878, 0.4143),
  ('unknown', 32, 'aspect', 0.5147, 0.2604),
  ('unknown', 32, 'behind', 0.4207, 0.2551),
  ('unknown', 32, 'edge_free', 0.5737, 0.2238),
  ('unknown', 32, 'edge_free_top', 0.9213, 0.1061),
  ('unknown', 32, 'edge_joined', 0.1847, 0.1731),
  ('unknown', 32, 'edge_unseen', 0.163, 0.1571),
  ('unknown', 32, 'height', 0.2141, 0.1223),
  ('unknown', 32, 'length', -1.025, 0.236),
  ('unknown', 32, 'rectangularity', 0.7166, 0.1154),
  ('unknown', 32, 'spread_length', -1.186, 0.3004),
  ('unknown', 32, 'spread_width', -1.752, 0.2428),
  ('unknown', 32, 'tilt_deg', 34.04, 30.76),
  ('unknown', 32, 'width', -1.502, 0.2291),
  ('unknown', 32, 'z_max', 0.2486, 0.1557),
  ('unknown', 32, 'z_min', 0.1193, 0.1081);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.0184, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'area_m2', -1.399, 0.3694),
  ('unknown', 33, 'aspect', 1.68, 0.3023),
  ('unknown', 33, 'behind', 0.6925, 0.08544),
  ('unknown', 33, 'edge_free', 0.02216, 0.04316),
  ('unknown', 33, 'edge_free_top', 0.5532, 0.13),
  ('unknown', 33, 'edge_joined', 0.9015, 0.1197),
  ('unknown', 33, 'edge_unseen', 0.02589, 0.05212),
  ('unknown', 33, 'height', 0.8877, 0.08009),
  ('unknown', 33, 'length', 0.3082, 0.2671),
  ('unknown', 33, 'rectangularity', 0.7709, 0.06616),
  ('unknown', 33, 'spread_length', 0.1399, 0.314),
  ('unknown', 33, 'spread_width', -1.478, 0.233),
  ('unknown', 33, 'tilt_deg', 1.802, 2.349),
  ('unknown', 33, 'width', -1.396, 0.2035),
  ('unknown', 33, 'z_max', 0.897, 0.07906),
  ('unknown', 33, 'z_min', 0.8835, 0.07984);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.01093, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'area_m2', -2.219, 0.317),
  ('unknown', 34, 'aspect', 1.515, 0.3262),
  ('unknown', 34, 'behind', 0.5744, 0.2726),
  ('unknown', 34, 'edge_free', 0.3544, 0.2239),
  ('unknown', 34, 'edge_free_top', 0.3963, 0.3971),
  ('unknown', 34, 'edge_joined', 0.3947, 0.3091),
  ('unknown', 34, 'edge_unseen', 0.005749, 0.03198),
  ('unknown', 34, 'height', 0.5951, 0.249),
  ('unknown', 34, 'length', -0.1722, 0.2281),
  ('unknown', 34, 'rectangularity', 0.6894, 0.08637),
  ('unknown', 34, 'spread_length', -0.244, 0.2364),
  ('unknown', 34, 'spread_width', -1.926, 0.1727),
  ('unknown', 34, 'tilt_deg', 60.56, 35.55),
  ('unknown', 34, 'width', -1.679, 0.2159),
  ('unknown', 34, 'z_max', 0.8071, 0.204),
  ('unknown', 34, 'z_min', 0.4189, 0.3232);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.02173, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'area_m2', 1.896, 0.5488),
  ('unknown', 35, 'aspect', 1.097, 0.7824),
  ('unknown', 35, 'behind', 0.007773, 0.03),
  ('unknown', 35, 'edge_free', 0.008236, 0.03087),
  ('unknown', 35, 'edge_free_top', 0.01028, 0.03083),
  ('unknown', 35, 'edge_joined', 0.1355, 0.1984),
  ('unknown', 35, 'edge_unseen', 0.0584, 0.1009),
  ('unknown', 35, 'height', 1.528, 1.228),
  ('unknown', 35, 'length', 1.563, 0.4873),
  ('unknown', 35, 'rectangularity', 0.815, 0.1395),
  ('unknown', 35, 'spread_length', 1.668, 0.3269),
  ('unknown', 35, 'spread_width', 0.5327, 0.4327),
  ('unknown', 35, 'tilt_deg', 89.79, 1.239),
  ('unknown', 35, 'width', 0.5645, 0.4531),
  ('unknown', 35, 'z_max', 3.949, 2.722),
  ('unknown', 35, 'z_min', -0.7333, 1.023);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.02378, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'area_m2', -0.9139, 0.293),
  ('unknown', 36, 'aspect', 1.16, 0.252),
  ('unknown', 36, 'behind', 0.4695, 0.2126),
  ('unknown', 36, 'edge_free', 0.5007, 0.1094),
  ('unknown', 36, 'edge_free_top', 0.8493, 0.1746),
  ('unknown', 36, 'edge_joined', 0.02875, 0.0456),
  ('unknown', 36, 'edge_unseen', 0.03226, 0.05698),
  ('unknown', 36, 'height', 0.9457, 0.07129),
  ('unknown', 36, 'length', 0.3087, 0.185),
  ('unknown', 36, 'rectangularity', 0.6902, 0.1343),
  ('unknown', 36, 'spread_length', 0.1757, 0.2521),
  ('unknown', 36, 'spread_width', -1.031, 0.2035),
  ('unknown', 36, 'tilt_deg', 89.79, 1.131),
  ('unknown', 36, 'width', -0.8633, 0.1954),
  ('unknown', 36, 'z_max', 1.158, 0.09526),
  ('unknown', 36, 'z_min', 0.7025, 0.05657);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.006633, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'area_m2', 0.1614, 1.113),
  ('unknown', 37, 'aspect', 0.5434, 0.3664),
  ('unknown', 37, 'behind', 0.4691, 0.2883),
  ('unknown', 37, 'edge_free', 0.3824, 0.2132),
  ('unknown', 37, 'edge_free_top', 0.4923, 0.319),
  ('unknown', 37, 'edge_joined', 0.3958, 0.2455),
  ('unknown', 37, 'edge_unseen', 0.1135, 0.1586),
  ('unknown', 37, 'height', 1.034, 0.5938),
  ('unknown', 37, 'length', 0.6476, 0.5993),
  ('unknown', 37, 'rectangularity', 0.5661, 0.1546),
  ('unknown', 37, 'spread_length', 0.5273, 0.6188),
  ('unknown', 37, 'spread_width', -0.2634, 0.5662),
  ('unknown', 37, 'tilt_deg', 47.34, 34.54),
  ('unknown', 37, 'width', 0.08075, 0.6491),
  ('unknown', 37, 'z_max', 1.511, 1.18),
  ('unknown', 37, 'z_min', 0.4254, 0.5172);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.01363, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'area_m2', -0.5154, 0.3184),
  ('unknown', 38, 'aspect', 0.4862, 0.1048),
  ('unknown', 38, 'behind', 0.04038, 0.05075),
  ('unknown', 38, 'edge_free', 0.9073, 0.1055),
  ('unknown', 38, 'edge_free_top', 0.9748, 0.04947),
  ('unknown', 38, 'edge_joined', 0.03016, 0.0564),
  ('unknown', 38, 'edge_unseen', 0.1149, 0.1283),
  ('unknown', 38, 'height', 1.664, 0.1029),
  ('unknown', 38, 'length', 0.06733, 0.2099),
  ('unknown', 38, 'rectangularity', 0.8575, 0.1233),
  ('unknown', 38, 'spread_length', -0.01741, 0.1803),
  ('unknown', 38, 'spread_width', -0.5421, 0.1356),
  ('unknown', 38, 'tilt_deg', 89.49, 2.19),
  ('unknown', 38, 'width', -0.3952, 0.1269),
  ('unknown', 38, 'z_max', 2.045, 0.1341),
  ('unknown', 38, 'z_min', 1.375, 0.08879);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.008988, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'area_m2', -1.808, 0.2315),
  ('unknown', 39, 'aspect', 0.1921, 0.1399),
  ('unknown', 39, 'behind', 0.2578, 0.1365),
  ('unknown', 39, 'edge_free', 0.8207, 0.117),
  ('unknown', 39, 'edge_free_top', 0.5533, 0.1299),
  ('unknown', 39, 'edge_joined', 0.01546, 0.03206),
  ('unknown', 39, 'edge_unseen', 0.01759, 0.06269),
  ('unknown', 39, 'height', 0.1128, 0.05577),
  ('unknown', 39, 'length', -0.5509, 0.1364),
  ('unknown', 39, 'rectangularity', 0.5992, 0.06934),
  ('unknown', 39, 'spread_length', -0.7553, 0.08112),
  ('unknown', 39, 'spread_width', -0.9909, 0.1393),
  ('unknown', 39, 'tilt_deg', 1.41, 2.703),
  ('unknown', 39, 'width', -0.7418, 0.1702),
  ('unknown', 39, 'z_max', 0.1166, 0.06451),
  ('unknown', 39, 'z_min', 0.1035, 0.05125);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.009707, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'area_m2', -1.056, 0.525),
  ('unknown', 40, 'aspect', 1.476, 0.5403),
  ('unknown', 40, 'behind', 0.6422, 0.1219),
  ('unknown', 40, 'edge_free', 0.4155, 0.2612),
  ('unknown', 40, 'edge_free_top', 0.06704, 0.157),
  ('unknown', 40, 'edge_joined', 0.4324, 0.3185),
  ('unknown', 40, 'edge_unseen', 0.08741, 0.08491),
  ('unknown', 40, 'height', 2.638, 0.4129),
  ('unknown', 40, 'length', 0.4147, 0.4094),
  ('unknown', 40, 'rectangularity', 0.6775, 0.1565),
  ('unknown', 40, 'spread_length', 0.3646, 0.4162),
  ('unknown', 40, 'spread_width', -1.396, 0.315),
  ('unknown', 40, 'tilt_deg', 49.77, 39.66),
  ('unknown', 40, 'width', -1.023, 0.2882),
  ('unknown', 40, 'z_max', 2.812, 0.467),
  ('unknown', 40, 'z_min', 2.616, 0.3322);

-- floor: 499 examples
UPDATE object_class SET prior = 0.04485 WHERE name = 'floor';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.2547, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'area_m2', 2.555, 0.2624),
  ('floor', 1, 'aspect', 0.2541, 0.1576),
  ('floor', 1, 'behind', -0.0007195, 0.03239),
  ('floor', 1, 'edge_free', -0.0001887, 0.03104),
  ('floor', 1, 'edge_free_top', -4.864e-05, 0.03042),
  ('floor', 1, 'edge_joined', 0.2829, 0.1147),
  ('floor', 1, 'edge_unseen', 0.1999, 0.1243),
  ('floor', 1, 'height', 2.17e-05, 0.02259),
  ('floor', 1, 'length', 1.705, 0.1372),
  ('floor', 1, 'rectangularity', 0.5535, 0.1251),
  ('floor', 1, 'spread_length', 1.372, 0.1226),
  ('floor', 1, 'spread_width', 0.9499, 0.1372),
  ('floor', 1, 'tilt_deg', 0.008201, 0.457),
  ('floor', 1, 'width', 1.455, 0.1214),
  ('floor', 1, 'z_max', -8.955e-05, 0.02254),
  ('floor', 1, 'z_min', -6.756e-05, 0.02342);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.1992, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'area_m2', 2.106, 0.2262),
  ('floor', 2, 'aspect', 0.1879, 0.1174),
  ('floor', 2, 'behind', -0.0007313, 0.03181),
  ('floor', 2, 'edge_free', -0.0001653, 0.03074),
  ('floor', 2, 'edge_free_top', -1.959e-05, 0.03049),
  ('floor', 2, 'edge_joined', 0.2854, 0.1001),
  ('floor', 2, 'edge_unseen', 0.1959, 0.07598),
  ('floor', 2, 'height', 0.0003903, 0.0225),
  ('floor', 2, 'length', 1.403, 0.1172),
  ('floor', 2, 'rectangularity', 0.6089, 0.1053),
  ('floor', 2, 'spread_length', 1.154, 0.1007),
  ('floor', 2, 'spread_width', 0.7923, 0.1361),
  ('floor', 2, 'tilt_deg', 0.01867, 0.4527),
  ('floor', 2, 'width', 1.217, 0.1241),
  ('floor', 2, 'z_max', 0.0006213, 0.0225),
  ('floor', 2, 'z_min', 7.792e-05, 0.0231);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.09684, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'area_m2', -1.305, 0.4459),
  ('floor', 3, 'aspect', 0.9373, 0.4712),
  ('floor', 3, 'behind', -0.005106, 0.03),
  ('floor', 3, 'edge_free', -0.001049, 0.03),
  ('floor', 3, 'edge_free_top', -0.0001057, 0.03),
  ('floor', 3, 'edge_joined', 0.2713, 0.2366),
  ('floor', 3, 'edge_unseen', 0.337, 0.1619),
  ('floor', 3, 'height', 0.0008029, 0.0225),
  ('floor', 3, 'length', -0.01163, 0.3422),
  ('floor', 3, 'rectangularity', 0.6609, 0.1231),
  ('floor', 3, 'spread_length', -0.1597, 0.3317),
  ('floor', 3, 'spread_width', -1.086, 0.2893),
  ('floor', 3, 'tilt_deg', 1.82, 0.9942),
  ('floor', 3, 'width', -0.8466, 0.2712),
  ('floor', 3, 'z_max', 0.01116, 0.02341),
  ('floor', 3, 'z_min', -0.01428, 0.02392);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.1298, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'area_m2', 2.148, 0.2849),
  ('floor', 4, 'aspect', 0.7519, 0.1478),
  ('floor', 4, 'behind', -0.0002375, 0.03181),
  ('floor', 4, 'edge_free', -0.0001899, 0.03055),
  ('floor', 4, 'edge_free_top', -4.819e-05, 0.0303),
  ('floor', 4, 'edge_joined', 0.2721, 0.105),
  ('floor', 4, 'edge_unseen', 0.2848, 0.08376),
  ('floor', 4, 'height', 5.542e-05, 0.02259),
  ('floor', 4, 'length', 1.771, 0.1874),
  ('floor', 4, 'rectangularity', 0.5314, 0.1065),
  ('floor', 4, 'spread_length', 1.389, 0.1531),
  ('floor', 4, 'spread_width', 0.6502, 0.1483),
  ('floor', 4, 'tilt_deg', 0.0297, 0.4559),
  ('floor', 4, 'width', 1.026, 0.1852),
  ('floor', 4, 'z_max', 0.0006329, 0.02259),
  ('floor', 4, 'z_min', -0.0002722, 0.02256);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.08011, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'area_m2', 0.09333, 0.3458),
  ('floor', 5, 'aspect', 0.7069, 0.4105),
  ('floor', 5, 'behind', -0.003475, 0.03),
  ('floor', 5, 'edge_free', -0.0005877, 0.03),
  ('floor', 5, 'edge_free_top', -8.326e-05, 0.03022),
  ('floor', 5, 'edge_joined', 0.1885, 0.1552),
  ('floor', 5, 'edge_unseen', 0.3511, 0.1421),
  ('floor', 5, 'height', 0.00283, 0.02387),
  ('floor', 5, 'length', 0.6263, 0.2362),
  ('floor', 5, 'rectangularity', 0.619, 0.1196),
  ('floor', 5, 'spread_length', 0.4876, 0.152),
  ('floor', 5, 'spread_width', -0.3091, 0.2569),
  ('floor', 5, 'tilt_deg', 1.427, 0.788),
  ('floor', 5, 'width', -0.04391, 0.2724),
  ('floor', 5, 'z_max', 0.02235, 0.02689),
  ('floor', 5, 'z_min', -0.01623, 0.02625);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.07295, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'area_m2', 1.462, 0.3463),
  ('floor', 6, 'aspect', 0.578, 0.2441),
  ('floor', 6, 'behind', -0.0002781, 0.03157),
  ('floor', 6, 'edge_free', -0.0002244, 0.03031),
  ('floor', 6, 'edge_free_top', -6.521e-05, 0.03034),
  ('floor', 6, 'edge_joined', 0.1387, 0.05744),
  ('floor', 6, 'edge_unseen', 0.2159, 0.06605),
  ('floor', 6, 'height', -3.232e-06, 0.0226),
  ('floor', 6, 'length', 1.383, 0.1754),
  ('floor', 6, 'rectangularity', 0.4955, 0.1083),
  ('floor', 6, 'spread_length', 1.11, 0.1655),
  ('floor', 6, 'spread_width', 0.4406, 0.1926),
  ('floor', 6, 'tilt_deg', 0.04362, 0.4527),
  ('floor', 6, 'width', 0.8107, 0.1884),
  ('floor', 6, 'z_max', 0.0006135, 0.02272),
  ('floor', 6, 'z_min', -0.000356, 0.0228);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.06305, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'area_m2', 1.381, 0.5105),
  ('floor', 7, 'aspect', 0.3781, 0.2053),
  ('floor', 7, 'behind', -0.0002947, 0.03084),
  ('floor', 7, 'edge_free', -8.963e-05, 0.03041),
  ('floor', 7, 'edge_free_top', -8.23e-05, 0.03027),
  ('floor', 7, 'edge_joined', 0.1831, 0.09079),
  ('floor', 7, 'edge_unseen', 0.3568, 0.08726),
  ('floor', 7, 'height', 0.000309, 0.02257),
  ('floor', 7, 'length', 1.159, 0.2281),
  ('floor', 7, 'rectangularity', 0.5779, 0.0779),
  ('floor', 7, 'spread_length', 0.9187, 0.1781),
  ('floor', 7, 'spread_width', 0.4542, 0.2863),
  ('floor', 7, 'tilt_deg', 1.334, 0.596),
  ('floor', 7, 'width', 0.782, 0.2736),
  ('floor', 7, 'z_max', 0.03478, 0.0225),
  ('floor', 7, 'z_min', -0.03737, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.03449, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'area_m2', -2.638, 0.56),
  ('floor', 8, 'aspect', 0.9239, 0.4294),
  ('floor', 8, 'behind', -0.001277, 0.0312),
  ('floor', 8, 'edge_free', -0.00106, 0.03),
  ('floor', 8, 'edge_free_top', -0.0003562, 0.03),
  ('floor', 8, 'edge_joined', 0.0554, 0.05673),
  ('floor', 8, 'edge_unseen', 0.3405, 0.1879),
  ('floor', 8, 'height', -0.1529, 0.2743),
  ('floor', 8, 'length', -0.655, 0.4621),
  ('floor', 8, 'rectangularity', 0.6315, 0.1596),
  ('floor', 8, 'spread_length', -0.8318, 0.4378),
  ('floor', 8, 'spread_width', -1.728, 0.319),
  ('floor', 8, 'tilt_deg', 2.295, 0.7844),
  ('floor', 8, 'width', -1.499, 0.3315),
  ('floor', 8, 'z_max', -0.2134, 0.2446),
  ('floor', 8, 'z_min', -0.1913, 0.2917);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.01877, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'area_m2', -0.5653, 0.8742),
  ('floor', 9, 'aspect', 0.7257, 0.3805),
  ('floor', 9, 'behind', -0.0008531, 0.03),
  ('floor', 9, 'edge_free', -0.0001897, 0.03),
  ('floor', 9, 'edge_free_top', -7.353e-06, 0.03),
  ('floor', 9, 'edge_joined', 0.2612, 0.2189),
  ('floor', 9, 'edge_unseen', 0.3609, 0.09744),
  ('floor', 9, 'height', 0.06292, 0.03294),
  ('floor', 9, 'length', 0.3725, 0.4541),
  ('floor', 9, 'rectangularity', 0.5597, 0.1409),
  ('floor', 9, 'spread_length', 0.1913, 0.3923),
  ('floor', 9, 'spread_width', -0.6077, 0.4751),
  ('floor', 9, 'tilt_deg', 11.52, 17.58),
  ('floor', 9, 'width', -0.3335, 0.5671),
  ('floor', 9, 'z_max', 0.1053, 0.03104),
  ('floor', 9, 'z_min', 0.02695, 0.042);

-- ceiling: 429 examples
UPDATE object_class SET prior = 0.03233 WHERE name = 'ceiling';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.265, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'area_m2', 2.679, 0.2611),
  ('ceiling', 1, 'aspect', 0.2188, 0.1331),
  ('ceiling', 1, 'behind', 0.0001011, 0.03),
  ('ceiling', 1, 'edge_free', 0.0001804, 0.03),
  ('ceiling', 1, 'edge_free_top', 8.685e-05, 0.3179),
  ('ceiling', 1, 'edge_joined', 0.5156, 0.1528),
  ('ceiling', 1, 'edge_unseen', 0.3073, 0.1275),
  ('ceiling', 1, 'height', 2.833, 0.1261),
  ('ceiling', 1, 'length', 1.644, 0.1167),
  ('ceiling', 1, 'rectangularity', 0.6908, 0.1157),
  ('ceiling', 1, 'spread_length', 1.529, 0.1152),
  ('ceiling', 1, 'spread_width', 1.097, 0.1393),
  ('ceiling', 1, 'tilt_deg', 0.001556, 0.45),
  ('ceiling', 1, 'width', 1.421, 0.1138),
  ('ceiling', 1, 'z_max', 2.831, 0.1282),
  ('ceiling', 1, 'z_min', 2.832, 0.1288);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1813, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'area_m2', 2.591, 0.3245),
  ('ceiling', 2, 'aspect', 0.2104, 0.1499),
  ('ceiling', 2, 'behind', -3.155e-05, 0.03),
  ('ceiling', 2, 'edge_free', 0.0001344, 0.03),
  ('ceiling', 2, 'edge_free_top', 0.0001119, 0.3169),
  ('ceiling', 2, 'edge_joined', 0.603, 0.1686),
  ('ceiling', 2, 'edge_unseen', 0.3128, 0.127),
  ('ceiling', 2, 'height', 2.511, 0.06486),
  ('ceiling', 2, 'length', 1.594, 0.1712),
  ('ceiling', 2, 'rectangularity', 0.6878, 0.1154),
  ('ceiling', 2, 'spread_length', 1.453, 0.1568),
  ('ceiling', 2, 'spread_width', 1.051, 0.1655),
  ('ceiling', 2, 'tilt_deg', 0.002152, 0.45),
  ('ceiling', 2, 'width', 1.384, 0.1361),
  ('ceiling', 2, 'z_max', 2.509, 0.06822),
  ('ceiling', 2, 'z_min', 2.509, 0.06816);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.1496, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'area_m2', 2.052, 0.3058),
  ('ceiling', 3, 'aspect', 0.4297, 0.2923),
  ('ceiling', 3, 'behind', 0.0001829, 0.03),
  ('ceiling', 3, 'edge_free', 0.0001815, 0.03),
  ('ceiling', 3, 'edge_free_top', -0.0001057, 0.3176),
  ('ceiling', 3, 'edge_joined', 0.3558, 0.1346),
  ('ceiling', 3, 'edge_unseen', 0.3198, 0.06625),
  ('ceiling', 3, 'height', 2.993, 0.08088),
  ('ceiling', 3, 'length', 1.465, 0.1949),
  ('ceiling', 3, 'rectangularity', 0.6543, 0.1213),
  ('ceiling', 3, 'spread_length', 1.349, 0.1414),
  ('ceiling', 3, 'spread_width', 0.7173, 0.212),
  ('ceiling', 3, 'tilt_deg', 0.001978, 0.45),
  ('ceiling', 3, 'width', 1.027, 0.2465),
  ('ceiling', 3, 'z_max', 2.994, 0.08235),
  ('ceiling', 3, 'z_min', 2.993, 0.08291);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.08618, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'area_m2', 2.073, 0.2802),
  ('ceiling', 4, 'aspect', 0.3583, 0.2488),
  ('ceiling', 4, 'behind', 0.0003233, 0.03),
  ('ceiling', 4, 'edge_free', 0.000335, 0.03),
  ('ceiling', 4, 'edge_free_top', 8.53e-05, 0.3167),
  ('ceiling', 4, 'edge_joined', 0.5238, 0.1708),
  ('ceiling', 4, 'edge_unseen', 0.3323, 0.07717),
  ('ceiling', 4, 'height', 2.654, 0.069),
  ('ceiling', 4, 'length', 1.451, 0.1435),
  ('ceiling', 4, 'rectangularity', 0.6401, 0.1165),
  ('ceiling', 4, 'spread_length', 1.326, 0.1212),
  ('ceiling', 4, 'spread_width', 0.7665, 0.1707),
  ('ceiling', 4, 'tilt_deg', 0.01245, 0.45),
  ('ceiling', 4, 'width', 1.087, 0.2155),
  ('ceiling', 4, 'z_max', 2.654, 0.06838),
  ('ceiling', 4, 'z_min', 2.654, 0.06873);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.04342, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'area_m2', -0.7365, 0.6326),
  ('ceiling', 5, 'aspect', 0.9287, 0.2468),
  ('ceiling', 5, 'behind', 0.002224, 0.03),
  ('ceiling', 5, 'edge_free', 0.0003065, 0.03),
  ('ceiling', 5, 'edge_free_top', -0.000125, 0.3169),
  ('ceiling', 5, 'edge_joined', 0.2964, 0.1493),
  ('ceiling', 5, 'edge_unseen', 0.09022, 0.1188),
  ('ceiling', 5, 'height', 2.512, 0.03631),
  ('ceiling', 5, 'length', 0.2993, 0.4032),
  ('ceiling', 5, 'rectangularity', 0.7192, 0.1109),
  ('ceiling', 5, 'spread_length', 0.1737, 0.4223),
  ('ceiling', 5, 'spread_width', -0.8204, 0.2286),
  ('ceiling', 5, 'tilt_deg', 0.1564, 0.4746),
  ('ceiling', 5, 'width', -0.6907, 0.3399),
  ('ceiling', 5, 'z_max', 2.511, 0.0293),
  ('ceiling', 5, 'z_min', 2.51, 0.03107);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.06397, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'area_m2', 2.126, 0.4874),
  ('ceiling', 6, 'aspect', 0.4203, 0.261),
  ('ceiling', 6, 'behind', 0.0004578, 0.03),
  ('ceiling', 6, 'edge_free', 0.0004716, 0.03),
  ('ceiling', 6, 'edge_free_top', 0.0001085, 0.3167),
  ('ceiling', 6, 'edge_joined', 0.1885, 0.06574),
  ('ceiling', 6, 'edge_unseen', 0.2791, 0.07366),
  ('ceiling', 6, 'height', 3.468, 0.2167),
  ('ceiling', 6, 'length', 1.518, 0.2519),
  ('ceiling', 6, 'rectangularity', 0.624, 0.1191),
  ('ceiling', 6, 'spread_length', 1.389, 0.2295),
  ('ceiling', 6, 'spread_width', 0.788, 0.276),
  ('ceiling', 6, 'tilt_deg', 0.01847, 0.45),
  ('ceiling', 6, 'width', 1.095, 0.328),
  ('ceiling', 6, 'z_max', 3.478, 0.2248),
  ('ceiling', 6, 'z_min', 3.476, 0.2255);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.02857, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'area_m2', -2.207, 0.8597),
  ('ceiling', 7, 'aspect', 0.3676, 0.4033),
  ('ceiling', 7, 'behind', 0.003482, 0.03509),
  ('ceiling', 7, 'edge_free', 0.004195, 0.03635),
  ('ceiling', 7, 'edge_free_top', -0.0008735, 0.3198),
  ('ceiling', 7, 'edge_joined', 0.4592, 0.295),
  ('ceiling', 7, 'edge_unseen', 0.438, 0.1845),
  ('ceiling', 7, 'height', 2.781, 0.2556),
  ('ceiling', 7, 'length', -0.6769, 0.4936),
  ('ceiling', 7, 'rectangularity', 0.6393, 0.09922),
  ('ceiling', 7, 'spread_length', -0.7501, 0.5065),
  ('ceiling', 7, 'spread_width', -1.299, 0.39),
  ('ceiling', 7, 'tilt_deg', 0.575, 0.6171),
  ('ceiling', 7, 'width', -1.083, 0.4695),
  ('ceiling', 7, 'z_max', 2.774, 0.2677),
  ('ceiling', 7, 'z_min', 2.791, 0.2515);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.03994, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'area_m2', -1.084, 0.6072),
  ('ceiling', 8, 'aspect', 0.5653, 0.4489),
  ('ceiling', 8, 'behind', 0.0008653, 0.03078),
  ('ceiling', 8, 'edge_free', 0.0005816, 0.03),
  ('ceiling', 8, 'edge_free_top', 8.818e-05, 0.3167),
  ('ceiling', 8, 'edge_joined', 0.3111, 0.1838),
  ('ceiling', 8, 'edge_unseen', 0.5465, 0.09476),
  ('ceiling', 8, 'height', 3.065, 0.06068),
  ('ceiling', 8, 'length', -0.02923, 0.3265),
  ('ceiling', 8, 'rectangularity', 0.6422, 0.09487),
  ('ceiling', 8, 'spread_length', -0.1544, 0.3299),
  ('ceiling', 8, 'spread_width', -0.8599, 0.3733),
  ('ceiling', 8, 'tilt_deg', 0.1928, 0.45),
  ('ceiling', 8, 'width', -0.6108, 0.3656),
  ('ceiling', 8, 'z_max', 3.07, 0.05578),
  ('ceiling', 8, 'z_min', 3.068, 0.05548);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.05653, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'area_m2', 0.5149, 0.6926),
  ('ceiling', 9, 'aspect', 0.9149, 0.4568),
  ('ceiling', 9, 'behind', 0.3068, 0.1404),
  ('ceiling', 9, 'edge_free', 0.2771, 0.1365),
  ('ceiling', 9, 'edge_free_top', -0.000593, 0.3185),
  ('ceiling', 9, 'edge_joined', 0.3231, 0.1628),
  ('ceiling', 9, 'edge_unseen', 0.1834, 0.08847),
  ('ceiling', 9, 'height', 2.959, 0.3189),
  ('ceiling', 9, 'length', 0.8637, 0.4678),
  ('ceiling', 9, 'rectangularity', 0.7554, 0.1069),
  ('ceiling', 9, 'spread_length', 0.7316, 0.4212),
  ('ceiling', 9, 'spread_width', -0.2653, 0.3704),
  ('ceiling', 9, 'tilt_deg', 0.06133, 0.45),
  ('ceiling', 9, 'width', -0.0843, 0.3777),
  ('ceiling', 9, 'z_max', 2.933, 0.3355),
  ('ceiling', 9, 'z_min', 2.939, 0.3357);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 10, 0.03544, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 10, 'area_m2', -1.147, 1.169),
  ('ceiling', 10, 'aspect', 0.6017, 0.3586),
  ('ceiling', 10, 'behind', 0.0007943, 0.03),
  ('ceiling', 10, 'edge_free', 0.0007775, 0.03),
  ('ceiling', 10, 'edge_free_top', 8.261e-05, 0.3165),
  ('ceiling', 10, 'edge_joined', 0.1738, 0.111),
  ('ceiling', 10, 'edge_unseen', 0.3957, 0.1434),
  ('ceiling', 10, 'height', 3.551, 0.1753),
  ('ceiling', 10, 'length', -0.01835, 0.6033),
  ('ceiling', 10, 'rectangularity', 0.6043, 0.07496),
  ('ceiling', 10, 'spread_length', -0.1401, 0.6185),
  ('ceiling', 10, 'spread_width', -0.8421, 0.5417),
  ('ceiling', 10, 'tilt_deg', 0.6747, 0.8591),
  ('ceiling', 10, 'width', -0.6232, 0.5977),
  ('ceiling', 10, 'z_max', 3.567, 0.1874),
  ('ceiling', 10, 'z_min', 3.563, 0.1869);

-- wall: 2699 examples
UPDATE object_class SET prior = 0.1676 WHERE name = 'wall';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.1138, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'area_m2', 1.971, 0.4052),
  ('wall', 1, 'aspect', 0.4612, 0.2973),
  ('wall', 1, 'behind', -0.003229, 0.03),
  ('wall', 1, 'edge_free', 0.005732, 0.03),
  ('wall', 1, 'edge_free_top', -0.0007271, 0.03),
  ('wall', 1, 'edge_joined', 0.1112, 0.1141),
  ('wall', 1, 'edge_unseen', 0.1, 0.1456),
  ('wall', 1, 'height', 1.565, 0.2169),
  ('wall', 1, 'length', 1.427, 0.2071),
  ('wall', 1, 'rectangularity', 0.7001, 0.0699),
  ('wall', 1, 'spread_length', 1.218, 0.2203),
  ('wall', 1, 'spread_width', 0.72, 0.1364),
  ('wall', 1, 'tilt_deg', 90.09, 0.45),
  ('wall', 1, 'width', 1.053, 0.08458),
  ('wall', 1, 'z_max', 2.942, 0.3667),
  ('wall', 1, 'z_min', -0.01494, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.08679, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'area_m2', 0.8608, 0.4062),
  ('wall', 2, 'aspect', 0.5894, 0.5338),
  ('wall', 2, 'behind', -0.005955, 0.03),
  ('wall', 2, 'edge_free', 0.007998, 0.03),
  ('wall', 2, 'edge_free_top', -0.0006565, 0.03),
  ('wall', 2, 'edge_joined', 0.3006, 0.1755),
  ('wall', 2, 'edge_unseen', 0.3384, 0.1052),
  ('wall', 2, 'height', 1.534, 0.3153),
  ('wall', 2, 'length', 1.014, 0.2508),
  ('wall', 2, 'rectangularity', 0.6526, 0.1081),
  ('wall', 2, 'spread_length', 0.6397, 0.2308),
  ('wall', 2, 'spread_width', 0.1219, 0.3704),
  ('wall', 2, 'tilt_deg', 90.17, 0.45),
  ('wall', 2, 'width', 0.4451, 0.439),
  ('wall', 2, 'z_max', 2.712, 0.1465),
  ('wall', 2, 'z_min', 0.4522, 0.2402);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.1684, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'area_m2', -0.5963, 0.8368),
  ('wall', 3, 'aspect', 0.8857, 0.4811),
  ('wall', 3, 'behind', 0.163, 0.2503),
  ('wall', 3, 'edge_free', 0.05317, 0.1193),
  ('wall', 3, 'edge_free_top', 0.003541, 0.03),
  ('wall', 3, 'edge_joined', 0.4318, 0.336),
  ('wall', 3, 'edge_unseen', 0.1944, 0.2469),
  ('wall', 3, 'height', 1.923, 0.4093),
  ('wall', 3, 'length', 0.4337, 0.3527),
  ('wall', 3, 'rectangularity', 0.673, 0.109),
  ('wall', 3, 'spread_length', 0.003217, 0.5473),
  ('wall', 3, 'spread_width', -0.8166, 0.3885),
  ('wall', 3, 'tilt_deg', 90.06, 0.45),
  ('wall', 3, 'width', -0.5934, 0.4985),
  ('wall', 3, 'z_max', 2.927, 0.2402),
  ('wall', 3, 'z_min', 1.312, 0.5855);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.05003, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'area_m2', 1.798, 0.3506),
  ('wall', 4, 'aspect', 0.3905, 0.27),
  ('wall', 4, 'behind', 0.1576, 0.1377),
  ('wall', 4, 'edge_free', 0.1427, 0.09124),
  ('wall', 4, 'edge_free_top', 0.07948, 0.1099),
  ('wall', 4, 'edge_joined', 0.1139, 0.1255),
  ('wall', 4, 'edge_unseen', 0.1148, 0.1338),
  ('wall', 4, 'height', 1.532, 0.2404),
  ('wall', 4, 'length', 1.383, 0.2126),
  ('wall', 4, 'rectangularity', 0.5316, 0.107),
  ('wall', 4, 'spread_length', 1.241, 0.218),
  ('wall', 4, 'spread_width', 0.802, 0.1528),
  ('wall', 4, 'tilt_deg', 90.02, 0.45),
  ('wall', 4, 'width', 1.022, 0.09951),
  ('wall', 4, 'z_max', 2.902, 0.3161),
  ('wall', 4, 'z_min', -0.01526, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.05152, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'area_m2', 0.6601, 0.4012),
  ('wall', 5, 'aspect', 0.2087, 0.1552),
  ('wall', 5, 'behind', 0.4109, 0.1347),
  ('wall', 5, 'edge_free', 0.4999, 0.2666),
  ('wall', 5, 'edge_free_top', 0.7221, 0.2861),
  ('wall', 5, 'edge_joined', 0.1853, 0.1955),
  ('wall', 5, 'edge_unseen', 0.17, 0.1326),
  ('wall', 5, 'height', 1.195, 0.3202),
  ('wall', 5, 'length', 0.854, 0.2698),
  ('wall', 5, 'rectangularity', 0.7426, 0.2004),
  ('wall', 5, 'spread_length', 0.5552, 0.1502),
  ('wall', 5, 'spread_width', 0.09954, 0.3323),
  ('wall', 5, 'tilt_deg', 89.97, 0.45),
  ('wall', 5, 'width', 0.3758, 0.2835),
  ('wall', 5, 'z_max', 1.971, 0.7859),
  ('wall', 5, 'z_min', -0.03999, 0.1956);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.07313, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'area_m2', -0.9764, 0.5582),
  ('wall', 6, 'aspect', 1.109, 0.4354),
  ('wall', 6, 'behind', 0.1209, 0.1917),
  ('wall', 6, 'edge_free', 0.4682, 0.4106),
  ('wall', 6, 'edge_free_top', 0.4554, 0.5789),
  ('wall', 6, 'edge_joined', 0.08689, 0.1737),
  ('wall', 6, 'edge_unseen', 0.4709, 0.1869),
  ('wall', 6, 'height', 1.177, 0.1879),
  ('wall', 6, 'length', 0.1456, 0.3237),
  ('wall', 6, 'rectangularity', 0.6779, 0.2552),
  ('wall', 6, 'spread_length', -0.2663, 0.29),
  ('wall', 6, 'spread_width', -0.9993, 0.2987),
  ('wall', 6, 'tilt_deg', 89.86, 0.6595),
  ('wall', 6, 'width', -0.7684, 0.4523),
  ('wall', 6, 'z_max', 1.844, 0.3391),
  ('wall', 6, 'z_min', 0.3678, 0.2942);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.1116, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'area_m2', 0.2618, 0.4698),
  ('wall', 7, 'aspect', 1.322, 0.3254),
  ('wall', 7, 'behind', 0.1817, 0.2064),
  ('wall', 7, 'edge_free', 0.2695, 0.3488),
  ('wall', 7, 'edge_free_top', 0.0653, 0.09868),
  ('wall', 7, 'edge_joined', 0.1548, 0.2135),
  ('wall', 7, 'edge_unseen', 0.009265, 0.03),
  ('wall', 7, 'height', 1.407, 0.1258),
  ('wall', 7, 'length', 0.9977, 0.1327),
  ('wall', 7, 'rectangularity', 0.8377, 0.1073),
  ('wall', 7, 'spread_length', 0.8538, 0.2213),
  ('wall', 7, 'spread_width', -0.7302, 0.4086),
  ('wall', 7, 'tilt_deg', 90.04, 0.45),
  ('wall', 7, 'width', -0.4341, 0.4291),
  ('wall', 7, 'z_max', 2.766, 0.2045),
  ('wall', 7, 'z_min', 0.009968, 0.06553);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.05068, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'area_m2', -2.661, 0.495),
  ('wall', 8, 'aspect', 0.4432, 0.4753),
  ('wall', 8, 'behind', 0.02994, 0.1606),
  ('wall', 8, 'edge_free', 0.1551, 0.1331),
  ('wall', 8, 'edge_free_top', 0.2089, 0.1895),
  ('wall', 8, 'edge_joined', 0.5711, 0.3428),
  ('wall', 8, 'edge_unseen', 0.1219, 0.1804),
  ('wall', 8, 'height', 1.285, 0.8455),
  ('wall', 8, 'length', -0.8752, 0.4326),
  ('wall', 8, 'rectangularity', 0.7806, 0.07792),
  ('wall', 8, 'spread_length', -1.131, 0.3565),
  ('wall', 8, 'spread_width', -1.675, 0.08647),
  ('wall', 8, 'tilt_deg', 89.54, 0.7991),
  ('wall', 8, 'width', -1.467, 0.1755),
  ('wall', 8, 'z_max', 1.281, 0.831),
  ('wall', 8, 'z_min', 1.052, 0.9601);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.1194, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'area_m2', -1.537, 1.055),
  ('wall', 9, 'aspect', 0.6224, 0.5231),
  ('wall', 9, 'behind', -0.00818, 0.03),
  ('wall', 9, 'edge_free', -0.000425, 0.03),
  ('wall', 9, 'edge_free_top', 0.0005031, 0.03),
  ('wall', 9, 'edge_joined', 0.09897, 0.161),
  ('wall', 9, 'edge_unseen', 0.1593, 0.2162),
  ('wall', 9, 'height', 0.3974, 0.3187),
  ('wall', 9, 'length', -0.3276, 0.5277),
  ('wall', 9, 'rectangularity', 0.7661, 0.1615),
  ('wall', 9, 'spread_length', -0.2653, 0.5615),
  ('wall', 9, 'spread_width', -1.154, 0.6882),
  ('wall', 9, 'tilt_deg', 88.38, 0.5006),
  ('wall', 9, 'width', -0.9784, 0.6441),
  ('wall', 9, 'z_max', 0.8754, 0.4647),
  ('wall', 9, 'z_min', -0.05154, 0.03938);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.1247, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'area_m2', -0.02397, 0.4921),
  ('wall', 10, 'aspect', 0.883, 0.3839),
  ('wall', 10, 'behind', 0.04371, 0.1283),
  ('wall', 10, 'edge_free', 0.1061, 0.199),
  ('wall', 10, 'edge_free_top', 0.06838, 0.133),
  ('wall', 10, 'edge_joined', 0.08706, 0.1216),
  ('wall', 10, 'edge_unseen', 0.3268, 0.1487),
  ('wall', 10, 'height', 1.025, 0.2718),
  ('wall', 10, 'length', 0.6161, 0.3122),
  ('wall', 10, 'rectangularity', 0.6357, 0.1447),
  ('wall', 10, 'spread_length', 0.5238, 0.2902),
  ('wall', 10, 'spread_width', -0.483, 0.4019),
  ('wall', 10, 'tilt_deg', 77.53, 11.91),
  ('wall', 10, 'width', -0.1645, 0.3794),
  ('wall', 10, 'z_max', 1.58, 0.1782),
  ('wall', 10, 'z_min', 0.2933, 0.3272);

-- table: 764 examples
UPDATE object_class SET prior = 0.02871 WHERE name = 'table';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.1003, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'area_m2', 0.116, 0.1918),
  ('table', 1, 'aspect', 0.5427, 0.1746),
  ('table', 1, 'behind', 0.7094, 0.05034),
  ('table', 1, 'edge_free', 0.3512, 0.1777),
  ('table', 1, 'edge_free_top', -0.000266, 0.3163),
  ('table', 1, 'edge_joined', 0.3949, 0.148),
  ('table', 1, 'edge_unseen', 0.008063, 0.03349),
  ('table', 1, 'height', 0.7387, 0.0233),
  ('table', 1, 'length', 0.5174, 0.1377),
  ('table', 1, 'rectangularity', 0.7051, 0.06609),
  ('table', 1, 'spread_length', 0.3726, 0.116),
  ('table', 1, 'spread_width', -0.2302, 0.1218),
  ('table', 1, 'tilt_deg', 0.09228, 0.45),
  ('table', 1, 'width', -0.05308, 0.1371),
  ('table', 1, 'z_max', 0.7396, 0.02289),
  ('table', 1, 'z_min', 0.7383, 0.02469);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.1361, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'area_m2', 0.01634, 0.2929),
  ('table', 2, 'aspect', 0.5949, 0.1687),
  ('table', 2, 'behind', 0.5569, 0.1041),
  ('table', 2, 'edge_free', 0.4533, 0.1458),
  ('table', 2, 'edge_free_top', -0.0009783, 0.3156),
  ('table', 2, 'edge_joined', 0.2817, 0.1624),
  ('table', 2, 'edge_unseen', 0.09516, 0.1084),
  ('table', 2, 'height', 0.6771, 0.0286),
  ('table', 2, 'length', 0.5095, 0.1768),
  ('table', 2, 'rectangularity', 0.7014, 0.1301),
  ('table', 2, 'spread_length', 0.3822, 0.2018),
  ('table', 2, 'spread_width', -0.2745, 0.1511),
  ('table', 2, 'tilt_deg', 0.3271, 0.4697),
  ('table', 2, 'width', -0.1114, 0.1569),
  ('table', 2, 'z_max', 0.6775, 0.02726),
  ('table', 2, 'z_min', 0.6683, 0.03145);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.1299, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'area_m2', -0.009641, 0.3587),
  ('table', 3, 'aspect', 0.6125, 0.2512),
  ('table', 3, 'behind', 0.4731, 0.1248),
  ('table', 3, 'edge_free', 0.5129, 0.2512),
  ('table', 3, 'edge_free_top', -0.000895, 0.3155),
  ('table', 3, 'edge_joined', 0.2301, 0.1659),
  ('table', 3, 'edge_unseen', 0.1324, 0.1341),
  ('table', 3, 'height', 0.7708, 0.02275),
  ('table', 3, 'length', 0.5388, 0.2321),
  ('table', 3, 'rectangularity', 0.7152, 0.1622),
  ('table', 3, 'spread_length', 0.3224, 0.1845),
  ('table', 3, 'spread_width', -0.3366, 0.2066),
  ('table', 3, 'tilt_deg', 0.2301, 0.45),
  ('table', 3, 'width', -0.1526, 0.1993),
  ('table', 3, 'z_max', 0.7764, 0.02665),
  ('table', 3, 'z_min', 0.7678, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.07278, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'area_m2', -0.311, 0.2599),
  ('table', 4, 'aspect', 0.4142, 0.174),
  ('table', 4, 'behind', 0.4941, 0.2206),
  ('table', 4, 'edge_free', 0.4106, 0.2135),
  ('table', 4, 'edge_free_top', -0.0004097, 0.3161),
  ('table', 4, 'edge_joined', 0.2589, 0.1677),
  ('table', 4, 'edge_unseen', 0.2203, 0.154),
  ('table', 4, 'height', 0.7329, 0.02259),
  ('table', 4, 'length', 0.3056, 0.1489),
  ('table', 4, 'rectangularity', 0.6186, 0.1477),
  ('table', 4, 'spread_length', 0.1712, 0.156),
  ('table', 4, 'spread_width', -0.3709, 0.1461),
  ('table', 4, 'tilt_deg', 0.2061, 0.45),
  ('table', 4, 'width', -0.1139, 0.1267),
  ('table', 4, 'z_max', 0.7363, 0.0225),
  ('table', 4, 'z_min', 0.7337, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.1157, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'area_m2', -1.37, 0.5521),
  ('table', 5, 'aspect', 0.7665, 0.3514),
  ('table', 5, 'behind', 0.2373, 0.1867),
  ('table', 5, 'edge_free', 0.5301, 0.3099),
  ('table', 5, 'edge_free_top', -0.007151, 0.3105),
  ('table', 5, 'edge_joined', 0.2488, 0.2002),
  ('table', 5, 'edge_unseen', 0.3737, 0.1051),
  ('table', 5, 'height', 0.7498, 0.09693),
  ('table', 5, 'length', -0.1238, 0.3325),
  ('table', 5, 'rectangularity', 0.6121, 0.1011),
  ('table', 5, 'spread_length', -0.2447, 0.3705),
  ('table', 5, 'spread_width', -1.021, 0.3231),
  ('table', 5, 'tilt_deg', 1.142, 1.409),
  ('table', 5, 'width', -0.8202, 0.4171),
  ('table', 5, 'z_max', 0.7409, 0.09475),
  ('table', 5, 'z_min', 0.7383, 0.09699);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.0641, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'area_m2', 0.11, 0.1842),
  ('table', 6, 'aspect', 0.614, 0.1695),
  ('table', 6, 'behind', 0.474, 0.1879),
  ('table', 6, 'edge_free', 0.7084, 0.1356),
  ('table', 6, 'edge_free_top', -0.000137, 0.316),
  ('table', 6, 'edge_joined', 0.1354, 0.08943),
  ('table', 6, 'edge_unseen', 0.006403, 0.03),
  ('table', 6, 'height', 0.7135, 0.02307),
  ('table', 6, 'length', 0.4646, 0.145),
  ('table', 6, 'rectangularity', 0.8322, 0.08261),
  ('table', 6, 'spread_length', 0.3314, 0.1481),
  ('table', 6, 'spread_width', -0.2918, 0.1048),
  ('table', 6, 'tilt_deg', 0.1163, 0.45),
  ('table', 6, 'width', -0.1654, 0.1234),
  ('table', 6, 'z_max', 0.7151, 0.02372),
  ('table', 6, 'z_min', 0.7125, 0.02397);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.113, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'area_m2', -0.9217, 0.2679),
  ('table', 7, 'aspect', 0.3882, 0.2101),
  ('table', 7, 'behind', 0.2963, 0.1529),
  ('table', 7, 'edge_free', 0.5045, 0.2272),
  ('table', 7, 'edge_free_top', -0.001736, 0.3139),
  ('table', 7, 'edge_joined', 0.2415, 0.1836),
  ('table', 7, 'edge_unseen', 0.137, 0.1794),
  ('table', 7, 'height', 0.6919, 0.02688),
  ('table', 7, 'length', -0.09221, 0.1657),
  ('table', 7, 'rectangularity', 0.7063, 0.1395),
  ('table', 7, 'spread_length', -0.2225, 0.1514),
  ('table', 7, 'spread_width', -0.6815, 0.1562),
  ('table', 7, 'tilt_deg', 0.3346, 0.45),
  ('table', 7, 'width', -0.4803, 0.1494),
  ('table', 7, 'z_max', 0.6944, 0.02637),
  ('table', 7, 'z_min', 0.6898, 0.02939);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.07659, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'area_m2', -0.494, 0.2392),
  ('table', 8, 'aspect', 0.186, 0.1334),
  ('table', 8, 'behind', 0.6894, 0.1135),
  ('table', 8, 'edge_free', 0.27, 0.1196),
  ('table', 8, 'edge_free_top', -0.001018, 0.3157),
  ('table', 8, 'edge_joined', 0.43, 0.1475),
  ('table', 8, 'edge_unseen', 0.02567, 0.05264),
  ('table', 8, 'height', 0.7343, 0.05444),
  ('table', 8, 'length', 0.03657, 0.1265),
  ('table', 8, 'rectangularity', 0.7256, 0.08172),
  ('table', 8, 'spread_length', -0.09564, 0.1191),
  ('table', 8, 'spread_width', -0.3513, 0.1286),
  ('table', 8, 'tilt_deg', 0.1787, 0.45),
  ('table', 8, 'width', -0.1599, 0.1071),
  ('table', 8, 'z_max', 0.7418, 0.06099),
  ('table', 8, 'z_min', 0.7326, 0.06771);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.1178, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'area_m2', -0.0533, 0.3295),
  ('table', 9, 'aspect', 0.4941, 0.1508),
  ('table', 9, 'behind', 0.4074, 0.217),
  ('table', 9, 'edge_free', 0.2713, 0.1771),
  ('table', 9, 'edge_free_top', -0.004026, 0.3147),
  ('table', 9, 'edge_joined', 0.4943, 0.2189),
  ('table', 9, 'edge_unseen', 0.1273, 0.1058),
  ('table', 9, 'height', 0.9473, 0.1325),
  ('table', 9, 'length', 0.4082, 0.212),
  ('table', 9, 'rectangularity', 0.7089, 0.1275),
  ('table', 9, 'spread_length', 0.2639, 0.2176),
  ('table', 9, 'spread_width', -0.2917, 0.2082),
  ('table', 9, 'tilt_deg', 0.4134, 0.4642),
  ('table', 9, 'width', -0.1198, 0.1289),
  ('table', 9, 'z_max', 0.9694, 0.1241),
  ('table', 9, 'z_min', 0.9586, 0.1391);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.02371, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'area_m2', -0.6797, 0.5815),
  ('table', 10, 'aspect', 0.5201, 0.1573),
  ('table', 10, 'behind', 0.2125, 0.1373),
  ('table', 10, 'edge_free', 0.2773, 0.1193),
  ('table', 10, 'edge_free_top', -0.00048, 0.316),
  ('table', 10, 'edge_joined', 0.1841, 0.1658),
  ('table', 10, 'edge_unseen', 0.2019, 0.1123),
  ('table', 10, 'height', 0.05146, 0.05559),
  ('table', 10, 'length', 0.1481, 0.3162),
  ('table', 10, 'rectangularity', 0.6154, 0.08406),
  ('table', 10, 'spread_length', 0.02875, 0.3134),
  ('table', 10, 'spread_width', -0.6121, 0.3529),
  ('table', 10, 'tilt_deg', 1.323, 0.4923),
  ('table', 10, 'width', -0.3407, 0.3076),
  ('table', 10, 'z_max', 0.03912, 0.04044),
  ('table', 10, 'z_min', 0.01999, 0.03998);

-- flat_screen: 607 examples
UPDATE object_class SET prior = 0.03949 WHERE name = 'flat_screen';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.2273, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'area_m2', -1.445, 0.2479),
  ('flat_screen', 1, 'aspect', 0.5582, 0.1635),
  ('flat_screen', 1, 'behind', 0.6226, 0.07033),
  ('flat_screen', 1, 'edge_free', 0.5936, 0.1112),
  ('flat_screen', 1, 'edge_free_top', 0.8963, 0.1227),
  ('flat_screen', 1, 'edge_joined', 0.1778, 0.1946),
  ('flat_screen', 1, 'edge_unseen', 0.0116, 0.03237),
  ('flat_screen', 1, 'height', 0.984, 0.05217),
  ('flat_screen', 1, 'length', -0.3455, 0.1927),
  ('flat_screen', 1, 'rectangularity', 0.6908, 0.06583),
  ('flat_screen', 1, 'spread_length', -0.5897, 0.227),
  ('flat_screen', 1, 'spread_width', -1.105, 0.09465),
  ('flat_screen', 1, 'tilt_deg', 83.83, 2.199),
  ('flat_screen', 1, 'width', -0.8076, 0.1249),
  ('flat_screen', 1, 'z_max', 1.159, 0.09546),
  ('flat_screen', 1, 'z_min', 0.7233, 0.06127);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.152, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'area_m2', -1.551, 0.09787),
  ('flat_screen', 2, 'aspect', 0.3421, 0.09219),
  ('flat_screen', 2, 'behind', 0.5586, 0.1001),
  ('flat_screen', 2, 'edge_free', 0.7569, 0.08345),
  ('flat_screen', 2, 'edge_free_top', 0.996, 0.03054),
  ('flat_screen', 2, 'edge_joined', 0.071, 0.04749),
  ('flat_screen', 2, 'edge_unseen', 0.007449, 0.03062),
  ('flat_screen', 2, 'height', 1.014, 0.04684),
  ('flat_screen', 2, 'length', -0.5276, 0.09606),
  ('flat_screen', 2, 'rectangularity', 0.8301, 0.05897),
  ('flat_screen', 2, 'spread_length', -0.6101, 0.06303),
  ('flat_screen', 2, 'spread_width', -1.074, 0.05213),
  ('flat_screen', 2, 'tilt_deg', 85.43, 2.813),
  ('flat_screen', 2, 'width', -0.8346, 0.07624),
  ('flat_screen', 2, 'z_max', 1.168, 0.06413),
  ('flat_screen', 2, 'z_min', 0.7402, 0.04815);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.0873, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'area_m2', -2.004, 0.131),
  ('flat_screen', 3, 'aspect', 0.1699, 0.1295),
  ('flat_screen', 3, 'behind', 0.6657, 0.04094),
  ('flat_screen', 3, 'edge_free', 0.764, 0.07037),
  ('flat_screen', 3, 'edge_free_top', 1.004, 0.03),
  ('flat_screen', 3, 'edge_joined', 0.05672, 0.034),
  ('flat_screen', 3, 'edge_unseen', 0.003465, 0.03),
  ('flat_screen', 3, 'height', 0.967, 0.03285),
  ('flat_screen', 3, 'length', -0.822, 0.1239),
  ('flat_screen', 3, 'rectangularity', 0.8221, 0.05224),
  ('flat_screen', 3, 'spread_length', -0.922, 0.0848),
  ('flat_screen', 3, 'spread_width', -1.245, 0.05841),
  ('flat_screen', 3, 'tilt_deg', 84.81, 2.41),
  ('flat_screen', 3, 'width', -0.9905, 0.0536),
  ('flat_screen', 3, 'z_max', 1.082, 0.04605),
  ('flat_screen', 3, 'z_min', 0.7118, 0.04223);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.08927, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'area_m2', -1.773, 0.1264),
  ('flat_screen', 4, 'aspect', 0.4981, 0.04239),
  ('flat_screen', 4, 'behind', 0.5763, 0.1016),
  ('flat_screen', 4, 'edge_free', 0.9847, 0.03),
  ('flat_screen', 4, 'edge_free_top', 0.9985, 0.03),
  ('flat_screen', 4, 'edge_joined', 0.003542, 0.03),
  ('flat_screen', 4, 'edge_unseen', 0.04124, 0.07663),
  ('flat_screen', 4, 'height', 1.03, 0.04141),
  ('flat_screen', 4, 'length', -0.5993, 0.06907),
  ('flat_screen', 4, 'rectangularity', 0.9315, 0.03132),
  ('flat_screen', 4, 'spread_length', -0.6469, 0.06001),
  ('flat_screen', 4, 'spread_width', -1.144, 0.07701),
  ('flat_screen', 4, 'tilt_deg', 84.96, 3.569),
  ('flat_screen', 4, 'width', -1.1, 0.06804),
  ('flat_screen', 4, 'z_max', 1.189, 0.04439),
  ('flat_screen', 4, 'z_min', 0.8542, 0.0421);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.08906, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'area_m2', -1.835, 0.1243),
  ('flat_screen', 5, 'aspect', 0.3451, 0.1572),
  ('flat_screen', 5, 'behind', 0.5648, 0.1237),
  ('flat_screen', 5, 'edge_free', 0.7209, 0.1208),
  ('flat_screen', 5, 'edge_free_top', 0.998, 0.03),
  ('flat_screen', 5, 'edge_joined', 0.04965, 0.03486),
  ('flat_screen', 5, 'edge_unseen', 0.07269, 0.1043),
  ('flat_screen', 5, 'height', 1.014, 0.0331),
  ('flat_screen', 5, 'length', -0.5963, 0.129),
  ('flat_screen', 5, 'rectangularity', 0.7295, 0.103),
  ('flat_screen', 5, 'spread_length', -0.793, 0.1252),
  ('flat_screen', 5, 'spread_width', -1.222, 0.07173),
  ('flat_screen', 5, 'tilt_deg', 84, 2.155),
  ('flat_screen', 5, 'width', -0.9376, 0.0689),
  ('flat_screen', 5, 'z_max', 1.15, 0.03948),
  ('flat_screen', 5, 'z_min', 0.7537, 0.03561);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.07184, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'area_m2', -2.23, 0.1513),
  ('flat_screen', 6, 'aspect', 0.2778, 0.1688),
  ('flat_screen', 6, 'behind', 0.5676, 0.09761),
  ('flat_screen', 6, 'edge_free', 0.8506, 0.1126),
  ('flat_screen', 6, 'edge_free_top', 0.9965, 0.03017),
  ('flat_screen', 6, 'edge_joined', 0.05489, 0.06781),
  ('flat_screen', 6, 'edge_unseen', 0.1236, 0.1352),
  ('flat_screen', 6, 'height', 1.046, 0.04194),
  ('flat_screen', 6, 'length', -0.8819, 0.1301),
  ('flat_screen', 6, 'rectangularity', 0.8269, 0.05837),
  ('flat_screen', 6, 'spread_length', -1.005, 0.08515),
  ('flat_screen', 6, 'spread_width', -1.312, 0.05864),
  ('flat_screen', 6, 'tilt_deg', 84.74, 2.206),
  ('flat_screen', 6, 'width', -1.15, 0.1205),
  ('flat_screen', 6, 'z_max', 1.18, 0.0437),
  ('flat_screen', 6, 'z_min', 0.8436, 0.06151);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.1022, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'area_m2', -1.775, 0.253),
  ('flat_screen', 7, 'aspect', 0.3926, 0.2054),
  ('flat_screen', 7, 'behind', 0.5055, 0.08277),
  ('flat_screen', 7, 'edge_free', 0.8485, 0.1566),
  ('flat_screen', 7, 'edge_free_top', 0.9981, 0.03),
  ('flat_screen', 7, 'edge_joined', 0.02133, 0.03),
  ('flat_screen', 7, 'edge_unseen', 0.09025, 0.1523),
  ('flat_screen', 7, 'height', 1.243, 0.1152),
  ('flat_screen', 7, 'length', -0.5912, 0.1999),
  ('flat_screen', 7, 'rectangularity', 0.8203, 0.1314),
  ('flat_screen', 7, 'spread_length', -0.6838, 0.1225),
  ('flat_screen', 7, 'spread_width', -1.136, 0.08626),
  ('flat_screen', 7, 'tilt_deg', 83.08, 2.203),
  ('flat_screen', 7, 'width', -0.98, 0.1899),
  ('flat_screen', 7, 'z_max', 1.406, 0.09632),
  ('flat_screen', 7, 'z_min', 1.052, 0.1329);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.03626, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'area_m2', -1.825, 0.4779),
  ('flat_screen', 8, 'aspect', 0.6037, 0.1484),
  ('flat_screen', 8, 'behind', 0.5228, 0.1812),
  ('flat_screen', 8, 'edge_free', 0.5846, 0.1453),
  ('flat_screen', 8, 'edge_free_top', 0.8808, 0.1686),
  ('flat_screen', 8, 'edge_joined', 0.201, 0.2232),
  ('flat_screen', 8, 'edge_unseen', 0.07459, 0.1132),
  ('flat_screen', 8, 'height', 0.8985, 0.3338),
  ('flat_screen', 8, 'length', -0.5307, 0.3523),
  ('flat_screen', 8, 'rectangularity', 0.7312, 0.2343),
  ('flat_screen', 8, 'spread_length', -0.7779, 0.1732),
  ('flat_screen', 8, 'spread_width', -1.203, 0.2742),
  ('flat_screen', 8, 'tilt_deg', 84.85, 1.651),
  ('flat_screen', 8, 'width', -0.9582, 0.3957),
  ('flat_screen', 8, 'z_max', 1.086, 0.591),
  ('flat_screen', 8, 'z_min', 0.5447, 0.4009);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.0487, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'area_m2', -2.185, 0.1236),
  ('flat_screen', 9, 'aspect', 0.3908, 0.1013),
  ('flat_screen', 9, 'behind', 0.5843, 0.08902),
  ('flat_screen', 9, 'edge_free', 0.9903, 0.03),
  ('flat_screen', 9, 'edge_free_top', 0.9994, 0.03),
  ('flat_screen', 9, 'edge_joined', 0.002121, 0.03),
  ('flat_screen', 9, 'edge_unseen', 0.02355, 0.05439),
  ('flat_screen', 9, 'height', 0.9873, 0.04879),
  ('flat_screen', 9, 'length', -0.8687, 0.1005),
  ('flat_screen', 9, 'rectangularity', 0.9409, 0.03037),
  ('flat_screen', 9, 'spread_length', -0.907, 0.1071),
  ('flat_screen', 9, 'spread_width', -1.281, 0.04897),
  ('flat_screen', 9, 'tilt_deg', 83.99, 3.168),
  ('flat_screen', 9, 'width', -1.252, 0.06212),
  ('flat_screen', 9, 'z_max', 1.123, 0.05631),
  ('flat_screen', 9, 'z_min', 0.8394, 0.05028);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.04608, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'area_m2', -2.69, 0.4359),
  ('flat_screen', 10, 'aspect', 0.6335, 0.2889),
  ('flat_screen', 10, 'behind', 0.5718, 0.1805),
  ('flat_screen', 10, 'edge_free', 0.8372, 0.1807),
  ('flat_screen', 10, 'edge_free_top', 0.9996, 0.03),
  ('flat_screen', 10, 'edge_joined', 0.0286, 0.05436),
  ('flat_screen', 10, 'edge_unseen', 0.2875, 0.09444),
  ('flat_screen', 10, 'height', 1.048, 0.04675),
  ('flat_screen', 10, 'length', -0.859, 0.2755),
  ('flat_screen', 10, 'rectangularity', 0.7205, 0.1115),
  ('flat_screen', 10, 'spread_length', -0.9924, 0.1693),
  ('flat_screen', 10, 'spread_width', -1.724, 0.2461),
  ('flat_screen', 10, 'tilt_deg', 83.93, 1.955),
  ('flat_screen', 10, 'width', -1.458, 0.2844),
  ('flat_screen', 10, 'z_max', 1.136, 0.05267),
  ('flat_screen', 10, 'z_min', 0.8391, 0.06844);

-- keyboard: 393 examples
UPDATE object_class SET prior = 0.05947 WHERE name = 'keyboard';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1447, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'area_m2', -2.312, 0.1014),
  ('keyboard', 1, 'aspect', 0.7494, 0.1645),
  ('keyboard', 1, 'behind', 0.252, 0.0901),
  ('keyboard', 1, 'edge_free', 0.2311, 0.1571),
  ('keyboard', 1, 'edge_free_top', -0.003129, 0.3132),
  ('keyboard', 1, 'edge_joined', 0.7722, 0.1426),
  ('keyboard', 1, 'edge_unseen', 0.002391, 0.03),
  ('keyboard', 1, 'height', 0.7451, 0.0396),
  ('keyboard', 1, 'length', -0.6376, 0.1169),
  ('keyboard', 1, 'rectangularity', 0.7561, 0.04423),
  ('keyboard', 1, 'spread_length', -0.7687, 0.07702),
  ('keyboard', 1, 'spread_width', -1.743, 0.07376),
  ('keyboard', 1, 'tilt_deg', 3.217, 1.126),
  ('keyboard', 1, 'width', -1.39, 0.1129),
  ('keyboard', 1, 'z_max', 0.7467, 0.03774),
  ('keyboard', 1, 'z_min', 0.7395, 0.05016);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.1504, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'area_m2', -2.74, 0.1093),
  ('keyboard', 2, 'aspect', 1.049, 0.08681),
  ('keyboard', 2, 'behind', 0.2128, 0.104),
  ('keyboard', 2, 'edge_free', 0.3662, 0.1442),
  ('keyboard', 2, 'edge_free_top', -0.01137, 0.3029),
  ('keyboard', 2, 'edge_joined', 0.5976, 0.1299),
  ('keyboard', 2, 'edge_unseen', 0.003507, 0.03),
  ('keyboard', 2, 'height', 0.7501, 0.06368),
  ('keyboard', 2, 'length', -0.7696, 0.08536),
  ('keyboard', 2, 'rectangularity', 0.8863, 0.04905),
  ('keyboard', 2, 'spread_length', -0.8202, 0.04898),
  ('keyboard', 2, 'spread_width', -1.899, 0.07264),
  ('keyboard', 2, 'tilt_deg', 4.539, 1.648),
  ('keyboard', 2, 'width', -1.826, 0.07753),
  ('keyboard', 2, 'z_max', 0.7565, 0.06584),
  ('keyboard', 2, 'z_min', 0.75, 0.06223);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.1157, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'area_m2', -2.634, 0.07816),
  ('keyboard', 3, 'aspect', 0.9596, 0.09354),
  ('keyboard', 3, 'behind', 0.2718, 0.1268),
  ('keyboard', 3, 'edge_free', 0.06977, 0.07188),
  ('keyboard', 3, 'edge_free_top', -0.001575, 0.3144),
  ('keyboard', 3, 'edge_joined', 0.9093, 0.07788),
  ('keyboard', 3, 'edge_unseen', 0.005313, 0.03083),
  ('keyboard', 3, 'height', 0.7581, 0.03374),
  ('keyboard', 3, 'length', -0.7529, 0.07267),
  ('keyboard', 3, 'rectangularity', 0.8464, 0.05877),
  ('keyboard', 3, 'spread_length', -0.8145, 0.04147),
  ('keyboard', 3, 'spread_width', -1.835, 0.07425),
  ('keyboard', 3, 'tilt_deg', 2.192, 1.071),
  ('keyboard', 3, 'width', -1.703, 0.0817),
  ('keyboard', 3, 'z_max', 0.7639, 0.03393),
  ('keyboard', 3, 'z_min', 0.7584, 0.0333);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.1207, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'area_m2', -2.573, 0.07474),
  ('keyboard', 4, 'aspect', 0.8456, 0.08007),
  ('keyboard', 4, 'behind', 0.2248, 0.1009),
  ('keyboard', 4, 'edge_free', 0.4779, 0.0844),
  ('keyboard', 4, 'edge_free_top', -0.005136, 0.3061),
  ('keyboard', 4, 'edge_joined', 0.4891, 0.09025),
  ('keyboard', 4, 'edge_unseen', 0.001434, 0.03039),
  ('keyboard', 4, 'height', 0.7662, 0.03048),
  ('keyboard', 4, 'length', -0.7739, 0.0646),
  ('keyboard', 4, 'rectangularity', 0.8358, 0.03662),
  ('keyboard', 4, 'spread_length', -0.8382, 0.06172),
  ('keyboard', 4, 'spread_width', -1.77, 0.06571),
  ('keyboard', 4, 'tilt_deg', 4.827, 1.332),
  ('keyboard', 4, 'width', -1.616, 0.05496),
  ('keyboard', 4, 'z_max', 0.7769, 0.03016),
  ('keyboard', 4, 'z_min', 0.7607, 0.03338);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.09427, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'area_m2', -2.885, 0.189),
  ('keyboard', 5, 'aspect', 0.5463, 0.1919),
  ('keyboard', 5, 'behind', 0.255, 0.08847),
  ('keyboard', 5, 'edge_free', 0.3685, 0.1014),
  ('keyboard', 5, 'edge_free_top', -0.006424, 0.3104),
  ('keyboard', 5, 'edge_joined', 0.5389, 0.1277),
  ('keyboard', 5, 'edge_unseen', 0.002824, 0.0319),
  ('keyboard', 5, 'height', 0.7606, 0.05122),
  ('keyboard', 5, 'length', -1.092, 0.1091),
  ('keyboard', 5, 'rectangularity', 0.8056, 0.06628),
  ('keyboard', 5, 'spread_length', -1.159, 0.06369),
  ('keyboard', 5, 'spread_width', -1.789, 0.07483),
  ('keyboard', 5, 'tilt_deg', 5.438, 1.181),
  ('keyboard', 5, 'width', -1.592, 0.2088),
  ('keyboard', 5, 'z_max', 0.7647, 0.04197),
  ('keyboard', 5, 'z_min', 0.7557, 0.05457);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.09111, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'area_m2', -2.926, 0.1554),
  ('keyboard', 6, 'aspect', 0.6878, 0.1657),
  ('keyboard', 6, 'behind', 0.2823, 0.08374),
  ('keyboard', 6, 'edge_free', 0.01382, 0.03),
  ('keyboard', 6, 'edge_free_top', -0.0002046, 0.3169),
  ('keyboard', 6, 'edge_joined', 0.9786, 0.03726),
  ('keyboard', 6, 'edge_unseen', 0.05714, 0.1092),
  ('keyboard', 6, 'height', 0.7658, 0.04783),
  ('keyboard', 6, 'length', -1.028, 0.1457),
  ('keyboard', 6, 'rectangularity', 0.846, 0.04567),
  ('keyboard', 6, 'spread_length', -1.09, 0.08081),
  ('keyboard', 6, 'spread_width', -1.82, 0.07095),
  ('keyboard', 6, 'tilt_deg', 1.678, 0.45),
  ('keyboard', 6, 'width', -1.699, 0.1215),
  ('keyboard', 6, 'z_max', 0.7603, 0.04308),
  ('keyboard', 6, 'z_min', 0.7655, 0.05628);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.07694, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'area_m2', -3.501, 0.3296),
  ('keyboard', 7, 'aspect', 0.2845, 0.1613),
  ('keyboard', 7, 'behind', 0.3148, 0.1159),
  ('keyboard', 7, 'edge_free', 0.2008, 0.1359),
  ('keyboard', 7, 'edge_free_top', -0.00543, 0.3181),
  ('keyboard', 7, 'edge_joined', 0.6234, 0.2359),
  ('keyboard', 7, 'edge_unseen', 0.1977, 0.07822),
  ('keyboard', 7, 'height', 0.7633, 0.04452),
  ('keyboard', 7, 'length', -1.493, 0.1529),
  ('keyboard', 7, 'rectangularity', 0.7667, 0.06287),
  ('keyboard', 7, 'spread_length', -1.588, 0.07606),
  ('keyboard', 7, 'spread_width', -1.963, 0.158),
  ('keyboard', 7, 'tilt_deg', 3.878, 0.9783),
  ('keyboard', 7, 'width', -1.761, 0.1903),
  ('keyboard', 7, 'z_max', 0.7515, 0.03461),
  ('keyboard', 7, 'z_min', 0.7754, 0.03991);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.07605, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'area_m2', -2.902, 0.2648),
  ('keyboard', 8, 'aspect', 0.8781, 0.1866),
  ('keyboard', 8, 'behind', 0.1584, 0.1521),
  ('keyboard', 8, 'edge_free', 0.2533, 0.2094),
  ('keyboard', 8, 'edge_free_top', -0.01708, 0.3032),
  ('keyboard', 8, 'edge_joined', 0.7155, 0.2152),
  ('keyboard', 8, 'edge_unseen', 0.1054, 0.1175),
  ('keyboard', 8, 'height', 0.9646, 0.149),
  ('keyboard', 8, 'length', -0.9167, 0.1936),
  ('keyboard', 8, 'rectangularity', 0.8607, 0.09629),
  ('keyboard', 8, 'spread_length', -0.9771, 0.1926),
  ('keyboard', 8, 'spread_width', -1.879, 0.07686),
  ('keyboard', 8, 'tilt_deg', 3.829, 1.341),
  ('keyboard', 8, 'width', -1.794, 0.0887),
  ('keyboard', 8, 'z_max', 0.9787, 0.1232),
  ('keyboard', 8, 'z_min', 1.012, 0.1096);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.05203, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'area_m2', -2.646, 0.142),
  ('keyboard', 9, 'aspect', 0.4456, 0.1947),
  ('keyboard', 9, 'behind', 0.2048, 0.09621),
  ('keyboard', 9, 'edge_free', 0.1777, 0.08144),
  ('keyboard', 9, 'edge_free_top', -0.001372, 0.3169),
  ('keyboard', 9, 'edge_joined', 0.7686, 0.07331),
  ('keyboard', 9, 'edge_unseen', 0.1174, 0.1172),
  ('keyboard', 9, 'height', 0.7564, 0.03644),
  ('keyboard', 9, 'length', -0.9439, 0.1352),
  ('keyboard', 9, 'rectangularity', 0.744, 0.06352),
  ('keyboard', 9, 'spread_length', -1.13, 0.1474),
  ('keyboard', 9, 'spread_width', -1.761, 0.06995),
  ('keyboard', 9, 'tilt_deg', 2.681, 0.6654),
  ('keyboard', 9, 'width', -1.405, 0.1169),
  ('keyboard', 9, 'z_max', 0.7595, 0.03333),
  ('keyboard', 9, 'z_min', 0.752, 0.03986);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.02808, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'area_m2', -2.95, 0.3833),
  ('keyboard', 10, 'aspect', 1.006, 0.4342),
  ('keyboard', 10, 'behind', 0.1115, 0.09662),
  ('keyboard', 10, 'edge_free', 0.1395, 0.1564),
  ('keyboard', 10, 'edge_free_top', -0.001797, 0.3209),
  ('keyboard', 10, 'edge_joined', 0.8528, 0.1464),
  ('keyboard', 10, 'edge_unseen', 0.1215, 0.1669),
  ('keyboard', 10, 'height', 0.1306, 0.08852),
  ('keyboard', 10, 'length', -0.9254, 0.335),
  ('keyboard', 10, 'rectangularity', 0.9114, 0.04523),
  ('keyboard', 10, 'spread_length', -0.9589, 0.3972),
  ('keyboard', 10, 'spread_width', -1.959, 0.04402),
  ('keyboard', 10, 'tilt_deg', 2.479, 1.129),
  ('keyboard', 10, 'width', -1.906, 0.0589),
  ('keyboard', 10, 'z_max', 0.1201, 0.08723),
  ('keyboard', 10, 'z_min', 0.128, 0.08296);

-- chair_seat: 471 examples
UPDATE object_class SET prior = 0.009405 WHERE name = 'chair_seat';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.1427, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'area_m2', -1.621, 0.1068),
  ('chair_seat', 1, 'aspect', 0.1217, 0.07795),
  ('chair_seat', 1, 'behind', 0.6964, 0.09408),
  ('chair_seat', 1, 'edge_free', 0.7827, 0.1105),
  ('chair_seat', 1, 'edge_free_top', -0.0004104, 0.3154),
  ('chair_seat', 1, 'edge_joined', 0.05927, 0.07411),
  ('chair_seat', 1, 'edge_unseen', 0.006751, 0.03086),
  ('chair_seat', 1, 'height', 0.4453, 0.0225),
  ('chair_seat', 1, 'length', -0.6699, 0.07793),
  ('chair_seat', 1, 'rectangularity', 0.8494, 0.06825),
  ('chair_seat', 1, 'spread_length', -0.7245, 0.05598),
  ('chair_seat', 1, 'spread_width', -0.9213, 0.0727),
  ('chair_seat', 1, 'tilt_deg', 0.3911, 0.461),
  ('chair_seat', 1, 'width', -0.7874, 0.07214),
  ('chair_seat', 1, 'z_max', 0.4501, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4459, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.1321, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'area_m2', -1.609, 0.1317),
  ('chair_seat', 2, 'aspect', 0.1241, 0.101),
  ('chair_seat', 2, 'behind', 0.6589, 0.08197),
  ('chair_seat', 2, 'edge_free', 0.7664, 0.1162),
  ('chair_seat', 2, 'edge_free_top', -0.0003117, 0.3157),
  ('chair_seat', 2, 'edge_joined', 0.05759, 0.07098),
  ('chair_seat', 2, 'edge_unseen', 0.002642, 0.03187),
  ('chair_seat', 2, 'height', 0.4938, 0.0225),
  ('chair_seat', 2, 'length', -0.6564, 0.09464),
  ('chair_seat', 2, 'rectangularity', 0.8368, 0.06056),
  ('chair_seat', 2, 'spread_length', -0.7182, 0.06423),
  ('chair_seat', 2, 'spread_width', -0.9219, 0.08588),
  ('chair_seat', 2, 'tilt_deg', 0.4391, 0.4672),
  ('chair_seat', 2, 'width', -0.7833, 0.07634),
  ('chair_seat', 2, 'z_max', 0.4934, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4896, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.1238, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'area_m2', -1.811, 0.1567),
  ('chair_seat', 3, 'aspect', 0.2129, 0.1929),
  ('chair_seat', 3, 'behind', 0.7171, 0.09069),
  ('chair_seat', 3, 'edge_free', 0.4933, 0.09732),
  ('chair_seat', 3, 'edge_free_top', -0.0008085, 0.3152),
  ('chair_seat', 3, 'edge_joined', 0.1978, 0.1147),
  ('chair_seat', 3, 'edge_unseen', 0.003069, 0.03),
  ('chair_seat', 3, 'height', 0.4621, 0.0225),
  ('chair_seat', 3, 'length', -0.6341, 0.1322),
  ('chair_seat', 3, 'rectangularity', 0.7276, 0.08894),
  ('chair_seat', 3, 'spread_length', -0.6968, 0.06178),
  ('chair_seat', 3, 'spread_width', -1.036, 0.09608),
  ('chair_seat', 3, 'tilt_deg', 0.3939, 0.45),
  ('chair_seat', 3, 'width', -0.8387, 0.1197),
  ('chair_seat', 3, 'z_max', 0.464, 0.0225),
  ('chair_seat', 3, 'z_min', 0.4619, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.1467, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'area_m2', -2.034, 0.2307),
  ('chair_seat', 4, 'aspect', 0.1986, 0.153),
  ('chair_seat', 4, 'behind', 0.665, 0.08516),
  ('chair_seat', 4, 'edge_free', 0.5659, 0.1357),
  ('chair_seat', 4, 'edge_free_top', -0.0006287, 0.3156),
  ('chair_seat', 4, 'edge_joined', 0.06977, 0.08648),
  ('chair_seat', 4, 'edge_unseen', 0.06587, 0.09563),
  ('chair_seat', 4, 'height', 0.4992, 0.0225),
  ('chair_seat', 4, 'length', -0.6839, 0.1249),
  ('chair_seat', 4, 'rectangularity', 0.6532, 0.09803),
  ('chair_seat', 4, 'spread_length', -0.7233, 0.1234),
  ('chair_seat', 4, 'spread_width', -1.2, 0.1234),
  ('chair_seat', 4, 'tilt_deg', 0.5328, 0.4988),
  ('chair_seat', 4, 'width', -0.89, 0.1061),
  ('chair_seat', 4, 'z_max', 0.5036, 0.0225),
  ('chair_seat', 4, 'z_min', 0.499, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.1379, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'area_m2', -2.582, 0.2723),
  ('chair_seat', 5, 'aspect', 0.7772, 0.2192),
  ('chair_seat', 5, 'behind', 0.7337, 0.07792),
  ('chair_seat', 5, 'edge_free', 0.4214, 0.1717),
  ('chair_seat', 5, 'edge_free_top', -0.001749, 0.3158),
  ('chair_seat', 5, 'edge_joined', 0.07358, 0.08065),
  ('chair_seat', 5, 'edge_unseen', 0.00928, 0.03101),
  ('chair_seat', 5, 'height', 0.4747, 0.02558),
  ('chair_seat', 5, 'length', -0.7239, 0.1069),
  ('chair_seat', 5, 'rectangularity', 0.7124, 0.1049),
  ('chair_seat', 5, 'spread_length', -0.7606, 0.09052),
  ('chair_seat', 5, 'spread_width', -1.729, 0.22),
  ('chair_seat', 5, 'tilt_deg', 1.06, 0.9514),
  ('chair_seat', 5, 'width', -1.495, 0.2575),
  ('chair_seat', 5, 'z_max', 0.4837, 0.0225),
  ('chair_seat', 5, 'z_min', 0.4793, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.1403, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'area_m2', -2.51, 0.4146),
  ('chair_seat', 6, 'aspect', 0.5487, 0.2645),
  ('chair_seat', 6, 'behind', 0.4159, 0.2946),
  ('chair_seat', 6, 'edge_free', 0.5665, 0.2044),
  ('chair_seat', 6, 'edge_free_top', -0.001605, 0.3151),
  ('chair_seat', 6, 'edge_joined', 0.1066, 0.1213),
  ('chair_seat', 6, 'edge_unseen', 0.2316, 0.1979),
  ('chair_seat', 6, 'height', 0.4787, 0.02744),
  ('chair_seat', 6, 'length', -0.8043, 0.2204),
  ('chair_seat', 6, 'rectangularity', 0.7, 0.1279),
  ('chair_seat', 6, 'spread_length', -0.8745, 0.2497),
  ('chair_seat', 6, 'spread_width', -1.558, 0.2676),
  ('chair_seat', 6, 'tilt_deg', 0.8309, 0.5818),
  ('chair_seat', 6, 'width', -1.332, 0.2159),
  ('chair_seat', 6, 'z_max', 0.4848, 0.02474),
  ('chair_seat', 6, 'z_min', 0.4785, 0.02731);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.05371, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'area_m2', -2.123, 0.1895),
  ('chair_seat', 7, 'aspect', 0.1052, 0.07181),
  ('chair_seat', 7, 'behind', 0.7054, 0.1203),
  ('chair_seat', 7, 'edge_free', 0.5984, 0.0834),
  ('chair_seat', 7, 'edge_free_top', -7.546e-06, 0.3161),
  ('chair_seat', 7, 'edge_joined', 0.0248, 0.03003),
  ('chair_seat', 7, 'edge_unseen', 0.04587, 0.09144),
  ('chair_seat', 7, 'height', 0.4432, 0.0225),
  ('chair_seat', 7, 'length', -0.7378, 0.06049),
  ('chair_seat', 7, 'rectangularity', 0.5907, 0.09128),
  ('chair_seat', 7, 'spread_length', -0.7233, 0.09013),
  ('chair_seat', 7, 'spread_width', -1.195, 0.08296),
  ('chair_seat', 7, 'tilt_deg', 0.5083, 0.5376),
  ('chair_seat', 7, 'width', -0.8474, 0.0674),
  ('chair_seat', 7, 'z_max', 0.4445, 0.0225),
  ('chair_seat', 7, 'z_min', 0.4405, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.04703, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'area_m2', -3.228, 0.3868),
  ('chair_seat', 8, 'aspect', 0.5034, 0.2298),
  ('chair_seat', 8, 'behind', 0.3645, 0.3647),
  ('chair_seat', 8, 'edge_free', 0.4655, 0.1888),
  ('chair_seat', 8, 'edge_free_top', -0.003342, 0.3134),
  ('chair_seat', 8, 'edge_joined', 0.0137, 0.03),
  ('chair_seat', 8, 'edge_unseen', 0.1834, 0.1717),
  ('chair_seat', 8, 'height', 0.4342, 0.1451),
  ('chair_seat', 8, 'length', -1.129, 0.2532),
  ('chair_seat', 8, 'rectangularity', 0.6729, 0.06441),
  ('chair_seat', 8, 'spread_length', -1.273, 0.3218),
  ('chair_seat', 8, 'spread_width', -1.921, 0.1447),
  ('chair_seat', 8, 'tilt_deg', 2.794, 2.053),
  ('chair_seat', 8, 'width', -1.673, 0.1662),
  ('chair_seat', 8, 'z_max', 0.4455, 0.1246),
  ('chair_seat', 8, 'z_min', 0.4467, 0.1206);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.0258, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'area_m2', -1.641, 0.4793),
  ('chair_seat', 9, 'aspect', 0.5133, 0.2128),
  ('chair_seat', 9, 'behind', 0.74, 0.115),
  ('chair_seat', 9, 'edge_free', 0.5842, 0.08446),
  ('chair_seat', 9, 'edge_free_top', -1.547e-05, 0.3162),
  ('chair_seat', 9, 'edge_joined', 0.009615, 0.03),
  ('chair_seat', 9, 'edge_unseen', 0.03525, 0.06122),
  ('chair_seat', 9, 'height', 0.4396, 0.0225),
  ('chair_seat', 9, 'length', -0.4332, 0.3222),
  ('chair_seat', 9, 'rectangularity', 0.7789, 0.08391),
  ('chair_seat', 9, 'spread_length', -0.567, 0.3165),
  ('chair_seat', 9, 'spread_width', -1.119, 0.1811),
  ('chair_seat', 9, 'tilt_deg', 0.5589, 0.45),
  ('chair_seat', 9, 'width', -0.9588, 0.1885),
  ('chair_seat', 9, 'z_max', 0.4435, 0.0225),
  ('chair_seat', 9, 'z_min', 0.4373, 0.0225);

-- chair_back: 510 examples
UPDATE object_class SET prior = 0.04789 WHERE name = 'chair_back';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1067, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'area_m2', -1.371, 0.1229),
  ('chair_back', 1, 'aspect', 0.1545, 0.07755),
  ('chair_back', 1, 'behind', 0.7498, 0.06611),
  ('chair_back', 1, 'edge_free', 0.8844, 0.0816),
  ('chair_back', 1, 'edge_free_top', 0.9989, 0.03148),
  ('chair_back', 1, 'edge_joined', 0.0366, 0.05054),
  ('chair_back', 1, 'edge_unseen', 0.003479, 0.03239),
  ('chair_back', 1, 'height', 0.7896, 0.07438),
  ('chair_back', 1, 'length', -0.5321, 0.09155),
  ('chair_back', 1, 'rectangularity', 0.8981, 0.03189),
  ('chair_back', 1, 'spread_length', -0.6921, 0.05364),
  ('chair_back', 1, 'spread_width', -0.818, 0.08709),
  ('chair_back', 1, 'tilt_deg', 81.12, 2.635),
  ('chair_back', 1, 'width', -0.6889, 0.08105),
  ('chair_back', 1, 'z_max', 1.009, 0.09346),
  ('chair_back', 1, 'z_min', 0.4293, 0.1037);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.1512, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'area_m2', -1.748, 0.1744),
  ('chair_back', 2, 'aspect', 0.1516, 0.1306),
  ('chair_back', 2, 'behind', 0.4092, 0.3835),
  ('chair_back', 2, 'edge_free', 0.7986, 0.1551),
  ('chair_back', 2, 'edge_free_top', 0.9986, 0.03116),
  ('chair_back', 2, 'edge_joined', 0.1276, 0.1734),
  ('chair_back', 2, 'edge_unseen', 0.0835, 0.1159),
  ('chair_back', 2, 'height', 0.7881, 0.05582),
  ('chair_back', 2, 'length', -0.6883, 0.0876),
  ('chair_back', 2, 'rectangularity', 0.8462, 0.1015),
  ('chair_back', 2, 'spread_length', -0.7621, 0.04301),
  ('chair_back', 2, 'spread_width', -1.025, 0.142),
  ('chair_back', 2, 'tilt_deg', 80.62, 2.727),
  ('chair_back', 2, 'width', -0.8692, 0.09557),
  ('chair_back', 2, 'z_max', 0.9446, 0.0472),
  ('chair_back', 2, 'z_min', 0.4919, 0.09289);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.1111, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'area_m2', -1.396, 0.1789),
  ('chair_back', 3, 'aspect', 0.2275, 0.1536),
  ('chair_back', 3, 'behind', 0.7487, 0.1002),
  ('chair_back', 3, 'edge_free', 0.5452, 0.104),
  ('chair_back', 3, 'edge_free_top', 0.8239, 0.2355),
  ('chair_back', 3, 'edge_joined', 0.3832, 0.1832),
  ('chair_back', 3, 'edge_unseen', 0.002671, 0.03136),
  ('chair_back', 3, 'height', 0.8083, 0.05217),
  ('chair_back', 3, 'length', -0.4879, 0.1276),
  ('chair_back', 3, 'rectangularity', 0.8098, 0.06865),
  ('chair_back', 3, 'spread_length', -0.6509, 0.1072),
  ('chair_back', 3, 'spread_width', -0.8105, 0.07674),
  ('chair_back', 3, 'tilt_deg', 79.52, 2.708),
  ('chair_back', 3, 'width', -0.7001, 0.1067),
  ('chair_back', 3, 'z_max', 1.023, 0.05991),
  ('chair_back', 3, 'z_min', 0.4025, 0.05154);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.1102, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'area_m2', -1.889, 0.1853),
  ('chair_back', 4, 'aspect', 0.6564, 0.2446),
  ('chair_back', 4, 'behind', 0.7553, 0.07249),
  ('chair_back', 4, 'edge_free', 0.7701, 0.117),
  ('chair_back', 4, 'edge_free_top', 0.9909, 0.03187),
  ('chair_back', 4, 'edge_joined', 0.1266, 0.08409),
  ('chair_back', 4, 'edge_unseen', 0.001183, 0.03),
  ('chair_back', 4, 'height', 0.8, 0.07117),
  ('chair_back', 4, 'length', -0.4733, 0.1332),
  ('chair_back', 4, 'rectangularity', 0.7451, 0.1237),
  ('chair_back', 4, 'spread_length', -0.639, 0.1078),
  ('chair_back', 4, 'spread_width', -1.404, 0.14),
  ('chair_back', 4, 'tilt_deg', 80.42, 2.563),
  ('chair_back', 4, 'width', -1.109, 0.1525),
  ('chair_back', 4, 'z_max', 1.035, 0.09633),
  ('chair_back', 4, 'z_min', 0.4134, 0.07469);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.1066, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'area_m2', -1.191, 0.1509),
  ('chair_back', 5, 'aspect', 0.4525, 0.1144),
  ('chair_back', 5, 'behind', 0.5079, 0.2614),
  ('chair_back', 5, 'edge_free', 0.985, 0.03),
  ('chair_back', 5, 'edge_free_top', 0.9978, 0.03054),
  ('chair_back', 5, 'edge_joined', 0.01113, 0.03054),
  ('chair_back', 5, 'edge_unseen', 0.01612, 0.04427),
  ('chair_back', 5, 'height', 0.8205, 0.0496),
  ('chair_back', 5, 'length', -0.3058, 0.1015),
  ('chair_back', 5, 'rectangularity', 0.8746, 0.06279),
  ('chair_back', 5, 'spread_length', -0.4924, 0.06348),
  ('chair_back', 5, 'spread_width', -0.8623, 0.1356),
  ('chair_back', 5, 'tilt_deg', 80.71, 3.077),
  ('chair_back', 5, 'width', -0.747, 0.09026),
  ('chair_back', 5, 'z_max', 1.07, 0.0589),
  ('chair_back', 5, 'z_min', 0.3421, 0.0572);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.09172, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'area_m2', -1.459, 0.128),
  ('chair_back', 6, 'aspect', 0.5379, 0.1326),
  ('chair_back', 6, 'behind', 0.4428, 0.2721),
  ('chair_back', 6, 'edge_free', 0.8504, 0.09564),
  ('chair_back', 6, 'edge_free_top', 0.9957, 0.03),
  ('chair_back', 6, 'edge_joined', 0.1057, 0.09839),
  ('chair_back', 6, 'edge_unseen', 0.1007, 0.1373),
  ('chair_back', 6, 'height', 0.8585, 0.04348),
  ('chair_back', 6, 'length', -0.3083, 0.09767),
  ('chair_back', 6, 'rectangularity', 0.7385, 0.08928),
  ('chair_back', 6, 'spread_length', -0.5474, 0.07406),
  ('chair_back', 6, 'spread_width', -1.132, 0.1735),
  ('chair_back', 6, 'tilt_deg', 80.54, 2.553),
  ('chair_back', 6, 'width', -0.8418, 0.1016),
  ('chair_back', 6, 'z_max', 1.101, 0.04969),
  ('chair_back', 6, 'z_min', 0.3775, 0.07144);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.06669, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'area_m2', -2.716, 0.4834),
  ('chair_back', 7, 'aspect', 0.3512, 0.2256),
  ('chair_back', 7, 'behind', 0.06222, 0.158),
  ('chair_back', 7, 'edge_free', 0.9732, 0.08172),
  ('chair_back', 7, 'edge_free_top', 0.9971, 0.03083),
  ('chair_back', 7, 'edge_joined', 0.01597, 0.06106),
  ('chair_back', 7, 'edge_unseen', 0.4774, 0.1415),
  ('chair_back', 7, 'height', 0.8402, 0.2918),
  ('chair_back', 7, 'length', -0.8779, 0.2402),
  ('chair_back', 7, 'rectangularity', 0.6154, 0.06861),
  ('chair_back', 7, 'spread_length', -1.114, 0.2337),
  ('chair_back', 7, 'spread_width', -1.654, 0.2958),
  ('chair_back', 7, 'tilt_deg', 80.48, 2.327),
  ('chair_back', 7, 'width', -1.344, 0.3157),
  ('chair_back', 7, 'z_max', 1.012, 0.09998),
  ('chair_back', 7, 'z_min', 0.5955, 0.1264);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.04746, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'area_m2', -2.392, 0.5632),
  ('chair_back', 8, 'aspect', 0.6358, 0.3134),
  ('chair_back', 8, 'behind', 0.5374, 0.429),
  ('chair_back', 8, 'edge_free', 0.4919, 0.1888),
  ('chair_back', 8, 'edge_free_top', 0.5209, 0.3086),
  ('chair_back', 8, 'edge_joined', 0.2056, 0.2398),
  ('chair_back', 8, 'edge_unseen', 0.1359, 0.1911),
  ('chair_back', 8, 'height', 0.8263, 0.08491),
  ('chair_back', 8, 'length', -0.6802, 0.2581),
  ('chair_back', 8, 'rectangularity', 0.6761, 0.1546),
  ('chair_back', 8, 'spread_length', -0.8418, 0.2319),
  ('chair_back', 8, 'spread_width', -1.61, 0.3393),
  ('chair_back', 8, 'tilt_deg', 80.04, 2.531),
  ('chair_back', 8, 'width', -1.287, 0.3406),
  ('chair_back', 8, 'z_max', 1.054, 0.09626),
  ('chair_back', 8, 'z_min', 0.5362, 0.08776);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.07542, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'area_m2', -2.623, 0.3211),
  ('chair_back', 9, 'aspect', 0.5465, 0.3539),
  ('chair_back', 9, 'behind', 0.6369, 0.2985),
  ('chair_back', 9, 'edge_free', 0.6323, 0.1141),
  ('chair_back', 9, 'edge_free_top', 0.9978, 0.03),
  ('chair_back', 9, 'edge_joined', 0.09246, 0.1317),
  ('chair_back', 9, 'edge_unseen', 0.001964, 0.03),
  ('chair_back', 9, 'height', 0.8435, 0.05785),
  ('chair_back', 9, 'length', -0.8659, 0.2045),
  ('chair_back', 9, 'rectangularity', 0.7893, 0.1231),
  ('chair_back', 9, 'spread_length', -0.9252, 0.1309),
  ('chair_back', 9, 'spread_width', -1.73, 0.2374),
  ('chair_back', 9, 'tilt_deg', 80.31, 2.509),
  ('chair_back', 9, 'width', -1.426, 0.2423),
  ('chair_back', 9, 'z_max', 1.027, 0.0622),
  ('chair_back', 9, 'z_min', 0.5947, 0.03417);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 10, 0.08285, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 10, 'area_m2', -1.124, 0.2128),
  ('chair_back', 10, 'aspect', 0.6279, 0.283),
  ('chair_back', 10, 'behind', 0.7378, 0.07274),
  ('chair_back', 10, 'edge_free', 0.7644, 0.159),
  ('chair_back', 10, 'edge_free_top', 0.9642, 0.0592),
  ('chair_back', 10, 'edge_joined', 0.1532, 0.1459),
  ('chair_back', 10, 'edge_unseen', 0.00962, 0.03),
  ('chair_back', 10, 'height', 0.758, 0.06177),
  ('chair_back', 10, 'length', -0.0242, 0.1668),
  ('chair_back', 10, 'rectangularity', 0.6244, 0.09768),
  ('chair_back', 10, 'spread_length', -0.4281, 0.1276),
  ('chair_back', 10, 'spread_width', -0.8434, 0.1897),
  ('chair_back', 10, 'tilt_deg', 80.29, 2.882),
  ('chair_back', 10, 'width', -0.6283, 0.2304),
  ('chair_back', 10, 'z_max', 1.015, 0.08324),
  ('chair_back', 10, 'z_min', 0.06396, 0.09841);

-- door: 314 examples
UPDATE object_class SET prior = 0.01728 WHERE name = 'door';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.18, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'area_m2', 0.558, 0.08622),
  ('door', 1, 'aspect', 0.7746, 0.07674),
  ('door', 1, 'behind', -0.009061, 0.03),
  ('door', 1, 'edge_free', -0.0005506, 0.03188),
  ('door', 1, 'edge_free_top', 0.002136, 0.03366),
  ('door', 1, 'edge_joined', 0.4373, 0.3074),
  ('door', 1, 'edge_unseen', 0.007847, 0.03385),
  ('door', 1, 'height', 1.076, 0.06433),
  ('door', 1, 'length', 0.7179, 0.03454),
  ('door', 1, 'rectangularity', 0.9071, 0.0676),
  ('door', 1, 'spread_length', 0.6419, 0.04554),
  ('door', 1, 'spread_width', -0.1413, 0.05458),
  ('door', 1, 'tilt_deg', 89.98, 0.4652),
  ('door', 1, 'width', -0.07228, 0.07324),
  ('door', 1, 'z_max', 2.045, 0.04667),
  ('door', 1, 'z_min', 0.004421, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1559, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'area_m2', 0.5839, 0.1215),
  ('door', 2, 'aspect', 0.843, 0.07482),
  ('door', 2, 'behind', 0.5267, 0.1342),
  ('door', 2, 'edge_free', 0.3961, 0.1444),
  ('door', 2, 'edge_free_top', 0.7889, 0.1797),
  ('door', 2, 'edge_joined', 0.3276, 0.3091),
  ('door', 2, 'edge_unseen', 0.004045, 0.03),
  ('door', 2, 'height', 1.078, 0.04072),
  ('door', 2, 'length', 0.7992, 0.07724),
  ('door', 2, 'rectangularity', 0.83, 0.04859),
  ('door', 2, 'spread_length', 0.6746, 0.04147),
  ('door', 2, 'spread_width', -0.124, 0.09511),
  ('door', 2, 'tilt_deg', 89.98, 0.45),
  ('door', 2, 'width', -0.02516, 0.09264),
  ('door', 2, 'z_max', 2.203, 0.1225),
  ('door', 2, 'z_min', -0.00764, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.09483, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'area_m2', 0.2967, 0.1559),
  ('door', 3, 'aspect', 0.8609, 0.1212),
  ('door', 3, 'behind', -0.001635, 0.03),
  ('door', 3, 'edge_free', 0.002175, 0.03),
  ('door', 3, 'edge_free_top', 0.005133, 0.03441),
  ('door', 3, 'edge_joined', 0.327, 0.2953),
  ('door', 3, 'edge_unseen', 0.2498, 0.2071),
  ('door', 3, 'height', 1.221, 0.1028),
  ('door', 3, 'length', 0.7066, 0.05176),
  ('door', 3, 'rectangularity', 0.7745, 0.1049),
  ('door', 3, 'spread_length', 0.4475, 0.1275),
  ('door', 3, 'spread_width', -0.2672, 0.1366),
  ('door', 3, 'tilt_deg', 89.96, 0.45),
  ('door', 3, 'width', -0.1509, 0.1338),
  ('door', 3, 'z_max', 2.061, 0.0398),
  ('door', 3, 'z_min', 0.04051, 0.08484);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.1197, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'area_m2', 0.1565, 0.4948),
  ('door', 4, 'aspect', 0.5009, 0.2045),
  ('door', 4, 'behind', -0.0008112, 0.03),
  ('door', 4, 'edge_free', -0.003067, 0.03),
  ('door', 4, 'edge_free_top', 0.006451, 0.03296),
  ('door', 4, 'edge_joined', 0.421, 0.3239),
  ('door', 4, 'edge_unseen', 0.2015, 0.2289),
  ('door', 4, 'height', 1.294, 0.1756),
  ('door', 4, 'length', 0.4993, 0.2525),
  ('door', 4, 'rectangularity', 0.7354, 0.1441),
  ('door', 4, 'spread_length', 0.1591, 0.3007),
  ('door', 4, 'spread_width', -0.2075, 0.1288),
  ('door', 4, 'tilt_deg', 89.89, 0.6163),
  ('door', 4, 'width', -0.07754, 0.114),
  ('door', 4, 'z_max', 2.057, 0.05712),
  ('door', 4, 'z_min', 0.3202, 0.1936);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.1199, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'area_m2', 0.2673, 0.2186),
  ('door', 5, 'aspect', 0.7484, 0.09356),
  ('door', 5, 'behind', 0.4772, 0.1173),
  ('door', 5, 'edge_free', 0.5413, 0.2534),
  ('door', 5, 'edge_free_top', 0.7721, 0.2183),
  ('door', 5, 'edge_joined', 0.2229, 0.2545),
  ('door', 5, 'edge_unseen', 0.2056, 0.1856),
  ('door', 5, 'height', 1.289, 0.08929),
  ('door', 5, 'length', 0.6797, 0.1292),
  ('door', 5, 'rectangularity', 0.7255, 0.1161),
  ('door', 5, 'spread_length', 0.2807, 0.1436),
  ('door', 5, 'spread_width', -0.1749, 0.09717),
  ('door', 5, 'tilt_deg', 89.97, 0.45),
  ('door', 5, 'width', -0.07434, 0.06778),
  ('door', 5, 'z_max', 2.184, 0.09298),
  ('door', 5, 'z_min', 0.2385, 0.3011);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.0814, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'area_m2', -0.4207, 0.3831),
  ('door', 6, 'aspect', 1.384, 0.2042),
  ('door', 6, 'behind', 0.1093, 0.1594),
  ('door', 6, 'edge_free', 0.1551, 0.2697),
  ('door', 6, 'edge_free_top', 0.3005, 0.3947),
  ('door', 6, 'edge_joined', 0.2523, 0.2528),
  ('door', 6, 'edge_unseen', 0.3499, 0.1254),
  ('door', 6, 'height', 1.114, 0.1219),
  ('door', 6, 'length', 0.6642, 0.1362),
  ('door', 6, 'rectangularity', 0.7123, 0.1227),
  ('door', 6, 'spread_length', 0.5986, 0.1477),
  ('door', 6, 'spread_width', -1.104, 0.3581),
  ('door', 6, 'tilt_deg', 89.21, 1.558),
  ('door', 6, 'width', -0.7971, 0.3603),
  ('door', 6, 'z_max', 2.043, 0.09751),
  ('door', 6, 'z_min', 0.05015, 0.1207);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.05033, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'area_m2', -2.273, 0.5993),
  ('door', 7, 'aspect', 1.014, 0.3569),
  ('door', 7, 'behind', 0.01969, 0.1084),
  ('door', 7, 'edge_free', 0.2526, 0.3146),
  ('door', 7, 'edge_free_top', 0.2232, 0.377),
  ('door', 7, 'edge_joined', 0.592, 0.2962),
  ('door', 7, 'edge_unseen', 0.07765, 0.1094),
  ('door', 7, 'height', 1.214, 0.3327),
  ('door', 7, 'length', -0.5208, 0.4116),
  ('door', 7, 'rectangularity', 0.7659, 0.06642),
  ('door', 7, 'spread_length', -0.6304, 0.406),
  ('door', 7, 'spread_width', -1.671, 0.2555),
  ('door', 7, 'tilt_deg', 88.1, 2.847),
  ('door', 7, 'width', -1.448, 0.1628),
  ('door', 7, 'z_max', 1.518, 0.3177),
  ('door', 7, 'z_min', 0.8276, 0.4234);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.06717, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'area_m2', -0.2714, 0.2162),
  ('door', 8, 'aspect', 0.9173, 0.4001),
  ('door', 8, 'behind', 0.2529, 0.09919),
  ('door', 8, 'edge_free', 0.3172, 0.07812),
  ('door', 8, 'edge_free_top', 0.04413, 0.08434),
  ('door', 8, 'edge_joined', 0.05186, 0.07101),
  ('door', 8, 'edge_unseen', 0.08626, 0.1047),
  ('door', 8, 'height', 0.939, 0.2427),
  ('door', 8, 'length', 0.6433, 0.2263),
  ('door', 8, 'rectangularity', 0.6055, 0.1208),
  ('door', 8, 'spread_length', 0.5279, 0.2188),
  ('door', 8, 'spread_width', -0.9524, 0.265),
  ('door', 8, 'tilt_deg', 74.79, 3.322),
  ('door', 8, 'width', -0.3566, 0.1659),
  ('door', 8, 'z_max', 1.55, 0.4711),
  ('door', 8, 'z_min', 0.1385, 0.2546);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.04562, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'area_m2', -0.2935, 0.3635),
  ('door', 9, 'aspect', 0.3105, 0.1294),
  ('door', 9, 'behind', 0.5641, 0.163),
  ('door', 9, 'edge_free', 0.2063, 0.1713),
  ('door', 9, 'edge_free_top', 0.3503, 0.2666),
  ('door', 9, 'edge_joined', 0.6273, 0.274),
  ('door', 9, 'edge_unseen', 0.2252, 0.09327),
  ('door', 9, 'height', 1.342, 0.1402),
  ('door', 9, 'length', 0.1884, 0.1996),
  ('door', 9, 'rectangularity', 0.7058, 0.1178),
  ('door', 9, 'spread_length', -0.006095, 0.1605),
  ('door', 9, 'spread_width', -0.3485, 0.2847),
  ('door', 9, 'tilt_deg', 89.18, 1.4),
  ('door', 9, 'width', -0.1292, 0.1179),
  ('door', 9, 'z_max', 1.978, 0.2634),
  ('door', 9, 'z_min', 0.7251, 0.2346);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.0352, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'area_m2', -1.305, 0.6602),
  ('door', 10, 'aspect', 0.8244, 0.3102),
  ('door', 10, 'behind', 0.04722, 0.1371),
  ('door', 10, 'edge_free', 0.1083, 0.1267),
  ('door', 10, 'edge_free_top', 0.1009, 0.158),
  ('door', 10, 'edge_joined', 0.2593, 0.1623),
  ('door', 10, 'edge_unseen', 0.1271, 0.1509),
  ('door', 10, 'height', 0.5092, 0.1912),
  ('door', 10, 'length', -0.1046, 0.327),
  ('door', 10, 'rectangularity', 0.8031, 0.1126),
  ('door', 10, 'spread_length', -0.1363, 0.3019),
  ('door', 10, 'spread_width', -1.062, 0.2454),
  ('door', 10, 'tilt_deg', 89.25, 0.825),
  ('door', 10, 'width', -0.933, 0.2417),
  ('door', 10, 'z_max', 0.9001, 0.2898),
  ('door', 10, 'z_min', 0.04473, 0.06317);

-- window: 657 examples
UPDATE object_class SET prior = 0.02286 WHERE name = 'window';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.1566, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'area_m2', -0.06489, 0.1422),
  ('window', 1, 'aspect', 0.2893, 0.1944),
  ('window', 1, 'behind', -0.002786, 0.03),
  ('window', 1, 'edge_free', 0.01127, 0.04171),
  ('window', 1, 'edge_free_top', 0.001534, 0.03),
  ('window', 1, 'edge_joined', 0.5603, 0.4221),
  ('window', 1, 'edge_unseen', 0.1493, 0.05461),
  ('window', 1, 'height', 1.441, 0.1424),
  ('window', 1, 'length', 0.2159, 0.1214),
  ('window', 1, 'rectangularity', 0.8907, 0.05112),
  ('window', 1, 'spread_length', 0.2271, 0.1224),
  ('window', 1, 'spread_width', -0.177, 0.1521),
  ('window', 1, 'tilt_deg', 89.54, 0.45),
  ('window', 1, 'width', -0.1283, 0.1041),
  ('window', 1, 'z_max', 2.075, 0.1954),
  ('window', 1, 'z_min', 0.9573, 0.06477);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1277, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'area_m2', 0.2873, 0.1569),
  ('window', 2, 'aspect', 0.1586, 0.1058),
  ('window', 2, 'behind', -0.0006613, 0.03),
  ('window', 2, 'edge_free', -0.005104, 0.03),
  ('window', 2, 'edge_free_top', -0.001487, 0.03),
  ('window', 2, 'edge_joined', 0.02906, 0.04436),
  ('window', 2, 'edge_unseen', 0.01021, 0.03937),
  ('window', 2, 'height', 1.521, 0.08965),
  ('window', 2, 'length', 0.3236, 0.1058),
  ('window', 2, 'rectangularity', 0.8988, 0.0876),
  ('window', 2, 'spread_length', 0.4682, 0.07769),
  ('window', 2, 'spread_width', 0.2502, 0.1096),
  ('window', 2, 'tilt_deg', 89.81, 0.45),
  ('window', 2, 'width', 0.1017, 0.09507),
  ('window', 2, 'z_max', 2.122, 0.1151),
  ('window', 2, 'z_min', 0.8961, 0.05089);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.07661, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'area_m2', -0.7329, 0.2864),
  ('window', 3, 'aspect', 0.4012, 0.2787),
  ('window', 3, 'behind', -0.005224, 0.03),
  ('window', 3, 'edge_free', 0.0005435, 0.03),
  ('window', 3, 'edge_free_top', 0.0006525, 0.03),
  ('window', 3, 'edge_joined', 0.734, 0.2618),
  ('window', 3, 'edge_unseen', 0.3402, 0.2282),
  ('window', 3, 'height', 1.382, 0.1828),
  ('window', 3, 'length', 0.001132, 0.1778),
  ('window', 3, 'rectangularity', 0.7903, 0.1713),
  ('window', 3, 'spread_length', -0.02737, 0.1788),
  ('window', 3, 'spread_width', -0.6026, 0.2361),
  ('window', 3, 'tilt_deg', 89.6, 0.45),
  ('window', 3, 'width', -0.4717, 0.2062),
  ('window', 3, 'z_max', 1.838, 0.2612),
  ('window', 3, 'z_min', 0.9967, 0.06402);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.153, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'area_m2', -0.5775, 0.4116),
  ('window', 4, 'aspect', 0.5604, 0.3034),
  ('window', 4, 'behind', -0.005808, 0.03),
  ('window', 4, 'edge_free', 0.1793, 0.107),
  ('window', 4, 'edge_free_top', 0.01186, 0.03),
  ('window', 4, 'edge_joined', 0.4449, 0.2634),
  ('window', 4, 'edge_unseen', 0.1927, 0.09604),
  ('window', 4, 'height', 1.838, 0.12),
  ('window', 4, 'length', 0.1041, 0.2407),
  ('window', 4, 'rectangularity', 0.8076, 0.07498),
  ('window', 4, 'spread_length', 0.1572, 0.1545),
  ('window', 4, 'spread_width', -0.6633, 0.2685),
  ('window', 4, 'tilt_deg', 89.79, 0.45),
  ('window', 4, 'width', -0.5001, 0.2816),
  ('window', 4, 'z_max', 2.152, 0.1261),
  ('window', 4, 'z_min', 1.532, 0.2074);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.1088, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'area_m2', -0.05322, 0.2764),
  ('window', 5, 'aspect', 0.2053, 0.154),
  ('window', 5, 'behind', -0.001111, 0.03),
  ('window', 5, 'edge_free', 0.09227, 0.1119),
  ('window', 5, 'edge_free_top', 0.02513, 0.06383),
  ('window', 5, 'edge_joined', 0.1715, 0.1715),
  ('window', 5, 'edge_unseen', 0.138, 0.1375),
  ('window', 5, 'height', 1.578, 0.1405),
  ('window', 5, 'length', 0.3439, 0.1011),
  ('window', 5, 'rectangularity', 0.6593, 0.2371),
  ('window', 5, 'spread_length', 0.4211, 0.1773),
  ('window', 5, 'spread_width', 0.09128, 0.1694),
  ('window', 5, 'tilt_deg', 89.71, 0.473),
  ('window', 5, 'width', 0.1102, 0.1046),
  ('window', 5, 'z_max', 2.212, 0.1083),
  ('window', 5, 'z_min', 0.9345, 0.07203);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.08739, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'area_m2', -0.4067, 0.4013),
  ('window', 6, 'aspect', 0.3734, 0.2446),
  ('window', 6, 'behind', -0.006039, 0.03),
  ('window', 6, 'edge_free', 0.3911, 0.2542),
  ('window', 6, 'edge_free_top', 0.4642, 0.3694),
  ('window', 6, 'edge_joined', 0.4589, 0.2367),
  ('window', 6, 'edge_unseen', 0.09076, 0.1155),
  ('window', 6, 'height', 1.455, 0.128),
  ('window', 6, 'length', 0.1079, 0.1784),
  ('window', 6, 'rectangularity', 0.8093, 0.07856),
  ('window', 6, 'spread_length', 0.07151, 0.1693),
  ('window', 6, 'spread_width', -0.4003, 0.2639),
  ('window', 6, 'tilt_deg', 89.72, 0.45),
  ('window', 6, 'width', -0.2841, 0.2366),
  ('window', 6, 'z_max', 2.003, 0.1438),
  ('window', 6, 'z_min', 1.025, 0.06718);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.1382, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'area_m2', -1.256, 0.4597),
  ('window', 7, 'aspect', 1.233, 0.3186),
  ('window', 7, 'behind', -0.002504, 0.03),
  ('window', 7, 'edge_free', 0.002784, 0.04503),
  ('window', 7, 'edge_free_top', 0.01121, 0.04263),
  ('window', 7, 'edge_joined', 0.3406, 0.2069),
  ('window', 7, 'edge_unseen', 0.1347, 0.1607),
  ('window', 7, 'height', 1.209, 0.1778),
  ('window', 7, 'length', 0.1638, 0.1614),
  ('window', 7, 'rectangularity', 0.7592, 0.1364),
  ('window', 7, 'spread_length', 0.2004, 0.136),
  ('window', 7, 'spread_width', -1.285, 0.4415),
  ('window', 7, 'tilt_deg', 88.89, 0.7509),
  ('window', 7, 'width', -1.099, 0.2741),
  ('window', 7, 'z_max', 1.511, 0.399),
  ('window', 7, 'z_min', 0.9206, 0.0425);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.04509, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'area_m2', -2.034, 0.3875),
  ('window', 8, 'aspect', 0.4704, 0.3142),
  ('window', 8, 'behind', -0.01269, 0.09985),
  ('window', 8, 'edge_free', 0.04357, 0.07007),
  ('window', 8, 'edge_free_top', 0.003525, 0.03),
  ('window', 8, 'edge_joined', 0.6749, 0.1754),
  ('window', 8, 'edge_unseen', 0.332, 0.2351),
  ('window', 8, 'height', 1.457, 0.2827),
  ('window', 8, 'length', -0.5136, 0.3502),
  ('window', 8, 'rectangularity', 0.6806, 0.07873),
  ('window', 8, 'spread_length', -0.5629, 0.2238),
  ('window', 8, 'spread_width', -1.214, 0.283),
  ('window', 8, 'tilt_deg', 89.68, 0.45),
  ('window', 8, 'width', -1.086, 0.2398),
  ('window', 8, 'z_max', 1.754, 0.3687),
  ('window', 8, 'z_min', 1.222, 0.2113);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.02131, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'area_m2', -1.399, 0.7718),
  ('window', 9, 'aspect', 1.033, 0.4694),
  ('window', 9, 'behind', 0.04352, 0.22),
  ('window', 9, 'edge_free', 0.3228, 0.1614),
  ('window', 9, 'edge_free_top', 0.4252, 0.2282),
  ('window', 9, 'edge_joined', 0.2603, 0.1808),
  ('window', 9, 'edge_unseen', 0.09602, 0.119),
  ('window', 9, 'height', 1.218, 0.2545),
  ('window', 9, 'length', -0.02103, 0.5056),
  ('window', 9, 'rectangularity', 0.6641, 0.1563),
  ('window', 9, 'spread_length', 0.05714, 0.3905),
  ('window', 9, 'spread_width', -1.162, 0.517),
  ('window', 9, 'tilt_deg', 87.69, 6.04),
  ('window', 9, 'width', -0.9562, 0.4516),
  ('window', 9, 'z_max', 1.614, 0.5027),
  ('window', 9, 'z_min', 0.8805, 0.1973);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.03536, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'area_m2', 1.318, 0.4434),
  ('window', 10, 'aspect', 0.9107, 0.264),
  ('window', 10, 'behind', -0.0006698, 0.03),
  ('window', 10, 'edge_free', 0.00534, 0.03),
  ('window', 10, 'edge_free_top', 0.00619, 0.03),
  ('window', 10, 'edge_joined', 0.2117, 0.2258),
  ('window', 10, 'edge_unseen', 0.1299, 0.1094),
  ('window', 10, 'height', 1.483, 0.07785),
  ('window', 10, 'length', 1.235, 0.2492),
  ('window', 10, 'rectangularity', 0.744, 0.2013),
  ('window', 10, 'spread_length', 1.201, 0.1915),
  ('window', 10, 'spread_width', 0.2482, 0.193),
  ('window', 10, 'tilt_deg', 89.87, 0.45),
  ('window', 10, 'width', 0.3699, 0.2789),
  ('window', 10, 'z_max', 2.337, 0.2473),
  ('window', 10, 'z_min', 0.8065, 0.2605);

-- whiteboard: 263 examples
UPDATE object_class SET prior = 0.01156 WHERE name = 'whiteboard';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.3159, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'area_m2', 0.6691, 0.1461),
  ('whiteboard', 1, 'aspect', 0.5773, 0.1493),
  ('whiteboard', 1, 'behind', -0.0005381, 0.03),
  ('whiteboard', 1, 'edge_free', 0.03219, 0.03),
  ('whiteboard', 1, 'edge_free_top', 0.0354, 0.03682),
  ('whiteboard', 1, 'edge_joined', 0.8559, 0.09803),
  ('whiteboard', 1, 'edge_unseen', 0.07644, 0.1046),
  ('whiteboard', 1, 'height', 1.427, 0.06508),
  ('whiteboard', 1, 'length', 0.681, 0.1277),
  ('whiteboard', 1, 'rectangularity', 0.8431, 0.07793),
  ('whiteboard', 1, 'spread_length', 0.5134, 0.1143),
  ('whiteboard', 1, 'spread_width', -0.1312, 0.1105),
  ('whiteboard', 1, 'tilt_deg', 90.07, 0.45),
  ('whiteboard', 1, 'width', 0.1331, 0.07861),
  ('whiteboard', 1, 'z_max', 2.006, 0.1019),
  ('whiteboard', 1, 'z_min', 0.8852, 0.06993);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.201, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'area_m2', 0.2557, 0.1488),
  ('whiteboard', 2, 'aspect', 0.1847, 0.08459),
  ('whiteboard', 2, 'behind', 0.002458, 0.03799),
  ('whiteboard', 2, 'edge_free', 0.02451, 0.03),
  ('whiteboard', 2, 'edge_free_top', 0.02724, 0.03219),
  ('whiteboard', 2, 'edge_joined', 0.8046, 0.09954),
  ('whiteboard', 2, 'edge_unseen', 0.01113, 0.05015),
  ('whiteboard', 2, 'height', 1.48, 0.06542),
  ('whiteboard', 2, 'length', 0.2656, 0.1067),
  ('whiteboard', 2, 'rectangularity', 0.8815, 0.03782),
  ('whiteboard', 2, 'spread_length', 0.1531, 0.09143),
  ('whiteboard', 2, 'spread_width', -0.05188, 0.08217),
  ('whiteboard', 2, 'tilt_deg', 90.16, 0.45),
  ('whiteboard', 2, 'width', 0.09902, 0.05506),
  ('whiteboard', 2, 'z_max', 2.006, 0.09066),
  ('whiteboard', 2, 'z_min', 0.9071, 0.04484);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.1054, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'area_m2', -0.403, 0.3015),
  ('whiteboard', 3, 'aspect', 0.3794, 0.3095),
  ('whiteboard', 3, 'behind', -0.003347, 0.03),
  ('whiteboard', 3, 'edge_free', 0.01721, 0.03917),
  ('whiteboard', 3, 'edge_free_top', 0.01061, 0.03228),
  ('whiteboard', 3, 'edge_joined', 0.7663, 0.1508),
  ('whiteboard', 3, 'edge_unseen', 0.361, 0.2235),
  ('whiteboard', 3, 'height', 1.353, 0.09522),
  ('whiteboard', 3, 'length', 0.09506, 0.1377),
  ('whiteboard', 3, 'rectangularity', 0.7901, 0.05707),
  ('whiteboard', 3, 'spread_length', -0.119, 0.1059),
  ('whiteboard', 3, 'spread_width', -0.5459, 0.1088),
  ('whiteboard', 3, 'tilt_deg', 89.88, 0.7058),
  ('whiteboard', 3, 'width', -0.2657, 0.2628),
  ('whiteboard', 3, 'z_max', 1.981, 0.1312),
  ('whiteboard', 3, 'z_min', 0.877, 0.0445);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.1006, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'area_m2', 0.6711, 0.2758),
  ('whiteboard', 4, 'aspect', 0.5669, 0.2238),
  ('whiteboard', 4, 'behind', -0.001239, 0.03),
  ('whiteboard', 4, 'edge_free', 0.01914, 0.03),
  ('whiteboard', 4, 'edge_free_top', 0.02368, 0.03),
  ('whiteboard', 4, 'edge_joined', 0.6715, 0.08462),
  ('whiteboard', 4, 'edge_unseen', 0.2423, 0.1952),
  ('whiteboard', 4, 'height', 1.417, 0.0763),
  ('whiteboard', 4, 'length', 0.7667, 0.222),
  ('whiteboard', 4, 'rectangularity', 0.6822, 0.07539),
  ('whiteboard', 4, 'spread_length', 0.6196, 0.1845),
  ('whiteboard', 4, 'spread_width', -0.1989, 0.2555),
  ('whiteboard', 4, 'tilt_deg', 89.94, 0.5667),
  ('whiteboard', 4, 'width', 0.2514, 0.143),
  ('whiteboard', 4, 'z_max', 2.089, 0.0806),
  ('whiteboard', 4, 'z_min', 0.7702, 0.2722);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.05283, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'area_m2', -1.799, 0.5649),
  ('whiteboard', 5, 'aspect', 0.9304, 0.3245),
  ('whiteboard', 5, 'behind', -0.003457, 0.03),
  ('whiteboard', 5, 'edge_free', 0.03466, 0.08533),
  ('whiteboard', 5, 'edge_free_top', 0.04971, 0.04816),
  ('whiteboard', 5, 'edge_joined', 0.817, 0.2431),
  ('whiteboard', 5, 'edge_unseen', 0.3333, 0.1119),
  ('whiteboard', 5, 'height', 1.438, 0.238),
  ('whiteboard', 5, 'length', -0.2826, 0.2742),
  ('whiteboard', 5, 'rectangularity', 0.7426, 0.05652),
  ('whiteboard', 5, 'spread_length', -0.5563, 0.3127),
  ('whiteboard', 5, 'spread_width', -1.385, 0.3536),
  ('whiteboard', 5, 'tilt_deg', 89.46, 1.18),
  ('whiteboard', 5, 'width', -1.193, 0.4263),
  ('whiteboard', 5, 'z_max', 1.868, 0.2161),
  ('whiteboard', 5, 'z_min', 1.048, 0.1429);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.04792, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'area_m2', 0.2542, 0.388),
  ('whiteboard', 6, 'aspect', 0.3864, 0.3152),
  ('whiteboard', 6, 'behind', 0.003098, 0.03),
  ('whiteboard', 6, 'edge_free', 0.2548, 0.2432),
  ('whiteboard', 6, 'edge_free_top', 0.319, 0.1634),
  ('whiteboard', 6, 'edge_joined', 0.4372, 0.1567),
  ('whiteboard', 6, 'edge_unseen', 0.1288, 0.1341),
  ('whiteboard', 6, 'height', 1.336, 0.1103),
  ('whiteboard', 6, 'length', 0.459, 0.3003),
  ('whiteboard', 6, 'rectangularity', 0.7389, 0.09778),
  ('whiteboard', 6, 'spread_length', 0.3422, 0.3882),
  ('whiteboard', 6, 'spread_width', -0.2516, 0.2537),
  ('whiteboard', 6, 'tilt_deg', 89.48, 1.027),
  ('whiteboard', 6, 'width', 0.08376, 0.2133),
  ('whiteboard', 6, 'z_max', 1.895, 0.1487),
  ('whiteboard', 6, 'z_min', 0.7324, 0.1296);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.05859, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'area_m2', -0.1955, 0.3248),
  ('whiteboard', 7, 'aspect', 0.9895, 0.3853),
  ('whiteboard', 7, 'behind', 0.000576, 0.03),
  ('whiteboard', 7, 'edge_free', 0.00713, 0.03),
  ('whiteboard', 7, 'edge_free_top', 0.06852, 0.03),
  ('whiteboard', 7, 'edge_joined', 0.5135, 0.1513),
  ('whiteboard', 7, 'edge_unseen', 0.3967, 0.05941),
  ('whiteboard', 7, 'height', 0.9521, 0.2264),
  ('whiteboard', 7, 'length', 0.4625, 0.1414),
  ('whiteboard', 7, 'rectangularity', 0.7889, 0.08658),
  ('whiteboard', 7, 'spread_length', 0.3433, 0.1387),
  ('whiteboard', 7, 'spread_width', -0.6206, 0.3248),
  ('whiteboard', 7, 'tilt_deg', 87.9, 0.8435),
  ('whiteboard', 7, 'width', -0.4451, 0.3269),
  ('whiteboard', 7, 'z_max', 1.264, 0.2263),
  ('whiteboard', 7, 'z_min', 0.4834, 0.3332);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.03462, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'area_m2', -2.398, 0.5518),
  ('whiteboard', 8, 'aspect', 0.3865, 0.1524),
  ('whiteboard', 8, 'behind', -0.001532, 0.03),
  ('whiteboard', 8, 'edge_free', 0.06319, 0.1639),
  ('whiteboard', 8, 'edge_free_top', 0.002507, 0.03),
  ('whiteboard', 8, 'edge_joined', 0.8048, 0.197),
  ('whiteboard', 8, 'edge_unseen', 0.3106, 0.1025),
  ('whiteboard', 8, 'height', 1.209, 0.13),
  ('whiteboard', 8, 'length', -0.8957, 0.302),
  ('whiteboard', 8, 'rectangularity', 0.8111, 0.0452),
  ('whiteboard', 8, 'spread_length', -1.041, 0.3569),
  ('whiteboard', 8, 'spread_width', -1.504, 0.2639),
  ('whiteboard', 8, 'tilt_deg', 89.23, 1.485),
  ('whiteboard', 8, 'width', -1.28, 0.2947),
  ('whiteboard', 8, 'z_max', 1.395, 0.187),
  ('whiteboard', 8, 'z_min', 0.9158, 0.07076);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 9, 0.0331, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 9, 'area_m2', -0.3795, 0.8338),
  ('whiteboard', 9, 'aspect', 0.4401, 0.2555),
  ('whiteboard', 9, 'behind', 0.5614, 0.1919),
  ('whiteboard', 9, 'edge_free', 0.01978, 0.03093),
  ('whiteboard', 9, 'edge_free_top', 0.014, 0.03084),
  ('whiteboard', 9, 'edge_joined', 0.8612, 0.09614),
  ('whiteboard', 9, 'edge_unseen', 0.02234, 0.04214),
  ('whiteboard', 9, 'height', 1.435, 0.198),
  ('whiteboard', 9, 'length', 0.2889, 0.4911),
  ('whiteboard', 9, 'rectangularity', 0.6623, 0.2874),
  ('whiteboard', 9, 'spread_length', 0.2668, 0.5313),
  ('whiteboard', 9, 'spread_width', -0.2497, 0.4277),
  ('whiteboard', 9, 'tilt_deg', 72.68, 29.82),
  ('whiteboard', 9, 'width', -0.09557, 0.467),
  ('whiteboard', 9, 'z_max', 1.996, 0.6359),
  ('whiteboard', 9, 'z_min', 0.9797, 0.1394);

-- shelf: 1293 examples
UPDATE object_class SET prior = 0.09243 WHERE name = 'shelf';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.18, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'area_m2', -1.453, 0.432),
  ('shelf', 1, 'aspect', 0.9127, 0.394),
  ('shelf', 1, 'behind', 0.8004, 0.1639),
  ('shelf', 1, 'edge_free', 0.3684, 0.1054),
  ('shelf', 1, 'edge_free_top', 0.5154, 0.3543),
  ('shelf', 1, 'edge_joined', 0.179, 0.3035),
  ('shelf', 1, 'edge_unseen', 0.09792, 0.1164),
  ('shelf', 1, 'height', 1.124, 0.197),
  ('shelf', 1, 'length', 0.1123, 0.2939),
  ('shelf', 1, 'rectangularity', 0.7386, 0.1493),
  ('shelf', 1, 'spread_length', -0.2636, 0.3277),
  ('shelf', 1, 'spread_width', -1.128, 0.167),
  ('shelf', 1, 'tilt_deg', 90.15, 0.45),
  ('shelf', 1, 'width', -0.9529, 0.128),
  ('shelf', 1, 'z_max', 1.674, 0.2264),
  ('shelf', 1, 'z_min', 0.3668, 0.2614);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.1681, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'area_m2', -1.406, 0.4339),
  ('shelf', 2, 'aspect', 0.8322, 0.1615),
  ('shelf', 2, 'behind', 0.7565, 0.1065),
  ('shelf', 2, 'edge_free', 0.2853, 0.1218),
  ('shelf', 2, 'edge_free_top', 0.4211, 0.1033),
  ('shelf', 2, 'edge_joined', 0.6065, 0.272),
  ('shelf', 2, 'edge_unseen', 0.03459, 0.08972),
  ('shelf', 2, 'height', 1.656, 0.2558),
  ('shelf', 2, 'length', -0.1184, 0.23),
  ('shelf', 2, 'rectangularity', 0.779, 0.1287),
  ('shelf', 2, 'spread_length', -0.3649, 0.2516),
  ('shelf', 2, 'spread_width', -1.019, 0.09925),
  ('shelf', 2, 'tilt_deg', 0.341, 0.45),
  ('shelf', 2, 'width', -0.9212, 0.111),
  ('shelf', 2, 'z_max', 1.625, 0.2636),
  ('shelf', 2, 'z_min', 1.641, 0.2542);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.1104, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'area_m2', -0.6053, 0.3525),
  ('shelf', 3, 'aspect', 1.558, 0.1218),
  ('shelf', 3, 'behind', 0.7467, 0.1106),
  ('shelf', 3, 'edge_free', 0.3854, 0.0717),
  ('shelf', 3, 'edge_free_top', 0.5041, 0.269),
  ('shelf', 3, 'edge_joined', 0.2546, 0.1849),
  ('shelf', 3, 'edge_unseen', 0.01109, 0.03),
  ('shelf', 3, 'height', 1.01, 0.1094),
  ('shelf', 3, 'length', 0.6107, 0.1325),
  ('shelf', 3, 'rectangularity', 0.7229, 0.1163),
  ('shelf', 3, 'spread_length', 0.4628, 0.1242),
  ('shelf', 3, 'spread_width', -1.061, 0.1465),
  ('shelf', 3, 'tilt_deg', 89.88, 1.605),
  ('shelf', 3, 'width', -0.9133, 0.1193),
  ('shelf', 3, 'z_max', 1.967, 0.1411),
  ('shelf', 3, 'z_min', 0.07424, 0.1139);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.0999, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'area_m2', -1.701, 0.3927),
  ('shelf', 4, 'aspect', 1.067, 0.3966),
  ('shelf', 4, 'behind', 0.7155, 0.1284),
  ('shelf', 4, 'edge_free', 0.3945, 0.0605),
  ('shelf', 4, 'edge_free_top', 0.419, 0.1074),
  ('shelf', 4, 'edge_joined', 0.4055, 0.1073),
  ('shelf', 4, 'edge_unseen', 0.01192, 0.03801),
  ('shelf', 4, 'height', 0.4697, 0.06157),
  ('shelf', 4, 'length', -0.173, 0.2377),
  ('shelf', 4, 'rectangularity', 0.6957, 0.1078),
  ('shelf', 4, 'spread_length', -0.257, 0.1311),
  ('shelf', 4, 'spread_width', -1.356, 0.2031),
  ('shelf', 4, 'tilt_deg', 2.031, 1.254),
  ('shelf', 4, 'width', -1.082, 0.1818),
  ('shelf', 4, 'z_max', 0.4738, 0.05752),
  ('shelf', 4, 'z_min', 0.479, 0.06589);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.073, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'area_m2', -1.579, 0.3996),
  ('shelf', 5, 'aspect', 0.9171, 0.2724),
  ('shelf', 5, 'behind', 0.8278, 0.06897),
  ('shelf', 5, 'edge_free', 0.3111, 0.1344),
  ('shelf', 5, 'edge_free_top', 0.417, 0.1048),
  ('shelf', 5, 'edge_joined', 0.5845, 0.235),
  ('shelf', 5, 'edge_unseen', 0.03447, 0.07694),
  ('shelf', 5, 'height', 0.8986, 0.146),
  ('shelf', 5, 'length', -0.09052, 0.2104),
  ('shelf', 5, 'rectangularity', 0.7339, 0.1392),
  ('shelf', 5, 'spread_length', -0.3449, 0.201),
  ('shelf', 5, 'spread_width', -1.299, 0.2736),
  ('shelf', 5, 'tilt_deg', 0.7915, 0.6699),
  ('shelf', 5, 'width', -0.9649, 0.1388),
  ('shelf', 5, 'z_max', 0.8697, 0.1351),
  ('shelf', 5, 'z_min', 0.9142, 0.1401);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.07227, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'area_m2', -2.724, 0.2434),
  ('shelf', 6, 'aspect', 0.7245, 0.5952),
  ('shelf', 6, 'behind', 0.5918, 0.197),
  ('shelf', 6, 'edge_free', 0.3015, 0.1356),
  ('shelf', 6, 'edge_free_top', 0.4315, 0.3061),
  ('shelf', 6, 'edge_joined', 0.3464, 0.2455),
  ('shelf', 6, 'edge_unseen', 0.255, 0.0984),
  ('shelf', 6, 'height', 0.8059, 0.5125),
  ('shelf', 6, 'length', -0.7773, 0.3366),
  ('shelf', 6, 'rectangularity', 0.6141, 0.09191),
  ('shelf', 6, 'spread_length', -0.9077, 0.2149),
  ('shelf', 6, 'spread_width', -1.81, 0.2293),
  ('shelf', 6, 'tilt_deg', 8.922, 18.54),
  ('shelf', 6, 'width', -1.524, 0.2724),
  ('shelf', 6, 'z_max', 0.745, 0.4829),
  ('shelf', 6, 'z_min', 0.7312, 0.5308);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.06716, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'area_m2', -2.447, 0.7623),
  ('shelf', 7, 'aspect', 0.3342, 0.4338),
  ('shelf', 7, 'behind', 0.0103, 0.03),
  ('shelf', 7, 'edge_free', 0.02005, 0.05183),
  ('shelf', 7, 'edge_free_top', 0.01127, 0.03),
  ('shelf', 7, 'edge_joined', 0.06807, 0.06139),
  ('shelf', 7, 'edge_unseen', -0.001282, 0.03),
  ('shelf', 7, 'height', 0.9151, 0.4823),
  ('shelf', 7, 'length', -0.6162, 0.5391),
  ('shelf', 7, 'rectangularity', 0.7057, 0.1577),
  ('shelf', 7, 'spread_length', -0.5702, 0.5444),
  ('shelf', 7, 'spread_width', -1.335, 0.7632),
  ('shelf', 7, 'tilt_deg', 89.39, 0.8264),
  ('shelf', 7, 'width', -1.215, 0.7715),
  ('shelf', 7, 'z_max', 0.962, 0.5388),
  ('shelf', 7, 'z_min', 0.5541, 0.371);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.1095, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'area_m2', -1.181, 0.2448),
  ('shelf', 8, 'aspect', 1.164, 0.196),
  ('shelf', 8, 'behind', 0.7964, 0.08296),
  ('shelf', 8, 'edge_free', 0.4372, 0.04578),
  ('shelf', 8, 'edge_free_top', 0.5825, 0.31),
  ('shelf', 8, 'edge_joined', 0.1927, 0.1871),
  ('shelf', 8, 'edge_unseen', 0.00622, 0.03),
  ('shelf', 8, 'height', 0.6596, 0.1631),
  ('shelf', 8, 'length', 0.2035, 0.1374),
  ('shelf', 8, 'rectangularity', 0.715, 0.1143),
  ('shelf', 8, 'spread_length', 0.04693, 0.1268),
  ('shelf', 8, 'spread_width', -1.143, 0.1406),
  ('shelf', 8, 'tilt_deg', 90.14, 0.6795),
  ('shelf', 8, 'width', -0.9254, 0.1324),
  ('shelf', 8, 'z_max', 1.21, 0.2419),
  ('shelf', 8, 'z_min', 0.03387, 0.02704);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.03476, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'area_m2', -2.032, 0.2638),
  ('shelf', 9, 'aspect', 0.3653, 0.1177),
  ('shelf', 9, 'behind', 0.6817, 0.1731),
  ('shelf', 9, 'edge_free', 0.2923, 0.1613),
  ('shelf', 9, 'edge_free_top', 0.3869, 0.3476),
  ('shelf', 9, 'edge_joined', 0.4268, 0.3169),
  ('shelf', 9, 'edge_unseen', 0.1798, 0.1227),
  ('shelf', 9, 'height', 0.9624, 0.4839),
  ('shelf', 9, 'length', -0.6188, 0.1944),
  ('shelf', 9, 'rectangularity', 0.6622, 0.08404),
  ('shelf', 9, 'spread_length', -0.836, 0.1422),
  ('shelf', 9, 'spread_width', -1.23, 0.1554),
  ('shelf', 9, 'tilt_deg', 29.8, 46.16),
  ('shelf', 9, 'width', -1.018, 0.1106),
  ('shelf', 9, 'z_max', 0.957, 0.5058),
  ('shelf', 9, 'z_min', 0.8142, 0.6605);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.03494, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'area_m2', -2.288, 0.7865),
  ('shelf', 10, 'aspect', 0.7502, 0.3588),
  ('shelf', 10, 'behind', -0.005142, 0.03),
  ('shelf', 10, 'edge_free', 0.1887, 0.1366),
  ('shelf', 10, 'edge_free_top', 0.4189, 0.1087),
  ('shelf', 10, 'edge_joined', 0.4242, 0.2092),
  ('shelf', 10, 'edge_unseen', 0.03199, 0.08521),
  ('shelf', 10, 'height', 0.08369, 0.02971),
  ('shelf', 10, 'length', -0.6696, 0.474),
  ('shelf', 10, 'rectangularity', 0.7383, 0.08706),
  ('shelf', 10, 'spread_length', -0.6412, 0.5177),
  ('shelf', 10, 'spread_width', -1.47, 0.2397),
  ('shelf', 10, 'tilt_deg', 0.6749, 1.951),
  ('shelf', 10, 'width', -1.311, 0.3375),
  ('shelf', 10, 'z_max', 0.08711, 0.0225),
  ('shelf', 10, 'z_min', 0.08319, 0.0225);

-- cabinet: 1416 examples
UPDATE object_class SET prior = 0.09981 WHERE name = 'cabinet';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.1362, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'area_m2', -0.8317, 0.4727),
  ('cabinet', 1, 'aspect', 0.4335, 0.2262),
  ('cabinet', 1, 'behind', 0.5891, 0.1793),
  ('cabinet', 1, 'edge_free', 0.3035, 0.3431),
  ('cabinet', 1, 'edge_free_top', 0.8342, 0.1721),
  ('cabinet', 1, 'edge_joined', 0.3857, 0.3254),
  ('cabinet', 1, 'edge_unseen', 0.2812, 0.2398),
  ('cabinet', 1, 'height', 1.032, 0.3605),
  ('cabinet', 1, 'length', -0.004455, 0.2784),
  ('cabinet', 1, 'rectangularity', 0.7067, 0.1537),
  ('cabinet', 1, 'spread_length', -0.246, 0.2122),
  ('cabinet', 1, 'spread_width', -0.6369, 0.1607),
  ('cabinet', 1, 'tilt_deg', 90.26, 0.45),
  ('cabinet', 1, 'width', -0.5054, 0.155),
  ('cabinet', 1, 'z_max', 1.676, 0.3625),
  ('cabinet', 1, 'z_min', 0.2763, 0.3823);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.0998, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'area_m2', -0.1653, 0.3003),
  ('cabinet', 2, 'aspect', 1.064, 0.407),
  ('cabinet', 2, 'behind', 0.5066, 0.1876),
  ('cabinet', 2, 'edge_free', 0.1125, 0.0627),
  ('cabinet', 2, 'edge_free_top', 0.7356, 0.1675),
  ('cabinet', 2, 'edge_joined', 0.5364, 0.3078),
  ('cabinet', 2, 'edge_unseen', 0.001933, 0.03),
  ('cabinet', 2, 'height', 1.045, 0.2359),
  ('cabinet', 2, 'length', 0.5938, 0.1971),
  ('cabinet', 2, 'rectangularity', 0.7996, 0.06674),
  ('cabinet', 2, 'spread_length', 0.3861, 0.251),
  ('cabinet', 2, 'spread_width', -0.563, 0.1828),
  ('cabinet', 2, 'tilt_deg', 90.25, 0.5657),
  ('cabinet', 2, 'width', -0.4811, 0.1169),
  ('cabinet', 2, 'z_max', 2.005, 0.1998),
  ('cabinet', 2, 'z_min', 0.07371, 0.1845);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.133, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'area_m2', 0.2564, 0.4777),
  ('cabinet', 3, 'aspect', 0.8968, 0.3649),
  ('cabinet', 3, 'behind', 0.38, 0.1798),
  ('cabinet', 3, 'edge_free', 0.5094, 0.173),
  ('cabinet', 3, 'edge_free_top', 0.9783, 0.04063),
  ('cabinet', 3, 'edge_joined', 0.04278, 0.05721),
  ('cabinet', 3, 'edge_unseen', -0.0005921, 0.03),
  ('cabinet', 3, 'height', 1.029, 0.09109),
  ('cabinet', 3, 'length', 0.6096, 0.08188),
  ('cabinet', 3, 'rectangularity', 0.902, 0.06757),
  ('cabinet', 3, 'spread_length', 0.5214, 0.08664),
  ('cabinet', 3, 'spread_width', -0.3487, 0.1995),
  ('cabinet', 3, 'tilt_deg', 90.1, 0.7608),
  ('cabinet', 3, 'width', -0.2196, 0.2776),
  ('cabinet', 3, 'z_max', 1.803, 0.09549),
  ('cabinet', 3, 'z_min', 0.02118, 0.0679);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.08869, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'area_m2', -0.3486, 0.4156),
  ('cabinet', 4, 'aspect', 0.5642, 0.2706),
  ('cabinet', 4, 'behind', 0.525, 0.1371),
  ('cabinet', 4, 'edge_free', 0.3903, 0.2045),
  ('cabinet', 4, 'edge_free_top', 0.9662, 0.06787),
  ('cabinet', 4, 'edge_joined', 0.06993, 0.1246),
  ('cabinet', 4, 'edge_unseen', 0.02607, 0.1121),
  ('cabinet', 4, 'height', 0.5811, 0.1374),
  ('cabinet', 4, 'length', 0.146, 0.1581),
  ('cabinet', 4, 'rectangularity', 0.8737, 0.1163),
  ('cabinet', 4, 'spread_length', -0.01352, 0.1364),
  ('cabinet', 4, 'spread_width', -0.4206, 0.4135),
  ('cabinet', 4, 'tilt_deg', 90.22, 0.45),
  ('cabinet', 4, 'width', -0.2916, 0.3108),
  ('cabinet', 4, 'z_max', 1.095, 0.1364),
  ('cabinet', 4, 'z_min', -0.002238, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.09979, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'area_m2', -1.185, 0.2567),
  ('cabinet', 5, 'aspect', 0.3517, 0.3644),
  ('cabinet', 5, 'behind', 0.6067, 0.09698),
  ('cabinet', 5, 'edge_free', 0.22, 0.2254),
  ('cabinet', 5, 'edge_free_top', 0.5926, 0.2974),
  ('cabinet', 5, 'edge_joined', 0.2294, 0.3007),
  ('cabinet', 5, 'edge_unseen', 0.0001436, 0.03),
  ('cabinet', 5, 'height', 0.3405, 0.03671),
  ('cabinet', 5, 'length', -0.2653, 0.1641),
  ('cabinet', 5, 'rectangularity', 0.6644, 0.07624),
  ('cabinet', 5, 'spread_length', -0.5214, 0.05147),
  ('cabinet', 5, 'spread_width', -0.8712, 0.2747),
  ('cabinet', 5, 'tilt_deg', 90.09, 0.5097),
  ('cabinet', 5, 'width', -0.5216, 0.106),
  ('cabinet', 5, 'z_max', 0.7339, 0.1065),
  ('cabinet', 5, 'z_min', -0.01678, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.07253, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'area_m2', -2.323, 0.7591),
  ('cabinet', 6, 'aspect', 0.8221, 0.959),
  ('cabinet', 6, 'behind', 0.4079, 0.2342),
  ('cabinet', 6, 'edge_free', 0.07936, 0.1148),
  ('cabinet', 6, 'edge_free_top', 0.1991, 0.3398),
  ('cabinet', 6, 'edge_joined', 0.1388, 0.1592),
  ('cabinet', 6, 'edge_unseen', 0.07877, 0.1459),
  ('cabinet', 6, 'height', 0.4045, 0.2415),
  ('cabinet', 6, 'length', -0.5349, 0.4511),
  ('cabinet', 6, 'rectangularity', 0.6594, 0.1118),
  ('cabinet', 6, 'spread_length', -0.5343, 0.4017),
  ('cabinet', 6, 'spread_width', -1.586, 0.2144),
  ('cabinet', 6, 'tilt_deg', 89.49, 0.9875),
  ('cabinet', 6, 'width', -1.351, 0.3152),
  ('cabinet', 6, 'z_max', 0.7135, 0.4351),
  ('cabinet', 6, 'z_min', 0.09751, 0.1761);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.1629, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'area_m2', -0.3269, 0.7335),
  ('cabinet', 7, 'aspect', 0.8042, 0.3611),
  ('cabinet', 7, 'behind', 0.1939, 0.07854),
  ('cabinet', 7, 'edge_free', 0.5653, 0.2495),
  ('cabinet', 7, 'edge_free_top', 0.98, 0.03639),
  ('cabinet', 7, 'edge_joined', 0.04831, 0.09519),
  ('cabinet', 7, 'edge_unseen', 0.2516, 0.2724),
  ('cabinet', 7, 'height', 1.279, 0.1015),
  ('cabinet', 7, 'length', 0.4322, 0.2444),
  ('cabinet', 7, 'rectangularity', 0.772, 0.09827),
  ('cabinet', 7, 'spread_length', -0.01199, 0.3879),
  ('cabinet', 7, 'spread_width', -0.6151, 0.6003),
  ('cabinet', 7, 'tilt_deg', 90.22, 0.45),
  ('cabinet', 7, 'width', -0.4574, 0.5326),
  ('cabinet', 7, 'z_max', 1.934, 0.1213),
  ('cabinet', 7, 'z_min', 0.3713, 0.2152);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.09766, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'area_m2', -0.7914, 0.3031),
  ('cabinet', 8, 'aspect', 0.673, 0.2723),
  ('cabinet', 8, 'behind', 0.6833, 0.1109),
  ('cabinet', 8, 'edge_free', 0.1433, 0.1387),
  ('cabinet', 8, 'edge_free_top', 0.7364, 0.1031),
  ('cabinet', 8, 'edge_joined', 0.7845, 0.1237),
  ('cabinet', 8, 'edge_unseen', 0.07841, 0.1626),
  ('cabinet', 8, 'height', 0.9248, 0.1585),
  ('cabinet', 8, 'length', 0.07898, 0.3078),
  ('cabinet', 8, 'rectangularity', 0.6962, 0.08738),
  ('cabinet', 8, 'spread_length', -0.2461, 0.2606),
  ('cabinet', 8, 'spread_width', -0.6315, 0.09265),
  ('cabinet', 8, 'tilt_deg', -0.1864, 0.45),
  ('cabinet', 8, 'width', -0.5581, 0.0865),
  ('cabinet', 8, 'z_max', 0.8873, 0.1518),
  ('cabinet', 8, 'z_min', 0.935, 0.1597);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.03107, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'area_m2', -2.305, 0.6194),
  ('cabinet', 9, 'aspect', 0.5576, 0.3252),
  ('cabinet', 9, 'behind', 0.728, 0.1663),
  ('cabinet', 9, 'edge_free', 0.2197, 0.1661),
  ('cabinet', 9, 'edge_free_top', 0.7372, 0.1038),
  ('cabinet', 9, 'edge_joined', 0.2037, 0.1041),
  ('cabinet', 9, 'edge_unseen', 0.008411, 0.04116),
  ('cabinet', 9, 'height', 0.5824, 0.0225),
  ('cabinet', 9, 'length', -0.6484, 0.2247),
  ('cabinet', 9, 'rectangularity', 0.7142, 0.08305),
  ('cabinet', 9, 'spread_length', -0.8962, 0.205),
  ('cabinet', 9, 'spread_width', -1.463, 0.4743),
  ('cabinet', 9, 'tilt_deg', 0.9723, 1.776),
  ('cabinet', 9, 'width', -1.253, 0.533),
  ('cabinet', 9, 'z_max', 0.5817, 0.0225),
  ('cabinet', 9, 'z_min', 0.5807, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.02834, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'area_m2', -2.41, 0.4701),
  ('cabinet', 10, 'aspect', 0.6543, 0.3048),
  ('cabinet', 10, 'behind', 0.2002, 0.209),
  ('cabinet', 10, 'edge_free', 0.6631, 0.3232),
  ('cabinet', 10, 'edge_free_top', 0.9731, 0.05583),
  ('cabinet', 10, 'edge_joined', 0.2355, 0.2449),
  ('cabinet', 10, 'edge_unseen', 0.409, 0.1082),
  ('cabinet', 10, 'height', 0.8646, 0.2566),
  ('cabinet', 10, 'length', -0.6661, 0.3115),
  ('cabinet', 10, 'rectangularity', 0.5951, 0.07501),
  ('cabinet', 10, 'spread_length', -0.8896, 0.319),
  ('cabinet', 10, 'spread_width', -1.59, 0.2426),
  ('cabinet', 10, 'tilt_deg', 58.2, 52.67),
  ('cabinet', 10, 'width', -1.243, 0.2216),
  ('cabinet', 10, 'z_max', 1.02, 0.1919),
  ('cabinet', 10, 'z_min', 0.7094, 0.4124);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.052 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.378 WHERE name = 'aspect';
UPDATE feature SET weight = 0.475 WHERE name = 'edge_free';
UPDATE feature SET weight = 0.336 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.228 WHERE name = 'edge_joined';
UPDATE feature SET weight = 0.266 WHERE name = 'edge_unseen';
UPDATE feature SET weight = 0.197 WHERE name = 'height';
UPDATE feature SET weight = 0 WHERE name = 'length';
UPDATE feature SET weight = 0.5 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.351 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.218 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.5 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.179 WHERE name = 'width';
UPDATE feature SET weight = 0.45 WHERE name = 'z_max';
UPDATE feature SET weight = 0.467 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.192 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0521 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0281 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.142 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0137 WHERE name = 'table';
UPDATE object_class SET prior = 0.031 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.251 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.0032 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0411 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0121 WHERE name = 'door';
UPDATE object_class SET prior = 0.0142 WHERE name = 'window';
UPDATE object_class SET prior = 0.00873 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0897 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.121 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.73 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.549 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 1.55 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.48 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 2.59 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.51 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 0.253 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.355 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.643 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 2.11 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.84 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.88 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.701 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.36 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 3.46 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 3.91 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.68 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.796 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.02 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 1.17 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.922 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 1.56 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.2 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 2.86 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.2 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.37 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.266 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.3 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.77 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.69 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.155 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.04 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2446 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.844' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.272' WHERE key = 'probability_offset';
