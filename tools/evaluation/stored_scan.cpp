#include "evaluation/stored_scan.hpp"

#include <algorithm>
#include <map>

#include "scenelore/kb/error.hpp"

namespace scenelore::evaluation {

namespace {

std::vector<std::vector<double>> stored_evidence(const kb::KnowledgeBase& base, const kb::Scan& scan, const kb::Knowledge& knowledge,
                                                 const std::vector<kb::PlaneId>& planes) {
  std::vector<std::vector<double>> out(planes.size(), std::vector<double>(knowledge.classes.size(), 0.0));
  base.query(
      "SELECT e.plane_id, e.class, e.probability FROM evidence e JOIN plane p ON p.id = e.plane_id WHERE p.scan_id = " + std::to_string(scan.id),
      [](const std::vector<std::string>&) {},
      [&](const kb::QueryRow& row) {
        const auto plane = std::find(planes.begin(), planes.end(), std::stoll(*row.values[0]));
        const int c = knowledge.class_index(*row.values[1]);
        if (plane == planes.end() || c < 0) return;
        out[static_cast<std::size_t>(plane - planes.begin())][static_cast<std::size_t>(c)] = std::stod(*row.values[2]);
      });
  return out;
}

}  // namespace

Answer answer_before(const kb::Knowledge& knowledge, const std::vector<std::vector<double>>& evidence) {
  Answer out;
  for (const std::vector<double>& row : evidence) {
    const auto best = std::max_element(row.begin(), row.end());
    out.classes.push_back(knowledge.classes[static_cast<std::size_t>(best - row.begin())].name);
    out.probabilities.push_back(*best);
  }
  return out;
}

Answer answer_after(const std::vector<kb::PlaneId>& planes, const std::vector<kb::Label>& labels) {
  std::map<kb::PlaneId, const kb::Label*> of_plane;
  for (const kb::Label& label : labels) of_plane[label.plane] = &label;
  Answer out;
  for (const kb::PlaneId plane : planes) {
    const auto found = of_plane.find(plane);
    if (found == of_plane.end()) throw kb::Error("plane " + std::to_string(plane) + " has no label");
    out.classes.push_back(found->second->object_class);
    out.probabilities.push_back(found->second->probability);
  }
  return out;
}

std::vector<std::int32_t> places(const std::vector<std::int64_t>& plane_id_of_point, const std::vector<kb::PlaneId>& planes) {
  std::map<kb::PlaneId, std::int32_t> place;
  for (const kb::PlaneId plane : planes) place.emplace(plane, static_cast<std::int32_t>(place.size()));
  std::vector<std::int32_t> out;
  out.reserve(plane_id_of_point.size());
  for (const std::int64_t plane : plane_id_of_point) out.push_back(plane < 0 ? -1 : place.at(plane));
  return out;
}

LabelledScan stored_scan(const kb::KnowledgeBase& base, const kb::Scan& scan) {
  std::vector<kb::PlaneId> planes;
  for (const kb::StoredPlane& plane : base.planes(scan.id)) planes.push_back(plane.id);
  std::sort(planes.begin(), planes.end());
  const std::vector<kb::Label> labels = base.labels(scan.id);
  if (labels.size() != planes.size()) {
    throw kb::Error("scan '" + scan.name + "' has planes without a label: label it first, with `scenelore label`");
  }
  const kb::Knowledge knowledge = base.knowledge();
  return {.plane_of_point = places(base.plane_of_point(scan.id), planes),
          .before = answer_before(knowledge, stored_evidence(base, scan, knowledge, planes)),
          .after = answer_after(planes, labels)};
}

}  // namespace scenelore::evaluation
