-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 5676 planes of 42 paper-like rooms, seeds from 1; 36 varied rooms, seeds from 301; 54 depth-camera frames, seeds from 101.
-- Priors and weights: 24 paper-like rooms, seeds from 11; 18 varied rooms, seeds from 401; 27 depth-camera frames, seeds from 201.

-- unknown: 2515 examples
UPDATE object_class SET prior = 0.5201 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.999, 1.234)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6059, 0.4906)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4417, 0.2892)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.455, 0.3044)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.5779, 0.4021)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_joined', 0.3117, 0.3202)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 0.979, 0.6632)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.5082, 0.7066)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.704, 0.1395)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.636, 0.7185)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.322, 0.6162)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 65.1, 36.12)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.117, 0.6203)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.226, 0.8271)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.7185, 0.7035)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0155234, 0.003548),
  ('unknown', 'area_m2', 0.0155234, 0.0323156, 0.141),
  ('unknown', 'area_m2', 0.0323156, 0.0343509, 0.1977),
  ('unknown', 'area_m2', 0.0343509, 0.0539777, 0.2205),
  ('unknown', 'area_m2', 0.0539777, 0.0745301, 0.3503),
  ('unknown', 'area_m2', 0.0745301, 0.0760132, 0.3953),
  ('unknown', 'area_m2', 0.0760132, 0.0995993, 0.377),
  ('unknown', 'area_m2', 0.0995993, 0.142062, 0.3101),
  ('unknown', 'area_m2', 0.142062, 0.168205, 0.2558),
  ('unknown', 'area_m2', 0.168205, 0.218139, 0.2656),
  ('unknown', 'area_m2', 0.218139, 0.307974, 0.3187),
  ('unknown', 'area_m2', 0.307974, 0.372212, 0.2537),
  ('unknown', 'area_m2', 0.372212, 0.521666, 0.1884),
  ('unknown', 'area_m2', 0.521666, 0.823648, 0.1265),
  ('unknown', 'area_m2', 0.823648, 1.8226, 0.03409),
  ('unknown', 'area_m2', 1.8226, 4.03314, 0.00695),
  ('unknown', 'area_m2', 4.03314, 8.92471, 0.005887),
  ('unknown', 'area_m2', 8.92471, 19.749, 0.008413),
  ('unknown', 'area_m2', 19.749, 100, 0.005719);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.10754, 1.097),
  ('unknown', 'aspect', 1.10754, 1.22528, 1.073),
  ('unknown', 'aspect', 1.22528, 1.25063, 1.003),
  ('unknown', 'aspect', 1.25063, 1.36535, 1.069),
  ('unknown', 'aspect', 1.36535, 1.5251, 0.9883),
  ('unknown', 'aspect', 1.5251, 1.56407, 0.9449),
  ('unknown', 'aspect', 1.56407, 1.7226, 0.8968),
  ('unknown', 'aspect', 1.7226, 1.95607, 0.7571),
  ('unknown', 'aspect', 1.95607, 1.99854, 0.7625),
  ('unknown', 'aspect', 1.99854, 2.41802, 0.5846),
  ('unknown', 'aspect', 2.41802, 2.44631, 0.4177),
  ('unknown', 'aspect', 2.44631, 3.05943, 0.2983),
  ('unknown', 'aspect', 3.05943, 3.8262, 0.1646),
  ('unknown', 'aspect', 3.8262, 3.88758, 0.1525),
  ('unknown', 'aspect', 3.88758, 4.78515, 0.1628),
  ('unknown', 'aspect', 4.78515, 5.98445, 0.2058),
  ('unknown', 'aspect', 5.98445, 7.48431, 0.09089),
  ('unknown', 'aspect', 7.48431, 100, 0.004025);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.0971112, 2.238),
  ('unknown', 'behind', 0.0971112, 0.107143, 0.4518),
  ('unknown', 'behind', 0.107143, 0.194222, 0.4404),
  ('unknown', 'behind', 0.194222, 0.291334, 0.6992),
  ('unknown', 'behind', 0.291334, 0.297872, 0.7851),
  ('unknown', 'behind', 0.297872, 0.388445, 0.6229),
  ('unknown', 'behind', 0.388445, 0.447368, 0.9493),
  ('unknown', 'behind', 0.447368, 0.485556, 1.06),
  ('unknown', 'behind', 0.485556, 0.550847, 1.064),
  ('unknown', 'behind', 0.550847, 0.582667, 1.127),
  ('unknown', 'behind', 0.582667, 0.637584, 1.386),
  ('unknown', 'behind', 0.637584, 0.679779, 1.282),
  ('unknown', 'behind', 0.679779, 0.714286, 1.659),
  ('unknown', 'behind', 0.714286, 0.77689, 1.594),
  ('unknown', 'behind', 0.77689, 0.783333, 1.536),
  ('unknown', 'behind', 0.783333, 0.874001, 1.178),
  ('unknown', 'behind', 0.874001, 1, 0.03707);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free', 0, 0.111111, 1.723),
  ('unknown', 'edge_free', 0.111111, 0.159342, 0.6466),
  ('unknown', 'edge_free', 0.159342, 0.222222, 0.6666),
  ('unknown', 'edge_free', 0.222222, 0.310262, 0.7846),
  ('unknown', 'edge_free', 0.310262, 0.333333, 0.8858),
  ('unknown', 'edge_free', 0.333333, 0.422551, 1.007),
  ('unknown', 'edge_free', 0.422551, 0.444444, 1.704),
  ('unknown', 'edge_free', 0.444444, 0.503848, 1.246),
  ('unknown', 'edge_free', 0.503848, 0.555556, 1.088),
  ('unknown', 'edge_free', 0.555556, 0.605755, 1.076),
  ('unknown', 'edge_free', 0.605755, 0.666667, 1.209),
  ('unknown', 'edge_free', 0.666667, 0.706463, 0.9907),
  ('unknown', 'edge_free', 0.706463, 0.777778, 0.8369),
  ('unknown', 'edge_free', 0.777778, 0.877195, 0.5042),
  ('unknown', 'edge_free', 0.877195, 0.888889, 0.4624),
  ('unknown', 'edge_free', 0.888889, 1, 0.9565);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free_top', 0, 0.0398373, 5.609),
  ('unknown', 'edge_free_top', 0.0398373, 0.111111, 0.3356),
  ('unknown', 'edge_free_top', 0.111111, 0.222222, 0.369),
  ('unknown', 'edge_free_top', 0.222222, 0.333333, 0.3664),
  ('unknown', 'edge_free_top', 0.333333, 0.34345, 0.3701),
  ('unknown', 'edge_free_top', 0.34345, 0.444444, 0.3866),
  ('unknown', 'edge_free_top', 0.444444, 0.555556, 0.4858),
  ('unknown', 'edge_free_top', 0.555556, 0.5974, 0.4882),
  ('unknown', 'edge_free_top', 0.5974, 0.666667, 0.5206),
  ('unknown', 'edge_free_top', 0.666667, 0.777778, 0.6427),
  ('unknown', 'edge_free_top', 0.777778, 0.785289, 0.5965),
  ('unknown', 'edge_free_top', 0.785289, 0.888889, 0.7185),
  ('unknown', 'edge_free_top', 0.888889, 0.919948, 1.169),
  ('unknown', 'edge_free_top', 0.919948, 1, 4.136);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_joined', 0, 0.0185687, 11.98),
  ('unknown', 'edge_joined', 0.0185687, 0.0661841, 2.284),
  ('unknown', 'edge_joined', 0.0661841, 0.111111, 1.612),
  ('unknown', 'edge_joined', 0.111111, 0.13912, 1.398),
  ('unknown', 'edge_joined', 0.13912, 0.222222, 1.017),
  ('unknown', 'edge_joined', 0.222222, 0.248242, 1.057),
  ('unknown', 'edge_joined', 0.248242, 0.333333, 0.6947),
  ('unknown', 'edge_joined', 0.333333, 0.409281, 0.6887),
  ('unknown', 'edge_joined', 0.409281, 0.444444, 0.7131),
  ('unknown', 'edge_joined', 0.444444, 0.555556, 0.5998),
  ('unknown', 'edge_joined', 0.555556, 0.582312, 0.7375),
  ('unknown', 'edge_joined', 0.582312, 0.666667, 0.518),
  ('unknown', 'edge_joined', 0.666667, 0.777778, 0.427),
  ('unknown', 'edge_joined', 0.777778, 0.8251, 0.4328),
  ('unknown', 'edge_joined', 0.8251, 0.888889, 0.3605),
  ('unknown', 'edge_joined', 0.888889, 1, 0.789);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.00790472, 0.01353),
  ('unknown', 'height', 0.00790472, 0.233132, 0.4582),
  ('unknown', 'height', 0.233132, 0.344847, 0.5686),
  ('unknown', 'height', 0.344847, 0.429448, 0.5798),
  ('unknown', 'height', 0.429448, 0.622211, 0.5768),
  ('unknown', 'height', 0.622211, 0.68179, 0.4944),
  ('unknown', 'height', 0.68179, 0.785166, 0.7687),
  ('unknown', 'height', 0.785166, 0.905846, 0.9309),
  ('unknown', 'height', 0.905846, 1.01873, 0.6136),
  ('unknown', 'height', 1.01873, 1.12082, 0.3972),
  ('unknown', 'height', 1.12082, 1.35568, 0.3742),
  ('unknown', 'height', 1.35568, 1.43633, 0.3047),
  ('unknown', 'height', 1.43633, 1.69262, 0.329),
  ('unknown', 'height', 1.69262, 1.84095, 0.1895),
  ('unknown', 'height', 1.84095, 2.02956, 0.1141),
  ('unknown', 'height', 2.02956, 2.3665, 0.1301),
  ('unknown', 'height', 2.3665, 2.70345, 0.06075),
  ('unknown', 'height', 2.70345, 3.04039, 0.0395),
  ('unknown', 'height', 3.04039, 4, 0.01156);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.153093, 0.004469),
  ('unknown', 'length', 0.153093, 0.231986, 0.1733),
  ('unknown', 'length', 0.231986, 0.260034, 0.2804),
  ('unknown', 'length', 0.260034, 0.340199, 0.4121),
  ('unknown', 'length', 0.340199, 0.351533, 0.5114),
  ('unknown', 'length', 0.351533, 0.42164, 0.5266),
  ('unknown', 'length', 0.42164, 0.512071, 0.5592),
  ('unknown', 'length', 0.512071, 0.532685, 0.473),
  ('unknown', 'length', 0.532685, 0.641543, 0.502),
  ('unknown', 'length', 0.641543, 0.804459, 0.4857),
  ('unknown', 'length', 0.804459, 1.02987, 0.4532),
  ('unknown', 'length', 1.02987, 1.22315, 0.352),
  ('unknown', 'length', 1.22315, 1.35366, 0.4951),
  ('unknown', 'length', 1.35366, 1.85347, 0.2342),
  ('unknown', 'length', 1.85347, 2.8086, 0.02995),
  ('unknown', 'length', 2.8086, 4.25593, 0.0168),
  ('unknown', 'length', 4.25593, 6.44911, 0.02149),
  ('unknown', 'length', 6.44911, 30, 0.006616);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.323748, 0.02561),
  ('unknown', 'rectangularity', 0.323748, 0.39466, 0.2526),
  ('unknown', 'rectangularity', 0.39466, 0.465572, 0.4406),
  ('unknown', 'rectangularity', 0.465572, 0.525479, 0.881),
  ('unknown', 'rectangularity', 0.525479, 0.536484, 1.669),
  ('unknown', 'rectangularity', 0.536484, 0.595523, 1.595),
  ('unknown', 'rectangularity', 0.595523, 0.607396, 2.083),
  ('unknown', 'rectangularity', 0.607396, 0.650404, 2.002),
  ('unknown', 'rectangularity', 0.650404, 0.678309, 2.368),
  ('unknown', 'rectangularity', 0.678309, 0.696928, 2.45),
  ('unknown', 'rectangularity', 0.696928, 0.739036, 2.634),
  ('unknown', 'rectangularity', 0.739036, 0.749221, 2.819),
  ('unknown', 'rectangularity', 0.749221, 0.781637, 2.586),
  ('unknown', 'rectangularity', 0.781637, 0.820133, 2.79),
  ('unknown', 'rectangularity', 0.820133, 0.869132, 2.276),
  ('unknown', 'rectangularity', 0.869132, 0.891045, 1.595),
  ('unknown', 'rectangularity', 0.891045, 0.961957, 0.9988),
  ('unknown', 'rectangularity', 0.961957, 1, 0.172);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.146576, 0.002351),
  ('unknown', 'spread_length', 0.146576, 0.222877, 0.2347),
  ('unknown', 'spread_length', 0.222877, 0.228117, 0.325),
  ('unknown', 'spread_length', 0.228117, 0.292441, 0.4431),
  ('unknown', 'spread_length', 0.292441, 0.338896, 0.6643),
  ('unknown', 'spread_length', 0.338896, 0.344995, 0.6629),
  ('unknown', 'spread_length', 0.344995, 0.433186, 0.4894),
  ('unknown', 'spread_length', 0.433186, 0.51531, 0.4192),
  ('unknown', 'spread_length', 0.51531, 0.56388, 0.4147),
  ('unknown', 'spread_length', 0.56388, 0.721509, 0.4601),
  ('unknown', 'spread_length', 0.721509, 0.783557, 0.5244),
  ('unknown', 'spread_length', 0.783557, 0.915811, 0.432),
  ('unknown', 'spread_length', 0.915811, 1.19144, 0.3659),
  ('unknown', 'spread_length', 1.19144, 1.24828, 0.335),
  ('unknown', 'spread_length', 1.24828, 1.81165, 0.2054),
  ('unknown', 'spread_length', 1.81165, 2.75471, 0.02303),
  ('unknown', 'spread_length', 2.75471, 4.18869, 0.01394),
  ('unknown', 'spread_length', 4.18869, 6.36913, 0.02121),
  ('unknown', 'spread_length', 6.36913, 40, 0.005222);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.108173, 0.0003988),
  ('unknown', 'spread_width', 0.108173, 0.110219, 0.1435),
  ('unknown', 'spread_width', 0.110219, 0.136801, 0.5002),
  ('unknown', 'spread_width', 0.136801, 0.160666, 0.5891),
  ('unknown', 'spread_width', 0.160666, 0.165008, 0.5698),
  ('unknown', 'spread_width', 0.165008, 0.197277, 0.631),
  ('unknown', 'spread_width', 0.197277, 0.221254, 0.9546),
  ('unknown', 'spread_width', 0.221254, 0.238632, 0.8857),
  ('unknown', 'spread_width', 0.238632, 0.25769, 0.5852),
  ('unknown', 'spread_width', 0.25769, 0.307139, 0.6385),
  ('unknown', 'spread_width', 0.307139, 0.354432, 0.4901),
  ('unknown', 'spread_width', 0.354432, 0.389447, 0.4067),
  ('unknown', 'spread_width', 0.389447, 0.526425, 0.3004),
  ('unknown', 'spread_width', 0.526425, 0.577617, 0.2365),
  ('unknown', 'spread_width', 0.577617, 0.781882, 0.2368),
  ('unknown', 'spread_width', 0.781882, 1.1613, 0.03966),
  ('unknown', 'spread_width', 1.1613, 1.72484, 0.01257),
  ('unknown', 'spread_width', 1.72484, 2.56185, 0.01248),
  ('unknown', 'spread_width', 2.56185, 3.80503, 0.009928),
  ('unknown', 'spread_width', 3.80503, 20, 0.005698);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 1.70419, 0.06499),
  ('unknown', 'tilt_deg', 1.70419, 10, 0.01142),
  ('unknown', 'tilt_deg', 10, 13.8349, 0.004237),
  ('unknown', 'tilt_deg', 13.8349, 20, 0.003085),
  ('unknown', 'tilt_deg', 20, 30, 0.001298),
  ('unknown', 'tilt_deg', 30, 40, 0.001042),
  ('unknown', 'tilt_deg', 40, 50, 0.0009685),
  ('unknown', 'tilt_deg', 50, 60, 0.0009599),
  ('unknown', 'tilt_deg', 60, 70, 0.0015),
  ('unknown', 'tilt_deg', 70, 77.7453, 0.004866),
  ('unknown', 'tilt_deg', 77.7453, 80, 0.006646),
  ('unknown', 'tilt_deg', 80, 86.592, 0.01445),
  ('unknown', 'tilt_deg', 86.592, 88.6014, 0.05675),
  ('unknown', 'tilt_deg', 88.6014, 89.419, 0.1468),
  ('unknown', 'tilt_deg', 89.419, 89.779, 0.4206),
  ('unknown', 'tilt_deg', 89.779, 90, 0.7611);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.112164, 0.003072),
  ('unknown', 'width', 0.112164, 0.159739, 0.2923),
  ('unknown', 'width', 0.159739, 0.166186, 0.4498),
  ('unknown', 'width', 0.166186, 0.204866, 0.4444),
  ('unknown', 'width', 0.204866, 0.238447, 0.7379),
  ('unknown', 'width', 0.238447, 0.246225, 0.8473),
  ('unknown', 'width', 0.246225, 0.276065, 0.7258),
  ('unknown', 'width', 0.276065, 0.331975, 0.6114),
  ('unknown', 'width', 0.331975, 0.364814, 0.7754),
  ('unknown', 'width', 0.364814, 0.386992, 0.593),
  ('unknown', 'width', 0.386992, 0.491695, 0.4763),
  ('unknown', 'width', 0.491695, 0.540518, 0.284),
  ('unknown', 'width', 0.540518, 0.706825, 0.3115),
  ('unknown', 'width', 0.706825, 0.800847, 0.3704),
  ('unknown', 'width', 0.800847, 1.18656, 0.09352),
  ('unknown', 'width', 1.18656, 1.75803, 0.02087),
  ('unknown', 'width', 1.75803, 2.60475, 0.01349),
  ('unknown', 'width', 2.60475, 3.85927, 0.01119),
  ('unknown', 'width', 3.85927, 12, 0.008729);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0260625, 0.01422),
  ('unknown', 'z_max', 0.0260625, 0.424894, 0.2696),
  ('unknown', 'z_max', 0.424894, 0.467611, 0.7209),
  ('unknown', 'z_max', 0.467611, 0.674755, 0.3694),
  ('unknown', 'z_max', 0.674755, 0.787785, 0.9839),
  ('unknown', 'z_max', 0.787785, 0.908722, 0.9129),
  ('unknown', 'z_max', 0.908722, 1.07855, 0.651),
  ('unknown', 'z_max', 1.07855, 1.33795, 0.4372),
  ('unknown', 'z_max', 1.33795, 1.35071, 0.304),
  ('unknown', 'z_max', 1.35071, 1.79226, 0.2387),
  ('unknown', 'z_max', 1.79226, 2.18178, 0.2823),
  ('unknown', 'z_max', 2.18178, 2.23381, 0.3832),
  ('unknown', 'z_max', 2.23381, 2.67535, 0.1096),
  ('unknown', 'z_max', 2.67535, 3.1169, 0.03853),
  ('unknown', 'z_max', 3.1169, 3.55845, 0.01855),
  ('unknown', 'z_max', 3.55845, 4, 0.04372);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.126713, 0.05081),
  ('unknown', 'z_min', -0.126713, -0.0125445, 0.8289),
  ('unknown', 'z_min', -0.0125445, 0.0545066, 1.659),
  ('unknown', 'z_min', 0.0545066, 0.246573, 0.4363),
  ('unknown', 'z_min', 0.246573, 0.315408, 0.3452),
  ('unknown', 'z_min', 0.315408, 0.61986, 0.3594),
  ('unknown', 'z_min', 0.61986, 0.74369, 0.9137),
  ('unknown', 'z_min', 0.74369, 0.865068, 0.9067),
  ('unknown', 'z_min', 0.865068, 0.993147, 0.5559),
  ('unknown', 'z_min', 0.993147, 1.10253, 0.3781),
  ('unknown', 'z_min', 1.10253, 1.36643, 0.3041),
  ('unknown', 'z_min', 1.36643, 1.55081, 0.1778),
  ('unknown', 'z_min', 1.55081, 1.73972, 0.09823),
  ('unknown', 'z_min', 1.73972, 2.11301, 0.06874),
  ('unknown', 'z_min', 2.11301, 2.48629, 0.09512),
  ('unknown', 'z_min', 2.48629, 2.85958, 0.04823),
  ('unknown', 'z_min', 2.85958, 4, 0.01025);

-- floor: 137 examples
UPDATE object_class SET prior = 0.02836 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.361, 1.47)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4644, 0.3323)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_joined', 0.2216, 0.1349)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.002009, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.202, 0.6909)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5801, 0.127)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.9193, 0.6192)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.3673, 0.7704)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.7055, 0.9698)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.7322, 0.8374)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.01209, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.009621, 0.02272)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'floor' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'area_m2', 0.002, 0.0468379, 0.002861),
  ('floor', 'area_m2', 0.0468379, 0.0927405, 0.01712),
  ('floor', 'area_m2', 0.0927405, 0.183629, 0.02648),
  ('floor', 'area_m2', 0.183629, 0.363592, 0.0792),
  ('floor', 'area_m2', 0.363592, 0.429882, 0.1073),
  ('floor', 'area_m2', 0.429882, 0.719923, 0.1111),
  ('floor', 'area_m2', 0.719923, 1.06511, 0.1232),
  ('floor', 'area_m2', 1.06511, 1.42547, 0.1296),
  ('floor', 'area_m2', 1.42547, 2.82248, 0.08453),
  ('floor', 'area_m2', 2.82248, 4.13344, 0.1219),
  ('floor', 'area_m2', 4.13344, 5.58859, 0.2387),
  ('floor', 'area_m2', 5.58859, 6.44379, 0.1967),
  ('floor', 'area_m2', 6.44379, 8.21576, 0.4536),
  ('floor', 'area_m2', 8.21576, 10.0576, 0.5499),
  ('floor', 'area_m2', 10.0576, 11.0656, 0.553),
  ('floor', 'area_m2', 11.0656, 12.1617, 0.4068),
  ('floor', 'area_m2', 12.1617, 14.7895, 0.5853),
  ('floor', 'area_m2', 14.7895, 21.9102, 0.2518),
  ('floor', 'area_m2', 21.9102, 100, 0.01014);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'aspect', 1, 1.06221, 1.875),
  ('floor', 'aspect', 1.06221, 1.16803, 1.045),
  ('floor', 'aspect', 1.16803, 1.32492, 0.997),
  ('floor', 'aspect', 1.32492, 1.36429, 1.642),
  ('floor', 'aspect', 1.36429, 1.42126, 1.18),
  ('floor', 'aspect', 1.42126, 1.59353, 0.9575),
  ('floor', 'aspect', 1.59353, 1.6275, 0.7393),
  ('floor', 'aspect', 1.6275, 1.83354, 0.839),
  ('floor', 'aspect', 1.83354, 2.09807, 0.8906),
  ('floor', 'aspect', 2.09807, 2.17403, 0.7871),
  ('floor', 'aspect', 2.17403, 2.35974, 0.9552),
  ('floor', 'aspect', 2.35974, 2.53932, 0.4111),
  ('floor', 'aspect', 2.53932, 2.966, 0.2213),
  ('floor', 'aspect', 2.966, 3.46437, 0.1649),
  ('floor', 'aspect', 3.46437, 4.04648, 0.08315),
  ('floor', 'aspect', 4.04648, 100, 0.003443);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'behind', 0, 0.00166667, 285.7),
  ('floor', 'behind', 0.00166667, 0.00333333, 189.3),
  ('floor', 'behind', 0.00333333, 0.005, 84.61),
  ('floor', 'behind', 0.005, 1, 0.06773);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'edge_free', 0, 0.00166667, 285.7),
  ('floor', 'edge_free', 0.00166667, 0.00333333, 189.3),
  ('floor', 'edge_free', 0.00333333, 0.005, 84.61),
  ('floor', 'edge_free', 0.005, 1, 0.06773);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'edge_joined', 0, 0.032372, 3.393),
  ('floor', 'edge_joined', 0.032372, 0.0639887, 1.32),
  ('floor', 'edge_joined', 0.0639887, 0.120932, 1.19),
  ('floor', 'edge_joined', 0.120932, 0.127977, 1.553),
  ('floor', 'edge_joined', 0.127977, 0.166947, 2.609),
  ('floor', 'edge_joined', 0.166947, 0.188318, 5.055),
  ('floor', 'edge_joined', 0.188318, 0.226233, 3.143),
  ('floor', 'edge_joined', 0.226233, 0.255955, 2.38),
  ('floor', 'edge_joined', 0.255955, 0.2739, 1.959),
  ('floor', 'edge_joined', 0.2739, 0.319944, 1.925),
  ('floor', 'edge_joined', 0.319944, 0.332975, 1.343),
  ('floor', 'edge_joined', 0.332975, 0.383932, 2.015),
  ('floor', 'edge_joined', 0.383932, 0.400016, 1.456),
  ('floor', 'edge_joined', 0.400016, 0.447921, 1.13),
  ('floor', 'edge_joined', 0.447921, 0.51191, 0.4227),
  ('floor', 'edge_joined', 0.51191, 0.575898, 0.1963),
  ('floor', 'edge_joined', 0.575898, 1, 0.02099);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'height', -0.5, -0.0375657, 0.02289),
  ('floor', 'height', -0.0375657, -0.0233161, 1.845),
  ('floor', 'height', -0.0233161, -0.00906651, 12.62),
  ('floor', 'height', -0.00906651, -0.000351934, 28.19),
  ('floor', 'height', -0.000351934, 0.0194327, 22.45),
  ('floor', 'height', 0.0194327, 0.0336823, 4.311),
  ('floor', 'height', 0.0336823, 0.0479319, 0.8095),
  ('floor', 'height', 0.0479319, 0.0621816, 0.3986),
  ('floor', 'height', 0.0621816, 0.0764312, 0.3296),
  ('floor', 'height', 0.0764312, 0.0906808, 0.1935),
  ('floor', 'height', 0.0906808, 4, 0.001868);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'length', 0.03, 0.415217, 0.003909),
  ('floor', 'length', 0.415217, 0.586403, 0.03864),
  ('floor', 'length', 0.586403, 0.828166, 0.08777),
  ('floor', 'length', 0.828166, 1.1696, 0.1307),
  ('floor', 'length', 1.1696, 1.24196, 0.1697),
  ('floor', 'length', 1.24196, 1.65181, 0.2531),
  ('floor', 'length', 1.65181, 1.99525, 0.2322),
  ('floor', 'length', 1.99525, 2.33282, 0.2155),
  ('floor', 'length', 2.33282, 3.29459, 0.2399),
  ('floor', 'length', 3.29459, 3.87818, 0.7125),
  ('floor', 'length', 3.87818, 4.24572, 1.123),
  ('floor', 'length', 4.24572, 4.65288, 1.081),
  ('floor', 'length', 4.65288, 4.76946, 0.6557),
  ('floor', 'length', 4.76946, 5.67598, 0.597),
  ('floor', 'length', 5.67598, 6.4469, 0.7651),
  ('floor', 'length', 6.4469, 8.63881, 0.3371),
  ('floor', 'length', 8.63881, 9.28035, 0.1758),
  ('floor', 'length', 9.28035, 30, 0.01075);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'rectangularity', 0, 0.287296, 0.04089),
  ('floor', 'rectangularity', 0.287296, 0.352793, 0.2971),
  ('floor', 'rectangularity', 0.352793, 0.41829, 1.015),
  ('floor', 'rectangularity', 0.41829, 0.431151, 1.471),
  ('floor', 'rectangularity', 0.431151, 0.483787, 1.845),
  ('floor', 'rectangularity', 0.483787, 0.521278, 3.348),
  ('floor', 'rectangularity', 0.521278, 0.549285, 3.397),
  ('floor', 'rectangularity', 0.549285, 0.591258, 2.885),
  ('floor', 'rectangularity', 0.591258, 0.614782, 3.136),
  ('floor', 'rectangularity', 0.614782, 0.629819, 2.942),
  ('floor', 'rectangularity', 0.629819, 0.680279, 2.082),
  ('floor', 'rectangularity', 0.680279, 0.745776, 1.557),
  ('floor', 'rectangularity', 0.745776, 0.752609, 1.186),
  ('floor', 'rectangularity', 0.752609, 0.811273, 1.064),
  ('floor', 'rectangularity', 0.811273, 0.87677, 0.5664),
  ('floor', 'rectangularity', 0.87677, 1, 0.0961);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_length', 0.01, 0.328754, 0.00234),
  ('floor', 'spread_length', 0.328754, 0.451653, 0.03869),
  ('floor', 'spread_length', 0.451653, 0.620495, 0.05834),
  ('floor', 'spread_length', 0.620495, 0.852455, 0.1244),
  ('floor', 'spread_length', 0.852455, 0.971303, 0.1757),
  ('floor', 'spread_length', 0.971303, 1.17113, 0.1947),
  ('floor', 'spread_length', 1.17113, 1.60893, 0.2693),
  ('floor', 'spread_length', 1.60893, 2.2104, 0.2077),
  ('floor', 'spread_length', 2.2104, 2.61764, 0.3418),
  ('floor', 'spread_length', 2.61764, 2.92684, 0.9896),
  ('floor', 'spread_length', 2.92684, 3.03672, 0.9991),
  ('floor', 'spread_length', 3.03672, 3.26548, 0.9527),
  ('floor', 'spread_length', 3.26548, 3.58358, 1.112),
  ('floor', 'spread_length', 3.58358, 3.91853, 1.159),
  ('floor', 'spread_length', 3.91853, 4.17194, 1.277),
  ('floor', 'spread_length', 4.17194, 4.34057, 0.878),
  ('floor', 'spread_length', 4.34057, 5.73155, 0.3564),
  ('floor', 'spread_length', 5.73155, 40, 0.007948);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'spread_width', 0.003, 0.13544, 0.002432),
  ('floor', 'spread_width', 0.13544, 0.142179, 0.04134),
  ('floor', 'spread_width', 0.142179, 0.194483, 0.0437),
  ('floor', 'spread_width', 0.194483, 0.279263, 0.03932),
  ('floor', 'spread_width', 0.279263, 0.401003, 0.1065),
  ('floor', 'spread_width', 0.401003, 0.455145, 0.1992),
  ('floor', 'spread_width', 0.455145, 0.575812, 0.2446),
  ('floor', 'spread_width', 0.575812, 0.717522, 0.2599),
  ('floor', 'spread_width', 0.717522, 0.826825, 0.1806),
  ('floor', 'spread_width', 0.826825, 1.18726, 0.156),
  ('floor', 'spread_width', 1.18726, 1.5547, 0.196),
  ('floor', 'spread_width', 1.5547, 1.70483, 0.4512),
  ('floor', 'spread_width', 1.70483, 1.84394, 0.7573),
  ('floor', 'spread_width', 1.84394, 2.11418, 0.778),
  ('floor', 'spread_width', 2.11418, 2.35917, 0.9553),
  ('floor', 'spread_width', 2.35917, 2.44801, 1.347),
  ('floor', 'spread_width', 2.44801, 2.56813, 1.251),
  ('floor', 'spread_width', 2.56813, 2.74204, 1.463),
  ('floor', 'spread_width', 2.74204, 3.3872, 0.5102),
  ('floor', 'spread_width', 3.3872, 3.51517, 0.1643),
  ('floor', 'spread_width', 3.51517, 20, 0.009125);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'tilt_deg', 0, 0.460076, 1.205),
  ('floor', 'tilt_deg', 0.460076, 0.920151, 0.2188),
  ('floor', 'tilt_deg', 0.920151, 1.38023, 0.2006),
  ('floor', 'tilt_deg', 1.38023, 1.52065, 0.1907),
  ('floor', 'tilt_deg', 1.52065, 1.8403, 0.1828),
  ('floor', 'tilt_deg', 1.8403, 2.13849, 0.1841),
  ('floor', 'tilt_deg', 2.13849, 2.30038, 0.1714),
  ('floor', 'tilt_deg', 2.30038, 2.76045, 0.1019),
  ('floor', 'tilt_deg', 2.76045, 3.22053, 0.03888),
  ('floor', 'tilt_deg', 3.22053, 3.6806, 0.0164),
  ('floor', 'tilt_deg', 3.6806, 4.14068, 0.01486),
  ('floor', 'tilt_deg', 4.14068, 90, 6.498e-05);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'width', 0.01, 0.196692, 0.003911),
  ('floor', 'width', 0.196692, 0.211532, 0.04873),
  ('floor', 'width', 0.211532, 0.288276, 0.05249),
  ('floor', 'width', 0.288276, 0.422503, 0.0583),
  ('floor', 'width', 0.422503, 0.602082, 0.1432),
  ('floor', 'width', 0.602082, 0.61923, 0.2331),
  ('floor', 'width', 0.61923, 0.907558, 0.2547),
  ('floor', 'width', 0.907558, 1.03261, 0.1469),
  ('floor', 'width', 1.03261, 1.33014, 0.1423),
  ('floor', 'width', 1.33014, 1.94948, 0.1804),
  ('floor', 'width', 1.94948, 2.01638, 0.2493),
  ('floor', 'width', 2.01638, 2.71352, 0.4283),
  ('floor', 'width', 2.71352, 2.8572, 0.6093),
  ('floor', 'width', 2.8572, 3.14477, 0.6256),
  ('floor', 'width', 3.14477, 3.52325, 0.943),
  ('floor', 'width', 3.52325, 3.923, 0.9696),
  ('floor', 'width', 3.923, 4.18758, 0.9597),
  ('floor', 'width', 4.18758, 4.45765, 0.8495),
  ('floor', 'width', 4.45765, 6.13741, 0.3112),
  ('floor', 'width', 6.13741, 12, 0.02095);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_max', -0.5, -0.022812, 0.04743),
  ('floor', 'z_max', -0.022812, -0.006645, 9.528),
  ('floor', 'z_max', -0.006645, 9.2536e-05, 21.47),
  ('floor', 'z_max', 9.2536e-05, 0.00952203, 23.67),
  ('floor', 'z_max', 0.00952203, 0.0191859, 17.94),
  ('floor', 'z_max', 0.0191859, 0.0256891, 11.87),
  ('floor', 'z_max', 0.0256891, 0.0326403, 8.357),
  ('floor', 'z_max', 0.0326403, 0.0418561, 5.558),
  ('floor', 'z_max', 0.0418561, 0.0580231, 2.971),
  ('floor', 'z_max', 0.0580231, 0.0741902, 1.408),
  ('floor', 'z_max', 0.0741902, 0.0903572, 0.5438),
  ('floor', 'z_max', 0.0903572, 0.106524, 0.337),
  ('floor', 'z_max', 0.106524, 0.122691, 0.2021),
  ('floor', 'z_max', 0.122691, 4, 0.001879);
