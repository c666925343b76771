// SPDX-License-Identifier: MIT
// sinew dataset: check, stats, convert, decimate and synthesize characters.
#include "sinew_formats/dataset.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "commands.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/synthesize.hpp"
#include "support.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace); }

// Files as they are; a folder stands for its characters. A bare mesh is a character without joints.
std::vector<std::string> expand(const std::vector<std::string>& inputs) {
  std::vector<std::string> paths;
  for (const std::string& input : inputs) {
    std::error_code ignored;
    if (!fs::is_directory(input, ignored)) {
      paths.push_back(input);
      continue;
    }
    const std::vector<std::string> inside = list_characters(input);
    if (inside.empty()) throw Error(input + ": no characters; expected NAME.obj with NAME.rig.txt, or .glb files");
    paths.insert(paths.end(), inside.begin(), inside.end());
  }
  return paths;
}

Character read_any(const std::string& path) {
  std::error_code ignored;
  if (ends_with(path, ".obj") && !fs::exists(path.substr(0, path.size() - 4) + ".rig.txt", ignored))
    return read_mesh(path);
  return path == "-" ? read_mesh(path) : read_character(path);
}

void check(const std::vector<std::string>& inputs, bool json) {
  const char* const level_names[] = {"note", "warning", "error"};
  Json all = Json::array();
  size_t bad = 0, total = 0;
  for (const std::string& path : expand(inputs)) {
    ++total;
    Json entry = {{"file", path}};
    CheckReport report;
    std::string unreadable;
    try {
      report = check_character(read_any(path));
    } catch (const Error& error) {
      unreadable = error.what();
    }
    bool failed = !unreadable.empty();
    for (const CheckFinding& finding : report.findings) failed = failed || finding.level == CheckFinding::Level::kError;
    bad += failed ? 1 : 0;
    if (json) {
      entry["ok"] = !failed;
      if (!unreadable.empty()) entry["unreadable"] = unreadable;
      entry["vertices"] = report.vertices;
      entry["faces"] = report.faces;
      entry["joints"] = report.joints;
      entry["components"] = report.components;
      entry["boundary_edges"] = report.boundary_edges;
      entry["non_manifold_edges"] = report.non_manifold_edges;
      entry["degenerate_faces"] = report.degenerate_faces;
      entry["duplicate_faces"] = report.duplicate_faces;
      entry["isolated_vertices"] = report.isolated_vertices;
      entry["unbound_vertices"] = report.unbound_vertices;
      entry["bad_weight_sums"] = report.bad_weight_sums;
      entry["joints_outside"] = report.joints_outside;
      entry["roots"] = report.roots;
      entry["hierarchy_cycles"] = report.hierarchy_cycles;
      entry["max_influences"] = report.max_influences;
      entry["findings"] = Json::array();
      for (const CheckFinding& finding : report.findings) {
        entry["findings"].push_back({{"level", level_names[static_cast<int>(finding.level)]},
                                     {"code", finding.code},
                                     {"count", finding.count},
                                     {"text", finding.text}});
      }
      all.push_back(std::move(entry));
      continue;
    }
    if (!unreadable.empty()) {
      std::printf("%s\n  error    unreadable: %s\n", path.c_str(), unreadable.c_str());
      continue;
    }
    std::printf("%s: %zu vertices, %zu faces, %zu joints, %zu components\n", path.c_str(), report.vertices,
                report.faces, report.joints, report.components);
    for (const CheckFinding& finding : report.findings) {
      std::printf("  %-8s %s: %s\n", level_names[static_cast<int>(finding.level)], finding.code.c_str(),
                  finding.text.c_str());
    }
  }
  if (json) std::printf("%s\n", dump(all).c_str());
  if (bad > 0) throw Error(print("%zu of %zu characters have errors", bad, total));
}

struct FamilyStats {
  size_t characters = 0;
  std::vector<size_t> vertices, faces, joints, bound_joints, components, influences;
};

