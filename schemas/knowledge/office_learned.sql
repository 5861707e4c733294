-- Learned by `make knowledge` (tools/bench/learn_office.cpp) from simulated scans at 1 cm range noise, varied rooms at 1 or 2 cm.
-- Densities and Gaussians: 5639 planes of 42 paper-like rooms, seeds from 1; 36 varied rooms, seeds from 301; 54 depth-camera frames, seeds from 101.
-- Priors and weights: 24 paper-like rooms, seeds from 11; 18 varied rooms, seeds from 401; 27 depth-camera frames, seeds from 201.

-- unknown: 2506 examples
UPDATE object_class SET prior = 0.5218 WHERE name = 'unknown';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'area_m2', -1.983, 1.237)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'aspect', 0.6068, 0.4913)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'behind', 0.4416, 0.2893)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'height', 0.9792, 0.6643)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'length', -0.4994, 0.7086)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'rectangularity', 0.7033, 0.1398)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_length', -0.6271, 0.7205)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'spread_width', -1.314, 0.6191)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'tilt_deg', 64.91, 36.25)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'width', -1.109, 0.6235)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_max', 1.227, 0.8283)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('unknown', 'z_min', 0.718, 0.7053)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'area_m2', 0.002, 0.0155015, 0.00353),
  ('unknown', 'area_m2', 0.0155015, 0.0329804, 0.1388),
  ('unknown', 'area_m2', 0.0329804, 0.0343339, 0.1869),
  ('unknown', 'area_m2', 0.0343339, 0.0546311, 0.2243),
  ('unknown', 'area_m2', 0.0546311, 0.0749793, 0.3465),
  ('unknown', 'area_m2', 0.0749793, 0.100766, 0.3767),
  ('unknown', 'area_m2', 0.100766, 0.144626, 0.3058),
  ('unknown', 'area_m2', 0.144626, 0.16843, 0.2493),
  ('unknown', 'area_m2', 0.16843, 0.22106, 0.2685),
  ('unknown', 'area_m2', 0.22106, 0.31129, 0.3219),
  ('unknown', 'area_m2', 0.31129, 0.37305, 0.2506),
  ('unknown', 'area_m2', 0.37305, 0.533397, 0.1891),
  ('unknown', 'area_m2', 0.533397, 0.826256, 0.1263),
  ('unknown', 'area_m2', 0.826256, 1.83005, 0.03619),
  ('unknown', 'area_m2', 1.83005, 4.05332, 0.007368),
  ('unknown', 'area_m2', 4.05332, 8.97757, 0.005923),
  ('unknown', 'area_m2', 8.97757, 19.8841, 0.008452),
  ('unknown', 'area_m2', 19.8841, 100, 0.005726);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'aspect', 1, 1.10722, 1.1),
  ('unknown', 'aspect', 1.10722, 1.22469, 1.076),
  ('unknown', 'aspect', 1.22469, 1.25076, 0.988),
  ('unknown', 'aspect', 1.25076, 1.36475, 1.066),
  ('unknown', 'aspect', 1.36475, 1.52643, 0.9788),
  ('unknown', 'aspect', 1.52643, 1.5644, 0.9536),
  ('unknown', 'aspect', 1.5644, 1.72303, 0.9008),
  ('unknown', 'aspect', 1.72303, 1.9567, 0.7574),
  ('unknown', 'aspect', 1.9567, 1.99925, 0.7339),
  ('unknown', 'aspect', 1.99925, 2.42004, 0.587),
  ('unknown', 'aspect', 2.42004, 2.44736, 0.4115),
  ('unknown', 'aspect', 2.44736, 3.06106, 0.2936),
  ('unknown', 'aspect', 3.06106, 3.82866, 0.1665),
  ('unknown', 'aspect', 3.82866, 3.90245, 0.1563),
  ('unknown', 'aspect', 3.90245, 4.78873, 0.168),
  ('unknown', 'aspect', 4.78873, 5.98956, 0.2045),
  ('unknown', 'aspect', 5.98956, 7.49151, 0.09076),
  ('unknown', 'aspect', 7.49151, 100, 0.004025);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'behind', 0, 0.0971274, 2.242),
  ('unknown', 'behind', 0.0971274, 0.105263, 0.4807),
  ('unknown', 'behind', 0.105263, 0.194255, 0.4348),
  ('unknown', 'behind', 0.194255, 0.291382, 0.7018),
  ('unknown', 'behind', 0.291382, 0.297297, 0.7897),
  ('unknown', 'behind', 0.297297, 0.38851, 0.6275),
  ('unknown', 'behind', 0.38851, 0.4475, 0.9185),
  ('unknown', 'behind', 0.4475, 0.485637, 1.073),
  ('unknown', 'behind', 0.485637, 0.550847, 1.072),
  ('unknown', 'behind', 0.550847, 0.582764, 1.114),
  ('unknown', 'behind', 0.582764, 0.638009, 1.387),
  ('unknown', 'behind', 0.638009, 0.679892, 1.306),
  ('unknown', 'behind', 0.679892, 0.714286, 1.633),
  ('unknown', 'behind', 0.714286, 0.777019, 1.62),
  ('unknown', 'behind', 0.777019, 0.782759, 1.526),
  ('unknown', 'behind', 0.782759, 0.874146, 1.169),
  ('unknown', 'behind', 0.874146, 1, 0.03461);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'height', -0.5, 0.00735838, 0.01386),
  ('unknown', 'height', 0.00735838, 0.232222, 0.458),
  ('unknown', 'height', 0.232222, 0.344434, 0.5705),
  ('unknown', 'height', 0.344434, 0.42934, 0.575),
  ('unknown', 'height', 0.42934, 0.624266, 0.5691),
  ('unknown', 'height', 0.624266, 0.681509, 0.517),
  ('unknown', 'height', 0.681509, 0.783649, 0.7723),
  ('unknown', 'height', 0.783649, 0.906258, 0.9215),
  ('unknown', 'height', 0.906258, 1.01858, 0.615),
  ('unknown', 'height', 1.01858, 1.12039, 0.4023),
  ('unknown', 'height', 1.12039, 1.35566, 0.3704),
  ('unknown', 'height', 1.35566, 1.43754, 0.305),
  ('unknown', 'height', 1.43754, 1.69273, 0.3295),
  ('unknown', 'height', 1.69273, 1.84439, 0.1844),
  ('unknown', 'height', 1.84439, 2.02981, 0.1141),
  ('unknown', 'height', 2.02981, 2.36688, 0.1318),
  ('unknown', 'height', 2.36688, 2.70396, 0.06092),
  ('unknown', 'height', 2.70396, 3.04104, 0.03957),
  ('unknown', 'height', 3.04104, 4, 0.0116);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'length', 0.03, 0.15319, 0.004384),
  ('unknown', 'length', 0.15319, 0.232136, 0.1691),
  ('unknown', 'length', 0.232136, 0.261676, 0.2821),
  ('unknown', 'length', 0.261676, 0.342742, 0.4107),
  ('unknown', 'length', 0.342742, 0.351767, 0.5179),
  ('unknown', 'length', 0.351767, 0.423793, 0.5242),
  ('unknown', 'length', 0.423793, 0.517383, 0.5545),
  ('unknown', 'length', 0.517383, 0.533049, 0.4711),
  ('unknown', 'length', 0.533049, 0.64553, 0.5051),
  ('unknown', 'length', 0.64553, 0.807754, 0.483),
  ('unknown', 'length', 0.807754, 0.815804, 0.5048),
  ('unknown', 'length', 0.815804, 1.04136, 0.4457),
  ('unknown', 'length', 1.04136, 1.22403, 0.3595),
  ('unknown', 'length', 1.22403, 1.36902, 0.4849),
  ('unknown', 'length', 1.36902, 1.85483, 0.2317),
  ('unknown', 'length', 1.85483, 2.8107, 0.03311),
  ('unknown', 'length', 2.8107, 4.25919, 0.01837),
  ('unknown', 'length', 4.25919, 6.45415, 0.02164),
  ('unknown', 'length', 6.45415, 30, 0.006635);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'rectangularity', 0, 0.32368, 0.02523),
  ('unknown', 'rectangularity', 0.32368, 0.394646, 0.2529),
  ('unknown', 'rectangularity', 0.394646, 0.465612, 0.4471),
  ('unknown', 'rectangularity', 0.465612, 0.524284, 0.8988),
  ('unknown', 'rectangularity', 0.524284, 0.536577, 1.628),
  ('unknown', 'rectangularity', 0.536577, 0.594416, 1.586),
  ('unknown', 'rectangularity', 0.594416, 0.607543, 2.076),
  ('unknown', 'rectangularity', 0.607543, 0.649772, 2.018),
  ('unknown', 'rectangularity', 0.649772, 0.678509, 2.381),
  ('unknown', 'rectangularity', 0.678509, 0.696055, 2.459),
  ('unknown', 'rectangularity', 0.696055, 0.737721, 2.622),
  ('unknown', 'rectangularity', 0.737721, 0.749475, 2.801),
  ('unknown', 'rectangularity', 0.749475, 0.780212, 2.55),
  ('unknown', 'rectangularity', 0.780212, 0.819079, 2.8),
  ('unknown', 'rectangularity', 0.819079, 0.869421, 2.229),
  ('unknown', 'rectangularity', 0.869421, 0.891406, 1.596),
  ('unknown', 'rectangularity', 0.891406, 0.962372, 0.9949),
  ('unknown', 'rectangularity', 0.962372, 1, 0.1698);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_length', 0.01, 0.147049, 0.002323),
  ('unknown', 'spread_length', 0.147049, 0.223529, 0.231),
  ('unknown', 'spread_length', 0.223529, 0.229461, 0.3116),
  ('unknown', 'spread_length', 0.229461, 0.294044, 0.4471),
  ('unknown', 'spread_length', 0.294044, 0.339787, 0.6644),
  ('unknown', 'spread_length', 0.339787, 0.346363, 0.6527),
  ('unknown', 'spread_length', 0.346363, 0.435854, 0.4878),
  ('unknown', 'spread_length', 0.435854, 0.51651, 0.4086),
  ('unknown', 'spread_length', 0.51651, 0.573002, 0.4192),
  ('unknown', 'spread_length', 0.573002, 0.727073, 0.4642),
  ('unknown', 'spread_length', 0.727073, 0.785147, 0.5268),
  ('unknown', 'spread_length', 0.785147, 0.931281, 0.4211),
  ('unknown', 'spread_length', 0.931281, 1.1935, 0.3717),
  ('unknown', 'spread_length', 1.1935, 1.2616, 0.346),
  ('unknown', 'spread_length', 1.2616, 1.81424, 0.2052),
  ('unknown', 'spread_length', 1.81424, 2.75783, 0.02585),
  ('unknown', 'spread_length', 2.75783, 4.19219, 0.01472),
  ('unknown', 'spread_length', 4.19219, 6.37255, 0.02128),
  ('unknown', 'spread_length', 6.37255, 40, 0.005237);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'spread_width', 0.003, 0.108115, 0.0003964),
  ('unknown', 'spread_width', 0.108115, 0.110219, 0.1448),
  ('unknown', 'spread_width', 0.110219, 0.137612, 0.491),
  ('unknown', 'spread_width', 0.137612, 0.160626, 0.5835),
  ('unknown', 'spread_width', 0.160626, 0.166407, 0.5654),
  ('unknown', 'spread_width', 0.166407, 0.198058, 0.631),
  ('unknown', 'spread_width', 0.198058, 0.222454, 0.9632),
  ('unknown', 'spread_width', 0.222454, 0.238641, 0.8683),
  ('unknown', 'spread_width', 0.238641, 0.260446, 0.5811),
  ('unknown', 'spread_width', 0.260446, 0.308277, 0.6454),
  ('unknown', 'spread_width', 0.308277, 0.354548, 0.4892),
  ('unknown', 'spread_width', 0.354548, 0.394662, 0.3974),
  ('unknown', 'spread_width', 0.394662, 0.52675, 0.3029),
  ('unknown', 'spread_width', 0.52675, 0.583256, 0.2445),
  ('unknown', 'spread_width', 0.583256, 0.78259, 0.2365),
  ('unknown', 'spread_width', 0.78259, 1.16269, 0.04421),
  ('unknown', 'spread_width', 1.16269, 1.7274, 0.01365),
  ('unknown', 'spread_width', 1.7274, 2.56639, 0.01253),
  ('unknown', 'spread_width', 2.56639, 3.81287, 0.009984),
  ('unknown', 'spread_width', 3.81287, 20, 0.005708);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'tilt_deg', 0, 1.66558, 0.06671),
  ('unknown', 'tilt_deg', 1.66558, 10, 0.01164),
  ('unknown', 'tilt_deg', 10, 13.1889, 0.004212),
  ('unknown', 'tilt_deg', 13.1889, 20, 0.003186),
  ('unknown', 'tilt_deg', 20, 30, 0.001264),
  ('unknown', 'tilt_deg', 30, 40, 0.00105),
  ('unknown', 'tilt_deg', 40, 50, 0.0009907),
  ('unknown', 'tilt_deg', 50, 60, 0.0009501),
  ('unknown', 'tilt_deg', 60, 70, 0.001475),
  ('unknown', 'tilt_deg', 70, 77.5924, 0.004726),
  ('unknown', 'tilt_deg', 77.5924, 80, 0.006855),
  ('unknown', 'tilt_deg', 80, 86.592, 0.01418),
  ('unknown', 'tilt_deg', 86.592, 88.6117, 0.05646),
  ('unknown', 'tilt_deg', 88.6117, 89.4192, 0.1481),
  ('unknown', 'tilt_deg', 89.4192, 89.779, 0.4216),
  ('unknown', 'tilt_deg', 89.779, 90, 0.7615);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'width', 0.01, 0.112584, 0.003135),
  ('unknown', 'width', 0.112584, 0.160325, 0.2925),
  ('unknown', 'width', 0.160325, 0.166756, 0.4323),
  ('unknown', 'width', 0.166756, 0.206869, 0.4413),
  ('unknown', 'width', 0.206869, 0.240658, 0.7514),
  ('unknown', 'width', 0.240658, 0.246995, 0.8779),
  ('unknown', 'width', 0.246995, 0.277901, 0.712),
  ('unknown', 'width', 0.277901, 0.333524, 0.616),
  ('unknown', 'width', 0.333524, 0.365842, 0.7644),
  ('unknown', 'width', 0.365842, 0.391454, 0.5847),
  ('unknown', 'width', 0.391454, 0.496738, 0.4675),
  ('unknown', 'width', 0.496738, 0.541876, 0.2816),
  ('unknown', 'width', 0.541876, 0.712061, 0.3178),
  ('unknown', 'width', 0.712061, 0.802611, 0.3685),
  ('unknown', 'width', 0.802611, 1.18881, 0.09532),
  ('unknown', 'width', 1.18881, 1.76083, 0.0247),
  ('unknown', 'width', 1.76083, 2.60809, 0.01408),
  ('unknown', 'width', 2.60809, 3.86303, 0.01124),
  ('unknown', 'width', 3.86303, 12, 0.008757);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_max', -0.5, 0.0254837, 0.01463),
  ('unknown', 'z_max', 0.0254837, 0.424028, 0.2693),
  ('unknown', 'z_max', 0.424028, 0.467097, 0.724),
  ('unknown', 'z_max', 0.467097, 0.675137, 0.3635),
  ('unknown', 'z_max', 0.675137, 0.787782, 0.9948),
  ('unknown', 'z_max', 0.787782, 0.908014, 0.9167),
  ('unknown', 'z_max', 0.908014, 1.08034, 0.6448),
  ('unknown', 'z_max', 1.08034, 1.33795, 0.4375),
  ('unknown', 'z_max', 1.33795, 1.35032, 0.3059),
  ('unknown', 'z_max', 1.35032, 1.79194, 0.2377),
  ('unknown', 'z_max', 1.79194, 2.18178, 0.2832),
  ('unknown', 'z_max', 2.18178, 2.23355, 0.3864),
  ('unknown', 'z_max', 2.23355, 2.67516, 0.1092),
  ('unknown', 'z_max', 2.67516, 3.11677, 0.03868),
  ('unknown', 'z_max', 3.11677, 3.55839, 0.01862),
  ('unknown', 'z_max', 3.55839, 4, 0.04387);
DELETE FROM class_density WHERE class = 'unknown' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('unknown', 'z_min', -0.5, -0.126549, 0.05098),
  ('unknown', 'z_min', -0.126549, -0.012595, 0.8335),
  ('unknown', 'z_min', -0.012595, 0.0504764, 1.757),
  ('unknown', 'z_min', 0.0504764, 0.246902, 0.4366),
  ('unknown', 'z_min', 0.246902, 0.309347, 0.3483),
  ('unknown', 'z_min', 0.309347, 0.617827, 0.3528),
  ('unknown', 'z_min', 0.617827, 0.742287, 0.9102),
  ('unknown', 'z_min', 0.742287, 0.865511, 0.8962),
  ('unknown', 'z_min', 0.865511, 0.993805, 0.5584),
  ('unknown', 'z_min', 0.993805, 1.10193, 0.3815),
  ('unknown', 'z_min', 1.10193, 1.36726, 0.301),
  ('unknown', 'z_min', 1.36726, 1.55083, 0.1763),
  ('unknown', 'z_min', 1.55083, 1.74071, 0.09672),
  ('unknown', 'z_min', 1.74071, 2.11416, 0.069),
  ('unknown', 'z_min', 2.11416, 2.48761, 0.0966),
  ('unknown', 'z_min', 2.48761, 2.86106, 0.04834),
  ('unknown', 'z_min', 2.86106, 4, 0.01025);

-- floor: 137 examples
UPDATE object_class SET prior = 0.02855 WHERE name = 'floor';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'area_m2', 1.361, 1.47)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'aspect', 0.4644, 0.3323)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('floor', 'behind', 0, 0.005)
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
  ('floor', 'area_m2', 11.0656, 12.1617, 0.4069),
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
  ('floor', 'rectangularity', 0.591258, 0.614782, 3.137),
  ('floor', 'rectangularity', 0.614782, 0.629819, 2.939),
  ('floor', 'rectangularity', 0.629819, 0.680279, 2.082),
  ('floor', 'rectangularity', 0.680279, 0.745776, 1.556),
  ('floor', 'rectangularity', 0.745776, 0.752609, 1.186),
  ('floor', 'rectangularity', 0.752609, 0.811273, 1.065),
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
  ('floor', 'spread_length', 2.2104, 2.61764, 0.3419),
  ('floor', 'spread_length', 2.61764, 2.92684, 0.9896),
  ('floor', 'spread_length', 2.92684, 3.03672, 0.9992),
  ('floor', 'spread_length', 3.03672, 3.26548, 0.9535),
  ('floor', 'spread_length', 3.26548, 3.58357, 1.111),
  ('floor', 'spread_length', 3.58357, 3.91853, 1.16),
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
  ('floor', 'spread_width', 2.56813, 2.74203, 1.463),
  ('floor', 'spread_width', 2.74203, 3.38721, 0.5102),
  ('floor', 'spread_width', 3.38721, 3.51517, 0.1643),
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
  ('floor', 'z_max', -0.5, -0.022812, 0.04742),
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
UPDATE object_class SET prior = 0.02005 WHERE name = 'ceiling';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'area_m2', 1.943, 1.114)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'aspect', 0.4176, 0.3847)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'behind', 0.04135, 0.1176)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'height', 2.886, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'length', 1.369, 0.4689)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'rectangularity', 0.6969, 0.133)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_length', 1.256, 0.4628)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'spread_width', 0.6602, 0.6687)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'tilt_deg', 0.02866, 0.45)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'width', 0.9472, 0.7227)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_max', 2.887, 0.3875)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('ceiling', 'z_min', 2.886, 0.3874)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'area_m2', 0.002, 0.201675, 0.002532),
  ('ceiling', 'area_m2', 0.201675, 0.351707, 0.03683),
  ('ceiling', 'area_m2', 0.351707, 0.613352, 0.04363),
  ('ceiling', 'area_m2', 0.613352, 1.06964, 0.06829),
  ('ceiling', 'area_m2', 1.06964, 1.1841, 0.092),
  ('ceiling', 'area_m2', 1.1841, 1.86538, 0.07825),
  ('ceiling', 'area_m2', 1.86538, 3.2531, 0.08913),
  ('ceiling', 'area_m2', 3.2531, 5.21901, 0.1248),
  ('ceiling', 'area_m2', 5.21901, 5.67318, 0.2243),
  ('ceiling', 'area_m2', 5.67318, 7.3965, 0.3284),
  ('ceiling', 'area_m2', 7.3965, 9.62452, 0.4529),
  ('ceiling', 'area_m2', 9.62452, 11.0962, 0.6227),
  ('ceiling', 'area_m2', 11.0962, 12.3741, 1.011),
  ('ceiling', 'area_m2', 12.3741, 14.6536, 0.6195),
  ('ceiling', 'area_m2', 14.6536, 17.2538, 0.5504),
  ('ceiling', 'area_m2', 17.2538, 18.501, 0.226),
  ('ceiling', 'area_m2', 18.501, 28.1474, 0.2378),
  ('ceiling', 'area_m2', 28.1474, 30.0894, 0.05619),
  ('ceiling', 'area_m2', 30.0894, 100, 0.01194);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'aspect', 1, 1.0426, 2.448),
  ('ceiling', 'aspect', 1.0426, 1.12948, 1.377),
  ('ceiling', 'aspect', 1.12948, 1.20036, 1.799),
  ('ceiling', 'aspect', 1.20036, 1.35929, 0.9076),
  ('ceiling', 'aspect', 1.35929, 1.4421, 1.737),
  ('ceiling', 'aspect', 1.4421, 1.56655, 1.357),
  ('ceiling', 'aspect', 1.56655, 1.73178, 0.751),
  ('ceiling', 'aspect', 1.73178, 1.82414, 0.698),
  ('ceiling', 'aspect', 1.82414, 2.07965, 0.6952),
  ('ceiling', 'aspect', 2.07965, 2.19721, 0.4302),
  ('ceiling', 'aspect', 2.19721, 2.49741, 0.2264),
  ('ceiling', 'aspect', 2.49741, 2.99907, 0.1239),
  ('ceiling', 'aspect', 2.99907, 3.60151, 0.07516),
  ('ceiling', 'aspect', 3.60151, 4.32496, 0.1091),
  ('ceiling', 'aspect', 4.32496, 5.19374, 0.1225),
  ('ceiling', 'aspect', 5.19374, 100, 0.005435);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'behind', 0, 0.0519312, 15.84),
  ('ceiling', 'behind', 0.0519312, 0.103862, 0.5821),
  ('ceiling', 'behind', 0.103862, 0.116741, 0.4817),
  ('ceiling', 'behind', 0.116741, 0.155794, 0.3947),
  ('ceiling', 'behind', 0.155794, 0.207725, 0.2761),
  ('ceiling', 'behind', 0.207725, 0.259656, 0.2841),
  ('ceiling', 'behind', 0.259656, 0.311587, 0.4125),
  ('ceiling', 'behind', 0.311587, 0.363518, 0.5),
  ('ceiling', 'behind', 0.363518, 0.415449, 0.4152),
  ('ceiling', 'behind', 0.415449, 0.467381, 0.2445),
  ('ceiling', 'behind', 0.467381, 1, 0.02738);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'height', -0.5, 2.29357, 0.005668),
  ('ceiling', 'height', 2.29357, 2.47316, 0.4738),
  ('ceiling', 'height', 2.47316, 2.51477, 2.715),
  ('ceiling', 'height', 2.51477, 2.65276, 0.619),
  ('ceiling', 'height', 2.65276, 2.68275, 1.034),
  ('ceiling', 'height', 2.68275, 2.74884, 1.69),
  ('ceiling', 'height', 2.74884, 2.83236, 1.075),
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
  ('ceiling', 'length', 0.03, 0.790484, 0.003548),
  ('ceiling', 'length', 0.790484, 1.00323, 0.03884),
  ('ceiling', 'length', 1.00323, 1.27325, 0.06294),
  ('ceiling', 'length', 1.27325, 1.61593, 0.1619),
  ('ceiling', 'length', 1.61593, 1.86983, 0.2057),
  ('ceiling', 'length', 1.86983, 2.05084, 0.165),
  ('ceiling', 'length', 2.05084, 2.6028, 0.1807),
  ('ceiling', 'length', 2.6028, 3.24949, 0.3213),
  ('ceiling', 'length', 3.24949, 3.30333, 0.3289),
  ('ceiling', 'length', 3.30333, 4.05138, 0.5856),
  ('ceiling', 'length', 4.05138, 4.19238, 1.211),
  ('ceiling', 'length', 4.19238, 4.42916, 1.237),
  ('ceiling', 'length', 4.42916, 4.70627, 1.575),
  ('ceiling', 'length', 4.70627, 5.02887, 1.608),
  ('ceiling', 'length', 5.02887, 5.32073, 1.122),
  ('ceiling', 'length', 5.32073, 5.4728, 1.258),
  ('ceiling', 'length', 5.4728, 6.02217, 1.199),
  ('ceiling', 'length', 6.02217, 6.75275, 0.8361),
  ('ceiling', 'length', 6.75275, 30, 0.01354);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'rectangularity', 0, 0.389676, 0.02972),
  ('ceiling', 'rectangularity', 0.389676, 0.45462, 0.1742),
  ('ceiling', 'rectangularity', 0.45462, 0.519563, 1.102),
  ('ceiling', 'rectangularity', 0.519563, 0.580084, 2.032),
  ('ceiling', 'rectangularity', 0.580084, 0.632, 2.056),
  ('ceiling', 'rectangularity', 0.632, 0.64945, 3.329),
  ('ceiling', 'rectangularity', 0.64945, 0.660798, 4.507),
  ('ceiling', 'rectangularity', 0.660798, 0.709951, 2.451),
  ('ceiling', 'rectangularity', 0.709951, 0.766331, 2.098),
  ('ceiling', 'rectangularity', 0.766331, 0.779337, 1.403),
  ('ceiling', 'rectangularity', 0.779337, 0.826432, 2.071),
  ('ceiling', 'rectangularity', 0.826432, 0.844281, 2.884),
  ('ceiling', 'rectangularity', 0.844281, 0.863285, 2.261),
  ('ceiling', 'rectangularity', 0.863285, 0.909224, 1.342),
  ('ceiling', 'rectangularity', 0.909224, 0.953337, 0.8902),
  ('ceiling', 'rectangularity', 0.953337, 0.974168, 0.4749),
  ('ceiling', 'rectangularity', 0.974168, 1, 0.2654);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_length', 0.01, 0.718513, 0.002909),
  ('ceiling', 'spread_length', 0.718513, 0.910638, 0.06225),
  ('ceiling', 'spread_length', 0.910638, 1.15413, 0.04243),
  ('ceiling', 'spread_length', 1.15413, 1.46274, 0.1574),
  ('ceiling', 'spread_length', 1.46274, 1.67893, 0.204),
  ('ceiling', 'spread_length', 1.67893, 1.85387, 0.1721),
  ('ceiling', 'spread_length', 1.85387, 2.34957, 0.1534),
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
  ('ceiling', 'spread_length', 6.06223, 40, 0.008495);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'spread_width', 0.003, 0.165672, 0.002858),
  ('ceiling', 'spread_width', 0.165672, 0.236796, 0.01929),
  ('ceiling', 'spread_width', 0.236796, 0.338456, 0.01693),
  ('ceiling', 'spread_width', 0.338456, 0.483759, 0.08553),
  ('ceiling', 'spread_width', 0.483759, 0.691443, 0.1377),
  ('ceiling', 'spread_width', 0.691443, 0.725019, 0.1245),
  ('ceiling', 'spread_width', 0.725019, 0.988288, 0.1563),
  ('ceiling', 'spread_width', 0.988288, 1.41257, 0.1645),
  ('ceiling', 'spread_width', 1.41257, 1.61637, 0.1741),
  ('ceiling', 'spread_width', 1.61637, 2.01901, 0.4693),
  ('ceiling', 'spread_width', 2.01901, 2.29515, 0.958),
  ('ceiling', 'spread_width', 2.29515, 2.57232, 0.8606),
  ('ceiling', 'spread_width', 2.57232, 2.79773, 1.193),
  ('ceiling', 'spread_width', 2.79773, 2.88579, 1.282),
  ('ceiling', 'spread_width', 2.88579, 3.04982, 1.122),
  ('ceiling', 'spread_width', 3.04982, 3.32505, 1.261),
  ('ceiling', 'spread_width', 3.32505, 3.91651, 0.5995),
  ('ceiling', 'spread_width', 3.91651, 4.1247, 0.1426),
  ('ceiling', 'spread_width', 4.1247, 20, 0.01114);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'tilt_deg', 0, 0.177075, 2.95),
  ('ceiling', 'tilt_deg', 0.177075, 0.35415, 1.741),
  ('ceiling', 'tilt_deg', 0.35415, 0.531226, 0.647),
  ('ceiling', 'tilt_deg', 0.531226, 0.708301, 0.1923),
  ('ceiling', 'tilt_deg', 0.708301, 90, 0.0002316);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'width', 0.01, 0.184132, 0.00413),
  ('ceiling', 'width', 0.184132, 0.266863, 0.01684),
  ('ceiling', 'width', 0.266863, 0.386766, 0.01177),
  ('ceiling', 'width', 0.386766, 0.560541, 0.09239),
  ('ceiling', 'width', 0.560541, 0.812395, 0.1196),
  ('ceiling', 'width', 0.812395, 0.90405, 0.09489),
  ('ceiling', 'width', 0.90405, 1.17741, 0.1339),
  ('ceiling', 'width', 1.17741, 1.70642, 0.144),
  ('ceiling', 'width', 1.70642, 2.05082, 0.2134),
  ('ceiling', 'width', 2.05082, 2.47312, 0.3585),
  ('ceiling', 'width', 2.47312, 2.60769, 0.7094),
  ('ceiling', 'width', 2.60769, 3.30656, 0.5036),
  ('ceiling', 'width', 3.30656, 3.5843, 1.119),
  ('ceiling', 'width', 3.5843, 3.86986, 1.365),
  ('ceiling', 'width', 3.86986, 4.13196, 1.705),
  ('ceiling', 'width', 4.13196, 4.55797, 1.119),
  ('ceiling', 'width', 4.55797, 5.19474, 0.7258),
  ('ceiling', 'width', 5.19474, 12, 0.0297);
