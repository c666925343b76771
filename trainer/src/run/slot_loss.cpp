// SPDX-License-Identifier: MIT
// Mean absolute errors of joint vectors and of the connection matrix.
#include "run/slot_loss.hpp"

#include <cmath>
#include <numeric>

#include "network/slot_network.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

using namespace rigging;

SlotLoss slot_loss(const SlotSample& sample, const SlotLossOptions& options, const std::vector<float>& outputs,
                   std::vector<float>* d_outputs) {
  if (outputs.size() != kSlotOutputs) throw Error(sample.name + ": the network's output is not that of slots");
  if (d_outputs != nullptr) d_outputs->assign(outputs.size(), 0.0f);
  const double balance = options.balance;
  // Adds a share of |output - target| to the sum.
  const auto absolute = [&](size_t output, double target, double share, double weight, double* sum) {
    const double e = static_cast<double>(outputs[output]) - target;
    *sum += share * std::fabs(e);
    if (d_outputs != nullptr && e != 0) (*d_outputs)[output] = static_cast<float>(weight * share * (e > 0 ? 1 : -1));
  };
  SlotLoss loss;
  const double held = std::accumulate(sample.present.begin(), sample.present.end(), 0.0);
  const double numbers = 4 * held + kSlots;
  const double of_presence = options.balanced ? kPresenceShare / kSlots : 1 / numbers,
               of_number = options.balanced ? 1 / (4 * held) : 1 / numbers;
  for (uint32_t i = 0; i < kSlots; ++i) {
    const size_t at = size_t{i} * kSlotNumbers;
    absolute(at + kSlotPresence, sample.present[i], of_presence, balance, &loss.joints);
    loss.presence += (outputs[at + kSlotPresence] > 0.5f) != (sample.present[i] != 0) ? 1.0 / kSlots : 0;
    if (sample.present[i] == 0) continue;
    double squared = 0;
    for (uint32_t c = 0; c <= kSlotOffset; ++c) {
      const double target = static_cast<double>(sample.joints[4 * i + c]);
      absolute(at + c, target, of_number, balance, &loss.joints);
      const double e = static_cast<double>(outputs[at + c]) - target;
      squared += c < kSlotOffset ? e * e : 0;
    }
    loss.distance += std::sqrt(squared) / held;
  }
  const double connected = std::accumulate(sample.connected.begin(), sample.connected.end(), 0.0);
  const double all = 0.5 * held * (held - 1), apart = all - connected;
  for (uint32_t i = 0; i < kSlots; ++i) {
    for (uint32_t j = i + 1; j < kSlots; ++j) {
      if (sample.present[i] == 0 || sample.present[j] == 0) continue;
      const uint32_t pair = slot_pair(i, j);
      const double share = options.balanced ? 0.5 / (sample.connected[pair] != 0 ? connected : apart) : 1 / all;
      absolute(size_t{kSlots} * kSlotNumbers + pair, sample.connected[pair], share, 1 - balance, &loss.connections);
    }
  }
  loss.total = balance * loss.joints + (1 - balance) * loss.connections;
  return loss;
}

}  // namespace sinew
