// SPDX-License-Identifier: MIT
// The engine's integer network on a sample, and its noise against the float network.
#include "sinew_trainer/engine_network.hpp"

#include <cmath>

#include "kernels/select.hpp"
#include "sinew/sinew.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

NetworkInput network_input(const NetworkSample& sample) {
  NetworkInput input;
  input.vertex_count = sample.vertices;
  input.candidate_count = sample.candidates;
  for (size_t i = 0; i < sample.inputs.size(); ++i) input.inputs[i] = sample.inputs[i].rows.data();
  input.joints = sample.candidate.data();
  input.row_offsets = sample.row_offsets.data();
  input.col_indices = sample.col_indices.data();
  input.far_offsets = sample.far_offsets.data();
  input.far_indices = sample.far_indices.data();
  input.part = sample.part.data();
  input.part_offsets = sample.part_offsets.data();
  input.part_vertices = sample.part_vertices.data();
  input.part_count = sample.part_count;
  input.joint_count = sample.joints;
  return input;
}

size_t network_workspace(const sinew_model& model, const NetworkSample& sample, const NetworkOptions& options) {
  Arena measuring;
  (void)run_network(model, network_input(sample), Kernels(), {}, measuring, nullptr, options);
  return measuring.high_water();
}

std::vector<int16_t> engine_rows(const sinew_model& model, const NetworkSample& sample, size_t count) {
  Kernels kernels;
  if (!select_kernels(kernel_from_environment(), &kernels)) throw Error(sinew_status_text(SINEW_ERROR_KERNEL));
  const Workspace block(network_workspace(model, sample));
  Arena arena(block.data(), block.size());
  std::vector<int16_t> rows(count);
  const sinew_status status = run_network(model, network_input(sample), kernels, {}, arena, rows.data());
  if (status != SINEW_OK) throw Error(sample.name + ": " + sinew_status_text(status));
  return rows;
}

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
