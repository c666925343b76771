// SPDX-License-Identifier: MIT
// Queries of readers and writers on a parsed glTF document: node tree, accessor values, bind matrices.
#include "gltf/gltf_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {

const char* image_type(const std::vector<unsigned char>& bytes) {
  const auto begins = [&](const char* magic, size_t size, size_t at) {
    return bytes.size() >= at + size && std::memcmp(bytes.data() + at, magic, size) == 0;
  };
  if (begins("\x89PNG", 4, 0)) return "image/png";
  if (begins("\xff\xd8\xff", 3, 0)) return "image/jpeg";
  if (begins("WEBP", 4, 8)) return "image/webp";
  if (begins("\xabKTX 20", 7, 0)) return "image/ktx2";
  return nullptr;
}

GltfNodes gltf_nodes(const std::string& path, const tinygltf::Model& model) {
  const size_t count = model.nodes.size();
  GltfNodes nodes{std::vector<int>(count, -1), std::vector<Affine>(count, kIdentity), std::vector<char>(count, 0)};
  const auto name = [&](size_t i) { return "node " + std::to_string(i) + " " + in_quotes(model.nodes[i].name); };
  for (size_t i = 0; i < count; ++i)
    for (const int child : model.nodes[i].children) {
      if (child < 0 || static_cast<size_t>(child) >= count)
        throw Error(path + ": " + name(i) + ": expected children below " + std::to_string(count) + ", found " +
                    std::to_string(child));
      if (nodes.parents[static_cast<size_t>(child)] >= 0)
        throw Error(path + ": " + name(static_cast<size_t>(child)) + ": expected one parent, found two");
      nodes.parents[static_cast<size_t>(child)] = static_cast<int>(i);
    }
  // Roots first, then level by level; what is not reached has a cycle above it.
  std::vector<size_t> order;
  for (size_t i = 0; i < count; ++i)
    if (nodes.parents[i] < 0) order.push_back(i);
  for (size_t next = 0; next < order.size(); ++next)
    for (const int child : model.nodes[order[next]].children) order.push_back(static_cast<size_t>(child));
  if (order.size() != count) throw Error(path + ": expected a tree of nodes, found a cycle");

  for (const size_t i : order) {
    const tinygltf::Node& node = model.nodes[i];
    Affine local = kIdentity;
    if (node.matrix.size() == 16) {
      for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 4; ++c) local[r * 4 + c] = node.matrix[c * 4 + r];
    } else {
      if (node.rotation.size() == 4) {
        double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
        const double length = std::sqrt(x * x + y * y + z * z + w * w);
        if (length > 0) x /= length, y /= length, z /= length, w /= length;
        local = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),     0,
                 2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),     0,
                 2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y), 0};
      }
      if (node.scale.size() == 3)
        for (size_t r = 0; r < 3; ++r)
          for (size_t c = 0; c < 3; ++c) local[r * 4 + c] *= node.scale[c];
      if (node.translation.size() == 3)
        for (size_t r = 0; r < 3; ++r) local[r * 4 + 3] = node.translation[r];
    }
    const int parent = nodes.parents[i];
    nodes.worlds[i] = parent < 0 ? local : multiply(nodes.worlds[static_cast<size_t>(parent)], local);
    for (const double value : nodes.worlds[i])
      if (!(std::abs(value) <= double{std::numeric_limits<float>::max()}))
        throw Error(path + ": " + name(i) + ": expected a transform in the range of floats, found one beyond it");
  }

  if (model.scenes.empty()) {
    std::fill(nodes.in_scene.begin(), nodes.in_scene.end(), char{1});
    return nodes;
  }
  const int scene =
      model.defaultScene >= 0 && static_cast<size_t>(model.defaultScene) < model.scenes.size() ? model.defaultScene : 0;
  for (const int root : model.scenes[static_cast<size_t>(scene)].nodes) {
    if (root < 0 || static_cast<size_t>(root) >= count)
      throw Error(path + ": scene " + std::to_string(scene) + ": expected nodes below " + std::to_string(count) +
                  ", found " + std::to_string(root));
    nodes.in_scene[static_cast<size_t>(root)] = 1;
  }
  for (const size_t i : order)
    if (nodes.parents[i] >= 0 && nodes.in_scene[static_cast<size_t>(nodes.parents[i])] != 0) nodes.in_scene[i] = 1;
  return nodes;
}

