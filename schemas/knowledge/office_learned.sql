-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 17465 planes of 180 paper-like rooms, seeds from 1; 90 at 2 cm, seeds from 10101; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 60 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 7095 examples
UPDATE object_class SET prior = 0.236 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.715, 0.5908)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4735, 0.2918)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'corner_offset', 0.8247, 1.283)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_concave', 0.3193, 0.326)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_convex', 0.1007, 0.1912)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.4455, 0.3163)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.565, 0.413)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_unseen', 0.05033, 0.1097)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'headroom', 0.8219, 0.854)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 1.041, 0.7339)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'lift', -3.503, 2.016)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.7256, 0.1459)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.5455, 0.7493)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.333, 0.6813)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'standoff', 0.4535, 0.3995)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 62.9, 39.63)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'wall_offset', 0.7842, 2.008)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.121, 0.6643)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.32, 0.9853)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7578, 0.7916)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
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
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'corner_offset';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'corner_offset', -2, -1.27192, 0.03264),
  ('unknown', 'corner_offset', -1.27192, -0.543831, 0.01331),
  ('unknown', 'corner_offset', -0.543831, -0.0887528, 0.1638),
  ('unknown', 'corner_offset', -0.0887528, 0.174128, 0.4328),
  ('unknown', 'corner_offset', 0.174128, 0.184253, 0.7083),
  ('unknown', 'corner_offset', 0.184253, 0.354988, 0.6151),
  ('unknown', 'corner_offset', 0.354988, 0.560599, 0.5391),
  ('unknown', 'corner_offset', 0.560599, 0.848794, 0.3857),
  ('unknown', 'corner_offset', 0.848794, 0.912338, 0.4161),
  ('unknown', 'corner_offset', 0.912338, 1.13318, 0.3832),
  ('unknown', 'corner_offset', 1.13318, 1.52917, 0.2792),
  ('unknown', 'corner_offset', 1.52917, 1.64042, 0.2279),
  ('unknown', 'corner_offset', 1.64042, 2.08682, 0.1917),
  ('unknown', 'corner_offset', 2.08682, 2.36851, 0.1118),
  ('unknown', 'corner_offset', 2.36851, 3.09659, 0.05448),
  ('unknown', 'corner_offset', 3.09659, 3.82468, 0.02647),
  ('unknown', 'corner_offset', 3.82468, 4.55276, 0.01613),
  ('unknown', 'corner_offset', 4.55276, 6, 0.006445);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_concave';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_concave', 0, 0.111111, 3.732),
  ('unknown', 'edge_concave', 0.111111, 0.1875, 0.4298),
  ('unknown', 'edge_concave', 0.1875, 0.222222, 0.6744),
  ('unknown', 'edge_concave', 0.222222, 0.333333, 0.5846),
  ('unknown', 'edge_concave', 0.333333, 0.34375, 1.552),
  ('unknown', 'edge_concave', 0.34375, 0.444444, 1.08),
  ('unknown', 'edge_concave', 0.444444, 0.46875, 0.6317),
  ('unknown', 'edge_concave', 0.46875, 0.555556, 0.7705),
  ('unknown', 'edge_concave', 0.555556, 0.59375, 0.8709),
  ('unknown', 'edge_concave', 0.59375, 0.666667, 0.7919),
  ('unknown', 'edge_concave', 0.666667, 0.777778, 0.4867),
  ('unknown', 'edge_concave', 0.777778, 0.78125, 0.2123),
  ('unknown', 'edge_concave', 0.78125, 0.888889, 0.2224),
  ('unknown', 'edge_concave', 0.888889, 1, 0.7851);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_convex';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_convex', 0, 0.0873611, 8.505),
  ('unknown', 'edge_convex', 0.0873611, 0.174722, 0.2952),
  ('unknown', 'edge_convex', 0.174722, 0.1875, 0.5819),
  ('unknown', 'edge_convex', 0.1875, 0.262083, 0.5292),
  ('unknown', 'edge_convex', 0.262083, 0.349444, 0.5599),
  ('unknown', 'edge_convex', 0.349444, 0.40625, 0.4255),
  ('unknown', 'edge_convex', 0.40625, 0.436806, 0.4259),
  ('unknown', 'edge_convex', 0.436806, 0.524167, 0.5072),
  ('unknown', 'edge_convex', 0.524167, 0.611528, 0.2449),
  ('unknown', 'edge_convex', 0.611528, 0.698889, 0.1963),
  ('unknown', 'edge_convex', 0.698889, 0.78625, 0.07342),
  ('unknown', 'edge_convex', 0.78625, 1, 0.04187);
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
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'headroom';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'headroom', -2, -0.287858, 0.004839),
  ('unknown', 'headroom', -0.287858, -0.0162393, 0.4376),
  ('unknown', 'headroom', -0.0162393, 0.0140559, 2.734),
  ('unknown', 'headroom', 0.0140559, 0.0484852, 0.7168),
  ('unknown', 'headroom', 0.0484852, 0.209428, 0.6156),
  ('unknown', 'headroom', 0.209428, 0.34723, 0.7965),
  ('unknown', 'headroom', 0.34723, 0.384828, 0.7686),
  ('unknown', 'headroom', 0.384828, 0.601054, 0.3848),
  ('unknown', 'headroom', 0.601054, 0.721171, 0.2344),
  ('unknown', 'headroom', 0.721171, 1.05751, 0.174),
  ('unknown', 'headroom', 1.05751, 1.19567, 0.1728),
  ('unknown', 'headroom', 1.19567, 1.39386, 0.1695),
  ('unknown', 'headroom', 1.39386, 1.7302, 0.2177),
  ('unknown', 'headroom', 1.7302, 1.743, 0.3596),
  ('unknown', 'headroom', 1.743, 2.06654, 0.3277),
  ('unknown', 'headroom', 2.06654, 2.09196, 0.242),
  ('unknown', 'headroom', 2.09196, 2.40289, 0.2317),
  ('unknown', 'headroom', 2.40289, 2.73923, 0.0908),
  ('unknown', 'headroom', 2.73923, 4, 0.006112);
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
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'lift';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'lift', 0.005, 0.00584348, 2.845),
  ('unknown', 'lift', 0.00584348, 0.00977613, 0.03033),
  ('unknown', 'lift', 0.00977613, 0.0191146, 0.1169),
  ('unknown', 'lift', 0.0191146, 0.0205563, 0.2234),
  ('unknown', 'lift', 0.0205563, 0.0373733, 0.08765),
  ('unknown', 'lift', 0.0373733, 0.067784, 0.1008),
  ('unknown', 'lift', 0.067784, 0.0730732, 0.1566),
  ('unknown', 'lift', 0.0730732, 0.142875, 0.06677),
  ('unknown', 'lift', 0.142875, 0.264735, 0.0882),
  ('unknown', 'lift', 0.264735, 0.279352, 0.1036),
  ('unknown', 'lift', 0.279352, 0.546197, 0.131),
  ('unknown', 'lift', 0.546197, 0.639009, 0.1258),
  ('unknown', 'lift', 0.639009, 1.06794, 0.08342),
  ('unknown', 'lift', 1.06794, 2.08806, 0.09103),
  ('unknown', 'lift', 2.08806, 2.5, 0.03215);
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
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'standoff';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'standoff', -0.05, -0.0154477, 0.143),
  ('unknown', 'standoff', -0.0154477, 0.0236913, 2.649),
  ('unknown', 'standoff', 0.0236913, 0.119544, 1.22),
  ('unknown', 'standoff', 0.119544, 0.149674, 2.768),
  ('unknown', 'standoff', 0.149674, 0.190514, 0.5726),
  ('unknown', 'standoff', 0.190514, 0.295621, 1.068),
  ('unknown', 'standoff', 0.295621, 0.314795, 1.124),
  ('unknown', 'standoff', 0.314795, 0.396584, 1.073),
  ('unknown', 'standoff', 0.396584, 0.479917, 0.8647),
  ('unknown', 'standoff', 0.479917, 0.532235, 0.7845),
  ('unknown', 'standoff', 0.532235, 0.645038, 0.6061),
  ('unknown', 'standoff', 0.645038, 0.757036, 0.3778),
  ('unknown', 'standoff', 0.757036, 0.81016, 0.4094),
  ('unknown', 'standoff', 0.81016, 0.975281, 0.3453),
  ('unknown', 'standoff', 0.975281, 1.07821, 0.3077),
  ('unknown', 'standoff', 1.07821, 1.1404, 0.3095),
  ('unknown', 'standoff', 1.1404, 1.30552, 0.3009),
  ('unknown', 'standoff', 1.30552, 1.47065, 0.2236),
  ('unknown', 'standoff', 1.47065, 1.5, 0.2054);
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
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'wall_offset';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'wall_offset', -2, -1.23731, 0.02294),
  ('unknown', 'wall_offset', -1.23731, -0.474623, 0.003855),
  ('unknown', 'wall_offset', -0.474623, 0.0156737, 0.1743),
  ('unknown', 'wall_offset', 0.0156737, 0.119794, 1.152),
  ('unknown', 'wall_offset', 0.119794, 0.239349, 0.9152),
  ('unknown', 'wall_offset', 0.239349, 0.288066, 0.7167),
  ('unknown', 'wall_offset', 0.288066, 0.414763, 0.584),
  ('unknown', 'wall_offset', 0.414763, 0.768599, 0.314),
  ('unknown', 'wall_offset', 0.768599, 1.05075, 0.2201),
  ('unknown', 'wall_offset', 1.05075, 1.26179, 0.2305),
  ('unknown', 'wall_offset', 1.26179, 1.7024, 0.2517),
  ('unknown', 'wall_offset', 1.7024, 1.81344, 0.2239),
  ('unknown', 'wall_offset', 1.81344, 2.36426, 0.1571),
  ('unknown', 'wall_offset', 2.36426, 2.57613, 0.1051),
  ('unknown', 'wall_offset', 2.57613, 3.33882, 0.0565),
  ('unknown', 'wall_offset', 3.33882, 4.10151, 0.03129),
  ('unknown', 'wall_offset', 4.10151, 4.8642, 0.01602),
  ('unknown', 'wall_offset', 4.8642, 6, 0.009066);
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.02678, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'aspect', 0.3999, 0.2483),
  ('unknown', 1, 'behind', 0.6872, 0.1118),
  ('unknown', 1, 'corner_offset', 1.656, 0.6048),
  ('unknown', 1, 'edge_concave', 0.4963, 0.1205),
  ('unknown', 1, 'edge_convex', 0.1867, 0.1487),
  ('unknown', 1, 'edge_free', 0.5485, 0.108),
  ('unknown', 1, 'edge_free_top', 0.8079, 0.2012),
  ('unknown', 1, 'edge_unseen', 0.002822, 0.03008),
  ('unknown', 1, 'headroom', 1.471, 1.315),
  ('unknown', 1, 'height', 0.1841, 0.02386),
  ('unknown', 1, 'lift', -3.511, 0.6505),
  ('unknown', 1, 'rectangularity', 0.7227, 0.1167),
  ('unknown', 1, 'spread_length', -1.165, 0.201),
  ('unknown', 1, 'spread_width', -1.769, 0.1783),
  ('unknown', 1, 'standoff', 0.6123, 0.1899),
  ('unknown', 1, 'tilt_deg', 88.94, 1.631),
  ('unknown', 1, 'wall_offset', 1.002, 0.3368),
  ('unknown', 1, 'width', -1.437, 0.26),
  ('unknown', 1, 'z_max', 0.3402, 0.04082),
  ('unknown', 1, 'z_min', -0.005259, 0.03907);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.04083, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'aspect', 0.3586, 0.2862),
  ('unknown', 2, 'behind', 0.6515, 0.1799),
  ('unknown', 2, 'corner_offset', 0.7876, 0.999),
  ('unknown', 2, 'edge_concave', 0.5449, 0.1919),
  ('unknown', 2, 'edge_convex', 0.2045, 0.1735),
  ('unknown', 2, 'edge_free', 0.4504, 0.1356),
  ('unknown', 2, 'edge_free_top', 0.6834, 0.2187),
  ('unknown', 2, 'edge_unseen', 0.006561, 0.03001),
  ('unknown', 2, 'headroom', 0.08448, 0.1284),
  ('unknown', 2, 'height', 0.2294, 0.04413),
  ('unknown', 2, 'lift', -3.518, 0.6463),
  ('unknown', 2, 'rectangularity', 0.4382, 0.1584),
  ('unknown', 2, 'spread_length', -0.7916, 0.1948),
  ('unknown', 2, 'spread_width', -1.331, 0.34),
  ('unknown', 2, 'standoff', 0.4833, 0.3519),
  ('unknown', 2, 'tilt_deg', 88.86, 1.231),
  ('unknown', 2, 'wall_offset', 1.524, 1.025),
  ('unknown', 2, 'width', -0.9432, 0.2369),
  ('unknown', 2, 'z_max', 0.4655, 0.07317),
  ('unknown', 2, 'z_min', -0.01795, 0.02813);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.01735, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'aspect', 1.707, 0.1698),
  ('unknown', 3, 'behind', 0.2728, 0.2865),
  ('unknown', 3, 'corner_offset', 0.8836, 0.4881),
  ('unknown', 3, 'edge_concave', 0.002718, 0.03005),
  ('unknown', 3, 'edge_convex', 0.06317, 0.158),
  ('unknown', 3, 'edge_free', 0.8789, 0.1427),
  ('unknown', 3, 'edge_free_top', 0.565, 0.1303),
  ('unknown', 3, 'edge_unseen', 0.01374, 0.03161),
  ('unknown', 3, 'headroom', 0.3347, 0.1317),
  ('unknown', 3, 'height', 2.546, 0.317),
  ('unknown', 3, 'lift', 0.44, 0.2713),
  ('unknown', 3, 'rectangularity', 0.8543, 0.05268),
  ('unknown', 3, 'spread_length', 0.232, 0.1292),
  ('unknown', 3, 'spread_width', -1.556, 0.05108),
  ('unknown', 3, 'standoff', 0.4534, 0.1268),
  ('unknown', 3, 'tilt_deg', 0.7869, 1.198),
  ('unknown', 3, 'wall_offset', 0.7988, 0.7878),
  ('unknown', 3, 'width', -1.45, 0.1087),
  ('unknown', 3, 'z_max', 2.559, 0.3353),
  ('unknown', 3, 'z_min', 2.56, 0.3325);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.0363, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'aspect', 0.9205, 0.3769),
  ('unknown', 4, 'behind', 0.618, 0.2208),
  ('unknown', 4, 'corner_offset', 1.123, 1.673),
  ('unknown', 4, 'edge_concave', 0.5157, 0.1141),
  ('unknown', 4, 'edge_convex', 0.2284, 0.1897),
  ('unknown', 4, 'edge_free', 0.4421, 0.3098),
  ('unknown', 4, 'edge_free_top', 0.4489, 0.2131),
  ('unknown', 4, 'edge_unseen', 0.06609, 0.07837),
  ('unknown', 4, 'headroom', 0.566, 0.9098),
  ('unknown', 4, 'height', 0.6739, 0.1196),
  ('unknown', 4, 'lift', -5.295, 0.03112),
  ('unknown', 4, 'rectangularity', 0.6323, 0.09512),
  ('unknown', 4, 'spread_length', -0.7637, 0.6743),
  ('unknown', 4, 'spread_width', -1.664, 0.3829),
  ('unknown', 4, 'standoff', 0.6243, 0.2311),
  ('unknown', 4, 'tilt_deg', 88.25, 1.891),
  ('unknown', 4, 'wall_offset', 1.992, 0.7037),
  ('unknown', 4, 'width', -1.399, 0.3499),
  ('unknown', 4, 'z_max', 0.972, 0.1924),
  ('unknown', 4, 'z_min', 0.4558, 0.3061);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.04502, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'aspect', 0.4157, 0.2629),
  ('unknown', 5, 'behind', 0.5797, 0.1838),
  ('unknown', 5, 'corner_offset', 1.46, 0.7011),
  ('unknown', 5, 'edge_concave', 0.4765, 0.1479),
  ('unknown', 5, 'edge_convex', 0.1969, 0.1825),
  ('unknown', 5, 'edge_free', 0.6409, 0.144),
  ('unknown', 5, 'edge_free_top', 0.9802, 0.03706),
  ('unknown', 5, 'edge_unseen', 0.005663, 0.03),
  ('unknown', 5, 'headroom', 1.054, 0.9785),
  ('unknown', 5, 'height', 0.8637, 0.02862),
  ('unknown', 5, 'lift', -5.235, 0.2084),
  ('unknown', 5, 'rectangularity', 0.7484, 0.1043),
  ('unknown', 5, 'spread_length', -1.289, 0.134),
  ('unknown', 5, 'spread_width', -1.52, 0.2258),
  ('unknown', 5, 'standoff', 0.8218, 0.3634),
  ('unknown', 5, 'tilt_deg', 81.79, 9.717),
  ('unknown', 5, 'wall_offset', 1.251, 0.7514),
  ('unknown', 5, 'width', -1.421, 0.1697),
  ('unknown', 5, 'z_max', 0.9912, 0.05708),
  ('unknown', 5, 'z_min', 0.7396, 0.06093);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.04145, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'aspect', 0.3465, 0.2359),
  ('unknown', 6, 'behind', 0.01106, 0.0301),
  ('unknown', 6, 'corner_offset', 1.338, 1.034),
  ('unknown', 6, 'edge_concave', 0.08762, 0.1691),
  ('unknown', 6, 'edge_convex', 0.007098, 0.08309),
  ('unknown', 6, 'edge_free', -0.008842, 0.03),
  ('unknown', 6, 'edge_free_top', 0.01135, 0.06093),
  ('unknown', 6, 'edge_unseen', 0.04114, 0.1127),
  ('unknown', 6, 'headroom', 0.9259, 0.2777),
  ('unknown', 6, 'height', 1.634, 0.08633),
  ('unknown', 6, 'lift', -1.102, 1.017),
  ('unknown', 6, 'rectangularity', 0.7968, 0.1095),
  ('unknown', 6, 'spread_length', -0.6168, 0.2231),
  ('unknown', 6, 'spread_width', -1.149, 0.3415),
  ('unknown', 6, 'standoff', 0.02296, 0.008891),
  ('unknown', 6, 'tilt_deg', 89.53, 1.05),
  ('unknown', 6, 'wall_offset', 0.06906, 0.04),
  ('unknown', 6, 'width', -0.8968, 0.4732),
  ('unknown', 6, 'z_max', 2.014, 0.1625),
  ('unknown', 6, 'z_min', 1.327, 0.06435);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.03384, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'aspect', 0.5312, 0.1924),
  ('unknown', 7, 'behind', 0.7266, 0.04845),
  ('unknown', 7, 'corner_offset', 0.1958, 0.09739),
  ('unknown', 7, 'edge_concave', 0.6479, 0.1489),
  ('unknown', 7, 'edge_convex', 0.0566, 0.09188),
  ('unknown', 7, 'edge_free', 0.3801, 0.1098),
  ('unknown', 7, 'edge_free_top', 0.5615, 0.1686),
  ('unknown', 7, 'edge_unseen', 0.005767, 0.03),
  ('unknown', 7, 'headroom', 0.6486, 0.5834),
  ('unknown', 7, 'height', 1.205, 0.2772),
  ('unknown', 7, 'lift', -3.207, 2.167),
  ('unknown', 7, 'rectangularity', 0.6549, 0.05261),
  ('unknown', 7, 'spread_length', -0.9727, 0.2562),
  ('unknown', 7, 'spread_width', -1.341, 0.1481),
  ('unknown', 7, 'standoff', 0.383, 0.2352),
  ('unknown', 7, 'tilt_deg', 88.91, 1.766),
  ('unknown', 7, 'wall_offset', 1.438, 0.4565),
  ('unknown', 7, 'width', -1.148, 0.2463),
  ('unknown', 7, 'z_max', 1.419, 0.2572),
  ('unknown', 7, 'z_min', 1.011, 0.1618);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.01986, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'aspect', 1.13, 0.4902),
  ('unknown', 8, 'behind', 0.6191, 0.201),
  ('unknown', 8, 'corner_offset', 1.021, 0.7602),
  ('unknown', 8, 'edge_concave', 0.3932, 0.3214),
  ('unknown', 8, 'edge_convex', -0.005322, 0.03003),
  ('unknown', 8, 'edge_free', 0.5445, 0.1397),
  ('unknown', 8, 'edge_free_top', 0.2288, 0.3915),
  ('unknown', 8, 'edge_unseen', 0.04869, 0.09709),
  ('unknown', 8, 'headroom', 0.205, 0.1648),
  ('unknown', 8, 'height', 0.3666, 0.07813),
  ('unknown', 8, 'lift', -4.902, 0.6319),
  ('unknown', 8, 'rectangularity', 0.6189, 0.2029),
  ('unknown', 8, 'spread_length', -0.6227, 0.7084),
  ('unknown', 8, 'spread_width', -2.013, 0.3461),
  ('unknown', 8, 'standoff', 0.5725, 0.5237),
  ('unknown', 8, 'tilt_deg', 87.95, 2.532),
  ('unknown', 8, 'wall_offset', 0.9567, 0.9176),
  ('unknown', 8, 'width', -1.605, 0.3099),
  ('unknown', 8, 'z_max', 0.5439, 0.2082),
  ('unknown', 8, 'z_min', 0.1038, 0.103);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.02822, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'aspect', 0.3145, 0.3873),
  ('unknown', 9, 'behind', 0.7327, 0.1318),
  ('unknown', 9, 'corner_offset', 1.091, 0.6415),
  ('unknown', 9, 'edge_concave', 0.4467, 0.06278),
  ('unknown', 9, 'edge_convex', 0.01334, 0.12),
  ('unknown', 9, 'edge_free', 0.4185, 0.2014),
  ('unknown', 9, 'edge_free_top', 0.4491, 0.4026),
  ('unknown', 9, 'edge_unseen', 0.006663, 0.03432),
  ('unknown', 9, 'headroom', -0.0216, 0.03656),
  ('unknown', 9, 'height', 0.3846, 0.07396),
  ('unknown', 9, 'lift', -3.507, 0.6511),
  ('unknown', 9, 'rectangularity', 0.5744, 0.1523),
  ('unknown', 9, 'spread_length', -0.2558, 0.08036),
  ('unknown', 9, 'spread_width', -0.8067, 0.605),
  ('unknown', 9, 'standoff', 0.5484, 0.296),
  ('unknown', 9, 'tilt_deg', 89.39, 1.511),
  ('unknown', 9, 'wall_offset', 1.953, 0.3609),
  ('unknown', 9, 'width', -0.4172, 0.3887),
  ('unknown', 9, 'z_max', 0.7387, 0.04889),
  ('unknown', 9, 'z_min', -0.0219, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.03334, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'aspect', 0.31, 0.17),
  ('unknown', 10, 'behind', 0.3007, 0.2305),
  ('unknown', 10, 'corner_offset', 0.674, 0.3376),
  ('unknown', 10, 'edge_concave', 0.1015, 0.1589),
  ('unknown', 10, 'edge_convex', 0.004323, 0.03),
  ('unknown', 10, 'edge_free', 0.3175, 0.3318),
  ('unknown', 10, 'edge_free_top', 0.5571, 0.1049),
  ('unknown', 10, 'edge_unseen', 0.00594, 0.03011),
  ('unknown', 10, 'headroom', 2.009, 0.198),
  ('unknown', 10, 'height', 0.7739, 0.08148),
  ('unknown', 10, 'lift', -3.883, 1.004),
  ('unknown', 10, 'rectangularity', 0.8367, 0.07217),
  ('unknown', 10, 'spread_length', -1.273, 0.1306),
  ('unknown', 10, 'spread_width', -1.498, 0.07434),
  ('unknown', 10, 'standoff', 0.4598, 0.1151),
  ('unknown', 10, 'tilt_deg', 0.4757, 0.8426),
  ('unknown', 10, 'wall_offset', 0.796, 0.7439),
  ('unknown', 10, 'width', -1.499, 0.1082),
  ('unknown', 10, 'z_max', 0.778, 0.09167),
  ('unknown', 10, 'z_min', 0.7693, 0.07992);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.01877, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'aspect', 1.068, 0.2647),
  ('unknown', 11, 'behind', 0.4596, 0.2106),
  ('unknown', 11, 'corner_offset', 1.784, 0.9587),
  ('unknown', 11, 'edge_concave', 0.4551, 0.2122),
  ('unknown', 11, 'edge_convex', 0.002728, 0.03312),
  ('unknown', 11, 'edge_free', 0.5715, 0.0659),
  ('unknown', 11, 'edge_free_top', 0.8256, 0.2266),
  ('unknown', 11, 'edge_unseen', 0.01828, 0.05023),
  ('unknown', 11, 'headroom', 1.49, 0.2434),
  ('unknown', 11, 'height', 0.9523, 0.07829),
  ('unknown', 11, 'lift', -5.299, 0.03121),
  ('unknown', 11, 'rectangularity', 0.7234, 0.1637),
  ('unknown', 11, 'spread_length', -0.2965, 0.9556),
  ('unknown', 11, 'spread_width', -1.241, 0.3274),
  ('unknown', 11, 'standoff', 0.2779, 0.2476),
  ('unknown', 11, 'tilt_deg', 90.05, 0.45),
  ('unknown', 11, 'wall_offset', 0.7641, 1.274),
  ('unknown', 11, 'width', -1.068, 0.3102),
  ('unknown', 11, 'z_max', 1.156, 0.09308),
  ('unknown', 11, 'z_min', 0.7891, 0.1236);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.01696, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'aspect', 1.46, 0.4947),
  ('unknown', 12, 'behind', 0.6552, 0.0811),
  ('unknown', 12, 'corner_offset', -0.08002, 0.07737),
  ('unknown', 12, 'edge_concave', 0.8627, 0.1788),
  ('unknown', 12, 'edge_convex', 0.0001807, 0.03),
  ('unknown', 12, 'edge_free', 0.1506, 0.146),
  ('unknown', 12, 'edge_free_top', 0.5654, 0.1299),
  ('unknown', 12, 'edge_unseen', 0.04988, 0.07029),
  ('unknown', 12, 'headroom', 0.5355, 0.2336),
  ('unknown', 12, 'height', 2.119, 0.1226),
  ('unknown', 12, 'lift', 0.1453, 0.1222),
  ('unknown', 12, 'rectangularity', 0.7266, 0.0863),
  ('unknown', 12, 'spread_length', -0.1824, 0.6176),
  ('unknown', 12, 'spread_width', -1.596, 0.2304),
  ('unknown', 12, 'standoff', 0.4537, 0.1267),
  ('unknown', 12, 'tilt_deg', 1.311, 1.906),
  ('unknown', 12, 'wall_offset', 0.8255, 0.7899),
  ('unknown', 12, 'width', -1.468, 0.22),
  ('unknown', 12, 'z_max', 2.117, 0.1192),
  ('unknown', 12, 'z_min', 2.11, 0.1148);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.0345, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'aspect', 1.608, 0.3912),
  ('unknown', 13, 'behind', 0.4466, 0.3071),
  ('unknown', 13, 'corner_offset', -0.1029, 0.04),
  ('unknown', 13, 'edge_concave', 0.9394, 0.1262),
  ('unknown', 13, 'edge_convex', 0.001833, 0.03006),
  ('unknown', 13, 'edge_free', 0.2009, 0.2203),
  ('unknown', 13, 'edge_free_top', 0.0322, 0.08741),
  ('unknown', 13, 'edge_unseen', 0.03825, 0.1364),
  ('unknown', 13, 'headroom', -0.003175, 0.1763),
  ('unknown', 13, 'height', 1.458, 0.1362),
  ('unknown', 13, 'lift', -5.084, 0.344),
  ('unknown', 13, 'rectangularity', 0.7618, 0.07095),
  ('unknown', 13, 'spread_length', -0.03344, 0.2662),
  ('unknown', 13, 'spread_width', -1.599, 0.3896),
  ('unknown', 13, 'standoff', 0.5095, 0.2017),
  ('unknown', 13, 'tilt_deg', 89.86, 0.5087),
  ('unknown', 13, 'wall_offset', 0.9392, 0.8246),
  ('unknown', 13, 'width', -1.413, 0.3384),
  ('unknown', 13, 'z_max', 2.072, 0.2038),
  ('unknown', 13, 'z_min', 0.8651, 0.1194);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.05094, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'aspect', 0.6994, 0.404),
  ('unknown', 14, 'behind', 0.7422, 0.07431),
  ('unknown', 14, 'corner_offset', 0.1903, 0.07918),
  ('unknown', 14, 'edge_concave', 0.3877, 0.1909),
  ('unknown', 14, 'edge_convex', 0.04497, 0.1218),
  ('unknown', 14, 'edge_free', 0.29, 0.1029),
  ('unknown', 14, 'edge_free_top', 0.5388, 0.1254),
  ('unknown', 14, 'edge_unseen', 0.05411, 0.06525),
  ('unknown', 14, 'headroom', 0.9247, 0.8804),
  ('unknown', 14, 'height', 0.9759, 0.3387),
  ('unknown', 14, 'lift', -1.362, 0.6151),
  ('unknown', 14, 'rectangularity', 0.6497, 0.1153),
  ('unknown', 14, 'spread_length', -0.2132, 0.3929),
  ('unknown', 14, 'spread_width', -0.9993, 0.4083),
  ('unknown', 14, 'standoff', 0.4346, 0.09852),
  ('unknown', 14, 'tilt_deg', 5.424, 1.509),
  ('unknown', 14, 'wall_offset', 1.057, 0.503),
  ('unknown', 14, 'width', -0.9492, 0.3055),
  ('unknown', 14, 'z_max', 1.058, 0.3564),
  ('unknown', 14, 'z_min', 0.9045, 0.4081);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.06377, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'aspect', 0.5341, 0.3722),
  ('unknown', 15, 'behind', 0.4299, 0.1364),
  ('unknown', 15, 'corner_offset', 1.27, 0.801),
  ('unknown', 15, 'edge_concave', 0.3948, 0.2117),
  ('unknown', 15, 'edge_convex', 0.007404, 0.03834),
  ('unknown', 15, 'edge_free', 0.5377, 0.2778),
  ('unknown', 15, 'edge_free_top', 0.4839, 0.3239),
  ('unknown', 15, 'edge_unseen', 0.003127, 0.03),
  ('unknown', 15, 'headroom', 1.515, 0.9961),
  ('unknown', 15, 'height', 0.5024, 0.1786),
  ('unknown', 15, 'lift', -2.152, 0.6469),
  ('unknown', 15, 'rectangularity', 0.6482, 0.1305),
  ('unknown', 15, 'spread_length', -0.3336, 0.4605),
  ('unknown', 15, 'spread_width', -1.085, 0.7301),
  ('unknown', 15, 'standoff', 0.1479, 0.2114),
  ('unknown', 15, 'tilt_deg', 85.09, 6.465),
  ('unknown', 15, 'wall_offset', 0.2101, 0.06232),
  ('unknown', 15, 'width', -0.8052, 0.6805),
  ('unknown', 15, 'z_max', 0.8211, 0.2702),
  ('unknown', 15, 'z_min', 0.1543, 0.1743);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.03195, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'aspect', 0.2718, 0.2494),
  ('unknown', 16, 'behind', 0.4345, 0.3136),
  ('unknown', 16, 'corner_offset', 0.6179, 0.4123),
  ('unknown', 16, 'edge_concave', 0.05158, 0.09536),
  ('unknown', 16, 'edge_convex', 0.4923, 0.152),
  ('unknown', 16, 'edge_free', 0.6413, 0.2323),
  ('unknown', 16, 'edge_free_top', 0.562, 0.1246),
  ('unknown', 16, 'edge_unseen', 0.004206, 0.03),
  ('unknown', 16, 'headroom', 2.122, 0.3817),
  ('unknown', 16, 'height', 0.7282, 0.2954),
  ('unknown', 16, 'lift', -1.676, 0.5278),
  ('unknown', 16, 'rectangularity', 0.83, 0.08878),
  ('unknown', 16, 'spread_length', -1.091, 0.1755),
  ('unknown', 16, 'spread_width', -1.388, 0.306),
  ('unknown', 16, 'standoff', 0.4522, 0.1175),
  ('unknown', 16, 'tilt_deg', 0.4914, 0.698),
  ('unknown', 16, 'wall_offset', 0.8375, 0.9119),
  ('unknown', 16, 'width', -1.282, 0.3499),
  ('unknown', 16, 'z_max', 0.7098, 0.2801),
  ('unknown', 16, 'z_min', 0.748, 0.3001);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.04971, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'aspect', 0.4869, 0.3352),
  ('unknown', 17, 'behind', 0.2635, 0.1221),
  ('unknown', 17, 'corner_offset', 1.657, 0.7472),
  ('unknown', 17, 'edge_concave', 0.5163, 0.1594),
  ('unknown', 17, 'edge_convex', 0.005106, 0.0301),
  ('unknown', 17, 'edge_free', 0.4915, 0.3089),
  ('unknown', 17, 'edge_free_top', 0.6847, 0.2896),
  ('unknown', 17, 'edge_unseen', 0.05212, 0.09262),
  ('unknown', 17, 'headroom', 0.5083, 0.6734),
  ('unknown', 17, 'height', 1.239, 0.2587),
  ('unknown', 17, 'lift', -3.65, 2.104),
  ('unknown', 17, 'rectangularity', 0.7129, 0.09891),
  ('unknown', 17, 'spread_length', -0.7734, 0.6398),
  ('unknown', 17, 'spread_width', -1.413, 0.7363),
  ('unknown', 17, 'standoff', 0.3209, 0.09123),
  ('unknown', 17, 'tilt_deg', 88.75, 0.8643),
  ('unknown', 17, 'wall_offset', 0.2241, 0.05281),
  ('unknown', 17, 'width', -1.187, 0.7369),
  ('unknown', 17, 'z_max', 1.561, 0.3343),
  ('unknown', 17, 'z_min', 0.8819, 0.3427);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.02889, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'aspect', 0.4381, 0.2386),
  ('unknown', 18, 'behind', 0.4414, 0.08965),
  ('unknown', 18, 'corner_offset', 1.396, 0.8787),
  ('unknown', 18, 'edge_concave', 0.05993, 0.09455),
  ('unknown', 18, 'edge_convex', 0.007481, 0.03084),
  ('unknown', 18, 'edge_free', 0.8339, 0.1427),
  ('unknown', 18, 'edge_free_top', 0.9844, 0.04371),
  ('unknown', 18, 'edge_unseen', 0.001847, 0.03),
  ('unknown', 18, 'headroom', 1.957, 0.2512),
  ('unknown', 18, 'height', 0.4873, 0.06083),
  ('unknown', 18, 'lift', -3.504, 0.6449),
  ('unknown', 18, 'rectangularity', 0.8271, 0.08965),
  ('unknown', 18, 'spread_length', -0.08032, 0.2862),
  ('unknown', 18, 'spread_width', -0.4888, 0.1129),
  ('unknown', 18, 'standoff', 0.1309, 0.0236),
  ('unknown', 18, 'tilt_deg', 89.72, 0.8142),
  ('unknown', 18, 'wall_offset', 0.1383, 0.04),
  ('unknown', 18, 'width', -0.3971, 0.2165),
  ('unknown', 18, 'z_max', 0.7842, 0.06954),
  ('unknown', 18, 'z_min', 0.06135, 0.06636);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.02212, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'aspect', 0.4432, 0.2763),
  ('unknown', 19, 'behind', 0.5677, 0.2372),
  ('unknown', 19, 'corner_offset', 0.7199, 0.7875),
  ('unknown', 19, 'edge_concave', 0.3838, 0.2153),
  ('unknown', 19, 'edge_convex', 0.159, 0.1783),
  ('unknown', 19, 'edge_free', 0.5137, 0.1709),
  ('unknown', 19, 'edge_free_top', 0.8214, 0.2535),
  ('unknown', 19, 'edge_unseen', 0.001374, 0.03),
  ('unknown', 19, 'headroom', 0.5821, 0.3303),
  ('unknown', 19, 'height', 1.874, 0.1516),
  ('unknown', 19, 'lift', -3.769, 1.755),
  ('unknown', 19, 'rectangularity', 0.6794, 0.1696),
  ('unknown', 19, 'spread_length', -1.238, 0.2643),
  ('unknown', 19, 'spread_width', -1.626, 0.2698),
  ('unknown', 19, 'standoff', 0.5806, 0.2537),
  ('unknown', 19, 'tilt_deg', 89.16, 1.258),
  ('unknown', 19, 'wall_offset', 1.142, 0.9046),
  ('unknown', 19, 'width', -1.4, 0.3013),
  ('unknown', 19, 'z_max', 2.06, 0.1629),
  ('unknown', 19, 'z_min', 1.661, 0.1496);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.02955, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'aspect', 0.9748, 0.396),
  ('unknown', 20, 'behind', 0.3156, 0.296),
  ('unknown', 20, 'corner_offset', 0.7959, 0.5071),
  ('unknown', 20, 'edge_concave', 0.01945, 0.05554),
  ('unknown', 20, 'edge_convex', 0.09399, 0.1835),
  ('unknown', 20, 'edge_free', 0.9368, 0.112),
  ('unknown', 20, 'edge_free_top', 0.5656, 0.1311),
  ('unknown', 20, 'edge_unseen', 0.1991, 0.1143),
  ('unknown', 20, 'headroom', 0.3034, 0.1266),
  ('unknown', 20, 'height', 2.531, 0.2683),
  ('unknown', 20, 'lift', 0.6356, 0.2411),
  ('unknown', 20, 'rectangularity', 0.732, 0.1153),
  ('unknown', 20, 'spread_length', -0.5419, 0.5594),
  ('unknown', 20, 'spread_width', -1.619, 0.1072),
  ('unknown', 20, 'standoff', 0.4542, 0.1257),
  ('unknown', 20, 'tilt_deg', 1.606, 1.619),
  ('unknown', 20, 'wall_offset', 0.8013, 0.7621),
  ('unknown', 20, 'width', -1.475, 0.1554),
  ('unknown', 20, 'z_max', 2.542, 0.2704),
  ('unknown', 20, 'z_min', 2.54, 0.2647);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.02709, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'aspect', 0.4673, 0.3375),
  ('unknown', 21, 'behind', 0.4936, 0.2223),
  ('unknown', 21, 'corner_offset', 1.397, 0.9258),
  ('unknown', 21, 'edge_concave', 0.1555, 0.1859),
  ('unknown', 21, 'edge_convex', 0.1921, 0.1406),
  ('unknown', 21, 'edge_free', 0.7919, 0.07305),
  ('unknown', 21, 'edge_free_top', 0.9726, 0.04804),
  ('unknown', 21, 'edge_unseen', 0.1374, 0.1475),
  ('unknown', 21, 'headroom', 0.4925, 0.8694),
  ('unknown', 21, 'height', 0.5345, 0.04454),
  ('unknown', 21, 'lift', -4.623, 0.6542),
  ('unknown', 21, 'rectangularity', 0.6568, 0.1035),
  ('unknown', 21, 'spread_length', -0.3224, 0.4083),
  ('unknown', 21, 'spread_width', -0.8685, 0.4148),
  ('unknown', 21, 'standoff', 0.1619, 0.1968),
  ('unknown', 21, 'tilt_deg', 89.19, 1.147),
  ('unknown', 21, 'wall_offset', 2.243, 0.7713),
  ('unknown', 21, 'width', -0.6081, 0.3588),
  ('unknown', 21, 'z_max', 0.7724, 0.04893),
  ('unknown', 21, 'z_min', 0.1662, 0.1282);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.0181, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'aspect', 0.863, 0.7832),
  ('unknown', 22, 'behind', 0.538, 0.363),
  ('unknown', 22, 'corner_offset', 0.4183, 0.4803),
  ('unknown', 22, 'edge_concave', 0.5065, 0.3578),
  ('unknown', 22, 'edge_convex', 0.07062, 0.1027),
  ('unknown', 22, 'edge_free', 0.3326, 0.2366),
  ('unknown', 22, 'edge_free_top', 0.277, 0.1869),
  ('unknown', 22, 'edge_unseen', 0.02442, 0.06493),
  ('unknown', 22, 'headroom', 0.1008, 0.7492),
  ('unknown', 22, 'height', 1.152, 0.2597),
  ('unknown', 22, 'lift', -4.282, 1.434),
  ('unknown', 22, 'rectangularity', 0.3836, 0.2084),
  ('unknown', 22, 'spread_length', 0.5603, 0.1812),
  ('unknown', 22, 'spread_width', -0.382, 1.058),
  ('unknown', 22, 'standoff', 0.3489, 0.6981),
  ('unknown', 22, 'tilt_deg', 88.96, 1.224),
  ('unknown', 22, 'wall_offset', 1.198, 1.191),
  ('unknown', 22, 'width', -0.4383, 0.8913),
  ('unknown', 22, 'z_max', 1.986, 0.2677),
  ('unknown', 22, 'z_min', 0.03823, 0.1124);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.006377, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'aspect', 0.8429, 0.4847),
  ('unknown', 23, 'behind', 0.5101, 0.2228),
  ('unknown', 23, 'corner_offset', 0.9778, 1.342),
  ('unknown', 23, 'edge_concave', 0.4752, 0.2266),
  ('unknown', 23, 'edge_convex', 0.1014, 0.1841),
  ('unknown', 23, 'edge_free', 0.4652, 0.3251),
  ('unknown', 23, 'edge_free_top', 0.6869, 0.3508),
  ('unknown', 23, 'edge_unseen', 0.222, 0.1745),
  ('unknown', 23, 'headroom', 0.4776, 0.5621),
  ('unknown', 23, 'height', 1.708, 0.7051),
  ('unknown', 23, 'lift', -2.293, 2.299),
  ('unknown', 23, 'rectangularity', 0.6029, 0.2452),
  ('unknown', 23, 'spread_length', -0.6463, 0.8203),
  ('unknown', 23, 'spread_width', -1.701, 0.4787),
  ('unknown', 23, 'standoff', 0.543, 0.3581),
  ('unknown', 23, 'tilt_deg', 45.96, 27.03),
  ('unknown', 23, 'wall_offset', 1.616, 1.11),
  ('unknown', 23, 'width', -1.367, 0.6651),
  ('unknown', 23, 'z_max', 1.858, 0.7898),
  ('unknown', 23, 'z_min', 1.557, 0.7626);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.02007, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'aspect', 0.1697, 0.1101),
  ('unknown', 24, 'behind', 0.4486, 0.198),
  ('unknown', 24, 'corner_offset', 1.79, 0.8761),
  ('unknown', 24, 'edge_concave', 0.002188, 0.03001),
  ('unknown', 24, 'edge_convex', 0.1995, 0.254),
  ('unknown', 24, 'edge_free', 0.8097, 0.2501),
  ('unknown', 24, 'edge_free_top', 0.9482, 0.1156),
  ('unknown', 24, 'edge_unseen', 0.1795, 0.1217),
  ('unknown', 24, 'headroom', 1.418, 0.3585),
  ('unknown', 24, 'height', 0.8759, 0.1354),
  ('unknown', 24, 'lift', -1.985, 0.9065),
  ('unknown', 24, 'rectangularity', 0.7647, 0.04908),
  ('unknown', 24, 'spread_length', -1.052, 0.3441),
  ('unknown', 24, 'spread_width', -1.451, 0.5237),
  ('unknown', 24, 'standoff', 0.2418, 0.2171),
  ('unknown', 24, 'tilt_deg', 63.52, 27.6),
  ('unknown', 24, 'wall_offset', 1.182, 0.3441),
  ('unknown', 24, 'width', -1.251, 0.5127),
  ('unknown', 24, 'z_max', 1.138, 0.104),
  ('unknown', 24, 'z_min', 0.6095, 0.07669);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.01302, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'aspect', 0.4789, 0.3464),
  ('unknown', 25, 'behind', 0.4412, 0.2187),
  ('unknown', 25, 'corner_offset', 0.8863, 0.8323),
  ('unknown', 25, 'edge_concave', 0.2331, 0.218),
  ('unknown', 25, 'edge_convex', 0.001043, 0.03004),
  ('unknown', 25, 'edge_free', 0.5772, 0.1779),
  ('unknown', 25, 'edge_free_top', 0.6498, 0.3822),
  ('unknown', 25, 'edge_unseen', 0.002002, 0.03),
  ('unknown', 25, 'headroom', 1.401, 0.86),
  ('unknown', 25, 'height', 0.7836, 0.3431),
  ('unknown', 25, 'lift', -2.767, 1.401),
  ('unknown', 25, 'rectangularity', 0.7677, 0.1196),
  ('unknown', 25, 'spread_length', -1.642, 0.259),
  ('unknown', 25, 'spread_width', -2.103, 0.344),
  ('unknown', 25, 'standoff', 0.2756, 0.2394),
  ('unknown', 25, 'tilt_deg', 42.21, 26.62),
  ('unknown', 25, 'wall_offset', 1.206, 1.156),
  ('unknown', 25, 'width', -1.981, 0.3297),
  ('unknown', 25, 'z_max', 0.8648, 0.3502),
  ('unknown', 25, 'z_min', 0.7408, 0.3534);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.01465, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'aspect', 0.2672, 0.2626),
  ('unknown', 26, 'behind', 0.1574, 0.1451),
  ('unknown', 26, 'corner_offset', 0.4688, 0.534),
  ('unknown', 26, 'edge_concave', 0.005068, 0.03068),
  ('unknown', 26, 'edge_convex', -0.0004003, 0.03),
  ('unknown', 26, 'edge_free', 0.4366, 0.4382),
  ('unknown', 26, 'edge_free_top', 0.5652, 0.1233),
  ('unknown', 26, 'edge_unseen', -0.00345, 0.03),
  ('unknown', 26, 'headroom', 2.005, 0.1532),
  ('unknown', 26, 'height', 0.7846, 0.08562),
  ('unknown', 26, 'lift', -3.338, 1.055),
  ('unknown', 26, 'rectangularity', 0.7794, 0.05319),
  ('unknown', 26, 'spread_length', -1.757, 0.1809),
  ('unknown', 26, 'spread_width', -1.924, 0.1641),
  ('unknown', 26, 'standoff', 0.4582, 0.1184),
  ('unknown', 26, 'tilt_deg', 4.345, 7.967),
  ('unknown', 26, 'wall_offset', 0.8118, 0.8255),
  ('unknown', 26, 'width', -1.853, 0.1661),
  ('unknown', 26, 'z_max', 0.7836, 0.08223),
  ('unknown', 26, 'z_min', 0.7806, 0.08891);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.02259, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'aspect', 1.492, 0.4558),
  ('unknown', 27, 'behind', 0.6509, 0.1058),
  ('unknown', 27, 'corner_offset', 0.2523, 0.6915),
  ('unknown', 27, 'edge_concave', 0.8548, 0.1951),
  ('unknown', 27, 'edge_convex', 0.0007524, 0.03),
  ('unknown', 27, 'edge_free', 0.07966, 0.1568),
  ('unknown', 27, 'edge_free_top', 0.565, 0.1303),
  ('unknown', 27, 'edge_unseen', 0.108, 0.1296),
  ('unknown', 27, 'headroom', 1.203, 0.1364),
  ('unknown', 27, 'height', 0.9059, 0.06504),
  ('unknown', 27, 'lift', -2.768, 0.4653),
  ('unknown', 27, 'rectangularity', 0.7173, 0.09482),
  ('unknown', 27, 'spread_length', -0.07601, 0.5483),
  ('unknown', 27, 'spread_width', -1.458, 0.2252),
  ('unknown', 27, 'standoff', 0.4537, 0.1255),
  ('unknown', 27, 'tilt_deg', 1.473, 1.429),
  ('unknown', 27, 'wall_offset', 0.8236, 0.783),
  ('unknown', 27, 'width', -1.395, 0.2091),
  ('unknown', 27, 'z_max', 0.9083, 0.06113),
  ('unknown', 27, 'z_min', 0.9006, 0.0682);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.02061, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'aspect', 0.8511, 0.446),
  ('unknown', 28, 'behind', 0.4342, 0.3045),
  ('unknown', 28, 'corner_offset', 1.377, 1.081),
  ('unknown', 28, 'edge_concave', 0.0004321, 0.03002),
  ('unknown', 28, 'edge_convex', 0.5718, 0.2608),
  ('unknown', 28, 'edge_free', 0.737, 0.1671),
  ('unknown', 28, 'edge_free_top', 0.6124, 0.3867),
  ('unknown', 28, 'edge_unseen', 0.009398, 0.03001),
  ('unknown', 28, 'headroom', 1.824, 0.4192),
  ('unknown', 28, 'height', 0.4675, 0.06534),
  ('unknown', 28, 'lift', -5.213, 0.2502),
  ('unknown', 28, 'rectangularity', 0.726, 0.1083),
  ('unknown', 28, 'spread_length', -0.9096, 0.2814),
  ('unknown', 28, 'spread_width', -1.885, 0.5888),
  ('unknown', 28, 'standoff', 0.5918, 0.5071),
  ('unknown', 28, 'tilt_deg', 85.08, 5.025),
  ('unknown', 28, 'wall_offset', 1.374, 0.6444),
  ('unknown', 28, 'width', -1.665, 0.4626),
  ('unknown', 28, 'z_max', 0.5929, 0.0815),
  ('unknown', 28, 'z_min', 0.362, 0.04032);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.01379, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'aspect', 0.6001, 0.2429),
  ('unknown', 29, 'behind', 0.5904, 0.233),
  ('unknown', 29, 'corner_offset', 1.253, 0.9876),
  ('unknown', 29, 'edge_concave', 0.5035, 0.1627),
  ('unknown', 29, 'edge_convex', 0.01449, 0.03467),
  ('unknown', 29, 'edge_free', 0.2691, 0.2032),
  ('unknown', 29, 'edge_free_top', 0.2792, 0.1928),
  ('unknown', 29, 'edge_unseen', 0.06911, 0.07351),
  ('unknown', 29, 'headroom', -0.04863, 0.1688),
  ('unknown', 29, 'height', 0.5476, 0.1752),
  ('unknown', 29, 'lift', -4.349, 1.021),
  ('unknown', 29, 'rectangularity', 0.546, 0.1259),
  ('unknown', 29, 'spread_length', -0.228, 0.3493),
  ('unknown', 29, 'spread_width', -0.9317, 0.3162),
  ('unknown', 29, 'standoff', 0.5456, 0.1669),
  ('unknown', 29, 'tilt_deg', 86.6, 1.184),
  ('unknown', 29, 'wall_offset', 1.568, 1.225),
  ('unknown', 29, 'width', -0.6112, 0.2452),
  ('unknown', 29, 'z_max', 0.9145, 0.1546),
  ('unknown', 29, 'z_min', 0.1222, 0.1601);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.02092, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'aspect', 0.688, 0.7198),
  ('unknown', 30, 'behind', 0.002309, 0.03),
  ('unknown', 30, 'corner_offset', -3.497, 4.474),
  ('unknown', 30, 'edge_concave', 9.499e-06, 0.03),
  ('unknown', 30, 'edge_convex', 0.0005551, 0.03),
  ('unknown', 30, 'edge_free', 0.005258, 0.03),
  ('unknown', 30, 'edge_free_top', 0.006803, 0.03),
  ('unknown', 30, 'edge_unseen', 0.1355, 0.1289),
  ('unknown', 30, 'headroom', 0.8333, 0.2464),
  ('unknown', 30, 'height', 2.188, 1.038),
  ('unknown', 30, 'lift', -3.509, 0.617),
  ('unknown', 30, 'rectangularity', 0.8177, 0.1474),
  ('unknown', 30, 'spread_length', 1.831, 0.4783),
  ('unknown', 30, 'spread_width', 1.192, 0.6399),
  ('unknown', 30, 'standoff', 0.4535, 0.1262),
  ('unknown', 30, 'tilt_deg', 89.88, 0.8447),
  ('unknown', 30, 'wall_offset', -11.67, 6.094),
  ('unknown', 30, 'width', 1.245, 0.7115),
  ('unknown', 30, 'z_max', 5.75, 2.533),
  ('unknown', 30, 'z_min', -0.8738, 1.565);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.04329, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'aspect', 0.8416, 0.9146),
  ('unknown', 31, 'behind', 0.02876, 0.03178),
  ('unknown', 31, 'corner_offset', -1.391, 2.671),
  ('unknown', 31, 'edge_concave', 0.009213, 0.03001),
  ('unknown', 31, 'edge_convex', 2.932e-05, 0.03012),
  ('unknown', 31, 'edge_free', 0.01776, 0.06059),
  ('unknown', 31, 'edge_free_top', 0.01363, 0.04536),
  ('unknown', 31, 'edge_unseen', 0.001988, 0.03),
  ('unknown', 31, 'headroom', 0.6346, 0.3216),
  ('unknown', 31, 'height', 1.597, 0.5704),
  ('unknown', 31, 'lift', -3.87, 0.7683),
  ('unknown', 31, 'rectangularity', 0.832, 0.1308),
  ('unknown', 31, 'spread_length', 1.435, 0.4623),
  ('unknown', 31, 'spread_width', 0.8025, 0.3533),
  ('unknown', 31, 'standoff', 0.05099, 0.03773),
  ('unknown', 31, 'tilt_deg', 89.75, 0.5633),
  ('unknown', 31, 'wall_offset', 0.01589, 0.04487),
  ('unknown', 31, 'width', 0.8288, 0.5473),
  ('unknown', 31, 'z_max', 3.251, 1.987),
  ('unknown', 31, 'z_min', -0.4269, 0.5208);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.0053, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'aspect', 0.985, 0.9812),
  ('unknown', 32, 'behind', 0.0282, 0.05027),
  ('unknown', 32, 'corner_offset', 1.503, 1.776),
  ('unknown', 32, 'edge_concave', 0.2504, 0.3162),
  ('unknown', 32, 'edge_convex', 0.001014, 0.04137),
  ('unknown', 32, 'edge_free', 0.03775, 0.07621),
  ('unknown', 32, 'edge_free_top', 0.04093, 0.08054),
  ('unknown', 32, 'edge_unseen', 0.1239, 0.09792),
  ('unknown', 32, 'headroom', 0.724, 0.3077),
  ('unknown', 32, 'height', 1.471, 0.2398),
  ('unknown', 32, 'lift', -3.16, 1.808),
  ('unknown', 32, 'rectangularity', 0.6654, 0.1004),
  ('unknown', 32, 'spread_length', -0.4246, 0.6261),
  ('unknown', 32, 'spread_width', -1.487, 0.6438),
  ('unknown', 32, 'standoff', 0.02619, 0.02842),
  ('unknown', 32, 'tilt_deg', 89.6, 2.272),
  ('unknown', 32, 'wall_offset', 2.027, 0.6852),
  ('unknown', 32, 'width', -1.246, 0.473),
  ('unknown', 32, 'z_max', 2.038, 0.1375),
  ('unknown', 32, 'z_min', 1.01, 0.3943);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.007346, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'aspect', 0.6416, 0.2074),
  ('unknown', 33, 'behind', 0.7275, 0.05114),
  ('unknown', 33, 'corner_offset', 0.7304, 0.2729),
  ('unknown', 33, 'edge_concave', 0.185, 0.2695),
  ('unknown', 33, 'edge_convex', 0.4332, 0.1535),
  ('unknown', 33, 'edge_free', 0.5843, 0.2326),
  ('unknown', 33, 'edge_free_top', 0.5651, 0.1303),
  ('unknown', 33, 'edge_unseen', 0.0007461, 0.03),
  ('unknown', 33, 'headroom', 0.2938, 0.03),
  ('unknown', 33, 'height', 0.4301, 0.0225),
  ('unknown', 33, 'lift', -3.503, 0.6346),
  ('unknown', 33, 'rectangularity', 0.7514, 0.1306),
  ('unknown', 33, 'spread_length', -0.8462, 0.3209),
  ('unknown', 33, 'spread_width', -1.61, 0.1034),
  ('unknown', 33, 'standoff', 0.4535, 0.1266),
  ('unknown', 33, 'tilt_deg', 0.2909, 1.67),
  ('unknown', 33, 'wall_offset', 0.7955, 0.7913),
  ('unknown', 33, 'width', -1.4, 0.4056),
  ('unknown', 33, 'z_max', 0.4326, 0.0225),
  ('unknown', 33, 'z_min', 0.4265, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.006164, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'aspect', 1.492, 0.5793),
  ('unknown', 34, 'behind', 0.616, 0.2442),
  ('unknown', 34, 'corner_offset', 1.589, 0.8371),
  ('unknown', 34, 'edge_concave', 0.01804, 0.06512),
  ('unknown', 34, 'edge_convex', 0.6739, 0.1234),
  ('unknown', 34, 'edge_free', 0.7918, 0.1998),
  ('unknown', 34, 'edge_free_top', 0.9078, 0.2032),
  ('unknown', 34, 'edge_unseen', 0.0541, 0.07067),
  ('unknown', 34, 'headroom', 0.2259, 0.1306),
  ('unknown', 34, 'height', 2.484, 0.2506),
  ('unknown', 34, 'lift', -5.284, 0.1012),
  ('unknown', 34, 'rectangularity', 0.7273, 0.08681),
  ('unknown', 34, 'spread_length', -0.5111, 0.7559),
  ('unknown', 34, 'spread_width', -2.362, 0.1225),
  ('unknown', 34, 'standoff', 1.036, 0.2472),
  ('unknown', 34, 'tilt_deg', 83.85, 6.515),
  ('unknown', 34, 'wall_offset', 1.523, 0.6971),
  ('unknown', 34, 'width', -1.998, 0.3197),
  ('unknown', 34, 'z_max', 2.579, 0.2729),
  ('unknown', 34, 'z_min', 2.433, 0.2402);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.008314, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'aspect', 0.7849, 0.2632),
  ('unknown', 35, 'behind', 0.1788, 0.2068),
  ('unknown', 35, 'corner_offset', 0.8345, 0.611),
  ('unknown', 35, 'edge_concave', 0.2577, 0.3013),
  ('unknown', 35, 'edge_convex', 0.001738, 0.03),
  ('unknown', 35, 'edge_free', 0.5208, 0.1769),
  ('unknown', 35, 'edge_free_top', 0.5667, 0.1333),
  ('unknown', 35, 'edge_unseen', 0.06398, 0.1306),
  ('unknown', 35, 'headroom', 0.8663, 0.2236),
  ('unknown', 35, 'height', 0.09594, 0.0794),
  ('unknown', 35, 'lift', -3.472, 0.6331),
  ('unknown', 35, 'rectangularity', 0.7471, 0.09399),
  ('unknown', 35, 'spread_length', -1.314, 0.3908),
  ('unknown', 35, 'spread_width', -2.171, 0.4217),
  ('unknown', 35, 'standoff', 0.4535, 0.1289),
  ('unknown', 35, 'tilt_deg', 7.556, 3.464),
  ('unknown', 35, 'wall_offset', 0.9089, 0.8331),
  ('unknown', 35, 'width', -1.889, 0.4884),
  ('unknown', 35, 'z_max', 0.07366, 0.04116),
  ('unknown', 35, 'z_min', 0.07251, 0.06863);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.01035, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'aspect', 0.2058, 0.1614),
  ('unknown', 36, 'behind', 0.2862, 0.112),
  ('unknown', 36, 'corner_offset', 0.8355, 0.5144),
  ('unknown', 36, 'edge_concave', 0.02136, 0.05143),
  ('unknown', 36, 'edge_convex', 0.001172, 0.03),
  ('unknown', 36, 'edge_free', 0.8105, 0.1104),
  ('unknown', 36, 'edge_free_top', 0.5653, 0.1309),
  ('unknown', 36, 'edge_unseen', 0.002131, 0.03002),
  ('unknown', 36, 'headroom', 0.4423, 0.3349),
  ('unknown', 36, 'height', 0.1057, 0.03286),
  ('unknown', 36, 'lift', -3.502, 0.6387),
  ('unknown', 36, 'rectangularity', 0.5885, 0.07222),
  ('unknown', 36, 'spread_length', -0.775, 0.1002),
  ('unknown', 36, 'spread_width', -0.9939, 0.1631),
  ('unknown', 36, 'standoff', 0.454, 0.1263),
  ('unknown', 36, 'tilt_deg', 1.077, 1.92),
  ('unknown', 36, 'wall_offset', 0.7915, 0.7878),
  ('unknown', 36, 'width', -0.7623, 0.2381),
  ('unknown', 36, 'z_max', 0.1092, 0.04056),
  ('unknown', 36, 'z_min', 0.1, 0.0289);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.01012, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'aspect', 1.635, 0.4586),
  ('unknown', 37, 'behind', 0.5706, 0.1787),
  ('unknown', 37, 'corner_offset', 2.891, 1.874),
  ('unknown', 37, 'edge_concave', 0.631, 0.1991),
  ('unknown', 37, 'edge_convex', 0.2363, 0.1992),
  ('unknown', 37, 'edge_free', 0.2397, 0.2114),
  ('unknown', 37, 'edge_free_top', 0.009012, 0.03038),
  ('unknown', 37, 'edge_unseen', 0.1368, 0.05552),
  ('unknown', 37, 'headroom', -0.02155, 0.05729),
  ('unknown', 37, 'height', 2.305, 0.7437),
  ('unknown', 37, 'lift', -4.971, 0.8288),
  ('unknown', 37, 'rectangularity', 0.7706, 0.06802),
  ('unknown', 37, 'spread_length', 0.2303, 0.443),
  ('unknown', 37, 'spread_width', -1.464, 0.3013),
  ('unknown', 37, 'standoff', 0.7088, 0.2371),
  ('unknown', 37, 'tilt_deg', 89.17, 2.319),
  ('unknown', 37, 'wall_offset', 0.9758, 0.4379),
  ('unknown', 37, 'width', -1.239, 0.2522),
  ('unknown', 37, 'z_max', 2.719, 0.5463),
  ('unknown', 37, 'z_min', 2.25, 0.6591);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.009102, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'aspect', 0.5034, 0.09539),
  ('unknown', 38, 'behind', 0.031, 0.03887),
  ('unknown', 38, 'corner_offset', 1.413, 0.8917),
  ('unknown', 38, 'edge_concave', 0.02153, 0.04585),
  ('unknown', 38, 'edge_convex', 0.001815, 0.03001),
  ('unknown', 38, 'edge_free', 0.9257, 0.09411),
  ('unknown', 38, 'edge_free_top', 0.9773, 0.04585),
  ('unknown', 38, 'edge_unseen', 0.1144, 0.1298),
  ('unknown', 38, 'headroom', 0.726, 0.2823),
  ('unknown', 38, 'height', 1.667, 0.09305),
  ('unknown', 38, 'lift', -0.6041, 0.4072),
  ('unknown', 38, 'rectangularity', 0.8698, 0.09617),
  ('unknown', 38, 'spread_length', -0.05792, 0.2509),
  ('unknown', 38, 'spread_width', -0.5502, 0.1549),
  ('unknown', 38, 'standoff', 0.09225, 0.03948),
  ('unknown', 38, 'tilt_deg', 89.59, 2.168),
  ('unknown', 38, 'wall_offset', 1.256, 1.948),
  ('unknown', 38, 'width', -0.403, 0.1036),
  ('unknown', 38, 'z_max', 2.049, 0.1235),
  ('unknown', 38, 'z_min', 1.385, 0.07593);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.001606, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'aspect', 1.405, 0.9217),
  ('unknown', 39, 'behind', 0.08023, 0.1124),
  ('unknown', 39, 'corner_offset', -3.59, 4.756),
  ('unknown', 39, 'edge_concave', 0.02086, 0.05197),
  ('unknown', 39, 'edge_convex', 0.006823, 0.03027),
  ('unknown', 39, 'edge_free', 0.1623, 0.1764),
  ('unknown', 39, 'edge_free_top', 0.2331, 0.2416),
  ('unknown', 39, 'edge_unseen', 0.2164, 0.2092),
  ('unknown', 39, 'headroom', 0.3224, 0.2685),
  ('unknown', 39, 'height', 2.161, 0.9996),
  ('unknown', 39, 'lift', -3.502, 0.638),
  ('unknown', 39, 'rectangularity', 0.6617, 0.1031),
  ('unknown', 39, 'spread_length', 1.441, 0.52),
  ('unknown', 39, 'spread_width', 0.0599, 0.7405),
  ('unknown', 39, 'standoff', 0.1323, 0.1189),
  ('unknown', 39, 'tilt_deg', 88.22, 5.674),
  ('unknown', 39, 'wall_offset', -2.716, 11.1),
  ('unknown', 39, 'width', 0.1639, 0.8272),
  ('unknown', 39, 'z_max', 5.287, 1.867),
  ('unknown', 39, 'z_min', -0.4216, 1.653);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.001058, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'aspect', 1.419, 0.6476),
  ('unknown', 40, 'behind', 0.09669, 0.09747),
  ('unknown', 40, 'corner_offset', 1.21, 7.739),
  ('unknown', 40, 'edge_concave', 0.04744, 0.07425),
  ('unknown', 40, 'edge_convex', 0.008364, 0.03328),
  ('unknown', 40, 'edge_free', 0.04234, 0.06085),
  ('unknown', 40, 'edge_free_top', 0.05153, 0.08101),
  ('unknown', 40, 'edge_unseen', 0.08826, 0.09081),
  ('unknown', 40, 'headroom', 0.8203, 0.241),
  ('unknown', 40, 'height', 0.3752, 0.7285),
  ('unknown', 40, 'lift', -1.914, 0.9148),
  ('unknown', 40, 'rectangularity', 0.7717, 0.106),
  ('unknown', 40, 'spread_length', 0.7965, 0.8353),
  ('unknown', 40, 'spread_width', -0.5715, 0.5055),
  ('unknown', 40, 'standoff', 0.456, 0.1277),
  ('unknown', 40, 'tilt_deg', 87.19, 7.117),
  ('unknown', 40, 'wall_offset', 0.1189, 0.4109),
  ('unknown', 40, 'width', -0.5911, 0.4744),
  ('unknown', 40, 'z_max', 0.9387, 1.11),
  ('unknown', 40, 'z_min', -0.2536, 0.6478);

