-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 17328 planes of 180 paper-like rooms, seeds from 1; 90 at 2 cm, seeds from 10101; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 60 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 7168 examples
UPDATE object_class SET prior = 0.4163 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.724, 1.193)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6817, 0.5557)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4788, 0.2946)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.4325, 0.3104)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.5639, 0.4087)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_joined', 0.3185, 0.3341)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 1.054, 0.7031)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.3468, 0.6884)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.723, 0.1348)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.5049, 0.7182)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.241, 0.6293)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 61.82, 39.64)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.031, 0.6136)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.332, 0.9481)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7719, 0.7637)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0219865, 0.003361),
  ('unknown', 'area_m2', 0.0219865, 0.0490513, 0.09969),
  ('unknown', 'area_m2', 0.0490513, 0.0538897, 0.2468),
  ('unknown', 'area_m2', 0.0538897, 0.0739492, 0.352),
  ('unknown', 'area_m2', 0.0739492, 0.0976898, 0.3951),
  ('unknown', 'area_m2', 0.0976898, 0.109432, 0.4058),
  ('unknown', 'area_m2', 0.109432, 0.131339, 0.3591),
  ('unknown', 'area_m2', 0.131339, 0.184104, 0.3295),
  ('unknown', 'area_m2', 0.184104, 0.244141, 0.3387),
  ('unknown', 'area_m2', 0.244141, 0.253627, 0.4146),
  ('unknown', 'area_m2', 0.253627, 0.336221, 0.3899),
  ('unknown', 'area_m2', 0.336221, 0.544673, 0.2222),
  ('unknown', 'area_m2', 0.544673, 0.564778, 0.1437),
  ('unknown', 'area_m2', 0.564778, 1.21515, 0.09013),
  ('unknown', 'area_m2', 1.21515, 2.71098, 0.01101),
  ('unknown', 'area_m2', 2.71098, 6.04812, 0.008308),
  ('unknown', 'area_m2', 6.04812, 13.4932, 0.009014),
  ('unknown', 'area_m2', 13.4932, 30.1031, 0.01233),
  ('unknown', 'area_m2', 30.1031, 100, 0.007598);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.11283, 1.037),
  ('unknown', 'aspect', 1.11283, 1.24384, 0.9979),
  ('unknown', 'aspect', 1.24384, 1.27188, 1.038),
  ('unknown', 'aspect', 1.27188, 1.39239, 0.9717),
  ('unknown', 'aspect', 1.39239, 1.56983, 0.9306),
  ('unknown', 'aspect', 1.56983, 1.61768, 0.8731),
  ('unknown', 'aspect', 1.61768, 1.80844, 0.7637),
  ('unknown', 'aspect', 1.80844, 2.0575, 0.6319),
  ('unknown', 'aspect', 2.0575, 2.16725, 0.5571),
  ('unknown', 'aspect', 2.16725, 2.61689, 0.4136),
  ('unknown', 'aspect', 2.61689, 2.93841, 0.2838),
  ('unknown', 'aspect', 2.93841, 3.32837, 0.2264),
  ('unknown', 'aspect', 3.32837, 4.23329, 0.2102),
  ('unknown', 'aspect', 4.23329, 4.88119, 0.2296),
  ('unknown', 'aspect', 4.88119, 5.38425, 0.29),
  ('unknown', 'aspect', 5.38425, 6.84812, 0.2268),
  ('unknown', 'aspect', 6.84812, 8.70999, 0.0791),
  ('unknown', 'aspect', 8.70999, 100, 0.003776);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.0965415, 2.092),
  ('unknown', 'behind', 0.0965415, 0.147805, 0.3896),
  ('unknown', 'behind', 0.147805, 0.193083, 0.3551),
  ('unknown', 'behind', 0.193083, 0.289624, 0.4504),
  ('unknown', 'behind', 0.289624, 0.384615, 0.5521),
  ('unknown', 'behind', 0.384615, 0.482707, 0.8139),
  ('unknown', 'behind', 0.482707, 0.511968, 1.055),
  ('unknown', 'behind', 0.511968, 0.579249, 1.004),
  ('unknown', 'behind', 0.579249, 0.610156, 1.405),
  ('unknown', 'behind', 0.610156, 0.67579, 1.39),
  ('unknown', 'behind', 0.67579, 0.688172, 1.644),
  ('unknown', 'behind', 0.688172, 0.75, 1.786),
  ('unknown', 'behind', 0.75, 0.772332, 2.148),
  ('unknown', 'behind', 0.772332, 0.80104, 2.189),
  ('unknown', 'behind', 0.80104, 0.868873, 1.554),
  ('unknown', 'behind', 0.868873, 1, 0.04723);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free', 0, 0.111111, 1.975),
  ('unknown', 'edge_free', 0.111111, 0.115341, 0.5893),
  ('unknown', 'edge_free', 0.115341, 0.222222, 0.6971),
  ('unknown', 'edge_free', 0.222222, 0.269679, 0.7856),
  ('unknown', 'edge_free', 0.269679, 0.333333, 0.8421),
  ('unknown', 'edge_free', 0.333333, 0.38727, 1.063),
  ('unknown', 'edge_free', 0.38727, 0.444444, 1.233),
  ('unknown', 'edge_free', 0.444444, 0.474652, 1.345),
  ('unknown', 'edge_free', 0.474652, 0.555556, 1.284),
  ('unknown', 'edge_free', 0.555556, 0.563822, 0.8656),
  ('unknown', 'edge_free', 0.563822, 0.666667, 0.899),
  ('unknown', 'edge_free', 0.666667, 0.688132, 0.8589),
  ('unknown', 'edge_free', 0.688132, 0.777778, 0.7085),
  ('unknown', 'edge_free', 0.777778, 0.883139, 0.46),
  ('unknown', 'edge_free', 0.883139, 0.888889, 0.3713),
  ('unknown', 'edge_free', 0.888889, 1, 0.9736);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free_top', 0, 0.111111, 2.446),
  ('unknown', 'edge_free_top', 0.111111, 0.222222, 0.3833),
  ('unknown', 'edge_free_top', 0.222222, 0.281742, 0.3152),
  ('unknown', 'edge_free_top', 0.281742, 0.333333, 0.3413),
  ('unknown', 'edge_free_top', 0.333333, 0.444444, 0.3718),
  ('unknown', 'edge_free_top', 0.444444, 0.555556, 0.4227),
  ('unknown', 'edge_free_top', 0.555556, 0.570694, 0.4306),
  ('unknown', 'edge_free_top', 0.570694, 0.666667, 0.4411),
  ('unknown', 'edge_free_top', 0.666667, 0.777778, 0.5882),
  ('unknown', 'edge_free_top', 0.777778, 0.781983, 0.7094),
  ('unknown', 'edge_free_top', 0.781983, 0.888889, 0.7716),
  ('unknown', 'edge_free_top', 0.888889, 0.917607, 1.004),
  ('unknown', 'edge_free_top', 0.917607, 1, 4.035);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_joined', 0, 0.0130681, 17),
  ('unknown', 'edge_joined', 0.0130681, 0.0540488, 2.694),
  ('unknown', 'edge_joined', 0.0540488, 0.111111, 1.524),
  ('unknown', 'edge_joined', 0.111111, 0.134913, 1.049),
  ('unknown', 'edge_joined', 0.134913, 0.222222, 0.9584),
  ('unknown', 'edge_joined', 0.222222, 0.252287, 0.8849),
  ('unknown', 'edge_joined', 0.252287, 0.333333, 0.7754),
  ('unknown', 'edge_joined', 0.333333, 0.412811, 0.6107),
  ('unknown', 'edge_joined', 0.412811, 0.444444, 0.5881),
  ('unknown', 'edge_joined', 0.444444, 0.555556, 0.5339),
  ('unknown', 'edge_joined', 0.555556, 0.622224, 0.5087),
  ('unknown', 'edge_joined', 0.622224, 0.666667, 0.4416),
  ('unknown', 'edge_joined', 0.666667, 0.777778, 0.4251),
  ('unknown', 'edge_joined', 0.777778, 0.87379, 0.4585),
  ('unknown', 'edge_joined', 0.87379, 0.888889, 0.4536),
  ('unknown', 'edge_joined', 0.888889, 1, 0.9377);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0721527, 0.008541),
  ('unknown', 'height', 0.0721527, 0.235395, 0.6447),
  ('unknown', 'height', 0.235395, 0.394868, 0.4665),
  ('unknown', 'height', 0.394868, 0.435391, 0.8386),
  ('unknown', 'height', 0.435391, 0.668737, 0.4954),
  ('unknown', 'height', 0.668737, 0.717583, 0.4588),
  ('unknown', 'height', 0.717583, 0.834793, 0.7507),
  ('unknown', 'height', 0.834793, 0.966941, 0.8405),
  ('unknown', 'height', 0.966941, 1.0403, 0.4808),
  ('unknown', 'height', 1.0403, 1.27191, 0.3267),
  ('unknown', 'height', 1.27191, 1.36301, 0.3403),
  ('unknown', 'height', 1.36301, 1.56883, 0.3932),
  ('unknown', 'height', 1.56883, 1.68573, 0.3805),
  ('unknown', 'height', 1.68573, 2.00844, 0.1585),
  ('unknown', 'height', 2.00844, 2.10106, 0.1517),
  ('unknown', 'height', 2.10106, 2.33116, 0.2002),
  ('unknown', 'height', 2.33116, 2.65388, 0.1152),
  ('unknown', 'height', 2.65388, 2.97659, 0.05948),
  ('unknown', 'height', 2.97659, 4, 0.009234);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.189649, 0.004236),
  ('unknown', 'length', 0.189649, 0.288144, 0.1468),
  ('unknown', 'length', 0.288144, 0.324344, 0.3601),
  ('unknown', 'length', 0.324344, 0.407224, 0.4822),
  ('unknown', 'length', 0.407224, 0.437792, 0.5748),
  ('unknown', 'length', 0.437792, 0.49214, 0.5973),
  ('unknown', 'length', 0.49214, 0.598527, 0.569),
  ('unknown', 'length', 0.598527, 0.66516, 0.557),
  ('unknown', 'length', 0.66516, 0.742713, 0.4744),
  ('unknown', 'length', 0.742713, 0.918961, 0.5232),
  ('unknown', 'length', 0.918961, 1.01061, 0.4933),
  ('unknown', 'length', 1.01061, 1.18272, 0.4039),
  ('unknown', 'length', 1.18272, 1.48755, 0.4857),
  ('unknown', 'length', 1.48755, 1.53548, 0.408),
  ('unknown', 'length', 1.53548, 2.33293, 0.1365),
  ('unknown', 'length', 2.33293, 3.54454, 0.02642),
  ('unknown', 'length', 3.54454, 5.3854, 0.02432),
  ('unknown', 'length', 5.3854, 8.18231, 0.02532),
  ('unknown', 'length', 8.18231, 30, 0.007233);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.33922, 0.02833),
  ('unknown', 'rectangularity', 0.33922, 0.408554, 0.2044),
  ('unknown', 'rectangularity', 0.408554, 0.477888, 0.3958),
  ('unknown', 'rectangularity', 0.477888, 0.545924, 0.8796),
  ('unknown', 'rectangularity', 0.545924, 0.547222, 1.321),
  ('unknown', 'rectangularity', 0.547222, 0.616556, 1.454),
  ('unknown', 'rectangularity', 0.616556, 0.621775, 1.669),
  ('unknown', 'rectangularity', 0.621775, 0.676621, 2.026),
  ('unknown', 'rectangularity', 0.676621, 0.68589, 2.529),
  ('unknown', 'rectangularity', 0.68589, 0.720565, 2.547),
  ('unknown', 'rectangularity', 0.720565, 0.755224, 2.68),
  ('unknown', 'rectangularity', 0.755224, 0.762177, 2.602),
  ('unknown', 'rectangularity', 0.762177, 0.796751, 3.21),
  ('unknown', 'rectangularity', 0.796751, 0.824558, 2.918),
  ('unknown', 'rectangularity', 0.824558, 0.834513, 3),
  ('unknown', 'rectangularity', 0.834513, 0.879495, 2.482),
  ('unknown', 'rectangularity', 0.879495, 0.893892, 1.798),
  ('unknown', 'rectangularity', 0.893892, 0.963226, 1.125),
  ('unknown', 'rectangularity', 0.963226, 1, 0.1729);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.166067, 0.002427),
  ('unknown', 'spread_length', 0.166067, 0.254743, 0.1624),
  ('unknown', 'spread_length', 0.254743, 0.275384, 0.4434),
  ('unknown', 'spread_length', 0.275384, 0.32875, 0.6249),
  ('unknown', 'spread_length', 0.32875, 0.39077, 0.6088),
  ('unknown', 'spread_length', 0.39077, 0.396724, 0.4749),
  ('unknown', 'spread_length', 0.396724, 0.485625, 0.5454),
  ('unknown', 'spread_length', 0.485625, 0.599434, 0.4062),
  ('unknown', 'spread_length', 0.599434, 0.636875, 0.4239),
  ('unknown', 'spread_length', 0.636875, 0.799544, 0.4856),
  ('unknown', 'spread_length', 0.799544, 0.91952, 0.4599),
  ('unknown', 'spread_length', 0.91952, 1.04315, 0.3764),
  ('unknown', 'spread_length', 1.04315, 1.33335, 0.4547),
  ('unknown', 'spread_length', 1.33335, 1.41052, 0.3872),
  ('unknown', 'spread_length', 1.41052, 2.16372, 0.1153),
  ('unknown', 'spread_length', 2.16372, 3.3191, 0.02176),
  ('unknown', 'spread_length', 3.3191, 5.09142, 0.02263),
  ('unknown', 'spread_length', 5.09142, 7.81014, 0.02662),
  ('unknown', 'spread_length', 7.81014, 40, 0.005644);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.110411, 0.0007874),
  ('unknown', 'spread_width', 0.110411, 0.158613, 0.3004),
  ('unknown', 'spread_width', 0.158613, 0.167553, 0.5807),
  ('unknown', 'spread_width', 0.167553, 0.18924, 0.6433),
  ('unknown', 'spread_width', 0.18924, 0.21171, 0.9988),
  ('unknown', 'spread_width', 0.21171, 0.231799, 1.204),
  ('unknown', 'spread_width', 0.231799, 0.254269, 0.7829),
  ('unknown', 'spread_width', 0.254269, 0.268964, 0.7013),
  ('unknown', 'spread_width', 0.268964, 0.318286, 0.658),
  ('unknown', 'spread_width', 0.318286, 0.385864, 0.4726),
  ('unknown', 'spread_width', 0.385864, 0.406999, 0.396),
  ('unknown', 'spread_width', 0.406999, 0.584285, 0.3073),
  ('unknown', 'spread_width', 0.584285, 0.888619, 0.1679),
  ('unknown', 'spread_width', 0.888619, 1.34852, 0.02522),
  ('unknown', 'spread_width', 1.34852, 2.04643, 0.01574),
  ('unknown', 'spread_width', 2.04643, 3.10554, 0.01463),
  ('unknown', 'spread_width', 3.10554, 4.71279, 0.01993),
  ('unknown', 'spread_width', 4.71279, 20, 0.0064);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 0.869048, 0.1254),
  ('unknown', 'tilt_deg', 0.869048, 2.6242, 0.06347),
  ('unknown', 'tilt_deg', 2.6242, 10, 0.009711),
  ('unknown', 'tilt_deg', 10, 20, 0.001105),
  ('unknown', 'tilt_deg', 20, 30, 0.0002193),
  ('unknown', 'tilt_deg', 30, 40, 0.0001598),
  ('unknown', 'tilt_deg', 40, 50, 0.0001674),
  ('unknown', 'tilt_deg', 50, 60, 0.0001493),
  ('unknown', 'tilt_deg', 60, 70, 0.0005076),
  ('unknown', 'tilt_deg', 70, 75.789, 0.00329),
  ('unknown', 'tilt_deg', 75.789, 80, 0.004644),
  ('unknown', 'tilt_deg', 80, 88.0709, 0.01148),
  ('unknown', 'tilt_deg', 88.0709, 89.3188, 0.09578),
  ('unknown', 'tilt_deg', 89.3188, 89.7306, 0.4126),
  ('unknown', 'tilt_deg', 89.7306, 90, 0.9806);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.132709, 0.002807),
  ('unknown', 'width', 0.132709, 0.194088, 0.2725),
  ('unknown', 'width', 0.194088, 0.19846, 0.4874),
  ('unknown', 'width', 0.19846, 0.228595, 0.718),
  ('unknown', 'width', 0.228595, 0.258082, 0.8997),
  ('unknown', 'width', 0.258082, 0.296786, 0.7378),
  ('unknown', 'width', 0.296786, 0.300276, 0.7727),
  ('unknown', 'width', 0.300276, 0.343031, 0.8317),
  ('unknown', 'width', 0.343031, 0.402551, 0.6923),
  ('unknown', 'width', 0.402551, 0.443828, 0.5384),
  ('unknown', 'width', 0.443828, 0.503135, 0.4664),
  ('unknown', 'width', 0.503135, 0.663722, 0.3231),
  ('unknown', 'width', 0.663722, 0.709725, 0.3304),
  ('unknown', 'width', 0.709725, 0.992561, 0.2017),
  ('unknown', 'width', 0.992561, 1.48432, 0.03082),
  ('unknown', 'width', 1.48432, 2.21973, 0.01661),
  ('unknown', 'width', 2.21973, 3.31948, 0.01848),
  ('unknown', 'width', 3.31948, 4.96411, 0.01962),
  ('unknown', 'width', 4.96411, 12, 0.01049);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0871065, 0.01003),
  ('unknown', 'z_max', 0.0871065, 0.431685, 0.3067),
  ('unknown', 'z_max', 0.431685, 0.521872, 0.4686),
  ('unknown', 'z_max', 0.521872, 0.703749, 0.3824),
  ('unknown', 'z_max', 0.703749, 0.798399, 1.145),
  ('unknown', 'z_max', 0.798399, 0.943994, 0.7768),
  ('unknown', 'z_max', 0.943994, 0.956638, 0.6685),
  ('unknown', 'z_max', 0.956638, 1.12595, 0.6069),
  ('unknown', 'z_max', 1.12595, 1.3914, 0.3032),
  ('unknown', 'z_max', 1.3914, 1.56932, 0.1701),
  ('unknown', 'z_max', 1.56932, 1.82617, 0.2179),
  ('unknown', 'z_max', 1.82617, 2.02434, 0.2786),
  ('unknown', 'z_max', 2.02434, 2.26094, 0.4204),
  ('unknown', 'z_max', 2.26094, 2.30124, 0.2862),
  ('unknown', 'z_max', 2.30124, 2.6957, 0.1574),
  ('unknown', 'z_max', 2.6957, 3.13047, 0.04817),
  ('unknown', 'z_max', 3.13047, 3.56523, 0.01089),
  ('unknown', 'z_max', 3.56523, 4, 0.05354);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.12989, 0.05941),
  ('unknown', 'z_min', -0.12989, -0.0160387, 0.858),
  ('unknown', 'z_min', -0.0160387, 0.0483668, 1.62),
  ('unknown', 'z_min', 0.0483668, 0.240219, 0.4416),
  ('unknown', 'z_min', 0.240219, 0.342325, 0.2427),
  ('unknown', 'z_min', 0.342325, 0.610329, 0.2956),
  ('unknown', 'z_min', 0.610329, 0.67612, 0.5034),
  ('unknown', 'z_min', 0.67612, 0.768473, 1.17),
  ('unknown', 'z_min', 0.768473, 0.914321, 0.7593),
  ('unknown', 'z_min', 0.914321, 0.980439, 0.4829),
  ('unknown', 'z_min', 0.980439, 1.22767, 0.3263),
  ('unknown', 'z_min', 1.22767, 1.35055, 0.3563),
  ('unknown', 'z_min', 1.35055, 1.72066, 0.1433),
  ('unknown', 'z_min', 1.72066, 1.94095, 0.06882),
  ('unknown', 'z_min', 1.94095, 2.09077, 0.09603),
  ('unknown', 'z_min', 2.09077, 2.46088, 0.1545),
  ('unknown', 'z_min', 2.46088, 2.83099, 0.08082),
  ('unknown', 'z_min', 2.83099, 4, 0.007883);
