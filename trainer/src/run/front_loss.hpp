// SPDX-License-Identifier: MIT
// What the network of the front is to make small.
#ifndef SINEW_TRAINER_RUN_FRONT_LOSS_HPP
#define SINEW_TRAINER_RUN_FRONT_LOSS_HPP

#include <array>
#include <vector>

#include "data/front_sample.hpp"

namespace sinew {

struct FrontLoss {
  double total = 0;    // of an upright sample front, and kUprightShare upright
  double front = 0;    // squared distance of the answer, cut to the length kLongestFront, from the true front
  double upright = 0;  // cross entropy
  double angle = 0;  // (1 - cosine) / 2 of the answer, 1 where it is exactly behind; 0 of samples that are not upright
  std::array<double, 2> answer{};
};
constexpr double kUprightShare = 0.3, kLongestFront = 1.5;

//   outputs    in   [N x kFrontOutputs]
//   d_outputs  out  gradient of the total; may be null
FrontLoss front_loss(const FrontSample& sample, const std::vector<float>& outputs, std::vector<float>* d_outputs);

}  // namespace sinew
#endif
