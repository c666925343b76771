// SPDX-License-Identifier: MIT
// Dividing a data set into training and validation so that what belongs together stays together, and placing
// the files of a character.
#ifndef SINEW_DATA_SETS_SPLIT_HPP
#define SINEW_DATA_SETS_SPLIT_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace sinew {

// Characters that go to the same side.
struct SplitUnit {
  std::string name;
  std::vector<size_t> members;  // indices of the keys given
};
// One unit per different key (a character's group, family or own name), sorted by key.
std::vector<SplitUnit> split_units(const std::vector<std::string>& keys);

// Marks the units of the validation side: drawn by the seed, together as close to `share` (0..1) of all characters as
// whole units allow, never none and never all. Same result on every machine. Throws Error for fewer than two units.
std::vector<bool> choose_validation(const std::vector<SplitUnit>& units, double share, uint64_t seed);

// Puts the files of one character (mesh, rig beside an OBJ, buffers and pictures of a .gltf) into a folder as hard links, as copies where
// links are not possible. Never replaces a file: throws Error.
void place_character(const std::string& mesh_path, const std::string& folder);

}  // namespace sinew
#endif
