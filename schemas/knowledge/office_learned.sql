-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise where nothing else is said, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 13026 planes of 180 paper-like rooms, seeds from 1; 66 varied rooms, seeds from 301; 100 depth-camera frames, seeds from 101.
-- Priors and weights: 96 paper-like rooms, seeds from 41; 36 at 2 cm, seeds from 31; 33 varied rooms, seeds from 401; 50 depth-camera frames, seeds from 201.

-- unknown: 5475 examples
UPDATE object_class SET prior = 0.423 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.804, 1.161)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6901, 0.5625)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4939, 0.2857)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free', 0.4357, 0.3085)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_free_top', 0.5859, 0.4042)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'edge_joined', 0.3084, 0.3337)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 1.038, 0.7007)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.3821, 0.6755)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.7226, 0.1381)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.5372, 0.707)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.276, 0.6061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 60.76, 40.12)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.075, 0.5919)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.298, 0.9236)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.772, 0.755)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0222491, 0.003447),
  ('unknown', 'area_m2', 0.0222491, 0.0492282, 0.1094),
  ('unknown', 'area_m2', 0.0492282, 0.0524474, 0.269),
  ('unknown', 'area_m2', 0.0524474, 0.0704608, 0.3749),
  ('unknown', 'area_m2', 0.0704608, 0.0914045, 0.4248),
  ('unknown', 'area_m2', 0.0914045, 0.108922, 0.4345),
  ('unknown', 'area_m2', 0.108922, 0.119451, 0.3761),
  ('unknown', 'area_m2', 0.119451, 0.165711, 0.3399),
  ('unknown', 'area_m2', 0.165711, 0.233491, 0.3257),
  ('unknown', 'area_m2', 0.233491, 0.241, 0.3889),
  ('unknown', 'area_m2', 0.241, 0.309362, 0.3862),
  ('unknown', 'area_m2', 0.309362, 0.51113, 0.2248),
  ('unknown', 'area_m2', 0.51113, 0.533235, 0.1611),
  ('unknown', 'area_m2', 0.533235, 1.17983, 0.08365),
  ('unknown', 'area_m2', 1.17983, 2.61049, 0.01042),
  ('unknown', 'area_m2', 2.61049, 5.77596, 0.006805),
  ('unknown', 'area_m2', 5.77596, 12.7799, 0.007691),
  ('unknown', 'area_m2', 12.7799, 28.2767, 0.01119),
  ('unknown', 'area_m2', 28.2767, 100, 0.007258);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.1115, 1.051),
  ('unknown', 'aspect', 1.1115, 1.24469, 0.9791),
  ('unknown', 'aspect', 1.24469, 1.27201, 1.016),
  ('unknown', 'aspect', 1.27201, 1.39349, 0.9847),
  ('unknown', 'aspect', 1.39349, 1.57748, 0.8957),
  ('unknown', 'aspect', 1.57748, 1.61801, 0.8463),
  ('unknown', 'aspect', 1.61801, 1.83032, 0.7238),
  ('unknown', 'aspect', 1.83032, 2.05813, 0.6221),
  ('unknown', 'aspect', 2.05813, 2.1948, 0.5869),
  ('unknown', 'aspect', 2.1948, 2.61796, 0.4138),
  ('unknown', 'aspect', 2.61796, 2.99224, 0.2886),
  ('unknown', 'aspect', 2.99224, 3.33007, 0.2152),
  ('unknown', 'aspect', 3.33007, 4.23588, 0.2217),
  ('unknown', 'aspect', 4.23588, 5.00286, 0.208),
  ('unknown', 'aspect', 5.00286, 5.38809, 0.305),
  ('unknown', 'aspect', 5.38809, 6.8537, 0.2409),
  ('unknown', 'aspect', 6.8537, 8.71798, 0.08835),
  ('unknown', 'aspect', 8.71798, 100, 0.003862);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.0965925, 1.825),
  ('unknown', 'behind', 0.0965925, 0.193185, 0.3539),
  ('unknown', 'behind', 0.193185, 0.222222, 0.411),
  ('unknown', 'behind', 0.222222, 0.289777, 0.5244),
  ('unknown', 'behind', 0.289777, 0.38637, 0.5992),
  ('unknown', 'behind', 0.38637, 0.408272, 0.8353),
  ('unknown', 'behind', 0.408272, 0.482962, 0.8183),
  ('unknown', 'behind', 0.482962, 0.530866, 1.026),
  ('unknown', 'behind', 0.530866, 0.579555, 1.054),
  ('unknown', 'behind', 0.579555, 0.619735, 1.491),
  ('unknown', 'behind', 0.619735, 0.676147, 1.45),
  ('unknown', 'behind', 0.676147, 0.692308, 1.828),
  ('unknown', 'behind', 0.692308, 0.750623, 1.9),
  ('unknown', 'behind', 0.750623, 0.77274, 2.229),
  ('unknown', 'behind', 0.77274, 0.801833, 2.123),
  ('unknown', 'behind', 0.801833, 0.869332, 1.564),
  ('unknown', 'behind', 0.869332, 1, 0.04396);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free', 0, 0.111111, 1.932),
  ('unknown', 'edge_free', 0.111111, 0.122174, 0.6808),
  ('unknown', 'edge_free', 0.122174, 0.222222, 0.6889),
  ('unknown', 'edge_free', 0.222222, 0.282134, 0.7036),
  ('unknown', 'edge_free', 0.282134, 0.333333, 0.8545),
  ('unknown', 'edge_free', 0.333333, 0.395846, 1.085),
  ('unknown', 'edge_free', 0.395846, 0.444444, 1.253),
  ('unknown', 'edge_free', 0.444444, 0.480841, 1.369),
  ('unknown', 'edge_free', 0.480841, 0.555556, 1.334),
  ('unknown', 'edge_free', 0.555556, 0.567681, 0.9827),
  ('unknown', 'edge_free', 0.567681, 0.666667, 0.9181),
  ('unknown', 'edge_free', 0.666667, 0.689225, 0.8781),
  ('unknown', 'edge_free', 0.689225, 0.777778, 0.7398),
  ('unknown', 'edge_free', 0.777778, 0.876217, 0.4738),
  ('unknown', 'edge_free', 0.876217, 0.888889, 0.3545),
  ('unknown', 'edge_free', 0.888889, 1, 0.9496);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_free_top';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_free_top', 0, 0.0373107, 5.959),
  ('unknown', 'edge_free_top', 0.0373107, 0.111111, 0.3917),
  ('unknown', 'edge_free_top', 0.111111, 0.222222, 0.3419),
  ('unknown', 'edge_free_top', 0.222222, 0.333333, 0.3218),
  ('unknown', 'edge_free_top', 0.333333, 0.356653, 0.3475),
  ('unknown', 'edge_free_top', 0.356653, 0.444444, 0.3879),
  ('unknown', 'edge_free_top', 0.444444, 0.555556, 0.4065),
  ('unknown', 'edge_free_top', 0.555556, 0.631811, 0.4265),
  ('unknown', 'edge_free_top', 0.631811, 0.666667, 0.5531),
  ('unknown', 'edge_free_top', 0.666667, 0.777778, 0.6341),
  ('unknown', 'edge_free_top', 0.777778, 0.805946, 0.7706),
  ('unknown', 'edge_free_top', 0.805946, 0.888889, 0.7709),
  ('unknown', 'edge_free_top', 0.888889, 0.935123, 1.017),
  ('unknown', 'edge_free_top', 0.935123, 1, 5.129);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'edge_joined';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'edge_joined', 0, 0.00780123, 28.41),
  ('unknown', 'edge_joined', 0.00780123, 0.0424276, 3.198),
  ('unknown', 'edge_joined', 0.0424276, 0.111111, 1.506),
  ('unknown', 'edge_joined', 0.111111, 0.11819, 1.121),
  ('unknown', 'edge_joined', 0.11819, 0.222222, 0.9562),
  ('unknown', 'edge_joined', 0.222222, 0.235455, 0.8792),
  ('unknown', 'edge_joined', 0.235455, 0.333333, 0.7753),
  ('unknown', 'edge_joined', 0.333333, 0.38764, 0.6504),
  ('unknown', 'edge_joined', 0.38764, 0.444444, 0.578),
  ('unknown', 'edge_joined', 0.444444, 0.555556, 0.496),
  ('unknown', 'edge_joined', 0.555556, 0.609058, 0.4364),
  ('unknown', 'edge_joined', 0.609058, 0.666667, 0.4711),
  ('unknown', 'edge_joined', 0.666667, 0.777778, 0.3748),
  ('unknown', 'edge_joined', 0.777778, 0.872088, 0.4523),
  ('unknown', 'edge_joined', 0.872088, 0.888889, 0.4706),
  ('unknown', 'edge_joined', 0.888889, 1, 0.9298);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.0703981, 0.008095),
  ('unknown', 'height', 0.0703981, 0.229138, 0.6577),
  ('unknown', 'height', 0.229138, 0.393461, 0.4656),
  ('unknown', 'height', 0.393461, 0.432178, 0.841),
  ('unknown', 'height', 0.432178, 0.649986, 0.5272),
  ('unknown', 'height', 0.649986, 0.716525, 0.422),
  ('unknown', 'height', 0.716525, 0.828954, 0.7556),
  ('unknown', 'height', 0.828954, 0.943511, 0.949),
  ('unknown', 'height', 0.943511, 1.03959, 0.5433),
  ('unknown', 'height', 1.03959, 1.20778, 0.3532),
  ('unknown', 'height', 1.20778, 1.36265, 0.2964),
  ('unknown', 'height', 1.36265, 1.54, 0.3703),
  ('unknown', 'height', 1.54, 1.68571, 0.3327),
  ('unknown', 'height', 1.68571, 2.00878, 0.152),
  ('unknown', 'height', 2.00878, 2.08577, 0.1654),
  ('unknown', 'height', 2.08577, 2.33184, 0.1996),
  ('unknown', 'height', 2.33184, 2.6549, 0.1015),
  ('unknown', 'height', 2.6549, 2.97797, 0.06413),
  ('unknown', 'height', 2.97797, 4, 0.008977);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.186686, 0.00427),
  ('unknown', 'length', 0.186686, 0.2828, 0.1383),
  ('unknown', 'length', 0.2828, 0.320432, 0.3705),
  ('unknown', 'length', 0.320432, 0.395806, 0.5197),
  ('unknown', 'length', 0.395806, 0.428396, 0.6105),
  ('unknown', 'length', 0.428396, 0.474735, 0.6232),
  ('unknown', 'length', 0.474735, 0.572131, 0.5922),
  ('unknown', 'length', 0.572131, 0.648951, 0.5374),
  ('unknown', 'length', 0.648951, 0.707848, 0.5061),
  ('unknown', 'length', 0.707848, 0.8853, 0.4928),
  ('unknown', 'length', 0.8853, 0.983057, 0.4931),
  ('unknown', 'length', 0.983057, 1.15368, 0.3745),
  ('unknown', 'length', 1.15368, 1.44855, 0.4864),
  ('unknown', 'length', 1.44855, 1.48917, 0.414),
  ('unknown', 'length', 1.48917, 2.25586, 0.154),
  ('unknown', 'length', 2.25586, 3.41726, 0.02136),
  ('unknown', 'length', 3.41726, 5.1766, 0.01925),
  ('unknown', 'length', 5.1766, 7.84171, 0.02328),
  ('unknown', 'length', 7.84171, 30, 0.007259);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.336469, 0.02827),
  ('unknown', 'rectangularity', 0.336469, 0.406206, 0.2036),
  ('unknown', 'rectangularity', 0.406206, 0.475944, 0.4224),
  ('unknown', 'rectangularity', 0.475944, 0.539364, 0.9062),
  ('unknown', 'rectangularity', 0.539364, 0.545682, 1.241),
  ('unknown', 'rectangularity', 0.545682, 0.615419, 1.482),
  ('unknown', 'rectangularity', 0.615419, 0.673926, 1.91),
  ('unknown', 'rectangularity', 0.673926, 0.685157, 2.363),
  ('unknown', 'rectangularity', 0.685157, 0.719297, 2.471),
  ('unknown', 'rectangularity', 0.719297, 0.754895, 2.565),
  ('unknown', 'rectangularity', 0.754895, 0.762477, 2.571),
  ('unknown', 'rectangularity', 0.762477, 0.799443, 3.011),
  ('unknown', 'rectangularity', 0.799443, 0.824633, 2.796),
  ('unknown', 'rectangularity', 0.824633, 0.838559, 2.953),
  ('unknown', 'rectangularity', 0.838559, 0.884268, 2.435),
  ('unknown', 'rectangularity', 0.884268, 0.89437, 1.942),
  ('unknown', 'rectangularity', 0.89437, 0.964108, 1.224),
  ('unknown', 'rectangularity', 0.964108, 1, 0.1559);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.165788, 0.002527),
  ('unknown', 'spread_length', 0.165788, 0.253561, 0.1676),
  ('unknown', 'spread_length', 0.253561, 0.271925, 0.4723),
  ('unknown', 'spread_length', 0.271925, 0.322484, 0.6524),
  ('unknown', 'spread_length', 0.322484, 0.379637, 0.6782),
  ('unknown', 'spread_length', 0.379637, 0.387803, 0.4927),
  ('unknown', 'spread_length', 0.387803, 0.465435, 0.5511),
  ('unknown', 'spread_length', 0.465435, 0.593117, 0.4053),
  ('unknown', 'spread_length', 0.593117, 0.612592, 0.421),
  ('unknown', 'spread_length', 0.612592, 0.7767, 0.4646),
  ('unknown', 'spread_length', 0.7767, 0.907129, 0.4514),
  ('unknown', 'spread_length', 0.907129, 1.013, 0.3761),
  ('unknown', 'spread_length', 1.013, 1.30258, 0.4358),
  ('unknown', 'spread_length', 1.30258, 1.38739, 0.4136),
  ('unknown', 'spread_length', 1.38739, 2.12191, 0.1234),
  ('unknown', 'spread_length', 2.12191, 3.24531, 0.01549),
  ('unknown', 'spread_length', 3.24531, 4.96346, 0.01744),
  ('unknown', 'spread_length', 4.96346, 7.59126, 0.02441),
  ('unknown', 'spread_length', 7.59126, 40, 0.005745);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.111696, 0.0009791),
  ('unknown', 'spread_width', 0.111696, 0.158143, 0.3122),
  ('unknown', 'spread_width', 0.158143, 0.168525, 0.6407),
  ('unknown', 'spread_width', 0.168525, 0.187046, 0.6803),
  ('unknown', 'spread_width', 0.187046, 0.208511, 1.019),
  ('unknown', 'spread_width', 0.208511, 0.22615, 1.315),
  ('unknown', 'spread_width', 0.22615, 0.254269, 0.8543),
  ('unknown', 'spread_width', 0.254269, 0.259431, 0.7161),
  ('unknown', 'spread_width', 0.259431, 0.303906, 0.6955),
  ('unknown', 'spread_width', 0.303906, 0.380886, 0.4942),
  ('unknown', 'spread_width', 0.380886, 0.555041, 0.2962),
  ('unknown', 'spread_width', 0.555041, 0.578827, 0.2402),
  ('unknown', 'spread_width', 0.578827, 0.873327, 0.1574),
  ('unknown', 'spread_width', 0.873327, 1.31766, 0.02196),
  ('unknown', 'spread_width', 1.31766, 1.98807, 0.01284),
  ('unknown', 'spread_width', 1.98807, 2.99958, 0.01289),
  ('unknown', 'spread_width', 2.99958, 4.52573, 0.01798),
  ('unknown', 'spread_width', 4.52573, 20, 0.006172);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 0.732412, 0.1471),
  ('unknown', 'tilt_deg', 0.732412, 2.31997, 0.0718),
  ('unknown', 'tilt_deg', 2.31997, 10, 0.01047),
  ('unknown', 'tilt_deg', 10, 20, 0.00138),
  ('unknown', 'tilt_deg', 20, 30, 0.000247),
  ('unknown', 'tilt_deg', 30, 40, 0.0001269),
  ('unknown', 'tilt_deg', 40, 50, 0.0001185),
  ('unknown', 'tilt_deg', 50, 60, 0.0001352),
  ('unknown', 'tilt_deg', 60, 70, 0.0005076),
  ('unknown', 'tilt_deg', 70, 72.9186, 0.002249),
  ('unknown', 'tilt_deg', 72.9186, 80, 0.004553),
  ('unknown', 'tilt_deg', 80, 87.9711, 0.01011),
  ('unknown', 'tilt_deg', 87.9711, 89.3159, 0.08861),
  ('unknown', 'tilt_deg', 89.3159, 89.7365, 0.4085),
  ('unknown', 'tilt_deg', 89.7365, 90, 0.9956);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.132736, 0.002731),
  ('unknown', 'width', 0.132736, 0.190491, 0.2886),
  ('unknown', 'width', 0.190491, 0.197411, 0.5023),
  ('unknown', 'width', 0.197411, 0.223208, 0.7498),
  ('unknown', 'width', 0.223208, 0.249659, 0.9938),
  ('unknown', 'width', 0.249659, 0.289416, 0.7655),
  ('unknown', 'width', 0.289416, 0.293599, 0.7556),
  ('unknown', 'width', 0.293599, 0.33008, 0.8365),
  ('unknown', 'width', 0.33008, 0.380291, 0.7866),
  ('unknown', 'width', 0.380291, 0.436655, 0.5524),
  ('unknown', 'width', 0.436655, 0.467859, 0.5043),
  ('unknown', 'width', 0.467859, 0.649414, 0.3102),
  ('unknown', 'width', 0.649414, 0.67257, 0.2725),
  ('unknown', 'width', 0.67257, 0.965839, 0.1998),
  ('unknown', 'width', 0.965839, 1.43644, 0.02961),
  ('unknown', 'width', 1.43644, 2.13635, 0.01394),
  ('unknown', 'width', 2.13635, 3.17728, 0.01448),
  ('unknown', 'width', 3.17728, 4.7254, 0.01761),
  ('unknown', 'width', 4.7254, 12, 0.01);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0778169, 0.009443),
  ('unknown', 'z_max', 0.0778169, 0.430681, 0.3135),
  ('unknown', 'z_max', 0.430681, 0.513615, 0.5068),
  ('unknown', 'z_max', 0.513615, 0.69069, 0.3658),
  ('unknown', 'z_max', 0.69069, 0.791678, 1.08),
  ('unknown', 'z_max', 0.791678, 0.925782, 0.8338),
  ('unknown', 'z_max', 0.925782, 0.949413, 0.7469),
  ('unknown', 'z_max', 0.949413, 1.09102, 0.6666),
  ('unknown', 'z_max', 1.09102, 1.38521, 0.3518),
  ('unknown', 'z_max', 1.38521, 1.42732, 0.1789),
  ('unknown', 'z_max', 1.42732, 1.82101, 0.1733),
  ('unknown', 'z_max', 1.82101, 1.99813, 0.243),
  ('unknown', 'z_max', 1.99813, 2.25681, 0.4011),
  ('unknown', 'z_max', 2.25681, 2.2818, 0.3228),
  ('unknown', 'z_max', 2.2818, 2.69261, 0.1497),
  ('unknown', 'z_max', 2.69261, 3.1284, 0.04964),
  ('unknown', 'z_max', 3.1284, 3.5642, 0.01154),
  ('unknown', 'z_max', 3.5642, 4, 0.05043);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.128916, 0.05524),
  ('unknown', 'z_min', -0.128916, -0.0133033, 0.8084),
  ('unknown', 'z_min', -0.0133033, 0.0807478, 1.163),
  ('unknown', 'z_min', 0.0807478, 0.242169, 0.4897),
  ('unknown', 'z_min', 0.242169, 0.36244, 0.257),
  ('unknown', 'z_min', 0.36244, 0.613253, 0.3064),
  ('unknown', 'z_min', 0.613253, 0.678059, 0.5494),
  ('unknown', 'z_min', 0.678059, 0.764656, 1.249),
  ('unknown', 'z_min', 0.764656, 0.905202, 0.8039),
  ('unknown', 'z_min', 0.905202, 0.984338, 0.5432),
  ('unknown', 'z_min', 0.984338, 1.19725, 0.3241),
  ('unknown', 'z_min', 1.19725, 1.35542, 0.3124),
  ('unknown', 'z_min', 1.35542, 1.72651, 0.1243),
  ('unknown', 'z_min', 1.72651, 1.92937, 0.07097),
  ('unknown', 'z_min', 1.92937, 2.09759, 0.09641),
  ('unknown', 'z_min', 2.09759, 2.46868, 0.1527),
  ('unknown', 'z_min', 2.46868, 2.83976, 0.07538),
  ('unknown', 'z_min', 2.83976, 4, 0.008911);
