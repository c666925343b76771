// SPDX-License-Identifier: MIT
// Gradient steps of the trainer. Everything runs in one fixed order, so a step gives the same bytes every time.
#include "run/optimizer.hpp"

#include <algorithm>
#include <cmath>

namespace sinew {

double clip_gradients(std::vector<LinearBlock<float>>* gradients, double limit) {
  double sum = 0;
  for (const LinearBlock<float>& block : *gradients) {
    for (float g : block.weights) sum += static_cast<double>(g) * static_cast<double>(g);
    for (float g : block.bias) sum += static_cast<double>(g) * static_cast<double>(g);
  }
  const double norm = std::sqrt(sum);
  if (limit > 0 && norm > limit) {
    const float scale = static_cast<float>(limit / norm);
    for (LinearBlock<float>& block : *gradients) {
      for (float& g : block.weights) g *= scale;
      for (float& g : block.bias) g *= scale;
    }
  }
  return norm;
}

double schedule(double progress) {
  constexpr double kWarmUp = 0.02, kFloor = 0.01, kPi = 3.14159265358979323846;
  const double p = std::clamp(progress, 0.0, 1.0);
  // Not from zero: the first step shall move.
  if (p < kWarmUp) return 0.1 + 0.9 * p / kWarmUp;
  return kFloor + (1 - kFloor) * 0.5 * (1 + std::cos(kPi * (p - kWarmUp) / (1 - kWarmUp)));
}

void optimizer_step(const RunConfig& config, double learning_rate, const std::vector<LinearBlock<float>>& gradients,
                    FloatNetwork* network, TrainingState* state) {
  const bool sgd = config.optimizer == "sgd", decoupled = config.optimizer == "adamw";
  if (state->adam_m.empty()) {
    for (const LinearParameters& p : network->parameters) {
      state->adam_m.emplace_back(p.weights.size() + p.bias.size(), 0.0f);
      state->adam_v.emplace_back(sgd ? 0 : p.weights.size() + p.bias.size(), 0.0f);
    }
  }
  constexpr float kBeta1 = 0.9f, kBeta2 = 0.999f, kEpsilon = 1e-8f;
  const double t = static_cast<double>(state->step + 1);
  const float correction1 = static_cast<float>(1.0 / (1.0 - std::pow(static_cast<double>(kBeta1), t)));
  const float correction2 = static_cast<float>(1.0 / (1.0 - std::pow(static_cast<double>(kBeta2), t)));
  const float rate = static_cast<float>(learning_rate);
  const float momentum = static_cast<float>(config.momentum);

  const auto update = [&](float* values, const float* g, size_t count, float* m, float* v, float decay) {
    const float keep = decoupled ? 1.0f - rate * decay : 1.0f;
    const float coupled = decoupled ? 0.0f : decay;
    for (size_t i = 0; i < count; ++i) {
      const float gradient = g[i] + coupled * values[i];
      if (sgd) {
        m[i] = momentum * m[i] + gradient;
        values[i] -= rate * m[i];
      } else {
        m[i] = kBeta1 * m[i] + (1 - kBeta1) * gradient;
        v[i] = kBeta2 * v[i] + (1 - kBeta2) * gradient * gradient;
        values[i] = keep * values[i] - rate * (m[i] * correction1) / (std::sqrt(v[i] * correction2) + kEpsilon);
      }
    }
  };
  for (size_t block = 0; block < network->parameters.size(); ++block) {
    LinearParameters& p = network->parameters[block];
    float* m = state->adam_m[block].data();
    float* v = state->adam_v[block].data();
    const size_t weights = p.weights.size();
    update(p.weights.data(), gradients[block].weights.data(), weights, m, v, static_cast<float>(config.weight_decay));
    update(p.bias.data(), gradients[block].bias.data(), p.bias.size(), m + weights, sgd ? v : v + weights, 0.0f);
  }
}

void update_average(const FloatNetwork& network, double decay, uint64_t step, FloatNetwork* average) {
  const double t = static_cast<double>(step);
  blend(network, 1.0 - std::min(decay, (1.0 + t) / (10.0 + t)), average);
}

void blend(const FloatNetwork& from_network, double share_of_from, FloatNetwork* to_network) {
  const float share = static_cast<float>(share_of_from);
  for (size_t block = 0; block < from_network.parameters.size(); ++block) {
    const LinearParameters& from = from_network.parameters[block];
    LinearParameters& to = to_network->parameters[block];
    for (size_t i = 0; i < from.weights.size(); ++i) to.weights[i] += share * (from.weights[i] - to.weights[i]);
    for (size_t i = 0; i < from.bias.size(); ++i) to.bias[i] += share * (from.bias[i] - to.bias[i]);
  }
}

}  // namespace sinew
