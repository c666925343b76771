// SPDX-License-Identifier: MIT
// A skeleton for a bare mesh: the stages of sinew_rig().
#ifndef SINEW_RIG_RIG_HPP
#define SINEW_RIG_RIG_HPP

#include <stddef.h>

#include "core/counts.hpp"
#include "front/mirror_frame.hpp"
#include "front/upright_mesh.hpp"
#include "rig/published.hpp"
#include "votes/point_voter.hpp"
#include "votes/rig_task.hpp"

namespace sinew::rigging {

// Sets of points, each a run of the network; their votes are counted together. One gives joints that are 3 % worse, eight none
// that are better.
constexpr uint32_t kRigSets = 4;

// The struct of the first release, 0.1.
constexpr uint32_t kFirstRigOptionsSize = offsetof(sinew_rig_options, progress_user) + sizeof(void*);

struct RigPlan {
  sinew_model model;
  Counts counts;
  NetworkOptions network;
  RigOptions tree;
  Mirroring mirroring = Mirroring::kAuto;
  uint32_t method = SINEW_RIG_VOTES;
  SlotsPlan slots;  // with SINEW_RIG_SLOTS
  FrontPlan front;
  uint32_t up_axis = 0, kernel = 0;  // up where it is not found
  Progress progress;
  OtherNetwork other;  // of a body's points; the model still says what memory it takes
};

// Checks the caller's options and counts, and fills in the defaults. A model of another feature set is one for another
// task. Errors are those of sinew_rig().
sinew_status plan_rig(const sinew_model* model, uint32_t vertices, uint32_t faces, uint32_t corners,
                      const sinew_rig_options* options, RigPlan* plan, uint32_t feature_set = kRigFeatureSet);

// Runs everything; the caller's arrays in `outputs` are written at the end. With a measuring arena the mesh is not read.
sinew_status run_rig(const RigPlan& plan, const sinew_mesh& mesh, const Kernels& kernels, Arena& arena,
                     sinew_rig_outputs* outputs);

}  // namespace sinew::rigging
#endif
