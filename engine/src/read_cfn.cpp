// toulbar2's .cfn: a JSON object with "problem", "variables" and "functions", in this order.
#include <algorithm>
#include <cmath>
#include <map>

#include "file_reader.hpp"

namespace scenelore::engine {
namespace {

class CfnReader {
 public:
  explicit CfnReader(FileText& text) : text_(text) {}

  ProblemFile read() {
    text_.expect("{");
    bool has_variables = false;
    each_field([&](const std::string& field) {
      if (field == "problem")
        header();
      else if (field == "variables")
        has_variables = true, variables();
      else if (field == "functions" && has_variables)
        functions();
      else if (field == "functions")
        text_.fail("'variables' must come before 'functions'");
      else
        text_.fail("'problem', 'variables' or 'functions' is expected, not '" + field + "'");
    });
    if (!text_.at_end()) text_.fail("the file goes on after its last brace");
    if (!has_variables) text_.fail("'variables' is missing");
    ProblemFile file = builder_.finish();
    file.maximised = sign_ < 0;
    return file;
  }

 private:
  /// Fields up to the closing brace; the opening one has been read.
  void each_field(const auto& visit) {
    while (!text_.accept("}")) {
      const std::string field(text_.next());
      text_.expect(":");
      visit(field);
      text_.accept(",");
    }
  }
  /// Items up to the closing bracket; the opening one has been read.
  void each_item(const auto& visit) {
    while (!text_.accept("]")) {
      visit();
      text_.accept(",");
    }
  }

  void header() {
    text_.expect("{");
    each_field([&](const std::string& field) {
      const std::string value(text_.next());
      if (field != "mustbe") return;
      if (value.empty() || (value[0] != '<' && value[0] != '>'))
        text_.fail("'mustbe' is '" + value + "'; it must be \"<cost\" or \">value\"");
      sign_ = value[0] == '<' ? 1 : -1;
      FileText rest(value.substr(1), "mustbe", "", false);
      builder_.set_top(sign_ * rest.number("a number"));
    });
  }

  void variables() {
    text_.expect("{");
    long long all = 0;
    each_field([&](const std::string& name) {
      std::vector<std::string> labels;
      if (text_.accept("[")) {
        each_item([&] { labels.emplace_back(text_.next()); });
      } else {
        const long long size = text_.integer("a list of labels or their number (from 1)", 1, kMostLabels - all);
        for (long long l = 0; l < size; ++l) labels.push_back("v" + std::to_string(l));
      }
      if (labels.empty()) text_.fail("variable '" + name + "' has no label");
      all += static_cast<long long>(labels.size());
      if (!variable_.try_emplace(name, builder_.variables()).second)
        text_.fail("there are two variables '" + name + "'");
      auto& numbers = label_.emplace_back();
      for (std::size_t l = 0; l < labels.size(); ++l)
        if (!numbers.try_emplace(labels[l], static_cast<int>(l)).second)
          text_.fail("variable '" + name + "' has two labels '" + labels[l] + "'");
      builder_.add_variable(name, std::move(labels));
    });
  }

  void functions() {
    text_.expect("{");
    each_field([&](const std::string& name) { function(name); });
  }

  struct Function {
    std::vector<int> scope;
    bool sparse = false;
    double other = 0;
  };

  void function(const std::string& name) {
    text_.expect("{");
    Function function;
    bool has_scope = false, has_costs = false;
    each_field([&](const std::string& field) {
      if (field == "scope") {
        has_scope = true;
        scope(name, function);
      } else if (field == "defaultcost") {
        function.sparse = true;
        function.other = text_.number("the default cost");
      } else if (field == "costs") {
        if (!has_scope) text_.fail("function '" + name + "': 'scope' must come before 'costs'");
        has_costs = true;
        costs(name, function);
      } else if (field == "type") {
        text_.fail("function '" + name + "': the global cost function '" + std::string(text_.peek()) +
                   "' is not supported; write it as a table");
      } else {
        text_.fail("function '" + name + "': unknown field '" + field + "'");
      }
    });
    if (!has_costs) text_.fail("function '" + name + "' has no costs");
  }

