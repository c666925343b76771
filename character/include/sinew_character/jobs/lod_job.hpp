// SPDX-License-Identifier: MIT
// The job of `sinew lod` for one character: levels with fewer triangles and joints.
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
  double ratio = 0.5;   // triangles as a share of the level before
  bool joints = false;  // level 2 has the skeleton of `simplify --level high`, later ones of low
};

struct LodLevel {
  Character character;
  Motion motion;  // the file's own clips, for its joints
  size_t triangles = 0;
  double rest_error = 0;   // largest distance of a vertex of the input from the level's surface, share of the height
  double posed_error = 0;  // the same in the worst test pose of `sinew check`
  double mean_error = 0;   // the mean over vertices in that pose
};

// Remaining vertices keep weights, shapes, seams and materials. Each level is reduced both at rest and in a bent
// pose; the result closer to the posed input is used, measured at up to 2,000 vertices. A level that misses its share
// has a note with the reason. Throws Error for a character without weights.
std::vector<LodLevel> levels_of_detail(const LodOptions& options, const Character& character);

}  // namespace sinew
#endif