DELETE FROM class_density WHERE class = 'floor' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('floor', 'z_min', -0.5, -0.127399, 0.01931),
  ('floor', 'z_min', -0.127399, -0.104945, 0.2394),
  ('floor', 'z_min', -0.104945, -0.0824917, 0.3228),
  ('floor', 'z_min', -0.0824917, -0.0600382, 0.9647),
  ('floor', 'z_min', -0.0600382, -0.0375847, 3.064),
  ('floor', 'z_min', -0.0375847, -0.0190657, 7.918),
  ('floor', 'z_min', -0.0190657, -0.00647357, 18.04),
  ('floor', 'z_min', -0.00647357, -0.00058269, 23.99),
  ('floor', 'z_min', -0.00058269, 0.00732232, 22.02),
  ('floor', 'z_min', 0.00732232, 0.0297758, 7.715),
  ('floor', 'z_min', 0.0297758, 0.0522293, 0.6313),
  ('floor', 'z_min', 0.0522293, 0.0746828, 0.2787),
  ('floor', 'z_min', 0.0746828, 4, 0.001768);

-- ceiling: 96 examples
UPDATE object_class SET prior = 0.01991 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.942, 1.115)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4246, 0.3835)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.04073, 0.1154)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.03819, 0.1126)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_joined', 0.4411, 0.2122)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.886, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.371, 0.4673)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6982, 0.1313)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.256, 0.4627)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.6584, 0.671)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.02946, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.9414, 0.7275)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.887, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.886, 0.3874)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'area_m2', 0.002, 0.201675, 0.002532),
  ('ceiling', 'area_m2', 0.201675, 0.351707, 0.03683),
  ('ceiling', 'area_m2', 0.351707, 0.613352, 0.04366),
  ('ceiling', 'area_m2', 0.613352, 1.06964, 0.0692),
  ('ceiling', 'area_m2', 1.06964, 1.15397, 0.09241),
  ('ceiling', 'area_m2', 1.15397, 1.86538, 0.07811),
  ('ceiling', 'area_m2', 1.86538, 3.2531, 0.08893),
  ('ceiling', 'area_m2', 3.2531, 5.21901, 0.1248),
  ('ceiling', 'area_m2', 5.21901, 5.67318, 0.2243),
  ('ceiling', 'area_m2', 5.67318, 7.3965, 0.3283),
  ('ceiling', 'area_m2', 7.3965, 9.62452, 0.4528),
  ('ceiling', 'area_m2', 9.62452, 11.0962, 0.6227),
  ('ceiling', 'area_m2', 11.0962, 12.3741, 1.011),
  ('ceiling', 'area_m2', 12.3741, 14.6536, 0.6194),
  ('ceiling', 'area_m2', 14.6536, 17.2538, 0.5504),
  ('ceiling', 'area_m2', 17.2538, 18.501, 0.226),
  ('ceiling', 'area_m2', 18.501, 28.1474, 0.2378),
  ('ceiling', 'area_m2', 28.1474, 30.0894, 0.05619),
  ('ceiling', 'area_m2', 30.0894, 100, 0.01195);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'aspect', 1, 1.04683, 2.222),
  ('ceiling', 'aspect', 1.04683, 1.14249, 1.349),
  ('ceiling', 'aspect', 1.14249, 1.20181, 1.856),
  ('ceiling', 'aspect', 1.20181, 1.36486, 0.9379),
  ('ceiling', 'aspect', 1.36486, 1.44436, 1.723),
  ('ceiling', 'aspect', 1.44436, 1.57341, 1.337),
  ('ceiling', 'aspect', 1.57341, 1.73585, 0.7321),
  ('ceiling', 'aspect', 1.73585, 1.84845, 0.7509),
  ('ceiling', 'aspect', 1.84845, 2.08617, 0.718),
  ('ceiling', 'aspect', 2.08617, 2.19721, 0.4744),
  ('ceiling', 'aspect', 2.19721, 2.50719, 0.2284),
  ('ceiling', 'aspect', 2.50719, 3.01317, 0.1224),
  ('ceiling', 'aspect', 3.01317, 3.62127, 0.07554),
  ('ceiling', 'aspect', 3.62127, 4.3521, 0.111),
  ('ceiling', 'aspect', 4.3521, 5.23041, 0.1204),
  ('ceiling', 'aspect', 5.23041, 100, 0.005262);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'behind', 0, 0.0501346, 16.4),
  ('ceiling', 'behind', 0.0501346, 0.100269, 0.5966),
  ('ceiling', 'behind', 0.100269, 0.116741, 0.4897),
  ('ceiling', 'behind', 0.116741, 0.150404, 0.4021),
  ('ceiling', 'behind', 0.150404, 0.200539, 0.2813),
  ('ceiling', 'behind', 0.200539, 0.250673, 0.2632),
  ('ceiling', 'behind', 0.250673, 0.300808, 0.3854),
  ('ceiling', 'behind', 0.300808, 0.350942, 0.5067),
  ('ceiling', 'behind', 0.350942, 0.401077, 0.5023),
  ('ceiling', 'behind', 0.401077, 0.451212, 0.2919),
  ('ceiling', 'behind', 0.451212, 1, 0.02625);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'edge_free', 0, 0.0519335, 15.88),
  ('ceiling', 'edge_free', 0.0519335, 0.0651135, 0.67),
  ('ceiling', 'edge_free', 0.0651135, 0.103867, 0.6173),
  ('ceiling', 'edge_free', 0.103867, 0.155801, 0.5461),
  ('ceiling', 'edge_free', 0.155801, 0.207734, 0.4177),
  ('ceiling', 'edge_free', 0.207734, 0.259668, 0.2873),
  ('ceiling', 'edge_free', 0.259668, 0.311601, 0.2643),
  ('ceiling', 'edge_free', 0.311601, 0.363535, 0.3477),
  ('ceiling', 'edge_free', 0.363535, 0.415468, 0.3412),
  ('ceiling', 'edge_free', 0.415468, 0.467402, 0.2866),
  ('ceiling', 'edge_free', 0.467402, 1, 0.025);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'edge_joined', 0, 0.0143934, 0.3307),
  ('ceiling', 'edge_joined', 0.0143934, 0.0475893, 0.3934),
  ('ceiling', 'edge_joined', 0.0475893, 0.111689, 0.5787),
  ('ceiling', 'edge_joined', 0.111689, 0.179602, 0.8712),
  ('ceiling', 'edge_joined', 0.179602, 0.208985, 1.545),
  ('ceiling', 'edge_joined', 0.208985, 0.273931, 1.062),
  ('ceiling', 'edge_joined', 0.273931, 0.306281, 1.633),
  ('ceiling', 'edge_joined', 0.306281, 0.327992, 2.112),
  ('ceiling', 'edge_joined', 0.327992, 0.393533, 1.91),
  ('ceiling', 'edge_joined', 0.393533, 0.403577, 2.36),
  ('ceiling', 'edge_joined', 0.403577, 0.448127, 1.695),
  ('ceiling', 'edge_joined', 0.448127, 0.500873, 0.9714),
  ('ceiling', 'edge_joined', 0.500873, 0.564521, 1.095),
  ('ceiling', 'edge_joined', 0.564521, 0.598169, 1.74),
  ('ceiling', 'edge_joined', 0.598169, 0.640807, 1.289),
  ('ceiling', 'edge_joined', 0.640807, 0.695464, 1.538),
  ('ceiling', 'edge_joined', 0.695464, 0.73096, 0.8109),
  ('ceiling', 'edge_joined', 0.73096, 0.79276, 0.8493),
  ('ceiling', 'edge_joined', 0.79276, 0.851473, 0.5349),
  ('ceiling', 'edge_joined', 0.851473, 0.890056, 0.2615),
  ('ceiling', 'edge_joined', 0.890056, 1, 0.06599);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'height', -0.5, 2.29357, 0.005668),
  ('ceiling', 'height', 2.29357, 2.47316, 0.4738),
  ('ceiling', 'height', 2.47316, 2.51477, 2.715),
  ('ceiling', 'height', 2.51477, 2.65276, 0.619),
  ('ceiling', 'height', 2.65276, 2.68275, 1.034),
  ('ceiling', 'height', 2.68275, 2.74885, 1.689),
  ('ceiling', 'height', 2.74885, 2.83236, 1.075),
  ('ceiling', 'height', 2.83236, 2.98167, 0.8366),
  ('ceiling', 'height', 2.98167, 3.01196, 0.6301),
  ('ceiling', 'height', 3.01196, 3.11001, 0.8932),
  ('ceiling', 'height', 3.11001, 3.19156, 0.6512),
  ('ceiling', 'height', 3.19156, 3.37115, 0.2787),
  ('ceiling', 'height', 3.37115, 3.40385, 0.3208),
  ('ceiling', 'height', 3.40385, 3.55075, 0.281),
  ('ceiling', 'height', 3.55075, 3.73035, 0.213),
  ('ceiling', 'height', 3.73035, 3.89021, 0.181),
  ('ceiling', 'height', 3.89021, 3.90995, 0.1453),
  ('ceiling', 'height', 3.90995, 4, 0.1291);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'length', 0.03, 0.790484, 0.003547),
  ('ceiling', 'length', 0.790484, 1.00323, 0.03882),
  ('ceiling', 'length', 1.00323, 1.27325, 0.06286),
  ('ceiling', 'length', 1.27325, 1.61593, 0.16),
  ('ceiling', 'length', 1.61593, 1.95819, 0.1825),
  ('ceiling', 'length', 1.95819, 2.05084, 0.1485),
  ('ceiling', 'length', 2.05084, 2.6028, 0.1944),
  ('ceiling', 'length', 2.6028, 3.24949, 0.323),
  ('ceiling', 'length', 3.24949, 3.30333, 0.3291),
  ('ceiling', 'length', 3.30333, 4.05138, 0.5859),
  ('ceiling', 'length', 4.05138, 4.19238, 1.211),
  ('ceiling', 'length', 4.19238, 4.42916, 1.237),
  ('ceiling', 'length', 4.42916, 4.70627, 1.576),
  ('ceiling', 'length', 4.70627, 5.02887, 1.608),
  ('ceiling', 'length', 5.02887, 5.32073, 1.123),
  ('ceiling', 'length', 5.32073, 5.4728, 1.258),
  ('ceiling', 'length', 5.4728, 6.02217, 1.199),
  ('ceiling', 'length', 6.02217, 6.75275, 0.8362),
  ('ceiling', 'length', 6.75275, 30, 0.01352);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'rectangularity', 0, 0.430429, 0.02141),
  ('ceiling', 'rectangularity', 0.430429, 0.490844, 0.5863),
  ('ceiling', 'rectangularity', 0.490844, 0.525579, 1.807),
  ('ceiling', 'rectangularity', 0.525579, 0.551259, 2.088),
  ('ceiling', 'rectangularity', 0.551259, 0.580084, 1.936),
  ('ceiling', 'rectangularity', 0.580084, 0.611675, 1.825),
  ('ceiling', 'rectangularity', 0.611675, 0.632, 2.441),
  ('ceiling', 'rectangularity', 0.632, 0.660829, 3.615),
  ('ceiling', 'rectangularity', 0.660829, 0.67209, 2.866),
  ('ceiling', 'rectangularity', 0.67209, 0.710656, 2.384),
  ('ceiling', 'rectangularity', 0.710656, 0.732506, 3.115),
  ('ceiling', 'rectangularity', 0.732506, 0.766331, 1.523),
  ('ceiling', 'rectangularity', 0.766331, 0.792921, 1.5),
  ('ceiling', 'rectangularity', 0.792921, 0.826432, 2.269),
  ('ceiling', 'rectangularity', 0.826432, 0.853337, 2.738),
  ('ceiling', 'rectangularity', 0.853337, 0.863285, 2.091),
  ('ceiling', 'rectangularity', 0.863285, 0.913752, 1.321),
  ('ceiling', 'rectangularity', 0.913752, 0.953337, 0.8636),
  ('ceiling', 'rectangularity', 0.953337, 0.974168, 0.4735),
  ('ceiling', 'rectangularity', 0.974168, 1, 0.2639);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_length', 0.01, 0.718513, 0.002909),
  ('ceiling', 'spread_length', 0.718513, 0.910638, 0.06225),
  ('ceiling', 'spread_length', 0.910638, 1.15413, 0.04243),
  ('ceiling', 'spread_length', 1.15413, 1.46274, 0.1572),
  ('ceiling', 'spread_length', 1.46274, 1.6831, 0.203),
  ('ceiling', 'spread_length', 1.6831, 1.85387, 0.172),
  ('ceiling', 'spread_length', 1.85387, 2.34957, 0.1539),
  ('ceiling', 'spread_length', 2.34957, 2.97783, 0.3077),
  ('ceiling', 'spread_length', 2.97783, 3.61145, 0.6573),
  ('ceiling', 'spread_length', 3.61145, 3.77408, 1.205),
  ('ceiling', 'spread_length', 3.77408, 3.89851, 1.669),
  ('ceiling', 'spread_length', 3.89851, 4.27943, 1.277),
  ('ceiling', 'spread_length', 4.27943, 4.45739, 1.938),
  ('ceiling', 'spread_length', 4.45739, 4.74037, 1.64),
  ('ceiling', 'spread_length', 4.74037, 5.12927, 1.383),
  ('ceiling', 'spread_length', 5.12927, 5.78993, 0.8226),
  ('ceiling', 'spread_length', 5.78993, 6.06223, 0.2901),
  ('ceiling', 'spread_length', 6.06223, 40, 0.008494);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_width', 0.003, 0.165672, 0.002859),
  ('ceiling', 'spread_width', 0.165672, 0.236796, 0.0193),
  ('ceiling', 'spread_width', 0.236796, 0.338456, 0.01696),
  ('ceiling', 'spread_width', 0.338456, 0.483759, 0.08564),
  ('ceiling', 'spread_width', 0.483759, 0.691443, 0.1439),
  ('ceiling', 'spread_width', 0.691443, 0.70874, 0.1418),
  ('ceiling', 'spread_width', 0.70874, 0.988288, 0.1526),
  ('ceiling', 'spread_width', 0.988288, 1.41257, 0.1588),
  ('ceiling', 'spread_width', 1.41257, 1.61637, 0.174),
  ('ceiling', 'spread_width', 1.61637, 2.01901, 0.4691),
  ('ceiling', 'spread_width', 2.01901, 2.29515, 0.9577),
  ('ceiling', 'spread_width', 2.29515, 2.57232, 0.8603),
  ('ceiling', 'spread_width', 2.57232, 2.79773, 1.193),
  ('ceiling', 'spread_width', 2.79773, 2.88579, 1.282),
  ('ceiling', 'spread_width', 2.88579, 3.04982, 1.122),
  ('ceiling', 'spread_width', 3.04982, 3.32505, 1.261),
  ('ceiling', 'spread_width', 3.32505, 3.91651, 0.5994),
  ('ceiling', 'spread_width', 3.91651, 4.1247, 0.1425),
  ('ceiling', 'spread_width', 4.1247, 20, 0.01116);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'tilt_deg', 0, 0.177075, 2.948),
  ('ceiling', 'tilt_deg', 0.177075, 0.35415, 1.741),
  ('ceiling', 'tilt_deg', 0.35415, 0.531226, 0.6482),
  ('ceiling', 'tilt_deg', 0.531226, 0.708301, 0.1928),
  ('ceiling', 'tilt_deg', 0.708301, 90, 0.0002318);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'width', 0.01, 0.184132, 0.004131),
  ('ceiling', 'width', 0.184132, 0.266863, 0.01686),
  ('ceiling', 'width', 0.266863, 0.386766, 0.01185),
  ('ceiling', 'width', 0.386766, 0.560541, 0.09263),
  ('ceiling', 'width', 0.560541, 0.812395, 0.123),
  ('ceiling', 'width', 0.812395, 0.877231, 0.1002),
  ('ceiling', 'width', 0.877231, 1.17741, 0.1435),
  ('ceiling', 'width', 1.17741, 1.70642, 0.1494),
  ('ceiling', 'width', 1.70642, 2.05082, 0.187),
  ('ceiling', 'width', 2.05082, 2.47312, 0.3456),
  ('ceiling', 'width', 2.47312, 2.60769, 0.7068),
  ('ceiling', 'width', 2.60769, 3.30656, 0.5029),
  ('ceiling', 'width', 3.30656, 3.5843, 1.119),
  ('ceiling', 'width', 3.5843, 3.86986, 1.364),
  ('ceiling', 'width', 3.86986, 4.13196, 1.704),
  ('ceiling', 'width', 4.13196, 4.55797, 1.119),
  ('ceiling', 'width', 4.55797, 5.19474, 0.7254),
  ('ceiling', 'width', 5.19474, 12, 0.02965);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_max', -0.5, 2.29399, 0.005673),
  ('ceiling', 'z_max', 2.29399, 2.47358, 0.4736),
  ('ceiling', 'z_max', 2.47358, 2.51531, 2.696),
  ('ceiling', 'z_max', 2.51531, 2.65318, 0.6247),
  ('ceiling', 'z_max', 2.65318, 2.68293, 1.034),
  ('ceiling', 'z_max', 2.68293, 2.7505, 1.68),
  ('ceiling', 'z_max', 2.7505, 2.83278, 1.072),
  ('ceiling', 'z_max', 2.83278, 2.982, 0.8362),
  ('ceiling', 'z_max', 2.982, 3.01238, 0.63),
  ('ceiling', 'z_max', 3.01238, 3.11051, 0.8896),
  ('ceiling', 'z_max', 3.11051, 3.19197, 0.6546),
  ('ceiling', 'z_max', 3.19197, 3.37157, 0.2776),
  ('ceiling', 'z_max', 3.37157, 3.40447, 0.3195),
  ('ceiling', 'z_max', 3.40447, 3.55117, 0.2813),
  ('ceiling', 'z_max', 3.55117, 3.73077, 0.2136),
  ('ceiling', 'z_max', 3.73077, 3.89197, 0.1808),
  ('ceiling', 'z_max', 3.89197, 3.91036, 0.1454),
  ('ceiling', 'z_max', 3.91036, 4, 0.1298);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_min', -0.5, 2.29342, 0.005677),
  ('ceiling', 'z_min', 2.29342, 2.47301, 0.4758),
  ('ceiling', 'z_min', 2.47301, 2.51428, 2.735),
  ('ceiling', 'z_min', 2.51428, 2.65259, 0.615),
  ('ceiling', 'z_min', 2.65259, 2.68257, 1.034),
  ('ceiling', 'z_min', 2.68257, 2.74733, 1.702),
  ('ceiling', 'z_min', 2.74733, 2.83217, 1.076),
  ('ceiling', 'z_min', 2.83217, 2.98137, 0.837),
  ('ceiling', 'z_min', 2.98137, 3.01175, 0.6304),
  ('ceiling', 'z_min', 3.01175, 3.10975, 0.8958),
  ('ceiling', 'z_min', 3.10975, 3.19134, 0.6482),
  ('ceiling', 'z_min', 3.19134, 3.37092, 0.2796),
  ('ceiling', 'z_min', 3.37092, 3.40344, 0.3216),
  ('ceiling', 'z_min', 3.40344, 3.5505, 0.2808),
  ('ceiling', 'z_min', 3.5505, 3.73008, 0.2126),
  ('ceiling', 'z_min', 3.73008, 3.88897, 0.181),
  ('ceiling', 'z_min', 3.88897, 3.90967, 0.1451),
  ('ceiling', 'z_min', 3.90967, 4, 0.1285);

-- wall: 510 examples
UPDATE object_class SET prior = 0.1057 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 1.097, 1.051)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.5767, 0.4124)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.09788, 0.1907)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.09962, 0.1774)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.06599, 0.1814)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_joined', 0.1496, 0.2023)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.407, 0.3665)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 1.045, 0.4709)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6807, 0.1486)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.8805, 0.4737)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', 0.2178, 0.6536)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.55, 1.13)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.4658, 0.6619)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.541, 0.6832)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.1668, 0.3708)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'wall' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'area_m2', 0.002, 0.234767, 0.002477),
  ('wall', 'area_m2', 0.234767, 0.377641, 0.05658),
  ('wall', 'area_m2', 0.377641, 0.607465, 0.1139),
  ('wall', 'area_m2', 0.607465, 0.713296, 0.1365),
  ('wall', 'area_m2', 0.713296, 0.977155, 0.1816),
  ('wall', 'area_m2', 0.977155, 1.20546, 0.2423),
  ('wall', 'area_m2', 1.20546, 1.57183, 0.2563),
  ('wall', 'area_m2', 1.57183, 1.92878, 0.2313),
  ('wall', 'area_m2', 1.92878, 2.52841, 0.2445),
  ('wall', 'area_m2', 2.52841, 2.96501, 0.2509),
  ('wall', 'area_m2', 2.96501, 4.06715, 0.2741),
  ('wall', 'area_m2', 4.06715, 4.39887, 0.31),
  ('wall', 'area_m2', 4.39887, 5.82279, 0.4058),
  ('wall', 'area_m2', 5.82279, 6.54233, 0.4052),
  ('wall', 'area_m2', 6.54233, 7.53568, 0.4298),
  ('wall', 'area_m2', 7.53568, 9.96127, 0.395),
  ('wall', 'area_m2', 9.96127, 10.5239, 0.3055),
  ('wall', 'area_m2', 10.5239, 16.9284, 0.1918),
  ('wall', 'area_m2', 16.9284, 100, 0.002699);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'aspect', 1, 1.1334, 0.8941),
  ('wall', 'aspect', 1.1334, 1.23637, 0.7641),
  ('wall', 'aspect', 1.23637, 1.28117, 1.181),
  ('wall', 'aspect', 1.28117, 1.40905, 1.182),
  ('wall', 'aspect', 1.40905, 1.52862, 0.8695),
  ('wall', 'aspect', 1.52862, 1.56437, 1.584),
  ('wall', 'aspect', 1.56437, 1.70016, 1.291),
  ('wall', 'aspect', 1.70016, 1.88994, 0.805),
  ('wall', 'aspect', 1.88994, 1.94553, 0.9609),
  ('wall', 'aspect', 1.94553, 2.26211, 0.7667),
  ('wall', 'aspect', 2.26211, 2.33667, 0.458),
  ('wall', 'aspect', 2.33667, 2.88899, 0.4421),
  ('wall', 'aspect', 2.88899, 2.97904, 0.1764),
  ('wall', 'aspect', 2.97904, 3.57187, 0.1487),
  ('wall', 'aspect', 3.57187, 4.41616, 0.172),
  ('wall', 'aspect', 4.41616, 5.46001, 0.1221),
  ('wall', 'aspect', 5.46001, 6.75061, 0.04542),
  ('wall', 'aspect', 6.75061, 100, 0.003876);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'behind', 0, 0.00126034, 202.2),
  ('wall', 'behind', 0.00126034, 0.081172, 5.952),
  ('wall', 'behind', 0.081172, 0.150849, 0.6269),
  ('wall', 'behind', 0.150849, 0.162344, 0.722),
  ('wall', 'behind', 0.162344, 0.243516, 0.597),
  ('wall', 'behind', 0.243516, 0.324688, 0.5011),
  ('wall', 'behind', 0.324688, 0.379093, 0.2986),
  ('wall', 'behind', 0.379093, 0.40586, 0.2877),
  ('wall', 'behind', 0.40586, 0.487032, 0.2411),
  ('wall', 'behind', 0.487032, 0.568204, 0.3632),
  ('wall', 'behind', 0.568204, 0.649376, 0.2991),
  ('wall', 'behind', 0.649376, 0.730548, 0.241),
  ('wall', 'behind', 0.730548, 1, 0.04282);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'edge_free', 0, 0.0150753, 43.29),
  ('wall', 'edge_free', 0.0150753, 0.0931373, 0.4239),
  ('wall', 'edge_free', 0.0931373, 0.186275, 0.7401),
  ('wall', 'edge_free', 0.186275, 0.21091, 0.8312),
  ('wall', 'edge_free', 0.21091, 0.279412, 1.252),
  ('wall', 'edge_free', 0.279412, 0.319898, 0.7488),
  ('wall', 'edge_free', 0.319898, 0.372549, 0.6147),
  ('wall', 'edge_free', 0.372549, 0.465687, 0.3216),
  ('wall', 'edge_free', 0.465687, 0.558824, 0.1782),
  ('wall', 'edge_free', 0.558824, 0.651961, 0.05434),
  ('wall', 'edge_free', 0.651961, 0.745099, 0.0453),
  ('wall', 'edge_free', 0.745099, 0.838236, 0.1048),
  ('wall', 'edge_free', 0.838236, 1, 0.0673);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'edge_free_top', 0, 0.111111, 7.525),
  ('wall', 'edge_free_top', 0.111111, 0.187635, 0.5504),
  ('wall', 'edge_free_top', 0.187635, 0.222222, 0.4577),
  ('wall', 'edge_free_top', 0.222222, 0.333333, 0.249),
  ('wall', 'edge_free_top', 0.333333, 0.444444, 0.2591),
  ('wall', 'edge_free_top', 0.444444, 0.555556, 0.1305),
  ('wall', 'edge_free_top', 0.555556, 0.666667, 0.07086),
  ('wall', 'edge_free_top', 0.666667, 0.777778, 0.04318),
  ('wall', 'edge_free_top', 0.777778, 0.888889, 0.05781),
  ('wall', 'edge_free_top', 0.888889, 1, 0.1429);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'edge_joined', 0, 0.0126306, 17.35),
  ('wall', 'edge_joined', 0.0126306, 0.0268579, 7.645),
  ('wall', 'edge_joined', 0.0268579, 0.046091, 5.702),
  ('wall', 'edge_joined', 0.046091, 0.0763901, 3.659),
  ('wall', 'edge_joined', 0.0763901, 0.106536, 2.108),
  ('wall', 'edge_joined', 0.106536, 0.140406, 1.521),
  ('wall', 'edge_joined', 0.140406, 0.213073, 1.284),
  ('wall', 'edge_joined', 0.213073, 0.231798, 0.8451),
  ('wall', 'edge_joined', 0.231798, 0.319609, 0.6818),
  ('wall', 'edge_joined', 0.319609, 0.412919, 0.6003),
  ('wall', 'edge_joined', 0.412919, 0.426145, 0.6073),
  ('wall', 'edge_joined', 0.426145, 0.532681, 0.37),
  ('wall', 'edge_joined', 0.532681, 0.639218, 0.208),
  ('wall', 'edge_joined', 0.639218, 0.745754, 0.1434),
  ('wall', 'edge_joined', 0.745754, 0.85229, 0.09806),
  ('wall', 'edge_joined', 0.85229, 0.958826, 0.07383),
  ('wall', 'edge_joined', 0.958826, 1, 0.1996);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'height', -0.5, 0.295707, 0.01409),
  ('wall', 'height', 0.295707, 0.518256, 0.09492),
  ('wall', 'height', 0.518256, 0.740806, 0.1357),
  ('wall', 'height', 0.740806, 0.963355, 0.2039),
  ('wall', 'height', 0.963355, 0.977145, 0.1817),
  ('wall', 'height', 0.977145, 1.18591, 0.3226),
  ('wall', 'height', 1.18591, 1.22912, 1.053),
  ('wall', 'height', 1.22912, 1.32538, 1.136),
  ('wall', 'height', 1.32538, 1.3952, 1.592),
  ('wall', 'height', 1.3952, 1.40845, 1.331),
  ('wall', 'height', 1.40845, 1.45738, 1.895),
  ('wall', 'height', 1.45738, 1.53721, 1.409),
  ('wall', 'height', 1.53721, 1.63002, 1.186),
  ('wall', 'height', 1.63002, 1.79029, 0.7025),
  ('wall', 'height', 1.79029, 1.85355, 0.3148),
  ('wall', 'height', 1.85355, 2.0761, 0.2409),
  ('wall', 'height', 2.0761, 2.29865, 0.1242),
  ('wall', 'height', 2.29865, 4, 0.005636);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'length', 0.03, 0.724547, 0.002934),
  ('wall', 'length', 0.724547, 0.925733, 0.06295),
  ('wall', 'length', 0.925733, 1.18278, 0.1032),
  ('wall', 'length', 1.18278, 1.49466, 0.2637),
  ('wall', 'length', 1.49466, 1.93082, 0.3301),
  ('wall', 'length', 1.93082, 2.11593, 0.2813),
  ('wall', 'length', 2.11593, 2.46695, 0.6853),
  ('wall', 'length', 2.46695, 2.74244, 1.074),
  ('wall', 'length', 2.74244, 3.15195, 0.757),
  ('wall', 'length', 3.15195, 3.72726, 0.7341),
  ('wall', 'length', 3.72726, 4.02715, 0.9518),
  ('wall', 'length', 4.02715, 4.2082, 0.7365),
  ('wall', 'length', 4.2082, 4.82473, 0.8402),
  ('wall', 'length', 4.82473, 5.14537, 0.5404),
  ('wall', 'length', 5.14537, 6.57408, 0.2779),
  ('wall', 'length', 6.57408, 30, 0.004522);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'rectangularity', 0, 0.331033, 0.03177),
  ('wall', 'rectangularity', 0.331033, 0.403975, 0.2849),
  ('wall', 'rectangularity', 0.403975, 0.476918, 0.958),
  ('wall', 'rectangularity', 0.476918, 0.484276, 1.416),
  ('wall', 'rectangularity', 0.484276, 0.54986, 1.425),
  ('wall', 'rectangularity', 0.54986, 0.559611, 1.848),
  ('wall', 'rectangularity', 0.559611, 0.620299, 1.857),
  ('wall', 'rectangularity', 0.620299, 0.664899, 2.492),
  ('wall', 'rectangularity', 0.664899, 0.695745, 2.732),
  ('wall', 'rectangularity', 0.695745, 0.705723, 2.578),
  ('wall', 'rectangularity', 0.705723, 0.750407, 2.458),
  ('wall', 'rectangularity', 0.750407, 0.768687, 1.722),
  ('wall', 'rectangularity', 0.768687, 0.80516, 2.209),
  ('wall', 'rectangularity', 0.80516, 0.84163, 1.776),
  ('wall', 'rectangularity', 0.84163, 0.871216, 1.602),
  ('wall', 'rectangularity', 0.871216, 0.914572, 1.105),
  ('wall', 'rectangularity', 0.914572, 0.986055, 0.7876),
  ('wall', 'rectangularity', 0.986055, 1, 0.3518);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_length', 0.01, 0.629369, 0.002245),
  ('wall', 'spread_length', 0.629369, 0.805672, 0.06493),
  ('wall', 'spread_length', 0.805672, 1.03136, 0.1182),
  ('wall', 'spread_length', 1.03136, 1.26407, 0.269),
  ('wall', 'spread_length', 1.26407, 1.32028, 0.2961),
  ('wall', 'spread_length', 1.32028, 1.68632, 0.4056),
  ('wall', 'spread_length', 1.68632, 2.09799, 0.5146),
  ('wall', 'spread_length', 2.09799, 2.16357, 0.6409),
  ('wall', 'spread_length', 2.16357, 2.39561, 0.9273),
  ('wall', 'spread_length', 2.39561, 2.67506, 0.9803),
  ('wall', 'spread_length', 2.67506, 2.76964, 0.9208),
  ('wall', 'spread_length', 2.76964, 3.14145, 0.6218),
  ('wall', 'spread_length', 3.14145, 3.54549, 0.7787),
  ('wall', 'spread_length', 3.54549, 3.66815, 0.4912),
  ('wall', 'spread_length', 3.66815, 4.18186, 0.8496),
  ('wall', 'spread_length', 4.18186, 4.53868, 0.5748),
  ('wall', 'spread_length', 4.53868, 5.81009, 0.2294),
  ('wall', 'spread_length', 5.81009, 40, 0.0039);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_width', 0.003, 0.218797, 0.002857),
  ('wall', 'spread_width', 0.218797, 0.296797, 0.04676),
  ('wall', 'spread_width', 0.296797, 0.402603, 0.107),
  ('wall', 'spread_width', 0.402603, 0.486092, 0.2583),
  ('wall', 'spread_width', 0.486092, 0.546129, 0.3257),
  ('wall', 'spread_width', 0.546129, 0.700379, 0.2901),
  ('wall', 'spread_width', 0.700379, 0.74082, 0.3259),
  ('wall', 'spread_width', 0.74082, 1.00258, 0.3225),
  ('wall', 'spread_width', 1.00258, 1.26227, 0.4849),
  ('wall', 'spread_width', 1.26227, 1.36317, 0.4408),
  ('wall', 'spread_width', 1.36317, 1.63133, 0.4245),
  ('wall', 'spread_width', 1.63133, 1.84913, 0.7582),
  ('wall', 'spread_width', 1.84913, 1.91006, 0.6675),
  ('wall', 'spread_width', 1.91006, 2.18808, 0.7532),
  ('wall', 'spread_width', 2.18808, 2.50833, 0.7322),
  ('wall', 'spread_width', 2.50833, 2.56272, 0.6173),
  ('wall', 'spread_width', 2.56272, 3.40253, 0.3716),
  ('wall', 'spread_width', 3.40253, 20, 0.003838);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'tilt_deg', 0, 83.3784, 0.0001139),
  ('wall', 'tilt_deg', 83.3784, 84.1142, 0.00468),
  ('wall', 'tilt_deg', 84.1142, 84.8499, 0.003267),
  ('wall', 'tilt_deg', 84.8499, 85.5856, 0.008542),
  ('wall', 'tilt_deg', 85.5856, 86.3213, 0.01848),
  ('wall', 'tilt_deg', 86.3213, 87.0571, 0.02332),
  ('wall', 'tilt_deg', 87.0571, 87.7928, 0.03989),
  ('wall', 'tilt_deg', 87.7928, 88.5285, 0.04067),
  ('wall', 'tilt_deg', 88.5285, 89.2643, 0.07558),
  ('wall', 'tilt_deg', 89.2643, 89.8691, 0.8059),
  ('wall', 'tilt_deg', 89.8691, 90, 2.638);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'width', 0.01, 0.275447, 0.003474),
  ('wall', 'width', 0.275447, 0.371611, 0.05217),
  ('wall', 'width', 0.371611, 0.501347, 0.09758),
  ('wall', 'width', 0.501347, 0.598836, 0.2922),
  ('wall', 'width', 0.598836, 0.676377, 0.2862),
  ('wall', 'width', 0.676377, 0.873903, 0.2903),
  ('wall', 'width', 0.873903, 0.912513, 0.3206),
  ('wall', 'width', 0.912513, 1.21891, 0.3448),
  ('wall', 'width', 1.21891, 1.63938, 0.3932),
  ('wall', 'width', 1.63938, 2.24073, 0.2498),
  ('wall', 'width', 2.24073, 2.39345, 0.4908),
  ('wall', 'width', 2.39345, 2.60827, 1.274),
  ('wall', 'width', 2.60827, 2.79659, 1.518),
  ('wall', 'width', 2.79659, 3.02301, 1.248),
  ('wall', 'width', 3.02301, 3.08942, 1.089),
  ('wall', 'width', 3.08942, 3.88275, 0.4202),
  ('wall', 'width', 3.88275, 4.07841, 0.1051),
  ('wall', 'width', 4.07841, 12, 0.004197);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_max', -0.5, 0.614195, 0.007784),
  ('wall', 'z_max', 0.614195, 0.976401, 0.04859),
  ('wall', 'z_max', 0.976401, 1.33861, 0.1095),
  ('wall', 'z_max', 1.33861, 1.49164, 0.2961),
  ('wall', 'z_max', 1.49164, 1.70081, 0.2345),
  ('wall', 'z_max', 1.70081, 2.06302, 0.1386),
  ('wall', 'z_max', 2.06302, 2.22753, 0.08582),
  ('wall', 'z_max', 2.22753, 2.42522, 0.2711),
  ('wall', 'z_max', 2.42522, 2.47939, 1.035),
  ('wall', 'z_max', 2.47939, 2.58019, 1.126),
  ('wall', 'z_max', 2.58019, 2.72042, 0.7971),
  ('wall', 'z_max', 2.72042, 2.78743, 1.183),
  ('wall', 'z_max', 2.78743, 2.83765, 0.5986),
  ('wall', 'z_max', 2.83765, 2.99483, 0.6964),
  ('wall', 'z_max', 2.99483, 3.14964, 0.5977),
  ('wall', 'z_max', 3.14964, 3.19606, 0.3022),
  ('wall', 'z_max', 3.19606, 3.51184, 0.1778),
  ('wall', 'z_max', 3.51184, 3.87405, 0.1337),
  ('wall', 'z_max', 3.87405, 4, 0.0837);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_min', -0.5, -0.152133, 0.04171),
  ('wall', 'z_min', -0.152133, -0.0243225, 1.226),
  ('wall', 'z_min', -0.0243225, -0.0155448, 15.34),
  ('wall', 'z_min', -0.0155448, -0.0067997, 18.32),
  ('wall', 'z_min', -0.0067997, 0.00230213, 14.65),
  ('wall', 'z_min', 0.00230213, 0.0563908, 2.314),
  ('wall', 'z_min', 0.0563908, 0.218937, 0.287),
  ('wall', 'z_min', 0.218937, 0.264914, 0.2514),
  ('wall', 'z_min', 0.264914, 0.473438, 0.2014),
  ('wall', 'z_min', 0.473438, 0.680452, 0.3219),
  ('wall', 'z_min', 0.680452, 0.890485, 0.1898),
  ('wall', 'z_min', 0.890485, 1.09901, 0.1526),
  ('wall', 'z_min', 1.09901, 1.30753, 0.07209),
  ('wall', 'z_min', 1.30753, 1.51606, 0.01396),
  ('wall', 'z_min', 1.51606, 1.72458, 0.04646),
  ('wall', 'z_min', 1.72458, 4, 0.004077);

