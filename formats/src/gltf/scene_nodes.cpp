// SPDX-License-Identifier: MIT
// A scene's nodes, which of them are joints, by what they move and their parents, and its materials as glTF has them.
#include "gltf/scene_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include "files/picture_files.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "text/text_lines.hpp"

namespace sinew {

Affine affine_of(const aiMatrix4x4& m) {
  return {static_cast<double>(m.a1), static_cast<double>(m.a2), static_cast<double>(m.a3), static_cast<double>(m.a4),
          static_cast<double>(m.b1), static_cast<double>(m.b2), static_cast<double>(m.b3), static_cast<double>(m.b4),
          static_cast<double>(m.c1), static_cast<double>(m.c2), static_cast<double>(m.c3), static_cast<double>(m.c4)};
}

bool is_finite(const Affine& m) {
  return std::all_of(m.begin(), m.end(), [](double value) { return std::isfinite(value); });
}

namespace {

class NodeFinder {
 public:
  NodeFinder(const std::string& path, const aiScene& scene) : path_(path), scene_(scene) {}

  SceneNodes find() {
    collect_nodes();
    find_bones();
    find_joints();
    return std::move(out_);
  }

 private:
  // FBX names its axes and counts in centimeters by a factor; Assimp leaves both to us. (COLLADA's and MD5's are in the
  // root.)
  Affine to_meters_and_y_up() const {
    if (has_extension(path_, ".smd")) return {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0};  // Z is up
    if (!has_extension(path_, ".fbx") || scene_.mMetaData == nullptr) return kIdentity;
    float factor = 1;
    double scale = 1;
    if (scene_.mMetaData->Get("UnitScaleFactor", factor))
      scale = static_cast<double>(factor);
    else if (!scene_.mMetaData->Get("UnitScaleFactor", scale))
      scale = 1;
    scale = std::isfinite(scale) && scale > 0 ? scale * 0.01 : 0.01;
    // Right, up and front of the file become +X, +Y and +Z.
    const std::array<std::array<const char*, 2>, 3> names = {
        {{"CoordAxis", "CoordAxisSign"}, {"UpAxis", "UpAxisSign"}, {"FrontAxis", "FrontAxisSign"}}};
    Affine rotation{};
    double determinant = 0;
    std::array<size_t, 3> axes{};
    std::array<double, 3> signs{};
    for (size_t r = 0; r < 3; ++r) {
      int32_t axis = static_cast<int32_t>(r), sign = 1;
      (void)scene_.mMetaData->Get(names[r][0], axis);
      (void)scene_.mMetaData->Get(names[r][1], sign);
      axes[r] = axis >= 0 && axis < 3 ? static_cast<size_t>(axis) : r;
      signs[r] = sign < 0 ? -1 : 1;
      rotation[r * 4 + axes[r]] = signs[r] * scale;
    }
    const bool even = (axes[1] + 3 - axes[0]) % 3 == 1;
    if (axes[0] != axes[1] && axes[1] != axes[2] && axes[0] != axes[2])
      determinant = signs[0] * signs[1] * signs[2] * (even ? 1 : -1);
    // Axes that mirror, or name one twice, are no axes.
    return determinant > 0 ? rotation : Affine{scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0};
  }

  void collect_nodes() {
    std::set<std::string> cameras_lights;
    for (unsigned i = 0; i < scene_.mNumCameras; ++i) cameras_lights.insert(scene_.mCameras[i]->mName.C_Str());
    for (unsigned i = 0; i < scene_.mNumLights; ++i) cameras_lights.insert(scene_.mLights[i]->mName.C_Str());
    nodes_.push_back({scene_.mRootNode, -1});
    for (size_t n = 0; n < nodes_.size(); ++n) {
      const aiNode& node = *nodes_[n].node;
      Affine local = affine_of(node.mTransformation);
      if (n == 0) local = multiply(to_meters_and_y_up(), local);
      if (!is_finite(local))
        throw Error(path_ + ": node " + in_quotes(node.mName.C_Str()) + ": expected a finite transform, found another");
      out_.locals.push_back(local);
      nodes_[n].world =
          nodes_[n].parent < 0 ? local : multiply(nodes_[static_cast<size_t>(nodes_[n].parent)].world, local);
      bool null = false;
      if (node.mMetaData != nullptr) (void)node.mMetaData->Get("IsNull", null);
      nodes_[n].not_a_joint = null || cameras_lights.count(node.mName.C_Str()) != 0;
      out_.by_name.emplace(node.mName.C_Str(), n);
      all_by_name_.emplace(node.mName.C_Str(), n);
      for (unsigned c = 0; c < node.mNumChildren; ++c) nodes_.push_back({node.mChildren[c], static_cast<int>(n)});
    }
  }

