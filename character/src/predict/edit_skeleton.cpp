// SPDX-License-Identifier: MIT
// Edits of a predicted skeleton, one after the other on a copy.
#include "sinew_character/predict/edit_skeleton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "predict/mirror_plane.hpp"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/lower_case.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr float kOnPlane =
    0.005f;  // of the skeleton's longest side: an added joint nearer than that is put on the plane

const char* form_of(EditKind kind) {
  switch (kind) {
    case EditKind::kMove:
      return "--move JOINT=X,Y,Z";
    case EditKind::kAdd:
      return "--add NAME=PARENT:X,Y,Z";
    case EditKind::kRemove:
      return "--remove JOINT";
    case EditKind::kParent:
      return "--parent JOINT=OTHER";
    case EditKind::kRename:
      return "--rename JOINT=NAME";
    case EditKind::kAt:
      return "--at JOINT=X,Y,Z";
  }
  return "";
}

Vec3 parse_position(EditKind kind, const std::string& text, std::string_view position) {
  std::array<float, 3> numbers = {};
  for (size_t i = 0; i < 3; ++i) {
    const size_t comma = position.find(',');
    const std::string_view word = position.substr(0, comma);
    const std::optional<float> number = to_finite_float(word);
    if (!number || (comma == std::string_view::npos) != (i == 2))
      throw Error(in_quotes(text) + ": expected three numbers as in " + form_of(kind) + ", found " +
                  in_quotes(number ? position : word));
    numbers[i] = *number;
    position.remove_prefix(comma == std::string_view::npos ? position.size() : comma + 1);
  }
  return {numbers[0], numbers[1], numbers[2]};
}