DELETE FROM class_kind WHERE class = 'unknown';
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.04751, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'area_m2', -2.212, 0.2268),
  ('unknown', 1, 'aspect', 0.3563, 0.2144),
  ('unknown', 1, 'behind', 0.5901, 0.2667),
  ('unknown', 1, 'edge_free', 0.4193, 0.1702),
  ('unknown', 1, 'edge_free_top', 0.645, 0.2617),
  ('unknown', 1, 'edge_joined', 0.282, 0.2184),
  ('unknown', 1, 'height', 1.168, 0.3864),
  ('unknown', 1, 'length', -0.7285, 0.1773),
  ('unknown', 1, 'rectangularity', 0.6776, 0.09216),
  ('unknown', 1, 'spread_length', -0.9884, 0.1605),
  ('unknown', 1, 'spread_width', -1.342, 0.1607),
  ('unknown', 1, 'tilt_deg', 88.65, 2.204),
  ('unknown', 1, 'width', -1.085, 0.1438),
  ('unknown', 1, 'z_max', 1.38, 0.3996),
  ('unknown', 1, 'z_min', 0.947, 0.3835);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.04611, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'area_m2', -1.389, 0.5915),
  ('unknown', 2, 'aspect', 0.3602, 0.2605),
  ('unknown', 2, 'behind', 0.00532, 0.03),
  ('unknown', 2, 'edge_free', 0.03159, 0.04809),
  ('unknown', 2, 'edge_free_top', 0.02881, 0.05254),
  ('unknown', 2, 'edge_joined', 0.8923, 0.1327),
  ('unknown', 2, 'height', 1.615, 0.1233),
  ('unknown', 2, 'length', -0.4034, 0.2963),
  ('unknown', 2, 'rectangularity', 0.8038, 0.06996),
  ('unknown', 2, 'spread_length', -0.5572, 0.3074),
  ('unknown', 2, 'spread_width', -1.005, 0.3463),
  ('unknown', 2, 'tilt_deg', 89.68, 1.387),
  ('unknown', 2, 'width', -0.7636, 0.3332),
  ('unknown', 2, 'z_max', 1.941, 0.1764),
  ('unknown', 2, 'z_min', 1.33, 0.1213);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.04563, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'area_m2', -1.862, 0.34),
  ('unknown', 3, 'aspect', 0.3733, 0.2414),
  ('unknown', 3, 'behind', 0.6521, 0.1793),
  ('unknown', 3, 'edge_free', 0.3621, 0.1884),
  ('unknown', 3, 'edge_free_top', 0.5446, 0.3288),
  ('unknown', 3, 'edge_joined', 0.2257, 0.2445),
  ('unknown', 3, 'height', 0.2406, 0.066),
  ('unknown', 3, 'length', -0.4545, 0.1769),
  ('unknown', 3, 'rectangularity', 0.5851, 0.1617),
  ('unknown', 3, 'spread_length', -0.6453, 0.183),
  ('unknown', 3, 'spread_width', -1.149, 0.2628),
  ('unknown', 3, 'tilt_deg', 89.22, 1.725),
  ('unknown', 3, 'width', -0.8278, 0.2077),
  ('unknown', 3, 'z_max', 0.5152, 0.1202),
  ('unknown', 3, 'z_min', -0.0114, 0.03626);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.04393, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'area_m2', -2.606, 0.3111),
  ('unknown', 4, 'aspect', 0.5274, 0.3166),
  ('unknown', 4, 'behind', 0.6113, 0.1905),
  ('unknown', 4, 'edge_free', 0.5752, 0.09553),
  ('unknown', 4, 'edge_free_top', 0.9675, 0.05708),
  ('unknown', 4, 'edge_joined', 0.0742, 0.1201),
  ('unknown', 4, 'height', 0.8634, 0.05652),
  ('unknown', 4, 'length', -0.8562, 0.2676),
  ('unknown', 4, 'rectangularity', 0.7009, 0.1022),
  ('unknown', 4, 'spread_length', -1.201, 0.1785),
  ('unknown', 4, 'spread_width', -1.556, 0.2071),
  ('unknown', 4, 'tilt_deg', 83.87, 7.109),
  ('unknown', 4, 'width', -1.384, 0.216),
  ('unknown', 4, 'z_max', 0.987, 0.07391),
  ('unknown', 4, 'z_min', 0.7159, 0.05799);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.04177, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'area_m2', -2.427, 0.2319),
  ('unknown', 5, 'aspect', 0.2347, 0.1611),
  ('unknown', 5, 'behind', 0.6856, 0.137),
  ('unknown', 5, 'edge_free', 0.5054, 0.1199),
  ('unknown', 5, 'edge_free_top', 0.8321, 0.1676),
  ('unknown', 5, 'edge_joined', 0.1398, 0.1514),
  ('unknown', 5, 'height', 0.1843, 0.03748),
  ('unknown', 5, 'length', -0.838, 0.1531),
  ('unknown', 5, 'rectangularity', 0.6071, 0.1094),
  ('unknown', 5, 'spread_length', -1.037, 0.1359),
  ('unknown', 5, 'spread_width', -1.522, 0.1944),
  ('unknown', 5, 'tilt_deg', 88.83, 2.158),
  ('unknown', 5, 'width', -1.073, 0.1432),
  ('unknown', 5, 'z_max', 0.3636, 0.0587),
  ('unknown', 5, 'z_min', -0.01403, 0.03212);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.03581, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'area_m2', -2.843, 0.3228),
  ('unknown', 6, 'aspect', 0.5565, 0.3038),
  ('unknown', 6, 'behind', 0.5414, 0.2485),
  ('unknown', 6, 'edge_free', 0.3743, 0.2341),
  ('unknown', 6, 'edge_free_top', 0.4965, 0.402),
  ('unknown', 6, 'edge_joined', 0.2186, 0.2491),
  ('unknown', 6, 'height', 0.2076, 0.07821),
  ('unknown', 6, 'length', -0.9511, 0.2914),
  ('unknown', 6, 'rectangularity', 0.6956, 0.1327),
  ('unknown', 6, 'spread_length', -1.12, 0.281),
  ('unknown', 6, 'spread_width', -1.739, 0.1995),
  ('unknown', 6, 'tilt_deg', 87.83, 3.436),
  ('unknown', 6, 'width', -1.508, 0.194),
  ('unknown', 6, 'z_max', 0.3628, 0.1095),
  ('unknown', 6, 'z_min', 0.03432, 0.0744);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.03387, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'area_m2', -1.321, 0.1506),
  ('unknown', 7, 'aspect', 1.722, 0.1526),
  ('unknown', 7, 'behind', 0.2656, 0.2721),
  ('unknown', 7, 'edge_free', 0.9655, 0.04871),
  ('unknown', 7, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 7, 'edge_joined', 0.03307, 0.04841),
  ('unknown', 7, 'height', 2.527, 0.263),
  ('unknown', 7, 'length', 0.275, 0.1181),
  ('unknown', 7, 'rectangularity', 0.8634, 0.0443),
  ('unknown', 7, 'spread_length', 0.2182, 0.1271),
  ('unknown', 7, 'spread_width', -1.554, 0.05694),
  ('unknown', 7, 'tilt_deg', 1.339, 1.902),
  ('unknown', 7, 'width', -1.447, 0.1054),
  ('unknown', 7, 'z_max', 2.53, 0.2649),
  ('unknown', 7, 'z_min', 2.522, 0.2635);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.03334, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'area_m2', -1.275, 0.2859),
  ('unknown', 8, 'aspect', 1.719, 0.2474),
  ('unknown', 8, 'behind', 0.5652, 0.2486),
  ('unknown', 8, 'edge_free', 0.2788, 0.2004),
  ('unknown', 8, 'edge_free_top', 0.01366, 0.04038),
  ('unknown', 8, 'edge_joined', 0.3537, 0.3237),
  ('unknown', 8, 'height', 1.503, 0.0947),
  ('unknown', 8, 'length', 0.3462, 0.1321),
  ('unknown', 8, 'rectangularity', 0.7823, 0.06109),
  ('unknown', 8, 'spread_length', 0.1767, 0.1561),
  ('unknown', 8, 'spread_width', -1.52, 0.2616),
  ('unknown', 8, 'tilt_deg', 89.82, 1.574),
  ('unknown', 8, 'width', -1.373, 0.2305),
  ('unknown', 8, 'z_max', 2.246, 0.1651),
  ('unknown', 8, 'z_min', 0.8203, 0.1101);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.03242, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'area_m2', -0.4434, 0.315),
  ('unknown', 9, 'aspect', 0.4428, 0.2328),
  ('unknown', 9, 'behind', 0.4885, 0.1133),
  ('unknown', 9, 'edge_free', 0.8605, 0.1361),
  ('unknown', 9, 'edge_free_top', 0.9917, 0.03),
  ('unknown', 9, 'edge_joined', 0.02428, 0.03574),
  ('unknown', 9, 'height', 0.4793, 0.05505),
  ('unknown', 9, 'length', 0.08953, 0.2277),
  ('unknown', 9, 'rectangularity', 0.8456, 0.1171),
  ('unknown', 9, 'spread_length', 0.008217, 0.2371),
  ('unknown', 9, 'spread_width', -0.4803, 0.1415),
  ('unknown', 9, 'tilt_deg', 89.73, 1.63),
  ('unknown', 9, 'width', -0.3533, 0.1309),
  ('unknown', 9, 'z_max', 0.7874, 0.07381),
  ('unknown', 9, 'z_min', 0.07021, 0.06876);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.02943, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'area_m2', 2.837, 0.962),
  ('unknown', 10, 'aspect', 0.6541, 0.6347),
  ('unknown', 10, 'behind', 0.002788, 0.03),
  ('unknown', 10, 'edge_free', 0.005874, 0.03),
  ('unknown', 10, 'edge_free_top', 0.007311, 0.03),
  ('unknown', 10, 'edge_joined', 0.08353, 0.146),
  ('unknown', 10, 'height', 1.997, 1.034),
  ('unknown', 10, 'length', 1.84, 0.4203),
  ('unknown', 10, 'rectangularity', 0.841, 0.1308),
  ('unknown', 10, 'spread_length', 1.795, 0.3995),
  ('unknown', 10, 'spread_width', 1.125, 0.672),
  ('unknown', 10, 'tilt_deg', 89.84, 1.674),
  ('unknown', 10, 'width', 1.186, 0.6883),
  ('unknown', 10, 'z_max', 5.11, 2.516),
  ('unknown', 10, 'z_min', -0.8123, 1.217);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.02885, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'area_m2', -0.853, 0.2882),
  ('unknown', 11, 'aspect', 0.2356, 0.1532),
  ('unknown', 11, 'behind', 0.6207, 0.2031),
  ('unknown', 11, 'edge_free', 0.3935, 0.2131),
  ('unknown', 11, 'edge_free_top', 0.5701, 0.3495),
  ('unknown', 11, 'edge_joined', 0.3191, 0.2731),
  ('unknown', 11, 'height', 0.4017, 0.08829),
  ('unknown', 11, 'length', -0.08189, 0.1566),
  ('unknown', 11, 'rectangularity', 0.6488, 0.1244),
  ('unknown', 11, 'spread_length', -0.2519, 0.1397),
  ('unknown', 11, 'spread_width', -0.6041, 0.1987),
  ('unknown', 11, 'tilt_deg', 89.41, 1.923),
  ('unknown', 11, 'width', -0.3175, 0.1255),
  ('unknown', 11, 'z_max', 0.7675, 0.08872),
  ('unknown', 11, 'z_min', -0.003041, 0.0557);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.02836, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'area_m2', -2.764, 0.1825),
  ('unknown', 12, 'aspect', 0.2678, 0.1466),
  ('unknown', 12, 'behind', 0.3566, 0.2061),
  ('unknown', 12, 'edge_free', 0.1643, 0.2339),
  ('unknown', 12, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 12, 'edge_joined', 0.7535, 0.2354),
  ('unknown', 12, 'height', 0.7549, 0.05955),
  ('unknown', 12, 'length', -1.143, 0.1235),
  ('unknown', 12, 'rectangularity', 0.8132, 0.06168),
  ('unknown', 12, 'spread_length', -1.251, 0.1169),
  ('unknown', 12, 'spread_width', -1.561, 0.08965),
  ('unknown', 12, 'tilt_deg', 1.284, 1.994),
  ('unknown', 12, 'width', -1.411, 0.124),
  ('unknown', 12, 'z_max', 0.759, 0.06876),
  ('unknown', 12, 'z_min', 0.751, 0.06179);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.0273, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'area_m2', -1.505, 0.499),
  ('unknown', 13, 'aspect', 1.576, 0.3853),
  ('unknown', 13, 'behind', 0.6602, 0.105),
  ('unknown', 13, 'edge_free', 0.1914, 0.1832),
  ('unknown', 13, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 13, 'edge_joined', 0.6912, 0.2453),
  ('unknown', 13, 'height', 2.141, 0.1404),
  ('unknown', 13, 'length', 0.1769, 0.3564),
  ('unknown', 13, 'rectangularity', 0.7575, 0.07393),
  ('unknown', 13, 'spread_length', 0.02743, 0.3773),
  ('unknown', 13, 'spread_width', -1.491, 0.2692),
  ('unknown', 13, 'tilt_deg', 1.698, 2.309),
  ('unknown', 13, 'width', -1.399, 0.2563),
  ('unknown', 13, 'z_max', 2.146, 0.1447),
  ('unknown', 13, 'z_min', 2.136, 0.1414);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.02696, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'area_m2', -1.299, 0.4129),
  ('unknown', 14, 'aspect', 0.7269, 0.3208),
  ('unknown', 14, 'behind', 0.7569, 0.0897),
  ('unknown', 14, 'edge_free', 0.1768, 0.111),
  ('unknown', 14, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 14, 'edge_joined', 0.7713, 0.1428),
  ('unknown', 14, 'height', 1.236, 0.2007),
  ('unknown', 14, 'length', -0.1139, 0.2953),
  ('unknown', 14, 'rectangularity', 0.7183, 0.1116),
  ('unknown', 14, 'spread_length', -0.2424, 0.2836),
  ('unknown', 14, 'spread_width', -0.8804, 0.234),
  ('unknown', 14, 'tilt_deg', 3.397, 2.544),
  ('unknown', 14, 'width', -0.8408, 0.1838),
  ('unknown', 14, 'z_max', 1.251, 0.2024),
  ('unknown', 14, 'z_min', 1.222, 0.2014);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.02582, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'area_m2', -2.48, 0.2997),
  ('unknown', 15, 'aspect', 0.3266, 0.2371),
  ('unknown', 15, 'behind', 0.4105, 0.2765),
  ('unknown', 15, 'edge_free', 0.5566, 0.2997),
  ('unknown', 15, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 15, 'edge_joined', 0.3713, 0.2735),
  ('unknown', 15, 'height', 0.927, 0.1168),
  ('unknown', 15, 'length', -0.9361, 0.1874),
  ('unknown', 15, 'rectangularity', 0.7625, 0.1053),
  ('unknown', 15, 'spread_length', -1.087, 0.1635),
  ('unknown', 15, 'spread_width', -1.454, 0.2036),
  ('unknown', 15, 'tilt_deg', 2.927, 3.402),
  ('unknown', 15, 'width', -1.263, 0.2146),
  ('unknown', 15, 'z_max', 0.9375, 0.1235),
  ('unknown', 15, 'z_min', 0.9181, 0.1184);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.02514, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'area_m2', -1.687, 0.4257),
  ('unknown', 16, 'aspect', 0.9264, 0.3065),
  ('unknown', 16, 'behind', 0.5246, 0.2334),
  ('unknown', 16, 'edge_free', 0.3564, 0.2189),
  ('unknown', 16, 'edge_free_top', 0.3992, 0.3578),
  ('unknown', 16, 'edge_joined', 0.1968, 0.245),
  ('unknown', 16, 'height', 0.4827, 0.1419),
  ('unknown', 16, 'length', -0.1019, 0.229),
  ('unknown', 16, 'rectangularity', 0.6033, 0.1749),
  ('unknown', 16, 'spread_length', -0.2172, 0.2556),
  ('unknown', 16, 'spread_width', -1.369, 0.3148),
  ('unknown', 16, 'tilt_deg', 88.78, 2.4),
  ('unknown', 16, 'width', -1.028, 0.2959),
  ('unknown', 16, 'z_max', 0.7835, 0.2277),
  ('unknown', 16, 'z_min', 0.1338, 0.163);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.02513, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'area_m2', -3.145, 0.4),
  ('unknown', 17, 'aspect', 0.3545, 0.2454),
  ('unknown', 17, 'behind', 0.3285, 0.3078),
  ('unknown', 17, 'edge_free', 0.2501, 0.2078),
  ('unknown', 17, 'edge_free_top', 0.3071, 0.313),
  ('unknown', 17, 'edge_joined', 0.5487, 0.2951),
  ('unknown', 17, 'height', 1.172, 0.3898),
  ('unknown', 17, 'length', -1.255, 0.2349),
  ('unknown', 17, 'rectangularity', 0.759, 0.07309),
  ('unknown', 17, 'spread_length', -1.367, 0.2269),
  ('unknown', 17, 'spread_width', -1.806, 0.215),
  ('unknown', 17, 'tilt_deg', 85.66, 6.375),
  ('unknown', 17, 'width', -1.609, 0.2436),
  ('unknown', 17, 'z_max', 1.304, 0.4029),
  ('unknown', 17, 'z_min', 1.038, 0.3908);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.02428, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'area_m2', -2.901, 0.3089),
  ('unknown', 18, 'aspect', 0.3928, 0.2687),
  ('unknown', 18, 'behind', 0.4284, 0.2931),
  ('unknown', 18, 'edge_free', 0.6468, 0.172),
  ('unknown', 18, 'edge_free_top', 0.9686, 0.06021),
  ('unknown', 18, 'edge_joined', 0.02916, 0.04434),
  ('unknown', 18, 'height', 1.499, 0.3743),
  ('unknown', 18, 'length', -1.092, 0.2337),
  ('unknown', 18, 'rectangularity', 0.7353, 0.1307),
  ('unknown', 18, 'spread_length', -1.308, 0.1829),
  ('unknown', 18, 'spread_width', -1.686, 0.1861),
  ('unknown', 18, 'tilt_deg', 88.83, 2.327),
  ('unknown', 18, 'width', -1.484, 0.2288),
  ('unknown', 18, 'z_max', 1.629, 0.3788),
  ('unknown', 18, 'z_min', 1.341, 0.3757);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.0237, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'area_m2', -1.507, 0.3945),
  ('unknown', 19, 'aspect', 0.5385, 0.3181),
  ('unknown', 19, 'behind', 0.4606, 0.3024),
  ('unknown', 19, 'edge_free', 0.2326, 0.1769),
  ('unknown', 19, 'edge_free_top', 0.3585, 0.3007),
  ('unknown', 19, 'edge_joined', 0.5551, 0.3055),
  ('unknown', 19, 'height', 1.347, 0.2366),
  ('unknown', 19, 'length', -0.2991, 0.2018),
  ('unknown', 19, 'rectangularity', 0.7021, 0.1221),
  ('unknown', 19, 'spread_length', -0.4877, 0.2285),
  ('unknown', 19, 'spread_width', -1.068, 0.2783),
  ('unknown', 19, 'tilt_deg', 88.52, 2.592),
  ('unknown', 19, 'width', -0.8377, 0.2694),
  ('unknown', 19, 'z_max', 1.694, 0.2665),
  ('unknown', 19, 'z_min', 1.005, 0.2745);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.02281, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'area_m2', -1.651, 0.3205),
  ('unknown', 20, 'aspect', 0.5604, 0.3092),
  ('unknown', 20, 'behind', 0.6589, 0.186),
  ('unknown', 20, 'edge_free', 0.3806, 0.2026),
  ('unknown', 20, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 20, 'edge_joined', 0.4121, 0.1874),
  ('unknown', 20, 'height', 0.6912, 0.1947),
  ('unknown', 20, 'length', -0.3384, 0.2764),
  ('unknown', 20, 'rectangularity', 0.6726, 0.1212),
  ('unknown', 20, 'spread_length', -0.4689, 0.2903),
  ('unknown', 20, 'spread_width', -1.12, 0.2057),
  ('unknown', 20, 'tilt_deg', 3.464, 3.24),
  ('unknown', 20, 'width', -0.8989, 0.1711),
  ('unknown', 20, 'z_max', 0.7071, 0.1981),
  ('unknown', 20, 'z_min', 0.6773, 0.1965);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.02156, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'area_m2', -1.882, 0.3599),
  ('unknown', 21, 'aspect', 0.5135, 0.2968),
  ('unknown', 21, 'behind', 0.4552, 0.2437),
  ('unknown', 21, 'edge_free', 0.7883, 0.2035),
  ('unknown', 21, 'edge_free_top', 0.9902, 0.03),
  ('unknown', 21, 'edge_joined', 0.01434, 0.03),
  ('unknown', 21, 'height', 0.7659, 0.2597),
  ('unknown', 21, 'length', -0.4883, 0.2239),
  ('unknown', 21, 'rectangularity', 0.688, 0.1244),
  ('unknown', 21, 'spread_length', -0.6951, 0.2694),
  ('unknown', 21, 'spread_width', -1.232, 0.2374),
  ('unknown', 21, 'tilt_deg', 86.62, 5.295),
  ('unknown', 21, 'width', -1.002, 0.2381),
  ('unknown', 21, 'z_max', 0.9717, 0.2683),
  ('unknown', 21, 'z_min', 0.4647, 0.2906);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.02052, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'area_m2', -2.298, 0.3074),
  ('unknown', 22, 'aspect', 1.385, 0.2883),
  ('unknown', 22, 'behind', 0.3963, 0.3399),
  ('unknown', 22, 'edge_free', 0.2999, 0.2691),
  ('unknown', 22, 'edge_free_top', 0.4488, 0.3916),
  ('unknown', 22, 'edge_joined', 0.3953, 0.3381),
  ('unknown', 22, 'height', 1.011, 0.5055),
  ('unknown', 22, 'length', -0.287, 0.2272),
  ('unknown', 22, 'rectangularity', 0.7199, 0.09489),
  ('unknown', 22, 'spread_length', -0.4514, 0.2593),
  ('unknown', 22, 'spread_width', -1.902, 0.191),
  ('unknown', 22, 'tilt_deg', 88.88, 2.54),
  ('unknown', 22, 'width', -1.672, 0.1944),
  ('unknown', 22, 'z_max', 1.305, 0.5562),
  ('unknown', 22, 'z_min', 0.71, 0.5159);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.02042, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'area_m2', -2.911, 0.3355),
  ('unknown', 23, 'aspect', 0.5498, 0.307),
  ('unknown', 23, 'behind', 0.5164, 0.2802),
  ('unknown', 23, 'edge_free', 0.4923, 0.2525),
  ('unknown', 23, 'edge_free_top', 0.5454, 0.3754),
  ('unknown', 23, 'edge_joined', 0.09948, 0.1343),
  ('unknown', 23, 'height', 0.5876, 0.1333),
  ('unknown', 23, 'length', -0.9843, 0.2282),
  ('unknown', 23, 'rectangularity', 0.6859, 0.1164),
  ('unknown', 23, 'spread_length', -1.153, 0.2244),
  ('unknown', 23, 'spread_width', -1.775, 0.2306),
  ('unknown', 23, 'tilt_deg', 87.66, 3.471),
  ('unknown', 23, 'width', -1.534, 0.2462),
  ('unknown', 23, 'z_max', 0.7287, 0.1393),
  ('unknown', 23, 'z_min', 0.4272, 0.1401);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.01747, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'area_m2', -1.481, 0.2594),
  ('unknown', 24, 'aspect', 0.3305, 0.2075),
  ('unknown', 24, 'behind', 0.584, 0.2313),
  ('unknown', 24, 'edge_free', 0.5461, 0.1713),
  ('unknown', 24, 'edge_free_top', 0.7879, 0.2347),
  ('unknown', 24, 'edge_joined', 0.2159, 0.1739),
  ('unknown', 24, 'height', 0.7554, 0.176),
  ('unknown', 24, 'length', -0.3986, 0.1658),
  ('unknown', 24, 'rectangularity', 0.7119, 0.1107),
  ('unknown', 24, 'spread_length', -0.5743, 0.1702),
  ('unknown', 24, 'spread_width', -0.9739, 0.1707),
  ('unknown', 24, 'tilt_deg', 82.82, 6.743),
  ('unknown', 24, 'width', -0.7291, 0.1655),
  ('unknown', 24, 'z_max', 1.009, 0.1868),
  ('unknown', 24, 'z_min', 0.4124, 0.1906);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.01708, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'area_m2', -2.541, 0.3335),
  ('unknown', 25, 'aspect', 0.4986, 0.2744),
  ('unknown', 25, 'behind', 0.6835, 0.1621),
  ('unknown', 25, 'edge_free', 0.5882, 0.2169),
  ('unknown', 25, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 25, 'edge_joined', 0.1883, 0.135),
  ('unknown', 25, 'height', 0.4024, 0.1055),
  ('unknown', 25, 'length', -0.8783, 0.2154),
  ('unknown', 25, 'rectangularity', 0.7602, 0.1087),
  ('unknown', 25, 'spread_length', -0.9899, 0.2174),
  ('unknown', 25, 'spread_width', -1.552, 0.2163),
  ('unknown', 25, 'tilt_deg', 2.327, 3.281),
  ('unknown', 25, 'width', -1.377, 0.2207),
  ('unknown', 25, 'z_max', 0.4105, 0.1142),
  ('unknown', 25, 'z_min', 0.395, 0.1079);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.01699, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'area_m2', -3.465, 0.3457),
  ('unknown', 26, 'aspect', 0.3086, 0.2484),
  ('unknown', 26, 'behind', 0.3064, 0.2303),
  ('unknown', 26, 'edge_free', 0.3747, 0.3266),
  ('unknown', 26, 'edge_free_top', 0.5641, 0.1292),
  ('unknown', 26, 'edge_joined', 0.5016, 0.338),
  ('unknown', 26, 'height', 0.7921, 0.08331),
  ('unknown', 26, 'length', -1.447, 0.2528),
  ('unknown', 26, 'rectangularity', 0.7744, 0.08855),
  ('unknown', 26, 'spread_length', -1.573, 0.2429),
  ('unknown', 26, 'spread_width', -1.893, 0.1486),
  ('unknown', 26, 'tilt_deg', 5.916, 6.64),
  ('unknown', 26, 'width', -1.756, 0.1672),
  ('unknown', 26, 'z_max', 0.8055, 0.09528),
  ('unknown', 26, 'z_min', 0.7808, 0.08662);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.01673, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'area_m2', -2.256, 0.4731),
  ('unknown', 27, 'aspect', 0.9542, 0.4055),
  ('unknown', 27, 'behind', 0.3122, 0.2738),
  ('unknown', 27, 'edge_free', 0.9654, 0.07356),
  ('unknown', 27, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 27, 'edge_joined', 0.01869, 0.04127),
  ('unknown', 27, 'height', 2.482, 0.2906),
  ('unknown', 27, 'length', -0.5245, 0.4103),
  ('unknown', 27, 'rectangularity', 0.7833, 0.09638),
  ('unknown', 27, 'spread_length', -0.642, 0.4031),
  ('unknown', 27, 'spread_width', -1.619, 0.1154),
  ('unknown', 27, 'tilt_deg', 1.866, 2.559),
  ('unknown', 27, 'width', -1.479, 0.122),
  ('unknown', 27, 'z_max', 2.488, 0.2943),
  ('unknown', 27, 'z_min', 2.476, 0.2911);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.01653, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'area_m2', -2.639, 0.4083),
  ('unknown', 28, 'aspect', 0.7683, 0.3124),
  ('unknown', 28, 'behind', 0.4744, 0.3053),
  ('unknown', 28, 'edge_free', 0.3591, 0.2387),
  ('unknown', 28, 'edge_free_top', 0.5411, 0.3788),
  ('unknown', 28, 'edge_joined', 0.389, 0.2776),
  ('unknown', 28, 'height', 1.511, 1.136),
  ('unknown', 28, 'length', -0.7134, 0.2542),
  ('unknown', 28, 'rectangularity', 0.6527, 0.1155),
  ('unknown', 28, 'spread_length', -0.8614, 0.2905),
  ('unknown', 28, 'spread_width', -1.73, 0.2887),
  ('unknown', 28, 'tilt_deg', 41.22, 34.96),
  ('unknown', 28, 'width', -1.482, 0.268),
  ('unknown', 28, 'z_max', 1.611, 1.159),
  ('unknown', 28, 'z_min', 1.411, 1.125);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.01611, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'area_m2', -1.895, 0.3768),
  ('unknown', 29, 'aspect', 1.393, 0.3598),
  ('unknown', 29, 'behind', 0.6663, 0.2136),
  ('unknown', 29, 'edge_free', 0.348, 0.1501),
  ('unknown', 29, 'edge_free_top', 0.2824, 0.1711),
  ('unknown', 29, 'edge_joined', 0.4664, 0.2052),
  ('unknown', 29, 'height', 0.8861, 0.216),
  ('unknown', 29, 'length', -0.03486, 0.2564),
  ('unknown', 29, 'rectangularity', 0.6592, 0.1103),
  ('unknown', 29, 'spread_length', -0.1538, 0.2518),
  ('unknown', 29, 'spread_width', -1.686, 0.2312),
  ('unknown', 29, 'tilt_deg', 7.572, 7.04),
  ('unknown', 29, 'width', -1.428, 0.2875),
  ('unknown', 29, 'z_max', 0.9091, 0.2291),
  ('unknown', 29, 'z_min', 0.8698, 0.2124);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.01589, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'area_m2', -0.6931, 0.3734),
  ('unknown', 30, 'aspect', 0.3719, 0.2118),
  ('unknown', 30, 'behind', 0.1438, 0.2044),
  ('unknown', 30, 'edge_free', 0.8708, 0.1251),
  ('unknown', 30, 'edge_free_top', 0.9351, 0.1087),
  ('unknown', 30, 'edge_joined', 0.04955, 0.07315),
  ('unknown', 30, 'height', 1.53, 0.1972),
  ('unknown', 30, 'length', -0.0433, 0.2335),
  ('unknown', 30, 'rectangularity', 0.8007, 0.1159),
  ('unknown', 30, 'spread_length', -0.1543, 0.2668),
  ('unknown', 30, 'spread_width', -0.6284, 0.2106),
  ('unknown', 30, 'tilt_deg', 89.03, 2.545),
  ('unknown', 30, 'width', -0.4152, 0.1816),
  ('unknown', 30, 'z_max', 1.916, 0.2128),
  ('unknown', 30, 'z_min', 1.186, 0.2354);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.0155, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'area_m2', -1.218, 0.1759),
  ('unknown', 31, 'aspect', 1.533, 0.323),
  ('unknown', 31, 'behind', 0.4391, 0.2755),
  ('unknown', 31, 'edge_free', 0.7335, 0.1154),
  ('unknown', 31, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 31, 'edge_joined', 0.2402, 0.1112),
  ('unknown', 31, 'height', 2.367, 0.1857),
  ('unknown', 31, 'length', 0.3139, 0.1277),
  ('unknown', 31, 'rectangularity', 0.7531, 0.1559),
  ('unknown', 31, 'spread_length', 0.2652, 0.1488),
  ('unknown', 31, 'spread_width', -1.482, 0.09109),
  ('unknown', 31, 'tilt_deg', 2.33, 2.836),
  ('unknown', 31, 'width', -1.219, 0.2988),
  ('unknown', 31, 'z_max', 2.373, 0.1909),
  ('unknown', 31, 'z_min', 2.358, 0.1878);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.01502, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'area_m2', -0.3709, 0.2978),
  ('unknown', 32, 'aspect', 0.4161, 0.2504),
  ('unknown', 32, 'behind', 0.437, 0.1605),
  ('unknown', 32, 'edge_free', 0.5764, 0.1678),
  ('unknown', 32, 'edge_free_top', 0.8455, 0.1509),
  ('unknown', 32, 'edge_joined', 0.1485, 0.1507),
  ('unknown', 32, 'height', 0.5765, 0.17),
  ('unknown', 32, 'length', 0.1712, 0.1863),
  ('unknown', 32, 'rectangularity', 0.7515, 0.1066),
  ('unknown', 32, 'spread_length', 0.0183, 0.1845),
  ('unknown', 32, 'spread_width', -0.4742, 0.2286),
  ('unknown', 32, 'tilt_deg', 84.47, 6.952),
  ('unknown', 32, 'width', -0.2449, 0.1908),
  ('unknown', 32, 'z_max', 0.9981, 0.248),
  ('unknown', 32, 'z_min', 0.04042, 0.1124);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.01434, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'area_m2', -1.118, 0.4677),
  ('unknown', 33, 'aspect', 1.687, 0.4609),
  ('unknown', 33, 'behind', 0.5094, 0.278),
  ('unknown', 33, 'edge_free', 0.3654, 0.2174),
  ('unknown', 33, 'edge_free_top', 0.2092, 0.2535),
  ('unknown', 33, 'edge_joined', 0.3823, 0.2889),
  ('unknown', 33, 'height', 1.606, 0.8238),
  ('unknown', 33, 'length', 0.5027, 0.306),
  ('unknown', 33, 'rectangularity', 0.6665, 0.1423),
  ('unknown', 33, 'spread_length', 0.3622, 0.3243),
  ('unknown', 33, 'spread_width', -1.525, 0.3746),
  ('unknown', 33, 'tilt_deg', 87.87, 4.306),
  ('unknown', 33, 'width', -1.185, 0.3633),
  ('unknown', 33, 'z_max', 2.172, 0.7558),
  ('unknown', 33, 'z_min', 1.025, 1.084);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.01396, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'area_m2', -1.355, 0.4307),
  ('unknown', 34, 'aspect', 1.552, 0.3691),
  ('unknown', 34, 'behind', 0.7018, 0.1032),
  ('unknown', 34, 'edge_free', 0.0221, 0.04059),
  ('unknown', 34, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 34, 'edge_joined', 0.9244, 0.08239),
  ('unknown', 34, 'height', 0.9001, 0.07875),
  ('unknown', 34, 'length', 0.2397, 0.3247),
  ('unknown', 34, 'rectangularity', 0.7578, 0.07482),
  ('unknown', 34, 'spread_length', 0.08683, 0.3234),
  ('unknown', 34, 'spread_width', -1.327, 0.2456),
  ('unknown', 34, 'tilt_deg', 2.718, 2.93),
  ('unknown', 34, 'width', -1.312, 0.2277),
  ('unknown', 34, 'z_max', 0.909, 0.09307),
  ('unknown', 34, 'z_min', 0.8915, 0.08138);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.01282, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'area_m2', -3.552, 0.2365),
  ('unknown', 35, 'aspect', 0.3678, 0.2215),
  ('unknown', 35, 'behind', 0.4029, 0.3049),
  ('unknown', 35, 'edge_free', 0.6555, 0.1989),
  ('unknown', 35, 'edge_free_top', 0.977, 0.05576),
  ('unknown', 35, 'edge_joined', 0.107, 0.1318),
  ('unknown', 35, 'height', 1.16, 0.7019),
  ('unknown', 35, 'length', -1.465, 0.181),
  ('unknown', 35, 'rectangularity', 0.7814, 0.0966),
  ('unknown', 35, 'spread_length', -1.583, 0.1609),
  ('unknown', 35, 'spread_width', -1.968, 0.1335),
  ('unknown', 35, 'tilt_deg', 58.87, 36.9),
  ('unknown', 35, 'width', -1.832, 0.1555),
  ('unknown', 35, 'z_max', 1.223, 0.7021),
  ('unknown', 35, 'z_min', 1.087, 0.7112);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.01241, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'area_m2', -0.9145, 0.3228),
  ('unknown', 36, 'aspect', 1.151, 0.2568),
  ('unknown', 36, 'behind', 0.4881, 0.2274),
  ('unknown', 36, 'edge_free', 0.5027, 0.1336),
  ('unknown', 36, 'edge_free_top', 0.8528, 0.1667),
  ('unknown', 36, 'edge_joined', 0.06203, 0.1267),
  ('unknown', 36, 'height', 0.9464, 0.09413),
  ('unknown', 36, 'length', 0.2939, 0.2003),
  ('unknown', 36, 'rectangularity', 0.7154, 0.1207),
  ('unknown', 36, 'spread_length', 0.1476, 0.2401),
  ('unknown', 36, 'spread_width', -1.046, 0.2165),
  ('unknown', 36, 'tilt_deg', 89.27, 2.68),
  ('unknown', 36, 'width', -0.8572, 0.2164),
  ('unknown', 36, 'z_max', 1.15, 0.1385),
  ('unknown', 36, 'z_min', 0.6842, 0.09055);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.01154, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'area_m2', 0.3561, 0.5905),
  ('unknown', 37, 'aspect', 0.5627, 0.3205),
  ('unknown', 37, 'behind', 0.2565, 0.2622),
  ('unknown', 37, 'edge_free', 0.3094, 0.234),
  ('unknown', 37, 'edge_free_top', 0.4027, 0.3218),
  ('unknown', 37, 'edge_joined', 0.3896, 0.2642),
  ('unknown', 37, 'height', 1.333, 0.5226),
  ('unknown', 37, 'length', 0.7464, 0.2928),
  ('unknown', 37, 'rectangularity', 0.5913, 0.17),
  ('unknown', 37, 'spread_length', 0.578, 0.363),
  ('unknown', 37, 'spread_width', -0.06822, 0.3825),
  ('unknown', 37, 'tilt_deg', 89.15, 2.76),
  ('unknown', 37, 'width', 0.1837, 0.3759),
  ('unknown', 37, 'z_max', 2.303, 0.7196),
  ('unknown', 37, 'z_min', 0.3043, 0.5227);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.01133, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'area_m2', -1.866, 0.2662),
  ('unknown', 38, 'aspect', 0.2037, 0.1546),
  ('unknown', 38, 'behind', 0.288, 0.2269),
  ('unknown', 38, 'edge_free', 0.8426, 0.132),
  ('unknown', 38, 'edge_free_top', 0.5639, 0.1292),
  ('unknown', 38, 'edge_joined', 0.04762, 0.08366),
  ('unknown', 38, 'height', 0.2059, 0.143),
  ('unknown', 38, 'length', -0.6525, 0.1874),
  ('unknown', 38, 'rectangularity', 0.7135, 0.1385),
  ('unknown', 38, 'spread_length', -0.8162, 0.1318),
  ('unknown', 38, 'spread_width', -1.058, 0.1638),
  ('unknown', 38, 'tilt_deg', 1.48, 2.988),
  ('unknown', 38, 'width', -0.8562, 0.2093),
  ('unknown', 38, 'z_max', 0.2124, 0.1528),
  ('unknown', 38, 'z_min', 0.199, 0.146);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.008113, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'area_m2', -0.4576, 0.3062),
  ('unknown', 39, 'aspect', 1.005, 0.4502),
  ('unknown', 39, 'behind', 0.7513, 0.07668),
  ('unknown', 39, 'edge_free', 0.147, 0.1067),
  ('unknown', 39, 'edge_free_top', 0.2393, 0.1797),
  ('unknown', 39, 'edge_joined', 0.8171, 0.1233),
  ('unknown', 39, 'height', 0.8806, 0.257),
  ('unknown', 39, 'length', 0.4854, 0.2661),
  ('unknown', 39, 'rectangularity', 0.6703, 0.1339),
  ('unknown', 39, 'spread_length', 0.3534, 0.2575),
  ('unknown', 39, 'spread_width', -0.5865, 0.2783),
  ('unknown', 39, 'tilt_deg', 88.98, 3.431),
  ('unknown', 39, 'width', -0.5193, 0.308),
  ('unknown', 39, 'z_max', 1.701, 0.5023),
  ('unknown', 39, 'z_min', 0.05507, 0.1387);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.007498, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'area_m2', -0.07383, 0.654),
  ('unknown', 40, 'aspect', 0.6429, 0.4284),
  ('unknown', 40, 'behind', 0.6371, 0.1616),
  ('unknown', 40, 'edge_free', 0.2452, 0.1871),
  ('unknown', 40, 'edge_free_top', 0.1369, 0.1206),
  ('unknown', 40, 'edge_joined', 0.577, 0.2434),
  ('unknown', 40, 'height', 0.897, 0.3233),
  ('unknown', 40, 'length', 0.5503, 0.4413),
  ('unknown', 40, 'rectangularity', 0.612, 0.1509),
  ('unknown', 40, 'spread_length', 0.3798, 0.4531),
  ('unknown', 40, 'spread_width', -0.2682, 0.3521),
  ('unknown', 40, 'tilt_deg', 10.33, 20.85),
  ('unknown', 40, 'width', -0.09257, 0.3465),
  ('unknown', 40, 'z_max', 0.9621, 0.3904),
  ('unknown', 40, 'z_min', 0.7988, 0.3352);

