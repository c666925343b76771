// SPDX-License-Identifier: MIT
// How the style options look on the command line and what they mean to the engine.
#include "style_options.hpp"

#include <cmath>

#include "options.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {

void add_style_options(CLI::App* sub, StyleOptions* style) {
  section(sub, "Style");
  word_option(sub, "--rigid-parts", style->rigid_parts, kRigidParts,
              "Whether connected parts move with one joint each. always: toys, robots, armour; never: no part does "
              "unless the heat field says so; auto: the model decides")
      ->type_name("WHEN");
  sub->add_option("--softness", style->softness,
                  "How softly weights blend between joints: 2 twice as softly, 0.5 harder")
      ->type_name("X")
      ->check(CLI::Range(0.25, 4.0))
      ->capture_default_str();
  sub->add_option("--surface-vertices", style->surface_vertices,
                  "A mesh of more vertices is bound on a surface reduced to so many. Its weights are interpolated: "
                  "faster, in less memory")
      ->check(CLI::Range(16, static_cast<int>(SINEW_MAX_VERTICES)))
      ->capture_default_str()
      ->type_name("N");
}

void apply_style(const StyleOptions& style, BindOptions* options) {
  if (options->method != SINEW_METHOD_MODEL && style.softness != 1)
    throw UsageError("--softness is for the model's weights: leave it out with --method heat or distance");
  options->rigid_parts = style.rigid_parts;
  options->surface_vertices = style.surface_vertices;
  options->softness_percent = static_cast<uint32_t>(std::lround(style.softness * 100));
}

std::string style_text(const StyleOptions& style) {
  const StyleOptions usual;
  std::string text;
  if (style.rigid_parts != usual.rigid_parts) text += " --rigid-parts " + kRigidParts[style.rigid_parts];
  if (style.softness != usual.softness) text += print(" --softness %g", style.softness);
  if (style.surface_vertices != usual.surface_vertices) text += print(" --surface-vertices %u", style.surface_vertices);
  return text;
}

}  // namespace sinew::cli
