// SPDX-License-Identifier: MIT
// A rigged character in memory: output of every reader and input of every writer.
#ifndef SINEW_FORMATS_CHARACTER_HPP
#define SINEW_FORMATS_CHARACTER_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sinew {

// An axis of the world. A mesh has y or z up; the C API, the command and the page convert their own codes.
enum class Axis : uint8_t { kX, kY, kZ };

struct Vec3 {
  float x = 0, y = 0, z = 0;
};

struct Joint {
  std::string name;
  Vec3 position;                     // rest pose, world space, the mesh's units
  int parent = -1;                   // index into Character::joints, -1 = root
  std::optional<bool> deforms = {};  // from the file (Blender's deform flag as a custom property), if present
};

struct Influence {
  uint32_t joint = 0;  // index into Character::joints
  float weight = 0;
};

// A mesh node of a glTF file.
struct CharacterMesh {
  std::string name;
  bool skinned = false;
  int carrier = -1;  // for a mesh without a skin: the joint that carries it (its node or the nearest ancestor), or -1
};

// Bytes of a PNG or JPEG file, shared by the materials that use it.
using Picture = std::shared_ptr<const std::vector<uint8_t>>;

// A material of an OBJ's .mtl; a glTF document keeps its own.
struct Material {
  std::array<float, 4> base_color = {1, 1, 1, 1};  // linear RGB 0..1, opacity
  std::array<float, 3> emissive = {0, 0, 0};       // linear RGB 0..1
  bool unlit = false;                              // KHR_materials_unlit
  bool cut_out = false;                            // alpha test: texels with alpha below 0.5 are cut out
  Picture base_color_texture, normal_texture;      // null = none
};

struct GltfSource;  // the parsed input document and the map back to its vertices (formats/src/gltf/gltf_source.hpp)

// For OBJ the vertices are those of the file; for glTF they are welded across seams (same position and same weights),
// and `gltf` keeps the map to the file's vertices.
struct Character {
  std::string name;            // file stem
  Axis up = Axis::kY;          // kZ: a format with y up is written with a root node that rotates the character
  std::vector<Vec3> vertices;  // [V]
  std::vector<uint32_t> face_offsets = {0};  // [F + 1] CSR into face_vertices; polygons are kept
  std::vector<uint32_t> face_vertices;       // [corners]
  std::vector<Joint> joints;                 // [J] any order; parents may come later

  // [V] or empty: reference or predicted weights; a row may be empty (unbound).
  std::vector<std::vector<Influence>> influences;
  std::vector<uint8_t> confidence;  // [V] 0..255 or empty: confidence of the prediction; written to glTF as _CONFIDENCE

  std::vector<CharacterMesh> meshes;    // glTF only
  std::vector<uint32_t> vertex_meshes;  // [V] index into meshes, or empty

  std::vector<std::string> notes;  // notes of the reader for the user, one line each

  // For writing, all optional. Per corner, parallel to face_vertices (empty if the file has none).
  std::vector<std::array<float, 2>> corner_uvs;
  std::vector<Vec3> corner_normals;
  std::vector<std::string> material_names;  // OBJ usemtl names
  std::vector<int> face_materials;          // [F] index into material_names or -1
  std::vector<std::string> group_names;     // OBJ o/g names
  std::vector<int> face_groups;             // [F] index into group_names or -1
  std::vector<Material> materials;          // [material_names] or empty
  std::vector<std::string> object_names;    // OBJ: the artist's objects (o, else g), each a node of a written glTF
  std::vector<int> face_objects;            // [F] index into object_names or -1
  std::vector<std::array<float, 3>> vertex_colors;  // [V] linear RGB 0..1 or empty
  std::shared_ptr<const GltfSource> gltf;           // set by the glTF reader only

  size_t face_count() const { return face_offsets.size() - 1; }
};

}  // namespace sinew
#endif
