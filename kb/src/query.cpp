// SQL from users: one statement that only reads, on the connection that we have.
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "implementation.hpp"

namespace scenelore::kb {

namespace {

constexpr std::array<std::string_view, 15> kReadingPragmas = {
    "application_id",    "collation_list", "compile_options", "foreign_key_check", "foreign_key_list",
    "function_list",     "index_info",     "index_list",      "index_xinfo",       "integrity_check",
    "quick_check",       "table_info",     "table_list",      "table_xinfo",       "user_version"};
constexpr std::array<std::string_view, 2> kPragmasWithoutValue = {"application_id", "user_version"};  // a value would write

template <typename List>
bool contains(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

std::string refused_pragma(const char* name, const char* value) {
  const std::string pragma = name == nullptr ? "" : name;
  if (!contains(kReadingPragmas, pragma) || (value != nullptr && contains(kPragmasWithoutValue, pragma))) {
    return "PRAGMA " + pragma + (value != nullptr ? " with a value" : "");
  }
  return "";
}

// What the statement wants to do that it must not; empty when it may.
std::string refusal(int action, const char* first, const char* second) {
  const auto on = [&](const char* what) { return std::string(what) + (first == nullptr ? "" : std::string(" ") + first); };
  switch (action) {
    case SQLITE_SELECT:
    case SQLITE_READ:
    case SQLITE_RECURSIVE: return "";
    case SQLITE_FUNCTION: return second != nullptr && std::string_view(second) == "load_extension" ? "load_extension" : "";
    case SQLITE_PRAGMA: return refused_pragma(first, second);
    case SQLITE_ATTACH: return "ATTACH";
    case SQLITE_DETACH: return "DETACH";
    case SQLITE_INSERT: return on("INSERT INTO");
    case SQLITE_UPDATE: return on("UPDATE");
    case SQLITE_DELETE: return on("DELETE FROM");
    case SQLITE_TRANSACTION:
    case SQLITE_SAVEPOINT: return on("transaction control:");
    default: return "changing the schema" + (first == nullptr ? "" : std::string(" (") + first + ")");
  }
}

// Installs authorizer and progress handler for as long as it lives.
class Guard {
 public:
  Guard(const Database& database, const QueryLimits& limits) : database_(database), limits_(limits) {
    sqlite3_set_authorizer(database.handle(), &Guard::authorize, this);
    sqlite3_progress_handler(database.handle(), 10'000, &Guard::progress, this);
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
  ~Guard() {
    sqlite3_set_authorizer(database_.handle(), nullptr, nullptr);
    sqlite3_progress_handler(database_.handle(), 0, nullptr, nullptr);
  }
  /// Turns SQLite's "not authorized" or "interrupted" into what happened.
  [[noreturn]] void explain(const Error& error) const {
    if (!refused_.empty()) {
      throw Error(database_.name() + ": " + refused_ + " is refused: a query only reads; use sqlite3 to change the file");
    }
    if (stopped_) throw Error(database_.name() + ": the query was stopped: " + stop_reason_);
    throw error;
  }

 private:
  static int authorize(void* self, int action, const char* first, const char* second, const char*, const char*) {
    auto& guard = *static_cast<Guard*>(self);
    const std::string reason = refusal(action, first, second);
    if (reason.empty()) return SQLITE_OK;
    // The first one is what the user wrote; writing pragmas and DDL bring further actions along.
    if (guard.refused_.empty()) guard.refused_ = reason;
    return SQLITE_DENY;
  }

  static int progress(void* self) {
    auto& guard = *static_cast<Guard*>(self);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - guard.start_;
    if (spent.count() > guard.limits_.seconds) {
      guard.stop_reason_ = "it took longer than the limit";
    } else if (guard.limits_.interrupt != nullptr && guard.limits_.interrupt->load()) {
      guard.stop_reason_ = "interrupted";
    } else {
      return 0;
    }
    guard.stopped_ = true;
    return 1;
  }

  const Database& database_;
  const QueryLimits& limits_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::string refused_, stop_reason_;
  bool stopped_ = false;
};

std::string hexadecimal(std::span<const std::byte> bytes) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string text;
  for (const std::byte byte : bytes) {
    text += kHex[std::to_integer<unsigned>(byte) >> 4];
    text += kHex[std::to_integer<unsigned>(byte) & 15];
  }
  return text;
}

ValueType value_type(int type) {
  switch (type) {
    case SQLITE_INTEGER: return ValueType::integer;
    case SQLITE_FLOAT: return ValueType::real;
    case SQLITE_TEXT: return ValueType::text;
    case SQLITE_BLOB: return ValueType::blob;
    default: return ValueType::null;
  }
}

QueryRow read_row(const Statement::Use& use, int columns) {
  QueryRow row;
  for (int column = 0; column < columns; ++column) {
    row.types.push_back(value_type(use.type(column)));
    const bool is_blob = row.types.back() == ValueType::blob;
    row.values.push_back(is_blob ? hexadecimal(use.blob(column)) : use.optional_text(column));
  }
  return row;
}

}  // namespace

void KnowledgeBase::query(const std::string& sql, const std::function<void(const std::vector<std::string>&)>& header,
                          const std::function<void(const QueryRow&)>& row, const QueryLimits& limits) const {
  const Database& database = implementation_->database;
  const Guard guard(database, limits);
  try {
    Statement statement = database.prepare(sql);
    if (!statement.only_reads()) throw Error(database.name() + ": a query only reads [" + sql + "]");
    std::vector<std::string> names;
    for (int column = 0; column < statement.columns(); ++column) names.push_back(statement.column_name(column));
    header(names);
    for (auto use = statement.use(); use.next();) row(read_row(use, statement.columns()));
  } catch (const Error& error) {
    guard.explain(error);
  }
}

}  // namespace scenelore::kb
