// Densities and logarithms of whole rows of numbers at once. What the evidence of all planes costs is nearly all spent here.
//
// Exponentials and logarithms are written with +, −, ×, ÷ and √ alone, so that each wider set of instructions a processor has does the same
// to more numbers at once, and the same bytes come out on every machine. libm and Eigen choose other algorithms on other processors.
// Both are within 3 units in the last place of the exact value.
#pragma once

#include <span>

namespace scenelore::kb {

/// Shares of (1) of likelihood.hpp, with u the uniform density.
struct OddValues {
  double usual = 1;    ///< 1 − ε
  double odd = 0;      ///< ε / 2, of the wide Gaussian
  double uniform = 0;  ///< ε u / 2
};

/// out[k] = (value − means[k])²; on a circle of circumference `turn` (0 = none) from the nearest image of the mean. NaN where the mean is.
void squared_distances(double value, std::span<const double> means, double turn, std::span<double> out);

/// out[k] = (1 − ε) N(d_k; s_k) + ε/2 N(d_k; 4 s_k) + ε u / 2, each Gaussian seen through normal errors: its variance is that of the kind, s_k², and
/// of the value. `squares`: d_k²; `variances`: s_k²; all of one length. NaN where one of these is.
void blurred_densities(std::span<const double> squares, std::span<const double> variances, double error, const OddValues& odd, std::span<double> out);

/// The same of a value without error, sooner. `exponents`: −1 / 2(4 s_k)²; `peaks`: 1 / s_k √2π.
void sharp_densities(std::span<const double> squares, std::span<const double> exponents, std::span<const double> peaks, const OddValues& odd,
                     std::span<double> out);

/// out[k] *= x[k].
void multiply(std::span<const double> x, std::span<double> out);

/// out[k] += factor · ln x[k]; x[k] a positive normal number.
void add_logarithms(std::span<const double> x, double factor, std::span<double> out);

/// ln Σ_k exp x[k]; one at least. Summands below e⁻⁷⁰⁰ times the greatest count as that, so −∞ is allowed where another is finite.
[[nodiscard]] double log_sum(std::span<const double> x);

}  // namespace scenelore::kb
