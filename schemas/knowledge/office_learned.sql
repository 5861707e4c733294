-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 16761 planes of 180 paper-like rooms, seeds from 1; 90 at 2 cm, seeds from 10101; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 60 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 6628 examples
UPDATE object_class SET prior = 0.3012 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.777, 1.239)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6842, 0.5746)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4749, 0.2907)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.4392, 0.3163)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.5605, 0.4132)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_joined', 0.3122, 0.3315)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_unseen', 0.0495, 0.1088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 1.042, 0.7283)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.3743, 0.7198)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.7294, 0.1443)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.5214, 0.7442)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.267, 0.6472)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 62.53, 39.98)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.061, 0.6371)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.331, 1.002)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7506, 0.7894)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0208889, 0.003234),
  ('unknown', 'area_m2', 0.0208889, 0.0469324, 0.1113),
  ('unknown', 'area_m2', 0.0469324, 0.049901, 0.2332),
  ('unknown', 'area_m2', 0.049901, 0.0672105, 0.3689),
  ('unknown', 'area_m2', 0.0672105, 0.0891506, 0.392),
  ('unknown', 'area_m2', 0.0891506, 0.105446, 0.3659),
  ('unknown', 'area_m2', 0.105446, 0.121573, 0.3473),
  ('unknown', 'area_m2', 0.121573, 0.172373, 0.3214),
  ('unknown', 'area_m2', 0.172373, 0.236913, 0.3336),
  ('unknown', 'area_m2', 0.236913, 0.324212, 0.3711),
  ('unknown', 'area_m2', 0.324212, 0.532289, 0.2134),
  ('unknown', 'area_m2', 0.532289, 0.550781, 0.1334),
  ('unknown', 'area_m2', 0.550781, 1.19593, 0.08572),
  ('unknown', 'area_m2', 1.19593, 2.68698, 0.01049),
  ('unknown', 'area_m2', 2.68698, 6.03701, 0.008948),
  ('unknown', 'area_m2', 6.03701, 13.5638, 0.01105),
  ('unknown', 'area_m2', 13.5638, 30.4746, 0.01355),
  ('unknown', 'area_m2', 30.4746, 100, 0.007897);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.10377, 1.126),
  ('unknown', 'aspect', 1.10377, 1.23127, 1.017),
  ('unknown', 'aspect', 1.23127, 1.27401, 1.037),
  ('unknown', 'aspect', 1.27401, 1.37433, 1.002),
  ('unknown', 'aspect', 1.37433, 1.54443, 0.9472),
  ('unknown', 'aspect', 1.54443, 1.6231, 0.796),
  ('unknown', 'aspect', 1.6231, 1.77127, 0.8233),
  ('unknown', 'aspect', 1.77127, 2.06784, 0.61),
  ('unknown', 'aspect', 2.06784, 2.12952, 0.5257),
  ('unknown', 'aspect', 2.12952, 2.63445, 0.3647),
  ('unknown', 'aspect', 2.63445, 3.08743, 0.2225),
  ('unknown', 'aspect', 3.08743, 3.35632, 0.1765),
  ('unknown', 'aspect', 3.35632, 4.27598, 0.2019),
  ('unknown', 'aspect', 4.27598, 5.10804, 0.265),
  ('unknown', 'aspect', 5.10804, 5.44764, 0.3084),
  ('unknown', 'aspect', 5.44764, 6.94035, 0.2544),
  ('unknown', 'aspect', 6.94035, 8.84207, 0.08203),
  ('unknown', 'aspect', 8.84207, 100, 0.003858);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.0963224, 2.08),
  ('unknown', 'behind', 0.0963224, 0.157895, 0.3521),
  ('unknown', 'behind', 0.157895, 0.192645, 0.3941),
  ('unknown', 'behind', 0.192645, 0.288967, 0.4514),
  ('unknown', 'behind', 0.288967, 0.382217, 0.585),
  ('unknown', 'behind', 0.382217, 0.38529, 0.8291),
  ('unknown', 'behind', 0.38529, 0.481612, 0.8677),
  ('unknown', 'behind', 0.481612, 0.503387, 1.132),
  ('unknown', 'behind', 0.503387, 0.577935, 1.026),
  ('unknown', 'behind', 0.577935, 0.602879, 1.384),
  ('unknown', 'behind', 0.602879, 0.674257, 1.455),
  ('unknown', 'behind', 0.674257, 0.678322, 1.69),
  ('unknown', 'behind', 0.678322, 0.742178, 1.746),
  ('unknown', 'behind', 0.742178, 0.77058, 2.083),
  ('unknown', 'behind', 0.77058, 0.794872, 2.145),
  ('unknown', 'behind', 0.794872, 0.866902, 1.452),
  ('unknown', 'behind', 0.866902, 1, 0.04801);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free', 0, 0.105088, 2.115),
  ('unknown', 'edge_free', 0.105088, 0.111111, 0.5811),
  ('unknown', 'edge_free', 0.111111, 0.222222, 0.6264),
  ('unknown', 'edge_free', 0.222222, 0.277351, 0.6905),
  ('unknown', 'edge_free', 0.277351, 0.333333, 0.8117),
  ('unknown', 'edge_free', 0.333333, 0.394995, 1.056),
  ('unknown', 'edge_free', 0.394995, 0.444444, 1.182),
  ('unknown', 'edge_free', 0.444444, 0.485393, 1.286),
  ('unknown', 'edge_free', 0.485393, 0.555556, 1.227),
  ('unknown', 'edge_free', 0.555556, 0.583168, 0.9194),
  ('unknown', 'edge_free', 0.583168, 0.666667, 0.9168),
  ('unknown', 'edge_free', 0.666667, 0.706024, 0.8724),
  ('unknown', 'edge_free', 0.706024, 0.777778, 0.7443),
  ('unknown', 'edge_free', 0.777778, 0.888889, 0.4805),
  ('unknown', 'edge_free', 0.888889, 0.898705, 0.4542),
  ('unknown', 'edge_free', 0.898705, 1, 1.098);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free_top', 0, 0.111111, 2.525),
  ('unknown', 'edge_free_top', 0.111111, 0.222222, 0.3707),
  ('unknown', 'edge_free_top', 0.222222, 0.255404, 0.3355),
  ('unknown', 'edge_free_top', 0.255404, 0.333333, 0.3535),
  ('unknown', 'edge_free_top', 0.333333, 0.444444, 0.3264),
  ('unknown', 'edge_free_top', 0.444444, 0.555556, 0.4258),
  ('unknown', 'edge_free_top', 0.555556, 0.666667, 0.4388),
  ('unknown', 'edge_free_top', 0.666667, 0.777778, 0.5385),
  ('unknown', 'edge_free_top', 0.777778, 0.78272, 0.757),
  ('unknown', 'edge_free_top', 0.78272, 0.888889, 0.6825),
  ('unknown', 'edge_free_top', 0.888889, 0.925381, 1.052),
  ('unknown', 'edge_free_top', 0.925381, 1, 4.46);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_joined', 0, 0.0143738, 15.4),
  ('unknown', 'edge_joined', 0.0143738, 0.0564611, 2.647),
  ('unknown', 'edge_joined', 0.0564611, 0.111111, 1.602),
  ('unknown', 'edge_joined', 0.111111, 0.129092, 1.32),
  ('unknown', 'edge_joined', 0.129092, 0.222222, 0.9958),
  ('unknown', 'edge_joined', 0.222222, 0.243385, 0.8564),
  ('unknown', 'edge_joined', 0.243385, 0.333333, 0.8248),
  ('unknown', 'edge_joined', 0.333333, 0.386301, 0.7031),
  ('unknown', 'edge_joined', 0.386301, 0.444444, 0.5988),
  ('unknown', 'edge_joined', 0.444444, 0.555556, 0.4974),
  ('unknown', 'edge_joined', 0.555556, 0.599168, 0.4883),
  ('unknown', 'edge_joined', 0.599168, 0.666667, 0.4029),
  ('unknown', 'edge_joined', 0.666667, 0.777778, 0.4099),
  ('unknown', 'edge_joined', 0.777778, 0.877881, 0.3815),
  ('unknown', 'edge_joined', 0.877881, 0.888889, 0.3993),
  ('unknown', 'edge_joined', 0.888889, 1, 0.9627);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_unseen';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_unseen', 0, 0.0374327, 20.75),
  ('unknown', 'edge_unseen', 0.0374327, 0.054523, 0.7779),
  ('unknown', 'edge_unseen', 0.054523, 0.109046, 0.7742),
  ('unknown', 'edge_unseen', 0.109046, 0.163569, 0.6699),
  ('unknown', 'edge_unseen', 0.163569, 0.19994, 0.5582),
  ('unknown', 'edge_unseen', 0.19994, 0.218092, 0.5785),
  ('unknown', 'edge_unseen', 0.218092, 0.272615, 0.4559),
  ('unknown', 'edge_unseen', 0.272615, 0.327138, 0.4672),
  ('unknown', 'edge_unseen', 0.327138, 0.381661, 0.3912),
  ('unknown', 'edge_unseen', 0.381661, 0.436184, 0.265),
  ('unknown', 'edge_unseen', 0.436184, 0.490707, 0.09105),
  ('unknown', 'edge_unseen', 0.490707, 1, 0.01848);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0710013, 0.009842),
  ('unknown', 'height', 0.0710013, 0.221814, 0.7045),
  ('unknown', 'height', 0.221814, 0.393931, 0.5444),
  ('unknown', 'height', 0.393931, 0.42134, 0.7399),
  ('unknown', 'height', 0.42134, 0.585477, 0.6557),
  ('unknown', 'height', 0.585477, 0.716861, 0.341),
  ('unknown', 'height', 0.716861, 0.80903, 0.7181),
  ('unknown', 'height', 0.80903, 0.922956, 0.951),
  ('unknown', 'height', 0.922956, 1.03979, 0.4792),
  ('unknown', 'height', 1.03979, 1.26738, 0.2553),
  ('unknown', 'height', 1.26738, 1.36272, 0.2713),
  ('unknown', 'height', 1.36272, 1.59373, 0.3679),
  ('unknown', 'height', 1.59373, 1.68565, 0.3608),
  ('unknown', 'height', 1.68565, 2.00858, 0.1634),
  ('unknown', 'height', 2.00858, 2.17008, 0.1855),
  ('unknown', 'height', 2.17008, 2.33151, 0.2213),
  ('unknown', 'height', 2.33151, 2.65444, 0.123),
  ('unknown', 'height', 2.65444, 2.97737, 0.06609),
  ('unknown', 'height', 2.97737, 4, 0.009371);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.183599, 0.004363),
  ('unknown', 'length', 0.183599, 0.28123, 0.1586),
  ('unknown', 'length', 0.28123, 0.310265, 0.3668),
  ('unknown', 'length', 0.310265, 0.37666, 0.5703),
  ('unknown', 'length', 0.37666, 0.430777, 0.5266),
  ('unknown', 'length', 0.430777, 0.461092, 0.5857),
  ('unknown', 'length', 0.461092, 0.567495, 0.5384),
  ('unknown', 'length', 0.567495, 0.659847, 0.4923),
  ('unknown', 'length', 0.659847, 0.725276, 0.3988),
  ('unknown', 'length', 0.725276, 0.911295, 0.4833),
  ('unknown', 'length', 0.911295, 1.01073, 0.4288),
  ('unknown', 'length', 1.01073, 1.18948, 0.4123),
  ('unknown', 'length', 1.18948, 1.49018, 0.4902),
  ('unknown', 'length', 1.49018, 1.54819, 0.4325),
  ('unknown', 'length', 1.54819, 2.37146, 0.1201),
  ('unknown', 'length', 2.37146, 3.63251, 0.02585),
  ('unknown', 'length', 3.63251, 5.56414, 0.02733),
  ('unknown', 'length', 5.56414, 8.52293, 0.02715),
  ('unknown', 'length', 8.52293, 30, 0.007351);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.30555, 0.03173),
  ('unknown', 'rectangularity', 0.30555, 0.378751, 0.1957),
  ('unknown', 'rectangularity', 0.378751, 0.451951, 0.3279),
  ('unknown', 'rectangularity', 0.451951, 0.525151, 0.6361),
  ('unknown', 'rectangularity', 0.525151, 0.539966, 1.113),
  ('unknown', 'rectangularity', 0.539966, 0.598351, 1.265),
  ('unknown', 'rectangularity', 0.598351, 0.622867, 1.52),
  ('unknown', 'rectangularity', 0.622867, 0.671551, 1.851),
  ('unknown', 'rectangularity', 0.671551, 0.682113, 1.965),
  ('unknown', 'rectangularity', 0.682113, 0.731266, 2.27),
  ('unknown', 'rectangularity', 0.731266, 0.744751, 2.471),
  ('unknown', 'rectangularity', 0.744751, 0.772491, 2.792),
  ('unknown', 'rectangularity', 0.772491, 0.811696, 2.842),
  ('unknown', 'rectangularity', 0.811696, 0.817951, 2.65),
  ('unknown', 'rectangularity', 0.817951, 0.850851, 2.862),
  ('unknown', 'rectangularity', 0.850851, 0.891151, 2.648),
  ('unknown', 'rectangularity', 0.891151, 0.892883, 2.443),
  ('unknown', 'rectangularity', 0.892883, 0.964351, 1.465),
  ('unknown', 'rectangularity', 0.964351, 1, 0.1912);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.162281, 0.002459),
  ('unknown', 'spread_length', 0.162281, 0.250047, 0.1734),
  ('unknown', 'spread_length', 0.250047, 0.265492, 0.4771),
  ('unknown', 'spread_length', 0.265492, 0.319788, 0.6079),
  ('unknown', 'spread_length', 0.319788, 0.375214, 0.6804),
  ('unknown', 'spread_length', 0.375214, 0.385279, 0.482),
  ('unknown', 'spread_length', 0.385279, 0.463666, 0.531),
  ('unknown', 'spread_length', 0.463666, 0.593647, 0.3883),
  ('unknown', 'spread_length', 0.593647, 0.620215, 0.369),
  ('unknown', 'spread_length', 0.620215, 0.789722, 0.464),
  ('unknown', 'spread_length', 0.789722, 0.914706, 0.3998),
  ('unknown', 'spread_length', 0.914706, 1.0568, 0.3494),
  ('unknown', 'spread_length', 1.0568, 1.34347, 0.4648),
  ('unknown', 'spread_length', 1.34347, 1.4094, 0.3731),
  ('unknown', 'spread_length', 1.4094, 2.17164, 0.1154),
  ('unknown', 'spread_length', 2.17164, 3.34612, 0.02441),
  ('unknown', 'spread_length', 3.34612, 5.15578, 0.02608),
  ('unknown', 'spread_length', 5.15578, 7.94416, 0.02896),
  ('unknown', 'spread_length', 7.94416, 40, 0.005876);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.110262, 0.0007285),
  ('unknown', 'spread_width', 0.110262, 0.154804, 0.3194),
  ('unknown', 'spread_width', 0.154804, 0.16759, 0.5918),
  ('unknown', 'spread_width', 0.16759, 0.184494, 0.6834),
  ('unknown', 'spread_width', 0.184494, 0.206035, 1.01),
  ('unknown', 'spread_width', 0.206035, 0.223416, 1.32),
  ('unknown', 'spread_width', 0.223416, 0.254724, 0.8155),
  ('unknown', 'spread_width', 0.254724, 0.301731, 0.6837),
  ('unknown', 'spread_width', 0.301731, 0.387161, 0.4483),
  ('unknown', 'spread_width', 0.387161, 0.578646, 0.279),
  ('unknown', 'spread_width', 0.578646, 0.588456, 0.2441),
  ('unknown', 'spread_width', 0.588456, 0.894409, 0.1512),
  ('unknown', 'spread_width', 0.894409, 1.35943, 0.02229),
  ('unknown', 'spread_width', 1.35943, 2.06624, 0.01933),
  ('unknown', 'spread_width', 2.06624, 3.14053, 0.01854),
  ('unknown', 'spread_width', 3.14053, 4.77337, 0.02268),
  ('unknown', 'spread_width', 4.77337, 20, 0.006466);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 0.414995, 0.2479),
  ('unknown', 'tilt_deg', 0.414995, 1.46345, 0.1136),
  ('unknown', 'tilt_deg', 1.46345, 10, 0.007985),
  ('unknown', 'tilt_deg', 10, 20, 0.0007442),
  ('unknown', 'tilt_deg', 20, 30, 0.0001092),
  ('unknown', 'tilt_deg', 30, 40, 2.289e-05),
  ('unknown', 'tilt_deg', 40, 50, 2.605e-05),
  ('unknown', 'tilt_deg', 50, 60, 5.116e-05),
  ('unknown', 'tilt_deg', 60, 70, 0.0003548),
  ('unknown', 'tilt_deg', 70, 79.7407, 0.003124),
  ('unknown', 'tilt_deg', 79.7407, 80, 0.003821),
  ('unknown', 'tilt_deg', 80, 88.7914, 0.01285),
  ('unknown', 'tilt_deg', 88.7914, 89.5641, 0.1833),
  ('unknown', 'tilt_deg', 89.5641, 89.8161, 0.7459),
  ('unknown', 'tilt_deg', 89.8161, 90, 1.211);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.130836, 0.002433),
  ('unknown', 'width', 0.130836, 0.187457, 0.2952),
  ('unknown', 'width', 0.187457, 0.196891, 0.5353),
  ('unknown', 'width', 0.196891, 0.219079, 0.7779),
  ('unknown', 'width', 0.219079, 0.245158, 0.9774),
  ('unknown', 'width', 0.245158, 0.282803, 0.7837),
  ('unknown', 'width', 0.282803, 0.296294, 0.7895),
  ('unknown', 'width', 0.296294, 0.325556, 0.7931),
  ('unknown', 'width', 0.325556, 0.388415, 0.6335),
  ('unknown', 'width', 0.388415, 0.445884, 0.45),
  ('unknown', 'width', 0.445884, 0.498412, 0.4357),
  ('unknown', 'width', 0.498412, 0.670995, 0.3254),
  ('unknown', 'width', 0.670995, 0.700981, 0.3258),
  ('unknown', 'width', 0.700981, 1.00976, 0.1815),
  ('unknown', 'width', 1.00976, 1.51955, 0.02545),
  ('unknown', 'width', 1.51955, 2.28672, 0.02007),
  ('unknown', 'width', 2.28672, 3.44121, 0.02166),
  ('unknown', 'width', 3.44121, 5.17857, 0.02163),
  ('unknown', 'width', 5.17857, 12, 0.01053);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0748564, 0.006959),
  ('unknown', 'z_max', 0.0748564, 0.426247, 0.3241),
  ('unknown', 'z_max', 0.426247, 0.510983, 0.5675),
  ('unknown', 'z_max', 0.510983, 0.672444, 0.3495),
  ('unknown', 'z_max', 0.672444, 0.778692, 1.044),
  ('unknown', 'z_max', 0.778692, 0.901375, 0.8991),
  ('unknown', 'z_max', 0.901375, 0.947111, 0.7369),
  ('unknown', 'z_max', 0.947111, 1.07608, 0.6043),
  ('unknown', 'z_max', 1.07608, 1.38324, 0.2687),
  ('unknown', 'z_max', 1.38324, 1.59936, 0.1281),
  ('unknown', 'z_max', 1.59936, 1.81936, 0.1798),
  ('unknown', 'z_max', 1.81936, 2.05003, 0.3107),
  ('unknown', 'z_max', 2.05003, 2.25549, 0.4476),
  ('unknown', 'z_max', 2.25549, 2.3181, 0.3191),
  ('unknown', 'z_max', 2.3181, 2.69162, 0.156),
  ('unknown', 'z_max', 2.69162, 3.12775, 0.05135),
  ('unknown', 'z_max', 3.12775, 3.56387, 0.01147),
  ('unknown', 'z_max', 3.56387, 4, 0.05875);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.12951, 0.06579),
  ('unknown', 'z_min', -0.12951, -0.0166997, 0.8425),
  ('unknown', 'z_min', -0.0166997, 0.00728487, 3.828),
  ('unknown', 'z_min', 0.00728487, 0.227309, 0.5529),
  ('unknown', 'z_min', 0.227309, 0.24098, 0.2914),
  ('unknown', 'z_min', 0.24098, 0.61147, 0.2631),
  ('unknown', 'z_min', 0.61147, 0.641548, 0.3294),
  ('unknown', 'z_min', 0.641548, 0.754877, 0.9767),
  ('unknown', 'z_min', 0.754877, 0.88718, 0.8454),
  ('unknown', 'z_min', 0.88718, 0.98196, 0.5622),
  ('unknown', 'z_min', 0.98196, 1.2125, 0.2434),
  ('unknown', 'z_min', 1.2125, 1.35245, 0.3132),
  ('unknown', 'z_min', 1.35245, 1.72294, 0.1214),
  ('unknown', 'z_min', 1.72294, 2.01227, 0.08074),
  ('unknown', 'z_min', 2.01227, 2.09343, 0.1032),
  ('unknown', 'z_min', 2.09343, 2.46392, 0.1666),
  ('unknown', 'z_min', 2.46392, 2.83441, 0.08768),
  ('unknown', 'z_min', 2.83441, 4, 0.00777);
