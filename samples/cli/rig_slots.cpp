// SPDX-License-Identifier: MIT
// Options of the published method.
#include "rig_slots.hpp"

#include <CLI/CLI.hpp>
#include <string>

#include "options.hpp"
#include "picture_options.hpp"
#include "support.hpp"

namespace sinew::cli {

void add_method_options(CLI::App* sub, MethodOptions* options) {
  shared_word_option(
      sub, "--method", options->method, kCharacterRigMethod,
      "votes: points of the surface vote for bones; shape: joints along the middle line of the mesh, without a "
      "model; auto: votes, or shape where the votes know nothing; for comparison, as published: slots, joints "
      "in fixed slots and a matrix of connections, and regions, boxes around pieces of "
      "the surface, whose contacts are collapsed to a tree");
  word_option(sub, "--class", options->category, kCategory, kClassMeaning)->type_name("KIND");
}

void check_method(const CLI::App& sub, const MethodOptions& options) {
  const auto given = [&](const char* option) { return sub.get_option(option)->count() > 0; };
  if (options.extracts() && given("--class"))
    throw UsageError("--class steers what a model says: leave --method " +
                     kCharacterRigMethod[static_cast<size_t>(options.method)] + " out");
  if (given("--class") && given("--prediction"))
    throw UsageError("--class steers a prediction: leave --prediction out, whose names say what joints are");
  if (!options.slots()) return;
  for (const char* option : {"--mirror", "--spine", "--prediction"})
    if (given(option)) throw UsageError(std::string(option) + " does not go with --method slots");
}

}  // namespace sinew::cli
