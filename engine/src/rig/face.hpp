// SPDX-License-Identifier: MIT
// Eyes and a jaw for the heads of a skeleton: the stages of sinew_rig_face().
#ifndef SINEW_RIG_FACE_HPP
#define SINEW_RIG_FACE_HPP

#include "rig/given_skeleton.hpp"
#include "rig/rig.hpp"

namespace sinew {

// Balls that lie like eyes, turned to face +z (MirrorFrame::turn), grid units.
struct Eyes {
  Vec3i at[2] = {};  // of the balls' middles: left (+x) and right
  int32_t size = 0;  // across a ball; 0: there are none
};
// The two loose parts of `mesh` that are most like the eyes of head joint `head`: round, of one size, side by side, nearest
// to the head's own bone and in front of it. A ball that lacks its back is taken for a whole one.
Eyes find_eyes(const Mesh& mesh, const GivenSkeleton& skeleton, uint32_t head);

// Where a jaw turns, and the chin.
struct Jaw {
  Vec3i at = {}, chin = {};
  bool found = false;
};
// Below and behind the eyes by their distance, as people's are; none where the head does not stand upright or has no
// surface where a chin would be.
Jaw find_jaw(const Mesh& mesh, const GivenSkeleton& skeleton, uint32_t head, const Eyes& eyes);

// Runs everything; `outputs` is a skeleton that becomes one with a face, at the end. With a measuring arena neither mesh nor
// skeleton is read. Errors are those of sinew_rig_face().
sinew_status run_face(const RigPlan& plan, const sinew_mesh& mesh, Arena& arena, sinew_rig_outputs* outputs);

}  // namespace sinew
#endif
