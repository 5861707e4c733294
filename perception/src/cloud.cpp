#include "scenelore/perception/cloud.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "bytes.hpp"
#include "rows_to_cloud.hpp"
#include "scenelore/perception/error.hpp"
#include "scenelore/perception/parallel.hpp"

namespace scenelore::perception {
namespace {

using Axes = std::array<const Column*, 3>;

std::string names_of(const PointTable& table) {
  std::string names;
  for (const Column& column : table.columns) names += (names.empty() ? "" : ", ") + column.name;
  return names.empty() ? "none" : names;
}

/// Columns x, y, z; X, Y, Z where these do not exist.
Axes coordinate_columns(const PointTable& table, const std::string& source_name) {
  Axes axes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char lower[] = {static_cast<char>('x' + axis), 0}, upper[] = {static_cast<char>('X' + axis), 0};
    axes[axis] = table.find(lower) != nullptr ? table.find(lower) : table.find(upper);
    if (axes[axis] == nullptr) {
      throw Error(source_name + ": no property '" + lower +
                  "'; a scan needs x, y and z (properties found: " + names_of(table) + ")");
    }
  }
  return axes;
}

/// The median coordinate of each axis, over the finite ones of some thousand rows spread evenly: a few wild points far
/// off must not move it. Zero where nothing is finite.
Eigen::Vector3d typical_position(const RowSource& rows, const Axes& axes) {
  const PointTable& table = rows.table;
  const std::size_t step = std::max<std::size_t>(1, table.rows / 4096);
  Eigen::Vector3d typical = Eigen::Vector3d::Zero();
  std::vector<double> sample;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sample.clear();
    for (std::size_t row = 0; row < table.rows; row += step) {
      const double value = value_at(rows, *axes[axis], row);
      if (std::isfinite(value)) sample.push_back(value);
    }
    if (sample.empty()) continue;
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), middle, sample.end());
    typical[static_cast<Eigen::Index>(axis)] = *middle;
  }
  return typical;
}

/// Zero as long as float offsets from zero are good to 0.03 mm (float sources: they are the very values of the file
/// below 1 km, double sources: below 100 m are good to 4 µm); else the typical position in whole metres, from which
/// they are good again.
Eigen::Vector3d choose_origin(const RowSource& rows, const Axes& axes) {
  const bool wide = std::any_of(axes.begin(), axes.end(), [](const Column* c) { return size_of(c->type) > 4; });
  const Eigen::Vector3d typical = typical_position(rows, axes);
  if (typical.cwiseAbs().maxCoeff() < (wide ? 100.0 : 1000.0)) return Eigen::Vector3d::Zero();
  return typical.array().round();
}

/// Some of the rows; coordinate(row, axis) is the file's value in double precision. Returns how many are invalid.
template <class Coordinate>
std::size_t take_offsets(std::size_t first, std::size_t last, Coordinate coordinate, Cloud& cloud) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const double cx = cloud.origin.x(), cy = cloud.origin.y(), cz = cloud.origin.z();
  std::size_t invalid = 0;
  for (std::size_t row = first; row < last; ++row) {
    const float x = static_cast<float>(coordinate(row, 0) - cx);
    const float y = static_cast<float>(coordinate(row, 1) - cy);
    const float z = static_cast<float>(coordinate(row, 2) - cz);
    // x - x is 0 for finite numbers alone. A double too large for a float has become infinite and is invalid, too.
    const bool finite = (x - x) + (y - y) + (z - z) == 0.0F;
    cloud.x[row] = finite ? x : kNone;
    cloud.y[row] = finite ? y : kNone;
    cloud.z[row] = finite ? z : kNone;
    invalid += finite ? 0 : 1;
  }
  return invalid;
}

template <class X>
std::size_t take_offsets_of(const RowSource& rows, const Axes& axes, std::size_t first, std::size_t last, Cloud& cloud) {
  const std::array<std::size_t, 3> offsets{axes[0]->offset, axes[1]->offset, axes[2]->offset};
  const std::byte* const bytes = rows.bytes;
  const std::size_t stride = rows.table.stride;
  return take_offsets(
      first, last, [=](std::size_t row, std::size_t axis) { return static_cast<double>(load<X>(bytes + row * stride + offsets[axis])); }, cloud);
}

}  // namespace

Cloud to_cloud(const RowSource& rows, const std::string& source_name, int threads) {
  const PointTable& table = rows.table;
  const Axes axes = coordinate_columns(table, source_name);
  if (table.rows == 0) throw Error(source_name + " holds no points");
  Cloud cloud;
  cloud.origin = choose_origin(rows, axes);
  for (auto* values : {&cloud.x, &cloud.y, &cloud.z}) values->resize(table.rows);
  const ScalarType type = axes[0]->type;
  const bool alike = axes[1]->type == type && axes[2]->type == type;
  constexpr std::size_t kPiece = 1 << 18;
  std::vector<std::size_t> invalid(table.rows / kPiece + 1, 0);
  const bool read_again = table.find("vp_x") != nullptr;  // by sensors_of(), which lets go in its turn
  parallel_pieces(table.rows, kPiece, threads, [&](std::size_t begin, std::size_t end) {
    // A single thread is given all rows at once; in pieces the pages of a file can be let go on the way.
    for (std::size_t first = begin; first < end; first += kPiece) {
      const std::size_t last = std::min(end, first + kPiece);
      if (alike) {
        with_type(type, [&](auto zero) { invalid[first / kPiece] = take_offsets_of<decltype(zero)>(rows, axes, first, last, cloud); });
      } else {
        invalid[first / kPiece] = take_offsets(
            first, last, [&](std::size_t row, std::size_t axis) { return value_at(rows, *axes[axis], row); }, cloud);
      }
      if (rows.file != nullptr && !read_again) rows.file->let_go(rows.bytes + first * table.stride, rows.bytes + last * table.stride);
    }
  });
  cloud.invalid = std::accumulate(invalid.begin(), invalid.end(), std::size_t{0});
  if (cloud.invalid == cloud.size()) {
    throw Error(source_name + ": none of the " + std::to_string(table.rows) + " points has finite coordinates");
  }
  cloud.sensors = sensors_of(rows, cloud, source_name);
  return cloud;
}

Cloud to_cloud(const PointTable& table, const std::string& source_name) {
  return to_cloud({.table = table, .bytes = table.bytes.data(), .file = nullptr}, source_name, 1);
}

}  // namespace scenelore::perception
