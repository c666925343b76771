// SPDX-License-Identifier: MIT
// The frame of an FBX: header, settings, definitions, objects, connections.
#include "fbx/fbx_write.hpp"

#include <algorithm>

namespace sinew {
namespace {

constexpr const char* kCreator = "sinew";

FbxNode header() {
  FbxNode node("FBXHeaderExtension");
  node.add("FBXHeaderVersion").integer(1003);
  node.add("FBXVersion").integer(7500);
  node.add("EncryptionType").integer(0);
  FbxNode time("CreationTimeStamp");
  time.add("Version").integer(1000);
  for (const auto& [name, value] : std::vector<std::pair<const char*, int32_t>>{
           {"Year", 1970}, {"Month", 1}, {"Day", 1}, {"Hour", 10}, {"Minute", 0}, {"Second", 0}, {"Millisecond", 0}})
    time.add(name).integer(value);
  node.add(std::move(time));
  node.add("Creator").text(kCreator);
  FbxNode info("SceneInfo");
  info.text(fbx_name("GlobalInfo", "SceneInfo")).text("UserData");
  info.add("Type").text("UserData");
  info.add("Version").integer(100);
  FbxNode meta("MetaData");
  meta.add("Version").integer(100);
  for (const char* name : {"Title", "Subject", "Author", "Keywords", "Revision", "Comment"}) meta.add(name).text("");
  info.add(std::move(meta));
  FbxNode properties("Properties70");
  properties.property_text("Original|ApplicationName", "", kCreator);
  properties.property_text("LastSaved|ApplicationName", "", kCreator);
  info.add(std::move(properties));
  node.add(std::move(info));
  return node;
}

FbxNode settings() {
  FbxNode node("GlobalSettings");
  node.add("Version").integer(1000);
  FbxNode properties("Properties70");
  for (const auto& [name, value] : std::vector<std::pair<const char*, int32_t>>{{"UpAxis", 1},
                                                                                {"UpAxisSign", 1},
                                                                                {"FrontAxis", 2},
                                                                                {"FrontAxisSign", 1},
                                                                                {"CoordAxis", 0},
                                                                                {"CoordAxisSign", 1},
                                                                                {"OriginalUpAxis", -1},
                                                                                {"OriginalUpAxisSign", 1}})
    properties.property_integer(name, value);
  properties.property_number("UnitScaleFactor", 1);
  properties.property_number("OriginalUnitScaleFactor", 1);
  properties.property_enum("TimeMode", 6);  // 30 frames per second
  properties.property_time("TimeSpanStart", 0);
  properties.property_time("TimeSpanStop", static_cast<int64_t>(kFbxTicks));
  properties.property_number("CustomFrameRate", -1);
  node.add(std::move(properties));
  return node;
}

FbxNode documents(const tinygltf::Model& model, int64_t id) {
  FbxNode node("Documents");
  node.add("Count").integer(1);
  FbxNode document("Document");
  document.id(id).text("").text("Scene");
  FbxNode properties("Properties70");
  properties.property("SourceObject", "object", "", "");
  properties.property_text("ActiveAnimStackName", "", model.animations.empty() ? "" : model.animations[0].name);
  document.add(std::move(properties));
  document.add("RootNode").id(0);
  node.add(std::move(document));
  return node;
}

FbxNode definitions(const FbxScene& scene) {
  FbxNode node("Definitions");
  node.add("Version").integer(100);
  int32_t count = 1;
  for (const auto& [kind, of_kind] : scene.counts) count += of_kind;
  node.add("Count").integer(count);
  FbxNode global("ObjectType");
  global.text("GlobalSettings");
  global.add("Count").integer(1);
  node.add(std::move(global));
  for (const auto& [kind, of_kind] : scene.counts) {
    FbxNode type("ObjectType");
    type.text(kind);
    type.add("Count").integer(of_kind);
    node.add(std::move(type));
  }
  return node;
}

void add_bind_pose(const FbxModels& models, FbxScene* scene) {
  if (models.bound.empty()) return;
  int64_t id = 0;
  FbxNode pose = scene->object("Pose", "BindPose", "Pose", "BindPose", &id);
  pose.add("Type").text("BindPose");
  pose.add("Version").integer(100);
  pose.add("NbPoseNodes").integer(static_cast<int32_t>(models.bound.size()));
  for (const auto& [model, at] : models.bound) {
    FbxNode entry("PoseNode");
    entry.add("Node").id(model);
    entry.add("Matrix").matrix(at);
    pose.add(std::move(entry));
  }
  scene->add("Pose", std::move(pose));
}

}  // namespace

FbxNode FbxScene::object(const char* kind, const std::string& name, const char* of, const char* type, int64_t* id) {
  *id = ++last_id;
  FbxNode node(kind);
  node.id(*id).text(fbx_name(name, of)).text(type);
  return node;
}

void FbxScene::add(const char* kind, FbxNode object) {
  ++counts[kind];
  objects.push_back(std::move(object));
}

void FbxScene::connect(int64_t child, int64_t parent) {
  FbxNode node("C");
  node.text("OO").id(child).id(parent);
  connections.push_back(std::move(node));
}

void FbxScene::connect(int64_t child, int64_t parent, const char* property) {
  FbxNode node("C");
  node.text("OP").id(child).id(parent).text(property);
  connections.push_back(std::move(node));
}

std::vector<uint8_t> fbx_of(const std::string& path, const tinygltf::Model& model) {
  const GltfNodes nodes = gltf_nodes(path, model);
  FbxScene scene;
  const std::vector<int64_t> materials = add_fbx_materials(model, &scene);
  const FbxModels models = add_fbx_models(path, model, nodes, materials, &scene);
  add_bind_pose(models, &scene);
  add_fbx_animations(path, model, models, &scene);
  FbxNode id("FileId"), time("CreationTime"), creator("Creator"), references("References"), objects("Objects"),
      connections("Connections"), takes("Takes");
  id.bytes(fbx_file_id().data(), fbx_file_id().size());
  time.text(fbx_creation_time());
  creator.text(kCreator);
  for (FbxNode& object : scene.objects) objects.add(std::move(object));
  for (FbxNode& connection : scene.connections) connections.add(std::move(connection));
  takes.add("Current").text("");
  return fbx_file({header(), id, time, creator, settings(), documents(model, 999999), references, definitions(scene),
                   std::move(objects), std::move(connections), std::move(takes)});
}

}  // namespace sinew
