// SPDX-License-Identifier: MIT
// FBX and COLLADA to the GLB that the command makes of them, from and to files of the module. src/scenes.js calls it.
#include <emscripten.h>

#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gltf/gltf_from_scene.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace {

std::string reply;

}  // namespace

// Writes the GLB of the scene. Returns {notes: [one line each]} or {error: one line} as JSON, valid until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* scenes_convert(const char* scene, const char* glb) {
  nlohmann::json said;
  try {
    std::vector<std::string> notes;
    const std::vector<uint8_t> bytes = sinew::scene_to_glb(scene, &notes);
    sinew::write_file(glb, bytes);
    said["notes"] = notes;
  } catch (const std::bad_alloc&) {
    said["error"] =
        std::string(scene) + ": out of memory: the file is too large for WebAssembly; try the sinew command";
  } catch (const std::exception& error) {
    said["error"] = error.what();
  }
  reply = said.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return reply.c_str();
}