-- floor: 507 examples
UPDATE object_class SET prior = 0.02945 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.228, 1.69)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4558, 0.3633)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_joined', 0.2446, 0.1651)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.00134, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.121, 0.8071)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5918, 0.1305)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.8604, 0.7363)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.2776, 0.8893)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.5832, 0.9824)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.6594, 0.9788)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.007275, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.005046, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'floor';
DELETE FROM class_density WHERE class = 'floor';
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.262, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'area_m2', 2.546, 0.2778),
  ('floor', 1, 'aspect', 0.2633, 0.1585),
  ('floor', 1, 'behind', 0, 0.03),
  ('floor', 1, 'edge_free', 4.181e-08, 0.03),
  ('floor', 1, 'edge_free_top', 0, 0.3162),
  ('floor', 1, 'edge_joined', 0.2734, 0.1168),
  ('floor', 1, 'height', 0.0002588, 0.0225),
  ('floor', 1, 'length', 1.711, 0.1349),
  ('floor', 1, 'rectangularity', 0.5578, 0.1267),
  ('floor', 1, 'spread_length', 1.381, 0.1291),
  ('floor', 1, 'spread_width', 0.9477, 0.1467),
  ('floor', 1, 'tilt_deg', 0.01076, 0.45),
  ('floor', 1, 'width', 1.448, 0.1322),
  ('floor', 1, 'z_max', 0.000572, 0.0225),
  ('floor', 1, 'z_min', -0.0001077, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.1594, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'area_m2', 2.204, 0.199),
  ('floor', 2, 'aspect', 0.1702, 0.1103),
  ('floor', 2, 'behind', 0, 0.03),
  ('floor', 2, 'edge_free', 2.814e-05, 0.03),
  ('floor', 2, 'edge_free_top', 0, 0.3162),
  ('floor', 2, 'edge_joined', 0.302, 0.09649),
  ('floor', 2, 'height', 0.0007541, 0.0225),
  ('floor', 2, 'length', 1.419, 0.1047),
  ('floor', 2, 'rectangularity', 0.6371, 0.09896),
  ('floor', 2, 'spread_length', 1.156, 0.1066),
  ('floor', 2, 'spread_width', 0.8403, 0.1245),
  ('floor', 2, 'tilt_deg', 0.06886, 0.45),
  ('floor', 2, 'width', 1.249, 0.1271),
  ('floor', 2, 'z_max', 0.002731, 0.0225),
  ('floor', 2, 'z_min', -0.001477, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.1072, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'area_m2', 2.111, 0.318),
  ('floor', 3, 'aspect', 0.7767, 0.1455),
  ('floor', 3, 'behind', 0, 0.03),
  ('floor', 3, 'edge_free', 8.348e-08, 0.03),
  ('floor', 3, 'edge_free_top', 0, 0.3162),
  ('floor', 3, 'edge_joined', 0.2511, 0.11),
  ('floor', 3, 'height', 7.365e-05, 0.0225),
  ('floor', 3, 'length', 1.777, 0.1887),
  ('floor', 3, 'rectangularity', 0.5235, 0.09611),
  ('floor', 3, 'spread_length', 1.396, 0.1551),
  ('floor', 3, 'spread_width', 0.611, 0.1983),
  ('floor', 3, 'tilt_deg', 0.02876, 0.45),
  ('floor', 3, 'width', 0.9999, 0.204),
  ('floor', 3, 'z_max', 0.0006461, 0.0225),
  ('floor', 3, 'z_min', -0.0008728, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.1009, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'area_m2', 1.712, 0.2355),
  ('floor', 4, 'aspect', 0.3333, 0.1813),
  ('floor', 4, 'behind', 0, 0.03),
  ('floor', 4, 'edge_free', 9.78e-08, 0.03),
  ('floor', 4, 'edge_free_top', 0, 0.3162),
  ('floor', 4, 'edge_joined', 0.1751, 0.07182),
  ('floor', 4, 'height', -0.0001782, 0.0225),
  ('floor', 4, 'length', 1.352, 0.1494),
  ('floor', 4, 'rectangularity', 0.5268, 0.09171),
  ('floor', 4, 'spread_length', 1.11, 0.1476),
  ('floor', 4, 'spread_width', 0.5952, 0.1502),
  ('floor', 4, 'tilt_deg', 0.09023, 0.45),
  ('floor', 4, 'width', 1.018, 0.1734),
  ('floor', 4, 'z_max', 0.002488, 0.0225),
  ('floor', 4, 'z_min', -0.002405, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.0882, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'area_m2', -2.267, 0.7256),
  ('floor', 5, 'aspect', 0.7394, 0.4442),
  ('floor', 5, 'behind', 0, 0.03),
  ('floor', 5, 'edge_free', 1.014e-07, 0.03),
  ('floor', 5, 'edge_free_top', 0, 0.3162),
  ('floor', 5, 'edge_joined', 0.3835, 0.3384),
  ('floor', 5, 'height', 0.009795, 0.0225),
  ('floor', 5, 'length', -0.5756, 0.5042),
  ('floor', 5, 'rectangularity', 0.7013, 0.1316),
  ('floor', 5, 'spread_length', -0.7055, 0.4879),
  ('floor', 5, 'spread_width', -1.523, 0.3337),
  ('floor', 5, 'tilt_deg', 1.667, 0.9452),
  ('floor', 5, 'width', -1.315, 0.3385),
  ('floor', 5, 'z_max', 0.01608, 0.02282),
  ('floor', 5, 'z_min', 0.003317, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.07532, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'area_m2', -0.9735, 0.381),
  ('floor', 6, 'aspect', 0.6162, 0.3342),
  ('floor', 6, 'behind', 0, 0.03),
  ('floor', 6, 'edge_free', 1.188e-07, 0.03),
  ('floor', 6, 'edge_free_top', 0, 0.3162),
  ('floor', 6, 'edge_joined', 0.1839, 0.1344),
  ('floor', 6, 'height', 0.004801, 0.0225),
  ('floor', 6, 'length', 0.03804, 0.233),
  ('floor', 6, 'rectangularity', 0.6605, 0.1142),
  ('floor', 6, 'spread_length', -0.118, 0.2248),
  ('floor', 6, 'spread_width', -0.8174, 0.2527),
  ('floor', 6, 'tilt_deg', 1.907, 0.9226),
  ('floor', 6, 'width', -0.5782, 0.2447),
  ('floor', 6, 'z_max', 0.02064, 0.0225),
  ('floor', 6, 'z_min', -0.009041, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.068, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'area_m2', 0.05103, 0.3958),
  ('floor', 7, 'aspect', 0.7966, 0.4614),
  ('floor', 7, 'behind', 0, 0.03),
  ('floor', 7, 'edge_free', 1.315e-07, 0.03),
  ('floor', 7, 'edge_free_top', 0, 0.3162),
  ('floor', 7, 'edge_joined', 0.1619, 0.1381),
  ('floor', 7, 'height', -0.0005975, 0.0225),
  ('floor', 7, 'length', 0.6545, 0.2251),
  ('floor', 7, 'rectangularity', 0.6413, 0.1083),
  ('floor', 7, 'spread_length', 0.4838, 0.1862),
  ('floor', 7, 'spread_width', -0.4065, 0.3546),
  ('floor', 7, 'tilt_deg', 1.311, 0.7681),
  ('floor', 7, 'width', -0.1421, 0.3545),
  ('floor', 7, 'z_max', 0.01554, 0.0225),
  ('floor', 7, 'z_min', -0.01798, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.05482, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'area_m2', 1.125, 0.4982),
  ('floor', 8, 'aspect', 0.5216, 0.257),
  ('floor', 8, 'behind', 0, 0.03),
  ('floor', 8, 'edge_free', 1.173e-06, 0.03),
  ('floor', 8, 'edge_free_top', 0, 0.3162),
  ('floor', 8, 'edge_joined', 0.1384, 0.06862),
  ('floor', 8, 'height', 0.00155, 0.0225),
  ('floor', 8, 'length', 1.152, 0.2402),
  ('floor', 8, 'rectangularity', 0.5379, 0.1196),
  ('floor', 8, 'spread_length', 0.9248, 0.2009),
  ('floor', 8, 'spread_width', 0.3217, 0.2805),
  ('floor', 8, 'tilt_deg', 1.137, 0.6671),
  ('floor', 8, 'width', 0.6304, 0.256),
  ('floor', 8, 'z_max', 0.02901, 0.02381),
  ('floor', 8, 'z_min', -0.02801, 0.02537);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.02118, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'area_m2', -2.08, 0.7156),
  ('floor', 9, 'aspect', 0.9715, 0.5404),
  ('floor', 9, 'behind', 0, 0.03),
  ('floor', 9, 'edge_free', 4.223e-07, 0.03),
  ('floor', 9, 'edge_free_top', 0, 0.3162),
  ('floor', 9, 'edge_joined', 0.0317, 0.03769),
  ('floor', 9, 'height', -0.2825, 0.2997),
  ('floor', 9, 'length', -0.2809, 0.4993),
  ('floor', 9, 'rectangularity', 0.6082, 0.1576),
  ('floor', 9, 'spread_length', -0.4337, 0.4934),
  ('floor', 9, 'spread_width', -1.553, 0.3961),
  ('floor', 9, 'tilt_deg', 2.558, 1.151),
  ('floor', 9, 'width', -1.252, 0.4391),
  ('floor', 9, 'z_max', -0.2716, 0.3026),
  ('floor', 9, 'z_min', -0.2925, 0.2976);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 10, 0.01296, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 10, 'area_m2', -0.2077, 0.6167),
  ('floor', 10, 'aspect', 0.6002, 0.3518),
  ('floor', 10, 'behind', 0, 0.03),
  ('floor', 10, 'edge_free', 6.901e-07, 0.03),
  ('floor', 10, 'edge_free_top', 0, 0.3162),
  ('floor', 10, 'edge_joined', 0.1504, 0.1044),
  ('floor', 10, 'height', 0.06598, 0.02966),
  ('floor', 10, 'length', 0.5155, 0.3384),
  ('floor', 10, 'rectangularity', 0.5478, 0.1106),
  ('floor', 10, 'spread_length', 0.3163, 0.3204),
  ('floor', 10, 'spread_width', -0.3916, 0.3315),
  ('floor', 10, 'tilt_deg', 2.777, 0.7332),
  ('floor', 10, 'width', -0.08473, 0.3474),
  ('floor', 10, 'z_max', 0.0987, 0.0326),
  ('floor', 10, 'z_min', 0.03572, 0.03507);

