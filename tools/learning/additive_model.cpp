#include "learning/additive_model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace scenelore::learning {
namespace {

/// Weights of the two knots around a value.
struct Place {
  std::size_t knot = 0;
  double next = 0;  ///< weight of the knot after it
};

Place place(const std::vector<double>& at, double x) {
  if (!(x > at.front())) return {0, 0};
  if (x >= at.back()) return {at.size() - 2, 1};
  const auto k = static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), x) - at.begin()) - 1;
  return {k, (x - at[k]) / (at[k + 1] - at[k])};
}

/// Equal shares of the distinct values between them; a value that many examples share is one knot.
std::vector<double> knots_of(std::vector<double> values, std::size_t count) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<double> at;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count - 1);
    double x = values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    if (!at.empty()) x = std::max(x, at.back() + 1e-3 * (1 + std::abs(at.back())));
    at.push_back(x);
  }
  return at;
}

}  // namespace

double AdditiveModel::odds(const std::vector<double>& traits) const {
  double sum = offset;
  for (std::size_t t = 0; t < curves.size(); ++t) {
    const auto [k, next] = place(curves[t].at, traits[t]);
    sum += (1 - next) * curves[t].odds[k] + next * curves[t].odds[k + 1];
  }
  return sum;
}

AdditiveModel fit_additive(const std::vector<std::vector<double>>& traits, const std::vector<bool>& outcomes, std::size_t knots, double penalty) {
  const std::size_t n = traits.size(), width = n == 0 ? 0 : traits.front().size();
  const auto yes = static_cast<std::size_t>(std::count(outcomes.begin(), outcomes.end(), true));
  if (n != outcomes.size() || yes == 0 || yes == n) throw std::invalid_argument("an additive model needs examples of both outcomes");
  AdditiveModel model;
  for (std::size_t t = 0; t < width; ++t) {
    std::vector<double> values;
    for (const std::vector<double>& row : traits) {
      if (row.size() != width) throw std::invalid_argument("examples of an additive model differ in their number of traits");
      values.push_back(row[t]);
    }
    model.curves.push_back({knots_of(std::move(values), knots), std::vector<double>(knots, 0)});
  }
  const auto size = static_cast<Eigen::Index>(1 + width * knots);
  Eigen::MatrixXd fixed = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t t = 0; t < width; ++t) {
    const auto first = static_cast<Eigen::Index>(1 + t * knots);
    for (std::size_t k = 0; k < knots; ++k) fixed(first + static_cast<Eigen::Index>(k), first + static_cast<Eigen::Index>(k)) += 0.05 * penalty;
    for (std::size_t k = 0; k + 2 < knots; ++k) {
      const Eigen::Vector3d bend(1, -2, 1);
      fixed.block<3, 3>(first + static_cast<Eigen::Index>(k), first + static_cast<Eigen::Index>(k)) += penalty * bend * bend.transpose();
    }
  }
  Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
  for (int round = 0; round < 25; ++round) {
    Eigen::MatrixXd hessian = fixed;
    Eigen::VectorXd gradient = -fixed * b;
    std::vector<std::pair<Eigen::Index, double>> row;
    for (std::size_t i = 0; i < n; ++i) {
      row.assign(1, {0, 1.0});
      for (std::size_t t = 0; t < width; ++t) {
        const auto [k, next] = place(model.curves[t].at, traits[i][t]);
        const auto at = static_cast<Eigen::Index>(1 + t * knots + k);
        row.emplace_back(at, 1 - next);
        row.emplace_back(at + 1, next);
      }
      double odds = 0;
      for (const auto& [at, weight] : row) odds += weight * b[at];
      const double p = 1 / (1 + std::exp(-odds)), w = std::max(p * (1 - p), 1e-6);
      for (const auto& [p_at, p_weight] : row) {
        gradient[p_at] += p_weight * ((outcomes[i] ? 1.0 : 0.0) - p);
        for (const auto& [q_at, q_weight] : row) hessian(p_at, q_at) += w * p_weight * q_weight;
      }
    }
    const Eigen::VectorXd step = hessian.ldlt().solve(gradient);
    b += step;
    if (step.cwiseAbs().maxCoeff() < 1e-6) break;
  }
  model.offset = b[0];
  for (std::size_t t = 0; t < width; ++t) {
    for (std::size_t k = 0; k < knots; ++k) model.curves[t].odds[k] = b[static_cast<Eigen::Index>(1 + t * knots + k)];
    double mean = 0;
    for (const std::vector<double>& row : traits) {
      const auto [k, next] = place(model.curves[t].at, row[t]);
      mean += ((1 - next) * model.curves[t].odds[k] + next * model.curves[t].odds[k + 1]) / static_cast<double>(n);
    }
    for (double& odds : model.curves[t].odds) odds -= mean;
    model.offset += mean;
  }
  return model;
}

}  // namespace scenelore::learning