DELETE FROM class_kind WHERE class = 'unknown';
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 1, 0.04658, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 1, 'area_m2', -1.962, 0.3292),
  ('unknown', 1, 'aspect', 0.3412, 0.2353),
  ('unknown', 1, 'behind', 0.6554, 0.1657),
  ('unknown', 1, 'edge_free', 0.3718, 0.1922),
  ('unknown', 1, 'edge_free_top', 0.5657, 0.3284),
  ('unknown', 1, 'edge_joined', 0.243, 0.2559),
  ('unknown', 1, 'height', 0.231, 0.06188),
  ('unknown', 1, 'length', -0.5196, 0.1743),
  ('unknown', 1, 'rectangularity', 0.5841, 0.1624),
  ('unknown', 1, 'spread_length', -0.6949, 0.188),
  ('unknown', 1, 'spread_width', -1.18, 0.2617),
  ('unknown', 1, 'tilt_deg', 89.25, 1.841),
  ('unknown', 1, 'width', -0.8607, 0.1935),
  ('unknown', 1, 'z_max', 0.4893, 0.1106),
  ('unknown', 1, 'z_min', -0.007655, 0.03729);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 2, 0.04343, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 2, 'area_m2', -1.323, 0.1526),
  ('unknown', 2, 'aspect', 1.748, 0.1367),
  ('unknown', 2, 'behind', 0.2808, 0.2772),
  ('unknown', 2, 'edge_free', 0.89, 0.1329),
  ('unknown', 2, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 2, 'edge_joined', 0.1046, 0.1285),
  ('unknown', 2, 'height', 2.508, 0.2833),
  ('unknown', 2, 'length', 0.2852, 0.1219),
  ('unknown', 2, 'rectangularity', 0.8665, 0.04023),
  ('unknown', 2, 'spread_length', 0.2428, 0.1311),
  ('unknown', 2, 'spread_width', -1.549, 0.05315),
  ('unknown', 2, 'tilt_deg', 1.297, 1.823),
  ('unknown', 2, 'width', -1.463, 0.08845),
  ('unknown', 2, 'z_max', 2.511, 0.2849),
  ('unknown', 2, 'z_min', 2.504, 0.2839);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 3, 0.03892, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 3, 'area_m2', -2.498, 0.2094),
  ('unknown', 3, 'aspect', 0.225, 0.1556),
  ('unknown', 3, 'behind', 0.6852, 0.1426),
  ('unknown', 3, 'edge_free', 0.5058, 0.1163),
  ('unknown', 3, 'edge_free_top', 0.825, 0.1582),
  ('unknown', 3, 'edge_joined', 0.1516, 0.1624),
  ('unknown', 3, 'height', 0.1829, 0.03939),
  ('unknown', 3, 'length', -0.8739, 0.1463),
  ('unknown', 3, 'rectangularity', 0.6018, 0.1107),
  ('unknown', 3, 'spread_length', -1.061, 0.1284),
  ('unknown', 3, 'spread_width', -1.564, 0.1796),
  ('unknown', 3, 'tilt_deg', 88.83, 2.337),
  ('unknown', 3, 'width', -1.099, 0.1303),
  ('unknown', 3, 'z_max', 0.3561, 0.05873),
  ('unknown', 3, 'z_min', -0.01067, 0.03567);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 4, 0.03777, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 4, 'area_m2', -2.65, 0.2562),
  ('unknown', 4, 'aspect', 0.5454, 0.3277),
  ('unknown', 4, 'behind', 0.6091, 0.1876),
  ('unknown', 4, 'edge_free', 0.5805, 0.09377),
  ('unknown', 4, 'edge_free_top', 0.9668, 0.06093),
  ('unknown', 4, 'edge_joined', 0.06929, 0.1125),
  ('unknown', 4, 'height', 0.8613, 0.05686),
  ('unknown', 4, 'length', -0.8656, 0.2649),
  ('unknown', 4, 'rectangularity', 0.6965, 0.1039),
  ('unknown', 4, 'spread_length', -1.213, 0.1695),
  ('unknown', 4, 'spread_width', -1.588, 0.1725),
  ('unknown', 4, 'tilt_deg', 83.22, 7.183),
  ('unknown', 4, 'width', -1.411, 0.1807),
  ('unknown', 4, 'z_max', 0.9812, 0.07322),
  ('unknown', 4, 'z_min', 0.7182, 0.05997);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 5, 0.03666, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 5, 'area_m2', -2.206, 0.4469),
  ('unknown', 5, 'aspect', 0.6104, 0.445),
  ('unknown', 5, 'behind', 0.4172, 0.3435),
  ('unknown', 5, 'edge_free', 0.243, 0.2148),
  ('unknown', 5, 'edge_free_top', 0.3527, 0.3312),
  ('unknown', 5, 'edge_joined', 0.5192, 0.3067),
  ('unknown', 5, 'height', 1.586, 0.2423),
  ('unknown', 5, 'length', -0.6096, 0.314),
  ('unknown', 5, 'rectangularity', 0.6955, 0.1097),
  ('unknown', 5, 'spread_length', -0.8137, 0.3163),
  ('unknown', 5, 'spread_width', -1.467, 0.3135),
  ('unknown', 5, 'tilt_deg', 88.97, 2.216),
  ('unknown', 5, 'width', -1.22, 0.3165),
  ('unknown', 5, 'z_max', 1.857, 0.2382),
  ('unknown', 5, 'z_min', 1.334, 0.277);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 6, 0.03479, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 6, 'area_m2', -1.332, 0.2893),
  ('unknown', 6, 'aspect', 1.752, 0.2544),
  ('unknown', 6, 'behind', 0.5707, 0.2398),
  ('unknown', 6, 'edge_free', 0.263, 0.205),
  ('unknown', 6, 'edge_free_top', 0.01235, 0.03936),
  ('unknown', 6, 'edge_joined', 0.3662, 0.3315),
  ('unknown', 6, 'height', 1.504, 0.09736),
  ('unknown', 6, 'length', 0.3297, 0.1337),
  ('unknown', 6, 'rectangularity', 0.7898, 0.0582),
  ('unknown', 6, 'spread_length', 0.1656, 0.1594),
  ('unknown', 6, 'spread_width', -1.54, 0.267),
  ('unknown', 6, 'tilt_deg', 89.8, 1.78),
  ('unknown', 6, 'width', -1.422, 0.2318),
  ('unknown', 6, 'z_max', 2.234, 0.1668),
  ('unknown', 6, 'z_min', 0.831, 0.1073);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 7, 0.03399, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 7, 'area_m2', -2.845, 0.309),
  ('unknown', 7, 'aspect', 0.5541, 0.2763),
  ('unknown', 7, 'behind', 0.5568, 0.2486),
  ('unknown', 7, 'edge_free', 0.3805, 0.232),
  ('unknown', 7, 'edge_free_top', 0.5586, 0.3993),
  ('unknown', 7, 'edge_joined', 0.1846, 0.2215),
  ('unknown', 7, 'height', 0.1953, 0.07661),
  ('unknown', 7, 'length', -0.9466, 0.262),
  ('unknown', 7, 'rectangularity', 0.6862, 0.1317),
  ('unknown', 7, 'spread_length', -1.127, 0.2445),
  ('unknown', 7, 'spread_width', -1.731, 0.2024),
  ('unknown', 7, 'tilt_deg', 87.91, 3.783),
  ('unknown', 7, 'width', -1.501, 0.1868),
  ('unknown', 7, 'z_max', 0.3487, 0.108),
  ('unknown', 7, 'z_min', 0.02731, 0.07383);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 8, 0.03111, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 8, 'area_m2', -2.657, 0.3094),
  ('unknown', 8, 'aspect', 0.3204, 0.2237),
  ('unknown', 8, 'behind', 0.3478, 0.2671),
  ('unknown', 8, 'edge_free', 0.6093, 0.2255),
  ('unknown', 8, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 8, 'edge_joined', 0.3209, 0.1993),
  ('unknown', 8, 'height', 0.8833, 0.1083),
  ('unknown', 8, 'length', -1.05, 0.1744),
  ('unknown', 8, 'rectangularity', 0.7951, 0.09477),
  ('unknown', 8, 'spread_length', -1.161, 0.1361),
  ('unknown', 8, 'spread_width', -1.521, 0.2001),
  ('unknown', 8, 'tilt_deg', 2.22, 2.918),
  ('unknown', 8, 'width', -1.37, 0.2241),
  ('unknown', 8, 'z_max', 0.8904, 0.1146),
  ('unknown', 8, 'z_min', 0.8766, 0.1101);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 9, 0.03106, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 9, 'area_m2', -0.467, 0.3051),
  ('unknown', 9, 'aspect', 0.4572, 0.2354),
  ('unknown', 9, 'behind', 0.4889, 0.1126),
  ('unknown', 9, 'edge_free', 0.8789, 0.1266),
  ('unknown', 9, 'edge_free_top', 0.9917, 0.03),
  ('unknown', 9, 'edge_joined', 0.01919, 0.03314),
  ('unknown', 9, 'height', 0.4791, 0.05601),
  ('unknown', 9, 'length', 0.07986, 0.2279),
  ('unknown', 9, 'rectangularity', 0.8542, 0.1176),
  ('unknown', 9, 'spread_length', 0.01267, 0.2394),
  ('unknown', 9, 'spread_width', -0.4887, 0.1411),
  ('unknown', 9, 'tilt_deg', 89.69, 1.919),
  ('unknown', 9, 'width', -0.3773, 0.1205),
  ('unknown', 9, 'z_max', 0.7838, 0.0753),
  ('unknown', 9, 'z_min', 0.08351, 0.0649);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 10, 0.0295, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 10, 'area_m2', -0.9668, 0.3275),
  ('unknown', 10, 'aspect', 0.2743, 0.2031),
  ('unknown', 10, 'behind', 0.6082, 0.2106),
  ('unknown', 10, 'edge_free', 0.3754, 0.2092),
  ('unknown', 10, 'edge_free_top', 0.5218, 0.3381),
  ('unknown', 10, 'edge_joined', 0.3267, 0.2735),
  ('unknown', 10, 'height', 0.4085, 0.104),
  ('unknown', 10, 'length', -0.09004, 0.158),
  ('unknown', 10, 'rectangularity', 0.6193, 0.1411),
  ('unknown', 10, 'spread_length', -0.2532, 0.1592),
  ('unknown', 10, 'spread_width', -0.6761, 0.2221),
  ('unknown', 10, 'tilt_deg', 89.38, 2.085),
  ('unknown', 10, 'width', -0.3643, 0.1642),
  ('unknown', 10, 'z_max', 0.777, 0.1171),
  ('unknown', 10, 'z_min', 0.01285, 0.06912);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 11, 0.02932, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 11, 'area_m2', -1.171, 0.4026),
  ('unknown', 11, 'aspect', 0.3473, 0.2526),
  ('unknown', 11, 'behind', 0.006528, 0.03),
  ('unknown', 11, 'edge_free', 0.02871, 0.03842),
  ('unknown', 11, 'edge_free_top', 0.02958, 0.05045),
  ('unknown', 11, 'edge_joined', 0.9202, 0.1056),
  ('unknown', 11, 'height', 1.616, 0.1055),
  ('unknown', 11, 'length', -0.3057, 0.2065),
  ('unknown', 11, 'rectangularity', 0.8116, 0.0625),
  ('unknown', 11, 'spread_length', -0.4437, 0.2187),
  ('unknown', 11, 'spread_width', -0.8899, 0.282),
  ('unknown', 11, 'tilt_deg', 89.7, 1.943),
  ('unknown', 11, 'width', -0.6529, 0.26),
  ('unknown', 11, 'z_max', 1.961, 0.1717),
  ('unknown', 11, 'z_min', 1.306, 0.09051);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 12, 0.02808, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 12, 'area_m2', -1.817, 0.4144),
  ('unknown', 12, 'aspect', 1.192, 0.3651),
  ('unknown', 12, 'behind', 0.6804, 0.1939),
  ('unknown', 12, 'edge_free', 0.3559, 0.1704),
  ('unknown', 12, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 12, 'edge_joined', 0.4582, 0.2047),
  ('unknown', 12, 'height', 0.852, 0.2448),
  ('unknown', 12, 'length', -0.08363, 0.2147),
  ('unknown', 12, 'rectangularity', 0.6436, 0.1136),
  ('unknown', 12, 'spread_length', -0.1855, 0.2147),
  ('unknown', 12, 'spread_width', -1.528, 0.3314),
  ('unknown', 12, 'tilt_deg', 6.455, 5.977),
  ('unknown', 12, 'width', -1.275, 0.3393),
  ('unknown', 12, 'z_max', 0.8728, 0.2523),
  ('unknown', 12, 'z_min', 0.8371, 0.2433);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 13, 0.02769, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 13, 'area_m2', -2.348, 0.3995),
  ('unknown', 13, 'aspect', 0.4178, 0.269),
  ('unknown', 13, 'behind', 0.6102, 0.227),
  ('unknown', 13, 'edge_free', 0.6091, 0.2263),
  ('unknown', 13, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 13, 'edge_joined', 0.2028, 0.1487),
  ('unknown', 13, 'height', 0.3856, 0.1251),
  ('unknown', 13, 'length', -0.8337, 0.2059),
  ('unknown', 13, 'rectangularity', 0.7776, 0.1113),
  ('unknown', 13, 'spread_length', -0.9395, 0.2119),
  ('unknown', 13, 'spread_width', -1.413, 0.2619),
  ('unknown', 13, 'tilt_deg', 1.977, 3.063),
  ('unknown', 13, 'width', -1.252, 0.2661),
  ('unknown', 13, 'z_max', 0.3929, 0.13),
  ('unknown', 13, 'z_min', 0.3791, 0.1276);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 14, 0.02687, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 14, 'area_m2', -3.098, 0.322),
  ('unknown', 14, 'aspect', 0.4843, 0.3312),
  ('unknown', 14, 'behind', 0.4716, 0.2805),
  ('unknown', 14, 'edge_free', 0.6524, 0.19),
  ('unknown', 14, 'edge_free_top', 0.9895, 0.03159),
  ('unknown', 14, 'edge_joined', 0.01912, 0.03252),
  ('unknown', 14, 'height', 0.978, 0.2862),
  ('unknown', 14, 'length', -1.146, 0.2858),
  ('unknown', 14, 'rectangularity', 0.7379, 0.13),
  ('unknown', 14, 'spread_length', -1.32, 0.2465),
  ('unknown', 14, 'spread_width', -1.804, 0.1844),
  ('unknown', 14, 'tilt_deg', 88.39, 3.099),
  ('unknown', 14, 'width', -1.631, 0.2056),
  ('unknown', 14, 'z_max', 1.094, 0.297),
  ('unknown', 14, 'z_min', 0.8333, 0.295);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 15, 0.02682, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 15, 'area_m2', -1.046, 0.4426),
  ('unknown', 15, 'aspect', 1.201, 0.5233),
  ('unknown', 15, 'behind', 0.5262, 0.2851),
  ('unknown', 15, 'edge_free', 0.2708, 0.2106),
  ('unknown', 15, 'edge_free_top', 0.2978, 0.283),
  ('unknown', 15, 'edge_joined', 0.4896, 0.3148),
  ('unknown', 15, 'height', 1.076, 0.3519),
  ('unknown', 15, 'length', 0.2999, 0.3123),
  ('unknown', 15, 'rectangularity', 0.6623, 0.1517),
  ('unknown', 15, 'spread_length', 0.1437, 0.3513),
  ('unknown', 15, 'spread_width', -1.15, 0.4357),
  ('unknown', 15, 'tilt_deg', 88.89, 2.948),
  ('unknown', 15, 'width', -0.9012, 0.356),
  ('unknown', 15, 'z_max', 1.657, 0.5122),
  ('unknown', 15, 'z_min', 0.4405, 0.4281);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 16, 0.02614, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 16, 'area_m2', -3.3, 0.3879),
  ('unknown', 16, 'aspect', 0.5321, 0.3074),
  ('unknown', 16, 'behind', 0.438, 0.301),
  ('unknown', 16, 'edge_free', 0.4175, 0.2464),
  ('unknown', 16, 'edge_free_top', 0.4933, 0.3622),
  ('unknown', 16, 'edge_joined', 0.2717, 0.285),
  ('unknown', 16, 'height', 0.8193, 0.383),
  ('unknown', 16, 'length', -1.22, 0.3084),
  ('unknown', 16, 'rectangularity', 0.7315, 0.1158),
  ('unknown', 16, 'spread_length', -1.368, 0.2953),
  ('unknown', 16, 'spread_width', -1.939, 0.1833),
  ('unknown', 16, 'tilt_deg', 54.9, 36.21),
  ('unknown', 16, 'width', -1.752, 0.2244),
  ('unknown', 16, 'z_max', 0.9012, 0.4038),
  ('unknown', 16, 'z_min', 0.7336, 0.3826);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 17, 0.026, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 17, 'area_m2', -2.798, 0.1903),
  ('unknown', 17, 'aspect', 0.2728, 0.1524),
  ('unknown', 17, 'behind', 0.3822, 0.2036),
  ('unknown', 17, 'edge_free', 0.03657, 0.0671),
  ('unknown', 17, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 17, 'edge_joined', 0.8735, 0.1142),
  ('unknown', 17, 'height', 0.7478, 0.06574),
  ('unknown', 17, 'length', -1.157, 0.1306),
  ('unknown', 17, 'rectangularity', 0.8129, 0.06427),
  ('unknown', 17, 'spread_length', -1.273, 0.1318),
  ('unknown', 17, 'spread_width', -1.58, 0.09015),
  ('unknown', 17, 'tilt_deg', 1.259, 2.287),
  ('unknown', 17, 'width', -1.43, 0.1247),
  ('unknown', 17, 'z_max', 0.752, 0.07658),
  ('unknown', 17, 'z_min', 0.7439, 0.06868);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 18, 0.02593, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 18, 'area_m2', -1.532, 0.4291),
  ('unknown', 18, 'aspect', 1.638, 0.3128),
  ('unknown', 18, 'behind', 0.6726, 0.08121),
  ('unknown', 18, 'edge_free', 0.1378, 0.1526),
  ('unknown', 18, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 18, 'edge_joined', 0.7755, 0.192),
  ('unknown', 18, 'height', 2.128, 0.1453),
  ('unknown', 18, 'length', 0.1886, 0.2787),
  ('unknown', 18, 'rectangularity', 0.7664, 0.06543),
  ('unknown', 18, 'spread_length', 0.04484, 0.2938),
  ('unknown', 18, 'spread_width', -1.514, 0.251),
  ('unknown', 18, 'tilt_deg', 1.679, 2.388),
  ('unknown', 18, 'width', -1.45, 0.237),
  ('unknown', 18, 'z_max', 2.132, 0.1504),
  ('unknown', 18, 'z_min', 2.123, 0.1468);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 19, 0.02573, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 19, 'area_m2', -2.283, 0.1822),
  ('unknown', 19, 'aspect', 0.263, 0.148),
  ('unknown', 19, 'behind', 0.5602, 0.2613),
  ('unknown', 19, 'edge_free', 0.4922, 0.1708),
  ('unknown', 19, 'edge_free_top', 0.7899, 0.1931),
  ('unknown', 19, 'edge_joined', 0.1994, 0.1885),
  ('unknown', 19, 'height', 1.053, 0.1848),
  ('unknown', 19, 'length', -0.8223, 0.1204),
  ('unknown', 19, 'rectangularity', 0.6935, 0.09215),
  ('unknown', 19, 'spread_length', -1.083, 0.1259),
  ('unknown', 19, 'spread_width', -1.335, 0.1389),
  ('unknown', 19, 'tilt_deg', 88.42, 3.062),
  ('unknown', 19, 'width', -1.085, 0.1224),
  ('unknown', 19, 'z_max', 1.24, 0.1993),
  ('unknown', 19, 'z_min', 0.8469, 0.1896);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 20, 0.025, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 20, 'area_m2', -1.857, 0.3698),
  ('unknown', 20, 'aspect', 0.8741, 0.2961),
  ('unknown', 20, 'behind', 0.5371, 0.2117),
  ('unknown', 20, 'edge_free', 0.4478, 0.2343),
  ('unknown', 20, 'edge_free_top', 0.5327, 0.4032),
  ('unknown', 20, 'edge_joined', 0.05056, 0.07068),
  ('unknown', 20, 'height', 0.458, 0.1298),
  ('unknown', 20, 'length', -0.2207, 0.2387),
  ('unknown', 20, 'rectangularity', 0.6155, 0.1888),
  ('unknown', 20, 'spread_length', -0.3273, 0.2642),
  ('unknown', 20, 'spread_width', -1.441, 0.2725),
  ('unknown', 20, 'tilt_deg', 88.93, 2.512),
  ('unknown', 20, 'width', -1.095, 0.2501),
  ('unknown', 20, 'z_max', 0.7239, 0.1735),
  ('unknown', 20, 'z_min', 0.1498, 0.1619);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 21, 0.02383, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 21, 'area_m2', -2.687, 0.2656),
  ('unknown', 21, 'aspect', 0.3538, 0.2355),
  ('unknown', 21, 'behind', 0.5949, 0.2445),
  ('unknown', 21, 'edge_free', 0.2909, 0.1568),
  ('unknown', 21, 'edge_free_top', 0.3904, 0.2915),
  ('unknown', 21, 'edge_joined', 0.3326, 0.2887),
  ('unknown', 21, 'height', 0.7638, 0.2169),
  ('unknown', 21, 'length', -0.9772, 0.1919),
  ('unknown', 21, 'rectangularity', 0.6914, 0.09448),
  ('unknown', 21, 'spread_length', -1.156, 0.1886),
  ('unknown', 21, 'spread_width', -1.56, 0.1935),
  ('unknown', 21, 'tilt_deg', 86.8, 4.908),
  ('unknown', 21, 'width', -1.331, 0.1791),
  ('unknown', 21, 'z_max', 0.928, 0.2202),
  ('unknown', 21, 'z_min', 0.5976, 0.2286);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 22, 0.02321, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 22, 'area_m2', -2.514, 0.5403),
  ('unknown', 22, 'aspect', 0.8123, 0.3829),
  ('unknown', 22, 'behind', 0.3544, 0.2875),
  ('unknown', 22, 'edge_free', 0.7603, 0.3176),
  ('unknown', 22, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 22, 'edge_joined', 0.1574, 0.237),
  ('unknown', 22, 'height', 2.391, 0.322),
  ('unknown', 22, 'length', -0.699, 0.4066),
  ('unknown', 22, 'rectangularity', 0.7479, 0.1153),
  ('unknown', 22, 'spread_length', -0.831, 0.4154),
  ('unknown', 22, 'spread_width', -1.647, 0.1962),
  ('unknown', 22, 'tilt_deg', 1.933, 2.829),
  ('unknown', 22, 'width', -1.511, 0.1706),
  ('unknown', 22, 'z_max', 2.396, 0.3247),
  ('unknown', 22, 'z_min', 2.385, 0.323);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 23, 0.02263, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 23, 'area_m2', -2.01, 0.3025),
  ('unknown', 23, 'aspect', 0.4358, 0.2406),
  ('unknown', 23, 'behind', 0.6597, 0.1732),
  ('unknown', 23, 'edge_free', 0.2444, 0.1937),
  ('unknown', 23, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 23, 'edge_joined', 0.6231, 0.2301),
  ('unknown', 23, 'height', 0.9357, 0.1959),
  ('unknown', 23, 'length', -0.5835, 0.1837),
  ('unknown', 23, 'rectangularity', 0.6747, 0.1095),
  ('unknown', 23, 'spread_length', -0.7228, 0.189),
  ('unknown', 23, 'spread_width', -1.189, 0.208),
  ('unknown', 23, 'tilt_deg', 4.541, 4.336),
  ('unknown', 23, 'width', -1.019, 0.1951),
  ('unknown', 23, 'z_max', 0.955, 0.2015),
  ('unknown', 23, 'z_min', 0.918, 0.1969);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 24, 0.02153, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 24, 'area_m2', -1.941, 0.2477),
  ('unknown', 24, 'aspect', 0.5849, 0.2202),
  ('unknown', 24, 'behind', 0.6713, 0.1599),
  ('unknown', 24, 'edge_free', 0.3272, 0.1647),
  ('unknown', 24, 'edge_free_top', 0.558, 0.2746),
  ('unknown', 24, 'edge_joined', 0.4162, 0.2868),
  ('unknown', 24, 'height', 1.003, 0.2171),
  ('unknown', 24, 'length', -0.4599, 0.1516),
  ('unknown', 24, 'rectangularity', 0.6525, 0.08656),
  ('unknown', 24, 'spread_length', -0.7342, 0.1928),
  ('unknown', 24, 'spread_width', -1.259, 0.1741),
  ('unknown', 24, 'tilt_deg', 87.17, 4.938),
  ('unknown', 24, 'width', -1.045, 0.1699),
  ('unknown', 24, 'z_max', 1.256, 0.2556),
  ('unknown', 24, 'z_min', 0.7211, 0.2174);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 25, 0.01985, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 25, 'area_m2', -1.163, 0.3153),
  ('unknown', 25, 'aspect', 0.841, 0.2655),
  ('unknown', 25, 'behind', 0.7566, 0.08438),
  ('unknown', 25, 'edge_free', 0.1523, 0.09665),
  ('unknown', 25, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 25, 'edge_joined', 0.803, 0.1364),
  ('unknown', 25, 'height', 1.268, 0.1868),
  ('unknown', 25, 'length', -0.008447, 0.2344),
  ('unknown', 25, 'rectangularity', 0.745, 0.1042),
  ('unknown', 25, 'spread_length', -0.1503, 0.2324),
  ('unknown', 25, 'spread_width', -0.8273, 0.1978),
  ('unknown', 25, 'tilt_deg', 3.31, 2.739),
  ('unknown', 25, 'width', -0.8495, 0.1732),
  ('unknown', 25, 'z_max', 1.283, 0.1907),
  ('unknown', 25, 'z_min', 1.255, 0.1877);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 26, 0.01941, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 26, 'area_m2', -2.976, 0.3928),
  ('unknown', 26, 'aspect', 0.3878, 0.2511),
  ('unknown', 26, 'behind', 0.4156, 0.2935),
  ('unknown', 26, 'edge_free', 0.6034, 0.1699),
  ('unknown', 26, 'edge_free_top', 0.9454, 0.08133),
  ('unknown', 26, 'edge_joined', 0.07379, 0.1145),
  ('unknown', 26, 'height', 1.874, 0.1701),
  ('unknown', 26, 'length', -1.122, 0.2814),
  ('unknown', 26, 'rectangularity', 0.7251, 0.1432),
  ('unknown', 26, 'spread_length', -1.325, 0.2252),
  ('unknown', 26, 'spread_width', -1.716, 0.2097),
  ('unknown', 26, 'tilt_deg', 88.71, 2.692),
  ('unknown', 26, 'width', -1.51, 0.275),
  ('unknown', 26, 'z_max', 2.004, 0.1726),
  ('unknown', 26, 'z_min', 1.718, 0.1832);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 27, 0.01938, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 27, 'area_m2', -1.517, 0.2454),
  ('unknown', 27, 'aspect', 0.2785, 0.1897),
  ('unknown', 27, 'behind', 0.5048, 0.2498),
  ('unknown', 27, 'edge_free', 0.6385, 0.208),
  ('unknown', 27, 'edge_free_top', 0.8264, 0.2351),
  ('unknown', 27, 'edge_joined', 0.1635, 0.1583),
  ('unknown', 27, 'height', 0.6833, 0.1757),
  ('unknown', 27, 'length', -0.4432, 0.1588),
  ('unknown', 27, 'rectangularity', 0.7144, 0.1193),
  ('unknown', 27, 'spread_length', -0.5752, 0.1605),
  ('unknown', 27, 'spread_width', -0.959, 0.1541),
  ('unknown', 27, 'tilt_deg', 84.62, 6.496),
  ('unknown', 27, 'width', -0.7216, 0.1348),
  ('unknown', 27, 'z_max', 0.9311, 0.1899),
  ('unknown', 27, 'z_min', 0.3403, 0.1914);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 28, 0.01913, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 28, 'area_m2', 3.289, 0.6966),
  ('unknown', 28, 'aspect', 0.444, 0.4056),
  ('unknown', 28, 'behind', 0.005696, 0.03),
  ('unknown', 28, 'edge_free', 0.006788, 0.03),
  ('unknown', 28, 'edge_free_top', 0.009618, 0.03107),
  ('unknown', 28, 'edge_joined', 0.05953, 0.09486),
  ('unknown', 28, 'height', 2.255, 0.8405),
  ('unknown', 28, 'length', 1.947, 0.3824),
  ('unknown', 28, 'rectangularity', 0.8623, 0.1211),
  ('unknown', 28, 'spread_length', 1.909, 0.354),
  ('unknown', 28, 'spread_width', 1.448, 0.3986),
  ('unknown', 28, 'tilt_deg', 89.73, 2.39),
  ('unknown', 28, 'width', 1.503, 0.4263),
  ('unknown', 28, 'z_max', 5.853, 2.198),
  ('unknown', 28, 'z_min', -0.9675, 1.322);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 29, 0.01868, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 29, 'area_m2', -2.114, 0.28),
  ('unknown', 29, 'aspect', 0.5257, 0.2584),
  ('unknown', 29, 'behind', 0.4215, 0.2529),
  ('unknown', 29, 'edge_free', 0.7324, 0.2072),
  ('unknown', 29, 'edge_free_top', 0.9851, 0.03438),
  ('unknown', 29, 'edge_joined', 0.02547, 0.04151),
  ('unknown', 29, 'height', 0.9146, 0.2615),
  ('unknown', 29, 'length', -0.5955, 0.2019),
  ('unknown', 29, 'rectangularity', 0.6821, 0.1129),
  ('unknown', 29, 'spread_length', -0.8546, 0.2582),
  ('unknown', 29, 'spread_width', -1.351, 0.1746),
  ('unknown', 29, 'tilt_deg', 85.49, 6.456),
  ('unknown', 29, 'width', -1.121, 0.1837),
  ('unknown', 29, 'z_max', 1.102, 0.2885),
  ('unknown', 29, 'z_min', 0.6622, 0.262);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 30, 0.0178, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 30, 'area_m2', -2.46, 0.3483),
  ('unknown', 30, 'aspect', 1.314, 0.3299),
  ('unknown', 30, 'behind', 0.5458, 0.2655),
  ('unknown', 30, 'edge_free', 0.3804, 0.2715),
  ('unknown', 30, 'edge_free_top', 0.4473, 0.3756),
  ('unknown', 30, 'edge_joined', 0.2669, 0.3181),
  ('unknown', 30, 'height', 0.506, 0.2318),
  ('unknown', 30, 'length', -0.3796, 0.2633),
  ('unknown', 30, 'rectangularity', 0.6932, 0.1274),
  ('unknown', 30, 'spread_length', -0.5267, 0.315),
  ('unknown', 30, 'spread_width', -1.912, 0.1699),
  ('unknown', 30, 'tilt_deg', 87.75, 3.861),
  ('unknown', 30, 'width', -1.694, 0.1907),
  ('unknown', 30, 'z_max', 0.721, 0.2627),
  ('unknown', 30, 'z_min', 0.2662, 0.2716);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 31, 0.01598, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 31, 'area_m2', -0.6992, 0.3613),
  ('unknown', 31, 'aspect', 0.3507, 0.2078),
  ('unknown', 31, 'behind', 0.1613, 0.2099),
  ('unknown', 31, 'edge_free', 0.8063, 0.2104),
  ('unknown', 31, 'edge_free_top', 0.8834, 0.1818),
  ('unknown', 31, 'edge_joined', 0.07176, 0.1133),
  ('unknown', 31, 'height', 1.515, 0.2097),
  ('unknown', 31, 'length', -0.06306, 0.225),
  ('unknown', 31, 'rectangularity', 0.8092, 0.1095),
  ('unknown', 31, 'spread_length', -0.1657, 0.243),
  ('unknown', 31, 'spread_width', -0.6149, 0.1901),
  ('unknown', 31, 'tilt_deg', 88.86, 2.89),
  ('unknown', 31, 'width', -0.4138, 0.1876),
  ('unknown', 31, 'z_max', 1.893, 0.2148),
  ('unknown', 31, 'z_min', 1.155, 0.2735);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 32, 0.01502, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 32, 'area_m2', -0.387, 0.2947),
  ('unknown', 32, 'aspect', 0.3977, 0.2288),
  ('unknown', 32, 'behind', 0.437, 0.1794),
  ('unknown', 32, 'edge_free', 0.601, 0.1617),
  ('unknown', 32, 'edge_free_top', 0.8667, 0.1381),
  ('unknown', 32, 'edge_joined', 0.1431, 0.1547),
  ('unknown', 32, 'height', 0.5439, 0.148),
  ('unknown', 32, 'length', 0.1458, 0.176),
  ('unknown', 32, 'rectangularity', 0.7629, 0.1017),
  ('unknown', 32, 'spread_length', -0.00986, 0.177),
  ('unknown', 32, 'spread_width', -0.4393, 0.2123),
  ('unknown', 32, 'tilt_deg', 84.06, 7.447),
  ('unknown', 32, 'width', -0.2519, 0.1882),
  ('unknown', 32, 'z_max', 0.9395, 0.2105),
  ('unknown', 32, 'z_min', 0.03385, 0.1063);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 33, 0.01447, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 33, 'area_m2', -1.4, 0.414),
  ('unknown', 33, 'aspect', 1.623, 0.3374),
  ('unknown', 33, 'behind', 0.7065, 0.09686),
  ('unknown', 33, 'edge_free', 0.01968, 0.03505),
  ('unknown', 33, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 33, 'edge_joined', 0.9256, 0.08593),
  ('unknown', 33, 'height', 0.8902, 0.08996),
  ('unknown', 33, 'length', 0.2382, 0.2995),
  ('unknown', 33, 'rectangularity', 0.779, 0.0595),
  ('unknown', 33, 'spread_length', 0.08817, 0.2921),
  ('unknown', 33, 'spread_width', -1.386, 0.2579),
  ('unknown', 33, 'tilt_deg', 2.804, 3.282),
  ('unknown', 33, 'width', -1.385, 0.2367),
  ('unknown', 33, 'z_max', 0.899, 0.1042),
  ('unknown', 33, 'z_min', 0.8814, 0.09349);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 34, 0.01306, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 34, 'area_m2', -3.586, 0.3156),
  ('unknown', 34, 'aspect', 0.1961, 0.1603),
  ('unknown', 34, 'behind', 0.251, 0.1907),
  ('unknown', 34, 'edge_free', 0.3363, 0.3333),
  ('unknown', 34, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 34, 'edge_joined', 0.5478, 0.3536),
  ('unknown', 34, 'height', 0.7901, 0.08744),
  ('unknown', 34, 'length', -1.575, 0.1877),
  ('unknown', 34, 'rectangularity', 0.7894, 0.07249),
  ('unknown', 34, 'spread_length', -1.68, 0.1768),
  ('unknown', 34, 'spread_width', -1.895, 0.1353),
  ('unknown', 34, 'tilt_deg', 6.52, 7.063),
  ('unknown', 34, 'width', -1.771, 0.1513),
  ('unknown', 34, 'z_max', 0.8049, 0.1056),
  ('unknown', 34, 'z_min', 0.7777, 0.09103);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 35, 0.01264, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 35, 'area_m2', -0.8995, 0.3034),
  ('unknown', 35, 'aspect', 1.143, 0.251),
  ('unknown', 35, 'behind', 0.4538, 0.2352),
  ('unknown', 35, 'edge_free', 0.508, 0.1486),
  ('unknown', 35, 'edge_free_top', 0.8672, 0.1723),
  ('unknown', 35, 'edge_joined', 0.02678, 0.04673),
  ('unknown', 35, 'height', 0.9453, 0.08823),
  ('unknown', 35, 'length', 0.2982, 0.1977),
  ('unknown', 35, 'rectangularity', 0.7157, 0.128),
  ('unknown', 35, 'spread_length', 0.1527, 0.2447),
  ('unknown', 35, 'spread_width', -1.017, 0.1995),
  ('unknown', 35, 'tilt_deg', 89.01, 3.418),
  ('unknown', 35, 'width', -0.8448, 0.2057),
  ('unknown', 35, 'z_max', 1.149, 0.1205),
  ('unknown', 35, 'z_min', 0.6898, 0.08742);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 36, 0.01155, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 36, 'area_m2', 0.09201, 0.5246),
  ('unknown', 36, 'aspect', 0.5386, 0.3859),
  ('unknown', 36, 'behind', 0.4868, 0.2379),
  ('unknown', 36, 'edge_free', 0.2971, 0.2332),
  ('unknown', 36, 'edge_free_top', 0.4677, 0.3202),
  ('unknown', 36, 'edge_joined', 0.4705, 0.3111),
  ('unknown', 36, 'height', 1.032, 0.3544),
  ('unknown', 36, 'length', 0.5547, 0.3434),
  ('unknown', 36, 'rectangularity', 0.6346, 0.1251),
  ('unknown', 36, 'spread_length', 0.3823, 0.3411),
  ('unknown', 36, 'spread_width', -0.1966, 0.328),
  ('unknown', 36, 'tilt_deg', 58.46, 39.64),
  ('unknown', 36, 'width', 0.01615, 0.2692),
  ('unknown', 36, 'z_max', 1.571, 0.7204),
  ('unknown', 36, 'z_min', 0.4369, 0.4073);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 37, 0.0109, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 37, 'area_m2', 1.414, 0.6878),
  ('unknown', 37, 'aspect', 1.06, 0.7572),
  ('unknown', 37, 'behind', 0.01061, 0.03),
  ('unknown', 37, 'edge_free', 0.01609, 0.05176),
  ('unknown', 37, 'edge_free_top', 0.01338, 0.03877),
  ('unknown', 37, 'edge_joined', 0.1728, 0.2431),
  ('unknown', 37, 'height', 1.423, 1.058),
  ('unknown', 37, 'length', 1.366, 0.5274),
  ('unknown', 37, 'rectangularity', 0.7886, 0.1455),
  ('unknown', 37, 'spread_length', 1.308, 0.5323),
  ('unknown', 37, 'spread_width', 0.2282, 0.4857),
  ('unknown', 37, 'tilt_deg', 89.4, 3.166),
  ('unknown', 37, 'width', 0.3053, 0.5134),
  ('unknown', 37, 'z_max', 3.213, 1.965),
  ('unknown', 37, 'z_min', -0.2861, 1.296);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 38, 0.00756, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 38, 'area_m2', -1.801, 0.2507),
  ('unknown', 38, 'aspect', 0.2005, 0.1513),
  ('unknown', 38, 'behind', 0.2088, 0.1249),
  ('unknown', 38, 'edge_free', 0.8163, 0.1327),
  ('unknown', 38, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 38, 'edge_joined', 0.01409, 0.03437),
  ('unknown', 38, 'height', 0.1175, 0.07095),
  ('unknown', 38, 'length', -0.5524, 0.1375),
  ('unknown', 38, 'rectangularity', 0.6135, 0.06846),
  ('unknown', 38, 'spread_length', -0.7662, 0.09125),
  ('unknown', 38, 'spread_width', -1.01, 0.1574),
  ('unknown', 38, 'tilt_deg', 2.163, 4.153),
  ('unknown', 38, 'width', -0.7529, 0.1751),
  ('unknown', 38, 'z_max', 0.1268, 0.1017),
  ('unknown', 38, 'z_min', 0.1074, 0.07812);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 39, 0.007343, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 39, 'area_m2', -1.469, 0.3378),
  ('unknown', 39, 'aspect', 1.252, 0.2362),
  ('unknown', 39, 'behind', 0.6502, 0.08038),
  ('unknown', 39, 'edge_free', 0.8271, 0.136),
  ('unknown', 39, 'edge_free_top', 0.5859, 0.1278),
  ('unknown', 39, 'edge_joined', 0.1286, 0.1045),
  ('unknown', 39, 'height', 2.295, 0.172),
  ('unknown', 39, 'length', 0.1317, 0.2406),
  ('unknown', 39, 'rectangularity', 0.6467, 0.1767),
  ('unknown', 39, 'spread_length', 0.02797, 0.265),
  ('unknown', 39, 'spread_width', -1.524, 0.1103),
  ('unknown', 39, 'tilt_deg', 2.47, 4.118),
  ('unknown', 39, 'width', -1.12, 0.3574),
  ('unknown', 39, 'z_max', 2.305, 0.1854),
  ('unknown', 39, 'z_min', 2.285, 0.1768);