-- table: 222 examples
UPDATE object_class SET prior = 0.04607 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.3793, 0.6506)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5331, 0.281)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5248, 0.2125)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.4263, 0.195)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_joined', 0.3122, 0.1979)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7446, 0.122)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.2565, 0.3344)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.7106, 0.1217)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1197, 0.3317)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4672, 0.3646)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.7852, 0.6552)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.28, 0.3442)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7527, 0.1219)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7382, 0.1217)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'table' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'area_m2', 0.002, 0.0833362, 0.00234),
  ('table', 'area_m2', 0.0833362, 0.119927, 0.03434),
  ('table', 'area_m2', 0.119927, 0.172583, 0.06242),
  ('table', 'area_m2', 0.172583, 0.248359, 0.09609),
  ('table', 'area_m2', 0.248359, 0.307893, 0.1369),
  ('table', 'area_m2', 0.307893, 0.357406, 0.2558),
  ('table', 'area_m2', 0.357406, 0.436478, 0.394),
  ('table', 'area_m2', 0.436478, 0.514333, 0.4413),
  ('table', 'area_m2', 0.514333, 0.567149, 0.4357),
  ('table', 'area_m2', 0.567149, 0.695733, 0.5061),
  ('table', 'area_m2', 0.695733, 0.740161, 0.6351),
  ('table', 'area_m2', 0.740161, 0.893683, 0.4221),
  ('table', 'area_m2', 0.893683, 1.01698, 0.845),
  ('table', 'area_m2', 1.01698, 1.06514, 0.9667),
  ('table', 'area_m2', 1.06514, 1.15179, 0.8406),
  ('table', 'area_m2', 1.15179, 1.32924, 0.7262),
  ('table', 'area_m2', 1.32924, 1.53282, 0.4201),
  ('table', 'area_m2', 1.53282, 2.20583, 0.121),
  ('table', 'area_m2', 2.20583, 100, 0.002568);
DELETE FROM class_density WHERE class = 'table' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'aspect', 1, 1.01743, 0.7328),
  ('table', 'aspect', 1.01743, 1.15735, 0.7433),
  ('table', 'aspect', 1.15735, 1.33946, 0.703),
  ('table', 'aspect', 1.33946, 1.51918, 0.9878),
  ('table', 'aspect', 1.51918, 1.55023, 1.569),
  ('table', 'aspect', 1.55023, 1.66087, 1.126),
  ('table', 'aspect', 1.66087, 1.79417, 1.498),
  ('table', 'aspect', 1.79417, 1.94076, 1.399),
  ('table', 'aspect', 1.94076, 2.07648, 1.326),
  ('table', 'aspect', 2.07648, 2.10375, 1.742),
  ('table', 'aspect', 2.10375, 2.39681, 0.8265),
  ('table', 'aspect', 2.39681, 2.78137, 0.4311),
  ('table', 'aspect', 2.78137, 3.21903, 0.1874),
  ('table', 'aspect', 3.21903, 3.72555, 0.049),
  ('table', 'aspect', 3.72555, 100, 0.003272);
DELETE FROM class_density WHERE class = 'table' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'behind', 0, 0.0920173, 0.5384),
  ('table', 'behind', 0.0920173, 0.184035, 0.4574),
  ('table', 'behind', 0.184035, 0.212018, 0.6145),
  ('table', 'behind', 0.212018, 0.276052, 0.6806),
  ('table', 'behind', 0.276052, 0.36066, 0.8386),
  ('table', 'behind', 0.36066, 0.458684, 1.145),
  ('table', 'behind', 0.458684, 0.552104, 1.144),
  ('table', 'behind', 0.552104, 0.627953, 1.574),
  ('table', 'behind', 0.627953, 0.644121, 2.222),
  ('table', 'behind', 0.644121, 0.673988, 2.347),
  ('table', 'behind', 0.673988, 0.700684, 3.981),
  ('table', 'behind', 0.700684, 0.728917, 4.076),
  ('table', 'behind', 0.728917, 0.822222, 1.094),
  ('table', 'behind', 0.822222, 1, 0.04914);
DELETE FROM class_density WHERE class = 'table' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'edge_free', 0, 0.106236, 0.4343),
  ('table', 'edge_free', 0.106236, 0.193078, 0.6607),
  ('table', 'edge_free', 0.193078, 0.212471, 0.9094),
  ('table', 'edge_free', 0.212471, 0.280043, 1.587),
  ('table', 'edge_free', 0.280043, 0.318707, 1.887),
  ('table', 'edge_free', 0.318707, 0.336885, 1.608),
  ('table', 'edge_free', 0.336885, 0.386776, 2.183),
  ('table', 'edge_free', 0.386776, 0.424943, 2.864),
  ('table', 'edge_free', 0.424943, 0.512655, 1.347),
  ('table', 'edge_free', 0.512655, 0.531178, 1.524),
  ('table', 'edge_free', 0.531178, 0.58719, 1.455),
  ('table', 'edge_free', 0.58719, 0.637414, 1.772),
  ('table', 'edge_free', 0.637414, 0.666129, 0.8555),
  ('table', 'edge_free', 0.666129, 0.74365, 0.6616),
  ('table', 'edge_free', 0.74365, 0.849885, 0.3294),
  ('table', 'edge_free', 0.849885, 0.956121, 0.1576),
  ('table', 'edge_free', 0.956121, 1, 0.1524);
DELETE FROM class_density WHERE class = 'table' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'edge_joined', 0, 0.0554617, 2.013),
  ('table', 'edge_joined', 0.0554617, 0.0911931, 1.109),
  ('table', 'edge_joined', 0.0911931, 0.140047, 1.416),
  ('table', 'edge_joined', 0.140047, 0.182386, 1.416),
  ('table', 'edge_joined', 0.182386, 0.204932, 2.22),
  ('table', 'edge_joined', 0.204932, 0.261543, 1.96),
  ('table', 'edge_joined', 0.261543, 0.273579, 1.645),
  ('table', 'edge_joined', 0.273579, 0.342125, 1.375),
  ('table', 'edge_joined', 0.342125, 0.364772, 2.181),
  ('table', 'edge_joined', 0.364772, 0.390317, 2.353),
  ('table', 'edge_joined', 0.390317, 0.455965, 1.485),
  ('table', 'edge_joined', 0.455965, 0.46433, 1.8),
  ('table', 'edge_joined', 0.46433, 0.547158, 0.9628),
  ('table', 'edge_joined', 0.547158, 0.588935, 0.8511),
  ('table', 'edge_joined', 0.588935, 0.638351, 1.076),
  ('table', 'edge_joined', 0.638351, 0.729545, 0.3503),
  ('table', 'edge_joined', 0.729545, 0.820738, 0.1302),
  ('table', 'edge_joined', 0.820738, 1, 0.05684);
DELETE FROM class_density WHERE class = 'table' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'height', -0.5, 0.105829, 0.02116),
  ('table', 'height', 0.105829, 0.221233, 3.939e-06),
  ('table', 'height', 0.221233, 0.336636, 0.0001793),
  ('table', 'height', 0.336636, 0.45204, 0.003475),
  ('table', 'height', 0.45204, 0.567443, 0.02938),
  ('table', 'height', 0.567443, 0.652885, 1.2),
  ('table', 'height', 0.652885, 0.682847, 3.165),
  ('table', 'height', 0.682847, 0.708183, 5.292),
  ('table', 'height', 0.708183, 0.724481, 5.892),
  ('table', 'height', 0.724481, 0.740506, 6.155),
  ('table', 'height', 0.740506, 0.762681, 5.276),
  ('table', 'height', 0.762681, 0.783479, 4.62),
  ('table', 'height', 0.783479, 0.79825, 3.149),
  ('table', 'height', 0.79825, 0.848006, 1.596),
  ('table', 'height', 0.848006, 0.913654, 0.7269),
  ('table', 'height', 0.913654, 1.02906, 0.313),
  ('table', 'height', 1.02906, 1.14446, 0.2527),
  ('table', 'height', 1.14446, 4, 0.001834);
DELETE FROM class_density WHERE class = 'table' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'length', 0.03, 0.536961, 0.002962),
  ('table', 'length', 0.536961, 0.639619, 0.08425),
  ('table', 'length', 0.639619, 0.761903, 0.2939),
  ('table', 'length', 0.761903, 0.806039, 0.4958),
  ('table', 'length', 0.806039, 0.907566, 0.439),
  ('table', 'length', 0.907566, 0.975371, 0.8729),
  ('table', 'length', 0.975371, 1.08108, 0.8566),
  ('table', 'length', 1.08108, 1.13518, 0.5836),
  ('table', 'length', 1.13518, 1.26009, 1.06),
  ('table', 'length', 1.26009, 1.28776, 0.9498),
  ('table', 'length', 1.28776, 1.42242, 0.9633),
  ('table', 'length', 1.42242, 1.53396, 0.8942),
  ('table', 'length', 1.53396, 1.5798, 1.328),
  ('table', 'length', 1.5798, 1.71081, 1.4),
  ('table', 'length', 1.71081, 1.82722, 0.9358),
  ('table', 'length', 1.82722, 1.88874, 1.312),
  ('table', 'length', 1.88874, 2.17656, 0.5804),
  ('table', 'length', 2.17656, 2.59268, 0.1183),
  ('table', 'length', 2.59268, 30, 0.005088);
DELETE FROM class_density WHERE class = 'table' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'rectangularity', 0, 0.38076, 0.02444),
  ('table', 'rectangularity', 0.38076, 0.445779, 0.172),
  ('table', 'rectangularity', 0.445779, 0.510798, 0.618),
  ('table', 'rectangularity', 0.510798, 0.538804, 1.677),
  ('table', 'rectangularity', 0.538804, 0.575817, 1.17),
  ('table', 'rectangularity', 0.575817, 0.621727, 1.6),
  ('table', 'rectangularity', 0.621727, 0.640836, 2.76),
  ('table', 'rectangularity', 0.640836, 0.664429, 2.462),
  ('table', 'rectangularity', 0.664429, 0.704607, 2.769),
  ('table', 'rectangularity', 0.704607, 0.734785, 3.788),
  ('table', 'rectangularity', 0.734785, 0.770874, 2.811),
  ('table', 'rectangularity', 0.770874, 0.808505, 3.037),
  ('table', 'rectangularity', 0.808505, 0.835893, 2.5),
  ('table', 'rectangularity', 0.835893, 0.859, 2.034),
  ('table', 'rectangularity', 0.859, 0.900912, 1.413),
  ('table', 'rectangularity', 0.900912, 0.959089, 0.6829),
  ('table', 'rectangularity', 0.959089, 0.965932, 0.3203),
  ('table', 'rectangularity', 0.965932, 1, 0.2007);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_length', 0.01, 0.472557, 0.003194),
  ('table', 'spread_length', 0.472557, 0.564056, 0.1403),
  ('table', 'spread_length', 0.564056, 0.673271, 0.1759),
  ('table', 'spread_length', 0.673271, 0.745857, 0.436),
  ('table', 'spread_length', 0.745857, 0.803633, 0.586),
  ('table', 'spread_length', 0.803633, 0.864428, 0.8415),
  ('table', 'spread_length', 0.864428, 0.959235, 0.9658),
  ('table', 'spread_length', 0.959235, 0.991868, 0.6206),
  ('table', 'spread_length', 0.991868, 1.11217, 0.8935),
  ('table', 'spread_length', 1.11217, 1.14497, 0.9554),
  ('table', 'spread_length', 1.14497, 1.24204, 1.155),
  ('table', 'spread_length', 1.24204, 1.34541, 1.313),
  ('table', 'spread_length', 1.34541, 1.36666, 1.226),
  ('table', 'spread_length', 1.36666, 1.46965, 1.192),
  ('table', 'spread_length', 1.46965, 1.62371, 1.079),
  ('table', 'spread_length', 1.62371, 1.94713, 0.4762),
  ('table', 'spread_length', 1.94713, 2.32415, 0.1246),
  ('table', 'spread_length', 2.32415, 40, 0.003447);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_width', 0.003, 0.178461, 0.002427),
  ('table', 'spread_width', 0.178461, 0.222092, 0.07449),
  ('table', 'spread_width', 0.222092, 0.27639, 0.09271),
  ('table', 'spread_width', 0.27639, 0.343963, 0.1521),
  ('table', 'spread_width', 0.343963, 0.403131, 0.1997),
  ('table', 'spread_width', 0.403131, 0.428056, 0.2464),
  ('table', 'spread_width', 0.428056, 0.514141, 0.5239),
  ('table', 'spread_width', 0.514141, 0.532709, 0.9037),
  ('table', 'spread_width', 0.532709, 0.618707, 0.6135),
  ('table', 'spread_width', 0.618707, 0.659938, 1.587),
  ('table', 'spread_width', 0.659938, 0.702406, 1.842),
  ('table', 'spread_width', 0.702406, 0.73854, 1.996),
  ('table', 'spread_width', 0.73854, 0.811009, 1.226),
  ('table', 'spread_width', 0.811009, 0.825027, 1.406),
  ('table', 'spread_width', 0.825027, 0.877012, 1.429),
  ('table', 'spread_width', 0.877012, 1.02673, 0.462),
  ('table', 'spread_width', 1.02673, 1.27775, 0.1222),
  ('table', 'spread_width', 1.27775, 20, 0.003954);
DELETE FROM class_density WHERE class = 'table' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'tilt_deg', 0, 0.156986, 0.8564),
  ('table', 'tilt_deg', 0.156986, 0.355863, 0.8563),
  ('table', 'tilt_deg', 0.355863, 0.49594, 0.7939),
  ('table', 'tilt_deg', 0.49594, 0.644414, 0.6799),
  ('table', 'tilt_deg', 0.644414, 0.928289, 0.4943),
  ('table', 'tilt_deg', 0.928289, 1.08512, 0.3749),
  ('table', 'tilt_deg', 1.08512, 1.20854, 0.3386),
  ('table', 'tilt_deg', 1.20854, 1.44682, 0.2925),
  ('table', 'tilt_deg', 1.44682, 1.70532, 0.228),
  ('table', 'tilt_deg', 1.70532, 2.17024, 0.1452),
  ('table', 'tilt_deg', 2.17024, 2.53194, 0.05698),
  ('table', 'tilt_deg', 2.53194, 2.89365, 0.03988),
  ('table', 'tilt_deg', 2.89365, 3.25535, 0.01734),
  ('table', 'tilt_deg', 3.25535, 90, 5.459e-05);
DELETE FROM class_density WHERE class = 'table' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'width', 0.01, 0.226865, 0.00281),
  ('table', 'width', 0.226865, 0.282133, 0.06636),
  ('table', 'width', 0.282133, 0.350864, 0.1074),
  ('table', 'width', 0.350864, 0.436339, 0.1423),
  ('table', 'width', 0.436339, 0.510892, 0.2703),
  ('table', 'width', 0.510892, 0.542636, 0.3466),
  ('table', 'width', 0.542636, 0.642863, 0.5143),
  ('table', 'width', 0.642863, 0.674829, 0.9255),
  ('table', 'width', 0.674829, 0.72948, 0.9423),
  ('table', 'width', 0.72948, 0.791809, 1.261),
  ('table', 'width', 0.791809, 0.839226, 1.749),
  ('table', 'width', 0.839226, 0.888459, 2.075),
  ('table', 'width', 0.888459, 0.935636, 1.797),
  ('table', 'width', 0.935636, 1.02942, 1.248),
  ('table', 'width', 1.02942, 1.04367, 1.448),
  ('table', 'width', 1.04367, 1.29792, 0.3099),
  ('table', 'width', 1.29792, 1.61411, 0.08796),
  ('table', 'width', 1.61411, 12, 0.005492);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_max', -0.5, 0.117763, 0.02075),
  ('table', 'z_max', 0.117763, 0.232336, 4.359e-06),
  ('table', 'z_max', 0.232336, 0.346909, 0.0001906),
  ('table', 'z_max', 0.346909, 0.461482, 0.003584),
  ('table', 'z_max', 0.461482, 0.576055, 0.02941),
  ('table', 'z_max', 0.576055, 0.665037, 1.149),
  ('table', 'z_max', 0.665037, 0.690629, 3.899),
  ('table', 'z_max', 0.690629, 0.712475, 5.531),
  ('table', 'z_max', 0.712475, 0.731085, 5.485),
  ('table', 'z_max', 0.731085, 0.749759, 6.107),
  ('table', 'z_max', 0.749759, 0.768224, 5.483),
  ('table', 'z_max', 0.768224, 0.792264, 4.411),
  ('table', 'z_max', 0.792264, 0.805202, 2.743),
  ('table', 'z_max', 0.805202, 0.855415, 1.597),
  ('table', 'z_max', 0.855415, 0.919775, 0.7431),
  ('table', 'z_max', 0.919775, 1.03435, 0.3316),
  ('table', 'z_max', 1.03435, 1.14892, 0.2593),
  ('table', 'z_max', 1.14892, 4, 0.002067);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_min', -0.5, 0.0951807, 0.02154),
  ('table', 'z_min', 0.0951807, 0.21115, 3.274e-06),
  ('table', 'z_min', 0.21115, 0.327119, 0.0001583),
  ('table', 'z_min', 0.327119, 0.443088, 0.003224),
  ('table', 'z_min', 0.443088, 0.559058, 0.03336),
  ('table', 'z_min', 0.559058, 0.644482, 1.18),
  ('table', 'z_min', 0.644482, 0.675027, 2.891),
  ('table', 'z_min', 0.675027, 0.682894, 4.45),
  ('table', 'z_min', 0.682894, 0.702616, 5.247),
  ('table', 'z_min', 0.702616, 0.721009, 5.731),
  ('table', 'z_min', 0.721009, 0.736098, 6.195),
  ('table', 'z_min', 0.736098, 0.758623, 5.228),
  ('table', 'z_min', 0.758623, 0.777559, 4.775),
  ('table', 'z_min', 0.777559, 0.790996, 3.622),
  ('table', 'z_min', 0.790996, 0.841549, 1.646),
  ('table', 'z_min', 0.841549, 0.906965, 0.7094),
  ('table', 'z_min', 0.906965, 1.02293, 0.3101),
  ('table', 'z_min', 1.02293, 1.1389, 0.2442),
  ('table', 'z_min', 1.1389, 4, 0.001986);

