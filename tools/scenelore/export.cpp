// `scenelore export`: a labelled scan in the formats of other tools.
#include <fmt/core.h>

#include <filesystem>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "pipeline/labelled_cloud.hpp"
#include "pipeline/text_file.hpp"
#include "plane_export.hpp"
#include "scenelore/kb/sha256.hpp"
#include "scenelore/perception/error.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

namespace fs = std::filesystem;

class ExportCommand : public Command {
 public:
  std::string name() const override { return "export"; }
  std::string summary() const override {
    return "Write a labelled scan: points (.ply, .pcd), planes (.csv, .json), or a floor plan (.svg).";
  }
  std::string example() const override {
    return "scenelore export office.gpkg office plan.svg\n"
           "scenelore export office.gpkg office labelled.ply";
  }
  std::vector<Argument> arguments() override {
    return {positional("FILE", &file_, "FILE", "knowledge base file"),
            positional("SCAN", &scan_, "NAME", "name of a stored scan"),
            positional("OUT", &out_, "FILE", "file to write; its extension names the format"),
            {"--source", &source_, "FILE", "the scan's point file, when it is no longer where it was imported from"}};
  }

  int run() override {
    const kb::KnowledgeBase base = kb::KnowledgeBase::open(file_, kb::Access::read_only);
    const kb::Scan scan = require_scan(base, file_, scan_);
    const std::string extension = fs::path(out_).extension().string();
    if (extension == ".ply" || extension == ".pcd") write_cloud(base, scan);
    else if (extension == ".csv") pipeline::write_text_file(out_, planes_csv(base, scan));
    else if (extension == ".json") pipeline::write_text_file(out_, planes_json(base, scan));
    else if (extension == ".svg") pipeline::write_text_file(out_, planes_svg(base, scan));
    else throw UsageError(fmt::format("'{}': a file to export to ends with .ply, .pcd, .csv, .json or .svg", out_));
    fmt::print("{}\n", out_);
    return kOk;
  }

 private:
  void write_cloud(const kb::KnowledgeBase& base, const kb::Scan& scan) const {
    const fs::path source = source_.value_or(scan.source);
    if (!fs::exists(source)) {
      throw perception::Error(fmt::format("{}: the point file of scan '{}' is not there any more; give it with --source",
                                          source.string(), scan.name));
    }
    if (kb::sha256_of_file(source) != scan.sha256) {
      throw perception::Error(fmt::format("{}: not the file that scan '{}' was made from (its SHA-256 differs); give that one "
                                          "with --source, or import this one with `scenelore run`", source.string(), scan.name));
    }
    perception::PointTable points = perception::read_points(source);
    pipeline::add_labels(points, base.plane_of_point(scan.id), base.labels(scan.id), base.knowledge());
    perception::write_points(out_, points);
  }

  std::string file_, scan_, out_;
  std::optional<std::string> source_;
};

}  // namespace

std::unique_ptr<Command> export_command() { return std::make_unique<ExportCommand>(); }

}  // namespace scenelore::tools
