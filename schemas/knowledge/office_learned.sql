-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 17465 planes of 180 paper-like rooms, seeds from 1; 90 at 2 cm, seeds from 10101; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 60 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 7095 examples
UPDATE object_class SET prior = 0.3146 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.871, 1.268)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.715, 0.5908)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4735, 0.2918)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.4455, 0.3163)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.565, 0.413)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_joined', 0.31, 0.3288)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_unseen', 0.05033, 0.1097)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 1.041, 0.7339)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.4032, 0.7278)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.7256, 0.1459)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.5455, 0.7493)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.333, 0.6813)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 62.9, 39.63)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.121, 0.6643)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.32, 0.9853)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7578, 0.7916)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0144372, 0.004208),
  ('unknown', 'area_m2', 0.0144372, 0.0336324, 0.07325),
  ('unknown', 'area_m2', 0.0336324, 0.0424801, 0.176),
  ('unknown', 'area_m2', 0.0424801, 0.0618017, 0.294),
  ('unknown', 'area_m2', 0.0618017, 0.078349, 0.3925),
  ('unknown', 'area_m2', 0.078349, 0.0824651, 0.3676),
  ('unknown', 'area_m2', 0.0824651, 0.111491, 0.3649),
  ('unknown', 'area_m2', 0.111491, 0.160067, 0.3091),
  ('unknown', 'area_m2', 0.160067, 0.182519, 0.3323),
  ('unknown', 'area_m2', 0.182519, 0.227965, 0.3075),
  ('unknown', 'area_m2', 0.227965, 0.309704, 0.36),
  ('unknown', 'area_m2', 0.309704, 0.425191, 0.2482),
  ('unknown', 'area_m2', 0.425191, 0.523108, 0.1564),
  ('unknown', 'area_m2', 0.523108, 0.99051, 0.1005),
  ('unknown', 'area_m2', 0.99051, 2.30746, 0.01379),
  ('unknown', 'area_m2', 2.30746, 5.37538, 0.008458),
  ('unknown', 'area_m2', 5.37538, 12.5223, 0.009801),
  ('unknown', 'area_m2', 12.5223, 29.1716, 0.01267),
  ('unknown', 'area_m2', 29.1716, 100, 0.007563);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.10937, 1.071),
  ('unknown', 'aspect', 1.10937, 1.24529, 0.9629),
  ('unknown', 'aspect', 1.24529, 1.29403, 0.9693),
  ('unknown', 'aspect', 1.29403, 1.39739, 0.9671),
  ('unknown', 'aspect', 1.39739, 1.58362, 0.8777),
  ('unknown', 'aspect', 1.58362, 1.67452, 0.7824),
  ('unknown', 'aspect', 1.67452, 1.83313, 0.7536),
  ('unknown', 'aspect', 1.83313, 2.16689, 0.5542),
  ('unknown', 'aspect', 2.16689, 2.25685, 0.4421),
  ('unknown', 'aspect', 2.25685, 2.80403, 0.3314),
  ('unknown', 'aspect', 2.80403, 3.31826, 0.2375),
  ('unknown', 'aspect', 3.31826, 3.6285, 0.2228),
  ('unknown', 'aspect', 3.6285, 4.6954, 0.2329),
  ('unknown', 'aspect', 4.6954, 5.20935, 0.2953),
  ('unknown', 'aspect', 5.20935, 6.07601, 0.2885),
  ('unknown', 'aspect', 6.07601, 7.86256, 0.1761),
  ('unknown', 'aspect', 7.86256, 10.1744, 0.04581),
  ('unknown', 'aspect', 10.1744, 100, 0.004147);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.0965381, 2.1),
  ('unknown', 'behind', 0.0965381, 0.151701, 0.3626),
  ('unknown', 'behind', 0.151701, 0.193076, 0.392),
  ('unknown', 'behind', 0.193076, 0.289614, 0.462),
  ('unknown', 'behind', 0.289614, 0.375604, 0.5721),
  ('unknown', 'behind', 0.375604, 0.386152, 0.7283),
  ('unknown', 'behind', 0.386152, 0.48269, 0.867),
  ('unknown', 'behind', 0.48269, 0.5, 1.084),
  ('unknown', 'behind', 0.5, 0.579228, 1.026),
  ('unknown', 'behind', 0.579228, 0.602787, 1.335),
  ('unknown', 'behind', 0.602787, 0.675766, 1.455),
  ('unknown', 'behind', 0.675766, 0.678488, 1.669),
  ('unknown', 'behind', 0.678488, 0.742267, 1.744),
  ('unknown', 'behind', 0.742267, 0.772304, 2.087),
  ('unknown', 'behind', 0.772304, 0.795632, 2.089),
  ('unknown', 'behind', 0.795632, 0.868842, 1.427),
  ('unknown', 'behind', 0.868842, 1, 0.05018);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free', 0, 0.111111, 1.967),
  ('unknown', 'edge_free', 0.111111, 0.117784, 0.5541),
  ('unknown', 'edge_free', 0.117784, 0.222222, 0.6219),
  ('unknown', 'edge_free', 0.222222, 0.288143, 0.6973),
  ('unknown', 'edge_free', 0.288143, 0.333333, 0.8191),
  ('unknown', 'edge_free', 0.333333, 0.403978, 1.059),
  ('unknown', 'edge_free', 0.403978, 0.444444, 1.256),
  ('unknown', 'edge_free', 0.444444, 0.48962, 1.325),
  ('unknown', 'edge_free', 0.48962, 0.555556, 1.214),
  ('unknown', 'edge_free', 0.555556, 0.589027, 0.9442),
  ('unknown', 'edge_free', 0.589027, 0.666667, 0.8954),
  ('unknown', 'edge_free', 0.666667, 0.713606, 0.8722),
  ('unknown', 'edge_free', 0.713606, 0.777778, 0.7371),
  ('unknown', 'edge_free', 0.777778, 0.888889, 0.5007),
  ('unknown', 'edge_free', 0.888889, 0.905321, 0.4746),
  ('unknown', 'edge_free', 0.905321, 1, 1.177);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free_top', 0, 0.111111, 2.485),
  ('unknown', 'edge_free_top', 0.111111, 0.222222, 0.3702),
  ('unknown', 'edge_free_top', 0.222222, 0.267625, 0.3369),
  ('unknown', 'edge_free_top', 0.267625, 0.333333, 0.3612),
  ('unknown', 'edge_free_top', 0.333333, 0.444444, 0.3366),
  ('unknown', 'edge_free_top', 0.444444, 0.555556, 0.4217),
  ('unknown', 'edge_free_top', 0.555556, 0.564478, 0.4436),
  ('unknown', 'edge_free_top', 0.564478, 0.666667, 0.4324),
  ('unknown', 'edge_free_top', 0.666667, 0.777778, 0.5261),
  ('unknown', 'edge_free_top', 0.777778, 0.788741, 0.7737),
  ('unknown', 'edge_free_top', 0.788741, 0.888889, 0.6723),
  ('unknown', 'edge_free_top', 0.888889, 0.933634, 1.011),
  ('unknown', 'edge_free_top', 0.933634, 1, 4.999);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_joined', 0, 0.0141074, 15.69),
  ('unknown', 'edge_joined', 0.0141074, 0.05651, 2.627),
  ('unknown', 'edge_joined', 0.05651, 0.111111, 1.601),
  ('unknown', 'edge_joined', 0.111111, 0.129255, 1.321),
  ('unknown', 'edge_joined', 0.129255, 0.222222, 0.9985),
  ('unknown', 'edge_joined', 0.222222, 0.244057, 0.8136),
  ('unknown', 'edge_joined', 0.244057, 0.333333, 0.8229),
  ('unknown', 'edge_joined', 0.333333, 0.386385, 0.7196),
  ('unknown', 'edge_joined', 0.386385, 0.444444, 0.6079),
  ('unknown', 'edge_joined', 0.444444, 0.555556, 0.5401),
  ('unknown', 'edge_joined', 0.555556, 0.589013, 0.4922),
  ('unknown', 'edge_joined', 0.589013, 0.666667, 0.419),
  ('unknown', 'edge_joined', 0.666667, 0.777778, 0.3986),
  ('unknown', 'edge_joined', 0.777778, 0.87092, 0.3711),
  ('unknown', 'edge_joined', 0.87092, 0.888889, 0.391),
  ('unknown', 'edge_joined', 0.888889, 1, 0.9314);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_unseen';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_unseen', 0, 0.0424116, 18.31),
  ('unknown', 'edge_unseen', 0.0424116, 0.0546018, 0.815),
  ('unknown', 'edge_unseen', 0.0546018, 0.109204, 0.8036),
  ('unknown', 'edge_unseen', 0.109204, 0.163805, 0.6883),
  ('unknown', 'edge_unseen', 0.163805, 0.201167, 0.554),
  ('unknown', 'edge_unseen', 0.201167, 0.218407, 0.5751),
  ('unknown', 'edge_unseen', 0.218407, 0.273009, 0.442),
  ('unknown', 'edge_unseen', 0.273009, 0.327611, 0.4594),
  ('unknown', 'edge_unseen', 0.327611, 0.382213, 0.4068),
  ('unknown', 'edge_unseen', 0.382213, 0.436815, 0.2787),
  ('unknown', 'edge_unseen', 0.436815, 0.491416, 0.09831),
  ('unknown', 'edge_unseen', 0.491416, 1, 0.01841);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0470541, 0.01156),
  ('unknown', 'height', 0.0470541, 0.221789, 0.6041),
  ('unknown', 'height', 0.221789, 0.371445, 0.5646),
  ('unknown', 'height', 0.371445, 0.415308, 0.6291),
  ('unknown', 'height', 0.415308, 0.573163, 0.6951),
  ('unknown', 'height', 0.573163, 0.695837, 0.3358),
  ('unknown', 'height', 0.695837, 0.801813, 0.6516),
  ('unknown', 'height', 0.801813, 0.921988, 0.9098),
  ('unknown', 'height', 0.921988, 1.02023, 0.4934),
  ('unknown', 'height', 1.02023, 1.25738, 0.2737),
  ('unknown', 'height', 1.25738, 1.34462, 0.2858),
  ('unknown', 'height', 1.34462, 1.59396, 0.3452),
  ('unknown', 'height', 1.59396, 1.66901, 0.3559),
  ('unknown', 'height', 1.66901, 1.9934, 0.1617),
  ('unknown', 'height', 1.9934, 2.1706, 0.183),
  ('unknown', 'height', 2.1706, 2.31779, 0.2357),
  ('unknown', 'height', 2.31779, 2.64218, 0.1308),
  ('unknown', 'height', 2.64218, 2.96658, 0.07469),
  ('unknown', 'height', 2.96658, 4, 0.009084);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.163856, 0.004562),
  ('unknown', 'length', 0.163856, 0.252907, 0.125),
  ('unknown', 'length', 0.252907, 0.296722, 0.3032),
  ('unknown', 'length', 0.296722, 0.365877, 0.5357),
  ('unknown', 'length', 0.365877, 0.390355, 0.5112),
  ('unknown', 'length', 0.390355, 0.448671, 0.5564),
  ('unknown', 'length', 0.448671, 0.552843, 0.53),
  ('unknown', 'length', 0.552843, 0.602501, 0.511),
  ('unknown', 'length', 0.602501, 0.702525, 0.4377),
  ('unknown', 'length', 0.702525, 0.893637, 0.4638),
  ('unknown', 'length', 0.893637, 0.929944, 0.4247),
  ('unknown', 'length', 0.929944, 1.17605, 0.4019),
  ('unknown', 'length', 1.17605, 1.43534, 0.4911),
  ('unknown', 'length', 1.43534, 1.48208, 0.414),
  ('unknown', 'length', 1.48208, 2.21541, 0.1652),
  ('unknown', 'length', 2.21541, 3.41942, 0.02954),
  ('unknown', 'length', 3.41942, 5.27778, 0.02491),
  ('unknown', 'length', 5.27778, 8.1461, 0.02595),
  ('unknown', 'length', 8.1461, 30, 0.007365);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.288558, 0.03298),
  ('unknown', 'rectangularity', 0.288558, 0.36358, 0.1698),
  ('unknown', 'rectangularity', 0.36358, 0.438602, 0.3267),
  ('unknown', 'rectangularity', 0.438602, 0.513624, 0.5832),
  ('unknown', 'rectangularity', 0.513624, 0.537233, 0.8969),
  ('unknown', 'rectangularity', 0.537233, 0.588646, 1.214),
  ('unknown', 'rectangularity', 0.588646, 0.620129, 1.535),
  ('unknown', 'rectangularity', 0.620129, 0.663669, 1.776),
  ('unknown', 'rectangularity', 0.663669, 0.679247, 2.17),
  ('unknown', 'rectangularity', 0.679247, 0.728211, 2.272),
  ('unknown', 'rectangularity', 0.728211, 0.738691, 2.656),
  ('unknown', 'rectangularity', 0.738691, 0.76935, 2.723),
  ('unknown', 'rectangularity', 0.76935, 0.807713, 2.872),
  ('unknown', 'rectangularity', 0.807713, 0.813713, 2.662),
  ('unknown', 'rectangularity', 0.813713, 0.846989, 2.876),
  ('unknown', 'rectangularity', 0.846989, 0.888735, 2.547),
  ('unknown', 'rectangularity', 0.888735, 0.890775, 2.376),
  ('unknown', 'rectangularity', 0.890775, 0.963757, 1.426),
  ('unknown', 'rectangularity', 0.963757, 1, 0.1863);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.148639, 0.002759),
  ('unknown', 'spread_length', 0.148639, 0.230899, 0.1413),
  ('unknown', 'spread_length', 0.230899, 0.258616, 0.3722),
  ('unknown', 'spread_length', 0.258616, 0.313244, 0.5709),
  ('unknown', 'spread_length', 0.313244, 0.358684, 0.7169),
  ('unknown', 'spread_length', 0.358684, 0.368092, 0.5531),
  ('unknown', 'spread_length', 0.368092, 0.453577, 0.5309),
  ('unknown', 'spread_length', 0.453577, 0.557189, 0.4109),
  ('unknown', 'spread_length', 0.557189, 0.603903, 0.3401),
  ('unknown', 'spread_length', 0.603903, 0.772714, 0.4465),
  ('unknown', 'spread_length', 0.772714, 0.86555, 0.4146),
  ('unknown', 'spread_length', 0.86555, 1.04546, 0.3422),
  ('unknown', 'spread_length', 1.04546, 1.33682, 0.4519),
  ('unknown', 'spread_length', 1.33682, 2.08868, 0.154),
  ('unknown', 'spread_length', 2.08868, 3.24461, 0.02568),
  ('unknown', 'spread_length', 3.24461, 5.04025, 0.0238),
  ('unknown', 'spread_length', 5.04025, 7.82964, 0.02719),
  ('unknown', 'spread_length', 7.82964, 40, 0.005638);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.0796335, 0.0005354),
  ('unknown', 'spread_width', 0.0796335, 0.12504, 0.1891),
  ('unknown', 'spread_width', 0.12504, 0.135733, 0.2921),
  ('unknown', 'spread_width', 0.135733, 0.17132, 0.4765),
  ('unknown', 'spread_width', 0.17132, 0.196337, 0.7378),
  ('unknown', 'spread_width', 0.196337, 0.21793, 1.173),
  ('unknown', 'spread_width', 0.21793, 0.24622, 0.8935),
  ('unknown', 'spread_width', 0.24622, 0.293111, 0.6415),
  ('unknown', 'spread_width', 0.293111, 0.308288, 0.565),
  ('unknown', 'spread_width', 0.308288, 0.374842, 0.426),
  ('unknown', 'spread_width', 0.374842, 0.484072, 0.2976),
  ('unknown', 'spread_width', 0.484072, 0.564734, 0.2226),
  ('unknown', 'spread_width', 0.564734, 0.760087, 0.2184),
  ('unknown', 'spread_width', 0.760087, 1.19348, 0.02653),
  ('unknown', 'spread_width', 1.19348, 1.874, 0.01984),
  ('unknown', 'spread_width', 1.874, 2.94255, 0.01649),
  ('unknown', 'spread_width', 2.94255, 4.62037, 0.02064),
  ('unknown', 'spread_width', 4.62037, 20, 0.006382);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 0.448873, 0.2314),
  ('unknown', 'tilt_deg', 0.448873, 1.70175, 0.09343),
  ('unknown', 'tilt_deg', 1.70175, 10, 0.007348),
  ('unknown', 'tilt_deg', 10, 20, 0.001022),
  ('unknown', 'tilt_deg', 20, 30, 0.0001406),
  ('unknown', 'tilt_deg', 30, 40, 7.723e-05),
  ('unknown', 'tilt_deg', 40, 50, 7.208e-05),
  ('unknown', 'tilt_deg', 50, 60, 9.128e-05),
  ('unknown', 'tilt_deg', 60, 70, 0.0004271),
  ('unknown', 'tilt_deg', 70, 80, 0.003239),
  ('unknown', 'tilt_deg', 80, 80.3841, 0.003714),
  ('unknown', 'tilt_deg', 80.3841, 88.608, 0.01357),
  ('unknown', 'tilt_deg', 88.608, 89.5138, 0.148),
  ('unknown', 'tilt_deg', 89.5138, 89.7989, 0.6552),
  ('unknown', 'tilt_deg', 89.7989, 90, 1.161);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.0961073, 0.003346),
  ('unknown', 'width', 0.0961073, 0.148559, 0.1481),
  ('unknown', 'width', 0.148559, 0.165944, 0.3552),
  ('unknown', 'width', 0.165944, 0.208002, 0.4932),
  ('unknown', 'width', 0.208002, 0.229636, 0.8446),
  ('unknown', 'width', 0.229636, 0.236183, 0.9692),
  ('unknown', 'width', 0.236183, 0.270981, 0.8047),
  ('unknown', 'width', 0.270981, 0.31437, 0.742),
  ('unknown', 'width', 0.31437, 0.354962, 0.7004),
  ('unknown', 'width', 0.354962, 0.373541, 0.5212),
  ('unknown', 'width', 0.373541, 0.483572, 0.4334),
  ('unknown', 'width', 0.483572, 0.548685, 0.3438),
  ('unknown', 'width', 0.548685, 0.691818, 0.295),
  ('unknown', 'width', 0.691818, 0.848135, 0.2761),
  ('unknown', 'width', 0.848135, 1.31101, 0.04359),
  ('unknown', 'width', 1.31101, 2.02651, 0.01768),
  ('unknown', 'width', 2.02651, 3.13249, 0.02072),
  ('unknown', 'width', 3.13249, 4.84208, 0.02024),
  ('unknown', 'width', 4.84208, 12, 0.01042);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0721514, 0.01217),
  ('unknown', 'z_max', 0.0721514, 0.418364, 0.3075),
  ('unknown', 'z_max', 0.418364, 0.508579, 0.6322),
  ('unknown', 'z_max', 0.508579, 0.657017, 0.3521),
  ('unknown', 'z_max', 0.657017, 0.772806, 0.9504),
  ('unknown', 'z_max', 0.772806, 0.897261, 0.9042),
  ('unknown', 'z_max', 0.897261, 0.945007, 0.7093),
  ('unknown', 'z_max', 0.945007, 1.07576, 0.5845),
  ('unknown', 'z_max', 1.07576, 1.38143, 0.2718),
  ('unknown', 'z_max', 1.38143, 1.59304, 0.1298),
  ('unknown', 'z_max', 1.59304, 1.81786, 0.175),
  ('unknown', 'z_max', 1.81786, 2.05091, 0.304),
  ('unknown', 'z_max', 2.05091, 2.25429, 0.4361),
  ('unknown', 'z_max', 2.25429, 2.32469, 0.3445),
  ('unknown', 'z_max', 2.32469, 2.69072, 0.1548),
  ('unknown', 'z_max', 2.69072, 3.12714, 0.05787),
  ('unknown', 'z_max', 3.12714, 3.56357, 0.01098),
  ('unknown', 'z_max', 3.56357, 4, 0.05493);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.129701, 0.06147),
  ('unknown', 'z_min', -0.129701, -0.0158253, 0.8363),
  ('unknown', 'z_min', -0.0158253, 0.0111186, 3.549),
  ('unknown', 'z_min', 0.0111186, 0.230781, 0.5427),
  ('unknown', 'z_min', 0.230781, 0.240598, 0.2944),
  ('unknown', 'z_min', 0.240598, 0.610897, 0.2778),
  ('unknown', 'z_min', 0.610897, 0.628638, 0.3046),
  ('unknown', 'z_min', 0.628638, 0.753754, 0.8881),
  ('unknown', 'z_min', 0.753754, 0.888663, 0.8312),
  ('unknown', 'z_min', 0.888663, 0.981196, 0.5438),
  ('unknown', 'z_min', 0.981196, 1.22268, 0.2477),
  ('unknown', 'z_min', 1.22268, 1.35149, 0.309),
  ('unknown', 'z_min', 1.35149, 1.72179, 0.1168),
  ('unknown', 'z_min', 1.72179, 2.0505, 0.08345),
  ('unknown', 'z_min', 2.0505, 2.09209, 0.0899),
  ('unknown', 'z_min', 2.09209, 2.46239, 0.1737),
  ('unknown', 'z_min', 2.46239, 2.83269, 0.09522),
  ('unknown', 'z_min', 2.83269, 4, 0.00759);
