// `scenelore run`: the main job, scan to labels, in one command.
#include <algorithm>
#include <filesystem>
#include <optional>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "pipeline/labelled_cloud.hpp"
#include "report.hpp"
#include "scenelore/perception/memory.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

namespace fs = std::filesystem;

class RunCommand : public Command {
 public:
  std::string name() const override { return "run"; }
  std::string summary() const override { return "Segment scans, label their planes, and leave a knowledge base to query."; }
  std::string example() const override {
    return "scenelore run office.ply\n"
           "scenelore run office.ply --kb lab.gpkg --labelled office_labelled.ply";
  }
  std::vector<Argument> arguments() override {
    return joined({positional("SCAN", &scans_, "FILE", "point clouds: PLY, PCD or text with x y z"),
                   {"--kb", &kb_, "FILE", "knowledge base file, made when there is none (default: beside the scan, .gpkg)"},
                   {"--labelled", &labelled_, "FILE", "write the scan's points with plane, label, probability and class colour"},
                   {"--knowledge", &knowledge_, "PACK", "knowledge of a new file: office, paper or empty", Effect::result},
                   isolate_argument(isolate_),
                   json_argument(json_)},
                  perception_.arguments(), labelling_.arguments());
  }

  int run() override {
    if (labelled_ && scans_.size() > 1) throw UsageError("--labelled takes one scan at a time");
    perception::keep_memory(perception::Work::perception);
    const perception::PerceptionOptions perception = perception_.options();
    std::vector<Report> reports;
    int code = kOk;
    for (const std::string& scan : scans_) {
      reports.push_back(run_one(scan, perception));
      code = std::max(code, exit_code(reports.back()));
    }
    if (json_) print_json(reports);
    return code;
  }

 private:
  Report run_one(const fs::path& source, const perception::PerceptionOptions& perception) {
    const fs::path file = kb_.empty() ? fs::path(source).replace_extension(".gpkg") : fs::path(kb_);
    const auto progress = terminal_progress(source.filename().string());
    kb::KnowledgeBase base = pipeline::open_or_create(file, knowledge_);
    std::optional<rules::RuleSet> rules;
    if (!isolate_) rules = labelling_.rules.load(base, file);  // a broken rule is told before the long steps

    const pipeline::Imported imported =
        pipeline::import_scan(base, source, {.perception = perception, .progress = progress});
    warn(source.string(), imported.warnings);
    progress("labelling");
    Report report{.file = file.string(),
                  .scan = imported.scan,
                  .inference = label_scan(base, file, imported.scan, labelling_, isolate_, rules),
                  .warnings = imported.warnings,
                  .written = {}};
    if (labelled_) {
      progress("writing");
      const kb::Knowledge knowledge = base.knowledge();
      perception::PointTable points = perception::read_points(source);
      pipeline::add_labels(points, base.plane_of_point(imported.scan.id), report.inference.labels, knowledge);
      perception::write_points(*labelled_, points);
      report.written.push_back(*labelled_);
    }
    if (!json_) print_text(report, fallback_name(base));
    return report;
  }

  static std::string fallback_name(const kb::KnowledgeBase& base) {
    const kb::Knowledge knowledge = base.knowledge();
    return knowledge.classes[static_cast<std::size_t>(knowledge.fallback_index())].name;
  }

  std::vector<std::string> scans_;
  std::string kb_;
  std::optional<std::string> labelled_;
  std::string knowledge_ = "office";
  bool json_ = false, isolate_ = false;
  PerceptionArguments perception_;
  LabellingArguments labelling_;
};

}  // namespace

std::unique_ptr<Command> run_command() { return std::make_unique<RunCommand>(); }

}  // namespace scenelore::tools
