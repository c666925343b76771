// SPDX-License-Identifier: MIT
// The yardstick: how far predicted skin weights are from reference weights. Same numbers as weights_eval.py to 1e-4.
#ifndef SINEW_TRAINER_EVALUATE_HPP
#define SINEW_TRAINER_EVALUATE_HPP

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// One character, or a mean over several. Definitions: trainer/README.md.
struct Metrics {
  double precision = 0, recall = 0, l1 = 0, avg_dist = 0, max_dist = 0, argmax = 0, kl = 0, bad = 0;
  double l1_area = 0, max_dist_all = 0, influences = 0, unweighted = 0;
  size_t vertices = 0, unbound = 0, joints = 0;
  double seconds = 0;
};

// Compares predicted influences with the character's own. End joints (unbound leaves) of the prediction are folded into their
// parents, rows normalised, vertices without reference weights left out. `name` seeds the poses.
// vertex_l1, when given, gets [V] L1 per vertex (0 for left-out vertices).
Metrics measure(const Character& reference, const std::vector<std::vector<Influence>>& predicted, const std::string& name,
                int poses = 10, std::vector<float>* vertex_l1 = nullptr);

// Parent every end joint's weight folds to ([J], itself when it is none): a leaf that no reference vertex is bound to.
std::vector<uint32_t> fold_targets(const Character& reference);

struct Scores {
  std::vector<std::pair<std::string, Metrics>> characters;  // by name
  std::map<std::string, Metrics> families;                  // mean of each family's characters
  Metrics all;                                              // mean over characters
  Metrics family_mean;                                      // mean over families
  std::map<std::string, std::string> failures;              // name -> one line
};
Scores summarise(std::vector<std::pair<std::string, Metrics>> characters);
// Markdown table as the yardstick prints it; JSON with every number.
std::string scores_markdown(const std::string& label, const Scores& scores);
std::string scores_json(const std::string& label, const Scores& scores);

}  // namespace sinew
#endif