DELETE FROM class_kind WHERE class = 'unknown';
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.02563, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'area_m2', -2.6, 0.2888),
  ('unknown', 1, 'aspect', 0.3728, 0.2601),
  ('unknown', 1, 'behind', 0.6407, 0.1737),
  ('unknown', 1, 'edge_free', 0.4619, 0.1531),
  ('unknown', 1, 'edge_free_top', 0.764, 0.2067),
  ('unknown', 1, 'edge_joined', 0.2005, 0.1852),
  ('unknown', 1, 'edge_unseen', 0.003499, 0.03431),
  ('unknown', 1, 'height', 0.1925, 0.02518),
  ('unknown', 1, 'length', -0.9111, 0.169),
  ('unknown', 1, 'rectangularity', 0.6684, 0.1336),
  ('unknown', 1, 'spread_length', -1.037, 0.1575),
  ('unknown', 1, 'spread_width', -1.668, 0.1912),
  ('unknown', 1, 'tilt_deg', 89.45, 1.441),
  ('unknown', 1, 'width', -1.262, 0.2657),
  ('unknown', 1, 'z_max', 0.3907, 0.04992),
  ('unknown', 1, 'z_min', -0.01097, 0.0343);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.06829, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'area_m2', -2.755, 0.3285),
  ('unknown', 2, 'aspect', 0.3403, 0.2015),
  ('unknown', 2, 'behind', 0.2604, 0.2109),
  ('unknown', 2, 'edge_free', 0.4437, 0.3476),
  ('unknown', 2, 'edge_free_top', 0.5635, 0.1226),
  ('unknown', 2, 'edge_joined', 0.5639, 0.3315),
  ('unknown', 2, 'edge_unseen', 0.005395, 0.03),
  ('unknown', 2, 'height', 0.8209, 0.1121),
  ('unknown', 2, 'length', -1.118, 0.168),
  ('unknown', 2, 'rectangularity', 0.8293, 0.08039),
  ('unknown', 2, 'spread_length', -1.257, 0.1358),
  ('unknown', 2, 'spread_width', -1.514, 0.1226),
  ('unknown', 2, 'tilt_deg', 0.3438, 0.5139),
  ('unknown', 2, 'width', -1.479, 0.2225),
  ('unknown', 2, 'z_max', 0.8356, 0.1176),
  ('unknown', 2, 'z_min', 0.8239, 0.1194);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.02822, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'area_m2', -1.912, 0.3208),
  ('unknown', 3, 'aspect', 0.3062, 0.246),
  ('unknown', 3, 'behind', 0.6605, 0.1833),
  ('unknown', 3, 'edge_free', 0.3999, 0.1403),
  ('unknown', 3, 'edge_free_top', 0.5788, 0.2671),
  ('unknown', 3, 'edge_joined', 0.3032, 0.2446),
  ('unknown', 3, 'edge_unseen', 0.006522, 0.03),
  ('unknown', 3, 'height', 0.2305, 0.05542),
  ('unknown', 3, 'length', -0.482, 0.1908),
  ('unknown', 3, 'rectangularity', 0.4604, 0.1471),
  ('unknown', 3, 'spread_length', -0.6369, 0.1932),
  ('unknown', 3, 'spread_width', -1.111, 0.2101),
  ('unknown', 3, 'tilt_deg', 88.96, 1.604),
  ('unknown', 3, 'width', -0.7767, 0.185),
  ('unknown', 3, 'z_max', 0.5167, 0.1051),
  ('unknown', 3, 'z_min', -0.009157, 0.03932);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.02557, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'area_m2', -1.301, 0.1477),
  ('unknown', 4, 'aspect', 1.719, 0.157),
  ('unknown', 4, 'behind', 0.2741, 0.2894),
  ('unknown', 4, 'edge_free', 0.8864, 0.1328),
  ('unknown', 4, 'edge_free_top', 0.5649, 0.1307),
  ('unknown', 4, 'edge_joined', 0.1047, 0.1259),
  ('unknown', 4, 'edge_unseen', 0.01141, 0.03195),
  ('unknown', 4, 'height', 2.524, 0.2733),
  ('unknown', 4, 'length', 0.2939, 0.1074),
  ('unknown', 4, 'rectangularity', 0.857, 0.04939),
  ('unknown', 4, 'spread_length', 0.2407, 0.121),
  ('unknown', 4, 'spread_width', -1.553, 0.05215),
  ('unknown', 4, 'tilt_deg', 0.833, 1.443),
  ('unknown', 4, 'width', -1.443, 0.1094),
  ('unknown', 4, 'z_max', 2.545, 0.2909),
  ('unknown', 4, 'z_min', 2.533, 0.2824);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.03897, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'area_m2', -2.719, 0.3184),
  ('unknown', 5, 'aspect', 0.4975, 0.3536),
  ('unknown', 5, 'behind', 0.5849, 0.2002),
  ('unknown', 5, 'edge_free', 0.6026, 0.1017),
  ('unknown', 5, 'edge_free_top', 0.9752, 0.04692),
  ('unknown', 5, 'edge_joined', 0.08161, 0.1016),
  ('unknown', 5, 'edge_unseen', 0.007242, 0.03675),
  ('unknown', 5, 'height', 0.8604, 0.03434),
  ('unknown', 5, 'length', -0.9933, 0.2685),
  ('unknown', 5, 'rectangularity', 0.7258, 0.1004),
  ('unknown', 5, 'spread_length', -1.266, 0.1383),
  ('unknown', 5, 'spread_width', -1.548, 0.2202),
  ('unknown', 5, 'tilt_deg', 85.05, 8.763),
  ('unknown', 5, 'width', -1.428, 0.2144),
  ('unknown', 5, 'z_max', 0.972, 0.05559),
  ('unknown', 5, 'z_min', 0.7338, 0.03674);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.03342, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'area_m2', -1.834, 0.634),
  ('unknown', 6, 'aspect', 0.9131, 0.6913),
  ('unknown', 6, 'behind', 0.3475, 0.1152),
  ('unknown', 6, 'edge_free', 0.2842, 0.2151),
  ('unknown', 6, 'edge_free_top', 0.4111, 0.2512),
  ('unknown', 6, 'edge_joined', 0.3685, 0.2613),
  ('unknown', 6, 'edge_unseen', 0.1662, 0.1008),
  ('unknown', 6, 'height', 1.084, 0.3647),
  ('unknown', 6, 'length', -0.2235, 0.3365),
  ('unknown', 6, 'rectangularity', 0.6946, 0.0941),
  ('unknown', 6, 'spread_length', -0.47, 0.3182),
  ('unknown', 6, 'spread_width', -1.416, 0.587),
  ('unknown', 6, 'tilt_deg', 88.3, 0.9517),
  ('unknown', 6, 'width', -1.14, 0.5809),
  ('unknown', 6, 'z_max', 1.41, 0.4021),
  ('unknown', 6, 'z_min', 0.7343, 0.2584);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.04942, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'area_m2', -1.704, 0.5212),
  ('unknown', 7, 'aspect', 0.6722, 0.4123),
  ('unknown', 7, 'behind', 0.7326, 0.1041),
  ('unknown', 7, 'edge_free', 0.2553, 0.1135),
  ('unknown', 7, 'edge_free_top', 0.5549, 0.1252),
  ('unknown', 7, 'edge_joined', 0.6017, 0.2496),
  ('unknown', 7, 'edge_unseen', 0.06742, 0.08837),
  ('unknown', 7, 'height', 0.9491, 0.273),
  ('unknown', 7, 'length', -0.2485, 0.4076),
  ('unknown', 7, 'rectangularity', 0.6556, 0.1177),
  ('unknown', 7, 'spread_length', -0.2616, 0.4508),
  ('unknown', 7, 'spread_width', -1.073, 0.341),
  ('unknown', 7, 'tilt_deg', 3.994, 1.081),
  ('unknown', 7, 'width', -0.9482, 0.1902),
  ('unknown', 7, 'z_max', 1.021, 0.3141),
  ('unknown', 7, 'z_min', 0.9666, 0.3045);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.03547, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'area_m2', -3.63, 0.58),
  ('unknown', 8, 'aspect', 0.7674, 0.3255),
  ('unknown', 8, 'behind', 0.2216, 0.2234),
  ('unknown', 8, 'edge_free', 0.541, 0.242),
  ('unknown', 8, 'edge_free_top', 0.649, 0.3922),
  ('unknown', 8, 'edge_joined', 0.3441, 0.2347),
  ('unknown', 8, 'edge_unseen', 0.1211, 0.1538),
  ('unknown', 8, 'height', 0.5262, 0.4517),
  ('unknown', 8, 'length', -1.345, 0.352),
  ('unknown', 8, 'rectangularity', 0.7306, 0.1012),
  ('unknown', 8, 'spread_length', -1.459, 0.4349),
  ('unknown', 8, 'spread_width', -2.248, 0.2844),
  ('unknown', 8, 'tilt_deg', 23.89, 20.48),
  ('unknown', 8, 'width', -2.004, 0.3766),
  ('unknown', 8, 'z_max', 0.4739, 0.4675),
  ('unknown', 8, 'z_min', 0.4099, 0.4232);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.02953, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'area_m2', -2.134, 0.2807),
  ('unknown', 9, 'aspect', 0.4558, 0.2855),
  ('unknown', 9, 'behind', 0.7283, 0.06937),
  ('unknown', 9, 'edge_free', 0.3542, 0.1199),
  ('unknown', 9, 'edge_free_top', 0.6041, 0.1833),
  ('unknown', 9, 'edge_joined', 0.318, 0.1817),
  ('unknown', 9, 'edge_unseen', 0.001767, 0.03),
  ('unknown', 9, 'height', 1.323, 0.4229),
  ('unknown', 9, 'length', -0.6437, 0.1947),
  ('unknown', 9, 'rectangularity', 0.6372, 0.07151),
  ('unknown', 9, 'spread_length', -0.9637, 0.2141),
  ('unknown', 9, 'spread_width', -1.332, 0.1882),
  ('unknown', 9, 'tilt_deg', 89.15, 1.724),
  ('unknown', 9, 'width', -1.08, 0.1726),
  ('unknown', 9, 'z_max', 1.577, 0.4302),
  ('unknown', 9, 'z_min', 1.115, 0.3865);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.02654, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'area_m2', -1.299, 0.2771),
  ('unknown', 10, 'aspect', 1.629, 0.2065),
  ('unknown', 10, 'behind', 0.6561, 0.1754),
  ('unknown', 10, 'edge_free', 0.2059, 0.1906),
  ('unknown', 10, 'edge_free_top', 0.01075, 0.03337),
  ('unknown', 10, 'edge_joined', 0.3927, 0.316),
  ('unknown', 10, 'edge_unseen', 0.0163, 0.03787),
  ('unknown', 10, 'height', 1.512, 0.07948),
  ('unknown', 10, 'length', 0.3134, 0.1308),
  ('unknown', 10, 'rectangularity', 0.7891, 0.0586),
  ('unknown', 10, 'spread_length', 0.1359, 0.1145),
  ('unknown', 10, 'spread_width', -1.484, 0.2225),
  ('unknown', 10, 'tilt_deg', 89.87, 1.09),
  ('unknown', 10, 'width', -1.342, 0.2294),
  ('unknown', 10, 'z_max', 2.242, 0.1458),
  ('unknown', 10, 'z_min', 0.8322, 0.09013);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.02895, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'area_m2', -0.9077, 0.4224),
  ('unknown', 11, 'aspect', 0.2755, 0.2051),
  ('unknown', 11, 'behind', 0.6668, 0.1878),
  ('unknown', 11, 'edge_free', 0.4163, 0.223),
  ('unknown', 11, 'edge_free_top', 0.3071, 0.1792),
  ('unknown', 11, 'edge_joined', 0.2928, 0.1967),
  ('unknown', 11, 'edge_unseen', 0.009589, 0.03995),
  ('unknown', 11, 'height', 0.4208, 0.09611),
  ('unknown', 11, 'length', -0.08691, 0.179),
  ('unknown', 11, 'rectangularity', 0.6282, 0.1056),
  ('unknown', 11, 'spread_length', -0.2514, 0.1369),
  ('unknown', 11, 'spread_width', -0.6211, 0.2765),
  ('unknown', 11, 'tilt_deg', 89.37, 1.608),
  ('unknown', 11, 'width', -0.3377, 0.1879),
  ('unknown', 11, 'z_max', 0.742, 0.04647),
  ('unknown', 11, 'z_min', 0.01494, 0.06572);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.06477, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'area_m2', -1.957, 0.4437),
  ('unknown', 12, 'aspect', 1.11, 0.4908),
  ('unknown', 12, 'behind', 0.5747, 0.2006),
  ('unknown', 12, 'edge_free', 0.4345, 0.2559),
  ('unknown', 12, 'edge_free_top', 0.3114, 0.247),
  ('unknown', 12, 'edge_joined', 0.2829, 0.3175),
  ('unknown', 12, 'edge_unseen', 0.009512, 0.03),
  ('unknown', 12, 'height', 0.4587, 0.09707),
  ('unknown', 12, 'length', -0.1491, 0.2569),
  ('unknown', 12, 'rectangularity', 0.576, 0.2221),
  ('unknown', 12, 'spread_length', -0.1386, 0.3657),
  ('unknown', 12, 'spread_width', -1.548, 0.5114),
  ('unknown', 12, 'tilt_deg', 88.73, 1.18),
  ('unknown', 12, 'width', -1.18, 0.4983),
  ('unknown', 12, 'z_max', 0.7458, 0.1638),
  ('unknown', 12, 'z_min', 0.1831, 0.1166);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.01895, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'area_m2', -2.068, 0.5741),
  ('unknown', 13, 'aspect', 0.4334, 0.3343),
  ('unknown', 13, 'behind', 0.3918, 0.1477),
  ('unknown', 13, 'edge_free', 0.8454, 0.2026),
  ('unknown', 13, 'edge_free_top', 0.9845, 0.0357),
  ('unknown', 13, 'edge_joined', 0.01091, 0.03),
  ('unknown', 13, 'edge_unseen', 0.1801, 0.1562),
  ('unknown', 13, 'height', 0.7293, 0.2245),
  ('unknown', 13, 'length', -0.58, 0.3036),
  ('unknown', 13, 'rectangularity', 0.6392, 0.1139),
  ('unknown', 13, 'spread_length', -0.7515, 0.3733),
  ('unknown', 13, 'spread_width', -1.221, 0.3292),
  ('unknown', 13, 'tilt_deg', 84.86, 7.921),
  ('unknown', 13, 'width', -0.9865, 0.3223),
  ('unknown', 13, 'z_max', 0.9691, 0.2597),
  ('unknown', 13, 'z_min', 0.4687, 0.1419);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.01987, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'area_m2', -2.518, 0.2426),
  ('unknown', 14, 'aspect', 0.4051, 0.2061),
  ('unknown', 14, 'behind', 0.6481, 0.1809),
  ('unknown', 14, 'edge_free', 0.3308, 0.138),
  ('unknown', 14, 'edge_free_top', 0.5085, 0.2837),
  ('unknown', 14, 'edge_joined', 0.3763, 0.2496),
  ('unknown', 14, 'edge_unseen', 0.008513, 0.03567),
  ('unknown', 14, 'height', 0.805, 0.1791),
  ('unknown', 14, 'length', -0.8974, 0.1803),
  ('unknown', 14, 'rectangularity', 0.6825, 0.05281),
  ('unknown', 14, 'spread_length', -1.126, 0.1531),
  ('unknown', 14, 'spread_width', -1.447, 0.1387),
  ('unknown', 14, 'tilt_deg', 87.09, 7.048),
  ('unknown', 14, 'width', -1.249, 0.1614),
  ('unknown', 14, 'z_max', 0.9953, 0.2183),
  ('unknown', 14, 'z_min', 0.6238, 0.2123);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.01893, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'area_m2', -3.142, 0.4298),
  ('unknown', 15, 'aspect', 0.444, 0.2474),
  ('unknown', 15, 'behind', 0.5191, 0.1939),
  ('unknown', 15, 'edge_free', 0.3648, 0.2654),
  ('unknown', 15, 'edge_free_top', 0.493, 0.3965),
  ('unknown', 15, 'edge_joined', 0.2173, 0.2229),
  ('unknown', 15, 'edge_unseen', 0.1131, 0.1586),
  ('unknown', 15, 'height', 0.2396, 0.08638),
  ('unknown', 15, 'length', -1.136, 0.3053),
  ('unknown', 15, 'rectangularity', 0.7289, 0.1108),
  ('unknown', 15, 'spread_length', -1.332, 0.2709),
  ('unknown', 15, 'spread_width', -1.865, 0.2409),
  ('unknown', 15, 'tilt_deg', 86.88, 4.155),
  ('unknown', 15, 'width', -1.638, 0.2303),
  ('unknown', 15, 'z_max', 0.3805, 0.0697),
  ('unknown', 15, 'z_min', 0.09091, 0.1007);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.02109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'area_m2', -1.394, 0.3852),
  ('unknown', 16, 'aspect', 1.633, 0.2837),
  ('unknown', 16, 'behind', 0.6541, 0.06472),
  ('unknown', 16, 'edge_free', 0.1877, 0.2172),
  ('unknown', 16, 'edge_free_top', 0.5651, 0.1306),
  ('unknown', 16, 'edge_joined', 0.7004, 0.2402),
  ('unknown', 16, 'edge_unseen', 0.02612, 0.04927),
  ('unknown', 16, 'height', 2.161, 0.1662),
  ('unknown', 16, 'length', 0.2715, 0.2288),
  ('unknown', 16, 'rectangularity', 0.7545, 0.06189),
  ('unknown', 16, 'spread_length', 0.1399, 0.2798),
  ('unknown', 16, 'spread_width', -1.521, 0.2189),
  ('unknown', 16, 'tilt_deg', 1.34, 2.031),
  ('unknown', 16, 'width', -1.374, 0.2719),
  ('unknown', 16, 'z_max', 2.174, 0.183),
  ('unknown', 16, 'z_min', 2.161, 0.1719);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.03119, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'area_m2', -1.208, 0.3599),
  ('unknown', 17, 'aspect', 0.4052, 0.3029),
  ('unknown', 17, 'behind', 0.007292, 0.03),
  ('unknown', 17, 'edge_free', 0.02836, 0.0538),
  ('unknown', 17, 'edge_free_top', 0.03789, 0.07622),
  ('unknown', 17, 'edge_joined', 0.9192, 0.08964),
  ('unknown', 17, 'edge_unseen', -0.001954, 0.03),
  ('unknown', 17, 'height', 1.652, 0.08637),
  ('unknown', 17, 'length', -0.3227, 0.1687),
  ('unknown', 17, 'rectangularity', 0.8186, 0.05156),
  ('unknown', 17, 'spread_length', -0.4062, 0.1271),
  ('unknown', 17, 'spread_width', -1.019, 0.2566),
  ('unknown', 17, 'tilt_deg', 89.7, 1.155),
  ('unknown', 17, 'width', -0.7455, 0.3329),
  ('unknown', 17, 'z_max', 1.993, 0.1725),
  ('unknown', 17, 'z_min', 1.341, 0.06528);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.0375, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'area_m2', -1.056, 0.4078),
  ('unknown', 18, 'aspect', 1.079, 0.2988),
  ('unknown', 18, 'behind', 0.4919, 0.1975),
  ('unknown', 18, 'edge_free', 0.5678, 0.1257),
  ('unknown', 18, 'edge_free_top', 0.7624, 0.193),
  ('unknown', 18, 'edge_joined', 0.1116, 0.1221),
  ('unknown', 18, 'edge_unseen', 0.0119, 0.03523),
  ('unknown', 18, 'height', 0.9088, 0.1019),
  ('unknown', 18, 'length', 0.1012, 0.329),
  ('unknown', 18, 'rectangularity', 0.6559, 0.1247),
  ('unknown', 18, 'spread_length', 0.1248, 0.2804),
  ('unknown', 18, 'spread_width', -1.01, 0.2266),
  ('unknown', 18, 'tilt_deg', 88.77, 2.285),
  ('unknown', 18, 'width', -0.7811, 0.1767),
  ('unknown', 18, 'z_max', 1.181, 0.1491),
  ('unknown', 18, 'z_min', 0.6299, 0.1257);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.01873, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'area_m2', -2.32, 0.4397),
  ('unknown', 19, 'aspect', 0.4917, 0.2235),
  ('unknown', 19, 'behind', 0.7315, 0.08269),
  ('unknown', 19, 'edge_free', 0.6833, 0.1919),
  ('unknown', 19, 'edge_free_top', 0.5646, 0.1302),
  ('unknown', 19, 'edge_joined', 0.2842, 0.1063),
  ('unknown', 19, 'edge_unseen', 0.002205, 0.03),
  ('unknown', 19, 'height', 0.3784, 0.1236),
  ('unknown', 19, 'length', -0.8193, 0.2342),
  ('unknown', 19, 'rectangularity', 0.7978, 0.1045),
  ('unknown', 19, 'spread_length', -0.9592, 0.1433),
  ('unknown', 19, 'spread_width', -1.528, 0.1306),
  ('unknown', 19, 'tilt_deg', 0.8125, 1.748),
  ('unknown', 19, 'width', -1.271, 0.3246),
  ('unknown', 19, 'z_max', 0.3493, 0.0832),
  ('unknown', 19, 'z_min', 0.3441, 0.07183);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.02313, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'area_m2', -3.004, 0.3725),
  ('unknown', 20, 'aspect', 0.3234, 0.2195),
  ('unknown', 20, 'behind', 0.4351, 0.2237),
  ('unknown', 20, 'edge_free', 0.6666, 0.1099),
  ('unknown', 20, 'edge_free_top', 0.9865, 0.0355),
  ('unknown', 20, 'edge_joined', 0.03802, 0.05741),
  ('unknown', 20, 'edge_unseen', 0.004514, 0.03),
  ('unknown', 20, 'height', 1.436, 0.3906),
  ('unknown', 20, 'length', -1.214, 0.2511),
  ('unknown', 20, 'rectangularity', 0.7629, 0.1232),
  ('unknown', 20, 'spread_length', -1.345, 0.1793),
  ('unknown', 20, 'spread_width', -1.661, 0.1824),
  ('unknown', 20, 'tilt_deg', 89.33, 1.396),
  ('unknown', 20, 'width', -1.506, 0.2405),
  ('unknown', 20, 'z_max', 1.556, 0.3883),
  ('unknown', 20, 'z_min', 1.277, 0.3583);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.02209, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'area_m2', -0.5467, 0.3623),
  ('unknown', 21, 'aspect', 0.2927, 0.1954),
  ('unknown', 21, 'behind', 0.4533, 0.1345),
  ('unknown', 21, 'edge_free', 0.7284, 0.1502),
  ('unknown', 21, 'edge_free_top', 0.9114, 0.1234),
  ('unknown', 21, 'edge_joined', 0.1138, 0.1189),
  ('unknown', 21, 'edge_unseen', 0.07139, 0.08557),
  ('unknown', 21, 'height', 0.5232, 0.08857),
  ('unknown', 21, 'length', 0.04574, 0.2213),
  ('unknown', 21, 'rectangularity', 0.7541, 0.07256),
  ('unknown', 21, 'spread_length', -0.07874, 0.2229),
  ('unknown', 21, 'spread_width', -0.5067, 0.2135),
  ('unknown', 21, 'tilt_deg', 80.79, 3.643),
  ('unknown', 21, 'width', -0.2688, 0.1932),
  ('unknown', 21, 'z_max', 0.9231, 0.2144),
  ('unknown', 21, 'z_min', 0.02831, 0.07167);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.02183, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'area_m2', -2.946, 0.2936),
  ('unknown', 22, 'aspect', 0.9956, 0.2333),
  ('unknown', 22, 'behind', 0.5216, 0.2602),
  ('unknown', 22, 'edge_free', 0.6322, 0.2232),
  ('unknown', 22, 'edge_free_top', 0.4804, 0.3936),
  ('unknown', 22, 'edge_joined', 0.1069, 0.1372),
  ('unknown', 22, 'edge_unseen', 0.004691, 0.03044),
  ('unknown', 22, 'height', 0.4369, 0.1228),
  ('unknown', 22, 'length', -0.7197, 0.1993),
  ('unknown', 22, 'rectangularity', 0.655, 0.1517),
  ('unknown', 22, 'spread_length', -0.8482, 0.2838),
  ('unknown', 22, 'spread_width', -2.116, 0.3127),
  ('unknown', 22, 'tilt_deg', 87.47, 2.801),
  ('unknown', 22, 'width', -1.748, 0.3368),
  ('unknown', 22, 'z_max', 0.6249, 0.1348),
  ('unknown', 22, 'z_min', 0.283, 0.152);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.02288, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'area_m2', -0.3452, 0.2527),
  ('unknown', 23, 'aspect', 0.5258, 0.2132),
  ('unknown', 23, 'behind', 0.451, 0.05667),
  ('unknown', 23, 'edge_free', 0.917, 0.0918),
  ('unknown', 23, 'edge_free_top', 0.9921, 0.03223),
  ('unknown', 23, 'edge_joined', 0.02348, 0.03853),
  ('unknown', 23, 'edge_unseen', 0.0004134, 0.03),
  ('unknown', 23, 'height', 0.4864, 0.03417),
  ('unknown', 23, 'length', 0.1283, 0.2155),
  ('unknown', 23, 'rectangularity', 0.8721, 0.06735),
  ('unknown', 23, 'spread_length', 0.09662, 0.2309),
  ('unknown', 23, 'spread_width', -0.4619, 0.075),
  ('unknown', 23, 'tilt_deg', 89.75, 1.367),
  ('unknown', 23, 'width', -0.3616, 0.1271),
  ('unknown', 23, 'z_max', 0.7767, 0.06287),
  ('unknown', 23, 'z_min', 0.09291, 0.04595);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.01197, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'area_m2', -3.308, 0.3798),
  ('unknown', 24, 'aspect', 0.6325, 0.3684),
  ('unknown', 24, 'behind', 0.5705, 0.2431),
  ('unknown', 24, 'edge_free', 0.384, 0.1811),
  ('unknown', 24, 'edge_free_top', 0.555, 0.3432),
  ('unknown', 24, 'edge_joined', 0.3518, 0.2703),
  ('unknown', 24, 'edge_unseen', 0.003731, 0.03),
  ('unknown', 24, 'height', 1.226, 0.4071),
  ('unknown', 24, 'length', -1.193, 0.2658),
  ('unknown', 24, 'rectangularity', 0.7079, 0.1298),
  ('unknown', 24, 'spread_length', -1.347, 0.1852),
  ('unknown', 24, 'spread_width', -1.931, 0.2705),
  ('unknown', 24, 'tilt_deg', 88.28, 2.958),
  ('unknown', 24, 'width', -1.771, 0.2901),
  ('unknown', 24, 'z_max', 1.376, 0.4005),
  ('unknown', 24, 'z_min', 1.106, 0.35);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.03567, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'area_m2', 3.103, 0.9584),
  ('unknown', 25, 'aspect', 0.9371, 0.7815),
  ('unknown', 25, 'behind', 0.002889, 0.03),
  ('unknown', 25, 'edge_free', 0.01036, 0.03),
  ('unknown', 25, 'edge_free_top', 0.01246, 0.03387),
  ('unknown', 25, 'edge_joined', 0.1156, 0.1664),
  ('unknown', 25, 'edge_unseen', 0.1193, 0.1467),
  ('unknown', 25, 'height', 2.202, 1.311),
  ('unknown', 25, 'length', 2.062, 0.2997),
  ('unknown', 25, 'rectangularity', 0.8059, 0.1408),
  ('unknown', 25, 'spread_length', 1.912, 0.2932),
  ('unknown', 25, 'spread_width', 1.143, 0.7236),
  ('unknown', 25, 'tilt_deg', 89.84, 1.051),
  ('unknown', 25, 'width', 1.175, 0.7931),
  ('unknown', 25, 'z_max', 5.813, 2.786),
  ('unknown', 25, 'z_min', -1.19, 1.281);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.02047, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'area_m2', -2.08, 0.5345),
  ('unknown', 26, 'aspect', 1.069, 0.4279),
  ('unknown', 26, 'behind', 0.2482, 0.2746),
  ('unknown', 26, 'edge_free', 0.9869, 0.03035),
  ('unknown', 26, 'edge_free_top', 0.5653, 0.1313),
  ('unknown', 26, 'edge_joined', 0.01111, 0.03),
  ('unknown', 26, 'edge_unseen', 0.2187, 0.1196),
  ('unknown', 26, 'height', 2.521, 0.2573),
  ('unknown', 26, 'length', -0.3583, 0.4682),
  ('unknown', 26, 'rectangularity', 0.7837, 0.09661),
  ('unknown', 26, 'spread_length', -0.5156, 0.4846),
  ('unknown', 26, 'spread_width', -1.614, 0.08887),
  ('unknown', 26, 'tilt_deg', 1.36, 1.901),
  ('unknown', 26, 'width', -1.495, 0.09294),
  ('unknown', 26, 'z_max', 2.557, 0.2544),
  ('unknown', 26, 'z_min', 2.545, 0.2467);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.02247, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'area_m2', -3.728, 0.3515),
  ('unknown', 27, 'aspect', 0.2687, 0.255),
  ('unknown', 27, 'behind', 0.2677, 0.2108),
  ('unknown', 27, 'edge_free', 0.3496, 0.348),
  ('unknown', 27, 'edge_free_top', 0.5655, 0.1305),
  ('unknown', 27, 'edge_joined', 0.576, 0.3302),
  ('unknown', 27, 'edge_unseen', 0.0007414, 0.03),
  ('unknown', 27, 'height', 0.7873, 0.07097),
  ('unknown', 27, 'length', -1.6, 0.1876),
  ('unknown', 27, 'rectangularity', 0.7606, 0.05337),
  ('unknown', 27, 'spread_length', -1.725, 0.1825),
  ('unknown', 27, 'spread_width', -1.97, 0.1982),
  ('unknown', 27, 'tilt_deg', 5.613, 7.358),
  ('unknown', 27, 'width', -1.866, 0.1864),
  ('unknown', 27, 'z_max', 0.7891, 0.06756),
  ('unknown', 27, 'z_min', 0.7728, 0.06591);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.007795, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'area_m2', -2.4, 0.4712),
  ('unknown', 28, 'aspect', 0.4511, 0.3636),
  ('unknown', 28, 'behind', 0.01055, 0.03635),
  ('unknown', 28, 'edge_free', 0.01758, 0.03),
  ('unknown', 28, 'edge_free_top', 0.02776, 0.05962),
  ('unknown', 28, 'edge_joined', 0.8391, 0.1932),
  ('unknown', 28, 'edge_unseen', 0.1115, 0.108),
  ('unknown', 28, 'height', 1.638, 0.1948),
  ('unknown', 28, 'length', -0.815, 0.2928),
  ('unknown', 28, 'rectangularity', 0.7694, 0.07226),
  ('unknown', 28, 'spread_length', -0.9864, 0.3287),
  ('unknown', 28, 'spread_width', -1.528, 0.2247),
  ('unknown', 28, 'tilt_deg', 89.46, 2.151),
  ('unknown', 28, 'width', -1.305, 0.2396),
  ('unknown', 28, 'z_max', 1.876, 0.1849),
  ('unknown', 28, 'z_min', 1.445, 0.2206);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.02266, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'area_m2', -1.426, 0.3855),
  ('unknown', 29, 'aspect', 1.659, 0.3105),
  ('unknown', 29, 'behind', 0.7063, 0.09926),
  ('unknown', 29, 'edge_free', 0.01969, 0.03781),
  ('unknown', 29, 'edge_free_top', 0.565, 0.1308),
  ('unknown', 29, 'edge_joined', 0.9154, 0.1046),
  ('unknown', 29, 'edge_unseen', 0.02702, 0.05619),
  ('unknown', 29, 'height', 0.8821, 0.08527),
  ('unknown', 29, 'length', 0.2737, 0.2486),
  ('unknown', 29, 'rectangularity', 0.7638, 0.06826),
  ('unknown', 29, 'spread_length', 0.1059, 0.2839),
  ('unknown', 29, 'spread_width', -1.535, 0.2489),
  ('unknown', 29, 'tilt_deg', 1.451, 1.867),
  ('unknown', 29, 'width', -1.453, 0.2043),
  ('unknown', 29, 'z_max', 0.8857, 0.08353),
  ('unknown', 29, 'z_min', 0.8738, 0.08923);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.02078, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'area_m2', 1.943, 0.6073),
  ('unknown', 30, 'aspect', 0.3362, 0.252),
  ('unknown', 30, 'behind', 0.008007, 0.03305),
  ('unknown', 30, 'edge_free', 0.005607, 0.03),
  ('unknown', 30, 'edge_free_top', 0.007833, 0.03),
  ('unknown', 30, 'edge_joined', 0.07463, 0.1446),
  ('unknown', 30, 'edge_unseen', 0.02914, 0.06926),
  ('unknown', 30, 'height', 1.443, 0.6922),
  ('unknown', 30, 'length', 1.308, 0.3381),
  ('unknown', 30, 'rectangularity', 0.8841, 0.124),
  ('unknown', 30, 'spread_length', 1.333, 0.3011),
  ('unknown', 30, 'spread_width', 0.8543, 0.3472),
  ('unknown', 30, 'tilt_deg', 89.59, 1.473),
  ('unknown', 30, 'width', 0.8251, 0.3826),
  ('unknown', 30, 'z_max', 3.096, 1.286),
  ('unknown', 30, 'z_min', -0.277, 0.775);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.01342, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'area_m2', -1.854, 0.3105),
  ('unknown', 31, 'aspect', 0.1904, 0.1481),
  ('unknown', 31, 'behind', 0.2833, 0.1226),
  ('unknown', 31, 'edge_free', 0.8115, 0.1248),
  ('unknown', 31, 'edge_free_top', 0.565, 0.1307),
  ('unknown', 31, 'edge_joined', 0.01584, 0.03097),
  ('unknown', 31, 'edge_unseen', 0.03229, 0.09183),
  ('unknown', 31, 'height', 0.1127, 0.04887),
  ('unknown', 31, 'length', -0.5748, 0.1577),
  ('unknown', 31, 'rectangularity', 0.6029, 0.08004),
  ('unknown', 31, 'spread_length', -0.7821, 0.09946),
  ('unknown', 31, 'spread_width', -1.007, 0.1584),
  ('unknown', 31, 'tilt_deg', 1.137, 2.144),
  ('unknown', 31, 'width', -0.776, 0.234),
  ('unknown', 31, 'z_max', 0.1165, 0.05421),
  ('unknown', 31, 'z_min', 0.1065, 0.04389);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.008669, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'area_m2', -2.461, 0.6709),
  ('unknown', 32, 'aspect', 0.9834, 0.4386),
  ('unknown', 32, 'behind', 0.511, 0.19),
  ('unknown', 32, 'edge_free', 0.3539, 0.2965),
  ('unknown', 32, 'edge_free_top', 0.5664, 0.1323),
  ('unknown', 32, 'edge_joined', 0.4637, 0.2814),
  ('unknown', 32, 'edge_unseen', 0.2013, 0.1537),
  ('unknown', 32, 'height', 2.145, 0.1419),
  ('unknown', 32, 'length', -0.5586, 0.4419),
  ('unknown', 32, 'rectangularity', 0.7138, 0.1061),
  ('unknown', 32, 'spread_length', -0.7698, 0.4384),
  ('unknown', 32, 'spread_width', -1.723, 0.2766),
  ('unknown', 32, 'tilt_deg', 2.035, 2.989),
  ('unknown', 32, 'width', -1.557, 0.286),
  ('unknown', 32, 'z_max', 2.17, 0.1386),
  ('unknown', 32, 'z_min', 2.159, 0.1303);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.01455, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'area_m2', 0.1808, 0.6996),
  ('unknown', 33, 'aspect', 0.5131, 0.2223),
  ('unknown', 33, 'behind', 0.4027, 0.3373),
  ('unknown', 33, 'edge_free', 0.2914, 0.2552),
  ('unknown', 33, 'edge_free_top', 0.4189, 0.2695),
  ('unknown', 33, 'edge_joined', 0.5725, 0.2182),
  ('unknown', 33, 'edge_unseen', 0.02346, 0.05657),
  ('unknown', 33, 'height', 1.184, 0.3489),
  ('unknown', 33, 'length', 0.7, 0.2904),
  ('unknown', 33, 'rectangularity', 0.6, 0.1104),
  ('unknown', 33, 'spread_length', 0.5379, 0.266),
  ('unknown', 33, 'spread_width', -0.08906, 0.4212),
  ('unknown', 33, 'tilt_deg', 88.16, 1.498),
  ('unknown', 33, 'width', 0.09858, 0.5115),
  ('unknown', 33, 'z_max', 2.113, 0.3212),
  ('unknown', 33, 'z_min', 0.1493, 0.2143);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.01035, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'area_m2', -1.365, 0.4609),
  ('unknown', 34, 'aspect', 2.287, 0.3725),
  ('unknown', 34, 'behind', 0.4116, 0.3166),
  ('unknown', 34, 'edge_free', 0.377, 0.1734),
  ('unknown', 34, 'edge_free_top', 0.177, 0.1884),
  ('unknown', 34, 'edge_joined', 0.4697, 0.2373),
  ('unknown', 34, 'edge_unseen', 0.008694, 0.03175),
  ('unknown', 34, 'height', 1.227, 0.2317),
  ('unknown', 34, 'length', 0.5713, 0.2029),
  ('unknown', 34, 'rectangularity', 0.6703, 0.0846),
  ('unknown', 34, 'spread_length', 0.4351, 0.1938),
  ('unknown', 34, 'spread_width', -2.01, 0.3416),
  ('unknown', 34, 'tilt_deg', 89.67, 2.265),
  ('unknown', 34, 'width', -1.601, 0.4876),
  ('unknown', 34, 'z_max', 2.04, 0.2314),
  ('unknown', 34, 'z_min', 0.2782, 0.3476);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.0134, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'area_m2', -0.5646, 0.3364),
  ('unknown', 35, 'aspect', 0.4701, 0.1063),
  ('unknown', 35, 'behind', 0.04888, 0.07313),
  ('unknown', 35, 'edge_free', 0.904, 0.1032),
  ('unknown', 35, 'edge_free_top', 0.9729, 0.05273),
  ('unknown', 35, 'edge_joined', 0.033, 0.05672),
  ('unknown', 35, 'edge_unseen', 0.09918, 0.1266),
  ('unknown', 35, 'height', 1.641, 0.1258),
  ('unknown', 35, 'length', 0.02151, 0.2149),
  ('unknown', 35, 'rectangularity', 0.8662, 0.1043),
  ('unknown', 35, 'spread_length', -0.05574, 0.2041),
  ('unknown', 35, 'spread_width', -0.5441, 0.1422),
  ('unknown', 35, 'tilt_deg', 89.41, 2.186),
  ('unknown', 35, 'width', -0.3873, 0.1263),
  ('unknown', 35, 'z_max', 2.017, 0.1556),
  ('unknown', 35, 'z_min', 1.366, 0.08994);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.009641, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'area_m2', -0.9177, 1.268),
  ('unknown', 36, 'aspect', 1.248, 0.6754),
  ('unknown', 36, 'behind', 0.6317, 0.192),
  ('unknown', 36, 'edge_free', 0.4004, 0.2232),
  ('unknown', 36, 'edge_free_top', 0.1198, 0.1964),
  ('unknown', 36, 'edge_joined', 0.4323, 0.2695),
  ('unknown', 36, 'edge_unseen', 0.06411, 0.08488),
  ('unknown', 36, 'height', 2.208, 0.944),
  ('unknown', 36, 'length', 0.3876, 0.6931),
  ('unknown', 36, 'rectangularity', 0.6242, 0.2111),
  ('unknown', 36, 'spread_length', 0.3638, 0.6342),
  ('unknown', 36, 'spread_width', -1.095, 0.7779),
  ('unknown', 36, 'tilt_deg', 50.74, 38.16),
  ('unknown', 36, 'width', -0.8127, 0.7523),
  ('unknown', 36, 'z_max', 2.523, 1.128),
  ('unknown', 36, 'z_min', 2.095, 1.022);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.009994, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'area_m2', -1.176, 0.2977),
  ('unknown', 37, 'aspect', 0.3143, 0.2291),
  ('unknown', 37, 'behind', 0.1127, 0.181),
  ('unknown', 37, 'edge_free', 0.01778, 0.03),
  ('unknown', 37, 'edge_free_top', 0.01607, 0.04074),
  ('unknown', 37, 'edge_joined', 0.9004, 0.1294),
  ('unknown', 37, 'edge_unseen', 0.1799, 0.1072),
  ('unknown', 37, 'height', 1.592, 0.08236),
  ('unknown', 37, 'length', -0.2688, 0.1723),
  ('unknown', 37, 'rectangularity', 0.7194, 0.09797),
  ('unknown', 37, 'spread_length', -0.4268, 0.2332),
  ('unknown', 37, 'spread_width', -0.869, 0.2097),
  ('unknown', 37, 'tilt_deg', 89.17, 2.493),
  ('unknown', 37, 'width', -0.56, 0.2196),
  ('unknown', 37, 'z_max', 1.98, 0.1243),
  ('unknown', 37, 'z_min', 1.29, 0.07617);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.004418, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'area_m2', -3.7, 0.4371),
  ('unknown', 38, 'aspect', 0.7861, 0.3755),
  ('unknown', 38, 'behind', 0.5248, 0.2858),
  ('unknown', 38, 'edge_free', 0.7889, 0.1906),
  ('unknown', 38, 'edge_free_top', 0.9804, 0.05112),
  ('unknown', 38, 'edge_joined', 0.1216, 0.1464),
  ('unknown', 38, 'edge_unseen', 0.09624, 0.1229),
  ('unknown', 38, 'height', 2.255, 0.3077),
  ('unknown', 38, 'length', -1.295, 0.3553),
  ('unknown', 38, 'rectangularity', 0.7715, 0.1009),
  ('unknown', 38, 'spread_length', -1.38, 0.3527),
  ('unknown', 38, 'spread_width', -2.343, 0.1701),
  ('unknown', 38, 'tilt_deg', 85.39, 5.732),
  ('unknown', 38, 'width', -2.117, 0.2801),
  ('unknown', 38, 'z_max', 2.341, 0.3289),
  ('unknown', 38, 'z_min', 2.201, 0.3452);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.005137, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'area_m2', -2.217, 0.3682),
  ('unknown', 39, 'aspect', 1.954, 0.3599),
  ('unknown', 39, 'behind', 0.6325, 0.1944),
  ('unknown', 39, 'edge_free', 0.7438, 0.1925),
  ('unknown', 39, 'edge_free_top', 0.9069, 0.1588),
  ('unknown', 39, 'edge_joined', 0.2358, 0.1983),
  ('unknown', 39, 'edge_unseen', 0.03266, 0.03867),
  ('unknown', 39, 'height', 2.508, 0.2575),
  ('unknown', 39, 'length', 0.06012, 0.2771),
  ('unknown', 39, 'rectangularity', 0.6934, 0.05818),
  ('unknown', 39, 'spread_length', 0.006258, 0.2732),
  ('unknown', 39, 'spread_width', -2.32, 0.1254),
  ('unknown', 39, 'tilt_deg', 83.37, 7.266),
  ('unknown', 39, 'width', -1.904, 0.2663),
  ('unknown', 39, 'z_max', 2.611, 0.2562),
  ('unknown', 39, 'z_min', 2.449, 0.2521);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.007601, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'area_m2', -0.8594, 0.4729),
  ('unknown', 40, 'aspect', 0.7316, 0.375),
  ('unknown', 40, 'behind', 0.1485, 0.1878),
  ('unknown', 40, 'edge_free', 0.2477, 0.2111),
  ('unknown', 40, 'edge_free_top', 0.04875, 0.0831),
  ('unknown', 40, 'edge_joined', 0.6662, 0.2082),
  ('unknown', 40, 'edge_unseen', 0.004537, 0.03),
  ('unknown', 40, 'height', 1.288, 0.1687),
  ('unknown', 40, 'length', 0.701, 0.1358),
  ('unknown', 40, 'rectangularity', 0.2271, 0.05121),
  ('unknown', 40, 'spread_length', 0.6781, 0.1513),
  ('unknown', 40, 'spread_width', -0.1878, 0.6745),
  ('unknown', 40, 'tilt_deg', 89.17, 3.145),
  ('unknown', 40, 'width', -0.04472, 0.3295),
  ('unknown', 40, 'z_max', 2.135, 0.0919),
  ('unknown', 40, 'z_min', 0.06592, 0.1229);

