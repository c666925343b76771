// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "serve/carriers.hpp"

namespace sinew::cli {
namespace {

// Whole lines, whatever threads they come from.
class Output {
 public:
  void write(const OrderedJson& message) {
    const std::string line = message.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
    const std::lock_guard<std::mutex> guard(lock_);
    std::fwrite(line.data(), 1, line.size(), stdout);
    std::fflush(stdout);
  }

 private:
  std::mutex lock_;
};

// The next line without its end; of a longer one than `most` the first bytes beyond it, which is enough to refuse it.
bool read_line(size_t most, std::string* line) {
  line->clear();
  int c = 0;
  while ((c = std::getc(stdin)) != EOF && c != '\n')
    if (line->size() <= most) line->push_back(static_cast<char>(c));
  if (!line->empty() && line->back() == '\r') line->pop_back();
  return c != EOF || !line->empty();
}

}  // namespace

void serve_lines(Server* server) {
  Output output;
  std::vector<std::jthread> calls;
  std::string line;
  const auto answer = [server, &output](const std::string& message) {
    const auto reply = server->answer(message, [&](const OrderedJson& note) { output.write(note); });
    if (reply) output.write(*reply);
  };
  while (read_line(server->limits().message, &line)) {
    if (line.find_first_not_of(" \t") == std::string::npos) continue;
    if (Server::is_call(line) && line.size() <= server->limits().message)
      calls.emplace_back([answer, message = line] { answer(message); });
    else
      answer(line);
  }
}

}  // namespace sinew::cli
