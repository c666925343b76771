// SPDX-License-Identifier: MIT
// The accuracy report: several variants of a binder (float, int16, fewer bits, heat) compared on one data set.
#ifndef SINEW_TRAINER_REPORT_HPP
#define SINEW_TRAINER_REPORT_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sinew_formats/base/box.hpp"
#include "sinew_trainer/confidence.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/weight_difference.hpp"

namespace sinew {

// One row of the tables.
struct ReportVariant {
  std::string label;  // "float checkpoint", "int16 model", "8 bits", "heat"
  Scores scores;
  int bits = 0;                        // bits of the weights; 0 = none of its own (heat): not on the axis of bits
  size_t size_bytes = 0;               // of the file; 0 = none
  std::optional<double> argmax_flips;  // share of vertices whose strongest joint differs from the float variant's
  std::optional<double> close_unorm8;  // share of weights within 1/255 of the float variant's
  std::optional<double> logit_snr_db;  // signal to noise of the logits against the float variant's
  std::map<std::string, std::vector<double>> pose_distances;  // character -> mean distance in each pose; may be empty
};

// One character in pictures, PNG files in memory.
struct ReportPicture {
  std::string heading;  // "best", "median", "worst"
  std::string character;
  std::string note;  // one line of figures
  struct Panel {
    std::string caption;
    std::vector<uint8_t> png;
  };
  std::vector<Panel> panels;
  int columns = 3;  // 3 or 4 panels in a row
};

struct ReportData {
  std::string title = "sinew: accuracy report";
  std::string summary;                                     // one sentence under the title; may be empty
  std::vector<std::pair<std::string, std::string>> facts;  // how the numbers were made: command, data, checksum ...
  std::vector<ReportVariant> variants;                     // at least one
  size_t main_variant = 0;                                 // whose characters are listed and drawn
  std::vector<ReportPicture> pictures;
  std::optional<Reliability> reliability;         // of the main variant
  std::string confidence = "the largest weight";  // what was taken as its confidence
  std::optional<WeightDifference> integers;       // the int16 variant against float
  // Characters on which the nearest bone alone is better than the main variant, and by how much; none: not compared.
  std::optional<std::vector<std::pair<std::string, double>>> beaten_by_nearest;
};

// Names of the characters with the lowest, the middle and the highest L1, each once; fewer when there are fewer.
std::vector<std::pair<std::string, std::string>> best_median_worst(const Scores& scores);  // (heading, character)

// Six panels of `side` pixels. At rest: the artist's weights, the prediction, L1 per vertex (0 .. 1). In the
// yardstick's first random pose: skinned with the artist's weights, with the prediction, and how far apart they are (0
// .. 0.05 of the longest side).
ReportPicture report_picture(const Character& reference, const std::vector<std::vector<Influence>>& predicted,
                             const std::string& heading, Axis up = Axis::kY, int side = 400);

// One page that needs nothing else: style, plots (SVG) and pictures (data URIs) are inside.
// Throws Error when there is no variant or main_variant is none of them.
std::string report_html(const ReportData& data);
// The table of variants alone.
std::string quantisation_table_markdown(const ReportData& data);

}  // namespace sinew
#endif
