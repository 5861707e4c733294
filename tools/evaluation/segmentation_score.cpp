#include "evaluation/segmentation_score.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace scenelore::evaluation {

namespace {

/// How many points planes and faces have and share.
struct Overlaps {
  std::map<std::int32_t, double> plane, face;
  std::map<std::pair<std::int32_t, std::int32_t>, double> both;  // plane, face

  Overlaps(const SceneTruth& truth, const std::vector<std::int32_t>& plane_of_point) {
    std::map<std::int32_t, double> not_known;
    for (std::size_t i = 0; i < plane_of_point.size(); ++i) {
      const std::int32_t p = plane_of_point[i], o = truth.object_of_point[i];
      const bool counts = o >= 0 && truth.objects[static_cast<std::size_t>(o)].planar &&
                          truth.objects[static_cast<std::size_t>(o)].points >= kFewestPoints;
      if (counts) face[o] += 1;
      if (p < 0) continue;
      if (o == kNotKnown) not_known[p] += 1;
      if (o != kNotKnown) plane[p] += 1;
      if (counts) both[{p, o}] += 1;
    }
    for (const auto& [p, n] : not_known) {
      if (n <= plane[p]) continue;
      plane.erase(p);
      std::erase_if(both, [p = p](const auto& entry) { return entry.first.first == p; });
    }
  }
};

/// A verdict on some planes and faces, and how much of them agrees.
struct Verdict {
  enum Kind { correct, over, under } kind;
  std::vector<std::int32_t> planes, faces;
  double overlap;
};

/// One region of one side that several of the other side make up: each of the parts lies in it by `t`, and they cover `t` of it.
template <typename PartOf, typename WholeOf>
void add_joined(const Overlaps& o, const std::map<std::int32_t, double>& wholes, const std::map<std::int32_t, double>& parts, double t,
                Verdict::Kind kind, PartOf part_of, WholeOf whole_of, std::vector<Verdict>& out) {
  for (const auto& [whole, size] : wholes) {
    std::vector<std::int32_t> inside;
    double covered = 0, share = 0;
    for (const auto& [pair, n] : o.both) {
      if (whole_of(pair) != whole || n < t * parts.at(part_of(pair))) continue;
      inside.push_back(part_of(pair));
      covered += n;
      share += n / parts.at(part_of(pair));
    }
    if (inside.size() < 2 || covered < t * size) continue;
    Verdict verdict{kind, inside, {whole}, (covered / size + share / static_cast<double>(inside.size())) / 2};
    if (kind == Verdict::under) std::swap(verdict.planes, verdict.faces);
    out.push_back(std::move(verdict));
  }
}

std::vector<Verdict> verdicts(const Overlaps& o, double t) {
  std::vector<Verdict> out;
  for (const auto& [pair, n] : o.both) {
    const double of_plane = n / o.plane.at(pair.first), of_face = n / o.face.at(pair.second);
    if (of_plane >= t && of_face >= t) out.push_back({Verdict::correct, {pair.first}, {pair.second}, (of_plane + of_face) / 2});
  }
  const auto plane_of = [](const auto& pair) { return pair.first; };
  const auto face_of = [](const auto& pair) { return pair.second; };
  add_joined(o, o.face, o.plane, t, Verdict::over, plane_of, face_of, out);
  add_joined(o, o.plane, o.face, t, Verdict::under, face_of, plane_of, out);
  std::stable_sort(out.begin(), out.end(), [](const Verdict& a, const Verdict& b) { return a.overlap > b.overlap; });
  return out;
}

}  // namespace

SegmentationScore score_segmentation(const SceneTruth& truth, const std::vector<std::int32_t>& plane_of_point, double threshold) {
  const Overlaps o(truth, plane_of_point);
  SegmentationScore score{.threshold = threshold, .planes = static_cast<int>(o.plane.size()), .faces = static_cast<int>(o.face.size())};
  std::set<std::int32_t> right, found;
  for (const auto& [pair, n] : o.both) {
    if (n < threshold * (o.plane.at(pair.first) + o.face.at(pair.second) - n)) continue;
    right.insert(pair.first);
    found.insert(pair.second);
  }
  score.right = static_cast<int>(right.size()), score.found = static_cast<int>(found.size());
  std::set<std::int32_t> judged_planes, judged_faces;
  for (const Verdict& v : verdicts(o, threshold)) {
    const auto judged = [](const auto& set, const auto& list) {
      return std::any_of(list.begin(), list.end(), [&](std::int32_t i) { return set.contains(i); });
    };
    if (judged(judged_planes, v.planes) || judged(judged_faces, v.faces)) continue;
    judged_planes.insert(v.planes.begin(), v.planes.end());
    judged_faces.insert(v.faces.begin(), v.faces.end());
    (v.kind == Verdict::correct ? score.correct : v.kind == Verdict::over ? score.over : score.under) += static_cast<int>(v.faces.size());
  }
  score.missed = score.faces - static_cast<int>(judged_faces.size());
  score.noise = score.planes - static_cast<int>(judged_planes.size());
  return score;
}

SegmentationScore& SegmentationScore::operator+=(const SegmentationScore& b) {
  planes += b.planes, faces += b.faces, found += b.found, right += b.right;
  correct += b.correct, over += b.over, under += b.under, missed += b.missed, noise += b.noise;
  return *this;
}

double SegmentationScore::precision() const { return planes == 0 ? 0 : static_cast<double>(right) / planes; }
double SegmentationScore::recall() const { return faces == 0 ? 0 : static_cast<double>(found) / faces; }

}  // namespace scenelore::evaluation
