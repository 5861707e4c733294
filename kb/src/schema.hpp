// The schema of the knowledge base file: making it, checking its version, bringing older files up to date. The SQL is
// schemas/*.sql, compiled in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sqlite.hpp"

namespace scenelore::kb {

inline constexpr int kSchemaVersion = 13;  ///< the highest number of schemas/<number>_*.sql

/// Fills an empty database. Throws Error for an unknown pack, naming the known ones.
void create_schema(Database& database, const std::string& pack);

/// Packs that add to a knowledge base, by name: schemas/knowledge/add/*.sql.
std::vector<std::string> added_packs();
/// Throws Error naming the packs there are.
std::string_view added_pack(const std::string& name);

/// Refuses what is no knowledge base, what is damaged, and what is too new. Returns the file's schema version, which is
/// above kSchemaVersion only for a newer file that this program may still read.
int check_schema(const Database& database);

/// Brings a file of version `from` up to date, in one transaction.
void migrate_schema(Database& database, int from);

}  // namespace scenelore::kb
