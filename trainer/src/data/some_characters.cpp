// SPDX-License-Identifier: MIT
// Every so many files of a folder's list.
#include "data/some_characters.hpp"

#include <algorithm>
#include <vector>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {

void each_of_some_characters(const std::string& folder, size_t limit,
                             const std::function<bool(const Character&, size_t)>& use) {
  const std::vector<std::string> paths = list_characters(folder);
  const size_t count = limit == 0 ? paths.size() : std::min(limit, paths.size());
  bool used = false;
  std::string last = folder + ": no characters (NAME.obj with NAME.rig.txt, or .glb)";
  for (size_t i = 0; i < count; ++i) {
    try {
      used = use(read_character(paths[i * paths.size() / count]), i) || used;
    } catch (const Error& error) {
      last = error.what();
    }
  }
  if (!used) throw Error(last);
}

}  // namespace sinew
