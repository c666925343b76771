// SPDX-License-Identifier: MIT
// A glTF document as tinygltf parses it: its node tree, the values of its accessors, its bind matrices and the pose they were made in.
#ifndef SINEW_FORMATS_GLTF_GLTF_MODEL_HPP
#define SINEW_FORMATS_GLTF_GLTF_MODEL_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

// tinygltf under a namespace of our own: Debian's libdraco exports another version of it, and a program that loads both
// would mix the two. So it is compiled here (tinygltf.cpp), without the picture codecs that nothing needs.

#define tinygltf sinew_tinygltf
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace sinew {

// Node transforms in the bind pose of the file's weights.
struct GltfBindPose {
  bool agrees = true;               // false: the inverse bind matrices know no common pose, see find_bind_pose()
  bool moved = false;               // the bind pose differs from the node transforms
  std::vector<Affine> worlds;       // [nodes] of joints and their descendants
  std::vector<Affine> skin_frames;  // [skins] where a skin's vertices stand; worlds[joint] x inverse bind matrix
};

// "image/png", "image/jpeg", "image/webp", "image/ktx2" by the first bytes; nullptr for anything else.
const char* image_type(const std::vector<unsigned char>& bytes);

// The node tree. Throws Error when it is none.
struct GltfNodes {
  std::vector<int> parents;    // [N], -1 = none
  std::vector<Affine> worlds;  // [N]
  std::vector<char> in_scene;  // [N] in the default scene (else the first; without scenes, every node)
};
GltfNodes gltf_nodes(const std::string& path, const tinygltf::Model& model);

// Values of an accessor [count x components], sparse ones and normalized integers resolved. Throws Error naming `where`
// when it is not of that many components, reaches outside of its buffer or holds a value that is not finite.
std::vector<float> accessor_floats(const std::string& where, const tinygltf::Model& model, int accessor,
                                   int components);
std::vector<uint32_t> accessor_integers(const std::string& where, const tinygltf::Model& model, int accessor,
                                        int components);
// [joints of the skin]
std::vector<Affine> inverse_bind_matrices(const std::string& where, const tinygltf::Model& model,
                                          const tinygltf::Skin& skin);

// Triangles of lists, strips and fans, in the order of a Character's faces.
//   vertex_count  of the primitive
// Throws Error naming `where` for indices that name no vertex, or a list that is not in threes.
std::vector<std::array<uint32_t, 3>> primitive_triangles(const std::string& where, const tinygltf::Model& model,
                                                         const tinygltf::Primitive& primitive, size_t vertex_count);

// The bind pose of a glTF file's skins. Node transforms are the pose in which the file was saved, perhaps a frame of
// an animation; the inverse bind matrices give the bind pose.

// How much weight the joints of each skin have in the meshes of the scene.
using SkinWeights = std::vector<std::vector<double>>;  // [skins][joints of the skin]

// Two transforms are one when they move no corner of a box of this size apart by more than this share of the size.
constexpr double kSamePose = 1e-3;

// Whether `a` and `b` do the same to the points within `size` of the origin's mesh box, see kSamePose.
bool same_pose(const Affine& a, const Affine& b, const std::vector<Vec3>& box_corners, double size);

// Returns a skin's palette in the file's rest pose: world x inverse bind matrix.
std::vector<Affine> skin_palette(const std::string& where, const tinygltf::Model& model, const GltfNodes& nodes,
                                 int skin);

// The pose of the inverse bind matrices where those of all joints with weight agree on one; the nodes' present pose
// where it is the same. Where they agree on none, `agrees` is false, and meshes stand as their weights hold them.
GltfBindPose find_bind_pose(const std::string& path, const tinygltf::Model& model, const GltfNodes& nodes,
                            const SkinWeights& weights);

}  // namespace sinew
#endif
