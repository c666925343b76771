// SPDX-License-Identifier: MIT
// Shapes that correct a skinned mesh: morph targets, and what turns them on: rotations of joints, or keys of a clip.
#ifndef SINEW_FORMATS_MORPHS_HPP
#define SINEW_FORMATS_MORPHS_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Vertices moved before skinning, in the pose that the weights are meant for, world axes, the mesh's units.
struct MorphShape {
  std::string name;
  std::vector<uint32_t> vertices;  // rising
  std::vector<Vec3> moves;         // [vertices]
};

// A part of the sums that drive one bend's shapes: nine values that one turn gives, or two turns together. A turn is a joint's rotation
// against its parent joint, world axes of the rest pose, as in MotionFrame::rotations, here a matrix R with the vector
// u = (R21 - R12, R02 - R20, R10 - R01) / 2, its axis times the sine of its angle.
//   one:  value 3 r + c is R(r, c) - I(r, c)
//   two:  value 3 r + c is u(r) of `joint` times u(c) of `with`
// All are 0 at rest, none passes 2 however far the joints turn, and half a turn is no jump.
struct MorphTerm {
  size_t joint = 0, with = 0;                  // index into Character::joints; the same for one turn
  std::vector<std::array<double, 9>> factors;  // [sums of the driver]
};

// The weight of a shape: `scale` times a sum of the driver, but no less than 0 and no more than 1, as programs clamp it. The two directions of a sum are two
// shapes, one with a negative scale.
struct MorphWeight {
  size_t shape = 0;  // index into Morphs::shapes
  size_t sum = 0;
  double scale = 1;
};

// Shapes of one bend. A sum is that of its factors times the values, over all terms: a polynomial of the pose
// space (Lewis, Cordner and Fong 2000, Pose Space Deformation, have radial functions of it).
struct MorphDriver {
  size_t joint = 0;  // index into Character::joints
  std::vector<MorphWeight> weights;
  std::vector<MorphTerm> terms;

  size_t sum_count() const { return terms.empty() ? 0 : terms[0].factors.size(); }
};

// Weights of all shapes frame by frame, for one animation of the written document.
struct MorphClip {
  bool is_new = false;                      // one of GlbOptions::motion, else of the input's own document
  size_t animation = 0;                     // its number there
  double start = 0, frame_time = 1.0 / 30;  // seconds
  std::vector<std::vector<float>> weights;  // [frames][shapes]
};

struct Morphs {
  std::vector<MorphShape> shapes;
  std::vector<MorphDriver> drivers;
  std::vector<MorphClip> clips;
};

struct GlbOptions;  // io.hpp

// Writes what write_gltf() does, and the shapes as morph targets behind those that its meshes have, with drivers
// (formats/spec/correctives.md) and weights over time. Everything else of an input's own document stays.
void write_gltf_morphs(const std::string& path, const Character& character, const GlbOptions& options,
                       const Morphs& morphs);

// The animations of a glTF file that move its skeleton, as read_gltf_motion() reads them; none is fine.
struct OwnMotion {
  Motion motion;
  std::vector<MorphClip> keys;  // [clips] where each stands in the document; weights are empty
};
OwnMotion read_own_motion(const std::string& path);

// The joint's turn in a pose of skinning matrices, its parent's taken off.
Quaternion joint_rotation(const std::vector<Joint>& joints, const std::vector<Affine>& palette, size_t joint);
std::vector<Quaternion> joint_rotations(const std::vector<Joint>& joints, const std::vector<Affine>& palette);
// turns [J]: joint_rotations()
std::array<double, 9> term_values(const MorphTerm& term, const std::vector<Quaternion>& rotations);
// [sums of the driver]
std::vector<double> driver_sums(const MorphDriver& driver, const std::vector<Quaternion>& rotations);
// 0..1 [weights of the driver]
std::vector<double> driver_weights(const MorphDriver& driver, const std::vector<Quaternion>& rotations);
// Weights of all shapes in a pose; a shape without a driver has 0. [shapes]
std::vector<float> shape_weights(const std::vector<Joint>& joints, const Morphs& morphs,
                                 const std::vector<Affine>& palette);
// The matrix that linear skinning gives a vertex. A row without weight stands still.
Affine blended_matrix(const std::vector<Influence>& row, const std::vector<Affine>& palette);
// Linear skinning of the vertices moved by the weighted shapes: what a program without sinew shows. [V]
std::vector<Vec3> morphed_pose(const Character& character, const Morphs& morphs, const std::vector<float>& weights,
                               const std::vector<Affine>& palette);

}  // namespace sinew
#endif
