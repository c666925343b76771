// SPDX-License-Identifier: MIT
// VMD (MikuMikuDance): keys of bones by their Japanese standard names or English ones, with a curve to the key before. Legs follow the IK bones of their feet, as the
// program has it; other IK is left out. The rest pose is ours: a person of MMD's proportions with arms lowered, since the file has none.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <map>
#include <set>

#include "motion/person.hpp"
#include "motion/vmd_bones.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

constexpr size_t kHeader = 30, kKey = 111, kNameBytes = 15;
constexpr size_t kIkNameBytes = 20;                          // in the list of switches
constexpr size_t kListsBetween[] = {23, 61, 28, 9};          // bytes of a key: faces, camera, light, shadow
constexpr double kUnit = 0.08, kFps = 30, kArmsDown = 0.66;  // meters; radians of the rest pose's arms

// A key: the frame, the translation against the rest position, the rotation and the four curves to it: x, y, z,
// rotation.
struct Key {
  size_t frame = 0;
  Point3 translation{};
  Quaternion rotation = kNoRotation4;
  std::array<std::array<double, 4>, 4> curves{};  // x1 y1 x2 y2, of a Bezier curve from (0, 0) to (1, 1)

  bool moves() const { return length(translation) > 1e-6 || std::abs(rotation[3]) < 1 - 1e-9; }
};

// One of the bones that rotate a joint one after the other, in the file's order: models with English names have one
// an axis.
struct Bone {
  std::string part;
  std::vector<Key> keys;
};

// The height of the curve where it is `x` along.
double on_curve(const std::array<double, 4>& c, double x) {
  if (c[0] == c[1] && c[2] == c[3]) return x;
  const auto bezier = [](double a, double b, double s) {
    return 3 * s * (1 - s) * (1 - s) * a + 3 * s * s * (1 - s) * b + s * s * s;
  };
  double low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (bezier(c[0], c[2], middle) < x ? low : high) = middle;
  }
  return bezier(c[1], c[3], low);
}

// World rotations of a leg's two bones.
struct LegRotations {
  Quaternion upper, lower;
};

// Inverse kinematics of a leg: the knee is a hinge about its x axis and bends forward of its rest pose, then the whole leg swings to the goal by the shortest arc. A
// goal out of reach is pointed at.
//   upper, lower  from hip to knee and from knee to ankle at rest
//   thigh         world rotation of the upper bone as its own keys have it, which says where the knee points
//   reach         from the hip to where the ankle shall be, in the world
LegRotations leg_to(const Point3& upper, const Point3& lower, const Quaternion& thigh, const Point3& reach) {
  // |upper + rotated lower|^2 is a constant plus 2 (along cos(bend) + side sin(bend)).
  const double along = upper[1] * lower[1] + upper[2] * lower[2], side = upper[2] * lower[1] - upper[1] * lower[2];
  const double wanted = (dot(reach, reach) - dot(upper, upper) - dot(lower, lower)) / 2 - upper[0] * lower[0];
  const double found = std::atan2(side, along) + std::acos(std::clamp(wanted / std::hypot(along, side), -1.0, 1.0));
  const double bend = std::max(0.0, found);  // never farther back than at rest
  const Quaternion knee = axis_rotation(0, bend);
  const Point3 bent = rotate(thigh, upper + rotate(knee, lower));
  const Quaternion swung = normalized(multiply(rotation_between(bent, reach), thigh));
  return {swung, normalized(multiply(swung, knee))};
}

class VmdReader {
 public:
  VmdReader(const std::string& path, const std::vector<uint8_t>& bytes) : path_(path), bytes_(bytes) {}

  Motion read() {
    read_keys();
    add_joints();
    motion_.name = stem_of(path_);
    Clip clip;
    clip.name = motion_.name;
    clip.frame_time = 1 / kFps;
    for (size_t f = 0; f <= last_; ++f) clip.frames.push_back(frame_at_key(f));
    motion_.clips.push_back(std::move(clip));
    return std::move(motion_);
  }

