// SPDX-License-Identifier: MIT
// The options --rigid-parts, --softness and --surface-vertices, which bind, rig and eval share.
#ifndef SINEW_CLI_STYLE_OPTIONS_HPP
#define SINEW_CLI_STYLE_OPTIONS_HPP

#include <CLI/CLI.hpp>
#include <string>

#include "sinew_character/bind/bind.hpp"

namespace sinew::cli {

struct StyleOptions {
  uint32_t rigid_parts = SINEW_RIGID_PARTS_AUTO;
  double softness = 1;
  uint32_t surface_vertices = 32768;
};
// Under a heading of their own. `style` must live as long as the subcommand.
void add_style_options(CLI::App* sub, StyleOptions* style);
// Throws UsageError when the method of `options` has no use for the softness.
void apply_style(const StyleOptions& style, BindOptions* options);
// " --rigid-parts always --softness 2", without what is as usual: empty for the defaults.
std::string style_text(const StyleOptions& style);

}  // namespace sinew::cli
#endif
