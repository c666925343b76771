// SPDX-License-Identifier: MIT
// Assimp's scene to glTF: nodes, skins and meshes. Only where Assimp is: in the command, and in the module of WebAssembly that reads FBX and COLLADA alone.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <unordered_map>

#include "gltf/collada_lists.hpp"
#include "gltf/gltf_container.hpp"
#include "gltf/gltf_from_scene.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/scene_input.hpp"
#include "gltf/scene_nodes.hpp"
#include "gltf/scene_process.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

class SceneConverter {
 public:
  SceneConverter(const std::string& path, const aiScene& scene)
      : path_(path), scene_(scene), found_(find_scene_nodes(path, scene)), nodes_(found_.nodes) {}

  // Bytes of a GLB.
  std::vector<uint8_t> convert(std::vector<std::string>* notes) {
    source_.document = {{"asset", {{"version", "2.0"}, {"generator", "sinew"}}}, {"scene", 0}};
    add_scene_materials(path_, scene_, &source_);
    for (size_t n = 0; n < nodes_.size(); ++n) add_node(n);
    add_unused_skin();
    document()["scenes"] = {{{"nodes", roots_}}};
    add_scene_animations(path_, scene_, found_.by_name, &source_);
    if (skipped_faces_ != 0)
      source_.notes.push_back(std::to_string(skipped_faces_) + " points and lines were left out");
    *notes = std::move(source_.notes);
    return pack_glb(path_, &document(), std::move(source_.bytes));
  }

 private:
  Json& document() { return source_.document; }

  void add_node(size_t n) {
    const SceneNode& from = nodes_[n];
    Json node = Json::object();
    node["name"] = from.node->mName.C_Str();
    if (!stands_alone(n)) position(found_.locals[n], &node);
    if (from.parent < 0 || stands_alone(n)) roots_.push_back(n);
    for (size_t child = n + 1; child < nodes_.size(); ++child)
      if (nodes_[child].parent == static_cast<int>(n) && !stands_alone(child)) node["children"].push_back(child);
    if (from.node->mNumMeshes != 0) {
      const int mesh = add_mesh(n);
      if (mesh >= 0) {
        node["mesh"] = mesh;
        if (is_skinned(n)) node["skin"] = skin_of(n);
      }
    }
    document()["nodes"].push_back(std::move(node));
  }