-- flat_screen: 179 examples
UPDATE object_class SET prior = 0.03721 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.818, 0.4163)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.4008, 0.2233)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5675, 0.1426)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.7554, 0.1696)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.9771, 0.07086)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_joined', 0.04429, 0.08271)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.03, 0.1178)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.5852, 0.2678)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.7932, 0.1114)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7593, 0.2131)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.2, 0.1812)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.11, 3.458)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -0.987, 0.2221)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.189, 0.1229)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7937, 0.1363)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'area_m2', 0.002, 0.0430928, 0.002509),
  ('flat_screen', 'area_m2', 0.0430928, 0.0546763, 0.04951),
  ('flat_screen', 'area_m2', 0.0546763, 0.0693734, 0.06365),
  ('flat_screen', 'area_m2', 0.0693734, 0.0880211, 0.1967),
  ('flat_screen', 'area_m2', 0.0880211, 0.0965881, 0.3517),
  ('flat_screen', 'area_m2', 0.0965881, 0.111681, 0.4721),
  ('flat_screen', 'area_m2', 0.111681, 0.116623, 0.7303),
  ('flat_screen', 'area_m2', 0.116623, 0.141702, 0.6322),
  ('flat_screen', 'area_m2', 0.141702, 0.165485, 0.7809),
  ('flat_screen', 'area_m2', 0.165485, 0.179792, 1.228),
  ('flat_screen', 'area_m2', 0.179792, 0.206702, 0.7718),
  ('flat_screen', 'area_m2', 0.206702, 0.22812, 1.031),
  ('flat_screen', 'area_m2', 0.22812, 0.253153, 1.094),
  ('flat_screen', 'area_m2', 0.253153, 0.289439, 0.5114),
  ('flat_screen', 'area_m2', 0.289439, 0.367241, 0.1585),
  ('flat_screen', 'area_m2', 0.367241, 100, 0.001815);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'aspect', 1, 1.01896, 0.8353),
  ('flat_screen', 'aspect', 1.01896, 1.11997, 0.9471),
  ('flat_screen', 'aspect', 1.11997, 1.26738, 0.9819),
  ('flat_screen', 'aspect', 1.26738, 1.34569, 1.689),
  ('flat_screen', 'aspect', 1.34569, 1.41355, 2.297),
  ('flat_screen', 'aspect', 1.41355, 1.43225, 1.613),
  ('flat_screen', 'aspect', 1.43225, 1.52336, 1.256),
  ('flat_screen', 'aspect', 1.52336, 1.60564, 2.28),
  ('flat_screen', 'aspect', 1.60564, 1.69555, 2.056),
  ('flat_screen', 'aspect', 1.69555, 1.81982, 1.049),
  ('flat_screen', 'aspect', 1.81982, 1.99179, 0.5522),
  ('flat_screen', 'aspect', 1.99179, 2.05133, 0.3941),
  ('flat_screen', 'aspect', 2.05133, 2.31228, 0.3933),
  ('flat_screen', 'aspect', 2.31228, 2.60644, 0.1812),
  ('flat_screen', 'aspect', 2.60644, 2.93801, 0.1104),
  ('flat_screen', 'aspect', 2.93801, 100, 0.003064);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'behind', 0, 0.133073, 0.07277),
  ('flat_screen', 'behind', 0.133073, 0.212221, 0.2375),
  ('flat_screen', 'behind', 0.212221, 0.291369, 0.3539),
  ('flat_screen', 'behind', 0.291369, 0.370518, 0.5508),
  ('flat_screen', 'behind', 0.370518, 0.383941, 0.9174),
  ('flat_screen', 'behind', 0.383941, 0.449666, 1.087),
  ('flat_screen', 'behind', 0.449666, 0.474917, 1.559),
  ('flat_screen', 'behind', 0.474917, 0.523892, 2.287),
  ('flat_screen', 'behind', 0.523892, 0.576837, 2.124),
  ('flat_screen', 'behind', 0.576837, 0.607962, 2.469),
  ('flat_screen', 'behind', 0.607962, 0.616957, 2.901),
  ('flat_screen', 'behind', 0.616957, 0.650937, 3.603),
  ('flat_screen', 'behind', 0.650937, 0.678125, 3.731),
  ('flat_screen', 'behind', 0.678125, 0.68711, 4.401),
  ('flat_screen', 'behind', 0.68711, 0.714935, 2.645),
  ('flat_screen', 'behind', 0.714935, 0.766258, 1.558),
  ('flat_screen', 'behind', 0.766258, 0.845407, 0.2807),
  ('flat_screen', 'behind', 0.845407, 1, 0.06622);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'edge_free', 0, 0.359816, 0.03248),
  ('flat_screen', 'edge_free', 0.359816, 0.430948, 0.2909),
  ('flat_screen', 'edge_free', 0.430948, 0.502079, 0.5521),
  ('flat_screen', 'edge_free', 0.502079, 0.553943, 0.6694),
  ('flat_screen', 'edge_free', 0.553943, 0.573211, 1.081),
  ('flat_screen', 'edge_free', 0.573211, 0.633797, 1.763),
  ('flat_screen', 'edge_free', 0.633797, 0.644342, 3.193),
  ('flat_screen', 'edge_free', 0.644342, 0.67465, 2.352),
  ('flat_screen', 'edge_free', 0.67465, 0.710672, 2.86),
  ('flat_screen', 'edge_free', 0.710672, 0.770361, 1.867),
  ('flat_screen', 'edge_free', 0.770361, 0.786605, 2.431),
  ('flat_screen', 'edge_free', 0.786605, 0.813958, 2.326),
  ('flat_screen', 'edge_free', 0.813958, 0.857737, 1.264),
  ('flat_screen', 'edge_free', 0.857737, 0.928868, 0.8349),
  ('flat_screen', 'edge_free', 0.928868, 0.948325, 0.8884),
  ('flat_screen', 'edge_free', 0.948325, 1, 4.092);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'edge_free_top', 0, 0.620496, 0.01604),
  ('flat_screen', 'edge_free_top', 0.620496, 0.662663, 0.1394),
  ('flat_screen', 'edge_free_top', 0.662663, 0.70483, 0.06892),
  ('flat_screen', 'edge_free_top', 0.70483, 0.746997, 0.2661),
  ('flat_screen', 'edge_free_top', 0.746997, 0.789164, 0.3433),
  ('flat_screen', 'edge_free_top', 0.789164, 0.831331, 0.4282),
  ('flat_screen', 'edge_free_top', 0.831331, 0.873499, 0.3062),
  ('flat_screen', 'edge_free_top', 0.873499, 0.915666, 0.6987),
  ('flat_screen', 'edge_free_top', 0.915666, 0.944633, 0.9986),
  ('flat_screen', 'edge_free_top', 0.944633, 0.957833, 1.104),
  ('flat_screen', 'edge_free_top', 0.957833, 1, 20.2);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'edge_joined', 0, 0.0216062, 24.39),
  ('flat_screen', 'edge_joined', 0.0216062, 0.0341586, 9.023),
  ('flat_screen', 'edge_joined', 0.0341586, 0.0494054, 7.082),
  ('flat_screen', 'edge_joined', 0.0494054, 0.100045, 2.261),
  ('flat_screen', 'edge_joined', 0.100045, 0.119707, 1.143),
  ('flat_screen', 'edge_joined', 0.119707, 0.150067, 1.102),
  ('flat_screen', 'edge_joined', 0.150067, 0.200089, 0.5525),
  ('flat_screen', 'edge_joined', 0.200089, 0.250112, 0.3205),
  ('flat_screen', 'edge_joined', 0.250112, 0.300134, 0.1327),
  ('flat_screen', 'edge_joined', 0.300134, 0.350156, 0.1805),
  ('flat_screen', 'edge_joined', 0.350156, 0.400179, 0.07316),
  ('flat_screen', 'edge_joined', 0.400179, 0.450201, 0.1573),
  ('flat_screen', 'edge_joined', 0.450201, 1, 0.01917);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'height', -0.5, 0.698664, 0.008865),
  ('flat_screen', 'height', 0.698664, 0.776318, 0.0111),
  ('flat_screen', 'height', 0.776318, 0.853972, 0.2187),
  ('flat_screen', 'height', 0.853972, 0.924068, 1.306),
  ('flat_screen', 'height', 0.924068, 0.931626, 2.58),
  ('flat_screen', 'height', 0.931626, 0.959723, 3.394),
  ('flat_screen', 'height', 0.959723, 0.979918, 4.934),
  ('flat_screen', 'height', 0.979918, 0.998556, 5.759),
  ('flat_screen', 'height', 0.998556, 1.00928, 5.575),
  ('flat_screen', 'height', 1.00928, 1.02022, 4.81),
  ('flat_screen', 'height', 1.02022, 1.04188, 4.46),
  ('flat_screen', 'height', 1.04188, 1.07431, 3.64),
  ('flat_screen', 'height', 1.07431, 1.08693, 2.424),
  ('flat_screen', 'height', 1.08693, 1.16459, 1.108),
  ('flat_screen', 'height', 1.16459, 1.17449, 0.7765),
  ('flat_screen', 'height', 1.17449, 1.24224, 0.4673),
  ('flat_screen', 'height', 1.24224, 1.3199, 0.3433),
  ('flat_screen', 'height', 1.3199, 1.39755, 0.5116),
  ('flat_screen', 'height', 1.39755, 4, 0.003359);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'length', 0.03, 0.303307, 0.004714),
  ('flat_screen', 'length', 0.303307, 0.348054, 0.2114),
  ('flat_screen', 'length', 0.348054, 0.382731, 0.7453),
  ('flat_screen', 'length', 0.382731, 0.399403, 0.8083),
  ('flat_screen', 'length', 0.399403, 0.449065, 0.6534),
  ('flat_screen', 'length', 0.449065, 0.458327, 0.8296),
  ('flat_screen', 'length', 0.458327, 0.512035, 0.8869),
  ('flat_screen', 'length', 0.512035, 0.525945, 1.573),
  ('flat_screen', 'length', 0.525945, 0.54014, 2.222),
  ('flat_screen', 'length', 0.54014, 0.584316, 1.532),
  ('flat_screen', 'length', 0.584316, 0.603538, 1.69),
  ('flat_screen', 'length', 0.603538, 0.617614, 1.792),
  ('flat_screen', 'length', 0.617614, 0.682063, 1.238),
  ('flat_screen', 'length', 0.682063, 0.692579, 1.26),
  ('flat_screen', 'length', 0.692579, 0.777588, 0.8296),
  ('flat_screen', 'length', 0.777588, 0.794756, 0.4828),
  ('flat_screen', 'length', 0.794756, 0.912008, 0.4225),
  ('flat_screen', 'length', 0.912008, 1.04656, 0.1982),
  ('flat_screen', 'length', 1.04656, 30, 0.003284);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'rectangularity', 0, 0.50594, 0.0187),
  ('flat_screen', 'rectangularity', 0.50594, 0.560835, 0.2855),
  ('flat_screen', 'rectangularity', 0.560835, 0.615731, 0.5312),
  ('flat_screen', 'rectangularity', 0.615731, 0.656793, 1.5),
  ('flat_screen', 'rectangularity', 0.656793, 0.670627, 2.607),
  ('flat_screen', 'rectangularity', 0.670627, 0.693674, 2.814),
  ('flat_screen', 'rectangularity', 0.693674, 0.725522, 2.652),
  ('flat_screen', 'rectangularity', 0.725522, 0.736774, 2.25),
  ('flat_screen', 'rectangularity', 0.736774, 0.779045, 2.743),
  ('flat_screen', 'rectangularity', 0.779045, 0.823142, 2.742),
  ('flat_screen', 'rectangularity', 0.823142, 0.835313, 3.945),
  ('flat_screen', 'rectangularity', 0.835313, 0.851841, 3.148),
  ('flat_screen', 'rectangularity', 0.851841, 0.886886, 3.359),
  ('flat_screen', 'rectangularity', 0.886886, 0.941495, 1.974),
  ('flat_screen', 'rectangularity', 0.941495, 0.98263, 2.385),
  ('flat_screen', 'rectangularity', 0.98263, 1, 0.7401);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_length', 0.01, 0.285585, 0.002807),
  ('flat_screen', 'spread_length', 0.285585, 0.318954, 0.189),
  ('flat_screen', 'spread_length', 0.318954, 0.349503, 0.8911),
  ('flat_screen', 'spread_length', 0.349503, 0.356222, 1.416),
  ('flat_screen', 'spread_length', 0.356222, 0.382951, 1.084),
  ('flat_screen', 'spread_length', 0.382951, 0.397844, 1.134),
  ('flat_screen', 'spread_length', 0.397844, 0.430506, 1.059),
  ('flat_screen', 'spread_length', 0.430506, 0.44433, 1.52),
  ('flat_screen', 'spread_length', 0.44433, 0.459306, 1.522),
  ('flat_screen', 'spread_length', 0.459306, 0.496247, 1.211),
  ('flat_screen', 'spread_length', 0.496247, 0.505498, 1.741),
  ('flat_screen', 'spread_length', 0.505498, 0.526175, 2.429),
  ('flat_screen', 'spread_length', 0.526175, 0.548545, 2.387),
  ('flat_screen', 'spread_length', 0.548545, 0.589378, 1.57),
  ('flat_screen', 'spread_length', 0.589378, 0.61899, 1.032),
  ('flat_screen', 'spread_length', 0.61899, 0.691315, 0.3683),
  ('flat_screen', 'spread_length', 0.691315, 0.772092, 0.1804),
  ('flat_screen', 'spread_length', 0.772092, 40, 0.002785);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_width', 0.003, 0.148289, 0.002576),
  ('flat_screen', 'spread_width', 0.148289, 0.165677, 0.07747),
  ('flat_screen', 'spread_width', 0.165677, 0.185104, 0.1402),
  ('flat_screen', 'spread_width', 0.185104, 0.206809, 0.1276),
  ('flat_screen', 'spread_width', 0.206809, 0.231058, 0.2015),
  ('flat_screen', 'spread_width', 0.231058, 0.251237, 0.4629),
  ('flat_screen', 'spread_width', 0.251237, 0.258151, 0.768),
  ('flat_screen', 'spread_width', 0.258151, 0.272685, 1.817),
  ('flat_screen', 'spread_width', 0.272685, 0.288421, 1.99),
  ('flat_screen', 'spread_width', 0.288421, 0.303429, 2.064),
  ('flat_screen', 'spread_width', 0.303429, 0.318752, 2.462),
  ('flat_screen', 'spread_width', 0.318752, 0.330478, 2.725),
  ('flat_screen', 'spread_width', 0.330478, 0.34524, 2.465),
  ('flat_screen', 'spread_width', 0.34524, 0.360025, 2.117),
  ('flat_screen', 'spread_width', 0.360025, 0.40224, 1.172),
  ('flat_screen', 'spread_width', 0.40224, 20, 0.001979);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'tilt_deg', 0, 75.8549, 0.0001428),
  ('flat_screen', 'tilt_deg', 75.8549, 77.4266, 0.002632),
  ('flat_screen', 'tilt_deg', 77.4266, 78.9982, 0.005697),
  ('flat_screen', 'tilt_deg', 78.9982, 80.207, 0.06964),
  ('flat_screen', 'tilt_deg', 80.207, 80.5699, 0.04788),
  ('flat_screen', 'tilt_deg', 80.5699, 81.826, 0.07589),
  ('flat_screen', 'tilt_deg', 81.826, 82.1416, 0.06238),
  ('flat_screen', 'tilt_deg', 82.1416, 83.3812, 0.07474),
  ('flat_screen', 'tilt_deg', 83.3812, 83.7133, 0.08577),
  ('flat_screen', 'tilt_deg', 83.7133, 84.7305, 0.07299),
  ('flat_screen', 'tilt_deg', 84.7305, 85.285, 0.06834),
  ('flat_screen', 'tilt_deg', 85.285, 86.1366, 0.09828),
  ('flat_screen', 'tilt_deg', 86.1366, 86.8566, 0.06562),
  ('flat_screen', 'tilt_deg', 86.8566, 87.4854, 0.09973),
  ('flat_screen', 'tilt_deg', 87.4854, 88.4283, 0.1096),
  ('flat_screen', 'tilt_deg', 88.4283, 89.1337, 0.1689),
  ('flat_screen', 'tilt_deg', 89.1337, 90, 0.1271);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'width', 0.01, 0.180306, 0.003411),
  ('flat_screen', 'width', 0.180306, 0.205698, 0.08886),
  ('flat_screen', 'width', 0.205698, 0.234666, 0.1401),
  ('flat_screen', 'width', 0.234666, 0.267714, 0.2848),
  ('flat_screen', 'width', 0.267714, 0.276212, 0.9315),
  ('flat_screen', 'width', 0.276212, 0.305416, 0.7215),
  ('flat_screen', 'width', 0.305416, 0.327278, 0.7872),
  ('flat_screen', 'width', 0.327278, 0.348427, 1.318),
  ('flat_screen', 'width', 0.348427, 0.356218, 1.392),
  ('flat_screen', 'width', 0.356218, 0.377534, 1.821),
  ('flat_screen', 'width', 0.377534, 0.397496, 1.741),
  ('flat_screen', 'width', 0.397496, 0.405472, 1.572),
  ('flat_screen', 'width', 0.405472, 0.422098, 2.277),
  ('flat_screen', 'width', 0.422098, 0.438877, 2.558),
  ('flat_screen', 'width', 0.438877, 0.453475, 2.32),
  ('flat_screen', 'width', 0.453475, 0.466039, 1.827),
  ('flat_screen', 'width', 0.466039, 0.517337, 0.738),
  ('flat_screen', 'width', 0.517337, 0.590192, 0.1813),
  ('flat_screen', 'width', 0.590192, 12, 0.002737);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_max', -0.5, 0.867184, 0.007863),
  ('flat_screen', 'z_max', 0.867184, 0.945633, 0.01598),
  ('flat_screen', 'z_max', 0.945633, 1.02408, 0.4679),
  ('flat_screen', 'z_max', 1.02408, 1.0672, 1.441),
  ('flat_screen', 'z_max', 1.0672, 1.10253, 2.424),
  ('flat_screen', 'z_max', 1.10253, 1.11044, 4.196),
  ('flat_screen', 'z_max', 1.11044, 1.13412, 4.469),
  ('flat_screen', 'z_max', 1.13412, 1.15793, 4.575),
  ('flat_screen', 'z_max', 1.15793, 1.17963, 4.655),
  ('flat_screen', 'z_max', 1.17963, 1.20546, 4.569),
  ('flat_screen', 'z_max', 1.20546, 1.22974, 3.986),
  ('flat_screen', 'z_max', 1.22974, 1.25943, 1.752),
  ('flat_screen', 'z_max', 1.25943, 1.33788, 0.9148),
  ('flat_screen', 'z_max', 1.33788, 1.41633, 0.544),
  ('flat_screen', 'z_max', 1.41633, 1.49478, 0.4341),
  ('flat_screen', 'z_max', 1.49478, 1.56382, 0.4485),
  ('flat_screen', 'z_max', 1.56382, 1.57322, 0.3105),
  ('flat_screen', 'z_max', 1.57322, 4, 0.002198);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_min', -0.5, 0.454226, 0.01139),
  ('flat_screen', 'z_min', 0.454226, 0.541854, 0.02482),
  ('flat_screen', 'z_min', 0.541854, 0.629481, 0.4344),
  ('flat_screen', 'z_min', 0.629481, 0.668974, 2.013),
  ('flat_screen', 'z_min', 0.668974, 0.691992, 3.672),
  ('flat_screen', 'z_min', 0.691992, 0.717109, 3.27),
  ('flat_screen', 'z_min', 0.717109, 0.728854, 3.968),
  ('flat_screen', 'z_min', 0.728854, 0.747468, 4.882),
  ('flat_screen', 'z_min', 0.747468, 0.77161, 4.199),
  ('flat_screen', 'z_min', 0.77161, 0.804737, 2.491),
  ('flat_screen', 'z_min', 0.804737, 0.81793, 2.861),
  ('flat_screen', 'z_min', 0.81793, 0.872103, 2.116),
  ('flat_screen', 'z_min', 0.872103, 0.892365, 2.42),
  ('flat_screen', 'z_min', 0.892365, 0.954751, 1.105),
  ('flat_screen', 'z_min', 0.954751, 0.979992, 0.6205),
  ('flat_screen', 'z_min', 0.979992, 1.06762, 0.409),
  ('flat_screen', 'z_min', 1.06762, 1.15525, 0.3635),
  ('flat_screen', 'z_min', 1.15525, 1.24288, 0.2243),
  ('flat_screen', 'z_min', 1.24288, 4, 0.002929);

-- keyboard: 106 examples
UPDATE object_class SET prior = 0.02211 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.778, 0.4088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7665, 0.3206)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.249, 0.1569)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.2656, 0.1913)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_joined', 0.6777, 0.21)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7836, 0.1043)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.9086, 0.2985)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8267, 0.08534)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9658, 0.3063)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.828, 0.1406)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.78, 2.092)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.675, 0.2268)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7915, 0.1055)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7765, 0.1034)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'area_m2', 0.002, 0.0158513, 0.002744),
  ('keyboard', 'area_m2', 0.0158513, 0.0203905, 0.05924),
  ('keyboard', 'area_m2', 0.0203905, 0.0262297, 0.1003),
  ('keyboard', 'area_m2', 0.0262297, 0.0337409, 0.128),
  ('keyboard', 'area_m2', 0.0337409, 0.040337, 0.2877),
  ('keyboard', 'area_m2', 0.040337, 0.0434032, 0.508),
  ('keyboard', 'area_m2', 0.0434032, 0.0487207, 0.5426),
  ('keyboard', 'area_m2', 0.0487207, 0.0558323, 0.5143),
  ('keyboard', 'area_m2', 0.0558323, 0.0594179, 0.8454),
  ('keyboard', 'area_m2', 0.0594179, 0.0637099, 1.456),
  ('keyboard', 'area_m2', 0.0637099, 0.0684874, 1.461),
  ('keyboard', 'area_m2', 0.0684874, 0.0718207, 1.442),
  ('keyboard', 'area_m2', 0.0718207, 0.0739467, 1.349),
  ('keyboard', 'area_m2', 0.0739467, 0.0794585, 1.447),
  ('keyboard', 'area_m2', 0.0794585, 0.0923877, 0.6654),
  ('keyboard', 'area_m2', 0.0923877, 0.118844, 0.3222),
  ('keyboard', 'area_m2', 0.118844, 0.152877, 0.1425),
  ('keyboard', 'area_m2', 0.152877, 100, 0.001763);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'aspect', 1, 1.01765, 0.3369),
  ('keyboard', 'aspect', 1.01765, 1.16697, 0.3254),
  ('keyboard', 'aspect', 1.16697, 1.36182, 0.344),
  ('keyboard', 'aspect', 1.36182, 1.58919, 0.4743),
  ('keyboard', 'aspect', 1.58919, 1.6938, 0.6433),
  ('keyboard', 'aspect', 1.6938, 1.85454, 0.8193),
  ('keyboard', 'aspect', 1.85454, 1.93762, 0.9929),
  ('keyboard', 'aspect', 1.93762, 2.13578, 1.124),
  ('keyboard', 'aspect', 2.13578, 2.2964, 1.561),
  ('keyboard', 'aspect', 2.2964, 2.51733, 1.184),
  ('keyboard', 'aspect', 2.51733, 2.86205, 0.8587),
  ('keyboard', 'aspect', 2.86205, 2.94723, 1.689),
  ('keyboard', 'aspect', 2.94723, 3.13176, 1.057),
  ('keyboard', 'aspect', 3.13176, 3.43932, 0.7125),
  ('keyboard', 'aspect', 3.43932, 3.81667, 0.2682),
  ('keyboard', 'aspect', 3.81667, 4.01358, 0.1338),
  ('keyboard', 'aspect', 4.01358, 100, 0.0024);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'behind', 0, 0.0350877, 3.157),
  ('keyboard', 'behind', 0.0350877, 0.0712982, 0.8187),
  ('keyboard', 'behind', 0.0712982, 0.116721, 1.844),
  ('keyboard', 'behind', 0.116721, 0.142596, 2.039),
  ('keyboard', 'behind', 0.142596, 0.175258, 1.598),
  ('keyboard', 'behind', 0.175258, 0.213894, 1.481),
  ('keyboard', 'behind', 0.213894, 0.238456, 2.557),
  ('keyboard', 'behind', 0.238456, 0.259179, 4.568),
  ('keyboard', 'behind', 0.259179, 0.285193, 2.922),
  ('keyboard', 'behind', 0.285193, 0.303571, 2.537),
  ('keyboard', 'behind', 0.303571, 0.356491, 1.961),
  ('keyboard', 'behind', 0.356491, 0.427789, 1.445),
  ('keyboard', 'behind', 0.427789, 0.46516, 0.7279),
  ('keyboard', 'behind', 0.46516, 0.499087, 0.652),
  ('keyboard', 'behind', 0.499087, 0.570385, 0.5603),
  ('keyboard', 'behind', 0.570385, 0.641683, 0.3267),
  ('keyboard', 'behind', 0.641683, 1, 0.03973);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'edge_free', 0, 0.0393209, 5.482),
  ('keyboard', 'edge_free', 0.0393209, 0.0700016, 1.31),
  ('keyboard', 'edge_free', 0.0700016, 0.140003, 0.9741),
  ('keyboard', 'edge_free', 0.140003, 0.210005, 0.8413),
  ('keyboard', 'edge_free', 0.210005, 0.273371, 1.06),
  ('keyboard', 'edge_free', 0.273371, 0.346106, 1.593),
  ('keyboard', 'edge_free', 0.346106, 0.386489, 2.912),
  ('keyboard', 'edge_free', 0.386489, 0.42001, 1.939),
  ('keyboard', 'edge_free', 0.42001, 0.441555, 1.469),
  ('keyboard', 'edge_free', 0.441555, 0.481058, 2.628),
  ('keyboard', 'edge_free', 0.481058, 0.490011, 2.093),
  ('keyboard', 'edge_free', 0.490011, 0.560013, 0.7923),
  ('keyboard', 'edge_free', 0.560013, 0.630015, 0.3597),
  ('keyboard', 'edge_free', 0.630015, 1, 0.04509);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'edge_joined', 0, 0.239618, 0.04597),
  ('keyboard', 'edge_joined', 0.239618, 0.324105, 0.1421),
  ('keyboard', 'edge_joined', 0.324105, 0.408592, 0.6498),
  ('keyboard', 'edge_joined', 0.408592, 0.425231, 2.15),
  ('keyboard', 'edge_joined', 0.425231, 0.493079, 1.553),
  ('keyboard', 'edge_joined', 0.493079, 0.563123, 1.698),
  ('keyboard', 'edge_joined', 0.563123, 0.577566, 1.756),
  ('keyboard', 'edge_joined', 0.577566, 0.617302, 1.853),
  ('keyboard', 'edge_joined', 0.617302, 0.662053, 2.418),
  ('keyboard', 'edge_joined', 0.662053, 0.746539, 1.247),
  ('keyboard', 'edge_joined', 0.746539, 0.778989, 0.9152),
  ('keyboard', 'edge_joined', 0.778989, 0.831026, 0.7854),
  ('keyboard', 'edge_joined', 0.831026, 0.906334, 0.8068),
  ('keyboard', 'edge_joined', 0.906334, 1, 2.329);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'height', -0.5, 0.615785, 0.01571),
  ('keyboard', 'height', 0.615785, 0.676493, 1.304),
  ('keyboard', 'height', 0.676493, 0.682687, 2.042),
  ('keyboard', 'height', 0.682687, 0.715855, 3.524),
  ('keyboard', 'height', 0.715855, 0.733419, 5.84),
  ('keyboard', 'height', 0.733419, 0.753109, 5.777),
  ('keyboard', 'height', 0.753109, 0.769667, 5.515),
  ('keyboard', 'height', 0.769667, 0.797346, 4.8),
  ('keyboard', 'height', 0.797346, 0.816768, 4.552),
  ('keyboard', 'height', 0.816768, 0.858617, 1.85),
  ('keyboard', 'height', 0.858617, 0.911964, 1.075),
  ('keyboard', 'height', 0.911964, 0.919325, 1.12),
  ('keyboard', 'height', 0.919325, 0.980033, 0.8056),
  ('keyboard', 'height', 0.980033, 1.04074, 0.2402),
  ('keyboard', 'height', 1.04074, 1.10145, 0.1132),
  ('keyboard', 'height', 1.10145, 1.16216, 0.3641),
  ('keyboard', 'height', 1.16216, 4, 0.003311);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'length', 0.03, 0.161228, 0.005861),
  ('keyboard', 'length', 0.161228, 0.191311, 0.1591),
  ('keyboard', 'length', 0.191311, 0.227006, 0.2028),
  ('keyboard', 'length', 0.227006, 0.269363, 0.1612),
  ('keyboard', 'length', 0.269363, 0.289962, 0.2534),
  ('keyboard', 'length', 0.289962, 0.319622, 0.8346),
  ('keyboard', 'length', 0.319622, 0.327936, 1.002),
  ('keyboard', 'length', 0.327936, 0.379259, 0.5067),
  ('keyboard', 'length', 0.379259, 0.423058, 0.5507),
  ('keyboard', 'length', 0.423058, 0.44047, 2.517),
  ('keyboard', 'length', 0.44047, 0.450023, 3.275),
  ('keyboard', 'length', 0.450023, 0.45558, 3.679),
  ('keyboard', 'length', 0.45558, 0.468093, 3.863),
  ('keyboard', 'length', 0.468093, 0.480845, 3.596),
  ('keyboard', 'length', 0.480845, 0.494865, 2.86),
  ('keyboard', 'length', 0.494865, 0.533991, 0.9168),
  ('keyboard', 'length', 0.533991, 0.633626, 0.2278),
  ('keyboard', 'length', 0.633626, 0.751852, 0.1008),
  ('keyboard', 'length', 0.751852, 30, 0.003972);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'rectangularity', 0, 0.555395, 0.01263),
  ('keyboard', 'rectangularity', 0.555395, 0.604152, 0.194),
  ('keyboard', 'rectangularity', 0.604152, 0.652909, 0.2474),
  ('keyboard', 'rectangularity', 0.652909, 0.701667, 1.021),
  ('keyboard', 'rectangularity', 0.701667, 0.718723, 1.472),
  ('keyboard', 'rectangularity', 0.718723, 0.750424, 2.148),
  ('keyboard', 'rectangularity', 0.750424, 0.767567, 3.157),
  ('keyboard', 'rectangularity', 0.767567, 0.797594, 3.589),
  ('keyboard', 'rectangularity', 0.797594, 0.825931, 4.536),
  ('keyboard', 'rectangularity', 0.825931, 0.835575, 9.685),
  ('keyboard', 'rectangularity', 0.835575, 0.847938, 5.637),
  ('keyboard', 'rectangularity', 0.847938, 0.862819, 3.198),
  ('keyboard', 'rectangularity', 0.862819, 0.892306, 3.797),
  ('keyboard', 'rectangularity', 0.892306, 0.944823, 1.982),
  ('keyboard', 'rectangularity', 0.944823, 0.979232, 2.85),
  ('keyboard', 'rectangularity', 0.979232, 0.994209, 0.7406),
  ('keyboard', 'rectangularity', 0.994209, 1, 0.3745);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_length', 0.01, 0.160213, 0.005999),
  ('keyboard', 'spread_length', 0.160213, 0.191188, 0.205),
  ('keyboard', 'spread_length', 0.191188, 0.228153, 0.2206),
  ('keyboard', 'spread_length', 0.228153, 0.263521, 0.1824),
  ('keyboard', 'spread_length', 0.263521, 0.272265, 0.2932),
  ('keyboard', 'spread_length', 0.272265, 0.309216, 0.774),
  ('keyboard', 'spread_length', 0.309216, 0.324905, 0.9121),
  ('keyboard', 'spread_length', 0.324905, 0.387723, 0.3988),
  ('keyboard', 'spread_length', 0.387723, 0.397233, 0.7229),
  ('keyboard', 'spread_length', 0.397233, 0.420729, 1.859),
  ('keyboard', 'spread_length', 0.420729, 0.435945, 2.711),
  ('keyboard', 'spread_length', 0.435945, 0.451062, 3.532),
  ('keyboard', 'spread_length', 0.451062, 0.458534, 4.426),
  ('keyboard', 'spread_length', 0.458534, 0.46743, 4.178),
  ('keyboard', 'spread_length', 0.46743, 0.552143, 0.768),
  ('keyboard', 'spread_length', 0.552143, 0.658896, 0.07515),
  ('keyboard', 'spread_length', 0.658896, 0.786288, 0.07448),
  ('keyboard', 'spread_length', 0.786288, 40, 0.002473);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_width', 0.003, 0.116347, 0.00186),
  ('keyboard', 'spread_width', 0.116347, 0.117997, 0.1992),
  ('keyboard', 'spread_width', 0.117997, 0.126804, 0.3545),
  ('keyboard', 'spread_width', 0.126804, 0.136964, 0.9645),
  ('keyboard', 'spread_width', 0.136964, 0.14447, 2.268),
  ('keyboard', 'spread_width', 0.14447, 0.150623, 2.496),
  ('keyboard', 'spread_width', 0.150623, 0.156781, 2.715),
  ('keyboard', 'spread_width', 0.156781, 0.16207, 3.387),
  ('keyboard', 'spread_width', 0.16207, 0.164161, 3.362),
  ('keyboard', 'spread_width', 0.164161, 0.16706, 2.973),
  ('keyboard', 'spread_width', 0.16706, 0.176371, 2.198),
  ('keyboard', 'spread_width', 0.176371, 0.178917, 1.589),
  ('keyboard', 'spread_width', 0.178917, 0.187916, 1.699),
  ('keyboard', 'spread_width', 0.187916, 0.194998, 1.273),
  ('keyboard', 'spread_width', 0.194998, 0.212524, 0.4065),
  ('keyboard', 'spread_width', 0.212524, 0.231626, 0.196),
  ('keyboard', 'spread_width', 0.231626, 0.252445, 0.1681),
  ('keyboard', 'spread_width', 0.252445, 20, 0.002371);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'tilt_deg', 0, 1.00225, 0.109),
  ('keyboard', 'tilt_deg', 1.00225, 2.12316, 0.1018),
  ('keyboard', 'tilt_deg', 2.12316, 2.80473, 0.1625),
  ('keyboard', 'tilt_deg', 2.80473, 3.18473, 0.2095),
  ('keyboard', 'tilt_deg', 3.18473, 3.31466, 0.2106),
  ('keyboard', 'tilt_deg', 3.31466, 4.09483, 0.1631),
  ('keyboard', 'tilt_deg', 4.09483, 4.24631, 0.1982),
  ('keyboard', 'tilt_deg', 4.24631, 4.61981, 0.1917),
  ('keyboard', 'tilt_deg', 4.61981, 5.30789, 0.1316),
  ('keyboard', 'tilt_deg', 5.30789, 5.53599, 0.09062),
  ('keyboard', 'tilt_deg', 5.53599, 6.32291, 0.1292),
  ('keyboard', 'tilt_deg', 6.32291, 7.43104, 0.06414),
  ('keyboard', 'tilt_deg', 7.43104, 8.49262, 0.02283),
  ('keyboard', 'tilt_deg', 8.49262, 9.5542, 0.01029),
  ('keyboard', 'tilt_deg', 9.5542, 90, 0.0001355);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'width', 0.01, 0.129153, 0.003672),
  ('keyboard', 'width', 0.129153, 0.134, 0.3526),
  ('keyboard', 'width', 0.134, 0.144898, 0.9093),
  ('keyboard', 'width', 0.144898, 0.147429, 1.943),
  ('keyboard', 'width', 0.147429, 0.153219, 2.42),
  ('keyboard', 'width', 0.153219, 0.162563, 1.504),
  ('keyboard', 'width', 0.162563, 0.176576, 1.564),
  ('keyboard', 'width', 0.176576, 0.182382, 2.444),
  ('keyboard', 'width', 0.182382, 0.195732, 1.945),
  ('keyboard', 'width', 0.195732, 0.204616, 1.539),
  ('keyboard', 'width', 0.204616, 0.219126, 0.7451),
  ('keyboard', 'width', 0.219126, 0.229562, 0.7138),
  ('keyboard', 'width', 0.229562, 0.25511, 0.7609),
  ('keyboard', 'width', 0.25511, 0.288947, 0.4403),
  ('keyboard', 'width', 0.288947, 0.324173, 0.2876),
  ('keyboard', 'width', 0.324173, 0.363693, 0.1065),
  ('keyboard', 'width', 0.363693, 12, 0.003367);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_max', -0.5, 0.624623, 0.01413),
  ('keyboard', 'z_max', 0.624623, 0.685754, 1.468),
  ('keyboard', 'z_max', 0.685754, 0.721983, 3.355),
  ('keyboard', 'z_max', 0.721983, 0.738998, 5.798),
  ('keyboard', 'z_max', 0.738998, 0.746885, 5.788),
  ('keyboard', 'z_max', 0.746885, 0.761245, 5.545),
  ('keyboard', 'z_max', 0.761245, 0.778526, 4.956),
  ('keyboard', 'z_max', 0.778526, 0.80657, 4.517),
  ('keyboard', 'z_max', 0.80657, 0.826596, 4.594),
  ('keyboard', 'z_max', 0.826596, 0.869147, 1.929),
  ('keyboard', 'z_max', 0.869147, 0.925842, 1.011),
  ('keyboard', 'z_max', 0.925842, 0.99141, 0.7952),
  ('keyboard', 'z_max', 0.99141, 1.05254, 0.2454),
  ('keyboard', 'z_max', 1.05254, 1.11367, 0.1167),
  ('keyboard', 'z_max', 1.11367, 1.1748, 0.35),
  ('keyboard', 'z_max', 1.1748, 4, 0.003352);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_min', -0.5, 0.604808, 0.01581),
  ('keyboard', 'z_min', 0.604808, 0.665377, 1.098),
  ('keyboard', 'z_min', 0.665377, 0.677705, 2.182),
  ('keyboard', 'z_min', 0.677705, 0.7088, 3.604),
  ('keyboard', 'z_min', 0.7088, 0.725947, 5.334),
  ('keyboard', 'z_min', 0.725947, 0.74681, 5.947),
  ('keyboard', 'z_min', 0.74681, 0.761781, 6.112),
  ('keyboard', 'z_min', 0.761781, 0.786345, 5.24),
  ('keyboard', 'z_min', 0.786345, 0.809045, 4.26),
  ('keyboard', 'z_min', 0.809045, 0.847085, 1.834),
  ('keyboard', 'z_min', 0.847085, 0.900044, 1.14),
  ('keyboard', 'z_min', 0.900044, 0.907655, 1.17),
  ('keyboard', 'z_min', 0.907655, 0.968224, 0.8648),
  ('keyboard', 'z_min', 0.968224, 1.02879, 0.237),
  ('keyboard', 'z_min', 1.02879, 1.08936, 0.1094),
  ('keyboard', 'z_min', 1.08936, 1.14993, 0.3662),
  ('keyboard', 'z_min', 1.14993, 4, 0.003545);

