// SPDX-License-Identifier: MIT
// Options of the published method.
#include "rig_slots.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "options.hpp"
#include "picture_options.hpp"
#include "sinew_character/picture/body_class.hpp"
#include "support.hpp"

namespace sinew::cli {

namespace {

// In the order of SINEW_CATEGORY_*, which is that of BodyClass without its last.
std::vector<std::string> categories() {
  std::vector<std::string> words = {"any"};
  for (const std::string& word : body_class_words())
    if (word != body_class_word(BodyClass::kOther)) words.push_back(word);
  return words;
}

}  // namespace

void add_method_options(CLI::App* sub, MethodOptions* options) {
  shared_option(
      sub, "--method", options->method,
      "votes: points of the surface vote for bones; shape: joints along the middle line of the mesh, without a "
      "model; auto: votes, or shape where the votes know nothing; for comparison, as published: slots, joints "
      "in fixed slots and a matrix of connections, and regions, boxes around pieces of "
      "the surface, whose contacts are collapsed to a tree")
      ->check(CLI::IsMember({"auto", "votes", "shape", "slots", "regions"}))
      ->capture_default_str();
  sub->add_option("--class", options->category, kClassMeaning)
      ->type_name("KIND")
      ->check(CLI::IsMember(categories()))
      ->capture_default_str();
}

void check_method(const CLI::App& sub, const MethodOptions& options) {
  const auto given = [&](const char* option) { return sub.get_option(option)->count() > 0; };
  if (options.extracts() && given("--class"))
    throw UsageError("--class steers what a model says: leave --method " + options.method + " out");
  if (given("--class") && given("--prediction"))
    throw UsageError("--class steers a prediction: leave --prediction out, whose names say what joints are");
  if (!options.slots()) return;
  for (const char* option : {"--mirror", "--spine", "--prediction"})
    if (given(option)) throw UsageError(std::string(option) + " does not go with --method slots");
}

uint32_t category_number(const std::string& name) {
  const std::vector<std::string> words = categories();
  for (uint32_t i = 0; i < words.size(); ++i)
    if (name == words[i]) return i;
  throw UsageError("--class " + name + ": there is none of that name");
}

}  // namespace sinew::cli
