// SPDX-License-Identifier: MIT
// Roles of joints from the words in their names and from who their parents and children are.
#include "sinew_character/joint_roles.hpp"

#include <algorithm>
#include <cmath>

#include "rig/joint_words.hpp"
#include "sinew_formats/box.hpp"

namespace sinew {
namespace {

using Words = std::vector<std::string>;

bool has_word(const Words& words, std::initializer_list<const char*> wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(wanted.begin(), wanted.end(), [&](const char* each) { return word == each; });
  });
}

// As has_word; words of five letters or more also count at the end of a longer one (legcontrol, poletarget).
bool has_ending(const Words& words, std::initializer_list<const char*> wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(wanted.begin(), wanted.end(), [&](const std::string& each) {
      return word == each || (each.size() >= 4 && word.size() > each.size() &&
                              word.compare(word.size() - each.size(), each.size(), each) == 0);
    });
  });
}

bool says_control(const Words& words) {
  return has_ending(words,
                    {"ik",  "ctrl", "ctl",   "cntrl", "control", "controller", "pole", "target", "effector", "goal",
                     "mch", "org",  "tweak", "wgt",   "widget",  "lookat",     "aim",  "orient", "tracker",  "handle"});
}
bool says_slot(const Words& words) {
  return has_ending(words, {"slot", "socket", "attach", "attachment", "mount", "weapon", "prop", "anchor", "holster",
                            "locator", "camera", "light", "marker", "interaction"});
}
bool says_tip(const Words& words) { return has_word(words, {"end", "nub", "tip", "null", "stub", "effector"}); }
// Root, b_Root_00, Armature_rootJoint, MASTER: nothing else may be in the name (thigh_Armature, tail_root).
bool says_root(const Words& words) {
  const auto is_root = [](const std::string& word) {
    return has_word({word}, {"root", "rootjoint", "rootnode", "master", "world", "global", "trajectory", "origin",
                             "reference", "footsteps", "motion", "rootmotion"});
  };
  const auto is_filler = [](const std::string& word) {
    return has_word({word},
                    {"armature", "skeleton", "rig", "bone", "joint", "jnt", "jt", "node", "b", "c", "m", "mid"});
  };
  return std::any_of(words.begin(), words.end(), is_root) &&
         std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return is_root(word) || is_filler(word); });
}
bool says_finger(const Words& words) {
  return has_ending(words, {"thumb", "index", "middle", "ring", "pinky", "little"});
}

class RoleFinder {
 public:
  explicit RoleFinder(const std::vector<Joint>& joints) : joints_(joints), roles_(joints.size(), JointRole::kDeforms) {
    for (const Joint& joint : joints) words_.push_back(words_of(joint.name));
    children_.resize(joints.size());
    for (size_t j = 0; j < joints.size(); ++j)
      if (joints[j].parent >= 0) children_[static_cast<size_t>(joints[j].parent)].push_back(j);
  }

  std::vector<JointRole> find() {
    find_roots();
    find_tips();
    find_slots();
    find_controls();
    return std::move(roles_);
  }

 private:
  bool deforms(size_t j) const { return roles_[j] == JointRole::kDeforms; }
  bool is_leaf(size_t j) const { return children_[j].empty(); }

  // A joint at the top, or below tops alone, that is called one. What has many children of its own is a body.
  void find_roots() {
    std::vector<size_t> open;
    for (size_t j = 0; j < joints_.size(); ++j)
      if (joints_[j].parent < 0) open.push_back(j);
    for (size_t next = 0; next < open.size(); ++next) {
      const size_t j = open[next];
      constexpr size_t kMostChildren = 16;
      if (!says_root(words_[j]) || is_leaf(j) || children_[j].size() > kMostChildren || !someone_deforms_below(j))
        continue;
      roles_[j] = JointRole::kRoot;
      open.insert(open.end(), children_[j].begin(), children_[j].end());
    }
  }

  // A rig of one or two joints whose root is called so has nothing else to deform with.
  bool someone_deforms_below(size_t root) const {
    std::vector<size_t> open = children_[root];
    size_t others = 0;
    for (size_t next = 0; next < open.size(); ++next) {
      others += says_tip(words_[open[next]]) || says_control(words_[open[next]]) ? 0 : 1;
      open.insert(open.end(), children_[open[next]].begin(), children_[open[next]].end());
    }
    return others > 1;
  }

  void find_tips() {
    for (size_t j = 0; j < joints_.size(); ++j)
      if (is_leaf(j) && joints_[j].parent >= 0 && ((says_tip(words_[j]) && !has_start(j)) || is_fingertip(j)))
        roles_[j] = JointRole::kTip;
    // thumb_null with thumb_null_end: a tip that has got a tip.
    for (size_t j = 0; j < joints_.size(); ++j)
      if (deforms(j) && !is_leaf(j) && joints_[j].parent >= 0 && has_word(words_[j], {"null", "nub", "stub"}) &&
          std::all_of(children_[j].begin(), children_[j].end(),
                      [&](size_t child) { return roles_[child] == JointRole::kTip; }))
        roles_[j] = JointRole::kTip;
  }

  // tail_start and tail_end are two bones.
  bool has_start(size_t j) const {
    return has_word(words_[static_cast<size_t>(joints_[j].parent)], {"start", "begin", "base"}) &&
           has_word(words_[j], {"end"}) && words_[j].size() > 1 &&
           words_[j].front() == words_[static_cast<size_t>(joints_[j].parent)].front() &&
           !has_word(words_[j], {"start", "begin", "base"});
  }

