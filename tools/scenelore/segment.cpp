// `scenelore segment`: the first half of `run`, scan to planes in the knowledge base.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "scenelore/perception/memory.hpp"

namespace scenelore::tools {

namespace {

class SegmentCommand : public Command {
 public:
  std::string name() const override { return "segment"; }
  std::string summary() const override { return "Segment scans into planes and store them, without labelling."; }
  std::string example() const override { return "scenelore segment office.ply --kb lab.gpkg"; }
  std::vector<Argument> arguments() override {
    return joined({positional("SCAN", &scans_, "FILE", "point clouds: PLY, PCD or text with x y z"),
                   {"--kb", &kb_, "FILE", "knowledge base file, made when there is none", Effect::output, {}, {}, true},
                   {"--knowledge", &knowledge_, "PACK", "knowledge of a new file: office, paper or empty", Effect::result},
                   json_argument(json_)},
                  perception_.arguments());
  }

  int run() override {
    perception::keep_memory(perception::Work::perception);
    const perception::PerceptionOptions perception = perception_.options();
    kb::KnowledgeBase base = pipeline::open_or_create(kb_, knowledge_);
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    int code = kOk;
    for (const std::string& source : scans_) {
      const pipeline::Imported imported =
          pipeline::import_scan(base, source, {.perception = perception, .progress = terminal_progress(source)});
      warn(source, imported.warnings);
      const std::size_t planes = imported.perception.planes.size();
      if (planes == 0) code = std::max<int>(code, kNegative);
      if (json_) {
        out.push_back({{"scan", imported.scan.name},
                       {"points", imported.scan.point_count},
                       {"planes", planes},
                       {"parameters", nlohmann::ordered_json::parse(imported.scan.parameters)},
                       {"warnings", imported.warnings}});
      } else {
        fmt::print("{}: {} points, {} planes; {}\n", imported.scan.name, imported.scan.point_count, planes,
                   imported.perception.upright.explanation);
      }
    }
    if (json_) fmt::print("{}\n", out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return code;
  }

 private:
  std::vector<std::string> scans_;
  std::string kb_;
  std::string knowledge_ = "office";
  bool json_ = false;
  PerceptionArguments perception_;
};

}  // namespace

std::unique_ptr<Command> segment_command() { return std::make_unique<SegmentCommand>(); }

}  // namespace scenelore::tools
