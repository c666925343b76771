// SPDX-License-Identifier: MIT
// A document's primitives packed by Draco's encoder, as KHR_draco_mesh_compression wants them.
#ifndef SINEW_TESTS_DRACO_GLB_HPP
#define SINEW_TESTS_DRACO_GLB_HPP

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
#include <draco/compression/encode.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <string>
#include <vector>

#include "make_glb.hpp"

// Primitives of float and byte attributes with 16-bit indices. Draco's sequential coding keeps the order of the
// vertices and, without quantization, their bits.
inline GlbBuilder draco_packed(const GlbBuilder& plain, bool sequential = true) {
  GlbBuilder packed;
  packed.document = plain.document;
  nlohmann::json& document = packed.document;
  const auto bytes_of = [&](const nlohmann::json& accessor) {
    return plain.bytes.data() +
           plain.document["bufferViews"][accessor["bufferView"].get<size_t>()]["byteOffset"].get<size_t>();
  };
  for (auto& mesh : document["meshes"])
    for (auto& primitive : mesh["primitives"]) {
      draco::Mesh geometry;
      nlohmann::json ids;
      for (const auto& [name, number] : primitive["attributes"].items()) {
        nlohmann::json& accessor = document["accessors"][number.get<size_t>()];
        const uint32_t count = accessor["count"].get<uint32_t>();
        const std::string type = accessor["type"];
        const int width = type == "VEC2" ? 2 : type == "VEC3" ? 3 : 4;
        const bool floats = accessor["componentType"] == 5126;
        const size_t stride = static_cast<size_t>(width) * (floats ? 4 : 1);
        geometry.set_num_points(count);
        draco::GeometryAttribute made;
        const auto kind = name == "POSITION"     ? draco::GeometryAttribute::POSITION
                          : name == "NORMAL"     ? draco::GeometryAttribute::NORMAL
                          : name == "TEXCOORD_0" ? draco::GeometryAttribute::TEX_COORD
                                                 : draco::GeometryAttribute::GENERIC;
        made.Init(kind, nullptr, static_cast<int8_t>(width), floats ? draco::DT_FLOAT32 : draco::DT_UINT8, false,
                  static_cast<int64_t>(stride), 0);
        const int id = geometry.AddAttribute(made, true, count);
        for (uint32_t i = 0; i < count; ++i)
          geometry.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), bytes_of(accessor) + i * stride);
        ids[name] = geometry.attribute(id)->unique_id();
        accessor.erase("bufferView");
      }
      nlohmann::json& indices = document["accessors"][primitive["indices"].get<size_t>()];
      const size_t count = indices["count"].get<size_t>();
      std::vector<uint16_t> corners(count);
      std::memcpy(corners.data(), bytes_of(indices), count * 2);
      indices.erase("bufferView");
      geometry.SetNumFaces(count / 3);
      for (uint32_t f = 0; f < count / 3; ++f)
        geometry.SetFace(draco::FaceIndex(f), {draco::PointIndex(corners[f * 3]), draco::PointIndex(corners[f * 3 + 1]),
                                               draco::PointIndex(corners[f * 3 + 2])});
      draco::Encoder encoder;
      encoder.SetEncodingMethod(sequential ? draco::MESH_SEQUENTIAL_ENCODING : draco::MESH_EDGEBREAKER_ENCODING);
      if (!sequential) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
      draco::EncoderBuffer out;
      if (!encoder.EncodeMeshToBuffer(geometry, &out).ok()) continue;
      packed.bytes.resize((packed.bytes.size() + 3) / 4 * 4);
      document["bufferViews"].push_back(
          {{"buffer", 0}, {"byteOffset", packed.bytes.size()}, {"byteLength", out.size()}});
      packed.bytes.append(out.data(), out.size());
      primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", document["bufferViews"].size() - 1},
                                                               {"attributes", ids}};
    }
  // Views of what is in Draco's bytes are gone; the others move behind these.
  nlohmann::json views = nlohmann::json::array();
  std::vector<size_t> number(document["bufferViews"].size());
  std::vector<char> used(number.size(), 0);
  for (const auto& accessor : document["accessors"])
    if (accessor.contains("bufferView")) used[accessor["bufferView"].get<size_t>()] = 1;
  for (size_t i = 0; i < number.size(); ++i) {
    nlohmann::json view = document["bufferViews"][i];
    number[i] = views.size();
    if (i < plain.document["bufferViews"].size()) {
      if (used[i] == 0) continue;
      packed.bytes.resize((packed.bytes.size() + 3) / 4 * 4);
      const size_t offset = view["byteOffset"].get<size_t>();
      view["byteOffset"] = packed.bytes.size();
      packed.bytes.append(plain.bytes, offset, view["byteLength"].get<size_t>());
    }
    views.push_back(view);
  }
  for (auto& accessor : document["accessors"])
    if (accessor.contains("bufferView")) accessor["bufferView"] = number[accessor["bufferView"].get<size_t>()];
  for (auto& mesh : document["meshes"])
    for (auto& primitive : mesh["primitives"]) {
      nlohmann::json& view = primitive["extensions"]["KHR_draco_mesh_compression"]["bufferView"];
      view = number[view.get<size_t>()];
    }
  document["bufferViews"] = views;
  document["extensionsUsed"] = document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return packed;
}

#endif
