// A sub-command declares its arguments once: name, unit, bounds, help, where the value goes. The parser, --help,
// the configuration file and docs/cli.md all come from that table (cli.cpp).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace scenelore::tools {

using Target = std::variant<bool*, std::string*, std::vector<std::string>*, double*, std::optional<double>*, int*,
                            std::optional<int>*, std::uint64_t*, std::optional<std::string>*>;

/// What giving another value changes.
enum class Effect { result, speed, output };

struct Argument {
  std::string name;  ///< "--noise" is an option, "SCAN" is positional
  Target target;     ///< holds the default
  std::string unit;  ///< what stands for the value in --help: "m", "deg", "FILE"; empty for a flag
  std::string help;
  Effect effect = Effect::output;
  std::optional<double> low = {}, high = {};
  bool required = false;
};

/// A positional argument that must be given.
[[nodiscard]] inline Argument positional(std::string name, Target target, std::string unit, std::string help) {
  return {std::move(name), target, std::move(unit), std::move(help), Effect::result, {}, {}, true};
}

class Command {
 public:
  virtual ~Command() = default;
  [[nodiscard]] virtual std::string name() const = 0;  ///< "label", or with a space "kb init"
  [[nodiscard]] virtual std::string summary() const = 0;
  [[nodiscard]] virtual std::string example() const = 0;  ///< shell lines that work
  [[nodiscard]] virtual std::vector<Argument> arguments() = 0;
  /// Returns an exit code; data to stdout, all else to stderr.
  virtual int run() = 0;
};

/// All sub-commands in the order of --help.
[[nodiscard]] std::vector<std::unique_ptr<Command>> all_commands();

/// Parses and runs. Never throws: each error is one line on stderr and an exit code.
int run_command_line(int argc, char** argv);

}  // namespace scenelore::tools
