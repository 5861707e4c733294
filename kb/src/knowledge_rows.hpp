// The knowledge tables as values, checked, and their hash.
#pragma once

#include <string>

#include "scenelore/kb/knowledge.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {

[[nodiscard]] Knowledge read_knowledge(const Database& database);

/// Throws Error naming file, table, row and rule for knowledge that makes no sense. The tables' CHECKs and foreign keys
/// refuse most of it already, but a person's connection may have foreign keys off.
void validate(const Knowledge& knowledge, const std::string& file_name);

/// SHA-256 over every value of the knowledge tables, in the order of their names and ids.
[[nodiscard]] std::string hash_knowledge(const Knowledge& knowledge);

}  // namespace scenelore::kb
