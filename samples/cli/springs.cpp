// SPDX-License-Identifier: MIT
// sinew springs: which chains of a character swing, with colliders, into its own file.
#include "sinew_formats/springs.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "option_groups.hpp"
#include "options.hpp"
#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/jobs/springs_job.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SpringsCommandSettings {
  std::string character, output;
  SpringsOptions options;
  ProfileSettings profile;
  bool make = false, json = false;
};

const char* shape_text(ColliderShape shape) {
  constexpr const char* kTexts[] = {"sphere", "capsule", "inside-sphere", "inside-capsule", "plane"};
  return kTexts[static_cast<size_t>(shape)];
}

Json chain_json(const FoundChain& found, const Springs& springs, const Character& character) {
  Json json = {{"name", found.chain.name}, {"kind", spring_kind_text(found.kind)}, {"kept", found.kept},
               {"own", found.own},         {"certainty", found.certainty},         {"reason", found.reason},
               {"length", found.length}};
  json["joints"] = Json::array();
  for (size_t i = 0; i < found.chain.joints.size(); ++i) {
    const SpringJoint& joint = found.chain.joints[i];
    Json one = {{"name", character.joints[joint.joint].name}};
    if (i < found.chain.turning_joints()) {
      one["stiffness"] = joint.stiffness;
      one["gravity"] = joint.gravity_power;
      one["drag"] = joint.drag;
      one["radius"] = joint.hit_radius;
      one["limit"] = joint.limit;
    }
    json["joints"].push_back(std::move(one));
  }
  if (found.chain.end) json["end"] = *found.chain.end;
  if (found.chain.center >= 0) json["center"] = character.joints[static_cast<size_t>(found.chain.center)].name;
  json["colliders"] = Json::array();
  for (const size_t group : found.chain.groups)
    for (const size_t collider : springs.groups[group].colliders) json["colliders"].push_back(collider);
  return json;
}

Json springs_json(const SpringsCommandSettings& s, const SpringsFound& found, const Character& character,
                  const std::vector<std::string>& notes) {
  Json json = {{"sinew_springs", 1}, {"character", s.character}};
  if (!s.output.empty()) json["output"] = s.output;
  json["chains"] = Json::array();
  for (const FoundChain& chain : found.chains) json["chains"].push_back(chain_json(chain, found.springs, character));
  json["colliders"] = Json::array();
  for (size_t i = 0; i < found.springs.colliders.size(); ++i) {
    const SpringCollider& c = found.springs.colliders[i];
    Json one = {{"name", c.name},
                {"joint", character.joints[c.joint].name},
                {"shape", shape_text(c.shape)},
                {"offset", c.offset}};
    if (c.shape != ColliderShape::kSphere && c.shape != ColliderShape::kInsideSphere) one["tail"] = c.tail;
    one["radius"] = c.radius;
    if (found.errors[i] >= 0) one["error"] = found.errors[i];
    json["colliders"].push_back(std::move(one));
  }
  json["notes"] = notes;
  return json;
}

void tell_springs(const SpringsCommandSettings& s, const SpringsFound& found, const Character& character,
                  const std::vector<std::string>& notes) {
  size_t kept = 0, joints = 0;
  for (const FoundChain& one : found.chains) {
    if (one.kept) {
      ++kept;
      joints += one.chain.turning_joints();
    }
    std::printf("  %s %s: %s, %zu joints, length %.3g, probability %.0f %%: %s\n", one.kept ? "+" : "-",
                printable(one.chain.name).c_str(), spring_kind_text(one.kind), one.chain.turning_joints(), one.length,
                100 * static_cast<double>(one.certainty), printable(one.reason).c_str());
  }
  std::printf("%s: kept %zu of %zu chains, %zu joints swing, %zu colliders\n", printable(s.character).c_str(), kept,
              found.chains.size(), joints, found.springs.colliders.size());
  for (size_t i = 0; i < found.springs.colliders.size(); ++i) {
    const SpringCollider& c = found.springs.colliders[i];
    if (found.errors[i] < 0) continue;
    std::printf("  %s on %s: %s, radius %.3g, fit error %.0f %% of it\n", printable(c.name).c_str(),
                printable(character.joints[c.joint].name).c_str(), shape_text(c.shape), c.radius,
                100 * found.errors[i]);
  }
  for (const std::string& note : notes) std::printf("  %s\n", printable(note).c_str());
  if (!s.output.empty()) std::printf("wrote %s\n", printable(s.output).c_str());
}