 private:
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw Error(path_ + ": expected " + expected + ", found " + found);
  }
  void need(size_t at, size_t count) const {
    if (at > bytes_.size() || count > bytes_.size() - at)
      throw Error(path_ + ": truncated VMD, expected " + std::to_string(count) + " bytes at " + std::to_string(at) +
                  ", found " + std::to_string(bytes_.size() - std::min(at, bytes_.size())));
  }
  template <class T>
  T number(size_t at) const {
    T value;
    std::memcpy(&value, &bytes_[at], sizeof value);
    return value;
  }
  std::string text(size_t at, size_t most) const {
    const char* const begin = reinterpret_cast<const char*>(&bytes_[at]);
    return {begin, std::find(begin, begin + most, '\0')};
  }

  void read_keys() {
    need(0, kHeader);
    const std::string magic = text(0, kHeader);
    const bool old = magic == "Vocaloid Motion Data file";
    if (!old && magic != "Vocaloid Motion Data 0002") fail("a VMD (Vocaloid Motion Data 0002)", "other bytes");
    const size_t list = kHeader + (old ? 10 : 20);  // behind the model's name
    need(list, 4);
    const size_t count = number<uint32_t>(list);
    if (count == 0) fail("keys of bones", "none (a camera's motion, or a face's)");
    if (count > (bytes_.size() - list - 4) / kKey) need(list + 4, count * kKey);
    std::set<std::string> ik, others;
    for (size_t k = 0; k < count; ++k) {
      const size_t at = list + 4 + k * kKey;
      const std::string name = text(at, kNameBytes);
      const std::string joint = joint_of_vmd_bone(name);
      if (!joint.empty()) {
        std::vector<Key>& keys = bone_keys(joint, name);
        keys.push_back(read_key(at + kNameBytes, k));
        last_ = std::max(last_, keys.back().frame);
      } else if (!is_vmd_ik(name)) {
        others.insert(name);
      } else if (read_key(at + kNameBytes, k).moves()) {
        ik.insert(name);
      }
    }
    if (keys_.empty())
      fail("bones with standard names", std::to_string(others.size() + ik.size()) + " bones with others");
    tell(ik.size(), others.size());
    read_ik_switches(list + 4 + count * kKey);
    for (auto& [joint, bones] : keys_)
      for (auto& [name, keys] : bones)
        std::stable_sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.frame < b.frame; });
  }
  // Keys of the bone, or of an earlier bone of the joint with the same name in another spelling.
  std::vector<Key>& bone_keys(const std::string& joint, const std::string& name) {
    std::vector<Bone>& bones = keys_[joint];
    const std::string part = part_of_vmd_bone(name);
    const auto found = std::find_if(bones.begin(), bones.end(), [&](const Bone& bone) { return bone.part == part; });
    if (found != bones.end()) return found->keys;
    bones.push_back({part, {}});
    return bones.back().keys;
  }

  void tell(size_t ik, size_t others) {
    if (ik > 0) motion_.notes.push_back(print("%zu IK bones other than feet were left out", ik));
    if (others > 0) motion_.notes.push_back(print("%zu bones without a standard name were left out", others));
  }

  // Old files end before this list.
  void read_ik_switches(size_t at) {
    const auto has = [&](size_t count) { return at <= bytes_.size() && count <= bytes_.size() - at; };
    for (const size_t bytes : kListsBetween) {
      if (!has(4)) return;
      const size_t count = number<uint32_t>(at);
      at += 4 + count * bytes;
    }
    if (!has(4)) return;
    const size_t count = number<uint32_t>(at);
    at += 4;
    for (size_t k = 0; k < count && has(9); ++k) {
      const size_t frame = number<uint32_t>(at), names = number<uint32_t>(at + 5);
      at += 9;
      for (size_t n = 0; n < names && has(kIkNameBytes + 1); ++n, at += kIkNameBytes + 1)
        ik_switches_[joint_of_vmd_bone(text(at, kIkNameBytes))][frame] = bytes_[at + kIkNameBytes] != 0;
    }
  }

  // To a right-handed world: z is negated.
  Key read_key(size_t at, size_t number_of_key) {
    Key key;
    key.frame = number<uint32_t>(at);
    std::array<double, 7> v{};
    for (size_t i = 0; i < 7; ++i) {
      v[i] = static_cast<double>(number<float>(at + 4 + 4 * i));
      if (!(std::abs(v[i]) < 1e6)) fail("finite numbers in key " + std::to_string(number_of_key), "another");
    }
    key.translation = {kUnit * v[0], kUnit * v[1], -kUnit * v[2]};
    key.rotation = normalized({-v[3], -v[4], v[5], v[6]});
    for (size_t c = 0; c < 4; ++c)
      for (size_t i = 0; i < 4; ++i) key.curves[c][i] = std::min(127, int{bytes_[at + 32 + 16 * c + 4 * i]}) / 127.0;
    return key;
  }

  void add_joints() {
    std::vector<std::string> names;
    for (const std::string& name : vmd_joints()) {
      const std::string other = other_side_of_person(name);
      const bool control = name == "root" || name == "center" || name == "groove" || name == "waist" ||
                           name.find("Ik") != std::string::npos;
      const bool finger = name.find("Proximal") != std::string::npos ||
                          name.find("Intermediate") != std::string::npos || name.find("Distal") != std::string::npos ||
                          name.find("Metacarpal") != std::string::npos;
      if (control || (finger && keys_.count(name) + keys_.count(other) == 0)) continue;
      names.push_back(name);
      if (other != name) names.push_back(other);
    }
    // Controls above the two halves of the body, then the body.
    const std::vector<MotionJoint> body = person_joints(names);
    const Point3 hips = body[0].offset;
    motion_.joints = {{"root", -1, {}}, {"center", 0, hips}, {"groove", 1, {}}, {"waist", 2, {}}};
    for (MotionJoint joint : body) {
      joint.parent = joint.name == "hips" || joint.name == "spine" ? 3 : joint.parent + 4;
      if (joint.name == "hips") joint.offset = {};
      const bool left = joint.name.rfind("left", 0) == 0;
      if (is_below_shoulder(joint))
        joint.offset = rotate(axis_rotation(2, left ? -kArmsDown : kArmsDown), joint.offset);
      motion_.joints.push_back(std::move(joint));
    }
    rest_ = rest_joints(motion_);
    if (last_ >= kMostRotations / motion_.joints.size())
      fail("at most " + std::to_string(kMostRotations) + " frames times joints",
           "a key at frame " + std::to_string(last_));
  }
  bool is_below_shoulder(const MotionJoint& joint) const {
    for (int j = joint.parent; j >= 0; j = motion_.joints[static_cast<size_t>(j)].parent)
      if (motion_.joints[static_cast<size_t>(j)].name.find("UpperArm") != std::string::npos) return true;
    return false;
  }

  MotionFrame frame_at_key(size_t f) const {
    MotionFrame frame;
    for (const MotionJoint& joint : motion_.joints) {
      const Key key = key_at(joint.name, f);
      frame.rotations.push_back(key.rotation);
      frame.translations.push_back(joint.offset + key.translation);
    }
    for (const std::string side : {"left", "right"})
      if (has_ik(side, f)) put_foot(side, f, &frame);
    return frame;
  }
  Key key_at(const std::string& joint, size_t f) const {
    const auto bones = keys_.find(joint);
    Key key;
    if (bones == keys_.end()) return key;
    for (const Bone& bone : bones->second) {
      const Key own = between_keys(bone.keys, f);
      key.translation = key.translation + rotate(key.rotation, own.translation);
      key.rotation = multiply(key.rotation, own.rotation);
    }
    return key;
  }

  // Where the legs' own bones are keyed and the IK bone stands still, a program has baked the one into the other.
  bool has_ik(const std::string& side, size_t f) const {
    const auto move = [&](const char* joint) {
      const auto bones = keys_.find(side + joint);
      return bones != keys_.end() && std::any_of(bones->second.begin(), bones->second.end(), [](const Bone& bone) {
               return std::any_of(bone.keys.begin(), bone.keys.end(), [](const Key& key) { return key.moves(); });
             });
    };
    if (keys_.count(side + "FootIk") == 0 || (!move("FootIk") && !move("FootIkParent") && move("LowerLeg")))
      return false;
    const auto switches = ik_switches_.find(side + "FootIk");
    if (switches == ik_switches_.end()) return true;
    const auto above = switches->second.upper_bound(f);
    return above == switches->second.begin() || std::prev(above)->second;
  }

  // The ankle moves to its IK bone, a child of a parent on the floor below the root, and rotates like the bone.
  void put_foot(const std::string& side, size_t f, MotionFrame* frame) const {
    const auto index = [&](const char* joint) {
      return static_cast<size_t>(joint_named(motion_.joints, side + joint));
    };
    const size_t upper = index("UpperLeg"), lower = index("LowerLeg"), foot = index("Foot");
    const Key bone = key_at(side + "FootIk", f), carrier = key_at(side + "FootIkParent", f);
    const WorldPose pose = world_pose(motion_, *frame);
    const Point3 ankle = point(rest_[foot].position), floor = {ankle[0], 0, ankle[2]};
    const Point3 goal = floor + carrier.translation + rotate(carrier.rotation, ankle - floor + bone.translation);
    const Point3 reach = pose.positions[0] + rotate(pose.rotations[0], goal) - pose.positions[upper];
    const LegRotations leg =
        leg_to(motion_.joints[lower].offset, motion_.joints[foot].offset, pose.rotations[upper], reach);
    const Quaternion turn = multiply(pose.rotations[0], multiply(carrier.rotation, bone.rotation));
    const Quaternion above = pose.rotations[static_cast<size_t>(motion_.joints[upper].parent)];
    frame->rotations[upper] = normalized(multiply(conjugate(above), leg.upper));
    frame->rotations[lower] = normalized(multiply(conjugate(leg.upper), leg.lower));
    frame->rotations[foot] = normalized(multiply(conjugate(leg.lower), turn));
  }

  static Key between_keys(const std::vector<Key>& keys, size_t f) {
    const auto above =
        std::upper_bound(keys.begin(), keys.end(), f, [](size_t at, const Key& key) { return at < key.frame; });
    if (above == keys.begin()) return keys.front();
    const Key& from = above[-1];
    if (above == keys.end() || from.frame == f) return from;
    const double t = static_cast<double>(f - from.frame) / static_cast<double>(above->frame - from.frame);
    Key key;
    for (size_t i = 0; i < 3; ++i)
      key.translation[i] =
          from.translation[i] + on_curve(above->curves[i], t) * (above->translation[i] - from.translation[i]);
    key.rotation = slerp(from.rotation, above->rotation, on_curve(above->curves[3], t));
    return key;
  }

  const std::string path_;
  const std::vector<uint8_t>& bytes_;
  std::map<std::string, std::vector<Bone>> keys_;              // by joint, of rising frames
  std::map<std::string, std::map<size_t, bool>> ik_switches_;  // by joint and frame
  size_t last_ = 0;
  Motion motion_;
  std::vector<Joint> rest_;
};

}  // namespace

Motion read_vmd(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  return VmdReader(path, bytes).read();
}

}  // namespace sinew
