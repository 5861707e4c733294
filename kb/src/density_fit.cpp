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

std::vector<double> borders_of(const Present& present, double low, double high) {
  std::vector<double> result{low};
  for (const Bin& bin : present.bins) {
    for (const double edge : {bin.low, bin.high}) {
      if (edge > result.back() && edge < high) result.push_back(edge);
    }
  }
  result.push_back(high);
  return result;
}

// Share of the present density between the bin's bounds.
double present_mass(const Bin& bin, const Present& present, double low, double high) {
  if (present.bins.empty()) {
    return present.gaussian ? folded_mass(bin, std::clamp(present.gaussian->mean, low, high), present.gaussian->sigma, low, high) : 0;
  }
  double mass = 0;
  for (const Bin& old : present.bins) mass += old.density * std::max(0.0, std::min(bin.high, old.high) - std::max(bin.low, old.low));
  return mass;
}

}  // namespace

Gaussian joined(const Gaussian& fitted, double n, const Present& present, double strength) {
  if (!present.gaussian || strength <= 0) return fitted;
  const Gaussian& old = *present.gaussian;
  const double all = n + strength, apart = fitted.mean - old.mean;
  const double variance = (n * fitted.sigma * fitted.sigma + strength * old.sigma * old.sigma + n * strength / all * apart * apart) / all;
  return {(n * fitted.mean + strength * old.mean) / all, std::sqrt(variance)};
}

Gaussian fit_gaussian(const std::vector<double>& sorted, double range, const LearnOptions& options) {
  const double low = quantile(sorted, options.outliers / 2), high = quantile(sorted, 1 - options.outliers / 2);
  const double n = static_cast<double>(sorted.size());
  Gaussian fit{0, 0};
  for (const double value : sorted) fit.mean += std::clamp(value, low, high) / n;
  for (const double value : sorted) fit.sigma += std::pow(std::clamp(value, low, high) - fit.mean, 2);
  fit.sigma = std::max(std::sqrt(fit.sigma / std::max(1.0, n - 1)), range / 200);
  return fit;
}

std::vector<Bin> fit_histogram(const std::vector<double>& sorted, const Gaussian& gaussian, const Present& present, double low,
                               double high, const LearnOptions& options) {
  const std::vector<double> widths = bandwidths(sorted, gaussian.sigma, (high - low) / 400);
  std::vector<double> by_size = widths;
  std::sort(by_size.begin(), by_size.end());
  const double n = static_cast<double>(sorted.size()), strength = options.gaussian_strength;
  const bool told = present.gaussian || !present.bins.empty();
  const double present_strength = told ? options.present_strength : 0;
  std::vector<double> borders = edges(sorted, by_size[by_size.size() / 2], low, high, options);
  if (!present.bins.empty() && n < 3 * present_strength) borders = borders_of(present, low, high);  // they have seen more
  const double mean = std::clamp(gaussian.mean, low, high);
  std::vector<Bin> bins;
  double total = 0;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    Bin bin{borders[i], borders[i + 1], 0};
    double mass = strength * folded_mass(bin, mean, gaussian.sigma, low, high);
    if (present_strength > 0) mass += present_strength * present_mass(bin, present, low, high);
    for (std::size_t e = 0; e < sorted.size(); ++e) {
      mass += folded_mass(bin, std::clamp(sorted[e], low, high), widths[e], low, high);
    }
    bin.density = mass / (n + strength + present_strength);
    total += bin.density;
    bins.push_back(bin);
  }
  for (Bin& bin : bins) bin.density /= total * (bin.high - bin.low);
  return bins;
}

}  // namespace scenelore::kb