void stats(const std::string& folder, bool json) {
  std::map<std::string, FamilyStats> families;
  for (const std::string& path : expand({folder})) {
    const Character character = read_character(path);
    const CheckReport report = check_character(character);
    std::set<uint32_t> bound;
    for (const auto& row : character.influences) {
      for (const Influence& i : row) bound.insert(i.joint);
    }
    for (const std::string& family : {family_of(character.name), std::string("(all)")}) {
      FamilyStats& f = families[family];
      ++f.characters;
      f.vertices.push_back(report.vertices);
      f.faces.push_back(report.faces);
      f.joints.push_back(report.joints);
      f.bound_joints.push_back(bound.size());
      f.components.push_back(report.components);
      f.influences.push_back(report.max_influences);
    }
  }
  const auto span = [](std::vector<size_t> values) {
    std::sort(values.begin(), values.end());
    return std::vector<size_t>{values.front(), values[values.size() / 2], values.back()};
  };
  if (json) {
    Json all = Json::object();
    for (const auto& [name, f] : families) {
      all[name] = {{"characters", f.characters},
                   {"vertices", span(f.vertices)},
                   {"faces", span(f.faces)},
                   {"joints", span(f.joints)},
                   {"bound_joints", span(f.bound_joints)},
                   {"components", span(f.components)},
                   {"max_influences", span(f.influences)}};
    }
    std::printf("%s\n", dump(all).c_str());
    return;
  }
  std::printf("smallest / median / largest of each family\n");
  std::printf("%-20s %5s %22s %22s %16s %16s %16s %14s\n", "family", "chars", "vertices", "faces", "joints",
              "bound joints", "components", "influences");
  for (const auto& [name, f] : families) {
    const auto text = [&](const std::vector<size_t>& values) {
      const std::vector<size_t> s = span(values);
      return print("%zu / %zu / %zu", s[0], s[1], s[2]);
    };
    std::printf("%-20s %5zu %22s %22s %16s %16s %16s %14s\n", name.c_str(), f.characters, text(f.vertices).c_str(),
                text(f.faces).c_str(), text(f.joints).c_str(), text(f.bound_joints).c_str(), text(f.components).c_str(),
                text(f.influences).c_str());
  }
}

struct ConvertSettings {
  std::string input, skeleton, output;
  double ratio = 0;
};

void convert(const ConvertSettings& s) {
  check_output(s.output, character_outputs(), true);
  if (ends_with(s.input, ".obj") && ends_with(s.skeleton, ".obj"))
    throw UsageError("--skeleton " + s.skeleton + ": an OBJ holds no skeleton");
  Character character = read_any(s.input);
  if (!s.skeleton.empty()) read_skeleton(s.skeleton, true, &character);
  if (s.ratio > 0) character = decimate(character, s.ratio);
  if (!ends_with(s.output, ".obj") && character.joints.empty()) {
    throw Error(s.input + ": has no skeleton, but " + (s.output == "-" ? std::string("a rig") : s.output) +
                " needs one; give --skeleton FILE");
  }
  write_character(s.output, character);
  if (s.output != "-") {
    std::printf("%s: %zu vertices, %zu faces, %zu joints, wrote %s\n", character.name.c_str(),
                character.vertices.size(), character.face_count(), character.joints.size(), s.output.c_str());
  }
}

struct SynthesizeSettings {
  std::string output, plan = "all";
  uint64_t seed = 1;
  unsigned count = 1;
  int resolution = 48;
  bool no_clothing = false;
};

void synthesize_all(const SynthesizeSettings& s) {
  const BodyPlan plans[] = {BodyPlan::kBiped, BodyPlan::kQuadruped, BodyPlan::kBird, BodyPlan::kSnake,
                            BodyPlan::kManyLegged};
  std::vector<BodyPlan> chosen;
  for (BodyPlan plan : plans) {
    if (s.plan == "all" || s.plan == body_plan_name(plan)) chosen.push_back(plan);
  }
  const bool one_file = ends_with(s.output, ".obj") || ends_with(s.output, ".glb");
  if (one_file) {
    if (chosen.size() * s.count != 1)
      throw UsageError("one output file holds one character: give --plan and no --count, or a folder as output");
    check_output(s.output, {".obj", ".glb"});
  } else {
    std::error_code failed;
    fs::create_directories(s.output, failed);
    if (failed || !fs::is_directory(s.output)) throw Error(s.output + ": cannot make this folder: " + failed.message());
  }
  for (BodyPlan plan : chosen) {
    for (unsigned i = 0; i < s.count; ++i) {
      SynthesizeOptions options;
      options.plan = plan;
      options.seed = s.seed + i;
      options.resolution = s.resolution;
      options.clothing = !s.no_clothing;
      Character character = synthesize(options);
      const std::string path = one_file ? s.output : (fs::path(s.output) / (character.name + ".obj")).string();
      character.name = stem(path);
      write_character(path, character);
      std::printf("%s: %s, seed %llu, %zu vertices, %zu joints\n", path.c_str(), body_plan_name(plan),
                  static_cast<unsigned long long>(options.seed), character.vertices.size(), character.joints.size());
    }
  }
}

