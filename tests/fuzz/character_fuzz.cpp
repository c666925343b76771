// SPDX-License-Identifier: MIT
// Fuzz target: characters from memory through the C API. The first byte says the extension. What is refused has one line; what is
// accepted has sound arrays and can be written as .glb or .rig.txt, or is refused with one line.
#include <string>

#include "fuzz.hpp"
#include "sinew/character.h"

namespace {

using sinew::test::demand;

void check_line(const sinew_character* character) {
  const std::string line = sinew_character_error(character);
  demand(!line.empty() && line.size() < 2000, "an error has a line");
  for (const char c : line)
    demand(static_cast<unsigned char>(c) >= 32 && c != 127, "an error is one line of printable text: " + line);
}

void check_arrays(sinew_character* character) {
  sinew_character_arrays a = SINEW_INIT(sinew_character_arrays);
  demand(sinew_character_view(character, &a) == SINEW_OK, "what was opened has arrays");
  demand(a.face_offsets[a.face_count] == a.corner_count, "offsets end at the corners");
  for (uint32_t c = 0; c < a.corner_count; ++c) demand(a.face_vertices[c] < a.vertex_count, "corners name vertices");
  for (uint32_t j = 0; j < a.joint_count; ++j)
    demand(a.parents[j] >= -1 && a.parents[j] < static_cast<int32_t>(a.joint_count), "parents exist");
  for (uint32_t i = 0; a.row_offsets != nullptr && i < a.row_offsets[a.vertex_count]; ++i)
    demand(a.joint_indices[i] < a.joint_count, "weights name joints");
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const char* names[] = {"x.obj", "x.glb", "x.gltf", "x.bvh", "x.rig.txt", "x.dae"};
  const sinew_file file = {names[data[0] % 6], data + 1, size - 1};
  sinew_character* character = nullptr;
  if (sinew_character_open_files(&file, 1, &character) != SINEW_OK) {
    demand(character == nullptr, "a refusal gives no character");
    check_line(nullptr);
    return 0;
  }
  check_arrays(character);
  uint32_t clips = 0;
  demand(sinew_character_clip_count(character, &clips) == SINEW_OK, "clips are counted");
  const sinew_file* files = nullptr;
  uint32_t count = 0;
  for (const char* name : {"y.glb", "y.rig.txt"})
    if (sinew_character_write(character, name, &files, &count) != SINEW_OK) check_line(character);
  sinew_character_close(character);
  return 0;
}
