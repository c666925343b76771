// SPDX-License-Identifier: MIT
// How well a binder knows where it is wrong: confidence per vertex against what the artist chose, and its calibration.
#ifndef SINEW_TRAINER_CONFIDENCE_HPP
#define SINEW_TRAINER_CONFIDENCE_HPP

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// The bound vertices of one character.
struct JudgedConfidence {
  std::string family;
  std::vector<uint8_t> confidence;  // 0..255, as the engine gives it
  std::vector<uint8_t> right;       // 1: the strongest predicted joint is the artist's (either one of a tie)
};
// `predicted` and `confidence` [V] as bind() returns them. End joints count as their parents, as in the yardstick.
JudgedConfidence judge_confidence(const Character& reference, const std::vector<std::vector<Influence>>& predicted,
                                  const std::vector<uint8_t>& confidence);

struct Reliability {
  struct Bin {
    double confidence = 0, right = 0;  // means over the vertices of the bin
    double share = 0;                  // of all vertices
  };
  std::vector<Bin> bins;  // ten, of equal width; an empty one has share 0
  double error = 0;       // expected calibration error: mean over vertices of |confidence - right| of their bin
};
// Families weigh the same, vertices of a family too.
Reliability reliability(const std::vector<JudgedConfidence>& judged);

// How much looking at the least sure tenth of a character's vertices finds. Of equally sure ones a fair share counts.
struct DoubtLift {
  double wrong = 0;          // share of vertices with a wrong strongest joint
  double wrong_first = 0;    // the same among the least sure tenth
  double times_average = 0;  // the second over the first, of every character
  size_t characters = 0;     // that have a wrong vertex: all are means over these
};
DoubtLift doubt_lift(const std::vector<JudgedConfidence>& judged);

// Share of the strongest joint and share of hits, both 65535 = 1: the entries of a model's confidence table.
using ConfidenceTable = std::vector<std::pair<uint16_t, uint16_t>>;
// Isotonic regression (pool adjacent violators) over at most `bins` bins of equal weight, families weighing the same.
// `judged` holds confidences without a table. Throws Error when there is no vertex.
ConfidenceTable fit_confidence(const std::vector<JudgedConfidence>& judged, size_t bins = 32);
// Applies the table to confidences without one, as the engine does.
std::vector<JudgedConfidence> apply_confidence(const std::vector<JudgedConfidence>& judged,
                                               const ConfidenceTable& table);
// Calibration on families that the table has not seen: fitted on each half of the families and evaluated on the
// other, both halves together. Families are dealt by descending size: 1st, 4th, 5th, 8th ... and the rest. Throws
// Error when there are fewer than two families.
Reliability reliability_across_families(const std::vector<JudgedConfidence>& judged);

// The plainest confidence, for binders that tell none: the largest weight of each row as a share of the row, 0..255;
// 0 for an empty row.
std::vector<uint8_t> top_weights(const std::vector<std::vector<Influence>>& rows);

// Hits over confidence and, below it, how much of the data each bin holds, as SVG of sinew_formats/plots.hpp.
std::string reliability_plot(const Reliability& reliability);

}  // namespace sinew
#endif