DELETE FROM class_kind WHERE class = 'unknown';
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.03049, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'area_m2', -2.593, 0.3169),
  ('unknown', 1, 'aspect', 0.3833, 0.2665),
  ('unknown', 1, 'behind', 0.633, 0.1797),
  ('unknown', 1, 'edge_free', 0.4692, 0.1497),
  ('unknown', 1, 'edge_free_top', 0.7797, 0.2033),
  ('unknown', 1, 'edge_joined', 0.1958, 0.1906),
  ('unknown', 1, 'edge_unseen', 0.005927, 0.04008),
  ('unknown', 1, 'height', 0.1908, 0.02696),
  ('unknown', 1, 'length', -0.9069, 0.1801),
  ('unknown', 1, 'rectangularity', 0.6709, 0.1555),
  ('unknown', 1, 'spread_length', -1.041, 0.1764),
  ('unknown', 1, 'spread_width', -1.629, 0.254),
  ('unknown', 1, 'tilt_deg', 89.45, 1.314),
  ('unknown', 1, 'width', -1.263, 0.273),
  ('unknown', 1, 'z_max', 0.3924, 0.0506),
  ('unknown', 1, 'z_min', -0.01459, 0.03226);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.03178, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'area_m2', -1.876, 0.3405),
  ('unknown', 2, 'aspect', 0.2481, 0.2333),
  ('unknown', 2, 'behind', 0.6698, 0.2037),
  ('unknown', 2, 'edge_free', 0.3931, 0.1244),
  ('unknown', 2, 'edge_free_top', 0.5226, 0.2871),
  ('unknown', 2, 'edge_joined', 0.3134, 0.2354),
  ('unknown', 2, 'edge_unseen', 0.008097, 0.03347),
  ('unknown', 2, 'height', 0.2394, 0.05683),
  ('unknown', 2, 'length', -0.4586, 0.1941),
  ('unknown', 2, 'rectangularity', 0.4541, 0.1326),
  ('unknown', 2, 'spread_length', -0.5907, 0.2139),
  ('unknown', 2, 'spread_width', -1.067, 0.2356),
  ('unknown', 2, 'tilt_deg', 89.02, 1.479),
  ('unknown', 2, 'width', -0.7158, 0.2187),
  ('unknown', 2, 'z_max', 0.5509, 0.1436),
  ('unknown', 2, 'z_min', -0.0104, 0.03356);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.02633, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'area_m2', -1.304, 0.155),
  ('unknown', 3, 'aspect', 1.719, 0.1554),
  ('unknown', 3, 'behind', 0.2705, 0.2844),
  ('unknown', 3, 'edge_free', 0.8818, 0.1356),
  ('unknown', 3, 'edge_free_top', 0.5604, 0.1308),
  ('unknown', 3, 'edge_joined', 0.1092, 0.129),
  ('unknown', 3, 'edge_unseen', 0.01201, 0.03221),
  ('unknown', 3, 'height', 2.523, 0.2778),
  ('unknown', 3, 'length', 0.2933, 0.111),
  ('unknown', 3, 'rectangularity', 0.8576, 0.04823),
  ('unknown', 3, 'spread_length', 0.2375, 0.1253),
  ('unknown', 3, 'spread_width', -1.553, 0.05172),
  ('unknown', 3, 'tilt_deg', 0.8393, 1.428),
  ('unknown', 3, 'width', -1.445, 0.1053),
  ('unknown', 3, 'z_max', 2.551, 0.2981),
  ('unknown', 3, 'z_min', 2.541, 0.292);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.02953, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'area_m2', -2.726, 0.3017),
  ('unknown', 4, 'aspect', 0.4699, 0.3607),
  ('unknown', 4, 'behind', 0.6005, 0.2044),
  ('unknown', 4, 'edge_free', 0.5941, 0.09048),
  ('unknown', 4, 'edge_free_top', 0.9744, 0.05085),
  ('unknown', 4, 'edge_joined', 0.08903, 0.1158),
  ('unknown', 4, 'edge_unseen', 0.005206, 0.03507),
  ('unknown', 4, 'height', 0.8595, 0.03411),
  ('unknown', 4, 'length', -1, 0.2663),
  ('unknown', 4, 'rectangularity', 0.7341, 0.1022),
  ('unknown', 4, 'spread_length', -1.273, 0.1436),
  ('unknown', 4, 'spread_width', -1.554, 0.2056),
  ('unknown', 4, 'tilt_deg', 84.43, 8.634),
  ('unknown', 4, 'width', -1.44, 0.2153),
  ('unknown', 4, 'z_max', 0.9679, 0.05435),
  ('unknown', 4, 'z_min', 0.7362, 0.03536);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.02785, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'area_m2', -1.281, 0.2518),
  ('unknown', 5, 'aspect', 1.641, 0.2303),
  ('unknown', 5, 'behind', 0.6496, 0.1582),
  ('unknown', 5, 'edge_free', 0.2354, 0.1919),
  ('unknown', 5, 'edge_free_top', 0.008109, 0.03005),
  ('unknown', 5, 'edge_joined', 0.4005, 0.3074),
  ('unknown', 5, 'edge_unseen', 0.01421, 0.03653),
  ('unknown', 5, 'height', 1.511, 0.07915),
  ('unknown', 5, 'length', 0.3263, 0.1247),
  ('unknown', 5, 'rectangularity', 0.785, 0.05792),
  ('unknown', 5, 'spread_length', 0.1486, 0.1056),
  ('unknown', 5, 'spread_width', -1.514, 0.2468),
  ('unknown', 5, 'tilt_deg', 89.85, 1.117),
  ('unknown', 5, 'width', -1.36, 0.2447),
  ('unknown', 5, 'z_max', 2.225, 0.1363),
  ('unknown', 5, 'z_min', 0.8265, 0.08384);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.03684, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'area_m2', -2.45, 0.2788),
  ('unknown', 6, 'aspect', 0.4137, 0.2397),
  ('unknown', 6, 'behind', 0.638, 0.1822),
  ('unknown', 6, 'edge_free', 0.406, 0.1754),
  ('unknown', 6, 'edge_free_top', 0.6125, 0.2557),
  ('unknown', 6, 'edge_joined', 0.3247, 0.2583),
  ('unknown', 6, 'edge_unseen', 0.00832, 0.03751),
  ('unknown', 6, 'height', 0.9201, 0.2022),
  ('unknown', 6, 'length', -0.8631, 0.1941),
  ('unknown', 6, 'rectangularity', 0.6602, 0.0461),
  ('unknown', 6, 'spread_length', -1.138, 0.1326),
  ('unknown', 6, 'spread_width', -1.408, 0.1563),
  ('unknown', 6, 'tilt_deg', 89.64, 0.7374),
  ('unknown', 6, 'width', -1.212, 0.16),
  ('unknown', 6, 'z_max', 1.111, 0.211),
  ('unknown', 6, 'z_min', 0.763, 0.209);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.02157, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'area_m2', -1.975, 0.5856),
  ('unknown', 7, 'aspect', 0.5059, 0.3778),
  ('unknown', 7, 'behind', 0.424, 0.1752),
  ('unknown', 7, 'edge_free', 0.8698, 0.2021),
  ('unknown', 7, 'edge_free_top', 0.9872, 0.0345),
  ('unknown', 7, 'edge_joined', 0.007221, 0.03),
  ('unknown', 7, 'edge_unseen', 0.1748, 0.1774),
  ('unknown', 7, 'height', 0.7055, 0.2174),
  ('unknown', 7, 'length', -0.5127, 0.3145),
  ('unknown', 7, 'rectangularity', 0.6463, 0.1173),
  ('unknown', 7, 'spread_length', -0.6657, 0.4005),
  ('unknown', 7, 'spread_width', -1.223, 0.3309),
  ('unknown', 7, 'tilt_deg', 84.61, 8.015),
  ('unknown', 7, 'width', -1.016, 0.3115),
  ('unknown', 7, 'z_max', 0.9357, 0.2516),
  ('unknown', 7, 'z_min', 0.4625, 0.1283);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.04748, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'area_m2', -2.084, 0.4469),
  ('unknown', 8, 'aspect', 1.197, 0.3723),
  ('unknown', 8, 'behind', 0.5913, 0.2049),
  ('unknown', 8, 'edge_free', 0.409, 0.2423),
  ('unknown', 8, 'edge_free_top', 0.2922, 0.2513),
  ('unknown', 8, 'edge_joined', 0.2802, 0.3358),
  ('unknown', 8, 'edge_unseen', 0.009601, 0.03413),
  ('unknown', 8, 'height', 0.4493, 0.1108),
  ('unknown', 8, 'length', -0.2298, 0.2538),
  ('unknown', 8, 'rectangularity', 0.6193, 0.205),
  ('unknown', 8, 'spread_length', -0.1824, 0.3539),
  ('unknown', 8, 'spread_width', -1.644, 0.4106),
  ('unknown', 8, 'tilt_deg', 88.77, 1.325),
  ('unknown', 8, 'width', -1.336, 0.4096),
  ('unknown', 8, 'z_max', 0.7218, 0.1684),
  ('unknown', 8, 'z_min', 0.2186, 0.1207);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.02681, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'area_m2', -0.7436, 0.521),
  ('unknown', 9, 'aspect', 0.2679, 0.1872),
  ('unknown', 9, 'behind', 0.5285, 0.1752),
  ('unknown', 9, 'edge_free', 0.4081, 0.203),
  ('unknown', 9, 'edge_free_top', 0.4573, 0.3028),
  ('unknown', 9, 'edge_joined', 0.2973, 0.2794),
  ('unknown', 9, 'edge_unseen', 0.00508, 0.03),
  ('unknown', 9, 'height', 0.4581, 0.125),
  ('unknown', 9, 'length', 0.009737, 0.1796),
  ('unknown', 9, 'rectangularity', 0.6421, 0.1911),
  ('unknown', 9, 'spread_length', -0.05199, 0.1807),
  ('unknown', 9, 'spread_width', -0.5688, 0.3144),
  ('unknown', 9, 'tilt_deg', 81.16, 3.823),
  ('unknown', 9, 'width', -0.2559, 0.1853),
  ('unknown', 9, 'z_max', 0.9309, 0.2086),
  ('unknown', 9, 'z_min', 0.004452, 0.04357);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.0181, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'area_m2', -1.513, 0.4548),
  ('unknown', 10, 'aspect', 1.645, 0.2724),
  ('unknown', 10, 'behind', 0.6593, 0.07263),
  ('unknown', 10, 'edge_free', 0.1526, 0.1623),
  ('unknown', 10, 'edge_free_top', 0.5607, 0.1301),
  ('unknown', 10, 'edge_joined', 0.7272, 0.2171),
  ('unknown', 10, 'edge_unseen', 0.03026, 0.05109),
  ('unknown', 10, 'height', 2.136, 0.1518),
  ('unknown', 10, 'length', 0.1985, 0.2714),
  ('unknown', 10, 'rectangularity', 0.7601, 0.0588),
  ('unknown', 10, 'spread_length', 0.06781, 0.3135),
  ('unknown', 10, 'spread_width', -1.563, 0.2226),
  ('unknown', 10, 'tilt_deg', 1.239, 2.021),
  ('unknown', 10, 'width', -1.447, 0.244),
  ('unknown', 10, 'z_max', 2.145, 0.1685),
  ('unknown', 10, 'z_min', 2.134, 0.1579);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.0443, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'area_m2', -2.645, 0.4325),
  ('unknown', 11, 'aspect', 0.3645, 0.2504),
  ('unknown', 11, 'behind', 0.2756, 0.2445),
  ('unknown', 11, 'edge_free', 0.6472, 0.1749),
  ('unknown', 11, 'edge_free_top', 0.561, 0.1266),
  ('unknown', 11, 'edge_joined', 0.3096, 0.1762),
  ('unknown', 11, 'edge_unseen', 0.003926, 0.03),
  ('unknown', 11, 'height', 0.8627, 0.1161),
  ('unknown', 11, 'length', -1.057, 0.1987),
  ('unknown', 11, 'rectangularity', 0.8225, 0.07678),
  ('unknown', 11, 'spread_length', -1.191, 0.1428),
  ('unknown', 11, 'spread_width', -1.512, 0.2367),
  ('unknown', 11, 'tilt_deg', 0.6631, 1.097),
  ('unknown', 11, 'width', -1.42, 0.2845),
  ('unknown', 11, 'z_max', 0.8629, 0.1211),
  ('unknown', 11, 'z_min', 0.8566, 0.1266);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.03268, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'area_m2', -0.7658, 0.4053),
  ('unknown', 12, 'aspect', 0.328, 0.1886),
  ('unknown', 12, 'behind', 0.5922, 0.1768),
  ('unknown', 12, 'edge_free', 0.7544, 0.1473),
  ('unknown', 12, 'edge_free_top', 0.9646, 0.06372),
  ('unknown', 12, 'edge_joined', 0.1325, 0.137),
  ('unknown', 12, 'edge_unseen', 0.1025, 0.1088),
  ('unknown', 12, 'height', 0.4876, 0.04956),
  ('unknown', 12, 'length', -0.08227, 0.2104),
  ('unknown', 12, 'rectangularity', 0.7337, 0.06514),
  ('unknown', 12, 'spread_length', -0.2605, 0.1907),
  ('unknown', 12, 'spread_width', -0.5969, 0.2511),
  ('unknown', 12, 'tilt_deg', 89.34, 1.615),
  ('unknown', 12, 'width', -0.3793, 0.2148),
  ('unknown', 12, 'z_max', 0.7385, 0.0585),
  ('unknown', 12, 'z_min', 0.05839, 0.08307);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.03052, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'area_m2', -1.926, 0.6591),
  ('unknown', 13, 'aspect', 0.4011, 0.3526),
  ('unknown', 13, 'behind', 0.04919, 0.09101),
  ('unknown', 13, 'edge_free', 0.03816, 0.07527),
  ('unknown', 13, 'edge_free_top', 0.04664, 0.07993),
  ('unknown', 13, 'edge_joined', 0.8504, 0.1831),
  ('unknown', 13, 'edge_unseen', 0.114, 0.1072),
  ('unknown', 13, 'height', 1.628, 0.1526),
  ('unknown', 13, 'length', -0.5997, 0.3536),
  ('unknown', 13, 'rectangularity', 0.7599, 0.0715),
  ('unknown', 13, 'spread_length', -0.8225, 0.3295),
  ('unknown', 13, 'spread_width', -1.327, 0.3466),
  ('unknown', 13, 'tilt_deg', 89.4, 1.247),
  ('unknown', 13, 'width', -1.044, 0.4256),
  ('unknown', 13, 'z_max', 1.902, 0.1811),
  ('unknown', 13, 'z_min', 1.335, 0.07395);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.02981, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'area_m2', -1.183, 0.324),
  ('unknown', 14, 'aspect', 0.4052, 0.3),
  ('unknown', 14, 'behind', 0.008024, 0.03),
  ('unknown', 14, 'edge_free', 0.01667, 0.03),
  ('unknown', 14, 'edge_free_top', 0.01687, 0.03362),
  ('unknown', 14, 'edge_joined', 0.9279, 0.08637),
  ('unknown', 14, 'edge_unseen', 0.009088, 0.0477),
  ('unknown', 14, 'height', 1.637, 0.08435),
  ('unknown', 14, 'length', -0.3235, 0.1699),
  ('unknown', 14, 'rectangularity', 0.8195, 0.05066),
  ('unknown', 14, 'spread_length', -0.4015, 0.1258),
  ('unknown', 14, 'spread_width', -0.9877, 0.249),
  ('unknown', 14, 'tilt_deg', 89.76, 1.141),
  ('unknown', 14, 'width', -0.7011, 0.3316),
  ('unknown', 14, 'z_max', 1.986, 0.1572),
  ('unknown', 14, 'z_min', 1.332, 0.06556);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.03784, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'area_m2', -0.8036, 0.3337),
  ('unknown', 15, 'aspect', 1.259, 0.2603),
  ('unknown', 15, 'behind', 0.5364, 0.2048),
  ('unknown', 15, 'edge_free', 0.4511, 0.1806),
  ('unknown', 15, 'edge_free_top', 0.5494, 0.349),
  ('unknown', 15, 'edge_joined', 0.2992, 0.2982),
  ('unknown', 15, 'edge_unseen', 0.01166, 0.03452),
  ('unknown', 15, 'height', 0.9396, 0.1277),
  ('unknown', 15, 'length', 0.4829, 0.2316),
  ('unknown', 15, 'rectangularity', 0.6569, 0.1184),
  ('unknown', 15, 'spread_length', 0.3328, 0.2586),
  ('unknown', 15, 'spread_width', -1.067, 0.3461),
  ('unknown', 15, 'tilt_deg', 89.3, 1.521),
  ('unknown', 15, 'width', -0.8504, 0.2375),
  ('unknown', 15, 'z_max', 1.212, 0.1743),
  ('unknown', 15, 'z_min', 0.6421, 0.1231);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.02821, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'area_m2', -2.811, 0.1872),
  ('unknown', 16, 'aspect', 0.3216, 0.1622),
  ('unknown', 16, 'behind', 0.3289, 0.2),
  ('unknown', 16, 'edge_free', 0.05027, 0.09331),
  ('unknown', 16, 'edge_free_top', 0.5598, 0.1297),
  ('unknown', 16, 'edge_joined', 0.8567, 0.1108),
  ('unknown', 16, 'edge_unseen', 0.004432, 0.03),
  ('unknown', 16, 'height', 0.7456, 0.06382),
  ('unknown', 16, 'length', -1.151, 0.1434),
  ('unknown', 16, 'rectangularity', 0.8238, 0.0685),
  ('unknown', 16, 'spread_length', -1.288, 0.113),
  ('unknown', 16, 'spread_width', -1.558, 0.07081),
  ('unknown', 16, 'tilt_deg', 0.4536, 1.008),
  ('unknown', 16, 'width', -1.481, 0.0957),
  ('unknown', 16, 'z_max', 0.7388, 0.06027),
  ('unknown', 16, 'z_min', 0.7336, 0.05605);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.01326, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'area_m2', -3.116, 0.3154),
  ('unknown', 17, 'aspect', 0.5191, 0.2133),
  ('unknown', 17, 'behind', 0.5185, 0.2979),
  ('unknown', 17, 'edge_free', 0.4142, 0.22),
  ('unknown', 17, 'edge_free_top', 0.4719, 0.423),
  ('unknown', 17, 'edge_joined', 0.1555, 0.1786),
  ('unknown', 17, 'edge_unseen', 0.002599, 0.0313),
  ('unknown', 17, 'height', 0.3699, 0.1992),
  ('unknown', 17, 'length', -1.151, 0.3023),
  ('unknown', 17, 'rectangularity', 0.7643, 0.07491),
  ('unknown', 17, 'spread_length', -1.302, 0.2042),
  ('unknown', 17, 'spread_width', -1.829, 0.1997),
  ('unknown', 17, 'tilt_deg', 87.29, 3.138),
  ('unknown', 17, 'width', -1.629, 0.2332),
  ('unknown', 17, 'z_max', 0.5109, 0.2363),
  ('unknown', 17, 'z_min', 0.2122, 0.1532);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.03696, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'area_m2', -1.263, 0.4512),
  ('unknown', 18, 'aspect', 0.4959, 0.2871),
  ('unknown', 18, 'behind', 0.3575, 0.1203),
  ('unknown', 18, 'edge_free', 0.48, 0.2666),
  ('unknown', 18, 'edge_free_top', 0.5714, 0.2514),
  ('unknown', 18, 'edge_joined', 0.2492, 0.2268),
  ('unknown', 18, 'edge_unseen', 0.0982, 0.1027),
  ('unknown', 18, 'height', 1.002, 0.3574),
  ('unknown', 18, 'length', -0.1575, 0.226),
  ('unknown', 18, 'rectangularity', 0.6421, 0.107),
  ('unknown', 18, 'spread_length', -0.2593, 0.2974),
  ('unknown', 18, 'spread_width', -0.9518, 0.3607),
  ('unknown', 18, 'tilt_deg', 87.41, 1.03),
  ('unknown', 18, 'width', -0.629, 0.2822),
  ('unknown', 18, 'z_max', 1.458, 0.3735),
  ('unknown', 18, 'z_min', 0.5764, 0.3101);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.01173, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'area_m2', -1.87, 0.2121),
  ('unknown', 19, 'aspect', 0.4271, 0.2574),
  ('unknown', 19, 'behind', 0.6407, 0.2594),
  ('unknown', 19, 'edge_free', 0.4304, 0.1378),
  ('unknown', 19, 'edge_free_top', 0.6217, 0.2133),
  ('unknown', 19, 'edge_joined', 0.2503, 0.1359),
  ('unknown', 19, 'edge_unseen', 0.001396, 0.03),
  ('unknown', 19, 'height', 0.973, 0.2798),
  ('unknown', 19, 'length', -0.5334, 0.154),
  ('unknown', 19, 'rectangularity', 0.6652, 0.08204),
  ('unknown', 19, 'spread_length', -0.825, 0.1248),
  ('unknown', 19, 'spread_width', -1.176, 0.212),
  ('unknown', 19, 'tilt_deg', 88.45, 3.395),
  ('unknown', 19, 'width', -0.9336, 0.1622),
  ('unknown', 19, 'z_max', 1.294, 0.2937),
  ('unknown', 19, 'z_min', 0.7217, 0.2711);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.01741, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'area_m2', -2.328, 0.3924),
  ('unknown', 20, 'aspect', 0.4977, 0.2248),
  ('unknown', 20, 'behind', 0.7387, 0.07024),
  ('unknown', 20, 'edge_free', 0.699, 0.1835),
  ('unknown', 20, 'edge_free_top', 0.5599, 0.1306),
  ('unknown', 20, 'edge_joined', 0.2792, 0.1),
  ('unknown', 20, 'edge_unseen', 0.001306, 0.03),
  ('unknown', 20, 'height', 0.3982, 0.1124),
  ('unknown', 20, 'length', -0.838, 0.2197),
  ('unknown', 20, 'rectangularity', 0.8049, 0.1054),
  ('unknown', 20, 'spread_length', -0.966, 0.1375),
  ('unknown', 20, 'spread_width', -1.51, 0.1366),
  ('unknown', 20, 'tilt_deg', 0.678, 1.495),
  ('unknown', 20, 'width', -1.27, 0.3031),
  ('unknown', 20, 'z_max', 0.3848, 0.1086),
  ('unknown', 20, 'z_min', 0.3579, 0.05666);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.02007, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'area_m2', -3.092, 0.3751),
  ('unknown', 21, 'aspect', 0.3533, 0.2784),
  ('unknown', 21, 'behind', 0.4419, 0.2338),
  ('unknown', 21, 'edge_free', 0.6617, 0.1117),
  ('unknown', 21, 'edge_free_top', 0.991, 0.03),
  ('unknown', 21, 'edge_joined', 0.02883, 0.04494),
  ('unknown', 21, 'edge_unseen', 0.003659, 0.03),
  ('unknown', 21, 'height', 1.442, 0.3712),
  ('unknown', 21, 'length', -1.264, 0.2415),
  ('unknown', 21, 'rectangularity', 0.7952, 0.117),
  ('unknown', 21, 'spread_length', -1.383, 0.1732),
  ('unknown', 21, 'spread_width', -1.716, 0.1966),
  ('unknown', 21, 'tilt_deg', 89.05, 1.739),
  ('unknown', 21, 'width', -1.595, 0.2327),
  ('unknown', 21, 'z_max', 1.548, 0.363),
  ('unknown', 21, 'z_min', 1.287, 0.3512);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.02525, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'area_m2', -1.566, 0.391),
  ('unknown', 22, 'aspect', 1.661, 0.3021),
  ('unknown', 22, 'behind', 0.6296, 0.1419),
  ('unknown', 22, 'edge_free', 0.07883, 0.1254),
  ('unknown', 22, 'edge_free_top', 0.5606, 0.1307),
  ('unknown', 22, 'edge_joined', 0.851, 0.1535),
  ('unknown', 22, 'edge_unseen', 0.06793, 0.09874),
  ('unknown', 22, 'height', 0.8712, 0.09648),
  ('unknown', 22, 'length', 0.203, 0.2994),
  ('unknown', 22, 'rectangularity', 0.7498, 0.07195),
  ('unknown', 22, 'spread_length', 0.1147, 0.3745),
  ('unknown', 22, 'spread_width', -1.577, 0.2628),
  ('unknown', 22, 'tilt_deg', 1.664, 1.995),
  ('unknown', 22, 'width', -1.469, 0.2003),
  ('unknown', 22, 'z_max', 0.8703, 0.09894),
  ('unknown', 22, 'z_min', 0.8597, 0.1054);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.05251, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'area_m2', -1.507, 0.4102),
  ('unknown', 23, 'aspect', 0.6451, 0.3693),
  ('unknown', 23, 'behind', 0.739, 0.09261),
  ('unknown', 23, 'edge_free', 0.2683, 0.1218),
  ('unknown', 23, 'edge_free_top', 0.5509, 0.1207),
  ('unknown', 23, 'edge_joined', 0.58, 0.2535),
  ('unknown', 23, 'edge_unseen', 0.04694, 0.07754),
  ('unknown', 23, 'height', 1.003, 0.3472),
  ('unknown', 23, 'length', -0.1909, 0.3047),
  ('unknown', 23, 'rectangularity', 0.6613, 0.1225),
  ('unknown', 23, 'spread_length', -0.3298, 0.3382),
  ('unknown', 23, 'spread_width', -0.994, 0.2993),
  ('unknown', 23, 'tilt_deg', 4.481, 1.237),
  ('unknown', 23, 'width', -0.9089, 0.1836),
  ('unknown', 23, 'z_max', 1.08, 0.3693),
  ('unknown', 23, 'z_min', 1.009, 0.3612);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.02358, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'area_m2', -2.562, 0.3579),
  ('unknown', 24, 'aspect', 0.4866, 0.3077),
  ('unknown', 24, 'behind', 0.6425, 0.2336),
  ('unknown', 24, 'edge_free', 0.4438, 0.1509),
  ('unknown', 24, 'edge_free_top', 0.6604, 0.2334),
  ('unknown', 24, 'edge_joined', 0.3025, 0.1851),
  ('unknown', 24, 'edge_unseen', 0.005293, 0.03),
  ('unknown', 24, 'height', 1.691, 0.2497),
  ('unknown', 24, 'length', -0.826, 0.2632),
  ('unknown', 24, 'rectangularity', 0.63, 0.1017),
  ('unknown', 24, 'spread_length', -1.105, 0.2347),
  ('unknown', 24, 'spread_width', -1.553, 0.2063),
  ('unknown', 24, 'tilt_deg', 88.68, 2.079),
  ('unknown', 24, 'width', -1.297, 0.2322),
  ('unknown', 24, 'z_max', 1.877, 0.2777),
  ('unknown', 24, 'z_min', 1.467, 0.2623);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.02377, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'area_m2', -0.3047, 0.2188),
  ('unknown', 25, 'aspect', 0.557, 0.2035),
  ('unknown', 25, 'behind', 0.448, 0.05518),
  ('unknown', 25, 'edge_free', 0.9201, 0.08672),
  ('unknown', 25, 'edge_free_top', 0.9861, 0.04769),
  ('unknown', 25, 'edge_joined', 0.02246, 0.03781),
  ('unknown', 25, 'edge_unseen', 0.001734, 0.03),
  ('unknown', 25, 'height', 0.4878, 0.03717),
  ('unknown', 25, 'length', 0.1673, 0.1986),
  ('unknown', 25, 'rectangularity', 0.8827, 0.06485),
  ('unknown', 25, 'spread_length', 0.1383, 0.2014),
  ('unknown', 25, 'spread_width', -0.4538, 0.07271),
  ('unknown', 25, 'tilt_deg', 89.73, 1.387),
  ('unknown', 25, 'width', -0.3589, 0.1263),
  ('unknown', 25, 'z_max', 0.7845, 0.06946),
  ('unknown', 25, 'z_min', 0.08799, 0.0522);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.02216, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'area_m2', -2.848, 0.4427),
  ('unknown', 26, 'aspect', 0.6114, 0.2623),
  ('unknown', 26, 'behind', 0.3335, 0.1904),
  ('unknown', 26, 'edge_free', 0.4686, 0.2639),
  ('unknown', 26, 'edge_free_top', 0.5016, 0.4031),
  ('unknown', 26, 'edge_joined', 0.2378, 0.2345),
  ('unknown', 26, 'edge_unseen', 0.2051, 0.1521),
  ('unknown', 26, 'height', 0.2105, 0.1317),
  ('unknown', 26, 'length', -0.9471, 0.2965),
  ('unknown', 26, 'rectangularity', 0.6974, 0.1332),
  ('unknown', 26, 'spread_length', -1.109, 0.3488),
  ('unknown', 26, 'spread_width', -1.786, 0.2682),
  ('unknown', 26, 'tilt_deg', 43.3, 36.76),
  ('unknown', 26, 'width', -1.512, 0.2179),
  ('unknown', 26, 'z_max', 0.2616, 0.1803),
  ('unknown', 26, 'z_min', 0.1094, 0.1012);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.02129, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'area_m2', -2.092, 0.5521),
  ('unknown', 27, 'aspect', 1.043, 0.4397),
  ('unknown', 27, 'behind', 0.257, 0.2766),
  ('unknown', 27, 'edge_free', 0.9862, 0.03053),
  ('unknown', 27, 'edge_free_top', 0.5607, 0.1311),
  ('unknown', 27, 'edge_joined', 0.0118, 0.03),
  ('unknown', 27, 'edge_unseen', 0.2201, 0.118),
  ('unknown', 27, 'height', 2.516, 0.2625),
  ('unknown', 27, 'length', -0.371, 0.4777),
  ('unknown', 27, 'rectangularity', 0.7894, 0.09502),
  ('unknown', 27, 'spread_length', -0.5284, 0.488),
  ('unknown', 27, 'spread_width', -1.613, 0.09029),
  ('unknown', 27, 'tilt_deg', 1.297, 1.838),
  ('unknown', 27, 'width', -1.496, 0.0964),
  ('unknown', 27, 'z_max', 2.55, 0.255),
  ('unknown', 27, 'z_min', 2.544, 0.2486);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.008807, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'area_m2', -3.291, 0.2727),
  ('unknown', 28, 'aspect', 0.4178, 0.3028),
  ('unknown', 28, 'behind', 0.3505, 0.3084),
  ('unknown', 28, 'edge_free', 0.4044, 0.2858),
  ('unknown', 28, 'edge_free_top', 0.5791, 0.3804),
  ('unknown', 28, 'edge_joined', 0.3844, 0.333),
  ('unknown', 28, 'edge_unseen', 0.1693, 0.1621),
  ('unknown', 28, 'height', 0.933, 0.1987),
  ('unknown', 28, 'length', -1.299, 0.2104),
  ('unknown', 28, 'rectangularity', 0.7612, 0.09275),
  ('unknown', 28, 'spread_length', -1.433, 0.1697),
  ('unknown', 28, 'spread_width', -1.893, 0.1845),
  ('unknown', 28, 'tilt_deg', 51.4, 40.74),
  ('unknown', 28, 'width', -1.704, 0.1866),
  ('unknown', 28, 'z_max', 0.9994, 0.2199),
  ('unknown', 28, 'z_min', 0.8514, 0.206);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.01979, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'area_m2', -3.646, 0.2656),
  ('unknown', 29, 'aspect', 0.2039, 0.1574),
  ('unknown', 29, 'behind', 0.2782, 0.1991),
  ('unknown', 29, 'edge_free', 0.3654, 0.3439),
  ('unknown', 29, 'edge_free_top', 0.5607, 0.1289),
  ('unknown', 29, 'edge_joined', 0.5527, 0.3467),
  ('unknown', 29, 'edge_unseen', -0.0002426, 0.03),
  ('unknown', 29, 'height', 0.7944, 0.07594),
  ('unknown', 29, 'length', -1.581, 0.1731),
  ('unknown', 29, 'rectangularity', 0.7713, 0.06168),
  ('unknown', 29, 'spread_length', -1.708, 0.1741),
  ('unknown', 29, 'spread_width', -1.906, 0.1237),
  ('unknown', 29, 'tilt_deg', 5.316, 7.096),
  ('unknown', 29, 'width', -1.807, 0.1375),
  ('unknown', 29, 'z_max', 0.8017, 0.08101),
  ('unknown', 29, 'z_min', 0.7768, 0.07021);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.01716, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'area_m2', 3.456, 0.6881),
  ('unknown', 30, 'aspect', 0.3506, 0.2493),
  ('unknown', 30, 'behind', 0.003654, 0.03),
  ('unknown', 30, 'edge_free', 0.006125, 0.03),
  ('unknown', 30, 'edge_free_top', 0.007024, 0.03),
  ('unknown', 30, 'edge_joined', 0.06249, 0.09991),
  ('unknown', 30, 'edge_unseen', 0.1132, 0.1477),
  ('unknown', 30, 'height', 2.276, 0.9636),
  ('unknown', 30, 'length', 1.988, 0.3382),
  ('unknown', 30, 'rectangularity', 0.8451, 0.1353),
  ('unknown', 30, 'spread_length', 1.932, 0.338),
  ('unknown', 30, 'spread_width', 1.569, 0.3507),
  ('unknown', 30, 'tilt_deg', 89.8, 1.722),
  ('unknown', 30, 'width', 1.635, 0.3914),
  ('unknown', 30, 'z_max', 6.19, 2.15),
  ('unknown', 30, 'z_min', -1.098, 1.393);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.01436, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'area_m2', -2.526, 0.2344),
  ('unknown', 31, 'aspect', 0.5734, 0.2209),
  ('unknown', 31, 'behind', 0.5511, 0.1999),
  ('unknown', 31, 'edge_free', 0.3118, 0.2417),
  ('unknown', 31, 'edge_free_top', 0.5867, 0.3477),
  ('unknown', 31, 'edge_joined', 0.4967, 0.316),
  ('unknown', 31, 'edge_unseen', 0.185, 0.134),
  ('unknown', 31, 'height', 0.8421, 0.1685),
  ('unknown', 31, 'length', -0.7878, 0.1797),
  ('unknown', 31, 'rectangularity', 0.6551, 0.07184),
  ('unknown', 31, 'spread_length', -1.014, 0.1852),
  ('unknown', 31, 'spread_width', -1.544, 0.1652),
  ('unknown', 31, 'tilt_deg', 43.71, 38.5),
  ('unknown', 31, 'width', -1.322, 0.1749),
  ('unknown', 31, 'z_max', 0.8959, 0.1239),
  ('unknown', 31, 'z_min', 0.7274, 0.2066);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.0122, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'area_m2', -1.734, 0.469),
  ('unknown', 32, 'aspect', 1.504, 0.3186),
  ('unknown', 32, 'behind', 0.4281, 0.2497),
  ('unknown', 32, 'edge_free', 0.1994, 0.1871),
  ('unknown', 32, 'edge_free_top', 0.1838, 0.2163),
  ('unknown', 32, 'edge_joined', 0.3471, 0.3298),
  ('unknown', 32, 'edge_unseen', 0.1813, 0.1543),
  ('unknown', 32, 'height', 1.41, 0.1329),
  ('unknown', 32, 'length', 0.07639, 0.2497),
  ('unknown', 32, 'rectangularity', 0.7254, 0.1393),
  ('unknown', 32, 'spread_length', -0.2989, 0.2048),
  ('unknown', 32, 'spread_width', -1.692, 0.2738),
  ('unknown', 32, 'tilt_deg', 89.44, 2.113),
  ('unknown', 32, 'width', -1.468, 0.3121),
  ('unknown', 32, 'z_max', 1.946, 0.24),
  ('unknown', 32, 'z_min', 0.9091, 0.1567);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.03, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'area_m2', 1.874, 0.5569),
  ('unknown', 33, 'aspect', 0.5441, 0.5581),
  ('unknown', 33, 'behind', 0.01021, 0.03387),
  ('unknown', 33, 'edge_free', 0.007895, 0.03125),
  ('unknown', 33, 'edge_free_top', 0.009247, 0.03),
  ('unknown', 33, 'edge_joined', 0.1049, 0.1708),
  ('unknown', 33, 'edge_unseen', 0.03077, 0.06979),
  ('unknown', 33, 'height', 1.322, 0.884),
  ('unknown', 33, 'length', 1.335, 0.4145),
  ('unknown', 33, 'rectangularity', 0.8642, 0.1304),
  ('unknown', 33, 'spread_length', 1.458, 0.3762),
  ('unknown', 33, 'spread_width', 0.7473, 0.3479),
  ('unknown', 33, 'tilt_deg', 89.61, 1.126),
  ('unknown', 33, 'width', 0.7284, 0.4069),
  ('unknown', 33, 'z_max', 2.787, 1.77),
  ('unknown', 33, 'z_min', -0.4648, 0.6819);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.01105, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'area_m2', -1.795, 0.2468),
  ('unknown', 34, 'aspect', 0.1784, 0.1409),
  ('unknown', 34, 'behind', 0.2739, 0.1153),
  ('unknown', 34, 'edge_free', 0.8157, 0.1198),
  ('unknown', 34, 'edge_free_top', 0.5605, 0.1306),
  ('unknown', 34, 'edge_joined', 0.01661, 0.03203),
  ('unknown', 34, 'edge_unseen', 0.001627, 0.03),
  ('unknown', 34, 'height', 0.109, 0.04821),
  ('unknown', 34, 'length', -0.546, 0.1315),
  ('unknown', 34, 'rectangularity', 0.5964, 0.07294),
  ('unknown', 34, 'spread_length', -0.7644, 0.08069),
  ('unknown', 34, 'spread_width', -0.9794, 0.1384),
  ('unknown', 34, 'tilt_deg', 1.137, 2.441),
  ('unknown', 34, 'width', -0.7288, 0.1756),
  ('unknown', 34, 'z_max', 0.113, 0.05935),
  ('unknown', 34, 'z_min', 0.104, 0.04498);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.01589, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'area_m2', -0.5393, 0.3308),
  ('unknown', 35, 'aspect', 0.4781, 0.1031),
  ('unknown', 35, 'behind', 0.04366, 0.06672),
  ('unknown', 35, 'edge_free', 0.9071, 0.1028),
  ('unknown', 35, 'edge_free_top', 0.9757, 0.04848),
  ('unknown', 35, 'edge_joined', 0.03173, 0.05649),
  ('unknown', 35, 'edge_unseen', 0.09855, 0.1275),
  ('unknown', 35, 'height', 1.645, 0.1259),
  ('unknown', 35, 'length', 0.02812, 0.2138),
  ('unknown', 35, 'rectangularity', 0.8659, 0.09651),
  ('unknown', 35, 'spread_length', -0.03931, 0.199),
  ('unknown', 35, 'spread_width', -0.5421, 0.139),
  ('unknown', 35, 'tilt_deg', 89.5, 2.05),
  ('unknown', 35, 'width', -0.3856, 0.1233),
  ('unknown', 35, 'z_max', 2.028, 0.1505),
  ('unknown', 35, 'z_min', 1.37, 0.08913);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.007965, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'area_m2', -2.758, 0.5158),
  ('unknown', 36, 'aspect', 0.7024, 0.374),
  ('unknown', 36, 'behind', 0.4656, 0.2507),
  ('unknown', 36, 'edge_free', 0.4137, 0.2766),
  ('unknown', 36, 'edge_free_top', 0.8936, 0.1247),
  ('unknown', 36, 'edge_joined', 0.3314, 0.2538),
  ('unknown', 36, 'edge_unseen', 0.222, 0.1595),
  ('unknown', 36, 'height', 2.129, 0.1784),
  ('unknown', 36, 'length', -0.8313, 0.3718),
  ('unknown', 36, 'rectangularity', 0.6939, 0.1087),
  ('unknown', 36, 'spread_length', -1.027, 0.3341),
  ('unknown', 36, 'spread_width', -1.747, 0.2441),
  ('unknown', 36, 'tilt_deg', 15.38, 27.6),
  ('unknown', 36, 'width', -1.548, 0.2245),
  ('unknown', 36, 'z_max', 2.161, 0.1572),
  ('unknown', 36, 'z_min', 2.109, 0.1921);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.02694, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'area_m2', 0.3673, 0.7363),
  ('unknown', 37, 'aspect', 0.487, 0.1962),
  ('unknown', 37, 'behind', 0.268, 0.3211),
  ('unknown', 37, 'edge_free', 0.3497, 0.2368),
  ('unknown', 37, 'edge_free_top', 0.3775, 0.3134),
  ('unknown', 37, 'edge_joined', 0.5664, 0.1898),
  ('unknown', 37, 'edge_unseen', 0.03146, 0.08128),
  ('unknown', 37, 'height', 1.281, 0.3823),
  ('unknown', 37, 'length', 0.7938, 0.2922),
  ('unknown', 37, 'rectangularity', 0.5199, 0.2133),
  ('unknown', 37, 'spread_length', 0.6451, 0.2707),
  ('unknown', 37, 'spread_width', 0.1931, 0.2291),
  ('unknown', 37, 'tilt_deg', 82.05, 18.36),
  ('unknown', 37, 'width', 0.2766, 0.3673),
  ('unknown', 37, 'z_max', 2.195, 0.2928),
  ('unknown', 37, 'z_min', 0.1155, 0.2103);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.01115, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'area_m2', -1.108, 0.57),
  ('unknown', 38, 'aspect', 1.501, 0.5104),
  ('unknown', 38, 'behind', 0.6471, 0.1165),
  ('unknown', 38, 'edge_free', 0.4622, 0.2281),
  ('unknown', 38, 'edge_free_top', 0.1229, 0.2227),
  ('unknown', 38, 'edge_joined', 0.3815, 0.2729),
  ('unknown', 38, 'edge_unseen', 0.08025, 0.08675),
  ('unknown', 38, 'height', 2.631, 0.4082),
  ('unknown', 38, 'length', 0.4108, 0.4135),
  ('unknown', 38, 'rectangularity', 0.6545, 0.1594),
  ('unknown', 38, 'spread_length', 0.3701, 0.4233),
  ('unknown', 38, 'spread_width', -1.436, 0.3273),
  ('unknown', 38, 'tilt_deg', 48.5, 41.68),
  ('unknown', 38, 'width', -1.046, 0.3124),
  ('unknown', 38, 'z_max', 2.781, 0.4797),
  ('unknown', 38, 'z_min', 2.606, 0.3387);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.005541, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'area_m2', 2.502, 0.7446),
  ('unknown', 39, 'aspect', 1.438, 0.5733),
  ('unknown', 39, 'behind', 0.02228, 0.04236),
  ('unknown', 39, 'edge_free', 0.04034, 0.05378),
  ('unknown', 39, 'edge_free_top', 0.06766, 0.1226),
  ('unknown', 39, 'edge_joined', 0.2727, 0.2029),
  ('unknown', 39, 'edge_unseen', 0.1296, 0.123),
  ('unknown', 39, 'height', 2.843, 0.9841),
  ('unknown', 39, 'length', 2.118, 0.2382),
  ('unknown', 39, 'rectangularity', 0.7193, 0.1198),
  ('unknown', 39, 'spread_length', 2.026, 0.2435),
  ('unknown', 39, 'spread_width', 0.6455, 0.5997),
  ('unknown', 39, 'tilt_deg', 89.33, 3.314),
  ('unknown', 39, 'width', 0.7011, 0.6305),
  ('unknown', 39, 'z_max', 7.595, 1.536),
  ('unknown', 39, 'z_min', -1.145, 1.476);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.0009653, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'area_m2', 0.1407, 0.6421),
  ('unknown', 40, 'aspect', 2.1, 0.3888),
  ('unknown', 40, 'behind', 0.1318, 0.1259),
  ('unknown', 40, 'edge_free', 0.07808, 0.08624),
  ('unknown', 40, 'edge_free_top', 0.1757, 0.1808),
  ('unknown', 40, 'edge_joined', 0.1969, 0.2372),
  ('unknown', 40, 'edge_unseen', 0.3825, 0.1416),
  ('unknown', 40, 'height', 1.34, 0.2213),
  ('unknown', 40, 'length', 1.298, 0.4816),
  ('unknown', 40, 'rectangularity', 0.6902, 0.06529),
  ('unknown', 40, 'spread_length', 1.173, 0.5056),
  ('unknown', 40, 'spread_width', -0.9002, 0.2982),
  ('unknown', 40, 'tilt_deg', 86.6, 7.919),
  ('unknown', 40, 'width', -0.7827, 0.2749),
  ('unknown', 40, 'z_max', 3.589, 1.275),
  ('unknown', 40, 'z_min', -0.9231, 1.019);

