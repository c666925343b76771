// SPDX-License-Identifier: MIT
// Fuzz target: the rig.txt reader, with and without skin lines.
#include "reader_checks.hpp"
#include "sinew_formats/io.hpp"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace sinew;
  using namespace sinew::test;
  const std::string path = input_file(data, size, "input.rig.txt");
  for (const bool with_skin : {false, true}) {
    Character mesh;
    mesh.vertices.resize(5);
    const auto read = [&] {
      Character character = mesh;
      read_skeleton(path, with_skin, &character);
      return character;
    };
    const auto character = read_or_refuse(path, read);
    if (!character) continue;
    check_character(*character);
    demand(!character->joints.empty(), "a rig has joints");
    demand(same_joints(*character, read()), "a second reading gives the same");
    const std::string again = input_file(nullptr, 0, "again.rig.txt");
    write_rig(again, *character);
    Character second = mesh;
    read_skeleton(again, with_skin, &second);  // an Error here is a finding
    demand(second.joints.size() == character->joints.size(), "what was written has the same joints");
    for (size_t j = 0; j < second.joints.size(); ++j)
      demand(second.joints[j].parent == character->joints[j].parent, "what was written has the same parents");
  }
  return 0;
}