-- floor: 512 examples
UPDATE object_class SET prior = 0.03807 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4801, 0.3969)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'corner_offset', 1.367, 0.5646)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_concave', 0.3426, 0.166)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_convex', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_unseen', 0.2546, 0.1429)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'headroom', 2.316, 0.8553)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.001528, 0.0225)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.2449, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'aspect', 0.218, 0.1468),
  ('floor', 1, 'behind', -0.00167, 0.03321),
  ('floor', 1, 'corner_offset', 1.614, 0.5813),
  ('floor', 1, 'edge_concave', 0.4095, 0.1222),
  ('floor', 1, 'edge_convex', -9.377e-05, 0.03272),
  ('floor', 1, 'edge_free', -0.0003934, 0.0322),
  ('floor', 1, 'edge_free_top', -0.0005185, 0.323),
  ('floor', 1, 'edge_unseen', 0.1982, 0.1123),
  ('floor', 1, 'headroom', 2.77, 0.2295),
  ('floor', 1, 'height', 0.0003858, 0.02255),
  ('floor', 1, 'lift', 9.108e-05, 0.3161),
  ('floor', 1, 'rectangularity', 0.5839, 0.1169),
  ('floor', 1, 'spread_length', 1.274, 0.1241),
  ('floor', 1, 'spread_width', 0.9156, 0.1208),
  ('floor', 1, 'standoff', -0.0001844, 0.3178),
  ('floor', 1, 'tilt_deg', 0.00409, 0.4774),
  ('floor', 1, 'wall_offset', 0.01078, 0.3198),
  ('floor', 1, 'width', 1.401, 0.1196),
  ('floor', 1, 'z_max', 0.001077, 0.023),
  ('floor', 1, 'z_min', 0.0005999, 0.02341);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.125, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'aspect', 0.327, 0.1497),
  ('floor', 2, 'behind', -0.0008279, 0.03182),
  ('floor', 2, 'corner_offset', 1.32, 0.4284),
  ('floor', 2, 'edge_concave', 0.4368, 0.08383),
  ('floor', 2, 'edge_convex', -5.648e-05, 0.03103),
  ('floor', 2, 'edge_free', -0.0002394, 0.03062),
  ('floor', 2, 'edge_free_top', -0.0005007, 0.3213),
  ('floor', 2, 'edge_unseen', 0.2094, 0.04903),
  ('floor', 2, 'headroom', 2.762, 0.1992),
  ('floor', 2, 'height', 0.0001873, 0.02256),
  ('floor', 2, 'lift', 4.155e-05, 0.3162),
  ('floor', 2, 'rectangularity', 0.5805, 0.1016),
  ('floor', 2, 'spread_length', 1.119, 0.1279),
  ('floor', 2, 'spread_width', 0.655, 0.1273),
  ('floor', 2, 'standoff', 9.758e-05, 0.3175),
  ('floor', 2, 'tilt_deg', 0.028, 0.462),
  ('floor', 2, 'wall_offset', 0.005005, 0.327),
  ('floor', 2, 'width', 1.052, 0.1464),
  ('floor', 2, 'z_max', 0.001177, 0.02253),
  ('floor', 2, 'z_min', -4.611e-05, 0.02255);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.1778, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'aspect', 0.9413, 0.3798),
  ('floor', 3, 'behind', -0.007785, 0.03),
  ('floor', 3, 'corner_offset', 0.7016, 0.09883),
  ('floor', 3, 'edge_concave', 0.2385, 0.1614),
  ('floor', 3, 'edge_convex', -0.0003738, 0.03304),
  ('floor', 3, 'edge_free', -0.001888, 0.03),
  ('floor', 3, 'edge_free_top', -0.003389, 0.326),
  ('floor', 3, 'edge_unseen', 0.3926, 0.1296),
  ('floor', 3, 'headroom', 0.8915, 0.1309),
  ('floor', 3, 'height', 0.009257, 0.03987),
  ('floor', 3, 'lift', -0.001392, 0.3096),
  ('floor', 3, 'rectangularity', 0.6646, 0.1444),
  ('floor', 3, 'spread_length', -0.002657, 0.4811),
  ('floor', 3, 'spread_width', -0.8366, 0.2827),
  ('floor', 3, 'standoff', -0.0006161, 0.3188),
  ('floor', 3, 'tilt_deg', 2.09, 0.4717),
  ('floor', 3, 'wall_offset', -0.003479, 0.3596),
  ('floor', 3, 'width', -0.6169, 0.4025),
  ('floor', 3, 'z_max', 0.02862, 0.04392),
  ('floor', 3, 'z_min', -0.004587, 0.04351);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.1085, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'aspect', 0.7846, 0.1438),
  ('floor', 4, 'behind', -0.0003082, 0.03324),
  ('floor', 4, 'corner_offset', 1.318, 0.4234),
  ('floor', 4, 'edge_concave', 0.373, 0.08516),
  ('floor', 4, 'edge_convex', -5.173e-05, 0.03112),
  ('floor', 4, 'edge_free', -0.0004515, 0.03019),
  ('floor', 4, 'edge_free_top', -0.0007016, 0.32),
  ('floor', 4, 'edge_unseen', 0.2897, 0.0728),
  ('floor', 4, 'headroom', 2.654, 0.1986),
  ('floor', 4, 'height', -0.0001968, 0.0225),
  ('floor', 4, 'lift', -0.0001507, 0.3162),
  ('floor', 4, 'rectangularity', 0.5176, 0.1098),
  ('floor', 4, 'spread_length', 1.349, 0.1695),
  ('floor', 4, 'spread_width', 0.5676, 0.1911),
  ('floor', 4, 'standoff', -3.78e-05, 0.317),
  ('floor', 4, 'tilt_deg', 0.02161, 0.4601),
  ('floor', 4, 'wall_offset', 0.001264, 0.3327),
  ('floor', 4, 'width', 0.9432, 0.2339),
  ('floor', 4, 'z_max', 0.0004821, 0.0225),
  ('floor', 4, 'z_min', -0.0001529, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.07966, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'aspect', 1.065, 0.5548),
  ('floor', 5, 'behind', -0.00383, 0.03006),
  ('floor', 5, 'corner_offset', 0.2739, 0.3906),
  ('floor', 5, 'edge_concave', 0.2855, 0.1926),
  ('floor', 5, 'edge_convex', -0.0001562, 0.03797),
  ('floor', 5, 'edge_free', -0.002892, 0.03),
  ('floor', 5, 'edge_free_top', -0.001912, 0.328),
  ('floor', 5, 'edge_unseen', 0.3406, 0.2244),
  ('floor', 5, 'headroom', 1.472, 0.4612),
  ('floor', 5, 'height', -0.009941, 0.02283),
  ('floor', 5, 'lift', -0.003419, 0.3198),
  ('floor', 5, 'rectangularity', 0.6472, 0.1028),
  ('floor', 5, 'spread_length', -0.4406, 0.4587),
  ('floor', 5, 'spread_width', -1.529, 0.3322),
  ('floor', 5, 'standoff', -0.001405, 0.3197),
  ('floor', 5, 'tilt_deg', 1.754, 0.7426),
  ('floor', 5, 'wall_offset', -0.01332, 0.3759),
  ('floor', 5, 'width', -1.304, 0.3601),
  ('floor', 5, 'z_max', -0.009262, 0.02937),
  ('floor', 5, 'z_min', -0.02433, 0.03323);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.06593, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'aspect', 0.4758, 0.2938),
  ('floor', 6, 'behind', -0.003782, 0.03),
  ('floor', 6, 'corner_offset', 0.8779, 0.3382),
  ('floor', 6, 'edge_concave', 0.205, 0.1234),
  ('floor', 6, 'edge_convex', -0.001738, 0.03005),
  ('floor', 6, 'edge_free', -0.0008319, 0.03),
  ('floor', 6, 'edge_free_top', -0.001668, 0.3212),
  ('floor', 6, 'edge_unseen', 0.3098, 0.1342),
  ('floor', 6, 'headroom', 0.7855, 0.2415),
  ('floor', 6, 'height', 0.007039, 0.02393),
  ('floor', 6, 'lift', -0.0001393, 0.3156),
  ('floor', 6, 'rectangularity', 0.5754, 0.1518),
  ('floor', 6, 'spread_length', 0.5101, 0.1507),
  ('floor', 6, 'spread_width', -0.1635, 0.1828),
  ('floor', 6, 'standoff', -0.0004812, 0.32),
  ('floor', 6, 'tilt_deg', 1.453, 0.7303),
  ('floor', 6, 'wall_offset', -0.001332, 0.3368),
  ('floor', 6, 'width', 0.148, 0.1906),
  ('floor', 6, 'z_max', 0.02892, 0.02886),
  ('floor', 6, 'z_min', -0.01459, 0.0238);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.06713, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'aspect', 0.396, 0.3236),
  ('floor', 7, 'behind', -0.0004322, 0.03242),
  ('floor', 7, 'corner_offset', 1.329, 0.5313),
  ('floor', 7, 'edge_concave', 0.3191, 0.09045),
  ('floor', 7, 'edge_convex', -9.027e-05, 0.03107),
  ('floor', 7, 'edge_free', -0.0004803, 0.03026),
  ('floor', 7, 'edge_free_top', -0.001081, 0.3229),
  ('floor', 7, 'edge_unseen', 0.1836, 0.1123),
  ('floor', 7, 'headroom', 0.7182, 0.1866),
  ('floor', 7, 'height', -0.0001287, 0.02258),
  ('floor', 7, 'lift', -5.369e-05, 0.3162),
  ('floor', 7, 'rectangularity', 0.4645, 0.1224),
  ('floor', 7, 'spread_length', 1.437, 0.1611),
  ('floor', 7, 'spread_width', 0.7965, 0.2872),
  ('floor', 7, 'standoff', -0.0004964, 0.3201),
  ('floor', 7, 'tilt_deg', 0.0263, 0.4538),
  ('floor', 7, 'wall_offset', 0.003491, 0.3344),
  ('floor', 7, 'width', 1.325, 0.2592),
  ('floor', 7, 'z_max', 0.0003403, 0.02256),
  ('floor', 7, 'z_min', -0.0002427, 0.02263);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.06049, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'aspect', 0.3842, 0.2117),
  ('floor', 8, 'behind', -0.0006412, 0.03103),
  ('floor', 8, 'corner_offset', 1.298, 0.3458),
  ('floor', 8, 'edge_concave', 0.2149, 0.1092),
  ('floor', 8, 'edge_convex', -8.598e-05, 0.03114),
  ('floor', 8, 'edge_free', -0.0005426, 0.03005),
  ('floor', 8, 'edge_free_top', -0.0009121, 0.3229),
  ('floor', 8, 'edge_unseen', 0.364, 0.08918),
  ('floor', 8, 'headroom', 0.9876, 0.2736),
  ('floor', 8, 'height', 0.0005875, 0.02252),
  ('floor', 8, 'lift', 1.538e-05, 0.3161),
  ('floor', 8, 'rectangularity', 0.5784, 0.0762),
  ('floor', 8, 'spread_length', 0.9402, 0.1785),
  ('floor', 8, 'spread_width', 0.4818, 0.2842),
  ('floor', 8, 'standoff', -0.0002712, 0.3213),
  ('floor', 8, 'tilt_deg', 1.337, 0.499),
  ('floor', 8, 'wall_offset', 0.001116, 0.3315),
  ('floor', 8, 'width', 0.7999, 0.2729),
  ('floor', 8, 'z_max', 0.03551, 0.02257),
  ('floor', 8, 'z_min', -0.03897, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.02058, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'aspect', 1.035, 0.4684),
  ('floor', 9, 'behind', -0.0004431, 0.03007),
  ('floor', 9, 'corner_offset', 0.7494, 0.2738),
  ('floor', 9, 'edge_concave', 0.2058, 0.1229),
  ('floor', 9, 'edge_convex', -1.616e-05, 0.03181),
  ('floor', 9, 'edge_free', -0.000761, 0.03),
  ('floor', 9, 'edge_free_top', -0.0008314, 0.3206),
  ('floor', 9, 'edge_unseen', 0.3708, 0.13),
  ('floor', 9, 'headroom', 1.495, 0.422),
  ('floor', 9, 'height', -0.3537, 0.3402),
  ('floor', 9, 'lift', 0.0005477, 0.3154),
  ('floor', 9, 'rectangularity', 0.6202, 0.19),
  ('floor', 9, 'spread_length', -0.08163, 0.3711),
  ('floor', 9, 'spread_width', -1.128, 0.464),
  ('floor', 9, 'standoff', 5.728e-05, 0.3179),
  ('floor', 9, 'tilt_deg', 2.8, 0.8441),
  ('floor', 9, 'wall_offset', -0.001878, 0.3309),
  ('floor', 9, 'width', -0.8716, 0.5367),
  ('floor', 9, 'z_max', -0.3737, 0.332),
  ('floor', 9, 'z_min', -0.3832, 0.3468);

