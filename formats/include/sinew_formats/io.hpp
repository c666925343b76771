// SPDX-License-Identifier: MIT
// Readers and writers of characters. Every reader throws sinew::Error with file, line or element, expected and found.
// Every writer writes to a temporary file beside the target and renames it, so a failure leaves the target as it was.
#ifndef SINEW_FORMATS_IO_HPP
#define SINEW_FORMATS_IO_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// By extension: .obj, .gltf, .glb, .vrm, .fbx, .dae. An OBJ has no joints; "-" reads OBJ from standard input. Reads
// NAME.rig.txt beside NAME.obj only when asked (read_character). read_gltf() takes .fbx and .dae too, which Assimp reads
// (Error naming the package where it is not built in).
Character read_mesh(const std::string& path);
Character read_obj(const std::string& path);
Character read_gltf(const std::string& path);
// As read_gltf; a file with a skeleton but no mesh is fine unless need_mesh.
Character read_gltf_character(const std::string& path, bool need_mesh);

// Adds joints (and influences when with_skin) from a skeleton file to a mesh: .rig.txt / .txt, .gltf/.glb/.vrm/.fbx/.dae
// (its skin's joints, world positions) or .bvh (offsets of its rest pose, End Sites as NAME_end).
void read_skeleton(const std::string& path, bool with_skin, Character* character);
// Replaces joints and influences of `character`; with_skin needs its vertices to be those the skin lines number. Throws
// Error with the line before anything is replaced.
void read_rig(const std::string& path, bool with_skin, Character* character);
// Mesh with its own skin (glTF) or NAME.obj + NAME.rig.txt. `path` is the mesh file, or the .rig.txt beside an .obj.
Character read_character(const std::string& path);
// All NAME.obj + NAME.rig.txt pairs and whole files (.glb, .gltf, .vrm, .fbx, .dae) of a folder and of the folders below it,
// sorted by name. Paths of mesh files. Hidden files and folders (.NAME) are left out; links to folders are followed, each folder once.
std::vector<std::string> list_characters(const std::string& folder);
// All mesh files, with or without a skeleton, sorted by path; otherwise the same.
std::vector<std::string> list_meshes(const std::string& folder);
// All files that may hold a motion, sorted by path; otherwise the same.
std::vector<std::string> list_motions(const std::string& folder);
// All files that have these uses (FileUse), sorted by path; otherwise the same.
std::vector<std::string> list_files(const std::string& folder, uint32_t uses);
// A name for each of the `paths` that were found below `folder`: NAME, or FOLDERS/NAME where several have that name, or
// FOLDERS/NAME.EXTENSION where that is not enough.
std::vector<std::string> character_names(const std::string& folder, const std::vector<std::string>& paths);
// FAMILY of FAMILY__NAME (folders before it do not count), "all" without "__".
std::string family_of(const std::string& character_name);

void write_obj(const std::string& path, const Character& character);
// The text form of RigNet's data: joints / root / skin / hier. Weights are printed with 6 digits.
void write_rig(const std::string& path, const Character& character);
// Skinned glTF by extension: .gltf with NAME.bin beside it (pictures that are files of this very folder stay files, all
// others lie in the .bin), .vrm where the input was one (Error otherwise), else GLB. From a glTF input: the input's own
// vertices, UVs, normals, materials and nodes back, with skin. From OBJ: its objects, corner UVs and normals (vertices
// split at seams), or smooth normals. Weights unorm16 with exact sums (unorm8 when `unorm8`), sorted, JOINTS_0.. as many
// sets as needed.
struct Motion;   // motion.hpp
struct Springs;  // springs.hpp
struct GlbOptions {
  bool unorm8 = false;
  bool keep_skin = false;          // the skin of the input's own document stays as it is, to the byte
  bool drop_animations = false;    // those of the input's own document go
  const Motion* motion = nullptr;  // of the character's joints, in their order: its clips become animations
  const Springs* springs =
      nullptr;           // of the character's joints, in place of those of the input's own document; null: those stay
  std::string extras{};  // JSON object whose members go into the document's extras; empty: none
};
void write_gltf(const std::string& path, const Character& character, const GlbOptions& options = {});
inline void write_glb(const std::string& path, const Character& character, const GlbOptions& options = {}) {
  write_gltf(path, character, options);
}

// Whole files; write goes through a temporary file and rename. "-" is standard input / output.
std::vector<uint8_t> read_file(const std::string& path);
std::string read_text_file(const std::string& path);
void write_file(const std::string& path, const std::vector<uint8_t>& bytes);
void write_text_file(const std::string& path, const std::string& text);
// Several files of one thing: all are whole on disk before the first target is replaced, in this order.
struct NamedBytes {
  std::string path;
  std::vector<uint8_t> bytes;
};
void write_files(const std::vector<NamedBytes>& files);

}  // namespace sinew
#endif
