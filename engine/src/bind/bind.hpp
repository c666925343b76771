// SPDX-License-Identifier: MIT
// A whole bind: options to a plan, the plan to bytes of workspace, and the run.
#ifndef SINEW_BIND_BIND_HPP
#define SINEW_BIND_BIND_HPP

#include "bind/pipeline.hpp"
#include "network/network.hpp"

namespace sinew {

// Checked options with their defaults filled in.
struct BindPlan {
  Counts counts;
  sinew_model model;  // valid for PrepareFor::kNetwork
  PrepareFor purpose;
  uint32_t influence_count;
  uint32_t up_axis;
  uint32_t weight_format;
  const uint8_t* locked;
  const uint8_t* hints;
  bool symmetric;
  NetworkOptions network;
  uint32_t rigid_parts;
  uint32_t softness_percent;
  Progress progress;
};

// Vertices above which a mesh is reduced unless the caller says otherwise.
constexpr uint32_t kSurfaceVertices = 32768;

// `options` as the caller gave them, of any version, or null. Returns SINEW_OK, SINEW_ERROR_ARGUMENT,
// SINEW_ERROR_VERSION or SINEW_ERROR_COUNT.
sinew_status plan_bind(const sinew_model* model, uint32_t vertices, uint32_t faces, uint32_t corners, uint32_t joints,
                       const sinew_options* options, BindPlan* plan);
void measure_bind(Arena& arena, const BindPlan& plan);
// `outputs` is the library's own struct, with the caller's arrays.
sinew_status run_bind(const BindPlan& plan, const sinew_mesh& mesh, const sinew_skeleton& skeleton, void* workspace,
                      size_t workspace_bytes, sinew_bind_outputs* outputs);

}  // namespace sinew
#endif
