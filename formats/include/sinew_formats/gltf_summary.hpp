// SPDX-License-Identifier: MIT
// Summary of a glTF file: counts and names, for `sinew inspect`.
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

// A mesh in a node; a mesh that several nodes use occurs several times.
struct GltfMeshSummary {
  std::string name, node;  // node is empty if no node uses it
  bool in_scene = false;   // in the scene that is read
  size_t vertices = 0;     // as counted in the file, not welded
  size_t primitives = 0;
  std::vector<std::string> morph_targets;
  int skin = -1;      // index into GltfSummary::skins
  std::string joint;  // without a skin: the ancestor joint that carries it; empty: none
};

struct GltfSkinSummary {
  std::string name;
  size_t joints = 0, joints_with_weight = 0;
  size_t meshes = 0;  // nodes of the scene that use it
  // Difference between rest and bind pose: if the inverse bind matrices and the current node transforms agree, world
  // x inverse bind is the same matrix for all joints. The deviation of a joint is the distance of its vertices (or of
  // its own position if it has none) from where the matrix of most joints puts them, in longest sides of the skin's
  // meshes.
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

// Reads a .gltf, .glb or .vrm. Throws Error like read_gltf(), but accepts a file without a mesh.
GltfSummary summarize_gltf(const std::string& path);

// Skins of a glTF in the file's rest pose, compared with their bind pose.
struct GltfRest {
  bool agrees = true;  // the inverse bind matrices share one pose
  std::vector<Affine>
      shown;  // [J] skinning matrices from the character's vertices to their positions in the file's rest pose
  std::vector<uint8_t> mirrored;  // [J] 1: the joint's node has a negative scale
  std::vector<double> uneven;     // [J] largest divided by smallest scale along the node's axes; 1 for a uniform scale
  double scale = 1;               // scale of the nodes above the skeleton that differs most from 1
  std::string scaled_by;          // the node with that scale
  std::vector<std::string> unused_skins;  // not used by a mesh of any scene; names, or "skin 2"
};

// For a character read from a glTF (or from a format converted to one) with its joints; nullopt for others. Throws
// Error for a document whose matrices cannot be read.
std::optional<GltfRest> gltf_rest(const Character& character);

}  // namespace sinew
#endif