-- ceiling: 432 examples
UPDATE object_class SET prior = 0.04017 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4171, 0.3899)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.01187, 0.06055)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'corner_offset', 1.078, 0.7913)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_concave', 0.5571, 0.1596)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_convex', 0.006293, 0.04186)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.01147, 0.06105)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_unseen', 0.3095, 0.1518)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.833, 0.314)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'lift', 0.7787, 0.2221)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.1934, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'aspect', 0.2486, 0.1767),
  ('ceiling', 1, 'behind', -0.0007981, 0.03),
  ('ceiling', 1, 'corner_offset', 1.518, 0.522),
  ('ceiling', 1, 'edge_concave', 0.6069, 0.109),
  ('ceiling', 1, 'edge_convex', 4.783e-05, 0.03),
  ('ceiling', 1, 'edge_free', 3.197e-06, 0.03),
  ('ceiling', 1, 'edge_free_top', -0.0001749, 0.3204),
  ('ceiling', 1, 'edge_unseen', 0.3153, 0.1113),
  ('ceiling', 1, 'headroom', -0.01876, 0.325),
  ('ceiling', 1, 'height', 2.525, 0.0726),
  ('ceiling', 1, 'lift', 0.7739, 0.0714),
  ('ceiling', 1, 'rectangularity', 0.6734, 0.112),
  ('ceiling', 1, 'spread_length', 1.433, 0.1483),
  ('ceiling', 1, 'spread_width', 1, 0.192),
  ('ceiling', 1, 'standoff', -4.987e-05, 0.3165),
  ('ceiling', 1, 'tilt_deg', -0.01701, 0.45),
  ('ceiling', 1, 'wall_offset', 0.01422, 0.3185),
  ('ceiling', 1, 'width', 1.329, 0.1942),
  ('ceiling', 1, 'z_max', 2.523, 0.07426),
  ('ceiling', 1, 'z_min', 2.525, 0.07519);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1423, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'aspect', 0.2255, 0.1398),
  ('ceiling', 2, 'behind', 0.0001109, 0.03264),
  ('ceiling', 2, 'corner_offset', 1.54, 0.37),
  ('ceiling', 2, 'edge_concave', 0.5914, 0.1073),
  ('ceiling', 2, 'edge_convex', 8.38e-05, 0.03018),
  ('ceiling', 2, 'edge_free', 5.534e-05, 0.03015),
  ('ceiling', 2, 'edge_free_top', -0.0002042, 0.3222),
  ('ceiling', 2, 'edge_unseen', 0.3387, 0.1065),
  ('ceiling', 2, 'headroom', -0.007151, 0.3247),
  ('ceiling', 2, 'height', 2.727, 0.0558),
  ('ceiling', 2, 'lift', 0.7731, 0.07357),
  ('ceiling', 2, 'rectangularity', 0.6447, 0.09627),
  ('ceiling', 2, 'spread_length', 1.479, 0.1349),
  ('ceiling', 2, 'spread_width', 1.019, 0.1888),
  ('ceiling', 2, 'standoff', -4.206e-05, 0.3165),
  ('ceiling', 2, 'tilt_deg', -0.03297, 0.45),
  ('ceiling', 2, 'wall_offset', 0.02246, 0.2916),
  ('ceiling', 2, 'width', 1.364, 0.1528),
  ('ceiling', 2, 'z_max', 2.724, 0.04991),
  ('ceiling', 2, 'z_min', 2.728, 0.05865);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.1474, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'aspect', 0.3801, 0.2979),
  ('ceiling', 3, 'behind', 2.452e-05, 0.03012),
  ('ceiling', 3, 'corner_offset', 1.197, 0.5463),
  ('ceiling', 3, 'edge_concave', 0.5988, 0.09339),
  ('ceiling', 3, 'edge_convex', 9.426e-05, 0.03),
  ('ceiling', 3, 'edge_free', 9.523e-05, 0.03),
  ('ceiling', 3, 'edge_free_top', -0.0001342, 0.3184),
  ('ceiling', 3, 'edge_unseen', 0.3123, 0.0846),
  ('ceiling', 3, 'headroom', -0.003346, 0.3261),
  ('ceiling', 3, 'height', 3.039, 0.04663),
  ('ceiling', 3, 'lift', 0.7698, 0.06831),
  ('ceiling', 3, 'rectangularity', 0.6383, 0.1166),
  ('ceiling', 3, 'spread_length', 1.43, 0.1563),
  ('ceiling', 3, 'spread_width', 0.8374, 0.2644),
  ('ceiling', 3, 'standoff', -1.244e-05, 0.3165),
  ('ceiling', 3, 'tilt_deg', -0.001215, 0.45),
  ('ceiling', 3, 'wall_offset', 0.007067, 0.3287),
  ('ceiling', 3, 'width', 1.172, 0.2926),
  ('ceiling', 3, 'z_max', 3.042, 0.04429),
  ('ceiling', 3, 'z_min', 3.041, 0.04535);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.11, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'aspect', 0.2499, 0.1633),
  ('ceiling', 4, 'behind', 0.0001448, 0.03155),
  ('ceiling', 4, 'corner_offset', 1.468, 0.4813),
  ('ceiling', 4, 'edge_concave', 0.662, 0.1317),
  ('ceiling', 4, 'edge_convex', 0.0001235, 0.03003),
  ('ceiling', 4, 'edge_free', 0.0001441, 0.03),
  ('ceiling', 4, 'edge_free_top', -0.0005315, 0.3202),
  ('ceiling', 4, 'edge_unseen', 0.2841, 0.1148),
  ('ceiling', 4, 'headroom', -0.01499, 0.3214),
  ('ceiling', 4, 'height', 2.887, 0.04335),
  ('ceiling', 4, 'lift', 0.772, 0.07236),
  ('ceiling', 4, 'rectangularity', 0.7125, 0.1193),
  ('ceiling', 4, 'spread_length', 1.445, 0.1472),
  ('ceiling', 4, 'spread_width', 1.001, 0.2001),
  ('ceiling', 4, 'standoff', -9.627e-05, 0.3167),
  ('ceiling', 4, 'tilt_deg', -0.00746, 0.45),
  ('ceiling', 4, 'wall_offset', 0.0115, 0.3112),
  ('ceiling', 4, 'width', 1.299, 0.2059),
  ('ceiling', 4, 'z_max', 2.887, 0.04355),
  ('ceiling', 4, 'z_min', 2.886, 0.04383);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.05112, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'aspect', 0.8864, 0.2845),
  ('ceiling', 5, 'behind', 0.0004318, 0.03005),
  ('ceiling', 5, 'corner_offset', -0.558, 0.8582),
  ('ceiling', 5, 'edge_concave', 0.2698, 0.1306),
  ('ceiling', 5, 'edge_convex', 0.000187, 0.03032),
  ('ceiling', 5, 'edge_free', 0.0002124, 0.03),
  ('ceiling', 5, 'edge_free_top', -0.0001335, 0.3188),
  ('ceiling', 5, 'edge_unseen', 0.08057, 0.1154),
  ('ceiling', 5, 'headroom', -0.1516, 0.1394),
  ('ceiling', 5, 'height', 2.507, 0.02251),
  ('ceiling', 5, 'lift', 0.78, 0.05674),
  ('ceiling', 5, 'rectangularity', 0.7244, 0.1292),
  ('ceiling', 5, 'spread_length', 0.04063, 0.415),
  ('ceiling', 5, 'spread_width', -0.8711, 0.2074),
  ('ceiling', 5, 'standoff', -7.93e-05, 0.3162),
  ('ceiling', 5, 'tilt_deg', 0.1935, 0.4711),
  ('ceiling', 5, 'wall_offset', -0.0001959, 0.3135),
  ('ceiling', 5, 'width', -0.9085, 0.7069),
  ('ceiling', 5, 'z_max', 2.504, 0.0225),
  ('ceiling', 5, 'z_min', 2.505, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.107, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'aspect', 0.4727, 0.2729),
  ('ceiling', 6, 'behind', 0.000114, 0.03),
  ('ceiling', 6, 'corner_offset', 0.6644, 0.7761),
  ('ceiling', 6, 'edge_concave', 0.5032, 0.1112),
  ('ceiling', 6, 'edge_convex', 0.0002048, 0.03001),
  ('ceiling', 6, 'edge_free', 0.0002365, 0.03),
  ('ceiling', 6, 'edge_free_top', -0.000772, 0.3219),
  ('ceiling', 6, 'edge_unseen', 0.2922, 0.07217),
  ('ceiling', 6, 'headroom', -0.01141, 0.3286),
  ('ceiling', 6, 'height', 3.367, 0.3192),
  ('ceiling', 6, 'lift', 0.7723, 0.07232),
  ('ceiling', 6, 'rectangularity', 0.6233, 0.1083),
  ('ceiling', 6, 'spread_length', 1.358, 0.2385),
  ('ceiling', 6, 'spread_width', 0.7117, 0.2884),
  ('ceiling', 6, 'standoff', -0.0003231, 0.3167),
  ('ceiling', 6, 'tilt_deg', 0.009999, 0.45),
  ('ceiling', 6, 'wall_offset', 0.01607, 0.3168),
  ('ceiling', 6, 'width', 1.001, 0.3465),
  ('ceiling', 6, 'z_max', 3.371, 0.3314),
  ('ceiling', 6, 'z_min', 3.367, 0.3344);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.04343, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'aspect', 0.4806, 0.3845),
  ('ceiling', 7, 'behind', 0.0001886, 0.03522),
  ('ceiling', 7, 'corner_offset', 0.1237, 0.07342),
  ('ceiling', 7, 'edge_concave', 0.5287, 0.08061),
  ('ceiling', 7, 'edge_convex', 0.000236, 0.03038),
  ('ceiling', 7, 'edge_free', 0.0001311, 0.03007),
  ('ceiling', 7, 'edge_free_top', -0.0003047, 0.3177),
  ('ceiling', 7, 'edge_unseen', 0.5657, 0.0524),
  ('ceiling', 7, 'headroom', -0.07551, 0.263),
  ('ceiling', 7, 'height', 3.153, 0.2769),
  ('ceiling', 7, 'lift', 0.6953, 0.3081),
  ('ceiling', 7, 'rectangularity', 0.6074, 0.09307),
  ('ceiling', 7, 'spread_length', -0.5362, 0.5423),
  ('ceiling', 7, 'spread_width', -1.183, 0.4976),
  ('ceiling', 7, 'standoff', -0.0001167, 0.3164),
  ('ceiling', 7, 'tilt_deg', 0.5616, 0.7874),
  ('ceiling', 7, 'wall_offset', 0.001828, 0.3185),
  ('ceiling', 7, 'width', -0.9204, 0.5017),
  ('ceiling', 7, 'z_max', 3.173, 0.3039),
  ('ceiling', 7, 'z_min', 3.181, 0.2909);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.06385, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'aspect', 0.7363, 0.4867),
  ('ceiling', 8, 'behind', 0.008107, 0.03001),
  ('ceiling', 8, 'corner_offset', 1.151, 1.752),
  ('ceiling', 8, 'edge_concave', 0.4467, 0.1076),
  ('ceiling', 8, 'edge_convex', 0.000364, 0.03161),
  ('ceiling', 8, 'edge_free', 0.001988, 0.03385),
  ('ceiling', 8, 'edge_free_top', -0.002568, 0.3233),
  ('ceiling', 8, 'edge_unseen', 0.3974, 0.1446),
  ('ceiling', 8, 'headroom', -0.09112, 0.2262),
  ('ceiling', 8, 'height', 3.206, 0.5216),
  ('ceiling', 8, 'lift', 0.7903, 0.06396),
  ('ceiling', 8, 'rectangularity', 0.6185, 0.05334),
  ('ceiling', 8, 'spread_length', 0.1477, 0.3677),
  ('ceiling', 8, 'spread_width', -0.6916, 0.4369),
  ('ceiling', 8, 'standoff', -0.001953, 0.3176),
  ('ceiling', 8, 'tilt_deg', 0.1613, 0.45),
  ('ceiling', 8, 'wall_offset', 0.006391, 0.3238),
  ('ceiling', 8, 'width', -0.456, 0.4797),
  ('ceiling', 8, 'z_max', 3.179, 0.5627),
  ('ceiling', 8, 'z_min', 3.2, 0.5353);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.09151, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'aspect', 0.8521, 0.3336),
  ('ceiling', 9, 'behind', 0.3458, 0.113),
  ('ceiling', 9, 'corner_offset', 0.4123, 0.3798),
  ('ceiling', 9, 'edge_concave', 0.4911, 0.1589),
  ('ceiling', 9, 'edge_convex', 0.1679, 0.1222),
  ('ceiling', 9, 'edge_free', 0.2814, 0.1284),
  ('ceiling', 9, 'edge_free_top', -0.002312, 0.3179),
  ('ceiling', 9, 'edge_unseen', 0.2027, 0.1023),
  ('ceiling', 9, 'headroom', -0.1129, 0.1701),
  ('ceiling', 9, 'height', 2.946, 0.3391),
  ('ceiling', 9, 'lift', 0.783, 0.05223),
  ('ceiling', 9, 'rectangularity', 0.7389, 0.09564),
  ('ceiling', 9, 'spread_length', 0.6994, 0.4605),
  ('ceiling', 9, 'spread_width', -0.2611, 0.34),
  ('ceiling', 9, 'standoff', -0.002196, 0.3139),
  ('ceiling', 9, 'tilt_deg', 0.004758, 0.45),
  ('ceiling', 9, 'wall_offset', -0.0002821, 0.3137),
  ('ceiling', 9, 'width', -0.08354, 0.3314),
  ('ceiling', 9, 'z_max', 2.924, 0.339),
  ('ceiling', 9, 'z_min', 2.936, 0.3329);

