// SPDX-License-Identifier: MIT
// The table, and questions to it.
#include "sinew_formats/file_kinds.hpp"

#include "sinew_formats/file_names.hpp"

namespace sinew {
namespace {

constexpr uint32_t kWhole = kReadsMesh | kReadsSkeleton | kReadsMotion | kReadsWhole;
constexpr uint32_t kMotionAlone = kReadsSkeleton | kReadsMotion | kOffered;
constexpr uint32_t kGltfUses = kWhole | kWritesCharacter | kWritesMotion | kOffered;

}  // namespace

const std::vector<FileKind>& file_kinds() {
  static const std::vector<FileKind> kinds = {
      {".obj", "OBJ", kReadsMesh | kWritesCharacter | kWritesMesh | kOffered, FileReader::kObj},
      {".rig.txt", "rig.txt", kReadsSkeleton | kWritesCharacter | kOffered, FileReader::kRig},
      {".txt", "rig.txt", kReadsSkeleton, FileReader::kRig},
      {".gltf", "glTF", kGltfUses, FileReader::kGltf},
      {".glb", "GLB", kGltfUses, FileReader::kGltf},
      {".vrm", "VRM", kGltfUses, FileReader::kGltf},
      {".fbx", "FBX", kWhole | kWritesCharacter | kWritesMotion | kOffered, FileReader::kScene},
      {".usda", "USD", kGltfUses, FileReader::kUsd},
      {".usdz", "USD", kGltfUses, FileReader::kUsd},
      {".dae", "COLLADA", kWhole | kOffered, FileReader::kScene},
      {".b3d", "Blitz3D", kWhole, FileReader::kScene},
      {".x", "DirectX", kWhole, FileReader::kScene},
      {".mesh.xml", "OGRE", kWhole, FileReader::kScene},
      {".mesh", "OGRE", kWhole, FileReader::kScene},
      {".md5mesh", "MD5", kWhole, FileReader::kScene},
      {".ms3d", "MilkShape", kWhole, FileReader::kScene},
      {".smd", "Valve SMD", kWhole, FileReader::kScene},
      {".bvh", "BVH", kMotionAlone | kWritesMotion, FileReader::kBvh},
      {".vrma", "VRM animation", kMotionAlone, FileReader::kGltf},
      {".npz", "NumPy", kMotionAlone, FileReader::kNumpy},
      {".npy", "NumPy", kMotionAlone, FileReader::kNumpy},
      {".vmd", "VMD", kMotionAlone, FileReader::kVmd},
      {".png", "PNG", kReadsPicture | kOffered, FileReader::kPicture},
      {".jpg", "JPEG", kReadsPicture | kOffered, FileReader::kPicture},
      {".jpeg", "JPEG", kReadsPicture | kOffered, FileReader::kPicture},
  };
  return kinds;
}

const FileKind* file_kind(const std::string& path) {
  for (const FileKind& kind : file_kinds())
    if (has_extension(path, kind.extension)) return &kind;
  return nullptr;
}

bool has_use(const std::string& path, uint32_t uses) {
  const FileKind* kind = file_kind(path);
  return kind != nullptr && (kind->uses & uses) == uses;
}

bool is_motion_alone(const std::string& path) { return has_use(path, kMotionAlone) && !has_use(path, kReadsWhole); }

std::vector<std::string> extensions_of(uint32_t uses) {
  std::vector<std::string> extensions;
  for (const FileKind& kind : file_kinds())
    if ((kind.uses & uses) == uses) extensions.emplace_back(kind.extension);
  return extensions;
}

std::string extensions_text(uint32_t uses, const char* between) {
  std::string text;
  for (const std::string& extension : extensions_of(uses)) text += (text.empty() ? "" : between) + extension;
  return text;
}

}  // namespace sinew
