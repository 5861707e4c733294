// `scenelore eval`: labelled scans held against what is really there.
#include <fmt/core.h>

#include <filesystem>
#include <map>

#include "command_list.hpp"
#include "evaluation/error.hpp"
#include "evaluation/report.hpp"
#include "evaluation/stored_scan.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "pipeline/text_file.hpp"
#include "scenelore/kb/error.hpp"

namespace scenelore::tools {

namespace {

namespace fs = std::filesystem;

bool is_cloud(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".ply" || extension == ".pcd" || extension == ".csv";
}

/// The truth for a scan: a file, and whether it was merely found in a folder.
struct Found {
  fs::path path;
  bool in_folder = false;
};

class EvalCommand : public Command {
 public:
  std::string name() const override { return "eval"; }
  std::string summary() const override {
    return "Score labelled scans against the truth: objects per class before and after constraints, points, segmentation, probabilities.";
  }
  std::string example() const override {
    return "scenelore eval office.gpkg --truth office.ply\n"
           "scenelore eval office.gpkg --truth office.ply --class table --class flat_screen --class keyboard --html office_eval.html";
  }
  std::vector<Argument> arguments() override {
    return joined(
        {positional("FILE", &files_, "FILE", "knowledge base files with labelled scans"),
         {"--truth", &truth_, "FILE|DIR|rows",
          "labelled clouds (properties label and instance), by the scans' names; or `rows`: the rows of the table truth, which "
          "the answer is then not told", Effect::result, {}, {}, true},
         {"--class-map", &map_, "FILE|indoor", "which classes are right for the clouds' labels (default: labels are ids of object_class)",
          Effect::result},
         {"--label-names", &names_, "FILE", "names of the clouds' label ids for --class-map (default: labels.txt beside or above the cloud)",
          Effect::result},
         {"--scan", &scan_, "NAME", "only this scan (default: all)", Effect::result},
         {"--class", &classes_, "NAME", "only this class in the table of objects and its sum; may be repeated"},
         {"--html", &html_, "FILE", "write a page with plots, too"},
         json_argument(json_)},
        rules_.arguments());
  }

  int run() override {
    evaluation::Evaluation sum;
    int skipped = 0;
    for (const std::string& file : files_) {
      const kb::KnowledgeBase base = kb::KnowledgeBase::open(file, kb::Access::read_only);
      const kb::Knowledge knowledge = base.knowledge();
      for (const std::string& name : classes_) {
        if (knowledge.class_index(name) < 0) throw kb::Error(fmt::format("{}: --class '{}' does not exist", file, name));
      }
      for (const kb::Scan& scan : scans_or_all(base, file, scan_)) {
        if (const auto one = evaluate_scan(base, file, knowledge, scan)) sum += *one;
        else ++skipped;
      }
    }
    if (sum.scans == 0) throw evaluation::Error(fmt::format("no truth for any scan in {}", joined_truth()));
    const evaluation::ReportOptions options{.title = "Labels against " + (by_rows() ? "truth rows" : joined_truth()), .classes = classes_,
                                            .segmentation = !by_rows()};
    if (html_) pipeline::write_text_file(*html_, evaluation::to_html(sum, options));
    fmt::print("{}", json_ ? evaluation::to_json(sum, options) : evaluation::to_text(sum, options));
    return kOk;
  }

 private:
  [[nodiscard]] bool by_rows() const { return truth_.size() == 1 && truth_[0] == "rows"; }
  [[nodiscard]] std::string joined_truth() const {
    std::string out;
    for (const std::string& path : truth_) out += (out.empty() ? "" : ", ") + path;
    return out;
  }

