#include "sqlite.hpp"

#include <sqlite3.h>

#include <algorithm>

namespace scenelore::kb {

namespace {

constexpr int kBusyMilliseconds = 5000;   // another program's transaction is waited for this long
constexpr std::size_t kSqlInError = 400;  // characters of a statement shown in an error

// What the user can do about it; empty where SQLite's own words suffice.
std::string advice(int code) {
  switch (code & 0xff) {
    case SQLITE_READONLY: return "; the file or its folder is read-only: copy it to where you may write";
    case SQLITE_CANTOPEN: return "; the file or its folder cannot be opened or written";
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return "; another program is using the file: close it there and try again";
    case SQLITE_FULL: return "; the disk is full, the file is as it was before";
    case SQLITE_CORRUPT: return "; the file is damaged or cut short: restore a copy, or save what is left with sqlite3 FILE .recover";
    case SQLITE_NOTADB: return "; this is no SQLite file, so no knowledge base";
    default: return "";
  }
}

std::string shortened(std::string sql) {
  if (sql.size() > kSqlInError) sql = sql.substr(0, kSqlInError) + " …";
  return sql;
}

// The file name as a URI, with every character that a URI gives a meaning escaped.
std::string immutable_uri(const std::string& name) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : name) {
    if (c == '%' || c == '?' || c == '#') {
      const auto byte = static_cast<unsigned char>(c);
      uri += {'%', kHex[byte >> 4], kHex[byte & 15]};
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

int flags_of(OpenMode mode) {
  switch (mode) {
    case OpenMode::read_only: return SQLITE_OPEN_READONLY;
    case OpenMode::immutable: return SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
    case OpenMode::read_write: return SQLITE_OPEN_READWRITE;
    case OpenMode::create: return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  }
  return 0;
}

bool blank(std::string_view text) { return text.find_first_not_of(" \t\r\n;") == std::string_view::npos; }

}  // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

int Statement::columns() const { return sqlite3_column_count(statement_.get()); }

std::string Statement::column_name(int column) const { return sqlite3_column_name(statement_.get(), column); }

bool Statement::only_reads() const { return sqlite3_stmt_readonly(statement_.get()) != 0; }

Statement::Use::~Use() {
  if (statement_ == nullptr) return;
  sqlite3_reset(statement_->statement_.get());
  sqlite3_clear_bindings(statement_->statement_.get());
}

void Statement::Use::check(int code) const {
  if (code == SQLITE_OK || code == SQLITE_ROW || code == SQLITE_DONE) return;
  char* const expanded = sqlite3_expanded_sql(statement_->statement_.get());
  const std::string sql = expanded != nullptr ? expanded : sqlite3_sql(statement_->statement_.get());
  sqlite3_free(expanded);
  statement_->database_->fail(code, sql);
}

Statement::Use& Statement::Use::operator()(std::int64_t value) {
  check(sqlite3_bind_int64(statement_->statement_.get(), ++bound_, value));
  return *this;
}

Statement::Use& Statement::Use::operator()(double value) {
  check(sqlite3_bind_double(statement_->statement_.get(), ++bound_, value));
  return *this;
}

Statement::Use& Statement::Use::operator()(std::string_view value) {
  check(sqlite3_bind_text64(statement_->statement_.get(), ++bound_, value.data() == nullptr ? "" : value.data(),
                            value.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
  return *this;
}

Statement::Use& Statement::Use::operator()(std::span<const std::byte> value) {
  sqlite3_stmt* const statement = statement_->statement_.get();
  ++bound_;
  // A null pointer would bind NULL instead of a blob without bytes.
  check(value.empty() ? sqlite3_bind_zeroblob(statement, bound_, 0)
                      : sqlite3_bind_blob64(statement, bound_, value.data(), value.size(), SQLITE_STATIC));
  return *this;
}

Statement::Use& Statement::Use::operator()(std::nullopt_t) {
  check(sqlite3_bind_null(statement_->statement_.get(), ++bound_));
  return *this;
}

bool Statement::Use::next() {
  const int code = sqlite3_step(statement_->statement_.get());
  check(code);
  return code == SQLITE_ROW;
}

void Statement::Use::run() {
  while (next()) {
  }
  sqlite3_reset(statement_->statement_.get());
  bound_ = 0;
}

bool Statement::Use::is_null(int column) const { return type(column) == SQLITE_NULL; }
int Statement::Use::type(int column) const { return sqlite3_column_type(statement_->statement_.get(), column); }

std::int64_t Statement::Use::integer(int column) const {
  return sqlite3_column_int64(statement_->statement_.get(), column);
}

double Statement::Use::real(int column) const {
  return sqlite3_column_double(statement_->statement_.get(), column);
}

std::string_view Statement::Use::view(int column) const {
  const auto* const bytes = sqlite3_column_text(statement_->statement_.get(), column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_->statement_.get(), column));
  return bytes == nullptr ? std::string_view() : std::string_view(reinterpret_cast<const char*>(bytes), size);
}

std::string Statement::Use::text(int column) const { return std::string(view(column)); }

std::span<const std::byte> Statement::Use::blob(int column) const {
  const auto* const bytes = static_cast<const std::byte*>(sqlite3_column_blob(statement_->statement_.get(), column));
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_->statement_.get(), column))};
}

