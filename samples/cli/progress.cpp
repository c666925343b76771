// SPDX-License-Identifier: MIT
// The line that counts.
#include "progress.hpp"

#include <unistd.h>

#include <utility>

namespace sinew::cli {

bool stderr_is_terminal() { return isatty(STDERR_FILENO) != 0; }

Progress::Progress(size_t total, std::string what)
    : total_(total), what_(std::move(what)), shows_(stderr_is_terminal() && total > 1) {
  show();
}

Progress::~Progress() { wipe(); }

void Progress::step() {
  const std::lock_guard<std::mutex> guard(lock_);
  ++done_;
  show();
}

void Progress::say(std::FILE* out, const std::string& line) {
  const std::lock_guard<std::mutex> guard(lock_);
  wipe();
  std::fprintf(out, "%s\n", line.c_str());
  std::fflush(out);
  show();
}

void Progress::show() {
  if (!shows_) return;
  const std::string line = std::to_string(done_) + " of " + std::to_string(total_) + " " + what_;
  std::fprintf(stderr, "\r%s", line.c_str());
  std::fflush(stderr);
  width_ = line.size();
}

void Progress::wipe() {
  if (width_ == 0) return;
  std::fprintf(stderr, "\r%s\r", std::string(width_, ' ').c_str());
  std::fflush(stderr);
  width_ = 0;
}

}  // namespace sinew::cli
