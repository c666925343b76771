// SPDX-License-Identifier: MIT
// Roles by words, and by who a joint's parents and children are and where it stands. A word that most joints of a rig share
// says nothing about any of them, and what a vertex follows deforms.
#include "names/named_joints.hpp"

namespace sinew::names {
namespace {

constexpr int32_t kMostChildren = 16;    // of a root; what has more is a body
constexpr double kSamePosition = 0.005;  // of the longest side of the skeleton's box

class RoleFinder {
 public:
  explicit RoleFinder(NamedJoints* joints) : s_(*joints) {
    if (s_.positions == nullptr) return;
    for (int axis = 0; axis < 3; ++axis) {
      double low = at(0, axis), high = low;
      for (int32_t j = 1; j < s_.n; ++j) {
        low = at(j, axis) < low ? at(j, axis) : low;
        high = at(j, axis) > high ? at(j, axis) : high;
      }
      if (high - low > side_) side_ = high - low;
    }
  }

  void find() {
    find_roots();
    find_ends();
    find_slots();
    find_controls();
    for (int32_t j = 0; j < s_.n; ++j) {
      if (s_.has_weight(j)) s_.roles[j] = SINEW_ROLE_DEFORMS;
    }
  }

 private:
  bool says(int32_t j, uint32_t bits) const { return s_.names[j].has(bits); }
  bool says_slot(int32_t j) const { return says(j, kSlot) && s_.names[j].part != Part::kEye; }
  double at(int32_t j, int axis) const { return static_cast<double>(s_.positions[3 * j + axis]); }

  // A joint at the top, or below tops alone, that is called one.
  void find_roots() {
    for (int32_t i = 0; i < s_.n; ++i) {
      const int32_t j = s_.order[i], p = s_.parents[j];
      if (p >= 0 && s_.roles[p] != SINEW_ROLE_ROOT) continue;
      const int32_t children = s_.kid_offsets[j + 1] - s_.kid_offsets[j];
      if (s_.names[j].root && children > 0 && children <= kMostChildren && someone_deforms_below(j))
        s_.roles[j] = SINEW_ROLE_ROOT;
    }
  }

  // A rig of one or two joints whose root is called so has nothing else to deform with.
  bool someone_deforms_below(int32_t root) {
    int32_t others = 0;
    mark_below(root);
    for (int32_t j = 0; j < s_.n; ++j)
      others += s_.marks[j] != 0 && !s_.names[j].is_end() && !says(j, kControl) ? 1 : 0;
    return others > 1;
  }

  void mark_below(int32_t top) {
    for (int32_t i = 0; i < s_.n; ++i) {
      const int32_t j = s_.order[i], p = s_.parents[j];
      s_.marks[j] = p >= 0 && (p == top || s_.marks[p] != 0) ? 1 : 0;
    }
  }

  // Marks leaves called ends or without followers as ends; a joint called a tip deforms unless it has no followers.
  void find_ends() {
    for (int32_t j = 0; j < s_.n; ++j) {
      if (!s_.is_leaf(j) || s_.parents[j] < 0 || s_.has_weight(j)) continue;
      if (s_.is_bare(j) || (s_.names[j].is_end() && !has_start(j)) || is_fingertip(j)) s_.roles[j] = SINEW_ROLE_END;
    }
    // thumb_null with thumb_null_end: an end that has got an end.
    for (int32_t j = 0; j < s_.n; ++j) {
      if (!s_.deforms(j) || s_.is_leaf(j) || s_.parents[j] < 0 || !says(j, kNub) || says(j, kControl)) continue;
      bool ends = true;
      each_kid(s_, j, [&](int32_t kid) { ends = ends && s_.is_end(kid); });
      if (ends) s_.roles[j] = SINEW_ROLE_END;
    }
  }

  // tail_start and tail_end are two bones.
  bool has_start(int32_t j) const {
    const JointName &own = s_.names[j], &above = s_.names[s_.parents[j]];
    return above.has(kStart) && own.has(kEnd) && !own.has(kStart) && own.words > 1 &&
           own.first_word == above.first_word;
  }

  // Fingers have three bones: the fourth of LeftHandIndex1 to 4 ends the third.
  bool is_fingertip(int32_t j) const {
    for (int32_t number = 4; number > 0; --number, j = s_.parents[j]) {
      if (j < 0 || s_.names[j].part >= Part::kFingers || s_.names[j].own_number != number) return false;
    }
    return true;
  }

