// SPDX-License-Identifier: MIT
// What --help and --help-all print.
#ifndef SINEW_CLI_HELP_HPP
#define SINEW_CLI_HELP_HPP

#include <CLI/CLI.hpp>
#include <string>

namespace sinew::cli {

// --help: one screen. The first sentence of every option that stands under no heading of its own (section()), and of the
// footer what comes before its first empty line. --help-all: everything, of a command with subcommands theirs too.
class HelpText : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace sinew::cli
#endif
