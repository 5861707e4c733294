-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Gaussians, densities and one half of the kinds: 18692 planes of 180 paper-like rooms, seeds from 1; 90 at 2 cm, seeds from 10101; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- The other half of the kinds: 18833 planes of 180 paper-like rooms, seeds from 11001; 90 at 2 cm, seeds from 12001; 66 varied rooms, seeds from 14001; 100 depth-camera frames, seeds from 13001.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 60 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 16330 examples
UPDATE object_class SET prior = 0.2082 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.7307, 0.6081)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4752, 0.2914)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'corner_offset', 0.8508, 1.218)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_concave', 0.3156, 0.324)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_convex', 0.1169, 0.207)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.4485, 0.314)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.5728, 0.4103)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_unseen', 0.04904, 0.1088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'headroom', 0.8146, 0.8556)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 1.031, 0.7339)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'lift', -3.537, 1.98)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.722, 0.1431)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.5916, 0.7444)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.404, 0.6766)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'standoff', 0.4631, 0.4048)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 62.97, 39.31)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'wall_offset', 0.8298, 1.863)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.185, 0.6574)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.29, 0.9482)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7666, 0.7872)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.11367, 1.029),
  ('unknown', 'aspect', 1.11367, 1.24617, 0.9875),
  ('unknown', 'aspect', 1.24617, 1.31855, 0.9266),
  ('unknown', 'aspect', 1.31855, 1.40347, 0.9434),
  ('unknown', 'aspect', 1.40347, 1.6042, 0.8307),
  ('unknown', 'aspect', 1.6042, 1.73856, 0.7879),
  ('unknown', 'aspect', 1.73856, 1.86387, 0.6852),
  ('unknown', 'aspect', 1.86387, 2.28801, 0.5441),
  ('unknown', 'aspect', 2.28801, 3.0226, 0.3098),
  ('unknown', 'aspect', 3.0226, 3.37097, 0.2261),
  ('unknown', 'aspect', 3.37097, 3.98544, 0.232),
  ('unknown', 'aspect', 3.98544, 5.25499, 0.2555),
  ('unknown', 'aspect', 5.25499, 5.29072, 0.319),
  ('unknown', 'aspect', 5.29072, 6.92894, 0.2433),
  ('unknown', 'aspect', 6.92894, 9.13613, 0.08774),
  ('unknown', 'aspect', 9.13613, 12.0464, 0.04339),
  ('unknown', 'aspect', 12.0464, 100, 0.004191);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.0965738, 2.046),
  ('unknown', 'behind', 0.0965738, 0.157393, 0.3967),
  ('unknown', 'behind', 0.157393, 0.193148, 0.3895),
  ('unknown', 'behind', 0.193148, 0.289721, 0.5067),
  ('unknown', 'behind', 0.289721, 0.374449, 0.5738),
  ('unknown', 'behind', 0.374449, 0.386295, 0.6722),
  ('unknown', 'behind', 0.386295, 0.482869, 0.8709),
  ('unknown', 'behind', 0.482869, 0.5, 1.032),
  ('unknown', 'behind', 0.5, 0.579443, 1.007),
  ('unknown', 'behind', 0.579443, 0.604167, 1.314),
  ('unknown', 'behind', 0.604167, 0.676017, 1.44),
  ('unknown', 'behind', 0.676017, 0.680851, 1.592),
  ('unknown', 'behind', 0.680851, 0.746243, 1.701),
  ('unknown', 'behind', 0.746243, 0.77259, 2.2),
  ('unknown', 'behind', 0.77259, 0.798029, 2.078),
  ('unknown', 'behind', 0.798029, 0.869164, 1.473),
  ('unknown', 'behind', 0.869164, 1, 0.04955);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'corner_offset';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'corner_offset', -2, -1.27698, 0.02913),
  ('unknown', 'corner_offset', -1.27698, -0.553968, 0.01233),
  ('unknown', 'corner_offset', -0.553968, -0.0793814, 0.166),
  ('unknown', 'corner_offset', -0.0793814, 0.169049, 0.4233),
  ('unknown', 'corner_offset', 0.169049, 0.179923, 0.7401),
  ('unknown', 'corner_offset', 0.179923, 0.362936, 0.6117),
  ('unknown', 'corner_offset', 0.362936, 0.573586, 0.5216),
  ('unknown', 'corner_offset', 0.573586, 0.864263, 0.3859),
  ('unknown', 'corner_offset', 0.864263, 0.892065, 0.4021),
  ('unknown', 'corner_offset', 0.892065, 1.1513, 0.3798),
  ('unknown', 'corner_offset', 1.1513, 1.55141, 0.2801),
  ('unknown', 'corner_offset', 1.55141, 1.61508, 0.2386),
  ('unknown', 'corner_offset', 1.61508, 2.07965, 0.2061),
  ('unknown', 'corner_offset', 2.07965, 2.3381, 0.1153),
  ('unknown', 'corner_offset', 2.3381, 3.06111, 0.05771),
  ('unknown', 'corner_offset', 3.06111, 3.78413, 0.02597),
  ('unknown', 'corner_offset', 3.78413, 4.50715, 0.01627),
  ('unknown', 'corner_offset', 4.50715, 6, 0.006252);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_concave';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_concave', 0, 0.111111, 3.735),
  ('unknown', 'edge_concave', 0.111111, 0.1875, 0.4525),
  ('unknown', 'edge_concave', 0.1875, 0.222222, 0.6727),
  ('unknown', 'edge_concave', 0.222222, 0.333333, 0.6345),
  ('unknown', 'edge_concave', 0.333333, 0.34375, 1.517),
  ('unknown', 'edge_concave', 0.34375, 0.444444, 1.046),
  ('unknown', 'edge_concave', 0.444444, 0.46875, 0.6214),
  ('unknown', 'edge_concave', 0.46875, 0.555556, 0.8024),
  ('unknown', 'edge_concave', 0.555556, 0.59375, 0.8379),
  ('unknown', 'edge_concave', 0.59375, 0.666667, 0.7729),
  ('unknown', 'edge_concave', 0.666667, 0.777778, 0.4786),
  ('unknown', 'edge_concave', 0.777778, 0.78125, 0.2314),
  ('unknown', 'edge_concave', 0.78125, 0.888889, 0.2294),
  ('unknown', 'edge_concave', 0.888889, 1, 0.7536);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_convex';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_convex', 0, 0.0908333, 7.854),
  ('unknown', 'edge_convex', 0.0908333, 0.181667, 0.2994),
  ('unknown', 'edge_convex', 0.181667, 0.25, 0.5678),
  ('unknown', 'edge_convex', 0.25, 0.2725, 0.4019),
  ('unknown', 'edge_convex', 0.2725, 0.363333, 0.5827),
  ('unknown', 'edge_convex', 0.363333, 0.4375, 0.5546),
  ('unknown', 'edge_convex', 0.4375, 0.454167, 0.4949),
  ('unknown', 'edge_convex', 0.454167, 0.545, 0.5424),
  ('unknown', 'edge_convex', 0.545, 0.635833, 0.268),
  ('unknown', 'edge_convex', 0.635833, 0.726667, 0.1788),
  ('unknown', 'edge_convex', 0.726667, 0.8175, 0.09965),
  ('unknown', 'edge_convex', 0.8175, 1, 0.05683);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free', 0, 0.111111, 1.898),
  ('unknown', 'edge_free', 0.111111, 0.129941, 0.5931),
  ('unknown', 'edge_free', 0.129941, 0.222222, 0.635),
  ('unknown', 'edge_free', 0.222222, 0.293642, 0.7394),
  ('unknown', 'edge_free', 0.293642, 0.333333, 0.85),
  ('unknown', 'edge_free', 0.333333, 0.404876, 1.067),
  ('unknown', 'edge_free', 0.404876, 0.444444, 1.163),
  ('unknown', 'edge_free', 0.444444, 0.49307, 1.351),
  ('unknown', 'edge_free', 0.49307, 0.555556, 1.247),
  ('unknown', 'edge_free', 0.555556, 0.58988, 0.9883),
  ('unknown', 'edge_free', 0.58988, 0.666667, 0.8933),
  ('unknown', 'edge_free', 0.666667, 0.716344, 0.8355),
  ('unknown', 'edge_free', 0.716344, 0.777778, 0.7757),
  ('unknown', 'edge_free', 0.777778, 0.888889, 0.5163),
  ('unknown', 'edge_free', 0.888889, 0.900085, 0.5823),
  ('unknown', 'edge_free', 0.900085, 1, 1.114);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free_top', 0, 0.111111, 2.383),
  ('unknown', 'edge_free_top', 0.111111, 0.222222, 0.3884),
  ('unknown', 'edge_free_top', 0.222222, 0.296866, 0.3233),
  ('unknown', 'edge_free_top', 0.296866, 0.333333, 0.4105),
  ('unknown', 'edge_free_top', 0.333333, 0.444444, 0.3438),
  ('unknown', 'edge_free_top', 0.444444, 0.555556, 0.4237),
  ('unknown', 'edge_free_top', 0.555556, 0.584456, 0.4442),
  ('unknown', 'edge_free_top', 0.584456, 0.666667, 0.4437),
  ('unknown', 'edge_free_top', 0.666667, 0.777778, 0.5443),
  ('unknown', 'edge_free_top', 0.777778, 0.79589, 0.7249),
  ('unknown', 'edge_free_top', 0.79589, 0.888889, 0.7048),
  ('unknown', 'edge_free_top', 0.888889, 0.936147, 0.9673),
  ('unknown', 'edge_free_top', 0.936147, 1, 5.224);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_unseen';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_unseen', 0, 0.0356685, 21.79),
  ('unknown', 'edge_unseen', 0.0356685, 0.054148, 0.8466),
  ('unknown', 'edge_unseen', 0.054148, 0.108296, 0.7908),
  ('unknown', 'edge_unseen', 0.108296, 0.162444, 0.6505),
  ('unknown', 'edge_unseen', 0.162444, 0.194894, 0.5515),
  ('unknown', 'edge_unseen', 0.194894, 0.216592, 0.5408),
  ('unknown', 'edge_unseen', 0.216592, 0.27074, 0.3967),
  ('unknown', 'edge_unseen', 0.27074, 0.324888, 0.4692),
  ('unknown', 'edge_unseen', 0.324888, 0.379036, 0.4036),
  ('unknown', 'edge_unseen', 0.379036, 0.433184, 0.2892),
  ('unknown', 'edge_unseen', 0.433184, 0.487332, 0.1021),
  ('unknown', 'edge_unseen', 0.487332, 1, 0.0187);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'headroom';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'headroom', -2, -0.245066, 0.004845),
  ('unknown', 'headroom', -0.245066, -0.0140054, 0.5107),
  ('unknown', 'headroom', -0.0140054, 0.0345788, 1.94),
  ('unknown', 'headroom', 0.0345788, 0.0863793, 0.5589),
  ('unknown', 'headroom', 0.0863793, 0.194881, 0.7647),
  ('unknown', 'headroom', 0.194881, 0.338448, 0.768),
  ('unknown', 'headroom', 0.338448, 0.417824, 0.7909),
  ('unknown', 'headroom', 0.417824, 0.554663, 0.3642),
  ('unknown', 'headroom', 0.554663, 0.749269, 0.2296),
  ('unknown', 'headroom', 0.749269, 1.08071, 0.1626),
  ('unknown', 'headroom', 1.08071, 1.16912, 0.1513),
  ('unknown', 'headroom', 1.16912, 1.41216, 0.1577),
  ('unknown', 'headroom', 1.41216, 1.73943, 0.2196),
  ('unknown', 'headroom', 1.73943, 2.07505, 0.3096),
  ('unknown', 'headroom', 2.07505, 2.10825, 0.2355),
  ('unknown', 'headroom', 2.10825, 2.40649, 0.2372),
  ('unknown', 'headroom', 2.40649, 2.73794, 0.09594),
  ('unknown', 'headroom', 2.73794, 4, 0.006372);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0521866, 0.01186),
  ('unknown', 'height', 0.0521866, 0.218728, 0.6344),
  ('unknown', 'height', 0.218728, 0.37491, 0.5958),
  ('unknown', 'height', 0.37491, 0.406617, 0.5739),
  ('unknown', 'height', 0.406617, 0.564646, 0.691),
  ('unknown', 'height', 0.564646, 0.697634, 0.3632),
  ('unknown', 'height', 0.697634, 0.792461, 0.6658),
  ('unknown', 'height', 0.792461, 0.916569, 0.884),
  ('unknown', 'height', 0.916569, 1.02036, 0.5283),
  ('unknown', 'height', 1.02036, 1.2195, 0.29),
  ('unknown', 'height', 1.2195, 1.34308, 0.2756),
  ('unknown', 'height', 1.34308, 1.58114, 0.3241),
  ('unknown', 'height', 1.58114, 1.66581, 0.3378),
  ('unknown', 'height', 1.66581, 1.98853, 0.1591),
  ('unknown', 'height', 1.98853, 2.17069, 0.1681),
  ('unknown', 'height', 2.17069, 2.31125, 0.2382),
  ('unknown', 'height', 2.31125, 2.63398, 0.1373),
  ('unknown', 'height', 2.63398, 2.9567, 0.07759),
  ('unknown', 'height', 2.9567, 4, 0.008646);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'lift';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'lift', 0.005, 0.00577935, 3.07),
  ('unknown', 'lift', 0.00577935, 0.00974266, 0.03557),
  ('unknown', 'lift', 0.00974266, 0.0189839, 0.112),
  ('unknown', 'lift', 0.0189839, 0.0203038, 0.2264),
  ('unknown', 'lift', 0.0203038, 0.0369907, 0.09143),
  ('unknown', 'lift', 0.0369907, 0.0677604, 0.09774),
  ('unknown', 'lift', 0.0677604, 0.0720775, 0.1878),
  ('unknown', 'lift', 0.0720775, 0.140445, 0.07464),
  ('unknown', 'lift', 0.140445, 0.251888, 0.08502),
  ('unknown', 'lift', 0.251888, 0.273662, 0.09087),
  ('unknown', 'lift', 0.273662, 0.533239, 0.1433),
  ('unknown', 'lift', 0.533239, 0.560325, 0.1362),
  ('unknown', 'lift', 0.560325, 1.03903, 0.0871),
  ('unknown', 'lift', 1.03903, 2.02459, 0.07822),
  ('unknown', 'lift', 2.02459, 2.5, 0.02839);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.290597, 0.03359),
  ('unknown', 'rectangularity', 0.290597, 0.365188, 0.1766),
  ('unknown', 'rectangularity', 0.365188, 0.43978, 0.3062),
  ('unknown', 'rectangularity', 0.43978, 0.514372, 0.6039),
  ('unknown', 'rectangularity', 0.514372, 0.538196, 0.8524),
  ('unknown', 'rectangularity', 0.538196, 0.588964, 1.255),
  ('unknown', 'rectangularity', 0.588964, 0.618785, 1.577),
  ('unknown', 'rectangularity', 0.618785, 0.663556, 1.753),
  ('unknown', 'rectangularity', 0.663556, 0.678396, 2.269),
  ('unknown', 'rectangularity', 0.678396, 0.725791, 2.353),
  ('unknown', 'rectangularity', 0.725791, 0.738148, 2.741),
  ('unknown', 'rectangularity', 0.738148, 0.763998, 2.929),
  ('unknown', 'rectangularity', 0.763998, 0.800936, 3.014),
  ('unknown', 'rectangularity', 0.800936, 0.81274, 2.974),
  ('unknown', 'rectangularity', 0.81274, 0.83925, 2.871),
  ('unknown', 'rectangularity', 0.83925, 0.882755, 2.547),
  ('unknown', 'rectangularity', 0.882755, 0.887331, 2.288),
  ('unknown', 'rectangularity', 0.887331, 0.961923, 1.264),
  ('unknown', 'rectangularity', 0.961923, 1, 0.1776);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.141572, 0.002719),
  ('unknown', 'spread_length', 0.141572, 0.219563, 0.1458),
  ('unknown', 'spread_length', 0.219563, 0.24871, 0.3197),
  ('unknown', 'spread_length', 0.24871, 0.304462, 0.5613),
  ('unknown', 'spread_length', 0.304462, 0.340516, 0.7771),
  ('unknown', 'spread_length', 0.340516, 0.351669, 0.6688),
  ('unknown', 'spread_length', 0.351669, 0.437112, 0.5154),
  ('unknown', 'spread_length', 0.437112, 0.528102, 0.4647),
  ('unknown', 'spread_length', 0.528102, 0.56339, 0.3484),
  ('unknown', 'spread_length', 0.56339, 0.745052, 0.3992),
  ('unknown', 'spread_length', 0.745052, 0.819026, 0.4292),
  ('unknown', 'spread_length', 0.819026, 1.01138, 0.3355),
  ('unknown', 'spread_length', 1.01138, 1.27021, 0.4137),
  ('unknown', 'spread_length', 1.27021, 1.31535, 0.4527),
  ('unknown', 'spread_length', 1.31535, 1.96996, 0.177),
  ('unknown', 'spread_length', 1.96996, 3.05518, 0.02514),
  ('unknown', 'spread_length', 3.05518, 4.73823, 0.02013),
  ('unknown', 'spread_length', 4.73823, 7.34845, 0.02428),
  ('unknown', 'spread_length', 7.34845, 40, 0.005518);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.0784909, 0.0003129),
  ('unknown', 'spread_width', 0.0784909, 0.0800095, 0.138),
  ('unknown', 'spread_width', 0.0800095, 0.119815, 0.2657),
  ('unknown', 'spread_width', 0.119815, 0.122776, 0.2752),
  ('unknown', 'spread_width', 0.122776, 0.158522, 0.4106),
  ('unknown', 'spread_width', 0.158522, 0.187906, 0.6558),
  ('unknown', 'spread_width', 0.187906, 0.192048, 0.8486),
  ('unknown', 'spread_width', 0.192048, 0.20834, 1.125),
  ('unknown', 'spread_width', 0.20834, 0.232583, 1.008),
  ('unknown', 'spread_width', 0.232583, 0.276457, 0.6441),
  ('unknown', 'spread_width', 0.276457, 0.300403, 0.5635),
  ('unknown', 'spread_width', 0.300403, 0.348691, 0.43),
  ('unknown', 'spread_width', 0.348691, 0.469894, 0.2967),
  ('unknown', 'spread_width', 0.469894, 0.530668, 0.1872),
  ('unknown', 'spread_width', 0.530668, 0.735012, 0.2066),
  ('unknown', 'spread_width', 0.735012, 1.14971, 0.03139),
  ('unknown', 'spread_width', 1.14971, 1.79839, 0.01465),
  ('unknown', 'spread_width', 1.79839, 2.81306, 0.01418),
  ('unknown', 'spread_width', 2.81306, 4.40022, 0.01757),
  ('unknown', 'spread_width', 4.40022, 20, 0.006045);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'standoff';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'standoff', -0.05, -0.0193579, 0.1844),
  ('unknown', 'standoff', -0.0193579, 0.0257073, 2.316),
  ('unknown', 'standoff', 0.0257073, 0.119571, 1.214),
  ('unknown', 'standoff', 0.119571, 0.146065, 2.741),
  ('unknown', 'standoff', 0.146065, 0.202529, 0.6433),
  ('unknown', 'standoff', 0.202529, 0.297509, 1.166),
  ('unknown', 'standoff', 0.297509, 0.311488, 1.051),
  ('unknown', 'standoff', 0.311488, 0.401868, 1.071),
  ('unknown', 'standoff', 0.401868, 0.476911, 0.8251),
  ('unknown', 'standoff', 0.476911, 0.539186, 0.7857),
  ('unknown', 'standoff', 0.539186, 0.642334, 0.5442),
  ('unknown', 'standoff', 0.642334, 0.786802, 0.384),
  ('unknown', 'standoff', 0.786802, 0.807757, 0.4171),
  ('unknown', 'standoff', 0.807757, 0.97318, 0.3468),
  ('unknown', 'standoff', 0.97318, 1.10408, 0.3543),
  ('unknown', 'standoff', 1.10408, 1.1386, 0.3054),
  ('unknown', 'standoff', 1.1386, 1.30403, 0.3398),
  ('unknown', 'standoff', 1.30403, 1.46945, 0.223),
  ('unknown', 'standoff', 1.46945, 1.5, 0.2053);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 0.498873, 0.2083),
  ('unknown', 'tilt_deg', 0.498873, 2.13648, 0.07179),
  ('unknown', 'tilt_deg', 2.13648, 10, 0.006607),
  ('unknown', 'tilt_deg', 10, 20, 0.001497),
  ('unknown', 'tilt_deg', 20, 30, 0.0002752),
  ('unknown', 'tilt_deg', 30, 40, 0.0003203),
  ('unknown', 'tilt_deg', 40, 50, 0.0002567),
  ('unknown', 'tilt_deg', 50, 60, 0.0001415),
  ('unknown', 'tilt_deg', 60, 70, 0.0004329),
  ('unknown', 'tilt_deg', 70, 79.922, 0.003086),
  ('unknown', 'tilt_deg', 79.922, 88.3848, 0.01347),
  ('unknown', 'tilt_deg', 88.3848, 89.423, 0.1196),
  ('unknown', 'tilt_deg', 89.423, 89.7595, 0.5187),
  ('unknown', 'tilt_deg', 89.7595, 90, 1.056);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'wall_offset';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'wall_offset', -2, -1.25057, 0.02076),
  ('unknown', 'wall_offset', -1.25057, -0.501133, 0.003932),
  ('unknown', 'wall_offset', -0.501133, 0.0183094, 0.1638),
  ('unknown', 'wall_offset', 0.0183094, 0.124523, 1.063),
  ('unknown', 'wall_offset', 0.124523, 0.248301, 0.8644),
  ('unknown', 'wall_offset', 0.248301, 0.259504, 0.7771),
  ('unknown', 'wall_offset', 0.259504, 0.454785, 0.58),
  ('unknown', 'wall_offset', 0.454785, 0.829008, 0.2921),
  ('unknown', 'wall_offset', 0.829008, 0.997735, 0.2283),
  ('unknown', 'wall_offset', 0.997735, 1.27395, 0.2669),
  ('unknown', 'wall_offset', 1.27395, 1.70033, 0.258),
  ('unknown', 'wall_offset', 1.70033, 1.74717, 0.2204),
  ('unknown', 'wall_offset', 1.74717, 2.35075, 0.1678),
  ('unknown', 'wall_offset', 2.35075, 2.4966, 0.1116),
  ('unknown', 'wall_offset', 2.4966, 3.24604, 0.06216),
  ('unknown', 'wall_offset', 3.24604, 3.99547, 0.03134),
  ('unknown', 'wall_offset', 3.99547, 4.7449, 0.01973),
  ('unknown', 'wall_offset', 4.7449, 6, 0.008166);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.093363, 0.002959),
  ('unknown', 'width', 0.093363, 0.143458, 0.1856),
  ('unknown', 'width', 0.143458, 0.154534, 0.3434),
  ('unknown', 'width', 0.154534, 0.195706, 0.468),
  ('unknown', 'width', 0.195706, 0.220433, 0.7574),
  ('unknown', 'width', 0.220433, 0.226126, 0.8382),
  ('unknown', 'width', 0.226126, 0.255582, 0.8967),
  ('unknown', 'width', 0.255582, 0.298826, 0.7117),
  ('unknown', 'width', 0.298826, 0.338709, 0.7234),
  ('unknown', 'width', 0.338709, 0.349897, 0.6403),
  ('unknown', 'width', 0.349897, 0.451207, 0.4354),
  ('unknown', 'width', 0.451207, 0.520449, 0.3461),
  ('unknown', 'width', 0.520449, 0.658462, 0.2654),
  ('unknown', 'width', 0.658462, 0.799703, 0.2792),
  ('unknown', 'width', 0.799703, 1.22879, 0.05851),
  ('unknown', 'width', 1.22879, 1.88812, 0.01524),
  ('unknown', 'width', 1.88812, 2.90122, 0.01813),
  ('unknown', 'width', 2.90122, 4.45791, 0.018),
  ('unknown', 'width', 4.45791, 12, 0.009684);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.071953, 0.01178),
  ('unknown', 'z_max', 0.071953, 0.389057, 0.3298),
  ('unknown', 'z_max', 0.389057, 0.508403, 0.5628),
  ('unknown', 'z_max', 0.508403, 0.632805, 0.3537),
  ('unknown', 'z_max', 0.632805, 0.766776, 0.8252),
  ('unknown', 'z_max', 0.766776, 0.882562, 0.9671),
  ('unknown', 'z_max', 0.882562, 0.944852, 0.7059),
  ('unknown', 'z_max', 0.944852, 1.05671, 0.5905),
  ('unknown', 'z_max', 1.05671, 1.3813, 0.2915),
  ('unknown', 'z_max', 1.3813, 1.49329, 0.1479),
  ('unknown', 'z_max', 1.49329, 1.81775, 0.1647),
  ('unknown', 'z_max', 1.81775, 2.03482, 0.2697),
  ('unknown', 'z_max', 2.03482, 2.2542, 0.3975),
  ('unknown', 'z_max', 2.2542, 2.3211, 0.3539),
  ('unknown', 'z_max', 2.3211, 2.69065, 0.1599),
  ('unknown', 'z_max', 2.69065, 3.1271, 0.06003),
  ('unknown', 'z_max', 3.1271, 3.56355, 0.01018),
  ('unknown', 'z_max', 3.56355, 4, 0.04848);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.130071, 0.05406),
  ('unknown', 'z_min', -0.130071, -0.0143153, 0.8098),
  ('unknown', 'z_min', -0.0143153, 0.0360941, 2.164),
  ('unknown', 'z_min', 0.0360941, 0.239858, 0.5334),
  ('unknown', 'z_min', 0.239858, 0.247409, 0.2951),
  ('unknown', 'z_min', 0.247409, 0.609788, 0.2848),
  ('unknown', 'z_min', 0.609788, 0.63137, 0.3227),
  ('unknown', 'z_min', 0.63137, 0.757453, 0.8826),
  ('unknown', 'z_min', 0.757453, 0.891207, 0.8327),
  ('unknown', 'z_min', 0.891207, 0.979717, 0.5425),
  ('unknown', 'z_min', 0.979717, 1.2239, 0.2566),
  ('unknown', 'z_min', 1.2239, 1.34965, 0.2928),
  ('unknown', 'z_min', 1.34965, 1.71958, 0.1241),
  ('unknown', 'z_min', 1.71958, 2.07478, 0.08003),
  ('unknown', 'z_min', 2.07478, 2.0895, 0.07741),
  ('unknown', 'z_min', 2.0895, 2.45943, 0.1752),
  ('unknown', 'z_min', 2.45943, 2.82936, 0.09969),
  ('unknown', 'z_min', 2.82936, 4, 0.007473);
DELETE FROM class_kind WHERE class = 'unknown';
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.01138, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'aspect', 0.373, 0.2279),
  ('unknown', 1, 'behind', 0.6951, 0.1084),
  ('unknown', 1, 'corner_offset', 1.601, 0.6275),
  ('unknown', 1, 'edge_concave', 0.4696, 0.232),
  ('unknown', 1, 'edge_convex', 0.1768, 0.1666),
  ('unknown', 1, 'edge_free', 0.4704, 0.19),
  ('unknown', 1, 'edge_free_top', 0.7988, 0.2347),
  ('unknown', 1, 'edge_unseen', 0.004195, 0.03009),
  ('unknown', 1, 'headroom', 1.512, 1.202),
  ('unknown', 1, 'height', 0.1783, 0.02251),
  ('unknown', 1, 'lift', -3.549, 0.6372),
  ('unknown', 1, 'rectangularity', 0.7308, 0.1203),
  ('unknown', 1, 'spread_length', -1.187, 0.1995),
  ('unknown', 1, 'spread_width', -1.786, 0.1841),
  ('unknown', 1, 'standoff', 0.5859, 0.1926),
  ('unknown', 1, 'tilt_deg', 89.17, 1.084),
  ('unknown', 1, 'wall_offset', 0.8606, 0.3617),
  ('unknown', 1, 'width', -1.467, 0.2948),
  ('unknown', 1, 'z_max', 0.3347, 0.02414),
  ('unknown', 1, 'z_min', -0.005799, 0.02276);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.01894, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'aspect', 0.5889, 0.4031),
  ('unknown', 2, 'behind', 0.7447, 0.0764),
  ('unknown', 2, 'corner_offset', 0.1762, 0.1179),
  ('unknown', 2, 'edge_concave', 0.4811, 0.1926),
  ('unknown', 2, 'edge_convex', 0.06076, 0.14),
  ('unknown', 2, 'edge_free', 0.2376, 0.07792),
  ('unknown', 2, 'edge_free_top', 0.5652, 0.1355),
  ('unknown', 2, 'edge_unseen', 0.06154, 0.07267),
  ('unknown', 2, 'headroom', 0.9751, 0.7988),
  ('unknown', 2, 'height', 1.011, 0.2988),
  ('unknown', 2, 'lift', -1.008, 0.4189),
  ('unknown', 2, 'rectangularity', 0.6564, 0.1154),
  ('unknown', 2, 'spread_length', -0.2837, 0.2322),
  ('unknown', 2, 'spread_width', -1.013, 0.389),
  ('unknown', 2, 'standoff', 0.445, 0.1023),
  ('unknown', 2, 'tilt_deg', 5.064, 1.418),
  ('unknown', 2, 'wall_offset', 0.8411, 0.6212),
  ('unknown', 2, 'width', -0.9115, 0.2672),
  ('unknown', 2, 'z_max', 1.054, 0.2939),
  ('unknown', 2, 'z_min', 1.013, 0.2846);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.01626, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'aspect', 0.5634, 0.231),
  ('unknown', 3, 'behind', 0.7418, 0.04514),
  ('unknown', 3, 'corner_offset', 0.1783, 0.1044),
  ('unknown', 3, 'edge_concave', 0.6521, 0.1668),
  ('unknown', 3, 'edge_convex', 0.04629, 0.07013),
  ('unknown', 3, 'edge_free', 0.3653, 0.115),
  ('unknown', 3, 'edge_free_top', 0.5061, 0.2182),
  ('unknown', 3, 'edge_unseen', 0.001774, 0.03),
  ('unknown', 3, 'headroom', 0.7375, 0.576),
  ('unknown', 3, 'height', 1.144, 0.4021),
  ('unknown', 3, 'lift', -3.798, 1.993),
  ('unknown', 3, 'rectangularity', 0.6614, 0.05042),
  ('unknown', 3, 'spread_length', -0.9185, 0.2196),
  ('unknown', 3, 'spread_width', -1.377, 0.1609),
  ('unknown', 3, 'standoff', 0.3544, 0.1256),
  ('unknown', 3, 'tilt_deg', 88.5, 1.817),
  ('unknown', 3, 'wall_offset', 1.467, 0.4769),
  ('unknown', 3, 'width', -1.198, 0.2348),
  ('unknown', 3, 'z_max', 1.357, 0.3619),
  ('unknown', 3, 'z_min', 0.9264, 0.3049);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.007383, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'aspect', 1.993, 0.5816),
  ('unknown', 4, 'behind', 0.2012, 0.1966),
  ('unknown', 4, 'corner_offset', 0.4328, 0.6995),
  ('unknown', 4, 'edge_concave', 0.2667, 0.2966),
  ('unknown', 4, 'edge_convex', 0.1828, 0.2664),
  ('unknown', 4, 'edge_free', 0.3633, 0.197),
  ('unknown', 4, 'edge_free_top', 0.4478, 0.3413),
  ('unknown', 4, 'edge_unseen', 0.127, 0.1504),
  ('unknown', 4, 'headroom', 0.8056, 0.4865),
  ('unknown', 4, 'height', 1.199, 0.2059),
  ('unknown', 4, 'lift', -3.838, 2.883),
  ('unknown', 4, 'rectangularity', 0.6816, 0.0801),
  ('unknown', 4, 'spread_length', -0.3188, 0.6834),
  ('unknown', 4, 'spread_width', -2.19, 0.1722),
  ('unknown', 4, 'standoff', 0.1528, 0.1669),
  ('unknown', 4, 'tilt_deg', 89.61, 1.053),
  ('unknown', 4, 'wall_offset', 0.3072, 0.6635),
  ('unknown', 4, 'width', -1.881, 0.2574),
  ('unknown', 4, 'z_max', 1.798, 0.1934),
  ('unknown', 4, 'z_min', 0.5047, 0.3434);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.02083, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'aspect', 0.313, 0.2332),
  ('unknown', 5, 'behind', 0.03653, 0.06692),
  ('unknown', 5, 'corner_offset', 1.61, 0.9179),
  ('unknown', 5, 'edge_concave', 0.1757, 0.08531),
  ('unknown', 5, 'edge_convex', 0.002036, 0.03075),
  ('unknown', 5, 'edge_free', -0.001961, 0.03008),
  ('unknown', 5, 'edge_free_top', 0.001033, 0.03006),
  ('unknown', 5, 'edge_unseen', 0.07092, 0.1196),
  ('unknown', 5, 'headroom', 0.794, 0.2302),
  ('unknown', 5, 'height', 1.614, 0.07644),
  ('unknown', 5, 'lift', -0.8624, 0.8625),
  ('unknown', 5, 'rectangularity', 0.7975, 0.06662),
  ('unknown', 5, 'spread_length', -0.6007, 0.2358),
  ('unknown', 5, 'spread_width', -1.12, 0.2746),
  ('unknown', 5, 'standoff', 0.0164, 0.01231),
  ('unknown', 5, 'tilt_deg', 89.68, 0.4501),
  ('unknown', 5, 'wall_offset', 0.1198, 0.07349),
  ('unknown', 5, 'width', -0.8572, 0.4626),
  ('unknown', 5, 'z_max', 1.976, 0.1555),
  ('unknown', 5, 'z_min', 1.328, 0.06654);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.0109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'aspect', 0.4038, 0.2849),
  ('unknown', 6, 'behind', 0.6042, 0.1765),
  ('unknown', 6, 'corner_offset', 1.22, 0.8364),
  ('unknown', 6, 'edge_concave', 0.5936, 0.174),
  ('unknown', 6, 'edge_convex', 0.2315, 0.1636),
  ('unknown', 6, 'edge_free', 0.487, 0.1219),
  ('unknown', 6, 'edge_free_top', 0.7251, 0.1838),
  ('unknown', 6, 'edge_unseen', 0.009349, 0.03697),
  ('unknown', 6, 'headroom', 0.0945, 0.1392),
  ('unknown', 6, 'height', 0.2064, 0.03998),
  ('unknown', 6, 'lift', -3.549, 0.6467),
  ('unknown', 6, 'rectangularity', 0.5465, 0.1908),
  ('unknown', 6, 'spread_length', -0.8506, 0.1644),
  ('unknown', 6, 'spread_width', -1.349, 0.3547),
  ('unknown', 6, 'standoff', 0.7078, 0.7712),
  ('unknown', 6, 'tilt_deg', 88.6, 2.417),
  ('unknown', 6, 'wall_offset', 1.301, 1.047),
  ('unknown', 6, 'width', -1.017, 0.289),
  ('unknown', 6, 'z_max', 0.4294, 0.05292),
  ('unknown', 6, 'z_min', -0.02912, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.01415, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'aspect', 0.3822, 0.5386),
  ('unknown', 7, 'behind', 0.7798, 0.1267),
  ('unknown', 7, 'corner_offset', 0.5412, 0.7356),
  ('unknown', 7, 'edge_concave', 0.4705, 0.09306),
  ('unknown', 7, 'edge_convex', -0.002398, 0.03),
  ('unknown', 7, 'edge_free', 0.3933, 0.1301),
  ('unknown', 7, 'edge_free_top', 0.3605, 0.1757),
  ('unknown', 7, 'edge_unseen', 0.01743, 0.03575),
  ('unknown', 7, 'headroom', 0.02295, 0.05426),
  ('unknown', 7, 'height', 0.3417, 0.07844),
  ('unknown', 7, 'lift', -3.567, 0.6842),
  ('unknown', 7, 'rectangularity', 0.4185, 0.1359),
  ('unknown', 7, 'spread_length', -0.3778, 0.1191),
  ('unknown', 7, 'spread_width', -1.337, 0.6808),
  ('unknown', 7, 'standoff', 0.5233, 0.22),
  ('unknown', 7, 'tilt_deg', 88.35, 1.505),
  ('unknown', 7, 'wall_offset', 1.064, 1.155),
  ('unknown', 7, 'width', -0.8154, 0.6037),
  ('unknown', 7, 'z_max', 0.725, 0.1651),
  ('unknown', 7, 'z_min', -0.008115, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.01539, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'aspect', 0.7329, 0.3651),
  ('unknown', 8, 'behind', 0.6869, 0.1654),
  ('unknown', 8, 'corner_offset', 0.9671, 0.8287),
  ('unknown', 8, 'edge_concave', 0.2787, 0.2152),
  ('unknown', 8, 'edge_convex', 0.4147, 0.1971),
  ('unknown', 8, 'edge_free', 0.5615, 0.1441),
  ('unknown', 8, 'edge_free_top', 0.4647, 0.4363),
  ('unknown', 8, 'edge_unseen', 0.08701, 0.1075),
  ('unknown', 8, 'headroom', 0.2845, 0.1395),
  ('unknown', 8, 'height', 0.3867, 0.08059),
  ('unknown', 8, 'lift', -4.952, 0.5745),
  ('unknown', 8, 'rectangularity', 0.6664, 0.1453),
  ('unknown', 8, 'spread_length', -0.824, 0.5371),
  ('unknown', 8, 'spread_width', -1.826, 0.3403),
  ('unknown', 8, 'standoff', 0.6933, 0.5803),
  ('unknown', 8, 'tilt_deg', 87.11, 3.006),
  ('unknown', 8, 'wall_offset', 0.9184, 0.7168),
  ('unknown', 8, 'width', -1.472, 0.1749),
  ('unknown', 8, 'z_max', 0.4505, 0.0486),
  ('unknown', 8, 'z_min', 0.2489, 0.1607);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.01182, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'aspect', 0.3902, 0.2911),
  ('unknown', 9, 'behind', 0.5012, 0.3177),
  ('unknown', 9, 'corner_offset', 0.5036, 0.1509),
  ('unknown', 9, 'edge_concave', 0.003805, 0.03013),
  ('unknown', 9, 'edge_convex', 0.5046, 0.1483),
  ('unknown', 9, 'edge_free', 0.6794, 0.2131),
  ('unknown', 9, 'edge_free_top', 0.5742, 0.1315),
  ('unknown', 9, 'edge_unseen', 0.003093, 0.03),
  ('unknown', 9, 'headroom', 2.047, 0.4275),
  ('unknown', 9, 'height', 0.569, 0.2823),
  ('unknown', 9, 'lift', -1.777, 0.5405),
  ('unknown', 9, 'rectangularity', 0.8402, 0.07603),
  ('unknown', 9, 'spread_length', -1.072, 0.1807),
  ('unknown', 9, 'spread_width', -1.445, 0.3165),
  ('unknown', 9, 'standoff', 0.4616, 0.1109),
  ('unknown', 9, 'tilt_deg', 0.4918, 0.6661),
  ('unknown', 9, 'wall_offset', 0.7008, 0.6066),
  ('unknown', 9, 'width', -1.35, 0.3664),
  ('unknown', 9, 'z_max', 0.5564, 0.2613),
  ('unknown', 9, 'z_min', 0.5815, 0.2988);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.03928, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'aspect', 0.4194, 0.2829),
  ('unknown', 10, 'behind', 0.3413, 0.1172),
  ('unknown', 10, 'corner_offset', 1.484, 0.8221),
  ('unknown', 10, 'edge_concave', 0.5213, 0.1322),
  ('unknown', 10, 'edge_convex', 0.01704, 0.04077),
  ('unknown', 10, 'edge_free', 0.3891, 0.2762),
  ('unknown', 10, 'edge_free_top', 0.4014, 0.264),
  ('unknown', 10, 'edge_unseen', -0.005125, 0.03),
  ('unknown', 10, 'headroom', 0.4723, 0.8665),
  ('unknown', 10, 'height', 0.7631, 0.4685),
  ('unknown', 10, 'lift', -5.146, 0.3315),
  ('unknown', 10, 'rectangularity', 0.6783, 0.09889),
  ('unknown', 10, 'spread_length', -0.5368, 0.5535),
  ('unknown', 10, 'spread_width', -1.256, 0.68),
  ('unknown', 10, 'standoff', 0.219, 0.05788),
  ('unknown', 10, 'tilt_deg', 88.45, 1.136),
  ('unknown', 10, 'wall_offset', 0.2101, 0.05507),
  ('unknown', 10, 'width', -0.9728, 0.6007),
  ('unknown', 10, 'z_max', 1.109, 0.5274),
  ('unknown', 10, 'z_min', 0.4854, 0.4199);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.01539, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'aspect', 0.3136, 0.1768),
  ('unknown', 11, 'behind', 0.2675, 0.2215),
  ('unknown', 11, 'corner_offset', 0.6531, 0.4748),
  ('unknown', 11, 'edge_concave', 0.09641, 0.1421),
  ('unknown', 11, 'edge_convex', 0.007559, 0.03002),
  ('unknown', 11, 'edge_free', 0.3331, 0.3365),
  ('unknown', 11, 'edge_free_top', 0.5746, 0.1209),
  ('unknown', 11, 'edge_unseen', 0.002886, 0.03001),
  ('unknown', 11, 'headroom', 1.986, 0.2099),
  ('unknown', 11, 'height', 0.779, 0.06764),
  ('unknown', 11, 'lift', -3.671, 0.9927),
  ('unknown', 11, 'rectangularity', 0.801, 0.1041),
  ('unknown', 11, 'spread_length', -1.241, 0.1137),
  ('unknown', 11, 'spread_width', -1.466, 0.08851),
  ('unknown', 11, 'standoff', 0.4652, 0.1261),
  ('unknown', 11, 'tilt_deg', 0.4711, 0.5032),
  ('unknown', 11, 'wall_offset', 0.8644, 0.8371),
  ('unknown', 11, 'width', -1.491, 0.07949),
  ('unknown', 11, 'z_max', 0.7794, 0.07194),
  ('unknown', 11, 'z_min', 0.7731, 0.07353);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.02271, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'aspect', 0.3702, 0.2182),
  ('unknown', 12, 'behind', 0.4395, 0.1071),
  ('unknown', 12, 'corner_offset', 1.63, 1.199),
  ('unknown', 12, 'edge_concave', 0.07103, 0.1057),
  ('unknown', 12, 'edge_convex', 0.06899, 0.12),
  ('unknown', 12, 'edge_free', 0.8374, 0.1586),
  ('unknown', 12, 'edge_free_top', 0.9785, 0.04886),
  ('unknown', 12, 'edge_unseen', 0.01838, 0.05521),
  ('unknown', 12, 'headroom', 1.889, 0.2587),
  ('unknown', 12, 'height', 0.5068, 0.0772),
  ('unknown', 12, 'lift', -3.567, 0.7079),
  ('unknown', 12, 'rectangularity', 0.7878, 0.1131),
  ('unknown', 12, 'spread_length', -0.06329, 0.2637),
  ('unknown', 12, 'spread_width', -0.5123, 0.1356),
  ('unknown', 12, 'standoff', 0.1292, 0.02285),
  ('unknown', 12, 'tilt_deg', 87.63, 6.019),
  ('unknown', 12, 'wall_offset', 0.1688, 0.05563),
  ('unknown', 12, 'width', -0.3545, 0.2266),
  ('unknown', 12, 'z_max', 0.8122, 0.1216),
  ('unknown', 12, 'z_min', 0.04424, 0.06189);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.005602, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'aspect', 1.666, 0.2048),
  ('unknown', 13, 'behind', 0.3286, 0.2919),
  ('unknown', 13, 'corner_offset', 0.8076, 0.5313),
  ('unknown', 13, 'edge_concave', 0.003267, 0.03),
  ('unknown', 13, 'edge_convex', 0.004142, 0.03),
  ('unknown', 13, 'edge_free', 0.8613, 0.1541),
  ('unknown', 13, 'edge_free_top', 0.5727, 0.1292),
  ('unknown', 13, 'edge_unseen', 0.02028, 0.04154),
  ('unknown', 13, 'headroom', 0.3245, 0.1391),
  ('unknown', 13, 'height', 2.56, 0.328),
  ('unknown', 13, 'lift', 0.4185, 0.29),
  ('unknown', 13, 'rectangularity', 0.8404, 0.05852),
  ('unknown', 13, 'spread_length', 0.2202, 0.1529),
  ('unknown', 13, 'spread_width', -1.552, 0.06101),
  ('unknown', 13, 'standoff', 0.4636, 0.1291),
  ('unknown', 13, 'tilt_deg', 0.9913, 1.502),
  ('unknown', 13, 'wall_offset', 0.8374, 0.7512),
  ('unknown', 13, 'width', -1.433, 0.1407),
  ('unknown', 13, 'z_max', 2.563, 0.338),
  ('unknown', 13, 'z_min', 2.561, 0.333);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.01952, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'aspect', 0.4122, 0.2897),
  ('unknown', 14, 'behind', 0.5821, 0.2392),
  ('unknown', 14, 'corner_offset', 1.562, 0.8098),
  ('unknown', 14, 'edge_concave', 0.3254, 0.1888),
  ('unknown', 14, 'edge_convex', 0.2639, 0.162),
  ('unknown', 14, 'edge_free', 0.7902, 0.1515),
  ('unknown', 14, 'edge_free_top', 0.7593, 0.3624),
  ('unknown', 14, 'edge_unseen', 0.04564, 0.06857),
  ('unknown', 14, 'headroom', -0.02447, 0.03799),
  ('unknown', 14, 'height', 0.5041, 0.05466),
  ('unknown', 14, 'lift', -4.457, 0.784),
  ('unknown', 14, 'rectangularity', 0.6919, 0.07757),
  ('unknown', 14, 'spread_length', -0.1694, 0.3167),
  ('unknown', 14, 'spread_width', -0.6901, 0.3544),
  ('unknown', 14, 'standoff', 0.9114, 1.505),
  ('unknown', 14, 'tilt_deg', 88.87, 1.736),
  ('unknown', 14, 'wall_offset', 2.109, 0.406),
  ('unknown', 14, 'width', -0.3931, 0.2294),
  ('unknown', 14, 'z_max', 0.7461, 0.05717),
  ('unknown', 14, 'z_min', 0.08789, 0.127);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.02169, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'aspect', 1.257, 0.5819),
  ('unknown', 15, 'behind', 0.6363, 0.1496),
  ('unknown', 15, 'corner_offset', 0.5037, 0.7337),
  ('unknown', 15, 'edge_concave', 0.6702, 0.1976),
  ('unknown', 15, 'edge_convex', 0.112, 0.1878),
  ('unknown', 15, 'edge_free', 0.2706, 0.2533),
  ('unknown', 15, 'edge_free_top', 0.3328, 0.3573),
  ('unknown', 15, 'edge_unseen', 0.1151, 0.1203),
  ('unknown', 15, 'headroom', 1.661, 0.3924),
  ('unknown', 15, 'height', 0.829, 0.123),
  ('unknown', 15, 'lift', -2.173, 0.3909),
  ('unknown', 15, 'rectangularity', 0.7408, 0.103),
  ('unknown', 15, 'spread_length', -0.06279, 0.9546),
  ('unknown', 15, 'spread_width', -1.719, 0.3758),
  ('unknown', 15, 'standoff', 0.4628, 0.1242),
  ('unknown', 15, 'tilt_deg', 4.193, 6.449),
  ('unknown', 15, 'wall_offset', 1.219, 0.6215),
  ('unknown', 15, 'width', -1.553, 0.2768),
  ('unknown', 15, 'z_max', 0.8382, 0.1057),
  ('unknown', 15, 'z_min', 0.8355, 0.1244);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.008753, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'aspect', 0.6474, 0.332),
  ('unknown', 16, 'behind', 0.1993, 0.1861),
  ('unknown', 16, 'corner_offset', 0.8486, 0.5976),
  ('unknown', 16, 'edge_concave', 0.2654, 0.2986),
  ('unknown', 16, 'edge_convex', -0.0003758, 0.03),
  ('unknown', 16, 'edge_free', 0.4209, 0.2319),
  ('unknown', 16, 'edge_free_top', 0.5261, 0.419),
  ('unknown', 16, 'edge_unseen', 0.001161, 0.03),
  ('unknown', 16, 'headroom', 0.7817, 0.3302),
  ('unknown', 16, 'height', 0.2027, 0.1751),
  ('unknown', 16, 'lift', -3.232, 1.126),
  ('unknown', 16, 'rectangularity', 0.7965, 0.07872),
  ('unknown', 16, 'spread_length', -1.489, 0.4611),
  ('unknown', 16, 'spread_width', -2.173, 0.3578),
  ('unknown', 16, 'standoff', 0.4927, 0.3743),
  ('unknown', 16, 'tilt_deg', 31.64, 28.96),
  ('unknown', 16, 'wall_offset', 2.353, 0.6519),
  ('unknown', 16, 'width', -1.924, 0.3911),
  ('unknown', 16, 'z_max', 0.2442, 0.2136),
  ('unknown', 16, 'z_min', 0.09926, 0.1016);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.01319, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'aspect', 1.168, 0.2192),
  ('unknown', 17, 'behind', 0.4825, 0.2684),
  ('unknown', 17, 'corner_offset', 1.419, 0.9413),
  ('unknown', 17, 'edge_concave', 0.3008, 0.05967),
  ('unknown', 17, 'edge_convex', 0.0115, 0.0431),
  ('unknown', 17, 'edge_free', 0.4159, 0.2261),
  ('unknown', 17, 'edge_free_top', 0.7053, 0.2963),
  ('unknown', 17, 'edge_unseen', 0.02744, 0.06639),
  ('unknown', 17, 'headroom', 1.423, 0.1811),
  ('unknown', 17, 'height', 0.9577, 0.06917),
  ('unknown', 17, 'lift', -5.297, 0.03109),
  ('unknown', 17, 'rectangularity', 0.6424, 0.1207),
  ('unknown', 17, 'spread_length', 0.1472, 0.3459),
  ('unknown', 17, 'spread_width', -1.089, 0.2148),
  ('unknown', 17, 'standoff', 0.1768, 0.35),
  ('unknown', 17, 'tilt_deg', 89.76, 1.512),
  ('unknown', 17, 'wall_offset', 1.574, 0.9432),
  ('unknown', 17, 'width', -0.8701, 0.1498),
  ('unknown', 17, 'z_max', 1.162, 0.1678),
  ('unknown', 17, 'z_min', 0.7358, 0.1701);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.01306, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'aspect', 1.47, 0.3299),
  ('unknown', 18, 'behind', 0.5434, 0.2751),
  ('unknown', 18, 'corner_offset', -0.1047, 0.04),
  ('unknown', 18, 'edge_concave', 0.9458, 0.08566),
  ('unknown', 18, 'edge_convex', 0.0005257, 0.03002),
  ('unknown', 18, 'edge_free', 0.2201, 0.2416),
  ('unknown', 18, 'edge_free_top', 0.0107, 0.03633),
  ('unknown', 18, 'edge_unseen', 0.02535, 0.08715),
  ('unknown', 18, 'headroom', 0.01361, 0.1682),
  ('unknown', 18, 'height', 1.458, 0.1408),
  ('unknown', 18, 'lift', -5.057, 0.3795),
  ('unknown', 18, 'rectangularity', 0.7826, 0.05696),
  ('unknown', 18, 'spread_length', -0.1177, 0.2774),
  ('unknown', 18, 'spread_width', -1.493, 0.3403),
  ('unknown', 18, 'standoff', 0.5177, 0.2089),
  ('unknown', 18, 'tilt_deg', 89.85, 0.5053),
  ('unknown', 18, 'wall_offset', 0.9849, 0.6211),
  ('unknown', 18, 'width', -1.371, 0.3388),
  ('unknown', 18, 'z_max', 2.049, 0.2522),
  ('unknown', 18, 'z_min', 0.849, 0.1097);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.006067, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'aspect', 1.509, 0.4883),
  ('unknown', 19, 'behind', 0.6662, 0.07869),
  ('unknown', 19, 'corner_offset', -0.07924, 0.04029),
  ('unknown', 19, 'edge_concave', 0.8846, 0.1529),
  ('unknown', 19, 'edge_convex', 0.0003316, 0.03),
  ('unknown', 19, 'edge_free', 0.151, 0.1409),
  ('unknown', 19, 'edge_free_top', 0.5718, 0.128),
  ('unknown', 19, 'edge_unseen', 0.02878, 0.05114),
  ('unknown', 19, 'headroom', 0.6322, 0.2661),
  ('unknown', 19, 'height', 2.113, 0.1261),
  ('unknown', 19, 'lift', 0.13, 0.1317),
  ('unknown', 19, 'rectangularity', 0.7328, 0.0879),
  ('unknown', 19, 'spread_length', -0.1419, 0.5906),
  ('unknown', 19, 'spread_width', -1.612, 0.2486),
  ('unknown', 19, 'standoff', 0.4625, 0.128),
  ('unknown', 19, 'tilt_deg', 1.364, 1.927),
  ('unknown', 19, 'wall_offset', 0.8407, 0.7545),
  ('unknown', 19, 'width', -1.486, 0.2484),
  ('unknown', 19, 'z_max', 2.116, 0.1267),
  ('unknown', 19, 'z_min', 2.108, 0.1249);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.01157, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'aspect', 0.4713, 0.2592),
  ('unknown', 20, 'behind', 0.6106, 0.181),
  ('unknown', 20, 'corner_offset', 1.525, 0.6508),
  ('unknown', 20, 'edge_concave', 0.4361, 0.1202),
  ('unknown', 20, 'edge_convex', 0.04285, 0.0919),
  ('unknown', 20, 'edge_free', 0.6397, 0.1292),
  ('unknown', 20, 'edge_free_top', 0.9749, 0.05181),
  ('unknown', 20, 'edge_unseen', 0.003025, 0.03),
  ('unknown', 20, 'headroom', 1.845, 0.2604),
  ('unknown', 20, 'height', 0.8604, 0.03105),
  ('unknown', 20, 'lift', -4.899, 0.6437),
  ('unknown', 20, 'rectangularity', 0.726, 0.1141),
  ('unknown', 20, 'spread_length', -1.294, 0.1698),
  ('unknown', 20, 'spread_width', -1.546, 0.1397),
  ('unknown', 20, 'standoff', 0.5785, 0.2931),
  ('unknown', 20, 'tilt_deg', 74.49, 4.496),
  ('unknown', 20, 'wall_offset', 1.16, 0.7947),
  ('unknown', 20, 'width', -1.424, 0.1334),
  ('unknown', 20, 'z_max', 0.9821, 0.05825),
  ('unknown', 20, 'z_min', 0.7324, 0.07299);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.01039, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'aspect', 0.2821, 0.2853),
  ('unknown', 21, 'behind', 0.4055, 0.214),
  ('unknown', 21, 'corner_offset', 2.016, 0.9563),
  ('unknown', 21, 'edge_concave', 0.08477, 0.1298),
  ('unknown', 21, 'edge_convex', 0.1509, 0.2091),
  ('unknown', 21, 'edge_free', 0.9795, 0.05053),
  ('unknown', 21, 'edge_free_top', 0.9895, 0.03024),
  ('unknown', 21, 'edge_unseen', 0.2691, 0.1466),
  ('unknown', 21, 'headroom', 0.6906, 0.6912),
  ('unknown', 21, 'height', 0.8679, 0.05175),
  ('unknown', 21, 'lift', -2.791, 0.8235),
  ('unknown', 21, 'rectangularity', 0.7727, 0.03695),
  ('unknown', 21, 'spread_length', -0.6365, 0.4746),
  ('unknown', 21, 'spread_width', -1.041, 0.1978),
  ('unknown', 21, 'standoff', 0.1233, 0.1602),
  ('unknown', 21, 'tilt_deg', 83.91, 8.409),
  ('unknown', 21, 'wall_offset', 2.091, 1.309),
  ('unknown', 21, 'width', -0.7946, 0.2228),
  ('unknown', 21, 'z_max', 1.109, 0.05342),
  ('unknown', 21, 'z_min', 0.5906, 0.04928);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.01281, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'aspect', 0.5341, 0.3359),
  ('unknown', 22, 'behind', 0.496, 0.191),
  ('unknown', 22, 'corner_offset', 0.9573, 0.7815),
  ('unknown', 22, 'edge_concave', 0.3825, 0.1938),
  ('unknown', 22, 'edge_convex', 0.1906, 0.1905),
  ('unknown', 22, 'edge_free', 0.5627, 0.1507),
  ('unknown', 22, 'edge_free_top', 0.9239, 0.1096),
  ('unknown', 22, 'edge_unseen', 0.04209, 0.06755),
  ('unknown', 22, 'headroom', 1.034, 0.6282),
  ('unknown', 22, 'height', 1.224, 0.1488),
  ('unknown', 22, 'lift', -3.765, 2.208),
  ('unknown', 22, 'rectangularity', 0.7467, 0.09616),
  ('unknown', 22, 'spread_length', -1.352, 0.1726),
  ('unknown', 22, 'spread_width', -1.787, 0.2816),
  ('unknown', 22, 'standoff', 0.4001, 0.07351),
  ('unknown', 22, 'tilt_deg', 89.39, 0.9162),
  ('unknown', 22, 'wall_offset', 0.7019, 0.4898),
  ('unknown', 22, 'width', -1.559, 0.2693),
  ('unknown', 22, 'z_max', 1.388, 0.1719),
  ('unknown', 22, 'z_min', 1.059, 0.1297);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.007917, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'aspect', 0.2891, 0.2726),
  ('unknown', 23, 'behind', 0.191, 0.1563),
  ('unknown', 23, 'corner_offset', 0.4965, 0.5077),
  ('unknown', 23, 'edge_concave', 0.007191, 0.04283),
  ('unknown', 23, 'edge_convex', -0.001362, 0.03003),
  ('unknown', 23, 'edge_free', 0.4494, 0.4589),
  ('unknown', 23, 'edge_free_top', 0.573, 0.1284),
  ('unknown', 23, 'edge_unseen', 0.003004, 0.03004),
  ('unknown', 23, 'headroom', 2.011, 0.1531),
  ('unknown', 23, 'height', 0.7898, 0.08869),
  ('unknown', 23, 'lift', -3.475, 1.032),
  ('unknown', 23, 'rectangularity', 0.7831, 0.03973),
  ('unknown', 23, 'spread_length', -1.711, 0.1956),
  ('unknown', 23, 'spread_width', -1.947, 0.2602),
  ('unknown', 23, 'standoff', 0.4694, 0.1161),
  ('unknown', 23, 'tilt_deg', 4.296, 8.406),
  ('unknown', 23, 'wall_offset', 0.8856, 0.6465),
  ('unknown', 23, 'width', -1.857, 0.1517),
  ('unknown', 23, 'z_max', 0.7995, 0.08982),
  ('unknown', 23, 'z_min', 0.7839, 0.09777);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.008475, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'aspect', 0.4571, 0.2257),
  ('unknown', 24, 'behind', 0.2017, 0.3163),
  ('unknown', 24, 'corner_offset', 1.339, 0.8016),
  ('unknown', 24, 'edge_concave', 0.3794, 0.2503),
  ('unknown', 24, 'edge_convex', 0.04494, 0.1113),
  ('unknown', 24, 'edge_free', 0.2285, 0.2724),
  ('unknown', 24, 'edge_free_top', 0.4059, 0.3859),
  ('unknown', 24, 'edge_unseen', -0.002629, 0.03),
  ('unknown', 24, 'headroom', 0.3855, 0.3046),
  ('unknown', 24, 'height', 1.563, 0.1166),
  ('unknown', 24, 'lift', -4.671, 0.8512),
  ('unknown', 24, 'rectangularity', 0.4479, 0.2716),
  ('unknown', 24, 'spread_length', 0.7149, 0.4383),
  ('unknown', 24, 'spread_width', -0.4403, 0.6621),
  ('unknown', 24, 'standoff', 0.04698, 0.03571),
  ('unknown', 24, 'tilt_deg', 87.21, 6.891),
  ('unknown', 24, 'wall_offset', 0.05743, 0.04),
  ('unknown', 24, 'width', 0.0125, 0.597),
  ('unknown', 24, 'z_max', 2.256, 0.1901),
  ('unknown', 24, 'z_min', 0.1306, 0.2483);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.00965, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'aspect', 0.4702, 0.2704),
  ('unknown', 25, 'behind', 0.5705, 0.1643),
  ('unknown', 25, 'corner_offset', 1.408, 1.392),
  ('unknown', 25, 'edge_concave', 0.6385, 0.1624),
  ('unknown', 25, 'edge_convex', 0.2296, 0.1192),
  ('unknown', 25, 'edge_free', 0.5375, 0.1512),
  ('unknown', 25, 'edge_free_top', 0.9095, 0.1541),
  ('unknown', 25, 'edge_unseen', 0.00987, 0.03199),
  ('unknown', 25, 'headroom', 0.03433, 0.05684),
  ('unknown', 25, 'height', 0.8527, 0.04681),
  ('unknown', 25, 'lift', -5.296, 0.03107),
  ('unknown', 25, 'rectangularity', 0.7481, 0.09996),
  ('unknown', 25, 'spread_length', -1.238, 0.1193),
  ('unknown', 25, 'spread_width', -1.47, 0.2463),
  ('unknown', 25, 'standoff', 0.903, 0.2365),
  ('unknown', 25, 'tilt_deg', 89.76, 0.6227),
  ('unknown', 25, 'wall_offset', 1.982, 0.8834),
  ('unknown', 25, 'width', -1.355, 0.2521),
  ('unknown', 25, 'z_max', 1.002, 0.1433),
  ('unknown', 25, 'z_min', 0.7194, 0.1805);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.003758, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'aspect', 1.787, 0.6571),
  ('unknown', 26, 'behind', 0.5856, 0.2467),
  ('unknown', 26, 'corner_offset', 1.566, 0.6989),
  ('unknown', 26, 'edge_concave', 0.002177, 0.03194),
  ('unknown', 26, 'edge_convex', 0.7201, 0.1165),
  ('unknown', 26, 'edge_free', 0.8715, 0.132),
  ('unknown', 26, 'edge_free_top', 0.9823, 0.05041),
  ('unknown', 26, 'edge_unseen', 0.03346, 0.06013),
  ('unknown', 26, 'headroom', 0.2198, 0.1442),
  ('unknown', 26, 'height', 2.472, 0.2038),
  ('unknown', 26, 'lift', -5.293, 0.0577),
  ('unknown', 26, 'rectangularity', 0.7404, 0.06943),
  ('unknown', 26, 'spread_length', -0.1673, 0.7294),
  ('unknown', 26, 'spread_width', -2.417, 0.1213),
  ('unknown', 26, 'standoff', 1.014, 0.2605),
  ('unknown', 26, 'tilt_deg', 85.21, 5.608),
  ('unknown', 26, 'wall_offset', 1.703, 0.7855),
  ('unknown', 26, 'width', -2.028, 0.3833),
  ('unknown', 26, 'z_max', 2.562, 0.2034),
  ('unknown', 26, 'z_min', 2.406, 0.2096);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.01751, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'aspect', 1.003, 0.4692),
  ('unknown', 27, 'behind', 0.5763, 0.2276),
  ('unknown', 27, 'corner_offset', 1.168, 1.267),
  ('unknown', 27, 'edge_concave', -0.001271, 0.03356),
  ('unknown', 27, 'edge_convex', 0.4227, 0.4144),
  ('unknown', 27, 'edge_free', 0.6156, 0.1314),
  ('unknown', 27, 'edge_free_top', 0.4644, 0.1898),
  ('unknown', 27, 'edge_unseen', 0.008689, 0.03012),
  ('unknown', 27, 'headroom', 1.949, 0.2765),
  ('unknown', 27, 'height', 0.4972, 0.08372),
  ('unknown', 27, 'lift', -5.256, 0.1571),
  ('unknown', 27, 'rectangularity', 0.6967, 0.09759),
  ('unknown', 27, 'spread_length', -0.7049, 0.48),
  ('unknown', 27, 'spread_width', -1.89, 0.5346),
  ('unknown', 27, 'standoff', 0.717, 0.5674),
  ('unknown', 27, 'tilt_deg', 85.87, 4.241),
  ('unknown', 27, 'wall_offset', 1.364, 0.8149),
  ('unknown', 27, 'width', -1.618, 0.4545),
  ('unknown', 27, 'z_max', 0.7299, 0.1529),
  ('unknown', 27, 'z_min', 0.31, 0.1553);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.01208, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'aspect', 0.8905, 0.5652),
  ('unknown', 28, 'behind', 0.7713, 0.07373),
  ('unknown', 28, 'corner_offset', 0.2508, 0.1935),
  ('unknown', 28, 'edge_concave', 0.5496, 0.1373),
  ('unknown', 28, 'edge_convex', 0.02584, 0.04461),
  ('unknown', 28, 'edge_free', 0.2695, 0.2651),
  ('unknown', 28, 'edge_free_top', 0.2677, 0.1657),
  ('unknown', 28, 'edge_unseen', 0.001203, 0.03004),
  ('unknown', 28, 'headroom', 0.07406, 0.5056),
  ('unknown', 28, 'height', 0.8852, 0.3381),
  ('unknown', 28, 'lift', -4.136, 0.6833),
  ('unknown', 28, 'rectangularity', 0.5119, 0.1538),
  ('unknown', 28, 'spread_length', 0.3865, 0.3924),
  ('unknown', 28, 'spread_width', -0.7183, 0.8761),
  ('unknown', 28, 'standoff', 0.714, 0.117),
  ('unknown', 28, 'tilt_deg', 88.27, 0.6627),
  ('unknown', 28, 'wall_offset', 1.76, 0.8051),
  ('unknown', 28, 'width', -0.6929, 0.864),
  ('unknown', 28, 'z_max', 1.812, 0.8291),
  ('unknown', 28, 'z_min', 0.1108, 0.1414);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.009441, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'aspect', 0.9239, 0.4004),
  ('unknown', 29, 'behind', 0.3058, 0.2902),
  ('unknown', 29, 'corner_offset', 0.8443, 0.5164),
  ('unknown', 29, 'edge_concave', 0.03208, 0.07453),
  ('unknown', 29, 'edge_convex', 0.1192, 0.1951),
  ('unknown', 29, 'edge_free', 0.8923, 0.1537),
  ('unknown', 29, 'edge_free_top', 0.5728, 0.1295),
  ('unknown', 29, 'edge_unseen', 0.2094, 0.1424),
  ('unknown', 29, 'headroom', 0.2914, 0.1292),
  ('unknown', 29, 'height', 2.53, 0.2713),
  ('unknown', 29, 'lift', 0.6174, 0.4285),
  ('unknown', 29, 'rectangularity', 0.7171, 0.119),
  ('unknown', 29, 'spread_length', -0.6479, 0.5679),
  ('unknown', 29, 'spread_width', -1.654, 0.1238),
  ('unknown', 29, 'standoff', 0.4634, 0.1287),
  ('unknown', 29, 'tilt_deg', 1.688, 1.593),
  ('unknown', 29, 'wall_offset', 0.8652, 0.7685),
  ('unknown', 29, 'width', -1.496, 0.1564),
  ('unknown', 29, 'z_max', 2.532, 0.2708),
  ('unknown', 29, 'z_min', 2.532, 0.2648);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.007597, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'aspect', 0.457, 0.3447),
  ('unknown', 30, 'behind', 0.5477, 0.2384),
  ('unknown', 30, 'corner_offset', 0.9495, 0.9343),
  ('unknown', 30, 'edge_concave', 0.3294, 0.2438),
  ('unknown', 30, 'edge_convex', 0.167, 0.1684),
  ('unknown', 30, 'edge_free', 0.5617, 0.1853),
  ('unknown', 30, 'edge_free_top', 0.9416, 0.1055),
  ('unknown', 30, 'edge_unseen', 0.00122, 0.03),
  ('unknown', 30, 'headroom', 0.6289, 0.3041),
  ('unknown', 30, 'height', 1.868, 0.1489),
  ('unknown', 30, 'lift', -4.104, 1.48),
  ('unknown', 30, 'rectangularity', 0.6886, 0.1822),
  ('unknown', 30, 'spread_length', -1.324, 0.3015),
  ('unknown', 30, 'spread_width', -1.735, 0.3189),
  ('unknown', 30, 'standoff', 0.527, 0.3192),
  ('unknown', 30, 'tilt_deg', 88.87, 1.854),
  ('unknown', 30, 'wall_offset', 0.7627, 0.5306),
  ('unknown', 30, 'width', -1.421, 0.2724),
  ('unknown', 30, 'z_max', 2.027, 0.1771),
  ('unknown', 30, 'z_min', 1.658, 0.1328);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.003383, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'aspect', 1.698, 0.184),
  ('unknown', 31, 'behind', 0.2338, 0.2715),
  ('unknown', 31, 'corner_offset', 0.9611, 0.4419),
  ('unknown', 31, 'edge_concave', 0.003931, 0.03),
  ('unknown', 31, 'edge_convex', 0.4815, 0.03004),
  ('unknown', 31, 'edge_free', 0.9088, 0.116),
  ('unknown', 31, 'edge_free_top', 0.5727, 0.1295),
  ('unknown', 31, 'edge_unseen', 0.02414, 0.04023),
  ('unknown', 31, 'headroom', 0.3469, 0.1324),
  ('unknown', 31, 'height', 2.486, 0.2424),
  ('unknown', 31, 'lift', 0.2725, 0.428),
  ('unknown', 31, 'rectangularity', 0.8551, 0.03908),
  ('unknown', 31, 'spread_length', 0.1921, 0.1758),
  ('unknown', 31, 'spread_width', -1.6, 0.04544),
  ('unknown', 31, 'standoff', 0.4631, 0.1288),
  ('unknown', 31, 'tilt_deg', 0.9986, 2.039),
  ('unknown', 31, 'wall_offset', 0.8323, 0.7511),
  ('unknown', 31, 'width', -1.459, 0.09034),
  ('unknown', 31, 'z_max', 2.488, 0.246),
  ('unknown', 31, 'z_min', 2.483, 0.2457);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.01328, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'aspect', 0.2461, 0.202),
  ('unknown', 32, 'behind', 0.3827, 0.1581),
  ('unknown', 32, 'corner_offset', 1.258, 0.3285),
  ('unknown', 32, 'edge_concave', 0.0003598, 0.03),
  ('unknown', 32, 'edge_convex', 7.673e-05, 0.03),
  ('unknown', 32, 'edge_free', 0.819, 0.179),
  ('unknown', 32, 'edge_free_top', 0.7165, 0.3002),
  ('unknown', 32, 'edge_unseen', 0.008298, 0.03348),
  ('unknown', 32, 'headroom', 1.542, 0.2636),
  ('unknown', 32, 'height', 1.126, 0.1818),
  ('unknown', 32, 'lift', -1.087, 0.3028),
  ('unknown', 32, 'rectangularity', 0.7524, 0.04468),
  ('unknown', 32, 'spread_length', -1.129, 0.451),
  ('unknown', 32, 'spread_width', -1.693, 0.5712),
  ('unknown', 32, 'standoff', 0.3909, 0.4842),
  ('unknown', 32, 'tilt_deg', 60.16, 36.35),
  ('unknown', 32, 'wall_offset', 2.194, 0.4802),
  ('unknown', 32, 'width', -1.44, 0.6619),
  ('unknown', 32, 'z_max', 1.325, 0.2601),
  ('unknown', 32, 'z_min', 0.9635, 0.1801);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.02029, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'aspect', 0.8071, 0.7205),
  ('unknown', 33, 'behind', 0.000615, 0.03),
  ('unknown', 33, 'corner_offset', -2.689, 3.398),
  ('unknown', 33, 'edge_concave', 0.001793, 0.03455),
  ('unknown', 33, 'edge_convex', 0.0001773, 0.03),
  ('unknown', 33, 'edge_free', 0.002611, 0.03),
  ('unknown', 33, 'edge_free_top', 0.003017, 0.03),
  ('unknown', 33, 'edge_unseen', 0.03075, 0.04859),
  ('unknown', 33, 'headroom', 0.5296, 0.1712),
  ('unknown', 33, 'height', 1.578, 1.165),
  ('unknown', 33, 'lift', -3.733, 0.2788),
  ('unknown', 33, 'rectangularity', 0.8724, 0.128),
  ('unknown', 33, 'spread_length', 1.612, 0.3068),
  ('unknown', 33, 'spread_width', 0.9289, 0.4659),
  ('unknown', 33, 'standoff', 0.1458, 0.1368),
  ('unknown', 33, 'tilt_deg', 89.82, 0.4509),
  ('unknown', 33, 'wall_offset', -0.01968, 0.09283),
  ('unknown', 33, 'width', 0.9325, 0.5621),
  ('unknown', 33, 'z_max', 3.882, 2.293),
  ('unknown', 33, 'z_min', -0.5091, 0.7898);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.004033, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'aspect', 0.2311, 0.1978),
  ('unknown', 34, 'behind', 0.2781, 0.116),
  ('unknown', 34, 'corner_offset', 0.9275, 0.468),
  ('unknown', 34, 'edge_concave', 0.0216, 0.05774),
  ('unknown', 34, 'edge_convex', 0.0009552, 0.03),
  ('unknown', 34, 'edge_free', 0.8054, 0.1162),
  ('unknown', 34, 'edge_free_top', 0.573, 0.1299),
  ('unknown', 34, 'edge_unseen', 0.01816, 0.05354),
  ('unknown', 34, 'headroom', 0.3794, 0.04662),
  ('unknown', 34, 'height', 0.1044, 0.02289),
  ('unknown', 34, 'lift', -3.535, 0.6274),
  ('unknown', 34, 'rectangularity', 0.5968, 0.06539),
  ('unknown', 34, 'spread_length', -0.7939, 0.1075),
  ('unknown', 34, 'spread_width', -1.013, 0.184),
  ('unknown', 34, 'standoff', 0.4632, 0.1281),
  ('unknown', 34, 'tilt_deg', 1.373, 2.267),
  ('unknown', 34, 'wall_offset', 0.8283, 0.7541),
  ('unknown', 34, 'width', -0.8175, 0.2903),
  ('unknown', 34, 'z_max', 0.1089, 0.0325),
  ('unknown', 34, 'z_min', 0.09896, 0.0264);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.008339, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'aspect', 0.3993, 0.2029),
  ('unknown', 35, 'behind', 0.03695, 0.04731),
  ('unknown', 35, 'corner_offset', 1.689, 1.597),
  ('unknown', 35, 'edge_concave', 0.02183, 0.03491),
  ('unknown', 35, 'edge_convex', 0.001305, 0.0301),
  ('unknown', 35, 'edge_free', 0.929, 0.1038),
  ('unknown', 35, 'edge_free_top', 0.8429, 0.2614),
  ('unknown', 35, 'edge_unseen', 0.1117, 0.13),
  ('unknown', 35, 'headroom', 0.6724, 0.2132),
  ('unknown', 35, 'height', 1.673, 0.08886),
  ('unknown', 35, 'lift', -0.5044, 0.4884),
  ('unknown', 35, 'rectangularity', 0.8913, 0.0877),
  ('unknown', 35, 'spread_length', -0.1128, 0.2706),
  ('unknown', 35, 'spread_width', -0.6557, 0.169),
  ('unknown', 35, 'standoff', 0.05673, 0.03784),
  ('unknown', 35, 'tilt_deg', 89.77, 0.9568),
  ('unknown', 35, 'wall_offset', 0.7163, 0.4827),
  ('unknown', 35, 'width', -0.3365, 0.05161),
  ('unknown', 35, 'z_max', 2.037, 0.1495),
  ('unknown', 35, 'z_min', 1.37, 0.07137);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.003493, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'aspect', 0.9246, 0.3549),
  ('unknown', 36, 'behind', 0.5666, 0.2572),
  ('unknown', 36, 'corner_offset', 0.5131, 0.4882),
  ('unknown', 36, 'edge_concave', 0.6891, 0.1675),
  ('unknown', 36, 'edge_convex', 0.001747, 0.03002),
  ('unknown', 36, 'edge_free', 0.3258, 0.213),
  ('unknown', 36, 'edge_free_top', 0.5709, 0.1297),
  ('unknown', 36, 'edge_unseen', 0.1457, 0.1462),
  ('unknown', 36, 'headroom', 0.5223, 0.3597),
  ('unknown', 36, 'height', 1.984, 0.3924),
  ('unknown', 36, 'lift', 0.1028, 0.3256),
  ('unknown', 36, 'rectangularity', 0.7024, 0.07587),
  ('unknown', 36, 'spread_length', -0.2538, 0.5209),
  ('unknown', 36, 'spread_width', -1.315, 0.3842),
  ('unknown', 36, 'standoff', 0.486, 0.1671),
  ('unknown', 36, 'tilt_deg', 4.073, 1.011),
  ('unknown', 36, 'wall_offset', 0.8921, 0.5443),
  ('unknown', 36, 'width', -1.078, 0.278),
  ('unknown', 36, 'z_max', 1.995, 0.3953),
  ('unknown', 36, 'z_min', 1.967, 0.384);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.002875, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'aspect', 1.839, 0.5225),
  ('unknown', 37, 'behind', 0.01517, 0.05049),
  ('unknown', 37, 'corner_offset', -3.876, 5.302),
  ('unknown', 37, 'edge_concave', 0.008221, 0.03011),
  ('unknown', 37, 'edge_convex', 0.001238, 0.03),
  ('unknown', 37, 'edge_free', 0.01641, 0.03473),
  ('unknown', 37, 'edge_free_top', 0.01127, 0.03506),
  ('unknown', 37, 'edge_unseen', 0.1538, 0.186),
  ('unknown', 37, 'headroom', 0.6396, 0.316),
  ('unknown', 37, 'height', 1.663, 1.331),
  ('unknown', 37, 'lift', -2.963, 1.384),
  ('unknown', 37, 'rectangularity', 0.7156, 0.1339),
  ('unknown', 37, 'spread_length', 1.666, 0.4363),
  ('unknown', 37, 'spread_width', -0.2242, 0.8606),
  ('unknown', 37, 'standoff', 0.03885, 0.06117),
  ('unknown', 37, 'tilt_deg', 89.69, 2.076),
  ('unknown', 37, 'wall_offset', -2.7, 12.23),
  ('unknown', 37, 'width', -0.14, 0.7369),
  ('unknown', 37, 'z_max', 4.805, 2.227),
  ('unknown', 37, 'z_min', -0.9648, 1.467);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.005547, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'aspect', 1.51, 0.3873),
  ('unknown', 38, 'behind', 0.2822, 0.2611),
  ('unknown', 38, 'corner_offset', 3.838, 0.7023),
  ('unknown', 38, 'edge_concave', 0.841, 0.1537),
  ('unknown', 38, 'edge_convex', 0.01943, 0.06215),
  ('unknown', 38, 'edge_free', 0.137, 0.1263),
  ('unknown', 38, 'edge_free_top', 0.1233, 0.1659),
  ('unknown', 38, 'edge_unseen', 0.0964, 0.1045),
  ('unknown', 38, 'headroom', -0.0148, 0.09529),
  ('unknown', 38, 'height', 1.492, 0.04586),
  ('unknown', 38, 'lift', -5.126, 0.3243),
  ('unknown', 38, 'rectangularity', 0.6843, 0.1549),
  ('unknown', 38, 'spread_length', 0.004384, 0.1506),
  ('unknown', 38, 'spread_width', -1.488, 0.3075),
  ('unknown', 38, 'standoff', 0.4995, 0.2874),
  ('unknown', 38, 'tilt_deg', 89.21, 1.83),
  ('unknown', 38, 'wall_offset', 1.069, 0.5752),
  ('unknown', 38, 'width', -1.187, 0.3667),
  ('unknown', 38, 'z_max', 2.201, 0.1576),
  ('unknown', 38, 'z_min', 0.8998, 0.2001);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.005503, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'aspect', 0.3253, 0.26),
  ('unknown', 39, 'behind', 0.003871, 0.03),
  ('unknown', 39, 'corner_offset', -2.729, 4.113),
  ('unknown', 39, 'edge_concave', 0.002458, 0.03),
  ('unknown', 39, 'edge_convex', 0.001304, 0.03),
  ('unknown', 39, 'edge_free', 0.02809, 0.08569),
  ('unknown', 39, 'edge_free_top', 0.03476, 0.1055),
  ('unknown', 39, 'edge_unseen', 0.162, 0.1449),
  ('unknown', 39, 'headroom', 0.8186, 0.2595),
  ('unknown', 39, 'height', 2.418, 0.7939),
  ('unknown', 39, 'lift', -3.538, 0.6234),
  ('unknown', 39, 'rectangularity', 0.7936, 0.1572),
  ('unknown', 39, 'spread_length', 2.058, 0.4463),
  ('unknown', 39, 'spread_width', 1.634, 0.4603),
  ('unknown', 39, 'standoff', 0.155, 0.1408),
  ('unknown', 39, 'tilt_deg', 89.77, 1.37),
  ('unknown', 39, 'wall_offset', -10.95, 6.945),
  ('unknown', 39, 'width', 1.739, 0.5052),
  ('unknown', 39, 'z_max', 7.257, 2.197),
  ('unknown', 39, 'z_min', -1.428, 1.673);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.004721, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'aspect', 1.488, 0.5487),
  ('unknown', 40, 'behind', 0.6757, 0.1214),
  ('unknown', 40, 'corner_offset', 1.7, 1.404),
  ('unknown', 40, 'edge_concave', 0.371, 0.2515),
  ('unknown', 40, 'edge_convex', 0.3628, 0.2007),
  ('unknown', 40, 'edge_free', 0.2988, 0.2371),
  ('unknown', 40, 'edge_free_top', 0.209, 0.2935),
  ('unknown', 40, 'edge_unseen', 0.06909, 0.07073),
  ('unknown', 40, 'headroom', 0.06242, 0.1213),
  ('unknown', 40, 'height', 2.807, 0.4368),
  ('unknown', 40, 'lift', -5.091, 0.6733),
  ('unknown', 40, 'rectangularity', 0.6708, 0.1261),
  ('unknown', 40, 'spread_length', 0.138, 0.5509),
  ('unknown', 40, 'spread_width', -1.69, 0.4721),
  ('unknown', 40, 'standoff', 0.849, 0.2339),
  ('unknown', 40, 'tilt_deg', 74.06, 25.19),
  ('unknown', 40, 'wall_offset', 0.9789, 0.4083),
  ('unknown', 40, 'width', -1.318, 0.3948),
  ('unknown', 40, 'z_max', 2.942, 0.4795),
  ('unknown', 40, 'z_min', 2.704, 0.3684);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 41, 0.02264, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 41, 'aspect', 0.4497, 0.2668),
  ('unknown', 41, 'behind', 0.6443, 0.1794),
  ('unknown', 41, 'corner_offset', 1.495, 0.5546),
  ('unknown', 41, 'edge_concave', 0.4958, 0.2489),
  ('unknown', 41, 'edge_convex', 0.2539, 0.07872),
  ('unknown', 41, 'edge_free', 0.4712, 0.1891),
  ('unknown', 41, 'edge_free_top', 0.8005, 0.2101),
  ('unknown', 41, 'edge_unseen', 0.009247, 0.03624),
  ('unknown', 41, 'headroom', 0.613, 0.9722),
  ('unknown', 41, 'height', 0.2078, 0.02933),
  ('unknown', 41, 'lift', -4.471, 0.7061),
  ('unknown', 41, 'rectangularity', 0.6719, 0.1289),
  ('unknown', 41, 'spread_length', -0.9936, 0.2094),
  ('unknown', 41, 'spread_width', -1.645, 0.5083),
  ('unknown', 41, 'standoff', 0.5508, 0.1508),
  ('unknown', 41, 'tilt_deg', 89.26, 0.9234),
  ('unknown', 41, 'wall_offset', 1.188, 0.7797),
  ('unknown', 41, 'width', -1.273, 0.4673),
  ('unknown', 41, 'z_max', 0.3895, 0.05839),
  ('unknown', 41, 'z_min', -0.01388, 0.02895);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 42, 0.01306, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 42, 'aspect', 0.3765, 0.4491),
  ('unknown', 42, 'behind', 0.7388, 0.1809),
  ('unknown', 42, 'corner_offset', 0.95, 0.8128),
  ('unknown', 42, 'edge_concave', 0.3513, 0.08283),
  ('unknown', 42, 'edge_convex', 0.02154, 0.07053),
  ('unknown', 42, 'edge_free', 0.4611, 0.09439),
  ('unknown', 42, 'edge_free_top', 0.4223, 0.2534),
  ('unknown', 42, 'edge_unseen', 0.01072, 0.03031),
  ('unknown', 42, 'headroom', 0.01925, 0.1484),
  ('unknown', 42, 'height', 0.2942, 0.1327),
  ('unknown', 42, 'lift', -3.521, 0.7027),
  ('unknown', 42, 'rectangularity', 0.3549, 0.1346),
  ('unknown', 42, 'spread_length', -0.3376, 0.3591),
  ('unknown', 42, 'spread_width', -1.383, 0.5705),
  ('unknown', 42, 'standoff', 0.6137, 0.6074),
  ('unknown', 42, 'tilt_deg', 88.54, 0.8174),
  ('unknown', 42, 'wall_offset', 1.787, 1.008),
  ('unknown', 42, 'width', -0.7847, 0.3512),
  ('unknown', 42, 'z_max', 0.6509, 0.2369),
  ('unknown', 42, 'z_min', -0.01608, 0.02846);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 43, 0.01947, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 43, 'aspect', 0.284, 0.1823),
  ('unknown', 43, 'behind', 0.3114, 0.269),
  ('unknown', 43, 'corner_offset', 0.4451, 0.6017),
  ('unknown', 43, 'edge_concave', 0.1181, 0.1991),
  ('unknown', 43, 'edge_convex', 0.003408, 0.03),
  ('unknown', 43, 'edge_free', 0.1861, 0.2895),
  ('unknown', 43, 'edge_free_top', 0.5835, 0.1256),
  ('unknown', 43, 'edge_unseen', 0.002491, 0.03),
  ('unknown', 43, 'headroom', 1.994, 0.2422),
  ('unknown', 43, 'height', 0.763, 0.06104),
  ('unknown', 43, 'lift', -3.238, 1.011),
  ('unknown', 43, 'rectangularity', 0.8009, 0.0855),
  ('unknown', 43, 'spread_length', -1.477, 0.2644),
  ('unknown', 43, 'spread_width', -1.492, 0.2092),
  ('unknown', 43, 'standoff', 0.4698, 0.1193),
  ('unknown', 43, 'tilt_deg', 0.4421, 0.451),
  ('unknown', 43, 'wall_offset', 0.9611, 0.9673),
  ('unknown', 43, 'width', -1.575, 0.2454),
  ('unknown', 43, 'z_max', 0.7695, 0.0698),
  ('unknown', 43, 'z_min', 0.7592, 0.05276);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 44, 0.02439, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 44, 'aspect', 0.8599, 0.4531),
  ('unknown', 44, 'behind', 0.7667, 0.06479),
  ('unknown', 44, 'corner_offset', 0.2057, 0.0758),
  ('unknown', 44, 'edge_concave', 0.4536, 0.153),
  ('unknown', 44, 'edge_convex', 0.03385, 0.102),
  ('unknown', 44, 'edge_free', 0.3004, 0.131),
  ('unknown', 44, 'edge_free_top', 0.5726, 0.1325),
  ('unknown', 44, 'edge_unseen', 0.04105, 0.04452),
  ('unknown', 44, 'headroom', 0.9629, 0.7182),
  ('unknown', 44, 'height', 0.8412, 0.3985),
  ('unknown', 44, 'lift', -1.448, 0.7189),
  ('unknown', 44, 'rectangularity', 0.6884, 0.1065),
  ('unknown', 44, 'spread_length', -0.2092, 0.6151),
  ('unknown', 44, 'spread_width', -1.26, 0.5389),
  ('unknown', 44, 'standoff', 0.4104, 0.101),
  ('unknown', 44, 'tilt_deg', 7.033, 1.95),
  ('unknown', 44, 'wall_offset', 0.8616, 0.2025),
  ('unknown', 44, 'width', -1.059, 0.3977),
  ('unknown', 44, 'z_max', 0.8976, 0.3723),
  ('unknown', 44, 'z_min', 0.8685, 0.3907);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 45, 0.0154, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 45, 'aspect', 0.9481, 0.3215),
  ('unknown', 45, 'behind', 0.6073, 0.1318),
  ('unknown', 45, 'corner_offset', 1.424, 0.5081),
  ('unknown', 45, 'edge_concave', 0.4368, 0.2055),
  ('unknown', 45, 'edge_convex', 0.1609, 0.1707),
  ('unknown', 45, 'edge_free', 0.5034, 0.2293),
  ('unknown', 45, 'edge_free_top', 0.903, 0.1492),
  ('unknown', 45, 'edge_unseen', 0.003614, 0.0301),
  ('unknown', 45, 'headroom', 1.284, 0.741),
  ('unknown', 45, 'height', 0.8839, 0.0823),
  ('unknown', 45, 'lift', -5.297, 0.03107),
  ('unknown', 45, 'rectangularity', 0.7272, 0.08921),
  ('unknown', 45, 'spread_length', -1.308, 0.1458),
  ('unknown', 45, 'spread_width', -1.327, 0.3921),
  ('unknown', 45, 'standoff', 0.6525, 0.3309),
  ('unknown', 45, 'tilt_deg', 89.91, 0.45),
  ('unknown', 45, 'wall_offset', 1.315, 0.6602),
  ('unknown', 45, 'width', -1.206, 0.3322),
  ('unknown', 45, 'z_max', 1.066, 0.1355),
  ('unknown', 45, 'z_min', 0.7323, 0.07842);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 46, 0.01558, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 46, 'aspect', 0.4388, 0.2622),
  ('unknown', 46, 'behind', 0.5863, 0.2112),
  ('unknown', 46, 'corner_offset', 0.338, 0.4641),
  ('unknown', 46, 'edge_concave', 0.397, 0.1721),
  ('unknown', 46, 'edge_convex', 0.2341, 0.1115),
  ('unknown', 46, 'edge_free', 0.4418, 0.1534),
  ('unknown', 46, 'edge_free_top', 0.6237, 0.2753),
  ('unknown', 46, 'edge_unseen', 0.0009898, 0.03),
  ('unknown', 46, 'headroom', 0.6893, 0.4545),
  ('unknown', 46, 'height', 1.526, 0.3141),
  ('unknown', 46, 'lift', -3.808, 2.02),
  ('unknown', 46, 'rectangularity', 0.6929, 0.06433),
  ('unknown', 46, 'spread_length', -1.135, 0.3118),
  ('unknown', 46, 'spread_width', -1.559, 0.3543),
  ('unknown', 46, 'standoff', 0.7946, 0.2749),
  ('unknown', 46, 'tilt_deg', 88.62, 1.053),
  ('unknown', 46, 'wall_offset', 1.85, 1.305),
  ('unknown', 46, 'width', -1.308, 0.4371),
  ('unknown', 46, 'z_max', 1.719, 0.2721),
  ('unknown', 46, 'z_min', 1.338, 0.2273);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 47, 0.01592, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 47, 'aspect', 0.2377, 0.253),
  ('unknown', 47, 'behind', 0.0121, 0.03016),
  ('unknown', 47, 'corner_offset', 1.156, 1.294),
  ('unknown', 47, 'edge_concave', 0.05734, 0.1016),
  ('unknown', 47, 'edge_convex', 0.002937, 0.03082),
  ('unknown', 47, 'edge_free', 0.03572, 0.03001),
  ('unknown', 47, 'edge_free_top', 0.01013, 0.03004),
  ('unknown', 47, 'edge_unseen', 0.05821, 0.1119),
  ('unknown', 47, 'headroom', 0.8863, 0.2204),
  ('unknown', 47, 'height', 1.641, 0.06865),
  ('unknown', 47, 'lift', -1.497, 0.5022),
  ('unknown', 47, 'rectangularity', 0.722, 0.0859),
  ('unknown', 47, 'spread_length', -0.5565, 0.2424),
  ('unknown', 47, 'spread_width', -1.143, 0.2917),
  ('unknown', 47, 'standoff', 0.01658, 0.009111),
  ('unknown', 47, 'tilt_deg', 89.49, 0.5333),
  ('unknown', 47, 'wall_offset', 0.06475, 0.04),
  ('unknown', 47, 'width', -0.6829, 0.4203),
  ('unknown', 47, 'z_max', 1.969, 0.1588),
  ('unknown', 47, 'z_min', 1.331, 0.07227);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 48, 0.02243, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 48, 'aspect', 0.5434, 0.3504),
  ('unknown', 48, 'behind', 0.5455, 0.1866),
  ('unknown', 48, 'corner_offset', 1.362, 0.4764),
  ('unknown', 48, 'edge_concave', 0.3256, 0.1069),
  ('unknown', 48, 'edge_convex', 0.2798, 0.1679),
  ('unknown', 48, 'edge_free', 0.7936, 0.0983),
  ('unknown', 48, 'edge_free_top', 0.5808, 0.4077),
  ('unknown', 48, 'edge_unseen', 0.07472, 0.08697),
  ('unknown', 48, 'headroom', -0.004872, 0.03252),
  ('unknown', 48, 'height', 0.4782, 0.08788),
  ('unknown', 48, 'lift', -5.268, 0.1182),
  ('unknown', 48, 'rectangularity', 0.6539, 0.1206),
  ('unknown', 48, 'spread_length', -0.2038, 0.2209),
  ('unknown', 48, 'spread_width', -1.102, 0.4742),
  ('unknown', 48, 'standoff', 0.3089, 0.1314),
  ('unknown', 48, 'tilt_deg', 89.24, 1.047),
  ('unknown', 48, 'wall_offset', 1.921, 0.3103),
  ('unknown', 48, 'width', -0.7176, 0.3491),
  ('unknown', 48, 'z_max', 0.7437, 0.04061),
  ('unknown', 48, 'z_min', 0.1136, 0.1515);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 49, 0.01857, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 49, 'aspect', 0.4865, 0.3184),
  ('unknown', 49, 'behind', 0.7823, 0.0349),
  ('unknown', 49, 'corner_offset', 0.1691, 0.0458),
  ('unknown', 49, 'edge_concave', 0.5861, 0.252),
  ('unknown', 49, 'edge_convex', 0.001459, 0.03125),
  ('unknown', 49, 'edge_free', 0.3081, 0.1152),
  ('unknown', 49, 'edge_free_top', 0.4248, 0.143),
  ('unknown', 49, 'edge_unseen', 0.0003342, 0.03),
  ('unknown', 49, 'headroom', 0.6759, 0.4494),
  ('unknown', 49, 'height', 0.9592, 0.3863),
  ('unknown', 49, 'lift', -4.045, 1.945),
  ('unknown', 49, 'rectangularity', 0.6095, 0.07123),
  ('unknown', 49, 'spread_length', -1.043, 0.369),
  ('unknown', 49, 'spread_width', -1.419, 0.1677),
  ('unknown', 49, 'standoff', 0.4675, 0.1956),
  ('unknown', 49, 'tilt_deg', 86.29, 3.604),
  ('unknown', 49, 'wall_offset', 1.439, 0.7598),
  ('unknown', 49, 'width', -1.194, 0.2124),
  ('unknown', 49, 'z_max', 1.237, 0.3816),
  ('unknown', 49, 'z_min', 0.8068, 0.3454);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 50, 0.006572, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 50, 'aspect', 1.678, 0.2112),
  ('unknown', 50, 'behind', 0.3921, 0.2437),
  ('unknown', 50, 'corner_offset', 0.7787, 0.5714),
  ('unknown', 50, 'edge_concave', 0.002864, 0.03002),
  ('unknown', 50, 'edge_convex', 0.1584, 0.215),
  ('unknown', 50, 'edge_free', 0.867, 0.1526),
  ('unknown', 50, 'edge_free_top', 0.5846, 0.1293),
  ('unknown', 50, 'edge_unseen', 0.007846, 0.03006),
  ('unknown', 50, 'headroom', 0.3301, 0.1421),
  ('unknown', 50, 'height', 2.419, 0.2045),
  ('unknown', 50, 'lift', 0.3824, 0.3041),
  ('unknown', 50, 'rectangularity', 0.8541, 0.04595),
  ('unknown', 50, 'spread_length', 0.2583, 0.1476),
  ('unknown', 50, 'spread_width', -1.558, 0.06527),
  ('unknown', 50, 'standoff', 0.4713, 0.1301),
  ('unknown', 50, 'tilt_deg', 0.7618, 1.185),
  ('unknown', 50, 'wall_offset', 0.7949, 0.7898),
  ('unknown', 50, 'width', -1.412, 0.165),
  ('unknown', 50, 'z_max', 2.428, 0.2065),
  ('unknown', 50, 'z_min', 2.419, 0.2096);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 51, 0.03539, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 51, 'aspect', 0.8673, 0.7441),
  ('unknown', 51, 'behind', -0.0004003, 0.03),
  ('unknown', 51, 'corner_offset', -2.83, 4.483),
  ('unknown', 51, 'edge_concave', -0.002412, 0.03),
  ('unknown', 51, 'edge_convex', 0.0009331, 0.03001),
  ('unknown', 51, 'edge_free', 0.006352, 0.03),
  ('unknown', 51, 'edge_free_top', 0.008132, 0.03),
  ('unknown', 51, 'edge_unseen', 0.04991, 0.07935),
  ('unknown', 51, 'headroom', 0.8714, 0.1018),
  ('unknown', 51, 'height', 1.659, 1.329),
  ('unknown', 51, 'lift', -3.536, 0.5027),
  ('unknown', 51, 'rectangularity', 0.8319, 0.1621),
  ('unknown', 51, 'spread_length', 1.851, 0.4712),
  ('unknown', 51, 'spread_width', 1.115, 0.6536),
  ('unknown', 51, 'standoff', 0.04852, 0.08277),
  ('unknown', 51, 'tilt_deg', 89.83, 0.45),
  ('unknown', 51, 'wall_offset', -2.014, 3.626),
  ('unknown', 51, 'width', 1.068, 0.8293),
  ('unknown', 51, 'z_max', 5.28, 2.789),
  ('unknown', 51, 'z_min', -1.145, 1.371);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 52, 0.007103, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 52, 'aspect', 1.574, 0.3756),
  ('unknown', 52, 'behind', 0.6522, 0.09114),
  ('unknown', 52, 'corner_offset', -0.09311, 0.05892),
  ('unknown', 52, 'edge_concave', 0.8567, 0.1632),
  ('unknown', 52, 'edge_convex', 0.0002804, 0.03),
  ('unknown', 52, 'edge_free', 0.1466, 0.1434),
  ('unknown', 52, 'edge_free_top', 0.5847, 0.1289),
  ('unknown', 52, 'edge_unseen', 0.05207, 0.07999),
  ('unknown', 52, 'headroom', 0.7257, 0.2813),
  ('unknown', 52, 'height', 2.109, 0.1378),
  ('unknown', 52, 'lift', 0.1479, 0.1686),
  ('unknown', 52, 'rectangularity', 0.7487, 0.07339),
  ('unknown', 52, 'spread_length', -0.148, 0.5701),
  ('unknown', 52, 'spread_width', -1.596, 0.2478),
  ('unknown', 52, 'standoff', 0.4681, 0.1275),
  ('unknown', 52, 'tilt_deg', 1.451, 2.252),
  ('unknown', 52, 'wall_offset', 0.8135, 0.7888),
  ('unknown', 52, 'width', -1.471, 0.2502),
  ('unknown', 52, 'z_max', 2.114, 0.1393),
  ('unknown', 52, 'z_min', 2.104, 0.141);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 53, 0.01012, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 53, 'aspect', 0.4402, 0.2634),
  ('unknown', 53, 'behind', 0.4613, 0.07468),
  ('unknown', 53, 'corner_offset', 1.459, 1.036),
  ('unknown', 53, 'edge_concave', 0.06074, 0.1074),
  ('unknown', 53, 'edge_convex', 0.06763, 0.1299),
  ('unknown', 53, 'edge_free', 0.7503, 0.2238),
  ('unknown', 53, 'edge_free_top', 0.9812, 0.04465),
  ('unknown', 53, 'edge_unseen', 0.07085, 0.1088),
  ('unknown', 53, 'headroom', 1.997, 0.4072),
  ('unknown', 53, 'height', 0.5368, 0.04797),
  ('unknown', 53, 'lift', -3.496, 0.6123),
  ('unknown', 53, 'rectangularity', 0.7611, 0.1123),
  ('unknown', 53, 'spread_length', -0.08409, 0.2803),
  ('unknown', 53, 'spread_width', -0.6038, 0.1416),
  ('unknown', 53, 'standoff', 0.1317, 0.02476),
  ('unknown', 53, 'tilt_deg', 89.69, 0.9313),
  ('unknown', 53, 'wall_offset', 0.1364, 0.04),
  ('unknown', 53, 'width', -0.3921, 0.1542),
  ('unknown', 53, 'z_max', 0.798, 0.07562),
  ('unknown', 53, 'z_min', 0.08543, 0.08198);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 54, 0.01126, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 54, 'aspect', 1.567, 0.3116),
  ('unknown', 54, 'behind', 0.5011, 0.3719),
  ('unknown', 54, 'corner_offset', -0.1032, 0.04),
  ('unknown', 54, 'edge_concave', 0.8664, 0.2944),
  ('unknown', 54, 'edge_convex', -0.0002361, 0.03),
  ('unknown', 54, 'edge_free', 0.1624, 0.1149),
  ('unknown', 54, 'edge_free_top', 0.02193, 0.05505),
  ('unknown', 54, 'edge_unseen', 0.02667, 0.04908),
  ('unknown', 54, 'headroom', -0.092, 0.1295),
  ('unknown', 54, 'height', 1.456, 0.1317),
  ('unknown', 54, 'lift', -4.634, 0.7461),
  ('unknown', 54, 'rectangularity', 0.7619, 0.08561),
  ('unknown', 54, 'spread_length', 0.0162, 0.2784),
  ('unknown', 54, 'spread_width', -1.644, 0.2384),
  ('unknown', 54, 'standoff', 0.6192, 0.2848),
  ('unknown', 54, 'tilt_deg', 89.83, 0.7365),
  ('unknown', 54, 'wall_offset', 1.049, 0.7504),
  ('unknown', 54, 'width', -1.383, 0.1934),
  ('unknown', 54, 'z_max', 2.026, 0.2604),
  ('unknown', 54, 'z_min', 0.8973, 0.1636);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 55, 0.01752, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 55, 'aspect', 0.8965, 0.3541),
  ('unknown', 55, 'behind', 0.3639, 0.1468),
  ('unknown', 55, 'corner_offset', 1.964, 0.54),
  ('unknown', 55, 'edge_concave', 0.3286, 0.1712),
  ('unknown', 55, 'edge_convex', -0.003328, 0.03003),
  ('unknown', 55, 'edge_free', 0.3669, 0.1466),
  ('unknown', 55, 'edge_free_top', 0.6651, 0.3292),
  ('unknown', 55, 'edge_unseen', 0.02839, 0.04953),
  ('unknown', 55, 'headroom', 0.9112, 1.162),
  ('unknown', 55, 'height', 0.8186, 0.2566),
  ('unknown', 55, 'lift', -5.295, 0.06185),
  ('unknown', 55, 'rectangularity', 0.5985, 0.1632),
  ('unknown', 55, 'spread_length', -0.146, 0.7353),
  ('unknown', 55, 'spread_width', -1.363, 0.3729),
  ('unknown', 55, 'standoff', 0.1486, 0.05989),
  ('unknown', 55, 'tilt_deg', 88.83, 1.293),
  ('unknown', 55, 'wall_offset', 0.1895, 0.05116),
  ('unknown', 55, 'width', -0.986, 0.402),
  ('unknown', 55, 'z_max', 1.003, 0.1945),
  ('unknown', 55, 'z_min', 0.5812, 0.2644);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 56, 0.00839, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 56, 'aspect', 0.5303, 0.4803),
  ('unknown', 56, 'behind', 0.2512, 0.1229),
  ('unknown', 56, 'corner_offset', 0.9925, 0.4859),
  ('unknown', 56, 'edge_concave', 0.1292, 0.3068),
  ('unknown', 56, 'edge_convex', 0.0003472, 0.03012),
  ('unknown', 56, 'edge_free', 0.6869, 0.3832),
  ('unknown', 56, 'edge_free_top', 0.5851, 0.1258),
  ('unknown', 56, 'edge_unseen', 0.002077, 0.03001),
  ('unknown', 56, 'headroom', 0.8471, 0.6813),
  ('unknown', 56, 'height', 0.07698, 0.0383),
  ('unknown', 56, 'lift', -3.498, 0.6297),
  ('unknown', 56, 'rectangularity', 0.6501, 0.1217),
  ('unknown', 56, 'spread_length', -0.9832, 0.2915),
  ('unknown', 56, 'spread_width', -1.633, 0.918),
  ('unknown', 56, 'standoff', 0.4713, 0.1302),
  ('unknown', 56, 'tilt_deg', 5.354, 4.561),
  ('unknown', 56, 'wall_offset', 1.037, 0.6205),
  ('unknown', 56, 'width', -1.305, 0.8584),
  ('unknown', 56, 'z_max', 0.07588, 0.03771),
  ('unknown', 56, 'z_min', 0.0674, 0.03689);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 57, 0.01542, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 57, 'aspect', 0.3115, 0.2854),
  ('unknown', 57, 'behind', 0.4576, 0.2889),
  ('unknown', 57, 'corner_offset', 0.8474, 0.5069),
  ('unknown', 57, 'edge_concave', 0.003865, 0.03002),
  ('unknown', 57, 'edge_convex', 0.3546, 0.2881),
  ('unknown', 57, 'edge_free', 0.6961, 0.2394),
  ('unknown', 57, 'edge_free_top', 0.5792, 0.1322),
  ('unknown', 57, 'edge_unseen', 0.006567, 0.03),
  ('unknown', 57, 'headroom', 1.851, 0.2456),
  ('unknown', 57, 'height', 0.8671, 0.1757),
  ('unknown', 57, 'lift', -1.814, 0.5631),
  ('unknown', 57, 'rectangularity', 0.8038, 0.07715),
  ('unknown', 57, 'spread_length', -1.089, 0.1746),
  ('unknown', 57, 'spread_width', -1.541, 0.3356),
  ('unknown', 57, 'standoff', 0.473, 0.12),
  ('unknown', 57, 'tilt_deg', 0.7533, 0.6422),
  ('unknown', 57, 'wall_offset', 1.259, 0.713),
  ('unknown', 57, 'width', -1.41, 0.3719),
  ('unknown', 57, 'z_max', 0.8414, 0.1528),
  ('unknown', 57, 'z_min', 0.888, 0.1764);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 58, 0.01242, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 58, 'aspect', 0.422, 0.2997),
  ('unknown', 58, 'behind', 0.4649, 0.2232),
  ('unknown', 58, 'corner_offset', 1.163, 0.5451),
  ('unknown', 58, 'edge_concave', 0.004281, 0.03003),
  ('unknown', 58, 'edge_convex', 0.002809, 0.03004),
  ('unknown', 58, 'edge_free', 0.6387, 0.2644),
  ('unknown', 58, 'edge_free_top', 0.6864, 0.3465),
  ('unknown', 58, 'edge_unseen', 0.08397, 0.08665),
  ('unknown', 58, 'headroom', 1.722, 0.3383),
  ('unknown', 58, 'height', 0.9436, 0.1893),
  ('unknown', 58, 'lift', -1.674, 0.6779),
  ('unknown', 58, 'rectangularity', 0.7347, 0.04844),
  ('unknown', 58, 'spread_length', -1.279, 0.6029),
  ('unknown', 58, 'spread_width', -1.961, 0.481),
  ('unknown', 58, 'standoff', 0.6551, 0.3649),
  ('unknown', 58, 'tilt_deg', 27.24, 19.31),
  ('unknown', 58, 'wall_offset', 1.715, 0.4424),
  ('unknown', 58, 'width', -1.727, 0.4754),
  ('unknown', 58, 'z_max', 1.026, 0.2317),
  ('unknown', 58, 'z_min', 0.8703, 0.1928);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 59, 0.006886, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 59, 'aspect', 1.147, 0.4514),
  ('unknown', 59, 'behind', 0.3855, 0.1776),
  ('unknown', 59, 'corner_offset', 0.9111, 0.5493),
  ('unknown', 59, 'edge_concave', 0.2676, 0.1999),
  ('unknown', 59, 'edge_convex', 0.0006629, 0.03021),
  ('unknown', 59, 'edge_free', 0.3718, 0.07952),
  ('unknown', 59, 'edge_free_top', 0.008192, 0.03004),
  ('unknown', 59, 'edge_unseen', 0.01086, 0.04017),
  ('unknown', 59, 'headroom', 0.2013, 0.09746),
  ('unknown', 59, 'height', 0.4168, 0.1134),
  ('unknown', 59, 'lift', -4.849, 0.593),
  ('unknown', 59, 'rectangularity', 0.7574, 0.1002),
  ('unknown', 59, 'spread_length', -0.5722, 0.5742),
  ('unknown', 59, 'spread_width', -1.876, 0.4331),
  ('unknown', 59, 'standoff', 0.3268, 0.2385),
  ('unknown', 59, 'tilt_deg', 88.37, 1.908),
  ('unknown', 59, 'wall_offset', 0.6794, 0.8725),
  ('unknown', 59, 'width', -1.579, 0.4176),
  ('unknown', 59, 'z_max', 0.5783, 0.1333),
  ('unknown', 59, 'z_min', 0.2315, 0.06584);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 60, 0.009885, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 60, 'aspect', 0.4267, 0.2547),
  ('unknown', 60, 'behind', 0.5545, 0.1799),
  ('unknown', 60, 'corner_offset', 1.682, 0.7769),
  ('unknown', 60, 'edge_concave', 0.1697, 0.1443),
  ('unknown', 60, 'edge_convex', 0.01181, 0.03967),
  ('unknown', 60, 'edge_free', 0.7413, 0.1023),
  ('unknown', 60, 'edge_free_top', 0.9909, 0.03769),
  ('unknown', 60, 'edge_unseen', 0.1155, 0.1292),
  ('unknown', 60, 'headroom', 1.662, 0.2325),
  ('unknown', 60, 'height', 0.6854, 0.1153),
  ('unknown', 60, 'lift', -5.29, 0.4933),
  ('unknown', 60, 'rectangularity', 0.6739, 0.08948),
  ('unknown', 60, 'spread_length', -0.4226, 0.4261),
  ('unknown', 60, 'spread_width', -0.8807, 0.1124),
  ('unknown', 60, 'standoff', 0.2793, 0.3982),
  ('unknown', 60, 'tilt_deg', 77.95, 6.611),
  ('unknown', 60, 'wall_offset', 1.55, 1.672),
  ('unknown', 60, 'width', -0.7195, 0.2614),
  ('unknown', 60, 'z_max', 0.9998, 0.1994),
  ('unknown', 60, 'z_min', 0.516, 0.07732);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 61, 0.005687, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 61, 'aspect', 0.7833, 0.5363),
  ('unknown', 61, 'behind', 0.5033, 0.2247),
  ('unknown', 61, 'corner_offset', 2.36, 0.7971),
  ('unknown', 61, 'edge_concave', 0.3586, 0.318),
  ('unknown', 61, 'edge_convex', 0.1932, 0.2748),
  ('unknown', 61, 'edge_free', 0.375, 0.2518),
  ('unknown', 61, 'edge_free_top', 0.5408, 0.3391),
  ('unknown', 61, 'edge_unseen', 0.1916, 0.1294),
  ('unknown', 61, 'headroom', 0.624, 0.627),
  ('unknown', 61, 'height', 1.468, 0.3059),
  ('unknown', 61, 'lift', -2.897, 2.214),
  ('unknown', 61, 'rectangularity', 0.636, 0.06086),
  ('unknown', 61, 'spread_length', -0.9695, 0.6921),
  ('unknown', 61, 'spread_width', -1.757, 0.5672),
  ('unknown', 61, 'standoff', 0.4576, 0.3471),
  ('unknown', 61, 'tilt_deg', 56.54, 34.26),
  ('unknown', 61, 'wall_offset', 1.59, 0.5389),
  ('unknown', 61, 'width', -1.496, 0.589),
  ('unknown', 61, 'z_max', 1.711, 0.6982),
  ('unknown', 61, 'z_min', 1.307, 0.1291);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 62, 0.01342, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 62, 'aspect', 0.3699, 0.2423),
  ('unknown', 62, 'behind', 0.1786, 0.1215),
  ('unknown', 62, 'corner_offset', 1.57, 0.7045),
  ('unknown', 62, 'edge_concave', 0.3184, 0.2848),
  ('unknown', 62, 'edge_convex', 0.01554, 0.06188),
  ('unknown', 62, 'edge_free', 0.6515, 0.1344),
  ('unknown', 62, 'edge_free_top', 0.9824, 0.0479),
  ('unknown', 62, 'edge_unseen', 0.02888, 0.06722),
  ('unknown', 62, 'headroom', 0.7784, 0.5951),
  ('unknown', 62, 'height', 1.384, 0.302),
  ('unknown', 62, 'lift', -3.233, 2.048),
  ('unknown', 62, 'rectangularity', 0.7815, 0.07782),
  ('unknown', 62, 'spread_length', -1.323, 0.2262),
  ('unknown', 62, 'spread_width', -1.684, 0.2036),
  ('unknown', 62, 'standoff', 0.3148, 0.0882),
  ('unknown', 62, 'tilt_deg', 89.38, 0.5867),
  ('unknown', 62, 'wall_offset', 0.3118, 0.08853),
  ('unknown', 62, 'width', -1.502, 0.3556),
  ('unknown', 62, 'z_max', 1.536, 0.2802),
  ('unknown', 62, 'z_min', 1.241, 0.3047);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 63, 0.01265, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 63, 'aspect', 0.9999, 0.2948),
  ('unknown', 63, 'behind', 0.4084, 0.2614),
  ('unknown', 63, 'corner_offset', 1.01, 0.5716),
  ('unknown', 63, 'edge_concave', 0.005408, 0.03541),
  ('unknown', 63, 'edge_convex', 0.6262, 0.2127),
  ('unknown', 63, 'edge_free', 0.704, 0.1709),
  ('unknown', 63, 'edge_free_top', 0.5654, 0.3804),
  ('unknown', 63, 'edge_unseen', 0.08773, 0.1214),
  ('unknown', 63, 'headroom', 1.689, 0.5756),
  ('unknown', 63, 'height', 0.6165, 0.1113),
  ('unknown', 63, 'lift', -3.788, 1.623),
  ('unknown', 63, 'rectangularity', 0.655, 0.1731),
  ('unknown', 63, 'spread_length', -0.9039, 0.3344),
  ('unknown', 63, 'spread_width', -2.222, 0.189),
  ('unknown', 63, 'standoff', 0.5234, 0.569),
  ('unknown', 63, 'tilt_deg', 87.5, 1.831),
  ('unknown', 63, 'wall_offset', 1.615, 1.021),
  ('unknown', 63, 'width', -1.888, 0.3171),
  ('unknown', 63, 'z_max', 0.762, 0.1524),
  ('unknown', 63, 'z_min', 0.4446, 0.1081);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 64, 0.01229, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 64, 'aspect', 1.05, 0.6463),
  ('unknown', 64, 'behind', 0.8067, 0.0586),
  ('unknown', 64, 'corner_offset', 0.2673, 0.2665),
  ('unknown', 64, 'edge_concave', 0.7583, 0.07306),
  ('unknown', 64, 'edge_convex', 0.01694, 0.06202),
  ('unknown', 64, 'edge_free', 0.1633, 0.1778),
  ('unknown', 64, 'edge_free_top', 0.337, 0.2448),
  ('unknown', 64, 'edge_unseen', 0.01158, 0.03),
  ('unknown', 64, 'headroom', -0.2882, 0.6292),
  ('unknown', 64, 'height', 0.97, 0.1485),
  ('unknown', 64, 'lift', -5.225, 0.1585),
  ('unknown', 64, 'rectangularity', 0.4736, 0.1577),
  ('unknown', 64, 'spread_length', 0.5638, 0.2099),
  ('unknown', 64, 'spread_width', -0.5875, 0.8672),
  ('unknown', 64, 'standoff', 0.8097, 0.7187),
  ('unknown', 64, 'tilt_deg', 89.17, 0.9232),
  ('unknown', 64, 'wall_offset', 2.581, 0.8763),
  ('unknown', 64, 'width', -0.6022, 0.7337),
  ('unknown', 64, 'z_max', 1.877, 0.4204),
  ('unknown', 64, 'z_min', 0.04042, 0.178);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 65, 0.007616, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 65, 'aspect', 1.203, 0.3579),
  ('unknown', 65, 'behind', 0.6876, 0.0629),
  ('unknown', 65, 'corner_offset', 0.3928, 0.5272),
  ('unknown', 65, 'edge_concave', 0.6486, 0.1772),
  ('unknown', 65, 'edge_convex', 0.1236, 0.196),
  ('unknown', 65, 'edge_free', 0.3331, 0.2051),
  ('unknown', 65, 'edge_free_top', 0.5029, 0.3021),
  ('unknown', 65, 'edge_unseen', 0.008003, 0.03018),
  ('unknown', 65, 'headroom', 1.42, 0.7971),
  ('unknown', 65, 'height', 0.4911, 0.1017),
  ('unknown', 65, 'lift', -4.95, 0.4885),
  ('unknown', 65, 'rectangularity', 0.6232, 0.1193),
  ('unknown', 65, 'spread_length', -0.509, 0.1786),
  ('unknown', 65, 'spread_width', -2.027, 0.2829),
  ('unknown', 65, 'standoff', 0.7875, 0.4714),
  ('unknown', 65, 'tilt_deg', 88.67, 1.842),
  ('unknown', 65, 'wall_offset', 1.681, 0.6538),
  ('unknown', 65, 'width', -1.594, 0.2486),
  ('unknown', 65, 'z_max', 0.811, 0.1507),
  ('unknown', 65, 'z_min', 0.1433, 0.1031);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 66, 0.01334, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 66, 'aspect', 0.4314, 0.2318),
  ('unknown', 66, 'behind', 0.6905, 0.1233),
  ('unknown', 66, 'corner_offset', 0.5995, 0.4603),
  ('unknown', 66, 'edge_concave', 0.008984, 0.0423),
  ('unknown', 66, 'edge_convex', 0.5118, 0.1439),
  ('unknown', 66, 'edge_free', 0.7598, 0.1122),
  ('unknown', 66, 'edge_free_top', 0.9365, 0.09162),
  ('unknown', 66, 'edge_unseen', 0.003068, 0.03),
  ('unknown', 66, 'headroom', 0.9517, 1.021),
  ('unknown', 66, 'height', 0.3838, 0.0608),
  ('unknown', 66, 'lift', -4.937, 0.6018),
  ('unknown', 66, 'rectangularity', 0.7859, 0.1037),
  ('unknown', 66, 'spread_length', -1.087, 0.2909),
  ('unknown', 66, 'spread_width', -1.564, 0.172),
  ('unknown', 66, 'standoff', 0.6192, 0.1185),
  ('unknown', 66, 'tilt_deg', 3.263, 10.47),
  ('unknown', 66, 'wall_offset', 1.272, 0.6158),
  ('unknown', 66, 'width', -1.404, 0.3112),
  ('unknown', 66, 'z_max', 0.3858, 0.05876),
  ('unknown', 66, 'z_min', 0.3611, 0.06565);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 67, 0.005842, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 67, 'aspect', 2.388, 0.2463),
  ('unknown', 67, 'behind', 0.3416, 0.4064),
  ('unknown', 67, 'corner_offset', 1.818, 2.498),
  ('unknown', 67, 'edge_concave', 0.5236, 0.4392),
  ('unknown', 67, 'edge_convex', 0.1518, 0.2432),
  ('unknown', 67, 'edge_free', 0.1878, 0.2319),
  ('unknown', 67, 'edge_free_top', 0.01124, 0.03752),
  ('unknown', 67, 'edge_unseen', 0.1164, 0.1196),
  ('unknown', 67, 'headroom', 0.479, 0.2849),
  ('unknown', 67, 'height', 1.348, 0.5901),
  ('unknown', 67, 'lift', -5.179, 0.3225),
  ('unknown', 67, 'rectangularity', 0.7003, 0.06779),
  ('unknown', 67, 'spread_length', 0.3934, 0.3876),
  ('unknown', 67, 'spread_width', -2.087, 0.1718),
  ('unknown', 67, 'standoff', 0.6892, 0.2337),
  ('unknown', 67, 'tilt_deg', 89.65, 1.275),
  ('unknown', 67, 'wall_offset', 0.3622, 0.3798),
  ('unknown', 67, 'width', -1.782, 0.1915),
  ('unknown', 67, 'z_max', 2.046, 0.241),
  ('unknown', 67, 'z_min', 0.4967, 0.6108);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 68, 0.01028, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 68, 'aspect', 0.9699, 0.337),
  ('unknown', 68, 'behind', 0.2703, 0.2502),
  ('unknown', 68, 'corner_offset', 1.062, 0.3232),
  ('unknown', 68, 'edge_concave', 0.006201, 0.03),
  ('unknown', 68, 'edge_convex', 0.08587, 0.1657),
  ('unknown', 68, 'edge_free', 0.9287, 0.12),
  ('unknown', 68, 'edge_free_top', 0.5846, 0.1294),
  ('unknown', 68, 'edge_unseen', 0.2371, 0.1495),
  ('unknown', 68, 'headroom', 0.2714, 0.1091),
  ('unknown', 68, 'height', 2.592, 0.3901),
  ('unknown', 68, 'lift', 0.3848, 0.2212),
  ('unknown', 68, 'rectangularity', 0.7253, 0.1276),
  ('unknown', 68, 'spread_length', -0.7931, 0.4667),
  ('unknown', 68, 'spread_width', -1.71, 0.1941),
  ('unknown', 68, 'standoff', 0.4754, 0.1252),
  ('unknown', 68, 'tilt_deg', 1.38, 1.587),
  ('unknown', 68, 'wall_offset', 0.808, 0.4243),
  ('unknown', 68, 'width', -1.568, 0.2171),
  ('unknown', 68, 'z_max', 2.599, 0.4004),
  ('unknown', 68, 'z_min', 2.594, 0.3947);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 69, 0.005481, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 69, 'aspect', 0.6671, 0.2532),
  ('unknown', 69, 'behind', 0.6271, 0.1246),
  ('unknown', 69, 'corner_offset', 1.977, 0.437),
  ('unknown', 69, 'edge_concave', 0.2974, 0.2018),
  ('unknown', 69, 'edge_convex', 0.137, 0.1791),
  ('unknown', 69, 'edge_free', 0.4989, 0.1648),
  ('unknown', 69, 'edge_free_top', 0.6276, 0.3066),
  ('unknown', 69, 'edge_unseen', 0.00281, 0.03),
  ('unknown', 69, 'headroom', 0.9506, 0.8374),
  ('unknown', 69, 'height', 0.8764, 0.1079),
  ('unknown', 69, 'lift', -4.547, 0.5449),
  ('unknown', 69, 'rectangularity', 0.6955, 0.05205),
  ('unknown', 69, 'spread_length', -1.075, 0.367),
  ('unknown', 69, 'spread_width', -1.795, 0.1624),
  ('unknown', 69, 'standoff', 0.6491, 0.388),
  ('unknown', 69, 'tilt_deg', 86.86, 2.94),
  ('unknown', 69, 'wall_offset', 1.305, 0.4904),
  ('unknown', 69, 'width', -1.498, 0.2511),
  ('unknown', 69, 'z_max', 1.091, 0.1755),
  ('unknown', 69, 'z_min', 0.6584, 0.0679);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 70, 0.008771, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 70, 'aspect', 1.48, 0.2821),
  ('unknown', 70, 'behind', 0.6469, 0.1112),
  ('unknown', 70, 'corner_offset', -0.09201, 0.08172),
  ('unknown', 70, 'edge_concave', 0.8916, 0.1403),
  ('unknown', 70, 'edge_convex', 0.0002563, 0.03),
  ('unknown', 70, 'edge_free', 0.02616, 0.06062),
  ('unknown', 70, 'edge_free_top', 0.5843, 0.129),
  ('unknown', 70, 'edge_unseen', 0.05, 0.0793),
  ('unknown', 70, 'headroom', 1.192, 0.1392),
  ('unknown', 70, 'height', 0.8887, 0.06422),
  ('unknown', 70, 'lift', -3.531, 0.6006),
  ('unknown', 70, 'rectangularity', 0.7633, 0.08727),
  ('unknown', 70, 'spread_length', -0.06118, 0.3113),
  ('unknown', 70, 'spread_width', -1.48, 0.2071),
  ('unknown', 70, 'standoff', 0.4717, 0.1313),
  ('unknown', 70, 'tilt_deg', 1.257, 0.9327),
  ('unknown', 70, 'wall_offset', 0.7966, 0.7915),
  ('unknown', 70, 'width', -1.362, 0.2938),
  ('unknown', 70, 'z_max', 0.8928, 0.06338),
  ('unknown', 70, 'z_min', 0.8829, 0.06738);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 71, 0.005088, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 71, 'aspect', 0.5972, 0.3508),
  ('unknown', 71, 'behind', 0.4028, 0.2925),
  ('unknown', 71, 'corner_offset', 0.9337, 0.6811),
  ('unknown', 71, 'edge_concave', 0.3016, 0.147),
  ('unknown', 71, 'edge_convex', 0.001202, 0.03),
  ('unknown', 71, 'edge_free', 0.2473, 0.2018),
  ('unknown', 71, 'edge_free_top', 0.5235, 0.3307),
  ('unknown', 71, 'edge_unseen', 0.2096, 0.17),
  ('unknown', 71, 'headroom', 0.3917, 0.3009),
  ('unknown', 71, 'height', 0.2795, 0.1349),
  ('unknown', 71, 'lift', -4.4, 0.8086),
  ('unknown', 71, 'rectangularity', 0.6909, 0.07309),
  ('unknown', 71, 'spread_length', -1.458, 0.3238),
  ('unknown', 71, 'spread_width', -2.129, 0.2747),
  ('unknown', 71, 'standoff', 0.5327, 0.2937),
  ('unknown', 71, 'tilt_deg', 65.12, 32.12),
  ('unknown', 71, 'wall_offset', 1.781, 0.373),
  ('unknown', 71, 'width', -1.858, 0.3044),
  ('unknown', 71, 'z_max', 0.3582, 0.1779),
  ('unknown', 71, 'z_min', 0.1621, 0.1652);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 72, 0.02009, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 72, 'aspect', 0.2826, 0.2158),
  ('unknown', 72, 'behind', 0.4037, 0.09625),
  ('unknown', 72, 'corner_offset', 1.186, 0.6754),
  ('unknown', 72, 'edge_concave', 0.5122, 0.2008),
  ('unknown', 72, 'edge_convex', 0.062, 0.08113),
  ('unknown', 72, 'edge_free', 0.4563, 0.2252),
  ('unknown', 72, 'edge_free_top', 0.6217, 0.2129),
  ('unknown', 72, 'edge_unseen', 0.007978, 0.03001),
  ('unknown', 72, 'headroom', 0.6684, 0.942),
  ('unknown', 72, 'height', 0.8111, 0.4337),
  ('unknown', 72, 'lift', -2.213, 1.661),
  ('unknown', 72, 'rectangularity', 0.698, 0.1071),
  ('unknown', 72, 'spread_length', -0.1552, 0.2743),
  ('unknown', 72, 'spread_width', -0.5603, 0.3123),
  ('unknown', 72, 'standoff', 0.2219, 0.03619),
  ('unknown', 72, 'tilt_deg', 81.66, 7.651),
  ('unknown', 72, 'wall_offset', 0.2363, 0.04225),
  ('unknown', 72, 'width', -0.3168, 0.2516),
  ('unknown', 72, 'z_max', 1.405, 0.406),
  ('unknown', 72, 'z_min', 0.3295, 0.4623);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 73, 0.003567, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 73, 'aspect', 1.865, 0.6433),
  ('unknown', 73, 'behind', 0.5363, 0.2557),
  ('unknown', 73, 'corner_offset', 1.518, 0.4941),
  ('unknown', 73, 'edge_concave', 0.003173, 0.03005),
  ('unknown', 73, 'edge_convex', 0.7489, 0.1171),
  ('unknown', 73, 'edge_free', 0.8692, 0.1527),
  ('unknown', 73, 'edge_free_top', 0.9915, 0.03),
  ('unknown', 73, 'edge_unseen', 0.02457, 0.04687),
  ('unknown', 73, 'headroom', 0.2792, 0.1725),
  ('unknown', 73, 'height', 2.403, 0.1814),
  ('unknown', 73, 'lift', -5.288, 0.08351),
  ('unknown', 73, 'rectangularity', 0.7603, 0.0718),
  ('unknown', 73, 'spread_length', -0.1984, 0.7335),
  ('unknown', 73, 'spread_width', -2.452, 0.07218),
  ('unknown', 73, 'standoff', 1.017, 0.2225),
  ('unknown', 73, 'tilt_deg', 87.06, 3.124),
  ('unknown', 73, 'wall_offset', 1.53, 0.9833),
  ('unknown', 73, 'width', -2.207, 0.1642),
  ('unknown', 73, 'z_max', 2.487, 0.2224),
  ('unknown', 73, 'z_min', 2.328, 0.1684);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 74, 0.007559, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 74, 'aspect', 0.3246, 0.2396),
  ('unknown', 74, 'behind', 0.547, 0.157),
  ('unknown', 74, 'corner_offset', 1.697, 0.7336),
  ('unknown', 74, 'edge_concave', 0.4565, 0.1124),
  ('unknown', 74, 'edge_convex', 0.003053, 0.03),
  ('unknown', 74, 'edge_free', 0.6653, 0.09375),
  ('unknown', 74, 'edge_free_top', 0.9853, 0.04077),
  ('unknown', 74, 'edge_unseen', 0.004232, 0.03074),
  ('unknown', 74, 'headroom', 1.765, 0.2153),
  ('unknown', 74, 'height', 0.8795, 0.07122),
  ('unknown', 74, 'lift', -4.842, 0.5902),
  ('unknown', 74, 'rectangularity', 0.7266, 0.1335),
  ('unknown', 74, 'spread_length', -1.346, 0.068),
  ('unknown', 74, 'spread_width', -1.517, 0.0732),
  ('unknown', 74, 'standoff', 0.5132, 0.2436),
  ('unknown', 74, 'tilt_deg', 74.53, 2.792),
  ('unknown', 74, 'wall_offset', 1.019, 0.855),
  ('unknown', 74, 'width', -1.396, 0.104),
  ('unknown', 74, 'z_max', 0.9845, 0.07787),
  ('unknown', 74, 'z_min', 0.752, 0.08349);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 75, 0.003818, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 75, 'aspect', 0.298, 0.2063),
  ('unknown', 75, 'behind', 0.643, 0.2109),
  ('unknown', 75, 'corner_offset', 1.362, 0.927),
  ('unknown', 75, 'edge_concave', 0.3233, 0.2787),
  ('unknown', 75, 'edge_convex', 0.00116, 0.03156),
  ('unknown', 75, 'edge_free', 0.497, 0.1833),
  ('unknown', 75, 'edge_free_top', 0.7605, 0.2691),
  ('unknown', 75, 'edge_unseen', 0.001556, 0.03105),
  ('unknown', 75, 'headroom', 2.45, 0.2413),
  ('unknown', 75, 'height', 0.2429, 0.04999),
  ('unknown', 75, 'lift', -3.503, 0.6257),
  ('unknown', 75, 'rectangularity', 0.746, 0.06469),
  ('unknown', 75, 'spread_length', -1.587, 0.2316),
  ('unknown', 75, 'spread_width', -1.954, 0.2363),
  ('unknown', 75, 'standoff', 0.4052, 0.3434),
  ('unknown', 75, 'tilt_deg', 86.48, 4.095),
  ('unknown', 75, 'wall_offset', 0.7052, 0.5879),
  ('unknown', 75, 'width', -1.709, 0.2436),
  ('unknown', 75, 'z_max', 0.3504, 0.06247),
  ('unknown', 75, 'z_min', 0.1093, 0.08832);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 76, 0.003668, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 76, 'aspect', 1.644, 0.2039),
  ('unknown', 76, 'behind', 0.01109, 0.03),
  ('unknown', 76, 'corner_offset', 1.08, 0.3211),
  ('unknown', 76, 'edge_concave', 0.003128, 0.03),
  ('unknown', 76, 'edge_convex', 0.112, 0.1932),
  ('unknown', 76, 'edge_free', 0.9652, 0.05324),
  ('unknown', 76, 'edge_free_top', 0.5846, 0.1291),
  ('unknown', 76, 'edge_unseen', 0.03985, 0.05743),
  ('unknown', 76, 'headroom', 0.2463, 0.1394),
  ('unknown', 76, 'height', 2.709, 0.2143),
  ('unknown', 76, 'lift', -0.5729, 1.182),
  ('unknown', 76, 'rectangularity', 0.8596, 0.04045),
  ('unknown', 76, 'spread_length', 0.1777, 0.2018),
  ('unknown', 76, 'spread_width', -1.559, 0.06495),
  ('unknown', 76, 'standoff', 0.4711, 0.1299),
  ('unknown', 76, 'tilt_deg', 1.261, 2.243),
  ('unknown', 76, 'wall_offset', 0.7926, 0.7921),
  ('unknown', 76, 'width', -1.438, 0.1381),
  ('unknown', 76, 'z_max', 2.714, 0.2205),
  ('unknown', 76, 'z_min', 2.704, 0.2159);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 77, 0.005684, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 77, 'aspect', 0.8921, 0.4684),
  ('unknown', 77, 'behind', 0.7186, 0.1143),
  ('unknown', 77, 'corner_offset', 1.357, 1.068),
  ('unknown', 77, 'edge_concave', 0.4904, 0.1204),
  ('unknown', 77, 'edge_convex', 0.002904, 0.03),
  ('unknown', 77, 'edge_free', 0.3261, 0.1458),
  ('unknown', 77, 'edge_free_top', 0.2104, 0.192),
  ('unknown', 77, 'edge_unseen', 0.007121, 0.03009),
  ('unknown', 77, 'headroom', 0.5889, 0.4212),
  ('unknown', 77, 'height', 1.198, 0.1377),
  ('unknown', 77, 'lift', -1.051, 0.305),
  ('unknown', 77, 'rectangularity', 0.6356, 0.09054),
  ('unknown', 77, 'spread_length', -0.5276, 0.602),
  ('unknown', 77, 'spread_width', -1.499, 0.5221),
  ('unknown', 77, 'standoff', 0.4702, 0.135),
  ('unknown', 77, 'tilt_deg', 16.61, 12.33),
  ('unknown', 77, 'wall_offset', -1.79, 1.161),
  ('unknown', 77, 'width', -1.398, 0.3483),
  ('unknown', 77, 'z_max', 1.245, 0.135),
  ('unknown', 77, 'z_min', 1.165, 0.1493);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 78, 0.008988, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 78, 'aspect', 0.383, 0.2456),
  ('unknown', 78, 'behind', 0.01454, 0.03),
  ('unknown', 78, 'corner_offset', 1.657, 1.047),
  ('unknown', 78, 'edge_concave', 0.05963, 0.1921),
  ('unknown', 78, 'edge_convex', 0.03034, 0.05099),
  ('unknown', 78, 'edge_free', 0.4082, 0.2062),
  ('unknown', 78, 'edge_free_top', 0.4028, 0.08692),
  ('unknown', 78, 'edge_unseen', 0.02616, 0.04597),
  ('unknown', 78, 'headroom', 0.4153, 0.4512),
  ('unknown', 78, 'height', 1.305, 0.1633),
  ('unknown', 78, 'lift', -3.176, 2.056),
  ('unknown', 78, 'rectangularity', 0.4049, 0.2757),
  ('unknown', 78, 'spread_length', 0.7065, 0.4466),
  ('unknown', 78, 'spread_width', 0.02592, 0.5437),
  ('unknown', 78, 'standoff', 0.06525, 0.0165),
  ('unknown', 78, 'tilt_deg', 88.27, 0.5075),
  ('unknown', 78, 'wall_offset', -0.0286, 0.2584),
  ('unknown', 78, 'width', 0.2503, 0.359),
  ('unknown', 78, 'z_max', 2.4, 0.4052),
  ('unknown', 78, 'z_min', 0.1685, 0.946);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 79, 0.008772, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 79, 'aspect', 0.5289, 0.08681),
  ('unknown', 79, 'behind', 0.02479, 0.05924),
  ('unknown', 79, 'corner_offset', 1.905, 0.95),
  ('unknown', 79, 'edge_concave', 0.09101, 0.105),
  ('unknown', 79, 'edge_convex', 0.001729, 0.03006),
  ('unknown', 79, 'edge_free', 0.8791, 0.1459),
  ('unknown', 79, 'edge_free_top', 0.9494, 0.08055),
  ('unknown', 79, 'edge_unseen', 0.09551, 0.1308),
  ('unknown', 79, 'headroom', 0.7891, 0.2015),
  ('unknown', 79, 'height', 1.61, 0.09841),
  ('unknown', 79, 'lift', -0.7822, 0.6495),
  ('unknown', 79, 'rectangularity', 0.8467, 0.1553),
  ('unknown', 79, 'spread_length', -0.09437, 0.1837),
  ('unknown', 79, 'spread_width', -0.6843, 0.1854),
  ('unknown', 79, 'standoff', 0.139, 0.05518),
  ('unknown', 79, 'tilt_deg', 89.73, 0.9395),
  ('unknown', 79, 'wall_offset', 0.1317, 0.04),
  ('unknown', 79, 'width', -0.4185, 0.2205),
  ('unknown', 79, 'z_max', 1.99, 0.1332),
  ('unknown', 79, 'z_min', 1.327, 0.08932);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 80, 0.003966, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 80, 'aspect', 1.706, 0.6418),
  ('unknown', 80, 'behind', 0.642, 0.1616),
  ('unknown', 80, 'corner_offset', 1.875, 0.8575),
  ('unknown', 80, 'edge_concave', 0.02984, 0.06997),
  ('unknown', 80, 'edge_convex', 0.5892, 0.1126),
  ('unknown', 80, 'edge_free', 0.587, 0.2535),
  ('unknown', 80, 'edge_free_top', 0.6705, 0.4007),
  ('unknown', 80, 'edge_unseen', 0.03213, 0.04354),
  ('unknown', 80, 'headroom', 0.1111, 0.1378),
  ('unknown', 80, 'height', 2.629, 0.3649),
  ('unknown', 80, 'lift', -5.28, 0.09541),
  ('unknown', 80, 'rectangularity', 0.6739, 0.1103),
  ('unknown', 80, 'spread_length', 0.1951, 0.7946),
  ('unknown', 80, 'spread_width', -2.167, 0.5175),
  ('unknown', 80, 'standoff', 1.099, 0.1364),
  ('unknown', 80, 'tilt_deg', 84.36, 6.701),
  ('unknown', 80, 'wall_offset', 1.056, 0.2887),
  ('unknown', 80, 'width', -1.553, 0.4967),
  ('unknown', 80, 'z_max', 2.779, 0.3818),
  ('unknown', 80, 'z_min', 2.517, 0.3341);

-- floor: 1034 examples
UPDATE object_class SET prior = 0.0261 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4772, 0.3961)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'corner_offset', 1.373, 0.5663)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_concave', 0.3473, 0.1674)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_convex', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_unseen', 0.2542, 0.1431)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'headroom', 2.314, 0.8562)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.0015, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5831, 0.1313)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.8776, 0.7015)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.2735, 0.8961)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.5866, 0.9678)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.6535, 0.9878)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.007768, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.004713, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'floor';
DELETE FROM class_density WHERE class = 'floor';
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.07553, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'aspect', 0.2427, 0.1692),
  ('floor', 1, 'behind', -0.001895, 0.03748),
  ('floor', 1, 'corner_offset', 1.557, 0.7595),
  ('floor', 1, 'edge_concave', 0.3736, 0.1127),
  ('floor', 1, 'edge_convex', -0.000137, 0.03521),
  ('floor', 1, 'edge_free', -0.0005212, 0.03356),
  ('floor', 1, 'edge_free_top', -0.0005408, 0.3226),
  ('floor', 1, 'edge_unseen', 0.2119, 0.1295),
  ('floor', 1, 'headroom', 2.765, 0.2434),
  ('floor', 1, 'height', 1.355e-05, 0.0225),
  ('floor', 1, 'lift', -0.000156, 0.3161),
  ('floor', 1, 'rectangularity', 0.5371, 0.1196),
  ('floor', 1, 'spread_length', 1.33, 0.09366),
  ('floor', 1, 'spread_width', 0.9267, 0.1187),
  ('floor', 1, 'standoff', 0.0003232, 0.3168),
  ('floor', 1, 'tilt_deg', 0.008369, 0.496),
  ('floor', 1, 'wall_offset', 0.01574, 0.3158),
  ('floor', 1, 'width', 1.469, 0.09924),
  ('floor', 1, 'z_max', 0.0006346, 0.02264),
  ('floor', 1, 'z_min', 0.0005496, 0.02273);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.07164, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'aspect', 0.2009, 0.09934),
  ('floor', 2, 'behind', -0.002445, 0.03398),
  ('floor', 2, 'corner_offset', 1.61, 0.3027),
  ('floor', 2, 'edge_concave', 0.4475, 0.1005),
  ('floor', 2, 'edge_convex', -4.203e-05, 0.03373),
  ('floor', 2, 'edge_free', -0.0002502, 0.03269),
  ('floor', 2, 'edge_free_top', -0.0008618, 0.3223),
  ('floor', 2, 'edge_unseen', 0.1865, 0.06139),
  ('floor', 2, 'headroom', 2.779, 0.2014),
  ('floor', 2, 'height', 0.001215, 0.0225),
  ('floor', 2, 'lift', 8.792e-07, 0.3163),
  ('floor', 2, 'rectangularity', 0.6312, 0.08495),
  ('floor', 2, 'spread_length', 1.134, 0.08482),
  ('floor', 2, 'spread_width', 0.8139, 0.1212),
  ('floor', 2, 'standoff', 0.0001877, 0.3168),
  ('floor', 2, 'tilt_deg', 0.01425, 0.481),
  ('floor', 2, 'wall_offset', 0.02418, 0.308),
  ('floor', 2, 'width', 1.241, 0.109),
  ('floor', 2, 'z_max', 0.003669, 0.02677),
  ('floor', 2, 'z_min', 0.001558, 0.02461);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.05608, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'aspect', 0.7061, 0.1853),
  ('floor', 3, 'behind', -0.001133, 0.03832),
  ('floor', 3, 'corner_offset', 1.224, 0.4689),
  ('floor', 3, 'edge_concave', 0.4073, 0.08565),
  ('floor', 3, 'edge_convex', -0.0001666, 0.03395),
  ('floor', 3, 'edge_free', -0.001225, 0.03127),
  ('floor', 3, 'edge_free_top', -0.001322, 0.328),
  ('floor', 3, 'edge_unseen', 0.259, 0.07438),
  ('floor', 3, 'headroom', 2.683, 0.1996),
  ('floor', 3, 'height', -0.0001801, 0.0225),
  ('floor', 3, 'lift', -0.0001646, 0.3159),
  ('floor', 3, 'rectangularity', 0.5279, 0.111),
  ('floor', 3, 'spread_length', 1.257, 0.1865),
  ('floor', 3, 'spread_width', 0.5756, 0.1524),
  ('floor', 3, 'standoff', 0.0004234, 0.3171),
  ('floor', 3, 'tilt_deg', 0.02204, 0.4732),
  ('floor', 3, 'wall_offset', 0.008251, 0.3527),
  ('floor', 3, 'width', 0.9391, 0.2136),
  ('floor', 3, 'z_max', 0.0008908, 0.0225),
  ('floor', 3, 'z_min', -0.0002273, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.09397, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'aspect', 0.9165, 0.4158),
  ('floor', 4, 'behind', -0.009446, 0.03),
  ('floor', 4, 'corner_offset', 0.5227, 0.2294),
  ('floor', 4, 'edge_concave', 0.3216, 0.09632),
  ('floor', 4, 'edge_convex', -0.0003785, 0.04863),
  ('floor', 4, 'edge_free', -0.002806, 0.03008),
  ('floor', 4, 'edge_free_top', -0.003479, 0.3263),
  ('floor', 4, 'edge_unseen', 0.3535, 0.1062),
  ('floor', 4, 'headroom', 0.8418, 0.1343),
  ('floor', 4, 'height', -0.01078, 0.02467),
  ('floor', 4, 'lift', 0.000695, 0.3113),
  ('floor', 4, 'rectangularity', 0.7027, 0.1078),
  ('floor', 4, 'spread_length', -0.2851, 0.4119),
  ('floor', 4, 'spread_width', -1.246, 0.3173),
  ('floor', 4, 'standoff', -0.001871, 0.3227),
  ('floor', 4, 'tilt_deg', 1.943, 0.4501),
  ('floor', 4, 'wall_offset', -0.01128, 0.3673),
  ('floor', 4, 'width', -1.063, 0.3042),
  ('floor', 4, 'z_max', 0.006297, 0.04092),
  ('floor', 4, 'z_min', -0.02717, 0.0226);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.0598, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'aspect', 0.6668, 0.5828),
  ('floor', 5, 'behind', -0.01026, 0.03),
  ('floor', 5, 'corner_offset', 0.8414, 0.1688),
  ('floor', 5, 'edge_concave', 0.1628, 0.138),
  ('floor', 5, 'edge_convex', -0.002947, 0.03223),
  ('floor', 5, 'edge_free', -0.003021, 0.03),
  ('floor', 5, 'edge_free_top', -0.00286, 0.3309),
  ('floor', 5, 'edge_unseen', 0.3579, 0.1679),
  ('floor', 5, 'headroom', 0.8426, 0.1385),
  ('floor', 5, 'height', 0.01746, 0.04074),
  ('floor', 5, 'lift', -0.001098, 0.3138),
  ('floor', 5, 'rectangularity', 0.5521, 0.1579),
  ('floor', 5, 'spread_length', 0.3995, 0.3301),
  ('floor', 5, 'spread_width', -0.335, 0.2722),
  ('floor', 5, 'standoff', -1.053e-05, 0.3265),
  ('floor', 5, 'tilt_deg', 1.56, 0.5717),
  ('floor', 5, 'wall_offset', -0.001689, 0.3681),
  ('floor', 5, 'width', -0.06138, 0.3094),
  ('floor', 5, 'z_max', 0.04315, 0.04287),
  ('floor', 5, 'z_min', -0.003703, 0.04218);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.03706, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'aspect', 0.3914, 0.2527),
  ('floor', 6, 'behind', -0.001391, 0.03062),
  ('floor', 6, 'corner_offset', 1.25, 0.3624),
  ('floor', 6, 'edge_concave', 0.2105, 0.1072),
  ('floor', 6, 'edge_convex', -0.0002867, 0.03345),
  ('floor', 6, 'edge_free', -0.002564, 0.03002),
  ('floor', 6, 'edge_free_top', -0.001544, 0.3357),
  ('floor', 6, 'edge_unseen', 0.3623, 0.08564),
  ('floor', 6, 'headroom', 0.8492, 0.3038),
  ('floor', 6, 'height', -0.0004618, 0.0225),
  ('floor', 6, 'lift', -0.0001709, 0.3163),
  ('floor', 6, 'rectangularity', 0.5871, 0.07134),
  ('floor', 6, 'spread_length', 0.9165, 0.1583),
  ('floor', 6, 'spread_width', 0.444, 0.31),
  ('floor', 6, 'standoff', 0.001171, 0.3299),
  ('floor', 6, 'tilt_deg', 1.326, 0.4832),
  ('floor', 6, 'wall_offset', 0.01077, 0.3548),
  ('floor', 6, 'width', 0.7593, 0.2902),
  ('floor', 6, 'z_max', 0.03526, 0.02341),
  ('floor', 6, 'z_min', -0.03964, 0.02251);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.03076, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'aspect', 0.4573, 0.3459),
  ('floor', 7, 'behind', -0.0009406, 0.03521),
  ('floor', 7, 'corner_offset', 1.374, 0.4475),
  ('floor', 7, 'edge_concave', 0.3362, 0.0781),
  ('floor', 7, 'edge_convex', -0.0001499, 0.0326),
  ('floor', 7, 'edge_free', -0.0008193, 0.03074),
  ('floor', 7, 'edge_free_top', -0.0007942, 0.3241),
  ('floor', 7, 'edge_unseen', 0.1786, 0.1138),
  ('floor', 7, 'headroom', 0.7201, 0.1854),
  ('floor', 7, 'height', -0.000326, 0.0225),
  ('floor', 7, 'lift', -8.768e-05, 0.3161),
  ('floor', 7, 'rectangularity', 0.4544, 0.1226),
  ('floor', 7, 'spread_length', 1.444, 0.169),
  ('floor', 7, 'spread_width', 0.7714, 0.2902),
  ('floor', 7, 'standoff', 0.0003644, 0.3175),
  ('floor', 7, 'tilt_deg', 0.02791, 0.4614),
  ('floor', 7, 'wall_offset', 0.01216, 0.3327),
  ('floor', 7, 'width', 1.296, 0.2781),
  ('floor', 7, 'z_max', 0.0002178, 0.0225),
  ('floor', 7, 'z_min', -0.0003548, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.02737, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'aspect', 1.328, 0.188),
  ('floor', 8, 'behind', -0.002633, 0.03),
  ('floor', 8, 'corner_offset', 0.8032, 0.1741),
  ('floor', 8, 'edge_concave', 0.1128, 0.1183),
  ('floor', 8, 'edge_convex', -1.985e-05, 0.03006),
  ('floor', 8, 'edge_free', -0.000904, 0.03),
  ('floor', 8, 'edge_free_top', -0.003191, 0.3256),
  ('floor', 8, 'edge_unseen', 0.4513, 0.1383),
  ('floor', 8, 'headroom', 1.298, 0.2566),
  ('floor', 8, 'height', -0.1894, 0.3205),
  ('floor', 8, 'lift', 0.002273, 0.3135),
  ('floor', 8, 'rectangularity', 0.6898, 0.0745),
  ('floor', 8, 'spread_length', -0.1709, 0.5),
  ('floor', 8, 'spread_width', -1.516, 0.4957),
  ('floor', 8, 'standoff', -0.002276, 0.3234),
  ('floor', 8, 'tilt_deg', 2.768, 0.5611),
  ('floor', 8, 'wall_offset', -0.01003, 0.3567),
  ('floor', 8, 'width', -1.369, 0.6251),
  ('floor', 8, 'z_max', -0.2084, 0.3143),
  ('floor', 8, 'z_min', -0.1659, 0.3347);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.02278, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'aspect', 1.389, 0.3043),
  ('floor', 9, 'behind', -0.001887, 0.03),
  ('floor', 9, 'corner_offset', 0.09452, 0.6575),
  ('floor', 9, 'edge_concave', 0.3107, 0.1679),
  ('floor', 9, 'edge_convex', -0.0001455, 0.03135),
  ('floor', 9, 'edge_free', -0.000606, 0.03),
  ('floor', 9, 'edge_free_top', -0.001957, 0.3192),
  ('floor', 9, 'edge_unseen', 0.3714, 0.1698),
  ('floor', 9, 'headroom', 2.48, 0.1575),
  ('floor', 9, 'height', -0.002765, 0.0225),
  ('floor', 9, 'lift', -0.0008154, 0.3158),
  ('floor', 9, 'rectangularity', 0.5891, 0.09906),
  ('floor', 9, 'spread_length', 0.3715, 0.3237),
  ('floor', 9, 'spread_width', -1.11, 0.3962),
  ('floor', 9, 'standoff', -0.0004771, 0.3197),
  ('floor', 9, 'tilt_deg', 0.6167, 0.45),
  ('floor', 9, 'wall_offset', -0.004479, 0.3429),
  ('floor', 9, 'width', -0.833, 0.4477),
  ('floor', 9, 'z_max', 0.004799, 0.02405),
  ('floor', 9, 'z_min', -0.007872, 0.02402);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 10, 0.0931, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 10, 'aspect', 0.2554, 0.1943),
  ('floor', 10, 'behind', -0.002206, 0.03784),
  ('floor', 10, 'corner_offset', 1.706, 0.402),
  ('floor', 10, 'edge_concave', 0.426, 0.1108),
  ('floor', 10, 'edge_convex', -1.033e-05, 0.03474),
  ('floor', 10, 'edge_free', -0.0009741, 0.03313),
  ('floor', 10, 'edge_free_top', 1.522e-05, 0.3288),
  ('floor', 10, 'edge_unseen', 0.1833, 0.1011),
  ('floor', 10, 'headroom', 2.754, 0.2273),
  ('floor', 10, 'height', 5.556e-05, 0.0225),
  ('floor', 10, 'lift', -0.0003104, 0.3162),
  ('floor', 10, 'rectangularity', 0.614, 0.08023),
  ('floor', 10, 'spread_length', 1.308, 0.1279),
  ('floor', 10, 'spread_width', 0.9415, 0.108),
  ('floor', 10, 'standoff', 0.0002525, 0.3171),
  ('floor', 10, 'tilt_deg', -0.01064, 0.4672),
  ('floor', 10, 'wall_offset', 0.01807, 0.3303),
  ('floor', 10, 'width', 1.429, 0.1217),
  ('floor', 10, 'z_max', 0.0007167, 0.0225),
  ('floor', 10, 'z_min', 0.001629, 0.02255);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 11, 0.05868, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 11, 'aspect', 0.5287, 0.3172),
  ('floor', 11, 'behind', -0.001604, 0.03727),
  ('floor', 11, 'corner_offset', 1.126, 0.7653),
  ('floor', 11, 'edge_concave', 0.2856, 0.08489),
  ('floor', 11, 'edge_convex', -0.0001668, 0.03526),
  ('floor', 11, 'edge_free', -0.0005983, 0.033),
  ('floor', 11, 'edge_free_top', -0.001119, 0.3311),
  ('floor', 11, 'edge_unseen', 0.2178, 0.09074),
  ('floor', 11, 'headroom', 1.841, 0.9161),
  ('floor', 11, 'height', -0.001109, 0.0225),
  ('floor', 11, 'lift', -4.932e-06, 0.3161),
  ('floor', 11, 'rectangularity', 0.4611, 0.08589),
  ('floor', 11, 'spread_length', 1.291, 0.1577),
  ('floor', 11, 'spread_width', 0.6969, 0.1793),
  ('floor', 11, 'standoff', 0.0006343, 0.3207),
  ('floor', 11, 'tilt_deg', 0.01065, 0.45),
  ('floor', 11, 'wall_offset', 0.03151, 0.3333),
  ('floor', 11, 'width', 1.186, 0.2179),
  ('floor', 11, 'z_max', 0.0007878, 0.0225),
  ('floor', 11, 'z_min', 0.0003637, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 12, 0.06084, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 12, 'aspect', 0.5227, 0.174),
  ('floor', 12, 'behind', -0.001591, 0.03721),
  ('floor', 12, 'corner_offset', 1.462, 0.2704),
  ('floor', 12, 'edge_concave', 0.4422, 0.0692),
  ('floor', 12, 'edge_convex', 5.996e-06, 0.03438),
  ('floor', 12, 'edge_free', -0.0003906, 0.03349),
  ('floor', 12, 'edge_free_top', -6.807e-05, 0.33),
  ('floor', 12, 'edge_unseen', 0.2306, 0.06084),
  ('floor', 12, 'headroom', 2.708, 0.2129),
  ('floor', 12, 'height', 0.0002086, 0.0225),
  ('floor', 12, 'lift', -4.976e-05, 0.3162),
  ('floor', 12, 'rectangularity', 0.6195, 0.08271),
  ('floor', 12, 'spread_length', 1.206, 0.1274),
  ('floor', 12, 'spread_width', 0.6727, 0.1218),
  ('floor', 12, 'standoff', 0.000329, 0.3169),
  ('floor', 12, 'tilt_deg', 0.01252, 0.4636),
  ('floor', 12, 'wall_offset', 0.03376, 0.2845),
  ('floor', 12, 'width', 1.015, 0.1664),
  ('floor', 12, 'z_max', 0.001138, 0.0226),
  ('floor', 12, 'z_min', 0.00199, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 13, 0.08377, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 13, 'aspect', 0.7893, 0.5682),
  ('floor', 13, 'behind', -0.01196, 0.03),
  ('floor', 13, 'corner_offset', 0.2581, 0.2607),
  ('floor', 13, 'edge_concave', 0.3716, 0.1211),
  ('floor', 13, 'edge_convex', -5.714e-05, 0.03981),
  ('floor', 13, 'edge_free', -0.002957, 0.03),
  ('floor', 13, 'edge_free_top', -0.0007563, 0.3223),
  ('floor', 13, 'edge_unseen', 0.3438, 0.1698),
  ('floor', 13, 'headroom', 1.48, 0.3502),
  ('floor', 13, 'height', 0.003605, 0.03384),
  ('floor', 13, 'lift', -0.003597, 0.3106),
  ('floor', 13, 'rectangularity', 0.5566, 0.04325),
  ('floor', 13, 'spread_length', -0.7027, 0.326),
  ('floor', 13, 'spread_width', -1.392, 0.2264),
  ('floor', 13, 'standoff', -0.001857, 0.3199),
  ('floor', 13, 'tilt_deg', 2.683, 0.4548),
  ('floor', 13, 'wall_offset', -0.02065, 0.3252),
  ('floor', 13, 'width', -1.15, 0.1934),
  ('floor', 13, 'z_max', 0.01383, 0.04357),
  ('floor', 13, 'z_min', 0.0001013, 0.02459);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 14, 0.04788, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 14, 'aspect', 0.4123, 0.2028),
  ('floor', 14, 'behind', -0.005432, 0.03),
  ('floor', 14, 'corner_offset', 0.7146, 0.5801),
  ('floor', 14, 'edge_concave', 0.2646, 0.1184),
  ('floor', 14, 'edge_convex', -4.759e-05, 0.03472),
  ('floor', 14, 'edge_free', -0.004185, 0.03),
  ('floor', 14, 'edge_free_top', -0.0003369, 0.3223),
  ('floor', 14, 'edge_unseen', 0.3526, 0.09477),
  ('floor', 14, 'headroom', 1.234, 0.7268),
  ('floor', 14, 'height', 0.003937, 0.02355),
  ('floor', 14, 'lift', -0.0002743, 0.3158),
  ('floor', 14, 'rectangularity', 0.5232, 0.08783),
  ('floor', 14, 'spread_length', 0.3268, 0.2345),
  ('floor', 14, 'spread_width', -0.2047, 0.1753),
  ('floor', 14, 'standoff', -5.055e-05, 0.3174),
  ('floor', 14, 'tilt_deg', 1.157, 1.044),
  ('floor', 14, 'wall_offset', 0.003038, 0.3247),
  ('floor', 14, 'width', 0.1038, 0.09465),
  ('floor', 14, 'z_max', 0.01936, 0.02524),
  ('floor', 14, 'z_min', -0.01161, 0.02519);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 15, 0.06618, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 15, 'aspect', 0.9117, 0.5172),
  ('floor', 15, 'behind', -0.01737, 0.03),
  ('floor', 15, 'corner_offset', 1.169, 0.8464),
  ('floor', 15, 'edge_concave', 0.3545, 0.09795),
  ('floor', 15, 'edge_convex', -2.873e-05, 0.04352),
  ('floor', 15, 'edge_free', -0.004635, 0.03),
  ('floor', 15, 'edge_free_top', -0.0005133, 0.3194),
  ('floor', 15, 'edge_unseen', 0.3094, 0.06147),
  ('floor', 15, 'headroom', 0.8407, 0.1544),
  ('floor', 15, 'height', -0.0001024, 0.02252),
  ('floor', 15, 'lift', 0.000395, 0.3139),
  ('floor', 15, 'rectangularity', 0.6894, 0.09219),
  ('floor', 15, 'spread_length', 0.08123, 0.3172),
  ('floor', 15, 'spread_width', -0.7739, 0.1471),
  ('floor', 15, 'standoff', -0.0008088, 0.3165),
  ('floor', 15, 'tilt_deg', 2.135, 0.4505),
  ('floor', 15, 'wall_offset', 0.0001853, 0.3272),
  ('floor', 15, 'width', -0.5861, 0.1559),
  ('floor', 15, 'z_max', 0.01665, 0.02259),
  ('floor', 15, 'z_min', -0.01702, 0.02259);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 16, 0.04306, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 16, 'aspect', 0.3953, 0.2209),
  ('floor', 16, 'behind', -0.001757, 0.03047),
  ('floor', 16, 'corner_offset', 1.171, 0.3912),
  ('floor', 16, 'edge_concave', 0.2036, 0.1205),
  ('floor', 16, 'edge_convex', -0.0001606, 0.03437),
  ('floor', 16, 'edge_free', -0.0004063, 0.03248),
  ('floor', 16, 'edge_free_top', -0.0002799, 0.3313),
  ('floor', 16, 'edge_unseen', 0.4101, 0.09238),
  ('floor', 16, 'headroom', 0.813, 0.2471),
  ('floor', 16, 'height', 0.002605, 0.02253),
  ('floor', 16, 'lift', -0.0005821, 0.3166),
  ('floor', 16, 'rectangularity', 0.5785, 0.06613),
  ('floor', 16, 'spread_length', 0.7975, 0.1617),
  ('floor', 16, 'spread_width', 0.3351, 0.2177),
  ('floor', 16, 'standoff', 5.363e-05, 0.3171),
  ('floor', 16, 'tilt_deg', 1.534, 0.5964),
  ('floor', 16, 'wall_offset', 0.01379, 0.3444),
  ('floor', 16, 'width', 0.6453, 0.2269),
  ('floor', 16, 'z_max', 0.04159, 0.02277),
  ('floor', 16, 'z_min', -0.03542, 0.02615);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 17, 0.02148, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 17, 'aspect', 1.082, 0.5863),
  ('floor', 17, 'behind', -0.003371, 0.03023),
  ('floor', 17, 'corner_offset', 1.346, 0.391),
  ('floor', 17, 'edge_concave', 0.02172, 0.0317),
  ('floor', 17, 'edge_convex', -2.803e-05, 0.03243),
  ('floor', 17, 'edge_free', -0.0008903, 0.03),
  ('floor', 17, 'edge_free_top', -0.001362, 0.3241),
  ('floor', 17, 'edge_unseen', 0.3381, 0.1912),
  ('floor', 17, 'headroom', 1.543, 0.3899),
  ('floor', 17, 'height', -0.2278, 0.22),
  ('floor', 17, 'lift', 0.001034, 0.3138),
  ('floor', 17, 'rectangularity', 0.6319, 0.111),
  ('floor', 17, 'spread_length', -0.5302, 0.4974),
  ('floor', 17, 'spread_width', -1.653, 0.201),
  ('floor', 17, 'standoff', -0.001488, 0.3206),
  ('floor', 17, 'tilt_deg', 2.902, 1.9),
  ('floor', 17, 'wall_offset', -0.01153, 0.3754),
  ('floor', 17, 'width', -1.399, 0.1823),
  ('floor', 17, 'z_max', -0.2502, 0.1914),
  ('floor', 17, 'z_min', -0.2372, 0.2412);

-- ceiling: 870 examples
UPDATE object_class SET prior = 0.0329 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4171, 0.3899)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.01187, 0.06056)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'corner_offset', 1.075, 0.7925)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_concave', 0.5579, 0.1594)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_convex', 0.006655, 0.044)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.01143, 0.06103)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_unseen', 0.3096, 0.152)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.833, 0.314)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'lift', 0.7787, 0.2221)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6749, 0.1235)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.091, 0.7278)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.5056, 0.8855)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.09206, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.7938, 0.9461)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.834, 0.3143)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.833, 0.3138)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'ceiling';
DELETE FROM class_density WHERE class = 'ceiling';
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.1088, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'aspect', 0.2434, 0.1977),
  ('ceiling', 1, 'behind', -0.0008067, 0.03001),
  ('ceiling', 1, 'corner_offset', 1.483, 0.5447),
  ('ceiling', 1, 'edge_concave', 0.602, 0.1098),
  ('ceiling', 1, 'edge_convex', 1.666e-05, 0.03),
  ('ceiling', 1, 'edge_free', 5.844e-05, 0.03),
  ('ceiling', 1, 'edge_free_top', -0.0003868, 0.3326),
  ('ceiling', 1, 'edge_unseen', 0.3205, 0.1018),
  ('ceiling', 1, 'headroom', -0.02202, 0.3607),
  ('ceiling', 1, 'height', 2.524, 0.08065),
  ('ceiling', 1, 'lift', 0.7783, 0.05979),
  ('ceiling', 1, 'rectangularity', 0.6822, 0.1182),
  ('ceiling', 1, 'spread_length', 1.438, 0.1513),
  ('ceiling', 1, 'spread_width', 1.002, 0.1872),
  ('ceiling', 1, 'standoff', -0.0001405, 0.3171),
  ('ceiling', 1, 'tilt_deg', -0.01552, 0.45),
  ('ceiling', 1, 'wall_offset', 0.04328, 0.3355),
  ('ceiling', 1, 'width', 1.34, 0.192),
  ('ceiling', 1, 'z_max', 2.518, 0.08183),
  ('ceiling', 1, 'z_min', 2.523, 0.08536);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.07574, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'aspect', 0.2171, 0.1264),
  ('ceiling', 2, 'behind', 1.03e-05, 0.03039),
  ('ceiling', 2, 'corner_offset', 1.539, 0.4409),
  ('ceiling', 2, 'edge_concave', 0.5913, 0.1088),
  ('ceiling', 2, 'edge_convex', 7.358e-05, 0.03021),
  ('ceiling', 2, 'edge_free', 9.59e-05, 0.03016),
  ('ceiling', 2, 'edge_free_top', -0.0002829, 0.3262),
  ('ceiling', 2, 'edge_unseen', 0.3371, 0.1043),
  ('ceiling', 2, 'headroom', -0.01217, 0.3369),
  ('ceiling', 2, 'height', 2.738, 0.06563),
  ('ceiling', 2, 'lift', 0.7733, 0.07357),
  ('ceiling', 2, 'rectangularity', 0.6604, 0.1036),
  ('ceiling', 2, 'spread_length', 1.488, 0.1307),
  ('ceiling', 2, 'spread_width', 1.031, 0.1788),
  ('ceiling', 2, 'standoff', 2.554e-05, 0.3165),
  ('ceiling', 2, 'tilt_deg', -0.02441, 0.45),
  ('ceiling', 2, 'wall_offset', 0.04436, 0.2732),
  ('ceiling', 2, 'width', 1.372, 0.1345),
  ('ceiling', 2, 'z_max', 2.735, 0.05879),
  ('ceiling', 2, 'z_min', 2.74, 0.06787);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.07009, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'aspect', 0.222, 0.1343),
  ('ceiling', 3, 'behind', -0.0001359, 0.03115),
  ('ceiling', 3, 'corner_offset', 1.3, 0.3204),
  ('ceiling', 3, 'edge_concave', 0.6311, 0.129),
  ('ceiling', 3, 'edge_convex', 1.719e-05, 0.03001),
  ('ceiling', 3, 'edge_free', 7.226e-05, 0.03001),
  ('ceiling', 3, 'edge_free_top', -0.0001395, 0.3278),
  ('ceiling', 3, 'edge_unseen', 0.2907, 0.09777),
  ('ceiling', 3, 'headroom', -0.01233, 0.3468),
  ('ceiling', 3, 'height', 2.97, 0.08848),
  ('ceiling', 3, 'lift', 0.7706, 0.06922),
  ('ceiling', 3, 'rectangularity', 0.6902, 0.1494),
  ('ceiling', 3, 'spread_length', 1.465, 0.1469),
  ('ceiling', 3, 'spread_width', 1.002, 0.1852),
  ('ceiling', 3, 'standoff', 1.544e-05, 0.3163),
  ('ceiling', 3, 'tilt_deg', -0.009394, 0.45),
  ('ceiling', 3, 'wall_offset', 0.03431, 0.3904),
  ('ceiling', 3, 'width', 1.355, 0.1567),
  ('ceiling', 3, 'z_max', 2.959, 0.07368),
  ('ceiling', 3, 'z_min', 2.973, 0.0932);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.04628, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'aspect', 0.6909, 0.2063),
  ('ceiling', 4, 'behind', 0.0001872, 0.03),
  ('ceiling', 4, 'corner_offset', 0.8196, 0.4145),
  ('ceiling', 4, 'edge_concave', 0.6011, 0.06504),
  ('ceiling', 4, 'edge_convex', 0.0001507, 0.03),
  ('ceiling', 4, 'edge_free', 0.0001441, 0.03),
  ('ceiling', 4, 'edge_free_top', -0.0001758, 0.3234),
  ('ceiling', 4, 'edge_unseen', 0.338, 0.05209),
  ('ceiling', 4, 'headroom', -0.009024, 0.3402),
  ('ceiling', 4, 'height', 2.976, 0.133),
  ('ceiling', 4, 'lift', 0.7693, 0.06785),
  ('ceiling', 4, 'rectangularity', 0.6482, 0.1329),
  ('ceiling', 4, 'spread_length', 1.358, 0.1701),
  ('ceiling', 4, 'spread_width', 0.583, 0.222),
  ('ceiling', 4, 'standoff', 4.32e-05, 0.3161),
  ('ceiling', 4, 'tilt_deg', -0.003435, 0.45),
  ('ceiling', 4, 'wall_offset', 0.02208, 0.3291),
  ('ceiling', 4, 'width', 0.8188, 0.2174),
  ('ceiling', 4, 'z_max', 2.973, 0.135),
  ('ceiling', 4, 'z_min', 2.975, 0.1378);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.04236, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'aspect', 0.6198, 0.3747),
  ('ceiling', 5, 'behind', -0.0003596, 0.03275),
  ('ceiling', 5, 'corner_offset', 0.1589, 0.1569),
  ('ceiling', 5, 'edge_concave', 0.4967, 0.1228),
  ('ceiling', 5, 'edge_convex', 0.001727, 0.03545),
  ('ceiling', 5, 'edge_free', 0.01059, 0.03927),
  ('ceiling', 5, 'edge_free_top', -0.001201, 0.3246),
  ('ceiling', 5, 'edge_unseen', 0.5468, 0.09286),
  ('ceiling', 5, 'headroom', -0.1301, 0.1213),
  ('ceiling', 5, 'height', 3.194, 0.3179),
  ('ceiling', 5, 'lift', 0.67, 0.3471),
  ('ceiling', 5, 'rectangularity', 0.6042, 0.07462),
  ('ceiling', 5, 'spread_length', -0.45, 0.3702),
  ('ceiling', 5, 'spread_width', -1.151, 0.424),
  ('ceiling', 5, 'standoff', -0.001502, 0.319),
  ('ceiling', 5, 'tilt_deg', 0.2406, 0.4505),
  ('ceiling', 5, 'wall_offset', 0.004567, 0.3312),
  ('ceiling', 5, 'width', -0.9107, 0.4577),
  ('ceiling', 5, 'z_max', 3.173, 0.3298),
  ('ceiling', 5, 'z_min', 3.202, 0.3033);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.02913, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'aspect', 1.043, 0.6455),
  ('ceiling', 6, 'behind', 0.0009833, 0.03),
  ('ceiling', 6, 'corner_offset', -0.6442, 0.4936),
  ('ceiling', 6, 'edge_concave', 0.2734, 0.1233),
  ('ceiling', 6, 'edge_convex', 0.0001632, 0.03054),
  ('ceiling', 6, 'edge_free', 0.0002293, 0.03),
  ('ceiling', 6, 'edge_free_top', -0.0001742, 0.3191),
  ('ceiling', 6, 'edge_unseen', 0.08168, 0.1157),
  ('ceiling', 6, 'headroom', -0.1412, 0.1587),
  ('ceiling', 6, 'height', 2.503, 0.0225),
  ('ceiling', 6, 'lift', 0.7813, 0.05453),
  ('ceiling', 6, 'rectangularity', 0.741, 0.129),
  ('ceiling', 6, 'spread_length', -0.04185, 0.4344),
  ('ceiling', 6, 'spread_width', -0.8539, 0.2193),
  ('ceiling', 6, 'standoff', -0.0003587, 0.3157),
  ('ceiling', 6, 'tilt_deg', 0.1891, 0.4504),
  ('ceiling', 6, 'wall_offset', 0.001447, 0.3161),
  ('ceiling', 6, 'width', -0.9354, 0.7274),
  ('ceiling', 6, 'z_max', 2.502, 0.0225),
  ('ceiling', 6, 'z_min', 2.503, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.04603, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'aspect', 0.4039, 0.2786),
  ('ceiling', 7, 'behind', 0.0002713, 0.03),
  ('ceiling', 7, 'corner_offset', 0.6451, 0.8172),
  ('ceiling', 7, 'edge_concave', 0.4777, 0.1007),
  ('ceiling', 7, 'edge_convex', 0.0002474, 0.03),
  ('ceiling', 7, 'edge_free', 0.0002158, 0.03),
  ('ceiling', 7, 'edge_free_top', -0.0002188, 0.3272),
  ('ceiling', 7, 'edge_unseen', 0.2762, 0.0721),
  ('ceiling', 7, 'headroom', -0.01223, 0.3289),
  ('ceiling', 7, 'height', 3.494, 0.2178),
  ('ceiling', 7, 'lift', 0.773, 0.07329),
  ('ceiling', 7, 'rectangularity', 0.6148, 0.1146),
  ('ceiling', 7, 'spread_length', 1.385, 0.2625),
  ('ceiling', 7, 'spread_width', 0.7802, 0.2915),
  ('ceiling', 7, 'standoff', 9.49e-05, 0.3169),
  ('ceiling', 7, 'tilt_deg', 0.01621, 0.45),
  ('ceiling', 7, 'wall_offset', 0.02949, 0.3229),
  ('ceiling', 7, 'width', 1.09, 0.3541),
  ('ceiling', 7, 'z_max', 3.503, 0.2153),
  ('ceiling', 7, 'z_min', 3.492, 0.2284);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.01863, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'aspect', 0.7964, 0.5314),
  ('ceiling', 8, 'behind', 0.01017, 0.03),
  ('ceiling', 8, 'corner_offset', 1.46, 1.711),
  ('ceiling', 8, 'edge_concave', 0.4252, 0.1049),
  ('ceiling', 8, 'edge_convex', 0.000481, 0.03206),
  ('ceiling', 8, 'edge_free', 0.002126, 0.03175),
  ('ceiling', 8, 'edge_free_top', -0.0009225, 0.3307),
  ('ceiling', 8, 'edge_unseen', 0.3314, 0.1357),
  ('ceiling', 8, 'headroom', -0.05778, 0.2916),
  ('ceiling', 8, 'height', 3.149, 0.5555),
  ('ceiling', 8, 'lift', 0.782, 0.06583),
  ('ceiling', 8, 'rectangularity', 0.632, 0.04826),
  ('ceiling', 8, 'spread_length', 0.3923, 0.2372),
  ('ceiling', 8, 'spread_width', -0.5145, 0.4679),
  ('ceiling', 8, 'standoff', -0.00077, 0.3183),
  ('ceiling', 8, 'tilt_deg', 0.1193, 0.45),
  ('ceiling', 8, 'wall_offset', 0.0223, 0.3305),
  ('ceiling', 8, 'width', -0.256, 0.5183),
  ('ceiling', 8, 'z_max', 3.093, 0.6127),
  ('ceiling', 8, 'z_min', 3.135, 0.5613);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.02179, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'aspect', 1.015, 0.3549),
  ('ceiling', 9, 'behind', 0.2922, 0.06346),
  ('ceiling', 9, 'corner_offset', 0.5896, 0.3041),
  ('ceiling', 9, 'edge_concave', 0.5047, 0.07269),
  ('ceiling', 9, 'edge_convex', 0.2952, 0.0501),
  ('ceiling', 9, 'edge_free', 0.2893, 0.07364),
  ('ceiling', 9, 'edge_free_top', -0.0006213, 0.3165),
  ('ceiling', 9, 'edge_unseen', 0.141, 0.05079),
  ('ceiling', 9, 'headroom', -0.03407, 0.2992),
  ('ceiling', 9, 'height', 2.894, 0.437),
  ('ceiling', 9, 'lift', 0.7746, 0.07018),
  ('ceiling', 9, 'rectangularity', 0.797, 0.08009),
  ('ceiling', 9, 'spread_length', 0.8495, 0.3343),
  ('ceiling', 9, 'spread_width', -0.2239, 0.3048),
  ('ceiling', 9, 'standoff', -0.001325, 0.3151),
  ('ceiling', 9, 'tilt_deg', 0.01823, 0.45),
  ('ceiling', 9, 'wall_offset', -0.001899, 0.3147),
  ('ceiling', 9, 'width', -0.09626, 0.27),
  ('ceiling', 9, 'z_max', 2.878, 0.4419),
  ('ceiling', 9, 'z_min', 2.884, 0.4416);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 10, 0.01613, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 10, 'aspect', 0.6578, 0.3896),
  ('ceiling', 10, 'behind', 0.364, 0.1264),
  ('ceiling', 10, 'corner_offset', 0.3221, 0.4658),
  ('ceiling', 10, 'edge_concave', 0.5485, 0.1695),
  ('ceiling', 10, 'edge_convex', 0.01748, 0.04002),
  ('ceiling', 10, 'edge_free', 0.301, 0.1207),
  ('ceiling', 10, 'edge_free_top', -0.0005662, 0.3173),
  ('ceiling', 10, 'edge_unseen', 0.2309, 0.08266),
  ('ceiling', 10, 'headroom', -0.03383, 0.3024),
  ('ceiling', 10, 'height', 2.981, 0.2158),
  ('ceiling', 10, 'lift', 0.7799, 0.05887),
  ('ceiling', 10, 'rectangularity', 0.7016, 0.09794),
  ('ceiling', 10, 'spread_length', 0.5901, 0.308),
  ('ceiling', 10, 'spread_width', -0.2395, 0.3752),
  ('ceiling', 10, 'standoff', -0.001756, 0.3129),
  ('ceiling', 10, 'tilt_deg', 0.05984, 0.45),
  ('ceiling', 10, 'wall_offset', -0.00356, 0.3086),
  ('ceiling', 10, 'width', 0.001224, 0.3956),
  ('ceiling', 10, 'z_max', 2.98, 0.2147),
  ('ceiling', 10, 'z_min', 2.981, 0.213);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 11, 0.08299, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 11, 'aspect', 0.3571, 0.2958),
  ('ceiling', 11, 'behind', -9.704e-05, 0.03),
  ('ceiling', 11, 'corner_offset', 1.158, 0.6392),
  ('ceiling', 11, 'edge_concave', 0.5925, 0.09333),
  ('ceiling', 11, 'edge_convex', 6.951e-05, 0.03),
  ('ceiling', 11, 'edge_free', -5.293e-05, 0.03),
  ('ceiling', 11, 'edge_free_top', -4.807e-05, 0.3259),
  ('ceiling', 11, 'edge_unseen', 0.332, 0.07657),
  ('ceiling', 11, 'headroom', -0.01005, 0.3657),
  ('ceiling', 11, 'height', 2.985, 0.08086),
  ('ceiling', 11, 'lift', -0.7762, 0.6799),
  ('ceiling', 11, 'rectangularity', 0.6609, 0.0877),
  ('ceiling', 11, 'spread_length', 1.433, 0.1504),
  ('ceiling', 11, 'spread_width', 0.8221, 0.2636),
  ('ceiling', 11, 'standoff', 0.0002408, 0.3171),
  ('ceiling', 11, 'tilt_deg', -0.03003, 0.45),
  ('ceiling', 11, 'wall_offset', 0.03194, 0.372),
  ('ceiling', 11, 'width', 1.159, 0.3166),
  ('ceiling', 11, 'z_max', 2.98, 0.07599),
  ('ceiling', 11, 'z_min', 2.983, 0.08596);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 12, 0.09119, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 12, 'aspect', 0.2455, 0.1832),
  ('ceiling', 12, 'behind', -7.452e-06, 0.03),
  ('ceiling', 12, 'corner_offset', 1.548, 0.4452),
  ('ceiling', 12, 'edge_concave', 0.6007, 0.07156),
  ('ceiling', 12, 'edge_convex', 7.69e-05, 0.03003),
  ('ceiling', 12, 'edge_free', -0.0009033, 0.03),
  ('ceiling', 12, 'edge_free_top', -0.0001044, 0.3231),
  ('ceiling', 12, 'edge_unseen', 0.3551, 0.07726),
  ('ceiling', 12, 'headroom', -0.0128, 0.3147),
  ('ceiling', 12, 'height', 2.487, 0.08687),
  ('ceiling', 12, 'lift', -0.8014, 0.6479),
  ('ceiling', 12, 'rectangularity', 0.6845, 0.07191),
  ('ceiling', 12, 'spread_length', 1.44, 0.1709),
  ('ceiling', 12, 'spread_width', 1.036, 0.1813),
  ('ceiling', 12, 'standoff', 0.0004664, 0.3174),
  ('ceiling', 12, 'tilt_deg', -0.005539, 0.45),
  ('ceiling', 12, 'wall_offset', 0.01828, 0.3543),
  ('ceiling', 12, 'width', 1.369, 0.2038),
  ('ceiling', 12, 'z_max', 2.483, 0.08757),
  ('ceiling', 12, 'z_min', 2.487, 0.09198);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 13, 0.0599, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 13, 'aspect', 0.2622, 0.235),
  ('ceiling', 13, 'behind', 3.951e-05, 0.0301),
  ('ceiling', 13, 'corner_offset', 1.389, 0.5855),
  ('ceiling', 13, 'edge_concave', 0.5908, 0.08341),
  ('ceiling', 13, 'edge_convex', 7.836e-05, 0.03001),
  ('ceiling', 13, 'edge_free', 3.797e-05, 0.03),
  ('ceiling', 13, 'edge_free_top', -2.101e-05, 0.3199),
  ('ceiling', 13, 'edge_unseen', 0.371, 0.07372),
  ('ceiling', 13, 'headroom', -0.008071, 0.326),
  ('ceiling', 13, 'height', 2.671, 0.05168),
  ('ceiling', 13, 'lift', -0.7732, 0.6642),
  ('ceiling', 13, 'rectangularity', 0.6514, 0.07903),
  ('ceiling', 13, 'spread_length', 1.433, 0.1403),
  ('ceiling', 13, 'spread_width', 0.942, 0.2328),
  ('ceiling', 13, 'standoff', 0.0001598, 0.317),
  ('ceiling', 13, 'tilt_deg', -0.01217, 0.45),
  ('ceiling', 13, 'wall_offset', 0.01225, 0.3403),
  ('ceiling', 13, 'width', 1.278, 0.2723),
  ('ceiling', 13, 'z_max', 2.672, 0.04982),
  ('ceiling', 13, 'z_min', 2.671, 0.05496);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 14, 0.0474, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 14, 'aspect', 0.1675, 0.1092),
  ('ceiling', 14, 'behind', 0.0001643, 0.03082),
  ('ceiling', 14, 'corner_offset', 1.751, 0.3077),
  ('ceiling', 14, 'edge_concave', 0.6252, 0.09784),
  ('ceiling', 14, 'edge_convex', 8.966e-05, 0.03002),
  ('ceiling', 14, 'edge_free', 0.0001971, 0.03002),
  ('ceiling', 14, 'edge_free_top', -4.664e-05, 0.3188),
  ('ceiling', 14, 'edge_unseen', 0.3014, 0.08507),
  ('ceiling', 14, 'headroom', -0.002793, 0.3197),
  ('ceiling', 14, 'height', 2.812, 0.05287),
  ('ceiling', 14, 'lift', -0.7741, 0.6812),
  ('ceiling', 14, 'rectangularity', 0.7277, 0.08256),
  ('ceiling', 14, 'spread_length', 1.44, 0.1466),
  ('ceiling', 14, 'spread_width', 1.068, 0.1816),
  ('ceiling', 14, 'standoff', -5.497e-05, 0.3165),
  ('ceiling', 14, 'tilt_deg', -0.004861, 0.4504),
  ('ceiling', 14, 'wall_offset', 0.005216, 0.3356),
  ('ceiling', 14, 'width', 1.362, 0.1728),
  ('ceiling', 14, 'z_max', 2.813, 0.05145),
  ('ceiling', 14, 'z_min', 2.813, 0.05309);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 15, 0.04094, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 15, 'aspect', 0.5587, 0.2881),
  ('ceiling', 15, 'behind', 0.002961, 0.03002),
  ('ceiling', 15, 'corner_offset', -0.1165, 0.4796),
  ('ceiling', 15, 'edge_concave', 0.2451, 0.1743),
  ('ceiling', 15, 'edge_convex', 7.743e-05, 0.0301),
  ('ceiling', 15, 'edge_free', -5.266e-05, 0.03002),
  ('ceiling', 15, 'edge_free_top', -0.000295, 0.3211),
  ('ceiling', 15, 'edge_unseen', 0.0912, 0.1346),
  ('ceiling', 15, 'headroom', -0.1588, 0.1142),
  ('ceiling', 15, 'height', 2.511, 0.02579),
  ('ceiling', 15, 'lift', -3.005, 1.138),
  ('ceiling', 15, 'rectangularity', 0.763, 0.07278),
  ('ceiling', 15, 'spread_length', -0.2016, 0.7144),
  ('ceiling', 15, 'spread_width', -0.8705, 0.4644),
  ('ceiling', 15, 'standoff', -0.0007985, 0.3177),
  ('ceiling', 15, 'tilt_deg', 0.2762, 0.4511),
  ('ceiling', 15, 'wall_offset', 0.005549, 0.3182),
  ('ceiling', 15, 'width', -0.7694, 0.581),
  ('ceiling', 15, 'z_max', 2.512, 0.02602),
  ('ceiling', 15, 'z_min', 2.511, 0.02453);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 16, 0.03302, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 16, 'aspect', 0.5775, 0.489),
  ('ceiling', 16, 'behind', 0.0001321, 0.03015),
  ('ceiling', 16, 'corner_offset', 0.3734, 0.5983),
  ('ceiling', 16, 'edge_concave', 0.5058, 0.08671),
  ('ceiling', 16, 'edge_convex', 0.0001686, 0.03033),
  ('ceiling', 16, 'edge_free', -0.001703, 0.03),
  ('ceiling', 16, 'edge_free_top', -4.607e-05, 0.318),
  ('ceiling', 16, 'edge_unseen', 0.5488, 0.09555),
  ('ceiling', 16, 'headroom', -0.06086, 0.4355),
  ('ceiling', 16, 'height', 2.993, 0.05243),
  ('ceiling', 16, 'lift', 0.6231, 0.4108),
  ('ceiling', 16, 'rectangularity', 0.6098, 0.05416),
  ('ceiling', 16, 'spread_length', -0.2096, 0.3322),
  ('ceiling', 16, 'spread_width', -0.9144, 0.5492),
  ('ceiling', 16, 'standoff', -0.0005121, 0.3166),
  ('ceiling', 16, 'tilt_deg', 0.605, 1.137),
  ('ceiling', 16, 'wall_offset', -0.003186, 0.3153),
  ('ceiling', 16, 'width', -0.6313, 0.3488),
  ('ceiling', 16, 'z_max', 2.995, 0.05064),
  ('ceiling', 16, 'z_min', 2.991, 0.05287);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 17, 0.04258, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 17, 'aspect', 0.4653, 0.3459),
  ('ceiling', 17, 'behind', 0.0003114, 0.03),
  ('ceiling', 17, 'corner_offset', 0.7614, 0.6121),
  ('ceiling', 17, 'edge_concave', 0.512, 0.1106),
  ('ceiling', 17, 'edge_convex', 0.0001902, 0.03),
  ('ceiling', 17, 'edge_free', 0.0001483, 0.03),
  ('ceiling', 17, 'edge_free_top', -0.0003165, 0.3245),
  ('ceiling', 17, 'edge_unseen', 0.3121, 0.07439),
  ('ceiling', 17, 'headroom', -0.004947, 0.3242),
  ('ceiling', 17, 'height', 3.476, 0.2117),
  ('ceiling', 17, 'lift', -0.775, 0.6803),
  ('ceiling', 17, 'rectangularity', 0.5824, 0.1054),
  ('ceiling', 17, 'spread_length', 1.315, 0.3358),
  ('ceiling', 17, 'spread_width', 0.6659, 0.3656),
  ('ceiling', 17, 'standoff', 0.0002041, 0.3169),
  ('ceiling', 17, 'tilt_deg', 0.008937, 0.45),
  ('ceiling', 17, 'wall_offset', 0.01387, 0.3299),
  ('ceiling', 17, 'width', 0.991, 0.372),
  ('ceiling', 17, 'z_max', 3.489, 0.1996),
  ('ceiling', 17, 'z_min', 3.477, 0.2199);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 18, 0.02325, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 18, 'aspect', 0.215, 0.1379),
  ('ceiling', 18, 'behind', 0.000484, 0.03107),
  ('ceiling', 18, 'corner_offset', 1.511, 0.5936),
  ('ceiling', 18, 'edge_concave', 0.8646, 0.1003),
  ('ceiling', 18, 'edge_convex', 0.0001998, 0.03008),
  ('ceiling', 18, 'edge_free', 0.0004361, 0.03006),
  ('ceiling', 18, 'edge_free_top', -1.102e-05, 0.3182),
  ('ceiling', 18, 'edge_unseen', 0.06984, 0.06409),
  ('ceiling', 18, 'headroom', -0.003884, 0.3218),
  ('ceiling', 18, 'height', 2.743, 0.156),
  ('ceiling', 18, 'lift', -0.7744, 0.6818),
  ('ceiling', 18, 'rectangularity', 0.8847, 0.0585),
  ('ceiling', 18, 'spread_length', 1.462, 0.1175),
  ('ceiling', 18, 'spread_width', 1.123, 0.1672),
  ('ceiling', 18, 'standoff', -5.896e-05, 0.3167),
  ('ceiling', 18, 'tilt_deg', -0.0001444, 0.45),
  ('ceiling', 18, 'wall_offset', 0.003089, 0.3448),
  ('ceiling', 18, 'width', 1.421, 0.1393),
  ('ceiling', 18, 'z_max', 2.741, 0.1496),
  ('ceiling', 18, 'z_min', 2.746, 0.1578);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 19, 0.03654, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 19, 'aspect', 0.9164, 0.4185),
  ('ceiling', 19, 'behind', 0.3197, 0.1307),
  ('ceiling', 19, 'corner_offset', 0.7046, 0.2458),
  ('ceiling', 19, 'edge_concave', 0.5805, 0.2079),
  ('ceiling', 19, 'edge_convex', 0.09159, 0.1441),
  ('ceiling', 19, 'edge_free', 0.2374, 0.1427),
  ('ceiling', 19, 'edge_free_top', -0.002905, 0.3161),
  ('ceiling', 19, 'edge_unseen', 0.1607, 0.1428),
  ('ceiling', 19, 'headroom', -0.07281, 0.3093),
  ('ceiling', 19, 'height', 2.793, 0.3496),
  ('ceiling', 19, 'lift', -0.8053, 0.6264),
  ('ceiling', 19, 'rectangularity', 0.7058, 0.1375),
  ('ceiling', 19, 'spread_length', 1.041, 0.356),
  ('ceiling', 19, 'spread_width', -0.184, 0.3273),
  ('ceiling', 19, 'standoff', -0.0006513, 0.3161),
  ('ceiling', 19, 'tilt_deg', 0.01183, 0.45),
  ('ceiling', 19, 'wall_offset', 0.006186, 0.2867),
  ('ceiling', 19, 'width', 0.0365, 0.2796),
  ('ceiling', 19, 'z_max', 2.769, 0.3501),
  ('ceiling', 19, 'z_min', 2.786, 0.3663);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 20, 0.01719, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 20, 'aspect', 0.7047, 0.5358),
  ('ceiling', 20, 'behind', 0.0007598, 0.03003),
  ('ceiling', 20, 'corner_offset', 0.3467, 0.2744),
  ('ceiling', 20, 'edge_concave', 0.5121, 0.05907),
  ('ceiling', 20, 'edge_convex', 0.0002507, 0.03),
  ('ceiling', 20, 'edge_free', -0.0001757, 0.03),
  ('ceiling', 20, 'edge_free_top', -2.515e-05, 0.3172),
  ('ceiling', 20, 'edge_unseen', 0.4328, 0.1062),
  ('ceiling', 20, 'headroom', -0.1027, 0.2283),
  ('ceiling', 20, 'height', 3.485, 0.1752),
  ('ceiling', 20, 'lift', 0.1393, 0.7469),
  ('ceiling', 20, 'rectangularity', 0.6459, 0.1327),
  ('ceiling', 20, 'spread_length', 0.04321, 0.625),
  ('ceiling', 20, 'spread_width', -0.7826, 0.4667),
  ('ceiling', 20, 'standoff', -0.0002283, 0.3167),
  ('ceiling', 20, 'tilt_deg', 0.2159, 0.451),
  ('ceiling', 20, 'wall_offset', 0.000876, 0.3033),
  ('ceiling', 20, 'width', -0.5588, 0.4713),
  ('ceiling', 20, 'z_max', 3.488, 0.179),
  ('ceiling', 20, 'z_min', 3.488, 0.1774);

-- wall: 5206 examples
UPDATE object_class SET prior = 0.3102 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.6671, 0.496)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.09276, 0.1811)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'corner_offset', 1.411, 1.058)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_concave', 0.4195, 0.2433)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_convex', 0.04071, 0.1064)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.1179, 0.2175)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.09471, 0.2338)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_unseen', 0.1795, 0.1949)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'headroom', 0.1095, 0.5234)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.39, 0.4712)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'lift', -3.548, 2.116)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6587, 0.1524)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.6481, 0.6777)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', -0.1015, 0.8778)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'standoff', 0.6978, 0.5214)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.65, 0.9972)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'wall_offset', 2.642, 2.658)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.1483, 0.886)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.397, 0.7571)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.2866, 0.5412)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'wall';
DELETE FROM class_density WHERE class = 'wall';
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.0223, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'aspect', 0.5556, 0.3082),
  ('wall', 1, 'behind', 0.0001793, 0.03006),
  ('wall', 1, 'corner_offset', 2.366, 1.113),
  ('wall', 1, 'edge_concave', 0.5123, 0.09611),
  ('wall', 1, 'edge_convex', 0.01294, 0.06312),
  ('wall', 1, 'edge_free', 0.07143, 0.05346),
  ('wall', 1, 'edge_free_top', 0.008712, 0.039),
  ('wall', 1, 'edge_unseen', 0.1932, 0.1347),
  ('wall', 1, 'headroom', -0.01595, 0.03005),
  ('wall', 1, 'height', 1.61, 0.2809),
  ('wall', 1, 'lift', -3.535, 0.5927),
  ('wall', 1, 'rectangularity', 0.5314, 0.1665),
  ('wall', 1, 'spread_length', 1.106, 0.1999),
  ('wall', 1, 'spread_width', 0.786, 0.1537),
  ('wall', 1, 'standoff', 0.6711, 0.2958),
  ('wall', 1, 'tilt_deg', 90.21, 0.45),
  ('wall', 1, 'wall_offset', 2.562, 2.869),
  ('wall', 1, 'width', 1.117, 0.07331),
  ('wall', 1, 'z_max', 2.942, 0.4875),
  ('wall', 1, 'z_min', -0.01644, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.05394, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'aspect', 0.9529, 0.4413),
  ('wall', 2, 'behind', -0.005097, 0.03),
  ('wall', 2, 'corner_offset', 0.5536, 1.367),
  ('wall', 2, 'edge_concave', 0.385, 0.1992),
  ('wall', 2, 'edge_convex', 0.005082, 0.03),
  ('wall', 2, 'edge_free', 0.003458, 0.03),
  ('wall', 2, 'edge_free_top', -0.01447, 0.03001),
  ('wall', 2, 'edge_unseen', 0.4447, 0.06904),
  ('wall', 2, 'headroom', -0.06675, 0.03002),
  ('wall', 2, 'height', 1.28, 0.2902),
  ('wall', 2, 'lift', -5.211, 0.3158),
  ('wall', 2, 'rectangularity', 0.6304, 0.09579),
  ('wall', 2, 'spread_length', 0.8423, 0.1924),
  ('wall', 2, 'spread_width', 0.1377, 0.139),
  ('wall', 2, 'standoff', 1.094, 0.2898),
  ('wall', 2, 'tilt_deg', 90.56, 0.45),
  ('wall', 2, 'wall_offset', 2.797, 3.602),
  ('wall', 2, 'width', 0.4913, 0.1703),
  ('wall', 2, 'z_max', 2.455, 0.5664),
  ('wall', 2, 'z_min', 0.1215, 0.2355);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.09081, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'aspect', 0.6461, 0.5389),
  ('wall', 3, 'behind', -0.009825, 0.03),
  ('wall', 3, 'corner_offset', 0.5136, 2.386),
  ('wall', 3, 'edge_concave', 0.2895, 0.1441),
  ('wall', 3, 'edge_convex', -0.0002674, 0.03),
  ('wall', 3, 'edge_free', -0.01751, 0.03005),
  ('wall', 3, 'edge_free_top', 0.006495, 0.04074),
  ('wall', 3, 'edge_unseen', 0.7777, 0.1789),
  ('wall', 3, 'headroom', 1.511, 0.4525),
  ('wall', 3, 'height', 1.023, 0.3518),
  ('wall', 3, 'lift', -3.511, 18.01),
  ('wall', 3, 'rectangularity', 0.6845, 0.09386),
  ('wall', 3, 'spread_length', 0.2482, 0.466),
  ('wall', 3, 'spread_width', -0.6911, 0.4873),
  ('wall', 3, 'standoff', -0.01574, 0.036),
  ('wall', 3, 'tilt_deg', 89.79, 0.6465),
  ('wall', 3, 'wall_offset', 7.181, 2.232),
  ('wall', 3, 'width', -0.3349, 0.5787),
  ('wall', 3, 'z_max', 1.535, 0.1035),
  ('wall', 3, 'z_min', 0.2051, 0.3453);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.056, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'aspect', 1.072, 0.3431),
  ('wall', 4, 'behind', 0.1783, 0.2005),
  ('wall', 4, 'corner_offset', -0.462, 1.388),
  ('wall', 4, 'edge_concave', 0.04352, 0.1024),
  ('wall', 4, 'edge_convex', 0.1555, 0.1894),
  ('wall', 4, 'edge_free', 0.5907, 0.3592),
  ('wall', 4, 'edge_free_top', 0.2321, 0.1471),
  ('wall', 4, 'edge_unseen', 0.3863, 0.2231),
  ('wall', 4, 'headroom', 1.834, 0.1962),
  ('wall', 4, 'height', 1.248, 0.177),
  ('wall', 4, 'lift', -6.552, 0.5146),
  ('wall', 4, 'rectangularity', 0.6699, 0.2434),
  ('wall', 4, 'spread_length', -0.419, 0.282),
  ('wall', 4, 'spread_width', -1.072, 0.2806),
  ('wall', 4, 'standoff', 0.9142, 0.4319),
  ('wall', 4, 'tilt_deg', 89.63, 0.45),
  ('wall', 4, 'wall_offset', 1.516, 0.5278),
  ('wall', 4, 'width', -0.3987, 0.238),
  ('wall', 4, 'z_max', 1.884, 0.4327),
  ('wall', 4, 'z_min', 0.3783, 0.2921);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.07854, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'aspect', 1.425, 0.3641),
  ('wall', 5, 'behind', 0.2165, 0.2061),
  ('wall', 5, 'corner_offset', 1.396, 0.64),
  ('wall', 5, 'edge_concave', 0.2524, 0.2302),
  ('wall', 5, 'edge_convex', 0.01339, 0.04288),
  ('wall', 5, 'edge_free', 0.4554, 0.3327),
  ('wall', 5, 'edge_free_top', 0.04088, 0.08138),
  ('wall', 5, 'edge_unseen', 0.009145, 0.03039),
  ('wall', 5, 'headroom', 0.01668, 0.04817),
  ('wall', 5, 'height', 1.487, 0.1448),
  ('wall', 5, 'lift', -4.719, 0.2598),
  ('wall', 5, 'rectangularity', 0.8466, 0.1119),
  ('wall', 5, 'spread_length', 0.6874, 0.3102),
  ('wall', 5, 'spread_width', -0.7821, 0.2591),
  ('wall', 5, 'standoff', 0.6803, 0.3236),
  ('wall', 5, 'tilt_deg', 90.1, 0.45),
  ('wall', 5, 'wall_offset', 1.338, 0.4309),
  ('wall', 5, 'width', -0.225, 0.123),
  ('wall', 5, 'z_max', 2.67, 0.1792),
  ('wall', 5, 'z_min', 0.2295, 0.3492);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.03181, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'aspect', 0.5166, 0.2926),
  ('wall', 6, 'behind', 0.1913, 0.1239),
  ('wall', 6, 'corner_offset', 1.951, 0.73),
  ('wall', 6, 'edge_concave', 0.3641, 0.08348),
  ('wall', 6, 'edge_convex', 0.09205, 0.1262),
  ('wall', 6, 'edge_free', 0.2442, 0.141),
  ('wall', 6, 'edge_free_top', 0.3117, 0.1852),
  ('wall', 6, 'edge_unseen', 0.2634, 0.07464),
  ('wall', 6, 'headroom', -0.3195, 0.1168),
  ('wall', 6, 'height', 1.319, 0.4015),
  ('wall', 6, 'lift', -4.788, 0.6079),
  ('wall', 6, 'rectangularity', 0.4071, 0.06383),
  ('wall', 6, 'spread_length', 0.7723, 0.2927),
  ('wall', 6, 'spread_width', 0.2691, 0.3347),
  ('wall', 6, 'standoff', 0.3706, 0.4076),
  ('wall', 6, 'tilt_deg', 90.06, 0.4501),
  ('wall', 6, 'wall_offset', 2.498, 2.817),
  ('wall', 6, 'width', 0.6723, 0.2874),
  ('wall', 6, 'z_max', 2.863, 0.1736),
  ('wall', 6, 'z_min', 0.1306, 0.2912);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.03787, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'aspect', 0.6178, 0.388),
  ('wall', 7, 'behind', 0.07405, 0.2295),
  ('wall', 7, 'corner_offset', 0.7954, 0.8905),
  ('wall', 7, 'edge_concave', 0.3348, 0.2329),
  ('wall', 7, 'edge_convex', 0.1535, 0.2131),
  ('wall', 7, 'edge_free', 0.06789, 0.1169),
  ('wall', 7, 'edge_free_top', 0.0004838, 0.03),
  ('wall', 7, 'edge_unseen', 0.2035, 0.2663),
  ('wall', 7, 'headroom', -0.0109, 0.03),
  ('wall', 7, 'height', 2.419, 0.2193),
  ('wall', 7, 'lift', -2.39, 13.75),
  ('wall', 7, 'rectangularity', 0.6766, 0.1042),
  ('wall', 7, 'spread_length', -0.2624, 0.7955),
  ('wall', 7, 'spread_width', -0.6035, 0.429),
  ('wall', 7, 'standoff', 0.172, 0.1504),
  ('wall', 7, 'tilt_deg', 89.77, 0.451),
  ('wall', 7, 'wall_offset', 2.14, 2.219),
  ('wall', 7, 'width', -0.7593, 0.8097),
  ('wall', 7, 'z_max', 3.012, 0.2542),
  ('wall', 7, 'z_min', 1.557, 0.5068);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.05489, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'aspect', 0.1793, 0.1105),
  ('wall', 8, 'behind', 0.2676, 0.1529),
  ('wall', 8, 'corner_offset', 1.943, 0.7543),
  ('wall', 8, 'edge_concave', 0.1617, 0.1541),
  ('wall', 8, 'edge_convex', 0.01664, 0.04895),
  ('wall', 8, 'edge_free', 0.5736, 0.1547),
  ('wall', 8, 'edge_free_top', 0.9612, 0.07724),
  ('wall', 8, 'edge_unseen', 0.1429, 0.1012),
  ('wall', 8, 'headroom', 1.738, 0.558),
  ('wall', 8, 'height', 1.004, 0.3577),
  ('wall', 8, 'lift', -4.528, 0.6027),
  ('wall', 8, 'rectangularity', 0.7359, 0.09721),
  ('wall', 8, 'spread_length', 0.4341, 0.1044),
  ('wall', 8, 'spread_width', 0.02475, 0.3232),
  ('wall', 8, 'standoff', 0.9367, 0.2152),
  ('wall', 8, 'tilt_deg', 89.7, 1.615),
  ('wall', 8, 'wall_offset', 1.789, 0.3866),
  ('wall', 8, 'width', 0.518, 0.09947),
  ('wall', 8, 'z_max', 1.514, 0.4563),
  ('wall', 8, 'z_min', -0.07992, 0.1032);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.04242, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'aspect', 1.261, 0.6549),
  ('wall', 9, 'behind', -0.01068, 0.03),
  ('wall', 9, 'corner_offset', -0.4914, 1.116),
  ('wall', 9, 'edge_concave', 0.2966, 0.2752),
  ('wall', 9, 'edge_convex', -0.0006386, 0.03),
  ('wall', 9, 'edge_free', 0.02501, 0.09034),
  ('wall', 9, 'edge_free_top', 0.005956, 0.0348),
  ('wall', 9, 'edge_unseen', 0.1106, 0.2767),
  ('wall', 9, 'headroom', 1.476, 12.92),
  ('wall', 9, 'height', 0.2592, 0.1002),
  ('wall', 9, 'lift', -4.22, 0.5817),
  ('wall', 9, 'rectangularity', 0.8203, 0.1114),
  ('wall', 9, 'spread_length', -0.2147, 0.7854),
  ('wall', 9, 'spread_width', -1.243, 0.3385),
  ('wall', 9, 'standoff', 0.6161, 0.5667),
  ('wall', 9, 'tilt_deg', 89.43, 0.6211),
  ('wall', 9, 'wall_offset', -0.924, 0.9292),
  ('wall', 9, 'width', -1.249, 0.4854),
  ('wall', 9, 'z_max', 0.6147, 0.369),
  ('wall', 9, 'z_min', -0.0297, 0.02273);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.006432, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'aspect', 0.5084, 0.2535),
  ('wall', 10, 'behind', 0.1696, 0.1152),
  ('wall', 10, 'corner_offset', 2.175, 0.4143),
  ('wall', 10, 'edge_concave', 0.7358, 0.1701),
  ('wall', 10, 'edge_convex', 0.01025, 0.03935),
  ('wall', 10, 'edge_free', 0.0182, 0.04559),
  ('wall', 10, 'edge_free_top', 0.002667, 0.03075),
  ('wall', 10, 'edge_unseen', 0.03836, 0.06651),
  ('wall', 10, 'headroom', -0.3604, 0.5064),
  ('wall', 10, 'height', 1.429, 0.3095),
  ('wall', 10, 'lift', -3.536, 0.6333),
  ('wall', 10, 'rectangularity', 0.5703, 0.16),
  ('wall', 10, 'spread_length', 1.393, 0.1928),
  ('wall', 10, 'spread_width', 0.8307, 0.1952),
  ('wall', 10, 'standoff', 0.6995, 0.1643),
  ('wall', 10, 'tilt_deg', 90.02, 0.4535),
  ('wall', 10, 'wall_offset', 4.816, 3.813),
  ('wall', 10, 'width', 0.9949, 0.08887),
  ('wall', 10, 'z_max', 2.665, 0.3497),
  ('wall', 10, 'z_min', -0.01142, 0.02252);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 11, 0.03092, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 11, 'aspect', 0.4106, 0.2174),
  ('wall', 11, 'behind', 0.004235, 0.03006),
  ('wall', 11, 'corner_offset', 2.287, 0.6956),
  ('wall', 11, 'edge_concave', 0.5279, 0.1566),
  ('wall', 11, 'edge_convex', 0.001354, 0.03),
  ('wall', 11, 'edge_free', 0.0102, 0.0308),
  ('wall', 11, 'edge_free_top', 0.001424, 0.03),
  ('wall', 11, 'edge_unseen', 0.03748, 0.05468),
  ('wall', 11, 'headroom', -0.01283, 0.03),
  ('wall', 11, 'height', 1.606, 0.1948),
  ('wall', 11, 'lift', -3.503, 0.6292),
  ('wall', 11, 'rectangularity', 0.6636, 0.08085),
  ('wall', 11, 'spread_length', 1.331, 0.1497),
  ('wall', 11, 'spread_width', 0.7889, 0.07782),
  ('wall', 11, 'standoff', 0.3442, 0.233),
  ('wall', 11, 'tilt_deg', 90.22, 0.45),
  ('wall', 11, 'wall_offset', 2.731, 3.635),
  ('wall', 11, 'width', 1.105, 0.08445),
  ('wall', 11, 'z_max', 2.877, 0.2683),
  ('wall', 11, 'z_min', -0.001212, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 12, 0.09883, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 12, 'aspect', 0.5764, 0.4222),
  ('wall', 12, 'behind', 0.2485, 0.2326),
  ('wall', 12, 'corner_offset', 1.933, 0.4439),
  ('wall', 12, 'edge_concave', 0.1595, 0.1153),
  ('wall', 12, 'edge_convex', 0.2448, 0.2872),
  ('wall', 12, 'edge_free', 0.5122, 0.2132),
  ('wall', 12, 'edge_free_top', 0.4561, 0.5049),
  ('wall', 12, 'edge_unseen', 0.2813, 0.2175),
  ('wall', 12, 'headroom', 2.017, 0.0622),
  ('wall', 12, 'height', 1.085, 0.2087),
  ('wall', 12, 'lift', -5.936, 0.172),
  ('wall', 12, 'rectangularity', 0.654, 0.2382),
  ('wall', 12, 'spread_length', 0.08923, 0.466),
  ('wall', 12, 'spread_width', -0.4304, 0.6416),
  ('wall', 12, 'standoff', 0.919, 0.3481),
  ('wall', 12, 'tilt_deg', 89.57, 0.45),
  ('wall', 12, 'wall_offset', 1.801, 0.4099),
  ('wall', 12, 'width', -0.03255, 0.7819),
  ('wall', 12, 'z_max', 1.545, 0.1617),
  ('wall', 12, 'z_min', 0.1326, 0.3813);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 13, 0.04815, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 13, 'aspect', 0.5188, 0.3923),
  ('wall', 13, 'behind', 0.0005174, 0.03),
  ('wall', 13, 'corner_offset', 1.339, 1.802),
  ('wall', 13, 'edge_concave', 0.397, 0.1886),
  ('wall', 13, 'edge_convex', 0.0007586, 0.03),
  ('wall', 13, 'edge_free', 0.02203, 0.04849),
  ('wall', 13, 'edge_free_top', -0.0007799, 0.03),
  ('wall', 13, 'edge_unseen', 0.4487, 0.2568),
  ('wall', 13, 'headroom', -0.03753, 0.03),
  ('wall', 13, 'height', 1.574, 0.3077),
  ('wall', 13, 'lift', -5.203, 0.7853),
  ('wall', 13, 'rectangularity', 0.5813, 0.127),
  ('wall', 13, 'spread_length', 0.5883, 0.3099),
  ('wall', 13, 'spread_width', 0.122, 0.1721),
  ('wall', 13, 'standoff', 1.065, 0.1559),
  ('wall', 13, 'tilt_deg', 90.36, 0.45),
  ('wall', 13, 'wall_offset', 3.224, 1.011),
  ('wall', 13, 'width', 0.4156, 0.1723),
  ('wall', 13, 'z_max', 2.889, 0.2115),
  ('wall', 13, 'z_min', 0.3378, 0.2185);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 14, 0.01766, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 14, 'aspect', 0.3742, 0.2942),
  ('wall', 14, 'behind', 0.2079, 0.07159),
  ('wall', 14, 'corner_offset', 1.771, 0.8874),
  ('wall', 14, 'edge_concave', 0.5521, 0.2064),
  ('wall', 14, 'edge_convex', 0.03306, 0.06548),
  ('wall', 14, 'edge_free', 0.1744, 0.1311),
  ('wall', 14, 'edge_free_top', 0.06356, 0.1249),
  ('wall', 14, 'edge_unseen', 0.1477, 0.1592),
  ('wall', 14, 'headroom', -0.3211, 0.1927),
  ('wall', 14, 'height', 1.496, 0.1652),
  ('wall', 14, 'lift', -3.506, 0.6656),
  ('wall', 14, 'rectangularity', 0.5311, 0.1412),
  ('wall', 14, 'spread_length', 1.167, 0.3469),
  ('wall', 14, 'spread_width', 0.7154, 0.3145),
  ('wall', 14, 'standoff', 0.3523, 0.2192),
  ('wall', 14, 'tilt_deg', 90.11, 0.45),
  ('wall', 14, 'wall_offset', 4.208, 1.769),
  ('wall', 14, 'width', 1.003, 0.1061),
  ('wall', 14, 'z_max', 2.704, 0.1107),
  ('wall', 14, 'z_min', -0.01425, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 15, 0.1251, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 15, 'aspect', 0.5357, 0.3817),
  ('wall', 15, 'behind', 0.00209, 0.03),
  ('wall', 15, 'corner_offset', -0.3504, 4.234),
  ('wall', 15, 'edge_concave', 0.1482, 0.1169),
  ('wall', 15, 'edge_convex', 0.0004954, 0.03),
  ('wall', 15, 'edge_free', -0.02509, 0.03),
  ('wall', 15, 'edge_free_top', -0.01179, 0.05732),
  ('wall', 15, 'edge_unseen', 0.6606, 0.1715),
  ('wall', 15, 'headroom', 1.749, 0.0969),
  ('wall', 15, 'height', 1.307, 0.171),
  ('wall', 15, 'lift', -3.463, 11.45),
  ('wall', 15, 'rectangularity', 0.6177, 0.1345),
  ('wall', 15, 'spread_length', -0.1757, 0.6816),
  ('wall', 15, 'spread_width', -0.5681, 0.542),
  ('wall', 15, 'standoff', 0.009371, 0.03719),
  ('wall', 15, 'tilt_deg', 87.48, 0.4516),
  ('wall', 15, 'wall_offset', 2.078, 0.7367),
  ('wall', 15, 'width', -0.2078, 0.641),
  ('wall', 15, 'z_max', 1.839, 0.4416),
  ('wall', 15, 'z_min', 0.3805, 0.2404);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 16, 0.05298, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 16, 'aspect', 1.368, 0.2883),
  ('wall', 16, 'behind', 0.1684, 0.2383),
  ('wall', 16, 'corner_offset', 1.204, 0.7231),
  ('wall', 16, 'edge_concave', 0.4121, 0.3049),
  ('wall', 16, 'edge_convex', 0.1938, 0.2035),
  ('wall', 16, 'edge_free', 0.5914, 0.2584),
  ('wall', 16, 'edge_free_top', 0.1581, 0.1927),
  ('wall', 16, 'edge_unseen', 0.08849, 0.1032),
  ('wall', 16, 'headroom', 0.02749, 0.03124),
  ('wall', 16, 'height', 1.445, 0.1088),
  ('wall', 16, 'lift', -3.767, 0.3113),
  ('wall', 16, 'rectangularity', 0.7738, 0.1209),
  ('wall', 16, 'spread_length', 0.4984, 0.4715),
  ('wall', 16, 'spread_width', -0.8481, 0.1962),
  ('wall', 16, 'standoff', 0.7949, 0.4235),
  ('wall', 16, 'tilt_deg', 90.1, 0.45),
  ('wall', 16, 'wall_offset', 1.511, 0.6772),
  ('wall', 16, 'width', -0.4337, 0.4787),
  ('wall', 16, 'z_max', 2.619, 0.2371),
  ('wall', 16, 'z_min', -0.001833, 0.1078);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 17, 0.02769, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 17, 'aspect', 1.019, 0.3635),
  ('wall', 17, 'behind', 0.08468, 0.1984),
  ('wall', 17, 'corner_offset', 0.7962, 1.342),
  ('wall', 17, 'edge_concave', 0.3787, 0.222),
  ('wall', 17, 'edge_convex', 0.05569, 0.1128),
  ('wall', 17, 'edge_free', 0.07402, 0.1215),
  ('wall', 17, 'edge_free_top', 0.005925, 0.03),
  ('wall', 17, 'edge_unseen', 0.2106, 0.2449),
  ('wall', 17, 'headroom', -0.01843, 0.03),
  ('wall', 17, 'height', 2.304, 0.1921),
  ('wall', 17, 'lift', -1.677, 0.7483),
  ('wall', 17, 'rectangularity', 0.7326, 0.07556),
  ('wall', 17, 'spread_length', 0.04805, 0.4999),
  ('wall', 17, 'spread_width', -0.6817, 0.6593),
  ('wall', 17, 'standoff', 0.3912, 0.3954),
  ('wall', 17, 'tilt_deg', 89.75, 0.458),
  ('wall', 17, 'wall_offset', 1.258, 1.866),
  ('wall', 17, 'width', -0.5803, 0.7372),
  ('wall', 17, 'z_max', 2.749, 0.1545),
  ('wall', 17, 'z_min', 1.597, 0.5951);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 18, 0.03574, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 18, 'aspect', 1.071, 0.3893),
  ('wall', 18, 'behind', -0.01207, 0.03),
  ('wall', 18, 'corner_offset', -0.05351, 0.253),
  ('wall', 18, 'edge_concave', 0.3425, 0.1246),
  ('wall', 18, 'edge_convex', 0.006633, 0.03052),
  ('wall', 18, 'edge_free', -0.01166, 0.03),
  ('wall', 18, 'edge_free_top', -0.006858, 0.03),
  ('wall', 18, 'edge_unseen', 0.2578, 0.2605),
  ('wall', 18, 'headroom', 1.124, 0.2097),
  ('wall', 18, 'height', 1.116, 0.2176),
  ('wall', 18, 'lift', -4.444, 0.264),
  ('wall', 18, 'rectangularity', 0.7092, 0.1302),
  ('wall', 18, 'spread_length', 0.1292, 0.6291),
  ('wall', 18, 'spread_width', -0.8173, 0.635),
  ('wall', 18, 'standoff', 0.709, 0.4676),
  ('wall', 18, 'tilt_deg', 90.06, 0.451),
  ('wall', 18, 'wall_offset', 1.696, 4.873),
  ('wall', 18, 'width', -0.7831, 0.8717),
  ('wall', 18, 'z_max', 2.374, 0.7364),
  ('wall', 18, 'z_min', 0.245, 0.2671);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 19, 0.02313, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 19, 'aspect', 0.5965, 0.488),
  ('wall', 19, 'behind', 0.003821, 0.03),
  ('wall', 19, 'corner_offset', 1.603, 0.5974),
  ('wall', 19, 'edge_concave', 0.4026, 0.1548),
  ('wall', 19, 'edge_convex', 0.001007, 0.04079),
  ('wall', 19, 'edge_free', -0.01367, 0.03249),
  ('wall', 19, 'edge_free_top', -0.0002658, 0.03),
  ('wall', 19, 'edge_unseen', 0.0632, 0.1422),
  ('wall', 19, 'headroom', 0.8987, 0.276),
  ('wall', 19, 'height', 0.3408, 0.1866),
  ('wall', 19, 'lift', -3.548, 0.4713),
  ('wall', 19, 'rectangularity', 0.7719, 0.159),
  ('wall', 19, 'spread_length', -0.4585, 0.6271),
  ('wall', 19, 'spread_width', -1.045, 0.47),
  ('wall', 19, 'standoff', 0.08626, 0.2816),
  ('wall', 19, 'tilt_deg', 88.88, 0.935),
  ('wall', 19, 'wall_offset', -1.004, 0.5505),
  ('wall', 19, 'width', -0.97, 0.6548),
  ('wall', 19, 'z_max', 0.6971, 0.3061),
  ('wall', 19, 'z_min', -0.01921, 0.02258);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 20, 0.01477, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 20, 'aspect', 0.5417, 0.316),
  ('wall', 20, 'behind', 0.1973, 0.1529),
  ('wall', 20, 'corner_offset', 2.767, 1.796),
  ('wall', 20, 'edge_concave', 0.261, 0.2954),
  ('wall', 20, 'edge_convex', -0.000314, 0.03001),
  ('wall', 20, 'edge_free', 0.08112, 0.08586),
  ('wall', 20, 'edge_free_top', 0.004117, 0.03003),
  ('wall', 20, 'edge_unseen', 0.05505, 0.07947),
  ('wall', 20, 'headroom', 2.273, 0.3903),
  ('wall', 20, 'height', 0.4493, 0.1245),
  ('wall', 20, 'lift', -2.268, 0.5134),
  ('wall', 20, 'rectangularity', 0.6641, 0.09724),
  ('wall', 20, 'spread_length', 0.2168, 0.3472),
  ('wall', 20, 'spread_width', -1.139, 0.9313),
  ('wall', 20, 'standoff', 0.9206, 0.5396),
  ('wall', 20, 'tilt_deg', 87.3, 8.728),
  ('wall', 20, 'wall_offset', 1.16, 0.2005),
  ('wall', 20, 'width', -0.8789, 1.119),
  ('wall', 20, 'z_max', 0.9295, 0.3921),
  ('wall', 20, 'z_min', 0.06132, 0.1912);

-- table: 1545 examples
UPDATE object_class SET prior = 0.0466 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5597, 0.2751)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5343, 0.2066)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'corner_offset', 0.7621, 0.5075)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_concave', 0.2118, 0.1617)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_convex', 0.05459, 0.08623)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.4316, 0.2217)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_unseen', 0.1091, 0.1468)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'headroom', 1.987, 0.3569)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7303, 0.1185)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.7044, 0.1287)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1845, 0.3214)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4241, 0.3413)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.3867, 0.5516)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2377, 0.324)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7341, 0.1178)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7269, 0.1189)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'table';
DELETE FROM class_density WHERE class = 'table';
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.02633, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'aspect', 0.4881, 0.175),
  ('table', 1, 'behind', 0.6064, 0.06139),
  ('table', 1, 'corner_offset', 0.6054, 0.2391),
  ('table', 1, 'edge_concave', 0.2961, 0.1372),
  ('table', 1, 'edge_convex', 0.04643, 0.07875),
  ('table', 1, 'edge_free', 0.4453, 0.2267),
  ('table', 1, 'edge_free_top', -0.001738, 0.3138),
  ('table', 1, 'edge_unseen', 0.1125, 0.0989),
  ('table', 1, 'headroom', 1.883, 0.1223),
  ('table', 1, 'height', 0.698, 0.02377),
  ('table', 1, 'lift', -0.002363, 0.3107),
  ('table', 1, 'rectangularity', 0.6909, 0.09208),
  ('table', 1, 'spread_length', 0.3442, 0.1859),
  ('table', 1, 'spread_width', -0.342, 0.07837),
  ('table', 1, 'standoff', -0.0003417, 0.3161),
  ('table', 1, 'tilt_deg', 0.1686, 0.4502),
  ('table', 1, 'wall_offset', -0.003094, 0.3182),
  ('table', 1, 'width', -0.1043, 0.1557),
  ('table', 1, 'z_max', 0.6979, 0.02253),
  ('table', 1, 'z_min', 0.6952, 0.02627);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.04679, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'aspect', 0.459, 0.2236),
  ('table', 2, 'behind', 0.7141, 0.06947),
  ('table', 2, 'corner_offset', 0.5668, 0.06605),
  ('table', 2, 'edge_concave', 0.3209, 0.08003),
  ('table', 2, 'edge_convex', 0.05116, 0.07739),
  ('table', 2, 'edge_free', 0.3078, 0.2212),
  ('table', 2, 'edge_free_top', -0.002266, 0.3122),
  ('table', 2, 'edge_unseen', 0.01044, 0.03621),
  ('table', 2, 'headroom', 1.975, 0.4269),
  ('table', 2, 'height', 0.7498, 0.0225),
  ('table', 2, 'lift', 0.004541, 0.2987),
  ('table', 2, 'rectangularity', 0.6972, 0.05235),
  ('table', 2, 'spread_length', 0.1086, 0.2315),
  ('table', 2, 'spread_width', -0.3188, 0.07515),
  ('table', 2, 'standoff', -0.0004101, 0.3163),
  ('table', 2, 'tilt_deg', 0.05189, 0.45),
  ('table', 2, 'wall_offset', -0.004798, 0.3162),
  ('table', 2, 'width', -0.1327, 0.09791),
  ('table', 2, 'z_max', 0.7499, 0.0225),
  ('table', 2, 'z_min', 0.7496, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.06252, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'aspect', 0.5471, 0.3871),
  ('table', 3, 'behind', 0.3149, 0.1216),
  ('table', 3, 'corner_offset', 0.9758, 0.4045),
  ('table', 3, 'edge_concave', 0.2283, 0.09879),
  ('table', 3, 'edge_convex', 0.005683, 0.03),
  ('table', 3, 'edge_free', 0.4917, 0.3157),
  ('table', 3, 'edge_free_top', -0.01136, 0.3018),
  ('table', 3, 'edge_unseen', 0.2512, 0.1682),
  ('table', 3, 'headroom', 1.829, 0.1114),
  ('table', 3, 'height', 0.761, 0.0225),
  ('table', 3, 'lift', -0.0004332, 0.2816),
  ('table', 3, 'rectangularity', 0.7236, 0.1239),
  ('table', 3, 'spread_length', 0.1179, 0.2465),
  ('table', 3, 'spread_width', -0.4492, 0.3236),
  ('table', 3, 'standoff', -0.002026, 0.3196),
  ('table', 3, 'tilt_deg', 0.1173, 0.45),
  ('table', 3, 'wall_offset', -0.01555, 0.3455),
  ('table', 3, 'width', -0.2633, 0.2278),
  ('table', 3, 'z_max', 0.7665, 0.0225),
  ('table', 3, 'z_min', 0.7534, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.04239, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'aspect', 0.6481, 0.1338),
  ('table', 4, 'behind', 0.4748, 0.2036),
  ('table', 4, 'corner_offset', 0.9788, 0.8571),
  ('table', 4, 'edge_concave', 0.08642, 0.06145),
  ('table', 4, 'edge_convex', 0.05902, 0.07405),
  ('table', 4, 'edge_free', 0.6755, 0.2117),
  ('table', 4, 'edge_free_top', -0.002099, 0.3113),
  ('table', 4, 'edge_unseen', 0.002781, 0.03),
  ('table', 4, 'headroom', 1.961, 0.3171),
  ('table', 4, 'height', 0.7162, 0.02762),
  ('table', 4, 'lift', 0.0005279, 0.3105),
  ('table', 4, 'rectangularity', 0.7805, 0.1362),
  ('table', 4, 'spread_length', 0.3655, 0.1564),
  ('table', 4, 'spread_width', -0.3399, 0.08558),
  ('table', 4, 'standoff', -0.0008524, 0.3177),
  ('table', 4, 'tilt_deg', 0.1916, 0.4523),
  ('table', 4, 'wall_offset', -0.008411, 0.3264),
  ('table', 4, 'width', -0.2217, 0.07549),
  ('table', 4, 'z_max', 0.7208, 0.03037),
  ('table', 4, 'z_min', 0.7109, 0.02921);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.06999, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'aspect', 0.4831, 0.1798),
  ('table', 5, 'behind', 0.4211, 0.1353),
  ('table', 5, 'corner_offset', 1.346, 0.3976),
  ('table', 5, 'edge_concave', 0.1615, 0.1441),
  ('table', 5, 'edge_convex', 0.09972, 0.07343),
  ('table', 5, 'edge_free', 0.4271, 0.1504),
  ('table', 5, 'edge_free_top', -0.007614, 0.3045),
  ('table', 5, 'edge_unseen', 0.09718, 0.1019),
  ('table', 5, 'headroom', 1.927, 0.5627),
  ('table', 5, 'height', 0.8245, 0.0225),
  ('table', 5, 'lift', 0.01432, 0.2633),
  ('table', 5, 'rectangularity', 0.7317, 0.1171),
  ('table', 5, 'spread_length', 0.08037, 0.3101),
  ('table', 5, 'spread_width', -0.3622, 0.2149),
  ('table', 5, 'standoff', -0.002747, 0.3188),
  ('table', 5, 'tilt_deg', 0.6116, 0.8155),
  ('table', 5, 'wall_offset', -0.03075, 0.3338),
  ('table', 5, 'width', -0.189, 0.1965),
  ('table', 5, 'z_max', 0.8367, 0.0225),
  ('table', 5, 'z_min', 0.8149, 0.02565);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.04229, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'aspect', 0.3885, 0.1914),
  ('table', 6, 'behind', 0.2636, 0.1297),
  ('table', 6, 'corner_offset', 1.075, 0.7008),
  ('table', 6, 'edge_concave', 0.1338, 0.161),
  ('table', 6, 'edge_convex', 0.08174, 0.1307),
  ('table', 6, 'edge_free', 0.5378, 0.2945),
  ('table', 6, 'edge_free_top', -0.007829, 0.3039),
  ('table', 6, 'edge_unseen', 0.2072, 0.2004),
  ('table', 6, 'headroom', 2.164, 0.3437),
  ('table', 6, 'height', 0.6897, 0.0225),
  ('table', 6, 'lift', 0.002339, 0.307),
  ('table', 6, 'rectangularity', 0.6664, 0.1163),
  ('table', 6, 'spread_length', -0.2716, 0.1336),
  ('table', 6, 'spread_width', -0.7116, 0.1837),
  ('table', 6, 'standoff', -0.002869, 0.3178),
  ('table', 6, 'tilt_deg', 0.3343, 0.4502),
  ('table', 6, 'wall_offset', -0.01876, 0.3314),
  ('table', 6, 'width', -0.4847, 0.1496),
  ('table', 6, 'z_max', 0.692, 0.02251),
  ('table', 6, 'z_min', 0.687, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.06589, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'aspect', 0.4361, 0.3211),
  ('table', 7, 'behind', 0.4054, 0.1807),
  ('table', 7, 'corner_offset', 1.054, 0.3929),
  ('table', 7, 'edge_concave', 0.151, 0.1442),
  ('table', 7, 'edge_convex', 0.03809, 0.06905),
  ('table', 7, 'edge_free', 0.502, 0.1745),
  ('table', 7, 'edge_free_top', -0.01176, 0.2925),
  ('table', 7, 'edge_unseen', 0.07657, 0.1101),
  ('table', 7, 'headroom', 2.379, 0.4929),
  ('table', 7, 'height', 0.6403, 0.02994),
  ('table', 7, 'lift', -0.003366, 0.2909),
  ('table', 7, 'rectangularity', 0.725, 0.1458),
  ('table', 7, 'spread_length', 0.1682, 0.2688),
  ('table', 7, 'spread_width', -0.3665, 0.1563),
  ('table', 7, 'standoff', -0.004621, 0.3155),
  ('table', 7, 'tilt_deg', 0.6451, 0.5718),
  ('table', 7, 'wall_offset', -0.01162, 0.363),
  ('table', 7, 'width', -0.2245, 0.1463),
  ('table', 7, 'z_max', 0.6496, 0.02844),
  ('table', 7, 'z_min', 0.6309, 0.03546);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.04034, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'aspect', 0.8535, 0.1479),
  ('table', 8, 'behind', 0.3161, 0.2924),
  ('table', 8, 'corner_offset', 1.285, 0.3223),
  ('table', 8, 'edge_concave', 0.07917, 0.1263),
  ('table', 8, 'edge_convex', 0.01371, 0.03867),
  ('table', 8, 'edge_free', 0.528, 0.2409),
  ('table', 8, 'edge_free_top', -0.02072, 0.2859),
  ('table', 8, 'edge_unseen', 0.4102, 0.09388),
  ('table', 8, 'headroom', 1.891, 0.1078),
  ('table', 8, 'height', 0.7249, 0.06601),
  ('table', 8, 'lift', 0.01733, 0.2415),
  ('table', 8, 'rectangularity', 0.6147, 0.06262),
  ('table', 8, 'spread_length', -0.3132, 0.4538),
  ('table', 8, 'spread_width', -1.321, 0.2657),
  ('table', 8, 'standoff', -0.02094, 0.3445),
  ('table', 8, 'tilt_deg', 1.074, 1.145),
  ('table', 8, 'wall_offset', -0.1025, 0.3615),
  ('table', 8, 'width', -1.182, 0.3943),
  ('table', 8, 'z_max', 0.7123, 0.0651),
  ('table', 8, 'z_min', 0.7226, 0.06212);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.05886, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'aspect', 0.5872, 0.214),
  ('table', 9, 'behind', 0.2901, 0.1318),
  ('table', 9, 'corner_offset', 0.4734, 0.9694),
  ('table', 9, 'edge_concave', 0.195, 0.1915),
  ('table', 9, 'edge_convex', 0.04327, 0.08426),
  ('table', 9, 'edge_free', 0.2718, 0.2225),
  ('table', 9, 'edge_free_top', -0.0146, 0.3044),
  ('table', 9, 'edge_unseen', 0.1507, 0.1207),
  ('table', 9, 'headroom', 2.234, 0.2035),
  ('table', 9, 'height', 1.042, 0.08149),
  ('table', 9, 'lift', 0.03339, 0.2463),
  ('table', 9, 'rectangularity', 0.607, 0.1549),
  ('table', 9, 'spread_length', 0.3491, 0.2346),
  ('table', 9, 'spread_width', -0.3483, 0.2102),
  ('table', 9, 'standoff', -0.006888, 0.3177),
  ('table', 9, 'tilt_deg', -0.05228, 0.45),
  ('table', 9, 'wall_offset', -0.046, 0.3365),
  ('table', 9, 'width', -0.1785, 0.2655),
  ('table', 9, 'z_max', 1.04, 0.07746),
  ('table', 9, 'z_min', 1.038, 0.09152);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.01959, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'aspect', 0.5014, 0.1518),
  ('table', 10, 'behind', 0.1828, 0.06454),
  ('table', 10, 'corner_offset', 0.6674, 0.09366),
  ('table', 10, 'edge_concave', 0.1481, 0.1245),
  ('table', 10, 'edge_convex', 0.01423, 0.03),
  ('table', 10, 'edge_free', 0.2989, 0.129),
  ('table', 10, 'edge_free_top', -0.003528, 0.3113),
  ('table', 10, 'edge_unseen', 0.2042, 0.1018),
  ('table', 10, 'headroom', 1.986, 0.1068),
  ('table', 10, 'height', 0.01993, 0.02888),
  ('table', 10, 'lift', -0.001696, 0.3133),
  ('table', 10, 'rectangularity', 0.6123, 0.07662),
  ('table', 10, 'spread_length', -0.108, 0.3537),
  ('table', 10, 'spread_width', -0.6017, 0.2641),
  ('table', 10, 'standoff', -0.0004245, 0.3165),
  ('table', 10, 'tilt_deg', 1.312, 0.5221),
  ('table', 10, 'wall_offset', -0.005102, 0.3147),
  ('table', 10, 'width', -0.2683, 0.2038),
  ('table', 10, 'z_max', 0.01765, 0.02252),
  ('table', 10, 'z_min', 0.01119, 0.02473);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 11, 0.07481, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 11, 'aspect', 0.4731, 0.2876),
  ('table', 11, 'behind', 0.4729, 0.1106),
  ('table', 11, 'corner_offset', 1.549, 0.2068),
  ('table', 11, 'edge_concave', 0.1881, 0.1077),
  ('table', 11, 'edge_convex', 0.05495, 0.05898),
  ('table', 11, 'edge_free', 0.4749, 0.1799),
  ('table', 11, 'edge_free_top', -0.006161, 0.3064),
  ('table', 11, 'edge_unseen', 0.1034, 0.106),
  ('table', 11, 'headroom', 1.932, 0.269),
  ('table', 11, 'height', 0.7777, 0.0377),
  ('table', 11, 'lift', -1.406, 0.03107),
  ('table', 11, 'rectangularity', 0.7968, 0.09568),
  ('table', 11, 'spread_length', 0.2621, 0.3261),
  ('table', 11, 'spread_width', -0.3062, 0.135),
  ('table', 11, 'standoff', -0.002377, 0.3175),
  ('table', 11, 'tilt_deg', 0.2398, 0.45),
  ('table', 11, 'wall_offset', -0.05063, 0.3182),
  ('table', 11, 'width', -0.134, 0.1273),
  ('table', 11, 'z_max', 0.7825, 0.04091),
  ('table', 11, 'z_min', 0.7741, 0.03743);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 12, 0.03571, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 12, 'aspect', 0.4306, 0.2787),
  ('table', 12, 'behind', 0.663, 0.1037),
  ('table', 12, 'corner_offset', 0.6075, 0.08132),
  ('table', 12, 'edge_concave', 0.2601, 0.1633),
  ('table', 12, 'edge_convex', 0.0213, 0.04209),
  ('table', 12, 'edge_free', 0.3921, 0.1889),
  ('table', 12, 'edge_free_top', -0.00118, 0.3139),
  ('table', 12, 'edge_unseen', 0.01155, 0.03472),
  ('table', 12, 'headroom', 2.049, 0.4033),
  ('table', 12, 'height', 0.7614, 0.03663),
  ('table', 12, 'lift', -1.406, 0.03107),
  ('table', 12, 'rectangularity', 0.7676, 0.1062),
  ('table', 12, 'spread_length', 0.2153, 0.1258),
  ('table', 12, 'spread_width', -0.3221, 0.1228),
  ('table', 12, 'standoff', -0.001437, 0.3163),
  ('table', 12, 'tilt_deg', 0.1259, 0.4501),
  ('table', 12, 'wall_offset', -0.007927, 0.3097),
  ('table', 12, 'width', -0.1722, 0.07336),
  ('table', 12, 'z_max', 0.7619, 0.03719),
  ('table', 12, 'z_min', 0.7616, 0.03496);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 13, 0.03382, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 13, 'aspect', 0.4047, 0.2198),
  ('table', 13, 'behind', 0.3442, 0.199),
  ('table', 13, 'corner_offset', 0.9481, 0.5452),
  ('table', 13, 'edge_concave', 0.2706, 0.1242),
  ('table', 13, 'edge_convex', 0.009711, 0.03),
  ('table', 13, 'edge_free', 0.466, 0.2253),
  ('table', 13, 'edge_free_top', -0.003597, 0.3088),
  ('table', 13, 'edge_unseen', 0.1995, 0.1615),
  ('table', 13, 'headroom', 1.973, 0.3581),
  ('table', 13, 'height', 0.7017, 0.0225),
  ('table', 13, 'lift', -1.405, 0.03107),
  ('table', 13, 'rectangularity', 0.6973, 0.144),
  ('table', 13, 'spread_length', 0.2074, 0.2493),
  ('table', 13, 'spread_width', -0.342, 0.1571),
  ('table', 13, 'standoff', -0.0007723, 0.3182),
  ('table', 13, 'tilt_deg', 0.3376, 0.452),
  ('table', 13, 'wall_offset', -0.023, 0.3198),
  ('table', 13, 'width', -0.08986, 0.08449),
  ('table', 13, 'z_max', 0.707, 0.02313),
  ('table', 13, 'z_min', 0.6961, 0.02258);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 14, 0.02474, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 14, 'aspect', 0.4042, 0.1998),
  ('table', 14, 'behind', 0.7263, 0.06698),
  ('table', 14, 'corner_offset', 0.6021, 0.1174),
  ('table', 14, 'edge_concave', 0.2711, 0.123),
  ('table', 14, 'edge_convex', 0.0885, 0.09334),
  ('table', 14, 'edge_free', 0.3806, 0.1178),
  ('table', 14, 'edge_free_top', -0.0004573, 0.3156),
  ('table', 14, 'edge_unseen', 0.004123, 0.03),
  ('table', 14, 'headroom', 2.031, 0.2551),
  ('table', 14, 'height', 0.7152, 0.02252),
  ('table', 14, 'lift', -1.406, 0.03107),
  ('table', 14, 'rectangularity', 0.7166, 0.1266),
  ('table', 14, 'spread_length', 0.23, 0.2309),
  ('table', 14, 'spread_width', -0.2408, 0.06876),
  ('table', 14, 'standoff', -0.0005511, 0.316),
  ('table', 14, 'tilt_deg', 0.1719, 0.4501),
  ('table', 14, 'wall_offset', -0.002202, 0.3126),
  ('table', 14, 'width', -0.07968, 0.09563),
  ('table', 14, 'z_max', 0.7177, 0.02271),
  ('table', 14, 'z_min', 0.7147, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 15, 0.08246, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 15, 'aspect', 0.6816, 0.3613),
  ('table', 15, 'behind', 0.1292, 0.1153),
  ('table', 15, 'corner_offset', 1.347, 0.4161),
  ('table', 15, 'edge_concave', 0.1092, 0.1024),
  ('table', 15, 'edge_convex', 0.004632, 0.03),
  ('table', 15, 'edge_free', 0.4376, 0.3918),
  ('table', 15, 'edge_free_top', -0.01583, 0.2912),
  ('table', 15, 'edge_unseen', 0.3476, 0.1201),
  ('table', 15, 'headroom', 2.575, 0.399),
  ('table', 15, 'height', 0.7488, 0.05),
  ('table', 15, 'lift', -1.407, 0.03107),
  ('table', 15, 'rectangularity', 0.6733, 0.1393),
  ('table', 15, 'spread_length', -0.1613, 0.2352),
  ('table', 15, 'spread_width', -0.9075, 0.3131),
  ('table', 15, 'standoff', -0.01305, 0.3285),
  ('table', 15, 'tilt_deg', 0.5119, 0.45),
  ('table', 15, 'wall_offset', -0.07595, 0.3597),
  ('table', 15, 'width', -0.5198, 0.2058),
  ('table', 15, 'z_max', 0.7492, 0.05052),
  ('table', 15, 'z_min', 0.7477, 0.05359);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 16, 0.035, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 16, 'aspect', 0.6587, 0.2137),
  ('table', 16, 'behind', 0.3357, 0.1415),
  ('table', 16, 'corner_offset', 1.688, 0.4835),
  ('table', 16, 'edge_concave', 0.05221, 0.06828),
  ('table', 16, 'edge_convex', 0.1309, 0.1523),
  ('table', 16, 'edge_free', 0.6312, 0.221),
  ('table', 16, 'edge_free_top', -0.002687, 0.3093),
  ('table', 16, 'edge_unseen', 0.007306, 0.03056),
  ('table', 16, 'headroom', 2.039, 0.2871),
  ('table', 16, 'height', 0.714, 0.0241),
  ('table', 16, 'lift', -1.406, 0.03107),
  ('table', 16, 'rectangularity', 0.8189, 0.09002),
  ('table', 16, 'spread_length', 0.1578, 0.2975),
  ('table', 16, 'spread_width', -0.4331, 0.2747),
  ('table', 16, 'standoff', -0.001318, 0.3182),
  ('table', 16, 'tilt_deg', 0.2001, 0.45),
  ('table', 16, 'wall_offset', -0.02199, 0.3259),
  ('table', 16, 'width', -0.2931, 0.2323),
  ('table', 16, 'z_max', 0.7185, 0.02673),
  ('table', 16, 'z_min', 0.7104, 0.02699);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 17, 0.09596, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 17, 'aspect', 0.5422, 0.2309),
  ('table', 17, 'behind', 0.4361, 0.1479),
  ('table', 17, 'corner_offset', 1.059, 0.2648),
  ('table', 17, 'edge_concave', 0.1491, 0.1432),
  ('table', 17, 'edge_convex', 0.05854, 0.05156),
  ('table', 17, 'edge_free', 0.3992, 0.1715),
  ('table', 17, 'edge_free_top', -0.01982, 0.2913),
  ('table', 17, 'edge_unseen', 0.06174, 0.07368),
  ('table', 17, 'headroom', 2.261, 0.2917),
  ('table', 17, 'height', 1.026, 0.1158),
  ('table', 17, 'lift', -1.412, 0.03108),
  ('table', 17, 'rectangularity', 0.6921, 0.09775),
  ('table', 17, 'spread_length', 0.1729, 0.1665),
  ('table', 17, 'spread_width', -0.4427, 0.2383),
  ('table', 17, 'standoff', -0.005977, 0.3191),
  ('table', 17, 'tilt_deg', 0.3614, 0.4512),
  ('table', 17, 'wall_offset', -0.142, 0.2277),
  ('table', 17, 'width', -0.2363, 0.1852),
  ('table', 17, 'z_max', 1.012, 0.1201),
  ('table', 17, 'z_min', 1.033, 0.1178);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 18, 0.05938, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 18, 'aspect', 0.7168, 0.3696),
  ('table', 18, 'behind', 0.4705, 0.1178),
  ('table', 18, 'corner_offset', 0.8874, 0.3199),
  ('table', 18, 'edge_concave', 0.1576, 0.1334),
  ('table', 18, 'edge_convex', 0.05736, 0.08739),
  ('table', 18, 'edge_free', 0.3834, 0.2535),
  ('table', 18, 'edge_free_top', -0.005653, 0.3073),
  ('table', 18, 'edge_unseen', 0.1028, 0.1237),
  ('table', 18, 'headroom', 2.085, 0.5288),
  ('table', 18, 'height', 0.6585, 0.0225),
  ('table', 18, 'lift', -1.405, 0.03107),
  ('table', 18, 'rectangularity', 0.7042, 0.1011),
  ('table', 18, 'spread_length', 0.1201, 0.2468),
  ('table', 18, 'spread_width', -0.5635, 0.3965),
  ('table', 18, 'standoff', -0.00224, 0.3184),
  ('table', 18, 'tilt_deg', 0.5028, 0.4514),
  ('table', 18, 'wall_offset', -0.02527, 0.3303),
  ('table', 18, 'width', -0.3286, 0.1742),
  ('table', 18, 'z_max', 0.6627, 0.0225),
  ('table', 18, 'z_min', 0.652, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 19, 0.0181, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 19, 'aspect', 0.9791, 0.1993),
  ('table', 19, 'behind', 0.07631, 0.04864),
  ('table', 19, 'corner_offset', 1.502, 0.5042),
  ('table', 19, 'edge_concave', 0.06274, 0.07465),
  ('table', 19, 'edge_convex', 0.0287, 0.06044),
  ('table', 19, 'edge_free', 0.46, 0.166),
  ('table', 19, 'edge_free_top', -0.01411, 0.2985),
  ('table', 19, 'edge_unseen', 0.283, 0.0656),
  ('table', 19, 'headroom', 1.901, 0.04755),
  ('table', 19, 'height', 0.8029, 0.2231),
  ('table', 19, 'lift', -1.409, 0.03107),
  ('table', 19, 'rectangularity', 0.7127, 0.1969),
  ('table', 19, 'spread_length', -0.5011, 0.2609),
  ('table', 19, 'spread_width', -1.427, 0.1761),
  ('table', 19, 'standoff', -0.01645, 0.3192),
  ('table', 19, 'tilt_deg', 1.588, 0.4511),
  ('table', 19, 'wall_offset', -0.08946, 0.368),
  ('table', 19, 'width', -1.277, 0.1696),
  ('table', 19, 'z_max', 0.7918, 0.2212),
  ('table', 19, 'z_min', 0.8488, 0.2147);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 20, 0.01501, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 20, 'aspect', 0.4247, 0.2161),
  ('table', 20, 'behind', 0.1286, 0.06485),
  ('table', 20, 'corner_offset', 0.6606, 0.07783),
  ('table', 20, 'edge_concave', 0.1608, 0.1362),
  ('table', 20, 'edge_convex', 0.004234, 0.03),
  ('table', 20, 'edge_free', 0.2866, 0.1172),
  ('table', 20, 'edge_free_top', -0.00192, 0.3132),
  ('table', 20, 'edge_unseen', 0.331, 0.1435),
  ('table', 20, 'headroom', 2.004, 0.09069),
  ('table', 20, 'height', 0.03971, 0.06468),
  ('table', 20, 'lift', -1.406, 0.03107),
  ('table', 20, 'rectangularity', 0.7374, 0.0654),
  ('table', 20, 'spread_length', 0.02849, 0.2333),
  ('table', 20, 'spread_width', -0.7868, 0.353),
  ('table', 20, 'standoff', 2.692e-05, 0.3169),
  ('table', 20, 'tilt_deg', 0.8584, 0.45),
  ('table', 20, 'wall_offset', -0.003833, 0.3197),
  ('table', 20, 'width', -0.5428, 0.3274),
  ('table', 20, 'z_max', 0.02818, 0.04521),
  ('table', 20, 'z_min', 0.02573, 0.05292);

-- flat_screen: 1212 examples
UPDATE object_class SET prior = 0.03203 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.3804, 0.2061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5874, 0.1374)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'corner_offset', 1.517, 0.8653)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_concave', 0.1916, 0.1733)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_convex', 0.003634, 0.02617)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.7783, 0.1715)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.9764, 0.07153)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_unseen', 0.05818, 0.1129)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'headroom', 1.589, 0.2827)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.018, 0.09428)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'lift', -4.009, 1.43)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.8029, 0.114)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7753, 0.2088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.216, 0.196)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'standoff', 0.4534, 0.266)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.24, 3.261)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'wall_offset', 0.9509, 1.026)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -1.011, 0.2266)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.173, 0.1054)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7842, 0.1294)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'flat_screen';
DELETE FROM class_density WHERE class = 'flat_screen';
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.04521, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'aspect', 0.4369, 0.1419),
  ('flat_screen', 1, 'behind', 0.5678, 0.07771),
  ('flat_screen', 1, 'corner_offset', 1.461, 1.149),
  ('flat_screen', 1, 'edge_concave', 0.005653, 0.0318),
  ('flat_screen', 1, 'edge_convex', -0.0002509, 0.03),
  ('flat_screen', 1, 'edge_free', 0.9942, 0.03),
  ('flat_screen', 1, 'edge_free_top', 0.9992, 0.03),
  ('flat_screen', 1, 'edge_unseen', 0.02977, 0.05485),
  ('flat_screen', 1, 'headroom', 1.735, 0.3844),
  ('flat_screen', 1, 'height', 1.042, 0.06955),
  ('flat_screen', 1, 'lift', -2.194, 0.1642),
  ('flat_screen', 1, 'rectangularity', 0.939, 0.03644),
  ('flat_screen', 1, 'spread_length', -0.7914, 0.1954),
  ('flat_screen', 1, 'spread_width', -1.207, 0.09509),
  ('flat_screen', 1, 'standoff', 0.5261, 0.1374),
  ('flat_screen', 1, 'tilt_deg', 85.15, 2.354),
  ('flat_screen', 1, 'wall_offset', 0.9718, 0.9462),
  ('flat_screen', 1, 'width', -1.17, 0.1099),
  ('flat_screen', 1, 'z_max', 1.18, 0.07844),
  ('flat_screen', 1, 'z_min', 0.8498, 0.04899);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.03801, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'aspect', 0.585, 0.1962),
  ('flat_screen', 2, 'behind', 0.6561, 0.07099),
  ('flat_screen', 2, 'corner_offset', 1.718, 0.5756),
  ('flat_screen', 2, 'edge_concave', 0.4381, 0.09525),
  ('flat_screen', 2, 'edge_convex', -0.0006195, 0.03),
  ('flat_screen', 2, 'edge_free', 0.6382, 0.07015),
  ('flat_screen', 2, 'edge_free_top', 0.9387, 0.1147),
  ('flat_screen', 2, 'edge_unseen', 0.005119, 0.03002),
  ('flat_screen', 2, 'headroom', 1.678, 0.2251),
  ('flat_screen', 2, 'height', 0.9542, 0.04688),
  ('flat_screen', 2, 'lift', -5.26, 0.1314),
  ('flat_screen', 2, 'rectangularity', 0.6546, 0.04113),
  ('flat_screen', 2, 'spread_length', -0.4586, 0.205),
  ('flat_screen', 2, 'spread_width', -1.085, 0.09718),
  ('flat_screen', 2, 'standoff', 0.7744, 0.2724),
  ('flat_screen', 2, 'tilt_deg', 84.29, 2.196),
  ('flat_screen', 2, 'wall_offset', 1.186, 0.846),
  ('flat_screen', 2, 'width', -0.7096, 0.1619),
  ('flat_screen', 2, 'z_max', 1.104, 0.05385),
  ('flat_screen', 2, 'z_min', 0.6577, 0.02877);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.06155, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'aspect', 0.3854, 0.06173),
  ('flat_screen', 3, 'behind', 0.4864, 0.1427),
  ('flat_screen', 3, 'corner_offset', 1.471, 0.7869),
  ('flat_screen', 3, 'edge_concave', 0.3097, 0.07904),
  ('flat_screen', 3, 'edge_convex', -0.001217, 0.03),
  ('flat_screen', 3, 'edge_free', 0.7413, 0.07318),
  ('flat_screen', 3, 'edge_free_top', 0.9968, 0.03167),
  ('flat_screen', 3, 'edge_unseen', 0.008066, 0.03),
  ('flat_screen', 3, 'headroom', 1.634, 0.2715),
  ('flat_screen', 3, 'height', 0.9905, 0.04571),
  ('flat_screen', 3, 'lift', -5.048, 0.2976),
  ('flat_screen', 3, 'rectangularity', 0.8193, 0.0747),
  ('flat_screen', 3, 'spread_length', -0.6211, 0.05991),
  ('flat_screen', 3, 'spread_width', -1.065, 0.04568),
  ('flat_screen', 3, 'standoff', 0.33, 0.06818),
  ('flat_screen', 3, 'tilt_deg', 86.45, 2.037),
  ('flat_screen', 3, 'wall_offset', 1.982, 0.4915),
  ('flat_screen', 3, 'width', -0.8413, 0.08004),
  ('flat_screen', 3, 'z_max', 1.126, 0.0655),
  ('flat_screen', 3, 'z_min', 0.6928, 0.04307);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.05648, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'aspect', 0.2316, 0.1261),
  ('flat_screen', 4, 'behind', 0.6418, 0.07124),
  ('flat_screen', 4, 'corner_offset', 1.373, 0.5653),
  ('flat_screen', 4, 'edge_concave', 0.3196, 0.09306),
  ('flat_screen', 4, 'edge_convex', -0.0001012, 0.03),
  ('flat_screen', 4, 'edge_free', 0.7443, 0.06059),
  ('flat_screen', 4, 'edge_free_top', 1.001, 0.03),
  ('flat_screen', 4, 'edge_unseen', 0.00282, 0.03),
  ('flat_screen', 4, 'headroom', 1.71, 0.1123),
  ('flat_screen', 4, 'height', 0.956, 0.0245),
  ('flat_screen', 4, 'lift', -5.114, 0.342),
  ('flat_screen', 4, 'rectangularity', 0.8203, 0.04507),
  ('flat_screen', 4, 'spread_length', -0.9019, 0.0951),
  ('flat_screen', 4, 'spread_width', -1.249, 0.06832),
  ('flat_screen', 4, 'standoff', 0.391, 0.1215),
  ('flat_screen', 4, 'tilt_deg', 85.02, 1.541),
  ('flat_screen', 4, 'wall_offset', 0.6402, 0.6489),
  ('flat_screen', 4, 'width', -0.9934, 0.04737),
  ('flat_screen', 4, 'z_max', 1.064, 0.03391),
  ('flat_screen', 4, 'z_min', 0.6849, 0.02684);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.04006, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'aspect', 0.6732, 0.3738),
  ('flat_screen', 5, 'behind', 0.5631, 0.132),
  ('flat_screen', 5, 'corner_offset', 1.596, 0.5813),
  ('flat_screen', 5, 'edge_concave', 0.0202, 0.07258),
  ('flat_screen', 5, 'edge_convex', 1.055e-05, 0.03002),
  ('flat_screen', 5, 'edge_free', 0.8313, 0.2612),
  ('flat_screen', 5, 'edge_free_top', 0.9975, 0.03419),
  ('flat_screen', 5, 'edge_unseen', 0.2552, 0.1106),
  ('flat_screen', 5, 'headroom', 1.468, 0.2332),
  ('flat_screen', 5, 'height', 1.072, 0.02294),
  ('flat_screen', 5, 'lift', -2.104, 0.319),
  ('flat_screen', 5, 'rectangularity', 0.775, 0.08815),
  ('flat_screen', 5, 'spread_length', -0.9106, 0.1748),
  ('flat_screen', 5, 'spread_width', -1.685, 0.2624),
  ('flat_screen', 5, 'standoff', 0.3559, 0.05917),
  ('flat_screen', 5, 'tilt_deg', 84.72, 2.646),
  ('flat_screen', 5, 'wall_offset', 1.797, 1.47),
  ('flat_screen', 5, 'width', -1.544, 0.2183),
  ('flat_screen', 5, 'z_max', 1.12, 0.06083),
  ('flat_screen', 5, 'z_min', 0.8547, 0.05411);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.06538, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'aspect', 0.3293, 0.1965),
  ('flat_screen', 6, 'behind', 0.6137, 0.05528),
  ('flat_screen', 6, 'corner_offset', 1.315, 0.3092),
  ('flat_screen', 6, 'edge_concave', 0.1429, 0.07153),
  ('flat_screen', 6, 'edge_convex', 0.0007306, 0.03),
  ('flat_screen', 6, 'edge_free', 0.8008, 0.1066),
  ('flat_screen', 6, 'edge_free_top', 0.9962, 0.03),
  ('flat_screen', 6, 'edge_unseen', 0.006683, 0.03002),
  ('flat_screen', 6, 'headroom', 1.581, 0.2848),
  ('flat_screen', 6, 'height', 1.098, 0.03162),
  ('flat_screen', 6, 'lift', -4.449, 1.007),
  ('flat_screen', 6, 'rectangularity', 0.7666, 0.07656),
  ('flat_screen', 6, 'spread_length', -0.6291, 0.1291),
  ('flat_screen', 6, 'spread_width', -1.153, 0.1184),
  ('flat_screen', 6, 'standoff', 0.6475, 0.3113),
  ('flat_screen', 6, 'tilt_deg', 84.28, 2.021),
  ('flat_screen', 6, 'wall_offset', 0.6526, 0.3729),
  ('flat_screen', 6, 'width', -0.8835, 0.1457),
  ('flat_screen', 6, 'z_max', 1.238, 0.03741),
  ('flat_screen', 6, 'z_min', 0.8237, 0.04116);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.03717, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'aspect', 0.476, 0.2272),
  ('flat_screen', 7, 'behind', 0.5482, 0.1133),
  ('flat_screen', 7, 'corner_offset', 1.278, 0.7449),
  ('flat_screen', 7, 'edge_concave', 0.3975, 0.09843),
  ('flat_screen', 7, 'edge_convex', 0.002415, 0.03011),
  ('flat_screen', 7, 'edge_free', 0.5651, 0.07747),
  ('flat_screen', 7, 'edge_free_top', 0.7692, 0.1153),
  ('flat_screen', 7, 'edge_unseen', 0.06568, 0.07511),
  ('flat_screen', 7, 'headroom', 1.564, 0.4265),
  ('flat_screen', 7, 'height', 1.098, 0.0446),
  ('flat_screen', 7, 'lift', -5.039, 0.4354),
  ('flat_screen', 7, 'rectangularity', 0.6408, 0.1704),
  ('flat_screen', 7, 'spread_length', -0.6054, 0.3362),
  ('flat_screen', 7, 'spread_width', -1.146, 0.09612),
  ('flat_screen', 7, 'standoff', 0.5943, 0.331),
  ('flat_screen', 7, 'tilt_deg', 83.11, 1.688),
  ('flat_screen', 7, 'wall_offset', 1.231, 1.478),
  ('flat_screen', 7, 'width', -0.6803, 0.2363),
  ('flat_screen', 7, 'z_max', 1.307, 0.1113),
  ('flat_screen', 7, 'z_min', 0.8046, 0.07806);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.05986, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'aspect', 0.4199, 0.2881),
  ('flat_screen', 8, 'behind', 0.6135, 0.0852),
  ('flat_screen', 8, 'corner_offset', 1.943, 0.5356),
  ('flat_screen', 8, 'edge_concave', 0.2524, 0.08577),
  ('flat_screen', 8, 'edge_convex', 0.03238, 0.08023),
  ('flat_screen', 8, 'edge_free', 0.7231, 0.1307),
  ('flat_screen', 8, 'edge_free_top', 0.999, 0.03003),
  ('flat_screen', 8, 'edge_unseen', 0.1688, 0.1273),
  ('flat_screen', 8, 'headroom', 1.479, 0.4576),
  ('flat_screen', 8, 'height', 1.019, 0.0358),
  ('flat_screen', 8, 'lift', -4.838, 0.6098),
  ('flat_screen', 8, 'rectangularity', 0.7497, 0.09788),
  ('flat_screen', 8, 'spread_length', -0.8217, 0.1918),
  ('flat_screen', 8, 'spread_width', -1.184, 0.09891),
  ('flat_screen', 8, 'standoff', 0.3194, 0.06845),
  ('flat_screen', 8, 'tilt_deg', 84.16, 1.889),
  ('flat_screen', 8, 'wall_offset', 0.356, 0.0588),
  ('flat_screen', 8, 'width', -0.8989, 0.09005),
  ('flat_screen', 8, 'z_max', 1.152, 0.04023),
  ('flat_screen', 8, 'z_min', 0.7291, 0.03349);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.05395, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'aspect', 0.3733, 0.2046),
  ('flat_screen', 9, 'behind', 0.4635, 0.05133),
  ('flat_screen', 9, 'corner_offset', 1.303, 1.346),
  ('flat_screen', 9, 'edge_concave', 0.1021, 0.09376),
  ('flat_screen', 9, 'edge_convex', -0.0004395, 0.03005),
  ('flat_screen', 9, 'edge_free', 0.8905, 0.08821),
  ('flat_screen', 9, 'edge_free_top', 0.998, 0.03002),
  ('flat_screen', 9, 'edge_unseen', 0.131, 0.1831),
  ('flat_screen', 9, 'headroom', 1.474, 0.5222),
  ('flat_screen', 9, 'height', 1.34, 0.03685),
  ('flat_screen', 9, 'lift', -4.029, 1.488),
  ('flat_screen', 9, 'rectangularity', 0.8448, 0.1007),
  ('flat_screen', 9, 'spread_length', -0.7049, 0.1418),
  ('flat_screen', 9, 'spread_width', -1.197, 0.1618),
  ('flat_screen', 9, 'standoff', 0.3584, 0.05978),
  ('flat_screen', 9, 'tilt_deg', 82.96, 2.217),
  ('flat_screen', 9, 'wall_offset', 0.8368, 0.7519),
  ('flat_screen', 9, 'width', -0.9577, 0.0607),
  ('flat_screen', 9, 'z_max', 1.471, 0.06639),
  ('flat_screen', 9, 'z_min', 1.149, 0.05142);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.01732, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'aspect', 0.5678, 0.2019),
  ('flat_screen', 10, 'behind', 0.542, 0.2202),
  ('flat_screen', 10, 'corner_offset', 1.13, 0.1424),
  ('flat_screen', 10, 'edge_concave', 0.07225, 0.06433),
  ('flat_screen', 10, 'edge_convex', 6.866e-05, 0.03001),
  ('flat_screen', 10, 'edge_free', 0.7123, 0.1273),
  ('flat_screen', 10, 'edge_free_top', 0.9985, 0.03),
  ('flat_screen', 10, 'edge_unseen', 0.02193, 0.05016),
  ('flat_screen', 10, 'headroom', 1.577, 0.07388),
  ('flat_screen', 10, 'height', 0.3281, 0.05153),
  ('flat_screen', 10, 'lift', -3.992, 0.4223),
  ('flat_screen', 10, 'rectangularity', 0.8897, 0.06424),
  ('flat_screen', 10, 'spread_length', -0.8508, 0.1225),
  ('flat_screen', 10, 'spread_width', -1.473, 0.1612),
  ('flat_screen', 10, 'standoff', 0.4998, 0.1606),
  ('flat_screen', 10, 'tilt_deg', 86.24, 4.367),
  ('flat_screen', 10, 'wall_offset', 1, 0.2196),
  ('flat_screen', 10, 'width', -1.294, 0.2411),
  ('flat_screen', 10, 'z_max', 0.4453, 0.04859),
  ('flat_screen', 10, 'z_min', 0.1475, 0.1024);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 11, 0.07916, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 11, 'aspect', 0.3506, 0.1497),
  ('flat_screen', 11, 'behind', 0.6091, 0.06887),
  ('flat_screen', 11, 'corner_offset', 2.034, 1.347),
  ('flat_screen', 11, 'edge_concave', 0.3339, 0.07471),
  ('flat_screen', 11, 'edge_convex', -0.002702, 0.03),
  ('flat_screen', 11, 'edge_free', 0.7073, 0.06592),
  ('flat_screen', 11, 'edge_free_top', 0.9946, 0.03213),
  ('flat_screen', 11, 'edge_unseen', 0.047, 0.1006),
  ('flat_screen', 11, 'headroom', 1.612, 0.2648),
  ('flat_screen', 11, 'height', 1.018, 0.0601),
  ('flat_screen', 11, 'lift', -5.064, 0.3239),
  ('flat_screen', 11, 'rectangularity', 0.7903, 0.08686),
  ('flat_screen', 11, 'spread_length', -0.7451, 0.1537),
  ('flat_screen', 11, 'spread_width', -1.155, 0.07549),
  ('flat_screen', 11, 'standoff', 0.3645, 0.09539),
  ('flat_screen', 11, 'tilt_deg', 84.09, 1.931),
  ('flat_screen', 11, 'wall_offset', 0.3708, 0.06211),
  ('flat_screen', 11, 'width', -0.9219, 0.09988),
  ('flat_screen', 11, 'z_max', 1.125, 0.08731),
  ('flat_screen', 11, 'z_min', 0.7, 0.03969);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 12, 0.04806, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 12, 'aspect', 0.4222, 0.1362),
  ('flat_screen', 12, 'behind', 0.5417, 0.1102),
  ('flat_screen', 12, 'corner_offset', 1.809, 0.6851),
  ('flat_screen', 12, 'edge_concave', 0.008214, 0.03733),
  ('flat_screen', 12, 'edge_convex', -0.0001552, 0.03013),
  ('flat_screen', 12, 'edge_free', 0.9785, 0.05115),
  ('flat_screen', 12, 'edge_free_top', 1.001, 0.03006),
  ('flat_screen', 12, 'edge_unseen', 0.06222, 0.1257),
  ('flat_screen', 12, 'headroom', 1.511, 0.2278),
  ('flat_screen', 12, 'height', 1.071, 0.03178),
  ('flat_screen', 12, 'lift', -2.189, 0.2326),
  ('flat_screen', 12, 'rectangularity', 0.9335, 0.04649),
  ('flat_screen', 12, 'spread_length', -0.7775, 0.2265),
  ('flat_screen', 12, 'spread_width', -1.203, 0.116),
  ('flat_screen', 12, 'standoff', 0.412, 0.1757),
  ('flat_screen', 12, 'tilt_deg', 84.02, 2.385),
  ('flat_screen', 12, 'wall_offset', 1.334, 0.8966),
  ('flat_screen', 12, 'width', -1.146, 0.1082),
  ('flat_screen', 12, 'z_max', 1.211, 0.03284),
  ('flat_screen', 12, 'z_min', 0.8915, 0.03754);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 13, 0.04141, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 13, 'aspect', 0.2824, 0.08171),
  ('flat_screen', 13, 'behind', 0.5815, 0.1109),
  ('flat_screen', 13, 'corner_offset', 1.531, 0.4187),
  ('flat_screen', 13, 'edge_concave', 0.2646, 0.05957),
  ('flat_screen', 13, 'edge_convex', 0.0002484, 0.03006),
  ('flat_screen', 13, 'edge_free', 0.7501, 0.06505),
  ('flat_screen', 13, 'edge_free_top', 0.9974, 0.03024),
  ('flat_screen', 13, 'edge_unseen', 0.006692, 0.03015),
  ('flat_screen', 13, 'headroom', 1.588, 0.2329),
  ('flat_screen', 13, 'height', 1.013, 0.02257),
  ('flat_screen', 13, 'lift', -4.948, 0.433),
  ('flat_screen', 13, 'rectangularity', 0.8104, 0.08401),
  ('flat_screen', 13, 'spread_length', -0.696, 0.1454),
  ('flat_screen', 13, 'spread_width', -1.146, 0.07577),
  ('flat_screen', 13, 'standoff', 0.915, 0.3446),
  ('flat_screen', 13, 'tilt_deg', 86.18, 2.576),
  ('flat_screen', 13, 'wall_offset', 1.44, 0.5412),
  ('flat_screen', 13, 'width', -0.8672, 0.07015),
  ('flat_screen', 13, 'z_max', 1.153, 0.02645),
  ('flat_screen', 13, 'z_min', 0.7358, 0.03009);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 14, 0.04433, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 14, 'aspect', 0.2647, 0.1614),
  ('flat_screen', 14, 'behind', 0.5549, 0.1141),
  ('flat_screen', 14, 'corner_offset', 1.825, 0.6433),
  ('flat_screen', 14, 'edge_concave', 0.3217, 0.04076),
  ('flat_screen', 14, 'edge_convex', 0.000494, 0.03),
  ('flat_screen', 14, 'edge_free', 0.6626, 0.09567),
  ('flat_screen', 14, 'edge_free_top', 0.9943, 0.03),
  ('flat_screen', 14, 'edge_unseen', 0.002742, 0.03001),
  ('flat_screen', 14, 'headroom', 1.688, 0.1687),
  ('flat_screen', 14, 'height', 0.9609, 0.0225),
  ('flat_screen', 14, 'lift', -5.007, 0.3739),
  ('flat_screen', 14, 'rectangularity', 0.8193, 0.06268),
  ('flat_screen', 14, 'spread_length', -0.9252, 0.1809),
  ('flat_screen', 14, 'spread_width', -1.256, 0.09967),
  ('flat_screen', 14, 'standoff', 0.3256, 0.05444),
  ('flat_screen', 14, 'tilt_deg', 83.15, 2.177),
  ('flat_screen', 14, 'wall_offset', 1.245, 1.829),
  ('flat_screen', 14, 'width', -0.9851, 0.0491),
  ('flat_screen', 14, 'z_max', 1.083, 0.0225),
  ('flat_screen', 14, 'z_min', 0.7118, 0.02375);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 15, 0.05638, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 15, 'aspect', 0.5806, 0.3701),
  ('flat_screen', 15, 'behind', 0.4648, 0.09828),
  ('flat_screen', 15, 'corner_offset', 1.306, 0.356),
  ('flat_screen', 15, 'edge_concave', 0.2404, 0.07381),
  ('flat_screen', 15, 'edge_convex', -0.001212, 0.03),
  ('flat_screen', 15, 'edge_free', 0.8382, 0.1317),
  ('flat_screen', 15, 'edge_free_top', 0.9958, 0.03),
  ('flat_screen', 15, 'edge_unseen', 0.1921, 0.1443),
  ('flat_screen', 15, 'headroom', 1.392, 0.3256),
  ('flat_screen', 15, 'height', 1.308, 0.1218),
  ('flat_screen', 15, 'lift', -3.911, 1.385),
  ('flat_screen', 15, 'rectangularity', 0.8425, 0.1734),
  ('flat_screen', 15, 'spread_length', -0.6843, 0.287),
  ('flat_screen', 15, 'spread_width', -1.18, 0.1011),
  ('flat_screen', 15, 'standoff', 0.3837, 0.1779),
  ('flat_screen', 15, 'tilt_deg', 83.8, 1.455),
  ('flat_screen', 15, 'wall_offset', 1.851, 0.7811),
  ('flat_screen', 15, 'width', -1.16, 0.4611),
  ('flat_screen', 15, 'z_max', 1.415, 0.09816),
  ('flat_screen', 15, 'z_min', 1.101, 0.1426);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 16, 0.04933, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 16, 'aspect', 0.437, 0.1185),
  ('flat_screen', 16, 'behind', 0.5448, 0.1461),
  ('flat_screen', 16, 'corner_offset', 1.498, 0.9086),
  ('flat_screen', 16, 'edge_concave', 0.04615, 0.07417),
  ('flat_screen', 16, 'edge_convex', 0.0002619, 0.03012),
  ('flat_screen', 16, 'edge_free', 0.9095, 0.09038),
  ('flat_screen', 16, 'edge_free_top', 0.9983, 0.03018),
  ('flat_screen', 16, 'edge_unseen', 0.004958, 0.03014),
  ('flat_screen', 16, 'headroom', 1.633, 0.2076),
  ('flat_screen', 16, 'height', 0.9684, 0.03112),
  ('flat_screen', 16, 'lift', -2.326, 0.252),
  ('flat_screen', 16, 'rectangularity', 0.9445, 0.03002),
  ('flat_screen', 16, 'spread_length', -0.856, 0.2113),
  ('flat_screen', 16, 'spread_width', -1.236, 0.1167),
  ('flat_screen', 16, 'standoff', 0.3704, 0.1564),
  ('flat_screen', 16, 'tilt_deg', 84.3, 3.116),
  ('flat_screen', 16, 'wall_offset', 0.6344, 0.3063),
  ('flat_screen', 16, 'width', -1.24, 0.1391),
  ('flat_screen', 16, 'z_max', 1.101, 0.02885),
  ('flat_screen', 16, 'z_min', 0.803, 0.03159);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 17, 0.07111, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 17, 'aspect', 0.54, 0.1946),
  ('flat_screen', 17, 'behind', 0.613, 0.1609),
  ('flat_screen', 17, 'corner_offset', 1.602, 0.409),
  ('flat_screen', 17, 'edge_concave', 0.4161, 0.06997),
  ('flat_screen', 17, 'edge_convex', -0.001107, 0.03002),
  ('flat_screen', 17, 'edge_free', 0.6207, 0.04356),
  ('flat_screen', 17, 'edge_free_top', 0.918, 0.09219),
  ('flat_screen', 17, 'edge_unseen', 0.007695, 0.03004),
  ('flat_screen', 17, 'headroom', 1.527, 0.3903),
  ('flat_screen', 17, 'height', 1.009, 0.04357),
  ('flat_screen', 17, 'lift', -5.268, 0.1018),
  ('flat_screen', 17, 'rectangularity', 0.6259, 0.06365),
  ('flat_screen', 17, 'spread_length', -0.5675, 0.1901),
  ('flat_screen', 17, 'spread_width', -1.131, 0.07234),
  ('flat_screen', 17, 'standoff', 1.172, 0.2969),
  ('flat_screen', 17, 'tilt_deg', 83.98, 1.866),
  ('flat_screen', 17, 'wall_offset', 2.089, 0.9948),
  ('flat_screen', 17, 'width', -0.6459, 0.2012),
  ('flat_screen', 17, 'z_max', 1.23, 0.1304),
  ('flat_screen', 17, 'z_min', 0.7049, 0.08214);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 18, 0.03091, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 18, 'aspect', 0.5535, 0.2018),
  ('flat_screen', 18, 'behind', 0.6418, 0.08743),
  ('flat_screen', 18, 'corner_offset', 1.622, 1.127),
  ('flat_screen', 18, 'edge_concave', 0.2141, 0.2291),
  ('flat_screen', 18, 'edge_convex', 0.06926, 0.08553),
  ('flat_screen', 18, 'edge_free', 0.6702, 0.1),
  ('flat_screen', 18, 'edge_free_top', 0.9979, 0.03),
  ('flat_screen', 18, 'edge_unseen', 0.108, 0.1014),
  ('flat_screen', 18, 'headroom', 1.877, 0.4235),
  ('flat_screen', 18, 'height', 1.034, 0.02365),
  ('flat_screen', 18, 'lift', -2.688, 0.6758),
  ('flat_screen', 18, 'rectangularity', 0.694, 0.1619),
  ('flat_screen', 18, 'spread_length', -0.8148, 0.2732),
  ('flat_screen', 18, 'spread_width', -1.338, 0.3492),
  ('flat_screen', 18, 'standoff', 0.325, 0.09129),
  ('flat_screen', 18, 'tilt_deg', 83.85, 1.603),
  ('flat_screen', 18, 'wall_offset', 0.3328, 0.07331),
  ('flat_screen', 18, 'width', -1.098, 0.3125),
  ('flat_screen', 18, 'z_max', 1.161, 0.04134),
  ('flat_screen', 18, 'z_min', 0.803, 0.04775);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 19, 0.03672, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 19, 'aspect', 0.6278, 0.1728),
  ('flat_screen', 19, 'behind', 0.7023, 0.1037),
  ('flat_screen', 19, 'corner_offset', 1.028, 0.2454),
  ('flat_screen', 19, 'edge_concave', 0.1582, 0.08863),
  ('flat_screen', 19, 'edge_convex', -0.002198, 0.03042),
  ('flat_screen', 19, 'edge_free', 0.5804, 0.1012),
  ('flat_screen', 19, 'edge_free_top', 0.683, 0.1472),
  ('flat_screen', 19, 'edge_unseen', 0.05931, 0.1142),
  ('flat_screen', 19, 'headroom', 1.388, 0.2096),
  ('flat_screen', 19, 'height', 1.076, 0.05039),
  ('flat_screen', 19, 'lift', -2.274, 0.3991),
  ('flat_screen', 19, 'rectangularity', 0.7785, 0.1315),
  ('flat_screen', 19, 'spread_length', -0.7639, 0.2433),
  ('flat_screen', 19, 'spread_width', -1.453, 0.3429),
  ('flat_screen', 19, 'standoff', 0.4044, 0.08806),
  ('flat_screen', 19, 'tilt_deg', 85.36, 2.112),
  ('flat_screen', 19, 'wall_offset', 1.578, 0.4053),
  ('flat_screen', 19, 'width', -1.233, 0.4049),
  ('flat_screen', 19, 'z_max', 1.198, 0.06561),
  ('flat_screen', 19, 'z_min', 0.8909, 0.06421);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 20, 0.0176, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 20, 'aspect', 0.5161, 0.1044),
  ('flat_screen', 20, 'behind', 0.5072, 0.1848),
  ('flat_screen', 20, 'corner_offset', 0.8176, 0.2504),
  ('flat_screen', 20, 'edge_concave', 0.182, 0.1763),
  ('flat_screen', 20, 'edge_convex', 0.0001242, 0.03),
  ('flat_screen', 20, 'edge_free', 0.6877, 0.08188),
  ('flat_screen', 20, 'edge_free_top', 0.9978, 0.03),
  ('flat_screen', 20, 'edge_unseen', 0.039, 0.06377),
  ('flat_screen', 20, 'headroom', 1.576, 0.08224),
  ('flat_screen', 20, 'height', 0.326, 0.07565),
  ('flat_screen', 20, 'lift', -3.97, 0.4461),
  ('flat_screen', 20, 'rectangularity', 0.8668, 0.08575),
  ('flat_screen', 20, 'spread_length', -0.7296, 0.1048),
  ('flat_screen', 20, 'spread_width', -1.193, 0.1383),
  ('flat_screen', 20, 'standoff', 0.5645, 0.3951),
  ('flat_screen', 20, 'tilt_deg', 85.2, 1.483),
  ('flat_screen', 20, 'wall_offset', 0.9945, 0.2283),
  ('flat_screen', 20, 'width', -1.107, 0.1262),
  ('flat_screen', 20, 'z_max', 0.4706, 0.06427),
  ('flat_screen', 20, 'z_min', 0.1284, 0.08018);

-- keyboard: 841 examples
UPDATE object_class SET prior = 0.02045 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7533, 0.3028)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.248, 0.1643)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'corner_offset', 0.7867, 0.4661)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_concave', 0.009581, 0.03796)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_convex', 0.02491, 0.08217)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.253, 0.2102)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_unseen', 0.04714, 0.1083)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'headroom', 1.951, 0.2465)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7604, 0.1189)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'lift', -3.591, 0.1694)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.81, 0.0831)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -1.001, 0.3035)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.84, 0.1587)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.367, 2.045)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.664, 0.2343)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.767, 0.119)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7541, 0.119)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'keyboard';
DELETE FROM class_density WHERE class = 'keyboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.06968, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'aspect', 0.9383, 0.1505),
  ('keyboard', 1, 'behind', 0.3137, 0.06906),
  ('keyboard', 1, 'corner_offset', 0.866, 0.4372),
  ('keyboard', 1, 'edge_concave', 0.001137, 0.03004),
  ('keyboard', 1, 'edge_convex', 0.001091, 0.03138),
  ('keyboard', 1, 'edge_free', 0.292, 0.0943),
  ('keyboard', 1, 'edge_free_top', -0.01183, 0.2901),
  ('keyboard', 1, 'edge_unseen', 0.001485, 0.03072),
  ('keyboard', 1, 'headroom', 1.955, 0.1975),
  ('keyboard', 1, 'height', 0.7929, 0.0225),
  ('keyboard', 1, 'lift', -3.54, 0.1055),
  ('keyboard', 1, 'rectangularity', 0.8081, 0.06157),
  ('keyboard', 1, 'spread_length', -0.8178, 0.08588),
  ('keyboard', 1, 'spread_width', -1.793, 0.1167),
  ('keyboard', 1, 'standoff', -0.0005005, 0.3175),
  ('keyboard', 1, 'tilt_deg', 4.374, 1.488),
  ('keyboard', 1, 'wall_offset', -0.01922, 0.3348),
  ('keyboard', 1, 'width', -1.671, 0.2048),
  ('keyboard', 1, 'z_max', 0.7961, 0.0225),
  ('keyboard', 1, 'z_min', 0.7892, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.05314, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'aspect', 0.9067, 0.1269),
  ('keyboard', 2, 'behind', 0.2125, 0.1349),
  ('keyboard', 2, 'corner_offset', 0.8675, 0.575),
  ('keyboard', 2, 'edge_concave', -0.0005214, 0.0375),
  ('keyboard', 2, 'edge_convex', 0.001002, 0.04222),
  ('keyboard', 2, 'edge_free', 0.2902, 0.1072),
  ('keyboard', 2, 'edge_free_top', -0.003332, 0.3108),
  ('keyboard', 2, 'edge_unseen', 0.00105, 0.03227),
  ('keyboard', 2, 'headroom', 1.914, 0.2093),
  ('keyboard', 2, 'height', 0.7226, 0.02702),
  ('keyboard', 2, 'lift', -3.597, 0.1303),
  ('keyboard', 2, 'rectangularity', 0.7647, 0.03803),
  ('keyboard', 2, 'spread_length', -0.7822, 0.06983),
  ('keyboard', 2, 'spread_width', -1.81, 0.08103),
  ('keyboard', 2, 'standoff', -0.0003916, 0.3185),
  ('keyboard', 2, 'tilt_deg', 4.362, 1.08),
  ('keyboard', 2, 'wall_offset', -0.004013, 0.3228),
  ('keyboard', 2, 'width', -1.579, 0.1101),
  ('keyboard', 2, 'z_max', 0.7307, 0.02804),
  ('keyboard', 2, 'z_min', 0.7145, 0.02735);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.04725, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'aspect', 0.5759, 0.1521),
  ('keyboard', 3, 'behind', 0.2517, 0.08469),
  ('keyboard', 3, 'corner_offset', 0.79, 0.07917),
  ('keyboard', 3, 'edge_concave', 0.006421, 0.03564),
  ('keyboard', 3, 'edge_convex', 0.001697, 0.03879),
  ('keyboard', 3, 'edge_free', 0.02442, 0.03167),
  ('keyboard', 3, 'edge_free_top', -0.001743, 0.3152),
  ('keyboard', 3, 'edge_unseen', 0.09854, 0.1099),
  ('keyboard', 3, 'headroom', 1.966, 0.1952),
  ('keyboard', 3, 'height', 0.7558, 0.03935),
  ('keyboard', 3, 'lift', -3.692, 0.06549),
  ('keyboard', 3, 'rectangularity', 0.8218, 0.03825),
  ('keyboard', 3, 'spread_length', -1.121, 0.2282),
  ('keyboard', 3, 'spread_width', -1.775, 0.06273),
  ('keyboard', 3, 'standoff', -0.0002128, 0.3217),
  ('keyboard', 3, 'tilt_deg', 1.825, 0.4501),
  ('keyboard', 3, 'wall_offset', -0.01025, 0.3121),
  ('keyboard', 3, 'width', -1.524, 0.179),
  ('keyboard', 3, 'z_max', 0.7579, 0.03681),
  ('keyboard', 3, 'z_min', 0.7562, 0.04534);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.055, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'aspect', 0.4352, 0.2608),
  ('keyboard', 4, 'behind', 0.2389, 0.1417),
  ('keyboard', 4, 'corner_offset', 1.117, 0.8068),
  ('keyboard', 4, 'edge_concave', -0.0006586, 0.03001),
  ('keyboard', 4, 'edge_convex', 0.004863, 0.03959),
  ('keyboard', 4, 'edge_free', 0.2412, 0.1501),
  ('keyboard', 4, 'edge_free_top', -0.005887, 0.3112),
  ('keyboard', 4, 'edge_unseen', 0.2583, 0.1094),
  ('keyboard', 4, 'headroom', 2.114, 0.297),
  ('keyboard', 4, 'height', 0.7492, 0.04971),
  ('keyboard', 4, 'lift', -3.554, 0.1004),
  ('keyboard', 4, 'rectangularity', 0.7348, 0.06211),
  ('keyboard', 4, 'spread_length', -1.664, 0.06812),
  ('keyboard', 4, 'spread_width', -2.079, 0.04413),
  ('keyboard', 4, 'standoff', -0.004961, 0.3245),
  ('keyboard', 4, 'tilt_deg', 4.246, 1.113),
  ('keyboard', 4, 'wall_offset', -0.02373, 0.3101),
  ('keyboard', 4, 'width', -1.989, 0.2856),
  ('keyboard', 4, 'z_max', 0.739, 0.03231),
  ('keyboard', 4, 'z_min', 0.7507, 0.05333);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.04933, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'aspect', 0.3146, 0.1783),
  ('keyboard', 5, 'behind', 0.3295, 0.04953),
  ('keyboard', 5, 'corner_offset', 0.669, 0.5345),
  ('keyboard', 5, 'edge_concave', -0.0006177, 0.03),
  ('keyboard', 5, 'edge_convex', 0.0004262, 0.03035),
  ('keyboard', 5, 'edge_free', 0.3758, 0.0934),
  ('keyboard', 5, 'edge_free_top', -0.006808, 0.3059),
  ('keyboard', 5, 'edge_unseen', 0.05507, 0.0994),
  ('keyboard', 5, 'headroom', 2.039, 0.4286),
  ('keyboard', 5, 'height', 0.7567, 0.0402),
  ('keyboard', 5, 'lift', -3.547, 0.08263),
  ('keyboard', 5, 'rectangularity', 0.7795, 0.03507),
  ('keyboard', 5, 'spread_length', -1.299, 0.2274),
  ('keyboard', 5, 'spread_width', -1.772, 0.05889),
  ('keyboard', 5, 'standoff', -0.002295, 0.3211),
  ('keyboard', 5, 'tilt_deg', 5.692, 1.28),
  ('keyboard', 5, 'wall_offset', -0.01944, 0.3139),
  ('keyboard', 5, 'width', -1.522, 0.1901),
  ('keyboard', 5, 'z_max', 0.7631, 0.03857),
  ('keyboard', 5, 'z_min', 0.7501, 0.04318);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.04018, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'aspect', 0.5921, 0.2011),
  ('keyboard', 6, 'behind', 0.4024, 0.1208),
  ('keyboard', 6, 'corner_offset', 0.8409, 0.6162),
  ('keyboard', 6, 'edge_concave', 0.09826, 0.09972),
  ('keyboard', 6, 'edge_convex', 0.09165, 0.09175),
  ('keyboard', 6, 'edge_free', 0.1395, 0.06458),
  ('keyboard', 6, 'edge_free_top', -0.004436, 0.3134),
  ('keyboard', 6, 'edge_unseen', 0.001328, 0.03009),
  ('keyboard', 6, 'headroom', 1.772, 0.1355),
  ('keyboard', 6, 'height', 0.757, 0.1092),
  ('keyboard', 6, 'lift', -3.564, 0.2093),
  ('keyboard', 6, 'rectangularity', 0.743, 0.03005),
  ('keyboard', 6, 'spread_length', -0.8708, 0.06017),
  ('keyboard', 6, 'spread_width', -1.727, 0.06826),
  ('keyboard', 6, 'standoff', -0.0009883, 0.3214),
  ('keyboard', 6, 'tilt_deg', 1.97, 0.6099),
  ('keyboard', 6, 'wall_offset', -0.01057, 0.3243),
  ('keyboard', 6, 'width', -1.308, 0.2158),
  ('keyboard', 6, 'z_max', 0.7368, 0.0604),
  ('keyboard', 6, 'z_min', 0.7648, 0.1072);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.04073, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'aspect', 0.8674, 0.196),
  ('keyboard', 7, 'behind', 0.1145, 0.1417),
  ('keyboard', 7, 'corner_offset', 0.5342, 0.4205),
  ('keyboard', 7, 'edge_concave', 0.005273, 0.03108),
  ('keyboard', 7, 'edge_convex', 0.006559, 0.03384),
  ('keyboard', 7, 'edge_free', 0.1663, 0.1381),
  ('keyboard', 7, 'edge_free_top', -0.0108, 0.3188),
  ('keyboard', 7, 'edge_unseen', 0.06438, 0.09573),
  ('keyboard', 7, 'headroom', 1.998, 0.3856),
  ('keyboard', 7, 'height', 1.022, 0.1209),
  ('keyboard', 7, 'lift', -3.567, 0.2037),
  ('keyboard', 7, 'rectangularity', 0.8423, 0.1784),
  ('keyboard', 7, 'spread_length', -0.9424, 0.1666),
  ('keyboard', 7, 'spread_width', -1.854, 0.05609),
  ('keyboard', 7, 'standoff', -0.007292, 0.3412),
  ('keyboard', 7, 'tilt_deg', 4.812, 0.9712),
  ('keyboard', 7, 'wall_offset', -0.03889, 0.3198),
  ('keyboard', 7, 'width', -1.837, 0.07209),
  ('keyboard', 7, 'z_max', 1.018, 0.12),
  ('keyboard', 7, 'z_min', 1.044, 0.1053);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.05488, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'aspect', 1.078, 0.08438),
  ('keyboard', 8, 'behind', 0.1834, 0.08612),
  ('keyboard', 8, 'corner_offset', 1.007, 0.6345),
  ('keyboard', 8, 'edge_concave', 0.03088, 0.0669),
  ('keyboard', 8, 'edge_convex', 0.008579, 0.03091),
  ('keyboard', 8, 'edge_free', 0.2673, 0.1674),
  ('keyboard', 8, 'edge_free_top', -0.002676, 0.3139),
  ('keyboard', 8, 'edge_unseen', 0.007793, 0.03001),
  ('keyboard', 8, 'headroom', 2.091, 0.06516),
  ('keyboard', 8, 'height', 0.7394, 0.07574),
  ('keyboard', 8, 'lift', -3.724, 0.3669),
  ('keyboard', 8, 'rectangularity', 0.9162, 0.03368),
  ('keyboard', 8, 'spread_length', -0.8154, 0.04677),
  ('keyboard', 8, 'spread_width', -1.893, 0.07496),
  ('keyboard', 8, 'standoff', -0.0003529, 0.3169),
  ('keyboard', 8, 'tilt_deg', 4.616, 1.545),
  ('keyboard', 8, 'wall_offset', -0.00497, 0.323),
  ('keyboard', 8, 'width', -1.848, 0.09182),
  ('keyboard', 8, 'z_max', 0.7457, 0.07444),
  ('keyboard', 8, 'z_min', 0.7341, 0.07591);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.04512, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'aspect', 0.8295, 0.2176),
  ('keyboard', 9, 'behind', 0.1829, 0.112),
  ('keyboard', 9, 'corner_offset', 0.8132, 0.1393),
  ('keyboard', 9, 'edge_concave', 0.0001326, 0.03002),
  ('keyboard', 9, 'edge_convex', 0.2744, 0.09427),
  ('keyboard', 9, 'edge_free', 0.2913, 0.1584),
  ('keyboard', 9, 'edge_free_top', -0.002702, 0.3126),
  ('keyboard', 9, 'edge_unseen', 0.1043, 0.1538),
  ('keyboard', 9, 'headroom', 1.896, 0.1515),
  ('keyboard', 9, 'height', 0.7438, 0.04587),
  ('keyboard', 9, 'lift', -3.617, 0.1034),
  ('keyboard', 9, 'rectangularity', 0.7949, 0.08569),
  ('keyboard', 9, 'spread_length', -0.9632, 0.1865),
  ('keyboard', 9, 'spread_width', -1.875, 0.1041),
  ('keyboard', 9, 'standoff', -0.0001749, 0.3189),
  ('keyboard', 9, 'tilt_deg', 4.414, 1.066),
  ('keyboard', 9, 'wall_offset', -0.008612, 0.3201),
  ('keyboard', 9, 'width', -1.696, 0.07357),
  ('keyboard', 9, 'z_max', 0.7486, 0.04346),
  ('keyboard', 9, 'z_min', 0.7381, 0.04663);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.01969, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'aspect', 1.076, 0.239),
  ('keyboard', 10, 'behind', 0.0972, 0.0885),
  ('keyboard', 10, 'corner_offset', 0.7995, 0.1401),
  ('keyboard', 10, 'edge_concave', 0.0009905, 0.03009),
  ('keyboard', 10, 'edge_convex', 0.003694, 0.03057),
  ('keyboard', 10, 'edge_free', 0.1103, 0.1275),
  ('keyboard', 10, 'edge_free_top', -0.0003591, 0.3225),
  ('keyboard', 10, 'edge_unseen', 0.1271, 0.1769),
  ('keyboard', 10, 'headroom', 1.95, 0.06391),
  ('keyboard', 10, 'height', 0.1167, 0.09171),
  ('keyboard', 10, 'lift', -3.586, 0.08156),
  ('keyboard', 10, 'rectangularity', 0.9169, 0.04343),
  ('keyboard', 10, 'spread_length', -0.8907, 0.2516),
  ('keyboard', 10, 'spread_width', -1.965, 0.04414),
  ('keyboard', 10, 'standoff', -0.0003764, 0.3172),
  ('keyboard', 10, 'tilt_deg', 2.334, 1.166),
  ('keyboard', 10, 'wall_offset', -0.06581, 0.2858),
  ('keyboard', 10, 'width', -1.913, 0.06216),
  ('keyboard', 10, 'z_max', 0.1025, 0.07625),
  ('keyboard', 10, 'z_min', 0.1229, 0.07663);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 11, 0.08258, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 11, 'aspect', 0.8108, 0.2025),
  ('keyboard', 11, 'behind', 0.2962, 0.0852),
  ('keyboard', 11, 'corner_offset', 0.8432, 0.1406),
  ('keyboard', 11, 'edge_concave', 0.0004989, 0.03),
  ('keyboard', 11, 'edge_convex', 0.0009745, 0.0307),
  ('keyboard', 11, 'edge_free', 0.3172, 0.131),
  ('keyboard', 11, 'edge_free_top', -0.00291, 0.3117),
  ('keyboard', 11, 'edge_unseen', 0.001865, 0.03092),
  ('keyboard', 11, 'headroom', 1.951, 0.1977),
  ('keyboard', 11, 'height', 0.7854, 0.0225),
  ('keyboard', 11, 'lift', -3.57, 0.08856),
  ('keyboard', 11, 'rectangularity', 0.8048, 0.03457),
  ('keyboard', 11, 'spread_length', -0.8061, 0.05902),
  ('keyboard', 11, 'spread_width', -1.8, 0.07582),
  ('keyboard', 11, 'standoff', -0.0009054, 0.3164),
  ('keyboard', 11, 'tilt_deg', 4.061, 1.537),
  ('keyboard', 11, 'wall_offset', -0.005227, 0.3163),
  ('keyboard', 11, 'width', -1.552, 0.1322),
  ('keyboard', 11, 'z_max', 0.7931, 0.0225),
  ('keyboard', 11, 'z_min', 0.7798, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 12, 0.05223, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 12, 'aspect', 0.6812, 0.1124),
  ('keyboard', 12, 'behind', 0.1983, 0.0792),
  ('keyboard', 12, 'corner_offset', 0.7768, 0.844),
  ('keyboard', 12, 'edge_concave', 0.0002954, 0.03332),
  ('keyboard', 12, 'edge_convex', 0.1519, 0.1518),
  ('keyboard', 12, 'edge_free', 0.4033, 0.1245),
  ('keyboard', 12, 'edge_free_top', -0.0009228, 0.3136),
  ('keyboard', 12, 'edge_unseen', 0.001101, 0.03),
  ('keyboard', 12, 'headroom', 1.941, 0.1864),
  ('keyboard', 12, 'height', 0.7347, 0.02251),
  ('keyboard', 12, 'lift', -3.583, 0.1066),
  ('keyboard', 12, 'rectangularity', 0.8102, 0.07029),
  ('keyboard', 12, 'spread_length', -0.941, 0.1395),
  ('keyboard', 12, 'spread_width', -1.8, 0.06588),
  ('keyboard', 12, 'standoff', -0.001071, 0.3182),
  ('keyboard', 12, 'tilt_deg', 5.265, 1.04),
  ('keyboard', 12, 'wall_offset', -0.004556, 0.3264),
  ('keyboard', 12, 'width', -1.52, 0.18),
  ('keyboard', 12, 'z_max', 0.7418, 0.0225),
  ('keyboard', 12, 'z_min', 0.7196, 0.02251);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 13, 0.03294, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 13, 'aspect', 0.8966, 0.2857),
  ('keyboard', 13, 'behind', 0.04329, 0.1238),
  ('keyboard', 13, 'corner_offset', 1.268, 0.545),
  ('keyboard', 13, 'edge_concave', -0.001485, 0.03),
  ('keyboard', 13, 'edge_convex', 0.004667, 0.03509),
  ('keyboard', 13, 'edge_free', 0.1648, 0.1703),
  ('keyboard', 13, 'edge_free_top', -0.002225, 0.3145),
  ('keyboard', 13, 'edge_unseen', 0.2258, 0.2006),
  ('keyboard', 13, 'headroom', 1.855, 0.292),
  ('keyboard', 13, 'height', 0.7657, 0.0225),
  ('keyboard', 13, 'lift', -3.642, 0.07882),
  ('keyboard', 13, 'rectangularity', 0.7741, 0.03),
  ('keyboard', 13, 'spread_length', -1.282, 0.3485),
  ('keyboard', 13, 'spread_width', -2.072, 0.07592),
  ('keyboard', 13, 'standoff', -0.0004194, 0.3212),
  ('keyboard', 13, 'tilt_deg', 3.908, 1.669),
  ('keyboard', 13, 'wall_offset', -0.005778, 0.3233),
  ('keyboard', 13, 'width', -1.834, 0.04922),
  ('keyboard', 13, 'z_max', 0.7657, 0.03586),
  ('keyboard', 13, 'z_min', 0.7657, 0.04174);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 14, 0.06346, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 14, 'aspect', 0.9964, 0.1166),
  ('keyboard', 14, 'behind', 0.1808, 0.1441),
  ('keyboard', 14, 'corner_offset', 1.006, 0.3057),
  ('keyboard', 14, 'edge_concave', 0.001763, 0.03294),
  ('keyboard', 14, 'edge_convex', 0.01897, 0.05248),
  ('keyboard', 14, 'edge_free', 0.2544, 0.1414),
  ('keyboard', 14, 'edge_free_top', -0.0006711, 0.3141),
  ('keyboard', 14, 'edge_unseen', 0.007979, 0.03186),
  ('keyboard', 14, 'headroom', 2.138, 0.1468),
  ('keyboard', 14, 'height', 0.7225, 0.03455),
  ('keyboard', 14, 'lift', -3.628, 0.1432),
  ('keyboard', 14, 'rectangularity', 0.8876, 0.03889),
  ('keyboard', 14, 'spread_length', -0.8152, 0.05312),
  ('keyboard', 14, 'spread_width', -1.875, 0.08508),
  ('keyboard', 14, 'standoff', -0.0007323, 0.3236),
  ('keyboard', 14, 'tilt_deg', 3.749, 1.337),
  ('keyboard', 14, 'wall_offset', -0.004218, 0.3324),
  ('keyboard', 14, 'width', -1.744, 0.07116),
  ('keyboard', 14, 'z_max', 0.7282, 0.03189),
  ('keyboard', 14, 'z_min', 0.7175, 0.03542);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 15, 0.05587, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 15, 'aspect', 0.9253, 0.2183),
  ('keyboard', 15, 'behind', 0.2009, 0.06493),
  ('keyboard', 15, 'corner_offset', 0.9556, 0.3104),
  ('keyboard', 15, 'edge_concave', 0.001106, 0.03515),
  ('keyboard', 15, 'edge_convex', 0.00775, 0.03961),
  ('keyboard', 15, 'edge_free', 0.1784, 0.18),
  ('keyboard', 15, 'edge_free_top', -0.000383, 0.3156),
  ('keyboard', 15, 'edge_unseen', 0.003839, 0.03002),
  ('keyboard', 15, 'headroom', 1.934, 0.1582),
  ('keyboard', 15, 'height', 0.8155, 0.03092),
  ('keyboard', 15, 'lift', -3.876, 0.3723),
  ('keyboard', 15, 'rectangularity', 0.9079, 0.04023),
  ('keyboard', 15, 'spread_length', -0.9124, 0.1462),
  ('keyboard', 15, 'spread_width', -1.852, 0.06532),
  ('keyboard', 15, 'standoff', -0.001846, 0.3351),
  ('keyboard', 15, 'tilt_deg', 3.994, 1.537),
  ('keyboard', 15, 'wall_offset', -0.004743, 0.3293),
  ('keyboard', 15, 'width', -1.809, 0.06933),
  ('keyboard', 15, 'z_max', 0.8247, 0.02767),
  ('keyboard', 15, 'z_min', 0.8162, 0.03181);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 16, 0.03626, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 16, 'aspect', 0.7859, 0.1674),
  ('keyboard', 16, 'behind', 0.3355, 0.06565),
  ('keyboard', 16, 'corner_offset', 0.7101, 0.2605),
  ('keyboard', 16, 'edge_concave', -0.0005018, 0.0354),
  ('keyboard', 16, 'edge_convex', -0.007521, 0.03001),
  ('keyboard', 16, 'edge_free', 0.02703, 0.03913),
  ('keyboard', 16, 'edge_free_top', -0.0008343, 0.3151),
  ('keyboard', 16, 'edge_unseen', 0.001986, 0.03098),
  ('keyboard', 16, 'headroom', 1.963, 0.2489),
  ('keyboard', 16, 'height', 0.7276, 0.04591),
  ('keyboard', 16, 'lift', -3.689, 0.08213),
  ('keyboard', 16, 'rectangularity', 0.843, 0.05908),
  ('keyboard', 16, 'spread_length', -0.895, 0.1389),
  ('keyboard', 16, 'spread_width', -1.799, 0.05906),
  ('keyboard', 16, 'standoff', -0.00078, 0.3197),
  ('keyboard', 16, 'tilt_deg', 1.781, 0.45),
  ('keyboard', 16, 'wall_offset', -0.0024, 0.3111),
  ('keyboard', 16, 'width', -1.606, 0.1252),
  ('keyboard', 16, 'z_max', 0.7271, 0.04621),
  ('keyboard', 16, 'z_min', 0.7291, 0.04572);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 17, 0.04869, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 17, 'aspect', 0.4197, 0.1791),
  ('keyboard', 17, 'behind', 0.2905, 0.08521),
  ('keyboard', 17, 'corner_offset', 0.7493, 0.1199),
  ('keyboard', 17, 'edge_concave', 0.171, 0.05347),
  ('keyboard', 17, 'edge_convex', 0.002062, 0.03078),
  ('keyboard', 17, 'edge_free', 0.197, 0.1149),
  ('keyboard', 17, 'edge_free_top', -0.0005906, 0.3157),
  ('keyboard', 17, 'edge_unseen', 0.05656, 0.08046),
  ('keyboard', 17, 'headroom', 1.908, 0.1793),
  ('keyboard', 17, 'height', 0.7958, 0.05764),
  ('keyboard', 17, 'lift', -3.596, 0.09227),
  ('keyboard', 17, 'rectangularity', 0.7552, 0.03002),
  ('keyboard', 17, 'spread_length', -1.011, 0.1251),
  ('keyboard', 17, 'spread_width', -1.839, 0.1595),
  ('keyboard', 17, 'standoff', -0.001008, 0.3179),
  ('keyboard', 17, 'tilt_deg', 4.175, 1.863),
  ('keyboard', 17, 'wall_offset', -0.009774, 0.306),
  ('keyboard', 17, 'width', -1.435, 0.3461),
  ('keyboard', 17, 'z_max', 0.7922, 0.03715),
  ('keyboard', 17, 'z_min', 0.7916, 0.05879);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 18, 0.03139, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 18, 'aspect', 0.2094, 0.1965),
  ('keyboard', 18, 'behind', 0.3081, 0.06948),
  ('keyboard', 18, 'corner_offset', 0.7597, 0.7139),
  ('keyboard', 18, 'edge_concave', 0.008751, 0.04976),
  ('keyboard', 18, 'edge_convex', 0.001025, 0.05866),
  ('keyboard', 18, 'edge_free', 0.1902, 0.06076),
  ('keyboard', 18, 'edge_free_top', -0.0005294, 0.3155),
  ('keyboard', 18, 'edge_unseen', 0.07697, 0.1258),
  ('keyboard', 18, 'headroom', 2.176, 0.34),
  ('keyboard', 18, 'height', 0.7393, 0.03042),
  ('keyboard', 18, 'lift', -3.675, 0.07355),
  ('keyboard', 18, 'rectangularity', 0.7482, 0.06323),
  ('keyboard', 18, 'spread_length', -1.301, 0.2298),
  ('keyboard', 18, 'spread_width', -1.794, 0.05751),
  ('keyboard', 18, 'standoff', -0.000885, 0.317),
  ('keyboard', 18, 'tilt_deg', 2.392, 0.6424),
  ('keyboard', 18, 'wall_offset', -0.003675, 0.3118),
  ('keyboard', 18, 'width', -1.512, 0.1714),
  ('keyboard', 18, 'z_max', 0.7442, 0.02719),
  ('keyboard', 18, 'z_min', 0.7381, 0.03364);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 19, 0.04881, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 19, 'aspect', 0.9141, 0.275),
  ('keyboard', 19, 'behind', 0.321, 0.1054),
  ('keyboard', 19, 'corner_offset', 0.9737, 0.3956),
  ('keyboard', 19, 'edge_concave', 0.006046, 0.0314),
  ('keyboard', 19, 'edge_convex', 0.006229, 0.03),
  ('keyboard', 19, 'edge_free', 0.2844, 0.1889),
  ('keyboard', 19, 'edge_free_top', -0.02713, 0.2904),
  ('keyboard', 19, 'edge_unseen', 0.004888, 0.03001),
  ('keyboard', 19, 'headroom', 1.654, 0.2024),
  ('keyboard', 19, 'height', 1.007, 0.1178),
  ('keyboard', 19, 'lift', -3.586, 0.1063),
  ('keyboard', 19, 'rectangularity', 0.8134, 0.1038),
  ('keyboard', 19, 'spread_length', -0.757, 0.1037),
  ('keyboard', 19, 'spread_width', -1.875, 0.07143),
  ('keyboard', 19, 'standoff', -0.01377, 0.3462),
  ('keyboard', 19, 'tilt_deg', 3.292, 1.264),
  ('keyboard', 19, 'wall_offset', -0.1039, 0.3087),
  ('keyboard', 19, 'width', -1.777, 0.1583),
  ('keyboard', 19, 'z_max', 0.9899, 0.105),
  ('keyboard', 19, 'z_min', 1.049, 0.1173);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 20, 0.02277, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 20, 'aspect', 0.8497, 0.3718),
  ('keyboard', 20, 'behind', 0.1089, 0.06646),
  ('keyboard', 20, 'corner_offset', 0.5678, 0.07824),
  ('keyboard', 20, 'edge_concave', 0.001411, 0.03011),
  ('keyboard', 20, 'edge_convex', 0.003318, 0.03099),
  ('keyboard', 20, 'edge_free', 0.3094, 0.1385),
  ('keyboard', 20, 'edge_free_top', -0.009464, 0.3078),
  ('keyboard', 20, 'edge_unseen', 0.1472, 0.1471),
  ('keyboard', 20, 'headroom', 1.946, 0.06573),
  ('keyboard', 20, 'height', 0.262, 0.2442),
  ('keyboard', 20, 'lift', -3.66, 0.06673),
  ('keyboard', 20, 'rectangularity', 0.8975, 0.097),
  ('keyboard', 20, 'spread_length', -1.257, 0.6201),
  ('keyboard', 20, 'spread_width', -2.109, 0.2376),
  ('keyboard', 20, 'standoff', -0.002152, 0.3187),
  ('keyboard', 20, 'tilt_deg', 4.368, 1.55),
  ('keyboard', 20, 'wall_offset', -0.01095, 0.3437),
  ('keyboard', 20, 'width', -1.996, 0.1154),
  ('keyboard', 20, 'z_max', 0.1348, 0.1052),
  ('keyboard', 20, 'z_min', 0.2653, 0.2406);

-- chair_seat: 1001 examples
UPDATE object_class SET prior = 0.01382 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.298, 0.2903)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6603, 0.1674)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'corner_offset', 0.9999, 0.4581)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_concave', 0.2213, 0.1816)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_convex', 0.03639, 0.09852)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.6186, 0.1981)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_unseen', 0.0515, 0.113)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'headroom', 1.957, 0.7862)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4698, 0.0303)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7471, 0.1276)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7869, 0.2054)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.222, 0.3917)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 0.7051, 0.8043)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.019, 0.373)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4724, 0.0304)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4674, 0.03044)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_seat';
DELETE FROM class_density WHERE class = 'chair_seat';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.07234, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'aspect', 0.133, 0.1161),
  ('chair_seat', 1, 'behind', 0.7308, 0.0871),
  ('chair_seat', 1, 'corner_offset', 1.198, 0.2888),
  ('chair_seat', 1, 'edge_concave', 0.211, 0.1648),
  ('chair_seat', 1, 'edge_convex', -0.0001728, 0.03),
  ('chair_seat', 1, 'edge_free', 0.6696, 0.156),
  ('chair_seat', 1, 'edge_free_top', -0.0002474, 0.3151),
  ('chair_seat', 1, 'edge_unseen', 0.0037, 0.03001),
  ('chair_seat', 1, 'headroom', 2.269, 0.2141),
  ('chair_seat', 1, 'height', 0.448, 0.0225),
  ('chair_seat', 1, 'lift', -1.057, 0.03116),
  ('chair_seat', 1, 'rectangularity', 0.8015, 0.09559),
  ('chair_seat', 1, 'spread_length', -0.703, 0.0518),
  ('chair_seat', 1, 'spread_width', -0.9675, 0.1086),
  ('chair_seat', 1, 'standoff', -0.000605, 0.3161),
  ('chair_seat', 1, 'tilt_deg', 0.4102, 0.45),
  ('chair_seat', 1, 'wall_offset', -0.004453, 0.3132),
  ('chair_seat', 1, 'width', -0.8054, 0.06977),
  ('chair_seat', 1, 'z_max', 0.45, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4464, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.08363, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'aspect', 0.1262, 0.1001),
  ('chair_seat', 2, 'behind', 0.6508, 0.1026),
  ('chair_seat', 2, 'corner_offset', 1.118, 0.2194),
  ('chair_seat', 2, 'edge_concave', 0.2985, 0.1154),
  ('chair_seat', 2, 'edge_convex', 0.001157, 0.03),
  ('chair_seat', 2, 'edge_free', 0.6738, 0.1254),
  ('chair_seat', 2, 'edge_free_top', -0.000484, 0.3146),
  ('chair_seat', 2, 'edge_unseen', 0.005131, 0.03281),
  ('chair_seat', 2, 'headroom', 2.237, 0.2606),
  ('chair_seat', 2, 'height', 0.5011, 0.02253),
  ('chair_seat', 2, 'lift', -0.985, 0.03112),
  ('chair_seat', 2, 'rectangularity', 0.7291, 0.1475),
  ('chair_seat', 2, 'spread_length', -0.7046, 0.08347),
  ('chair_seat', 2, 'spread_width', -1.025, 0.168),
  ('chair_seat', 2, 'standoff', -0.001408, 0.3154),
  ('chair_seat', 2, 'tilt_deg', 0.4558, 0.45),
  ('chair_seat', 2, 'wall_offset', -0.005424, 0.3144),
  ('chair_seat', 2, 'width', -0.8148, 0.09842),
  ('chair_seat', 2, 'z_max', 0.504, 0.02254),
  ('chair_seat', 2, 'z_min', 0.4988, 0.02251);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.06542, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'aspect', 0.5998, 0.2852),
  ('chair_seat', 3, 'behind', 0.74, 0.137),
  ('chair_seat', 3, 'corner_offset', 0.981, 0.1266),
  ('chair_seat', 3, 'edge_concave', 0.1949, 0.1638),
  ('chair_seat', 3, 'edge_convex', 0.001686, 0.03),
  ('chair_seat', 3, 'edge_free', 0.4605, 0.1226),
  ('chair_seat', 3, 'edge_free_top', -0.001414, 0.3141),
  ('chair_seat', 3, 'edge_unseen', 0.008677, 0.03),
  ('chair_seat', 3, 'headroom', 2.232, 0.4942),
  ('chair_seat', 3, 'height', 0.4602, 0.02253),
  ('chair_seat', 3, 'lift', -1.019, 0.03107),
  ('chair_seat', 3, 'rectangularity', 0.6181, 0.1249),
  ('chair_seat', 3, 'spread_length', -0.7637, 0.1096),
  ('chair_seat', 3, 'spread_width', -1.491, 0.3582),
  ('chair_seat', 3, 'standoff', -0.00285, 0.3166),
  ('chair_seat', 3, 'tilt_deg', 0.8241, 0.6686),
  ('chair_seat', 3, 'wall_offset', -0.007849, 0.315),
  ('chair_seat', 3, 'width', -1.196, 0.2539),
  ('chair_seat', 3, 'z_max', 0.4644, 0.02252),
  ('chair_seat', 3, 'z_min', 0.4578, 0.02253);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.0627, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'aspect', 0.5958, 0.2044),
  ('chair_seat', 4, 'behind', 0.6155, 0.2021),
  ('chair_seat', 4, 'corner_offset', 1.107, 0.4922),
  ('chair_seat', 4, 'edge_concave', 0.2222, 0.2336),
  ('chair_seat', 4, 'edge_convex', 0.000605, 0.03),
  ('chair_seat', 4, 'edge_free', 0.5909, 0.1132),
  ('chair_seat', 4, 'edge_free_top', -0.001194, 0.3139),
  ('chair_seat', 4, 'edge_unseen', 0.1358, 0.1496),
  ('chair_seat', 4, 'headroom', 2.21, 0.2303),
  ('chair_seat', 4, 'height', 0.4991, 0.0225),
  ('chair_seat', 4, 'lift', -1.019, 0.03107),
  ('chair_seat', 4, 'rectangularity', 0.7422, 0.07394),
  ('chair_seat', 4, 'spread_length', -0.7332, 0.09119),
  ('chair_seat', 4, 'spread_width', -1.551, 0.1989),
  ('chair_seat', 4, 'standoff', -0.001455, 0.3165),
  ('chair_seat', 4, 'tilt_deg', 0.6423, 0.451),
  ('chair_seat', 4, 'wall_offset', -0.008993, 0.3154),
  ('chair_seat', 4, 'width', -1.306, 0.2364),
  ('chair_seat', 4, 'z_max', 0.5005, 0.0225),
  ('chair_seat', 4, 'z_min', 0.4985, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.02082, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'aspect', 0.137, 0.0827),
  ('chair_seat', 5, 'behind', 0.675, 0.1074),
  ('chair_seat', 5, 'corner_offset', 1.114, 0.2159),
  ('chair_seat', 5, 'edge_concave', 0.1891, 0.1549),
  ('chair_seat', 5, 'edge_convex', 0.2588, 0.08368),
  ('chair_seat', 5, 'edge_free', 0.696, 0.1474),
  ('chair_seat', 5, 'edge_free_top', -0.0005686, 0.3156),
  ('chair_seat', 5, 'edge_unseen', 0.005523, 0.03046),
  ('chair_seat', 5, 'headroom', 2.284, 0.2652),
  ('chair_seat', 5, 'height', 0.4728, 0.02923),
  ('chair_seat', 5, 'lift', -1.019, 0.03109),
  ('chair_seat', 5, 'rectangularity', 0.7451, 0.1358),
  ('chair_seat', 5, 'spread_length', -0.7278, 0.09074),
  ('chair_seat', 5, 'spread_width', -1.042, 0.1402),
  ('chair_seat', 5, 'standoff', -8.393e-05, 0.3162),
  ('chair_seat', 5, 'tilt_deg', 0.3869, 0.45),
  ('chair_seat', 5, 'wall_offset', -0.001269, 0.3151),
  ('chair_seat', 5, 'width', -0.8319, 0.08331),
  ('chair_seat', 5, 'z_max', 0.4746, 0.02964),
  ('chair_seat', 5, 'z_min', 0.4711, 0.02852);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.02263, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'aspect', 0.08772, 0.05232),
  ('chair_seat', 6, 'behind', 0.7508, 0.07458),
  ('chair_seat', 6, 'corner_offset', 1.136, 0.3759),
  ('chair_seat', 6, 'edge_concave', 0.1939, 0.1414),
  ('chair_seat', 6, 'edge_convex', 0.01379, 0.04682),
  ('chair_seat', 6, 'edge_free', 0.6087, 0.1295),
  ('chair_seat', 6, 'edge_free_top', 1.725e-05, 0.3162),
  ('chair_seat', 6, 'edge_unseen', 0.07926, 0.1116),
  ('chair_seat', 6, 'headroom', 0.366, 0.1777),
  ('chair_seat', 6, 'height', 0.4738, 0.02252),
  ('chair_seat', 6, 'lift', -1.02, 0.03111),
  ('chair_seat', 6, 'rectangularity', 0.7759, 0.096),
  ('chair_seat', 6, 'spread_length', -0.7532, 0.07118),
  ('chair_seat', 6, 'spread_width', -1.027, 0.1144),
  ('chair_seat', 6, 'standoff', -0.0002694, 0.3161),
  ('chair_seat', 6, 'tilt_deg', 0.4351, 0.45),
  ('chair_seat', 6, 'wall_offset', -0.000776, 0.3155),
  ('chair_seat', 6, 'width', -0.8011, 0.07803),
  ('chair_seat', 6, 'z_max', 0.4761, 0.02251),
  ('chair_seat', 6, 'z_min', 0.4731, 0.02252);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.1105, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'aspect', 0.7097, 0.2042),
  ('chair_seat', 7, 'behind', 0.4181, 0.3068),
  ('chair_seat', 7, 'corner_offset', 1.017, 0.2094),
  ('chair_seat', 7, 'edge_concave', 0.2009, 0.2713),
  ('chair_seat', 7, 'edge_convex', 0.0004428, 0.03),
  ('chair_seat', 7, 'edge_free', 0.5246, 0.163),
  ('chair_seat', 7, 'edge_free_top', -0.007706, 0.3111),
  ('chair_seat', 7, 'edge_unseen', 0.1555, 0.143),
  ('chair_seat', 7, 'headroom', 2.162, 0.3981),
  ('chair_seat', 7, 'height', 0.4974, 0.02408),
  ('chair_seat', 7, 'lift', -1.016, 0.03107),
  ('chair_seat', 7, 'rectangularity', 0.6832, 0.09046),
  ('chair_seat', 7, 'spread_length', -1.112, 0.219),
  ('chair_seat', 7, 'spread_width', -2, 0.2312),
  ('chair_seat', 7, 'standoff', -0.006911, 0.3229),
  ('chair_seat', 7, 'tilt_deg', 1.414, 1.079),
  ('chair_seat', 7, 'wall_offset', -0.01896, 0.3173),
  ('chair_seat', 7, 'width', -1.768, 0.239),
  ('chair_seat', 7, 'z_max', 0.4969, 0.02251),
  ('chair_seat', 7, 'z_min', 0.4965, 0.02584);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.0256, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'aspect', 0.3513, 0.1242),
  ('chair_seat', 8, 'behind', 0.2543, 0.2075),
  ('chair_seat', 8, 'corner_offset', 1.07, 0.1588),
  ('chair_seat', 8, 'edge_concave', 0.1605, 0.208),
  ('chair_seat', 8, 'edge_convex', 0.001071, 0.03),
  ('chair_seat', 8, 'edge_free', 0.6032, 0.2765),
  ('chair_seat', 8, 'edge_free_top', -0.000967, 0.3151),
  ('chair_seat', 8, 'edge_unseen', 0.2452, 0.2294),
  ('chair_seat', 8, 'headroom', 1.667, 0.3338),
  ('chair_seat', 8, 'height', 0.4277, 0.02593),
  ('chair_seat', 8, 'lift', -1.02, 0.03107),
  ('chair_seat', 8, 'rectangularity', 0.7003, 0.05387),
  ('chair_seat', 8, 'spread_length', -1.239, 0.3221),
  ('chair_seat', 8, 'spread_width', -1.83, 0.2884),
  ('chair_seat', 8, 'standoff', -0.001178, 0.316),
  ('chair_seat', 8, 'tilt_deg', 2.497, 1.744),
  ('chair_seat', 8, 'wall_offset', -0.003681, 0.3188),
  ('chair_seat', 8, 'width', -1.602, 0.2201),
  ('chair_seat', 8, 'z_max', 0.4308, 0.02617),
  ('chair_seat', 8, 'z_min', 0.4224, 0.02543);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.0114, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'aspect', 0.3519, 0.2161),
  ('chair_seat', 9, 'behind', 0.5124, 0.06682),
  ('chair_seat', 9, 'corner_offset', 1.105, 0.1862),
  ('chair_seat', 9, 'edge_concave', 0.05229, 0.08468),
  ('chair_seat', 9, 'edge_convex', 0.2256, 0.1344),
  ('chair_seat', 9, 'edge_free', 0.4262, 0.1108),
  ('chair_seat', 9, 'edge_free_top', -0.001178, 0.3149),
  ('chair_seat', 9, 'edge_unseen', 0.07121, 0.087),
  ('chair_seat', 9, 'headroom', 0.9502, 0.8419),
  ('chair_seat', 9, 'height', 0.4678, 0.1023),
  ('chair_seat', 9, 'lift', -1.02, 0.03107),
  ('chair_seat', 9, 'rectangularity', 0.773, 0.03765),
  ('chair_seat', 9, 'spread_length', -0.8742, 0.137),
  ('chair_seat', 9, 'spread_width', -1.361, 0.2062),
  ('chair_seat', 9, 'standoff', -0.003435, 0.3133),
  ('chair_seat', 9, 'tilt_deg', 1.206, 0.7433),
  ('chair_seat', 9, 'wall_offset', -0.008176, 0.3131),
  ('chair_seat', 9, 'width', -1.174, 0.1987),
  ('chair_seat', 9, 'z_max', 0.4724, 0.08977),
  ('chair_seat', 9, 'z_min', 0.472, 0.08383);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 10, 0.04429, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 10, 'aspect', 0.1052, 0.1024),
  ('chair_seat', 10, 'behind', 0.6457, 0.07448),
  ('chair_seat', 10, 'corner_offset', 1.135, 0.3373),
  ('chair_seat', 10, 'edge_concave', 0.2315, 0.1302),
  ('chair_seat', 10, 'edge_convex', 0.0003668, 0.03003),
  ('chair_seat', 10, 'edge_free', 0.7668, 0.1246),
  ('chair_seat', 10, 'edge_free_top', -0.0002446, 0.3153),
  ('chair_seat', 10, 'edge_unseen', 0.002159, 0.03025),
  ('chair_seat', 10, 'headroom', 2.264, 0.2458),
  ('chair_seat', 10, 'height', 0.4905, 0.02254),
  ('chair_seat', 10, 'lift', -0.8885, 0.03107),
  ('chair_seat', 10, 'rectangularity', 0.8583, 0.04805),
  ('chair_seat', 10, 'spread_length', -0.7342, 0.06313),
  ('chair_seat', 10, 'spread_width', -0.9105, 0.07817),
  ('chair_seat', 10, 'standoff', -0.0004548, 0.3158),
  ('chair_seat', 10, 'tilt_deg', 0.3905, 0.4527),
  ('chair_seat', 10, 'wall_offset', -0.005235, 0.3126),
  ('chair_seat', 10, 'width', -0.7874, 0.06682),
  ('chair_seat', 10, 'z_max', 0.4931, 0.02307),
  ('chair_seat', 10, 'z_min', 0.4888, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 11, 0.08516, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 11, 'aspect', 0.1213, 0.1055),
  ('chair_seat', 11, 'behind', 0.7232, 0.08842),
  ('chair_seat', 11, 'corner_offset', 1.039, 0.2071),
  ('chair_seat', 11, 'edge_concave', 0.24, 0.1504),
  ('chair_seat', 11, 'edge_convex', 0.001383, 0.03),
  ('chair_seat', 11, 'edge_free', 0.6468, 0.1129),
  ('chair_seat', 11, 'edge_free_top', -0.001907, 0.314),
  ('chair_seat', 11, 'edge_unseen', 0.002952, 0.03),
  ('chair_seat', 11, 'headroom', 2.015, 0.4942),
  ('chair_seat', 11, 'height', 0.4405, 0.0225),
  ('chair_seat', 11, 'lift', -0.8894, 0.03108),
  ('chair_seat', 11, 'rectangularity', 0.7898, 0.1049),
  ('chair_seat', 11, 'spread_length', -0.7191, 0.06453),
  ('chair_seat', 11, 'spread_width', -0.9705, 0.1193),
  ('chair_seat', 11, 'standoff', -0.0003869, 0.3162),
  ('chair_seat', 11, 'tilt_deg', 0.4725, 0.4785),
  ('chair_seat', 11, 'wall_offset', -0.01185, 0.3094),
  ('chair_seat', 11, 'width', -0.7779, 0.08897),
  ('chair_seat', 11, 'z_max', 0.443, 0.0225),
  ('chair_seat', 11, 'z_min', 0.4388, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 12, 0.06425, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 12, 'aspect', 0.2076, 0.149),
  ('chair_seat', 12, 'behind', 0.7194, 0.07565),
  ('chair_seat', 12, 'corner_offset', 1.115, 0.2044),
  ('chair_seat', 12, 'edge_concave', 0.2408, 0.1336),
  ('chair_seat', 12, 'edge_convex', 0.002296, 0.03),
  ('chair_seat', 12, 'edge_free', 0.5777, 0.115),
  ('chair_seat', 12, 'edge_free_top', -0.002354, 0.3159),
  ('chair_seat', 12, 'edge_unseen', 0.005042, 0.03001),
  ('chair_seat', 12, 'headroom', 2.206, 0.1962),
  ('chair_seat', 12, 'height', 0.4777, 0.02473),
  ('chair_seat', 12, 'lift', -0.9065, 0.03107),
  ('chair_seat', 12, 'rectangularity', 0.6569, 0.1191),
  ('chair_seat', 12, 'spread_length', -0.6865, 0.07647),
  ('chair_seat', 12, 'spread_width', -1.141, 0.1449),
  ('chair_seat', 12, 'standoff', -0.0007991, 0.3162),
  ('chair_seat', 12, 'tilt_deg', 0.4106, 0.45),
  ('chair_seat', 12, 'wall_offset', -0.006042, 0.3125),
  ('chair_seat', 12, 'width', -0.8587, 0.1194),
  ('chair_seat', 12, 'z_max', 0.4798, 0.02632),
  ('chair_seat', 12, 'z_min', 0.4753, 0.02368);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 13, 0.1181, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 13, 'aspect', 0.5703, 0.474),
  ('chair_seat', 13, 'behind', 0.2447, 0.1771),
  ('chair_seat', 13, 'corner_offset', 1.525, 0.8679),
  ('chair_seat', 13, 'edge_concave', 0.1407, 0.2089),
  ('chair_seat', 13, 'edge_convex', -6.926e-06, 0.03),
  ('chair_seat', 13, 'edge_free', 0.6211, 0.2546),
  ('chair_seat', 13, 'edge_free_top', -0.02141, 0.3009),
  ('chair_seat', 13, 'edge_unseen', 0.2175, 0.1306),
  ('chair_seat', 13, 'headroom', 1.596, 0.3051),
  ('chair_seat', 13, 'height', 0.4798, 0.03442),
  ('chair_seat', 13, 'lift', -0.8877, 0.03107),
  ('chair_seat', 13, 'rectangularity', 0.6746, 0.1093),
  ('chair_seat', 13, 'spread_length', -1.188, 0.2341),
  ('chair_seat', 13, 'spread_width', -1.77, 0.1866),
  ('chair_seat', 13, 'standoff', -0.01005, 0.3236),
  ('chair_seat', 13, 'tilt_deg', 1.946, 0.45),
  ('chair_seat', 13, 'wall_offset', -0.03224, 0.3084),
  ('chair_seat', 13, 'width', -1.554, 0.1791),
  ('chair_seat', 13, 'z_max', 0.4793, 0.03668),
  ('chair_seat', 13, 'z_min', 0.4789, 0.03359);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 14, 0.02895, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 14, 'aspect', 0.456, 0.1798),
  ('chair_seat', 14, 'behind', 0.6709, 0.1523),
  ('chair_seat', 14, 'corner_offset', 1.025, 0.1769),
  ('chair_seat', 14, 'edge_concave', 0.0806, 0.07762),
  ('chair_seat', 14, 'edge_convex', 0.1697, 0.1296),
  ('chair_seat', 14, 'edge_free', 0.5144, 0.1055),
  ('chair_seat', 14, 'edge_free_top', -0.001672, 0.318),
  ('chair_seat', 14, 'edge_unseen', 0.01698, 0.05491),
  ('chair_seat', 14, 'headroom', 1.198, 0.999),
  ('chair_seat', 14, 'height', 0.4296, 0.02696),
  ('chair_seat', 14, 'lift', -0.8896, 0.03108),
  ('chair_seat', 14, 'rectangularity', 0.6238, 0.1457),
  ('chair_seat', 14, 'spread_length', -0.442, 0.3002),
  ('chair_seat', 14, 'spread_width', -1.03, 0.1492),
  ('chair_seat', 14, 'standoff', 6.751e-05, 0.3191),
  ('chair_seat', 14, 'tilt_deg', 0.5552, 0.6099),
  ('chair_seat', 14, 'wall_offset', -0.004042, 0.3157),
  ('chair_seat', 14, 'width', -0.7905, 0.1893),
  ('chair_seat', 14, 'z_max', 0.4341, 0.024),
  ('chair_seat', 14, 'z_min', 0.4243, 0.0273);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 15, 0.0334, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 15, 'aspect', 0.8962, 0.2842),
  ('chair_seat', 15, 'behind', 0.6886, 0.0761),
  ('chair_seat', 15, 'corner_offset', 0.9759, 0.7762),
  ('chair_seat', 15, 'edge_concave', 0.1607, 0.2188),
  ('chair_seat', 15, 'edge_convex', 0.001465, 0.03),
  ('chair_seat', 15, 'edge_free', 0.4769, 0.1341),
  ('chair_seat', 15, 'edge_free_top', -0.002208, 0.3151),
  ('chair_seat', 15, 'edge_unseen', 0.003786, 0.03007),
  ('chair_seat', 15, 'headroom', 2.194, 0.2974),
  ('chair_seat', 15, 'height', 0.4632, 0.02263),
  ('chair_seat', 15, 'lift', -0.8786, 0.03107),
  ('chair_seat', 15, 'rectangularity', 0.7551, 0.1323),
  ('chair_seat', 15, 'spread_length', -0.7521, 0.04941),
  ('chair_seat', 15, 'spread_width', -1.768, 0.3034),
  ('chair_seat', 15, 'standoff', -0.001622, 0.317),
  ('chair_seat', 15, 'tilt_deg', 1.739, 1.383),
  ('chair_seat', 15, 'wall_offset', -0.008039, 0.3042),
  ('chair_seat', 15, 'width', -1.59, 0.2578),
  ('chair_seat', 15, 'z_max', 0.4614, 0.02251),
  ('chair_seat', 15, 'z_min', 0.4607, 0.02364);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 16, 0.01927, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 16, 'aspect', 0.1642, 0.1121),
  ('chair_seat', 16, 'behind', 0.5681, 0.1982),
  ('chair_seat', 16, 'corner_offset', 1.075, 0.2026),
  ('chair_seat', 16, 'edge_concave', 0.2191, 0.1603),
  ('chair_seat', 16, 'edge_convex', 0.1541, 0.1207),
  ('chair_seat', 16, 'edge_free', 0.7125, 0.1523),
  ('chair_seat', 16, 'edge_free_top', -0.0002911, 0.3163),
  ('chair_seat', 16, 'edge_unseen', 0.05712, 0.09172),
  ('chair_seat', 16, 'headroom', 2.275, 0.2525),
  ('chair_seat', 16, 'height', 0.4939, 0.0225),
  ('chair_seat', 16, 'lift', -0.8892, 0.03107),
  ('chair_seat', 16, 'rectangularity', 0.8133, 0.09024),
  ('chair_seat', 16, 'spread_length', -0.7278, 0.06133),
  ('chair_seat', 16, 'spread_width', -1.029, 0.1314),
  ('chair_seat', 16, 'standoff', -0.0003763, 0.3158),
  ('chair_seat', 16, 'tilt_deg', 0.3967, 0.4501),
  ('chair_seat', 16, 'wall_offset', -0.0014, 0.3155),
  ('chair_seat', 16, 'width', -0.8463, 0.0836),
  ('chair_seat', 16, 'z_max', 0.496, 0.0225),
  ('chair_seat', 16, 'z_min', 0.492, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 17, 0.01756, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 17, 'aspect', 0.4041, 0.1106),
  ('chair_seat', 17, 'behind', 0.6198, 0.1649),
  ('chair_seat', 17, 'corner_offset', 1.296, 0.3155),
  ('chair_seat', 17, 'edge_concave', 0.08688, 0.1326),
  ('chair_seat', 17, 'edge_convex', 0.1132, 0.1401),
  ('chair_seat', 17, 'edge_free', 0.6687, 0.2176),
  ('chair_seat', 17, 'edge_free_top', -0.001113, 0.3161),
  ('chair_seat', 17, 'edge_unseen', 0.2624, 0.09372),
  ('chair_seat', 17, 'headroom', 1.097, 0.8646),
  ('chair_seat', 17, 'height', 0.4761, 0.02256),
  ('chair_seat', 17, 'lift', -0.8892, 0.03107),
  ('chair_seat', 17, 'rectangularity', 0.7601, 0.09359),
  ('chair_seat', 17, 'spread_length', -0.8361, 0.1092),
  ('chair_seat', 17, 'spread_width', -1.278, 0.1219),
  ('chair_seat', 17, 'standoff', -0.0003399, 0.3165),
  ('chair_seat', 17, 'tilt_deg', 0.6059, 0.4893),
  ('chair_seat', 17, 'wall_offset', -0.002453, 0.3146),
  ('chair_seat', 17, 'width', -1.133, 0.1597),
  ('chair_seat', 17, 'z_max', 0.4787, 0.02252),
  ('chair_seat', 17, 'z_min', 0.4751, 0.02251);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 18, 0.01426, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 18, 'aspect', 0.1032, 0.0793),
  ('chair_seat', 18, 'behind', 0.7192, 0.08484),
  ('chair_seat', 18, 'corner_offset', 0.7904, 0.5952),
  ('chair_seat', 18, 'edge_concave', 0.1746, 0.1654),
  ('chair_seat', 18, 'edge_convex', 0.00105, 0.03002),
  ('chair_seat', 18, 'edge_free', 0.6125, 0.09546),
  ('chair_seat', 18, 'edge_free_top', -0.0003509, 0.3163),
  ('chair_seat', 18, 'edge_unseen', 0.01096, 0.03013),
  ('chair_seat', 18, 'headroom', 0.2931, 0.04837),
  ('chair_seat', 18, 'height', 0.4989, 0.0225),
  ('chair_seat', 18, 'lift', -0.8765, 0.03107),
  ('chair_seat', 18, 'rectangularity', 0.7809, 0.1093),
  ('chair_seat', 18, 'spread_length', -0.7364, 0.06408),
  ('chair_seat', 18, 'spread_width', -1.007, 0.09704),
  ('chair_seat', 18, 'standoff', -0.0004792, 0.3158),
  ('chair_seat', 18, 'tilt_deg', 0.6483, 0.6313),
  ('chair_seat', 18, 'wall_offset', -0.001181, 0.3158),
  ('chair_seat', 18, 'width', -0.8121, 0.05649),
  ('chair_seat', 18, 'z_max', 0.5026, 0.0225),
  ('chair_seat', 18, 'z_min', 0.4951, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 19, 0.04978, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 19, 'aspect', 0.6902, 0.2069),
  ('chair_seat', 19, 'behind', 0.6611, 0.1205),
  ('chair_seat', 19, 'corner_offset', 1.052, 0.2018),
  ('chair_seat', 19, 'edge_concave', 0.2672, 0.2291),
  ('chair_seat', 19, 'edge_convex', 0.001557, 0.03),
  ('chair_seat', 19, 'edge_free', 0.4237, 0.2163),
  ('chair_seat', 19, 'edge_free_top', -0.003598, 0.3145),
  ('chair_seat', 19, 'edge_unseen', 0.006791, 0.03),
  ('chair_seat', 19, 'headroom', 2.176, 0.2135),
  ('chair_seat', 19, 'height', 0.4984, 0.02364),
  ('chair_seat', 19, 'lift', -0.887, 0.03108),
  ('chair_seat', 19, 'rectangularity', 0.7284, 0.08391),
  ('chair_seat', 19, 'spread_length', -0.8273, 0.1274),
  ('chair_seat', 19, 'spread_width', -1.63, 0.1729),
  ('chair_seat', 19, 'standoff', -0.002372, 0.3168),
  ('chair_seat', 19, 'tilt_deg', 1.548, 1.72),
  ('chair_seat', 19, 'wall_offset', -0.006069, 0.3101),
  ('chair_seat', 19, 'width', -1.418, 0.2016),
  ('chair_seat', 19, 'z_max', 0.5032, 0.02903),
  ('chair_seat', 19, 'z_min', 0.4915, 0.0225);

-- chair_back: 981 examples
UPDATE object_class SET prior = 0.04386 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3898, 0.2911)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.5692, 0.2929)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'corner_offset', 1.613, 0.8587)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_concave', 0.06669, 0.1166)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_convex', 0.09116, 0.1313)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.7897, 0.1998)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9469, 0.1626)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_unseen', 0.08067, 0.1594)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'headroom', 1.736, 0.2808)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8189, 0.08037)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'lift', -4.521, 1.287)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7788, 0.1223)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.7203, 0.2403)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.142, 0.4027)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'standoff', 1.082, 0.3274)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.51, 3.834)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'wall_offset', 1.424, 0.7729)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9466, 0.35)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.024, 0.08947)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4557, 0.1611)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_back';
DELETE FROM class_density WHERE class = 'chair_back';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.05527, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'aspect', 0.4147, 0.1723),
  ('chair_back', 1, 'behind', 0.4425, 0.2825),
  ('chair_back', 1, 'corner_offset', 1.488, 0.3248),
  ('chair_back', 1, 'edge_concave', 0.00283, 0.03),
  ('chair_back', 1, 'edge_convex', 0.2098, 0.1431),
  ('chair_back', 1, 'edge_free', 0.8858, 0.08189),
  ('chair_back', 1, 'edge_free_top', 0.9987, 0.03),
  ('chair_back', 1, 'edge_unseen', 0.1133, 0.1528),
  ('chair_back', 1, 'headroom', 1.783, 0.1384),
  ('chair_back', 1, 'height', 0.8102, 0.0552),
  ('chair_back', 1, 'lift', -5.301, 0.1213),
  ('chair_back', 1, 'rectangularity', 0.7861, 0.07867),
  ('chair_back', 1, 'spread_length', -0.6045, 0.08092),
  ('chair_back', 1, 'spread_width', -1.116, 0.1952),
  ('chair_back', 1, 'standoff', 1.074, 0.2024),
  ('chair_back', 1, 'tilt_deg', 81, 2.838),
  ('chair_back', 1, 'wall_offset', 1.313, 0.3126),
  ('chair_back', 1, 'width', -0.8601, 0.07278),
  ('chair_back', 1, 'z_max', 1.023, 0.08852),
  ('chair_back', 1, 'z_min', 0.3835, 0.03997);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.03925, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'aspect', 0.382, 0.1453),
  ('chair_back', 2, 'behind', 0.5347, 0.2845),
  ('chair_back', 2, 'corner_offset', 1.806, 0.7043),
  ('chair_back', 2, 'edge_concave', 0.002226, 0.03204),
  ('chair_back', 2, 'edge_convex', 0.203, 0.1405),
  ('chair_back', 2, 'edge_free', 0.9814, 0.03147),
  ('chair_back', 2, 'edge_free_top', 0.9994, 0.03016),
  ('chair_back', 2, 'edge_unseen', 0.003831, 0.03098),
  ('chair_back', 2, 'headroom', 1.66, 0.2492),
  ('chair_back', 2, 'height', 0.8094, 0.06511),
  ('chair_back', 2, 'lift', -5.278, 0.1288),
  ('chair_back', 2, 'rectangularity', 0.9099, 0.03055),
  ('chair_back', 2, 'spread_length', -0.5597, 0.1041),
  ('chair_back', 2, 'spread_width', -0.8074, 0.08263),
  ('chair_back', 2, 'standoff', 1.263, 0.2344),
  ('chair_back', 2, 'tilt_deg', 78.89, 2.517),
  ('chair_back', 2, 'wall_offset', 1.57, 0.4018),
  ('chair_back', 2, 'width', -0.7341, 0.07519),
  ('chair_back', 2, 'z_max', 1.043, 0.08823),
  ('chair_back', 2, 'z_min', 0.3593, 0.04058);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.04373, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'aspect', 0.1945, 0.1271),
  ('chair_back', 3, 'behind', 0.7283, 0.09933),
  ('chair_back', 3, 'corner_offset', 1.656, 0.8329),
  ('chair_back', 3, 'edge_concave', 0.1947, 0.03371),
  ('chair_back', 3, 'edge_convex', 0.0009164, 0.03003),
  ('chair_back', 3, 'edge_free', 0.6198, 0.1198),
  ('chair_back', 3, 'edge_free_top', 0.9937, 0.03163),
  ('chair_back', 3, 'edge_unseen', 0.003899, 0.03386),
  ('chair_back', 3, 'headroom', 1.7, 0.4207),
  ('chair_back', 3, 'height', 0.7912, 0.06778),
  ('chair_back', 3, 'lift', -5.04, 0.5126),
  ('chair_back', 3, 'rectangularity', 0.7862, 0.07162),
  ('chair_back', 3, 'spread_length', -0.7091, 0.056),
  ('chair_back', 3, 'spread_width', -0.8417, 0.1238),
  ('chair_back', 3, 'standoff', 0.9688, 0.2606),
  ('chair_back', 3, 'tilt_deg', 80.84, 2.239),
  ('chair_back', 3, 'wall_offset', 1.598, 0.7192),
  ('chair_back', 3, 'width', -0.6834, 0.1002),
  ('chair_back', 3, 'z_max', 0.9928, 0.06828),
  ('chair_back', 3, 'z_min', 0.4129, 0.05265);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.08778, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'aspect', 0.1344, 0.1047),
  ('chair_back', 4, 'behind', 0.3845, 0.4094),
  ('chair_back', 4, 'corner_offset', 1.242, 0.4174),
  ('chair_back', 4, 'edge_concave', 0.005869, 0.03562),
  ('chair_back', 4, 'edge_convex', 0.005236, 0.03),
  ('chair_back', 4, 'edge_free', 0.7889, 0.125),
  ('chair_back', 4, 'edge_free_top', 0.9987, 0.03),
  ('chair_back', 4, 'edge_unseen', 0.04586, 0.08526),
  ('chair_back', 4, 'headroom', 1.679, 0.1794),
  ('chair_back', 4, 'height', 0.8331, 0.07459),
  ('chair_back', 4, 'lift', -2.298, 0.4246),
  ('chair_back', 4, 'rectangularity', 0.8996, 0.03407),
  ('chair_back', 4, 'spread_length', -0.7243, 0.04158),
  ('chair_back', 4, 'spread_width', -0.9888, 0.1873),
  ('chair_back', 4, 'standoff', 1.049, 0.3172),
  ('chair_back', 4, 'tilt_deg', 81.05, 2.786),
  ('chair_back', 4, 'wall_offset', 1.552, 0.6223),
  ('chair_back', 4, 'width', -0.8844, 0.09785),
  ('chair_back', 4, 'z_max', 1.006, 0.07258),
  ('chair_back', 4, 'z_min', 0.5568, 0.04133);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.04687, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'aspect', 0.7663, 0.2603),
  ('chair_back', 5, 'behind', 0.7125, 0.1119),
  ('chair_back', 5, 'corner_offset', 1.715, 0.7769),
  ('chair_back', 5, 'edge_concave', 0.1934, 0.06405),
  ('chair_back', 5, 'edge_convex', 0.02912, 0.05767),
  ('chair_back', 5, 'edge_free', 0.7942, 0.18),
  ('chair_back', 5, 'edge_free_top', 0.9912, 0.03038),
  ('chair_back', 5, 'edge_unseen', 0.003505, 0.03002),
  ('chair_back', 5, 'headroom', 1.666, 0.1831),
  ('chair_back', 5, 'height', 0.8166, 0.04915),
  ('chair_back', 5, 'lift', -4.902, 0.5758),
  ('chair_back', 5, 'rectangularity', 0.6668, 0.09463),
  ('chair_back', 5, 'spread_length', -0.5153, 0.1482),
  ('chair_back', 5, 'spread_width', -1.177, 0.3235),
  ('chair_back', 5, 'standoff', 1.231, 0.1132),
  ('chair_back', 5, 'tilt_deg', 80.54, 2.144),
  ('chair_back', 5, 'wall_offset', 1.616, 0.3149),
  ('chair_back', 5, 'width', -0.8851, 0.283),
  ('chair_back', 5, 'z_max', 1.118, 0.05333),
  ('chair_back', 5, 'z_min', 0.1852, 0.1532);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.03218, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'aspect', 0.5266, 0.3702),
  ('chair_back', 6, 'behind', 0.4144, 0.514),
  ('chair_back', 6, 'corner_offset', 1.535, 0.3801),
  ('chair_back', 6, 'edge_concave', 0.1584, 0.06441),
  ('chair_back', 6, 'edge_convex', 0.0246, 0.05832),
  ('chair_back', 6, 'edge_free', 0.4957, 0.1252),
  ('chair_back', 6, 'edge_free_top', 0.5691, 0.2964),
  ('chair_back', 6, 'edge_unseen', 0.1257, 0.1911),
  ('chair_back', 6, 'headroom', 1.77, 0.08591),
  ('chair_back', 6, 'height', 0.7995, 0.1118),
  ('chair_back', 6, 'lift', -3.685, 0.4785),
  ('chair_back', 6, 'rectangularity', 0.6093, 0.0931),
  ('chair_back', 6, 'spread_length', -0.8852, 0.1376),
  ('chair_back', 6, 'spread_width', -1.49, 0.5038),
  ('chair_back', 6, 'standoff', 1, 0.286),
  ('chair_back', 6, 'tilt_deg', 80.4, 2.445),
  ('chair_back', 6, 'wall_offset', 2.448, 5.187),
  ('chair_back', 6, 'width', -1.294, 0.3325),
  ('chair_back', 6, 'z_max', 1.051, 0.08099),
  ('chair_back', 6, 'z_min', 0.4828, 0.09393);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.06033, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'aspect', 0.3106, 0.1658),
  ('chair_back', 7, 'behind', -0.005734, 0.04762),
  ('chair_back', 7, 'corner_offset', 1.869, 3.185),
  ('chair_back', 7, 'edge_concave', 0.0001746, 0.04543),
  ('chair_back', 7, 'edge_convex', 0.001264, 0.03399),
  ('chair_back', 7, 'edge_free', 0.9567, 0.03642),
  ('chair_back', 7, 'edge_free_top', 0.9995, 0.03162),
  ('chair_back', 7, 'edge_unseen', 0.4914, 0.1139),
  ('chair_back', 7, 'headroom', 1.654, 0.0976),
  ('chair_back', 7, 'height', 0.9025, 0.1134),
  ('chair_back', 7, 'lift', -2.493, 0.1946),
  ('chair_back', 7, 'rectangularity', 0.6354, 0.04301),
  ('chair_back', 7, 'spread_length', -1.147, 0.2934),
  ('chair_back', 7, 'spread_width', -1.722, 0.3738),
  ('chair_back', 7, 'standoff', 1.104, 0.291),
  ('chair_back', 7, 'tilt_deg', 79.5, 2.541),
  ('chair_back', 7, 'wall_offset', 1.593, 0.4085),
  ('chair_back', 7, 'width', -1.376, 0.4552),
  ('chair_back', 7, 'z_max', 1.037, 0.06895),
  ('chair_back', 7, 'z_min', 0.6291, 0.1058);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.05884, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'aspect', 0.6924, 0.1891),
  ('chair_back', 8, 'behind', 0.546, 0.357),
  ('chair_back', 8, 'corner_offset', 1.171, 0.1433),
  ('chair_back', 8, 'edge_concave', 0.00699, 0.0301),
  ('chair_back', 8, 'edge_convex', 0.2095, 0.06138),
  ('chair_back', 8, 'edge_free', 0.7189, 0.1455),
  ('chair_back', 8, 'edge_free_top', 0.8801, 0.1826),
  ('chair_back', 8, 'edge_unseen', 0.006707, 0.03045),
  ('chair_back', 8, 'headroom', 1.628, 0.2002),
  ('chair_back', 8, 'height', 0.7918, 0.04321),
  ('chair_back', 8, 'lift', -5.262, 0.1782),
  ('chair_back', 8, 'rectangularity', 0.6889, 0.1271),
  ('chair_back', 8, 'spread_length', -0.5882, 0.109),
  ('chair_back', 8, 'spread_width', -1.238, 0.3622),
  ('chair_back', 8, 'standoff', 1.28, 0.1543),
  ('chair_back', 8, 'tilt_deg', 80.4, 2.676),
  ('chair_back', 8, 'wall_offset', 1.51, 0.268),
  ('chair_back', 8, 'width', -0.9591, 0.2872),
  ('chair_back', 8, 'z_max', 1.044, 0.08268),
  ('chair_back', 8, 'z_min', 0.2923, 0.1034);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.05075, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'aspect', 0.7732, 0.354),
  ('chair_back', 9, 'behind', 0.7563, 0.06033),
  ('chair_back', 9, 'corner_offset', 1.93, 0.4175),
  ('chair_back', 9, 'edge_concave', 0.001851, 0.03),
  ('chair_back', 9, 'edge_convex', 0.001176, 0.03),
  ('chair_back', 9, 'edge_free', 0.619, 0.08163),
  ('chair_back', 9, 'edge_free_top', 0.9976, 0.03),
  ('chair_back', 9, 'edge_unseen', 0.0115, 0.06029),
  ('chair_back', 9, 'headroom', 2, 0.4655),
  ('chair_back', 9, 'height', 0.8909, 0.06857),
  ('chair_back', 9, 'lift', -1.666, 0.6404),
  ('chair_back', 9, 'rectangularity', 0.8242, 0.125),
  ('chair_back', 9, 'spread_length', -0.8536, 0.1264),
  ('chair_back', 9, 'spread_width', -1.717, 0.3698),
  ('chair_back', 9, 'standoff', 0.7902, 0.1028),
  ('chair_back', 9, 'tilt_deg', 79.51, 2.583),
  ('chair_back', 9, 'wall_offset', 1.228, 0.3083),
  ('chair_back', 9, 'width', -1.513, 0.3749),
  ('chair_back', 9, 'z_max', 1.052, 0.07384),
  ('chair_back', 9, 'z_min', 0.6027, 0.06259);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 10, 0.07197, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 10, 'aspect', 0.3286, 0.1794),
  ('chair_back', 10, 'behind', 0.3937, 0.2273),
  ('chair_back', 10, 'corner_offset', 2.555, 3.287),
  ('chair_back', 10, 'edge_concave', 0.001158, 0.03018),
  ('chair_back', 10, 'edge_convex', 0.2024, 0.1224),
  ('chair_back', 10, 'edge_free', 0.9799, 0.04097),
  ('chair_back', 10, 'edge_free_top', 0.9976, 0.03001),
  ('chair_back', 10, 'edge_unseen', 0.05914, 0.1258),
  ('chair_back', 10, 'headroom', 1.821, 0.1594),
  ('chair_back', 10, 'height', 0.7808, 0.05488),
  ('chair_back', 10, 'lift', -5.25, 0.1893),
  ('chair_back', 10, 'rectangularity', 0.8887, 0.04456),
  ('chair_back', 10, 'spread_length', -0.6262, 0.1105),
  ('chair_back', 10, 'spread_width', -0.8119, 0.0943),
  ('chair_back', 10, 'standoff', 1.199, 0.101),
  ('chair_back', 10, 'tilt_deg', 80.26, 2.771),
  ('chair_back', 10, 'wall_offset', 1.616, 0.4076),
  ('chair_back', 10, 'width', -0.7267, 0.0787),
  ('chair_back', 10, 'z_max', 0.9956, 0.05716),
  ('chair_back', 10, 'z_min', 0.3664, 0.03616);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 11, 0.07488, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 11, 'aspect', 0.1799, 0.1876),
  ('chair_back', 11, 'behind', 0.7113, 0.2463),
  ('chair_back', 11, 'corner_offset', 1.377, 0.8021),
  ('chair_back', 11, 'edge_concave', 0.1963, 0.04682),
  ('chair_back', 11, 'edge_convex', 0.0006192, 0.03001),
  ('chair_back', 11, 'edge_free', 0.7399, 0.09947),
  ('chair_back', 11, 'edge_free_top', 0.9927, 0.03),
  ('chair_back', 11, 'edge_unseen', 0.005097, 0.03387),
  ('chair_back', 11, 'headroom', 1.87, 0.1547),
  ('chair_back', 11, 'height', 0.7818, 0.02457),
  ('chair_back', 11, 'lift', -5.154, 0.2387),
  ('chair_back', 11, 'rectangularity', 0.841, 0.09289),
  ('chair_back', 11, 'spread_length', -0.768, 0.04736),
  ('chair_back', 11, 'spread_width', -0.9216, 0.1454),
  ('chair_back', 11, 'standoff', 0.9324, 0.4448),
  ('chair_back', 11, 'tilt_deg', 79.5, 2.246),
  ('chair_back', 11, 'wall_offset', 1.782, 1.066),
  ('chair_back', 11, 'width', -0.7199, 0.04771),
  ('chair_back', 11, 'z_max', 0.98, 0.08474),
  ('chair_back', 11, 'z_min', 0.399, 0.05286);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 12, 0.07631, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 12, 'aspect', 0.5107, 0.2916),
  ('chair_back', 12, 'behind', 0.3288, 0.4455),
  ('chair_back', 12, 'corner_offset', 1.77, 0.6839),
  ('chair_back', 12, 'edge_concave', -0.006766, 0.03),
  ('chair_back', 12, 'edge_convex', 0.001248, 0.03),
  ('chair_back', 12, 'edge_free', 0.8255, 0.175),
  ('chair_back', 12, 'edge_free_top', 0.9986, 0.03),
  ('chair_back', 12, 'edge_unseen', 0.416, 0.1683),
  ('chair_back', 12, 'headroom', 1.672, 0.1149),
  ('chair_back', 12, 'height', 0.8451, 0.05186),
  ('chair_back', 12, 'lift', -1.851, 0.4018),
  ('chair_back', 12, 'rectangularity', 0.8045, 0.0937),
  ('chair_back', 12, 'spread_length', -0.8528, 0.07451),
  ('chair_back', 12, 'spread_width', -1.556, 0.2042),
  ('chair_back', 12, 'standoff', 1.203, 0.2296),
  ('chair_back', 12, 'tilt_deg', 79.99, 2.37),
  ('chair_back', 12, 'wall_offset', 1.17, 0.735),
  ('chair_back', 12, 'width', -1.395, 0.2586),
  ('chair_back', 12, 'z_max', 1.013, 0.06937),
  ('chair_back', 12, 'z_min', 0.5811, 0.05916);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 13, 0.03038, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 13, 'aspect', 0.7625, 0.2133),
  ('chair_back', 13, 'behind', 0.4895, 0.4077),
  ('chair_back', 13, 'corner_offset', 1.012, 0.9357),
  ('chair_back', 13, 'edge_concave', 0.00284, 0.0386),
  ('chair_back', 13, 'edge_convex', 0.2657, 0.07757),
  ('chair_back', 13, 'edge_free', 0.8096, 0.0805),
  ('chair_back', 13, 'edge_free_top', 0.9551, 0.08618),
  ('chair_back', 13, 'edge_unseen', 0.004596, 0.03295),
  ('chair_back', 13, 'headroom', 1.768, 0.3164),
  ('chair_back', 13, 'height', 0.8422, 0.05159),
  ('chair_back', 13, 'lift', -5.281, 0.09561),
  ('chair_back', 13, 'rectangularity', 0.748, 0.1006),
  ('chair_back', 13, 'spread_length', -0.5118, 0.1062),
  ('chair_back', 13, 'spread_width', -1.422, 0.1564),
  ('chair_back', 13, 'standoff', 1.233, 0.1562),
  ('chair_back', 13, 'tilt_deg', 79.96, 2.882),
  ('chair_back', 13, 'wall_offset', 1.617, 0.3636),
  ('chair_back', 13, 'width', -1.035, 0.2345),
  ('chair_back', 13, 'z_max', 1.107, 0.05323),
  ('chair_back', 13, 'z_min', 0.4059, 0.02255);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 14, 0.04019, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 14, 'aspect', 0.1837, 0.08682),
  ('chair_back', 14, 'behind', 0.3653, 0.3317),
  ('chair_back', 14, 'corner_offset', 1.296, 0.8788),
  ('chair_back', 14, 'edge_concave', 0.001443, 0.03003),
  ('chair_back', 14, 'edge_convex', 0.02497, 0.05115),
  ('chair_back', 14, 'edge_free', 0.8099, 0.1442),
  ('chair_back', 14, 'edge_free_top', 0.9964, 0.03005),
  ('chair_back', 14, 'edge_unseen', 0.02081, 0.05751),
  ('chair_back', 14, 'headroom', 1.644, 0.1136),
  ('chair_back', 14, 'height', 0.8313, 0.06491),
  ('chair_back', 14, 'lift', -2.335, 0.501),
  ('chair_back', 14, 'rectangularity', 0.9175, 0.0317),
  ('chair_back', 14, 'spread_length', -0.7306, 0.06329),
  ('chair_back', 14, 'spread_width', -0.9536, 0.2157),
  ('chair_back', 14, 'standoff', 1.162, 0.191),
  ('chair_back', 14, 'tilt_deg', 83.4, 1.562),
  ('chair_back', 14, 'wall_offset', 1.403, 0.5265),
  ('chair_back', 14, 'width', -0.8597, 0.1429),
  ('chair_back', 14, 'z_max', 1.009, 0.0751),
  ('chair_back', 14, 'z_min', 0.5728, 0.04904);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 15, 0.03688, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 15, 'aspect', 0.3006, 0.1656),
  ('chair_back', 15, 'behind', 0.7141, 0.1451),
  ('chair_back', 15, 'corner_offset', 1.785, 0.4464),
  ('chair_back', 15, 'edge_concave', 0.1327, 0.07184),
  ('chair_back', 15, 'edge_convex', 0.005967, 0.03),
  ('chair_back', 15, 'edge_free', 0.5835, 0.1424),
  ('chair_back', 15, 'edge_free_top', 0.7505, 0.2929),
  ('chair_back', 15, 'edge_unseen', 0.01065, 0.04862),
  ('chair_back', 15, 'headroom', 1.742, 0.197),
  ('chair_back', 15, 'height', 0.7843, 0.04119),
  ('chair_back', 15, 'lift', -3.439, 0.8821),
  ('chair_back', 15, 'rectangularity', 0.7846, 0.0916),
  ('chair_back', 15, 'spread_length', -0.8719, 0.1429),
  ('chair_back', 15, 'spread_width', -1.183, 0.2451),
  ('chair_back', 15, 'standoff', 0.8084, 0.4097),
  ('chair_back', 15, 'tilt_deg', 79, 2.807),
  ('chair_back', 15, 'wall_offset', 0.8888, 0.1431),
  ('chair_back', 15, 'width', -0.9385, 0.1677),
  ('chair_back', 15, 'z_max', 0.9641, 0.05666),
  ('chair_back', 15, 'z_min', 0.4671, 0.05849);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 16, 0.06593, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 16, 'aspect', 0.6397, 0.07063),
  ('chair_back', 16, 'behind', 0.7982, 0.03023),
  ('chair_back', 16, 'corner_offset', 1.823, 0.524),
  ('chair_back', 16, 'edge_concave', 0.177, 0.1204),
  ('chair_back', 16, 'edge_convex', 0.04016, 0.06414),
  ('chair_back', 16, 'edge_free', 0.7009, 0.1681),
  ('chair_back', 16, 'edge_free_top', 0.8629, 0.1501),
  ('chair_back', 16, 'edge_unseen', 0.004502, 0.03001),
  ('chair_back', 16, 'headroom', 1.872, 0.4175),
  ('chair_back', 16, 'height', 0.84, 0.06658),
  ('chair_back', 16, 'lift', -4.44, 0.8383),
  ('chair_back', 16, 'rectangularity', 0.6745, 0.1554),
  ('chair_back', 16, 'spread_length', -0.4414, 0.1175),
  ('chair_back', 16, 'spread_width', -1.061, 0.3116),
  ('chair_back', 16, 'standoff', 1.035, 0.476),
  ('chair_back', 16, 'tilt_deg', 80, 2.647),
  ('chair_back', 16, 'wall_offset', 1.479, 0.4932),
  ('chair_back', 16, 'width', -0.7933, 0.15),
  ('chair_back', 16, 'z_max', 1.079, 0.07928),
  ('chair_back', 16, 'z_min', 0.1955, 0.1496);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 17, 0.02832, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 17, 'aspect', 0.7935, 0.1838),
  ('chair_back', 17, 'behind', 0.4695, 0.338),
  ('chair_back', 17, 'corner_offset', 1.709, 0.6093),
  ('chair_back', 17, 'edge_concave', 0.09455, 0.09875),
  ('chair_back', 17, 'edge_convex', 0.1175, 0.1473),
  ('chair_back', 17, 'edge_free', 0.7559, 0.2019),
  ('chair_back', 17, 'edge_free_top', 0.9917, 0.03),
  ('chair_back', 17, 'edge_unseen', 0.2529, 0.1789),
  ('chair_back', 17, 'headroom', 1.65, 0.05713),
  ('chair_back', 17, 'height', 0.7936, 0.08826),
  ('chair_back', 17, 'lift', -5.082, 0.4666),
  ('chair_back', 17, 'rectangularity', 0.737, 0.08225),
  ('chair_back', 17, 'spread_length', -0.7732, 0.07853),
  ('chair_back', 17, 'spread_width', -1.556, 0.1759),
  ('chair_back', 17, 'standoff', 1.256, 0.1103),
  ('chair_back', 17, 'tilt_deg', 78.21, 2.811),
  ('chair_back', 17, 'wall_offset', 1.683, 0.4526),
  ('chair_back', 17, 'width', -1.292, 0.1965),
  ('chair_back', 17, 'z_max', 1.014, 0.1072),
  ('chair_back', 17, 'z_min', 0.4057, 0.07327);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 18, 0.02126, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 18, 'aspect', 0.6319, 0.2174),
  ('chair_back', 18, 'behind', 0.3476, 0.3424),
  ('chair_back', 18, 'corner_offset', 1.394, 0.3413),
  ('chair_back', 18, 'edge_concave', 0.001631, 0.03),
  ('chair_back', 18, 'edge_convex', 0.0024, 0.03),
  ('chair_back', 18, 'edge_free', 0.717, 0.1542),
  ('chair_back', 18, 'edge_free_top', 0.9687, 0.07216),
  ('chair_back', 18, 'edge_unseen', 0.1825, 0.181),
  ('chair_back', 18, 'headroom', 1.717, 0.2348),
  ('chair_back', 18, 'height', 0.998, 0.0379),
  ('chair_back', 18, 'lift', -4.44, 0.2303),
  ('chair_back', 18, 'rectangularity', 0.6201, 0.1614),
  ('chair_back', 18, 'spread_length', -1.279, 0.4406),
  ('chair_back', 18, 'spread_width', -2.042, 0.4028),
  ('chair_back', 18, 'standoff', 0.9862, 0.1014),
  ('chair_back', 18, 'tilt_deg', 77.63, 2.219),
  ('chair_back', 18, 'wall_offset', 2.349, 0.7023),
  ('chair_back', 18, 'width', -1.892, 0.3386),
  ('chair_back', 18, 'z_max', 1.067, 0.03289),
  ('chair_back', 18, 'z_min', 0.8664, 0.02761);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 19, 0.02887, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 19, 'aspect', 0.788, 0.2471),
  ('chair_back', 19, 'behind', 0.3715, 0.3665),
  ('chair_back', 19, 'corner_offset', 1.716, 0.2531),
  ('chair_back', 19, 'edge_concave', 0.003002, 0.03),
  ('chair_back', 19, 'edge_convex', 0.01754, 0.04447),
  ('chair_back', 19, 'edge_free', 0.2956, 0.2392),
  ('chair_back', 19, 'edge_free_top', 0.2347, 0.1758),
  ('chair_back', 19, 'edge_unseen', 0.3714, 0.3019),
  ('chair_back', 19, 'headroom', 1.579, 0.1505),
  ('chair_back', 19, 'height', 0.8944, 0.0406),
  ('chair_back', 19, 'lift', -2.537, 0.4537),
  ('chair_back', 19, 'rectangularity', 0.5598, 0.05274),
  ('chair_back', 19, 'spread_length', -0.977, 0.3527),
  ('chair_back', 19, 'spread_width', -1.808, 0.4097),
  ('chair_back', 19, 'standoff', 1.045, 0.1061),
  ('chair_back', 19, 'tilt_deg', 79.39, 2.801),
  ('chair_back', 19, 'wall_offset', 1.457, 0.1599),
  ('chair_back', 19, 'width', -1.575, 0.4063),
  ('chair_back', 19, 'z_max', 1.027, 0.09687),
  ('chair_back', 19, 'z_min', 0.6129, 0.05785);

-- door: 600 examples
UPDATE object_class SET prior = 0.02465 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.8262, 0.295)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.1669, 0.261)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'corner_offset', 1.016, 0.8082)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_concave', 0.16, 0.1559)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_convex', 0.0004325, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.1438, 0.2417)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.2484, 0.3846)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_unseen', 0.1048, 0.1745)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'headroom', 0.6961, 0.3802)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.148, 0.1928)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8231, 0.1249)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4732, 0.3078)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.3257, 0.4416)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'standoff', 0.4327, 0.4791)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.65, 1.683)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'wall_offset', 0.5535, 1.428)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1975, 0.4062)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.056, 0.2962)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1244, 0.2876)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'door';
DELETE FROM class_density WHERE class = 'door';
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.06335, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'aspect', 0.7888, 0.06906),
  ('door', 1, 'behind', -0.01772, 0.03),
  ('door', 1, 'corner_offset', 0.8287, 0.9221),
  ('door', 1, 'edge_concave', 0.1062, 0.08509),
  ('door', 1, 'edge_convex', -0.0001893, 0.03008),
  ('door', 1, 'edge_free', -0.004296, 0.03004),
  ('door', 1, 'edge_free_top', 0.0006886, 0.03006),
  ('door', 1, 'edge_unseen', 0.006521, 0.03323),
  ('door', 1, 'headroom', 0.5851, 0.725),
  ('door', 1, 'height', 1.161, 0.07522),
  ('door', 1, 'lift', 0.01537, 0.2857),
  ('door', 1, 'rectangularity', 0.78, 0.09932),
  ('door', 1, 'spread_length', 0.5093, 0.3029),
  ('door', 1, 'spread_width', -0.1866, 0.1294),
  ('door', 1, 'standoff', 0.1462, 0.3311),
  ('door', 1, 'tilt_deg', 90.08, 0.45),
  ('door', 1, 'wall_offset', -0.07025, 0.04),
  ('door', 1, 'width', -0.175, 0.0998),
  ('door', 1, 'z_max', 2.046, 0.02857),
  ('door', 1, 'z_min', 0.002217, 0.02264);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1074, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'aspect', 0.8412, 0.04202),
  ('door', 2, 'behind', 0.4052, 0.07131),
  ('door', 2, 'corner_offset', 0.4498, 0.05985),
  ('door', 2, 'edge_concave', 0.188, 0.1182),
  ('door', 2, 'edge_convex', 0.001537, 0.03),
  ('door', 2, 'edge_free', 0.4148, 0.1204),
  ('door', 2, 'edge_free_top', 0.8003, 0.1694),
  ('door', 2, 'edge_unseen', 0.002553, 0.03),
  ('door', 2, 'headroom', 0.5464, 0.4521),
  ('door', 2, 'height', 1.115, 0.05564),
  ('door', 2, 'lift', 0.0007561, 0.3159),
  ('door', 2, 'rectangularity', 0.7655, 0.1695),
  ('door', 2, 'spread_length', 0.6893, 0.0416),
  ('door', 2, 'spread_width', -0.1734, 0.1004),
  ('door', 2, 'standoff', 0.7819, 0.1177),
  ('door', 2, 'tilt_deg', 90, 0.45),
  ('door', 2, 'wall_offset', 0.7014, 0.3802),
  ('door', 2, 'width', -0.02808, 0.05541),
  ('door', 2, 'z_max', 2.162, 0.07925),
  ('door', 2, 'z_min', -0.01497, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.03282, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'aspect', 0.9486, 0.1046),
  ('door', 3, 'behind', -0.003044, 0.03001),
  ('door', 3, 'corner_offset', 2.267, 0.7105),
  ('door', 3, 'edge_concave', 0.07073, 0.05746),
  ('door', 3, 'edge_convex', -0.003256, 0.03003),
  ('door', 3, 'edge_free', 0.00494, 0.03562),
  ('door', 3, 'edge_free_top', 0.004048, 0.03001),
  ('door', 3, 'edge_unseen', 0.6176, 0.07229),
  ('door', 3, 'headroom', 0.6969, 0.07064),
  ('door', 3, 'height', 1.333, 0.1383),
  ('door', 3, 'lift', 0.00838, 0.302),
  ('door', 3, 'rectangularity', 0.6469, 0.06423),
  ('door', 3, 'spread_length', 0.6625, 0.1429),
  ('door', 3, 'spread_width', -0.2279, 0.7403),
  ('door', 3, 'standoff', 0.4368, 0.1367),
  ('door', 3, 'tilt_deg', 89.87, 0.4504),
  ('door', 3, 'wall_offset', 3.945, 1.81),
  ('door', 3, 'width', -0.0825, 0.461),
  ('door', 3, 'z_max', 2.172, 0.1033),
  ('door', 3, 'z_min', 0.08337, 0.06456);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.05944, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'aspect', 0.6837, 0.09694),
  ('door', 4, 'behind', -0.002689, 0.03),
  ('door', 4, 'corner_offset', 0.8524, 0.1934),
  ('door', 4, 'edge_concave', 0.01541, 0.04572),
  ('door', 4, 'edge_convex', -0.0001746, 0.03),
  ('door', 4, 'edge_free', -0.0008178, 0.03),
  ('door', 4, 'edge_free_top', 0.004884, 0.03068),
  ('door', 4, 'edge_unseen', 0.004259, 0.03),
  ('door', 4, 'headroom', 0.7042, 0.4167),
  ('door', 4, 'height', 1.431, 0.07348),
  ('door', 4, 'lift', 0.04188, 0.2372),
  ('door', 4, 'rectangularity', 0.8278, 0.1165),
  ('door', 4, 'spread_length', 0.1378, 0.1173),
  ('door', 4, 'spread_width', -0.188, 0.04402),
  ('door', 4, 'standoff', 0.4479, 0.1217),
  ('door', 4, 'tilt_deg', 90, 0.45),
  ('door', 4, 'wall_offset', 1.594, 2.572),
  ('door', 4, 'width', -0.1431, 0.05037),
  ('door', 4, 'z_max', 2.063, 0.04479),
  ('door', 4, 'z_min', 0.3269, 0.2918);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.03238, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'aspect', 0.8023, 0.06101),
  ('door', 5, 'behind', 0.4574, 0.1118),
  ('door', 5, 'corner_offset', 2.978, 4.772),
  ('door', 5, 'edge_concave', 0.1002, 0.1269),
  ('door', 5, 'edge_convex', 0.004854, 0.05617),
  ('door', 5, 'edge_free', 0.4588, 0.1008),
  ('door', 5, 'edge_free_top', 0.8439, 0.1592),
  ('door', 5, 'edge_unseen', 0.2499, 0.07472),
  ('door', 5, 'headroom', 0.734, 0.2339),
  ('door', 5, 'height', 1.279, 0.02255),
  ('door', 5, 'lift', -0.0001223, 0.3166),
  ('door', 5, 'rectangularity', 0.7295, 0.1016),
  ('door', 5, 'spread_length', 0.3587, 0.08003),
  ('door', 5, 'spread_width', -0.3182, 0.2383),
  ('door', 5, 'standoff', 0.8083, 0.1899),
  ('door', 5, 'tilt_deg', 89.97, 0.45),
  ('door', 5, 'wall_offset', 0.8496, 2.654),
  ('door', 5, 'width', -0.1701, 0.1985),
  ('door', 5, 'z_max', 2.139, 0.07646),
  ('door', 5, 'z_min', -0.0009429, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.03782, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'aspect', 0.6066, 0.1693),
  ('door', 6, 'behind', -0.004904, 0.03),
  ('door', 6, 'corner_offset', 1.11, 0.6013),
  ('door', 6, 'edge_concave', 0.001156, 0.03),
  ('door', 6, 'edge_convex', -9.298e-05, 0.03003),
  ('door', 6, 'edge_free', -0.002562, 0.03),
  ('door', 6, 'edge_free_top', 0.005438, 0.03015),
  ('door', 6, 'edge_unseen', 0.3778, 0.03181),
  ('door', 6, 'headroom', 0.5772, 0.06909),
  ('door', 6, 'height', 1.367, 0.08292),
  ('door', 6, 'lift', 0.0265, 0.2464),
  ('door', 6, 'rectangularity', 0.5787, 0.0535),
  ('door', 6, 'spread_length', -0.1597, 0.06972),
  ('door', 6, 'spread_width', -0.3749, 0.05612),
  ('door', 6, 'standoff', 0.2031, 0.377),
  ('door', 6, 'tilt_deg', 89.8, 0.4749),
  ('door', 6, 'wall_offset', -0.1026, 2.568),
  ('door', 6, 'width', -0.1418, 0.2338),
  ('door', 6, 'z_max', 2.034, 0.05616),
  ('door', 6, 'z_min', 0.5414, 0.1486);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.01315, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'aspect', 0.9918, 0.5741),
  ('door', 7, 'behind', 0.1295, 0.4754),
  ('door', 7, 'corner_offset', 0.1261, 0.8569),
  ('door', 7, 'edge_concave', 0.1262, 0.1514),
  ('door', 7, 'edge_convex', -0.001295, 0.03018),
  ('door', 7, 'edge_free', 0.2163, 0.168),
  ('door', 7, 'edge_free_top', 0.2638, 0.3361),
  ('door', 7, 'edge_unseen', 0.06969, 0.106),
  ('door', 7, 'headroom', 1.759, 0.5757),
  ('door', 7, 'height', 0.9434, 0.867),
  ('door', 7, 'lift', 0.09448, 0.1973),
  ('door', 7, 'rectangularity', 0.7342, 0.0638),
  ('door', 7, 'spread_length', -0.3447, 0.2175),
  ('door', 7, 'spread_width', -1.567, 0.6298),
  ('door', 7, 'standoff', 0.2182, 0.1249),
  ('door', 7, 'tilt_deg', 89.21, 1.176),
  ('door', 7, 'wall_offset', 0.5082, 0.6487),
  ('door', 7, 'width', -1.524, 0.5732),
  ('door', 7, 'z_max', 1.181, 0.6836),
  ('door', 7, 'z_min', 0.649, 0.9512);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.08084, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'aspect', 0.5595, 0.1386),
  ('door', 8, 'behind', 0.5865, 0.06254),
  ('door', 8, 'corner_offset', 0.3689, 0.1106),
  ('door', 8, 'edge_concave', 0.05529, 0.06168),
  ('door', 8, 'edge_convex', 0.0005716, 0.03),
  ('door', 8, 'edge_free', 0.4988, 0.4164),
  ('door', 8, 'edge_free_top', 0.7215, 0.197),
  ('door', 8, 'edge_unseen', 0.2778, 0.2707),
  ('door', 8, 'headroom', 0.436, 0.3632),
  ('door', 8, 'height', 1.365, 0.1585),
  ('door', 8, 'lift', 0.01325, 0.295),
  ('door', 8, 'rectangularity', 0.6782, 0.1173),
  ('door', 8, 'spread_length', 0.06312, 0.1139),
  ('door', 8, 'spread_width', -0.2427, 0.1277),
  ('door', 8, 'standoff', 0.3657, 0.1052),
  ('door', 8, 'tilt_deg', 89.98, 0.45),
  ('door', 8, 'wall_offset', 1.383, 0.4721),
  ('door', 8, 'width', -0.08077, 0.05506),
  ('door', 8, 'z_max', 2.085, 0.07694),
  ('door', 8, 'z_min', 0.5934, 0.2692);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.02777, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'aspect', 1.234, 0.1341),
  ('door', 9, 'behind', 0.1327, 0.1342),
  ('door', 9, 'corner_offset', 1.048, 0.1472),
  ('door', 9, 'edge_concave', 0.2816, 0.2576),
  ('door', 9, 'edge_convex', -0.0004517, 0.03001),
  ('door', 9, 'edge_free', 0.1978, 0.1342),
  ('door', 9, 'edge_free_top', 0.2768, 0.3675),
  ('door', 9, 'edge_unseen', 0.2245, 0.1399),
  ('door', 9, 'headroom', 0.7013, 0.09425),
  ('door', 9, 'height', 1.173, 0.08968),
  ('door', 9, 'lift', 0.003762, 0.3114),
  ('door', 9, 'rectangularity', 0.627, 0.06313),
  ('door', 9, 'spread_length', 0.5247, 0.3524),
  ('door', 9, 'spread_width', -1.197, 0.3982),
  ('door', 9, 'standoff', 0.4024, 0.1087),
  ('door', 9, 'tilt_deg', 79.33, 9.657),
  ('door', 9, 'wall_offset', 0.4646, 0.4614),
  ('door', 9, 'width', -0.6887, 0.4289),
  ('door', 9, 'z_max', 2.042, 0.1241),
  ('door', 9, 'z_min', 0.1305, 0.206);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.02004, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'aspect', 1.147, 0.06726),
  ('door', 10, 'behind', 0.007819, 0.03),
  ('door', 10, 'corner_offset', 0.8693, 0.1895),
  ('door', 10, 'edge_concave', 0.2688, 0.1922),
  ('door', 10, 'edge_convex', -2.831e-05, 0.03004),
  ('door', 10, 'edge_free', 0.01128, 0.05034),
  ('door', 10, 'edge_free_top', 0.08198, 0.1236),
  ('door', 10, 'edge_unseen', 0.2271, 0.2138),
  ('door', 10, 'headroom', 0.6973, 0.08809),
  ('door', 10, 'height', 0.9135, 0.1533),
  ('door', 10, 'lift', 0.00102, 0.3148),
  ('door', 10, 'rectangularity', 0.8779, 0.03669),
  ('door', 10, 'spread_length', 0.3237, 0.2868),
  ('door', 10, 'spread_width', -0.821, 0.2733),
  ('door', 10, 'standoff', 0.4326, 0.1444),
  ('door', 10, 'tilt_deg', 88.21, 1.266),
  ('door', 10, 'wall_offset', 9.851, 2.672),
  ('door', 10, 'width', -0.6812, 0.3111),
  ('door', 10, 'z_max', 1.584, 0.342),
  ('door', 10, 'z_min', 0.01314, 0.02256);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 11, 0.04281, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 11, 'aspect', 0.8315, 0.07327),
  ('door', 11, 'behind', -0.006736, 0.03),
  ('door', 11, 'corner_offset', 1.088, 0.5608),
  ('door', 11, 'edge_concave', 0.1828, 0.07233),
  ('door', 11, 'edge_convex', -0.001103, 0.03004),
  ('door', 11, 'edge_free', 0.0004716, 0.03013),
  ('door', 11, 'edge_free_top', 0.002132, 0.03004),
  ('door', 11, 'edge_unseen', 0.004302, 0.03017),
  ('door', 11, 'headroom', 0.7357, 0.3797),
  ('door', 11, 'height', 1.113, 0.04907),
  ('door', 11, 'lift', 0.003173, 0.3118),
  ('door', 11, 'rectangularity', 0.8877, 0.06798),
  ('door', 11, 'spread_length', 0.6074, 0.06943),
  ('door', 11, 'spread_width', -0.1282, 0.04441),
  ('door', 11, 'standoff', 0.1189, 0.1703),
  ('door', 11, 'tilt_deg', 90, 0.45),
  ('door', 11, 'wall_offset', -0.07313, 0.04),
  ('door', 11, 'width', -0.08401, 0.05661),
  ('door', 11, 'z_max', 2.057, 0.04),
  ('door', 11, 'z_min', -0.01254, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 12, 0.05962, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 12, 'aspect', 0.8214, 0.1198),
  ('door', 12, 'behind', 0.5676, 0.08646),
  ('door', 12, 'corner_offset', 0.4393, 0.04008),
  ('door', 12, 'edge_concave', 0.2996, 0.1971),
  ('door', 12, 'edge_convex', -0.004473, 0.03),
  ('door', 12, 'edge_free', 0.4352, 0.123),
  ('door', 12, 'edge_free_top', 0.7424, 0.08014),
  ('door', 12, 'edge_unseen', 0.002477, 0.03004),
  ('door', 12, 'headroom', 0.5875, 0.1812),
  ('door', 12, 'height', 1.157, 0.06706),
  ('door', 12, 'lift', 0.0005978, 0.3162),
  ('door', 12, 'rectangularity', 0.7984, 0.06159),
  ('door', 12, 'spread_length', 0.5411, 0.1335),
  ('door', 12, 'spread_width', -0.1107, 0.05071),
  ('door', 12, 'standoff', 0.8631, 0.397),
  ('door', 12, 'tilt_deg', 89.99, 0.45),
  ('door', 12, 'wall_offset', 0.6243, 0.343),
  ('door', 12, 'width', -0.00721, 0.08142),
  ('door', 12, 'z_max', 2.296, 0.2029),
  ('door', 12, 'z_min', 0.001669, 0.03568);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 13, 0.09888, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 13, 'aspect', 0.7199, 0.1807),
  ('door', 13, 'behind', -0.001959, 0.03),
  ('door', 13, 'corner_offset', 0.8435, 0.5119),
  ('door', 13, 'edge_concave', 0.03735, 0.04528),
  ('door', 13, 'edge_convex', -0.0001608, 0.03),
  ('door', 13, 'edge_free', 0.004649, 0.03),
  ('door', 13, 'edge_free_top', 0.004666, 0.03001),
  ('door', 13, 'edge_unseen', 0.2402, 0.1996),
  ('door', 13, 'headroom', 0.6818, 0.2101),
  ('door', 13, 'height', 1.28, 0.08913),
  ('door', 13, 'lift', 0.05311, 0.2193),
  ('door', 13, 'rectangularity', 0.7052, 0.1131),
  ('door', 13, 'spread_length', 0.1623, 0.1433),
  ('door', 13, 'spread_width', -0.161, 0.07924),
  ('door', 13, 'standoff', 0.1554, 0.04527),
  ('door', 13, 'tilt_deg', 90.05, 0.45),
  ('door', 13, 'wall_offset', -0.08603, 0.04),
  ('door', 13, 'width', -0.1445, 0.07599),
  ('door', 13, 'z_max', 2.061, 0.03869),
  ('door', 13, 'z_min', 0.177, 0.1682);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 14, 0.1043, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 14, 'aspect', 0.4173, 0.1962),
  ('door', 14, 'behind', 0.5764, 0.1341),
  ('door', 14, 'corner_offset', 0.8531, 0.8412),
  ('door', 14, 'edge_concave', 0.09565, 0.08184),
  ('door', 14, 'edge_convex', -0.000389, 0.03),
  ('door', 14, 'edge_free', 0.4298, 0.2869),
  ('door', 14, 'edge_free_top', 0.7449, 0.2673),
  ('door', 14, 'edge_unseen', 0.333, 0.1445),
  ('door', 14, 'headroom', 0.7232, 0.2746),
  ('door', 14, 'height', 1.404, 0.1761),
  ('door', 14, 'lift', 0.03947, 0.255),
  ('door', 14, 'rectangularity', 0.6896, 0.1134),
  ('door', 14, 'spread_length', -0.08218, 0.08003),
  ('door', 14, 'spread_width', -0.237, 0.07275),
  ('door', 14, 'standoff', 0.8855, 0.2117),
  ('door', 14, 'tilt_deg', 90.02, 0.45),
  ('door', 14, 'wall_offset', 2.615, 2.668),
  ('door', 14, 'width', -0.131, 0.0359),
  ('door', 14, 'z_max', 2.063, 0.05384),
  ('door', 14, 'z_min', 0.6378, 0.454);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 15, 0.04613, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 15, 'aspect', 0.858, 0.0663),
  ('door', 15, 'behind', 0.3613, 0.06977),
  ('door', 15, 'corner_offset', 2.304, 0.3016),
  ('door', 15, 'edge_concave', 0.1284, 0.03),
  ('door', 15, 'edge_convex', 0.006893, 0.03666),
  ('door', 15, 'edge_free', 0.4662, 0.05042),
  ('door', 15, 'edge_free_top', 0.8195, 0.1458),
  ('door', 15, 'edge_unseen', 0.02152, 0.05274),
  ('door', 15, 'headroom', 0.5953, 0.1745),
  ('door', 15, 'height', 1.102, 0.05273),
  ('door', 15, 'lift', -1.056e-07, 0.3163),
  ('door', 15, 'rectangularity', 0.858, 0.08024),
  ('door', 15, 'spread_length', 0.6494, 0.05001),
  ('door', 15, 'spread_width', -0.2097, 0.08916),
  ('door', 15, 'standoff', 0.5018, 0.1605),
  ('door', 15, 'tilt_deg', 89.99, 0.45),
  ('door', 15, 'wall_offset', 0.1658, 0.06014),
  ('door', 15, 'width', -0.1135, 0.07168),
  ('door', 15, 'z_max', 2.088, 0.07002),
  ('door', 15, 'z_min', -0.01334, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 16, 0.01216, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 16, 'aspect', 1.145, 0.6678),
  ('door', 16, 'behind', -0.004662, 0.03),
  ('door', 16, 'corner_offset', 0.1208, 1.082),
  ('door', 16, 'edge_concave', 0.04516, 0.1305),
  ('door', 16, 'edge_convex', -0.0005397, 0.03),
  ('door', 16, 'edge_free', 0.1305, 0.3342),
  ('door', 16, 'edge_free_top', 0.03755, 0.08179),
  ('door', 16, 'edge_unseen', 0.4667, 0.05485),
  ('door', 16, 'headroom', 0.5801, 0.04814),
  ('door', 16, 'height', 1.264, 0.2286),
  ('door', 16, 'lift', 0.09618, 0.2371),
  ('door', 16, 'rectangularity', 0.6697, 0.07652),
  ('door', 16, 'spread_length', 0.03405, 0.2045),
  ('door', 16, 'spread_width', -1.468, 0.3845),
  ('door', 16, 'standoff', 0.07571, 0.1054),
  ('door', 16, 'tilt_deg', 89.85, 0.45),
  ('door', 16, 'wall_offset', 2.069, 3.002),
  ('door', 16, 'width', -1.285, 0.4193),
  ('door', 16, 'z_max', 1.789, 0.1634),
  ('door', 16, 'z_min', 0.5957, 0.5117);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 17, 0.08285, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 17, 'aspect', 0.7936, 0.1941),
  ('door', 17, 'behind', 0.03015, 0.03937),
  ('door', 17, 'corner_offset', 7.304, 6.379),
  ('door', 17, 'edge_concave', 0.08623, 0.09298),
  ('door', 17, 'edge_convex', -0.003295, 0.04427),
  ('door', 17, 'edge_free', 0.06929, 0.2147),
  ('door', 17, 'edge_free_top', 0.3144, 0.2417),
  ('door', 17, 'edge_unseen', 0.496, 0.03004),
  ('door', 17, 'headroom', 0.6909, 0.1747),
  ('door', 17, 'height', 1.118, 0.2025),
  ('door', 17, 'lift', 0.01586, 0.2932),
  ('door', 17, 'rectangularity', 0.7769, 0.04635),
  ('door', 17, 'spread_length', 0.3503, 0.07315),
  ('door', 17, 'spread_width', -0.4524, 0.2178),
  ('door', 17, 'standoff', 0.4869, 0.1225),
  ('door', 17, 'tilt_deg', 89.48, 0.6054),
  ('door', 17, 'wall_offset', 3.7, 0.4017),
  ('door', 17, 'width', -0.3173, 0.1575),
  ('door', 17, 'z_max', 1.88, 0.2869),
  ('door', 17, 'z_min', 0.1567, 0.1355);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 18, 0.01848, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 18, 'aspect', 0.2552, 0.1009),
  ('door', 18, 'behind', 0.1759, 0.288),
  ('door', 18, 'corner_offset', 0.3619, 0.1205),
  ('door', 18, 'edge_concave', 0.61, 0.08503),
  ('door', 18, 'edge_convex', 0.002275, 0.03012),
  ('door', 18, 'edge_free', 0.04664, 0.09399),
  ('door', 18, 'edge_free_top', 0.02398, 0.04123),
  ('door', 18, 'edge_unseen', 0.1388, 0.09768),
  ('door', 18, 'headroom', 0.9191, 0.9271),
  ('door', 18, 'height', 0.9451, 0.4529),
  ('door', 18, 'lift', 0.01109, 0.3048),
  ('door', 18, 'rectangularity', 0.7254, 0.1046),
  ('door', 18, 'spread_length', 0.4546, 0.3811),
  ('door', 18, 'spread_width', -0.2441, 0.9527),
  ('door', 18, 'standoff', 0.9182, 0.2939),
  ('door', 18, 'tilt_deg', 89.94, 0.4507),
  ('door', 18, 'wall_offset', 0.06893, 0.2619),
  ('door', 18, 'width', -0.01969, 1.166),
  ('door', 18, 'z_max', 1.757, 0.7707),
  ('door', 18, 'z_min', -0.04246, 0.0299);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 19, 0.009717, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 19, 'aspect', 1.42, 0.588),
  ('door', 19, 'behind', 0.08974, 0.1075),
  ('door', 19, 'corner_offset', 0.8347, 0.1421),
  ('door', 19, 'edge_concave', 0.09526, 0.03001),
  ('door', 19, 'edge_convex', -0.0002335, 0.03),
  ('door', 19, 'edge_free', 0.03904, 0.05085),
  ('door', 19, 'edge_free_top', 0.102, 0.1539),
  ('door', 19, 'edge_unseen', 0.008655, 0.03),
  ('door', 19, 'headroom', 0.4259, 0.409),
  ('door', 19, 'height', 1.161, 0.08817),
  ('door', 19, 'lift', 0.0005556, 0.3157),
  ('door', 19, 'rectangularity', 0.6373, 0.07223),
  ('door', 19, 'spread_length', 0.7108, 0.1003),
  ('door', 19, 'spread_width', -0.9981, 0.2519),
  ('door', 19, 'standoff', 0.1042, 0.1478),
  ('door', 19, 'tilt_deg', 89.93, 0.45),
  ('door', 19, 'wall_offset', -0.06302, 0.115),
  ('door', 19, 'width', -0.7407, 0.2223),
  ('door', 19, 'z_max', 2.491, 0.2661),
  ('door', 19, 'z_min', 0.005134, 0.02255);

-- window: 1557 examples
UPDATE object_class SET prior = 0.01586 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.4852, 0.4382)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 0.0004216, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'corner_offset', 1.405, 0.9222)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_concave', 0.246, 0.2749)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_convex', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.08316, 0.1502)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.07546, 0.1927)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_unseen', 0.141, 0.156)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'headroom', 0.2985, 0.3898)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.49, 0.2173)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'lift', -3.323, 1.906)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.7477, 0.1933)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.1188, 0.3666)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.481, 0.6466)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'standoff', 0.003016, 0.02054)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.72, 0.5479)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'wall_offset', 0.4674, 1.534)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.3557, 0.5454)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.025, 0.2883)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 1.023, 0.2197)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'window';
DELETE FROM class_density WHERE class = 'window';
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.08191, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'aspect', 0.3312, 0.2955),
  ('window', 1, 'behind', -0.004473, 0.03),
  ('window', 1, 'corner_offset', 1.672, 1.127),
  ('window', 1, 'edge_concave', 0.01202, 0.03),
  ('window', 1, 'edge_convex', -0.00268, 0.03008),
  ('window', 1, 'edge_free', 0.004129, 0.04624),
  ('window', 1, 'edge_free_top', 0.00401, 0.03919),
  ('window', 1, 'edge_unseen', 0.193, 0.09091),
  ('window', 1, 'headroom', 0.7931, 0.4144),
  ('window', 1, 'height', 1.43, 0.1426),
  ('window', 1, 'lift', -2.118, 0.5999),
  ('window', 1, 'rectangularity', 0.8352, 0.04741),
  ('window', 1, 'spread_length', -0.08154, 0.4823),
  ('window', 1, 'spread_width', -0.4115, 0.5373),
  ('window', 1, 'standoff', -0.01563, 0.00775),
  ('window', 1, 'tilt_deg', 89.66, 0.45),
  ('window', 1, 'wall_offset', -0.1017, 0.04009),
  ('window', 1, 'width', -0.3225, 0.7405),
  ('window', 1, 'z_max', 2.109, 0.4349),
  ('window', 1, 'z_min', 0.9759, 0.061);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.05889, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'aspect', 0.2199, 0.1461),
  ('window', 2, 'behind', -0.0003461, 0.03),
  ('window', 2, 'corner_offset', 1.487, 1.009),
  ('window', 2, 'edge_concave', 0.2641, 0.192),
  ('window', 2, 'edge_convex', -0.008104, 0.03009),
  ('window', 2, 'edge_free', -0.01041, 0.03),
  ('window', 2, 'edge_free_top', 0.002275, 0.03067),
  ('window', 2, 'edge_unseen', 0.0069, 0.03008),
  ('window', 2, 'headroom', -0.01273, 0.03001),
  ('window', 2, 'height', 1.503, 0.0875),
  ('window', 2, 'lift', -5.251, 0.1917),
  ('window', 2, 'rectangularity', 0.7286, 0.2763),
  ('window', 2, 'spread_length', 0.4965, 0.08233),
  ('window', 2, 'spread_width', 0.2276, 0.1464),
  ('window', 2, 'standoff', 0.01225, 0.00775),
  ('window', 2, 'tilt_deg', 89.8, 0.45),
  ('window', 2, 'wall_offset', -0.1582, 0.05285),
  ('window', 2, 'width', 0.09787, 0.1182),
  ('window', 2, 'z_max', 2.184, 0.09279),
  ('window', 2, 'z_min', 0.8862, 0.04208);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.03707, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'aspect', 0.6775, 0.6196),
  ('window', 3, 'behind', -0.00459, 0.03),
  ('window', 3, 'corner_offset', 1.024, 0.2464),
  ('window', 3, 'edge_concave', 0.2268, 0.3215),
  ('window', 3, 'edge_convex', -0.0008868, 0.03),
  ('window', 3, 'edge_free', 0.006895, 0.03002),
  ('window', 3, 'edge_free_top', -0.0007677, 0.03),
  ('window', 3, 'edge_unseen', 0.2876, 0.1171),
  ('window', 3, 'headroom', 0.2119, 0.1638),
  ('window', 3, 'height', 1.284, 0.1679),
  ('window', 3, 'lift', -4.177, 1.371),
  ('window', 3, 'rectangularity', 0.7634, 0.08859),
  ('window', 3, 'spread_length', 0.08815, 0.1222),
  ('window', 3, 'spread_width', -1.428, 0.7038),
  ('window', 3, 'standoff', 0.01233, 0.00775),
  ('window', 3, 'tilt_deg', 89.57, 0.45),
  ('window', 3, 'wall_offset', 4.714, 1.101),
  ('window', 3, 'width', -1.017, 0.4664),
  ('window', 3, 'z_max', 1.902, 0.1809),
  ('window', 3, 'z_min', 0.9459, 0.05777);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.06167, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'aspect', 0.2768, 0.1764),
  ('window', 4, 'behind', -0.001752, 0.03),
  ('window', 4, 'corner_offset', 1.14, 0.2611),
  ('window', 4, 'edge_concave', 0.2365, 0.2302),
  ('window', 4, 'edge_convex', -0.002506, 0.03),
  ('window', 4, 'edge_free', 0.03986, 0.04443),
  ('window', 4, 'edge_free_top', 0.0003204, 0.03),
  ('window', 4, 'edge_unseen', 0.1726, 0.1421),
  ('window', 4, 'headroom', 0.04414, 0.07277),
  ('window', 4, 'height', 1.521, 0.1646),
  ('window', 4, 'lift', -3.019, 1.112),
  ('window', 4, 'rectangularity', 0.7886, 0.1864),
  ('window', 4, 'spread_length', 0.2557, 0.1354),
  ('window', 4, 'spread_width', -0.2077, 0.2747),
  ('window', 4, 'standoff', 0.01756, 0.00775),
  ('window', 4, 'tilt_deg', 89.76, 0.45),
  ('window', 4, 'wall_offset', -0.184, 0.05714),
  ('window', 4, 'width', -0.09962, 0.1583),
  ('window', 4, 'z_max', 2.145, 0.1218),
  ('window', 4, 'z_min', 0.9893, 0.08008);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.0164, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'aspect', 0.443, 0.1125),
  ('window', 5, 'behind', -0.003457, 0.03),
  ('window', 5, 'corner_offset', 0.9186, 0.3779),
  ('window', 5, 'edge_concave', 0.2082, 0.2812),
  ('window', 5, 'edge_convex', -0.0004708, 0.03006),
  ('window', 5, 'edge_free', 0.3541, 0.1195),
  ('window', 5, 'edge_free_top', 0.4841, 0.2288),
  ('window', 5, 'edge_unseen', 0.06696, 0.09621),
  ('window', 5, 'headroom', 0.218, 0.2343),
  ('window', 5, 'height', 1.41, 0.1597),
  ('window', 5, 'lift', -3.891, 1.167),
  ('window', 5, 'rectangularity', 0.4734, 0.2542),
  ('window', 5, 'spread_length', 0.2688, 0.1573),
  ('window', 5, 'spread_width', -0.3179, 0.2482),
  ('window', 5, 'standoff', 0.0005618, 0.01333),
  ('window', 5, 'tilt_deg', 89.78, 0.4515),
  ('window', 5, 'wall_offset', 1.054, 2.348),
  ('window', 5, 'width', -0.3204, 0.1837),
  ('window', 5, 'z_max', 2.047, 0.2149),
  ('window', 5, 'z_min', 0.9421, 0.05264);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.09939, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'aspect', 0.4543, 0.2292),
  ('window', 6, 'behind', -0.006667, 0.03),
  ('window', 6, 'corner_offset', 1.456, 1.065),
  ('window', 6, 'edge_concave', 0.09659, 0.1883),
  ('window', 6, 'edge_convex', -0.0003768, 0.03),
  ('window', 6, 'edge_free', 0.3088, 0.1309),
  ('window', 6, 'edge_free_top', 0.02546, 0.04201),
  ('window', 6, 'edge_unseen', 0.1876, 0.08773),
  ('window', 6, 'headroom', 0.2868, 0.3276),
  ('window', 6, 'height', 1.767, 0.2138),
  ('window', 6, 'lift', -0.7176, 0.6075),
  ('window', 6, 'rectangularity', 0.8081, 0.08141),
  ('window', 6, 'spread_length', 0.1116, 0.122),
  ('window', 6, 'spread_width', -0.5255, 0.3675),
  ('window', 6, 'standoff', -0.01248, 0.02015),
  ('window', 6, 'tilt_deg', 89.84, 0.45),
  ('window', 6, 'wall_offset', -0.1344, 0.06422),
  ('window', 6, 'width', -0.4133, 0.3575),
  ('window', 6, 'z_max', 2.151, 0.1289),
  ('window', 6, 'z_min', 1.436, 0.2863);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.01631, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'aspect', 0.6347, 0.3639),
  ('window', 7, 'behind', -0.003382, 0.03),
  ('window', 7, 'corner_offset', 1.107, 0.2819),
  ('window', 7, 'edge_concave', 0.2243, 0.2695),
  ('window', 7, 'edge_convex', -2.7e-05, 0.03),
  ('window', 7, 'edge_free', 0.1706, 0.1147),
  ('window', 7, 'edge_free_top', 0.06659, 0.1475),
  ('window', 7, 'edge_unseen', 0.3093, 0.09886),
  ('window', 7, 'headroom', 0.2145, 0.2635),
  ('window', 7, 'height', 1.777, 0.07804),
  ('window', 7, 'lift', -0.4329, 0.3337),
  ('window', 7, 'rectangularity', 0.6636, 0.1901),
  ('window', 7, 'spread_length', -0.3715, 0.3915),
  ('window', 7, 'spread_width', -1.112, 0.3124),
  ('window', 7, 'standoff', 0.01646, 0.0169),
  ('window', 7, 'tilt_deg', 89.57, 0.8152),
  ('window', 7, 'wall_offset', 2.878, 3.2),
  ('window', 7, 'width', -0.8999, 0.33),
  ('window', 7, 'z_max', 2.055, 0.1408),
  ('window', 7, 'z_min', 1.566, 0.06387);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.05233, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'aspect', 1.006, 0.3645),
  ('window', 8, 'behind', -0.003393, 0.03),
  ('window', 8, 'corner_offset', 1.27, 1.002),
  ('window', 8, 'edge_concave', 0.2508, 0.3138),
  ('window', 8, 'edge_convex', -0.000307, 0.03001),
  ('window', 8, 'edge_free', 0.02019, 0.04829),
  ('window', 8, 'edge_free_top', 0.1225, 0.2259),
  ('window', 8, 'edge_unseen', 0.1547, 0.1391),
  ('window', 8, 'headroom', 0.777, 0.2036),
  ('window', 8, 'height', 1.061, 0.1125),
  ('window', 8, 'lift', -5.226, 0.2589),
  ('window', 8, 'rectangularity', 0.632, 0.233),
  ('window', 8, 'spread_length', 0.02939, 0.2722),
  ('window', 8, 'spread_width', -1.321, 0.6662),
  ('window', 8, 'standoff', -0.0006574, 0.01186),
  ('window', 8, 'tilt_deg', 88.64, 1.375),
  ('window', 8, 'wall_offset', -0.1704, 0.06119),
  ('window', 8, 'width', -1.098, 0.4457),
  ('window', 8, 'z_max', 1.36, 0.2042),
  ('window', 8, 'z_min', 0.9048, 0.03724);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.02888, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'aspect', 1.304, 0.2164),
  ('window', 9, 'behind', -0.001343, 0.03),
  ('window', 9, 'corner_offset', 1.521, 0.9764),
  ('window', 9, 'edge_concave', 0.284, 0.2777),
  ('window', 9, 'edge_convex', -0.0001224, 0.03),
  ('window', 9, 'edge_free', 0.05835, 0.09931),
  ('window', 9, 'edge_free_top', 0.02678, 0.06642),
  ('window', 9, 'edge_unseen', 0.0604, 0.07493),
  ('window', 9, 'headroom', 0.09896, 0.1194),
  ('window', 9, 'height', 1.542, 0.1404),
  ('window', 9, 'lift', -5, 0.5145),
  ('window', 9, 'rectangularity', 0.6851, 0.1862),
  ('window', 9, 'spread_length', 0.1563, 0.2204),
  ('window', 9, 'spread_width', -1.493, 0.3858),
  ('window', 9, 'standoff', 0.01372, 0.009765),
  ('window', 9, 'tilt_deg', 89.63, 0.5689),
  ('window', 9, 'wall_offset', -0.1857, 0.05938),
  ('window', 9, 'width', -1.228, 0.2563),
  ('window', 9, 'z_max', 2.128, 0.1331),
  ('window', 9, 'z_min', 0.9067, 0.05181);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.02216, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'aspect', 1.283, 0.5702),
  ('window', 10, 'behind', 0.6768, 0.1161),
  ('window', 10, 'corner_offset', 0.76, 0.1708),
  ('window', 10, 'edge_concave', 0.7836, 0.2941),
  ('window', 10, 'edge_convex', -0.0001762, 0.03),
  ('window', 10, 'edge_free', 0.1045, 0.1121),
  ('window', 10, 'edge_free_top', 0.095, 0.1045),
  ('window', 10, 'edge_unseen', 0.1078, 0.06954),
  ('window', 10, 'headroom', 0.5187, 0.1025),
  ('window', 10, 'height', 1.421, 0.1098),
  ('window', 10, 'lift', -4.641, 0.6986),
  ('window', 10, 'rectangularity', 0.7263, 0.04441),
  ('window', 10, 'spread_length', -0.3552, 0.5766),
  ('window', 10, 'spread_width', -1.44, 0.2237),
  ('window', 10, 'standoff', 0.3453, 0.1337),
  ('window', 10, 'tilt_deg', 89.79, 0.45),
  ('window', 10, 'wall_offset', 0.991, 0.6036),
  ('window', 10, 'width', -1.401, 0.1231),
  ('window', 10, 'z_max', 1.928, 0.3642),
  ('window', 10, 'z_min', 0.9377, 0.1502);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 11, 0.07376, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 11, 'aspect', 0.1846, 0.1411),
  ('window', 11, 'behind', -9.946e-05, 0.03),
  ('window', 11, 'corner_offset', 1.151, 0.6576),
  ('window', 11, 'edge_concave', 0.3056, 0.3165),
  ('window', 11, 'edge_convex', -0.0001889, 0.03),
  ('window', 11, 'edge_free', 0.003967, 0.03516),
  ('window', 11, 'edge_free_top', -0.002575, 0.03),
  ('window', 11, 'edge_unseen', 0.03187, 0.05323),
  ('window', 11, 'headroom', -0.002615, 0.03003),
  ('window', 11, 'height', 1.52, 0.1254),
  ('window', 11, 'lift', -5.24, 0.1635),
  ('window', 11, 'rectangularity', 0.6795, 0.3082),
  ('window', 11, 'spread_length', 0.4285, 0.1487),
  ('window', 11, 'spread_width', 0.2111, 0.09586),
  ('window', 11, 'standoff', 0.01596, 0.00775),
  ('window', 11, 'tilt_deg', 89.89, 0.45),
  ('window', 11, 'wall_offset', -0.1657, 0.05416),
  ('window', 11, 'width', 0.04813, 0.1395),
  ('window', 11, 'z_max', 2.175, 0.1091),
  ('window', 11, 'z_min', 0.903, 0.04134);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 12, 0.08819, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 12, 'aspect', 0.3955, 0.3992),
  ('window', 12, 'behind', -0.005403, 0.03),
  ('window', 12, 'corner_offset', 1.874, 1.173),
  ('window', 12, 'edge_concave', 0.02016, 0.05992),
  ('window', 12, 'edge_convex', -0.0007624, 0.03005),
  ('window', 12, 'edge_free', 0.02045, 0.07037),
  ('window', 12, 'edge_free_top', -0.0005521, 0.03003),
  ('window', 12, 'edge_unseen', 0.1075, 0.0635),
  ('window', 12, 'headroom', 0.6504, 0.3203),
  ('window', 12, 'height', 1.441, 0.1394),
  ('window', 12, 'lift', -2.211, 0.3619),
  ('window', 12, 'rectangularity', 0.8523, 0.1005),
  ('window', 12, 'spread_length', -0.06221, 0.2624),
  ('window', 12, 'spread_width', -0.5185, 0.8755),
  ('window', 12, 'standoff', -0.01303, 0.01983),
  ('window', 12, 'tilt_deg', 89.65, 0.45),
  ('window', 12, 'wall_offset', -0.1262, 0.04684),
  ('window', 12, 'width', -0.2612, 0.4482),
  ('window', 12, 'z_max', 1.999, 0.3423),
  ('window', 12, 'z_min', 1.027, 0.08526);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 13, 0.05784, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 13, 'aspect', 0.942, 0.4597),
  ('window', 13, 'behind', -0.003196, 0.03),
  ('window', 13, 'corner_offset', 0.9313, 0.6142),
  ('window', 13, 'edge_concave', 0.2886, 0.3435),
  ('window', 13, 'edge_convex', -0.0001776, 0.03),
  ('window', 13, 'edge_free', 0.002589, 0.0319),
  ('window', 13, 'edge_free_top', 0.009513, 0.03055),
  ('window', 13, 'edge_unseen', 0.1239, 0.143),
  ('window', 13, 'headroom', 0.5329, 0.2996),
  ('window', 13, 'height', 1.104, 0.1598),
  ('window', 13, 'lift', -5.097, 0.5145),
  ('window', 13, 'rectangularity', 0.4551, 0.2007),
  ('window', 13, 'spread_length', 0.07546, 0.252),
  ('window', 13, 'spread_width', -1.379, 0.578),
  ('window', 13, 'standoff', 0.003576, 0.01762),
  ('window', 13, 'tilt_deg', 89.33, 0.5906),
  ('window', 13, 'wall_offset', -0.2104, 0.06019),
  ('window', 13, 'width', -1.041, 0.3339),
  ('window', 13, 'z_max', 1.584, 0.3517),
  ('window', 13, 'z_min', 0.8927, 0.04327);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 14, 0.06435, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 14, 'aspect', 0.8345, 0.2656),
  ('window', 14, 'behind', -0.004875, 0.03),
  ('window', 14, 'corner_offset', 1.309, 0.3965),
  ('window', 14, 'edge_concave', 0.3433, 0.2766),
  ('window', 14, 'edge_convex', -0.0002419, 0.03),
  ('window', 14, 'edge_free', 0.1745, 0.09271),
  ('window', 14, 'edge_free_top', 0.0009692, 0.03),
  ('window', 14, 'edge_unseen', 0.2465, 0.09587),
  ('window', 14, 'headroom', 0.2121, 0.3978),
  ('window', 14, 'height', 1.835, 0.174),
  ('window', 14, 'lift', -0.778, 0.5502),
  ('window', 14, 'rectangularity', 0.7589, 0.104),
  ('window', 14, 'spread_length', 0.112, 0.2043),
  ('window', 14, 'spread_width', -0.7467, 0.2737),
  ('window', 14, 'standoff', 0.01954, 0.00775),
  ('window', 14, 'tilt_deg', 89.79, 0.4509),
  ('window', 14, 'wall_offset', -0.1704, 0.07789),
  ('window', 14, 'width', -0.5412, 0.2207),
  ('window', 14, 'z_max', 2.187, 0.1358),
  ('window', 14, 'z_min', 1.499, 0.2602);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 15, 0.05618, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 15, 'aspect', 0.2104, 0.1555),
  ('window', 15, 'behind', -0.002231, 0.03),
  ('window', 15, 'corner_offset', 1.148, 0.1905),
  ('window', 15, 'edge_concave', 0.1497, 0.2135),
  ('window', 15, 'edge_convex', -0.0003759, 0.03001),
  ('window', 15, 'edge_free', 0.2102, 0.1704),
  ('window', 15, 'edge_free_top', 0.2348, 0.2556),
  ('window', 15, 'edge_unseen', 0.06337, 0.08138),
  ('window', 15, 'headroom', 0.1926, 0.2696),
  ('window', 15, 'height', 1.527, 0.1262),
  ('window', 15, 'lift', -3.1, 0.6884),
  ('window', 15, 'rectangularity', 0.7506, 0.2202),
  ('window', 15, 'spread_length', 0.3075, 0.2392),
  ('window', 15, 'spread_width', 0.04468, 0.2822),
  ('window', 15, 'standoff', 0.01985, 0.01087),
  ('window', 15, 'tilt_deg', 89.76, 0.45),
  ('window', 15, 'wall_offset', -0.1494, 0.05316),
  ('window', 15, 'width', 0.1347, 0.4306),
  ('window', 15, 'z_max', 2.264, 0.2189),
  ('window', 15, 'z_min', 1.023, 0.1347);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 16, 0.03082, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 16, 'aspect', 0.2482, 0.197),
  ('window', 16, 'behind', -0.001674, 0.03011),
  ('window', 16, 'corner_offset', 1.06, 0.1253),
  ('window', 16, 'edge_concave', 0.1331, 0.2394),
  ('window', 16, 'edge_convex', -9.732e-05, 0.03018),
  ('window', 16, 'edge_free', 0.005582, 0.0301),
  ('window', 16, 'edge_free_top', 0.003746, 0.03013),
  ('window', 16, 'edge_unseen', 0.2422, 0.1365),
  ('window', 16, 'headroom', 0.1481, 0.1549),
  ('window', 16, 'height', 1.368, 0.1557),
  ('window', 16, 'lift', -2.966, 1.118),
  ('window', 16, 'rectangularity', 0.6709, 0.228),
  ('window', 16, 'spread_length', 0.1133, 0.04268),
  ('window', 16, 'spread_width', -0.4109, 0.1359),
  ('window', 16, 'standoff', 0.01709, 0.00775),
  ('window', 16, 'tilt_deg', 89.77, 0.4516),
  ('window', 16, 'wall_offset', 2.25, 1.897),
  ('window', 16, 'width', -0.131, 0.188),
  ('window', 16, 'z_max', 2.045, 0.1078),
  ('window', 16, 'z_min', 0.9893, 0.0521);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 17, 0.0354, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 17, 'aspect', 0.6881, 0.5891),
  ('window', 17, 'behind', -0.005002, 0.03),
  ('window', 17, 'corner_offset', 1.452, 1.193),
  ('window', 17, 'edge_concave', 0.08805, 0.3248),
  ('window', 17, 'edge_convex', -0.0001423, 0.03004),
  ('window', 17, 'edge_free', -0.0005658, 0.03002),
  ('window', 17, 'edge_free_top', 0.003697, 0.03373),
  ('window', 17, 'edge_unseen', 0.3667, 0.1193),
  ('window', 17, 'headroom', 0.4903, 0.1671),
  ('window', 17, 'height', 1.325, 0.2058),
  ('window', 17, 'lift', -3.429, 0.7248),
  ('window', 17, 'rectangularity', 0.7778, 0.1142),
  ('window', 17, 'spread_length', -0.2747, 0.3743),
  ('window', 17, 'spread_width', -1.556, 0.6648),
  ('window', 17, 'standoff', 0.01141, 0.00775),
  ('window', 17, 'tilt_deg', 88.67, 0.4513),
  ('window', 17, 'wall_offset', 3.185, 0.3587),
  ('window', 17, 'width', -1.085, 0.3478),
  ('window', 17, 'z_max', 1.751, 0.3015),
  ('window', 17, 'z_min', 0.9167, 0.05927);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 18, 0.02682, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 18, 'aspect', 0.3416, 0.2158),
  ('window', 18, 'behind', -0.00302, 0.03002),
  ('window', 18, 'corner_offset', 2.209, 0.7699),
  ('window', 18, 'edge_concave', 0.004312, 0.03),
  ('window', 18, 'edge_convex', -5.447e-05, 0.03),
  ('window', 18, 'edge_free', 0.2731, 0.09782),
  ('window', 18, 'edge_free_top', 0.3316, 0.2769),
  ('window', 18, 'edge_unseen', 0.05945, 0.09856),
  ('window', 18, 'headroom', 0.5676, 0.3739),
  ('window', 18, 'height', 1.44, 0.04793),
  ('window', 18, 'lift', -2.131, 0.5112),
  ('window', 18, 'rectangularity', 0.8873, 0.04952),
  ('window', 18, 'spread_length', -0.1291, 0.1842),
  ('window', 18, 'spread_width', -0.4778, 0.174),
  ('window', 18, 'standoff', -0.01286, 0.00775),
  ('window', 18, 'tilt_deg', 89.85, 0.4502),
  ('window', 18, 'wall_offset', -0.08879, 0.1685),
  ('window', 18, 'width', -0.4112, 0.2027),
  ('window', 18, 'z_max', 1.964, 0.08897),
  ('window', 18, 'z_min', 1.032, 0.05247);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 19, 0.02363, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 19, 'aspect', 0.5361, 0.591),
  ('window', 19, 'behind', -0.003435, 0.03),
  ('window', 19, 'corner_offset', 1.258, 1.158),
  ('window', 19, 'edge_concave', 0.1642, 0.2349),
  ('window', 19, 'edge_convex', -0.0005068, 0.03006),
  ('window', 19, 'edge_free', 0.2425, 0.08052),
  ('window', 19, 'edge_free_top', 0.01318, 0.0398),
  ('window', 19, 'edge_unseen', 0.2585, 0.07909),
  ('window', 19, 'headroom', 0.08695, 0.0419),
  ('window', 19, 'height', 1.888, 0.131),
  ('window', 19, 'lift', -0.5674, 0.5181),
  ('window', 19, 'rectangularity', 0.7729, 0.0309),
  ('window', 19, 'spread_length', -0.4048, 0.2924),
  ('window', 19, 'spread_width', -1.073, 0.5782),
  ('window', 19, 'standoff', 0.01395, 0.007833),
  ('window', 19, 'tilt_deg', 89.07, 1.264),
  ('window', 19, 'wall_offset', 2.149, 2.264),
  ('window', 19, 'width', -0.8047, 0.4948),
  ('window', 19, 'z_max', 2.163, 0.1228),
  ('window', 19, 'z_min', 1.655, 0.213);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 20, 0.01801, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 20, 'aspect', 1.288, 0.2171),
  ('window', 20, 'behind', 0.1181, 0.2222),
  ('window', 20, 'corner_offset', 0.5873, 0.5657),
  ('window', 20, 'edge_concave', 0.2661, 0.2751),
  ('window', 20, 'edge_convex', -0.0004179, 0.03104),
  ('window', 20, 'edge_free', 0.3788, 0.1022),
  ('window', 20, 'edge_free_top', 0.4751, 0.2338),
  ('window', 20, 'edge_unseen', 0.07567, 0.07862),
  ('window', 20, 'headroom', 0.5321, 0.1566),
  ('window', 20, 'height', 1.338, 0.1354),
  ('window', 20, 'lift', -4.161, 1.588),
  ('window', 20, 'rectangularity', 0.6684, 0.1288),
  ('window', 20, 'spread_length', -0.09963, 0.2912),
  ('window', 20, 'spread_width', -1.708, 0.501),
  ('window', 20, 'standoff', 0.02199, 0.05017),
  ('window', 20, 'tilt_deg', 89.64, 0.4501),
  ('window', 20, 'wall_offset', 2.811, 2.092),
  ('window', 20, 'width', -1.365, 0.2934),
  ('window', 20, 'z_max', 1.735, 0.2636),
  ('window', 20, 'z_min', 0.9645, 0.05181);

-- whiteboard: 507 examples
UPDATE object_class SET prior = 0.01496 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4311, 0.3078)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.008271, 0.05697)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'corner_offset', 1.664, 0.9484)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_concave', 0.05721, 0.1065)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_convex', 0.0001735, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.02728, 0.046)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.03504, 0.06768)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_unseen', 0.154, 0.1883)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'headroom', 0.7641, 0.2997)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.402, 0.1462)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'lift', -2.359, 1.179)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.8258, 0.09658)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.2204, 0.4044)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.2987, 0.4365)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'standoff', 0.04049, 0.1499)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.82, 0.5002)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'wall_offset', 0.3523, 1.088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', -0.07847, 0.4356)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 1.957, 0.2314)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.8786, 0.1386)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'whiteboard';
DELETE FROM class_density WHERE class = 'whiteboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.06085, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'aspect', 0.325, 0.3084),
  ('whiteboard', 1, 'behind', 0.0007891, 0.03003),
  ('whiteboard', 1, 'corner_offset', 1.966, 0.4758),
  ('whiteboard', 1, 'edge_concave', 0.0133, 0.0643),
  ('whiteboard', 1, 'edge_convex', -0.0001681, 0.06238),
  ('whiteboard', 1, 'edge_free', 0.0197, 0.03),
  ('whiteboard', 1, 'edge_free_top', 0.02656, 0.03032),
  ('whiteboard', 1, 'edge_unseen', -0.0006735, 0.03),
  ('whiteboard', 1, 'headroom', 0.7676, 0.2198),
  ('whiteboard', 1, 'height', 1.485, 0.03556),
  ('whiteboard', 1, 'lift', -1.709, 0.4303),
  ('whiteboard', 1, 'rectangularity', 0.8988, 0.05652),
  ('whiteboard', 1, 'spread_length', 0.4642, 0.1895),
  ('whiteboard', 1, 'spread_width', -0.07627, 0.1131),
  ('whiteboard', 1, 'standoff', 0.01984, 0.01188),
  ('whiteboard', 1, 'tilt_deg', 90.17, 0.45),
  ('whiteboard', 1, 'wall_offset', 0.05797, 0.04),
  ('whiteboard', 1, 'width', 0.1217, 0.04882),
  ('whiteboard', 1, 'z_max', 2.054, 0.07584),
  ('whiteboard', 1, 'z_min', 0.9647, 0.0413);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.09304, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'aspect', 0.5962, 0.3226),
  ('whiteboard', 2, 'behind', -0.008581, 0.03005),
  ('whiteboard', 2, 'corner_offset', 1.209, 0.9462),
  ('whiteboard', 2, 'edge_concave', 0.01873, 0.07019),
  ('whiteboard', 2, 'edge_convex', -0.0004994, 0.03739),
  ('whiteboard', 2, 'edge_free', 0.02673, 0.03005),
  ('whiteboard', 2, 'edge_free_top', 0.01141, 0.03011),
  ('whiteboard', 2, 'edge_unseen', 0.4891, 0.1587),
  ('whiteboard', 2, 'headroom', 0.782, 0.2132),
  ('whiteboard', 2, 'height', 1.289, 0.08068),
  ('whiteboard', 2, 'lift', -2.128, 0.4378),
  ('whiteboard', 2, 'rectangularity', 0.7965, 0.05328),
  ('whiteboard', 2, 'spread_length', 0.01932, 0.3237),
  ('whiteboard', 2, 'spread_width', -0.4712, 0.1397),
  ('whiteboard', 2, 'standoff', 0.03635, 0.01249),
  ('whiteboard', 2, 'tilt_deg', 90, 0.4516),
  ('whiteboard', 2, 'wall_offset', 0.05564, 0.04),
  ('whiteboard', 2, 'width', -0.0264, 0.2072),
  ('whiteboard', 2, 'z_max', 1.952, 0.09863),
  ('whiteboard', 2, 'z_min', 0.8617, 0.0469);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.1236, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'aspect', 0.5958, 0.1605),
  ('whiteboard', 3, 'behind', -0.0009455, 0.03),
  ('whiteboard', 3, 'corner_offset', 1.794, 0.6188),
  ('whiteboard', 3, 'edge_concave', 0.174, 0.05668),
  ('whiteboard', 3, 'edge_convex', -0.0004024, 0.03185),
  ('whiteboard', 3, 'edge_free', 0.02714, 0.03),
  ('whiteboard', 3, 'edge_free_top', 0.02907, 0.0307),
  ('whiteboard', 3, 'edge_unseen', 0.1857, 0.06714),
  ('whiteboard', 3, 'headroom', 0.6804, 0.1666),
  ('whiteboard', 3, 'height', 1.417, 0.06898),
  ('whiteboard', 3, 'lift', -2.151, 0.7679),
  ('whiteboard', 3, 'rectangularity', 0.7511, 0.09121),
  ('whiteboard', 3, 'spread_length', 0.5213, 0.0777),
  ('whiteboard', 3, 'spread_width', -0.2328, 0.0985),
  ('whiteboard', 3, 'standoff', 0.03748, 0.01087),
  ('whiteboard', 3, 'tilt_deg', 90.01, 0.45),
  ('whiteboard', 3, 'wall_offset', 0.05354, 0.04),
  ('whiteboard', 3, 'width', 0.218, 0.04545),
  ('whiteboard', 3, 'z_max', 2.106, 0.09666),
  ('whiteboard', 3, 'z_min', 0.9029, 0.06188);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.02168, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'aspect', 0.2573, 0.2951),
  ('whiteboard', 4, 'behind', -0.00206, 0.03),
  ('whiteboard', 4, 'corner_offset', 1.017, 0.3332),
  ('whiteboard', 4, 'edge_concave', 0.1297, 0.2101),
  ('whiteboard', 4, 'edge_convex', -0.003361, 0.03051),
  ('whiteboard', 4, 'edge_free', 0.01772, 0.03005),
  ('whiteboard', 4, 'edge_free_top', 0.0518, 0.0303),
  ('whiteboard', 4, 'edge_unseen', 0.2791, 0.07053),
  ('whiteboard', 4, 'headroom', 0.453, 0.142),
  ('whiteboard', 4, 'height', 1.359, 0.03893),
  ('whiteboard', 4, 'lift', -3.578, 1.484),
  ('whiteboard', 4, 'rectangularity', 0.5718, 0.03478),
  ('whiteboard', 4, 'spread_length', 0.2003, 0.3535),
  ('whiteboard', 4, 'spread_width', -0.6028, 0.2535),
  ('whiteboard', 4, 'standoff', 0.0299, 0.04355),
  ('whiteboard', 4, 'tilt_deg', 89.89, 0.4509),
  ('whiteboard', 4, 'wall_offset', 3.559, 0.8536),
  ('whiteboard', 4, 'width', -0.003134, 0.4845),
  ('whiteboard', 4, 'z_max', 2.008, 0.08931),
  ('whiteboard', 4, 'z_min', 0.7966, 0.1222);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.02619, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'aspect', 0.5844, 0.1194),
  ('whiteboard', 5, 'behind', -0.01006, 0.03),
  ('whiteboard', 5, 'corner_offset', 2.51, 0.5674),
  ('whiteboard', 5, 'edge_concave', 0.01724, 0.05558),
  ('whiteboard', 5, 'edge_convex', -0.000552, 0.06307),
  ('whiteboard', 5, 'edge_free', -0.01991, 0.03),
  ('whiteboard', 5, 'edge_free_top', -0.002925, 0.03),
  ('whiteboard', 5, 'edge_unseen', 0.4099, 0.1304),
  ('whiteboard', 5, 'headroom', 0.7544, 0.05655),
  ('whiteboard', 5, 'height', 1.313, 0.07267),
  ('whiteboard', 5, 'lift', -1.914, 0.1865),
  ('whiteboard', 5, 'rectangularity', 0.7065, 0.07461),
  ('whiteboard', 5, 'spread_length', -0.7391, 0.2653),
  ('whiteboard', 5, 'spread_width', -1.163, 0.254),
  ('whiteboard', 5, 'standoff', 0.05049, 0.00775),
  ('whiteboard', 5, 'tilt_deg', 89.83, 0.4505),
  ('whiteboard', 5, 'wall_offset', 0.04662, 0.05971),
  ('whiteboard', 5, 'width', -0.9951, 0.168),
  ('whiteboard', 5, 'z_max', 1.691, 0.1863),
  ('whiteboard', 5, 'z_min', 0.9824, 0.05382);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.1025, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'aspect', 0.753, 0.5195),
  ('whiteboard', 6, 'behind', -0.00296, 0.03007),
  ('whiteboard', 6, 'corner_offset', 0.2051, 2.127),
  ('whiteboard', 6, 'edge_concave', 0.01946, 0.04807),
  ('whiteboard', 6, 'edge_convex', -0.0005321, 0.03005),
  ('whiteboard', 6, 'edge_free', 0.04011, 0.05911),
  ('whiteboard', 6, 'edge_free_top', 0.09289, 0.03119),
  ('whiteboard', 6, 'edge_unseen', 0.389, 0.06229),
  ('whiteboard', 6, 'headroom', 1.683, 0.1243),
  ('whiteboard', 6, 'height', 0.9221, 0.2083),
  ('whiteboard', 6, 'lift', -3.408, 1.362),
  ('whiteboard', 6, 'rectangularity', 0.8062, 0.06346),
  ('whiteboard', 6, 'spread_length', 0.297, 0.3164),
  ('whiteboard', 6, 'spread_width', -0.583, 0.379),
  ('whiteboard', 6, 'standoff', 0.03889, 0.009838),
  ('whiteboard', 6, 'tilt_deg', 87.88, 0.45),
  ('whiteboard', 6, 'wall_offset', 0.04046, 0.04008),
  ('whiteboard', 6, 'width', -0.3815, 0.299),
  ('whiteboard', 6, 'z_max', 1.158, 0.1932),
  ('whiteboard', 6, 'z_min', 0.6737, 0.32);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.02119, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'aspect', 0.4659, 0.341),
  ('whiteboard', 7, 'behind', -0.0007091, 0.03),
  ('whiteboard', 7, 'corner_offset', 1.483, 0.6033),
  ('whiteboard', 7, 'edge_concave', 0.1261, 0.03858),
  ('whiteboard', 7, 'edge_convex', -0.0006485, 0.03001),
  ('whiteboard', 7, 'edge_free', 0.07717, 0.03271),
  ('whiteboard', 7, 'edge_free_top', 0.1216, 0.04365),
  ('whiteboard', 7, 'edge_unseen', 0.02807, 0.05946),
  ('whiteboard', 7, 'headroom', 0.8279, 0.2273),
  ('whiteboard', 7, 'height', 1.424, 0.05554),
  ('whiteboard', 7, 'lift', -4.737, 0.7341),
  ('whiteboard', 7, 'rectangularity', 0.8309, 0.05839),
  ('whiteboard', 7, 'spread_length', 0.4764, 0.2478),
  ('whiteboard', 7, 'spread_width', -0.0578, 0.1813),
  ('whiteboard', 7, 'standoff', 0.0285, 0.02571),
  ('whiteboard', 7, 'tilt_deg', 89.92, 0.45),
  ('whiteboard', 7, 'wall_offset', 0.05605, 0.04),
  ('whiteboard', 7, 'width', 0.1875, 0.0858),
  ('whiteboard', 7, 'z_max', 2.002, 0.06809),
  ('whiteboard', 7, 'z_min', 0.8334, 0.08411);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.02215, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'aspect', 0.2755, 0.1541),
  ('whiteboard', 8, 'behind', 0.2189, 0.227),
  ('whiteboard', 8, 'corner_offset', 0.5299, 0.7933),
  ('whiteboard', 8, 'edge_concave', 0.1208, 0.1033),
  ('whiteboard', 8, 'edge_convex', 0.05228, 0.08845),
  ('whiteboard', 8, 'edge_free', 0.01715, 0.03),
  ('whiteboard', 8, 'edge_free_top', 0.009399, 0.03),
  ('whiteboard', 8, 'edge_unseen', 0.02989, 0.04417),
  ('whiteboard', 8, 'headroom', 0.6699, 0.12),
  ('whiteboard', 8, 'height', 1.466, 0.07137),
  ('whiteboard', 8, 'lift', -1.881, 0.3079),
  ('whiteboard', 8, 'rectangularity', 0.8689, 0.0681),
  ('whiteboard', 8, 'spread_length', 0.3385, 0.1396),
  ('whiteboard', 8, 'spread_width', -0.01547, 0.06431),
  ('whiteboard', 8, 'standoff', 0.5421, 0.4452),
  ('whiteboard', 8, 'tilt_deg', 90.01, 0.45),
  ('whiteboard', 8, 'wall_offset', 2.601, 1.527),
  ('whiteboard', 8, 'width', 0.137, 0.05432),
  ('whiteboard', 8, 'z_max', 2.037, 0.08568),
  ('whiteboard', 8, 'z_min', 0.8952, 0.08067);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 9, 0.003763, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 9, 'aspect', 0.3112, 0.1159),
  ('whiteboard', 9, 'behind', 0.001049, 0.03299),
  ('whiteboard', 9, 'corner_offset', 2.62, 0.7082),
  ('whiteboard', 9, 'edge_concave', 0.01532, 0.03052),
  ('whiteboard', 9, 'edge_convex', 0.0003073, 0.03106),
  ('whiteboard', 9, 'edge_free', 0.371, 0.2156),
  ('whiteboard', 9, 'edge_free_top', 0.3965, 0.1456),
  ('whiteboard', 9, 'edge_unseen', 0.1465, 0.1023),
  ('whiteboard', 9, 'headroom', 0.8665, 0.1419),
  ('whiteboard', 9, 'height', 1.39, 0.04067),
  ('whiteboard', 9, 'lift', -2.59, 0.3258),
  ('whiteboard', 9, 'rectangularity', 0.7571, 0.06169),
  ('whiteboard', 9, 'spread_length', 0.1586, 0.1219),
  ('whiteboard', 9, 'spread_width', -0.3478, 0.1093),
  ('whiteboard', 9, 'standoff', 0.05046, 0.04303),
  ('whiteboard', 9, 'tilt_deg', 89.92, 0.4789),
  ('whiteboard', 9, 'wall_offset', 0.1238, 0.2027),
  ('whiteboard', 9, 'width', 0.01426, 0.1318),
  ('whiteboard', 9, 'z_max', 1.916, 0.05401),
  ('whiteboard', 9, 'z_min', 0.835, 0.02317);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 10, 0.08373, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 10, 'aspect', 0.5163, 0.2909),
  ('whiteboard', 10, 'behind', -0.001995, 0.03001),
  ('whiteboard', 10, 'corner_offset', 1.641, 0.5616),
  ('whiteboard', 10, 'edge_concave', 0.1194, 0.05973),
  ('whiteboard', 10, 'edge_convex', -0.0007686, 0.04318),
  ('whiteboard', 10, 'edge_free', 0.02026, 0.03001),
  ('whiteboard', 10, 'edge_free_top', 0.06555, 0.03),
  ('whiteboard', 10, 'edge_unseen', -0.002038, 0.04227),
  ('whiteboard', 10, 'headroom', 0.6379, 0.224),
  ('whiteboard', 10, 'height', 1.469, 0.05678),
  ('whiteboard', 10, 'lift', -2.398, 1.497),
  ('whiteboard', 10, 'rectangularity', 0.8316, 0.05684),
  ('whiteboard', 10, 'spread_length', 0.4523, 0.1673),
  ('whiteboard', 10, 'spread_width', -0.08134, 0.08601),
  ('whiteboard', 10, 'standoff', 0.02579, 0.0175),
  ('whiteboard', 10, 'tilt_deg', 90.17, 0.45),
  ('whiteboard', 10, 'wall_offset', 0.05632, 0.04),
  ('whiteboard', 10, 'width', 0.1794, 0.05086),
  ('whiteboard', 10, 'z_max', 2.041, 0.07769),
  ('whiteboard', 10, 'z_min', 0.9115, 0.05723);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 11, 0.07659, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 11, 'aspect', 0.3593, 0.1705),
  ('whiteboard', 11, 'behind', -0.001699, 0.03),
  ('whiteboard', 11, 'corner_offset', 2.304, 0.8984),
  ('whiteboard', 11, 'edge_concave', 0.04943, 0.1227),
  ('whiteboard', 11, 'edge_convex', -0.000114, 0.03),
  ('whiteboard', 11, 'edge_free', 0.02858, 0.03283),
  ('whiteboard', 11, 'edge_free_top', 0.04488, 0.03011),
  ('whiteboard', 11, 'edge_unseen', 0.1953, 0.1622),
  ('whiteboard', 11, 'headroom', 0.9125, 0.2818),
  ('whiteboard', 11, 'height', 1.329, 0.02835),
  ('whiteboard', 11, 'lift', -2.294, 0.7199),
  ('whiteboard', 11, 'rectangularity', 0.8242, 0.1048),
  ('whiteboard', 11, 'spread_length', 0.175, 0.1798),
  ('whiteboard', 11, 'spread_width', -0.3318, 0.1168),
  ('whiteboard', 11, 'standoff', 0.02246, 0.008326),
  ('whiteboard', 11, 'tilt_deg', 90.09, 0.45),
  ('whiteboard', 11, 'wall_offset', 0.07002, 0.04),
  ('whiteboard', 11, 'width', 0.03798, 0.03718),
  ('whiteboard', 11, 'z_max', 1.892, 0.03903),
  ('whiteboard', 11, 'z_min', 0.8592, 0.05682);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 12, 0.09557, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 12, 'aspect', 0.4555, 0.3754),
  ('whiteboard', 12, 'behind', -0.003401, 0.03),
  ('whiteboard', 12, 'corner_offset', 1.155, 0.491),
  ('whiteboard', 12, 'edge_concave', 0.281, 0.05826),
  ('whiteboard', 12, 'edge_convex', -0.0002095, 0.03003),
  ('whiteboard', 12, 'edge_free', 0.00741, 0.03003),
  ('whiteboard', 12, 'edge_free_top', 0.01841, 0.03),
  ('whiteboard', 12, 'edge_unseen', 0.3316, 0.117),
  ('whiteboard', 12, 'headroom', 0.9065, 0.3019),
  ('whiteboard', 12, 'height', 1.371, 0.1138),
  ('whiteboard', 12, 'lift', -5.219, 0.254),
  ('whiteboard', 12, 'rectangularity', 0.7294, 0.04789),
  ('whiteboard', 12, 'spread_length', 0.5875, 0.1273),
  ('whiteboard', 12, 'spread_width', -0.07895, 0.2219),
  ('whiteboard', 12, 'standoff', 0.02381, 0.007831),
  ('whiteboard', 12, 'tilt_deg', 89.42, 0.7483),
  ('whiteboard', 12, 'wall_offset', 0.1053, 0.04009),
  ('whiteboard', 12, 'width', 0.2737, 0.1762),
  ('whiteboard', 12, 'z_max', 1.887, 0.1454),
  ('whiteboard', 12, 'z_min', 0.7146, 0.03766);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 13, 0.04997, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 13, 'aspect', 0.458, 0.1528),
  ('whiteboard', 13, 'behind', -0.002591, 0.03),
  ('whiteboard', 13, 'corner_offset', 1.998, 0.2107),
  ('whiteboard', 13, 'edge_concave', 0.1351, 0.07762),
  ('whiteboard', 13, 'edge_convex', -5.755e-05, 0.03),
  ('whiteboard', 13, 'edge_free', 0.01648, 0.03),
  ('whiteboard', 13, 'edge_free_top', 0.007937, 0.03),
  ('whiteboard', 13, 'edge_unseen', 0.351, 0.1426),
  ('whiteboard', 13, 'headroom', 0.4016, 0.1187),
  ('whiteboard', 13, 'height', 1.348, 0.05282),
  ('whiteboard', 13, 'lift', -3.805, 1.472),
  ('whiteboard', 13, 'rectangularity', 0.753, 0.06476),
  ('whiteboard', 13, 'spread_length', 0.3568, 0.185),
  ('whiteboard', 13, 'spread_width', -0.3246, 0.09238),
  ('whiteboard', 13, 'standoff', 0.01988, 0.008173),
  ('whiteboard', 13, 'tilt_deg', 89.97, 0.45),
  ('whiteboard', 13, 'wall_offset', 3.706, 0.5483),
  ('whiteboard', 13, 'width', 0.1238, 0.06805),
  ('whiteboard', 13, 'z_max', 1.992, 0.07921),
  ('whiteboard', 13, 'z_min', 0.9217, 0.03578);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 14, 0.04307, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 14, 'aspect', 0.781, 0.05055),
  ('whiteboard', 14, 'behind', 0.06684, 0.08372),
  ('whiteboard', 14, 'corner_offset', 2.133, 0.3684),
  ('whiteboard', 14, 'edge_concave', 0.08439, 0.07714),
  ('whiteboard', 14, 'edge_convex', -0.0002843, 0.03),
  ('whiteboard', 14, 'edge_free', 0.06258, 0.09339),
  ('whiteboard', 14, 'edge_free_top', 0.02324, 0.03002),
  ('whiteboard', 14, 'edge_unseen', 0.3725, 0.1543),
  ('whiteboard', 14, 'headroom', 0.7341, 0.0815),
  ('whiteboard', 14, 'height', 1.154, 0.1165),
  ('whiteboard', 14, 'lift', -3.833, 1.27),
  ('whiteboard', 14, 'rectangularity', 0.8775, 0.03426),
  ('whiteboard', 14, 'spread_length', 0.2416, 0.1313),
  ('whiteboard', 14, 'spread_width', -0.5024, 0.1852),
  ('whiteboard', 14, 'standoff', 0.02381, 0.00775),
  ('whiteboard', 14, 'tilt_deg', 85.92, 4.923),
  ('whiteboard', 14, 'wall_offset', 0.7158, 0.2701),
  ('whiteboard', 14, 'width', -0.4125, 0.218),
  ('whiteboard', 14, 'z_max', 1.461, 0.1263),
  ('whiteboard', 14, 'z_min', 0.7763, 0.08488);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 15, 0.06948, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 15, 'aspect', 1.193, 0.3021),
  ('whiteboard', 15, 'behind', -0.003466, 0.03),
  ('whiteboard', 15, 'corner_offset', 0.4059, 0.2059),
  ('whiteboard', 15, 'edge_concave', 0.04734, 0.1732),
  ('whiteboard', 15, 'edge_convex', -0.0001239, 0.03004),
  ('whiteboard', 15, 'edge_free', 0.006599, 0.03002),
  ('whiteboard', 15, 'edge_free_top', 0.005152, 0.03171),
  ('whiteboard', 15, 'edge_unseen', 0.3743, 0.1575),
  ('whiteboard', 15, 'headroom', 1.29, 0.1299),
  ('whiteboard', 15, 'height', 1.209, 0.4496),
  ('whiteboard', 15, 'lift', -1.982, 0.7628),
  ('whiteboard', 15, 'rectangularity', 0.736, 0.08119),
  ('whiteboard', 15, 'spread_length', 0.2019, 0.1982),
  ('whiteboard', 15, 'spread_width', -1.14, 0.4741),
  ('whiteboard', 15, 'standoff', 0.02036, 0.008915),
  ('whiteboard', 15, 'tilt_deg', 89.43, 0.4771),
  ('whiteboard', 15, 'wall_offset', -1.188, 0.2729),
  ('whiteboard', 15, 'width', -0.9451, 0.5583),
  ('whiteboard', 15, 'z_max', 1.283, 0.3211),
  ('whiteboard', 15, 'z_min', 0.8752, 0.04581);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 16, 0.01292, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 16, 'aspect', 0.6364, 0.0431),
  ('whiteboard', 16, 'behind', -0.001927, 0.03005),
  ('whiteboard', 16, 'corner_offset', 2.444, 0.5243),
  ('whiteboard', 16, 'edge_concave', 0.0235, 0.0517),
  ('whiteboard', 16, 'edge_convex', -0.0001175, 0.04238),
  ('whiteboard', 16, 'edge_free', 0.006468, 0.03039),
  ('whiteboard', 16, 'edge_free_top', 0.03641, 0.04923),
  ('whiteboard', 16, 'edge_unseen', 0.2886, 0.1032),
  ('whiteboard', 16, 'headroom', 0.4971, 0.05048),
  ('whiteboard', 16, 'height', 1.473, 0.1153),
  ('whiteboard', 16, 'lift', -2.371, 1.865),
  ('whiteboard', 16, 'rectangularity', 0.7204, 0.03001),
  ('whiteboard', 16, 'spread_length', -0.5399, 0.3303),
  ('whiteboard', 16, 'spread_width', -1.223, 0.318),
  ('whiteboard', 16, 'standoff', 0.01539, 0.00775),
  ('whiteboard', 16, 'tilt_deg', 89.82, 0.5484),
  ('whiteboard', 16, 'wall_offset', 1.832, 2.864),
  ('whiteboard', 16, 'width', -0.9688, 0.3214),
  ('whiteboard', 16, 'z_max', 1.928, 0.2125),
  ('whiteboard', 16, 'z_min', 1.145, 0.113);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 17, 0.03343, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 17, 'aspect', 0.4387, 0.4433),
  ('whiteboard', 17, 'behind', -0.005193, 0.03),
  ('whiteboard', 17, 'corner_offset', 1.621, 0.2777),
  ('whiteboard', 17, 'edge_concave', 0.04597, 0.05996),
  ('whiteboard', 17, 'edge_convex', 9.143e-05, 0.04741),
  ('whiteboard', 17, 'edge_free', 0.185, 0.04508),
  ('whiteboard', 17, 'edge_free_top', 0.2573, 0.09035),
  ('whiteboard', 17, 'edge_unseen', 0.03981, 0.052),
  ('whiteboard', 17, 'headroom', 0.6632, 0.4077),
  ('whiteboard', 17, 'height', 1.499, 0.08685),
  ('whiteboard', 17, 'lift', -1.658, 0.3871),
  ('whiteboard', 17, 'rectangularity', 0.6568, 0.04082),
  ('whiteboard', 17, 'spread_length', 0.5703, 0.3033),
  ('whiteboard', 17, 'spread_width', -0.2034, 0.2219),
  ('whiteboard', 17, 'standoff', 0.02741, 0.00775),
  ('whiteboard', 17, 'tilt_deg', 89.92, 0.45),
  ('whiteboard', 17, 'wall_offset', 0.0343, 0.05362),
  ('whiteboard', 17, 'width', 0.3062, 0.1418),
  ('whiteboard', 17, 'z_max', 2.165, 0.02694),
  ('whiteboard', 17, 'z_min', 0.7868, 0.1155);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 18, 0.01024, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 18, 'aspect', 0.2786, 0.1163),
  ('whiteboard', 18, 'behind', 0.1445, 0.1737),
  ('whiteboard', 18, 'corner_offset', 0.1996, 0.43),
  ('whiteboard', 18, 'edge_concave', 0.1824, 0.09725),
  ('whiteboard', 18, 'edge_convex', 0.04049, 0.07228),
  ('whiteboard', 18, 'edge_free', 0.03812, 0.03708),
  ('whiteboard', 18, 'edge_free_top', 0.04843, 0.06358),
  ('whiteboard', 18, 'edge_unseen', 0.01527, 0.03068),
  ('whiteboard', 18, 'headroom', 0.8635, 0.198),
  ('whiteboard', 18, 'height', 1.454, 0.03442),
  ('whiteboard', 18, 'lift', -1.747, 0.846),
  ('whiteboard', 18, 'rectangularity', 0.9051, 0.0452),
  ('whiteboard', 18, 'spread_length', 0.2739, 0.1061),
  ('whiteboard', 18, 'spread_width', -0.04182, 0.07954),
  ('whiteboard', 18, 'standoff', 0.01924, 0.007784),
  ('whiteboard', 18, 'tilt_deg', 89.93, 0.5233),
  ('whiteboard', 18, 'wall_offset', 2.766, 1.542),
  ('whiteboard', 18, 'width', 0.08531, 0.05977),
  ('whiteboard', 18, 'z_max', 1.996, 0.05895),
  ('whiteboard', 18, 'z_min', 0.896, 0.03432);

-- shelf: 2835 examples
UPDATE object_class SET prior = 0.07594 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.9224, 0.4398)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5548, 0.3281)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'corner_offset', 0.5743, 0.8469)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_concave', 0.4972, 0.1948)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_convex', 0.03036, 0.07135)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3094, 0.1816)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4255, 0.3441)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_unseen', 0.05098, 0.1078)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'headroom', 0.5713, 0.7169)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.8915, 0.5008)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'lift', -2.631, 2.031)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6931, 0.1295)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.2869, 0.5067)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.285, 0.4043)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'standoff', 0.6631, 0.4548)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 45.21, 44.21)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'wall_offset', 1.15, 1.052)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.079, 0.375)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.147, 0.6325)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5959, 0.5779)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'shelf';
DELETE FROM class_density WHERE class = 'shelf';
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.04567, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'aspect', 0.8892, 0.1066),
  ('shelf', 1, 'behind', 0.632, 0.1821),
  ('shelf', 1, 'corner_offset', 2.944, 1.183),
  ('shelf', 1, 'edge_concave', 0.1899, 0.1755),
  ('shelf', 1, 'edge_convex', 0.1639, 0.03106),
  ('shelf', 1, 'edge_free', 0.5743, 0.3184),
  ('shelf', 1, 'edge_free_top', 0.5773, 0.3748),
  ('shelf', 1, 'edge_unseen', 0.3621, 0.07985),
  ('shelf', 1, 'headroom', 0.2604, 0.6302),
  ('shelf', 1, 'height', 1.245, 0.1786),
  ('shelf', 1, 'lift', -3.519, 1.132),
  ('shelf', 1, 'rectangularity', 0.7201, 0.1173),
  ('shelf', 1, 'spread_length', -0.1449, 0.3822),
  ('shelf', 1, 'spread_width', -1.308, 0.1702),
  ('shelf', 1, 'standoff', 0.8193, 0.1173),
  ('shelf', 1, 'tilt_deg', 90.14, 0.45),
  ('shelf', 1, 'wall_offset', 1.754, 0.6865),
  ('shelf', 1, 'width', -1.078, 0.0928),
  ('shelf', 1, 'z_max', 1.7, 0.1746),
  ('shelf', 1, 'z_min', 0.4048, 0.4057);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.1056, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'aspect', 1.132, 0.4923),
  ('shelf', 2, 'behind', 0.7918, 0.1292),
  ('shelf', 2, 'corner_offset', 0.2447, 0.04002),
  ('shelf', 2, 'edge_concave', 0.4231, 0.1609),
  ('shelf', 2, 'edge_convex', 0.07099, 0.08014),
  ('shelf', 2, 'edge_free', 0.3772, 0.08864),
  ('shelf', 2, 'edge_free_top', 0.4511, 0.3682),
  ('shelf', 2, 'edge_unseen', 0.04373, 0.07457),
  ('shelf', 2, 'headroom', -0.3371, 0.2208),
  ('shelf', 2, 'height', 1.087, 0.1712),
  ('shelf', 2, 'lift', -4.858, 1.836),
  ('shelf', 2, 'rectangularity', 0.7972, 0.08881),
  ('shelf', 2, 'spread_length', -0.2432, 0.4167),
  ('shelf', 2, 'spread_width', -1.154, 0.1615),
  ('shelf', 2, 'standoff', 0.6578, 0.4561),
  ('shelf', 2, 'tilt_deg', 89.94, 0.4506),
  ('shelf', 2, 'wall_offset', 1.244, 1.029),
  ('shelf', 2, 'width', -0.9409, 0.1372),
  ('shelf', 2, 'z_max', 1.74, 0.2617),
  ('shelf', 2, 'z_min', 0.3201, 0.2755);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.06013, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'aspect', 0.8478, 0.202),
  ('shelf', 3, 'behind', 0.7383, 0.1146),
  ('shelf', 3, 'corner_offset', 0.3271, 0.2652),
  ('shelf', 3, 'edge_concave', 0.5938, 0.1525),
  ('shelf', 3, 'edge_convex', 0.03542, 0.07538),
  ('shelf', 3, 'edge_free', 0.2626, 0.1481),
  ('shelf', 3, 'edge_free_top', 0.4233, 0.1033),
  ('shelf', 3, 'edge_unseen', 0.01248, 0.04044),
  ('shelf', 3, 'headroom', 0.671, 0.2018),
  ('shelf', 3, 'height', 1.635, 0.2376),
  ('shelf', 3, 'lift', -0.7516, 0.3942),
  ('shelf', 3, 'rectangularity', 0.7944, 0.1074),
  ('shelf', 3, 'spread_length', -0.4181, 0.2925),
  ('shelf', 3, 'spread_width', -1.047, 0.09928),
  ('shelf', 3, 'standoff', 0.6626, 0.07689),
  ('shelf', 3, 'tilt_deg', 0.3389, 0.45),
  ('shelf', 3, 'wall_offset', 1.287, 0.109),
  ('shelf', 3, 'width', -0.9139, 0.1569),
  ('shelf', 3, 'z_max', 1.594, 0.2231),
  ('shelf', 3, 'z_min', 1.67, 0.2482);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.0755, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'aspect', 1.338, 0.2221),
  ('shelf', 4, 'behind', 0.7444, 0.1274),
  ('shelf', 4, 'corner_offset', 0.2388, 0.04348),
  ('shelf', 4, 'edge_concave', 0.4612, 0.08685),
  ('shelf', 4, 'edge_convex', 0.04643, 0.048),
  ('shelf', 4, 'edge_free', 0.4419, 0.03746),
  ('shelf', 4, 'edge_free_top', 0.4343, 0.2806),
  ('shelf', 4, 'edge_unseen', 0.03013, 0.06239),
  ('shelf', 4, 'headroom', 0.1627, 0.9285),
  ('shelf', 4, 'height', 0.6954, 0.2598),
  ('shelf', 4, 'lift', -2.675, 0.4727),
  ('shelf', 4, 'rectangularity', 0.6724, 0.1046),
  ('shelf', 4, 'spread_length', -0.1918, 0.5855),
  ('shelf', 4, 'spread_width', -1.152, 0.1135),
  ('shelf', 4, 'standoff', 0.5302, 0.3829),
  ('shelf', 4, 'tilt_deg', 89.99, 0.45),
  ('shelf', 4, 'wall_offset', 0.7388, 0.9764),
  ('shelf', 4, 'width', -1.108, 0.2213),
  ('shelf', 4, 'z_max', 1.257, 0.4759),
  ('shelf', 4, 'z_min', 0.02742, 0.04409);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.02916, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'aspect', 0.8037, 0.7215),
  ('shelf', 5, 'behind', 0.719, 0.1794),
  ('shelf', 5, 'corner_offset', 1.016, 0.712),
  ('shelf', 5, 'edge_concave', 0.4862, 0.1442),
  ('shelf', 5, 'edge_convex', 0.002605, 0.03011),
  ('shelf', 5, 'edge_free', 0.3766, 0.105),
  ('shelf', 5, 'edge_free_top', 0.4309, 0.09671),
  ('shelf', 5, 'edge_unseen', 0.205, 0.1073),
  ('shelf', 5, 'headroom', 0.4714, 0.1348),
  ('shelf', 5, 'height', 1.109, 0.3971),
  ('shelf', 5, 'lift', -0.9477, 0.07188),
  ('shelf', 5, 'rectangularity', 0.5611, 0.1015),
  ('shelf', 5, 'spread_length', -0.8105, 0.3264),
  ('shelf', 5, 'spread_width', -1.767, 0.2739),
  ('shelf', 5, 'standoff', 0.7066, 0.2613),
  ('shelf', 5, 'tilt_deg', 1.289, 0.9197),
  ('shelf', 5, 'wall_offset', 1.029, 0.1539),
  ('shelf', 5, 'width', -1.462, 0.3257),
  ('shelf', 5, 'z_max', 1.065, 0.3867),
  ('shelf', 5, 'z_min', 1.208, 0.3571);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.01924, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'aspect', 0.7563, 0.7134),
  ('shelf', 6, 'behind', -0.006065, 0.03),
  ('shelf', 6, 'corner_offset', 0.2204, 0.06926),
  ('shelf', 6, 'edge_concave', 0.5003, 0.163),
  ('shelf', 6, 'edge_convex', 0.000297, 0.03),
  ('shelf', 6, 'edge_free', 0.2898, 0.1205),
  ('shelf', 6, 'edge_free_top', 0.4258, 0.1092),
  ('shelf', 6, 'edge_unseen', 0.02996, 0.05601),
  ('shelf', 6, 'headroom', 0.5117, 0.4997),
  ('shelf', 6, 'height', 0.08517, 0.0225),
  ('shelf', 6, 'lift', -2.625, 0.6448),
  ('shelf', 6, 'rectangularity', 0.684, 0.1075),
  ('shelf', 6, 'spread_length', -0.3432, 0.2332),
  ('shelf', 6, 'spread_width', -1.601, 0.2346),
  ('shelf', 6, 'standoff', 0.6673, 0.1433),
  ('shelf', 6, 'tilt_deg', 0.8849, 0.8619),
  ('shelf', 6, 'wall_offset', 1.159, 0.3435),
  ('shelf', 6, 'width', -1.314, 0.2972),
  ('shelf', 6, 'z_max', 0.0839, 0.0225),
  ('shelf', 6, 'z_min', 0.08702, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.04262, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'aspect', 0.876, 0.2187),
  ('shelf', 7, 'behind', 0.8072, 0.0585),
  ('shelf', 7, 'corner_offset', 0.2602, 0.0404),
  ('shelf', 7, 'edge_concave', 0.5538, 0.109),
  ('shelf', 7, 'edge_convex', 0.04758, 0.04043),
  ('shelf', 7, 'edge_free', 0.2352, 0.1306),
  ('shelf', 7, 'edge_free_top', 0.4221, 0.1033),
  ('shelf', 7, 'edge_unseen', 0.04127, 0.09794),
  ('shelf', 7, 'headroom', 0.8989, 0.4615),
  ('shelf', 7, 'height', 0.9018, 0.1394),
  ('shelf', 7, 'lift', -0.7465, 0.1927),
  ('shelf', 7, 'rectangularity', 0.7533, 0.08964),
  ('shelf', 7, 'spread_length', -0.3654, 0.2346),
  ('shelf', 7, 'spread_width', -1.318, 0.305),
  ('shelf', 7, 'standoff', 0.6631, 0.1052),
  ('shelf', 7, 'tilt_deg', 0.6573, 0.45),
  ('shelf', 7, 'wall_offset', 1.138, 0.2791),
  ('shelf', 7, 'width', -0.9797, 0.1569),
  ('shelf', 7, 'z_max', 0.8826, 0.1175),
  ('shelf', 7, 'z_min', 0.9274, 0.1314);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.05939, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'aspect', 0.9974, 0.5686),
  ('shelf', 8, 'behind', 0.6257, 0.1062),
  ('shelf', 8, 'corner_offset', 0.2512, 0.05912),
  ('shelf', 8, 'edge_concave', 0.6266, 0.1549),
  ('shelf', 8, 'edge_convex', -0.002051, 0.03),
  ('shelf', 8, 'edge_free', 0.3787, 0.05555),
  ('shelf', 8, 'edge_free_top', 0.4257, 0.1035),
  ('shelf', 8, 'edge_unseen', 0.01294, 0.03684),
  ('shelf', 8, 'headroom', 1.007, 0.4551),
  ('shelf', 8, 'height', 0.4693, 0.07273),
  ('shelf', 8, 'lift', -1.902, 0.4491),
  ('shelf', 8, 'rectangularity', 0.6748, 0.08907),
  ('shelf', 8, 'spread_length', -0.2662, 0.1364),
  ('shelf', 8, 'spread_width', -1.387, 0.3114),
  ('shelf', 8, 'standoff', 0.6839, 0.1389),
  ('shelf', 8, 'tilt_deg', 1.723, 1.119),
  ('shelf', 8, 'wall_offset', 1.194, 0.3179),
  ('shelf', 8, 'width', -1.282, 0.3202),
  ('shelf', 8, 'z_max', 0.4586, 0.06542),
  ('shelf', 8, 'z_min', 0.4873, 0.07538);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.03026, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'aspect', 0.1862, 0.5655),
  ('shelf', 9, 'behind', 0.01465, 0.03005),
  ('shelf', 9, 'corner_offset', 1.502, 0.7279),
  ('shelf', 9, 'edge_concave', 0.5957, 0.1633),
  ('shelf', 9, 'edge_convex', -0.0003035, 0.03),
  ('shelf', 9, 'edge_free', 0.02702, 0.07156),
  ('shelf', 9, 'edge_free_top', 0.0212, 0.05183),
  ('shelf', 9, 'edge_unseen', 0.006946, 0.03),
  ('shelf', 9, 'headroom', 0.1628, 0.6865),
  ('shelf', 9, 'height', 1.187, 0.3407),
  ('shelf', 9, 'lift', -3.275, 1.951),
  ('shelf', 9, 'rectangularity', 0.6214, 0.1582),
  ('shelf', 9, 'spread_length', -0.5017, 0.496),
  ('shelf', 9, 'spread_width', -1.24, 1.115),
  ('shelf', 9, 'standoff', 0.06467, 0.01316),
  ('shelf', 9, 'tilt_deg', 89.58, 0.688),
  ('shelf', 9, 'wall_offset', 0.0763, 0.04),
  ('shelf', 9, 'width', -1.319, 0.8544),
  ('shelf', 9, 'z_max', 1.284, 0.3503),
  ('shelf', 9, 'z_min', 0.4304, 0.284);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.007403, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'aspect', 0.6692, 0.4674),
  ('shelf', 10, 'behind', 0.004979, 0.03548),
  ('shelf', 10, 'corner_offset', 1.919, 1.102),
  ('shelf', 10, 'edge_concave', 0.3943, 0.323),
  ('shelf', 10, 'edge_convex', 0.01303, 0.03006),
  ('shelf', 10, 'edge_free', 0.03729, 0.06403),
  ('shelf', 10, 'edge_free_top', 0.03997, 0.0895),
  ('shelf', 10, 'edge_unseen', 0.05592, 0.1287),
  ('shelf', 10, 'headroom', 0.9887, 0.4431),
  ('shelf', 10, 'height', 0.2971, 0.08281),
  ('shelf', 10, 'lift', -4.892, 0.4956),
  ('shelf', 10, 'rectangularity', 0.7801, 0.1323),
  ('shelf', 10, 'spread_length', -1.016, 0.4333),
  ('shelf', 10, 'spread_width', -1.608, 0.264),
  ('shelf', 10, 'standoff', 0.3175, 0.2638),
  ('shelf', 10, 'tilt_deg', 89.57, 1.553),
  ('shelf', 10, 'wall_offset', -0.07046, 0.296),
  ('shelf', 10, 'width', -1.57, 0.2424),
  ('shelf', 10, 'z_max', 0.2954, 0.07238),
  ('shelf', 10, 'z_min', 0.1689, 0.06455);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 11, 0.1761, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 11, 'aspect', 1.267, 0.386),
  ('shelf', 11, 'behind', 0.8198, 0.08441),
  ('shelf', 11, 'corner_offset', 0.238, 0.04168),
  ('shelf', 11, 'edge_concave', 0.4024, 0.1615),
  ('shelf', 11, 'edge_convex', 0.06297, 0.0647),
  ('shelf', 11, 'edge_free', 0.3835, 0.09134),
  ('shelf', 11, 'edge_free_top', 0.3362, 0.3321),
  ('shelf', 11, 'edge_unseen', 0.01907, 0.03425),
  ('shelf', 11, 'headroom', -0.3119, 0.768),
  ('shelf', 11, 'height', 0.8593, 0.2729),
  ('shelf', 11, 'lift', -3.344, 0.8949),
  ('shelf', 11, 'rectangularity', 0.7223, 0.1214),
  ('shelf', 11, 'spread_length', -0.04566, 0.4407),
  ('shelf', 11, 'spread_width', -1.102, 0.1247),
  ('shelf', 11, 'standoff', 0.6025, 0.3715),
  ('shelf', 11, 'tilt_deg', 90.16, 0.45),
  ('shelf', 11, 'wall_offset', 1.02, 0.9581),
  ('shelf', 11, 'width', -1.042, 0.1799),
  ('shelf', 11, 'z_max', 1.603, 0.2726),
  ('shelf', 11, 'z_min', 0.1138, 0.2704);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 12, 0.05244, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 12, 'aspect', 1.317, 0.3691),
  ('shelf', 12, 'behind', 0.5711, 0.1302),
  ('shelf', 12, 'corner_offset', 3.506, 0.6504),
  ('shelf', 12, 'edge_concave', 0.1148, 0.1632),
  ('shelf', 12, 'edge_convex', 0.06625, 0.07934),
  ('shelf', 12, 'edge_free', 0.4289, 0.07805),
  ('shelf', 12, 'edge_free_top', 0.4349, 0.2304),
  ('shelf', 12, 'edge_unseen', 0.2207, 0.221),
  ('shelf', 12, 'headroom', -0.05116, 0.3718),
  ('shelf', 12, 'height', 1.122, 0.124),
  ('shelf', 12, 'lift', -4.866, 0.7381),
  ('shelf', 12, 'rectangularity', 0.7937, 0.08693),
  ('shelf', 12, 'spread_length', -0.1728, 0.5141),
  ('shelf', 12, 'spread_width', -1.124, 0.1796),
  ('shelf', 12, 'standoff', 0.687, 0.3573),
  ('shelf', 12, 'tilt_deg', 90.16, 0.4501),
  ('shelf', 12, 'wall_offset', 2.009, 1.208),
  ('shelf', 12, 'width', -1.018, 0.1503),
  ('shelf', 12, 'z_max', 1.616, 0.0935),
  ('shelf', 12, 'z_min', 0.2612, 0.2774);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 13, 0.03873, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 13, 'aspect', 0.6191, 0.337),
  ('shelf', 13, 'behind', 0.667, 0.1256),
  ('shelf', 13, 'corner_offset', 1.442, 0.9361),
  ('shelf', 13, 'edge_concave', 0.5602, 0.2269),
  ('shelf', 13, 'edge_convex', 0.01835, 0.04883),
  ('shelf', 13, 'edge_free', 0.3234, 0.1196),
  ('shelf', 13, 'edge_free_top', 0.4128, 0.0982),
  ('shelf', 13, 'edge_unseen', 0.2541, 0.1712),
  ('shelf', 13, 'headroom', 0.5625, 0.1622),
  ('shelf', 13, 'height', 1.337, 0.3867),
  ('shelf', 13, 'lift', -0.8307, 0.3718),
  ('shelf', 13, 'rectangularity', 0.6748, 0.1647),
  ('shelf', 13, 'spread_length', -0.7363, 0.3276),
  ('shelf', 13, 'spread_width', -1.427, 0.3408),
  ('shelf', 13, 'standoff', 0.6802, 0.09261),
  ('shelf', 13, 'tilt_deg', 1.015, 0.6952),
  ('shelf', 13, 'wall_offset', 1.142, 0.06866),
  ('shelf', 13, 'width', -1.194, 0.2193),
  ('shelf', 13, 'z_max', 1.3, 0.3797),
  ('shelf', 13, 'z_min', 1.35, 0.3739);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 14, 0.02487, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 14, 'aspect', 0.6516, 0.2724),
  ('shelf', 14, 'behind', -0.005337, 0.03),
  ('shelf', 14, 'corner_offset', 0.2337, 0.08437),
  ('shelf', 14, 'edge_concave', 0.4662, 0.1773),
  ('shelf', 14, 'edge_convex', 0.0001111, 0.03),
  ('shelf', 14, 'edge_free', 0.2395, 0.1807),
  ('shelf', 14, 'edge_free_top', 0.4216, 0.1104),
  ('shelf', 14, 'edge_unseen', 0.04243, 0.1196),
  ('shelf', 14, 'headroom', 0.5354, 0.619),
  ('shelf', 14, 'height', 0.08008, 0.02252),
  ('shelf', 14, 'lift', -2.555, 0.6614),
  ('shelf', 14, 'rectangularity', 0.687, 0.08687),
  ('shelf', 14, 'spread_length', -0.3549, 0.1989),
  ('shelf', 14, 'spread_width', -1.663, 0.2048),
  ('shelf', 14, 'standoff', 0.7109, 0.1426),
  ('shelf', 14, 'tilt_deg', 0.9951, 0.7599),
  ('shelf', 14, 'wall_offset', 1.087, 0.3182),
  ('shelf', 14, 'width', -1.469, 0.2481),
  ('shelf', 14, 'z_max', 0.07718, 0.02252),
  ('shelf', 14, 'z_min', 0.08574, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 15, 0.05258, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 15, 'aspect', 0.822, 0.5297),
  ('shelf', 15, 'behind', 0.7985, 0.08056),
  ('shelf', 15, 'corner_offset', 0.227, 0.04262),
  ('shelf', 15, 'edge_concave', 0.5254, 0.1257),
  ('shelf', 15, 'edge_convex', 0.004983, 0.03005),
  ('shelf', 15, 'edge_free', 0.2662, 0.1081),
  ('shelf', 15, 'edge_free_top', 0.4218, 0.1028),
  ('shelf', 15, 'edge_unseen', 0.03107, 0.1147),
  ('shelf', 15, 'headroom', 0.9344, 0.5894),
  ('shelf', 15, 'height', 0.4778, 0.07201),
  ('shelf', 15, 'lift', -1.897, 0.7316),
  ('shelf', 15, 'rectangularity', 0.6329, 0.1067),
  ('shelf', 15, 'spread_length', -0.3431, 0.214),
  ('shelf', 15, 'spread_width', -1.618, 0.4092),
  ('shelf', 15, 'standoff', 0.7039, 0.1304),
  ('shelf', 15, 'tilt_deg', 1.438, 0.8133),
  ('shelf', 15, 'wall_offset', 1.025, 0.2779),
  ('shelf', 15, 'width', -1.446, 0.3274),
  ('shelf', 15, 'z_max', 0.45, 0.05299),
  ('shelf', 15, 'z_min', 0.5026, 0.07008);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 16, 0.03515, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 16, 'aspect', 0.8787, 0.2984),
  ('shelf', 16, 'behind', 0.7324, 0.04652),
  ('shelf', 16, 'corner_offset', 0.2352, 0.08678),
  ('shelf', 16, 'edge_concave', 0.5028, 0.134),
  ('shelf', 16, 'edge_convex', 0.02566, 0.04708),
  ('shelf', 16, 'edge_free', 0.2067, 0.1745),
  ('shelf', 16, 'edge_free_top', 0.3956, 0.1275),
  ('shelf', 16, 'edge_unseen', 0.01423, 0.04402),
  ('shelf', 16, 'headroom', 1.071, 0.4635),
  ('shelf', 16, 'height', 1.7, 0.2696),
  ('shelf', 16, 'lift', -1.07, 0.3053),
  ('shelf', 16, 'rectangularity', 0.7892, 0.1401),
  ('shelf', 16, 'spread_length', -0.3083, 0.2638),
  ('shelf', 16, 'spread_width', -1.055, 0.1406),
  ('shelf', 16, 'standoff', 0.7067, 0.09704),
  ('shelf', 16, 'tilt_deg', 0.4476, 0.45),
  ('shelf', 16, 'wall_offset', 0.839, 0.3682),
  ('shelf', 16, 'width', -0.9908, 0.1355),
  ('shelf', 16, 'z_max', 1.691, 0.2345),
  ('shelf', 16, 'z_min', 1.731, 0.3185);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 17, 0.03991, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 17, 'aspect', 0.9063, 0.295),
  ('shelf', 17, 'behind', 0.8, 0.1275),
  ('shelf', 17, 'corner_offset', 0.2592, 0.04043),
  ('shelf', 17, 'edge_concave', 0.4726, 0.08972),
  ('shelf', 17, 'edge_convex', 0.02091, 0.04989),
  ('shelf', 17, 'edge_free', 0.2634, 0.1402),
  ('shelf', 17, 'edge_free_top', 0.4202, 0.1112),
  ('shelf', 17, 'edge_unseen', 0.00534, 0.03323),
  ('shelf', 17, 'headroom', 0.9039, 0.4357),
  ('shelf', 17, 'height', 0.8509, 0.1089),
  ('shelf', 17, 'lift', -1.048, 0.096),
  ('shelf', 17, 'rectangularity', 0.7405, 0.09159),
  ('shelf', 17, 'spread_length', -0.4375, 0.2666),
  ('shelf', 17, 'spread_width', -1.251, 0.2536),
  ('shelf', 17, 'standoff', 0.7363, 0.1068),
  ('shelf', 17, 'tilt_deg', 0.8177, 0.4519),
  ('shelf', 17, 'wall_offset', 1.17, 0.3812),
  ('shelf', 17, 'width', -1.062, 0.1456),
  ('shelf', 17, 'z_max', 0.8347, 0.1108),
  ('shelf', 17, 'z_min', 0.8546, 0.1264);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 18, 0.01598, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 18, 'aspect', 0.4275, 0.4684),
  ('shelf', 18, 'behind', -0.01244, 0.03),
  ('shelf', 18, 'corner_offset', 1.36, 0.9535),
  ('shelf', 18, 'edge_concave', 0.4523, 0.2328),
  ('shelf', 18, 'edge_convex', 0.0007919, 0.03),
  ('shelf', 18, 'edge_free', -0.0009862, 0.03),
  ('shelf', 18, 'edge_free_top', 0.0008801, 0.03),
  ('shelf', 18, 'edge_unseen', 0.009148, 0.03946),
  ('shelf', 18, 'headroom', 0.7103, 0.5625),
  ('shelf', 18, 'height', 0.6558, 0.3491),
  ('shelf', 18, 'lift', -3.013, 2.434),
  ('shelf', 18, 'rectangularity', 0.8221, 0.07077),
  ('shelf', 18, 'spread_length', -0.8563, 0.4505),
  ('shelf', 18, 'spread_width', -1.646, 0.4032),
  ('shelf', 18, 'standoff', 0.1591, 0.04204),
  ('shelf', 18, 'tilt_deg', 89.52, 0.6677),
  ('shelf', 18, 'wall_offset', 0.04778, 0.04),
  ('shelf', 18, 'width', -1.553, 0.1898),
  ('shelf', 18, 'z_max', 0.8203, 0.3188),
  ('shelf', 18, 'z_min', 0.782, 0.4568);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 19, 0.02481, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 19, 'aspect', 0.2071, 0.3228),
  ('shelf', 19, 'behind', -0.005034, 0.03),
  ('shelf', 19, 'corner_offset', 1.164, 0.6681),
  ('shelf', 19, 'edge_concave', 0.609, 0.1689),
  ('shelf', 19, 'edge_convex', -0.0001577, 0.03),
  ('shelf', 19, 'edge_free', 0.09119, 0.1242),
  ('shelf', 19, 'edge_free_top', 0.03694, 0.07358),
  ('shelf', 19, 'edge_unseen', 0.001345, 0.03),
  ('shelf', 19, 'headroom', -0.08984, 0.1639),
  ('shelf', 19, 'height', 1.1, 0.3632),
  ('shelf', 19, 'lift', -3.143, 2.338),
  ('shelf', 19, 'rectangularity', 0.5612, 0.1345),
  ('shelf', 19, 'spread_length', -0.2901, 0.4767),
  ('shelf', 19, 'spread_width', -0.9631, 0.8066),
  ('shelf', 19, 'standoff', 0.07816, 0.03028),
  ('shelf', 19, 'tilt_deg', 89.93, 0.8528),
  ('shelf', 19, 'wall_offset', 0.06547, 0.04),
  ('shelf', 19, 'width', -0.8797, 0.3981),
  ('shelf', 19, 'z_max', 1.523, 0.2405),
  ('shelf', 19, 'z_min', 0.6955, 0.7765);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 20, 0.01445, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 20, 'aspect', 0.6877, 0.1673),
  ('shelf', 20, 'behind', 0.4825, 0.1415),
  ('shelf', 20, 'corner_offset', 0.2934, 0.0987),
  ('shelf', 20, 'edge_concave', 0.3073, 0.293),
  ('shelf', 20, 'edge_convex', 0.08312, 0.1733),
  ('shelf', 20, 'edge_free', 0.1719, 0.05815),
  ('shelf', 20, 'edge_free_top', 0.2753, 0.4531),
  ('shelf', 20, 'edge_unseen', 0.08973, 0.1372),
  ('shelf', 20, 'headroom', 1.658, 0.5535),
  ('shelf', 20, 'height', 0.326, 0.4383),
  ('shelf', 20, 'lift', -2.617, 3.262),
  ('shelf', 20, 'rectangularity', 0.709, 0.1354),
  ('shelf', 20, 'spread_length', -1.028, 0.2062),
  ('shelf', 20, 'spread_width', -1.76, 0.1159),
  ('shelf', 20, 'standoff', 0.3801, 0.2847),
  ('shelf', 20, 'tilt_deg', 79.92, 21.31),
  ('shelf', 20, 'wall_offset', 1.36, 0.3404),
  ('shelf', 20, 'width', -1.581, 0.1522),
  ('shelf', 20, 'z_max', 0.4344, 0.4529),
  ('shelf', 20, 'z_min', 0.224, 0.4336);

-- cabinet: 2821 examples
UPDATE object_class SET prior = 0.1345 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6638, 0.4308)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.4909, 0.245)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'corner_offset', 1.055, 0.937)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_concave', 0.3667, 0.2608)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_convex', 0.19, 0.1802)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.378, 0.2754)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.7418, 0.328)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_unseen', 0.08653, 0.1626)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'headroom', 0.6606, 0.7356)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7979, 0.363)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'lift', -5.01, 0.8392)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7402, 0.1322)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1209, 0.511)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.8208, 0.5485)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'standoff', 0.7426, 0.3473)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 74.62, 33.51)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'wall_offset', 1.162, 0.9906)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.6162, 0.5145)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.25, 0.5795)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2644, 0.3737)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'cabinet';
DELETE FROM class_density WHERE class = 'cabinet';
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.07464, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'aspect', 0.6719, 0.467),
  ('cabinet', 1, 'behind', 0.4699, 0.1841),
  ('cabinet', 1, 'corner_offset', 0.2533, 0.1904),
  ('cabinet', 1, 'edge_concave', 0.7613, 0.3031),
  ('cabinet', 1, 'edge_convex', 0.2896, 0.1923),
  ('cabinet', 1, 'edge_free', 0.1351, 0.03687),
  ('cabinet', 1, 'edge_free_top', 0.8654, 0.1396),
  ('cabinet', 1, 'edge_unseen', -0.0008068, 0.03005),
  ('cabinet', 1, 'headroom', 0.7278, 0.4149),
  ('cabinet', 1, 'height', 0.8331, 0.3632),
  ('cabinet', 1, 'lift', -5.104, 1.058),
  ('cabinet', 1, 'rectangularity', 0.7974, 0.07831),
  ('cabinet', 1, 'spread_length', 0.2161, 0.252),
  ('cabinet', 1, 'spread_width', -0.655, 0.1297),
  ('cabinet', 1, 'standoff', 1.196, 0.359),
  ('cabinet', 1, 'tilt_deg', 90.12, 0.45),
  ('cabinet', 1, 'wall_offset', 1.699, 0.4472),
  ('cabinet', 1, 'width', -0.5204, 0.1075),
  ('cabinet', 1, 'z_max', 1.753, 0.3925),
  ('cabinet', 1, 'z_min', 0.08871, 0.2904);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.04662, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'aspect', 0.6776, 0.2838),
  ('cabinet', 2, 'behind', 0.5723, 0.2334),
  ('cabinet', 2, 'corner_offset', 2.357, 1.172),
  ('cabinet', 2, 'edge_concave', 0.2389, 0.2758),
  ('cabinet', 2, 'edge_convex', 0.01135, 0.03984),
  ('cabinet', 2, 'edge_free', 0.4458, 0.1798),
  ('cabinet', 2, 'edge_free_top', 0.8014, 0.1351),
  ('cabinet', 2, 'edge_unseen', 0.1209, 0.166),
  ('cabinet', 2, 'headroom', 0.6655, 0.1322),
  ('cabinet', 2, 'height', 1.287, 0.0786),
  ('cabinet', 2, 'lift', -5.704, 0.7199),
  ('cabinet', 2, 'rectangularity', 0.6594, 0.06198),
  ('cabinet', 2, 'spread_length', -0.4027, 0.3032),
  ('cabinet', 2, 'spread_width', -0.6491, 0.2916),
  ('cabinet', 2, 'standoff', 0.4098, 0.475),
  ('cabinet', 2, 'tilt_deg', 90.14, 0.45),
  ('cabinet', 2, 'wall_offset', 2.319, 1.067),
  ('cabinet', 2, 'width', -0.4607, 0.3058),
  ('cabinet', 2, 'z_max', 1.907, 0.09777),
  ('cabinet', 2, 'z_min', 0.445, 0.2488);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.01768, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'aspect', 0.5537, 0.3229),
  ('cabinet', 3, 'behind', 0.5434, 0.1541),
  ('cabinet', 3, 'corner_offset', 1.516, 0.837),
  ('cabinet', 3, 'edge_concave', 0.4873, 0.2687),
  ('cabinet', 3, 'edge_convex', 0.2105, 0.1404),
  ('cabinet', 3, 'edge_free', 0.2216, 0.1768),
  ('cabinet', 3, 'edge_free_top', 0.5304, 0.3667),
  ('cabinet', 3, 'edge_unseen', 0.06407, 0.1491),
  ('cabinet', 3, 'headroom', 0.004782, 0.1311),
  ('cabinet', 3, 'height', 0.338, 0.03642),
  ('cabinet', 3, 'lift', -4.979, 0.2627),
  ('cabinet', 3, 'rectangularity', 0.6823, 0.09375),
  ('cabinet', 3, 'spread_length', -0.5304, 0.04915),
  ('cabinet', 3, 'spread_width', -0.8685, 0.1654),
  ('cabinet', 3, 'standoff', 0.9258, 0.1364),
  ('cabinet', 3, 'tilt_deg', 90.15, 0.4501),
  ('cabinet', 3, 'wall_offset', 1.431, 1.041),
  ('cabinet', 3, 'width', -0.5359, 0.1265),
  ('cabinet', 3, 'z_max', 0.793, 0.1359),
  ('cabinet', 3, 'z_min', -0.01586, 0.02361);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.1743, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'aspect', 0.7945, 0.3236),
  ('cabinet', 4, 'behind', 0.2066, 0.0711),
  ('cabinet', 4, 'corner_offset', 1.363, 0.6217),
  ('cabinet', 4, 'edge_concave', 0.3183, 0.1852),
  ('cabinet', 4, 'edge_convex', 0.0009825, 0.03001),
  ('cabinet', 4, 'edge_free', 0.7384, 0.2517),
  ('cabinet', 4, 'edge_free_top', 0.998, 0.03),
  ('cabinet', 4, 'edge_unseen', 0.001733, 0.03),
  ('cabinet', 4, 'headroom', 0.7886, 0.3529),
  ('cabinet', 4, 'height', 1.218, 0.1598),
  ('cabinet', 4, 'lift', -4.89, 0.09923),
  ('cabinet', 4, 'rectangularity', 0.8587, 0.111),
  ('cabinet', 4, 'spread_length', 0.176, 0.4052),
  ('cabinet', 4, 'spread_width', -0.5246, 0.5812),
  ('cabinet', 4, 'standoff', 0.5342, 0.0462),
  ('cabinet', 4, 'tilt_deg', 90.15, 0.45),
  ('cabinet', 4, 'wall_offset', 0.5139, 0.06203),
  ('cabinet', 4, 'width', -0.4056, 0.4061),
  ('cabinet', 4, 'z_max', 1.841, 0.1108),
  ('cabinet', 4, 'z_min', 0.06409, 0.3456);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.02988, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'aspect', 0.4932, 0.5074),
  ('cabinet', 5, 'behind', 0.1027, 0.2568),
  ('cabinet', 5, 'corner_offset', 1.87, 0.5304),
  ('cabinet', 5, 'edge_concave', 0.001811, 0.03),
  ('cabinet', 5, 'edge_convex', 0.2068, 0.1549),
  ('cabinet', 5, 'edge_free', 0.4577, 0.3832),
  ('cabinet', 5, 'edge_free_top', 0.986, 0.0342),
  ('cabinet', 5, 'edge_unseen', 0.3773, 0.1279),
  ('cabinet', 5, 'headroom', 0.1741, 0.2136),
  ('cabinet', 5, 'height', 1.079, 0.1553),
  ('cabinet', 5, 'lift', -4.896, 0.03334),
  ('cabinet', 5, 'rectangularity', 0.6396, 0.06566),
  ('cabinet', 5, 'spread_length', -0.509, 0.5158),
  ('cabinet', 5, 'spread_width', -0.8725, 1.132),
  ('cabinet', 5, 'standoff', 0.5137, 0.05609),
  ('cabinet', 5, 'tilt_deg', 90.2, 0.4501),
  ('cabinet', 5, 'wall_offset', 1.789, 1.897),
  ('cabinet', 5, 'width', -0.7781, 0.8404),
  ('cabinet', 5, 'z_max', 1.587, 0.4331),
  ('cabinet', 5, 'z_min', 0.4657, 0.147);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.03864, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'aspect', 0.6814, 0.2435),
  ('cabinet', 6, 'behind', 0.6598, 0.121),
  ('cabinet', 6, 'corner_offset', 0.2978, 0.05394),
  ('cabinet', 6, 'edge_concave', 0.5123, 0.1552),
  ('cabinet', 6, 'edge_convex', 0.3143, 0.1045),
  ('cabinet', 6, 'edge_free', 0.1266, 0.1288),
  ('cabinet', 6, 'edge_free_top', 0.7485, 0.09539),
  ('cabinet', 6, 'edge_unseen', 0.1394, 0.1859),
  ('cabinet', 6, 'headroom', 1.902, 0.2899),
  ('cabinet', 6, 'height', 0.9324, 0.1494),
  ('cabinet', 6, 'lift', -5.002, 0.2177),
  ('cabinet', 6, 'rectangularity', 0.6688, 0.08279),
  ('cabinet', 6, 'spread_length', -0.2061, 0.2777),
  ('cabinet', 6, 'spread_width', -0.679, 0.1),
  ('cabinet', 6, 'standoff', 0.7463, 0.1013),
  ('cabinet', 6, 'tilt_deg', -0.1913, 0.45),
  ('cabinet', 6, 'wall_offset', 1.119, 0.2995),
  ('cabinet', 6, 'width', -0.5402, 0.08918),
  ('cabinet', 6, 'z_max', 0.8992, 0.1368),
  ('cabinet', 6, 'z_min', 0.9223, 0.1409);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.0434, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'aspect', 0.5595, 0.2591),
  ('cabinet', 7, 'behind', 0.4711, 0.1497),
  ('cabinet', 7, 'corner_offset', 1.239, 0.8469),
  ('cabinet', 7, 'edge_concave', 0.3073, 0.3282),
  ('cabinet', 7, 'edge_convex', 0.1526, 0.2013),
  ('cabinet', 7, 'edge_free', 0.4294, 0.1818),
  ('cabinet', 7, 'edge_free_top', 0.9754, 0.03572),
  ('cabinet', 7, 'edge_unseen', -0.0257, 0.03009),
  ('cabinet', 7, 'headroom', 0.5222, 0.7514),
  ('cabinet', 7, 'height', 0.7162, 0.1334),
  ('cabinet', 7, 'lift', -4.925, 0.1116),
  ('cabinet', 7, 'rectangularity', 0.797, 0.1424),
  ('cabinet', 7, 'spread_length', -0.1291, 0.2155),
  ('cabinet', 7, 'spread_width', -0.3672, 0.4955),
  ('cabinet', 7, 'standoff', 0.5573, 0.1058),
  ('cabinet', 7, 'tilt_deg', 90.14, 0.45),
  ('cabinet', 7, 'wall_offset', 0.5094, 0.06001),
  ('cabinet', 7, 'width', -0.2821, 0.4164),
  ('cabinet', 7, 'z_max', 0.9612, 0.1112),
  ('cabinet', 7, 'z_min', 0.0005117, 0.02606);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.01439, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'aspect', 1.137, 0.8242),
  ('cabinet', 8, 'behind', 0.3236, 0.3824),
  ('cabinet', 8, 'corner_offset', 1.013, 0.764),
  ('cabinet', 8, 'edge_concave', 0.241, 0.2068),
  ('cabinet', 8, 'edge_convex', 0.05579, 0.1172),
  ('cabinet', 8, 'edge_free', 0.05115, 0.1032),
  ('cabinet', 8, 'edge_free_top', 0.003031, 0.03004),
  ('cabinet', 8, 'edge_unseen', -0.001513, 0.03),
  ('cabinet', 8, 'headroom', 1.714, 0.7693),
  ('cabinet', 8, 'height', 0.2678, 0.1864),
  ('cabinet', 8, 'lift', -4.917, 0.1214),
  ('cabinet', 8, 'rectangularity', 0.7379, 0.1395),
  ('cabinet', 8, 'spread_length', -0.243, 0.589),
  ('cabinet', 8, 'spread_width', -1.56, 0.3212),
  ('cabinet', 8, 'standoff', 0.4599, 0.4126),
  ('cabinet', 8, 'tilt_deg', 89.76, 0.8222),
  ('cabinet', 8, 'wall_offset', 1.031, 0.3294),
  ('cabinet', 8, 'width', -1.427, 0.3354),
  ('cabinet', 8, 'z_max', 0.7124, 0.438),
  ('cabinet', 8, 'z_min', -0.02919, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.01853, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'aspect', 0.6776, 0.3417),
  ('cabinet', 9, 'behind', 0.7699, 0.1742),
  ('cabinet', 9, 'corner_offset', 0.7685, 0.1405),
  ('cabinet', 9, 'edge_concave', 0.5235, 0.1111),
  ('cabinet', 9, 'edge_convex', 0.2115, 0.2204),
  ('cabinet', 9, 'edge_free', 0.2311, 0.1463),
  ('cabinet', 9, 'edge_free_top', 0.7418, 0.1024),
  ('cabinet', 9, 'edge_unseen', 0.008983, 0.04511),
  ('cabinet', 9, 'headroom', 0.1728, 0.05563),
  ('cabinet', 9, 'height', 0.5811, 0.0225),
  ('cabinet', 9, 'lift', -3.486, 0.5855),
  ('cabinet', 9, 'rectangularity', 0.6952, 0.08135),
  ('cabinet', 9, 'spread_length', -0.7655, 0.1726),
  ('cabinet', 9, 'spread_width', -1.48, 0.4644),
  ('cabinet', 9, 'standoff', 0.7437, 0.1089),
  ('cabinet', 9, 'tilt_deg', 0.8284, 1.316),
  ('cabinet', 9, 'wall_offset', 1.167, 0.3068),
  ('cabinet', 9, 'width', -1.254, 0.537),
  ('cabinet', 9, 'z_max', 0.5836, 0.0225),
  ('cabinet', 9, 'z_min', 0.5809, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.01688, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'aspect', 0.3257, 0.341),
  ('cabinet', 10, 'behind', 0.5833, 0.185),
  ('cabinet', 10, 'corner_offset', 1.274, 1.701),
  ('cabinet', 10, 'edge_concave', 0.1753, 0.1807),
  ('cabinet', 10, 'edge_convex', 0.3726, 0.247),
  ('cabinet', 10, 'edge_free', 0.2787, 0.1674),
  ('cabinet', 10, 'edge_free_top', 0.5549, 0.3294),
  ('cabinet', 10, 'edge_unseen', 0.1589, 0.1428),
  ('cabinet', 10, 'headroom', 0.006967, 0.07018),
  ('cabinet', 10, 'height', 0.4614, 0.02517),
  ('cabinet', 10, 'lift', -5.158, 0.7002),
  ('cabinet', 10, 'rectangularity', 0.6463, 0.05502),
  ('cabinet', 10, 'spread_length', -0.6764, 0.1365),
  ('cabinet', 10, 'spread_width', -1.692, 0.2477),
  ('cabinet', 10, 'standoff', 0.8902, 0.124),
  ('cabinet', 10, 'tilt_deg', 91.19, 4.613),
  ('cabinet', 10, 'wall_offset', 1.4, 1.218),
  ('cabinet', 10, 'width', -1.549, 0.5054),
  ('cabinet', 10, 'z_max', 0.6743, 0.06647),
  ('cabinet', 10, 'z_min', 0.4839, 0.2278);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 11, 0.06181, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 11, 'aspect', 0.5099, 0.4671),
  ('cabinet', 11, 'behind', 0.1408, 0.07813),
  ('cabinet', 11, 'corner_offset', 2.007, 0.07867),
  ('cabinet', 11, 'edge_concave', 0.2354, 0.2399),
  ('cabinet', 11, 'edge_convex', 0.008255, 0.04039),
  ('cabinet', 11, 'edge_free', 0.4078, 0.3453),
  ('cabinet', 11, 'edge_free_top', 0.9845, 0.03712),
  ('cabinet', 11, 'edge_unseen', 0.5733, 0.2237),
  ('cabinet', 11, 'headroom', 0.8802, 0.2538),
  ('cabinet', 11, 'height', 1.252, 0.1605),
  ('cabinet', 11, 'lift', -3.053, 0.1434),
  ('cabinet', 11, 'rectangularity', 0.7131, 0.09461),
  ('cabinet', 11, 'spread_length', -0.5025, 0.3533),
  ('cabinet', 11, 'spread_width', -0.6907, 0.4355),
  ('cabinet', 11, 'standoff', 0.5589, 0.0824),
  ('cabinet', 11, 'tilt_deg', 90.17, 0.45),
  ('cabinet', 11, 'wall_offset', 2.543, 0.7994),
  ('cabinet', 11, 'width', -0.4776, 0.3919),
  ('cabinet', 11, 'z_max', 1.879, 0.1155),
  ('cabinet', 11, 'z_min', 0.4957, 0.2761);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 12, 0.08674, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 12, 'aspect', 1.02, 0.3985),
  ('cabinet', 12, 'behind', 0.5119, 0.1836),
  ('cabinet', 12, 'corner_offset', 0.2449, 0.2475),
  ('cabinet', 12, 'edge_concave', 0.5805, 0.3112),
  ('cabinet', 12, 'edge_convex', 0.1236, 0.1837),
  ('cabinet', 12, 'edge_free', 0.1275, 0.0704),
  ('cabinet', 12, 'edge_free_top', 0.8688, 0.1337),
  ('cabinet', 12, 'edge_unseen', -0.01307, 0.03),
  ('cabinet', 12, 'headroom', 0.7442, 0.3805),
  ('cabinet', 12, 'height', 0.9271, 0.2591),
  ('cabinet', 12, 'lift', -5.544, 1.653),
  ('cabinet', 12, 'rectangularity', 0.7941, 0.1073),
  ('cabinet', 12, 'spread_length', -0.03083, 0.4033),
  ('cabinet', 12, 'spread_width', -0.6331, 0.1381),
  ('cabinet', 12, 'standoff', 1.044, 0.214),
  ('cabinet', 12, 'tilt_deg', 90.11, 0.45),
  ('cabinet', 12, 'wall_offset', 1.876, 0.4297),
  ('cabinet', 12, 'width', -0.502, 0.09111),
  ('cabinet', 12, 'z_max', 1.786, 0.4052),
  ('cabinet', 12, 'z_min', 0.06205, 0.2267);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 13, 0.01412, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 13, 'aspect', 1.135, 0.4277),
  ('cabinet', 13, 'behind', 0.6088, 0.5084),
  ('cabinet', 13, 'corner_offset', 0.8945, 0.6978),
  ('cabinet', 13, 'edge_concave', 0.3348, 0.3453),
  ('cabinet', 13, 'edge_convex', 0.05544, 0.09405),
  ('cabinet', 13, 'edge_free', 0.06239, 0.09937),
  ('cabinet', 13, 'edge_free_top', 0.06303, 0.1098),
  ('cabinet', 13, 'edge_unseen', 0.1894, 0.2708),
  ('cabinet', 13, 'headroom', 1.315, 0.9795),
  ('cabinet', 13, 'height', 0.2847, 0.1796),
  ('cabinet', 13, 'lift', -5.076, 0.5031),
  ('cabinet', 13, 'rectangularity', 0.6864, 0.1074),
  ('cabinet', 13, 'spread_length', -0.8103, 0.5521),
  ('cabinet', 13, 'spread_width', -1.506, 0.208),
  ('cabinet', 13, 'standoff', 0.8616, 0.4118),
  ('cabinet', 13, 'tilt_deg', 89.7, 1.231),
  ('cabinet', 13, 'wall_offset', 1.608, 0.6363),
  ('cabinet', 13, 'width', -1.567, 0.467),
  ('cabinet', 13, 'z_max', 0.7612, 0.336),
  ('cabinet', 13, 'z_min', -0.04531, 0.123);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 14, 0.02174, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 14, 'aspect', 0.4809, 0.2939),
  ('cabinet', 14, 'behind', 0.5645, 0.0853),
  ('cabinet', 14, 'corner_offset', 1.713, 0.7223),
  ('cabinet', 14, 'edge_concave', 0.5098, 0.3042),
  ('cabinet', 14, 'edge_convex', 0.2078, 0.1048),
  ('cabinet', 14, 'edge_free', 0.1913, 0.2007),
  ('cabinet', 14, 'edge_free_top', 0.6993, 0.1834),
  ('cabinet', 14, 'edge_unseen', -0.003138, 0.03163),
  ('cabinet', 14, 'headroom', -0.0857, 0.1347),
  ('cabinet', 14, 'height', 0.3264, 0.03932),
  ('cabinet', 14, 'lift', -4.699, 0.3524),
  ('cabinet', 14, 'rectangularity', 0.7646, 0.1191),
  ('cabinet', 14, 'spread_length', -0.5557, 0.05734),
  ('cabinet', 14, 'spread_width', -0.8559, 0.1316),
  ('cabinet', 14, 'standoff', 0.8703, 0.1811),
  ('cabinet', 14, 'tilt_deg', 90.06, 0.45),
  ('cabinet', 14, 'wall_offset', 1.535, 0.4017),
  ('cabinet', 14, 'width', -0.7218, 0.3),
  ('cabinet', 14, 'z_max', 0.6894, 0.07294),
  ('cabinet', 14, 'z_min', -0.003728, 0.02254);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 15, 0.1395, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 15, 'aspect', 0.7692, 0.4356),
  ('cabinet', 15, 'behind', 0.2604, 0.2131),
  ('cabinet', 15, 'corner_offset', 1.622, 0.6555),
  ('cabinet', 15, 'edge_concave', 0.1945, 0.2814),
  ('cabinet', 15, 'edge_convex', 0.1034, 0.1412),
  ('cabinet', 15, 'edge_free', 0.739, 0.286),
  ('cabinet', 15, 'edge_free_top', 0.9689, 0.05747),
  ('cabinet', 15, 'edge_unseen', -0.005386, 0.03),
  ('cabinet', 15, 'headroom', 0.7842, 0.3129),
  ('cabinet', 15, 'height', 1.322, 0.1046),
  ('cabinet', 15, 'lift', -4.601, 0.1786),
  ('cabinet', 15, 'rectangularity', 0.8108, 0.1405),
  ('cabinet', 15, 'spread_length', 0.1539, 0.3216),
  ('cabinet', 15, 'spread_width', -0.5064, 0.2818),
  ('cabinet', 15, 'standoff', 0.556, 0.05874),
  ('cabinet', 15, 'tilt_deg', 90.12, 0.45),
  ('cabinet', 15, 'wall_offset', 0.5107, 0.05873),
  ('cabinet', 15, 'width', -0.2638, 0.262),
  ('cabinet', 15, 'z_max', 1.866, 0.1139),
  ('cabinet', 15, 'z_min', -0.03182, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 16, 0.03875, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 16, 'aspect', 0.545, 0.2543),
  ('cabinet', 16, 'behind', 0.5145, 0.1107),
  ('cabinet', 16, 'corner_offset', 1.901, 0.7413),
  ('cabinet', 16, 'edge_concave', 0.2732, 0.3648),
  ('cabinet', 16, 'edge_convex', 0.2671, 0.2155),
  ('cabinet', 16, 'edge_free', 0.4965, 0.2425),
  ('cabinet', 16, 'edge_free_top', 0.9472, 0.06295),
  ('cabinet', 16, 'edge_unseen', -0.01321, 0.03),
  ('cabinet', 16, 'headroom', 0.5859, 0.7204),
  ('cabinet', 16, 'height', 0.7544, 0.1359),
  ('cabinet', 16, 'lift', -4.657, 0.1769),
  ('cabinet', 16, 'rectangularity', 0.8454, 0.1707),
  ('cabinet', 16, 'spread_length', -0.2614, 0.199),
  ('cabinet', 16, 'spread_width', -0.4828, 0.3338),
  ('cabinet', 16, 'standoff', 0.5428, 0.0751),
  ('cabinet', 16, 'tilt_deg', 90.09, 0.45),
  ('cabinet', 16, 'wall_offset', 0.4907, 0.05275),
  ('cabinet', 16, 'width', -0.4009, 0.2349),
  ('cabinet', 16, 'z_max', 1.056, 0.1655),
  ('cabinet', 16, 'z_min', -0.004986, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 17, 0.03635, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 17, 'aspect', 0.749, 0.3569),
  ('cabinet', 17, 'behind', 0.6656, 0.1223),
  ('cabinet', 17, 'corner_offset', 0.3196, 0.05758),
  ('cabinet', 17, 'edge_concave', 0.5709, 0.2207),
  ('cabinet', 17, 'edge_convex', 0.3469, 0.08258),
  ('cabinet', 17, 'edge_free', 0.07955, 0.07802),
  ('cabinet', 17, 'edge_free_top', 0.7336, 0.1101),
  ('cabinet', 17, 'edge_unseen', 0.04131, 0.1016),
  ('cabinet', 17, 'headroom', 1.746, 0.2918),
  ('cabinet', 17, 'height', 0.9231, 0.1748),
  ('cabinet', 17, 'lift', -4.689, 0.2031),
  ('cabinet', 17, 'rectangularity', 0.6176, 0.1147),
  ('cabinet', 17, 'spread_length', -0.2346, 0.263),
  ('cabinet', 17, 'spread_width', -0.646, 0.108),
  ('cabinet', 17, 'standoff', 0.7792, 0.1059),
  ('cabinet', 17, 'tilt_deg', -0.2652, 0.45),
  ('cabinet', 17, 'wall_offset', 1.195, 0.2303),
  ('cabinet', 17, 'width', -0.5466, 0.09082),
  ('cabinet', 17, 'z_max', 0.8781, 0.1513),
  ('cabinet', 17, 'z_min', 0.9341, 0.1757);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 18, 0.01722, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 18, 'aspect', 0.7536, 0.49),
  ('cabinet', 18, 'behind', 0.7193, 0.1481),
  ('cabinet', 18, 'corner_offset', 1.071, 0.2501),
  ('cabinet', 18, 'edge_concave', 0.4134, 0.1332),
  ('cabinet', 18, 'edge_convex', 0.09941, 0.1972),
  ('cabinet', 18, 'edge_free', 0.2737, 0.2077),
  ('cabinet', 18, 'edge_free_top', 0.7299, 0.1041),
  ('cabinet', 18, 'edge_unseen', 0.00761, 0.03196),
  ('cabinet', 18, 'headroom', 0.1732, 0.09456),
  ('cabinet', 18, 'height', 0.5814, 0.0225),
  ('cabinet', 18, 'lift', -4.675, 0.2711),
  ('cabinet', 18, 'rectangularity', 0.7224, 0.205),
  ('cabinet', 18, 'spread_length', -0.7066, 0.3079),
  ('cabinet', 18, 'spread_width', -1.452, 0.4647),
  ('cabinet', 18, 'standoff', 0.7836, 0.1117),
  ('cabinet', 18, 'tilt_deg', 0.4826, 0.5174),
  ('cabinet', 18, 'wall_offset', 1.117, 0.2771),
  ('cabinet', 18, 'width', -1.238, 0.4966),
  ('cabinet', 18, 'z_max', 0.5849, 0.0225),
  ('cabinet', 18, 'z_min', 0.5819, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 19, 0.01742, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 19, 'aspect', 0.9357, 1.178),
  ('cabinet', 19, 'behind', 0.1992, 0.3143),
  ('cabinet', 19, 'corner_offset', 1.659, 0.6447),
  ('cabinet', 19, 'edge_concave', 0.06045, 0.07393),
  ('cabinet', 19, 'edge_convex', 0.2514, 0.3384),
  ('cabinet', 19, 'edge_free', 0.6108, 0.2093),
  ('cabinet', 19, 'edge_free_top', 0.9906, 0.03025),
  ('cabinet', 19, 'edge_unseen', 0.4761, 0.0881),
  ('cabinet', 19, 'headroom', -0.02339, 0.03095),
  ('cabinet', 19, 'height', 0.9453, 0.2031),
  ('cabinet', 19, 'lift', -4.765, 0.0427),
  ('cabinet', 19, 'rectangularity', 0.6059, 0.04141),
  ('cabinet', 19, 'spread_length', -0.4645, 0.8676),
  ('cabinet', 19, 'spread_width', -1.625, 0.4424),
  ('cabinet', 19, 'standoff', 0.4743, 0.08212),
  ('cabinet', 19, 'tilt_deg', 89.78, 1.147),
  ('cabinet', 19, 'wall_offset', 0.6517, 0.1638),
  ('cabinet', 19, 'width', -1.166, 0.4918),
  ('cabinet', 19, 'z_max', 1.283, 0.3295),
  ('cabinet', 19, 'z_min', 0.3997, 0.3075);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 20, 0.04135, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 20, 'aspect', 0.3249, 0.3049),
  ('cabinet', 20, 'behind', 0.2754, 0.2046),
  ('cabinet', 20, 'corner_offset', 0.2138, 0.1739),
  ('cabinet', 20, 'edge_concave', 0.3983, 0.08633),
  ('cabinet', 20, 'edge_convex', 0.2829, 0.08927),
  ('cabinet', 20, 'edge_free', 0.2735, 0.2007),
  ('cabinet', 20, 'edge_free_top', 0.8737, 0.1542),
  ('cabinet', 20, 'edge_unseen', 0.323, 0.1987),
  ('cabinet', 20, 'headroom', 0.1576, 0.5747),
  ('cabinet', 20, 'height', 1.044, 0.2236),
  ('cabinet', 20, 'lift', -4.846, 0.121),
  ('cabinet', 20, 'rectangularity', 0.5216, 0.08593),
  ('cabinet', 20, 'spread_length', -0.6019, 0.09464),
  ('cabinet', 20, 'spread_width', -1.203, 0.2809),
  ('cabinet', 20, 'standoff', 0.9542, 0.245),
  ('cabinet', 20, 'tilt_deg', 47.35, 47.2),
  ('cabinet', 20, 'wall_offset', 1.177, 0.339),
  ('cabinet', 20, 'width', -0.688, 0.1474),
  ('cabinet', 20, 'z_max', 1.206, 0.3605),
  ('cabinet', 20, 'z_min', 0.881, 0.1166);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.4 WHERE name = 'aspect';
UPDATE feature SET weight = 0.4 WHERE name = 'behind';
UPDATE feature SET weight = 0.3 WHERE name = 'edge_concave';
UPDATE feature SET weight = 0.2 WHERE name = 'edge_convex';
UPDATE feature SET weight = 0.3 WHERE name = 'edge_free';
UPDATE feature SET weight = 0.2 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.2 WHERE name = 'edge_unseen';
UPDATE feature SET weight = 0.4 WHERE name = 'height';
UPDATE feature SET weight = 0.4 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.4 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.3 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.4 WHERE name = 'standoff';
UPDATE feature SET weight = 0.5 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.2 WHERE name = 'width';
UPDATE feature SET weight = 0.4 WHERE name = 'z_max';
UPDATE feature SET weight = 0.4 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.138 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0474 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0376 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.316 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0176 WHERE name = 'table';
UPDATE object_class SET prior = 0.0256 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.0836 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.00426 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0457 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0239 WHERE name = 'door';
UPDATE object_class SET prior = 0.0223 WHERE name = 'window';
UPDATE object_class SET prior = 0.0102 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0658 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.162 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.83 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.204 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 1.49 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.64 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 3.13 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 1.66 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.632 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 0.801 WHERE name = 'wall_in_one_plane';
UPDATE class_constraint SET weight = 0.874 WHERE name = 'cabinet_off_wall';
UPDATE class_constraint SET weight = 0.913 WHERE name = 'window_off_wall';
UPDATE class_constraint SET weight = 0.104 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.52 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 0.982 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.834 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 0.441 WHERE name = 'screen_within_table';
UPDATE class_constraint SET weight = 0.975 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 2.92 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 4.12 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.21 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.398 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 1.14 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.01 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 1.05 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.606 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 1.44 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.32 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 3.21 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.71 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.21 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.0343 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 0.842 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.79 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.62 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.0862 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.43 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2569 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.880' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.087' WHERE key = 'probability_offset';
