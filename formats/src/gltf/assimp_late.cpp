// SPDX-License-Identifier: MIT
// Assimp's functions that scene_to_glb.cpp, scene_input.hpp and scene_nodes.cpp call, from its shared library (late_library.hpp). Only where
// SINEW_LATE_ASSIMP is that library's name (formats/CMakeLists.txt).
#include <assimp/material.h>

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <new>
#include <string>

#include "gltf/late_library.hpp"

namespace {

template <class Result, class... Arguments>
Result assimp_call(const char* name, Arguments... arguments) {
  static const sinew::LateLibrary assimp(SINEW_LATE_ASSIMP, "Assimp", "libassimp-dev");
  return assimp.call<Result>(name, arguments...);
}

}  // namespace

namespace Assimp {

Importer::Importer() : pimpl(nullptr) { assimp_call<void>("_ZN6Assimp8ImporterC1Ev", this); }
Importer::~Importer() { assimp_call<void>("_ZN6Assimp8ImporterD1Ev", this); }
void Importer::SetIOHandler(IOSystem* files) {
  assimp_call<void>("_ZN6Assimp8Importer12SetIOHandlerEPNS_8IOSystemE", this, files);
}
bool Importer::SetPropertyInteger(const char* name, int value) {
  return assimp_call<bool>("_ZN6Assimp8Importer18SetPropertyIntegerEPKci", this, name, value);
}
const aiScene* Importer::ReadFile(const char* path, unsigned int flags) {
  return assimp_call<const aiScene*>("_ZN6Assimp8Importer8ReadFileEPKcj", this, path, flags);
}
const char* Importer::GetErrorString() const {
  return assimp_call<const char*>("_ZNK6Assimp8Importer14GetErrorStringEv", this);
}

bool IOSystem::ComparePaths(const char* one, const char* second) const {
  return assimp_call<bool>("_ZNK6Assimp8IOSystem12ComparePathsEPKcS2_", this, one, second);
}
const std::string& IOSystem::CurrentDirectory() const {
  return *assimp_call<const std::string*>("_ZNK6Assimp8IOSystem16CurrentDirectoryB5cxx11Ev", this);
}

// What Assimp makes and frees comes from the same heap as everything.
void* Intern::AllocateFromAssimpHeap::operator new(size_t bytes) { return ::operator new(bytes); }
void Intern::AllocateFromAssimpHeap::operator delete(void* data) { ::operator delete(data); }

}  // namespace Assimp

aiReturn aiGetMaterialString(const aiMaterial* material, const char* key, unsigned int type, unsigned int index,
                             aiString* out) {
  return assimp_call<aiReturn>("aiGetMaterialString", material, key, type, index, out);
}
aiReturn aiGetMaterialColor(const aiMaterial* material, const char* key, unsigned int type, unsigned int index,
                            aiColor4D* out) {
  return assimp_call<aiReturn>("aiGetMaterialColor", material, key, type, index, out);
}
aiReturn aiGetMaterialFloatArray(const aiMaterial* material, const char* key, unsigned int type, unsigned int index,
                                 ai_real* out, unsigned int* count) {
  return assimp_call<aiReturn>("aiGetMaterialFloatArray", material, key, type, index, out, count);
}
aiReturn aiGetMaterialTexture(const aiMaterial* material, aiTextureType type, unsigned int index, aiString* path,
                              aiTextureMapping* mapping, unsigned int* uv_index, ai_real* blend, aiTextureOp* operation,
                              aiTextureMapMode* map_mode, unsigned int* flags) {
  return assimp_call<aiReturn>("aiGetMaterialTexture", material, type, index, path, mapping, uv_index, blend, operation,
                               map_mode, flags);
}
