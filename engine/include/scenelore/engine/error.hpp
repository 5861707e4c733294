#pragma once

#include <stdexcept>

namespace scenelore::engine {

/// A problem that makes no sense, or a problem file that cannot be read; the text names variable, constraint or line.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A problem file that cannot be opened, read or understood.
class FileError : public Error {
 public:
  using Error::Error;
};

}  // namespace scenelore::engine
