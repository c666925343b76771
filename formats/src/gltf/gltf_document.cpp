// SPDX-License-Identifier: MIT
// A glTF document loaded through tinygltf; joints of another file as its nodes.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>

#include "gltf/gltf_container.hpp"
#include "gltf/gltf_decompress.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

namespace fs = std::filesystem;

// tinygltf before 2.6 expanded file names as a shell does (wordexp), which a file from a stranger must never reach.
tinygltf::FsCallbacks plain_file_access() {
  tinygltf::FsCallbacks access;
  access.FileExists = [](const std::string& path, void*) { return is_file(path); };
  access.ExpandFilePath = [](const std::string& path, void*) { return path; };
  access.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* problem, const std::string& path, void*) {
    try {
      *out = read_file(path);
      return true;
    } catch (const Error& error) {
      if (problem != nullptr) *problem += error.what();
      return false;
    }
  };
  access.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  access.user_data = nullptr;
  return access;
}

// Keeps the file's bytes; nothing here looks at pictures.
bool keep_image(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes,
                int size, void*) {
  image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

// Puts all buffers behind one another.
void gather_buffers(GltfSource* source) {
  const tinygltf::Model& model = source->model;
  Json& document = source->document;
  std::vector<size_t> starts;
  for (const tinygltf::Buffer& buffer : model.buffers) {
    source->bytes.resize((source->bytes.size() + 7) / 8 * 8);  // keeps the alignment of the largest component inside
    starts.push_back(source->bytes.size());
    source->bytes.insert(source->bytes.end(), buffer.data.begin(), buffer.data.end());
  }
  const auto move = [&](Json* view) {
    const size_t buffer = view->at("buffer").get<size_t>();
    (*view)["buffer"] = 0;
    const size_t offset = view->value("byteOffset", size_t{0}) + starts.at(buffer);
    if (offset != 0) (*view)["byteOffset"] = offset;
  };
  if (document.contains("bufferViews"))
    for (Json& view : document["bufferViews"]) {
      move(&view);
      if (view.contains("extensions"))
        for (auto& [name, extension] : view["extensions"].items())
          if (extension.is_object() && extension.contains("buffer")) move(&extension);
    }
  if (!model.buffers.empty()) {
    Json buffer = document["buffers"][0];
    buffer.erase("uri");
    document["buffers"] = Json::array({buffer});
  }
}

// glTF's counts, sizes and numbers of elements. The loader takes a fraction under such a name for a field that is not
// there, and what reads the document later would take it for another number.
bool is_whole_number_field(const std::string& key) {
  static const std::set<std::string> fields = {"buffer",
                                               "bufferView",
                                               "byteLength",
                                               "byteOffset",
                                               "byteStride",
                                               "camera",
                                               "children",
                                               "count",
                                               "indices",
                                               "input",
                                               "inverseBindMatrices",
                                               "joints",
                                               "mesh",
                                               "node",
                                               "material",
                                               "mode",
                                               "nodes",
                                               "output",
                                               "sampler",
                                               "scene",
                                               "skeleton",
                                               "skin",
                                               "source",
                                               "componentType"};
  return fields.count(key) != 0;
}

void refuse_fractions(const std::string& path, const Json& value, const std::string& key, bool whole) {
  if (whole && value.is_number() && !value.is_number_integer())
    throw Error(path + ": expected a whole number for '" + key + "', found " + value.dump());
  if (value.is_array())
    for (const Json& element : value) refuse_fractions(path, element, key, whole);
  if (!value.is_object()) return;
  const bool numbers = key == "attributes" || key == "targets";  // whose fields have names of their own
  for (const auto& field : value.items())
    if (field.key() != "extras" && field.key() != "extensions")
      refuse_fractions(path, field.value(), numbers ? key : field.key(), numbers || is_whole_number_field(field.key()));
}

}  // namespace

