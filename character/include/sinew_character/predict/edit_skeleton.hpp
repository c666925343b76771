// SPDX-License-Identifier: MIT
// What a user changes about a predicted skeleton before the mesh is bound to it.
#ifndef SINEW_CHARACTER_EDIT_SKELETON_HPP
#define SINEW_CHARACTER_EDIT_SKELETON_HPP

#include <string>
#include <vector>

#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

enum class EditKind { kMove, kAdd, kRemove, kParent, kRename, kAt };

struct SkeletonEdit {
  EditKind kind = EditKind::kMove;
  std::string joint;  // which one; kAdd: the new joint's name
  std::string other;  // kAdd: its parent; kParent: the new parent; kRename: the new name
  Vec3 position;      // kMove, kAdd, kAt: in the mesh's units
};

// From JOINT=X,Y,Z (move, at), NAME=PARENT:X,Y,Z (add), JOINT (remove), JOINT=OTHER (parent, rename). Throws Error with the
// text.
SkeletonEdit parse_edit(EditKind kind, const std::string& text);

// Applies edits in their order. Where the skeleton is its own mirror image and `mirror` is set, it stays so:
//   move    the partner goes to the mirror image of the position; a joint on the plane stays on it. Bone ends go along
//           with their joints, nothing else moves
//   add     below a joint that has a partner, or with a side in its name, a joint gets a partner, named for the other side
//   remove  a joint's children go to its parent, its bone ends go with it; of a root, the first child on the plane, or the
//           first, becomes the root. Its partner goes too
//   parent  the partner gets the parent's partner. A parent among what hangs on the joint is refused
//   at      as move; a joint that was not found is added, with those between it and the body that are missing too
//   rename  with a side in the new name the partner is named for the other side; bone ends follow: NAME_end
// Parents come first in the result. New joints deform, their confidence is 1, their class other (a bone end's: its
// parent's). On an Error (a joint that does not exist with those named nearly so, a name that is taken, a cycle, nothing
// left) the skeleton is as it was.
void edit_skeleton(const std::vector<SkeletonEdit>& edits, bool mirror, PredictedSkeleton* skeleton);

// The joints that are to be added for a marker (kAt) that no joint is called like: its own, and those between it and the body that are
// missing too, at their usual shares of the way. Throws Error for a name that no chain has, or a skeleton without what the chain hangs on.
std::vector<SkeletonEdit> marker_edits(const std::vector<Joint>& joints, const SkeletonEdit& marker);

}  // namespace sinew
#endif
