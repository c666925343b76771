// SPDX-License-Identifier: MIT
// A glTF document as a binary FBX.
#ifndef SINEW_FORMATS_FBX_FBX_WRITE_HPP
#define SINEW_FORMATS_FBX_FBX_WRITE_HPP

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fbx/fbx_binary.hpp"
#include "gltf/gltf_model.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Bytes of an FBX 7.5, y up, in centimeters (UnitScaleFactor 1): models, limbs, meshes with skins, shapes, materials and pictures, a bind pose,
// animations. Assimp's own writer is not used: its skins do not come back whole (github.com/assimp/assimp, issues about FBX export of bones).
//   model  a document as it was read; what glTF has beside these (cameras, lights, extensions) is left out
// Throws Error naming `path` for accessors that are broken.
std::vector<uint8_t> fbx_of(const std::string& path, const tinygltf::Model& model);

// Objects of an FBX and their connections, and the parts of a glTF document that become them.

constexpr double kFbxUnits = 100;            // centimeters a meter: the file's UnitScaleFactor is 1
constexpr double kFbxTicks = 46186158000.0;  // a second

struct FbxScene {
  std::vector<FbxNode> objects, connections;
  std::map<std::string, int32_t> counts;  // of objects by their kind
  int64_t last_id = 1000000;

  // Begins an object: kind { id, name, class }.
  FbxNode object(const char* kind, const std::string& name, const char* of, const char* type, int64_t* id);
  void add(const char* kind, FbxNode object);
  void connect(int64_t child, int64_t parent);
  void connect(int64_t child, int64_t parent, const char* property);
};

// Models of nodes and meshes.
struct FbxModels {
  std::vector<int64_t> nodes;   // [N] model of a node, 0: none
  std::vector<int64_t> meshes;  // [N] model that has the node's mesh, 0: none
  // A bind pose: models and where they stand, in the file's units.
  std::vector<std::pair<int64_t, Affine>> bound;
  // Channels of blend shapes, for animations. [N][targets]
  std::vector<std::vector<int64_t>> channels;
};

// Translation, rotation and scale as FBX has them; rotations are in degrees about x, then y, then z.
std::array<double, 3> fbx_euler(const Quaternion& rotation);
// Among the angles of one rotation those nearest to `before`.
std::array<double, 3> fbx_euler(const Quaternion& rotation, const std::array<double, 3>& before);
Affine in_fbx_units(Affine m);

// Each material, texture and picture; the ids of the materials. [materials]
std::vector<int64_t> add_fbx_materials(const tinygltf::Model& model, FbxScene* scene);
// Nodes of the scene as limbs, nulls and meshes with their skins and shapes.
//   whose  file that is written, for messages
FbxModels add_fbx_models(const std::string& whose, const tinygltf::Model& model, const GltfNodes& nodes,
                         const std::vector<int64_t>& materials, FbxScene* scene);
// Animations as stacks with a layer each.
void add_fbx_animations(const std::string& whose, const tinygltf::Model& model, const FbxModels& models,
                        FbxScene* scene);

// The geometry of a node's mesh, with the mesh's space for `frame`; skin and shapes are connected to it.
//   clusters  models of the joints of the node's skin, or empty
//   channels  gets one of each shape
// Returns its id, 0 for a mesh without triangles.
int64_t add_fbx_geometry(const std::string& whose, const tinygltf::Model& model, size_t node, const Affine& frame,
                         const std::vector<int64_t>& clusters, FbxScene* scene, std::vector<int>* materials,
                         std::vector<int64_t>* channels);

}  // namespace sinew
#endif