  // Assimp has only a bone's name. Of several nodes with that name it is one that is not a mesh or locator, at the
  // position where the bone was bound.
  size_t node_of(const aiBone& bone, const aiMesh& mesh, size_t mesh_node) const {
    const auto [begin, end] = all_by_name_.equal_range(bone.mName.C_Str());
    if (begin == end)
      throw Error(path_ + ": mesh " + in_quotes(mesh.mName.C_Str()) + ": expected a node for its bone " +
                  in_quotes(bone.mName.C_Str()) + ", found none");
    const auto rank = [&](size_t n) {
      const Affine bound = multiply(nodes_[n].world, affine_of(bone.mOffsetMatrix));
      double apart = 0;
      for (size_t i = 0; i < bound.size(); ++i)
        apart = std::max(apart, std::abs(bound[i] - nodes_[mesh_node].world[i]));
      return std::tuple(nodes_[n].node->mNumMeshes != 0, nodes_[n].not_a_joint, apart);
    };
    return std::min_element(begin, end, [&](const auto& a, const auto& b) { return rank(a.second) < rank(b.second); })
        ->second;
  }

  void find_bones() {
    for (size_t n = 0; n < nodes_.size(); ++n)
      for (unsigned i = 0; i < nodes_[n].node->mNumMeshes; ++i) {
        const aiMesh& mesh = *scene_.mMeshes[nodes_[n].node->mMeshes[i]];
        for (unsigned b = 0; b < mesh.mNumBones; ++b) {
          const aiBone& bone = *mesh.mBones[b];
          const size_t at = node_of(bone, mesh, n);
          out_.bone_nodes.emplace(&bone, at);
          out_.by_name[bone.mName.C_Str()] = at;
          nodes_[at].bone = true;
          nodes_[at].binds.emplace(static_cast<int>(n), affine_of(bone.mOffsetMatrix));
        }
      }
    for (size_t n = nodes_.size(); n-- > 0;) {
      SceneNode& node = nodes_[n];
      node.meshes_below = node.meshes_below || node.node->mNumMeshes != 0;
      if (node.parent < 0) continue;
      SceneNode& parent = nodes_[static_cast<size_t>(node.parent)];
      parent.meshes_below = parent.meshes_below || node.meshes_below;
      parent.bones_below = parent.bones_below || node.bone || node.bones_below;
    }
  }

  // FBX marks its locators, so that all else without a mesh is a joint; the others mark nothing.
  void find_joints() {
    const bool fbx = has_extension(path_, ".fbx");
    const bool has_bones = nodes_[0].bones_below || nodes_[0].bone;
    std::vector<char> below_bone(nodes_.size(), 0);
    std::vector<int> branches(nodes_.size(), 0);
    for (size_t n = 1; n < nodes_.size(); ++n) {
      const size_t parent = static_cast<size_t>(nodes_[n].parent);
      below_bone[n] = below_bone[parent] != 0 || nodes_[parent].bone;
      branches[parent] += nodes_[n].bone || nodes_[n].bones_below;
    }
    for (size_t n = 0; n < nodes_.size(); ++n) {
      SceneNode& node = nodes_[n];
      if (node.bone) node.joint = true;
      if (node.joint || n == 0 || node.node->mNumMeshes != 0) continue;
      if (!has_bones)
        node.joint =
            fbx && !node.not_a_joint &&
            !(node.meshes_below && nodes_[static_cast<size_t>(node.parent)].parent < 0 && node.node->mNumChildren == 0);
      else if (node.bones_below)  // hips without weights: the branches meet there
        node.joint = below_bone[n] != 0 || (fbx ? !node.not_a_joint : branches[n] > 1 && !node.meshes_below);
      else  // leaves and their ancestors
        node.joint = nodes_[static_cast<size_t>(node.parent)].joint && !node.meshes_below && !node.not_a_joint;
    }
    for (size_t n = 0; n < nodes_.size(); ++n)
      if (nodes_[n].joint) {
        out_.joint_number[n] = out_.joint_nodes.size();
        out_.joint_nodes.push_back(n);
      }
  }