-- floor: 512 examples
UPDATE object_class SET prior = 0.04353 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.215, 1.682)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4801, 0.3969)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_joined', 0.247, 0.159)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_unseen', 0.2546, 0.1429)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.001528, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.133, 0.7709)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5836, 0.131)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.8754, 0.698)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.2699, 0.8949)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.5893, 0.9696)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.6486, 0.9865)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.007765, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.004685, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'floor';
DELETE FROM class_density WHERE class = 'floor';
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.245, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'area_m2', 2.553, 0.2742),
  ('floor', 1, 'aspect', 0.2674, 0.1615),
  ('floor', 1, 'behind', -0.0003467, 0.03225),
  ('floor', 1, 'edge_free', -0.0001339, 0.03086),
  ('floor', 1, 'edge_free_top', -3.604e-05, 0.3184),
  ('floor', 1, 'edge_joined', 0.2797, 0.1155),
  ('floor', 1, 'edge_unseen', 0.2001, 0.1254),
  ('floor', 1, 'height', 8.206e-05, 0.0225),
  ('floor', 1, 'length', 1.716, 0.1321),
  ('floor', 1, 'rectangularity', 0.5523, 0.1283),
  ('floor', 1, 'spread_length', 1.376, 0.1217),
  ('floor', 1, 'spread_width', 0.9447, 0.1426),
  ('floor', 1, 'tilt_deg', 0.008375, 0.4589),
  ('floor', 1, 'width', 1.454, 0.1264),
  ('floor', 1, 'z_max', 0.000142, 0.0225),
  ('floor', 1, 'z_min', -9.584e-05, 0.02276);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.1738, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'area_m2', 2.204, 0.2036),
  ('floor', 2, 'aspect', 0.168, 0.1103),
  ('floor', 2, 'behind', -0.0002793, 0.03104),
  ('floor', 2, 'edge_free', -4.328e-05, 0.0303),
  ('floor', 2, 'edge_free_top', 2.259e-05, 0.3177),
  ('floor', 2, 'edge_joined', 0.3053, 0.1006),
  ('floor', 2, 'edge_unseen', 0.1884, 0.08729),
  ('floor', 2, 'height', 0.00067, 0.0225),
  ('floor', 2, 'length', 1.432, 0.1061),
  ('floor', 2, 'rectangularity', 0.622, 0.1078),
  ('floor', 2, 'spread_length', 1.161, 0.1028),
  ('floor', 2, 'spread_width', 0.8424, 0.117),
  ('floor', 2, 'tilt_deg', 0.03586, 0.4521),
  ('floor', 2, 'width', 1.266, 0.114),
  ('floor', 2, 'z_max', 0.001452, 0.0225),
  ('floor', 2, 'z_min', -0.0004979, 0.02263);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.1178, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'area_m2', 2.056, 0.3792),
  ('floor', 3, 'aspect', 0.7999, 0.1376),
  ('floor', 3, 'behind', -0.0001625, 0.03149),
  ('floor', 3, 'edge_free', -0.0001555, 0.03033),
  ('floor', 3, 'edge_free_top', -6.863e-06, 0.3179),
  ('floor', 3, 'edge_joined', 0.243, 0.12),
  ('floor', 3, 'edge_unseen', 0.2808, 0.09003),
  ('floor', 3, 'height', 3.147e-06, 0.0225),
  ('floor', 3, 'length', 1.769, 0.1932),
  ('floor', 3, 'rectangularity', 0.5107, 0.09309),
  ('floor', 3, 'spread_length', 1.394, 0.1511),
  ('floor', 3, 'spread_width', 0.5789, 0.2092),
  ('floor', 3, 'tilt_deg', 0.03099, 0.4544),
  ('floor', 3, 'width', 0.9744, 0.2216),
  ('floor', 3, 'z_max', 0.0005052, 0.0225),
  ('floor', 3, 'z_min', -0.0007507, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.113, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'area_m2', 1.716, 0.2586),
  ('floor', 4, 'aspect', 0.3573, 0.1816),
  ('floor', 4, 'behind', -0.0002696, 0.03098),
  ('floor', 4, 'edge_free', -0.0001596, 0.03009),
  ('floor', 4, 'edge_free_top', -0.0002487, 0.3183),
  ('floor', 4, 'edge_joined', 0.2045, 0.08717),
  ('floor', 4, 'edge_unseen', 0.2253, 0.05759),
  ('floor', 4, 'height', -0.0001502, 0.0225),
  ('floor', 4, 'length', 1.341, 0.1472),
  ('floor', 4, 'rectangularity', 0.5526, 0.09576),
  ('floor', 4, 'spread_length', 1.103, 0.1356),
  ('floor', 4, 'spread_width', 0.5937, 0.1424),
  ('floor', 4, 'tilt_deg', 0.05915, 0.4529),
  ('floor', 4, 'width', 0.9856, 0.164),
  ('floor', 4, 'z_max', 0.00131, 0.0225),
  ('floor', 4, 'z_min', -0.001514, 0.02278);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.07617, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'area_m2', 0.07012, 0.3782),
  ('floor', 5, 'aspect', 0.6425, 0.3723),
  ('floor', 5, 'behind', -0.002827, 0.03),
  ('floor', 5, 'edge_free', -0.0004702, 0.03),
  ('floor', 5, 'edge_free_top', -0.00111, 0.318),
  ('floor', 5, 'edge_joined', 0.1784, 0.1499),
  ('floor', 5, 'edge_unseen', 0.3317, 0.1417),
  ('floor', 5, 'height', 0.006026, 0.02398),
  ('floor', 5, 'length', 0.6254, 0.24),
  ('floor', 5, 'rectangularity', 0.588, 0.146),
  ('floor', 5, 'spread_length', 0.5019, 0.162),
  ('floor', 5, 'spread_width', -0.2785, 0.2161),
  ('floor', 5, 'tilt_deg', 1.513, 0.8037),
  ('floor', 5, 'width', 0.005022, 0.2402),
  ('floor', 5, 'z_max', 0.02787, 0.0288),
  ('floor', 5, 'z_min', -0.01465, 0.0255);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.06136, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'area_m2', -1.314, 0.4736),
  ('floor', 6, 'aspect', 0.5056, 0.2749),
  ('floor', 6, 'behind', -0.003085, 0.03),
  ('floor', 6, 'edge_free', -0.0004888, 0.03),
  ('floor', 6, 'edge_free_top', -0.0005377, 0.317),
  ('floor', 6, 'edge_joined', 0.2475, 0.2046),
  ('floor', 6, 'edge_unseen', 0.2952, 0.1587),
  ('floor', 6, 'height', 0.003565, 0.0225),
  ('floor', 6, 'length', -0.1662, 0.2455),
  ('floor', 6, 'rectangularity', 0.6251, 0.1656),
  ('floor', 6, 'spread_length', -0.3207, 0.1972),
  ('floor', 6, 'spread_width', -0.9421, 0.2807),
  ('floor', 6, 'tilt_deg', 1.833, 0.962),
  ('floor', 6, 'width', -0.6924, 0.246),
  ('floor', 6, 'z_max', 0.01355, 0.02283),
  ('floor', 6, 'z_min', -0.00753, 0.02472);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.04725, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'area_m2', -2.654, 0.7926),
  ('floor', 7, 'aspect', 1.075, 0.5803),
  ('floor', 7, 'behind', -0.003133, 0.03001),
  ('floor', 7, 'edge_free', -0.001657, 0.03),
  ('floor', 7, 'edge_free_top', -0.002715, 0.3235),
  ('floor', 7, 'edge_joined', 0.1682, 0.228),
  ('floor', 7, 'edge_unseen', 0.3569, 0.2156),
  ('floor', 7, 'height', -0.09107, 0.2495),
  ('floor', 7, 'length', -0.6061, 0.5403),
  ('floor', 7, 'rectangularity', 0.6492, 0.1619),
  ('floor', 7, 'spread_length', -0.6359, 0.3606),
  ('floor', 7, 'spread_width', -1.71, 0.3463),
  ('floor', 7, 'tilt_deg', 2.384, 0.5342),
  ('floor', 7, 'width', -1.553, 0.4593),
  ('floor', 7, 'z_max', -0.1675, 0.2319),
  ('floor', 7, 'z_min', -0.1376, 0.2726);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.05985, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'area_m2', -0.9183, 0.5014),
  ('floor', 8, 'aspect', 1.316, 0.252),
  ('floor', 8, 'behind', -0.001389, 0.03),
  ('floor', 8, 'edge_free', -0.0004052, 0.03),
  ('floor', 8, 'edge_free_top', -0.0005234, 0.3175),
  ('floor', 8, 'edge_joined', 0.2664, 0.277),
  ('floor', 8, 'edge_unseen', 0.408, 0.1318),
  ('floor', 8, 'height', 0.003115, 0.0225),
  ('floor', 8, 'length', 0.4349, 0.2593),
  ('floor', 8, 'rectangularity', 0.6313, 0.1612),
  ('floor', 8, 'spread_length', 0.2837, 0.2142),
  ('floor', 8, 'spread_width', -1.072, 0.2779),
  ('floor', 8, 'tilt_deg', 1.612, 0.8724),
  ('floor', 8, 'width', -0.8677, 0.2872),
  ('floor', 8, 'z_max', 0.01797, 0.0248),
  ('floor', 8, 'z_min', -0.01045, 0.02303);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.05583, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'area_m2', 1.254, 0.5476),
  ('floor', 9, 'aspect', 0.4223, 0.2144),
  ('floor', 9, 'behind', -0.0002546, 0.0305),
  ('floor', 9, 'edge_free', -0.0001884, 0.03002),
  ('floor', 9, 'edge_free_top', -0.0001959, 0.318),
  ('floor', 9, 'edge_joined', 0.1743, 0.08928),
  ('floor', 9, 'edge_unseen', 0.3611, 0.08633),
  ('floor', 9, 'height', 0.0002099, 0.0225),
  ('floor', 9, 'length', 1.146, 0.2399),
  ('floor', 9, 'rectangularity', 0.5599, 0.1137),
  ('floor', 9, 'spread_length', 0.9114, 0.1879),
  ('floor', 9, 'spread_width', 0.4186, 0.2854),
  ('floor', 9, 'tilt_deg', 1.281, 0.5527),
  ('floor', 9, 'width', 0.7246, 0.2636),
  ('floor', 9, 'z_max', 0.03262, 0.02256),
  ('floor', 9, 'z_min', -0.03465, 0.02273);

