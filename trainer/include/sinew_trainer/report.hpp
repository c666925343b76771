// SPDX-License-Identifier: MIT
// The accuracy report: several variants of a binder (float, int16, fewer bits, heat) compared on one data set, with pictures of
// bends: before and after correction, and under cloth.
#ifndef SINEW_TRAINER_REPORT_HPP
#define SINEW_TRAINER_REPORT_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_formats/base/box.hpp"
#include "sinew_trainer/confidence.hpp"
#include "sinew_trainer/evaluate.hpp"

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
std::string quantization_table_markdown(const ReportData& data);

// Elbow, knee, hip and shoulder bent and wrist twisted, each as linear skinning shows it and with its volume kept: the joints of
// one side that names tell. A panel a joint; none where no name tells a joint.
ReportPicture bend_pictures(const Character& character, Axis up = Axis::kY, int side = 300);

// How much there is to see. Cloth is a part of the mesh of its own that lies around another part and the bone.
struct Clothing {
  size_t bends = 0;      // of the report's elbow, knee, hip and shoulder those under cloth; 0 when nothing is dressed
  size_t crossings = 0;  // pairs of triangles of cloth and skin that cross at rest
};
Clothing measure_clothing(const Character& character);

// Four panels a bend: the cloth bound alone, with the weights of the body's nearest points, as a transfer to a garment gives them, and
// these with the volume of body and cloth kept. The body has the weights of `character`. Each caption counts the pairs of triangles of
// cloth and skin that cross and did not at rest. No panels when nothing lies under cloth.
//   model  for the binds; null: by heat
ReportPicture garment_pictures(const Character& character, const sinew_model* model, Axis up = Axis::kY,
                               int side = 300);

}  // namespace sinew
#endif
