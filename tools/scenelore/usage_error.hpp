#pragma once

#include <stdexcept>

namespace scenelore::tools {

/// Arguments that parse but make no sense together; exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace scenelore::tools
