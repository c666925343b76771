// SPDX-License-Identifier: MIT
// What the files of `sinew dataset` share: lists of inputs, and one function per subcommand that has a file of its own.
#ifndef SINEW_CLI_DATASET_HPP
#define SINEW_CLI_DATASET_HPP

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"
#include "support.hpp"

namespace sinew::cli {

// Files as they are; a folder stands for its characters and those of the folders below it. Throws Error for a folder
// without any.
std::vector<FoundCharacter> expand(const std::vector<std::string>& inputs);
// A bare mesh is a character without joints.
Character read_any(const std::string& path);
// With those above it.
void make_folder(const std::string& path);

void add_dataset_check(CLI::App* parent);
void add_dataset_stats(CLI::App* parent);
void add_dataset_dedup(CLI::App* parent);
void add_dataset_split(CLI::App* parent);
void add_dataset_target(CLI::App* parent);
void add_dataset_convert(CLI::App* parent);
void add_dataset_decimate(CLI::App* parent);

}  // namespace sinew::cli
#endif
