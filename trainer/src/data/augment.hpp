// SPDX-License-Identifier: MIT
// Changed copies of a training character, whose features are then computed anew.
#ifndef SINEW_TRAINER_DATA_AUGMENT_HPP
#define SINEW_TRAINER_DATA_AUGMENT_HPP

#include <cstdint>

#include "sinew_formats/character.hpp"

namespace sinew {

constexpr uint32_t kAugmentVersion = 3;  // part of the cache key: grows whenever augment() changes

// Turned about the up axis (Y) by any angle, perhaps mirrored in X, stretched by 0.8..1.2 per axis, vertices and
// joints jittered, for two seeds in five decimated to 0.4..0.9 of its vertices, and for one in five, with at most 1,500
// vertices, subdivided once. Weights follow their vertices.
// Perhaps with a thinner skeleton (joints removed, their weights given to the parent; end markers removed), with joints
// that do not deform (a root on the floor, controls, end markers) and in another rest pose (posed by its own weights).
// Vertices or joints at the same position stay at the same position. The same seed gives the same character. What only
// writers need (UVs, materials) is dropped.
Character augment(const Character& character, uint64_t seed);

}  // namespace sinew
#endif
