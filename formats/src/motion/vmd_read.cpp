// SPDX-License-Identifier: MIT
// VMD (MikuMikuDance): keys of bones by their Japanese standard names, with a curve to the key before. Bones as they are keyed: inverse
// kinematics is left out. The rest pose is ours: a person of MMD's proportions with arms lowered, since the file has none.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "motion/person.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

constexpr size_t kHeader = 30, kKey = 111, kNameBytes = 15;
constexpr double kUnit = 0.08, kFps = 30, kArmsDown = 0.66;  // metres; radians of the rest pose's arms
constexpr const char *kIk = "\x82\x68\x82\x6a", *kLeft = "\x8d\xb6", *kRight = "\x89\x45";  // Shift-JIS

struct BoneName {
  const char *shift_jis, *name;
};
// The left side alone. To add a bone: its name here, and in person.cpp where it stands.
constexpr BoneName kBones[] = {
    {"\x91\x53\x82\xc4\x82\xcc\x90\x65", "root"},                    // 全ての親
    {"\x83\x5a\x83\x93\x83\x5e\x81\x5b", "center"},                  // センター
    {"\x83\x4f\x83\x8b\x81\x5b\x83\x75", "groove"},                  // グルーブ
    {"\x8d\x98", "waist"},                                           // 腰
    {"\x89\xba\x94\xbc\x90\x67", "hips"},                            // 下半身
    {"\x8f\xe3\x94\xbc\x90\x67", "spine"},                           // 上半身
    {"\x8f\xe3\x94\xbc\x90\x67\x32", "chest"},                       // 上半身2
    {"\x8f\xe3\x94\xbc\x90\x67\x82\x51", "chest"},                   // 上半身２
    {"\x8e\xf1", "neck"},                                            // 首
    {"\x93\xaa", "head"},                                            // 頭
    {"\x8d\xb6\x8c\xa8", "leftShoulder"},                            // 左肩
    {"\x8d\xb6\x98\x72", "leftUpperArm"},                            // 左腕
    {"\x8d\xb6\x82\xd0\x82\xb6", "leftLowerArm"},                    // 左ひじ
    {"\x8d\xb6\x8e\xe8\x8e\xf1", "leftHand"},                        // 左手首
    {"\x8d\xb6\x91\xab", "leftUpperLeg"},                            // 左足
    {"\x8d\xb6\x82\xd0\x82\xb4", "leftLowerLeg"},                    // 左ひざ
    {"\x8d\xb6\x91\xab\x8e\xf1", "leftFoot"},                        // 左足首
    {"\x8d\xb6\x82\xc2\x82\xdc\x90\xe6", "leftToes"},                // 左つま先
    {"\x8d\xb6\x90\x65\x8e\x77\x82\x4f", "leftThumbMetacarpal"},     // 左親指０
    {"\x8d\xb6\x90\x65\x8e\x77\x82\x50", "leftThumbProximal"},       // 左親指１
    {"\x8d\xb6\x90\x65\x8e\x77\x82\x51", "leftThumbDistal"},         // 左親指２
    {"\x8d\xb6\x90\x6c\x8e\x77\x82\x50", "leftIndexProximal"},       // 左人指１
    {"\x8d\xb6\x90\x6c\x8e\x77\x82\x51", "leftIndexIntermediate"},   // 左人指２
    {"\x8d\xb6\x90\x6c\x8e\x77\x82\x52", "leftIndexDistal"},         // 左人指３
    {"\x8d\xb6\x92\x86\x8e\x77\x82\x50", "leftMiddleProximal"},      // 左中指１
    {"\x8d\xb6\x92\x86\x8e\x77\x82\x51", "leftMiddleIntermediate"},  // 左中指２
    {"\x8d\xb6\x92\x86\x8e\x77\x82\x52", "leftMiddleDistal"},        // 左中指３
    {"\x8d\xb6\x96\xf2\x8e\x77\x82\x50", "leftRingProximal"},        // 左薬指１
    {"\x8d\xb6\x96\xf2\x8e\x77\x82\x51", "leftRingIntermediate"},    // 左薬指２
    {"\x8d\xb6\x96\xf2\x8e\x77\x82\x52", "leftRingDistal"},          // 左薬指３
    {"\x8d\xb6\x8f\xac\x8e\x77\x82\x50", "leftLittleProximal"},      // 左小指１
    {"\x8d\xb6\x8f\xac\x8e\x77\x82\x51", "leftLittleIntermediate"},  // 左小指２
    {"\x8d\xb6\x8f\xac\x8e\x77\x82\x52", "leftLittleDistal"},        // 左小指３
};

