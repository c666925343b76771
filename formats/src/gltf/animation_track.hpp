// SPDX-License-Identifier: MIT
// One sampler of a glTF animation, and its value at any time.
#ifndef SINEW_FORMATS_GLTF_ANIMATION_TRACK_HPP
#define SINEW_FORMATS_GLTF_ANIMATION_TRACK_HPP

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "gltf/gltf_model.hpp"

namespace sinew {

enum class Blend { kLinear, kStep, kCubic };

// Keys and values of `width` numbers, with tangents where it is cubic.
struct Track {
  Blend blend = Blend::kLinear;
  size_t width = 3;
  std::vector<float> times, values;

  // The value of key k; of a cubic track the tangent before it (part 0), the value (1), the tangent behind it (2).
  double at(size_t k, size_t part, size_t i) const {
    const size_t row = blend == Blend::kCubic ? 3 * k + part : k;
    return static_cast<double>(values[row * width + i]);
  }
  // The first four numbers of key k.
  std::array<double, 4> key(size_t k) const;
  // Rotations, of width 4, go along the shortest arc; they are not normalized where the track is cubic.
  std::array<double, 4> sample(double seconds) const;
};

// Throws Error naming `where` for another interpolation, a count that does not fit, and times that fall.
Track read_track(const std::string& where, const tinygltf::Model& model, const tinygltf::AnimationSampler& sampler,
                 size_t width);

}  // namespace sinew
#endif