INSERT INTO class_kind (class, kind, share, description) VALUES ('unknown', 40, 0.004651, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('unknown', 40, 'area_m2', -1.07, 0.6066),
  ('unknown', 40, 'aspect', 1.649, 0.4634),
  ('unknown', 40, 'behind', 0.6413, 0.1356),
  ('unknown', 40, 'edge_free', 0.3287, 0.1798),
  ('unknown', 40, 'edge_free_top', 0.04397, 0.07537),
  ('unknown', 40, 'edge_joined', 0.4287, 0.3252),
  ('unknown', 40, 'height', 2.852, 0.3725),
  ('unknown', 40, 'length', 0.4374, 0.4372),
  ('unknown', 40, 'rectangularity', 0.7511, 0.08829),
  ('unknown', 40, 'spread_length', 0.342, 0.4186),
  ('unknown', 40, 'spread_width', -1.42, 0.3498),
  ('unknown', 40, 'tilt_deg', 84.21, 9.263),
  ('unknown', 40, 'width', -1.211, 0.292),
  ('unknown', 40, 'z_max', 3.027, 0.4034),
  ('unknown', 40, 'z_min', 2.705, 0.3463);

-- floor: 412 examples
UPDATE object_class SET prior = 0.03183 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.036, 1.747)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4751, 0.381)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_free', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'edge_joined', 0.2428, 0.1628)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'height', 0.0006089, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'length', 1.035, 0.8339)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'rectangularity', 0.5924, 0.1355)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_length', 0.785, 0.7612)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'spread_width', 0.1863, 0.9242)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'tilt_deg', 0.686, 1.025)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'width', 0.5548, 1.014)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_max', 0.007825, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'z_min', -0.006738, 0.0225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'floor';
DELETE FROM class_density WHERE class = 'floor';
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 1, 0.2571, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 1, 'area_m2', 2.52, 0.2904),
  ('floor', 1, 'aspect', 0.3184, 0.2224),
  ('floor', 1, 'behind', 0, 0.03),
  ('floor', 1, 'edge_free', 5.257e-08, 0.03),
  ('floor', 1, 'edge_free_top', 0, 0.3162),
  ('floor', 1, 'edge_joined', 0.2872, 0.1254),
  ('floor', 1, 'height', 8.355e-06, 0.0225),
  ('floor', 1, 'length', 1.745, 0.1571),
  ('floor', 1, 'rectangularity', 0.5378, 0.1277),
  ('floor', 1, 'spread_length', 1.4, 0.1341),
  ('floor', 1, 'spread_width', 0.9232, 0.1577),
  ('floor', 1, 'tilt_deg', 0.0107, 0.45),
  ('floor', 1, 'width', 1.427, 0.1557),
  ('floor', 1, 'z_max', 0.0002609, 0.0225),
  ('floor', 1, 'z_min', -0.0002763, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 2, 0.1701, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 2, 'area_m2', 2.161, 0.244),
  ('floor', 2, 'aspect', 0.167, 0.1047),
  ('floor', 2, 'behind', 0, 0.03),
  ('floor', 2, 'edge_free', 7.997e-08, 0.03),
  ('floor', 2, 'edge_free_top', 0, 0.3162),
  ('floor', 2, 'edge_joined', 0.3085, 0.1024),
  ('floor', 2, 'height', -2.383e-05, 0.0225),
  ('floor', 2, 'length', 1.408, 0.1152),
  ('floor', 2, 'rectangularity', 0.6259, 0.1155),
  ('floor', 2, 'spread_length', 1.159, 0.1041),
  ('floor', 2, 'spread_width', 0.8322, 0.1447),
  ('floor', 2, 'tilt_deg', 0.01643, 0.45),
  ('floor', 2, 'width', 1.241, 0.1386),
  ('floor', 2, 'z_max', 0.0002871, 0.0225),
  ('floor', 2, 'z_min', -0.0003985, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 3, 0.1419, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 3, 'area_m2', 1.756, 0.309),
  ('floor', 3, 'aspect', 0.5832, 0.2712),
  ('floor', 3, 'behind', 0, 0.03),
  ('floor', 3, 'edge_free', 9.524e-08, 0.03),
  ('floor', 3, 'edge_free_top', 0, 0.3162),
  ('floor', 3, 'edge_joined', 0.2119, 0.1008),
  ('floor', 3, 'height', -0.0001849, 0.0225),
  ('floor', 3, 'length', 1.5, 0.2293),
  ('floor', 3, 'rectangularity', 0.5249, 0.09464),
  ('floor', 3, 'spread_length', 1.21, 0.1838),
  ('floor', 3, 'spread_width', 0.5527, 0.167),
  ('floor', 3, 'tilt_deg', 0.08649, 0.45),
  ('floor', 3, 'width', 0.9168, 0.1753),
  ('floor', 3, 'z_max', 0.002256, 0.0225),
  ('floor', 3, 'z_min', -0.002315, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 4, 0.093, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 4, 'area_m2', -1.041, 0.3669),
  ('floor', 4, 'aspect', 0.6316, 0.3423),
  ('floor', 4, 'behind', 0, 0.03),
  ('floor', 4, 'edge_free', 1.454e-07, 0.03),
  ('floor', 4, 'edge_free_top', 0, 0.3162),
  ('floor', 4, 'edge_joined', 0.2379, 0.216),
  ('floor', 4, 'height', 0.006857, 0.0225),
  ('floor', 4, 'length', 0.001645, 0.209),
  ('floor', 4, 'rectangularity', 0.6739, 0.1127),
  ('floor', 4, 'spread_length', -0.1489, 0.2031),
  ('floor', 4, 'spread_width', -0.8628, 0.2668),
  ('floor', 4, 'tilt_deg', 1.903, 0.9282),
  ('floor', 4, 'width', -0.63, 0.2685),
  ('floor', 4, 'z_max', 0.02098, 0.0225),
  ('floor', 4, 'z_min', -0.00646, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 5, 0.09017, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 5, 'area_m2', -2.483, 0.6042),
  ('floor', 5, 'aspect', 0.6724, 0.3707),
  ('floor', 5, 'behind', 0, 0.03),
  ('floor', 5, 'edge_free', 1.499e-07, 0.03),
  ('floor', 5, 'edge_free_top', 0, 0.3162),
  ('floor', 5, 'edge_joined', 0.2704, 0.2893),
  ('floor', 5, 'height', 0.005178, 0.0257),
  ('floor', 5, 'length', -0.7013, 0.3644),
  ('floor', 5, 'rectangularity', 0.6819, 0.1399),
  ('floor', 5, 'spread_length', -0.8407, 0.3455),
  ('floor', 5, 'spread_width', -1.596, 0.3445),
  ('floor', 5, 'tilt_deg', 1.714, 1.029),
  ('floor', 5, 'width', -1.374, 0.3438),
  ('floor', 5, 'z_max', 0.01074, 0.02679),
  ('floor', 5, 'z_min', -0.0001762, 0.02488);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 6, 0.08922, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 6, 'area_m2', -0.1973, 0.4733),
  ('floor', 6, 'aspect', 0.8972, 0.4931),
  ('floor', 6, 'behind', 0, 0.03),
  ('floor', 6, 'edge_free', 1.515e-07, 0.03),
  ('floor', 6, 'edge_free_top', 0, 0.3162),
  ('floor', 6, 'edge_joined', 0.1464, 0.1402),
  ('floor', 6, 'height', 0.002156, 0.0225),
  ('floor', 6, 'length', 0.5905, 0.2265),
  ('floor', 6, 'rectangularity', 0.6296, 0.1101),
  ('floor', 6, 'spread_length', 0.4249, 0.1976),
  ('floor', 6, 'spread_width', -0.5664, 0.3826),
  ('floor', 6, 'tilt_deg', 1.463, 0.8844),
  ('floor', 6, 'width', -0.3067, 0.3949),
  ('floor', 6, 'z_max', 0.01924, 0.0225),
  ('floor', 6, 'z_min', -0.01521, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 7, 0.06294, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 7, 'area_m2', 0.8151, 0.3853),
  ('floor', 7, 'aspect', 0.5223, 0.2607),
  ('floor', 7, 'behind', 0, 0.03),
  ('floor', 7, 'edge_free', 2.148e-07, 0.03),
  ('floor', 7, 'edge_free_top', 0, 0.3162),
  ('floor', 7, 'edge_joined', 0.1524, 0.07543),
  ('floor', 7, 'height', 0.002745, 0.0225),
  ('floor', 7, 'length', 0.9909, 0.2428),
  ('floor', 7, 'rectangularity', 0.5474, 0.132),
  ('floor', 7, 'spread_length', 0.7957, 0.2219),
  ('floor', 7, 'spread_width', 0.1595, 0.2353),
  ('floor', 7, 'tilt_deg', 1.235, 0.6238),
  ('floor', 7, 'width', 0.4686, 0.2157),
  ('floor', 7, 'z_max', 0.02827, 0.02456),
  ('floor', 7, 'z_min', -0.02327, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 8, 0.02474, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 8, 'area_m2', -1.492, 0.7248),
  ('floor', 8, 'aspect', 0.9053, 0.5669),
  ('floor', 8, 'behind', 0, 0.03),
  ('floor', 8, 'edge_free', 5.465e-07, 0.03),
  ('floor', 8, 'edge_free_top', 0, 0.3162),
  ('floor', 8, 'edge_joined', 0.08194, 0.09943),
  ('floor', 8, 'height', -0.2671, 0.325),
  ('floor', 8, 'length', -0.02215, 0.4581),
  ('floor', 8, 'rectangularity', 0.6168, 0.169),
  ('floor', 8, 'spread_length', -0.1564, 0.415),
  ('floor', 8, 'spread_width', -1.233, 0.4656),
  ('floor', 8, 'tilt_deg', 2.596, 0.9895),
  ('floor', 8, 'width', -0.9275, 0.5091),
  ('floor', 8, 'z_max', -0.2498, 0.3334),
  ('floor', 8, 'z_min', -0.2828, 0.3181);
INSERT INTO class_kind (class, kind, share, description) VALUES ('floor', 9, 0.02072, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('floor', 9, 'area_m2', 1.897, 0.3836),
  ('floor', 9, 'aspect', 0.2774, 0.1289),
  ('floor', 9, 'behind', 0, 0.03),
  ('floor', 9, 'edge_free', 0.0002695, 0.03),
  ('floor', 9, 'edge_free_top', 0, 0.3162),
  ('floor', 9, 'edge_joined', 0.2159, 0.08816),
  ('floor', 9, 'height', 0.001587, 0.0225),
  ('floor', 9, 'length', 1.327, 0.1661),
  ('floor', 9, 'rectangularity', 0.622, 0.03764),
  ('floor', 9, 'spread_length', 1.01, 0.1512),
  ('floor', 9, 'spread_width', 0.7207, 0.2088),
  ('floor', 9, 'tilt_deg', 1.692, 0.45),
  ('floor', 9, 'width', 1.05, 0.2409),
  ('floor', 9, 'z_max', 0.05149, 0.0225),
  ('floor', 9, 'z_min', -0.05602, 0.02255);

-- ceiling: 318 examples
UPDATE object_class SET prior = 0.02458 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.62, 1.594)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4039, 0.3684)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.01742, 0.07646)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_free', 0.01594, 0.07265)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'edge_joined', 0.4507, 0.2163)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.861, 0.3463)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.218, 0.7161)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.676, 0.1296)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.093, 0.71)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.524, 0.8533)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.06586, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.8116, 0.901)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.862, 0.3466)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.861, 0.3461)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'ceiling';
DELETE FROM class_density WHERE class = 'ceiling';
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 1, 0.2023, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 1, 'area_m2', 2.642, 0.274),
  ('ceiling', 1, 'aspect', 0.2199, 0.1379),
  ('ceiling', 1, 'behind', 0.000267, 0.03),
  ('ceiling', 1, 'edge_free', 0.0002329, 0.03),
  ('ceiling', 1, 'edge_free_top', 0, 0.3162),
  ('ceiling', 1, 'edge_joined', 0.5553, 0.1411),
  ('ceiling', 1, 'height', 2.776, 0.0836),
  ('ceiling', 1, 'length', 1.623, 0.1216),
  ('ceiling', 1, 'rectangularity', 0.6909, 0.1182),
  ('ceiling', 1, 'spread_length', 1.512, 0.1224),
  ('ceiling', 1, 'spread_width', 1.086, 0.1434),
  ('ceiling', 1, 'tilt_deg', 0.004444, 0.45),
  ('ceiling', 1, 'width', 1.404, 0.1235),
  ('ceiling', 1, 'z_max', 2.776, 0.08358),
  ('ceiling', 1, 'z_min', 2.775, 0.0836);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 2, 0.1855, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 2, 'area_m2', 2.586, 0.3417),
  ('ceiling', 2, 'aspect', 0.2083, 0.1566),
  ('ceiling', 2, 'behind', 0.0002912, 0.03),
  ('ceiling', 2, 'edge_free', 0.000254, 0.03),
  ('ceiling', 2, 'edge_free_top', 0, 0.3162),
  ('ceiling', 2, 'edge_joined', 0.6282, 0.1572),
  ('ceiling', 2, 'height', 2.508, 0.06777),
  ('ceiling', 2, 'length', 1.582, 0.1728),
  ('ceiling', 2, 'rectangularity', 0.7035, 0.1263),
  ('ceiling', 2, 'spread_length', 1.438, 0.164),
  ('ceiling', 2, 'spread_width', 1.048, 0.176),
  ('ceiling', 2, 'tilt_deg', 0.005276, 0.45),
  ('ceiling', 2, 'width', 1.373, 0.1485),
  ('ceiling', 2, 'z_max', 2.508, 0.06776),
  ('ceiling', 2, 'z_min', 2.508, 0.06778);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 3, 0.1563, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 3, 'area_m2', 2.33, 0.3872),
  ('ceiling', 3, 'aspect', 0.3611, 0.2717),
  ('ceiling', 3, 'behind', 0.0003456, 0.03),
  ('ceiling', 3, 'edge_free', 0.0003014, 0.03),
  ('ceiling', 3, 'edge_free_top', 0, 0.3162),
  ('ceiling', 3, 'edge_joined', 0.4214, 0.1304),
  ('ceiling', 3, 'height', 3.041, 0.05349),
  ('ceiling', 3, 'length', 1.567, 0.1956),
  ('ceiling', 3, 'rectangularity', 0.6554, 0.1244),
  ('ceiling', 3, 'spread_length', 1.43, 0.162),
  ('ceiling', 3, 'spread_width', 0.8927, 0.2415),
  ('ceiling', 3, 'tilt_deg', 0.006446, 0.45),
  ('ceiling', 3, 'width', 1.205, 0.2591),
  ('ceiling', 3, 'z_max', 3.041, 0.05351),
  ('ceiling', 3, 'z_min', 3.041, 0.05349);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 4, 0.09576, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 4, 'area_m2', 1.978, 0.237),
  ('ceiling', 4, 'aspect', 0.3655, 0.2278),
  ('ceiling', 4, 'behind', 0.0005641, 0.03),
  ('ceiling', 4, 'edge_free', 0.0004921, 0.03),
  ('ceiling', 4, 'edge_free_top', 0, 0.3162),
  ('ceiling', 4, 'edge_joined', 0.5023, 0.1696),
  ('ceiling', 4, 'height', 2.737, 0.126),
  ('ceiling', 4, 'length', 1.406, 0.1402),
  ('ceiling', 4, 'rectangularity', 0.6396, 0.1243),
  ('ceiling', 4, 'spread_length', 1.302, 0.1111),
  ('ceiling', 4, 'spread_width', 0.7382, 0.1669),
  ('ceiling', 4, 'tilt_deg', 0.009138, 0.45),
  ('ceiling', 4, 'width', 1.04, 0.1977),
  ('ceiling', 4, 'z_max', 2.737, 0.126),
  ('ceiling', 4, 'z_min', 2.737, 0.1259);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 5, 0.07832, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 5, 'area_m2', -2.075, 0.7277),
  ('ceiling', 5, 'aspect', 0.6149, 0.4253),
  ('ceiling', 5, 'behind', 0.00181, 0.03),
  ('ceiling', 5, 'edge_free', 0.001152, 0.03),
  ('ceiling', 5, 'edge_free_top', 0, 0.3162),
  ('ceiling', 5, 'edge_joined', 0.2578, 0.1461),
  ('ceiling', 5, 'height', 3.114, 0.3614),
  ('ceiling', 5, 'length', -0.4672, 0.436),
  ('ceiling', 5, 'rectangularity', 0.6007, 0.1041),
  ('ceiling', 5, 'spread_length', -0.6141, 0.4042),
  ('ceiling', 5, 'spread_width', -1.316, 0.3695),
  ('ceiling', 5, 'tilt_deg', 0.6897, 0.778),
  ('ceiling', 5, 'width', -1.082, 0.4019),
  ('ceiling', 5, 'z_max', 3.116, 0.362),
  ('ceiling', 5, 'z_min', 3.112, 0.361);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 6, 0.07255, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 6, 'area_m2', 2.127, 0.4854),
  ('ceiling', 6, 'aspect', 0.4229, 0.2634),
  ('ceiling', 6, 'behind', 0.0007446, 0.03),
  ('ceiling', 6, 'edge_free', 0.0006495, 0.03),
  ('ceiling', 6, 'edge_free_top', 0, 0.3162),
  ('ceiling', 6, 'edge_joined', 0.1849, 0.06645),
  ('ceiling', 6, 'height', 3.464, 0.2127),
  ('ceiling', 6, 'length', 1.519, 0.2512),
  ('ceiling', 6, 'rectangularity', 0.6268, 0.1208),
  ('ceiling', 6, 'spread_length', 1.392, 0.2284),
  ('ceiling', 6, 'spread_width', 0.7889, 0.2761),
  ('ceiling', 6, 'tilt_deg', 0.0203, 0.45),
  ('ceiling', 6, 'width', 1.096, 0.3299),
  ('ceiling', 6, 'z_max', 3.465, 0.2127),
  ('ceiling', 6, 'z_min', 3.464, 0.2126);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 7, 0.06371, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 7, 'area_m2', -0.747, 0.6245),
  ('ceiling', 7, 'aspect', 0.9066, 0.4253),
  ('ceiling', 7, 'behind', 0.004449, 0.03),
  ('ceiling', 7, 'edge_free', 0.0007396, 0.03),
  ('ceiling', 7, 'edge_free_top', 0, 0.3162),
  ('ceiling', 7, 'edge_joined', 0.41, 0.2388),
  ('ceiling', 7, 'height', 2.505, 0.06237),
  ('ceiling', 7, 'length', 0.2415, 0.3962),
  ('ceiling', 7, 'rectangularity', 0.7342, 0.1124),
  ('ceiling', 7, 'spread_length', 0.1497, 0.3758),
  ('ceiling', 7, 'spread_width', -0.8195, 0.3242),
  ('ceiling', 7, 'tilt_deg', 0.1486, 0.45),
  ('ceiling', 7, 'width', -0.6651, 0.3703),
  ('ceiling', 7, 'z_max', 2.505, 0.0624),
  ('ceiling', 7, 'z_min', 2.504, 0.06241);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 8, 0.04043, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 8, 'area_m2', -0.248, 0.4624),
  ('ceiling', 8, 'aspect', 0.6684, 0.3686),
  ('ceiling', 8, 'behind', 0.001336, 0.03),
  ('ceiling', 8, 'edge_free', 0.001166, 0.03),
  ('ceiling', 8, 'edge_free_top', 0, 0.3162),
  ('ceiling', 8, 'edge_joined', 0.2218, 0.1411),
  ('ceiling', 8, 'height', 3.346, 0.2674),
  ('ceiling', 8, 'length', 0.4112, 0.2268),
  ('ceiling', 8, 'rectangularity', 0.6762, 0.08657),
  ('ceiling', 8, 'spread_length', 0.2955, 0.2256),
  ('ceiling', 8, 'spread_width', -0.4702, 0.3362),
  ('ceiling', 8, 'tilt_deg', 0.1009, 0.45),
  ('ceiling', 8, 'width', -0.2572, 0.3605),
  ('ceiling', 8, 'z_max', 3.347, 0.2679),
  ('ceiling', 8, 'z_min', 3.345, 0.2669);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 9, 0.03766, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 9, 'area_m2', 0.7955, 0.5543),
  ('ceiling', 9, 'aspect', 0.9576, 0.5201),
  ('ceiling', 9, 'behind', 0.3066, 0.06245),
  ('ceiling', 9, 'edge_free', 0.3117, 0.07235),
  ('ceiling', 9, 'edge_free_top', 0, 0.3162),
  ('ceiling', 9, 'edge_joined', 0.3262, 0.1761),
  ('ceiling', 9, 'height', 3.048, 0.3314),
  ('ceiling', 9, 'length', 0.991, 0.4382),
  ('ceiling', 9, 'rectangularity', 0.801, 0.07115),
  ('ceiling', 9, 'spread_length', 0.8678, 0.3933),
  ('ceiling', 9, 'spread_width', -0.1184, 0.3101),
  ('ceiling', 9, 'tilt_deg', 0.06306, 0.45),
  ('ceiling', 9, 'width', 0.03337, 0.2936),
  ('ceiling', 9, 'z_max', 3.048, 0.3317),
  ('ceiling', 9, 'z_min', 3.047, 0.3312);
