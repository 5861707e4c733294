#include "command_list.hpp"

namespace scenelore::tools {

std::vector<std::unique_ptr<Command>> all_commands() {
  std::vector<std::unique_ptr<Command>> commands;
  commands.push_back(run_command());
  commands.push_back(segment_command());
  commands.push_back(label_command());
  commands.push_back(query_command());
  commands.push_back(why_command());
  commands.push_back(watch_command());
  commands.push_back(conflict_command());
  commands.push_back(relations_command());
  commands.push_back(export_command());
  commands.push_back(info_command());
  commands.push_back(eval_command());
  commands.push_back(learn_command());
  commands.push_back(kb_init_command());
  commands.push_back(kb_add_command());
  commands.push_back(rules_check_command());
  commands.push_back(rules_test_command());
  commands.push_back(rules_profile_command());
  commands.push_back(rules_new_command());
  commands.push_back(rules_doc_command());
  commands.push_back(simulate_command());
  commands.push_back(solve_command());
  return commands;
}

}  // namespace scenelore::tools
