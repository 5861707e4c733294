#include "documentation.hpp"

#include <fmt/core.h>

#include <sstream>
#include <type_traits>

namespace scenelore::tools {

namespace {

std::string default_text(const Argument& argument) {
  return std::visit(
      [](auto* target) -> std::string {
        using Value = std::remove_pointer_t<decltype(target)>;
        if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, int> || std::is_same_v<Value, std::uint64_t>) {
          return fmt::format("{}", *target);
        } else if constexpr (std::is_same_v<Value, std::string>) {
          return *target;
        } else if constexpr (std::is_same_v<Value, bool>) {
          return "off";
        } else {
          return "";
        }
      },
      argument.target);
}

const char* effect_text(Effect effect) {
  switch (effect) {
    case Effect::result: return "result";
    case Effect::speed: return "speed";
    case Effect::output: return "output";
  }
  return "";
}

}  // namespace

std::string indented(const std::string& text) {
  std::istringstream lines(text);
  std::string out, line;
  while (std::getline(lines, line)) out += "  " + line + "\n";
  return out;
}

std::string documentation(const std::vector<std::unique_ptr<Command>>& commands) {
  std::string out =
      "# Command line\n\n"
      "Made by `scenelore --documentation` from the tables that the parser itself uses; a test holds this page against it.\n\n"
      "Data goes to stdout, everything else to stderr. `--config FILE` reads options of a command from a file of lines\n"
      "`name = value`. The last column tells what an option changes: the result, only speed, or only the output.\n\n"
      "| exit code | meaning |\n| --- | --- |\n"
      "| 0 | ok |\n| 1 | ran, but the answer is negative: no planes, no valid world model, a check failed |\n"
      "| 2 | usage |\n| 3 | a scan or problem file could not be read, or an output not written |\n| 4 | knowledge base or rule error |\n"
      "| 5 | a limit or an interrupt struck; the best answer so far is stored |\n| 70 | internal error |\n";
  for (const auto& command : commands) {
    out += fmt::format("\n## scenelore {}\n\n{}\n\n```sh\n{}\n```\n\n", command->name(), command->summary(), command->example());
    out += "| argument | value | default | meaning | changes |\n| --- | --- | --- | --- | --- |\n";
    for (const Argument& argument : command->arguments()) {
      out += fmt::format("| `{}` | {} | {} | {} | {} |\n", argument.name, argument.unit, default_text(argument), argument.help,
                         effect_text(argument.effect));
    }
  }
  return out;
}

}  // namespace scenelore::tools