  /// Nothing for a scan that the truth says nothing about.
  std::optional<evaluation::Evaluation> evaluate_scan(const kb::KnowledgeBase& base, const std::string& file, const kb::Knowledge& knowledge,
                                                      const kb::Scan& scan) {
    const std::string& fallback = knowledge.classes[static_cast<std::size_t>(knowledge.fallback_index())].name;
    if (by_rows()) {
      if (base.truth(scan.id).empty()) return skip(scan, "has no truth rows");
      const evaluation::SceneTruth truth = evaluation::truth_of_rows(base.truth(scan.id), base.plane_of_point(scan.id));
      return evaluation::evaluate(untold(base, file, scan), truth, fallback);
    }
    const std::optional<Found> found = find_truth(scan, file, scan_.empty() ? base.scans().size() : 1);
    if (!found) return skip(scan, "has no cloud of its name among the truth");
    try {
      const evaluation::SceneTruth truth = evaluation::read_truth(truth_file(found->path, knowledge), knowledge);
      if (truth.object_of_point.size() != static_cast<std::size_t>(scan.point_count)) {
        throw evaluation::Error(fmt::format("{}: {} points, but scan '{}' of {} has {}: the truth must be of the same cloud, point by point",
                                            found->path.string(), truth.object_of_point.size(), scan.name, file, scan.point_count));
      }
      return evaluation::evaluate(evaluation::stored_scan(base, scan), truth, fallback);
    } catch (const evaluation::NoTruth& none) {
      if (!found->in_folder) throw;
      return skip(scan, none.what());
    }
  }

  std::optional<evaluation::Evaluation> skip(const kb::Scan& scan, const std::string& why) {
    fmt::print(stderr, "{}: left out: {}\n", scan.name, why);
    return std::nullopt;
  }

  /// The answer as it is when the engine knows no truth row.
  evaluation::LabelledScan untold(const kb::KnowledgeBase& base, const std::string& file, const kb::Scan& scan) {
    rules::RuleSet rules = rules_.load(base, file);
    const pipeline::Situation s = pipeline::assess(base, scan, rules);
    const kb::Inference answer = rules::label(s.knowledge, s.scene, s.evidence, s.facts, {}, {.alternatives = 0, .reasons = false});
    if (answer.labels.size() != s.scene.ids.size()) throw kb::Error(fmt::format("{}: no world model of scan '{}' was found", file, scan.name));
    return {.plane_of_point = evaluation::places(base.plane_of_point(scan.id), s.scene.ids),
            .before = evaluation::answer_before(s.knowledge, s.evidence),
            .after = evaluation::answer_after(s.scene.ids, answer.labels)};
  }

  std::optional<Found> find_truth(const kb::Scan& scan, const std::string& file, std::size_t scans) {
    std::vector<Found> named;
    for (const std::string& given : truth_) {
      if (!fs::exists(given)) throw evaluation::Error(given + ": there is no such truth file or folder");
      if (!fs::is_directory(given)) {
        if (fs::path(given).stem() == scan.name) named.push_back({given, false});
        continue;
      }
      for (const auto& entry : fs::recursive_directory_iterator(given)) {
        if (is_cloud(entry.path()) && entry.path().stem() == scan.name) named.push_back({entry.path(), true});
      }
    }
    if (named.size() > 1) {
      throw evaluation::Error(fmt::format("scan '{}' of {}: more than one truth of that name: {} and {}", scan.name, file, named[0].path.string(),
                                          named[1].path.string()));
    }
    if (!named.empty()) return named[0];
    const bool one_for_one = truth_.size() == 1 && files_.size() == 1 && scans == 1 && !fs::is_directory(truth_[0]);
    if (one_for_one) return Found{truth_[0], false};
    return std::nullopt;
  }

  evaluation::TruthFile truth_file(const fs::path& path, const kb::Knowledge& knowledge) {
    evaluation::TruthFile out{.path = path, .map = nullptr, .names = {}};
    if (!map_) return out;
    if (!class_map_) {
      std::vector<std::string> classes;
      for (const kb::ObjectClass& c : knowledge.classes) classes.push_back(c.name);
      class_map_ = evaluation::read_class_map(*map_, classes);
    }
    const fs::path names = names_ ? fs::path(*names_) : evaluation::find_label_names(path);
    if (names.empty()) throw evaluation::Error(path.string() + ": no labels.txt beside or above it says what its labels mean; give --label-names");
    out.map = &*class_map_;
    out.names = evaluation::read_label_names(names);
    return out;
  }

  std::vector<std::string> files_, truth_, classes_;
  std::optional<std::string> map_, names_, html_;
  std::string scan_;
  bool json_ = false;
  RuleArguments rules_;
  std::optional<evaluation::ClassMap> class_map_;
};

}  // namespace

std::unique_ptr<Command> eval_command() { return std::make_unique<EvalCommand>(); }

}  // namespace scenelore::tools
