// SPDX-License-Identifier: MIT
#include "serve/child.hpp"

#include "sinew_formats/error.hpp"

#ifdef _WIN32

namespace sinew::cli {

bool can_confine() { return false; }

ChildResult run_child(const std::vector<std::string>&, const std::string&, double, const std::atomic<bool>&,
                      const std::function<void(const std::string&)>&) {
  throw Error("sinew serve does not run on Windows; call the command for each file");
}

}  // namespace sinew::cli

#else

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>

#ifdef __linux__
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

namespace sinew::cli {
namespace {

#if defined(__linux__) && defined(SYS_landlock_create_ruleset)

constexpr uint64_t kRead = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr uint64_t kAll = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;  // of the first version

int new_ruleset() {
  landlock_ruleset_attr attributes = {};
  attributes.handled_access_fs = kAll;
  return static_cast<int>(syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0));
}

void allow(int rules, const char* path, uint64_t access) {
  const int folder = open(path, O_PATH | O_CLOEXEC);
  if (folder < 0) return;
  landlock_path_beneath_attr attributes = {};
  attributes.allowed_access = access;
  attributes.parent_fd = folder;
  (void)syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &attributes, 0);
  close(folder);
}

// Between fork() and exec(): system calls alone.
bool confine(const char* folder, const char* program_folder) {
  const int rules = new_ruleset();
  if (rules < 0) return errno == ENOSYS || errno == EOPNOTSUPP;
  for (const char* system : {"/usr", "/lib", "/lib64", "/etc", "/proc/self", "/dev"}) allow(rules, system, kRead);
  allow(rules, program_folder, kRead);
  allow(rules, folder, kAll);
  const bool done = prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && syscall(SYS_landlock_restrict_self, rules, 0) == 0;
  close(rules);
  return done;
}

// A job is nothing to anybody once its server is gone.
void end_with_parent() { (void)prctl(PR_SET_PDEATHSIG, SIGKILL); }

#else

void end_with_parent() {}
int new_ruleset() { return -1; }
bool confine(const char*, const char*) { return true; }

#endif

std::string this_program() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "sinew" : program.string();
}

// A pipe, closed with it.
struct Pipe {
  int ends[2] = {-1, -1};
  Pipe() {
    if (pipe(ends) != 0) throw Error(std::string("sinew serve: cannot create a pipe: ") + std::strerror(errno));
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  }
  ~Pipe() {
    for (int& end : ends) shut(&end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  static void shut(int* end) {
    if (*end >= 0) close(*end);
    *end = -1;
  }
};

class Child {
 public:
  Child(const std::vector<std::string>& words, const std::string& folder) {
    const std::string program = this_program();
    const std::string program_folder = std::filesystem::path(program).parent_path().string();
    std::vector<char*> arguments = {const_cast<char*>("sinew")};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    process_ = fork();
    if (process_ < 0) throw Error(std::string("sinew serve: cannot start a process: ") + std::strerror(errno));
    if (process_ == 0) {
      end_with_parent();
      const int nothing = open("/dev/null", O_RDONLY);
      if (nothing < 0 || dup2(nothing, 0) < 0 || dup2(out_.ends[1], 1) < 0 || dup2(errors_.ends[1], 2) < 0 ||
          chdir(folder.c_str()) != 0 || !confine(folder.c_str(), program_folder.c_str()))
        _exit(126);
      execvp(program.c_str(), arguments.data());
      _exit(127);
    }
    Pipe::shut(&out_.ends[1]);
    Pipe::shut(&errors_.ends[1]);
  }

  ~Child() {
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Until it has closed its outputs, or what the caller says.
  template <class Stop>
  ChildEnd read(ChildResult* result, const std::function<void(const std::string&)>& on_line, const Stop& stop) {
    size_t told = 0;
    while (out_.ends[0] >= 0 || errors_.ends[0] >= 0) {
      if (const ChildEnd end = stop(); end != ChildEnd::kDone) return end;
      std::array<pollfd, 2> both = {pollfd{out_.ends[0], POLLIN, 0}, pollfd{errors_.ends[0], POLLIN, 0}};
      if (poll(both.data(), both.size(), 50) < 0 && errno != EINTR) break;
      if (both[0].revents != 0) take(&out_.ends[0], &result->out);
      if (both[1].revents != 0) take(&errors_.ends[0], &result->errors);
      for (size_t end; (end = result->errors.find('\n', told)) != std::string::npos; told = end + 1)
        on_line(result->errors.substr(told, end - told));
      if (result->out.size() + result->errors.size() > kMostOutput) return ChildEnd::kTooLong;
    }
    return ChildEnd::kDone;
  }

  int wait() {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  static void take(int* from, std::string* to) {
    char bytes[65536];
    const ssize_t count = ::read(*from, bytes, sizeof bytes);
    if (count > 0)
      to->append(bytes, static_cast<size_t>(count));
    else if (count == 0 || (errno != EINTR && errno != EAGAIN))
      Pipe::shut(from);
  }

  Pipe out_, errors_;
  pid_t process_ = -1;
};

}  // namespace

bool can_confine() {
  const int rules = new_ruleset();
  if (rules >= 0) close(rules);
  return rules >= 0;
}

ChildResult run_child(const std::vector<std::string>& words, const std::string& folder, double seconds,
                      const std::atomic<bool>& cancel, const std::function<void(const std::string&)>& on_line) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  ChildResult result;
  Child child(words, folder);
  result.end = child.read(&result, on_line, [&] {
    if (cancel) return ChildEnd::kCancelled;
    return std::chrono::duration<double>(Clock::now() - begin).count() > seconds ? ChildEnd::kTooLate : ChildEnd::kDone;
  });
  if (result.end == ChildEnd::kDone) result.status = child.wait();
  return result;
}

}  // namespace sinew::cli

#endif
