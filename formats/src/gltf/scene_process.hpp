// SPDX-License-Identifier: MIT
// Assimp in its place: files of its own, and a process of its own for readers of rarer formats.
#ifndef SINEW_FORMATS_GLTF_SCENE_PROCESS_HPP
#define SINEW_FORMATS_GLTF_SCENE_PROCESS_HPP

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"

#if defined(__unix__) && !defined(__EMSCRIPTEN__)
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#endif

namespace sinew {

// What Assimp's readers of rarer formats do to the process that calls them, kept away from it: 5.2 crashes or hangs on broken files
// of some (MD5, SMD), and prints to standard output for others (OGRE's XML).
struct SceneBytes {
  std::vector<uint8_t> glb;
  std::vector<std::string> notes;
};

#if defined(__unix__) && !defined(__EMSCRIPTEN__)

// What `convert` returns or throws, worked out by a child process. Throws Error where the child dies, or works longer than any
// whole file of so many bytes takes.
inline SceneBytes convert_in_child(const std::string& path, const std::string& kind, size_t bytes,
                                   const std::function<SceneBytes()>& convert) {
  int ends[2] = {-1, -1};
  if (pipe(ends) != 0) return convert();
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) {  // no more processes
    (void)close(ends[0]);
    (void)close(ends[1]);
    return convert();
  }
  if (child == 0) {
    (void)close(ends[0]);
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGPIPE})
      (void)std::signal(signal, SIG_DFL);
    const rlimit no_core = {0, 0};
    (void)setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = open("/dev/null", O_WRONLY);
    (void)dup2(nowhere, STDOUT_FILENO);
    (void)dup2(nowhere, STDERR_FILENO);
    const rlim_t seconds = 1 + bytes / 100000;  // of the processor
    const rlimit time = {seconds, seconds};
    (void)setrlimit(RLIMIT_CPU, &time);
    // Texts end with a 0. First "ok" or the error's line, then the number of notes and these, then the bytes.
    std::string told;
    SceneBytes scene;
    try {
      scene = convert();
      told = "ok";
      told += '\0';
      told += std::to_string(scene.notes.size());
      told += '\0';
      for (const std::string& note : scene.notes) (told += note) += '\0';
    } catch (const std::exception& error) {
      told = error.what();
      told += '\0';
    }
    told.append(scene.glb.begin(), scene.glb.end());
    for (size_t at = 0; at < told.size();) {
      const ssize_t count = write(ends[1], told.data() + at, told.size() - at);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) _exit(1);
      at += static_cast<size_t>(count);
    }
    _exit(0);
  }
  (void)close(ends[1]);
  std::string told;
  std::vector<char> block(1 << 16);
  for (;;) {
    const ssize_t count = read(ends[0], block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    told.append(block.data(), static_cast<size_t>(count));
  }
  (void)close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || told.empty())
    throw Error(path + ": expected " + kind + ", found a file that Assimp does not survive");
  size_t at = 0;
  const auto text = [&] {
    const size_t end = told.find('\0', at);
    std::string out = told.substr(at, end - at);
    at = end + 1;
    return out;
  };
  const std::string first = text();
  if (first != "ok") throw Error(first);
  SceneBytes scene;
  scene.notes.resize(std::stoul(text()));
  for (std::string& note : scene.notes) note = text();
  scene.glb.assign(told.begin() + static_cast<std::ptrdiff_t>(at), told.end());
  return scene;
}

#else  // a page's module has neither processes nor these formats

inline SceneBytes convert_in_child(const std::string&, const std::string&, size_t,
                                   const std::function<SceneBytes()>& convert) {
  return convert();
}

#endif

// Assimp's files: bytes that formats reads, from the disk or from memory.
class SceneFile : public Assimp::IOStream {
 public:
  explicit SceneFile(std::vector<uint8_t> bytes) : bytes_(std::move(bytes)) {}
  size_t Read(void* out, size_t size, size_t count) override {
    if (size == 0) return 0;
    const size_t whole = std::min(count, (bytes_.size() - at_) / size);
    if (whole != 0) std::memcpy(out, bytes_.data() + at_, whole * size);
    at_ += whole * size;
    return whole;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    const size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
    if (offset > bytes_.size() || from > bytes_.size() - offset) return aiReturn_FAILURE;
    at_ = from + offset;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return at_; }
  size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::vector<uint8_t> bytes_;
  size_t at_ = 0;
};

class SceneFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char* path) const override { return is_file(path); }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (std::strchr(mode, 'r') == nullptr || !is_file(path)) return nullptr;
    try {
      return new SceneFile(read_file(path));
    } catch (const Error&) {
      return nullptr;
    }
  }
  void Close(Assimp::IOStream* file) override { delete file; }
};

}  // namespace sinew
#endif