DELETE FROM class_density WHERE class = 'ceiling' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('ceiling', 'z_max', -0.5, 2.29399, 0.005673),
  ('ceiling', 'z_max', 2.29399, 2.47358, 0.4736),
  ('ceiling', 'z_max', 2.47358, 2.51531, 2.696),
  ('ceiling', 'z_max', 2.51531, 2.65318, 0.6247),
  ('ceiling', 'z_max', 2.65318, 2.68293, 1.034),
  ('ceiling', 'z_max', 2.68293, 2.74982, 1.683),
  ('ceiling', 'z_max', 2.74982, 2.83278, 1.074),
  ('ceiling', 'z_max', 2.83278, 2.982, 0.8364),
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
  ('ceiling', 'z_min', -0.5, 2.29342, 0.005678),
  ('ceiling', 'z_min', 2.29342, 2.473, 0.4757),
  ('ceiling', 'z_min', 2.473, 2.51428, 2.735),
  ('ceiling', 'z_min', 2.51428, 2.65259, 0.615),
  ('ceiling', 'z_min', 2.65259, 2.68257, 1.038),
  ('ceiling', 'z_min', 2.68257, 2.74746, 1.696),
  ('ceiling', 'z_min', 2.74746, 2.83217, 1.079),
  ('ceiling', 'z_min', 2.83217, 2.98137, 0.837),
  ('ceiling', 'z_min', 2.98137, 3.01175, 0.6304),
  ('ceiling', 'z_min', 3.01175, 3.10975, 0.8958),
  ('ceiling', 'z_min', 3.10975, 3.19133, 0.6482),
  ('ceiling', 'z_min', 3.19133, 3.37092, 0.2796),
  ('ceiling', 'z_min', 3.37092, 3.40344, 0.3216),
  ('ceiling', 'z_min', 3.40344, 3.5505, 0.2808),
  ('ceiling', 'z_min', 3.5505, 3.73008, 0.2126),
  ('ceiling', 'z_min', 3.73008, 3.88897, 0.181),
  ('ceiling', 'z_min', 3.88897, 3.90967, 0.1451),
  ('ceiling', 'z_min', 3.90967, 4, 0.1285);

-- wall: 509 examples
UPDATE object_class SET prior = 0.1062 WHERE name = 'wall';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'area_m2', 1.097, 1.052)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'aspect', 0.5773, 0.4125)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'behind', 0.09698, 0.1898)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'height', 1.407, 0.3668)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'length', 1.045, 0.4714)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'rectangularity', 0.681, 0.1486)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_length', 0.8808, 0.474)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'spread_width', 0.2172, 0.654)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'tilt_deg', 89.55, 1.131)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'width', 0.4652, 0.6623)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_max', 2.54, 0.6837)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('wall', 'z_min', 0.1671, 0.3711)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'wall' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'area_m2', 0.002, 0.233878, 0.002455),
  ('wall', 'area_m2', 0.233878, 0.376522, 0.05645),
  ('wall', 'area_m2', 0.376522, 0.606166, 0.1137),
  ('wall', 'area_m2', 0.606166, 0.711777, 0.1373),
  ('wall', 'area_m2', 0.711777, 0.97587, 0.1816),
  ('wall', 'area_m2', 0.97587, 1.2037, 0.2424),
  ('wall', 'area_m2', 1.2037, 1.57106, 0.2565),
  ('wall', 'area_m2', 1.57106, 1.92221, 0.2333),
  ('wall', 'area_m2', 1.92221, 2.52926, 0.244),
  ('wall', 'area_m2', 2.52926, 2.96284, 0.252),
  ('wall', 'area_m2', 2.96284, 4.07187, 0.2668),
  ('wall', 'area_m2', 4.07187, 4.40149, 0.3157),
  ('wall', 'area_m2', 4.40149, 5.83048, 0.4074),
  ('wall', 'area_m2', 5.83048, 6.55533, 0.4051),
  ('wall', 'area_m2', 6.55533, 7.5414, 0.4307),
  ('wall', 'area_m2', 7.5414, 9.97228, 0.3956),
  ('wall', 'area_m2', 9.97228, 10.5535, 0.303),
  ('wall', 'area_m2', 10.5535, 16.9901, 0.1906),
  ('wall', 'area_m2', 16.9901, 100, 0.002629);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'aspect', 1, 1.13339, 0.8958),
  ('wall', 'aspect', 1.13339, 1.23643, 0.7657),
  ('wall', 'aspect', 1.23643, 1.28063, 1.183),
  ('wall', 'aspect', 1.28063, 1.40976, 1.164),
  ('wall', 'aspect', 1.40976, 1.52876, 0.8701),
  ('wall', 'aspect', 1.52876, 1.56961, 1.58),
  ('wall', 'aspect', 1.56961, 1.70132, 1.281),
  ('wall', 'aspect', 1.70132, 1.8902, 0.8056),
  ('wall', 'aspect', 1.8902, 1.94638, 0.9628),
  ('wall', 'aspect', 1.94638, 2.26598, 0.7647),
  ('wall', 'aspect', 2.26598, 2.33711, 0.4566),
  ('wall', 'aspect', 2.33711, 2.88967, 0.4427),
  ('wall', 'aspect', 2.88967, 2.98294, 0.1757),
  ('wall', 'aspect', 2.98294, 3.57287, 0.149),
  ('wall', 'aspect', 3.57287, 4.41761, 0.1725),
  ('wall', 'aspect', 4.41761, 5.46206, 0.1225),
  ('wall', 'aspect', 5.46206, 6.75346, 0.04487),
  ('wall', 'aspect', 6.75346, 100, 0.00388);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'behind', 0, 0.0811752, 9.017),
  ('wall', 'behind', 0.0811752, 0.146673, 0.6206),
  ('wall', 'behind', 0.146673, 0.16235, 0.7299),
  ('wall', 'behind', 0.16235, 0.243526, 0.5967),
  ('wall', 'behind', 0.243526, 0.324701, 0.5038),
  ('wall', 'behind', 0.324701, 0.373072, 0.2912),
  ('wall', 'behind', 0.373072, 0.405876, 0.301),
  ('wall', 'behind', 0.405876, 0.487051, 0.24),
  ('wall', 'behind', 0.487051, 0.568226, 0.35),
  ('wall', 'behind', 0.568226, 0.649402, 0.2906),
  ('wall', 'behind', 0.649402, 0.730577, 0.2417),
  ('wall', 'behind', 0.730577, 1, 0.04272);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'height', -0.5, 0.295699, 0.01412),
  ('wall', 'height', 0.295699, 0.51827, 0.09508),
  ('wall', 'height', 0.51827, 0.74084, 0.136),
  ('wall', 'height', 0.74084, 0.963411, 0.2042),
  ('wall', 'height', 0.963411, 0.976764, 0.182),
  ('wall', 'height', 0.976764, 1.18598, 0.3231),
  ('wall', 'height', 1.18598, 1.22892, 1.052),
  ('wall', 'height', 1.22892, 1.32529, 1.139),
  ('wall', 'height', 1.32529, 1.39476, 1.597),
  ('wall', 'height', 1.39476, 1.40855, 1.319),
  ('wall', 'height', 1.40855, 1.45756, 1.855),
  ('wall', 'height', 1.45756, 1.53657, 1.443),
  ('wall', 'height', 1.53657, 1.63089, 1.167),
  ('wall', 'height', 1.63089, 1.79189, 0.6976),
  ('wall', 'height', 1.79189, 1.85369, 0.3148),
  ('wall', 'height', 1.85369, 2.07626, 0.2414),
  ('wall', 'height', 2.07626, 2.29883, 0.1242),
  ('wall', 'height', 2.29883, 4, 0.005642);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'length', 0.03, 0.723441, 0.002921),
  ('wall', 'length', 0.723441, 0.924632, 0.06288),
  ('wall', 'length', 0.924632, 1.18177, 0.1031),
  ('wall', 'length', 1.18177, 1.4942, 0.2637),
  ('wall', 'length', 1.4942, 1.93048, 0.3309),
  ('wall', 'length', 1.93048, 2.1129, 0.2805),
  ('wall', 'length', 2.1129, 2.46735, 0.6844),
  ('wall', 'length', 2.46735, 2.74135, 1.077),
  ('wall', 'length', 2.74135, 3.15353, 0.7447),
  ('wall', 'length', 3.15353, 3.7293, 0.7358),
  ('wall', 'length', 3.7293, 4.03053, 0.9527),
  ('wall', 'length', 4.03053, 4.21391, 0.7334),
  ('wall', 'length', 4.21391, 4.82553, 0.8437),
  ('wall', 'length', 4.82553, 5.15143, 0.5391),
  ('wall', 'length', 5.15143, 6.58406, 0.2766),
  ('wall', 'length', 6.58406, 30, 0.004434);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'rectangularity', 0, 0.330953, 0.03179),
  ('wall', 'rectangularity', 0.330953, 0.403906, 0.2851),
  ('wall', 'rectangularity', 0.403906, 0.476859, 0.9592),
  ('wall', 'rectangularity', 0.476859, 0.484236, 1.416),
  ('wall', 'rectangularity', 0.484236, 0.549812, 1.398),
  ('wall', 'rectangularity', 0.549812, 0.560376, 1.847),
  ('wall', 'rectangularity', 0.560376, 0.620286, 1.89),
  ('wall', 'rectangularity', 0.620286, 0.66542, 2.463),
  ('wall', 'rectangularity', 0.66542, 0.695719, 2.735),
  ('wall', 'rectangularity', 0.695719, 0.7058, 2.585),
  ('wall', 'rectangularity', 0.7058, 0.750609, 2.457),
  ('wall', 'rectangularity', 0.750609, 0.768672, 1.731),
  ('wall', 'rectangularity', 0.768672, 0.805413, 2.21),
  ('wall', 'rectangularity', 0.805413, 0.841625, 1.765),
  ('wall', 'rectangularity', 0.841625, 0.871382, 1.615),
  ('wall', 'rectangularity', 0.871382, 0.914578, 1.11),
  ('wall', 'rectangularity', 0.914578, 0.986055, 0.789),
  ('wall', 'rectangularity', 0.986055, 1, 0.3525);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_length', 0.01, 0.62917, 0.002246),
  ('wall', 'spread_length', 0.62917, 0.805487, 0.06502),
  ('wall', 'spread_length', 0.805487, 1.03121, 0.1184),
  ('wall', 'spread_length', 1.03121, 1.26323, 0.2693),
  ('wall', 'spread_length', 1.26323, 1.3202, 0.2969),
  ('wall', 'spread_length', 1.3202, 1.68539, 0.4062),
  ('wall', 'spread_length', 1.68539, 2.10463, 0.5065),
  ('wall', 'spread_length', 2.10463, 2.16382, 0.6587),
  ('wall', 'spread_length', 2.16382, 2.3966, 0.9295),
  ('wall', 'spread_length', 2.3966, 2.67179, 0.9944),
  ('wall', 'spread_length', 2.67179, 2.7702, 0.8932),
  ('wall', 'spread_length', 2.7702, 3.14515, 0.6249),
  ('wall', 'spread_length', 3.14515, 3.54651, 0.7771),
  ('wall', 'spread_length', 3.54651, 3.67041, 0.494),
  ('wall', 'spread_length', 3.67041, 4.18484, 0.852),
  ('wall', 'spread_length', 4.18484, 4.54038, 0.5734),
  ('wall', 'spread_length', 4.54038, 5.81277, 0.2293),
  ('wall', 'spread_length', 5.81277, 40, 0.003895);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'spread_width', 0.003, 0.218781, 0.002862),
  ('wall', 'spread_width', 0.218781, 0.296779, 0.0465),
  ('wall', 'spread_width', 0.296779, 0.402584, 0.1074),
  ('wall', 'spread_width', 0.402584, 0.485989, 0.2589),
  ('wall', 'spread_width', 0.485989, 0.546111, 0.3263),
  ('wall', 'spread_width', 0.546111, 0.699372, 0.2904),
  ('wall', 'spread_width', 0.699372, 0.740807, 0.3263),
  ('wall', 'spread_width', 0.740807, 1.00092, 0.3231),
  ('wall', 'spread_width', 1.00092, 1.26077, 0.4852),
  ('wall', 'spread_width', 1.26077, 1.36318, 0.4417),
  ('wall', 'spread_width', 1.36318, 1.63007, 0.4245),
  ('wall', 'spread_width', 1.63007, 1.84917, 0.7434),
  ('wall', 'spread_width', 1.84917, 1.913, 0.6722),
  ('wall', 'spread_width', 1.913, 2.18998, 0.7541),
  ('wall', 'spread_width', 2.18998, 2.50843, 0.734),
  ('wall', 'spread_width', 2.50843, 2.56279, 0.6185),
  ('wall', 'spread_width', 2.56279, 3.40271, 0.3722),
  ('wall', 'spread_width', 3.40271, 20, 0.003844);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'tilt_deg', 0, 83.3749, 0.000114),
  ('wall', 'tilt_deg', 83.3749, 84.111, 0.004661),
  ('wall', 'tilt_deg', 84.111, 84.8471, 0.003304),
  ('wall', 'tilt_deg', 84.8471, 85.5833, 0.008496),
  ('wall', 'tilt_deg', 85.5833, 86.3194, 0.01851),
  ('wall', 'tilt_deg', 86.3194, 87.0555, 0.02333),
  ('wall', 'tilt_deg', 87.0555, 87.7916, 0.03998),
  ('wall', 'tilt_deg', 87.7916, 88.5278, 0.04073),
  ('wall', 'tilt_deg', 88.5278, 89.2639, 0.07568),
  ('wall', 'tilt_deg', 89.2639, 89.8674, 0.8008),
  ('wall', 'tilt_deg', 89.8674, 90, 2.633);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'width', 0.01, 0.275374, 0.003481),
  ('wall', 'width', 0.275374, 0.371527, 0.05231),
  ('wall', 'width', 0.371527, 0.501253, 0.09738),
  ('wall', 'width', 0.501253, 0.598235, 0.2918),
  ('wall', 'width', 0.598235, 0.676277, 0.2888),
  ('wall', 'width', 0.676277, 0.871901, 0.2905),
  ('wall', 'width', 0.871901, 0.912414, 0.3211),
  ('wall', 'width', 0.912414, 1.2167, 0.3453),
  ('wall', 'width', 1.2167, 1.63721, 0.3943),
  ('wall', 'width', 1.63721, 2.24075, 0.2476),
  ('wall', 'width', 2.24075, 2.39354, 0.4765),
  ('wall', 'width', 2.39354, 2.61024, 1.275),
  ('wall', 'width', 2.61024, 2.7969, 1.525),
  ('wall', 'width', 2.7969, 3.02316, 1.25),
  ('wall', 'width', 3.02316, 3.08989, 1.092),
  ('wall', 'width', 3.08989, 3.88275, 0.4205),
  ('wall', 'width', 3.88275, 4.07877, 0.1052),
  ('wall', 'width', 4.07877, 12, 0.004199);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_max', -0.5, 0.613961, 0.007793),
  ('wall', 'z_max', 0.613961, 0.976197, 0.04867),
  ('wall', 'z_max', 0.976197, 1.33843, 0.1097),
  ('wall', 'z_max', 1.33843, 1.49077, 0.2961),
  ('wall', 'z_max', 1.49077, 1.70067, 0.2357),
  ('wall', 'z_max', 1.70067, 2.0629, 0.1389),
  ('wall', 'z_max', 2.0629, 2.2229, 0.08638),
  ('wall', 'z_max', 2.2229, 2.42514, 0.2671),
  ('wall', 'z_max', 2.42514, 2.47928, 1.034),
  ('wall', 'z_max', 2.47928, 2.57833, 1.139),
  ('wall', 'z_max', 2.57833, 2.71999, 0.7927),
  ('wall', 'z_max', 2.71999, 2.78737, 1.189),
  ('wall', 'z_max', 2.78737, 2.83466, 0.5997),
  ('wall', 'z_max', 2.83466, 2.99499, 0.6838),
  ('wall', 'z_max', 2.99499, 3.14961, 0.599),
  ('wall', 'z_max', 3.14961, 3.1961, 0.3028),
  ('wall', 'z_max', 3.1961, 3.51184, 0.1781),
  ('wall', 'z_max', 3.51184, 3.87408, 0.1339),
  ('wall', 'z_max', 3.87408, 4, 0.08385);
DELETE FROM class_density WHERE class = 'wall' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('wall', 'z_min', -0.5, -0.152586, 0.04179),
  ('wall', 'z_min', -0.152586, -0.0243972, 1.215),
  ('wall', 'z_min', -0.0243972, -0.0155695, 15.28),
  ('wall', 'z_min', -0.0155695, -0.00677355, 18.28),
  ('wall', 'z_min', -0.00677355, 0.00261397, 14.51),
  ('wall', 'z_min', 0.00261397, 0.0559912, 2.28),
  ('wall', 'z_min', 0.0559912, 0.219466, 0.2874),
  ('wall', 'z_min', 0.219466, 0.264569, 0.2517),
  ('wall', 'z_min', 0.264569, 0.473146, 0.2017),
  ('wall', 'z_min', 0.473146, 0.68099, 0.3224),
  ('wall', 'z_min', 0.68099, 0.890302, 0.1899),
  ('wall', 'z_min', 0.890302, 1.09888, 0.1531),
  ('wall', 'z_min', 1.09888, 1.30746, 0.07219),
  ('wall', 'z_min', 1.30746, 1.51603, 0.01401),
  ('wall', 'z_min', 1.51603, 1.72461, 0.04648),
  ('wall', 'z_min', 1.72461, 4, 0.004089);

-- table: 204 examples
UPDATE object_class SET prior = 0.04265 WHERE name = 'table';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'area_m2', -0.3446, 0.6635)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'aspect', 0.5417, 0.3018)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'behind', 0.5316, 0.2094)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'height', 0.7415, 0.131)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'length', 0.2856, 0.3436)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'rectangularity', 0.702, 0.1297)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_length', 0.1421, 0.3397)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'spread_width', -0.4523, 0.3801)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'tilt_deg', 0.7707, 0.6316)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'width', -0.2574, 0.3645)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_max', 0.7495, 0.1308)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'z_min', 0.735, 0.1305)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'table' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'area_m2', 0.002, 0.0818098, 0.002434),
  ('table', 'area_m2', 0.0818098, 0.118039, 0.03632),
  ('table', 'area_m2', 0.118039, 0.170312, 0.06278),
  ('table', 'area_m2', 0.170312, 0.245734, 0.08777),
  ('table', 'area_m2', 0.245734, 0.307893, 0.1388),
  ('table', 'area_m2', 0.307893, 0.354556, 0.2376),
  ('table', 'area_m2', 0.354556, 0.452425, 0.3429),
  ('table', 'area_m2', 0.452425, 0.511569, 0.4324),
  ('table', 'area_m2', 0.511569, 0.606999, 0.3147),
  ('table', 'area_m2', 0.606999, 0.738115, 0.5517),
  ('table', 'area_m2', 0.738115, 0.926319, 0.5402),
  ('table', 'area_m2', 0.926319, 1.04507, 0.856),
  ('table', 'area_m2', 1.04507, 1.18973, 0.8684),
  ('table', 'area_m2', 1.18973, 1.36737, 0.7726),
  ('table', 'area_m2', 1.36737, 1.53661, 0.4366),
  ('table', 'area_m2', 1.53661, 2.21709, 0.1407),
  ('table', 'area_m2', 2.21709, 100, 0.002787);
DELETE FROM class_density WHERE class = 'table' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'aspect', 1, 1.01746, 0.8238),
  ('table', 'aspect', 1.01746, 1.15641, 0.7971),
  ('table', 'aspect', 1.15641, 1.18893, 0.585),
  ('table', 'aspect', 1.18893, 1.34201, 0.7529),
  ('table', 'aspect', 1.34201, 1.41355, 0.9124),
  ('table', 'aspect', 1.41355, 1.52253, 0.8631),
  ('table', 'aspect', 1.52253, 1.66953, 1.177),
  ('table', 'aspect', 1.66953, 1.80293, 1.428),
  ('table', 'aspect', 1.80293, 1.96261, 1.293),
  ('table', 'aspect', 1.96261, 1.99812, 1.305),
  ('table', 'aspect', 1.99812, 2.11595, 1.691),
  ('table', 'aspect', 2.11595, 2.37561, 0.8187),
  ('table', 'aspect', 2.37561, 2.45459, 0.4582),
  ('table', 'aspect', 2.45459, 2.82443, 0.4439),
  ('table', 'aspect', 2.82443, 3.35804, 0.1307),
  ('table', 'aspect', 3.35804, 3.99247, 0.03871),
  ('table', 'aspect', 3.99247, 4.74675, 0.04488),
  ('table', 'aspect', 4.74675, 100, 0.00241);