-- ceiling: 432 examples
UPDATE object_class SET prior = 0.03637 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.598, 1.658)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4171, 0.3899)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.01187, 0.06055)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.01147, 0.06105)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_joined', 0.4333, 0.2134)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_unseen', 0.3095, 0.1518)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.833, 0.314)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.214, 0.7335)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6751, 0.1234)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.091, 0.7279)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.5054, 0.8858)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.09106, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.7936, 0.9466)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.834, 0.3143)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.833, 0.3138)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'ceiling';
DELETE FROM class_density WHERE class = 'ceiling';
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.1868, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'area_m2', 2.588, 0.3241),
  ('ceiling', 1, 'aspect', 0.2105, 0.152),
  ('ceiling', 1, 'behind', 1.027e-05, 0.03),
  ('ceiling', 1, 'edge_free', 0.0001397, 0.03),
  ('ceiling', 1, 'edge_free_top', 0.000131, 0.3169),
  ('ceiling', 1, 'edge_joined', 0.6046, 0.166),
  ('ceiling', 1, 'edge_unseen', 0.3126, 0.1252),
  ('ceiling', 1, 'height', 2.51, 0.06479),
  ('ceiling', 1, 'length', 1.592, 0.1718),
  ('ceiling', 1, 'rectangularity', 0.6878, 0.1139),
  ('ceiling', 1, 'spread_length', 1.451, 0.1573),
  ('ceiling', 1, 'spread_width', 1.048, 0.1666),
  ('ceiling', 1, 'tilt_deg', 0.004396, 0.45),
  ('ceiling', 1, 'width', 1.382, 0.1373),
  ('ceiling', 1, 'z_max', 2.509, 0.06718),
  ('ceiling', 1, 'z_min', 2.509, 0.06642);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1542, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'area_m2', 2.494, 0.1974),
  ('ceiling', 2, 'aspect', 0.2165, 0.1322),
  ('ceiling', 2, 'behind', 0.000201, 0.03057),
  ('ceiling', 2, 'edge_free', 0.0001762, 0.03),
  ('ceiling', 2, 'edge_free_top', 0.0001469, 0.3165),
  ('ceiling', 2, 'edge_joined', 0.5103, 0.1493),
  ('ceiling', 2, 'edge_unseen', 0.377, 0.07995),
  ('ceiling', 2, 'height', 2.805, 0.1084),
  ('ceiling', 2, 'length', 1.6, 0.1055),
  ('ceiling', 2, 'rectangularity', 0.6127, 0.06818),
  ('ceiling', 2, 'spread_length', 1.507, 0.1041),
  ('ceiling', 2, 'spread_width', 1.019, 0.1319),
  ('ceiling', 2, 'tilt_deg', 0.003845, 0.45),
  ('ceiling', 2, 'width', 1.387, 0.12),
  ('ceiling', 2, 'z_max', 2.804, 0.1098),
  ('ceiling', 2, 'z_min', 2.806, 0.1096);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.1615, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'area_m2', 2.058, 0.3069),
  ('ceiling', 3, 'aspect', 0.433, 0.2924),
  ('ceiling', 3, 'behind', 0.0001637, 0.03),
  ('ceiling', 3, 'edge_free', 0.0001549, 0.03),
  ('ceiling', 3, 'edge_free_top', 6.483e-05, 0.3176),
  ('ceiling', 3, 'edge_joined', 0.357, 0.1376),
  ('ceiling', 3, 'edge_unseen', 0.3159, 0.0637),
  ('ceiling', 3, 'height', 2.999, 0.08175),
  ('ceiling', 3, 'length', 1.471, 0.1955),
  ('ceiling', 3, 'rectangularity', 0.653, 0.1225),
  ('ceiling', 3, 'spread_length', 1.353, 0.1432),
  ('ceiling', 3, 'spread_width', 0.7204, 0.2135),
  ('ceiling', 3, 'tilt_deg', 0.009538, 0.45),
  ('ceiling', 3, 'width', 1.031, 0.252),
  ('ceiling', 3, 'z_max', 3.001, 0.08301),
  ('ceiling', 3, 'z_min', 3, 0.0834);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.1109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'area_m2', 2.881, 0.2272),
  ('ceiling', 4, 'aspect', 0.2358, 0.1311),
  ('ceiling', 4, 'behind', 0.0002637, 0.03054),
  ('ceiling', 4, 'edge_free', 0.0002424, 0.03),
  ('ceiling', 4, 'edge_free_top', 0.0001403, 0.3175),
  ('ceiling', 4, 'edge_joined', 0.506, 0.1595),
  ('ceiling', 4, 'edge_unseen', 0.2134, 0.1228),
  ('ceiling', 4, 'height', 2.865, 0.1458),
  ('ceiling', 4, 'length', 1.681, 0.131),
  ('ceiling', 4, 'rectangularity', 0.786, 0.09496),
  ('ceiling', 4, 'spread_length', 1.539, 0.1409),
  ('ceiling', 4, 'spread_width', 1.176, 0.1229),
  ('ceiling', 4, 'tilt_deg', 0.001277, 0.45),
  ('ceiling', 4, 'width', 1.449, 0.1251),
  ('ceiling', 4, 'z_max', 2.866, 0.1484),
  ('ceiling', 4, 'z_min', 2.867, 0.147);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.0694, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'area_m2', -1.894, 1.017),
  ('ceiling', 5, 'aspect', 0.5274, 0.3712),
  ('ceiling', 5, 'behind', 0.0007609, 0.03255),
  ('ceiling', 5, 'edge_free', 0.0004722, 0.03),
  ('ceiling', 5, 'edge_free_top', -0.0009574, 0.3163),
  ('ceiling', 5, 'edge_joined', 0.2739, 0.1654),
  ('ceiling', 5, 'edge_unseen', 0.5558, 0.07289),
  ('ceiling', 5, 'height', 3.163, 0.2534),
  ('ceiling', 5, 'length', -0.4231, 0.5248),
  ('ceiling', 5, 'rectangularity', 0.602, 0.07283),
  ('ceiling', 5, 'spread_length', -0.5053, 0.4954),
  ('ceiling', 5, 'spread_width', -1.161, 0.4904),
  ('ceiling', 5, 'tilt_deg', 0.5622, 0.7636),
  ('ceiling', 5, 'width', -0.905, 0.4704),
  ('ceiling', 5, 'z_max', 3.196, 0.3009),
  ('ceiling', 5, 'z_min', 3.2, 0.2666);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.04053, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'area_m2', -1.089, 0.9192),
  ('ceiling', 6, 'aspect', 0.9258, 0.2618),
  ('ceiling', 6, 'behind', 0.0003101, 0.03035),
  ('ceiling', 6, 'edge_free', 0.0002227, 0.03),
  ('ceiling', 6, 'edge_free_top', -0.0003696, 0.3167),
  ('ceiling', 6, 'edge_joined', 0.2974, 0.1703),
  ('ceiling', 6, 'edge_unseen', 0.08542, 0.1202),
  ('ceiling', 6, 'height', 2.51, 0.03214),
  ('ceiling', 6, 'length', 0.1472, 0.4874),
  ('ceiling', 6, 'rectangularity', 0.6973, 0.08903),
  ('ceiling', 6, 'spread_length', 0.06551, 0.4478),
  ('ceiling', 6, 'spread_width', -0.9455, 0.489),
  ('ceiling', 6, 'tilt_deg', 0.251, 0.5367),
  ('ceiling', 6, 'width', -0.8566, 0.6345),
  ('ceiling', 6, 'z_max', 2.506, 0.0225),
  ('ceiling', 6, 'z_min', 2.508, 0.02375);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.07651, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'area_m2', 2.042, 0.2847),
  ('ceiling', 7, 'aspect', 0.3874, 0.2492),
  ('ceiling', 7, 'behind', 0.0003747, 0.03),
  ('ceiling', 7, 'edge_free', 0.0003626, 0.03),
  ('ceiling', 7, 'edge_free_top', 0.0001282, 0.3166),
  ('ceiling', 7, 'edge_joined', 0.5269, 0.1773),
  ('ceiling', 7, 'edge_unseen', 0.3288, 0.0752),
  ('ceiling', 7, 'height', 2.65, 0.07014),
  ('ceiling', 7, 'length', 1.443, 0.1473),
  ('ceiling', 7, 'rectangularity', 0.6434, 0.1197),
  ('ceiling', 7, 'spread_length', 1.314, 0.122),
  ('ceiling', 7, 'spread_width', 0.7495, 0.1727),
  ('ceiling', 7, 'tilt_deg', 0.01073, 0.45),
  ('ceiling', 7, 'width', 1.057, 0.2117),
  ('ceiling', 7, 'z_max', 2.65, 0.06968),
  ('ceiling', 7, 'z_min', 2.649, 0.07057);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.08526, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'area_m2', 1.637, 1.003),
  ('ceiling', 8, 'aspect', 0.4938, 0.3429),
  ('ceiling', 8, 'behind', 0.0003282, 0.03),
  ('ceiling', 8, 'edge_free', 0.0003673, 0.03),
  ('ceiling', 8, 'edge_free_top', -8.728e-06, 0.3174),
  ('ceiling', 8, 'edge_joined', 0.1604, 0.0787),
  ('ceiling', 8, 'edge_unseen', 0.2807, 0.08636),
  ('ceiling', 8, 'height', 3.537, 0.2018),
  ('ceiling', 8, 'length', 1.307, 0.4582),
  ('ceiling', 8, 'rectangularity', 0.6306, 0.1125),
  ('ceiling', 8, 'spread_length', 1.179, 0.4363),
  ('ceiling', 8, 'spread_width', 0.5151, 0.5872),
  ('ceiling', 8, 'tilt_deg', 0.05236, 0.45),
  ('ceiling', 8, 'width', 0.8045, 0.6339),
  ('ceiling', 8, 'z_max', 3.547, 0.2069),
  ('ceiling', 8, 'z_min', 3.544, 0.2076);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.04625, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'area_m2', 0.1259, 0.8474),
  ('ceiling', 9, 'aspect', 0.9217, 0.5047),
  ('ceiling', 9, 'behind', 0.2501, 0.1782),
  ('ceiling', 9, 'edge_free', 0.1918, 0.1593),
  ('ceiling', 9, 'edge_free_top', -0.0008619, 0.318),
  ('ceiling', 9, 'edge_joined', 0.3743, 0.2291),
  ('ceiling', 9, 'edge_unseen', 0.2491, 0.1283),
  ('ceiling', 9, 'height', 2.727, 0.2519),
  ('ceiling', 9, 'length', 0.71, 0.5058),
  ('ceiling', 9, 'rectangularity', 0.696, 0.08309),
  ('ceiling', 9, 'spread_length', 0.5785, 0.4829),
  ('ceiling', 9, 'spread_width', -0.4618, 0.3768),
  ('ceiling', 9, 'tilt_deg', 0.08578, 0.45),
  ('ceiling', 9, 'width', -0.2227, 0.4296),
  ('ceiling', 9, 'z_max', 2.719, 0.2619),
  ('ceiling', 9, 'z_min', 2.723, 0.2578);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 10, 0.01868, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 10, 'area_m2', 0.9066, 0.519),
  ('ceiling', 10, 'aspect', 0.8069, 0.3729),
  ('ceiling', 10, 'behind', 0.2523, 0.05269),
  ('ceiling', 10, 'edge_free', 0.2968, 0.07532),
  ('ceiling', 10, 'edge_free_top', 0.00014, 0.3164),
  ('ceiling', 10, 'edge_joined', 0.2636, 0.08302),
  ('ceiling', 10, 'edge_unseen', 0.1578, 0.05491),
  ('ceiling', 10, 'height', 3.249, 0.1766),
  ('ceiling', 10, 'length', 0.9488, 0.3552),
  ('ceiling', 10, 'rectangularity', 0.8405, 0.05451),
  ('ceiling', 10, 'spread_length', 0.8426, 0.3168),
  ('ceiling', 10, 'spread_width', 0.03445, 0.2915),
  ('ceiling', 10, 'tilt_deg', 0.03829, 0.45),
  ('ceiling', 10, 'width', 0.1386, 0.3053),
  ('ceiling', 10, 'z_max', 3.25, 0.1787),
  ('ceiling', 10, 'z_min', 3.249, 0.1786);

-- wall: 2606 examples
UPDATE object_class SET prior = 0.1642 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 0.5508, 1.424)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.6595, 0.4893)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.09451, 0.1817)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.1187, 0.2184)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.09604, 0.2348)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_joined', 0.2309, 0.2512)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_unseen', 0.1787, 0.194)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.383, 0.4693)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 0.8326, 0.6625)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.657, 0.1531)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.6605, 0.673)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', -0.07998, 0.8705)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.65, 0.9935)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.1691, 0.8783)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.4, 0.7609)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.27, 0.5228)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'wall';
DELETE FROM class_density WHERE class = 'wall';
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.1652, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'area_m2', 1.982, 0.3839),
  ('wall', 1, 'aspect', 0.538, 0.306),
  ('wall', 1, 'behind', -0.001521, 0.03),
  ('wall', 1, 'edge_free', 0.005195, 0.03),
  ('wall', 1, 'edge_free_top', 0.000386, 0.03),
  ('wall', 1, 'edge_joined', 0.1004, 0.09206),
  ('wall', 1, 'edge_unseen', 0.08195, 0.131),
  ('wall', 1, 'height', 1.568, 0.2196),
  ('wall', 1, 'length', 1.429, 0.2137),
  ('wall', 1, 'rectangularity', 0.6873, 0.1386),
  ('wall', 1, 'spread_length', 1.132, 0.2036),
  ('wall', 1, 'spread_width', 0.7004, 0.1297),
  ('wall', 1, 'tilt_deg', 90.08, 0.45),
  ('wall', 1, 'width', 1.082, 0.07659),
  ('wall', 1, 'z_max', 2.934, 0.3828),
  ('wall', 1, 'z_min', -0.0136, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.08436, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'area_m2', 1.109, 0.4044),
  ('wall', 2, 'aspect', 0.5162, 0.4158),
  ('wall', 2, 'behind', -0.007752, 0.03),
  ('wall', 2, 'edge_free', 0.0129, 0.03545),
  ('wall', 2, 'edge_free_top', 0.0005096, 0.03008),
  ('wall', 2, 'edge_joined', 0.3069, 0.1752),
  ('wall', 2, 'edge_unseen', 0.3292, 0.1132),
  ('wall', 2, 'height', 1.6, 0.2988),
  ('wall', 2, 'length', 1.058, 0.2383),
  ('wall', 2, 'rectangularity', 0.6222, 0.1306),
  ('wall', 2, 'spread_length', 0.7382, 0.2065),
  ('wall', 2, 'spread_width', 0.2114, 0.2771),
  ('wall', 2, 'tilt_deg', 90.15, 0.45),
  ('wall', 2, 'width', 0.563, 0.3108),
  ('wall', 2, 'z_max', 2.736, 0.1559),
  ('wall', 2, 'z_min', 0.3337, 0.3341);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.1389, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'area_m2', -0.007688, 0.5145),
  ('wall', 3, 'aspect', 0.884, 0.4317),
  ('wall', 3, 'behind', -0.0009344, 0.03),
  ('wall', 3, 'edge_free', -0.00176, 0.03474),
  ('wall', 3, 'edge_free_top', -0.004622, 0.03001),
  ('wall', 3, 'edge_joined', 0.173, 0.1782),
  ('wall', 3, 'edge_unseen', 0.4438, 0.1344),
  ('wall', 3, 'height', 1.122, 0.2145),
  ('wall', 3, 'length', 0.6128, 0.3328),
  ('wall', 3, 'rectangularity', 0.6783, 0.08553),
  ('wall', 3, 'spread_length', 0.3594, 0.4448),
  ('wall', 3, 'spread_width', -0.4574, 0.4766),
  ('wall', 3, 'tilt_deg', 87.93, 0.45),
  ('wall', 3, 'width', -0.2262, 0.5652),
  ('wall', 3, 'z_max', 1.763, 0.431),
  ('wall', 3, 'z_min', 0.2354, 0.2326);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.08646, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'area_m2', -1.96, 1.012),
  ('wall', 4, 'aspect', 0.6898, 0.578),
  ('wall', 4, 'behind', -0.01077, 0.03),
  ('wall', 4, 'edge_free', -0.001969, 0.03),
  ('wall', 4, 'edge_free_top', -0.002653, 0.03),
  ('wall', 4, 'edge_joined', 0.09657, 0.2168),
  ('wall', 4, 'edge_unseen', 0.1367, 0.2223),
  ('wall', 4, 'height', 0.5849, 0.4309),
  ('wall', 4, 'length', -0.3218, 0.6218),
  ('wall', 4, 'rectangularity', 0.7646, 0.1785),
  ('wall', 4, 'spread_length', -0.3858, 0.6569),
  ('wall', 4, 'spread_width', -1.355, 0.6085),
  ('wall', 4, 'tilt_deg', 88.75, 1.025),
  ('wall', 4, 'width', -1.159, 0.5669),
  ('wall', 4, 'z_max', 1.036, 0.8862),
  ('wall', 4, 'z_min', -0.03382, 0.1171);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.04937, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'area_m2', 1.835, 0.3234),
  ('wall', 5, 'aspect', 0.4243, 0.2179),
  ('wall', 5, 'behind', 0.1544, 0.1273),
  ('wall', 5, 'edge_free', 0.1376, 0.08346),
  ('wall', 5, 'edge_free_top', 0.08206, 0.114),
  ('wall', 5, 'edge_joined', 0.1066, 0.1073),
  ('wall', 5, 'edge_unseen', 0.1054, 0.1262),
  ('wall', 5, 'height', 1.544, 0.2055),
  ('wall', 5, 'length', 1.4, 0.2054),
  ('wall', 5, 'rectangularity', 0.5351, 0.1181),
  ('wall', 5, 'spread_length', 1.279, 0.21),
  ('wall', 5, 'spread_width', 0.8276, 0.1482),
  ('wall', 5, 'tilt_deg', 90.02, 0.45),
  ('wall', 5, 'width', 1.028, 0.09147),
  ('wall', 5, 'z_max', 2.828, 0.2777),
  ('wall', 5, 'z_min', -0.01439, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.09969, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'area_m2', 0.1795, 0.3818),
  ('wall', 6, 'aspect', 1.401, 0.3395),
  ('wall', 6, 'behind', 0.2125, 0.2001),
  ('wall', 6, 'edge_free', 0.4107, 0.3804),
  ('wall', 6, 'edge_free_top', 0.07712, 0.1141),
  ('wall', 6, 'edge_joined', 0.1828, 0.2145),
  ('wall', 6, 'edge_unseen', 0.01129, 0.03),
  ('wall', 6, 'height', 1.454, 0.1439),
  ('wall', 6, 'length', 0.9797, 0.1469),
  ('wall', 6, 'rectangularity', 0.7961, 0.1468),
  ('wall', 6, 'spread_length', 0.8078, 0.2101),
  ('wall', 6, 'spread_width', -0.8268, 0.3309),
  ('wall', 6, 'tilt_deg', 90.05, 0.45),
  ('wall', 6, 'width', -0.4373, 0.3678),
  ('wall', 6, 'z_max', 2.866, 0.2894),
  ('wall', 6, 'z_min', 0.1087, 0.2467);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.06147, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'area_m2', 0.8042, 0.401),
  ('wall', 7, 'aspect', 0.2576, 0.1947),
  ('wall', 7, 'behind', 0.3699, 0.1402),
  ('wall', 7, 'edge_free', 0.4329, 0.2561),
  ('wall', 7, 'edge_free_top', 0.5633, 0.3738),
  ('wall', 7, 'edge_joined', 0.2498, 0.2372),
  ('wall', 7, 'edge_unseen', 0.1721, 0.1577),
  ('wall', 7, 'height', 1.225, 0.3325),
  ('wall', 7, 'length', 0.9239, 0.2433),
  ('wall', 7, 'rectangularity', 0.7055, 0.2067),
  ('wall', 7, 'spread_length', 0.6292, 0.2297),
  ('wall', 7, 'spread_width', 0.1218, 0.2921),
  ('wall', 7, 'tilt_deg', 90.01, 0.45),
  ('wall', 7, 'width', 0.4574, 0.1133),
  ('wall', 7, 'z_max', 2.221, 0.8996),
  ('wall', 7, 'z_min', 0.009587, 0.1717);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.1736, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'area_m2', -0.6499, 0.7667),
  ('wall', 8, 'aspect', 0.769, 0.3344),
  ('wall', 8, 'behind', 0.1775, 0.21),
  ('wall', 8, 'edge_free', 0.08516, 0.1233),
  ('wall', 8, 'edge_free_top', 0.004667, 0.03),
  ('wall', 8, 'edge_joined', 0.3636, 0.3212),
  ('wall', 8, 'edge_unseen', 0.195, 0.2628),
  ('wall', 8, 'height', 2.162, 0.4137),
  ('wall', 8, 'length', 0.2578, 0.4126),
  ('wall', 8, 'rectangularity', 0.6713, 0.1152),
  ('wall', 8, 'spread_length', -0.06952, 0.5628),
  ('wall', 8, 'spread_width', -0.7581, 0.3679),
  ('wall', 8, 'tilt_deg', 89.97, 0.45),
  ('wall', 8, 'width', -0.5557, 0.5028),
  ('wall', 8, 'z_max', 2.847, 0.2073),
  ('wall', 8, 'z_min', 1.436, 0.6124);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.03491, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'area_m2', -1.674, 0.8246),
  ('wall', 9, 'aspect', 1.137, 0.2969),
  ('wall', 9, 'behind', 0.2623, 0.1707),
  ('wall', 9, 'edge_free', 0.4121, 0.3688),
  ('wall', 9, 'edge_free_top', 0.3342, 0.3141),
  ('wall', 9, 'edge_joined', 0.2037, 0.2815),
  ('wall', 9, 'edge_unseen', 0.3, 0.2621),
  ('wall', 9, 'height', 0.9693, 0.6952),
  ('wall', 9, 'length', -0.1949, 0.525),
  ('wall', 9, 'rectangularity', 0.7295, 0.1083),
  ('wall', 9, 'spread_length', -0.5507, 0.451),
  ('wall', 9, 'spread_width', -1.354, 0.3253),
  ('wall', 9, 'tilt_deg', 89.43, 0.8192),
  ('wall', 9, 'width', -1.105, 0.4802),
  ('wall', 9, 'z_max', 1.579, 0.9404),
  ('wall', 9, 'z_min', 0.3148, 0.3669);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.05603, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'area_m2', -0.1994, 0.4679),
  ('wall', 10, 'aspect', 0.9887, 0.2764),
  ('wall', 10, 'behind', 0.1836, 0.1884),
  ('wall', 10, 'edge_free', 0.5461, 0.2992),
  ('wall', 10, 'edge_free_top', 0.6546, 0.4535),
  ('wall', 10, 'edge_joined', 0.06197, 0.1099),
  ('wall', 10, 'edge_unseen', 0.346, 0.2092),
  ('wall', 10, 'height', 1.046, 0.3526),
  ('wall', 10, 'length', 0.5112, 0.2968),
  ('wall', 10, 'rectangularity', 0.6536, 0.2305),
  ('wall', 10, 'spread_length', 0.1482, 0.4216),
  ('wall', 10, 'spread_width', -0.708, 0.2642),
  ('wall', 10, 'tilt_deg', 87.62, 8.113),
  ('wall', 10, 'width', -0.3556, 0.3585),
  ('wall', 10, 'z_max', 1.752, 0.3155),
  ('wall', 10, 'z_min', 0.1993, 0.3587);

-- table: 770 examples
UPDATE object_class SET prior = 0.03096 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.2835, 0.6143)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5536, 0.2717)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5326, 0.2083)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.433, 0.2217)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_joined', 0.3102, 0.2098)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_unseen', 0.109, 0.1467)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7303, 0.1187)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.3211, 0.3151)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.7045, 0.1301)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1778, 0.3229)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4221, 0.3388)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.3761, 0.5625)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2361, 0.3222)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7341, 0.1181)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.727, 0.1192)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'table';
DELETE FROM class_density WHERE class = 'table';
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.1373, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'area_m2', 0.1391, 0.1939),
  ('table', 1, 'aspect', 0.6053, 0.1502),
  ('table', 1, 'behind', 0.5342, 0.1624),
  ('table', 1, 'edge_free', 0.5303, 0.1973),
  ('table', 1, 'edge_free_top', -0.0007446, 0.3152),
  ('table', 1, 'edge_joined', 0.2555, 0.163),
  ('table', 1, 'edge_unseen', 0.08052, 0.109),
  ('table', 1, 'height', 0.7035, 0.02255),
  ('table', 1, 'length', 0.5234, 0.1206),
  ('table', 1, 'rectangularity', 0.7471, 0.1246),
  ('table', 1, 'spread_length', 0.4032, 0.1135),
  ('table', 1, 'spread_width', -0.2512, 0.1182),
  ('table', 1, 'tilt_deg', 0.1619, 0.45),
  ('table', 1, 'width', -0.09147, 0.1385),
  ('table', 1, 'z_max', 0.7042, 0.0225),
  ('table', 1, 'z_min', 0.7007, 0.02309);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.09614, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'area_m2', 0.09538, 0.2043),
  ('table', 2, 'aspect', 0.5375, 0.162),
  ('table', 2, 'behind', 0.7102, 0.05031),
  ('table', 2, 'edge_free', 0.3809, 0.2045),
  ('table', 2, 'edge_free_top', -0.0006175, 0.3155),
  ('table', 2, 'edge_joined', 0.3766, 0.1531),
  ('table', 2, 'edge_unseen', 0.007059, 0.03347),
  ('table', 2, 'height', 0.7433, 0.02335),
  ('table', 2, 'length', 0.505, 0.1425),
  ('table', 2, 'rectangularity', 0.7111, 0.07348),
  ('table', 2, 'spread_length', 0.358, 0.1128),
  ('table', 2, 'spread_width', -0.2483, 0.1236),
  ('table', 2, 'tilt_deg', 0.08403, 0.45),
  ('table', 2, 'width', -0.06171, 0.1387),
  ('table', 2, 'z_max', 0.7431, 0.0225),
  ('table', 2, 'z_min', 0.742, 0.02444);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.1211, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'area_m2', -0.05224, 0.393),
  ('table', 3, 'aspect', 0.6428, 0.2514),
  ('table', 3, 'behind', 0.4548, 0.1136),
  ('table', 3, 'edge_free', 0.5328, 0.2581),
  ('table', 3, 'edge_free_top', -0.001119, 0.3144),
  ('table', 3, 'edge_joined', 0.2161, 0.1629),
  ('table', 3, 'edge_unseen', 0.1483, 0.1407),
  ('table', 3, 'height', 0.7679, 0.0225),
  ('table', 3, 'length', 0.5156, 0.2295),
  ('table', 3, 'rectangularity', 0.7071, 0.1629),
  ('table', 3, 'spread_length', 0.3198, 0.1835),
  ('table', 3, 'spread_width', -0.3743, 0.2276),
  ('table', 3, 'tilt_deg', 0.2212, 0.45),
  ('table', 3, 'width', -0.1857, 0.1916),
  ('table', 3, 'z_max', 0.7725, 0.02441),
  ('table', 3, 'z_min', 0.7653, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.1228, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'area_m2', -0.4015, 0.2195),
  ('table', 4, 'aspect', 0.2766, 0.1684),
  ('table', 4, 'behind', 0.5548, 0.2558),
  ('table', 4, 'edge_free', 0.3654, 0.2459),
  ('table', 4, 'edge_free_top', -0.00138, 0.3141),
  ('table', 4, 'edge_joined', 0.3248, 0.2039),
  ('table', 4, 'edge_unseen', 0.1195, 0.1471),
  ('table', 4, 'height', 0.7332, 0.02902),
  ('table', 4, 'length', 0.1601, 0.1524),
  ('table', 4, 'rectangularity', 0.6757, 0.1388),
  ('table', 4, 'spread_length', 0.007666, 0.1541),
  ('table', 4, 'spread_width', -0.3716, 0.09568),
  ('table', 4, 'tilt_deg', 0.1953, 0.45),
  ('table', 4, 'width', -0.1446, 0.09482),
  ('table', 4, 'z_max', 0.7371, 0.03288),
  ('table', 4, 'z_min', 0.734, 0.03142);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.1023, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'area_m2', -0.9097, 0.239),
  ('table', 5, 'aspect', 0.3681, 0.1924),
  ('table', 5, 'behind', 0.3503, 0.168),
  ('table', 5, 'edge_free', 0.5116, 0.2203),
  ('table', 5, 'edge_free_top', -0.001833, 0.3133),
  ('table', 5, 'edge_joined', 0.2359, 0.1711),
  ('table', 5, 'edge_unseen', 0.09649, 0.1413),
  ('table', 5, 'height', 0.6904, 0.02456),
  ('table', 5, 'length', -0.1008, 0.1504),
  ('table', 5, 'rectangularity', 0.7142, 0.1368),
  ('table', 5, 'spread_length', -0.2177, 0.132),
  ('table', 5, 'spread_width', -0.6553, 0.1467),
  ('table', 5, 'tilt_deg', 0.3209, 0.45),
  ('table', 5, 'width', -0.4685, 0.1394),
  ('table', 5, 'z_max', 0.6915, 0.02252),
  ('table', 5, 'z_min', 0.6869, 0.02541);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.08566, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'area_m2', -0.1466, 0.3101),
  ('table', 6, 'aspect', 0.6085, 0.265),
  ('table', 6, 'behind', 0.5532, 0.1616),
  ('table', 6, 'edge_free', 0.4399, 0.1972),
  ('table', 6, 'edge_free_top', -0.000703, 0.3155),
  ('table', 6, 'edge_joined', 0.2507, 0.1612),
  ('table', 6, 'edge_unseen', 0.0686, 0.1075),
  ('table', 6, 'height', 0.6517, 0.02504),
  ('table', 6, 'length', 0.4304, 0.2156),
  ('table', 6, 'rectangularity', 0.6999, 0.1385),
  ('table', 6, 'spread_length', 0.2895, 0.2451),
  ('table', 6, 'spread_width', -0.3347, 0.1709),
  ('table', 6, 'tilt_deg', 0.5821, 0.6489),
  ('table', 6, 'width', -0.1976, 0.1471),
  ('table', 6, 'z_max', 0.6575, 0.02441),
  ('table', 6, 'z_min', 0.6433, 0.02508);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.1087, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'area_m2', -0.055, 0.313),
  ('table', 7, 'aspect', 0.492, 0.1859),
  ('table', 7, 'behind', 0.4985, 0.1884),
  ('table', 7, 'edge_free', 0.2623, 0.1701),
  ('table', 7, 'edge_free_top', -0.003291, 0.3127),
  ('table', 7, 'edge_joined', 0.5065, 0.2068),
  ('table', 7, 'edge_unseen', 0.1233, 0.1061),
  ('table', 7, 'height', 0.9519, 0.1362),
  ('table', 7, 'length', 0.4098, 0.2107),
  ('table', 7, 'rectangularity', 0.7171, 0.1422),
  ('table', 7, 'spread_length', 0.2548, 0.2241),
  ('table', 7, 'spread_width', -0.2499, 0.1462),
  ('table', 7, 'tilt_deg', 0.4527, 0.5331),
  ('table', 7, 'width', -0.103, 0.1197),
  ('table', 7, 'z_max', 0.9652, 0.1403),
  ('table', 7, 'z_min', 0.9508, 0.1485);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.07593, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'area_m2', -1.161, 0.329),
  ('table', 8, 'aspect', 0.5056, 0.2731),
  ('table', 8, 'behind', 0.228, 0.1545),
  ('table', 8, 'edge_free', 0.3467, 0.2892),
  ('table', 8, 'edge_free_top', -0.004933, 0.3118),
  ('table', 8, 'edge_joined', 0.3761, 0.229),
  ('table', 8, 'edge_unseen', 0.2482, 0.1465),
  ('table', 8, 'height', 0.808, 0.1283),
  ('table', 8, 'length', -0.09444, 0.2236),
  ('table', 8, 'rectangularity', 0.6205, 0.1451),
  ('table', 8, 'spread_length', -0.1972, 0.2348),
  ('table', 8, 'spread_width', -0.8225, 0.1901),
  ('table', 8, 'tilt_deg', 0.6924, 0.8962),
  ('table', 8, 'width', -0.5653, 0.1764),
  ('table', 8, 'z_max', 0.8143, 0.1294),
  ('table', 8, 'z_min', 0.8153, 0.1357);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.07607, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'area_m2', -1.857, 0.7311),
  ('table', 9, 'aspect', 0.9718, 0.2693),
  ('table', 9, 'behind', 0.2717, 0.2358),
  ('table', 9, 'edge_free', 0.5153, 0.2719),
  ('table', 9, 'edge_free_top', -0.002803, 0.313),
  ('table', 9, 'edge_joined', 0.1876, 0.1606),
  ('table', 9, 'edge_unseen', 0.3733, 0.1042),
  ('table', 9, 'height', 0.7195, 0.05452),
  ('table', 9, 'length', -0.2329, 0.4361),
  ('table', 9, 'rectangularity', 0.628, 0.07133),
  ('table', 9, 'spread_length', -0.3942, 0.4716),
  ('table', 9, 'spread_width', -1.365, 0.2716),
  ('table', 9, 'tilt_deg', 1.035, 1.275),
  ('table', 9, 'width', -1.193, 0.3729),
  ('table', 9, 'z_max', 0.7194, 0.05619),
  ('table', 9, 'z_min', 0.7132, 0.05668);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.02393, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'area_m2', -0.7125, 0.6523),
  ('table', 10, 'aspect', 0.5194, 0.1525),
  ('table', 10, 'behind', 0.2167, 0.1385),
  ('table', 10, 'edge_free', 0.2766, 0.1166),
  ('table', 10, 'edge_free_top', -0.0003679, 0.3159),
  ('table', 10, 'edge_joined', 0.1913, 0.1713),
  ('table', 10, 'edge_unseen', 0.2002, 0.113),
  ('table', 10, 'height', 0.05028, 0.05531),
  ('table', 10, 'length', 0.1476, 0.3165),
  ('table', 10, 'rectangularity', 0.6142, 0.08384),
  ('table', 10, 'spread_length', 0.0228, 0.3222),
  ('table', 10, 'spread_width', -0.6062, 0.3456),
  ('table', 10, 'tilt_deg', 1.316, 0.4826),
  ('table', 10, 'width', -0.321, 0.2734),
  ('table', 10, 'z_max', 0.04229, 0.04413),
  ('table', 10, 'z_min', 0.02402, 0.04459);

