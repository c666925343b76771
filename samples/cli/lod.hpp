// SPDX-License-Identifier: MIT
#ifndef SINEW_CLI_LOD_HPP
#define SINEW_CLI_LOD_HPP
namespace CLI {
class App;
}
namespace sinew::cli {
void add_lod(CLI::App& app);
}
#endif
