// SPDX-License-Identifier: MIT
// Finds the up axis and the front of a mesh: by the network of the front, then by the mesh's mirror plane at any
// angle.
#ifndef SINEW_FRONT_FRONT_HPP
#define SINEW_FRONT_FRONT_HPP

#include "front/front_points.hpp"
#include "front/turn.hpp"
#include "network/network.hpp"

namespace sinew::rigging {

// The network's output for one candidate of up.
struct FrontAnswer {
  int64_t x = 0, z = 0;  // the front in the plane of the floor, Q15; its length is its certainty
  int32_t upright = 0;   // logit, Q10
};

// The answer of four frames, added up. Scratch is taken from the arena and released.
//   points  [kFrontPoints] of the mesh in its grid
// Returns what run_network() does, or SINEW_ERROR_WORKSPACE.
sinew_status ask_front(const sinew_model& model, const NetworkOptions& options, const Kernels& kernels,
                       const SurfacePoint* points, uint32_t up_axis, Arena& arena, FrontAnswer* answer);

struct FrontQuestion {
  const sinew_model* model = nullptr;
  NetworkOptions network;
  uint32_t up_axis = 0;
  bool find_up = false;
  bool axes_known = false;  // y is up and +z front by the file
};

struct Front {
  Turn turn;
  bool clear = false;  // the answer is taken; else the votes choose
  float confidence = 0, up_confidence = 1;
};

// How likely a front is within 60 degrees. A mesh without a mirror plane leans, and a long answer says less of it.
//   reach  how much farther the answer reaches to this end than to the other, Q15
float front_likelihood(int64_t reach, bool mirrored);

// The front of a mesh in a grid with the caller's y up, or with up_axis up if find_up is false. Returns as
// ask_front().
sinew_status find_front(const FrontQuestion& question, const Kernels& kernels, const Mesh& mesh, Arena& arena,
                        Front* front);

}  // namespace sinew::rigging
#endif