INSERT INTO class_kind (class, kind, share, description) VALUES ('ceiling', 10, 0.01738, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('ceiling', 10, 'area_m2', 0.1562, 0.8975),
  ('ceiling', 10, 'aspect', 0.6858, 0.2448),
  ('ceiling', 10, 'behind', 0.312, 0.1901),
  ('ceiling', 10, 'edge_free', 0.1898, 0.1376),
  ('ceiling', 10, 'edge_free_top', 0, 0.3162),
  ('ceiling', 10, 'edge_joined', 0.291, 0.06509),
  ('ceiling', 10, 'height', 2.804, 0.08523),
  ('ceiling', 10, 'length', 0.6392, 0.374),
  ('ceiling', 10, 'rectangularity', 0.6526, 0.06332),
  ('ceiling', 10, 'spread_length', 0.5045, 0.3809),
  ('ceiling', 10, 'spread_width', -0.3397, 0.4878),
  ('ceiling', 10, 'tilt_deg', 0.04956, 0.45),
  ('ceiling', 10, 'width', -0.04665, 0.5432),
  ('ceiling', 10, 'z_max', 2.805, 0.08528),
  ('ceiling', 10, 'z_min', 2.804, 0.08517);

-- wall: 1987 examples
UPDATE object_class SET prior = 0.1535 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 0.5641, 1.413)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.661, 0.4811)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.1038, 0.1886)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free', 0.1339, 0.2302)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_free_top', 0.1162, 0.2558)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'edge_joined', 0.1843, 0.2414)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.364, 0.4769)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 0.8225, 0.6515)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.6791, 0.1476)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.6474, 0.6605)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', -0.09727, 0.8415)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.27, 2.492)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.157, 0.8528)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.367, 0.7882)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.2585, 0.5097)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'wall';
DELETE FROM class_density WHERE class = 'wall';
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 1, 0.21, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 1, 'area_m2', 2.06, 0.3181),
  ('wall', 1, 'aspect', 0.3895, 0.2138),
  ('wall', 1, 'behind', 0.00216, 0.03),
  ('wall', 1, 'edge_free', 0.003236, 0.03),
  ('wall', 1, 'edge_free_top', 0.0005025, 0.03),
  ('wall', 1, 'edge_joined', 0.08699, 0.09274),
  ('wall', 1, 'height', 1.528, 0.1833),
  ('wall', 1, 'length', 1.412, 0.214),
  ('wall', 1, 'rectangularity', 0.6989, 0.1246),
  ('wall', 1, 'spread_length', 1.243, 0.2268),
  ('wall', 1, 'spread_width', 0.7457, 0.1904),
  ('wall', 1, 'tilt_deg', 89.98, 0.45),
  ('wall', 1, 'width', 1.023, 0.1014),
  ('wall', 1, 'z_max', 2.828, 0.3014),
  ('wall', 1, 'z_min', -0.009267, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 2, 0.1448, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 2, 'area_m2', 1.137, 0.4599),
  ('wall', 2, 'aspect', 0.4832, 0.3124),
  ('wall', 2, 'behind', 0.001016, 0.03),
  ('wall', 2, 'edge_free', 0.006395, 0.03),
  ('wall', 2, 'edge_free_top', 0.007395, 0.03),
  ('wall', 2, 'edge_joined', 0.2545, 0.2418),
  ('wall', 2, 'height', 1.503, 0.269),
  ('wall', 2, 'length', 1.027, 0.2625),
  ('wall', 2, 'rectangularity', 0.6679, 0.1585),
  ('wall', 2, 'spread_length', 0.8295, 0.263),
  ('wall', 2, 'spread_width', 0.2441, 0.246),
  ('wall', 2, 'tilt_deg', 89.94, 0.45),
  ('wall', 2, 'width', 0.5442, 0.3346),
  ('wall', 2, 'z_max', 2.756, 0.3908),
  ('wall', 2, 'z_min', 0.2456, 0.3497);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 3, 0.1291, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 3, 'area_m2', 0.4151, 0.5119),
  ('wall', 3, 'aspect', 1.089, 0.5217),
  ('wall', 3, 'behind', 0.2923, 0.2398),
  ('wall', 3, 'edge_free', 0.2987, 0.2385),
  ('wall', 3, 'edge_free_top', 0.2164, 0.2248),
  ('wall', 3, 'edge_joined', 0.3086, 0.306),
  ('wall', 3, 'height', 1.428, 0.1933),
  ('wall', 3, 'length', 0.9788, 0.1697),
  ('wall', 3, 'rectangularity', 0.6577, 0.1585),
  ('wall', 3, 'spread_length', 0.7757, 0.2432),
  ('wall', 3, 'spread_width', -0.3936, 0.5431),
  ('wall', 3, 'tilt_deg', 89.98, 0.45),
  ('wall', 3, 'width', -0.1102, 0.5347),
  ('wall', 3, 'z_max', 2.765, 0.325),
  ('wall', 3, 'z_min', 0.124, 0.2302);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 4, 0.1133, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 4, 'area_m2', -0.2347, 0.6438),
  ('wall', 4, 'aspect', 0.9643, 0.5835),
  ('wall', 4, 'behind', 0.001245, 0.03),
  ('wall', 4, 'edge_free', 0.006183, 0.03),
  ('wall', 4, 'edge_free_top', 0.01288, 0.043),
  ('wall', 4, 'edge_joined', 0.1846, 0.2218),
  ('wall', 4, 'height', 1.028, 0.4114),
  ('wall', 4, 'length', 0.5497, 0.3672),
  ('wall', 4, 'rectangularity', 0.7099, 0.1502),
  ('wall', 4, 'spread_length', 0.3969, 0.3771),
  ('wall', 4, 'spread_width', -0.6146, 0.5071),
  ('wall', 4, 'tilt_deg', 88.56, 1.83),
  ('wall', 4, 'width', -0.4146, 0.5265),
  ('wall', 4, 'z_max', 1.721, 0.682),
  ('wall', 4, 'z_min', 0.2321, 0.3504);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 5, 0.09641, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 5, 'area_m2', 1.857, 0.318),
  ('wall', 5, 'aspect', 0.3827, 0.2087),
  ('wall', 5, 'behind', 0.1229, 0.1175),
  ('wall', 5, 'edge_free', 0.1744, 0.1119),
  ('wall', 5, 'edge_free_top', 0.09315, 0.133),
  ('wall', 5, 'edge_joined', 0.07447, 0.09294),
  ('wall', 5, 'height', 1.553, 0.2082),
  ('wall', 5, 'length', 1.395, 0.2104),
  ('wall', 5, 'rectangularity', 0.5905, 0.123),
  ('wall', 5, 'spread_length', 1.26, 0.2189),
  ('wall', 5, 'spread_width', 0.8187, 0.1866),
  ('wall', 5, 'tilt_deg', 89.98, 0.45),
  ('wall', 5, 'width', 1.012, 0.1121),
  ('wall', 5, 'z_max', 2.844, 0.2893),
  ('wall', 5, 'z_min', -0.008346, 0.02779);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 6, 0.07986, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 6, 'area_m2', -0.7386, 0.7078),
  ('wall', 6, 'aspect', 0.9426, 0.4374),
  ('wall', 6, 'behind', 0.2187, 0.2156),
  ('wall', 6, 'edge_free', 0.4958, 0.3162),
  ('wall', 6, 'edge_free_top', 0.5237, 0.4142),
  ('wall', 6, 'edge_joined', 0.07548, 0.1369),
  ('wall', 6, 'height', 1.062, 0.3476),
  ('wall', 6, 'length', 0.3364, 0.3766),
  ('wall', 6, 'rectangularity', 0.6483, 0.1602),
  ('wall', 6, 'spread_length', 0.1251, 0.4191),
  ('wall', 6, 'spread_width', -0.9091, 0.4652),
  ('wall', 6, 'tilt_deg', 84.09, 12.21),
  ('wall', 6, 'width', -0.6062, 0.4749),
  ('wall', 6, 'z_max', 1.625, 0.4469),
  ('wall', 6, 'z_min', 0.4023, 0.4116);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 7, 0.06063, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 7, 'area_m2', -0.8962, 0.9688),
  ('wall', 7, 'aspect', 0.749, 0.4512),
  ('wall', 7, 'behind', 0.1693, 0.2349),
  ('wall', 7, 'edge_free', 0.1516, 0.2104),
  ('wall', 7, 'edge_free_top', 0.007239, 0.03),
  ('wall', 7, 'edge_joined', 0.3343, 0.2857),
  ('wall', 7, 'height', 2.285, 0.3873),
  ('wall', 7, 'length', 0.1074, 0.511),
  ('wall', 7, 'rectangularity', 0.7079, 0.1207),
  ('wall', 7, 'spread_length', -0.05299, 0.5414),
  ('wall', 7, 'spread_width', -0.835, 0.5343),
  ('wall', 7, 'tilt_deg', 89.74, 0.5005),
  ('wall', 7, 'width', -0.6417, 0.5444),
  ('wall', 7, 'z_max', 2.827, 0.4119),
  ('wall', 7, 'z_min', 1.815, 0.5486);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 8, 0.05544, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 8, 'area_m2', -2.353, 0.6736),
  ('wall', 8, 'aspect', 0.7388, 0.4815),
  ('wall', 8, 'behind', 0.1313, 0.223),
  ('wall', 8, 'edge_free', 0.06665, 0.1202),
  ('wall', 8, 'edge_free_top', 0.1175, 0.2252),
  ('wall', 8, 'edge_joined', 0.1572, 0.246),
  ('wall', 8, 'height', 0.2955, 0.2708),
  ('wall', 8, 'length', -0.6335, 0.4493),
  ('wall', 8, 'rectangularity', 0.7185, 0.1244),
  ('wall', 8, 'spread_length', -0.7787, 0.4396),
  ('wall', 8, 'spread_width', -1.577, 0.3733),
  ('wall', 8, 'tilt_deg', 88.3, 2.282),
  ('wall', 8, 'width', -1.372, 0.3645),
  ('wall', 8, 'z_max', 0.4931, 0.3177),
  ('wall', 8, 'z_min', 0.09045, 0.2603);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 9, 0.03365, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 9, 'area_m2', 0.5736, 0.3536),
  ('wall', 9, 'aspect', 0.2774, 0.1999),
  ('wall', 9, 'behind', 0.3213, 0.211),
  ('wall', 9, 'edge_free', 0.4943, 0.2716),
  ('wall', 9, 'edge_free_top', 0.9072, 0.1131),
  ('wall', 9, 'edge_joined', 0.1498, 0.2089),
  ('wall', 9, 'height', 0.9792, 0.2075),
  ('wall', 9, 'length', 0.5854, 0.1769),
  ('wall', 9, 'rectangularity', 0.7463, 0.1527),
  ('wall', 9, 'spread_length', 0.4371, 0.1814),
  ('wall', 9, 'spread_width', 0.04823, 0.2413),
  ('wall', 9, 'tilt_deg', 89.66, 0.6323),
  ('wall', 9, 'width', 0.308, 0.2209),
  ('wall', 9, 'z_max', 1.65, 0.2965),
  ('wall', 9, 'z_min', -0.006934, 0.07086);
INSERT INTO class_kind (class, kind, share, description) VALUES ('wall', 10, 0.02686, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('wall', 10, 'area_m2', -1.659, 0.6307),
  ('wall', 10, 'aspect', 0.7838, 0.5253),
  ('wall', 10, 'behind', 0.1057, 0.2026),
  ('wall', 10, 'edge_free', 0.01004, 0.03),
  ('wall', 10, 'edge_free_top', 0.008841, 0.03664),
  ('wall', 10, 'edge_joined', 0.4628, 0.3892),
  ('wall', 10, 'height', 1.319, 0.1852),
  ('wall', 10, 'length', -0.2641, 0.4183),
  ('wall', 10, 'rectangularity', 0.7234, 0.1445),
  ('wall', 10, 'spread_length', -0.4559, 0.3858),
  ('wall', 10, 'spread_width', -1.268, 0.4143),
  ('wall', 10, 'tilt_deg', 88.92, 1.723),
  ('wall', 10, 'width', -1.048, 0.4077),
  ('wall', 10, 'z_max', 1.692, 0.2844),
  ('wall', 10, 'z_min', 0.915, 0.2678);

-- table: 605 examples
UPDATE object_class SET prior = 0.04679 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.3815, 0.6607)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5574, 0.2943)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5264, 0.2121)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_free', 0.4448, 0.2204)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'edge_joined', 0.2889, 0.1983)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7279, 0.1224)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.2665, 0.3351)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.7108, 0.1243)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1259, 0.3286)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4771, 0.3847)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.614, 0.5902)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2928, 0.3565)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7344, 0.1226)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.7232, 0.1222)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'table';
DELETE FROM class_density WHERE class = 'table';
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 1, 0.1584, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 1, 'area_m2', 0.148, 0.1964),
  ('table', 1, 'aspect', 0.6, 0.19),
  ('table', 1, 'behind', 0.6999, 0.05142),
  ('table', 1, 'edge_free', 0.3679, 0.1321),
  ('table', 1, 'edge_free_top', 0, 0.3162),
  ('table', 1, 'edge_joined', 0.3944, 0.1561),
  ('table', 1, 'height', 0.7347, 0.02371),
  ('table', 1, 'length', 0.5403, 0.1174),
  ('table', 1, 'rectangularity', 0.723, 0.08924),
  ('table', 1, 'spread_length', 0.3711, 0.1426),
  ('table', 1, 'spread_width', -0.2072, 0.1571),
  ('table', 1, 'tilt_deg', 0.3731, 0.45),
  ('table', 1, 'width', -0.0597, 0.1535),
  ('table', 1, 'z_max', 0.7394, 0.02363),
  ('table', 1, 'z_min', 0.7317, 0.02398);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 2, 0.1273, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 2, 'area_m2', -0.04339, 0.3168),
  ('table', 2, 'aspect', 0.5823, 0.2679),
  ('table', 2, 'behind', 0.5554, 0.1413),
  ('table', 2, 'edge_free', 0.475, 0.1662),
  ('table', 2, 'edge_free_top', 0, 0.3162),
  ('table', 2, 'edge_joined', 0.2294, 0.1422),
  ('table', 2, 'height', 0.6639, 0.02817),
  ('table', 2, 'length', 0.4557, 0.2142),
  ('table', 2, 'rectangularity', 0.7019, 0.1265),
  ('table', 2, 'spread_length', 0.3294, 0.2295),
  ('table', 2, 'spread_width', -0.2837, 0.1775),
  ('table', 2, 'tilt_deg', 0.6995, 0.6213),
  ('table', 2, 'width', -0.1266, 0.1879),
  ('table', 2, 'z_max', 0.6733, 0.02738),
  ('table', 2, 'z_min', 0.6568, 0.03056);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 3, 0.1106, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 3, 'area_m2', -0.3561, 0.2235),
  ('table', 3, 'aspect', 0.2735, 0.1525),
  ('table', 3, 'behind', 0.5471, 0.223),
  ('table', 3, 'edge_free', 0.3176, 0.1569),
  ('table', 3, 'edge_free_top', 0, 0.3162),
  ('table', 3, 'edge_joined', 0.3886, 0.1862),
  ('table', 3, 'height', 0.7369, 0.02417),
  ('table', 3, 'length', 0.1664, 0.1392),
  ('table', 3, 'rectangularity', 0.6743, 0.1213),
  ('table', 3, 'spread_length', 0.03851, 0.1379),
  ('table', 3, 'spread_width', -0.3233, 0.1352),
  ('table', 3, 'tilt_deg', 0.429, 0.45),
  ('table', 3, 'width', -0.1071, 0.1101),
  ('table', 3, 'z_max', 0.7416, 0.02506),
  ('table', 3, 'z_min', 0.7337, 0.024);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 4, 0.1057, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 4, 'area_m2', 0.08598, 0.1731),
  ('table', 4, 'aspect', 0.6382, 0.1585),
  ('table', 4, 'behind', 0.5062, 0.1647),
  ('table', 4, 'edge_free', 0.6506, 0.1566),
  ('table', 4, 'edge_free_top', 0, 0.3162),
  ('table', 4, 'edge_joined', 0.1644, 0.1142),
  ('table', 4, 'height', 0.7183, 0.0225),
  ('table', 4, 'length', 0.4667, 0.1296),
  ('table', 4, 'rectangularity', 0.8154, 0.07824),
  ('table', 4, 'spread_length', 0.3342, 0.1419),
  ('table', 4, 'spread_width', -0.3005, 0.1118),
  ('table', 4, 'tilt_deg', 0.2943, 0.45),
  ('table', 4, 'width', -0.1715, 0.1064),
  ('table', 4, 'z_max', 0.7216, 0.0225),
  ('table', 4, 'z_min', 0.7157, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 5, 0.1027, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 5, 'area_m2', -0.06992, 0.3059),
  ('table', 5, 'aspect', 0.5907, 0.2708),
  ('table', 5, 'behind', 0.5045, 0.158),
  ('table', 5, 'edge_free', 0.4913, 0.2023),
  ('table', 5, 'edge_free_top', 0, 0.3162),
  ('table', 5, 'edge_joined', 0.2369, 0.171),
  ('table', 5, 'height', 0.7927, 0.02743),
  ('table', 5, 'length', 0.4334, 0.2165),
  ('table', 5, 'rectangularity', 0.724, 0.1418),
  ('table', 5, 'spread_length', 0.2842, 0.1877),
  ('table', 5, 'spread_width', -0.3357, 0.1919),
  ('table', 5, 'tilt_deg', 0.6668, 0.6244),
  ('table', 5, 'width', -0.1574, 0.1888),
  ('table', 5, 'z_max', 0.8011, 0.03114),
  ('table', 5, 'z_min', 0.7862, 0.02633);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 6, 0.1007, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 6, 'area_m2', -0.9345, 0.3002),
  ('table', 6, 'aspect', 0.659, 0.2549),
  ('table', 6, 'behind', 0.4489, 0.2242),
  ('table', 6, 'edge_free', 0.4647, 0.2203),
  ('table', 6, 'edge_free_top', 0, 0.3162),
  ('table', 6, 'edge_joined', 0.2615, 0.2147),
  ('table', 6, 'height', 0.7185, 0.02898),
  ('table', 6, 'length', 0.06691, 0.2232),
  ('table', 6, 'rectangularity', 0.676, 0.1191),
  ('table', 6, 'spread_length', -0.08301, 0.2378),
  ('table', 6, 'spread_width', -0.8396, 0.177),
  ('table', 6, 'tilt_deg', 0.4908, 0.45),
  ('table', 6, 'width', -0.5921, 0.1569),
  ('table', 6, 'z_max', 0.7227, 0.02938),
  ('table', 6, 'z_min', 0.7157, 0.02884);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 7, 0.09383, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 7, 'area_m2', -0.8642, 0.1918),
  ('table', 7, 'aspect', 0.2586, 0.1511),
  ('table', 7, 'behind', 0.5175, 0.2174),
  ('table', 7, 'edge_free', 0.4746, 0.2147),
  ('table', 7, 'edge_free_top', 0, 0.3162),
  ('table', 7, 'edge_joined', 0.254, 0.1709),
  ('table', 7, 'height', 0.7261, 0.06473),
  ('table', 7, 'length', -0.1489, 0.1129),
  ('table', 7, 'rectangularity', 0.7432, 0.1027),
  ('table', 7, 'spread_length', -0.2291, 0.1068),
  ('table', 7, 'spread_width', -0.5973, 0.15),
  ('table', 7, 'tilt_deg', 0.8845, 0.6499),
  ('table', 7, 'width', -0.4075, 0.1323),
  ('table', 7, 'z_max', 0.7332, 0.06553),
  ('table', 7, 'z_min', 0.7209, 0.06484);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 8, 0.07985, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 8, 'area_m2', -1.866, 0.5163),
  ('table', 8, 'aspect', 0.8554, 0.4018),
  ('table', 8, 'behind', 0.3626, 0.2539),
  ('table', 8, 'edge_free', 0.4556, 0.2999),
  ('table', 8, 'edge_free_top', 0, 0.3162),
  ('table', 8, 'edge_joined', 0.2342, 0.2003),
  ('table', 8, 'height', 0.7289, 0.05265),
  ('table', 8, 'length', -0.2807, 0.2948),
  ('table', 8, 'rectangularity', 0.65, 0.1189),
  ('table', 8, 'spread_length', -0.4312, 0.3176),
  ('table', 8, 'spread_width', -1.377, 0.3158),
  ('table', 8, 'tilt_deg', 1.144, 1.052),
  ('table', 8, 'width', -1.136, 0.3395),
  ('table', 8, 'z_max', 0.735, 0.0536),
  ('table', 8, 'z_min', 0.7245, 0.05223);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 9, 0.05385, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 9, 'area_m2', -0.1688, 0.6398),
  ('table', 9, 'aspect', 0.6794, 0.3172),
  ('table', 9, 'behind', 0.4932, 0.1951),
  ('table', 9, 'edge_free', 0.3144, 0.2195),
  ('table', 9, 'edge_free_top', 0, 0.3162),
  ('table', 9, 'edge_joined', 0.4921, 0.192),
  ('table', 9, 'height', 0.9736, 0.1202),
  ('table', 9, 'length', 0.4753, 0.3884),
  ('table', 9, 'rectangularity', 0.6575, 0.1196),
  ('table', 9, 'spread_length', 0.2919, 0.3581),
  ('table', 9, 'spread_width', -0.3912, 0.3477),
  ('table', 9, 'tilt_deg', 0.9006, 0.5604),
  ('table', 9, 'width', -0.2041, 0.3198),
  ('table', 9, 'z_max', 0.9845, 0.1197),
  ('table', 9, 'z_min', 0.9641, 0.1208);
