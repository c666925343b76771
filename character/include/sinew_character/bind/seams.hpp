// SPDX-License-Identifier: MIT
// Seams: lines where separate parts of a body are fused in the mesh, such as a hand on a hip, an arm along the torso,
// or two thighs.
#ifndef SINEW_CHARACTER_SEAMS_HPP
#define SINEW_CHARACTER_SEAMS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// One seam between two parts.
struct Seam {
  std::array<size_t, 2> joints = {};  // joints on its two sides, the lower index first
  Vec3 position;                      // its center
  double length = 0;                  // sum of its faces' shares, in the mesh's units
};

constexpr uint32_t kNoHome = UINT32_MAX;

struct Seams {
  std::vector<Seam> seams;                     // longest first
  std::vector<std::array<uint32_t, 2>> edges;  // across seams, between vertices that are the first at their positions
  std::vector<uint32_t>
      homes;  // [V] joint of the part of each vertex near a seam, kNoHome elsewhere; empty without seams
};

using WeightRows = std::vector<std::vector<Influence>>;

// Finds seams from the skeleton, the mesh and weights that may cross them. An edge crosses a seam if the parts of its
// ends are far apart along the skeleton but near in space, the surface is concave, and both sides are also connected
// on another path. The part of a vertex near a seam is decided from the weights, the distance to each bone relative
// to that bone's usual distance to its surface, and creases. Decisions use doubles in a fixed order of operations.
//   rows  [V]
Seams find_seams(const Character& character, const WeightRows& rows);

// Removes weight across seams: of joints that are far from a vertex's home along the skeleton and near in space.
//   keep  [V] non-zero: the row is kept; or empty
//   rows  in/out [V]
// Returns the number of changed rows.
size_t keep_apart(const Character& character, const Seams& seams, const std::vector<uint8_t>& keep, WeightRows* rows);

// Cuts the seams open as slits: vertices there are doubled, and each face belongs to the part of most of its corners.
// Only the new vertices move, by four millionths of the size towards their part, so that the engine does not weld
// them. They are appended with the weights of their part; corners keep their UVs, normals and materials, and a glTF
// document its attributes and shapes. Returns the number of doubled vertices. Throws Error for an invalid document.
size_t cut_seams(const Seams& seams, Character* character);

// "fused parts at LeftHand and Hips, LeftThigh and RightThigh; no weight crosses there, --cut opens the mesh there"
//   doubled  result of cut_seams(); 0: not cut
std::string seams_text(const std::vector<Joint>& joints, const Seams& seams, size_t doubled);

// Amount of weight on the wrong side of seams, for characters with reference weights.
struct SeamLeak {
  double surface = 0;  // share of the surface within 5 % of the size of a true seam; 0 without seams
  double wrong = 0;    // of the weight there, the share on joints of the other side beyond the true share
};

// True seams are edges between separate parts, by the strongest of the character's own weights.
//   rows  [V] predicted
SeamLeak measure_seam_leak(const Character& character, const WeightRows& rows);

}  // namespace sinew
#endif