-- chair_seat: 138 examples
UPDATE object_class SET prior = 0.02877 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.068, 0.5754)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.319, 0.2919)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6107, 0.2118)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.6475, 0.1939)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_joined', 0.07884, 0.09315)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4737, 0.03346)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7206, 0.2083)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.748, 0.1308)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7665, 0.2017)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.231, 0.3914)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 1.43, 1.193)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.039, 0.3663)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.48, 0.03382)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4689, 0.03407)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'area_m2', 0.002, 0.0267098, 0.004115),
  ('chair_seat', 'area_m2', 0.0267098, 0.0352189, 0.1007),
  ('chair_seat', 'area_m2', 0.0352189, 0.0464388, 0.1591),
  ('chair_seat', 'area_m2', 0.0464388, 0.0552859, 0.1834),
  ('chair_seat', 'area_m2', 0.0552859, 0.0612331, 0.2295),
  ('chair_seat', 'area_m2', 0.0612331, 0.0807404, 0.2675),
  ('chair_seat', 'area_m2', 0.0807404, 0.0849535, 0.3109),
  ('chair_seat', 'area_m2', 0.0849535, 0.106462, 0.4384),
  ('chair_seat', 'area_m2', 0.106462, 0.140379, 0.4115),
  ('chair_seat', 'area_m2', 0.140379, 0.146325, 0.5021),
  ('chair_seat', 'area_m2', 0.146325, 0.165833, 0.8158),
  ('chair_seat', 'area_m2', 0.165833, 0.1851, 0.95),
  ('chair_seat', 'area_m2', 0.1851, 0.196313, 1.639),
  ('chair_seat', 'area_m2', 0.196313, 0.223422, 0.9435),
  ('chair_seat', 'area_m2', 0.223422, 0.244068, 0.8505),
  ('chair_seat', 'area_m2', 0.244068, 0.321823, 0.092),
  ('chair_seat', 'area_m2', 0.321823, 100, 0.002289);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'aspect', 1, 1.05254, 2.331),
  ('chair_seat', 'aspect', 1.05254, 1.09341, 2.574),
  ('chair_seat', 'aspect', 1.09341, 1.1305, 3.02),
  ('chair_seat', 'aspect', 1.1305, 1.14089, 2.995),
  ('chair_seat', 'aspect', 1.14089, 1.18232, 2.376),
  ('chair_seat', 'aspect', 1.18232, 1.27175, 1.548),
  ('chair_seat', 'aspect', 1.27175, 1.30163, 1.396),
  ('chair_seat', 'aspect', 1.30163, 1.41677, 0.9022),
  ('chair_seat', 'aspect', 1.41677, 1.48501, 0.4841),
  ('chair_seat', 'aspect', 1.48501, 1.69424, 0.5669),
  ('chair_seat', 'aspect', 1.69424, 1.77169, 0.7845),
  ('chair_seat', 'aspect', 1.77169, 1.93294, 0.76),
  ('chair_seat', 'aspect', 1.93294, 2.03251, 0.6563),
  ('chair_seat', 'aspect', 2.03251, 2.20527, 0.4065),
  ('chair_seat', 'aspect', 2.20527, 2.51596, 0.2548),
  ('chair_seat', 'aspect', 2.51596, 2.87044, 0.1819),
  ('chair_seat', 'aspect', 2.87044, 3.27485, 0.107),
  ('chair_seat', 'aspect', 3.27485, 100, 0.003318);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'behind', 0, 0.096753, 0.5988),
  ('chair_seat', 'behind', 0.096753, 0.193506, 0.07191),
  ('chair_seat', 'behind', 0.193506, 0.290259, 0.3965),
  ('chair_seat', 'behind', 0.290259, 0.387012, 0.4103),
  ('chair_seat', 'behind', 0.387012, 0.483765, 0.2812),
  ('chair_seat', 'behind', 0.483765, 0.556413, 0.8913),
  ('chair_seat', 'behind', 0.556413, 0.580518, 2.397),
  ('chair_seat', 'behind', 0.580518, 0.600953, 2.72),
  ('chair_seat', 'behind', 0.600953, 0.653371, 1.989),
  ('chair_seat', 'behind', 0.653371, 0.677271, 3.173),
  ('chair_seat', 'behind', 0.677271, 0.691464, 2.824),
  ('chair_seat', 'behind', 0.691464, 0.726539, 2.742),
  ('chair_seat', 'behind', 0.726539, 0.757989, 3.668),
  ('chair_seat', 'behind', 0.757989, 0.774024, 3.113),
  ('chair_seat', 'behind', 0.774024, 0.798028, 2.367),
  ('chair_seat', 'behind', 0.798028, 0.857143, 1.591),
  ('chair_seat', 'behind', 0.857143, 0.870777, 0.5036),
  ('chair_seat', 'behind', 0.870777, 1, 0.09543);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'edge_free', 0, 0.201481, 0.04258),
  ('chair_seat', 'edge_free', 0.201481, 0.23006, 0.2722),
  ('chair_seat', 'edge_free', 0.23006, 0.290205, 0.4274),
  ('chair_seat', 'edge_free', 0.290205, 0.378929, 0.5247),
  ('chair_seat', 'edge_free', 0.378929, 0.421678, 0.7077),
  ('chair_seat', 'edge_free', 0.421678, 0.467654, 1.345),
  ('chair_seat', 'edge_free', 0.467654, 0.494044, 1.615),
  ('chair_seat', 'edge_free', 0.494044, 0.556378, 1.617),
  ('chair_seat', 'edge_free', 0.556378, 0.568055, 1.095),
  ('chair_seat', 'edge_free', 0.568055, 0.628767, 1.766),
  ('chair_seat', 'edge_free', 0.628767, 0.645102, 3.743),
  ('chair_seat', 'edge_free', 0.645102, 0.664756, 2.467),
  ('chair_seat', 'edge_free', 0.664756, 0.720671, 1.967),
  ('chair_seat', 'edge_free', 0.720671, 0.733827, 1.722),
  ('chair_seat', 'edge_free', 0.733827, 0.813659, 1.123),
  ('chair_seat', 'edge_free', 0.813659, 0.907567, 1.246),
  ('chair_seat', 'edge_free', 0.907567, 1, 1.157);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'edge_joined', 0, 0.0254064, 16.49),
  ('chair_seat', 'edge_joined', 0.0254064, 0.0394803, 4.826),
  ('chair_seat', 'edge_joined', 0.0394803, 0.0532656, 3.604),
  ('chair_seat', 'edge_joined', 0.0532656, 0.0789607, 2.138),
  ('chair_seat', 'edge_joined', 0.0789607, 0.104374, 2.651),
  ('chair_seat', 'edge_joined', 0.104374, 0.118441, 2.39),
  ('chair_seat', 'edge_joined', 0.118441, 0.150382, 2.649),
  ('chair_seat', 'edge_joined', 0.150382, 0.157921, 2.931),
  ('chair_seat', 'edge_joined', 0.157921, 0.197402, 2.014),
  ('chair_seat', 'edge_joined', 0.197402, 0.213856, 0.9845),
  ('chair_seat', 'edge_joined', 0.213856, 0.236882, 0.8694),
  ('chair_seat', 'edge_joined', 0.236882, 0.276362, 0.9037),
  ('chair_seat', 'edge_joined', 0.276362, 0.315843, 0.6323),
  ('chair_seat', 'edge_joined', 0.315843, 0.355323, 0.344),
  ('chair_seat', 'edge_joined', 0.355323, 1, 0.01664);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'height', -0.5, 0.386166, 0.008471),
  ('chair_seat', 'height', 0.386166, 0.406842, 0.9301),
  ('chair_seat', 'height', 0.406842, 0.425286, 4.455),
  ('chair_seat', 'height', 0.425286, 0.439657, 6.429),
  ('chair_seat', 'height', 0.439657, 0.448195, 6.662),
  ('chair_seat', 'height', 0.448195, 0.457941, 7.436),
  ('chair_seat', 'height', 0.457941, 0.468871, 8.674),
  ('chair_seat', 'height', 0.468871, 0.482644, 9.689),
  ('chair_seat', 'height', 0.482644, 0.489547, 10.23),
  ('chair_seat', 'height', 0.489547, 0.495807, 10.65),
  ('chair_seat', 'height', 0.495807, 0.502692, 10.86),
  ('chair_seat', 'height', 0.502692, 0.510224, 10.17),
  ('chair_seat', 'height', 0.510224, 0.5309, 5.73),
  ('chair_seat', 'height', 0.5309, 0.551577, 1.005),
  ('chair_seat', 'height', 0.551577, 0.572253, 0.2657),
  ('chair_seat', 'height', 0.572253, 4, 0.002226);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'length', 0.03, 0.260145, 0.003998),
  ('chair_seat', 'length', 0.260145, 0.301019, 0.2073),
  ('chair_seat', 'length', 0.301019, 0.348316, 0.2932),
  ('chair_seat', 'length', 0.348316, 0.400899, 0.2378),
  ('chair_seat', 'length', 0.400899, 0.443252, 1.197),
  ('chair_seat', 'length', 0.443252, 0.466371, 1.419),
  ('chair_seat', 'length', 0.466371, 0.472556, 2.637),
  ('chair_seat', 'length', 0.472556, 0.486059, 3.619),
  ('chair_seat', 'length', 0.486059, 0.502725, 3.533),
  ('chair_seat', 'length', 0.502725, 0.517171, 3.376),
  ('chair_seat', 'length', 0.517171, 0.539649, 2.462),
  ('chair_seat', 'length', 0.539649, 0.583922, 1.549),
  ('chair_seat', 'length', 0.583922, 0.62444, 0.5899),
  ('chair_seat', 'length', 0.62444, 0.722553, 0.2859),
  ('chair_seat', 'length', 0.722553, 0.836082, 0.1105),
  ('chair_seat', 'length', 0.836082, 0.967449, 0.0325),
  ('chair_seat', 'length', 0.967449, 30, 0.003477);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'rectangularity', 0, 0.435734, 0.02523),
  ('chair_seat', 'rectangularity', 0.435734, 0.495482, 0.4091),
  ('chair_seat', 'rectangularity', 0.495482, 0.55523, 1.17),
  ('chair_seat', 'rectangularity', 0.55523, 0.614978, 1.225),
  ('chair_seat', 'rectangularity', 0.614978, 0.638195, 1.521),
  ('chair_seat', 'rectangularity', 0.638195, 0.674726, 2.376),
  ('chair_seat', 'rectangularity', 0.674726, 0.697267, 1.939),
  ('chair_seat', 'rectangularity', 0.697267, 0.734474, 2.18),
  ('chair_seat', 'rectangularity', 0.734474, 0.747597, 1.526),
  ('chair_seat', 'rectangularity', 0.747597, 0.792656, 2.522),
  ('chair_seat', 'rectangularity', 0.792656, 0.819462, 4.072),
  ('chair_seat', 'rectangularity', 0.819462, 0.85397, 3.02),
  ('chair_seat', 'rectangularity', 0.85397, 0.906368, 2.202),
  ('chair_seat', 'rectangularity', 0.906368, 0.913717, 2.698),
  ('chair_seat', 'rectangularity', 0.913717, 0.957796, 1.744),
  ('chair_seat', 'rectangularity', 0.957796, 0.973465, 0.6434),
  ('chair_seat', 'rectangularity', 0.973465, 1, 0.1988);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_length', 0.01, 0.233866, 0.000944),
  ('chair_seat', 'spread_length', 0.233866, 0.24264, 0.1779),
  ('chair_seat', 'spread_length', 0.24264, 0.26802, 0.2041),
  ('chair_seat', 'spread_length', 0.26802, 0.307161, 0.2256),
  ('chair_seat', 'spread_length', 0.307161, 0.352018, 0.2855),
  ('chair_seat', 'spread_length', 0.352018, 0.357288, 0.5017),
  ('chair_seat', 'spread_length', 0.357288, 0.403427, 0.474),
  ('chair_seat', 'spread_length', 0.403427, 0.439435, 0.9002),
  ('chair_seat', 'spread_length', 0.439435, 0.458827, 2.354),
  ('chair_seat', 'spread_length', 0.458827, 0.475148, 3.078),
  ('chair_seat', 'spread_length', 0.475148, 0.489876, 3.333),
  ('chair_seat', 'spread_length', 0.489876, 0.506413, 3.288),
  ('chair_seat', 'spread_length', 0.506413, 0.523396, 3.124),
  ('chair_seat', 'spread_length', 0.523396, 0.529862, 2.875),
  ('chair_seat', 'spread_length', 0.529862, 0.544314, 2.514),
  ('chair_seat', 'spread_length', 0.544314, 0.607243, 0.9113),
  ('chair_seat', 'spread_length', 0.607243, 0.695923, 0.08103),
  ('chair_seat', 'spread_length', 0.695923, 0.797555, 0.09448),
  ('chair_seat', 'spread_length', 0.797555, 40, 0.002238);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_width', 0.003, 0.109607, 0.002978),
  ('chair_seat', 'spread_width', 0.109607, 0.111282, 0.1064),
  ('chair_seat', 'spread_width', 0.111282, 0.129612, 0.1689),
  ('chair_seat', 'spread_width', 0.129612, 0.153267, 0.2587),
  ('chair_seat', 'spread_width', 0.153267, 0.161701, 0.5216),
  ('chair_seat', 'spread_width', 0.161701, 0.18124, 0.5997),
  ('chair_seat', 'spread_width', 0.18124, 0.20927, 0.3632),
  ('chair_seat', 'spread_width', 0.20927, 0.214319, 0.331),
  ('chair_seat', 'spread_width', 0.214319, 0.253434, 0.4057),
  ('chair_seat', 'spread_width', 0.253434, 0.267283, 0.5724),
  ('chair_seat', 'spread_width', 0.267283, 0.299689, 0.5872),
  ('chair_seat', 'spread_width', 0.299689, 0.328055, 0.6572),
  ('chair_seat', 'spread_width', 0.328055, 0.354385, 1.27),
  ('chair_seat', 'spread_width', 0.354385, 0.38032, 1.523),
  ('chair_seat', 'spread_width', 0.38032, 0.4014, 2.015),
  ('chair_seat', 'spread_width', 0.4014, 0.419065, 1.878),
  ('chair_seat', 'spread_width', 0.419065, 0.479609, 0.9148),
  ('chair_seat', 'spread_width', 0.479609, 0.495549, 0.2297),
  ('chair_seat', 'spread_width', 0.495549, 20, 0.002922);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'tilt_deg', 0, 0.387603, 0.3476),
  ('chair_seat', 'tilt_deg', 0.387603, 0.550985, 0.5015),
  ('chair_seat', 'tilt_deg', 0.550985, 0.677974, 0.57),
  ('chair_seat', 'tilt_deg', 0.677974, 0.891205, 0.5829),
  ('chair_seat', 'tilt_deg', 0.891205, 1.09476, 0.4967),
  ('chair_seat', 'tilt_deg', 1.09476, 1.35595, 0.3368),
  ('chair_seat', 'tilt_deg', 1.35595, 1.59798, 0.2351),
  ('chair_seat', 'tilt_deg', 1.59798, 2.03392, 0.2257),
  ('chair_seat', 'tilt_deg', 2.03392, 2.71189, 0.1663),
  ('chair_seat', 'tilt_deg', 2.71189, 3.38987, 0.07357),
  ('chair_seat', 'tilt_deg', 3.38987, 4.06784, 0.04511),
  ('chair_seat', 'tilt_deg', 4.06784, 4.74582, 0.03171),
  ('chair_seat', 'tilt_deg', 4.74582, 5.42379, 0.0197),
  ('chair_seat', 'tilt_deg', 5.42379, 6.0588, 0.01252),
  ('chair_seat', 'tilt_deg', 6.0588, 90, 7.448e-05);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'width', 0.01, 0.139105, 0.003708),
  ('chair_seat', 'width', 0.139105, 0.142151, 0.1243),
  ('chair_seat', 'width', 0.142151, 0.163182, 0.2076),
  ('chair_seat', 'width', 0.163182, 0.191245, 0.3982),
  ('chair_seat', 'width', 0.191245, 0.224559, 0.4121),
  ('chair_seat', 'width', 0.224559, 0.263367, 0.3602),
  ('chair_seat', 'width', 0.263367, 0.309022, 0.3545),
  ('chair_seat', 'width', 0.309022, 0.361736, 0.4141),
  ('chair_seat', 'width', 0.361736, 0.402746, 0.9907),
  ('chair_seat', 'width', 0.402746, 0.425253, 2.008),
  ('chair_seat', 'width', 0.425253, 0.441189, 2.742),
  ('chair_seat', 'width', 0.441189, 0.46347, 2.257),
  ('chair_seat', 'width', 0.46347, 0.488487, 1.93),
  ('chair_seat', 'width', 0.488487, 0.498858, 1.32),
  ('chair_seat', 'width', 0.498858, 0.565692, 0.613),
  ('chair_seat', 'width', 0.565692, 0.585203, 0.161),
  ('chair_seat', 'width', 0.585203, 12, 0.003586);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_max', -0.5, 0.393228, 0.008509),
  ('chair_seat', 'z_max', 0.393228, 0.413762, 0.9956),
  ('chair_seat', 'z_max', 0.413762, 0.431391, 4.648),
  ('chair_seat', 'z_max', 0.431391, 0.445583, 6.617),
  ('chair_seat', 'z_max', 0.445583, 0.45483, 6.781),
  ('chair_seat', 'z_max', 0.45483, 0.463564, 7.468),
  ('chair_seat', 'z_max', 0.463564, 0.475364, 8.462),
  ('chair_seat', 'z_max', 0.475364, 0.490474, 9.015),
  ('chair_seat', 'z_max', 0.490474, 0.501453, 10.16),
  ('chair_seat', 'z_max', 0.501453, 0.509784, 11.13),
  ('chair_seat', 'z_max', 0.509784, 0.516432, 10.48),
  ('chair_seat', 'z_max', 0.516432, 0.536966, 6.004),
  ('chair_seat', 'z_max', 0.536966, 0.5575, 1.056),
  ('chair_seat', 'z_max', 0.5575, 0.578034, 0.2665),
  ('chair_seat', 'z_max', 0.578034, 4, 0.002275);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_min', -0.5, 0.378366, 0.008462),
  ('chair_seat', 'z_min', 0.378366, 0.399488, 0.7857),
  ('chair_seat', 'z_min', 0.399488, 0.420611, 4.106),
  ('chair_seat', 'z_min', 0.420611, 0.437265, 6.63),
  ('chair_seat', 'z_min', 0.437265, 0.452051, 7.201),
  ('chair_seat', 'z_min', 0.452051, 0.462855, 8.078),
  ('chair_seat', 'z_min', 0.462855, 0.477743, 9.439),
  ('chair_seat', 'z_min', 0.477743, 0.483978, 10.14),
  ('chair_seat', 'z_min', 0.483978, 0.491944, 10.48),
  ('chair_seat', 'z_min', 0.491944, 0.498904, 10.69),
  ('chair_seat', 'z_min', 0.498904, 0.5051, 10.14),
  ('chair_seat', 'z_min', 0.5051, 0.526222, 5.9),
  ('chair_seat', 'z_min', 0.526222, 0.547345, 1.073),
  ('chair_seat', 'z_min', 0.547345, 0.568467, 0.273),
  ('chair_seat', 'z_min', 0.568467, 4, 0.002215);

-- chair_back: 136 examples
UPDATE object_class SET prior = 0.02836 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.748, 0.6147)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3803, 0.2719)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.52, 0.3107)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.7827, 0.2428)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9142, 0.2513)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_joined', 0.1096, 0.1882)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8231, 0.09271)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5456, 0.2918)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7765, 0.1301)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6841, 0.2508)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.127, 0.3931)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.84, 3.699)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9304, 0.3374)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.03, 0.1005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.461, 0.1825)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'area_m2', 0.002, 0.0288569, 0.004264),
  ('chair_back', 'area_m2', 0.0288569, 0.0397763, 0.06686),
  ('chair_back', 'area_m2', 0.0397763, 0.0548277, 0.1376),
  ('chair_back', 'area_m2', 0.0548277, 0.0713805, 0.127),
  ('chair_back', 'area_m2', 0.0713805, 0.0755744, 0.1184),
  ('chair_back', 'area_m2', 0.0755744, 0.104172, 0.1683),
  ('chair_back', 'area_m2', 0.104172, 0.124436, 0.3366),
  ('chair_back', 'area_m2', 0.124436, 0.14359, 0.4032),
  ('chair_back', 'area_m2', 0.14359, 0.158372, 0.4642),
  ('chair_back', 'area_m2', 0.158372, 0.183996, 0.7035),
  ('chair_back', 'area_m2', 0.183996, 0.197925, 0.867),
  ('chair_back', 'area_m2', 0.197925, 0.210709, 0.8617),
  ('chair_back', 'area_m2', 0.210709, 0.24072, 0.8529),
  ('chair_back', 'area_m2', 0.24072, 0.27282, 0.8603),
  ('chair_back', 'area_m2', 0.27282, 0.327138, 0.6073),
  ('chair_back', 'area_m2', 0.327138, 0.376054, 0.3631),
  ('chair_back', 'area_m2', 0.376054, 0.518353, 0.1469),
  ('chair_back', 'area_m2', 0.518353, 100, 0.002605);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'aspect', 1, 1.06641, 1.537),
  ('chair_back', 'aspect', 1.06641, 1.12385, 1.704),
  ('chair_back', 'aspect', 1.12385, 1.20368, 2.037),
  ('chair_back', 'aspect', 1.20368, 1.26303, 1.272),
  ('chair_back', 'aspect', 1.26303, 1.31753, 1.039),
  ('chair_back', 'aspect', 1.31753, 1.41945, 0.9703),
  ('chair_back', 'aspect', 1.41945, 1.46263, 1.528),
  ('chair_back', 'aspect', 1.46263, 1.59524, 1.134),
  ('chair_back', 'aspect', 1.59524, 1.62364, 0.8289),
  ('chair_back', 'aspect', 1.62364, 1.7928, 0.6432),
  ('chair_back', 'aspect', 1.7928, 1.93405, 0.8069),
  ('chair_back', 'aspect', 1.93405, 2.01483, 1.069),
  ('chair_back', 'aspect', 2.01483, 2.12069, 1.03),
  ('chair_back', 'aspect', 2.12069, 2.26436, 0.7683),
  ('chair_back', 'aspect', 2.26436, 2.54479, 0.3231),
  ('chair_back', 'aspect', 2.54479, 2.85995, 0.1287),
  ('chair_back', 'aspect', 2.85995, 100, 0.003151);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'behind', 0, 0.0976665, 2.097),
  ('chair_back', 'behind', 0.0976665, 0.152542, 0.2601),
  ('chair_back', 'behind', 0.152542, 0.195333, 0.2153),
  ('chair_back', 'behind', 0.195333, 0.293, 0.2521),
  ('chair_back', 'behind', 0.293, 0.390666, 0.352),
  ('chair_back', 'behind', 0.390666, 0.482456, 0.6659),
  ('chair_back', 'behind', 0.482456, 0.488333, 0.9538),
  ('chair_back', 'behind', 0.488333, 0.58209, 1.047),
  ('chair_back', 'behind', 0.58209, 0.680851, 1.175),
  ('chair_back', 'behind', 0.680851, 0.757426, 1.381),
  ('chair_back', 'behind', 0.757426, 0.781332, 3.011),
  ('chair_back', 'behind', 0.781332, 0.792593, 2.631),
  ('chair_back', 'behind', 0.792593, 0.821053, 3.724),
  ('chair_back', 'behind', 0.821053, 0.876106, 1.909),
  ('chair_back', 'behind', 0.876106, 1, 0.1082);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'edge_free', 0, 0.111111, 0.2315),
  ('chair_back', 'edge_free', 0.111111, 0.222222, 0.1639),
  ('chair_back', 'edge_free', 0.222222, 0.333333, 0.212),
  ('chair_back', 'edge_free', 0.333333, 0.444444, 0.2953),
  ('chair_back', 'edge_free', 0.444444, 0.476058, 0.5083),
  ('chair_back', 'edge_free', 0.476058, 0.555556, 0.7211),
  ('chair_back', 'edge_free', 0.555556, 0.666667, 0.4627),
  ('chair_back', 'edge_free', 0.666667, 0.750766, 1.435),
  ('chair_back', 'edge_free', 0.750766, 0.777778, 1.964),
  ('chair_back', 'edge_free', 0.777778, 0.808471, 1.926),
  ('chair_back', 'edge_free', 0.808471, 0.872349, 1.701),
  ('chair_back', 'edge_free', 0.872349, 0.888889, 1.447),
  ('chair_back', 'edge_free', 0.888889, 0.948678, 1.398),
  ('chair_back', 'edge_free', 0.948678, 1, 6.35);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'edge_free_top', 0, 0.111111, 0.3355),
  ('chair_back', 'edge_free_top', 0.111111, 0.222222, 0.1832),
  ('chair_back', 'edge_free_top', 0.222222, 0.333333, 0.09744),
  ('chair_back', 'edge_free_top', 0.333333, 0.444444, 0.08253),
  ('chair_back', 'edge_free_top', 0.444444, 0.555556, 0.1257),
  ('chair_back', 'edge_free_top', 0.555556, 0.666667, 0.1585),
  ('chair_back', 'edge_free_top', 0.666667, 0.777778, 0.1907),
  ('chair_back', 'edge_free_top', 0.777778, 0.866093, 0.2655),
  ('chair_back', 'edge_free_top', 0.866093, 0.888889, 0.3156),
  ('chair_back', 'edge_free_top', 0.888889, 1, 7.551);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'edge_joined', 0, 0.00493993, 79.44),
  ('chair_back', 'edge_joined', 0.00493993, 0.0376533, 3.688),
  ('chair_back', 'edge_joined', 0.0376533, 0.0781439, 3.089),
  ('chair_back', 'edge_joined', 0.0781439, 0.103394, 1.796),
  ('chair_back', 'edge_joined', 0.103394, 0.158552, 1.343),
  ('chair_back', 'edge_joined', 0.158552, 0.206788, 0.8666),
  ('chair_back', 'edge_joined', 0.206788, 0.287442, 0.8571),
  ('chair_back', 'edge_joined', 0.287442, 0.310182, 0.7623),
  ('chair_back', 'edge_joined', 0.310182, 0.413576, 0.4058),
  ('chair_back', 'edge_joined', 0.413576, 0.51697, 0.2688),
  ('chair_back', 'edge_joined', 0.51697, 0.620364, 0.09464),
  ('chair_back', 'edge_joined', 0.620364, 0.723758, 0.09901),
  ('chair_back', 'edge_joined', 0.723758, 0.827152, 0.0423),
  ('chair_back', 'edge_joined', 0.827152, 0.930546, 0.08869),
  ('chair_back', 'edge_joined', 0.930546, 1, 0.1555);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'height', -0.5, 0.596861, 0.009491),
  ('chair_back', 'height', 0.596861, 0.647969, 0.3589),
  ('chair_back', 'height', 0.647969, 0.699076, 1.325),
  ('chair_back', 'height', 0.699076, 0.71448, 1.822),
  ('chair_back', 'height', 0.71448, 0.750183, 2.4),
  ('chair_back', 'height', 0.750183, 0.755944, 3.489),
  ('chair_back', 'height', 0.755944, 0.785699, 3.751),
  ('chair_back', 'height', 0.785699, 0.801291, 4.497),
  ('chair_back', 'height', 0.801291, 0.809042, 5.225),
  ('chair_back', 'height', 0.809042, 0.826361, 5.23),
  ('chair_back', 'height', 0.826361, 0.852398, 3.745),
  ('chair_back', 'height', 0.852398, 0.90056, 2.986),
  ('chair_back', 'height', 0.90056, 0.940606, 2.644),
  ('chair_back', 'height', 0.940606, 0.954613, 1.946),
  ('chair_back', 'height', 0.954613, 1.00572, 0.9521),
  ('chair_back', 'height', 1.00572, 1.05683, 0.4732),
  ('chair_back', 'height', 1.05683, 4, 0.003241);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'length', 0.03, 0.242677, 0.005368),
  ('chair_back', 'length', 0.242677, 0.289041, 0.04312),
  ('chair_back', 'length', 0.289041, 0.344264, 0.1146),
  ('chair_back', 'length', 0.344264, 0.410037, 0.2941),
  ('chair_back', 'length', 0.410037, 0.430578, 0.7322),
  ('chair_back', 'length', 0.430578, 0.471188, 1.078),
  ('chair_back', 'length', 0.471188, 0.488376, 1.43),
  ('chair_back', 'length', 0.488376, 0.503145, 1.782),
  ('chair_back', 'length', 0.503145, 0.55088, 1.335),
  ('chair_back', 'length', 0.55088, 0.581683, 1.388),
  ('chair_back', 'length', 0.581683, 0.602468, 0.9071),
  ('chair_back', 'length', 0.602468, 0.649113, 1.313),
  ('chair_back', 'length', 0.649113, 0.692816, 0.927),
  ('chair_back', 'length', 0.692816, 0.732266, 1.234),
  ('chair_back', 'length', 0.732266, 0.807769, 1.108),
  ('chair_back', 'length', 0.807769, 0.825182, 0.7229),
  ('chair_back', 'length', 0.825182, 0.982837, 0.2864),
  ('chair_back', 'length', 0.982837, 1.16595, 0.1759),
  ('chair_back', 'length', 1.16595, 30, 0.004088);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'rectangularity', 0, 0.431144, 0.02148),
  ('chair_back', 'rectangularity', 0.431144, 0.494346, 0.2705),
  ('chair_back', 'rectangularity', 0.494346, 0.557547, 0.6844),
  ('chair_back', 'rectangularity', 0.557547, 0.580153, 1.629),
  ('chair_back', 'rectangularity', 0.580153, 0.620749, 1.212),
  ('chair_back', 'rectangularity', 0.620749, 0.676992, 1.187),
  ('chair_back', 'rectangularity', 0.676992, 0.683951, 1.811),
  ('chair_back', 'rectangularity', 0.683951, 0.741738, 1.851),
  ('chair_back', 'rectangularity', 0.741738, 0.783141, 2.659),
  ('chair_back', 'rectangularity', 0.783141, 0.810355, 3.191),
  ('chair_back', 'rectangularity', 0.810355, 0.819489, 2.713),
  ('chair_back', 'rectangularity', 0.819489, 0.849919, 3.418),
  ('chair_back', 'rectangularity', 0.849919, 0.873557, 3.482),
  ('chair_back', 'rectangularity', 0.873557, 0.883415, 3.141),
  ('chair_back', 'rectangularity', 0.883415, 0.922871, 2.556),
  ('chair_back', 'rectangularity', 0.922871, 0.936758, 2.651),
  ('chair_back', 'rectangularity', 0.936758, 0.98555, 1.406),
  ('chair_back', 'rectangularity', 0.98555, 1, 0.8833);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_length', 0.01, 0.23569, 0.003322),
  ('chair_back', 'spread_length', 0.23569, 0.275864, 0.102),
  ('chair_back', 'spread_length', 0.275864, 0.322886, 0.1692),
  ('chair_back', 'spread_length', 0.322886, 0.370553, 0.3676),
  ('chair_back', 'spread_length', 0.370553, 0.377922, 0.3991),
  ('chair_back', 'spread_length', 0.377922, 0.441039, 0.7623),
  ('chair_back', 'spread_length', 0.441039, 0.465056, 2.195),
  ('chair_back', 'spread_length', 0.465056, 0.489492, 2.145),
  ('chair_back', 'spread_length', 0.489492, 0.51093, 1.906),
  ('chair_back', 'spread_length', 0.51093, 0.517738, 1.547),
  ('chair_back', 'spread_length', 0.517738, 0.561518, 1.309),
  ('chair_back', 'spread_length', 0.561518, 0.6033, 1.527),
  ('chair_back', 'spread_length', 0.6033, 0.652119, 1.277),
  ('chair_back', 'spread_length', 0.652119, 0.70928, 0.7601),
  ('chair_back', 'spread_length', 0.70928, 0.830178, 0.2016),
  ('chair_back', 'spread_length', 0.830178, 0.971684, 0.1303),
  ('chair_back', 'spread_length', 0.971684, 40, 0.00295);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_width', 0.003, 0.115097, 0.003628),
  ('chair_back', 'spread_width', 0.115097, 0.139366, 0.1457),
  ('chair_back', 'spread_width', 0.139366, 0.168752, 0.2251),
  ('chair_back', 'spread_width', 0.168752, 0.184959, 0.2921),
  ('chair_back', 'spread_width', 0.184959, 0.204334, 0.2983),
  ('chair_back', 'spread_width', 0.204334, 0.245657, 0.4762),
  ('chair_back', 'spread_width', 0.245657, 0.283313, 0.774),
  ('chair_back', 'spread_width', 0.283313, 0.299587, 0.4158),
  ('chair_back', 'spread_width', 0.299587, 0.348413, 0.6531),
  ('chair_back', 'spread_width', 0.348413, 0.362756, 1.087),
  ('chair_back', 'spread_width', 0.362756, 0.380825, 1.345),
  ('chair_back', 'spread_width', 0.380825, 0.410553, 1.296),
  ('chair_back', 'spread_width', 0.410553, 0.439244, 1.265),
  ('chair_back', 'spread_width', 0.439244, 0.484106, 1.269),
  ('chair_back', 'spread_width', 0.484106, 0.53186, 0.942),
  ('chair_back', 'spread_width', 0.53186, 0.644004, 0.1161),
  ('chair_back', 'spread_width', 0.644004, 20, 0.003822);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'tilt_deg', 0, 72.5623, 0.0001302),
  ('chair_back', 'tilt_deg', 72.5623, 74.3644, 0.01632),
  ('chair_back', 'tilt_deg', 74.3644, 76.1665, 0.03469),
  ('chair_back', 'tilt_deg', 76.1665, 76.3488, 0.04417),
  ('chair_back', 'tilt_deg', 76.3488, 77.7524, 0.07792),
  ('chair_back', 'tilt_deg', 77.7524, 77.9686, 0.1301),
  ('chair_back', 'tilt_deg', 77.9686, 78.7994, 0.1116),
  ('chair_back', 'tilt_deg', 78.7994, 79.7706, 0.06977),
  ('chair_back', 'tilt_deg', 79.7706, 80.2286, 0.08235),
  ('chair_back', 'tilt_deg', 80.2286, 81.4338, 0.09836),
  ('chair_back', 'tilt_deg', 81.4338, 82.3117, 0.1081),
  ('chair_back', 'tilt_deg', 82.3117, 83.3748, 0.05115),
  ('chair_back', 'tilt_deg', 83.3748, 84.3547, 0.07157),
  ('chair_back', 'tilt_deg', 84.3547, 85.1768, 0.07474),
  ('chair_back', 'tilt_deg', 85.1768, 85.8371, 0.07258),
  ('chair_back', 'tilt_deg', 85.8371, 86.9789, 0.06295),
  ('chair_back', 'tilt_deg', 86.9789, 88.781, 0.015),
  ('chair_back', 'tilt_deg', 88.781, 90, 0.007082);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'width', 0.01, 0.165802, 0.005872),
  ('chair_back', 'width', 0.165802, 0.197294, 0.2663),
  ('chair_back', 'width', 0.197294, 0.233382, 0.2754),
  ('chair_back', 'width', 0.233382, 0.27936, 0.2717),
  ('chair_back', 'width', 0.27936, 0.315632, 0.5221),
  ('chair_back', 'width', 0.315632, 0.332421, 0.6059),
  ('chair_back', 'width', 0.332421, 0.395561, 0.5676),
  ('chair_back', 'width', 0.395561, 0.426183, 1.55),
  ('chair_back', 'width', 0.426183, 0.443493, 2.251),
  ('chair_back', 'width', 0.443493, 0.469074, 1.998),
  ('chair_back', 'width', 0.469074, 0.498961, 1.744),
  ('chair_back', 'width', 0.498961, 0.53093, 1.644),
  ('chair_back', 'width', 0.53093, 0.560096, 0.999),
  ('chair_back', 'width', 0.560096, 0.66648, 0.2069),
  ('chair_back', 'width', 0.66648, 0.79307, 0.1),
  ('chair_back', 'width', 0.79307, 12, 0.005268);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_max', -0.5, 0.767739, 0.009952),
  ('chair_back', 'z_max', 0.767739, 0.818883, 0.448),
  ('chair_back', 'z_max', 0.818883, 0.870028, 0.758),
  ('chair_back', 'z_max', 0.870028, 0.905242, 1.041),
  ('chair_back', 'z_max', 0.905242, 0.921172, 1.399),
  ('chair_back', 'z_max', 0.921172, 0.958255, 2.483),
  ('chair_back', 'z_max', 0.958255, 0.972317, 3.229),
  ('chair_back', 'z_max', 0.972317, 0.99223, 3.553),
  ('chair_back', 'z_max', 0.99223, 1.01708, 4.014),
  ('chair_back', 'z_max', 1.01708, 1.02346, 3.395),
  ('chair_back', 'z_max', 1.02346, 1.05025, 3.366),
  ('chair_back', 'z_max', 1.05025, 1.07461, 3.86),
  ('chair_back', 'z_max', 1.07461, 1.08045, 4.139),
  ('chair_back', 'z_max', 1.08045, 1.11156, 3.534),
  ('chair_back', 'z_max', 1.11156, 1.12575, 2.222),
  ('chair_back', 'z_max', 1.12575, 1.15905, 2.102),
  ('chair_back', 'z_max', 1.15905, 1.1769, 2.894),
  ('chair_back', 'z_max', 1.1769, 1.21919, 1.353),
  ('chair_back', 'z_max', 1.21919, 1.22804, 0.3377),
  ('chair_back', 'z_max', 1.22804, 4, 0.001965);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_min', -0.5, -0.0419979, 0.04189),
  ('chair_back', 'z_min', -0.0419979, 0.0593539, 0.2724),
  ('chair_back', 'z_min', 0.0593539, 0.160706, 0.2088),
  ('chair_back', 'z_min', 0.160706, 0.262058, 0.2177),
  ('chair_back', 'z_min', 0.262058, 0.304523, 0.8147),
  ('chair_back', 'z_min', 0.304523, 0.363113, 1.805),
  ('chair_back', 'z_min', 0.363113, 0.406683, 2.607),
  ('chair_back', 'z_min', 0.406683, 0.431762, 3.638),
  ('chair_back', 'z_min', 0.431762, 0.464761, 2.97),
  ('chair_back', 'z_min', 0.464761, 0.475978, 2.557),
  ('chair_back', 'z_min', 0.475978, 0.51561, 2.442),
  ('chair_back', 'z_min', 0.51561, 0.566113, 1.223),
  ('chair_back', 'z_min', 0.566113, 0.612917, 1.258),
  ('chair_back', 'z_min', 0.612917, 0.658069, 2.195),
  ('chair_back', 'z_min', 0.658069, 0.667465, 2.209),
  ('chair_back', 'z_min', 0.667465, 0.768817, 0.5633),
  ('chair_back', 'z_min', 0.768817, 0.870169, 0.3078),
  ('chair_back', 'z_min', 0.870169, 4, 0.004025);

