// SPDX-License-Identifier: MIT
// A process of its own for a reader that is not ours, with limits of memory and time.
#ifndef SINEW_FORMATS_GLTF_SCENE_PROCESS_HPP
#define SINEW_FORMATS_GLTF_SCENE_PROCESS_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace sinew {

struct SceneBytes {
  std::vector<uint8_t> glb;
  std::vector<std::string> notes;
};

struct SceneLimits {
  size_t memory_bytes;   // beyond what the calling process has
  size_t cpu_seconds;    // of the processor
  size_t whole_seconds;  // by the clock, for a child that waits for what never comes
};

// Far more than any whole file of so many bytes takes.
SceneLimits scene_limits(size_t file_bytes);

// What `convert` returns or throws, worked out by a child process: broken files make Assimp 5.2 crash, loop or ask for memory without end, and some of
// its readers print to standard output. Throws Error naming `path` where the child dies or reaches a limit. Systems without fork(), which are
// Windows and WebAssembly, call `convert` in place and know no limits. The limit of memory holds where the system has it: on Linux, not on macOS.
//   kind  of the file, for the user
SceneBytes convert_in_child(const std::string& path, const std::string& kind, const SceneLimits& limits,
                            const std::function<SceneBytes()>& convert);

}  // namespace sinew
#endif
