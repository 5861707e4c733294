#pragma once

#include <stdexcept>

namespace scenelore::perception {

/// Wrong input to this module; the text names file, object and the way out, in the user's words.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace scenelore::perception
