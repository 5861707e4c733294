#include "pipeline/pipeline.hpp"

#include <utility>

#include "pipeline/parameters_json.hpp"
#include "scenelore/kb/sha256.hpp"

namespace scenelore::pipeline {

namespace fs = std::filesystem;

Imported import_scan(kb::KnowledgeBase& base, const fs::path& source, const ImportOptions& options) {
  options.progress("reading");
  const perception::Cloud cloud = perception::read_cloud(source, options.perception.threads);

  options.progress("segmenting");
  Imported imported;
  imported.perception = perception::perceive(cloud, options.perception);
  imported.warnings = imported.perception.warnings;

  options.progress("storing");
  const perception::Upright& upright = imported.perception.upright;
  imported.scan = {.name = options.name.empty() ? source.stem().string() : options.name,
                   .source = source.string(),
                   .sha256 = kb::sha256_of_file(source),
                   .point_count = static_cast<std::int64_t>(cloud.size()),
                   .origin = cloud.origin,
                   .rotation = upright.rotation,
                   .floor_z = upright.floor_z,
                   .parameters = parameters_json(imported.perception)};
  imported.scan.id = base.store_scan(imported.scan, imported.perception.planes, imported.perception.plane_of_point,
                                     &imported.warnings);
  return imported;
}

namespace {

/// The planes of a scan with the features that need no Lua.
rules::Scene planes_of(const kb::KnowledgeBase& base, const kb::Scan& scan) {
  const std::vector<kb::StoredPlane> planes = base.planes(scan.id);
  return rules::make_scene(scan, planes, kb::built_in_features(scan, planes));
}

rules::KnownAnswers known_about(const kb::KnowledgeBase& base, const kb::Scan& scan) {
  return {base.facts(scan.id), base.pair_geometry(scan.id), base.rule_answers(scan.id)};
}

Situation situation_of(const kb::KnowledgeBase& base, const kb::Scan& scan, kb::Knowledge knowledge, rules::Scene scene,
                       rules::RuleAnswers answers) {
  Situation situation{.knowledge = std::move(knowledge), .scene = std::move(scene), .evidence = {}, .evidence_inputs = {}, .facts = std::move(answers.facts), .truth = {}};
  answers.table.errors = std::move(situation.scene.features.errors);  // rule files add values, and know no errors
  situation.scene.features = std::move(answers.table);
  situation.knowledge = rules::with_tuple_constraints(std::move(situation.knowledge), situation.facts);
  kb::Evidence evidence = base.evidence(scan.id, situation.scene.ids, situation.scene.features);
  situation.evidence = std::move(evidence.probabilities);
  situation.evidence_inputs = std::move(evidence.inputs_sha256);
  situation.truth = base.truth(scan.id);
  return situation;
}

kb::Inference label_and_store(kb::KnowledgeBase& base, const kb::Scan& scan, const Situation& situation, const std::string& rules_hash,
                              const rules::LabellingOptions& options) {
  kb::Inference inference = rules::label(situation.knowledge, situation.scene, situation.evidence, situation.facts,
                                         situation.truth, options);
  inference.run.knowledge_hash = base.knowledge_hash();
  inference.run.rules_hash = rules_hash;
  inference.run.engine_version = SCENELORE_VERSION;
  inference.evidence_inputs = situation.evidence_inputs;
  base.store_features(scan.id, situation.scene.ids, situation.scene.features);
  base.store_inference(scan.id, inference);
  return inference;
}

}  // namespace

namespace {

Situation assess(const kb::KnowledgeBase& base, const kb::Scan& scan, rules::RuleSet& rules, kb::Knowledge knowledge) {
  rules::Scene scene = planes_of(base, scan);
  rules::RuleAnswers answers = rules::answer(rules, knowledge, scene, known_about(base, scan));
  return situation_of(base, scan, std::move(knowledge), std::move(scene), std::move(answers));
}

}  // namespace

Situation assess(const kb::KnowledgeBase& base, const kb::Scan& scan, rules::RuleSet& rules) {
  return assess(base, scan, rules, base.knowledge());
}

kb::Inference label_scan(kb::KnowledgeBase& base, const kb::Scan& scan, rules::RuleSet& rules,
                         const rules::LabellingOptions& options) {
  kb::Knowledge knowledge = base.knowledge();
  const std::vector<kb::Feature> new_features = rules.new_features(knowledge);
  if (!new_features.empty()) {
    base.register_features(new_features);
    knowledge = base.knowledge();
  }
  return label_and_store(base, scan, assess(base, scan, rules, std::move(knowledge)), rules.hash(), options);
}

kb::Inference label_scan_isolated(kb::KnowledgeBase& base, const kb::Scan& scan, const std::vector<fs::path>& folders,
                                  const rules::Budget& budget, const rules::LabellingOptions& options) {
  rules::Scene scene = planes_of(base, scan);
  rules::RuleAnswers answers = rules::answer_isolated(folders, budget, base.knowledge(), scene, known_about(base, scan));
  base.register_features(answers.features);
  const std::string hash = answers.hash;
  return label_and_store(base, scan, situation_of(base, scan, base.knowledge(), std::move(scene), std::move(answers)), hash, options);
}

kb::KnowledgeBase open_or_create(const fs::path& path, const std::string& knowledge) {
  return fs::exists(path) ? kb::KnowledgeBase::open(path) : kb::KnowledgeBase::create(path, knowledge);
}

std::vector<fs::path> rule_folders(const fs::path& file, const std::vector<std::string>& given) {
  std::vector<fs::path> folders(given.begin(), given.end());
  const fs::path beside = file.parent_path() / "rules";
  if (folders.empty() && fs::is_directory(beside)) folders.push_back(beside);
  return folders;
}

rules::RuleSet load_rules(const kb::KnowledgeBase& base, const fs::path& file, const std::vector<std::string>& given,
                          const rules::Budget& budget) {
  return rules::RuleSet::load(rule_folders(file, given), budget, base.knowledge().settings);
}

}  // namespace scenelore::pipeline
