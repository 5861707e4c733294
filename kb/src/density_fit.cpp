// A kernel density estimate integrated over bins, mixed with a Gaussian as if that were so many further examples (a
// Dirichlet prior over the bins). Each example has a bandwidth of its own (Breiman, Meisel, Purcell 1977, Variable kernel
// estimates of multivariate densities): classes gather in heaps, level and upright, that one bandwidth for all would
// smear into one. Mass beyond the feature's range is folded back at its ends, since a tilt of −1 degree is one of +1.
#include "density_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenelore::kb {

namespace {

// The value below which a share `q` of the sorted values lies, linear between ranks.
double quantile(const std::vector<double>& sorted, double q) {
  const double at = q * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double mass_between(double low, double high, double mean, double sigma) {
  return normal_cdf((high - mean) / sigma) - normal_cdf((low - mean) / sigma);
}

// Of a bump at `mean`, folded at both ends of the range.
double folded_mass(const Bin& bin, double mean, double sigma, double low, double high) {
  return mass_between(bin.low, bin.high, mean, sigma) + mass_between(bin.low, bin.high, 2 * low - mean, sigma) +
         mass_between(bin.low, bin.high, 2 * high - mean, sigma);
}

// Half the width of the narrowest window of √n (at least 4) neighbours around each example; at most Silverman's rule of
// thumb (1986, equation 3.31: 0.9 min(s, IQR / 1.34) n^(−1/5)), at least `least`.
std::vector<double> bandwidths(const std::vector<double>& sorted, double sigma, double least) {
  const std::size_t n = sorted.size();
  const double quartiles = (quantile(sorted, 0.75) - quantile(sorted, 0.25)) / 1.34;
  const double spread = quartiles > 0 ? std::min(sigma, quartiles) : sigma;
  const double most = std::max(least, 0.9 * spread * std::pow(static_cast<double>(n), -0.2));
  const std::size_t k = std::min(n, std::max<std::size_t>(4, static_cast<std::size_t>(std::sqrt(static_cast<double>(n)))));
  std::vector<double> result(n, most);
  for (std::size_t begin = 0; begin + k <= n; ++begin) {
    const double half = std::max(least, (sorted[begin + k - 1] - sorted[begin]) / 2);
    for (std::size_t i = begin; i < begin + k; ++i) result[i] = std::min(result[i], half);
  }
  return result;
}

// Edges where they tell something: half of them at quantiles of the data, half at equal steps through its reach, thinned
// where they are closer than half a bandwidth; then the ends of the range.
std::vector<double> edges(const std::vector<double>& sorted, double step, double low, double high, const LearnOptions& options) {
  const double first = std::max(low, quantile(sorted, options.outliers / 2) - 2 * step);
  const double last = std::min(high, quantile(sorted, 1 - options.outliers / 2) + 2 * step);
  const int half = std::max(1, (options.bins - 2) / 2);
  std::vector<double> candidates;
  for (int i = 0; i <= half; ++i) {
    const double share = static_cast<double>(i) / half;
    candidates.push_back(first + share * (last - first));
    candidates.push_back(std::clamp(quantile(sorted, share), first, last));
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<double> result{low};
  for (const double edge : candidates) {
    if (edge - result.back() >= step / 2 && high - edge >= step / 2) result.push_back(edge);
  }
  result.push_back(high);
  return result;
}

}  // namespace

Gaussian fit_gaussian(const std::vector<double>& sorted, double range, const LearnOptions& options) {
  const double low = quantile(sorted, options.outliers / 2), high = quantile(sorted, 1 - options.outliers / 2);
  const double n = static_cast<double>(sorted.size());
  Gaussian fit{0, 0};
  for (const double value : sorted) fit.mean += std::clamp(value, low, high) / n;
  for (const double value : sorted) fit.sigma += std::pow(std::clamp(value, low, high) - fit.mean, 2);
  fit.sigma = std::max(std::sqrt(fit.sigma / std::max(1.0, n - 1)), range / 200);
  return fit;
}

std::vector<Bin> fit_histogram(const std::vector<double>& sorted, const Gaussian& gaussian, double low, double high,
                               const LearnOptions& options) {
  const std::vector<double> widths = bandwidths(sorted, gaussian.sigma, (high - low) / 400);
  std::vector<double> by_size = widths;
  std::sort(by_size.begin(), by_size.end());
  const std::vector<double> borders = edges(sorted, by_size[by_size.size() / 2], low, high, options);
  const double n = static_cast<double>(sorted.size()), strength = options.gaussian_strength;
  const double mean = std::clamp(gaussian.mean, low, high);
  std::vector<Bin> bins;
  double total = 0;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    Bin bin{borders[i], borders[i + 1], 0};
    double mass = strength * folded_mass(bin, mean, gaussian.sigma, low, high);
    for (std::size_t e = 0; e < sorted.size(); ++e) {
      mass += folded_mass(bin, std::clamp(sorted[e], low, high), widths[e], low, high);
    }
    bin.density = mass / (n + strength);
    total += bin.density;
    bins.push_back(bin);
  }
  for (Bin& bin : bins) bin.density /= total * (bin.high - bin.low);
  return bins;
}

}  // namespace scenelore::kb
