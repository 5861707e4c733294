-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 17465 planes of 180 paper-like rooms, seeds from 1; 90 at 2 cm, seeds from 10101; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 60 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 7095 examples
UPDATE object_class SET prior = 0.2394 WHERE name = 'unknown';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'lift', 0.194, 0.4152)
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
  ('unknown', 'lift', -1, -0.120125, 0.002039),
  ('unknown', 'lift', -0.120125, -0.0999694, 0.4061),
  ('unknown', 'lift', -0.0999694, -0.0334703, 1.799),
  ('unknown', 'lift', -0.0334703, -0.0150887, 6.241),
  ('unknown', 'lift', -0.0150887, -0.00572049, 8.82),
  ('unknown', 'lift', -0.00572049, 0.00584349, 8.825),
  ('unknown', 'lift', 0.00584349, 0.0205563, 6.906),
  ('unknown', 'lift', 0.0205563, 0.067784, 2.751),
  ('unknown', 'lift', 0.067784, 0.109391, 0.9009),
  ('unknown', 'lift', 0.109391, 0.264735, 0.5014),
  ('unknown', 'lift', 0.264735, 0.338906, 0.4946),
  ('unknown', 'lift', 0.338906, 0.568422, 0.2726),
  ('unknown', 'lift', 0.568422, 0.639018, 0.2096),
  ('unknown', 'lift', 0.639018, 0.797937, 0.1693),
  ('unknown', 'lift', 0.797937, 1.02745, 0.05184),
  ('unknown', 'lift', 1.02745, 1.25697, 0.08492),
  ('unknown', 'lift', 1.25697, 1.48648, 0.09315),
  ('unknown', 'lift', 1.48648, 1.716, 0.04781),
  ('unknown', 'lift', 1.716, 1.94551, 0.04838),
  ('unknown', 'lift', 1.94551, 4, 0.004066);
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.03418, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'aspect', 0.4014, 0.3088),
  ('unknown', 1, 'behind', 0.62, 0.1832),
  ('unknown', 1, 'corner_offset', 1.25, 0.8277),
  ('unknown', 1, 'edge_concave', 0.5539, 0.1675),
  ('unknown', 1, 'edge_convex', 0.2445, 0.1723),
  ('unknown', 1, 'edge_free', 0.4379, 0.1623),
  ('unknown', 1, 'edge_free_top', 0.719, 0.2265),
  ('unknown', 1, 'edge_unseen', 0.005297, 0.03001),
  ('unknown', 1, 'headroom', 0.07855, 0.1324),
  ('unknown', 1, 'height', 0.2193, 0.05701),
  ('unknown', 1, 'lift', 0.1921, 0.1391),
  ('unknown', 1, 'rectangularity', 0.5482, 0.16),
  ('unknown', 1, 'spread_length', -0.905, 0.1663),
  ('unknown', 1, 'spread_width', -1.482, 0.433),
  ('unknown', 1, 'standoff', 0.4972, 0.132),
  ('unknown', 1, 'tilt_deg', 89.09, 1.176),
  ('unknown', 1, 'wall_offset', 1.159, 0.9467),
  ('unknown', 1, 'width', -1.117, 0.3601),
  ('unknown', 1, 'z_max', 0.4326, 0.05607),
  ('unknown', 1, 'z_min', -0.01729, 0.03676);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.04386, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'aspect', 0.2517, 0.1991),
  ('unknown', 2, 'behind', 0.2606, 0.239),
  ('unknown', 2, 'corner_offset', 0.548, 0.4959),
  ('unknown', 2, 'edge_concave', 0.06364, 0.1172),
  ('unknown', 2, 'edge_convex', 0.003025, 0.03),
  ('unknown', 2, 'edge_free', 0.4039, 0.3517),
  ('unknown', 2, 'edge_free_top', 0.5541, 0.09615),
  ('unknown', 2, 'edge_unseen', -0.0007032, 0.03),
  ('unknown', 2, 'headroom', 2.026, 0.1804),
  ('unknown', 2, 'height', 0.7501, 0.07856),
  ('unknown', 2, 'lift', 0.03894, 0.04183),
  ('unknown', 2, 'rectangularity', 0.8099, 0.06752),
  ('unknown', 2, 'spread_length', -1.51, 0.2462),
  ('unknown', 2, 'spread_width', -1.512, 0.1875),
  ('unknown', 2, 'standoff', 0.4568, 0.1232),
  ('unknown', 2, 'tilt_deg', 0.0143, 0.4508),
  ('unknown', 2, 'wall_offset', 0.9364, 0.9524),
  ('unknown', 2, 'width', -1.631, 0.2803),
  ('unknown', 2, 'z_max', 0.7524, 0.08103),
  ('unknown', 2, 'z_min', 0.7445, 0.07771);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.02674, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'aspect', 1.347, 0.376),
  ('unknown', 3, 'behind', 0.7039, 0.191),
  ('unknown', 3, 'corner_offset', 0.5497, 0.728),
  ('unknown', 3, 'edge_concave', 0.3251, 0.2879),
  ('unknown', 3, 'edge_convex', 0.00216, 0.03288),
  ('unknown', 3, 'edge_free', 0.3973, 0.3128),
  ('unknown', 3, 'edge_free_top', 0.161, 0.2991),
  ('unknown', 3, 'edge_unseen', 0.003032, 0.03004),
  ('unknown', 3, 'headroom', 0.777, 0.8719),
  ('unknown', 3, 'height', 0.4304, 0.08451),
  ('unknown', 3, 'lift', 0.02873, 0.1021),
  ('unknown', 3, 'rectangularity', 0.6063, 0.1975),
  ('unknown', 3, 'spread_length', -0.3458, 0.2595),
  ('unknown', 3, 'spread_width', -2.01, 0.3711),
  ('unknown', 3, 'standoff', 0.5537, 0.4769),
  ('unknown', 3, 'tilt_deg', 88.78, 1.744),
  ('unknown', 3, 'wall_offset', 1.33, 0.4629),
  ('unknown', 3, 'width', -1.663, 0.3411),
  ('unknown', 3, 'z_max', 0.7453, 0.1689),
  ('unknown', 3, 'z_min', 0.121, 0.1215);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.03752, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'aspect', 0.3431, 0.2609),
  ('unknown', 4, 'behind', 0.01218, 0.0301),
  ('unknown', 4, 'corner_offset', 1.398, 0.972),
  ('unknown', 4, 'edge_concave', 0.07873, 0.2023),
  ('unknown', 4, 'edge_convex', 0.005334, 0.07906),
  ('unknown', 4, 'edge_free', -0.00734, 0.03),
  ('unknown', 4, 'edge_free_top', -0.003845, 0.03),
  ('unknown', 4, 'edge_unseen', 0.05909, 0.1019),
  ('unknown', 4, 'headroom', 0.9166, 0.2752),
  ('unknown', 4, 'height', 1.652, 0.09599),
  ('unknown', 4, 'lift', 0.3806, 0.2183),
  ('unknown', 4, 'rectangularity', 0.8065, 0.1121),
  ('unknown', 4, 'spread_length', -0.6245, 0.2243),
  ('unknown', 4, 'spread_width', -1.18, 0.3801),
  ('unknown', 4, 'standoff', 0.02135, 0.008358),
  ('unknown', 4, 'tilt_deg', 89.58, 0.9644),
  ('unknown', 4, 'wall_offset', 0.07054, 0.04),
  ('unknown', 4, 'width', -0.8945, 0.4669),
  ('unknown', 4, 'z_max', 2.021, 0.1675),
  ('unknown', 4, 'z_min', 1.333, 0.06667);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.01469, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'aspect', 1.72, 0.1602),
  ('unknown', 5, 'behind', 0.2655, 0.2746),
  ('unknown', 5, 'corner_offset', 0.8884, 0.4937),
  ('unknown', 5, 'edge_concave', 0.002343, 0.03),
  ('unknown', 5, 'edge_convex', 0.003786, 0.03),
  ('unknown', 5, 'edge_free', 0.871, 0.1423),
  ('unknown', 5, 'edge_free_top', 0.565, 0.1303),
  ('unknown', 5, 'edge_unseen', 0.01054, 0.03078),
  ('unknown', 5, 'headroom', 0.3346, 0.1316),
  ('unknown', 5, 'height', 2.545, 0.3113),
  ('unknown', 5, 'lift', 1.677, 0.256),
  ('unknown', 5, 'rectangularity', 0.8568, 0.05058),
  ('unknown', 5, 'spread_length', 0.241, 0.1202),
  ('unknown', 5, 'spread_width', -1.549, 0.04972),
  ('unknown', 5, 'standoff', 0.4535, 0.1269),
  ('unknown', 5, 'tilt_deg', 0.7868, 1.314),
  ('unknown', 5, 'wall_offset', 0.7971, 0.7876),
  ('unknown', 5, 'width', -1.448, 0.1087),
  ('unknown', 5, 'z_max', 2.553, 0.3255),
  ('unknown', 5, 'z_min', 2.554, 0.3216);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.02568, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'aspect', 0.2634, 0.2746),
  ('unknown', 6, 'behind', 0.7576, 0.1171),
  ('unknown', 6, 'corner_offset', 0.7032, 0.7503),
  ('unknown', 6, 'edge_concave', 0.4447, 0.1221),
  ('unknown', 6, 'edge_convex', -0.002476, 0.03),
  ('unknown', 6, 'edge_free', 0.339, 0.09652),
  ('unknown', 6, 'edge_free_top', 0.4153, 0.2463),
  ('unknown', 6, 'edge_unseen', 0.01333, 0.03089),
  ('unknown', 6, 'headroom', 0.01643, 0.05865),
  ('unknown', 6, 'height', 0.3415, 0.1349),
  ('unknown', 6, 'lift', 0.1917, 0.1387),
  ('unknown', 6, 'rectangularity', 0.3988, 0.1389),
  ('unknown', 6, 'spread_length', -0.37, 0.115),
  ('unknown', 6, 'spread_width', -1.108, 0.3045),
  ('unknown', 6, 'standoff', 0.5375, 0.2046),
  ('unknown', 6, 'tilt_deg', 88.14, 1.457),
  ('unknown', 6, 'wall_offset', 1.194, 0.9636),
  ('unknown', 6, 'width', -0.6423, 0.2753),
  ('unknown', 6, 'z_max', 0.7226, 0.1577),
  ('unknown', 6, 'z_min', -0.01639, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.03594, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'aspect', 0.6568, 0.417),
  ('unknown', 7, 'behind', 0.6016, 0.2006),
  ('unknown', 7, 'corner_offset', 1.504, 0.8221),
  ('unknown', 7, 'edge_concave', 0.4983, 0.2138),
  ('unknown', 7, 'edge_convex', 0.2527, 0.1609),
  ('unknown', 7, 'edge_free', 0.5722, 0.1599),
  ('unknown', 7, 'edge_free_top', 0.9013, 0.1565),
  ('unknown', 7, 'edge_unseen', 0.008854, 0.03146),
  ('unknown', 7, 'headroom', 1.093, 0.8563),
  ('unknown', 7, 'height', 0.8691, 0.03473),
  ('unknown', 7, 'lift', -0.02731, 0.03049),
  ('unknown', 7, 'rectangularity', 0.7614, 0.104),
  ('unknown', 7, 'spread_length', -1.228, 0.1323),
  ('unknown', 7, 'spread_width', -1.496, 0.2609),
  ('unknown', 7, 'standoff', 0.8012, 0.33),
  ('unknown', 7, 'tilt_deg', 89.8, 0.45),
  ('unknown', 7, 'wall_offset', 1.318, 0.7588),
  ('unknown', 7, 'width', -1.36, 0.2643),
  ('unknown', 7, 'z_max', 1.018, 0.07442),
  ('unknown', 7, 'z_min', 0.7424, 0.05753);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.02886, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'aspect', 0.6676, 0.5973),
  ('unknown', 8, 'behind', 0.5145, 0.2224),
  ('unknown', 8, 'corner_offset', 1.902, 0.7362),
  ('unknown', 8, 'edge_concave', 0.1681, 0.1946),
  ('unknown', 8, 'edge_convex', 0.09378, 0.1492),
  ('unknown', 8, 'edge_free', 0.8442, 0.1971),
  ('unknown', 8, 'edge_free_top', 0.945, 0.09607),
  ('unknown', 8, 'edge_unseen', 0.1516, 0.1356),
  ('unknown', 8, 'headroom', 1.174, 0.4597),
  ('unknown', 8, 'height', 0.87, 0.0856),
  ('unknown', 8, 'lift', 0.03962, 0.1347),
  ('unknown', 8, 'rectangularity', 0.7046, 0.08609),
  ('unknown', 8, 'spread_length', -0.301, 0.6064),
  ('unknown', 8, 'spread_width', -0.9985, 0.1861),
  ('unknown', 8, 'standoff', 0.3599, 0.2954),
  ('unknown', 8, 'tilt_deg', 84.98, 9.12),
  ('unknown', 8, 'wall_offset', 2.035, 1.183),
  ('unknown', 8, 'width', -0.7749, 0.1702),
  ('unknown', 8, 'z_max', 1.158, 0.1199),
  ('unknown', 8, 'z_min', 0.5805, 0.08577);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.03257, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'aspect', 0.6483, 0.2623),
  ('unknown', 9, 'behind', 0.6799, 0.199),
  ('unknown', 9, 'corner_offset', 0.8573, 0.5121),
  ('unknown', 9, 'edge_concave', 0.0008367, 0.03001),
  ('unknown', 9, 'edge_convex', 0.5608, 0.1502),
  ('unknown', 9, 'edge_free', 0.7565, 0.1589),
  ('unknown', 9, 'edge_free_top', 0.6297, 0.3613),
  ('unknown', 9, 'edge_unseen', 0.01267, 0.04572),
  ('unknown', 9, 'headroom', 1.157, 0.9198),
  ('unknown', 9, 'height', 0.4376, 0.02432),
  ('unknown', 9, 'lift', -0.06906, 0.05167),
  ('unknown', 9, 'rectangularity', 0.7877, 0.1054),
  ('unknown', 9, 'spread_length', -0.9644, 0.1297),
  ('unknown', 9, 'spread_width', -1.705, 0.3946),
  ('unknown', 9, 'standoff', 0.6552, 0.5182),
  ('unknown', 9, 'tilt_deg', 47.54, 43.2),
  ('unknown', 9, 'wall_offset', 1.475, 0.6683),
  ('unknown', 9, 'width', -1.53, 0.309),
  ('unknown', 9, 'z_max', 0.4853, 0.1156),
  ('unknown', 9, 'z_min', 0.3831, 0.03756);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.03412, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'aspect', 0.3928, 0.2261),
  ('unknown', 10, 'behind', 0.4176, 0.1058),
  ('unknown', 10, 'corner_offset', 1.386, 0.8374),
  ('unknown', 10, 'edge_concave', 0.07131, 0.08622),
  ('unknown', 10, 'edge_convex', 0.04728, 0.1036),
  ('unknown', 10, 'edge_free', 0.8439, 0.1444),
  ('unknown', 10, 'edge_free_top', 0.9917, 0.03001),
  ('unknown', 10, 'edge_unseen', 0.04522, 0.108),
  ('unknown', 10, 'headroom', 1.912, 0.263),
  ('unknown', 10, 'height', 0.4987, 0.06319),
  ('unknown', 10, 'lift', 0.1964, 0.1342),
  ('unknown', 10, 'rectangularity', 0.8199, 0.09173),
  ('unknown', 10, 'spread_length', -0.07523, 0.2642),
  ('unknown', 10, 'spread_width', -0.4943, 0.1199),
  ('unknown', 10, 'standoff', 0.1311, 0.02325),
  ('unknown', 10, 'tilt_deg', 89.51, 1.498),
  ('unknown', 10, 'wall_offset', 0.15, 0.04),
  ('unknown', 10, 'width', -0.3704, 0.2054),
  ('unknown', 10, 'z_max', 0.8278, 0.1232),
  ('unknown', 10, 'z_min', 0.04588, 0.06253);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.03033, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'aspect', 0.4011, 0.3263),
  ('unknown', 11, 'behind', 0.5605, 0.2594),
  ('unknown', 11, 'corner_offset', 1.433, 0.867),
  ('unknown', 11, 'edge_concave', 0.3685, 0.1136),
  ('unknown', 11, 'edge_convex', 0.2583, 0.1502),
  ('unknown', 11, 'edge_free', 0.7543, 0.1337),
  ('unknown', 11, 'edge_free_top', 0.8996, 0.2326),
  ('unknown', 11, 'edge_unseen', 0.07129, 0.07975),
  ('unknown', 11, 'headroom', -0.03371, 0.04242),
  ('unknown', 11, 'height', 0.5147, 0.05717),
  ('unknown', 11, 'lift', 0.04055, 0.1197),
  ('unknown', 11, 'rectangularity', 0.6927, 0.07954),
  ('unknown', 11, 'spread_length', -0.2335, 0.3077),
  ('unknown', 11, 'spread_width', -0.6914, 0.3548),
  ('unknown', 11, 'standoff', 0.7316, 1.115),
  ('unknown', 11, 'tilt_deg', 89.53, 1.096),
  ('unknown', 11, 'wall_offset', 2.094, 0.3986),
  ('unknown', 11, 'width', -0.4119, 0.2345),
  ('unknown', 11, 'z_max', 0.7616, 0.05395),
  ('unknown', 11, 'z_min', 0.09258, 0.1479);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.01801, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'aspect', 1.421, 0.4779),
  ('unknown', 12, 'behind', 0.5428, 0.1659),
  ('unknown', 12, 'corner_offset', 0.5753, 0.7564),
  ('unknown', 12, 'edge_concave', 0.6335, 0.21),
  ('unknown', 12, 'edge_convex', 0.1457, 0.2367),
  ('unknown', 12, 'edge_free', 0.2161, 0.2449),
  ('unknown', 12, 'edge_free_top', 0.5654, 0.1298),
  ('unknown', 12, 'edge_unseen', 0.1706, 0.1137),
  ('unknown', 12, 'headroom', 1.273, 0.2145),
  ('unknown', 12, 'height', 0.8754, 0.1065),
  ('unknown', 12, 'lift', 0.1264, 0.05115),
  ('unknown', 12, 'rectangularity', 0.7042, 0.08087),
  ('unknown', 12, 'spread_length', -0.2846, 0.6261),
  ('unknown', 12, 'spread_width', -1.644, 0.3759),
  ('unknown', 12, 'standoff', 0.4543, 0.1251),
  ('unknown', 12, 'tilt_deg', 1.679, 1.608),
  ('unknown', 12, 'wall_offset', 0.7863, 0.7651),
  ('unknown', 12, 'width', -1.453, 0.2429),
  ('unknown', 12, 'z_max', 0.8874, 0.08969),
  ('unknown', 12, 'z_min', 0.8747, 0.1026);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.02644, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'aspect', 1.071, 0.3815),
  ('unknown', 13, 'behind', 0.7251, 0.1751),
  ('unknown', 13, 'corner_offset', 0.5043, 0.7325),
  ('unknown', 13, 'edge_concave', 0.6042, 0.1272),
  ('unknown', 13, 'edge_convex', 0.08377, 0.1409),
  ('unknown', 13, 'edge_free', 0.203, 0.08123),
  ('unknown', 13, 'edge_free_top', 0.2801, 0.156),
  ('unknown', 13, 'edge_unseen', 0.009604, 0.03006),
  ('unknown', 13, 'headroom', 0.2484, 0.9867),
  ('unknown', 13, 'height', 0.8484, 0.1588),
  ('unknown', 13, 'lift', -0.04775, 0.03446),
  ('unknown', 13, 'rectangularity', 0.5385, 0.1644),
  ('unknown', 13, 'spread_length', 0.5276, 0.3391),
  ('unknown', 13, 'spread_width', -0.7368, 0.7729),
  ('unknown', 13, 'standoff', 0.9719, 0.1744),
  ('unknown', 13, 'tilt_deg', 88.53, 0.8579),
  ('unknown', 13, 'wall_offset', 1.496, 0.5476),
  ('unknown', 13, 'width', -0.6739, 0.7208),
  ('unknown', 13, 'z_max', 1.337, 0.6509),
  ('unknown', 13, 'z_min', 0.2986, 0.337);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.02507, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'aspect', 1.552, 0.3118),
  ('unknown', 14, 'behind', 0.5123, 0.3184),
  ('unknown', 14, 'corner_offset', -0.1037, 0.04),
  ('unknown', 14, 'edge_concave', 0.9712, 0.03673),
  ('unknown', 14, 'edge_convex', 0.0004537, 0.03007),
  ('unknown', 14, 'edge_free', 0.2461, 0.2404),
  ('unknown', 14, 'edge_free_top', 0.01859, 0.05838),
  ('unknown', 14, 'edge_unseen', 0.01564, 0.07087),
  ('unknown', 14, 'headroom', 0.02054, 0.2267),
  ('unknown', 14, 'height', 1.468, 0.1554),
  ('unknown', 14, 'lift', -0.01626, 0.02588),
  ('unknown', 14, 'rectangularity', 0.7708, 0.0636),
  ('unknown', 14, 'spread_length', 0.01464, 0.2817),
  ('unknown', 14, 'spread_width', -1.516, 0.3677),
  ('unknown', 14, 'standoff', 0.5075, 0.2179),
  ('unknown', 14, 'tilt_deg', 89.86, 0.6712),
  ('unknown', 14, 'wall_offset', 0.9978, 0.7427),
  ('unknown', 14, 'width', -1.383, 0.3127),
  ('unknown', 14, 'z_max', 2.081, 0.2245),
  ('unknown', 14, 'z_min', 0.8633, 0.1275);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.02689, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'aspect', 0.7606, 0.2327),
  ('unknown', 15, 'behind', 0.2928, 0.1184),
  ('unknown', 15, 'corner_offset', 1.593, 1.657),
  ('unknown', 15, 'edge_concave', 0.458, 0.103),
  ('unknown', 15, 'edge_convex', -0.0002692, 0.03),
  ('unknown', 15, 'edge_free', 0.1564, 0.1636),
  ('unknown', 15, 'edge_free_top', 0.3287, 0.3266),
  ('unknown', 15, 'edge_unseen', 0.1619, 0.08149),
  ('unknown', 15, 'headroom', 0.08437, 0.09403),
  ('unknown', 15, 'height', 0.8006, 0.4013),
  ('unknown', 15, 'lift', -0.004898, 0.02506),
  ('unknown', 15, 'rectangularity', 0.6722, 0.08469),
  ('unknown', 15, 'spread_length', -0.8946, 0.4958),
  ('unknown', 15, 'spread_width', -1.58, 0.6099),
  ('unknown', 15, 'standoff', 0.4789, 0.1776),
  ('unknown', 15, 'tilt_deg', 87.67, 2.05),
  ('unknown', 15, 'wall_offset', 2.612, 0.6055),
  ('unknown', 15, 'width', -1.324, 0.5074),
  ('unknown', 15, 'z_max', 1.069, 0.3294),
  ('unknown', 15, 'z_min', 0.6291, 0.4367);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.01773, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'aspect', 0.38, 0.2394),
  ('unknown', 16, 'behind', 0.7031, 0.08755),
  ('unknown', 16, 'corner_offset', 1.62, 0.6424),
  ('unknown', 16, 'edge_concave', 0.5046, 0.114),
  ('unknown', 16, 'edge_convex', 0.1304, 0.1559),
  ('unknown', 16, 'edge_free', 0.5724, 0.1009),
  ('unknown', 16, 'edge_free_top', 0.8736, 0.1454),
  ('unknown', 16, 'edge_unseen', 0.001732, 0.03006),
  ('unknown', 16, 'headroom', 2.399, 0.2957),
  ('unknown', 16, 'height', 0.1896, 0.02258),
  ('unknown', 16, 'lift', 0.1961, 0.1349),
  ('unknown', 16, 'rectangularity', 0.7269, 0.1108),
  ('unknown', 16, 'spread_length', -1.135, 0.1707),
  ('unknown', 16, 'spread_width', -1.762, 0.1597),
  ('unknown', 16, 'standoff', 0.6662, 0.2123),
  ('unknown', 16, 'tilt_deg', 88.87, 1.927),
  ('unknown', 16, 'wall_offset', 0.9574, 0.3483),
  ('unknown', 16, 'width', -1.412, 0.3046),
  ('unknown', 16, 'z_max', 0.3387, 0.03752),
  ('unknown', 16, 'z_min', -0.01045, 0.02864);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.01664, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'aspect', 1.646, 0.3144),
  ('unknown', 17, 'behind', 0.7092, 0.07201),
  ('unknown', 17, 'corner_offset', -0.09734, 0.04),
  ('unknown', 17, 'edge_concave', 0.9625, 0.03141),
  ('unknown', 17, 'edge_convex', 0.000938, 0.03001),
  ('unknown', 17, 'edge_free', 0.08498, 0.1283),
  ('unknown', 17, 'edge_free_top', 0.5648, 0.1305),
  ('unknown', 17, 'edge_unseen', 0.01839, 0.037),
  ('unknown', 17, 'headroom', 1.153, 0.2468),
  ('unknown', 17, 'height', 1.558, 0.6257),
  ('unknown', 17, 'lift', 1.22, 0.1194),
  ('unknown', 17, 'rectangularity', 0.7725, 0.05616),
  ('unknown', 17, 'spread_length', 0.07576, 0.3742),
  ('unknown', 17, 'spread_width', -1.488, 0.2306),
  ('unknown', 17, 'standoff', 0.4535, 0.1261),
  ('unknown', 17, 'tilt_deg', 1.02, 1.392),
  ('unknown', 17, 'wall_offset', 0.7797, 0.7721),
  ('unknown', 17, 'width', -1.401, 0.2073),
  ('unknown', 17, 'z_max', 1.561, 0.6208),
  ('unknown', 17, 'z_min', 1.506, 0.6641);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.08859, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'aspect', 0.6505, 0.4127),
  ('unknown', 18, 'behind', 0.4031, 0.1459),
  ('unknown', 18, 'corner_offset', 1.472, 0.8439),
  ('unknown', 18, 'edge_concave', 0.4003, 0.2151),
  ('unknown', 18, 'edge_convex', 0.03231, 0.1065),
  ('unknown', 18, 'edge_free', 0.6183, 0.2175),
  ('unknown', 18, 'edge_free_top', 0.6885, 0.2826),
  ('unknown', 18, 'edge_unseen', 0.006966, 0.03011),
  ('unknown', 18, 'headroom', 1.382, 1.038),
  ('unknown', 18, 'height', 0.6057, 0.2872),
  ('unknown', 18, 'lift', -0.03427, 0.03563),
  ('unknown', 18, 'rectangularity', 0.6592, 0.1217),
  ('unknown', 18, 'spread_length', -0.2598, 0.6581),
  ('unknown', 18, 'spread_width', -1.046, 0.7056),
  ('unknown', 18, 'standoff', 0.1517, 0.0409),
  ('unknown', 18, 'tilt_deg', 88.47, 1.742),
  ('unknown', 18, 'wall_offset', 0.1991, 0.05858),
  ('unknown', 18, 'width', -0.8361, 0.6822),
  ('unknown', 18, 'z_max', 0.8227, 0.299),
  ('unknown', 18, 'z_min', 0.3205, 0.2553);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.02737, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'aspect', 0.3758, 0.3986),
  ('unknown', 19, 'behind', 0.3409, 0.1439),
  ('unknown', 19, 'corner_offset', 1.443, 0.7783),
  ('unknown', 19, 'edge_concave', 0.391, 0.235),
  ('unknown', 19, 'edge_convex', 0.08977, 0.1493),
  ('unknown', 19, 'edge_free', 0.5768, 0.1627),
  ('unknown', 19, 'edge_free_top', 0.907, 0.1273),
  ('unknown', 19, 'edge_unseen', 0.006218, 0.03001),
  ('unknown', 19, 'headroom', 0.8092, 0.6687),
  ('unknown', 19, 'height', 1.269, 0.1334),
  ('unknown', 19, 'lift', 0.2328, 0.2407),
  ('unknown', 19, 'rectangularity', 0.7662, 0.07841),
  ('unknown', 19, 'spread_length', -1.188, 0.3917),
  ('unknown', 19, 'spread_width', -1.516, 0.5392),
  ('unknown', 19, 'standoff', 0.326, 0.08108),
  ('unknown', 19, 'tilt_deg', 89.1, 0.7804),
  ('unknown', 19, 'wall_offset', 0.333, 0.1431),
  ('unknown', 19, 'width', -1.337, 0.6164),
  ('unknown', 19, 'z_max', 1.515, 0.2024),
  ('unknown', 19, 'z_min', 1.02, 0.1282);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.04778, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'aspect', 0.6303, 0.4187),
  ('unknown', 20, 'behind', 0.7449, 0.07127),
  ('unknown', 20, 'corner_offset', 0.2037, 0.07721),
  ('unknown', 20, 'edge_concave', 0.3892, 0.1843),
  ('unknown', 20, 'edge_convex', 0.08499, 0.163),
  ('unknown', 20, 'edge_free', 0.2881, 0.09695),
  ('unknown', 20, 'edge_free_top', 0.5591, 0.1173),
  ('unknown', 20, 'edge_unseen', 0.03483, 0.06086),
  ('unknown', 20, 'headroom', 1.051, 0.8543),
  ('unknown', 20, 'height', 1.002, 0.3893),
  ('unknown', 20, 'lift', 0.3665, 0.219),
  ('unknown', 20, 'rectangularity', 0.6453, 0.1163),
  ('unknown', 20, 'spread_length', -0.2957, 0.3359),
  ('unknown', 20, 'spread_width', -1.012, 0.3786),
  ('unknown', 20, 'standoff', 0.4386, 0.1021),
  ('unknown', 20, 'tilt_deg', 5.432, 1.522),
  ('unknown', 20, 'wall_offset', 0.7828, 0.7185),
  ('unknown', 20, 'width', -0.9275, 0.3002),
  ('unknown', 20, 'z_max', 1.025, 0.3759),
  ('unknown', 20, 'z_min', 1.016, 0.3638);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.02161, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'aspect', 1.002, 0.4616),
  ('unknown', 21, 'behind', 0.1857, 0.2458),
  ('unknown', 21, 'corner_offset', 0.8329, 0.5179),
  ('unknown', 21, 'edge_concave', 0.002967, 0.03),
  ('unknown', 21, 'edge_convex', 0.1797, 0.2243),
  ('unknown', 21, 'edge_free', 0.9787, 0.04625),
  ('unknown', 21, 'edge_free_top', 0.5655, 0.131),
  ('unknown', 21, 'edge_unseen', 0.1788, 0.1298),
  ('unknown', 21, 'headroom', 0.2935, 0.1233),
  ('unknown', 21, 'height', 2.609, 0.299),
  ('unknown', 21, 'lift', 1.988, 0.3797),
  ('unknown', 21, 'rectangularity', 0.7682, 0.1011),
  ('unknown', 21, 'spread_length', -0.59, 0.5006),
  ('unknown', 21, 'spread_width', -1.632, 0.09449),
  ('unknown', 21, 'standoff', 0.4538, 0.1264),
  ('unknown', 21, 'tilt_deg', 1.487, 1.553),
  ('unknown', 21, 'wall_offset', 0.8149, 0.7856),
  ('unknown', 21, 'width', -1.505, 0.09347),
  ('unknown', 21, 'z_max', 2.624, 0.3035),
  ('unknown', 21, 'z_min', 2.622, 0.2966);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.01856, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'aspect', 0.617, 0.231),
  ('unknown', 22, 'behind', 0.7475, 0.04403),
  ('unknown', 22, 'corner_offset', 0.1663, 0.04011),
  ('unknown', 22, 'edge_concave', 0.567, 0.2105),
  ('unknown', 22, 'edge_convex', 0.0006866, 0.03),
  ('unknown', 22, 'edge_free', 0.3341, 0.1459),
  ('unknown', 22, 'edge_free_top', 0.3854, 0.172),
  ('unknown', 22, 'edge_unseen', 0.002685, 0.03),
  ('unknown', 22, 'headroom', 0.4662, 0.5122),
  ('unknown', 22, 'height', 0.8181, 0.2094),
  ('unknown', 22, 'lift', -0.02283, 0.0481),
  ('unknown', 22, 'rectangularity', 0.6836, 0.05551),
  ('unknown', 22, 'spread_length', -1.057, 0.1786),
  ('unknown', 22, 'spread_width', -1.402, 0.1328),
  ('unknown', 22, 'standoff', 0.3344, 0.1512),
  ('unknown', 22, 'tilt_deg', 86.93, 5.106),
  ('unknown', 22, 'wall_offset', 1.551, 0.9049),
  ('unknown', 22, 'width', -1.227, 0.2491),
  ('unknown', 22, 'z_max', 1.097, 0.2513),
  ('unknown', 22, 'z_min', 0.6029, 0.2482);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.02782, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'aspect', 0.5169, 0.2045),
  ('unknown', 23, 'behind', 0.7215, 0.05677),
  ('unknown', 23, 'corner_offset', 0.1961, 0.1383),
  ('unknown', 23, 'edge_concave', 0.6448, 0.1577),
  ('unknown', 23, 'edge_convex', 0.09333, 0.09123),
  ('unknown', 23, 'edge_free', 0.3953, 0.1131),
  ('unknown', 23, 'edge_free_top', 0.6152, 0.1634),
  ('unknown', 23, 'edge_unseen', 0.00402, 0.03),
  ('unknown', 23, 'headroom', 0.7403, 0.5498),
  ('unknown', 23, 'height', 1.44, 0.3129),
  ('unknown', 23, 'lift', 0.233, 0.2584),
  ('unknown', 23, 'rectangularity', 0.6355, 0.06037),
  ('unknown', 23, 'spread_length', -0.9708, 0.2798),
  ('unknown', 23, 'spread_width', -1.377, 0.1869),
  ('unknown', 23, 'standoff', 0.4596, 0.3099),
  ('unknown', 23, 'tilt_deg', 88.95, 1.54),
  ('unknown', 23, 'wall_offset', 1.373, 0.4046),
  ('unknown', 23, 'width', -1.167, 0.2573),
  ('unknown', 23, 'z_max', 1.611, 0.3284),
  ('unknown', 23, 'z_min', 1.167, 0.2493);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.01603, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'aspect', 0.7303, 0.2988),
  ('unknown', 24, 'behind', 0.2434, 0.2202),
  ('unknown', 24, 'corner_offset', 0.8206, 0.6238),
  ('unknown', 24, 'edge_concave', 0.2557, 0.2892),
  ('unknown', 24, 'edge_convex', 0.0006712, 0.03),
  ('unknown', 24, 'edge_free', 0.502, 0.1695),
  ('unknown', 24, 'edge_free_top', 0.6108, 0.3817),
  ('unknown', 24, 'edge_unseen', 0.09031, 0.138),
  ('unknown', 24, 'headroom', 0.8325, 0.2426),
  ('unknown', 24, 'height', 0.1433, 0.1009),
  ('unknown', 24, 'lift', 0.1172, 0.1238),
  ('unknown', 24, 'rectangularity', 0.7744, 0.09517),
  ('unknown', 24, 'spread_length', -1.364, 0.3901),
  ('unknown', 24, 'spread_width', -2.114, 0.4186),
  ('unknown', 24, 'standoff', 0.3966, 0.2249),
  ('unknown', 24, 'tilt_deg', 21.47, 21.35),
  ('unknown', 24, 'wall_offset', 1.249, 0.4348),
  ('unknown', 24, 'width', -1.886, 0.4412),
  ('unknown', 24, 'z_max', 0.1689, 0.1342),
  ('unknown', 24, 'z_min', 0.06924, 0.0653);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.02479, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'aspect', 0.2805, 0.2165),
  ('unknown', 25, 'behind', 0.3911, 0.3048),
  ('unknown', 25, 'corner_offset', 0.7158, 0.4669),
  ('unknown', 25, 'edge_concave', 0.001831, 0.03),
  ('unknown', 25, 'edge_convex', 0.3329, 0.2811),
  ('unknown', 25, 'edge_free', 0.69, 0.1665),
  ('unknown', 25, 'edge_free_top', 0.5636, 0.115),
  ('unknown', 25, 'edge_unseen', 0.005122, 0.03),
  ('unknown', 25, 'headroom', 1.918, 0.3187),
  ('unknown', 25, 'height', 0.8804, 0.1702),
  ('unknown', 25, 'lift', 0.2037, 0.06931),
  ('unknown', 25, 'rectangularity', 0.842, 0.08479),
  ('unknown', 25, 'spread_length', -1.176, 0.1847),
  ('unknown', 25, 'spread_width', -1.467, 0.2827),
  ('unknown', 25, 'standoff', 0.4464, 0.1464),
  ('unknown', 25, 'tilt_deg', 0.7176, 0.946),
  ('unknown', 25, 'wall_offset', 0.8894, 0.6908),
  ('unknown', 25, 'width', -1.392, 0.3468),
  ('unknown', 25, 'z_max', 0.8607, 0.1456),
  ('unknown', 25, 'z_min', 0.8924, 0.1679);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.01236, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'aspect', 1.19, 0.5513),
  ('unknown', 26, 'behind', 0.5392, 0.1599),
  ('unknown', 26, 'corner_offset', 0.2037, 0.6202),
  ('unknown', 26, 'edge_concave', 0.6628, 0.1716),
  ('unknown', 26, 'edge_convex', 0.04368, 0.128),
  ('unknown', 26, 'edge_free', 0.3104, 0.239),
  ('unknown', 26, 'edge_free_top', 0.5673, 0.1334),
  ('unknown', 26, 'edge_unseen', 0.1419, 0.1539),
  ('unknown', 26, 'headroom', 0.4348, 0.1806),
  ('unknown', 26, 'height', 2.179, 0.1575),
  ('unknown', 26, 'lift', 1.26, 0.1983),
  ('unknown', 26, 'rectangularity', 0.6882, 0.1033),
  ('unknown', 26, 'spread_length', -0.56, 0.5793),
  ('unknown', 26, 'spread_width', -1.674, 0.2702),
  ('unknown', 26, 'standoff', 0.4538, 0.1263),
  ('unknown', 26, 'tilt_deg', 2.529, 2.917),
  ('unknown', 26, 'wall_offset', 0.9227, 0.7506),
  ('unknown', 26, 'width', -1.499, 0.2782),
  ('unknown', 26, 'z_max', 2.186, 0.1575),
  ('unknown', 26, 'z_min', 2.181, 0.1402);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.02099, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'aspect', 0.7776, 0.7699),
  ('unknown', 27, 'behind', 0.002156, 0.03),
  ('unknown', 27, 'corner_offset', -2.953, 3.999),
  ('unknown', 27, 'edge_concave', -0.001211, 0.03),
  ('unknown', 27, 'edge_convex', 0.0004574, 0.03),
  ('unknown', 27, 'edge_free', 0.004998, 0.03),
  ('unknown', 27, 'edge_free_top', 0.006859, 0.03),
  ('unknown', 27, 'edge_unseen', 0.1215, 0.1248),
  ('unknown', 27, 'headroom', 0.8345, 0.2432),
  ('unknown', 27, 'height', 2.038, 0.9617),
  ('unknown', 27, 'lift', 0.1979, 0.1346),
  ('unknown', 27, 'rectangularity', 0.8166, 0.144),
  ('unknown', 27, 'spread_length', 1.754, 0.4791),
  ('unknown', 27, 'spread_width', 1.013, 0.6747),
  ('unknown', 27, 'standoff', 0.4539, 0.1262),
  ('unknown', 27, 'tilt_deg', 89.89, 0.7791),
  ('unknown', 27, 'wall_offset', -12.21, 5.03),
  ('unknown', 27, 'width', 1.053, 0.7497),
  ('unknown', 27, 'z_max', 5.191, 2.535),
  ('unknown', 27, 'z_min', -0.7174, 1.417);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.02051, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'aspect', 0.4522, 0.2455),
  ('unknown', 28, 'behind', 0.5706, 0.1886),
  ('unknown', 28, 'corner_offset', 1.616, 0.611),
  ('unknown', 28, 'edge_concave', 0.4474, 0.1073),
  ('unknown', 28, 'edge_convex', 0.006958, 0.03107),
  ('unknown', 28, 'edge_free', 0.6368, 0.1338),
  ('unknown', 28, 'edge_free_top', 0.9746, 0.05687),
  ('unknown', 28, 'edge_unseen', 0.005492, 0.03113),
  ('unknown', 28, 'headroom', 1.869, 0.2729),
  ('unknown', 28, 'height', 0.8581, 0.04643),
  ('unknown', 28, 'lift', -0.009417, 0.03494),
  ('unknown', 28, 'rectangularity', 0.7068, 0.1063),
  ('unknown', 28, 'spread_length', -1.311, 0.1327),
  ('unknown', 28, 'spread_width', -1.501, 0.06427),
  ('unknown', 28, 'standoff', 0.4798, 0.2948),
  ('unknown', 28, 'tilt_deg', 74.82, 2.93),
  ('unknown', 28, 'wall_offset', 1.077, 0.909),
  ('unknown', 28, 'width', -1.384, 0.1188),
  ('unknown', 28, 'z_max', 0.9661, 0.05393),
  ('unknown', 28, 'z_min', 0.724, 0.07599);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.0127, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'aspect', 0.4774, 0.1081),
  ('unknown', 29, 'behind', 0.05901, 0.07062),
  ('unknown', 29, 'corner_offset', 1.506, 1.146),
  ('unknown', 29, 'edge_concave', 0.01786, 0.04587),
  ('unknown', 29, 'edge_convex', 0.005436, 0.03872),
  ('unknown', 29, 'edge_free', 0.8818, 0.1264),
  ('unknown', 29, 'edge_free_top', 0.717, 0.3748),
  ('unknown', 29, 'edge_unseen', 0.1073, 0.1277),
  ('unknown', 29, 'headroom', 0.7611, 0.3298),
  ('unknown', 29, 'height', 1.624, 0.07603),
  ('unknown', 29, 'lift', 0.5861, 0.1873),
  ('unknown', 29, 'rectangularity', 0.8423, 0.08668),
  ('unknown', 29, 'spread_length', -0.3259, 0.3535),
  ('unknown', 29, 'spread_width', -0.7515, 0.275),
  ('unknown', 29, 'standoff', 0.06121, 0.02907),
  ('unknown', 29, 'tilt_deg', 89.55, 1.78),
  ('unknown', 29, 'wall_offset', 1.95, 1.999),
  ('unknown', 29, 'width', -0.5423, 0.2303),
  ('unknown', 29, 'z_max', 1.984, 0.1378),
  ('unknown', 29, 'z_min', 1.358, 0.07599);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.01606, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'aspect', 0.4449, 0.3093),
  ('unknown', 30, 'behind', 0.511, 0.2495),
  ('unknown', 30, 'corner_offset', 0.8765, 0.8099),
  ('unknown', 30, 'edge_concave', 0.2855, 0.2126),
  ('unknown', 30, 'edge_convex', 0.1912, 0.19),
  ('unknown', 30, 'edge_free', 0.599, 0.1658),
  ('unknown', 30, 'edge_free_top', 0.9507, 0.09399),
  ('unknown', 30, 'edge_unseen', 0.001635, 0.03),
  ('unknown', 30, 'headroom', 0.6677, 0.2852),
  ('unknown', 30, 'height', 1.895, 0.153),
  ('unknown', 30, 'lift', 0.061, 0.1291),
  ('unknown', 30, 'rectangularity', 0.7177, 0.1844),
  ('unknown', 30, 'spread_length', -1.327, 0.2818),
  ('unknown', 30, 'spread_width', -1.713, 0.2668),
  ('unknown', 30, 'standoff', 0.5385, 0.2377),
  ('unknown', 30, 'tilt_deg', 89.25, 1.414),
  ('unknown', 30, 'wall_offset', 1.1, 1.045),
  ('unknown', 30, 'width', -1.492, 0.2648),
  ('unknown', 30, 'z_max', 2.04, 0.1672),
  ('unknown', 30, 'z_min', 1.71, 0.1494);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.01306, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'aspect', 0.4641, 0.3293),
  ('unknown', 31, 'behind', 0.33, 0.2385),
  ('unknown', 31, 'corner_offset', 0.982, 0.7324),
  ('unknown', 31, 'edge_concave', 0.1092, 0.1616),
  ('unknown', 31, 'edge_convex', 0.0007587, 0.03),
  ('unknown', 31, 'edge_free', 0.5138, 0.3085),
  ('unknown', 31, 'edge_free_top', 0.5378, 0.4309),
  ('unknown', 31, 'edge_unseen', 0.002055, 0.03),
  ('unknown', 31, 'headroom', 1.465, 0.8455),
  ('unknown', 31, 'height', 0.8777, 0.2051),
  ('unknown', 31, 'lift', 0.1778, 0.1658),
  ('unknown', 31, 'rectangularity', 0.7263, 0.1074),
  ('unknown', 31, 'spread_length', -1.68, 0.2576),
  ('unknown', 31, 'spread_width', -2.196, 0.2865),
  ('unknown', 31, 'standoff', 0.05419, 0.06826),
  ('unknown', 31, 'tilt_deg', 25.59, 16.21),
  ('unknown', 31, 'wall_offset', 1.549, 3.574),
  ('unknown', 31, 'width', -2.043, 0.2905),
  ('unknown', 31, 'z_max', 0.8991, 0.1944),
  ('unknown', 31, 'z_min', 0.8437, 0.2054);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.008454, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'aspect', 1.56, 0.3065),
  ('unknown', 32, 'behind', 0.2441, 0.2609),
  ('unknown', 32, 'corner_offset', 3.686, 1.039),
  ('unknown', 32, 'edge_concave', 0.7591, 0.2235),
  ('unknown', 32, 'edge_convex', 0.04623, 0.1145),
  ('unknown', 32, 'edge_free', 0.1256, 0.1262),
  ('unknown', 32, 'edge_free_top', 0.1, 0.1613),
  ('unknown', 32, 'edge_unseen', 0.1416, 0.1215),
  ('unknown', 32, 'headroom', -0.01794, 0.2142),
  ('unknown', 32, 'height', 1.469, 0.09278),
  ('unknown', 32, 'lift', 0.03589, 0.1324),
  ('unknown', 32, 'rectangularity', 0.7069, 0.1284),
  ('unknown', 32, 'spread_length', -0.09191, 0.2204),
  ('unknown', 32, 'spread_width', -1.628, 0.3569),
  ('unknown', 32, 'standoff', 0.4407, 0.1698),
  ('unknown', 32, 'tilt_deg', 89.57, 1.97),
  ('unknown', 32, 'wall_offset', 0.9811, 0.8332),
  ('unknown', 32, 'width', -1.367, 0.3257),
  ('unknown', 32, 'z_max', 2.138, 0.1784),
  ('unknown', 32, 'z_min', 0.8624, 0.1065);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.0325, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'aspect', 0.6885, 0.7426),
  ('unknown', 33, 'behind', 0.004784, 0.0302),
  ('unknown', 33, 'corner_offset', -2.617, 3.678),
  ('unknown', 33, 'edge_concave', -0.002258, 0.03),
  ('unknown', 33, 'edge_convex', 0.0004081, 0.03014),
  ('unknown', 33, 'edge_free', 0.008335, 0.03014),
  ('unknown', 33, 'edge_free_top', 0.01447, 0.04217),
  ('unknown', 33, 'edge_unseen', 0.005812, 0.03004),
  ('unknown', 33, 'headroom', 0.3933, 0.2027),
  ('unknown', 33, 'height', 1.651, 1.348),
  ('unknown', 33, 'lift', 0.1667, 0.1765),
  ('unknown', 33, 'rectangularity', 0.8624, 0.1286),
  ('unknown', 33, 'spread_length', 1.591, 0.2994),
  ('unknown', 33, 'spread_width', 0.9498, 0.4863),
  ('unknown', 33, 'standoff', 0.1003, 0.1168),
  ('unknown', 33, 'tilt_deg', 89.87, 0.5102),
  ('unknown', 33, 'wall_offset', -0.008635, 0.04472),
  ('unknown', 33, 'width', 0.9795, 0.5467),
  ('unknown', 33, 'z_max', 3.783, 2.25),
  ('unknown', 33, 'z_min', -0.5369, 0.8168);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.01212, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'aspect', 1.275, 0.6237),
  ('unknown', 34, 'behind', 0.5879, 0.185),
  ('unknown', 34, 'corner_offset', 2.416, 2.296),
  ('unknown', 34, 'edge_concave', 0.4579, 0.1825),
  ('unknown', 34, 'edge_convex', 0.3099, 0.2065),
  ('unknown', 34, 'edge_free', 0.2568, 0.2194),
  ('unknown', 34, 'edge_free_top', 0.0595, 0.09904),
  ('unknown', 34, 'edge_unseen', 0.1433, 0.09362),
  ('unknown', 34, 'headroom', 0.1697, 0.336),
  ('unknown', 34, 'height', 2.542, 0.6463),
  ('unknown', 34, 'lift', 0.015, 0.1544),
  ('unknown', 34, 'rectangularity', 0.7154, 0.1332),
  ('unknown', 34, 'spread_length', -0.1386, 0.754),
  ('unknown', 34, 'spread_width', -1.488, 0.4091),
  ('unknown', 34, 'standoff', 0.7731, 0.2519),
  ('unknown', 34, 'tilt_deg', 88.39, 2.631),
  ('unknown', 34, 'wall_offset', 0.9998, 0.4539),
  ('unknown', 34, 'width', -1.207, 0.3318),
  ('unknown', 34, 'z_max', 2.682, 0.6968),
  ('unknown', 34, 'z_min', 2.48, 0.5444);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.009937, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'aspect', 0.2057, 0.161),
  ('unknown', 35, 'behind', 0.285, 0.1092),
  ('unknown', 35, 'corner_offset', 0.8405, 0.5122),
  ('unknown', 35, 'edge_concave', 0.02439, 0.06201),
  ('unknown', 35, 'edge_convex', 0.001134, 0.03),
  ('unknown', 35, 'edge_free', 0.8082, 0.1104),
  ('unknown', 35, 'edge_free_top', 0.5653, 0.1308),
  ('unknown', 35, 'edge_unseen', 0.003333, 0.03),
  ('unknown', 35, 'headroom', 0.4413, 0.3365),
  ('unknown', 35, 'height', 0.1064, 0.03245),
  ('unknown', 35, 'lift', 0.1956, 0.1344),
  ('unknown', 35, 'rectangularity', 0.5889, 0.07147),
  ('unknown', 35, 'spread_length', -0.7785, 0.1032),
  ('unknown', 35, 'spread_width', -0.9949, 0.1619),
  ('unknown', 35, 'standoff', 0.454, 0.1263),
  ('unknown', 35, 'tilt_deg', 1.092, 1.963),
  ('unknown', 35, 'wall_offset', 0.7916, 0.7875),
  ('unknown', 35, 'width', -0.7725, 0.2484),
  ('unknown', 35, 'z_max', 0.11, 0.04232),
  ('unknown', 35, 'z_min', 0.1011, 0.03106);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.00675, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'aspect', 1.468, 0.6101),
  ('unknown', 36, 'behind', 0.6013, 0.2466),
  ('unknown', 36, 'corner_offset', 1.582, 0.8567),
  ('unknown', 36, 'edge_concave', 0.005724, 0.03265),
  ('unknown', 36, 'edge_convex', 0.6691, 0.1398),
  ('unknown', 36, 'edge_free', 0.808, 0.1974),
  ('unknown', 36, 'edge_free_top', 0.9445, 0.1201),
  ('unknown', 36, 'edge_unseen', 0.0536, 0.07235),
  ('unknown', 36, 'headroom', 0.2325, 0.1318),
  ('unknown', 36, 'height', 2.506, 0.2434),
  ('unknown', 36, 'lift', -0.02388, 0.0261),
  ('unknown', 36, 'rectangularity', 0.7273, 0.08109),
  ('unknown', 36, 'spread_length', -0.5263, 0.7381),
  ('unknown', 36, 'spread_width', -2.356, 0.1483),
  ('unknown', 36, 'standoff', 1.03, 0.2524),
  ('unknown', 36, 'tilt_deg', 83.63, 7.096),
  ('unknown', 36, 'wall_offset', 1.603, 0.6664),
  ('unknown', 36, 'width', -1.981, 0.3458),
  ('unknown', 36, 'z_max', 2.604, 0.2525),
  ('unknown', 36, 'z_min', 2.453, 0.2254);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.009118, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'aspect', 0.3153, 0.1583),
  ('unknown', 37, 'behind', 0.1906, 0.1655),
  ('unknown', 37, 'corner_offset', 1.472, 1.44),
  ('unknown', 37, 'edge_concave', 0.3391, 0.254),
  ('unknown', 37, 'edge_convex', 0.01415, 0.03665),
  ('unknown', 37, 'edge_free', 0.479, 0.1668),
  ('unknown', 37, 'edge_free_top', 0.4803, 0.2604),
  ('unknown', 37, 'edge_unseen', 0.05916, 0.08269),
  ('unknown', 37, 'headroom', -0.1998, 0.2488),
  ('unknown', 37, 'height', 1.478, 0.1655),
  ('unknown', 37, 'lift', 0.1285, 0.1859),
  ('unknown', 37, 'rectangularity', 0.6062, 0.09609),
  ('unknown', 37, 'spread_length', 0.3763, 0.4663),
  ('unknown', 37, 'spread_width', -0.1095, 0.3053),
  ('unknown', 37, 'standoff', 0.1133, 0.08925),
  ('unknown', 37, 'tilt_deg', 87.44, 1.057),
  ('unknown', 37, 'wall_offset', 0.3245, 1.271),
  ('unknown', 37, 'width', 0.3578, 0.545),
  ('unknown', 37, 'z_max', 2.319, 0.4732),
  ('unknown', 37, 'z_min', 0.4285, 0.5449);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.01258, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'aspect', 2.396, 0.2644),
  ('unknown', 38, 'behind', 0.1141, 0.151),
  ('unknown', 38, 'corner_offset', 0.696, 0.7023),
  ('unknown', 38, 'edge_concave', 0.1456, 0.2625),
  ('unknown', 38, 'edge_convex', 0.1833, 0.2665),
  ('unknown', 38, 'edge_free', 0.3967, 0.2461),
  ('unknown', 38, 'edge_free_top', 0.2637, 0.3209),
  ('unknown', 38, 'edge_unseen', 0.1163, 0.1677),
  ('unknown', 38, 'headroom', 0.6482, 0.4044),
  ('unknown', 38, 'height', 1.142, 0.2139),
  ('unknown', 38, 'lift', 0.3988, 0.1392),
  ('unknown', 38, 'rectangularity', 0.7382, 0.08233),
  ('unknown', 38, 'spread_length', 0.09092, 0.4903),
  ('unknown', 38, 'spread_width', -2.322, 0.1486),
  ('unknown', 38, 'standoff', 0.03689, 0.06993),
  ('unknown', 38, 'tilt_deg', 89.81, 1.386),
  ('unknown', 38, 'wall_offset', 0.08118, 0.1444),
  ('unknown', 38, 'width', -2.032, 0.2046),
  ('unknown', 38, 'z_max', 1.796, 0.2141),
  ('unknown', 38, 'z_min', 0.3196, 0.3038);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.01136, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'aspect', 0.7149, 0.3871),
  ('unknown', 39, 'behind', 0.06709, 0.1181),
  ('unknown', 39, 'corner_offset', 0.669, 0.6761),
  ('unknown', 39, 'edge_concave', 0.154, 0.3328),
  ('unknown', 39, 'edge_convex', -0.0001078, 0.03024),
  ('unknown', 39, 'edge_free', 0.03408, 0.03982),
  ('unknown', 39, 'edge_free_top', 0.04423, 0.0863),
  ('unknown', 39, 'edge_unseen', 0.007489, 0.03041),
  ('unknown', 39, 'headroom', 0.5511, 0.2496),
  ('unknown', 39, 'height', 1.397, 0.2113),
  ('unknown', 39, 'lift', 0.2598, 0.08574),
  ('unknown', 39, 'rectangularity', 0.5116, 0.366),
  ('unknown', 39, 'spread_length', 0.5645, 0.215),
  ('unknown', 39, 'spread_width', 0.3482, 0.1175),
  ('unknown', 39, 'standoff', 0.05556, 0.03932),
  ('unknown', 39, 'tilt_deg', 89.43, 1.679),
  ('unknown', 39, 'wall_offset', 0.02892, 0.1048),
  ('unknown', 39, 'width', 0.06772, 0.1103),
  ('unknown', 39, 'z_max', 2.189, 0.1183),
  ('unknown', 39, 'z_min', 0.1697, 0.3069);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.003678, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'aspect', 1.289, 0.3045),
  ('unknown', 40, 'behind', 0.6622, 0.06583),
  ('unknown', 40, 'corner_offset', 0.6076, 0.4755),
  ('unknown', 40, 'edge_concave', 0.2391, 0.1458),
  ('unknown', 40, 'edge_convex', 0.01687, 0.03938),
  ('unknown', 40, 'edge_free', 0.7374, 0.0802),
  ('unknown', 40, 'edge_free_top', 0.5649, 0.1308),
  ('unknown', 40, 'edge_unseen', 0.01598, 0.03707),
  ('unknown', 40, 'headroom', 0.3856, 0.1518),
  ('unknown', 40, 'height', 2.403, 0.2111),
  ('unknown', 40, 'lift', 1.216, 0.3617),
  ('unknown', 40, 'rectangularity', 0.5826, 0.1499),
  ('unknown', 40, 'spread_length', 0.2544, 0.1502),
  ('unknown', 40, 'spread_width', -1.493, 0.1144),
  ('unknown', 40, 'standoff', 0.4535, 0.1265),
  ('unknown', 40, 'tilt_deg', 3.034, 4.562),
  ('unknown', 40, 'wall_offset', 0.7934, 0.7887),
  ('unknown', 40, 'width', -0.9461, 0.2651),
  ('unknown', 40, 'z_max', 2.425, 0.2138),
  ('unknown', 40, 'z_min', 2.399, 0.2087);

