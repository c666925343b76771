// SPDX-License-Identifier: MIT
// Laplace likelihood of both ends of a point's bone, and cross entropy of their classes.
#include "run/rig_loss.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

}  // namespace sinew
