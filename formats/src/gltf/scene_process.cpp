// SPDX-License-Identifier: MIT
#include "gltf/scene_process.hpp"

#include "sinew_formats/error.hpp"

#ifdef __APPLE__
#include <TargetConditionals.h>
#endif
#if (defined(__unix__) && !defined(__EMSCRIPTEN__)) || (defined(__APPLE__) && TARGET_OS_OSX)
#define SINEW_HAS_FORK
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#endif

namespace sinew {

SceneLimits scene_limits(size_t file_bytes) {
  const size_t seconds = 1 + file_bytes / 100000;
  return {(size_t{512} << 20) + 64 * file_bytes, seconds, 30 + 10 * seconds};
}

#ifdef SINEW_HAS_FORK

namespace {

// Bytes of address space that this process has; 0 where the system does not say.
size_t own_size() {
  std::FILE* const file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr) return 0;
  unsigned long long pages = 0;
  const bool read = std::fscanf(file, "%llu", &pages) == 1;
  (void)std::fclose(file);
  return read ? static_cast<size_t>(pages) * static_cast<size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void set_limit(int what, size_t soft, size_t hard) {
  const rlimit limit = {static_cast<rlim_t>(soft), static_cast<rlim_t>(hard)};
  (void)setrlimit(what, &limit);
}

// Quiet, and within the limits.
void enter_child(const SceneLimits& limits) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGPIPE})
    (void)std::signal(signal, SIG_DFL);
  const int nowhere = open("/dev/null", O_WRONLY);
  (void)dup2(nowhere, STDOUT_FILENO);
  (void)dup2(nowhere, STDERR_FILENO);
  set_limit(RLIMIT_CORE, 0, 0);
  set_limit(RLIMIT_CPU, limits.cpu_seconds, limits.cpu_seconds + 1);
  if (const size_t own = own_size(); own != 0)
    set_limit(RLIMIT_AS, own + limits.memory_bytes, own + limits.memory_bytes);
}

// A message to the parent: texts that end with a 0, first "ok" or the error's line, then the number of notes and these; then the bytes.
std::string message_of(const std::function<SceneBytes()>& convert) {
  std::string message;
  try {
    const SceneBytes scene = convert();
    message = "ok";
    message += '\0';
    message += std::to_string(scene.notes.size());
    message += '\0';
    for (const std::string& note : scene.notes) (message += note) += '\0';
    message.append(scene.glb.begin(), scene.glb.end());
  } catch (const std::exception& error) {
    message = error.what();
    message += '\0';
  }
  return message;
}

SceneBytes scene_of(const std::string& message) {
  size_t at = 0;
  const auto text = [&] {
    const size_t end = message.find('\0', at);
    std::string out = message.substr(at, end - at);
    at = end + 1;
    return out;
  };
  const std::string first = text();
  if (first != "ok") throw Error(first);
  SceneBytes scene;
  scene.notes.resize(std::stoul(text()));
  for (std::string& note : scene.notes) note = text();
  scene.glb.assign(message.begin() + static_cast<std::ptrdiff_t>(at), message.end());
  return scene;
}

bool write_all(int end, const std::string& message) {
  for (size_t at = 0; at < message.size();) {
    const ssize_t count = write(end, message.data() + at, message.size() - at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    at += static_cast<size_t>(count);
  }
  return true;
}

// All that comes before the deadline; a child that is late is killed.
std::string read_all(int end, pid_t child, size_t seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + std::chrono::seconds(seconds);
  std::string message;
  std::vector<char> block(1 << 16);
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd waiting = {end, POLLIN, 0};
    const int ready = left > 0 ? poll(&waiting, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) {
      (void)kill(child, SIGKILL);
      return message;
    }
    const ssize_t count = read(end, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return message;
    message.append(block.data(), static_cast<size_t>(count));
  }
}

std::string why_dead(int status, const SceneLimits& limits) {
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU)
    return "Assimp does not finish reading, stopped after " + std::to_string(limits.cpu_seconds) + " s";
  return signal == SIGKILL ? "Assimp does not finish reading, stopped" : "Assimp crashes on";
}

}  // namespace

SceneBytes convert_in_child(const std::string& path, const std::string& kind, const SceneLimits& limits,
                            const std::function<SceneBytes()>& convert) {
  int ends[2] = {-1, -1};
  if (pipe(ends) != 0)
    throw Error(path + ": cannot read, the system has no free pipe; close other files and try again");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    (void)close(ends[0]);
    enter_child(limits);
    _exit(write_all(ends[1], message_of(convert)) ? 0 : 1);
  }
  (void)close(ends[1]);
  if (child < 0) {
    (void)close(ends[0]);
    throw Error(path + ": cannot read, the system cannot start a process; end others and try again");
  }
  const std::string message = read_all(ends[0], child, limits.whole_seconds);
  (void)close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || message.empty())
    throw Error(path + ": expected " + kind + ", found a file that " + why_dead(status, limits) + "; export it again");
  return scene_of(message);
}

#else

SceneBytes convert_in_child(const std::string&, const std::string&, const SceneLimits&,
                            const std::function<SceneBytes()>& convert) {
  return convert();
}

#endif

}  // namespace sinew