DELETE FROM class_density WHERE class = 'table' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'behind', 0, 0.0920347, 0.5778),
  ('table', 'behind', 0.0920347, 0.184069, 0.3877),
  ('table', 'behind', 0.184069, 0.238675, 0.3667),
  ('table', 'behind', 0.238675, 0.276104, 0.4753),
  ('table', 'behind', 0.276104, 0.367891, 1.01),
  ('table', 'behind', 0.367891, 0.460174, 1.132),
  ('table', 'behind', 0.460174, 0.552208, 1.157),
  ('table', 'behind', 0.552208, 0.572844, 1.091),
  ('table', 'behind', 0.572844, 0.631262, 1.841),
  ('table', 'behind', 0.631262, 0.644243, 2.174),
  ('table', 'behind', 0.644243, 0.676292, 2.394),
  ('table', 'behind', 0.676292, 0.704915, 4.191),
  ('table', 'behind', 0.704915, 0.727821, 4.615),
  ('table', 'behind', 0.727821, 0.822222, 1.038),
  ('table', 'behind', 0.822222, 1, 0.06194);
DELETE FROM class_density WHERE class = 'table' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'height', -0.5, -0.00300238, 0.01268),
  ('table', 'height', -0.00300238, 0.125102, 0.05921),
  ('table', 'height', 0.125102, 0.253206, 4.114e-05),
  ('table', 'height', 0.253206, 0.38131, 0.001248),
  ('table', 'height', 0.38131, 0.509414, 0.01526),
  ('table', 'height', 0.509414, 0.637518, 0.4948),
  ('table', 'height', 0.637518, 0.649645, 2.91),
  ('table', 'height', 0.649645, 0.687882, 3.249),
  ('table', 'height', 0.687882, 0.708661, 5.352),
  ('table', 'height', 0.708661, 0.72427, 6.188),
  ('table', 'height', 0.72427, 0.739635, 6.224),
  ('table', 'height', 0.739635, 0.76422, 4.88),
  ('table', 'height', 0.76422, 0.78375, 4.543),
  ('table', 'height', 0.78375, 0.843687, 2.138),
  ('table', 'height', 0.843687, 0.893726, 0.9039),
  ('table', 'height', 0.893726, 1.02183, 0.3486),
  ('table', 'height', 1.02183, 1.14993, 0.2055),
  ('table', 'height', 1.14993, 4, 0.001613);
DELETE FROM class_density WHERE class = 'table' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'length', 0.03, 0.59512, 0.004257),
  ('table', 'length', 0.59512, 0.710922, 0.1925),
  ('table', 'length', 0.710922, 0.806702, 0.4243),
  ('table', 'length', 0.806702, 0.849259, 0.3529),
  ('table', 'length', 0.849259, 0.990276, 0.6768),
  ('table', 'length', 0.990276, 1.01451, 1.209),
  ('table', 'length', 1.01451, 1.18713, 0.5617),
  ('table', 'length', 1.18713, 1.21192, 1.362),
  ('table', 'length', 1.21192, 1.29823, 1.108),
  ('table', 'length', 1.29823, 1.43351, 1.045),
  ('table', 'length', 1.43351, 1.60313, 1.028),
  ('table', 'length', 1.60313, 1.72946, 1.227),
  ('table', 'length', 1.72946, 1.78669, 0.8903),
  ('table', 'length', 1.78669, 1.93914, 1.29),
  ('table', 'length', 1.93914, 2.06599, 0.6921),
  ('table', 'length', 2.06599, 2.46801, 0.1985),
  ('table', 'length', 2.46801, 2.94825, 0.09312),
  ('table', 'length', 2.94825, 30, 0.00582);
DELETE FROM class_density WHERE class = 'table' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'rectangularity', 0, 0.361753, 0.03063),
  ('table', 'rectangularity', 0.361753, 0.429417, 0.3436),
  ('table', 'rectangularity', 0.429417, 0.497081, 0.6024),
  ('table', 'rectangularity', 0.497081, 0.526865, 1.359),
  ('table', 'rectangularity', 0.526865, 0.564746, 1.223),
  ('table', 'rectangularity', 0.564746, 0.611479, 1.277),
  ('table', 'rectangularity', 0.611479, 0.63241, 2.64),
  ('table', 'rectangularity', 0.63241, 0.663442, 2.219),
  ('table', 'rectangularity', 0.663442, 0.699224, 2.761),
  ('table', 'rectangularity', 0.699224, 0.734175, 3.384),
  ('table', 'rectangularity', 0.734175, 0.767739, 3.004),
  ('table', 'rectangularity', 0.767739, 0.806239, 3.014),
  ('table', 'rectangularity', 0.806239, 0.835404, 2.541),
  ('table', 'rectangularity', 0.835404, 0.849322, 2.451),
  ('table', 'rectangularity', 0.849322, 0.903068, 1.307),
  ('table', 'rectangularity', 0.903068, 0.959089, 0.5862),
  ('table', 'rectangularity', 0.959089, 0.970732, 0.2735),
  ('table', 'rectangularity', 0.970732, 1, 0.2027);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_length', 0.01, 0.46925, 0.003036),
  ('table', 'spread_length', 0.46925, 0.564652, 0.1311),
  ('table', 'spread_length', 0.564652, 0.679449, 0.1707),
  ('table', 'spread_length', 0.679449, 0.765385, 0.4224),
  ('table', 'spread_length', 0.765385, 0.817586, 0.566),
  ('table', 'spread_length', 0.817586, 0.878931, 0.9795),
  ('table', 'spread_length', 0.878931, 0.983806, 0.7799),
  ('table', 'spread_length', 0.983806, 1.02396, 0.5966),
  ('table', 'spread_length', 1.02396, 1.14436, 0.9556),
  ('table', 'spread_length', 1.14436, 1.18382, 1.002),
  ('table', 'spread_length', 1.18382, 1.26195, 1.225),
  ('table', 'spread_length', 1.26195, 1.36319, 1.366),
  ('table', 'spread_length', 1.36319, 1.4245, 1.085),
  ('table', 'spread_length', 1.4245, 1.51144, 1.206),
  ('table', 'spread_length', 1.51144, 1.65048, 1.174),
  ('table', 'spread_length', 1.65048, 1.71411, 0.7345),
  ('table', 'spread_length', 1.71411, 2.0626, 0.284),
  ('table', 'spread_length', 2.0626, 2.48194, 0.121),
  ('table', 'spread_length', 2.48194, 40, 0.004701);
DELETE FROM class_density WHERE class = 'table' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'spread_width', 0.003, 0.178087, 0.002607),
  ('table', 'spread_width', 0.178087, 0.222335, 0.08089),
  ('table', 'spread_width', 0.222335, 0.277575, 0.1005),
  ('table', 'spread_width', 0.277575, 0.346541, 0.157),
  ('table', 'spread_width', 0.346541, 0.39844, 0.1982),
  ('table', 'spread_width', 0.39844, 0.432641, 0.2332),
  ('table', 'spread_width', 0.432641, 0.522379, 0.5082),
  ('table', 'spread_width', 0.522379, 0.540134, 0.7076),
  ('table', 'spread_width', 0.540134, 0.63174, 0.6155),
  ('table', 'spread_width', 0.63174, 0.674149, 1.587),
  ('table', 'spread_width', 0.674149, 0.708786, 2.069),
  ('table', 'spread_width', 0.708786, 0.764633, 1.55),
  ('table', 'spread_width', 0.764633, 0.828832, 1.339),
  ('table', 'spread_width', 0.828832, 0.841876, 1.614),
  ('table', 'spread_width', 0.841876, 0.899684, 1.248),
  ('table', 'spread_width', 0.899684, 1.05105, 0.4527),
  ('table', 'spread_width', 1.05105, 1.31219, 0.1288),
  ('table', 'spread_width', 1.31219, 20, 0.00447);
DELETE FROM class_density WHERE class = 'table' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'tilt_deg', 0, 0.155081, 0.8613),
  ('table', 'tilt_deg', 0.155081, 0.352063, 0.8616),
  ('table', 'tilt_deg', 0.352063, 0.487847, 0.8017),
  ('table', 'tilt_deg', 0.487847, 0.650663, 0.6839),
  ('table', 'tilt_deg', 0.650663, 0.913914, 0.4977),
  ('table', 'tilt_deg', 0.913914, 1.05619, 0.3814),
  ('table', 'tilt_deg', 1.05619, 1.209, 0.3475),
  ('table', 'tilt_deg', 1.209, 1.40825, 0.3127),
  ('table', 'tilt_deg', 1.40825, 1.65758, 0.2448),
  ('table', 'tilt_deg', 1.65758, 2.11238, 0.1529),
  ('table', 'tilt_deg', 2.11238, 2.46444, 0.06678),
  ('table', 'tilt_deg', 2.46444, 2.8165, 0.03859),
  ('table', 'tilt_deg', 2.8165, 3.16857, 0.02039),
  ('table', 'tilt_deg', 3.16857, 90, 1.12e-05);
DELETE FROM class_density WHERE class = 'table' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'width', 0.01, 0.223995, 0.002706),
  ('table', 'width', 0.223995, 0.282693, 0.0726),
  ('table', 'width', 0.282693, 0.356773, 0.1181),
  ('table', 'width', 0.356773, 0.450266, 0.1469),
  ('table', 'width', 0.450266, 0.520278, 0.2233),
  ('table', 'width', 0.520278, 0.568259, 0.3123),
  ('table', 'width', 0.568259, 0.651258, 0.5803),
  ('table', 'width', 0.651258, 0.717171, 0.8709),
  ('table', 'width', 0.717171, 0.733647, 1.245),
  ('table', 'width', 0.733647, 0.810148, 1.116),
  ('table', 'width', 0.810148, 0.855123, 1.963),
  ('table', 'width', 0.855123, 0.901268, 2.076),
  ('table', 'width', 0.901268, 0.957435, 1.763),
  ('table', 'width', 0.957435, 1.05101, 1.153),
  ('table', 'width', 1.05101, 1.14229, 0.5551),
  ('table', 'width', 1.14229, 1.44163, 0.1964),
  ('table', 'width', 1.44163, 1.81941, 0.09328),
  ('table', 'width', 1.81941, 12, 0.004403);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_max', -0.5, 0.00942364, 0.01313),
  ('table', 'z_max', 0.00942364, 0.136315, 0.05672),
  ('table', 'z_max', 0.136315, 0.263207, 4.337e-05),
  ('table', 'z_max', 0.263207, 0.390099, 0.001269),
  ('table', 'z_max', 0.390099, 0.516991, 0.0152),
  ('table', 'z_max', 0.516991, 0.643883, 0.4157),
  ('table', 'z_max', 0.643883, 0.66492, 2.553),
  ('table', 'z_max', 0.66492, 0.693429, 4.013),
  ('table', 'z_max', 0.693429, 0.712473, 5.546),
  ('table', 'z_max', 0.712473, 0.730143, 5.698),
  ('table', 'z_max', 0.730143, 0.748073, 6.081),
  ('table', 'z_max', 0.748073, 0.769035, 5.062),
  ('table', 'z_max', 0.769035, 0.793224, 4.217),
  ('table', 'z_max', 0.793224, 0.854618, 1.961),
  ('table', 'z_max', 0.854618, 0.897666, 0.8648),
  ('table', 'z_max', 0.897666, 1.02456, 0.3836),
  ('table', 'z_max', 1.02456, 1.15145, 0.2158),
  ('table', 'z_max', 1.15145, 4, 0.002107);
DELETE FROM class_density WHERE class = 'table' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('table', 'z_min', -0.5, -0.0106894, 0.01289),
  ('table', 'z_min', -0.0106894, 0.117977, 0.05892),
  ('table', 'z_min', 0.117977, 0.246643, 3.893e-05),
  ('table', 'z_min', 0.246643, 0.37531, 0.001223),
  ('table', 'z_min', 0.37531, 0.503976, 0.0153),
  ('table', 'z_min', 0.503976, 0.632643, 0.5505),
  ('table', 'z_min', 0.632643, 0.643638, 3.006),
  ('table', 'z_min', 0.643638, 0.683012, 3.056),
  ('table', 'z_min', 0.683012, 0.704383, 5.354),
  ('table', 'z_min', 0.704383, 0.720469, 6.067),
  ('table', 'z_min', 0.720469, 0.735176, 6.151),
  ('table', 'z_min', 0.735176, 0.760177, 4.824),
  ('table', 'z_min', 0.760177, 0.778495, 4.784),
  ('table', 'z_min', 0.778495, 0.836736, 2.221),
  ('table', 'z_min', 0.836736, 0.889975, 0.8995),
  ('table', 'z_min', 0.889975, 1.01864, 0.3305),
  ('table', 'z_min', 1.01864, 1.14731, 0.1935),
  ('table', 'z_min', 1.14731, 4, 0.001529);

-- flat_screen: 179 examples
UPDATE object_class SET prior = 0.03747 WHERE name = 'flat_screen';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'area_m2', -1.818, 0.4166)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'aspect', 0.4008, 0.2221)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'behind', 0.5672, 0.1432)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'height', 1.03, 0.1178)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'length', -0.5852, 0.2671)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'rectangularity', 0.7935, 0.1109)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_length', -0.7588, 0.214)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'spread_width', -1.2, 0.1812)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'tilt_deg', 85.1, 3.459)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'width', -0.9871, 0.222)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_max', 1.189, 0.1229)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('flat_screen', 'z_min', 0.7937, 0.1363)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'area_m2', 0.002, 0.0430928, 0.002509),
  ('flat_screen', 'area_m2', 0.0430928, 0.0546752, 0.04951),
  ('flat_screen', 'area_m2', 0.0546752, 0.0693706, 0.06363),
  ('flat_screen', 'area_m2', 0.0693706, 0.0880158, 0.1967),
  ('flat_screen', 'area_m2', 0.0880158, 0.0965881, 0.3516),
  ('flat_screen', 'area_m2', 0.0965881, 0.111672, 0.472),
  ('flat_screen', 'area_m2', 0.111672, 0.116623, 0.7301),
  ('flat_screen', 'area_m2', 0.116623, 0.141688, 0.6326),
  ('flat_screen', 'area_m2', 0.141688, 0.165485, 0.7802),
  ('flat_screen', 'area_m2', 0.165485, 0.17977, 1.229),
  ('flat_screen', 'area_m2', 0.17977, 0.207246, 0.7721),
  ('flat_screen', 'area_m2', 0.207246, 0.228088, 1.019),
  ('flat_screen', 'area_m2', 0.228088, 0.252933, 1.112),
  ('flat_screen', 'area_m2', 0.252933, 0.289393, 0.5146),
  ('flat_screen', 'area_m2', 0.289393, 0.367175, 0.1589),
  ('flat_screen', 'area_m2', 0.367175, 100, 0.001808);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'aspect', 1, 1.01896, 0.8352),
  ('flat_screen', 'aspect', 1.01896, 1.11997, 0.9294),
  ('flat_screen', 'aspect', 1.11997, 1.26738, 0.9944),
  ('flat_screen', 'aspect', 1.26738, 1.34569, 1.69),
  ('flat_screen', 'aspect', 1.34569, 1.41355, 2.297),
  ('flat_screen', 'aspect', 1.41355, 1.43164, 1.616),
  ('flat_screen', 'aspect', 1.43164, 1.52336, 1.247),
  ('flat_screen', 'aspect', 1.52336, 1.60564, 2.294),
  ('flat_screen', 'aspect', 1.60564, 1.69555, 2.056),
  ('flat_screen', 'aspect', 1.69555, 1.81854, 1.057),
  ('flat_screen', 'aspect', 1.81854, 1.98866, 0.5783),
  ('flat_screen', 'aspect', 1.98866, 2.0496, 0.415),
  ('flat_screen', 'aspect', 2.0496, 2.31001, 0.3764),
  ('flat_screen', 'aspect', 2.31001, 2.6035, 0.1759),
  ('flat_screen', 'aspect', 2.6035, 2.93429, 0.1109),
  ('flat_screen', 'aspect', 2.93429, 100, 0.003088);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'behind', 0, 0.133073, 0.07249),
  ('flat_screen', 'behind', 0.133073, 0.212299, 0.242),
  ('flat_screen', 'behind', 0.212299, 0.291526, 0.3835),
  ('flat_screen', 'behind', 0.291526, 0.370752, 0.5313),
  ('flat_screen', 'behind', 0.370752, 0.381549, 0.8947),
  ('flat_screen', 'behind', 0.381549, 0.449978, 1.073),
  ('flat_screen', 'behind', 0.449978, 0.474917, 1.561),
  ('flat_screen', 'behind', 0.474917, 0.523892, 2.279),
  ('flat_screen', 'behind', 0.523892, 0.576837, 2.13),
  ('flat_screen', 'behind', 0.576837, 0.608431, 2.476),
  ('flat_screen', 'behind', 0.608431, 0.616957, 2.975),
  ('flat_screen', 'behind', 0.616957, 0.650937, 3.579),
  ('flat_screen', 'behind', 0.650937, 0.67744, 3.773),
  ('flat_screen', 'behind', 0.67744, 0.687657, 4.057),
  ('flat_screen', 'behind', 0.687657, 0.714935, 2.682),
  ('flat_screen', 'behind', 0.714935, 0.766884, 1.547),
  ('flat_screen', 'behind', 0.766884, 0.84611, 0.2768),
  ('flat_screen', 'behind', 0.84611, 1, 0.06621);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'height', -0.5, 0.698683, 0.008865),
  ('flat_screen', 'height', 0.698683, 0.776334, 0.0111),
  ('flat_screen', 'height', 0.776334, 0.853986, 0.2185),
  ('flat_screen', 'height', 0.853986, 0.924068, 1.288),
  ('flat_screen', 'height', 0.924068, 0.931638, 2.501),
  ('flat_screen', 'height', 0.931638, 0.959557, 3.482),
  ('flat_screen', 'height', 0.959557, 0.979918, 4.913),
  ('flat_screen', 'height', 0.979918, 0.998556, 5.762),
  ('flat_screen', 'height', 0.998556, 1.00929, 5.625),
  ('flat_screen', 'height', 1.00929, 1.01812, 4.897),
  ('flat_screen', 'height', 1.01812, 1.04188, 4.441),
  ('flat_screen', 'height', 1.04188, 1.07434, 3.628),
  ('flat_screen', 'height', 1.07434, 1.08694, 2.439),
  ('flat_screen', 'height', 1.08694, 1.16459, 1.103),
  ('flat_screen', 'height', 1.16459, 1.17449, 0.7765),
  ('flat_screen', 'height', 1.17449, 1.24225, 0.4672),
  ('flat_screen', 'height', 1.24225, 1.3199, 0.3432),
  ('flat_screen', 'height', 1.3199, 1.39755, 0.5116),
  ('flat_screen', 'height', 1.39755, 4, 0.003359);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'length', 0.03, 0.304391, 0.004841),
  ('flat_screen', 'length', 0.304391, 0.349021, 0.2185),
  ('flat_screen', 'length', 0.349021, 0.382731, 0.7554),
  ('flat_screen', 'length', 0.382731, 0.400195, 0.7979),
  ('flat_screen', 'length', 0.400195, 0.449065, 0.6547),
  ('flat_screen', 'length', 0.449065, 0.458873, 0.8277),
  ('flat_screen', 'length', 0.458873, 0.512035, 0.8881),
  ('flat_screen', 'length', 0.512035, 0.526154, 1.551),
  ('flat_screen', 'length', 0.526154, 0.540826, 2.13),
  ('flat_screen', 'length', 0.540826, 0.584316, 1.539),
  ('flat_screen', 'length', 0.584316, 0.603299, 1.75),
  ('flat_screen', 'length', 0.603299, 0.617614, 1.793),
  ('flat_screen', 'length', 0.617614, 0.682063, 1.236),
  ('flat_screen', 'length', 0.682063, 0.691756, 1.262),
  ('flat_screen', 'length', 0.691756, 0.77168, 0.8828),
  ('flat_screen', 'length', 0.77168, 0.793183, 0.5194),
  ('flat_screen', 'length', 0.793183, 0.909481, 0.4037),
  ('flat_screen', 'length', 0.909481, 1.04283, 0.1979),
  ('flat_screen', 'length', 1.04283, 30, 0.003457);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'rectangularity', 0, 0.506562, 0.01883),
  ('flat_screen', 'rectangularity', 0.506562, 0.561388, 0.2882),
  ('flat_screen', 'rectangularity', 0.561388, 0.616215, 0.5469),
  ('flat_screen', 'rectangularity', 0.616215, 0.656793, 1.415),
  ('flat_screen', 'rectangularity', 0.656793, 0.671041, 2.165),
  ('flat_screen', 'rectangularity', 0.671041, 0.697484, 2.882),
  ('flat_screen', 'rectangularity', 0.697484, 0.725868, 2.931),
  ('flat_screen', 'rectangularity', 0.725868, 0.736782, 2.225),
  ('flat_screen', 'rectangularity', 0.736782, 0.780329, 2.627),
  ('flat_screen', 'rectangularity', 0.780329, 0.820905, 2.904),
  ('flat_screen', 'rectangularity', 0.820905, 0.835521, 4.088),
  ('flat_screen', 'rectangularity', 0.835521, 0.851143, 3.03),
  ('flat_screen', 'rectangularity', 0.851143, 0.886886, 3.196),
  ('flat_screen', 'rectangularity', 0.886886, 0.941257, 1.981),
  ('flat_screen', 'rectangularity', 0.941257, 0.98263, 2.383),
  ('flat_screen', 'rectangularity', 0.98263, 1, 0.7406);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_length', 0.01, 0.285585, 0.00281),
  ('flat_screen', 'spread_length', 0.285585, 0.318954, 0.1891),
  ('flat_screen', 'spread_length', 0.318954, 0.349503, 0.8923),
  ('flat_screen', 'spread_length', 0.349503, 0.356222, 1.415),
  ('flat_screen', 'spread_length', 0.356222, 0.382951, 1.083),
  ('flat_screen', 'spread_length', 0.382951, 0.397844, 1.128),
  ('flat_screen', 'spread_length', 0.397844, 0.430506, 1.063),
  ('flat_screen', 'spread_length', 0.430506, 0.44433, 1.515),
  ('flat_screen', 'spread_length', 0.44433, 0.459306, 1.52),
  ('flat_screen', 'spread_length', 0.459306, 0.496247, 1.191),
  ('flat_screen', 'spread_length', 0.496247, 0.505791, 1.793),
  ('flat_screen', 'spread_length', 0.505791, 0.526175, 2.519),
  ('flat_screen', 'spread_length', 0.526175, 0.54586, 2.47),
  ('flat_screen', 'spread_length', 0.54586, 0.554231, 1.676),
  ('flat_screen', 'spread_length', 0.554231, 0.595005, 1.435),
  ('flat_screen', 'spread_length', 0.595005, 0.61899, 0.9382),
  ('flat_screen', 'spread_length', 0.61899, 0.691315, 0.4027),
  ('flat_screen', 'spread_length', 0.691315, 0.772092, 0.1869),
  ('flat_screen', 'spread_length', 0.772092, 40, 0.00289);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'spread_width', 0.003, 0.148289, 0.002576),
  ('flat_screen', 'spread_width', 0.148289, 0.165679, 0.07748),
  ('flat_screen', 'spread_width', 0.165679, 0.185108, 0.1402),
  ('flat_screen', 'spread_width', 0.185108, 0.206816, 0.1275),
  ('flat_screen', 'spread_width', 0.206816, 0.231069, 0.2016),
  ('flat_screen', 'spread_width', 0.231069, 0.251237, 0.463),
  ('flat_screen', 'spread_width', 0.251237, 0.258167, 0.7684),
  ('flat_screen', 'spread_width', 0.258167, 0.272685, 1.818),
  ('flat_screen', 'spread_width', 0.272685, 0.288442, 1.99),
  ('flat_screen', 'spread_width', 0.288442, 0.303429, 2.066),
  ('flat_screen', 'spread_width', 0.303429, 0.318752, 2.463),
  ('flat_screen', 'spread_width', 0.318752, 0.330131, 2.729),
  ('flat_screen', 'spread_width', 0.330131, 0.34524, 2.472),
  ('flat_screen', 'spread_width', 0.34524, 0.36006, 2.088),
  ('flat_screen', 'spread_width', 0.36006, 0.402284, 1.177),
  ('flat_screen', 'spread_width', 0.402284, 20, 0.001979);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'tilt_deg', 0, 75.8549, 0.0001428),
  ('flat_screen', 'tilt_deg', 75.8549, 77.4266, 0.002694),
  ('flat_screen', 'tilt_deg', 77.4266, 78.9982, 0.005998),
  ('flat_screen', 'tilt_deg', 78.9982, 80.207, 0.06844),
  ('flat_screen', 'tilt_deg', 80.207, 80.5699, 0.04453),
  ('flat_screen', 'tilt_deg', 80.5699, 81.783, 0.08004),
  ('flat_screen', 'tilt_deg', 81.783, 82.1416, 0.0521),
  ('flat_screen', 'tilt_deg', 82.1416, 83.3812, 0.07573),
  ('flat_screen', 'tilt_deg', 83.3812, 83.7133, 0.08613),
  ('flat_screen', 'tilt_deg', 83.7133, 84.7305, 0.07298),
  ('flat_screen', 'tilt_deg', 84.7305, 85.285, 0.0683),
  ('flat_screen', 'tilt_deg', 85.285, 86.1366, 0.09848),
  ('flat_screen', 'tilt_deg', 86.1366, 86.8566, 0.06535),
  ('flat_screen', 'tilt_deg', 86.8566, 87.4854, 0.09919),
  ('flat_screen', 'tilt_deg', 87.4854, 88.4283, 0.1138),
  ('flat_screen', 'tilt_deg', 88.4283, 89.1337, 0.1652),
  ('flat_screen', 'tilt_deg', 89.1337, 90, 0.1259);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'width', 0.01, 0.180306, 0.003411),
  ('flat_screen', 'width', 0.180306, 0.205697, 0.08886),
  ('flat_screen', 'width', 0.205697, 0.234663, 0.1401),
  ('flat_screen', 'width', 0.234663, 0.267709, 0.2847),
  ('flat_screen', 'width', 0.267709, 0.276212, 0.9314),
  ('flat_screen', 'width', 0.276212, 0.305408, 0.7216),
  ('flat_screen', 'width', 0.305408, 0.327278, 0.7871),
  ('flat_screen', 'width', 0.327278, 0.348416, 1.318),
  ('flat_screen', 'width', 0.348416, 0.356218, 1.392),
  ('flat_screen', 'width', 0.356218, 0.377534, 1.82),
  ('flat_screen', 'width', 0.377534, 0.39748, 1.742),
  ('flat_screen', 'width', 0.39748, 0.405472, 1.574),
  ('flat_screen', 'width', 0.405472, 0.422098, 2.279),
  ('flat_screen', 'width', 0.422098, 0.439064, 2.568),
  ('flat_screen', 'width', 0.439064, 0.453454, 2.363),
  ('flat_screen', 'width', 0.453454, 0.466039, 1.765),
  ('flat_screen', 'width', 0.466039, 0.51731, 0.7362),
  ('flat_screen', 'width', 0.51731, 0.590158, 0.1814),
  ('flat_screen', 'width', 0.590158, 12, 0.002738);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_max', -0.5, 0.867184, 0.007863),
  ('flat_screen', 'z_max', 0.867184, 0.945633, 0.01598),
  ('flat_screen', 'z_max', 0.945633, 1.02408, 0.468),
  ('flat_screen', 'z_max', 1.02408, 1.0672, 1.442),
  ('flat_screen', 'z_max', 1.0672, 1.10253, 2.422),
  ('flat_screen', 'z_max', 1.10253, 1.11044, 4.196),
  ('flat_screen', 'z_max', 1.11044, 1.13412, 4.469),
  ('flat_screen', 'z_max', 1.13412, 1.15793, 4.575),
  ('flat_screen', 'z_max', 1.15793, 1.17963, 4.655),
  ('flat_screen', 'z_max', 1.17963, 1.20546, 4.57),
  ('flat_screen', 'z_max', 1.20546, 1.22974, 3.986),
  ('flat_screen', 'z_max', 1.22974, 1.25943, 1.752),
  ('flat_screen', 'z_max', 1.25943, 1.33788, 0.9148),
  ('flat_screen', 'z_max', 1.33788, 1.41633, 0.5438),
  ('flat_screen', 'z_max', 1.41633, 1.49478, 0.4343),
  ('flat_screen', 'z_max', 1.49478, 1.56382, 0.4485),
  ('flat_screen', 'z_max', 1.56382, 1.57322, 0.3105),
  ('flat_screen', 'z_max', 1.57322, 4, 0.002198);
