// One function a sub-command, each in a source file of its name.
#pragma once

#include <memory>

#include "command.hpp"

namespace scenelore::tools {

std::unique_ptr<Command> run_command();
std::unique_ptr<Command> segment_command();
std::unique_ptr<Command> label_command();
std::unique_ptr<Command> query_command();
std::unique_ptr<Command> why_command();
std::unique_ptr<Command> export_command();
std::unique_ptr<Command> info_command();
std::unique_ptr<Command> eval_command();
std::unique_ptr<Command> learn_command();
std::unique_ptr<Command> kb_init_command();
std::unique_ptr<Command> kb_add_command();
std::unique_ptr<Command> conflict_command();
std::unique_ptr<Command> relations_command();
std::unique_ptr<Command> watch_command();
std::unique_ptr<Command> rules_check_command();
std::unique_ptr<Command> rules_test_command();
std::unique_ptr<Command> rules_profile_command();
std::unique_ptr<Command> rules_new_command();
std::unique_ptr<Command> rules_doc_command();
std::unique_ptr<Command> simulate_command();
std::unique_ptr<Command> solve_command();

}  // namespace scenelore::tools
