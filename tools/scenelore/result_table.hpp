// The answer of a query, and its three printed forms.
#pragma once

#include <string>
#include <vector>

#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::tools {

struct ResultTable {
  std::vector<std::string> header;
  std::vector<kb::QueryRow> rows;
};

[[nodiscard]] ResultTable run_query(const kb::KnowledgeBase& base, const std::string& sql);

[[nodiscard]] std::string to_text(const ResultTable& table);  ///< columns aligned, numbers to the right
[[nodiscard]] std::string to_csv(const ResultTable& table);   ///< RFC 4180 with a header record; NULL is an empty field
[[nodiscard]] std::string to_json(const ResultTable& table);  ///< an array with one object a row

}  // namespace scenelore::tools