INSERT INTO class_kind (class, kind, share, description) VALUES ('table', 10, 0.01699, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('table', 10, 'area_m2', -0.6871, 0.694),
  ('table', 10, 'aspect', 0.5021, 0.1452),
  ('table', 10, 'behind', 0.2057, 0.129),
  ('table', 10, 'edge_free', 0.2972, 0.1151),
  ('table', 10, 'edge_free_top', 0, 0.3162),
  ('table', 10, 'edge_joined', 0.1806, 0.1707),
  ('table', 10, 'height', 0.06691, 0.05976),
  ('table', 10, 'length', 0.1457, 0.331),
  ('table', 10, 'rectangularity', 0.6299, 0.08749),
  ('table', 10, 'spread_length', 0.01805, 0.3006),
  ('table', 10, 'spread_width', -0.6223, 0.418),
  ('table', 10, 'tilt_deg', 1.333, 0.6203),
  ('table', 10, 'width', -0.3564, 0.3879),
  ('table', 10, 'z_max', 0.07848, 0.05963),
  ('table', 10, 'z_min', 0.05702, 0.06033);

-- flat_screen: 483 examples
UPDATE object_class SET prior = 0.03738 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.867, 0.3821)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.392, 0.2059)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5848, 0.1371)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free', 0.7806, 0.172)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_free_top', 0.9811, 0.06075)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'edge_joined', 0.04402, 0.08137)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.016, 0.1242)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.624, 0.2451)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.8076, 0.1173)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7716, 0.2025)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.213, 0.1779)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.15, 3.358)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -1.016, 0.2171)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.17, 0.1334)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.789, 0.1399)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'flat_screen';
DELETE FROM class_density WHERE class = 'flat_screen';
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 1, 0.1544, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 1, 'area_m2', -1.553, 0.1166),
  ('flat_screen', 1, 'aspect', 0.3225, 0.1084),
  ('flat_screen', 1, 'behind', 0.5709, 0.1278),
  ('flat_screen', 1, 'edge_free', 0.7428, 0.08266),
  ('flat_screen', 1, 'edge_free_top', 0.9935, 0.03),
  ('flat_screen', 1, 'edge_joined', 0.06314, 0.06833),
  ('flat_screen', 1, 'height', 1.002, 0.0507),
  ('flat_screen', 1, 'length', -0.5167, 0.09566),
  ('flat_screen', 1, 'rectangularity', 0.8247, 0.07572),
  ('flat_screen', 1, 'spread_length', -0.6243, 0.07044),
  ('flat_screen', 1, 'spread_width', -1.081, 0.06468),
  ('flat_screen', 1, 'tilt_deg', 85.15, 3.113),
  ('flat_screen', 1, 'width', -0.8392, 0.08052),
  ('flat_screen', 1, 'z_max', 1.165, 0.05137),
  ('flat_screen', 1, 'z_min', 0.7319, 0.04938);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 2, 0.1178, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 2, 'area_m2', -1.771, 0.1345),
  ('flat_screen', 2, 'aspect', 0.5012, 0.05062),
  ('flat_screen', 2, 'behind', 0.5694, 0.1055),
  ('flat_screen', 2, 'edge_free', 0.9828, 0.0308),
  ('flat_screen', 2, 'edge_free_top', 0.9992, 0.03),
  ('flat_screen', 2, 'edge_joined', 0.003435, 0.03),
  ('flat_screen', 2, 'height', 1.025, 0.03934),
  ('flat_screen', 2, 'length', -0.5986, 0.07619),
  ('flat_screen', 2, 'rectangularity', 0.9311, 0.03),
  ('flat_screen', 2, 'spread_length', -0.6426, 0.07124),
  ('flat_screen', 2, 'spread_width', -1.14, 0.07734),
  ('flat_screen', 2, 'tilt_deg', 85.13, 3.654),
  ('flat_screen', 2, 'width', -1.1, 0.0693),
  ('flat_screen', 2, 'z_max', 1.181, 0.04305),
  ('flat_screen', 2, 'z_min', 0.8479, 0.03881);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 3, 0.1169, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 3, 'area_m2', -2.02, 0.1877),
  ('flat_screen', 3, 'aspect', 0.3853, 0.1633),
  ('flat_screen', 3, 'behind', 0.5831, 0.1582),
  ('flat_screen', 3, 'edge_free', 0.7697, 0.1525),
  ('flat_screen', 3, 'edge_free_top', 0.9957, 0.03),
  ('flat_screen', 3, 'edge_joined', 0.03558, 0.04641),
  ('flat_screen', 3, 'height', 1.041, 0.03849),
  ('flat_screen', 3, 'length', -0.6559, 0.1231),
  ('flat_screen', 3, 'rectangularity', 0.7324, 0.1049),
  ('flat_screen', 3, 'spread_length', -0.8313, 0.158),
  ('flat_screen', 3, 'spread_width', -1.288, 0.1164),
  ('flat_screen', 3, 'tilt_deg', 85.54, 3.164),
  ('flat_screen', 3, 'width', -1.041, 0.1392),
  ('flat_screen', 3, 'z_max', 1.177, 0.03923),
  ('flat_screen', 3, 'z_min', 0.8019, 0.0578);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 4, 0.1058, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 4, 'area_m2', -1.55, 0.2079),
  ('flat_screen', 4, 'aspect', 0.5891, 0.1373),
  ('flat_screen', 4, 'behind', 0.627, 0.1295),
  ('flat_screen', 4, 'edge_free', 0.6301, 0.05344),
  ('flat_screen', 4, 'edge_free_top', 0.9883, 0.03),
  ('flat_screen', 4, 'edge_joined', 0.07534, 0.1051),
  ('flat_screen', 4, 'height', 0.9433, 0.04465),
  ('flat_screen', 4, 'length', -0.3056, 0.1339),
  ('flat_screen', 4, 'rectangularity', 0.7085, 0.06601),
  ('flat_screen', 4, 'spread_length', -0.6458, 0.1801),
  ('flat_screen', 4, 'spread_width', -1.119, 0.1075),
  ('flat_screen', 4, 'tilt_deg', 85.6, 3.167),
  ('flat_screen', 4, 'width', -0.8947, 0.09668),
  ('flat_screen', 4, 'z_max', 1.104, 0.04941),
  ('flat_screen', 4, 'z_min', 0.6875, 0.04094);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 5, 0.1054, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 5, 'area_m2', -2.024, 0.1527),
  ('flat_screen', 5, 'aspect', 0.151, 0.1099),
  ('flat_screen', 5, 'behind', 0.6491, 0.09394),
  ('flat_screen', 5, 'edge_free', 0.7439, 0.05529),
  ('flat_screen', 5, 'edge_free_top', 0.9996, 0.03),
  ('flat_screen', 5, 'edge_joined', 0.03864, 0.04193),
  ('flat_screen', 5, 'height', 0.955, 0.0424),
  ('flat_screen', 5, 'length', -0.8362, 0.1247),
  ('flat_screen', 5, 'rectangularity', 0.822, 0.07333),
  ('flat_screen', 5, 'spread_length', -0.9645, 0.1082),
  ('flat_screen', 5, 'spread_width', -1.249, 0.05809),
  ('flat_screen', 5, 'tilt_deg', 85.67, 3.333),
  ('flat_screen', 5, 'width', -0.9871, 0.07255),
  ('flat_screen', 5, 'z_max', 1.09, 0.04416),
  ('flat_screen', 5, 'z_min', 0.7111, 0.04324);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 6, 0.09426, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 6, 'area_m2', -2.218, 0.1257),
  ('flat_screen', 6, 'aspect', 0.342, 0.1273),
  ('flat_screen', 6, 'behind', 0.568, 0.1203),
  ('flat_screen', 6, 'edge_free', 0.9868, 0.03),
  ('flat_screen', 6, 'edge_free_top', 0.9996, 0.03),
  ('flat_screen', 6, 'edge_joined', 0.002099, 0.03),
  ('flat_screen', 6, 'height', 1.002, 0.05223),
  ('flat_screen', 6, 'length', -0.9015, 0.1066),
  ('flat_screen', 6, 'rectangularity', 0.9309, 0.03088),
  ('flat_screen', 6, 'spread_length', -0.9315, 0.1061),
  ('flat_screen', 6, 'spread_width', -1.281, 0.05774),
  ('flat_screen', 6, 'tilt_deg', 84.41, 3.213),
  ('flat_screen', 6, 'width', -1.244, 0.06966),
  ('flat_screen', 6, 'z_max', 1.139, 0.05174),
  ('flat_screen', 6, 'z_min', 0.8495, 0.05352);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 7, 0.09235, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 7, 'area_m2', -1.792, 0.2422),
  ('flat_screen', 7, 'aspect', 0.3919, 0.186),
  ('flat_screen', 7, 'behind', 0.5303, 0.1175),
  ('flat_screen', 7, 'edge_free', 0.8206, 0.172),
  ('flat_screen', 7, 'edge_free_top', 0.9958, 0.03),
  ('flat_screen', 7, 'edge_joined', 0.01903, 0.03),
  ('flat_screen', 7, 'height', 1.242, 0.1036),
  ('flat_screen', 7, 'length', -0.5942, 0.1894),
  ('flat_screen', 7, 'rectangularity', 0.8176, 0.1072),
  ('flat_screen', 7, 'spread_length', -0.7218, 0.1653),
  ('flat_screen', 7, 'spread_width', -1.168, 0.1165),
  ('flat_screen', 7, 'tilt_deg', 84.37, 3.033),
  ('flat_screen', 7, 'width', -0.9861, 0.1708),
  ('flat_screen', 7, 'z_max', 1.402, 0.1067),
  ('flat_screen', 7, 'z_min', 1.018, 0.1197);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 8, 0.07445, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 8, 'area_m2', -1.529, 0.3313),
  ('flat_screen', 8, 'aspect', 0.3743, 0.2143),
  ('flat_screen', 8, 'behind', 0.6197, 0.09207),
  ('flat_screen', 8, 'edge_free', 0.5249, 0.1295),
  ('flat_screen', 8, 'edge_free_top', 0.8257, 0.1089),
  ('flat_screen', 8, 'edge_joined', 0.13, 0.1961),
  ('flat_screen', 8, 'height', 1.001, 0.06146),
  ('flat_screen', 8, 'length', -0.3968, 0.2327),
  ('flat_screen', 8, 'rectangularity', 0.7041, 0.09245),
  ('flat_screen', 8, 'spread_length', -0.6895, 0.2087),
  ('flat_screen', 8, 'spread_width', -1.123, 0.1219),
  ('flat_screen', 8, 'tilt_deg', 82.31, 12.62),
  ('flat_screen', 8, 'width', -0.7711, 0.1676),
  ('flat_screen', 8, 'z_max', 1.229, 0.1051),
  ('flat_screen', 8, 'z_min', 0.7503, 0.0776);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 9, 0.05078, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 9, 'area_m2', -2.701, 0.29),
  ('flat_screen', 9, 'aspect', 0.4441, 0.3033),
  ('flat_screen', 9, 'behind', 0.5744, 0.1765),
  ('flat_screen', 9, 'edge_free', 0.8073, 0.155),
  ('flat_screen', 9, 'edge_free_top', 0.9992, 0.03),
  ('flat_screen', 9, 'edge_joined', 0.01061, 0.03),
  ('flat_screen', 9, 'height', 1.01, 0.05737),
  ('flat_screen', 9, 'length', -0.9828, 0.1586),
  ('flat_screen', 9, 'rectangularity', 0.7581, 0.1151),
  ('flat_screen', 9, 'spread_length', -1.083, 0.1192),
  ('flat_screen', 9, 'spread_width', -1.641, 0.2573),
  ('flat_screen', 9, 'tilt_deg', 85.64, 2.538),
  ('flat_screen', 9, 'width', -1.427, 0.2489),
  ('flat_screen', 9, 'z_max', 1.129, 0.05419),
  ('flat_screen', 9, 'z_min', 0.8221, 0.0691);
INSERT INTO class_kind (class, kind, share, description) VALUES ('flat_screen', 10, 0.03785, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('flat_screen', 10, 'area_m2', -2.314, 0.4618),
  ('flat_screen', 10, 'aspect', 0.5848, 0.2821),
  ('flat_screen', 10, 'behind', 0.5012, 0.2299),
  ('flat_screen', 10, 'edge_free', 0.6906, 0.1545),
  ('flat_screen', 10, 'edge_free_top', 0.9439, 0.1028),
  ('flat_screen', 10, 'edge_joined', 0.1341, 0.1422),
  ('flat_screen', 10, 'height', 0.8431, 0.3655),
  ('flat_screen', 10, 'length', -0.7075, 0.339),
  ('flat_screen', 10, 'rectangularity', 0.749, 0.146),
  ('flat_screen', 10, 'spread_length', -0.8642, 0.2803),
  ('flat_screen', 10, 'spread_width', -1.466, 0.2588),
  ('flat_screen', 10, 'tilt_deg', 85.23, 4.798),
  ('flat_screen', 10, 'width', -1.292, 0.2549),
  ('flat_screen', 10, 'z_max', 0.9861, 0.3763),
  ('flat_screen', 10, 'z_min', 0.6142, 0.3992);

-- keyboard: 291 examples
UPDATE object_class SET prior = 0.02255 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.771, 0.35)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7733, 0.3011)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.2318, 0.1578)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_free', 0.2642, 0.2088)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'edge_joined', 0.6885, 0.225)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7579, 0.1366)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.8989, 0.2719)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8244, 0.07912)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9733, 0.2728)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.832, 0.1211)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.793, 2.126)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.674, 0.1888)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7655, 0.1373)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7513, 0.1363)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'keyboard';
DELETE FROM class_density WHERE class = 'keyboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 1, 0.1755, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 1, 'area_m2', -2.547, 0.121),
  ('keyboard', 1, 'aspect', 0.8522, 0.1343),
  ('keyboard', 1, 'behind', 0.2473, 0.1285),
  ('keyboard', 1, 'edge_free', 0.4279, 0.1139),
  ('keyboard', 1, 'edge_free_top', 0, 0.3162),
  ('keyboard', 1, 'edge_joined', 0.5349, 0.1173),
  ('keyboard', 1, 'height', 0.7697, 0.02713),
  ('keyboard', 1, 'length', -0.7465, 0.09591),
  ('keyboard', 1, 'rectangularity', 0.819, 0.05429),
  ('keyboard', 1, 'spread_length', -0.8212, 0.07465),
  ('keyboard', 1, 'spread_width', -1.781, 0.09911),
  ('keyboard', 1, 'tilt_deg', 4.733, 1.425),
  ('keyboard', 1, 'width', -1.599, 0.1014),
  ('keyboard', 1, 'z_max', 0.779, 0.02726),
  ('keyboard', 1, 'z_min', 0.7617, 0.02748);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 2, 0.1496, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 2, 'area_m2', -2.577, 0.1031),
  ('keyboard', 2, 'aspect', 0.9132, 0.1658),
  ('keyboard', 2, 'behind', 0.2835, 0.156),
  ('keyboard', 2, 'edge_free', 0.05028, 0.05994),
  ('keyboard', 2, 'edge_free_top', 0, 0.3162),
  ('keyboard', 2, 'edge_joined', 0.9137, 0.08106),
  ('keyboard', 2, 'height', 0.7578, 0.03538),
  ('keyboard', 2, 'length', -0.7275, 0.09723),
  ('keyboard', 2, 'rectangularity', 0.8139, 0.05974),
  ('keyboard', 2, 'spread_length', -0.806, 0.07905),
  ('keyboard', 2, 'spread_width', -1.81, 0.09717),
  ('keyboard', 2, 'tilt_deg', 1.902, 1.162),
  ('keyboard', 2, 'width', -1.641, 0.1186),
  ('keyboard', 2, 'z_max', 0.7619, 0.03543),
  ('keyboard', 2, 'z_min', 0.7544, 0.03535);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 3, 0.1378, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 3, 'area_m2', -2.89, 0.1498),
  ('keyboard', 3, 'aspect', 0.4576, 0.1691),
  ('keyboard', 3, 'behind', 0.2645, 0.1848),
  ('keyboard', 3, 'edge_free', 0.2633, 0.2123),
  ('keyboard', 3, 'edge_free_top', 0, 0.3162),
  ('keyboard', 3, 'edge_joined', 0.6651, 0.2522),
  ('keyboard', 3, 'height', 0.7477, 0.0452),
  ('keyboard', 3, 'length', -1.101, 0.1027),
  ('keyboard', 3, 'rectangularity', 0.7985, 0.07502),
  ('keyboard', 3, 'spread_length', -1.19, 0.09604),
  ('keyboard', 3, 'spread_width', -1.769, 0.09619),
  ('keyboard', 3, 'tilt_deg', 4.218, 2.5),
  ('keyboard', 3, 'width', -1.559, 0.1442),
  ('keyboard', 3, 'z_max', 0.7565, 0.04775),
  ('keyboard', 3, 'z_min', 0.7398, 0.04337);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 4, 0.114, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 4, 'area_m2', -2.704, 0.1036),
  ('keyboard', 4, 'aspect', 1.008, 0.1033),
  ('keyboard', 4, 'behind', 0.1825, 0.1307),
  ('keyboard', 4, 'edge_free', 0.3951, 0.151),
  ('keyboard', 4, 'edge_free_top', 0, 0.3162),
  ('keyboard', 4, 'edge_joined', 0.5821, 0.1338),
  ('keyboard', 4, 'height', 0.7005, 0.03882),
  ('keyboard', 4, 'length', -0.7781, 0.06163),
  ('keyboard', 4, 'rectangularity', 0.8725, 0.06432),
  ('keyboard', 4, 'spread_length', -0.8256, 0.06594),
  ('keyboard', 4, 'spread_width', -1.876, 0.08385),
  ('keyboard', 4, 'tilt_deg', 4.49, 1.65),
  ('keyboard', 4, 'width', -1.787, 0.09877),
  ('keyboard', 4, 'z_max', 0.709, 0.03828),
  ('keyboard', 4, 'z_min', 0.6932, 0.03979);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 5, 0.09111, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 5, 'area_m2', -2.764, 0.1131),
  ('keyboard', 5, 'aspect', 1.058, 0.1196),
  ('keyboard', 5, 'behind', 0.1965, 0.1246),
  ('keyboard', 5, 'edge_free', 0.2986, 0.2222),
  ('keyboard', 5, 'edge_free_top', 0, 0.3162),
  ('keyboard', 5, 'edge_joined', 0.6507, 0.2333),
  ('keyboard', 5, 'height', 0.8147, 0.03784),
  ('keyboard', 5, 'length', -0.7766, 0.1006),
  ('keyboard', 5, 'rectangularity', 0.8609, 0.06142),
  ('keyboard', 5, 'spread_length', -0.8302, 0.08091),
  ('keyboard', 5, 'spread_width', -1.899, 0.07716),
  ('keyboard', 5, 'tilt_deg', 3.689, 1.915),
  ('keyboard', 5, 'width', -1.835, 0.06786),
  ('keyboard', 5, 'z_max', 0.8218, 0.03951),
  ('keyboard', 5, 'z_min', 0.8083, 0.03673);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 6, 0.08528, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 6, 'area_m2', -3.509, 0.2841),
  ('keyboard', 6, 'aspect', 0.266, 0.1733),
  ('keyboard', 6, 'behind', 0.2653, 0.1399),
  ('keyboard', 6, 'edge_free', 0.1946, 0.172),
  ('keyboard', 6, 'edge_free_top', 0, 0.3162),
  ('keyboard', 6, 'edge_joined', 0.6717, 0.2535),
  ('keyboard', 6, 'height', 0.7469, 0.03831),
  ('keyboard', 6, 'length', -1.493, 0.1522),
  ('keyboard', 6, 'rectangularity', 0.7764, 0.06435),
  ('keyboard', 6, 'spread_length', -1.595, 0.1128),
  ('keyboard', 6, 'spread_width', -1.93, 0.1424),
  ('keyboard', 6, 'tilt_deg', 3.959, 2.067),
  ('keyboard', 6, 'width', -1.759, 0.1652),
  ('keyboard', 6, 'z_max', 0.7544, 0.04053),
  ('keyboard', 6, 'z_min', 0.741, 0.03749);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 7, 0.06726, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 7, 'area_m2', -3.189, 0.1478),
  ('keyboard', 7, 'aspect', 0.7226, 0.1518),
  ('keyboard', 7, 'behind', 0.1644, 0.1413),
  ('keyboard', 7, 'edge_free', 0.2685, 0.1854),
  ('keyboard', 7, 'edge_free_top', 0, 0.3162),
  ('keyboard', 7, 'edge_joined', 0.705, 0.1899),
  ('keyboard', 7, 'height', 0.8663, 0.1136),
  ('keyboard', 7, 'length', -1.145, 0.09191),
  ('keyboard', 7, 'rectangularity', 0.8462, 0.1008),
  ('keyboard', 7, 'spread_length', -1.213, 0.09825),
  ('keyboard', 7, 'spread_width', -1.933, 0.07999),
  ('keyboard', 7, 'tilt_deg', 4.185, 2.249),
  ('keyboard', 7, 'width', -1.868, 0.1007),
  ('keyboard', 7, 'z_max', 0.8735, 0.1152),
  ('keyboard', 7, 'z_min', 0.8605, 0.1131);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 8, 0.06313, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 8, 'area_m2', -2.332, 0.1329),
  ('keyboard', 8, 'aspect', 0.6468, 0.1355),
  ('keyboard', 8, 'behind', 0.2527, 0.0776),
  ('keyboard', 8, 'edge_free', 0.1724, 0.1539),
  ('keyboard', 8, 'edge_free_top', 0, 0.3162),
  ('keyboard', 8, 'edge_joined', 0.8166, 0.1492),
  ('keyboard', 8, 'height', 0.7056, 0.03233),
  ('keyboard', 8, 'length', -0.6965, 0.1057),
  ('keyboard', 8, 'rectangularity', 0.7489, 0.04874),
  ('keyboard', 8, 'spread_length', -0.8301, 0.06413),
  ('keyboard', 8, 'spread_width', -1.713, 0.09816),
  ('keyboard', 8, 'tilt_deg', 2.99, 1.915),
  ('keyboard', 8, 'width', -1.343, 0.09759),
  ('keyboard', 8, 'z_max', 0.7125, 0.0322),
  ('keyboard', 8, 'z_min', 0.6976, 0.0334);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 9, 0.04424, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 9, 'area_m2', -2.633, 0.1516),
  ('keyboard', 9, 'aspect', 0.9202, 0.1909),
  ('keyboard', 9, 'behind', 0.1736, 0.1733),
  ('keyboard', 9, 'edge_free', 0.2842, 0.1568),
  ('keyboard', 9, 'edge_free_top', 0, 0.3162),
  ('keyboard', 9, 'edge_joined', 0.6877, 0.1343),
  ('keyboard', 9, 'height', 1.024, 0.07575),
  ('keyboard', 9, 'length', -0.7891, 0.0953),
  ('keyboard', 9, 'rectangularity', 0.8793, 0.08087),
  ('keyboard', 9, 'spread_length', -0.8086, 0.08385),
  ('keyboard', 9, 'spread_width', -1.808, 0.09691),
  ('keyboard', 9, 'tilt_deg', 4.764, 1.818),
  ('keyboard', 9, 'width', -1.709, 0.169),
  ('keyboard', 9, 'z_max', 1.034, 0.07589),
  ('keyboard', 9, 'z_min', 1.016, 0.07656);
