// SPDX-License-Identifier: MIT
// Recorded motion of a skeleton: BVH files and glTF animations in, both out, and what is done with clips between.
#ifndef SINEW_FORMATS_MOTION_HPP
#define SINEW_FORMATS_MOTION_HPP

#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// At rest every joint's axes are those of the world, as in a BVH file; readers of others turn their poses into this.
struct MotionJoint {
  std::string name;
  int parent = -1;     // index into Motion::joints; any order
  Point3 offset = {};  // from the parent at rest, a root's from the origin
  bool end = false;    // of a bone alone: a BVH's End Site, which never turns
};

// One pose: local turns against the rest pose, and where joints stand from their parents, in the parent's turned axes.
struct MotionFrame {
  std::vector<Quaternion> rotations;  // [J]
  std::vector<Point3> translations;   // [J] a joint that keeps its position has its offset here
};

constexpr size_t kMostRotations = size_t{1} << 24;  // frames times joints of a clip that a file may ask for

struct Clip {
  std::string name;
  double frame_time = 1.0 / 30;  // seconds
  std::vector<MotionFrame> frames;
};

struct Motion {
  std::string name;  // file stem
  std::vector<MotionJoint> joints;
  std::vector<Clip> clips;
  std::vector<std::string> notes;  // remarks of the reader for the user, a line each
  bool rest_stands = false;        // the rest pose is known to be a stance; else standing_motion() judges it
};

// .bvh, .vmd, .amc, .npy, .npz, .vrma, or an animated .gltf, .glb, .vrm, .fbx or .dae. Animations are sampled at `fps` frames a second, 0 = at the
// rate of their own keys, 30 where these have none. `layout` says which joints the places of a NumPy file are (keypoint_layouts()), ""
// asks for a guess. Throws Error for a file without motion.
Motion read_motion(const std::string& path, double fps = 0, const std::string& layout = "");
Motion read_bvh(const std::string& path);
Motion read_vmd(const std::string& path);
// With the .asf of its name beside it, or of the beginning of its name, or the only one there.
Motion read_amc(const std::string& path);
Motion read_numpy_motion(const std::string& path, const std::string& layout = "");
// The same for all but BVH. Joints are those that read_gltf() gives, in its order and with its names, then animated nodes above and below them; in a
// file without a skin all animated nodes. The rest pose is the one that the skin was bound in.
Motion read_gltf_motion(const std::string& path, double fps = 0);

// "smpl24, humanml3d22, ...".
std::string motion_layouts();

// One of several people in a file: the skeleton below a root that has at least 8 joints, 5 of them ends, and at least half of the largest
// one's; where one root carries all, below its children. `actor` is such a root's name or number; "" means the first where all are alike, which
// is noted. nullopt where that leaves the motion as it is. Throws Error that lists them.
std::optional<Motion> one_actor(const Motion& motion, const std::string& file, const std::string& actor);

// One clip; channels Zrotation Xrotation Yrotation, positions for roots and for joints that leave their position.
void write_bvh(const std::string& path, const Motion& motion, const Clip& clip);

// .vrma: joints are called as the humanoid bones of VRM 1.0 and stand in a T pose, y up and facing +z.
void write_vrm_animation(const std::string& path, const Motion& motion);

// Positions at rest in the world, names, parents.
std::vector<Joint> rest_joints(const Motion& motion);
// A motion's skeleton for clips to be made: its rest pose is the character's.
Motion motion_of(const std::vector<Joint>& joints);

// By name; "3" is the fourth where no clip is called so; the only clip for an empty name. Throws Error that lists the names.
const Clip& find_clip(const Motion& motion, const std::string& file, const std::string& name);
// Frames from `from` to `to` seconds.
Clip cut(const Clip& clip, double from, double to);
// Frames at another rate over the same time: turns along the shortest arc at constant speed, positions along lines.
Clip resample(const Clip& clip, double fps);
MotionFrame frame_at(const Clip& clip, double seconds);

// Turns against the rest pose in the world, and positions. [J]
struct WorldPose {
  std::vector<Quaternion> rotations;
  std::vector<Point3> positions;
};
WorldPose world_pose(const Motion& motion, const MotionFrame& frame);
// Pose times inverse bind for the first `count` joints.
std::vector<Affine> motion_palette(const Motion& motion, const MotionFrame& frame, size_t count);

// Whether a file's joints are places alone. check_layout() throws Error where they say themselves which they are.
bool takes_layout(const std::string& path);
void check_layout(const std::string& path);

}  // namespace sinew
#endif