-- floor: 500 examples
UPDATE object_class SET prior = 0.05041 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.303, 1.59)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4616, 0.3685)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_joined', 0.2498, 0.1583)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_unseen', 0.2539, 0.1398)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.001202, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.168, 0.7388)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5846, 0.1284)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.9042, 0.6718)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.3189, 0.8381)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.5569, 0.9475)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.7007, 0.9264)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.007368, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.004965, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'floor';
DELETE FROM class_density WHERE class = 'floor';
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.1947, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'area_m2', 2.661, 0.2068),
  ('floor', 1, 'aspect', 0.2761, 0.1605),
  ('floor', 1, 'behind', -0.0003481, 0.03146),
  ('floor', 1, 'edge_free', -7.906e-05, 0.03068),
  ('floor', 1, 'edge_free_top', 6.905e-05, 0.3181),
  ('floor', 1, 'edge_joined', 0.3119, 0.1123),
  ('floor', 1, 'edge_unseen', 0.1894, 0.1287),
  ('floor', 1, 'height', 0.0003306, 0.02258),
  ('floor', 1, 'length', 1.724, 0.1412),
  ('floor', 1, 'rectangularity', 0.6056, 0.103),
  ('floor', 1, 'spread_length', 1.392, 0.1164),
  ('floor', 1, 'spread_width', 0.9849, 0.1306),
  ('floor', 1, 'tilt_deg', 0.007725, 0.456),
  ('floor', 1, 'width', 1.453, 0.131),
  ('floor', 1, 'z_max', 0.0004651, 0.02263),
  ('floor', 1, 'z_min', 0.0002821, 0.02306);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.159, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'area_m2', 2.219, 0.1935),
  ('floor', 2, 'aspect', 0.1676, 0.1088),
  ('floor', 2, 'behind', -0.0003441, 0.03071),
  ('floor', 2, 'edge_free', -2.989e-05, 0.03028),
  ('floor', 2, 'edge_free_top', 7.979e-05, 0.3175),
  ('floor', 2, 'edge_joined', 0.3167, 0.09756),
  ('floor', 2, 'edge_unseen', 0.1825, 0.08016),
  ('floor', 2, 'height', 0.0008141, 0.0225),
  ('floor', 2, 'length', 1.413, 0.1024),
  ('floor', 2, 'rectangularity', 0.6498, 0.08211),
  ('floor', 2, 'spread_length', 1.153, 0.1027),
  ('floor', 2, 'spread_width', 0.8422, 0.121),
  ('floor', 2, 'tilt_deg', 0.02881, 0.451),
  ('floor', 2, 'width', 1.247, 0.1176),
  ('floor', 2, 'z_max', 0.001437, 0.0225),
  ('floor', 2, 'z_min', -0.0001337, 0.02289);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.07855, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'area_m2', -1.334, 0.5396),
  ('floor', 3, 'aspect', 0.896, 0.5057),
  ('floor', 3, 'behind', -0.004868, 0.03),
  ('floor', 3, 'edge_free', -0.0009192, 0.03),
  ('floor', 3, 'edge_free_top', -0.001202, 0.3175),
  ('floor', 3, 'edge_joined', 0.3033, 0.2612),
  ('floor', 3, 'edge_unseen', 0.3516, 0.1432),
  ('floor', 3, 'height', 0.004035, 0.0225),
  ('floor', 3, 'length', -0.05082, 0.3994),
  ('floor', 3, 'rectangularity', 0.6658, 0.1128),
  ('floor', 3, 'spread_length', -0.1547, 0.3925),
  ('floor', 3, 'spread_width', -1.098, 0.2838),
  ('floor', 3, 'tilt_deg', 1.842, 0.9771),
  ('floor', 3, 'width', -0.8808, 0.2524),
  ('floor', 3, 'z_max', 0.01331, 0.0225),
  ('floor', 3, 'z_min', -0.00872, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.1227, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'area_m2', 1.648, 0.3328),
  ('floor', 4, 'aspect', 0.4614, 0.2511),
  ('floor', 4, 'behind', -0.0003287, 0.03121),
  ('floor', 4, 'edge_free', -0.0001771, 0.03013),
  ('floor', 4, 'edge_free_top', -0.000244, 0.3183),
  ('floor', 4, 'edge_joined', 0.202, 0.1035),
  ('floor', 4, 'edge_unseen', 0.2317, 0.05912),
  ('floor', 4, 'height', -1.119e-05, 0.02263),
  ('floor', 4, 'length', 1.369, 0.1528),
  ('floor', 4, 'rectangularity', 0.545, 0.1133),
  ('floor', 4, 'spread_length', 1.125, 0.1401),
  ('floor', 4, 'spread_width', 0.5428, 0.1631),
  ('floor', 4, 'tilt_deg', 0.04127, 0.4544),
  ('floor', 4, 'width', 0.9119, 0.1895),
  ('floor', 4, 'z_max', 0.0009518, 0.02273),
  ('floor', 4, 'z_min', -0.000701, 0.02305);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.0802, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'area_m2', 0.05721, 0.3803),
  ('floor', 5, 'aspect', 0.705, 0.402),
  ('floor', 5, 'behind', -0.003574, 0.03),
  ('floor', 5, 'edge_free', -0.0005994, 0.03),
  ('floor', 5, 'edge_free_top', -0.001068, 0.3175),
  ('floor', 5, 'edge_joined', 0.1829, 0.1518),
  ('floor', 5, 'edge_unseen', 0.3483, 0.1405),
  ('floor', 5, 'height', 0.005434, 0.02438),
  ('floor', 5, 'length', 0.6304, 0.2382),
  ('floor', 5, 'rectangularity', 0.6013, 0.1381),
  ('floor', 5, 'spread_length', 0.4916, 0.1526),
  ('floor', 5, 'spread_width', -0.3076, 0.2501),
  ('floor', 5, 'tilt_deg', 1.514, 0.8322),
  ('floor', 5, 'width', -0.04216, 0.2676),
  ('floor', 5, 'z_max', 0.02716, 0.0283),
  ('floor', 5, 'z_min', -0.01408, 0.02714);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'area_m2', 2.155, 0.2411),
  ('floor', 6, 'aspect', 0.2364, 0.1418),
  ('floor', 6, 'behind', -7.973e-05, 0.03059),
  ('floor', 6, 'edge_free', -1.115e-05, 0.03015),
  ('floor', 6, 'edge_free_top', 8.827e-05, 0.3167),
  ('floor', 6, 'edge_joined', 0.1914, 0.06077),
  ('floor', 6, 'edge_unseen', 0.2317, 0.1022),
  ('floor', 6, 'height', 2.554e-05, 0.02252),
  ('floor', 6, 'length', 1.635, 0.1268),
  ('floor', 6, 'rectangularity', 0.4211, 0.06787),
  ('floor', 6, 'spread_length', 1.299, 0.1447),
  ('floor', 6, 'spread_width', 0.8114, 0.1315),
  ('floor', 6, 'tilt_deg', 0.01896, 0.4514),
  ('floor', 6, 'width', 1.4, 0.1441),
  ('floor', 6, 'z_max', 0.0003924, 0.02253),
  ('floor', 6, 'z_min', -0.0004201, 0.02264);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.1052, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'area_m2', 2.16, 0.305),
  ('floor', 7, 'aspect', 0.7862, 0.141),
  ('floor', 7, 'behind', -9.327e-05, 0.03098),
  ('floor', 7, 'edge_free', -8.736e-05, 0.03024),
  ('floor', 7, 'edge_free_top', 5.485e-05, 0.3171),
  ('floor', 7, 'edge_joined', 0.2526, 0.1077),
  ('floor', 7, 'edge_unseen', 0.2846, 0.09412),
  ('floor', 7, 'height', 4.384e-05, 0.02252),
  ('floor', 7, 'length', 1.821, 0.1654),
  ('floor', 7, 'rectangularity', 0.5026, 0.07609),
  ('floor', 7, 'spread_length', 1.424, 0.1435),
  ('floor', 7, 'spread_width', 0.6276, 0.1887),
  ('floor', 7, 'tilt_deg', 0.03252, 0.4542),
  ('floor', 7, 'width', 1.038, 0.1861),
  ('floor', 7, 'z_max', 0.0006806, 0.0225),
  ('floor', 7, 'z_min', -0.0008537, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.0579, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'area_m2', 1.346, 0.5117),
  ('floor', 8, 'aspect', 0.3946, 0.2033),
  ('floor', 8, 'behind', -0.0002467, 0.03024),
  ('floor', 8, 'edge_free', -6.445e-05, 0.03006),
  ('floor', 8, 'edge_free_top', -6.32e-05, 0.3173),
  ('floor', 8, 'edge_joined', 0.1773, 0.08831),
  ('floor', 8, 'edge_unseen', 0.3634, 0.08488),
  ('floor', 8, 'height', 0.0002044, 0.02255),
  ('floor', 8, 'length', 1.153, 0.2338),
  ('floor', 8, 'rectangularity', 0.5749, 0.08098),
  ('floor', 8, 'spread_length', 0.9129, 0.1818),
  ('floor', 8, 'spread_width', 0.4415, 0.2895),
  ('floor', 8, 'tilt_deg', 1.348, 0.4896),
  ('floor', 8, 'width', 0.7592, 0.2686),
  ('floor', 8, 'z_max', 0.03499, 0.0225),
  ('floor', 8, 'z_min', -0.03693, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.04282, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'area_m2', -2.316, 0.881),
  ('floor', 9, 'aspect', 0.8492, 0.4701),
  ('floor', 9, 'behind', -0.001239, 0.03),
  ('floor', 9, 'edge_free', -0.00138, 0.03),
  ('floor', 9, 'edge_free_top', -0.003464, 0.3184),
  ('floor', 9, 'edge_joined', 0.0753, 0.08238),
  ('floor', 9, 'edge_unseen', 0.3578, 0.147),
  ('floor', 9, 'height', -0.1193, 0.2682),
  ('floor', 9, 'length', -0.5038, 0.5397),
  ('floor', 9, 'rectangularity', 0.6131, 0.1931),
  ('floor', 9, 'spread_length', -0.6104, 0.5196),
  ('floor', 9, 'spread_width', -1.518, 0.4849),
  ('floor', 9, 'tilt_deg', 2.577, 0.5928),
  ('floor', 9, 'width', -1.277, 0.5412),
  ('floor', 9, 'z_max', -0.1641, 0.2643),
  ('floor', 9, 'z_min', -0.1417, 0.2856);

