// Instances for the engine's benchmark, made from a seed.
#pragma once

#include <cstdint>

#include "scenelore/engine/problem.hpp"

namespace scenelore::bench {

/// Planes with noisy class costs, a hard table for each pair of planes (one of six relations, each allowing most class
/// pairs), and "a screen needs some table below it" for each plane. Nothing true is hidden in it.
engine::Problem random_planes(std::uint64_t seed, int planes, int classes);
/// The same with a true labelling that most costs speak for, as in a room that was scanned.
engine::Problem noisy_room(std::uint64_t seed, int planes, int classes);
/// `rooms` such rooms side by side in one problem.
engine::Problem building(std::uint64_t seed, int rooms, int planes);
/// Random Max-CSP: each pair is constrained with probability `density`, each of its tuples costs 1 with `tightness`.
engine::Problem max_csp(std::uint64_t seed, int variables, int labels, double density, double tightness);
/// Potts model on a square grid with random label costs and random smoothing of each edge.
engine::Problem grid_mrf(std::uint64_t seed, int side, int labels);
/// Each customer is served by one of the warehouses that are open; opening and serving cost. At most `most` are open.
engine::Problem warehouses(std::uint64_t seed, int count, int customers);
/// Frequencies of links that must or should differ by a distance.
engine::Problem radio_links(std::uint64_t seed, int links, int frequencies);

}  // namespace scenelore::bench