-- door: 63 examples
UPDATE object_class SET prior = 0.01311 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.2975, 0.5474)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.7457, 0.2604)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.2445, 0.303)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.2245, 0.306)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.3651, 0.4147)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_joined', 0.191, 0.2685)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.14, 0.2002)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.6233, 0.2514)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.8346, 0.1183)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4766, 0.275)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.2501, 0.3692)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 89.8, 0.6086)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.1366, 0.3439)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.04, 0.2611)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1462, 0.3058)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'door' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'area_m2', 0.002, 0.122914, 0.003238),
  ('door', 'area_m2', 0.122914, 0.16972, 0.002665),
  ('door', 'area_m2', 0.16972, 0.234349, 0.03802),
  ('door', 'area_m2', 0.234349, 0.323589, 0.01655),
  ('door', 'area_m2', 0.323589, 0.446811, 0.1039),
  ('door', 'area_m2', 0.446811, 0.616956, 0.04266),
  ('door', 'area_m2', 0.616956, 0.851892, 0.1682),
  ('door', 'area_m2', 0.851892, 1.17629, 0.2777),
  ('door', 'area_m2', 1.17629, 1.25623, 0.4857),
  ('door', 'area_m2', 1.25623, 1.39053, 1.048),
  ('door', 'area_m2', 1.39053, 1.59451, 0.8457),
  ('door', 'area_m2', 1.59451, 1.62422, 1.662),
  ('door', 'area_m2', 1.62422, 1.68056, 1.787),
  ('door', 'area_m2', 1.68056, 1.75412, 2.235),
  ('door', 'area_m2', 1.75412, 1.8252, 2.291),
  ('door', 'area_m2', 1.8252, 1.92581, 1.783),
  ('door', 'area_m2', 1.92581, 2.1983, 0.8422),
  ('door', 'area_m2', 2.1983, 2.24272, 0.2093),
  ('door', 'area_m2', 2.24272, 100, 0.00876);
DELETE FROM class_density WHERE class = 'door' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'aspect', 1, 1.08158, 0.1348),
  ('door', 'aspect', 1.08158, 1.2879, 0.2251),
  ('door', 'aspect', 1.2879, 1.53358, 0.3717),
  ('door', 'aspect', 1.53358, 1.81937, 0.722),
  ('door', 'aspect', 1.81937, 1.97419, 1.308),
  ('door', 'aspect', 1.97419, 2.09516, 1.774),
  ('door', 'aspect', 2.09516, 2.17447, 1.445),
  ('door', 'aspect', 2.17447, 2.28883, 1.417),
  ('door', 'aspect', 2.28883, 2.34708, 3.458),
  ('door', 'aspect', 2.34708, 2.45935, 2.234),
  ('door', 'aspect', 2.45935, 2.57779, 2.048),
  ('door', 'aspect', 2.57779, 3.0832, 0.4975),
  ('door', 'aspect', 3.0832, 3.67134, 0.1065),
  ('door', 'aspect', 3.67134, 4.37168, 0.07054),
  ('door', 'aspect', 4.37168, 5.20562, 0.01256),
  ('door', 'aspect', 5.20562, 100, 0.004527);
DELETE FROM class_density WHERE class = 'door' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'behind', 0, 0.0906821, 5.662),
  ('door', 'behind', 0.0906821, 0.181364, 0.3741),
  ('door', 'behind', 0.181364, 0.272046, 0.335),
  ('door', 'behind', 0.272046, 0.362728, 0.4563),
  ('door', 'behind', 0.362728, 0.45341, 0.54),
  ('door', 'behind', 0.45341, 0.456175, 0.5631),
  ('door', 'behind', 0.456175, 0.544092, 0.8683),
  ('door', 'behind', 0.544092, 0.570241, 1.511),
  ('door', 'behind', 0.570241, 0.634774, 0.9152),
  ('door', 'behind', 0.634774, 0.698371, 0.7487),
  ('door', 'behind', 0.698371, 0.725457, 1.427),
  ('door', 'behind', 0.725457, 0.816139, 0.5906),
  ('door', 'behind', 0.816139, 1, 0.08505);
DELETE FROM class_density WHERE class = 'door' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'edge_free', 0, 0.0987443, 5.179),
  ('door', 'edge_free', 0.0987443, 0.111111, 0.8794),
  ('door', 'edge_free', 0.111111, 0.222222, 0.773),
  ('door', 'edge_free', 0.222222, 0.303522, 0.5071),
  ('door', 'edge_free', 0.303522, 0.333333, 0.4454),
  ('door', 'edge_free', 0.333333, 0.444444, 0.4728),
  ('door', 'edge_free', 0.444444, 0.474252, 2.244),
  ('door', 'edge_free', 0.474252, 0.555556, 0.8774),
  ('door', 'edge_free', 0.555556, 0.656312, 0.3831),
  ('door', 'edge_free', 0.656312, 0.666667, 0.3349),
  ('door', 'edge_free', 0.666667, 0.777778, 0.288),
  ('door', 'edge_free', 0.777778, 0.888889, 0.303),
  ('door', 'edge_free', 0.888889, 1, 0.3498);
DELETE FROM class_density WHERE class = 'door' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'edge_free_top', 0, 0.111111, 4.216),
  ('door', 'edge_free_top', 0.111111, 0.222222, 0.2474),
  ('door', 'edge_free_top', 0.222222, 0.333333, 0.2925),
  ('door', 'edge_free_top', 0.333333, 0.396941, 0.3514),
  ('door', 'edge_free_top', 0.396941, 0.444444, 0.3978),
  ('door', 'edge_free_top', 0.444444, 0.555556, 0.4471),
  ('door', 'edge_free_top', 0.555556, 0.666667, 0.4308),
  ('door', 'edge_free_top', 0.666667, 0.685655, 0.3705),
  ('door', 'edge_free_top', 0.685655, 0.777778, 0.4441),
  ('door', 'edge_free_top', 0.777778, 0.845084, 1.313),
  ('door', 'edge_free_top', 0.845084, 0.888889, 1.263),
  ('door', 'edge_free_top', 0.888889, 0.932925, 0.9268),
  ('door', 'edge_free_top', 0.932925, 1, 1.496);
DELETE FROM class_density WHERE class = 'door' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'edge_joined', 0, 0.0100893, 19.12),
  ('door', 'edge_joined', 0.0100893, 0.0224938, 7.828),
  ('door', 'edge_joined', 0.0224938, 0.0453288, 4.466),
  ('door', 'edge_joined', 0.0453288, 0.101566, 2.022),
  ('door', 'edge_joined', 0.101566, 0.172835, 1.487),
  ('door', 'edge_joined', 0.172835, 0.209919, 1.544),
  ('door', 'edge_joined', 0.209919, 0.266551, 1.318),
  ('door', 'edge_joined', 0.266551, 0.314878, 1.05),
  ('door', 'edge_joined', 0.314878, 0.419838, 0.5192),
  ('door', 'edge_joined', 0.419838, 0.524797, 0.2381),
  ('door', 'edge_joined', 0.524797, 0.629757, 0.1622),
  ('door', 'edge_joined', 0.629757, 0.655949, 0.1713),
  ('door', 'edge_joined', 0.655949, 0.734716, 0.1937),
  ('door', 'edge_joined', 0.734716, 0.839676, 0.3219),
  ('door', 'edge_joined', 0.839676, 0.930561, 0.4033),
  ('door', 'edge_joined', 0.930561, 0.944635, 0.3233),
  ('door', 'edge_joined', 0.944635, 1, 0.2608);
DELETE FROM class_density WHERE class = 'door' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'height', -0.5, 0.470658, 0.01397),
  ('door', 'height', 0.470658, 0.603833, 0.1149),
  ('door', 'height', 0.603833, 0.737008, 0.1479),
  ('door', 'height', 0.737008, 0.870183, 0.1456),
  ('door', 'height', 0.870183, 1.00336, 0.3316),
  ('door', 'height', 1.00336, 1.02684, 1.682),
  ('door', 'height', 1.02684, 1.05092, 3.994),
  ('door', 'height', 1.05092, 1.06677, 5.608),
  ('door', 'height', 1.06677, 1.08354, 4.862),
  ('door', 'height', 1.08354, 1.13331, 2.503),
  ('door', 'height', 1.13331, 1.20929, 1.531),
  ('door', 'height', 1.20929, 1.26971, 1.512),
  ('door', 'height', 1.26971, 1.29078, 1.685),
  ('door', 'height', 1.29078, 1.35469, 1.475),
  ('door', 'height', 1.35469, 1.40288, 0.9526),
  ('door', 'height', 1.40288, 1.53606, 0.3436),
  ('door', 'height', 1.53606, 1.66923, 0.1062),
  ('door', 'height', 1.66923, 4, 0.005964);
DELETE FROM class_density WHERE class = 'door' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'length', 0.03, 0.636749, 0.004365),
  ('door', 'length', 0.636749, 0.738143, 0.000128),
  ('door', 'length', 0.738143, 0.855683, 0.02035),
  ('door', 'length', 0.855683, 0.991939, 0.0942),
  ('door', 'length', 0.991939, 1.14989, 0.309),
  ('door', 'length', 1.14989, 1.333, 0.1347),
  ('door', 'length', 1.333, 1.4638, 0.3821),
  ('door', 'length', 1.4638, 1.54526, 0.7436),
  ('door', 'length', 1.54526, 1.71387, 0.7695),
  ('door', 'length', 1.71387, 1.79132, 0.6856),
  ('door', 'length', 1.79132, 1.99902, 1.101),
  ('door', 'length', 1.99902, 2.02888, 4.687),
  ('door', 'length', 2.02888, 2.06537, 5.954),
  ('door', 'length', 2.06537, 2.08949, 5.85),
  ('door', 'length', 2.08949, 2.13522, 4.369),
  ('door', 'length', 2.13522, 2.25488, 2.391),
  ('door', 'length', 2.25488, 2.35867, 2.038),
  ('door', 'length', 2.35867, 2.40724, 0.4837),
  ('door', 'length', 2.40724, 30, 0.01082);
DELETE FROM class_density WHERE class = 'door' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'rectangularity', 0, 0.446586, 0.02264),
  ('door', 'rectangularity', 0.446586, 0.507451, 0.2499),
  ('door', 'rectangularity', 0.507451, 0.568316, 0.2613),
  ('door', 'rectangularity', 0.568316, 0.629181, 0.3798),
  ('door', 'rectangularity', 0.629181, 0.690047, 0.6921),
  ('door', 'rectangularity', 0.690047, 0.706569, 1.118),
  ('door', 'rectangularity', 0.706569, 0.750912, 1.777),
  ('door', 'rectangularity', 0.750912, 0.764507, 2.672),
  ('door', 'rectangularity', 0.764507, 0.802603, 2.828),
  ('door', 'rectangularity', 0.802603, 0.811777, 1.466),
  ('door', 'rectangularity', 0.811777, 0.858574, 2.081),
  ('door', 'rectangularity', 0.858574, 0.872642, 4.524),
  ('door', 'rectangularity', 0.872642, 0.893205, 6.978),
  ('door', 'rectangularity', 0.893205, 0.919641, 3.834),
  ('door', 'rectangularity', 0.919641, 0.933507, 1.767),
  ('door', 'rectangularity', 0.933507, 0.96121, 3.588),
  ('door', 'rectangularity', 0.96121, 0.975374, 6.334),
  ('door', 'rectangularity', 0.975374, 0.994372, 0.8948),
  ('door', 'rectangularity', 0.994372, 1, 0.4086);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_length', 0.01, 0.605232, 0.003258),
  ('door', 'spread_length', 0.605232, 0.69717, 0.003314),
  ('door', 'spread_length', 0.69717, 0.803072, 0.04014),
  ('door', 'spread_length', 0.803072, 0.925062, 0.2044),
  ('door', 'spread_length', 0.925062, 1.05186, 0.4436),
  ('door', 'spread_length', 1.05186, 1.06558, 0.4823),
  ('door', 'spread_length', 1.06558, 1.22745, 0.4124),
  ('door', 'spread_length', 1.22745, 1.40243, 0.6077),
  ('door', 'spread_length', 1.40243, 1.60894, 0.8432),
  ('door', 'spread_length', 1.60894, 1.62868, 1.884),
  ('door', 'spread_length', 1.62868, 1.69127, 1.952),
  ('door', 'spread_length', 1.69127, 1.87608, 1.087),
  ('door', 'spread_length', 1.87608, 1.96497, 2.892),
  ('door', 'spread_length', 1.96497, 2.00434, 4.921),
  ('door', 'spread_length', 2.00434, 2.12614, 2.694),
  ('door', 'spread_length', 2.12614, 2.16107, 0.4322),
  ('door', 'spread_length', 2.16107, 40, 0.009058);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_width', 0.003, 0.175346, 0.001523),
  ('door', 'spread_width', 0.175346, 0.180444, 0.1679),
  ('door', 'spread_width', 0.180444, 0.219107, 0.08081),
  ('door', 'spread_width', 0.219107, 0.27379, 0.00156),
  ('door', 'spread_width', 0.27379, 0.342121, 0.09099),
  ('door', 'spread_width', 0.342121, 0.427504, 0.1074),
  ('door', 'spread_width', 0.427504, 0.534197, 0.1809),
  ('door', 'spread_width', 0.534197, 0.573149, 0.3172),
  ('door', 'spread_width', 0.573149, 0.667518, 0.4023),
  ('door', 'spread_width', 0.667518, 0.76158, 0.536),
  ('door', 'spread_width', 0.76158, 0.810061, 2.049),
  ('door', 'spread_width', 0.810061, 0.821194, 3.341),
  ('door', 'spread_width', 0.821194, 0.834111, 3.26),
  ('door', 'spread_width', 0.834111, 0.860058, 2.552),
  ('door', 'spread_width', 0.860058, 0.895942, 2.17),
  ('door', 'spread_width', 0.895942, 0.94312, 2.142),
  ('door', 'spread_width', 0.94312, 1.00544, 1.541),
  ('door', 'spread_width', 1.00544, 1.04228, 0.4769),
  ('door', 'spread_width', 1.04228, 1.28252, 0.4482),
  ('door', 'spread_width', 1.28252, 1.30241, 0.2852),
  ('door', 'spread_width', 1.30241, 20, 0.007784);
DELETE FROM class_density WHERE class = 'door' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'tilt_deg', 0, 87.0341, 1.034e-05),
  ('door', 'tilt_deg', 87.0341, 87.3636, 0.03344),
  ('door', 'tilt_deg', 87.3636, 87.6932, 0.07581),
  ('door', 'tilt_deg', 87.6932, 88.0227, 0.04331),
  ('door', 'tilt_deg', 88.0227, 88.3523, 0.0146),
  ('door', 'tilt_deg', 88.3523, 88.6818, 0.03309),
  ('door', 'tilt_deg', 88.6818, 89.0114, 0.05714),
  ('door', 'tilt_deg', 89.0114, 89.3409, 0.103),
  ('door', 'tilt_deg', 89.3409, 89.6705, 0.5065),
  ('door', 'tilt_deg', 89.6705, 89.8051, 1.587),
  ('door', 'tilt_deg', 89.8051, 90, 2.564);
DELETE FROM class_density WHERE class = 'door' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'width', 0.01, 0.20956, 0.00319),
  ('door', 'width', 0.20956, 0.263045, 0.07478),
  ('door', 'width', 0.263045, 0.33018, 0.003326),
  ('door', 'width', 0.33018, 0.414449, 0.124),
  ('door', 'width', 0.414449, 0.520227, 0.06475),
  ('door', 'width', 0.520227, 0.653001, 0.1723),
  ('door', 'width', 0.653001, 0.760858, 0.2864),
  ('door', 'width', 0.760858, 0.819662, 0.8218),
  ('door', 'width', 0.819662, 0.84428, 1.616),
  ('door', 'width', 0.84428, 0.886612, 2.513),
  ('door', 'width', 0.886612, 0.904031, 4.074),
  ('door', 'width', 0.904031, 0.925051, 3.449),
  ('door', 'width', 0.925051, 0.982286, 2.262),
  ('door', 'width', 0.982286, 1.00842, 2.692),
  ('door', 'width', 1.00842, 1.02886, 1.925),
  ('door', 'width', 1.02886, 1.12186, 0.8946),
  ('door', 'width', 1.12186, 1.29145, 0.5294),
  ('door', 'width', 1.29145, 1.62105, 0.1766),
  ('door', 'width', 1.62105, 12, 0.009504);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_max', -0.5, 0.878929, 0.00967),
  ('door', 'z_max', 0.878929, 1.05777, 0.0072),
  ('door', 'z_max', 1.05777, 1.23661, 0.06787),
  ('door', 'z_max', 1.23661, 1.41545, 0.09468),
  ('door', 'z_max', 1.41545, 1.59429, 0.1663),
  ('door', 'z_max', 1.59429, 1.77313, 0.1146),
  ('door', 'z_max', 1.77313, 1.93724, 0.3647),
  ('door', 'z_max', 1.93724, 1.95197, 0.4875),
  ('door', 'z_max', 1.95197, 2.01908, 1.675),
  ('door', 'z_max', 2.01908, 2.0442, 4.135),
  ('door', 'z_max', 2.0442, 2.06184, 4.265),
  ('door', 'z_max', 2.06184, 2.09178, 3.66),
  ('door', 'z_max', 2.09178, 2.12233, 3.252),
  ('door', 'z_max', 2.12233, 2.13081, 2.874),
  ('door', 'z_max', 2.13081, 2.19372, 1.175),
  ('door', 'z_max', 2.19372, 2.2449, 2.118),
  ('door', 'z_max', 2.2449, 2.30965, 1.326),
  ('door', 'z_max', 2.30965, 2.48849, 0.1446),
  ('door', 'z_max', 2.48849, 4, 0.01338);
DELETE FROM class_density WHERE class = 'door' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'z_min', -0.5, -0.0725319, 0.1055),
  ('door', 'z_min', -0.0725319, -0.015774, 2.506),
  ('door', 'z_min', -0.015774, -0.00765939, 13.34),
  ('door', 'z_min', -0.00765939, 0.00157503, 16.38),
  ('door', 'z_min', 0.00157503, 0.0724815, 3.45),
  ('door', 'z_min', 0.0724815, 0.217495, 0.357),
  ('door', 'z_min', 0.217495, 0.362508, 0.4058),
  ('door', 'z_min', 0.362508, 0.507522, 0.487),
  ('door', 'z_min', 0.507522, 0.537751, 0.5427),
  ('door', 'z_min', 0.537751, 0.652535, 0.3204),
  ('door', 'z_min', 0.652535, 0.797548, 0.1254),
  ('door', 'z_min', 0.797548, 0.942562, 0.02034),
  ('door', 'z_min', 0.942562, 1.08758, 0.2138),
  ('door', 'z_min', 1.08758, 1.23259, 0.05984),
  ('door', 'z_min', 1.23259, 4, 0.004829);

-- window: 108 examples
UPDATE object_class SET prior = 0.02245 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', 0.01759, 0.669)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.352, 0.326)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.03671, 0.09419)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.01626, 0.06675)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_joined', 0.1716, 0.2597)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.526, 0.1635)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.2862, 0.2873)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8395, 0.1448)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.3026, 0.3237)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.132, 0.4476)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.64, 0.5511)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.06689, 0.3621)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.125, 0.1981)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 0.9646, 0.1881)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'window' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'area_m2', 0.002, 0.119383, 0.001668),
  ('window', 'area_m2', 0.119383, 0.125426, 0.06155),
  ('window', 'area_m2', 0.125426, 0.181483, 0.06678),
  ('window', 'area_m2', 0.181483, 0.275886, 0.04317),
  ('window', 'area_m2', 0.275886, 0.419395, 0.1218),
  ('window', 'area_m2', 0.419395, 0.446789, 0.17),
  ('window', 'area_m2', 0.446789, 0.637552, 0.1744),
  ('window', 'area_m2', 0.637552, 0.769245, 0.2708),
  ('window', 'area_m2', 0.769245, 0.956945, 0.5993),
  ('window', 'area_m2', 0.956945, 1.03215, 1.285),
  ('window', 'area_m2', 1.03215, 1.19215, 0.6829),
  ('window', 'area_m2', 1.19215, 1.40614, 0.7113),
  ('window', 'area_m2', 1.40614, 1.47334, 1.078),
  ('window', 'area_m2', 1.47334, 1.5537, 1.063),
  ('window', 'area_m2', 1.5537, 1.81675, 0.7273),
  ('window', 'area_m2', 1.81675, 2.23973, 0.2577),
  ('window', 'area_m2', 2.23973, 3.40478, 0.04919),
  ('window', 'area_m2', 3.40478, 5.17585, 0.0589),
  ('window', 'area_m2', 5.17585, 100, 0.003088);
DELETE FROM class_density WHERE class = 'window' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'aspect', 1, 1.05795, 2.009),
  ('window', 'aspect', 1.05795, 1.09938, 2.683),
  ('window', 'aspect', 1.09938, 1.14699, 2.511),
  ('window', 'aspect', 1.14699, 1.17588, 1.013),
  ('window', 'aspect', 1.17588, 1.2546, 1.223),
  ('window', 'aspect', 1.2546, 1.36908, 1.448),
  ('window', 'aspect', 1.36908, 1.38268, 3.43),
  ('window', 'aspect', 1.38268, 1.43775, 1.732),
  ('window', 'aspect', 1.43775, 1.60252, 0.9436),
  ('window', 'aspect', 1.60252, 1.62587, 0.6118),
  ('window', 'aspect', 1.62587, 1.91182, 0.3708),
  ('window', 'aspect', 1.91182, 2.1914, 0.3692),
  ('window', 'aspect', 2.1914, 2.24806, 0.3671),
  ('window', 'aspect', 2.24806, 2.64344, 0.2965),
  ('window', 'aspect', 2.64344, 3.10836, 0.2045),
  ('window', 'aspect', 3.10836, 3.65504, 0.06856),
  ('window', 'aspect', 3.65504, 4.29788, 0.07364),
  ('window', 'aspect', 4.29788, 100, 0.003055);
DELETE FROM class_density WHERE class = 'window' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'behind', 0, 0.00166667, 282),
  ('window', 'behind', 0.00166667, 0.00333333, 188.1),
  ('window', 'behind', 0.00333333, 0.005, 85.63),
  ('window', 'behind', 0.005, 1, 0.0741);
DELETE FROM class_density WHERE class = 'window' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'edge_free', 0, 0.0103788, 68.55),
  ('window', 'edge_free', 0.0103788, 0.050019, 1.904),
  ('window', 'edge_free', 0.050019, 0.100038, 1.387),
  ('window', 'edge_free', 0.100038, 0.114017, 1.2),
  ('window', 'edge_free', 0.114017, 0.150057, 0.9466),
  ('window', 'edge_free', 0.150057, 0.200076, 0.4484),
  ('window', 'edge_free', 0.200076, 0.250095, 0.2627),
  ('window', 'edge_free', 0.250095, 0.300114, 0.3601),
  ('window', 'edge_free', 0.300114, 0.350133, 0.2442),
  ('window', 'edge_free', 0.350133, 0.400152, 0.09183),
  ('window', 'edge_free', 0.400152, 0.450171, 0.1696),
  ('window', 'edge_free', 0.450171, 1, 0.02542);
DELETE FROM class_density WHERE class = 'window' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'edge_free_top', 0, 0.0448853, 19.74),
  ('window', 'edge_free_top', 0.0448853, 0.0897705, 0.9079),
  ('window', 'edge_free_top', 0.0897705, 0.134656, 0.5892),
  ('window', 'edge_free_top', 0.134656, 0.179541, 0.2341),
  ('window', 'edge_free_top', 0.179541, 0.224426, 0.09795),
  ('window', 'edge_free_top', 0.224426, 0.269312, 0.2559),
  ('window', 'edge_free_top', 0.269312, 0.314197, 0.07052),
  ('window', 'edge_free_top', 0.314197, 0.359082, 0.008301),
  ('window', 'edge_free_top', 0.359082, 0.403967, 0.1285),
  ('window', 'edge_free_top', 0.403967, 1, 0.01895);
DELETE FROM class_density WHERE class = 'window' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'edge_joined', 0, 0.00858486, 34.01),
  ('window', 'edge_joined', 0.00858486, 0.0303104, 5.442),
  ('window', 'edge_joined', 0.0303104, 0.0858662, 1.871),
  ('window', 'edge_joined', 0.0858662, 0.110326, 2.417),
  ('window', 'edge_joined', 0.110326, 0.128175, 3.036),
  ('window', 'edge_joined', 0.128175, 0.220652, 1.172),
  ('window', 'edge_joined', 0.220652, 0.243977, 0.9342),
  ('window', 'edge_joined', 0.243977, 0.330978, 0.7369),
  ('window', 'edge_joined', 0.330978, 0.441304, 0.3434),
  ('window', 'edge_joined', 0.441304, 0.546814, 0.282),
  ('window', 'edge_joined', 0.546814, 0.661957, 0.2054),
  ('window', 'edge_joined', 0.661957, 0.772283, 0.2222),
  ('window', 'edge_joined', 0.772283, 0.882609, 0.2148),
  ('window', 'edge_joined', 0.882609, 0.981672, 0.3269),
  ('window', 'edge_joined', 0.981672, 0.992935, 0.3459),
  ('window', 'edge_joined', 0.992935, 1, 0.3465);
DELETE FROM class_density WHERE class = 'window' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'height', -0.5, 1.08935, 0.0084),
  ('window', 'height', 1.08935, 1.19062, 0.2492),
  ('window', 'height', 1.19062, 1.2919, 0.307),
  ('window', 'height', 1.2919, 1.3585, 0.5845),
  ('window', 'height', 1.3585, 1.39318, 1.015),
  ('window', 'height', 1.39318, 1.42253, 2.781),
  ('window', 'height', 1.42253, 1.45525, 3.271),
  ('window', 'height', 1.45525, 1.49445, 2.56),
  ('window', 'height', 1.49445, 1.5041, 2.11),
  ('window', 'height', 1.5041, 1.53695, 2.974),
  ('window', 'height', 1.53695, 1.57935, 2.468),
  ('window', 'height', 1.57935, 1.59573, 2.913),
  ('window', 'height', 1.59573, 1.63589, 1.847),
  ('window', 'height', 1.63589, 1.697, 1.228),
  ('window', 'height', 1.697, 1.72225, 1.302),
  ('window', 'height', 1.72225, 1.79828, 0.9374),
  ('window', 'height', 1.79828, 1.89955, 0.1993),
  ('window', 'height', 1.89955, 2.00083, 0.1452),
  ('window', 'height', 2.00083, 4, 0.004262);
DELETE FROM class_density WHERE class = 'window' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'length', 0.03, 0.665722, 0.003985),
  ('window', 'length', 0.665722, 0.81469, 0.1162),
  ('window', 'length', 0.81469, 0.996994, 0.3278),
  ('window', 'length', 0.996994, 1.02093, 0.8101),
  ('window', 'length', 1.02093, 1.11757, 1.195),
  ('window', 'length', 1.11757, 1.20905, 1.375),
  ('window', 'length', 1.20905, 1.32392, 1.357),
  ('window', 'length', 1.32392, 1.36908, 2.7),
  ('window', 'length', 1.36908, 1.42805, 2.464),
  ('window', 'length', 1.42805, 1.4905, 2.204),
  ('window', 'length', 1.4905, 1.61883, 1.501),
  ('window', 'length', 1.61883, 1.82722, 0.5893),
  ('window', 'length', 1.82722, 2.2361, 0.05963),
  ('window', 'length', 2.2361, 2.73647, 0.04509),
  ('window', 'length', 2.73647, 3.34881, 0.007906),
  ('window', 'length', 3.34881, 4.09818, 0.09938),
  ('window', 'length', 4.09818, 30, 0.00622);
DELETE FROM class_density WHERE class = 'window' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'rectangularity', 0, 0.317871, 0.03889),
  ('window', 'rectangularity', 0.317871, 0.393, 0.1358),
  ('window', 'rectangularity', 0.393, 0.468129, 0.1603),
  ('window', 'rectangularity', 0.468129, 0.543259, 0.2453),
  ('window', 'rectangularity', 0.543259, 0.618388, 0.3147),
  ('window', 'rectangularity', 0.618388, 0.679142, 0.6963),
  ('window', 'rectangularity', 0.679142, 0.693517, 0.9512),
  ('window', 'rectangularity', 0.693517, 0.76352, 1.392),
  ('window', 'rectangularity', 0.76352, 0.768646, 2.449),
  ('window', 'rectangularity', 0.768646, 0.820408, 2.062),
  ('window', 'rectangularity', 0.820408, 0.843775, 2.757),
  ('window', 'rectangularity', 0.843775, 0.850476, 6.189),
  ('window', 'rectangularity', 0.850476, 0.896632, 2.384),
  ('window', 'rectangularity', 0.896632, 0.918904, 2.073),
  ('window', 'rectangularity', 0.918904, 0.94173, 3.308),
  ('window', 'rectangularity', 0.94173, 0.959782, 5.221),
  ('window', 'rectangularity', 0.959782, 0.970555, 9.98),
  ('window', 'rectangularity', 0.970555, 0.982985, 8.183),
  ('window', 'rectangularity', 0.982985, 0.994034, 0.6805),
  ('window', 'rectangularity', 0.994034, 1, 0.3345);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_length', 0.01, 0.460114, 0.002388),
  ('window', 'spread_length', 0.460114, 0.590811, 0.04492),
  ('window', 'spread_length', 0.590811, 0.758632, 0.1059),
  ('window', 'spread_length', 0.758632, 0.974125, 0.2467),
  ('window', 'spread_length', 0.974125, 1.02242, 0.3751),
  ('window', 'spread_length', 1.02242, 1.14957, 0.8919),
  ('window', 'spread_length', 1.14957, 1.25083, 1.066),
  ('window', 'spread_length', 1.25083, 1.26888, 1.423),
  ('window', 'spread_length', 1.26888, 1.32836, 2.201),
  ('window', 'spread_length', 1.32836, 1.42039, 1.653),
  ('window', 'spread_length', 1.42039, 1.52836, 1.54),
  ('window', 'spread_length', 1.52836, 1.60391, 2.096),
  ('window', 'spread_length', 1.60391, 1.74163, 1.444),
  ('window', 'spread_length', 1.74163, 2.06236, 0.4157),
  ('window', 'spread_length', 2.06236, 2.64818, 0.04408),
  ('window', 'spread_length', 2.64818, 3.4004, 0.04503),
  ('window', 'spread_length', 3.4004, 4.36629, 0.04599),
  ('window', 'spread_length', 4.36629, 40, 0.004467);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_width', 0.003, 0.200188, 0.002604),
  ('window', 'spread_width', 0.200188, 0.252861, 0.06347),
  ('window', 'spread_width', 0.252861, 0.319391, 0.05716),
  ('window', 'spread_width', 0.319391, 0.403427, 0.1537),
  ('window', 'spread_width', 0.403427, 0.442872, 0.2666),
  ('window', 'spread_width', 0.442872, 0.509574, 0.2753),
  ('window', 'spread_width', 0.509574, 0.643649, 0.2862),
  ('window', 'spread_width', 0.643649, 0.687625, 0.3133),
  ('window', 'spread_width', 0.687625, 0.813001, 0.413),
  ('window', 'spread_width', 0.813001, 0.870461, 0.8282),
  ('window', 'spread_width', 0.870461, 0.979719, 0.9943),
  ('window', 'spread_width', 0.979719, 1.02691, 1.73),
  ('window', 'spread_width', 1.02691, 1.09973, 1.684),
  ('window', 'spread_width', 1.09973, 1.19384, 1.239),
  ('window', 'spread_width', 1.19384, 1.29711, 0.9042),
  ('window', 'spread_width', 1.29711, 1.33887, 1.039),
  ('window', 'spread_width', 1.33887, 1.63839, 0.5394),
  ('window', 'spread_width', 1.63839, 20, 0.006104);
