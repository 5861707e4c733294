// What SQL from users may do, and for how long.
#pragma once

#include <chrono>
#include <string>

#include "scenelore/kb/knowledge_base.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {

enum class Permission {
  read,       ///< SELECT and harmless pragmas
  knowledge   ///< besides, INSERT, UPDATE and DELETE in the tables that people edit
};

/// Installs an authorizer and a progress handler on a connection for as long as it lives.
class Guard {
 public:
  Guard(const Database& database, Permission permission, const QueryLimits& limits = {});
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
  ~Guard();
  /// Throws `error`, with SQLite's "not authorized" or "interrupted" turned into what happened.
  [[noreturn]] void explain(const Error& error) const;

 private:
  static int authorize(void* self, int action, const char* first, const char* second, const char* schema, const char* trigger);
  static int progress(void* self);

  const Database& database_;
  Permission permission_;
  QueryLimits limits_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::string refused_, stopped_;  // why; empty = not
};

}  // namespace scenelore::kb