-- ceiling: 428 examples
UPDATE object_class SET prior = 0.03396 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.647, 1.586)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4101, 0.3797)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.012, 0.06089)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.01158, 0.06139)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_joined', 0.4358, 0.2124)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_unseen', 0.3086, 0.1503)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.833, 0.3146)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.234, 0.7064)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6754, 0.1235)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.11, 0.7024)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.5303, 0.8519)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.07753, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.8205, 0.909)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.833, 0.3149)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.832, 0.3144)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'ceiling';
DELETE FROM class_density WHERE class = 'ceiling';
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.1927, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'area_m2', 2.588, 0.3227),
  ('ceiling', 1, 'aspect', 0.2107, 0.1501),
  ('ceiling', 1, 'behind', -1.999e-05, 0.03),
  ('ceiling', 1, 'edge_free', 0.000141, 0.03),
  ('ceiling', 1, 'edge_free_top', 0.0001431, 0.3168),
  ('ceiling', 1, 'edge_joined', 0.6012, 0.1677),
  ('ceiling', 1, 'edge_unseen', 0.3126, 0.1246),
  ('ceiling', 1, 'height', 2.512, 0.06468),
  ('ceiling', 1, 'length', 1.592, 0.17),
  ('ceiling', 1, 'rectangularity', 0.688, 0.1141),
  ('ceiling', 1, 'spread_length', 1.451, 0.1551),
  ('ceiling', 1, 'spread_width', 1.048, 0.1653),
  ('ceiling', 1, 'tilt_deg', 0.003181, 0.45),
  ('ceiling', 1, 'width', 1.382, 0.1357),
  ('ceiling', 1, 'z_max', 2.511, 0.06715),
  ('ceiling', 1, 'z_min', 2.511, 0.06636);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1657, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'area_m2', 2.593, 0.254),
  ('ceiling', 2, 'aspect', 0.2236, 0.1308),
  ('ceiling', 2, 'behind', 0.0001778, 0.03111),
  ('ceiling', 2, 'edge_free', 0.0001574, 0.03),
  ('ceiling', 2, 'edge_free_top', 0.0001499, 0.3169),
  ('ceiling', 2, 'edge_joined', 0.5253, 0.153),
  ('ceiling', 2, 'edge_unseen', 0.3334, 0.1136),
  ('ceiling', 2, 'height', 2.744, 0.06671),
  ('ceiling', 2, 'length', 1.612, 0.121),
  ('ceiling', 2, 'rectangularity', 0.6649, 0.09983),
  ('ceiling', 2, 'spread_length', 1.504, 0.1209),
  ('ceiling', 2, 'spread_width', 1.06, 0.1484),
  ('ceiling', 2, 'tilt_deg', -0.01365, 0.45),
  ('ceiling', 2, 'width', 1.394, 0.1197),
  ('ceiling', 2, 'z_max', 2.744, 0.06781),
  ('ceiling', 2, 'z_min', 2.745, 0.06824);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.1493, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'area_m2', 2.039, 0.282),
  ('ceiling', 3, 'aspect', 0.4463, 0.2943),
  ('ceiling', 3, 'behind', 0.0001957, 0.03),
  ('ceiling', 3, 'edge_free', 0.0001811, 0.03),
  ('ceiling', 3, 'edge_free_top', 0.0001099, 0.3172),
  ('ceiling', 3, 'edge_joined', 0.356, 0.1351),
  ('ceiling', 3, 'edge_unseen', 0.3229, 0.0641),
  ('ceiling', 3, 'height', 2.993, 0.08123),
  ('ceiling', 3, 'length', 1.469, 0.1916),
  ('ceiling', 3, 'rectangularity', 0.6532, 0.1234),
  ('ceiling', 3, 'spread_length', 1.349, 0.1357),
  ('ceiling', 3, 'spread_width', 0.7081, 0.1982),
  ('ceiling', 3, 'tilt_deg', 0.005847, 0.45),
  ('ceiling', 3, 'width', 1.014, 0.2349),
  ('ceiling', 3, 'z_max', 2.995, 0.08239),
  ('ceiling', 3, 'z_min', 2.994, 0.08271);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.1195, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'area_m2', 2.725, 0.2893),
  ('ceiling', 4, 'aspect', 0.2219, 0.1359),
  ('ceiling', 4, 'behind', 0.0002622, 0.03),
  ('ceiling', 4, 'edge_free', 0.0002374, 0.03),
  ('ceiling', 4, 'edge_free_top', 0.00015, 0.3166),
  ('ceiling', 4, 'edge_joined', 0.493, 0.158),
  ('ceiling', 4, 'edge_unseen', 0.2628, 0.1299),
  ('ceiling', 4, 'height', 2.968, 0.08472),
  ('ceiling', 4, 'length', 1.653, 0.132),
  ('ceiling', 4, 'rectangularity', 0.7093, 0.1266),
  ('ceiling', 4, 'spread_length', 1.529, 0.1252),
  ('ceiling', 4, 'spread_width', 1.109, 0.143),
  ('ceiling', 4, 'tilt_deg', 0.004123, 0.45),
  ('ceiling', 4, 'width', 1.431, 0.1236),
  ('ceiling', 4, 'z_max', 2.969, 0.08518),
  ('ceiling', 4, 'z_min', 2.968, 0.08511);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.08867, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'area_m2', -1.484, 0.9741),
  ('ceiling', 5, 'aspect', 0.5486, 0.4347),
  ('ceiling', 5, 'behind', 0.003384, 0.0319),
  ('ceiling', 5, 'edge_free', 0.000769, 0.03),
  ('ceiling', 5, 'edge_free_top', -0.001335, 0.3172),
  ('ceiling', 5, 'edge_joined', 0.2635, 0.1993),
  ('ceiling', 5, 'edge_unseen', 0.5194, 0.1251),
  ('ceiling', 5, 'height', 3.191, 0.3795),
  ('ceiling', 5, 'length', -0.2185, 0.526),
  ('ceiling', 5, 'rectangularity', 0.6057, 0.06959),
  ('ceiling', 5, 'spread_length', -0.2894, 0.5077),
  ('ceiling', 5, 'spread_width', -0.9825, 0.4219),
  ('ceiling', 5, 'tilt_deg', 0.414, 0.6892),
  ('ceiling', 5, 'width', -0.7354, 0.437),
  ('ceiling', 5, 'z_max', 3.209, 0.4484),
  ('ceiling', 5, 'z_min', 3.238, 0.392);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.04503, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'area_m2', -1.045, 0.9372),
  ('ceiling', 6, 'aspect', 0.9199, 0.2556),
  ('ceiling', 6, 'behind', 0.0003289, 0.03),
  ('ceiling', 6, 'edge_free', 0.0002483, 0.03),
  ('ceiling', 6, 'edge_free_top', -1.606e-05, 0.3168),
  ('ceiling', 6, 'edge_joined', 0.3067, 0.1682),
  ('ceiling', 6, 'edge_unseen', 0.08779, 0.121),
  ('ceiling', 6, 'height', 2.51, 0.03394),
  ('ceiling', 6, 'length', 0.1495, 0.4971),
  ('ceiling', 6, 'rectangularity', 0.7016, 0.09628),
  ('ceiling', 6, 'spread_length', 0.04847, 0.4846),
  ('ceiling', 6, 'spread_width', -0.8688, 0.2276),
  ('ceiling', 6, 'tilt_deg', 0.2703, 0.5646),
  ('ceiling', 6, 'width', -0.842, 0.5656),
  ('ceiling', 6, 'z_max', 2.507, 0.0225),
  ('ceiling', 6, 'z_min', 2.509, 0.02686);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.06616, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'area_m2', 1.982, 0.2578),
  ('ceiling', 7, 'aspect', 0.4244, 0.2432),
  ('ceiling', 7, 'behind', 0.0004534, 0.03007),
  ('ceiling', 7, 'edge_free', 0.0003911, 0.03),
  ('ceiling', 7, 'edge_free_top', 0.0001428, 0.3165),
  ('ceiling', 7, 'edge_joined', 0.514, 0.1692),
  ('ceiling', 7, 'edge_unseen', 0.3352, 0.06877),
  ('ceiling', 7, 'height', 2.646, 0.07317),
  ('ceiling', 7, 'length', 1.438, 0.1459),
  ('ceiling', 7, 'rectangularity', 0.636, 0.1218),
  ('ceiling', 7, 'spread_length', 1.307, 0.124),
  ('ceiling', 7, 'spread_width', 0.716, 0.1605),
  ('ceiling', 7, 'tilt_deg', 0.01136, 0.45),
  ('ceiling', 7, 'width', 1.015, 0.2011),
  ('ceiling', 7, 'z_max', 2.646, 0.0729),
  ('ceiling', 7, 'z_min', 2.645, 0.0733);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.06628, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'area_m2', 2.054, 0.5503),
  ('ceiling', 8, 'aspect', 0.42, 0.2599),
  ('ceiling', 8, 'behind', 0.0004578, 0.03),
  ('ceiling', 8, 'edge_free', 0.0004627, 0.03),
  ('ceiling', 8, 'edge_free_top', 0.0001219, 0.3168),
  ('ceiling', 8, 'edge_joined', 0.1816, 0.06897),
  ('ceiling', 8, 'edge_unseen', 0.2808, 0.07156),
  ('ceiling', 8, 'height', 3.483, 0.2125),
  ('ceiling', 8, 'length', 1.483, 0.2926),
  ('ceiling', 8, 'rectangularity', 0.6223, 0.1172),
  ('ceiling', 8, 'spread_length', 1.354, 0.2667),
  ('ceiling', 8, 'spread_width', 0.756, 0.2943),
  ('ceiling', 8, 'tilt_deg', 0.02124, 0.45),
  ('ceiling', 8, 'width', 1.059, 0.3408),
  ('ceiling', 8, 'z_max', 3.491, 0.218),
  ('ceiling', 8, 'z_min', 3.489, 0.2176);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.03121, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'area_m2', 0.8241, 0.5927),
  ('ceiling', 9, 'aspect', 0.8537, 0.474),
  ('ceiling', 9, 'behind', 0.2952, 0.06574),
  ('ceiling', 9, 'edge_free', 0.3079, 0.06868),
  ('ceiling', 9, 'edge_free_top', 8.915e-05, 0.317),
  ('ceiling', 9, 'edge_joined', 0.3065, 0.1393),
  ('ceiling', 9, 'edge_unseen', 0.1606, 0.05398),
  ('ceiling', 9, 'height', 3.065, 0.3746),
  ('ceiling', 9, 'length', 0.9536, 0.4574),
  ('ceiling', 9, 'rectangularity', 0.8092, 0.07626),
  ('ceiling', 9, 'spread_length', 0.8225, 0.4077),
  ('ceiling', 9, 'spread_width', -0.0511, 0.286),
  ('ceiling', 9, 'tilt_deg', 0.04281, 0.45),
  ('ceiling', 9, 'width', 0.08199, 0.2802),
  ('ceiling', 9, 'z_max', 3.035, 0.4069),
  ('ceiling', 9, 'z_min', 3.041, 0.4033);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 10, 0.0254, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 10, 'area_m2', 0.3185, 0.7953),
  ('ceiling', 10, 'aspect', 0.9308, 0.3962),
  ('ceiling', 10, 'behind', 0.2725, 0.2007),
  ('ceiling', 10, 'edge_free', 0.1833, 0.1575),
  ('ceiling', 10, 'edge_free_top', -2.995e-05, 0.3166),
  ('ceiling', 10, 'edge_joined', 0.3457, 0.1633),
  ('ceiling', 10, 'edge_unseen', 0.2315, 0.1015),
  ('ceiling', 10, 'height', 2.823, 0.07576),
  ('ceiling', 10, 'length', 0.8121, 0.3999),
  ('ceiling', 10, 'rectangularity', 0.6993, 0.08058),
  ('ceiling', 10, 'spread_length', 0.6505, 0.4375),
  ('ceiling', 10, 'spread_width', -0.3895, 0.4241),
  ('ceiling', 10, 'tilt_deg', 0.1031, 0.45),
  ('ceiling', 10, 'width', -0.1391, 0.4744),
  ('ceiling', 10, 'z_max', 2.821, 0.07339),
  ('ceiling', 10, 'z_min', 2.82, 0.07341);

-- wall: 2566 examples
UPDATE object_class SET prior = 0.1698 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 0.5999, 1.369)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.6527, 0.4831)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.09516, 0.1821)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.1199, 0.2194)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.09501, 0.2326)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_joined', 0.2319, 0.2511)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_unseen', 0.179, 0.1938)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.393, 0.461)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 0.853, 0.6376)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6577, 0.1526)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.6794, 0.6497)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', -0.05262, 0.8416)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.67, 0.9562)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.1963, 0.8504)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.419, 0.7429)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.2674, 0.5214)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'wall';
DELETE FROM class_density WHERE class = 'wall';
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.1412, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'area_m2', 1.944, 0.4441),
  ('wall', 1, 'aspect', 0.5888, 0.2566),
  ('wall', 1, 'behind', -0.003342, 0.03),
  ('wall', 1, 'edge_free', 0.006327, 0.03),
  ('wall', 1, 'edge_free_top', 0.001303, 0.03),
  ('wall', 1, 'edge_joined', 0.09873, 0.09274),
  ('wall', 1, 'edge_unseen', 0.08881, 0.1383),
  ('wall', 1, 'height', 1.557, 0.2146),
  ('wall', 1, 'length', 1.424, 0.2188),
  ('wall', 1, 'rectangularity', 0.6946, 0.1295),
  ('wall', 1, 'spread_length', 1.106, 0.2119),
  ('wall', 1, 'spread_width', 0.7183, 0.123),
  ('wall', 1, 'tilt_deg', 90.1, 0.45),
  ('wall', 1, 'width', 1.07, 0.07529),
  ('wall', 1, 'z_max', 2.766, 0.2348),
  ('wall', 1, 'z_min', -0.01619, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.08646, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'area_m2', 1.035, 0.3846),
  ('wall', 2, 'aspect', 0.5249, 0.4556),
  ('wall', 2, 'behind', -0.006112, 0.03),
  ('wall', 2, 'edge_free', 0.01266, 0.03592),
  ('wall', 2, 'edge_free_top', 0.001786, 0.03248),
  ('wall', 2, 'edge_joined', 0.3034, 0.1776),
  ('wall', 2, 'edge_unseen', 0.3386, 0.1075),
  ('wall', 2, 'height', 1.564, 0.275),
  ('wall', 2, 'length', 1.041, 0.2408),
  ('wall', 2, 'rectangularity', 0.6195, 0.121),
  ('wall', 2, 'spread_length', 0.6814, 0.1834),
  ('wall', 2, 'spread_width', 0.2024, 0.2981),
  ('wall', 2, 'tilt_deg', 90.15, 0.45),
  ('wall', 2, 'width', 0.5601, 0.3609),
  ('wall', 2, 'z_max', 2.724, 0.1571),
  ('wall', 2, 'z_min', 0.3604, 0.3258);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.1656, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'area_m2', -0.1211, 0.4333),
  ('wall', 3, 'aspect', 0.7673, 0.4803),
  ('wall', 3, 'behind', -0.002478, 0.03),
  ('wall', 3, 'edge_free', 0.002932, 0.03),
  ('wall', 3, 'edge_free_top', -0.001034, 0.03),
  ('wall', 3, 'edge_joined', 0.1319, 0.1059),
  ('wall', 3, 'edge_unseen', 0.3577, 0.2447),
  ('wall', 3, 'height', 0.947, 0.3433),
  ('wall', 3, 'length', 0.5017, 0.363),
  ('wall', 3, 'rectangularity', 0.66, 0.1299),
  ('wall', 3, 'spread_length', 0.1193, 0.5711),
  ('wall', 3, 'spread_width', -0.6736, 0.6141),
  ('wall', 3, 'tilt_deg', 88.23, 0.45),
  ('wall', 3, 'width', -0.4202, 0.6197),
  ('wall', 3, 'z_max', 1.42, 0.3918),
  ('wall', 3, 'z_min', 0.09265, 0.2451);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.06363, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'area_m2', 1.822, 0.3664),
  ('wall', 4, 'aspect', 0.403, 0.2554),
  ('wall', 4, 'behind', 0.1336, 0.1335),
  ('wall', 4, 'edge_free', 0.1291, 0.08928),
  ('wall', 4, 'edge_free_top', 0.07866, 0.111),
  ('wall', 4, 'edge_joined', 0.1052, 0.11),
  ('wall', 4, 'edge_unseen', 0.1108, 0.1305),
  ('wall', 4, 'height', 1.571, 0.2601),
  ('wall', 4, 'length', 1.395, 0.2046),
  ('wall', 4, 'rectangularity', 0.5343, 0.1182),
  ('wall', 4, 'spread_length', 1.277, 0.2068),
  ('wall', 4, 'spread_width', 0.8214, 0.1622),
  ('wall', 4, 'tilt_deg', 90.03, 0.45),
  ('wall', 4, 'width', 1.039, 0.1201),
  ('wall', 4, 'z_max', 2.991, 0.3887),
  ('wall', 4, 'z_min', -0.01215, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.06629, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'area_m2', 0.6884, 0.4191),
  ('wall', 5, 'aspect', 0.2219, 0.1879),
  ('wall', 5, 'behind', 0.3683, 0.1345),
  ('wall', 5, 'edge_free', 0.4529, 0.276),
  ('wall', 5, 'edge_free_top', 0.6395, 0.3294),
  ('wall', 5, 'edge_joined', 0.1993, 0.2193),
  ('wall', 5, 'edge_unseen', 0.1749, 0.1419),
  ('wall', 5, 'height', 1.139, 0.3025),
  ('wall', 5, 'length', 0.8705, 0.2705),
  ('wall', 5, 'rectangularity', 0.7134, 0.2107),
  ('wall', 5, 'spread_length', 0.5858, 0.2309),
  ('wall', 5, 'spread_width', 0.05838, 0.3703),
  ('wall', 5, 'tilt_deg', 89.97, 0.45),
  ('wall', 5, 'width', 0.4564, 0.1157),
  ('wall', 5, 'z_max', 2.001, 0.8366),
  ('wall', 5, 'z_min', -0.006237, 0.1826);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.1055, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'area_m2', 0.192, 0.4163),
  ('wall', 6, 'aspect', 1.371, 0.314),
  ('wall', 6, 'behind', 0.1759, 0.2026),
  ('wall', 6, 'edge_free', 0.3258, 0.3855),
  ('wall', 6, 'edge_free_top', 0.05974, 0.09453),
  ('wall', 6, 'edge_joined', 0.174, 0.2132),
  ('wall', 6, 'edge_unseen', 0.007982, 0.03),
  ('wall', 6, 'height', 1.452, 0.1565),
  ('wall', 6, 'length', 0.9743, 0.1436),
  ('wall', 6, 'rectangularity', 0.8201, 0.1165),
  ('wall', 6, 'spread_length', 0.8594, 0.1712),
  ('wall', 6, 'spread_width', -0.7825, 0.3643),
  ('wall', 6, 'tilt_deg', 90.05, 0.45),
  ('wall', 6, 'width', -0.4397, 0.3631),
  ('wall', 6, 'z_max', 2.938, 0.3711),
  ('wall', 6, 'z_min', 0.07913, 0.2365);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.0839, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'area_m2', -0.8107, 0.7148),
  ('wall', 7, 'aspect', 1.091, 0.3274),
  ('wall', 7, 'behind', 0.1969, 0.176),
  ('wall', 7, 'edge_free', 0.5575, 0.3427),
  ('wall', 7, 'edge_free_top', 0.5647, 0.4733),
  ('wall', 7, 'edge_joined', 0.06575, 0.1474),
  ('wall', 7, 'edge_unseen', 0.4376, 0.1765),
  ('wall', 7, 'height', 1.088, 0.3246),
  ('wall', 7, 'length', 0.2204, 0.4608),
  ('wall', 7, 'rectangularity', 0.7069, 0.2126),
  ('wall', 7, 'spread_length', -0.2515, 0.3211),
  ('wall', 7, 'spread_width', -0.9775, 0.3597),
  ('wall', 7, 'tilt_deg', 89.7, 3.846),
  ('wall', 7, 'width', -0.705, 0.5251),
  ('wall', 7, 'z_max', 1.84, 0.3857),
  ('wall', 7, 'z_min', 0.3611, 0.3183);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.029, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'area_m2', -2.006, 0.6171),
  ('wall', 8, 'aspect', 0.9784, 0.6416),
  ('wall', 8, 'behind', 0.1231, 0.2161),
  ('wall', 8, 'edge_free', 0.1095, 0.1559),
  ('wall', 8, 'edge_free_top', 0.00794, 0.03074),
  ('wall', 8, 'edge_joined', 0.3526, 0.3714),
  ('wall', 8, 'edge_unseen', 0.2109, 0.2402),
  ('wall', 8, 'height', 1.581, 0.8969),
  ('wall', 8, 'length', -0.3023, 0.5019),
  ('wall', 8, 'rectangularity', 0.6681, 0.1554),
  ('wall', 8, 'spread_length', -0.6765, 0.3647),
  ('wall', 8, 'spread_width', -1.489, 0.3478),
  ('wall', 8, 'tilt_deg', 89.62, 0.7999),
  ('wall', 8, 'width', -1.281, 0.2936),
  ('wall', 8, 'z_max', 2.302, 0.7364),
  ('wall', 8, 'z_min', 1.279, 1.215);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.1688, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'area_m2', -0.3097, 0.4626),
  ('wall', 9, 'aspect', 0.7601, 0.3233),
  ('wall', 9, 'behind', 0.1549, 0.2165),
  ('wall', 9, 'edge_free', 0.06419, 0.1218),
  ('wall', 9, 'edge_free_top', 0.004674, 0.03),
  ('wall', 9, 'edge_joined', 0.3618, 0.2717),
  ('wall', 9, 'edge_unseen', 0.1914, 0.2511),
  ('wall', 9, 'height', 2.161, 0.4063),
  ('wall', 9, 'length', 0.3855, 0.3192),
  ('wall', 9, 'rectangularity', 0.6728, 0.1001),
  ('wall', 9, 'spread_length', 0.08996, 0.4404),
  ('wall', 9, 'spread_width', -0.6033, 0.2932),
  ('wall', 9, 'tilt_deg', 89.99, 0.45),
  ('wall', 9, 'width', -0.3911, 0.4188),
  ('wall', 9, 'z_max', 2.803, 0.1871),
  ('wall', 9, 'z_min', 1.46, 0.6387);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.03962, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'area_m2', -1.995, 0.8198),
  ('wall', 10, 'aspect', 0.7799, 0.5981),
  ('wall', 10, 'behind', -0.007098, 0.03124),
  ('wall', 10, 'edge_free', 0.04793, 0.1216),
  ('wall', 10, 'edge_free_top', 0.05698, 0.1296),
  ('wall', 10, 'edge_joined', 0.09785, 0.1681),
  ('wall', 10, 'edge_unseen', 0.08602, 0.1434),
  ('wall', 10, 'height', 0.1772, 0.1175),
  ('wall', 10, 'length', -0.5042, 0.4761),
  ('wall', 10, 'rectangularity', 0.7998, 0.114),
  ('wall', 10, 'spread_length', -0.4542, 0.5159),
  ('wall', 10, 'spread_width', -1.27, 0.3472),
  ('wall', 10, 'tilt_deg', 89.53, 0.9307),
  ('wall', 10, 'width', -1.193, 0.4896),
  ('wall', 10, 'z_max', 0.3217, 0.1245),
  ('wall', 10, 'z_min', -0.02823, 0.02477);

-- table: 767 examples
UPDATE object_class SET prior = 0.02731 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.2784, 0.6058)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5534, 0.2715)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5337, 0.2073)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.4333, 0.222)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_joined', 0.3109, 0.2097)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_unseen', 0.1085, 0.1464)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7303, 0.1188)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.323, 0.312)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.7049, 0.1301)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1799, 0.3181)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4202, 0.3355)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.372, 0.5576)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2336, 0.3179)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.734, 0.1182)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7271, 0.1193)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'table';
DELETE FROM class_density WHERE class = 'table';
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.1226, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'area_m2', 0.01575, 0.2722),
  ('table', 1, 'aspect', 0.5373, 0.1671),
  ('table', 1, 'behind', 0.5882, 0.1029),
  ('table', 1, 'edge_free', 0.4353, 0.1463),
  ('table', 1, 'edge_free_top', -0.000346, 0.3159),
  ('table', 1, 'edge_joined', 0.2903, 0.1644),
  ('table', 1, 'edge_unseen', 0.1154, 0.1152),
  ('table', 1, 'height', 0.6964, 0.02573),
  ('table', 1, 'length', 0.4757, 0.1473),
  ('table', 1, 'rectangularity', 0.6789, 0.1249),
  ('table', 1, 'spread_length', 0.3628, 0.1676),
  ('table', 1, 'spread_width', -0.2539, 0.1293),
  ('table', 1, 'tilt_deg', 0.1852, 0.45),
  ('table', 1, 'width', -0.07048, 0.1443),
  ('table', 1, 'z_max', 0.693, 0.02525),
  ('table', 1, 'z_min', 0.6908, 0.0291);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.09099, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'area_m2', 0.1182, 0.1984),
  ('table', 2, 'aspect', 0.54, 0.1605),
  ('table', 2, 'behind', 0.7096, 0.05032),
  ('table', 2, 'edge_free', 0.3604, 0.1895),
  ('table', 2, 'edge_free_top', -0.0001257, 0.3162),
  ('table', 2, 'edge_joined', 0.3914, 0.1518),
  ('table', 2, 'edge_unseen', 0.00709, 0.0332),
  ('table', 2, 'height', 0.7425, 0.02298),
  ('table', 2, 'length', 0.5188, 0.1472),
  ('table', 2, 'rectangularity', 0.7102, 0.06849),
  ('table', 2, 'spread_length', 0.365, 0.1137),
  ('table', 2, 'spread_width', -0.234, 0.1208),
  ('table', 2, 'tilt_deg', 0.08553, 0.45),
  ('table', 2, 'width', -0.05246, 0.1339),
  ('table', 2, 'z_max', 0.7422, 0.0225),
  ('table', 2, 'z_min', 0.7417, 0.02412);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.1289, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'area_m2', -0.1816, 0.3593),
  ('table', 3, 'aspect', 0.5423, 0.2385),
  ('table', 3, 'behind', 0.4388, 0.1392),
  ('table', 3, 'edge_free', 0.5051, 0.2644),
  ('table', 3, 'edge_free_top', -0.0005818, 0.3153),
  ('table', 3, 'edge_joined', 0.2241, 0.1569),
  ('table', 3, 'edge_unseen', 0.1872, 0.1501),
  ('table', 3, 'height', 0.7651, 0.0225),
  ('table', 3, 'length', 0.4284, 0.1737),
  ('table', 3, 'rectangularity', 0.6772, 0.1689),
  ('table', 3, 'spread_length', 0.2558, 0.1778),
  ('table', 3, 'spread_width', -0.3977, 0.2057),
  ('table', 3, 'tilt_deg', 0.1727, 0.45),
  ('table', 3, 'width', -0.1725, 0.1811),
  ('table', 3, 'z_max', 0.769, 0.0225),
  ('table', 3, 'z_min', 0.7646, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.1376, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'area_m2', -0.9285, 0.2757),
  ('table', 4, 'aspect', 0.381, 0.2128),
  ('table', 4, 'behind', 0.3031, 0.1628),
  ('table', 4, 'edge_free', 0.482, 0.2506),
  ('table', 4, 'edge_free_top', -0.001519, 0.3142),
  ('table', 4, 'edge_joined', 0.2616, 0.2089),
  ('table', 4, 'edge_unseen', 0.1584, 0.1986),
  ('table', 4, 'height', 0.6909, 0.02869),
  ('table', 4, 'length', -0.08242, 0.1698),
  ('table', 4, 'rectangularity', 0.6932, 0.1471),
  ('table', 4, 'spread_length', -0.2041, 0.1565),
  ('table', 4, 'spread_width', -0.6754, 0.1593),
  ('table', 4, 'tilt_deg', 0.3272, 0.45),
  ('table', 4, 'width', -0.4706, 0.1533),
  ('table', 4, 'z_max', 0.6917, 0.03039),
  ('table', 4, 'z_min', 0.6876, 0.03133);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.1312, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'area_m2', 0.003051, 0.3799),
  ('table', 5, 'aspect', 0.5193, 0.2356),
  ('table', 5, 'behind', 0.4714, 0.1352),
  ('table', 5, 'edge_free', 0.401, 0.186),
  ('table', 5, 'edge_free_top', -0.002229, 0.3134),
  ('table', 5, 'edge_joined', 0.3093, 0.1793),
  ('table', 5, 'edge_unseen', 0.09327, 0.1006),
  ('table', 5, 'height', 0.7354, 0.09729),
  ('table', 5, 'length', 0.4771, 0.3022),
  ('table', 5, 'rectangularity', 0.7594, 0.1324),
  ('table', 5, 'spread_length', 0.2639, 0.2621),
  ('table', 5, 'spread_width', -0.2888, 0.1726),
  ('table', 5, 'tilt_deg', 0.8245, 0.7662),
  ('table', 5, 'width', -0.136, 0.1506),
  ('table', 5, 'z_max', 0.7541, 0.1055),
  ('table', 5, 'z_min', 0.7312, 0.1046);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.05928, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'area_m2', 0.09062, 0.1955),
  ('table', 6, 'aspect', 0.6349, 0.175),
  ('table', 6, 'behind', 0.4779, 0.1886),
  ('table', 6, 'edge_free', 0.7223, 0.1311),
  ('table', 6, 'edge_free_top', -4.275e-05, 0.316),
  ('table', 6, 'edge_joined', 0.1289, 0.0874),
  ('table', 6, 'edge_unseen', 0.006705, 0.03),
  ('table', 6, 'height', 0.7099, 0.02417),
  ('table', 6, 'length', 0.4617, 0.1518),
  ('table', 6, 'rectangularity', 0.8365, 0.07461),
  ('table', 6, 'spread_length', 0.3329, 0.1518),
  ('table', 6, 'spread_width', -0.3084, 0.09954),
  ('table', 6, 'tilt_deg', 0.129, 0.45),
  ('table', 6, 'width', -0.1882, 0.1182),
  ('table', 6, 'z_max', 0.7114, 0.02449),
  ('table', 6, 'z_min', 0.7084, 0.02602);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.1089, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'area_m2', -1.619, 0.703),
  ('table', 7, 'aspect', 0.8931, 0.3285),
  ('table', 7, 'behind', 0.2714, 0.2079),
  ('table', 7, 'edge_free', 0.5175, 0.3138),
  ('table', 7, 'edge_free_top', -0.003078, 0.313),
  ('table', 7, 'edge_joined', 0.2316, 0.1902),
  ('table', 7, 'edge_unseen', 0.362, 0.1066),
  ('table', 7, 'height', 0.7322, 0.06165),
  ('table', 7, 'length', -0.1799, 0.3695),
  ('table', 7, 'rectangularity', 0.6269, 0.07304),
  ('table', 7, 'spread_length', -0.3381, 0.4018),
  ('table', 7, 'spread_width', -1.189, 0.336),
  ('table', 7, 'tilt_deg', 1.019, 1.253),
  ('table', 7, 'width', -1.012, 0.4397),
  ('table', 7, 'z_max', 0.7278, 0.06164),
  ('table', 7, 'z_min', 0.722, 0.06207);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.07746, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'area_m2', -0.4863, 0.2016),
  ('table', 8, 'aspect', 0.2139, 0.1431),
  ('table', 8, 'behind', 0.6806, 0.109),
  ('table', 8, 'edge_free', 0.2711, 0.1517),
  ('table', 8, 'edge_free_top', -0.0004491, 0.3159),
  ('table', 8, 'edge_joined', 0.4123, 0.1883),
  ('table', 8, 'edge_unseen', 0.05237, 0.08426),
  ('table', 8, 'height', 0.7346, 0.0398),
  ('table', 8, 'length', 0.06484, 0.1379),
  ('table', 8, 'rectangularity', 0.6999, 0.102),
  ('table', 8, 'spread_length', -0.07614, 0.107),
  ('table', 8, 'spread_width', -0.3535, 0.1045),
  ('table', 8, 'tilt_deg', 0.1779, 0.45),
  ('table', 8, 'width', -0.1598, 0.09326),
  ('table', 8, 'z_max', 0.7372, 0.04723),
  ('table', 8, 'z_min', 0.7346, 0.0466);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.06932, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'area_m2', -0.4053, 0.6391),
  ('table', 9, 'aspect', 0.5201, 0.2175),
  ('table', 9, 'behind', 0.3493, 0.2065),
  ('table', 9, 'edge_free', 0.2379, 0.2194),
  ('table', 9, 'edge_free_top', -0.001347, 0.3151),
  ('table', 9, 'edge_joined', 0.568, 0.2076),
  ('table', 9, 'edge_unseen', 0.1399, 0.1333),
  ('table', 9, 'height', 1.028, 0.09798),
  ('table', 9, 'length', 0.2966, 0.3069),
  ('table', 9, 'rectangularity', 0.6253, 0.1445),
  ('table', 9, 'spread_length', 0.219, 0.2613),
  ('table', 9, 'spread_width', -0.4228, 0.3414),
  ('table', 9, 'tilt_deg', 0.2296, 0.45),
  ('table', 9, 'width', -0.2299, 0.2637),
  ('table', 9, 'z_max', 1.035, 0.09909),
  ('table', 9, 'z_min', 1.025, 0.1049);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.02368, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'area_m2', -0.6927, 0.6187),
  ('table', 10, 'aspect', 0.5201, 0.1555),
  ('table', 10, 'behind', 0.215, 0.1349),
  ('table', 10, 'edge_free', 0.2757, 0.1178),
  ('table', 10, 'edge_free_top', -0.0001249, 0.3161),
  ('table', 10, 'edge_joined', 0.1882, 0.1676),
  ('table', 10, 'edge_unseen', 0.2003, 0.1137),
  ('table', 10, 'height', 0.04956, 0.05487),
  ('table', 10, 'length', 0.1491, 0.3145),
  ('table', 10, 'rectangularity', 0.6143, 0.08308),
  ('table', 10, 'spread_length', 0.0265, 0.3251),
  ('table', 10, 'spread_width', -0.608, 0.3496),
  ('table', 10, 'tilt_deg', 1.326, 0.4907),
  ('table', 10, 'width', -0.3261, 0.2816),
  ('table', 10, 'z_max', 0.03764, 0.03877),
  ('table', 10, 'z_min', 0.02003, 0.04029);

