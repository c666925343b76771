// SPDX-License-Identifier: MIT
// The files that belong to one character, and placing them in another folder without touching what is there.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sinew_data_sets/dedup.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace fs = std::filesystem;

namespace sinew {
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
  if (!document.is_object()) throw Error(path + ": not a glTF document, expected JSON");
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
    if (fs::exists(fs::symlink_status(to, failed))) throw Error(to.string() + ": is there already and is not replaced");
    fs::create_hard_link(from, to, failed);
    if (!failed) continue;
    fs::copy_file(from, to, failed);  // another disk, or a file system without links
    if (failed) throw Error(to.string() + ": cannot copy " + from.string() + " here: " + failed.message());
  }
}

}  // namespace sinew