-- wall: 2606 examples
UPDATE object_class SET prior = 0.2397 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.6595, 0.4893)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.09451, 0.1817)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'corner_offset', 1.417, 1.056)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_concave', 0.4189, 0.2421)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_convex', 0.04017, 0.1054)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.1187, 0.2184)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.09604, 0.2348)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_unseen', 0.1787, 0.194)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'headroom', 0.1117, 0.534)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.383, 0.4693)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'lift', -3.636, 2.056)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.657, 0.1531)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.6605, 0.673)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', -0.07998, 0.8705)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'standoff', 0.7228, 0.5134)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.65, 0.9935)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'wall_offset', 2.645, 2.663)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.1691, 0.8783)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.4, 0.7609)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.27, 0.5228)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'wall';
DELETE FROM class_density WHERE class = 'wall';
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.063, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'aspect', 0.5712, 0.3975),
  ('wall', 1, 'behind', -0.004139, 0.03),
  ('wall', 1, 'corner_offset', 1.766, 1.293),
  ('wall', 1, 'edge_concave', 0.5885, 0.133),
  ('wall', 1, 'edge_convex', 0.001548, 0.03031),
  ('wall', 1, 'edge_free', 0.01542, 0.0394),
  ('wall', 1, 'edge_free_top', 0.003184, 0.03024),
  ('wall', 1, 'edge_unseen', 0.1401, 0.1992),
  ('wall', 1, 'headroom', -0.01969, 0.03),
  ('wall', 1, 'height', 1.581, 0.3191),
  ('wall', 1, 'lift', -3.59, 0.5037),
  ('wall', 1, 'rectangularity', 0.6191, 0.1915),
  ('wall', 1, 'spread_length', 1.102, 0.2245),
  ('wall', 1, 'spread_width', 0.7499, 0.1268),
  ('wall', 1, 'standoff', 0.7281, 0.1603),
  ('wall', 1, 'tilt_deg', 90.18, 0.45),
  ('wall', 1, 'wall_offset', 2.643, 2.893),
  ('wall', 1, 'width', 1.074, 0.09974),
  ('wall', 1, 'z_max', 3.015, 0.3803),
  ('wall', 1, 'z_min', -0.02107, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.234, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'aspect', 0.7024, 0.4982),
  ('wall', 2, 'behind', -0.01031, 0.03),
  ('wall', 2, 'corner_offset', -0.8675, 1.565),
  ('wall', 2, 'edge_concave', 0.251, 0.2788),
  ('wall', 2, 'edge_convex', -5.242e-05, 0.03),
  ('wall', 2, 'edge_free', 0.002824, 0.0346),
  ('wall', 2, 'edge_free_top', -0.005376, 0.03003),
  ('wall', 2, 'edge_unseen', 0.02884, 0.1804),
  ('wall', 2, 'headroom', 1.07, 22.13),
  ('wall', 2, 'height', 0.732, 0.3656),
  ('wall', 2, 'lift', -2.524, 8.513),
  ('wall', 2, 'rectangularity', 0.7492, 0.214),
  ('wall', 2, 'spread_length', -0.2915, 0.769),
  ('wall', 2, 'spread_width', -1.098, 0.6339),
  ('wall', 2, 'standoff', 0.3047, 0.6206),
  ('wall', 2, 'tilt_deg', 88.9, 0.4647),
  ('wall', 2, 'wall_offset', -1.234, 2.217),
  ('wall', 2, 'width', -0.9424, 0.7659),
  ('wall', 2, 'z_max', 1.258, 0.6939),
  ('wall', 2, 'z_min', -0.03068, 0.02839);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.1181, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'aspect', 0.8732, 0.4287),
  ('wall', 3, 'behind', -0.003155, 0.03),
  ('wall', 3, 'corner_offset', -0.08039, 0.812),
  ('wall', 3, 'edge_concave', 0.33, 0.1721),
  ('wall', 3, 'edge_convex', 0.004018, 0.03),
  ('wall', 3, 'edge_free', -0.003307, 0.03),
  ('wall', 3, 'edge_free_top', -0.03564, 0.03),
  ('wall', 3, 'edge_unseen', 0.4086, 0.1006),
  ('wall', 3, 'headroom', -0.02007, 0.03),
  ('wall', 3, 'height', 1.433, 0.2456),
  ('wall', 3, 'lift', -4.203, 3.609),
  ('wall', 3, 'rectangularity', 0.6727, 0.05796),
  ('wall', 3, 'spread_length', 0.7089, 0.2794),
  ('wall', 3, 'spread_width', -0.1384, 0.216),
  ('wall', 3, 'standoff', 1.141, 0.191),
  ('wall', 3, 'tilt_deg', 90.54, 0.45),
  ('wall', 3, 'wall_offset', 3.765, 1.821),
  ('wall', 3, 'width', 0.2741, 0.5749),
  ('wall', 3, 'z_max', 2.549, 0.6896),
  ('wall', 3, 'z_min', 0.486, 0.146);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.03613, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'aspect', 0.4361, 0.2477),
  ('wall', 4, 'behind', 0.1801, 0.1507),
  ('wall', 4, 'corner_offset', 1.786, 1.139),
  ('wall', 4, 'edge_concave', 0.5225, 0.2004),
  ('wall', 4, 'edge_convex', 0.05164, 0.06157),
  ('wall', 4, 'edge_free', 0.1295, 0.109),
  ('wall', 4, 'edge_free_top', 0.06916, 0.108),
  ('wall', 4, 'edge_unseen', 0.122, 0.1403),
  ('wall', 4, 'headroom', -0.186, 0.3605),
  ('wall', 4, 'height', 1.443, 0.3736),
  ('wall', 4, 'lift', -3.626, 0.6258),
  ('wall', 4, 'rectangularity', 0.4472, 0.08312),
  ('wall', 4, 'spread_length', 1.229, 0.2418),
  ('wall', 4, 'spread_width', 0.7841, 0.1793),
  ('wall', 4, 'standoff', 0.4996, 0.1321),
  ('wall', 4, 'tilt_deg', 89.99, 0.4501),
  ('wall', 4, 'wall_offset', 3.648, 3.607),
  ('wall', 4, 'width', 0.9943, 0.1498),
  ('wall', 4, 'z_max', 2.735, 0.4778),
  ('wall', 4, 'z_min', -0.01524, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.09385, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'aspect', 1.19, 0.3979),
  ('wall', 5, 'behind', 0.1058, 0.1838),
  ('wall', 5, 'corner_offset', 1.089, 1.173),
  ('wall', 5, 'edge_concave', 0.1274, 0.199),
  ('wall', 5, 'edge_convex', 0.1113, 0.1612),
  ('wall', 5, 'edge_free', 0.5849, 0.3774),
  ('wall', 5, 'edge_free_top', 0.09762, 0.161),
  ('wall', 5, 'edge_unseen', 0.3996, 0.2876),
  ('wall', 5, 'headroom', 0.4829, 0.1185),
  ('wall', 5, 'height', 1.232, 0.1537),
  ('wall', 5, 'lift', -3.295, 6.346),
  ('wall', 5, 'rectangularity', 0.7704, 0.2254),
  ('wall', 5, 'spread_length', -0.2849, 0.2475),
  ('wall', 5, 'spread_width', -0.9761, 0.32),
  ('wall', 5, 'standoff', 0.6689, 0.4733),
  ('wall', 5, 'tilt_deg', 89.91, 0.451),
  ('wall', 5, 'wall_offset', 3.997, 2.196),
  ('wall', 5, 'width', -0.6179, 0.4167),
  ('wall', 5, 'z_max', 2.018, 0.4643),
  ('wall', 5, 'z_min', 0.3942, 0.286);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.1413, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'aspect', 1.447, 0.3629),
  ('wall', 6, 'behind', 0.2511, 0.2175),
  ('wall', 6, 'corner_offset', 1.343, 0.7728),
  ('wall', 6, 'edge_concave', 0.364, 0.2757),
  ('wall', 6, 'edge_convex', 0.03227, 0.07469),
  ('wall', 6, 'edge_free', 0.3961, 0.3494),
  ('wall', 6, 'edge_free_top', 0.06905, 0.09911),
  ('wall', 6, 'edge_unseen', -0.00065, 0.03),
  ('wall', 6, 'headroom', -0.01226, 0.03),
  ('wall', 6, 'height', 1.554, 0.1627),
  ('wall', 6, 'lift', -4.732, 1.496),
  ('wall', 6, 'rectangularity', 0.86, 0.06239),
  ('wall', 6, 'spread_length', 0.8286, 0.2226),
  ('wall', 6, 'spread_width', -0.7562, 0.3491),
  ('wall', 6, 'standoff', 0.8341, 0.4471),
  ('wall', 6, 'tilt_deg', 90.13, 0.4501),
  ('wall', 6, 'wall_offset', 1.091, 0.3479),
  ('wall', 6, 'width', -0.2666, 0.3388),
  ('wall', 6, 'z_max', 2.81, 0.2277),
  ('wall', 6, 'z_min', 0.2213, 0.4191);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.1158, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'aspect', 0.6704, 0.348),
  ('wall', 7, 'behind', 0.1213, 0.2292),
  ('wall', 7, 'corner_offset', 0.7493, 0.9234),
  ('wall', 7, 'edge_concave', 0.3308, 0.2378),
  ('wall', 7, 'edge_convex', 0.1321, 0.2045),
  ('wall', 7, 'edge_free', 0.07182, 0.1249),
  ('wall', 7, 'edge_free_top', 0.002511, 0.03),
  ('wall', 7, 'edge_unseen', 0.1702, 0.2438),
  ('wall', 7, 'headroom', -0.005843, 0.03),
  ('wall', 7, 'height', 2.45, 0.1895),
  ('wall', 7, 'lift', -2.598, 0.9877),
  ('wall', 7, 'rectangularity', 0.7073, 0.1313),
  ('wall', 7, 'spread_length', -0.09413, 0.6658),
  ('wall', 7, 'spread_width', -0.7034, 0.4097),
  ('wall', 7, 'standoff', 0.2186, 0.2501),
  ('wall', 7, 'tilt_deg', 89.74, 0.4693),
  ('wall', 7, 'wall_offset', 2.366, 2.422),
  ('wall', 7, 'width', -0.555, 0.5096),
  ('wall', 7, 'z_max', 3.089, 0.2871),
  ('wall', 7, 'z_min', 1.784, 0.4543);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.04286, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'aspect', 0.6736, 0.5022),
  ('wall', 8, 'behind', 0.1676, 0.1653),
  ('wall', 8, 'corner_offset', 2.528, 2.703),
  ('wall', 8, 'edge_concave', 0.369, 0.09132),
  ('wall', 8, 'edge_convex', 0.1529, 0.1461),
  ('wall', 8, 'edge_free', 0.2237, 0.1559),
  ('wall', 8, 'edge_free_top', 0.3642, 0.2874),
  ('wall', 8, 'edge_unseen', 0.2696, 0.08181),
  ('wall', 8, 'headroom', -0.4867, 0.1692),
  ('wall', 8, 'height', 1.383, 0.2548),
  ('wall', 8, 'lift', -5.069, 0.4408),
  ('wall', 8, 'rectangularity', 0.4859, 0.09912),
  ('wall', 8, 'spread_length', 0.7139, 0.1607),
  ('wall', 8, 'spread_width', -0.07864, 0.4602),
  ('wall', 8, 'standoff', 0.8686, 0.4123),
  ('wall', 8, 'tilt_deg', 90.02, 0.45),
  ('wall', 8, 'wall_offset', 3.792, 3.043),
  ('wall', 8, 'width', 0.3602, 0.4734),
  ('wall', 8, 'z_max', 2.755, 0.178),
  ('wall', 8, 'z_min', 0.1891, 0.2932);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.03253, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'aspect', 0.9937, 0.1741),
  ('wall', 9, 'behind', 0.3702, 0.1365),
  ('wall', 9, 'corner_offset', 1.174, 0.214),
  ('wall', 9, 'edge_concave', 0.352, 0.2827),
  ('wall', 9, 'edge_convex', 0.04587, 0.0747),
  ('wall', 9, 'edge_free', 0.2137, 0.1341),
  ('wall', 9, 'edge_free_top', 0.357, 0.3209),
  ('wall', 9, 'edge_unseen', 0.1043, 0.1566),
  ('wall', 9, 'headroom', 2.202, 0.5175),
  ('wall', 9, 'height', 0.6413, 0.6483),
  ('wall', 9, 'lift', -5.047, 0.9812),
  ('wall', 9, 'rectangularity', 0.6838, 0.07326),
  ('wall', 9, 'spread_length', -0.2972, 0.8527),
  ('wall', 9, 'spread_width', -1.299, 0.3403),
  ('wall', 9, 'standoff', 0.2616, 0.3522),
  ('wall', 9, 'tilt_deg', 89.4, 2.224),
  ('wall', 9, 'wall_offset', 1.553, 1.666),
  ('wall', 9, 'width', -0.9092, 0.7725),
  ('wall', 9, 'z_max', 1.101, 0.8449),
  ('wall', 9, 'z_min', 0.01895, 0.3257);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.07244, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'aspect', 0.1471, 0.1342),
  ('wall', 10, 'behind', 0.2775, 0.2015),
  ('wall', 10, 'corner_offset', 1.872, 0.9281),
  ('wall', 10, 'edge_concave', 0.1288, 0.1225),
  ('wall', 10, 'edge_convex', 0.009796, 0.03006),
  ('wall', 10, 'edge_free', 0.4741, 0.1897),
  ('wall', 10, 'edge_free_top', 0.9539, 0.06011),
  ('wall', 10, 'edge_unseen', 0.1076, 0.1146),
  ('wall', 10, 'headroom', 1.434, 0.4138),
  ('wall', 10, 'height', 0.9628, 0.1941),
  ('wall', 10, 'lift', -3.62, 0.5024),
  ('wall', 10, 'rectangularity', 0.795, 0.09828),
  ('wall', 10, 'spread_length', 0.4908, 0.1152),
  ('wall', 10, 'spread_width', 0.04135, 0.3462),
  ('wall', 10, 'standoff', 1.01, 0.1791),
  ('wall', 10, 'tilt_deg', 89.71, 0.4837),
  ('wall', 10, 'wall_offset', 3.08, 0.9992),
  ('wall', 10, 'width', 0.3532, 0.3354),
  ('wall', 10, 'z_max', 1.437, 0.3702),
  ('wall', 10, 'z_min', -0.04689, 0.109);

-- table: 770 examples
UPDATE object_class SET prior = 0.04081 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5536, 0.2717)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5326, 0.2083)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'corner_offset', 0.7551, 0.5189)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_concave', 0.2108, 0.162)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_convex', 0.05509, 0.08789)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.433, 0.2217)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_unseen', 0.109, 0.1467)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'headroom', 1.992, 0.3631)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7303, 0.1187)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.09275, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'aspect', 0.466, 0.1796),
  ('table', 1, 'behind', 0.6237, 0.0627),
  ('table', 1, 'corner_offset', 0.5887, 0.1669),
  ('table', 1, 'edge_concave', 0.2737, 0.1296),
  ('table', 1, 'edge_convex', 0.06682, 0.08354),
  ('table', 1, 'edge_free', 0.4114, 0.2164),
  ('table', 1, 'edge_free_top', -0.0008453, 0.3143),
  ('table', 1, 'edge_unseen', 0.08346, 0.09631),
  ('table', 1, 'headroom', 1.981, 0.238),
  ('table', 1, 'height', 0.6916, 0.02374),
  ('table', 1, 'lift', -0.002463, 0.3105),
  ('table', 1, 'rectangularity', 0.6944, 0.1055),
  ('table', 1, 'spread_length', 0.2528, 0.2464),
  ('table', 1, 'spread_width', -0.3434, 0.1039),
  ('table', 1, 'standoff', -0.000343, 0.3164),
  ('table', 1, 'tilt_deg', 0.1706, 0.45),
  ('table', 1, 'wall_offset', -0.003315, 0.318),
  ('table', 1, 'width', -0.1539, 0.1053),
  ('table', 1, 'z_max', 0.6907, 0.02251),
  ('table', 1, 'z_min', 0.6874, 0.02493);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.05147, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'aspect', 0.487, 0.1588),
  ('table', 2, 'behind', 0.7147, 0.04351),
  ('table', 2, 'corner_offset', 0.6339, 0.3923),
  ('table', 2, 'edge_concave', 0.276, 0.0879),
  ('table', 2, 'edge_convex', 0.03988, 0.06411),
  ('table', 2, 'edge_free', 0.3694, 0.2509),
  ('table', 2, 'edge_free_top', -0.001007, 0.3145),
  ('table', 2, 'edge_unseen', 0.007083, 0.03449),
  ('table', 2, 'headroom', 1.983, 0.3797),
  ('table', 2, 'height', 0.7458, 0.02319),
  ('table', 2, 'lift', 0.0007107, 0.311),
  ('table', 2, 'rectangularity', 0.715, 0.07678),
  ('table', 2, 'spread_length', 0.2388, 0.1854),
  ('table', 2, 'spread_width', -0.3073, 0.0894),
  ('table', 2, 'standoff', -0.0001934, 0.3164),
  ('table', 2, 'tilt_deg', -0.07224, 0.45),
  ('table', 2, 'wall_offset', -0.001979, 0.3166),
  ('table', 2, 'width', -0.1259, 0.09909),
  ('table', 2, 'z_max', 0.7445, 0.02255),
  ('table', 2, 'z_min', 0.7455, 0.02263);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.1249, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'aspect', 0.5471, 0.264),
  ('table', 3, 'behind', 0.4738, 0.2029),
  ('table', 3, 'corner_offset', 0.7892, 0.2078),
  ('table', 3, 'edge_concave', 0.2053, 0.1152),
  ('table', 3, 'edge_convex', 0.006828, 0.03),
  ('table', 3, 'edge_free', 0.4434, 0.2728),
  ('table', 3, 'edge_free_top', -0.003294, 0.3124),
  ('table', 3, 'edge_unseen', 0.2105, 0.1573),
  ('table', 3, 'headroom', 1.851, 0.1235),
  ('table', 3, 'height', 0.7577, 0.0225),
  ('table', 3, 'lift', -0.00478, 0.2906),
  ('table', 3, 'rectangularity', 0.6808, 0.1537),
  ('table', 3, 'spread_length', 0.2542, 0.1839),
  ('table', 3, 'spread_width', -0.3783, 0.1034),
  ('table', 3, 'standoff', -0.0005174, 0.3175),
  ('table', 3, 'tilt_deg', 0.08451, 0.45),
  ('table', 3, 'wall_offset', -0.005241, 0.3216),
  ('table', 3, 'width', -0.175, 0.1118),
  ('table', 3, 'z_max', 0.7602, 0.0225),
  ('table', 3, 'z_min', 0.7572, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.1189, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'aspect', 0.4546, 0.1961),
  ('table', 4, 'behind', 0.3369, 0.08644),
  ('table', 4, 'corner_offset', 1.522, 0.6578),
  ('table', 4, 'edge_concave', 0.0485, 0.05457),
  ('table', 4, 'edge_convex', 0.06559, 0.09642),
  ('table', 4, 'edge_free', 0.7188, 0.1818),
  ('table', 4, 'edge_free_top', -0.002791, 0.3118),
  ('table', 4, 'edge_unseen', 0.004516, 0.03001),
  ('table', 4, 'headroom', 2.139, 0.3419),
  ('table', 4, 'height', 0.7084, 0.03188),
  ('table', 4, 'lift', 0.003059, 0.306),
  ('table', 4, 'rectangularity', 0.8019, 0.1074),
  ('table', 4, 'spread_length', 0.02326, 0.3199),
  ('table', 4, 'spread_width', -0.5062, 0.2724),
  ('table', 4, 'standoff', -0.001353, 0.3169),
  ('table', 4, 'tilt_deg', 0.1345, 0.45),
  ('table', 4, 'wall_offset', -0.01231, 0.3271),
  ('table', 4, 'width', -0.3756, 0.1838),
  ('table', 4, 'z_max', 0.7094, 0.03196),
  ('table', 4, 'z_min', 0.7077, 0.03371);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.1051, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'aspect', 0.7847, 0.2294),
  ('table', 5, 'behind', 0.2296, 0.2364),
  ('table', 5, 'corner_offset', 1.033, 0.2999),
  ('table', 5, 'edge_concave', 0.1477, 0.1579),
  ('table', 5, 'edge_convex', 0.03756, 0.07737),
  ('table', 5, 'edge_free', 0.5217, 0.2964),
  ('table', 5, 'edge_free_top', -0.005947, 0.3067),
  ('table', 5, 'edge_unseen', 0.4071, 0.1006),
  ('table', 5, 'headroom', 2.185, 0.2473),
  ('table', 5, 'height', 0.7311, 0.05046),
  ('table', 5, 'lift', 0.01149, 0.2658),
  ('table', 5, 'rectangularity', 0.6071, 0.06672),
  ('table', 5, 'spread_length', -0.4153, 0.3342),
  ('table', 5, 'spread_width', -1.156, 0.2952),
  ('table', 5, 'standoff', -0.003206, 0.3225),
  ('table', 5, 'tilt_deg', 0.7251, 1.08),
  ('table', 5, 'wall_offset', -0.02138, 0.3397),
  ('table', 5, 'width', -0.8994, 0.3744),
  ('table', 5, 'z_max', 0.727, 0.05041),
  ('table', 5, 'z_min', 0.7305, 0.04923);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.1806, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'aspect', 0.5473, 0.3273),
  ('table', 6, 'behind', 0.302, 0.2118),
  ('table', 6, 'corner_offset', 1.257, 0.5074),
  ('table', 6, 'edge_concave', 0.1117, 0.1355),
  ('table', 6, 'edge_convex', 0.002534, 0.03),
  ('table', 6, 'edge_free', 0.4265, 0.2168),
  ('table', 6, 'edge_free_top', -0.008652, 0.3072),
  ('table', 6, 'edge_unseen', 0.1603, 0.1849),
  ('table', 6, 'headroom', 2.424, 0.4939),
  ('table', 6, 'height', 0.6498, 0.03045),
  ('table', 6, 'lift', -0.005256, 0.294),
  ('table', 6, 'rectangularity', 0.7107, 0.1378),
  ('table', 6, 'spread_length', 0.08716, 0.2758),
  ('table', 6, 'spread_width', -0.4634, 0.1942),
  ('table', 6, 'standoff', -0.002188, 0.3185),
  ('table', 6, 'tilt_deg', 0.6362, 0.7158),
  ('table', 6, 'wall_offset', -0.01768, 0.3381),
  ('table', 6, 'width', -0.2848, 0.1708),
  ('table', 6, 'z_max', 0.6565, 0.02937),
  ('table', 6, 'z_min', 0.6413, 0.03586);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.1169, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'aspect', 0.4556, 0.1462),
  ('table', 7, 'behind', 0.436, 0.1434),
  ('table', 7, 'corner_offset', 1.253, 0.4456),
  ('table', 7, 'edge_concave', 0.1562, 0.1446),
  ('table', 7, 'edge_convex', 0.08437, 0.09157),
  ('table', 7, 'edge_free', 0.401, 0.1576),
  ('table', 7, 'edge_free_top', -0.003955, 0.31),
  ('table', 7, 'edge_unseen', 0.1174, 0.1103),
  ('table', 7, 'headroom', 1.795, 0.6859),
  ('table', 7, 'height', 0.8216, 0.0263),
  ('table', 7, 'lift', 0.01537, 0.2747),
  ('table', 7, 'rectangularity', 0.7435, 0.1045),
  ('table', 7, 'spread_length', 0.09748, 0.2791),
  ('table', 7, 'spread_width', -0.3858, 0.2034),
  ('table', 7, 'standoff', -0.001548, 0.3183),
  ('table', 7, 'tilt_deg', 0.6424, 0.7442),
  ('table', 7, 'wall_offset', -0.01149, 0.3221),
  ('table', 7, 'width', -0.2206, 0.1869),
  ('table', 7, 'z_max', 0.8345, 0.02253),
  ('table', 7, 'z_min', 0.8143, 0.02973);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.1072, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'aspect', 0.5394, 0.2976),
  ('table', 8, 'behind', 0.2806, 0.144),
  ('table', 8, 'corner_offset', 0.4371, 0.7978),
  ('table', 8, 'edge_concave', 0.2124, 0.1944),
  ('table', 8, 'edge_convex', 0.04484, 0.07434),
  ('table', 8, 'edge_free', 0.2228, 0.2068),
  ('table', 8, 'edge_free_top', -0.006469, 0.3121),
  ('table', 8, 'edge_unseen', 0.1335, 0.1172),
  ('table', 8, 'headroom', 2.201, 0.2123),
  ('table', 8, 'height', 1.03, 0.08592),
  ('table', 8, 'lift', 0.03977, 0.2327),
  ('table', 8, 'rectangularity', 0.5844, 0.155),
  ('table', 8, 'spread_length', 0.2803, 0.2676),
  ('table', 8, 'spread_width', -0.3031, 0.204),
  ('table', 8, 'standoff', -0.002513, 0.3177),
  ('table', 8, 'tilt_deg', 0.01315, 0.45),
  ('table', 8, 'wall_offset', -0.0162, 0.3276),
  ('table', 8, 'width', -0.2123, 0.2916),
  ('table', 8, 'z_max', 1.032, 0.07898),
  ('table', 8, 'z_min', 1.025, 0.09353);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.01269, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'aspect', 0.3059, 0.1724),
  ('table', 9, 'behind', 0.5918, 0.1092),
  ('table', 9, 'corner_offset', 1.082, 0.677),
  ('table', 9, 'edge_concave', 0.1922, 0.1203),
  ('table', 9, 'edge_convex', 0.1034, 0.1025),
  ('table', 9, 'edge_free', 0.4601, 0.1647),
  ('table', 9, 'edge_free_top', -0.0004359, 0.3152),
  ('table', 9, 'edge_unseen', 0.01286, 0.03),
  ('table', 9, 'headroom', 1.672, 0.7148),
  ('table', 9, 'height', 0.7287, 0.02738),
  ('table', 9, 'lift', 4.829e-05, 0.3161),
  ('table', 9, 'rectangularity', 0.6403, 0.1055),
  ('table', 9, 'spread_length', 0.3677, 0.09409),
  ('table', 9, 'spread_width', -0.03337, 0.2134),
  ('table', 9, 'standoff', -8.221e-05, 0.3163),
  ('table', 9, 'tilt_deg', 0.1885, 0.4501),
  ('table', 9, 'wall_offset', -0.0009324, 0.316),
  ('table', 9, 'width', 0.1645, 0.1565),
  ('table', 9, 'z_max', 0.7315, 0.02895),
  ('table', 9, 'z_min', 0.7258, 0.03011);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.03954, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'aspect', 0.5293, 0.1586),
  ('table', 10, 'behind', 0.2295, 0.1426),
  ('table', 10, 'corner_offset', 0.6711, 0.09204),
  ('table', 10, 'edge_concave', 0.1228, 0.1133),
  ('table', 10, 'edge_convex', 0.02139, 0.0334),
  ('table', 10, 'edge_free', 0.2757, 0.1274),
  ('table', 10, 'edge_free_top', -0.002545, 0.3136),
  ('table', 10, 'edge_unseen', 0.1965, 0.1068),
  ('table', 10, 'headroom', 1.991, 0.1118),
  ('table', 10, 'height', 0.0334, 0.04248),
  ('table', 10, 'lift', -0.001405, 0.3136),
  ('table', 10, 'rectangularity', 0.6088, 0.07784),
  ('table', 10, 'spread_length', -0.0725, 0.3876),
  ('table', 10, 'spread_width', -0.6055, 0.2985),
  ('table', 10, 'standoff', -0.0001377, 0.3164),
  ('table', 10, 'tilt_deg', 1.35, 0.4694),
  ('table', 10, 'wall_offset', -0.003595, 0.3178),
  ('table', 10, 'width', -0.3138, 0.2485),
  ('table', 10, 'z_max', 0.02492, 0.02431),
  ('table', 10, 'z_min', 0.01282, 0.02958);

