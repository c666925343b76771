// SPDX-License-Identifier: MIT
// The choice of whole units that comes closest to the wanted share. The files that belong to one character, and placing them in
// another folder without touching what is there.
#include "sinew_data_sets/split.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace fs = std::filesystem;

namespace sinew {
namespace {

// splitmix64 (Steele, Lea and Flood 2014): the standard library's shuffles differ between implementations.
uint64_t next_random(uint64_t* state) {
  uint64_t z = (*state += 0x9E3779B97F4A7C15ull);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

}  // namespace

std::vector<SplitUnit> split_units(const std::vector<std::string>& keys) {
  std::map<std::string, std::vector<size_t>> members;
  for (size_t i = 0; i < keys.size(); ++i) members[keys[i]].push_back(i);
  std::vector<SplitUnit> units;
  for (auto& [name, list] : members) units.push_back({name, std::move(list)});
  return units;
}

std::vector<bool> choose_validation(const std::vector<SplitUnit>& units, double share, uint64_t seed) {
  if (units.size() < 2) {
    throw Error("split: " + std::to_string(units.size()) +
                " unit cannot be split; expected at least two families, groups or characters");
  }
  std::vector<size_t> order(units.size());
  std::iota(order.begin(), order.end(), size_t{0});
  uint64_t state = seed;
  for (size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[next_random(&state) % (i + 1)]);

  size_t total = 0;
  for (const SplitUnit& unit : units) total += unit.members.size();
  // last[s]: the unit that first reached the sum s, with units tried in drawn order (subset sums).
  constexpr size_t kNone = SIZE_MAX;
  std::vector<size_t> last(total + 1, kNone);
  std::vector<bool> reached(total + 1, false);
  reached[0] = true;
  for (size_t k = 0; k < order.size(); ++k) {
    const size_t size = units[order[k]].members.size();
    for (size_t sum = total; sum >= size && sum > 0; --sum) {
      if (size == 0 || reached[sum] || !reached[sum - size]) continue;
      reached[sum] = true;
      last[sum] = k;
    }
  }
  const double wanted = std::clamp(share, 0.0, 1.0) * static_cast<double>(total);
  size_t best = kNone;
  for (size_t sum = 1; sum < total; ++sum)
    if (reached[sum] &&
        (best == kNone || std::abs(static_cast<double>(sum) - wanted) < std::abs(static_cast<double>(best) - wanted)))
      best = sum;
  std::vector<bool> chosen(units.size(), false);
  for (size_t sum = best; sum > 0 && best != kNone; sum -= units[order[last[sum]]].members.size())
    chosen[order[last[sum]]] = true;
  return chosen;
}

namespace {

std::string percent_decoded(const std::string& text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && std::isxdigit(static_cast<unsigned char>(text[i + 1])) &&
        std::isxdigit(static_cast<unsigned char>(text[i + 2]))) {
      out += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

// Paths relative to the document, of buffers and pictures that are files of their own.
std::vector<fs::path> gltf_references(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  const nlohmann::json document = nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (!document.is_object()) throw Error(path + ": expected a glTF document, found no JSON");
  std::vector<fs::path> references;
  for (const char* kind : {"buffers", "images"}) {
    const auto list = document.find(kind);
    if (list == document.end() || !list->is_array()) continue;
    for (const auto& entry : *list) {
      if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
      const std::string uri = entry["uri"].get<std::string>();
      if (uri.rfind("data:", 0) == 0) continue;
      const fs::path reference = fs::path(percent_decoded(uri)).lexically_normal();
      if (reference.is_absolute() || reference.empty() || *reference.begin() == "..")
        throw Error(path + ": names a file outside its folder: " + uri);
      if (std::find(references.begin(), references.end(), reference) == references.end())
        references.push_back(reference);
    }
  }
  return references;
}

// Relative to the mesh's folder, the mesh first.
std::vector<fs::path> relative_files(const std::string& mesh_path) {
  const fs::path mesh(mesh_path);
  std::vector<fs::path> files = {mesh.filename()};
  std::string extension = mesh.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".obj") files.emplace_back(mesh.stem().string() + ".rig.txt");
  if (extension == ".gltf")
    for (const fs::path& reference : gltf_references(mesh_path)) files.push_back(reference);
  return files;
}

}  // namespace

void place_character(const std::string& mesh_path, const std::string& folder) {
  for (const fs::path& file : relative_files(mesh_path)) {
    const fs::path from = fs::path(mesh_path).parent_path() / file, to = fs::path(folder) / file;
    std::error_code failed;
    fs::create_directories(to.parent_path(), failed);
    if (fs::exists(fs::symlink_status(to, failed)))
      throw Error(to.string() + ": exists and is never replaced; give another folder");
    fs::create_hard_link(from, to, failed);
    if (!failed) continue;
    fs::copy_file(from, to, failed);  // another disk, or a file system without links
    if (failed) throw Error(to.string() + ": cannot copy " + from.string() + " here: " + failed.message());
  }
}

}  // namespace sinew