-- ceiling: 426 examples
UPDATE object_class SET prior = 0.02475 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.671, 1.557)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4054, 0.372)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.01264, 0.06432)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.01158, 0.06141)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_joined', 0.4226, 0.2082)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.837, 0.3169)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.243, 0.6981)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6755, 0.1235)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.118, 0.6949)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.5422, 0.836)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.06787, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.8362, 0.8829)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.837, 0.3171)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.836, 0.3167)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'ceiling';
DELETE FROM class_density WHERE class = 'ceiling';
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.1859, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'area_m2', 2.593, 0.3205),
  ('ceiling', 1, 'aspect', 0.2098, 0.1519),
  ('ceiling', 1, 'behind', 0.0001628, 0.03),
  ('ceiling', 1, 'edge_free', 0.0001414, 0.03),
  ('ceiling', 1, 'edge_free_top', 0, 0.3162),
  ('ceiling', 1, 'edge_joined', 0.5879, 0.164),
  ('ceiling', 1, 'height', 2.512, 0.0635),
  ('ceiling', 1, 'length', 1.593, 0.1696),
  ('ceiling', 1, 'rectangularity', 0.6911, 0.1156),
  ('ceiling', 1, 'spread_length', 1.454, 0.1559),
  ('ceiling', 1, 'spread_width', 1.051, 0.166),
  ('ceiling', 1, 'tilt_deg', 0.00674, 0.45),
  ('ceiling', 1, 'width', 1.383, 0.134),
  ('ceiling', 1, 'z_max', 2.513, 0.06351),
  ('ceiling', 1, 'z_min', 2.512, 0.06348);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1707, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'area_m2', 2.603, 0.2521),
  ('ceiling', 2, 'aspect', 0.2209, 0.1353),
  ('ceiling', 2, 'behind', 0.0001772, 0.03),
  ('ceiling', 2, 'edge_free', 0.0001539, 0.03),
  ('ceiling', 2, 'edge_free_top', 0, 0.3162),
  ('ceiling', 2, 'edge_joined', 0.5118, 0.1522),
  ('ceiling', 2, 'height', 2.744, 0.06468),
  ('ceiling', 2, 'length', 1.616, 0.1191),
  ('ceiling', 2, 'rectangularity', 0.6727, 0.103),
  ('ceiling', 2, 'spread_length', 1.508, 0.1209),
  ('ceiling', 2, 'spread_width', 1.065, 0.1486),
  ('ceiling', 2, 'tilt_deg', 0.00632, 0.45),
  ('ceiling', 2, 'width', 1.396, 0.1189),
  ('ceiling', 2, 'z_max', 2.744, 0.06467),
  ('ceiling', 2, 'z_min', 2.744, 0.0647);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.141, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'area_m2', 2.034, 0.2855),
  ('ceiling', 3, 'aspect', 0.4622, 0.3007),
  ('ceiling', 3, 'behind', 0.0002145, 0.03),
  ('ceiling', 3, 'edge_free', 0.0001864, 0.03),
  ('ceiling', 3, 'edge_free_top', 0, 0.3162),
  ('ceiling', 3, 'edge_joined', 0.3352, 0.129),
  ('ceiling', 3, 'height', 2.991, 0.08161),
  ('ceiling', 3, 'length', 1.471, 0.1968),
  ('ceiling', 3, 'rectangularity', 0.6536, 0.1247),
  ('ceiling', 3, 'spread_length', 1.347, 0.1372),
  ('ceiling', 3, 'spread_width', 0.7067, 0.2015),
  ('ceiling', 3, 'tilt_deg', 0.01384, 0.45),
  ('ceiling', 3, 'width', 1.008, 0.2301),
  ('ceiling', 3, 'z_max', 2.992, 0.08154),
  ('ceiling', 3, 'z_min', 2.991, 0.08167);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.1152, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'area_m2', 2.718, 0.2876),
  ('ceiling', 4, 'aspect', 0.2184, 0.1375),
  ('ceiling', 4, 'behind', 0.0002625, 0.03),
  ('ceiling', 4, 'edge_free', 0.0002281, 0.03),
  ('ceiling', 4, 'edge_free_top', 0, 0.3162),
  ('ceiling', 4, 'edge_joined', 0.4776, 0.1528),
  ('ceiling', 4, 'height', 2.965, 0.08343),
  ('ceiling', 4, 'length', 1.648, 0.1338),
  ('ceiling', 4, 'rectangularity', 0.7099, 0.1266),
  ('ceiling', 4, 'spread_length', 1.529, 0.1256),
  ('ceiling', 4, 'spread_width', 1.105, 0.1444),
  ('ceiling', 4, 'tilt_deg', 0.005437, 0.45),
  ('ceiling', 4, 'width', 1.43, 0.1215),
  ('ceiling', 4, 'z_max', 2.965, 0.08343),
  ('ceiling', 4, 'z_min', 2.964, 0.08343);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.09811, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'area_m2', -1.551, 0.9282),
  ('ceiling', 5, 'aspect', 0.6081, 0.4247),
  ('ceiling', 5, 'behind', 0.0009813, 0.03),
  ('ceiling', 5, 'edge_free', 0.0005984, 0.03),
  ('ceiling', 5, 'edge_free_top', 0, 0.3162),
  ('ceiling', 5, 'edge_joined', 0.2147, 0.1428),
  ('ceiling', 5, 'height', 3.19, 0.3141),
  ('ceiling', 5, 'length', -0.2353, 0.5128),
  ('ceiling', 5, 'rectangularity', 0.6332, 0.1099),
  ('ceiling', 5, 'spread_length', -0.3811, 0.5112),
  ('ceiling', 5, 'spread_width', -1.073, 0.4497),
  ('ceiling', 5, 'tilt_deg', 0.5111, 0.7124),
  ('ceiling', 5, 'width', -0.8434, 0.4621),
  ('ceiling', 5, 'z_max', 3.192, 0.3145),
  ('ceiling', 5, 'z_min', 3.189, 0.3138);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.06964, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'area_m2', -0.9321, 0.7841),
  ('ceiling', 6, 'aspect', 0.9967, 0.4272),
  ('ceiling', 6, 'behind', 0.002912, 0.03),
  ('ceiling', 6, 'edge_free', 0.0003774, 0.03),
  ('ceiling', 6, 'edge_free_top', 0, 0.3162),
  ('ceiling', 6, 'edge_joined', 0.3122, 0.1704),
  ('ceiling', 6, 'height', 2.512, 0.03622),
  ('ceiling', 6, 'length', 0.2099, 0.4717),
  ('ceiling', 6, 'rectangularity', 0.7122, 0.1169),
  ('ceiling', 6, 'spread_length', 0.09236, 0.4418),
  ('ceiling', 6, 'spread_width', -0.9354, 0.4177),
  ('ceiling', 6, 'tilt_deg', 0.2364, 0.45),
  ('ceiling', 6, 'width', -0.7868, 0.4299),
  ('ceiling', 6, 'z_max', 2.513, 0.03625),
  ('ceiling', 6, 'z_min', 2.51, 0.03624);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.06665, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'area_m2', 2.006, 0.252),
  ('ceiling', 7, 'aspect', 0.4158, 0.2453),
  ('ceiling', 7, 'behind', 0.0004539, 0.03),
  ('ceiling', 7, 'edge_free', 0.0003944, 0.03),
  ('ceiling', 7, 'edge_free_top', 0, 0.3162),
  ('ceiling', 7, 'edge_joined', 0.5017, 0.1674),
  ('ceiling', 7, 'height', 2.646, 0.07355),
  ('ceiling', 7, 'length', 1.443, 0.148),
  ('ceiling', 7, 'rectangularity', 0.6412, 0.1214),
  ('ceiling', 7, 'spread_length', 1.306, 0.1239),
  ('ceiling', 7, 'spread_width', 0.7232, 0.1621),
  ('ceiling', 7, 'tilt_deg', 0.01335, 0.45),
  ('ceiling', 7, 'width', 1.027, 0.2018),
  ('ceiling', 7, 'z_max', 2.647, 0.07352),
  ('ceiling', 7, 'z_min', 2.646, 0.07355);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.05561, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'area_m2', 2.062, 0.5483),
  ('ceiling', 8, 'aspect', 0.4195, 0.2604),
  ('ceiling', 8, 'behind', 0.000544, 0.03),
  ('ceiling', 8, 'edge_free', 0.0004726, 0.03),
  ('ceiling', 8, 'edge_free_top', 0, 0.3162),
  ('ceiling', 8, 'edge_joined', 0.1782, 0.06886),
  ('ceiling', 8, 'height', 3.476, 0.2081),
  ('ceiling', 8, 'length', 1.485, 0.2912),
  ('ceiling', 8, 'rectangularity', 0.6256, 0.1196),
  ('ceiling', 8, 'spread_length', 1.361, 0.2633),
  ('ceiling', 8, 'spread_width', 0.7615, 0.2925),
  ('ceiling', 8, 'tilt_deg', 0.02408, 0.45),
  ('ceiling', 8, 'width', 1.066, 0.3403),
  ('ceiling', 8, 'z_max', 3.477, 0.2082),
  ('ceiling', 8, 'z_min', 3.476, 0.2081);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.02755, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'area_m2', 0.3588, 0.8095),
  ('ceiling', 9, 'aspect', 0.955, 0.5213),
  ('ceiling', 9, 'behind', 0.2608, 0.1937),
  ('ceiling', 9, 'edge_free', 0.1947, 0.1563),
  ('ceiling', 9, 'edge_free_top', 0, 0.3162),
  ('ceiling', 9, 'edge_joined', 0.4261, 0.2181),
  ('ceiling', 9, 'height', 2.722, 0.1875),
  ('ceiling', 9, 'length', 0.8369, 0.4966),
  ('ceiling', 9, 'rectangularity', 0.7056, 0.09153),
  ('ceiling', 9, 'spread_length', 0.7023, 0.461),
  ('ceiling', 9, 'spread_width', -0.3864, 0.3913),
  ('ceiling', 9, 'tilt_deg', 0.08833, 0.45),
  ('ceiling', 9, 'width', -0.1181, 0.4345),
  ('ceiling', 9, 'z_max', 2.723, 0.1879),
  ('ceiling', 9, 'z_min', 2.721, 0.1872);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 10, 0.01959, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 10, 'area_m2', 0.8324, 0.518),
  ('ceiling', 10, 'aspect', 0.7077, 0.3967),
  ('ceiling', 10, 'behind', 0.2821, 0.0696),
  ('ceiling', 10, 'edge_free', 0.2988, 0.06767),
  ('ceiling', 10, 'edge_free_top', 0, 0.3162),
  ('ceiling', 10, 'edge_joined', 0.2488, 0.07758),
  ('ceiling', 10, 'height', 3.233, 0.1751),
  ('ceiling', 10, 'length', 0.8841, 0.3711),
  ('ceiling', 10, 'rectangularity', 0.8013, 0.05836),
  ('ceiling', 10, 'spread_length', 0.777, 0.3403),
  ('ceiling', 10, 'spread_width', 0.03589, 0.2686),
  ('ceiling', 10, 'tilt_deg', 0.05224, 0.45),
  ('ceiling', 10, 'width', 0.1764, 0.2685),
  ('ceiling', 10, 'z_max', 3.234, 0.1749),
  ('ceiling', 10, 'z_min', 3.233, 0.1751);

-- wall: 2645 examples
UPDATE object_class SET prior = 0.1536 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 0.5372, 1.434)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.6393, 0.4706)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.09551, 0.1838)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.1215, 0.2162)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.1018, 0.234)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_joined', 0.2303, 0.2591)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.377, 0.4583)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 0.8162, 0.6844)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6555, 0.1515)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.6449, 0.6925)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', -0.08058, 0.8593)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.43, 1.982)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.1735, 0.8666)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.384, 0.7583)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.2713, 0.5153)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'wall';
DELETE FROM class_density WHERE class = 'wall';
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.2214, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'area_m2', 2.012, 0.3172),
  ('wall', 1, 'aspect', 0.4018, 0.2095),
  ('wall', 1, 'behind', 0.002838, 0.03),
  ('wall', 1, 'edge_free', 0.004955, 0.03),
  ('wall', 1, 'edge_free_top', 0.0009048, 0.03),
  ('wall', 1, 'edge_joined', 0.1367, 0.131),
  ('wall', 1, 'height', 1.54, 0.1775),
  ('wall', 1, 'length', 1.43, 0.2046),
  ('wall', 1, 'rectangularity', 0.6529, 0.123),
  ('wall', 1, 'spread_length', 1.271, 0.2147),
  ('wall', 1, 'spread_width', 0.7719, 0.1847),
  ('wall', 1, 'tilt_deg', 89.99, 0.45),
  ('wall', 1, 'width', 1.028, 0.09167),
  ('wall', 1, 'z_max', 2.826, 0.274),
  ('wall', 1, 'z_min', -0.01293, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.1468, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'area_m2', 1.119, 0.438),
  ('wall', 2, 'aspect', 0.4144, 0.2731),
  ('wall', 2, 'behind', 0.001413, 0.03),
  ('wall', 2, 'edge_free', 0.008539, 0.03),
  ('wall', 2, 'edge_free_top', 0.005523, 0.03),
  ('wall', 2, 'edge_joined', 0.2973, 0.2485),
  ('wall', 2, 'height', 1.501, 0.2723),
  ('wall', 2, 'length', 1.032, 0.2533),
  ('wall', 2, 'rectangularity', 0.6123, 0.1685),
  ('wall', 2, 'spread_length', 0.8375, 0.2609),
  ('wall', 2, 'spread_width', 0.305, 0.2334),
  ('wall', 2, 'tilt_deg', 89.95, 0.45),
  ('wall', 2, 'width', 0.6174, 0.2874),
  ('wall', 2, 'z_max', 2.742, 0.356),
  ('wall', 2, 'z_min', 0.2468, 0.3313);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.1051, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'area_m2', 0.01546, 0.7028),
  ('wall', 3, 'aspect', 0.8258, 0.5774),
  ('wall', 3, 'behind', 0.2795, 0.2315),
  ('wall', 3, 'edge_free', 0.4359, 0.2828),
  ('wall', 3, 'edge_free_top', 0.4395, 0.3918),
  ('wall', 3, 'edge_joined', 0.2461, 0.2638),
  ('wall', 3, 'height', 1.286, 0.3155),
  ('wall', 3, 'length', 0.6316, 0.3223),
  ('wall', 3, 'rectangularity', 0.6824, 0.1731),
  ('wall', 3, 'spread_length', 0.3919, 0.3838),
  ('wall', 3, 'spread_width', -0.4409, 0.5666),
  ('wall', 3, 'tilt_deg', 89.9, 0.45),
  ('wall', 3, 'width', -0.1942, 0.5956),
  ('wall', 3, 'z_max', 2.188, 0.5646),
  ('wall', 3, 'z_min', 0.3271, 0.324);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.1042, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'area_m2', -0.3597, 0.6661),
  ('wall', 4, 'aspect', 0.969, 0.6075),
  ('wall', 4, 'behind', 0.001861, 0.03),
  ('wall', 4, 'edge_free', 0.0049, 0.03),
  ('wall', 4, 'edge_free_top', 0.002385, 0.03),
  ('wall', 4, 'edge_joined', 0.2937, 0.297),
  ('wall', 4, 'height', 1.161, 0.3435),
  ('wall', 4, 'length', 0.5044, 0.3698),
  ('wall', 4, 'rectangularity', 0.69, 0.1518),
  ('wall', 4, 'spread_length', 0.3233, 0.391),
  ('wall', 4, 'spread_width', -0.6796, 0.5184),
  ('wall', 4, 'tilt_deg', 89.13, 1.281),
  ('wall', 4, 'width', -0.4645, 0.5375),
  ('wall', 4, 'z_max', 1.892, 0.5704),
  ('wall', 4, 'z_min', 0.36, 0.3847);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.09649, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'area_m2', 1.784, 0.3336),
  ('wall', 5, 'aspect', 0.365, 0.208),
  ('wall', 5, 'behind', 0.1333, 0.1226),
  ('wall', 5, 'edge_free', 0.1645, 0.1138),
  ('wall', 5, 'edge_free_top', 0.1148, 0.1608),
  ('wall', 5, 'edge_joined', 0.128, 0.1445),
  ('wall', 5, 'height', 1.521, 0.2086),
  ('wall', 5, 'length', 1.374, 0.2126),
  ('wall', 5, 'rectangularity', 0.5622, 0.117),
  ('wall', 5, 'spread_length', 1.233, 0.2279),
  ('wall', 5, 'spread_width', 0.7893, 0.208),
  ('wall', 5, 'tilt_deg', 89.97, 0.45),
  ('wall', 5, 'width', 1.009, 0.107),
  ('wall', 5, 'z_max', 2.836, 0.2644),
  ('wall', 5, 'z_min', -0.01085, 0.02904);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.08378, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'area_m2', 0.4991, 0.4116),
  ('wall', 6, 'aspect', 1.116, 0.4281),
  ('wall', 6, 'behind', 0.2793, 0.2634),
  ('wall', 6, 'edge_free', 0.2463, 0.2324),
  ('wall', 6, 'edge_free_top', 0.173, 0.1914),
  ('wall', 6, 'edge_joined', 0.2929, 0.3116),
  ('wall', 6, 'height', 1.397, 0.1665),
  ('wall', 6, 'length', 1.029, 0.1058),
  ('wall', 6, 'rectangularity', 0.6618, 0.1543),
  ('wall', 6, 'spread_length', 0.8634, 0.1637),
  ('wall', 6, 'spread_width', -0.3809, 0.4816),
  ('wall', 6, 'tilt_deg', 89.98, 0.45),
  ('wall', 6, 'width', -0.08642, 0.4199),
  ('wall', 6, 'z_max', 2.79, 0.2962),
  ('wall', 6, 'z_min', -0.01268, 0.02914);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.07441, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'area_m2', -2.269, 0.6183),
  ('wall', 7, 'aspect', 0.7498, 0.466),
  ('wall', 7, 'behind', 0.1838, 0.2487),
  ('wall', 7, 'edge_free', 0.249, 0.2974),
  ('wall', 7, 'edge_free_top', 0.2549, 0.3246),
  ('wall', 7, 'edge_joined', 0.3771, 0.3465),
  ('wall', 7, 'height', 1.13, 0.6832),
  ('wall', 7, 'length', -0.5804, 0.4629),
  ('wall', 7, 'rectangularity', 0.7127, 0.1276),
  ('wall', 7, 'spread_length', -0.7567, 0.4447),
  ('wall', 7, 'spread_width', -1.547, 0.3427),
  ('wall', 7, 'tilt_deg', 88.74, 1.842),
  ('wall', 7, 'width', -1.33, 0.3291),
  ('wall', 7, 'z_max', 1.383, 0.6947),
  ('wall', 7, 'z_min', 0.8697, 0.7139);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.0467, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'area_m2', -0.5968, 0.702),
  ('wall', 8, 'aspect', 0.69, 0.435),
  ('wall', 8, 'behind', 0.1092, 0.1936),
  ('wall', 8, 'edge_free', 0.08817, 0.1636),
  ('wall', 8, 'edge_free_top', 0.002787, 0.03),
  ('wall', 8, 'edge_joined', 0.3662, 0.2938),
  ('wall', 8, 'height', 2.27, 0.2892),
  ('wall', 8, 'length', 0.2301, 0.3804),
  ('wall', 8, 'rectangularity', 0.705, 0.1227),
  ('wall', 8, 'spread_length', 0.09507, 0.388),
  ('wall', 8, 'spread_width', -0.6746, 0.4304),
  ('wall', 8, 'tilt_deg', 89.88, 0.45),
  ('wall', 8, 'width', -0.4599, 0.4307),
  ('wall', 8, 'z_max', 2.859, 0.3672),
  ('wall', 8, 'z_min', 1.782, 0.4132);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.03942, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'area_m2', -1.99, 0.7783),
  ('wall', 9, 'aspect', 0.7522, 0.4989),
  ('wall', 9, 'behind', 0.002167, 0.03),
  ('wall', 9, 'edge_free', 0.003624, 0.03),
  ('wall', 9, 'edge_free_top', 0.004259, 0.03),
  ('wall', 9, 'edge_joined', 0.1136, 0.2051),
  ('wall', 9, 'height', 0.2399, 0.13),
  ('wall', 9, 'length', -0.4568, 0.4537),
  ('wall', 9, 'rectangularity', 0.7386, 0.1387),
  ('wall', 9, 'spread_length', -0.5688, 0.4594),
  ('wall', 9, 'spread_width', -1.407, 0.4478),
  ('wall', 9, 'tilt_deg', 88.39, 1.657),
  ('wall', 9, 'width', -1.209, 0.4301),
  ('wall', 9, 'z_max', 0.4525, 0.2082),
  ('wall', 9, 'z_min', 0.01668, 0.09001);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.03181, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'area_m2', -0.1226, 0.5535),
  ('wall', 10, 'aspect', 0.8333, 0.4133),
  ('wall', 10, 'behind', 0.1746, 0.1824),
  ('wall', 10, 'edge_free', 0.2443, 0.2098),
  ('wall', 10, 'edge_free_top', 0.3408, 0.3942),
  ('wall', 10, 'edge_joined', 0.0716, 0.1472),
  ('wall', 10, 'height', 0.9197, 0.3337),
  ('wall', 10, 'length', 0.6134, 0.3338),
  ('wall', 10, 'rectangularity', 0.6207, 0.1615),
  ('wall', 10, 'spread_length', 0.4966, 0.3307),
  ('wall', 10, 'spread_width', -0.5552, 0.4524),
  ('wall', 10, 'tilt_deg', 77.89, 16.51),
  ('wall', 10, 'width', -0.2199, 0.3823),
  ('wall', 10, 'z_max', 1.527, 0.4158),
  ('wall', 10, 'z_min', 0.1925, 0.396);

-- table: 772 examples
UPDATE object_class SET prior = 0.04487 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.3716, 0.665)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5502, 0.2972)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5274, 0.2141)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.4507, 0.2215)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_joined', 0.2812, 0.1939)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7274, 0.1091)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.2735, 0.3331)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.7046, 0.1263)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1235, 0.3246)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.474, 0.3918)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.6259, 0.632)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2791, 0.3613)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7337, 0.1092)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7226, 0.1088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'table';
DELETE FROM class_density WHERE class = 'table';
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.1541, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'area_m2', 0.1953, 0.1741),
  ('table', 1, 'aspect', 0.6086, 0.161),
  ('table', 1, 'behind', 0.6985, 0.05453),
  ('table', 1, 'edge_free', 0.3927, 0.1411),
  ('table', 1, 'edge_free_top', 0, 0.3162),
  ('table', 1, 'edge_joined', 0.3873, 0.1506),
  ('table', 1, 'height', 0.7323, 0.02505),
  ('table', 1, 'length', 0.563, 0.1059),
  ('table', 1, 'rectangularity', 0.7295, 0.08186),
  ('table', 1, 'spread_length', 0.3824, 0.1375),
  ('table', 1, 'spread_width', -0.1906, 0.1373),
  ('table', 1, 'tilt_deg', 0.4006, 0.45),
  ('table', 1, 'width', -0.04556, 0.1255),
  ('table', 1, 'z_max', 0.7374, 0.02515),
  ('table', 1, 'z_min', 0.7291, 0.02532);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.1375, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'area_m2', -0.2194, 0.1873),
  ('table', 2, 'aspect', 0.2997, 0.1535),
  ('table', 2, 'behind', 0.5876, 0.1874),
  ('table', 2, 'edge_free', 0.4103, 0.212),
  ('table', 2, 'edge_free_top', 0, 0.3162),
  ('table', 2, 'edge_joined', 0.312, 0.1978),
  ('table', 2, 'height', 0.7414, 0.02554),
  ('table', 2, 'length', 0.225, 0.1186),
  ('table', 2, 'rectangularity', 0.7011, 0.113),
  ('table', 2, 'spread_length', 0.08087, 0.1251),
  ('table', 2, 'spread_width', -0.2908, 0.122),
  ('table', 2, 'tilt_deg', 0.4579, 0.45),
  ('table', 2, 'width', -0.0747, 0.103),
  ('table', 2, 'z_max', 0.7466, 0.02673),
  ('table', 2, 'z_min', 0.7377, 0.02512);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.126, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'area_m2', -0.7185, 0.1765),
  ('table', 3, 'aspect', 0.3095, 0.1999),
  ('table', 3, 'behind', 0.4703, 0.2294),
  ('table', 3, 'edge_free', 0.4518, 0.2103),
  ('table', 3, 'edge_free_top', 0, 0.3162),
  ('table', 3, 'edge_joined', 0.2897, 0.185),
  ('table', 3, 'height', 0.7144, 0.03918),
  ('table', 3, 'length', -0.03829, 0.1283),
  ('table', 3, 'rectangularity', 0.7275, 0.1151),
  ('table', 3, 'spread_length', -0.1356, 0.119),
  ('table', 3, 'spread_width', -0.5566, 0.146),
  ('table', 3, 'tilt_deg', 0.6196, 0.45),
  ('table', 3, 'width', -0.3478, 0.1454),
  ('table', 3, 'z_max', 0.7198, 0.03912),
  ('table', 3, 'z_min', 0.7103, 0.03981);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.1193, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'area_m2', -0.03854, 0.2646),
  ('table', 4, 'aspect', 0.5577, 0.2414),
  ('table', 4, 'behind', 0.546, 0.1471),
  ('table', 4, 'edge_free', 0.4887, 0.1598),
  ('table', 4, 'edge_free_top', 0, 0.3162),
  ('table', 4, 'edge_joined', 0.223, 0.1394),
  ('table', 4, 'height', 0.6702, 0.02878),
  ('table', 4, 'length', 0.4427, 0.1719),
  ('table', 4, 'rectangularity', 0.7053, 0.1225),
  ('table', 4, 'spread_length', 0.304, 0.1787),
  ('table', 4, 'spread_width', -0.2799, 0.1694),
  ('table', 4, 'tilt_deg', 0.6401, 0.5945),
  ('table', 4, 'width', -0.115, 0.1649),
  ('table', 4, 'z_max', 0.6787, 0.02726),
  ('table', 4, 'z_min', 0.6637, 0.03134);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.1019, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'area_m2', -1.238, 0.2336),
  ('table', 5, 'aspect', 0.5241, 0.252),
  ('table', 5, 'behind', 0.4113, 0.2321),
  ('table', 5, 'edge_free', 0.4406, 0.245),
  ('table', 5, 'edge_free_top', 0, 0.3162),
  ('table', 5, 'edge_joined', 0.2543, 0.219),
  ('table', 5, 'height', 0.7211, 0.04864),
  ('table', 5, 'length', -0.147, 0.19),
  ('table', 5, 'rectangularity', 0.6684, 0.1173),
  ('table', 5, 'spread_length', -0.3071, 0.1789),
  ('table', 5, 'spread_width', -0.9285, 0.1794),
  ('table', 5, 'tilt_deg', 0.8802, 0.7449),
  ('table', 5, 'width', -0.6711, 0.1634),
  ('table', 5, 'z_max', 0.7271, 0.04883),
  ('table', 5, 'z_min', 0.7166, 0.04829);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.0911, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'area_m2', 0.1275, 0.1747),
  ('table', 6, 'aspect', 0.7237, 0.1235),
  ('table', 6, 'behind', 0.4826, 0.1753),
  ('table', 6, 'edge_free', 0.6822, 0.1371),
  ('table', 6, 'edge_free_top', 0, 0.3162),
  ('table', 6, 'edge_joined', 0.1397, 0.091),
  ('table', 6, 'height', 0.7331, 0.03194),
  ('table', 6, 'length', 0.5228, 0.1053),
  ('table', 6, 'rectangularity', 0.8273, 0.07556),
  ('table', 6, 'spread_length', 0.372, 0.1238),
  ('table', 6, 'spread_width', -0.3279, 0.1049),
  ('table', 6, 'tilt_deg', 0.2895, 0.45),
  ('table', 6, 'width', -0.2009, 0.1027),
  ('table', 6, 'z_max', 0.7366, 0.03322),
  ('table', 6, 'z_min', 0.7302, 0.0311);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.07818, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'area_m2', -0.07908, 0.5729),
  ('table', 7, 'aspect', 0.7595, 0.3469),
  ('table', 7, 'behind', 0.5642, 0.173),
  ('table', 7, 'edge_free', 0.4431, 0.1922),
  ('table', 7, 'edge_free_top', 0, 0.3162),
  ('table', 7, 'edge_joined', 0.2501, 0.17),
  ('table', 7, 'height', 0.7457, 0.03024),
  ('table', 7, 'length', 0.6174, 0.2862),
  ('table', 7, 'rectangularity', 0.595, 0.1468),
  ('table', 7, 'spread_length', 0.4242, 0.2586),
  ('table', 7, 'spread_width', -0.3958, 0.4132),
  ('table', 7, 'tilt_deg', 0.3516, 0.45),
  ('table', 7, 'width', -0.1421, 0.3683),
  ('table', 7, 'z_max', 0.7505, 0.03027),
  ('table', 7, 'z_min', 0.7425, 0.03114);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.07229, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'area_m2', -0.2374, 0.4678),
  ('table', 8, 'aspect', 0.5523, 0.2732),
  ('table', 8, 'behind', 0.4849, 0.1796),
  ('table', 8, 'edge_free', 0.3333, 0.2004),
  ('table', 8, 'edge_free_top', 0, 0.3162),
  ('table', 8, 'edge_joined', 0.4292, 0.2002),
  ('table', 8, 'height', 0.9167, 0.1148),
  ('table', 8, 'length', 0.3433, 0.2737),
  ('table', 8, 'rectangularity', 0.7031, 0.1307),
  ('table', 8, 'spread_length', 0.2103, 0.2561),
  ('table', 8, 'spread_width', -0.396, 0.2777),
  ('table', 8, 'tilt_deg', 1.066, 0.6644),
  ('table', 8, 'width', -0.209, 0.2353),
  ('table', 8, 'z_max', 0.9292, 0.1132),
  ('table', 8, 'z_min', 0.9068, 0.1158);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.05615, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'area_m2', -1.994, 0.529),
  ('table', 9, 'aspect', 1.046, 0.3285),
  ('table', 9, 'behind', 0.3646, 0.264),
  ('table', 9, 'edge_free', 0.4678, 0.3226),
  ('table', 9, 'edge_free_top', 0, 0.3162),
  ('table', 9, 'edge_joined', 0.1838, 0.1638),
  ('table', 9, 'height', 0.7276, 0.05121),
  ('table', 9, 'length', -0.2325, 0.3465),
  ('table', 9, 'rectangularity', 0.6268, 0.1081),
  ('table', 9, 'spread_length', -0.3988, 0.3794),
  ('table', 9, 'spread_width', -1.511, 0.2768),
  ('table', 9, 'tilt_deg', 1.584, 1.666),
  ('table', 9, 'width', -1.278, 0.2718),
  ('table', 9, 'z_max', 0.7347, 0.05301),
  ('table', 9, 'z_min', 0.722, 0.05039);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.01336, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'area_m2', -0.6861, 0.694),
  ('table', 10, 'aspect', 0.5014, 0.1453),
  ('table', 10, 'behind', 0.2058, 0.1292),
  ('table', 10, 'edge_free', 0.2977, 0.1152),
  ('table', 10, 'edge_free_top', 0, 0.3162),
  ('table', 10, 'edge_joined', 0.18, 0.1705),
  ('table', 10, 'height', 0.06685, 0.05897),
  ('table', 10, 'length', 0.1463, 0.3309),
  ('table', 10, 'rectangularity', 0.6293, 0.08754),
  ('table', 10, 'spread_length', 0.01775, 0.3005),
  ('table', 10, 'spread_width', -0.622, 0.4182),
  ('table', 10, 'tilt_deg', 1.335, 0.6231),
  ('table', 10, 'width', -0.3552, 0.388),
  ('table', 10, 'z_max', 0.07842, 0.05884),
  ('table', 10, 'z_min', 0.05696, 0.05954);