-- flat_screen: 604 examples
UPDATE object_class SET prior = 0.03297 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.3801, 0.2017)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5884, 0.1355)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'corner_offset', 1.534, 0.8903)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_concave', 0.1911, 0.1719)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_convex', 0.002377, 0.01806)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.7792, 0.1705)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.9768, 0.06977)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_unseen', 0.05771, 0.1128)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'headroom', 1.592, 0.278)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.018, 0.09436)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'lift', -4.022, 1.426)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.803, 0.1137)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7733, 0.2061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.212, 0.1909)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'standoff', 0.452, 0.2654)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.21, 3.253)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'wall_offset', 0.9662, 1.056)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -1.008, 0.2216)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.174, 0.1046)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7855, 0.1215)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'flat_screen';
DELETE FROM class_density WHERE class = 'flat_screen';
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.1322, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'aspect', 0.4082, 0.2442),
  ('flat_screen', 1, 'behind', 0.5927, 0.07429),
  ('flat_screen', 1, 'corner_offset', 1.474, 0.5806),
  ('flat_screen', 1, 'edge_concave', 0.3793, 0.07923),
  ('flat_screen', 1, 'edge_convex', -0.0005748, 0.03),
  ('flat_screen', 1, 'edge_free', 0.6773, 0.05396),
  ('flat_screen', 1, 'edge_free_top', 0.9986, 0.03003),
  ('flat_screen', 1, 'edge_unseen', 0.007336, 0.03019),
  ('flat_screen', 1, 'headroom', 1.683, 0.1672),
  ('flat_screen', 1, 'height', 0.9614, 0.02489),
  ('flat_screen', 1, 'lift', -5.288, 0.04471),
  ('flat_screen', 1, 'rectangularity', 0.7595, 0.1033),
  ('flat_screen', 1, 'spread_length', -0.7656, 0.1315),
  ('flat_screen', 1, 'spread_width', -1.183, 0.09082),
  ('flat_screen', 1, 'standoff', 0.2948, 0.04144),
  ('flat_screen', 1, 'tilt_deg', 84.99, 1.533),
  ('flat_screen', 1, 'wall_offset', 0.7899, 0.7499),
  ('flat_screen', 1, 'width', -0.9351, 0.06001),
  ('flat_screen', 1, 'z_max', 1.064, 0.03449),
  ('flat_screen', 1, 'z_min', 0.6736, 0.02748);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.1823, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'aspect', 0.358, 0.2667),
  ('flat_screen', 2, 'behind', 0.6495, 0.05931),
  ('flat_screen', 2, 'corner_offset', 2.015, 0.6414),
  ('flat_screen', 2, 'edge_concave', 0.2377, 0.124),
  ('flat_screen', 2, 'edge_convex', 0.001763, 0.03),
  ('flat_screen', 2, 'edge_free', 0.7513, 0.1125),
  ('flat_screen', 2, 'edge_free_top', 1.001, 0.03),
  ('flat_screen', 2, 'edge_unseen', 0.08413, 0.1113),
  ('flat_screen', 2, 'headroom', 1.563, 0.3531),
  ('flat_screen', 2, 'height', 1.025, 0.04271),
  ('flat_screen', 2, 'lift', -4.526, 0.9079),
  ('flat_screen', 2, 'rectangularity', 0.7488, 0.1137),
  ('flat_screen', 2, 'spread_length', -0.9046, 0.1352),
  ('flat_screen', 2, 'spread_width', -1.256, 0.06344),
  ('flat_screen', 2, 'standoff', 0.5349, 0.2952),
  ('flat_screen', 2, 'tilt_deg', 84.2, 1.722),
  ('flat_screen', 2, 'wall_offset', 0.3987, 0.08234),
  ('flat_screen', 2, 'width', -0.9908, 0.05751),
  ('flat_screen', 2, 'z_max', 1.142, 0.05943),
  ('flat_screen', 2, 'z_min', 0.7572, 0.04281);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.07395, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'aspect', 0.3623, 0.159),
  ('flat_screen', 3, 'behind', 0.5914, 0.09487),
  ('flat_screen', 3, 'corner_offset', 1.647, 0.9416),
  ('flat_screen', 3, 'edge_concave', 0.00644, 0.03393),
  ('flat_screen', 3, 'edge_convex', 0.001225, 0.03089),
  ('flat_screen', 3, 'edge_free', 0.966, 0.07617),
  ('flat_screen', 3, 'edge_free_top', 0.9977, 0.03121),
  ('flat_screen', 3, 'edge_unseen', 0.06073, 0.1019),
  ('flat_screen', 3, 'headroom', 1.619, 0.2735),
  ('flat_screen', 3, 'height', 1.041, 0.05353),
  ('flat_screen', 3, 'lift', -2.211, 0.219),
  ('flat_screen', 3, 'rectangularity', 0.9137, 0.06692),
  ('flat_screen', 3, 'spread_length', -0.9455, 0.1028),
  ('flat_screen', 3, 'spread_width', -1.307, 0.05923),
  ('flat_screen', 3, 'standoff', 0.383, 0.1089),
  ('flat_screen', 3, 'tilt_deg', 84.35, 2.673),
  ('flat_screen', 3, 'wall_offset', 0.8597, 0.912),
  ('flat_screen', 3, 'width', -1.248, 0.08652),
  ('flat_screen', 3, 'z_max', 1.168, 0.06748),
  ('flat_screen', 3, 'z_min', 0.862, 0.04531);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.09695, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'aspect', 0.4977, 0.04614),
  ('flat_screen', 4, 'behind', 0.5196, 0.1053),
  ('flat_screen', 4, 'corner_offset', 1.318, 0.7728),
  ('flat_screen', 4, 'edge_concave', 0.006902, 0.03),
  ('flat_screen', 4, 'edge_convex', 0.0002999, 0.03),
  ('flat_screen', 4, 'edge_free', 0.9493, 0.09071),
  ('flat_screen', 4, 'edge_free_top', 0.9972, 0.03),
  ('flat_screen', 4, 'edge_unseen', 0.02996, 0.06474),
  ('flat_screen', 4, 'headroom', 1.7, 0.3563),
  ('flat_screen', 4, 'height', 1.028, 0.05704),
  ('flat_screen', 4, 'lift', -2.234, 0.2186),
  ('flat_screen', 4, 'rectangularity', 0.9176, 0.06127),
  ('flat_screen', 4, 'spread_length', -0.6386, 0.05988),
  ('flat_screen', 4, 'spread_width', -1.133, 0.076),
  ('flat_screen', 4, 'standoff', 0.5533, 0.2828),
  ('flat_screen', 4, 'tilt_deg', 85.28, 2.978),
  ('flat_screen', 4, 'wall_offset', 0.8998, 0.9611),
  ('flat_screen', 4, 'width', -1.079, 0.07723),
  ('flat_screen', 4, 'z_max', 1.181, 0.0627),
  ('flat_screen', 4, 'z_min', 0.8349, 0.05605);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.1607, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'aspect', 0.4672, 0.2008),
  ('flat_screen', 5, 'behind', 0.6269, 0.1137),
  ('flat_screen', 5, 'corner_offset', 1.724, 0.5281),
  ('flat_screen', 5, 'edge_concave', 0.3882, 0.09246),
  ('flat_screen', 5, 'edge_convex', 0.004888, 0.03525),
  ('flat_screen', 5, 'edge_free', 0.5698, 0.08678),
  ('flat_screen', 5, 'edge_free_top', 0.8011, 0.08764),
  ('flat_screen', 5, 'edge_unseen', 0.03372, 0.06468),
  ('flat_screen', 5, 'headroom', 1.498, 0.4004),
  ('flat_screen', 5, 'height', 1.059, 0.07314),
  ('flat_screen', 5, 'lift', -5.09, 0.3183),
  ('flat_screen', 5, 'rectangularity', 0.6828, 0.07096),
  ('flat_screen', 5, 'spread_length', -0.5685, 0.2378),
  ('flat_screen', 5, 'spread_width', -1.075, 0.08294),
  ('flat_screen', 5, 'standoff', 0.7723, 0.3236),
  ('flat_screen', 5, 'tilt_deg', 83.18, 2.04),
  ('flat_screen', 5, 'wall_offset', 1.266, 1.035),
  ('flat_screen', 5, 'width', -0.6645, 0.1727),
  ('flat_screen', 5, 'z_max', 1.264, 0.1295),
  ('flat_screen', 5, 'z_min', 0.7559, 0.08405);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.1288, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'aspect', 0.3095, 0.1211),
  ('flat_screen', 6, 'behind', 0.5692, 0.08639),
  ('flat_screen', 6, 'corner_offset', 1.23, 0.8585),
  ('flat_screen', 6, 'edge_concave', 0.2272, 0.08348),
  ('flat_screen', 6, 'edge_convex', -0.0003621, 0.03),
  ('flat_screen', 6, 'edge_free', 0.7542, 0.07624),
  ('flat_screen', 6, 'edge_free_top', 0.9963, 0.03004),
  ('flat_screen', 6, 'edge_unseen', 0.005362, 0.03008),
  ('flat_screen', 6, 'headroom', 1.667, 0.2817),
  ('flat_screen', 6, 'height', 1.028, 0.04549),
  ('flat_screen', 6, 'lift', -4.854, 0.488),
  ('flat_screen', 6, 'rectangularity', 0.8056, 0.06573),
  ('flat_screen', 6, 'spread_length', -0.5929, 0.06185),
  ('flat_screen', 6, 'spread_width', -1.063, 0.05104),
  ('flat_screen', 6, 'standoff', 0.526, 0.3075),
  ('flat_screen', 6, 'tilt_deg', 86.46, 2.674),
  ('flat_screen', 6, 'wall_offset', 1.561, 1.066),
  ('flat_screen', 6, 'width', -0.822, 0.06406),
  ('flat_screen', 6, 'z_max', 1.175, 0.0562),
  ('flat_screen', 6, 'z_min', 0.7365, 0.04512);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.04773, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'aspect', 0.7559, 0.2767),
  ('flat_screen', 7, 'behind', 0.5209, 0.227),
  ('flat_screen', 7, 'corner_offset', 1.365, 0.5583),
  ('flat_screen', 7, 'edge_concave', 0.07408, 0.09567),
  ('flat_screen', 7, 'edge_convex', 0.0001486, 0.03013),
  ('flat_screen', 7, 'edge_free', 0.7779, 0.2919),
  ('flat_screen', 7, 'edge_free_top', 1, 0.03967),
  ('flat_screen', 7, 'edge_unseen', 0.297, 0.07367),
  ('flat_screen', 7, 'headroom', 1.432, 0.2294),
  ('flat_screen', 7, 'height', 1.024, 0.09421),
  ('flat_screen', 7, 'lift', -2.11, 0.3758),
  ('flat_screen', 7, 'rectangularity', 0.7479, 0.07129),
  ('flat_screen', 7, 'spread_length', -0.9759, 0.2768),
  ('flat_screen', 7, 'spread_width', -1.767, 0.2496),
  ('flat_screen', 7, 'standoff', 0.343, 0.05343),
  ('flat_screen', 7, 'tilt_deg', 83.75, 2.497),
  ('flat_screen', 7, 'wall_offset', 1.632, 1.814),
  ('flat_screen', 7, 'width', -1.552, 0.174),
  ('flat_screen', 7, 'z_max', 1.109, 0.06242),
  ('flat_screen', 7, 'z_min', 0.8491, 0.06029);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.08685, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'aspect', 0.397, 0.212),
  ('flat_screen', 8, 'behind', 0.4792, 0.05776),
  ('flat_screen', 8, 'corner_offset', 1.26, 1.46),
  ('flat_screen', 8, 'edge_concave', 0.1383, 0.07864),
  ('flat_screen', 8, 'edge_convex', -0.0004672, 0.03428),
  ('flat_screen', 8, 'edge_free', 0.8642, 0.1102),
  ('flat_screen', 8, 'edge_free_top', 0.9988, 0.03017),
  ('flat_screen', 8, 'edge_unseen', 0.1262, 0.2214),
  ('flat_screen', 8, 'headroom', 1.458, 0.5974),
  ('flat_screen', 8, 'height', 1.335, 0.06045),
  ('flat_screen', 8, 'lift', -3.566, 1.582),
  ('flat_screen', 8, 'rectangularity', 0.8492, 0.1271),
  ('flat_screen', 8, 'spread_length', -0.6851, 0.1284),
  ('flat_screen', 8, 'spread_width', -1.188, 0.1438),
  ('flat_screen', 8, 'standoff', 0.3574, 0.06723),
  ('flat_screen', 8, 'tilt_deg', 82.57, 1.997),
  ('flat_screen', 8, 'wall_offset', 1.392, 2.18),
  ('flat_screen', 8, 'width', -0.9785, 0.09924),
  ('flat_screen', 8, 'z_max', 1.467, 0.08415),
  ('flat_screen', 8, 'z_min', 1.147, 0.0588);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.01344, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'aspect', 0.5489, 0.1589),
  ('flat_screen', 9, 'behind', 0.5645, 0.1316),
  ('flat_screen', 9, 'corner_offset', 1.696, 0.5594),
  ('flat_screen', 9, 'edge_concave', 0.1086, 0.1134),
  ('flat_screen', 9, 'edge_convex', 0.0968, 0.09821),
  ('flat_screen', 9, 'edge_free', 0.6556, 0.1158),
  ('flat_screen', 9, 'edge_free_top', 0.8212, 0.2254),
  ('flat_screen', 9, 'edge_unseen', 0.1111, 0.1603),
  ('flat_screen', 9, 'headroom', 1.735, 0.2003),
  ('flat_screen', 9, 'height', 1.013, 0.04419),
  ('flat_screen', 9, 'lift', -3.818, 1.066),
  ('flat_screen', 9, 'rectangularity', 0.763, 0.06749),
  ('flat_screen', 9, 'spread_length', -0.7731, 0.2314),
  ('flat_screen', 9, 'spread_width', -1.316, 0.1809),
  ('flat_screen', 9, 'standoff', 0.3845, 0.0706),
  ('flat_screen', 9, 'tilt_deg', 86.76, 1.801),
  ('flat_screen', 9, 'wall_offset', 0.8976, 1.136),
  ('flat_screen', 9, 'width', -1.114, 0.2886),
  ('flat_screen', 9, 'z_max', 1.179, 0.05856),
  ('flat_screen', 9, 'z_min', 0.7842, 0.02992);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.02698, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'aspect', 0.7037, 0.1073),
  ('flat_screen', 10, 'behind', 0.6255, 0.1187),
  ('flat_screen', 10, 'corner_offset', 0.7416, 0.4539),
  ('flat_screen', 10, 'edge_concave', 0.1498, 0.195),
  ('flat_screen', 10, 'edge_convex', -0.0009519, 0.03),
  ('flat_screen', 10, 'edge_free', 0.6974, 0.1173),
  ('flat_screen', 10, 'edge_free_top', 0.997, 0.03),
  ('flat_screen', 10, 'edge_unseen', 0.003902, 0.03),
  ('flat_screen', 10, 'headroom', 1.697, 0.1039),
  ('flat_screen', 10, 'height', 0.5051, 0.2825),
  ('flat_screen', 10, 'lift', -4.009, 0.3967),
  ('flat_screen', 10, 'rectangularity', 0.7462, 0.2562),
  ('flat_screen', 10, 'spread_length', -0.5961, 0.271),
  ('flat_screen', 10, 'spread_width', -1.171, 0.3192),
  ('flat_screen', 10, 'standoff', 0.4888, 0.1702),
  ('flat_screen', 10, 'tilt_deg', 86.57, 3.77),
  ('flat_screen', 10, 'wall_offset', 1.933, 0.3489),
  ('flat_screen', 10, 'width', -1.02, 0.4077),
  ('flat_screen', 10, 'z_max', 0.6237, 0.3915),
  ('flat_screen', 10, 'z_min', 0.0943, 0.1004);

-- keyboard: 411 examples
UPDATE object_class SET prior = 0.02629 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.752, 0.3045)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.2451, 0.1626)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'corner_offset', 0.7911, 0.4706)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_concave', 0.00996, 0.03951)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_convex', 0.02285, 0.07579)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.2511, 0.2088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_unseen', 0.04497, 0.1061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'headroom', 1.95, 0.2436)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7611, 0.1205)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'lift', -3.594, 0.1703)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1438, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'aspect', 0.979, 0.156),
  ('keyboard', 1, 'behind', 0.2825, 0.06053),
  ('keyboard', 1, 'corner_offset', 0.9948, 0.4936),
  ('keyboard', 1, 'edge_concave', -0.0005791, 0.03004),
  ('keyboard', 1, 'edge_convex', 0.001135, 0.03419),
  ('keyboard', 1, 'edge_free', 0.3161, 0.142),
  ('keyboard', 1, 'edge_free_top', -0.009223, 0.3008),
  ('keyboard', 1, 'edge_unseen', 0.0008843, 0.03004),
  ('keyboard', 1, 'headroom', 1.988, 0.2038),
  ('keyboard', 1, 'height', 0.7945, 0.02355),
  ('keyboard', 1, 'lift', -3.556, 0.1162),
  ('keyboard', 1, 'rectangularity', 0.8472, 0.06),
  ('keyboard', 1, 'spread_length', -0.8322, 0.0936),
  ('keyboard', 1, 'spread_width', -1.813, 0.1159),
  ('keyboard', 1, 'standoff', -0.0009268, 0.3238),
  ('keyboard', 1, 'tilt_deg', 4.544, 1.474),
  ('keyboard', 1, 'wall_offset', -0.01143, 0.3341),
  ('keyboard', 1, 'width', -1.7, 0.2063),
  ('keyboard', 1, 'z_max', 0.7984, 0.02474),
  ('keyboard', 1, 'z_min', 0.7959, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.1256, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'aspect', 0.6938, 0.2327),
  ('keyboard', 2, 'behind', 0.217, 0.1488),
  ('keyboard', 2, 'corner_offset', 0.9306, 0.1432),
  ('keyboard', 2, 'edge_concave', -0.001236, 0.03063),
  ('keyboard', 2, 'edge_convex', 0.0006637, 0.03611),
  ('keyboard', 2, 'edge_free', 0.2889, 0.0966),
  ('keyboard', 2, 'edge_free_top', -0.005568, 0.3079),
  ('keyboard', 2, 'edge_unseen', 0.001601, 0.03448),
  ('keyboard', 2, 'headroom', 1.971, 0.3216),
  ('keyboard', 2, 'height', 0.7368, 0.0225),
  ('keyboard', 2, 'lift', -3.559, 0.1007),
  ('keyboard', 2, 'rectangularity', 0.7512, 0.04877),
  ('keyboard', 2, 'spread_length', -0.8484, 0.09247),
  ('keyboard', 2, 'spread_width', -1.793, 0.08018),
  ('keyboard', 2, 'standoff', -0.001369, 0.3222),
  ('keyboard', 2, 'tilt_deg', 4.623, 1.269),
  ('keyboard', 2, 'wall_offset', -0.003296, 0.3233),
  ('keyboard', 2, 'width', -1.523, 0.1604),
  ('keyboard', 2, 'z_max', 0.7483, 0.0225),
  ('keyboard', 2, 'z_min', 0.7264, 0.02269);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.09353, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'aspect', 0.315, 0.143),
  ('keyboard', 3, 'behind', 0.2616, 0.1259),
  ('keyboard', 3, 'corner_offset', 1.106, 0.9861),
  ('keyboard', 3, 'edge_concave', -8.731e-05, 0.0314),
  ('keyboard', 3, 'edge_convex', 0.003694, 0.03832),
  ('keyboard', 3, 'edge_free', 0.2033, 0.1262),
  ('keyboard', 3, 'edge_free_top', -0.003552, 0.3127),
  ('keyboard', 3, 'edge_unseen', 0.2237, 0.08362),
  ('keyboard', 3, 'headroom', 2.033, 0.2827),
  ('keyboard', 3, 'height', 0.727, 0.02442),
  ('keyboard', 3, 'lift', -3.565, 0.1005),
  ('keyboard', 3, 'rectangularity', 0.7267, 0.0427),
  ('keyboard', 3, 'spread_length', -1.544, 0.1554),
  ('keyboard', 3, 'spread_width', -2.083, 0.05069),
  ('keyboard', 3, 'standoff', -0.002098, 0.3199),
  ('keyboard', 3, 'tilt_deg', 4.834, 1.32),
  ('keyboard', 3, 'wall_offset', -0.005188, 0.3199),
  ('keyboard', 3, 'width', -1.865, 0.2935),
  ('keyboard', 3, 'z_max', 0.7294, 0.02257),
  ('keyboard', 3, 'z_min', 0.7227, 0.03803);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.1216, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'aspect', 0.8356, 0.1828),
  ('keyboard', 4, 'behind', 0.09589, 0.1421),
  ('keyboard', 4, 'corner_offset', 0.7386, 0.6464),
  ('keyboard', 4, 'edge_concave', 0.01293, 0.0492),
  ('keyboard', 4, 'edge_convex', 0.04503, 0.08471),
  ('keyboard', 4, 'edge_free', 0.1667, 0.1489),
  ('keyboard', 4, 'edge_free_top', -0.01229, 0.3216),
  ('keyboard', 4, 'edge_unseen', 0.04489, 0.0901),
  ('keyboard', 4, 'headroom', 1.889, 0.3226),
  ('keyboard', 4, 'height', 0.9949, 0.1167),
  ('keyboard', 4, 'lift', -3.588, 0.2134),
  ('keyboard', 4, 'rectangularity', 0.8171, 0.1176),
  ('keyboard', 4, 'spread_length', -0.9284, 0.13),
  ('keyboard', 4, 'spread_width', -1.852, 0.05262),
  ('keyboard', 4, 'standoff', -0.008287, 0.3393),
  ('keyboard', 4, 'tilt_deg', 4.479, 1.376),
  ('keyboard', 4, 'wall_offset', -0.04573, 0.3313),
  ('keyboard', 4, 'width', -1.808, 0.1173),
  ('keyboard', 4, 'z_max', 1.002, 0.1113),
  ('keyboard', 4, 'z_min', 1.018, 0.1092);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.1057, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'aspect', 0.7034, 0.1835),
  ('keyboard', 5, 'behind', 0.2471, 0.08323),
  ('keyboard', 5, 'corner_offset', 0.8005, 0.06265),
  ('keyboard', 5, 'edge_concave', 0.003849, 0.03384),
  ('keyboard', 5, 'edge_convex', 0.04757, 0.09937),
  ('keyboard', 5, 'edge_free', 0.01128, 0.03003),
  ('keyboard', 5, 'edge_free_top', -0.003713, 0.311),
  ('keyboard', 5, 'edge_unseen', 0.02611, 0.05502),
  ('keyboard', 5, 'headroom', 1.988, 0.2342),
  ('keyboard', 5, 'height', 0.7508, 0.03576),
  ('keyboard', 5, 'lift', -3.729, 0.06228),
  ('keyboard', 5, 'rectangularity', 0.8333, 0.04866),
  ('keyboard', 5, 'spread_length', -1.033, 0.2238),
  ('keyboard', 5, 'spread_width', -1.796, 0.05462),
  ('keyboard', 5, 'standoff', -0.0002881, 0.3218),
  ('keyboard', 5, 'tilt_deg', 1.612, 0.45),
  ('keyboard', 5, 'wall_offset', -0.005583, 0.323),
  ('keyboard', 5, 'width', -1.582, 0.1493),
  ('keyboard', 5, 'z_max', 0.7545, 0.0378),
  ('keyboard', 5, 'z_min', 0.7502, 0.04088);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.08486, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'aspect', 0.5432, 0.4271),
  ('keyboard', 6, 'behind', 0.299, 0.06456),
  ('keyboard', 6, 'corner_offset', 0.7032, 0.7418),
  ('keyboard', 6, 'edge_concave', 0.09921, 0.09786),
  ('keyboard', 6, 'edge_convex', 0.1243, 0.1138),
  ('keyboard', 6, 'edge_free', 0.2513, 0.08895),
  ('keyboard', 6, 'edge_free_top', -0.005126, 0.3104),
  ('keyboard', 6, 'edge_unseen', 0.00167, 0.03147),
  ('keyboard', 6, 'headroom', 1.906, 0.2307),
  ('keyboard', 6, 'height', 0.7281, 0.05415),
  ('keyboard', 6, 'lift', -3.606, 0.0797),
  ('keyboard', 6, 'rectangularity', 0.8122, 0.03),
  ('keyboard', 6, 'spread_length', -0.9826, 0.1806),
  ('keyboard', 6, 'spread_width', -1.757, 0.07494),
  ('keyboard', 6, 'standoff', -0.0008868, 0.321),
  ('keyboard', 6, 'tilt_deg', 4.167, 1.064),
  ('keyboard', 6, 'wall_offset', -0.007496, 0.3239),
  ('keyboard', 6, 'width', -1.395, 0.1339),
  ('keyboard', 6, 'z_max', 0.7286, 0.05317),
  ('keyboard', 6, 'z_min', 0.7202, 0.05494);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.08214, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'aspect', 0.9235, 0.1893),
  ('keyboard', 7, 'behind', 0.2127, 0.07509),
  ('keyboard', 7, 'corner_offset', 0.7024, 0.2459),
  ('keyboard', 7, 'edge_concave', 0.001491, 0.03088),
  ('keyboard', 7, 'edge_convex', 0.0009213, 0.03271),
  ('keyboard', 7, 'edge_free', 0.2554, 0.1552),
  ('keyboard', 7, 'edge_free_top', -0.006077, 0.3055),
  ('keyboard', 7, 'edge_unseen', 0.02383, 0.06279),
  ('keyboard', 7, 'headroom', 1.909, 0.08),
  ('keyboard', 7, 'height', 0.6857, 0.04264),
  ('keyboard', 7, 'lift', -3.6, 0.5223),
  ('keyboard', 7, 'rectangularity', 0.8947, 0.04983),
  ('keyboard', 7, 'spread_length', -0.8351, 0.0877),
  ('keyboard', 7, 'spread_width', -1.845, 0.06543),
  ('keyboard', 7, 'standoff', -0.0002994, 0.3229),
  ('keyboard', 7, 'tilt_deg', 4.215, 1.244),
  ('keyboard', 7, 'wall_offset', -0.002547, 0.3252),
  ('keyboard', 7, 'width', -1.743, 0.1172),
  ('keyboard', 7, 'z_max', 0.6902, 0.03277),
  ('keyboard', 7, 'z_min', 0.6729, 0.02961);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.1032, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'aspect', 0.373, 0.2203),
  ('keyboard', 8, 'behind', 0.3276, 0.057),
  ('keyboard', 8, 'corner_offset', 0.6645, 0.06627),
  ('keyboard', 8, 'edge_concave', 0.005189, 0.03003),
  ('keyboard', 8, 'edge_convex', 0.0006339, 0.03002),
  ('keyboard', 8, 'edge_free', 0.2567, 0.1468),
  ('keyboard', 8, 'edge_free_top', -0.003467, 0.3122),
  ('keyboard', 8, 'edge_unseen', 0.22, 0.1252),
  ('keyboard', 8, 'headroom', 1.873, 0.1659),
  ('keyboard', 8, 'height', 0.7917, 0.0225),
  ('keyboard', 8, 'lift', -3.569, 0.08402),
  ('keyboard', 8, 'rectangularity', 0.7964, 0.03391),
  ('keyboard', 8, 'spread_length', -1.52, 0.1076),
  ('keyboard', 8, 'spread_width', -1.859, 0.1621),
  ('keyboard', 8, 'standoff', -0.001733, 0.3185),
  ('keyboard', 8, 'tilt_deg', 3.776, 1.081),
  ('keyboard', 8, 'wall_offset', -0.004833, 0.3171),
  ('keyboard', 8, 'width', -1.626, 0.2981),
  ('keyboard', 8, 'z_max', 0.7963, 0.0225),
  ('keyboard', 8, 'z_min', 0.7909, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.04045, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'aspect', 0.8269, 0.1935),
  ('keyboard', 9, 'behind', 0.2076, 0.08469),
  ('keyboard', 9, 'corner_offset', 0.8747, 0.1481),
  ('keyboard', 9, 'edge_concave', 0.0009127, 0.03052),
  ('keyboard', 9, 'edge_convex', 0.1916, 0.1418),
  ('keyboard', 9, 'edge_free', 0.4794, 0.1051),
  ('keyboard', 9, 'edge_free_top', -0.003796, 0.3092),
  ('keyboard', 9, 'edge_unseen', 0.1804, 0.1117),
  ('keyboard', 9, 'headroom', 1.844, 0.1316),
  ('keyboard', 9, 'height', 0.7367, 0.02687),
  ('keyboard', 9, 'lift', -3.57, 0.08918),
  ('keyboard', 9, 'rectangularity', 0.7761, 0.07083),
  ('keyboard', 9, 'spread_length', -0.9935, 0.1223),
  ('keyboard', 9, 'spread_width', -1.862, 0.07656),
  ('keyboard', 9, 'standoff', -0.0003405, 0.3203),
  ('keyboard', 9, 'tilt_deg', 4.039, 0.8024),
  ('keyboard', 9, 'wall_offset', -0.0008095, 0.3207),
  ('keyboard', 9, 'width', -1.716, 0.05826),
  ('keyboard', 9, 'z_max', 0.7437, 0.02706),
  ('keyboard', 9, 'z_min', 0.7293, 0.02755);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.04911, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'aspect', 1.044, 0.2062),
  ('keyboard', 10, 'behind', 0.1058, 0.1169),
  ('keyboard', 10, 'corner_offset', 0.8198, 0.1431),
  ('keyboard', 10, 'edge_concave', 0.0008844, 0.03),
  ('keyboard', 10, 'edge_convex', 0.002987, 0.03),
  ('keyboard', 10, 'edge_free', 0.1159, 0.1523),
  ('keyboard', 10, 'edge_free_top', -0.0003711, 0.3246),
  ('keyboard', 10, 'edge_unseen', 0.1319, 0.1856),
  ('keyboard', 10, 'headroom', 1.948, 0.06204),
  ('keyboard', 10, 'height', 0.1077, 0.0867),
  ('keyboard', 10, 'lift', -3.593, 0.0742),
  ('keyboard', 10, 'rectangularity', 0.9075, 0.0585),
  ('keyboard', 10, 'spread_length', -1.071, 0.4701),
  ('keyboard', 10, 'spread_width', -1.967, 0.0442),
  ('keyboard', 10, 'standoff', -0.000554, 0.3167),
  ('keyboard', 10, 'tilt_deg', 2.228, 1.13),
  ('keyboard', 10, 'wall_offset', -0.04961, 0.314),
  ('keyboard', 10, 'width', -1.914, 0.06039),
  ('keyboard', 10, 'z_max', 0.07872, 0.05474),
  ('keyboard', 10, 'z_min', 0.1043, 0.07238);

-- chair_seat: 489 examples
UPDATE object_class SET prior = 0.02502 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.2885, 0.2855)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6622, 0.1639)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'corner_offset', 0.995, 0.4663)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_concave', 0.2169, 0.1811)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_convex', 0.02905, 0.09131)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.6209, 0.1977)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_unseen', 0.0487, 0.1098)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'headroom', 1.963, 0.7827)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4697, 0.03029)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.08386, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'aspect', 0.09941, 0.07511),
  ('chair_seat', 1, 'behind', 0.6709, 0.0912),
  ('chair_seat', 1, 'corner_offset', 1.15, 0.3548),
  ('chair_seat', 1, 'edge_concave', 0.2959, 0.105),
  ('chair_seat', 1, 'edge_convex', 0.001004, 0.03),
  ('chair_seat', 1, 'edge_free', 0.7468, 0.1362),
  ('chair_seat', 1, 'edge_free_top', -0.0002901, 0.3159),
  ('chair_seat', 1, 'edge_unseen', 0.002682, 0.03059),
  ('chair_seat', 1, 'headroom', 2.227, 0.1847),
  ('chair_seat', 1, 'height', 0.4914, 0.0225),
  ('chair_seat', 1, 'lift', -0.9858, 0.03107),
  ('chair_seat', 1, 'rectangularity', 0.8299, 0.07127),
  ('chair_seat', 1, 'spread_length', -0.7089, 0.05324),
  ('chair_seat', 1, 'spread_width', -0.9316, 0.09547),
  ('chair_seat', 1, 'standoff', -0.0004744, 0.3159),
  ('chair_seat', 1, 'tilt_deg', 0.3862, 0.45),
  ('chair_seat', 1, 'wall_offset', -0.003453, 0.3148),
  ('chair_seat', 1, 'width', -0.7717, 0.06546),
  ('chair_seat', 1, 'z_max', 0.4931, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4894, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.05351, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'aspect', 0.1512, 0.1234),
  ('chair_seat', 2, 'behind', 0.7574, 0.07197),
  ('chair_seat', 2, 'corner_offset', 0.9311, 0.6419),
  ('chair_seat', 2, 'edge_concave', 0.2097, 0.1632),
  ('chair_seat', 2, 'edge_convex', -0.001091, 0.03),
  ('chair_seat', 2, 'edge_free', 0.5735, 0.1222),
  ('chair_seat', 2, 'edge_free_top', -0.0003513, 0.316),
  ('chair_seat', 2, 'edge_unseen', 0.003054, 0.032),
  ('chair_seat', 2, 'headroom', 2.33, 0.3165),
  ('chair_seat', 2, 'height', 0.4472, 0.0225),
  ('chair_seat', 2, 'lift', -1.058, 0.03117),
  ('chair_seat', 2, 'rectangularity', 0.6677, 0.09505),
  ('chair_seat', 2, 'spread_length', -0.6769, 0.04827),
  ('chair_seat', 2, 'spread_width', -1.072, 0.1134),
  ('chair_seat', 2, 'standoff', -0.0001354, 0.316),
  ('chair_seat', 2, 'tilt_deg', 0.4565, 0.45),
  ('chair_seat', 2, 'wall_offset', -0.001985, 0.3144),
  ('chair_seat', 2, 'width', -0.8228, 0.07898),
  ('chair_seat', 2, 'z_max', 0.4488, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4457, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.1575, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'aspect', 0.1791, 0.1448),
  ('chair_seat', 3, 'behind', 0.6546, 0.1294),
  ('chair_seat', 3, 'corner_offset', 1.042, 0.1777),
  ('chair_seat', 3, 'edge_concave', 0.1768, 0.1691),
  ('chair_seat', 3, 'edge_convex', -0.0003652, 0.03),
  ('chair_seat', 3, 'edge_free', 0.5388, 0.1501),
  ('chair_seat', 3, 'edge_free_top', -0.001955, 0.3145),
  ('chair_seat', 3, 'edge_unseen', 0.07335, 0.107),
  ('chair_seat', 3, 'headroom', 1.605, 1.156),
  ('chair_seat', 3, 'height', 0.4951, 0.02575),
  ('chair_seat', 3, 'lift', -1.02, 0.03122),
  ('chair_seat', 3, 'rectangularity', 0.6695, 0.1226),
  ('chair_seat', 3, 'spread_length', -0.7271, 0.1006),
  ('chair_seat', 3, 'spread_width', -1.193, 0.1116),
  ('chair_seat', 3, 'standoff', -0.001782, 0.3161),
  ('chair_seat', 3, 'tilt_deg', 0.4862, 0.4585),
  ('chair_seat', 3, 'wall_offset', -0.007351, 0.312),
  ('chair_seat', 3, 'width', -0.8971, 0.09037),
  ('chair_seat', 3, 'z_max', 0.4974, 0.02719),
  ('chair_seat', 3, 'z_min', 0.4944, 0.02402);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.06728, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'aspect', 0.12, 0.07908),
  ('chair_seat', 4, 'behind', 0.6852, 0.08291),
  ('chair_seat', 4, 'corner_offset', 1.165, 0.1838),
  ('chair_seat', 4, 'edge_concave', 0.2243, 0.1587),
  ('chair_seat', 4, 'edge_convex', 0.0009441, 0.03),
  ('chair_seat', 4, 'edge_free', 0.7764, 0.1126),
  ('chair_seat', 4, 'edge_free_top', -0.0003518, 0.3156),
  ('chair_seat', 4, 'edge_unseen', 0.007193, 0.03004),
  ('chair_seat', 4, 'headroom', 2.255, 0.221),
  ('chair_seat', 4, 'height', 0.4442, 0.0225),
  ('chair_seat', 4, 'lift', -1.02, 0.0311),
  ('chair_seat', 4, 'rectangularity', 0.8584, 0.05223),
  ('chair_seat', 4, 'spread_length', -0.7334, 0.05572),
  ('chair_seat', 4, 'spread_width', -0.9125, 0.07011),
  ('chair_seat', 4, 'standoff', -0.0005617, 0.3159),
  ('chair_seat', 4, 'tilt_deg', 0.4017, 0.4503),
  ('chair_seat', 4, 'wall_offset', -0.002095, 0.315),
  ('chair_seat', 4, 'width', -0.8069, 0.07308),
  ('chair_seat', 4, 'z_max', 0.447, 0.0225),
  ('chair_seat', 4, 'z_min', 0.443, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.3691, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'aspect', 0.6769, 0.2144),
  ('chair_seat', 5, 'behind', 0.7689, 0.08817),
  ('chair_seat', 5, 'corner_offset', 1.007, 0.1581),
  ('chair_seat', 5, 'edge_concave', 0.2301, 0.2124),
  ('chair_seat', 5, 'edge_convex', 0.0001275, 0.03),
  ('chair_seat', 5, 'edge_free', 0.4478, 0.1504),
  ('chair_seat', 5, 'edge_free_top', -0.007739, 0.3164),
  ('chair_seat', 5, 'edge_unseen', 0.009055, 0.03),
  ('chair_seat', 5, 'headroom', 2.324, 0.4126),
  ('chair_seat', 5, 'height', 0.4777, 0.02788),
  ('chair_seat', 5, 'lift', -1.013, 0.03107),
  ('chair_seat', 5, 'rectangularity', 0.6992, 0.1036),
  ('chair_seat', 5, 'spread_length', -0.7779, 0.09273),
  ('chair_seat', 5, 'spread_width', -1.702, 0.2455),
  ('chair_seat', 5, 'standoff', -0.004301, 0.3321),
  ('chair_seat', 5, 'tilt_deg', 0.9422, 0.6458),
  ('chair_seat', 5, 'wall_offset', -0.02839, 0.3003),
  ('chair_seat', 5, 'width', -1.414, 0.1825),
  ('chair_seat', 5, 'z_max', 0.4809, 0.02602),
  ('chair_seat', 5, 'z_min', 0.4767, 0.02849);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.05119, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'aspect', 0.4987, 0.114),
  ('chair_seat', 6, 'behind', 0.5087, 0.3027),
  ('chair_seat', 6, 'corner_offset', 0.5564, 0.4817),
  ('chair_seat', 6, 'edge_concave', 0.1179, 0.1578),
  ('chair_seat', 6, 'edge_convex', 0.0005614, 0.03002),
  ('chair_seat', 6, 'edge_free', 0.6799, 0.1872),
  ('chair_seat', 6, 'edge_free_top', -0.00134, 0.314),
  ('chair_seat', 6, 'edge_unseen', 0.2436, 0.2125),
  ('chair_seat', 6, 'headroom', 1.951, 0.4046),
  ('chair_seat', 6, 'height', 0.4743, 0.0279),
  ('chair_seat', 6, 'lift', -1.02, 0.03107),
  ('chair_seat', 6, 'rectangularity', 0.653, 0.1371),
  ('chair_seat', 6, 'spread_length', -0.892, 0.1964),
  ('chair_seat', 6, 'spread_width', -1.52, 0.1809),
  ('chair_seat', 6, 'standoff', -0.0003722, 0.3169),
  ('chair_seat', 6, 'tilt_deg', 0.5886, 0.45),
  ('chair_seat', 6, 'wall_offset', -0.004799, 0.3144),
  ('chair_seat', 6, 'width', -1.285, 0.1326),
  ('chair_seat', 6, 'z_max', 0.4747, 0.02768),
  ('chair_seat', 6, 'z_min', 0.4712, 0.02809);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.116, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'aspect', 0.558, 0.2555),
  ('chair_seat', 7, 'behind', 0.3574, 0.3142),
  ('chair_seat', 7, 'corner_offset', 1.035, 0.1458),
  ('chair_seat', 7, 'edge_concave', 0.1876, 0.268),
  ('chair_seat', 7, 'edge_convex', 0.0004398, 0.03),
  ('chair_seat', 7, 'edge_free', 0.526, 0.1318),
  ('chair_seat', 7, 'edge_free_top', -0.01033, 0.3099),
  ('chair_seat', 7, 'edge_unseen', 0.1569, 0.1188),
  ('chair_seat', 7, 'headroom', 1.868, 0.3849),
  ('chair_seat', 7, 'height', 0.4733, 0.04226),
  ('chair_seat', 7, 'lift', -1.02, 0.03107),
  ('chair_seat', 7, 'rectangularity', 0.6877, 0.07056),
  ('chair_seat', 7, 'spread_length', -1.236, 0.2251),
  ('chair_seat', 7, 'spread_width', -2.052, 0.1837),
  ('chair_seat', 7, 'standoff', -0.006132, 0.3197),
  ('chair_seat', 7, 'tilt_deg', 2.356, 1.298),
  ('chair_seat', 7, 'wall_offset', -0.0167, 0.3174),
  ('chair_seat', 7, 'width', -1.791, 0.2024),
  ('chair_seat', 7, 'z_max', 0.4714, 0.03762),
  ('chair_seat', 7, 'z_min', 0.4736, 0.04357);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.02539, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'aspect', 0.1335, 0.08248),
  ('chair_seat', 8, 'behind', 0.6861, 0.1053),
  ('chair_seat', 8, 'corner_offset', 1.17, 0.2183),
  ('chair_seat', 8, 'edge_concave', 0.1762, 0.1394),
  ('chair_seat', 8, 'edge_convex', 0.2878, 0.09119),
  ('chair_seat', 8, 'edge_free', 0.6937, 0.1556),
  ('chair_seat', 8, 'edge_free_top', -0.0001992, 0.3161),
  ('chair_seat', 8, 'edge_unseen', 0.004032, 0.03061),
  ('chair_seat', 8, 'headroom', 2.262, 0.2565),
  ('chair_seat', 8, 'height', 0.4695, 0.0285),
  ('chair_seat', 8, 'lift', -1.02, 0.03107),
  ('chair_seat', 8, 'rectangularity', 0.7506, 0.1393),
  ('chair_seat', 8, 'spread_length', -0.7335, 0.09466),
  ('chair_seat', 8, 'spread_width', -1.053, 0.1482),
  ('chair_seat', 8, 'standoff', -0.0002651, 0.316),
  ('chair_seat', 8, 'tilt_deg', 0.3025, 0.4502),
  ('chair_seat', 8, 'wall_offset', -0.001399, 0.3153),
  ('chair_seat', 8, 'width', -0.8316, 0.09138),
  ('chair_seat', 8, 'z_max', 0.4705, 0.02778),
  ('chair_seat', 8, 'z_min', 0.468, 0.02798);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.01952, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'aspect', 0.1689, 0.204),
  ('chair_seat', 9, 'behind', 0.8, 0.03616),
  ('chair_seat', 9, 'corner_offset', 1.184, 0.3013),
  ('chair_seat', 9, 'edge_concave', 0.202, 0.09831),
  ('chair_seat', 9, 'edge_convex', 0.004711, 0.03001),
  ('chair_seat', 9, 'edge_free', 0.5738, 0.09634),
  ('chair_seat', 9, 'edge_free_top', -0.0001545, 0.316),
  ('chair_seat', 9, 'edge_unseen', 0.006565, 0.03009),
  ('chair_seat', 9, 'headroom', 0.3697, 0.1584),
  ('chair_seat', 9, 'height', 0.4501, 0.0225),
  ('chair_seat', 9, 'lift', -1.02, 0.03107),
  ('chair_seat', 9, 'rectangularity', 0.7835, 0.1252),
  ('chair_seat', 9, 'spread_length', -0.6938, 0.2282),
  ('chair_seat', 9, 'spread_width', -0.9916, 0.121),
  ('chair_seat', 9, 'standoff', -9.709e-05, 0.3162),
  ('chair_seat', 9, 'tilt_deg', 0.5596, 0.45),
  ('chair_seat', 9, 'wall_offset', -0.0005412, 0.3157),
  ('chair_seat', 9, 'width', -0.7865, 0.1174),
  ('chair_seat', 9, 'z_max', 0.4525, 0.0225),
  ('chair_seat', 9, 'z_min', 0.4481, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 10, 0.006645, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 10, 'aspect', 0.4218, 0.2291),
  ('chair_seat', 10, 'behind', 0.5389, 0.1712),
  ('chair_seat', 10, 'corner_offset', 0.9901, 0.219),
  ('chair_seat', 10, 'edge_concave', 0.09518, 0.1059),
  ('chair_seat', 10, 'edge_convex', 0.2529, 0.152),
  ('chair_seat', 10, 'edge_free', 0.4972, 0.1302),
  ('chair_seat', 10, 'edge_free_top', -0.001945, 0.3134),
  ('chair_seat', 10, 'edge_unseen', 0.09041, 0.09952),
  ('chair_seat', 10, 'headroom', 1.094, 0.623),
  ('chair_seat', 10, 'height', 0.436, 0.1645),
  ('chair_seat', 10, 'lift', -1.02, 0.03107),
  ('chair_seat', 10, 'rectangularity', 0.7584, 0.05731),
  ('chair_seat', 10, 'spread_length', -0.8713, 0.1363),
  ('chair_seat', 10, 'spread_width', -1.426, 0.3173),
  ('chair_seat', 10, 'standoff', -0.00159, 0.3143),
  ('chair_seat', 10, 'tilt_deg', 1.288, 0.7694),
  ('chair_seat', 10, 'wall_offset', -0.007376, 0.3122),
  ('chair_seat', 10, 'width', -1.213, 0.3087),
  ('chair_seat', 10, 'z_max', 0.4404, 0.1493),
  ('chair_seat', 10, 'z_min', 0.4496, 0.1299);