DELETE FROM class_density WHERE class = 'flat_screen' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('flat_screen', 'z_min', -0.5, 0.454226, 0.01139),
  ('flat_screen', 'z_min', 0.454226, 0.541854, 0.02482),
  ('flat_screen', 'z_min', 0.541854, 0.629481, 0.4344),
  ('flat_screen', 'z_min', 0.629481, 0.668974, 2.014),
  ('flat_screen', 'z_min', 0.668974, 0.69184, 3.675),
  ('flat_screen', 'z_min', 0.69184, 0.717109, 3.222),
  ('flat_screen', 'z_min', 0.717109, 0.728854, 3.974),
  ('flat_screen', 'z_min', 0.728854, 0.746869, 4.977),
  ('flat_screen', 'z_min', 0.746869, 0.77161, 4.197),
  ('flat_screen', 'z_min', 0.77161, 0.804737, 2.504),
  ('flat_screen', 'z_min', 0.804737, 0.81793, 2.826),
  ('flat_screen', 'z_min', 0.81793, 0.872103, 2.113),
  ('flat_screen', 'z_min', 0.872103, 0.892365, 2.42),
  ('flat_screen', 'z_min', 0.892365, 0.954751, 1.105),
  ('flat_screen', 'z_min', 0.954751, 0.979992, 0.6204),
  ('flat_screen', 'z_min', 0.979992, 1.06762, 0.409),
  ('flat_screen', 'z_min', 1.06762, 1.15525, 0.3635),
  ('flat_screen', 'z_min', 1.15525, 1.24288, 0.2242),
  ('flat_screen', 'z_min', 1.24288, 4, 0.002929);

-- keyboard: 106 examples
UPDATE object_class SET prior = 0.02226 WHERE name = 'keyboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'area_m2', -2.778, 0.409)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'aspect', 0.7684, 0.3207)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'behind', 0.2491, 0.1568)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'height', 0.7836, 0.1043)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'length', -0.9088, 0.2983)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'rectangularity', 0.8286, 0.08396)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_length', -0.9659, 0.3064)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'spread_width', -1.827, 0.1406)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'tilt_deg', 3.788, 2.126)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'width', -1.677, 0.2242)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_max', 0.7915, 0.1055)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('keyboard', 'z_min', 0.7765, 0.1035)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'area_m2', 0.002, 0.0158006, 0.002663),
  ('keyboard', 'area_m2', 0.0158006, 0.0203398, 0.05915),
  ('keyboard', 'area_m2', 0.0203398, 0.0261831, 0.0997),
  ('keyboard', 'area_m2', 0.0261831, 0.033705, 0.1279),
  ('keyboard', 'area_m2', 0.033705, 0.040337, 0.2887),
  ('keyboard', 'area_m2', 0.040337, 0.0433877, 0.5197),
  ('keyboard', 'area_m2', 0.0433877, 0.0487207, 0.5393),
  ('keyboard', 'area_m2', 0.0487207, 0.0558522, 0.5086),
  ('keyboard', 'area_m2', 0.0558522, 0.0594557, 0.8512),
  ('keyboard', 'area_m2', 0.0594557, 0.0637099, 1.458),
  ('keyboard', 'area_m2', 0.0637099, 0.0684874, 1.462),
  ('keyboard', 'area_m2', 0.0684874, 0.0718974, 1.45),
  ('keyboard', 'area_m2', 0.0718974, 0.0739467, 1.344),
  ('keyboard', 'area_m2', 0.0739467, 0.0794585, 1.403),
  ('keyboard', 'area_m2', 0.0794585, 0.0925521, 0.675),
  ('keyboard', 'area_m2', 0.0925521, 0.119141, 0.3304),
  ('keyboard', 'area_m2', 0.119141, 0.153367, 0.1348),
  ('keyboard', 'area_m2', 0.153367, 100, 0.001725);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'aspect', 1, 1.01765, 0.3367),
  ('keyboard', 'aspect', 1.01765, 1.16697, 0.3252),
  ('keyboard', 'aspect', 1.16697, 1.36182, 0.3437),
  ('keyboard', 'aspect', 1.36182, 1.58919, 0.4739),
  ('keyboard', 'aspect', 1.58919, 1.6938, 0.6429),
  ('keyboard', 'aspect', 1.6938, 1.85454, 0.8259),
  ('keyboard', 'aspect', 1.85454, 1.93755, 0.9706),
  ('keyboard', 'aspect', 1.93755, 2.15561, 1.073),
  ('keyboard', 'aspect', 2.15561, 2.3171, 1.451),
  ('keyboard', 'aspect', 2.3171, 2.51733, 1.357),
  ('keyboard', 'aspect', 2.51733, 2.86205, 0.8592),
  ('keyboard', 'aspect', 2.86205, 2.94723, 1.69),
  ('keyboard', 'aspect', 2.94723, 3.13176, 1.057),
  ('keyboard', 'aspect', 3.13176, 3.43932, 0.7129),
  ('keyboard', 'aspect', 3.43932, 3.81667, 0.2686),
  ('keyboard', 'aspect', 3.81667, 4.01358, 0.1341),
  ('keyboard', 'aspect', 4.01358, 100, 0.002413);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'behind', 0, 0.0350877, 3.157),
  ('keyboard', 'behind', 0.0350877, 0.0712982, 0.8185),
  ('keyboard', 'behind', 0.0712982, 0.116721, 1.843),
  ('keyboard', 'behind', 0.116721, 0.142596, 2.039),
  ('keyboard', 'behind', 0.142596, 0.175258, 1.584),
  ('keyboard', 'behind', 0.175258, 0.213894, 1.442),
  ('keyboard', 'behind', 0.213894, 0.238456, 2.637),
  ('keyboard', 'behind', 0.238456, 0.259179, 4.568),
  ('keyboard', 'behind', 0.259179, 0.285193, 2.913),
  ('keyboard', 'behind', 0.285193, 0.303571, 2.437),
  ('keyboard', 'behind', 0.303571, 0.356491, 2.038),
  ('keyboard', 'behind', 0.356491, 0.427789, 1.41),
  ('keyboard', 'behind', 0.427789, 0.46516, 0.7391),
  ('keyboard', 'behind', 0.46516, 0.499087, 0.6547),
  ('keyboard', 'behind', 0.499087, 0.570385, 0.5604),
  ('keyboard', 'behind', 0.570385, 0.641683, 0.3268),
  ('keyboard', 'behind', 0.641683, 1, 0.03973);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'height', -0.5, 0.615823, 0.01572),
  ('keyboard', 'height', 0.615823, 0.676527, 1.305),
  ('keyboard', 'height', 0.676527, 0.682687, 2.068),
  ('keyboard', 'height', 0.682687, 0.715855, 3.536),
  ('keyboard', 'height', 0.715855, 0.733419, 5.814),
  ('keyboard', 'height', 0.733419, 0.753109, 5.771),
  ('keyboard', 'height', 0.753109, 0.769754, 5.5),
  ('keyboard', 'height', 0.769754, 0.797346, 4.803),
  ('keyboard', 'height', 0.797346, 0.816863, 4.551),
  ('keyboard', 'height', 0.816863, 0.858638, 1.846),
  ('keyboard', 'height', 0.858638, 0.911964, 1.075),
  ('keyboard', 'height', 0.911964, 0.919342, 1.12),
  ('keyboard', 'height', 0.919342, 0.980045, 0.8054),
  ('keyboard', 'height', 0.980045, 1.04075, 0.2402),
  ('keyboard', 'height', 1.04075, 1.10145, 0.1132),
  ('keyboard', 'height', 1.10145, 1.16216, 0.3641),
  ('keyboard', 'height', 1.16216, 4, 0.003311);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'length', 0.03, 0.161228, 0.005861),
  ('keyboard', 'length', 0.161228, 0.19131, 0.1591),
  ('keyboard', 'length', 0.19131, 0.227006, 0.2028),
  ('keyboard', 'length', 0.227006, 0.269362, 0.1612),
  ('keyboard', 'length', 0.269362, 0.289962, 0.2534),
  ('keyboard', 'length', 0.289962, 0.319621, 0.8347),
  ('keyboard', 'length', 0.319621, 0.327938, 1.002),
  ('keyboard', 'length', 0.327938, 0.379257, 0.5068),
  ('keyboard', 'length', 0.379257, 0.423058, 0.5504),
  ('keyboard', 'length', 0.423058, 0.440555, 2.508),
  ('keyboard', 'length', 0.440555, 0.450021, 3.275),
  ('keyboard', 'length', 0.450021, 0.45558, 3.658),
  ('keyboard', 'length', 0.45558, 0.468093, 3.851),
  ('keyboard', 'length', 0.468093, 0.481144, 3.702),
  ('keyboard', 'length', 0.481144, 0.491744, 3.183),
  ('keyboard', 'length', 0.491744, 0.533988, 0.9522),
  ('keyboard', 'length', 0.533988, 0.633622, 0.2284),
  ('keyboard', 'length', 0.633622, 0.751846, 0.1008),
  ('keyboard', 'length', 0.751846, 30, 0.00397);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'rectangularity', 0, 0.555395, 0.01252),
  ('keyboard', 'rectangularity', 0.555395, 0.604152, 0.195),
  ('keyboard', 'rectangularity', 0.604152, 0.652909, 0.2049),
  ('keyboard', 'rectangularity', 0.652909, 0.701667, 0.9186),
  ('keyboard', 'rectangularity', 0.701667, 0.72699, 1.456),
  ('keyboard', 'rectangularity', 0.72699, 0.750424, 2.357),
  ('keyboard', 'rectangularity', 0.750424, 0.769916, 3.083),
  ('keyboard', 'rectangularity', 0.769916, 0.799181, 3.34),
  ('keyboard', 'rectangularity', 0.799181, 0.82644, 4.984),
  ('keyboard', 'rectangularity', 0.82644, 0.837069, 9.342),
  ('keyboard', 'rectangularity', 0.837069, 0.847938, 6.053),
  ('keyboard', 'rectangularity', 0.847938, 0.862819, 3.355),
  ('keyboard', 'rectangularity', 0.862819, 0.892306, 3.806),
  ('keyboard', 'rectangularity', 0.892306, 0.944823, 1.988),
  ('keyboard', 'rectangularity', 0.944823, 0.979232, 2.851),
  ('keyboard', 'rectangularity', 0.979232, 0.994209, 0.7401),
  ('keyboard', 'rectangularity', 0.994209, 1, 0.3739);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_length', 0.01, 0.160213, 0.006004),
  ('keyboard', 'spread_length', 0.160213, 0.191295, 0.2051),
  ('keyboard', 'spread_length', 0.191295, 0.228406, 0.2201),
  ('keyboard', 'spread_length', 0.228406, 0.263521, 0.1826),
  ('keyboard', 'spread_length', 0.263521, 0.272718, 0.2937),
  ('keyboard', 'spread_length', 0.272718, 0.309216, 0.7757),
  ('keyboard', 'spread_length', 0.309216, 0.325627, 0.909),
  ('keyboard', 'spread_length', 0.325627, 0.3888, 0.3982),
  ('keyboard', 'spread_length', 0.3888, 0.397233, 0.7285),
  ('keyboard', 'spread_length', 0.397233, 0.420729, 1.857),
  ('keyboard', 'spread_length', 0.420729, 0.435945, 2.734),
  ('keyboard', 'spread_length', 0.435945, 0.451062, 3.533),
  ('keyboard', 'spread_length', 0.451062, 0.458534, 4.433),
  ('keyboard', 'spread_length', 0.458534, 0.464229, 4.371),
  ('keyboard', 'spread_length', 0.464229, 0.554291, 0.8697),
  ('keyboard', 'spread_length', 0.554291, 0.661826, 0.07468),
  ('keyboard', 'spread_length', 0.661826, 0.790223, 0.07393),
  ('keyboard', 'spread_length', 0.790223, 40, 0.002425);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'spread_width', 0.003, 0.116518, 0.001917),
  ('keyboard', 'spread_width', 0.116518, 0.117997, 0.199),
  ('keyboard', 'spread_width', 0.117997, 0.126969, 0.3571),
  ('keyboard', 'spread_width', 0.126969, 0.136964, 0.9642),
  ('keyboard', 'spread_width', 0.136964, 0.14447, 2.252),
  ('keyboard', 'spread_width', 0.14447, 0.150769, 2.52),
  ('keyboard', 'spread_width', 0.150769, 0.156781, 2.749),
  ('keyboard', 'spread_width', 0.156781, 0.16207, 3.268),
  ('keyboard', 'spread_width', 0.16207, 0.164292, 3.165),
  ('keyboard', 'spread_width', 0.164292, 0.167999, 2.786),
  ('keyboard', 'spread_width', 0.167999, 0.177442, 2.084),
  ('keyboard', 'spread_width', 0.177442, 0.187618, 1.809),
  ('keyboard', 'spread_width', 0.187618, 0.195087, 1.333),
  ('keyboard', 'spread_width', 0.195087, 0.212586, 0.4086),
  ('keyboard', 'spread_width', 0.212586, 0.231654, 0.1823),
  ('keyboard', 'spread_width', 0.231654, 0.252433, 0.1669),
  ('keyboard', 'spread_width', 0.252433, 20, 0.002372);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'tilt_deg', 0, 1.00225, 0.1094),
  ('keyboard', 'tilt_deg', 1.00225, 2.12741, 0.1029),
  ('keyboard', 'tilt_deg', 2.12741, 2.80473, 0.1646),
  ('keyboard', 'tilt_deg', 2.80473, 3.19111, 0.2202),
  ('keyboard', 'tilt_deg', 3.19111, 4.09483, 0.1646),
  ('keyboard', 'tilt_deg', 4.09483, 4.25482, 0.1846),
  ('keyboard', 'tilt_deg', 4.25482, 4.61981, 0.1855),
  ('keyboard', 'tilt_deg', 4.61981, 5.31852, 0.1359),
  ('keyboard', 'tilt_deg', 5.31852, 5.53599, 0.08973),
  ('keyboard', 'tilt_deg', 5.53599, 6.3795, 0.1142),
  ('keyboard', 'tilt_deg', 6.3795, 7.44593, 0.06463),
  ('keyboard', 'tilt_deg', 7.44593, 8.50963, 0.02643),
  ('keyboard', 'tilt_deg', 8.50963, 9.57334, 0.01216),
  ('keyboard', 'tilt_deg', 9.57334, 90, 0.0001385);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'width', 0.01, 0.129153, 0.003635),
  ('keyboard', 'width', 0.129153, 0.134, 0.3525),
  ('keyboard', 'width', 0.134, 0.144898, 0.9096),
  ('keyboard', 'width', 0.144898, 0.147429, 1.944),
  ('keyboard', 'width', 0.147429, 0.15322, 2.421),
  ('keyboard', 'width', 0.15322, 0.162563, 1.505),
  ('keyboard', 'width', 0.162563, 0.176576, 1.566),
  ('keyboard', 'width', 0.176576, 0.182382, 2.446),
  ('keyboard', 'width', 0.182382, 0.195732, 1.952),
  ('keyboard', 'width', 0.195732, 0.204617, 1.611),
  ('keyboard', 'width', 0.204617, 0.214716, 0.8594),
  ('keyboard', 'width', 0.214716, 0.229562, 0.6505),
  ('keyboard', 'width', 0.229562, 0.253754, 0.7633),
  ('keyboard', 'width', 0.253754, 0.257549, 0.6332),
  ('keyboard', 'width', 0.257549, 0.288947, 0.4245),
  ('keyboard', 'width', 0.288947, 0.324174, 0.2572),
  ('keyboard', 'width', 0.324174, 0.363695, 0.1012),
  ('keyboard', 'width', 0.363695, 12, 0.003327);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_max', -0.5, 0.624868, 0.01417),
  ('keyboard', 'z_max', 0.624868, 0.685972, 1.475),
  ('keyboard', 'z_max', 0.685972, 0.721886, 3.36),
  ('keyboard', 'z_max', 0.721886, 0.738998, 5.801),
  ('keyboard', 'z_max', 0.738998, 0.747076, 5.785),
  ('keyboard', 'z_max', 0.747076, 0.761245, 5.538),
  ('keyboard', 'z_max', 0.761245, 0.778379, 4.967),
  ('keyboard', 'z_max', 0.778379, 0.806662, 4.515),
  ('keyboard', 'z_max', 0.806662, 0.826596, 4.619),
  ('keyboard', 'z_max', 0.826596, 0.869284, 1.911),
  ('keyboard', 'z_max', 0.869284, 0.925842, 1.011),
  ('keyboard', 'z_max', 0.925842, 0.991491, 0.7946),
  ('keyboard', 'z_max', 0.991491, 1.0526, 0.2451),
  ('keyboard', 'z_max', 1.0526, 1.1137, 0.1166),
  ('keyboard', 'z_max', 1.1137, 1.1748, 0.35),
  ('keyboard', 'z_max', 1.1748, 4, 0.003352);
DELETE FROM class_density WHERE class = 'keyboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('keyboard', 'z_min', -0.5, 0.604686, 0.01573),
  ('keyboard', 'z_min', 0.604686, 0.665269, 1.106),
  ('keyboard', 'z_min', 0.665269, 0.677705, 2.259),
  ('keyboard', 'z_min', 0.677705, 0.7088, 3.572),
  ('keyboard', 'z_min', 0.7088, 0.725852, 5.293),
  ('keyboard', 'z_min', 0.725852, 0.74681, 5.939),
  ('keyboard', 'z_min', 0.74681, 0.761781, 6.088),
  ('keyboard', 'z_min', 0.761781, 0.786345, 5.238),
  ('keyboard', 'z_min', 0.786345, 0.809173, 4.273),
  ('keyboard', 'z_min', 0.809173, 0.847018, 1.833),
  ('keyboard', 'z_min', 0.847018, 0.900044, 1.14),
  ('keyboard', 'z_min', 0.900044, 0.9076, 1.17),
  ('keyboard', 'z_min', 0.9076, 0.968183, 0.8654),
  ('keyboard', 'z_min', 0.968183, 1.02877, 0.2372),
  ('keyboard', 'z_min', 1.02877, 1.08935, 0.1094),
  ('keyboard', 'z_min', 1.08935, 1.14993, 0.3661),
  ('keyboard', 'z_min', 1.14993, 4, 0.003545);

