// SPDX-License-Identifier: MIT
// Fuzz target: the OBJ reader. What it accepts is sound, and survives being written and read again.
#include "reader_checks.hpp"
#include "sinew_formats/io.hpp"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace sinew;
  using namespace sinew::test;
  const std::string path = input_file(data, size, "input.obj");
  const auto character = read_or_refuse(path, [&] { return read_obj(path); });
  if (!character) return 0;
  check_character(*character);
  const std::string again = input_file(nullptr, 0, "again.obj");
  write_obj(again, *character);
  const Character second = read_obj(again);  // an Error here is a finding
  demand(same_mesh(*character, second), "what was written reads back as the same mesh");
  demand(character->corner_uvs == second.corner_uvs, "texture coordinates survive");
  demand(same_points(character->corner_normals, second.corner_normals), "normals survive");
  return 0;
}
