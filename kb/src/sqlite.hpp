// A thin RAII layer over the SQLite C API: database, statement, its short-lived use, transaction. Private to kb.
//
//   Database db("office.gpkg", OpenMode::read_write);
//   Statement insert = db.prepare("INSERT INTO truth (plane_id, class) VALUES (?, ?)");
//   Transaction transaction(db);
//   insert.use()(17)("table").run();
//   transaction.commit();
//
// Every failure throws Error with the file's name, SQLite's message, the way out where there is one, and the SQL with
// its values filled in. Destructors never throw.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scenelore/kb/error.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace scenelore::kb {

enum class OpenMode {
  read_only,
  immutable,   ///< read-only, no locks and no journal: for a file at rest where nothing can be written beside it
  read_write,  ///< falls back to reading where the file cannot be written; see Database::read_only
  create
};

class Database;

/// A prepared statement. Must not outlive its database.
class Statement {
 public:
  /// One execution: binds values in order, steps, and resets the statement when it goes out of scope.
  class Use {
   public:
    explicit Use(Statement& statement) : statement_(&statement) {}
    Use(Use&& other) noexcept : statement_(other.statement_), bound_(other.bound_) { other.statement_ = nullptr; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    Use& operator=(Use&&) = delete;
    ~Use();

    Use& operator()(std::int64_t value);
    Use& operator()(int value) { return (*this)(static_cast<std::int64_t>(value)); }
    Use& operator()(double value);  ///< NaN becomes NULL
    Use& operator()(std::string_view value);
    Use& operator()(const char* value) { return (*this)(std::string_view(value)); }
    Use& operator()(const std::string& value) { return (*this)(std::string_view(value)); }
    Use& operator()(std::span<const std::byte> value);  ///< must outlive the use
    Use& operator()(std::nullopt_t);
    template <typename T>
    Use& operator()(const std::optional<T>& value) {
      return value ? (*this)(*value) : (*this)(std::nullopt);
    }

    bool next();  ///< true: there is a row
    void run();   ///< to the end, ignoring rows; may then be bound and run again

    // Columns of the present row, from 0. The view of blob() lives until the next call of next().
    [[nodiscard]] bool is_null(int column) const;
    [[nodiscard]] std::int64_t integer(int column) const;
    [[nodiscard]] double real(int column) const;
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] std::string_view view(int column) const;  ///< the same, only until the next row
    [[nodiscard]] std::span<const std::byte> blob(int column) const;
    [[nodiscard]] int type(int column) const;  ///< SQLITE_INTEGER, …
    [[nodiscard]] std::optional<std::string> optional_text(int column) const;
    [[nodiscard]] std::optional<double> optional_real(int column) const;

   private:
    void check(int code) const;
    Statement* statement_;
    int bound_ = 0;
  };

  Use use() { return Use(*this); }
  [[nodiscard]] int columns() const;
  [[nodiscard]] std::string column_name(int column) const;
  [[nodiscard]] bool only_reads() const;

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  Statement(const Database& database, sqlite3_stmt* statement) : database_(&database), statement_(statement) {}
  const Database* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// A connection with foreign keys on. Not safe for concurrent use.
class Database {
 public:
  Database(const std::filesystem::path& path, OpenMode mode);
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database();

  void execute(std::string_view sql);  ///< any number of statements, rows ignored
  /// One statement; `rest` gets what follows it, else anything but white space after it is an error.
  [[nodiscard]] Statement prepare(std::string_view sql, std::string_view* rest = nullptr) const;
  [[nodiscard]] std::int64_t last_id() const;
  [[nodiscard]] bool read_only() const;
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] sqlite3* handle() const { return handle_; }
  [[noreturn]] void fail(int code, std::string_view sql) const;

 private:
  std::string name_;
  sqlite3* handle_ = nullptr;
};

/// Takes the write lock at once; rolls back unless committed.
class Transaction {
 public:
  explicit Transaction(Database& database);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  Database* database_;
};

}  // namespace scenelore::kb
