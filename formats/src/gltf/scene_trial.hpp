// SPDX-License-Identifier: MIT
// What Assimp's readers of rarer formats do to the process that calls them, kept away from it.
#ifndef SINEW_FORMATS_GLTF_SCENE_TRIAL_HPP
#define SINEW_FORMATS_GLTF_SCENE_TRIAL_HPP

#include <assimp/postprocess.h>

#include <assimp/Importer.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <string>

#include "gltf/scene_files.hpp"

#if defined(__unix__) && !defined(__EMSCRIPTEN__)
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace sinew {

// Assimp 5.2 prints a line to standard output for every skeleton of OGRE's XML. While this lives, what is printed is kept;
// then all but that line goes where it was meant to.
class KeptOutput {
 public:
  explicit KeptOutput(bool wanted) : lock_(one_, std::defer_lock) {
    if (!wanted) return;
    lock_.lock();
    std::fflush(stdout);
    kept_ = std::tmpfile();
    before_ = kept_ == nullptr ? -1 : dup(STDOUT_FILENO);
    if (before_ >= 0) (void)dup2(fileno(kept_), STDOUT_FILENO);
  }
  ~KeptOutput() {
    if (before_ >= 0) {
      std::fflush(stdout);
      (void)dup2(before_, STDOUT_FILENO);
      (void)close(before_);
      std::string text;
      std::rewind(kept_);
      for (int c = std::fgetc(kept_); c != EOF; c = std::fgetc(kept_)) text += static_cast<char>(c);
      const std::string noise = "\nSkeleton is not a valid root: \n";
      for (size_t at = text.find(noise); at != std::string::npos; at = text.find(noise)) text.erase(at, noise.size());
      (void)std::fwrite(text.data(), 1, text.size(), stdout);
    }
    if (kept_ != nullptr) (void)std::fclose(kept_);
  }
  KeptOutput(const KeptOutput&) = delete;
  KeptOutput& operator=(const KeptOutput&) = delete;

 private:
  static inline std::mutex one_;
  std::unique_lock<std::mutex> lock_;
  std::FILE* kept_ = nullptr;
  int before_ = -1;
};

// Assimp 5.2 crashes or hangs on broken files of some formats (MD5, SMD): a process of its own tries first.
inline bool survives(const std::string& path, size_t bytes) {
  const rlim_t seconds = 3 + bytes / 200000;  // of the processor; no whole file takes so long
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) return true;  // no more processes: it is read without a trial
  if (child == 0) {
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU}) (void)std::signal(signal, SIG_DFL);
    const rlimit no_core = {0, 0};
    (void)setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = open("/dev/null", O_WRONLY);
    (void)dup2(nowhere, STDOUT_FILENO);
    (void)dup2(nowhere, STDERR_FILENO);
    const rlimit time = {seconds, seconds};
    (void)setrlimit(RLIMIT_CPU, &time);
    try {
      Assimp::Importer importer;
      importer.SetIOHandler(new SceneFiles);
      (void)importer.ReadFile(path, aiProcess_Triangulate);
    } catch (...) {  // told by the reading that follows
    }
    _exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace sinew

#else  // a page's module has neither processes nor these formats

namespace sinew {

struct KeptOutput {
  explicit KeptOutput(bool) {}
};
inline bool survives(const std::string&, size_t) { return true; }

}  // namespace sinew

#endif
#endif
