// SPDX-License-Identifier: MIT
// Weights of all points to one direction, and how far that is from the front.
#include "run/front_loss.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_formats/error.hpp"

namespace sinew {

using namespace rigging;

FrontLoss front_loss(const FrontSample& sample, const std::vector<float>& outputs, std::vector<float>* d_outputs) {
  if (outputs.size() != size_t{sample.vertices} * kFrontOutputs)
    throw Error(sample.name + ": the network's output is not that of fronts");
  const double count = sample.vertices;
  FrontLoss loss;
  double logit = 0;
  for (size_t i = 0; i < sample.vertices; ++i) {
    const float* const row = &outputs[i * kFrontOutputs];
    for (size_t axis = 0; axis < 2; ++axis) {
      loss.answer[axis] +=
          (kFrontPositionScale * static_cast<double>(row[kFrontPosition] * sample.positions[2 * i + axis]) +
           kFrontNormalScale * static_cast<double>(row[kFrontNormalShare] * sample.normals[2 * i + axis])) /
          count;
    }
    logit += static_cast<double>(row[kFrontUpright]) / count;
  }
  const double target = sample.upright ? 1 : 0;
  loss.upright = std::log1p(std::exp(-std::fabs(logit))) + std::max(logit, 0.0) - target * logit;
  const double d_logit = kUprightShare * (1 / (1 + std::exp(-logit)) - target);
  const std::array<double, 2> front = {static_cast<double>(sample.front[0]), static_cast<double>(sample.front[1])};
  std::array<double, 2> d_answer{};
  if (sample.upright) {
    const double size = std::hypot(loss.answer[0], loss.answer[1]);
    const double cut = size > kLongestFront ? kLongestFront / size : 1;
    double radial = 0;  // of the gradient, which a cut answer has none of
    for (size_t axis = 0; axis < 2; ++axis) {
      const double e = cut * loss.answer[axis] - front[axis];
      loss.front += e * e;
      d_answer[axis] = 2 * cut * e;
      radial += d_answer[axis] * loss.answer[axis] / std::max(size, 1e-12);
    }
    for (size_t axis = 0; axis < 2 && cut < 1; ++axis) d_answer[axis] -= radial * loss.answer[axis] / size;
    const double cosine = (loss.answer[0] * front[0] + loss.answer[1] * front[1]) / std::max(size, 1e-12);
    loss.angle = 0.5 * (1 - cosine);
  }
  loss.total = loss.front + kUprightShare * loss.upright;
  if (d_outputs == nullptr) return loss;
  d_outputs->assign(outputs.size(), 0.0f);
  for (size_t i = 0; i < sample.vertices; ++i) {
    float* const row = &(*d_outputs)[i * kFrontOutputs];
    double position = 0, normal = 0;
    for (size_t axis = 0; axis < 2; ++axis) {
      position += d_answer[axis] * static_cast<double>(sample.positions[2 * i + axis]);
      normal += d_answer[axis] * static_cast<double>(sample.normals[2 * i + axis]);
    }
    row[kFrontPosition] = static_cast<float>(kFrontPositionScale * position / count);
    row[kFrontNormalShare] = static_cast<float>(kFrontNormalScale * normal / count);
    row[kFrontUpright] = static_cast<float>(d_logit / count);
  }
  return loss;
}

}  // namespace sinew
