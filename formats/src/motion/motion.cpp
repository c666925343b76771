// SPDX-License-Identifier: MIT
// Clips found, cut, resampled, and posed in the world.
#include "sinew_formats/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

Point3 sum(const Point3& a, const Point3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

MotionFrame between(const MotionFrame& a, const MotionFrame& b, double t) {
  if (t <= 0) return a;
  if (t >= 1) return b;
  MotionFrame out;
  for (size_t j = 0; j < a.rotations.size(); ++j) {
    out.rotations.push_back(slerp(a.rotations[j], b.rotations[j], t));
    Point3 position{};
    for (size_t i = 0; i < 3; ++i)
      position[i] = a.translations[j][i] + t * (b.translations[j][i] - a.translations[j][i]);
    out.translations.push_back(position);
  }
  return out;
}

std::string names_of(const Motion& motion) {
  constexpr size_t kMost = 20;
  std::string names;
  for (size_t c = 0; c < motion.clips.size() && c < kMost; ++c)
    names += (c == 0 ? "" : ", ") + in_quotes(motion.clips[c].name);
  return names + (motion.clips.size() > kMost ? ", ..." : "");
}

}  // namespace

std::vector<Joint> rest_joints(const Motion& motion) {
  std::vector<Point3> positions(motion.joints.size());
  for (const size_t j : JointTree(motion.joints).parents_first) {
    const MotionJoint& joint = motion.joints[j];
    positions[j] = joint.parent < 0 ? joint.offset : sum(positions[static_cast<size_t>(joint.parent)], joint.offset);
  }
  std::vector<Joint> joints;
  for (size_t j = 0; j < motion.joints.size(); ++j)
    joints.push_back({motion.joints[j].name,
                      {static_cast<float>(positions[j][0]), static_cast<float>(positions[j][1]),
                       static_cast<float>(positions[j][2])},
                      motion.joints[j].parent});
  return joints;
}

Motion motion_of(const std::vector<Joint>& joints) {
  Motion motion;
  for (const Joint& joint : joints) {
    const Vec3 from = joint.parent < 0 ? Vec3{} : joints[static_cast<size_t>(joint.parent)].position;
    const auto difference = [](float a, float b) { return static_cast<double>(a) - static_cast<double>(b); };
    motion.joints.push_back({joint.name,
                             joint.parent,
                             {difference(joint.position.x, from.x), difference(joint.position.y, from.y),
                              difference(joint.position.z, from.z)}});
  }
  return motion;
}

const Clip& find_clip(const Motion& motion, const std::string& file, const std::string& name) {
  if (name.empty() && motion.clips.size() == 1) return motion.clips[0];
  if (name.empty())
    throw Error(file + ": expected the name of one of its " + std::to_string(motion.clips.size()) +
                " clips, found none; give " + file + "#NAME with NAME one of " + names_of(motion));
  for (const Clip& clip : motion.clips)
    if (clip.name == name) return clip;
  const std::optional<int64_t> number = to_integer(name);
  if (number && *number >= 0 && static_cast<size_t>(*number) < motion.clips.size())
    return motion.clips[static_cast<size_t>(*number)];
  throw Error(file + ": expected one of its clips, " + names_of(motion) + ", found " + in_quotes(name));
}

Clip cut(const Clip& clip, double from, double to) {
  Clip out = {clip.name, clip.frame_time, {}};
  for (size_t f = 0; f < clip.frames.size(); ++f) {
    const double seconds = static_cast<double>(f) * clip.frame_time;
    if (seconds >= from - 1e-6 && seconds <= to + 1e-6) out.frames.push_back(clip.frames[f]);
  }
  return out;
}

MotionFrame frame_at(const Clip& clip, double seconds) {
  const double at = std::clamp(seconds / clip.frame_time, 0.0, static_cast<double>(clip.frames.size() - 1));
  const size_t below = static_cast<size_t>(at), above = std::min(below + 1, clip.frames.size() - 1);
  return between(clip.frames[below], clip.frames[above], at - static_cast<double>(below));
}

Clip resample(const Clip& clip, double fps) {
  Clip out = {clip.name, 1 / fps, {}};
  const double seconds = static_cast<double>(clip.frames.size() - 1) * clip.frame_time;
  const size_t count = static_cast<size_t>(seconds * fps + 1e-6) + 1;
  for (size_t f = 0; f < count; ++f) out.frames.push_back(frame_at(clip, static_cast<double>(f) / fps));
  return out;
}

WorldPose world_pose(const Motion& motion, const MotionFrame& frame) {
  WorldPose pose;
  pose.rotations.resize(motion.joints.size(), kNoRotation4);
  pose.positions.resize(motion.joints.size());
  for (const size_t j : JointTree(motion.joints).parents_first) {
    const int above = motion.joints[j].parent;
    if (above < 0) {
      pose.rotations[j] = frame.rotations[j];
      pose.positions[j] = frame.translations[j];
      continue;
    }
    const size_t parent = static_cast<size_t>(above);
    pose.rotations[j] = multiply(pose.rotations[parent], frame.rotations[j]);
    pose.positions[j] = sum(pose.positions[parent], rotate(pose.rotations[parent], frame.translations[j]));
  }
  return pose;
}

std::vector<Affine> motion_palette(const Motion& motion, const MotionFrame& frame, size_t count) {
  const WorldPose pose = world_pose(motion, frame);
  const std::vector<Joint> rest = rest_joints(motion);
  std::vector<Affine> palette;
  for (size_t j = 0; j < count; ++j) {
    const Rotation r = rotation_of(pose.rotations[j]);
    const Point3 from = {static_cast<double>(rest[j].position.x), static_cast<double>(rest[j].position.y),
                         static_cast<double>(rest[j].position.z)};
    Affine m{};
    for (size_t row = 0; row < 3; ++row) {
      m[4 * row + 3] = pose.positions[j][row];
      for (size_t c = 0; c < 3; ++c) {
        m[4 * row + c] = r[3 * row + c];
        m[4 * row + 3] -= r[3 * row + c] * from[c];
      }
    }
    palette.push_back(m);
  }
  return palette;
}

bool takes_layout(const std::string& path) {
  const FileKind* kind = file_kind(path);
  return kind != nullptr && kind->reader == FileReader::kNumpy;
}

void check_layout(const std::string& path) {
  if (takes_layout(path)) return;
  throw Error(path + ": --layout is for the keypoints of a .npy or .npz (" + motion_layouts() +
              "), but the joints of this file have names; leave it out");
}

Motion read_motion(const std::string& path, double fps, const std::string& layout) {
  if (!has_use(path, kReadsMotion))
    throw Error(path + ": expected a motion (" + extensions_text(kReadsMotion) + "), found another extension" +
                remedy(path));
  if (!layout.empty()) check_layout(path);
  switch (file_kind(path)->reader) {
    case FileReader::kBvh:
      return read_bvh(path);
    case FileReader::kVmd:
      return read_vmd(path);
    case FileReader::kAmc:
      return read_amc(path);
    case FileReader::kNumpy:
      return read_numpy_motion(path, layout);
    default:
      return read_gltf_motion(path, fps);
  }
}

}  // namespace sinew
