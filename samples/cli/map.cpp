// SPDX-License-Identifier: MIT
// sinew map: which joint of one skeleton represents which of another, as text that can be edited and given back.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "options.hpp"
#include "pictures.hpp"
#include "sinew/published.h"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/motion/map_source.hpp"
#include "sinew_character/motion/motion_map.hpp"
#include "sinew_character/motion/simplify_skeleton.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNoEnds = "none";  // of --ends, instead of a file

struct MapCommandSettings {
  std::string target, source, preset, output = "-", up = "auto", source_up, pins_file, ends_file, png, level, layout,
                                      actor;
  uint32_t method = SINEW_MAP_AUTO, cost = SINEW_BRANCHES_MEAN, first = SINEW_BRANCHES_BOTH;
  std::vector<std::string> pins;
  bool no_names = false, as_drawn = false, json = false;
};

// A template that does not exist is wrong usage.
template <class Read>
MapRig read_rig(const std::string& path, const Read& read) {
  try {
    return read();
  } catch (const Error& error) {
    if (path.rfind("template:", 0) == 0) throw UsageError(error.what());
    throw;
  }
}

// RIG JOINT, or JOINT alone for both rigs; other rigs' lines are left out.
void read_ends(const std::string& path, MapRig* rig) {
  std::string stem = stem_of(rig->name);
  if (has_extension(stem, ".rig")) stem = stem_of(stem);
  rig->ends.assign(rig->joints.size(), 0);
  const std::string text = read_text_file(path);
  size_t number = 0;
  for (size_t at = 0; at < text.size();) {
    size_t end = text.find('\n', at);
    if (end == std::string::npos) end = text.size();
    std::string line = text.substr(at, end - at);
    at = end + 1;
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line[0] == '#') continue;
    const size_t tab = line.find('\t');
    if (tab != std::string::npos && line.substr(0, tab) != stem) continue;
    const std::string name = tab == std::string::npos ? line : line.substr(tab + 1);
    const auto found =
        std::find_if(rig->joints.begin(), rig->joints.end(), [&](const Joint& joint) { return joint.name == name; });
    if (found != rig->joints.end()) {
      rig->ends[static_cast<size_t>(found - rig->joints.begin())] = 1;
    } else if (tab != std::string::npos) {
      throw Error(path + ":" + std::to_string(number) + ": expected a joint of " + rig->name + ", found '" + name +
                  "'");
    }
  }
}

// The file's pins, then those of --set, which win.
std::vector<sinew_map_pin> read_pins(const MapCommandSettings& s, const MapRig& target, const MapRig& source) {
  std::vector<sinew_map_pin> pins;
  if (!s.pins_file.empty()) pins = read_map_file(s.pins_file, target, source);
  std::vector<sinew_map_pin> said;
  for (const std::string& text : s.pins) {
    sinew_map_pin pin;
    try {
      pin = parse_map_pin(text, target, source);
    } catch (const Error& error) {
      throw UsageError(std::string("--set: ") + error.what());
    }
    for (const sinew_map_pin& other : said)
      if (other.target == pin.target || (pin.source >= 0 && other.source == pin.source))
        throw UsageError("--set " + text + ": this joint has a --set already; give each joint once");
    said.push_back(pin);
  }
  for (const sinew_map_pin& pin : said) {
    std::erase_if(pins, [&](const sinew_map_pin& one) {
      return one.target == pin.target || (pin.source >= 0 && one.source == pin.source);
    });
    pins.push_back(pin);
  }
  return pins;
}

Json map_json(const MapCommandSettings& s, const MapRig& target, const MapRig& source, const MappedSkeleton& map,
              const MapCover& cover) {
  Json json = {{"sinew_map", 1}};
  json["target"] = target.name;
  json["source"] = source.name;
  if (s.output != "-") json["output"] = s.output;
  json["method"] = map.method == SINEW_MAP_BRANCHES ? "branches" : "sinew";
  json["mapped"] = map.mapped;
  json["certainty"] = map.certainty;
  json["cover"] = cover.share;
  if (cover.share < kLeastCover) json["missing"] = cover.missing;
  if (!cover.warnings.empty()) json["warnings"] = cover.warnings;
  if (!cover.rigid.empty()) json["rigid"] = cover.rigid;
  json["seconds"] = map.seconds;
  json["workspace_bytes"] = map.workspace_bytes;
  for (size_t j = 0; j < target.joints.size(); ++j) {
    Json one;
    one["target"] = target.joints[j].name;
    if (map.sources[j] >= 0) {
      one["source"] = source.joints[static_cast<size_t>(map.sources[j])].name;
      one["confidence"] = map.confidence[j];
    } else {
      one["source"] = nullptr;
    }
    if (map.reasons[j] != SINEW_MAP_FOUND) one["reason"] = map_reason_text(map.reasons[j]);
    json["joints"].push_back(std::move(one));
  }
  return json;
}

