// SPDX-License-Identifier: MIT
// A mesh as programs of modelling want it: vertices that seams of normals and textures do not part, and where its skin puts it.
#ifndef SINEW_FORMATS_GLTF_CONTROL_POINTS_HPP
#define SINEW_FORMATS_GLTF_CONTROL_POINTS_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "gltf/gltf_model.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct ControlShape {
  std::string name;
  double weight = 0;                   // at rest
  std::vector<int32_t> points;         // that move
  std::vector<double> moves, normals;  // [points x 3]
};

// Points are vertices of equal position, weights and shapes; normals, texture coordinates and colors are their
// corners'.
struct ControlPoints {
  std::string name, where;  // `where` is for messages
  bool has_normals = true, has_uvs = true, has_colors = true;
  std::vector<double> positions;             // [points x 3] in the mesh's own space
  std::vector<std::vector<Influence>> rows;  // [points] joint of the node's skin, weight
  std::vector<int32_t> corners;              // [triangles x 3] points
  std::vector<double> normals, uvs, colors;  // [corners x 3, 2, 4]; v goes up
  std::vector<int> materials;                // glTF's, -1 none, in the order of their use
  std::vector<int32_t> polygon_materials;    // [triangles] numbers in `materials`
  std::vector<ControlShape> shapes;
};

// The points of a node that has a mesh. Throws Error naming `whose` for accessors that are broken.
ControlPoints control_points(const std::string& whose, const tinygltf::Model& model, size_t node);

// [N] 1: a joint of a skin, or its descendant without a mesh; without any skin a node without a mesh below.
std::vector<char> scene_joints(const tinygltf::Model& model, const GltfNodes& nodes);

// Where a skin's vertices stand: world x inverse bind matrix, which most joints agree on in the pose that the skin was bound in.
Affine skin_frame(const std::string& whose, const tinygltf::Model& model, const GltfNodes& nodes, size_t skin);

}  // namespace sinew
#endif