DELETE FROM class_density WHERE class = 'window' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'tilt_deg', 0, 87.2471, 9.012e-05),
  ('window', 'tilt_deg', 87.2471, 87.553, 0.01482),
  ('window', 'tilt_deg', 87.553, 87.8589, 0.03951),
  ('window', 'tilt_deg', 87.8589, 88.1648, 0.04564),
  ('window', 'tilt_deg', 88.1648, 88.4706, 0.07299),
  ('window', 'tilt_deg', 88.4706, 88.7765, 0.1282),
  ('window', 'tilt_deg', 88.7765, 89.0824, 0.1601),
  ('window', 'tilt_deg', 89.0824, 89.3883, 0.2229),
  ('window', 'tilt_deg', 89.3883, 89.6021, 0.5626),
  ('window', 'tilt_deg', 89.6021, 89.771, 1.216),
  ('window', 'tilt_deg', 89.771, 90, 1.996);
DELETE FROM class_density WHERE class = 'window' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'width', 0.01, 0.276736, 0.003518),
  ('window', 'width', 0.276736, 0.334041, 0.0849),
  ('window', 'width', 0.334041, 0.403213, 0.09553),
  ('window', 'width', 0.403213, 0.486709, 0.121),
  ('window', 'width', 0.486709, 0.587495, 0.273),
  ('window', 'width', 0.587495, 0.709151, 0.3778),
  ('window', 'width', 0.709151, 0.825134, 0.2943),
  ('window', 'width', 0.825134, 0.855999, 0.3777),
  ('window', 'width', 0.855999, 0.938693, 1.058),
  ('window', 'width', 0.938693, 1.01676, 1.468),
  ('window', 'width', 1.01676, 1.03326, 2.093),
  ('window', 'width', 1.03326, 1.06861, 2.099),
  ('window', 'width', 1.06861, 1.11294, 2.284),
  ('window', 'width', 1.11294, 1.19457, 1.548),
  ('window', 'width', 1.19457, 1.24722, 1.055),
  ('window', 'width', 1.24722, 1.29417, 1.651),
  ('window', 'width', 1.29417, 1.50549, 0.6442),
  ('window', 'width', 1.50549, 12, 0.01211);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_max', -0.5, 1.35725, 0.004835),
  ('window', 'z_max', 1.35725, 1.48109, 0.06784),
  ('window', 'z_max', 1.48109, 1.60493, 0.08431),
  ('window', 'z_max', 1.60493, 1.72878, 0.07111),
  ('window', 'z_max', 1.72878, 1.85262, 0.1146),
  ('window', 'z_max', 1.85262, 1.94015, 0.7696),
  ('window', 'z_max', 1.94015, 1.97646, 1.683),
  ('window', 'z_max', 1.97646, 1.99618, 2.242),
  ('window', 'z_max', 1.99618, 2.05377, 2.082),
  ('window', 'z_max', 2.05377, 2.08801, 2.781),
  ('window', 'z_max', 2.08801, 2.10031, 1.931),
  ('window', 'z_max', 2.10031, 2.16204, 1.598),
  ('window', 'z_max', 2.16204, 2.22415, 1.275),
  ('window', 'z_max', 2.22415, 2.24177, 1.865),
  ('window', 'z_max', 2.24177, 2.2699, 3.353),
  ('window', 'z_max', 2.2699, 2.34799, 1.305),
  ('window', 'z_max', 2.34799, 2.3669, 1.07),
  ('window', 'z_max', 2.3669, 2.47184, 0.9206),
  ('window', 'z_max', 2.47184, 4, 0.009101);
DELETE FROM class_density WHERE class = 'window' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'z_min', -0.5, 0.701132, 0.01575),
  ('window', 'z_min', 0.701132, 0.80379, 0.257),
  ('window', 'z_min', 0.80379, 0.826729, 3.465),
  ('window', 'z_min', 0.826729, 0.849684, 4.637),
  ('window', 'z_min', 0.849684, 0.876798, 3.964),
  ('window', 'z_min', 0.876798, 0.904458, 3.972),
  ('window', 'z_min', 0.904458, 0.927253, 4.69),
  ('window', 'z_min', 0.927253, 0.951691, 3.884),
  ('window', 'z_min', 0.951691, 0.974829, 4.044),
  ('window', 'z_min', 0.974829, 1.0091, 2.507),
  ('window', 'z_min', 1.0091, 1.11176, 0.2339),
  ('window', 'z_min', 1.11176, 1.20902, 0.3118),
  ('window', 'z_min', 1.20902, 1.31708, 0.2677),
  ('window', 'z_min', 1.31708, 1.41973, 0.2948),
  ('window', 'z_min', 1.41973, 1.52239, 0.2813),
  ('window', 'z_min', 1.52239, 1.62505, 0.1652),
  ('window', 'z_min', 1.62505, 4, 0.004511);

-- whiteboard: 54 examples
UPDATE object_class SET prior = 0.01119 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.1893, 0.7106)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4077, 0.3167)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.001806, 0.009945)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.05515, 0.09614)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.06879, 0.1226)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_joined', 0.7037, 0.2677)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.391, 0.142)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.4364, 0.3272)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.7724, 0.1077)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.2796, 0.3144)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.254, 0.4105)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.62, 0.9269)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', 0.02674, 0.4224)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 2.022, 0.2581)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.7913, 0.26)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'area_m2', 0.002, 0.136733, 0.002606),
  ('whiteboard', 'area_m2', 0.136733, 0.207464, 0.05786),
  ('whiteboard', 'area_m2', 0.207464, 0.314782, 0.09458),
  ('whiteboard', 'area_m2', 0.314782, 0.477615, 0.05738),
  ('whiteboard', 'area_m2', 0.477615, 0.606505, 0.1543),
  ('whiteboard', 'area_m2', 0.606505, 0.72468, 0.2579),
  ('whiteboard', 'area_m2', 0.72468, 0.868444, 0.3253),
  ('whiteboard', 'area_m2', 0.868444, 1.09955, 0.4298),
  ('whiteboard', 'area_m2', 1.09955, 1.27549, 0.7456),
  ('whiteboard', 'area_m2', 1.27549, 1.44329, 1.033),
  ('whiteboard', 'area_m2', 1.44329, 1.6017, 0.8184),
  ('whiteboard', 'area_m2', 1.6017, 2.07496, 0.4712),
  ('whiteboard', 'area_m2', 2.07496, 2.42936, 0.5729),
  ('whiteboard', 'area_m2', 2.42936, 3.84078, 0.2031),
  ('whiteboard', 'area_m2', 3.84078, 5.82757, 0.03179),
  ('whiteboard', 'area_m2', 5.82757, 100, 0.00572);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'aspect', 1, 1.07585, 1.626),
  ('whiteboard', 'aspect', 1.07585, 1.13935, 1.57),
  ('whiteboard', 'aspect', 1.13935, 1.17335, 1.451),
  ('whiteboard', 'aspect', 1.17335, 1.24445, 1.193),
  ('whiteboard', 'aspect', 1.24445, 1.37676, 1.034),
  ('whiteboard', 'aspect', 1.37676, 1.55465, 1.105),
  ('whiteboard', 'aspect', 1.55465, 1.61543, 2.379),
  ('whiteboard', 'aspect', 1.61543, 1.76304, 1.29),
  ('whiteboard', 'aspect', 1.76304, 1.89547, 0.593),
  ('whiteboard', 'aspect', 1.89547, 2.1819, 0.4887),
  ('whiteboard', 'aspect', 2.1819, 2.60962, 0.3517),
  ('whiteboard', 'aspect', 2.60962, 3.062, 0.1405),
  ('whiteboard', 'aspect', 3.062, 3.59282, 0.09397),
  ('whiteboard', 'aspect', 3.59282, 4.21565, 0.08676),
  ('whiteboard', 'aspect', 4.21565, 100, 0.002993);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'behind', 0, 0.00799675, 111.4),
  ('whiteboard', 'behind', 0.00799675, 0.0159935, 7.306),
  ('whiteboard', 'behind', 0.0159935, 0.0239903, 2.281),
  ('whiteboard', 'behind', 0.0239903, 0.031987, 1.48),
  ('whiteboard', 'behind', 0.031987, 0.0399838, 0.696),
  ('whiteboard', 'behind', 0.0399838, 0.0479805, 0.01969),
  ('whiteboard', 'behind', 0.0479805, 0.0559773, 5.886e-05),
  ('whiteboard', 'behind', 0.0559773, 0.063974, 6.471e-07),
  ('whiteboard', 'behind', 0.063974, 0.0719708, 5.024e-09),
  ('whiteboard', 'behind', 0.0719708, 1, 0.01633);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'edge_free', 0, 0.00915274, 41.59),
  ('whiteboard', 'edge_free', 0.00915274, 0.0177251, 11.42),
  ('whiteboard', 'edge_free', 0.0177251, 0.0302502, 8.849),
  ('whiteboard', 'edge_free', 0.0302502, 0.0438595, 5.5),
  ('whiteboard', 'edge_free', 0.0438595, 0.0678371, 2.121),
  ('whiteboard', 'edge_free', 0.0678371, 0.087719, 2.243),
  ('whiteboard', 'edge_free', 0.087719, 0.131579, 1.661),
  ('whiteboard', 'edge_free', 0.131579, 0.175438, 1.027),
  ('whiteboard', 'edge_free', 0.175438, 0.186144, 0.9579),
  ('whiteboard', 'edge_free', 0.186144, 0.219298, 1.083),
  ('whiteboard', 'edge_free', 0.219298, 0.263157, 0.3101),
  ('whiteboard', 'edge_free', 0.263157, 0.307017, 0.4852),
  ('whiteboard', 'edge_free', 0.307017, 0.350876, 0.3474),
  ('whiteboard', 'edge_free', 0.350876, 0.394736, 0.259),
  ('whiteboard', 'edge_free', 0.394736, 1, 0.02434);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'edge_free_top', 0, 0.00760838, 59.55),
  ('whiteboard', 'edge_free_top', 0.00760838, 0.0300971, 4.986),
  ('whiteboard', 'edge_free_top', 0.0300971, 0.0514874, 3.804),
  ('whiteboard', 'edge_free_top', 0.0514874, 0.102975, 1.478),
  ('whiteboard', 'edge_free_top', 0.102975, 0.108064, 0.9339),
  ('whiteboard', 'edge_free_top', 0.108064, 0.154462, 1.271),
  ('whiteboard', 'edge_free_top', 0.154462, 0.205949, 1.395),
  ('whiteboard', 'edge_free_top', 0.205949, 0.22296, 1.235),
  ('whiteboard', 'edge_free_top', 0.22296, 0.257437, 0.8253),
  ('whiteboard', 'edge_free_top', 0.257437, 0.308924, 0.6374),
  ('whiteboard', 'edge_free_top', 0.308924, 0.360412, 0.152),
  ('whiteboard', 'edge_free_top', 0.360412, 0.411899, 0.3112),
  ('whiteboard', 'edge_free_top', 0.411899, 0.463386, 0.3828),
  ('whiteboard', 'edge_free_top', 0.463386, 1, 0.02975);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'edge_joined', 0, 0.111111, 0.4125),
  ('whiteboard', 'edge_joined', 0.111111, 0.222222, 0.3322),
  ('whiteboard', 'edge_joined', 0.222222, 0.281281, 0.2937),
  ('whiteboard', 'edge_joined', 0.281281, 0.333333, 0.2825),
  ('whiteboard', 'edge_joined', 0.333333, 0.444444, 0.328),
  ('whiteboard', 'edge_joined', 0.444444, 0.555556, 0.6027),
  ('whiteboard', 'edge_joined', 0.555556, 0.57684, 1.159),
  ('whiteboard', 'edge_joined', 0.57684, 0.666667, 1.334),
  ('whiteboard', 'edge_joined', 0.666667, 0.741988, 1.382),
  ('whiteboard', 'edge_joined', 0.741988, 0.777778, 1.601),
  ('whiteboard', 'edge_joined', 0.777778, 0.803261, 2.323),
  ('whiteboard', 'edge_joined', 0.803261, 0.859633, 1.757),
  ('whiteboard', 'edge_joined', 0.859633, 0.888889, 1.614),
  ('whiteboard', 'edge_joined', 0.888889, 0.909685, 2.602),
  ('whiteboard', 'edge_joined', 0.909685, 0.977472, 1.659),
  ('whiteboard', 'edge_joined', 0.977472, 1, 4.61);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'height', -0.5, 0.814414, 0.01068),
  ('whiteboard', 'height', 0.814414, 0.904084, 0.06553),
  ('whiteboard', 'height', 0.904084, 0.993754, 0.1097),
  ('whiteboard', 'height', 0.993754, 1.08342, 0.04672),
  ('whiteboard', 'height', 1.08342, 1.17309, 0.3092),
  ('whiteboard', 'height', 1.17309, 1.26276, 0.6963),
  ('whiteboard', 'height', 1.26276, 1.32785, 1.921),
  ('whiteboard', 'height', 1.32785, 1.35243, 2.039),
  ('whiteboard', 'height', 1.35243, 1.37348, 3.144),
  ('whiteboard', 'height', 1.37348, 1.38939, 5.039),
  ('whiteboard', 'height', 1.38939, 1.41902, 3.724),
  ('whiteboard', 'height', 1.41902, 1.4421, 3.331),
  ('whiteboard', 'height', 1.4421, 1.44976, 3.343),
  ('whiteboard', 'height', 1.44976, 1.4908, 3.004),
  ('whiteboard', 'height', 1.4908, 1.53177, 2.15),
  ('whiteboard', 'height', 1.53177, 1.60657, 1.405),
  ('whiteboard', 'height', 1.60657, 1.62144, 0.582),
  ('whiteboard', 'height', 1.62144, 4, 0.006914);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'length', 0.03, 0.62663, 0.004784),
  ('whiteboard', 'length', 0.62663, 0.768672, 0.03012),
  ('whiteboard', 'length', 0.768672, 0.942912, 0.08979),
  ('whiteboard', 'length', 0.942912, 1.08959, 0.4817),
  ('whiteboard', 'length', 1.08959, 1.15665, 0.939),
  ('whiteboard', 'length', 1.15665, 1.22195, 1.257),
  ('whiteboard', 'length', 1.22195, 1.29091, 1.921),
  ('whiteboard', 'length', 1.29091, 1.37471, 1.495),
  ('whiteboard', 'length', 1.37471, 1.41883, 1.26),
  ('whiteboard', 'length', 1.41883, 1.55601, 0.8072),
  ('whiteboard', 'length', 1.55601, 1.74045, 0.8208),
  ('whiteboard', 'length', 1.74045, 1.79046, 0.6881),
  ('whiteboard', 'length', 1.79046, 2.00487, 0.9478),
  ('whiteboard', 'length', 2.00487, 2.13497, 0.9517),
  ('whiteboard', 'length', 2.13497, 2.33537, 0.6307),
  ('whiteboard', 'length', 2.33537, 2.61892, 0.5645),
  ('whiteboard', 'length', 2.61892, 3.21257, 0.1568),
  ('whiteboard', 'length', 3.21257, 3.94078, 0.03334),
  ('whiteboard', 'length', 3.94078, 30, 0.006783);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'rectangularity', 0, 0.46758, 0.02407),
  ('whiteboard', 'rectangularity', 0.46758, 0.517403, 0.3687),
  ('whiteboard', 'rectangularity', 0.517403, 0.567226, 0.6247),
  ('whiteboard', 'rectangularity', 0.567226, 0.617048, 0.9015),
  ('whiteboard', 'rectangularity', 0.617048, 0.626303, 1.035),
  ('whiteboard', 'rectangularity', 0.626303, 0.666871, 1.174),
  ('whiteboard', 'rectangularity', 0.666871, 0.714076, 1.65),
  ('whiteboard', 'rectangularity', 0.714076, 0.737318, 4.487),
  ('whiteboard', 'rectangularity', 0.737318, 0.766517, 3.254),
  ('whiteboard', 'rectangularity', 0.766517, 0.786586, 1.424),
  ('whiteboard', 'rectangularity', 0.786586, 0.816339, 2.216),
  ('whiteboard', 'rectangularity', 0.816339, 0.824293, 5.163),
  ('whiteboard', 'rectangularity', 0.824293, 0.844419, 5.645),
  ('whiteboard', 'rectangularity', 0.844419, 0.86603, 4.769),
  ('whiteboard', 'rectangularity', 0.86603, 0.880867, 5.679),
  ('whiteboard', 'rectangularity', 0.880867, 0.9018, 4.243),
  ('whiteboard', 'rectangularity', 0.9018, 0.915985, 1.194),
  ('whiteboard', 'rectangularity', 0.915985, 1, 0.2107);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_length', 0.01, 0.55461, 0.00312),
  ('whiteboard', 'spread_length', 0.55461, 0.666292, 0.0748),
  ('whiteboard', 'spread_length', 0.666292, 0.800464, 0.1791),
  ('whiteboard', 'spread_length', 0.800464, 0.914936, 0.3997),
  ('whiteboard', 'spread_length', 0.914936, 0.961655, 0.5839),
  ('whiteboard', 'spread_length', 0.961655, 1.09124, 0.7669),
  ('whiteboard', 'spread_length', 1.09124, 1.15466, 1.699),
  ('whiteboard', 'spread_length', 1.15466, 1.25011, 1.49),
  ('whiteboard', 'spread_length', 1.25011, 1.38795, 0.9803),
  ('whiteboard', 'spread_length', 1.38795, 1.47448, 1.689),
  ('whiteboard', 'spread_length', 1.47448, 1.66744, 0.7198),
  ('whiteboard', 'spread_length', 1.66744, 1.90281, 0.9503),
  ('whiteboard', 'spread_length', 1.90281, 2.00322, 1.019),
  ('whiteboard', 'spread_length', 2.00322, 2.40661, 0.2578),
  ('whiteboard', 'spread_length', 2.40661, 2.89123, 0.08198),
  ('whiteboard', 'spread_length', 2.89123, 40, 0.005232);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_width', 0.003, 0.171213, 0.003262),
  ('whiteboard', 'spread_width', 0.171213, 0.222006, 0.04909),
  ('whiteboard', 'spread_width', 0.222006, 0.287868, 0.07071),
  ('whiteboard', 'spread_width', 0.287868, 0.373268, 0.07505),
  ('whiteboard', 'spread_width', 0.373268, 0.484004, 0.1607),
  ('whiteboard', 'spread_width', 0.484004, 0.566543, 0.235),
  ('whiteboard', 'spread_width', 0.566543, 0.627591, 0.4221),
  ('whiteboard', 'spread_width', 0.627591, 0.690448, 0.7722),
  ('whiteboard', 'spread_width', 0.690448, 0.738533, 1.301),
  ('whiteboard', 'spread_width', 0.738533, 0.813775, 0.9681),
  ('whiteboard', 'spread_width', 0.813775, 0.829167, 1.237),
  ('whiteboard', 'spread_width', 0.829167, 0.886244, 1.512),
  ('whiteboard', 'spread_width', 0.886244, 0.92464, 2.188),
  ('whiteboard', 'spread_width', 0.92464, 0.964184, 2.161),
  ('whiteboard', 'spread_width', 0.964184, 1.05519, 1.137),
  ('whiteboard', 'spread_width', 1.05519, 1.36823, 0.4085),
  ('whiteboard', 'spread_width', 1.36823, 1.77414, 0.1104),
  ('whiteboard', 'spread_width', 1.77414, 20, 0.005987);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'tilt_deg', 0, 85.273, 1.822e-05),
  ('whiteboard', 'tilt_deg', 85.273, 85.5637, 0.02545),
  ('whiteboard', 'tilt_deg', 85.5637, 85.7983, 0.04168),
  ('whiteboard', 'tilt_deg', 85.7983, 86.3235, 0.02153),
  ('whiteboard', 'tilt_deg', 86.3235, 86.8487, 0.007492),
  ('whiteboard', 'tilt_deg', 86.8487, 87.3739, 0.02313),
  ('whiteboard', 'tilt_deg', 87.3739, 87.8991, 0.01971),
  ('whiteboard', 'tilt_deg', 87.8991, 88.4243, 0.0712),
  ('whiteboard', 'tilt_deg', 88.4243, 88.9496, 0.07959),
  ('whiteboard', 'tilt_deg', 88.9496, 89.2541, 0.1561),
  ('whiteboard', 'tilt_deg', 89.2541, 89.4748, 0.288),
  ('whiteboard', 'tilt_deg', 89.4748, 89.7915, 0.9677),
  ('whiteboard', 'tilt_deg', 89.7915, 90, 2.143);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'width', 0.01, 0.238802, 0.004769),
  ('whiteboard', 'width', 0.238802, 0.309038, 0.04969),
  ('whiteboard', 'width', 0.309038, 0.399931, 0.07787),
  ('whiteboard', 'width', 0.399931, 0.517558, 0.1435),
  ('whiteboard', 'width', 0.517558, 0.669781, 0.1696),
  ('whiteboard', 'width', 0.669781, 0.677533, 0.3163),
  ('whiteboard', 'width', 0.677533, 0.866776, 0.3803),
  ('whiteboard', 'width', 0.866776, 0.938032, 0.4274),
  ('whiteboard', 'width', 0.938032, 1.07874, 0.8429),
  ('whiteboard', 'width', 1.07874, 1.11839, 2.333),
  ('whiteboard', 'width', 1.11839, 1.17696, 2.276),
  ('whiteboard', 'width', 1.17696, 1.2009, 3.052),
  ('whiteboard', 'width', 1.2009, 1.26081, 2.272),
  ('whiteboard', 'width', 1.26081, 1.36167, 1.485),
  ('whiteboard', 'width', 1.36167, 1.45163, 0.483),
  ('whiteboard', 'width', 1.45163, 1.87857, 0.2428),
  ('whiteboard', 'width', 1.87857, 2.4311, 0.0904),
  ('whiteboard', 'width', 2.4311, 12, 0.01179);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_max', -0.5, 1.22137, 0.005739),
  ('whiteboard', 'z_max', 1.22137, 1.39545, 0.1196),
  ('whiteboard', 'z_max', 1.39545, 1.56953, 0.07849),
  ('whiteboard', 'z_max', 1.56953, 1.74361, 0.3842),
  ('whiteboard', 'z_max', 1.74361, 1.82128, 0.4452),
  ('whiteboard', 'z_max', 1.82128, 1.90171, 1.127),
  ('whiteboard', 'z_max', 1.90171, 1.91769, 1.07),
  ('whiteboard', 'z_max', 1.91769, 1.94868, 2.595),
  ('whiteboard', 'z_max', 1.94868, 2.02319, 1.651),
  ('whiteboard', 'z_max', 2.02319, 2.06329, 2.18),
  ('whiteboard', 'z_max', 2.06329, 2.09177, 2.694),
  ('whiteboard', 'z_max', 2.09177, 2.14753, 2.513),
  ('whiteboard', 'z_max', 2.14753, 2.20337, 1.802),
  ('whiteboard', 'z_max', 2.20337, 2.26585, 0.6093),
  ('whiteboard', 'z_max', 2.26585, 2.43993, 0.2619),
  ('whiteboard', 'z_max', 2.43993, 2.61401, 0.1321),
  ('whiteboard', 'z_max', 2.61401, 2.78809, 0.1149),
  ('whiteboard', 'z_max', 2.78809, 4, 0.009473);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_min', -0.5, -0.050976, 0.02031),
  ('whiteboard', 'z_min', -0.050976, -0.043909, 0.3509),
  ('whiteboard', 'z_min', -0.043909, 0.0849523, 0.3783),
  ('whiteboard', 'z_min', 0.0849523, 0.22088, 0.0572),
  ('whiteboard', 'z_min', 0.22088, 0.356809, 0.1195),
  ('whiteboard', 'z_min', 0.356809, 0.492737, 0.1044),
  ('whiteboard', 'z_min', 0.492737, 0.628665, 0.195),
  ('whiteboard', 'z_min', 0.628665, 0.701877, 0.6156),
  ('whiteboard', 'z_min', 0.701877, 0.763755, 1.355),
  ('whiteboard', 'z_min', 0.763755, 0.804898, 2.429),
  ('whiteboard', 'z_min', 0.804898, 0.845572, 3.45),
  ('whiteboard', 'z_min', 0.845572, 0.853248, 5.562),
  ('whiteboard', 'z_min', 0.853248, 0.886117, 3.913),
  ('whiteboard', 'z_min', 0.886117, 0.900522, 3.135),
  ('whiteboard', 'z_min', 0.900522, 0.912907, 3.326),
  ('whiteboard', 'z_min', 0.912907, 0.954373, 2.246),
  ('whiteboard', 'z_min', 0.954373, 1.03645, 0.8452),
  ('whiteboard', 'z_min', 1.03645, 1.16133, 0.4874),
  ('whiteboard', 'z_min', 1.16133, 1.17238, 0.3856),
  ('whiteboard', 'z_min', 1.17238, 4, 0.007244);

