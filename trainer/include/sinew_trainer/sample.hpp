// SPDX-License-Identifier: MIT
// Samples: what a network sees of one mesh or one skeleton, and of a character with the weights it shall learn.
#ifndef SINEW_TRAINER_SAMPLE_HPP
#define SINEW_TRAINER_SAMPLE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// The rows of a network's inputs, and who is whose neighbor. Every task's samples begin with it and add what they are trained
// towards. Copies, all sizes known. For a task over joints, "vertex" represents a joint everywhere here. A task whose network has no
// domain with slots has one slot per vertex, always absent.
struct NetworkSample {
  NetworkSample() = default;
  NetworkSample(const NetworkSample&) = default;
  NetworkSample(NetworkSample&&) = default;
  NetworkSample& operator=(const NetworkSample&) = default;
  NetworkSample& operator=(NetworkSample&&) = default;
  virtual ~NetworkSample() = default;

  struct Input {
    uint32_t channels = 0;      // C
    std::vector<int16_t> rows;  // [U x C] or, in a domain with slots, [U x K x C]; Q13
  };

  std::string name, family;
  uint32_t vertices = 0;                           // U, welded
  uint32_t candidates = 0;                         // K
  uint32_t part_count = 0, joints = 0;             // parts; J, more than any candidate
  std::vector<Input> inputs;                       // in the task's order
  std::vector<uint16_t> candidate;                 // [U x K], 0xFFFF absent
  std::vector<uint32_t> row_offsets, col_indices;  // one-ring CSR
  std::vector<uint32_t> far_offsets, far_indices;  // CSR of far neighbors; empty where the task has none
  std::vector<uint32_t> part, part_offsets, part_vertices;
};

// One training sample: the input of bind's network for one character, and the reference. Its inputs are the engine's
// vertex and pair features (kVertexInput and kPairInput of features/features.hpp). A joint that is no candidate, but
// whose end marker is (fold[end] == joint), has its reference weight on the first such end marker. The yardstick
// counts `importance`.
struct Sample : NetworkSample {
  std::vector<float> target;      // [U x K] reference weight of each candidate, see above
  std::vector<uint32_t> fold;     // [J] fold_targets of the character
  std::vector<float> missing;     // [U] reference weight no candidate has
  std::vector<float> importance;  // [U] the caller's vertices in this one that have weights; 0: unbound, or owned
  std::vector<uint16_t> owner;    // [U] the joint that owns the vertex' part and is its row, or kNoJoint; or empty
  std::vector<float> heat;        // [U x K] the finished rule field at the candidates (sums to <= 1)
  std::vector<uint32_t> vertex_to_welded;  // [V]
  std::vector<float> positions;            // [U x 3] in sides of the grid, 0..1
  std::vector<float> joint_positions;      // [J x 3] likewise
  std::vector<int32_t> parents;            // [J] -1 for roots
};

// Runs the engine's stages 1 to 7 on a character. feature_flags: of a network's feature set (other bits are ignored).
// Throws Error.
Sample make_sample(const Character& character, uint32_t candidates, uint32_t grid, uint32_t feature_flags = 0);

// A network's probabilities [U x K] as rows of influences [V], the `keep` largest, rounded as the engine rounds. Owned
// vertices follow their owners.
inline constexpr uint32_t kKeptInfluences = 4;  // of a bind by default: what is validated and measured
std::vector<std::vector<Influence>> sample_influences(const Sample& sample, const std::vector<float>& probabilities,
                                                      uint32_t keep);

}  // namespace sinew
#endif
