// SPDX-License-Identifier: MIT
// The table, and questions to it.
#include "sinew_formats/file_kinds.hpp"

namespace sinew {
namespace {

constexpr uint32_t kWhole = kReadsMesh | kReadsSkeleton | kReadsMotion | kReadsWhole;
constexpr uint32_t kMotionAlone = kReadsSkeleton | kReadsMotion | kOffered;
constexpr uint32_t kWritesAll = kWritesCharacter | kWritesSkin | kWritesWithMesh | kWritesMotion;
constexpr uint32_t kGltfUses = kWhole | kWritesAll | kOffered | kWritesSprings;

}  // namespace

const std::vector<FileKind>& file_kinds() {
  static const std::vector<FileKind> kinds = {
      {".obj", "OBJ", kReadsMesh | kWritesCharacter | kWritesWithMesh | kWritesMesh | kOffered, FileReader::kObj},
      {".rig.txt", "rig.txt", kReadsSkeleton | kWritesCharacter | kWritesSkin | kOffered, FileReader::kRig},
      {".txt", "rig.txt", kReadsSkeleton, FileReader::kRig},
      {".gltf", "glTF", kGltfUses, FileReader::kGltf},
      {".glb", "GLB", kGltfUses, FileReader::kGltf},
      {".vrm", "VRM", kGltfUses, FileReader::kGltf},
      {".fbx", "FBX", kWhole | kWritesAll | kOffered, FileReader::kScene},
      {".usda", "USD", kWritesAll, FileReader::kNone},
      {".usdz", "USD", kWritesAll, FileReader::kNone},
      {".dae", "COLLADA", kWhole | kOffered, FileReader::kScene},
      {".b3d", "Blitz3D", kWhole, FileReader::kScene},
      {".x", "DirectX", kWhole, FileReader::kScene},
      {".mesh.xml", "OGRE", kWhole, FileReader::kScene},
      {".mesh", "OGRE", kWhole, FileReader::kScene},
      {".md5mesh", "MD5", kWhole, FileReader::kScene},
      {".ms3d", "MilkShape", kWhole, FileReader::kScene},
      {".smd", "Valve SMD", kWhole, FileReader::kScene},
      {".iqm", "IQM", kWhole | kOffered, FileReader::kIqm},
      {".bvh", "BVH", kMotionAlone | kWritesMotion, FileReader::kBvh},
      {".vrma", "VRM animation", kMotionAlone | kWritesMotion, FileReader::kGltf},
      {".npz", "NumPy", kMotionAlone, FileReader::kNumpy},
      {".npy", "NumPy", kMotionAlone, FileReader::kNumpy},
      {".vmd", "VMD", kMotionAlone, FileReader::kVmd},
      {".amc", "Acclaim", kMotionAlone, FileReader::kAmc},
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

std::string remedy(const std::string& path) {
  const std::string glb = stem_of(path) + ".glb";
  const std::string export_glb = "bpy.ops.export_scene.gltf(filepath='" + glb + "')\"";
  if (has_extension(path, ".blend"))
    return "; in Blender: File > Export > glTF 2.0, or: blender --background " + path +
           " --python-expr \"import bpy; " + export_glb;
  for (const char* extension : {".usda", ".usdz", ".usdc", ".usd"})
    if (has_extension(path, extension))
      return "; sinew writes USD but does not read it: export glTF or FBX, or with Blender: blender --background "
             "--python-expr \"import bpy; bpy.ops.wm.usd_import(filepath='" +
             path + "'); " + export_glb;
  if (is_motion_alone(path))
    return "; a " + std::string(file_kind(path)->name) +
           " has a skeleton and motion: pass it to --skeleton, or to sinew animate --motion";
  if (has_extension(path, ".asf")) return "; an Acclaim skeleton is read with its motion: give the .amc beside it";
  if (has_extension(path, ".pkl"))
    return "; a pickle may run code when opened, so sinew does not read it. Save its arrays: python3 -c \"import "
           "numpy; numpy.savez('" +
           stem_of(path) + ".npz', **numpy.load('" + path + "', allow_pickle=True))\"";
  if (has_use(path, kReadsPicture)) return "; sinew rig and sinew animate make a character from a picture";
  for (const char* extension : {".gif", ".svg", ".webp", ".bmp", ".tga", ".tif", ".tiff", ".avif", ".psd"})
    if (has_extension(path, extension))
      return "; pictures are read as " + extensions_text(kReadsPicture) + ": save it as one of those";
  if (has_extension(path, ".max")) return "; in 3ds Max: File > Export > FBX or glTF";
  if (has_extension(path, ".ma") || has_extension(path, ".mb"))
    return "; in Maya: File > Export All > FBX export (load the plug-in fbxmaya)";
  if (has_extension(path, ".c4d")) return "; in Cinema 4D: File > Export > glTF or FBX";
  for (const char* extension : {".3ds", ".stl", ".ply", ".lwo", ".abc", ".x3d", ".pmx"})
    if (has_extension(path, extension)) return "; import it in Blender and export it: File > Export > glTF 2.0 or OBJ";
  return "";
}

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