-- flat_screen: 602 examples
UPDATE object_class SET prior = 0.03804 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.858, 0.3778)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.3791, 0.2014)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5894, 0.1336)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.7784, 0.1703)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.9768, 0.06983)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_joined', 0.0707, 0.1071)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_unseen', 0.05635, 0.1105)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.018, 0.09424)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.6251, 0.2479)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.8033, 0.1135)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7716, 0.2043)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.207, 0.1737)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.22, 3.254)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -1.005, 0.2149)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.174, 0.1043)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7853, 0.1218)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'flat_screen';
DELETE FROM class_density WHERE class = 'flat_screen';
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.1232, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'area_m2', -1.456, 0.124),
  ('flat_screen', 1, 'aspect', 0.3904, 0.102),
  ('flat_screen', 1, 'behind', 0.5951, 0.09201),
  ('flat_screen', 1, 'edge_free', 0.7155, 0.08099),
  ('flat_screen', 1, 'edge_free_top', 0.9922, 0.03),
  ('flat_screen', 1, 'edge_joined', 0.09563, 0.08619),
  ('flat_screen', 1, 'edge_unseen', 0.006032, 0.03007),
  ('flat_screen', 1, 'height', 1.012, 0.05915),
  ('flat_screen', 1, 'length', -0.4093, 0.1079),
  ('flat_screen', 1, 'rectangularity', 0.7883, 0.06973),
  ('flat_screen', 1, 'spread_length', -0.5822, 0.05981),
  ('flat_screen', 1, 'spread_width', -1.043, 0.04782),
  ('flat_screen', 1, 'tilt_deg', 85.5, 2.74),
  ('flat_screen', 1, 'width', -0.8039, 0.09497),
  ('flat_screen', 1, 'z_max', 1.174, 0.08139),
  ('flat_screen', 1, 'z_min', 0.7365, 0.05903);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.1754, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'area_m2', -1.541, 0.2643),
  ('flat_screen', 2, 'aspect', 0.5626, 0.1877),
  ('flat_screen', 2, 'behind', 0.6223, 0.06483),
  ('flat_screen', 2, 'edge_free', 0.5733, 0.1185),
  ('flat_screen', 2, 'edge_free_top', 0.8735, 0.1209),
  ('flat_screen', 2, 'edge_joined', 0.2089, 0.1887),
  ('flat_screen', 2, 'edge_unseen', 0.0192, 0.04224),
  ('flat_screen', 2, 'height', 0.9759, 0.05099),
  ('flat_screen', 2, 'length', -0.3634, 0.2145),
  ('flat_screen', 2, 'rectangularity', 0.6692, 0.04782),
  ('flat_screen', 2, 'spread_length', -0.6294, 0.2247),
  ('flat_screen', 2, 'spread_width', -1.142, 0.1025),
  ('flat_screen', 2, 'tilt_deg', 83.85, 2.12),
  ('flat_screen', 2, 'width', -0.8419, 0.1284),
  ('flat_screen', 2, 'z_max', 1.146, 0.08984),
  ('flat_screen', 2, 'z_min', 0.7196, 0.06087);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.09955, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'area_m2', -2.053, 0.1196),
  ('flat_screen', 3, 'aspect', 0.1558, 0.1157),
  ('flat_screen', 3, 'behind', 0.6647, 0.04111),
  ('flat_screen', 3, 'edge_free', 0.7759, 0.07433),
  ('flat_screen', 3, 'edge_free_top', 1.001, 0.03),
  ('flat_screen', 3, 'edge_joined', 0.05111, 0.04043),
  ('flat_screen', 3, 'edge_unseen', 0.003354, 0.03),
  ('flat_screen', 3, 'height', 0.9853, 0.04885),
  ('flat_screen', 3, 'length', -0.8553, 0.1068),
  ('flat_screen', 3, 'rectangularity', 0.8204, 0.0528),
  ('flat_screen', 3, 'spread_length', -0.9423, 0.08039),
  ('flat_screen', 3, 'spread_width', -1.251, 0.05844),
  ('flat_screen', 3, 'tilt_deg', 84.52, 2.425),
  ('flat_screen', 3, 'width', -1.005, 0.04459),
  ('flat_screen', 3, 'z_max', 1.109, 0.06601),
  ('flat_screen', 3, 'z_min', 0.7383, 0.05957);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.1009, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'area_m2', -1.85, 0.1373),
  ('flat_screen', 4, 'aspect', 0.3716, 0.1415),
  ('flat_screen', 4, 'behind', 0.5659, 0.1186),
  ('flat_screen', 4, 'edge_free', 0.7133, 0.109),
  ('flat_screen', 4, 'edge_free_top', 0.998, 0.03),
  ('flat_screen', 4, 'edge_joined', 0.06997, 0.06321),
  ('flat_screen', 4, 'edge_unseen', 0.08291, 0.1111),
  ('flat_screen', 4, 'height', 1.009, 0.03985),
  ('flat_screen', 4, 'length', -0.5851, 0.1308),
  ('flat_screen', 4, 'rectangularity', 0.727, 0.09324),
  ('flat_screen', 4, 'spread_length', -0.8096, 0.1347),
  ('flat_screen', 4, 'spread_width', -1.227, 0.07132),
  ('flat_screen', 4, 'tilt_deg', 84.51, 2.021),
  ('flat_screen', 4, 'width', -0.95, 0.06702),
  ('flat_screen', 4, 'z_max', 1.14, 0.04456),
  ('flat_screen', 4, 'z_min', 0.7512, 0.03856);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.1047, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'area_m2', -1.782, 0.1373),
  ('flat_screen', 5, 'aspect', 0.5006, 0.04895),
  ('flat_screen', 5, 'behind', 0.5803, 0.1028),
  ('flat_screen', 5, 'edge_free', 0.9836, 0.03),
  ('flat_screen', 5, 'edge_free_top', 0.9986, 0.03),
  ('flat_screen', 5, 'edge_joined', 0.003401, 0.03),
  ('flat_screen', 5, 'edge_unseen', 0.03919, 0.07691),
  ('flat_screen', 5, 'height', 1.029, 0.04271),
  ('flat_screen', 5, 'length', -0.6046, 0.07116),
  ('flat_screen', 5, 'rectangularity', 0.9317, 0.03253),
  ('flat_screen', 5, 'spread_length', -0.6491, 0.07001),
  ('flat_screen', 5, 'spread_width', -1.149, 0.07965),
  ('flat_screen', 5, 'tilt_deg', 85.3, 3.083),
  ('flat_screen', 5, 'width', -1.105, 0.07316),
  ('flat_screen', 5, 'z_max', 1.185, 0.04561),
  ('flat_screen', 5, 'z_min', 0.8518, 0.04234);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.06792, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'area_m2', -2.534, 0.4214),
  ('flat_screen', 6, 'aspect', 0.5577, 0.3278),
  ('flat_screen', 6, 'behind', 0.5666, 0.2034),
  ('flat_screen', 6, 'edge_free', 0.8234, 0.1985),
  ('flat_screen', 6, 'edge_free_top', 0.9998, 0.03),
  ('flat_screen', 6, 'edge_joined', 0.04538, 0.07635),
  ('flat_screen', 6, 'edge_unseen', 0.2693, 0.09697),
  ('flat_screen', 6, 'height', 1.037, 0.04517),
  ('flat_screen', 6, 'length', -0.8627, 0.2443),
  ('flat_screen', 6, 'rectangularity', 0.7526, 0.08738),
  ('flat_screen', 6, 'spread_length', -1.003, 0.131),
  ('flat_screen', 6, 'spread_width', -1.593, 0.2698),
  ('flat_screen', 6, 'tilt_deg', 84.45, 1.769),
  ('flat_screen', 6, 'width', -1.365, 0.2924),
  ('flat_screen', 6, 'z_max', 1.13, 0.05116),
  ('flat_screen', 6, 'z_min', 0.8294, 0.0685);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.07442, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'area_m2', -2.218, 0.1299),
  ('flat_screen', 7, 'aspect', 0.3516, 0.1184),
  ('flat_screen', 7, 'behind', 0.5736, 0.08178),
  ('flat_screen', 7, 'edge_free', 0.9897, 0.03),
  ('flat_screen', 7, 'edge_free_top', 0.9975, 0.03),
  ('flat_screen', 7, 'edge_joined', 0.0044, 0.03),
  ('flat_screen', 7, 'edge_unseen', 0.06492, 0.1005),
  ('flat_screen', 7, 'height', 1.01, 0.05559),
  ('flat_screen', 7, 'length', -0.8933, 0.108),
  ('flat_screen', 7, 'rectangularity', 0.914, 0.05784),
  ('flat_screen', 7, 'spread_length', -0.942, 0.1054),
  ('flat_screen', 7, 'spread_width', -1.289, 0.05135),
  ('flat_screen', 7, 'tilt_deg', 84.01, 2.989),
  ('flat_screen', 7, 'width', -1.233, 0.08652),
  ('flat_screen', 7, 'z_max', 1.147, 0.05981),
  ('flat_screen', 7, 'z_min', 0.853, 0.04518);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.1074, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'area_m2', -1.831, 0.2997),
  ('flat_screen', 8, 'aspect', 0.4024, 0.2344),
  ('flat_screen', 8, 'behind', 0.4869, 0.08202),
  ('flat_screen', 8, 'edge_free', 0.8441, 0.1398),
  ('flat_screen', 8, 'edge_free_top', 0.9985, 0.03),
  ('flat_screen', 8, 'edge_joined', 0.03828, 0.05015),
  ('flat_screen', 8, 'edge_unseen', 0.1066, 0.1587),
  ('flat_screen', 8, 'height', 1.241, 0.1154),
  ('flat_screen', 8, 'length', -0.6215, 0.2312),
  ('flat_screen', 8, 'rectangularity', 0.8209, 0.1288),
  ('flat_screen', 8, 'spread_length', -0.6799, 0.1302),
  ('flat_screen', 8, 'spread_width', -1.183, 0.149),
  ('flat_screen', 8, 'tilt_deg', 82.66, 2.178),
  ('flat_screen', 8, 'width', -1.008, 0.2032),
  ('flat_screen', 8, 'z_max', 1.395, 0.0995),
  ('flat_screen', 8, 'z_min', 1.057, 0.135);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.06696, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'area_m2', -1.655, 0.07231),
  ('flat_screen', 9, 'aspect', 0.2532, 0.09064),
  ('flat_screen', 9, 'behind', 0.5656, 0.1215),
  ('flat_screen', 9, 'edge_free', 0.7666, 0.08601),
  ('flat_screen', 9, 'edge_free_top', 0.997, 0.03),
  ('flat_screen', 9, 'edge_joined', 0.05888, 0.04056),
  ('flat_screen', 9, 'edge_unseen', 0.004588, 0.03036),
  ('flat_screen', 9, 'height', 0.9882, 0.043),
  ('flat_screen', 9, 'length', -0.6224, 0.05623),
  ('flat_screen', 9, 'rectangularity', 0.8504, 0.03118),
  ('flat_screen', 9, 'spread_length', -0.6799, 0.06869),
  ('flat_screen', 9, 'spread_width', -1.119, 0.04402),
  ('flat_screen', 9, 'tilt_deg', 85.27, 2.917),
  ('flat_screen', 9, 'width', -0.8692, 0.06211),
  ('flat_screen', 9, 'z_max', 1.135, 0.05277),
  ('flat_screen', 9, 'z_min', 0.7206, 0.04197);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.02959, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'area_m2', -1.704, 0.5074),
  ('flat_screen', 10, 'aspect', 0.6239, 0.1509),
  ('flat_screen', 10, 'behind', 0.6123, 0.1553),
  ('flat_screen', 10, 'edge_free', 0.5734, 0.1343),
  ('flat_screen', 10, 'edge_free_top', 0.8613, 0.173),
  ('flat_screen', 10, 'edge_joined', 0.198, 0.2012),
  ('flat_screen', 10, 'edge_unseen', 0.03842, 0.07426),
  ('flat_screen', 10, 'height', 0.8712, 0.3161),
  ('flat_screen', 10, 'length', -0.3984, 0.3536),
  ('flat_screen', 10, 'rectangularity', 0.6813, 0.2496),
  ('flat_screen', 10, 'spread_length', -0.5576, 0.3519),
  ('flat_screen', 10, 'spread_width', -1.151, 0.2865),
  ('flat_screen', 10, 'tilt_deg', 84.63, 1.804),
  ('flat_screen', 10, 'width', -0.8904, 0.4471),
  ('flat_screen', 10, 'z_max', 1.117, 0.6367),
  ('flat_screen', 10, 'z_min', 0.5053, 0.3646);

-- keyboard: 398 examples
UPDATE object_class SET prior = 0.0656 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.756, 0.3741)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7552, 0.3016)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.2478, 0.1624)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.2507, 0.2041)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_joined', 0.6998, 0.2212)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_unseen', 0.03851, 0.09491)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7605, 0.1218)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.8949, 0.2797)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8148, 0.08035)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9821, 0.2764)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.826, 0.1261)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.302, 2.039)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.651, 0.2067)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.767, 0.1219)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7544, 0.122)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'keyboard';
DELETE FROM class_density WHERE class = 'keyboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1256, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'area_m2', -2.322, 0.1014),
  ('keyboard', 1, 'aspect', 0.7743, 0.1653),
  ('keyboard', 1, 'behind', 0.2772, 0.09603),
  ('keyboard', 1, 'edge_free', 0.1992, 0.1453),
  ('keyboard', 1, 'edge_free_top', -0.002111, 0.3149),
  ('keyboard', 1, 'edge_joined', 0.7805, 0.1405),
  ('keyboard', 1, 'edge_unseen', 0.003558, 0.03),
  ('keyboard', 1, 'height', 0.7417, 0.04052),
  ('keyboard', 1, 'length', -0.6406, 0.1163),
  ('keyboard', 1, 'rectangularity', 0.7519, 0.04606),
  ('keyboard', 1, 'spread_length', -0.7736, 0.0757),
  ('keyboard', 1, 'spread_width', -1.748, 0.06572),
  ('keyboard', 1, 'tilt_deg', 2.779, 0.8721),
  ('keyboard', 1, 'width', -1.395, 0.1037),
  ('keyboard', 1, 'z_max', 0.7463, 0.0409),
  ('keyboard', 1, 'z_min', 0.7357, 0.04565);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.1393, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'area_m2', -2.625, 0.07752),
  ('keyboard', 2, 'aspect', 0.9293, 0.1073),
  ('keyboard', 2, 'behind', 0.1847, 0.1011),
  ('keyboard', 2, 'edge_free', 0.4114, 0.1255),
  ('keyboard', 2, 'edge_free_top', -0.002145, 0.3114),
  ('keyboard', 2, 'edge_joined', 0.5641, 0.1353),
  ('keyboard', 2, 'edge_unseen', 0.001799, 0.03074),
  ('keyboard', 2, 'height', 0.7415, 0.02891),
  ('keyboard', 2, 'length', -0.7651, 0.06468),
  ('keyboard', 2, 'rectangularity', 0.8404, 0.06179),
  ('keyboard', 2, 'spread_length', -0.8274, 0.04147),
  ('keyboard', 2, 'spread_width', -1.823, 0.07675),
  ('keyboard', 2, 'tilt_deg', 4.946, 1.206),
  ('keyboard', 2, 'width', -1.683, 0.09187),
  ('keyboard', 2, 'z_max', 0.7499, 0.02975),
  ('keyboard', 2, 'z_min', 0.7327, 0.03122);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.1247, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'area_m2', -2.704, 0.2375),
  ('keyboard', 3, 'aspect', 0.4671, 0.2312),
  ('keyboard', 3, 'behind', 0.243, 0.08381),
  ('keyboard', 3, 'edge_free', 0.3458, 0.13),
  ('keyboard', 3, 'edge_free_top', -0.003252, 0.3147),
  ('keyboard', 3, 'edge_joined', 0.6232, 0.1482),
  ('keyboard', 3, 'edge_unseen', 0.08619, 0.1181),
  ('keyboard', 3, 'height', 0.7415, 0.03951),
  ('keyboard', 3, 'length', -0.9849, 0.1925),
  ('keyboard', 3, 'rectangularity', 0.7727, 0.04651),
  ('keyboard', 3, 'spread_length', -1.11, 0.1415),
  ('keyboard', 3, 'spread_width', -1.748, 0.07057),
  ('keyboard', 3, 'tilt_deg', 4.83, 1.199),
  ('keyboard', 3, 'width', -1.435, 0.1329),
  ('keyboard', 3, 'z_max', 0.7481, 0.04194),
  ('keyboard', 3, 'z_min', 0.7315, 0.04538);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.1062, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'area_m2', -2.672, 0.1019),
  ('keyboard', 4, 'aspect', 0.9856, 0.1065),
  ('keyboard', 4, 'behind', 0.2703, 0.1279),
  ('keyboard', 4, 'edge_free', 0.03482, 0.04872),
  ('keyboard', 4, 'edge_free_top', -0.001051, 0.3155),
  ('keyboard', 4, 'edge_joined', 0.9275, 0.08446),
  ('keyboard', 4, 'edge_unseen', 0.02819, 0.07985),
  ('keyboard', 4, 'height', 0.7589, 0.03652),
  ('keyboard', 4, 'length', -0.7598, 0.08042),
  ('keyboard', 4, 'rectangularity', 0.8348, 0.0637),
  ('keyboard', 4, 'spread_length', -0.8281, 0.05261),
  ('keyboard', 4, 'spread_width', -1.856, 0.09487),
  ('keyboard', 4, 'tilt_deg', 1.96, 0.8881),
  ('keyboard', 4, 'width', -1.722, 0.09519),
  ('keyboard', 4, 'z_max', 0.7618, 0.03331),
  ('keyboard', 4, 'z_min', 0.7563, 0.03515);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.1138, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'area_m2', -2.688, 0.2015),
  ('keyboard', 5, 'aspect', 0.9247, 0.155),
  ('keyboard', 5, 'behind', 0.2925, 0.07769),
  ('keyboard', 5, 'edge_free', 0.4076, 0.09217),
  ('keyboard', 5, 'edge_free_top', -0.001141, 0.3133),
  ('keyboard', 5, 'edge_joined', 0.5429, 0.09512),
  ('keyboard', 5, 'edge_unseen', 0.0002244, 0.03),
  ('keyboard', 5, 'height', 0.7911, 0.0225),
  ('keyboard', 5, 'length', -0.785, 0.1435),
  ('keyboard', 5, 'rectangularity', 0.8428, 0.03668),
  ('keyboard', 5, 'spread_length', -0.8842, 0.1037),
  ('keyboard', 5, 'spread_width', -1.832, 0.08882),
  ('keyboard', 5, 'tilt_deg', 4.105, 1.326),
  ('keyboard', 5, 'width', -1.726, 0.1317),
  ('keyboard', 5, 'z_max', 0.7987, 0.0225),
  ('keyboard', 5, 'z_min', 0.7872, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.08776, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'area_m2', -3.509, 0.285),
  ('keyboard', 6, 'aspect', 0.2918, 0.1506),
  ('keyboard', 6, 'behind', 0.3271, 0.1076),
  ('keyboard', 6, 'edge_free', 0.2009, 0.1234),
  ('keyboard', 6, 'edge_free_top', -0.005526, 0.3095),
  ('keyboard', 6, 'edge_joined', 0.6373, 0.2023),
  ('keyboard', 6, 'edge_unseen', 0.1764, 0.1043),
  ('keyboard', 6, 'height', 0.758, 0.0429),
  ('keyboard', 6, 'length', -1.495, 0.1548),
  ('keyboard', 6, 'rectangularity', 0.7759, 0.04903),
  ('keyboard', 6, 'spread_length', -1.59, 0.07869),
  ('keyboard', 6, 'spread_width', -1.97, 0.1319),
  ('keyboard', 6, 'tilt_deg', 3.987, 0.9869),
  ('keyboard', 6, 'width', -1.772, 0.19),
  ('keyboard', 6, 'z_max', 0.7561, 0.03274),
  ('keyboard', 6, 'z_min', 0.7598, 0.051);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.1145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'area_m2', -2.709, 0.1158),
  ('keyboard', 7, 'aspect', 1.017, 0.1444),
  ('keyboard', 7, 'behind', 0.1785, 0.1261),
  ('keyboard', 7, 'edge_free', 0.29, 0.1781),
  ('keyboard', 7, 'edge_free_top', -0.008395, 0.3061),
  ('keyboard', 7, 'edge_joined', 0.6778, 0.1716),
  ('keyboard', 7, 'edge_unseen', 0.0261, 0.05235),
  ('keyboard', 7, 'height', 0.8795, 0.17),
  ('keyboard', 7, 'length', -0.7955, 0.07256),
  ('keyboard', 7, 'rectangularity', 0.9027, 0.06232),
  ('keyboard', 7, 'spread_length', -0.8329, 0.04516),
  ('keyboard', 7, 'spread_width', -1.861, 0.08144),
  ('keyboard', 7, 'tilt_deg', 4.303, 1.768),
  ('keyboard', 7, 'width', -1.811, 0.1202),
  ('keyboard', 7, 'z_max', 0.8988, 0.1551),
  ('keyboard', 7, 'z_min', 0.9031, 0.1555);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.0536, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'area_m2', -3.175, 0.1454),
  ('keyboard', 8, 'aspect', 0.6672, 0.1191),
  ('keyboard', 8, 'behind', 0.1677, 0.1734),
  ('keyboard', 8, 'edge_free', 0.1748, 0.1591),
  ('keyboard', 8, 'edge_free_top', -0.00474, 0.3137),
  ('keyboard', 8, 'edge_joined', 0.8052, 0.1807),
  ('keyboard', 8, 'edge_unseen', 0.09428, 0.1438),
  ('keyboard', 8, 'height', 0.8609, 0.1302),
  ('keyboard', 8, 'length', -1.138, 0.07866),
  ('keyboard', 8, 'rectangularity', 0.8308, 0.1286),
  ('keyboard', 8, 'spread_length', -1.229, 0.09772),
  ('keyboard', 8, 'spread_width', -1.907, 0.06176),
  ('keyboard', 8, 'tilt_deg', 4.782, 1.74),
  ('keyboard', 8, 'width', -1.823, 0.08713),
  ('keyboard', 8, 'z_max', 0.8576, 0.1295),
  ('keyboard', 8, 'z_min', 0.8889, 0.1247);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.05872, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'area_m2', -2.936, 0.1099),
  ('keyboard', 9, 'aspect', 0.5496, 0.123),
  ('keyboard', 9, 'behind', 0.2892, 0.09289),
  ('keyboard', 9, 'edge_free', 0.01443, 0.03),
  ('keyboard', 9, 'edge_free_top', -0.0003578, 0.316),
  ('keyboard', 9, 'edge_joined', 0.9542, 0.06612),
  ('keyboard', 9, 'edge_unseen', 0.006385, 0.0321),
  ('keyboard', 9, 'height', 0.7514, 0.03517),
  ('keyboard', 9, 'length', -1.102, 0.08106),
  ('keyboard', 9, 'rectangularity', 0.8439, 0.03523),
  ('keyboard', 9, 'spread_length', -1.137, 0.05203),
  ('keyboard', 9, 'spread_width', -1.801, 0.06352),
  ('keyboard', 9, 'tilt_deg', 1.705, 0.45),
  ('keyboard', 9, 'width', -1.642, 0.1287),
  ('keyboard', 9, 'z_max', 0.7519, 0.03976),
  ('keyboard', 9, 'z_min', 0.7461, 0.04156);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.02589, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'area_m2', -2.944, 0.3734),
  ('keyboard', 10, 'aspect', 0.9915, 0.4227),
  ('keyboard', 10, 'behind', 0.1196, 0.09244),
  ('keyboard', 10, 'edge_free', 0.1346, 0.1497),
  ('keyboard', 10, 'edge_free_top', -0.0005631, 0.3203),
  ('keyboard', 10, 'edge_joined', 0.855, 0.1399),
  ('keyboard', 10, 'edge_unseen', 0.1226, 0.1639),
  ('keyboard', 10, 'height', 0.1313, 0.08785),
  ('keyboard', 10, 'length', -0.928, 0.3362),
  ('keyboard', 10, 'rectangularity', 0.9132, 0.04037),
  ('keyboard', 10, 'spread_length', -0.9603, 0.3892),
  ('keyboard', 10, 'spread_width', -1.958, 0.04402),
  ('keyboard', 10, 'tilt_deg', 2.507, 1.084),
  ('keyboard', 10, 'width', -1.909, 0.05931),
  ('keyboard', 10, 'z_max', 0.1239, 0.0869),
  ('keyboard', 10, 'z_min', 0.1278, 0.0825);

