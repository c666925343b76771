// SPDX-License-Identifier: MIT
// The yardstick of fingers: predicted ones against those of a rigged character's clear hands (target_skeleton.hpp).
#ifndef SINEW_TRAINER_HAND_SCORE_HPP
#define SINEW_TRAINER_HAND_SCORE_HPP

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_data_sets/target_skeleton.hpp"

namespace sinew {

// Within this share of the hand's length a predicted joint is right.
constexpr double kFingerTolerance = 0.1;

// Scores of the hands of one character or of several. Joints are finger joints and finger ends; lengths are shares of
// the length of the hand, from the wrist to its farthest point.
struct HandScore {
  size_t hands = 0;                 // that have fingers
  size_t exact = 0;                 // of these: with the same number of fingers predicted
  size_t bare = 0;                  // that have none
  size_t bare_wrong = 0;            // of these: with a finger predicted
  size_t unclear = 0;               // that are not counted
  size_t joints = 0, found = 0;     // the artist's; those with a predicted joint within the tolerance
  size_t predicted = 0, right = 0;  // predicted on hands with fingers; those within the tolerance of the artist's
  size_t same = 0;                  // pairs of the same finger and index in it
  double distance = 0;              // summed over these pairs

  double mean_distance() const { return same > 0 ? distance / static_cast<double>(same) : 0; }
  double precision() const { return predicted > 0 ? static_cast<double>(right) / static_cast<double>(predicted) : 0; }
  double recall() const { return joints > 0 ? static_cast<double>(found) / static_cast<double>(joints) : 0; }
  void add(const HandScore& other);
};

// A target hand's fingers are those of the predicted hand that is nearest to it, within its length.
HandScore score_hands(const Character& character, const PredictedSkeleton& predicted);

// A Markdown table of the scores by family, and of all.
std::string hand_scores_markdown(const std::vector<std::pair<std::string, HandScore>>& characters);
std::string hand_scores_json(const std::vector<std::pair<std::string, HandScore>>& characters);

}  // namespace sinew
#endif
