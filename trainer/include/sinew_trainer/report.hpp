// SPDX-License-Identifier: MIT
// The accuracy report: several variants of a binder (float, int16, fewer bits, heat) compared on one data set.
#ifndef SINEW_TRAINER_REPORT_HPP
#define SINEW_TRAINER_REPORT_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sinew_trainer/evaluate.hpp"

namespace sinew {

// One row of the tables.
struct ReportVariant {
  std::string label;  // "float checkpoint", "int16 model", "8 bits", "heat"
  Scores scores;
  int bits = 0;                        // bits of the weights; 0 = none of its own (heat): not on the axis of bits
  size_t size_bytes = 0;               // of the file; 0 = none
  std::optional<double> argmax_flips;  // share of vertices whose strongest joint differs from the float variant's
  std::optional<double> logit_snr_db;  // signal to noise of the logits against the float variant's
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
};

struct ReportData {
  std::string title = "sinew: accuracy report";
  std::string summary;                                     // one sentence under the title; may be empty
  std::vector<std::pair<std::string, std::string>> facts;  // data folder, model, commit ...
  std::vector<ReportVariant> variants;                     // at least one
  size_t main_variant = 0;                                 // whose characters are listed and drawn
  std::vector<ReportPicture> pictures;
};

// Names of the characters with the lowest, the middle and the highest L1, each once; fewer when there are fewer.
std::vector<std::pair<std::string, std::string>> best_median_worst(const Scores& scores);  // (heading, character)

// Four panels of `side` pixels: reference weights, predicted weights, L1 error (0 .. 1), posed with the prediction.
ReportPicture report_picture(const Character& reference, const std::vector<std::vector<Influence>>& predicted,
                             const std::string& heading, bool up_z = false, int side = 420);

// One page that needs nothing else: style, plots (SVG) and pictures (data URIs) are inside.
// Throws Error when there is no variant or main_variant is none of them.
std::string report_html(const ReportData& data);
// The table of variants alone.
std::string quantisation_table_markdown(const ReportData& data);

}  // namespace sinew
#endif
