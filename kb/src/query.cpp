// SQL from users: one statement that only reads, on the connection that we have.
#include <sqlite3.h>

#include "guard.hpp"
#include "implementation.hpp"

namespace scenelore::kb {

namespace {

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
  const Guard guard(database, Permission::read, limits);
  try {
    Statement statement = database.prepare(sql);
    if (!statement.only_reads()) throw Error(database.name() + ": is refused, since a query only reads: " + sql);
    std::vector<std::string> names;
    for (int column = 0; column < statement.columns(); ++column) names.push_back(statement.column_name(column));
    header(names);
    for (auto use = statement.use(); use.next();) row(read_row(use, statement.columns()));
  } catch (const Error& error) {
    guard.explain(error);
  }
}

}  // namespace scenelore::kb
