// SPDX-License-Identifier: MIT
// The pose that a glTF file's skins were bound in. Nodes stand in whatever pose the file was saved in, perhaps a frame
// of an animation; the inverse bind matrices remember the other one.
#ifndef SINEW_FORMATS_GLTF_BIND_POSE_HPP
#define SINEW_FORMATS_GLTF_BIND_POSE_HPP

#include <string>
#include <vector>

#include "gltf/gltf_model.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// How much weight the joints of each skin have in the meshes of the scene.
using SkinWeights = std::vector<std::vector<double>>;  // [skins][joints of the skin]

// Two transforms are one when they move no corner of a box of this size apart by more than this share of the size.
constexpr double kSamePose = 1e-3;

// Whether `a` and `b` do the same to the points within `size` of the origin's mesh box, see kSamePose.
bool same_pose(const Affine& a, const Affine& b, const std::vector<Vec3>& box_corners, double size);

// What a skin's joints do to its vertices while nobody moves them: world x inverse bind matrix.
std::vector<Affine> skin_palette(const std::string& where, const tinygltf::Model& model, const GltfNodes& nodes,
                                 int skin);

// The pose of the inverse bind matrices where those of all joints with weight agree on one; the nodes' present pose
// where it is the same. Where they agree on none, `agrees` is false, and meshes stand as their weights hold them.
GltfBindPose find_bind_pose(const std::string& path, const tinygltf::Model& model, const GltfNodes& nodes,
                            const SkinWeights& weights);

}  // namespace sinew
#endif
