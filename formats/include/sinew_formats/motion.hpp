// SPDX-License-Identifier: MIT
// Motion of a skeleton: readers, writers and operations on clips.
#ifndef SINEW_FORMATS_MOTION_HPP
#define SINEW_FORMATS_MOTION_HPP

#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// At rest all joints have world axes, as in a BVH file; readers of other formats convert their poses.
struct MotionJoint {
  std::string name;
  int parent = -1;     // index into Motion::joints; any order
  Point3 offset = {};  // from the parent at rest; for a root from the origin
  bool end = false;    // only the end of a bone: a BVH's End Site, which does not rotate
};

// One pose: local rotations relative to the rest pose, and positions relative to the parents, in the parent's rotated
// axes.
struct MotionFrame {
  std::vector<Quaternion> rotations;  // [J]
  std::vector<Point3> translations;   // [J] equal to its offset for a joint that keeps its position
};

constexpr size_t kMostRotations = size_t{1} << 24;  // limit on frames times joints of a clip

struct Clip {
  std::string name;
  double frame_time = 1.0 / 30;  // seconds
  std::vector<MotionFrame> frames;
};

struct Motion {
  std::string name;  // file stem
  std::vector<MotionJoint> joints;
  std::vector<Clip> clips;
  std::vector<std::string> notes;  // notes of the reader for the user, one line each
  bool rest_stands = false;        // the rest pose is known to be a standing pose; else standing_motion() decides
};

// Reads .bvh, .vmd, .amc, .npy, .npz, .vrma, or an animated .gltf, .glb, .vrm, .fbx or .dae. Animations are sampled
// at `fps` frames per second; 0 = at the rate of their keys, or 30 without one. `layout` is the keypoint layout of a
// NumPy file (motion_layouts()), "" = guessed. Throws Error for a file without motion.
Motion read_motion(const std::string& path, double fps = 0, const std::string& layout = "");
Motion read_bvh(const std::string& path);
Motion read_vmd(const std::string& path);
// Reads a .amc with the .asf beside it that has the same name, the start of the name, or is the only one.
Motion read_amc(const std::string& path);
Motion read_numpy_motion(const std::string& path, const std::string& layout = "");
// Reads glTF and what is converted to it. Joints are those of read_gltf(), in its order and with its names, then
// animated nodes above and below them; without a skin all animated nodes. The rest pose is the bind pose of the skin.
Motion read_gltf_motion(const std::string& path, double fps = 0);

// "smpl24, humanml3d22, ...".
std::string motion_layouts();

// Selects one of several people in a file. A person is the skeleton below a root with at least 8 joints, 5 of them
// ends, and at least half as many joints as the largest one; if one root carries all, the skeletons below its
// children. `actor` is the name or number of such a root; "" selects the first one with a note if all are equal.
// Returns nullopt if the motion is unchanged. Throws Error that lists the actors.
std::optional<Motion> one_actor(const Motion& motion, const std::string& file, const std::string& actor);

// Writes one clip as BVH: channels Zrotation Xrotation Yrotation, and positions for roots and joints that change
// their position.
void write_bvh(const std::string& path, const Motion& motion, const Clip& clip);

// Writes a .vrma. Joints have the names of VRM 1.0 humanoid bones and a T pose at rest, y up and facing +z.
void write_vrm_animation(const std::string& path, const Motion& motion);

// Converts joints: world positions at rest, names, parents.
std::vector<Joint> rest_joints(const Motion& motion);
// Makes a motion without clips whose rest pose is the character's.
Motion motion_of(const std::vector<Joint>& joints);

// Finds a clip by name or index ("3" is the fourth unless a clip has that name); an empty name selects the only clip.
// Throws Error that lists the names.
const Clip& find_clip(const Motion& motion, const std::string& file, const std::string& name);
// Cuts out the frames from `from` to `to` seconds.
Clip cut(const Clip& clip, double from, double to);
// Resamples a clip: rotations are interpolated along the shortest arc, positions linearly.
Clip resample(const Clip& clip, double fps);
MotionFrame frame_at(const Clip& clip, double seconds);

// World rotations relative to the rest pose, and positions. [J]
struct WorldPose {
  std::vector<Quaternion> rotations;
  std::vector<Point3> positions;
};
WorldPose world_pose(const Motion& motion, const MotionFrame& frame);
// Pose times inverse bind for the first `count` joints.
std::vector<Affine> motion_palette(const Motion& motion, const MotionFrame& frame, size_t count);

// Returns whether a file holds keypoints (positions only). check_layout() throws Error if its joints have names.
bool takes_layout(const std::string& path);
void check_layout(const std::string& path);

}  // namespace sinew
#endif
