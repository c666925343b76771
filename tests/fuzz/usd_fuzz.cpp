// SPDX-License-Identifier: MIT
// Fuzz target: the reader of USD, its text and its packages. What it accepts is sound, and comes back from what is written of it.
#include "reader_checks.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace sinew;
  using namespace sinew::test;
  const bool is_package = size >= 2 && data[0] == 'P' && data[1] == 'K';
  const std::string path = input_file(data, size, is_package ? "input.usdz" : "input.usda");
  try {
    demand(!read_motion(path).clips.empty(), "a motion has clips");
  } catch (const Error& error) {
    check_refusal(error.what(), path);
  }
  const auto character = read_or_refuse(path, [&] { return read_gltf(path); });
  if (!character) return 0;
  check_character(*character);
  const std::string again = input_file(nullptr, 0, "again.usda");
  const auto second = read_or_refuse(again, [&] {
    write_gltf(again, *character);
    return read_gltf(again);
  });
  if (!second) return 0;  // numbers that no float holds
  check_character(*second);
  demand(second->face_count() == character->face_count(), "what was written has the same faces");
  demand(second->joints.size() >= character->joints.size(), "and the joints");
  return 0;
}
