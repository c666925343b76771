// SPDX-License-Identifier: MIT
// Training samples of where a mesh faces: points of a character's surface in a frame of their own, with its true front.
#ifndef SINEW_TRAINER_DATA_FRONT_SAMPLE_HPP
#define SINEW_TRAINER_DATA_FRONT_SAMPLE_HPP

#include <array>
#include <vector>

#include "data/rig_sample.hpp"
#include "front/front_points.hpp"

namespace sinew {

// N = kFrontPoints points. Vectors lie in the floor's plane: x and z.
struct FrontSample : NetworkSample {
  std::vector<float> positions;  // [N x 2] from the mean, shares of the longest side
  std::vector<float> normals;    // [N x 2]
  std::array<float, 2> front{};  // unit vector
  bool upright = true;           // false: the mesh lies, and `front` says nothing
};

class FrontSource {
 public:
  // Throws Error as RigSource does, and for a skeleton whose names do not tell left from right, or not where the front is.
  explicit FrontSource(const Character& character);

  // Samples of one copy (RigSource): `upright` upright ones, whose frames take turns, and two that lie. Each has its own points.
  std::vector<FrontSample> make(uint64_t seed, const RigVariant& variant, uint32_t upright = 2) const;
  // As it is, upright, in the first frame.
  FrontSample original(uint64_t seed) const;

  // Where it faces in its mirror frame: x and z.
  const std::array<double, 2>& front() const { return front_; }

 private:
  FrontSample sample(const std::vector<rigging::SurfacePoint>& points, uint32_t frame, bool upright) const;

  RigSource source_;
  std::array<double, 2> front_{};
};

}  // namespace sinew
#endif
