// Relation facts: rows, and what they were found from.
#pragma once

#include "scenelore/kb/inference.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {

/// Makes the rows of relation_fact and relation_asked those of the inference; the ones of relations whose inputs are the
/// same as before are left alone.
void replace_facts(Database& database, ScanId scan, const Inference& inference);

/// Both are written only where they have changed; empty leaves what is there.
void replace_rule_answers(Database& database, ScanId scan, const Inference& inference);
void replace_geometry(Database& database, ScanId scan, const StoredGeometry& geometry);

}  // namespace scenelore::kb
