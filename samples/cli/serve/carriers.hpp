// SPDX-License-Identifier: MIT
// What carries a server's messages: standard input and output, or HTTP on this machine.
#ifndef SINEW_CLI_CARRIERS_HPP
#define SINEW_CLI_CARRIERS_HPP

#include <string>

#include "serve/server.hpp"

namespace sinew::cli {

// A message a line, until the input ends and every job with it.
void serve_lines(Server* server);

// POST /mcp has a message in its body and the answer in its own; until the process is ended.
//   address  "127.0.0.1:8000", "localhost:8000" or "[::1]:8000"; port 0 takes a free one, which a line on standard error tells
// Throws UsageError for another address, Error where the port is taken.
void serve_http(Server* server, const std::string& address);

}  // namespace sinew::cli
#endif
