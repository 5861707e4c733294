// The page: figures as tiles, tables, and plots as SVG that take their colours from the page's own variables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "evaluation/report.hpp"

namespace scenelore::evaluation {

namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ground: #fbfbfa; --card: #ffffff; --ink: #22252a; --soft: #6b7178; --line: #dfe2e6;
  --before: #9aa5b1; --after: #1f77b4; --good: #2a9d5c; --bad: #c8553d; --over: #e0a030; --under: #8e6bbf; }
@media (prefers-color-scheme: dark) { :root { --ground: #16181b; --card: #1e2125; --ink: #e6e8ea; --soft: #9aa1a9;
  --line: #353a40; --before: #6d7883; --after: #5aa9e6; --good: #4cc38a; --bad: #e5735b; --over: #e8b85a; --under: #b294dd; } }
body { margin: 0; background: var(--ground); color: var(--ink); font: 15px/1.5 system-ui, sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 2rem 1rem 4rem; }
h1 { font-size: 1.5rem; margin: 0; } h2 { font-size: 1.1rem; margin: 2.2rem 0 .6rem; }
p { margin: .3rem 0 .8rem; color: var(--soft); max-width: 46rem; }
.tiles { display: flex; flex-wrap: wrap; gap: .8rem; margin-top: 1.2rem; }
.tile, .card { background: var(--card); border: 1px solid var(--line); border-radius: 8px; }
.tile { padding: .7rem 1rem; min-width: 8.5rem; } .tile b { display: block; font-size: 1.6rem; line-height: 1.2; }
.tile span { color: var(--soft); font-size: .85rem; } .card { padding: .8rem 1rem; overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem; }
th { color: var(--soft); font-weight: 500; } th, td { padding: .15rem .6rem; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; } tbody tr { border-top: 1px solid var(--line); }
tr.sum td { font-weight: 600; } th.group { text-align: center; border-left: 1px solid var(--line); } td.first { border-left: 1px solid var(--line); }
svg { display: block; max-width: 100%; height: auto; } svg text { fill: var(--ink); font: 12px system-ui, sans-serif; }
svg .soft { fill: var(--soft); } .row { display: flex; flex-wrap: wrap; gap: 1rem; }
.key { display: inline-block; width: .8em; height: .8em; border-radius: 2px; margin: 0 .35em 0 .9em; vertical-align: -.05em; }
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '&') out += "&amp;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

ClassScore score_of(const AnswerScore& answer, const std::string& name) {
  const auto found = answer.objects.find(name);
  return found == answer.objects.end() ? ClassScore{} : found->second;
}

std::string tile(const std::string& value, const std::string& meaning) {
  return fmt::format("<div class=\"tile\"><b>{}</b><span>{}</span></div>", value, meaning);
}

std::string objects_row(const std::string& name, const ClassScore& before, const ClassScore& after, bool sum) {
  std::string out = fmt::format("<tr{}><td>{}</td><td>{}</td>", sum ? " class=\"sum\"" : "", escaped(name), after.real);
  for (const ClassScore* s : {&before, &after}) {
    out += fmt::format("<td class=\"first\">{}</td><td>{}</td><td>{}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td>", s->true_positive,
                       s->false_positive, s->false_negative(), precision(*s), recall(*s), f1(*s));
  }
  return out + "</tr>\n";
}

std::string objects_table(const Evaluation& e, const std::vector<std::string>& classes) {
  std::string out = "<table><thead><tr><th></th><th></th><th class=\"group\" colspan=\"6\">before constraints</th>"
                    "<th class=\"group\" colspan=\"6\">after constraints</th></tr><tr><th>class</th><th>real</th>";
  for (int i = 0; i < 2; ++i) out += "<th>TP</th><th>FP</th><th>FN</th><th>precision</th><th>recall</th><th>F1</th>";
  out += "</tr></thead><tbody>\n";
  for (const std::string& name : classes) out += objects_row(name, score_of(e.before, name), score_of(e.after, name), false);
  return out + objects_row("all of these", total(e.before.objects, classes), total(e.after.objects, classes), true) + "</tbody></table>";
}

/// Pairs of bars, before and after, a class each.
std::string f1_plot(const Evaluation& e, const std::vector<std::string>& classes) {
  constexpr double left = 110, width = 460, row = 30;
  const double height = row * static_cast<double>(classes.size()) + 30;
  std::string out = fmt::format("<svg viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\" aria-label=\"F1 per class\">", left + width + 60, height,
                                left + width + 60);
  for (int tick = 0; tick <= 4; ++tick) {
    const double x = left + width * tick / 4;
    out += fmt::format("<line x1=\"{0}\" x2=\"{0}\" y1=\"0\" y2=\"{1}\" stroke=\"var(--line)\"/><text class=\"soft\" x=\"{0}\" y=\"{2}\" "
                       "text-anchor=\"middle\">{3:.2f}</text>", x, height - 24, height - 8, tick / 4.0);
  }
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const double y = row * static_cast<double>(i) + 4, before = f1(score_of(e.before, classes[i])), after = f1(score_of(e.after, classes[i]));
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", left - 8, y + 15, escaped(classes[i]));
    out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"8\" rx=\"1.5\" fill=\"var(--before)\"/>", left, y, width * before);
    out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"10\" rx=\"1.5\" fill=\"var(--after)\"/>", left, y + 9, width * after);
    out += fmt::format("<text x=\"{:.1f}\" y=\"{}\">{:.2f}</text>", left + width * std::max(after, before) + 6, y + 15, after);
  }
  return out + "</svg>";
}