std::optional<std::string> Statement::Use::optional_text(int column) const {
  return is_null(column) ? std::nullopt : std::optional(text(column));
}

std::optional<double> Statement::Use::optional_real(int column) const {
  return is_null(column) ? std::nullopt : std::optional(real(column));
}

Database::Database(const std::filesystem::path& path, OpenMode mode) : name_(path.string()) {
  const std::string target = mode == OpenMode::immutable ? immutable_uri(name_) : name_;
  // One thread at a time uses a database, so SQLite need not lock at every column it reads.
  const int code = sqlite3_open_v2(target.c_str(), &handle_, flags_of(mode) | SQLITE_OPEN_NOMUTEX, nullptr);
  try {
    if (code != SQLITE_OK) fail(code, "");
    sqlite3_extended_result_codes(handle_, 1);
    sqlite3_busy_timeout(handle_, kBusyMilliseconds);
    sqlite3_db_config(handle_, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0, nullptr);
    sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle_, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);  // "name" is a column, never a string
    execute("PRAGMA foreign_keys = ON");
    execute("PRAGMA secure_delete = OFF");  // Debian's default wipes deleted rows; nothing here is a secret
  } catch (...) {
    sqlite3_close_v2(handle_);
    throw;
  }
}

Database::~Database() { sqlite3_close_v2(handle_); }

void Database::fail(int code, std::string_view sql) const {
  std::string message = name_ + ": " + (handle_ != nullptr ? sqlite3_errmsg(handle_) : sqlite3_errstr(code)) + advice(code);
  if (!sql.empty()) message += " [" + shortened(std::string(sql)) + "]";
  throw Error(message);
}

void Database::execute(std::string_view sql) {
  while (!blank(sql)) {
    std::string_view rest;
    Statement statement = prepare(sql, &rest);
    // What is left may be a comment alone, which prepares to nothing.
    if (statement.statement_ != nullptr) statement.use().run();
    sql = rest;
  }
}

Statement Database::prepare(std::string_view sql, std::string_view* rest) const {
  sqlite3_stmt* statement = nullptr;
  const char* tail = nullptr;
  const int code = sqlite3_prepare_v2(handle_, sql.data(), static_cast<int>(sql.size()), &statement, &tail);
  if (code != SQLITE_OK) fail(code, sql);
  Statement result(*this, statement);
  const std::string_view remaining = sql.substr(static_cast<std::size_t>(tail - sql.data()));
  if (rest != nullptr) {
    *rest = remaining;
  } else if (statement == nullptr || !blank(remaining)) {
    throw Error(name_ + ": " + (statement == nullptr ? "no SQL statement in" : "one SQL statement at a time") + " [" +
                shortened(std::string(sql)) + "]");
  }
  return result;
}

std::int64_t Database::last_id() const { return sqlite3_last_insert_rowid(handle_); }

bool Database::read_only() const { return sqlite3_db_readonly(handle_, "main") == 1; }

Transaction::Transaction(Database& database) : database_(&database) {
  if (database.read_only()) {
    throw Error(database.name() + ": cannot be written; the file or its folder is read-only: copy it to where you may write");
  }
  database.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (database_ == nullptr) return;
  // A failed commit or a full disk may have rolled back already; then there is nothing to do.
  if (sqlite3_get_autocommit(database_->handle()) == 0) sqlite3_exec(database_->handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_->execute("COMMIT");
  database_ = nullptr;
}

}  // namespace scenelore::kb