namespace {

// Where the elements of an accessor or of its sparse part lie; checked.
struct Elements {
  const uint8_t* first = nullptr;
  size_t stride = 0;
};

Elements elements_at(const std::string& where, const tinygltf::Model& model, int view_index, int64_t offset,
                     size_t element_bytes, size_t count, bool strided) {
  const auto fail = [&](const std::string& expected, const std::string& found) {
    throw Error(where + ": expected " + expected + ", found " + found);
  };
  if (view_index < 0 || static_cast<size_t>(view_index) >= model.bufferViews.size())
    fail("a buffer view below " + std::to_string(model.bufferViews.size()), std::to_string(view_index));
  const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(view_index)];
  if (view.buffer < 0 || static_cast<size_t>(view.buffer) >= model.buffers.size())
    fail("a buffer below " + std::to_string(model.buffers.size()), std::to_string(view.buffer));
  const std::vector<unsigned char>& data = model.buffers[static_cast<size_t>(view.buffer)].data;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
    fail("buffer view " + std::to_string(view_index) + " inside of its buffer of " + std::to_string(data.size()) +
             " bytes",
         std::to_string(view.byteOffset) + " + " + std::to_string(view.byteLength));
  const size_t stride = strided && view.byteStride != 0 ? view.byteStride : element_bytes;
  const size_t room =
      offset < 0 || static_cast<size_t>(offset) > view.byteLength ? 0 : view.byteLength - static_cast<size_t>(offset);
  if (stride > data.size() || (count != 0 && (room < element_bytes || (room - element_bytes) / stride < count - 1)))
    fail(std::to_string(count) + " elements inside of buffer view " + std::to_string(view_index),
         std::to_string(view.byteLength) + " bytes");
  return {data.data() + view.byteOffset + static_cast<size_t>(offset), stride};
}

// One component as double; `normalized` maps integers to 0..1 or -1..1.
double component(const uint8_t* at, int type, bool normalized) {
  const auto load = [&](auto value) {
    std::memcpy(&value, at,
                sizeof value);  // host is little-endian, as the file; accessors may be unaligned in bad files
    return value;
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return normalized ? std::max(load(int8_t{}) / 127.0, -1.0) : load(int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load(uint8_t{}) / (normalized ? 255.0 : 1.0);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return normalized ? std::max(load(int16_t{}) / 32767.0, -1.0) : load(int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load(uint16_t{}) / (normalized ? 65535.0 : 1.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load(uint32_t{});
    default:
      return static_cast<double>(load(float{}));
  }
}

std::vector<double> accessor_values(const std::string& where, const tinygltf::Model& model, int index, int components) {
  if (index < 0 || static_cast<size_t>(index) >= model.accessors.size())
    throw Error(where + ": expected an accessor below " + std::to_string(model.accessors.size()) + ", found " +
                std::to_string(index));
  const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(index)];
  const std::string name = where + ", accessor " + std::to_string(index);
  const int found = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type));
  if (found != components)
    throw Error(name + ": expected " + std::to_string(components) + " components, found " + std::to_string(found));
  const int type = accessor.componentType;
  const int component_bytes = tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(type));
  if (component_bytes <= 0 || type == TINYGLTF_COMPONENT_TYPE_DOUBLE || type == TINYGLTF_COMPONENT_TYPE_INT)
    throw Error(name + ": expected a component type of glTF 2.0, found " + std::to_string(type));
  constexpr size_t kMostValues = size_t{1} << 28;  // of an accessor without bytes, whose count is all that a file gives
  if (accessor.bufferView < 0 && accessor.count > kMostValues)
    throw Error(name + ": expected at most " + std::to_string(kMostValues) + " elements, found " +
                std::to_string(accessor.count));

  const size_t width = static_cast<size_t>(components), bytes = static_cast<size_t>(component_bytes);
  std::vector<double> values;
  const auto read_element = [&](const uint8_t* at, double* to) {
    for (size_t c = 0; c < width; ++c) to[c] = component(at + c * bytes, type, accessor.normalized);
  };
  if (accessor.bufferView >= 0) {
    const Elements from = elements_at(name, model, accessor.bufferView, static_cast<int64_t>(accessor.byteOffset),
                                      width * bytes, accessor.count, true);
    values.resize(accessor.count * width);
    for (size_t i = 0; i < accessor.count; ++i) read_element(from.first + i * from.stride, &values[i * width]);
  } else {
    values.resize(accessor.count * width);
  }
  if (accessor.sparse.isSparse && accessor.sparse.count > 0) {
    const size_t count = static_cast<size_t>(accessor.sparse.count);
    const auto& at = accessor.sparse.indices;
    if (at.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
        at.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        at.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
      throw Error(name + ": expected unsigned sparse indices, found component type " +
                  std::to_string(at.componentType));
    const size_t index_bytes =
        static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(at.componentType)));
    const Elements indices =
        elements_at(name + ", sparse indices", model, at.bufferView, at.byteOffset, index_bytes, count, false);
    const Elements from = elements_at(name + ", sparse values", model, accessor.sparse.values.bufferView,
                                      accessor.sparse.values.byteOffset, width * bytes, count, false);
    for (size_t i = 0; i < count; ++i) {
      const size_t element = static_cast<size_t>(component(indices.first + i * index_bytes, at.componentType, false));
      if (element >= accessor.count)
        throw Error(name + ": expected sparse indices below " + std::to_string(accessor.count) + ", found " +
                    std::to_string(element));
      read_element(from.first + i * from.stride, &values[element * width]);
    }
  }
  return values;
}

}  // namespace

