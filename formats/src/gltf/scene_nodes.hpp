// SPDX-License-Identifier: MIT
// Parts of a scene that Assimp read: its nodes, in meters with Y up, and which of them are joints; its materials and animations as a glTF
// document's. Only where the build has Assimp.
#ifndef SINEW_FORMATS_GLTF_SCENE_NODES_HPP
#define SINEW_FORMATS_GLTF_SCENE_NODES_HPP

#include <assimp/scene.h>

#include <map>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct SceneNode {
  const aiNode* node = nullptr;
  int parent = -1;
  Affine world = kIdentity;
  bool bone = false;          // moves vertices
  bool bones_below = false;   // itself not counted
  bool meshes_below = false;  // itself counted
  bool not_a_joint = false;   // a locator, a camera, a light; known from FBX, not from COLLADA
  bool joint = false;
  std::map<int, Affine> binds = {};  // by mesh node
};

// Parents before children; 0 is the scene's root.
struct SceneNodes {
  std::vector<SceneNode> nodes;
  std::vector<Affine> locals;             // [nodes]
  std::map<std::string, size_t> by_name;  // of equal names the bone, else the first
  std::map<const aiBone*, size_t> bone_nodes;
  std::vector<size_t> joint_nodes;        // joint -> node
  std::map<size_t, size_t> joint_number;  // node -> joint
};

// Throws Error, which begins with `path`, for transforms that are not finite and bones without a node.
SceneNodes find_scene_nodes(const std::string& path, const aiScene& scene);

Affine affine_of(const aiMatrix4x4& matrix);
bool is_finite(const Affine& transform);

// Adds all materials, in their order. Its notes list pictures that are missing or not PNG or JPEG.
void add_scene_materials(const std::string& path, const aiScene& scene, GltfSource* source);

// Adds every animation that moves a node of the document; its notes list the others. Nodes are found by name and
// number, 0 is the scene's root, which stays. Keys are those of the file, from the first one on; a track that stands
// still has its first and last. Throws Error for numbers that are not finite.
void add_scene_animations(const std::string& path, const aiScene& scene, const std::map<std::string, size_t>& nodes,
                          GltfSource* source);

}  // namespace sinew
#endif
