#include "row_math.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "likelihood.hpp"

// One body for every width of registers; which is run is chosen when the program starts. (Under sanitizers, and with clang, that is the narrow one.)
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SCENELORE_EVERY_WIDTH __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define SCENELORE_EVERY_WIDTH
#endif

namespace scenelore::kb {

namespace {

constexpr double kPeak = 0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2;  // of the normal distribution

/// Exponents below which a summand is lost in the rounding of the others: of one that is at most 1 beside one of 1; of the wide Gaussian beside
/// the uniform part, unless σ is below a 10⁻⁴ th of the range. Smaller powers are numbers without all their digits, which processors
/// are slow with.
constexpr double kLost = -700, kLostBesideUniform = -43;

// ln 2 in two parts; the first has zeros enough at its end that its product with any exponent is exact (Cody & Waite 1980).
constexpr double kLn2High = 0x1.62e42fefa0000p-1, kLn2Low = 0x1.cf79abc9e3b39p-40;

/// eˣ for |x| ≤ 700: 2ⁿ eʳ with |r| ≤ ln 2 / 2 and the Taylor series of eʳ up to r¹³, by the scheme of Estrin.
inline double exponential(double x) {
  constexpr double kToInteger = 0x1.8p52;  // what is added to it loses its fraction, and its last bits are the integer
  const double shifted = x * std::numbers::log2e + kToInteger;
  const double n = shifted - kToInteger;
  const double r = (x - n * kLn2High) - n * kLn2Low;
  const double r2 = r * r, r4 = r2 * r2, r8 = r4 * r4;
  const double low = ((1 + r) + r2 * (1 / 2. + r * (1 / 6.))) + r4 * ((1 / 24. + r * (1 / 120.)) + r2 * (1 / 720. + r * (1 / 5040.)));
  const double high = ((1 / 40320. + r * (1 / 362880.)) + r2 * (1 / 3628800. + r * (1 / 39916800.))) + r4 * (1 / 479001600. + r * (1 / 6227020800.));
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(low + r8 * high) + (std::bit_cast<std::uint64_t>(shifted) << 52));
}

/// ln x of a positive normal number: e ln 2 + 2 artanh((m − 1) / (m + 1)) with x = 2ᵉ m, √½ ≤ m < √2, and the series of artanh up to the 21st power.
inline double logarithm(double x) {
  constexpr std::uint64_t kRootOfHalf = 0x3fe6a09e667f3bcdULL, kMantissa = 0x000fffffffffffffULL;
  const std::uint64_t above = std::bit_cast<std::uint64_t>(x) - kRootOfHalf;
  const double m = std::bit_cast<double>((above & kMantissa) + kRootOfHalf);
  const double e = std::bit_cast<double>(((above >> 52) ^ 0x800) | 0x4330000000000000ULL) - (0x1p52 + 0x800);  // of 12 bits with a sign
  const double s = (m - 1) / (m + 1), z = s * s, z2 = z * z, z4 = z2 * z2;
  const double series = ((1 / 3. + z * (1 / 5.)) + z2 * (1 / 7. + z * (1 / 9.))) +
                        z4 * (((1 / 11. + z * (1 / 13.)) + z2 * (1 / 15. + z * (1 / 17.))) + z4 * (1 / 19. + z * (1 / 21.)));
  return e * kLn2High + (2 * s + (2 * s * z * series + e * kLn2Low));
}

}  // namespace

// std::remainder is slow and exact. So is one turn taken off a distance of half a turn to two of them (Sterbenz 1974), and distances
// between two points of a circle's range are no longer.
SCENELORE_EVERY_WIDTH
void squared_distances(double value, std::span<const double> means, double turn, std::span<double> out) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = std::abs(value - means[k]);
  if (turn > 0) {
    const bool far = std::any_of(out.begin(), out.end(), [turn](double distance) { return distance > 1.5 * turn; });
    for (double& distance : out) {
      if (far) distance = std::remainder(distance, turn);
      distance -= distance > turn / 2 ? turn : 0;
    }
  }
  for (double& distance : out) distance *= distance;
}

SCENELORE_EVERY_WIDTH
void blurred_densities(std::span<const double> squares, std::span<const double> variances, double error, const OddValues& odd, std::span<double> out) {
  const double usual = odd.usual * kPeak, wide = odd.odd * kPeak, blur = error * error;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double near = variances[k] + blur, far = kTail * kTail * variances[k] + blur;
    const double of_near = exponential(std::max(-0.5 * squares[k] / near, kLost)), of_far = exponential(std::max(-0.5 * squares[k] / far, kLost));
    out[k] = usual * of_near / std::sqrt(near) + wide * of_far / std::sqrt(far) + odd.uniform;
  }
}

SCENELORE_EVERY_WIDTH
void sharp_densities(std::span<const double> squares, std::span<const double> exponents, std::span<const double> peaks, const OddValues& odd,
                     std::span<double> out) {
  static_assert(kTail == 4);  // so the two exponents are as 16 to one, and one exponential gives both
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double far = exponential(std::max(squares[k] * exponents[k], kLostBesideUniform));
    const double far2 = far * far, far4 = far2 * far2, far8 = far4 * far4;
    out[k] = peaks[k] * (odd.usual * (far8 * far8) + odd.odd / kTail * far) + odd.uniform;
  }
}

SCENELORE_EVERY_WIDTH
void multiply(std::span<const double> x, std::span<double> out) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] *= x[k];
}

SCENELORE_EVERY_WIDTH
void add_logarithms(std::span<const double> x, double factor, std::span<double> out) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] += factor * logarithm(x[k]);
}

// The exponentials of many at once; the sum in their order, one by one.
SCENELORE_EVERY_WIDTH
double log_sum(std::span<const double> x) {
  constexpr std::size_t kAtOnce = 64;
  std::array<double, kAtOnce> powers;
  const double highest = *std::max_element(x.begin(), x.end());
  double sum = 0;
  for (std::size_t begin = 0; begin < x.size(); begin += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, x.size() - begin);
    for (std::size_t k = 0; k < count; ++k) powers[k] = exponential(std::max(x[begin + k] - highest, kLost));
    for (std::size_t k = 0; k < count; ++k) sum += powers[k];
  }
  return highest + logarithm(sum);
}

}  // namespace scenelore::kb