  // Translation, rotation and scale, as editors want them; a matrix where these cannot say it (shear).
  static void position(const Affine& local, Json* node) {
    if (local == kIdentity) return;
    const auto f = [&](size_t i) { return static_cast<float>(local[i]); };
    const aiMatrix4x4 matrix(f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7), f(8), f(9), f(10), f(11), 0, 0, 0, 1);
    aiVector3D scale, at;
    aiQuaternion rotation;
    matrix.Decompose(scale, rotation, at);
    rotation.Normalize();
    const aiMatrix4x4 again(scale, rotation, at);
    const float size = std::max({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)});
    bool same = size > 0 && std::isfinite(rotation.w);
    for (unsigned r = 0; r < 3; ++r)
      for (unsigned c = 0; c < 3; ++c) same = same && std::abs(again[r][c] - matrix[r][c]) <= 1e-5f * size;
    if (!same) {
      (*node)["matrix"] = columns_of(local);
      return;
    }
    (*node)["translation"] = {at.x, at.y, at.z};
    (*node)["rotation"] = {rotation.x, rotation.y, rotation.z, rotation.w};
    (*node)["scale"] = {scale.x, scale.y, scale.z};
  }

  // Transforms above a skinned mesh have no effect in glTF, and validators warn about them.
  bool stands_alone(size_t n) const {
    return is_skinned(n) && nodes_[n].node->mNumChildren == 0 && !nodes_[n].joint && nodes_[n].parent >= 0;
  }

  bool is_skinned(size_t n) const {
    for (unsigned i = 0; i < nodes_[n].node->mNumMeshes; ++i)
      if (scene_.mMeshes[nodes_[n].node->mMeshes[i]]->mNumBones != 0) return true;
    return false;
  }

  // All joints in every skin; those that move nothing of this mesh go with the nearest joint above that does.
  int skin_of(size_t mesh_node) {
    std::vector<std::optional<Affine> > positions(nodes_.size());  // world x bind, where known
    std::optional<Affine> first;
    for (size_t n = 0; n < nodes_.size(); ++n) {
      const auto at = nodes_[n].binds.find(static_cast<int>(mesh_node));
      if (at == nodes_[n].binds.end()) continue;
      positions[n] = multiply(nodes_[n].world, at->second);
      if (!first) first = positions[n];
    }
    std::vector<float> values;
    for (const size_t n : found_.joint_nodes) {
      Affine bind = kIdentity;
      const auto at = nodes_[n].binds.find(static_cast<int>(mesh_node));
      if (at != nodes_[n].binds.end()) {
        bind = at->second;
      } else {
        std::optional<Affine> position;
        for (int up = nodes_[n].parent; up >= 0 && !position; up = nodes_[static_cast<size_t>(up)].parent)
          position = positions[static_cast<size_t>(up)];
        const std::optional<Affine> back = inverse(nodes_[n].world);
        if (back) bind = multiply(*back, position ? *position : *first);
      }
      if (!is_finite(bind))
        throw Error(path_ + ": joint " + in_quotes(nodes_[n].node->mName.C_Str()) +
                    ": expected a finite bind matrix, found another");
      const std::vector<float> columns = columns_of(bind);
      values.insert(values.end(), columns.begin(), columns.end());
    }
    const auto [known, is_new] = skins_.try_emplace(values, static_cast<int>(skins_.size()));
    if (is_new) {
      const int accessor = add_accessor(&source_, values.data(), values.size() * 4, "MAT4",
                                        TINYGLTF_COMPONENT_TYPE_FLOAT, found_.joint_nodes.size(), false, false);
      document()["skins"].push_back({{"joints", found_.joint_nodes}, {"inverseBindMatrices", accessor}});
    }
    return known->second;
  }

  // A skeleton that moves no mesh yet.
  void add_unused_skin() {
    if (skins_.empty() && !found_.joint_nodes.empty()) document()["skins"].push_back({{"joints", found_.joint_nodes}});
  }

  int add_mesh(size_t n) {
    const aiNode& node = *nodes_[n].node;
    Json primitives = Json::array();
    std::set<unsigned> target_counts;
    std::vector<std::string> target_names;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[i]];
      const Json primitive = primitive_of(node.mMeshes[i]);
      if (primitive.is_null()) continue;
      target_counts.insert(mesh.mNumAnimMeshes);
      target_names.clear();
      for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t) target_names.push_back(mesh.mAnimMeshes[t]->mName.C_Str());
      primitives.push_back(primitive);
    }
    if (primitives.empty()) return -1;
    Json mesh = {{"name", node.mName.C_Str()}};
    if (target_counts.size() > 1) {  // glTF: all primitives of a mesh have the same
      for (Json& primitive : primitives) primitive.erase("targets");
      source_.notes.push_back("blend shapes of " + in_quotes(node.mName.C_Str()) +
                              " were left out: its parts have different blend shapes");
    } else if (!target_names.empty()) {
      mesh["extras"] = {{"targetNames", target_names}};
    }
    mesh["primitives"] = std::move(primitives);
    document()["meshes"].push_back(std::move(mesh));
    return static_cast<int>(document()["meshes"].size()) - 1;
  }

  using Influences = std::vector<std::pair<uint16_t, float> >;

  std::vector<Influences> influences_of(const aiMesh& mesh) const {
    std::vector<Influences> rows(mesh.mNumBones == 0 ? 0 : mesh.mNumVertices);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const aiBone& bone = *mesh.mBones[b];
      const uint16_t joint = static_cast<uint16_t>(found_.joint_number.at(found_.bone_nodes.at(&bone)));
      for (unsigned w = 0; w < bone.mNumWeights; ++w) {
        const aiVertexWeight& weight = bone.mWeights[w];
        if (weight.mVertexId < mesh.mNumVertices && weight.mWeight > 0 && std::isfinite(weight.mWeight))
          rows[weight.mVertexId].emplace_back(joint, weight.mWeight);
      }
    }
    for (Influences& row : rows) {
      std::stable_sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
      float sum = 0;
      for (const auto& [joint, weight] : row) sum += weight;
      for (auto& [joint, weight] : row) weight /= sum;
    }
    return rows;
  }

  // Corners that agree in everything are one vertex: Assimp hands out one vertex per corner.
  struct IndexedVertices {
    std::vector<unsigned> first;    // a corner of each vertex
    std::vector<uint32_t> indices;  // of triangles
  };

  IndexedVertices join(const aiMesh& mesh, const std::vector<Influences>& rows) {
    IndexedVertices joined;
    std::unordered_map<std::string, uint32_t> numbers;
    const auto add = [](std::string* key, const auto& value) {
      key->append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) {
        ++skipped_faces_;
        continue;
      }
      for (unsigned c = 0; c < 3; ++c) {
        const unsigned v = face.mIndices[c];
        if (v >= mesh.mNumVertices)
          throw Error(path_ + ": mesh " + in_quotes(mesh.mName.C_Str()) + ": expected vertices below " +
                      std::to_string(mesh.mNumVertices) + ", found " + std::to_string(v));
        std::string key;
        add(&key, mesh.mVertices[v]);
        if (mesh.HasNormals()) add(&key, mesh.mNormals[v]);
        if (mesh.HasTextureCoords(0)) add(&key, mesh.mTextureCoords[0][v]);
        if (mesh.HasVertexColors(0)) add(&key, mesh.mColors[0][v]);
        for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t)
          if (mesh.mAnimMeshes[t]->HasPositions()) add(&key, mesh.mAnimMeshes[t]->mVertices[v]);
        if (!rows.empty())
          for (const auto& [joint, weight] : rows[v]) add(&key, joint), add(&key, weight);
        const auto [at, is_new] = numbers.emplace(std::move(key), static_cast<uint32_t>(joined.first.size()));
        if (is_new) joined.first.push_back(v);
        joined.indices.push_back(at->second);
      }
    }
    return joined;
  }

  Json primitive_of(unsigned mesh_index) {
    const auto known = primitives_.find(mesh_index);
    if (known != primitives_.end()) return known->second;
    Json& primitive = primitives_[mesh_index];
    const aiMesh& mesh = *scene_.mMeshes[mesh_index];
    const std::vector<Influences> rows = influences_of(mesh);
    const IndexedVertices joined = join(mesh, rows);
    if (joined.first.empty()) return primitive;
    Json attributes;
    std::vector<float> positions, normals, uvs, colors;
    for (const unsigned v : joined.first) {
      const aiVector3D& p = mesh.mVertices[v];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw Error(path_ + ": mesh " + in_quotes(mesh.mName.C_Str()) + ": expected finite positions, found others");
      positions.insert(positions.end(), {p.x, p.y, p.z});
      if (mesh.HasNormals()) {
        aiVector3D normal = mesh.mNormals[v];
        const float length = normal.Length();
        normal = std::isfinite(length) && length > 1e-20f ? normal / length : aiVector3D(0, 1, 0);
        normals.insert(normals.end(), {normal.x, normal.y, normal.z});
      }
      const auto number = [](float value) { return std::isfinite(value) ? value : 0.0f; };
      if (mesh.HasTextureCoords(0)) {
        const aiVector3D& uv = mesh.mTextureCoords[0][v];
        uvs.insert(uvs.end(), {number(uv.x), number(1 - uv.y)});
      }
      if (mesh.HasVertexColors(0)) {
        const aiColor4D& color = mesh.mColors[0][v];
        for (const float channel : {color.r, color.g, color.b, color.a})
          colors.push_back(std::clamp(number(channel), 0.0f, 1.0f));
      }
    }
    attributes["POSITION"] = add_vectors(&source_, positions, 3, true);
    if (!normals.empty()) attributes["NORMAL"] = add_vectors(&source_, normals, 3, false);
    if (!uvs.empty()) attributes["TEXCOORD_0"] = add_vectors(&source_, uvs, 2, false);
    if (!colors.empty()) attributes["COLOR_0"] = add_vectors(&source_, colors, 4, false);
    add_weights(joined, rows, &attributes);
    primitive = {{"attributes", attributes}};
    primitive["indices"] = add_accessor(&source_, joined.indices.data(), joined.indices.size() * 4, "SCALAR",
                                        TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, joined.indices.size(), false, false);
    document()["bufferViews"].back()["target"] = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
    if (mesh.mMaterialIndex < scene_.mNumMaterials) primitive["material"] = mesh.mMaterialIndex;
    for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t) {
      const aiAnimMesh& target = *mesh.mAnimMeshes[t];
      std::vector<float> differences;
      for (const unsigned v : joined.first) {
        const aiVector3D d = target.HasPositions() ? target.mVertices[v] - mesh.mVertices[v] : aiVector3D();
        for (const float value : {d.x, d.y, d.z}) differences.push_back(std::isfinite(value) ? value : 0.0f);
      }
      primitive["targets"].push_back({{"POSITION", add_vectors(&source_, differences, 3, true)}});
    }
    return primitive;
  }

  void add_weights(const IndexedVertices& joined, const std::vector<Influences>& rows, Json* attributes) {
    if (rows.empty()) return;
    size_t longest = 1;
    for (const unsigned v : joined.first) longest = std::max(longest, rows[v].size());
    for (size_t set = 0; set * 4 < longest; ++set) {
      std::vector<uint16_t> joints;
      std::vector<float> weights;
      for (const unsigned v : joined.first)
        for (size_t k = set * 4; k < set * 4 + 4; ++k) {
          joints.push_back(k < rows[v].size() ? rows[v][k].first : uint16_t{0});
          weights.push_back(k < rows[v].size() ? rows[v][k].second : 0.0f);
        }
      (*attributes)["JOINTS_" + std::to_string(set)] =
          add_accessor(&source_, joints.data(), joints.size() * 2, "VEC4", TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                       joints.size() / 4, true, false);
      (*attributes)["WEIGHTS_" + std::to_string(set)] = add_vectors(&source_, weights, 4, false);
    }
  }

  std::string path_;
  const aiScene& scene_;
  GltfSource source_;
  const SceneNodes found_;
  const std::vector<SceneNode>& nodes_;
  std::vector<size_t> roots_;
  std::map<std::vector<float>, int> skins_;
  std::map<unsigned, Json> primitives_;
  size_t skipped_faces_ = 0;
};