-- floor: 512 examples
UPDATE object_class SET prior = 0.03771 WHERE name = 'floor';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.261, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'aspect', 0.2177, 0.1448),
  ('floor', 1, 'behind', -0.001549, 0.03242),
  ('floor', 1, 'corner_offset', 1.606, 0.5695),
  ('floor', 1, 'edge_concave', 0.4097, 0.1226),
  ('floor', 1, 'edge_convex', -9.374e-05, 0.03228),
  ('floor', 1, 'edge_free', -0.0003995, 0.03148),
  ('floor', 1, 'edge_free_top', -0.0004825, 0.3221),
  ('floor', 1, 'edge_unseen', 0.1988, 0.1129),
  ('floor', 1, 'headroom', 2.77, 0.2297),
  ('floor', 1, 'height', 0.0003544, 0.02255),
  ('floor', 1, 'lift', -3.519e-05, 0.3165),
  ('floor', 1, 'rectangularity', 0.5863, 0.119),
  ('floor', 1, 'spread_length', 1.278, 0.1285),
  ('floor', 1, 'spread_width', 0.916, 0.1229),
  ('floor', 1, 'standoff', -5.271e-05, 0.3169),
  ('floor', 1, 'tilt_deg', 0.004318, 0.4679),
  ('floor', 1, 'wall_offset', 0.01078, 0.3164),
  ('floor', 1, 'width', 1.4, 0.1208),
  ('floor', 1, 'z_max', 0.0009783, 0.02286),
  ('floor', 1, 'z_min', 0.0006739, 0.02345);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.126, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'aspect', 0.3254, 0.151),
  ('floor', 2, 'behind', -0.0007444, 0.03148),
  ('floor', 2, 'corner_offset', 1.318, 0.4255),
  ('floor', 2, 'edge_concave', 0.437, 0.0839),
  ('floor', 2, 'edge_convex', -5.271e-05, 0.03083),
  ('floor', 2, 'edge_free', -0.0001957, 0.03041),
  ('floor', 2, 'edge_free_top', -0.0003225, 0.3206),
  ('floor', 2, 'edge_unseen', 0.2095, 0.04926),
  ('floor', 2, 'headroom', 2.762, 0.1992),
  ('floor', 2, 'height', 0.0001704, 0.02256),
  ('floor', 2, 'lift', 8.339e-05, 0.3166),
  ('floor', 2, 'rectangularity', 0.5805, 0.1028),
  ('floor', 2, 'spread_length', 1.12, 0.1306),
  ('floor', 2, 'spread_width', 0.6549, 0.1296),
  ('floor', 2, 'standoff', 4.972e-08, 0.3167),
  ('floor', 2, 'tilt_deg', 0.02787, 0.4581),
  ('floor', 2, 'wall_offset', 0.004566, 0.3263),
  ('floor', 2, 'width', 1.052, 0.147),
  ('floor', 2, 'z_max', 0.001117, 0.02252),
  ('floor', 2, 'z_min', -7.141e-05, 0.02257);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.1661, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'aspect', 0.9558, 0.4233),
  ('floor', 3, 'behind', -0.007619, 0.03),
  ('floor', 3, 'corner_offset', 0.7163, 0.1107),
  ('floor', 3, 'edge_concave', 0.2325, 0.1619),
  ('floor', 3, 'edge_convex', -0.0003409, 0.03187),
  ('floor', 3, 'edge_free', -0.001587, 0.03),
  ('floor', 3, 'edge_free_top', -0.002712, 0.3236),
  ('floor', 3, 'edge_unseen', 0.388, 0.1326),
  ('floor', 3, 'headroom', 0.9158, 0.08253),
  ('floor', 3, 'height', 0.0111, 0.04292),
  ('floor', 3, 'lift', -0.002637, 0.3161),
  ('floor', 3, 'rectangularity', 0.656, 0.1557),
  ('floor', 3, 'spread_length', 0.02749, 0.4604),
  ('floor', 3, 'spread_width', -0.8268, 0.2869),
  ('floor', 3, 'standoff', -0.0005902, 0.3189),
  ('floor', 3, 'tilt_deg', 2.082, 0.4799),
  ('floor', 3, 'wall_offset', -0.003141, 0.3481),
  ('floor', 3, 'width', -0.6046, 0.3837),
  ('floor', 3, 'z_max', 0.02896, 0.04533),
  ('floor', 3, 'z_min', -0.003842, 0.04477);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.1084, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'aspect', 0.7839, 0.1446),
  ('floor', 4, 'behind', -0.0002898, 0.03281),
  ('floor', 4, 'corner_offset', 1.314, 0.4258),
  ('floor', 4, 'edge_concave', 0.3738, 0.08571),
  ('floor', 4, 'edge_convex', -5.272e-05, 0.03089),
  ('floor', 4, 'edge_free', -0.0004525, 0.03006),
  ('floor', 4, 'edge_free_top', -0.0006488, 0.3198),
  ('floor', 4, 'edge_unseen', 0.2898, 0.073),
  ('floor', 4, 'headroom', 2.654, 0.1989),
  ('floor', 4, 'height', -0.0002562, 0.0225),
  ('floor', 4, 'lift', 5.661e-05, 0.3164),
  ('floor', 4, 'rectangularity', 0.5176, 0.1094),
  ('floor', 4, 'spread_length', 1.349, 0.1705),
  ('floor', 4, 'spread_width', 0.5677, 0.1929),
  ('floor', 4, 'standoff', -1.656e-05, 0.3164),
  ('floor', 4, 'tilt_deg', 0.02138, 0.4562),
  ('floor', 4, 'wall_offset', 0.000673, 0.3319),
  ('floor', 4, 'width', 0.9428, 0.2356),
  ('floor', 4, 'z_max', 0.0003962, 0.0225),
  ('floor', 4, 'z_min', -0.0002118, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.08023, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'aspect', 1.046, 0.5692),
  ('floor', 5, 'behind', -0.003744, 0.03003),
  ('floor', 5, 'corner_offset', 0.2798, 0.3799),
  ('floor', 5, 'edge_concave', 0.3119, 0.1804),
  ('floor', 5, 'edge_convex', -0.0001433, 0.0387),
  ('floor', 5, 'edge_free', -0.002664, 0.03),
  ('floor', 5, 'edge_free_top', -0.002187, 0.3251),
  ('floor', 5, 'edge_unseen', 0.3576, 0.1866),
  ('floor', 5, 'headroom', 1.414, 0.5154),
  ('floor', 5, 'height', -0.01182, 0.02271),
  ('floor', 5, 'lift', -0.004488, 0.3136),
  ('floor', 5, 'rectangularity', 0.6406, 0.1075),
  ('floor', 5, 'spread_length', -0.4399, 0.4986),
  ('floor', 5, 'spread_width', -1.526, 0.3076),
  ('floor', 5, 'standoff', -0.001016, 0.319),
  ('floor', 5, 'tilt_deg', 1.691, 0.7366),
  ('floor', 5, 'wall_offset', -0.01059, 0.3607),
  ('floor', 5, 'width', -1.276, 0.3144),
  ('floor', 5, 'z_max', -0.01036, 0.02767),
  ('floor', 5, 'z_min', -0.02395, 0.03129);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.06298, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'aspect', 0.4743, 0.2885),
  ('floor', 6, 'behind', -0.004127, 0.03),
  ('floor', 6, 'corner_offset', 0.8781, 0.3352),
  ('floor', 6, 'edge_concave', 0.2055, 0.1264),
  ('floor', 6, 'edge_convex', -0.001825, 0.03003),
  ('floor', 6, 'edge_free', -0.0006169, 0.03),
  ('floor', 6, 'edge_free_top', -0.001035, 0.3193),
  ('floor', 6, 'edge_unseen', 0.3088, 0.1357),
  ('floor', 6, 'headroom', 0.7855, 0.2459),
  ('floor', 6, 'height', 0.006544, 0.02372),
  ('floor', 6, 'lift', -0.0002114, 0.3165),
  ('floor', 6, 'rectangularity', 0.571, 0.157),
  ('floor', 6, 'spread_length', 0.5152, 0.1528),
  ('floor', 6, 'spread_width', -0.1603, 0.1876),
  ('floor', 6, 'standoff', -0.0002218, 0.3187),
  ('floor', 6, 'tilt_deg', 1.443, 0.7192),
  ('floor', 6, 'wall_offset', -0.001771, 0.3268),
  ('floor', 6, 'width', 0.1512, 0.1898),
  ('floor', 6, 'z_max', 0.02869, 0.02904),
  ('floor', 6, 'z_min', -0.01555, 0.02277);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.06698, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'aspect', 0.3948, 0.3192),
  ('floor', 7, 'behind', -0.0004145, 0.03198),
  ('floor', 7, 'corner_offset', 1.328, 0.5281),
  ('floor', 7, 'edge_concave', 0.3195, 0.09083),
  ('floor', 7, 'edge_convex', -9.093e-05, 0.03081),
  ('floor', 7, 'edge_free', -0.0003194, 0.03019),
  ('floor', 7, 'edge_free_top', -0.0006973, 0.3216),
  ('floor', 7, 'edge_unseen', 0.183, 0.1133),
  ('floor', 7, 'headroom', 0.7188, 0.1874),
  ('floor', 7, 'height', -0.0002364, 0.02257),
  ('floor', 7, 'lift', -4.674e-05, 0.3163),
  ('floor', 7, 'rectangularity', 0.4648, 0.1231),
  ('floor', 7, 'spread_length', 1.435, 0.1643),
  ('floor', 7, 'spread_width', 0.7954, 0.2897),
  ('floor', 7, 'standoff', -0.0002739, 0.3187),
  ('floor', 7, 'tilt_deg', 0.02605, 0.4515),
  ('floor', 7, 'wall_offset', 0.003097, 0.3311),
  ('floor', 7, 'width', 1.324, 0.2609),
  ('floor', 7, 'z_max', 0.0001963, 0.02255),
  ('floor', 7, 'z_min', -0.0003607, 0.0226);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.0592, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'aspect', 0.3839, 0.2111),
  ('floor', 8, 'behind', -0.0006042, 0.03084),
  ('floor', 8, 'corner_offset', 1.298, 0.3469),
  ('floor', 8, 'edge_concave', 0.2153, 0.1099),
  ('floor', 8, 'edge_convex', -8.437e-05, 0.03093),
  ('floor', 8, 'edge_free', -0.0003792, 0.03008),
  ('floor', 8, 'edge_free_top', -0.0006316, 0.3221),
  ('floor', 8, 'edge_unseen', 0.3637, 0.08947),
  ('floor', 8, 'headroom', 0.9875, 0.2737),
  ('floor', 8, 'height', 0.0005077, 0.02253),
  ('floor', 8, 'lift', 6.94e-05, 0.3167),
  ('floor', 8, 'rectangularity', 0.5777, 0.07674),
  ('floor', 8, 'spread_length', 0.9397, 0.1802),
  ('floor', 8, 'spread_width', 0.4806, 0.2842),
  ('floor', 8, 'standoff', -0.0001552, 0.3203),
  ('floor', 8, 'tilt_deg', 1.334, 0.501),
  ('floor', 8, 'wall_offset', 0.0004025, 0.3289),
  ('floor', 8, 'width', 0.7993, 0.2742),
  ('floor', 8, 'z_max', 0.03549, 0.02256),
  ('floor', 8, 'z_min', -0.0388, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.01913, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'aspect', 1.04, 0.4765),
  ('floor', 9, 'behind', -0.0003941, 0.03016),
  ('floor', 9, 'corner_offset', 0.7471, 0.2813),
  ('floor', 9, 'edge_concave', 0.2068, 0.1274),
  ('floor', 9, 'edge_convex', -1.069e-05, 0.03201),
  ('floor', 9, 'edge_free', -0.0006669, 0.03),
  ('floor', 9, 'edge_free_top', -0.0006498, 0.3203),
  ('floor', 9, 'edge_unseen', 0.369, 0.1328),
  ('floor', 9, 'headroom', 1.492, 0.4241),
  ('floor', 9, 'height', -0.3617, 0.3437),
  ('floor', 9, 'lift', -0.001015, 0.3165),
  ('floor', 9, 'rectangularity', 0.6203, 0.1908),
  ('floor', 9, 'spread_length', -0.07325, 0.3563),
  ('floor', 9, 'spread_width', -1.121, 0.4574),
  ('floor', 9, 'standoff', 4.031e-05, 0.3178),
  ('floor', 9, 'tilt_deg', 2.808, 0.8254),
  ('floor', 9, 'wall_offset', -0.001753, 0.3277),
  ('floor', 9, 'width', -0.8654, 0.5347),
  ('floor', 9, 'z_max', -0.3783, 0.3325),
  ('floor', 9, 'z_min', -0.3811, 0.3521);