-- flat_screen: 604 examples
UPDATE object_class SET prior = 0.03742 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.865, 0.3927)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.3801, 0.2017)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5884, 0.1355)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.7792, 0.1705)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.9768, 0.06977)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_joined', 0.07045, 0.1069)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_unseen', 0.05771, 0.1128)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.018, 0.09436)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.627, 0.2497)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.803, 0.1137)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7733, 0.2061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.212, 0.1909)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.21, 3.253)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -1.008, 0.2216)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.174, 0.1046)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7855, 0.1215)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'flat_screen';
DELETE FROM class_density WHERE class = 'flat_screen';
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.1517, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'area_m2', -1.595, 0.1075),
  ('flat_screen', 1, 'aspect', 0.3365, 0.1033),
  ('flat_screen', 1, 'behind', 0.5572, 0.1113),
  ('flat_screen', 1, 'edge_free', 0.7482, 0.08646),
  ('flat_screen', 1, 'edge_free_top', 0.9961, 0.03),
  ('flat_screen', 1, 'edge_joined', 0.07281, 0.05477),
  ('flat_screen', 1, 'edge_unseen', 0.005607, 0.03145),
  ('flat_screen', 1, 'height', 1.007, 0.04781),
  ('flat_screen', 1, 'length', -0.5494, 0.09321),
  ('flat_screen', 1, 'rectangularity', 0.8232, 0.06136),
  ('flat_screen', 1, 'spread_length', -0.6248, 0.06776),
  ('flat_screen', 1, 'spread_width', -1.09, 0.05394),
  ('flat_screen', 1, 'tilt_deg', 85.55, 2.651),
  ('flat_screen', 1, 'width', -0.8535, 0.07464),
  ('flat_screen', 1, 'z_max', 1.154, 0.06379),
  ('flat_screen', 1, 'z_min', 0.7381, 0.04851);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.1783, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'area_m2', -1.416, 0.1799),
  ('flat_screen', 2, 'aspect', 0.5602, 0.1708),
  ('flat_screen', 2, 'behind', 0.6393, 0.06802),
  ('flat_screen', 2, 'edge_free', 0.6049, 0.0974),
  ('flat_screen', 2, 'edge_free_top', 0.9246, 0.1126),
  ('flat_screen', 2, 'edge_joined', 0.1864, 0.1604),
  ('flat_screen', 2, 'edge_unseen', 0.01849, 0.04218),
  ('flat_screen', 2, 'height', 0.9785, 0.05191),
  ('flat_screen', 2, 'length', -0.2846, 0.124),
  ('flat_screen', 2, 'rectangularity', 0.6892, 0.0644),
  ('flat_screen', 2, 'spread_length', -0.5257, 0.1531),
  ('flat_screen', 2, 'spread_width', -1.085, 0.09538),
  ('flat_screen', 2, 'tilt_deg', 84.01, 2.338),
  ('flat_screen', 2, 'width', -0.7868, 0.1319),
  ('flat_screen', 2, 'z_max', 1.154, 0.09318),
  ('flat_screen', 2, 'z_min', 0.6992, 0.048);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.1145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'area_m2', -1.924, 0.1702),
  ('flat_screen', 3, 'aspect', 0.387, 0.1694),
  ('flat_screen', 3, 'behind', 0.5778, 0.1145),
  ('flat_screen', 3, 'edge_free', 0.7226, 0.111),
  ('flat_screen', 3, 'edge_free_top', 0.9981, 0.03),
  ('flat_screen', 3, 'edge_joined', 0.0615, 0.0553),
  ('flat_screen', 3, 'edge_unseen', 0.09895, 0.1256),
  ('flat_screen', 3, 'height', 1.017, 0.03754),
  ('flat_screen', 3, 'length', -0.6167, 0.1512),
  ('flat_screen', 3, 'rectangularity', 0.7105, 0.09116),
  ('flat_screen', 3, 'spread_length', -0.8484, 0.1553),
  ('flat_screen', 3, 'spread_width', -1.255, 0.07249),
  ('flat_screen', 3, 'tilt_deg', 84.23, 1.791),
  ('flat_screen', 3, 'width', -0.9661, 0.08399),
  ('flat_screen', 3, 'z_max', 1.145, 0.0444),
  ('flat_screen', 3, 'z_min', 0.7604, 0.04543);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.1108, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'area_m2', -2.043, 0.1338),
  ('flat_screen', 4, 'aspect', 0.1634, 0.1213),
  ('flat_screen', 4, 'behind', 0.6652, 0.04112),
  ('flat_screen', 4, 'edge_free', 0.7726, 0.07456),
  ('flat_screen', 4, 'edge_free_top', 1, 0.03),
  ('flat_screen', 4, 'edge_joined', 0.05279, 0.0413),
  ('flat_screen', 4, 'edge_unseen', 0.003197, 0.03),
  ('flat_screen', 4, 'height', 0.9826, 0.0469),
  ('flat_screen', 4, 'length', -0.8436, 0.1145),
  ('flat_screen', 4, 'rectangularity', 0.8215, 0.05001),
  ('flat_screen', 4, 'spread_length', -0.93, 0.08419),
  ('flat_screen', 4, 'spread_width', -1.25, 0.06068),
  ('flat_screen', 4, 'tilt_deg', 84.57, 2.201),
  ('flat_screen', 4, 'width', -1.001, 0.04509),
  ('flat_screen', 4, 'z_max', 1.103, 0.05964),
  ('flat_screen', 4, 'z_min', 0.7338, 0.05758);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.09936, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'area_m2', -1.78, 0.134),
  ('flat_screen', 5, 'aspect', 0.5012, 0.0473),
  ('flat_screen', 5, 'behind', 0.5801, 0.103),
  ('flat_screen', 5, 'edge_free', 0.9839, 0.03),
  ('flat_screen', 5, 'edge_free_top', 0.9986, 0.03),
  ('flat_screen', 5, 'edge_joined', 0.003426, 0.03),
  ('flat_screen', 5, 'edge_unseen', 0.03874, 0.07662),
  ('flat_screen', 5, 'height', 1.029, 0.04193),
  ('flat_screen', 5, 'length', -0.6045, 0.0712),
  ('flat_screen', 5, 'rectangularity', 0.9323, 0.03163),
  ('flat_screen', 5, 'spread_length', -0.6496, 0.06946),
  ('flat_screen', 5, 'spread_width', -1.149, 0.07997),
  ('flat_screen', 5, 'tilt_deg', 85.3, 3.059),
  ('flat_screen', 5, 'width', -1.105, 0.07232),
  ('flat_screen', 5, 'z_max', 1.185, 0.04497),
  ('flat_screen', 5, 'z_min', 0.8517, 0.04174);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.07869, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'area_m2', -2.232, 0.1379),
  ('flat_screen', 6, 'aspect', 0.3507, 0.1195),
  ('flat_screen', 6, 'behind', 0.5801, 0.07728),
  ('flat_screen', 6, 'edge_free', 0.9906, 0.03),
  ('flat_screen', 6, 'edge_free_top', 0.9976, 0.03),
  ('flat_screen', 6, 'edge_joined', 0.004166, 0.03),
  ('flat_screen', 6, 'edge_unseen', 0.07301, 0.1067),
  ('flat_screen', 6, 'height', 1.012, 0.05382),
  ('flat_screen', 6, 'length', -0.8989, 0.11),
  ('flat_screen', 6, 'rectangularity', 0.911, 0.05952),
  ('flat_screen', 6, 'spread_length', -0.9491, 0.1013),
  ('flat_screen', 6, 'spread_width', -1.3, 0.05734),
  ('flat_screen', 6, 'tilt_deg', 84, 2.802),
  ('flat_screen', 6, 'width', -1.243, 0.08916),
  ('flat_screen', 6, 'z_max', 1.147, 0.05866),
  ('flat_screen', 6, 'z_min', 0.8556, 0.04267);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.09728, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'area_m2', -1.83, 0.2628),
  ('flat_screen', 7, 'aspect', 0.3915, 0.2273),
  ('flat_screen', 7, 'behind', 0.4912, 0.08699),
  ('flat_screen', 7, 'edge_free', 0.8401, 0.1492),
  ('flat_screen', 7, 'edge_free_top', 0.9985, 0.03),
  ('flat_screen', 7, 'edge_joined', 0.03776, 0.05145),
  ('flat_screen', 7, 'edge_unseen', 0.1052, 0.1555),
  ('flat_screen', 7, 'height', 1.249, 0.1131),
  ('flat_screen', 7, 'length', -0.6288, 0.2122),
  ('flat_screen', 7, 'rectangularity', 0.8276, 0.1323),
  ('flat_screen', 7, 'spread_length', -0.6844, 0.1331),
  ('flat_screen', 7, 'spread_width', -1.145, 0.09239),
  ('flat_screen', 7, 'tilt_deg', 83.12, 2.118),
  ('flat_screen', 7, 'width', -1.012, 0.1978),
  ('flat_screen', 7, 'z_max', 1.403, 0.09695),
  ('flat_screen', 7, 'z_min', 1.062, 0.1249);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.0438, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'area_m2', -2.7, 0.4477),
  ('flat_screen', 8, 'aspect', 0.5921, 0.2828),
  ('flat_screen', 8, 'behind', 0.5274, 0.2403),
  ('flat_screen', 8, 'edge_free', 0.8506, 0.1647),
  ('flat_screen', 8, 'edge_free_top', 0.9996, 0.03),
  ('flat_screen', 8, 'edge_joined', 0.0221, 0.03439),
  ('flat_screen', 8, 'edge_unseen', 0.2916, 0.09092),
  ('flat_screen', 8, 'height', 1.035, 0.08642),
  ('flat_screen', 8, 'length', -0.9186, 0.2819),
  ('flat_screen', 8, 'rectangularity', 0.7431, 0.09148),
  ('flat_screen', 8, 'spread_length', -1.039, 0.2283),
  ('flat_screen', 8, 'spread_width', -1.73, 0.2874),
  ('flat_screen', 8, 'tilt_deg', 83.61, 1.848),
  ('flat_screen', 8, 'width', -1.472, 0.2983),
  ('flat_screen', 8, 'z_max', 1.13, 0.06152),
  ('flat_screen', 8, 'z_min', 0.842, 0.07211);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.05367, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'area_m2', -1.965, 0.4006),
  ('flat_screen', 9, 'aspect', 0.4977, 0.2573),
  ('flat_screen', 9, 'behind', 0.5493, 0.08577),
  ('flat_screen', 9, 'edge_free', 0.5208, 0.1292),
  ('flat_screen', 9, 'edge_free_top', 0.8019, 0.1299),
  ('flat_screen', 9, 'edge_joined', 0.2293, 0.2323),
  ('flat_screen', 9, 'edge_unseen', 0.07069, 0.1156),
  ('flat_screen', 9, 'height', 1.004, 0.06088),
  ('flat_screen', 9, 'length', -0.6178, 0.1951),
  ('flat_screen', 9, 'rectangularity', 0.7164, 0.1056),
  ('flat_screen', 9, 'spread_length', -0.8531, 0.15),
  ('flat_screen', 9, 'spread_width', -1.285, 0.1916),
  ('flat_screen', 9, 'tilt_deg', 84.12, 1.787),
  ('flat_screen', 9, 'width', -1.029, 0.3357),
  ('flat_screen', 9, 'z_max', 1.162, 0.1047),
  ('flat_screen', 9, 'z_min', 0.7805, 0.06641);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.02196, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'area_m2', -1.562, 0.5248),
  ('flat_screen', 10, 'aspect', 0.6771, 0.1282),
  ('flat_screen', 10, 'behind', 0.644, 0.1246),
  ('flat_screen', 10, 'edge_free', 0.6248, 0.1363),
  ('flat_screen', 10, 'edge_free_top', 0.9026, 0.1797),
  ('flat_screen', 10, 'edge_joined', 0.1413, 0.1343),
  ('flat_screen', 10, 'edge_unseen', 0.006327, 0.03),
  ('flat_screen', 10, 'height', 0.7977, 0.3456),
  ('flat_screen', 10, 'length', -0.2561, 0.3629),
  ('flat_screen', 10, 'rectangularity', 0.6632, 0.2491),
  ('flat_screen', 10, 'spread_length', -0.433, 0.3361),
  ('flat_screen', 10, 'spread_width', -1.109, 0.3249),
  ('flat_screen', 10, 'tilt_deg', 84.77, 2.014),
  ('flat_screen', 10, 'width', -0.864, 0.4615),
  ('flat_screen', 10, 'z_max', 1.045, 0.6429),
  ('flat_screen', 10, 'z_min', 0.4217, 0.3496);

-- keyboard: 411 examples
UPDATE object_class SET prior = 0.06116 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.797, 0.4337)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.752, 0.3045)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.2451, 0.1626)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.2511, 0.2088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_joined', 0.6948, 0.2264)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_unseen', 0.04497, 0.1061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7611, 0.1205)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.9149, 0.3029)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8118, 0.08244)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -1.002, 0.299)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.842, 0.1514)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.312, 2.026)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.668, 0.2251)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7675, 0.1206)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.755, 0.1207)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'keyboard';
DELETE FROM class_density WHERE class = 'keyboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1393, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'area_m2', -2.315, 0.1292),
  ('keyboard', 1, 'aspect', 0.7414, 0.1708),
  ('keyboard', 1, 'behind', 0.2642, 0.09258),
  ('keyboard', 1, 'edge_free', 0.2611, 0.1427),
  ('keyboard', 1, 'edge_free_top', -0.002183, 0.3142),
  ('keyboard', 1, 'edge_joined', 0.7451, 0.1646),
  ('keyboard', 1, 'edge_unseen', 0.002957, 0.03),
  ('keyboard', 1, 'height', 0.7435, 0.04211),
  ('keyboard', 1, 'length', -0.648, 0.1196),
  ('keyboard', 1, 'rectangularity', 0.7456, 0.04387),
  ('keyboard', 1, 'spread_length', -0.7755, 0.0843),
  ('keyboard', 1, 'spread_width', -1.74, 0.06622),
  ('keyboard', 1, 'tilt_deg', 3.255, 0.9994),
  ('keyboard', 1, 'width', -1.363, 0.0973),
  ('keyboard', 1, 'z_max', 0.7474, 0.04171),
  ('keyboard', 1, 'z_min', 0.7352, 0.04731);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.1335, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'area_m2', -2.84, 0.2183),
  ('keyboard', 2, 'aspect', 0.5647, 0.2671),
  ('keyboard', 2, 'behind', 0.2203, 0.09388),
  ('keyboard', 2, 'edge_free', 0.3321, 0.1066),
  ('keyboard', 2, 'edge_free_top', -0.004618, 0.3112),
  ('keyboard', 2, 'edge_joined', 0.6183, 0.1401),
  ('keyboard', 2, 'edge_unseen', 0.07345, 0.12),
  ('keyboard', 2, 'height', 0.7524, 0.04245),
  ('keyboard', 2, 'length', -1.017, 0.1544),
  ('keyboard', 2, 'rectangularity', 0.7809, 0.06259),
  ('keyboard', 2, 'spread_length', -1.123, 0.1039),
  ('keyboard', 2, 'spread_width', -1.811, 0.0817),
  ('keyboard', 2, 'tilt_deg', 4.905, 1.132),
  ('keyboard', 2, 'width', -1.533, 0.2097),
  ('keyboard', 2, 'z_max', 0.7636, 0.03369),
  ('keyboard', 2, 'z_min', 0.751, 0.05196);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.1145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'area_m2', -2.618, 0.0867),
  ('keyboard', 3, 'aspect', 0.9866, 0.1177),
  ('keyboard', 3, 'behind', 0.2606, 0.1258),
  ('keyboard', 3, 'edge_free', 0.09792, 0.08732),
  ('keyboard', 3, 'edge_free_top', -0.001128, 0.315),
  ('keyboard', 3, 'edge_joined', 0.863, 0.1122),
  ('keyboard', 3, 'edge_unseen', 0.005091, 0.03221),
  ('keyboard', 3, 'height', 0.7602, 0.0316),
  ('keyboard', 3, 'length', -0.7263, 0.09737),
  ('keyboard', 3, 'rectangularity', 0.8345, 0.06526),
  ('keyboard', 3, 'spread_length', -0.8063, 0.05674),
  ('keyboard', 3, 'spread_width', -1.843, 0.07909),
  ('keyboard', 3, 'tilt_deg', 2.397, 1.096),
  ('keyboard', 3, 'width', -1.701, 0.07078),
  ('keyboard', 3, 'z_max', 0.7649, 0.03063),
  ('keyboard', 3, 'z_min', 0.7583, 0.03304);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.137, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'area_m2', -2.594, 0.08716),
  ('keyboard', 4, 'aspect', 0.8572, 0.07791),
  ('keyboard', 4, 'behind', 0.2166, 0.1153),
  ('keyboard', 4, 'edge_free', 0.4613, 0.09325),
  ('keyboard', 4, 'edge_free_top', -0.002728, 0.3102),
  ('keyboard', 4, 'edge_joined', 0.4987, 0.09259),
  ('keyboard', 4, 'edge_unseen', 0.001448, 0.03023),
  ('keyboard', 4, 'height', 0.7513, 0.04984),
  ('keyboard', 4, 'length', -0.783, 0.06309),
  ('keyboard', 4, 'rectangularity', 0.8435, 0.05371),
  ('keyboard', 4, 'spread_length', -0.8399, 0.04833),
  ('keyboard', 4, 'spread_width', -1.777, 0.0689),
  ('keyboard', 4, 'tilt_deg', 4.776, 1.337),
  ('keyboard', 4, 'width', -1.637, 0.05963),
  ('keyboard', 4, 'z_max', 0.7593, 0.05047),
  ('keyboard', 4, 'z_min', 0.7449, 0.05455);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.138, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'area_m2', -2.759, 0.1052),
  ('keyboard', 5, 'aspect', 1.088, 0.08012),
  ('keyboard', 5, 'behind', 0.2101, 0.1213),
  ('keyboard', 5, 'edge_free', 0.359, 0.1681),
  ('keyboard', 5, 'edge_free_top', -0.001873, 0.3136),
  ('keyboard', 5, 'edge_joined', 0.6162, 0.1599),
  ('keyboard', 5, 'edge_unseen', 0.004792, 0.03),
  ('keyboard', 5, 'height', 0.7606, 0.06043),
  ('keyboard', 5, 'length', -0.771, 0.08567),
  ('keyboard', 5, 'rectangularity', 0.8939, 0.04199),
  ('keyboard', 5, 'spread_length', -0.8225, 0.0613),
  ('keyboard', 5, 'spread_width', -1.91, 0.05581),
  ('keyboard', 5, 'tilt_deg', 4.624, 1.668),
  ('keyboard', 5, 'width', -1.865, 0.0629),
  ('keyboard', 5, 'z_max', 0.7686, 0.05938),
  ('keyboard', 5, 'z_min', 0.7556, 0.06045);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.07721, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'area_m2', -3.42, 0.2211),
  ('keyboard', 6, 'aspect', 0.2856, 0.185),
  ('keyboard', 6, 'behind', 0.2924, 0.1197),
  ('keyboard', 6, 'edge_free', 0.1857, 0.1345),
  ('keyboard', 6, 'edge_free_top', -0.004144, 0.3107),
  ('keyboard', 6, 'edge_joined', 0.7008, 0.1944),
  ('keyboard', 6, 'edge_unseen', 0.2071, 0.129),
  ('keyboard', 6, 'height', 0.7578, 0.0352),
  ('keyboard', 6, 'length', -1.449, 0.167),
  ('keyboard', 6, 'rectangularity', 0.766, 0.05492),
  ('keyboard', 6, 'spread_length', -1.562, 0.08181),
  ('keyboard', 6, 'spread_width', -1.933, 0.08827),
  ('keyboard', 6, 'tilt_deg', 4.006, 1.011),
  ('keyboard', 6, 'width', -1.717, 0.0884),
  ('keyboard', 6, 'z_max', 0.7652, 0.02807),
  ('keyboard', 6, 'z_min', 0.7548, 0.04404);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.07379, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'area_m2', -2.934, 0.1794),
  ('keyboard', 7, 'aspect', 0.6259, 0.1076),
  ('keyboard', 7, 'behind', 0.2794, 0.08175),
  ('keyboard', 7, 'edge_free', 0.01651, 0.03025),
  ('keyboard', 7, 'edge_free_top', -0.0007556, 0.3166),
  ('keyboard', 7, 'edge_joined', 0.9683, 0.05561),
  ('keyboard', 7, 'edge_unseen', 0.04158, 0.07361),
  ('keyboard', 7, 'height', 0.7633, 0.04923),
  ('keyboard', 7, 'length', -1.073, 0.1123),
  ('keyboard', 7, 'rectangularity', 0.8493, 0.03834),
  ('keyboard', 7, 'spread_length', -1.108, 0.06697),
  ('keyboard', 7, 'spread_width', -1.806, 0.06366),
  ('keyboard', 7, 'tilt_deg', 1.687, 0.45),
  ('keyboard', 7, 'width', -1.679, 0.1156),
  ('keyboard', 7, 'z_max', 0.7656, 0.05017),
  ('keyboard', 7, 'z_min', 0.7671, 0.05474);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.06536, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'area_m2', -2.906, 0.3071),
  ('keyboard', 8, 'aspect', 0.8546, 0.1819),
  ('keyboard', 8, 'behind', 0.1746, 0.1721),
  ('keyboard', 8, 'edge_free', 0.2039, 0.1484),
  ('keyboard', 8, 'edge_free_top', -0.007831, 0.3109),
  ('keyboard', 8, 'edge_joined', 0.7241, 0.1995),
  ('keyboard', 8, 'edge_unseen', 0.0638, 0.09641),
  ('keyboard', 8, 'height', 1.013, 0.1088),
  ('keyboard', 8, 'length', -0.9402, 0.1979),
  ('keyboard', 8, 'rectangularity', 0.8639, 0.1095),
  ('keyboard', 8, 'spread_length', -0.952, 0.1647),
  ('keyboard', 8, 'spread_width', -1.873, 0.07994),
  ('keyboard', 8, 'tilt_deg', 4.3, 1.473),
  ('keyboard', 8, 'width', -1.79, 0.1145),
  ('keyboard', 8, 'z_max', 1.019, 0.1007),
  ('keyboard', 8, 'z_min', 1.024, 0.09894);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.04775, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'area_m2', -3.988, 0.3159),
  ('keyboard', 9, 'aspect', 0.5543, 0.3228),
  ('keyboard', 9, 'behind', 0.2712, 0.1007),
  ('keyboard', 9, 'edge_free', 0.2772, 0.2884),
  ('keyboard', 9, 'edge_free_top', -0.001531, 0.3153),
  ('keyboard', 9, 'edge_joined', 0.4736, 0.2929),
  ('keyboard', 9, 'edge_unseen', 0.1971, 0.1769),
  ('keyboard', 9, 'height', 0.7603, 0.0482),
  ('keyboard', 9, 'length', -1.553, 0.2907),
  ('keyboard', 9, 'rectangularity', 0.7475, 0.07217),
  ('keyboard', 9, 'spread_length', -1.641, 0.1247),
  ('keyboard', 9, 'spread_width', -2.244, 0.09411),
  ('keyboard', 9, 'tilt_deg', 4.099, 1.161),
  ('keyboard', 9, 'width', -2.13, 0.1493),
  ('keyboard', 9, 'z_max', 0.7595, 0.04731),
  ('keyboard', 9, 'z_min', 0.7582, 0.05421);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.02358, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'area_m2', -2.939, 0.3579),
  ('keyboard', 10, 'aspect', 0.9725, 0.4134),
  ('keyboard', 10, 'behind', 0.1199, 0.09401),
  ('keyboard', 10, 'edge_free', 0.1332, 0.1521),
  ('keyboard', 10, 'edge_free_top', -0.0006413, 0.32),
  ('keyboard', 10, 'edge_joined', 0.8531, 0.1403),
  ('keyboard', 10, 'edge_unseen', 0.1244, 0.1648),
  ('keyboard', 10, 'height', 0.1327, 0.08755),
  ('keyboard', 10, 'length', -0.9292, 0.3347),
  ('keyboard', 10, 'rectangularity', 0.9133, 0.04178),
  ('keyboard', 10, 'spread_length', -0.9515, 0.3851),
  ('keyboard', 10, 'spread_width', -1.961, 0.04402),
  ('keyboard', 10, 'tilt_deg', 2.442, 1.06),
  ('keyboard', 10, 'width', -1.912, 0.05696),
  ('keyboard', 10, 'z_max', 0.1307, 0.0896),
  ('keyboard', 10, 'z_min', 0.1343, 0.07741);