void tell(const MapCommandSettings& s, const MapRig& target, const MapRig& source, const MappedSkeleton& map,
          const MapCover& cover, std::FILE* out) {
  std::fprintf(out, "%s: %zu of %zu joints from %s, which has %zu; %.1f ms%s\n", printable(target.name).c_str(),
               map.mapped, target.joints.size(), printable(source.name).c_str(), source.joints.size(),
               1e3 * map.seconds, map.method == SINEW_MAP_BRANCHES ? ", by branches" : "");
  if (map.method != SINEW_MAP_BRANCHES && map.certainty < kDoubtfulSides)
    std::fprintf(out,
                 "  warning: the front of the rig is uncertain (%.0f %%), so left and right may be exchanged; give one "
                 "pair of a side with --set\n",
                 100 * static_cast<double>(map.certainty));
  if (cover.share < kLeastCover)
    std::fprintf(out, "  warning: %s: the motion does not fit; sinew animate refuses it without --force\n",
                 cover.missing.c_str());
  for (const std::string& warning : cover.warnings) std::fprintf(out, "  warning: %s\n", printable(warning).c_str());
  if (!cover.rigid.empty()) std::fprintf(out, "  %s stay rigid\n", printable(cover.rigid).c_str());
  for (size_t j = 0; j < target.joints.size(); ++j)
    if (map.sources[j] < 0 && map.reasons[j] != SINEW_MAP_END)
      std::fprintf(out, "  %s: no source, %s\n", printable(target.joints[j].name).c_str(),
                   map_reason_text(map.reasons[j]));
  if (s.output != "-") std::fprintf(out, "wrote %s\n", printable(s.output).c_str());
}

// Options that are not given follow from those that are.
MapCommandSettings settled(MapCommandSettings s) {
  if (s.source.empty() == s.preset.empty())
    throw UsageError("give the other skeleton with --from FILE, or the joint names of a standard rig with --to NAME");
  if (!s.preset.empty()) s.source = "template:" + s.preset;
  if (s.source_up.empty()) s.source_up = s.source.rfind("template:", 0) == 0 ? "y" : s.up;
  if (s.as_drawn) {
    if (s.method == SINEW_MAP_SINEW) throw UsageError("--as-drawn is --method branches: leave out --method sinew");
    s.method = SINEW_MAP_BRANCHES;
    s.cost = SINEW_BRANCHES_SUM;
    s.no_names = true;
  }
  if (s.method != SINEW_MAP_BRANCHES)
    refuse_given({{"--cost", s.cost != SINEW_BRANCHES_MEAN}, {"--first", s.first != SINEW_BRANCHES_BOTH}},
                 " needs --method branches; found --method " + kMapMethod[s.method]);
  if (s.output != "-") check_output(s.output, {".txt", ".map", ".json"});
  if (!s.png.empty()) check_output(s.png, {".png"});
  return s;
}

MappedSkeleton map_joints(const MapCommandSettings& s, const MapRig& target, const MapRig& source) {
  MapSkeletonOptions options;
  options.method = s.method;
  options.branches_cost = s.cost;
  options.branches_first = s.first;
  options.names = !s.no_names;
  options.ends = s.ends_file != kNoEnds;
  options.target_up = maybe_axis(s.up);
  options.source_up = maybe_axis(s.source_up);
  options.pins = read_pins(s, target, source);
  return s.level.empty() ? map_skeleton(target, source, options)
                         : map_at_level(target, source, options, s.level == "low");
}

void write_map(const MapCommandSettings& s, const MapRig& target, const MapRig& source, const MappedSkeleton& map,
               const std::string& json) {
  if (s.output != "-")
    write_text_file(s.output, has_extension(s.output, ".json") ? json + "\n" : map_text(target, source, map));
  if (!s.png.empty())
    write_file(s.png, encode_png(draw_map(target, maybe_axis(s.up), source, maybe_axis(s.source_up), map)));
}

