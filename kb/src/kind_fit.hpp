// Fitting the kinds of one class.
#pragma once

#include <vector>

#include "scenelore/kb/knowledge.hpp"
#include "scenelore/kb/learn.hpp"

namespace scenelore::kb {

/// One plane: a value of each feature on its scale; NaN = not known.
using KindExample = std::vector<double>;

/// No kind is sharper in a feature than this, on its scale.
[[nodiscard]] double least_sigma(const Feature& feature);

/// Kinds of a class from its examples: a mixture of Gaussians with independent features, by expectation maximisation (Dempster, Laird,
/// Rubin 1977; starts after k-means++, Arthur & Vassilvitskii 2007, of several the likeliest), as many kinds as there are
/// options.examples_per_kind, at most `most`; kinds that keep less than options.min_of_kind examples are given up, so that a
/// wrong label makes none. Variances are shrunk towards the class's own as if four more examples had said so (a tenth of it). No sigma below
/// a 200th of the feature's range. Fewer than two kinds: empty, the class's own rows say as much.
/// `present`, if not empty and options.present_strength > 0: the kinds that the class has, whose Gaussians stand for so many examples each, and
/// their shares for so many in all; they are moved, not replaced. Shares add up to options.kind_share.
/// The order of the examples does not matter.
[[nodiscard]] std::vector<ClassKind> fit_kinds(const std::string& object_class, std::vector<KindExample> examples,
                                               const std::vector<const Feature*>& features, const std::vector<ClassKind>& present, int most,
                                               const LearnOptions& options);

}  // namespace scenelore::kb
