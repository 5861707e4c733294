// The glue: cloud → planes → evidence → world model → labels, as two functions over the four modules. The command line,
// the benchmarks and the end-to-end tests all go through here.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scenelore/kb/knowledge_base.hpp"
#include "scenelore/perception/perceive.hpp"
#include "scenelore/rules/isolated.hpp"
#include "scenelore/rules/labelling.hpp"
#include "scenelore/rules/rule_set.hpp"

namespace scenelore::pipeline {

/// Told the name of each long step as it begins.
using Progress = std::function<void(const std::string& step)>;

struct ImportOptions {
  std::string name;  ///< of the scan; empty = the file's name without its extension
  perception::PerceptionOptions perception;
  Progress progress = [](const std::string&) {};
};

struct Imported {
  kb::Scan scan;
  perception::Perception perception;
  std::vector<std::string> warnings;
};

/// Reads, segments and stores one scan; a scan of the same name is replaced.
/// Throws perception::Error for the file, kb::Error for the knowledge base.
Imported import_scan(kb::KnowledgeBase& base, const std::filesystem::path& source, const ImportOptions& options);

/// Evidence and facts of a stored scan: all that labelling, explaining and exporting need. The cloud is not touched.
struct Situation {
  kb::Knowledge knowledge;
  rules::Scene scene;
  std::vector<std::vector<double>> evidence;  ///< [plane][class]
  std::string evidence_inputs;                ///< kb::Evidence::inputs_sha256
  rules::Facts facts;
  std::vector<std::pair<kb::PlaneId, std::string>> truth;
};
[[nodiscard]] Situation assess(const kb::KnowledgeBase& base, const kb::Scan& scan, rules::RuleSet& rules);

/// Labels a stored scan with the knowledge and the rules as they are now, and stores the answer.
kb::Inference label_scan(kb::KnowledgeBase& base, const kb::Scan& scan, rules::RuleSet& rules,
                         const rules::LabellingOptions& options = {});

/// The same with rules from strangers, which are loaded and asked in a process of their own (rules::answer_isolated).
kb::Inference label_scan_isolated(kb::KnowledgeBase& base, const kb::Scan& scan, const std::vector<std::filesystem::path>& folders,
                                  const rules::Budget& budget, const rules::LabellingOptions& options = {});

/// The knowledge base file at `path`: opened, or created with the named knowledge pack when there is none.
[[nodiscard]] kb::KnowledgeBase open_or_create(const std::filesystem::path& path, const std::string& knowledge = "office");

/// The built-in rules and those of the folders given, else of a folder `rules` beside the knowledge base file if there is
/// one, with the tolerances that the knowledge's settings replace (`above.reach`).
[[nodiscard]] rules::RuleSet load_rules(const kb::KnowledgeBase& base, const std::filesystem::path& file,
                                        const std::vector<std::string>& given, const rules::Budget& budget = {});
/// The folders that load_rules takes: those given, else `rules` beside the file if there is one.
[[nodiscard]] std::vector<std::filesystem::path> rule_folders(const std::filesystem::path& file, const std::vector<std::string>& given);

}  // namespace scenelore::pipeline
