// `scenelore query`: one reading SQL statement over the knowledge base, as a table, JSON or CSV.
#include <fmt/core.h>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "result_table.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

class QueryCommand : public Command {
 public:
  std::string name() const override { return "query"; }
  std::string summary() const override { return "Ask a knowledge base in SQL; reading only."; }
  std::string example() const override {
    return "scenelore query office.gpkg \"SELECT a, b FROM labelled_relation WHERE relation = 'above' AND a_class = "
           "'flat_screen' AND b_class = 'table'\"";
  }
  std::vector<Argument> arguments() override {
    return {positional("FILE", &file_, "FILE", "knowledge base file"),
            positional("SQL", &sql_, "SQL", "one statement; the views are labelled_plane, labelled_relation, class_count, needs_review"),
            json_argument(json_),
            {"--csv", &csv_, "", "print comma-separated values"}};
  }

  int run() override {
    if (json_ && csv_) throw UsageError("--json and --csv exclude each other");
    const kb::KnowledgeBase base = kb::KnowledgeBase::open(file_, kb::Access::read_only);
    const ResultTable table = run_query(base, sql_);
    fmt::print("{}", json_ ? to_json(table) : csv_ ? to_csv(table) : to_text(table));
    return kOk;
  }

 private:
  std::string file_;
  std::string sql_;
  bool json_ = false;
  bool csv_ = false;
};

}  // namespace

std::unique_ptr<Command> query_command() { return std::make_unique<QueryCommand>(); }

}  // namespace scenelore::tools