  void find_slots() {
    if (is_habit([&](int32_t j) { return says_slot(j); })) return;
    for (int32_t j = 0; j < s_.n; ++j) {
      if (says_slot(j) && s_.deforms(j) && !leads_to_limb(j, [&](int32_t k) { return says_slot(k); }))
        s_.roles[j] = SINEW_ROLE_SLOT;
    }
  }

  // A word in the names of a third of the joints distinguishes none of them.
  template <class Named>
  bool is_habit(const Named& named) const {
    int32_t count = 0, twins = 0;
    for (int32_t j = 0; j < s_.n; ++j) count += named(j) && !s_.is_end(j) ? 1 : 0;
    if (int64_t{3} * count <= s_.n) return false;
    for (int32_t j = 0; j < s_.n; ++j) twins += named(j) && has_twin(j, named) ? 1 : 0;
    return twins * 2 < count;
  }

  void find_controls() {
    int32_t rigify = 0;
    for (int32_t j = 0; j < s_.n; ++j) rigify += says(j, kDef) ? 1 : 0;
    // Rigify's DEF- joints deform; what stands beside them under another of its prefixes or without one does not.
    const auto named = [&](int32_t j) {
      if (rigify >= 3 && says(j, kDef)) return false;
      return says(j, kControl) || (rigify >= 3 && says(j, kRigify));
    };
    const bool habit = is_habit(named);
    for (int32_t j = 0; j < s_.n; ++j) {
      s_.marks[j] = 0;
      if (!named(j)) continue;
      const int32_t p = s_.parents[j];
      const bool from_top = p < 0 || s_.roles[p] == SINEW_ROLE_ROOT || named(p);
      s_.marks[j] = has_twin(j, named) || (!habit && (from_top || !leads_to_limb(j, named))) ? 1 : 0;
    }
    for (int32_t j = 0; j < s_.n; ++j) {
      if (s_.marks[j] != 0 && (s_.deforms(j) || s_.roles[j] == SINEW_ROLE_SLOT)) s_.roles[j] = SINEW_ROLE_CONTROL;
    }
    // Where two joints of a limb are called FK and IK, a third that stands there deforms.
    for (int32_t j = 0; j < s_.n; ++j) {
      if (s_.deforms(j) && says(j, kFk) && has_twin(j, named)) s_.roles[j] = SINEW_ROLE_CONTROL;
    }
  }

  // Another joint that is none of the named stands at the same position.
  template <class Named>
  bool has_twin(int32_t j, const Named& named) const {
    if (s_.positions == nullptr) return false;
    const double limit = kSamePosition * side_;
    for (int32_t k = 0; k < s_.n; ++k) {
      if (k == j || !s_.deforms(k) || says(k, kFk) || named(k)) continue;
      const double x = at(k, 0) - at(j, 0), y = at(k, 1) - at(j, 1), z = at(k, 2) - at(j, 2);
      if (x * x + y * y + z * z <= limit * limit) return true;
    }
    return false;
  }

  // Down to the first child, else on to the next sibling of the joint or of one above it.
  template <class Named>
  bool leads_to_limb(int32_t top, const Named& named) const {
    int32_t kid = s_.is_leaf(top) ? -1 : s_.kids[s_.kid_offsets[top]];
    while (kid >= 0) {
      if (s_.deforms(kid) && !named(kid)) return true;
      if (!s_.is_leaf(kid)) {
        kid = s_.kids[s_.kid_offsets[kid]];
        continue;
      }
      while (kid != top && next_of(kid) < 0) kid = s_.parents[kid];
      kid = kid == top ? -1 : next_of(kid);
    }
    return false;
  }
  int32_t next_of(int32_t j) const {
    const int32_t p = s_.parents[j];
    for (int32_t k = s_.kid_offsets[p]; k + 1 < s_.kid_offsets[p + 1]; ++k) {
      if (s_.kids[k] == j) return s_.kids[k + 1];
    }
    return -1;
  }

  NamedJoints& s_;
  double side_ = 0;
};

}  // namespace

void find_roles(NamedJoints* joints) { RoleFinder(joints).find(); }

}  // namespace sinew::names
