// `scenelore kb init`: a new knowledge base file.
#include <fmt/core.h>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"

namespace scenelore::tools {

namespace {

class KbInitCommand : public Command {
 public:
  std::string name() const override { return "kb init"; }
  std::string summary() const override { return "Make a knowledge base file with the default knowledge as rows."; }
  std::string example() const override { return "scenelore kb init empty_lab.gpkg"; }
  std::vector<Argument> arguments() override {
    return {positional("FILE", &file_, "FILE", "file to make; an existing one is never touched"),
            {"--knowledge", &knowledge_, "PACK",
             "office; paper (equation 1, hand-set Gaussians, hard constraints: the reference mode); or empty", Effect::result}};
  }
  int run() override {
    const kb::KnowledgeBase base = kb::KnowledgeBase::create(file_, knowledge_);
    const kb::Knowledge knowledge = base.knowledge();
    fmt::print("{}: {} classes, {} features, {} constraints\n", file_, knowledge.classes.size(), knowledge.features.size(),
               knowledge.constraints.size());
    return kOk;
  }

 private:
  std::string file_;
  std::string knowledge_ = "office";
};

}  // namespace

std::unique_ptr<Command> kb_init_command() { return std::make_unique<KbInitCommand>(); }

}  // namespace scenelore::tools
