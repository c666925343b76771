// SPDX-License-Identifier: MIT
// The accuracy report as one HTML page: figures first, then tables, plots and pictures, nothing loaded from anywhere.
#include "sinew_trainer/report.hpp"

#include <algorithm>

#include "score/report_parts.hpp"
#include "sinew_character/page/html.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_trainer/confidence.hpp"

namespace sinew {
namespace {

using html::escape;
using html::number;

void check(const ReportData& data) {
  if (data.variants.empty()) throw Error("report: no variant to report on");
  if (data.main_variant >= data.variants.size()) {
    throw Error("report: the main variant is number " + std::to_string(data.main_variant) + ", but there are " +
                std::to_string(data.variants.size()));
  }
}

const ReportVariant* labeled(const ReportData& data, const std::string& label) {
  for (const ReportVariant& v : data.variants)
    if (v.label == label) return &v;
  return nullptr;
}

// The figures that a reader looks for first; beside each what heat, the same features without a network, gets.
std::string key_figures(const ReportData& data) {
  const ReportVariant& main = data.variants[data.main_variant];
  const ReportVariant* heat = labeled(data, "heat");
  if (heat == &main) heat = nullptr;
  std::string out = "<div class=\"figures\">";
  const auto add = [&](const std::string& value, const std::string& what, const std::string& beside) {
    out += "<div><b>" + value + "</b><span>" + escape(what) + "</span>" +
           (beside.empty() ? "" : "<span>heat: " + beside + "</span>") + "</div>";
  };
  const auto figure = [&](double Metrics::*value, int digits, double factor, const char* unit, const char* what) {
    add(number(factor * (main.scores.all.*value), digits) + unit, what,
        heat ? number(factor * (heat->scores.all.*value), digits) + unit : "");
  };
  figure(&Metrics::l1, 3, 1, "", "L1, mean of characters (lower is better)");
  add(number(main.scores.family_mean.l1, 3), "L1, mean of families (lower is better)",
      heat ? number(heat->scores.family_mean.l1, 3) : "");
  figure(&Metrics::l1_file, 3, 1, "", "L1 with end joints as they lie in the file (lower is better)");
  figure(&Metrics::argmax, 1, 100, " %", "strongest joint right (higher is better)");
  figure(&Metrics::avg_dist, 4, 1, "", "mean distance in random poses (lower is better)");
  if (main.size_bytes > 0) add(number(static_cast<double>(main.size_bytes) / 1024, 1) + " KiB", "model", "");
  if (data.beaten_by_nearest)
    add(std::to_string(data.beaten_by_nearest->size()), "characters on which nearest bone is better", "");
  return out + "</div>\n";
}

std::string pictures(const ReportData& data) {
  if (data.pictures.empty()) return "";
  std::string out = "<h2>Characters</h2>\n<p class=\"soft\">Bound by " +
                    escape(data.variants[data.main_variant].label) +
                    ". One color per joint, blended by weight. Errors: 0 <span class=\"ramp\"></span> the largest of "
                    "the scale. The pose is the first of the ten random ones.</p>\n";
  for (const ReportPicture& picture : data.pictures) {
    out += "<div class=\"card character\"><h3>" + escape(picture.heading) + ": " + escape(picture.character) +
           "<span>" + escape(picture.note) + "</span></h3><div class=\"panels" + (picture.columns == 4 ? " four" : "") +
           "\">\n";
    for (const ReportPicture::Panel& panel : picture.panels)
      out += "<figure>" + html::image(panel.png, picture.character + ", " + panel.caption) + "<figcaption>" +
             escape(panel.caption) + "</figcaption></figure>\n";
    out += "</div></div>\n";
  }
  return out;
}

std::string families(const ReportData& data) {
  if (report_families(data).size() < 2) return "";
  return html::card("L1 by family (lower is better)", family_table(data, &Metrics::l1, 4, 1, true)) +
         html::card("Strongest joint right by family, % (higher is better)",
                    family_table(data, &Metrics::argmax, 2, 100, false)) +
         html::card("Mean distance in random poses by family (lower is better)",
                    family_table(data, &Metrics::avg_dist, 5, 1, true));
}

std::string plots(const ReportData& data) {
  const std::string legend = html::legend(variant_labels(data));
  std::string out = "<div class=\"grid\">\n";
  out += html::card("L1 of every character, sorted", legend + sorted_plot(data));
  const std::string deformation = deformation_plot(data);
  if (!deformation.empty()) {
    out += html::card("Deformation of every character in 10 poses",
                      legend + "<p class=\"soft\">Line: mean of " + escape(data.variants[data.main_variant].label) +
                          "; small dots: its single poses; large dots: heat's mean.</p>" + deformation);
  }
  out += html::card("L1 by family (lower is better)", legend + family_bars(data, &Metrics::l1, 3));
  out += html::card("Strongest joint right by family, % (higher is better)",
                    legend + family_bars(data, &Metrics::argmax, 1, 100));
  out += html::card("Mean distance by family (lower is better)", legend + family_bars(data, &Metrics::avg_dist, 4));
  if (data.reliability) {
    const Reliability& r = *data.reliability;
    double right = 0, confidence = 0;
    for (const Reliability::Bin& bin : r.bins) {
      right += bin.share * bin.right;
      confidence += bin.share * bin.confidence;
    }
    out +=
        html::card("Is the confidence honest?",
                   "<p class=\"soft\">Confidence: " + escape(data.confidence) +
                       ". On the dashed line a confidence of 0.8 is right four times in five; above it the binder is "
                       "better than it says. Every family counts the same. Expected calibration error " +
                       number(100 * r.error, 1) + " % (0 is best); right " + number(100 * right, 1) +
                       " %, confidence on average " + number(100 * confidence, 1) + " %.</p>" + reliability_plot(r));
  }
  return out + "</div>\n";
}

std::string integers(const ReportData& data) {
  const std::string bits = bits_plot(data);
  if (bits.empty() && !data.integers) return "";
  std::string out = "<div class=\"grid\">\n";
  if (!bits.empty()) out += html::card("L1 against bits", bits);
  if (data.integers) {
    out += html::card(
        "int16 against float",
        "<p class=\"soft\">Weights of both as 255ths, over all pairs of vertex and joint with weight in either: " +
            number(100 * data.integers->close_share(), 2) +
            " % within 1/255 (higher is better). Strongest joint changed at " +
            number(100 * data.integers->flip_share(), 3) + " % of " + html::count(data.integers->vertices) +
            " vertices (lower is better).</p>" + difference_plot(*data.integers));
  }
  return out + "</div>\n";
}

constexpr const char* kMeaning =
    "L1: sum over joints of |predicted - artist's| at a vertex, mean over vertices, 0 to 2. Argmax: share of vertices "
    "whose strongest joint is the artist's. Distances: between the vertices skinned with the prediction and with the "
    "artist's weights in 10 random poses, linear blend, longest side of the mesh = 1. KL: divergence of the prediction "
    "from the artist's weights. Means over characters; L1 (families) counts each family the same. Flips: vertices "
    "whose "
    "strongest joint differs from the float variant's; within 1/255: share of 8-bit weights at most one step from the "
    "float variant's. Arrows: ↓ lower is better, ↑ higher is better; bold is best.";

}  // namespace

std::string report_html(const ReportData& data) {
  check(data);
  const ReportVariant& main = data.variants[data.main_variant];
  std::string out = "<h1>" + escape(data.title) + "</h1>\n";
  if (!data.summary.empty()) out += "<p>" + escape(data.summary) + "</p>\n";
  out += key_figures(data);
  out += "<h2>Variants</h2>\n<div class=\"card\">" + variant_table(data) + "</div>\n";
  out += families(data) + pictures(data) + plots(data) + integers(data);
  out += html::card("Worst characters of " + main.label + " (L1)", worst_table(data, 10));
  if (data.beaten_by_nearest)
    out += html::card("Where nearest bone is better", beaten_table(data),
                      "Every vertex rigid to the nearest bone: what any binder should beat.");
  const std::string failures = failure_table(data);
  if (!failures.empty()) out += html::card("Failures", failures);
  out += "<h2>Every character</h2>\n<details class=\"card\"><summary>" + escape(main.label) + ": " +
         std::to_string(main.scores.characters.size()) + " characters</summary>\n" + character_table(main) +
         "</details>\n<h2>How the numbers were made</h2>\n" + html::facts(data.facts) + "<p class=\"soft\">" +
         kMeaning + "</p>\n";
  return html::page(data.title, out);
}

}  // namespace sinew
