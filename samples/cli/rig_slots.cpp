// SPDX-License-Identifier: MIT
// Options of the published method and its checkpoint.
#include "rig_slots.hpp"

#include <CLI/CLI.hpp>

#include "options.hpp"
#include "support.hpp"

namespace sinew::cli {

void add_method_options(CLI::App* sub, MethodOptions* options) {
  shared_option(
      sub, "--method", options->method,
      "votes: points of the surface vote for bones; shape: joints along the middle line of the mesh, without a "
      "model; auto: votes, or shape where the votes know nothing; for comparison, as published: slots, joints "
      "in fixed slots and a matrix of connections (float; --model CKPT), and regions, boxes around pieces of "
      "the surface, whose contacts are collapsed to a tree")
      ->check(CLI::IsMember({"auto", "votes", "shape", "slots", "regions"}))
      ->capture_default_str();
  shared_option(sub, "--category", options->category, "It says what slots there are")
      ->check(CLI::IsMember(slot_category_names()))
      ->capture_default_str();
}

void check_method(const CLI::App& sub, const MethodOptions& options, const std::string& model) {
  const auto given = [&](const char* option) { return sub.get_option(option)->count() > 0; };
  if (!options.slots()) {
    if (given("--category")) throw UsageError("--category is for --method slots");
    return;
  }
  for (const char* option : {"--mirror", "--spine", "--prediction"})
    if (given(option)) throw UsageError(std::string(option) + " does not go with --method slots");
  if (model.empty())
    throw UsageError(
        "--method slots needs --model CKPT, a checkpoint that was trained with \"architecture\": \"slots\"");
}

FloatNetwork load_slots(const std::string& path) {
  if (path.empty() || path == "bundled")
    throw UsageError(
        "--method slots needs --model CKPT, a checkpoint that was trained with \"architecture\": \"slots\"");
  return read_slot_network(path);
}

}  // namespace sinew::cli