-- chair_seat: 489 examples
UPDATE object_class SET prior = 0.009546 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.032, 0.5589)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.2885, 0.2855)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6622, 0.1639)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.6209, 0.1977)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_joined', 0.08756, 0.1114)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_unseen', 0.0487, 0.1098)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4697, 0.03029)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7189, 0.1949)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7494, 0.1287)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7822, 0.1959)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.21, 0.3813)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 0.6717, 0.7662)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.007, 0.3611)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4722, 0.03037)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4674, 0.03041)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_seat';
DELETE FROM class_density WHERE class = 'chair_seat';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.132, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'area_m2', -1.62, 0.11),
  ('chair_seat', 1, 'aspect', 0.1184, 0.07769),
  ('chair_seat', 1, 'behind', 0.6958, 0.094),
  ('chair_seat', 1, 'edge_free', 0.7797, 0.1149),
  ('chair_seat', 1, 'edge_free_top', -0.0004296, 0.3153),
  ('chair_seat', 1, 'edge_joined', 0.06167, 0.07691),
  ('chair_seat', 1, 'edge_unseen', 0.006743, 0.03038),
  ('chair_seat', 1, 'height', 0.4446, 0.0225),
  ('chair_seat', 1, 'length', -0.6694, 0.07943),
  ('chair_seat', 1, 'rectangularity', 0.8462, 0.07193),
  ('chair_seat', 1, 'spread_length', -0.7221, 0.05581),
  ('chair_seat', 1, 'spread_width', -0.918, 0.07605),
  ('chair_seat', 1, 'tilt_deg', 0.3955, 0.45),
  ('chair_seat', 1, 'width', -0.7864, 0.07593),
  ('chair_seat', 1, 'z_max', 0.4488, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4443, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.1042, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'area_m2', -1.626, 0.1244),
  ('chair_seat', 2, 'aspect', 0.1181, 0.0835),
  ('chair_seat', 2, 'behind', 0.6647, 0.08582),
  ('chair_seat', 2, 'edge_free', 0.7547, 0.1342),
  ('chair_seat', 2, 'edge_free_top', -0.0002738, 0.3156),
  ('chair_seat', 2, 'edge_joined', 0.0628, 0.07832),
  ('chair_seat', 2, 'edge_unseen', 0.002445, 0.03186),
  ('chair_seat', 2, 'height', 0.4926, 0.0225),
  ('chair_seat', 2, 'length', -0.6662, 0.07949),
  ('chair_seat', 2, 'rectangularity', 0.8406, 0.06225),
  ('chair_seat', 2, 'spread_length', -0.7199, 0.06622),
  ('chair_seat', 2, 'spread_width', -0.9236, 0.08779),
  ('chair_seat', 2, 'tilt_deg', 0.4214, 0.4541),
  ('chair_seat', 2, 'width', -0.7862, 0.07906),
  ('chair_seat', 2, 'z_max', 0.4924, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4885, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.1223, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'area_m2', -1.943, 0.1843),
  ('chair_seat', 3, 'aspect', 0.1221, 0.07998),
  ('chair_seat', 3, 'behind', 0.7318, 0.08843),
  ('chair_seat', 3, 'edge_free', 0.5381, 0.1041),
  ('chair_seat', 3, 'edge_free_top', -0.0006697, 0.3152),
  ('chair_seat', 3, 'edge_joined', 0.1381, 0.123),
  ('chair_seat', 3, 'edge_unseen', 0.00218, 0.0316),
  ('chair_seat', 3, 'height', 0.4569, 0.0225),
  ('chair_seat', 3, 'length', -0.7075, 0.07122),
  ('chair_seat', 3, 'rectangularity', 0.6842, 0.1082),
  ('chair_seat', 3, 'spread_length', -0.7084, 0.08499),
  ('chair_seat', 3, 'spread_width', -1.087, 0.1087),
  ('chair_seat', 3, 'tilt_deg', 0.38, 0.45),
  ('chair_seat', 3, 'width', -0.8427, 0.07202),
  ('chair_seat', 3, 'z_max', 0.4583, 0.0225),
  ('chair_seat', 3, 'z_min', 0.4552, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.1628, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'area_m2', -2.037, 0.2584),
  ('chair_seat', 4, 'aspect', 0.2045, 0.1629),
  ('chair_seat', 4, 'behind', 0.6299, 0.1108),
  ('chair_seat', 4, 'edge_free', 0.5621, 0.1485),
  ('chair_seat', 4, 'edge_free_top', -0.0008462, 0.3152),
  ('chair_seat', 4, 'edge_joined', 0.08155, 0.09834),
  ('chair_seat', 4, 'edge_unseen', 0.1121, 0.1251),
  ('chair_seat', 4, 'height', 0.4937, 0.0249),
  ('chair_seat', 4, 'length', -0.7118, 0.1308),
  ('chair_seat', 4, 'rectangularity', 0.6751, 0.105),
  ('chair_seat', 4, 'spread_length', -0.7369, 0.1331),
  ('chair_seat', 4, 'spread_width', -1.222, 0.1261),
  ('chair_seat', 4, 'tilt_deg', 0.5547, 0.5141),
  ('chair_seat', 4, 'width', -0.9273, 0.1065),
  ('chair_seat', 4, 'z_max', 0.4974, 0.0246),
  ('chair_seat', 4, 'z_min', 0.4925, 0.02307);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.2026, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'area_m2', -3.368, 0.4284),
  ('chair_seat', 5, 'aspect', 0.5419, 0.3246),
  ('chair_seat', 5, 'behind', 0.3774, 0.3113),
  ('chair_seat', 5, 'edge_free', 0.5248, 0.1398),
  ('chair_seat', 5, 'edge_free_top', -0.005511, 0.3131),
  ('chair_seat', 5, 'edge_joined', 0.05878, 0.1166),
  ('chair_seat', 5, 'edge_unseen', 0.1875, 0.1669),
  ('chair_seat', 5, 'height', 0.4771, 0.03783),
  ('chair_seat', 5, 'length', -1.199, 0.2538),
  ('chair_seat', 5, 'rectangularity', 0.6775, 0.07426),
  ('chair_seat', 5, 'spread_length', -1.283, 0.3075),
  ('chair_seat', 5, 'spread_width', -2.003, 0.2769),
  ('chair_seat', 5, 'tilt_deg', 2.033, 1.35),
  ('chair_seat', 5, 'width', -1.762, 0.2675),
  ('chair_seat', 5, 'z_max', 0.4912, 0.02373),
  ('chair_seat', 5, 'z_min', 0.478, 0.03933);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.0694, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'area_m2', -2.305, 0.2735),
  ('chair_seat', 6, 'aspect', 0.5285, 0.1043),
  ('chair_seat', 6, 'behind', 0.7408, 0.1167),
  ('chair_seat', 6, 'edge_free', 0.4643, 0.1243),
  ('chair_seat', 6, 'edge_free_top', -0.0005036, 0.3158),
  ('chair_seat', 6, 'edge_joined', 0.07687, 0.1038),
  ('chair_seat', 6, 'edge_unseen', 0.01496, 0.03419),
  ('chair_seat', 6, 'height', 0.447, 0.0225),
  ('chair_seat', 6, 'length', -0.6993, 0.1391),
  ('chair_seat', 6, 'rectangularity', 0.6789, 0.1556),
  ('chair_seat', 6, 'spread_length', -0.7444, 0.09155),
  ('chair_seat', 6, 'spread_width', -1.452, 0.2225),
  ('chair_seat', 6, 'tilt_deg', 0.917, 0.8043),
  ('chair_seat', 6, 'width', -1.217, 0.1283),
  ('chair_seat', 6, 'z_max', 0.4548, 0.0225),
  ('chair_seat', 6, 'z_min', 0.4479, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.07361, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'area_m2', -2.424, 0.187),
  ('chair_seat', 7, 'aspect', 0.733, 0.1285),
  ('chair_seat', 7, 'behind', 0.6509, 0.1317),
  ('chair_seat', 7, 'edge_free', 0.4897, 0.231),
  ('chair_seat', 7, 'edge_free_top', -0.0001255, 0.3161),
  ('chair_seat', 7, 'edge_joined', 0.06736, 0.1032),
  ('chair_seat', 7, 'edge_unseen', 0.1218, 0.1538),
  ('chair_seat', 7, 'height', 0.4909, 0.0225),
  ('chair_seat', 7, 'length', -0.6716, 0.09727),
  ('chair_seat', 7, 'rectangularity', 0.7226, 0.128),
  ('chair_seat', 7, 'spread_length', -0.7233, 0.09161),
  ('chair_seat', 7, 'spread_width', -1.604, 0.1329),
  ('chair_seat', 7, 'tilt_deg', 0.8184, 0.6084),
  ('chair_seat', 7, 'width', -1.401, 0.113),
  ('chair_seat', 7, 'z_max', 0.4943, 0.0225),
  ('chair_seat', 7, 'z_min', 0.4888, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.03011, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'area_m2', -1.508, 0.3551),
  ('chair_seat', 8, 'aspect', 0.383, 0.2849),
  ('chair_seat', 8, 'behind', 0.7211, 0.08936),
  ('chair_seat', 8, 'edge_free', 0.594, 0.08593),
  ('chair_seat', 8, 'edge_free_top', -0.0001123, 0.316),
  ('chair_seat', 8, 'edge_joined', 0.08129, 0.09164),
  ('chair_seat', 8, 'edge_unseen', 0.00837, 0.03052),
  ('chair_seat', 8, 'height', 0.4686, 0.02656),
  ('chair_seat', 8, 'length', -0.3644, 0.2366),
  ('chair_seat', 8, 'rectangularity', 0.6748, 0.09557),
  ('chair_seat', 8, 'spread_length', -0.592, 0.3051),
  ('chair_seat', 8, 'spread_width', -0.9658, 0.112),
  ('chair_seat', 8, 'tilt_deg', 0.4348, 0.45),
  ('chair_seat', 8, 'width', -0.7361, 0.1332),
  ('chair_seat', 8, 'z_max', 0.4712, 0.02556),
  ('chair_seat', 8, 'z_min', 0.4672, 0.02517);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.03628, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'area_m2', -2.826, 0.1818),
  ('chair_seat', 9, 'aspect', 1.009, 0.1336),
  ('chair_seat', 9, 'behind', 0.7474, 0.07336),
  ('chair_seat', 9, 'edge_free', 0.4466, 0.1196),
  ('chair_seat', 9, 'edge_free_top', -0.0001897, 0.3163),
  ('chair_seat', 9, 'edge_joined', 0.08425, 0.06073),
  ('chair_seat', 9, 'edge_unseen', 0.007129, 0.03),
  ('chair_seat', 9, 'height', 0.4777, 0.02552),
  ('chair_seat', 9, 'length', -0.7457, 0.06925),
  ('chair_seat', 9, 'rectangularity', 0.7305, 0.104),
  ('chair_seat', 9, 'spread_length', -0.7992, 0.123),
  ('chair_seat', 9, 'spread_width', -1.93, 0.1202),
  ('chair_seat', 9, 'tilt_deg', 1.604, 1.536),
  ('chair_seat', 9, 'width', -1.75, 0.1884),
  ('chair_seat', 9, 'z_max', 0.4817, 0.02372),
  ('chair_seat', 9, 'z_min', 0.4743, 0.02722);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 10, 0.0168, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 10, 'area_m2', -2.542, 0.1984),
  ('chair_seat', 10, 'aspect', 0.4622, 0.08723),
  ('chair_seat', 10, 'behind', 0.2335, 0.2397),
  ('chair_seat', 10, 'edge_free', 0.6594, 0.2316),
  ('chair_seat', 10, 'edge_free_top', -0.0008399, 0.3152),
  ('chair_seat', 10, 'edge_joined', 0.01782, 0.03),
  ('chair_seat', 10, 'edge_unseen', 0.2575, 0.2024),
  ('chair_seat', 10, 'height', 0.4079, 0.1947),
  ('chair_seat', 10, 'length', -0.8742, 0.06823),
  ('chair_seat', 10, 'rectangularity', 0.7192, 0.072),
  ('chair_seat', 10, 'spread_length', -0.9485, 0.1158),
  ('chair_seat', 10, 'spread_width', -1.562, 0.1701),
  ('chair_seat', 10, 'tilt_deg', 0.8241, 0.6443),
  ('chair_seat', 10, 'width', -1.34, 0.116),
  ('chair_seat', 10, 'z_max', 0.4202, 0.1738),
  ('chair_seat', 10, 'z_min', 0.4155, 0.1741);

-- chair_back: 483 examples
UPDATE object_class SET prior = 0.04998 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.743, 0.6157)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3824, 0.2906)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.5752, 0.2886)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.7938, 0.1968)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9471, 0.1618)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_joined', 0.1156, 0.158)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_unseen', 0.07804, 0.1574)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.818, 0.07962)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.547, 0.2708)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7808, 0.1215)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.7139, 0.2369)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.126, 0.3948)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.48, 3.827)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.933, 0.3446)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.024, 0.08937)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4513, 0.1601)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_back';
DELETE FROM class_density WHERE class = 'chair_back';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1276, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'area_m2', -1.381, 0.1317),
  ('chair_back', 1, 'aspect', 0.1665, 0.06576),
  ('chair_back', 1, 'behind', 0.7605, 0.05383),
  ('chair_back', 1, 'edge_free', 0.7545, 0.1336),
  ('chair_back', 1, 'edge_free_top', 0.9971, 0.03158),
  ('chair_back', 1, 'edge_joined', 0.1469, 0.1719),
  ('chair_back', 1, 'edge_unseen', 0.001808, 0.03297),
  ('chair_back', 1, 'height', 0.8029, 0.07265),
  ('chair_back', 1, 'length', -0.5224, 0.09523),
  ('chair_back', 1, 'rectangularity', 0.8604, 0.09346),
  ('chair_back', 1, 'spread_length', -0.6913, 0.04147),
  ('chair_back', 1, 'spread_width', -0.8034, 0.09614),
  ('chair_back', 1, 'tilt_deg', 80.86, 2.435),
  ('chair_back', 1, 'width', -0.6878, 0.08347),
  ('chair_back', 1, 'z_max', 1.012, 0.07556),
  ('chair_back', 1, 'z_min', 0.4293, 0.09415);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.1461, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'area_m2', -1.792, 0.2289),
  ('chair_back', 2, 'aspect', 0.6174, 0.207),
  ('chair_back', 2, 'behind', 0.7519, 0.0707),
  ('chair_back', 2, 'edge_free', 0.8035, 0.1181),
  ('chair_back', 2, 'edge_free_top', 0.9937, 0.03),
  ('chair_back', 2, 'edge_joined', 0.1162, 0.08231),
  ('chair_back', 2, 'edge_unseen', 0.002486, 0.03),
  ('chair_back', 2, 'height', 0.8095, 0.06546),
  ('chair_back', 2, 'length', -0.4319, 0.1481),
  ('chair_back', 2, 'rectangularity', 0.7545, 0.1179),
  ('chair_back', 2, 'spread_length', -0.6081, 0.1098),
  ('chair_back', 2, 'spread_width', -1.374, 0.1143),
  ('chair_back', 2, 'tilt_deg', 80.21, 2.607),
  ('chair_back', 2, 'width', -1.073, 0.1479),
  ('chair_back', 2, 'z_max', 1.043, 0.09895),
  ('chair_back', 2, 'z_min', 0.4122, 0.07302);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'area_m2', -1.714, 0.1911),
  ('chair_back', 3, 'aspect', 0.1883, 0.1389),
  ('chair_back', 3, 'behind', 0.4466, 0.3563),
  ('chair_back', 3, 'edge_free', 0.8804, 0.1272),
  ('chair_back', 3, 'edge_free_top', 0.9991, 0.03072),
  ('chair_back', 3, 'edge_joined', 0.02916, 0.04361),
  ('chair_back', 3, 'edge_unseen', 0.1159, 0.1324),
  ('chair_back', 3, 'height', 0.7884, 0.05283),
  ('chair_back', 3, 'length', -0.6769, 0.09252),
  ('chair_back', 3, 'rectangularity', 0.8736, 0.07069),
  ('chair_back', 3, 'spread_length', -0.7656, 0.04147),
  ('chair_back', 3, 'spread_width', -1.012, 0.156),
  ('chair_back', 3, 'tilt_deg', 80.32, 2.831),
  ('chair_back', 3, 'width', -0.8878, 0.1168),
  ('chair_back', 3, 'z_max', 0.96, 0.05462),
  ('chair_back', 3, 'z_min', 0.4845, 0.09397);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.1123, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'area_m2', -1.205, 0.1598),
  ('chair_back', 4, 'aspect', 0.4443, 0.1254),
  ('chair_back', 4, 'behind', 0.5179, 0.2809),
  ('chair_back', 4, 'edge_free', 0.9805, 0.03),
  ('chair_back', 4, 'edge_free_top', 0.9982, 0.03),
  ('chair_back', 4, 'edge_joined', 0.01181, 0.03001),
  ('chair_back', 4, 'edge_unseen', 0.0174, 0.04633),
  ('chair_back', 4, 'height', 0.8179, 0.04849),
  ('chair_back', 4, 'length', -0.3164, 0.09779),
  ('chair_back', 4, 'rectangularity', 0.8723, 0.07185),
  ('chair_back', 4, 'spread_length', -0.4988, 0.06455),
  ('chair_back', 4, 'spread_width', -0.8788, 0.1557),
  ('chair_back', 4, 'tilt_deg', 80.65, 2.974),
  ('chair_back', 4, 'width', -0.7511, 0.09553),
  ('chair_back', 4, 'z_max', 1.065, 0.05774),
  ('chair_back', 4, 'z_min', 0.35, 0.04039);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.09692, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'area_m2', -1.425, 0.1919),
  ('chair_back', 5, 'aspect', 0.4992, 0.1441),
  ('chair_back', 5, 'behind', 0.5269, 0.3205),
  ('chair_back', 5, 'edge_free', 0.6744, 0.2013),
  ('chair_back', 5, 'edge_free_top', 0.8707, 0.1868),
  ('chair_back', 5, 'edge_joined', 0.2585, 0.2067),
  ('chair_back', 5, 'edge_unseen', 0.1428, 0.1553),
  ('chair_back', 5, 'height', 0.8652, 0.05026),
  ('chair_back', 5, 'length', -0.3345, 0.07293),
  ('chair_back', 5, 'rectangularity', 0.7639, 0.08687),
  ('chair_back', 5, 'spread_length', -0.5554, 0.07472),
  ('chair_back', 5, 'spread_width', -1.003, 0.2267),
  ('chair_back', 5, 'tilt_deg', 79.51, 2.649),
  ('chair_back', 5, 'width', -0.8121, 0.1105),
  ('chair_back', 5, 'z_max', 1.104, 0.05298),
  ('chair_back', 5, 'z_min', 0.4006, 0.06458);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.1171, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'area_m2', -2.542, 0.3785),
  ('chair_back', 6, 'aspect', 0.6711, 0.4617),
  ('chair_back', 6, 'behind', 0.5692, 0.3851),
  ('chair_back', 6, 'edge_free', 0.6199, 0.1389),
  ('chair_back', 6, 'edge_free_top', 0.9608, 0.07993),
  ('chair_back', 6, 'edge_joined', 0.06154, 0.08599),
  ('chair_back', 6, 'edge_unseen', 0.009588, 0.03519),
  ('chair_back', 6, 'height', 0.8504, 0.05553),
  ('chair_back', 6, 'length', -0.7853, 0.2103),
  ('chair_back', 6, 'rectangularity', 0.7541, 0.1337),
  ('chair_back', 6, 'spread_length', -0.878, 0.1333),
  ('chair_back', 6, 'spread_width', -1.795, 0.2003),
  ('chair_back', 6, 'tilt_deg', 80.03, 2.624),
  ('chair_back', 6, 'width', -1.512, 0.268),
  ('chair_back', 6, 'z_max', 1.037, 0.06091),
  ('chair_back', 6, 'z_min', 0.569, 0.04812);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.06709, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'area_m2', -2.881, 0.6506),
  ('chair_back', 7, 'aspect', 0.3078, 0.1864),
  ('chair_back', 7, 'behind', 0.04232, 0.1412),
  ('chair_back', 7, 'edge_free', 0.9816, 0.0479),
  ('chair_back', 7, 'edge_free_top', 0.9992, 0.03244),
  ('chair_back', 7, 'edge_joined', 0.01428, 0.04341),
  ('chair_back', 7, 'edge_unseen', 0.4603, 0.1309),
  ('chair_back', 7, 'height', 0.9248, 0.07306),
  ('chair_back', 7, 'length', -0.9587, 0.3013),
  ('chair_back', 7, 'rectangularity', 0.6292, 0.07088),
  ('chair_back', 7, 'spread_length', -1.179, 0.2978),
  ('chair_back', 7, 'spread_width', -1.757, 0.3923),
  ('chair_back', 7, 'tilt_deg', 80.78, 2.468),
  ('chair_back', 7, 'width', -1.452, 0.4337),
  ('chair_back', 7, 'z_max', 1.023, 0.07186),
  ('chair_back', 7, 'z_min', 0.6751, 0.09078);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.07621, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'area_m2', -1.701, 0.2044),
  ('chair_back', 8, 'aspect', 0.1312, 0.1016),
  ('chair_back', 8, 'behind', 0.5511, 0.3284),
  ('chair_back', 8, 'edge_free', 0.57, 0.1585),
  ('chair_back', 8, 'edge_free_top', 0.7562, 0.2787),
  ('chair_back', 8, 'edge_joined', 0.3684, 0.2003),
  ('chair_back', 8, 'edge_unseen', 0.04408, 0.118),
  ('chair_back', 8, 'height', 0.7736, 0.04642),
  ('chair_back', 8, 'length', -0.6677, 0.1129),
  ('chair_back', 8, 'rectangularity', 0.8199, 0.09861),
  ('chair_back', 8, 'spread_length', -0.7665, 0.0574),
  ('chair_back', 8, 'spread_width', -0.9907, 0.1785),
  ('chair_back', 8, 'tilt_deg', 80.2, 2.676),
  ('chair_back', 8, 'width', -0.8278, 0.1089),
  ('chair_back', 8, 'z_max', 0.9541, 0.05441),
  ('chair_back', 8, 'z_min', 0.4771, 0.07979);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.0726, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'area_m2', -1.19, 0.2515),
  ('chair_back', 9, 'aspect', 0.6989, 0.2953),
  ('chair_back', 9, 'behind', 0.7033, 0.1239),
  ('chair_back', 9, 'edge_free', 0.789, 0.1823),
  ('chair_back', 9, 'edge_free_top', 0.9764, 0.05612),
  ('chair_back', 9, 'edge_joined', 0.1299, 0.1339),
  ('chair_back', 9, 'edge_unseen', 0.02639, 0.06182),
  ('chair_back', 9, 'height', 0.7663, 0.08707),
  ('chair_back', 9, 'length', -0.05881, 0.2047),
  ('chair_back', 9, 'rectangularity', 0.6407, 0.07756),
  ('chair_back', 9, 'spread_length', -0.4332, 0.142),
  ('chair_back', 9, 'spread_width', -0.9079, 0.2176),
  ('chair_back', 9, 'tilt_deg', 80.72, 2.465),
  ('chair_back', 9, 'width', -0.6986, 0.1788),
  ('chair_back', 9, 'z_max', 1.034, 0.1006),
  ('chair_back', 9, 'z_min', 0.05688, 0.08186);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 10, 0.02503, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 10, 'area_m2', -3.136, 0.3996),
  ('chair_back', 10, 'aspect', 0.6736, 0.367),
  ('chair_back', 10, 'behind', 0.2772, 0.3304),
  ('chair_back', 10, 'edge_free', 0.3942, 0.2557),
  ('chair_back', 10, 'edge_free_top', 0.2724, 0.08873),
  ('chair_back', 10, 'edge_joined', 0.1615, 0.2382),
  ('chair_back', 10, 'edge_unseen', 0.2624, 0.2259),
  ('chair_back', 10, 'height', 0.6766, 0.3065),
  ('chair_back', 10, 'length', -1.006, 0.2169),
  ('chair_back', 10, 'rectangularity', 0.6153, 0.0965),
  ('chair_back', 10, 'spread_length', -1.194, 0.2464),
  ('chair_back', 10, 'spread_width', -1.92, 0.3211),
  ('chair_back', 10, 'tilt_deg', 78.87, 2.718),
  ('chair_back', 10, 'width', -1.701, 0.3375),
  ('chair_back', 10, 'z_max', 0.917, 0.156),
  ('chair_back', 10, 'z_min', 0.4611, 0.3399);