INSERT INTO class_kind (class, kind, share, description) VALUES ('keyboard', 10, 0.02209, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('keyboard', 10, 'area_m2', -2.934, 0.351),
  ('keyboard', 10, 'aspect', 0.9799, 0.3588),
  ('keyboard', 10, 'behind', 0.0998, 0.09242),
  ('keyboard', 10, 'edge_free', 0.1318, 0.1403),
  ('keyboard', 10, 'edge_free_top', 0, 0.3162),
  ('keyboard', 10, 'edge_joined', 0.8478, 0.1369),
  ('keyboard', 10, 'height', 0.1326, 0.08544),
  ('keyboard', 10, 'length', -0.9256, 0.3308),
  ('keyboard', 10, 'rectangularity', 0.905, 0.04627),
  ('keyboard', 10, 'spread_length', -0.9431, 0.3189),
  ('keyboard', 10, 'spread_width', -1.953, 0.04402),
  ('keyboard', 10, 'tilt_deg', 2.564, 1.232),
  ('keyboard', 10, 'width', -1.906, 0.06283),
  ('keyboard', 10, 'z_max', 0.1381, 0.08576),
  ('keyboard', 10, 'z_min', 0.1276, 0.08524);

-- chair_seat: 373 examples
UPDATE object_class SET prior = 0.0289 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.033, 0.4999)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.2842, 0.269)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6583, 0.1656)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_free', 0.627, 0.1959)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'edge_joined', 0.07975, 0.1011)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.469, 0.03077)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7149, 0.165)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7434, 0.1314)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7686, 0.1719)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.202, 0.3447)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 0.9436, 0.9062)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.003, 0.3263)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.473, 0.03089)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4659, 0.03098)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_seat';
DELETE FROM class_density WHERE class = 'chair_seat';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 1, 0.1549, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 1, 'area_m2', -1.636, 0.09908),
  ('chair_seat', 1, 'aspect', 0.1255, 0.07011),
  ('chair_seat', 1, 'behind', 0.6967, 0.08124),
  ('chair_seat', 1, 'edge_free', 0.8032, 0.104),
  ('chair_seat', 1, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 1, 'edge_joined', 0.04485, 0.05645),
  ('chair_seat', 1, 'height', 0.4407, 0.0225),
  ('chair_seat', 1, 'length', -0.6749, 0.07288),
  ('chair_seat', 1, 'rectangularity', 0.8547, 0.06118),
  ('chair_seat', 1, 'spread_length', -0.7322, 0.06378),
  ('chair_seat', 1, 'spread_width', -0.9195, 0.08095),
  ('chair_seat', 1, 'tilt_deg', 0.5164, 0.45),
  ('chair_seat', 1, 'width', -0.8004, 0.06519),
  ('chair_seat', 1, 'z_max', 0.4435, 0.0225),
  ('chair_seat', 1, 'z_min', 0.4386, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 2, 0.1351, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 2, 'area_m2', -1.933, 0.2323),
  ('chair_seat', 2, 'aspect', 0.2098, 0.1504),
  ('chair_seat', 2, 'behind', 0.7313, 0.08067),
  ('chair_seat', 2, 'edge_free', 0.5616, 0.1027),
  ('chair_seat', 2, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 2, 'edge_joined', 0.08992, 0.09326),
  ('chair_seat', 2, 'height', 0.4441, 0.0225),
  ('chair_seat', 2, 'length', -0.6357, 0.1329),
  ('chair_seat', 2, 'rectangularity', 0.6453, 0.09843),
  ('chair_seat', 2, 'spread_length', -0.6995, 0.08971),
  ('chair_seat', 2, 'spread_width', -1.102, 0.1112),
  ('chair_seat', 2, 'tilt_deg', 0.5723, 0.45),
  ('chair_seat', 2, 'width', -0.8455, 0.09169),
  ('chair_seat', 2, 'z_max', 0.447, 0.0225),
  ('chair_seat', 2, 'z_min', 0.4418, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 3, 0.1133, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 3, 'area_m2', -1.663, 0.1236),
  ('chair_seat', 3, 'aspect', 0.1294, 0.1046),
  ('chair_seat', 3, 'behind', 0.6667, 0.1081),
  ('chair_seat', 3, 'edge_free', 0.5914, 0.1258),
  ('chair_seat', 3, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 3, 'edge_joined', 0.2129, 0.09737),
  ('chair_seat', 3, 'height', 0.4809, 0.0225),
  ('chair_seat', 3, 'length', -0.6617, 0.08318),
  ('chair_seat', 3, 'rectangularity', 0.8147, 0.07805),
  ('chair_seat', 3, 'spread_length', -0.6818, 0.06775),
  ('chair_seat', 3, 'spread_width', -0.9419, 0.09389),
  ('chair_seat', 3, 'tilt_deg', 0.8484, 0.5809),
  ('chair_seat', 3, 'width', -0.7911, 0.08741),
  ('chair_seat', 3, 'z_max', 0.4855, 0.0225),
  ('chair_seat', 3, 'z_min', 0.4775, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 4, 0.1128, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 4, 'area_m2', -1.653, 0.1235),
  ('chair_seat', 4, 'aspect', 0.1261, 0.07406),
  ('chair_seat', 4, 'behind', 0.6236, 0.1093),
  ('chair_seat', 4, 'edge_free', 0.8467, 0.08182),
  ('chair_seat', 4, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 4, 'edge_joined', 0.01759, 0.03),
  ('chair_seat', 4, 'height', 0.4922, 0.0225),
  ('chair_seat', 4, 'length', -0.6831, 0.06386),
  ('chair_seat', 4, 'rectangularity', 0.8537, 0.04725),
  ('chair_seat', 4, 'spread_length', -0.7427, 0.06513),
  ('chair_seat', 4, 'spread_width', -0.9491, 0.1084),
  ('chair_seat', 4, 'tilt_deg', 0.6544, 0.6029),
  ('chair_seat', 4, 'width', -0.8092, 0.08679),
  ('chair_seat', 4, 'z_max', 0.4959, 0.0225),
  ('chair_seat', 4, 'z_min', 0.4898, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 5, 0.112, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 5, 'area_m2', -1.968, 0.2466),
  ('chair_seat', 5, 'aspect', 0.2079, 0.1524),
  ('chair_seat', 5, 'behind', 0.6872, 0.0803),
  ('chair_seat', 5, 'edge_free', 0.6266, 0.08869),
  ('chair_seat', 5, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 5, 'edge_joined', 0.02638, 0.03468),
  ('chair_seat', 5, 'height', 0.4992, 0.0225),
  ('chair_seat', 5, 'length', -0.6457, 0.1401),
  ('chair_seat', 5, 'rectangularity', 0.6367, 0.1083),
  ('chair_seat', 5, 'spread_length', -0.6876, 0.09082),
  ('chair_seat', 5, 'spread_width', -1.175, 0.1576),
  ('chair_seat', 5, 'tilt_deg', 0.7821, 0.6199),
  ('chair_seat', 5, 'width', -0.8536, 0.1078),
  ('chair_seat', 5, 'z_max', 0.5031, 0.0225),
  ('chair_seat', 5, 'z_min', 0.4963, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 6, 0.102, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 6, 'area_m2', -3.102, 0.3556),
  ('chair_seat', 6, 'aspect', 0.6536, 0.3323),
  ('chair_seat', 6, 'behind', 0.5584, 0.3036),
  ('chair_seat', 6, 'edge_free', 0.4965, 0.1955),
  ('chair_seat', 6, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 6, 'edge_joined', 0.07717, 0.09527),
  ('chair_seat', 6, 'height', 0.4537, 0.1175),
  ('chair_seat', 6, 'length', -1.031, 0.2665),
  ('chair_seat', 6, 'rectangularity', 0.6893, 0.1068),
  ('chair_seat', 6, 'spread_length', -1.139, 0.2908),
  ('chair_seat', 6, 'spread_width', -1.876, 0.2117),
  ('chair_seat', 6, 'tilt_deg', 2.222, 1.593),
  ('chair_seat', 6, 'width', -1.685, 0.2303),
  ('chair_seat', 6, 'z_max', 0.4594, 0.118),
  ('chair_seat', 6, 'z_min', 0.4491, 0.1174);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 7, 0.09592, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 7, 'area_m2', -2.431, 0.1949),
  ('chair_seat', 7, 'aspect', 0.6984, 0.1402),
  ('chair_seat', 7, 'behind', 0.6243, 0.1649),
  ('chair_seat', 7, 'edge_free', 0.5191, 0.22),
  ('chair_seat', 7, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 7, 'edge_joined', 0.0689, 0.09807),
  ('chair_seat', 7, 'height', 0.486, 0.0225),
  ('chair_seat', 7, 'length', -0.6853, 0.09874),
  ('chair_seat', 7, 'rectangularity', 0.7092, 0.1256),
  ('chair_seat', 7, 'spread_length', -0.7318, 0.1049),
  ('chair_seat', 7, 'spread_width', -1.595, 0.131),
  ('chair_seat', 7, 'tilt_deg', 0.9798, 0.6155),
  ('chair_seat', 7, 'width', -1.384, 0.1444),
  ('chair_seat', 7, 'z_max', 0.4896, 0.0225),
  ('chair_seat', 7, 'z_min', 0.4828, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 8, 0.06441, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 8, 'area_m2', -2.274, 0.2437),
  ('chair_seat', 8, 'aspect', 0.3942, 0.1761),
  ('chair_seat', 8, 'behind', 0.599, 0.239),
  ('chair_seat', 8, 'edge_free', 0.6077, 0.1535),
  ('chair_seat', 8, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 8, 'edge_joined', 0.02505, 0.0347),
  ('chair_seat', 8, 'height', 0.4381, 0.0225),
  ('chair_seat', 8, 'length', -0.7559, 0.1182),
  ('chair_seat', 8, 'rectangularity', 0.7068, 0.1324),
  ('chair_seat', 8, 'spread_length', -0.8149, 0.1065),
  ('chair_seat', 8, 'spread_width', -1.389, 0.1515),
  ('chair_seat', 8, 'tilt_deg', 1.334, 1.037),
  ('chair_seat', 8, 'width', -1.15, 0.1414),
  ('chair_seat', 8, 'z_max', 0.4437, 0.0225),
  ('chair_seat', 8, 'z_min', 0.4341, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_seat', 9, 0.05958, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_seat', 9, 'area_m2', -2.138, 0.1875),
  ('chair_seat', 9, 'aspect', 0.2043, 0.143),
  ('chair_seat', 9, 'behind', 0.6804, 0.08179),
  ('chair_seat', 9, 'edge_free', 0.3813, 0.09332),
  ('chair_seat', 9, 'edge_free_top', 0, 0.3162),
  ('chair_seat', 9, 'edge_joined', 0.1974, 0.08059),
  ('chair_seat', 9, 'height', 0.4836, 0.0286),
  ('chair_seat', 9, 'length', -0.7934, 0.1107),
  ('chair_seat', 9, 'rectangularity', 0.7171, 0.1051),
  ('chair_seat', 9, 'spread_length', -0.8131, 0.1303),
  ('chair_seat', 9, 'spread_width', -1.205, 0.1099),
  ('chair_seat', 9, 'tilt_deg', 1.48, 1.094),
  ('chair_seat', 9, 'width', -0.9977, 0.09983),
  ('chair_seat', 9, 'z_max', 0.4901, 0.02846),
  ('chair_seat', 9, 'z_min', 0.4785, 0.0289);

-- chair_back: 382 examples
UPDATE object_class SET prior = 0.02959 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.744, 0.5533)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.388, 0.2705)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.56, 0.2933)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free', 0.806, 0.1822)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_free_top', 0.9539, 0.152)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'edge_joined', 0.09982, 0.1329)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8155, 0.0791)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5435, 0.2655)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7777, 0.1218)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6988, 0.2285)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.134, 0.3658)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.53, 3.832)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9346, 0.3072)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.023, 0.09017)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.4463, 0.1614)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'chair_back';
DELETE FROM class_density WHERE class = 'chair_back';
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 1, 0.1744, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 1, 'area_m2', -1.451, 0.1104),
  ('chair_back', 1, 'aspect', 0.1317, 0.07821),
  ('chair_back', 1, 'behind', 0.6908, 0.1548),
  ('chair_back', 1, 'edge_free', 0.8313, 0.1171),
  ('chair_back', 1, 'edge_free_top', 0.9952, 0.03),
  ('chair_back', 1, 'edge_joined', 0.1013, 0.1105),
  ('chair_back', 1, 'height', 0.7971, 0.07343),
  ('chair_back', 1, 'length', -0.5771, 0.07488),
  ('chair_back', 1, 'rectangularity', 0.8519, 0.07211),
  ('chair_back', 1, 'spread_length', -0.7057, 0.06005),
  ('chair_back', 1, 'spread_width', -0.8352, 0.09497),
  ('chair_back', 1, 'tilt_deg', 80.44, 3.777),
  ('chair_back', 1, 'width', -0.7089, 0.07647),
  ('chair_back', 1, 'z_max', 1.001, 0.08603),
  ('chair_back', 1, 'z_min', 0.455, 0.08957);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 2, 0.1339, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 2, 'area_m2', -1.819, 0.1578),
  ('chair_back', 2, 'aspect', 0.1889, 0.1144),
  ('chair_back', 2, 'behind', 0.4054, 0.3199),
  ('chair_back', 2, 'edge_free', 0.8695, 0.1397),
  ('chair_back', 2, 'edge_free_top', 0.9971, 0.03),
  ('chair_back', 2, 'edge_joined', 0.02989, 0.04959),
  ('chair_back', 2, 'height', 0.812, 0.07814),
  ('chair_back', 2, 'length', -0.7084, 0.08903),
  ('chair_back', 2, 'rectangularity', 0.8148, 0.09991),
  ('chair_back', 2, 'spread_length', -0.7927, 0.09715),
  ('chair_back', 2, 'spread_width', -1.084, 0.1272),
  ('chair_back', 2, 'tilt_deg', 81.65, 3.931),
  ('chair_back', 2, 'width', -0.8973, 0.0859),
  ('chair_back', 2, 'z_max', 0.9853, 0.07816),
  ('chair_back', 2, 'z_min', 0.5278, 0.09868);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 3, 0.12, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 3, 'area_m2', -2.695, 0.4105),
  ('chair_back', 3, 'aspect', 0.4981, 0.3128),
  ('chair_back', 3, 'behind', 0.4085, 0.3395),
  ('chair_back', 3, 'edge_free', 0.796, 0.1884),
  ('chair_back', 3, 'edge_free_top', 0.9949, 0.03),
  ('chair_back', 3, 'edge_joined', 0.06227, 0.1186),
  ('chair_back', 3, 'height', 0.8608, 0.07819),
  ('chair_back', 3, 'length', -0.9148, 0.2128),
  ('chair_back', 3, 'rectangularity', 0.7077, 0.1357),
  ('chair_back', 3, 'spread_length', -1.05, 0.2257),
  ('chair_back', 3, 'spread_width', -1.667, 0.2637),
  ('chair_back', 3, 'tilt_deg', 80.46, 3.607),
  ('chair_back', 3, 'width', -1.413, 0.2736),
  ('chair_back', 3, 'z_max', 1.003, 0.07098),
  ('chair_back', 3, 'z_min', 0.6333, 0.09455);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 4, 0.1085, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 4, 'area_m2', -1.919, 0.1753),
  ('chair_back', 4, 'aspect', 0.6418, 0.1928),
  ('chair_back', 4, 'behind', 0.7472, 0.07759),
  ('chair_back', 4, 'edge_free', 0.7766, 0.1148),
  ('chair_back', 4, 'edge_free_top', 0.9733, 0.0522),
  ('chair_back', 4, 'edge_joined', 0.1367, 0.09041),
  ('chair_back', 4, 'height', 0.8069, 0.07853),
  ('chair_back', 4, 'length', -0.4658, 0.13),
  ('chair_back', 4, 'rectangularity', 0.7178, 0.1084),
  ('chair_back', 4, 'spread_length', -0.6133, 0.1255),
  ('chair_back', 4, 'spread_width', -1.407, 0.1791),
  ('chair_back', 4, 'tilt_deg', 80.08, 3.104),
  ('chair_back', 4, 'width', -1.108, 0.1487),
  ('chair_back', 4, 'z_max', 1.039, 0.09208),
  ('chair_back', 4, 'z_min', 0.4389, 0.08821);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 5, 0.1003, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 5, 'area_m2', -1.516, 0.1247),
  ('chair_back', 5, 'aspect', 0.5355, 0.1127),
  ('chair_back', 5, 'behind', 0.5562, 0.2588),
  ('chair_back', 5, 'edge_free', 0.8885, 0.07981),
  ('chair_back', 5, 'edge_free_top', 0.996, 0.03),
  ('chair_back', 5, 'edge_joined', 0.06224, 0.06148),
  ('chair_back', 5, 'height', 0.8475, 0.05209),
  ('chair_back', 5, 'length', -0.3466, 0.07695),
  ('chair_back', 5, 'rectangularity', 0.7523, 0.05616),
  ('chair_back', 5, 'spread_length', -0.576, 0.08837),
  ('chair_back', 5, 'spread_width', -1.162, 0.1289),
  ('chair_back', 5, 'tilt_deg', 80.97, 3.537),
  ('chair_back', 5, 'width', -0.882, 0.09616),
  ('chair_back', 5, 'z_max', 1.083, 0.05908),
  ('chair_back', 5, 'z_min', 0.4051, 0.06015);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 6, 0.09685, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 6, 'area_m2', -1.195, 0.1498),
  ('chair_back', 6, 'aspect', 0.3821, 0.1228),
  ('chair_back', 6, 'behind', 0.5398, 0.2835),
  ('chair_back', 6, 'edge_free', 0.9852, 0.03),
  ('chair_back', 6, 'edge_free_top', 0.9988, 0.03),
  ('chair_back', 6, 'edge_joined', 0.01214, 0.03),
  ('chair_back', 6, 'height', 0.8104, 0.05132),
  ('chair_back', 6, 'length', -0.3472, 0.1144),
  ('chair_back', 6, 'rectangularity', 0.891, 0.05936),
  ('chair_back', 6, 'spread_length', -0.5043, 0.0947),
  ('chair_back', 6, 'spread_width', -0.8108, 0.09881),
  ('chair_back', 6, 'tilt_deg', 80.36, 3.743),
  ('chair_back', 6, 'width', -0.7293, 0.08765),
  ('chair_back', 6, 'z_max', 1.053, 0.05967),
  ('chair_back', 6, 'z_min', 0.3537, 0.05436);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 7, 0.08867, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 7, 'area_m2', -2.267, 0.5873),
  ('chair_back', 7, 'aspect', 0.4255, 0.3313),
  ('chair_back', 7, 'behind', 0.4725, 0.3146),
  ('chair_back', 7, 'edge_free', 0.5127, 0.1902),
  ('chair_back', 7, 'edge_free_top', 0.5802, 0.3126),
  ('chair_back', 7, 'edge_joined', 0.243, 0.2283),
  ('chair_back', 7, 'height', 0.7438, 0.2231),
  ('chair_back', 7, 'length', -0.7555, 0.2371),
  ('chair_back', 7, 'rectangularity', 0.7304, 0.1174),
  ('chair_back', 7, 'spread_length', -0.8653, 0.2422),
  ('chair_back', 7, 'spread_width', -1.429, 0.42),
  ('chair_back', 7, 'tilt_deg', 80.05, 4.125),
  ('chair_back', 7, 'width', -1.181, 0.4023),
  ('chair_back', 7, 'z_max', 0.9354, 0.2412),
  ('chair_back', 7, 'z_min', 0.4808, 0.2166);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 8, 0.07147, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 8, 'area_m2', -1.299, 0.1473),
  ('chair_back', 8, 'aspect', 0.3386, 0.1283),
  ('chair_back', 8, 'behind', 0.6135, 0.2279),
  ('chair_back', 8, 'edge_free', 0.6405, 0.1256),
  ('chair_back', 8, 'edge_free_top', 0.9625, 0.06795),
  ('chair_back', 8, 'edge_joined', 0.2756, 0.1238),
  ('chair_back', 8, 'height', 0.8353, 0.05667),
  ('chair_back', 8, 'length', -0.3626, 0.06511),
  ('chair_back', 8, 'rectangularity', 0.7947, 0.07371),
  ('chair_back', 8, 'spread_length', -0.5155, 0.08177),
  ('chair_back', 8, 'spread_width', -0.8656, 0.1668),
  ('chair_back', 8, 'tilt_deg', 78.14, 2.92),
  ('chair_back', 8, 'width', -0.7012, 0.1165),
  ('chair_back', 8, 'z_max', 1.087, 0.04903),
  ('chair_back', 8, 'z_min', 0.4072, 0.04334);
INSERT INTO class_kind (class, kind, share, description) VALUES ('chair_back', 9, 0.05599, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('chair_back', 9, 'area_m2', -1.227, 0.2096),
  ('chair_back', 9, 'aspect', 0.7005, 0.1555),
  ('chair_back', 9, 'behind', 0.5978, 0.2215),
  ('chair_back', 9, 'edge_free', 0.8567, 0.1012),
  ('chair_back', 9, 'edge_free_top', 0.975, 0.04079),
  ('chair_back', 9, 'edge_joined', 0.07191, 0.06536),
  ('chair_back', 9, 'height', 0.7653, 0.0755),
  ('chair_back', 9, 'length', -0.0165, 0.1153),
  ('chair_back', 9, 'rectangularity', 0.6192, 0.09195),
  ('chair_back', 9, 'spread_length', -0.4015, 0.1354),
  ('chair_back', 9, 'spread_width', -0.8957, 0.1445),
  ('chair_back', 9, 'tilt_deg', 82.37, 3.053),
  ('chair_back', 9, 'width', -0.717, 0.1241),
  ('chair_back', 9, 'z_max', 1.007, 0.09128),
  ('chair_back', 9, 'z_min', 0.05657, 0.07283);

-- door: 185 examples
UPDATE object_class SET prior = 0.01432 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.214, 0.6309)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.7977, 0.3339)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.2167, 0.2692)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free', 0.1994, 0.2643)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_free_top', 0.3105, 0.4076)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'edge_joined', 0.2168, 0.2716)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'height', 1.119, 0.2199)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'length', 0.637, 0.2831)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'rectangularity', 0.7863, 0.1388)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_length', 0.4692, 0.3146)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'spread_width', -0.3349, 0.4327)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'tilt_deg', 88.6, 4.118)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'width', -0.163, 0.3791)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_max', 2.015, 0.3711)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'z_min', 0.1094, 0.2516)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'door';
DELETE FROM class_density WHERE class = 'door';
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 1, 0.2619, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 1, 'area_m2', 0.519, 0.1248),
  ('door', 1, 'aspect', 0.806, 0.1179),
  ('door', 1, 'behind', 0.004033, 0.03),
  ('door', 1, 'edge_free', 0.003718, 0.03),
  ('door', 1, 'edge_free_top', 0.005776, 0.03457),
  ('door', 1, 'edge_joined', 0.1164, 0.1662),
  ('door', 1, 'height', 1.113, 0.08133),
  ('door', 1, 'length', 0.7175, 0.03454),
  ('door', 1, 'rectangularity', 0.8997, 0.07498),
  ('door', 1, 'spread_length', 0.6281, 0.09702),
  ('door', 1, 'spread_width', -0.1732, 0.0919),
  ('door', 1, 'tilt_deg', 89.96, 0.45),
  ('door', 1, 'width', -0.08844, 0.1167),
  ('door', 1, 'z_max', 2.055, 0.04859),
  ('door', 1, 'z_min', 0.006162, 0.0225);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 2, 0.1854, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 2, 'area_m2', 0.51, 0.1695),
  ('door', 2, 'aspect', 0.8192, 0.0864),
  ('door', 2, 'behind', 0.4656, 0.1386),
  ('door', 2, 'edge_free', 0.5219, 0.1445),
  ('door', 2, 'edge_free_top', 0.8869, 0.1023),
  ('door', 2, 'edge_joined', 0.1326, 0.1374),
  ('door', 2, 'height', 1.139, 0.08509),
  ('door', 2, 'length', 0.7883, 0.05102),
  ('door', 2, 'rectangularity', 0.7892, 0.1009),
  ('door', 2, 'spread_length', 0.5486, 0.1766),
  ('door', 2, 'spread_width', -0.1689, 0.1208),
  ('door', 2, 'tilt_deg', 89.95, 0.45),
  ('door', 2, 'width', -0.03095, 0.0817),
  ('door', 2, 'z_max', 2.186, 0.09893),
  ('door', 2, 'z_min', -0.007106, 0.02683);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 3, 0.09806, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 3, 'area_m2', 0.2039, 0.2136),
  ('door', 3, 'aspect', 0.6515, 0.2501),
  ('door', 3, 'behind', 0.01077, 0.03666),
  ('door', 3, 'edge_free', 0.00993, 0.03598),
  ('door', 3, 'edge_free_top', 0.01812, 0.05954),
  ('door', 3, 'edge_joined', 0.1499, 0.1765),
  ('door', 3, 'height', 1.286, 0.1573),
  ('door', 3, 'length', 0.5368, 0.187),
  ('door', 3, 'rectangularity', 0.813, 0.1078),
  ('door', 3, 'spread_length', 0.3397, 0.2044),
  ('door', 3, 'spread_width', -0.2435, 0.1658),
  ('door', 3, 'tilt_deg', 89.33, 1.278),
  ('door', 3, 'width', -0.1146, 0.1417),
  ('door', 3, 'z_max', 2.038, 0.1318),
  ('door', 3, 'z_min', 0.3102, 0.3195);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 4, 0.07772, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 4, 'area_m2', 0.5366, 0.1411),
  ('door', 4, 'aspect', 0.7759, 0.1167),
  ('door', 4, 'behind', 0.6118, 0.1195),
  ('door', 4, 'edge_free', 0.1744, 0.1325),
  ('door', 4, 'edge_free_top', 0.4924, 0.1576),
  ('door', 4, 'edge_joined', 0.7056, 0.2178),
  ('door', 4, 'height', 1.073, 0.07679),
  ('door', 4, 'length', 0.7808, 0.05896),
  ('door', 4, 'rectangularity', 0.7842, 0.07412),
  ('door', 4, 'spread_length', 0.6576, 0.1358),
  ('door', 4, 'spread_width', -0.007289, 0.1631),
  ('door', 4, 'tilt_deg', 89.11, 1.833),
  ('door', 4, 'width', 0.004951, 0.1119),
  ('door', 4, 'z_max', 2.159, 0.1109),
  ('door', 4, 'z_min', -0.001797, 0.03857);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 5, 0.06828, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 5, 'area_m2', -1.438, 0.5385),
  ('door', 5, 'aspect', 0.7923, 0.454),
  ('door', 5, 'behind', 0.126, 0.2056),
  ('door', 5, 'edge_free', 0.09123, 0.1275),
  ('door', 5, 'edge_free_top', 0.03874, 0.08338),
  ('door', 5, 'edge_joined', 0.2771, 0.1936),
  ('door', 5, 'height', 0.736, 0.4116),
  ('door', 5, 'length', -0.1515, 0.2671),
  ('door', 5, 'rectangularity', 0.7203, 0.1046),
  ('door', 5, 'spread_length', -0.2645, 0.2568),
  ('door', 5, 'spread_width', -1.182, 0.3877),
  ('door', 5, 'tilt_deg', 88.08, 1.796),
  ('door', 5, 'width', -0.9438, 0.3924),
  ('door', 5, 'z_max', 1.098, 0.4328),
  ('door', 5, 'z_min', 0.3091, 0.3903);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 6, 0.06823, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 6, 'area_m2', -0.05107, 0.1976),
  ('door', 6, 'aspect', 0.513, 0.1602),
  ('door', 6, 'behind', 0.5035, 0.2078),
  ('door', 6, 'edge_free', 0.4247, 0.2737),
  ('door', 6, 'edge_free_top', 0.5997, 0.259),
  ('door', 6, 'edge_joined', 0.4013, 0.3174),
  ('door', 6, 'height', 1.349, 0.1067),
  ('door', 6, 'length', 0.419, 0.1183),
  ('door', 6, 'rectangularity', 0.6983, 0.1079),
  ('door', 6, 'spread_length', 0.1, 0.1593),
  ('door', 6, 'spread_width', -0.2167, 0.15),
  ('door', 6, 'tilt_deg', 89.63, 1.049),
  ('door', 6, 'width', -0.09397, 0.09322),
  ('door', 6, 'z_max', 2.096, 0.1515),
  ('door', 6, 'z_min', 0.5416, 0.186);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 7, 0.05889, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 7, 'area_m2', -0.3689, 0.4362),
  ('door', 7, 'aspect', 1.448, 0.3228),
  ('door', 7, 'behind', 0.1202, 0.1494),
  ('door', 7, 'edge_free', 0.2895, 0.3131),
  ('door', 7, 'edge_free_top', 0.4819, 0.3857),
  ('door', 7, 'edge_joined', 0.1306, 0.1339),
  ('door', 7, 'height', 1.143, 0.09076),
  ('door', 7, 'length', 0.6894, 0.1203),
  ('door', 7, 'rectangularity', 0.7533, 0.1197),
  ('door', 7, 'spread_length', 0.5007, 0.1623),
  ('door', 7, 'spread_width', -0.9741, 0.3335),
  ('door', 7, 'tilt_deg', 89.87, 0.6795),
  ('door', 7, 'width', -0.7584, 0.3633),
  ('door', 7, 'z_max', 2.083, 0.1328),
  ('door', 7, 'z_min', 0.0744, 0.1307);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 8, 0.05847, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 8, 'area_m2', 0.8582, 0.2689),
  ('door', 8, 'aspect', 0.4147, 0.3024),
  ('door', 8, 'behind', 0.02037, 0.04695),
  ('door', 8, 'edge_free', 0.02192, 0.048),
  ('door', 8, 'edge_free_top', 0.03105, 0.07582),
  ('door', 8, 'edge_joined', 0.4081, 0.2082),
  ('door', 8, 'height', 1.175, 0.1636),
  ('door', 8, 'length', 0.8609, 0.1888),
  ('door', 8, 'rectangularity', 0.6476, 0.08866),
  ('door', 8, 'spread_length', 0.5836, 0.2677),
  ('door', 8, 'spread_width', 0.02011, 0.2059),
  ('door', 8, 'tilt_deg', 89.72, 0.7446),
  ('door', 8, 'width', 0.4462, 0.2551),
  ('door', 8, 'z_max', 2.393, 0.4375),
  ('door', 8, 'z_min', 0.02125, 0.05959);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 9, 0.04385, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 9, 'area_m2', -0.1519, 0.1598),
  ('door', 9, 'aspect', 1.279, 0.1546),
  ('door', 9, 'behind', 0.2471, 0.1261),
  ('door', 9, 'edge_free', 0.3519, 0.1308),
  ('door', 9, 'edge_free_top', 0.08177, 0.1052),
  ('door', 9, 'edge_joined', 0.06504, 0.07495),
  ('door', 9, 'height', 1.09, 0.1123),
  ('door', 9, 'length', 0.8068, 0.08761),
  ('door', 9, 'rectangularity', 0.621, 0.0583),
  ('door', 9, 'spread_length', 0.7356, 0.09756),
  ('door', 9, 'spread_width', -1.114, 0.1515),
  ('door', 9, 'tilt_deg', 78.32, 1.323),
  ('door', 9, 'width', -0.4718, 0.147),
  ('door', 9, 'z_max', 1.988, 0.1745),
  ('door', 9, 'z_min', 0.008731, 0.05094);