-- shelf: 242 examples
UPDATE object_class SET prior = 0.05053 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.435, 0.7475)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.9792, 0.4334)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5537, 0.3158)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3588, 0.1762)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4882, 0.353)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_joined', 0.2765, 0.238)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.971, 0.4822)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.04352, 0.5017)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.7046, 0.1216)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.2026, 0.5124)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.219, 0.3583)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 55.31, 42.65)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.026, 0.3243)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.309, 0.6181)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5823, 0.5875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'area_m2', 0.002, 0.0218682, 0.003715),
  ('shelf', 'area_m2', 0.0218682, 0.0330504, 0.03527),
  ('shelf', 'area_m2', 0.0330504, 0.0499505, 0.06293),
  ('shelf', 'area_m2', 0.0499505, 0.0754924, 0.06942),
  ('shelf', 'area_m2', 0.0754924, 0.0969088, 0.1088),
  ('shelf', 'area_m2', 0.0969088, 0.114095, 0.2099),
  ('shelf', 'area_m2', 0.114095, 0.148669, 0.3128),
  ('shelf', 'area_m2', 0.148669, 0.172437, 0.3372),
  ('shelf', 'area_m2', 0.172437, 0.197972, 0.4842),
  ('shelf', 'area_m2', 0.197972, 0.243507, 0.5625),
  ('shelf', 'area_m2', 0.243507, 0.260611, 0.7166),
  ('shelf', 'area_m2', 0.260611, 0.289124, 0.5102),
  ('shelf', 'area_m2', 0.289124, 0.343504, 0.6564),
  ('shelf', 'area_m2', 0.343504, 0.393873, 0.5861),
  ('shelf', 'area_m2', 0.393873, 0.424489, 0.3683),
  ('shelf', 'area_m2', 0.424489, 0.554487, 0.4025),
  ('shelf', 'area_m2', 0.554487, 0.595278, 0.356),
  ('shelf', 'area_m2', 0.595278, 0.899669, 0.1925),
  ('shelf', 'area_m2', 0.899669, 100, 0.002011);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'aspect', 1, 1.02692, 0.1048),
  ('shelf', 'aspect', 1.02692, 1.25966, 0.2803),
  ('shelf', 'aspect', 1.25966, 1.44852, 0.3552),
  ('shelf', 'aspect', 1.44852, 1.54515, 0.3317),
  ('shelf', 'aspect', 1.54515, 1.89535, 0.4304),
  ('shelf', 'aspect', 1.89535, 2.19612, 0.7936),
  ('shelf', 'aspect', 2.19612, 2.32491, 0.7257),
  ('shelf', 'aspect', 2.32491, 2.56513, 0.6918),
  ('shelf', 'aspect', 2.56513, 2.85183, 0.6805),
  ('shelf', 'aspect', 2.85183, 2.91447, 1.69),
  ('shelf', 'aspect', 2.91447, 3.25258, 1.074),
  ('shelf', 'aspect', 3.25258, 3.49817, 0.764),
  ('shelf', 'aspect', 3.49817, 3.78406, 0.6604),
  ('shelf', 'aspect', 3.78406, 4.291, 0.5419),
  ('shelf', 'aspect', 4.291, 4.76073, 0.4164),
  ('shelf', 'aspect', 4.76073, 5.26351, 0.486),
  ('shelf', 'aspect', 5.26351, 6.45644, 0.269),
  ('shelf', 'aspect', 6.45644, 100, 0.001974);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'behind', 0, 0.0975141, 2.172),
  ('shelf', 'behind', 0.0975141, 0.143758, 0.1507),
  ('shelf', 'behind', 0.143758, 0.195028, 0.1361),
  ('shelf', 'behind', 0.195028, 0.292542, 0.138),
  ('shelf', 'behind', 0.292542, 0.390056, 0.1928),
  ('shelf', 'behind', 0.390056, 0.487571, 0.2819),
  ('shelf', 'behind', 0.487571, 0.585085, 0.4805),
  ('shelf', 'behind', 0.585085, 0.592543, 1.117),
  ('shelf', 'behind', 0.592543, 0.682468, 1.292),
  ('shelf', 'behind', 0.682468, 0.735333, 2.048),
  ('shelf', 'behind', 0.735333, 0.766489, 3.442),
  ('shelf', 'behind', 0.766489, 0.780113, 5.072),
  ('shelf', 'behind', 0.780113, 0.787265, 4.473),
  ('shelf', 'behind', 0.787265, 0.822054, 3.21),
  ('shelf', 'behind', 0.822054, 0.877627, 1.829),
  ('shelf', 'behind', 0.877627, 1, 0.1075);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'edge_free', 0, 0.0961316, 1.154),
  ('shelf', 'edge_free', 0.0961316, 0.111111, 0.6007),
  ('shelf', 'edge_free', 0.111111, 0.222222, 0.8413),
  ('shelf', 'edge_free', 0.222222, 0.235601, 0.6584),
  ('shelf', 'edge_free', 0.235601, 0.333333, 1.034),
  ('shelf', 'edge_free', 0.333333, 0.339184, 1.28),
  ('shelf', 'edge_free', 0.339184, 0.392073, 2.196),
  ('shelf', 'edge_free', 0.392073, 0.42224, 3.849),
  ('shelf', 'edge_free', 0.42224, 0.444444, 4.377),
  ('shelf', 'edge_free', 0.444444, 0.473685, 3.838),
  ('shelf', 'edge_free', 0.473685, 0.491978, 6.211),
  ('shelf', 'edge_free', 0.491978, 0.555556, 1.202),
  ('shelf', 'edge_free', 0.555556, 0.666667, 0.1615),
  ('shelf', 'edge_free', 0.666667, 0.777778, 0.02993),
  ('shelf', 'edge_free', 0.777778, 0.888889, 0.004931),
  ('shelf', 'edge_free', 0.888889, 1, 0.1411);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'edge_free_top', 0, 0.0780848, 2.678),
  ('shelf', 'edge_free_top', 0.0780848, 0.111111, 0.4793),
  ('shelf', 'edge_free_top', 0.111111, 0.222222, 0.6375),
  ('shelf', 'edge_free_top', 0.222222, 0.269099, 0.6697),
  ('shelf', 'edge_free_top', 0.269099, 0.333333, 0.617),
  ('shelf', 'edge_free_top', 0.333333, 0.444444, 0.6142),
  ('shelf', 'edge_free_top', 0.444444, 0.46559, 0.655),
  ('shelf', 'edge_free_top', 0.46559, 0.555556, 1.071),
  ('shelf', 'edge_free_top', 0.555556, 0.666667, 0.928),
  ('shelf', 'edge_free_top', 0.666667, 0.703202, 0.672),
  ('shelf', 'edge_free_top', 0.703202, 0.777778, 0.7253),
  ('shelf', 'edge_free_top', 0.777778, 0.833005, 0.8964),
  ('shelf', 'edge_free_top', 0.833005, 0.888889, 0.6671),
  ('shelf', 'edge_free_top', 0.888889, 0.952187, 1.19),
  ('shelf', 'edge_free_top', 0.952187, 1, 2.319);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'edge_joined', 0, 0.00903057, 12.42),
  ('shelf', 'edge_joined', 0.00903057, 0.0610232, 2.127),
  ('shelf', 'edge_joined', 0.0610232, 0.0982224, 2.408),
  ('shelf', 'edge_joined', 0.0982224, 0.17112, 1.705),
  ('shelf', 'edge_joined', 0.17112, 0.196445, 1.77),
  ('shelf', 'edge_joined', 0.196445, 0.274564, 0.9193),
  ('shelf', 'edge_joined', 0.274564, 0.294667, 1.196),
  ('shelf', 'edge_joined', 0.294667, 0.374917, 1.077),
  ('shelf', 'edge_joined', 0.374917, 0.392889, 0.906),
  ('shelf', 'edge_joined', 0.392889, 0.482424, 1.099),
  ('shelf', 'edge_joined', 0.482424, 0.491112, 0.9119),
  ('shelf', 'edge_joined', 0.491112, 0.589334, 0.8739),
  ('shelf', 'edge_joined', 0.589334, 0.617135, 0.9143),
  ('shelf', 'edge_joined', 0.617135, 0.687557, 0.6143),
  ('shelf', 'edge_joined', 0.687557, 0.785779, 0.3258),
  ('shelf', 'edge_joined', 0.785779, 0.884001, 0.1842),
  ('shelf', 'edge_joined', 0.884001, 1, 0.07775);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'height', -0.5, 0.0019367, 0.002143),
  ('shelf', 'height', 0.0019367, 0.0526313, 0.1135),
  ('shelf', 'height', 0.0526313, 0.245365, 0.3626),
  ('shelf', 'height', 0.245365, 0.418012, 0.2088),
  ('shelf', 'height', 0.418012, 0.488794, 0.7147),
  ('shelf', 'height', 0.488794, 0.602174, 0.593),
  ('shelf', 'height', 0.602174, 0.732223, 0.5417),
  ('shelf', 'height', 0.732223, 0.756745, 1.04),
  ('shelf', 'height', 0.756745, 0.927583, 0.7191),
  ('shelf', 'height', 0.927583, 0.975652, 1.119),
  ('shelf', 'height', 0.975652, 1.02799, 0.9415),
  ('shelf', 'height', 1.02799, 1.13108, 1.128),
  ('shelf', 'height', 1.13108, 1.21908, 0.645),
  ('shelf', 'height', 1.21908, 1.30765, 0.5791),
  ('shelf', 'height', 1.30765, 1.46251, 0.5548),
  ('shelf', 'height', 1.46251, 1.57478, 0.2848),
  ('shelf', 'height', 1.57478, 1.70594, 0.2028),
  ('shelf', 'height', 1.70594, 1.94937, 0.1602),
  ('shelf', 'height', 1.94937, 2.15759, 0.1341),
  ('shelf', 'height', 2.15759, 2.1928, 0.08964),
  ('shelf', 'height', 2.1928, 4, 0.004765);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'length', 0.03, 0.210708, 0.005761),
  ('shelf', 'length', 0.210708, 0.275609, 0.06408),
  ('shelf', 'length', 0.275609, 0.360501, 0.06635),
  ('shelf', 'length', 0.360501, 0.471541, 0.1017),
  ('shelf', 'length', 0.471541, 0.52986, 0.2933),
  ('shelf', 'length', 0.52986, 0.616784, 0.3927),
  ('shelf', 'length', 0.616784, 0.682106, 0.5929),
  ('shelf', 'length', 0.682106, 0.806762, 0.6219),
  ('shelf', 'length', 0.806762, 0.94442, 0.7634),
  ('shelf', 'length', 0.94442, 1.05526, 0.8437),
  ('shelf', 'length', 1.05526, 1.08147, 0.4686),
  ('shelf', 'length', 1.08147, 1.21794, 0.9582),
  ('shelf', 'length', 1.21794, 1.38029, 0.7334),
  ('shelf', 'length', 1.38029, 1.42175, 0.6511),
  ('shelf', 'length', 1.42175, 1.74462, 0.5062),
  ('shelf', 'length', 1.74462, 1.80545, 0.2632),
  ('shelf', 'length', 1.80545, 2.24937, 0.4257),
  ('shelf', 'length', 2.24937, 2.36155, 0.1825),
  ('shelf', 'length', 2.36155, 30, 0.00124);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'rectangularity', 0, 0.415666, 0.01675),
  ('shelf', 'rectangularity', 0.415666, 0.474642, 0.3678),
  ('shelf', 'rectangularity', 0.474642, 0.533617, 0.8337),
  ('shelf', 'rectangularity', 0.533617, 0.553137, 2.158),
  ('shelf', 'rectangularity', 0.553137, 0.592593, 2.509),
  ('shelf', 'rectangularity', 0.592593, 0.645175, 2.09),
  ('shelf', 'rectangularity', 0.645175, 0.651568, 2.869),
  ('shelf', 'rectangularity', 0.651568, 0.686313, 2.651),
  ('shelf', 'rectangularity', 0.686313, 0.710544, 2.159),
  ('shelf', 'rectangularity', 0.710544, 0.729276, 3.502),
  ('shelf', 'rectangularity', 0.729276, 0.769518, 2.737),
  ('shelf', 'rectangularity', 0.769518, 0.809877, 2.748),
  ('shelf', 'rectangularity', 0.809877, 0.828494, 2.428),
  ('shelf', 'rectangularity', 0.828494, 0.862449, 1.941),
  ('shelf', 'rectangularity', 0.862449, 0.88747, 2.391),
  ('shelf', 'rectangularity', 0.88747, 0.946445, 0.7135),
  ('shelf', 'rectangularity', 0.946445, 1, 0.163);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_length', 0.01, 0.186586, 0.003179),
  ('shelf', 'spread_length', 0.186586, 0.245024, 0.05849),
  ('shelf', 'spread_length', 0.245024, 0.321765, 0.0799),
  ('shelf', 'spread_length', 0.321765, 0.420782, 0.2318),
  ('shelf', 'spread_length', 0.420782, 0.554878, 0.3085),
  ('shelf', 'spread_length', 0.554878, 0.576123, 0.5941),
  ('shelf', 'spread_length', 0.576123, 0.661341, 0.8415),
  ('shelf', 'spread_length', 0.661341, 0.728663, 0.9414),
  ('shelf', 'spread_length', 0.728663, 0.772865, 0.471),
  ('shelf', 'spread_length', 0.772865, 0.941073, 0.5234),
  ('shelf', 'spread_length', 0.941073, 1.07367, 0.9009),
  ('shelf', 'spread_length', 1.07367, 1.22588, 0.7837),
  ('shelf', 'spread_length', 1.22588, 1.25657, 0.7089),
  ('shelf', 'spread_length', 1.25657, 1.48229, 0.5544),
  ('shelf', 'spread_length', 1.48229, 1.65012, 0.2799),
  ('shelf', 'spread_length', 1.65012, 2.12369, 0.2936),
  ('shelf', 'spread_length', 2.12369, 2.16693, 0.1169),
  ('shelf', 'spread_length', 2.16693, 40, 0.002316);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_width', 0.003, 0.113504, 0.002611),
  ('shelf', 'spread_width', 0.113504, 0.139052, 0.1479),
  ('shelf', 'spread_width', 0.139052, 0.170351, 0.2324),
  ('shelf', 'spread_width', 0.170351, 0.178723, 0.4491),
  ('shelf', 'spread_width', 0.178723, 0.208695, 0.4854),
  ('shelf', 'spread_width', 0.208695, 0.23291, 0.3874),
  ('shelf', 'spread_width', 0.23291, 0.255669, 0.5458),
  ('shelf', 'spread_width', 0.255669, 0.278585, 0.8329),
  ('shelf', 'spread_width', 0.278585, 0.299589, 1.372),
  ('shelf', 'spread_width', 0.299589, 0.313216, 1.157),
  ('shelf', 'spread_width', 0.313216, 0.327802, 1.425),
  ('shelf', 'spread_width', 0.327802, 0.346324, 1.71),
  ('shelf', 'spread_width', 0.346324, 0.381856, 1.215),
  ('shelf', 'spread_width', 0.381856, 0.433834, 0.8876),
  ('shelf', 'spread_width', 0.433834, 0.470085, 0.6415),
  ('shelf', 'spread_width', 0.470085, 0.575894, 0.1674),
  ('shelf', 'spread_width', 0.575894, 0.705519, 0.07209),
  ('shelf', 'spread_width', 0.705519, 20, 0.00284);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'tilt_deg', 0, 1.10114, 0.09616),
  ('shelf', 'tilt_deg', 1.10114, 2.03406, 0.1134),
  ('shelf', 'tilt_deg', 2.03406, 3.76504, 0.0617),
  ('shelf', 'tilt_deg', 3.76504, 10, 0.008665),
  ('shelf', 'tilt_deg', 10, 20, 0.0008833),
  ('shelf', 'tilt_deg', 20, 30, 0.0005205),
  ('shelf', 'tilt_deg', 30, 40, 0.0004916),
  ('shelf', 'tilt_deg', 40, 50, 0.000534),
  ('shelf', 'tilt_deg', 50, 60, 0.0005743),
  ('shelf', 'tilt_deg', 60, 70, 0.0006513),
  ('shelf', 'tilt_deg', 70, 80, 0.000882),
  ('shelf', 'tilt_deg', 80, 88.6006, 0.006342),
  ('shelf', 'tilt_deg', 88.6006, 89.7105, 0.1724),
  ('shelf', 'tilt_deg', 89.7105, 90, 1.161);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'width', 0.01, 0.128601, 0.003464),
  ('shelf', 'width', 0.128601, 0.159647, 0.1117),
  ('shelf', 'width', 0.159647, 0.198188, 0.1493),
  ('shelf', 'width', 0.198188, 0.246034, 0.2012),
  ('shelf', 'width', 0.246034, 0.305431, 0.5066),
  ('shelf', 'width', 0.305431, 0.335476, 1.292),
  ('shelf', 'width', 0.335476, 0.358684, 1.597),
  ('shelf', 'width', 0.358684, 0.379167, 1.449),
  ('shelf', 'width', 0.379167, 0.386779, 1.614),
  ('shelf', 'width', 0.386779, 0.411929, 1.726),
  ('shelf', 'width', 0.411929, 0.436039, 1.833),
  ('shelf', 'width', 0.436039, 0.470704, 1.214),
  ('shelf', 'width', 0.470704, 0.480636, 1.024),
  ('shelf', 'width', 0.480636, 0.584339, 0.3791),
  ('shelf', 'width', 0.584339, 0.725408, 0.07705),
  ('shelf', 'width', 0.725408, 0.900533, 0.06403),
  ('shelf', 'width', 0.900533, 12, 0.003569);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_max', -0.5, -0.00709011, 0.001595),
  ('shelf', 'z_max', -0.00709011, 0.0704397, 0.2583),
  ('shelf', 'z_max', 0.0704397, 0.250063, 0.2814),
  ('shelf', 'z_max', 0.250063, 0.447081, 0.2111),
  ('shelf', 'z_max', 0.447081, 0.507215, 0.6925),
  ('shelf', 'z_max', 0.507215, 0.764368, 0.282),
  ('shelf', 'z_max', 0.764368, 1.02152, 0.2794),
  ('shelf', 'z_max', 1.02152, 1.09676, 0.4391),
  ('shelf', 'z_max', 1.09676, 1.27867, 0.5043),
  ('shelf', 'z_max', 1.27867, 1.33436, 0.4834),
  ('shelf', 'z_max', 1.33436, 1.50043, 0.6095),
  ('shelf', 'z_max', 1.50043, 1.53583, 0.4259),
  ('shelf', 'z_max', 1.53583, 1.68338, 0.7594),
  ('shelf', 'z_max', 1.68338, 1.79298, 0.6708),
  ('shelf', 'z_max', 1.79298, 1.86254, 0.4747),
  ('shelf', 'z_max', 1.86254, 2.05013, 0.5001),
  ('shelf', 'z_max', 2.05013, 2.30728, 0.4339),
  ('shelf', 'z_max', 2.30728, 4, 0.00535);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_min', -0.5, -0.0765221, 0.01421),
  ('shelf', 'z_min', -0.0765221, -0.0425353, 0.1011),
  ('shelf', 'z_min', -0.0425353, -0.00696458, 2.931),
  ('shelf', 'z_min', -0.00696458, 0.0102506, 5.203),
  ('shelf', 'z_min', 0.0102506, 0.0805516, 1.699),
  ('shelf', 'z_min', 0.0805516, 0.174051, 0.4699),
  ('shelf', 'z_min', 0.174051, 0.41581, 0.3169),
  ('shelf', 'z_min', 0.41581, 0.543419, 0.8626),
  ('shelf', 'z_min', 0.543419, 0.675196, 0.3505),
  ('shelf', 'z_min', 0.675196, 0.77749, 0.6762),
  ('shelf', 'z_min', 0.77749, 0.925768, 0.6194),
  ('shelf', 'z_min', 0.925768, 0.953272, 0.4988),
  ('shelf', 'z_min', 0.953272, 1.17634, 0.4187),
  ('shelf', 'z_min', 1.17634, 1.41567, 0.1013),
  ('shelf', 'z_min', 1.41567, 1.67749, 0.1115),
  ('shelf', 'z_min', 1.67749, 1.92806, 0.1452),
  ('shelf', 'z_min', 1.92806, 2.15413, 0.1326),
  ('shelf', 'z_min', 2.15413, 2.17863, 0.0902),
  ('shelf', 'z_min', 2.17863, 4, 0.005683);

-- cabinet: 319 examples
UPDATE object_class SET prior = 0.06619 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.8551, 0.9606)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6145, 0.4202)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.5466, 0.2181)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.4502, 0.2668)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.7481, 0.3178)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_joined', 0.2549, 0.3014)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7518, 0.3472)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.04913, 0.5218)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7281, 0.1315)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1189, 0.5167)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7819, 0.4968)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 75.32, 32.65)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.5681, 0.4706)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.199, 0.5694)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.222, 0.3335)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'area_m2', 0.002, 0.0271185, 0.003368),
  ('cabinet', 'area_m2', 0.0271185, 0.0464993, 0.02063),
  ('cabinet', 'area_m2', 0.0464993, 0.0797309, 0.07276),
  ('cabinet', 'area_m2', 0.0797309, 0.121986, 0.122),
  ('cabinet', 'area_m2', 0.121986, 0.136712, 0.1303),
  ('cabinet', 'area_m2', 0.136712, 0.215394, 0.2128),
  ('cabinet', 'area_m2', 0.215394, 0.234417, 0.2199),
  ('cabinet', 'area_m2', 0.234417, 0.311992, 0.317),
  ('cabinet', 'area_m2', 0.311992, 0.376248, 0.6008),
  ('cabinet', 'area_m2', 0.376248, 0.401947, 0.4525),
  ('cabinet', 'area_m2', 0.401947, 0.520455, 0.3292),
  ('cabinet', 'area_m2', 0.520455, 0.684977, 0.3871),
  ('cabinet', 'area_m2', 0.684977, 0.952971, 0.3288),
  ('cabinet', 'area_m2', 0.952971, 1.18176, 0.3734),
  ('cabinet', 'area_m2', 1.18176, 1.35699, 0.2658),
  ('cabinet', 'area_m2', 1.35699, 2.02634, 0.1915),
  ('cabinet', 'area_m2', 2.02634, 3.4745, 0.04621),
  ('cabinet', 'area_m2', 3.4745, 100, 0.002075);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'aspect', 1, 1.12083, 0.9679),
  ('cabinet', 'aspect', 1.12083, 1.23061, 0.8048),
  ('cabinet', 'aspect', 1.23061, 1.26771, 1.108),
  ('cabinet', 'aspect', 1.26771, 1.44582, 0.8634),
  ('cabinet', 'aspect', 1.44582, 1.5144, 1.038),
  ('cabinet', 'aspect', 1.5144, 1.59679, 1.226),
  ('cabinet', 'aspect', 1.59679, 1.86363, 0.612),
  ('cabinet', 'aspect', 1.86363, 1.89612, 0.7889),
  ('cabinet', 'aspect', 1.89612, 2.19901, 0.7501),
  ('cabinet', 'aspect', 2.19901, 2.29341, 0.8898),
  ('cabinet', 'aspect', 2.29341, 2.58562, 0.6793),
  ('cabinet', 'aspect', 2.58562, 2.82229, 0.5757),
  ('cabinet', 'aspect', 2.82229, 3.16232, 0.4616),
  ('cabinet', 'aspect', 3.16232, 3.47313, 0.3634),
  ('cabinet', 'aspect', 3.47313, 4.27407, 0.2058),
  ('cabinet', 'aspect', 4.27407, 5.25971, 0.08592),
  ('cabinet', 'aspect', 5.25971, 6.47265, 0.04756),
  ('cabinet', 'aspect', 6.47265, 100, 0.003392);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'behind', 0, 0.0967578, 0.5844),
  ('cabinet', 'behind', 0.0967578, 0.193516, 0.4121),
  ('cabinet', 'behind', 0.193516, 0.219538, 0.4296),
  ('cabinet', 'behind', 0.219538, 0.290273, 0.5624),
  ('cabinet', 'behind', 0.290273, 0.387031, 0.542),
  ('cabinet', 'behind', 0.387031, 0.417794, 0.9114),
  ('cabinet', 'behind', 0.417794, 0.483789, 1.352),
  ('cabinet', 'behind', 0.483789, 0.5, 1.257),
  ('cabinet', 'behind', 0.5, 0.551585, 2.192),
  ('cabinet', 'behind', 0.551585, 0.580547, 1.584),
  ('cabinet', 'behind', 0.580547, 0.628027, 1.303),
  ('cabinet', 'behind', 0.628027, 0.677305, 2.075),
  ('cabinet', 'behind', 0.677305, 0.684615, 1.32),
  ('cabinet', 'behind', 0.684615, 0.737173, 2.115),
  ('cabinet', 'behind', 0.737173, 0.774062, 2.695),
  ('cabinet', 'behind', 0.774062, 0.87082, 1.16),
  ('cabinet', 'behind', 0.87082, 1, 0.05444);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'edge_free', 0, 0.0812827, 1.297),
  ('cabinet', 'edge_free', 0.0812827, 0.111111, 1.358),
  ('cabinet', 'edge_free', 0.111111, 0.200804, 0.8658),
  ('cabinet', 'edge_free', 0.200804, 0.222222, 1.105),
  ('cabinet', 'edge_free', 0.222222, 0.30428, 1.008),
  ('cabinet', 'edge_free', 0.30428, 0.333333, 1.112),
  ('cabinet', 'edge_free', 0.333333, 0.44176, 0.796),
  ('cabinet', 'edge_free', 0.44176, 0.493009, 2.092),
  ('cabinet', 'edge_free', 0.493009, 0.555556, 1.507),
  ('cabinet', 'edge_free', 0.555556, 0.58109, 0.7431),
  ('cabinet', 'edge_free', 0.58109, 0.666667, 0.9386),
  ('cabinet', 'edge_free', 0.666667, 0.690724, 1.071),
  ('cabinet', 'edge_free', 0.690724, 0.777778, 1.162),
  ('cabinet', 'edge_free', 0.777778, 0.788874, 1.158),
  ('cabinet', 'edge_free', 0.788874, 0.888889, 0.7054),
  ('cabinet', 'edge_free', 0.888889, 1, 0.3633);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'edge_free_top', 0, 0.111111, 0.8129),
  ('cabinet', 'edge_free_top', 0.111111, 0.191109, 0.2267),
  ('cabinet', 'edge_free_top', 0.191109, 0.222222, 0.207),
  ('cabinet', 'edge_free_top', 0.222222, 0.333333, 0.2795),
  ('cabinet', 'edge_free_top', 0.333333, 0.444444, 0.3743),
  ('cabinet', 'edge_free_top', 0.444444, 0.538009, 0.3813),
  ('cabinet', 'edge_free_top', 0.538009, 0.555556, 0.3583),
  ('cabinet', 'edge_free_top', 0.555556, 0.666667, 0.5179),
  ('cabinet', 'edge_free_top', 0.666667, 0.744717, 0.7517),
  ('cabinet', 'edge_free_top', 0.744717, 0.777778, 0.799),
  ('cabinet', 'edge_free_top', 0.777778, 0.849747, 1.115),
  ('cabinet', 'edge_free_top', 0.849747, 0.888889, 1.618),
  ('cabinet', 'edge_free_top', 0.888889, 0.926522, 1.576),
  ('cabinet', 'edge_free_top', 0.926522, 1, 5.784);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'edge_joined', 0, 0.0110558, 19.3),
  ('cabinet', 'edge_joined', 0.0110558, 0.0314963, 5.219),
  ('cabinet', 'edge_joined', 0.0314963, 0.0758404, 2.519),
  ('cabinet', 'edge_joined', 0.0758404, 0.109626, 2.534),
  ('cabinet', 'edge_joined', 0.109626, 0.152866, 0.7337),
  ('cabinet', 'edge_joined', 0.152866, 0.219251, 0.8524),
  ('cabinet', 'edge_joined', 0.219251, 0.30539, 0.6667),
  ('cabinet', 'edge_joined', 0.30539, 0.328877, 0.7096),
  ('cabinet', 'edge_joined', 0.328877, 0.438502, 0.7024),
  ('cabinet', 'edge_joined', 0.438502, 0.474338, 0.5299),
  ('cabinet', 'edge_joined', 0.474338, 0.548128, 0.4169),
  ('cabinet', 'edge_joined', 0.548128, 0.657753, 0.4067),
  ('cabinet', 'edge_joined', 0.657753, 0.766772, 0.3662),
  ('cabinet', 'edge_joined', 0.766772, 0.877005, 0.4088),
  ('cabinet', 'edge_joined', 0.877005, 0.98663, 0.5324),
  ('cabinet', 'edge_joined', 0.98663, 1, 0.4156);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'height', -0.5, 0.149464, 0.01206),
  ('cabinet', 'height', 0.149464, 0.300921, 0.498),
  ('cabinet', 'height', 0.300921, 0.315252, 1.948),
  ('cabinet', 'height', 0.315252, 0.452379, 0.8194),
  ('cabinet', 'height', 0.452379, 0.555137, 1.065),
  ('cabinet', 'height', 0.555137, 0.599905, 2.441),
  ('cabinet', 'height', 0.599905, 0.755294, 0.6021),
  ('cabinet', 'height', 0.755294, 0.789062, 0.4599),
  ('cabinet', 'height', 0.789062, 0.906752, 0.6094),
  ('cabinet', 'height', 0.906752, 0.946557, 1.181),
  ('cabinet', 'height', 0.946557, 1.05696, 0.9667),
  ('cabinet', 'height', 1.05696, 1.20967, 0.6349),
  ('cabinet', 'height', 1.20967, 1.23501, 0.6439),
  ('cabinet', 'height', 1.23501, 1.36112, 0.5048),
  ('cabinet', 'height', 1.36112, 1.49807, 0.2717),
  ('cabinet', 'height', 1.49807, 1.51258, 0.1385),
  ('cabinet', 'height', 1.51258, 4, 0.00283);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'length', 0.03, 0.219413, 0.003794),
  ('cabinet', 'length', 0.219413, 0.290372, 0.03514),
  ('cabinet', 'length', 0.290372, 0.384279, 0.05503),
  ('cabinet', 'length', 0.384279, 0.508556, 0.1697),
  ('cabinet', 'length', 0.508556, 0.554573, 0.3549),
  ('cabinet', 'length', 0.554573, 0.673024, 0.4705),
  ('cabinet', 'length', 0.673024, 0.704834, 0.4145),
  ('cabinet', 'length', 0.704834, 0.80792, 0.8273),
  ('cabinet', 'length', 0.80792, 0.890681, 0.4545),
  ('cabinet', 'length', 0.890681, 0.982405, 0.695),
  ('cabinet', 'length', 0.982405, 1.153, 0.6819),
  ('cabinet', 'length', 1.153, 1.17873, 0.4861),
  ('cabinet', 'length', 1.17873, 1.43528, 0.5402),
  ('cabinet', 'length', 1.43528, 1.55993, 0.2758),
  ('cabinet', 'length', 1.55993, 1.75051, 0.7238),
  ('cabinet', 'length', 1.75051, 1.95631, 1.017),
  ('cabinet', 'length', 1.95631, 2.06442, 0.576),
  ('cabinet', 'length', 2.06442, 2.73205, 0.2476),
  ('cabinet', 'length', 2.73205, 30, 0.003019);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'rectangularity', 0, 0.381539, 0.03265),
  ('cabinet', 'rectangularity', 0.381539, 0.447607, 0.3039),
  ('cabinet', 'rectangularity', 0.447607, 0.513674, 0.5871),
  ('cabinet', 'rectangularity', 0.513674, 0.55251, 0.9467),
  ('cabinet', 'rectangularity', 0.55251, 0.579742, 1.033),
  ('cabinet', 'rectangularity', 0.579742, 0.626396, 1.856),
  ('cabinet', 'rectangularity', 0.626396, 0.64581, 1.945),
  ('cabinet', 'rectangularity', 0.64581, 0.669255, 2.841),
  ('cabinet', 'rectangularity', 0.669255, 0.711878, 2.549),
  ('cabinet', 'rectangularity', 0.711878, 0.722253, 1.336),
  ('cabinet', 'rectangularity', 0.722253, 0.766007, 2.377),
  ('cabinet', 'rectangularity', 0.766007, 0.777946, 2.555),
  ('cabinet', 'rectangularity', 0.777946, 0.812507, 2.54),
  ('cabinet', 'rectangularity', 0.812507, 0.834929, 4.471),
  ('cabinet', 'rectangularity', 0.834929, 0.844014, 3.386),
  ('cabinet', 'rectangularity', 0.844014, 0.88083, 2.163),
  ('cabinet', 'rectangularity', 0.88083, 0.910082, 2.33),
  ('cabinet', 'rectangularity', 0.910082, 0.97615, 0.6534),
  ('cabinet', 'rectangularity', 0.97615, 1, 0.2536);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_length', 0.01, 0.199843, 0.002446),
  ('cabinet', 'spread_length', 0.199843, 0.260696, 0.03398),
  ('cabinet', 'spread_length', 0.260696, 0.340078, 0.03997),
  ('cabinet', 'spread_length', 0.340078, 0.443633, 0.2461),
  ('cabinet', 'spread_length', 0.443633, 0.476844, 0.2928),
  ('cabinet', 'spread_length', 0.476844, 0.57872, 0.4744),
  ('cabinet', 'spread_length', 0.57872, 0.594574, 0.7262),
  ('cabinet', 'spread_length', 0.594574, 0.678316, 0.8286),
  ('cabinet', 'spread_length', 0.678316, 0.754942, 0.7678),
  ('cabinet', 'spread_length', 0.754942, 0.812016, 0.4405),
  ('cabinet', 'spread_length', 0.812016, 0.967559, 0.6134),
  ('cabinet', 'spread_length', 0.967559, 0.984824, 0.5354),
  ('cabinet', 'spread_length', 0.984824, 1.18569, 0.5515),
  ('cabinet', 'spread_length', 1.18569, 1.28471, 0.5796),
  ('cabinet', 'spread_length', 1.28471, 1.50132, 0.4173),
  ('cabinet', 'spread_length', 1.50132, 1.6759, 0.7654),
  ('cabinet', 'spread_length', 1.6759, 1.72144, 0.7968),
  ('cabinet', 'spread_length', 1.72144, 2.18622, 0.4441),
  ('cabinet', 'spread_length', 2.18622, 40, 0.003083);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_width', 0.003, 0.12589, 0.002333),
  ('cabinet', 'spread_width', 0.12589, 0.165318, 0.1022),
  ('cabinet', 'spread_width', 0.165318, 0.217095, 0.1869),
  ('cabinet', 'spread_width', 0.217095, 0.231258, 0.3674),
  ('cabinet', 'spread_width', 0.231258, 0.285089, 0.2687),
  ('cabinet', 'spread_width', 0.285089, 0.334043, 0.3738),
  ('cabinet', 'spread_width', 0.334043, 0.374377, 0.6967),
  ('cabinet', 'spread_width', 0.374377, 0.390781, 0.5825),
  ('cabinet', 'spread_width', 0.390781, 0.446094, 0.836),
  ('cabinet', 'spread_width', 0.446094, 0.491631, 0.892),
  ('cabinet', 'spread_width', 0.491631, 0.512292, 0.8413),
  ('cabinet', 'spread_width', 0.512292, 0.564287, 1.077),
  ('cabinet', 'spread_width', 0.564287, 0.645608, 0.7952),
  ('cabinet', 'spread_width', 0.645608, 0.798819, 0.5267),
  ('cabinet', 'spread_width', 0.798819, 0.847811, 0.5463),
  ('cabinet', 'spread_width', 0.847811, 1.11334, 0.1773),
  ('cabinet', 'spread_width', 1.11334, 1.46204, 0.08665),
  ('cabinet', 'spread_width', 1.46204, 20, 0.003694);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'tilt_deg', 0, 0.698347, 0.1496),
  ('cabinet', 'tilt_deg', 0.698347, 10, 0.005409),
  ('cabinet', 'tilt_deg', 10, 20, 0.0001015),
  ('cabinet', 'tilt_deg', 20, 30, 0.0001629),
  ('cabinet', 'tilt_deg', 30, 40, 0.0002547),
  ('cabinet', 'tilt_deg', 40, 50, 0.0003723),
  ('cabinet', 'tilt_deg', 50, 60, 0.0005042),
  ('cabinet', 'tilt_deg', 60, 70, 0.000632),
  ('cabinet', 'tilt_deg', 70, 80, 0.001036),
  ('cabinet', 'tilt_deg', 80, 88.0279, 0.007062),
  ('cabinet', 'tilt_deg', 88.0279, 89.6001, 0.1086),
  ('cabinet', 'tilt_deg', 89.6001, 89.8711, 1.206),
  ('cabinet', 'tilt_deg', 89.8711, 90, 2.018);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'width', 0.01, 0.153811, 0.002784),
  ('cabinet', 'width', 0.153811, 0.200571, 0.09816),
  ('cabinet', 'width', 0.200571, 0.261547, 0.1869),
  ('cabinet', 'width', 0.261547, 0.308314, 0.1934),
  ('cabinet', 'width', 0.308314, 0.341059, 0.2295),
  ('cabinet', 'width', 0.341059, 0.418577, 0.3873),
  ('cabinet', 'width', 0.418577, 0.444744, 0.3814),
  ('cabinet', 'width', 0.444744, 0.504725, 0.7062),
  ('cabinet', 'width', 0.504725, 0.570061, 0.9755),
  ('cabinet', 'width', 0.570061, 0.579949, 1.278),
  ('cabinet', 'width', 0.579949, 0.610451, 1.667),
  ('cabinet', 'width', 0.610451, 0.666505, 1.243),
  ('cabinet', 'width', 0.666505, 0.756259, 0.6384),
  ('cabinet', 'width', 0.756259, 0.807276, 0.5097),
  ('cabinet', 'width', 0.807276, 0.97665, 0.5604),
  ('cabinet', 'width', 0.97665, 1.28597, 0.295),
  ('cabinet', 'width', 1.28597, 1.67692, 0.09323),
  ('cabinet', 'width', 1.67692, 12, 0.004054);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_max', -0.5, 0.310724, 0.01166),
  ('cabinet', 'z_max', 0.310724, 0.556491, 0.08531),
  ('cabinet', 'z_max', 0.556491, 0.580991, 2.976),
  ('cabinet', 'z_max', 0.580991, 0.677946, 1.27),
  ('cabinet', 'z_max', 0.677946, 0.760447, 1.207),
  ('cabinet', 'z_max', 0.760447, 0.802258, 0.5678),
  ('cabinet', 'z_max', 0.802258, 0.946413, 0.5958),
  ('cabinet', 'z_max', 0.946413, 1.04803, 0.7281),
  ('cabinet', 'z_max', 1.04803, 1.0909, 0.8715),
  ('cabinet', 'z_max', 1.0909, 1.29379, 0.4151),
  ('cabinet', 'z_max', 1.29379, 1.53956, 0.1449),
  ('cabinet', 'z_max', 1.53956, 1.78533, 0.4276),
  ('cabinet', 'z_max', 1.78533, 1.9937, 0.5607),
  ('cabinet', 'z_max', 1.9937, 2.03109, 0.2978),
  ('cabinet', 'z_max', 2.03109, 2.27686, 0.3192),
  ('cabinet', 'z_max', 2.27686, 2.52263, 0.05615),
  ('cabinet', 'z_max', 2.52263, 4, 0.005278);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_min', -0.5, -0.0657669, 0.02413),
  ('cabinet', 'z_min', -0.0657669, -0.0206232, 3.903),
  ('cabinet', 'z_min', -0.0206232, -0.0147793, 14.4),
  ('cabinet', 'z_min', -0.0147793, -0.00835503, 15.11),
  ('cabinet', 'z_min', -0.00835503, 0.00564663, 10.5),
  ('cabinet', 'z_min', 0.00564663, 0.0700307, 1.079),
  ('cabinet', 'z_min', 0.0700307, 0.205828, 0.3513),
  ('cabinet', 'z_min', 0.205828, 0.28817, 0.3656),
  ('cabinet', 'z_min', 0.28817, 0.341626, 0.4379),
  ('cabinet', 'z_min', 0.341626, 0.477423, 0.4745),
  ('cabinet', 'z_min', 0.477423, 0.554188, 0.3659),
  ('cabinet', 'z_min', 0.554188, 0.613221, 1.472),
  ('cabinet', 'z_min', 0.613221, 0.708383, 0.2918),
  ('cabinet', 'z_min', 0.708383, 0.749019, 0.3052),
  ('cabinet', 'z_min', 0.749019, 0.884816, 0.2563),
  ('cabinet', 'z_min', 0.884816, 1.02061, 0.2063),
  ('cabinet', 'z_min', 1.02061, 1.15641, 0.1395),
  ('cabinet', 'z_min', 1.15641, 4, 0.004608);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.114 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.5 WHERE name = 'aspect';
UPDATE feature SET weight = 0.303 WHERE name = 'behind';
UPDATE feature SET weight = 0.27 WHERE name = 'edge_free';
UPDATE feature SET weight = 0.264 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.367 WHERE name = 'edge_joined';
UPDATE feature SET weight = 0.25 WHERE name = 'height';
UPDATE feature SET weight = 0.0487 WHERE name = 'length';
UPDATE feature SET weight = 0.433 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.234 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.135 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.5 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.233 WHERE name = 'width';
UPDATE feature SET weight = 0.5 WHERE name = 'z_max';
UPDATE feature SET weight = 0.378 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.39 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0367 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0295 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.0772 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0377 WHERE name = 'table';
UPDATE object_class SET prior = 0.0644 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.112 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.0116 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0585 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0172 WHERE name = 'door';
UPDATE object_class SET prior = 0.015 WHERE name = 'window';
UPDATE object_class SET prior = 0.017 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0779 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.0549 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 3.03 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.195 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 3.66 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.51 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 1.92 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.52 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.491 WHERE name = 'wall_square';
UPDATE class_constraint SET weight = 0.691 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 2.8 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 2.08 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.74 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.625 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 2.29 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.833 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 2.69 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 5.12 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.12 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.446 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.968 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 1.21 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.652 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.02 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 1.14 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 1.77 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.46 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.63 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.443 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.13 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.31 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.77 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 1425 planes of 24 paper-like rooms, seeds from 8001.
UPDATE setting SET value = '0.560' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.401' WHERE key = 'probability_offset';
