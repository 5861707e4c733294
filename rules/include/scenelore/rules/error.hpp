#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace scenelore::rules {

/// Wrong input to this module; the text names file, object and the way out, in the user's words.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  Error(const std::string& text, std::string traceback) : std::runtime_error(text), traceback_(std::move(traceback)) {}

  /// For an error inside a rule file: the calls that led there, innermost first, a line each; else empty.
  [[nodiscard]] const std::string& traceback() const { return traceback_; }

 private:
  std::string traceback_;
};

}  // namespace scenelore::rules