INSERT INTO class_kind (class, kind, share, description) VALUES ('door', 10, 0.02923, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('door', 10, 'area_m2', -0.3312, 0.2317),
  ('door', 10, 'aspect', 0.6016, 0.1513),
  ('door', 10, 'behind', 0.2729, 0.0797),
  ('door', 10, 'edge_free', 0.2791, 0.06782),
  ('door', 10, 'edge_free_top', 0.0621, 0.1009),
  ('door', 10, 'edge_joined', 0.04032, 0.06313),
  ('door', 10, 'height', 0.799, 0.2068),
  ('door', 10, 'length', 0.4112, 0.1226),
  ('door', 10, 'rectangularity', 0.6033, 0.1285),
  ('door', 10, 'spread_length', 0.3233, 0.08136),
  ('door', 10, 'spread_width', -0.6197, 0.14),
  ('door', 10, 'tilt_deg', 73.39, 2.896),
  ('door', 10, 'width', -0.1903, 0.09208),
  ('door', 10, 'z_max', 1.28, 0.2462),
  ('door', 10, 'z_min', 0.2779, 0.2226);

-- window: 367 examples
UPDATE object_class SET prior = 0.02838 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', -0.04038, 0.7221)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.3677, 0.3574)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 7.715e-05, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free', 0.03017, 0.08594)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_free_top', 0.006746, 0.03423)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'edge_joined', 0.1655, 0.2415)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.527, 0.1716)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.2551, 0.2904)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8455, 0.1351)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.2837, 0.3227)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.1864, 0.529)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.58, 0.6346)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.1155, 0.4371)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_max', 2.125, 0.1899)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'z_min', 0.96, 0.1903)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'window';
DELETE FROM class_density WHERE class = 'window';
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 1, 0.2084, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 1, 'area_m2', 0.5235, 0.1265),
  ('window', 1, 'aspect', 0.2037, 0.1235),
  ('window', 1, 'behind', 5.464e-05, 0.03),
  ('window', 1, 'edge_free', 0.0009926, 0.03),
  ('window', 1, 'edge_free_top', 0.0004406, 0.03),
  ('window', 1, 'edge_joined', 0.02764, 0.0435),
  ('window', 1, 'height', 1.552, 0.116),
  ('window', 1, 'length', 0.3946, 0.07554),
  ('window', 1, 'rectangularity', 0.9413, 0.04501),
  ('window', 1, 'spread_length', 0.4641, 0.08883),
  ('window', 1, 'spread_width', 0.2283, 0.1132),
  ('window', 1, 'tilt_deg', 89.71, 0.45),
  ('window', 1, 'width', 0.1908, 0.1013),
  ('window', 1, 'z_max', 2.207, 0.1312),
  ('window', 1, 'z_min', 0.9026, 0.05359);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 2, 0.1557, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 2, 'area_m2', 0.1489, 0.2536),
  ('window', 2, 'aspect', 0.3454, 0.182),
  ('window', 2, 'behind', 7.314e-05, 0.03),
  ('window', 2, 'edge_free', 0.003616, 0.03),
  ('window', 2, 'edge_free_top', 0.001389, 0.03),
  ('window', 2, 'edge_joined', 0.1449, 0.1468),
  ('window', 2, 'height', 1.55, 0.1406),
  ('window', 2, 'length', 0.3494, 0.07331),
  ('window', 2, 'rectangularity', 0.8283, 0.1344),
  ('window', 2, 'spread_length', 0.3959, 0.1403),
  ('window', 2, 'spread_width', -0.03294, 0.1771),
  ('window', 2, 'tilt_deg', 89.67, 0.45),
  ('window', 2, 'width', 0.004059, 0.1994),
  ('window', 2, 'z_max', 2.281, 0.08419),
  ('window', 2, 'z_min', 0.8938, 0.05699);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 3, 0.1414, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 3, 'area_m2', 0.2188, 0.1226),
  ('window', 3, 'aspect', 0.1347, 0.08539),
  ('window', 3, 'behind', 8.05e-05, 0.03),
  ('window', 3, 'edge_free', 0.005031, 0.03),
  ('window', 3, 'edge_free_top', 0.00124, 0.03),
  ('window', 3, 'edge_joined', 0.07116, 0.1071),
  ('window', 3, 'height', 1.497, 0.08316),
  ('window', 3, 'length', 0.2238, 0.05249),
  ('window', 3, 'rectangularity', 0.9128, 0.06317),
  ('window', 3, 'spread_length', 0.3042, 0.088),
  ('window', 3, 'spread_width', 0.1042, 0.1093),
  ('window', 3, 'tilt_deg', 89.56, 0.5587),
  ('window', 3, 'width', 0.08913, 0.08282),
  ('window', 3, 'z_max', 2.07, 0.07459),
  ('window', 3, 'z_min', 0.8802, 0.05355);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 4, 0.08793, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 4, 'area_m2', -0.3755, 0.2833),
  ('window', 4, 'aspect', 0.3235, 0.2351),
  ('window', 4, 'behind', 0.0001295, 0.03),
  ('window', 4, 'edge_free', 0.001561, 0.03),
  ('window', 4, 'edge_free_top', 0.001859, 0.03),
  ('window', 4, 'edge_joined', 0.282, 0.2298),
  ('window', 4, 'height', 1.373, 0.1636),
  ('window', 4, 'length', 0.141, 0.1242),
  ('window', 4, 'rectangularity', 0.7404, 0.1624),
  ('window', 4, 'spread_length', 0.119, 0.1402),
  ('window', 4, 'spread_width', -0.3933, 0.1898),
  ('window', 4, 'tilt_deg', 89.36, 0.6402),
  ('window', 4, 'width', -0.1825, 0.2104),
  ('window', 4, 'z_max', 1.987, 0.1526),
  ('window', 4, 'z_min', 0.9038, 0.0656);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 5, 0.08003, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 5, 'area_m2', -0.07111, 0.1231),
  ('window', 5, 'aspect', 0.1233, 0.08778),
  ('window', 5, 'behind', 0.0001423, 0.03),
  ('window', 5, 'edge_free', 0.00888, 0.03),
  ('window', 5, 'edge_free_top', 0.002638, 0.03),
  ('window', 5, 'edge_joined', 0.03846, 0.05435),
  ('window', 5, 'height', 1.492, 0.06888),
  ('window', 5, 'length', 0.07179, 0.06334),
  ('window', 5, 'rectangularity', 0.9143, 0.04347),
  ('window', 5, 'spread_length', 0.192, 0.1347),
  ('window', 5, 'spread_width', -0.07112, 0.1748),
  ('window', 5, 'tilt_deg', 89.61, 0.5775),
  ('window', 5, 'width', -0.05155, 0.08474),
  ('window', 5, 'z_max', 2.014, 0.06964),
  ('window', 5, 'z_min', 0.9639, 0.05001);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 6, 0.07558, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 6, 'area_m2', -0.9397, 0.7051),
  ('window', 6, 'aspect', 0.5428, 0.2864),
  ('window', 6, 'behind', 0.0001507, 0.03),
  ('window', 6, 'edge_free', 0.1492, 0.1288),
  ('window', 6, 'edge_free_top', 0.004175, 0.03),
  ('window', 6, 'edge_joined', 0.6182, 0.2446),
  ('window', 6, 'height', 1.791, 0.1208),
  ('window', 6, 'length', -0.06133, 0.3405),
  ('window', 6, 'rectangularity', 0.7676, 0.09566),
  ('window', 6, 'spread_length', -0.1776, 0.3798),
  ('window', 6, 'spread_width', -0.8281, 0.3705),
  ('window', 6, 'tilt_deg', 89.73, 0.45),
  ('window', 6, 'width', -0.6042, 0.3462),
  ('window', 6, 'z_max', 2.14, 0.1404),
  ('window', 6, 'z_min', 1.472, 0.1374);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 7, 0.06879, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 7, 'area_m2', -1.139, 0.3795),
  ('window', 7, 'aspect', 1.137, 0.2897),
  ('window', 7, 'behind', 0.0001655, 0.03),
  ('window', 7, 'edge_free', 0.002723, 0.03),
  ('window', 7, 'edge_free_top', 0.0004665, 0.03),
  ('window', 7, 'edge_joined', 0.1572, 0.2005),
  ('window', 7, 'height', 1.493, 0.2043),
  ('window', 7, 'length', 0.1438, 0.09739),
  ('window', 7, 'rectangularity', 0.7578, 0.1031),
  ('window', 7, 'spread_length', 0.09031, 0.1485),
  ('window', 7, 'spread_width', -1.234, 0.3566),
  ('window', 7, 'tilt_deg', 89.35, 0.7762),
  ('window', 7, 'width', -0.9935, 0.2807),
  ('window', 7, 'z_max', 2.083, 0.113),
  ('window', 7, 'z_min', 0.9782, 0.2531);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 8, 0.06251, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 8, 'area_m2', -0.1063, 0.364),
  ('window', 8, 'aspect', 0.3316, 0.2023),
  ('window', 8, 'behind', 0.0008154, 0.03),
  ('window', 8, 'edge_free', 0.2011, 0.1376),
  ('window', 8, 'edge_free_top', 0.08913, 0.1114),
  ('window', 8, 'edge_joined', 0.3473, 0.2997),
  ('window', 8, 'height', 1.605, 0.1267),
  ('window', 8, 'length', 0.2971, 0.1129),
  ('window', 8, 'rectangularity', 0.7221, 0.1632),
  ('window', 8, 'spread_length', 0.2831, 0.1808),
  ('window', 8, 'spread_width', -0.2569, 0.2376),
  ('window', 8, 'tilt_deg', 89.8, 0.45),
  ('window', 8, 'width', -0.03445, 0.2045),
  ('window', 8, 'z_max', 2.181, 0.1135),
  ('window', 8, 'z_min', 1.025, 0.1769);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 9, 0.03514, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 9, 'area_m2', 1.266, 0.3445),
  ('window', 9, 'aspect', 0.8159, 0.3523),
  ('window', 9, 'behind', 0.000324, 0.03),
  ('window', 9, 'edge_free', 0.00538, 0.03),
  ('window', 9, 'edge_free_top', 0.0005331, 0.03),
  ('window', 9, 'edge_joined', 0.07745, 0.08406),
  ('window', 9, 'height', 1.535, 0.05802),
  ('window', 9, 'length', 1.144, 0.2949),
  ('window', 9, 'rectangularity', 0.8288, 0.1324),
  ('window', 9, 'spread_length', 1.105, 0.3073),
  ('window', 9, 'spread_width', 0.3174, 0.1387),
  ('window', 9, 'tilt_deg', 89.84, 0.45),
  ('window', 9, 'width', 0.3285, 0.1999),
  ('window', 9, 'z_max', 2.262, 0.1831),
  ('window', 9, 'z_min', 0.7872, 0.204);
INSERT INTO class_kind (class, kind, share, description) VALUES ('window', 10, 0.03451, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('window', 10, 'area_m2', -1.6, 0.7774),
  ('window', 10, 'aspect', 0.827, 0.4159),
  ('window', 10, 'behind', 0.1203, 0.2167),
  ('window', 10, 'edge_free', 0.09859, 0.1627),
  ('window', 10, 'edge_free_top', 0.0009293, 0.03),
  ('window', 10, 'edge_joined', 0.2792, 0.2414),
  ('window', 10, 'height', 1.219, 0.1791),
  ('window', 10, 'length', -0.2325, 0.4657),
  ('window', 10, 'rectangularity', 0.7433, 0.09733),
  ('window', 10, 'spread_length', -0.2653, 0.4752),
  ('window', 10, 'spread_width', -1.272, 0.4375),
  ('window', 10, 'tilt_deg', 86.79, 3.928),
  ('window', 10, 'width', -1.06, 0.3906),
  ('window', 10, 'z_max', 1.577, 0.2758),
  ('window', 10, 'z_min', 0.9101, 0.1574);

-- whiteboard: 183 examples
UPDATE object_class SET prior = 0.01414 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.1067, 0.9893)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.4106, 0.2992)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.0006853, 0.005352)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free', 0.02935, 0.05553)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_free_top', 0.03529, 0.0611)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'edge_joined', 0.7316, 0.2615)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.42, 0.1844)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.3838, 0.5043)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.7923, 0.1003)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.2142, 0.4843)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.2934, 0.5083)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.75, 0.5925)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', -0.0321, 0.5425)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 2.041, 0.3482)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.834, 0.2982)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'whiteboard';
DELETE FROM class_density WHERE class = 'whiteboard';
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 1, 0.2101, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 1, 'area_m2', 0.2345, 0.1705),
  ('whiteboard', 1, 'aspect', 0.1576, 0.1008),
  ('whiteboard', 1, 'behind', 0.002939, 0.03),
  ('whiteboard', 1, 'edge_free', 0.02294, 0.03),
  ('whiteboard', 1, 'edge_free_top', 0.0202, 0.03),
  ('whiteboard', 1, 'edge_joined', 0.8627, 0.1048),
  ('whiteboard', 1, 'height', 1.472, 0.06666),
  ('whiteboard', 1, 'length', 0.2813, 0.105),
  ('whiteboard', 1, 'rectangularity', 0.8449, 0.04775),
  ('whiteboard', 1, 'spread_length', 0.168, 0.1147),
  ('whiteboard', 1, 'spread_width', -0.06538, 0.09432),
  ('whiteboard', 1, 'tilt_deg', 89.96, 0.45),
  ('whiteboard', 1, 'width', 0.1237, 0.09427),
  ('whiteboard', 1, 'z_max', 2.066, 0.1018),
  ('whiteboard', 1, 'z_min', 0.8726, 0.06161);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 2, 0.1971, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 2, 'area_m2', 0.6806, 0.1929),
  ('whiteboard', 2, 'aspect', 0.5277, 0.1328),
  ('whiteboard', 2, 'behind', 7.948e-05, 0.03),
  ('whiteboard', 2, 'edge_free', 0.01494, 0.03),
  ('whiteboard', 2, 'edge_free_top', 0.0135, 0.03),
  ('whiteboard', 2, 'edge_joined', 0.8485, 0.109),
  ('whiteboard', 2, 'height', 1.43, 0.07768),
  ('whiteboard', 2, 'length', 0.6986, 0.1287),
  ('whiteboard', 2, 'rectangularity', 0.8314, 0.07064),
  ('whiteboard', 2, 'spread_length', 0.5412, 0.1284),
  ('whiteboard', 2, 'spread_width', -0.09752, 0.1289),
  ('whiteboard', 2, 'tilt_deg', 89.96, 0.45),
  ('whiteboard', 2, 'width', 0.171, 0.09993),
  ('whiteboard', 2, 'z_max', 2.059, 0.1053),
  ('whiteboard', 2, 'z_min', 0.854, 0.06065);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 3, 0.1077, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 3, 'area_m2', -1.984, 0.5888),
  ('whiteboard', 3, 'aspect', 0.5459, 0.4049),
  ('whiteboard', 3, 'behind', 0.0001454, 0.03),
  ('whiteboard', 3, 'edge_free', 0.01199, 0.03),
  ('whiteboard', 3, 'edge_free_top', 0.02684, 0.05282),
  ('whiteboard', 3, 'edge_joined', 0.8385, 0.1928),
  ('whiteboard', 3, 'height', 1.519, 0.2426),
  ('whiteboard', 3, 'length', -0.5832, 0.3874),
  ('whiteboard', 3, 'rectangularity', 0.7655, 0.06415),
  ('whiteboard', 3, 'spread_length', -0.7545, 0.3682),
  ('whiteboard', 3, 'spread_width', -1.348, 0.3106),
  ('whiteboard', 3, 'tilt_deg', 89.73, 0.45),
  ('whiteboard', 3, 'width', -1.129, 0.319),
  ('whiteboard', 3, 'z_max', 1.825, 0.2671),
  ('whiteboard', 3, 'z_min', 1.258, 0.3003);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 4, 0.09104, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 4, 'area_m2', 0.7157, 0.1972),
  ('whiteboard', 4, 'aspect', 0.5738, 0.1564),
  ('whiteboard', 4, 'behind', 0.0001721, 0.03),
  ('whiteboard', 4, 'edge_free', 0.07942, 0.03),
  ('whiteboard', 4, 'edge_free_top', 0.1025, 0.04207),
  ('whiteboard', 4, 'edge_joined', 0.783, 0.1011),
  ('whiteboard', 4, 'height', 1.448, 0.0662),
  ('whiteboard', 4, 'length', 0.7309, 0.1326),
  ('whiteboard', 4, 'rectangularity', 0.8435, 0.04213),
  ('whiteboard', 4, 'spread_length', 0.5805, 0.1477),
  ('whiteboard', 4, 'spread_width', -0.08445, 0.1517),
  ('whiteboard', 4, 'tilt_deg', 89.96, 0.45),
  ('whiteboard', 4, 'width', 0.157, 0.1178),
  ('whiteboard', 4, 'z_max', 2.048, 0.1182),
  ('whiteboard', 4, 'z_min', 0.8481, 0.06753);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 5, 0.08859, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 5, 'area_m2', 1.298, 0.4151),
  ('whiteboard', 5, 'aspect', 0.3579, 0.2113),
  ('whiteboard', 5, 'behind', 0.0001768, 0.03),
  ('whiteboard', 5, 'edge_free', 0.007238, 0.03),
  ('whiteboard', 5, 'edge_free_top', 0.0139, 0.03825),
  ('whiteboard', 5, 'edge_joined', 0.278, 0.1802),
  ('whiteboard', 5, 'height', 1.485, 0.08652),
  ('whiteboard', 5, 'length', 1.079, 0.2625),
  ('whiteboard', 5, 'rectangularity', 0.6195, 0.1141),
  ('whiteboard', 5, 'spread_length', 0.7343, 0.2359),
  ('whiteboard', 5, 'spread_width', 0.295, 0.2084),
  ('whiteboard', 5, 'tilt_deg', 89.72, 0.45),
  ('whiteboard', 5, 'width', 0.7213, 0.2552),
  ('whiteboard', 5, 'z_max', 2.74, 0.2879),
  ('whiteboard', 5, 'z_min', 0.343, 0.2877);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 6, 0.07228, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 6, 'area_m2', 0.1065, 0.2191),
  ('whiteboard', 6, 'aspect', 0.2062, 0.1673),
  ('whiteboard', 6, 'behind', 0.03155, 0.1054),
  ('whiteboard', 6, 'edge_free', 0.0175, 0.03),
  ('whiteboard', 6, 'edge_free_top', 0.02094, 0.03),
  ('whiteboard', 6, 'edge_joined', 0.758, 0.09885),
  ('whiteboard', 6, 'height', 1.352, 0.0961),
  ('whiteboard', 6, 'length', 0.3267, 0.1723),
  ('whiteboard', 6, 'rectangularity', 0.7163, 0.07211),
  ('whiteboard', 6, 'spread_length', 0.1114, 0.1801),
  ('whiteboard', 6, 'spread_width', -0.3878, 0.1757),
  ('whiteboard', 6, 'tilt_deg', 89.95, 0.45),
  ('whiteboard', 6, 'width', 0.1205, 0.1256),
  ('whiteboard', 6, 'z_max', 2.036, 0.112),
  ('whiteboard', 6, 'z_min', 0.8672, 0.08098);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 7, 0.05423, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 7, 'area_m2', -0.01309, 0.3795),
  ('whiteboard', 7, 'aspect', 0.4598, 0.3055),
  ('whiteboard', 7, 'behind', 0.0002889, 0.03),
  ('whiteboard', 7, 'edge_free', 0.003517, 0.03),
  ('whiteboard', 7, 'edge_free_top', 0.01816, 0.03),
  ('whiteboard', 7, 'edge_joined', 0.3711, 0.263),
  ('whiteboard', 7, 'height', 1.034, 0.2888),
  ('whiteboard', 7, 'length', 0.3383, 0.2668),
  ('whiteboard', 7, 'rectangularity', 0.7971, 0.05036),
  ('whiteboard', 7, 'spread_length', 0.2255, 0.2658),
  ('whiteboard', 7, 'spread_width', -0.296, 0.2363),
  ('whiteboard', 7, 'tilt_deg', 88.45, 0.67),
  ('whiteboard', 7, 'width', -0.1215, 0.2385),
  ('whiteboard', 7, 'z_max', 1.527, 0.4222),
  ('whiteboard', 7, 'z_min', 0.4519, 0.2671);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 8, 0.05416, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 8, 'area_m2', -0.4243, 0.215),
  ('whiteboard', 8, 'aspect', 0.5612, 0.1583),
  ('whiteboard', 8, 'behind', 0.0002893, 0.03),
  ('whiteboard', 8, 'edge_free', 0.03699, 0.04739),
  ('whiteboard', 8, 'edge_free_top', 0.01953, 0.03294),
  ('whiteboard', 8, 'edge_joined', 0.8434, 0.09202),
  ('whiteboard', 8, 'height', 1.457, 0.06682),
  ('whiteboard', 8, 'length', 0.177, 0.1054),
  ('whiteboard', 8, 'rectangularity', 0.8071, 0.04557),
  ('whiteboard', 8, 'spread_length', 0.002164, 0.1272),
  ('whiteboard', 8, 'spread_width', -0.5705, 0.1584),
  ('whiteboard', 8, 'tilt_deg', 89.93, 0.45),
  ('whiteboard', 8, 'width', -0.3842, 0.1523),
  ('whiteboard', 8, 'z_max', 2.035, 0.1024),
  ('whiteboard', 8, 'z_min', 0.919, 0.1024);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 9, 0.04478, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 9, 'area_m2', -0.82, 0.3683),
  ('whiteboard', 9, 'aspect', 0.8039, 0.4511),
  ('whiteboard', 9, 'behind', 0.0003499, 0.03),
  ('whiteboard', 9, 'edge_free', 0.004552, 0.03),
  ('whiteboard', 9, 'edge_free_top', 0.02352, 0.03),
  ('whiteboard', 9, 'edge_joined', 0.4651, 0.2003),
  ('whiteboard', 9, 'height', 1.23, 0.1364),
  ('whiteboard', 9, 'length', 0.1369, 0.3353),
  ('whiteboard', 9, 'rectangularity', 0.7599, 0.1068),
  ('whiteboard', 9, 'spread_length', -0.03874, 0.328),
  ('whiteboard', 9, 'spread_width', -0.8722, 0.2235),
  ('whiteboard', 9, 'tilt_deg', 88.4, 1.091),
  ('whiteboard', 9, 'width', -0.667, 0.2295),
  ('whiteboard', 9, 'z_max', 1.58, 0.2139),
  ('whiteboard', 9, 'z_min', 0.7782, 0.2554);