-- chair_seat: 476 examples
UPDATE object_class SET prior = 0.00773 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -1.984, 0.4834)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.2766, 0.2747)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6664, 0.1583)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.6243, 0.1969)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_joined', 0.08796, 0.11)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_unseen', 0.0447, 0.106)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4691, 0.03001)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7017, 0.1627)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7513, 0.1288)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.764, 0.159)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.18, 0.3386)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 0.6273, 0.7031)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -0.9778, 0.3181)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4716, 0.0301)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4669, 0.0302)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_seat';
DELETE FROM class_density WHERE class = 'chair_seat';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.1523, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'area_m2', -1.616, 0.1079),
  ('chair_seat', 1, 'aspect', 0.1177, 0.07838),
  ('chair_seat', 1, 'behind', 0.6959, 0.09051),
  ('chair_seat', 1, 'edge_free', 0.7838, 0.1124),
  ('chair_seat', 1, 'edge_free_top', -0.0001493, 0.3158),
  ('chair_seat', 1, 'edge_joined', 0.06143, 0.07599),
  ('chair_seat', 1, 'edge_unseen', 0.006339, 0.03033),
  ('chair_seat', 1, 'height', 0.4445, 0.0225),
  ('chair_seat', 1, 'length', -0.6678, 0.07881),
  ('chair_seat', 1, 'rectangularity', 0.849, 0.07032),
  ('chair_seat', 1, 'spread_length', -0.7229, 0.05587),
  ('chair_seat', 1, 'spread_width', -0.9194, 0.07386),
  ('chair_seat', 1, 'tilt_deg', 0.3984, 0.4533),
  ('chair_seat', 1, 'width', -0.7845, 0.07548),
  ('chair_seat', 1, 'z_max', 0.449, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4445, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.1185, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'area_m2', -1.613, 0.1199),
  ('chair_seat', 2, 'aspect', 0.1127, 0.0769),
  ('chair_seat', 2, 'behind', 0.6634, 0.08127),
  ('chair_seat', 2, 'edge_free', 0.7756, 0.1196),
  ('chair_seat', 2, 'edge_free_top', -5.097e-05, 0.316),
  ('chair_seat', 2, 'edge_joined', 0.05956, 0.07358),
  ('chair_seat', 2, 'edge_unseen', 0.00226, 0.03161),
  ('chair_seat', 2, 'height', 0.493, 0.0225),
  ('chair_seat', 2, 'length', -0.6643, 0.07989),
  ('chair_seat', 2, 'rectangularity', 0.8458, 0.05822),
  ('chair_seat', 2, 'spread_length', -0.7214, 0.06654),
  ('chair_seat', 2, 'spread_width', -0.9194, 0.08347),
  ('chair_seat', 2, 'tilt_deg', 0.4281, 0.4589),
  ('chair_seat', 2, 'width', -0.7831, 0.07569),
  ('chair_seat', 2, 'z_max', 0.4927, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4888, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.1549, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'area_m2', -1.951, 0.2923),
  ('chair_seat', 3, 'aspect', 0.2158, 0.1635),
  ('chair_seat', 3, 'behind', 0.6503, 0.09064),
  ('chair_seat', 3, 'edge_free', 0.576, 0.1388),
  ('chair_seat', 3, 'edge_free_top', -0.0003158, 0.3158),
  ('chair_seat', 3, 'edge_joined', 0.07698, 0.09517),
  ('chair_seat', 3, 'edge_unseen', 0.07458, 0.103),
  ('chair_seat', 3, 'height', 0.4983, 0.0225),
  ('chair_seat', 3, 'length', -0.6466, 0.1502),
  ('chair_seat', 3, 'rectangularity', 0.6624, 0.0995),
  ('chair_seat', 3, 'spread_length', -0.7148, 0.113),
  ('chair_seat', 3, 'spread_width', -1.164, 0.156),
  ('chair_seat', 3, 'tilt_deg', 0.4712, 0.45),
  ('chair_seat', 3, 'width', -0.875, 0.1232),
  ('chair_seat', 3, 'z_max', 0.501, 0.0225),
  ('chair_seat', 3, 'z_min', 0.4971, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.125, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'area_m2', -1.869, 0.1178),
  ('chair_seat', 4, 'aspect', 0.1242, 0.07905),
  ('chair_seat', 4, 'behind', 0.721, 0.08451),
  ('chair_seat', 4, 'edge_free', 0.5237, 0.1089),
  ('chair_seat', 4, 'edge_free_top', -0.0002842, 0.3159),
  ('chair_seat', 4, 'edge_joined', 0.1795, 0.1263),
  ('chair_seat', 4, 'edge_unseen', 0.003146, 0.03037),
  ('chair_seat', 4, 'height', 0.4608, 0.0225),
  ('chair_seat', 4, 'length', -0.7094, 0.06538),
  ('chair_seat', 4, 'rectangularity', 0.7317, 0.08263),
  ('chair_seat', 4, 'spread_length', -0.7106, 0.07072),
  ('chair_seat', 4, 'spread_width', -1.054, 0.1014),
  ('chair_seat', 4, 'tilt_deg', 0.4181, 0.45),
  ('chair_seat', 4, 'width', -0.8417, 0.0677),
  ('chair_seat', 4, 'z_max', 0.4621, 0.0225),
  ('chair_seat', 4, 'z_min', 0.4587, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.05329, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'area_m2', -2.315, 0.2295),
  ('chair_seat', 5, 'aspect', 0.362, 0.1887),
  ('chair_seat', 5, 'behind', 0.5779, 0.2972),
  ('chair_seat', 5, 'edge_free', 0.5264, 0.2317),
  ('chair_seat', 5, 'edge_free_top', -0.0001948, 0.3162),
  ('chair_seat', 5, 'edge_joined', 0.09812, 0.1255),
  ('chair_seat', 5, 'edge_unseen', 0.16, 0.2167),
  ('chair_seat', 5, 'height', 0.4452, 0.0225),
  ('chair_seat', 5, 'length', -0.7776, 0.119),
  ('chair_seat', 5, 'rectangularity', 0.6774, 0.1426),
  ('chair_seat', 5, 'spread_length', -0.8214, 0.1385),
  ('chair_seat', 5, 'spread_width', -1.37, 0.1584),
  ('chair_seat', 5, 'tilt_deg', 0.855, 0.791),
  ('chair_seat', 5, 'width', -1.149, 0.1527),
  ('chair_seat', 5, 'z_max', 0.4515, 0.0225),
  ('chair_seat', 5, 'z_min', 0.4436, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.05707, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'area_m2', -1.849, 0.4711),
  ('chair_seat', 6, 'aspect', 0.3682, 0.2575),
  ('chair_seat', 6, 'behind', 0.7753, 0.06915),
  ('chair_seat', 6, 'edge_free', 0.5758, 0.06739),
  ('chair_seat', 6, 'edge_free_top', -0.0001617, 0.3159),
  ('chair_seat', 6, 'edge_joined', 0.03076, 0.05103),
  ('chair_seat', 6, 'edge_unseen', 0.003833, 0.03),
  ('chair_seat', 6, 'height', 0.4433, 0.0225),
  ('chair_seat', 6, 'length', -0.5111, 0.269),
  ('chair_seat', 6, 'rectangularity', 0.6457, 0.1347),
  ('chair_seat', 6, 'spread_length', -0.66, 0.1651),
  ('chair_seat', 6, 'spread_width', -1.123, 0.1435),
  ('chair_seat', 6, 'tilt_deg', 0.4299, 0.45),
  ('chair_seat', 6, 'width', -0.8764, 0.1759),
  ('chair_seat', 6, 'z_max', 0.4472, 0.0225),
  ('chair_seat', 6, 'z_min', 0.4426, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.1086, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'area_m2', -2.629, 0.2819),
  ('chair_seat', 7, 'aspect', 0.829, 0.203),
  ('chair_seat', 7, 'behind', 0.7455, 0.07069),
  ('chair_seat', 7, 'edge_free', 0.4471, 0.1468),
  ('chair_seat', 7, 'edge_free_top', -0.0004287, 0.3161),
  ('chair_seat', 7, 'edge_joined', 0.05702, 0.05757),
  ('chair_seat', 7, 'edge_unseen', 0.005655, 0.03),
  ('chair_seat', 7, 'height', 0.4754, 0.0225),
  ('chair_seat', 7, 'length', -0.7114, 0.1057),
  ('chair_seat', 7, 'rectangularity', 0.7101, 0.1132),
  ('chair_seat', 7, 'spread_length', -0.7592, 0.1117),
  ('chair_seat', 7, 'spread_width', -1.795, 0.2031),
  ('chair_seat', 7, 'tilt_deg', 1.138, 0.9751),
  ('chair_seat', 7, 'width', -1.556, 0.2438),
  ('chair_seat', 7, 'z_max', 0.481, 0.0225),
  ('chair_seat', 7, 'z_min', 0.4744, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.129, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'area_m2', -2.603, 0.3604),
  ('chair_seat', 8, 'aspect', 0.5898, 0.2584),
  ('chair_seat', 8, 'behind', 0.5427, 0.2718),
  ('chair_seat', 8, 'edge_free', 0.5107, 0.1923),
  ('chair_seat', 8, 'edge_free_top', -0.0004273, 0.3158),
  ('chair_seat', 8, 'edge_joined', 0.1338, 0.1414),
  ('chair_seat', 8, 'edge_unseen', 0.1734, 0.1592),
  ('chair_seat', 8, 'height', 0.4945, 0.0225),
  ('chair_seat', 8, 'length', -0.8385, 0.2223),
  ('chair_seat', 8, 'rectangularity', 0.7321, 0.1144),
  ('chair_seat', 8, 'spread_length', -0.9159, 0.2342),
  ('chair_seat', 8, 'spread_width', -1.614, 0.2184),
  ('chair_seat', 8, 'tilt_deg', 0.7933, 0.5138),
  ('chair_seat', 8, 'width', -1.437, 0.2109),
  ('chair_seat', 8, 'z_max', 0.498, 0.0225),
  ('chair_seat', 8, 'z_min', 0.4927, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.05126, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'area_m2', -3.205, 0.3772),
  ('chair_seat', 9, 'aspect', 0.5277, 0.2453),
  ('chair_seat', 9, 'behind', 0.3508, 0.3758),
  ('chair_seat', 9, 'edge_free', 0.4827, 0.1775),
  ('chair_seat', 9, 'edge_free_top', -0.003266, 0.3128),
  ('chair_seat', 9, 'edge_joined', 0.01471, 0.03),
  ('chair_seat', 9, 'edge_unseen', 0.185, 0.1798),
  ('chair_seat', 9, 'height', 0.4422, 0.1369),
  ('chair_seat', 9, 'length', -1.105, 0.2596),
  ('chair_seat', 9, 'rectangularity', 0.6683, 0.06982),
  ('chair_seat', 9, 'spread_length', -1.247, 0.323),
  ('chair_seat', 9, 'spread_width', -1.913, 0.1385),
  ('chair_seat', 9, 'tilt_deg', 2.558, 1.918),
  ('chair_seat', 9, 'width', -1.67, 0.1663),
  ('chair_seat', 9, 'z_max', 0.4567, 0.1182),
  ('chair_seat', 9, 'z_min', 0.4556, 0.1156);

-- chair_back: 472 examples
UPDATE object_class SET prior = 0.04998 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.697, 0.5405)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3704, 0.2731)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.5839, 0.2817)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.7974, 0.1919)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9492, 0.1577)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_joined', 0.1158, 0.1567)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_unseen', 0.07329, 0.154)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8158, 0.07731)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5335, 0.2559)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7842, 0.1197)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.7005, 0.2169)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.099, 0.3549)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.48, 3.815)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9065, 0.2989)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.025, 0.08898)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4436, 0.1529)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_back';
DELETE FROM class_density WHERE class = 'chair_back';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1087, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'area_m2', -1.365, 0.1264),
  ('chair_back', 1, 'aspect', 0.1687, 0.09114),
  ('chair_back', 1, 'behind', 0.7507, 0.05625),
  ('chair_back', 1, 'edge_free', 0.8791, 0.09364),
  ('chair_back', 1, 'edge_free_top', 0.9991, 0.03001),
  ('chair_back', 1, 'edge_joined', 0.03537, 0.0473),
  ('chair_back', 1, 'edge_unseen', 0.002781, 0.03125),
  ('chair_back', 1, 'height', 0.7885, 0.08022),
  ('chair_back', 1, 'length', -0.5216, 0.09197),
  ('chair_back', 1, 'rectangularity', 0.8925, 0.03101),
  ('chair_back', 1, 'spread_length', -0.685, 0.04919),
  ('chair_back', 1, 'spread_width', -0.8168, 0.09567),
  ('chair_back', 1, 'tilt_deg', 80.91, 2.622),
  ('chair_back', 1, 'width', -0.6877, 0.07692),
  ('chair_back', 1, 'z_max', 1.009, 0.0958),
  ('chair_back', 1, 'z_min', 0.4196, 0.09882);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.09853, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'area_m2', -1.447, 0.192),
  ('chair_back', 2, 'aspect', 0.1962, 0.1392),
  ('chair_back', 2, 'behind', 0.753, 0.1005),
  ('chair_back', 2, 'edge_free', 0.5538, 0.09838),
  ('chair_back', 2, 'edge_free_top', 0.8358, 0.2359),
  ('chair_back', 2, 'edge_joined', 0.3785, 0.1622),
  ('chair_back', 2, 'edge_unseen', 0.00169, 0.03213),
  ('chair_back', 2, 'height', 0.8075, 0.05632),
  ('chair_back', 2, 'length', -0.5073, 0.1336),
  ('chair_back', 2, 'rectangularity', 0.7988, 0.0819),
  ('chair_back', 2, 'spread_length', -0.6754, 0.08074),
  ('chair_back', 2, 'spread_width', -0.8434, 0.1332),
  ('chair_back', 2, 'tilt_deg', 79.01, 2.656),
  ('chair_back', 2, 'width', -0.7107, 0.09997),
  ('chair_back', 2, 'z_max', 1.011, 0.06356),
  ('chair_back', 2, 'z_min', 0.42, 0.04722);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.114, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'area_m2', -1.653, 0.1742),
  ('chair_back', 3, 'aspect', 0.1363, 0.1054),
  ('chair_back', 3, 'behind', 0.3543, 0.3424),
  ('chair_back', 3, 'edge_free', 0.8159, 0.14),
  ('chair_back', 3, 'edge_free_top', 0.9977, 0.03044),
  ('chair_back', 3, 'edge_joined', 0.1183, 0.1527),
  ('chair_back', 3, 'edge_unseen', 0.09164, 0.1141),
  ('chair_back', 3, 'height', 0.801, 0.05031),
  ('chair_back', 3, 'length', -0.6774, 0.103),
  ('chair_back', 3, 'rectangularity', 0.8891, 0.05464),
  ('chair_back', 3, 'spread_length', -0.7604, 0.04147),
  ('chair_back', 3, 'spread_width', -0.9468, 0.1132),
  ('chair_back', 3, 'tilt_deg', 81.38, 2.454),
  ('chair_back', 3, 'width', -0.8346, 0.08314),
  ('chair_back', 3, 'z_max', 0.9808, 0.06251),
  ('chair_back', 3, 'z_min', 0.4994, 0.08951);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.1267, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'area_m2', -1.216, 0.1676),
  ('chair_back', 4, 'aspect', 0.4522, 0.1126),
  ('chair_back', 4, 'behind', 0.4749, 0.265),
  ('chair_back', 4, 'edge_free', 0.982, 0.0303),
  ('chair_back', 4, 'edge_free_top', 0.9982, 0.03),
  ('chair_back', 4, 'edge_joined', 0.01262, 0.03068),
  ('chair_back', 4, 'edge_unseen', 0.03937, 0.0861),
  ('chair_back', 4, 'height', 0.8265, 0.04981),
  ('chair_back', 4, 'length', -0.314, 0.08767),
  ('chair_back', 4, 'rectangularity', 0.8644, 0.07189),
  ('chair_back', 4, 'spread_length', -0.5009, 0.06176),
  ('chair_back', 4, 'spread_width', -0.8891, 0.1617),
  ('chair_back', 4, 'tilt_deg', 80.46, 2.957),
  ('chair_back', 4, 'width', -0.76, 0.09688),
  ('chair_back', 4, 'z_max', 1.076, 0.05997),
  ('chair_back', 4, 'z_min', 0.3579, 0.04874);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.14, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'area_m2', -2.56, 0.4835),
  ('chair_back', 5, 'aspect', 0.609, 0.3912),
  ('chair_back', 5, 'behind', 0.4271, 0.4287),
  ('chair_back', 5, 'edge_free', 0.5725, 0.1653),
  ('chair_back', 5, 'edge_free_top', 0.7416, 0.3462),
  ('chair_back', 5, 'edge_joined', 0.1528, 0.1906),
  ('chair_back', 5, 'edge_unseen', 0.1292, 0.1975),
  ('chair_back', 5, 'height', 0.822, 0.09092),
  ('chair_back', 5, 'length', -0.7541, 0.2627),
  ('chair_back', 5, 'rectangularity', 0.7174, 0.155),
  ('chair_back', 5, 'spread_length', -0.864, 0.1489),
  ('chair_back', 5, 'spread_width', -1.762, 0.2346),
  ('chair_back', 5, 'tilt_deg', 80.23, 2.554),
  ('chair_back', 5, 'width', -1.437, 0.3121),
  ('chair_back', 5, 'z_max', 1.044, 0.07351),
  ('chair_back', 5, 'z_min', 0.5511, 0.05468);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.08705, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'area_m2', -1.915, 0.2025),
  ('chair_back', 6, 'aspect', 0.3813, 0.1388),
  ('chair_back', 6, 'behind', 0.7318, 0.08298),
  ('chair_back', 6, 'edge_free', 0.7667, 0.1255),
  ('chair_back', 6, 'edge_free_top', 0.9938, 0.03),
  ('chair_back', 6, 'edge_joined', 0.07866, 0.07304),
  ('chair_back', 6, 'edge_unseen', 0.003693, 0.03004),
  ('chair_back', 6, 'height', 0.7787, 0.06723),
  ('chair_back', 6, 'length', -0.6491, 0.1418),
  ('chair_back', 6, 'rectangularity', 0.8062, 0.08791),
  ('chair_back', 6, 'spread_length', -0.7782, 0.1307),
  ('chair_back', 6, 'spread_width', -1.264, 0.09672),
  ('chair_back', 6, 'tilt_deg', 80.16, 2.788),
  ('chair_back', 6, 'width', -1.036, 0.1442),
  ('chair_back', 6, 'z_max', 0.9522, 0.07213),
  ('chair_back', 6, 'z_min', 0.4507, 0.08039);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.06134, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'area_m2', -2.574, 0.5898),
  ('chair_back', 7, 'aspect', 0.3302, 0.1679),
  ('chair_back', 7, 'behind', 0.0858, 0.1567),
  ('chair_back', 7, 'edge_free', 0.9978, 0.03029),
  ('chair_back', 7, 'edge_free_top', 0.9987, 0.03385),
  ('chair_back', 7, 'edge_joined', 0.003013, 0.03198),
  ('chair_back', 7, 'edge_unseen', 0.4674, 0.134),
  ('chair_back', 7, 'height', 0.8876, 0.1734),
  ('chair_back', 7, 'length', -0.8518, 0.2582),
  ('chair_back', 7, 'rectangularity', 0.6348, 0.06525),
  ('chair_back', 7, 'spread_length', -1.089, 0.2853),
  ('chair_back', 7, 'spread_width', -1.58, 0.3447),
  ('chair_back', 7, 'tilt_deg', 80.36, 2.416),
  ('chair_back', 7, 'width', -1.275, 0.3487),
  ('chair_back', 7, 'z_max', 1.007, 0.0892),
  ('chair_back', 7, 'z_min', 0.592, 0.1265);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.1082, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'area_m2', -1.758, 0.2832),
  ('chair_back', 8, 'aspect', 0.7337, 0.1745),
  ('chair_back', 8, 'behind', 0.7539, 0.0716),
  ('chair_back', 8, 'edge_free', 0.815, 0.1039),
  ('chair_back', 8, 'edge_free_top', 0.9933, 0.03),
  ('chair_back', 8, 'edge_joined', 0.1219, 0.08226),
  ('chair_back', 8, 'edge_unseen', 0.004192, 0.03),
  ('chair_back', 8, 'height', 0.8446, 0.04913),
  ('chair_back', 8, 'length', -0.3449, 0.104),
  ('chair_back', 8, 'rectangularity', 0.7218, 0.1291),
  ('chair_back', 8, 'spread_length', -0.5584, 0.08992),
  ('chair_back', 8, 'spread_width', -1.407, 0.1707),
  ('chair_back', 8, 'tilt_deg', 79.76, 2.681),
  ('chair_back', 8, 'width', -1.081, 0.2084),
  ('chair_back', 8, 'z_max', 1.109, 0.0592),
  ('chair_back', 8, 'z_min', 0.4172, 0.06725);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.1054, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'area_m2', -1.208, 0.2114),
  ('chair_back', 9, 'aspect', 0.6645, 0.253),
  ('chair_back', 9, 'behind', 0.6635, 0.1876),
  ('chair_back', 9, 'edge_free', 0.7692, 0.1709),
  ('chair_back', 9, 'edge_free_top', 0.9783, 0.05389),
  ('chair_back', 9, 'edge_joined', 0.1676, 0.1497),
  ('chair_back', 9, 'edge_unseen', 0.03406, 0.07237),
  ('chair_back', 9, 'height', 0.7938, 0.05937),
  ('chair_back', 9, 'length', -0.1057, 0.1753),
  ('chair_back', 9, 'rectangularity', 0.6586, 0.08964),
  ('chair_back', 9, 'spread_length', -0.4455, 0.1318),
  ('chair_back', 9, 'spread_width', -0.923, 0.2067),
  ('chair_back', 9, 'tilt_deg', 80.39, 2.592),
  ('chair_back', 9, 'width', -0.7159, 0.1833),
  ('chair_back', 9, 'z_max', 1.047, 0.08672),
  ('chair_back', 9, 'z_min', 0.1002, 0.1055);

-- door: 294 examples
UPDATE object_class SET prior = 0.01637 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.2535, 0.5714)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.8187, 0.2899)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.1612, 0.2552)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.141, 0.2434)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.2385, 0.3801)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_joined', 0.3707, 0.3351)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_unseen', 0.108, 0.1749)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.146, 0.1841)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.644, 0.2491)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8196, 0.1264)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4796, 0.2817)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.3043, 0.3744)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.73, 1.289)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1777, 0.34)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.054, 0.2564)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1171, 0.2716)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'door';
DELETE FROM class_density WHERE class = 'door';
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.1957, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'area_m2', 0.5573, 0.08802),
  ('door', 1, 'aspect', 0.7785, 0.07888),
  ('door', 1, 'behind', -0.009061, 0.03),
  ('door', 1, 'edge_free', -0.0006361, 0.03),
  ('door', 1, 'edge_free_top', 0.002171, 0.03153),
  ('door', 1, 'edge_joined', 0.4367, 0.321),
  ('door', 1, 'edge_unseen', 0.008717, 0.03246),
  ('door', 1, 'height', 1.077, 0.06656),
  ('door', 1, 'length', 0.7189, 0.03454),
  ('door', 1, 'rectangularity', 0.9062, 0.06889),
  ('door', 1, 'spread_length', 0.6454, 0.0437),
  ('door', 1, 'spread_width', -0.1433, 0.06289),
  ('door', 1, 'tilt_deg', 89.98, 0.477),
  ('door', 1, 'width', -0.07219, 0.07496),
  ('door', 1, 'z_max', 2.049, 0.04672),
  ('door', 1, 'z_min', 0.002678, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1302, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'area_m2', 0.5678, 0.1225),
  ('door', 2, 'aspect', 0.8393, 0.07221),
  ('door', 2, 'behind', 0.4348, 0.1031),
  ('door', 2, 'edge_free', 0.4883, 0.1069),
  ('door', 2, 'edge_free_top', 0.8832, 0.08739),
  ('door', 2, 'edge_joined', 0.1661, 0.1654),
  ('door', 2, 'edge_unseen', 0.03957, 0.08693),
  ('door', 2, 'height', 1.112, 0.07226),
  ('door', 2, 'length', 0.7946, 0.07207),
  ('door', 2, 'rectangularity', 0.8131, 0.07533),
  ('door', 2, 'spread_length', 0.6055, 0.1272),
  ('door', 2, 'spread_width', -0.1411, 0.09331),
  ('door', 2, 'tilt_deg', 89.98, 0.45),
  ('door', 2, 'width', -0.01375, 0.09015),
  ('door', 2, 'z_max', 2.181, 0.09605),
  ('door', 2, 'z_min', -0.01085, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.1869, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'area_m2', 0.2804, 0.1614),
  ('door', 3, 'aspect', 0.7896, 0.1885),
  ('door', 3, 'behind', -0.002779, 0.03),
  ('door', 3, 'edge_free', -0.00181, 0.03),
  ('door', 3, 'edge_free_top', 0.003236, 0.03),
  ('door', 3, 'edge_joined', 0.3496, 0.3327),
  ('door', 3, 'edge_unseen', 0.2276, 0.2304),
  ('door', 3, 'height', 1.239, 0.1293),
  ('door', 3, 'length', 0.6692, 0.09243),
  ('door', 3, 'rectangularity', 0.784, 0.1299),
  ('door', 3, 'spread_length', 0.4019, 0.1377),
  ('door', 3, 'spread_width', -0.2313, 0.1054),
  ('door', 3, 'tilt_deg', 89.93, 0.45),
  ('door', 3, 'width', -0.1354, 0.1074),
  ('door', 3, 'z_max', 2.051, 0.04299),
  ('door', 3, 'z_min', 0.1445, 0.1808);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.2116, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'area_m2', -0.02729, 0.1788),
  ('door', 4, 'aspect', 0.5186, 0.2198),
  ('door', 4, 'behind', 0.3563, 0.3226),
  ('door', 4, 'edge_free', 0.2397, 0.34),
  ('door', 4, 'edge_free_top', 0.3335, 0.3508),
  ('door', 4, 'edge_joined', 0.4449, 0.3512),
  ('door', 4, 'edge_unseen', 0.2402, 0.1848),
  ('door', 4, 'height', 1.393, 0.09202),
  ('door', 4, 'length', 0.4201, 0.2125),
  ('door', 4, 'rectangularity', 0.7063, 0.1283),
  ('door', 4, 'spread_length', 0.0113, 0.1778),
  ('door', 4, 'spread_width', -0.2272, 0.1007),
  ('door', 4, 'tilt_deg', 90.02, 0.45),
  ('door', 4, 'width', -0.09794, 0.0633),
  ('door', 4, 'z_max', 2.115, 0.06843),
  ('door', 4, 'z_min', 0.5931, 0.2439);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.04921, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'area_m2', -1.213, 0.8427),
  ('door', 5, 'aspect', 1.038, 0.6024),
  ('door', 5, 'behind', 0.2481, 0.3977),
  ('door', 5, 'edge_free', 0.263, 0.2873),
  ('door', 5, 'edge_free_top', 0.2626, 0.3335),
  ('door', 5, 'edge_joined', 0.2819, 0.2612),
  ('door', 5, 'edge_unseen', 0.2819, 0.1796),
  ('door', 5, 'height', 1.352, 0.276),
  ('door', 5, 'length', 0.06628, 0.3329),
  ('door', 5, 'rectangularity', 0.7121, 0.06938),
  ('door', 5, 'spread_length', -0.1303, 0.1886),
  ('door', 5, 'spread_width', -1.134, 0.6697),
  ('door', 5, 'tilt_deg', 87.93, 2.844),
  ('door', 5, 'width', -0.9648, 0.6718),
  ('door', 5, 'z_max', 1.792, 0.2274),
  ('door', 5, 'z_min', 0.8536, 0.4962);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.04375, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'area_m2', 0.5309, 0.1337),
  ('door', 6, 'aspect', 0.8469, 0.07043),
  ('door', 6, 'behind', 0.6449, 0.08075),
  ('door', 6, 'edge_free', 0.1435, 0.08347),
  ('door', 6, 'edge_free_top', 0.5082, 0.1297),
  ('door', 6, 'edge_joined', 0.7836, 0.09987),
  ('door', 6, 'edge_unseen', 0.008235, 0.03),
  ('door', 6, 'height', 1.059, 0.04027),
  ('door', 6, 'length', 0.7721, 0.0667),
  ('door', 6, 'rectangularity', 0.8474, 0.04822),
  ('door', 6, 'spread_length', 0.6775, 0.0417),
  ('door', 6, 'spread_width', -0.09209, 0.1131),
  ('door', 6, 'tilt_deg', 89.95, 0.45),
  ('door', 6, 'width', -0.07495, 0.07164),
  ('door', 6, 'z_max', 2.178, 0.1131),
  ('door', 6, 'z_min', 0.005771, 0.04354);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.05213, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'area_m2', -0.06348, 0.1321),
  ('door', 7, 'aspect', 1.249, 0.1705),
  ('door', 7, 'behind', 0.1395, 0.1515),
  ('door', 7, 'edge_free', 0.2018, 0.2302),
  ('door', 7, 'edge_free_top', 0.3874, 0.3723),
  ('door', 7, 'edge_joined', 0.144, 0.176),
  ('door', 7, 'edge_unseen', 0.3373, 0.1241),
  ('door', 7, 'height', 1.125, 0.08814),
  ('door', 7, 'length', 0.781, 0.08802),
  ('door', 7, 'rectangularity', 0.6879, 0.1055),
  ('door', 7, 'spread_length', 0.6228, 0.1358),
  ('door', 7, 'spread_width', -0.816, 0.2092),
  ('door', 7, 'tilt_deg', 85.76, 4.252),
  ('door', 7, 'width', -0.4606, 0.1595),
  ('door', 7, 'z_max', 2.074, 0.1338),
  ('door', 7, 'z_min', 0.01001, 0.03426);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.02092, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'area_m2', -0.5721, 0.2464),
  ('door', 8, 'aspect', 1.562, 0.3159),
  ('door', 8, 'behind', 0.04021, 0.1039),
  ('door', 8, 'edge_free', 0.05592, 0.1498),
  ('door', 8, 'edge_free_top', 0.09737, 0.2305),
  ('door', 8, 'edge_joined', 0.3741, 0.2682),
  ('door', 8, 'edge_unseen', 0.1565, 0.1915),
  ('door', 8, 'height', 1.073, 0.1545),
  ('door', 8, 'length', 0.6535, 0.08661),
  ('door', 8, 'rectangularity', 0.7877, 0.1654),
  ('door', 8, 'spread_length', 0.5758, 0.133),
  ('door', 8, 'spread_width', -1.211, 0.2571),
  ('door', 8, 'tilt_deg', 89.9, 0.5068),
  ('door', 8, 'width', -0.9472, 0.2591),
  ('door', 8, 'z_max', 2.042, 0.03756),
  ('door', 8, 'z_min', 0.1095, 0.1478);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.02109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'area_m2', 0.7315, 0.3239),
  ('door', 9, 'aspect', 0.449, 0.1997),
  ('door', 9, 'behind', 0.01502, 0.04737),
  ('door', 9, 'edge_free', 0.01175, 0.03524),
  ('door', 9, 'edge_free_top', 0.02667, 0.0636),
  ('door', 9, 'edge_joined', 0.6065, 0.2297),
  ('door', 9, 'edge_unseen', 0.2048, 0.168),
  ('door', 9, 'height', 1.122, 0.138),
  ('door', 9, 'length', 0.8533, 0.1275),
  ('door', 9, 'rectangularity', 0.5947, 0.05757),
  ('door', 9, 'spread_length', 0.578, 0.1585),
  ('door', 9, 'spread_width', 0.03664, 0.1962),
  ('door', 9, 'tilt_deg', 89.91, 0.4609),
  ('door', 9, 'width', 0.3966, 0.277),
  ('door', 9, 'z_max', 2.369, 0.3244),
  ('door', 9, 'z_min', 0.03782, 0.08069);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.03849, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'area_m2', -1.163, 0.6076),
  ('door', 10, 'aspect', 0.8562, 0.2148),
  ('door', 10, 'behind', 0.07818, 0.1777),
  ('door', 10, 'edge_free', 0.109, 0.1267),
  ('door', 10, 'edge_free_top', 0.1005, 0.1794),
  ('door', 10, 'edge_joined', 0.252, 0.1575),
  ('door', 10, 'edge_unseen', 0.1105, 0.1483),
  ('door', 10, 'height', 0.5324, 0.2115),
  ('door', 10, 'length', -0.0302, 0.2814),
  ('door', 10, 'rectangularity', 0.8195, 0.1047),
  ('door', 10, 'spread_length', -0.07165, 0.2593),
  ('door', 10, 'spread_width', -1.008, 0.2225),
  ('door', 10, 'tilt_deg', 89.35, 0.76),
  ('door', 10, 'width', -0.9117, 0.2098),
  ('door', 10, 'z_max', 0.9339, 0.3157),
  ('door', 10, 'z_min', 0.04895, 0.0645);

