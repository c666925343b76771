// SPDX-License-Identifier: MIT
// Where parts of a body that move apart have grown together: a hand on a hip, an arm along the trunk, two thighs.
#ifndef SINEW_CHARACTER_SEAMS_HPP
#define SINEW_CHARACTER_SEAMS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// One line along which two parts meet.
struct Seam {
  std::array<size_t, 2> joints = {};  // those that most of it lies between, the lower index first
  Vec3 position;                      // its middle
  double length = 0;                  // the sum of its faces' shares, the mesh's units
};

constexpr uint32_t kNoHome = UINT32_MAX;

struct Seams {
  std::vector<Seam> seams;                     // longest first
  std::vector<std::array<uint32_t, 2>> edges;  // across them, of vertices that are the first at their positions
  std::vector<uint32_t>
      homes;  // [V] joint of the part that a vertex near a seam belongs to, kNoHome elsewhere; empty without seams
};

using WeightRows = std::vector<std::vector<Influence>>;

// Finds seams by the skeleton, the mesh and weights that may cross them. An edge lies across a seam where the parts of its ends are far
// apart along the skeleton but near in space, the surface is a valley, and both sides still hang together another way round. Which part
// a vertex near a seam belongs to is decided anew by three things: what the weights say, the distance to each bone against that bone's
// usual distance to its surface, and creases. Decisions are doubles of one order of operations.
//   rows  [V]
Seams find_seams(const Character& character, const WeightRows& rows);

// Takes the weight across seams away: joints that are far from a vertex's home along the skeleton and near in space.
//   keep  [V] non-zero: the row stays, or empty
//   rows  in/out [V]
// Returns how many rows changed.
size_t keep_apart(const Character& character, const Seams& seams, const std::vector<uint8_t>& keep, WeightRows* rows);

// Opens the seams as a slit: vertices there are doubled, and each face belongs to the part that most of its corners do. Only the new
// vertices move, by four millionths of the size towards their part, so that the engine does not weld them. They come last, with the weights of the part that they now belong to; corners keep their UVs, normals and
// materials, a glTF document its attributes and shapes. Returns how many vertices were doubled. Throws Error for a broken document.
size_t cut_seams(const Seams& seams, Character* character);

// "grown together: LeftHand and Hips, LeftThigh and RightThigh; no weight crosses, --cut opens them"
//   doubled  vertices of cut_seams(), 0: they are not open
std::string seams_text(const std::vector<Joint>& joints, const Seams& seams, size_t doubled);

// How much weight lies on the wrong side of seams, where the true weights are known.
struct SeamLeak {
  double surface = 0;  // share of the surface that lies within 5 % of the size around a true seam; 0 without seams
  double wrong = 0;    // of the weight there, the share beyond the true one of joints on the other side
};

// True seams are edges between parts that are apart by the strongest of the character's own weights.
//   rows  [V] predicted
SeamLeak measure_seam_leak(const Character& character, const WeightRows& rows);

}  // namespace sinew
#endif
