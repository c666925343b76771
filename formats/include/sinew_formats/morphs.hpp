// SPDX-License-Identifier: MIT
// Shapes that correct a skinned mesh: morph targets, driven by rotations of joints or by keys of a clip.
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

// A shape: displacements of vertices before skinning, in the bind pose, in world axes and the mesh's units.
struct MorphShape {
  std::string name;
  std::vector<uint32_t> vertices;  // rising
  std::vector<Vec3> moves;         // [vertices]
};

// A term of the sums that drive the shapes of one bend: nine values from the rotation of one joint, or from those of
// two joints. A rotation is relative to the parent joint, in world axes of the rest pose, as in
// MotionFrame::rotations, here a matrix R with the vector u = (R21 - R12, R02 - R20, R10 - R01) / 2, its axis times
// the sine of its angle.
//   one:  value 3 r + c is R(r, c) - I(r, c)
//   two:  value 3 r + c is u(r) of `joint` times u(c) of `with`
// All are 0 at rest and at most 2 for any rotation, and continuous at 180 degrees.
struct MorphTerm {
  size_t joint = 0, with = 0;                  // index into Character::joints; equal for one rotation
  std::vector<std::array<double, 9>> factors;  // [sums of the driver]
};

// The weight of a shape: `scale` times a sum of the driver, clamped to 0..1, as programs clamp weights. The two
// directions of a sum are two shapes, one with a negative scale.
struct MorphWeight {
  size_t shape = 0;  // index into Morphs::shapes
  size_t sum = 0;
  double scale = 1;
};

// Driver of the shapes of one bend. A sum adds its factors times the values over all terms: a polynomial in pose
// space (Lewis, Cordner and Fong 2000, Pose Space Deformation, use radial functions).
struct MorphDriver {
  size_t joint = 0;  // index into Character::joints
  std::vector<MorphWeight> weights;
  std::vector<MorphTerm> terms;

  size_t sum_count() const { return terms.empty() ? 0 : terms[0].factors.size(); }
};

// Weights of all shapes per frame, for one animation of the written document.
struct MorphClip {
  bool is_new = false;                      // one of GlbOptions::motion, else of the input document
  size_t animation = 0;                     // its index there
  double start = 0, frame_time = 1.0 / 30;  // seconds
  std::vector<std::vector<float>> weights;  // [frames][shapes]
};

struct Morphs {
  std::vector<MorphShape> shapes;
  std::vector<MorphDriver> drivers;
  std::vector<MorphClip> clips;
};

struct GlbOptions;  // io.hpp

// Writes like write_gltf(), with the shapes as morph targets after those of the meshes, with drivers
// (formats/spec/correctives.md) and animated weights. Everything else in an input document is kept.
void write_gltf_morphs(const std::string& path, const Character& character, const GlbOptions& options,
                       const Morphs& morphs);

// Reads the animations of a glTF file that move its skeleton, like read_gltf_motion(); there may be none.
struct OwnMotion {
  Motion motion;
  std::vector<MorphClip> keys;  // [clips] index of each in the document; weights are empty
};
OwnMotion read_own_motion(const std::string& path);

// Returns a joint's rotation relative to its parent, in a pose of skinning matrices.
Quaternion joint_rotation(const std::vector<Joint>& joints, const std::vector<Affine>& palette, size_t joint);
std::vector<Quaternion> joint_rotations(const std::vector<Joint>& joints, const std::vector<Affine>& palette);
// turns [J]: joint_rotations()
std::array<double, 9> term_values(const MorphTerm& term, const std::vector<Quaternion>& rotations);
// [sums of the driver]
std::vector<double> driver_sums(const MorphDriver& driver, const std::vector<Quaternion>& rotations);
// 0..1 [weights of the driver]
std::vector<double> driver_weights(const MorphDriver& driver, const std::vector<Quaternion>& rotations);
// Returns the weights of all shapes in a pose [shapes]; 0 for a shape without a driver.
std::vector<float> shape_weights(const std::vector<Joint>& joints, const Morphs& morphs,
                                 const std::vector<Affine>& palette);
// Returns the linear skinning matrix of a vertex. A vertex without weight does not move.
Affine blended_matrix(const std::vector<Influence>& row, const std::vector<Affine>& palette);
// Returns the vertices [V] displaced by the weighted shapes and skinned linearly, as in a program without sinew.
std::vector<Vec3> morphed_pose(const Character& character, const Morphs& morphs, const std::vector<float>& weights,
                               const std::vector<Affine>& palette);

}  // namespace sinew
#endif
