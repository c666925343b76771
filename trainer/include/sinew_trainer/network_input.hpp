// SPDX-License-Identifier: MIT
// A sample as the engine's network sees it: for programs that run the int16 network beside the float one.
#ifndef SINEW_TRAINER_NETWORK_INPUT_HPP
#define SINEW_TRAINER_NETWORK_INPUT_HPP

#include <string>
#include <vector>

#include "kernels/select.hpp"
#include "network/network.hpp"
#include "sinew/sinew.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_trainer/network_sample.hpp"

namespace sinew {

// Views of the sample, which must outlive them.
inline NetworkInput network_input(const NetworkSample& sample) {
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

// Bytes that run_network() needs for the sample.
inline size_t network_workspace(const sinew_model& model, const NetworkSample& sample,
                                const NetworkOptions& options = {}) {
  Arena measuring;
  (void)run_network(model, network_input(sample), Kernels(), {}, measuring, nullptr, options);
  return measuring.high_water();
}

// What the engine's network writes for the sample: `count` numbers, by the kernel of the environment. Throws Error with the sample's
// name.
inline std::vector<int16_t> engine_rows(const sinew_model& model, const NetworkSample& sample, size_t count) {
  Kernels kernels;
  if (!select_kernels(kernel_from_environment(), &kernels)) throw Error(sinew_status_text(SINEW_ERROR_KERNEL));
  const Workspace block(network_workspace(model, sample));
  Arena arena(block.data(), block.size());
  std::vector<int16_t> rows(count);
  const sinew_status status = run_network(model, network_input(sample), kernels, {}, arena, rows.data());
  if (status != SINEW_OK) throw Error(sample.name + ": " + sinew_status_text(status));
  return rows;
}

}  // namespace sinew
#endif