std::string reliability_plot(const Calibration& c, const char* title) {
  constexpr double left = 40, top = 24, side = 240, counts = 46;
  std::string out = fmt::format("<svg viewBox=\"0 0 300 365\" width=\"300\" role=\"img\" aria-label=\"reliability {}\">"
                                "<text x=\"{}\" y=\"14\">{}: ECE {:.3f}, Brier {:.3f}</text>", title, left, title, c.ece(), c.brier());
  out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"var(--line)\"/>", left, top, side, side);
  out += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"var(--soft)\" stroke-dasharray=\"4 4\"/>", left, top + side, left + side, top);
  double most = 1;
  for (const Calibration::Bin& bin : c.bins) most = std::max(most, bin.claims);
  std::string line;
  for (std::size_t b = 0; b < Calibration::kBins; ++b) {
    const Calibration::Bin& bin = c.bins[b];
    const double wide = side / Calibration::kBins, x = left + wide * static_cast<double>(b), high = counts * bin.claims / most;
    out += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"var(--before)\"><title>{:.0f} planes</title></rect>",
                       x + 1, top + side + 20 + counts - high, wide - 2, high, bin.claims);
    if (bin.claims <= 0) continue;
    const double px = left + side * bin.probability / bin.claims, py = top + side * (1 - bin.right / bin.claims);
    line += fmt::format("{}{:.1f},{:.1f}", line.empty() ? "" : " ", px, py);
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"var(--after)\"><title>says {:.2f}, right {:.2f}, {:.0f} planes"
                       "</title></circle>", px, py, 2.5 + 3 * std::sqrt(bin.claims / most), bin.probability / bin.claims, bin.right / bin.claims, bin.claims);
  }
  out += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"var(--after)\" stroke-width=\"1.5\"/>", line);
  for (const double at : {0.0, 0.5, 1.0}) {
    out += fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>", left + side * at, top + side + 14, at);
    out += fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", left - 5, top + side * (1 - at) + 4, at);
  }
  return out + fmt::format("<text class=\"soft\" x=\"{}\" y=\"355\" text-anchor=\"middle\">probability told; below: planes</text></svg>", left + side / 2);
}

/// Planes; shaded by the share of the row.
std::string confusion_plot(const Confusion& planes) {
  std::set<std::string> names;
  std::map<std::string, std::size_t> of_truth;
  for (const auto& [pair, n] : planes) names.insert({pair.first, pair.second}), of_truth[pair.first] += n;
  const std::vector<std::string> order(names.begin(), names.end());
  constexpr double left = 110, top = 96, cell = 34;
  const double side = cell * static_cast<double>(order.size());
  std::string out = fmt::format("<svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" role=\"img\" aria-label=\"confusion of planes\">", left + side + 20, top + side + 10);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double at = cell * static_cast<double>(i) + cell / 2;
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", left - 8, top + at + 4, escaped(order[i]));
    out += fmt::format("<text transform=\"translate({},{}) rotate(-55)\">{}</text>", left + at + 2, top - 6, escaped(order[i]));
    for (std::size_t j = 0; j < order.size(); ++j) {
      const auto found = planes.find({order[i], order[j]});
      const std::size_t n = found == planes.end() ? 0 : found->second;
      const double share = n == 0 ? 0 : static_cast<double>(n) / static_cast<double>(of_truth[order[i]]);
      out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"2\" fill=\"var({})\" fill-opacity=\"{:.2f}\"/>", left + cell * static_cast<double>(j) + 1,
                         top + cell * static_cast<double>(i) + 1, cell - 2, cell - 2, n == 0 ? "--line" : i == j ? "--good" : "--bad", n == 0 ? 0.25 : 0.15 + 0.65 * share);
      if (n > 0) {
        out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>", left + cell * static_cast<double>(j) + cell / 2, top + at + 4, n);
      }
    }
  }
  return out + "</svg>";
}

