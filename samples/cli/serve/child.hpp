// SPDX-License-Identifier: MIT
// The command as a process of its own, which may read and write in one folder alone.
#ifndef SINEW_CLI_CHILD_HPP
#define SINEW_CLI_CHILD_HPP

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace sinew::cli {

enum class ChildEnd { kDone, kTooLate, kCancelled, kTooLong };

struct ChildResult {
  ChildEnd end = ChildEnd::kDone;
  int status = 0;           // exit status; 128 and the signal where one ended it
  std::string out, errors;  // standard output and standard error, together at most kMostOutput
};

// Bytes of output after which a process is ended.
constexpr size_t kMostOutput = size_t{64} << 20;

// Whether this system keeps a process to a folder whatever a file of it refers to (Landlock of Linux).
bool can_confine();

// Runs this very program with `words` in `folder`.
//   seconds  after which it is ended
//   cancel   ends it when set
//   on_line  receives each line of standard error immediately
// Throws Error where no process can be made.
ChildResult run_child(const std::vector<std::string>& words, const std::string& folder, double seconds,
                      const std::atomic<bool>& cancel, const std::function<void(const std::string&)>& on_line);

}  // namespace sinew::cli
#endif