-- flat_screen: 595 examples
UPDATE object_class SET prior = 0.03461 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.82, 0.3869)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.3887, 0.2101)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5919, 0.1347)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.767, 0.1695)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.9802, 0.06017)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_joined', 0.0477, 0.08367)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.017, 0.0955)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.5974, 0.2561)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.7998, 0.1148)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7636, 0.2049)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.199, 0.1747)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.15, 3.305)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -0.9868, 0.2153)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.175, 0.1062)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7789, 0.1234)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'flat_screen';
DELETE FROM class_density WHERE class = 'flat_screen';
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.1778, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'area_m2', -1.54, 0.1225),
  ('flat_screen', 1, 'aspect', 0.3039, 0.1143),
  ('flat_screen', 1, 'behind', 0.5727, 0.1251),
  ('flat_screen', 1, 'edge_free', 0.7407, 0.07886),
  ('flat_screen', 1, 'edge_free_top', 0.9948, 0.03),
  ('flat_screen', 1, 'edge_joined', 0.06945, 0.07131),
  ('flat_screen', 1, 'height', 1.005, 0.04965),
  ('flat_screen', 1, 'length', -0.5187, 0.09652),
  ('flat_screen', 1, 'rectangularity', 0.8226, 0.06865),
  ('flat_screen', 1, 'spread_length', -0.6412, 0.08453),
  ('flat_screen', 1, 'spread_width', -1.081, 0.06855),
  ('flat_screen', 1, 'tilt_deg', 85.41, 3.025),
  ('flat_screen', 1, 'width', -0.8226, 0.0822),
  ('flat_screen', 1, 'z_max', 1.168, 0.05138),
  ('flat_screen', 1, 'z_min', 0.7268, 0.04697);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.1395, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'area_m2', -1.994, 0.1541),
  ('flat_screen', 2, 'aspect', 0.1647, 0.1121),
  ('flat_screen', 2, 'behind', 0.6343, 0.116),
  ('flat_screen', 2, 'edge_free', 0.7477, 0.07008),
  ('flat_screen', 2, 'edge_free_top', 0.9998, 0.03),
  ('flat_screen', 2, 'edge_joined', 0.04133, 0.03894),
  ('flat_screen', 2, 'height', 0.973, 0.04749),
  ('flat_screen', 2, 'length', -0.8102, 0.1171),
  ('flat_screen', 2, 'rectangularity', 0.8146, 0.06986),
  ('flat_screen', 2, 'spread_length', -0.9485, 0.1187),
  ('flat_screen', 2, 'spread_width', -1.247, 0.06677),
  ('flat_screen', 2, 'tilt_deg', 85.6, 3.337),
  ('flat_screen', 2, 'width', -0.975, 0.08042),
  ('flat_screen', 2, 'z_max', 1.111, 0.05047),
  ('flat_screen', 2, 'z_min', 0.7234, 0.04348);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.1049, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'area_m2', -1.758, 0.1273),
  ('flat_screen', 3, 'aspect', 0.4964, 0.06388),
  ('flat_screen', 3, 'behind', 0.5574, 0.118),
  ('flat_screen', 3, 'edge_free', 0.9827, 0.03121),
  ('flat_screen', 3, 'edge_free_top', 0.9992, 0.03),
  ('flat_screen', 3, 'edge_joined', 0.003203, 0.03),
  ('flat_screen', 3, 'height', 1.032, 0.04256),
  ('flat_screen', 3, 'length', -0.5897, 0.07577),
  ('flat_screen', 3, 'rectangularity', 0.9222, 0.03821),
  ('flat_screen', 3, 'spread_length', -0.6378, 0.06464),
  ('flat_screen', 3, 'spread_width', -1.138, 0.0747),
  ('flat_screen', 3, 'tilt_deg', 85.17, 3.555),
  ('flat_screen', 3, 'width', -1.086, 0.07412),
  ('flat_screen', 3, 'z_max', 1.188, 0.04408),
  ('flat_screen', 3, 'z_min', 0.8496, 0.03981);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.1014, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'area_m2', -1.587, 0.2143),
  ('flat_screen', 4, 'aspect', 0.5917, 0.1483),
  ('flat_screen', 4, 'behind', 0.6192, 0.1415),
  ('flat_screen', 4, 'edge_free', 0.6207, 0.05542),
  ('flat_screen', 4, 'edge_free_top', 0.9902, 0.03),
  ('flat_screen', 4, 'edge_joined', 0.02564, 0.03355),
  ('flat_screen', 4, 'height', 0.9474, 0.04203),
  ('flat_screen', 4, 'length', -0.3102, 0.1529),
  ('flat_screen', 4, 'rectangularity', 0.6911, 0.06803),
  ('flat_screen', 4, 'spread_length', -0.6876, 0.1759),
  ('flat_screen', 4, 'spread_width', -1.135, 0.1035),
  ('flat_screen', 4, 'tilt_deg', 85.43, 3.02),
  ('flat_screen', 4, 'width', -0.9019, 0.09278),
  ('flat_screen', 4, 'z_max', 1.108, 0.04511),
  ('flat_screen', 4, 'z_min', 0.6935, 0.03846);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.09801, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'area_m2', -2.207, 0.1478),
  ('flat_screen', 5, 'aspect', 0.3548, 0.1303),
  ('flat_screen', 5, 'behind', 0.5816, 0.1228),
  ('flat_screen', 5, 'edge_free', 0.9859, 0.03),
  ('flat_screen', 5, 'edge_free_top', 0.998, 0.03),
  ('flat_screen', 5, 'edge_joined', 0.003074, 0.03),
  ('flat_screen', 5, 'height', 1.008, 0.05223),
  ('flat_screen', 5, 'length', -0.8794, 0.1207),
  ('flat_screen', 5, 'rectangularity', 0.9125, 0.05428),
  ('flat_screen', 5, 'spread_length', -0.9285, 0.1079),
  ('flat_screen', 5, 'spread_width', -1.289, 0.0678),
  ('flat_screen', 5, 'tilt_deg', 84.71, 3.299),
  ('flat_screen', 5, 'width', -1.234, 0.07498),
  ('flat_screen', 5, 'z_max', 1.144, 0.05241),
  ('flat_screen', 5, 'z_min', 0.8505, 0.0505);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.09586, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'area_m2', -1.311, 0.2377),
  ('flat_screen', 6, 'aspect', 0.5047, 0.2142),
  ('flat_screen', 6, 'behind', 0.6136, 0.1419),
  ('flat_screen', 6, 'edge_free', 0.5527, 0.1171),
  ('flat_screen', 6, 'edge_free_top', 0.8912, 0.0983),
  ('flat_screen', 6, 'edge_joined', 0.1816, 0.1816),
  ('flat_screen', 6, 'height', 0.9915, 0.06721),
  ('flat_screen', 6, 'length', -0.2157, 0.1865),
  ('flat_screen', 6, 'rectangularity', 0.6963, 0.1013),
  ('flat_screen', 6, 'spread_length', -0.5428, 0.2261),
  ('flat_screen', 6, 'spread_width', -1.034, 0.1395),
  ('flat_screen', 6, 'tilt_deg', 83.45, 10.48),
  ('flat_screen', 6, 'width', -0.7204, 0.1832),
  ('flat_screen', 6, 'z_max', 1.232, 0.1677),
  ('flat_screen', 6, 'z_min', 0.7064, 0.1186);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.07923, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'area_m2', -1.852, 0.3187),
  ('flat_screen', 7, 'aspect', 0.4054, 0.1959),
  ('flat_screen', 7, 'behind', 0.5258, 0.1092),
  ('flat_screen', 7, 'edge_free', 0.8164, 0.1699),
  ('flat_screen', 7, 'edge_free_top', 0.9956, 0.03),
  ('flat_screen', 7, 'edge_joined', 0.02467, 0.03633),
  ('flat_screen', 7, 'height', 1.249, 0.1027),
  ('flat_screen', 7, 'length', -0.6148, 0.2142),
  ('flat_screen', 7, 'rectangularity', 0.8127, 0.1071),
  ('flat_screen', 7, 'spread_length', -0.7557, 0.1848),
  ('flat_screen', 7, 'spread_width', -1.204, 0.1553),
  ('flat_screen', 7, 'tilt_deg', 84.11, 3.4),
  ('flat_screen', 7, 'width', -1.02, 0.1934),
  ('flat_screen', 7, 'z_max', 1.41, 0.1045),
  ('flat_screen', 7, 'z_min', 1.028, 0.1166);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.07422, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'area_m2', -1.977, 0.2071),
  ('flat_screen', 8, 'aspect', 0.3435, 0.1658),
  ('flat_screen', 8, 'behind', 0.6446, 0.07465),
  ('flat_screen', 8, 'edge_free', 0.6837, 0.1571),
  ('flat_screen', 8, 'edge_free_top', 0.9187, 0.1238),
  ('flat_screen', 8, 'edge_joined', 0.01744, 0.03),
  ('flat_screen', 8, 'height', 1.026, 0.0467),
  ('flat_screen', 8, 'length', -0.6535, 0.1308),
  ('flat_screen', 8, 'rectangularity', 0.7299, 0.1077),
  ('flat_screen', 8, 'spread_length', -0.8475, 0.14),
  ('flat_screen', 8, 'spread_width', -1.261, 0.08717),
  ('flat_screen', 8, 'tilt_deg', 84.98, 3.316),
  ('flat_screen', 8, 'width', -0.9969, 0.1508),
  ('flat_screen', 8, 'z_max', 1.178, 0.05189),
  ('flat_screen', 8, 'z_min', 0.7844, 0.05956);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.06804, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'area_m2', -2.556, 0.3798),
  ('flat_screen', 9, 'aspect', 0.5066, 0.3135),
  ('flat_screen', 9, 'behind', 0.5706, 0.2115),
  ('flat_screen', 9, 'edge_free', 0.7784, 0.1712),
  ('flat_screen', 9, 'edge_free_top', 0.9995, 0.03),
  ('flat_screen', 9, 'edge_joined', 0.0558, 0.1135),
  ('flat_screen', 9, 'height', 1.026, 0.05489),
  ('flat_screen', 9, 'length', -0.8485, 0.2706),
  ('flat_screen', 9, 'rectangularity', 0.7156, 0.124),
  ('flat_screen', 9, 'spread_length', -0.9825, 0.229),
  ('flat_screen', 9, 'spread_width', -1.611, 0.2484),
  ('flat_screen', 9, 'tilt_deg', 85.3, 3.077),
  ('flat_screen', 9, 'width', -1.355, 0.2535),
  ('flat_screen', 9, 'z_max', 1.141, 0.05387),
  ('flat_screen', 9, 'z_min', 0.8223, 0.07011);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.01099, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'area_m2', -2.098, 0.2663),
  ('flat_screen', 10, 'aspect', 0.5446, 0.18),
  ('flat_screen', 10, 'behind', 0.524, 0.1593),
  ('flat_screen', 10, 'edge_free', 0.7074, 0.111),
  ('flat_screen', 10, 'edge_free_top', 0.9971, 0.03),
  ('flat_screen', 10, 'edge_joined', 0.1127, 0.1125),
  ('flat_screen', 10, 'height', 0.3871, 0.09134),
  ('flat_screen', 10, 'length', -0.6689, 0.1466),
  ('flat_screen', 10, 'rectangularity', 0.8174, 0.105),
  ('flat_screen', 10, 'spread_length', -0.7939, 0.1083),
  ('flat_screen', 10, 'spread_width', -1.403, 0.1688),
  ('flat_screen', 10, 'tilt_deg', 86.1, 3.351),
  ('flat_screen', 10, 'width', -1.213, 0.2068),
  ('flat_screen', 10, 'z_max', 0.521, 0.09426),
  ('flat_screen', 10, 'z_min', 0.1766, 0.1127);

-- keyboard: 382 examples
UPDATE object_class SET prior = 0.02223 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.711, 0.3853)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7392, 0.3073)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.2444, 0.1628)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.2688, 0.2088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_joined', 0.681, 0.224)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.759, 0.1201)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.8783, 0.2811)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8112, 0.0781)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9701, 0.2776)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.81, 0.1344)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.586, 2.168)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.618, 0.22)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7664, 0.1208)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7524, 0.12)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'keyboard';
DELETE FROM class_density WHERE class = 'keyboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1376, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'area_m2', -2.566, 0.08318),
  ('keyboard', 1, 'aspect', 0.8862, 0.1571),
  ('keyboard', 1, 'behind', 0.2293, 0.1134),
  ('keyboard', 1, 'edge_free', 0.4511, 0.1019),
  ('keyboard', 1, 'edge_free_top', 0, 0.3162),
  ('keyboard', 1, 'edge_joined', 0.521, 0.105),
  ('keyboard', 1, 'height', 0.767, 0.02495),
  ('keyboard', 1, 'length', -0.7363, 0.09634),
  ('keyboard', 1, 'rectangularity', 0.8152, 0.05562),
  ('keyboard', 1, 'spread_length', -0.8238, 0.0768),
  ('keyboard', 1, 'spread_width', -1.792, 0.07911),
  ('keyboard', 1, 'tilt_deg', 4.825, 1.66),
  ('keyboard', 1, 'width', -1.622, 0.09252),
  ('keyboard', 1, 'z_max', 0.7763, 0.02493),
  ('keyboard', 1, 'z_min', 0.7588, 0.02535);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.1343, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'area_m2', -2.733, 0.09662),
  ('keyboard', 2, 'aspect', 1.002, 0.1079),
  ('keyboard', 2, 'behind', 0.2007, 0.1469),
  ('keyboard', 2, 'edge_free', 0.4313, 0.17),
  ('keyboard', 2, 'edge_free_top', 0, 0.3162),
  ('keyboard', 2, 'edge_joined', 0.5338, 0.1619),
  ('keyboard', 2, 'height', 0.7419, 0.06886),
  ('keyboard', 2, 'length', -0.788, 0.05987),
  ('keyboard', 2, 'rectangularity', 0.8591, 0.07127),
  ('keyboard', 2, 'spread_length', -0.8283, 0.06311),
  ('keyboard', 2, 'spread_width', -1.878, 0.07726),
  ('keyboard', 2, 'tilt_deg', 4.835, 1.872),
  ('keyboard', 2, 'width', -1.79, 0.09832),
  ('keyboard', 2, 'z_max', 0.7508, 0.06912),
  ('keyboard', 2, 'z_min', 0.7341, 0.06881);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.1177, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'area_m2', -2.649, 0.1146),
  ('keyboard', 3, 'aspect', 1.002, 0.142),
  ('keyboard', 3, 'behind', 0.2458, 0.1477),
  ('keyboard', 3, 'edge_free', 0.07436, 0.0815),
  ('keyboard', 3, 'edge_free_top', 0, 0.3162),
  ('keyboard', 3, 'edge_joined', 0.8842, 0.1014),
  ('keyboard', 3, 'height', 0.7709, 0.04005),
  ('keyboard', 3, 'length', -0.729, 0.0923),
  ('keyboard', 3, 'rectangularity', 0.8302, 0.06586),
  ('keyboard', 3, 'spread_length', -0.8021, 0.07016),
  ('keyboard', 3, 'spread_width', -1.865, 0.1125),
  ('keyboard', 3, 'tilt_deg', 2.245, 1.128),
  ('keyboard', 3, 'width', -1.731, 0.1063),
  ('keyboard', 3, 'z_max', 0.7756, 0.04029),
  ('keyboard', 3, 'z_min', 0.7669, 0.03978);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.1167, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'area_m2', -2.878, 0.2394),
  ('keyboard', 4, 'aspect', 0.4801, 0.2514),
  ('keyboard', 4, 'behind', 0.2402, 0.1611),
  ('keyboard', 4, 'edge_free', 0.3867, 0.1201),
  ('keyboard', 4, 'edge_free_top', 0, 0.3162),
  ('keyboard', 4, 'edge_joined', 0.5406, 0.1421),
  ('keyboard', 4, 'height', 0.76, 0.04278),
  ('keyboard', 4, 'length', -1.092, 0.1154),
  ('keyboard', 4, 'rectangularity', 0.8108, 0.06967),
  ('keyboard', 4, 'spread_length', -1.188, 0.108),
  ('keyboard', 4, 'spread_width', -1.77, 0.1424),
  ('keyboard', 4, 'tilt_deg', 4.702, 2.006),
  ('keyboard', 4, 'width', -1.572, 0.2348),
  ('keyboard', 4, 'z_max', 0.7697, 0.043),
  ('keyboard', 4, 'z_min', 0.7517, 0.04337);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.1166, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'area_m2', -2.246, 0.1368),
  ('keyboard', 5, 'aspect', 0.7231, 0.1648),
  ('keyboard', 5, 'behind', 0.28, 0.1534),
  ('keyboard', 5, 'edge_free', 0.3612, 0.1458),
  ('keyboard', 5, 'edge_free_top', 0, 0.3162),
  ('keyboard', 5, 'edge_joined', 0.6169, 0.1562),
  ('keyboard', 5, 'height', 0.7514, 0.03949),
  ('keyboard', 5, 'length', -0.6245, 0.1147),
  ('keyboard', 5, 'rectangularity', 0.7621, 0.05233),
  ('keyboard', 5, 'spread_length', -0.7892, 0.1172),
  ('keyboard', 5, 'spread_width', -1.701, 0.09477),
  ('keyboard', 5, 'tilt_deg', 3.387, 1.774),
  ('keyboard', 5, 'width', -1.348, 0.1012),
  ('keyboard', 5, 'z_max', 0.7596, 0.03951),
  ('keyboard', 5, 'z_min', 0.7427, 0.04103);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.09305, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'area_m2', -2.319, 0.2158),
  ('keyboard', 6, 'aspect', 0.7022, 0.1795),
  ('keyboard', 6, 'behind', 0.3122, 0.137),
  ('keyboard', 6, 'edge_free', 0.02772, 0.03433),
  ('keyboard', 6, 'edge_free_top', 0, 0.3162),
  ('keyboard', 6, 'edge_joined', 0.9419, 0.05919),
  ('keyboard', 6, 'height', 0.7365, 0.03455),
  ('keyboard', 6, 'length', -0.6805, 0.1402),
  ('keyboard', 6, 'rectangularity', 0.777, 0.05647),
  ('keyboard', 6, 'spread_length', -0.7949, 0.1206),
  ('keyboard', 6, 'spread_width', -1.698, 0.1124),
  ('keyboard', 6, 'tilt_deg', 1.345, 0.8112),
  ('keyboard', 6, 'width', -1.383, 0.1716),
  ('keyboard', 6, 'z_max', 0.7401, 0.03423),
  ('keyboard', 6, 'z_min', 0.7328, 0.03525);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.0836, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'area_m2', -3.512, 0.28),
  ('keyboard', 7, 'aspect', 0.2552, 0.1757),
  ('keyboard', 7, 'behind', 0.2617, 0.1882),
  ('keyboard', 7, 'edge_free', 0.1939, 0.1525),
  ('keyboard', 7, 'edge_free_top', 0, 0.3162),
  ('keyboard', 7, 'edge_joined', 0.6419, 0.251),
  ('keyboard', 7, 'height', 0.7533, 0.04054),
  ('keyboard', 7, 'length', -1.49, 0.1494),
  ('keyboard', 7, 'rectangularity', 0.7623, 0.07112),
  ('keyboard', 7, 'spread_length', -1.591, 0.1075),
  ('keyboard', 7, 'spread_width', -1.952, 0.1347),
  ('keyboard', 7, 'tilt_deg', 3.702, 2.078),
  ('keyboard', 7, 'width', -1.746, 0.1685),
  ('keyboard', 7, 'z_max', 0.7602, 0.04175),
  ('keyboard', 7, 'z_min', 0.7477, 0.04005);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.08006, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'area_m2', -2.931, 0.1641),
  ('keyboard', 8, 'aspect', 0.5224, 0.1861),
  ('keyboard', 8, 'behind', 0.276, 0.1386),
  ('keyboard', 8, 'edge_free', 0.03931, 0.0474),
  ('keyboard', 8, 'edge_free_top', 0, 0.3162),
  ('keyboard', 8, 'edge_joined', 0.917, 0.09057),
  ('keyboard', 8, 'height', 0.764, 0.04213),
  ('keyboard', 8, 'length', -1.096, 0.09451),
  ('keyboard', 8, 'rectangularity', 0.8088, 0.069),
  ('keyboard', 8, 'spread_length', -1.207, 0.1282),
  ('keyboard', 8, 'spread_width', -1.802, 0.09116),
  ('keyboard', 8, 'tilt_deg', 1.981, 1.126),
  ('keyboard', 8, 'width', -1.618, 0.1669),
  ('keyboard', 8, 'z_max', 0.7681, 0.04255),
  ('keyboard', 8, 'z_min', 0.7602, 0.04216);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.05339, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'area_m2', -2.842, 0.3211),
  ('keyboard', 9, 'aspect', 0.8105, 0.2511),
  ('keyboard', 9, 'behind', 0.1803, 0.2066),
  ('keyboard', 9, 'edge_free', 0.3029, 0.1708),
  ('keyboard', 9, 'edge_free_top', 0, 0.3162),
  ('keyboard', 9, 'edge_joined', 0.6492, 0.1858),
  ('keyboard', 9, 'height', 1.015, 0.08756),
  ('keyboard', 9, 'length', -0.9294, 0.2082),
  ('keyboard', 9, 'rectangularity', 0.8506, 0.1121),
  ('keyboard', 9, 'spread_length', -0.9722, 0.232),
  ('keyboard', 9, 'spread_width', -1.831, 0.1174),
  ('keyboard', 9, 'tilt_deg', 5.026, 2.851),
  ('keyboard', 9, 'width', -1.74, 0.1894),
  ('keyboard', 9, 'z_max', 1.025, 0.08756),
  ('keyboard', 9, 'z_min', 1.006, 0.08921);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.01696, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'area_m2', -2.925, 0.3531),
  ('keyboard', 10, 'aspect', 0.9751, 0.3593),
  ('keyboard', 10, 'behind', 0.1016, 0.09303),
  ('keyboard', 10, 'edge_free', 0.1324, 0.1404),
  ('keyboard', 10, 'edge_free_top', 0, 0.3162),
  ('keyboard', 10, 'edge_joined', 0.8467, 0.137),
  ('keyboard', 10, 'height', 0.1328, 0.08456),
  ('keyboard', 10, 'length', -0.9225, 0.3312),
  ('keyboard', 10, 'rectangularity', 0.9031, 0.04654),
  ('keyboard', 10, 'spread_length', -0.9425, 0.3191),
  ('keyboard', 10, 'spread_width', -1.95, 0.04402),
  ('keyboard', 10, 'tilt_deg', 2.535, 1.233),
  ('keyboard', 10, 'width', -1.898, 0.06984),
  ('keyboard', 10, 'z_max', 0.1382, 0.08486),
  ('keyboard', 10, 'z_min', 0.1277, 0.08436);

