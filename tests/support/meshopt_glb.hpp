// SPDX-License-Identifier: MIT
// A document's buffer views packed by meshoptimizer's encoders, as EXT_meshopt_compression wants them.
#ifndef SINEW_TESTS_MESHOPT_GLB_HPP
#define SINEW_TESTS_MESHOPT_GLB_HPP

#include <meshoptimizer.h>

#include <string>
#include <vector>

#include "make_glb.hpp"

// Every accessor must have a view of its own. Buffer 1 is the fallback, which has no bytes.
inline GlbBuilder meshopt_packed(const GlbBuilder& plain, const std::string& name = "EXT_meshopt_compression") {
  GlbBuilder packed;
  packed.document = plain.document;
  nlohmann::json& document = packed.document;
  std::vector<char> is_index(document["accessors"].size(), 0);
  for (const auto& mesh : document["meshes"])
    for (const auto& primitive : mesh["primitives"])
      if (primitive.contains("indices")) is_index[primitive["indices"].get<size_t>()] = 1;
  for (size_t a = 0; a < document["accessors"].size(); ++a) {
    const nlohmann::json accessor = document["accessors"][a];
    nlohmann::json& view = document["bufferViews"][accessor["bufferView"].get<size_t>()];
    const size_t count = accessor["count"].get<size_t>(), length = view["byteLength"].get<size_t>();
    const size_t offset = view["byteOffset"].get<size_t>(), stride = length / count;
    const unsigned char* bytes = reinterpret_cast<const unsigned char*>(plain.bytes.data()) + offset;
    std::vector<unsigned char> out;
    if (is_index[a] != 0) {
      std::vector<unsigned int> indices(count, 0);
      for (size_t i = 0; i < count; ++i) std::memcpy(&indices[i], bytes + i * stride, stride);
      out.resize(meshopt_encodeIndexBufferBound(count, 65536));
      out.resize(meshopt_encodeIndexBuffer(out.data(), out.size(), indices.data(), count));
    } else {
      out.resize(meshopt_encodeVertexBufferBound(count, stride));
      out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), bytes, count, stride));
    }
    packed.bytes.resize((packed.bytes.size() + 3) / 4 * 4);
    view["extensions"][name] = {{"buffer", 0},
                                {"byteOffset", packed.bytes.size()},
                                {"byteLength", out.size()},
                                {"byteStride", stride},
                                {"count", count},
                                {"mode", is_index[a] != 0 ? "TRIANGLES" : "ATTRIBUTES"}};
    view["buffer"] = 1;
    packed.bytes.append(out.begin(), out.end());
  }
  document["buffers"] = {{{"byteLength", plain.bytes.size()}, {"extensions", {{name, {{"fallback", true}}}}}}};
  document["extensionsUsed"] = document["extensionsRequired"] = {name};
  return packed;
}

#endif
