// Everything that is measured about labelled scenes, added up over any number of them.
#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/calibration.hpp"
#include "evaluation/class_score.hpp"
#include "evaluation/segmentation_score.hpp"

namespace scenelore::evaluation {

/// One class a plane, with the probability it was given.
struct Answer {
  std::vector<std::string> classes;
  std::vector<double> probabilities;
};

/// A labelled scan.
struct LabelledScan {
  std::vector<std::int32_t> plane_of_point;  ///< from 0, −1 = no plane
  Answer before;  ///< class of highest evidence and its probability
  Answer after;   ///< best world model
};

/// How many points (or planes) of a true class got which class.
using Confusion = std::map<std::pair<std::string, std::string>, std::size_t>;  // truth, answer

struct PointScore {
  std::size_t truth = 0, answer = 0, both = 0;  ///< points of the class, labelled so, and both
  [[nodiscard]] double iou() const;        ///< both / (truth + answer − both); 0 when nothing is there
  [[nodiscard]] double accuracy() const;   ///< both / truth
  [[nodiscard]] double precision() const;  ///< both / answer
};

/// What was measured of one answer (before or after constraints).
struct AnswerScore {
  std::map<std::string, ClassScore> objects;  ///< by class, without the fallback
  Confusion points;   ///< points that are known; the answer for points on no plane is the fallback class
  Confusion planes;   ///< planes that are known
  Calibration calibration;  ///< over the planes that are known
  AnswerScore& operator+=(const AnswerScore& other);
};

struct Evaluation {
  int scans = 0;
  std::size_t points = 0, known_points = 0, planes = 0, known_planes = 0;
  AnswerScore before, after;
  std::array<SegmentationScore, 2> segmentation{SegmentationScore{.threshold = 0.5}, SegmentationScore{.threshold = 0.8}};
  Evaluation& operator+=(const Evaluation& other);
};

/// Of one scan. An answer that is one of several right classes counts as the first of them. Throws Error when truth and scan
/// differ in their number of points.
[[nodiscard]] Evaluation evaluate(const LabelledScan& scan, const SceneTruth& truth, const std::string& fallback);

/// Sum over classes (all of them when the list is empty).
[[nodiscard]] ClassScore total(const std::map<std::string, ClassScore>& scores, const std::vector<std::string>& classes = {});
/// Classes that occur as truth or answer, by name.
[[nodiscard]] std::map<std::string, PointScore> point_scores(const Confusion& points);
/// Share of the points that have a right class.
[[nodiscard]] double overall_accuracy(const Confusion& points);

}  // namespace scenelore::evaluation