-- chair_seat: 137 examples
UPDATE object_class SET prior = 0.02876 WHERE name = 'chair_seat';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'area_m2', -2.069, 0.5775)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'aspect', 0.3205, 0.2926)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'behind', 0.6111, 0.2125)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'height', 0.4735, 0.03346)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'length', -0.7206, 0.2093)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'rectangularity', 0.7484, 0.1313)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_length', -0.7665, 0.2025)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'spread_width', -1.232, 0.3927)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'tilt_deg', 1.434, 1.197)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'width', -1.041, 0.3672)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_max', 0.4798, 0.03382)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_seat', 'z_min', 0.4686, 0.03406)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'area_m2', 0.002, 0.0266615, 0.004106),
  ('chair_seat', 'area_m2', 0.0266615, 0.0351719, 0.1009),
  ('chair_seat', 'area_m2', 0.0351719, 0.046399, 0.1602),
  ('chair_seat', 'area_m2', 0.046399, 0.0551055, 0.1842),
  ('chair_seat', 'area_m2', 0.0551055, 0.0612097, 0.2304),
  ('chair_seat', 'area_m2', 0.0612097, 0.0807481, 0.2693),
  ('chair_seat', 'area_m2', 0.0807481, 0.0847923, 0.3119),
  ('chair_seat', 'area_m2', 0.0847923, 0.106523, 0.4431),
  ('chair_seat', 'area_m2', 0.106523, 0.140526, 0.4116),
  ('chair_seat', 'area_m2', 0.140526, 0.145438, 0.461),
  ('chair_seat', 'area_m2', 0.145438, 0.166617, 0.7795),
  ('chair_seat', 'area_m2', 0.166617, 0.185382, 0.9456),
  ('chair_seat', 'area_m2', 0.185382, 0.196719, 1.661),
  ('chair_seat', 'area_m2', 0.196719, 0.223678, 0.947),
  ('chair_seat', 'area_m2', 0.223678, 0.244557, 0.8401),
  ('chair_seat', 'area_m2', 0.244557, 0.32262, 0.09053),
  ('chair_seat', 'area_m2', 0.32262, 100, 0.002292);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'aspect', 1, 1.05247, 2.346),
  ('chair_seat', 'aspect', 1.05247, 1.09242, 2.579),
  ('chair_seat', 'aspect', 1.09242, 1.12975, 3.039),
  ('chair_seat', 'aspect', 1.12975, 1.1414, 3.015),
  ('chair_seat', 'aspect', 1.1414, 1.18007, 2.375),
  ('chair_seat', 'aspect', 1.18007, 1.27505, 1.418),
  ('chair_seat', 'aspect', 1.27505, 1.30279, 1.609),
  ('chair_seat', 'aspect', 1.30279, 1.42755, 0.8869),
  ('chair_seat', 'aspect', 1.42755, 1.487, 0.4744),
  ('chair_seat', 'aspect', 1.487, 1.69727, 0.575),
  ('chair_seat', 'aspect', 1.69727, 1.77226, 0.7905),
  ('chair_seat', 'aspect', 1.77226, 1.93726, 0.7645),
  ('chair_seat', 'aspect', 1.93726, 2.03569, 0.6549),
  ('chair_seat', 'aspect', 2.03569, 2.21118, 0.4038),
  ('chair_seat', 'aspect', 2.21118, 2.52384, 0.2546),
  ('chair_seat', 'aspect', 2.52384, 2.88071, 0.1814),
  ('chair_seat', 'aspect', 2.88071, 3.28804, 0.1058),
  ('chair_seat', 'aspect', 3.28804, 100, 0.00326);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'behind', 0, 0.0967491, 0.6042),
  ('chair_seat', 'behind', 0.0967491, 0.193498, 0.0703),
  ('chair_seat', 'behind', 0.193498, 0.290247, 0.4005),
  ('chair_seat', 'behind', 0.290247, 0.386996, 0.4135),
  ('chair_seat', 'behind', 0.386996, 0.483745, 0.2845),
  ('chair_seat', 'behind', 0.483745, 0.560741, 0.8885),
  ('chair_seat', 'behind', 0.560741, 0.580495, 2.416),
  ('chair_seat', 'behind', 0.580495, 0.60252, 2.729),
  ('chair_seat', 'behind', 0.60252, 0.656099, 2.004),
  ('chair_seat', 'behind', 0.656099, 0.677244, 3.185),
  ('chair_seat', 'behind', 0.677244, 0.691886, 2.963),
  ('chair_seat', 'behind', 0.691886, 0.727853, 2.802),
  ('chair_seat', 'behind', 0.727853, 0.758027, 3.712),
  ('chair_seat', 'behind', 0.758027, 0.773993, 3.127),
  ('chair_seat', 'behind', 0.773993, 0.798613, 2.386),
  ('chair_seat', 'behind', 0.798613, 0.857143, 1.594),
  ('chair_seat', 'behind', 0.857143, 0.870742, 0.5078),
  ('chair_seat', 'behind', 0.870742, 1, 0.09675);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'height', -0.5, 0.386114, 0.008531),
  ('chair_seat', 'height', 0.386114, 0.406825, 0.9369),
  ('chair_seat', 'height', 0.406825, 0.425157, 4.48),
  ('chair_seat', 'height', 0.425157, 0.439427, 6.468),
  ('chair_seat', 'height', 0.439427, 0.448246, 6.703),
  ('chair_seat', 'height', 0.448246, 0.457767, 7.479),
  ('chair_seat', 'height', 0.457767, 0.468957, 8.728),
  ('chair_seat', 'height', 0.468957, 0.482214, 9.742),
  ('chair_seat', 'height', 0.482214, 0.489668, 10.26),
  ('chair_seat', 'height', 0.489668, 0.50195, 10.71),
  ('chair_seat', 'height', 0.50195, 0.510379, 10.04),
  ('chair_seat', 'height', 0.510379, 0.531089, 5.567),
  ('chair_seat', 'height', 0.531089, 0.5518, 0.9825),
  ('chair_seat', 'height', 0.5518, 0.572511, 0.2639),
  ('chair_seat', 'height', 0.572511, 4, 0.00223);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'length', 0.03, 0.260011, 0.004038),
  ('chair_seat', 'length', 0.260011, 0.300944, 0.2088),
  ('chair_seat', 'length', 0.300944, 0.348321, 0.2936),
  ('chair_seat', 'length', 0.348321, 0.399846, 0.2377),
  ('chair_seat', 'length', 0.399846, 0.443064, 1.183),
  ('chair_seat', 'length', 0.443064, 0.466627, 1.438),
  ('chair_seat', 'length', 0.466627, 0.472406, 2.662),
  ('chair_seat', 'length', 0.472406, 0.485862, 3.629),
  ('chair_seat', 'length', 0.485862, 0.502069, 3.543),
  ('chair_seat', 'length', 0.502069, 0.517418, 3.254),
  ('chair_seat', 'length', 0.517418, 0.540087, 2.305),
  ('chair_seat', 'length', 0.540087, 0.584057, 1.626),
  ('chair_seat', 'length', 0.584057, 0.625113, 0.5834),
  ('chair_seat', 'length', 0.625113, 0.723524, 0.2839),
  ('chair_seat', 'length', 0.723524, 0.837429, 0.1107),
  ('chair_seat', 'length', 0.837429, 0.969265, 0.03341),
  ('chair_seat', 'length', 0.969265, 30, 0.003455);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'rectangularity', 0, 0.434308, 0.0252),
  ('chair_seat', 'rectangularity', 0.434308, 0.494224, 0.3974),
  ('chair_seat', 'rectangularity', 0.494224, 0.553605, 1.166),
  ('chair_seat', 'rectangularity', 0.553605, 0.614056, 1.233),
  ('chair_seat', 'rectangularity', 0.614056, 0.636028, 1.507),
  ('chair_seat', 'rectangularity', 0.636028, 0.673972, 2.345),
  ('chair_seat', 'rectangularity', 0.673972, 0.699034, 1.826),
  ('chair_seat', 'rectangularity', 0.699034, 0.733888, 2.123),
  ('chair_seat', 'rectangularity', 0.733888, 0.751001, 1.504),
  ('chair_seat', 'rectangularity', 0.751001, 0.792994, 2.73),
  ('chair_seat', 'rectangularity', 0.792994, 0.821378, 3.828),
  ('chair_seat', 'rectangularity', 0.821378, 0.85372, 3.1),
  ('chair_seat', 'rectangularity', 0.85372, 0.906506, 2.232),
  ('chair_seat', 'rectangularity', 0.906506, 0.913635, 2.707),
  ('chair_seat', 'rectangularity', 0.913635, 0.957796, 1.754),
  ('chair_seat', 'rectangularity', 0.957796, 0.973551, 0.6623),
  ('chair_seat', 'rectangularity', 0.973551, 1, 0.2031);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_length', 0.01, 0.23386, 0.0009708),
  ('chair_seat', 'spread_length', 0.23386, 0.24264, 0.1778),
  ('chair_seat', 'spread_length', 0.24264, 0.268022, 0.2057),
  ('chair_seat', 'spread_length', 0.268022, 0.307174, 0.2269),
  ('chair_seat', 'spread_length', 0.307174, 0.352047, 0.2879),
  ('chair_seat', 'spread_length', 0.352047, 0.356788, 0.5031),
  ('chair_seat', 'spread_length', 0.356788, 0.403474, 0.4771),
  ('chair_seat', 'spread_length', 0.403474, 0.43918, 0.9013),
  ('chair_seat', 'spread_length', 0.43918, 0.458678, 2.356),
  ('chair_seat', 'spread_length', 0.458678, 0.476391, 3.015),
  ('chair_seat', 'spread_length', 0.476391, 0.490546, 3.27),
  ('chair_seat', 'spread_length', 0.490546, 0.506866, 3.294),
  ('chair_seat', 'spread_length', 0.506866, 0.523505, 3.123),
  ('chair_seat', 'spread_length', 0.523505, 0.529963, 2.824),
  ('chair_seat', 'spread_length', 0.529963, 0.544701, 2.453),
  ('chair_seat', 'spread_length', 0.544701, 0.60738, 0.9399),
  ('chair_seat', 'spread_length', 0.60738, 0.696106, 0.07942),
  ('chair_seat', 'spread_length', 0.696106, 0.797794, 0.09501),
  ('chair_seat', 'spread_length', 0.797794, 40, 0.00226);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'spread_width', 0.003, 0.109576, 0.002998),
  ('chair_seat', 'spread_width', 0.109576, 0.111282, 0.1068),
  ('chair_seat', 'spread_width', 0.111282, 0.129582, 0.1699),
  ('chair_seat', 'spread_width', 0.129582, 0.15324, 0.2604),
  ('chair_seat', 'spread_width', 0.15324, 0.161684, 0.5249),
  ('chair_seat', 'spread_width', 0.161684, 0.181218, 0.604),
  ('chair_seat', 'spread_width', 0.181218, 0.208374, 0.367),
  ('chair_seat', 'spread_width', 0.208374, 0.214304, 0.3318),
  ('chair_seat', 'spread_width', 0.214304, 0.25343, 0.4084),
  ('chair_seat', 'spread_width', 0.25343, 0.267211, 0.5764),
  ('chair_seat', 'spread_width', 0.267211, 0.299699, 0.5913),
  ('chair_seat', 'spread_width', 0.299699, 0.328987, 0.6313),
  ('chair_seat', 'spread_width', 0.328987, 0.354416, 1.26),
  ('chair_seat', 'spread_width', 0.354416, 0.380582, 1.523),
  ('chair_seat', 'spread_width', 0.380582, 0.401638, 2.033),
  ('chair_seat', 'spread_width', 0.401638, 0.419123, 1.881),
  ('chair_seat', 'spread_width', 0.419123, 0.479609, 0.9215),
  ('chair_seat', 'spread_width', 0.479609, 0.495644, 0.2308),
  ('chair_seat', 'spread_width', 0.495644, 20, 0.002942);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'tilt_deg', 0, 0.377811, 0.3477),
  ('chair_seat', 'tilt_deg', 0.377811, 0.549966, 0.5015),
  ('chair_seat', 'tilt_deg', 0.549966, 0.679033, 0.5685),
  ('chair_seat', 'tilt_deg', 0.679033, 0.890066, 0.5765),
  ('chair_seat', 'tilt_deg', 0.890066, 1.10517, 0.4852),
  ('chair_seat', 'tilt_deg', 1.10517, 1.35807, 0.3295),
  ('chair_seat', 'tilt_deg', 1.35807, 1.60638, 0.2352),
  ('chair_seat', 'tilt_deg', 1.60638, 2.0371, 0.2272),
  ('chair_seat', 'tilt_deg', 2.0371, 2.71613, 0.1669),
  ('chair_seat', 'tilt_deg', 2.71613, 3.39516, 0.07363),
  ('chair_seat', 'tilt_deg', 3.39516, 4.0742, 0.04535),
  ('chair_seat', 'tilt_deg', 4.0742, 4.75323, 0.03185),
  ('chair_seat', 'tilt_deg', 4.75323, 5.43226, 0.01964),
  ('chair_seat', 'tilt_deg', 5.43226, 6.0588, 0.01265),
  ('chair_seat', 'tilt_deg', 6.0588, 90, 7.503e-05);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'width', 0.01, 0.139045, 0.00372),
  ('chair_seat', 'width', 0.139045, 0.142151, 0.1251),
  ('chair_seat', 'width', 0.142151, 0.163125, 0.2089),
  ('chair_seat', 'width', 0.163125, 0.191024, 0.4004),
  ('chair_seat', 'width', 0.191024, 0.224518, 0.4155),
  ('chair_seat', 'width', 0.224518, 0.263088, 0.3628),
  ('chair_seat', 'width', 0.263088, 0.309017, 0.357),
  ('chair_seat', 'width', 0.309017, 0.35843, 0.4034),
  ('chair_seat', 'width', 0.35843, 0.401349, 0.9535),
  ('chair_seat', 'width', 0.401349, 0.425316, 1.933),
  ('chair_seat', 'width', 0.425316, 0.440717, 2.783),
  ('chair_seat', 'width', 0.440717, 0.463593, 2.2),
  ('chair_seat', 'width', 0.463593, 0.488947, 1.936),
  ('chair_seat', 'width', 0.488947, 0.498973, 1.31),
  ('chair_seat', 'width', 0.498973, 0.565692, 0.6153),
  ('chair_seat', 'width', 0.565692, 0.585386, 0.1617),
  ('chair_seat', 'width', 0.585386, 12, 0.003593);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_max', -0.5, 0.393153, 0.008567),
  ('chair_seat', 'z_max', 0.393153, 0.413727, 0.9998),
  ('chair_seat', 'z_max', 0.413727, 0.431411, 4.682),
  ('chair_seat', 'z_max', 0.431411, 0.445241, 6.663),
  ('chair_seat', 'z_max', 0.445241, 0.454875, 6.824),
  ('chair_seat', 'z_max', 0.454875, 0.4634, 7.514),
  ('chair_seat', 'z_max', 0.4634, 0.475449, 8.518),
  ('chair_seat', 'z_max', 0.475449, 0.48951, 9.047),
  ('chair_seat', 'z_max', 0.48951, 0.496022, 9.738),
  ('chair_seat', 'z_max', 0.496022, 0.509522, 10.83),
  ('chair_seat', 'z_max', 0.509522, 0.516596, 10.32),
  ('chair_seat', 'z_max', 0.516596, 0.53717, 5.837),
  ('chair_seat', 'z_max', 0.53717, 0.557744, 1.03),
  ('chair_seat', 'z_max', 0.557744, 0.578317, 0.2646),
  ('chair_seat', 'z_max', 0.578317, 4, 0.002278);
DELETE FROM class_density WHERE class = 'chair_seat' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_seat', 'z_min', -0.5, 0.378347, 0.008525),
  ('chair_seat', 'z_min', 0.378347, 0.399499, 0.7936),
  ('chair_seat', 'z_min', 0.399499, 0.42065, 4.151),
  ('chair_seat', 'z_min', 0.42065, 0.437187, 6.673),
  ('chair_seat', 'z_min', 0.437187, 0.451957, 7.24),
  ('chair_seat', 'z_min', 0.451957, 0.462953, 8.131),
  ('chair_seat', 'z_min', 0.462953, 0.477374, 9.488),
  ('chair_seat', 'z_min', 0.477374, 0.484104, 10.18),
  ('chair_seat', 'z_min', 0.484104, 0.491713, 10.48),
  ('chair_seat', 'z_min', 0.491713, 0.498542, 10.62),
  ('chair_seat', 'z_min', 0.498542, 0.505256, 9.992),
  ('chair_seat', 'z_min', 0.505256, 0.526407, 5.721),
  ('chair_seat', 'z_min', 0.526407, 0.547559, 1.048),
  ('chair_seat', 'z_min', 0.547559, 0.56871, 0.2708),
  ('chair_seat', 'z_min', 0.56871, 4, 0.00222);

-- chair_back: 136 examples
UPDATE object_class SET prior = 0.02855 WHERE name = 'chair_back';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'area_m2', -1.747, 0.6153)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'aspect', 0.3797, 0.2711)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'behind', 0.52, 0.3107)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'height', 0.8231, 0.09274)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'length', -0.5456, 0.2919)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'rectangularity', 0.7769, 0.1301)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_length', -0.6839, 0.2512)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'spread_width', -1.125, 0.3926)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'tilt_deg', 80.84, 3.701)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'width', -0.9299, 0.337)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_max', 1.03, 0.1005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('chair_back', 'z_min', 0.461, 0.1825)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'area_m2', 0.002, 0.0285354, 0.004147),
  ('chair_back', 'area_m2', 0.0285354, 0.0394313, 0.06446),
  ('chair_back', 'area_m2', 0.0394313, 0.0544875, 0.1369),
  ('chair_back', 'area_m2', 0.0544875, 0.0713805, 0.1273),
  ('chair_back', 'area_m2', 0.0713805, 0.0752928, 0.1183),
  ('chair_back', 'area_m2', 0.0752928, 0.104042, 0.1673),
  ('chair_back', 'area_m2', 0.104042, 0.124436, 0.336),
  ('chair_back', 'area_m2', 0.124436, 0.143769, 0.4038),
  ('chair_back', 'area_m2', 0.143769, 0.158372, 0.4661),
  ('chair_back', 'area_m2', 0.158372, 0.186248, 0.7044),
  ('chair_back', 'area_m2', 0.186248, 0.198665, 0.8917),
  ('chair_back', 'area_m2', 0.198665, 0.210709, 0.858),
  ('chair_back', 'area_m2', 0.210709, 0.240209, 0.8585),
  ('chair_back', 'area_m2', 0.240209, 0.274523, 0.818),
  ('chair_back', 'area_m2', 0.274523, 0.327138, 0.6272),
  ('chair_back', 'area_m2', 0.327138, 0.379345, 0.3597),
  ('chair_back', 'area_m2', 0.379345, 0.524192, 0.1393),
  ('chair_back', 'area_m2', 0.524192, 100, 0.002523);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'aspect', 1, 1.06715, 1.536),
  ('chair_back', 'aspect', 1.06715, 1.12332, 1.702),
  ('chair_back', 'aspect', 1.12332, 1.13749, 2.374),
  ('chair_back', 'aspect', 1.13749, 1.20368, 1.965),
  ('chair_back', 'aspect', 1.20368, 1.26184, 1.27),
  ('chair_back', 'aspect', 1.26184, 1.31753, 1.044),
  ('chair_back', 'aspect', 1.31753, 1.41744, 0.9654),
  ('chair_back', 'aspect', 1.41744, 1.46189, 1.521),
  ('chair_back', 'aspect', 1.46189, 1.59223, 1.143),
  ('chair_back', 'aspect', 1.59223, 1.62374, 0.8283),
  ('chair_back', 'aspect', 1.62374, 1.78858, 0.6462),
  ('chair_back', 'aspect', 1.78858, 1.93405, 0.798),
  ('chair_back', 'aspect', 1.93405, 2.00914, 1.052),
  ('chair_back', 'aspect', 2.00914, 2.11868, 1.126),
  ('chair_back', 'aspect', 2.11868, 2.2569, 0.7961),
  ('chair_back', 'aspect', 2.2569, 2.53521, 0.2868),
  ('chair_back', 'aspect', 2.53521, 2.84784, 0.1338),
  ('chair_back', 'aspect', 2.84784, 100, 0.003289);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'behind', 0, 0.0976209, 2.097),
  ('chair_back', 'behind', 0.0976209, 0.152542, 0.2602),
  ('chair_back', 'behind', 0.152542, 0.195242, 0.2153),
  ('chair_back', 'behind', 0.195242, 0.292863, 0.252),
  ('chair_back', 'behind', 0.292863, 0.390484, 0.3518),
  ('chair_back', 'behind', 0.390484, 0.482456, 0.6667),
  ('chair_back', 'behind', 0.482456, 0.488105, 0.9612),
  ('chair_back', 'behind', 0.488105, 0.58209, 1.044),
  ('chair_back', 'behind', 0.58209, 0.680851, 1.182),
  ('chair_back', 'behind', 0.680851, 0.757426, 1.381),
  ('chair_back', 'behind', 0.757426, 0.780967, 2.967),
  ('chair_back', 'behind', 0.780967, 0.795964, 2.413),
  ('chair_back', 'behind', 0.795964, 0.821053, 4.035),
  ('chair_back', 'behind', 0.821053, 0.876106, 1.904),
  ('chair_back', 'behind', 0.876106, 1, 0.1083);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'height', -0.5, 0.596861, 0.009483),
  ('chair_back', 'height', 0.596861, 0.647969, 0.3486),
  ('chair_back', 'height', 0.647969, 0.699076, 1.338),
  ('chair_back', 'height', 0.699076, 0.71448, 1.817),
  ('chair_back', 'height', 0.71448, 0.750183, 2.424),
  ('chair_back', 'height', 0.750183, 0.755944, 3.489),
  ('chair_back', 'height', 0.755944, 0.785699, 3.733),
  ('chair_back', 'height', 0.785699, 0.801291, 4.489),
  ('chair_back', 'height', 0.801291, 0.809042, 5.275),
  ('chair_back', 'height', 0.809042, 0.826361, 5.267),
  ('chair_back', 'height', 0.826361, 0.852398, 3.697),
  ('chair_back', 'height', 0.852398, 0.90056, 2.972),
  ('chair_back', 'height', 0.90056, 0.940606, 2.66),
  ('chair_back', 'height', 0.940606, 0.954613, 1.946),
  ('chair_back', 'height', 0.954613, 1.00572, 0.9522),
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
  ('chair_back', 'length', 0.55088, 0.581683, 1.387),
  ('chair_back', 'length', 0.581683, 0.602968, 0.9022),
  ('chair_back', 'length', 0.602968, 0.649113, 1.318),
  ('chair_back', 'length', 0.649113, 0.692816, 0.9315),
  ('chair_back', 'length', 0.692816, 0.732266, 1.232),
  ('chair_back', 'length', 0.732266, 0.807526, 1.109),
  ('chair_back', 'length', 0.807526, 0.825182, 0.7233),
  ('chair_back', 'length', 0.825182, 0.982837, 0.2863),
  ('chair_back', 'length', 0.982837, 1.16595, 0.1759),
  ('chair_back', 'length', 1.16595, 30, 0.004089);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'rectangularity', 0, 0.430802, 0.02135),
  ('chair_back', 'rectangularity', 0.430802, 0.494046, 0.2702),
  ('chair_back', 'rectangularity', 0.494046, 0.55729, 0.676),
  ('chair_back', 'rectangularity', 0.55729, 0.582168, 1.62),
  ('chair_back', 'rectangularity', 0.582168, 0.620535, 1.197),
  ('chair_back', 'rectangularity', 0.620535, 0.676992, 1.183),
  ('chair_back', 'rectangularity', 0.676992, 0.683779, 1.881),
  ('chair_back', 'rectangularity', 0.683779, 0.741738, 1.851),
  ('chair_back', 'rectangularity', 0.741738, 0.783473, 2.519),
  ('chair_back', 'rectangularity', 0.783473, 0.810267, 3.118),
  ('chair_back', 'rectangularity', 0.810267, 0.824089, 2.802),
  ('chair_back', 'rectangularity', 0.824089, 0.849919, 3.873),
  ('chair_back', 'rectangularity', 0.849919, 0.873512, 3.368),
  ('chair_back', 'rectangularity', 0.873512, 0.883415, 3.207),
  ('chair_back', 'rectangularity', 0.883415, 0.922871, 2.56),
  ('chair_back', 'rectangularity', 0.922871, 0.936756, 2.651),
  ('chair_back', 'rectangularity', 0.936756, 0.98555, 1.406),
  ('chair_back', 'rectangularity', 0.98555, 1, 0.8841);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_length', 0.01, 0.23569, 0.003323),
  ('chair_back', 'spread_length', 0.23569, 0.275864, 0.102),
  ('chair_back', 'spread_length', 0.275864, 0.322886, 0.1693),
  ('chair_back', 'spread_length', 0.322886, 0.370553, 0.3677),
  ('chair_back', 'spread_length', 0.370553, 0.377922, 0.3991),
  ('chair_back', 'spread_length', 0.377922, 0.441039, 0.7623),
  ('chair_back', 'spread_length', 0.441039, 0.465056, 2.202),
  ('chair_back', 'spread_length', 0.465056, 0.491154, 2.069),
  ('chair_back', 'spread_length', 0.491154, 0.51093, 1.958),
  ('chair_back', 'spread_length', 0.51093, 0.517738, 1.556),
  ('chair_back', 'spread_length', 0.517738, 0.561518, 1.36),
  ('chair_back', 'spread_length', 0.561518, 0.600491, 1.509),
  ('chair_back', 'spread_length', 0.600491, 0.656153, 1.223),
  ('chair_back', 'spread_length', 0.656153, 0.70928, 0.7682),
  ('chair_back', 'spread_length', 0.70928, 0.830178, 0.1957),
  ('chair_back', 'spread_length', 0.830178, 0.971684, 0.1349),
  ('chair_back', 'spread_length', 0.971684, 40, 0.002993);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'spread_width', 0.003, 0.115275, 0.003668),
  ('chair_back', 'spread_width', 0.115275, 0.139533, 0.1461),
  ('chair_back', 'spread_width', 0.139533, 0.168896, 0.2255),
  ('chair_back', 'spread_width', 0.168896, 0.184959, 0.2932),
  ('chair_back', 'spread_width', 0.184959, 0.204439, 0.2997),
  ('chair_back', 'spread_width', 0.204439, 0.24746, 0.4664),
  ('chair_back', 'spread_width', 0.24746, 0.291992, 0.6895),
  ('chair_back', 'spread_width', 0.291992, 0.299536, 0.4376),
  ('chair_back', 'spread_width', 0.299536, 0.348413, 0.6795),
  ('chair_back', 'spread_width', 0.348413, 0.362569, 1.171),
  ('chair_back', 'spread_width', 0.362569, 0.380825, 1.268),
  ('chair_back', 'spread_width', 0.380825, 0.410553, 1.323),
  ('chair_back', 'spread_width', 0.410553, 0.438868, 1.274),
  ('chair_back', 'spread_width', 0.438868, 0.484106, 1.269),
  ('chair_back', 'spread_width', 0.484106, 0.531223, 0.9489),
  ('chair_back', 'spread_width', 0.531223, 0.643013, 0.1188),
  ('chair_back', 'spread_width', 0.643013, 20, 0.00385);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'tilt_deg', 0, 72.5623, 0.0001302),
  ('chair_back', 'tilt_deg', 72.5623, 74.3644, 0.01632),
  ('chair_back', 'tilt_deg', 74.3644, 76.1665, 0.03467),
  ('chair_back', 'tilt_deg', 76.1665, 76.3488, 0.04398),
  ('chair_back', 'tilt_deg', 76.3488, 77.7524, 0.0778),
  ('chair_back', 'tilt_deg', 77.7524, 77.9686, 0.1261),
  ('chair_back', 'tilt_deg', 77.9686, 78.7994, 0.1142),
  ('chair_back', 'tilt_deg', 78.7994, 79.7706, 0.06847),
  ('chair_back', 'tilt_deg', 79.7706, 80.2286, 0.08218),
  ('chair_back', 'tilt_deg', 80.2286, 81.4338, 0.09526),
  ('chair_back', 'tilt_deg', 81.4338, 82.3117, 0.1134),
  ('chair_back', 'tilt_deg', 82.3117, 83.3748, 0.05056),
  ('chair_back', 'tilt_deg', 83.3748, 84.3547, 0.07154),
  ('chair_back', 'tilt_deg', 84.3547, 85.1768, 0.07459),
  ('chair_back', 'tilt_deg', 85.1768, 85.8765, 0.07081),
  ('chair_back', 'tilt_deg', 85.8765, 86.9789, 0.06383),
  ('chair_back', 'tilt_deg', 86.9789, 88.781, 0.01506),
  ('chair_back', 'tilt_deg', 88.781, 90, 0.00704);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'width', 0.01, 0.165802, 0.00587),
  ('chair_back', 'width', 0.165802, 0.197294, 0.2649),
  ('chair_back', 'width', 0.197294, 0.233382, 0.2774),
  ('chair_back', 'width', 0.233382, 0.27936, 0.2755),
  ('chair_back', 'width', 0.27936, 0.323307, 0.5005),
  ('chair_back', 'width', 0.323307, 0.332421, 0.6162),
  ('chair_back', 'width', 0.332421, 0.395561, 0.5918),
  ('chair_back', 'width', 0.395561, 0.426183, 1.549),
  ('chair_back', 'width', 0.426183, 0.443493, 2.251),
  ('chair_back', 'width', 0.443493, 0.469074, 1.998),
  ('chair_back', 'width', 0.469074, 0.498961, 1.746),
  ('chair_back', 'width', 0.498961, 0.53093, 1.643),
  ('chair_back', 'width', 0.53093, 0.560096, 0.9989),
  ('chair_back', 'width', 0.560096, 0.66648, 0.2062),
  ('chair_back', 'width', 0.66648, 0.79307, 0.1016),
  ('chair_back', 'width', 0.79307, 12, 0.005222);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_max', -0.5, 0.767739, 0.009949),
  ('chair_back', 'z_max', 0.767739, 0.818883, 0.4464),
  ('chair_back', 'z_max', 0.818883, 0.870028, 0.7569),
  ('chair_back', 'z_max', 0.870028, 0.905242, 1.043),
  ('chair_back', 'z_max', 0.905242, 0.921172, 1.401),
  ('chair_back', 'z_max', 0.921172, 0.95852, 2.487),
  ('chair_back', 'z_max', 0.95852, 0.972317, 3.233),
  ('chair_back', 'z_max', 0.972317, 0.99223, 3.553),
  ('chair_back', 'z_max', 0.99223, 1.01708, 4.014),
  ('chair_back', 'z_max', 1.01708, 1.02346, 3.395),
  ('chair_back', 'z_max', 1.02346, 1.05025, 3.366),
  ('chair_back', 'z_max', 1.05025, 1.07461, 3.86),
  ('chair_back', 'z_max', 1.07461, 1.08045, 4.139),
  ('chair_back', 'z_max', 1.08045, 1.11156, 3.535),
  ('chair_back', 'z_max', 1.11156, 1.12575, 2.229),
  ('chair_back', 'z_max', 1.12575, 1.1587, 2.093),
  ('chair_back', 'z_max', 1.1587, 1.1769, 2.889),
  ('chair_back', 'z_max', 1.1769, 1.21919, 1.352),
  ('chair_back', 'z_max', 1.21919, 1.22804, 0.3377),
  ('chair_back', 'z_max', 1.22804, 4, 0.001964);