-- window: 646 examples
UPDATE object_class SET prior = 0.02595 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', -0.3409, 0.7348)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.4516, 0.4039)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 0.002865, 0.02572)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.08415, 0.1628)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.07209, 0.1987)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_joined', 0.3914, 0.3573)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_unseen', 0.1441, 0.1671)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.5, 0.2069)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.1754, 0.2889)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8043, 0.1428)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.1625, 0.3429)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.3865, 0.5602)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.74, 0.4661)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.2788, 0.4842)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.041, 0.2682)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 1.025, 0.2229)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'window';
DELETE FROM class_density WHERE class = 'window';
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.1653, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'area_m2', -0.05889, 0.1398),
  ('window', 1, 'aspect', 0.2714, 0.1826),
  ('window', 1, 'behind', -0.003357, 0.03),
  ('window', 1, 'edge_free', 0.008007, 0.03542),
  ('window', 1, 'edge_free_top', 0.002744, 0.03),
  ('window', 1, 'edge_joined', 0.535, 0.4336),
  ('window', 1, 'edge_unseen', 0.1494, 0.05464),
  ('window', 1, 'height', 1.44, 0.1446),
  ('window', 1, 'length', 0.2108, 0.1183),
  ('window', 1, 'rectangularity', 0.884, 0.05608),
  ('window', 1, 'spread_length', 0.2408, 0.1241),
  ('window', 1, 'spread_width', -0.1722, 0.1505),
  ('window', 1, 'tilt_deg', 89.48, 0.45),
  ('window', 1, 'width', -0.144, 0.09713),
  ('window', 1, 'z_max', 2.079, 0.1846),
  ('window', 1, 'z_min', 0.9621, 0.06144);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1471, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'area_m2', 0.3241, 0.157),
  ('window', 2, 'aspect', 0.1568, 0.1046),
  ('window', 2, 'behind', -0.0007472, 0.03),
  ('window', 2, 'edge_free', -0.006323, 0.03),
  ('window', 2, 'edge_free_top', -0.00151, 0.03),
  ('window', 2, 'edge_joined', 0.02881, 0.0445),
  ('window', 2, 'edge_unseen', 0.009198, 0.03766),
  ('window', 2, 'height', 1.521, 0.08058),
  ('window', 2, 'length', 0.3297, 0.09766),
  ('window', 2, 'rectangularity', 0.9002, 0.08905),
  ('window', 2, 'spread_length', 0.4826, 0.07287),
  ('window', 2, 'spread_width', 0.2954, 0.1141),
  ('window', 2, 'tilt_deg', 89.82, 0.45),
  ('window', 2, 'width', 0.1103, 0.1044),
  ('window', 2, 'z_max', 2.144, 0.1102),
  ('window', 2, 'z_min', 0.888, 0.05047);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.0857, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'area_m2', -0.7342, 0.2871),
  ('window', 3, 'aspect', 0.4633, 0.3727),
  ('window', 3, 'behind', -0.006126, 0.03),
  ('window', 3, 'edge_free', 0.003033, 0.03),
  ('window', 3, 'edge_free_top', 0.0009198, 0.03),
  ('window', 3, 'edge_joined', 0.6853, 0.3106),
  ('window', 3, 'edge_unseen', 0.3156, 0.2091),
  ('window', 3, 'height', 1.39, 0.1799),
  ('window', 3, 'length', 0.006214, 0.1814),
  ('window', 3, 'rectangularity', 0.7901, 0.1999),
  ('window', 3, 'spread_length', 0.02377, 0.1511),
  ('window', 3, 'spread_width', -0.6157, 0.2515),
  ('window', 3, 'tilt_deg', 89.53, 0.45),
  ('window', 3, 'width', -0.4941, 0.1967),
  ('window', 3, 'z_max', 1.86, 0.2668),
  ('window', 3, 'z_min', 0.9812, 0.06107);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.1631, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'area_m2', -0.5296, 0.4008),
  ('window', 4, 'aspect', 0.556, 0.2963),
  ('window', 4, 'behind', -0.006388, 0.03),
  ('window', 4, 'edge_free', 0.1867, 0.1132),
  ('window', 4, 'edge_free_top', 0.01069, 0.03048),
  ('window', 4, 'edge_joined', 0.433, 0.2727),
  ('window', 4, 'edge_unseen', 0.1825, 0.09893),
  ('window', 4, 'height', 1.841, 0.1223),
  ('window', 4, 'length', 0.1192, 0.2328),
  ('window', 4, 'rectangularity', 0.8105, 0.06016),
  ('window', 4, 'spread_length', 0.175, 0.1612),
  ('window', 4, 'spread_width', -0.6384, 0.2781),
  ('window', 4, 'tilt_deg', 89.8, 0.45),
  ('window', 4, 'width', -0.4844, 0.2762),
  ('window', 4, 'z_max', 2.151, 0.1302),
  ('window', 4, 'z_min', 1.533, 0.2181);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.1149, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'area_m2', -0.06754, 0.2679),
  ('window', 5, 'aspect', 0.2096, 0.1512),
  ('window', 5, 'behind', -0.000856, 0.03),
  ('window', 5, 'edge_free', 0.1132, 0.1263),
  ('window', 5, 'edge_free_top', 0.04904, 0.1002),
  ('window', 5, 'edge_joined', 0.1785, 0.1763),
  ('window', 5, 'edge_unseen', 0.1376, 0.1382),
  ('window', 5, 'height', 1.578, 0.1527),
  ('window', 5, 'length', 0.3408, 0.0974),
  ('window', 5, 'rectangularity', 0.6317, 0.2444),
  ('window', 5, 'spread_length', 0.4314, 0.186),
  ('window', 5, 'spread_width', 0.07301, 0.1821),
  ('window', 5, 'tilt_deg', 89.69, 0.4582),
  ('window', 5, 'width', 0.09324, 0.1019),
  ('window', 5, 'z_max', 2.229, 0.1014),
  ('window', 5, 'z_min', 0.9434, 0.07476);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.08962, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'area_m2', -0.498, 0.4545),
  ('window', 6, 'aspect', 0.3404, 0.2589),
  ('window', 6, 'behind', -0.006973, 0.03),
  ('window', 6, 'edge_free', 0.4407, 0.2569),
  ('window', 6, 'edge_free_top', 0.4957, 0.3284),
  ('window', 6, 'edge_joined', 0.4511, 0.2267),
  ('window', 6, 'edge_unseen', 0.08919, 0.1175),
  ('window', 6, 'height', 1.443, 0.1148),
  ('window', 6, 'length', 0.05723, 0.2091),
  ('window', 6, 'rectangularity', 0.8079, 0.05523),
  ('window', 6, 'spread_length', 0.04439, 0.1923),
  ('window', 6, 'spread_width', -0.4249, 0.2815),
  ('window', 6, 'tilt_deg', 89.75, 0.45),
  ('window', 6, 'width', -0.3334, 0.2545),
  ('window', 6, 'z_max', 2.019, 0.1504),
  ('window', 6, 'z_min', 1.03, 0.06779);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.04583, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'area_m2', -1.782, 0.4021),
  ('window', 7, 'aspect', 0.7379, 0.4178),
  ('window', 7, 'behind', -0.005399, 0.03),
  ('window', 7, 'edge_free', 0.0195, 0.03757),
  ('window', 7, 'edge_free_top', 0.002686, 0.03),
  ('window', 7, 'edge_joined', 0.4901, 0.1971),
  ('window', 7, 'edge_unseen', 0.3282, 0.2067),
  ('window', 7, 'height', 1.513, 0.2818),
  ('window', 7, 'length', -0.2269, 0.362),
  ('window', 7, 'rectangularity', 0.6704, 0.08097),
  ('window', 7, 'spread_length', -0.2259, 0.3453),
  ('window', 7, 'spread_width', -1.379, 0.4422),
  ('window', 7, 'tilt_deg', 89.34, 0.7289),
  ('window', 7, 'width', -1.156, 0.2632),
  ('window', 7, 'z_max', 1.873, 0.3339),
  ('window', 7, 'z_min', 1.221, 0.1948);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.09215, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'area_m2', -1.067, 0.451),
  ('window', 8, 'aspect', 1.259, 0.31),
  ('window', 8, 'behind', -0.0008321, 0.03),
  ('window', 8, 'edge_free', 0.05061, 0.08898),
  ('window', 8, 'edge_free_top', 0.1478, 0.2381),
  ('window', 8, 'edge_joined', 0.314, 0.1432),
  ('window', 8, 'edge_unseen', 0.05114, 0.08087),
  ('window', 8, 'height', 1.055, 0.06514),
  ('window', 8, 'length', 0.2024, 0.1758),
  ('window', 8, 'rectangularity', 0.794, 0.1384),
  ('window', 8, 'spread_length', 0.2383, 0.1431),
  ('window', 8, 'spread_width', -1.153, 0.4335),
  ('window', 8, 'tilt_deg', 88.66, 0.9035),
  ('window', 8, 'width', -1.061, 0.3371),
  ('window', 8, 'z_max', 1.293, 0.127),
  ('window', 8, 'z_min', 0.9219, 0.04211);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.03051, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'area_m2', 1.074, 0.5055),
  ('window', 9, 'aspect', 0.76, 0.2015),
  ('window', 9, 'behind', 0.01239, 0.04544),
  ('window', 9, 'edge_free', 0.06342, 0.1748),
  ('window', 9, 'edge_free_top', 0.06077, 0.1445),
  ('window', 9, 'edge_joined', 0.3413, 0.2501),
  ('window', 9, 'edge_unseen', 0.1433, 0.1016),
  ('window', 9, 'height', 1.429, 0.1011),
  ('window', 9, 'length', 1.148, 0.293),
  ('window', 9, 'rectangularity', 0.6247, 0.1479),
  ('window', 9, 'spread_length', 1.095, 0.2689),
  ('window', 9, 'spread_width', 0.09547, 0.2017),
  ('window', 9, 'tilt_deg', 89.47, 1.174),
  ('window', 9, 'width', 0.3882, 0.3413),
  ('window', 9, 'z_max', 2.385, 0.2733),
  ('window', 9, 'z_min', 0.6226, 0.3681);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.0158, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'area_m2', -1.793, 0.4683),
  ('window', 10, 'aspect', 1.299, 0.4246),
  ('window', 10, 'behind', 0.4193, 0.2533),
  ('window', 10, 'edge_free', 0.243, 0.2376),
  ('window', 10, 'edge_free_top', 0.2066, 0.2263),
  ('window', 10, 'edge_joined', 0.574, 0.2338),
  ('window', 10, 'edge_unseen', 0.06688, 0.06729),
  ('window', 10, 'height', 1.387, 0.08258),
  ('window', 10, 'length', -0.1169, 0.4681),
  ('window', 10, 'rectangularity', 0.7071, 0.09241),
  ('window', 10, 'spread_length', -0.2206, 0.547),
  ('window', 10, 'spread_width', -1.58, 0.2438),
  ('window', 10, 'tilt_deg', 89.82, 0.4652),
  ('window', 10, 'width', -1.341, 0.1517),
  ('window', 10, 'z_max', 1.936, 0.3172),
  ('window', 10, 'z_min', 0.8797, 0.1219);

-- whiteboard: 251 examples
UPDATE object_class SET prior = 0.01029 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.0733, 0.815)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4459, 0.3051)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.008528, 0.05729)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.02744, 0.05243)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.03569, 0.07225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_joined', 0.7775, 0.1945)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_unseen', 0.1549, 0.1859)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.399, 0.1468)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.3632, 0.4029)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.8226, 0.09912)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.2196, 0.4121)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.309, 0.4467)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.82, 0.5077)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', -0.08684, 0.4441)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 1.955, 0.231)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.8652, 0.1829)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'whiteboard';
DELETE FROM class_density WHERE class = 'whiteboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.3396, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'area_m2', 0.6852, 0.1482),
  ('whiteboard', 1, 'aspect', 0.5918, 0.1434),
  ('whiteboard', 1, 'behind', -0.0004219, 0.03),
  ('whiteboard', 1, 'edge_free', 0.03287, 0.03),
  ('whiteboard', 1, 'edge_free_top', 0.03211, 0.03393),
  ('whiteboard', 1, 'edge_joined', 0.8369, 0.1096),
  ('whiteboard', 1, 'edge_unseen', 0.09992, 0.1049),
  ('whiteboard', 1, 'height', 1.42, 0.06634),
  ('whiteboard', 1, 'length', 0.7192, 0.1078),
  ('whiteboard', 1, 'rectangularity', 0.8213, 0.09637),
  ('whiteboard', 1, 'spread_length', 0.5314, 0.1147),
  ('whiteboard', 1, 'spread_width', -0.1545, 0.1135),
  ('whiteboard', 1, 'tilt_deg', 90.05, 0.45),
  ('whiteboard', 1, 'width', 0.1479, 0.08437),
  ('whiteboard', 1, 'z_max', 2.026, 0.1064),
  ('whiteboard', 1, 'z_min', 0.8894, 0.07221);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.1053, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'area_m2', 0.1669, 0.1498),
  ('whiteboard', 2, 'aspect', 0.1177, 0.06976),
  ('whiteboard', 2, 'behind', 0.003582, 0.03506),
  ('whiteboard', 2, 'edge_free', 0.02159, 0.03),
  ('whiteboard', 2, 'edge_free_top', 0.02019, 0.03253),
  ('whiteboard', 2, 'edge_joined', 0.8133, 0.1033),
  ('whiteboard', 2, 'edge_unseen', 0.04542, 0.09011),
  ('whiteboard', 2, 'height', 1.48, 0.06766),
  ('whiteboard', 2, 'length', 0.2104, 0.08545),
  ('whiteboard', 2, 'rectangularity', 0.8741, 0.03227),
  ('whiteboard', 2, 'spread_length', 0.1022, 0.06853),
  ('whiteboard', 2, 'spread_width', -0.05894, 0.09765),
  ('whiteboard', 2, 'tilt_deg', 90.11, 0.45),
  ('whiteboard', 2, 'width', 0.09161, 0.05359),
  ('whiteboard', 2, 'z_max', 2.034, 0.0939),
  ('whiteboard', 2, 'z_min', 0.9032, 0.05135);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.115, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'area_m2', 0.3904, 0.1263),
  ('whiteboard', 3, 'aspect', 0.3027, 0.08018),
  ('whiteboard', 3, 'behind', 0.0004045, 0.03),
  ('whiteboard', 3, 'edge_free', 0.02322, 0.03),
  ('whiteboard', 3, 'edge_free_top', 0.02751, 0.03157),
  ('whiteboard', 3, 'edge_joined', 0.8342, 0.1073),
  ('whiteboard', 3, 'edge_unseen', 0.004676, 0.03),
  ('whiteboard', 3, 'height', 1.476, 0.05787),
  ('whiteboard', 3, 'length', 0.4012, 0.08415),
  ('whiteboard', 3, 'rectangularity', 0.9008, 0.03912),
  ('whiteboard', 3, 'spread_length', 0.3056, 0.06891),
  ('whiteboard', 3, 'spread_width', -0.03148, 0.0839),
  ('whiteboard', 3, 'tilt_deg', 90.04, 0.45),
  ('whiteboard', 3, 'width', 0.1082, 0.0803),
  ('whiteboard', 3, 'z_max', 2.01, 0.09474),
  ('whiteboard', 3, 'z_min', 0.9096, 0.04721);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.09574, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'area_m2', -0.2929, 0.34),
  ('whiteboard', 4, 'aspect', 0.3721, 0.3029),
  ('whiteboard', 4, 'behind', -0.002861, 0.03),
  ('whiteboard', 4, 'edge_free', 0.01669, 0.03903),
  ('whiteboard', 4, 'edge_free_top', 0.007095, 0.03063),
  ('whiteboard', 4, 'edge_joined', 0.7669, 0.1631),
  ('whiteboard', 4, 'edge_unseen', 0.3231, 0.1947),
  ('whiteboard', 4, 'height', 1.353, 0.09391),
  ('whiteboard', 4, 'length', 0.1466, 0.15),
  ('whiteboard', 4, 'rectangularity', 0.785, 0.05534),
  ('whiteboard', 4, 'spread_length', -0.1037, 0.1522),
  ('whiteboard', 4, 'spread_width', -0.5203, 0.1252),
  ('whiteboard', 4, 'tilt_deg', 89.96, 0.45),
  ('whiteboard', 4, 'width', -0.1964, 0.2953),
  ('whiteboard', 4, 'z_max', 2.012, 0.1073),
  ('whiteboard', 4, 'z_min', 0.8777, 0.048);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.08246, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'area_m2', 0.7002, 0.2982),
  ('whiteboard', 5, 'aspect', 0.5584, 0.2342),
  ('whiteboard', 5, 'behind', 0.002276, 0.03),
  ('whiteboard', 5, 'edge_free', 0.04137, 0.06448),
  ('whiteboard', 5, 'edge_free_top', 0.07252, 0.1141),
  ('whiteboard', 5, 'edge_joined', 0.6325, 0.1491),
  ('whiteboard', 5, 'edge_unseen', 0.2103, 0.2048),
  ('whiteboard', 5, 'height', 1.443, 0.09408),
  ('whiteboard', 5, 'length', 0.7815, 0.2316),
  ('whiteboard', 5, 'rectangularity', 0.6724, 0.08501),
  ('whiteboard', 5, 'spread_length', 0.6746, 0.1879),
  ('whiteboard', 5, 'spread_width', -0.1237, 0.2848),
  ('whiteboard', 5, 'tilt_deg', 89.77, 0.553),
  ('whiteboard', 5, 'width', 0.2999, 0.1502),
  ('whiteboard', 5, 'z_max', 2.097, 0.07696),
  ('whiteboard', 5, 'z_min', 0.6429, 0.339);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.03388, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'area_m2', -1.605, 0.5423),
  ('whiteboard', 6, 'aspect', 0.8382, 0.3552),
  ('whiteboard', 6, 'behind', -0.002461, 0.03),
  ('whiteboard', 6, 'edge_free', 0.02635, 0.0409),
  ('whiteboard', 6, 'edge_free_top', 0.0622, 0.04825),
  ('whiteboard', 6, 'edge_joined', 0.7856, 0.2692),
  ('whiteboard', 6, 'edge_unseen', 0.3687, 0.164),
  ('whiteboard', 6, 'height', 1.442, 0.2213),
  ('whiteboard', 6, 'length', -0.2361, 0.2885),
  ('whiteboard', 6, 'rectangularity', 0.7511, 0.08073),
  ('whiteboard', 6, 'spread_length', -0.514, 0.2786),
  ('whiteboard', 6, 'spread_width', -1.261, 0.4032),
  ('whiteboard', 6, 'tilt_deg', 89.63, 0.4684),
  ('whiteboard', 6, 'width', -1.073, 0.4142),
  ('whiteboard', 6, 'z_max', 1.868, 0.1635),
  ('whiteboard', 6, 'z_min', 1.103, 0.3267);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.1, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'area_m2', -0.3028, 0.415),
  ('whiteboard', 7, 'aspect', 0.8495, 0.4582),
  ('whiteboard', 7, 'behind', -0.0006561, 0.03),
  ('whiteboard', 7, 'edge_free', 0.01252, 0.03),
  ('whiteboard', 7, 'edge_free_top', 0.06771, 0.03),
  ('whiteboard', 7, 'edge_joined', 0.5355, 0.15),
  ('whiteboard', 7, 'edge_unseen', 0.4049, 0.06813),
  ('whiteboard', 7, 'height', 1.001, 0.2336),
  ('whiteboard', 7, 'length', 0.3588, 0.2754),
  ('whiteboard', 7, 'rectangularity', 0.8066, 0.07855),
  ('whiteboard', 7, 'spread_length', 0.2578, 0.2692),
  ('whiteboard', 7, 'spread_width', -0.6283, 0.3206),
  ('whiteboard', 7, 'tilt_deg', 87.92, 0.5723),
  ('whiteboard', 7, 'width', -0.4536, 0.3178),
  ('whiteboard', 7, 'z_max', 1.299, 0.2408),
  ('whiteboard', 7, 'z_min', 0.556, 0.3529);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.03069, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'area_m2', -0.08713, 0.2323),
  ('whiteboard', 8, 'aspect', 0.2674, 0.1324),
  ('whiteboard', 8, 'behind', 0.0005795, 0.03),
  ('whiteboard', 8, 'edge_free', 0.2657, 0.2731),
  ('whiteboard', 8, 'edge_free_top', 0.2546, 0.191),
  ('whiteboard', 8, 'edge_joined', 0.5642, 0.2192),
  ('whiteboard', 8, 'edge_unseen', 0.102, 0.1274),
  ('whiteboard', 8, 'height', 1.381, 0.03148),
  ('whiteboard', 8, 'length', 0.2219, 0.1346),
  ('whiteboard', 8, 'rectangularity', 0.7767, 0.08384),
  ('whiteboard', 8, 'spread_length', 0.08475, 0.1461),
  ('whiteboard', 8, 'spread_width', -0.3535, 0.1434),
  ('whiteboard', 8, 'tilt_deg', 89.89, 0.45),
  ('whiteboard', 8, 'width', -0.04403, 0.09816),
  ('whiteboard', 8, 'z_max', 1.891, 0.07228),
  ('whiteboard', 8, 'z_min', 0.8429, 0.03256);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 9, 0.02693, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 9, 'area_m2', -2.349, 0.5297),
  ('whiteboard', 9, 'aspect', 0.4467, 0.1539),
  ('whiteboard', 9, 'behind', -5.062e-05, 0.03),
  ('whiteboard', 9, 'edge_free', 0.0007536, 0.03),
  ('whiteboard', 9, 'edge_free_top', 0.004065, 0.03),
  ('whiteboard', 9, 'edge_joined', 0.8008, 0.1854),
  ('whiteboard', 9, 'edge_unseen', 0.1879, 0.1453),
  ('whiteboard', 9, 'height', 1.159, 0.1183),
  ('whiteboard', 9, 'length', -0.8131, 0.2859),
  ('whiteboard', 9, 'rectangularity', 0.7918, 0.03676),
  ('whiteboard', 9, 'spread_length', -1.046, 0.2708),
  ('whiteboard', 9, 'spread_width', -1.457, 0.256),
  ('whiteboard', 9, 'tilt_deg', 89.63, 0.45),
  ('whiteboard', 9, 'width', -1.3, 0.2618),
  ('whiteboard', 9, 'z_max', 1.355, 0.1436),
  ('whiteboard', 9, 'z_min', 0.8869, 0.05446);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 10, 0.02035, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 10, 'area_m2', 0.2691, 0.246),
  ('whiteboard', 10, 'aspect', 0.2589, 0.136),
  ('whiteboard', 10, 'behind', 0.3695, 0.09201),
  ('whiteboard', 10, 'edge_free', 0.02129, 0.03),
  ('whiteboard', 10, 'edge_free_top', 0.01322, 0.03),
  ('whiteboard', 10, 'edge_joined', 0.843, 0.09429),
  ('whiteboard', 10, 'edge_unseen', 0.02536, 0.04367),
  ('whiteboard', 10, 'height', 1.469, 0.07177),
  ('whiteboard', 10, 'length', 0.3651, 0.1532),
  ('whiteboard', 10, 'rectangularity', 0.8245, 0.08786),
  ('whiteboard', 10, 'spread_length', 0.2628, 0.1629),
  ('whiteboard', 10, 'spread_width', -0.05532, 0.115),
  ('whiteboard', 10, 'tilt_deg', 89.95, 0.45),
  ('whiteboard', 10, 'width', 0.1027, 0.0996),
  ('whiteboard', 10, 'z_max', 2.026, 0.09967),
  ('whiteboard', 10, 'z_min', 0.8675, 0.07935);

