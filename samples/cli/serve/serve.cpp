// SPDX-License-Identifier: MIT
// sinew serve: the Model Context Protocol on standard input and output, for files of one folder.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "commands.hpp"
#include "options.hpp"
#include "serve/server.hpp"

namespace sinew::cli {
namespace {

struct ServeCommandSettings {
  std::string folder = ".";
  bool mcp = false;
  double timeout = 600;
  unsigned jobs = 1;
  uint64_t most_bytes = uint64_t{512} << 20;
};

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

// Answers a message a line, until the input ends and every job with it.
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

void run_serve(const ServeCommandSettings& s) {
  ServerLimits limits;
  limits.seconds = s.timeout;
  limits.jobs = s.jobs;
  Server server(ServedFolder(s.folder, s.most_bytes), limits, run_child);
  if (!can_confine())
    std::fprintf(stderr,
                 "warning: this system cannot confine jobs to a folder (no Landlock), so a file that refers to others, "
                 "such as a .gltf, may read files elsewhere; serve only trusted files\n");
  serve_lines(&server);
}

}  // namespace

void add_serve(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("serve", "Serve programs over the Model Context Protocol");
  auto s = std::make_shared<ServeCommandSettings>();
  sub->add_flag("--mcp", s->mcp, "Messages on standard input, one line each, and answers on standard output")
      ->required();
  sub->add_option("--folder", s->folder,
                  "The only folder that is read and written. Neither '..' nor a link leads out of it, and the system "
                  "confines jobs to it where it can")
      ->type_name("DIR")
      ->capture_default_str();
  sub->add_option("--timeout", s->timeout, "Time limit of a job")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  add_jobs(sub, s->jobs, "Number of parallel jobs; more wait");
  sub->add_option("--most-bytes", s->most_bytes, "Largest file that is read")->type_name("N")->capture_default_str();
  sub->footer(
      "Example:\n  sinew serve --mcp --folder characters --jobs 4\n\nTools: rig, bind, animate, check, pose, inspect; "
      "resources: the folder's files. Each job is a separate process.");
  sub->callback([s] { run_serve(*s); });
}

}  // namespace sinew::cli