DELETE FROM class_density WHERE class = 'chair_back' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('chair_back', 'z_min', -0.5, -0.0419979, 0.04189),
  ('chair_back', 'z_min', -0.0419979, 0.0593539, 0.2723),
  ('chair_back', 'z_min', 0.0593539, 0.160706, 0.2085),
  ('chair_back', 'z_min', 0.160706, 0.262058, 0.2186),
  ('chair_back', 'z_min', 0.262058, 0.304523, 0.8181),
  ('chair_back', 'z_min', 0.304523, 0.363113, 1.797),
  ('chair_back', 'z_min', 0.363113, 0.406683, 2.618),
  ('chair_back', 'z_min', 0.406683, 0.431762, 3.633),
  ('chair_back', 'z_min', 0.431762, 0.464761, 2.968),
  ('chair_back', 'z_min', 0.464761, 0.475978, 2.557),
  ('chair_back', 'z_min', 0.475978, 0.51561, 2.442),
  ('chair_back', 'z_min', 0.51561, 0.566113, 1.222),
  ('chair_back', 'z_min', 0.566113, 0.612917, 1.258),
  ('chair_back', 'z_min', 0.612917, 0.658069, 2.195),
  ('chair_back', 'z_min', 0.658069, 0.667465, 2.209),
  ('chair_back', 'z_min', 0.667465, 0.768817, 0.5633),
  ('chair_back', 'z_min', 0.768817, 0.870169, 0.3078),
  ('chair_back', 'z_min', 0.870169, 4, 0.004024);

-- door: 63 examples
UPDATE object_class SET prior = 0.0132 WHERE name = 'door';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'area_m2', 0.2975, 0.5474)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'aspect', 0.7457, 0.2604)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('door', 'behind', 0.2445, 0.303)
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
DELETE FROM class_density WHERE class = 'door' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'height', -0.5, 0.470733, 0.01397),
  ('door', 'height', 0.470733, 0.6039, 0.1149),
  ('door', 'height', 0.6039, 0.737066, 0.148),
  ('door', 'height', 0.737066, 0.870233, 0.1456),
  ('door', 'height', 0.870233, 1.0034, 0.3318),
  ('door', 'height', 1.0034, 1.02684, 1.683),
  ('door', 'height', 1.02684, 1.05092, 3.994),
  ('door', 'height', 1.05092, 1.06677, 5.608),
  ('door', 'height', 1.06677, 1.08354, 4.862),
  ('door', 'height', 1.08354, 1.13331, 2.503),
  ('door', 'height', 1.13331, 1.20929, 1.531),
  ('door', 'height', 1.20929, 1.26973, 1.512),
  ('door', 'height', 1.26973, 1.29078, 1.685),
  ('door', 'height', 1.29078, 1.35469, 1.475),
  ('door', 'height', 1.35469, 1.4029, 0.9525),
  ('door', 'height', 1.4029, 1.53607, 0.3436),
  ('door', 'height', 1.53607, 1.66923, 0.1062),
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
  ('door', 'spread_length', 0.605232, 0.697161, 0.003313),
  ('door', 'spread_length', 0.697161, 0.803052, 0.04013),
  ('door', 'spread_length', 0.803052, 0.925028, 0.2043),
  ('door', 'spread_length', 0.925028, 1.05186, 0.4435),
  ('door', 'spread_length', 1.05186, 1.06553, 0.4823),
  ('door', 'spread_length', 1.06553, 1.22737, 0.4124),
  ('door', 'spread_length', 1.22737, 1.40243, 0.6076),
  ('door', 'spread_length', 1.40243, 1.60894, 0.8432),
  ('door', 'spread_length', 1.60894, 1.62854, 1.883),
  ('door', 'spread_length', 1.62854, 1.69127, 1.953),
  ('door', 'spread_length', 1.69127, 1.8759, 1.087),
  ('door', 'spread_length', 1.8759, 1.96497, 2.889),
  ('door', 'spread_length', 1.96497, 2.00434, 4.921),
  ('door', 'spread_length', 2.00434, 2.12551, 2.705),
  ('door', 'spread_length', 2.12551, 2.16083, 0.4358),
  ('door', 'spread_length', 2.16083, 40, 0.009047);
DELETE FROM class_density WHERE class = 'door' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'spread_width', 0.003, 0.175346, 0.001523),
  ('door', 'spread_width', 0.175346, 0.180444, 0.1679),
  ('door', 'spread_width', 0.180444, 0.2191, 0.08083),
  ('door', 'spread_width', 0.2191, 0.273771, 0.001559),
  ('door', 'spread_width', 0.273771, 0.342085, 0.09092),
  ('door', 'spread_width', 0.342085, 0.427445, 0.1074),
  ('door', 'spread_width', 0.427445, 0.534105, 0.1808),
  ('door', 'spread_width', 0.534105, 0.573149, 0.317),
  ('door', 'spread_width', 0.573149, 0.667379, 0.4023),
  ('door', 'spread_width', 0.667379, 0.76158, 0.5358),
  ('door', 'spread_width', 0.76158, 0.810061, 2.049),
  ('door', 'spread_width', 0.810061, 0.821194, 3.341),
  ('door', 'spread_width', 0.821194, 0.833909, 3.263),
  ('door', 'spread_width', 0.833909, 0.860058, 2.556),
  ('door', 'spread_width', 0.860058, 0.895942, 2.17),
  ('door', 'spread_width', 0.895942, 0.94312, 2.142),
  ('door', 'spread_width', 0.94312, 1.00544, 1.541),
  ('door', 'spread_width', 1.00544, 1.04199, 0.4773),
  ('door', 'spread_width', 1.04199, 1.28252, 0.4484),
  ('door', 'spread_width', 1.28252, 1.302, 0.2852),
  ('door', 'spread_width', 1.302, 20, 0.007802);
DELETE FROM class_density WHERE class = 'door' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('door', 'tilt_deg', 0, 87.0341, 1.034e-05),
  ('door', 'tilt_deg', 87.0341, 87.3636, 0.03344),
  ('door', 'tilt_deg', 87.3636, 87.6932, 0.07581),
  ('door', 'tilt_deg', 87.6932, 88.0227, 0.04331),
  ('door', 'tilt_deg', 88.0227, 88.3523, 0.01461),
  ('door', 'tilt_deg', 88.3523, 88.6818, 0.03309),
  ('door', 'tilt_deg', 88.6818, 89.0114, 0.05713),
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
  ('door', 'z_min', -0.5, -0.072532, 0.1055),
  ('door', 'z_min', -0.072532, -0.015774, 2.506),
  ('door', 'z_min', -0.015774, -0.00765939, 13.34),
  ('door', 'z_min', -0.00765939, 0.00157503, 16.38),
  ('door', 'z_min', 0.00157503, 0.0724814, 3.45),
  ('door', 'z_min', 0.0724814, 0.217495, 0.357),
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
UPDATE object_class SET prior = 0.0226 WHERE name = 'window';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'area_m2', 0.01758, 0.669)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'aspect', 0.352, 0.3259)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'behind', 0, 0.005)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'height', 1.526, 0.1636)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'length', 0.2862, 0.2873)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'rectangularity', 0.8395, 0.1448)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_length', 0.3025, 0.3237)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'spread_width', -0.1321, 0.4476)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'tilt_deg', 89.64, 0.5511)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('window', 'width', -0.06693, 0.3621)
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
  ('window', 'area_m2', 0.637552, 0.770128, 0.2708),
  ('window', 'area_m2', 0.770128, 0.956945, 0.6022),
  ('window', 'area_m2', 0.956945, 1.03215, 1.282),
  ('window', 'area_m2', 1.03215, 1.19215, 0.6828),
  ('window', 'area_m2', 1.19215, 1.40607, 0.7112),
  ('window', 'area_m2', 1.40607, 1.47334, 1.077),
  ('window', 'area_m2', 1.47334, 1.5537, 1.063),
  ('window', 'area_m2', 1.5537, 1.81675, 0.7273),
  ('window', 'area_m2', 1.81675, 2.23973, 0.2577),
  ('window', 'area_m2', 2.23973, 3.40478, 0.04919),
  ('window', 'area_m2', 3.40478, 5.17585, 0.05889),
  ('window', 'area_m2', 5.17585, 100, 0.003088);
DELETE FROM class_density WHERE class = 'window' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'aspect', 1, 1.05795, 2.009),
  ('window', 'aspect', 1.05795, 1.09938, 2.683),
  ('window', 'aspect', 1.09938, 1.14699, 2.511),
  ('window', 'aspect', 1.14699, 1.17588, 1.011),
  ('window', 'aspect', 1.17588, 1.2546, 1.211),
  ('window', 'aspect', 1.2546, 1.36908, 1.457),
  ('window', 'aspect', 1.36908, 1.38268, 3.428),
  ('window', 'aspect', 1.38268, 1.43775, 1.732),
  ('window', 'aspect', 1.43775, 1.60252, 0.9436),
  ('window', 'aspect', 1.60252, 1.62587, 0.6118),
  ('window', 'aspect', 1.62587, 1.91182, 0.3709),
  ('window', 'aspect', 1.91182, 2.1914, 0.3692),
  ('window', 'aspect', 2.1914, 2.24806, 0.3672),
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
DELETE FROM class_density WHERE class = 'window' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'height', -0.5, 1.08935, 0.008416),
  ('window', 'height', 1.08935, 1.19062, 0.2495),
  ('window', 'height', 1.19062, 1.2919, 0.3065),
  ('window', 'height', 1.2919, 1.3585, 0.5844),
  ('window', 'height', 1.3585, 1.39318, 1.015),
  ('window', 'height', 1.39318, 1.42253, 2.781),
  ('window', 'height', 1.42253, 1.45525, 3.271),
  ('window', 'height', 1.45525, 1.49445, 2.56),
  ('window', 'height', 1.49445, 1.5041, 2.11),
  ('window', 'height', 1.5041, 1.53695, 2.956),
  ('window', 'height', 1.53695, 1.57935, 2.481),
  ('window', 'height', 1.57935, 1.59573, 2.913),
  ('window', 'height', 1.59573, 1.63589, 1.847),
  ('window', 'height', 1.63589, 1.697, 1.229),
  ('window', 'height', 1.697, 1.72225, 1.302),
  ('window', 'height', 1.72225, 1.79828, 0.9374),
  ('window', 'height', 1.79828, 1.89955, 0.1994),
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
  ('window', 'length', 3.34881, 4.09818, 0.09939),
  ('window', 'length', 4.09818, 30, 0.00622);
DELETE FROM class_density WHERE class = 'window' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'rectangularity', 0, 0.317871, 0.03889),
  ('window', 'rectangularity', 0.317871, 0.393, 0.1358),
  ('window', 'rectangularity', 0.393, 0.468129, 0.1603),
  ('window', 'rectangularity', 0.468129, 0.543259, 0.2453),
  ('window', 'rectangularity', 0.543259, 0.618388, 0.3147),
  ('window', 'rectangularity', 0.618388, 0.679142, 0.6965),
  ('window', 'rectangularity', 0.679142, 0.693517, 0.9512),
  ('window', 'rectangularity', 0.693517, 0.76352, 1.392),
  ('window', 'rectangularity', 0.76352, 0.768646, 2.449),
  ('window', 'rectangularity', 0.768646, 0.820408, 2.062),
  ('window', 'rectangularity', 0.820408, 0.843775, 2.757),
  ('window', 'rectangularity', 0.843775, 0.850476, 6.188),
  ('window', 'rectangularity', 0.850476, 0.897923, 2.358),
  ('window', 'rectangularity', 0.897923, 0.918904, 2.087),
  ('window', 'rectangularity', 0.918904, 0.94173, 3.326),
  ('window', 'rectangularity', 0.94173, 0.959724, 5.236),
  ('window', 'rectangularity', 0.959724, 0.970555, 9.946),
  ('window', 'rectangularity', 0.970555, 0.982985, 8.183),
  ('window', 'rectangularity', 0.982985, 0.994034, 0.6806),
  ('window', 'rectangularity', 0.994034, 1, 0.3346);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_length', 0.01, 0.460114, 0.002388),
  ('window', 'spread_length', 0.460114, 0.590811, 0.04492),
  ('window', 'spread_length', 0.590811, 0.758632, 0.1059),
  ('window', 'spread_length', 0.758632, 0.974125, 0.2467),
  ('window', 'spread_length', 0.974125, 1.02226, 0.3749),
  ('window', 'spread_length', 1.02226, 1.14957, 0.8912),
  ('window', 'spread_length', 1.14957, 1.25083, 1.067),
  ('window', 'spread_length', 1.25083, 1.26888, 1.425),
  ('window', 'spread_length', 1.26888, 1.32836, 2.202),
  ('window', 'spread_length', 1.32836, 1.42039, 1.653),
  ('window', 'spread_length', 1.42039, 1.52836, 1.538),
  ('window', 'spread_length', 1.52836, 1.60543, 2.074),
  ('window', 'spread_length', 1.60543, 1.74163, 1.451),
  ('window', 'spread_length', 1.74163, 2.06236, 0.4147),
  ('window', 'spread_length', 2.06236, 2.64818, 0.04408),
  ('window', 'spread_length', 2.64818, 3.4004, 0.04504),
  ('window', 'spread_length', 3.4004, 4.36629, 0.04599),
  ('window', 'spread_length', 4.36629, 40, 0.004467);
DELETE FROM class_density WHERE class = 'window' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'spread_width', 0.003, 0.200188, 0.002604),
  ('window', 'spread_width', 0.200188, 0.252861, 0.06347),
  ('window', 'spread_width', 0.252861, 0.319391, 0.05717),
  ('window', 'spread_width', 0.319391, 0.403427, 0.1539),
  ('window', 'spread_width', 0.403427, 0.442872, 0.2672),
  ('window', 'spread_width', 0.442872, 0.509574, 0.2755),
  ('window', 'spread_width', 0.509574, 0.643649, 0.2857),
  ('window', 'spread_width', 0.643649, 0.687625, 0.3131),
  ('window', 'spread_width', 0.687625, 0.813001, 0.413),
  ('window', 'spread_width', 0.813001, 0.870461, 0.8282),
  ('window', 'spread_width', 0.870461, 0.979719, 0.9942),
  ('window', 'spread_width', 0.979719, 1.02691, 1.731),
  ('window', 'spread_width', 1.02691, 1.09973, 1.685),
  ('window', 'spread_width', 1.09973, 1.19384, 1.238),
  ('window', 'spread_width', 1.19384, 1.29711, 0.9043),
  ('window', 'spread_width', 1.29711, 1.33887, 1.039),
  ('window', 'spread_width', 1.33887, 1.63839, 0.5394),
  ('window', 'spread_width', 1.63839, 20, 0.006105);
DELETE FROM class_density WHERE class = 'window' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'tilt_deg', 0, 87.2471, 9.012e-05),
  ('window', 'tilt_deg', 87.2471, 87.553, 0.01482),
  ('window', 'tilt_deg', 87.553, 87.8589, 0.03951),
  ('window', 'tilt_deg', 87.8589, 88.1648, 0.04564),
  ('window', 'tilt_deg', 88.1648, 88.4706, 0.07299),
  ('window', 'tilt_deg', 88.4706, 88.7765, 0.1282),
  ('window', 'tilt_deg', 88.7765, 89.0824, 0.1602),
  ('window', 'tilt_deg', 89.0824, 89.3883, 0.2233),
  ('window', 'tilt_deg', 89.3883, 89.6046, 0.5667),
  ('window', 'tilt_deg', 89.6046, 89.771, 1.221),
  ('window', 'tilt_deg', 89.771, 90, 1.995);