std::string segmentation_plot(const SegmentationScore& s) {
  constexpr double left = 90, width = 480;
  const std::pair<const char*, int> parts[]{{"--good", s.correct}, {"--over", s.over}, {"--under", s.under}, {"--bad", s.missed}};
  std::string out = fmt::format("<svg viewBox=\"0 0 {} 26\" width=\"{}\" role=\"img\" aria-label=\"segmentation\"><text x=\"0\" y=\"17\">threshold {}</text>",
                                left + width + 10, left + width + 10, s.threshold);
  double x = left;
  for (const auto& [color, n] : parts) {
    const double wide = s.faces == 0 ? 0 : width * n / s.faces;
    out += fmt::format("<rect x=\"{:.1f}\" y=\"3\" width=\"{:.1f}\" height=\"20\" fill=\"var({})\"><title>{}</title></rect>", x, wide, color, n);
    if (wide > 18) out += fmt::format("<text x=\"{:.1f}\" y=\"17\" text-anchor=\"middle\">{}</text>", x + wide / 2, n);
    x += wide;
  }
  return out + "</svg>";
}

std::string key(const char* color, const char* meaning) {
  return fmt::format("<span class=\"key\" style=\"background:var({})\"></span>{}", color, meaning);
}

std::string points_table(const Evaluation& e) {
  std::string out = "<table><thead><tr><th>class</th><th>points</th><th>IoU before</th><th>IoU after</th><th>accuracy</th><th>precision</th></tr></thead><tbody>\n";
  const auto before = point_scores(e.before.points);
  for (const auto& [name, s] : point_scores(e.after.points)) {
    if (s.truth == 0) continue;
    const auto first = before.find(name);
    out += fmt::format("<tr><td>{}</td><td>{}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td></tr>\n", escaped(name), s.truth,
                       first == before.end() ? 0 : first->second.iou(), s.iou(), s.accuracy(), s.precision());
  }
  return out + "</tbody></table>";
}

}  // namespace

std::string to_html(const Evaluation& e, const ReportOptions& options) {
  const std::vector<std::string> classes = listed_classes(e, options);
  const ClassScore before = total(e.before.objects, classes), after = total(e.after.objects, classes);
  std::string out = fmt::format("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">"
                                "<title>{0}</title><style>{1}</style></head><body><main>\n<h1>{0}</h1>\n", escaped(options.title), kStyle);
  out += fmt::format("<p>{} scan{}, {} planes ({} of them known), {} of {} points known.</p>\n", e.scans, e.scans == 1 ? "" : "s", e.planes,
                     e.known_planes, e.known_points, e.points);
  out += "<div class=\"tiles\">" + tile(fmt::format("{:.3f}", f1(after)), fmt::format("F1 of objects (before constraints {:.3f})", f1(before))) +
         tile(fmt::format("{:.3f}", precision(after)), "precision") + tile(fmt::format("{:.3f}", recall(after)), "recall") +
         tile(fmt::format("{:.1f} %", 100 * overall_accuracy(e.after.points)), "points with the right class") +
         tile(fmt::format("{:.3f}", e.after.calibration.ece()), "calibration error") + "</div>\n";
  out += "<h2>Objects</h2><p>An object is found when a plane of its label has more than half of its points on it; a second such plane, and a plane on "
         "something else, are false.</p><div class=\"card\">" + objects_table(e, classes) + "</div>\n";
  out += "<h2>F1 per class</h2><p>" + key("--before", "before constraints") + key("--after", "after") + "</p><div class=\"card\">" + f1_plot(e, classes) + "</div>\n";
  out += "<h2>Points</h2><div class=\"card\">" + points_table(e) + "</div>\n";
  if (options.segmentation) {
    out += "<h2>Segmentation</h2><p>Faces" + key("--good", "found as one plane") + key("--over", "over-segmented") + key("--under", "under-segmented") +
           key("--bad", "missed") + " (Hoover et al. 1996)";
    for (const SegmentationScore& s : e.segmentation) {
      out += fmt::format("; at {}: IoU precision {:.3f}, recall {:.3f}, {} noise planes", s.threshold, s.precision(), s.recall(), s.noise);
    }
    out += "</p><div class=\"card\">";
    for (const SegmentationScore& s : e.segmentation) out += segmentation_plot(s);
    out += "</div>\n";
  }
  out += "<h2>Which planes are taken for what</h2><p>Rows are the truth, columns the answer; shaded by share of the row.</p><div class=\"card\">" +
         confusion_plot(e.after.planes) + "</div>\n";
  out += "<h2>Do the probabilities hold?</h2><p>Of planes told with a probability of 0.8, eight of ten should be right: on the diagonal.</p>"
         "<div class=\"card row\">" + reliability_plot(e.before.calibration, "before constraints") + reliability_plot(e.after.calibration, "after") + "</div>\n";
  return out + "</main></body></html>\n";
}

}  // namespace scenelore::evaluation
