// SPDX-License-Identifier: MIT
// Votes: Laplace likelihood of both ends of a point's bone, and cross entropy of their classes. Slots: mean absolute errors of
// joint vectors and of the connection matrix. Front: weights of all points to one direction, and how far that is from the front.
#include "run/rig_loss.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "network/slot_network.hpp"
#include "sinew_formats/error.hpp"
#include "votes/rig_task.hpp"

namespace sinew {
namespace {

using namespace rigging;

constexpr double kClassShare = 0.3, kSmoothing = 0.05, kLog2 = 0.6931471805599453;

// distance / b + log b for b = 2^log2_spread, of an offset in units of 1 / kRigOffsetScale.
struct Ends {
  double loss = 0, distance = 0;
};
Ends end_loss(const float* medial, const float* target, const float* offset, float log2_spread, double weight,
              float* d_offset, float* d_spread) {
  double e[3], squared = 1e-6;
  for (int i = 0; i < 3; ++i) {
    e[i] = static_cast<double>(target[i] - medial[i]) - static_cast<double>(offset[i]) / kRigOffsetScale;
    squared += e[i] * e[i];
  }
  const double distance = std::sqrt(squared);
  const double log2_b = std::clamp(static_cast<double>(log2_spread), static_cast<double>(kRigLeastSpread), 0.0);
  const double over = distance * std::exp2(-log2_b);
  if (d_offset != nullptr) {
    for (int i = 0; i < 3; ++i)
      d_offset[i] = static_cast<float>(-weight * e[i] / distance * std::exp2(-log2_b) / kRigOffsetScale);
    const bool inside = log2_spread > static_cast<float>(kRigLeastSpread) && log2_spread < 0;
    *d_spread = inside ? static_cast<float>(weight * kLog2 * (1 - over)) : 0.0f;
  }
  return {over + kLog2 * log2_b, distance};
}

double class_loss(const float* logits, uint32_t count, uint32_t target, double weight, float* d_logits) {
  double most = -1e30, sum = 0, mean = 0;
  for (uint32_t c = 0; c < count; ++c) most = std::max(most, static_cast<double>(logits[c]) * kLog2);
  for (uint32_t c = 0; c < count; ++c) {
    sum += std::exp(static_cast<double>(logits[c]) * kLog2 - most);
    mean += static_cast<double>(logits[c]) * kLog2 / count;
  }
  const double log_sum = most + std::log(sum);
  if (d_logits != nullptr) {
    for (uint32_t c = 0; c < count; ++c) {
      const double p = std::exp(static_cast<double>(logits[c]) * kLog2 - log_sum);
      const double want = kSmoothing / count + (c == target ? 1 - kSmoothing : 0);
      d_logits[c] = static_cast<float>(weight * kLog2 * (p - want));
    }
  }
  return log_sum - (1 - kSmoothing) * static_cast<double>(logits[target]) * kLog2 - kSmoothing * mean;
}

}  // namespace

RigLoss rig_loss(const RigSample& sample, const std::vector<float>& outputs, std::vector<float>* d_outputs) {
  const size_t n = sample.vertices;
  if (outputs.size() != n * kRigOutputs) throw Error(sample.name + ": the network's output is not that of votes");
  if (d_outputs != nullptr) d_outputs->assign(outputs.size(), 0.0f);
  const std::vector<float>& class_weight = sample.class_weight.empty() ? sample.weight : sample.class_weight;
  const auto sum = [](const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0,
                           [](double s, float w) { return s + static_cast<double>(w); });
  };
  const double weights = std::max(sum(sample.weight), 1e-9), class_weights = sum(class_weight);
  RigLoss loss;
  if (class_weights <= 0) return loss;
  for (size_t i = 0; i < n; ++i) {
    const double w = static_cast<double>(sample.weight[i]) / weights;
    const double v = static_cast<double>(class_weight[i]) / class_weights;
    const float* const out = &outputs[i * kRigOutputs];
    float* const d = d_outputs != nullptr ? d_outputs->data() + i * kRigOutputs : nullptr;
    const auto at = [&](uint32_t channel) { return d != nullptr ? d + channel : nullptr; };
    const Ends start = end_loss(&sample.medial[3 * i], &sample.start[3 * i], out + kRigStart, out[kRigStartSpread], w,
                                at(kRigStart), at(kRigStartSpread));
    const Ends end = end_loss(&sample.medial[3 * i], &sample.end[3 * i], out + kRigEnd, out[kRigEndSpread], w,
                              at(kRigEnd), at(kRigEndSpread));
    loss.start += w * start.loss;
    loss.end += w * end.loss;
    loss.start_distance += w * start.distance;
    loss.end_distance += w * end.distance;
    if (sample.start_class[i] != kClassOther)
      loss.start_class += v * class_loss(out + kRigStartClass, kJointClasses, sample.start_class[i], v * kClassShare,
                                         at(kRigStartClass));
    if (sample.end_class[i] != kClassOther)
      loss.end_class +=
          v * class_loss(out + kRigEndClass, kEndClasses, sample.end_class[i], v * kClassShare, at(kRigEndClass));
  }
  loss.total = loss.start + loss.end + kClassShare * (loss.start_class + loss.end_class);
  return loss;
}

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
