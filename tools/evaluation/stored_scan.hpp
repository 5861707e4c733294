// The answer that a knowledge base holds, in the form that is judged.
#pragma once

#include "evaluation/evaluation.hpp"
#include "scenelore/kb/inference.hpp"
#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::evaluation {

/// Classes of highest evidence, with it; classes of the best world, with their probabilities. `evidence` is [plane][class] and
/// `planes` names its rows. Of equal evidence the class with the lowest id.
[[nodiscard]] Answer answer_before(const kb::Knowledge& knowledge, const std::vector<std::vector<double>>& evidence);
[[nodiscard]] Answer answer_after(const std::vector<kb::PlaneId>& planes, const std::vector<kb::Label>& labels);

/// What is stored about a scan. Throws kb::Error when it has planes but no labels.
[[nodiscard]] LabelledScan stored_scan(const kb::KnowledgeBase& base, const kb::Scan& scan);

/// Ids of planes to their places in `planes`, −1 stays.
[[nodiscard]] std::vector<std::int32_t> places(const std::vector<std::int64_t>& plane_id_of_point, const std::vector<kb::PlaneId>& planes);

}  // namespace scenelore::evaluation