DELETE FROM class_density WHERE class = 'window' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('window', 'width', 0.01, 0.276736, 0.003518),
  ('window', 'width', 0.276736, 0.334041, 0.0849),
  ('window', 'width', 0.334041, 0.403213, 0.09553),
  ('window', 'width', 0.403213, 0.486709, 0.121),
  ('window', 'width', 0.486709, 0.587495, 0.273),
  ('window', 'width', 0.587495, 0.709151, 0.3777),
  ('window', 'width', 0.709151, 0.825134, 0.2946),
  ('window', 'width', 0.825134, 0.855999, 0.3794),
  ('window', 'width', 0.855999, 0.938693, 1.065),
  ('window', 'width', 0.938693, 1.01676, 1.459),
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
  ('window', 'z_max', 1.60493, 1.72878, 0.07113),
  ('window', 'z_max', 1.72878, 1.85262, 0.1149),
  ('window', 'z_max', 1.85262, 1.94015, 0.7705),
  ('window', 'z_max', 1.94015, 1.97646, 1.676),
  ('window', 'z_max', 1.97646, 1.99618, 2.248),
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
  ('window', 'z_max', 2.47184, 4, 0.009102);
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
UPDATE object_class SET prior = 0.01127 WHERE name = 'whiteboard';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'area_m2', 0.2146, 0.7328)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'aspect', 0.409, 0.316)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'behind', 0.00826, 0.04418)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'height', 1.393, 0.1426)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'length', 0.4515, 0.3388)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'rectangularity', 0.7689, 0.1106)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_length', 0.2867, 0.3163)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'spread_width', -0.2396, 0.4203)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'tilt_deg', 89.61, 0.9265)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'width', 0.04167, 0.4387)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_max', 2.042, 0.2858)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('whiteboard', 'z_min', 0.777, 0.2823)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'area_m2', 0.002, 0.136311, 0.002638),
  ('whiteboard', 'area_m2', 0.136311, 0.20945, 0.05986),
  ('whiteboard', 'area_m2', 0.20945, 0.321834, 0.08902),
  ('whiteboard', 'area_m2', 0.321834, 0.494518, 0.06289),
  ('whiteboard', 'area_m2', 0.494518, 0.606505, 0.1618),
  ('whiteboard', 'area_m2', 0.606505, 0.759857, 0.2683),
  ('whiteboard', 'area_m2', 0.759857, 0.868444, 0.3355),
  ('whiteboard', 'area_m2', 0.868444, 1.13798, 0.397),
  ('whiteboard', 'area_m2', 1.13798, 1.29728, 0.8273),
  ('whiteboard', 'area_m2', 1.29728, 1.45653, 0.9827),
  ('whiteboard', 'area_m2', 1.45653, 1.69242, 0.6945),
  ('whiteboard', 'area_m2', 1.69242, 1.79404, 0.4209),
  ('whiteboard', 'area_m2', 1.79404, 2.09991, 0.4908),
  ('whiteboard', 'area_m2', 2.09991, 2.58414, 0.5271),
  ('whiteboard', 'area_m2', 2.58414, 2.75666, 0.3358),
  ('whiteboard', 'area_m2', 2.75666, 4.23578, 0.1428),
  ('whiteboard', 'area_m2', 4.23578, 6.50855, 0.04099),
  ('whiteboard', 'area_m2', 6.50855, 100, 0.005119);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'aspect', 1, 1.07585, 1.625),
  ('whiteboard', 'aspect', 1.07585, 1.13935, 1.565),
  ('whiteboard', 'aspect', 1.13935, 1.17335, 1.401),
  ('whiteboard', 'aspect', 1.17335, 1.27002, 1.071),
  ('whiteboard', 'aspect', 1.27002, 1.37676, 1.104),
  ('whiteboard', 'aspect', 1.37676, 1.55465, 1.124),
  ('whiteboard', 'aspect', 1.55465, 1.61543, 2.379),
  ('whiteboard', 'aspect', 1.61543, 1.76304, 1.29),
  ('whiteboard', 'aspect', 1.76304, 1.89547, 0.5938),
  ('whiteboard', 'aspect', 1.89547, 2.1819, 0.4892),
  ('whiteboard', 'aspect', 2.1819, 2.60962, 0.352),
  ('whiteboard', 'aspect', 2.60962, 3.062, 0.1406),
  ('whiteboard', 'aspect', 3.062, 3.59282, 0.09395),
  ('whiteboard', 'aspect', 3.59282, 4.21565, 0.08675),
  ('whiteboard', 'aspect', 4.21565, 100, 0.002992);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'behind', 0, 0.0347164, 25.46),
  ('whiteboard', 'behind', 0.0347164, 0.0694327, 1.839),
  ('whiteboard', 'behind', 0.0694327, 0.104149, 0.71),
  ('whiteboard', 'behind', 0.104149, 0.138865, 0.334),
  ('whiteboard', 'behind', 0.138865, 0.173582, 0.02842),
  ('whiteboard', 'behind', 0.173582, 0.208298, 0.0006161),
  ('whiteboard', 'behind', 0.208298, 0.243014, 1.778e-05),
  ('whiteboard', 'behind', 0.243014, 0.277731, 3.121e-07),
  ('whiteboard', 'behind', 0.277731, 0.312447, 3.023e-09),
  ('whiteboard', 'behind', 0.312447, 1, 0.02204);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'height', -0.5, 0.814964, 0.01061),
  ('whiteboard', 'height', 0.814964, 0.904512, 0.06869),
  ('whiteboard', 'height', 0.904512, 0.99406, 0.1063),
  ('whiteboard', 'height', 0.99406, 1.08361, 0.05067),
  ('whiteboard', 'height', 1.08361, 1.17316, 0.3071),
  ('whiteboard', 'height', 1.17316, 1.2627, 0.6868),
  ('whiteboard', 'height', 1.2627, 1.32785, 1.92),
  ('whiteboard', 'height', 1.32785, 1.35225, 2.016),
  ('whiteboard', 'height', 1.35225, 1.37526, 2.888),
  ('whiteboard', 'height', 1.37526, 1.39296, 4.66),
  ('whiteboard', 'height', 1.39296, 1.42495, 3.527),
  ('whiteboard', 'height', 1.42495, 1.4418, 3.318),
  ('whiteboard', 'height', 1.4418, 1.45456, 3.206),
  ('whiteboard', 'height', 1.45456, 1.49111, 3.225),
  ('whiteboard', 'height', 1.49111, 1.53135, 2.372),
  ('whiteboard', 'height', 1.53135, 1.60657, 1.397),
  ('whiteboard', 'height', 1.60657, 1.62089, 0.5913),
  ('whiteboard', 'height', 1.62089, 4, 0.007207);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'length', 0.03, 0.62663, 0.004775),
  ('whiteboard', 'length', 0.62663, 0.769516, 0.03139),
  ('whiteboard', 'length', 0.769516, 0.944983, 0.09038),
  ('whiteboard', 'length', 0.944983, 1.08959, 0.4835),
  ('whiteboard', 'length', 1.08959, 1.16046, 0.9351),
  ('whiteboard', 'length', 1.16046, 1.22195, 1.268),
  ('whiteboard', 'length', 1.22195, 1.29091, 1.908),
  ('whiteboard', 'length', 1.29091, 1.3889, 1.265),
  ('whiteboard', 'length', 1.3889, 1.42507, 1.089),
  ('whiteboard', 'length', 1.42507, 1.59641, 0.8088),
  ('whiteboard', 'length', 1.59641, 1.75002, 0.8107),
  ('whiteboard', 'length', 1.75002, 1.89754, 0.7699),
  ('whiteboard', 'length', 1.89754, 2.06836, 1.082),
  ('whiteboard', 'length', 2.06836, 2.14907, 0.8444),
  ('whiteboard', 'length', 2.14907, 2.36511, 0.6347),
  ('whiteboard', 'length', 2.36511, 2.63911, 0.5698),
  ('whiteboard', 'length', 2.63911, 3.24088, 0.1944),
  ('whiteboard', 'length', 3.24088, 3.97988, 0.05291),
  ('whiteboard', 'length', 3.97988, 30, 0.006772);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'rectangularity', 0, 0.46758, 0.02478),
  ('whiteboard', 'rectangularity', 0.46758, 0.517403, 0.3872),
  ('whiteboard', 'rectangularity', 0.517403, 0.567226, 0.7129),
  ('whiteboard', 'rectangularity', 0.567226, 0.591147, 0.9948),
  ('whiteboard', 'rectangularity', 0.591147, 0.617048, 1.097),
  ('whiteboard', 'rectangularity', 0.617048, 0.666871, 1.232),
  ('whiteboard', 'rectangularity', 0.666871, 0.700121, 1.447),
  ('whiteboard', 'rectangularity', 0.700121, 0.716694, 2.36),
  ('whiteboard', 'rectangularity', 0.716694, 0.734325, 4.544),
  ('whiteboard', 'rectangularity', 0.734325, 0.766517, 3.294),
  ('whiteboard', 'rectangularity', 0.766517, 0.773531, 1.051),
  ('whiteboard', 'rectangularity', 0.773531, 0.816339, 1.773),
  ('whiteboard', 'rectangularity', 0.816339, 0.824293, 5.097),
  ('whiteboard', 'rectangularity', 0.824293, 0.844419, 5.612),
  ('whiteboard', 'rectangularity', 0.844419, 0.86603, 4.751),
  ('whiteboard', 'rectangularity', 0.86603, 0.880867, 5.665),
  ('whiteboard', 'rectangularity', 0.880867, 0.9018, 4.233),
  ('whiteboard', 'rectangularity', 0.9018, 0.915985, 1.187),
  ('whiteboard', 'rectangularity', 0.915985, 1, 0.211);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_length', 0.01, 0.550741, 0.00302),
  ('whiteboard', 'spread_length', 0.550741, 0.662674, 0.07295),
  ('whiteboard', 'spread_length', 0.662674, 0.797356, 0.1737),
  ('whiteboard', 'spread_length', 0.797356, 0.914936, 0.3941),
  ('whiteboard', 'spread_length', 0.914936, 0.95941, 0.5792),
  ('whiteboard', 'spread_length', 0.95941, 1.09124, 0.7647),
  ('whiteboard', 'spread_length', 1.09124, 1.1544, 1.707),
  ('whiteboard', 'spread_length', 1.1544, 1.25604, 1.26),
  ('whiteboard', 'spread_length', 1.25604, 1.38902, 0.9828),
  ('whiteboard', 'spread_length', 1.38902, 1.52261, 1.375),
  ('whiteboard', 'spread_length', 1.52261, 1.67133, 0.7534),
  ('whiteboard', 'spread_length', 1.67133, 1.74679, 0.9543),
  ('whiteboard', 'spread_length', 1.74679, 1.90281, 1.094),
  ('whiteboard', 'spread_length', 1.90281, 2.01101, 0.9789),
  ('whiteboard', 'spread_length', 2.01101, 2.41972, 0.2492),
  ('whiteboard', 'spread_length', 2.41972, 2.91151, 0.08058),
  ('whiteboard', 'spread_length', 2.91151, 40, 0.005143);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'spread_width', 0.003, 0.169554, 0.003209),
  ('whiteboard', 'spread_width', 0.169554, 0.220397, 0.04769),
  ('whiteboard', 'spread_width', 0.220397, 0.286485, 0.07195),
  ('whiteboard', 'spread_width', 0.286485, 0.37239, 0.07267),
  ('whiteboard', 'spread_width', 0.37239, 0.484056, 0.1598),
  ('whiteboard', 'spread_width', 0.484056, 0.566543, 0.2335),
  ('whiteboard', 'spread_width', 0.566543, 0.629205, 0.4271),
  ('whiteboard', 'spread_width', 0.629205, 0.690448, 0.7498),
  ('whiteboard', 'spread_width', 0.690448, 0.760844, 1.003),
  ('whiteboard', 'spread_width', 0.760844, 0.817879, 1.035),
  ('whiteboard', 'spread_width', 0.817879, 0.840199, 1.301),
  ('whiteboard', 'spread_width', 0.840199, 0.895313, 1.619),
  ('whiteboard', 'spread_width', 0.895313, 0.925639, 2.267),
  ('whiteboard', 'spread_width', 0.925639, 0.977514, 2.022),
  ('whiteboard', 'spread_width', 0.977514, 1.06313, 1.054),
  ('whiteboard', 'spread_width', 1.06313, 1.38192, 0.3893),
  ('whiteboard', 'spread_width', 1.38192, 1.7963, 0.1623),
  ('whiteboard', 'spread_width', 1.7963, 20, 0.006024);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'tilt_deg', 0, 85.273, 1.822e-05),
  ('whiteboard', 'tilt_deg', 85.273, 85.5637, 0.02545),
  ('whiteboard', 'tilt_deg', 85.5637, 85.7983, 0.04168),
  ('whiteboard', 'tilt_deg', 85.7983, 86.3235, 0.02153),
  ('whiteboard', 'tilt_deg', 86.3235, 86.8487, 0.007492),
  ('whiteboard', 'tilt_deg', 86.8487, 87.3739, 0.02313),
  ('whiteboard', 'tilt_deg', 87.3739, 87.8991, 0.01971),
  ('whiteboard', 'tilt_deg', 87.8991, 88.4243, 0.07121),
  ('whiteboard', 'tilt_deg', 88.4243, 88.9496, 0.0796),
  ('whiteboard', 'tilt_deg', 88.9496, 89.2541, 0.1562),
  ('whiteboard', 'tilt_deg', 89.2541, 89.4748, 0.2896),
  ('whiteboard', 'tilt_deg', 89.4748, 89.7915, 0.9702),
  ('whiteboard', 'tilt_deg', 89.7915, 90, 2.137);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'width', 0.01, 0.237625, 0.00477),
  ('whiteboard', 'width', 0.237625, 0.310367, 0.04968),
  ('whiteboard', 'width', 0.310367, 0.405375, 0.07716),
  ('whiteboard', 'width', 0.405375, 0.529467, 0.1441),
  ('whiteboard', 'width', 0.529467, 0.677533, 0.1832),
  ('whiteboard', 'width', 0.677533, 0.691545, 0.336),
  ('whiteboard', 'width', 0.691545, 0.903239, 0.3876),
  ('whiteboard', 'width', 0.903239, 0.938032, 0.3905),
  ('whiteboard', 'width', 0.938032, 1.07874, 0.8219),
  ('whiteboard', 'width', 1.07874, 1.13438, 1.892),
  ('whiteboard', 'width', 1.13438, 1.17973, 2.528),
  ('whiteboard', 'width', 1.17973, 1.21773, 2.738),
  ('whiteboard', 'width', 1.21773, 1.27422, 2.313),
  ('whiteboard', 'width', 1.27422, 1.39188, 1.12),
  ('whiteboard', 'width', 1.39188, 1.54087, 0.3578),
  ('whiteboard', 'width', 1.54087, 2.01256, 0.2164),
  ('whiteboard', 'width', 2.01256, 2.62863, 0.1188),
  ('whiteboard', 'width', 2.62863, 12, 0.01094);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_max', -0.5, 1.22137, 0.005799),
  ('whiteboard', 'z_max', 1.22137, 1.41068, 0.1176),
  ('whiteboard', 'z_max', 1.41068, 1.6, 0.1177),
  ('whiteboard', 'z_max', 1.6, 1.78931, 0.3967),
  ('whiteboard', 'z_max', 1.78931, 1.82128, 0.5312),
  ('whiteboard', 'z_max', 1.82128, 1.92351, 0.9366),
  ('whiteboard', 'z_max', 1.92351, 1.94946, 2.912),
  ('whiteboard', 'z_max', 1.94946, 1.97863, 1.848),
  ('whiteboard', 'z_max', 1.97863, 2.03151, 1.556),
  ('whiteboard', 'z_max', 2.03151, 2.07721, 2.116),
  ('whiteboard', 'z_max', 2.07721, 2.09851, 3.681),
  ('whiteboard', 'z_max', 2.09851, 2.14977, 2.236),
  ('whiteboard', 'z_max', 2.14977, 2.16794, 2.443),
  ('whiteboard', 'z_max', 2.16794, 2.24004, 1.043),
  ('whiteboard', 'z_max', 2.24004, 2.35725, 0.3814),
  ('whiteboard', 'z_max', 2.35725, 2.54657, 0.1822),
  ('whiteboard', 'z_max', 2.54657, 2.73588, 0.1253),
  ('whiteboard', 'z_max', 2.73588, 2.92519, 0.1148),
  ('whiteboard', 'z_max', 2.92519, 4, 0.01109);
DELETE FROM class_density WHERE class = 'whiteboard' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('whiteboard', 'z_min', -0.5, -0.0541672, 0.02267),
  ('whiteboard', 'z_min', -0.0541672, -0.043909, 0.4462),
  ('whiteboard', 'z_min', -0.043909, 0.0821156, 0.4861),
  ('whiteboard', 'z_min', 0.0821156, 0.218398, 0.06393),
  ('whiteboard', 'z_min', 0.218398, 0.354681, 0.1357),
  ('whiteboard', 'z_min', 0.354681, 0.490964, 0.1176),
  ('whiteboard', 'z_min', 0.490964, 0.627247, 0.1976),
  ('whiteboard', 'z_min', 0.627247, 0.63391, 0.3082),
  ('whiteboard', 'z_min', 0.63391, 0.763319, 0.8816),
  ('whiteboard', 'z_min', 0.763319, 0.804898, 2.288),
  ('whiteboard', 'z_min', 0.804898, 0.845572, 3.424),
  ('whiteboard', 'z_min', 0.845572, 0.853248, 5.539),
  ('whiteboard', 'z_min', 0.853248, 0.886117, 3.89),
  ('whiteboard', 'z_min', 0.886117, 0.899812, 3.105),
  ('whiteboard', 'z_min', 0.899812, 0.912907, 3.303),
  ('whiteboard', 'z_min', 0.912907, 0.954373, 2.226),
  ('whiteboard', 'z_min', 0.954373, 1.0361, 0.8323),
  ('whiteboard', 'z_min', 1.0361, 1.16133, 0.4828),
  ('whiteboard', 'z_min', 1.16133, 1.17238, 0.3863),
  ('whiteboard', 'z_min', 1.17238, 4, 0.007844);

-- shelf: 240 examples
UPDATE object_class SET prior = 0.05046 WHERE name = 'shelf';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'area_m2', -1.436, 0.7499)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'aspect', 0.9784, 0.4347)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'behind', 0.5526, 0.3168)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'height', 0.9727, 0.4838)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'length', -0.04425, 0.5027)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'rectangularity', 0.7048, 0.1218)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_length', -0.205, 0.5137)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'spread_width', -1.218, 0.3595)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'tilt_deg', 55.38, 42.63)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'width', -1.026, 0.3257)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_max', 1.311, 0.6196)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('shelf', 'z_min', 0.5841, 0.5886)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'area_m2', 0.002, 0.0217751, 0.003718),
  ('shelf', 'area_m2', 0.0217751, 0.0329261, 0.03538),
  ('shelf', 'area_m2', 0.0329261, 0.0497875, 0.06303),
  ('shelf', 'area_m2', 0.0497875, 0.0752837, 0.06802),
  ('shelf', 'area_m2', 0.0752837, 0.0967427, 0.1121),
  ('shelf', 'area_m2', 0.0967427, 0.113836, 0.209),
  ('shelf', 'area_m2', 0.113836, 0.148561, 0.3158),
  ('shelf', 'area_m2', 0.148561, 0.172132, 0.3383),
  ('shelf', 'area_m2', 0.172132, 0.197345, 0.4864),
  ('shelf', 'area_m2', 0.197345, 0.239929, 0.5473),
  ('shelf', 'area_m2', 0.239929, 0.260281, 0.6862),
  ('shelf', 'area_m2', 0.260281, 0.289092, 0.5327),
  ('shelf', 'area_m2', 0.289092, 0.345245, 0.6349),
  ('shelf', 'area_m2', 0.345245, 0.39357, 0.5852),
  ('shelf', 'area_m2', 0.39357, 0.426381, 0.3708),
  ('shelf', 'area_m2', 0.426381, 0.555624, 0.4063),
  ('shelf', 'area_m2', 0.555624, 0.595118, 0.3588),
  ('shelf', 'area_m2', 0.595118, 0.899877, 0.1941),
  ('shelf', 'area_m2', 0.899877, 100, 0.002028);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'aspect', 1, 1.02209, 0.1052),
  ('shelf', 'aspect', 1.02209, 1.25512, 0.2757),
  ('shelf', 'aspect', 1.25512, 1.44541, 0.3608),
  ('shelf', 'aspect', 1.44541, 1.54127, 0.3338),
  ('shelf', 'aspect', 1.54127, 1.89267, 0.4318),
  ('shelf', 'aspect', 1.89267, 2.17497, 0.7971),
  ('shelf', 'aspect', 2.17497, 2.32418, 0.7507),
  ('shelf', 'aspect', 2.32418, 2.56688, 0.6535),
  ('shelf', 'aspect', 2.56688, 2.85407, 0.6871),
  ('shelf', 'aspect', 2.85407, 2.91678, 1.624),
  ('shelf', 'aspect', 2.91678, 3.2413, 1.116),
  ('shelf', 'aspect', 3.2413, 3.50477, 0.7659),
  ('shelf', 'aspect', 3.50477, 3.78874, 0.6009),
  ('shelf', 'aspect', 3.78874, 4.30382, 0.5469),
  ('shelf', 'aspect', 4.30382, 4.76252, 0.4176),
  ('shelf', 'aspect', 4.76252, 5.28505, 0.4917),
  ('shelf', 'aspect', 5.28505, 6.48338, 0.2617),
  ('shelf', 'aspect', 6.48338, 100, 0.001899);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'behind', 0, 0.0975294, 2.189),
  ('shelf', 'behind', 0.0975294, 0.13367, 0.1544),
  ('shelf', 'behind', 0.13367, 0.195059, 0.1388),
  ('shelf', 'behind', 0.195059, 0.292588, 0.139),
  ('shelf', 'behind', 0.292588, 0.390117, 0.194),
  ('shelf', 'behind', 0.390117, 0.487647, 0.2843),
  ('shelf', 'behind', 0.487647, 0.585176, 0.488),
  ('shelf', 'behind', 0.585176, 0.590888, 1.055),
  ('shelf', 'behind', 0.590888, 0.682661, 1.248),
  ('shelf', 'behind', 0.682661, 0.735257, 2.077),
  ('shelf', 'behind', 0.735257, 0.766441, 3.419),
  ('shelf', 'behind', 0.766441, 0.780235, 4.934),
  ('shelf', 'behind', 0.780235, 0.7878, 4.521),
  ('shelf', 'behind', 0.7878, 0.822242, 3.223),
  ('shelf', 'behind', 0.822242, 0.877764, 1.83),
  ('shelf', 'behind', 0.877764, 1, 0.1084);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'height', -0.5, 0.00193634, 0.002176),
  ('shelf', 'height', 0.00193634, 0.0526313, 0.1144),
  ('shelf', 'height', 0.0526313, 0.245408, 0.3654),
  ('shelf', 'height', 0.245408, 0.417691, 0.2098),
  ('shelf', 'height', 0.417691, 0.48888, 0.7198),
  ('shelf', 'height', 0.48888, 0.598369, 0.6028),
  ('shelf', 'height', 0.598369, 0.732352, 0.5439),
  ('shelf', 'height', 0.732352, 0.759706, 0.9001),
  ('shelf', 'height', 0.759706, 0.930519, 0.7001),
  ('shelf', 'height', 0.930519, 0.975824, 1.139),
  ('shelf', 'height', 0.975824, 1.03637, 0.9132),
  ('shelf', 'height', 1.03637, 1.13226, 1.179),
  ('shelf', 'height', 1.13226, 1.2193, 0.6412),
  ('shelf', 'height', 1.2193, 1.3078, 0.5819),
  ('shelf', 'height', 1.3078, 1.46277, 0.559),
  ('shelf', 'height', 1.46277, 1.57738, 0.2857),
  ('shelf', 'height', 1.57738, 1.70624, 0.2045),
  ('shelf', 'height', 1.70624, 1.94971, 0.1613),
  ('shelf', 'height', 1.94971, 2.15759, 0.1346),
  ('shelf', 'height', 2.15759, 2.19318, 0.09017),
  ('shelf', 'height', 2.19318, 4, 0.004848);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'length', 0.03, 0.210497, 0.005777),
  ('shelf', 'length', 0.210497, 0.275372, 0.06463),
  ('shelf', 'length', 0.275372, 0.360242, 0.06762),
  ('shelf', 'length', 0.360242, 0.471269, 0.09834),
  ('shelf', 'length', 0.471269, 0.531368, 0.2796),
  ('shelf', 'length', 0.531368, 0.616515, 0.4164),
  ('shelf', 'length', 0.616515, 0.680475, 0.5866),
  ('shelf', 'length', 0.680475, 0.806525, 0.6149),
  ('shelf', 'length', 0.806525, 0.943504, 0.7927),
  ('shelf', 'length', 0.943504, 1.0551, 0.8065),
  ('shelf', 'length', 1.0551, 1.07976, 0.4751),
  ('shelf', 'length', 1.07976, 1.21761, 0.9591),
  ('shelf', 'length', 1.21761, 1.38028, 0.7236),
  ('shelf', 'length', 1.38028, 1.42468, 0.6199),
  ('shelf', 'length', 1.42468, 1.74863, 0.5025),
  ('shelf', 'length', 1.74863, 1.80568, 0.2643),
  ('shelf', 'length', 1.80568, 2.24937, 0.4291),
  ('shelf', 'length', 2.24937, 2.3622, 0.1834),
  ('shelf', 'length', 2.3622, 30, 0.001245);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'rectangularity', 0, 0.415371, 0.01766),
  ('shelf', 'rectangularity', 0.415371, 0.47437, 0.3688),
  ('shelf', 'rectangularity', 0.47437, 0.533369, 0.8312),
  ('shelf', 'rectangularity', 0.533369, 0.552944, 2.154),
  ('shelf', 'rectangularity', 0.552944, 0.592369, 2.436),
  ('shelf', 'rectangularity', 0.592369, 0.597721, 1.928),
  ('shelf', 'rectangularity', 0.597721, 0.645499, 2.128),
  ('shelf', 'rectangularity', 0.645499, 0.651368, 2.906),
  ('shelf', 'rectangularity', 0.651368, 0.686548, 2.661),
  ('shelf', 'rectangularity', 0.686548, 0.710367, 2.121),
  ('shelf', 'rectangularity', 0.710367, 0.729119, 3.644),
  ('shelf', 'rectangularity', 0.729119, 0.769366, 2.639),
  ('shelf', 'rectangularity', 0.769366, 0.809804, 2.849),
  ('shelf', 'rectangularity', 0.809804, 0.828365, 2.438),
  ('shelf', 'rectangularity', 0.828365, 0.862658, 1.879),
  ('shelf', 'rectangularity', 0.862658, 0.887365, 2.415),
  ('shelf', 'rectangularity', 0.887365, 0.946364, 0.7207),
  ('shelf', 'rectangularity', 0.946364, 1, 0.1648);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_length', 0.01, 0.186117, 0.003168),
  ('shelf', 'spread_length', 0.186117, 0.244546, 0.05884),
  ('shelf', 'spread_length', 0.244546, 0.321317, 0.08029),
  ('shelf', 'spread_length', 0.321317, 0.418954, 0.2332),
  ('shelf', 'spread_length', 0.418954, 0.554729, 0.3092),
  ('shelf', 'spread_length', 0.554729, 0.575861, 0.6026),
  ('shelf', 'spread_length', 0.575861, 0.657544, 0.8538),
  ('shelf', 'spread_length', 0.657544, 0.728878, 0.9397),
  ('shelf', 'spread_length', 0.728878, 0.758838, 0.5175),
  ('shelf', 'spread_length', 0.758838, 0.940209, 0.4909),
  ('shelf', 'spread_length', 0.940209, 1.0688, 0.8985),
  ('shelf', 'spread_length', 1.0688, 1.22479, 0.8064),
  ('shelf', 'spread_length', 1.22479, 1.25835, 0.6948),
  ('shelf', 'spread_length', 1.25835, 1.49744, 0.5178),
  ('shelf', 'spread_length', 1.49744, 1.65339, 0.2863),
  ('shelf', 'spread_length', 1.65339, 2.12369, 0.2957),
  ('shelf', 'spread_length', 2.12369, 2.17245, 0.116),
  ('shelf', 'spread_length', 2.17245, 40, 0.002251);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'spread_width', 0.003, 0.112959, 0.002458),
  ('shelf', 'spread_width', 0.112959, 0.138547, 0.1496),
  ('shelf', 'spread_width', 0.138547, 0.169931, 0.2294),
  ('shelf', 'spread_width', 0.169931, 0.177818, 0.4581),
  ('shelf', 'spread_width', 0.177818, 0.208424, 0.4851),
  ('shelf', 'spread_width', 0.208424, 0.233428, 0.3676),
  ('shelf', 'spread_width', 0.233428, 0.255638, 0.5429),
  ('shelf', 'spread_width', 0.255638, 0.278645, 0.8389),
  ('shelf', 'spread_width', 0.278645, 0.29963, 1.377),
  ('shelf', 'spread_width', 0.29963, 0.313546, 1.089),
  ('shelf', 'spread_width', 0.313546, 0.328141, 1.45),
  ('shelf', 'spread_width', 0.328141, 0.346474, 1.722),
  ('shelf', 'spread_width', 0.346474, 0.381888, 1.223),
  ('shelf', 'spread_width', 0.381888, 0.434139, 0.8941),
  ('shelf', 'spread_width', 0.434139, 0.471687, 0.6351),
  ('shelf', 'spread_width', 0.471687, 0.578536, 0.1627),
  ('shelf', 'spread_width', 0.578536, 0.709588, 0.07231),
  ('shelf', 'spread_width', 0.709588, 20, 0.002771);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'tilt_deg', 0, 1.09887, 0.09682),
  ('shelf', 'tilt_deg', 1.09887, 2.00441, 0.1154),
  ('shelf', 'tilt_deg', 2.00441, 3.77758, 0.05994),
  ('shelf', 'tilt_deg', 3.77758, 10, 0.008728),
  ('shelf', 'tilt_deg', 10, 20, 0.0008895),
  ('shelf', 'tilt_deg', 20, 30, 0.000524),
  ('shelf', 'tilt_deg', 30, 40, 0.0004952),
  ('shelf', 'tilt_deg', 40, 50, 0.0005382),
  ('shelf', 'tilt_deg', 50, 60, 0.0005792),
  ('shelf', 'tilt_deg', 60, 70, 0.0006571),
  ('shelf', 'tilt_deg', 70, 80, 0.0008898),
  ('shelf', 'tilt_deg', 80, 88.5951, 0.006398),
  ('shelf', 'tilt_deg', 88.5951, 89.7076, 0.1703),
  ('shelf', 'tilt_deg', 89.7076, 90, 1.157);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'width', 0.01, 0.128386, 0.003447),
  ('shelf', 'width', 0.128386, 0.159426, 0.1122),
  ('shelf', 'width', 0.159426, 0.197972, 0.1499),
  ('shelf', 'width', 0.197972, 0.245836, 0.2028),
  ('shelf', 'width', 0.245836, 0.305273, 0.5075),
  ('shelf', 'width', 0.305273, 0.335592, 1.274),
  ('shelf', 'width', 0.335592, 0.358739, 1.593),
  ('shelf', 'width', 0.358739, 0.379081, 1.417),
  ('shelf', 'width', 0.379081, 0.387101, 1.565),
  ('shelf', 'width', 0.387101, 0.41229, 1.736),
  ('shelf', 'width', 0.41229, 0.4361, 1.851),
  ('shelf', 'width', 0.4361, 0.470733, 1.22),
  ('shelf', 'width', 0.470733, 0.480652, 1.033),
  ('shelf', 'width', 0.480652, 0.584545, 0.3816),
  ('shelf', 'width', 0.584545, 0.725874, 0.07759),
  ('shelf', 'width', 0.725874, 0.901372, 0.06456),
  ('shelf', 'width', 0.901372, 12, 0.003582);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_max', -0.5, -0.00594508, 0.001618),
  ('shelf', 'z_max', -0.00594508, 0.0704397, 0.2642),
  ('shelf', 'z_max', 0.0704397, 0.25099, 0.2824),
  ('shelf', 'z_max', 0.25099, 0.446407, 0.212),
  ('shelf', 'z_max', 0.446407, 0.507925, 0.6968),
  ('shelf', 'z_max', 0.507925, 0.764861, 0.2753),
  ('shelf', 'z_max', 0.764861, 1.0218, 0.2742),
  ('shelf', 'z_max', 1.0218, 1.09785, 0.4435),
  ('shelf', 'z_max', 1.09785, 1.27873, 0.4967),
  ('shelf', 'z_max', 1.27873, 1.33507, 0.4763),
  ('shelf', 'z_max', 1.33507, 1.51423, 0.5962),
  ('shelf', 'z_max', 1.51423, 1.53567, 0.4068),
  ('shelf', 'z_max', 1.53567, 1.68471, 0.7637),
  ('shelf', 'z_max', 1.68471, 1.7926, 0.6772),
  ('shelf', 'z_max', 1.7926, 1.86803, 0.4819),
  ('shelf', 'z_max', 1.86803, 2.04954, 0.5036),
  ('shelf', 'z_max', 2.04954, 2.30647, 0.4388),
  ('shelf', 'z_max', 2.30647, 4, 0.005448);