INSERT INTO class_kind (class, kind, share, description) VALUES ('whiteboard', 10, 0.02996, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('whiteboard', 10, 'area_m2', 0.1727, 0.3802),
  ('whiteboard', 10, 'aspect', 0.268, 0.1193),
  ('whiteboard', 10, 'behind', 0.0005229, 0.03),
  ('whiteboard', 10, 'edge_free', 0.2725, 0.07092),
  ('whiteboard', 10, 'edge_free_top', 0.2529, 0.06277),
  ('whiteboard', 10, 'edge_joined', 0.6294, 0.09524),
  ('whiteboard', 10, 'height', 1.431, 0.06788),
  ('whiteboard', 10, 'length', 0.3415, 0.1973),
  ('whiteboard', 10, 'rectangularity', 0.7901, 0.06843),
  ('whiteboard', 10, 'spread_length', 0.1816, 0.2258),
  ('whiteboard', 10, 'spread_width', -0.1563, 0.1727),
  ('whiteboard', 10, 'tilt_deg', 89.77, 0.45),
  ('whiteboard', 10, 'width', 0.07355, 0.158),
  ('whiteboard', 10, 'z_max', 2.034, 0.09697),
  ('whiteboard', 10, 'z_min', 0.8468, 0.06807);

-- shelf: 869 examples
UPDATE object_class SET prior = 0.06728 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.62, 0.8021)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.9081, 0.4444)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5424, 0.3302)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free', 0.3314, 0.1787)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_free_top', 0.4414, 0.3574)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'edge_joined', 0.2884, 0.2401)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.911, 0.5053)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.1635, 0.5399)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.6962, 0.131)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.3039, 0.5351)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.279, 0.3829)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 50.71, 43.48)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.075, 0.3535)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.188, 0.6312)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5876, 0.5882)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'shelf';
DELETE FROM class_density WHERE class = 'shelf';
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 1, 0.173, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 1, 'area_m2', -1.604, 0.4251),
  ('shelf', 1, 'aspect', 0.9413, 0.3171),
  ('shelf', 1, 'behind', 0.7526, 0.08),
  ('shelf', 1, 'edge_free', 0.3995, 0.07638),
  ('shelf', 1, 'edge_free_top', 0.4414, 0.1129),
  ('shelf', 1, 'edge_joined', 0.3677, 0.175),
  ('shelf', 1, 'height', 0.6362, 0.2212),
  ('shelf', 1, 'length', -0.1146, 0.2486),
  ('shelf', 1, 'rectangularity', 0.6604, 0.1243),
  ('shelf', 1, 'spread_length', -0.2554, 0.2582),
  ('shelf', 1, 'spread_width', -1.286, 0.3306),
  ('shelf', 1, 'tilt_deg', 2.807, 2.728),
  ('shelf', 1, 'width', -1.056, 0.2479),
  ('shelf', 1, 'z_max', 0.6474, 0.2214),
  ('shelf', 1, 'z_min', 0.628, 0.2219);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 2, 0.1219, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 2, 'area_m2', -1.35, 0.3781),
  ('shelf', 2, 'aspect', 1.103, 0.3687),
  ('shelf', 2, 'behind', 0.5853, 0.2895),
  ('shelf', 2, 'edge_free', 0.4016, 0.09976),
  ('shelf', 2, 'edge_free_top', 0.5383, 0.3245),
  ('shelf', 2, 'edge_joined', 0.188, 0.205),
  ('shelf', 2, 'height', 1.064, 0.2986),
  ('shelf', 2, 'length', 0.07288, 0.2496),
  ('shelf', 2, 'rectangularity', 0.6899, 0.1355),
  ('shelf', 2, 'spread_length', -0.1237, 0.2996),
  ('shelf', 2, 'spread_width', -1.214, 0.3073),
  ('shelf', 2, 'tilt_deg', 89.4, 2.625),
  ('shelf', 2, 'width', -1.03, 0.2395),
  ('shelf', 2, 'z_max', 1.566, 0.3576),
  ('shelf', 2, 'z_min', 0.4829, 0.3454);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 3, 0.1164, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 3, 'area_m2', -1.439, 0.4034),
  ('shelf', 3, 'aspect', 0.8025, 0.2729),
  ('shelf', 3, 'behind', 0.739, 0.1001),
  ('shelf', 3, 'edge_free', 0.3241, 0.1051),
  ('shelf', 3, 'edge_free_top', 0.4414, 0.1129),
  ('shelf', 3, 'edge_joined', 0.5214, 0.1974),
  ('shelf', 3, 'height', 1.747, 0.1997),
  ('shelf', 3, 'length', -0.1812, 0.2481),
  ('shelf', 3, 'rectangularity', 0.7738, 0.1276),
  ('shelf', 3, 'spread_length', -0.3012, 0.2631),
  ('shelf', 3, 'spread_width', -1.052, 0.2531),
  ('shelf', 3, 'tilt_deg', 2.028, 2.749),
  ('shelf', 3, 'width', -0.9837, 0.1628),
  ('shelf', 3, 'z_max', 1.754, 0.2005),
  ('shelf', 3, 'z_min', 1.738, 0.2014);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 4, 0.1157, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 4, 'area_m2', -0.5902, 0.2656),
  ('shelf', 4, 'aspect', 1.476, 0.17),
  ('shelf', 4, 'behind', 0.7013, 0.1588),
  ('shelf', 4, 'edge_free', 0.4144, 0.07044),
  ('shelf', 4, 'edge_free_top', 0.5772, 0.2808),
  ('shelf', 4, 'edge_joined', 0.2648, 0.2212),
  ('shelf', 4, 'height', 1.043, 0.106),
  ('shelf', 4, 'length', 0.6245, 0.1227),
  ('shelf', 4, 'rectangularity', 0.7073, 0.1219),
  ('shelf', 4, 'spread_length', 0.4764, 0.1577),
  ('shelf', 4, 'spread_width', -1.07, 0.1899),
  ('shelf', 4, 'tilt_deg', 89.53, 2.661),
  ('shelf', 4, 'width', -0.8515, 0.1688),
  ('shelf', 4, 'z_max', 1.914, 0.1972),
  ('shelf', 4, 'z_min', 0.03937, 0.08984);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 5, 0.09973, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 5, 'area_m2', -2.534, 0.681),
  ('shelf', 5, 'aspect', 0.6542, 0.4623),
  ('shelf', 5, 'behind', 0.007928, 0.03),
  ('shelf', 5, 'edge_free', 0.02124, 0.04464),
  ('shelf', 5, 'edge_free_top', 0.008438, 0.03),
  ('shelf', 5, 'edge_joined', 0.109, 0.1374),
  ('shelf', 5, 'height', 0.8182, 0.4968),
  ('shelf', 5, 'length', -0.7923, 0.4618),
  ('shelf', 5, 'rectangularity', 0.7558, 0.121),
  ('shelf', 5, 'spread_length', -0.8754, 0.4694),
  ('shelf', 5, 'spread_width', -1.641, 0.3451),
  ('shelf', 5, 'tilt_deg', 88.62, 3.102),
  ('shelf', 5, 'width', -1.447, 0.3544),
  ('shelf', 5, 'z_max', 0.9612, 0.508),
  ('shelf', 5, 'z_min', 0.6542, 0.4932);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 6, 0.09234, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 6, 'area_m2', -1.013, 0.2653),
  ('shelf', 6, 'aspect', 1.097, 0.217),
  ('shelf', 6, 'behind', 0.7631, 0.07716),
  ('shelf', 6, 'edge_free', 0.4046, 0.09067),
  ('shelf', 6, 'edge_free_top', 0.6329, 0.2097),
  ('shelf', 6, 'edge_joined', 0.2762, 0.2481),
  ('shelf', 6, 'height', 0.7341, 0.1628),
  ('shelf', 6, 'length', 0.2687, 0.138),
  ('shelf', 6, 'rectangularity', 0.6483, 0.1256),
  ('shelf', 6, 'spread_length', 0.1066, 0.1869),
  ('shelf', 6, 'spread_width', -1.091, 0.1927),
  ('shelf', 6, 'tilt_deg', 89.31, 3.012),
  ('shelf', 6, 'width', -0.8286, 0.1748),
  ('shelf', 6, 'z_max', 1.311, 0.1869),
  ('shelf', 6, 'z_min', 0.01059, 0.05468);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 7, 0.0804, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 7, 'area_m2', -2.634, 0.4632),
  ('shelf', 7, 'aspect', 0.6405, 0.4189),
  ('shelf', 7, 'behind', 0.5657, 0.2425),
  ('shelf', 7, 'edge_free', 0.3376, 0.1726),
  ('shelf', 7, 'edge_free_top', 0.2506, 0.1718),
  ('shelf', 7, 'edge_joined', 0.3088, 0.2357),
  ('shelf', 7, 'height', 0.7341, 0.4975),
  ('shelf', 7, 'length', -0.7862, 0.2807),
  ('shelf', 7, 'rectangularity', 0.6657, 0.106),
  ('shelf', 7, 'spread_length', -0.9252, 0.2651),
  ('shelf', 7, 'spread_width', -1.667, 0.3085),
  ('shelf', 7, 'tilt_deg', 29.3, 38.4),
  ('shelf', 7, 'width', -1.427, 0.3374),
  ('shelf', 7, 'z_max', 0.7945, 0.4849),
  ('shelf', 7, 'z_min', 0.6732, 0.5207);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 8, 0.07565, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 8, 'area_m2', -2.386, 0.6969),
  ('shelf', 8, 'aspect', 0.5907, 0.4043),
  ('shelf', 8, 'behind', 0.00775, 0.03),
  ('shelf', 8, 'edge_free', 0.2187, 0.1803),
  ('shelf', 8, 'edge_free_top', 0.4414, 0.1129),
  ('shelf', 8, 'edge_joined', 0.385, 0.2388),
  ('shelf', 8, 'height', 0.08384, 0.04296),
  ('shelf', 8, 'length', -0.7241, 0.4509),
  ('shelf', 8, 'rectangularity', 0.7137, 0.09577),
  ('shelf', 8, 'spread_length', -0.7951, 0.4613),
  ('shelf', 8, 'spread_width', -1.518, 0.338),
  ('shelf', 8, 'tilt_deg', 2.008, 3.454),
  ('shelf', 8, 'width', -1.315, 0.3694),
  ('shelf', 8, 'z_max', 0.09166, 0.05249),
  ('shelf', 8, 'z_min', 0.07557, 0.04771);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 9, 0.05116, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 9, 'area_m2', -2.083, 0.4339),
  ('shelf', 9, 'aspect', 0.6325, 0.3793),
  ('shelf', 9, 'behind', 0.5402, 0.2896),
  ('shelf', 9, 'edge_free', 0.533, 0.2661),
  ('shelf', 9, 'edge_free_top', 0.6896, 0.3321),
  ('shelf', 9, 'edge_joined', 0.05088, 0.05978),
  ('shelf', 9, 'height', 1.12, 0.2228),
  ('shelf', 9, 'length', -0.4855, 0.2618),
  ('shelf', 9, 'rectangularity', 0.6331, 0.1254),
  ('shelf', 9, 'spread_length', -0.7044, 0.2939),
  ('shelf', 9, 'spread_width', -1.391, 0.301),
  ('shelf', 9, 'tilt_deg', 88.31, 4.499),
  ('shelf', 9, 'width', -1.118, 0.2971),
  ('shelf', 9, 'z_max', 1.407, 0.2622),
  ('shelf', 9, 'z_min', 0.7912, 0.2397);
INSERT INTO class_kind (class, kind, share, description) VALUES ('shelf', 10, 0.02375, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('shelf', 10, 'area_m2', -0.7022, 0.3608),
  ('shelf', 10, 'aspect', 0.3328, 0.2674),
  ('shelf', 10, 'behind', 0.07403, 0.1567),
  ('shelf', 10, 'edge_free', 0.08004, 0.08641),
  ('shelf', 10, 'edge_free_top', 0.07878, 0.1069),
  ('shelf', 10, 'edge_joined', 0.1427, 0.1002),
  ('shelf', 10, 'height', 1.25, 0.1988),
  ('shelf', 10, 'length', 0.03026, 0.2172),
  ('shelf', 10, 'rectangularity', 0.666, 0.1167),
  ('shelf', 10, 'spread_length', -0.0846, 0.2303),
  ('shelf', 10, 'spread_width', -0.5069, 0.2171),
  ('shelf', 10, 'tilt_deg', 88.01, 5.755),
  ('shelf', 10, 'width', -0.3025, 0.235),
  ('shelf', 10, 'z_max', 1.704, 0.2692),
  ('shelf', 10, 'z_min', 0.7305, 0.2234);

-- cabinet: 1006 examples
UPDATE object_class SET prior = 0.07777 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.8812, 0.9717)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6551, 0.4305)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.4901, 0.2432)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free', 0.3736, 0.2723)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_free_top', 0.7447, 0.3223)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'edge_joined', 0.269, 0.3061)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7836, 0.3699)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.05603, 0.4976)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7311, 0.1311)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1131, 0.5011)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.8051, 0.5238)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 74.88, 33.2)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.6029, 0.4948)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.235, 0.5976)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.251, 0.3598)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_kind WHERE class = 'cabinet';
DELETE FROM class_density WHERE class = 'cabinet';
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 1, 0.134, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 1, 'area_m2', -0.5765, 0.7235),
  ('cabinet', 1, 'aspect', 0.8186, 0.5005),
  ('cabinet', 1, 'behind', 0.2856, 0.2275),
  ('cabinet', 1, 'edge_free', 0.5567, 0.31),
  ('cabinet', 1, 'edge_free_top', 0.9718, 0.05526),
  ('cabinet', 1, 'edge_joined', 0.02258, 0.0349),
  ('cabinet', 1, 'height', 1.115, 0.3296),
  ('cabinet', 1, 'length', 0.3031, 0.3298),
  ('cabinet', 1, 'rectangularity', 0.7144, 0.1561),
  ('cabinet', 1, 'spread_length', 0.08721, 0.3605),
  ('cabinet', 1, 'spread_width', -0.7406, 0.5276),
  ('cabinet', 1, 'tilt_deg', 89.59, 1.976),
  ('cabinet', 1, 'width', -0.5155, 0.4957),
  ('cabinet', 1, 'z_max', 1.716, 0.4745),
  ('cabinet', 1, 'z_min', 0.3556, 0.3639);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 2, 0.1284, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 2, 'area_m2', -1.126, 0.2355),
  ('cabinet', 2, 'aspect', 0.2752, 0.205),
  ('cabinet', 2, 'behind', 0.5985, 0.1581),
  ('cabinet', 2, 'edge_free', 0.3733, 0.2212),
  ('cabinet', 2, 'edge_free_top', 0.6259, 0.3281),
  ('cabinet', 2, 'edge_joined', 0.2383, 0.2707),
  ('cabinet', 2, 'height', 0.3634, 0.08442),
  ('cabinet', 2, 'length', -0.2169, 0.1603),
  ('cabinet', 2, 'rectangularity', 0.6674, 0.1045),
  ('cabinet', 2, 'spread_length', -0.4052, 0.1437),
  ('cabinet', 2, 'spread_width', -0.7817, 0.1631),
  ('cabinet', 2, 'tilt_deg', 89.66, 1.827),
  ('cabinet', 2, 'width', -0.4921, 0.1493),
  ('cabinet', 2, 'z_max', 0.7281, 0.1252),
  ('cabinet', 2, 'z_min', -0.01094, 0.02382);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 3, 0.1215, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 3, 'area_m2', -0.5992, 0.4407),
  ('cabinet', 3, 'aspect', 0.6642, 0.3441),
  ('cabinet', 3, 'behind', 0.5071, 0.2439),
  ('cabinet', 3, 'edge_free', 0.2472, 0.1976),
  ('cabinet', 3, 'edge_free_top', 0.6626, 0.2935),
  ('cabinet', 3, 'edge_joined', 0.4644, 0.287),
  ('cabinet', 3, 'height', 1.046, 0.3873),
  ('cabinet', 3, 'length', 0.1841, 0.3001),
  ('cabinet', 3, 'rectangularity', 0.7483, 0.1139),
  ('cabinet', 3, 'spread_length', -0.02771, 0.2758),
  ('cabinet', 3, 'spread_width', -0.6435, 0.2588),
  ('cabinet', 3, 'tilt_deg', 89.72, 1.909),
  ('cabinet', 3, 'width', -0.4802, 0.2495),
  ('cabinet', 3, 'z_max', 1.598, 0.4763),
  ('cabinet', 3, 'z_min', 0.3994, 0.4242);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 4, 0.1141, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 4, 'area_m2', -2.266, 0.6256),
  ('cabinet', 4, 'aspect', 0.7869, 0.4807),
  ('cabinet', 4, 'behind', 0.5442, 0.2236),
  ('cabinet', 4, 'edge_free', 0.2044, 0.1805),
  ('cabinet', 4, 'edge_free_top', 0.3644, 0.3317),
  ('cabinet', 4, 'edge_joined', 0.1918, 0.2087),
  ('cabinet', 4, 'height', 0.3459, 0.1903),
  ('cabinet', 4, 'length', -0.5116, 0.421),
  ('cabinet', 4, 'rectangularity', 0.6464, 0.1188),
  ('cabinet', 4, 'spread_length', -0.6878, 0.3999),
  ('cabinet', 4, 'spread_width', -1.57, 0.3162),
  ('cabinet', 4, 'tilt_deg', 89.09, 2.192),
  ('cabinet', 4, 'width', -1.299, 0.3469),
  ('cabinet', 4, 'z_max', 0.574, 0.24),
  ('cabinet', 4, 'z_min', 0.1009, 0.1792);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 5, 0.1032, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 5, 'area_m2', 0.3927, 0.2752),
  ('cabinet', 5, 'aspect', 0.6825, 0.2646),
  ('cabinet', 5, 'behind', 0.2987, 0.1659),
  ('cabinet', 5, 'edge_free', 0.5773, 0.2061),
  ('cabinet', 5, 'edge_free_top', 0.965, 0.05504),
  ('cabinet', 5, 'edge_joined', 0.04594, 0.05899),
  ('cabinet', 5, 'height', 1.037, 0.1044),
  ('cabinet', 5, 'length', 0.6216, 0.08532),
  ('cabinet', 5, 'rectangularity', 0.8503, 0.08679),
  ('cabinet', 5, 'spread_length', 0.5109, 0.1242),
  ('cabinet', 5, 'spread_width', -0.2261, 0.2621),
  ('cabinet', 5, 'tilt_deg', 89.81, 2.003),
  ('cabinet', 5, 'width', -0.06091, 0.2589),
  ('cabinet', 5, 'z_max', 1.871, 0.1432),
  ('cabinet', 5, 'z_min', 0.008696, 0.04759);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 6, 0.08986, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 6, 'area_m2', -0.08097, 0.3091),
  ('cabinet', 6, 'aspect', 1.163, 0.2956),
  ('cabinet', 6, 'behind', 0.5261, 0.2127),
  ('cabinet', 6, 'edge_free', 0.2135, 0.188),
  ('cabinet', 6, 'edge_free_top', 0.7415, 0.2318),
  ('cabinet', 6, 'edge_joined', 0.4988, 0.3119),
  ('cabinet', 6, 'height', 1.035, 0.1127),
  ('cabinet', 6, 'length', 0.6655, 0.1019),
  ('cabinet', 6, 'rectangularity', 0.7853, 0.09081),
  ('cabinet', 6, 'spread_length', 0.5192, 0.1216),
  ('cabinet', 6, 'spread_width', -0.6789, 0.2857),
  ('cabinet', 6, 'tilt_deg', 89.82, 2.115),
  ('cabinet', 6, 'width', -0.4971, 0.2749),
  ('cabinet', 6, 'z_max', 1.952, 0.1949),
  ('cabinet', 6, 'z_min', 0.00317, 0.04236);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 7, 0.08525, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 7, 'area_m2', -0.9236, 0.4082),
  ('cabinet', 7, 'aspect', 0.5979, 0.311),
  ('cabinet', 7, 'behind', 0.6673, 0.1586),
  ('cabinet', 7, 'edge_free', 0.168, 0.1236),
  ('cabinet', 7, 'edge_free_top', 0.7447, 0.1019),
  ('cabinet', 7, 'edge_joined', 0.7592, 0.1574),
  ('cabinet', 7, 'height', 0.9076, 0.1401),
  ('cabinet', 7, 'length', 0.02225, 0.3048),
  ('cabinet', 7, 'rectangularity', 0.6963, 0.0854),
  ('cabinet', 7, 'spread_length', -0.1537, 0.2825),
  ('cabinet', 7, 'spread_width', -0.668, 0.206),
  ('cabinet', 7, 'tilt_deg', 1.266, 2.355),
  ('cabinet', 7, 'width', -0.5757, 0.151),
  ('cabinet', 7, 'z_max', 0.9154, 0.144),
  ('cabinet', 7, 'z_min', 0.8994, 0.1399);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 8, 0.07699, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 8, 'area_m2', -0.2297, 0.2965),
  ('cabinet', 8, 'aspect', 0.305, 0.1988),
  ('cabinet', 8, 'behind', 0.464, 0.1413),
  ('cabinet', 8, 'edge_free', 0.5659, 0.1508),
  ('cabinet', 8, 'edge_free_top', 0.9709, 0.05029),
  ('cabinet', 8, 'edge_joined', 0.0742, 0.1114),
  ('cabinet', 8, 'height', 0.5657, 0.1152),
  ('cabinet', 8, 'length', 0.1358, 0.1542),
  ('cabinet', 8, 'rectangularity', 0.8264, 0.08302),
  ('cabinet', 8, 'spread_length', 0.03497, 0.1459),
  ('cabinet', 8, 'spread_width', -0.3102, 0.2032),
  ('cabinet', 8, 'tilt_deg', 89.61, 2.435),
  ('cabinet', 8, 'width', -0.1692, 0.1901),
  ('cabinet', 8, 'z_max', 1.014, 0.1619),
  ('cabinet', 8, 'z_min', -0.003326, 0.0327);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 9, 0.06343, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 9, 'area_m2', -2.225, 0.5466),
  ('cabinet', 9, 'aspect', 0.555, 0.3473),
  ('cabinet', 9, 'behind', 0.6903, 0.1437),
  ('cabinet', 9, 'edge_free', 0.3382, 0.1995),
  ('cabinet', 9, 'edge_free_top', 0.7447, 0.1019),
  ('cabinet', 9, 'edge_joined', 0.2575, 0.1744),
  ('cabinet', 9, 'height', 0.5834, 0.02975),
  ('cabinet', 9, 'length', -0.6734, 0.2387),
  ('cabinet', 9, 'rectangularity', 0.7346, 0.1182),
  ('cabinet', 9, 'spread_length', -0.8007, 0.2537),
  ('cabinet', 9, 'spread_width', -1.417, 0.3973),
  ('cabinet', 9, 'tilt_deg', 1.856, 2.822),
  ('cabinet', 9, 'width', -1.228, 0.4069),
  ('cabinet', 9, 'z_max', 0.5927, 0.04722),
  ('cabinet', 9, 'z_min', 0.573, 0.02945);
INSERT INTO class_kind (class, kind, share, description) VALUES ('cabinet', 10, 0.0331, '');
INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES
  ('cabinet', 10, 'area_m2', -2.353, 0.533),
  ('cabinet', 10, 'aspect', 0.7044, 0.3002),
  ('cabinet', 10, 'behind', 0.3726, 0.2761),
  ('cabinet', 10, 'edge_free', 0.6411, 0.2816),
  ('cabinet', 10, 'edge_free_top', 0.9369, 0.09447),
  ('cabinet', 10, 'edge_joined', 0.2194, 0.2051),
  ('cabinet', 10, 'height', 0.7658, 0.182),
  ('cabinet', 10, 'length', -0.5607, 0.2783),
  ('cabinet', 10, 'rectangularity', 0.6017, 0.1056),
  ('cabinet', 10, 'spread_length', -0.7442, 0.2709),
  ('cabinet', 10, 'spread_width', -1.527, 0.2357),
  ('cabinet', 10, 'tilt_deg', 62.69, 38.09),
  ('cabinet', 10, 'width', -1.265, 0.2807),
  ('cabinet', 10, 'z_max', 0.8941, 0.1964),
  ('cabinet', 10, 'z_min', 0.5805, 0.2462);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.0355 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.497 WHERE name = 'aspect';
UPDATE feature SET weight = 0.497 WHERE name = 'edge_free';
UPDATE feature SET weight = 0.337 WHERE name = 'edge_free_top';
UPDATE feature SET weight = 0.233 WHERE name = 'edge_joined';
UPDATE feature SET weight = 0.339 WHERE name = 'height';
UPDATE feature SET weight = 0.0496 WHERE name = 'length';
UPDATE feature SET weight = 0.5 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.328 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.255 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.379 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.163 WHERE name = 'width';
UPDATE feature SET weight = 0.36 WHERE name = 'z_max';
UPDATE feature SET weight = 0.34 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.258 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0803 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0332 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.11 WHERE name = 'wall';
UPDATE object_class SET prior = 0.0186 WHERE name = 'table';
UPDATE object_class SET prior = 0.0346 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.176 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.0077 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0485 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.014 WHERE name = 'door';
UPDATE object_class SET prior = 0.0126 WHERE name = 'window';
UPDATE object_class SET prior = 0.00895 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0872 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.111 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 2.83 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.321 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 1.84 WHERE name = 'one_floor_level';
UPDATE class_constraint SET weight = 3.08 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 3.21 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 1.51 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 0.329 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.135 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 0.644 WHERE name = 'wall_at_corner';
UPDATE class_constraint SET weight = 0.804 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.79 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.18 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.451 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.84 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.375 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 2.98 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 4.45 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.38 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.274 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.0167 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 3.02 WHERE name = 'seat_not_on_table';
UPDATE class_constraint SET weight = 1.25 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.71 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.13 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 2.07 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 1.86 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 0.237 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 0.901 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 1.32 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.61 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 1.56 WHERE name = 'cabinet_of_faces';
UPDATE class_constraint SET weight = 0.0327 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.22 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 2249 planes of 48 paper-like rooms, seeds from 8001, half of them at 2 cm.
UPDATE setting SET value = '0.868' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.159' WHERE key = 'probability_offset';