-- shelf: 1256 examples
UPDATE object_class SET prior = 0.09748 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.554, 0.7471)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.9134, 0.4369)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5858, 0.3094)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3086, 0.1768)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4365, 0.3438)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_joined', 0.3668, 0.2873)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_unseen', 0.05024, 0.106)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9228, 0.4864)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.1271, 0.5012)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6958, 0.1319)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.2643, 0.4983)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.248, 0.365)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 45.51, 44.3)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.046, 0.3361)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.192, 0.6122)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.612, 0.5858)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'shelf';
DELETE FROM class_density WHERE class = 'shelf';
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.2282, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'area_m2', -1.264, 0.2262),
  ('shelf', 1, 'aspect', 0.8494, 0.204),
  ('shelf', 1, 'behind', 0.7925, 0.05923),
  ('shelf', 1, 'edge_free', 0.2831, 0.1126),
  ('shelf', 1, 'edge_free_top', 0.438, 0.1104),
  ('shelf', 1, 'edge_joined', 0.6427, 0.2127),
  ('shelf', 1, 'edge_unseen', 0.002855, 0.03),
  ('shelf', 1, 'height', 1.359, 0.461),
  ('shelf', 1, 'length', -0.0619, 0.2065),
  ('shelf', 1, 'rectangularity', 0.7993, 0.1017),
  ('shelf', 1, 'spread_length', -0.2611, 0.1767),
  ('shelf', 1, 'spread_width', -1.017, 0.09537),
  ('shelf', 1, 'tilt_deg', 0.7393, 0.45),
  ('shelf', 1, 'width', -0.9288, 0.1066),
  ('shelf', 1, 'z_max', 1.291, 0.5031),
  ('shelf', 1, 'z_min', 1.327, 0.4512);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.08025, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'area_m2', -2.039, 0.5507),
  ('shelf', 2, 'aspect', 0.6529, 0.4558),
  ('shelf', 2, 'behind', 0.7531, 0.165),
  ('shelf', 2, 'edge_free', 0.3455, 0.1239),
  ('shelf', 2, 'edge_free_top', 0.4157, 0.4101),
  ('shelf', 2, 'edge_joined', 0.1735, 0.2265),
  ('shelf', 2, 'edge_unseen', 0.1604, 0.2047),
  ('shelf', 2, 'height', 0.8547, 0.4731),
  ('shelf', 2, 'length', -0.4328, 0.4026),
  ('shelf', 2, 'rectangularity', 0.6979, 0.138),
  ('shelf', 2, 'spread_length', -0.7234, 0.2415),
  ('shelf', 2, 'spread_width', -1.375, 0.2899),
  ('shelf', 2, 'tilt_deg', 89.75, 0.8532),
  ('shelf', 2, 'width', -1.101, 0.1749),
  ('shelf', 2, 'z_max', 1.449, 0.1904),
  ('shelf', 2, 'z_min', 0.2373, 0.236);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.0811, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'area_m2', -2.285, 0.4832),
  ('shelf', 3, 'aspect', 0.8084, 0.6545),
  ('shelf', 3, 'behind', 0.7514, 0.1795),
  ('shelf', 3, 'edge_free', 0.3049, 0.1429),
  ('shelf', 3, 'edge_free_top', 0.434, 0.09978),
  ('shelf', 3, 'edge_joined', 0.4618, 0.2455),
  ('shelf', 3, 'edge_unseen', 0.1562, 0.07221),
  ('shelf', 3, 'height', 0.7672, 0.2914),
  ('shelf', 3, 'length', -0.4841, 0.3553),
  ('shelf', 3, 'rectangularity', 0.6081, 0.09894),
  ('shelf', 3, 'spread_length', -0.6514, 0.2936),
  ('shelf', 3, 'spread_width', -1.648, 0.3153),
  ('shelf', 3, 'tilt_deg', 2.244, 1.966),
  ('shelf', 3, 'width', -1.311, 0.2868),
  ('shelf', 3, 'z_max', 0.6886, 0.2767),
  ('shelf', 3, 'z_min', 0.857, 0.2277);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.08716, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'area_m2', -0.6029, 0.3402),
  ('shelf', 4, 'aspect', 1.557, 0.1243),
  ('shelf', 4, 'behind', 0.7565, 0.1134),
  ('shelf', 4, 'edge_free', 0.3868, 0.06589),
  ('shelf', 4, 'edge_free_top', 0.4663, 0.2829),
  ('shelf', 4, 'edge_joined', 0.2463, 0.1846),
  ('shelf', 4, 'edge_unseen', 0.009049, 0.03),
  ('shelf', 4, 'height', 1.008, 0.1065),
  ('shelf', 4, 'length', 0.6203, 0.1253),
  ('shelf', 4, 'rectangularity', 0.7161, 0.09817),
  ('shelf', 4, 'spread_length', 0.4868, 0.1183),
  ('shelf', 4, 'spread_width', -1.052, 0.1484),
  ('shelf', 4, 'tilt_deg', 89.75, 2.038),
  ('shelf', 4, 'width', -0.8742, 0.1832),
  ('shelf', 4, 'z_max', 1.979, 0.131),
  ('shelf', 4, 'z_min', 0.07017, 0.1082);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.1004, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'area_m2', -1.697, 0.3967),
  ('shelf', 5, 'aspect', 1.05, 0.3727),
  ('shelf', 5, 'behind', 0.7134, 0.1379),
  ('shelf', 5, 'edge_free', 0.3987, 0.05863),
  ('shelf', 5, 'edge_free_top', 0.4361, 0.108),
  ('shelf', 5, 'edge_joined', 0.3816, 0.1093),
  ('shelf', 5, 'edge_unseen', 0.007687, 0.03199),
  ('shelf', 5, 'height', 0.4629, 0.06957),
  ('shelf', 5, 'length', -0.1393, 0.2006),
  ('shelf', 5, 'rectangularity', 0.6835, 0.09454),
  ('shelf', 5, 'spread_length', -0.2519, 0.126),
  ('shelf', 5, 'spread_width', -1.343, 0.1688),
  ('shelf', 5, 'tilt_deg', 2.079, 1.566),
  ('shelf', 5, 'width', -1.09, 0.1684),
  ('shelf', 5, 'z_max', 0.4561, 0.06739),
  ('shelf', 5, 'z_min', 0.4603, 0.07643);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.09841, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'area_m2', -1.118, 0.3377),
  ('shelf', 6, 'aspect', 1.105, 0.2544),
  ('shelf', 6, 'behind', 0.7314, 0.1955),
  ('shelf', 6, 'edge_free', 0.4006, 0.0566),
  ('shelf', 6, 'edge_free_top', 0.5213, 0.2994),
  ('shelf', 6, 'edge_joined', 0.3415, 0.3574),
  ('shelf', 6, 'edge_unseen', 0.07015, 0.06626),
  ('shelf', 6, 'height', 1.147, 0.1794),
  ('shelf', 6, 'length', 0.2023, 0.2401),
  ('shelf', 6, 'rectangularity', 0.7282, 0.08748),
  ('shelf', 6, 'spread_length', 0.01309, 0.1985),
  ('shelf', 6, 'spread_width', -1.073, 0.1659),
  ('shelf', 6, 'tilt_deg', 90.27, 0.8399),
  ('shelf', 6, 'width', -0.9142, 0.1255),
  ('shelf', 6, 'z_max', 1.774, 0.207),
  ('shelf', 6, 'z_min', 0.488, 0.2882);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.1158, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'area_m2', -1.177, 0.2581),
  ('shelf', 7, 'aspect', 1.203, 0.2515),
  ('shelf', 7, 'behind', 0.7945, 0.06803),
  ('shelf', 7, 'edge_free', 0.4361, 0.04244),
  ('shelf', 7, 'edge_free_top', 0.606, 0.304),
  ('shelf', 7, 'edge_joined', 0.183, 0.1658),
  ('shelf', 7, 'edge_unseen', 0.004356, 0.03),
  ('shelf', 7, 'height', 0.6687, 0.1588),
  ('shelf', 7, 'length', 0.2043, 0.1393),
  ('shelf', 7, 'rectangularity', 0.7112, 0.1152),
  ('shelf', 7, 'spread_length', 0.01072, 0.1693),
  ('shelf', 7, 'spread_width', -1.119, 0.1351),
  ('shelf', 7, 'tilt_deg', 90.11, 0.6825),
  ('shelf', 7, 'width', -0.9143, 0.1253),
  ('shelf', 7, 'z_max', 1.251, 0.2059),
  ('shelf', 7, 'z_min', 0.03637, 0.02948);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.0387, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'area_m2', -2.256, 0.8126),
  ('shelf', 8, 'aspect', 0.6583, 0.4274),
  ('shelf', 8, 'behind', -0.004162, 0.03),
  ('shelf', 8, 'edge_free', 0.2003, 0.1348),
  ('shelf', 8, 'edge_free_top', 0.4349, 0.1084),
  ('shelf', 8, 'edge_joined', 0.3727, 0.2097),
  ('shelf', 8, 'edge_unseen', 0.03722, 0.1006),
  ('shelf', 8, 'height', 0.08635, 0.0225),
  ('shelf', 8, 'length', -0.6343, 0.5244),
  ('shelf', 8, 'rectangularity', 0.6904, 0.1043),
  ('shelf', 8, 'spread_length', -0.6955, 0.6771),
  ('shelf', 8, 'spread_width', -1.474, 0.2431),
  ('shelf', 8, 'tilt_deg', 0.7635, 1.559),
  ('shelf', 8, 'width', -1.261, 0.3185),
  ('shelf', 8, 'z_max', 0.1147, 0.08484),
  ('shelf', 8, 'z_min', 0.083, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.06473, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'area_m2', -2.085, 1.062),
  ('shelf', 9, 'aspect', 0.3508, 0.4257),
  ('shelf', 9, 'behind', 0.01221, 0.03087),
  ('shelf', 9, 'edge_free', 0.02334, 0.04559),
  ('shelf', 9, 'edge_free_top', 0.0165, 0.03829),
  ('shelf', 9, 'edge_joined', 0.06372, 0.06618),
  ('shelf', 9, 'edge_unseen', -0.004787, 0.03),
  ('shelf', 9, 'height', 0.9566, 0.3822),
  ('shelf', 9, 'length', -0.5143, 0.5692),
  ('shelf', 9, 'rectangularity', 0.6827, 0.1902),
  ('shelf', 9, 'spread_length', -0.4269, 0.4806),
  ('shelf', 9, 'spread_width', -1.215, 0.816),
  ('shelf', 9, 'tilt_deg', 89.68, 0.9999),
  ('shelf', 9, 'width', -1.103, 0.9231),
  ('shelf', 9, 'z_max', 1.059, 0.4673),
  ('shelf', 9, 'z_min', 0.6082, 0.4599);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.05517, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'area_m2', -1.959, 0.4982),
  ('shelf', 10, 'aspect', 0.6318, 0.3902),
  ('shelf', 10, 'behind', 0.6297, 0.1644),
  ('shelf', 10, 'edge_free', 0.2798, 0.1622),
  ('shelf', 10, 'edge_free_top', 0.4361, 0.1071),
  ('shelf', 10, 'edge_joined', 0.4984, 0.3029),
  ('shelf', 10, 'edge_unseen', 0.1584, 0.1205),
  ('shelf', 10, 'height', 1.688, 0.1808),
  ('shelf', 10, 'length', -0.432, 0.2885),
  ('shelf', 10, 'rectangularity', 0.7123, 0.1334),
  ('shelf', 10, 'spread_length', -0.6414, 0.2265),
  ('shelf', 10, 'spread_width', -1.354, 0.3266),
  ('shelf', 10, 'tilt_deg', 0.4776, 2.134),
  ('shelf', 10, 'width', -1.147, 0.3143),
  ('shelf', 10, 'z_max', 1.66, 0.1415),
  ('shelf', 10, 'z_min', 1.661, 0.1546);

-- cabinet: 1406 examples
UPDATE object_class SET prior = 0.106 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.8272, 0.9347)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6511, 0.4199)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.4915, 0.2431)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.3768, 0.2749)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.7431, 0.3261)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_joined', 0.2905, 0.3085)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_unseen', 0.08467, 0.1609)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7988, 0.3616)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.0737, 0.4867)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7423, 0.1327)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.09937, 0.4941)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7839, 0.5069)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 75.16, 33.05)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.5829, 0.4767)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.26, 0.5821)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2554, 0.3691)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'cabinet';
DELETE FROM class_density WHERE class = 'cabinet';
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.2009, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'area_m2', -0.5323, 0.5124),
  ('cabinet', 1, 'aspect', 0.4838, 0.3439),
  ('cabinet', 1, 'behind', 0.5006, 0.2181),
  ('cabinet', 1, 'edge_free', 0.2539, 0.1289),
  ('cabinet', 1, 'edge_free_top', 0.8201, 0.162),
  ('cabinet', 1, 'edge_joined', 0.3709, 0.271),
  ('cabinet', 1, 'edge_unseen', 0.1071, 0.1788),
  ('cabinet', 1, 'height', 1.162, 0.3062),
  ('cabinet', 1, 'length', 0.2442, 0.3684),
  ('cabinet', 1, 'rectangularity', 0.7883, 0.1167),
  ('cabinet', 1, 'spread_length', -0.1466, 0.3508),
  ('cabinet', 1, 'spread_width', -0.6275, 0.2028),
  ('cabinet', 1, 'tilt_deg', 90.28, 0.45),
  ('cabinet', 1, 'width', -0.5361, 0.1416),
  ('cabinet', 1, 'z_max', 1.966, 0.1334),
  ('cabinet', 1, 'z_min', 0.4493, 0.1829);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.09388, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'area_m2', -0.3612, 0.3863),
  ('cabinet', 2, 'aspect', 0.5479, 0.2429),
  ('cabinet', 2, 'behind', 0.528, 0.1416),
  ('cabinet', 2, 'edge_free', 0.3424, 0.2253),
  ('cabinet', 2, 'edge_free_top', 0.9346, 0.0776),
  ('cabinet', 2, 'edge_joined', 0.09217, 0.1511),
  ('cabinet', 2, 'edge_unseen', 0.002589, 0.04148),
  ('cabinet', 2, 'height', 0.5806, 0.1199),
  ('cabinet', 2, 'length', 0.1527, 0.1658),
  ('cabinet', 2, 'rectangularity', 0.8609, 0.1475),
  ('cabinet', 2, 'spread_length', -0.03978, 0.1481),
  ('cabinet', 2, 'spread_width', -0.3934, 0.3562),
  ('cabinet', 2, 'tilt_deg', 90.14, 0.45),
  ('cabinet', 2, 'width', -0.3312, 0.3257),
  ('cabinet', 2, 'z_max', 1.121, 0.1417),
  ('cabinet', 2, 'z_min', -0.0008821, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.08919, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'area_m2', -0.7706, 0.8384),
  ('cabinet', 3, 'aspect', 0.5887, 0.4722),
  ('cabinet', 3, 'behind', 0.2652, 0.1745),
  ('cabinet', 3, 'edge_free', 0.6698, 0.3293),
  ('cabinet', 3, 'edge_free_top', 0.9903, 0.03),
  ('cabinet', 3, 'edge_joined', 0.0252, 0.04997),
  ('cabinet', 3, 'edge_unseen', 0.3957, 0.1297),
  ('cabinet', 3, 'height', 1.1, 0.2212),
  ('cabinet', 3, 'length', 0.189, 0.3548),
  ('cabinet', 3, 'rectangularity', 0.6859, 0.1306),
  ('cabinet', 3, 'spread_length', -0.3271, 0.3936),
  ('cabinet', 3, 'spread_width', -0.8294, 0.6552),
  ('cabinet', 3, 'tilt_deg', 90.32, 0.45),
  ('cabinet', 3, 'width', -0.6227, 0.5459),
  ('cabinet', 3, 'z_max', 1.725, 0.47),
  ('cabinet', 3, 'z_min', 0.298, 0.1718);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.1608, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'area_m2', 0.3086, 0.483),
  ('cabinet', 4, 'aspect', 0.8043, 0.3328),
  ('cabinet', 4, 'behind', 0.2532, 0.08809),
  ('cabinet', 4, 'edge_free', 0.5245, 0.1883),
  ('cabinet', 4, 'edge_free_top', 0.9799, 0.03821),
  ('cabinet', 4, 'edge_joined', 0.04837, 0.07219),
  ('cabinet', 4, 'edge_unseen', 0.0001862, 0.03),
  ('cabinet', 4, 'height', 1.084, 0.1442),
  ('cabinet', 4, 'length', 0.6089, 0.07896),
  ('cabinet', 4, 'rectangularity', 0.8866, 0.08149),
  ('cabinet', 4, 'spread_length', 0.503, 0.1904),
  ('cabinet', 4, 'spread_width', -0.357, 0.2003),
  ('cabinet', 4, 'tilt_deg', 90.12, 0.6357),
  ('cabinet', 4, 'width', -0.2159, 0.454),
  ('cabinet', 4, 'z_max', 1.849, 0.1176),
  ('cabinet', 4, 'z_min', 0.02707, 0.08725);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.1003, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'area_m2', -1.184, 0.248),
  ('cabinet', 5, 'aspect', 0.373, 0.3277),
  ('cabinet', 5, 'behind', 0.6047, 0.0989),
  ('cabinet', 5, 'edge_free', 0.2929, 0.2581),
  ('cabinet', 5, 'edge_free_top', 0.6913, 0.1918),
  ('cabinet', 5, 'edge_joined', 0.2308, 0.2828),
  ('cabinet', 5, 'edge_unseen', 0.01877, 0.06529),
  ('cabinet', 5, 'height', 0.3513, 0.03978),
  ('cabinet', 5, 'length', -0.2574, 0.157),
  ('cabinet', 5, 'rectangularity', 0.6874, 0.0869),
  ('cabinet', 5, 'spread_length', -0.5179, 0.05159),
  ('cabinet', 5, 'spread_width', -0.8606, 0.2148),
  ('cabinet', 5, 'tilt_deg', 90.06, 0.5235),
  ('cabinet', 5, 'width', -0.5408, 0.04484),
  ('cabinet', 5, 'z_max', 0.7345, 0.1331),
  ('cabinet', 5, 'z_min', -0.01316, 0.02295);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.0978, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'area_m2', -0.8243, 0.3085),
  ('cabinet', 6, 'aspect', 0.6546, 0.2779),
  ('cabinet', 6, 'behind', 0.6815, 0.1086),
  ('cabinet', 6, 'edge_free', 0.1584, 0.1112),
  ('cabinet', 6, 'edge_free_top', 0.7433, 0.1025),
  ('cabinet', 6, 'edge_joined', 0.7691, 0.117),
  ('cabinet', 6, 'edge_unseen', 0.07207, 0.1569),
  ('cabinet', 6, 'height', 0.932, 0.1668),
  ('cabinet', 6, 'length', 0.06689, 0.3256),
  ('cabinet', 6, 'rectangularity', 0.7012, 0.08098),
  ('cabinet', 6, 'spread_length', -0.2261, 0.2809),
  ('cabinet', 6, 'spread_width', -0.6536, 0.1038),
  ('cabinet', 6, 'tilt_deg', -0.05338, 0.45),
  ('cabinet', 6, 'width', -0.5496, 0.08857),
  ('cabinet', 6, 'z_max', 0.916, 0.1688),
  ('cabinet', 6, 'z_min', 0.9426, 0.1675);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.06774, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'area_m2', -1.938, 0.285),
  ('cabinet', 7, 'aspect', 0.8534, 0.7973),
  ('cabinet', 7, 'behind', 0.4934, 0.2635),
  ('cabinet', 7, 'edge_free', 0.07597, 0.1056),
  ('cabinet', 7, 'edge_free_top', 0.1647, 0.2591),
  ('cabinet', 7, 'edge_joined', 0.1499, 0.1489),
  ('cabinet', 7, 'edge_unseen', 0.0521, 0.1149),
  ('cabinet', 7, 'height', 0.3216, 0.1899),
  ('cabinet', 7, 'length', -0.4395, 0.4006),
  ('cabinet', 7, 'rectangularity', 0.6794, 0.09695),
  ('cabinet', 7, 'spread_length', -0.5358, 0.5228),
  ('cabinet', 7, 'spread_width', -1.591, 0.2776),
  ('cabinet', 7, 'tilt_deg', 89.64, 0.9782),
  ('cabinet', 7, 'width', -1.303, 0.3339),
  ('cabinet', 7, 'z_max', 0.638, 0.4673),
  ('cabinet', 7, 'z_min', 0.04906, 0.1527);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.07058, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'area_m2', 0.01277, 0.1589),
  ('cabinet', 8, 'aspect', 1.158, 0.1936),
  ('cabinet', 8, 'behind', 0.5385, 0.1132),
  ('cabinet', 8, 'edge_free', 0.107, 0.0443),
  ('cabinet', 8, 'edge_free_top', 0.7464, 0.1585),
  ('cabinet', 8, 'edge_joined', 0.5888, 0.2725),
  ('cabinet', 8, 'edge_unseen', 0.00163, 0.03),
  ('cabinet', 8, 'height', 1.028, 0.1301),
  ('cabinet', 8, 'length', 0.6854, 0.114),
  ('cabinet', 8, 'rectangularity', 0.8096, 0.06485),
  ('cabinet', 8, 'spread_length', 0.5361, 0.06972),
  ('cabinet', 8, 'spread_width', -0.6113, 0.2045),
  ('cabinet', 8, 'tilt_deg', 89.91, 1.772),
  ('cabinet', 8, 'width', -0.4674, 0.126),
  ('cabinet', 8, 'z_max', 1.962, 0.2499),
  ('cabinet', 8, 'z_min', 0.000454, 0.03833);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.03254, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'area_m2', -2.214, 0.602),
  ('cabinet', 9, 'aspect', 0.6082, 0.258),
  ('cabinet', 9, 'behind', 0.7449, 0.1364),
  ('cabinet', 9, 'edge_free', 0.2379, 0.1657),
  ('cabinet', 9, 'edge_free_top', 0.7434, 0.1027),
  ('cabinet', 9, 'edge_joined', 0.2252, 0.09584),
  ('cabinet', 9, 'edge_unseen', 0.005037, 0.04061),
  ('cabinet', 9, 'height', 0.5824, 0.0225),
  ('cabinet', 9, 'length', -0.6194, 0.1821),
  ('cabinet', 9, 'rectangularity', 0.7071, 0.07781),
  ('cabinet', 9, 'spread_length', -0.8868, 0.2012),
  ('cabinet', 9, 'spread_width', -1.46, 0.4556),
  ('cabinet', 9, 'tilt_deg', 1.209, 2.483),
  ('cabinet', 9, 'width', -1.248, 0.5444),
  ('cabinet', 9, 'z_max', 0.5865, 0.0225),
  ('cabinet', 9, 'z_min', 0.5778, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.03631, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'area_m2', -2.655, 0.4995),
  ('cabinet', 10, 'aspect', 0.5407, 0.1985),
  ('cabinet', 10, 'behind', 0.4079, 0.2697),
  ('cabinet', 10, 'edge_free', 0.4443, 0.2861),
  ('cabinet', 10, 'edge_free_top', 0.7921, 0.2341),
  ('cabinet', 10, 'edge_joined', 0.2453, 0.2231),
  ('cabinet', 10, 'edge_unseen', 0.2776, 0.186),
  ('cabinet', 10, 'height', 0.735, 0.2048),
  ('cabinet', 10, 'length', -0.8276, 0.3713),
  ('cabinet', 10, 'rectangularity', 0.5975, 0.07153),
  ('cabinet', 10, 'spread_length', -0.7494, 0.1229),
  ('cabinet', 10, 'spread_width', -1.698, 0.1956),
  ('cabinet', 10, 'tilt_deg', 65.53, 48.92),
  ('cabinet', 10, 'width', -1.379, 0.243),
  ('cabinet', 10, 'z_max', 0.8404, 0.1504),
  ('cabinet', 10, 'z_min', 0.6269, 0.3038);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.0112 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.427 WHERE name = 'aspect';
UPDATE feature SET weight = 0.418 WHERE name = 'edge_free';
UPDATE feature SET weight = 0.272 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.211 WHERE name = 'edge_joined';
UPDATE feature SET weight = 0.246 WHERE name = 'edge_unseen';
UPDATE feature SET weight = 0.233 WHERE name = 'height';
UPDATE feature SET weight = 0 WHERE name = 'length';
UPDATE feature SET weight = 0.473 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.406 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.239 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.5 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.236 WHERE name = 'width';
UPDATE feature SET weight = 0.471 WHERE name = 'z_max';
UPDATE feature SET weight = 0.463 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.158 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0546 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0321 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.166 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0141 WHERE name = 'table';
UPDATE object_class SET prior = 0.0244 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.246 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.00214 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0465 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.00965 WHERE name = 'door';
UPDATE object_class SET prior = 0.0256 WHERE name = 'window';
UPDATE object_class SET prior = 0.00563 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0856 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.13 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.78 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.283 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 1.31 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.63 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 2.75 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.51 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 0.176 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.2 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.0179 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.948 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 0.506 WHERE name = 'wall_in_one_plane';
UPDATE class_constraint SET weight = 1.7 WHERE name = 'cabinet_off_wall';
UPDATE class_constraint SET weight = 1.28 WHERE name = 'window_off_wall';
UPDATE class_constraint SET weight = 2.15 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.97 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.38 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.4 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 0.397 WHERE name = 'screen_within_table';
UPDATE class_constraint SET weight = 1.76 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 3.25 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 4.18 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.35 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.775 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.02 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 1.23 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.767 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.09 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.43 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 3.54 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.67 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.73 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.23 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.86 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.69 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.123 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.25 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2331 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.848' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.205' WHERE key = 'probability_offset';