DELETE FROM class_density WHERE class = 'shelf' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('shelf', 'z_min', -0.5, -0.081789, 0.01416),
  ('shelf', 'z_min', -0.081789, -0.0425353, 0.09145),
  ('shelf', 'z_min', -0.0425353, -0.00669042, 2.91),
  ('shelf', 'z_min', -0.00669042, 0.0119706, 4.961),
  ('shelf', 'z_min', 0.0119706, 0.0831737, 1.67),
  ('shelf', 'z_min', 0.0831737, 0.169994, 0.4529),
  ('shelf', 'z_min', 0.169994, 0.416048, 0.3187),
  ('shelf', 'z_min', 0.416048, 0.542338, 0.8728),
  ('shelf', 'z_min', 0.542338, 0.67356, 0.3566),
  ('shelf', 'z_min', 0.67356, 0.779612, 0.6375),
  ('shelf', 'z_min', 0.779612, 0.925343, 0.6225),
  ('shelf', 'z_min', 0.925343, 0.953303, 0.5026),
  ('shelf', 'z_min', 0.953303, 1.17713, 0.4211),
  ('shelf', 'z_min', 1.17713, 1.41965, 0.102),
  ('shelf', 'z_min', 1.41965, 1.68069, 0.1128),
  ('shelf', 'z_min', 1.68069, 1.93247, 0.1468),
  ('shelf', 'z_min', 1.93247, 2.15413, 0.1332),
  ('shelf', 'z_min', 2.15413, 2.18426, 0.08969),
  ('shelf', 'z_min', 2.18426, 4, 0.005487);

-- cabinet: 317 examples
UPDATE object_class SET prior = 0.06622 WHERE name = 'cabinet';
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'area_m2', -0.8506, 0.9623)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'aspect', 0.6163, 0.4204)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'behind', 0.546, 0.2187)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'height', 0.7524, 0.3481)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'length', 0.05277, 0.5219)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'rectangularity', 0.7274, 0.1313)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_length', -0.1168, 0.5168)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'spread_width', -0.7798, 0.4979)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'tilt_deg', 75.8, 32.21)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'width', -0.5663, 0.4717)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_max', 1.202, 0.5696)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('cabinet', 'z_min', 0.2193, 0.3329)
  ON CONFLICT (class, feature) DO UPDATE SET mean = excluded.mean, sigma = excluded.sigma;
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'area_m2';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'area_m2', 0.002, 0.0270503, 0.003373),
  ('cabinet', 'area_m2', 0.0270503, 0.0464276, 0.02073),
  ('cabinet', 'area_m2', 0.0464276, 0.0796858, 0.07303),
  ('cabinet', 'area_m2', 0.0796858, 0.121858, 0.123),
  ('cabinet', 'area_m2', 0.121858, 0.136768, 0.1335),
  ('cabinet', 'area_m2', 0.136768, 0.219511, 0.2066),
  ('cabinet', 'area_m2', 0.219511, 0.234741, 0.2237),
  ('cabinet', 'area_m2', 0.234741, 0.314603, 0.3129),
  ('cabinet', 'area_m2', 0.314603, 0.380992, 0.597),
  ('cabinet', 'area_m2', 0.380992, 0.402897, 0.4741),
  ('cabinet', 'area_m2', 0.402897, 0.523509, 0.3277),
  ('cabinet', 'area_m2', 0.523509, 0.691509, 0.39),
  ('cabinet', 'area_m2', 0.691509, 0.967315, 0.3338),
  ('cabinet', 'area_m2', 0.967315, 1.18687, 0.3716),
  ('cabinet', 'area_m2', 1.18687, 1.35731, 0.2682),
  ('cabinet', 'area_m2', 1.35731, 2.03707, 0.1915),
  ('cabinet', 'area_m2', 2.03707, 3.49632, 0.04564),
  ('cabinet', 'area_m2', 3.49632, 100, 0.00206);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'aspect';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'aspect', 1, 1.11904, 0.9795),
  ('cabinet', 'aspect', 1.11904, 1.23098, 0.7604),
  ('cabinet', 'aspect', 1.23098, 1.27311, 1.07),
  ('cabinet', 'aspect', 1.27311, 1.45037, 0.8472),
  ('cabinet', 'aspect', 1.45037, 1.51532, 1.166),
  ('cabinet', 'aspect', 1.51532, 1.59839, 1.222),
  ('cabinet', 'aspect', 1.59839, 1.86533, 0.6186),
  ('cabinet', 'aspect', 1.86533, 1.89556, 0.7966),
  ('cabinet', 'aspect', 1.89556, 2.20504, 0.7357),
  ('cabinet', 'aspect', 2.20504, 2.29619, 0.8852),
  ('cabinet', 'aspect', 2.29619, 2.58758, 0.6827),
  ('cabinet', 'aspect', 2.58758, 2.82657, 0.5769),
  ('cabinet', 'aspect', 2.82657, 3.16459, 0.4646),
  ('cabinet', 'aspect', 3.16459, 3.47945, 0.364),
  ('cabinet', 'aspect', 3.47945, 4.28315, 0.2052),
  ('cabinet', 'aspect', 4.28315, 5.27248, 0.08599),
  ('cabinet', 'aspect', 5.27248, 6.49033, 0.04753),
  ('cabinet', 'aspect', 6.49033, 100, 0.003378);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'behind';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'behind', 0, 0.0967866, 0.5881),
  ('cabinet', 'behind', 0.0967866, 0.193573, 0.4147),
  ('cabinet', 'behind', 0.193573, 0.217758, 0.4307),
  ('cabinet', 'behind', 0.217758, 0.29036, 0.5633),
  ('cabinet', 'behind', 0.29036, 0.387146, 0.5454),
  ('cabinet', 'behind', 0.387146, 0.414467, 0.8819),
  ('cabinet', 'behind', 0.414467, 0.483933, 1.353),
  ('cabinet', 'behind', 0.483933, 0.498236, 1.211),
  ('cabinet', 'behind', 0.498236, 0.549435, 2.187),
  ('cabinet', 'behind', 0.549435, 0.58072, 1.626),
  ('cabinet', 'behind', 0.58072, 0.627522, 1.252),
  ('cabinet', 'behind', 0.627522, 0.677506, 2.075),
  ('cabinet', 'behind', 0.677506, 0.683643, 1.273),
  ('cabinet', 'behind', 0.683643, 0.738175, 2.077),
  ('cabinet', 'behind', 0.738175, 0.774293, 2.707),
  ('cabinet', 'behind', 0.774293, 0.87108, 1.162),
  ('cabinet', 'behind', 0.87108, 1, 0.05455);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'height';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'height', -0.5, 0.149348, 0.01214),
  ('cabinet', 'height', 0.149348, 0.300833, 0.4998),
  ('cabinet', 'height', 0.300833, 0.314687, 1.946),
  ('cabinet', 'height', 0.314687, 0.452319, 0.8305),
  ('cabinet', 'height', 0.452319, 0.553129, 1.068),
  ('cabinet', 'height', 0.553129, 0.601271, 2.31),
  ('cabinet', 'height', 0.601271, 0.755289, 0.5798),
  ('cabinet', 'height', 0.755289, 0.789841, 0.4382),
  ('cabinet', 'height', 0.789841, 0.906774, 0.6204),
  ('cabinet', 'height', 0.906774, 0.947946, 1.207),
  ('cabinet', 'height', 0.947946, 1.05717, 0.9635),
  ('cabinet', 'height', 1.05717, 1.20974, 0.6388),
  ('cabinet', 'height', 1.20974, 1.23566, 0.6519),
  ('cabinet', 'height', 1.23566, 1.36123, 0.5056),
  ('cabinet', 'height', 1.36123, 1.49807, 0.2733),
  ('cabinet', 'height', 1.49807, 1.51272, 0.1394),
  ('cabinet', 'height', 1.51272, 4, 0.002845);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'length', 0.03, 0.218314, 0.003741),
  ('cabinet', 'length', 0.218314, 0.289242, 0.03546),
  ('cabinet', 'length', 0.289242, 0.383213, 0.05492),
  ('cabinet', 'length', 0.383213, 0.507715, 0.1607),
  ('cabinet', 'length', 0.507715, 0.559367, 0.3491),
  ('cabinet', 'length', 0.559367, 0.672665, 0.477),
  ('cabinet', 'length', 0.672665, 0.711596, 0.3966),
  ('cabinet', 'length', 0.711596, 0.808361, 0.874),
  ('cabinet', 'length', 0.808361, 0.891207, 0.4498),
  ('cabinet', 'length', 0.891207, 0.983671, 0.6773),
  ('cabinet', 'length', 0.983671, 1.16869, 0.6452),
  ('cabinet', 'length', 1.16869, 1.4374, 0.5575),
  ('cabinet', 'length', 1.4374, 1.56436, 0.2841),
  ('cabinet', 'length', 1.56436, 1.7526, 0.7442),
  ('cabinet', 'length', 1.7526, 1.96001, 1.012),
  ('cabinet', 'length', 1.96001, 2.07261, 0.5816),
  ('cabinet', 'length', 2.07261, 2.74597, 0.2409),
  ('cabinet', 'length', 2.74597, 30, 0.00292);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'rectangularity';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'rectangularity', 0, 0.381611, 0.03288),
  ('cabinet', 'rectangularity', 0.381611, 0.447668, 0.3061),
  ('cabinet', 'rectangularity', 0.447668, 0.513726, 0.5911),
  ('cabinet', 'rectangularity', 0.513726, 0.552393, 0.9526),
  ('cabinet', 'rectangularity', 0.552393, 0.579783, 1.041),
  ('cabinet', 'rectangularity', 0.579783, 0.624834, 1.859),
  ('cabinet', 'rectangularity', 0.624834, 0.645841, 1.882),
  ('cabinet', 'rectangularity', 0.645841, 0.671007, 2.798),
  ('cabinet', 'rectangularity', 0.671007, 0.711898, 2.542),
  ('cabinet', 'rectangularity', 0.711898, 0.722959, 1.33),
  ('cabinet', 'rectangularity', 0.722959, 0.765155, 2.49),
  ('cabinet', 'rectangularity', 0.765155, 0.777955, 2.602),
  ('cabinet', 'rectangularity', 0.777955, 0.8091, 2.523),
  ('cabinet', 'rectangularity', 0.8091, 0.834627, 4.178),
  ('cabinet', 'rectangularity', 0.834627, 0.844013, 3.35),
  ('cabinet', 'rectangularity', 0.844013, 0.880054, 2.187),
  ('cabinet', 'rectangularity', 0.880054, 0.91007, 2.309),
  ('cabinet', 'rectangularity', 0.91007, 0.976128, 0.6235),
  ('cabinet', 'rectangularity', 0.976128, 1, 0.2557);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_length';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_length', 0.01, 0.199299, 0.002435),
  ('cabinet', 'spread_length', 0.199299, 0.260085, 0.03415),
  ('cabinet', 'spread_length', 0.260085, 0.33941, 0.03988),
  ('cabinet', 'spread_length', 0.33941, 0.442928, 0.2395),
  ('cabinet', 'spread_length', 0.442928, 0.477963, 0.277),
  ('cabinet', 'spread_length', 0.477963, 0.578019, 0.4776),
  ('cabinet', 'spread_length', 0.578019, 0.597343, 0.7224),
  ('cabinet', 'spread_length', 0.597343, 0.678631, 0.8396),
  ('cabinet', 'spread_length', 0.678631, 0.754313, 0.7749),
  ('cabinet', 'spread_length', 0.754313, 0.812445, 0.4432),
  ('cabinet', 'spread_length', 0.812445, 0.972864, 0.6038),
  ('cabinet', 'spread_length', 0.972864, 1.18611, 0.5493),
  ('cabinet', 'spread_length', 1.18611, 1.28461, 0.5831),
  ('cabinet', 'spread_length', 1.28461, 1.50166, 0.4202),
  ('cabinet', 'spread_length', 1.50166, 1.6764, 0.7707),
  ('cabinet', 'spread_length', 1.6764, 1.72172, 0.8002),
  ('cabinet', 'spread_length', 1.72172, 2.1877, 0.4455),
  ('cabinet', 'spread_length', 2.1877, 40, 0.003095);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'spread_width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'spread_width', 0.003, 0.125245, 0.002276),
  ('cabinet', 'spread_width', 0.125245, 0.164665, 0.1016),
  ('cabinet', 'spread_width', 0.164665, 0.216493, 0.1856),
  ('cabinet', 'spread_width', 0.216493, 0.231243, 0.3679),
  ('cabinet', 'spread_width', 0.231243, 0.284634, 0.2718),
  ('cabinet', 'spread_width', 0.284634, 0.335824, 0.3623),
  ('cabinet', 'spread_width', 0.335824, 0.374221, 0.6734),
  ('cabinet', 'spread_width', 0.374221, 0.392454, 0.584),
  ('cabinet', 'spread_width', 0.392454, 0.447922, 0.8527),
  ('cabinet', 'spread_width', 0.447922, 0.492006, 0.9008),
  ('cabinet', 'spread_width', 0.492006, 0.514238, 0.8552),
  ('cabinet', 'spread_width', 0.514238, 0.564602, 1.088),
  ('cabinet', 'spread_width', 0.564602, 0.646863, 0.7941),
  ('cabinet', 'spread_width', 0.646863, 0.799119, 0.5303),
  ('cabinet', 'spread_width', 0.799119, 0.850461, 0.5226),
  ('cabinet', 'spread_width', 0.850461, 1.11814, 0.1803),
  ('cabinet', 'spread_width', 1.11814, 1.47007, 0.08554),
  ('cabinet', 'spread_width', 1.47007, 20, 0.003628);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'tilt_deg';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'tilt_deg', 0, 0.727002, 0.1432),
  ('cabinet', 'tilt_deg', 0.727002, 10, 0.004907),
  ('cabinet', 'tilt_deg', 10, 20, 9.565e-05),
  ('cabinet', 'tilt_deg', 20, 30, 0.000157),
  ('cabinet', 'tilt_deg', 30, 40, 0.0002499),
  ('cabinet', 'tilt_deg', 40, 50, 0.0003706),
  ('cabinet', 'tilt_deg', 50, 60, 0.0005075),
  ('cabinet', 'tilt_deg', 60, 70, 0.0006414),
  ('cabinet', 'tilt_deg', 70, 80, 0.001053),
  ('cabinet', 'tilt_deg', 80, 88.5401, 0.008762),
  ('cabinet', 'tilt_deg', 88.5401, 89.6508, 0.1707),
  ('cabinet', 'tilt_deg', 89.6508, 89.8717, 1.333),
  ('cabinet', 'tilt_deg', 89.8717, 90, 2.033);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'width';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'width', 0.01, 0.15381, 0.002769),
  ('cabinet', 'width', 0.15381, 0.200604, 0.09931),
  ('cabinet', 'width', 0.200604, 0.261634, 0.1881),
  ('cabinet', 'width', 0.261634, 0.307222, 0.1946),
  ('cabinet', 'width', 0.307222, 0.341232, 0.2299),
  ('cabinet', 'width', 0.341232, 0.41915, 0.3763),
  ('cabinet', 'width', 0.41915, 0.445046, 0.3567),
  ('cabinet', 'width', 0.445046, 0.508752, 0.7054),
  ('cabinet', 'width', 0.508752, 0.571341, 0.9956),
  ('cabinet', 'width', 0.571341, 0.580443, 1.314),
  ('cabinet', 'width', 0.580443, 0.6108, 1.679),
  ('cabinet', 'width', 0.6108, 0.669082, 1.232),
  ('cabinet', 'width', 0.669082, 0.757032, 0.636),
  ('cabinet', 'width', 0.757032, 0.808431, 0.5116),
  ('cabinet', 'width', 0.808431, 0.97867, 0.5614),
  ('cabinet', 'width', 0.97867, 1.28773, 0.2953),
  ('cabinet', 'width', 1.28773, 1.6795, 0.09447),
  ('cabinet', 'width', 1.6795, 12, 0.003986);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_max';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_max', -0.5, 0.310506, 0.01169),
  ('cabinet', 'z_max', 0.310506, 0.556532, 0.08565),
  ('cabinet', 'z_max', 0.556532, 0.581016, 2.937),
  ('cabinet', 'z_max', 0.581016, 0.679088, 1.258),
  ('cabinet', 'z_max', 0.679088, 0.782316, 1.068),
  ('cabinet', 'z_max', 0.782316, 0.802559, 0.4837),
  ('cabinet', 'z_max', 0.802559, 0.951749, 0.6191),
  ('cabinet', 'z_max', 0.951749, 1.04858, 0.7101),
  ('cabinet', 'z_max', 1.04858, 1.09359, 0.8752),
  ('cabinet', 'z_max', 1.09359, 1.29461, 0.4118),
  ('cabinet', 'z_max', 1.29461, 1.54064, 0.1451),
  ('cabinet', 'z_max', 1.54064, 1.57949, 0.1343),
  ('cabinet', 'z_max', 1.57949, 1.78666, 0.4886),
  ('cabinet', 'z_max', 1.78666, 1.99406, 0.5635),
  ('cabinet', 'z_max', 1.99406, 2.03269, 0.2993),
  ('cabinet', 'z_max', 2.03269, 2.27872, 0.3197),
  ('cabinet', 'z_max', 2.27872, 2.52474, 0.0561),
  ('cabinet', 'z_max', 2.52474, 4, 0.005265);
DELETE FROM class_density WHERE class = 'cabinet' AND feature = 'z_min';
INSERT INTO class_density (class, feature, low, high, density) VALUES
  ('cabinet', 'z_min', -0.5, -0.0657923, 0.02442),
  ('cabinet', 'z_min', -0.0657923, -0.0206392, 3.952),
  ('cabinet', 'z_min', -0.0206392, -0.0148664, 14.55),
  ('cabinet', 'z_min', -0.0148664, -0.00877105, 15.27),
  ('cabinet', 'z_min', -0.00877105, 0.00534865, 10.71),
  ('cabinet', 'z_min', 0.00534865, 0.0700173, 1.09),
  ('cabinet', 'z_min', 0.0700173, 0.205827, 0.3541),
  ('cabinet', 'z_min', 0.205827, 0.275541, 0.3649),
  ('cabinet', 'z_min', 0.275541, 0.341636, 0.4299),
  ('cabinet', 'z_min', 0.341636, 0.477446, 0.4772),
  ('cabinet', 'z_min', 0.477446, 0.546029, 0.3385),
  ('cabinet', 'z_min', 0.546029, 0.613256, 1.327),
  ('cabinet', 'z_min', 0.613256, 0.706976, 0.2853),
  ('cabinet', 'z_min', 0.706976, 0.749065, 0.2821),
  ('cabinet', 'z_min', 0.749065, 0.884875, 0.2466),
  ('cabinet', 'z_min', 0.884875, 1.02068, 0.2106),
  ('cabinet', 'z_min', 1.02068, 1.15649, 0.1404),
  ('cabinet', 'z_min', 1.15649, 4, 0.004631);

-- Weights of features, priors of classes and weights of constraint rows: most likely classes given all others.
UPDATE feature SET weight = 0.106 WHERE name = 'area_m2';
UPDATE feature SET weight = 0.55 WHERE name = 'aspect';
UPDATE feature SET weight = 0.561 WHERE name = 'behind';
UPDATE feature SET weight = 0.238 WHERE name = 'height';
UPDATE feature SET weight = 0.0291 WHERE name = 'length';
UPDATE feature SET weight = 0.448 WHERE name = 'rectangularity';
UPDATE feature SET weight = 0.266 WHERE name = 'spread_length';
UPDATE feature SET weight = 0.117 WHERE name = 'spread_width';
UPDATE feature SET weight = 0.404 WHERE name = 'tilt_deg';
UPDATE feature SET weight = 0.261 WHERE name = 'width';
UPDATE feature SET weight = 0.516 WHERE name = 'z_max';
UPDATE feature SET weight = 0.386 WHERE name = 'z_min';
UPDATE object_class SET prior = 0.379 WHERE name = 'unknown';
UPDATE object_class SET prior = 0.0307 WHERE name = 'floor';
UPDATE object_class SET prior = 0.0263 WHERE name = 'ceiling';
UPDATE object_class SET prior = 0.121 WHERE name = 'wall';
UPDATE object_class SET prior = 0.037 WHERE name = 'table';
UPDATE object_class SET prior = 0.0587 WHERE name = 'flat_screen';
UPDATE object_class SET prior = 0.099 WHERE name = 'keyboard';
UPDATE object_class SET prior = 0.0122 WHERE name = 'chair_seat';
UPDATE object_class SET prior = 0.0673 WHERE name = 'chair_back';
UPDATE object_class SET prior = 0.0174 WHERE name = 'door';
UPDATE object_class SET prior = 0.00584 WHERE name = 'window';
UPDATE object_class SET prior = 0.0191 WHERE name = 'whiteboard';
UPDATE object_class SET prior = 0.0679 WHERE name = 'shelf';
UPDATE object_class SET prior = 0.0585 WHERE name = 'cabinet';
UPDATE class_constraint SET weight = 3.01 WHERE name = 'some_floor';
UPDATE class_constraint SET weight = 0.198 WHERE name = 'one_ceiling_level';
UPDATE class_constraint SET weight = 4.02 WHERE name = 'floor_lowest';
UPDATE class_constraint SET weight = 3.53 WHERE name = 'ceiling_highest';
UPDATE class_constraint SET weight = 2.51 WHERE name = 'ceiling_over_floor';
UPDATE class_constraint SET weight = 1.83 WHERE name = 'wall_upright';
UPDATE class_constraint SET weight = 1.53 WHERE name = 'wall_meets_ceiling';
UPDATE class_constraint SET weight = 0.554 WHERE name = 'wall_square';
UPDATE class_constraint SET weight = 0.49 WHERE name = 'wall_beside_wall';
UPDATE class_constraint SET weight = 2.84 WHERE name = 'table_level';
UPDATE class_constraint SET weight = 1.74 WHERE name = 'table_clear_above';
UPDATE class_constraint SET weight = 1.46 WHERE name = 'screen_over_table';
UPDATE class_constraint SET weight = 0.464 WHERE name = 'screen_upright';
UPDATE class_constraint SET weight = 1.39 WHERE name = 'keyboard_on_table';
UPDATE class_constraint SET weight = 0.267 WHERE name = 'keyboard_level';
UPDATE class_constraint SET weight = 2.57 WHERE name = 'keyboard_before_screen';
UPDATE class_constraint SET weight = 5.09 WHERE name = 'keyboard_not_beneath';
UPDATE class_constraint SET weight = 1.03 WHERE name = 'keyboards_apart';
UPDATE class_constraint SET weight = 0.49 WHERE name = 'screen_off_wall';
UPDATE class_constraint SET weight = 0.961 WHERE name = 'seat_level';
UPDATE class_constraint SET weight = 1.29 WHERE name = 'back_near_seat';
UPDATE class_constraint SET weight = 0.615 WHERE name = 'back_not_on_table';
UPDATE class_constraint SET weight = 2.01 WHERE name = 'door_upright';
UPDATE class_constraint SET weight = 0.816 WHERE name = 'door_in_wall';
UPDATE class_constraint SET weight = 1.36 WHERE name = 'window_in_wall';
UPDATE class_constraint SET weight = 1.22 WHERE name = 'window_along_wall';
UPDATE class_constraint SET weight = 1.43 WHERE name = 'whiteboard_on_wall';
UPDATE class_constraint SET weight = 0.35 WHERE name = 'whiteboard_along_wall';
UPDATE class_constraint SET weight = 0.992 WHERE name = 'shelf_not_on_table';
UPDATE class_constraint SET weight = 1.11 WHERE name = 'shelf_near_shelf';
UPDATE class_constraint SET weight = 0.01 WHERE name = 'cabinet_near_wall';
UPDATE class_constraint SET weight = 1.72 WHERE name = 'cabinet_not_on_table';

-- Scale of told probabilities: 1406 planes of 24 paper-like rooms, seeds from 8001.
UPDATE setting SET value = '0.537' WHERE key = 'probability_slope';
UPDATE setting SET value = '0.494' WHERE key = 'probability_offset';