void add_check(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("check", "Look for defects of meshes, skeletons and weights");
  auto inputs = std::make_shared<std::vector<std::string>>();
  auto json = std::make_shared<bool>(false);
  sub->add_option("inputs", *inputs, "Meshes, characters and folders of them")->required()->type_name("FILE|DIR");
  sub->add_flag("--json", *json, "Print JSON");
  sub->footer(
      "Example:\n  sinew dataset check characters/train hero.glb\nExit status 1 when any character has an error.");
  sub->callback([inputs, json] { check(*inputs, *json); });
}

void add_stats(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("stats", "Sizes of the families in a folder");
  auto folder = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  sub->add_option("dir", *folder, "Folder of FAMILY__NAME characters")->required()->type_name("DIR");
  sub->add_flag("--json", *json, "Print JSON; each size is [smallest, median, largest]");
  sub->footer("Example:\n  sinew dataset stats characters/train");
  sub->callback([folder, json] { stats(*folder, *json); });
}

void add_convert(CLI::App* parent, bool decimates) {
  CLI::App* sub =
      decimates ? parent->add_subcommand("decimate", "Write a character with fewer vertices, weights carried along")
                : parent->add_subcommand("convert", "Write a character in another format");
  auto s = std::make_shared<ConvertSettings>();
  sub->add_option("input", s->input, "Character: .glb, .gltf, .vrm, or NAME.obj (NAME.rig.txt beside it is read too)")
      ->required()
      ->type_name("IN");
  sub->add_option("output,-o,--output", s->output,
                  "Output: .glb, .rig.txt, or .obj (a .rig.txt goes beside it); - for rig.txt on standard output")
      ->required()
      ->type_name("OUT");
  sub->add_option("--skeleton", s->skeleton, "Skeleton and weights of another file")->type_name("FILE");
  if (decimates) {
    sub->add_option("--ratio", s->ratio, "Share of the vertices to keep")
        ->required()
        ->check(CLI::Range(0.01, 1.0))
        ->type_name("X");
    sub->footer("Example:\n  sinew dataset decimate hero.obj hero_small.obj --ratio 0.5");
  } else {
    sub->footer("Example:\n  sinew dataset convert hero.obj hero.glb");
  }
  sub->callback([s] { convert(*s); });
}

void add_synthesize(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("synthesize", "Make characters with exact weights from a seed");
  auto s = std::make_shared<SynthesizeSettings>();
  sub->add_option("-o,--output", s->output, "Folder, or one .obj or .glb file")->required()->type_name("OUT");
  sub->add_option("--plan", s->plan, "Body plan")
      ->check(CLI::IsMember({"all", "biped", "quadruped", "bird", "snake", "many-legged"}))
      ->capture_default_str();
  sub->add_option("--seed", s->seed, "First seed; the same seed gives the same character everywhere")
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--count", s->count, "Characters per plan, from seed on")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--resolution", s->resolution, "Voxels along the longest side")
      ->check(CLI::Range(24, 256))
      ->capture_default_str()
      ->type_name("N");
  sub->add_flag("--no-clothing", s->no_clothing, "Bodies only");
  sub->footer(
      "Examples:\n  sinew dataset synthesize --count 20 -o made\n  sinew dataset synthesize --plan biped --seed 2 -o "
      "hero.obj");
  sub->callback([s] { synthesize_all(*s); });
}

}  // namespace

void add_dataset(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("dataset", "Check, count, convert, decimate and make characters");
  sub->require_subcommand(1);
  sub->footer("Example:\n  sinew dataset stats characters/train");
  add_check(sub);
  add_stats(sub);
  add_convert(sub, false);
  add_convert(sub, true);
  add_synthesize(sub);
}

}  // namespace sinew::cli
