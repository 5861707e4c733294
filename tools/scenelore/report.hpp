// What `run` and `label` print: one line a labelled object, or the same as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::tools {

/// One reason with all its numbers.
[[nodiscard]] nlohmann::ordered_json reason_json(const kb::Reason& reason);

/// One scan's answer, ready to print.
struct Report {
  std::string file;  ///< knowledge base
  kb::Scan scan;
  kb::Inference inference;
  std::vector<std::string> warnings;
  std::vector<std::string> written;  ///< further files
  std::vector<kb::Label> before;     ///< labels of the run before; empty = there was none
  std::vector<kb::PlaneId> corrected;  ///< planes that a person has named since then
};

/// A label that is another one now, with the reason that matters most.
struct LabelChange {
  kb::PlaneId plane = 0;
  std::string was, is, reason;
};
[[nodiscard]] std::vector<LabelChange> changes(const Report& report);

/// The planes of a scan with a truth row that the stored answer does not know of yet.
[[nodiscard]] std::vector<kb::PlaneId> new_corrections(const kb::KnowledgeBase& base, const kb::Scan& scan);

/// What was corrected and what else changed; nothing when there was no answer before.
void print_changes(const Report& report);

/// `fallback` is the class that is only counted in the text form, not listed.
void print_text(const Report& report, const std::string& fallback);
/// One JSON array with an object a report.
void print_json(const std::vector<Report>& reports);

/// kOk, kNegative without planes or without a world model, kLimit when the search was cut short.
[[nodiscard]] int exit_code(const Report& report);

}  // namespace scenelore::tools