GltfSource load_gltf(const std::string& path, const std::vector<uint8_t>& file) {
  if (file.empty()) throw Error(path + ": expected a glTF file, found an empty file");
  if (file.size() > UINT32_MAX)
    throw Error(path + ": expected a glTF file below 4 GiB, found " + std::to_string(file.size()) + " bytes");
  const bool binary = file.size() >= 4 && std::memcmp(file.data(), "glTF", 4) == 0;
  if (binary && file.size() < 20)
    throw Error(path + ": truncated GLB, expected a header of 20 bytes, found " + std::to_string(file.size()));
  if (binary && read_u32(file, 4) != 2)
    throw Error(path + ": expected glTF version 2, found version " + std::to_string(read_u32(file, 4)));
  if (binary && read_u32(file, 8) > file.size())
    throw Error(path + ": truncated GLB, expected " + std::to_string(read_u32(file, 8)) + " bytes, found " +
                std::to_string(file.size()));

  std::vector<std::string> notes;
  if (const std::optional<std::vector<uint8_t>> plain = decompress_gltf(path, file, &notes)) {
    GltfSource source = load_gltf(path, *plain);
    source.notes = std::move(notes);
    return source;
  }

  GltfSource source;
  source.path = path;
  source.in_memory = memory_inputs() != nullptr;
  std::string problem, warning;
  bool ok = false;
  try {
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks(plain_file_access());
    loader.SetImageLoader(keep_image, nullptr);
    const std::string folder = fs::path(path).parent_path().string();
    const unsigned size = static_cast<unsigned>(file.size());
    ok = binary ? loader.LoadBinaryFromMemory(&source.model, &problem, &warning, file.data(), size, folder)
                : loader.LoadASCIIFromString(&source.model, &problem, &warning,
                                             reinterpret_cast<const char*>(file.data()), size, folder);
    if (ok) {
      const uint8_t* text = binary ? file.data() + 20 : file.data();
      source.document = Json::parse(text, binary ? text + read_u32(file, 12) : file.data() + file.size());
    }
  } catch (const std::exception& error) {
    problem += error.what();
    ok = false;
  }
  if (!ok) throw Error(path + ": expected a glTF 2.0 file, found one that does not parse: " + one_line(problem));
  refuse_fractions(path, source.document, "", false);
  try {
    gather_buffers(&source);
  } catch (const std::exception& error) {
    throw Error(path + ": expected buffer views that name their buffer, found others: " + one_line(error.what()));
  }
  return source;
}

std::shared_ptr<GltfSource> read_again(const std::string& name, GltfSource changed) {
  auto fresh = std::make_shared<GltfSource>(std::move(changed));
  GltfSource read = load_gltf(fresh->path.empty() ? name : fresh->path, pack_glb(name, &fresh->document, fresh->bytes));
  fresh->model = std::move(read.model);
  fresh->document = std::move(read.document);
  fresh->bytes = std::move(read.bytes);
  return fresh;
}

bool same_joints(const std::vector<Joint>& a, const std::vector<Joint>& b) {
  return a.size() == b.size() && has_joints(a, b);
}

bool has_joints(const std::vector<Joint>& a, const std::vector<Joint>& b) {
  if (a.size() < b.size()) return false;
  for (size_t j = b.size(); j < a.size(); ++j)
    if (a[j].parent < 0 || joint_index(a[j].parent) >= j) return false;
  return std::equal(b.begin(), b.end(), a.begin(), [](const Joint& y, const Joint& x) {
    return x.name == y.name && (x.parent == y.parent || y.parent < 0) && x.position.x == y.position.x &&
           x.position.y == y.position.y && x.position.z == y.position.z;
  });
}

std::vector<int> add_joint_nodes(const std::string& path, const std::vector<Joint>& joints, Json* document) {
  Json& nodes = (*document)["nodes"];
  if (nodes.is_null()) nodes = Json::array();
  const size_t base = nodes.size();
  std::vector<int> numbers;
  std::vector<size_t> roots;
  for (size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    if (joint.parent >= static_cast<int>(joints.size()))
      throw Error(path + ": cannot write, joint " + in_quotes(joint.name) + " has a parent that does not exist");
    size_t steps = 0;
    for (int up = joint.parent; up >= 0; up = joints[static_cast<size_t>(up)].parent)
      if (++steps > joints.size())
        throw Error(path + ": cannot write, joint " + in_quotes(joint.name) + " is in a cycle");
    const Vec3 from = joint.parent < 0 ? Vec3{} : joints[static_cast<size_t>(joint.parent)].position;
    const auto difference = [](float a, float b) { return static_cast<double>(a) - static_cast<double>(b); };
    nodes.push_back({{"name", joint.name},
                     {"translation",
                      {difference(joint.position.x, from.x), difference(joint.position.y, from.y),
                       difference(joint.position.z, from.z)}}});
    numbers.push_back(static_cast<int>(base + j));
    if (joint.parent < 0) roots.push_back(base + j);
  }
  for (size_t j = 0; j < joints.size(); ++j)
    if (joints[j].parent >= 0) nodes[base + static_cast<size_t>(joints[j].parent)]["children"].push_back(base + j);
  size_t top = roots.empty() ? 0 : roots[0];
  if (roots.size() > 1) {
    top = nodes.size();
    nodes.push_back({{"name", "skeleton"}, {"children", roots}});
  }
  if (document->contains("scenes") && !(*document)["scenes"].empty() && !roots.empty()) {
    const size_t scene = document->value("scene", size_t{0});
    (*document)["scenes"].at(scene)["nodes"].push_back(top);
  }
  return numbers;
}

}  // namespace sinew
