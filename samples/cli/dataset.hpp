// SPDX-License-Identifier: MIT
// One function per subcommand of `sinew-lab dataset` that has a file of its own.
#ifndef SINEW_CLI_DATASET_HPP
#define SINEW_CLI_DATASET_HPP

#include <CLI/CLI.hpp>

namespace sinew::cli {

void add_dataset_check(CLI::App* parent);
void add_dataset_stats(CLI::App* parent);
void add_dataset_dedup(CLI::App* parent);
void add_dataset_split(CLI::App* parent);
void add_dataset_target(CLI::App* parent);
void add_dataset_convert(CLI::App* parent);
void add_dataset_decimate(CLI::App* parent);

}  // namespace sinew::cli
#endif
