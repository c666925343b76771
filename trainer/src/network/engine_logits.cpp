// SPDX-License-Identifier: MIT
// The engine's integer network on a sample, and its noise against the float network.
#include "sinew_trainer/engine_logits.hpp"

#include <cmath>

#include "sinew_trainer/network_input.hpp"

namespace sinew {

std::vector<float> engine_logits(const sinew_model& model, const Sample& sample) {
  const std::vector<int16_t> logits =
      engine_rows(model, sample, static_cast<size_t>(sample.vertices) * sample.candidates);
  constexpr float kLn2 = 0.69314718056f;
  std::vector<float> natural(logits.size());
  for (size_t i = 0; i < logits.size(); ++i) natural[i] = static_cast<float>(logits[i]) * (kLn2 / 1024.0f);
  return natural;
}

void LogitNoise::add(const Sample& sample, const std::vector<float>& reference, const std::vector<float>& other) {
  const size_t k = sample.candidates;
  for (size_t u = 0; u < sample.vertices; ++u) {
    double mean_reference = 0, mean_other = 0;
    size_t present = 0;
    for (size_t i = u * k; i < (u + 1) * k; ++i) {
      if (sample.candidate[i] == kNoJoint) continue;
      mean_reference += static_cast<double>(reference[i]);
      mean_other += static_cast<double>(other[i]);
      ++present;
    }
    if (present == 0) continue;
    mean_reference /= static_cast<double>(present);
    mean_other /= static_cast<double>(present);
    for (size_t i = u * k; i < (u + 1) * k; ++i) {
      if (sample.candidate[i] == kNoJoint) continue;
      const double s = static_cast<double>(reference[i]) - mean_reference;
      const double e = static_cast<double>(other[i]) - mean_other - s;
      signal += s * s;
      noise += e * e;
    }
  }
}

double LogitNoise::decibels() const { return 10.0 * std::log10((signal + 1e-30) / (noise + 1e-30)); }

}  // namespace sinew
