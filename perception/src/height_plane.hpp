// Planes through heights over a surface.
#pragma once

namespace scenelore::perception {

/// h = a + b u + c v.
struct HeightPlane {
  double a = 0, b = 0, c = 0;
  [[nodiscard]] double at(double u, double v) const { return a + b * u + c * v; }
};

/// Weighted sums over heights h at (u, v): what fitting a plane needs.
struct HeightSums {
  double w = 0, u = 0, v = 0, h = 0, uu = 0, uv = 0, vv = 0, uh = 0, vh = 0;

  void add(double weight, double at_u, double at_v, double height) {
    const double wu = weight * at_u, wv = weight * at_v;
    w += weight, u += wu, v += wv, h += weight * height;
    uu += wu * at_u, uv += wu * at_v, vv += wv * at_v, uh += wu * height, vh += wv * height;
  }
  /// Requires w > 0.
  [[nodiscard]] double mean() const { return h / w; }
  /// Least squares; `slope` is the deviation of a Gaussian prior on b and c. Requires w > 0, the weights being one over
  /// variances.
  [[nodiscard]] HeightPlane fit(double slope) const {
    const double certainty = 1 / (slope * slope);
    const double suu = uu - u * u / w + certainty, suv = uv - u * v / w, svv = vv - v * v / w + certainty;
    const double suh = uh - u * h / w, svh = vh - v * h / w, determinant = suu * svv - suv * suv;
    const double b = (svv * suh - suv * svh) / determinant, c = (suu * svh - suv * suh) / determinant;
    return {(h - b * u - c * v) / w, b, c};
  }
};

}  // namespace scenelore::perception
