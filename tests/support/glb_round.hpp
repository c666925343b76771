// SPDX-License-Identifier: MIT
// Documents to characters and back, for tests of the glTF reader and writer.
#ifndef SINEW_TESTS_GLB_ROUND_HPP
#define SINEW_TESTS_GLB_ROUND_HPP

#include <map>
#include <string>

#include "make_glb.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"
#if __has_include("gltf/gltf_source.hpp")  // tests that see the sources of formats
#include "rest_pose.hpp"
#endif

inline sinew::Character read(const GlbBuilder& builder) {
  const TempFolder folder;
  return sinew::read_gltf(folder.write("cat.glb", builder.glb()));
}

inline std::string written(const sinew::Character& character, const sinew::GlbOptions& options = {}) {
  const TempFolder folder;
  sinew::write_glb(folder.file("out.glb"), character, options);
#if __has_include("gltf/gltf_source.hpp")
  expect_same_rest(character, folder.file("out.glb"));
#endif
  return folder.text_of("out.glb");
}

inline sinew::Character reread(const std::string& glb) {
  const TempFolder folder;
  return sinew::read_gltf(folder.write("again.glb", glb));
}

inline std::map<uint32_t, float> row(const sinew::Character& c, size_t v) {
  std::map<uint32_t, float> out;
  for (const sinew::Influence& i : c.influences[v]) out[i.joint] += i.weight;
  return out;
}

// A lamp hangs on the knee without a skin; a stone lies beside the character.
inline GlbBuilder with_parts() {
  GlbBuilder builder = two_joint_strip();
  const int triangle = builder.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const nlohmann::json primitive = {{"attributes", {{"POSITION", triangle}}}};
  builder.add("meshes", {{"name", "shared"}, {"primitives", nlohmann::json::array({primitive})}});
  const int lamp =
      builder.add("nodes", {{"name", "lamp"}, {"mesh", 1}, {"translation", {0, 0, 1}}, {"scale", {2, 2, 2}}});
  builder.document["nodes"][1]["children"] = {lamp};
  builder.root({{"name", "stone"}, {"mesh", 1}, {"translation", {-5, 0, 0}}});
  return builder;
}

#endif