-- ceiling: 432 examples
UPDATE object_class SET prior = 0.04556 WHERE name = 'ceiling';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'lift', 2.224, 0.3906)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.1888, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'aspect', 0.2493, 0.1725),
  ('ceiling', 1, 'behind', -0.0009725, 0.03026),
  ('ceiling', 1, 'corner_offset', 1.53, 0.5308),
  ('ceiling', 1, 'edge_concave', 0.6067, 0.1097),
  ('ceiling', 1, 'edge_convex', 5.794e-05, 0.03),
  ('ceiling', 1, 'edge_free', 1.676e-05, 0.03),
  ('ceiling', 1, 'edge_free_top', -0.0001162, 0.3203),
  ('ceiling', 1, 'edge_unseen', 0.316, 0.112),
  ('ceiling', 1, 'headroom', -0.01984, 0.3258),
  ('ceiling', 1, 'height', 2.525, 0.07279),
  ('ceiling', 1, 'lift', 2.216, 0.1246),
  ('ceiling', 1, 'rectangularity', 0.6735, 0.1119),
  ('ceiling', 1, 'spread_length', 1.435, 0.1488),
  ('ceiling', 1, 'spread_width', 1.002, 0.1922),
  ('ceiling', 1, 'standoff', -4.336e-05, 0.3164),
  ('ceiling', 1, 'tilt_deg', -0.01609, 0.45),
  ('ceiling', 1, 'wall_offset', 0.01589, 0.3142),
  ('ceiling', 1, 'width', 1.331, 0.1922),
  ('ceiling', 1, 'z_max', 2.524, 0.07383),
  ('ceiling', 1, 'z_min', 2.525, 0.07413);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1435, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'aspect', 0.225, 0.1387),
  ('ceiling', 2, 'behind', 0.0001247, 0.03345),
  ('ceiling', 2, 'corner_offset', 1.55, 0.364),
  ('ceiling', 2, 'edge_concave', 0.5919, 0.108),
  ('ceiling', 2, 'edge_convex', 8.554e-05, 0.03043),
  ('ceiling', 2, 'edge_free', 5.354e-05, 0.03044),
  ('ceiling', 2, 'edge_free_top', -0.0001139, 0.3236),
  ('ceiling', 2, 'edge_unseen', 0.339, 0.1062),
  ('ceiling', 2, 'headroom', -0.006526, 0.3275),
  ('ceiling', 2, 'height', 2.726, 0.05584),
  ('ceiling', 2, 'lift', 2.216, 0.1263),
  ('ceiling', 2, 'rectangularity', 0.6444, 0.09434),
  ('ceiling', 2, 'spread_length', 1.481, 0.134),
  ('ceiling', 2, 'spread_width', 1.02, 0.1871),
  ('ceiling', 2, 'standoff', -1.533e-05, 0.3164),
  ('ceiling', 2, 'tilt_deg', -0.03149, 0.45),
  ('ceiling', 2, 'wall_offset', 0.02834, 0.2789),
  ('ceiling', 2, 'width', 1.365, 0.1514),
  ('ceiling', 2, 'z_max', 2.723, 0.04774),
  ('ceiling', 2, 'z_min', 2.728, 0.05892);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.1496, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'aspect', 0.3885, 0.3166),
  ('ceiling', 3, 'behind', 6.309e-05, 0.03055),
  ('ceiling', 3, 'corner_offset', 1.205, 0.5353),
  ('ceiling', 3, 'edge_concave', 0.5989, 0.09343),
  ('ceiling', 3, 'edge_convex', 9.747e-05, 0.03001),
  ('ceiling', 3, 'edge_free', 0.0001059, 0.03),
  ('ceiling', 3, 'edge_free_top', -0.0001114, 0.3184),
  ('ceiling', 3, 'edge_unseen', 0.3123, 0.08474),
  ('ceiling', 3, 'headroom', -0.003464, 0.3269),
  ('ceiling', 3, 'height', 3.039, 0.04647),
  ('ceiling', 3, 'lift', 2.212, 0.119),
  ('ceiling', 3, 'rectangularity', 0.6399, 0.1174),
  ('ceiling', 3, 'spread_length', 1.432, 0.156),
  ('ceiling', 3, 'spread_width', 0.8388, 0.2667),
  ('ceiling', 3, 'standoff', -3.686e-05, 0.3162),
  ('ceiling', 3, 'tilt_deg', 0.00224, 0.45),
  ('ceiling', 3, 'wall_offset', 0.006982, 0.3281),
  ('ceiling', 3, 'width', 1.175, 0.293),
  ('ceiling', 3, 'z_max', 3.041, 0.04446),
  ('ceiling', 3, 'z_min', 3.04, 0.04575);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.1098, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'aspect', 0.2492, 0.1605),
  ('ceiling', 4, 'behind', 0.0001705, 0.03231),
  ('ceiling', 4, 'corner_offset', 1.477, 0.4772),
  ('ceiling', 4, 'edge_concave', 0.6629, 0.1318),
  ('ceiling', 4, 'edge_convex', 0.0001244, 0.0302),
  ('ceiling', 4, 'edge_free', 0.0001525, 0.03018),
  ('ceiling', 4, 'edge_free_top', -0.000235, 0.3213),
  ('ceiling', 4, 'edge_unseen', 0.2838, 0.114),
  ('ceiling', 4, 'headroom', -0.01706, 0.3216),
  ('ceiling', 4, 'height', 2.888, 0.04289),
  ('ceiling', 4, 'lift', 2.215, 0.1253),
  ('ceiling', 4, 'rectangularity', 0.7135, 0.1192),
  ('ceiling', 4, 'spread_length', 1.447, 0.1451),
  ('ceiling', 4, 'spread_width', 1.002, 0.1998),
  ('ceiling', 4, 'standoff', -2.675e-05, 0.3165),
  ('ceiling', 4, 'tilt_deg', -0.006537, 0.45),
  ('ceiling', 4, 'wall_offset', 0.01463, 0.3062),
  ('ceiling', 4, 'width', 1.301, 0.2046),
  ('ceiling', 4, 'z_max', 2.887, 0.04433),
  ('ceiling', 4, 'z_min', 2.887, 0.04429);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.06098, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'aspect', 0.9179, 0.3609),
  ('ceiling', 5, 'behind', 0.0008166, 0.03005),
  ('ceiling', 5, 'corner_offset', -0.5819, 0.4559),
  ('ceiling', 5, 'edge_concave', 0.2673, 0.1351),
  ('ceiling', 5, 'edge_convex', 0.000174, 0.03012),
  ('ceiling', 5, 'edge_free', 0.0002465, 0.03),
  ('ceiling', 5, 'edge_free_top', -9.379e-05, 0.3186),
  ('ceiling', 5, 'edge_unseen', 0.08364, 0.1178),
  ('ceiling', 5, 'headroom', -0.1363, 0.1663),
  ('ceiling', 5, 'height', 2.507, 0.02402),
  ('ceiling', 5, 'lift', 2.222, 0.1103),
  ('ceiling', 5, 'rectangularity', 0.7294, 0.1243),
  ('ceiling', 5, 'spread_length', 0.03539, 0.4114),
  ('ceiling', 5, 'spread_width', -0.8733, 0.2226),
  ('ceiling', 5, 'standoff', -4.387e-05, 0.3161),
  ('ceiling', 5, 'tilt_deg', 0.1911, 0.4523),
  ('ceiling', 5, 'wall_offset', -7.657e-08, 0.3119),
  ('ceiling', 5, 'width', -0.8989, 0.6832),
  ('ceiling', 5, 'z_max', 2.504, 0.02252),
  ('ceiling', 5, 'z_min', 2.505, 0.02251);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.1008, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'aspect', 0.4758, 0.2729),
  ('ceiling', 6, 'behind', 0.0001513, 0.03),
  ('ceiling', 6, 'corner_offset', 0.6449, 0.7774),
  ('ceiling', 6, 'edge_concave', 0.5029, 0.1116),
  ('ceiling', 6, 'edge_convex', 0.0002014, 0.03),
  ('ceiling', 6, 'edge_free', 0.0002455, 0.03),
  ('ceiling', 6, 'edge_free_top', -0.0003792, 0.3221),
  ('ceiling', 6, 'edge_unseen', 0.2929, 0.07203),
  ('ceiling', 6, 'headroom', -0.01127, 0.3296),
  ('ceiling', 6, 'height', 3.372, 0.3163),
  ('ceiling', 6, 'lift', 2.215, 0.1253),
  ('ceiling', 6, 'rectangularity', 0.6251, 0.1086),
  ('ceiling', 6, 'spread_length', 1.363, 0.2351),
  ('ceiling', 6, 'spread_width', 0.7126, 0.2914),
  ('ceiling', 6, 'standoff', -0.0002609, 0.3162),
  ('ceiling', 6, 'tilt_deg', 0.01734, 0.45),
  ('ceiling', 6, 'wall_offset', 0.01538, 0.3167),
  ('ceiling', 6, 'width', 1.003, 0.352),
  ('ceiling', 6, 'z_max', 3.372, 0.3315),
  ('ceiling', 6, 'z_min', 3.369, 0.3332);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.04527, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'aspect', 0.4701, 0.3813),
  ('ceiling', 7, 'behind', 0.000218, 0.03531),
  ('ceiling', 7, 'corner_offset', 0.1251, 0.07675),
  ('ceiling', 7, 'edge_concave', 0.5287, 0.07962),
  ('ceiling', 7, 'edge_convex', 0.0002148, 0.03021),
  ('ceiling', 7, 'edge_free', 0.0001537, 0.03003),
  ('ceiling', 7, 'edge_free_top', 4.283e-05, 0.3183),
  ('ceiling', 7, 'edge_unseen', 0.566, 0.0535),
  ('ceiling', 7, 'headroom', -0.07115, 0.2636),
  ('ceiling', 7, 'height', 3.162, 0.3026),
  ('ceiling', 7, 'lift', 2.059, 0.4029),
  ('ceiling', 7, 'rectangularity', 0.6085, 0.09873),
  ('ceiling', 7, 'spread_length', -0.554, 0.5358),
  ('ceiling', 7, 'spread_width', -1.188, 0.4906),
  ('ceiling', 7, 'standoff', -0.0001946, 0.316),
  ('ceiling', 7, 'tilt_deg', 0.5795, 0.8158),
  ('ceiling', 7, 'wall_offset', 0.001466, 0.3186),
  ('ceiling', 7, 'width', -0.9053, 0.481),
  ('ceiling', 7, 'z_max', 3.175, 0.322),
  ('ceiling', 7, 'z_min', 3.128, 0.1222);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.06705, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'aspect', 0.7246, 0.477),
  ('ceiling', 8, 'behind', 0.00796, 0.03001),
  ('ceiling', 8, 'corner_offset', 1.118, 1.729),
  ('ceiling', 8, 'edge_concave', 0.4457, 0.1061),
  ('ceiling', 8, 'edge_convex', 0.0003655, 0.03115),
  ('ceiling', 8, 'edge_free', 0.001712, 0.03269),
  ('ceiling', 8, 'edge_free_top', -0.003161, 0.3248),
  ('ceiling', 8, 'edge_unseen', 0.3992, 0.1425),
  ('ceiling', 8, 'headroom', -0.08576, 0.2446),
  ('ceiling', 8, 'height', 3.212, 0.5353),
  ('ceiling', 8, 'lift', 2.252, 0.1157),
  ('ceiling', 8, 'rectangularity', 0.6173, 0.05167),
  ('ceiling', 8, 'spread_length', 0.1475, 0.3742),
  ('ceiling', 8, 'spread_width', -0.6861, 0.4366),
  ('ceiling', 8, 'standoff', -0.001669, 0.3179),
  ('ceiling', 8, 'tilt_deg', 0.1687, 0.45),
  ('ceiling', 8, 'wall_offset', 0.008873, 0.3235),
  ('ceiling', 8, 'width', -0.4412, 0.4729),
  ('ceiling', 8, 'z_max', 3.176, 0.5732),
  ('ceiling', 8, 'z_min', 3.215, 0.5334);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.08426, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'aspect', 0.8509, 0.3189),
  ('ceiling', 9, 'behind', 0.3488, 0.1126),
  ('ceiling', 9, 'corner_offset', 0.4233, 0.3828),
  ('ceiling', 9, 'edge_concave', 0.4894, 0.1563),
  ('ceiling', 9, 'edge_convex', 0.1655, 0.1215),
  ('ceiling', 9, 'edge_free', 0.2848, 0.1279),
  ('ceiling', 9, 'edge_free_top', -0.001972, 0.3185),
  ('ceiling', 9, 'edge_unseen', 0.1971, 0.1011),
  ('ceiling', 9, 'headroom', -0.1082, 0.1816),
  ('ceiling', 9, 'height', 2.937, 0.348),
  ('ceiling', 9, 'lift', 2.223, 0.1067),
  ('ceiling', 9, 'rectangularity', 0.7418, 0.09577),
  ('ceiling', 9, 'spread_length', 0.6932, 0.4814),
  ('ceiling', 9, 'spread_width', -0.2631, 0.349),
  ('ceiling', 9, 'standoff', -0.002462, 0.3132),
  ('ceiling', 9, 'tilt_deg', 0.01209, 0.45),
  ('ceiling', 9, 'wall_offset', 0.001457, 0.3106),
  ('ceiling', 9, 'width', -0.08189, 0.3189),
  ('ceiling', 9, 'z_max', 2.914, 0.341),
  ('ceiling', 9, 'z_min', 2.932, 0.3378);

