// What a KnowledgeBase owns.
#pragma once

#include "scenelore/kb/knowledge_base.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {

struct KnowledgeBase::Implementation {
  Implementation(const std::filesystem::path& path, OpenMode mode) : database(path, mode) {}
  Database database;
};

}  // namespace scenelore::kb