-- chair_back: 483 examples
UPDATE object_class SET prior = 0.04996 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3824, 0.2906)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.5752, 0.2886)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'corner_offset', 1.605, 0.8588)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_concave', 0.06607, 0.1124)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_convex', 0.08849, 0.1293)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.7938, 0.1968)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9471, 0.1618)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_unseen', 0.07804, 0.1574)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'headroom', 1.738, 0.2829)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.818, 0.07962)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'lift', -4.507, 1.303)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7808, 0.1215)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.7139, 0.2369)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.126, 0.3948)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'standoff', 1.072, 0.3324)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.48, 3.827)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'wall_offset', 1.442, 0.8054)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.933, 0.3446)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.024, 0.08937)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4513, 0.1601)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_back';
DELETE FROM class_density WHERE class = 'chair_back';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1033, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'aspect', 0.2484, 0.1799),
  ('chair_back', 1, 'behind', 0.1993, 0.5696),
  ('chair_back', 1, 'corner_offset', 2.456, 2.203),
  ('chair_back', 1, 'edge_concave', -0.004107, 0.03754),
  ('chair_back', 1, 'edge_convex', 0.0007844, 0.04541),
  ('chair_back', 1, 'edge_free', 0.8998, 0.3932),
  ('chair_back', 1, 'edge_free_top', 0.9993, 0.03002),
  ('chair_back', 1, 'edge_unseen', 0.2885, 0.4121),
  ('chair_back', 1, 'headroom', 1.744, 0.1071),
  ('chair_back', 1, 'height', 0.8985, 0.1032),
  ('chair_back', 1, 'lift', -1.79, 0.283),
  ('chair_back', 1, 'rectangularity', 0.6233, 0.05916),
  ('chair_back', 1, 'spread_length', -1.207, 0.2983),
  ('chair_back', 1, 'spread_width', -1.767, 0.3631),
  ('chair_back', 1, 'standoff', 1.084, 0.1807),
  ('chair_back', 1, 'tilt_deg', 80.76, 2.433),
  ('chair_back', 1, 'wall_offset', 1.726, 0.6638),
  ('chair_back', 1, 'width', -1.431, 0.4031),
  ('chair_back', 1, 'z_max', 0.9997, 0.06275),
  ('chair_back', 1, 'z_min', 0.6515, 0.08698);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.07617, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'aspect', 0.251, 0.1457),
  ('chair_back', 2, 'behind', 0.7294, 0.09633),
  ('chair_back', 2, 'corner_offset', 1.872, 0.5469),
  ('chair_back', 2, 'edge_concave', 0.002736, 0.03013),
  ('chair_back', 2, 'edge_convex', 0.3092, 0.1007),
  ('chair_back', 2, 'edge_free', 0.8781, 0.07379),
  ('chair_back', 2, 'edge_free_top', 0.9954, 0.03543),
  ('chair_back', 2, 'edge_unseen', 0.001625, 0.03476),
  ('chair_back', 2, 'headroom', 1.734, 0.1305),
  ('chair_back', 2, 'height', 0.7338, 0.04425),
  ('chair_back', 2, 'lift', -5.284, 0.1104),
  ('chair_back', 2, 'rectangularity', 0.8225, 0.1143),
  ('chair_back', 2, 'spread_length', -0.6603, 0.08402),
  ('chair_back', 2, 'spread_width', -0.979, 0.2376),
  ('chair_back', 2, 'standoff', 1.234, 0.1732),
  ('chair_back', 2, 'tilt_deg', 81.48, 2.668),
  ('chair_back', 2, 'wall_offset', 1.415, 0.4193),
  ('chair_back', 2, 'width', -0.7671, 0.1099),
  ('chair_back', 2, 'z_max', 0.9371, 0.05585),
  ('chair_back', 2, 'z_min', 0.3579, 0.03625);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.1747, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'aspect', 0.2086, 0.1985),
  ('chair_back', 3, 'behind', 0.6272, 0.3097),
  ('chair_back', 3, 'corner_offset', 1.293, 0.4513),
  ('chair_back', 3, 'edge_concave', -0.0009411, 0.03),
  ('chair_back', 3, 'edge_convex', 0.001484, 0.03),
  ('chair_back', 3, 'edge_free', 0.7134, 0.1106),
  ('chair_back', 3, 'edge_free_top', 1, 0.03),
  ('chair_back', 3, 'edge_unseen', 0.04376, 0.09298),
  ('chair_back', 3, 'headroom', 1.776, 0.3279),
  ('chair_back', 3, 'height', 0.8281, 0.06131),
  ('chair_back', 3, 'lift', -1.978, 0.5229),
  ('chair_back', 3, 'rectangularity', 0.8961, 0.03111),
  ('chair_back', 3, 'spread_length', -0.7435, 0.05402),
  ('chair_back', 3, 'spread_width', -1.06, 0.2522),
  ('chair_back', 3, 'standoff', 0.9599, 0.2957),
  ('chair_back', 3, 'tilt_deg', 81.06, 2.647),
  ('chair_back', 3, 'wall_offset', 1.24, 0.4085),
  ('chair_back', 3, 'width', -0.9248, 0.17),
  ('chair_back', 3, 'z_max', 1.008, 0.07946),
  ('chair_back', 3, 'z_min', 0.5692, 0.04569);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.08098, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'aspect', 0.1688, 0.05929),
  ('chair_back', 4, 'behind', 0.7286, 0.08865),
  ('chair_back', 4, 'corner_offset', 1.572, 1.004),
  ('chair_back', 4, 'edge_concave', 0.2063, 0.04793),
  ('chair_back', 4, 'edge_convex', 0.001351, 0.03002),
  ('chair_back', 4, 'edge_free', 0.6229, 0.1142),
  ('chair_back', 4, 'edge_free_top', 0.9929, 0.03782),
  ('chair_back', 4, 'edge_unseen', 0.001502, 0.03027),
  ('chair_back', 4, 'headroom', 1.606, 0.2462),
  ('chair_back', 4, 'height', 0.7911, 0.06681),
  ('chair_back', 4, 'lift', -5.121, 0.3784),
  ('chair_back', 4, 'rectangularity', 0.7956, 0.08129),
  ('chair_back', 4, 'spread_length', -0.691, 0.07739),
  ('chair_back', 4, 'spread_width', -0.8253, 0.1089),
  ('chair_back', 4, 'standoff', 0.8892, 0.3078),
  ('chair_back', 4, 'tilt_deg', 79.6, 2.247),
  ('chair_back', 4, 'wall_offset', 1.466, 1.031),
  ('chair_back', 4, 'width', -0.6757, 0.08936),
  ('chair_back', 4, 'z_max', 1.005, 0.07167),
  ('chair_back', 4, 'z_min', 0.4428, 0.02262);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.1579, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'aspect', 0.6725, 0.1728),
  ('chair_back', 5, 'behind', 0.7002, 0.06999),
  ('chair_back', 5, 'corner_offset', 1.344, 0.3595),
  ('chair_back', 5, 'edge_concave', 0.1873, 0.07187),
  ('chair_back', 5, 'edge_convex', 0.03259, 0.0667),
  ('chair_back', 5, 'edge_free', 0.7677, 0.1998),
  ('chair_back', 5, 'edge_free_top', 0.9858, 0.05019),
  ('chair_back', 5, 'edge_unseen', 0.003171, 0.03008),
  ('chair_back', 5, 'headroom', 1.658, 0.1741),
  ('chair_back', 5, 'height', 0.7921, 0.04948),
  ('chair_back', 5, 'lift', -4.961, 0.4851),
  ('chair_back', 5, 'rectangularity', 0.6428, 0.08401),
  ('chair_back', 5, 'spread_length', -0.5314, 0.1389),
  ('chair_back', 5, 'spread_width', -1.133, 0.3566),
  ('chair_back', 5, 'standoff', 1.235, 0.1179),
  ('chair_back', 5, 'tilt_deg', 79.85, 2.479),
  ('chair_back', 5, 'wall_offset', 1.577, 0.3326),
  ('chair_back', 5, 'width', -0.8851, 0.269),
  ('chair_back', 5, 'z_max', 1.061, 0.09778),
  ('chair_back', 5, 'z_min', 0.1588, 0.1418);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.08381, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'aspect', 0.4787, 0.09606),
  ('chair_back', 6, 'behind', 0.4164, 0.2454),
  ('chair_back', 6, 'corner_offset', 1.686, 0.655),
  ('chair_back', 6, 'edge_concave', 0.00257, 0.03073),
  ('chair_back', 6, 'edge_convex', 0.1595, 0.1304),
  ('chair_back', 6, 'edge_free', 0.9663, 0.05426),
  ('chair_back', 6, 'edge_free_top', 0.9986, 0.03),
  ('chair_back', 6, 'edge_unseen', 0.0981, 0.1378),
  ('chair_back', 6, 'headroom', 1.606, 0.2197),
  ('chair_back', 6, 'height', 0.8237, 0.05378),
  ('chair_back', 6, 'lift', -5.272, 0.1904),
  ('chair_back', 6, 'rectangularity', 0.8709, 0.07046),
  ('chair_back', 6, 'spread_length', -0.5481, 0.1027),
  ('chair_back', 6, 'spread_width', -0.8923, 0.1605),
  ('chair_back', 6, 'standoff', 1.124, 0.2535),
  ('chair_back', 6, 'tilt_deg', 79.13, 2.789),
  ('chair_back', 6, 'wall_offset', 1.33, 0.3953),
  ('chair_back', 6, 'width', -0.7843, 0.07253),
  ('chair_back', 6, 'z_max', 1.06, 0.07981),
  ('chair_back', 6, 'z_min', 0.3571, 0.04166);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.06955, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'aspect', 0.2559, 0.1732),
  ('chair_back', 7, 'behind', 0.607, 0.3703),
  ('chair_back', 7, 'corner_offset', 1.675, 0.387),
  ('chair_back', 7, 'edge_concave', 0.09142, 0.09715),
  ('chair_back', 7, 'edge_convex', 0.07799, 0.1137),
  ('chair_back', 7, 'edge_free', 0.5489, 0.1357),
  ('chair_back', 7, 'edge_free_top', 0.6621, 0.2917),
  ('chair_back', 7, 'edge_unseen', 0.04939, 0.107),
  ('chair_back', 7, 'headroom', 1.844, 0.2401),
  ('chair_back', 7, 'height', 0.7792, 0.03971),
  ('chair_back', 7, 'lift', -4.236, 1.175),
  ('chair_back', 7, 'rectangularity', 0.7939, 0.1066),
  ('chair_back', 7, 'spread_length', -0.7231, 0.154),
  ('chair_back', 7, 'spread_width', -1.038, 0.2478),
  ('chair_back', 7, 'standoff', 1.065, 0.2424),
  ('chair_back', 7, 'tilt_deg', 80.76, 2.384),
  ('chair_back', 7, 'wall_offset', 1.568, 0.4649),
  ('chair_back', 7, 'width', -0.8577, 0.1297),
  ('chair_back', 7, 'z_max', 0.9806, 0.07026),
  ('chair_back', 7, 'z_min', 0.462, 0.04956);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.08423, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'aspect', 0.7514, 0.2186),
  ('chair_back', 8, 'behind', 0.5899, 0.3336),
  ('chair_back', 8, 'corner_offset', 1.359, 0.2852),
  ('chair_back', 8, 'edge_concave', 0.004335, 0.03),
  ('chair_back', 8, 'edge_convex', 0.2259, 0.06312),
  ('chair_back', 8, 'edge_free', 0.8059, 0.06659),
  ('chair_back', 8, 'edge_free_top', 0.9972, 0.03),
  ('chair_back', 8, 'edge_unseen', 0.02425, 0.05448),
  ('chair_back', 8, 'headroom', 1.765, 0.3049),
  ('chair_back', 8, 'height', 0.8255, 0.04916),
  ('chair_back', 8, 'lift', -5.271, 0.1585),
  ('chair_back', 8, 'rectangularity', 0.7059, 0.1283),
  ('chair_back', 8, 'spread_length', -0.5553, 0.09803),
  ('chair_back', 8, 'spread_width', -1.415, 0.2297),
  ('chair_back', 8, 'standoff', 0.8971, 0.3899),
  ('chair_back', 8, 'tilt_deg', 80.46, 2.53),
  ('chair_back', 8, 'wall_offset', 1.508, 0.366),
  ('chair_back', 8, 'width', -1.097, 0.2523),
  ('chair_back', 8, 'z_max', 1.093, 0.07512),
  ('chair_back', 8, 'z_min', 0.3939, 0.07317);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.1053, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'aspect', 0.9586, 0.3325),
  ('chair_back', 9, 'behind', 0.3704, 0.4142),
  ('chair_back', 9, 'corner_offset', 1.918, 0.4662),
  ('chair_back', 9, 'edge_concave', 0.01299, 0.0346),
  ('chair_back', 9, 'edge_convex', 0.01008, 0.03013),
  ('chair_back', 9, 'edge_free', 0.4809, 0.1317),
  ('chair_back', 9, 'edge_free_top', 0.5118, 0.266),
  ('chair_back', 9, 'edge_unseen', 0.1178, 0.143),
  ('chair_back', 9, 'headroom', 2.121, 0.3878),
  ('chair_back', 9, 'height', 0.9049, 0.0528),
  ('chair_back', 9, 'lift', -2.406, 0.8411),
  ('chair_back', 9, 'rectangularity', 0.6827, 0.1141),
  ('chair_back', 9, 'spread_length', -0.8608, 0.1361),
  ('chair_back', 9, 'spread_width', -1.873, 0.3332),
  ('chair_back', 9, 'standoff', 0.8884, 0.3192),
  ('chair_back', 9, 'tilt_deg', 79.33, 2.652),
  ('chair_back', 9, 'wall_offset', 3.01, 3.257),
  ('chair_back', 9, 'width', -1.618, 0.4392),
  ('chair_back', 9, 'z_max', 1.061, 0.04912),
  ('chair_back', 9, 'z_min', 0.6044, 0.05396);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 10, 0.014, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 10, 'aspect', 0.52, 0.2551),
  ('chair_back', 10, 'behind', 0.08072, 0.1084),
  ('chair_back', 10, 'corner_offset', 1.625, 0.2592),
  ('chair_back', 10, 'edge_concave', 0.1288, 0.1864),
  ('chair_back', 10, 'edge_convex', 0.01143, 0.03),
  ('chair_back', 10, 'edge_free', 0.5616, 0.3965),
  ('chair_back', 10, 'edge_free_top', 0.9734, 0.04788),
  ('chair_back', 10, 'edge_unseen', 0.487, 0.1296),
  ('chair_back', 10, 'headroom', 1.73, 0.0909),
  ('chair_back', 10, 'height', 0.3559, 0.2761),
  ('chair_back', 10, 'lift', -2.984, 0.5298),
  ('chair_back', 10, 'rectangularity', 0.6023, 0.07764),
  ('chair_back', 10, 'spread_length', -1.313, 0.243),
  ('chair_back', 10, 'spread_width', -1.845, 0.3448),
  ('chair_back', 10, 'standoff', 1.071, 0.1045),
  ('chair_back', 10, 'tilt_deg', 80.25, 1.187),
  ('chair_back', 10, 'wall_offset', 1.524, 0.3893),
  ('chair_back', 10, 'width', -1.613, 0.3467),
  ('chair_back', 10, 'z_max', 0.5206, 0.2917),
  ('chair_back', 10, 'z_min', 0.1591, 0.3115);

-- door: 295 examples
UPDATE object_class SET prior = 0.02257 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.8219, 0.2943)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.1607, 0.255)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'corner_offset', 1.012, 0.7905)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_concave', 0.1494, 0.1438)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_convex', 2.56e-05, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.1405, 0.243)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.2376, 0.3797)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_unseen', 0.1077, 0.1747)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'headroom', 0.6961, 0.3508)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.148, 0.1876)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8191, 0.1265)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4763, 0.2869)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.31, 0.3862)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'standoff', 0.3374, 0.4595)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.72, 1.289)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'wall_offset', 0.4877, 1.319)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1827, 0.3499)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.054, 0.256)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1219, 0.2824)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'door';
DELETE FROM class_density WHERE class = 'door';
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.1789, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'aspect', 0.771, 0.288),
  ('door', 1, 'behind', -0.008405, 0.03),
  ('door', 1, 'corner_offset', 0.8149, 0.8842),
  ('door', 1, 'edge_concave', 0.1121, 0.1031),
  ('door', 1, 'edge_convex', -0.0002292, 0.03),
  ('door', 1, 'edge_free', -0.004608, 0.03),
  ('door', 1, 'edge_free_top', 0.004721, 0.03003),
  ('door', 1, 'edge_unseen', 0.02788, 0.1041),
  ('door', 1, 'headroom', 0.6582, 0.4001),
  ('door', 1, 'height', 1.127, 0.08411),
  ('door', 1, 'lift', 0.03205, 0.2551),
  ('door', 1, 'rectangularity', 0.842, 0.1572),
  ('door', 1, 'spread_length', 0.5727, 0.07644),
  ('door', 1, 'spread_width', -0.1306, 0.0762),
  ('door', 1, 'standoff', 0.04976, 0.1757),
  ('door', 1, 'tilt_deg', 90.02, 0.45),
  ('door', 1, 'wall_offset', -0.09224, 0.04),
  ('door', 1, 'width', -0.1345, 0.08719),
  ('door', 1, 'z_max', 2.037, 0.03786),
  ('door', 1, 'z_min', -0.00012, 0.02635);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1606, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'aspect', 0.8639, 0.05648),
  ('door', 2, 'behind', 0.4811, 0.1378),
  ('door', 2, 'corner_offset', 0.5472, 0.08419),
  ('door', 2, 'edge_concave', 0.2159, 0.1156),
  ('door', 2, 'edge_convex', -0.0004785, 0.03),
  ('door', 2, 'edge_free', 0.4119, 0.1127),
  ('door', 2, 'edge_free_top', 0.7998, 0.1671),
  ('door', 2, 'edge_unseen', 0.003904, 0.03),
  ('door', 2, 'headroom', 0.6484, 0.4444),
  ('door', 2, 'height', 1.076, 0.02511),
  ('door', 2, 'lift', -1.342e-05, 0.3163),
  ('door', 2, 'rectangularity', 0.8656, 0.06031),
  ('door', 2, 'spread_length', 0.6858, 0.04147),
  ('door', 2, 'spread_width', -0.1221, 0.09551),
  ('door', 2, 'standoff', 0.6802, 0.1957),
  ('door', 2, 'tilt_deg', 89.99, 0.45),
  ('door', 2, 'wall_offset', 0.766, 0.4268),
  ('door', 2, 'width', -0.02458, 0.09573),
  ('door', 2, 'z_max', 2.156, 0.08401),
  ('door', 2, 'z_min', -0.008799, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.1844, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'aspect', 0.6114, 0.2356),
  ('door', 3, 'behind', -0.004757, 0.03),
  ('door', 3, 'corner_offset', 0.8371, 0.2401),
  ('door', 3, 'edge_concave', 0.01472, 0.03101),
  ('door', 3, 'edge_convex', -0.0004573, 0.03),
  ('door', 3, 'edge_free', -0.006637, 0.03),
  ('door', 3, 'edge_free_top', 0.0019, 0.03),
  ('door', 3, 'edge_unseen', 0.2395, 0.2134),
  ('door', 3, 'headroom', 0.7796, 0.3178),
  ('door', 3, 'height', 1.403, 0.06855),
  ('door', 3, 'lift', 0.06573, 0.2085),
  ('door', 3, 'rectangularity', 0.7202, 0.138),
  ('door', 3, 'spread_length', 0.058, 0.1711),
  ('door', 3, 'spread_width', -0.2712, 0.09649),
  ('door', 3, 'standoff', 0.1209, 0.1145),
  ('door', 3, 'tilt_deg', 90.02, 0.45),
  ('door', 3, 'wall_offset', 0.6506, 2.129),
  ('door', 3, 'width', -0.1242, 0.0611),
  ('door', 3, 'z_max', 2.062, 0.04462),
  ('door', 3, 'z_min', 0.3484, 0.1826);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.04619, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'aspect', 1.023, 0.2281),
  ('door', 4, 'behind', 0.003843, 0.03172),
  ('door', 4, 'corner_offset', 1.697, 0.3971),
  ('door', 4, 'edge_concave', 0.07745, 0.06269),
  ('door', 4, 'edge_convex', -0.000812, 0.03),
  ('door', 4, 'edge_free', 0.01245, 0.0367),
  ('door', 4, 'edge_free_top', 0.01234, 0.04297),
  ('door', 4, 'edge_unseen', 0.3566, 0.1995),
  ('door', 4, 'headroom', 0.593, 0.191),
  ('door', 4, 'height', 1.155, 0.1526),
  ('door', 4, 'lift', 0.005329, 0.3099),
  ('door', 4, 'rectangularity', 0.7242, 0.08247),
  ('door', 4, 'spread_length', 0.5343, 0.08136),
  ('door', 4, 'spread_width', -0.3846, 0.3039),
  ('door', 4, 'standoff', 0.1705, 0.1496),
  ('door', 4, 'tilt_deg', 89.78, 0.568),
  ('door', 4, 'wall_offset', 4.863, 0.4986),
  ('door', 4, 'width', -0.1823, 0.3106),
  ('door', 4, 'z_max', 2.126, 0.2328),
  ('door', 4, 'z_min', 0.06885, 0.1014);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.1303, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'aspect', 0.5976, 0.2161),
  ('door', 5, 'behind', 0.6045, 0.1342),
  ('door', 5, 'corner_offset', 0.4553, 0.0404),
  ('door', 5, 'edge_concave', 0.08799, 0.05721),
  ('door', 5, 'edge_convex', 0.001326, 0.03005),
  ('door', 5, 'edge_free', 0.3423, 0.2871),
  ('door', 5, 'edge_free_top', 0.5243, 0.2081),
  ('door', 5, 'edge_unseen', 0.1479, 0.1848),
  ('door', 5, 'headroom', 0.4442, 0.3089),
  ('door', 5, 'height', 1.368, 0.1701),
  ('door', 5, 'lift', 0.01169, 0.2966),
  ('door', 5, 'rectangularity', 0.6911, 0.1163),
  ('door', 5, 'spread_length', 0.0008082, 0.2014),
  ('door', 5, 'spread_width', -0.2401, 0.1849),
  ('door', 5, 'standoff', 0.5194, 0.2527),
  ('door', 5, 'tilt_deg', 89.99, 0.4511),
  ('door', 5, 'wall_offset', 2.325, 2.655),
  ('door', 5, 'width', -0.202, 0.1786),
  ('door', 5, 'z_max', 2.073, 0.1626),
  ('door', 5, 'z_min', 0.655, 0.2732);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.06116, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'aspect', 0.8492, 0.08382),
  ('door', 6, 'behind', 0.4333, 0.09281),
  ('door', 6, 'corner_offset', -0.01214, 0.2737),
  ('door', 6, 'edge_concave', 0.2045, 0.1715),
  ('door', 6, 'edge_convex', 0.02498, 0.07149),
  ('door', 6, 'edge_free', 0.377, 0.2317),
  ('door', 6, 'edge_free_top', 0.8236, 0.1199),
  ('door', 6, 'edge_unseen', 0.1454, 0.1556),
  ('door', 6, 'headroom', 0.6207, 0.2487),
  ('door', 6, 'height', 1.211, 0.06164),
  ('door', 6, 'lift', 6.673e-05, 0.3162),
  ('door', 6, 'rectangularity', 0.7884, 0.1387),
  ('door', 6, 'spread_length', 0.3672, 0.1599),
  ('door', 6, 'spread_width', -0.2698, 0.16),
  ('door', 6, 'standoff', 0.342, 0.1159),
  ('door', 6, 'tilt_deg', 89.98, 0.45),
  ('door', 6, 'wall_offset', 0.5183, 0.3731),
  ('door', 6, 'width', -0.07226, 0.09949),
  ('door', 6, 'z_max', 2.164, 0.08631),
  ('door', 6, 'z_min', -0.008154, 0.02429);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.04771, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'aspect', 0.9886, 0.249),
  ('door', 7, 'behind', 0.2234, 0.1501),
  ('door', 7, 'corner_offset', 3.458, 0.5848),
  ('door', 7, 'edge_concave', 0.0874, 0.05107),
  ('door', 7, 'edge_convex', -0.0003033, 0.03),
  ('door', 7, 'edge_free', 0.4317, 0.3255),
  ('door', 7, 'edge_free_top', 0.7865, 0.2438),
  ('door', 7, 'edge_unseen', 0.4004, 0.05859),
  ('door', 7, 'headroom', 0.6817, 0.1033),
  ('door', 7, 'height', 1.206, 0.09916),
  ('door', 7, 'lift', 0.001039, 0.3154),
  ('door', 7, 'rectangularity', 0.6816, 0.04659),
  ('door', 7, 'spread_length', 0.402, 0.08103),
  ('door', 7, 'spread_width', -0.3974, 0.2363),
  ('door', 7, 'standoff', 0.7388, 0.2019),
  ('door', 7, 'tilt_deg', 89.26, 1.291),
  ('door', 7, 'wall_offset', 1.536, 2.13),
  ('door', 7, 'width', -0.2418, 0.2002),
  ('door', 7, 'z_max', 2.1, 0.07439),
  ('door', 7, 'z_min', 0.02295, 0.07617);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.02744, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'aspect', 1.644, 0.2631),
  ('door', 8, 'behind', 0.03383, 0.07932),
  ('door', 8, 'corner_offset', 1.004, 0.2438),
  ('door', 8, 'edge_concave', 0.09251, 0.1377),
  ('door', 8, 'edge_convex', -0.0009247, 0.03441),
  ('door', 8, 'edge_free', 0.1061, 0.2796),
  ('door', 8, 'edge_free_top', 0.09461, 0.2408),
  ('door', 8, 'edge_unseen', 0.2011, 0.2132),
  ('door', 8, 'headroom', 0.851, 0.2886),
  ('door', 8, 'height', 1.08, 0.1753),
  ('door', 8, 'lift', 0.007044, 0.3124),
  ('door', 8, 'rectangularity', 0.7314, 0.1637),
  ('door', 8, 'spread_length', 0.4985, 0.2699),
  ('door', 8, 'spread_width', -1.37, 0.2568),
  ('door', 8, 'standoff', 0.1928, 0.1417),
  ('door', 8, 'tilt_deg', 89.92, 0.4513),
  ('door', 8, 'wall_offset', -0.004355, 0.1883),
  ('door', 8, 'width', -1.025, 0.3194),
  ('door', 8, 'z_max', 2.024, 0.04009),
  ('door', 8, 'z_min', 0.1687, 0.189);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.08115, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'aspect', 0.8562, 0.2276),
  ('door', 9, 'behind', 0.0277, 0.07365),
  ('door', 9, 'corner_offset', 1.018, 0.06059),
  ('door', 9, 'edge_concave', 0.1557, 0.1131),
  ('door', 9, 'edge_convex', -0.0004435, 0.03008),
  ('door', 9, 'edge_free', 0.1099, 0.1288),
  ('door', 9, 'edge_free_top', 0.09206, 0.192),
  ('door', 9, 'edge_unseen', 0.07708, 0.1279),
  ('door', 9, 'headroom', 1.658, 0.2319),
  ('door', 9, 'height', 0.64, 0.3421),
  ('door', 9, 'lift', 0.006461, 0.3084),
  ('door', 9, 'rectangularity', 0.8459, 0.08349),
  ('door', 9, 'spread_length', -0.1551, 0.2755),
  ('door', 9, 'spread_width', -1.085, 0.2351),
  ('door', 9, 'standoff', 0.1798, 0.1265),
  ('door', 9, 'tilt_deg', 89.24, 0.7943),
  ('door', 9, 'wall_offset', 0.7255, 2.005),
  ('door', 9, 'width', -0.9955, 0.2183),
  ('door', 9, 'z_max', 1.018, 0.324),
  ('door', 9, 'z_min', 0.06371, 0.1042);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.03213, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'aspect', 1.59, 0.1735),
  ('door', 10, 'behind', 0.2009, 0.3695),
  ('door', 10, 'corner_offset', 0.8919, 0.2652),
  ('door', 10, 'edge_concave', 0.05154, 0.07583),
  ('door', 10, 'edge_convex', -0.0002955, 0.03002),
  ('door', 10, 'edge_free', 0.3281, 0.1559),
  ('door', 10, 'edge_free_top', 0.2255, 0.4243),
  ('door', 10, 'edge_unseen', 0.07799, 0.05243),
  ('door', 10, 'headroom', 0.6559, 0.05845),
  ('door', 10, 'height', 1.498, 0.3011),
  ('door', 10, 'lift', -0.006181, 0.3393),
  ('door', 10, 'rectangularity', 0.6906, 0.04983),
  ('door', 10, 'spread_length', 0.1646, 0.4778),
  ('door', 10, 'spread_width', -1.612, 0.4296),
  ('door', 10, 'standoff', 0.268, 0.0993),
  ('door', 10, 'tilt_deg', 84.49, 3.447),
  ('door', 10, 'wall_offset', 0.5833, 0.6089),
  ('door', 10, 'width', -1.247, 0.7083),
  ('door', 10, 'z_max', 2.039, 0.1034),
  ('door', 10, 'z_min', 0.8224, 0.7575);

