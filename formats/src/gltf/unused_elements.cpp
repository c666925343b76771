// SPDX-License-Identifier: MIT
// Elements that a document's elements name by number, taken out where nothing needs them: accessors, buffer views, the nodes of an old skeleton.
#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <utility>

#include "gltf/gltf_source.hpp"

namespace sinew {
namespace {

// Extensions known to hold no accessor and no buffer view: with any other, numbers must stay as they are.
bool numbers_may_change(const Json& document) {
  constexpr std::array<const char*, 6> kKnown = {"KHR_materials_",        "KHR_texture_",     "KHR_lights_punctual",
                                                 "KHR_mesh_quantization", "EXT_texture_webp", "VRM"};
  if (!document.contains("extensionsUsed")) return true;
  for (const Json& used : document["extensionsUsed"]) {
    const std::string name = used.get<std::string>();
    if (std::none_of(kKnown.begin(), kKnown.end(), [&](const char* prefix) { return name.rfind(prefix, 0) == 0; }))
      return false;
  }
  return true;
}

using Visit = std::function<void(Json*)>;

void visit(Json* parent, const char* key, const Visit& each) {
  if (parent->is_object() && parent->contains(key)) each(&(*parent)[key]);
}

void visit_all(Json* parent, const char* key, const Visit& each) {
  if (parent->is_object() && parent->contains(key))
    for (Json& element : (*parent)[key]) each(&element);
}

// Every value of the document that is the number of an accessor.
void visit_accessor_numbers(Json* document, const Visit& each) {
  visit_all(document, "meshes", [&](Json* mesh) {
    visit_all(mesh, "primitives", [&](Json* primitive) {
      visit_all(primitive, "attributes", each);
      visit(primitive, "indices", each);
      visit_all(primitive, "targets", [&](Json* target) {
        for (Json& attribute : *target) each(&attribute);
      });
    });
  });
  visit_all(document, "skins", [&](Json* skin) { visit(skin, "inverseBindMatrices", each); });
  visit_all(document, "animations", [&](Json* animation) {
    visit_all(animation, "samplers", [&](Json* sampler) {
      visit(sampler, "input", each);
      visit(sampler, "output", each);
    });
  });
}

void visit_view_numbers_of_accessor(Json* accessor, const Visit& each) {
  visit(accessor, "bufferView", each);
  visit(accessor, "sparse", [&](Json* sparse) {
    visit(sparse, "indices", [&](Json* indices) { visit(indices, "bufferView", each); });
    visit(sparse, "values", [&](Json* values) { visit(values, "bufferView", each); });
  });
}

void visit_view_numbers(Json* document, const Visit& each) {
  visit_all(document, "accessors", [&](Json* accessor) { visit_view_numbers_of_accessor(accessor, each); });
  visit_all(document, "images", [&](Json* image) { visit(image, "bufferView", each); });
}

// Every value of the document that is the number of a node, but for those by which VRM's extensions name joints (forget_joints()).
void visit_node_numbers(Json* document, const Visit& each) {
  visit_all(document, "scenes", [&](Json* scene) { visit_all(scene, "nodes", each); });
  visit_all(document, "nodes", [&](Json* node) { visit_all(node, "children", each); });
  visit_all(document, "skins", [&](Json* skin) {
    visit_all(skin, "joints", each);
    visit(skin, "skeleton", each);
  });
  visit_all(document, "animations", [&](Json* animation) {
    visit_all(animation, "channels",
              [&](Json* channel) { visit(channel, "target", [&](Json* target) { visit(target, "node", each); }); });
  });
  visit_all(document, "meshes", [&](Json* mesh) {
    visit(mesh, "extras", [&](Json* extras) {
      visit(extras, "sinew_correctives",
            [&](Json* drivers) { visit_all(drivers, "joints", [&](Json* joint) { visit(joint, "node", each); }); });
    });
  });
  visit(document, "extensions", [&](Json* extensions) {
    visit(extensions, "VRMC_vrm", [&](Json* vrm) {
      visit(vrm, "firstPerson",
            [&](Json* view) { visit_all(view, "meshAnnotations", [&](Json* mesh) { visit(mesh, "node", each); }); });
      visit(vrm, "expressions", [&](Json* lists) {
        for (const char* list : {"preset", "custom"})
          visit_all(lists, list, [&](Json* expression) {
            visit_all(expression, "morphTargetBinds", [&](Json* bind) { visit(bind, "node", each); });
          });
      });
    });
  });
}

// False for a file that names accessors or buffer views that it does not have, where the reader had no need
// of.
bool numbers_exist(Json* document) {
  bool exist = true;
  const auto below = [&](const char* key) {
    const size_t count = document->contains(key) ? (*document)[key].size() : 0;
    return [&exist, count](Json* number) { exist = exist && number->get<size_t>() < count; };
  };
  visit_accessor_numbers(document, below("accessors"));
  visit_view_numbers(document, below("bufferViews"));
  return exist;
}

// Takes the elements in `gone` out of document[key] and lets `renumber` put the new numbers into all references. Returns the new numbers; one that
// is gone has that of the next.
std::vector<size_t> remove_elements(Json* document, const char* key, const std::set<size_t>& gone,
                                    const std::function<void(const Visit&)>& renumber) {
  Json& elements = (*document)[key];
  std::vector<size_t> new_number(elements.size());
  Json kept = Json::array();
  for (size_t i = 0; i < elements.size(); ++i) {
    new_number[i] = kept.size();
    if (gone.count(i) == 0) kept.push_back(std::move(elements[i]));
  }
  elements = std::move(kept);
  renumber([&](Json* number) { *number = new_number.at(number->get<size_t>()); });
  return new_number;
}

// Moves the bytes of all buffer views together; views that overlap keep doing so.
void pack_bytes(GltfSource* source) {
  Json& views = source->document["bufferViews"];
  std::vector<std::array<size_t, 2>> spans;  // begin, end
  for (const Json& view : views) {
    const size_t begin = view.value("byteOffset", size_t{0}), length = view.at("byteLength").get<size_t>();
    // A view outside of the buffer, or before it (a negative offset is a huge one here): leave a broken file as it is.
    if (begin > source->bytes.size() || length > source->bytes.size() - begin) return;
    spans.push_back({begin, begin + length});
  }
  std::sort(spans.begin(), spans.end());
  std::vector<std::array<size_t, 3>> moves;  // old begin, old end, new begin
  std::vector<uint8_t> packed;
  for (const auto& [begin, end] : spans) {
    if (!moves.empty() && begin < moves.back()[1]) {
      const size_t known = moves.back()[1];
      if (end <= known) continue;
      packed.insert(packed.end(), source->bytes.begin() + static_cast<std::ptrdiff_t>(known),
                    source->bytes.begin() + static_cast<std::ptrdiff_t>(end));
      moves.back()[1] = end;
      continue;
    }
    while (packed.size() % 4 != begin % 4) packed.push_back(0);
    moves.push_back({begin, end, packed.size()});
    packed.insert(packed.end(), source->bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                  source->bytes.begin() + static_cast<std::ptrdiff_t>(end));
  }
  for (Json& view : views) {
    const size_t begin = view.value("byteOffset", size_t{0});
    const auto after =
        std::upper_bound(moves.begin(), moves.end(), begin, [](size_t at, const auto& move) { return at < move[0]; });
    const auto& move = *(after - 1);
    view["byteOffset"] = begin - move[0] + move[2];
  }
  source->bytes = std::move(packed);
}

// Data of a document about joints that it loses: bones, springs and constraints of a VRM, which has neither meaning
// without them, and drivers of corrections.
void forget_joints(Json* document) {
  visit(document, "extensions", [](Json* extensions) {
    for (const char* name : {"VRM", "VRMC_vrm"})
      visit(extensions, name, [](Json* vrm) {
        for (const char* key : {"humanoid", "lookAt", "secondaryAnimation"}) vrm->erase(key);
        visit(vrm, "firstPerson", [](Json* view) { view->erase("firstPersonBone"); });
      });
  });
  visit_all(document, "nodes", [](Json* node) {
    visit(node, "extensions", [](Json* extensions) { extensions->erase("VRMC_node_constraint"); });
    if (node->contains("extensions") && (*node)["extensions"].empty()) node->erase("extensions");
  });
  visit_all(document, "meshes",
            [](Json* mesh) { visit(mesh, "extras", [](Json* extras) { extras->erase("sinew_correctives"); }); });
  for (const char* name : {"VRMC_springBone", "VRMC_node_constraint"}) drop_extension(name, document);
}

// Old joints and their descendants that hold nothing: no mesh, no camera, no light, no joint that a skin still has.
// Ancestors without other children are removed too.
std::set<size_t> bare_nodes(const std::vector<tinygltf::Skin>& old_skins, const Json& document) {
  const Json& nodes = document["nodes"];
  std::vector<int> parents(nodes.size(), -1);
  for (size_t n = 0; n < nodes.size(); ++n)
    for (const Json& child : nodes[n].value("children", Json::array()))
      parents.at(child.get<size_t>()) = static_cast<int>(n);
  std::vector<char> hangs(nodes.size(), 0), used(nodes.size(), 0);
  for (const tinygltf::Skin& skin : old_skins)
    for (const int joint : skin.joints) hangs.at(static_cast<size_t>(joint)) = 1;
  const Json skins = document.value("skins", Json::array());
  for (const Json& skin : skins)
    for (const Json& joint : skin["joints"]) used.at(joint.get<size_t>()) = 1;
  std::set<size_t> gone;
  for (bool changed = true; changed;) {
    changed = false;
    for (size_t n = 0; n < nodes.size(); ++n) {
      if (gone.count(n) != 0) continue;
      const int parent = parents[n];
      if (parent >= 0 && hangs[static_cast<size_t>(parent)] != 0 && hangs[n] == 0) hangs[n] = changed = true;
      const Json children = nodes[n].value("children", Json::array());
      const bool alone = std::all_of(children.begin(), children.end(),
                                     [&](const Json& child) { return gone.count(child.get<size_t>()) != 0; });
      const bool holds =
          used[n] != 0 || nodes[n].contains("mesh") || nodes[n].contains("camera") || nodes[n].contains("extensions");
      if (!alone || holds || (hangs[n] == 0 && children.empty())) continue;
      gone.insert(n);
      changed = true;
    }
  }
  return gone;
}

// Channels that move nodes which are gone, their samplers, and animations that are left empty. Returns the accessors that lost a user.
std::vector<int> drop_channels(const std::set<size_t>& gone, Json* document) {
  std::vector<int> orphans;
  if (!document->contains("animations")) return orphans;
  Json animations = Json::array();
  for (Json& animation : (*document)["animations"]) {
    Json channels = Json::array(), samplers = Json::array();
    std::vector<int> new_number(animation["samplers"].size(), -1);
    for (Json& channel : animation["channels"]) {
      if (channel["target"].contains("node") && gone.count(channel["target"]["node"].get<size_t>()) != 0) continue;
      int& number = new_number.at(channel["sampler"].get<size_t>());
      if (number < 0) {
        number = static_cast<int>(samplers.size());
        samplers.push_back(animation["samplers"][channel["sampler"].get<size_t>()]);
      }
      channel["sampler"] = number;
      channels.push_back(std::move(channel));
    }
    for (size_t s = 0; s < new_number.size(); ++s)
      if (new_number[s] < 0)
        for (const char* key : {"input", "output"}) orphans.push_back(animation["samplers"][s][key].get<int>());
    if (channels.empty()) continue;
    animation["channels"] = std::move(channels);
    animation["samplers"] = std::move(samplers);
    animations.push_back(std::move(animation));
  }
  (*document)["animations"] = std::move(animations);
  if ((*document)["animations"].empty()) document->erase("animations");
  return orphans;
}

void keep_others(const std::set<size_t>& gone, const char* key, Json* parent) {
  if (!parent->contains(key)) return;
  Json kept = Json::array();
  for (const Json& number : (*parent)[key])
    if (gone.count(number.get<size_t>()) == 0) kept.push_back(number);
  if (kept.empty())
    parent->erase(key);
  else
    (*parent)[key] = std::move(kept);
}

}  // namespace

void drop_extension(const char* name, Json* document) {
  visit(document, "extensions", [&](Json* extensions) { extensions->erase(name); });
  visit(document, "extensionsUsed",
        [&](Json* used) { used->erase(std::remove(used->begin(), used->end(), name), used->end()); });
  for (const char* key : {"extensions", "extensionsUsed"})
    if (document->contains(key) && (*document)[key].empty()) document->erase(key);
}

void drop_old_skeleton(GltfJoints* joints, GltfSource* source) {
  Json& document = source->document;
  forget_joints(&document);
  if (!numbers_may_change(document)) return;
  const std::set<size_t> gone = bare_nodes(source->model.skins, document);
  if (gone.empty()) return;
  const std::vector<int> orphans = drop_channels(gone, &document);
  visit_all(&document, "scenes", [&](Json* scene) { keep_others(gone, "nodes", scene); });
  visit_all(&document, "nodes", [&](Json* node) { keep_others(gone, "children", node); });
  visit_all(&document, "skins", [&](Json* skin) {
    if (skin->contains("skeleton") && gone.count((*skin)["skeleton"].get<size_t>()) != 0) skin->erase("skeleton");
  });
  const std::vector<size_t> new_number =
      remove_elements(&document, "nodes", gone, [&](const Visit& each) { visit_node_numbers(&document, each); });
  const auto renumber = [&](int* node) { *node = static_cast<int>(new_number.at(static_cast<size_t>(*node))); };
  for (int& node : joints->nodes) renumber(&node);
  for (GltfPart& part : source->parts) renumber(&part.node);
  std::vector<Affine> worlds;
  for (size_t n = 0; n < source->bind_pose.worlds.size(); ++n)
    if (gone.count(n) == 0) worlds.push_back(source->bind_pose.worlds[n]);
  source->bind_pose.worlds = std::move(worlds);
  source->joint_nodes.clear();
  drop_unused_accessors(orphans, source);
}

void drop_unused_accessors(std::vector<int> candidates, GltfSource* source) {
  Json& document = source->document;
  if (!numbers_may_change(document) || !numbers_exist(&document)) return;
  std::set<size_t> gone(candidates.begin(), candidates.end());
  visit_accessor_numbers(&document, [&](Json* number) { gone.erase(number->get<size_t>()); });
  if (gone.empty()) return;
  std::set<size_t> views;
  for (const size_t accessor : gone)
    visit_view_numbers_of_accessor(&document["accessors"].at(accessor),
                                   [&](Json* number) { views.insert(number->get<size_t>()); });
  remove_elements(&document, "accessors", gone, [&](const Visit& each) { visit_accessor_numbers(&document, each); });
  visit_view_numbers(&document, [&](Json* number) { views.erase(number->get<size_t>()); });
  remove_elements(&document, "bufferViews", views, [&](const Visit& each) { visit_view_numbers(&document, each); });
  pack_bytes(source);
}

bool drop_unused_view(size_t view, Json* document) {
  if (!numbers_may_change(*document) || !numbers_exist(document)) return false;
  std::set<size_t> views = {view};
  visit_view_numbers(document, [&](Json* number) { views.erase(number->get<size_t>()); });
  if (views.empty()) return false;
  remove_elements(document, "bufferViews", views, [&](const Visit& each) { visit_view_numbers(document, each); });
  return true;
}

}  // namespace sinew
