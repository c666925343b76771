// SPDX-License-Identifier: MIT
// tinyobjloader's reader of .mtl takes words into buffers of fixed size and says nothing of what it skips, so this is
// read here.
#include "text/mtl.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <unordered_map>

#include "files/picture_files.hpp"
#include "sinew_formats/base/lower_case.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"
#include "text/text_lines.hpp"

namespace fs = std::filesystem;

namespace sinew {
namespace {

// The line from word `first` on, blanks inside kept.
std::string rest_from(const TextLines& lines, size_t first) {
  if (first >= lines.words().size()) return "";
  const std::string_view line = lines.line();
  std::string rest(line.substr(static_cast<size_t>(lines.words()[first].data() - line.data())));
  rest.erase(rest.find_last_not_of(" \t\r\v\f") + 1);
  return rest;
}

// The file name behind the options of a map statement; those of offset and size have up to three numbers.
std::string picture_name(const TextLines& lines) {
  const auto& words = lines.words();
  size_t at = 1;
  while (at < words.size() && words[at].size() > 1 && words[at][0] == '-') {
    const std::string option = lower_case(words[at++]);
    const size_t most = option == "-o" || option == "-s" || option == "-t" ? 3 : option == "-mm" ? 2 : 1;
    const bool word_follows = option == "-imfchan" || option == "-type" || option == "-clamp" ||
                              option.rfind("-blend", 0) == 0 || option == "-cc";
    for (size_t i = 0; i < most && at < words.size() && (word_follows || to_finite_float(words[at])); ++i) ++at;
  }
  return rest_from(lines, at);
}

class MtlReader {
 public:
  MtlReader(const std::string& path, Character* character)
      : path_(path), character_(*character), pictures_(path, &character->notes) {
    for (size_t m = 0; m < character->material_names.size(); ++m) numbers_.emplace(character->material_names[m], m);
  }

  void read() {
    const std::string text = read_text_file(path_);
    TextLines lines(path_, text);
    while (lines.next()) {
      if (lines.words().empty() || lines.words()[0][0] == '#') continue;
      read_statement(lines);
    }
  }

 private:
  void read_statement(const TextLines& lines) {
    const std::string keyword = lower_case(lines.words()[0]);
    if (keyword == "newmtl") {
      const auto at = numbers_.find(rest_from(lines, 1));
      material_ = at == numbers_.end() ? nullptr : &character_.materials[at->second];  // the OBJ does not use it
      return;
    }
    if (material_ == nullptr) return;
    if (keyword == "kd") {
      if (const auto color = color_of(lines); color && !material_->base_color_texture)
        std::copy(color->begin(), color->end(), material_->base_color.begin());
    } else if (keyword == "ke") {
      if (const auto color = color_of(lines)) material_->emissive = *color;
    } else if (keyword == "d" || keyword == "tr") {
      const std::string_view word = lines.words().back();  // "d -halo 0.5"
      const std::optional<float> value = to_finite_float(word);
      if (!value) return complain(lines, "a number");
      material_->base_color[3] = std::clamp(keyword == "d" ? *value : 1 - *value, 0.0f, 1.0f);
    } else if (keyword == "map_kd") {
      material_->base_color_texture = pictures_.find(picture_name(lines));
      // Exporters write any Kd beside a picture, 0 0 0 among them; the picture is the color.
      if (material_->base_color_texture)
        material_->base_color[0] = material_->base_color[1] = material_->base_color[2] = 1;
    } else if (keyword == "norm" || keyword == "map_bump" || keyword == "bump") {
      const Picture picture = pictures_.find(picture_name(lines));
      if (!picture) return;
      if (is_gray(*picture))
        character_.notes.push_back(fs::path(path_).filename().string() + ": " + in_quotes(picture_name(lines)) +
                                   " is a height map, so it was left out; glTF needs a normal map");
      else
        material_->normal_texture = picture;
    }
  }

  void complain(const TextLines& lines, const char* expected) {
    character_.notes.push_back(fs::path(path_).filename().string() + ":" + std::to_string(lines.number()) +
                               ": expected " + expected + ", found " + in_quotes(lines.line()) + "; left out");
  }

  std::optional<std::array<float, 3>> color_of(const TextLines& lines) {
    const auto& words = lines.words();
    std::array<float, 3> color{};
    for (size_t c = 0; c < 3; ++c) {
      // One number is gray. "spectral" and "xyz" are other statements under this name.
      const std::optional<float> value =
          words.size() < 2 ? std::nullopt : to_finite_float(words[std::min(c + 1, words.size() - 1)]);
      if (!value) {
        complain(lines, "three numbers");
        return std::nullopt;
      }
      color[c] = std::clamp(*value, 0.0f, 1.0f);
    }
    return color;
  }

  std::string path_;
  Character& character_;
  PictureFiles pictures_;
  std::unordered_map<std::string, size_t> numbers_;
  Material* material_ = nullptr;
};

}  // namespace

void read_materials(const std::string& obj_path, const std::vector<std::string>& libraries, Character* character) {
  if (libraries.empty() || character->material_names.empty()) return;
  const fs::path folder = obj_path == "-" ? fs::path() : fs::path(obj_path).parent_path();
  character->materials.assign(character->material_names.size(), Material());
  for (const std::string& name : libraries) {
    std::string plain = name;
    std::replace(plain.begin(), plain.end(), '\\', '/');
    fs::path path = folder / plain;
    if (!is_file(path.string())) path = folder / fs::path(plain).filename();
    if (!is_file(path.string())) {
      character->notes.push_back("materials " + in_quotes(name) +
                                 " were not found; the output has their names without colors");
      continue;
    }
    MtlReader(path.string(), character).read();
  }
}

}  // namespace sinew
