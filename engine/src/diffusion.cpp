// Diffusion: function by function, all costs of its variables go into it, and each variable gets its share of what its
// labels cost in any case. Where existential consistency pushes costs to the first variables and is stuck when these
// cannot use them, here they spread evenly, pass by pass, and the bound goes on rising towards that of the best shifting
// (the local polytope). For two variables this is the handshake of MPLP++: Tourani, Shekhovtsov, Rother, Savchynskyy,
// "MPLP++: Fast, parallel dual block-coordinate ascent for dense graphical models", ECCV 2018, in whole numbers.
#include <algorithm>

#include "network.hpp"

namespace scenelore::engine {
namespace {

/// Of each column, the least cost with what its row has: costs is row-major.
void least_of_columns(std::span<const Cost> costs, std::span<const Cost> row_has, std::span<Cost> least) {
  std::fill(least.begin(), least.end(), kTop);
  const Cost* cost = costs.data();
  for (const Cost own : row_has)
    for (Cost& column : least) column = std::min(column, *cost++ + own);
}

}  // namespace

/// potentials_[first + i] = what live label i costs inside a function that has been given all of it.
void Network::pour_in(int v, int shift_cell, std::size_t first) {
  const auto labels_of = live(v);
  const bool open = labels_of.size() > 1;  // a settled variable has nothing to give
  for (std::size_t i = 0; i < labels_of.size(); ++i)
    potentials_[first + i] = (open ? unary(v, labels_of[i]) : 0) - cost_at(shift_cell + labels_of[i]);
}

/// Live label i gets got[i]; the function keeps kept[i].
void Network::pour_out(int v, int shift_cell, std::span<const Cost> got, std::span<const Cost> kept) {
  const auto labels_of = live(v);
  for (std::size_t i = 0; i < labels_of.size(); ++i) {
    set(static_cast<int>(cell(v, labels_of[i])), got[i]);
    set(shift_cell + labels_of[i], -kept[i]);
  }
}

/// y takes half of what it can get, x all that is left then, and y the rest.
bool Network::diffuse(const BinaryFunction& f) {
  const auto xs = live(f.x), ys = live(f.y);
  const std::size_t nx = xs.size(), ny = ys.size();
  if (nx == 1 || ny == 1 || cost_at(f.idle_cell) != 0) return true;
  potentials_.resize(2 * (nx + ny) + ny + nx * ny);
  const std::span<Cost> all(potentials_);
  const auto x = all.first(nx), y = all.subspan(nx, ny);
  const auto got_x = all.subspan(nx + ny, nx), got_y = all.subspan(2 * nx + ny, ny), least = all.subspan(2 * (nx + ny), ny);
  const auto costs = all.subspan(2 * (nx + ny) + ny, nx * ny);
  pour_in(f.x, f.x_cell, 0);
  pour_in(f.y, f.y_cell, nx);
  const Cost* const table = tables_[static_cast<std::size_t>(f.table)].data();
  Cost any = 0;
  for (std::size_t i = 0; i < nx; ++i)
    for (std::size_t j = 0; j < ny; ++j) any |= costs[i * ny + j] = table[xs[i] * at(f.y).size + ys[j]];
  if (any == 0) return set_idle(f, x, y);

  least_of_columns(costs, x, least);
  if (std::any_of(least.begin(), least.end(), is_forbidden)) return strike_forbidden(f);
  for (std::size_t j = 0; j < ny; ++j) y[j] -= got_y[j] = (least[j] + y[j]) / 2;
  for (std::size_t i = 0; i < nx; ++i) {
    Cost row = kTop;
    for (std::size_t j = 0; j < ny; ++j) row = std::min(row, costs[i * ny + j] + y[j]);
    if (is_forbidden(row)) return strike_forbidden(f);
    got_x[i] = row + x[i];
    x[i] = -row;
  }
  least_of_columns(costs, x, least);
  for (std::size_t j = 0; j < ny; ++j) {
    got_y[j] += least[j] + y[j];
    y[j] = -least[j];
  }
  pour_out(f.x, f.x_cell, got_x, x);
  pour_out(f.y, f.y_cell, got_y, y);
  return settle(f.x) && settle(f.y);
}

/// No two live labels cost anything together: what the function was given goes back, and it is not looked at again.
bool Network::set_idle(const BinaryFunction& f, std::span<Cost> x, std::span<Cost> y) {
  const Cost least = *std::min_element(x.begin(), x.end());
  for (Cost& cost : x) cost -= least;
  for (Cost& cost : y) cost += least;
  scratch_.assign(std::max(x.size(), y.size()), 0);
  pour_out(f.x, f.x_cell, x, scratch_);
  pour_out(f.y, f.y_cell, y, scratch_);
  set(f.idle_cell, 1);
  return settle(f.x) && settle(f.y);
}

bool Network::strike_forbidden(const BinaryFunction& f) {
  failed_constraint_ = f.constraint;
  for (const int v : {f.x, f.y}) {
    const View side = view(f, v);
    const auto clashes = [&](int label) {
      const auto others = live(side.from);
      return std::all_of(others.begin(), others.end(), [&](int other) {
        return is_forbidden(side.table[label * side.to_stride + other * side.from_stride]);
      });
    };
    for (int i = at(v).live - 1; i >= 0; --i) {
      const int label = order_[static_cast<std::size_t>(at(v).first + i)];
      if (clashes(label) && !strike(v, label)) return false;
    }
  }
  failed_constraint_ = -1;
  return true;
}

/// As long as a pass closes a good part of the gap to the limit, and at most so often.
bool Network::diffuse(int most_passes, Cost part, int most_idle) {
  int idle = 0;
  for (int pass = 0; pass < most_passes && idle < most_idle; ++pass) {
    const Cost before = bound();
    for (const BinaryFunction& f : binary_) {
      if (!diffuse(f)) return false;
      if (out_of_time()) return true;
    }
    for (std::size_t r = 0; r < requirements_.size(); ++r) {
      if (!diffuse(static_cast<int>(r))) return false;
      if (out_of_time()) return true;
    }
    if (!propagate()) return false;
    const Cost room = is_forbidden(limit_) ? bound() : limit_ - bound();
    idle = bound() - before <= std::max(least_gain_, room / part) ? idle + 1 : 0;
  }
  return true;
}

}  // namespace scenelore::engine
