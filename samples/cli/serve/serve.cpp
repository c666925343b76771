// SPDX-License-Identifier: MIT
// sinew serve: the command as a server for programs and agents, for files of one folder.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "commands.hpp"
#include "options.hpp"
#include "serve/carriers.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct ServeCommandSettings {
  std::string folder = ".", http;
  bool mcp = false;
  double timeout = 600;
  unsigned jobs = 1;
  uint64_t most_bytes = uint64_t{512} << 20;
};

void run_serve(const ServeCommandSettings& s) {
  if (s.mcp == !s.http.empty()) throw UsageError("expected one of --mcp and --http 127.0.0.1:PORT");
  ServerLimits limits;
  limits.seconds = s.timeout;
  limits.jobs = s.jobs;
  Server server(ServedFolder(s.folder, s.most_bytes), limits, run_child);
  if (!can_confine())
    std::fprintf(stderr,
                 "warning: this system cannot keep jobs to a folder (no Landlock): a file that refers to others, such "
                 "as a .gltf, "
                 "may have them read from elsewhere\n");
  if (s.mcp)
    serve_lines(&server);
  else
    serve_http(&server, s.http);
}

}  // namespace

void add_serve(CLI::App& app) {
  CLI::App* sub =
      app.add_subcommand("serve", "Serve programs and agents: Model Context Protocol, or the same over HTTP");
  auto s = std::make_shared<ServeCommandSettings>();
  sub->add_flag("--mcp", s->mcp, "Messages come on standard input, a line each, and answers go to standard output");
  sub->add_option("--http", s->http,
                  "Messages come by POST to /mcp on this machine. Port 0: a free one, which is printed")
      ->type_name("127.0.0.1:PORT");
  sub->add_option("--folder", s->folder,
                  "The folder whose files are read and written, no others. Neither '..' nor a link leads out, and jobs "
                  "run where the "
                  "system lets them see it alone")
      ->type_name("DIR")
      ->capture_default_str();
  sub->add_option("--timeout", s->timeout, "After which a job is ended")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  add_jobs(sub, s->jobs, "Others wait");
  sub->add_option("--most-bytes", s->most_bytes, "Of a file that is read")->type_name("N")->capture_default_str();
  sub->footer(
      "Examples:\n  sinew serve --mcp --folder characters\n"
      "  sinew serve --http 127.0.0.1:8000 --folder characters --jobs 4\n\n"
      "Tools: rig, bind, animate, check, pose, inspect; resources: the folder's files. A job is a process of its own.");
  sub->callback([s] { run_serve(*s); });
}

}  // namespace sinew::cli