  const std::string& path_;
  const aiScene& scene_;
  SceneNodes out_;
  std::vector<SceneNode>& nodes_ = out_.nodes;
  std::multimap<std::string, size_t> all_by_name_;
};

}  // namespace

SceneNodes find_scene_nodes(const std::string& path, const aiScene& scene) { return NodeFinder(path, scene).find(); }

// Colors, opacity and pictures; what no glTF material has is left out.

namespace {

class MaterialWriter {
 public:
  MaterialWriter(const std::string& path, const aiScene& scene, GltfSource* source)
      : scene_(scene), source_(*source), pictures_(path, &source->notes) {}

  void add_material(const aiMaterial& from) {
    aiString name;
    (void)from.Get(AI_MATKEY_NAME, name);
    std::array<float, 4> base = {1, 1, 1, 1};
    aiColor3D color;
    if (from.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS) base = {color.r, color.g, color.b, 1};
    float opacity = 1;
    // Exporters that write 0 mean the opposite: an exported body is visible.
    if (from.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS && opacity > 0 && opacity < 1) base[3] = opacity;
    Json material = {{"name", name.C_Str()}};
    const int texture = texture_of(from, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}, false);
    Json& surface = material["pbrMetallicRoughness"];
    surface = {{"metallicFactor", 0}, {"roughnessFactor", 0.9}};
    if (texture >= 0) {
      base[0] = base[1] = base[2] = 1;
      surface["baseColorTexture"] = {{"index", texture}};
    }
    for (float& channel : base) channel = std::isfinite(channel) ? std::clamp(channel, 0.0f, 1.0f) : 1.0f;
    surface["baseColorFactor"] = base;
    if (base[3] < 1) material["alphaMode"] = "BLEND";
    const int normal =
        texture_of(from, {aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA, aiTextureType_HEIGHT}, true);
    if (normal >= 0) material["normalTexture"] = {{"index", normal}};
    source_.document["materials"].push_back(std::move(material));
  }

 private:
  int texture_of(const aiMaterial& material, std::initializer_list<aiTextureType> kinds, bool normals) {
    for (const aiTextureType kind : kinds) {
      aiString name;
      if (material.GetTexture(kind, 0, &name) != AI_SUCCESS || name.length == 0 || name == aiString(".")) continue;
      const auto [at, is_new] = textures_.try_emplace(name.C_Str(), -1);
      if (!is_new) return at->second;
      Picture picture;
      if (const aiTexture* inside = scene_.GetEmbeddedTexture(name.C_Str()); inside != nullptr) {
        const uint8_t* bytes = reinterpret_cast<const uint8_t*>(inside->pcData);
        if (inside->mHeight == 0 && png_or_jpeg(bytes, inside->mWidth) != nullptr)
          picture = std::make_shared<std::vector<uint8_t> >(bytes, bytes + inside->mWidth);
        else
          source_.notes.push_back("embedded picture " + in_quotes(name.C_Str()) +
                                  " is not a PNG or JPEG, so the output lacks it; convert it");
      } else {
        picture = pictures_.find(name.C_Str());
      }
      if (!picture || (normals && is_gray(*picture))) return -1;
      source_.bytes.resize((source_.bytes.size() + 3) / 4 * 4);
      source_.document["bufferViews"].push_back(
          {{"buffer", 0}, {"byteOffset", source_.bytes.size()}, {"byteLength", picture->size()}});
      source_.bytes.insert(source_.bytes.end(), picture->begin(), picture->end());
      if (!source_.document.contains("buffers")) source_.document["buffers"] = Json::array({Json::object()});
      source_.document["images"].push_back({{"bufferView", source_.document["bufferViews"].size() - 1},
                                            {"mimeType", png_or_jpeg(picture->data(), picture->size())}});
      source_.document["textures"].push_back({{"source", source_.document["images"].size() - 1}});
      return at->second = static_cast<int>(source_.document["textures"].size()) - 1;
    }
    return -1;
  }

  const aiScene& scene_;
  GltfSource& source_;
  PictureFiles pictures_;
  std::map<std::string, int> textures_;
};

}  // namespace

void add_scene_materials(const std::string& path, const aiScene& scene, GltfSource* source) {
  MaterialWriter writer(path, scene, source);
  for (unsigned m = 0; m < scene.mNumMaterials; ++m) writer.add_material(*scene.mMaterials[m]);
}

}  // namespace sinew