-- wall: 2606 examples
UPDATE object_class SET prior = 0.2567 WHERE name = 'wall';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'lift', 0.1415, 0.305)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.0517, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'aspect', 0.521, 0.3625),
  ('wall', 1, 'behind', -0.005708, 0.03),
  ('wall', 1, 'corner_offset', 1.82, 1.305),
  ('wall', 1, 'edge_concave', 0.5724, 0.1278),
  ('wall', 1, 'edge_convex', 0.001659, 0.031),
  ('wall', 1, 'edge_free', 0.0143, 0.03945),
  ('wall', 1, 'edge_free_top', 0.002792, 0.03051),
  ('wall', 1, 'edge_unseen', 0.1361, 0.1852),
  ('wall', 1, 'headroom', -0.02001, 0.03),
  ('wall', 1, 'height', 1.593, 0.3415),
  ('wall', 1, 'lift', 0.1652, 0.08057),
  ('wall', 1, 'rectangularity', 0.5832, 0.1891),
  ('wall', 1, 'spread_length', 1.1, 0.2322),
  ('wall', 1, 'spread_width', 0.7267, 0.1183),
  ('wall', 1, 'standoff', 0.7283, 0.1664),
  ('wall', 1, 'tilt_deg', 90.19, 0.45),
  ('wall', 1, 'wall_offset', 2.98, 2.852),
  ('wall', 1, 'width', 1.084, 0.1001),
  ('wall', 1, 'z_max', 2.998, 0.4049),
  ('wall', 1, 'z_min', -0.02267, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.2395, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'aspect', 0.6721, 0.4972),
  ('wall', 2, 'behind', -0.01283, 0.03),
  ('wall', 2, 'corner_offset', -0.3799, 1.446),
  ('wall', 2, 'edge_concave', 0.2653, 0.2909),
  ('wall', 2, 'edge_convex', 0.0002817, 0.03),
  ('wall', 2, 'edge_free', 0.003271, 0.03425),
  ('wall', 2, 'edge_free_top', -0.00371, 0.03),
  ('wall', 2, 'edge_unseen', 0.03948, 0.1507),
  ('wall', 2, 'headroom', 1.072, 18.76),
  ('wall', 2, 'height', 0.713, 0.3295),
  ('wall', 2, 'lift', 0.05978, 0.8817),
  ('wall', 2, 'rectangularity', 0.737, 0.2304),
  ('wall', 2, 'spread_length', -0.2891, 0.7926),
  ('wall', 2, 'spread_width', -1.147, 0.6569),
  ('wall', 2, 'standoff', 0.3403, 0.6128),
  ('wall', 2, 'tilt_deg', 89.08, 0.4527),
  ('wall', 2, 'wall_offset', -1.36, 1.096),
  ('wall', 2, 'width', -1.012, 0.7661),
  ('wall', 2, 'z_max', 1.251, 0.6748),
  ('wall', 2, 'z_min', -0.02654, 0.02618);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.1439, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'aspect', 0.7841, 0.4505),
  ('wall', 3, 'behind', -0.002719, 0.03),
  ('wall', 3, 'corner_offset', 0.2567, 0.1552),
  ('wall', 3, 'edge_concave', 0.3161, 0.1626),
  ('wall', 3, 'edge_convex', 0.002772, 0.03),
  ('wall', 3, 'edge_free', -0.002959, 0.03),
  ('wall', 3, 'edge_free_top', -0.017, 0.03),
  ('wall', 3, 'edge_unseen', 0.416, 0.1047),
  ('wall', 3, 'headroom', -0.009784, 0.03),
  ('wall', 3, 'height', 1.405, 0.2302),
  ('wall', 3, 'lift', 0.0374, 0.2083),
  ('wall', 3, 'rectangularity', 0.6694, 0.07292),
  ('wall', 3, 'spread_length', 0.6663, 0.3031),
  ('wall', 3, 'spread_width', -0.1663, 0.2102),
  ('wall', 3, 'standoff', 1.159, 0.1953),
  ('wall', 3, 'tilt_deg', 90.48, 0.4502),
  ('wall', 3, 'wall_offset', 3.432, 2.816),
  ('wall', 3, 'width', 0.2105, 0.5234),
  ('wall', 3, 'z_max', 2.432, 0.7118),
  ('wall', 3, 'z_min', 0.5032, 0.137);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.02767, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'aspect', 0.4343, 0.2065),
  ('wall', 4, 'behind', 0.1744, 0.145),
  ('wall', 4, 'corner_offset', 1.766, 1.029),
  ('wall', 4, 'edge_concave', 0.5454, 0.2003),
  ('wall', 4, 'edge_convex', 0.047, 0.06365),
  ('wall', 4, 'edge_free', 0.1385, 0.1128),
  ('wall', 4, 'edge_free_top', 0.07474, 0.1105),
  ('wall', 4, 'edge_unseen', 0.1156, 0.137),
  ('wall', 4, 'headroom', -0.1792, 0.3587),
  ('wall', 4, 'height', 1.464, 0.3375),
  ('wall', 4, 'lift', 0.1492, 0.1048),
  ('wall', 4, 'rectangularity', 0.4777, 0.0935),
  ('wall', 4, 'spread_length', 1.247, 0.2609),
  ('wall', 4, 'spread_width', 0.7979, 0.1806),
  ('wall', 4, 'standoff', 0.5001, 0.1387),
  ('wall', 4, 'tilt_deg', 90.02, 0.4518),
  ('wall', 4, 'wall_offset', 4.051, 3.495),
  ('wall', 4, 'width', 1.027, 0.08175),
  ('wall', 4, 'z_max', 2.779, 0.4215),
  ('wall', 4, 'z_min', -0.01765, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.08281, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'aspect', 1.192, 0.4326),
  ('wall', 5, 'behind', 0.09088, 0.1954),
  ('wall', 5, 'corner_offset', 1.902, 0.8266),
  ('wall', 5, 'edge_concave', 0.07662, 0.1556),
  ('wall', 5, 'edge_convex', 0.1319, 0.1723),
  ('wall', 5, 'edge_free', 0.6509, 0.328),
  ('wall', 5, 'edge_free_top', 0.1329, 0.1666),
  ('wall', 5, 'edge_unseen', 0.4386, 0.2627),
  ('wall', 5, 'headroom', 0.5201, 0.1259),
  ('wall', 5, 'height', 1.246, 0.1624),
  ('wall', 5, 'lift', -0.1079, 0.1405),
  ('wall', 5, 'rectangularity', 0.8003, 0.2173),
  ('wall', 5, 'spread_length', -0.304, 0.2381),
  ('wall', 5, 'spread_width', -0.9576, 0.3268),
  ('wall', 5, 'standoff', 0.7378, 0.4527),
  ('wall', 5, 'tilt_deg', 89.94, 0.4513),
  ('wall', 5, 'wall_offset', 3.789, 2.031),
  ('wall', 5, 'width', -0.6041, 0.4741),
  ('wall', 5, 'z_max', 2.091, 0.4959),
  ('wall', 5, 'z_min', 0.3911, 0.2878);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.138, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'aspect', 1.384, 0.3755),
  ('wall', 6, 'behind', 0.2824, 0.2125),
  ('wall', 6, 'corner_offset', 1.348, 0.7608),
  ('wall', 6, 'edge_concave', 0.3509, 0.272),
  ('wall', 6, 'edge_convex', 0.0356, 0.07591),
  ('wall', 6, 'edge_free', 0.3858, 0.3529),
  ('wall', 6, 'edge_free_top', 0.07062, 0.0998),
  ('wall', 6, 'edge_unseen', -0.001362, 0.03),
  ('wall', 6, 'headroom', 0.002914, 0.0385),
  ('wall', 6, 'height', 1.555, 0.16),
  ('wall', 6, 'lift', 0.009164, 0.131),
  ('wall', 6, 'rectangularity', 0.8702, 0.06823),
  ('wall', 6, 'spread_length', 0.8057, 0.2563),
  ('wall', 6, 'spread_width', -0.7558, 0.3301),
  ('wall', 6, 'standoff', 0.8612, 0.4724),
  ('wall', 6, 'tilt_deg', 90.15, 0.45),
  ('wall', 6, 'wall_offset', 1.126, 0.3625),
  ('wall', 6, 'width', -0.2556, 0.3294),
  ('wall', 6, 'z_max', 2.767, 0.2141),
  ('wall', 6, 'z_min', 0.2594, 0.406);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.1097, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'aspect', 0.6428, 0.337),
  ('wall', 7, 'behind', 0.1199, 0.22),
  ('wall', 7, 'corner_offset', 0.7853, 0.9408),
  ('wall', 7, 'edge_concave', 0.3257, 0.2428),
  ('wall', 7, 'edge_convex', 0.1448, 0.2168),
  ('wall', 7, 'edge_free', 0.07642, 0.1212),
  ('wall', 7, 'edge_free_top', 0.001589, 0.03),
  ('wall', 7, 'edge_unseen', 0.2129, 0.2505),
  ('wall', 7, 'headroom', -0.004826, 0.03),
  ('wall', 7, 'height', 2.444, 0.1823),
  ('wall', 7, 'lift', 0.1537, 0.2511),
  ('wall', 7, 'rectangularity', 0.6942, 0.1356),
  ('wall', 7, 'spread_length', -0.1223, 0.6841),
  ('wall', 7, 'spread_width', -0.683, 0.4299),
  ('wall', 7, 'standoff', 0.2041, 0.2191),
  ('wall', 7, 'tilt_deg', 89.75, 0.4572),
  ('wall', 7, 'wall_offset', 2.607, 2.432),
  ('wall', 7, 'width', -0.5232, 0.5244),
  ('wall', 7, 'z_max', 3.08, 0.2881),
  ('wall', 7, 'z_min', 1.701, 0.4613);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.05225, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'aspect', 0.5694, 0.4513),
  ('wall', 8, 'behind', 0.1417, 0.1632),
  ('wall', 8, 'corner_offset', 2.524, 2.136),
  ('wall', 8, 'edge_concave', 0.3715, 0.085),
  ('wall', 8, 'edge_convex', 0.1367, 0.1464),
  ('wall', 8, 'edge_free', 0.2044, 0.146),
  ('wall', 8, 'edge_free_top', 0.3493, 0.3053),
  ('wall', 8, 'edge_unseen', 0.2755, 0.08476),
  ('wall', 8, 'headroom', -0.4899, 0.1861),
  ('wall', 8, 'height', 1.404, 0.2682),
  ('wall', 8, 'lift', -0.02866, 0.06997),
  ('wall', 8, 'rectangularity', 0.4996, 0.09887),
  ('wall', 8, 'spread_length', 0.7039, 0.1504),
  ('wall', 8, 'spread_width', -0.02239, 0.4107),
  ('wall', 8, 'standoff', 0.8437, 0.4241),
  ('wall', 8, 'tilt_deg', 90.03, 0.45),
  ('wall', 8, 'wall_offset', 3.825, 2.892),
  ('wall', 8, 'width', 0.4399, 0.3524),
  ('wall', 8, 'z_max', 2.783, 0.1929),
  ('wall', 8, 'z_min', 0.2376, 0.301);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.03642, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'aspect', 1.025, 0.2703),
  ('wall', 9, 'behind', 0.3557, 0.1484),
  ('wall', 9, 'corner_offset', 1.147, 0.1973),
  ('wall', 9, 'edge_concave', 0.3131, 0.2917),
  ('wall', 9, 'edge_convex', 0.04053, 0.07043),
  ('wall', 9, 'edge_free', 0.2004, 0.1305),
  ('wall', 9, 'edge_free_top', 0.3602, 0.3035),
  ('wall', 9, 'edge_unseen', 0.1083, 0.1652),
  ('wall', 9, 'headroom', 2.164, 0.5258),
  ('wall', 9, 'height', 0.8392, 0.7661),
  ('wall', 9, 'lift', 0.2658, 0.5565),
  ('wall', 9, 'rectangularity', 0.6915, 0.07119),
  ('wall', 9, 'spread_length', -0.2928, 0.7338),
  ('wall', 9, 'spread_width', -1.357, 0.331),
  ('wall', 9, 'standoff', 0.2884, 0.3826),
  ('wall', 9, 'tilt_deg', 89.64, 1.907),
  ('wall', 9, 'wall_offset', 1.744, 1.912),
  ('wall', 9, 'width', -0.9658, 0.72),
  ('wall', 9, 'z_max', 1.357, 0.8177),
  ('wall', 9, 'z_min', 0.02246, 0.3716);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.0681, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'aspect', 0.1482, 0.1456),
  ('wall', 10, 'behind', 0.3166, 0.193),
  ('wall', 10, 'corner_offset', 1.913, 0.916),
  ('wall', 10, 'edge_concave', 0.1203, 0.1219),
  ('wall', 10, 'edge_convex', 0.01056, 0.03027),
  ('wall', 10, 'edge_free', 0.4742, 0.1853),
  ('wall', 10, 'edge_free_top', 0.9563, 0.05619),
  ('wall', 10, 'edge_unseen', 0.1263, 0.114),
  ('wall', 10, 'headroom', 1.318, 0.4058),
  ('wall', 10, 'height', 0.9387, 0.2294),
  ('wall', 10, 'lift', 0.1631, 0.09258),
  ('wall', 10, 'rectangularity', 0.795, 0.09579),
  ('wall', 10, 'spread_length', 0.4738, 0.1015),
  ('wall', 10, 'spread_width', 0.06254, 0.3396),
  ('wall', 10, 'standoff', 1.013, 0.1817),
  ('wall', 10, 'tilt_deg', 89.69, 0.4969),
  ('wall', 10, 'wall_offset', 3.073, 0.9992),
  ('wall', 10, 'width', 0.3748, 0.3221),
  ('wall', 10, 'z_max', 1.425, 0.4003),
  ('wall', 10, 'z_min', -0.04105, 0.1207);

-- table: 770 examples
UPDATE object_class SET prior = 0.04074 WHERE name = 'table';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.08864, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'aspect', 0.4772, 0.1762),
  ('table', 1, 'behind', 0.6209, 0.06313),
  ('table', 1, 'corner_offset', 0.625, 0.2091),
  ('table', 1, 'edge_concave', 0.2793, 0.1341),
  ('table', 1, 'edge_convex', 0.06829, 0.08299),
  ('table', 1, 'edge_free', 0.4209, 0.2076),
  ('table', 1, 'edge_free_top', -0.0009047, 0.3143),
  ('table', 1, 'edge_unseen', 0.08381, 0.09841),
  ('table', 1, 'headroom', 1.974, 0.2246),
  ('table', 1, 'height', 0.6903, 0.02253),
  ('table', 1, 'lift', -0.001708, 0.3344),
  ('table', 1, 'rectangularity', 0.6955, 0.1076),
  ('table', 1, 'spread_length', 0.2643, 0.245),
  ('table', 1, 'spread_width', -0.3311, 0.1141),
  ('table', 1, 'standoff', -0.0002442, 0.3163),
  ('table', 1, 'tilt_deg', 0.1767, 0.45),
  ('table', 1, 'wall_offset', -0.003378, 0.3172),
  ('table', 1, 'width', -0.1596, 0.09814),
  ('table', 1, 'z_max', 0.6902, 0.0225),
  ('table', 1, 'z_min', 0.6864, 0.02309);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.05065, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'aspect', 0.4771, 0.1668),
  ('table', 2, 'behind', 0.7166, 0.0478),
  ('table', 2, 'corner_offset', 0.61, 0.4146),
  ('table', 2, 'edge_concave', 0.269, 0.09016),
  ('table', 2, 'edge_convex', 0.03977, 0.0638),
  ('table', 2, 'edge_free', 0.3744, 0.2436),
  ('table', 2, 'edge_free_top', -0.001747, 0.3138),
  ('table', 2, 'edge_unseen', 0.006617, 0.03384),
  ('table', 2, 'headroom', 1.976, 0.3631),
  ('table', 2, 'height', 0.7455, 0.02298),
  ('table', 2, 'lift', -0.006919, 0.339),
  ('table', 2, 'rectangularity', 0.7211, 0.07309),
  ('table', 2, 'spread_length', 0.2385, 0.1869),
  ('table', 2, 'spread_width', -0.3066, 0.09132),
  ('table', 2, 'standoff', -2.487e-05, 0.3164),
  ('table', 2, 'tilt_deg', -0.06408, 0.45),
  ('table', 2, 'wall_offset', -0.002424, 0.3166),
  ('table', 2, 'width', -0.1295, 0.09764),
  ('table', 2, 'z_max', 0.7439, 0.02253),
  ('table', 2, 'z_min', 0.7452, 0.0226);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.129, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'aspect', 0.5651, 0.2556),
  ('table', 3, 'behind', 0.4625, 0.1992),
  ('table', 3, 'corner_offset', 0.797, 0.2013),
  ('table', 3, 'edge_concave', 0.2051, 0.1183),
  ('table', 3, 'edge_convex', 0.006384, 0.03),
  ('table', 3, 'edge_free', 0.4547, 0.2692),
  ('table', 3, 'edge_free_top', -0.003477, 0.3121),
  ('table', 3, 'edge_unseen', 0.2189, 0.1501),
  ('table', 3, 'headroom', 1.847, 0.1243),
  ('table', 3, 'height', 0.7581, 0.0225),
  ('table', 3, 'lift', -0.01825, 0.4151),
  ('table', 3, 'rectangularity', 0.6776, 0.1575),
  ('table', 3, 'spread_length', 0.2498, 0.1847),
  ('table', 3, 'spread_width', -0.3763, 0.1057),
  ('table', 3, 'standoff', -0.0005132, 0.3176),
  ('table', 3, 'tilt_deg', 0.09261, 0.45),
  ('table', 3, 'wall_offset', -0.005485, 0.3209),
  ('table', 3, 'width', -0.1779, 0.1183),
  ('table', 3, 'z_max', 0.7602, 0.0225),
  ('table', 3, 'z_min', 0.7571, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.1194, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'aspect', 0.4543, 0.1951),
  ('table', 4, 'behind', 0.3383, 0.08061),
  ('table', 4, 'corner_offset', 1.555, 0.6167),
  ('table', 4, 'edge_concave', 0.04819, 0.05293),
  ('table', 4, 'edge_convex', 0.06691, 0.09671),
  ('table', 4, 'edge_free', 0.718, 0.1763),
  ('table', 4, 'edge_free_top', -0.003172, 0.3113),
  ('table', 4, 'edge_unseen', 0.004491, 0.03004),
  ('table', 4, 'headroom', 2.129, 0.3237),
  ('table', 4, 'height', 0.7098, 0.03213),
  ('table', 4, 'lift', -0.01134, 0.4253),
  ('table', 4, 'rectangularity', 0.7986, 0.1071),
  ('table', 4, 'spread_length', 0.02385, 0.3231),
  ('table', 4, 'spread_width', -0.5087, 0.2878),
  ('table', 4, 'standoff', -0.001359, 0.317),
  ('table', 4, 'tilt_deg', 0.1212, 0.45),
  ('table', 4, 'wall_offset', -0.01346, 0.327),
  ('table', 4, 'width', -0.3791, 0.1978),
  ('table', 4, 'z_max', 0.7112, 0.03239),
  ('table', 4, 'z_min', 0.7092, 0.03361);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.113, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'aspect', 0.8627, 0.2087),
  ('table', 5, 'behind', 0.2639, 0.2574),
  ('table', 5, 'corner_offset', 1.09, 0.3071),
  ('table', 5, 'edge_concave', 0.1439, 0.1668),
  ('table', 5, 'edge_convex', 0.04156, 0.08202),
  ('table', 5, 'edge_free', 0.501, 0.3044),
  ('table', 5, 'edge_free_top', -0.006473, 0.3071),
  ('table', 5, 'edge_unseen', 0.406, 0.104),
  ('table', 5, 'headroom', 2.233, 0.2181),
  ('table', 5, 'height', 0.7306, 0.05309),
  ('table', 5, 'lift', -0.04368, 1.035),
  ('table', 5, 'rectangularity', 0.6151, 0.06593),
  ('table', 5, 'spread_length', -0.3728, 0.3338),
  ('table', 5, 'spread_width', -1.182, 0.2819),
  ('table', 5, 'standoff', -0.002933, 0.3215),
  ('table', 5, 'tilt_deg', 0.7324, 1.093),
  ('table', 5, 'wall_offset', -0.02134, 0.3328),
  ('table', 5, 'width', -0.9593, 0.3643),
  ('table', 5, 'z_max', 0.7263, 0.05314),
  ('table', 5, 'z_min', 0.7308, 0.05136);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.1812, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'aspect', 0.5306, 0.3058),
  ('table', 6, 'behind', 0.2757, 0.206),
  ('table', 6, 'corner_offset', 1.207, 0.5064),
  ('table', 6, 'edge_concave', 0.1174, 0.1507),
  ('table', 6, 'edge_convex', 0.002029, 0.03),
  ('table', 6, 'edge_free', 0.4173, 0.2233),
  ('table', 6, 'edge_free_top', -0.009495, 0.3056),
  ('table', 6, 'edge_unseen', 0.1705, 0.1773),
  ('table', 6, 'headroom', 2.439, 0.5115),
  ('table', 6, 'height', 0.6522, 0.03178),
  ('table', 6, 'lift', -0.02341, 0.4184),
  ('table', 6, 'rectangularity', 0.6938, 0.1419),
  ('table', 6, 'spread_length', 0.09601, 0.2735),
  ('table', 6, 'spread_width', -0.4646, 0.2004),
  ('table', 6, 'standoff', -0.001925, 0.3182),
  ('table', 6, 'tilt_deg', 0.5364, 0.5786),
  ('table', 6, 'wall_offset', -0.01928, 0.3349),
  ('table', 6, 'width', -0.2889, 0.1655),
  ('table', 6, 'z_max', 0.6593, 0.02939),
  ('table', 6, 'z_min', 0.6445, 0.03852);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.1084, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'aspect', 0.4556, 0.1481),
  ('table', 7, 'behind', 0.4343, 0.1476),
  ('table', 7, 'corner_offset', 1.308, 0.4336),
  ('table', 7, 'edge_concave', 0.157, 0.1535),
  ('table', 7, 'edge_convex', 0.08665, 0.09276),
  ('table', 7, 'edge_free', 0.4013, 0.1534),
  ('table', 7, 'edge_free_top', -0.003516, 0.3115),
  ('table', 7, 'edge_unseen', 0.1236, 0.1137),
  ('table', 7, 'headroom', 1.774, 0.6728),
  ('table', 7, 'height', 0.8222, 0.02614),
  ('table', 7, 'lift', -0.04234, 0.4236),
  ('table', 7, 'rectangularity', 0.7476, 0.1063),
  ('table', 7, 'spread_length', 0.09742, 0.2692),
  ('table', 7, 'spread_width', -0.3906, 0.2092),
  ('table', 7, 'standoff', -0.0007998, 0.3173),
  ('table', 7, 'tilt_deg', 0.5244, 0.609),
  ('table', 7, 'wall_offset', -0.009765, 0.3212),
  ('table', 7, 'width', -0.2218, 0.1884),
  ('table', 7, 'z_max', 0.8344, 0.02253),
  ('table', 7, 'z_min', 0.8142, 0.03035);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.1098, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'aspect', 0.5546, 0.3055),
  ('table', 8, 'behind', 0.2644, 0.1456),
  ('table', 8, 'corner_offset', 0.4396, 0.7835),
  ('table', 8, 'edge_concave', 0.2134, 0.1971),
  ('table', 8, 'edge_convex', 0.04724, 0.07624),
  ('table', 8, 'edge_free', 0.2448, 0.2358),
  ('table', 8, 'edge_free_top', -0.007312, 0.3114),
  ('table', 8, 'edge_unseen', 0.1412, 0.1181),
  ('table', 8, 'headroom', 2.176, 0.2447),
  ('table', 8, 'height', 1.032, 0.08667),
  ('table', 8, 'lift', -0.1679, 0.1528),
  ('table', 8, 'rectangularity', 0.5889, 0.1601),
  ('table', 8, 'spread_length', 0.1881, 0.4047),
  ('table', 8, 'spread_width', -0.3113, 0.2116),
  ('table', 8, 'standoff', -0.003034, 0.318),
  ('table', 8, 'tilt_deg', 0.04725, 0.45),
  ('table', 8, 'wall_offset', -0.02158, 0.3268),
  ('table', 8, 'width', -0.1498, 0.121),
  ('table', 8, 'z_max', 1.032, 0.08076),
  ('table', 8, 'z_min', 1.029, 0.09311);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.01268, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'aspect', 0.3058, 0.1745),
  ('table', 9, 'behind', 0.5908, 0.1071),
  ('table', 9, 'corner_offset', 1.091, 0.6747),
  ('table', 9, 'edge_concave', 0.1885, 0.1185),
  ('table', 9, 'edge_convex', 0.1043, 0.103),
  ('table', 9, 'edge_free', 0.4596, 0.1649),
  ('table', 9, 'edge_free_top', -0.00124, 0.3146),
  ('table', 9, 'edge_unseen', 0.01277, 0.03),
  ('table', 9, 'headroom', 1.662, 0.7081),
  ('table', 9, 'height', 0.7286, 0.02785),
  ('table', 9, 'lift', -0.0001433, 0.3202),
  ('table', 9, 'rectangularity', 0.6401, 0.1101),
  ('table', 9, 'spread_length', 0.3669, 0.09513),
  ('table', 9, 'spread_width', -0.03191, 0.2148),
  ('table', 9, 'standoff', -3.685e-05, 0.3163),
  ('table', 9, 'tilt_deg', 0.1893, 0.4502),
  ('table', 9, 'wall_offset', -0.001565, 0.316),
  ('table', 9, 'width', 0.1633, 0.1486),
  ('table', 9, 'z_max', 0.7314, 0.0293),
  ('table', 9, 'z_min', 0.7255, 0.03048);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.03729, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'aspect', 0.5278, 0.1584),
  ('table', 10, 'behind', 0.2286, 0.1443),
  ('table', 10, 'corner_offset', 0.6719, 0.09301),
  ('table', 10, 'edge_concave', 0.1221, 0.1133),
  ('table', 10, 'edge_convex', 0.02183, 0.03376),
  ('table', 10, 'edge_free', 0.2779, 0.1275),
  ('table', 10, 'edge_free_top', -0.002013, 0.3138),
  ('table', 10, 'edge_unseen', 0.196, 0.1068),
  ('table', 10, 'headroom', 1.99, 0.1116),
  ('table', 10, 'height', 0.03115, 0.04061),
  ('table', 10, 'lift', -0.0001976, 0.3165),
  ('table', 10, 'rectangularity', 0.6093, 0.07886),
  ('table', 10, 'spread_length', -0.06813, 0.3896),
  ('table', 10, 'spread_width', -0.6081, 0.3219),
  ('table', 10, 'standoff', -7.815e-05, 0.3162),
  ('table', 10, 'tilt_deg', 1.341, 0.4685),
  ('table', 10, 'wall_offset', -0.003368, 0.3168),
  ('table', 10, 'width', -0.3036, 0.2423),
  ('table', 10, 'z_max', 0.02462, 0.02434),
  ('table', 10, 'z_min', 0.01395, 0.03069);

-- flat_screen: 604 examples
UPDATE object_class SET prior = 0.03031 WHERE name = 'flat_screen';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'lift', 0.03697, 0.06344)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.1323, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'aspect', 0.3379, 0.09058),
  ('flat_screen', 1, 'behind', 0.5429, 0.142),
  ('flat_screen', 1, 'corner_offset', 1.222, 0.7754),
  ('flat_screen', 1, 'edge_concave', 0.3235, 0.1118),
  ('flat_screen', 1, 'edge_convex', -0.0002352, 0.03),
  ('flat_screen', 1, 'edge_free', 0.7185, 0.06696),
  ('flat_screen', 1, 'edge_free_top', 0.9992, 0.03),
  ('flat_screen', 1, 'edge_unseen', 0.006431, 0.03052),
  ('flat_screen', 1, 'headroom', 1.649, 0.258),
  ('flat_screen', 1, 'height', 1.003, 0.04496),
  ('flat_screen', 1, 'lift', -0.002827, 0.02502),
  ('flat_screen', 1, 'rectangularity', 0.7809, 0.07246),
  ('flat_screen', 1, 'spread_length', -0.6604, 0.09707),
  ('flat_screen', 1, 'spread_width', -1.109, 0.08067),
  ('flat_screen', 1, 'standoff', 0.6945, 0.3794),
  ('flat_screen', 1, 'tilt_deg', 85.76, 2.226),
  ('flat_screen', 1, 'wall_offset', 1.737, 0.4952),
  ('flat_screen', 1, 'width', -0.8355, 0.09541),
  ('flat_screen', 1, 'z_max', 1.121, 0.06063),
  ('flat_screen', 1, 'z_min', 0.7025, 0.04891);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.1982, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'aspect', 0.3168, 0.2403),
  ('flat_screen', 2, 'behind', 0.6397, 0.0705),
  ('flat_screen', 2, 'corner_offset', 1.849, 0.5942),
  ('flat_screen', 2, 'edge_concave', 0.3383, 0.106),
  ('flat_screen', 2, 'edge_convex', -0.0003138, 0.03001),
  ('flat_screen', 2, 'edge_free', 0.7138, 0.08978),
  ('flat_screen', 2, 'edge_free_top', 0.9959, 0.03006),
  ('flat_screen', 2, 'edge_unseen', 0.006071, 0.03587),
  ('flat_screen', 2, 'headroom', 1.651, 0.3566),
  ('flat_screen', 2, 'height', 0.9668, 0.0466),
  ('flat_screen', 2, 'lift', -0.00851, 0.025),
  ('flat_screen', 2, 'rectangularity', 0.7725, 0.09512),
  ('flat_screen', 2, 'spread_length', -0.8031, 0.153),
  ('flat_screen', 2, 'spread_width', -1.185, 0.08359),
  ('flat_screen', 2, 'standoff', 0.2817, 0.03326),
  ('flat_screen', 2, 'tilt_deg', 84.83, 1.758),
  ('flat_screen', 2, 'wall_offset', 0.3568, 0.06348),
  ('flat_screen', 2, 'width', -0.9603, 0.05843),
  ('flat_screen', 2, 'z_max', 1.078, 0.04128),
  ('flat_screen', 2, 'z_min', 0.6854, 0.03306);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.0724, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'aspect', 0.3834, 0.1652),
  ('flat_screen', 3, 'behind', 0.5972, 0.07592),
  ('flat_screen', 3, 'corner_offset', 1.652, 0.7367),
  ('flat_screen', 3, 'edge_concave', 0.007219, 0.0347),
  ('flat_screen', 3, 'edge_convex', -1.72e-05, 0.0302),
  ('flat_screen', 3, 'edge_free', 0.9699, 0.07531),
  ('flat_screen', 3, 'edge_free_top', 0.9968, 0.03477),
  ('flat_screen', 3, 'edge_unseen', 0.05, 0.0995),
  ('flat_screen', 3, 'headroom', 1.629, 0.2744),
  ('flat_screen', 3, 'height', 1.024, 0.05535),
  ('flat_screen', 3, 'lift', 0.114, 0.025),
  ('flat_screen', 3, 'rectangularity', 0.9186, 0.054),
  ('flat_screen', 3, 'spread_length', -0.9381, 0.1188),
  ('flat_screen', 3, 'spread_width', -1.303, 0.06252),
  ('flat_screen', 3, 'standoff', 0.386, 0.09914),
  ('flat_screen', 3, 'tilt_deg', 84.88, 2.931),
  ('flat_screen', 3, 'wall_offset', 0.9639, 0.9684),
  ('flat_screen', 3, 'width', -1.261, 0.08236),
  ('flat_screen', 3, 'z_max', 1.153, 0.06569),
  ('flat_screen', 3, 'z_min', 0.8557, 0.04957);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.1354, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'aspect', 0.4868, 0.1722),
  ('flat_screen', 4, 'behind', 0.6464, 0.09185),
  ('flat_screen', 4, 'corner_offset', 1.363, 0.7495),
  ('flat_screen', 4, 'edge_concave', 0.4075, 0.1358),
  ('flat_screen', 4, 'edge_convex', 0.004358, 0.03015),
  ('flat_screen', 4, 'edge_free', 0.6195, 0.106),
  ('flat_screen', 4, 'edge_free_top', 0.8212, 0.123),
  ('flat_screen', 4, 'edge_unseen', 0.0364, 0.06739),
  ('flat_screen', 4, 'headroom', 1.577, 0.4162),
  ('flat_screen', 4, 'height', 1.003, 0.06991),
  ('flat_screen', 4, 'lift', -0.003113, 0.02507),
  ('flat_screen', 4, 'rectangularity', 0.6567, 0.03868),
  ('flat_screen', 4, 'spread_length', -0.5653, 0.2813),
  ('flat_screen', 4, 'spread_width', -1.121, 0.112),
  ('flat_screen', 4, 'standoff', 0.7666, 0.2909),
  ('flat_screen', 4, 'tilt_deg', 82.96, 1.981),
  ('flat_screen', 4, 'wall_offset', 1.648, 0.867),
  ('flat_screen', 4, 'width', -0.6118, 0.18),
  ('flat_screen', 4, 'z_max', 1.218, 0.1427),
  ('flat_screen', 4, 'z_min', 0.6988, 0.05197);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.0812, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'aspect', 0.499, 0.04449),
  ('flat_screen', 5, 'behind', 0.528, 0.1206),
  ('flat_screen', 5, 'corner_offset', 1.387, 0.8042),
  ('flat_screen', 5, 'edge_concave', 0.007116, 0.03),
  ('flat_screen', 5, 'edge_convex', 0.0003709, 0.03),
  ('flat_screen', 5, 'edge_free', 0.9586, 0.07019),
  ('flat_screen', 5, 'edge_free_top', 0.9981, 0.03),
  ('flat_screen', 5, 'edge_unseen', 0.03267, 0.0675),
  ('flat_screen', 5, 'headroom', 1.682, 0.3628),
  ('flat_screen', 5, 'height', 1.029, 0.05628),
  ('flat_screen', 5, 'lift', 0.1141, 0.025),
  ('flat_screen', 5, 'rectangularity', 0.9263, 0.03667),
  ('flat_screen', 5, 'spread_length', -0.6311, 0.05966),
  ('flat_screen', 5, 'spread_width', -1.123, 0.07332),
  ('flat_screen', 5, 'standoff', 0.5655, 0.3037),
  ('flat_screen', 5, 'tilt_deg', 85.31, 3.042),
  ('flat_screen', 5, 'wall_offset', 1.016, 0.9805),
  ('flat_screen', 5, 'width', -1.079, 0.06811),
  ('flat_screen', 5, 'z_max', 1.183, 0.0564),
  ('flat_screen', 5, 'z_min', 0.8387, 0.05567);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.05693, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'aspect', 0.4171, 0.1801),
  ('flat_screen', 6, 'behind', 0.4479, 0.09636),
  ('flat_screen', 6, 'corner_offset', 1.339, 2.04),
  ('flat_screen', 6, 'edge_concave', 0.006713, 0.04169),
  ('flat_screen', 6, 'edge_convex', -0.0002267, 0.03712),
  ('flat_screen', 6, 'edge_free', 0.8929, 0.1369),
  ('flat_screen', 6, 'edge_free_top', 0.9971, 0.03114),
  ('flat_screen', 6, 'edge_unseen', 0.1558, 0.1875),
  ('flat_screen', 6, 'headroom', 1.354, 0.5024),
  ('flat_screen', 6, 'height', 1.233, 0.156),
  ('flat_screen', 6, 'lift', 0.1208, 0.05483),
  ('flat_screen', 6, 'rectangularity', 0.8671, 0.1401),
  ('flat_screen', 6, 'spread_length', -0.7033, 0.141),
  ('flat_screen', 6, 'spread_width', -1.269, 0.1829),
  ('flat_screen', 6, 'standoff', 0.3673, 0.09605),
  ('flat_screen', 6, 'tilt_deg', 81.77, 1.276),
  ('flat_screen', 6, 'wall_offset', 1.682, 2.236),
  ('flat_screen', 6, 'width', -1.109, 0.1464),
  ('flat_screen', 6, 'z_max', 1.389, 0.1387),
  ('flat_screen', 6, 'z_min', 1.142, 0.05735);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.1245, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'aspect', 0.3663, 0.2269),
  ('flat_screen', 7, 'behind', 0.6397, 0.1138),
  ('flat_screen', 7, 'corner_offset', 1.795, 0.5085),
  ('flat_screen', 7, 'edge_concave', 0.1633, 0.1008),
  ('flat_screen', 7, 'edge_convex', 0.02866, 0.07027),
  ('flat_screen', 7, 'edge_free', 0.771, 0.1525),
  ('flat_screen', 7, 'edge_free_top', 0.997, 0.03045),
  ('flat_screen', 7, 'edge_unseen', 0.1684, 0.1293),
  ('flat_screen', 7, 'headroom', 1.407, 0.2729),
  ('flat_screen', 7, 'height', 1.059, 0.03469),
  ('flat_screen', 7, 'lift', 0.01251, 0.05424),
  ('flat_screen', 7, 'rectangularity', 0.735, 0.1125),
  ('flat_screen', 7, 'spread_length', -0.8385, 0.1692),
  ('flat_screen', 7, 'spread_width', -1.226, 0.1104),
  ('flat_screen', 7, 'standoff', 0.3272, 0.08193),
  ('flat_screen', 7, 'tilt_deg', 84.27, 1.862),
  ('flat_screen', 7, 'wall_offset', 0.3933, 0.07258),
  ('flat_screen', 7, 'width', -0.9439, 0.1248),
  ('flat_screen', 7, 'z_max', 1.19, 0.04096),
  ('flat_screen', 7, 'z_min', 0.7771, 0.04829);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.04434, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'aspect', 0.8009, 0.2236),
  ('flat_screen', 8, 'behind', 0.4488, 0.2417),
  ('flat_screen', 8, 'corner_offset', 1.272, 0.4332),
  ('flat_screen', 8, 'edge_concave', 0.09275, 0.09533),
  ('flat_screen', 8, 'edge_convex', 0.004945, 0.03009),
  ('flat_screen', 8, 'edge_free', 0.8057, 0.2712),
  ('flat_screen', 8, 'edge_free_top', 0.9745, 0.1346),
  ('flat_screen', 8, 'edge_unseen', 0.3163, 0.08443),
  ('flat_screen', 8, 'headroom', 1.528, 0.2029),
  ('flat_screen', 8, 'height', 0.9976, 0.09681),
  ('flat_screen', 8, 'lift', 0.1338, 0.04246),
  ('flat_screen', 8, 'rectangularity', 0.7434, 0.07345),
  ('flat_screen', 8, 'spread_length', -1.076, 0.2977),
  ('flat_screen', 8, 'spread_width', -1.85, 0.2417),
  ('flat_screen', 8, 'standoff', 0.3342, 0.05858),
  ('flat_screen', 8, 'tilt_deg', 84.44, 2.757),
  ('flat_screen', 8, 'wall_offset', 1.394, 1.949),
  ('flat_screen', 8, 'width', -1.64, 0.1332),
  ('flat_screen', 8, 'z_max', 1.098, 0.06913),
  ('flat_screen', 8, 'z_min', 0.8418, 0.06336);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.08632, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'aspect', 0.343, 0.2561),
  ('flat_screen', 9, 'behind', 0.5176, 0.07437),
  ('flat_screen', 9, 'corner_offset', 1.926, 0.9069),
  ('flat_screen', 9, 'edge_concave', 0.2933, 0.09552),
  ('flat_screen', 9, 'edge_convex', -0.0003962, 0.03191),
  ('flat_screen', 9, 'edge_free', 0.7405, 0.1241),
  ('flat_screen', 9, 'edge_free_top', 0.9892, 0.03574),
  ('flat_screen', 9, 'edge_unseen', 0.06043, 0.0777),
  ('flat_screen', 9, 'headroom', 1.553, 0.4844),
  ('flat_screen', 9, 'height', 1.232, 0.09667),
  ('flat_screen', 9, 'lift', -0.001681, 0.025),
  ('flat_screen', 9, 'rectangularity', 0.752, 0.08159),
  ('flat_screen', 9, 'spread_length', -0.6767, 0.1425),
  ('flat_screen', 9, 'spread_width', -1.109, 0.07128),
  ('flat_screen', 9, 'standoff', 0.3837, 0.06663),
  ('flat_screen', 9, 'tilt_deg', 83.55, 2.476),
  ('flat_screen', 9, 'wall_offset', 0.7504, 0.6157),
  ('flat_screen', 9, 'width', -0.8625, 0.09784),
  ('flat_screen', 9, 'z_max', 1.392, 0.07772),
  ('flat_screen', 9, 'z_min', 0.9714, 0.1031);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.01831, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'aspect', 0.6163, 0.196),
  ('flat_screen', 10, 'behind', 0.6023, 0.1209),
  ('flat_screen', 10, 'corner_offset', 1.556, 0.2729),
  ('flat_screen', 10, 'edge_concave', 0.08242, 0.07374),
  ('flat_screen', 10, 'edge_convex', 0.0002511, 0.03),
  ('flat_screen', 10, 'edge_free', 0.6901, 0.1292),
  ('flat_screen', 10, 'edge_free_top', 0.9976, 0.03),
  ('flat_screen', 10, 'edge_unseen', 0.007212, 0.03),
  ('flat_screen', 10, 'headroom', 1.584, 0.08145),
  ('flat_screen', 10, 'height', 0.3491, 0.08818),
  ('flat_screen', 10, 'lift', 0.03832, 0.025),
  ('flat_screen', 10, 'rectangularity', 0.8348, 0.1324),
  ('flat_screen', 10, 'spread_length', -0.783, 0.09291),
  ('flat_screen', 10, 'spread_width', -1.414, 0.1672),
  ('flat_screen', 10, 'standoff', 0.4949, 0.1686),
  ('flat_screen', 10, 'tilt_deg', 85.53, 4.001),
  ('flat_screen', 10, 'wall_offset', 1.027, 0.1861),
  ('flat_screen', 10, 'width', -1.235, 0.2423),
  ('flat_screen', 10, 'z_max', 0.445, 0.05801),
  ('flat_screen', 10, 'z_min', 0.1473, 0.1175);