// Letters to insert, delete or replace (Levenshtein).
size_t letters_apart(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

class Editor {
 public:
  Editor(const PredictedSkeleton& skeleton, bool mirror)
      : s_(skeleton), mirror_(mirror && skeleton.mirrored), plane_(skeleton) {}

  void apply(const SkeletonEdit& edit) {
    switch (edit.kind) {
      case EditKind::kMove:
        return move(edit);
      case EditKind::kAdd:
        return add(edit);
      case EditKind::kRemove:
        return remove(edit);
      case EditKind::kParent:
        return set_parent(edit);
      case EditKind::kRename:
        return rename(edit);
      case EditKind::kAt:
        return mark(edit);
    }
  }

  PredictedSkeleton result() {
    bool parents_first = true;
    for (size_t j = 0; j < count(); ++j) parents_first = parents_first && s_.joints[j].parent < static_cast<int>(j);
    if (parents_first) return std::move(s_);
    std::vector<size_t> order;
    for (size_t j = 0; j < count(); ++j)
      if (s_.joints[j].parent < 0) add_branch(j, &order);
    keep(order);
    return std::move(s_);
  }

 private:
  size_t count() const { return s_.joints.size(); }
  Joint& joint(int32_t j) { return s_.joints[static_cast<size_t>(j)]; }
  bool is_end(int32_t j) const { return s_.ends[static_cast<size_t>(j)] != 0; }

  std::optional<int32_t> find(const std::string& name) const {
    for (size_t j = 0; j < count(); ++j)
      if (s_.joints[j].name == name) return static_cast<int32_t>(j);
    return std::nullopt;
  }

  int32_t need(const std::string& name) const {
    if (const auto found = find(name)) return *found;
    std::vector<std::pair<size_t, size_t>> near;
    for (size_t j = 0; j < count(); ++j) {
      const std::string a = lower_case(name), b = lower_case(s_.joints[j].name);
      const bool part = a.size() > 2 && (b.find(a) != std::string::npos || a.find(b) != std::string::npos);
      near.emplace_back(part ? 1 : letters_apart(a, b), j);
    }
    std::sort(near.begin(), near.end());
    std::string text;
    for (size_t i = 0; i < near.size() && i < 3; ++i)
      if (i == 0 || near[i].first <= near[0].first + 1) text += (i == 0 ? "" : ", ") + s_.joints[near[i].second].name;
    throw Error("unknown joint " + in_quotes(name) + "; near it: " + text);
  }

  // The other joint that an edit is about, or -1.
  int32_t partner(int32_t j) const {
    const int32_t other = mirror_ ? s_.partners[static_cast<size_t>(j)] : -1;
    return other == j ? -1 : other;
  }
  bool on_plane(int32_t j) const { return mirror_ && s_.partners[static_cast<size_t>(j)] == j; }
  // Itself for a joint that represents both sides.
  int32_t image(int32_t j) const {
    const int32_t other = s_.partners[static_cast<size_t>(j)];
    return other < 0 ? j : other;
  }
  Vec3 image(const Vec3& p) const { return plane_.image(p); }

  std::vector<int32_t> children(int32_t parent) const {
    std::vector<int32_t> found;
    for (size_t j = 0; j < count(); ++j)
      if (s_.joints[j].parent == parent) found.push_back(static_cast<int32_t>(j));
    return found;
  }

  void move(const SkeletonEdit& edit) {
    const int32_t j = need(edit.joint), other = partner(j);
    Vec3 position = edit.position;
    if (on_plane(j)) plane_.move_there(&position);
    if (other >= 0) place_with_ends(other, image(position));
    place_with_ends(j, position);
    // A joint that was moved alone loses its mirror image.
    if (!mirror_) forget_partner(j);
  }

  void mark(const SkeletonEdit& edit) {
    if (find(edit.joint)) return move(edit);
    const size_t before = count();
    for (const SkeletonEdit& step : marker_edits(s_.joints, edit)) add(step);
    const JointVerdicts verdicts = joint_verdicts(s_.joints);
    for (size_t j = before; j < count(); ++j) s_.classes[j] = verdicts.classes[j];
  }

  void place_with_ends(int32_t j, const Vec3& position) {
    const Vec3 from = joint(j).position;
    for (const int32_t child : children(j)) {
      if (!is_end(child)) continue;
      Vec3& p = joint(child).position;
      p = {p.x + (position.x - from.x), p.y + (position.y - from.y), p.z + (position.z - from.z)};
    }
    joint(j).position = position;
  }

  void forget_partner(int32_t j) {
    const int32_t other = s_.partners[static_cast<size_t>(j)];
    if (other >= 0) s_.partners[static_cast<size_t>(other)] = -1;
    s_.partners[static_cast<size_t>(j)] = -1;
    for (const int32_t child : children(j))
      if (is_end(child)) forget_partner(child);
  }

  float longest_side() const {
    float longest = 0;
    for (uint32_t axis = 0; axis < 3; ++axis) {
      float low = INFINITY, high = -INFINITY;
      for (const Joint& one : s_.joints) {
        low = std::min(low, component(one.position, axis));
        high = std::max(high, component(one.position, axis));
      }
      longest = std::max(longest, high - low);
    }
    return longest;
  }

  void check_new_name(const std::string& name) const {
    if (name.empty()) throw Error("a joint needs a name; expected --add NAME=PARENT:X,Y,Z or --rename JOINT=NAME");
    for (const char c : name)
      if (static_cast<unsigned char>(c) <= ' ' || c == 127)
        throw Error("the joint name " + in_quotes(name) + " contains a space, which rig.txt does not allow");
    if (find(name)) throw Error("the skeleton already has a joint " + in_quotes(name) + "; choose another name");
  }

  void check_parent(int32_t parent) const {
    if (is_end(parent))
      throw Error("the bone end " + in_quotes(s_.joints[static_cast<size_t>(parent)].name) +
                  " moves nothing and has no joints; use " +
                  in_quotes(s_.joints[static_cast<size_t>(s_.joints[static_cast<size_t>(parent)].parent)].name) +
                  " as the parent");
  }

  int32_t append(const std::string& name, int32_t parent, const Vec3& position, bool end) {
    check_new_name(name);
    s_.joints.push_back({name, position, parent, !end});
    s_.classes.push_back(end ? s_.classes[static_cast<size_t>(parent)] : static_cast<uint8_t>(SINEW_CLASS_OTHER));
    s_.ends.push_back(end ? 1 : 0);
    s_.partners.push_back(-1);
    s_.confidence.push_back(1);
    s_.parent_confidence.push_back(1);
    return static_cast<int32_t>(count() - 1);
  }

  void add(const SkeletonEdit& edit) {
    const int32_t parent = need(edit.other);
    check_parent(parent);
    const bool end = edit.joint.size() > 4 && edit.joint.compare(edit.joint.size() - 4, 4, "_end") == 0;
    const std::string other_name = other_side_name(edit.joint);
    Vec3 position = edit.position;
    const bool near_plane = std::fabs(plane_.distance(position)) <= kOnPlane * longest_side();
    if (mirror_ && other_name == edit.joint && partner(parent) >= 0)
      throw Error("the joint " + in_quotes(edit.joint) + " exists on both sides, like its parent " +
                  in_quotes(edit.other) +
                  "; give it a name with a side, as in LeftWing, or edit one side with --no-mirror");
    const bool stands_on_plane = mirror_ && other_name == edit.joint && near_plane;
    if (stands_on_plane) plane_.move_there(&position);
    const int32_t j = append(edit.joint, parent, position, end);
    if (stands_on_plane) s_.partners[static_cast<size_t>(j)] = j;
    if (!mirror_ || other_name == edit.joint) return;
    const int32_t other = append(other_name, image(parent), image(position), end);
    s_.partners[static_cast<size_t>(j)] = other;
    s_.partners[static_cast<size_t>(other)] = j;
  }

  void remove(const SkeletonEdit& edit) {
    const int32_t j = need(edit.joint), other = partner(j);
    std::vector<bool> gone(count(), false);
    take_out(j, &gone);
    if (other >= 0) take_out(other, &gone);
    std::vector<size_t> left;
    bool any = false;
    for (size_t k = 0; k < count(); ++k) {
      if (gone[k]) continue;
      left.push_back(k);
      any = any || s_.ends[k] == 0;
    }
    if (!any) throw Error("removing " + in_quotes(edit.joint) + " would leave no joint; a skeleton needs one");
    keep(left);
  }

  void take_out(int32_t j, std::vector<bool>* gone) {
    (*gone)[static_cast<size_t>(j)] = true;
    int32_t heir = joint(j).parent;
    for (const int32_t child : children(j))
      if (is_end(child)) (*gone)[static_cast<size_t>(child)] = true;
    if (heir < 0) {
      for (const int32_t child : children(j)) {
        if (is_end(child)) continue;
        if (heir < 0 ||
            (s_.partners[static_cast<size_t>(child)] == child && s_.partners[static_cast<size_t>(heir)] != heir))
          heir = child;
      }
      if (heir >= 0) joint(heir).parent = -1;
    }
    for (const int32_t child : children(j))
      if (child != heir) joint(child).parent = heir;
  }

  void set_parent(const SkeletonEdit& edit) {
    const int32_t j = need(edit.joint), parent = need(edit.other), other = partner(j);
    check_parent(parent);
    joint(j).parent = parent;
    if (other >= 0) joint(other).parent = mirror_ ? image(parent) : parent;
    for (int32_t above = parent, steps = 0; above >= 0; above = joint(above).parent, ++steps)
      if (above == j || steps > static_cast<int32_t>(count()))
        throw Error("the parent of " + in_quotes(edit.joint) + " cannot be " + in_quotes(edit.other) +
                    ", its descendant: that would be a cycle; move " + in_quotes(edit.other) + " first");
    if (on_plane(j) && partner(parent) >= 0)
      throw Error("the joint " + in_quotes(edit.joint) + " is on the mirror plane, so its parent cannot be " +
                  in_quotes(edit.other) + " beside it; edit one side with --no-mirror");
    s_.parent_confidence[static_cast<size_t>(j)] = 1;
    if (other >= 0) s_.parent_confidence[static_cast<size_t>(other)] = 1;
  }

  void rename(const SkeletonEdit& edit) {
    const int32_t j = need(edit.joint), other = partner(j);
    rename_one(j, edit.other);
    const std::string other_name = other_side_name(edit.other);
    if (other >= 0 && other_name != edit.other) rename_one(other, other_name);
  }

  void rename_one(int32_t j, const std::string& name) {
    const std::string before = joint(j).name;
    if (name == before) return;
    check_new_name(name);
    joint(j).name = name;
    for (const int32_t child : children(j))
      if (is_end(child) && joint(child).name == before + "_end" && !find(name + "_end"))
        joint(child).name = name + "_end";
  }

  void add_branch(size_t root, std::vector<size_t>* order) const {
    std::vector<size_t> open = {root};
    while (!open.empty()) {
      const size_t j = open.back();
      open.pop_back();
      order->push_back(j);
      const std::vector<int32_t> below = children(static_cast<int32_t>(j));
      open.insert(open.end(), below.rbegin(), below.rend());
    }
  }

  template <typename T>
  static void pick(const std::vector<size_t>& order, std::vector<T>* values) {
    std::vector<T> picked;
    for (const size_t j : order) picked.push_back((*values)[j]);
    *values = std::move(picked);
  }

  // These joints in this order, no others.
  void keep(const std::vector<size_t>& order) {
    std::vector<int32_t> index(count(), -1);
    for (size_t i = 0; i < order.size(); ++i) index[order[i]] = static_cast<int32_t>(i);
    const auto at = [&](int32_t j) { return j < 0 ? -1 : index[static_cast<size_t>(j)]; };
    for (Joint& one : s_.joints) one.parent = at(one.parent);
    for (int32_t& one : s_.partners) one = at(one);
    pick(order, &s_.joints);
    pick(order, &s_.classes);
    pick(order, &s_.ends);
    pick(order, &s_.partners);
    pick(order, &s_.confidence);
    pick(order, &s_.parent_confidence);
  }

  PredictedSkeleton s_;
  bool mirror_;
  MirrorPlane plane_;
};

}  // namespace

