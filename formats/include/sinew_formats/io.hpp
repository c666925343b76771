// SPDX-License-Identifier: MIT
// Readers and writers of characters. Every reader throws sinew::Error with file, line or element, expected and found.
// Every writer writes to a temporary file beside the target and renames it, so a failure leaves the target unchanged.
#ifndef SINEW_FORMATS_IO_HPP
#define SINEW_FORMATS_IO_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Reads a mesh by extension: .obj, .gltf, .glb, .vrm, .fbx, .dae; "-" reads an OBJ from standard input. An OBJ has no
// joints: only read_character() reads the NAME.rig.txt beside NAME.obj. read_gltf() also takes .fbx and .dae, which
// Assimp reads (Error with the package name if it is not built in).
Character read_mesh(const std::string& path);
Character read_obj(const std::string& path);
Character read_gltf(const std::string& path);
// Like read_gltf(), but accepts a file with a skeleton and no mesh unless need_mesh.
Character read_gltf_character(const std::string& path, bool need_mesh);

// Adds joints (and influences when with_skin) from a skeleton file to a mesh: .rig.txt / .txt, .gltf/.glb/.vrm/.fbx/.dae
// (its skin's joints, world positions) or .bvh (offsets of its rest pose, End Sites as NAME_end).
void read_skeleton(const std::string& path, bool with_skin, Character* character);
// Replaces joints and influences of `character`; with_skin requires the vertices that the skin lines refer to. Throws
// Error with the line before anything is replaced.
void read_rig(const std::string& path, bool with_skin, Character* character);
// Reads a mesh with its own skin (glTF) or NAME.obj + NAME.rig.txt. `path` is the mesh file, or the .rig.txt beside
// an .obj.
Character read_character(const std::string& path);
// Lists all NAME.obj + NAME.rig.txt pairs and whole files (.glb, .gltf, .vrm, .fbx, .dae) of a folder and its
// subfolders, sorted by name. Returns paths of mesh files. Hidden files and folders (.NAME) are left out; links to
// folders are followed, each folder once.
std::vector<std::string> list_characters(const std::string& folder);
// Lists all mesh files, with or without a skeleton, sorted by path.
std::vector<std::string> list_meshes(const std::string& folder);
// Lists all files that may hold a motion, sorted by path.
std::vector<std::string> list_motions(const std::string& folder);
// Lists all files that have these uses (FileUse), sorted by path.
std::vector<std::string> list_files(const std::string& folder, uint32_t uses);
// Returns a unique name for each of the `paths` found below `folder`: NAME, else FOLDERS/NAME, else
// FOLDERS/NAME.EXTENSION.
std::vector<std::string> character_names(const std::string& folder, const std::vector<std::string>& paths);
// Returns FAMILY of FAMILY__NAME (without folders), or "all" without "__".
std::string family_of(const std::string& character_name);

void write_obj(const std::string& path, const Character& character);
// The text form of RigNet's data: joints / root / skin / hier. Weights are printed with 6 digits.
void write_rig(const std::string& path, const Character& character);
// Writes a skinned glTF by extension: .gltf with NAME.bin beside it (picture files in the same folder stay files,
// others go into the .bin), .vrm if the input was one (Error otherwise), else GLB. A glTF input keeps its vertices,
// UVs, normals, materials and nodes, and gets the skin. An OBJ gives its objects, corner UVs and normals (vertices
// split at seams), or smooth normals. Weights are unorm16 with exact sums (unorm8 if `unorm8`), sorted, in as many
// sets JOINTS_0, ... as needed.
struct Motion;   // motion.hpp
struct Springs;  // springs.hpp
struct GlbOptions {
  bool unorm8 = false;
  bool keep_skin = false;          // keeps the skin of the input document byte for byte
  bool drop_animations = false;    // removes those of the input document
  const Motion* motion = nullptr;  // motion of the character's joints, in their order; its clips become animations
  const Springs* springs =
      nullptr;  // springs of the character's joints instead of those of the input document; null: those are kept
  std::string extras{};  // JSON object whose members go into the document's extras; empty: none
};
void write_gltf(const std::string& path, const Character& character, const GlbOptions& options = {});
inline void write_glb(const std::string& path, const Character& character, const GlbOptions& options = {}) {
  write_gltf(path, character, options);
}

// Reads and writes whole files; writing uses a temporary file and rename. "-" is standard input / output.
std::vector<uint8_t> read_file(const std::string& path);
std::string read_text_file(const std::string& path);
void write_file(const std::string& path, const std::vector<uint8_t>& bytes);
void write_text_file(const std::string& path, const std::string& text);
// Writes several files together: all are complete on disk before the targets are replaced, in this order.
struct NamedBytes {
  std::string path;
  std::vector<uint8_t> bytes;
};
void write_files(const std::vector<NamedBytes>& files);

}  // namespace sinew
#endif
