#include "scenelore/rules/objects.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {

namespace {

using kb::CompositePart;
using kb::Orientation;

/// Degrees from 45 on a plane is upright, below it level.
constexpr double kUpright = 45;

struct Labelled {
  const Scene& scene;
  std::vector<std::string> classes;                                       // by plane index
  std::map<std::string, std::map<std::pair<int, int>, double>> relations;  // name → (a, b) → degree that holds

  [[nodiscard]] bool fits(int plane, const CompositePart& part) const {
    const auto p = static_cast<std::size_t>(plane);
    if (classes[p] != part.object_class) return false;
    if (part.orientation == Orientation::any) return true;
    return (scene.planes[p].tilt_deg >= kUpright) == (part.orientation == Orientation::upright);
  }
  [[nodiscard]] double degree(const std::string& relation, int a, int b) const {
    const auto of = relations.find(relation);
    if (of == relations.end()) return 0;
    const auto found = of->second.find({a, b});
    return found == of->second.end() ? 0 : found->second;
  }
  [[nodiscard]] std::vector<int> all(const CompositePart& part) const {
    std::vector<int> out;
    for (int p = 0; p < static_cast<int>(classes.size()); ++p) {
      if (fits(p, part)) out.push_back(p);
    }
    return out;
  }
};

Labelled labelled(const kb::Knowledge& knowledge, const Scene& scene, const std::vector<kb::Label>& labels,
                  const std::vector<kb::RelationFact>& facts) {
  Labelled out{scene, std::vector<std::string>(scene.ids.size()), {}};
  std::map<kb::PlaneId, int> place;
  for (std::size_t p = 0; p < scene.ids.size(); ++p) place[scene.ids[p]] = static_cast<int>(p);
  for (const kb::Label& label : labels) out.classes[static_cast<std::size_t>(place.at(label.plane))] = label.object_class;
  const double hold = hold_degree(knowledge);
  for (const kb::Composite& composite : knowledge.composites) {
    for (const CompositePart& part : composite.parts) {
      if (composite.enabled && part.relation) out.relations[*part.relation];
    }
  }
  std::map<std::pair<int, int>, double>* of = nullptr;  // of the relation at work: facts come by relation
  const std::string* relation = nullptr;
  for (const kb::RelationFact& fact : facts) {
    if (relation == nullptr || *relation != fact.relation) {
      const auto used = out.relations.find(fact.relation);
      of = used == out.relations.end() ? nullptr : &used->second;
      relation = &fact.relation;
    }
    if (of != nullptr && fact.degree >= hold) (*of)[{place.at(fact.a), place.at(fact.b)}] = fact.degree;
  }
  return out;
}

/// Anchor of each part plane (index into `anchors`, −1 = none): the assignment of highest total degree, by augmenting along the path that
/// gains most, again and again (min-cost flow, Ahuja, Magnanti, Orlin 1993, section 9.7; a dozen planes each).
std::vector<int> assign(const std::vector<std::vector<double>>& degree, std::size_t anchors, int most) {
  const std::size_t parts = degree.size();
  std::vector<int> owner(parts, -1), used(anchors, 0);
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  for (;;) {
    std::vector<double> best(anchors, kNone);  // gain of freeing a place at an anchor, or of ending there
    std::vector<int> via(anchors, -1);         // part that comes to the anchor
    for (std::size_t p = 0; p < parts; ++p) {
      if (owner[p] >= 0) continue;
      for (std::size_t a = 0; a < anchors; ++a) {
        if (degree[p][a] > 0 && degree[p][a] > best[a]) best[a] = degree[p][a], via[a] = static_cast<int>(p);
      }
    }
    for (std::size_t round = 0; round < anchors; ++round) {  // parts move on from full anchors: Bellman and Ford
      for (std::size_t p = 0; p < parts; ++p) {
        if (owner[p] < 0 || best[static_cast<std::size_t>(owner[p])] == kNone) continue;
        const auto from = static_cast<std::size_t>(owner[p]);
        for (std::size_t a = 0; a < anchors; ++a) {
          if (a == from || degree[p][a] <= 0) continue;
          const double gain = best[from] - degree[p][from] + degree[p][a];
          if (gain > best[a] + 1e-12) best[a] = gain, via[a] = static_cast<int>(p);
        }
      }
    }
    int end = -1;
    for (std::size_t a = 0; a < anchors; ++a) {
      if (used[a] < most && best[a] > 1e-12 && (end < 0 || best[a] > best[static_cast<std::size_t>(end)] + 1e-12)) end = static_cast<int>(a);
    }
    if (end < 0) return owner;
    ++used[static_cast<std::size_t>(end)];
    for (int a = end; a >= 0;) {
      const int part = via[static_cast<std::size_t>(a)], before = owner[static_cast<std::size_t>(part)];
      owner[static_cast<std::size_t>(part)] = a;
      a = before;
    }
  }
}

/// Objects as anchor and (plane, part) pairs, in scene indices.
struct Group {
  int anchor = 0;
  std::vector<std::pair<int, const CompositePart*>> parts;
};

void add_parts(const Labelled& world, const CompositePart& part, std::vector<Group>& groups) {
  const std::vector<int> planes = world.all(part);
  std::vector<std::vector<double>> degree;
  for (const int p : planes) {
    std::vector<double>& row = degree.emplace_back();
    for (const Group& group : groups) row.push_back(world.degree(*part.relation, p, group.anchor));
  }
  const std::vector<int> owner = assign(degree, groups.size(), part.most);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (owner[p] >= 0) groups[static_cast<std::size_t>(owner[p])].parts.emplace_back(planes[p], &part);
  }
}

