// SPDX-License-Identifier: MIT
// A program of subcommands: reads the command line, runs one of them, turns every failure into one line and an exit status.
#ifndef SINEW_CLI_PROGRAM_HPP
#define SINEW_CLI_PROGRAM_HPP

#include <exception>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sinew::cli {

struct Command {
  const char* name;
  void (*add)(CLI::App&);  // declares its options and says what runs when it is chosen
};

struct Program {
  std::string name, description, footer;
  std::vector<Command> commands;
  // The words of the command line as CLI11 is to read them; null: as they are.
  std::vector<std::string> (*read_words)(const CLI::App&, std::vector<std::string>) = nullptr;
  // True where another process of the same run reports this failure; null: none does.
  bool (*is_reported_elsewhere)(const std::vector<std::string>& words, const std::exception&) = nullptr;
};

// Exit status: 0 done, 1 the job failed, 2 wrong usage, 3 done, but --gate found it wanting.
int run_program(const Program& program, int argc, char** argv);

}  // namespace sinew::cli
#endif
