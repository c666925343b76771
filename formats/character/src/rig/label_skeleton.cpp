// SPDX-License-Identifier: MIT
// Classes, bone ends and mirror images of a skeleton by its names and places.
#include "sinew_character/label_skeleton.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include "sinew_character/joint_class_of.hpp"
#include "sinew_character/joint_mirror.hpp"
#include "sinew_character/joint_roles.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

bool is_gap(char c) { return c == ':' || c == '_' || c == ' ' || c == '|' || c == '-' || c == '.'; }

// Bip01_, J_Bip_, mixamorig: : what at least four of five names begin with, up to a gap; "" without one.
std::string shared_prefix(const std::vector<Joint>& joints) {
  std::string best;
  if (joints.size() < 5) return best;
  for (const Joint& joint : joints) {
    for (size_t i = best.size(); i + 1 < joint.name.size(); ++i) {
      if (!is_gap(joint.name[i])) continue;
      const std::string prefix = joint.name.substr(0, i + 1);
      const auto sharing =
          std::count_if(joints.begin(), joints.end(), [&](const Joint& one) { return one.name.starts_with(prefix); });
      if (5 * static_cast<size_t>(sharing) < 4 * joints.size()) break;
      if (prefix.size() > best.size()) best = prefix;
    }
  }
  return best;
}

bool words_hold(std::string name, const char* word) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name.find(word) != std::string::npos;
}

// What joint_class_of() reads: leftUpperArm as LeftUpperArm, "L_UpperArm" and "L UpperArm" as LeftUpperArm, C_Hips as Hips.
std::string readable_name(std::string name, const std::string& prefix) {
  if (!prefix.empty() && name.starts_with(prefix) && name.size() > prefix.size()) name.erase(0, prefix.size());
  const auto upper_at = [&](size_t i) {
    return i < name.size() && std::isupper(static_cast<unsigned char>(name[i])) != 0;
  };
  if (name.size() > 2 && (name[1] == '_' || name[1] == ' ') && std::isalpha(static_cast<unsigned char>(name[2])) != 0) {
    const char first = name[0];
    if (first == 'L' || first == 'l' || first == 'R' || first == 'r' || first == 'C' || first == 'M') {
      name.erase(0, 2);
      name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
      if (first == 'L' || first == 'l') name.insert(0, "Left");
      if (first == 'R' || first == 'r') name.insert(0, "Right");
    }
  } else if ((name.starts_with("left") && upper_at(4)) || (name.starts_with("right") && upper_at(5))) {
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  }
  std::erase(name, ' ');
  return name;
}

// The joint nearest above that is no detail, -1 without one.
int core_parent(const LabelledSkeleton& s, size_t j) {
  int above = s.joints[j].parent;
  while (above >= 0 && s.classes[static_cast<size_t>(above)] == kClassDetail)
    above = s.joints[static_cast<size_t>(above)].parent;
  return above;
}

bool has_class(const LabelledSkeleton& s, uint8_t wanted) {
  return std::find(s.classes.begin(), s.classes.end(), wanted) != s.classes.end();
}

// Rigify's trunk is spine from the pelvis to the head: what thighs hang on is the pelvis, and beyond the joint with the
// clavicles come the neck and, last, the head.
void tell_spine_apart(LabelledSkeleton* s) {
  const size_t count = s->joints.size();
  const auto carrier_of = [&](uint8_t wanted) {
    for (size_t j = 0; j < count; ++j) {
      const int above = s->classes[j] == wanted ? core_parent(*s, j) : -1;
      if (above >= 0 && s->classes[static_cast<size_t>(above)] == SINEW_CLASS_SPINE) return above;
    }
    return -1;
  };
  const int legs = carrier_of(SINEW_CLASS_THIGH), arms = carrier_of(SINEW_CLASS_CLAVICLE);
  if (legs < 0 || arms < 0 || has_class(*s, SINEW_CLASS_PELVIS)) return;
  if (!has_class(*s, SINEW_CLASS_NECK) && !has_class(*s, SINEW_CLASS_HEAD)) {
    int last = arms;
    for (bool more = true; more;) {
      more = false;
      for (size_t j = 0; j < count && !more; ++j) {
        more = s->classes[j] == SINEW_CLASS_SPINE && s->ends[j] == 0 && core_parent(*s, j) == last;
        if (!more) continue;
        s->classes[j] = SINEW_CLASS_NECK;
        last = static_cast<int>(j);
      }
    }
    if (last != arms) s->classes[static_cast<size_t>(last)] = SINEW_CLASS_HEAD;
  }
  s->classes[static_cast<size_t>(legs)] = SINEW_CLASS_PELVIS;
}

}  // namespace

