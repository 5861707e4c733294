// Constraint rows of the shipped office that change labels: each alone, on planes whose features leave it open.
#include <gtest/gtest.h>

#include "scenelore/kb/knowledge_base.hpp"
#include "scenelore/rules/labelling.hpp"
#include "scenelore/rules/made_plane.hpp"
#include "scenelore/rules/rule_set.hpp"
#include "temporary_folder.hpp"

namespace scenelore::rules {
namespace {

const double kWall = 2.4;  // metres high
const MadePlane kFront{.center = {0, 0, 1.2}, .normal = {0, -1, 0}, .length = 0.5, .width = kWall, .along = {1, 0, 0}},
    kSide{.center = {0.25, 0.25, 1.2}, .normal = {1, 0, 0}, .length = 0.5, .width = kWall, .along = {0, 1, 0}},
    kAcrossTheRoom{.center = {3, 1.8, 1.2}, .normal = {1, 0, 0}, .length = 0.5, .width = kWall, .along = {0, 1, 0}};

/// The classes of planes that are `named` or unknown with even odds, when only one row of the office holds.
std::vector<std::string> labels(const std::string& row, const std::string& named, const std::vector<MadePlane>& made) {
  const test::TemporaryFolder folder;
  kb::Knowledge knowledge = kb::KnowledgeBase::create(folder / "office.gpkg", "office").knowledge();
  std::erase_if(knowledge.constraints, [&](const kb::ClassConstraint& c) { return c.name != row; });
  if (knowledge.constraints.size() != 1) return {"no row " + row};
  knowledge.composites.clear();
  RuleSet rules = RuleSet::load();
  const Scene scene = make_scene(made);
  std::vector<double> even(knowledge.classes.size(), 0.0);
  even[static_cast<std::size_t>(knowledge.class_index(named))] = 0.52;
  even[static_cast<std::size_t>(knowledge.class_index("unknown"))] = 0.48;
  const kb::Inference inference =
      label(knowledge, scene, std::vector<std::vector<double>>(made.size(), even), rules.relate(scene, {*knowledge.constraints[0].relation}), {});
  std::vector<std::string> out;
  for (const kb::Label& l : inference.labels) out.push_back(l.object_class);
  return out;
}

using Classes = std::vector<std::string>;

TEST(OfficeRows, FacesOfAPillarAreWallsForMeetingAtACorner) {
  EXPECT_EQ(labels("wall_at_corner", "wall", {kFront, kSide}), (Classes{"wall", "wall"}));
  EXPECT_EQ(labels("wall_at_corner", "wall", {kFront, kAcrossTheRoom}), (Classes{"unknown", "unknown"}));
}

TEST(OfficeRows, ACabinetShowsMoreThanOneFace) {
  EXPECT_EQ(labels("cabinet_of_faces", "cabinet", {kFront, kSide}), (Classes{"cabinet", "cabinet"}));
  EXPECT_EQ(labels("cabinet_of_faces", "cabinet", {kFront, kAcrossTheRoom}), (Classes{"unknown", "unknown"}));
}

}  // namespace
}  // namespace scenelore::rules
