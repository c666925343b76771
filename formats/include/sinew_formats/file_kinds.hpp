// SPDX-License-Identifier: MIT
// Table of file formats, one row per extension. Readers, folder lists, error messages, help texts and file dialogs
// use it; scripts/file_kinds.py generates the tables of front-ends without C++. formats/README.md explains how to add
// a format.
#ifndef SINEW_FORMATS_FILE_KINDS_HPP
#define SINEW_FORMATS_FILE_KINDS_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sinew {

// Uses of a file format; bits.
enum FileUse : uint32_t {
  kReadsMesh = 1,
  kReadsSkeleton = 2,
  kReadsMotion = 4,
  kReadsWhole = 8,        // mesh, skeleton and weights in one file
  kWritesCharacter = 16,  // mesh, skeleton and weights
  kWritesMotion = 32,
  kWritesMesh = 64,        // only a mesh: poses
  kOffered = 128,          // dialogs of the page and of editors offer to open it, and the WebAssembly modules read it
  kReadsPicture = 256,     // a drawing or a photograph of a character
  kWritesSkin = 512,       // skeleton and weights in one file, with or without a mesh
  kWritesWithMesh = 1024,  // a character with its mesh; skeleton and weights may lie beside it
  kWritesSprings = 2048    // springs, with the character
};

// Reader of a format.
enum class FileReader : uint8_t {
  kObj,
  kRig,
  kGltf,
  kScene,  // through Assimp as a glTF document
  kIqm,    // as a glTF document
  kBvh,
  kVmd,
  kAmc,
  kNumpy,
  kPicture,
  kNone  // only written, not read
};

struct FileKind {
  const char* extension;  // ".glb", in small letters
  const char* name;       // "FBX", for error lines
  uint32_t uses;          // FileUse
  FileReader reader;
};

// In the order of error messages; an extension comes before those that are its endings.
const std::vector<FileKind>& file_kinds();
// Finds a format by the extension, ignoring case; null for an unknown one.
const FileKind* file_kind(const std::string& path);
bool has_use(const std::string& path, uint32_t uses);  // all of them
bool is_motion_alone(const std::string& path);         // clips and their skeleton, no mesh

// Remedy for a file that cannot be read: "; import it in Blender ...", appended to "found another extension". "" if
// none is known.
std::string remedy(const std::string& path);

// ".obj, .gltf, .glb" of the files of a use.
std::string extensions_text(uint32_t uses, const char* between = ", ");
std::vector<std::string> extensions_of(uint32_t uses);

// Parts of file names: extensions (ignoring case), the stem that names a character, the rig beside a mesh.
bool has_extension(const std::string& path, const char* extension);  // ".glb"; the name must be longer than that
std::string stem_of(const std::string& path);                        // folder/NAME.rig.txt -> NAME, "-" -> stdin
std::string rig_path_beside(const std::string& mesh_path);           // folder/NAME.obj -> folder/NAME.rig.txt

}  // namespace sinew
#endif