-- door: 295 examples
UPDATE object_class SET prior = 0.01512 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.2425, 0.5999)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.8219, 0.2943)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.1607, 0.255)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.1405, 0.243)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.2376, 0.3797)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_joined', 0.3704, 0.3346)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_unseen', 0.1077, 0.1747)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.148, 0.1876)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.6403, 0.2565)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8191, 0.1265)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4763, 0.2869)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.31, 0.3862)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.72, 1.289)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1827, 0.3499)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.054, 0.256)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1219, 0.2824)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'door';
DELETE FROM class_density WHERE class = 'door';
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.2379, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'area_m2', 0.5595, 0.08542),
  ('door', 1, 'aspect', 0.7652, 0.07927),
  ('door', 1, 'behind', -0.007376, 0.03),
  ('door', 1, 'edge_free', -0.0003906, 0.03),
  ('door', 1, 'edge_free_top', 0.002233, 0.03102),
  ('door', 1, 'edge_joined', 0.4334, 0.33),
  ('door', 1, 'edge_unseen', 0.006837, 0.03153),
  ('door', 1, 'height', 1.072, 0.05816),
  ('door', 1, 'length', 0.7184, 0.03454),
  ('door', 1, 'rectangularity', 0.9078, 0.06532),
  ('door', 1, 'spread_length', 0.6482, 0.04356),
  ('door', 1, 'spread_width', -0.14, 0.04402),
  ('door', 1, 'tilt_deg', 89.98, 0.45),
  ('door', 1, 'width', -0.07174, 0.08199),
  ('door', 1, 'z_max', 2.048, 0.04538),
  ('door', 1, 'z_min', 0.003184, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1575, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'area_m2', 0.579, 0.1233),
  ('door', 2, 'aspect', 0.8565, 0.07778),
  ('door', 2, 'behind', 0.5072, 0.1446),
  ('door', 2, 'edge_free', 0.3865, 0.1157),
  ('door', 2, 'edge_free_top', 0.7781, 0.1677),
  ('door', 2, 'edge_joined', 0.3463, 0.3055),
  ('door', 2, 'edge_unseen', 0.004658, 0.03),
  ('door', 2, 'height', 1.071, 0.03364),
  ('door', 2, 'length', 0.8029, 0.07342),
  ('door', 2, 'rectangularity', 0.8353, 0.05261),
  ('door', 2, 'spread_length', 0.6814, 0.04147),
  ('door', 2, 'spread_width', -0.1284, 0.1048),
  ('door', 2, 'tilt_deg', 89.98, 0.45),
  ('door', 2, 'width', -0.02749, 0.1073),
  ('door', 2, 'z_max', 2.202, 0.1085),
  ('door', 2, 'z_min', -0.009169, 0.02335);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'area_m2', 0.3081, 0.1544),
  ('door', 3, 'aspect', 0.8275, 0.1502),
  ('door', 3, 'behind', -0.002395, 0.03),
  ('door', 3, 'edge_free', -8.429e-05, 0.03),
  ('door', 3, 'edge_free_top', 0.0043, 0.03184),
  ('door', 3, 'edge_joined', 0.3428, 0.2908),
  ('door', 3, 'edge_unseen', 0.2247, 0.2252),
  ('door', 3, 'height', 1.226, 0.1136),
  ('door', 3, 'length', 0.7093, 0.04498),
  ('door', 3, 'rectangularity', 0.7833, 0.1136),
  ('door', 3, 'spread_length', 0.4285, 0.1304),
  ('door', 3, 'spread_width', -0.2495, 0.1152),
  ('door', 3, 'tilt_deg', 89.97, 0.45),
  ('door', 3, 'width', -0.1446, 0.1224),
  ('door', 3, 'z_max', 2.066, 0.03986),
  ('door', 3, 'z_min', 0.0464, 0.08867);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.1113, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'area_m2', 0.03824, 0.5452),
  ('door', 4, 'aspect', 0.613, 0.2751),
  ('door', 4, 'behind', -0.002829, 0.03),
  ('door', 4, 'edge_free', -0.001681, 0.03),
  ('door', 4, 'edge_free_top', 0.006015, 0.03092),
  ('door', 4, 'edge_joined', 0.4412, 0.3173),
  ('door', 4, 'edge_unseen', 0.2336, 0.225),
  ('door', 4, 'height', 1.194, 0.1807),
  ('door', 4, 'length', 0.5936, 0.1956),
  ('door', 4, 'rectangularity', 0.7034, 0.1253),
  ('door', 4, 'spread_length', 0.2598, 0.3147),
  ('door', 4, 'spread_width', -0.4527, 0.5258),
  ('door', 4, 'tilt_deg', 89.91, 0.45),
  ('door', 4, 'width', -0.1672, 0.5307),
  ('door', 4, 'z_max', 2.046, 0.04949),
  ('door', 4, 'z_min', 0.2619, 0.1902);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.06785, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'area_m2', 0.1113, 0.2137),
  ('door', 5, 'aspect', 0.7368, 0.2158),
  ('door', 5, 'behind', 0.4861, 0.1418),
  ('door', 5, 'edge_free', 0.4605, 0.2679),
  ('door', 5, 'edge_free_top', 0.6862, 0.1958),
  ('door', 5, 'edge_joined', 0.2966, 0.2692),
  ('door', 5, 'edge_unseen', 0.2079, 0.204),
  ('door', 5, 'height', 1.314, 0.1001),
  ('door', 5, 'length', 0.6112, 0.1644),
  ('door', 5, 'rectangularity', 0.7262, 0.1056),
  ('door', 5, 'spread_length', 0.2346, 0.2153),
  ('door', 5, 'spread_width', -0.2664, 0.1982),
  ('door', 5, 'tilt_deg', 89.99, 0.45),
  ('door', 5, 'width', -0.1661, 0.1491),
  ('door', 5, 'z_max', 2.185, 0.1032),
  ('door', 5, 'z_min', 0.4319, 0.2291);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.05625, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'area_m2', 0.4135, 0.2001),
  ('door', 6, 'aspect', 0.7909, 0.05881),
  ('door', 6, 'behind', 0.4325, 0.08298),
  ('door', 6, 'edge_free', 0.5956, 0.1699),
  ('door', 6, 'edge_free_top', 0.9117, 0.08334),
  ('door', 6, 'edge_joined', 0.09721, 0.1056),
  ('door', 6, 'edge_unseen', 0.1832, 0.1554),
  ('door', 6, 'height', 1.218, 0.06849),
  ('door', 6, 'length', 0.752, 0.05944),
  ('door', 6, 'rectangularity', 0.7481, 0.1277),
  ('door', 6, 'spread_length', 0.3885, 0.1272),
  ('door', 6, 'spread_width', -0.16, 0.07161),
  ('door', 6, 'tilt_deg', 89.97, 0.45),
  ('door', 6, 'width', -0.03392, 0.06048),
  ('door', 6, 'z_max', 2.129, 0.07883),
  ('door', 6, 'z_min', -0.003274, 0.03597);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.05962, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'area_m2', -0.2975, 0.2807),
  ('door', 7, 'aspect', 0.3205, 0.1335),
  ('door', 7, 'behind', 0.4363, 0.3339),
  ('door', 7, 'edge_free', 0.08625, 0.1194),
  ('door', 7, 'edge_free_top', 0.1807, 0.2488),
  ('door', 7, 'edge_joined', 0.5281, 0.3196),
  ('door', 7, 'edge_unseen', 0.2261, 0.1239),
  ('door', 7, 'height', 1.373, 0.1961),
  ('door', 7, 'length', 0.1858, 0.1662),
  ('door', 7, 'rectangularity', 0.7489, 0.1185),
  ('door', 7, 'spread_length', -0.03576, 0.09239),
  ('door', 7, 'spread_width', -0.3431, 0.206),
  ('door', 7, 'tilt_deg', 89.29, 1.505),
  ('door', 7, 'width', -0.1552, 0.1371),
  ('door', 7, 'z_max', 2.026, 0.1163),
  ('door', 7, 'z_min', 0.7957, 0.3012);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.04608, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'area_m2', -1.172, 0.5686),
  ('door', 8, 'aspect', 0.8944, 0.2116),
  ('door', 8, 'behind', 0.08988, 0.2085),
  ('door', 8, 'edge_free', 0.1032, 0.1277),
  ('door', 8, 'edge_free_top', 0.1037, 0.1802),
  ('door', 8, 'edge_joined', 0.245, 0.1518),
  ('door', 8, 'edge_unseen', 0.1302, 0.1557),
  ('door', 8, 'height', 0.5894, 0.266),
  ('door', 8, 'length', -0.03033, 0.2678),
  ('door', 8, 'rectangularity', 0.8161, 0.1146),
  ('door', 8, 'spread_length', -0.07555, 0.2408),
  ('door', 8, 'spread_width', -1.044, 0.2216),
  ('door', 8, 'tilt_deg', 89.15, 0.9064),
  ('door', 8, 'width', -0.9508, 0.2045),
  ('door', 8, 'z_max', 0.985, 0.3301),
  ('door', 8, 'z_min', 0.08872, 0.1488);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.02651, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'area_m2', -1.821, 0.6882),
  ('door', 9, 'aspect', 1.512, 0.4246),
  ('door', 9, 'behind', 0.1698, 0.2898),
  ('door', 9, 'edge_free', 0.4182, 0.2459),
  ('door', 9, 'edge_free_top', 0.4492, 0.3601),
  ('door', 9, 'edge_joined', 0.3066, 0.2479),
  ('door', 9, 'edge_unseen', 0.1842, 0.19),
  ('door', 9, 'height', 1.462, 0.3317),
  ('door', 9, 'length', 0.01009, 0.43),
  ('door', 9, 'rectangularity', 0.7151, 0.05864),
  ('door', 9, 'spread_length', -0.1615, 0.3742),
  ('door', 9, 'spread_width', -1.69, 0.3372),
  ('door', 9, 'tilt_deg', 88.24, 2.734),
  ('door', 9, 'width', -1.543, 0.373),
  ('door', 9, 'z_max', 1.906, 0.1721),
  ('door', 9, 'z_min', 0.9556, 0.6879);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.04197, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'area_m2', -0.03746, 0.1381),
  ('door', 10, 'aspect', 1.208, 0.1752),
  ('door', 10, 'behind', 0.1414, 0.1371),
  ('door', 10, 'edge_free', 0.1453, 0.1419),
  ('door', 10, 'edge_free_top', 0.05236, 0.08654),
  ('door', 10, 'edge_joined', 0.1564, 0.1993),
  ('door', 10, 'edge_unseen', 0.2771, 0.1398),
  ('door', 10, 'height', 1.098, 0.09192),
  ('door', 10, 'length', 0.7821, 0.1032),
  ('door', 10, 'rectangularity', 0.6661, 0.09242),
  ('door', 10, 'spread_length', 0.6745, 0.1336),
  ('door', 10, 'spread_width', -0.8612, 0.2067),
  ('door', 10, 'tilt_deg', 83.44, 4.254),
  ('door', 10, 'width', -0.4146, 0.1661),
  ('door', 10, 'z_max', 2.029, 0.1252),
  ('door', 10, 'z_min', 0.007161, 0.04537);

-- window: 719 examples
UPDATE object_class SET prior = 0.02668 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', -0.4097, 0.7573)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.4487, 0.4055)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 0.001234, 0.01123)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.08277, 0.1596)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.07367, 0.195)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_joined', 0.382, 0.3513)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_unseen', 0.1398, 0.1615)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.496, 0.204)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.1768, 0.2847)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.7619, 0.1896)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.1804, 0.3466)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.3725, 0.5763)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.75, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.2721, 0.4907)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.044, 0.2651)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 1.016, 0.2164)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'window';
DELETE FROM class_density WHERE class = 'window';
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.1499, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'area_m2', -0.02286, 0.1937),
  ('window', 1, 'aspect', 0.2451, 0.1648),
  ('window', 1, 'behind', -0.003203, 0.03),
  ('window', 1, 'edge_free', 0.01037, 0.04069),
  ('window', 1, 'edge_free_top', 0.0009559, 0.03),
  ('window', 1, 'edge_joined', 0.4789, 0.4275),
  ('window', 1, 'edge_unseen', 0.1655, 0.06286),
  ('window', 1, 'height', 1.452, 0.1543),
  ('window', 1, 'length', 0.2218, 0.1228),
  ('window', 1, 'rectangularity', 0.8756, 0.07625),
  ('window', 1, 'spread_length', 0.255, 0.1269),
  ('window', 1, 'spread_width', -0.1362, 0.1959),
  ('window', 1, 'tilt_deg', 89.46, 0.45),
  ('window', 1, 'width', -0.1443, 0.09826),
  ('window', 1, 'z_max', 2.109, 0.167),
  ('window', 1, 'z_min', 0.9736, 0.06625);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1185, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'area_m2', -1.087, 0.4606),
  ('window', 2, 'aspect', 0.5589, 0.4153),
  ('window', 2, 'behind', -0.007468, 0.03),
  ('window', 2, 'edge_free', -0.0005399, 0.03),
  ('window', 2, 'edge_free_top', -0.0006591, 0.03),
  ('window', 2, 'edge_joined', 0.6608, 0.2736),
  ('window', 2, 'edge_unseen', 0.2931, 0.2256),
  ('window', 2, 'height', 1.397, 0.1745),
  ('window', 2, 'length', -0.02598, 0.2196),
  ('window', 2, 'rectangularity', 0.7331, 0.1732),
  ('window', 2, 'spread_length', 0.1046, 0.1657),
  ('window', 2, 'spread_width', -0.8709, 0.657),
  ('window', 2, 'tilt_deg', 89.48, 0.45),
  ('window', 2, 'width', -0.7576, 0.3374),
  ('window', 2, 'z_max', 1.794, 0.2618),
  ('window', 2, 'z_min', 0.9834, 0.06296);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.1412, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'area_m2', 0.3471, 0.1766),
  ('window', 3, 'aspect', 0.1481, 0.09029),
  ('window', 3, 'behind', -0.0004979, 0.03),
  ('window', 3, 'edge_free', -0.007102, 0.03),
  ('window', 3, 'edge_free_top', -0.0009012, 0.03),
  ('window', 3, 'edge_joined', 0.02541, 0.03813),
  ('window', 3, 'edge_unseen', 0.0112, 0.03999),
  ('window', 3, 'height', 1.514, 0.08462),
  ('window', 3, 'length', 0.3401, 0.09825),
  ('window', 3, 'rectangularity', 0.883, 0.1008),
  ('window', 3, 'spread_length', 0.4826, 0.07522),
  ('window', 3, 'spread_width', 0.2931, 0.1128),
  ('window', 3, 'tilt_deg', 89.84, 0.45),
  ('window', 3, 'width', 0.1043, 0.0898),
  ('window', 3, 'z_max', 2.156, 0.1092),
  ('window', 3, 'z_min', 0.8924, 0.05231);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.1622, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'area_m2', -0.5623, 0.3961),
  ('window', 4, 'aspect', 0.2566, 0.1673),
  ('window', 4, 'behind', -0.0008838, 0.03),
  ('window', 4, 'edge_free', 0.0826, 0.1247),
  ('window', 4, 'edge_free_top', 0.09093, 0.1646),
  ('window', 4, 'edge_joined', 0.1769, 0.1664),
  ('window', 4, 'edge_unseen', 0.09713, 0.09141),
  ('window', 4, 'height', 1.521, 0.17),
  ('window', 4, 'length', 0.2975, 0.1166),
  ('window', 4, 'rectangularity', 0.4109, 0.0916),
  ('window', 4, 'spread_length', 0.4514, 0.1449),
  ('window', 4, 'spread_width', 0.04456, 0.2409),
  ('window', 4, 'tilt_deg', 89.82, 0.4587),
  ('window', 4, 'width', 0.01314, 0.1343),
  ('window', 4, 'z_max', 2.183, 0.1315),
  ('window', 4, 'z_min', 0.8996, 0.04963);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.1365, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'area_m2', -0.515, 0.4871),
  ('window', 5, 'aspect', 0.5956, 0.2886),
  ('window', 5, 'behind', -0.00562, 0.03),
  ('window', 5, 'edge_free', 0.1733, 0.1156),
  ('window', 5, 'edge_free_top', 0.01111, 0.03096),
  ('window', 5, 'edge_joined', 0.4034, 0.2705),
  ('window', 5, 'edge_unseen', 0.1896, 0.1186),
  ('window', 5, 'height', 1.849, 0.1175),
  ('window', 5, 'length', 0.1256, 0.2445),
  ('window', 5, 'rectangularity', 0.8027, 0.06998),
  ('window', 5, 'spread_length', 0.1298, 0.265),
  ('window', 5, 'spread_width', -0.66, 0.3271),
  ('window', 5, 'tilt_deg', 89.72, 0.6584),
  ('window', 5, 'width', -0.5163, 0.3103),
  ('window', 5, 'z_max', 2.156, 0.1281),
  ('window', 5, 'z_min', 1.58, 0.1741);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.0878, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'area_m2', -0.3721, 0.3975),
  ('window', 6, 'aspect', 0.3431, 0.2397),
  ('window', 6, 'behind', -0.006722, 0.03),
  ('window', 6, 'edge_free', 0.4134, 0.2731),
  ('window', 6, 'edge_free_top', 0.432, 0.3501),
  ('window', 6, 'edge_joined', 0.4814, 0.2505),
  ('window', 6, 'edge_unseen', 0.08798, 0.117),
  ('window', 6, 'height', 1.476, 0.08805),
  ('window', 6, 'length', 0.1021, 0.1811),
  ('window', 6, 'rectangularity', 0.8092, 0.05985),
  ('window', 6, 'spread_length', 0.0506, 0.1729),
  ('window', 6, 'spread_width', -0.4041, 0.2507),
  ('window', 6, 'tilt_deg', 89.8, 0.45),
  ('window', 6, 'width', -0.2994, 0.2532),
  ('window', 6, 'z_max', 2.054, 0.1482),
  ('window', 6, 'z_min', 1.044, 0.06049);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.03415, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'area_m2', -2.079, 0.9896),
  ('window', 7, 'aspect', 1.106, 0.4198),
  ('window', 7, 'behind', 0.1015, 0.3284),
  ('window', 7, 'edge_free', 0.08937, 0.1505),
  ('window', 7, 'edge_free_top', 0.1595, 0.2592),
  ('window', 7, 'edge_joined', 0.5998, 0.2673),
  ('window', 7, 'edge_unseen', 0.1928, 0.1616),
  ('window', 7, 'height', 1.506, 0.2124),
  ('window', 7, 'length', -0.335, 0.6107),
  ('window', 7, 'rectangularity', 0.6861, 0.08281),
  ('window', 7, 'spread_length', -0.427, 0.7462),
  ('window', 7, 'spread_width', -1.638, 0.5732),
  ('window', 7, 'tilt_deg', 89.28, 1.003),
  ('window', 7, 'width', -1.398, 0.2335),
  ('window', 7, 'z_max', 1.951, 0.3144),
  ('window', 7, 'z_min', 1.143, 0.3326);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.04176, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'area_m2', -0.6918, 0.4512),
  ('window', 8, 'aspect', 0.8537, 0.3055),
  ('window', 8, 'behind', -0.001362, 0.03),
  ('window', 8, 'edge_free', 0.0862, 0.08912),
  ('window', 8, 'edge_free_top', 0.2763, 0.2579),
  ('window', 8, 'edge_joined', 0.258, 0.1555),
  ('window', 8, 'edge_unseen', 0.09198, 0.1134),
  ('window', 8, 'height', 1.136, 0.07051),
  ('window', 8, 'length', 0.2265, 0.2599),
  ('window', 8, 'rectangularity', 0.7853, 0.2182),
  ('window', 8, 'spread_length', 0.2877, 0.23),
  ('window', 8, 'spread_width', -0.6664, 0.2066),
  ('window', 8, 'tilt_deg', 89.24, 0.5261),
  ('window', 8, 'width', -0.6336, 0.1814),
  ('window', 8, 'z_max', 1.477, 0.09782),
  ('window', 8, 'z_min', 0.9202, 0.04951);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.02464, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'area_m2', 1.024, 0.481),
  ('window', 9, 'aspect', 0.6695, 0.2707),
  ('window', 9, 'behind', -0.0006426, 0.03),
  ('window', 9, 'edge_free', 0.002479, 0.03),
  ('window', 9, 'edge_free_top', 0.005845, 0.03),
  ('window', 9, 'edge_joined', 0.3078, 0.2775),
  ('window', 9, 'edge_unseen', 0.1709, 0.102),
  ('window', 9, 'height', 1.468, 0.07547),
  ('window', 9, 'length', 1.009, 0.3573),
  ('window', 9, 'rectangularity', 0.6908, 0.1735),
  ('window', 9, 'spread_length', 1.089, 0.1734),
  ('window', 9, 'spread_width', 0.1552, 0.1751),
  ('window', 9, 'tilt_deg', 89.83, 0.45),
  ('window', 9, 'width', 0.4133, 0.3271),
  ('window', 9, 'z_max', 2.332, 0.2804),
  ('window', 9, 'z_min', 0.7473, 0.2717);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.05329, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'area_m2', -1.425, 0.3342),
  ('window', 10, 'aspect', 1.426, 0.3123),
  ('window', 10, 'behind', -0.0003234, 0.03),
  ('window', 10, 'edge_free', 0.04942, 0.08902),
  ('window', 10, 'edge_free_top', 0.09919, 0.174),
  ('window', 10, 'edge_joined', 0.3718, 0.104),
  ('window', 10, 'edge_unseen', 0.04184, 0.05216),
  ('window', 10, 'height', 1.032, 0.0578),
  ('window', 10, 'length', 0.1375, 0.1439),
  ('window', 10, 'rectangularity', 0.7556, 0.1347),
  ('window', 10, 'spread_length', 0.1831, 0.1081),
  ('window', 10, 'spread_width', -1.445, 0.3201),
  ('window', 10, 'tilt_deg', 88.56, 1.017),
  ('window', 10, 'width', -1.299, 0.255),
  ('window', 10, 'z_max', 1.229, 0.08813),
  ('window', 10, 'z_min', 0.9242, 0.04311);

-- whiteboard: 253 examples
UPDATE object_class SET prior = 0.01072 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.0436, 0.8756)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4456, 0.3054)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.009392, 0.05882)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.02812, 0.05368)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.03806, 0.081)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_joined', 0.7741, 0.1974)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_unseen', 0.1536, 0.1856)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.4, 0.1537)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.3491, 0.4304)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.8216, 0.09934)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.2039, 0.4451)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.3231, 0.4723)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.79, 0.581)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', -0.1032, 0.4777)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 1.952, 0.2388)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.8696, 0.1926)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'whiteboard';
DELETE FROM class_density WHERE class = 'whiteboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.2255, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'area_m2', 0.2333, 0.1726),
  ('whiteboard', 1, 'aspect', 0.1843, 0.08176),
  ('whiteboard', 1, 'behind', 0.06399, 0.1623),
  ('whiteboard', 1, 'edge_free', 0.02229, 0.03),
  ('whiteboard', 1, 'edge_free_top', 0.02218, 0.03103),
  ('whiteboard', 1, 'edge_joined', 0.8277, 0.1031),
  ('whiteboard', 1, 'edge_unseen', 0.0006511, 0.03),
  ('whiteboard', 1, 'height', 1.495, 0.05784),
  ('whiteboard', 1, 'length', 0.2588, 0.114),
  ('whiteboard', 1, 'rectangularity', 0.8846, 0.04171),
  ('whiteboard', 1, 'spread_length', 0.1619, 0.09732),
  ('whiteboard', 1, 'spread_width', -0.03147, 0.07996),
  ('whiteboard', 1, 'tilt_deg', 90.09, 0.45),
  ('whiteboard', 1, 'width', 0.1109, 0.0605),
  ('whiteboard', 1, 'z_max', 2.03, 0.08971),
  ('whiteboard', 1, 'z_min', 0.9096, 0.04692);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.1395, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'area_m2', 0.4244, 0.1212),
  ('whiteboard', 2, 'aspect', 0.4546, 0.1274),
  ('whiteboard', 2, 'behind', -0.0002275, 0.03),
  ('whiteboard', 2, 'edge_free', 0.02722, 0.03),
  ('whiteboard', 2, 'edge_free_top', 0.03346, 0.04056),
  ('whiteboard', 2, 'edge_joined', 0.8052, 0.119),
  ('whiteboard', 2, 'edge_unseen', 0.1629, 0.1576),
  ('whiteboard', 2, 'height', 1.421, 0.07218),
  ('whiteboard', 2, 'length', 0.4966, 0.1185),
  ('whiteboard', 2, 'rectangularity', 0.8192, 0.08339),
  ('whiteboard', 2, 'spread_length', 0.3735, 0.08656),
  ('whiteboard', 2, 'spread_width', -0.1848, 0.1273),
  ('whiteboard', 2, 'tilt_deg', 90.07, 0.45),
  ('whiteboard', 2, 'width', 0.1314, 0.08704),
  ('whiteboard', 2, 'z_max', 1.997, 0.1097),
  ('whiteboard', 2, 'z_min', 0.8872, 0.06911);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.186, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'area_m2', 0.7523, 0.1235),
  ('whiteboard', 3, 'aspect', 0.6257, 0.1451),
  ('whiteboard', 3, 'behind', -0.0001056, 0.03),
  ('whiteboard', 3, 'edge_free', 0.03023, 0.03),
  ('whiteboard', 3, 'edge_free_top', 0.02941, 0.03602),
  ('whiteboard', 3, 'edge_joined', 0.877, 0.07876),
  ('whiteboard', 3, 'edge_unseen', 0.04496, 0.07965),
  ('whiteboard', 3, 'height', 1.439, 0.05951),
  ('whiteboard', 3, 'length', 0.7391, 0.1097),
  ('whiteboard', 3, 'rectangularity', 0.8782, 0.07003),
  ('whiteboard', 3, 'spread_length', 0.5872, 0.09412),
  ('whiteboard', 3, 'spread_width', -0.09553, 0.09974),
  ('whiteboard', 3, 'tilt_deg', 90.02, 0.45),
  ('whiteboard', 3, 'width', 0.1448, 0.0795),
  ('whiteboard', 3, 'z_max', 2.03, 0.09286),
  ('whiteboard', 3, 'z_min', 0.8928, 0.07006);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.108, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'area_m2', -0.2873, 0.3229),
  ('whiteboard', 4, 'aspect', 0.353, 0.3233),
  ('whiteboard', 4, 'behind', -0.00358, 0.03),
  ('whiteboard', 4, 'edge_free', 0.02864, 0.04019),
  ('whiteboard', 4, 'edge_free_top', 0.02482, 0.04196),
  ('whiteboard', 4, 'edge_joined', 0.7775, 0.1665),
  ('whiteboard', 4, 'edge_unseen', 0.29, 0.1917),
  ('whiteboard', 4, 'height', 1.373, 0.09329),
  ('whiteboard', 4, 'length', 0.144, 0.09359),
  ('whiteboard', 4, 'rectangularity', 0.7869, 0.05681),
  ('whiteboard', 4, 'spread_length', -0.08629, 0.1231),
  ('whiteboard', 4, 'spread_width', -0.5142, 0.1655),
  ('whiteboard', 4, 'tilt_deg', 90.05, 0.45),
  ('whiteboard', 4, 'width', -0.1753, 0.32),
  ('whiteboard', 4, 'z_max', 2.014, 0.09359),
  ('whiteboard', 4, 'z_min', 0.8721, 0.04434);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.09625, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'area_m2', 0.7327, 0.2768),
  ('whiteboard', 5, 'aspect', 0.6221, 0.203),
  ('whiteboard', 5, 'behind', 0.0001362, 0.03),
  ('whiteboard', 5, 'edge_free', 0.02369, 0.03),
  ('whiteboard', 5, 'edge_free_top', 0.0304, 0.03),
  ('whiteboard', 5, 'edge_joined', 0.6212, 0.1208),
  ('whiteboard', 5, 'edge_unseen', 0.1814, 0.1882),
  ('whiteboard', 5, 'height', 1.437, 0.09297),
  ('whiteboard', 5, 'length', 0.8455, 0.1704),
  ('whiteboard', 5, 'rectangularity', 0.6751, 0.07706),
  ('whiteboard', 5, 'spread_length', 0.6928, 0.1623),
  ('whiteboard', 5, 'spread_width', -0.132, 0.29),
  ('whiteboard', 5, 'tilt_deg', 89.88, 0.45),
  ('whiteboard', 5, 'width', 0.2959, 0.1471),
  ('whiteboard', 5, 'z_max', 2.077, 0.0928),
  ('whiteboard', 5, 'z_min', 0.6957, 0.2831);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.053, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'area_m2', -2.031, 0.7682),
  ('whiteboard', 6, 'aspect', 0.6585, 0.3203),
  ('whiteboard', 6, 'behind', -0.003731, 0.03),
  ('whiteboard', 6, 'edge_free', 0.01374, 0.04777),
  ('whiteboard', 6, 'edge_free_top', 0.00416, 0.03124),
  ('whiteboard', 6, 'edge_joined', 0.8327, 0.2382),
  ('whiteboard', 6, 'edge_unseen', 0.3861, 0.1523),
  ('whiteboard', 6, 'height', 1.249, 0.1664),
  ('whiteboard', 6, 'length', -0.4921, 0.4475),
  ('whiteboard', 6, 'rectangularity', 0.7531, 0.05952),
  ('whiteboard', 6, 'spread_length', -0.8405, 0.4321),
  ('whiteboard', 6, 'spread_width', -1.425, 0.3479),
  ('whiteboard', 6, 'tilt_deg', 89.61, 0.45),
  ('whiteboard', 6, 'width', -1.26, 0.4267),
  ('whiteboard', 6, 'z_max', 1.61, 0.4002),
  ('whiteboard', 6, 'z_min', 0.9279, 0.07033);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.09684, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'area_m2', -0.3442, 0.4108),
  ('whiteboard', 7, 'aspect', 0.8109, 0.4814),
  ('whiteboard', 7, 'behind', -0.000857, 0.03),
  ('whiteboard', 7, 'edge_free', 0.01188, 0.03),
  ('whiteboard', 7, 'edge_free_top', 0.06871, 0.03),
  ('whiteboard', 7, 'edge_joined', 0.5675, 0.165),
  ('whiteboard', 7, 'edge_unseen', 0.4096, 0.06811),
  ('whiteboard', 7, 'height', 1.033, 0.2375),
  ('whiteboard', 7, 'length', 0.2995, 0.3033),
  ('whiteboard', 7, 'rectangularity', 0.808, 0.07961),
  ('whiteboard', 7, 'spread_length', 0.244, 0.2617),
  ('whiteboard', 7, 'spread_width', -0.615, 0.3144),
  ('whiteboard', 7, 'tilt_deg', 87.97, 0.5378),
  ('whiteboard', 7, 'width', -0.4406, 0.313),
  ('whiteboard', 7, 'z_max', 1.336, 0.2527),
  ('whiteboard', 7, 'z_min', 0.5878, 0.3414);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.02704, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'area_m2', 0.1093, 0.399),
  ('whiteboard', 8, 'aspect', 0.3652, 0.1822),
  ('whiteboard', 8, 'behind', 0.004709, 0.03),
  ('whiteboard', 8, 'edge_free', 0.3329, 0.2234),
  ('whiteboard', 8, 'edge_free_top', 0.3322, 0.161),
  ('whiteboard', 8, 'edge_joined', 0.4694, 0.1524),
  ('whiteboard', 8, 'edge_unseen', 0.09866, 0.1131),
  ('whiteboard', 8, 'height', 1.385, 0.03685),
  ('whiteboard', 8, 'length', 0.4003, 0.2796),
  ('whiteboard', 8, 'rectangularity', 0.7195, 0.08891),
  ('whiteboard', 8, 'spread_length', 0.256, 0.332),
  ('whiteboard', 8, 'spread_width', -0.2924, 0.1725),
  ('whiteboard', 8, 'tilt_deg', 89.62, 0.6411),
  ('whiteboard', 8, 'width', 0.06153, 0.1811),
  ('whiteboard', 8, 'z_max', 1.935, 0.09524),
  ('whiteboard', 8, 'z_min', 0.7467, 0.1861);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 9, 0.01789, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 9, 'area_m2', -2.197, 1.093),
  ('whiteboard', 9, 'aspect', 0.3563, 0.2371),
  ('whiteboard', 9, 'behind', 0.05602, 0.09046),
  ('whiteboard', 9, 'edge_free', 0.08289, 0.07813),
  ('whiteboard', 9, 'edge_free_top', 0.2151, 0.1989),
  ('whiteboard', 9, 'edge_joined', 0.4959, 0.1065),
  ('whiteboard', 9, 'edge_unseen', 0.02981, 0.0463),
  ('whiteboard', 9, 'height', 1.79, 0.1483),
  ('whiteboard', 9, 'length', -0.7994, 0.5502),
  ('whiteboard', 9, 'rectangularity', 0.8007, 0.07033),
  ('whiteboard', 9, 'spread_length', -0.9063, 0.4874),
  ('whiteboard', 9, 'spread_width', -1.309, 0.5552),
  ('whiteboard', 9, 'tilt_deg', 84.52, 8.259),
  ('whiteboard', 9, 'width', -1.207, 0.5537),
  ('whiteboard', 9, 'z_max', 2.018, 0.07671),
  ('whiteboard', 9, 'z_min', 1.597, 0.2374);

