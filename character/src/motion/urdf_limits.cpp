// SPDX-License-Identifier: MIT
// Limits of a robot's joints from its URDF: tags and attributes of XML, axes carried into the world of the target's rest pose.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sinew_character/motion/joint_limits.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "text/joint_names.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

struct Tag {
  std::string_view name;
  bool opens = true, closes = false;  // <a>: opens; </a>: closes; <a/>: both
  std::map<std::string, std::string> attributes;
  size_t line = 1;
};

// One tag after the other; comments, declarations and text between are passed over.
class XmlTags {
 public:
  XmlTags(std::string path, std::string_view text) : path_(std::move(path)), text_(text) {}

  std::optional<Tag> next() {
    while (true) {
      go_to('<');
      if (at_ >= text_.size()) return std::nullopt;
      if (skip("<!--", "-->") || skip("<?", "?>") || skip("<![CDATA[", "]]>") || skip("<!", ">")) continue;
      return read_tag();
    }
  }
  [[noreturn]] void fail(size_t line, const std::string& expected, std::string_view found) const {
    throw Error(path_ + ":" + std::to_string(line) + ": expected " + expected + ", found " + in_quotes(found));
  }

 private:
  void step() {
    if (text_[at_] == '\n') ++line_;
    ++at_;
  }
  void go_to(char c) {
    while (at_ < text_.size() && text_[at_] != c) step();
  }
  bool skip(std::string_view begin, std::string_view end) {
    if (text_.substr(at_, begin.size()) != begin) return false;
    const size_t stop = text_.find(end, at_ + begin.size());
    if (stop == std::string_view::npos) fail(line_, "'" + std::string(end) + "' behind it", text_.substr(at_));
    while (at_ < stop + end.size()) step();
    return true;
  }
  bool ends_word(char c) const { return c <= ' ' || c == '=' || c == '/' || c == '>'; }
  std::string_view word() {
    const size_t begin = at_;
    while (at_ < text_.size() && !ends_word(text_[at_])) step();
    return text_.substr(begin, at_ - begin);
  }
  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] <= ' ') step();
  }
  bool take(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    step();
    return true;
  }
  Tag read_tag() {
    Tag tag;
    tag.line = line_;
    step();
    if (take('/')) {
      tag.opens = false;
      tag.closes = true;
    }
    tag.name = word();
    for (skip_blanks(); !take('>'); skip_blanks()) {
      if (at_ >= text_.size()) fail(tag.line, "the end of the tag", tag.name);
      if (take('/')) {
        tag.closes = true;
        continue;
      }
      const std::string_view name = word();
      skip_blanks();
      const bool has_value = take('=');
      skip_blanks();
      const char quote = at_ < text_.size() ? text_[at_] : ' ';
      if (name.empty() || !has_value || (quote != '"' && quote != '\''))
        fail(line_, "NAME=\"VALUE\"", text_.substr(at_));
      step();
      const size_t begin = at_;
      go_to(quote);
      tag.attributes.emplace(name, text_.substr(begin, at_ - begin));
      if (!take(quote)) fail(tag.line, "a closing quote", tag.name);
    }
    return tag;
  }

  const std::string path_;
  const std::string_view text_;
  size_t at_ = 0, line_ = 1;
};

struct UrdfJoint {
  std::string name, type, parent, child;
  Point3 origin = {}, axis = {1, 0, 0};
  Quaternion rotation = kNoRotation4;  // of the joint's frame in that of the parent link, zero pose
  double least = 0, most = 0;          // radians
  bool has_limit = false;
  size_t line = 0;
  Quaternion world = kNoRotation4;  // once placed
  Point3 position = {};
};

class UrdfReader {
 public:
  UrdfReader(const std::string& path, const std::string& text) : path_(path), tags_(path, text) {}