SkeletonEdit parse_edit(EditKind kind, const std::string& text) {
  SkeletonEdit edit;
  edit.kind = kind;
  const size_t equals = text.find('=');
  edit.joint = text.substr(0, equals);
  const auto refuse = [&] { throw Error(in_quotes(text) + ": expected " + form_of(kind)); };
  if (edit.joint.empty()) refuse();
  if (kind == EditKind::kRemove) {
    edit.joint = text;
    return edit;
  }
  if (equals == std::string::npos || equals + 1 == text.size()) refuse();
  const std::string value = text.substr(equals + 1);
  if (kind == EditKind::kMove || kind == EditKind::kAt) {
    edit.position = parse_position(kind, text, value);
  } else if (kind == EditKind::kAdd) {
    const size_t colon = value.rfind(':');  // mixamorig:Hips has one of its own
    if (colon == std::string::npos || colon == 0) refuse();
    edit.other = value.substr(0, colon);
    edit.position = parse_position(kind, text, std::string_view(value).substr(colon + 1));
  } else {
    edit.other = value;
  }
  return edit;
}

void edit_skeleton(const std::vector<SkeletonEdit>& edits, bool mirror, PredictedSkeleton* skeleton) {
  if (edits.empty()) return;
  Editor editor(*skeleton, mirror);
  for (const SkeletonEdit& edit : edits) editor.apply(edit);
  *skeleton = editor.result();
}

}  // namespace sinew
