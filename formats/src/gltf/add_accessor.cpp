// SPDX-License-Identifier: MIT
#include "gltf/gltf_source.hpp"

namespace sinew {

int add_accessor(GltfSource* source, const void* values, size_t size_bytes, const char* type, int component_type,
                 size_t count, bool vertex_attribute, bool normalized) {
  Json& document = source->document;
  source->bytes.resize((source->bytes.size() + 3) / 4 * 4);
  Json view = {{"buffer", 0}, {"byteOffset", source->bytes.size()}, {"byteLength", size_bytes}};
  if (vertex_attribute) view["target"] = TINYGLTF_TARGET_ARRAY_BUFFER;
  const uint8_t* bytes = static_cast<const uint8_t*>(values);
  source->bytes.insert(source->bytes.end(), bytes, bytes + size_bytes);
  document["bufferViews"].push_back(std::move(view));
  Json accessor = {{"bufferView", document["bufferViews"].size() - 1},
                   {"componentType", component_type},
                   {"count", count},
                   {"type", type}};
  if (normalized) accessor["normalized"] = true;
  document["accessors"].push_back(std::move(accessor));
  if (!document.contains("buffers")) document["buffers"] = Json::array({Json::object()});
  return static_cast<int>(document["accessors"].size()) - 1;
}

}  // namespace sinew
