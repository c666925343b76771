// SPDX-License-Identifier: MIT
// Builds small glTF documents for tests: JSON by hand, accessors from vectors, out as GLB or as .gltf with a data URI.
#ifndef SINEW_TESTS_MAKE_GLB_HPP
#define SINEW_TESTS_MAKE_GLB_HPP

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

struct GlbBuilder {
  nlohmann::json document = {
      {"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", nlohmann::json::array()}}}}};
  std::string bytes;

  template <class T>
  int view(const std::vector<T>& values) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    document["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * sizeof(T)}});
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    return static_cast<int>(document["bufferViews"].size()) - 1;
  }
  static int component_type(float) { return 5126; }
  static int component_type(int8_t) { return 5120; }
  static int component_type(uint8_t) { return 5121; }
  static int component_type(int16_t) { return 5122; }
  static int component_type(uint16_t) { return 5123; }
  static int component_type(uint32_t) { return 5125; }
  template <class T>
  int accessor(const std::vector<T>& values, const char* type, bool normalized = false) {
    const std::string name = type;
    const size_t width = name == "SCALAR" ? 1 : name == "VEC2" ? 2 : name == "VEC3" ? 3 : name == "VEC4" ? 4 : 16;
    nlohmann::json made = {{"bufferView", view(values)},
                           {"componentType", component_type(T{})},
                           {"count", values.size() / width},
                           {"type", type}};
    if (normalized) made["normalized"] = true;
    document["accessors"].push_back(made);
    return static_cast<int>(document["accessors"].size()) - 1;
  }
  // With the bounds that the validator demands.
  int positions(const std::vector<float>& values) {
    const int index = accessor(values, "VEC3");
    nlohmann::json low = {values[0], values[1], values[2]}, high = low;
    for (size_t i = 0; i < values.size(); ++i) {
      if (values[i] < low[i % 3].get<float>()) low[i % 3] = values[i];
      if (values[i] > high[i % 3].get<float>()) high[i % 3] = values[i];
    }
    document["accessors"].back()["min"] = low;
    document["accessors"].back()["max"] = high;
    return index;
  }
  int add(const char* list, nlohmann::json element) {
    document[list].push_back(std::move(element));
    return static_cast<int>(document[list].size()) - 1;
  }
  int root(nlohmann::json node) {
    const int index = add("nodes", std::move(node));
    document["scenes"][0]["nodes"].push_back(index);
    return index;
  }

  std::string glb() const {
    nlohmann::json whole = document;
    std::string binary = bytes;
    binary.resize((binary.size() + 3) / 4 * 4);
    // Buffers of the document stand behind the one that is built here.
    if (!binary.empty()) {
      whole["buffers"] = {{{"byteLength", bytes.size()}}};
      for (const nlohmann::json& other : document.value("buffers", nlohmann::json::array()))
        whole["buffers"].push_back(other);
    }
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string out = "glTF";
    const auto put = [&](size_t value) {
      for (size_t i = 0; i < 4; ++i) out += static_cast<char>(value >> (8 * i));
    };
    put(2);
    put(20 + text.size() + (binary.empty() ? 0 : 8 + binary.size()));
    put(text.size());
    out += "JSON" + text;
    if (!binary.empty()) {
      put(binary.size());
      out += std::string("BIN\0", 4) + binary;
    }
    return out;
  }
};

// JSON chunk of a GLB.
inline nlohmann::json json_of_glb(const std::string& glb) {
  uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  return nlohmann::json::parse(glb.substr(20, length));
}

// Bytes of an accessor in a GLB, tightly packed as this repository writes them.
template <class T>
std::vector<T> values_of(const std::string& glb, const nlohmann::json& document, int accessor, size_t width) {
  uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  const nlohmann::json& from = document["accessors"][static_cast<size_t>(accessor)];
  const size_t offset = document["bufferViews"][from["bufferView"].get<size_t>()].value("byteOffset", size_t{0}) +
                        from.value("byteOffset", size_t{0});
  std::vector<T> values(from["count"].get<size_t>() * width);
  std::memcpy(values.data(), glb.data() + 28 + length + offset, values.size() * sizeof(T));
  return values;
}

// A quad strip of `rows` x 2 vertices along +Y, split at a UV seam in the middle row when `seam`; two joints, hip and
// knee, knee above hip; positions stand 10 to the right of where the nodes put them.
inline GlbBuilder two_joint_strip(bool seam = false) {
  GlbBuilder builder;
  std::vector<float> positions, uvs, normals, weights;
  std::vector<uint8_t> joints;
  std::vector<uint16_t> indices;
  const auto vertex = [&](float x, float y, float u) {
    positions.insert(positions.end(), {x, y, 0});
    normals.insert(normals.end(), {0, 0, 1});
    uvs.insert(uvs.end(), {u, y / 4});
    joints.insert(joints.end(), {0, 1, 0, 0});
    weights.insert(weights.end(), {1 - y / 4, y / 4, 0, 0});
  };
  for (int y = 0; y < 5; ++y) vertex(0, static_cast<float>(y), 0), vertex(1, static_cast<float>(y), 1);
  if (seam) vertex(0, 2, 0.5f), vertex(1, 2, 0.75f);
  for (uint16_t y = 0; y < 4; ++y) {
    const uint16_t low = static_cast<uint16_t>(seam && y == 2 ? 10 : 2 * y), high = static_cast<uint16_t>(2 * y + 2);
    for (const uint16_t i : {low, static_cast<uint16_t>(low + 1), static_cast<uint16_t>(high + 1), low,
                             static_cast<uint16_t>(high + 1), high})
      indices.push_back(i);
  }
  const nlohmann::json primitive = {{"attributes",
                                     {{"POSITION", builder.positions(positions)},
                                      {"NORMAL", builder.accessor(normals, "VEC3")},
                                      {"TEXCOORD_0", builder.accessor(uvs, "VEC2")},
                                      {"JOINTS_0", builder.accessor(joints, "VEC4")},
                                      {"WEIGHTS_0", builder.accessor(weights, "VEC4")}}},
                                    {"indices", builder.accessor(indices, "SCALAR")}};
  builder.add("meshes", {{"name", "strip"}, {"primitives", nlohmann::json::array({primitive})}});
  const std::vector<float> binds = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                    1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2, 0, 1};
  builder.root({{"name", "hip"}, {"translation", {10, 0, 0}}, {"children", {1}}});
  builder.add("nodes", {{"name", "knee"}, {"translation", {0, 2, 0}}});
  builder.root({{"name", "body"}, {"mesh", 0}, {"skin", 0}});
  builder.add("skins", {{"joints", {0, 1}}, {"inverseBindMatrices", builder.accessor(binds, "MAT4")}});
  return builder;
}

#endif
