// The labelled planes of a scan as text of other formats.
#pragma once

#include <string>

#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::tools {

/// The rows of the view labelled_plane, with a header line.
[[nodiscard]] std::string planes_csv(const kb::KnowledgeBase& base, const kb::Scan& scan);
/// Scan, planes with hull, features, label and reasons, and the relations between them.
[[nodiscard]] std::string planes_json(const kb::KnowledgeBase& base, const kb::Scan& scan);
/// A floor plan.
[[nodiscard]] std::string planes_svg(const kb::KnowledgeBase& base, const kb::Scan& scan);

}  // namespace scenelore::tools
