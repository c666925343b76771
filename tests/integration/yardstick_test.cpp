// SPDX-License-Identifier: MIT
// Our figures against weights_eval.py on the same files: every number of every character, family and mean to 1e-4.
// The draws, the folding of end joints and the means are easy to get subtly wrong; only the script itself can tell.
#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "shared_data.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/evaluate.hpp"

namespace sinew {
namespace {

namespace fs = std::filesystem;
using Prediction = std::vector<std::vector<Influence>>;

std::string python_with_numpy() {
  for (const char* python : {"python3", "/usr/bin/python3"})
    if (std::system((std::string(python) + " -c 'import numpy' >/dev/null 2>&1").c_str()) == 0) return python;
  return "";
}

// The reference with weights scaled at random, some dropped, some given to strangers, some rows emptied.
Prediction perturbed(const Character& c, uint32_t seed) {
  std::mt19937 random(seed);
  const auto chance = [&] { return static_cast<float>(random() % 1000u) / 1000.0f; };
  Prediction out(c.vertices.size());
  for (size_t v = 0; v < out.size(); ++v) {
    if (chance() < 0.01f) continue;
    for (const Influence& influence : c.influences[v])
      if (chance() > 0.1f) out[v].push_back({influence.joint, influence.weight * (0.25f + chance())});
    if (chance() < 0.3f) out[v].push_back({static_cast<uint32_t>(random() % c.joints.size()), 0.4f * chance()});
  }
  return out;
}

Prediction nearest_joint(const Character& c) {
  Prediction out(c.vertices.size());
  for (size_t v = 0; v < out.size(); ++v) {
    float least = INFINITY;
    uint32_t nearest = 0;
    for (uint32_t j = 0; j < c.joints.size(); ++j) {
      const Vec3 &p = c.vertices[v], &q = c.joints[j].position;
      const float d = std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
      if (d < least) {
        least = d;
        nearest = j;
      }
    }
    out[v] = {{nearest, 1.0f}};
  }
  return out;
}

void write_csv(const fs::path& path, const Character& c, const Prediction& prediction) {
  std::ofstream out(path);
  out << "vertex,joint,weight\n";
  for (size_t v = 0; v < prediction.size(); ++v) {
    for (const Influence& influence : prediction[v]) {
      std::array<char, 32> text;  // the shortest decimal that reads back as this float
      const auto end = std::to_chars(text.data(), text.data() + text.size(), influence.weight).ptr;
      out << v << ',' << c.joints[influence.joint].name << ',' << std::string_view(text.data(), end) << '\n';
    }
  }
}

double largest_difference = 0;  // of all figures compared so far

// Takes our figure with end joints as they lie in the file out of `scores`: the yardstick has it in a run of its own.
nlohmann::json without_file_figure(nlohmann::json scores) {
  for (auto& [key, value] : scores.items()) {
    if (value.is_object()) value = without_file_figure(value);
  }
  if (scores.is_object()) scores.erase("l1_file");
  return scores;
}

// Returns how many numbers were compared.
size_t compare(const nlohmann::json& ours, const nlohmann::json& theirs, const std::string& where) {
  if (theirs.is_object()) {
    EXPECT_TRUE(ours.is_object()) << where;
    if (!ours.is_object()) return 0;
    EXPECT_EQ(ours.size(), theirs.size()) << where;
    size_t count = 0;
    for (const auto& [key, value] : theirs.items()) {
      EXPECT_TRUE(ours.contains(key)) << where << "/" << key;
      if (ours.contains(key)) count += compare(ours.at(key), value, where + "/" + key);
    }
    return count;
  }
  if (theirs.is_number() && ours.is_number()) {
    EXPECT_NEAR(ours.get<double>(), theirs.get<double>(), 1e-4) << where;
    largest_difference = std::max(largest_difference, std::abs(ours.get<double>() - theirs.get<double>()));
    return 1;
  }
  EXPECT_EQ(ours, theirs) << where;
  return 0;
}

TEST(Yardstick, EveryFigureAgrees) {
  const fs::path shared = shared_folder();
  if (shared.empty())
    GTEST_SKIP() << "NOT CHECKED: there is no shared data; set SINEW_SHARED_DIR to compare with weights_eval.py";
  const std::string python = python_with_numpy();
  if (python.empty()) GTEST_SKIP() << "NOT CHECKED: no python3 with numpy to run weights_eval.py";

  const fs::path work = fs::temp_directory_path() / ("sinew_yardstick_" + std::to_string(std::random_device{}()));
  const fs::path reference = shared / "data" / "characters" / "val";
  const std::vector<std::string> methods = {"perturbed", "nearest"};
  std::map<std::string, std::vector<std::pair<std::string, Metrics>>> measured;
  for (const std::string& method : methods) fs::create_directories(work / method);
  nlohmann::json status;
  uint32_t seed = 1;
  for (const std::string& path : list_characters(reference.string())) {
    const Character c = read_character(path);
    for (const std::string& method : methods) {
      const Prediction prediction = method == "perturbed" ? perturbed(c, seed++) : nearest_joint(c);
      write_csv(work / method / (c.name + ".csv"), c, prediction);
      Metrics m = measure(c, prediction, c.name);
      m.seconds = 0.25 * static_cast<double>(measured[method].size() + 1);
      measured[method].emplace_back(c.name, m);
      status[c.name] = {{"seconds", m.seconds}, {"ok", true}};
    }
  }
  for (const std::string& method : methods) std::ofstream(work / method / "status.json") << status;

  const auto run_yardstick = [&](const std::string& options) {
    const std::string out = (work / "out.json").string();
    const std::string command = python + " '" + (shared / "eval" / "weights_eval.py").string() + "' '" +
                                reference.string() + "' '" + (work / "perturbed").string() + "' '" +
                                (work / "nearest").string() + "' --json '" + out + "' " + options + " >/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return nlohmann::json::parse(std::ifstream(out));
  };
  const nlohmann::json theirs = run_yardstick(""), kept = run_yardstick("--ends keep --poses 1");
  for (const std::string& method : methods) {
    const Scores scores = summarize(measured[method]);
    const size_t compared = compare(without_file_figure(nlohmann::json::parse(scores_json(method, scores)).at(method)),
                                    theirs.at(method), method);
    EXPECT_GT(compared, 15 * scores.characters.size()) << "hardly anything was compared";
    for (const auto& [name, m] : scores.characters)
      compare(m.l1_file, kept.at(method).at("characters").at(name).at("l1"), method + "/" + name + " --ends keep");
    EXPECT_GT(scores.all.l1_file, scores.all.l1) << "val has end joints, and nearest binds to them";
  }
  std::printf("largest difference of any figure: %.2g\n", largest_difference);
  fs::remove_all(work);
}

}  // namespace
}  // namespace sinew
