#pragma once

#include <span>

#include "evaluation/calibration.hpp"
#include "scenelore/kb/knowledge.hpp"

namespace scenelore::learning {

/// Scale under which the claims are most likely (logistic regression on their logits by Newton's method), held to slope 1 and offset 0
/// as `strength` claims would; slope stays between 0.1 and 9. Probabilities of 0 and 1 are left out.
[[nodiscard]] kb::ProbabilityScale fit_scale(std::span<const evaluation::Claim> claims, double strength = 20);

}  // namespace scenelore::learning
