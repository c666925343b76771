// SPDX-License-Identifier: MIT
// The subcommands: one function each, which declares its options and its callback; the program that runs them, and
// the layout of help texts.
#ifndef SINEW_CLI_COMMANDS_HPP
#define SINEW_CLI_COMMANDS_HPP

#include <array>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class FormatterBase;
}  // namespace CLI

namespace sinew::cli {

struct Command {
  const char* name;
  void (*add)(CLI::App&);  // declares its options and its callback
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

// The commands of sinew-lab; those of sinew are in main.cpp.
inline constexpr std::array<std::string_view, 5> kLabCommands = {"train", "crossval", "quantize", "dataset", "eval"};
inline bool is_lab_command(std::string_view word) {
  for (const std::string_view command : kLabCommands)
    if (word == command) return true;
  return false;
}

void add_bind(CLI::App& app);
void add_eval(CLI::App& app);
void add_train(CLI::App& app);
void add_crossval(CLI::App& app);
void add_quantize(CLI::App& app);
void add_dataset(CLI::App& app);
void add_inspect(CLI::App& app);
void add_pose(CLI::App& app);
void add_rig(CLI::App& app);
void add_simplify(CLI::App& app);
void add_lod(CLI::App& app);
void add_springs(CLI::App& app);
void add_map(CLI::App& app);
void add_animate(CLI::App& app);
void add_bake(CLI::App& app);
void add_transfer(CLI::App& app);
void add_check(CLI::App& app);
void add_serve(CLI::App& app);

// --help: one screen. The first sentence of every option that stands under no heading of its own (section()), and of the
// footer what comes before its first empty line. --help-all: everything, of a command with subcommands theirs too.
std::shared_ptr<CLI::FormatterBase> help_text();

void add_dataset_check(CLI::App* parent);
void add_dataset_stats(CLI::App* parent);
void add_dataset_dedup(CLI::App* parent);
void add_dataset_split(CLI::App* parent);
void add_dataset_target(CLI::App* parent);
void add_dataset_convert(CLI::App* parent);
void add_dataset_decimate(CLI::App* parent);

}  // namespace sinew::cli
#endif
