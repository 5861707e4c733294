#pragma once

#include "file_builder.hpp"
#include "file_text.hpp"

namespace scenelore::engine {

/// One a format; see problem_file.hpp.
ProblemFile read_cfn(FileText& text);
ProblemFile read_wcsp(FileText& text);
ProblemFile read_uai(FileText& text);

/// Domains of a file may not hold more labels than this together: a damaged file asks for no gigabytes.
inline constexpr long long kMostLabels = 20'000'000;

}  // namespace scenelore::engine
