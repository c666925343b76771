// SPDX-License-Identifier: MIT
// Corrections of poses on the command line.
#include "deform_options.hpp"

#include <CLI/CLI.hpp>

#include "sinew/published.h"
#include "support.hpp"

namespace sinew::cli {

std::optional<sinew_deform_options> deform_options(const DeformSettings& settings) {
  sinew_deform_options options = sinew_deform_options_init();
  options.cell_count = settings.cells;
  options.round_count = settings.rounds;
  options.body_contact = settings.body_contact ? 1 : 0;
  if (settings.method == "xpbd") options.method = SINEW_DEFORM_XPBD;
  if (settings.method == "delta-mush") options.method = SINEW_DEFORM_DELTA_MUSH;
  if (settings.body_contact && settings.method != "volume") throw UsageError("--body-contact needs --deform volume");
  if (settings.method == "volume" || options.method != SINEW_DEFORM_VOLUME) return options;
  if (settings.cells != 0 || settings.rounds != 0)
    throw UsageError("--cells and --rounds need --deform volume, xpbd or delta-mush");
  return std::nullopt;
}

void add_deform_options(CLI::App* sub, const std::string& what, DeformSettings* settings) {
  sub->add_option("--deform", settings->method, what)->check(CLI::IsMember({"volume", "xpbd", "delta-mush"}));
  add_solver_options(sub, settings);
}

void add_solver_options(CLI::App* sub, DeformSettings* settings) {
  sub->add_option("--cells", settings->cells, "Cells of the lattice along the longest side, for volume and xpbd [32]")
      ->check(CLI::Range(8u, SINEW_MAX_DEFORM_CELLS));
  sub->add_option("--rounds", settings->rounds,
                  "Rounds of the solver or, for delta-mush, of smoothing [20, delta-mush 5]")
      ->check(CLI::Range(1u, SINEW_MAX_DEFORM_ROUNDS));
  sub->add_flag("--body-contact", settings->body_contact,
                "Keep an arm out of the torso, a thigh out of the belly and the other thigh too, for volume");
}

}  // namespace sinew::cli