-- keyboard: 411 examples
UPDATE object_class SET prior = 0.02733 WHERE name = 'keyboard';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'lift', 0.02789, 0.025)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1523, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'aspect', 0.936, 0.1929),
  ('keyboard', 1, 'behind', 0.2888, 0.0624),
  ('keyboard', 1, 'corner_offset', 0.8116, 0.4275),
  ('keyboard', 1, 'edge_concave', -0.0003288, 0.03006),
  ('keyboard', 1, 'edge_convex', 0.0001108, 0.03271),
  ('keyboard', 1, 'edge_free', 0.3565, 0.1133),
  ('keyboard', 1, 'edge_free_top', -0.01514, 0.2871),
  ('keyboard', 1, 'edge_unseen', 0.001349, 0.03388),
  ('keyboard', 1, 'headroom', 1.952, 0.2181),
  ('keyboard', 1, 'height', 0.7986, 0.0225),
  ('keyboard', 1, 'lift', 0.02133, 0.025),
  ('keyboard', 1, 'rectangularity', 0.8396, 0.07262),
  ('keyboard', 1, 'spread_length', -0.8498, 0.1023),
  ('keyboard', 1, 'spread_width', -1.772, 0.0643),
  ('keyboard', 1, 'standoff', -0.001157, 0.3252),
  ('keyboard', 1, 'tilt_deg', 4.943, 0.8653),
  ('keyboard', 1, 'wall_offset', -0.01564, 0.3374),
  ('keyboard', 1, 'width', -1.689, 0.2397),
  ('keyboard', 1, 'z_max', 0.8011, 0.0225),
  ('keyboard', 1, 'z_min', 0.7986, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.06975, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'aspect', 0.3552, 0.3994),
  ('keyboard', 2, 'behind', 0.3609, 0.0553),
  ('keyboard', 2, 'corner_offset', 0.8788, 0.8202),
  ('keyboard', 2, 'edge_concave', 0.0002633, 0.03318),
  ('keyboard', 2, 'edge_convex', 0.004272, 0.04209),
  ('keyboard', 2, 'edge_free', 0.2075, 0.1094),
  ('keyboard', 2, 'edge_free_top', -0.005553, 0.3115),
  ('keyboard', 2, 'edge_unseen', 0.2612, 0.07515),
  ('keyboard', 2, 'headroom', 2.121, 0.2089),
  ('keyboard', 2, 'height', 0.7594, 0.04756),
  ('keyboard', 2, 'lift', 0.02083, 0.025),
  ('keyboard', 2, 'rectangularity', 0.7513, 0.0759),
  ('keyboard', 2, 'spread_length', -1.559, 0.08308),
  ('keyboard', 2, 'spread_width', -2.052, 0.1636),
  ('keyboard', 2, 'standoff', -0.003306, 0.3204),
  ('keyboard', 2, 'tilt_deg', 3.712, 1.181),
  ('keyboard', 2, 'wall_offset', -0.009794, 0.321),
  ('keyboard', 2, 'width', -1.812, 0.3661),
  ('keyboard', 2, 'z_max', 0.7486, 0.02951),
  ('keyboard', 2, 'z_min', 0.7649, 0.05623);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.126, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'aspect', 0.7645, 0.2017),
  ('keyboard', 3, 'behind', 0.1708, 0.1596),
  ('keyboard', 3, 'corner_offset', 0.9104, 0.1405),
  ('keyboard', 3, 'edge_concave', -0.0007272, 0.03428),
  ('keyboard', 3, 'edge_convex', 0.00275, 0.03682),
  ('keyboard', 3, 'edge_free', 0.3013, 0.08562),
  ('keyboard', 3, 'edge_free_top', -0.004567, 0.3099),
  ('keyboard', 3, 'edge_unseen', 0.003775, 0.03641),
  ('keyboard', 3, 'headroom', 1.961, 0.3323),
  ('keyboard', 3, 'height', 0.7313, 0.0225),
  ('keyboard', 3, 'lift', 0.03385, 0.025),
  ('keyboard', 3, 'rectangularity', 0.7447, 0.04882),
  ('keyboard', 3, 'spread_length', -0.7941, 0.0779),
  ('keyboard', 3, 'spread_width', -1.81, 0.07516),
  ('keyboard', 3, 'standoff', -0.001522, 0.3202),
  ('keyboard', 3, 'tilt_deg', 4.371, 1.129),
  ('keyboard', 3, 'wall_offset', -0.002703, 0.321),
  ('keyboard', 3, 'width', -1.536, 0.125),
  ('keyboard', 3, 'z_max', 0.7407, 0.0225),
  ('keyboard', 3, 'z_min', 0.7201, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.101, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'aspect', 0.9153, 0.1507),
  ('keyboard', 4, 'behind', 0.3862, 0.1664),
  ('keyboard', 4, 'corner_offset', 0.7951, 0.117),
  ('keyboard', 4, 'edge_concave', 0.001929, 0.03813),
  ('keyboard', 4, 'edge_convex', 0.001834, 0.03413),
  ('keyboard', 4, 'edge_free', 0.02003, 0.03732),
  ('keyboard', 4, 'edge_free_top', -0.002508, 0.3121),
  ('keyboard', 4, 'edge_unseen', 0.003612, 0.03492),
  ('keyboard', 4, 'headroom', 1.915, 0.2243),
  ('keyboard', 4, 'height', 0.7583, 0.02258),
  ('keyboard', 4, 'lift', 0.02674, 0.025),
  ('keyboard', 4, 'rectangularity', 0.8404, 0.03208),
  ('keyboard', 4, 'spread_length', -0.8293, 0.08781),
  ('keyboard', 4, 'spread_width', -1.804, 0.06968),
  ('keyboard', 4, 'standoff', -0.0003425, 0.319),
  ('keyboard', 4, 'tilt_deg', 1.672, 0.4502),
  ('keyboard', 4, 'wall_offset', -0.002827, 0.3192),
  ('keyboard', 4, 'width', -1.614, 0.1025),
  ('keyboard', 4, 'z_max', 0.759, 0.02255),
  ('keyboard', 4, 'z_min', 0.7594, 0.02258);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.06237, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'aspect', 0.7854, 0.2145),
  ('keyboard', 5, 'behind', 0.2775, 0.06637),
  ('keyboard', 5, 'corner_offset', 0.899, 0.9406),
  ('keyboard', 5, 'edge_concave', 0.127, 0.07695),
  ('keyboard', 5, 'edge_convex', 0.1228, 0.1236),
  ('keyboard', 5, 'edge_free', 0.1671, 0.1616),
  ('keyboard', 5, 'edge_free_top', -0.004222, 0.3123),
  ('keyboard', 5, 'edge_unseen', 0.006051, 0.03003),
  ('keyboard', 5, 'headroom', 1.923, 0.1818),
  ('keyboard', 5, 'height', 0.7445, 0.04815),
  ('keyboard', 5, 'lift', 0.02853, 0.025),
  ('keyboard', 5, 'rectangularity', 0.7778, 0.06059),
  ('keyboard', 5, 'spread_length', -0.8588, 0.1196),
  ('keyboard', 5, 'spread_width', -1.797, 0.0576),
  ('keyboard', 5, 'standoff', -0.001494, 0.3203),
  ('keyboard', 5, 'tilt_deg', 3.209, 1.16),
  ('keyboard', 5, 'wall_offset', -0.004219, 0.3187),
  ('keyboard', 5, 'width', -1.49, 0.1437),
  ('keyboard', 5, 'z_max', 0.7492, 0.04443),
  ('keyboard', 5, 'z_min', 0.7436, 0.05505);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.1068, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'aspect', 1.054, 0.07735),
  ('keyboard', 6, 'behind', 0.1861, 0.1182),
  ('keyboard', 6, 'corner_offset', 0.7546, 0.636),
  ('keyboard', 6, 'edge_concave', 0.001331, 0.03127),
  ('keyboard', 6, 'edge_convex', 0.001127, 0.03165),
  ('keyboard', 6, 'edge_free', 0.3023, 0.1565),
  ('keyboard', 6, 'edge_free_top', -0.006455, 0.3056),
  ('keyboard', 6, 'edge_unseen', 0.006908, 0.03075),
  ('keyboard', 6, 'headroom', 2.257, 0.1642),
  ('keyboard', 6, 'height', 0.7497, 0.07467),
  ('keyboard', 6, 'lift', 0.02682, 0.025),
  ('keyboard', 6, 'rectangularity', 0.9179, 0.03588),
  ('keyboard', 6, 'spread_length', -0.8216, 0.04177),
  ('keyboard', 6, 'spread_width', -1.874, 0.08323),
  ('keyboard', 6, 'standoff', -0.00093, 0.3225),
  ('keyboard', 6, 'tilt_deg', 4.602, 1.582),
  ('keyboard', 6, 'wall_offset', -0.006027, 0.3262),
  ('keyboard', 6, 'width', -1.835, 0.0828),
  ('keyboard', 6, 'z_max', 0.7579, 0.07281),
  ('keyboard', 6, 'z_min', 0.7481, 0.06946);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.09218, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'aspect', 0.8385, 0.1739),
  ('keyboard', 7, 'behind', 0.09662, 0.143),
  ('keyboard', 7, 'corner_offset', 0.7575, 0.6654),
  ('keyboard', 7, 'edge_concave', 0.01552, 0.05127),
  ('keyboard', 7, 'edge_convex', 0.02036, 0.06097),
  ('keyboard', 7, 'edge_free', 0.1472, 0.1276),
  ('keyboard', 7, 'edge_free_top', -0.009521, 0.3201),
  ('keyboard', 7, 'edge_unseen', 0.06542, 0.09625),
  ('keyboard', 7, 'headroom', 1.869, 0.3001),
  ('keyboard', 7, 'height', 1.014, 0.1091),
  ('keyboard', 7, 'lift', 0.0232, 0.025),
  ('keyboard', 7, 'rectangularity', 0.8081, 0.1283),
  ('keyboard', 7, 'spread_length', -0.9326, 0.1284),
  ('keyboard', 7, 'spread_width', -1.858, 0.05781),
  ('keyboard', 7, 'standoff', -0.00581, 0.337),
  ('keyboard', 7, 'tilt_deg', 4.068, 1.61),
  ('keyboard', 7, 'wall_offset', -0.05462, 0.309),
  ('keyboard', 7, 'width', -1.787, 0.1231),
  ('keyboard', 7, 'z_max', 1.01, 0.1016),
  ('keyboard', 7, 'z_min', 1.037, 0.09423);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.09192, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'aspect', 0.3652, 0.2265),
  ('keyboard', 8, 'behind', 0.2698, 0.07345),
  ('keyboard', 8, 'corner_offset', 0.7411, 0.6049),
  ('keyboard', 8, 'edge_concave', 0.00533, 0.04601),
  ('keyboard', 8, 'edge_convex', 0.03775, 0.07204),
  ('keyboard', 8, 'edge_free', 0.344, 0.09828),
  ('keyboard', 8, 'edge_free_top', -0.007366, 0.311),
  ('keyboard', 8, 'edge_unseen', 0.002921, 0.03857),
  ('keyboard', 8, 'headroom', 1.919, 0.1697),
  ('keyboard', 8, 'height', 0.729, 0.05979),
  ('keyboard', 8, 'lift', 0.03006, 0.025),
  ('keyboard', 8, 'rectangularity', 0.7818, 0.03441),
  ('keyboard', 8, 'spread_length', -1.017, 0.1892),
  ('keyboard', 8, 'spread_width', -1.684, 0.04414),
  ('keyboard', 8, 'standoff', -0.001457, 0.3278),
  ('keyboard', 8, 'tilt_deg', 5.429, 1.249),
  ('keyboard', 8, 'wall_offset', -0.01008, 0.3173),
  ('keyboard', 8, 'width', -1.283, 0.05323),
  ('keyboard', 8, 'z_max', 0.7361, 0.05708),
  ('keyboard', 8, 'z_min', 0.722, 0.0636);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.1081, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'aspect', 0.6749, 0.1224),
  ('keyboard', 9, 'behind', 0.2182, 0.06546),
  ('keyboard', 9, 'corner_offset', 0.8236, 0.0954),
  ('keyboard', 9, 'edge_concave', -0.0001554, 0.03),
  ('keyboard', 9, 'edge_convex', 0.1463, 0.1459),
  ('keyboard', 9, 'edge_free', 0.1633, 0.1644),
  ('keyboard', 9, 'edge_free_top', -0.01563, 0.2952),
  ('keyboard', 9, 'edge_unseen', 0.09118, 0.09957),
  ('keyboard', 9, 'headroom', 1.83, 0.1714),
  ('keyboard', 9, 'height', 0.7398, 0.06429),
  ('keyboard', 9, 'lift', 0.02538, 0.025),
  ('keyboard', 9, 'rectangularity', 0.8466, 0.07698),
  ('keyboard', 9, 'spread_length', -1.066, 0.2121),
  ('keyboard', 9, 'spread_width', -1.847, 0.06783),
  ('keyboard', 9, 'standoff', -0.0061, 0.3306),
  ('keyboard', 9, 'tilt_deg', 3.224, 1.32),
  ('keyboard', 9, 'wall_offset', -0.01929, 0.3166),
  ('keyboard', 9, 'width', -1.717, 0.04973),
  ('keyboard', 9, 'z_max', 0.7402, 0.05782),
  ('keyboard', 9, 'z_min', 0.7428, 0.07124);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.03963, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'aspect', 0.8883, 0.5294),
  ('keyboard', 10, 'behind', 0.1014, 0.1181),
  ('keyboard', 10, 'corner_offset', 0.8225, 0.1331),
  ('keyboard', 10, 'edge_concave', 0.0008806, 0.03),
  ('keyboard', 10, 'edge_convex', 0.003095, 0.03),
  ('keyboard', 10, 'edge_free', 0.1143, 0.1461),
  ('keyboard', 10, 'edge_free_top', -0.0006975, 0.3245),
  ('keyboard', 10, 'edge_unseen', 0.1319, 0.1836),
  ('keyboard', 10, 'headroom', 1.948, 0.06154),
  ('keyboard', 10, 'height', 0.1105, 0.09099),
  ('keyboard', 10, 'lift', 0.02861, 0.025),
  ('keyboard', 10, 'rectangularity', 0.9082, 0.05447),
  ('keyboard', 10, 'spread_length', -1.048, 0.4514),
  ('keyboard', 10, 'spread_width', -1.965, 0.04407),
  ('keyboard', 10, 'standoff', -0.0004934, 0.3164),
  ('keyboard', 10, 'tilt_deg', 2.249, 1.134),
  ('keyboard', 10, 'wall_offset', -0.03829, 0.3276),
  ('keyboard', 10, 'width', -1.917, 0.05717),
  ('keyboard', 10, 'z_max', 0.0768, 0.05306),
  ('keyboard', 10, 'z_min', 0.1122, 0.07508);

-- chair_seat: 489 examples
UPDATE object_class SET prior = 0.01389 WHERE name = 'chair_seat';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.08647, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'aspect', 0.105, 0.08302),
  ('chair_seat', 1, 'behind', 0.6722, 0.08664),
  ('chair_seat', 1, 'corner_offset', 1.171, 0.2917),
  ('chair_seat', 1, 'edge_concave', 0.3006, 0.09723),
  ('chair_seat', 1, 'edge_convex', 0.0009712, 0.03),
  ('chair_seat', 1, 'edge_free', 0.7471, 0.1403),
  ('chair_seat', 1, 'edge_free_top', -0.0001978, 0.316),
  ('chair_seat', 1, 'edge_unseen', 0.002723, 0.03062),
  ('chair_seat', 1, 'headroom', 2.214, 0.1636),
  ('chair_seat', 1, 'height', 0.492, 0.0225),
  ('chair_seat', 1, 'lift', 0.3737, 0.025),
  ('chair_seat', 1, 'rectangularity', 0.8225, 0.07745),
  ('chair_seat', 1, 'spread_length', -0.7086, 0.05418),
  ('chair_seat', 1, 'spread_width', -0.9333, 0.09631),
  ('chair_seat', 1, 'standoff', -9.841e-05, 0.3162),
  ('chair_seat', 1, 'tilt_deg', 0.4049, 0.45),
  ('chair_seat', 1, 'wall_offset', -0.001216, 0.3152),
  ('chair_seat', 1, 'width', -0.7695, 0.06455),
  ('chair_seat', 1, 'z_max', 0.494, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4901, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.05113, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'aspect', 0.145, 0.1292),
  ('chair_seat', 2, 'behind', 0.7583, 0.08093),
  ('chair_seat', 2, 'corner_offset', 0.9916, 0.6456),
  ('chair_seat', 2, 'edge_concave', 0.1937, 0.1503),
  ('chair_seat', 2, 'edge_convex', -0.0025, 0.03),
  ('chair_seat', 2, 'edge_free', 0.5752, 0.1177),
  ('chair_seat', 2, 'edge_free_top', -0.0003402, 0.3162),
  ('chair_seat', 2, 'edge_unseen', 0.003323, 0.0329),
  ('chair_seat', 2, 'headroom', 2.318, 0.3028),
  ('chair_seat', 2, 'height', 0.448, 0.0225),
  ('chair_seat', 2, 'lift', 0.3476, 0.025),
  ('chair_seat', 2, 'rectangularity', 0.6677, 0.08898),
  ('chair_seat', 2, 'spread_length', -0.6768, 0.05017),
  ('chair_seat', 2, 'spread_width', -1.076, 0.1083),
  ('chair_seat', 2, 'standoff', -5.265e-05, 0.3162),
  ('chair_seat', 2, 'tilt_deg', 0.4532, 0.45),
  ('chair_seat', 2, 'wall_offset', -0.001209, 0.3151),
  ('chair_seat', 2, 'width', -0.8237, 0.07891),
  ('chair_seat', 2, 'z_max', 0.4496, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4468, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.1403, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'aspect', 0.1668, 0.1451),
  ('chair_seat', 3, 'behind', 0.661, 0.1104),
  ('chair_seat', 3, 'corner_offset', 1.068, 0.1836),
  ('chair_seat', 3, 'edge_concave', 0.2065, 0.1703),
  ('chair_seat', 3, 'edge_convex', -0.0008735, 0.03),
  ('chair_seat', 3, 'edge_free', 0.5729, 0.1293),
  ('chair_seat', 3, 'edge_free_top', -0.0008346, 0.3158),
  ('chair_seat', 3, 'edge_unseen', 0.0892, 0.1206),
  ('chair_seat', 3, 'headroom', 1.448, 1.107),
  ('chair_seat', 3, 'height', 0.4953, 0.02315),
  ('chair_seat', 3, 'lift', 0.3612, 0.02516),
  ('chair_seat', 3, 'rectangularity', 0.6529, 0.1252),
  ('chair_seat', 3, 'spread_length', -0.7304, 0.1089),
  ('chair_seat', 3, 'spread_width', -1.183, 0.1249),
  ('chair_seat', 3, 'standoff', -0.0005419, 0.3164),
  ('chair_seat', 3, 'tilt_deg', 0.5038, 0.4647),
  ('chair_seat', 3, 'wall_offset', -0.002734, 0.3147),
  ('chair_seat', 3, 'width', -0.8934, 0.08909),
  ('chair_seat', 3, 'z_max', 0.4976, 0.0244),
  ('chair_seat', 3, 'z_min', 0.4937, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.07044, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'aspect', 0.1224, 0.08404),
  ('chair_seat', 4, 'behind', 0.689, 0.0827),
  ('chair_seat', 4, 'corner_offset', 1.175, 0.1794),
  ('chair_seat', 4, 'edge_concave', 0.2217, 0.1636),
  ('chair_seat', 4, 'edge_convex', 0.0007855, 0.03),
  ('chair_seat', 4, 'edge_free', 0.7753, 0.1126),
  ('chair_seat', 4, 'edge_free_top', -0.0001513, 0.3162),
  ('chair_seat', 4, 'edge_unseen', 0.007262, 0.03004),
  ('chair_seat', 4, 'headroom', 2.239, 0.2018),
  ('chair_seat', 4, 'height', 0.4448, 0.0225),
  ('chair_seat', 4, 'lift', 0.3613, 0.025),
  ('chair_seat', 4, 'rectangularity', 0.8559, 0.05123),
  ('chair_seat', 4, 'spread_length', -0.733, 0.05331),
  ('chair_seat', 4, 'spread_width', -0.9135, 0.07343),
  ('chair_seat', 4, 'standoff', -0.000196, 0.3161),
  ('chair_seat', 4, 'tilt_deg', 0.4067, 0.4503),
  ('chair_seat', 4, 'wall_offset', -0.001156, 0.3157),
  ('chair_seat', 4, 'width', -0.8071, 0.07633),
  ('chair_seat', 4, 'z_max', 0.4475, 0.0225),
  ('chair_seat', 4, 'z_min', 0.4434, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.2985, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'aspect', 0.7402, 0.233),
  ('chair_seat', 5, 'behind', 0.7589, 0.09959),
  ('chair_seat', 5, 'corner_offset', 1.052, 0.1716),
  ('chair_seat', 5, 'edge_concave', 0.2361, 0.2327),
  ('chair_seat', 5, 'edge_convex', 0.0001361, 0.03),
  ('chair_seat', 5, 'edge_free', 0.4524, 0.1562),
  ('chair_seat', 5, 'edge_free_top', -0.005054, 0.3233),
  ('chair_seat', 5, 'edge_unseen', 0.009957, 0.03),
  ('chair_seat', 5, 'headroom', 2.235, 0.3903),
  ('chair_seat', 5, 'height', 0.4819, 0.02632),
  ('chair_seat', 5, 'lift', 0.3627, 0.02527),
  ('chair_seat', 5, 'rectangularity', 0.716, 0.1005),
  ('chair_seat', 5, 'spread_length', -0.7757, 0.08773),
  ('chair_seat', 5, 'spread_width', -1.739, 0.2566),
  ('chair_seat', 5, 'standoff', -0.0004942, 0.3372),
  ('chair_seat', 5, 'tilt_deg', 0.9712, 0.7217),
  ('chair_seat', 5, 'wall_offset', -0.01113, 0.3089),
  ('chair_seat', 5, 'width', -1.5, 0.2745),
  ('chair_seat', 5, 'z_max', 0.4859, 0.02394),
  ('chair_seat', 5, 'z_min', 0.4812, 0.0263);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.07585, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'aspect', 0.5237, 0.09918),
  ('chair_seat', 6, 'behind', 0.481, 0.3167),
  ('chair_seat', 6, 'corner_offset', 0.4977, 0.5253),
  ('chair_seat', 6, 'edge_concave', 0.0729, 0.09654),
  ('chair_seat', 6, 'edge_convex', 0.000327, 0.03),
  ('chair_seat', 6, 'edge_free', 0.6378, 0.2362),
  ('chair_seat', 6, 'edge_free_top', -0.001747, 0.3145),
  ('chair_seat', 6, 'edge_unseen', 0.238, 0.2098),
  ('chair_seat', 6, 'headroom', 2.081, 0.4493),
  ('chair_seat', 6, 'height', 0.4749, 0.02817),
  ('chair_seat', 6, 'lift', 0.3612, 0.02501),
  ('chair_seat', 6, 'rectangularity', 0.6462, 0.1303),
  ('chair_seat', 6, 'spread_length', -0.8628, 0.1903),
  ('chair_seat', 6, 'spread_width', -1.522, 0.1853),
  ('chair_seat', 6, 'standoff', -0.0001355, 0.3174),
  ('chair_seat', 6, 'tilt_deg', 0.5685, 0.45),
  ('chair_seat', 6, 'wall_offset', -0.00322, 0.3148),
  ('chair_seat', 6, 'width', -1.295, 0.127),
  ('chair_seat', 6, 'z_max', 0.4758, 0.0277),
  ('chair_seat', 6, 'z_min', 0.4722, 0.02848);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.1675, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'aspect', 0.5572, 0.2499),
  ('chair_seat', 7, 'behind', 0.3349, 0.2908),
  ('chair_seat', 7, 'corner_offset', 1.05, 0.1438),
  ('chair_seat', 7, 'edge_concave', 0.1739, 0.224),
  ('chair_seat', 7, 'edge_convex', 0.000366, 0.03),
  ('chair_seat', 7, 'edge_free', 0.524, 0.1333),
  ('chair_seat', 7, 'edge_free_top', -0.02322, 0.3047),
  ('chair_seat', 7, 'edge_unseen', 0.1642, 0.1281),
  ('chair_seat', 7, 'headroom', 1.859, 0.3844),
  ('chair_seat', 7, 'height', 0.4761, 0.04844),
  ('chair_seat', 7, 'lift', 0.3614, 0.025),
  ('chair_seat', 7, 'rectangularity', 0.6855, 0.07349),
  ('chair_seat', 7, 'spread_length', -1.202, 0.2467),
  ('chair_seat', 7, 'spread_width', -2.035, 0.1904),
  ('chair_seat', 7, 'standoff', -0.006786, 0.33),
  ('chair_seat', 7, 'tilt_deg', 2.598, 1.253),
  ('chair_seat', 7, 'wall_offset', -0.01885, 0.3184),
  ('chair_seat', 7, 'width', -1.761, 0.2192),
  ('chair_seat', 7, 'z_max', 0.4694, 0.03885),
  ('chair_seat', 7, 'z_min', 0.4783, 0.04612);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.02771, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'aspect', 0.1322, 0.08291),
  ('chair_seat', 8, 'behind', 0.6891, 0.1026),
  ('chair_seat', 8, 'corner_offset', 1.178, 0.2128),
  ('chair_seat', 8, 'edge_concave', 0.1757, 0.1427),
  ('chair_seat', 8, 'edge_convex', 0.2855, 0.08722),
  ('chair_seat', 8, 'edge_free', 0.6947, 0.1471),
  ('chair_seat', 8, 'edge_free_top', -0.000106, 0.3162),
  ('chair_seat', 8, 'edge_unseen', 0.004084, 0.03126),
  ('chair_seat', 8, 'headroom', 2.254, 0.2551),
  ('chair_seat', 8, 'height', 0.4673, 0.0272),
  ('chair_seat', 8, 'lift', 0.3612, 0.025),
  ('chair_seat', 8, 'rectangularity', 0.7419, 0.1426),
  ('chair_seat', 8, 'spread_length', -0.731, 0.09262),
  ('chair_seat', 8, 'spread_width', -1.054, 0.1467),
  ('chair_seat', 8, 'standoff', -0.0001047, 0.3161),
  ('chair_seat', 8, 'tilt_deg', 0.3056, 0.4523),
  ('chair_seat', 8, 'wall_offset', -0.0007754, 0.3157),
  ('chair_seat', 8, 'width', -0.8302, 0.0859),
  ('chair_seat', 8, 'z_max', 0.4678, 0.026),
  ('chair_seat', 8, 'z_min', 0.4652, 0.0267);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.018, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'aspect', 0.145, 0.1942),
  ('chair_seat', 9, 'behind', 0.802, 0.03623),
  ('chair_seat', 9, 'corner_offset', 1.255, 0.2737),
  ('chair_seat', 9, 'edge_concave', 0.1936, 0.1007),
  ('chair_seat', 9, 'edge_convex', 0.004113, 0.03),
  ('chair_seat', 9, 'edge_free', 0.5703, 0.09468),
  ('chair_seat', 9, 'edge_free_top', -8.121e-05, 0.3162),
  ('chair_seat', 9, 'edge_unseen', 0.006514, 0.03029),
  ('chair_seat', 9, 'headroom', 0.3832, 0.1717),
  ('chair_seat', 9, 'height', 0.4528, 0.0225),
  ('chair_seat', 9, 'lift', 0.3612, 0.025),
  ('chair_seat', 9, 'rectangularity', 0.7988, 0.1158),
  ('chair_seat', 9, 'spread_length', -0.6288, 0.2249),
  ('chair_seat', 9, 'spread_width', -0.9821, 0.1186),
  ('chair_seat', 9, 'standoff', -6.968e-05, 0.3161),
  ('chair_seat', 9, 'tilt_deg', 0.5504, 0.45),
  ('chair_seat', 9, 'wall_offset', -0.0001497, 0.3163),
  ('chair_seat', 9, 'width', -0.7743, 0.1042),
  ('chair_seat', 9, 'z_max', 0.4556, 0.0225),
  ('chair_seat', 9, 'z_min', 0.4515, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 10, 0.01401, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 10, 'aspect', 0.3735, 0.2441),
  ('chair_seat', 10, 'behind', 0.5105, 0.09081),
  ('chair_seat', 10, 'corner_offset', 1.013, 0.194),
  ('chair_seat', 10, 'edge_concave', 0.08628, 0.1036),
  ('chair_seat', 10, 'edge_convex', 0.2493, 0.1358),
  ('chair_seat', 10, 'edge_free', 0.4756, 0.1276),
  ('chair_seat', 10, 'edge_free_top', -0.0008486, 0.3155),
  ('chair_seat', 10, 'edge_unseen', 0.08429, 0.09682),
  ('chair_seat', 10, 'headroom', 0.9947, 0.6197),
  ('chair_seat', 10, 'height', 0.452, 0.1406),
  ('chair_seat', 10, 'lift', 0.3613, 0.025),
  ('chair_seat', 10, 'rectangularity', 0.7686, 0.04356),
  ('chair_seat', 10, 'spread_length', -0.8726, 0.1435),
  ('chair_seat', 10, 'spread_width', -1.4, 0.2896),
  ('chair_seat', 10, 'standoff', -0.001217, 0.3145),
  ('chair_seat', 10, 'tilt_deg', 1.354, 0.7398),
  ('chair_seat', 10, 'wall_offset', -0.005025, 0.3127),
  ('chair_seat', 10, 'width', -1.184, 0.2709),
  ('chair_seat', 10, 'z_max', 0.4646, 0.1188),
  ('chair_seat', 10, 'z_min', 0.4665, 0.1011);

