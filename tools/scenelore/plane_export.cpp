#include "plane_export.hpp"

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "export/floor_plan.hpp"
#include "result_table.hpp"
#include "scenelore/rules/scene.hpp"

namespace scenelore::tools {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json to_json(const perception::Ring& ring) {
  Json out = Json::array();
  for (const Eigen::Vector3d& corner : ring) out.push_back(to_json(corner));
  return out;
}

/// JSON has no infinity: null.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json label_json(const kb::Label& label, const std::vector<kb::Reason>& reasons) {
  Json sentences = Json::array();
  for (const kb::Reason& reason : reasons) sentences.push_back(reason.sentence);
  return {{"class", label.object_class},
          {"probability", label.probability},
          {"margin", finite(label.margin)},
          {"runner_up", label.runner_up ? Json(*label.runner_up) : Json(nullptr)},
          {"reasons", std::move(sentences)}};
}

Json plane_json(const kb::StoredPlane& stored) {
  const perception::Plane& plane = stored.plane;
  Json holes = Json::array();
  for (const perception::Ring& hole : plane.hull.holes) holes.push_back(to_json(hole));
  const Eigen::Quaterniond& q = plane.orientation;
  return {{"plane", stored.id},
          {"centroid", to_json(plane.centroid)},
          {"normal", to_json(plane.normal)},
          {"orientation_wxyz", {q.w(), q.x(), q.y(), q.z()}},
          {"area_m2", plane.area_m2},
          {"length", plane.length},
          {"width", plane.width},
          {"rectangularity", plane.rectangularity},
          {"tilt_deg", plane.tilt_deg},
          {"height", plane.height},
          {"z_min", plane.z_min},
          {"z_max", plane.z_max},
          {"rmse", plane.rmse},
          {"points", plane.point_count},
          {"hull", {{"outer", to_json(plane.hull.outer)}, {"holes", std::move(holes)}}}};
}

std::map<kb::PlaneId, kb::Label> labels_by_plane(const kb::KnowledgeBase& base, const kb::Scan& scan) {
  std::map<kb::PlaneId, kb::Label> out;
  for (const kb::Label& label : base.labels(scan.id)) out[label.plane] = label;
  return out;
}

}  // namespace

std::string planes_csv(const kb::KnowledgeBase& base, const kb::Scan& scan) {
  std::string name;
  for (const char c : scan.name) name.append(c == '\'' ? 2 : 1, c);
  return to_csv(run_query(base, fmt::format("SELECT * FROM labelled_plane WHERE scan = '{}' ORDER BY plane", name)));
}

std::string planes_json(const kb::KnowledgeBase& base, const kb::Scan& scan) {
  const auto labels = labels_by_plane(base, scan);
  Json planes = Json::array();
  for (const kb::StoredPlane& stored : base.planes(scan.id)) {
    Json plane = plane_json(stored);
    if (const auto found = labels.find(stored.id); found != labels.end()) {
      plane.update(label_json(found->second, base.reasons(stored.id)));
    }
    planes.push_back(std::move(plane));
  }
  const Eigen::Quaterniond& q = scan.rotation;
  Json relations = Json::parse(to_json(run_query(
      base, fmt::format("SELECT relation, a, b, degree FROM relation_fact WHERE scan_id = {} ORDER BY relation, a, b", scan.id))));
  const Json out{{"scan", scan.name},
                 {"source", scan.source},
                 {"sha256", scan.sha256},
                 {"points", scan.point_count},
                 {"rotation_wxyz", {q.w(), q.x(), q.y(), q.z()}},
                 {"floor_z", scan.floor_z},
                 {"planes", std::move(planes)},
                 {"relations", std::move(relations)}};
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string planes_svg(const kb::KnowledgeBase& base, const kb::Scan& scan) {
  const kb::Knowledge knowledge = base.knowledge();
  const auto labels = labels_by_plane(base, scan);
  const rules::Scene scene = rules::make_scene(scan, base.planes(scan.id), {});
  exports::FloorPlan plan;
  plan.title = scan.name;
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    const auto found = labels.find(scene.ids[i]);
    const int index = found == labels.end() ? knowledge.fallback_index() : knowledge.class_index(found->second.object_class);
    if (index < 0) continue;
    const kb::ObjectClass& known = knowledge.classes[static_cast<std::size_t>(index)];
    const perception::Plane& plane = scene.planes[i];
    plan.items.push_back({.hull = plane.hull,
                          .class_name = known.name,
                          .color = known.color,
                          .probability = found == labels.end() ? 0 : found->second.probability,
                          .id = scene.ids[i],
                          .tilt_deg = plane.tilt_deg,
                          .height = plane.height});
  }
  return exports::floor_plan_svg(plan);
}

}  // namespace scenelore::tools
