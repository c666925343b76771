// SPDX-License-Identifier: MIT
// User edits of a predicted skeleton before binding.
#ifndef SINEW_CHARACTER_EDIT_SKELETON_HPP
#define SINEW_CHARACTER_EDIT_SKELETON_HPP

#include <string>
#include <vector>

#include "sinew_character/predict/predict_skeleton.hpp"

namespace sinew {

enum class EditKind { kMove, kAdd, kRemove, kParent, kRename, kAt };

struct SkeletonEdit {
  EditKind kind = EditKind::kMove;
  std::string joint;  // name of the joint; kAdd: of the new joint
  std::string other;  // kAdd: its parent; kParent: the new parent; kRename: the new name
  Vec3 position;      // kMove, kAdd, kAt: in the mesh's units
};

// Parses JOINT=X,Y,Z (move, at), NAME=PARENT:X,Y,Z (add), JOINT (remove), JOINT=OTHER (parent, rename). Throws Error
// with the text.
SkeletonEdit parse_edit(EditKind kind, const std::string& text);

// Applies edits in order. If the skeleton is symmetric and `mirror` is set, it stays symmetric:
//   move    the partner moves to the mirror image of the position; a joint on the plane stays on it. Bone ends move with their joints, nothing else moves
//   add     a joint below one that has a partner, or with a side in its name, gets a partner, named for the other side
//   remove  a joint's children move to its parent, its bone ends are removed too; for a root, the first child on the plane, or the first child, becomes the root. Its partner is removed too
//   parent  the partner gets the parent's partner. A descendant as the parent is an error
//   at      like move; a joint that was not found is added, with the missing joints between it and the body
//   rename  with a side in the new name the partner is named for the other side; bone ends follow: NAME_end
// Parents come first in the result. New joints deform, their confidence is 1, their class other (a bone end's: its
// parent's). On an Error (an unknown joint, with similar names; a duplicate name; a cycle; no joint left) the
// skeleton is unchanged.
void edit_skeleton(const std::vector<SkeletonEdit>& edits, bool mirror, PredictedSkeleton* skeleton);

// Returns the joints to add for a marker (kAt) whose joint does not exist: that joint, and the missing ones between
// it and the body, at their usual proportions. Throws Error for a name outside the known chains, or a skeleton
// without the chain's parent.
std::vector<SkeletonEdit> marker_edits(const std::vector<Joint>& joints, const SkeletonEdit& marker);

}  // namespace sinew
#endif