-- chair_seat: 468 examples
UPDATE object_class SET prior = 0.02724 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -1.971, 0.488)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.2785, 0.2651)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6664, 0.1571)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.6379, 0.1935)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_joined', 0.06975, 0.09164)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4684, 0.0304)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.6895, 0.1657)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7463, 0.1259)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7563, 0.1603)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.176, 0.3382)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 1.019, 0.9663)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -0.9719, 0.3196)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.473, 0.03066)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4649, 0.0306)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_seat';
DELETE FROM class_density WHERE class = 'chair_seat';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.1674, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'area_m2', -1.608, 0.1109),
  ('chair_seat', 1, 'aspect', 0.1169, 0.07232),
  ('chair_seat', 1, 'behind', 0.6945, 0.07918),
  ('chair_seat', 1, 'edge_free', 0.7944, 0.1172),
  ('chair_seat', 1, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 1, 'edge_joined', 0.03899, 0.05178),
  ('chair_seat', 1, 'height', 0.4408, 0.0225),
  ('chair_seat', 1, 'length', -0.6598, 0.0755),
  ('chair_seat', 1, 'rectangularity', 0.8451, 0.06359),
  ('chair_seat', 1, 'spread_length', -0.7298, 0.06346),
  ('chair_seat', 1, 'spread_width', -0.9176, 0.07963),
  ('chair_seat', 1, 'tilt_deg', 0.6137, 0.45),
  ('chair_seat', 1, 'width', -0.7766, 0.07457),
  ('chair_seat', 1, 'z_max', 0.4442, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4383, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.128, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'area_m2', -1.626, 0.1231),
  ('chair_seat', 2, 'aspect', 0.1341, 0.08377),
  ('chair_seat', 2, 'behind', 0.643, 0.1047),
  ('chair_seat', 2, 'edge_free', 0.838, 0.08787),
  ('chair_seat', 2, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 2, 'edge_joined', 0.01498, 0.03),
  ('chair_seat', 2, 'height', 0.4941, 0.0225),
  ('chair_seat', 2, 'length', -0.6584, 0.07505),
  ('chair_seat', 2, 'rectangularity', 0.8418, 0.05491),
  ('chair_seat', 2, 'spread_length', -0.7353, 0.06393),
  ('chair_seat', 2, 'spread_width', -0.9422, 0.09598),
  ('chair_seat', 2, 'tilt_deg', 0.7259, 0.5795),
  ('chair_seat', 2, 'width', -0.7925, 0.08766),
  ('chair_seat', 2, 'z_max', 0.4981, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4911, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.1074, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'area_m2', -2.05, 0.1843),
  ('chair_seat', 3, 'aspect', 0.1583, 0.1004),
  ('chair_seat', 3, 'behind', 0.6901, 0.07998),
  ('chair_seat', 3, 'edge_free', 0.5584, 0.1277),
  ('chair_seat', 3, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 3, 'edge_joined', 0.0619, 0.07667),
  ('chair_seat', 3, 'height', 0.4989, 0.0225),
  ('chair_seat', 3, 'length', -0.7205, 0.07811),
  ('chair_seat', 3, 'rectangularity', 0.6477, 0.1106),
  ('chair_seat', 3, 'spread_length', -0.7336, 0.1062),
  ('chair_seat', 3, 'spread_width', -1.19, 0.1261),
  ('chair_seat', 3, 'tilt_deg', 0.8521, 0.6371),
  ('chair_seat', 3, 'width', -0.8788, 0.09731),
  ('chair_seat', 3, 'z_max', 0.5029, 0.0225),
  ('chair_seat', 3, 'z_min', 0.4957, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.1043, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'area_m2', -2.068, 0.2417),
  ('chair_seat', 4, 'aspect', 0.2873, 0.1983),
  ('chair_seat', 4, 'behind', 0.7225, 0.1113),
  ('chair_seat', 4, 'edge_free', 0.5879, 0.09271),
  ('chair_seat', 4, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 4, 'edge_joined', 0.01378, 0.03),
  ('chair_seat', 4, 'height', 0.4404, 0.0225),
  ('chair_seat', 4, 'length', -0.6575, 0.1338),
  ('chair_seat', 4, 'rectangularity', 0.6416, 0.1261),
  ('chair_seat', 4, 'spread_length', -0.7097, 0.09024),
  ('chair_seat', 4, 'spread_width', -1.237, 0.1465),
  ('chair_seat', 4, 'tilt_deg', 0.8174, 0.6972),
  ('chair_seat', 4, 'width', -0.9448, 0.1441),
  ('chair_seat', 4, 'z_max', 0.4442, 0.0225),
  ('chair_seat', 4, 'z_min', 0.4374, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.09457, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'area_m2', -1.674, 0.1173),
  ('chair_seat', 5, 'aspect', 0.1296, 0.1022),
  ('chair_seat', 5, 'behind', 0.6769, 0.1046),
  ('chair_seat', 5, 'edge_free', 0.5885, 0.1308),
  ('chair_seat', 5, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 5, 'edge_joined', 0.191, 0.1077),
  ('chair_seat', 5, 'height', 0.4822, 0.0225),
  ('chair_seat', 5, 'length', -0.6728, 0.07028),
  ('chair_seat', 5, 'rectangularity', 0.8235, 0.0696),
  ('chair_seat', 5, 'spread_length', -0.6953, 0.06814),
  ('chair_seat', 5, 'spread_width', -0.9486, 0.09431),
  ('chair_seat', 5, 'tilt_deg', 0.7996, 0.5193),
  ('chair_seat', 5, 'width', -0.8024, 0.07582),
  ('chair_seat', 5, 'z_max', 0.4866, 0.0225),
  ('chair_seat', 5, 'z_min', 0.479, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.09042, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'area_m2', -2.424, 0.1882),
  ('chair_seat', 6, 'aspect', 0.6911, 0.1521),
  ('chair_seat', 6, 'behind', 0.6515, 0.1511),
  ('chair_seat', 6, 'edge_free', 0.5168, 0.1912),
  ('chair_seat', 6, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 6, 'edge_joined', 0.05314, 0.07527),
  ('chair_seat', 6, 'height', 0.4787, 0.0225),
  ('chair_seat', 6, 'length', -0.6864, 0.1069),
  ('chair_seat', 6, 'rectangularity', 0.71, 0.1258),
  ('chair_seat', 6, 'spread_length', -0.7439, 0.105),
  ('chair_seat', 6, 'spread_width', -1.598, 0.1281),
  ('chair_seat', 6, 'tilt_deg', 1.019, 0.653),
  ('chair_seat', 6, 'width', -1.377, 0.1428),
  ('chair_seat', 6, 'z_max', 0.4826, 0.0225),
  ('chair_seat', 6, 'z_min', 0.4753, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.08938, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'area_m2', -3.053, 0.3881),
  ('chair_seat', 7, 'aspect', 0.6961, 0.3305),
  ('chair_seat', 7, 'behind', 0.575, 0.2859),
  ('chair_seat', 7, 'edge_free', 0.4907, 0.2027),
  ('chair_seat', 7, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 7, 'edge_joined', 0.07837, 0.09618),
  ('chair_seat', 7, 'height', 0.4668, 0.03367),
  ('chair_seat', 7, 'length', -0.9871, 0.2899),
  ('chair_seat', 7, 'rectangularity', 0.6913, 0.107),
  ('chair_seat', 7, 'spread_length', -1.095, 0.3103),
  ('chair_seat', 7, 'spread_width', -1.884, 0.2052),
  ('chair_seat', 7, 'tilt_deg', 2.652, 2.134),
  ('chair_seat', 7, 'width', -1.683, 0.2188),
  ('chair_seat', 7, 'z_max', 0.4731, 0.03368),
  ('chair_seat', 7, 'z_min', 0.4614, 0.03484);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.07551, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'area_m2', -1.532, 0.1366),
  ('chair_seat', 8, 'aspect', 0.2985, 0.1558),
  ('chair_seat', 8, 'behind', 0.7046, 0.07608),
  ('chair_seat', 8, 'edge_free', 0.6772, 0.1228),
  ('chair_seat', 8, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 8, 'edge_joined', 0.08171, 0.07983),
  ('chair_seat', 8, 'height', 0.4715, 0.02735),
  ('chair_seat', 8, 'length', -0.4357, 0.08855),
  ('chair_seat', 8, 'rectangularity', 0.7022, 0.08188),
  ('chair_seat', 8, 'spread_length', -0.6245, 0.06493),
  ('chair_seat', 8, 'spread_width', -0.9606, 0.1275),
  ('chair_seat', 8, 'tilt_deg', 1.051, 0.8063),
  ('chair_seat', 8, 'width', -0.7342, 0.1228),
  ('chair_seat', 8, 'z_max', 0.4783, 0.02823),
  ('chair_seat', 8, 'z_min', 0.4668, 0.02765);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.07541, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'area_m2', -2.024, 0.2035),
  ('chair_seat', 9, 'aspect', 0.2034, 0.1468),
  ('chair_seat', 9, 'behind', 0.7084, 0.08331),
  ('chair_seat', 9, 'edge_free', 0.4572, 0.1284),
  ('chair_seat', 9, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 9, 'edge_joined', 0.1902, 0.08863),
  ('chair_seat', 9, 'height', 0.4504, 0.0225),
  ('chair_seat', 9, 'length', -0.7359, 0.1383),
  ('chair_seat', 9, 'rectangularity', 0.7134, 0.1001),
  ('chair_seat', 9, 'spread_length', -0.7739, 0.1332),
  ('chair_seat', 9, 'spread_width', -1.129, 0.1284),
  ('chair_seat', 9, 'tilt_deg', 1.588, 1.244),
  ('chair_seat', 9, 'width', -0.9393, 0.1237),
  ('chair_seat', 9, 'z_max', 0.4578, 0.0225),
  ('chair_seat', 9, 'z_min', 0.4452, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 10, 0.01755, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 10, 'area_m2', -2.414, 0.2388),
  ('chair_seat', 10, 'aspect', 0.4273, 0.1052),
  ('chair_seat', 10, 'behind', 0.241, 0.2262),
  ('chair_seat', 10, 'edge_free', 0.6779, 0.2239),
  ('chair_seat', 10, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 10, 'edge_joined', 0.02314, 0.03),
  ('chair_seat', 10, 'height', 0.4062, 0.2139),
  ('chair_seat', 10, 'length', -0.8166, 0.07558),
  ('chair_seat', 10, 'rectangularity', 0.706, 0.05526),
  ('chair_seat', 10, 'spread_length', -0.884, 0.1362),
  ('chair_seat', 10, 'spread_width', -1.476, 0.1563),
  ('chair_seat', 10, 'tilt_deg', 1.001, 0.8009),
  ('chair_seat', 10, 'width', -1.244, 0.1342),
  ('chair_seat', 10, 'z_max', 0.4102, 0.2151),
  ('chair_seat', 10, 'z_min', 0.4027, 0.2131);

-- chair_back: 471 examples
UPDATE object_class SET prior = 0.02742 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.687, 0.5469)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3776, 0.2612)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.5754, 0.2835)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.8105, 0.1794)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9542, 0.1524)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_joined', 0.0944, 0.129)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8143, 0.07995)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5185, 0.2707)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7755, 0.1214)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6826, 0.2294)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.11, 0.356)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.52, 3.778)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.8996, 0.302)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.025, 0.08957)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4334, 0.1662)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_back';
DELETE FROM class_density WHERE class = 'chair_back';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1233, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'area_m2', -1.653, 0.2043),
  ('chair_back', 1, 'aspect', 0.6186, 0.1547),
  ('chair_back', 1, 'behind', 0.6392, 0.2235),
  ('chair_back', 1, 'edge_free', 0.8291, 0.08777),
  ('chair_back', 1, 'edge_free_top', 0.9927, 0.03),
  ('chair_back', 1, 'edge_joined', 0.1151, 0.07901),
  ('chair_back', 1, 'height', 0.8414, 0.06207),
  ('chair_back', 1, 'length', -0.3603, 0.09959),
  ('chair_back', 1, 'rectangularity', 0.7366, 0.08933),
  ('chair_back', 1, 'spread_length', -0.5562, 0.1099),
  ('chair_back', 1, 'spread_width', -1.276, 0.1819),
  ('chair_back', 1, 'tilt_deg', 80.26, 3.252),
  ('chair_back', 1, 'width', -0.9789, 0.1559),
  ('chair_back', 1, 'z_max', 1.087, 0.06304),
  ('chair_back', 1, 'z_min', 0.4196, 0.06441);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.1209, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'area_m2', -1.592, 0.1777),
  ('chair_back', 2, 'aspect', 0.1417, 0.08668),
  ('chair_back', 2, 'behind', 0.4568, 0.3167),
  ('chair_back', 2, 'edge_free', 0.8686, 0.11),
  ('chair_back', 2, 'edge_free_top', 0.9992, 0.03),
  ('chair_back', 2, 'edge_joined', 0.06631, 0.08832),
  ('chair_back', 2, 'height', 0.8428, 0.06348),
  ('chair_back', 2, 'length', -0.6549, 0.09419),
  ('chair_back', 2, 'rectangularity', 0.8712, 0.05876),
  ('chair_back', 2, 'spread_length', -0.7397, 0.06928),
  ('chair_back', 2, 'spread_width', -0.9097, 0.131),
  ('chair_back', 2, 'tilt_deg', 82.38, 3.694),
  ('chair_back', 2, 'width', -0.7966, 0.08936),
  ('chair_back', 2, 'z_max', 1.036, 0.07958),
  ('chair_back', 2, 'z_min', 0.5394, 0.07913);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.1192, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'area_m2', -1.22, 0.1738),
  ('chair_back', 3, 'aspect', 0.4154, 0.1422),
  ('chair_back', 3, 'behind', 0.5371, 0.2797),
  ('chair_back', 3, 'edge_free', 0.9882, 0.03),
  ('chair_back', 3, 'edge_free_top', 0.9991, 0.03),
  ('chair_back', 3, 'edge_joined', 0.007933, 0.03),
  ('chair_back', 3, 'height', 0.8208, 0.05191),
  ('chair_back', 3, 'length', -0.3207, 0.1014),
  ('chair_back', 3, 'rectangularity', 0.8536, 0.07605),
  ('chair_back', 3, 'spread_length', -0.5148, 0.09921),
  ('chair_back', 3, 'spread_width', -0.8752, 0.1443),
  ('chair_back', 3, 'tilt_deg', 80.82, 3.839),
  ('chair_back', 3, 'width', -0.7361, 0.1141),
  ('chair_back', 3, 'z_max', 1.06, 0.05719),
  ('chair_back', 3, 'z_min', 0.3446, 0.05315);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.1111, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'area_m2', -1.291, 0.1337),
  ('chair_back', 4, 'aspect', 0.2435, 0.1226),
  ('chair_back', 4, 'behind', 0.7393, 0.0873),
  ('chair_back', 4, 'edge_free', 0.7203, 0.1358),
  ('chair_back', 4, 'edge_free_top', 0.9863, 0.0351),
  ('chair_back', 4, 'edge_joined', 0.177, 0.1474),
  ('chair_back', 4, 'height', 0.8283, 0.0496),
  ('chair_back', 4, 'length', -0.4177, 0.08857),
  ('chair_back', 4, 'rectangularity', 0.8119, 0.06487),
  ('chair_back', 4, 'spread_length', -0.5928, 0.0929),
  ('chair_back', 4, 'spread_width', -0.8083, 0.09843),
  ('chair_back', 4, 'tilt_deg', 78.34, 3.03),
  ('chair_back', 4, 'width', -0.6612, 0.08922),
  ('chair_back', 4, 'z_max', 1.062, 0.05501),
  ('chair_back', 4, 'z_min', 0.4188, 0.04922);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.1, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'area_m2', -2.012, 0.1987),
  ('chair_back', 5, 'aspect', 0.3413, 0.1666),
  ('chair_back', 5, 'behind', 0.6818, 0.132),
  ('chair_back', 5, 'edge_free', 0.7474, 0.1431),
  ('chair_back', 5, 'edge_free_top', 0.9951, 0.03),
  ('chair_back', 5, 'edge_joined', 0.07164, 0.08448),
  ('chair_back', 5, 'height', 0.7999, 0.0741),
  ('chair_back', 5, 'length', -0.704, 0.1358),
  ('chair_back', 5, 'rectangularity', 0.7756, 0.09508),
  ('chair_back', 5, 'spread_length', -0.8241, 0.1326),
  ('chair_back', 5, 'spread_width', -1.277, 0.1603),
  ('chair_back', 5, 'tilt_deg', 80.5, 3.671),
  ('chair_back', 5, 'width', -1.045, 0.1389),
  ('chair_back', 5, 'z_max', 0.9803, 0.08168),
  ('chair_back', 5, 'z_min', 0.5178, 0.1078);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.09494, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'area_m2', -1.45, 0.1324),
  ('chair_back', 6, 'aspect', 0.1312, 0.08279),
  ('chair_back', 6, 'behind', 0.7005, 0.1257),
  ('chair_back', 6, 'edge_free', 0.9069, 0.0947),
  ('chair_back', 6, 'edge_free_top', 0.9958, 0.03),
  ('chair_back', 6, 'edge_joined', 0.04204, 0.05919),
  ('chair_back', 6, 'height', 0.7252, 0.03806),
  ('chair_back', 6, 'length', -0.5721, 0.0767),
  ('chair_back', 6, 'rectangularity', 0.8444, 0.0838),
  ('chair_back', 6, 'spread_length', -0.7007, 0.07584),
  ('chair_back', 6, 'spread_width', -0.8749, 0.1373),
  ('chair_back', 6, 'tilt_deg', 80.12, 3.184),
  ('chair_back', 6, 'width', -0.7033, 0.08195),
  ('chair_back', 6, 'z_max', 0.9243, 0.04251),
  ('chair_back', 6, 'z_min', 0.3758, 0.0462);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.07616, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'area_m2', -1.771, 0.3126),
  ('chair_back', 7, 'aspect', 0.3298, 0.2026),
  ('chair_back', 7, 'behind', 0.5389, 0.2913),
  ('chair_back', 7, 'edge_free', 0.5328, 0.1239),
  ('chair_back', 7, 'edge_free_top', 0.732, 0.2537),
  ('chair_back', 7, 'edge_joined', 0.2443, 0.1986),
  ('chair_back', 7, 'height', 0.7932, 0.0614),
  ('chair_back', 7, 'length', -0.549, 0.1809),
  ('chair_back', 7, 'rectangularity', 0.725, 0.1346),
  ('chair_back', 7, 'spread_length', -0.665, 0.1573),
  ('chair_back', 7, 'spread_width', -1.175, 0.2648),
  ('chair_back', 7, 'tilt_deg', 80.02, 3.734),
  ('chair_back', 7, 'width', -0.8788, 0.1942),
  ('chair_back', 7, 'z_max', 1.014, 0.08474),
  ('chair_back', 7, 'z_min', 0.4678, 0.09053);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.07215, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'area_m2', -2.758, 0.3386),
  ('chair_back', 8, 'aspect', 0.6406, 0.3317),
  ('chair_back', 8, 'behind', 0.4171, 0.3239),
  ('chair_back', 8, 'edge_free', 0.5928, 0.2013),
  ('chair_back', 8, 'edge_free_top', 0.7364, 0.349),
  ('chair_back', 8, 'edge_joined', 0.162, 0.1979),
  ('chair_back', 8, 'height', 0.7528, 0.223),
  ('chair_back', 8, 'length', -0.8867, 0.2467),
  ('chair_back', 8, 'rectangularity', 0.7229, 0.1259),
  ('chair_back', 8, 'spread_length', -0.9802, 0.2547),
  ('chair_back', 8, 'spread_width', -1.785, 0.2278),
  ('chair_back', 8, 'tilt_deg', 80.34, 3.85),
  ('chair_back', 8, 'width', -1.527, 0.2438),
  ('chair_back', 8, 'z_max', 0.9288, 0.2373),
  ('chair_back', 8, 'z_min', 0.5252, 0.2175);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.07109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'area_m2', -1.147, 0.2204),
  ('chair_back', 9, 'aspect', 0.6419, 0.2039),
  ('chair_back', 9, 'behind', 0.6448, 0.1992),
  ('chair_back', 9, 'edge_free', 0.8325, 0.09562),
  ('chair_back', 9, 'edge_free_top', 0.9713, 0.0514),
  ('chair_back', 9, 'edge_joined', 0.09027, 0.07849),
  ('chair_back', 9, 'height', 0.7642, 0.07797),
  ('chair_back', 9, 'length', -0.0064, 0.1341),
  ('chair_back', 9, 'rectangularity', 0.6188, 0.08916),
  ('chair_back', 9, 'spread_length', -0.3896, 0.1507),
  ('chair_back', 9, 'spread_width', -0.9053, 0.1843),
  ('chair_back', 9, 'tilt_deg', 81.87, 3.345),
  ('chair_back', 9, 'width', -0.6483, 0.1564),
  ('chair_back', 9, 'z_max', 1.011, 0.09032),
  ('chair_back', 9, 'z_min', 0.05946, 0.09256);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 10, 0.0612, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 10, 'area_m2', -2.693, 0.4573),
  ('chair_back', 10, 'aspect', 0.4294, 0.2902),
  ('chair_back', 10, 'behind', 0.2436, 0.3096),
  ('chair_back', 10, 'edge_free', 0.9923, 0.03),
  ('chair_back', 10, 'edge_free_top', 0.995, 0.03),
  ('chair_back', 10, 'edge_joined', 0.004554, 0.03),
  ('chair_back', 10, 'height', 0.9285, 0.0777),
  ('chair_back', 10, 'length', -0.9037, 0.2251),
  ('chair_back', 10, 'rectangularity', 0.6396, 0.08211),
  ('chair_back', 10, 'spread_length', -1.086, 0.2532),
  ('chair_back', 10, 'spread_width', -1.621, 0.2746),
  ('chair_back', 10, 'tilt_deg', 80.56, 3.693),
  ('chair_back', 10, 'width', -1.333, 0.2893),
  ('chair_back', 10, 'z_max', 1.046, 0.07577),
  ('chair_back', 10, 'z_min', 0.6787, 0.08457);

