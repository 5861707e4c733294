// Diffusion through a requirement (see diffusion.cpp, and pull_requirement.cpp for the formula). One after the other, each
// of its variables takes its share of what its labels cost in any case, the last one all; then each takes what is left.
// What the members before and after the one at hand cost is kept up to date, so that one round looks at each label twice.
#include <algorithm>

#include "network.hpp"

namespace scenelore::engine {

class RequirementDiffusion {
 public:
  RequirementDiffusion(Network& network, const RequirementFunction& function) : net_(network), f_(function) {}

  /// False: some label is forbidden by the requirement alone; nothing was changed.
  bool share_out() {
    for (const auto& member : f_.members) add(member.variable, member.cell);
    add(f_.x, f_.x_cell);
    if (open_ < 2) return true;
    net_.potentials_.resize(labels_);
    prices_.assign(labels_, kTop);
    got_.assign(labels_, 0);
    for (Side& side : sides_) net_.pour_in(side.variable, side.cell, side.first);
    for (std::size_t m = 0; m < f_.members.size(); ++m) {
      price(m);
      weigh(sides_[m]);
      sum_ += sides_[m].least;
    }
    weigh_owner();
    if (!round(open_) || !round(1)) return false;
    for (const Side& side : sides_)
      if (side.size > 1)
        net_.pour_out(side.variable, side.cell, std::span(got_).subspan(side.first, side.size),
                      std::span(net_.potentials_).subspan(side.first, side.size));
    return true;
  }

 private:
  struct Side {  ///< a member, or in the end the owner
    int variable, cell;
    std::size_t first, size;  ///< its live labels in potentials_, prices_, got_
    Cost least = 0;           ///< what the member costs at least
    Cost support = kTop;      ///< what it costs as a support on top of that
  };

  void add(int v, int cell) {
    const std::size_t size = net_.live(v).size();
    sides_.push_back({v, cell, labels_, size});
    labels_ += size;
    open_ += size > 1 ? 1 : 0;
  }

  void price(std::size_t m) {
    const auto live = net_.live(sides_[m].variable);
    for (const auto& [label, cost] : f_.members[m].supports) {
      const auto place = std::find(live.begin(), live.end(), label);
      if (place != live.end()) prices_[sides_[m].first + static_cast<std::size_t>(place - live.begin())] = cost;
    }
  }

  void weigh(Side& side) const {
    side.least = side.support = kTop;
    for (std::size_t i = side.first; i < side.first + side.size; ++i) {
      side.least = std::min(side.least, net_.potentials_[i]);
      side.support = std::min(side.support, net_.potentials_[i] + prices_[i]);
    }
    side.support -= side.least;
  }

  void weigh_owner() {
    idle_ = active_ = kTop;
    const auto live = net_.live(f_.x);
    for (std::size_t i = 0; i < live.size(); ++i) {
      Cost& least = live[i] == f_.label ? active_ : idle_;
      least = std::min(least, net_.potentials_[sides_.back().first + i]);
    }
  }

  /// The first one takes one of so many shares, the next one of one less, and so on; 1 = each takes all.
  bool round(Cost shares) {
    const std::size_t members = sides_.size() - 1;
    after_.assign(members + 1, f_.weight);  // least support of the members from there on
    for (std::size_t m = members; m-- > 0;) after_[m] = std::min(after_[m + 1], sides_[m].support);
    Cost before = f_.weight;
    for (std::size_t m = 0; m < members; ++m) {
      Side& side = sides_[m];
      const Cost others = std::min(before, after_[m + 1]), rest = sum_ - side.least;
      const bool fine = take(side, shares, [&](std::size_t i) {
        return rest + std::min(idle_, active_ + std::min(others, prices_[i]));
      });
      if (!fine) return false;
      weigh(side);
      sum_ = rest + side.least;
      before = std::min(before, side.support);
    }
    const auto live = net_.live(f_.x);
    const Side& owner = sides_.back();
    const bool fine = take(owner, shares, [&](std::size_t i) { return sum_ + (live[i - owner.first] == f_.label ? before : 0); });
    weigh_owner();
    return fine;
  }

  bool take(const Side& side, Cost& shares, const auto& from_others) {
    if (side.size < 2) return true;
    for (std::size_t i = side.first; i < side.first + side.size; ++i) {
      const Cost others = from_others(i);
      if (is_forbidden(others)) return false;
      const Cost share = (net_.potentials_[i] + others) / shares;
      net_.potentials_[i] -= share;
      got_[i] += share;
    }
    if (shares > 1) --shares;
    return true;
  }

  Network& net_;
  const RequirementFunction& f_;
  std::vector<Side> sides_{};
  std::size_t labels_ = 0;
  Cost open_ = 0;                  ///< variables with more than one label
  std::vector<Cost> prices_{};     ///< as a support; kTop = it is none
  std::vector<Cost> got_{}, after_{};
  Cost sum_ = 0;                   ///< of what each member costs at least
  Cost idle_ = kTop, active_ = kTop;
};

bool Network::diffuse(int requirement) {
  const RequirementFunction& f = requirements_[static_cast<std::size_t>(requirement)];
  if (!is_live(f.x, f.label)) return true;
  if (!RequirementDiffusion(*this, f).share_out()) return filter_global(requirement);
  set(f.shifted_cell, 1);
  set(f.lifted_cell, 1);
  for (const auto& member : f.members)
    if (!settle(member.variable)) return false;
  return settle(f.x);
}

}  // namespace scenelore::engine
