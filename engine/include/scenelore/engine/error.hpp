#pragma once

#include <stdexcept>

namespace scenelore::engine {

/// A problem that makes no sense, or a problem file that cannot be read; the text names variable, constraint or line.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace scenelore::engine