// Of a key the frame, the translation against the rest position, the rotation and the four curves to it: x, y, z, rotation.
struct Key {
  size_t frame = 0;
  Point3 translation{};
  Quaternion rotation = kNoRotation4;
  std::array<std::array<double, 4>, 4> curves{};  // x1 y1 x2 y2, of a Bezier curve from (0, 0) to (1, 1)
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
      const std::string joint = joint_of(name);
      if (!joint.empty())
        keys_[joint].push_back(read_key(at + kNameBytes, k));
      else
        (name.find(kIk) != std::string::npos || name.find("IK") != std::string::npos ? ik : others).insert(name);
    }
    if (keys_.empty())
      fail("bones with standard names", std::to_string(others.size() + ik.size()) + " bones with others");
    tell(ik.size(), others.size());
    for (auto& [joint, keys] : keys_)
      std::stable_sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.frame < b.frame; });
  }

  void tell(size_t ik, size_t others) {
    const bool legs = keys_.count("leftLowerLeg") + keys_.count("leftUpperLeg") > 0;
    if (ik > 0)
      motion_.notes.push_back(print("%zu IK bones were left out%s", ik,
                                    legs ? "" : ", and nothing else moves the legs; bake IK into bones first"));
    if (others > 0) motion_.notes.push_back(print("%zu bones without a standard name were left out", others));
  }

  static std::string joint_of(const std::string& name) {
    const bool right = name.rfind(kRight, 0) == 0;
    const std::string left = right ? kLeft + name.substr(2) : name;
    for (const BoneName& bone : kBones)
      if (left == bone.shift_jis) return right ? other_side_of_person(bone.name) : bone.name;
    return "";
  }

  // To a right-handed world: z the other way.
  Key read_key(size_t at, size_t number_of_key) {
    Key key;
    key.frame = number<uint32_t>(at);
    std::array<double, 7> v{};
    for (size_t i = 0; i < 7; ++i) {
      v[i] = static_cast<double>(number<float>(at + 4 + 4 * i));
      if (!(std::abs(v[i]) < 1e6)) fail("finite numbers in key " + std::to_string(number_of_key), "another");
    }
    key.translation = {kUnit * v[0], kUnit * v[1], -kUnit * v[2]};
    key.rotation = normalised({-v[3], -v[4], v[5], v[6]});
    for (size_t c = 0; c < 4; ++c)
      for (size_t i = 0; i < 4; ++i) key.curves[c][i] = std::min(127, int{bytes_[at + 32 + 16 * c + 4 * i]}) / 127.0;
    last_ = std::max(last_, key.frame);
    return key;
  }

  void add_joints() {
    std::vector<std::string> names;
    for (const BoneName& bone : kBones) {
      const std::string name = bone.name, other = other_side_of_person(name);
      const bool control = name == "root" || name == "center" || name == "groove" || name == "waist";
      const bool finger = name.find("Proximal") != std::string::npos ||
                          name.find("Intermediate") != std::string::npos || name.find("Distal") != std::string::npos ||
                          name.find("Metacarpal") != std::string::npos;
      if (control || (finger && keys_.count(name) + keys_.count(other) == 0)) continue;
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
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
      const auto keys = keys_.find(joint.name);
      const Key key = keys == keys_.end() ? Key() : between_keys(keys->second, f);
      frame.rotations.push_back(key.rotation);
      frame.translations.push_back(joint.offset + key.translation);
    }
    return frame;
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
  std::map<std::string, std::vector<Key>> keys_;  // by joint, of rising frames
  size_t last_ = 0;
  Motion motion_;
};

}  // namespace

Motion read_vmd(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  return VmdReader(path, bytes).read();
}

}  // namespace sinew
