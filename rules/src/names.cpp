#include "names.hpp"

#include <charconv>
#include <cmath>

#include "scenelore/rules/error.hpp"
#include "suggestion.hpp"

namespace scenelore::rules {

std::vector<std::string> class_names(const kb::Knowledge& knowledge) {
  std::vector<std::string> names;
  for (const kb::ObjectClass& object_class : knowledge.classes) names.push_back(object_class.name);
  return names;
}

int require_class(const kb::Knowledge& knowledge, const std::string& name, const std::string& who) {
  const int index = knowledge.class_index(name);
  if (index >= 0) return index;
  throw Error(who + ": there is no class '" + name + "'" + did_you_mean(name, class_names(knowledge)));
}

std::string row_name(const kb::ClassConstraint& row) {
  return "constraint '" + row.name + "' (row " + std::to_string(row.id) + ")";
}

double number_setting(const kb::Knowledge& knowledge, const std::string& key, double otherwise, double low, double high) {
  const std::string text = knowledge.setting(key, "");
  if (text.empty()) return otherwise;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value >= low && value <= high) return value;
  throw Error("setting '" + key + "' is '" + text + "'; it must be a number from " + number(low) + " to " + number(high));
}

std::string number(double value, int decimals) {
  if (std::isinf(value)) return value > 0 ? "infinite" : "-infinite";
  if (std::isnan(value)) return "nan";
  char text[400];  // the largest number has 309 digits before the point
  const std::to_chars_result end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
  std::string_view out(text, static_cast<std::size_t>(end.ptr - text));
  if (decimals > 0) {
    out = out.substr(0, out.find_last_not_of('0') + 1);
    if (out.back() == '.') out.remove_suffix(1);
  }
  return std::string(out == "-0" ? "0" : out);
}

}  // namespace scenelore::rules
