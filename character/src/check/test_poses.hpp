// SPDX-License-Identifier: MIT
// Poses that every body of a kind takes: elbows and knees bent, limbs swung, hands turned.
#ifndef SINEW_CHARACTER_CHECK_TEST_POSES_HPP
#define SINEW_CHARACTER_CHECK_TEST_POSES_HPP

#include <string>
#include <vector>

#include "check/rig_facts.hpp"
#include "sinew_formats/base/affine.hpp"

namespace sinew {

struct TestPose {
  std::string name;             // "elbows and knees bent by 90 degrees"
  std::vector<size_t> joints;   // that turn
  std::vector<Affine> palette;  // [J] skinning matrices
};

// Poses in which at least one joint turns. Angles are tabled with their sines, so that matrices are the same on every machine.
std::vector<TestPose> test_poses(const RigFacts& facts);

}  // namespace sinew
#endif
