// SPDX-License-Identifier: MIT
// sinew-lab dataset check: defects of meshes, skeletons and weights, as text, JSON and pictures of the defects.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "commands.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_data_sets/dataset.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct DatasetCheckCommandSettings {
  std::vector<std::string> inputs;
  std::string pictures;
  bool json = false;
};

constexpr const char* kLevels[] = {"note", "warning", "error"};

Json as_json(const std::string& path, const CheckReport& report, const std::string& unreadable, bool failed) {
  Json entry = {{"sinew_dataset", 1}, {"about", "check"}, {"file", path}};
  entry["ok"] = !failed;
  if (!unreadable.empty()) entry["unreadable"] = unreadable;
  entry["vertices"] = report.vertices;
  entry["faces"] = report.faces;
  entry["joints"] = report.joints;
  entry["parts"] = report.parts;
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
    Json one = {{"level", kLevels[static_cast<int>(finding.level)]},
                {"code", finding.code},
                {"count", finding.count},
                {"text", finding.text}};
    if (!finding.vertices.empty()) one["vertices"] = finding.vertices;
    entry["findings"].push_back(std::move(one));
  }
  return entry;
}

Vec3 middle_of(const Character& character, const std::vector<uint32_t>& vertices, float* radius) {
  Box box = {character.vertices[vertices[0]], character.vertices[vertices[0]]};
  for (const uint32_t v : vertices) box.add(character.vertices[v]);
  *radius = box.longest_side() / 2;
  const auto& [low, high] = box;
  return {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
}

// The flagged vertices ringed on the weights as colors: from the front, from behind, and the largest finding from
// near. Nothing when no finding names a vertex.
void write_picture(const std::string& path, const Character& character, const CheckReport& report) {
  const CheckFinding* largest = nullptr;
  std::set<uint32_t> marked;
  for (const CheckFinding& f : report.findings) {
    if (f.vertices.empty()) continue;
    marked.insert(f.vertices.begin(), f.vertices.end());
    if (largest == nullptr || f.vertices.size() > largest->vertices.size()) largest = &f;
  }
  if (largest == nullptr) return;
  RenderOptions options;
  options.width = options.height = 560;
  // Thousands of rings would hide what they mark.
  const size_t step = 1 + marked.size() / 400;
  size_t at = 0;
  for (const uint32_t v : marked)
    if (at++ % step == 0) options.marks.push_back({character.vertices[v]});
  const auto colors = weight_colors(character);
  std::vector<Image> images = {render(character, colors, options)};
  options.yaw_degrees += 180;
  images.push_back(render(character, colors, options));
  float size = 0, radius = 0;
  std::vector<uint32_t> everything(character.vertices.size());
  for (uint32_t v = 0; v < everything.size(); ++v) everything[v] = v;
  const Vec3 center = middle_of(character, everything, &size);
  options.focus = middle_of(character, largest->vertices, &radius);
  options.focus_radius = std::max(1.4f * radius, 0.15f * size);
  // From the side on which it lies.
  const float dx = options.focus.x - center.x, dz = options.focus.z - center.z;
  options.yaw_degrees = std::hypot(dx, dz) > 0.02f * size ? std::atan2(dx, dz) * 57.29578f : 25.0f;
  images.push_back(render(character, colors, options));
  write_file(path, encode_png(beside(images)));
}

struct CheckedCharacter {
  CheckReport report;
  std::string unreadable;
  bool failed() const {
    return !unreadable.empty() ||
           std::any_of(report.findings.begin(), report.findings.end(),
                       [](const CheckFinding& finding) { return finding.level == CheckFinding::Level::kError; });
  }
};

CheckedCharacter check_one(const FoundCharacter& found, const std::string& pictures) {
  CheckedCharacter checked;
  Character character;
  try {
    character = read_any(found.path);
    checked.report = check_training_character(character);
  } catch (const Error& error) {
    checked.unreadable = error.what();
  }
  if (!checked.failed() && !pictures.empty()) {
    const fs::path picture = fs::path(pictures) / (found.name + ".png");
    make_folder(picture.parent_path().string());
    write_picture(picture.string(), character, checked.report);
  }
  return checked;
}

void say(const std::string& path, const CheckedCharacter& checked, Progress* progress) {
  if (!checked.unreadable.empty()) {
    progress->say(stdout, path + "\n  error    unreadable: " + checked.unreadable);
    return;
  }
  const CheckReport& report = checked.report;
  std::string text = print("%s: %zu vertices, %zu faces, %zu joints, %zu parts", path.c_str(), report.vertices,
                           report.faces, report.joints, report.parts);
  for (const CheckFinding& finding : report.findings)
    text +=
        print("\n  %-8s %s: %s", kLevels[static_cast<int>(finding.level)], finding.code.c_str(), finding.text.c_str());
  progress->say(stdout, text);
}

void run_dataset_check(const DatasetCheckCommandSettings& s) {
  if (!s.pictures.empty()) make_folder(s.pictures);
  size_t bad = 0;
  const std::vector<FoundCharacter> inputs = expand(s.inputs);
  {
    Progress progress(inputs.size(), "characters");
    for (const FoundCharacter& found : inputs) {
      const CheckedCharacter checked = check_one(found, s.pictures);
      bad += checked.failed() ? 1 : 0;
      if (s.json) {
        const Json json = as_json(found.path, checked.report, checked.unreadable, checked.failed());
        progress.say(stdout, json_line(json));
      } else {
        say(found.path, checked, &progress);
      }
      progress.step();
    }
  }
  if (bad > 0) throw Error(print("%zu of %zu characters have errors", bad, inputs.size()));
}

}  // namespace

void add_dataset_check(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("check", "Find defects of meshes, skeletons and weights");
  auto s = std::make_shared<DatasetCheckCommandSettings>();
  sub->add_option("inputs", s->inputs, "Meshes, characters, or folders of them with subfolders")
      ->required()
      ->type_name("FILE|DIR");
  shared_flag(sub, "--json", s->json, "One line per character, with all vertices of findings about weights");
  sub->add_option("--pictures", s->pictures,
                  "Folder for a picture of each character with its suspicious vertices ringed")
      ->type_name("DIR");
  sub->footer(
      "Example:\n  sinew-lab dataset check characters/train hero.glb --pictures suspicious\n\nSuspicious weights are "
      "warnings: far-weight (a joint across the body while another is near), island (a patch\nbound across the body), "
      "odd-vertex (its neighbors agree on another joint), left-right (at the position of the\njoint's mirror twin), "
      "idle-twin (no weight, but the twin has some), shared-position (joints at one position\nhold much of the mesh; "
      "leave such characters out of training).\nExit status 1 if any character has an error.");
  sub->callback([s] { run_dataset_check(*s); });
}

}  // namespace sinew::cli