void run_springs(const SpringsCommandSettings& s) {
  settle_profile(s.profile, nullptr);
  if (!s.output.empty()) check_output(s.output, kWritesSprings);
  AnimatedCharacter animated = animated_character(open_character(s.character).character, s.character);
  const size_t noted = animated.character.notes.size();
  SpringsOptions options = s.options;
  const bool made = s.make && make_spring_chains(&options, &animated.character);
  const SpringsFound found = springs_of(options, s.character, animated.character);
  std::vector<std::string> notes(animated.character.notes.begin() + static_cast<std::ptrdiff_t>(noted),
                                 animated.character.notes.end());
  notes.insert(notes.end(), found.notes.begin(), found.notes.end());
  if (animated.rigged)
    notes.insert(notes.begin(), "rigged first, " + std::to_string(animated.character.joints.size()) + " joints");
  if (!s.output.empty()) {
    GlbOptions glb;
    glb.keep_skin = !animated.rigged && !made;
    glb.springs = &found.springs;
    write_as(s.profile, s.output, animated.character, &notes, glb);
  }
  if (s.json)
    std::printf("%s\n", json_line(springs_json(s, found, animated.character, notes)).c_str());
  else
    tell_springs(s, found, animated.character, notes);
}

}  // namespace

void add_springs(CLI::App& app) {
  CLI::App* sub = app.add_subcommand(
      "springs", "Find hair, tails, ears and skirts that swing, with colliders, and write them as springs");
  auto s = std::make_shared<SpringsCommandSettings>();
  sub->add_option("character", s->character, "Skinned file, or a bare mesh, which is rigged first. " + mesh_files())
      ->required()
      ->type_name("CHARACTER");
  shared_option(sub, "-o,--output", s->output,
                "The character with its springs (VRMC_springBone), " + extensions_text(kWritesSprings) +
                    ". By default only prints the result");
  sub->add_option("--take", s->options.keep,
                  "Keep a chain despite a low probability, or beside the file's own; NAME* for all that begin with "
                  "NAME; repeatable")
      ->type_name("NAME")
      ->allow_extra_args(false);
  sub->add_option("--drop", s->options.drop, "Leave out a chain; repeatable")
      ->type_name("NAME")
      ->allow_extra_args(false);
  sub->add_option("--preset", s->options.presets,
                  "Use the parameters of another kind for a chain: " + spring_kinds_text() + "; repeatable")
      ->type_name("NAME=KIND")
      ->allow_extra_args(false);
  sub->add_option(
         "--value", s->options.values,
         "Set a parameter of a chain's joints, NAME:FIELD=X, or scale it, NAME:FIELD=xF; repeatable. Fields: " +
             spring_fields_text() + ", in meters per second, meters, degrees; limit is for animate --springs only")
      ->type_name("SETTING")
      ->allow_extra_args(false);
  sub->add_flag("--make", s->make,
                "Make chains of joints for skirts, coats and capes without any, and bind the mesh to them");
  sub->add_flag("--replace", s->options.replace, "Find springs anew instead of the file's own");
  shared_flag(sub, "--json", s->json, "One line: chains with reasons and parameters, colliders with their fit");
  add_profile_options(sub, &s->profile);
  sub->footer(
      "Examples:\n  sinew springs hero.vrm\n"
      "  sinew springs hero.glb --drop 'Antenna*' --preset Tail=ear -o hero.springs.glb\n"
      "  sinew springs hero.glb --value 'Hair*:drag=0.3' --for vrm -o hero.vrm");
  sub->callback([s] { run_springs(*s); });
}

}  // namespace sinew::cli
