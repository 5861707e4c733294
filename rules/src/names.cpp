#include "names.hpp"

#include <charconv>

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
  throw Error("setting '" + key + "' is '" + text + "'; it must be a number from " + std::to_string(low) + " to " +
              std::to_string(high));
}

}  // namespace scenelore::rules