-- shelf: 1281 examples
UPDATE object_class SET prior = 0.09723 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.583, 0.7849)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.9165, 0.4393)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5808, 0.3122)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3069, 0.1781)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4294, 0.3452)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_joined', 0.3637, 0.2876)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_unseen', 0.05169, 0.1078)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9223, 0.4868)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.1383, 0.5111)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6944, 0.132)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.2751, 0.5088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.262, 0.3889)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 45.55, 44.28)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.06, 0.3624)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.189, 0.6126)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.614, 0.5845)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'shelf';
DELETE FROM class_density WHERE class = 'shelf';
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.1496, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'area_m2', -1.331, 0.4663),
  ('shelf', 1, 'aspect', 0.8951, 0.3534),
  ('shelf', 1, 'behind', 0.7791, 0.1656),
  ('shelf', 1, 'edge_free', 0.3551, 0.1063),
  ('shelf', 1, 'edge_free_top', 0.4969, 0.3447),
  ('shelf', 1, 'edge_joined', 0.224, 0.3267),
  ('shelf', 1, 'edge_unseen', 0.1049, 0.1075),
  ('shelf', 1, 'height', 1.147, 0.205),
  ('shelf', 1, 'length', 0.05824, 0.3091),
  ('shelf', 1, 'rectangularity', 0.7447, 0.1253),
  ('shelf', 1, 'spread_length', -0.2152, 0.3469),
  ('shelf', 1, 'spread_width', -1.163, 0.2011),
  ('shelf', 1, 'tilt_deg', 90.16, 0.5051),
  ('shelf', 1, 'width', -0.952, 0.1292),
  ('shelf', 1, 'z_max', 1.699, 0.2283),
  ('shelf', 1, 'z_min', 0.3702, 0.1998);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.1755, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'area_m2', -1.401, 0.4125),
  ('shelf', 2, 'aspect', 0.8447, 0.2389),
  ('shelf', 2, 'behind', 0.7579, 0.09146),
  ('shelf', 2, 'edge_free', 0.2871, 0.1407),
  ('shelf', 2, 'edge_free_top', 0.4292, 0.1076),
  ('shelf', 2, 'edge_joined', 0.6151, 0.3029),
  ('shelf', 2, 'edge_unseen', 0.03785, 0.0947),
  ('shelf', 2, 'height', 1.62, 0.287),
  ('shelf', 2, 'length', -0.162, 0.2666),
  ('shelf', 2, 'rectangularity', 0.7798, 0.1027),
  ('shelf', 2, 'spread_length', -0.364, 0.2713),
  ('shelf', 2, 'spread_width', -1.022, 0.09726),
  ('shelf', 2, 'tilt_deg', 0.4651, 0.45),
  ('shelf', 2, 'width', -0.9325, 0.1074),
  ('shelf', 2, 'z_max', 1.568, 0.3198),
  ('shelf', 2, 'z_min', 1.575, 0.3104);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.1055, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'area_m2', -0.6209, 0.3217),
  ('shelf', 3, 'aspect', 1.532, 0.1477),
  ('shelf', 3, 'behind', 0.7577, 0.121),
  ('shelf', 3, 'edge_free', 0.3924, 0.06173),
  ('shelf', 3, 'edge_free_top', 0.4918, 0.2909),
  ('shelf', 3, 'edge_joined', 0.2737, 0.1985),
  ('shelf', 3, 'edge_unseen', 0.01072, 0.03),
  ('shelf', 3, 'height', 1.007, 0.1075),
  ('shelf', 3, 'length', 0.6122, 0.1294),
  ('shelf', 3, 'rectangularity', 0.7068, 0.1049),
  ('shelf', 3, 'spread_length', 0.4818, 0.1117),
  ('shelf', 3, 'spread_width', -1.049, 0.1512),
  ('shelf', 3, 'tilt_deg', 89.81, 1.746),
  ('shelf', 3, 'width', -0.8897, 0.1929),
  ('shelf', 3, 'z_max', 1.98, 0.132),
  ('shelf', 3, 'z_min', 0.08038, 0.1021);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.1298, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'area_m2', -1.742, 0.4132),
  ('shelf', 4, 'aspect', 1.049, 0.3598),
  ('shelf', 4, 'behind', 0.6907, 0.1363),
  ('shelf', 4, 'edge_free', 0.385, 0.06651),
  ('shelf', 4, 'edge_free_top', 0.4287, 0.1074),
  ('shelf', 4, 'edge_joined', 0.3985, 0.118),
  ('shelf', 4, 'edge_unseen', 0.01612, 0.0396),
  ('shelf', 4, 'height', 0.4683, 0.07155),
  ('shelf', 4, 'length', -0.1784, 0.2404),
  ('shelf', 4, 'rectangularity', 0.6828, 0.1009),
  ('shelf', 4, 'spread_length', -0.2556, 0.125),
  ('shelf', 4, 'spread_width', -1.429, 0.3344),
  ('shelf', 4, 'tilt_deg', 2.04, 1.315),
  ('shelf', 4, 'width', -1.082, 0.1511),
  ('shelf', 4, 'z_max', 0.4613, 0.06679),
  ('shelf', 4, 'z_min', 0.4716, 0.07765);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.06994, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'area_m2', -1.621, 0.4685),
  ('shelf', 5, 'aspect', 0.8752, 0.3409),
  ('shelf', 5, 'behind', 0.823, 0.05656),
  ('shelf', 5, 'edge_free', 0.2908, 0.1422),
  ('shelf', 5, 'edge_free_top', 0.4273, 0.1053),
  ('shelf', 5, 'edge_joined', 0.5948, 0.2391),
  ('shelf', 5, 'edge_unseen', 0.04819, 0.08171),
  ('shelf', 5, 'height', 0.8909, 0.1395),
  ('shelf', 5, 'length', -0.1617, 0.2655),
  ('shelf', 5, 'rectangularity', 0.6909, 0.1428),
  ('shelf', 5, 'spread_length', -0.3149, 0.1814),
  ('shelf', 5, 'spread_width', -1.352, 0.3038),
  ('shelf', 5, 'tilt_deg', 1.302, 0.8371),
  ('shelf', 5, 'width', -0.9872, 0.167),
  ('shelf', 5, 'z_max', 0.8524, 0.1258),
  ('shelf', 5, 'z_min', 0.8936, 0.1298);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.1193, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'area_m2', -1.142, 0.2792),
  ('shelf', 6, 'aspect', 1.182, 0.2214),
  ('shelf', 6, 'behind', 0.7978, 0.07438),
  ('shelf', 6, 'edge_free', 0.4368, 0.04241),
  ('shelf', 6, 'edge_free_top', 0.5994, 0.3098),
  ('shelf', 6, 'edge_joined', 0.1987, 0.1914),
  ('shelf', 6, 'edge_unseen', 0.005441, 0.03),
  ('shelf', 6, 'height', 0.6654, 0.1558),
  ('shelf', 6, 'length', 0.2141, 0.1396),
  ('shelf', 6, 'rectangularity', 0.7168, 0.1114),
  ('shelf', 6, 'spread_length', 0.02847, 0.1541),
  ('shelf', 6, 'spread_width', -1.111, 0.1367),
  ('shelf', 6, 'tilt_deg', 90.06, 0.7063),
  ('shelf', 6, 'width', -0.9972, 0.1793),
  ('shelf', 6, 'z_max', 1.25, 0.214),
  ('shelf', 6, 'z_min', 0.03008, 0.02753);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.07979, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'area_m2', -2.758, 0.441),
  ('shelf', 7, 'aspect', 0.787, 0.6875),
  ('shelf', 7, 'behind', 0.6199, 0.1659),
  ('shelf', 7, 'edge_free', 0.317, 0.1329),
  ('shelf', 7, 'edge_free_top', 0.5749, 0.3765),
  ('shelf', 7, 'edge_joined', 0.3665, 0.2303),
  ('shelf', 7, 'edge_unseen', 0.2665, 0.09139),
  ('shelf', 7, 'height', 0.9499, 0.464),
  ('shelf', 7, 'length', -0.7587, 0.3386),
  ('shelf', 7, 'rectangularity', 0.6193, 0.08922),
  ('shelf', 7, 'spread_length', -0.8793, 0.2328),
  ('shelf', 7, 'spread_width', -1.784, 0.2838),
  ('shelf', 7, 'tilt_deg', 6.213, 16.81),
  ('shelf', 7, 'width', -1.538, 0.4058),
  ('shelf', 7, 'z_max', 0.9381, 0.4943),
  ('shelf', 7, 'z_min', 0.9509, 0.4612);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.06976, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'area_m2', -2.139, 0.9521),
  ('shelf', 8, 'aspect', 0.3453, 0.3762),
  ('shelf', 8, 'behind', 0.01125, 0.03),
  ('shelf', 8, 'edge_free', 0.01649, 0.04059),
  ('shelf', 8, 'edge_free_top', 0.01214, 0.03),
  ('shelf', 8, 'edge_joined', 0.05948, 0.06475),
  ('shelf', 8, 'edge_unseen', -0.0005957, 0.03066),
  ('shelf', 8, 'height', 1.091, 0.4656),
  ('shelf', 8, 'length', -0.5486, 0.5403),
  ('shelf', 8, 'rectangularity', 0.6679, 0.1972),
  ('shelf', 8, 'spread_length', -0.5714, 0.5138),
  ('shelf', 8, 'spread_width', -1.186, 0.6971),
  ('shelf', 8, 'tilt_deg', 89.68, 1.049),
  ('shelf', 8, 'width', -1.152, 0.8059),
  ('shelf', 8, 'z_max', 1.176, 0.4799),
  ('shelf', 8, 'z_min', 0.4569, 0.2371);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.03326, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'area_m2', -2.24, 0.7101),
  ('shelf', 9, 'aspect', 0.5919, 0.5153),
  ('shelf', 9, 'behind', -0.006431, 0.03),
  ('shelf', 9, 'edge_free', 0.1867, 0.1421),
  ('shelf', 9, 'edge_free_top', 0.4297, 0.1088),
  ('shelf', 9, 'edge_joined', 0.3731, 0.2208),
  ('shelf', 9, 'edge_unseen', 0.04834, 0.1064),
  ('shelf', 9, 'height', 0.08393, 0.0225),
  ('shelf', 9, 'length', -0.6216, 0.5226),
  ('shelf', 9, 'rectangularity', 0.7058, 0.1117),
  ('shelf', 9, 'spread_length', -0.4361, 0.4172),
  ('shelf', 9, 'spread_width', -1.501, 0.2528),
  ('shelf', 9, 'tilt_deg', 0.7624, 1.33),
  ('shelf', 9, 'width', -1.259, 0.2829),
  ('shelf', 9, 'z_max', 0.09301, 0.0225),
  ('shelf', 9, 'z_min', 0.08763, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.01754, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'area_m2', -2.228, 0.3173),
  ('shelf', 10, 'aspect', 0.6041, 0.2804),
  ('shelf', 10, 'behind', 0.7414, 0.1729),
  ('shelf', 10, 'edge_free', 0.3123, 0.1129),
  ('shelf', 10, 'edge_free_top', 0.2957, 0.2599),
  ('shelf', 10, 'edge_joined', 0.2854, 0.3025),
  ('shelf', 10, 'edge_unseen', 0.006951, 0.03),
  ('shelf', 10, 'height', 0.6501, 0.5095),
  ('shelf', 10, 'length', -0.6481, 0.1794),
  ('shelf', 10, 'rectangularity', 0.7051, 0.08448),
  ('shelf', 10, 'spread_length', -0.834, 0.09274),
  ('shelf', 10, 'spread_width', -1.442, 0.2832),
  ('shelf', 10, 'tilt_deg', 89.57, 2.695),
  ('shelf', 10, 'width', -1.253, 0.2323),
  ('shelf', 10, 'z_max', 0.8181, 0.6378),
  ('shelf', 10, 'z_min', 0.2545, 0.4001);

-- cabinet: 1432 examples
UPDATE object_class SET prior = 0.1025 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.8719, 0.985)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6635, 0.4321)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.4908, 0.2446)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.3791, 0.2761)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.7426, 0.3275)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_joined', 0.2879, 0.308)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_unseen', 0.08673, 0.1629)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7987, 0.363)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.05881, 0.4993)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7404, 0.1333)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1138, 0.5061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.812, 0.5429)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 74.86, 33.3)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.6088, 0.5095)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.255, 0.5834)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2618, 0.3721)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'cabinet';
DELETE FROM class_density WHERE class = 'cabinet';
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.1054, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'area_m2', -0.6255, 0.6187),
  ('cabinet', 1, 'aspect', 0.706, 0.5974),
  ('cabinet', 1, 'behind', 0.2775, 0.1665),
  ('cabinet', 1, 'edge_free', 0.6139, 0.347),
  ('cabinet', 1, 'edge_free_top', 0.9873, 0.03),
  ('cabinet', 1, 'edge_joined', 0.05964, 0.1006),
  ('cabinet', 1, 'edge_unseen', 0.3695, 0.1992),
  ('cabinet', 1, 'height', 1.108, 0.2183),
  ('cabinet', 1, 'length', 0.2183, 0.3251),
  ('cabinet', 1, 'rectangularity', 0.6808, 0.1292),
  ('cabinet', 1, 'spread_length', -0.2921, 0.4809),
  ('cabinet', 1, 'spread_width', -0.8088, 0.8864),
  ('cabinet', 1, 'tilt_deg', 90.3, 0.45),
  ('cabinet', 1, 'width', -0.6127, 0.7157),
  ('cabinet', 1, 'z_max', 1.758, 0.4726),
  ('cabinet', 1, 'z_min', 0.2835, 0.1698);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.09589, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'area_m2', -0.3821, 0.3791),
  ('cabinet', 2, 'aspect', 0.5848, 0.2533),
  ('cabinet', 2, 'behind', 0.53, 0.1402),
  ('cabinet', 2, 'edge_free', 0.3529, 0.3104),
  ('cabinet', 2, 'edge_free_top', 0.9364, 0.119),
  ('cabinet', 2, 'edge_joined', 0.1682, 0.3079),
  ('cabinet', 2, 'edge_unseen', 0.001641, 0.03847),
  ('cabinet', 2, 'height', 0.5839, 0.1125),
  ('cabinet', 2, 'length', 0.1615, 0.1618),
  ('cabinet', 2, 'rectangularity', 0.8555, 0.147),
  ('cabinet', 2, 'spread_length', -0.0451, 0.1489),
  ('cabinet', 2, 'spread_width', -0.4547, 0.3953),
  ('cabinet', 2, 'tilt_deg', 90.18, 0.45),
  ('cabinet', 2, 'width', -0.4393, 0.2771),
  ('cabinet', 2, 'z_max', 1.134, 0.1371),
  ('cabinet', 2, 'z_min', -0.001909, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.1815, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'area_m2', -0.5665, 0.484),
  ('cabinet', 3, 'aspect', 0.5431, 0.3673),
  ('cabinet', 3, 'behind', 0.5096, 0.2262),
  ('cabinet', 3, 'edge_free', 0.2207, 0.127),
  ('cabinet', 3, 'edge_free_top', 0.7992, 0.1654),
  ('cabinet', 3, 'edge_joined', 0.3988, 0.2704),
  ('cabinet', 3, 'edge_unseen', 0.1039, 0.1684),
  ('cabinet', 3, 'height', 1.2, 0.2671),
  ('cabinet', 3, 'length', 0.2619, 0.3894),
  ('cabinet', 3, 'rectangularity', 0.7879, 0.1145),
  ('cabinet', 3, 'spread_length', -0.1319, 0.3456),
  ('cabinet', 3, 'spread_width', -0.6438, 0.1842),
  ('cabinet', 3, 'tilt_deg', 90.19, 0.45),
  ('cabinet', 3, 'width', -0.5286, 0.1361),
  ('cabinet', 3, 'z_max', 1.972, 0.1333),
  ('cabinet', 3, 'z_min', 0.4365, 0.174);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.09378, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'area_m2', -1.166, 0.2252),
  ('cabinet', 4, 'aspect', 0.3215, 0.3338),
  ('cabinet', 4, 'behind', 0.6063, 0.09284),
  ('cabinet', 4, 'edge_free', 0.2476, 0.2149),
  ('cabinet', 4, 'edge_free_top', 0.6062, 0.281),
  ('cabinet', 4, 'edge_joined', 0.2452, 0.2843),
  ('cabinet', 4, 'edge_unseen', 0.01646, 0.06259),
  ('cabinet', 4, 'height', 0.3438, 0.0324),
  ('cabinet', 4, 'length', -0.2627, 0.1534),
  ('cabinet', 4, 'rectangularity', 0.6597, 0.07727),
  ('cabinet', 4, 'spread_length', -0.5207, 0.05204),
  ('cabinet', 4, 'spread_width', -0.857, 0.258),
  ('cabinet', 4, 'tilt_deg', 90.05, 0.5294),
  ('cabinet', 4, 'width', -0.5558, 0.1725),
  ('cabinet', 4, 'z_max', 0.7332, 0.1169),
  ('cabinet', 4, 'z_min', -0.01302, 0.02252);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.1188, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'area_m2', 0.01496, 0.1751),
  ('cabinet', 5, 'aspect', 1.147, 0.193),
  ('cabinet', 5, 'behind', 0.5022, 0.1581),
  ('cabinet', 5, 'edge_free', 0.2452, 0.3499),
  ('cabinet', 5, 'edge_free_top', 0.8477, 0.1616),
  ('cabinet', 5, 'edge_joined', 0.4294, 0.3873),
  ('cabinet', 5, 'edge_unseen', -0.0008822, 0.03),
  ('cabinet', 5, 'height', 1.033, 0.1131),
  ('cabinet', 5, 'length', 0.6522, 0.1037),
  ('cabinet', 5, 'rectangularity', 0.8475, 0.07868),
  ('cabinet', 5, 'spread_length', 0.5064, 0.07056),
  ('cabinet', 5, 'spread_width', -0.698, 0.3611),
  ('cabinet', 5, 'tilt_deg', 90.02, 1.242),
  ('cabinet', 5, 'width', -0.4419, 0.1267),
  ('cabinet', 5, 'z_max', 1.911, 0.1987),
  ('cabinet', 5, 'z_min', 0.02217, 0.05663);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.09614, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'area_m2', -0.8677, 0.3735),
  ('cabinet', 6, 'aspect', 0.6741, 0.2759),
  ('cabinet', 6, 'behind', 0.688, 0.1069),
  ('cabinet', 6, 'edge_free', 0.1536, 0.1217),
  ('cabinet', 6, 'edge_free_top', 0.7428, 0.1028),
  ('cabinet', 6, 'edge_joined', 0.7745, 0.12),
  ('cabinet', 6, 'edge_unseen', 0.07421, 0.1479),
  ('cabinet', 6, 'height', 0.9294, 0.1547),
  ('cabinet', 6, 'length', 0.06619, 0.3296),
  ('cabinet', 6, 'rectangularity', 0.7011, 0.08115),
  ('cabinet', 6, 'spread_length', -0.2236, 0.306),
  ('cabinet', 6, 'spread_width', -0.6496, 0.1166),
  ('cabinet', 6, 'tilt_deg', -0.01604, 0.45),
  ('cabinet', 6, 'width', -0.5518, 0.0929),
  ('cabinet', 6, 'z_max', 0.9163, 0.1559),
  ('cabinet', 6, 'z_min', 0.9351, 0.1561);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.1161, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'area_m2', 0.4559, 0.2279),
  ('cabinet', 7, 'aspect', 0.6361, 0.298),
  ('cabinet', 7, 'behind', 0.2339, 0.07738),
  ('cabinet', 7, 'edge_free', 0.5385, 0.1793),
  ('cabinet', 7, 'edge_free_top', 0.9792, 0.03934),
  ('cabinet', 7, 'edge_joined', 0.04376, 0.06369),
  ('cabinet', 7, 'edge_unseen', 0.002564, 0.03),
  ('cabinet', 7, 'height', 1.063, 0.1334),
  ('cabinet', 7, 'length', 0.61, 0.08513),
  ('cabinet', 7, 'rectangularity', 0.8851, 0.0893),
  ('cabinet', 7, 'spread_length', 0.5015, 0.2212),
  ('cabinet', 7, 'spread_width', -0.2317, 0.1742),
  ('cabinet', 7, 'tilt_deg', 90.15, 0.9791),
  ('cabinet', 7, 'width', -0.06376, 0.197),
  ('cabinet', 7, 'z_max', 1.866, 0.1193),
  ('cabinet', 7, 'z_min', 0.003259, 0.07036);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.05966, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'area_m2', -2.173, 0.7495),
  ('cabinet', 8, 'aspect', 0.8025, 0.7423),
  ('cabinet', 8, 'behind', 0.5029, 0.2566),
  ('cabinet', 8, 'edge_free', 0.07897, 0.129),
  ('cabinet', 8, 'edge_free_top', 0.2293, 0.3478),
  ('cabinet', 8, 'edge_joined', 0.1281, 0.1446),
  ('cabinet', 8, 'edge_unseen', 0.005541, 0.03),
  ('cabinet', 8, 'height', 0.3294, 0.2087),
  ('cabinet', 8, 'length', -0.4523, 0.3986),
  ('cabinet', 8, 'rectangularity', 0.6812, 0.0924),
  ('cabinet', 8, 'spread_length', -0.4611, 0.4343),
  ('cabinet', 8, 'spread_width', -1.634, 0.2712),
  ('cabinet', 8, 'tilt_deg', 89.72, 1.021),
  ('cabinet', 8, 'width', -1.345, 0.3791),
  ('cabinet', 8, 'z_max', 0.6437, 0.3152),
  ('cabinet', 8, 'z_min', 0.07999, 0.1602);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.04528, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'area_m2', -2.739, 0.5792),
  ('cabinet', 9, 'aspect', 0.6896, 0.506),
  ('cabinet', 9, 'behind', 0.3156, 0.2436),
  ('cabinet', 9, 'edge_free', 0.4558, 0.3658),
  ('cabinet', 9, 'edge_free_top', 0.6684, 0.3571),
  ('cabinet', 9, 'edge_joined', 0.2435, 0.231),
  ('cabinet', 9, 'edge_unseen', 0.3369, 0.1313),
  ('cabinet', 9, 'height', 0.7477, 0.2694),
  ('cabinet', 9, 'length', -0.8008, 0.3848),
  ('cabinet', 9, 'rectangularity', 0.5843, 0.06642),
  ('cabinet', 9, 'spread_length', -0.7551, 0.1256),
  ('cabinet', 9, 'spread_width', -1.799, 0.3073),
  ('cabinet', 9, 'tilt_deg', 67.91, 46.51),
  ('cabinet', 9, 'width', -1.498, 0.3527),
  ('cabinet', 9, 'z_max', 0.8661, 0.1656),
  ('cabinet', 9, 'z_min', 0.5689, 0.4205);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.03751, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'area_m2', -2.225, 0.5675),
  ('cabinet', 10, 'aspect', 0.6297, 0.2814),
  ('cabinet', 10, 'behind', 0.7281, 0.1651),
  ('cabinet', 10, 'edge_free', 0.2448, 0.1651),
  ('cabinet', 10, 'edge_free_top', 0.7429, 0.1035),
  ('cabinet', 10, 'edge_joined', 0.2301, 0.09682),
  ('cabinet', 10, 'edge_unseen', 0.0063, 0.03796),
  ('cabinet', 10, 'height', 0.5825, 0.0225),
  ('cabinet', 10, 'length', -0.6265, 0.1835),
  ('cabinet', 10, 'rectangularity', 0.7128, 0.07629),
  ('cabinet', 10, 'spread_length', -0.8751, 0.197),
  ('cabinet', 10, 'spread_width', -1.515, 0.4775),
  ('cabinet', 10, 'tilt_deg', 1.293, 2.23),
  ('cabinet', 10, 'width', -1.294, 0.572),
  ('cabinet', 10, 'z_max', 0.585, 0.0225),
  ('cabinet', 10, 'z_min', 0.5788, 0.0225);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.398 WHERE name = 'aspect';
UPDATE feature SET weight = 0.499 WHERE name = 'behind';
UPDATE feature SET weight = 0.465 WHERE name = 'edge_free';
UPDATE feature SET weight = 0.259 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.191 WHERE name = 'edge_joined';
UPDATE feature SET weight = 0.277 WHERE name = 'edge_unseen';
UPDATE feature SET weight = 0.214 WHERE name = 'height';
UPDATE feature SET weight = 0 WHERE name = 'length';
UPDATE feature SET weight = 0.5 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.362 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.236 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.5 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.304 WHERE name = 'width';
UPDATE feature SET weight = 0.497 WHERE name = 'z_max';
UPDATE feature SET weight = 0.421 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.172 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0469 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0363 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.181 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0157 WHERE name = 'table';
UPDATE object_class SET prior = 0.0261 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.211 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.00274 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0533 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0112 WHERE name = 'door';
UPDATE object_class SET prior = 0.0269 WHERE name = 'window';
UPDATE object_class SET prior = 0.00618 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.089 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.122 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.67 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.328 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 1.39 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.67 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 2.99 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.52 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 0.098 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.38 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.921 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 0.463 WHERE name = 'wall_in_one_plane';
UPDATE class_constraint SET weight = 1.05 WHERE name = 'cabinet_off_wall';
UPDATE class_constraint SET weight = 1.27 WHERE name = 'window_off_wall';
UPDATE class_constraint SET weight = 2.19 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 2.13 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.57 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.521 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 0.354 WHERE name = 'screen_within_table';
UPDATE class_constraint SET weight = 1.5 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 3.3 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 4.06 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.38 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.897 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.02 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 1.36 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.958 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.09 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.41 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 3.74 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.42 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.91 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.23 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.87 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.73 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.171 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.24 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2405 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.866' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.213' WHERE key = 'probability_offset';