-- chair_back: 483 examples
UPDATE object_class SET prior = 0.05072 WHERE name = 'chair_back';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'lift', -0.01187, 0.08057)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1154, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'aspect', 0.1523, 0.1216),
  ('chair_back', 1, 'behind', 0.5818, 0.3639),
  ('chair_back', 1, 'corner_offset', 1.149, 0.4376),
  ('chair_back', 1, 'edge_concave', 0.003264, 0.03003),
  ('chair_back', 1, 'edge_convex', 0.001873, 0.03),
  ('chair_back', 1, 'edge_free', 0.7271, 0.1008),
  ('chair_back', 1, 'edge_free_top', 0.9995, 0.03),
  ('chair_back', 1, 'edge_unseen', 0.0517, 0.0958),
  ('chair_back', 1, 'headroom', 1.741, 0.2491),
  ('chair_back', 1, 'height', 0.8409, 0.05942),
  ('chair_back', 1, 'lift', 0.1131, 0.02971),
  ('chair_back', 1, 'rectangularity', 0.9029, 0.0301),
  ('chair_back', 1, 'spread_length', -0.7364, 0.04726),
  ('chair_back', 1, 'spread_width', -1.026, 0.2078),
  ('chair_back', 1, 'standoff', 0.9605, 0.2933),
  ('chair_back', 1, 'tilt_deg', 81.35, 2.719),
  ('chair_back', 1, 'wall_offset', 1.24, 0.5813),
  ('chair_back', 1, 'width', -0.8926, 0.1204),
  ('chair_back', 1, 'z_max', 1.016, 0.07074),
  ('chair_back', 1, 'z_min', 0.5758, 0.04538);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.07866, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'aspect', 0.3584, 0.1419),
  ('chair_back', 2, 'behind', 0.5445, 0.2654),
  ('chair_back', 2, 'corner_offset', 1.802, 0.6255),
  ('chair_back', 2, 'edge_concave', 0.002331, 0.03456),
  ('chair_back', 2, 'edge_convex', 0.2095, 0.1328),
  ('chair_back', 2, 'edge_free', 0.9796, 0.03128),
  ('chair_back', 2, 'edge_free_top', 0.9989, 0.03044),
  ('chair_back', 2, 'edge_unseen', 0.007406, 0.03137),
  ('chair_back', 2, 'headroom', 1.654, 0.2736),
  ('chair_back', 2, 'height', 0.795, 0.05714),
  ('chair_back', 2, 'lift', -0.0746, 0.0251),
  ('chair_back', 2, 'rectangularity', 0.9077, 0.03011),
  ('chair_back', 2, 'spread_length', -0.5562, 0.09917),
  ('chair_back', 2, 'spread_width', -0.835, 0.1161),
  ('chair_back', 2, 'standoff', 1.206, 0.2476),
  ('chair_back', 2, 'tilt_deg', 79.91, 3.267),
  ('chair_back', 2, 'wall_offset', 1.516, 0.4511),
  ('chair_back', 2, 'width', -0.746, 0.07968),
  ('chair_back', 2, 'z_max', 1.028, 0.07633),
  ('chair_back', 2, 'z_min', 0.3635, 0.03541);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.1317, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'aspect', 0.6465, 0.2226),
  ('chair_back', 3, 'behind', 0.4661, 0.3433),
  ('chair_back', 3, 'corner_offset', 1.402, 0.3228),
  ('chair_back', 3, 'edge_concave', 0.003345, 0.03002),
  ('chair_back', 3, 'edge_convex', 0.1955, 0.09428),
  ('chair_back', 3, 'edge_free', 0.8381, 0.06265),
  ('chair_back', 3, 'edge_free_top', 0.9961, 0.03),
  ('chair_back', 3, 'edge_unseen', 0.1146, 0.1317),
  ('chair_back', 3, 'headroom', 1.747, 0.1643),
  ('chair_back', 3, 'height', 0.8412, 0.05113),
  ('chair_back', 3, 'lift', -0.04449, 0.02501),
  ('chair_back', 3, 'rectangularity', 0.7471, 0.102),
  ('chair_back', 3, 'spread_length', -0.5616, 0.09035),
  ('chair_back', 3, 'spread_width', -1.192, 0.3278),
  ('chair_back', 3, 'standoff', 1.035, 0.2688),
  ('chair_back', 3, 'tilt_deg', 80.33, 2.535),
  ('chair_back', 3, 'wall_offset', 1.489, 0.3628),
  ('chair_back', 3, 'width', -0.9406, 0.228),
  ('chair_back', 3, 'z_max', 1.095, 0.06632),
  ('chair_back', 3, 'z_min', 0.3907, 0.07452);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.09936, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'aspect', 0.1572, 0.07081),
  ('chair_back', 4, 'behind', 0.7372, 0.09044),
  ('chair_back', 4, 'corner_offset', 1.736, 0.8336),
  ('chair_back', 4, 'edge_concave', 0.1943, 0.03809),
  ('chair_back', 4, 'edge_convex', 0.001451, 0.03003),
  ('chair_back', 4, 'edge_free', 0.6109, 0.08303),
  ('chair_back', 4, 'edge_free_top', 0.9945, 0.03254),
  ('chair_back', 4, 'edge_unseen', 0.001685, 0.03084),
  ('chair_back', 4, 'headroom', 1.604, 0.2361),
  ('chair_back', 4, 'height', 0.7826, 0.05591),
  ('chair_back', 4, 'lift', -0.03766, 0.03974),
  ('chair_back', 4, 'rectangularity', 0.7898, 0.08351),
  ('chair_back', 4, 'spread_length', -0.7243, 0.05198),
  ('chair_back', 4, 'spread_width', -0.8506, 0.1299),
  ('chair_back', 4, 'standoff', 0.8948, 0.2907),
  ('chair_back', 4, 'tilt_deg', 79.99, 2.543),
  ('chair_back', 4, 'wall_offset', 1.341, 0.8416),
  ('chair_back', 4, 'width', -0.6838, 0.09376),
  ('chair_back', 4, 'z_max', 0.987, 0.0548),
  ('chair_back', 4, 'z_min', 0.4375, 0.03761);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.1076, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'aspect', 0.5549, 0.1529),
  ('chair_back', 5, 'behind', 0.7195, 0.05504),
  ('chair_back', 5, 'corner_offset', 1.628, 0.4726),
  ('chair_back', 5, 'edge_concave', 0.09933, 0.1048),
  ('chair_back', 5, 'edge_convex', 0.11, 0.1111),
  ('chair_back', 5, 'edge_free', 0.6704, 0.1726),
  ('chair_back', 5, 'edge_free_top', 0.7885, 0.2234),
  ('chair_back', 5, 'edge_unseen', 0.005311, 0.03096),
  ('chair_back', 5, 'headroom', 1.67, 0.222),
  ('chair_back', 5, 'height', 0.7865, 0.05359),
  ('chair_back', 5, 'lift', -0.02213, 0.06225),
  ('chair_back', 5, 'rectangularity', 0.6618, 0.09502),
  ('chair_back', 5, 'spread_length', -0.4639, 0.1278),
  ('chair_back', 5, 'spread_width', -0.9358, 0.2697),
  ('chair_back', 5, 'standoff', 1.221, 0.1698),
  ('chair_back', 5, 'tilt_deg', 79.86, 2.522),
  ('chair_back', 5, 'wall_offset', 1.431, 0.2975),
  ('chair_back', 5, 'width', -0.7418, 0.2174),
  ('chair_back', 5, 'z_max', 1.041, 0.1035),
  ('chair_back', 5, 'z_min', 0.1378, 0.1282);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.05905, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'aspect', 0.5654, 0.2165),
  ('chair_back', 6, 'behind', 0.6837, 0.1666),
  ('chair_back', 6, 'corner_offset', 1.054, 0.5497),
  ('chair_back', 6, 'edge_concave', 0.2161, 0.05948),
  ('chair_back', 6, 'edge_convex', 0.001923, 0.03),
  ('chair_back', 6, 'edge_free', 0.7431, 0.2),
  ('chair_back', 6, 'edge_free_top', 0.983, 0.04897),
  ('chair_back', 6, 'edge_unseen', 0.02898, 0.07213),
  ('chair_back', 6, 'headroom', 1.663, 0.1721),
  ('chair_back', 6, 'height', 0.8325, 0.03796),
  ('chair_back', 6, 'lift', -0.02387, 0.03349),
  ('chair_back', 6, 'rectangularity', 0.7747, 0.07532),
  ('chair_back', 6, 'spread_length', -0.5939, 0.06843),
  ('chair_back', 6, 'spread_width', -1.268, 0.304),
  ('chair_back', 6, 'standoff', 1.152, 0.1655),
  ('chair_back', 6, 'tilt_deg', 79.3, 2.529),
  ('chair_back', 6, 'wall_offset', 2.65, 3.554),
  ('chair_back', 6, 'width', -0.9634, 0.2092),
  ('chair_back', 6, 'z_max', 1.075, 0.06106),
  ('chair_back', 6, 'z_min', 0.4337, 0.04892);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.07328, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'aspect', 0.2784, 0.1674),
  ('chair_back', 7, 'behind', 0.008539, 0.105),
  ('chair_back', 7, 'corner_offset', 2.404, 2.209),
  ('chair_back', 7, 'edge_concave', 0.001094, 0.03954),
  ('chair_back', 7, 'edge_convex', 0.00264, 0.03804),
  ('chair_back', 7, 'edge_free', 0.9846, 0.04578),
  ('chair_back', 7, 'edge_free_top', 0.9994, 0.03568),
  ('chair_back', 7, 'edge_unseen', 0.5039, 0.1094),
  ('chair_back', 7, 'headroom', 1.667, 0.1183),
  ('chair_back', 7, 'height', 0.9338, 0.04375),
  ('chair_back', 7, 'lift', 0.1262, 0.03611),
  ('chair_back', 7, 'rectangularity', 0.6371, 0.05921),
  ('chair_back', 7, 'spread_length', -1.312, 0.3318),
  ('chair_back', 7, 'spread_width', -1.822, 0.4663),
  ('chair_back', 7, 'standoff', 1.122, 0.1894),
  ('chair_back', 7, 'tilt_deg', 80.88, 2.42),
  ('chair_back', 7, 'wall_offset', 2.323, 0.8536),
  ('chair_back', 7, 'width', -1.512, 0.5227),
  ('chair_back', 7, 'z_max', 0.9915, 0.05318),
  ('chair_back', 7, 'z_min', 0.7035, 0.07325);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.06383, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'aspect', 0.2961, 0.2045),
  ('chair_back', 8, 'behind', 0.593, 0.2981),
  ('chair_back', 8, 'corner_offset', 1.658, 0.3299),
  ('chair_back', 8, 'edge_concave', 0.005338, 0.03006),
  ('chair_back', 8, 'edge_convex', 0.2823, 0.1117),
  ('chair_back', 8, 'edge_free', 0.8109, 0.07993),
  ('chair_back', 8, 'edge_free_top', 0.9843, 0.04376),
  ('chair_back', 8, 'edge_unseen', 0.002633, 0.03016),
  ('chair_back', 8, 'headroom', 1.818, 0.2123),
  ('chair_back', 8, 'height', 0.7336, 0.02925),
  ('chair_back', 8, 'lift', -0.04833, 0.049),
  ('chair_back', 8, 'rectangularity', 0.7798, 0.07706),
  ('chair_back', 8, 'spread_length', -0.744, 0.05948),
  ('chair_back', 8, 'spread_width', -1.148, 0.1492),
  ('chair_back', 8, 'standoff', 0.9411, 0.448),
  ('chair_back', 8, 'tilt_deg', 82.03, 2.399),
  ('chair_back', 8, 'wall_offset', 2.102, 2.868),
  ('chair_back', 8, 'width', -0.8748, 0.08336),
  ('chair_back', 8, 'z_max', 0.9152, 0.03979),
  ('chair_back', 8, 'z_min', 0.3799, 0.07948);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.1604, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'aspect', 0.6977, 0.4872),
  ('chair_back', 9, 'behind', 0.3228, 0.4478),
  ('chair_back', 9, 'corner_offset', 1.379, 0.3188),
  ('chair_back', 9, 'edge_concave', 0.09537, 0.1337),
  ('chair_back', 9, 'edge_convex', 0.003239, 0.03),
  ('chair_back', 9, 'edge_free', 0.3418, 0.1812),
  ('chair_back', 9, 'edge_free_top', 0.4526, 0.2735),
  ('chair_back', 9, 'edge_unseen', 0.1705, 0.247),
  ('chair_back', 9, 'headroom', 2.125, 0.2801),
  ('chair_back', 9, 'height', 0.8566, 0.1156),
  ('chair_back', 9, 'lift', 0.08972, 0.03347),
  ('chair_back', 9, 'rectangularity', 0.5944, 0.07207),
  ('chair_back', 9, 'spread_length', -0.8712, 0.1361),
  ('chair_back', 9, 'spread_width', -1.885, 0.3452),
  ('chair_back', 9, 'standoff', 1.072, 0.1329),
  ('chair_back', 9, 'tilt_deg', 79.8, 2.644),
  ('chair_back', 9, 'wall_offset', 1.328, 0.3575),
  ('chair_back', 9, 'width', -1.594, 0.4367),
  ('chair_back', 9, 'z_max', 1.071, 0.06391),
  ('chair_back', 9, 'z_min', 0.5732, 0.06213);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 10, 0.06074, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 10, 'aspect', 0.5852, 0.2599),
  ('chair_back', 10, 'behind', 0.6951, 0.07376),
  ('chair_back', 10, 'corner_offset', 2.309, 0.3578),
  ('chair_back', 10, 'edge_concave', 0.008188, 0.03004),
  ('chair_back', 10, 'edge_convex', 0.002547, 0.03),
  ('chair_back', 10, 'edge_free', 0.6756, 0.1006),
  ('chair_back', 10, 'edge_free_top', 0.9967, 0.03),
  ('chair_back', 10, 'edge_unseen', 0.1042, 0.1975),
  ('chair_back', 10, 'headroom', 1.758, 0.3654),
  ('chair_back', 10, 'height', 0.8058, 0.1065),
  ('chair_back', 10, 'lift', 0.2685, 0.08665),
  ('chair_back', 10, 'rectangularity', 0.8203, 0.1238),
  ('chair_back', 10, 'spread_length', -0.9025, 0.136),
  ('chair_back', 10, 'spread_width', -1.619, 0.2441),
  ('chair_back', 10, 'standoff', 1.031, 0.05913),
  ('chair_back', 10, 'tilt_deg', 79.66, 2.473),
  ('chair_back', 10, 'wall_offset', 1.317, 0.4191),
  ('chair_back', 10, 'width', -1.359, 0.1375),
  ('chair_back', 10, 'z_max', 0.9979, 0.1203),
  ('chair_back', 10, 'z_min', 0.5424, 0.1185);

-- door: 295 examples
UPDATE object_class SET prior = 0.02368 WHERE name = 'door';
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.1918, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'aspect', 0.7631, 0.3133),
  ('door', 1, 'behind', -0.008584, 0.03),
  ('door', 1, 'corner_offset', 0.8325, 0.7718),
  ('door', 1, 'edge_concave', 0.1192, 0.1155),
  ('door', 1, 'edge_convex', -0.0004669, 0.03),
  ('door', 1, 'edge_free', -0.004281, 0.03),
  ('door', 1, 'edge_free_top', 0.005636, 0.03006),
  ('door', 1, 'edge_unseen', 0.009292, 0.03862),
  ('door', 1, 'headroom', 0.6843, 0.4324),
  ('door', 1, 'height', 1.132, 0.07812),
  ('door', 1, 'lift', -0.03406, 0.3147),
  ('door', 1, 'rectangularity', 0.8279, 0.1581),
  ('door', 1, 'spread_length', 0.5835, 0.07422),
  ('door', 1, 'spread_width', -0.1223, 0.07434),
  ('door', 1, 'standoff', 0.04845, 0.1484),
  ('door', 1, 'tilt_deg', 90.03, 0.45),
  ('door', 1, 'wall_offset', -0.08503, 0.04),
  ('door', 1, 'width', -0.1308, 0.09536),
  ('door', 1, 'z_max', 2.037, 0.03807),
  ('door', 1, 'z_min', 0.001245, 0.0248);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1544, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'aspect', 0.8611, 0.05668),
  ('door', 2, 'behind', 0.4899, 0.1283),
  ('door', 2, 'corner_offset', 0.5319, 0.08386),
  ('door', 2, 'edge_concave', 0.2081, 0.1137),
  ('door', 2, 'edge_convex', -0.0007996, 0.03),
  ('door', 2, 'edge_free', 0.422, 0.1097),
  ('door', 2, 'edge_free_top', 0.7956, 0.1723),
  ('door', 2, 'edge_unseen', 0.004156, 0.03),
  ('door', 2, 'headroom', 0.6456, 0.4518),
  ('door', 2, 'height', 1.075, 0.02455),
  ('door', 2, 'lift', -0.0002037, 0.3169),
  ('door', 2, 'rectangularity', 0.8637, 0.06359),
  ('door', 2, 'spread_length', 0.6847, 0.04152),
  ('door', 2, 'spread_width', -0.1197, 0.09423),
  ('door', 2, 'standoff', 0.7063, 0.1865),
  ('door', 2, 'tilt_deg', 89.99, 0.45),
  ('door', 2, 'wall_offset', 0.7784, 0.432),
  ('door', 2, 'width', -0.01966, 0.0968),
  ('door', 2, 'z_max', 2.154, 0.08377),
  ('door', 2, 'z_min', -0.007812, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.192, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'aspect', 0.608, 0.2503),
  ('door', 3, 'behind', -0.004504, 0.03),
  ('door', 3, 'corner_offset', 0.7953, 0.2916),
  ('door', 3, 'edge_concave', 0.01677, 0.03114),
  ('door', 3, 'edge_convex', -0.0005896, 0.03001),
  ('door', 3, 'edge_free', -0.007748, 0.03),
  ('door', 3, 'edge_free_top', 0.001429, 0.03),
  ('door', 3, 'edge_unseen', 0.2368, 0.2123),
  ('door', 3, 'headroom', 0.7911, 0.2753),
  ('door', 3, 'height', 1.402, 0.06521),
  ('door', 3, 'lift', -0.1986, 0.143),
  ('door', 3, 'rectangularity', 0.7134, 0.1356),
  ('door', 3, 'spread_length', 0.07744, 0.1696),
  ('door', 3, 'spread_width', -0.2679, 0.09561),
  ('door', 3, 'standoff', 0.1229, 0.1012),
  ('door', 3, 'tilt_deg', 90.03, 0.45),
  ('door', 3, 'wall_offset', 0.3828, 1.124),
  ('door', 3, 'width', -0.1241, 0.06581),
  ('door', 3, 'z_max', 2.067, 0.04313),
  ('door', 3, 'z_min', 0.3276, 0.1679);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.04081, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'aspect', 0.9463, 0.286),
  ('door', 4, 'behind', 0.0001132, 0.03004),
  ('door', 4, 'corner_offset', 1.79, 0.3756),
  ('door', 4, 'edge_concave', 0.06019, 0.04269),
  ('door', 4, 'edge_convex', -0.0009049, 0.03),
  ('door', 4, 'edge_free', 0.009659, 0.03362),
  ('door', 4, 'edge_free_top', 0.01005, 0.03979),
  ('door', 4, 'edge_unseen', 0.3418, 0.1952),
  ('door', 4, 'headroom', 0.5952, 0.1773),
  ('door', 4, 'height', 1.146, 0.1506),
  ('door', 4, 'lift', -0.01077, 0.3248),
  ('door', 4, 'rectangularity', 0.7389, 0.08149),
  ('door', 4, 'spread_length', 0.5215, 0.08025),
  ('door', 4, 'spread_width', -0.3671, 0.3057),
  ('door', 4, 'standoff', 0.1729, 0.1481),
  ('door', 4, 'tilt_deg', 89.75, 0.6171),
  ('door', 4, 'wall_offset', 2.994, 7.094),
  ('door', 4, 'width', -0.1934, 0.3004),
  ('door', 4, 'z_max', 2.11, 0.2599),
  ('door', 4, 'z_min', 0.09848, 0.08635);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.1274, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'aspect', 0.5957, 0.2119),
  ('door', 5, 'behind', 0.6058, 0.1362),
  ('door', 5, 'corner_offset', 0.4736, 0.04003),
  ('door', 5, 'edge_concave', 0.08499, 0.05597),
  ('door', 5, 'edge_convex', 0.001399, 0.03004),
  ('door', 5, 'edge_free', 0.3234, 0.2826),
  ('door', 5, 'edge_free_top', 0.5143, 0.239),
  ('door', 5, 'edge_unseen', 0.1457, 0.1764),
  ('door', 5, 'headroom', 0.4411, 0.3242),
  ('door', 5, 'height', 1.374, 0.1814),
  ('door', 5, 'lift', -0.01924, 0.4119),
  ('door', 5, 'rectangularity', 0.6973, 0.1217),
  ('door', 5, 'spread_length', 0.004145, 0.2044),
  ('door', 5, 'spread_width', -0.2309, 0.1863),
  ('door', 5, 'standoff', 0.5258, 0.2478),
  ('door', 5, 'tilt_deg', 90, 0.4509),
  ('door', 5, 'wall_offset', 2.745, 2.631),
  ('door', 5, 'width', -0.189, 0.1761),
  ('door', 5, 'z_max', 2.082, 0.1678),
  ('door', 5, 'z_min', 0.6391, 0.2653);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.06701, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'aspect', 0.843, 0.08394),
  ('door', 6, 'behind', 0.4359, 0.08594),
  ('door', 6, 'corner_offset', -0.006882, 0.2415),
  ('door', 6, 'edge_concave', 0.1939, 0.1691),
  ('door', 6, 'edge_convex', 0.02552, 0.07266),
  ('door', 6, 'edge_free', 0.3791, 0.2332),
  ('door', 6, 'edge_free_top', 0.8286, 0.1238),
  ('door', 6, 'edge_unseen', 0.1516, 0.1572),
  ('door', 6, 'headroom', 0.6352, 0.2524),
  ('door', 6, 'height', 1.214, 0.06106),
  ('door', 6, 'lift', 0.002437, 0.3294),
  ('door', 6, 'rectangularity', 0.7987, 0.1198),
  ('door', 6, 'spread_length', 0.377, 0.1589),
  ('door', 6, 'spread_width', -0.266, 0.1605),
  ('door', 6, 'standoff', 0.346, 0.1187),
  ('door', 6, 'tilt_deg', 89.98, 0.45),
  ('door', 6, 'wall_offset', 0.5353, 0.3515),
  ('door', 6, 'width', -0.06607, 0.09226),
  ('door', 6, 'z_max', 2.156, 0.08663),
  ('door', 6, 'z_min', -0.008503, 0.02277);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.04378, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'aspect', 1.005, 0.2577),
  ('door', 7, 'behind', 0.2199, 0.1551),
  ('door', 7, 'corner_offset', 3.484, 0.548),
  ('door', 7, 'edge_concave', 0.08669, 0.04924),
  ('door', 7, 'edge_convex', -0.0002637, 0.03),
  ('door', 7, 'edge_free', 0.4335, 0.332),
  ('door', 7, 'edge_free_top', 0.7869, 0.241),
  ('door', 7, 'edge_unseen', 0.4004, 0.0606),
  ('door', 7, 'headroom', 0.6827, 0.1051),
  ('door', 7, 'height', 1.204, 0.09953),
  ('door', 7, 'lift', -0.001223, 0.3167),
  ('door', 7, 'rectangularity', 0.6792, 0.04704),
  ('door', 7, 'spread_length', 0.4122, 0.08318),
  ('door', 7, 'spread_width', -0.4088, 0.2498),
  ('door', 7, 'standoff', 0.7385, 0.2045),
  ('door', 7, 'tilt_deg', 89.23, 1.339),
  ('door', 7, 'wall_offset', 1.604, 2.159),
  ('door', 7, 'width', -0.2592, 0.1998),
  ('door', 7, 'z_max', 2.104, 0.07569),
  ('door', 7, 'z_min', 0.02232, 0.07606);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.02785, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'aspect', 1.671, 0.2757),
  ('door', 8, 'behind', 0.03289, 0.07675),
  ('door', 8, 'corner_offset', 1.007, 0.2365),
  ('door', 8, 'edge_concave', 0.0936, 0.137),
  ('door', 8, 'edge_convex', -0.00174, 0.03269),
  ('door', 8, 'edge_free', 0.09424, 0.2679),
  ('door', 8, 'edge_free_top', 0.0852, 0.2306),
  ('door', 8, 'edge_unseen', 0.2044, 0.2108),
  ('door', 8, 'headroom', 0.8379, 0.2722),
  ('door', 8, 'height', 1.087, 0.1837),
  ('door', 8, 'lift', -0.01035, 0.32),
  ('door', 8, 'rectangularity', 0.721, 0.1419),
  ('door', 8, 'spread_length', 0.482, 0.276),
  ('door', 8, 'spread_width', -1.382, 0.2785),
  ('door', 8, 'standoff', 0.1989, 0.1386),
  ('door', 8, 'tilt_deg', 89.93, 0.4505),
  ('door', 8, 'wall_offset', -0.008745, 0.1687),
  ('door', 8, 'width', -1.062, 0.3893),
  ('door', 8, 'z_max', 2.026, 0.03942),
  ('door', 8, 'z_min', 0.1769, 0.1962);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.07479, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'aspect', 0.857, 0.2168),
  ('door', 9, 'behind', 0.02548, 0.06997),
  ('door', 9, 'corner_offset', 1.027, 0.05966),
  ('door', 9, 'edge_concave', 0.1582, 0.1149),
  ('door', 9, 'edge_convex', -0.0003672, 0.03006),
  ('door', 9, 'edge_free', 0.1011, 0.1267),
  ('door', 9, 'edge_free_top', 0.08397, 0.1809),
  ('door', 9, 'edge_unseen', 0.08886, 0.1322),
  ('door', 9, 'headroom', 1.647, 0.2349),
  ('door', 9, 'height', 0.6238, 0.3402),
  ('door', 9, 'lift', -0.005982, 0.3611),
  ('door', 9, 'rectangularity', 0.851, 0.07853),
  ('door', 9, 'spread_length', -0.1451, 0.2545),
  ('door', 9, 'spread_width', -1.088, 0.2305),
  ('door', 9, 'standoff', 0.1825, 0.1286),
  ('door', 9, 'tilt_deg', 89.25, 0.7636),
  ('door', 9, 'wall_offset', 0.6776, 0.9808),
  ('door', 9, 'width', -1.006, 0.2182),
  ('door', 9, 'z_max', 0.994, 0.3216),
  ('door', 9, 'z_min', 0.05863, 0.09661);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.03017, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'aspect', 1.579, 0.1819),
  ('door', 10, 'behind', 0.1972, 0.369),
  ('door', 10, 'corner_offset', 0.8898, 0.2614),
  ('door', 10, 'edge_concave', 0.04841, 0.07362),
  ('door', 10, 'edge_convex', -0.0003495, 0.03002),
  ('door', 10, 'edge_free', 0.3082, 0.1621),
  ('door', 10, 'edge_free_top', 0.2357, 0.4151),
  ('door', 10, 'edge_unseen', 0.07354, 0.05599),
  ('door', 10, 'headroom', 0.6548, 0.06197),
  ('door', 10, 'height', 1.522, 0.3225),
  ('door', 10, 'lift', -0.02779, 0.3088),
  ('door', 10, 'rectangularity', 0.6885, 0.04938),
  ('door', 10, 'spread_length', 0.1491, 0.4998),
  ('door', 10, 'spread_width', -1.625, 0.4424),
  ('door', 10, 'standoff', 0.2674, 0.09411),
  ('door', 10, 'tilt_deg', 83.68, 4.122),
  ('door', 10, 'wall_offset', 0.5649, 0.6149),
  ('door', 10, 'width', -1.281, 0.7236),
  ('door', 10, 'z_max', 2.04, 0.1008),
  ('door', 10, 'z_min', 0.8707, 0.8096);

