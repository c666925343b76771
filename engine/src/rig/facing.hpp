// SPDX-License-Identifier: MIT
// Which of a few directions a mesh faces, by where the votes are surest.
#ifndef SINEW_RIG_FACING_HPP
#define SINEW_RIG_FACING_HPP

#include "rig/point_voter.hpp"
#include "rig/rig.hpp"

namespace sinew::rigging {

// Finds the mirror frame of a mesh that stands upright, and brings the mesh into it. False if the arena is full.
bool place_frame(const RigPlan& plan, const UprightMesh& upright, Arena& arena, Mesh* mesh, MirrorFrame* frame);

// Turns the mesh to where the votes are surest: front and back of a mirrored mesh, all four sides of another. Other ways than
// the one that it has must be better by a gain. The voter keeps the interior of the way that was chosen, and where that
// is the way that the mesh had, what set 0 said there.
sinew_status choose_facing(const RigPlan& plan, const Kernels& kernels, Arena& arena, PointVoter* voter,
                           MirrorFrame* frame, Mesh* mesh, bool* turned);

// The found front of a mesh that no plane mirrors is off by up to 30 degrees: it is turned in steps of 15 degrees for as long
// as the votes of one set get surer, at most two. Nothing is done where the front is a coin toss or the mesh is mirrored.
// On return mesh, `upright` and `frame` are those of the chosen front. Returns what stand_upright() and the network do.
sinew_status refine_front(const RigPlan& plan, const sinew_mesh& input, const Kernels& kernels, Arena& arena,
                          Mesh* mesh, UprightMesh* upright, MirrorFrame* frame);

}  // namespace sinew::rigging
#endif
