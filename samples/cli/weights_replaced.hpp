// SPDX-License-Identifier: MIT
// What a bind did to weights that the file had: how many, how far away, and which joints changed most.
#ifndef SINEW_CLI_WEIGHTS_REPLACED_HPP
#define SINEW_CLI_WEIGHTS_REPLACED_HPP

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew::cli {

// The vertices that a joint had most weight on in the file.
struct JointChange {
  std::string joint;
  size_t vertices = 0;
  double l1 = 0;  // mean over them
};

struct WeightsReplaced {
  size_t vertices = 0;               // that had weights and got others; 0: nothing was replaced
  double l1 = 0;                     // mean over them of the sum over joints of |new - old|, 0..2
  std::vector<JointChange> changes;  // every joint that has such vertices, the largest mean first
};

// Compares rows [V] of the same joints; old ones are scaled to a sum of 1.
//   kept  [V] not 0: the vertex keeps its weights and does not count; or empty
WeightsReplaced compare_weights(const std::vector<Joint>& joints, const std::vector<std::vector<Influence>>& before,
                                const std::vector<std::vector<Influence>>& after, const std::vector<uint8_t>& kept);

// "replaced the weights of 2,338 vertices; they were L1 0.21 away"; empty when none were.
std::string replaced_text(const WeightsReplaced& replaced);
// The joints that changed most as a table, ten at most.
std::vector<std::string> change_lines(const WeightsReplaced& replaced);
// {"vertices", "l1"}, and the "joints" of the table if asked for.
nlohmann::ordered_json replaced_json(const WeightsReplaced& replaced, bool with_joints);

}  // namespace sinew::cli
#endif