-- door: 307 examples
UPDATE object_class SET prior = 0.01785 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.221, 0.623)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.8021, 0.2953)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.1625, 0.2515)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.1454, 0.2388)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.2329, 0.3749)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_joined', 0.3631, 0.3402)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.133, 0.2025)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.6279, 0.2875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8092, 0.1294)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4667, 0.3117)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.3176, 0.3965)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.26, 2.857)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1801, 0.3464)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.028, 0.3129)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1203, 0.2727)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'door';
DELETE FROM class_density WHERE class = 'door';
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.2046, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'area_m2', 0.5439, 0.1053),
  ('door', 1, 'aspect', 0.7935, 0.09684),
  ('door', 1, 'behind', 0.002382, 0.03),
  ('door', 1, 'edge_free', 0.002144, 0.03),
  ('door', 1, 'edge_free_top', 0.003411, 0.03),
  ('door', 1, 'edge_joined', 0.1469, 0.1696),
  ('door', 1, 'height', 1.101, 0.07088),
  ('door', 1, 'length', 0.7203, 0.03454),
  ('door', 1, 'rectangularity', 0.9048, 0.06559),
  ('door', 1, 'spread_length', 0.6302, 0.0888),
  ('door', 1, 'spread_width', -0.153, 0.08044),
  ('door', 1, 'tilt_deg', 89.97, 0.45),
  ('door', 1, 'width', -0.07319, 0.09317),
  ('door', 1, 'z_max', 2.058, 0.04851),
  ('door', 1, 'z_min', 0.003568, 0.02288);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1642, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'area_m2', 0.5485, 0.1251),
  ('door', 2, 'aspect', 0.8223, 0.09375),
  ('door', 2, 'behind', 0.5005, 0.1361),
  ('door', 2, 'edge_free', 0.4618, 0.1898),
  ('door', 2, 'edge_free_top', 0.8459, 0.1428),
  ('door', 2, 'edge_joined', 0.2429, 0.2699),
  ('door', 2, 'height', 1.114, 0.08625),
  ('door', 2, 'length', 0.7903, 0.05339),
  ('door', 2, 'rectangularity', 0.8138, 0.06418),
  ('door', 2, 'spread_length', 0.6082, 0.1264),
  ('door', 2, 'spread_width', -0.1493, 0.1125),
  ('door', 2, 'tilt_deg', 89.97, 0.45),
  ('door', 2, 'width', -0.03206, 0.09231),
  ('door', 2, 'z_max', 2.191, 0.1042),
  ('door', 2, 'z_min', -0.008721, 0.02547);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.1357, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'area_m2', 0.555, 0.09604),
  ('door', 3, 'aspect', 0.792, 0.05838),
  ('door', 3, 'behind', 0.003592, 0.03),
  ('door', 3, 'edge_free', 0.003233, 0.03),
  ('door', 3, 'edge_free_top', 0.005143, 0.03442),
  ('door', 3, 'edge_joined', 0.7895, 0.08055),
  ('door', 3, 'height', 1.085, 0.08034),
  ('door', 3, 'length', 0.7163, 0.04016),
  ('door', 3, 'rectangularity', 0.9195, 0.04262),
  ('door', 3, 'spread_length', 0.6094, 0.08243),
  ('door', 3, 'spread_width', -0.1556, 0.06537),
  ('door', 3, 'tilt_deg', 89.97, 0.45),
  ('door', 3, 'width', -0.07575, 0.05764),
  ('door', 3, 'z_max', 2.041, 0.06277),
  ('door', 3, 'z_min', -0.007291, 0.02831);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.1242, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'area_m2', 0.2325, 0.1479),
  ('door', 4, 'aspect', 0.8366, 0.1562),
  ('door', 4, 'behind', 0.003925, 0.03),
  ('door', 4, 'edge_free', 0.004544, 0.03),
  ('door', 4, 'edge_free_top', 0.005622, 0.03592),
  ('door', 4, 'edge_joined', 0.4121, 0.3061),
  ('door', 4, 'height', 1.24, 0.1012),
  ('door', 4, 'length', 0.6624, 0.09016),
  ('door', 4, 'rectangularity', 0.7826, 0.1068),
  ('door', 4, 'spread_length', 0.4486, 0.1658),
  ('door', 4, 'spread_width', -0.301, 0.1562),
  ('door', 4, 'tilt_deg', 89.95, 0.45),
  ('door', 4, 'width', -0.1742, 0.1268),
  ('door', 4, 'z_max', 2.055, 0.05031),
  ('door', 4, 'z_min', 0.111, 0.1456);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.07438, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'area_m2', -0.1268, 0.3292),
  ('door', 5, 'aspect', 1.083, 0.427),
  ('door', 5, 'behind', 0.2143, 0.1544),
  ('door', 5, 'edge_free', 0.291, 0.2138),
  ('door', 5, 'edge_free_top', 0.3276, 0.3599),
  ('door', 5, 'edge_joined', 0.08977, 0.1058),
  ('door', 5, 'height', 1.02, 0.2043),
  ('door', 5, 'length', 0.6712, 0.1967),
  ('door', 5, 'rectangularity', 0.6949, 0.1311),
  ('door', 5, 'spread_length', 0.5768, 0.1861),
  ('door', 5, 'spread_width', -0.8113, 0.3953),
  ('door', 5, 'tilt_deg', 81.77, 6.584),
  ('door', 5, 'width', -0.4121, 0.3312),
  ('door', 5, 'z_max', 1.841, 0.388),
  ('door', 5, 'z_min', 0.05595, 0.147);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.05996, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'area_m2', -0.1321, 0.1966),
  ('door', 6, 'aspect', 0.4031, 0.1608),
  ('door', 6, 'behind', 0.114, 0.2371),
  ('door', 6, 'edge_free', 0.01523, 0.03746),
  ('door', 6, 'edge_free_top', 0.03019, 0.07192),
  ('door', 6, 'edge_joined', 0.5946, 0.3326),
  ('door', 6, 'height', 1.417, 0.107),
  ('door', 6, 'length', 0.3175, 0.1352),
  ('door', 6, 'rectangularity', 0.7094, 0.1305),
  ('door', 6, 'spread_length', 0.04457, 0.1609),
  ('door', 6, 'spread_width', -0.2844, 0.1223),
  ('door', 6, 'tilt_deg', 89.77, 0.6607),
  ('door', 6, 'width', -0.08567, 0.1126),
  ('door', 6, 'z_max', 2.076, 0.1354),
  ('door', 6, 'z_min', 0.6691, 0.2339);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.04837, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'area_m2', 0.7279, 0.2512),
  ('door', 7, 'aspect', 0.6449, 0.2097),
  ('door', 7, 'behind', 0.3387, 0.2977),
  ('door', 7, 'edge_free', 0.1482, 0.178),
  ('door', 7, 'edge_free_top', 0.2764, 0.2495),
  ('door', 7, 'edge_joined', 0.6297, 0.2653),
  ('door', 7, 'height', 1.125, 0.1047),
  ('door', 7, 'length', 0.8823, 0.1348),
  ('door', 7, 'rectangularity', 0.6843, 0.09377),
  ('door', 7, 'spread_length', 0.606, 0.1976),
  ('door', 7, 'spread_width', 0.09487, 0.1849),
  ('door', 7, 'tilt_deg', 89.86, 0.4715),
  ('door', 7, 'width', 0.2374, 0.241),
  ('door', 7, 'z_max', 2.344, 0.2794),
  ('door', 7, 'z_min', -0.002947, 0.04394);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.04821, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'area_m2', 0.04116, 0.1808),
  ('door', 8, 'aspect', 0.6039, 0.2005),
  ('door', 8, 'behind', 0.513, 0.1593),
  ('door', 8, 'edge_free', 0.4859, 0.2299),
  ('door', 8, 'edge_free_top', 0.7148, 0.1878),
  ('door', 8, 'edge_joined', 0.2801, 0.2637),
  ('door', 8, 'height', 1.35, 0.1008),
  ('door', 8, 'length', 0.5111, 0.188),
  ('door', 8, 'rectangularity', 0.6992, 0.1156),
  ('door', 8, 'spread_length', 0.159, 0.1661),
  ('door', 8, 'spread_width', -0.2056, 0.1299),
  ('door', 8, 'tilt_deg', 89.71, 0.9042),
  ('door', 8, 'width', -0.09276, 0.08734),
  ('door', 8, 'z_max', 2.189, 0.222),
  ('door', 8, 'z_min', 0.4881, 0.2592);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.04527, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'area_m2', -1.378, 0.9301),
  ('door', 9, 'aspect', 1.367, 0.4889),
  ('door', 9, 'behind', 0.01077, 0.03855),
  ('door', 9, 'edge_free', 0.08127, 0.2353),
  ('door', 9, 'edge_free_top', 0.01948, 0.06344),
  ('door', 9, 'edge_joined', 0.3552, 0.3323),
  ('door', 9, 'height', 1.244, 0.1704),
  ('door', 9, 'length', 0.1671, 0.6074),
  ('door', 9, 'rectangularity', 0.7204, 0.1203),
  ('door', 9, 'spread_length', 0.013, 0.5895),
  ('door', 9, 'spread_width', -1.413, 0.3772),
  ('door', 9, 'tilt_deg', 89.77, 0.6049),
  ('door', 9, 'width', -1.2, 0.3938),
  ('door', 9, 'z_max', 1.932, 0.237),
  ('door', 9, 'z_min', 0.5359, 0.4192);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.04513, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'area_m2', -1.227, 0.5665),
  ('door', 10, 'aspect', 0.6187, 0.3486),
  ('door', 10, 'behind', 0.1442, 0.2136),
  ('door', 10, 'edge_free', 0.1034, 0.1283),
  ('door', 10, 'edge_free_top', 0.1098, 0.1639),
  ('door', 10, 'edge_joined', 0.313, 0.1713),
  ('door', 10, 'height', 0.6562, 0.3801),
  ('door', 10, 'length', -0.1553, 0.2638),
  ('door', 10, 'rectangularity', 0.7523, 0.1037),
  ('door', 10, 'spread_length', -0.2291, 0.2543),
  ('door', 10, 'spread_width', -0.9537, 0.3429),
  ('door', 10, 'tilt_deg', 88.76, 1.442),
  ('door', 10, 'width', -0.774, 0.3499),
  ('door', 10, 'z_max', 1.038, 0.406),
  ('door', 10, 'z_min', 0.2383, 0.3644);

-- window: 662 examples
UPDATE object_class SET prior = 0.03845 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', -0.348, 0.8022)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.4568, 0.397)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.08282, 0.1555)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.07341, 0.2033)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_joined', 0.3847, 0.3537)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.494, 0.2151)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.1764, 0.3436)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8013, 0.1432)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.1564, 0.3859)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.4002, 0.5755)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.68, 0.5706)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.2846, 0.4887)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.029, 0.2797)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 1.026, 0.2268)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'window';
DELETE FROM class_density WHERE class = 'window';
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.1964, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'area_m2', -0.2283, 0.2878),
  ('window', 1, 'aspect', 0.3076, 0.1967),
  ('window', 1, 'behind', 1.813e-05, 0.03),
  ('window', 1, 'edge_free', 0.006351, 0.03),
  ('window', 1, 'edge_free_top', 0.002074, 0.03),
  ('window', 1, 'edge_joined', 0.5337, 0.3579),
  ('window', 1, 'height', 1.436, 0.1368),
  ('window', 1, 'length', 0.163, 0.154),
  ('window', 1, 'rectangularity', 0.7998, 0.1479),
  ('window', 1, 'spread_length', 0.1401, 0.2046),
  ('window', 1, 'spread_width', -0.2764, 0.1821),
  ('window', 1, 'tilt_deg', 89.74, 0.45),
  ('window', 1, 'width', -0.1446, 0.1684),
  ('window', 1, 'z_max', 2.023, 0.1705),
  ('window', 1, 'z_min', 0.9619, 0.08443);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1926, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'area_m2', 0.3186, 0.2657),
  ('window', 2, 'aspect', 0.1928, 0.1303),
  ('window', 2, 'behind', 1.847e-05, 0.03),
  ('window', 2, 'edge_free', 0.001115, 0.03),
  ('window', 2, 'edge_free_top', 0.0009658, 0.03),
  ('window', 2, 'edge_joined', 0.04254, 0.06884),
  ('window', 2, 'height', 1.534, 0.1094),
  ('window', 2, 'length', 0.3395, 0.1112),
  ('window', 2, 'rectangularity', 0.8634, 0.146),
  ('window', 2, 'spread_length', 0.4571, 0.1123),
  ('window', 2, 'spread_width', 0.2097, 0.1412),
  ('window', 2, 'tilt_deg', 89.84, 0.45),
  ('window', 2, 'width', 0.1467, 0.1212),
  ('window', 2, 'z_max', 2.188, 0.1299),
  ('window', 2, 'z_min', 0.9005, 0.056);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.1264, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'area_m2', -1.156, 0.4537),
  ('window', 3, 'aspect', 0.8128, 0.4325),
  ('window', 3, 'behind', 2.813e-05, 0.03),
  ('window', 3, 'edge_free', 0.004366, 0.03),
  ('window', 3, 'edge_free_top', 0.002654, 0.03),
  ('window', 3, 'edge_joined', 0.5561, 0.362),
  ('window', 3, 'height', 1.365, 0.1409),
  ('window', 3, 'length', -0.01158, 0.1979),
  ('window', 3, 'rectangularity', 0.7406, 0.1286),
  ('window', 3, 'spread_length', -0.09428, 0.2291),
  ('window', 3, 'spread_width', -1.039, 0.4095),
  ('window', 3, 'tilt_deg', 89.65, 0.45),
  ('window', 3, 'width', -0.8244, 0.3522),
  ('window', 3, 'z_max', 1.85, 0.2516),
  ('window', 3, 'z_min', 0.9551, 0.08321);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.1021, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'area_m2', 0.1958, 0.1954),
  ('window', 4, 'aspect', 0.2312, 0.1551),
  ('window', 4, 'behind', 3.493e-05, 0.03),
  ('window', 4, 'edge_free', 0.1231, 0.1104),
  ('window', 4, 'edge_free_top', 0.03815, 0.06459),
  ('window', 4, 'edge_joined', 0.498, 0.3587),
  ('window', 4, 'height', 1.571, 0.1399),
  ('window', 4, 'length', 0.2998, 0.1115),
  ('window', 4, 'rectangularity', 0.8479, 0.09361),
  ('window', 4, 'spread_length', 0.2373, 0.1493),
  ('window', 4, 'spread_width', -0.07595, 0.1553),
  ('window', 4, 'tilt_deg', 89.83, 0.45),
  ('window', 4, 'width', 0.06855, 0.1281),
  ('window', 4, 'z_max', 2.199, 0.1354),
  ('window', 4, 'z_min', 1.015, 0.143);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.09852, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'area_m2', -0.4684, 0.3735),
  ('window', 5, 'aspect', 0.3596, 0.2635),
  ('window', 5, 'behind', 0.0003379, 0.03),
  ('window', 5, 'edge_free', 0.3655, 0.2244),
  ('window', 5, 'edge_free_top', 0.4613, 0.3232),
  ('window', 5, 'edge_joined', 0.3853, 0.2455),
  ('window', 5, 'height', 1.454, 0.1516),
  ('window', 5, 'length', 0.09658, 0.1888),
  ('window', 5, 'rectangularity', 0.7618, 0.1505),
  ('window', 5, 'spread_length', 0.05025, 0.2109),
  ('window', 5, 'spread_width', -0.4164, 0.2566),
  ('window', 5, 'tilt_deg', 89.76, 0.45),
  ('window', 5, 'width', -0.263, 0.2471),
  ('window', 5, 'z_max', 1.992, 0.1857),
  ('window', 5, 'z_min', 0.9918, 0.1138);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.09787, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'area_m2', -0.568, 0.3867),
  ('window', 6, 'aspect', 0.5653, 0.2854),
  ('window', 6, 'behind', 4.047e-05, 0.03),
  ('window', 6, 'edge_free', 0.1576, 0.1143),
  ('window', 6, 'edge_free_top', 0.01161, 0.03766),
  ('window', 6, 'edge_joined', 0.4355, 0.2982),
  ('window', 6, 'height', 1.81, 0.1264),
  ('window', 6, 'length', 0.096, 0.2459),
  ('window', 6, 'rectangularity', 0.8272, 0.07726),
  ('window', 6, 'spread_length', 0.003072, 0.2669),
  ('window', 6, 'spread_width', -0.6352, 0.2282),
  ('window', 6, 'tilt_deg', 89.86, 0.45),
  ('window', 6, 'width', -0.4693, 0.2091),
  ('window', 6, 'z_max', 2.164, 0.1379),
  ('window', 6, 'z_min', 1.485, 0.156);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.04599, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'area_m2', -2.269, 0.5874),
  ('window', 7, 'aspect', 0.4916, 0.3306),
  ('window', 7, 'behind', 7.733e-05, 0.03),
  ('window', 7, 'edge_free', 0.1279, 0.2033),
  ('window', 7, 'edge_free_top', 0.2074, 0.3258),
  ('window', 7, 'edge_joined', 0.5524, 0.3272),
  ('window', 7, 'height', 1.455, 0.3616),
  ('window', 7, 'length', -0.6938, 0.2929),
  ('window', 7, 'rectangularity', 0.6891, 0.1094),
  ('window', 7, 'spread_length', -0.7927, 0.3583),
  ('window', 7, 'spread_width', -1.443, 0.4106),
  ('window', 7, 'tilt_deg', 88.69, 1.756),
  ('window', 7, 'width', -1.185, 0.3783),
  ('window', 7, 'z_max', 1.694, 0.3663),
  ('window', 7, 'z_min', 1.258, 0.3553);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.03714, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'area_m2', -1.062, 0.5204),
  ('window', 8, 'aspect', 1.273, 0.3579),
  ('window', 8, 'behind', 9.576e-05, 0.03),
  ('window', 8, 'edge_free', 0.07132, 0.09749),
  ('window', 8, 'edge_free_top', 0.1729, 0.2327),
  ('window', 8, 'edge_joined', 0.3186, 0.1294),
  ('window', 8, 'height', 1.062, 0.06574),
  ('window', 8, 'length', 0.2102, 0.1667),
  ('window', 8, 'rectangularity', 0.8206, 0.1083),
  ('window', 8, 'spread_length', 0.2324, 0.1569),
  ('window', 8, 'spread_width', -1.157, 0.4378),
  ('window', 8, 'tilt_deg', 88.53, 0.8923),
  ('window', 8, 'width', -1.063, 0.3674),
  ('window', 8, 'z_max', 1.309, 0.127),
  ('window', 8, 'z_min', 0.922, 0.05582);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.03541, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'area_m2', 1.255, 0.4338),
  ('window', 9, 'aspect', 0.874, 0.3416),
  ('window', 9, 'behind', 0.0001004, 0.03),
  ('window', 9, 'edge_free', 0.02865, 0.1039),
  ('window', 9, 'edge_free_top', 0.02796, 0.09525),
  ('window', 9, 'edge_joined', 0.2522, 0.2753),
  ('window', 9, 'height', 1.49, 0.09988),
  ('window', 9, 'length', 1.229, 0.2736),
  ('window', 9, 'rectangularity', 0.7478, 0.1774),
  ('window', 9, 'spread_length', 1.119, 0.2915),
  ('window', 9, 'spread_width', 0.2198, 0.2218),
  ('window', 9, 'tilt_deg', 89.83, 0.45),
  ('window', 9, 'width', 0.355, 0.2609),
  ('window', 9, 'z_max', 2.319, 0.273),
  ('window', 9, 'z_min', 0.7568, 0.2933);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.0176, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'area_m2', -1.305, 0.3781),
  ('window', 10, 'aspect', 1.169, 0.2833),
  ('window', 10, 'behind', 0.1323, 0.2222),
  ('window', 10, 'edge_free', 0.2385, 0.1716),
  ('window', 10, 'edge_free_top', 0.008037, 0.0378),
  ('window', 10, 'edge_joined', 0.2613, 0.2035),
  ('window', 10, 'height', 1.692, 0.1986),
  ('window', 10, 'length', 0.1106, 0.2093),
  ('window', 10, 'rectangularity', 0.7162, 0.1237),
  ('window', 10, 'spread_length', 0.05744, 0.2352),
  ('window', 10, 'spread_width', -1.28, 0.2989),
  ('window', 10, 'tilt_deg', 88.03, 3.999),
  ('window', 10, 'width', -1.058, 0.2602),
  ('window', 10, 'z_max', 2.042, 0.1298),
  ('window', 10, 'z_min', 1.292, 0.3946);

-- whiteboard: 282 examples
UPDATE object_class SET prior = 0.01638 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', -0.09558, 0.985)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4334, 0.3276)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.01013, 0.06437)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.05112, 0.1084)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.05285, 0.1062)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_joined', 0.7704, 0.2039)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.398, 0.1606)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.29, 0.4629)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.7985, 0.09031)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.1274, 0.471)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.4013, 0.5302)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.68, 0.8393)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', -0.1453, 0.5392)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 1.948, 0.2662)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.8752, 0.1913)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'whiteboard';
DELETE FROM class_density WHERE class = 'whiteboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.2751, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'area_m2', 0.7004, 0.1872),
  ('whiteboard', 1, 'aspect', 0.5341, 0.1392),
  ('whiteboard', 1, 'behind', 0.0001453, 0.03),
  ('whiteboard', 1, 'edge_free', 0.03015, 0.03321),
  ('whiteboard', 1, 'edge_free_top', 0.03571, 0.04223),
  ('whiteboard', 1, 'edge_joined', 0.8137, 0.1245),
  ('whiteboard', 1, 'height', 1.437, 0.06819),
  ('whiteboard', 1, 'length', 0.7157, 0.1283),
  ('whiteboard', 1, 'rectangularity', 0.8253, 0.0754),
  ('whiteboard', 1, 'spread_length', 0.5474, 0.1244),
  ('whiteboard', 1, 'spread_width', -0.1029, 0.148),
  ('whiteboard', 1, 'tilt_deg', 89.96, 0.45),
  ('whiteboard', 1, 'width', 0.1815, 0.09184),
  ('whiteboard', 1, 'z_max', 2.067, 0.1038),
  ('whiteboard', 1, 'z_min', 0.8539, 0.06311);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.1935, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'area_m2', 0.1593, 0.1811),
  ('whiteboard', 2, 'aspect', 0.1863, 0.1321),
  ('whiteboard', 2, 'behind', 0.0002225, 0.03),
  ('whiteboard', 2, 'edge_free', 0.02006, 0.03),
  ('whiteboard', 2, 'edge_free_top', 0.01999, 0.03088),
  ('whiteboard', 2, 'edge_joined', 0.8175, 0.1316),
  ('whiteboard', 2, 'height', 1.412, 0.08635),
  ('whiteboard', 2, 'length', 0.2882, 0.1259),
  ('whiteboard', 2, 'rectangularity', 0.7986, 0.08124),
  ('whiteboard', 2, 'spread_length', 0.1304, 0.1342),
  ('whiteboard', 2, 'spread_width', -0.1972, 0.1485),
  ('whiteboard', 2, 'tilt_deg', 89.96, 0.45),
  ('whiteboard', 2, 'width', 0.1018, 0.1027),
  ('whiteboard', 2, 'z_max', 2.024, 0.1007),
  ('whiteboard', 2, 'z_min', 0.8603, 0.05608);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.1303, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'area_m2', -1.921, 0.4741),
  ('whiteboard', 3, 'aspect', 0.6456, 0.4568),
  ('whiteboard', 3, 'behind', 0.000772, 0.03),
  ('whiteboard', 3, 'edge_free', 0.03063, 0.05712),
  ('whiteboard', 3, 'edge_free_top', 0.02229, 0.04391),
  ('whiteboard', 3, 'edge_joined', 0.8245, 0.237),
  ('whiteboard', 3, 'height', 1.397, 0.2101),
  ('whiteboard', 3, 'length', -0.4945, 0.3187),
  ('whiteboard', 3, 'rectangularity', 0.7536, 0.06026),
  ('whiteboard', 3, 'spread_length', -0.6788, 0.319),
  ('whiteboard', 3, 'spread_width', -1.371, 0.3203),
  ('whiteboard', 3, 'tilt_deg', 89.63, 0.6616),
  ('whiteboard', 3, 'width', -1.14, 0.3259),
  ('whiteboard', 3, 'z_max', 1.734, 0.2454),
  ('whiteboard', 3, 'z_min', 1.107, 0.2455);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.1228, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'area_m2', 0.4078, 0.1663),
  ('whiteboard', 4, 'aspect', 0.1561, 0.09239),
  ('whiteboard', 4, 'behind', 0.03449, 0.1037),
  ('whiteboard', 4, 'edge_free', 0.04531, 0.03735),
  ('whiteboard', 4, 'edge_free_top', 0.05074, 0.05365),
  ('whiteboard', 4, 'edge_joined', 0.8083, 0.1215),
  ('whiteboard', 4, 'height', 1.501, 0.04746),
  ('whiteboard', 4, 'length', 0.3573, 0.09722),
  ('whiteboard', 4, 'rectangularity', 0.862, 0.05013),
  ('whiteboard', 4, 'spread_length', 0.2543, 0.1105),
  ('whiteboard', 4, 'spread_width', 0.02133, 0.09304),
  ('whiteboard', 4, 'tilt_deg', 89.94, 0.5312),
  ('whiteboard', 4, 'width', 0.2012, 0.08272),
  ('whiteboard', 4, 'z_max', 2.112, 0.08009),
  ('whiteboard', 4, 'z_min', 0.8603, 0.06201);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.0963, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'area_m2', -0.5249, 0.2708),
  ('whiteboard', 5, 'aspect', 0.4877, 0.2566),
  ('whiteboard', 5, 'behind', 0.000415, 0.03),
  ('whiteboard', 5, 'edge_free', 0.01477, 0.03),
  ('whiteboard', 5, 'edge_free_top', 0.02002, 0.03196),
  ('whiteboard', 5, 'edge_joined', 0.7686, 0.2087),
  ('whiteboard', 5, 'height', 1.368, 0.1282),
  ('whiteboard', 5, 'length', 0.1187, 0.1413),
  ('whiteboard', 5, 'rectangularity', 0.7681, 0.1007),
  ('whiteboard', 5, 'spread_length', -0.09862, 0.1488),
  ('whiteboard', 5, 'spread_width', -0.5833, 0.1966),
  ('whiteboard', 5, 'tilt_deg', 89.61, 0.8415),
  ('whiteboard', 5, 'width', -0.369, 0.2229),
  ('whiteboard', 5, 'z_max', 1.916, 0.2083),
  ('whiteboard', 5, 'z_min', 0.9002, 0.1387);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.05244, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'area_m2', 0.2609, 0.5083),
  ('whiteboard', 6, 'aspect', 0.6573, 0.3032),
  ('whiteboard', 6, 'behind', 0.0874, 0.2071),
  ('whiteboard', 6, 'edge_free', 0.03905, 0.07248),
  ('whiteboard', 6, 'edge_free_top', 0.06451, 0.09176),
  ('whiteboard', 6, 'edge_joined', 0.4986, 0.2001),
  ('whiteboard', 6, 'height', 1.171, 0.3301),
  ('whiteboard', 6, 'length', 0.6949, 0.2569),
  ('whiteboard', 6, 'rectangularity', 0.6899, 0.1732),
  ('whiteboard', 6, 'spread_length', 0.5597, 0.2773),
  ('whiteboard', 6, 'spread_width', -0.2351, 0.3661),
  ('whiteboard', 6, 'tilt_deg', 87.14, 5.998),
  ('whiteboard', 6, 'width', 0.03764, 0.3379),
  ('whiteboard', 6, 'z_max', 1.777, 0.5536),
  ('whiteboard', 6, 'z_min', 0.4631, 0.3291);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.04313, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'area_m2', -1.62, 0.6404),
  ('whiteboard', 7, 'aspect', 0.7502, 0.4788),
  ('whiteboard', 7, 'behind', 0.05793, 0.1621),
  ('whiteboard', 7, 'edge_free', 0.1523, 0.1147),
  ('whiteboard', 7, 'edge_free_top', 0.1532, 0.09717),
  ('whiteboard', 7, 'edge_joined', 0.5734, 0.2353),
  ('whiteboard', 7, 'height', 1.123, 0.1085),
  ('whiteboard', 7, 'length', -0.3134, 0.511),
  ('whiteboard', 7, 'rectangularity', 0.7903, 0.08346),
  ('whiteboard', 7, 'spread_length', -0.4488, 0.4944),
  ('whiteboard', 7, 'spread_width', -1.256, 0.2444),
  ('whiteboard', 7, 'tilt_deg', 81.29, 19.65),
  ('whiteboard', 7, 'width', -1.064, 0.2417),
  ('whiteboard', 7, 'z_max', 1.31, 0.1129),
  ('whiteboard', 7, 'z_min', 0.8966, 0.1614);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.03642, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'area_m2', -0.1809, 0.4605),
  ('whiteboard', 8, 'aspect', 0.3869, 0.2794),
  ('whiteboard', 8, 'behind', 0.001327, 0.03),
  ('whiteboard', 8, 'edge_free', 0.4702, 0.1808),
  ('whiteboard', 8, 'edge_free_top', 0.4649, 0.166),
  ('whiteboard', 8, 'edge_joined', 0.4426, 0.1526),
  ('whiteboard', 8, 'height', 1.385, 0.0494),
  ('whiteboard', 8, 'length', 0.2547, 0.1444),
  ('whiteboard', 8, 'rectangularity', 0.744, 0.07535),
  ('whiteboard', 8, 'spread_length', 0.08492, 0.1563),
  ('whiteboard', 8, 'spread_width', -0.4088, 0.3305),
  ('whiteboard', 8, 'tilt_deg', 89.69, 0.9146),
  ('whiteboard', 8, 'width', -0.1322, 0.3433),
  ('whiteboard', 8, 'z_max', 2.002, 0.06789),
  ('whiteboard', 8, 'z_min', 0.8435, 0.05224);

