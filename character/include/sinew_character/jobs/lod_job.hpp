// SPDX-License-Identifier: MIT
// What `sinew lod` does with one character: the same with fewer triangles and joints, level by level.
#ifndef SINEW_CHARACTER_LOD_JOB_HPP
#define SINEW_CHARACTER_LOD_JOB_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

struct LodOptions {
  uint32_t levels = 3;
  double ratio = 0.5;   // of the level before's triangles
  bool joints = false;  // level 2 has the skeleton of `simplify --level high`, further ones of low
};

struct LodLevel {
  Character character;
  Motion motion;  // the file's own clips, for its joints
  size_t triangles = 0;
  double rest_error = 0;   // largest distance of a vertex of the input from the level's surface, share of the height
  double posed_error = 0;  // the same, the worst of the poses that `sinew check` bends bodies in
  double mean_error = 0;   // the mean over vertices in that pose
};

// Vertices that are left keep weights, shapes, seams and materials. Each level is reduced at rest and in a bent pose, and the one that is nearer
// to the input when posed is taken: at most 2,000 vertices are looked at. A level that misses its share says why in its character's notes. Throws Error for a character without weights.
std::vector<LodLevel> levels_of_detail(const LodOptions& options, const Character& character);

}  // namespace sinew
#endif
