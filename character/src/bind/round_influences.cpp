// SPDX-License-Identifier: MIT
// A row of any length as the engine would have written it.
#include <cmath>

#include "sinew_character/bind/bind.hpp"
#include "weights/influences.hpp"

namespace sinew {

std::vector<Influence> round_influences(const std::vector<Influence>& row, uint32_t keep) {
  double sum = 0;
  for (const Influence& i : row) sum += i.weight;
  std::vector<uint16_t> joints;
  std::vector<uint32_t> weights;
  for (const Influence& i : row) {
    joints.push_back(static_cast<uint16_t>(i.joint));
    // In steps of the result: a row that has only such steps already comes out as it is.
    weights.push_back(sum > 0 ? static_cast<uint32_t>(std::lround(i.weight / sum * 65535.0)) : 0);
  }
  std::vector<Influence> out;
  if (sum <= 0) return out;
  uint16_t kept_joints[SINEW_MAX_INFLUENCES], kept[SINEW_MAX_INFLUENCES];
  keep_largest(joints.data(), weights.data(), static_cast<uint32_t>(joints.size()), keep, 65535, kept_joints, kept);
  for (uint32_t i = 0; i < keep; ++i) {
    if (kept[i] > 0) out.push_back({kept_joints[i], static_cast<float>(kept[i]) / 65535.0f});
  }
  return out;
}

}  // namespace sinew
