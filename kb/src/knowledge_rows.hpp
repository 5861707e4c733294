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

/// SHA-256 over values of the knowledge tables, in the order of their names and ids.
struct KnowledgeHashes {
  std::string all;
  std::string evidence;  ///< without constraints and composites, which say nothing about a plane alone
};
[[nodiscard]] KnowledgeHashes hash_knowledge(const Knowledge& knowledge);

}  // namespace scenelore::kb
