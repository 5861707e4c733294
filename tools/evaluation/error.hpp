#pragma once

#include <stdexcept>

namespace scenelore::evaluation {

/// A truth file or class map that cannot be used; the text names file, object and the way out.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A cloud without labels.
class NoTruth : public Error {
 public:
  using Error::Error;
};

}  // namespace scenelore::evaluation
