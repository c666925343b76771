// SPDX-License-Identifier: MIT
// FBX and COLLADA in a module without Assimp: JavaScript has the module of scenes/ make a GLB of them, see src/scenes.js.
#include <emscripten.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gltf/gltf_from_scene.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"

// The GLB into a file of this module, and the messages about it: {notes} or {error} as text for free(); null without
// that module.
EM_JS(char*, read_scene, (const char* path, const char* glb), {
  if (!Module["readScene"]) return 0;
  const said = Module["readScene"](UTF8ToString(path), UTF8ToString(glb));
  const size = lengthBytesUTF8(said) + 1;
  const text = _malloc(size);
  stringToUTF8(said, text, size);
  return text;
});

namespace sinew {
namespace {

// The files that a caller has in memory, where the other module finds them, while it reads.
class OnDisk {
 public:
  explicit OnDisk(const FileBytes* files) {
    if (files == nullptr) return;
    const MemoryFiles disk(nullptr, nullptr);
    for (const auto& [name, bytes] : *files) {
      const std::filesystem::path path = name;
      if (path.is_absolute() || *path.begin() == "..") continue;
      if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
      write_file(name, bytes);
      names_.push_back(name);
    }
  }
  OnDisk(const OnDisk&) = delete;
  OnDisk& operator=(const OnDisk&) = delete;
  ~OnDisk() {
    for (const std::string& name : names_) std::remove(name.c_str());
  }

 private:
  std::vector<std::string> names_;
};

}  // namespace

std::vector<uint8_t> scene_to_glb(const std::string& path, std::vector<std::string>* notes) {
  const OnDisk beside(memory_inputs());
  const MemoryFiles disk(nullptr, nullptr);
  const std::string glb = "/tmp/scene.glb";
  const std::unique_ptr<char, void (*)(void*)> text(read_scene(path.c_str(), glb.c_str()), std::free);
  if (!text)
    throw Error(path +
                ": cannot be read here, where FBX and COLLADA alone are read by Assimp; the sinew command reads it");
  const nlohmann::json said = nlohmann::json::parse(text.get());
  if (said.contains("error")) throw Error(said["error"].get<std::string>());
  *notes = said.at("notes").get<std::vector<std::string>>();
  std::vector<uint8_t> bytes = read_file(glb);
  std::remove(glb.c_str());
  return bytes;
}

}  // namespace sinew