// Meshes may be called as joints are (find_scene_nodes).
bool joint_names_are_unique(const aiNode* root) {
  std::set<std::string> seen;
  std::vector<const aiNode*> open = {root};
  while (!open.empty()) {
    const aiNode* node = open.back();
    open.pop_back();
    if (node->mNumMeshes == 0 && !seen.insert(node->mName.C_Str()).second) return false;
    open.insert(open.end(), node->mChildren, node->mChildren + node->mNumChildren);
  }
  return true;
}

const aiScene* import(const std::string& path, bool names_for_people, Assimp::Importer* importer) {
  // Without this, a joint of FBX becomes a chain of up to ten nodes named $AssimpFbx$.
  importer->SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  importer->SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer->SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, names_for_people);
#ifdef AI_CONFIG_IMPORT_FBX_IGNORE_UP_AXIS_DIRECTION  // Assimp after 5.2 rotates it by default
  importer->SetPropertyBool(AI_CONFIG_IMPORT_FBX_IGNORE_UP_AXIS_DIRECTION, true);
#endif
  const aiScene* scene = importer->ReadFile(path, aiProcess_Triangulate);
  if (scene != nullptr && scene->mRootNode != nullptr) return scene;
  const std::string reason = importer->GetErrorString();
  if (reason.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
  throw Error(path + ": expected " + file_kind(path)->name + ", found a file that Assimp does not read: " +
              one_line(reason) + "; open it in Blender and export it: File > Export > glTF 2.0");
}

