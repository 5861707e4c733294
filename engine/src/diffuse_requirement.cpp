// Diffusion through a requirement (see diffusion.cpp, and pull_requirement.cpp for the formula). One after the other, each
// of its variables takes its share of what its labels cost in any case, the last one all; then each takes what is left.
// What the members before and after the one at hand cost is kept up to date, so that one round looks at each label twice.
// A member with one label takes and gives nothing: all of those together are two numbers, what they cost and the cheapest
// support among them.
#include <algorithm>

#include "network.hpp"

namespace scenelore::engine {

class RequirementDiffusion {
  using Side = Network::Side;

 public:
  RequirementDiffusion(Network& network, const RequirementFunction& function)
      : net_(network), f_(function), sides_(network.sides_), potentials_(network.potentials_), prices_(network.prices_),
        got_(network.got_), after_(network.after_) {}

  /// False: some label is forbidden by the requirement alone; nothing was changed.
  bool share_out() {
    sides_.clear();
    closed_ = f_.weight;
    for (const auto& member : f_.members) {
      if (net_.at(member.variable).live > 1)
        add(member.variable, member.cell);
      else
        close(member);
    }
    members_ = sides_.size();
    open_ = static_cast<Cost>(members_ + (net_.at(f_.x).live > 1 ? 1 : 0));
    if (open_ < 2) return true;
    add(f_.x, f_.x_cell);
    potentials_.resize(labels_);
    prices_.assign(labels_, kTop);
    got_.assign(labels_, 0);
    for (const Side& side : sides_) pour_in(side);
    std::size_t m = 0;
    for (const auto& member : f_.members) {
      if (net_.at(member.variable).live < 2) continue;
      Side& side = sides_[m++];
      price(member, side);
      weigh(side);
      sum_ += side.least;
    }
    weigh_owner();
    if (!round(open_) || !round(1)) return false;
    for (const Side& side : sides_)
      if (side.size > 1) pour_out(side);
    return true;
  }

 private:
  void add(int v, int cell) {
    const auto size = static_cast<std::size_t>(net_.at(v).live);
    sides_.push_back({v, cell, labels_, size});
    labels_ += size;
  }

  void close(const RequirementFunction::Member& member) {
    const int label = net_.value(member.variable);
    const Cost given = -net_.cost_at(member.cell + label);
    Cost price = kTop;
    for (const auto& [support, cost] : member.supports)
      if (support == label) price = cost;
    sum_ += given;
    closed_ = std::min(closed_, std::min(kTop, given + price) - given);
  }

  /// What each live label costs inside the function when that has been given all of it. A settled variable has nothing to give.
  void pour_in(const Side& side) {
    const int* const live = net_.live(side.variable).data();
    const Cost* const own = net_.cost_.data() + net_.at(side.variable).first;
    const Cost* const shift = net_.cost_.data() + side.cell;
    Cost* const potential = potentials_.data() + side.first;
    for (std::size_t i = 0; i < side.size; ++i) potential[i] = (side.size > 1 ? own[live[i]] : 0) - shift[live[i]];
  }

  void pour_out(const Side& side) {
    const int* const live = net_.live(side.variable).data();
    const int own = net_.at(side.variable).first;
    for (std::size_t i = 0; i < side.size; ++i) {
      net_.set(own + live[i], got_[side.first + i]);
      net_.set(side.cell + live[i], -potentials_[side.first + i]);
    }
  }

  void price(const RequirementFunction::Member& member, const Side& side) {
    for (const auto& [label, cost] : member.supports) {
      const auto place = static_cast<std::size_t>(net_.position_[net_.cell(side.variable, label)]);
      if (place < side.size) prices_[side.first + place] = cost;
    }
  }

  void weigh(Side& side) const {
    const Cost* const potential = potentials_.data() + side.first;
    const Cost* const price = prices_.data() + side.first;
    Cost least = kTop, support = kTop;
    for (std::size_t i = 0; i < side.size; ++i) {
      least = std::min(least, potential[i]);
      support = std::min(support, potential[i] + price[i]);
    }
    side.least = least;
    side.support = support - least;
  }

  void weigh_owner() {
    idle_ = active_ = kTop;
    const auto live = net_.live(f_.x);
    for (std::size_t i = 0; i < live.size(); ++i) {
      Cost& least = live[i] == f_.label ? active_ : idle_;
      least = std::min(least, potentials_[sides_.back().first + i]);
    }
  }

  /// The first one takes one of so many shares, the next one of one less, and so on; 1 = each takes all.
  bool round(Cost shares) {
    after_.assign(members_ + 1, closed_);  // least support of the members from there on
    for (std::size_t m = members_; m-- > 0;) after_[m] = std::min(after_[m + 1], sides_[m].support);
    Cost before = closed_;
    for (std::size_t m = 0; m < members_; ++m) {
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
      const Cost all = potentials_[i] + others, share = shares == 1 ? all : all / shares;
      potentials_[i] -= share;
      got_[i] += share;
    }
    if (shares > 1) --shares;
    return true;
  }

  Network& net_;
  const RequirementFunction& f_;
  std::vector<Side>& sides_;  ///< members with more than one label, then the owner
  std::vector<Cost>&potentials_, &prices_, &got_, &after_;  ///< by label of the sides; prices: as a support, kTop = it is none
  std::size_t labels_ = 0, members_ = 0;
  Cost open_ = 0;                  ///< variables with more than one label
  Cost closed_ = kTop;             ///< the weight, or the cheapest support among the members with one label
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
