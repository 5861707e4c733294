// The only source that knows CLI11: turns the commands' argument tables into a parser, and errors into exit codes.
#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <type_traits>

#include "documentation.hpp"
#include "exit_code.hpp"
#include "command.hpp"
#include "evaluation/error.hpp"
#include "scenelore/engine/error.hpp"
#include "scenelore/kb/error.hpp"
#include "scenelore/perception/error.hpp"
#include "scenelore/rules/error.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

template <typename T>
constexpr bool is_number_v = std::is_same_v<T, double> || std::is_same_v<T, int> || std::is_same_v<T, std::uint64_t> ||
                             std::is_same_v<T, std::optional<double>> || std::is_same_v<T, std::optional<int>>;

/// Says "INT in [1 - 16]" of whole numbers, and "FLOAT in …" of others.
template <typename T>
CLI::Range range(double low, double high) {
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>) return {low, high};
  else return {static_cast<long long>(low), static_cast<long long>(high)};
}

void add_argument(CLI::App& app, const Argument& argument) {
  std::visit(
      [&](auto* target) {
        using Value = std::remove_pointer_t<decltype(target)>;
        CLI::Option* option = nullptr;
        if constexpr (std::is_same_v<Value, bool>) {
          option = app.add_flag(argument.name, *target, argument.help);
        } else {
          option = app.add_option(argument.name, *target, argument.help);
          option->type_name(argument.unit);
          if constexpr (is_number_v<Value>) {
            if (argument.low && argument.high) option->check(range<Value>(*argument.low, *argument.high));
          }
          if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, int> || std::is_same_v<Value, std::uint64_t>) {
            option->capture_default_str();
          }
        }
        if (argument.required) option->required();
      },
      argument.target);
}

/// "kb init" hangs below a group "kb", made when first met. Only what begins with `asked` gets its arguments: making those of all
/// commands takes a millisecond, and the others are but named in the list.
CLI::App* add_sub_command(CLI::App& app, Command& command, std::string_view asked, std::map<std::string, CLI::App*>& groups) {
  const std::string name = command.name();
  const std::size_t space = name.find(' ');
  CLI::App* parent = &app;
  if (space != std::string::npos) {
    const std::string group = name.substr(0, space);
    CLI::App*& made = groups[group];
    if (!made) {
      made = app.add_subcommand(group, group == "kb" ? "the knowledge base file" : "relation and feature files");
      made->require_subcommand(1);
    }
    parent = made;
  }
  CLI::App* sub = parent->add_subcommand(space == std::string::npos ? name : name.substr(space + 1), command.summary());
  if (name.substr(0, space) != asked) return sub;
  sub->footer("Example:\n" + indented(command.example()));
  sub->set_config("--config", "", "read options from a file: lines `name = value`");
  for (const Argument& argument : command.arguments()) add_argument(*sub, argument);
  return sub;
}

int report(int code, const char* kind, const std::exception& error) {
  std::fflush(stdout);
  fmt::print(stderr, "scenelore: {}{}\n", kind, error.what());
  return code;
}

int guarded(Command& command) {
  try {
    const int code = command.run();
    if (std::fflush(stdout) != 0) {
      fmt::print(stderr, "scenelore: the output could not be written\n");
      return kInput;
    }
    return code;
  } catch (const UsageError& error) {
    return report(kUsage, "", error);
  } catch (const perception::Error& error) {
    return report(kInput, "", error);
  } catch (const evaluation::Error& error) {
    return report(kInput, "", error);
  } catch (const kb::Error& error) {
    return report(kKnowledge, "", error);
  } catch (const rules::Error& error) {
    return report(kKnowledge, "", error);
  } catch (const engine::FileError& error) {
    return report(kInput, "", error);
  } catch (const engine::Error& error) {
    return report(kKnowledge, "", error);
  } catch (const std::bad_alloc& error) {
    return report(kInternal, "out of memory: ", error);
  } catch (const std::exception& error) {
    return report(kInternal, "internal error, please report it: ", error);
  }
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App app{"Scenelore turns a 3D scan of an indoor scene into a labelled world model.", "scenelore"};
  app.set_version_flag("--version", "scenelore " SCENELORE_VERSION);
  app.require_subcommand(1);
  app.footer("Each command has --help with an example. Exit codes: 0 ok, 1 negative answer, 2 usage, 3 input unreadable,\n"
             "4 knowledge base or rule error, 5 limit reached, 70 internal.");
  std::vector<std::unique_ptr<Command>> commands = all_commands();
  std::vector<CLI::App*> subs;
  std::map<std::string, CLI::App*> groups;
  for (const auto& command : commands) subs.push_back(add_sub_command(app, *command, argc > 1 ? argv[1] : "", groups));

  if (argc == 2 && std::string_view(argv[1]) == "--documentation") {
    fmt::print("{}", documentation(commands));
    return kOk;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    app.exit(error, std::cerr, std::cerr);
    return kUsage;
  }
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (subs[i]->parsed()) return guarded(*commands[i]);
  }
  return kUsage;
}

}  // namespace scenelore::tools
