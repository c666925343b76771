// SPDX-License-Identifier: MIT
// One function per subcommand: declares its options and says what runs when it is chosen.
#ifndef SINEW_CLI_COMMANDS_HPP
#define SINEW_CLI_COMMANDS_HPP

namespace CLI {
class App;
}

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

}  // namespace sinew::cli
#endif