  void scope(const std::string& name, Function& function) {
    text_.expect("[");
    each_item([&] {
      const bool quoted = text_.peek_is_quoted();
      const auto found = variable_.find(std::string(text_.peek()));
      if (found != variable_.end()) {
        function.scope.push_back(found->second);
        text_.next();
      } else if (quoted) {
        text_.fail("function '" + name + "': there is no variable '" + std::string(text_.peek()) + "'");
      } else {
        function.scope.push_back(static_cast<int>(text_.integer("a variable", 0, builder_.variables() - 1)));
      }
      const auto& seen = function.scope;
      if (std::find(seen.begin(), seen.end() - 1, seen.back()) != seen.end() - 1)
        text_.fail("function '" + name + "' names a variable twice");
    });
    if (builder_.tuples(function.scope) > FileBuilder::kMostTuples)
      text_.fail("function '" + name + "' has too many tuples");
  }

  /// A list of costs, or the name of a function that has one: that list is then read once more.
  void costs(const std::string& name, const Function& function) {
    if (!text_.peek_is_quoted() && text_.peek() == "[") {
      lists_[name] = {text_.here(), function};
      return builder_.add_function(name, function.scope, list(name, function));
    }
    const std::string other(text_.next());
    const auto found = lists_.find(other);
    if (found == lists_.end()) text_.fail("function '" + name + "': there is no function '" + other + "' to share costs of");
    const auto& [place, theirs] = found->second;
    if (builder_.tuples(theirs.scope) != builder_.tuples(function.scope))
      text_.fail("function '" + name + "' and '" + other + "' have different sizes");
    const std::size_t after = text_.end_of_last();
    text_.go_to(place);
    std::vector<double> table = list(other, theirs);
    text_.go_to(after);
    builder_.add_function(name, function.scope, std::move(table));
  }

  std::vector<double> list(const std::string& name, const Function& function) {
    const std::size_t size = builder_.tuples(function.scope);
    text_.expect("[");
    std::vector<double> table(function.sparse ? size : 0, function.other);
    if (!function.sparse) table.reserve(size);
    each_item([&] {
      if (function.sparse)
        tuple(function, table);
      else
        table.push_back(text_.number("a cost"));
      if (table.size() > size) text_.fail("function '" + name + "' has more costs than tuples");
    });
    if (table.size() != size)
      text_.fail("function '" + name + "' has " + std::to_string(table.size()) + " costs for " + std::to_string(size) +
                 " tuples");
    for (double& cost : table) cost *= sign_;
    return table;
  }

  void tuple(const Function& function, std::vector<double>& table) {
    std::size_t place = 0;
    for (const int v : function.scope) {
      const auto& numbers = label_[static_cast<std::size_t>(v)];
      const auto found = text_.peek_is_quoted() ? numbers.find(std::string(text_.peek())) : numbers.end();
      long long label = 0;
      if (found != numbers.end()) {
        label = found->second;
        text_.next();
      } else {
        label = text_.integer("a label of a tuple", 0, static_cast<long long>(numbers.size()) - 1);
      }
      place = place * numbers.size() + static_cast<std::size_t>(label);
      text_.accept(",");
    }
    table[place] = text_.number("the cost of a tuple");
  }

  FileText& text_;
  FileBuilder builder_;
  double sign_ = 1;
  std::map<std::string, int> variable_;
  std::vector<std::map<std::string, int>> label_;
  std::map<std::string, std::pair<std::size_t, Function>> lists_;  ///< by function: where its list of costs is
};

}  // namespace

ProblemFile read_cfn(FileText& text) { return CfnReader(text).read(); }

}  // namespace scenelore::engine