-- window: 719 examples
UPDATE object_class SET prior = 0.02339 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.4487, 0.4055)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 0.001234, 0.01123)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'corner_offset', 1.43, 0.9169)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_concave', 0.2472, 0.2789)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_convex', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.08277, 0.1596)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.07367, 0.195)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_unseen', 0.1398, 0.1615)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'headroom', 0.2931, 0.3867)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.496, 0.204)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'lift', -3.416, 1.93)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.7619, 0.1896)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.1804, 0.3466)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.3725, 0.5763)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'standoff', 0.001195, 0.01846)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.75, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'wall_offset', 0.3962, 1.448)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.2721, 0.4907)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.044, 0.2651)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 1.016, 0.2164)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'window';
DELETE FROM class_density WHERE class = 'window';
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.1725, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'aspect', 0.2357, 0.1186),
  ('window', 1, 'behind', -0.0006256, 0.03),
  ('window', 1, 'corner_offset', 1.748, 1.244),
  ('window', 1, 'edge_concave', 0.2166, 0.1069),
  ('window', 1, 'edge_convex', -0.003837, 0.03002),
  ('window', 1, 'edge_free', -0.0005935, 0.03959),
  ('window', 1, 'edge_free_top', 5.152e-05, 0.03003),
  ('window', 1, 'edge_unseen', 0.02881, 0.04533),
  ('window', 1, 'headroom', -0.003847, 0.03116),
  ('window', 1, 'height', 1.476, 0.08259),
  ('window', 1, 'lift', -5.221, 0.272),
  ('window', 1, 'rectangularity', 0.8624, 0.08633),
  ('window', 1, 'spread_length', 0.382, 0.1346),
  ('window', 1, 'spread_width', 0.1326, 0.2831),
  ('window', 1, 'standoff', 0.01455, 0.00775),
  ('window', 1, 'tilt_deg', 89.88, 0.45),
  ('window', 1, 'wall_offset', -0.1681, 0.05898),
  ('window', 1, 'width', 0.007583, 0.1085),
  ('window', 1, 'z_max', 2.127, 0.09586),
  ('window', 1, 'z_min', 0.8973, 0.04788);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1202, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'aspect', 0.3917, 0.3364),
  ('window', 2, 'behind', -0.00326, 0.03001),
  ('window', 2, 'corner_offset', 1.647, 0.6749),
  ('window', 2, 'edge_concave', 0.03201, 0.09501),
  ('window', 2, 'edge_convex', -0.002021, 0.03003),
  ('window', 2, 'edge_free', 0.003507, 0.03073),
  ('window', 2, 'edge_free_top', 0.002114, 0.03002),
  ('window', 2, 'edge_unseen', 0.1905, 0.09154),
  ('window', 2, 'headroom', 0.3866, 0.2487),
  ('window', 2, 'height', 1.497, 0.1262),
  ('window', 2, 'lift', -2.497, 0.3757),
  ('window', 2, 'rectangularity', 0.6838, 0.2268),
  ('window', 2, 'spread_length', 0.4701, 0.5638),
  ('window', 2, 'spread_width', -0.0276, 0.2015),
  ('window', 2, 'standoff', -0.004949, 0.01754),
  ('window', 2, 'tilt_deg', 89.75, 0.4501),
  ('window', 2, 'wall_offset', -0.144, 0.05106),
  ('window', 2, 'width', -0.02862, 0.5726),
  ('window', 2, 'z_max', 2.267, 0.276),
  ('window', 2, 'z_min', 0.9591, 0.07168);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.1811, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'aspect', 0.5198, 0.3186),
  ('window', 3, 'behind', -0.005386, 0.03),
  ('window', 3, 'corner_offset', 1.136, 0.2236),
  ('window', 3, 'edge_concave', 0.2249, 0.257),
  ('window', 3, 'edge_convex', -0.0002763, 0.03),
  ('window', 3, 'edge_free', 0.1686, 0.1091),
  ('window', 3, 'edge_free_top', 0.019, 0.03099),
  ('window', 3, 'edge_unseen', 0.1848, 0.06896),
  ('window', 3, 'headroom', 0.292, 0.3854),
  ('window', 3, 'height', 1.841, 0.16),
  ('window', 3, 'lift', -0.6236, 0.7286),
  ('window', 3, 'rectangularity', 0.84, 0.07978),
  ('window', 3, 'spread_length', 0.1569, 0.138),
  ('window', 3, 'spread_width', -0.5812, 0.3153),
  ('window', 3, 'standoff', 0.02058, 0.01102),
  ('window', 3, 'tilt_deg', 89.84, 0.45),
  ('window', 3, 'wall_offset', -0.1668, 0.07018),
  ('window', 3, 'width', -0.434, 0.3394),
  ('window', 3, 'z_max', 2.186, 0.1442),
  ('window', 3, 'z_min', 1.479, 0.2529);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.05999, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'aspect', 0.421, 0.2497),
  ('window', 4, 'behind', -0.004151, 0.03),
  ('window', 4, 'corner_offset', 1.053, 0.2377),
  ('window', 4, 'edge_concave', 0.005025, 0.03),
  ('window', 4, 'edge_convex', -0.0008321, 0.03),
  ('window', 4, 'edge_free', 0.01382, 0.03228),
  ('window', 4, 'edge_free_top', 0.001138, 0.03),
  ('window', 4, 'edge_unseen', 0.2498, 0.1993),
  ('window', 4, 'headroom', 0.5079, 0.3455),
  ('window', 4, 'height', 1.398, 0.06921),
  ('window', 4, 'lift', -2.233, 0.5141),
  ('window', 4, 'rectangularity', 0.8019, 0.08481),
  ('window', 4, 'spread_length', 0.03278, 0.1088),
  ('window', 4, 'spread_width', -0.6139, 0.3672),
  ('window', 4, 'standoff', -0.01396, 0.00775),
  ('window', 4, 'tilt_deg', 89.69, 0.4505),
  ('window', 4, 'wall_offset', 3.218, 2.317),
  ('window', 4, 'width', -0.5672, 0.2509),
  ('window', 4, 'z_max', 1.912, 0.2649),
  ('window', 4, 'z_min', 0.9892, 0.05643);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.04259, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'aspect', 0.9301, 0.5606),
  ('window', 5, 'behind', -0.002881, 0.03001),
  ('window', 5, 'corner_offset', 1.384, 0.499),
  ('window', 5, 'edge_concave', 0.4507, 0.2582),
  ('window', 5, 'edge_convex', -0.0008329, 0.03009),
  ('window', 5, 'edge_free', 0.002768, 0.03011),
  ('window', 5, 'edge_free_top', 0.001299, 0.03006),
  ('window', 5, 'edge_unseen', 0.3043, 0.1075),
  ('window', 5, 'headroom', 0.2113, 0.1542),
  ('window', 5, 'height', 1.365, 0.0783),
  ('window', 5, 'lift', -5.135, 0.4429),
  ('window', 5, 'rectangularity', 0.7447, 0.06698),
  ('window', 5, 'spread_length', 0.1721, 0.1197),
  ('window', 5, 'spread_width', -1.201, 0.798),
  ('window', 5, 'standoff', 0.01392, 0.00775),
  ('window', 5, 'tilt_deg', 89.55, 0.4507),
  ('window', 5, 'wall_offset', 3.659, 0.9537),
  ('window', 5, 'width', -0.9619, 0.6492),
  ('window', 5, 'z_max', 1.926, 0.2186),
  ('window', 5, 'z_min', 0.9246, 0.03244);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.1205, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'aspect', 0.279, 0.2096),
  ('window', 6, 'behind', -0.00635, 0.03),
  ('window', 6, 'corner_offset', 1.71, 0.959),
  ('window', 6, 'edge_concave', 0.03091, 0.05995),
  ('window', 6, 'edge_convex', -0.0009067, 0.03),
  ('window', 6, 'edge_free', 0.3107, 0.1966),
  ('window', 6, 'edge_free_top', 0.4315, 0.3313),
  ('window', 6, 'edge_unseen', 0.08674, 0.1126),
  ('window', 6, 'headroom', 0.5725, 0.3783),
  ('window', 6, 'height', 1.464, 0.1615),
  ('window', 6, 'lift', -1.859, 0.9331),
  ('window', 6, 'rectangularity', 0.7575, 0.161),
  ('window', 6, 'spread_length', 0.02157, 0.1522),
  ('window', 6, 'spread_width', -0.3921, 0.298),
  ('window', 6, 'standoff', -0.01389, 0.00775),
  ('window', 6, 'tilt_deg', 89.72, 0.4501),
  ('window', 6, 'wall_offset', -0.1016, 0.04124),
  ('window', 6, 'width', -0.2805, 0.3237),
  ('window', 6, 'z_max', 2.034, 0.1942),
  ('window', 6, 'z_min', 1.048, 0.1113);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.03965, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'aspect', 0.3036, 0.1803),
  ('window', 7, 'behind', -0.0007212, 0.03005),
  ('window', 7, 'corner_offset', 0.5984, 0.7938),
  ('window', 7, 'edge_concave', 0.4886, 0.1564),
  ('window', 7, 'edge_convex', -0.0009389, 0.03001),
  ('window', 7, 'edge_free', 0.1656, 0.1648),
  ('window', 7, 'edge_free_top', 0.173, 0.1924),
  ('window', 7, 'edge_unseen', 0.1496, 0.125),
  ('window', 7, 'headroom', 0.00118, 0.03636),
  ('window', 7, 'height', 1.52, 0.1116),
  ('window', 7, 'lift', -4.78, 0.9858),
  ('window', 7, 'rectangularity', 0.4283, 0.1241),
  ('window', 7, 'spread_length', 0.4194, 0.1355),
  ('window', 7, 'spread_width', -0.1242, 0.2579),
  ('window', 7, 'standoff', 0.01478, 0.00775),
  ('window', 7, 'tilt_deg', 89.91, 0.4587),
  ('window', 7, 'wall_offset', 1.811, 2.673),
  ('window', 7, 'width', -0.1029, 0.165),
  ('window', 7, 'z_max', 2.149, 0.09654),
  ('window', 7, 'z_min', 0.8995, 0.03558);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.1205, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'aspect', 1.097, 0.3596),
  ('window', 8, 'behind', -0.003417, 0.03),
  ('window', 8, 'corner_offset', 1.156, 0.4601),
  ('window', 8, 'edge_concave', 0.2162, 0.299),
  ('window', 8, 'edge_convex', -0.0002471, 0.03),
  ('window', 8, 'edge_free', 0.02234, 0.04687),
  ('window', 8, 'edge_free_top', 0.136, 0.2328),
  ('window', 8, 'edge_unseen', 0.06206, 0.07747),
  ('window', 8, 'headroom', 0.9049, 0.2976),
  ('window', 8, 'height', 1.123, 0.1237),
  ('window', 8, 'lift', -4.448, 1.179),
  ('window', 8, 'rectangularity', 0.7606, 0.1749),
  ('window', 8, 'spread_length', 0.0914, 0.2607),
  ('window', 8, 'spread_width', -1.139, 0.4871),
  ('window', 8, 'standoff', -0.01519, 0.00776),
  ('window', 8, 'tilt_deg', 89.11, 0.7982),
  ('window', 8, 'wall_offset', -0.174, 0.06898),
  ('window', 8, 'width', -1.066, 0.3258),
  ('window', 8, 'z_max', 1.462, 0.2953),
  ('window', 8, 'z_min', 0.9295, 0.04184);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.04165, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'aspect', 0.611, 0.1749),
  ('window', 9, 'behind', -0.001318, 0.03),
  ('window', 9, 'corner_offset', 1.223, 0.3738),
  ('window', 9, 'edge_concave', 0.1066, 0.1633),
  ('window', 9, 'edge_convex', -2.335e-05, 0.03),
  ('window', 9, 'edge_free', 0.1001, 0.04061),
  ('window', 9, 'edge_free_top', 0.05448, 0.07877),
  ('window', 9, 'edge_unseen', 0.3173, 0.1068),
  ('window', 9, 'headroom', 0.6341, 0.3906),
  ('window', 9, 'height', 1.769, 0.08119),
  ('window', 9, 'lift', -0.3203, 0.3943),
  ('window', 9, 'rectangularity', 0.6551, 0.06244),
  ('window', 9, 'spread_length', -0.4906, 0.6504),
  ('window', 9, 'spread_width', -1.174, 0.6864),
  ('window', 9, 'standoff', 0.01251, 0.01468),
  ('window', 9, 'tilt_deg', 89.51, 0.6955),
  ('window', 9, 'wall_offset', 1.293, 2.664),
  ('window', 9, 'width', -0.8235, 0.4024),
  ('window', 9, 'z_max', 2.063, 0.1432),
  ('window', 9, 'z_min', 1.529, 0.1578);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.05127, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'aspect', 1.404, 0.4238),
  ('window', 10, 'behind', 0.6072, 0.1657),
  ('window', 10, 'corner_offset', 0.724, 0.1722),
  ('window', 10, 'edge_concave', 0.9208, 0.09602),
  ('window', 10, 'edge_convex', -6.41e-07, 0.03),
  ('window', 10, 'edge_free', 0.1069, 0.1106),
  ('window', 10, 'edge_free_top', 0.1277, 0.1589),
  ('window', 10, 'edge_unseen', 0.08777, 0.09016),
  ('window', 10, 'headroom', 0.5067, 0.104),
  ('window', 10, 'height', 1.396, 0.09547),
  ('window', 10, 'lift', -5.112, 0.3178),
  ('window', 10, 'rectangularity', 0.7446, 0.04365),
  ('window', 10, 'spread_length', -0.2125, 0.5808),
  ('window', 10, 'spread_width', -1.49, 0.2095),
  ('window', 10, 'standoff', 0.1724, 0.06518),
  ('window', 10, 'tilt_deg', 89.79, 0.45),
  ('window', 10, 'wall_offset', 0.9944, 0.5909),
  ('window', 10, 'width', -1.387, 0.1453),
  ('window', 10, 'z_max', 1.977, 0.3491),
  ('window', 10, 'z_min', 0.8703, 0.1383);

-- whiteboard: 253 examples
UPDATE object_class SET prior = 0.008379 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4456, 0.3054)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.009392, 0.05882)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'corner_offset', 1.654, 0.9642)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_concave', 0.05859, 0.1106)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_convex', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.02812, 0.05368)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.03806, 0.081)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_unseen', 0.1536, 0.1856)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'headroom', 0.7564, 0.2966)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.4, 0.1537)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'lift', -2.366, 1.191)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.8216, 0.09934)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.2039, 0.4451)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.3231, 0.4723)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'standoff', 0.04177, 0.1591)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.79, 0.581)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'wall_offset', 0.3714, 1.178)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', -0.1032, 0.4777)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 1.952, 0.2388)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.8696, 0.1926)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'whiteboard';
DELETE FROM class_density WHERE class = 'whiteboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.2243, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'aspect', 0.4234, 0.2971),
  ('whiteboard', 1, 'behind', 0.0004584, 0.03004),
  ('whiteboard', 1, 'corner_offset', 1.514, 0.7184),
  ('whiteboard', 1, 'edge_concave', 0.06052, 0.05315),
  ('whiteboard', 1, 'edge_convex', 8.51e-05, 0.03496),
  ('whiteboard', 1, 'edge_free', 0.01032, 0.03),
  ('whiteboard', 1, 'edge_free_top', 0.03344, 0.04745),
  ('whiteboard', 1, 'edge_unseen', -0.002976, 0.03),
  ('whiteboard', 1, 'headroom', 0.7578, 0.211),
  ('whiteboard', 1, 'height', 1.473, 0.05743),
  ('whiteboard', 1, 'lift', -2.303, 1.58),
  ('whiteboard', 1, 'rectangularity', 0.8734, 0.0518),
  ('whiteboard', 1, 'spread_length', 0.3942, 0.1651),
  ('whiteboard', 1, 'spread_width', -0.03744, 0.08576),
  ('whiteboard', 1, 'standoff', 0.02499, 0.00818),
  ('whiteboard', 1, 'tilt_deg', 90.19, 0.45),
  ('whiteboard', 1, 'wall_offset', 0.06885, 0.04),
  ('whiteboard', 1, 'width', 0.1302, 0.05933),
  ('whiteboard', 1, 'z_max', 1.973, 0.08974),
  ('whiteboard', 1, 'z_min', 0.915, 0.05413);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.2114, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'aspect', 0.5205, 0.2691),
  ('whiteboard', 2, 'behind', -0.002706, 0.03002),
  ('whiteboard', 2, 'corner_offset', 1.696, 0.7635),
  ('whiteboard', 2, 'edge_concave', 0.06064, 0.1075),
  ('whiteboard', 2, 'edge_convex', -5.941e-05, 0.03335),
  ('whiteboard', 2, 'edge_free', 0.03108, 0.03011),
  ('whiteboard', 2, 'edge_free_top', 0.03243, 0.05363),
  ('whiteboard', 2, 'edge_unseen', 0.2421, 0.06588),
  ('whiteboard', 2, 'headroom', 0.7286, 0.2518),
  ('whiteboard', 2, 'height', 1.357, 0.06337),
  ('whiteboard', 2, 'lift', -2.261, 0.5116),
  ('whiteboard', 2, 'rectangularity', 0.7568, 0.07569),
  ('whiteboard', 2, 'spread_length', 0.289, 0.3914),
  ('whiteboard', 2, 'spread_width', -0.3126, 0.1861),
  ('whiteboard', 2, 'standoff', 0.03384, 0.01198),
  ('whiteboard', 2, 'tilt_deg', 90.08, 0.45),
  ('whiteboard', 2, 'wall_offset', 0.06236, 0.04),
  ('whiteboard', 2, 'width', 0.1603, 0.0857),
  ('whiteboard', 2, 'z_max', 2.017, 0.08779),
  ('whiteboard', 2, 'z_min', 0.8629, 0.05594);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.1458, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'aspect', 0.592, 0.1691),
  ('whiteboard', 3, 'behind', -0.004765, 0.03),
  ('whiteboard', 3, 'corner_offset', 1.176, 1.464),
  ('whiteboard', 3, 'edge_concave', 0.05451, 0.1618),
  ('whiteboard', 3, 'edge_convex', -0.0005513, 0.05299),
  ('whiteboard', 3, 'edge_free', 0.02515, 0.09159),
  ('whiteboard', 3, 'edge_free_top', 0.006814, 0.03642),
  ('whiteboard', 3, 'edge_unseen', 0.3995, 0.07757),
  ('whiteboard', 3, 'headroom', 1.203, 0.4187),
  ('whiteboard', 3, 'height', 1.246, 0.154),
  ('whiteboard', 3, 'lift', -1.938, 0.2163),
  ('whiteboard', 3, 'rectangularity', 0.7804, 0.07909),
  ('whiteboard', 3, 'spread_length', -0.4258, 0.7541),
  ('whiteboard', 3, 'spread_width', -0.8819, 0.4081),
  ('whiteboard', 3, 'standoff', 0.02098, 0.06616),
  ('whiteboard', 3, 'tilt_deg', 89.45, 0.45),
  ('whiteboard', 3, 'wall_offset', 0.0438, 0.04),
  ('whiteboard', 3, 'width', -0.6996, 0.551),
  ('whiteboard', 3, 'z_max', 1.685, 0.3799),
  ('whiteboard', 3, 'z_min', 0.8542, 0.03964);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.08559, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'aspect', 0.4205, 0.2093),
  ('whiteboard', 4, 'behind', -0.001308, 0.03),
  ('whiteboard', 4, 'corner_offset', 1.239, 0.4823),
  ('whiteboard', 4, 'edge_concave', 0.003987, 0.03084),
  ('whiteboard', 4, 'edge_convex', -4.793e-05, 0.03401),
  ('whiteboard', 4, 'edge_free', 0.01557, 0.03004),
  ('whiteboard', 4, 'edge_free_top', 0.01466, 0.033),
  ('whiteboard', 4, 'edge_unseen', 0.3749, 0.1989),
  ('whiteboard', 4, 'headroom', 0.6346, 0.1164),
  ('whiteboard', 4, 'height', 1.381, 0.05174),
  ('whiteboard', 4, 'lift', -1.919, 0.6609),
  ('whiteboard', 4, 'rectangularity', 0.7169, 0.04087),
  ('whiteboard', 4, 'spread_length', 0.1368, 0.3302),
  ('whiteboard', 4, 'spread_width', -0.344, 0.1277),
  ('whiteboard', 4, 'standoff', 0.03131, 0.04133),
  ('whiteboard', 4, 'tilt_deg', 90, 0.45),
  ('whiteboard', 4, 'wall_offset', 2.63, 0.8047),
  ('whiteboard', 4, 'width', 0.09033, 0.1309),
  ('whiteboard', 4, 'z_max', 2.106, 0.08796),
  ('whiteboard', 4, 'z_min', 0.9243, 0.04793);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.1096, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'aspect', 0.8905, 0.4461),
  ('whiteboard', 5, 'behind', 0.001738, 0.03002),
  ('whiteboard', 5, 'corner_offset', 0.5562, 0.1867),
  ('whiteboard', 5, 'edge_concave', 0.1096, 0.1142),
  ('whiteboard', 5, 'edge_convex', -0.0001259, 0.03001),
  ('whiteboard', 5, 'edge_free', 0.01262, 0.0301),
  ('whiteboard', 5, 'edge_free_top', 0.1402, 0.1285),
  ('whiteboard', 5, 'edge_unseen', 0.3567, 0.08069),
  ('whiteboard', 5, 'headroom', 0.4947, 0.116),
  ('whiteboard', 5, 'height', 1.123, 0.4144),
  ('whiteboard', 5, 'lift', -4.746, 0.8242),
  ('whiteboard', 5, 'rectangularity', 0.7944, 0.09164),
  ('whiteboard', 5, 'spread_length', 0.2408, 0.2274),
  ('whiteboard', 5, 'spread_width', -0.6545, 0.4553),
  ('whiteboard', 5, 'standoff', 0.05514, 0.05035),
  ('whiteboard', 5, 'tilt_deg', 87.56, 2.195),
  ('whiteboard', 5, 'wall_offset', 4.252, 1.357),
  ('whiteboard', 5, 'width', -0.4753, 0.4426),
  ('whiteboard', 5, 'z_max', 1.418, 0.4302),
  ('whiteboard', 5, 'z_min', 0.52, 0.3423);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.03183, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'aspect', 1.027, 0.2932),
  ('whiteboard', 6, 'behind', -0.001403, 0.03004),
  ('whiteboard', 6, 'corner_offset', 1.878, 1.67),
  ('whiteboard', 6, 'edge_concave', 0.004641, 0.03905),
  ('whiteboard', 6, 'edge_convex', 0.0001061, 0.03996),
  ('whiteboard', 6, 'edge_free', 0.005078, 0.03995),
  ('whiteboard', 6, 'edge_free_top', 0.01268, 0.03296),
  ('whiteboard', 6, 'edge_unseen', 0.3639, 0.1046),
  ('whiteboard', 6, 'headroom', 0.9912, 0.4435),
  ('whiteboard', 6, 'height', 1.375, 0.3346),
  ('whiteboard', 6, 'lift', -2.131, 0.3029),
  ('whiteboard', 6, 'rectangularity', 0.794, 0.04783),
  ('whiteboard', 6, 'spread_length', -0.7654, 0.3627),
  ('whiteboard', 6, 'spread_width', -1.705, 0.1584),
  ('whiteboard', 6, 'standoff', 0.01503, 0.02988),
  ('whiteboard', 6, 'tilt_deg', 89.73, 0.4506),
  ('whiteboard', 6, 'wall_offset', 2.092, 3.575),
  ('whiteboard', 6, 'width', -1.544, 0.1991),
  ('whiteboard', 6, 'z_max', 1.851, 0.1697),
  ('whiteboard', 6, 'z_min', 0.9829, 0.06999);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.08251, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'aspect', 0.5395, 0.2403),
  ('whiteboard', 7, 'behind', 0.00301, 0.03001),
  ('whiteboard', 7, 'corner_offset', 1.307, 0.2933),
  ('whiteboard', 7, 'edge_concave', 0.2826, 0.05791),
  ('whiteboard', 7, 'edge_convex', -1.221e-05, 0.03001),
  ('whiteboard', 7, 'edge_free', 0.05475, 0.1199),
  ('whiteboard', 7, 'edge_free_top', 0.06938, 0.135),
  ('whiteboard', 7, 'edge_unseen', 0.07807, 0.1157),
  ('whiteboard', 7, 'headroom', 0.6467, 0.2461),
  ('whiteboard', 7, 'height', 1.396, 0.05104),
  ('whiteboard', 7, 'lift', -2.122, 0.354),
  ('whiteboard', 7, 'rectangularity', 0.6522, 0.09308),
  ('whiteboard', 7, 'spread_length', 0.7185, 0.2023),
  ('whiteboard', 7, 'spread_width', 0.03828, 0.2061),
  ('whiteboard', 7, 'standoff', 0.03161, 0.04166),
  ('whiteboard', 7, 'tilt_deg', 89.6, 0.6345),
  ('whiteboard', 7, 'wall_offset', 0.7103, 1.995),
  ('whiteboard', 7, 'width', 0.3983, 0.08759),
  ('whiteboard', 7, 'z_max', 2.071, 0.08018),
  ('whiteboard', 7, 'z_min', 0.4155, 0.205);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.02525, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'aspect', 0.2864, 0.1393),
  ('whiteboard', 8, 'behind', 0.0007183, 0.03241),
  ('whiteboard', 8, 'corner_offset', 2.72, 0.7829),
  ('whiteboard', 8, 'edge_concave', 0.01311, 0.03016),
  ('whiteboard', 8, 'edge_convex', 0.0002098, 0.03024),
  ('whiteboard', 8, 'edge_free', 0.2676, 0.2413),
  ('whiteboard', 8, 'edge_free_top', 0.2752, 0.1749),
  ('whiteboard', 8, 'edge_unseen', 0.1457, 0.1272),
  ('whiteboard', 8, 'headroom', 0.7964, 0.145),
  ('whiteboard', 8, 'height', 1.389, 0.02911),
  ('whiteboard', 8, 'lift', -2.56, 0.4251),
  ('whiteboard', 8, 'rectangularity', 0.7927, 0.07756),
  ('whiteboard', 8, 'spread_length', 0.08873, 0.1439),
  ('whiteboard', 8, 'spread_width', -0.3644, 0.1295),
  ('whiteboard', 8, 'standoff', 0.04663, 0.0422),
  ('whiteboard', 8, 'tilt_deg', 89.92, 0.46),
  ('whiteboard', 8, 'wall_offset', 0.1039, 0.1285),
  ('whiteboard', 8, 'width', -0.03624, 0.1433),
  ('whiteboard', 8, 'z_max', 1.919, 0.07312),
  ('whiteboard', 8, 'z_min', 0.8386, 0.02959);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 9, 0.03366, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 9, 'aspect', 0.2367, 0.1624),
  ('whiteboard', 9, 'behind', 0.3517, 0.1394),
  ('whiteboard', 9, 'corner_offset', 0.09792, 0.6842),
  ('whiteboard', 9, 'edge_concave', 0.1357, 0.08891),
  ('whiteboard', 9, 'edge_convex', 0.08136, 0.113),
  ('whiteboard', 9, 'edge_free', 0.02093, 0.03),
  ('whiteboard', 9, 'edge_free_top', 0.01443, 0.03),
  ('whiteboard', 9, 'edge_unseen', 0.01828, 0.03638),
  ('whiteboard', 9, 'headroom', 0.6655, 0.128),
  ('whiteboard', 9, 'height', 1.481, 0.07645),
  ('whiteboard', 9, 'lift', -1.89, 0.3961),
  ('whiteboard', 9, 'rectangularity', 0.8283, 0.0905),
  ('whiteboard', 9, 'spread_length', 0.2736, 0.1682),
  ('whiteboard', 9, 'spread_width', -0.01959, 0.1129),
  ('whiteboard', 9, 'standoff', 0.623, 0.3855),
  ('whiteboard', 9, 'tilt_deg', 89.95, 0.45),
  ('whiteboard', 9, 'wall_offset', 0.6957, 0.6441),
  ('whiteboard', 9, 'width', 0.128, 0.07923),
  ('whiteboard', 9, 'z_max', 2.041, 0.1269),
  ('whiteboard', 9, 'z_min', 0.8657, 0.08423);

