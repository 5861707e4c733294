// An evaluation in three printed forms.
#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluation.hpp"

namespace scenelore::evaluation {

struct ReportOptions {
  std::string title;                 ///< what was held against what
  std::vector<std::string> classes;  ///< rows of the table and of its sum; empty = all that occur
  bool segmentation = true;          ///< false where the truth says nothing about it (truth rows)
};

[[nodiscard]] std::string to_text(const Evaluation& evaluation, const ReportOptions& options);
[[nodiscard]] std::string to_json(const Evaluation& evaluation, const ReportOptions& options);
/// One page that needs nothing else, with plots as SVG, for light and dark screens.
[[nodiscard]] std::string to_html(const Evaluation& evaluation, const ReportOptions& options);

/// Classes of the table's rows: those of the options, or all that are there or were found, by name.
[[nodiscard]] std::vector<std::string> listed_classes(const Evaluation& evaluation, const ReportOptions& options);

}  // namespace scenelore::evaluation
