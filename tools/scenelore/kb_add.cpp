// `scenelore kb add`: more classes for a knowledge base.
#include <fmt/core.h>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::tools {

namespace {

class KbAddCommand : public Command {
 public:
  std::string name() const override { return "kb add"; }
  std::string summary() const override { return "Add a knowledge pack: classes of homes or kitchens, or a file of SQL of one's own."; }
  std::string example() const override {
    return "scenelore kb init flat.gpkg\n"
           "scenelore kb add home flat.gpkg\n"
           "scenelore simulate living_room.ply --room home --seed 3\n"
           "scenelore run living_room.ply --kb flat.gpkg";
  }
  std::vector<Argument> arguments() override {
    return {positional("PACK", &pack_, "home|kitchen|FILE", "pack that comes with the program, or INSERTs into the knowledge tables"),
            positional("KB", &file_, "FILE", "knowledge base file; all of the pack is added or nothing")};
  }
  int run() override {
    kb::KnowledgeBase base = kb::KnowledgeBase::open(file_);
    const kb::Knowledge before = base.knowledge();
    base.add_knowledge(pack_);
    const kb::Knowledge after = base.knowledge();
    fmt::print("{}: {} classes, {} constraints added; `scenelore label {}` uses them\n", file_, after.classes.size() - before.classes.size(),
               after.constraints.size() - before.constraints.size(), file_);
    return kOk;
  }

 private:
  std::string pack_, file_;
};

}  // namespace

std::unique_ptr<Command> kb_add_command() { return std::make_unique<KbAddCommand>(); }

}  // namespace scenelore::tools