-- shelf: 1281 examples
UPDATE object_class SET prior = 0.08577 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.9165, 0.4393)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5808, 0.3122)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'corner_offset', 0.5705, 0.862)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_concave', 0.4863, 0.1957)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_convex', 0.02776, 0.06735)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3069, 0.1781)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4294, 0.3452)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_unseen', 0.05169, 0.1078)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'headroom', 0.5813, 0.7294)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9223, 0.4868)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'lift', -2.652, 2.064)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6944, 0.132)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.2751, 0.5088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.262, 0.3889)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'standoff', 0.6796, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 45.55, 44.28)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'wall_offset', 1.168, 1.037)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.06, 0.3624)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.189, 0.6126)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.614, 0.5845)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'shelf';
DELETE FROM class_density WHERE class = 'shelf';
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.0919, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'aspect', 1.234, 0.3241),
  ('shelf', 1, 'behind', 0.7526, 0.1093),
  ('shelf', 1, 'corner_offset', 0.2267, 0.04365),
  ('shelf', 1, 'edge_concave', 0.4638, 0.1272),
  ('shelf', 1, 'edge_convex', 0.04398, 0.06879),
  ('shelf', 1, 'edge_free', 0.4398, 0.03646),
  ('shelf', 1, 'edge_free_top', 0.5929, 0.3205),
  ('shelf', 1, 'edge_unseen', 0.005305, 0.03003),
  ('shelf', 1, 'headroom', 0.4929, 1.044),
  ('shelf', 1, 'height', 0.6779, 0.3011),
  ('shelf', 1, 'lift', -2.583, 0.549),
  ('shelf', 1, 'rectangularity', 0.7194, 0.1044),
  ('shelf', 1, 'spread_length', -0.009112, 0.588),
  ('shelf', 1, 'spread_width', -1.11, 0.1252),
  ('shelf', 1, 'standoff', 0.5366, 0.4182),
  ('shelf', 1, 'tilt_deg', 89.92, 0.5187),
  ('shelf', 1, 'wall_offset', 0.9252, 0.9468),
  ('shelf', 1, 'width', -1.094, 0.2188),
  ('shelf', 1, 'z_max', 1.284, 0.618),
  ('shelf', 1, 'z_min', 0.02933, 0.02724);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.1814, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'aspect', 1.202, 0.4776),
  ('shelf', 2, 'behind', 0.8039, 0.1359),
  ('shelf', 2, 'corner_offset', 0.2547, 0.04007),
  ('shelf', 2, 'edge_concave', 0.3978, 0.1495),
  ('shelf', 2, 'edge_convex', 0.06441, 0.06512),
  ('shelf', 2, 'edge_free', 0.3646, 0.1052),
  ('shelf', 2, 'edge_free_top', 0.4619, 0.3708),
  ('shelf', 2, 'edge_unseen', 0.08248, 0.08289),
  ('shelf', 2, 'headroom', -0.3299, 0.2283),
  ('shelf', 2, 'height', 1.081, 0.1753),
  ('shelf', 2, 'lift', -3.384, 1.043),
  ('shelf', 2, 'rectangularity', 0.78, 0.1109),
  ('shelf', 2, 'spread_length', -0.1971, 0.3769),
  ('shelf', 2, 'spread_width', -1.115, 0.1434),
  ('shelf', 2, 'standoff', 0.7068, 0.5002),
  ('shelf', 2, 'tilt_deg', 90.04, 0.4505),
  ('shelf', 2, 'wall_offset', 1.272, 1.198),
  ('shelf', 2, 'width', -0.9602, 0.134),
  ('shelf', 2, 'z_max', 1.715, 0.2905),
  ('shelf', 2, 'z_min', 0.3774, 0.3042);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.14, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'aspect', 0.8661, 0.2031),
  ('shelf', 3, 'behind', 0.7379, 0.1176),
  ('shelf', 3, 'corner_offset', 0.3678, 0.2483),
  ('shelf', 3, 'edge_concave', 0.5709, 0.1564),
  ('shelf', 3, 'edge_convex', 0.03369, 0.06611),
  ('shelf', 3, 'edge_free', 0.2288, 0.1663),
  ('shelf', 3, 'edge_free_top', 0.3602, 0.2167),
  ('shelf', 3, 'edge_unseen', 0.02255, 0.07091),
  ('shelf', 3, 'headroom', 0.5518, 0.3005),
  ('shelf', 3, 'height', 1.671, 0.2123),
  ('shelf', 3, 'lift', -0.862, 0.2109),
  ('shelf', 3, 'rectangularity', 0.7874, 0.1198),
  ('shelf', 3, 'spread_length', -0.4641, 0.3161),
  ('shelf', 3, 'spread_width', -1.057, 0.1061),
  ('shelf', 3, 'standoff', 0.6727, 0.08617),
  ('shelf', 3, 'tilt_deg', 0.396, 0.4503),
  ('shelf', 3, 'wall_offset', 1.638, 0.2249),
  ('shelf', 3, 'width', -0.9366, 0.1714),
  ('shelf', 3, 'z_max', 1.631, 0.2118),
  ('shelf', 3, 'z_min', 1.685, 0.1989);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.0702, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'aspect', 0.9369, 0.8047),
  ('shelf', 4, 'behind', 0.7348, 0.1379),
  ('shelf', 4, 'corner_offset', 0.992, 0.5842),
  ('shelf', 4, 'edge_concave', 0.4803, 0.1638),
  ('shelf', 4, 'edge_convex', -0.0004602, 0.03),
  ('shelf', 4, 'edge_free', 0.4014, 0.0662),
  ('shelf', 4, 'edge_free_top', 0.4357, 0.1002),
  ('shelf', 4, 'edge_unseen', 0.1827, 0.1145),
  ('shelf', 4, 'headroom', 0.4549, 0.12),
  ('shelf', 4, 'height', 0.9913, 0.4093),
  ('shelf', 4, 'lift', -0.8829, 0.2208),
  ('shelf', 4, 'rectangularity', 0.5738, 0.1127),
  ('shelf', 4, 'spread_length', -0.7255, 0.3133),
  ('shelf', 4, 'spread_width', -1.74, 0.2878),
  ('shelf', 4, 'standoff', 0.7443, 0.2085),
  ('shelf', 4, 'tilt_deg', 1.749, 2.035),
  ('shelf', 4, 'wall_offset', 1.075, 0.1546),
  ('shelf', 4, 'width', -1.529, 0.3679),
  ('shelf', 4, 'z_max', 0.9987, 0.3854),
  ('shelf', 4, 'z_min', 1.093, 0.37);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.1755, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'aspect', 0.8944, 0.4603),
  ('shelf', 5, 'behind', 0.646, 0.117),
  ('shelf', 5, 'corner_offset', 0.2502, 0.05433),
  ('shelf', 5, 'edge_concave', 0.5881, 0.1941),
  ('shelf', 5, 'edge_convex', 0.006488, 0.03001),
  ('shelf', 5, 'edge_free', 0.3292, 0.09153),
  ('shelf', 5, 'edge_free_top', 0.4302, 0.09362),
  ('shelf', 5, 'edge_unseen', 0.007048, 0.03705),
  ('shelf', 5, 'headroom', 0.9482, 0.4291),
  ('shelf', 5, 'height', 0.463, 0.05953),
  ('shelf', 5, 'lift', -1.828, 0.51),
  ('shelf', 5, 'rectangularity', 0.6732, 0.09197),
  ('shelf', 5, 'spread_length', -0.2542, 0.1343),
  ('shelf', 5, 'spread_width', -1.44, 0.3136),
  ('shelf', 5, 'standoff', 0.7037, 0.14),
  ('shelf', 5, 'tilt_deg', 1.465, 0.9935),
  ('shelf', 5, 'wall_offset', 1.243, 0.4084),
  ('shelf', 5, 'width', -1.249, 0.3034),
  ('shelf', 5, 'z_max', 0.4567, 0.05568),
  ('shelf', 5, 'z_min', 0.4789, 0.06603);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.09031, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'aspect', 0.9107, 0.2294),
  ('shelf', 6, 'behind', 0.8022, 0.06628),
  ('shelf', 6, 'corner_offset', 0.2547, 0.04004),
  ('shelf', 6, 'edge_concave', 0.5413, 0.1625),
  ('shelf', 6, 'edge_convex', 0.02214, 0.03656),
  ('shelf', 6, 'edge_free', 0.2581, 0.1324),
  ('shelf', 6, 'edge_free_top', 0.4274, 0.106),
  ('shelf', 6, 'edge_unseen', 0.01473, 0.1011),
  ('shelf', 6, 'headroom', 0.8949, 0.4286),
  ('shelf', 6, 'height', 0.9178, 0.1408),
  ('shelf', 6, 'lift', -0.7251, 0.1072),
  ('shelf', 6, 'rectangularity', 0.7462, 0.09042),
  ('shelf', 6, 'spread_length', -0.4392, 0.2916),
  ('shelf', 6, 'spread_width', -1.313, 0.2722),
  ('shelf', 6, 'standoff', 0.6828, 0.1189),
  ('shelf', 6, 'tilt_deg', 0.6915, 0.45),
  ('shelf', 6, 'wall_offset', 1.062, 0.2744),
  ('shelf', 6, 'width', -1, 0.1515),
  ('shelf', 6, 'z_max', 0.9082, 0.1347),
  ('shelf', 6, 'z_min', 0.9314, 0.1262);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.06761, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'aspect', 1.274, 0.329),
  ('shelf', 7, 'behind', 0.5211, 0.3705),
  ('shelf', 7, 'corner_offset', 2.307, 1.96),
  ('shelf', 7, 'edge_concave', 0.3865, 0.1325),
  ('shelf', 7, 'edge_convex', 0.01645, 0.03851),
  ('shelf', 7, 'edge_free', 0.4061, 0.04484),
  ('shelf', 7, 'edge_free_top', 0.3526, 0.3178),
  ('shelf', 7, 'edge_unseen', 0.008253, 0.03645),
  ('shelf', 7, 'headroom', 0.4027, 0.6167),
  ('shelf', 7, 'height', 0.8754, 0.1036),
  ('shelf', 7, 'lift', -3.387, 0.9629),
  ('shelf', 7, 'rectangularity', 0.6266, 0.117),
  ('shelf', 7, 'spread_length', -0.2037, 0.5241),
  ('shelf', 7, 'spread_width', -1.49, 0.2726),
  ('shelf', 7, 'standoff', 0.2383, 0.2015),
  ('shelf', 7, 'tilt_deg', 90.09, 0.4506),
  ('shelf', 7, 'wall_offset', 0.3489, 0.3999),
  ('shelf', 7, 'width', -1.132, 0.1189),
  ('shelf', 7, 'z_max', 1.435, 0.2357),
  ('shelf', 7, 'z_min', 0.09986, 0.1441);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.05338, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'aspect', 0.1523, 0.5388),
  ('shelf', 8, 'behind', 0.007091, 0.03017),
  ('shelf', 8, 'corner_offset', 1.554, 0.7741),
  ('shelf', 8, 'edge_concave', 0.6146, 0.1777),
  ('shelf', 8, 'edge_convex', -0.0001154, 0.03002),
  ('shelf', 8, 'edge_free', 0.01617, 0.04569),
  ('shelf', 8, 'edge_free_top', 0.007619, 0.03001),
  ('shelf', 8, 'edge_unseen', 0.004659, 0.03003),
  ('shelf', 8, 'headroom', 0.3913, 0.7731),
  ('shelf', 8, 'height', 0.9361, 0.4059),
  ('shelf', 8, 'lift', -3.542, 1.958),
  ('shelf', 8, 'rectangularity', 0.6408, 0.2114),
  ('shelf', 8, 'spread_length', -0.5867, 0.5658),
  ('shelf', 8, 'spread_width', -1.097, 0.754),
  ('shelf', 8, 'standoff', 0.06261, 0.009802),
  ('shelf', 8, 'tilt_deg', 89.69, 0.9264),
  ('shelf', 8, 'wall_offset', 0.06994, 0.04),
  ('shelf', 8, 'width', -1.169, 0.7159),
  ('shelf', 8, 'z_max', 1.098, 0.4648),
  ('shelf', 8, 'z_min', 0.6749, 0.5144);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.03768, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'aspect', 0.702, 0.6),
  ('shelf', 9, 'behind', -0.003672, 0.03),
  ('shelf', 9, 'corner_offset', 0.2021, 0.07129),
  ('shelf', 9, 'edge_concave', 0.4722, 0.2183),
  ('shelf', 9, 'edge_convex', 0.000171, 0.03007),
  ('shelf', 9, 'edge_free', 0.2469, 0.1675),
  ('shelf', 9, 'edge_free_top', 0.431, 0.1088),
  ('shelf', 9, 'edge_unseen', 0.03904, 0.08135),
  ('shelf', 9, 'headroom', 0.7492, 0.6964),
  ('shelf', 9, 'height', 0.08811, 0.0225),
  ('shelf', 9, 'lift', -2.65, 0.6522),
  ('shelf', 9, 'rectangularity', 0.6874, 0.1153),
  ('shelf', 9, 'spread_length', -0.3901, 0.2812),
  ('shelf', 9, 'spread_width', -1.601, 0.2518),
  ('shelf', 9, 'standoff', 0.6793, 0.1466),
  ('shelf', 9, 'tilt_deg', 0.9072, 1.172),
  ('shelf', 9, 'wall_offset', 1.17, 0.3367),
  ('shelf', 9, 'width', -1.321, 0.3067),
  ('shelf', 9, 'z_max', 0.08727, 0.0225),
  ('shelf', 9, 'z_min', 0.08777, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.04199, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'aspect', 0.9958, 0.3553),
  ('shelf', 10, 'behind', 0.5807, 0.1688),
  ('shelf', 10, 'corner_offset', 3.376, 0.7882),
  ('shelf', 10, 'edge_concave', 0.2423, 0.174),
  ('shelf', 10, 'edge_convex', 0.1911, 0.07334),
  ('shelf', 10, 'edge_free', 0.437, 0.3956),
  ('shelf', 10, 'edge_free_top', 0.5527, 0.4261),
  ('shelf', 10, 'edge_unseen', 0.2188, 0.16),
  ('shelf', 10, 'headroom', -0.1699, 0.209),
  ('shelf', 10, 'height', 1.211, 0.1852),
  ('shelf', 10, 'lift', -3.371, 1.273),
  ('shelf', 10, 'rectangularity', 0.7236, 0.123),
  ('shelf', 10, 'spread_length', -0.2456, 0.3371),
  ('shelf', 10, 'spread_width', -1.326, 0.2155),
  ('shelf', 10, 'standoff', 0.8631, 0.1356),
  ('shelf', 10, 'tilt_deg', 89.98, 1.447),
  ('shelf', 10, 'wall_offset', 1.961, 0.5076),
  ('shelf', 10, 'width', -1.124, 0.1509),
  ('shelf', 10, 'z_max', 1.703, 0.122),
  ('shelf', 10, 'z_min', 0.5507, 0.3822);

-- cabinet: 1432 examples
UPDATE object_class SET prior = 0.131 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6635, 0.4321)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.4908, 0.2446)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'corner_offset', 1.063, 0.9624)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_concave', 0.368, 0.2616)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_convex', 0.1886, 0.181)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.3791, 0.2761)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.7426, 0.3275)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_unseen', 0.08673, 0.1629)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'headroom', 0.6789, 0.7428)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7987, 0.363)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'lift', -4.991, 0.8659)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7404, 0.1333)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1138, 0.5061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.812, 0.5429)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'standoff', 0.7394, 0.3517)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 74.86, 33.3)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'wall_offset', 1.158, 0.9935)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.6088, 0.5095)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.255, 0.5834)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2618, 0.3721)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'cabinet';
DELETE FROM class_density WHERE class = 'cabinet';
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.122, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'aspect', 0.7524, 0.5664),
  ('cabinet', 1, 'behind', 0.2656, 0.1927),
  ('cabinet', 1, 'corner_offset', 1.863, 0.7834),
  ('cabinet', 1, 'edge_concave', 0.06357, 0.1205),
  ('cabinet', 1, 'edge_convex', 0.01477, 0.04102),
  ('cabinet', 1, 'edge_free', 0.5184, 0.2843),
  ('cabinet', 1, 'edge_free_top', 0.9003, 0.1307),
  ('cabinet', 1, 'edge_unseen', 0.2823, 0.2068),
  ('cabinet', 1, 'headroom', 0.5398, 0.1521),
  ('cabinet', 1, 'height', 1.194, 0.1361),
  ('cabinet', 1, 'lift', -5.033, 0.0628),
  ('cabinet', 1, 'rectangularity', 0.7033, 0.1054),
  ('cabinet', 1, 'spread_length', -0.3837, 0.4149),
  ('cabinet', 1, 'spread_width', -0.9718, 0.7722),
  ('cabinet', 1, 'standoff', 0.5346, 0.06291),
  ('cabinet', 1, 'tilt_deg', 90.18, 0.45),
  ('cabinet', 1, 'wall_offset', 2.198, 1.556),
  ('cabinet', 1, 'width', -0.5, 0.3258),
  ('cabinet', 1, 'z_max', 1.925, 0.1169),
  ('cabinet', 1, 'z_min', 0.4541, 0.167);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.06784, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'aspect', 0.6044, 0.2737),
  ('cabinet', 2, 'behind', 0.6151, 0.1012),
  ('cabinet', 2, 'corner_offset', 0.1911, 0.2936),
  ('cabinet', 2, 'edge_concave', 0.8646, 0.235),
  ('cabinet', 2, 'edge_convex', 0.04975, 0.1388),
  ('cabinet', 2, 'edge_free', 0.1303, 0.1602),
  ('cabinet', 2, 'edge_free_top', 0.8373, 0.1432),
  ('cabinet', 2, 'edge_unseen', 0.004642, 0.03303),
  ('cabinet', 2, 'headroom', 1.068, 0.7433),
  ('cabinet', 2, 'height', 0.6595, 0.2654),
  ('cabinet', 2, 'lift', -4.902, 0.1482),
  ('cabinet', 2, 'rectangularity', 0.8301, 0.1176),
  ('cabinet', 2, 'spread_length', -0.09264, 0.3766),
  ('cabinet', 2, 'spread_width', -0.6638, 0.104),
  ('cabinet', 2, 'standoff', 1.183, 0.3281),
  ('cabinet', 2, 'tilt_deg', 90.1, 0.45),
  ('cabinet', 2, 'wall_offset', 1.827, 0.9106),
  ('cabinet', 2, 'width', -0.535, 0.08537),
  ('cabinet', 2, 'z_max', 1.286, 0.5804),
  ('cabinet', 2, 'z_min', -0.005776, 0.02251);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.05177, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'aspect', 0.2723, 0.4345),
  ('cabinet', 3, 'behind', 0.5544, 0.3216),
  ('cabinet', 3, 'corner_offset', 1.549, 1.129),
  ('cabinet', 3, 'edge_concave', 0.1843, 0.2792),
  ('cabinet', 3, 'edge_convex', 0.2094, 0.2899),
  ('cabinet', 3, 'edge_free', 0.3692, 0.3563),
  ('cabinet', 3, 'edge_free_top', 0.6553, 0.3498),
  ('cabinet', 3, 'edge_unseen', 0.2923, 0.2266),
  ('cabinet', 3, 'headroom', -0.02473, 0.08716),
  ('cabinet', 3, 'height', 0.6908, 0.1916),
  ('cabinet', 3, 'lift', -5.33, 7.138),
  ('cabinet', 3, 'rectangularity', 0.6192, 0.0616),
  ('cabinet', 3, 'spread_length', -0.6733, 0.1227),
  ('cabinet', 3, 'spread_width', -1.725, 0.2706),
  ('cabinet', 3, 'standoff', 0.7815, 0.1764),
  ('cabinet', 3, 'tilt_deg', 89.58, 0.8218),
  ('cabinet', 3, 'wall_offset', 1.469, 0.9157),
  ('cabinet', 3, 'width', -1.386, 0.5101),
  ('cabinet', 3, 'z_max', 0.7916, 0.1839),
  ('cabinet', 3, 'z_min', 0.5692, 0.2679);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.04836, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'aspect', 0.4219, 0.47),
  ('cabinet', 4, 'behind', 0.5909, 0.09117),
  ('cabinet', 4, 'corner_offset', 1.701, 0.7237),
  ('cabinet', 4, 'edge_concave', 0.4337, 0.2408),
  ('cabinet', 4, 'edge_convex', 0.2018, 0.08814),
  ('cabinet', 4, 'edge_free', 0.1619, 0.2152),
  ('cabinet', 4, 'edge_free_top', 0.3765, 0.4005),
  ('cabinet', 4, 'edge_unseen', 0.0003801, 0.03),
  ('cabinet', 4, 'headroom', 0.1808, 0.3942),
  ('cabinet', 4, 'height', 0.322, 0.03483),
  ('cabinet', 4, 'lift', -4.963, 0.2728),
  ('cabinet', 4, 'rectangularity', 0.6651, 0.08443),
  ('cabinet', 4, 'spread_length', -0.5369, 0.05369),
  ('cabinet', 4, 'spread_width', -0.9406, 0.2939),
  ('cabinet', 4, 'standoff', 0.8788, 0.1566),
  ('cabinet', 4, 'tilt_deg', 90.09, 0.4504),
  ('cabinet', 4, 'wall_offset', 1.566, 0.7894),
  ('cabinet', 4, 'width', -0.6319, 0.3213),
  ('cabinet', 4, 'z_max', 0.6793, 0.06875),
  ('cabinet', 4, 'z_min', -0.02368, 0.02253);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.2107, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'aspect', 0.7427, 0.4005),
  ('cabinet', 5, 'behind', 0.2143, 0.07097),
  ('cabinet', 5, 'corner_offset', 1.503, 0.5898),
  ('cabinet', 5, 'edge_concave', 0.3343, 0.1787),
  ('cabinet', 5, 'edge_convex', 0.1106, 0.1928),
  ('cabinet', 5, 'edge_free', 0.5291, 0.215),
  ('cabinet', 5, 'edge_free_top', 0.985, 0.03719),
  ('cabinet', 5, 'edge_unseen', 0.0003513, 0.03),
  ('cabinet', 5, 'headroom', 0.8614, 0.3505),
  ('cabinet', 5, 'height', 1.162, 0.2364),
  ('cabinet', 5, 'lift', -4.893, 0.1262),
  ('cabinet', 5, 'rectangularity', 0.8991, 0.07284),
  ('cabinet', 5, 'spread_length', 0.3671, 0.2784),
  ('cabinet', 5, 'spread_width', -0.365, 0.1981),
  ('cabinet', 5, 'standoff', 0.5386, 0.08266),
  ('cabinet', 5, 'tilt_deg', 90.07, 0.45),
  ('cabinet', 5, 'wall_offset', 0.5099, 0.06124),
  ('cabinet', 5, 'width', -0.2464, 0.4568),
  ('cabinet', 5, 'z_max', 1.864, 0.123),
  ('cabinet', 5, 'z_min', 0.01406, 0.08946);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.08549, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'aspect', 0.6906, 0.256),
  ('cabinet', 6, 'behind', 0.6576, 0.08521),
  ('cabinet', 6, 'corner_offset', 0.3003, 0.05448),
  ('cabinet', 6, 'edge_concave', 0.5242, 0.1943),
  ('cabinet', 6, 'edge_convex', 0.3046, 0.08519),
  ('cabinet', 6, 'edge_free', 0.1394, 0.1283),
  ('cabinet', 6, 'edge_free_top', 0.7462, 0.0948),
  ('cabinet', 6, 'edge_unseen', 0.0884, 0.1628),
  ('cabinet', 6, 'headroom', 1.876, 0.2781),
  ('cabinet', 6, 'height', 0.915, 0.1419),
  ('cabinet', 6, 'lift', -4.93, 0.158),
  ('cabinet', 6, 'rectangularity', 0.6823, 0.08245),
  ('cabinet', 6, 'spread_length', -0.2404, 0.3114),
  ('cabinet', 6, 'spread_width', -0.661, 0.09088),
  ('cabinet', 6, 'standoff', 0.7399, 0.1054),
  ('cabinet', 6, 'tilt_deg', -0.0723, 0.45),
  ('cabinet', 6, 'wall_offset', 1.158, 0.2755),
  ('cabinet', 6, 'width', -0.5472, 0.08679),
  ('cabinet', 6, 'z_max', 0.9031, 0.1447),
  ('cabinet', 6, 'z_min', 0.9267, 0.1399);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.1132, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'aspect', 0.5958, 0.2981),
  ('cabinet', 7, 'behind', 0.4112, 0.1661),
  ('cabinet', 7, 'corner_offset', 1.484, 0.809),
  ('cabinet', 7, 'edge_concave', 0.2506, 0.2681),
  ('cabinet', 7, 'edge_convex', 0.1693, 0.2101),
  ('cabinet', 7, 'edge_free', 0.4814, 0.3034),
  ('cabinet', 7, 'edge_free_top', 0.9783, 0.03486),
  ('cabinet', 7, 'edge_unseen', -0.03629, 0.04866),
  ('cabinet', 7, 'headroom', 0.5228, 0.7178),
  ('cabinet', 7, 'height', 0.7622, 0.1533),
  ('cabinet', 7, 'lift', -4.893, 0.1164),
  ('cabinet', 7, 'rectangularity', 0.766, 0.1516),
  ('cabinet', 7, 'spread_length', -0.1227, 0.2025),
  ('cabinet', 7, 'spread_width', -0.436, 0.4958),
  ('cabinet', 7, 'standoff', 0.5474, 0.09134),
  ('cabinet', 7, 'tilt_deg', 90.09, 0.45),
  ('cabinet', 7, 'wall_offset', 0.5064, 0.0572),
  ('cabinet', 7, 'width', -0.3452, 0.3943),
  ('cabinet', 7, 'z_max', 1.009, 0.1243),
  ('cabinet', 7, 'z_min', -0.006552, 0.03332);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.1544, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'aspect', 0.8678, 0.5156),
  ('cabinet', 8, 'behind', 0.4888, 0.2088),
  ('cabinet', 8, 'corner_offset', 0.3499, 0.05406),
  ('cabinet', 8, 'edge_concave', 0.4953, 0.2336),
  ('cabinet', 8, 'edge_convex', 0.3604, 0.05932),
  ('cabinet', 8, 'edge_free', 0.1636, 0.06109),
  ('cabinet', 8, 'edge_free_top', 0.7926, 0.1692),
  ('cabinet', 8, 'edge_unseen', 0.01414, 0.05573),
  ('cabinet', 8, 'headroom', 0.7295, 0.3291),
  ('cabinet', 8, 'height', 1.033, 0.2742),
  ('cabinet', 8, 'lift', -5.069, 0.924),
  ('cabinet', 8, 'rectangularity', 0.8006, 0.07589),
  ('cabinet', 8, 'spread_length', 0.08729, 0.359),
  ('cabinet', 8, 'spread_width', -0.7204, 0.1214),
  ('cabinet', 8, 'standoff', 1.151, 0.2849),
  ('cabinet', 8, 'tilt_deg', 90.05, 0.45),
  ('cabinet', 8, 'wall_offset', 1.732, 0.467),
  ('cabinet', 8, 'width', -0.526, 0.1265),
  ('cabinet', 8, 'z_max', 2.046, 0.1776),
  ('cabinet', 8, 'z_min', 0.2302, 0.2395);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.04784, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'aspect', 1.047, 0.7875),
  ('cabinet', 9, 'behind', 0.2533, 0.3313),
  ('cabinet', 9, 'corner_offset', 1.259, 0.5718),
  ('cabinet', 9, 'edge_concave', 0.2538, 0.2043),
  ('cabinet', 9, 'edge_convex', 0.03055, 0.0916),
  ('cabinet', 9, 'edge_free', 0.06262, 0.1125),
  ('cabinet', 9, 'edge_free_top', 0.07194, 0.1813),
  ('cabinet', 9, 'edge_unseen', 0.01931, 0.06342),
  ('cabinet', 9, 'headroom', 1.905, 0.6667),
  ('cabinet', 9, 'height', 0.405, 0.3322),
  ('cabinet', 9, 'lift', -3.9, 0.5116),
  ('cabinet', 9, 'rectangularity', 0.7096, 0.1511),
  ('cabinet', 9, 'spread_length', -0.4171, 0.3902),
  ('cabinet', 9, 'spread_width', -1.761, 0.2813),
  ('cabinet', 9, 'standoff', 0.441, 0.4288),
  ('cabinet', 9, 'tilt_deg', 90.04, 2.067),
  ('cabinet', 9, 'wall_offset', 0.9096, 0.2647),
  ('cabinet', 9, 'width', -1.461, 0.3538),
  ('cabinet', 9, 'z_max', 0.713, 0.5714),
  ('cabinet', 9, 'z_min', 0.005594, 0.06451);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.04854, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'aspect', 0.6305, 0.3506),
  ('cabinet', 10, 'behind', 0.7474, 0.1446),
  ('cabinet', 10, 'corner_offset', 0.7841, 0.1302),
  ('cabinet', 10, 'edge_concave', 0.5106, 0.1389),
  ('cabinet', 10, 'edge_convex', 0.1817, 0.2083),
  ('cabinet', 10, 'edge_free', 0.2546, 0.169),
  ('cabinet', 10, 'edge_free_top', 0.7428, 0.102),
  ('cabinet', 10, 'edge_unseen', 0.01103, 0.04823),
  ('cabinet', 10, 'headroom', 0.1713, 0.05564),
  ('cabinet', 10, 'height', 0.5801, 0.0225),
  ('cabinet', 10, 'lift', -4.981, 0.2542),
  ('cabinet', 10, 'rectangularity', 0.6892, 0.09434),
  ('cabinet', 10, 'spread_length', -0.7874, 0.1738),
  ('cabinet', 10, 'spread_width', -1.474, 0.416),
  ('cabinet', 10, 'standoff', 0.7412, 0.1114),
  ('cabinet', 10, 'tilt_deg', 0.7843, 1.311),
  ('cabinet', 10, 'wall_offset', 1.158, 0.3152),
  ('cabinet', 10, 'width', -1.26, 0.4666),
  ('cabinet', 10, 'z_max', 0.5826, 0.0225),
  ('cabinet', 10, 'z_min', 0.5778, 0.0225);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.4 WHERE name = 'aspect';
UPDATE feature SET weight = 0.4 WHERE name = 'behind';
UPDATE feature SET weight = 0.4 WHERE name = 'corner_offset';
UPDATE feature SET weight = 0.3 WHERE name = 'edge_concave';
UPDATE feature SET weight = 0.2 WHERE name = 'edge_convex';
UPDATE feature SET weight = 0.4 WHERE name = 'edge_free';
UPDATE feature SET weight = 0.2 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.2 WHERE name = 'edge_unseen';
UPDATE feature SET weight = 0.4 WHERE name = 'headroom';
UPDATE feature SET weight = 0.4 WHERE name = 'height';
UPDATE feature SET weight = 0.4 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.3 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.2 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.5 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.2 WHERE name = 'width';
UPDATE feature SET weight = 0.4 WHERE name = 'z_max';
UPDATE feature SET weight = 0.4 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.144 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0439 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0649 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.258 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0166 WHERE name = 'table';
UPDATE object_class SET prior = 0.0269 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.105 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.00874 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0442 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0196 WHERE name = 'door';
UPDATE object_class SET prior = 0.0239 WHERE name = 'window';
UPDATE object_class SET prior = 0.00681 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0724 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.165 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.94 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.526 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 1.45 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.69 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 3.07 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.51 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 0.0118 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.19 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.0185 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.621 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 0.728 WHERE name = 'wall_in_one_plane';
UPDATE class_constraint SET weight = 0.922 WHERE name = 'cabinet_off_wall';
UPDATE class_constraint SET weight = 0.785 WHERE name = 'window_off_wall';
UPDATE class_constraint SET weight = 2.2 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.71 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.01 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.572 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 0.781 WHERE name = 'screen_within_table';
UPDATE class_constraint SET weight = 1.27 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 3.1 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 4.12 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.44 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.091 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 1.01 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.02 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 0.878 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.555 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.19 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.24 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 3.1 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.36 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.42 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.0353 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 0.851 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.74 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.67 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.149 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.4 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2405 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.854' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.124' WHERE key = 'probability_offset';