-- shelf: 1153 examples
UPDATE object_class SET prior = 0.06707 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.575, 0.8003)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.8852, 0.4434)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5387, 0.334)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3252, 0.1778)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4294, 0.3554)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_joined', 0.2849, 0.2362)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9088, 0.4944)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.1526, 0.5421)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6969, 0.1291)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.2922, 0.5356)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.25, 0.3839)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 53.21, 43.13)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.043, 0.3589)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.203, 0.6259)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.576, 0.5801)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'shelf';
DELETE FROM class_density WHERE class = 'shelf';
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.1505, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'area_m2', -1.475, 0.4107),
  ('shelf', 1, 'aspect', 0.8791, 0.4229),
  ('shelf', 1, 'behind', 0.5868, 0.2977),
  ('shelf', 1, 'edge_free', 0.3988, 0.1608),
  ('shelf', 1, 'edge_free_top', 0.5467, 0.3345),
  ('shelf', 1, 'edge_joined', 0.1983, 0.2157),
  ('shelf', 1, 'height', 1.033, 0.3324),
  ('shelf', 1, 'length', -0.09592, 0.3085),
  ('shelf', 1, 'rectangularity', 0.6809, 0.1273),
  ('shelf', 1, 'spread_length', -0.3083, 0.3353),
  ('shelf', 1, 'spread_width', -1.192, 0.2919),
  ('shelf', 1, 'tilt_deg', 89.48, 2.076),
  ('shelf', 1, 'width', -0.975, 0.25),
  ('shelf', 1, 'z_max', 1.461, 0.4042),
  ('shelf', 1, 'z_min', 0.5363, 0.3593);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.1382, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'area_m2', -0.607, 0.2935),
  ('shelf', 2, 'aspect', 1.442, 0.189),
  ('shelf', 2, 'behind', 0.6833, 0.1956),
  ('shelf', 2, 'edge_free', 0.4026, 0.08212),
  ('shelf', 2, 'edge_free_top', 0.5563, 0.2857),
  ('shelf', 2, 'edge_joined', 0.2546, 0.2263),
  ('shelf', 2, 'height', 1.049, 0.1394),
  ('shelf', 2, 'length', 0.6081, 0.1376),
  ('shelf', 2, 'rectangularity', 0.6959, 0.1274),
  ('shelf', 2, 'spread_length', 0.4572, 0.1632),
  ('shelf', 2, 'spread_width', -1.057, 0.2042),
  ('shelf', 2, 'tilt_deg', 89.69, 2.102),
  ('shelf', 2, 'width', -0.8339, 0.1849),
  ('shelf', 2, 'z_max', 1.929, 0.2207),
  ('shelf', 2, 'z_min', 0.08061, 0.1541);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.1123, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'area_m2', -1.391, 0.3947),
  ('shelf', 3, 'aspect', 0.8009, 0.29),
  ('shelf', 3, 'behind', 0.7467, 0.09369),
  ('shelf', 3, 'edge_free', 0.3403, 0.1094),
  ('shelf', 3, 'edge_free_top', 0.4294, 0.1123),
  ('shelf', 3, 'edge_joined', 0.499, 0.1977),
  ('shelf', 3, 'height', 1.755, 0.2061),
  ('shelf', 3, 'length', -0.1582, 0.2602),
  ('shelf', 3, 'rectangularity', 0.773, 0.1231),
  ('shelf', 3, 'spread_length', -0.28, 0.2652),
  ('shelf', 3, 'spread_width', -1.037, 0.2578),
  ('shelf', 3, 'tilt_deg', 1.959, 2.437),
  ('shelf', 3, 'width', -0.9591, 0.1785),
  ('shelf', 3, 'z_max', 1.762, 0.2066),
  ('shelf', 3, 'z_min', 1.746, 0.2078);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.1113, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'area_m2', -1.738, 0.4231),
  ('shelf', 4, 'aspect', 0.8665, 0.3679),
  ('shelf', 4, 'behind', 0.7355, 0.07696),
  ('shelf', 4, 'edge_free', 0.4203, 0.0735),
  ('shelf', 4, 'edge_free_top', 0.4294, 0.1123),
  ('shelf', 4, 'edge_joined', 0.2847, 0.126),
  ('shelf', 4, 'height', 0.4702, 0.07073),
  ('shelf', 4, 'length', -0.216, 0.2941),
  ('shelf', 4, 'rectangularity', 0.6555, 0.1182),
  ('shelf', 4, 'spread_length', -0.3306, 0.2974),
  ('shelf', 4, 'spread_width', -1.343, 0.2939),
  ('shelf', 4, 'tilt_deg', 3.046, 2.97),
  ('shelf', 4, 'width', -1.083, 0.2668),
  ('shelf', 4, 'z_max', 0.4822, 0.0732),
  ('shelf', 4, 'z_min', 0.4612, 0.07331);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.1019, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'area_m2', -2.473, 0.6571),
  ('shelf', 5, 'aspect', 0.6336, 0.43),
  ('shelf', 5, 'behind', 0.005043, 0.03),
  ('shelf', 5, 'edge_free', 0.009595, 0.03),
  ('shelf', 5, 'edge_free_top', 0.007206, 0.03),
  ('shelf', 5, 'edge_joined', 0.1072, 0.1308),
  ('shelf', 5, 'height', 0.8164, 0.4503),
  ('shelf', 5, 'length', -0.7709, 0.4186),
  ('shelf', 5, 'rectangularity', 0.7543, 0.1224),
  ('shelf', 5, 'spread_length', -0.8443, 0.4244),
  ('shelf', 5, 'spread_width', -1.59, 0.3619),
  ('shelf', 5, 'tilt_deg', 88.82, 2.723),
  ('shelf', 5, 'width', -1.405, 0.3613),
  ('shelf', 5, 'z_max', 0.9643, 0.4646),
  ('shelf', 5, 'z_min', 0.6451, 0.4447);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.09051, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'area_m2', -1.025, 0.2587),
  ('shelf', 6, 'aspect', 1.09, 0.2043),
  ('shelf', 6, 'behind', 0.7635, 0.07849),
  ('shelf', 6, 'edge_free', 0.4146, 0.07856),
  ('shelf', 6, 'edge_free_top', 0.6474, 0.2173),
  ('shelf', 6, 'edge_joined', 0.2348, 0.2306),
  ('shelf', 6, 'height', 0.698, 0.1376),
  ('shelf', 6, 'length', 0.2647, 0.1304),
  ('shelf', 6, 'rectangularity', 0.6399, 0.1175),
  ('shelf', 6, 'spread_length', 0.1178, 0.1482),
  ('shelf', 6, 'spread_width', -1.091, 0.2023),
  ('shelf', 6, 'tilt_deg', 89.49, 2.625),
  ('shelf', 6, 'width', -0.8258, 0.1774),
  ('shelf', 6, 'z_max', 1.294, 0.173),
  ('shelf', 6, 'z_min', 0.002021, 0.04493);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.08795, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'area_m2', -2.683, 0.4327),
  ('shelf', 7, 'aspect', 0.6606, 0.426),
  ('shelf', 7, 'behind', 0.4944, 0.2988),
  ('shelf', 7, 'edge_free', 0.3457, 0.2267),
  ('shelf', 7, 'edge_free_top', 0.4044, 0.3384),
  ('shelf', 7, 'edge_joined', 0.2908, 0.2598),
  ('shelf', 7, 'height', 0.7992, 0.4695),
  ('shelf', 7, 'length', -0.7978, 0.3331),
  ('shelf', 7, 'rectangularity', 0.6626, 0.1117),
  ('shelf', 7, 'spread_length', -0.9449, 0.3362),
  ('shelf', 7, 'spread_width', -1.719, 0.2689),
  ('shelf', 7, 'tilt_deg', 48.22, 41.9),
  ('shelf', 7, 'width', -1.458, 0.2917),
  ('shelf', 7, 'z_max', 0.9003, 0.4766),
  ('shelf', 7, 'z_min', 0.6949, 0.4883);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.0653, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'area_m2', -2.325, 0.741),
  ('shelf', 8, 'aspect', 0.5987, 0.4042),
  ('shelf', 8, 'behind', 0.006739, 0.03),
  ('shelf', 8, 'edge_free', 0.2329, 0.1815),
  ('shelf', 8, 'edge_free_top', 0.4294, 0.1123),
  ('shelf', 8, 'edge_joined', 0.3745, 0.2341),
  ('shelf', 8, 'height', 0.08207, 0.03929),
  ('shelf', 8, 'length', -0.695, 0.4802),
  ('shelf', 8, 'rectangularity', 0.7218, 0.09612),
  ('shelf', 8, 'spread_length', -0.7713, 0.479),
  ('shelf', 8, 'spread_width', -1.488, 0.3523),
  ('shelf', 8, 'tilt_deg', 1.959, 3.229),
  ('shelf', 8, 'width', -1.294, 0.3717),
  ('shelf', 8, 'z_max', 0.0897, 0.04868),
  ('shelf', 8, 'z_min', 0.07416, 0.04405);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.06459, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'area_m2', -1.414, 0.3851),
  ('shelf', 9, 'aspect', 0.8544, 0.3187),
  ('shelf', 9, 'behind', 0.7453, 0.1232),
  ('shelf', 9, 'edge_free', 0.3648, 0.08559),
  ('shelf', 9, 'edge_free_top', 0.4294, 0.1123),
  ('shelf', 9, 'edge_joined', 0.4783, 0.1697),
  ('shelf', 9, 'height', 0.8858, 0.1154),
  ('shelf', 9, 'length', -0.08942, 0.2703),
  ('shelf', 9, 'rectangularity', 0.695, 0.1187),
  ('shelf', 9, 'spread_length', -0.2674, 0.2797),
  ('shelf', 9, 'spread_width', -1.123, 0.2966),
  ('shelf', 9, 'tilt_deg', 2.792, 3.347),
  ('shelf', 9, 'width', -0.9438, 0.1984),
  ('shelf', 9, 'z_max', 0.8986, 0.1194),
  ('shelf', 9, 'z_min', 0.8755, 0.1173);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.02746, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'area_m2', -0.5939, 0.51),
  ('shelf', 10, 'aspect', 0.3223, 0.2138),
  ('shelf', 10, 'behind', 0.06301, 0.1439),
  ('shelf', 10, 'edge_free', 0.0677, 0.07921),
  ('shelf', 10, 'edge_free_top', 0.07415, 0.1111),
  ('shelf', 10, 'edge_joined', 0.1908, 0.1772),
  ('shelf', 10, 'height', 1.257, 0.2057),
  ('shelf', 10, 'length', 0.08598, 0.2938),
  ('shelf', 10, 'rectangularity', 0.6666, 0.1549),
  ('shelf', 10, 'spread_length', -0.01543, 0.2841),
  ('shelf', 10, 'spread_width', -0.4641, 0.2312),
  ('shelf', 10, 'tilt_deg', 88.68, 4.642),
  ('shelf', 10, 'width', -0.2363, 0.316),
  ('shelf', 10, 'z_max', 1.738, 0.2563),
  ('shelf', 10, 'z_min', 0.711, 0.283);

-- cabinet: 1373 examples
UPDATE object_class SET prior = 0.07977 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.7965, 0.9298)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6478, 0.4158)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.4888, 0.2429)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.3862, 0.2701)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.7655, 0.3058)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_joined', 0.2635, 0.3026)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7972, 0.3636)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.09507, 0.4796)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7296, 0.1288)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.08268, 0.4865)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7646, 0.5077)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 76.14, 32.03)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.5563, 0.4805)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.27, 0.5849)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2442, 0.3609)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'cabinet';
DELETE FROM class_density WHERE class = 'cabinet';
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.1536, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'area_m2', -0.3461, 0.3643),
  ('cabinet', 1, 'aspect', 0.4397, 0.2695),
  ('cabinet', 1, 'behind', 0.5104, 0.1669),
  ('cabinet', 1, 'edge_free', 0.4365, 0.223),
  ('cabinet', 1, 'edge_free_top', 0.8668, 0.2048),
  ('cabinet', 1, 'edge_joined', 0.2236, 0.2805),
  ('cabinet', 1, 'height', 0.5974, 0.1136),
  ('cabinet', 1, 'length', 0.1875, 0.14),
  ('cabinet', 1, 'rectangularity', 0.7653, 0.1189),
  ('cabinet', 1, 'spread_length', 0.04737, 0.1417),
  ('cabinet', 1, 'spread_width', -0.4477, 0.3086),
  ('cabinet', 1, 'tilt_deg', 89.8, 1.458),
  ('cabinet', 1, 'width', -0.2521, 0.2623),
  ('cabinet', 1, 'z_max', 1.092, 0.1723),
  ('cabinet', 1, 'z_min', -0.01242, 0.02509);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.125, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'area_m2', -0.4375, 0.4684),
  ('cabinet', 2, 'aspect', 0.6678, 0.365),
  ('cabinet', 2, 'behind', 0.3735, 0.2681),
  ('cabinet', 2, 'edge_free', 0.3415, 0.258),
  ('cabinet', 2, 'edge_free_top', 0.7886, 0.2517),
  ('cabinet', 2, 'edge_joined', 0.2995, 0.2969),
  ('cabinet', 2, 'height', 1.3, 0.231),
  ('cabinet', 2, 'length', 0.268, 0.3045),
  ('cabinet', 2, 'rectangularity', 0.7478, 0.1215),
  ('cabinet', 2, 'spread_length', 0.02036, 0.3092),
  ('cabinet', 2, 'spread_width', -0.5625, 0.2762),
  ('cabinet', 2, 'tilt_deg', 89.73, 1.605),
  ('cabinet', 2, 'width', -0.3998, 0.2911),
  ('cabinet', 2, 'z_max', 1.925, 0.3218),
  ('cabinet', 2, 'z_min', 0.5882, 0.3504);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.1244, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'area_m2', 0.3779, 0.3405),
  ('cabinet', 3, 'aspect', 0.6851, 0.2794),
  ('cabinet', 3, 'behind', 0.311, 0.176),
  ('cabinet', 3, 'edge_free', 0.6014, 0.1954),
  ('cabinet', 3, 'edge_free_top', 0.9757, 0.03991),
  ('cabinet', 3, 'edge_joined', 0.04496, 0.05867),
  ('cabinet', 3, 'height', 1.052, 0.1445),
  ('cabinet', 3, 'length', 0.6279, 0.1026),
  ('cabinet', 3, 'rectangularity', 0.8322, 0.1051),
  ('cabinet', 3, 'spread_length', 0.4927, 0.1665),
  ('cabinet', 3, 'spread_width', -0.2367, 0.3051),
  ('cabinet', 3, 'tilt_deg', 89.88, 1.518),
  ('cabinet', 3, 'width', -0.0572, 0.2925),
  ('cabinet', 3, 'z_max', 1.873, 0.2164),
  ('cabinet', 3, 'z_min', 0.01327, 0.05714);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.1083, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'area_m2', -1.086, 0.2342),
  ('cabinet', 4, 'aspect', 0.246, 0.1828),
  ('cabinet', 4, 'behind', 0.6136, 0.1558),
  ('cabinet', 4, 'edge_free', 0.3914, 0.2151),
  ('cabinet', 4, 'edge_free_top', 0.6477, 0.3145),
  ('cabinet', 4, 'edge_joined', 0.2223, 0.26),
  ('cabinet', 4, 'height', 0.352, 0.06846),
  ('cabinet', 4, 'length', -0.2148, 0.1479),
  ('cabinet', 4, 'rectangularity', 0.6711, 0.0965),
  ('cabinet', 4, 'spread_length', -0.4115, 0.13),
  ('cabinet', 4, 'spread_width', -0.7631, 0.1695),
  ('cabinet', 4, 'tilt_deg', 89.67, 1.653),
  ('cabinet', 4, 'width', -0.4609, 0.1487),
  ('cabinet', 4, 'z_max', 0.7218, 0.1053),
  ('cabinet', 4, 'z_min', -0.0145, 0.02435);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.09299, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'area_m2', -0.04827, 0.3245),
  ('cabinet', 5, 'aspect', 1.151, 0.2865),
  ('cabinet', 5, 'behind', 0.5036, 0.2184),
  ('cabinet', 5, 'edge_free', 0.2085, 0.1704),
  ('cabinet', 5, 'edge_free_top', 0.7406, 0.2249),
  ('cabinet', 5, 'edge_joined', 0.4691, 0.329),
  ('cabinet', 5, 'height', 1.037, 0.1253),
  ('cabinet', 5, 'length', 0.6877, 0.1084),
  ('cabinet', 5, 'rectangularity', 0.7684, 0.09935),
  ('cabinet', 5, 'spread_length', 0.524, 0.1217),
  ('cabinet', 5, 'spread_width', -0.6471, 0.2958),
  ('cabinet', 5, 'tilt_deg', 89.88, 1.725),
  ('cabinet', 5, 'width', -0.4629, 0.2764),
  ('cabinet', 5, 'z_max', 1.988, 0.216),
  ('cabinet', 5, 'z_min', -0.00301, 0.03648);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.08572, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'area_m2', -1.253, 0.4821),
  ('cabinet', 6, 'aspect', 0.8193, 0.5258),
  ('cabinet', 6, 'behind', 0.3676, 0.2674),
  ('cabinet', 6, 'edge_free', 0.6549, 0.3039),
  ('cabinet', 6, 'edge_free_top', 0.9658, 0.06037),
  ('cabinet', 6, 'edge_joined', 0.045, 0.08031),
  ('cabinet', 6, 'height', 0.9273, 0.3011),
  ('cabinet', 6, 'length', 0.0004979, 0.3429),
  ('cabinet', 6, 'rectangularity', 0.6685, 0.1526),
  ('cabinet', 6, 'spread_length', -0.2082, 0.3893),
  ('cabinet', 6, 'spread_width', -1.088, 0.3776),
  ('cabinet', 6, 'tilt_deg', 89.47, 2.083),
  ('cabinet', 6, 'width', -0.8189, 0.3678),
  ('cabinet', 6, 'z_max', 1.355, 0.4227),
  ('cabinet', 6, 'z_min', 0.3711, 0.3237);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.08271, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'area_m2', -1.94, 0.4025),
  ('cabinet', 7, 'aspect', 0.8844, 0.4643),
  ('cabinet', 7, 'behind', 0.5191, 0.2308),
  ('cabinet', 7, 'edge_free', 0.1904, 0.1691),
  ('cabinet', 7, 'edge_free_top', 0.3181, 0.2992),
  ('cabinet', 7, 'edge_joined', 0.2062, 0.1942),
  ('cabinet', 7, 'height', 0.3094, 0.1565),
  ('cabinet', 7, 'length', -0.3113, 0.298),
  ('cabinet', 7, 'rectangularity', 0.6604, 0.1176),
  ('cabinet', 7, 'spread_length', -0.4991, 0.2796),
  ('cabinet', 7, 'spread_width', -1.46, 0.3042),
  ('cabinet', 7, 'tilt_deg', 89.06, 2.22),
  ('cabinet', 7, 'width', -1.196, 0.3162),
  ('cabinet', 7, 'z_max', 0.5668, 0.235),
  ('cabinet', 7, 'z_min', 0.03041, 0.08761);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.08024, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'area_m2', -0.8664, 0.436),
  ('cabinet', 8, 'aspect', 0.6275, 0.2991),
  ('cabinet', 8, 'behind', 0.6512, 0.1852),
  ('cabinet', 8, 'edge_free', 0.1834, 0.1384),
  ('cabinet', 8, 'edge_free_top', 0.7655, 0.09667),
  ('cabinet', 8, 'edge_joined', 0.7487, 0.1662),
  ('cabinet', 8, 'height', 0.9231, 0.1365),
  ('cabinet', 8, 'length', 0.0773, 0.3122),
  ('cabinet', 8, 'rectangularity', 0.6812, 0.09141),
  ('cabinet', 8, 'spread_length', -0.1175, 0.289),
  ('cabinet', 8, 'spread_width', -0.653, 0.2367),
  ('cabinet', 8, 'tilt_deg', 1.176, 2.023),
  ('cabinet', 8, 'width', -0.5502, 0.1886),
  ('cabinet', 8, 'z_max', 0.9306, 0.1401),
  ('cabinet', 8, 'z_min', 0.9153, 0.1358);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.05561, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'area_m2', -2.13, 0.5075),
  ('cabinet', 9, 'aspect', 0.5427, 0.3418),
  ('cabinet', 9, 'behind', 0.7093, 0.1277),
  ('cabinet', 9, 'edge_free', 0.3656, 0.1873),
  ('cabinet', 9, 'edge_free_top', 0.7655, 0.09667),
  ('cabinet', 9, 'edge_joined', 0.2513, 0.1653),
  ('cabinet', 9, 'height', 0.5828, 0.02687),
  ('cabinet', 9, 'length', -0.6351, 0.2047),
  ('cabinet', 9, 'rectangularity', 0.7384, 0.1145),
  ('cabinet', 9, 'spread_length', -0.7664, 0.2155),
  ('cabinet', 9, 'spread_width', -1.372, 0.3902),
  ('cabinet', 9, 'tilt_deg', 1.728, 2.597),
  ('cabinet', 9, 'width', -1.178, 0.4006),
  ('cabinet', 9, 'z_max', 0.5914, 0.04257),
  ('cabinet', 9, 'z_min', 0.5734, 0.02708);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.04147, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'area_m2', -2.852, 0.5951),
  ('cabinet', 10, 'aspect', 0.5588, 0.348),
  ('cabinet', 10, 'behind', 0.513, 0.2656),
  ('cabinet', 10, 'edge_free', 0.341, 0.299),
  ('cabinet', 10, 'edge_free_top', 0.5831, 0.3888),
  ('cabinet', 10, 'edge_joined', 0.2415, 0.2759),
  ('cabinet', 10, 'height', 0.664, 0.3177),
  ('cabinet', 10, 'length', -0.9046, 0.3682),
  ('cabinet', 10, 'rectangularity', 0.6323, 0.1293),
  ('cabinet', 10, 'spread_length', -1.057, 0.3713),
  ('cabinet', 10, 'spread_width', -1.718, 0.248),
  ('cabinet', 10, 'tilt_deg', 68.88, 35.62),
  ('cabinet', 10, 'width', -1.463, 0.2954),
  ('cabinet', 10, 'z_max', 0.7822, 0.3369),
  ('cabinet', 10, 'z_min', 0.5325, 0.3236);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.0333 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.366 WHERE name = 'aspect';
UPDATE feature SET weight = 0.489 WHERE name = 'edge_free';
UPDATE feature SET weight = 0.298 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.267 WHERE name = 'edge_joined';
UPDATE feature SET weight = 0.209 WHERE name = 'height';
UPDATE feature SET weight = 0.0686 WHERE name = 'length';
UPDATE feature SET weight = 0.5 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.316 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.258 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.418 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.308 WHERE name = 'width';
UPDATE feature SET weight = 0.436 WHERE name = 'z_max';
UPDATE feature SET weight = 0.429 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.276 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0554 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0404 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.132 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0188 WHERE name = 'table';
UPDATE object_class SET prior = 0.0261 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.15 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.00831 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0467 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0188 WHERE name = 'door';
UPDATE object_class SET prior = 0.0162 WHERE name = 'window';
UPDATE object_class SET prior = 0.0113 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0858 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.114 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.94 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.532 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 2.05 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.56 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 3.69 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 0.0413 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 0.805 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.299 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.677 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 2.08 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.84 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 0.819 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.411 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.72 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.12 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 2.97 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 4.52 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.48 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.515 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.627 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.01 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 1.29 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.503 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.14 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.22 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 2.39 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 0.958 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.67 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.444 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.35 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.71 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.54 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.0224 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 0.912 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2383 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.845' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.182' WHERE key = 'probability_offset';
