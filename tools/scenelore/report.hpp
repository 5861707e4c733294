// What `run` and `label` print: one line a labelled object, or the same as JSON.
#pragma once

#include <string>
#include <vector>

#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::tools {

/// One scan's answer, ready to print.
struct Report {
  std::string file;  ///< knowledge base
  kb::Scan scan;
  kb::Inference inference;
  std::vector<std::string> warnings;
  std::vector<std::string> written;  ///< further files
};

/// `fallback` is the class that is only counted in the text form, not listed.
void print_text(const Report& report, const std::string& fallback);
/// One JSON array with an object a report.
void print_json(const std::vector<Report>& reports);

/// kOk, kNegative without planes or without a world model, kLimit when the search was cut short.
[[nodiscard]] int exit_code(const Report& report);

}  // namespace scenelore::tools