/// Planes of one class that hang together, by any of the parts' relations.
std::vector<Group> groups_of_one_class(const Labelled& world, const CompositePart& anchor, const std::vector<const CompositePart*>& own) {
  std::vector<int> of(world.classes.size());
  std::iota(of.begin(), of.end(), 0);
  const auto root = [&](int p) {
    while (of[static_cast<std::size_t>(p)] != p) p = of[static_cast<std::size_t>(p)];
    return p;
  };
  for (const CompositePart* part : own) {
    const auto found = world.relations.find(*part->relation);
    if (found == world.relations.end()) continue;
    for (const auto& [pair, degree] : found->second) {
      const auto a = static_cast<std::size_t>(pair.first), b = static_cast<std::size_t>(pair.second);
      if (world.classes[a] != anchor.object_class || world.classes[b] != anchor.object_class) continue;
      const int low = std::min(root(pair.first), root(pair.second)), high = std::max(root(pair.first), root(pair.second));
      of[static_cast<std::size_t>(high)] = low;
    }
  }
  std::map<int, std::vector<int>> members;
  for (std::size_t p = 0; p < of.size(); ++p) {
    if (world.classes[p] == anchor.object_class) members[root(static_cast<int>(p))].push_back(static_cast<int>(p));
  }
  std::vector<Group> out;
  for (const auto& [first, planes] : members) {
    Group group{-1, {}};
    const auto area = [&](int p) { return world.scene.planes[static_cast<std::size_t>(p)].area_m2; };
    for (const int p : planes) {
      if (world.fits(p, anchor) && (group.anchor < 0 || area(p) > area(group.anchor))) group.anchor = p;
    }
    if (group.anchor < 0) continue;
    for (const int p : planes) {
      if (p == group.anchor) continue;
      for (const CompositePart* part : own) {
        const auto taken = std::count_if(group.parts.begin(), group.parts.end(), [&](const auto& entry) { return entry.second == part; });
        if (!world.fits(p, *part) || taken >= part->most) continue;
        group.parts.emplace_back(p, part);
        break;
      }
    }
    out.push_back(std::move(group));
  }
  return out;
}

bool complete(const Group& group, const kb::Composite& composite) {
  return std::all_of(composite.parts.begin(), composite.parts.end(), [&](const CompositePart& part) {
    if (!part.relation) return true;
    return std::count_if(group.parts.begin(), group.parts.end(), [&](const auto& entry) { return entry.second == &part; }) >= part.fewest;
  });
}

}  // namespace

std::vector<kb::Object> group_objects(const kb::Knowledge& knowledge, const Scene& scene, const std::vector<kb::Label>& labels,
                                      const std::vector<kb::RelationFact>& facts) {
  std::vector<kb::Object> out;
  if (labels.empty()) return out;
  const Labelled world = labelled(knowledge, scene, labels, facts);
  for (const kb::Composite& composite : knowledge.composites) {
    const auto anchor = std::find_if(composite.parts.begin(), composite.parts.end(), [](const CompositePart& part) { return !part.relation; });
    if (!composite.enabled || anchor == composite.parts.end()) continue;
    std::vector<const CompositePart*> own;
    for (const CompositePart& part : composite.parts) {
      if (part.relation && part.object_class == anchor->object_class) own.push_back(&part);
    }
    std::vector<Group> groups;
    if (own.empty()) {
      for (const int p : world.all(*anchor)) groups.push_back({p, {}});
    } else {
      groups = groups_of_one_class(world, *anchor, own);
    }
    for (const CompositePart& part : composite.parts) {
      if (part.relation && part.object_class != anchor->object_class) add_parts(world, part, groups);
    }
    std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.anchor < b.anchor; });
    int number = 0;
    for (const Group& group : groups) {
      if (!complete(group, composite)) continue;
      kb::Object& object = out.emplace_back();
      object.composite = composite.name;
      object.number = ++number;
      object.planes.emplace_back(scene.ids[static_cast<std::size_t>(group.anchor)], anchor->part);
      for (const auto& [p, part] : group.parts) object.planes.emplace_back(scene.ids[static_cast<std::size_t>(p)], part->part);
    }
  }
  return out;
}

}  // namespace scenelore::rules