-- window: 719 examples
UPDATE object_class SET prior = 0.0246 WHERE name = 'window';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'lift', 0.1436, 0.2399)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.1815, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'aspect', 0.3005, 0.1623),
  ('window', 1, 'behind', -0.001335, 0.03),
  ('window', 1, 'corner_offset', 1.528, 1.276),
  ('window', 1, 'edge_concave', 0.3312, 0.2563),
  ('window', 1, 'edge_convex', -0.004596, 0.03004),
  ('window', 1, 'edge_free', -0.0004047, 0.03007),
  ('window', 1, 'edge_free_top', 0.003685, 0.03414),
  ('window', 1, 'edge_unseen', 0.1052, 0.1203),
  ('window', 1, 'headroom', -0.008331, 0.03005),
  ('window', 1, 'height', 1.482, 0.09026),
  ('window', 1, 'lift', 0.00404, 0.02517),
  ('window', 1, 'rectangularity', 0.7177, 0.2528),
  ('window', 1, 'spread_length', 0.4038, 0.1646),
  ('window', 1, 'spread_width', 0.1042, 0.2298),
  ('window', 1, 'standoff', 0.01444, 0.00775),
  ('window', 1, 'tilt_deg', 89.88, 0.45),
  ('window', 1, 'wall_offset', -0.1704, 0.05608),
  ('window', 1, 'width', -0.02067, 0.1401),
  ('window', 1, 'z_max', 2.144, 0.09928),
  ('window', 1, 'z_min', 0.9018, 0.05168);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1015, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'aspect', 0.4491, 0.4364),
  ('window', 2, 'behind', -0.004306, 0.03),
  ('window', 2, 'corner_offset', 1.919, 0.9466),
  ('window', 2, 'edge_concave', 0.00459, 0.03196),
  ('window', 2, 'edge_convex', -0.0007894, 0.03001),
  ('window', 2, 'edge_free', 0.005702, 0.03425),
  ('window', 2, 'edge_free_top', -0.002717, 0.03002),
  ('window', 2, 'edge_unseen', 0.1463, 0.07942),
  ('window', 2, 'headroom', 0.8275, 0.3726),
  ('window', 2, 'height', 1.448, 0.1539),
  ('window', 2, 'lift', 0.2043, 0.03934),
  ('window', 2, 'rectangularity', 0.6949, 0.1704),
  ('window', 2, 'spread_length', 0.158, 0.5845),
  ('window', 2, 'spread_width', -0.2533, 0.308),
  ('window', 2, 'standoff', -0.01431, 0.00775),
  ('window', 2, 'tilt_deg', 89.64, 0.4511),
  ('window', 2, 'wall_offset', -0.0937, 0.04),
  ('window', 2, 'width', -0.2529, 0.6455),
  ('window', 2, 'z_max', 2.018, 0.429),
  ('window', 2, 'z_min', 0.9995, 0.05984);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.167, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'aspect', 0.5263, 0.2945),
  ('window', 3, 'behind', -0.006745, 0.03),
  ('window', 3, 'corner_offset', 1.139, 0.2364),
  ('window', 3, 'edge_concave', 0.2109, 0.2549),
  ('window', 3, 'edge_convex', -0.0001741, 0.03),
  ('window', 3, 'edge_free', 0.1565, 0.112),
  ('window', 3, 'edge_free_top', 0.01855, 0.03117),
  ('window', 3, 'edge_unseen', 0.1974, 0.06851),
  ('window', 3, 'headroom', 0.2912, 0.3949),
  ('window', 3, 'height', 1.854, 0.1409),
  ('window', 3, 'lift', 0.7023, 0.3134),
  ('window', 3, 'rectangularity', 0.8112, 0.08843),
  ('window', 3, 'spread_length', 0.1545, 0.1414),
  ('window', 3, 'spread_width', -0.6015, 0.3079),
  ('window', 3, 'standoff', 0.02065, 0.01025),
  ('window', 3, 'tilt_deg', 89.83, 0.45),
  ('window', 3, 'wall_offset', -0.1609, 0.07199),
  ('window', 3, 'width', -0.454, 0.3264),
  ('window', 3, 'z_max', 2.165, 0.1479),
  ('window', 3, 'z_min', 1.524, 0.2108);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.1116, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'aspect', 0.4065, 0.2475),
  ('window', 4, 'behind', -0.002378, 0.03),
  ('window', 4, 'corner_offset', 0.9969, 0.2389),
  ('window', 4, 'edge_concave', 0.2808, 0.2927),
  ('window', 4, 'edge_convex', -0.001279, 0.03),
  ('window', 4, 'edge_free', 0.007235, 0.03),
  ('window', 4, 'edge_free_top', 0.002975, 0.03),
  ('window', 4, 'edge_unseen', 0.2776, 0.1491),
  ('window', 4, 'headroom', 0.2196, 0.2049),
  ('window', 4, 'height', 1.363, 0.1136),
  ('window', 4, 'lift', 0.02846, 0.04543),
  ('window', 4, 'rectangularity', 0.7611, 0.08811),
  ('window', 4, 'spread_length', 0.1593, 0.05922),
  ('window', 4, 'spread_width', -0.7133, 0.7238),
  ('window', 4, 'standoff', 0.01349, 0.00775),
  ('window', 4, 'tilt_deg', 89.64, 0.45),
  ('window', 4, 'wall_offset', 4.181, 0.8576),
  ('window', 4, 'width', -0.6175, 0.2417),
  ('window', 4, 'z_max', 1.934, 0.2025),
  ('window', 4, 'z_min', 0.9518, 0.05405);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.07213, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'aspect', 0.1494, 0.09038),
  ('window', 5, 'behind', -0.002207, 0.03),
  ('window', 5, 'corner_offset', 1.113, 0.1367),
  ('window', 5, 'edge_concave', 0.07834, 0.1183),
  ('window', 5, 'edge_convex', -0.0006337, 0.03001),
  ('window', 5, 'edge_free', 0.01729, 0.04795),
  ('window', 5, 'edge_free_top', 0.004146, 0.03001),
  ('window', 5, 'edge_unseen', 0.01911, 0.05239),
  ('window', 5, 'headroom', 0.6259, 0.2364),
  ('window', 5, 'height', 1.513, 0.1154),
  ('window', 5, 'lift', 0.1553, 0.06717),
  ('window', 5, 'rectangularity', 0.9183, 0.06962),
  ('window', 5, 'spread_length', 0.3721, 0.2699),
  ('window', 5, 'spread_width', 0.1209, 0.2186),
  ('window', 5, 'standoff', -0.00586, 0.02072),
  ('window', 5, 'tilt_deg', 89.69, 0.45),
  ('window', 5, 'wall_offset', -0.09927, 0.04),
  ('window', 5, 'width', 0.07039, 0.1307),
  ('window', 5, 'z_max', 2.17, 0.1448),
  ('window', 5, 'z_min', 0.9083, 0.08804);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.09999, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'aspect', 0.3505, 0.2299),
  ('window', 6, 'behind', -0.005224, 0.03),
  ('window', 6, 'corner_offset', 1.507, 0.8559),
  ('window', 6, 'edge_concave', 0.0341, 0.06977),
  ('window', 6, 'edge_convex', -0.0006378, 0.03),
  ('window', 6, 'edge_free', 0.3225, 0.1854),
  ('window', 6, 'edge_free_top', 0.4191, 0.3535),
  ('window', 6, 'edge_unseen', 0.08878, 0.1232),
  ('window', 6, 'headroom', 0.2461, 0.2123),
  ('window', 6, 'height', 1.462, 0.1277),
  ('window', 6, 'lift', 0.1716, 0.1091),
  ('window', 6, 'rectangularity', 0.8141, 0.06084),
  ('window', 6, 'spread_length', 0.1043, 0.2027),
  ('window', 6, 'spread_width', -0.4205, 0.3447),
  ('window', 6, 'standoff', -0.01121, 0.007752),
  ('window', 6, 'tilt_deg', 89.77, 0.45),
  ('window', 6, 'wall_offset', -0.1567, 0.05705),
  ('window', 6, 'width', -0.3195, 0.377),
  ('window', 6, 'z_max', 2.064, 0.1384),
  ('window', 6, 'z_min', 1.017, 0.08279);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.03168, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'aspect', 0.7722, 0.2146),
  ('window', 7, 'behind', -0.003481, 0.03),
  ('window', 7, 'corner_offset', 1.36, 0.4508),
  ('window', 7, 'edge_concave', 0.1944, 0.2436),
  ('window', 7, 'edge_convex', -2.39e-05, 0.03004),
  ('window', 7, 'edge_free', 0.08527, 0.04068),
  ('window', 7, 'edge_free_top', 0.00705, 0.03127),
  ('window', 7, 'edge_unseen', 0.3343, 0.1173),
  ('window', 7, 'headroom', 0.3273, 0.4016),
  ('window', 7, 'height', 1.707, 0.05432),
  ('window', 7, 'lift', 0.6822, 0.2311),
  ('window', 7, 'rectangularity', 0.6539, 0.06277),
  ('window', 7, 'spread_length', -0.3165, 0.5588),
  ('window', 7, 'spread_width', -1.362, 0.5661),
  ('window', 7, 'standoff', 0.01134, 0.01247),
  ('window', 7, 'tilt_deg', 89.64, 0.5759),
  ('window', 7, 'wall_offset', 1.515, 2.669),
  ('window', 7, 'width', -1.063, 0.3038),
  ('window', 7, 'z_max', 2.074, 0.1516),
  ('window', 7, 'z_min', 1.429, 0.181);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.02716, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'aspect', 0.4622, 0.2582),
  ('window', 8, 'behind', 0.01608, 0.06833),
  ('window', 8, 'corner_offset', 1.467, 1.26),
  ('window', 8, 'edge_concave', 0.3323, 0.2556),
  ('window', 8, 'edge_convex', -0.000529, 0.03),
  ('window', 8, 'edge_free', 0.3125, 0.1149),
  ('window', 8, 'edge_free_top', 0.3079, 0.1318),
  ('window', 8, 'edge_unseen', 0.08074, 0.09088),
  ('window', 8, 'headroom', 0.1755, 0.2333),
  ('window', 8, 'height', 1.427, 0.1679),
  ('window', 8, 'lift', 0.01912, 0.04058),
  ('window', 8, 'rectangularity', 0.4872, 0.1148),
  ('window', 8, 'spread_length', 0.5695, 0.2095),
  ('window', 8, 'spread_width', -0.1035, 0.2574),
  ('window', 8, 'standoff', 0.01359, 0.00775),
  ('window', 8, 'tilt_deg', 89.37, 1.706),
  ('window', 8, 'wall_offset', 0.4359, 1.646),
  ('window', 8, 'width', -0.02831, 0.2237),
  ('window', 8, 'z_max', 2.257, 0.1537),
  ('window', 8, 'z_min', 0.902, 0.1444);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.1063, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'aspect', 1.138, 0.4851),
  ('window', 9, 'behind', -0.002983, 0.03),
  ('window', 9, 'corner_offset', 1.327, 0.6621),
  ('window', 9, 'edge_concave', 0.3267, 0.2945),
  ('window', 9, 'edge_convex', -0.0003566, 0.03007),
  ('window', 9, 'edge_free', 0.02863, 0.0564),
  ('window', 9, 'edge_free_top', 0.1275, 0.2185),
  ('window', 9, 'edge_unseen', 0.06735, 0.09649),
  ('window', 9, 'headroom', 0.7283, 0.2252),
  ('window', 9, 'height', 1.16, 0.1737),
  ('window', 9, 'lift', 0.02535, 0.03337),
  ('window', 9, 'rectangularity', 0.769, 0.1791),
  ('window', 9, 'spread_length', 0.2026, 0.1774),
  ('window', 9, 'spread_width', -1.179, 0.5424),
  ('window', 9, 'standoff', -0.01082, 0.01222),
  ('window', 9, 'tilt_deg', 89.13, 0.8329),
  ('window', 9, 'wall_offset', -0.1887, 0.06088),
  ('window', 9, 'width', -1.045, 0.3597),
  ('window', 9, 'z_max', 1.517, 0.3379),
  ('window', 9, 'z_min', 0.914, 0.03898);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.05109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'aspect', 1.375, 0.4513),
  ('window', 10, 'behind', 0.6121, 0.164),
  ('window', 10, 'corner_offset', 0.7307, 0.178),
  ('window', 10, 'edge_concave', 0.9333, 0.08346),
  ('window', 10, 'edge_convex', -1.265e-05, 0.03),
  ('window', 10, 'edge_free', 0.1082, 0.1119),
  ('window', 10, 'edge_free_top', 0.1289, 0.1616),
  ('window', 10, 'edge_unseen', 0.08707, 0.08995),
  ('window', 10, 'headroom', 0.5105, 0.1028),
  ('window', 10, 'height', 1.392, 0.1015),
  ('window', 10, 'lift', -0.05027, 0.04048),
  ('window', 10, 'rectangularity', 0.7432, 0.04501),
  ('window', 10, 'spread_length', -0.2394, 0.6042),
  ('window', 10, 'spread_width', -1.489, 0.2113),
  ('window', 10, 'standoff', 0.1736, 0.0668),
  ('window', 10, 'tilt_deg', 89.78, 0.45),
  ('window', 10, 'wall_offset', 0.9908, 0.5887),
  ('window', 10, 'width', -1.396, 0.1432),
  ('window', 10, 'z_max', 1.964, 0.3717),
  ('window', 10, 'z_min', 0.8734, 0.1419);

-- whiteboard: 253 examples
UPDATE object_class SET prior = 0.01115 WHERE name = 'whiteboard';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'lift', 0.1382, 0.09253)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.1637, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'aspect', 0.4748, 0.3336),
  ('whiteboard', 1, 'behind', 0.001089, 0.03001),
  ('whiteboard', 1, 'corner_offset', 1.414, 0.6096),
  ('whiteboard', 1, 'edge_concave', 0.02046, 0.05149),
  ('whiteboard', 1, 'edge_convex', 8.626e-05, 0.03013),
  ('whiteboard', 1, 'edge_free', 0.01281, 0.03),
  ('whiteboard', 1, 'edge_free_top', 0.02676, 0.04074),
  ('whiteboard', 1, 'edge_unseen', -0.001337, 0.03),
  ('whiteboard', 1, 'headroom', 0.7314, 0.1933),
  ('whiteboard', 1, 'height', 1.482, 0.0603),
  ('whiteboard', 1, 'lift', 0.1792, 0.06292),
  ('whiteboard', 1, 'rectangularity', 0.883, 0.03771),
  ('whiteboard', 1, 'spread_length', 0.3347, 0.2185),
  ('whiteboard', 1, 'spread_width', -0.000466, 0.06845),
  ('whiteboard', 1, 'standoff', 0.02374, 0.009137),
  ('whiteboard', 1, 'tilt_deg', 90.16, 0.45),
  ('whiteboard', 1, 'wall_offset', 0.06767, 0.04),
  ('whiteboard', 1, 'width', 0.1311, 0.05477),
  ('whiteboard', 1, 'z_max', 1.992, 0.1053),
  ('whiteboard', 1, 'z_min', 0.9181, 0.04328);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.225, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'aspect', 0.6466, 0.1343),
  ('whiteboard', 2, 'behind', -0.001168, 0.03),
  ('whiteboard', 2, 'corner_offset', 1.76, 0.5696),
  ('whiteboard', 2, 'edge_concave', 0.05876, 0.1053),
  ('whiteboard', 2, 'edge_convex', -0.0001111, 0.03513),
  ('whiteboard', 2, 'edge_free', 0.02791, 0.03001),
  ('whiteboard', 2, 'edge_free_top', 0.02574, 0.0319),
  ('whiteboard', 2, 'edge_unseen', 0.2006, 0.06612),
  ('whiteboard', 2, 'headroom', 0.961, 0.4037),
  ('whiteboard', 2, 'height', 1.4, 0.06118),
  ('whiteboard', 2, 'lift', 0.1605, 0.08718),
  ('whiteboard', 2, 'rectangularity', 0.7612, 0.08981),
  ('whiteboard', 2, 'spread_length', 0.5303, 0.09752),
  ('whiteboard', 2, 'spread_width', -0.2638, 0.1449),
  ('whiteboard', 2, 'standoff', 0.02397, 0.01265),
  ('whiteboard', 2, 'tilt_deg', 90.02, 0.45),
  ('whiteboard', 2, 'wall_offset', 0.05624, 0.04),
  ('whiteboard', 2, 'width', 0.1628, 0.1001),
  ('whiteboard', 2, 'z_max', 2.049, 0.1096),
  ('whiteboard', 2, 'z_min', 0.9157, 0.08621);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.1463, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'aspect', 0.1472, 0.202),
  ('whiteboard', 3, 'behind', -0.001657, 0.03004),
  ('whiteboard', 3, 'corner_offset', 1.542, 1.355),
  ('whiteboard', 3, 'edge_concave', 0.1633, 0.2666),
  ('whiteboard', 3, 'edge_convex', -0.0001294, 0.03),
  ('whiteboard', 3, 'edge_free', 0.02332, 0.0366),
  ('whiteboard', 3, 'edge_free_top', 0.04094, 0.06302),
  ('whiteboard', 3, 'edge_unseen', 0.1991, 0.1615),
  ('whiteboard', 3, 'headroom', 0.7468, 0.1922),
  ('whiteboard', 3, 'height', 1.33, 0.07312),
  ('whiteboard', 3, 'lift', 0.07256, 0.08016),
  ('whiteboard', 3, 'rectangularity', 0.81, 0.08161),
  ('whiteboard', 3, 'spread_length', -0.04705, 0.1947),
  ('whiteboard', 3, 'spread_width', -0.3191, 0.2077),
  ('whiteboard', 3, 'standoff', 0.03016, 0.01249),
  ('whiteboard', 3, 'tilt_deg', 89.98, 0.4504),
  ('whiteboard', 3, 'wall_offset', 0.06214, 0.04),
  ('whiteboard', 3, 'width', 0.1232, 0.06778),
  ('whiteboard', 3, 'z_max', 1.961, 0.08944),
  ('whiteboard', 3, 'z_min', 0.8467, 0.04435);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.06116, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'aspect', 0.7807, 0.1223),
  ('whiteboard', 4, 'behind', -0.003483, 0.03004),
  ('whiteboard', 4, 'corner_offset', 1.251, 1.087),
  ('whiteboard', 4, 'edge_concave', 0.1633, 0.05085),
  ('whiteboard', 4, 'edge_convex', -0.000115, 0.04093),
  ('whiteboard', 4, 'edge_free', 0.0197, 0.03413),
  ('whiteboard', 4, 'edge_free_top', 0.04482, 0.03653),
  ('whiteboard', 4, 'edge_unseen', 0.262, 0.06348),
  ('whiteboard', 4, 'headroom', 0.5601, 0.07328),
  ('whiteboard', 4, 'height', 1.573, 0.2366),
  ('whiteboard', 4, 'lift', 0.04453, 0.06637),
  ('whiteboard', 4, 'rectangularity', 0.7575, 0.1022),
  ('whiteboard', 4, 'spread_length', -0.3729, 0.3766),
  ('whiteboard', 4, 'spread_width', -1.072, 0.3661),
  ('whiteboard', 4, 'standoff', 0.01744, 0.02858),
  ('whiteboard', 4, 'tilt_deg', 89.75, 0.4505),
  ('whiteboard', 4, 'wall_offset', 3.335, 3.157),
  ('whiteboard', 4, 'width', -0.8616, 0.5276),
  ('whiteboard', 4, 'z_max', 1.995, 0.1341),
  ('whiteboard', 4, 'z_min', 0.9507, 0.1117);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.04653, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'aspect', 0.3712, 0.08216),
  ('whiteboard', 5, 'behind', -0.002518, 0.03009),
  ('whiteboard', 5, 'corner_offset', 1.333, 0.8445),
  ('whiteboard', 5, 'edge_concave', 0.003019, 0.03004),
  ('whiteboard', 5, 'edge_convex', 4.137e-05, 0.03011),
  ('whiteboard', 5, 'edge_free', 0.0886, 0.1716),
  ('whiteboard', 5, 'edge_free_top', 0.1513, 0.2274),
  ('whiteboard', 5, 'edge_unseen', 0.3407, 0.2261),
  ('whiteboard', 5, 'headroom', 0.8265, 0.1186),
  ('whiteboard', 5, 'height', 1.396, 0.04635),
  ('whiteboard', 5, 'lift', 0.1457, 0.05964),
  ('whiteboard', 5, 'rectangularity', 0.7323, 0.03395),
  ('whiteboard', 5, 'spread_length', 0.1075, 0.3143),
  ('whiteboard', 5, 'spread_width', -0.3556, 0.1159),
  ('whiteboard', 5, 'standoff', 0.04312, 0.04429),
  ('whiteboard', 5, 'tilt_deg', 89.98, 0.4515),
  ('whiteboard', 5, 'wall_offset', 2.341, 2.14),
  ('whiteboard', 5, 'width', -0.03591, 0.2032),
  ('whiteboard', 5, 'z_max', 2.079, 0.08182),
  ('whiteboard', 5, 'z_min', 0.9056, 0.0459);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.1254, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'aspect', 0.8148, 0.5142),
  ('whiteboard', 6, 'behind', 0.002336, 0.03002),
  ('whiteboard', 6, 'corner_offset', 1.649, 0.109),
  ('whiteboard', 6, 'edge_concave', 0.05243, 0.106),
  ('whiteboard', 6, 'edge_convex', -8.057e-05, 0.03),
  ('whiteboard', 6, 'edge_free', 0.04258, 0.06843),
  ('whiteboard', 6, 'edge_free_top', 0.302, 0.1662),
  ('whiteboard', 6, 'edge_unseen', 0.4015, 0.06257),
  ('whiteboard', 6, 'headroom', 0.4632, 0.1382),
  ('whiteboard', 6, 'height', 0.9771, 0.2337),
  ('whiteboard', 6, 'lift', 0.2434, 0.4027),
  ('whiteboard', 6, 'rectangularity', 0.8073, 0.09345),
  ('whiteboard', 6, 'spread_length', 0.2785, 0.2694),
  ('whiteboard', 6, 'spread_width', -0.6615, 0.3463),
  ('whiteboard', 6, 'standoff', 0.06618, 0.03215),
  ('whiteboard', 6, 'tilt_deg', 87.09, 0.9236),
  ('whiteboard', 6, 'wall_offset', 0.13, 0.3911),
  ('whiteboard', 6, 'width', -0.4912, 0.3381),
  ('whiteboard', 6, 'z_max', 1.233, 0.2085),
  ('whiteboard', 6, 'z_min', 0.648, 0.4788);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.05828, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'aspect', 0.5141, 0.1512),
  ('whiteboard', 7, 'behind', -0.005137, 0.03),
  ('whiteboard', 7, 'corner_offset', 1.803, 1.887),
  ('whiteboard', 7, 'edge_concave', 0.06275, 0.1941),
  ('whiteboard', 7, 'edge_convex', 6.351e-05, 0.05299),
  ('whiteboard', 7, 'edge_free', -0.03458, 0.03),
  ('whiteboard', 7, 'edge_free_top', -0.01176, 0.03),
  ('whiteboard', 7, 'edge_unseen', 0.3751, 0.09123),
  ('whiteboard', 7, 'headroom', 1.46, 0.3451),
  ('whiteboard', 7, 'height', 1.197, 0.1612),
  ('whiteboard', 7, 'lift', 0.1389, 0.025),
  ('whiteboard', 7, 'rectangularity', 0.7474, 0.06424),
  ('whiteboard', 7, 'spread_length', -0.8507, 0.4303),
  ('whiteboard', 7, 'spread_width', -1.395, 0.3857),
  ('whiteboard', 7, 'standoff', 0.01194, 0.07),
  ('whiteboard', 7, 'tilt_deg', 89.7, 0.45),
  ('whiteboard', 7, 'wall_offset', 0.03008, 0.04),
  ('whiteboard', 7, 'width', -1.288, 0.427),
  ('whiteboard', 7, 'z_max', 1.541, 0.3625),
  ('whiteboard', 7, 'z_min', 0.8991, 0.05946);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.09374, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'aspect', 0.5054, 0.2617),
  ('whiteboard', 8, 'behind', 0.003633, 0.03001),
  ('whiteboard', 8, 'corner_offset', 1.22, 0.3048),
  ('whiteboard', 8, 'edge_concave', 0.2849, 0.05486),
  ('whiteboard', 8, 'edge_convex', -5.936e-05, 0.03),
  ('whiteboard', 8, 'edge_free', 0.05855, 0.1242),
  ('whiteboard', 8, 'edge_free_top', 0.07205, 0.1397),
  ('whiteboard', 8, 'edge_unseen', 0.07212, 0.1139),
  ('whiteboard', 8, 'headroom', 0.5965, 0.3068),
  ('whiteboard', 8, 'height', 1.398, 0.0467),
  ('whiteboard', 8, 'lift', 0.1496, 0.03974),
  ('whiteboard', 8, 'rectangularity', 0.6761, 0.1034),
  ('whiteboard', 8, 'spread_length', 0.714, 0.1902),
  ('whiteboard', 8, 'spread_width', 0.08877, 0.2464),
  ('whiteboard', 8, 'standoff', 0.02973, 0.03778),
  ('whiteboard', 8, 'tilt_deg', 89.58, 0.6209),
  ('whiteboard', 8, 'wall_offset', -0.1032, 2.29),
  ('whiteboard', 8, 'width', 0.4222, 0.09162),
  ('whiteboard', 8, 'z_max', 2.087, 0.07998),
  ('whiteboard', 8, 'z_min', 0.3862, 0.1687);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 9, 0.02989, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 9, 'aspect', 0.2413, 0.1555),
  ('whiteboard', 9, 'behind', 0.3489, 0.1299),
  ('whiteboard', 9, 'corner_offset', 0.1602, 0.7085),
  ('whiteboard', 9, 'edge_concave', 0.1419, 0.08764),
  ('whiteboard', 9, 'edge_convex', 0.07442, 0.1034),
  ('whiteboard', 9, 'edge_free', 0.02012, 0.03),
  ('whiteboard', 9, 'edge_free_top', 0.01385, 0.03),
  ('whiteboard', 9, 'edge_unseen', 0.019, 0.03739),
  ('whiteboard', 9, 'headroom', 0.6547, 0.1415),
  ('whiteboard', 9, 'height', 1.481, 0.0746),
  ('whiteboard', 9, 'lift', 0.1754, 0.05746),
  ('whiteboard', 9, 'rectangularity', 0.834, 0.09165),
  ('whiteboard', 9, 'spread_length', 0.2833, 0.1609),
  ('whiteboard', 9, 'spread_width', -0.01634, 0.1134),
  ('whiteboard', 9, 'standoff', 0.6001, 0.3751),
  ('whiteboard', 9, 'tilt_deg', 89.95, 0.45),
  ('whiteboard', 9, 'wall_offset', 0.7328, 0.65),
  ('whiteboard', 9, 'width', 0.1312, 0.07737),
  ('whiteboard', 9, 'z_max', 2.042, 0.1204),
  ('whiteboard', 9, 'z_min', 0.8666, 0.08037);

