// SPDX-License-Identifier: MIT
// Fuzz target: the glTF reader (GLB and JSON). What it accepts is sound; with a row of weights for every vertex it can
// be written as a skinned GLB, which reads back.
#include "reader_checks.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"

namespace {

// Animations: refused as the mesh is, or joints whole in every frame.
void read_motion_of(const std::string& path) {
  using namespace sinew;
  using namespace sinew::test;
  Motion motion;
  try {
    motion = read_gltf_motion(path);
  } catch (const Error& error) {
    check_refusal(error.what(), path);
    return;
  }
  demand(!motion.clips.empty() && !motion.joints.empty(), "a motion has clips and joints");
  for (const Clip& clip : motion.clips) {
    demand(clip.frame_time > 0 && !clip.frames.empty(), "a clip has frames and a rate");
    for (const MotionFrame& frame : clip.frames) {
      demand(frame.rotations.size() == motion.joints.size(), "a frame has every joint");
      for (const Quaternion& q : frame.rotations)
        demand(std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1) < 1e-9, "turns have length 1");
      for (const Point3& p : frame.translations) demand(std::isfinite(p[0] + p[1] + p[2]), "places are finite");
    }
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace sinew;
  using namespace sinew::test;
  const std::string path = input_file(data, size, "input.glb");
  read_motion_of(path);  // a motion needs no mesh
  const auto character = read_or_refuse(path, [&] { return read_gltf(path); });
  if (!character) return 0;
  check_character(*character);
  const Character once_more = read_gltf(path);
  demand(same_mesh(*character, once_more) && same_joints(*character, once_more), "a second reading gives the same");
  if (character->joints.empty()) return 0;

  Character bound = *character;
  bound.influences.assign(bound.vertices.size(), {});
  for (size_t v = 0; v < bound.vertices.size(); ++v)
    bound.influences[v] = {{static_cast<uint32_t>(v % bound.joints.size()), 1.0f}};
  const std::string again = input_file(nullptr, 0, "again.glb");
  const auto second = [&]() -> std::optional<Character> {
    try {
      write_glb(again, bound);
    } catch (const Error& error) {  // transforms without an inverse, say
      check_refusal(error.what(), again);
      return std::nullopt;
    }
    try {
      return read_gltf(again);
    } catch (
        const Error& error) {  // near the largest floats an inverse bind matrix may not be one; all else is a finding
      demand(std::string(error.what()).find("finite") != std::string::npos, error.what());
      return std::nullopt;
    }
  }();
  if (!second) return 0;
  check_character(*second);
  demand(second->face_vertices.size() == character->face_vertices.size(), "what was written has the same faces");
  return 0;
}
