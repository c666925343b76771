// SPDX-License-Identifier: MIT
// One function per subcommand: declares its options and says what runs when it is chosen. How help texts look.
#ifndef SINEW_CLI_COMMANDS_HPP
#define SINEW_CLI_COMMANDS_HPP

#include <memory>

namespace CLI {
class App;
class FormatterBase;
}  // namespace CLI

namespace sinew::cli {

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
void add_map(CLI::App& app);
void add_animate(CLI::App& app);
void add_bake(CLI::App& app);
void add_transfer(CLI::App& app);
void add_check(CLI::App& app);
void add_serve(CLI::App& app);

// --help: one screen. The first sentence of every option that stands under no heading of its own (section()), and of the
// footer what comes before its first empty line. --help-all: everything, of a command with subcommands theirs too.
std::shared_ptr<CLI::FormatterBase> help_text();

}  // namespace sinew::cli
#endif
