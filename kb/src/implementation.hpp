// What a KnowledgeBase owns.
#pragma once

#include <optional>

#include "knowledge_rows.hpp"
#include "scenelore/kb/knowledge_base.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {

struct KnowledgeBase::Implementation {
  Implementation(const std::filesystem::path& path, OpenMode mode) : database(path, mode) {}
  Database database;

  /// The knowledge as it was read and checked last. Thousands of rows are read once a command, not once a question.
  struct Read {
    std::int64_t version = 0;  ///< PRAGMA data_version: changes when another connection has changed the file
    Knowledge knowledge;
    std::optional<KnowledgeHashes> hashes = std::nullopt;  ///< once somebody has asked
  };
  std::optional<Read> read;  ///< whoever writes knowledge tables through this connection resets it
  const Knowledge& knowledge();  ///< read and checked when it is not at hand; until the next change
  const KnowledgeHashes& hashes();  ///< of it
};

}  // namespace scenelore::kb
