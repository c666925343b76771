// SPDX-License-Identifier: MIT
// A whole bind: the caller's options, checked and with their defaults filled in, and the stages one after the other. The
// plan holds all that the size query needs: the size of the workspace is a function of the plan alone.
#ifndef SINEW_BIND_BIND_HPP
#define SINEW_BIND_BIND_HPP

#include "bind/pipeline.hpp"
#include "model/task.hpp"
#include "network/network.hpp"
#include "weights/finish.hpp"

namespace sinew {

// Vertices above which a mesh is reduced unless the caller says otherwise.
constexpr uint32_t kSurfaceVertices = 32768;

struct BindPlan {
  Counts counts;
  bool with_network;  // rows come from the network, else from the heat field
  bool by_distance;   // or from distances
  sinew_model model;  // valid with_network
  NetworkOptions network;
  uint32_t kernel;   // sinew_kernel that the caller wants
  uint32_t up_axis;  // of the skeleton, set by the caller of plan_bind(): 0 = Y, 1 = Z
  RowOptions rows;
  Progress progress;

  // make_parts_soft() is all that reads candidates or heat fields after the features.
  PreparePurpose purpose() const {
    if (!with_network) return by_distance ? PreparePurpose::kDistance : PreparePurpose::kHeat;
    return rows.reads_heat() ? PreparePurpose::kNetwork : PreparePurpose::kNetworkAlone;
  }
};

// Makes the plan for a mesh of `vertices`, `faces` and `corners` and a skeleton of `joints`.
//   options  as the caller gave them, of any version, or null: all defaults
// Returns SINEW_OK; SINEW_ERROR_ARGUMENT where an option is out of range, is not in this build or contradicts the
// model, or the model is missing; SINEW_ERROR_VERSION where an option is set that this library does not know;
// SINEW_ERROR_COUNT where a count is out of range.
sinew_status plan_bind(const sinew_model* model, uint32_t vertices, uint32_t faces, uint32_t corners, uint32_t joints,
                       const sinew_bind_options* options, BindPlan* plan);

// The task of the networks that predict skin weights: vertex and pair features of that set, and one logit per pair.
// False for a set or a flag that this build does not have.
bool bind_task(uint32_t feature_set, ModelTask* task);

// Runs the stages of a plan in the workspace and writes the outputs. Arguments as in sinew_bind(), already checked
// except for the contents of arrays. Outputs are written after the last step that can fail.
//   outputs  the library's own struct, with the caller's arrays
sinew_status run_bind(const BindPlan& plan, const sinew_mesh& mesh, const sinew_skeleton& skeleton, void* workspace,
                      size_t workspace_bytes, sinew_bind_outputs* outputs);
// Takes from a measuring arena what run_bind() takes of its workspace. Asks neither for the processor nor for progress.
void measure_bind(Arena& arena, const BindPlan& plan);

}  // namespace sinew
#endif