LabelledSkeleton label_skeleton(const std::vector<Joint>& joints) {
  LabelledSkeleton labelled;
  labelled.joints = joints;
  const size_t count = joints.size();
  std::vector<bool> leaf(count, true);
  for (const Joint& joint : joints)
    if (joint.parent >= 0) leaf[static_cast<size_t>(joint.parent)] = false;
  const std::vector<JointRole> roles = joint_roles(joints);
  const std::string prefix = shared_prefix(joints);
  std::vector<std::string> names;
  for (const Joint& joint : joints) names.push_back(readable_name(joint.name, prefix));
  labelled.ends.assign(count, 0);
  for (size_t j = 0; j < count; ++j)
    labelled.ends[j] = leaf[j] && joints[j].parent >= 0 && (roles[j] == JointRole::kTip || names_bone_end(names[j]));
  std::vector<std::vector<std::string_view>> below(count);
  for (size_t j = 0; j < count; ++j) {
    if (labelled.ends[j] != 0) continue;
    size_t steps = 0;
    for (int above = joints[j].parent; above >= 0 && steps < count; above = joints[static_cast<size_t>(above)].parent) {
      below[static_cast<size_t>(above)].push_back(names[j]);
      ++steps;
    }
  }
  for (size_t j = 0; j < count; ++j) {
    const auto joint_class = joint_class_of(names[j], below[j]);
    const bool aside = roles[j] == JointRole::kControl || roles[j] == JointRole::kSlot;
    const bool little = words_hold(names[j], "little");  // finger
    labelled.classes.push_back(!joint_class || aside || little ? kClassDetail : static_cast<uint8_t>(*joint_class));
  }
  for (size_t j = 0; j < count; ++j) {  // palms and what a hand holds
    const int above = labelled.classes[j] == SINEW_CLASS_HAND ? core_parent(labelled, j) : -1;
    if (above >= 0 && labelled.ends[j] == 0 && labelled.classes[static_cast<size_t>(above)] == SINEW_CLASS_HAND)
      labelled.classes[j] = kClassDetail;
  }
  tell_spine_apart(&labelled);
  for (size_t j = 0; j < count; ++j) {
    if (labelled.ends[j] == 0) continue;
    const size_t parent = static_cast<size_t>(joints[j].parent);
    if (labelled.classes[j] == kClassDetail || labelled.classes[parent] == kClassDetail) {
      labelled.classes[j] = kClassDetail;
      labelled.ends[j] = 0;
    } else {
      labelled.classes[j] = labelled.classes[parent];
    }
  }
  return labelled;
}

LabelledSkeleton label_skeleton(const PredictedSkeleton& skeleton) {
  return {skeleton.joints, skeleton.classes, skeleton.ends};
}

PredictedSkeleton skeleton_from_joints(const std::vector<Joint>& joints) {
  if (joints.empty()) throw Error("the skeleton has no joints");
  std::vector<size_t> order;
  std::vector<int> index(joints.size(), -1);
  bool parents_first = true;
  for (size_t j = 0; j < joints.size(); ++j) parents_first = parents_first && joints[j].parent < static_cast<int>(j);
  for (size_t j = 0; j < joints.size(); ++j)
    if (parents_first || joints[j].parent < 0) order.push_back(j);
  for (size_t i = 0; i < order.size() && !parents_first; ++i)
    for (size_t j = 0; j < joints.size(); ++j)
      if (joints[j].parent == static_cast<int>(order[i])) order.push_back(j);
  if (order.size() != joints.size()) throw Error("the joints form a cycle, expected a tree");
  for (size_t i = 0; i < order.size(); ++i) index[order[i]] = static_cast<int>(i);
  PredictedSkeleton skeleton;
  for (const size_t j : order) {
    skeleton.joints.push_back(joints[j]);
    int& parent = skeleton.joints.back().parent;
    if (parent >= 0) parent = index[static_cast<size_t>(parent)];
  }
  LabelledSkeleton labelled = label_skeleton(skeleton.joints);
  skeleton.classes = std::move(labelled.classes);
  skeleton.ends = std::move(labelled.ends);
  for (uint8_t& one : skeleton.classes)
    if (one == kClassDetail) one = SINEW_CLASS_OTHER;
  for (size_t j = 0; j < joints.size(); ++j) skeleton.joints[j].deforms = skeleton.ends[j] == 0;
  JointMirror mirror = find_joint_mirror(skeleton.joints);
  skeleton.mirrored = mirror.exact && mirror.axis != 1;
  skeleton.facing = mirror.axis == 2 ? 1 : 0;
  skeleton.plane = mirror.plane;
  skeleton.partners = std::move(mirror.partners);
  if (!skeleton.mirrored) skeleton.partners.assign(joints.size(), -1);
  skeleton.confidence.assign(joints.size(), 1);
  skeleton.parent_confidence.assign(joints.size(), 1);
  return skeleton;
}

}  // namespace sinew
