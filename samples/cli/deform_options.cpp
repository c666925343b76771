// SPDX-License-Identifier: MIT
// Corrections of poses on the command line.
#include "deform_options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>

#include "options.hpp"
#include "sinew/published.h"
#include "support.hpp"

namespace sinew::cli {

std::optional<sinew_deform_options> deform_options(const DeformSettings& settings) {
  sinew_deform_options options = SINEW_INIT(sinew_deform_options);
  options.cell_count = settings.cells;
  options.round_count = settings.rounds;
  options.body_contact = settings.body_contact ? 1 : 0;
  if (settings.method == "xpbd") options.method = SINEW_DEFORM_XPBD;
  if (settings.method == "delta-mush") options.method = SINEW_DEFORM_DELTA_MUSH;
  const bool xpbd = options.method == SINEW_DEFORM_XPBD;
  if (settings.body_contact && settings.method != "volume" && !xpbd)
    throw UsageError("--body-contact needs --deform volume or xpbd");
  if (!xpbd && (settings.no_smoothing || settings.stiffness != 0 || settings.tet_weights != SINEW_TET_WEIGHTS_SKIN))
    throw UsageError("--no-smoothing, --stiffness and --tet-weights need --deform xpbd");
  if (settings.no_smoothing) options.without = SINEW_WITHOUT_SMOOTHING;
  options.energy = static_cast<uint32_t>(std::lround(1000 * settings.stiffness));
  options.tet_weights = settings.tet_weights;
  if (settings.method == "volume" || options.method != SINEW_DEFORM_VOLUME) return options;
  if (settings.cells != 0 || settings.rounds != 0)
    throw UsageError("--cells and --rounds need --deform volume, xpbd or delta-mush");
  return std::nullopt;
}

void add_deform_options(CLI::App* sub, const std::vector<std::string>& methods, const std::string& what,
                        DeformSettings* settings) {
  shared_option(sub, "--deform", settings->method,
                what +
                    "volume: bends keep their volume and do not pass through themselves; xpbd: the published "
                    "correction by position-based dynamics; delta-mush: smoothed, with the details of the rest shape")
      ->check(CLI::IsMember(methods));
}

void add_solver_options(CLI::App* sub, DeformSettings* settings) {
  section(sub, "Corrections");
  shared_option(sub, "--cells", settings->cells)->check(CLI::Range(8u, SINEW_MAX_DEFORM_CELLS))->default_str("32");
  shared_option(sub, "--rounds", settings->rounds)
      ->check(CLI::Range(1u, SINEW_MAX_DEFORM_ROUNDS))
      ->default_str("20, xpbd 60, delta-mush 5");
  shared_flag(sub, "--body-contact", settings->body_contact,
              "An arm keeps out of the torso, a thigh out of the belly and the other thigh");
  shared_option(sub, "--stiffness", settings->stiffness)
      ->check(CLI::Range(0.001, SINEW_MAX_DEFORM_ENERGY / 1000.0))
      ->default_str("0.2");
  shared_word_option(sub, "--tet-weights", settings->tet_weights, kTetWeights, "");
  shared_flag(sub, "--no-smoothing", settings->no_smoothing);
}

}  // namespace sinew::cli
