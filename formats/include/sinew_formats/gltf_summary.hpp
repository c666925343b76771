// SPDX-License-Identifier: MIT
// What a glTF file holds, counted and named: for people who look before they bind.
#ifndef SINEW_FORMATS_GLTF_SUMMARY_HPP
#define SINEW_FORMATS_GLTF_SUMMARY_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// One mesh as one node shows it; a mesh that several nodes show is there several times.
struct GltfMeshSummary {
  std::string name, node;  // node empty: no node shows it
  bool in_scene = false;   // the scene that is read
  size_t vertices = 0;     // as the file counts them, seams apart
  size_t primitives = 0;
  std::vector<std::string> morph_targets;
  int skin = -1;      // index into GltfSummary::skins
  std::string joint;  // without a skin: the joint above its node, which carries it whole; empty: none
};

struct GltfSkinSummary {
  std::string name;
  size_t joints = 0, joints_with_weight = 0;
  size_t meshes = 0;  // nodes of the scene that use it
  // Rest against bind pose: where the inverse bind matrices and the nodes' present transforms agree, all of world x
  // inverse bind are one matrix. The deviation of a joint is how far its vertices (its own position, when it has none)
  // would stand apart from where the matrix of most joints puts them, in longest sides of the skin's meshes.
  double deviation = 0;     // largest
  std::string farthest;     // its joint
  size_t joints_apart = 0;  // by more than kGltfPoseTolerance
};
constexpr double kGltfPoseTolerance = 0.001;

struct GltfAnimationSummary {
  std::string name;
  double seconds = 0;  // last key
  size_t channels = 0;
};

struct GltfImageSummary {
  std::string name;  // or its file
  size_t bytes = 0;  // 0: the file beside is missing
};

struct GltfSummary {
  std::string generator;
  size_t nodes = 0;
  std::vector<GltfMeshSummary> meshes;
  std::vector<GltfSkinSummary> skins;
  std::vector<std::string> materials;
  std::vector<GltfImageSummary> images;
  std::vector<GltfAnimationSummary> animations;
  std::vector<std::string> extensions_used, extensions_required;
};

// Reads a .gltf, .glb or .vrm. Throws Error as read_gltf does, but a file without a mesh is fine.
GltfSummary summarize_gltf(const std::string& path);

// A glTF's skins as the file shows them while nothing moves, against the pose that they were bound in.
struct GltfRest {
  bool agrees = true;             // the inverse bind matrices know one pose
  std::vector<Affine> shown;      // [J] skinning matrices from the character's vertices to where the file shows them
  std::vector<uint8_t> mirrored;  // [J] 1: the joint's node is scaled by a negative number
  std::vector<double> uneven;  // [J] largest over smallest scale along the node's axes, 1 for one that is scaled evenly
  double scale = 1;            // of the nodes above the skeleton: what most differs from 1
  std::string scaled_by;       // the node that has it
  std::vector<std::string> unused_skins;  // no mesh of any scene has them; names, or "skin 2"
};

// Of a character that was read from a glTF (or from what becomes one) and has its joints; nullopt for others. Throws Error for a document
// whose matrices cannot be read.
std::optional<GltfRest> gltf_rest(const Character& character);

}  // namespace sinew
#endif
