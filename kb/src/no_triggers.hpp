// What is kept in one piece beside its rows is void once anybody changes those rows; triggers see to that.
#pragma once

#include <sqlite3.h>

#include "sqlite.hpp"

namespace scenelore::kb {

/// While it lives, this connection's own writing fires no triggers.
class NoTriggers {
 public:
  explicit NoTriggers(Database& database) : database_(database) { enable(0); }
  NoTriggers(const NoTriggers&) = delete;
  NoTriggers& operator=(const NoTriggers&) = delete;
  ~NoTriggers() { enable(1); }

 private:
  void enable(int on) const { sqlite3_db_config(database_.handle(), SQLITE_DBCONFIG_ENABLE_TRIGGER, on, nullptr); }
  Database& database_;
};

}  // namespace scenelore::kb