  std::vector<UrdfJoint> read() {
    std::vector<std::string_view> open;
    UrdfJoint* joint = nullptr;
    while (std::optional<Tag> tag = tags_.next()) {
      if (tag->name.substr(0, 6) == "xacro:")
        throw Error(path_ + ":" + std::to_string(tag->line) +
                    ": is a xacro macro; expected a plain URDF, as written by `xacro FILE > OUT.urdf`");
      if (tag->opens) {
        if (open.empty() && tag->name != "robot") tags_.fail(tag->line, "<robot>", tag->name);
        if (open.size() == 1 && tag->name == "joint") joint = begin(*tag);
        if (open.size() == 2 && joint != nullptr) take(*tag, joint);
        if (!tag->closes) open.push_back(tag->name);
      } else if (open.empty() || open.back() != tag->name) {
        tags_.fail(tag->line, open.empty() ? "no closing tag" : "</" + std::string(open.back()) + ">", tag->name);
      } else {
        open.pop_back();
      }
      if (open.size() == 1) joint = nullptr;
    }
    place();
    return std::move(joints_);
  }

 private:
  const std::string& text_of(const Tag& tag, const char* name) const {
    const auto found = tag.attributes.find(name);
    if (found == tag.attributes.end()) tags_.fail(tag.line, "a " + std::string(name) + "=\"...\" in it", tag.name);
    return found->second;
  }
  double number_of(const Tag& tag, const char* name) const {
    const auto found = tag.attributes.find(name);
    if (found == tag.attributes.end()) return 0;
    const std::optional<double> value = to_finite_double(found->second);
    if (!value) tags_.fail(tag.line, "a number as its " + std::string(name), found->second);
    return *value;
  }
  Point3 point_of(const Tag& tag, const char* name, const Point3& none) const {
    const auto found = tag.attributes.find(name);
    if (found == tag.attributes.end()) return none;
    TextLines lines(path_, found->second);
    if (!lines.next() || lines.words().size() != 3)
      tags_.fail(tag.line, "three numbers as its " + std::string(name), found->second);
    Point3 point = {};
    for (size_t i = 0; i < 3; ++i) {
      const std::optional<double> value = to_finite_double(lines.words()[i]);
      if (!value) tags_.fail(tag.line, "a number", lines.words()[i]);
      point[i] = *value;
    }
    return point;
  }

  UrdfJoint* begin(const Tag& tag) {
    UrdfJoint& joint = joints_.emplace_back();
    joint.name = text_of(tag, "name");
    joint.type = text_of(tag, "type");
    joint.line = tag.line;
    return &joint;
  }
  void take(const Tag& tag, UrdfJoint* joint) const {
    if (tag.name == "parent") joint->parent = text_of(tag, "link");
    if (tag.name == "child") joint->child = text_of(tag, "link");
    if (tag.name == "axis") joint->axis = point_of(tag, "xyz", {1, 0, 0});
    if (tag.name == "origin") {
      joint->origin = point_of(tag, "xyz", {});
      const Point3 rpy = point_of(tag, "rpy", {});  // about fixed axes, x first
      joint->rotation =
          multiply(axis_rotation(2, rpy[2]), multiply(axis_rotation(1, rpy[1]), axis_rotation(0, rpy[0])));
    }
    if (tag.name == "limit") {
      joint->least = number_of(tag, "lower");
      joint->most = number_of(tag, "upper");
      joint->has_limit = true;
    }
  }

  // Frames in the world, joints in any order; joints of a cycle stay at the origin.
  void place() {
    std::map<std::string, const UrdfJoint*> above;
    for (const UrdfJoint& joint : joints_) above.emplace(joint.child, &joint);
    for (UrdfJoint& joint : joints_) {
      joint.world = joint.rotation;
      joint.position = joint.origin;
      auto found = above.find(joint.parent);
      for (size_t steps = 0; found != above.end() && steps < joints_.size(); ++steps) {
        const UrdfJoint& up = *found->second;
        joint.position = up.origin + rotate(up.rotation, joint.position);
        joint.world = multiply(up.rotation, joint.world);
        found = above.find(up.parent);
      }
    }
  }

  const std::string& path_;
  XmlTags tags_;
  std::vector<UrdfJoint> joints_;
};

// Rotations by multiples of 90 degrees, the smallest first: none, z up to y up, then all others.
std::vector<Quaternion> quarter_turns() {
  const double quarter = 3.14159265358979323846 / 2;
  std::vector<Quaternion> turns = {kNoRotation4, axis_rotation(0, -quarter)};
  for (const size_t axis : {size_t{0}, size_t{1}, size_t{2}})
    for (int first = 0; first < 4; ++first)
      for (int second = 0; second < 4; ++second)
        turns.push_back(
            multiply(axis_rotation(axis, quarter * first), axis_rotation((axis + 1) % 3, quarter * second)));
  return turns;
}