std::vector<float> accessor_floats(const std::string& where, const tinygltf::Model& model, int accessor,
                                   int components) {
  const std::vector<double> values = accessor_values(where, model, accessor, components);
  std::vector<float> out(values.size());
  for (size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]))
      throw Error(where + ", accessor " + std::to_string(accessor) +
                  ": expected finite numbers, found NaN or infinity in element " +
                  std::to_string(i / static_cast<size_t>(components)));
    out[i] = static_cast<float>(values[i]);
  }
  return out;
}

std::vector<uint32_t> accessor_integers(const std::string& where, const tinygltf::Model& model, int accessor,
                                        int components) {
  const std::vector<double> values = accessor_values(where, model, accessor, components);
  std::vector<uint32_t> out(values.size());
  for (size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] >= 0 && values[i] <= UINT32_MAX) || values[i] != std::floor(values[i]))
      throw Error(where + ", accessor " + std::to_string(accessor) +
                  ": expected whole numbers from 0, found another in element " +
                  std::to_string(i / static_cast<size_t>(components)));
    out[i] = static_cast<uint32_t>(values[i]);
  }
  return out;
}

std::vector<Affine> inverse_bind_matrices(const std::string& where, const tinygltf::Model& model,
                                          const tinygltf::Skin& skin) {
  std::vector<Affine> matrices(skin.joints.size(), kIdentity);
  if (skin.inverseBindMatrices < 0) return matrices;
  const std::vector<float> values =
      accessor_floats(where + ", inverse bind matrices", model, skin.inverseBindMatrices, 16);
  if (values.size() < matrices.size() * 16)
    throw Error(where + ": expected " + std::to_string(matrices.size()) + " inverse bind matrices, found " +
                std::to_string(values.size() / 16));
  for (size_t j = 0; j < matrices.size(); ++j)
    for (size_t r = 0; r < 3; ++r)
      for (size_t c = 0; c < 4; ++c) matrices[j][r * 4 + c] = static_cast<double>(values[j * 16 + c * 4 + r]);
  return matrices;
}

std::vector<std::array<uint32_t, 3>> primitive_triangles(const std::string& where, const tinygltf::Model& model,
                                                         const tinygltf::Primitive& primitive, size_t vertex_count) {
  std::vector<uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = accessor_integers(where + ", indices", model, primitive.indices, 1);
    for (const uint32_t index : indices)
      if (index >= vertex_count)
        throw Error(where + ": expected indices below " + std::to_string(vertex_count) + ", found " +
                    std::to_string(index));
  } else {
    for (size_t v = 0; v < vertex_count; ++v) indices.push_back(static_cast<uint32_t>(v));
  }
  const bool list = primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP && primitive.mode != TINYGLTF_MODE_TRIANGLE_FAN;
  if (list && indices.size() % 3 != 0)
    throw Error(where + ": expected indices in threes, found " + std::to_string(indices.size()));
  std::vector<std::array<uint32_t, 3>> triangles;
  for (size_t i = 2; i < indices.size(); i += list ? 3 : 1) {
    std::array<uint32_t, 3> corners = {indices[i - 2], indices[i - 1], indices[i]};
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1) std::swap(corners[1], corners[2]);
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) corners[0] = indices[0];
    triangles.push_back(corners);
  }
  return triangles;
}

}  // namespace sinew
