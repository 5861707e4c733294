// Learning from labelled planes: densities, Gaussians and priors as rows that a person can read and edit.
//
//   LearnedRows rows = learn(base.knowledge(), {features, classes});
//   std::ofstream("office_learned.sql") << to_sql(rows);
#pragma once

#include <string>
#include <vector>

#include "scenelore/kb/evidence.hpp"
#include "scenelore/kb/knowledge.hpp"

namespace scenelore::kb {

/// What is learned from: one row of features and one class a plane. Scraps of planes belong to it where such planes will be labelled, too: they make
/// kinds of their own, and what is left out of a class is learned as what is unknown. Leave them out where a thing shows whole on one plane.
struct LabelledPlanes {
  FeatureTable features;
  std::vector<std::string> classes;  ///< one a plane; empty = not known, left out
  std::vector<double> stakes;        ///< how much the label of each plane matters to `contrast`; empty = 1 each
};

struct LearnOptions {
  int min_examples = 12;           ///< classes with fewer keep their rows
  double gaussian_strength = 12;   ///< pretended examples drawn from the Gaussian: what small n is shrunk towards
  double present_strength = 0;     ///< pretended examples distributed as the present rows of the class and feature say
  double prior_strength = 30;      ///< pretended planes distributed like the present priors
  bool priors = true;              ///< false: examples were picked, their shares mean nothing; priors stay
  int bins = 20;                   ///< at most, of each histogram
  int examples_per_kind = 12;      ///< a class gets a kind for so many, if that makes two
  int most_kinds = 10;             ///< of a class
  int most_kinds_of_fallback = 40;  ///< of the fallback class, which is everything else
  double min_of_kind = 5;          ///< examples; kinds that keep fewer are given up
  double kind_share = 0.95;        ///< of a class that has kinds; the rest is judged by its own rows, so that what is like none is not ruled out
  double outliers = 0.02;          ///< share of examples that may lie outside, half at either end, without moving the fit
};

struct LearnedClass {
  std::string object_class;
  int examples = 0;
  double prior = 0;                          ///< share of planes
  std::vector<ClassFeature> gaussians;       ///< empty when there were too few examples
  std::vector<ClassDensity> densities;
  std::vector<ClassKind> kinds;              ///< empty where there were too few examples for two
  /// Kinds stand in for all histograms of the class, but of the fallback class: its own rows speak where other classes have none.
  [[nodiscard]] bool kinds_replace_densities() const { return !kinds.empty() && densities.empty(); }
};

/// By class id; features in the knowledge's order.
struct LearnedRows {
  std::vector<LearnedClass> classes;
  std::vector<std::string> notes;  ///< a sentence per class that keeps its rows
};

/// Fits, for each class and each feature of the knowledge that counts (weight above 0) and that the table has, a Gaussian (on the feature's
/// scale, robust to outliers) and a histogram (kernel estimate, shrunk for small n: towards that Gaussian, and by present_strength
/// towards the present rows; both Gaussians then join as conjugate ones do, Murphy 2007, section 3). The fallback class is
/// learned like any other. A class with enough examples is divided into kinds (kind_fit.hpp), which replace its histograms. Deterministic; the order of planes does not matter but for rounding.
/// Throws Error for a class that the knowledge lacks, and for sizes that do not fit.
[[nodiscard]] LearnedRows learn(const Knowledge& knowledge, const LabelledPlanes& planes, const LearnOptions& options = {});

struct ContrastOptions {
  int passes = 20;      ///< over all planes
  double strength = 4;  ///< how firmly kinds hold on to what they are, in pretended planes
};

/// Moves the kinds of `rows`, how usual they are and the priors so that the labels of these planes become likelier given their features.
/// `learn` asks of each class alone what it looks like; where classes overlap, and since weights other than 1 make densities what nothing is
/// drawn from, that is not what tells them apart best. `knowledge`: what else counts, the weights of features above all; `planes` may have
/// errors of their values. Kinds need a row for each feature that counts; classes without kinds stay as they are. Deterministic, with any number
/// of threads. Throws Error for a kind that lacks a row and for stakes of another number of planes.
void contrast(const Knowledge& knowledge, const LabelledPlanes& planes, LearnedRows& rows, const ContrastOptions& options = {});

/// What fits to planes of several collections say together (bagging, Breiman 1996, of mixtures), which is more even than what each says: a class
/// has the kinds of all that have kinds for it, with equal parts of their shares, and the mean of their priors. Its other rows are those
/// of the first. All have the same classes; at least one. Throws std::out_of_range without any.
[[nodiscard]] LearnedRows mix_fits(std::vector<LearnedRows> fits);

/// The knowledge with the rows in place, as after to_sql but for rounding.
[[nodiscard]] Knowledge with_rows(Knowledge knowledge, const LearnedRows& rows);

/// Statements that put the rows in place of those of the same classes: numbers with 4 significant digits, one histogram a
/// statement, the same bytes for the same rows.
[[nodiscard]] std::string to_sql(const LearnedRows& rows);

}  // namespace scenelore::kb