using Pairs = std::vector<std::pair<uint32_t, const UrdfJoint*>>;

// How the robot's world lies in the target's, by where joints of both are; sizes may differ.
Quaternion world_turn(const std::string& path, const Pairs& pairs, const MapRig& target) {
  Point3 from{}, to{};
  for (const auto& [joint, urdf] : pairs) {
    from = from + (1.0 / static_cast<double>(pairs.size())) * urdf->position;
    to = to + (1.0 / static_cast<double>(pairs.size())) * point(target.joints[joint].position);
  }
  double size_from = 0, size_to = 0;
  for (const auto& [joint, urdf] : pairs) {
    size_from += dot(urdf->position - from, urdf->position - from);
    size_to += dot(point(target.joints[joint].position) - to, point(target.joints[joint].position) - to);
  }
  if (!(size_from > 0) || !(size_to > 0)) return kNoRotation4;
  const double scale = std::sqrt(size_to / size_from);
  Quaternion best = kNoRotation4;
  double least = 2;
  for (const Quaternion& turn : quarter_turns()) {
    double off = 0;
    for (const auto& [joint, urdf] : pairs) {
      const Point3 d = scale * rotate(turn, urdf->position - from) - (point(target.joints[joint].position) - to);
      off += dot(d, d) / size_to;
    }
    if (off >= least - 1e-6) continue;
    least = off;
    best = turn;
  }
  constexpr double kSamePose = 0.01;  // of the squared size
  if (least > kSamePose)
    throw Error(path + ": the joints of " + target.name +
                " are at other positions than the robot's at zero, so its axes do not apply; give the robot itself");
  return best;
}

sinew_joint_limit limit_of(const UrdfJoint& urdf, uint32_t joint, const Quaternion& turn) {
  sinew_joint_limit limit = {};
  limit.joint = joint;
  limit.kind = SINEW_LIMIT_HINGE;
  const Point3 axis = unit(rotate(turn, rotate(urdf.world, urdf.axis)));
  for (size_t i = 0; i < 3; ++i) limit.axis[i] = static_cast<float>(axis[i]);
  if (length(axis) == 0) limit.axis[0] = 1;
  if (urdf.type == "continuous") limit.least[0] = -180, limit.most[0] = 180;
  if (urdf.type == "revolute") {
    limit.least[0] = static_cast<float>(std::max(-180.0, std::min(180.0, kDegrees * urdf.least)));
    limit.most[0] = static_cast<float>(std::max(-180.0, std::min(180.0, kDegrees * urdf.most)));
  }
  return limit;
}

}  // namespace

std::vector<sinew_joint_limit> urdf_joint_limits(const std::string& path, const MapRig& target) {
  const std::string text = read_text_file(path);
  const std::vector<UrdfJoint> joints = UrdfReader(path, text).read();
  const std::map<std::string, uint32_t> index = joints_by_name(target.joints);
  Pairs pairs;
  for (const UrdfJoint& joint : joints) {
    auto found = index.find(joint.child);
    if (found == index.end()) found = index.find(joint.name);
    if (found != index.end()) pairs.emplace_back(found->second, &joint);
  }
  if (pairs.empty())
    throw Error(path + ": none of its " + std::to_string(joints.size()) + " joints, nor their links, is one of " +
                target.name + " (its first is " + target.joints[0].name + ")");
  const Quaternion turn = world_turn(path, pairs, target);
  std::vector<sinew_joint_limit> limits;
  for (const auto& [joint, urdf] : pairs) {
    if (urdf->type == "floating" || urdf->type == "planar") continue;
    if (urdf->type == "revolute" && (!urdf->has_limit || !(urdf->least <= urdf->most)))
      throw Error(path + ":" + std::to_string(urdf->line) + ": expected <limit lower=\"...\" upper=\"...\"> of joint " +
                  in_quotes(urdf->name) + ", found " +
                  (urdf->has_limit ? "a lower limit above the upper one" : "none"));
    limits.push_back(limit_of(*urdf, joint, turn));
  }
  if (limits.empty()) throw Error(path + ": expected revolute joints, found none that " + target.name + " has");
  return limits;
}

}  // namespace sinew
