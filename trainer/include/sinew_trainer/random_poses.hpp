// SPDX-License-Identifier: MIT
// The poses in which the yardstick compares deformations.
#ifndef SINEW_TRAINER_RANDOM_POSES_HPP
#define SINEW_TRAINER_RANDOM_POSES_HPP

#include <array>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Random poses of the yardstick (numpy's default_rng seeded with crc32(name), axis normal, angle uniform, limit 30..60
// degrees): [poses][joints] skinning matrices; `positions` scaled as the caller wants. Same draws as weights_eval.py.
std::vector<std::vector<Affine>> random_poses(const Character& character, const std::string& name,
                                              const std::vector<std::array<double, 3>>& positions, int poses = 10);

}  // namespace sinew
#endif