-- shelf: 1281 examples
UPDATE object_class SET prior = 0.07965 WHERE name = 'shelf';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'lift', 0.2471, 0.292)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.1471, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'aspect', 1.226, 0.3058),
  ('shelf', 1, 'behind', 0.753, 0.1214),
  ('shelf', 1, 'corner_offset', 0.2406, 0.04196),
  ('shelf', 1, 'edge_concave', 0.44, 0.1572),
  ('shelf', 1, 'edge_convex', 0.06398, 0.07152),
  ('shelf', 1, 'edge_free', 0.4359, 0.03786),
  ('shelf', 1, 'edge_free_top', 0.5101, 0.3735),
  ('shelf', 1, 'edge_unseen', 0.01024, 0.03048),
  ('shelf', 1, 'headroom', 0.1895, 1.044),
  ('shelf', 1, 'height', 0.6979, 0.2755),
  ('shelf', 1, 'lift', 0.2307, 0.06005),
  ('shelf', 1, 'rectangularity', 0.683, 0.1115),
  ('shelf', 1, 'spread_length', -0.1128, 0.5338),
  ('shelf', 1, 'spread_width', -1.138, 0.128),
  ('shelf', 1, 'standoff', 0.4741, 0.4043),
  ('shelf', 1, 'tilt_deg', 89.94, 0.456),
  ('shelf', 1, 'wall_offset', 0.6192, 0.88),
  ('shelf', 1, 'width', -1.136, 0.2303),
  ('shelf', 1, 'z_max', 1.32, 0.5302),
  ('shelf', 1, 'z_min', 0.0328, 0.02838);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.07728, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'aspect', 1.127, 0.6479),
  ('shelf', 2, 'behind', 0.673, 0.1722),
  ('shelf', 2, 'corner_offset', 1.181, 0.4552),
  ('shelf', 2, 'edge_concave', 0.4272, 0.2111),
  ('shelf', 2, 'edge_convex', 0.001075, 0.03),
  ('shelf', 2, 'edge_free', 0.4129, 0.06625),
  ('shelf', 2, 'edge_free_top', 0.4279, 0.09674),
  ('shelf', 2, 'edge_unseen', 0.1445, 0.114),
  ('shelf', 2, 'headroom', 0.4696, 0.1302),
  ('shelf', 2, 'height', 1.012, 0.4525),
  ('shelf', 2, 'lift', 0.4324, 0.1131),
  ('shelf', 2, 'rectangularity', 0.6041, 0.1171),
  ('shelf', 2, 'spread_length', -0.5384, 0.2596),
  ('shelf', 2, 'spread_width', -1.796, 0.3068),
  ('shelf', 2, 'standoff', 0.6742, 0.124),
  ('shelf', 2, 'tilt_deg', 1.98, 2.13),
  ('shelf', 2, 'wall_offset', 1.159, 0.1908),
  ('shelf', 2, 'width', -1.601, 0.3736),
  ('shelf', 2, 'z_max', 0.9529, 0.4204),
  ('shelf', 2, 'z_min', 1.141, 0.3778);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.1227, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'aspect', 0.7996, 0.2754),
  ('shelf', 3, 'behind', 0.7604, 0.08694),
  ('shelf', 3, 'corner_offset', 0.2705, 0.09077),
  ('shelf', 3, 'edge_concave', 0.5675, 0.1488),
  ('shelf', 3, 'edge_convex', 0.03128, 0.06097),
  ('shelf', 3, 'edge_free', 0.2631, 0.1744),
  ('shelf', 3, 'edge_free_top', 0.4051, 0.226),
  ('shelf', 3, 'edge_unseen', 0.04476, 0.1186),
  ('shelf', 3, 'headroom', 0.5612, 0.2382),
  ('shelf', 3, 'height', 1.676, 0.2247),
  ('shelf', 3, 'lift', 0.4473, 0.1186),
  ('shelf', 3, 'rectangularity', 0.7539, 0.1315),
  ('shelf', 3, 'spread_length', -0.3474, 0.3279),
  ('shelf', 3, 'spread_width', -1.083, 0.1109),
  ('shelf', 3, 'standoff', 0.661, 0.06678),
  ('shelf', 3, 'tilt_deg', 0.3796, 0.4511),
  ('shelf', 3, 'wall_offset', 1.515, 0.1775),
  ('shelf', 3, 'width', -0.9553, 0.2254),
  ('shelf', 3, 'z_max', 1.653, 0.1871),
  ('shelf', 3, 'z_min', 1.703, 0.2286);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.1573, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'aspect', 1.071, 0.4853),
  ('shelf', 4, 'behind', 0.798, 0.1387),
  ('shelf', 4, 'corner_offset', 0.2395, 0.04198),
  ('shelf', 4, 'edge_concave', 0.4101, 0.1756),
  ('shelf', 4, 'edge_convex', 0.05772, 0.05831),
  ('shelf', 4, 'edge_free', 0.3515, 0.1075),
  ('shelf', 4, 'edge_free_top', 0.4519, 0.3688),
  ('shelf', 4, 'edge_unseen', 0.08833, 0.1006),
  ('shelf', 4, 'headroom', -0.2526, 0.6896),
  ('shelf', 4, 'height', 1.074, 0.2004),
  ('shelf', 4, 'lift', 0.008306, 0.1093),
  ('shelf', 4, 'rectangularity', 0.7871, 0.09004),
  ('shelf', 4, 'spread_length', -0.2049, 0.3684),
  ('shelf', 4, 'spread_width', -1.127, 0.1532),
  ('shelf', 4, 'standoff', 0.6695, 0.5097),
  ('shelf', 4, 'tilt_deg', 90.08, 0.4503),
  ('shelf', 4, 'wall_offset', 1.069, 1.186),
  ('shelf', 4, 'width', -0.9885, 0.1375),
  ('shelf', 4, 'z_max', 1.723, 0.2955),
  ('shelf', 4, 'z_min', 0.3531, 0.2482);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.1413, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'aspect', 0.9375, 0.4303),
  ('shelf', 5, 'behind', 0.621, 0.1161),
  ('shelf', 5, 'corner_offset', 0.2445, 0.05126),
  ('shelf', 5, 'edge_concave', 0.6267, 0.1664),
  ('shelf', 5, 'edge_convex', 0.003364, 0.03),
  ('shelf', 5, 'edge_free', 0.3224, 0.08968),
  ('shelf', 5, 'edge_free_top', 0.4289, 0.09983),
  ('shelf', 5, 'edge_unseen', 0.00583, 0.03557),
  ('shelf', 5, 'headroom', 1.064, 0.4),
  ('shelf', 5, 'height', 0.4702, 0.06651),
  ('shelf', 5, 'lift', 0.2426, 0.06875),
  ('shelf', 5, 'rectangularity', 0.6768, 0.09039),
  ('shelf', 5, 'spread_length', -0.2535, 0.1326),
  ('shelf', 5, 'spread_width', -1.382, 0.3245),
  ('shelf', 5, 'standoff', 0.6882, 0.1464),
  ('shelf', 5, 'tilt_deg', 2.01, 1.647),
  ('shelf', 5, 'wall_offset', 1.207, 0.3664),
  ('shelf', 5, 'width', -1.229, 0.3175),
  ('shelf', 5, 'z_max', 0.4596, 0.05702),
  ('shelf', 5, 'z_min', 0.48, 0.07237);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.09537, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'aspect', 0.8534, 0.2743),
  ('shelf', 6, 'behind', 0.8092, 0.06853),
  ('shelf', 6, 'corner_offset', 0.2562, 0.04003),
  ('shelf', 6, 'edge_concave', 0.5146, 0.1486),
  ('shelf', 6, 'edge_convex', 0.02589, 0.03569),
  ('shelf', 6, 'edge_free', 0.2851, 0.1188),
  ('shelf', 6, 'edge_free_top', 0.423, 0.1009),
  ('shelf', 6, 'edge_unseen', 0.02071, 0.1126),
  ('shelf', 6, 'headroom', 0.8411, 0.4722),
  ('shelf', 6, 'height', 0.9184, 0.1555),
  ('shelf', 6, 'lift', 0.4681, 0.03701),
  ('shelf', 6, 'rectangularity', 0.735, 0.09092),
  ('shelf', 6, 'spread_length', -0.4979, 0.3377),
  ('shelf', 6, 'spread_width', -1.371, 0.3062),
  ('shelf', 6, 'standoff', 0.7193, 0.1582),
  ('shelf', 6, 'tilt_deg', 0.668, 0.45),
  ('shelf', 6, 'wall_offset', 1.023, 0.2766),
  ('shelf', 6, 'width', -1.012, 0.158),
  ('shelf', 6, 'z_max', 0.909, 0.1644),
  ('shelf', 6, 'z_min', 0.9311, 0.1352);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.04129, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'aspect', 0.9904, 0.6271),
  ('shelf', 7, 'behind', 0.2091, 0.545),
  ('shelf', 7, 'corner_offset', 1.609, 1.952),
  ('shelf', 7, 'edge_concave', 0.4458, 0.1333),
  ('shelf', 7, 'edge_convex', 0.004692, 0.03),
  ('shelf', 7, 'edge_free', 0.1925, 0.1866),
  ('shelf', 7, 'edge_free_top', 0.08582, 0.1311),
  ('shelf', 7, 'edge_unseen', 0.01829, 0.05471),
  ('shelf', 7, 'headroom', 0.2828, 0.5338),
  ('shelf', 7, 'height', 0.8487, 0.1167),
  ('shelf', 7, 'lift', 0.1315, 0.2131),
  ('shelf', 7, 'rectangularity', 0.6903, 0.1603),
  ('shelf', 7, 'spread_length', -0.3781, 0.6213),
  ('shelf', 7, 'spread_width', -1.801, 0.266),
  ('shelf', 7, 'standoff', 0.05061, 0.06982),
  ('shelf', 7, 'tilt_deg', 89.86, 0.5511),
  ('shelf', 7, 'wall_offset', 1.072, 0.9821),
  ('shelf', 7, 'width', -1.723, 0.3433),
  ('shelf', 7, 'z_max', 1.423, 0.2285),
  ('shelf', 7, 'z_min', 0.4907, 0.7839);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.03666, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'aspect', 0.6578, 0.6383),
  ('shelf', 8, 'behind', -0.00393, 0.03),
  ('shelf', 8, 'corner_offset', 0.1994, 0.07076),
  ('shelf', 8, 'edge_concave', 0.4739, 0.224),
  ('shelf', 8, 'edge_convex', 0.0001913, 0.03009),
  ('shelf', 8, 'edge_free', 0.2443, 0.1641),
  ('shelf', 8, 'edge_free_top', 0.4314, 0.1094),
  ('shelf', 8, 'edge_unseen', 0.04078, 0.08555),
  ('shelf', 8, 'headroom', 0.7331, 0.6928),
  ('shelf', 8, 'height', 0.0896, 0.0225),
  ('shelf', 8, 'lift', 0.2488, 0.09299),
  ('shelf', 8, 'rectangularity', 0.6909, 0.1179),
  ('shelf', 8, 'spread_length', -0.376, 0.2468),
  ('shelf', 8, 'spread_width', -1.585, 0.2529),
  ('shelf', 8, 'standoff', 0.6793, 0.148),
  ('shelf', 8, 'tilt_deg', 0.8388, 1.088),
  ('shelf', 8, 'wall_offset', 1.173, 0.3381),
  ('shelf', 8, 'width', -1.312, 0.3033),
  ('shelf', 8, 'z_max', 0.08791, 0.0225),
  ('shelf', 8, 'z_min', 0.08917, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.07288, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'aspect', 0.143, 0.4938),
  ('shelf', 9, 'behind', 0.004179, 0.03004),
  ('shelf', 9, 'corner_offset', 1.606, 0.6965),
  ('shelf', 9, 'edge_concave', 0.6295, 0.1901),
  ('shelf', 9, 'edge_convex', -0.000157, 0.03002),
  ('shelf', 9, 'edge_free', 0.01141, 0.03924),
  ('shelf', 9, 'edge_free_top', 0.007662, 0.03001),
  ('shelf', 9, 'edge_unseen', 0.001957, 0.03001),
  ('shelf', 9, 'headroom', 0.4281, 0.774),
  ('shelf', 9, 'height', 1.084, 0.4843),
  ('shelf', 9, 'lift', 0.1194, 0.2312),
  ('shelf', 9, 'rectangularity', 0.6555, 0.2121),
  ('shelf', 9, 'spread_length', -0.5863, 0.538),
  ('shelf', 9, 'spread_width', -1.176, 0.7024),
  ('shelf', 9, 'standoff', 0.07019, 0.014),
  ('shelf', 9, 'tilt_deg', 89.73, 0.906),
  ('shelf', 9, 'wall_offset', 0.0614, 0.04),
  ('shelf', 9, 'width', -1.172, 0.6177),
  ('shelf', 9, 'z_max', 1.268, 0.4659),
  ('shelf', 9, 'z_min', 0.4299, 0.2541);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.05812, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'aspect', 1.067, 0.3476),
  ('shelf', 10, 'behind', 0.5616, 0.1526),
  ('shelf', 10, 'corner_offset', 3.507, 0.909),
  ('shelf', 10, 'edge_concave', 0.2556, 0.1617),
  ('shelf', 10, 'edge_convex', 0.1901, 0.06293),
  ('shelf', 10, 'edge_free', 0.5087, 0.3294),
  ('shelf', 10, 'edge_free_top', 0.6224, 0.4027),
  ('shelf', 10, 'edge_unseen', 0.1472, 0.184),
  ('shelf', 10, 'headroom', -0.09448, 0.3486),
  ('shelf', 10, 'height', 1.224, 0.1898),
  ('shelf', 10, 'lift', 0.08505, 0.0758),
  ('shelf', 10, 'rectangularity', 0.7256, 0.1135),
  ('shelf', 10, 'spread_length', -0.101, 0.3953),
  ('shelf', 10, 'spread_width', -1.283, 0.2069),
  ('shelf', 10, 'standoff', 0.9001, 0.1151),
  ('shelf', 10, 'tilt_deg', 90, 1.181),
  ('shelf', 10, 'wall_offset', 1.91, 0.5741),
  ('shelf', 10, 'width', -1.082, 0.1161),
  ('shelf', 10, 'z_max', 1.723, 0.1368),
  ('shelf', 10, 'z_min', 0.476, 0.4332);

-- cabinet: 1432 examples
UPDATE object_class SET prior = 0.1186 WHERE name = 'cabinet';
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
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'lift', -0.02935, 0.05039)
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
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.1354, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'aspect', 0.8313, 0.5691),
  ('cabinet', 1, 'behind', 0.2372, 0.1881),
  ('cabinet', 1, 'corner_offset', 2.005, 0.6958),
  ('cabinet', 1, 'edge_concave', 0.03053, 0.07166),
  ('cabinet', 1, 'edge_convex', 0.03668, 0.0897),
  ('cabinet', 1, 'edge_free', 0.5484, 0.2838),
  ('cabinet', 1, 'edge_free_top', 0.9126, 0.1176),
  ('cabinet', 1, 'edge_unseen', 0.2877, 0.2203),
  ('cabinet', 1, 'headroom', 0.5047, 0.1525),
  ('cabinet', 1, 'height', 1.238, 0.1441),
  ('cabinet', 1, 'lift', -0.05284, 0.025),
  ('cabinet', 1, 'rectangularity', 0.7137, 0.1047),
  ('cabinet', 1, 'spread_length', -0.4231, 0.4093),
  ('cabinet', 1, 'spread_width', -0.9937, 0.9613),
  ('cabinet', 1, 'standoff', 0.5372, 0.06758),
  ('cabinet', 1, 'tilt_deg', 90.21, 0.45),
  ('cabinet', 1, 'wall_offset', 2.123, 1.669),
  ('cabinet', 1, 'width', -0.42, 0.3714),
  ('cabinet', 1, 'z_max', 1.927, 0.1218),
  ('cabinet', 1, 'z_min', 0.4613, 0.1451);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.06986, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'aspect', 0.2471, 0.5331),
  ('cabinet', 2, 'behind', 0.4473, 0.399),
  ('cabinet', 2, 'corner_offset', 1.454, 0.9493),
  ('cabinet', 2, 'edge_concave', 0.1728, 0.2575),
  ('cabinet', 2, 'edge_convex', 0.1528, 0.2765),
  ('cabinet', 2, 'edge_free', 0.3085, 0.3199),
  ('cabinet', 2, 'edge_free_top', 0.6464, 0.3869),
  ('cabinet', 2, 'edge_unseen', 0.33, 0.2408),
  ('cabinet', 2, 'headroom', -0.004687, 0.07895),
  ('cabinet', 2, 'height', 0.7406, 0.2346),
  ('cabinet', 2, 'lift', -0.1138, 0.025),
  ('cabinet', 2, 'rectangularity', 0.6427, 0.06934),
  ('cabinet', 2, 'spread_length', -0.676, 0.1307),
  ('cabinet', 2, 'spread_width', -1.716, 0.3603),
  ('cabinet', 2, 'standoff', 0.7661, 0.1775),
  ('cabinet', 2, 'tilt_deg', 89.81, 0.6369),
  ('cabinet', 2, 'wall_offset', 1.02, 1.038),
  ('cabinet', 2, 'width', -1.49, 0.5228),
  ('cabinet', 2, 'z_max', 0.8217, 0.1853),
  ('cabinet', 2, 'z_min', 0.6635, 0.3101);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.1442, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'aspect', 0.8403, 0.5382),
  ('cabinet', 3, 'behind', 0.5194, 0.2053),
  ('cabinet', 3, 'corner_offset', 0.3494, 0.2564),
  ('cabinet', 3, 'edge_concave', 0.542, 0.2602),
  ('cabinet', 3, 'edge_convex', 0.3237, 0.1733),
  ('cabinet', 3, 'edge_free', 0.1412, 0.06151),
  ('cabinet', 3, 'edge_free_top', 0.7763, 0.1737),
  ('cabinet', 3, 'edge_unseen', -0.003009, 0.03),
  ('cabinet', 3, 'headroom', 0.7602, 0.264),
  ('cabinet', 3, 'height', 1.071, 0.2749),
  ('cabinet', 3, 'lift', -0.05647, 0.04067),
  ('cabinet', 3, 'rectangularity', 0.7924, 0.08658),
  ('cabinet', 3, 'spread_length', 0.181, 0.2997),
  ('cabinet', 3, 'spread_width', -0.6814, 0.1351),
  ('cabinet', 3, 'standoff', 1.197, 0.2888),
  ('cabinet', 3, 'tilt_deg', 90.05, 0.4501),
  ('cabinet', 3, 'wall_offset', 1.778, 0.5005),
  ('cabinet', 3, 'width', -0.495, 0.1135),
  ('cabinet', 3, 'z_max', 1.995, 0.1969),
  ('cabinet', 3, 'z_min', 0.1715, 0.2711);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.1878, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'aspect', 0.7406, 0.3653),
  ('cabinet', 4, 'behind', 0.2998, 0.1808),
  ('cabinet', 4, 'corner_offset', 1.466, 0.5781),
  ('cabinet', 4, 'edge_concave', 0.3065, 0.1909),
  ('cabinet', 4, 'edge_convex', 0.08714, 0.1856),
  ('cabinet', 4, 'edge_free', 0.5398, 0.1817),
  ('cabinet', 4, 'edge_free_top', 0.9848, 0.03767),
  ('cabinet', 4, 'edge_unseen', -0.004103, 0.03),
  ('cabinet', 4, 'headroom', 0.8571, 0.3499),
  ('cabinet', 4, 'height', 1.174, 0.2461),
  ('cabinet', 4, 'lift', -0.03807, 0.025),
  ('cabinet', 4, 'rectangularity', 0.8892, 0.08862),
  ('cabinet', 4, 'spread_length', 0.3482, 0.3218),
  ('cabinet', 4, 'spread_width', -0.4088, 0.2007),
  ('cabinet', 4, 'standoff', 0.543, 0.07333),
  ('cabinet', 4, 'tilt_deg', 90.06, 0.4503),
  ('cabinet', 4, 'wall_offset', 0.5118, 0.05888),
  ('cabinet', 4, 'width', -0.3339, 0.49),
  ('cabinet', 4, 'z_max', 1.854, 0.1182),
  ('cabinet', 4, 'z_min', 0.0101, 0.1031);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.09142, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'aspect', 0.6708, 0.2592),
  ('cabinet', 5, 'behind', 0.6576, 0.08583),
  ('cabinet', 5, 'corner_offset', 0.3012, 0.05427),
  ('cabinet', 5, 'edge_concave', 0.5107, 0.1783),
  ('cabinet', 5, 'edge_convex', 0.3063, 0.08082),
  ('cabinet', 5, 'edge_free', 0.1458, 0.1247),
  ('cabinet', 5, 'edge_free_top', 0.7489, 0.08883),
  ('cabinet', 5, 'edge_unseen', 0.0869, 0.1533),
  ('cabinet', 5, 'headroom', 1.863, 0.282),
  ('cabinet', 5, 'height', 0.9187, 0.1499),
  ('cabinet', 5, 'lift', -0.04026, 0.025),
  ('cabinet', 5, 'rectangularity', 0.6825, 0.08423),
  ('cabinet', 5, 'spread_length', -0.2559, 0.3155),
  ('cabinet', 5, 'spread_width', -0.6591, 0.09225),
  ('cabinet', 5, 'standoff', 0.7395, 0.1056),
  ('cabinet', 5, 'tilt_deg', -0.06632, 0.45),
  ('cabinet', 5, 'wall_offset', 1.127, 0.2755),
  ('cabinet', 5, 'width', -0.5485, 0.08891),
  ('cabinet', 5, 'z_max', 0.9011, 0.1495),
  ('cabinet', 5, 'z_min', 0.9255, 0.1466);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.06343, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'aspect', 0.5104, 0.3614),
  ('cabinet', 6, 'behind', 0.6154, 0.08668),
  ('cabinet', 6, 'corner_offset', 1.672, 0.764),
  ('cabinet', 6, 'edge_concave', 0.4202, 0.2341),
  ('cabinet', 6, 'edge_convex', 0.206, 0.1267),
  ('cabinet', 6, 'edge_free', 0.1455, 0.1903),
  ('cabinet', 6, 'edge_free_top', 0.3999, 0.4099),
  ('cabinet', 6, 'edge_unseen', -0.001382, 0.03),
  ('cabinet', 6, 'headroom', 0.1146, 0.3511),
  ('cabinet', 6, 'height', 0.3324, 0.03563),
  ('cabinet', 6, 'lift', -0.02876, 0.02511),
  ('cabinet', 6, 'rectangularity', 0.6748, 0.08972),
  ('cabinet', 6, 'spread_length', -0.5235, 0.05104),
  ('cabinet', 6, 'spread_width', -0.984, 0.2743),
  ('cabinet', 6, 'standoff', 0.8726, 0.1443),
  ('cabinet', 6, 'tilt_deg', 90.05, 0.4501),
  ('cabinet', 6, 'wall_offset', 1.508, 0.9939),
  ('cabinet', 6, 'width', -0.5415, 0.04326),
  ('cabinet', 6, 'z_max', 0.6831, 0.06484),
  ('cabinet', 6, 'z_min', -0.0213, 0.02254);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.1025, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'aspect', 0.5521, 0.3322),
  ('cabinet', 7, 'behind', 0.419, 0.1835),
  ('cabinet', 7, 'corner_offset', 1.538, 0.7826),
  ('cabinet', 7, 'edge_concave', 0.286, 0.2961),
  ('cabinet', 7, 'edge_convex', 0.2167, 0.2014),
  ('cabinet', 7, 'edge_free', 0.4947, 0.2906),
  ('cabinet', 7, 'edge_free_top', 0.9756, 0.03707),
  ('cabinet', 7, 'edge_unseen', 0.09903, 0.2089),
  ('cabinet', 7, 'headroom', 0.5321, 0.7417),
  ('cabinet', 7, 'height', 0.6946, 0.1407),
  ('cabinet', 7, 'lift', -0.04127, 0.025),
  ('cabinet', 7, 'rectangularity', 0.7881, 0.1605),
  ('cabinet', 7, 'spread_length', -0.09988, 0.2185),
  ('cabinet', 7, 'spread_width', -0.3996, 0.5047),
  ('cabinet', 7, 'standoff', 0.5504, 0.09146),
  ('cabinet', 7, 'tilt_deg', 90.09, 0.45),
  ('cabinet', 7, 'wall_offset', 0.5078, 0.05758),
  ('cabinet', 7, 'width', -0.3398, 0.3751),
  ('cabinet', 7, 'z_max', 0.9969, 0.1277),
  ('cabinet', 7, 'z_min', 0.0001529, 0.03025);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.07401, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'aspect', 0.4482, 0.1962),
  ('cabinet', 8, 'behind', 0.6339, 0.1267),
  ('cabinet', 8, 'corner_offset', 0.3029, 0.04173),
  ('cabinet', 8, 'edge_concave', 0.9116, 0.07453),
  ('cabinet', 8, 'edge_convex', 0.09242, 0.1769),
  ('cabinet', 8, 'edge_free', 0.2106, 0.07945),
  ('cabinet', 8, 'edge_free_top', 0.8082, 0.1404),
  ('cabinet', 8, 'edge_unseen', 0.003545, 0.03115),
  ('cabinet', 8, 'headroom', 0.779, 0.8588),
  ('cabinet', 8, 'height', 0.6149, 0.1115),
  ('cabinet', 8, 'lift', -0.03229, 0.02501),
  ('cabinet', 8, 'rectangularity', 0.8136, 0.1391),
  ('cabinet', 8, 'spread_length', -0.1534, 0.1979),
  ('cabinet', 8, 'spread_width', -0.7359, 0.1361),
  ('cabinet', 8, 'standoff', 1.061, 0.3845),
  ('cabinet', 8, 'tilt_deg', 90.04, 0.4502),
  ('cabinet', 8, 'wall_offset', 1.367, 0.5968),
  ('cabinet', 8, 'width', -0.5314, 0.09628),
  ('cabinet', 8, 'z_max', 1.125, 0.1637),
  ('cabinet', 8, 'z_min', 0.00622, 0.03055);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.04131, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'aspect', 0.662, 0.3485),
  ('cabinet', 9, 'behind', 0.7547, 0.1692),
  ('cabinet', 9, 'corner_offset', 0.9102, 0.1794),
  ('cabinet', 9, 'edge_concave', 0.5164, 0.1301),
  ('cabinet', 9, 'edge_convex', 0.1855, 0.2125),
  ('cabinet', 9, 'edge_free', 0.2469, 0.178),
  ('cabinet', 9, 'edge_free_top', 0.7427, 0.1031),
  ('cabinet', 9, 'edge_unseen', 0.02617, 0.07468),
  ('cabinet', 9, 'headroom', 0.1708, 0.04849),
  ('cabinet', 9, 'height', 0.5855, 0.0225),
  ('cabinet', 9, 'lift', 0.05317, 0.03838),
  ('cabinet', 9, 'rectangularity', 0.6848, 0.0906),
  ('cabinet', 9, 'spread_length', -0.7421, 0.1672),
  ('cabinet', 9, 'spread_width', -1.472, 0.4247),
  ('cabinet', 9, 'standoff', 0.7396, 0.1126),
  ('cabinet', 9, 'tilt_deg', 0.8347, 1.289),
  ('cabinet', 9, 'wall_offset', 1.163, 0.3085),
  ('cabinet', 9, 'width', -1.25, 0.5047),
  ('cabinet', 9, 'z_max', 0.5842, 0.0225),
  ('cabinet', 9, 'z_min', 0.5844, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.04007, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'aspect', 1.108, 0.7848),
  ('cabinet', 10, 'behind', 0.394, 0.2879),
  ('cabinet', 10, 'corner_offset', 1.033, 0.7358),
  ('cabinet', 10, 'edge_concave', 0.2478, 0.2091),
  ('cabinet', 10, 'edge_convex', 0.07123, 0.1212),
  ('cabinet', 10, 'edge_free', 0.0652, 0.1134),
  ('cabinet', 10, 'edge_free_top', 0.0009039, 0.03),
  ('cabinet', 10, 'edge_unseen', 0.0009518, 0.03),
  ('cabinet', 10, 'headroom', 1.821, 0.6966),
  ('cabinet', 10, 'height', 0.2827, 0.2166),
  ('cabinet', 10, 'lift', -0.03332, 0.025),
  ('cabinet', 10, 'rectangularity', 0.7287, 0.1567),
  ('cabinet', 10, 'spread_length', -0.2382, 0.4341),
  ('cabinet', 10, 'spread_width', -1.68, 0.3988),
  ('cabinet', 10, 'standoff', 0.506, 0.4797),
  ('cabinet', 10, 'tilt_deg', 89.58, 0.9249),
  ('cabinet', 10, 'wall_offset', 1.045, 0.3344),
  ('cabinet', 10, 'width', -1.414, 0.346),
  ('cabinet', 10, 'z_max', 0.6446, 0.5769),
  ('cabinet', 10, 'z_min', -0.01714, 0.02394);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.4 WHERE name = 'aspect';
UPDATE feature SET weight = 0.4 WHERE name = 'behind';
UPDATE feature SET weight = 0.4 WHERE name = 'corner_offset';
UPDATE feature SET weight = 0.4 WHERE name = 'edge_concave';
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
UPDATE object_class SET prior = 0.0458 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0843 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.273 WHERE name = 'wall';
UPDATE object_class SET prior = 0.017 WHERE name = 'table';
UPDATE object_class SET prior = 0.0213 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.0963 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.00394 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0443 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0204 WHERE name = 'door';
UPDATE object_class SET prior = 0.0276 WHERE name = 'window';
UPDATE object_class SET prior = 0.00946 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0667 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.146 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.96 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.564 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 1.44 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.75 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 3.21 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.52 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 0.0552 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.23 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.647 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 0.741 WHERE name = 'wall_in_one_plane';
UPDATE class_constraint SET weight = 0.821 WHERE name = 'cabinet_off_wall';
UPDATE class_constraint SET weight = 0.857 WHERE name = 'window_off_wall';
UPDATE class_constraint SET weight = 2.17 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.9 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 0.878 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.584 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 0.69 WHERE name = 'screen_within_table';
UPDATE class_constraint SET weight = 1.31 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 3.07 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 4.32 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.29 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.0802 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.876 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.01 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 0.929 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.622 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.2 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.21 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 2.98 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.44 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.57 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.08 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.72 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.66 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.164 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.43 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2405 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.896' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.068' WHERE key = 'probability_offset';