void run_map(const MapCommandSettings& given) {
  const MapCommandSettings s = settled(given);
  MapRig target = read_rig(s.target, [&] { return read_map_rig(s.target); });
  MapRig source = read_rig(s.source, [&] {
    return read_map_source({s.source, s.layout, s.actor, maybe_axis(s.source_up), maybe_axis(s.up),
                            down_axis(s.source_up), s.source_up == "auto"},
                           target);
  });
  if (!s.ends_file.empty() && s.ends_file != kNoEnds) {
    read_ends(s.ends_file, &target);
    read_ends(s.ends_file, &source);
  }
  const MappedSkeleton map = map_joints(s, target, source);
  const MapCover cover =
      map_cover(target, maybe_axis(s.up), source, maybe_axis(s.source_up), {map.sources.begin(), map.sources.end()});
  const std::string json = map_json(s, target, source, map, cover).dump(2, ' ', false, Json::error_handler_t::replace);
  write_map(s, target, source, map, json);
  if (s.json) {
    std::printf("%s\n", json.c_str());
  } else if (s.output == "-") {
    std::printf("%s", map_text(target, source, map).c_str());
    tell(s, target, source, map, cover, stderr);
  } else {
    tell(s, target, source, map, cover, stdout);
  }
}

void add_map_inputs(CLI::App* sub, MapCommandSettings* s) {
  sub->add_option("target", s->target,
                  "Skeleton to map. " + skeleton_files() + ", .obj with its .rig.txt, or template:NAME")
      ->required()
      ->type_name("TARGET");
  sub->add_option("--from", s->source, "Skeleton with the sources, in the same kinds of files")->type_name("SOURCE");
  sub->add_option("--to", s->preset, "Names of a standard rig, instead of --from. See sinew rig --list-templates")
      ->type_name("NAME");
  shared_option(sub, "-o,--output", s->output,
                "Output: lines TARGET_JOINT SOURCE_JOINT, - for none: .txt, .map, or .json with confidence and "
                "reasons; - is standard output")
      ->capture_default_str();
  shared_option(sub, "--map", s->pins_file,
                "Keeps the lines of this map, such as an edited one; other joints are matched");
  sub->add_option("--set", s->pins, "Keep this pair and match the rest; - for no source; repeatable")
      ->type_name("JOINT=SOURCE_JOINT")
      ->allow_extra_args(false);
  shared_word_option(sub, "--method", s->method, kMapMethod,
                     "sinew: by anatomy; branches: the published method, for comparison; auto: sinew, or branches for "
                     "nearly equal rigs without a body");
  sub->add_option("--at-level", s->level,
                  "Map the joints that both skeletons keep at a level of sinew simplify. low is made from high")
      ->type_name("high|low")
      ->check(CLI::IsMember({"high", "low"}));
  shared_flag(sub, "--as-drawn", s->as_drawn, "As published: --method branches --cost sum --no-names");
  word_option(sub, "--cost", s->cost, kBranchesCost,
              "For --method branches: cost of two branches as the mean or the sum of their joints' costs")
      ->type_name("COST");
  word_option(sub, "--first", s->first, kBranchesFirst,
              "For --method branches: skeleton whose branches choose one of the other's. both: the cheaper direction")
      ->type_name("RIG");
  sub->add_flag("--no-names", s->no_names, "Ignore the joints' names");
  sub->add_option("--ends", s->ends_file,
                  "List joints that only end bones, for files without weights. Lines JOINT, or RIG and JOINT with a "
                  "tab; none: do not derive them from the skin weights")
      ->type_name("FILE|none");
  shared_option(sub, "--up", s->up, "auto: along the legs of a body with two legs, else y")
      ->check(CLI::IsMember({"x", "y", "z", "auto"}))
      ->capture_default_str();
  shared_option(sub, "--from-up", s->source_up, "Of the source; -y: y points down. By default as --up")
      ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z", "auto"}));
  shared_option(sub, "--png", s->png, "Both skeletons, with matching joints in one color");
  shared_option(sub, "--layout", s->layout, motion_layouts() + ". By default chosen by the number of keypoints");
  shared_option(sub, "--actor", s->actor, "Required if the actors differ; otherwise the first one");
  shared_flag(sub, "--json", s->json, "With confidence and reasons");
}

}  // namespace

void add_map(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("map", "Match the joints of a skeleton to those of another");
  auto s = std::make_shared<MapCommandSettings>();
  add_map_inputs(sub, s.get());
  sub->footer(
      "Examples:\n  sinew map hero.glb --from walk.glb -o hero.map\n  sinew map hero.glb --from walk.glb --map "
      "hero.map --set LeftHand=hand_l -o hero.map\n  sinew map hero.glb --to mixamo --png map.png\n\nConfidence 1 is "
      "certain. The sides of a rig whose front is uncertain may be exchanged: one --set of a side\ncorrects them all.");
  sub->callback([s] { run_map(*s); });
}

}  // namespace sinew::cli
