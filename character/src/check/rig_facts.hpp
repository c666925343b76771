// SPDX-License-Identifier: MIT
// Facts of a character for the rules, found once, and poses that every body of its kind takes.
#ifndef SINEW_CHARACTER_CHECK_RIG_FACTS_HPP
#define SINEW_CHARACTER_CHECK_RIG_FACTS_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

constexpr uint32_t kNoOne = UINT32_MAX;

struct RigFacts {
  explicit RigFacts(const Character& character);  // throws Error, see check_rig()

  const Character& character;
  double size = 1;         // the mesh's longest side; of a skeleton alone the skeleton's
  bool bound = false;      // there are weights
  JointVerdicts verdicts;  // by names, positions and weights
  JointTree tree;
  std::vector<uint32_t> first;               // [V] the first vertex at its position
  std::vector<std::vector<uint32_t>> rings;  // [V] of first vertices, each once, ascending; of others empty
  std::vector<uint32_t> parts;               // [V] number of the connected piece of the surface
  std::vector<uint32_t> strongest;           // [V] joint, kNoOne for a row without weight
  std::vector<std::vector<uint32_t>> moves;  // [J] vertices that it is the strongest of
  std::vector<double> weight;                // [J] of all rows, each brought to a sum of 1

  // Weight for a joint, the row brought to a sum of 1.
  double weight_of(uint32_t vertex, uint32_t joint) const;
  // Difference of two rows (L1), both brought to a sum of 1: 0..2.
  double difference(uint32_t a, uint32_t b) const;
  bool is_below(size_t joint, size_t above) const;
  // Part of a body that names or hierarchy know as one: an arm, a leg, the torso, a head, a tail, a wing.
  bool is_body(size_t joint) const;
  // A joint of an arm or a leg that deforms.
  bool is_limb(size_t joint) const;
  // At most one other joint of its class is on its side: of insects little can be said by names.
  bool is_single(size_t joint) const;
};

// Poses that every body of a kind takes: elbows and knees bent, limbs swung, hands twisted.
struct TestPose {
  std::string name;             // "elbows and knees bent by 90 degrees"
  std::vector<size_t> joints;   // rotated joints
  std::vector<Affine> palette;  // [J] skinning matrices
};

// Poses in which at least one joint rotates. Angles are tabled with their sines, so that matrices are the same on
// every machine.
std::vector<TestPose> test_poses(const RigFacts& facts);

}  // namespace sinew
#endif
