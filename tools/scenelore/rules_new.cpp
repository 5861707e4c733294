// `scenelore rules new`: a rule and its test to start from, with help for editors beside them.
#include <fmt/core.h>

#include <filesystem>
#include <optional>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "pipeline/text_file.hpp"
#include "scenelore/rules/language.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

namespace fs = std::filesystem;

class RulesNewCommand : public Command {
 public:
  std::string name() const override { return "rules new"; }
  std::string summary() const override { return "Start a relation (or a feature): its file, its test, and help for editors."; }
  std::string example() const override {
    return "scenelore rules new leans_on\n"
           "scenelore rules new far_above --extends above";
  }
  std::vector<Argument> arguments() override {
    return {positional("NAME", &name_, "NAME", "of the relation: letters, digits, _"),
            {"--extends", &extends_, "RELATION", "built-in relation whose tolerances are to be changed", Effect::result},
            {"--feature", &feature_, "", "a feature: one number for each plane", Effect::result},
            {"--in", &folder_, "DIR", "folder to write to; made when it is not there (default: rules)"}};
  }

  int run() override {
    if (feature_ && extends_) throw UsageError("--feature and --extends exclude each other");
    if (name_.empty() || name_.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") != name_.npos ||
        (name_[0] >= '0' && name_[0] <= '9')) {
      throw UsageError("'" + name_ + "' is no name for a rule: letters, digits and _");
    }
    const rules::NewRule made = feature_   ? rules::new_feature(name_)
                                : extends_ ? rules::new_variant(name_, *extends_)
                                           : rules::new_relation(name_);
    const fs::path folder = folder_;
    for (const char* ending : {".lua", "_test.lua"}) {
      if (fs::exists(folder / (name_ + ending))) throw UsageError((folder / (name_ + ending)).string() + ": exists already and is never overwritten");
    }
    fs::create_directories(folder / ".scenelore");
    write(folder / (name_ + ".lua"), made.rule);
    write(folder / (name_ + "_test.lua"), made.test);
    write(folder / ".scenelore" / "meta.lua", rules::language_meta());
    if (!fs::exists(folder / ".luarc.json")) write(folder / ".luarc.json", rules::language_luarc());
    if (!fs::exists(folder / ".luacheckrc")) write(folder / ".luacheckrc", rules::language_luacheckrc());
    fmt::print("next: edit {}, then: scenelore rules test {}\n", (folder / (name_ + ".lua")).string(), folder.string());
    return kOk;
  }

 private:
  static void write(const fs::path& path, const std::string& text) {
    pipeline::write_text_file(path, text);
    fmt::print("written: {}\n", path.string());
  }

  std::string name_, folder_ = "rules";
  std::optional<std::string> extends_;
  bool feature_ = false;
};

}  // namespace

std::unique_ptr<Command> rules_new_command() { return std::make_unique<RulesNewCommand>(); }

}  // namespace scenelore::tools
