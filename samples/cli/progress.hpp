// SPDX-License-Identifier: MIT
// A line on stderr that counts while work goes on, only where stderr is a terminal.
#ifndef SINEW_CLI_PROGRESS_HPP
#define SINEW_CLI_PROGRESS_HPP

#include <cstddef>
#include <cstdio>
#include <mutex>
#include <string>

namespace sinew::cli {

bool stderr_is_terminal();

// "3 of 20 characters"; gone when the object is. Any thread may call.
class Progress {
 public:
  Progress(size_t total, std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step();  // one more is done
  // A whole line of output, above the line that counts.
  void say(std::FILE* out, const std::string& line);

 private:
  void show();
  void wipe();

  const size_t total_;
  const std::string what_;
  const bool shows_;
  std::mutex lock_;
  size_t done_ = 0, width_ = 0;  // characters on the terminal
};

}  // namespace sinew::cli
#endif