SceneBytes convert_scene(const std::string& path, Assimp::Importer* importer) {
  try {
    const aiScene* scene = import(path, true, importer);
    // COLLADA's bones are found by name: where two joints share one, by identifier.
    if (has_extension(path, ".dae") && !joint_names_are_unique(scene->mRootNode)) scene = import(path, false, importer);
    SceneBytes out;
    out.glb = SceneConverter(path, *scene).convert(&out.notes);
    return out;
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(path + ": expected " + file_kind(path)->name +
                ", found a file that needs more memory than one of its size may; export it again");
  } catch (const std::exception& error) {
    throw Error(path + ": expected a complete scene, found errors: " + one_line(error.what()));
  }
}

}  // namespace

std::vector<uint8_t> scene_to_glb(const std::string& path, std::vector<std::string>* notes) {
  const std::vector<uint8_t> file = read_file(path);
  if (file.empty()) throw Error(path + ": expected a scene, found an empty file");
  if (has_extension(path, ".dae")) check_collada_lists(path, file);
  try {
    Assimp::Importer importer;              // here: a missing library is reported, and an available one is loaded once
    importer.SetIOHandler(new SceneFiles);  // the importer deletes it
    SceneBytes scene = convert_in_child(path, file_kind(path)->name, scene_limits(file.size()),
                                        [&] { return convert_scene(path, &importer); });
    notes->insert(notes->end(), scene.notes.begin(), scene.notes.end());
    return std::move(scene.glb);
  } catch (const Error& error) {  // a library that is missing knows of no file
    const std::string text = error.what();
    if (text.rfind(path, 0) == 0) throw;
    throw Error(path + ": " + text);
  }
}

}  // namespace sinew
