// Names that rows use, checked: classes, relations, settings; and numbers for people.
#pragma once

#include <string>
#include <vector>

#include "scenelore/kb/knowledge.hpp"

namespace scenelore::rules {

[[nodiscard]] std::vector<std::string> class_names(const kb::Knowledge& knowledge);

/// Index of a class. Throws Error "<who>: there is no class 'x'; did you mean 'y'?".
[[nodiscard]] int require_class(const kb::Knowledge& knowledge, const std::string& name, const std::string& who);

/// "constraint 'screen_over_table' (row 7)".
[[nodiscard]] std::string row_name(const kb::ClassConstraint& row);

/// A numeric setting within [low, high]. Throws Error naming it.
[[nodiscard]] double number_setting(const kb::Knowledge& knowledge, const std::string& key, double otherwise, double low,
                                    double high);

/// "3.2": with so many decimals at most, no trailing zeros.
[[nodiscard]] std::string number(double value, int decimals = 2);

}  // namespace scenelore::rules
