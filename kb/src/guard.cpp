#include "guard.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace scenelore::kb {

namespace {

constexpr std::array<std::string_view, 16> kReadingPragmas = {
    "application_id",    "collation_list", "compile_options", "data_version",      "foreign_key_check", "foreign_key_list",
    "function_list",     "index_info",     "index_list",      "index_xinfo",       "integrity_check",
    "quick_check",       "table_info",     "table_list",      "table_xinfo",       "user_version"};
constexpr std::array<std::string_view, 11> kKnowledgeTables = {
    "class_constraint", "class_density", "class_feature", "class_kind", "composite", "composite_part", "feature", "kind_feature", "object_class",
    "setting", "truth"};
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

bool writes(int action) { return action == SQLITE_INSERT || action == SQLITE_UPDATE || action == SQLITE_DELETE; }

// What the statement wants to do that a query must not; empty when it may.
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

}  // namespace

Guard::Guard(const Database& database, Permission permission, const QueryLimits& limits)
    : database_(database), permission_(permission), limits_(limits) {
  sqlite3_set_authorizer(database.handle(), &Guard::authorize, this);
  sqlite3_progress_handler(database.handle(), 10'000, &Guard::progress, this);
}

Guard::~Guard() {
  sqlite3_set_authorizer(database_.handle(), nullptr, nullptr);
  sqlite3_progress_handler(database_.handle(), 0, nullptr, nullptr);
}

void Guard::explain(const Error& error) const {
  if (!refused_.empty()) {
    throw Error(database_.name() + ": " + refused_ + " is refused: " +
                (permission_ == Permission::read ? "a query only reads; use sqlite3 to change the file"
                                                 : "knowledge may change knowledge tables only"));
  }
  if (!stopped_.empty()) throw Error(database_.name() + ": the query was stopped: " + stopped_);
  throw error;
}

int Guard::authorize(void* self, int action, const char* first, const char* second, const char*, const char* trigger) {
  auto& guard = *static_cast<Guard*>(self);
  const std::string reason = refusal(action, first, second);
  // Table-valued functions (json_each, pragma_table_info) announce themselves so; a statement that really changes the
  // schema also asks for that by name, and only reads in neither case.
  const std::string_view table = first == nullptr ? "" : first;
  const bool declares = writes(action) && (table == "sqlite_master" || table == "sqlite_temp_master");
  if (reason.empty() || declares) return SQLITE_OK;
  // What follows from an allowed change (foreign keys, triggers) is allowed: it names the trigger, or happens unasked.
  const bool knowledge = writes(action) && (trigger != nullptr || contains(kKnowledgeTables, first));
  if (guard.permission_ == Permission::knowledge && knowledge) return SQLITE_OK;
  // The first refusal is what the user wrote; writing pragmas and DDL bring further actions along.
  if (guard.refused_.empty()) guard.refused_ = reason;
  return SQLITE_DENY;
}

int Guard::progress(void* self) {
  auto& guard = *static_cast<Guard*>(self);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - guard.start_;
  if (spent.count() > guard.limits_.seconds) guard.stopped_ = "it took longer than the limit";
  if (guard.limits_.interrupt != nullptr && guard.limits_.interrupt->load()) guard.stopped_ = "interrupted";
  return guard.stopped_.empty() ? 0 : 1;
}

}  // namespace scenelore::kb
