// SPDX-License-Identifier: MIT
// The caller's mesh with y up and front +z in the grid, and where that was in the caller's axes.
#ifndef SINEW_FRONT_UPRIGHT_MESH_HPP
#define SINEW_FRONT_UPRIGHT_MESH_HPP

#include "front/front.hpp"

namespace sinew::rigging {

// The caller's options of up and front.
struct FrontPlan {
  sinew_model model = {};  // without bytes: nothing is found
  NetworkOptions network;
  uint32_t up_axis = 0;
  bool find_up = false, axes_known = false;
  uint32_t given = SINEW_FRONT_AUTO;

  bool asks() const { return model.bytes != nullptr && (given == SINEW_FRONT_AUTO || find_up); }
  bool may_turn() const { return asks() || given != SINEW_FRONT_AUTO; }
};

// Reads and checks the options. Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_MODEL_TASK.
sinew_status plan_front(const sinew_rig_options& options, FrontPlan* plan);

struct UprightMesh {
  sinew_mesh mesh = {};  // the caller's, or with rotated positions
  uint32_t up_axis = 0;  // of `mesh`
  GridQuantizer quantizer;
  Front front;
  bool known = false;  // the front was given, or found with certainty
};

// Builds the mesh in the grid, allocated beforehand. The rotated positions stay in the arena. Returns what
// build_mesh() and find_front() do, and SINEW_ERROR_NOT_FINITE.
sinew_status stand_upright(const FrontPlan& plan, const sinew_mesh& input, const Counts& counts, const Kernels& kernels,
                           Arena& arena, Mesh* mesh, UprightMesh* upright);

// Fills sinew_rig_outputs, the skeleton facing along `quarters` of the upright mesh (MirrorFrame) with its plane at
// `plane` across that.
void write_front(const UprightMesh& upright, uint32_t quarters, double plane, sinew_rig_outputs* outputs);

}  // namespace sinew::rigging
#endif