  // Fingers have three bones: the fourth of LeftHandIndex1 to 4 ends the third.
  bool is_fingertip(size_t j) const {
    if (!says_finger(words_[j]) || number_at_end(joints_[j].name) != 4) return false;
    int up = joints_[j].parent;
    for (int number = 3; number > 0; --number, up = joints_[static_cast<size_t>(up)].parent)
      if (up < 0 || !says_finger(words_[static_cast<size_t>(up)]) ||
          number_at_end(joints_[static_cast<size_t>(up)].name) != number)
        return false;
    return true;
  }

  void find_slots() {
    std::vector<char> named(joints_.size(), 0);
    for (size_t j = 0; j < joints_.size(); ++j)
      named[j] = says_slot(words_[j]) && !has_word(words_[j], {"eye", "eyes"}) ? 1 : 0;
    if (is_habit(named)) return;
    for (size_t j = 0; j < joints_.size(); ++j)
      if (named[j] != 0 && deforms(j) && !leads_to_limb(j, named)) roles_[j] = JointRole::kSlot;
  }

  // A word that a third of the joints have in their names tells nobody apart.
  bool is_habit(const std::vector<char>& named) const {
    size_t count = 0;
    for (size_t j = 0; j < named.size(); ++j) count += named[j] != 0 && roles_[j] != JointRole::kTip ? 1 : 0;
    return count * 3 > joints_.size() && twins(named) * 2 < count;
  }

  void find_controls() {
    std::vector<char> named(joints_.size(), 0);
    for (size_t j = 0; j < joints_.size(); ++j) named[j] = says_control(words_[j]) ? 1 : 0;
    name_rigify(&named);
    const bool habit = is_habit(named);
    std::vector<char> control(joints_.size(), 0);
    for (size_t j = 0; j < joints_.size(); ++j) {
      if (named[j] == 0) continue;
      const int parent = joints_[j].parent;
      const bool from_top = parent < 0 || roles_[static_cast<size_t>(parent)] == JointRole::kRoot ||
                            named[static_cast<size_t>(parent)] != 0;
      control[j] = has_twin(j, named) || (!habit && (!leads_to_limb(j, named) || from_top)) ? 1 : 0;
    }
    for (size_t j = 0; j < joints_.size(); ++j) {
      if (control[j] == 0 || !(deforms(j) || roles_[j] == JointRole::kSlot)) continue;
      roles_[j] = JointRole::kControl;
    }
    // Where two joints of a limb are called FK and IK, a third that stands there deforms.
    for (size_t j = 0; j < joints_.size(); ++j)
      if (deforms(j) && has_word(words_[j], {"fk"}) && has_twin(j, named)) roles_[j] = JointRole::kControl;
  }

  // Rigify's DEF- joints deform; what stands beside them under another of its prefixes or without one does not.
  void name_rigify(std::vector<char>* named) const {
    size_t count = 0;
    for (const Words& words : words_) count += has_word(words, {"def"}) ? 1 : 0;
    if (count < 3) return;
    for (size_t j = 0; j < joints_.size(); ++j) {
      if (has_word(words_[j], {"def"}))
        (*named)[j] = 0;
      else if (has_word(words_[j], {"fk", "parent", "torso", "master", "hips", "chest"}))
        (*named)[j] = 1;
    }
  }

  size_t twins(const std::vector<char>& named) const {
    size_t count = 0;
    for (size_t j = 0; j < joints_.size(); ++j) count += named[j] != 0 && has_twin(j, named) ? 1 : 0;
    return count;
  }

  // Another joint that is none of the named stands in the same place.
  bool has_twin(size_t j, const std::vector<char>& named) const {
    const Vec3& p = joints_[j].position;
    for (size_t k = 0; k < joints_.size(); ++k) {
      if (k == j || named[k] != 0 || !deforms(k) || has_word(words_[k], {"fk"})) continue;
      const Vec3& q = joints_[k].position;
      if (std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) <= twin_distance()) return true;
    }
    return false;
  }
  float twin_distance() const {
    if (twin_distance_ < 0) {
      std::vector<Vec3> points;
      for (const Joint& joint : joints_) points.push_back(joint.position);
      twin_distance_ = 0.005f * box_of(points).longest_side();
    }
    return twin_distance_;
  }

  bool leads_to_limb(size_t top, const std::vector<char>& named) const {
    std::vector<size_t> open = children_[top];
    for (size_t next = 0; next < open.size(); ++next) {
      if (deforms(open[next]) && named[open[next]] == 0) return true;
      open.insert(open.end(), children_[open[next]].begin(), children_[open[next]].end());
    }
    return false;
  }

  const std::vector<Joint>& joints_;
  std::vector<JointRole> roles_;
  std::vector<Words> words_;
  std::vector<std::vector<size_t>> children_;
  mutable float twin_distance_ = -1;
};

}  // namespace

const char* joint_role_text(JointRole role) {
  switch (role) {
    case JointRole::kDeforms:
      return "deforms";
    case JointRole::kRoot:
      return "root";
    case JointRole::kControl:
      return "control";
    case JointRole::kSlot:
      return "slot";
    case JointRole::kTip:
      return "tip";
  }
  return "";
}

std::vector<JointRole> joint_roles(const std::vector<Joint>& joints) { return RoleFinder(joints).find(); }

}  // namespace sinew
