// SPDX-License-Identifier: MIT
// Wavefront OBJ to Character and back. tinyobjloader reads; because it takes malformed lines in silence (a bad number
// is 0, a bad index is dropped), every line is checked here first, so that a wrong file is refused with its line.
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <string_view>
#include <unordered_map>

#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "text/decimal.hpp"
#include "text/mtl.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

// Statements of the OBJ specification (and `tw`, `vw` and `t` of common tools) that say nothing about faces.
constexpr std::string_view kOtherStatements[] = {
    "g",    "o",    "s",     "usemtl", "l",          "p",         "vp",      "cstype", "deg", "bmat",
    "step", "curv", "curv2", "surf",   "parm",       "trim",      "hole",    "scrv",   "sp",  "end",
    "con",  "mg",   "bevel", "lod",    "c_interp",   "usemap",    "t",       "tw",     "vw",  "maplib",
    "call", "csh",  "ctech", "stech",  "shadow_obj", "trace_obj", "d_interp"};

struct ObjCounts {
  size_t vertices = 0, uvs = 0, normals = 0, corners = 0, faces = 0;
};

// One number of a corner "v/vt/vn"; positive numbers may point forward, so they are compared with the totals at the
// end.
struct LargestIndex {
  int64_t value = 0;
  size_t line = 0;
  std::string word;
};

void check_index(const TextLines& lines, std::string_view corner, std::string_view word, const char* what, size_t count,
                 LargestIndex* largest) {
  const std::optional<int64_t> index = to_integer(word);
  if (!index) lines.fail(std::string("a ") + what + " number in the corner", corner);
  if (*index == 0) lines.fail(std::string("a ") + what + " number from 1 or below 0 in the corner", corner);
  if (*index < 0 && static_cast<uint64_t>(-(*index + 1)) >= count)
    lines.fail(std::string("a ") + what + " number no further back than -" + std::to_string(count), corner);
  if (*index > INT32_MAX) lines.fail(std::string("a ") + what + " number below 2^31", corner);
  if (*index > largest->value) *largest = {*index, lines.number(), std::string(corner)};
}

void check_numbers(const TextLines& lines, size_t fewest, size_t most) {
  const auto& words = lines.words();
  if (words.size() - 1 < fewest || words.size() - 1 > most) {
    lines.fail(std::to_string(fewest) + (most > fewest ? " to " + std::to_string(most) : "") + " numbers after '" +
                   std::string(words[0]) + "'",
               lines.line());
  }
  for (size_t i = 1; i < words.size(); ++i)
    if (!to_finite_float(words[i])) lines.fail("a finite number after '" + std::string(words[0]) + "'", words[i]);
}

// Joins lines that end in a backslash, which tinyobjloader does not know. The line ends are put back after the
// statement, so that line numbers stay nearly right.
std::string join_continued_lines(const std::string& text) {
  std::string out;
  out.reserve(text.size());
  size_t owed = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      const size_t skip = text.compare(i + 1, 2, "\r\n") == 0 ? 2 : text.compare(i + 1, 1, "\n") == 0 ? 1 : 0;
      if (skip != 0) {
        out += ' ';
        ++owed;
        i += skip;
        continue;
      }
    }
    out += text[i];
    if (text[i] == '\n' && owed != 0) {
      out.append(owed, '\n');
      owed = 0;
    }
  }
  return out;
}

// Data that the loader drops.
struct ObjExtras {
  std::vector<std::array<float, 3>> colors;  // [V] once a vertex has one; white where it has none
  std::vector<std::string> libraries;        // after mtllib
  std::string unknown;                       // the first statement that no OBJ has, with its line
  size_t unknown_count = 0;
};

// Colors of vertices are written as screens show them (sRGB); glTF wants light (IEC 61966-2-1).
float linear_light(float shown) {
  const float value = std::clamp(shown, 0.0f, 1.0f);
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

void read_color(const std::vector<std::string_view>& words, size_t vertex, ObjExtras* extras) {
  if (words.size() < 7) return;  // "v x y z r g b", perhaps with an opacity
  extras->colors.resize(vertex, {1, 1, 1});
  std::array<float, 3> color{};
  for (size_t c = 0; c < 3; ++c) color[c] = linear_light(to_finite_float(words[c + 4]).value_or(1.0f));
  extras->colors.push_back(color);
}

// File names may hold blanks: the words after mtllib are one name, unless it takes several to end in .mtl each.
void read_libraries(const std::vector<std::string_view>& words, ObjExtras* extras) {
  std::string name;
  for (size_t i = 1; i < words.size(); ++i) {
    name.append(name.empty() ? "" : " ").append(words[i]);
    if (i + 1 < words.size() && !has_extension(name, ".mtl")) continue;
    if (std::find(extras->libraries.begin(), extras->libraries.end(), name) == extras->libraries.end())
      extras->libraries.push_back(name);
    name.clear();
  }
}

ObjCounts check_lines(const std::string& name, std::string_view text, ObjExtras* extras) {
  ObjCounts counts;
  LargestIndex vertex, uv, normal;
  TextLines lines(name, text);
  while (lines.next()) {
    const auto& words = lines.words();
    if (words.empty() || words[0][0] == '#') continue;
    const std::string_view keyword = words[0];
    if (keyword == "v") {
      check_numbers(lines, 3, 7);  // w or a color may follow
      read_color(words, counts.vertices, extras);
      ++counts.vertices;
    } else if (keyword == "vt") {
      check_numbers(lines, 1, 3);
      ++counts.uvs;
    } else if (keyword == "vn") {
      check_numbers(lines, 3, 3);
      ++counts.normals;
    } else if (keyword == "f") {
      if (words.size() < 4) lines.fail("at least 3 corners after 'f'", lines.line());
      for (size_t i = 1; i < words.size(); ++i) {
        const std::string_view corner = words[i];
        const size_t first = corner.find('/');
        check_index(lines, corner, corner.substr(0, first), "vertex", counts.vertices, &vertex);
        if (first == std::string_view::npos) continue;
        const std::string_view rest = corner.substr(first + 1);
        const size_t second = rest.find('/');
        if (second != 0) check_index(lines, corner, rest.substr(0, second), "texture coordinate", counts.uvs, &uv);
        if (second != std::string_view::npos)
          check_index(lines, corner, rest.substr(second + 1), "normal", counts.normals, &normal);
      }
      counts.corners += words.size() - 1;
      ++counts.faces;
    } else if (keyword == "mtllib") {
      read_libraries(words, extras);
    } else if (std::find(std::begin(kOtherStatements), std::end(kOtherStatements), keyword) ==
               std::end(kOtherStatements)) {
      // A word may be an exporter's own statement; anything else is no OBJ.
      if (!std::all_of(keyword.begin(), keyword.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; }) ||
          !std::isalpha(static_cast<unsigned char>(keyword[0])))
        lines.fail("an OBJ statement (v, vt, vn, f, g, o, ...)", keyword);
      if (extras->unknown_count++ == 0)
        extras->unknown = "'" + std::string(keyword) + "' in line " + std::to_string(lines.number());
    }
  }
  const auto check_largest = [&](const LargestIndex& largest, const char* what, size_t count) {
    if (static_cast<uint64_t>(largest.value) > count)
      lines.fail_at(largest.line,
                    std::string("a ") + what + " number up to " + std::to_string(count) + " in the corner",
                    largest.word);
  };
  check_largest(vertex, "vertex", counts.vertices);
  check_largest(uv, "texture coordinate", counts.uvs);
  check_largest(normal, "normal", counts.normals);
  if (counts.vertices == 0)
    throw Error(name + ": expected an OBJ with vertices ('v x y z'), found none in " + std::to_string(lines.number()) +
                " lines");
  return counts;
}

constexpr int64_t kNotGiven = -1;

// Data that the loader's callbacks fill, in the file's order.
struct ObjCollector {
  Character* character = nullptr;
  std::vector<std::array<float, 2>> uvs;
  std::vector<Vec3> normals;
  std::vector<int64_t> corner_uvs, corner_normals;  // [corners] numbers from 0: a face may come before what it names
  std::unordered_map<std::string, int> materials, groups, objects;
  int material = -1, group = -1, object = -1;
};

int number_of(std::string name, std::unordered_map<std::string, int>* numbers, std::vector<std::string>* names) {
  name.erase(name.find_last_not_of(" \t") + 1);
  name.erase(0, name.find_first_not_of(" \t"));
  if (name.empty()) return -1;
  const auto [at, is_new] = numbers->emplace(name, static_cast<int>(names->size()));
  if (is_new) names->push_back(name);
  return at->second;
}

// In the loader's callbacks 0 is "not given" and negative numbers count back from the last element so far.
int64_t resolve(int index, size_t count) {
  if (index == 0) return kNotGiven;
  return index > 0 ? index - 1 : static_cast<int64_t>(count) + index;
}

// The loader makes NaN of "0e999", a zero that check_numbers() let pass.
float number(float loaded) { return std::isfinite(loaded) ? loaded : 0.0f; }

void add_face(ObjCollector* to, const tinyobj::index_t* corners, int count) {
  Character& character = *to->character;
  for (int i = 0; i < count; ++i) {
    character.face_vertices.push_back(
        static_cast<uint32_t>(resolve(corners[i].vertex_index, character.vertices.size())));
    to->corner_uvs.push_back(resolve(corners[i].texcoord_index, to->uvs.size()));
    to->corner_normals.push_back(resolve(corners[i].normal_index, to->normals.size()));
  }
  character.face_offsets.push_back(static_cast<uint32_t>(character.face_vertices.size()));
  character.face_materials.push_back(to->material);
  character.face_groups.push_back(to->group);
  character.face_objects.push_back(to->object);
}

tinyobj::callback_t collector_callbacks() {
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = [](void* to, float x, float y, float z, float) {
    static_cast<ObjCollector*>(to)->character->vertices.push_back({number(x), number(y), number(z)});
  };
  callbacks.normal_cb = [](void* to, float x, float y, float z) {
    static_cast<ObjCollector*>(to)->normals.push_back({number(x), number(y), number(z)});
  };
  callbacks.texcoord_cb = [](void* to, float u, float v, float) {
    static_cast<ObjCollector*>(to)->uvs.push_back({number(u), number(v)});
  };
  callbacks.index_cb = [](void* to, tinyobj::index_t* corners, int count) {
    add_face(static_cast<ObjCollector*>(to), corners, count);
  };
  callbacks.usemtl_cb = [](void* to, const char* name, int) {
    ObjCollector& collector = *static_cast<ObjCollector*>(to);
    collector.material = number_of(name, &collector.materials, &collector.character->material_names);
  };
  callbacks.group_cb = [](void* to, const char** names, int count) {
    ObjCollector& collector = *static_cast<ObjCollector*>(to);
    std::string joined;
    for (int i = 0; i < count; ++i) joined.append(i != 0 ? " " : "").append(names[i]);
    collector.group = number_of(joined, &collector.groups, &collector.character->group_names);
  };
  callbacks.object_cb = [](void* to, const char* name) {
    ObjCollector& collector = *static_cast<ObjCollector*>(to);
    collector.group = number_of(name, &collector.groups, &collector.character->group_names);
    collector.object = number_of(name, &collector.objects, &collector.character->object_names);
  };
  return callbacks;
}

// Drops what no face uses, and resolves the indices to values. Corners without a value get 0.
void finish(ObjCollector* from) {
  Character& character = *from->character;
  const auto given = [](int64_t index) { return index != kNotGiven; };
  if (std::any_of(from->corner_uvs.begin(), from->corner_uvs.end(), given))
    for (const int64_t index : from->corner_uvs)
      character.corner_uvs.push_back(given(index) ? from->uvs[static_cast<size_t>(index)] : std::array<float, 2>{0, 0});
  if (std::any_of(from->corner_normals.begin(), from->corner_normals.end(), given))
    for (const int64_t index : from->corner_normals)
      character.corner_normals.push_back(given(index) ? from->normals[static_cast<size_t>(index)] : Vec3{0, 0, 0});
  if (character.material_names.empty()) character.face_materials.clear();
  if (character.group_names.empty()) character.face_groups.clear();
  if (character.object_names.empty()) {
    character.object_names = character.group_names;
    character.face_objects = character.face_groups;
  }
}

void append_number(std::string* out, float value) {
  *out += ' ';
  *out += shortest_decimal(value);
}

// Numbers of distinct values, from 1, in the order of their first use. Distinct by their bits: 0 and -0 are two.
template <size_t N>
class Numbering {
 public:
  size_t add(const std::array<float, N>& value, const char* keyword, std::string* out) {
    std::array<uint32_t, N> bits;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(bits.data(), value.data(), sizeof bits);  // Debian 12's Emscripten has no std::bit_cast
    const auto [at, is_new] = numbers_.emplace(bits, numbers_.size() + 1);
    if (is_new) {
      *out += keyword;
      for (const float x : value) append_number(out, x);
      *out += '\n';
    }
    return at->second;
  }

 private:
  std::map<std::array<uint32_t, N>, size_t> numbers_;
};

}  // namespace

Character read_obj(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  const std::string name = path == "-" ? "standard input" : path;
  std::string text(bytes.begin(), bytes.end());
  if (text.compare(0, 3, "\xef\xbb\xbf") == 0) text.erase(0, 3);  // byte order mark
  if (text.empty()) throw Error(name + ": expected an OBJ file, found an empty file");
  if (text.find('\0') != std::string::npos)
    throw Error(name + ": expected an OBJ text file, found binary data (a zero byte)");
  if (text.find('\\') != std::string::npos) text = join_continued_lines(text);
  // They part words here; the loader takes them for letters.
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\f' || c == '\v'; }, ' ');
  ObjExtras extras;
  const ObjCounts counts = check_lines(name, text, &extras);

  Character character;
  character.name = stem_of(path);
  character.vertices.reserve(counts.vertices);
  character.face_offsets.reserve(counts.faces + 1);
  character.face_vertices.reserve(counts.corners);
  ObjCollector collector;
  collector.character = &character;
  std::istringstream stream(text);
  std::string problem;
  const bool ok = tinyobj::LoadObjWithCallback(stream, collector_callbacks(), &collector, nullptr, nullptr, &problem);
  if (!ok || character.vertices.size() != counts.vertices || character.face_count() != counts.faces ||
      character.face_vertices.size() != counts.corners || collector.uvs.size() != counts.uvs ||
      collector.normals.size() != counts.normals)
    throw Error(name + ": expected " + std::to_string(counts.vertices) + " vertices and " +
                std::to_string(counts.faces) + " faces, tinyobjloader found " +
                std::to_string(character.vertices.size()) + " and " + std::to_string(character.face_count()) + " " +
                problem);
  finish(&collector);
  if (!extras.colors.empty()) {
    extras.colors.resize(counts.vertices, {1, 1, 1});
    character.vertex_colors = std::move(extras.colors);
  }
  if (extras.unknown_count > 0)
    character.notes.push_back(
        "no OBJ has the statement " + extras.unknown + ", left out" +
        (extras.unknown_count == 1 ? "" : " as " + std::to_string(extras.unknown_count - 1) + " more lines"));
  read_materials(path, extras.libraries, &character);
  return character;
}

namespace {

// A name as the rest of a line. OBJ has no escapes: a line break would begin a statement, and a backslash at the end
// would swallow the next one.
std::string rest_of_line(std::string name) {
  for (char& c : name) c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  for (size_t i = name.size(); i > 0 && (name[i - 1] == '\\' || name[i - 1] == ' '); --i) name[i - 1] = '_';
  return name;
}

}  // namespace

void write_obj(const std::string& path, const Character& character) {
  std::string out = "# sinew\n";
  out.reserve(character.vertices.size() * 32 + character.face_vertices.size() * 12);
  for (const Vec3& p : character.vertices) {
    out += 'v';
    for (const float x : {p.x, p.y, p.z}) append_number(&out, x);
    out += '\n';
  }
  const size_t corner_count = character.face_vertices.size();
  const bool has_uvs = character.corner_uvs.size() == corner_count && corner_count != 0;
  const bool has_normals = character.corner_normals.size() == corner_count && corner_count != 0;
  std::vector<size_t> uv_numbers, normal_numbers;
  Numbering<2> uvs;
  Numbering<3> normals;
  if (has_uvs)
    for (const auto& uv : character.corner_uvs) uv_numbers.push_back(uvs.add(uv, "vt", &out));
  if (has_normals)
    for (const Vec3& n : character.corner_normals) normal_numbers.push_back(normals.add({n.x, n.y, n.z}, "vn", &out));

  const bool has_groups = character.face_groups.size() == character.face_count();
  const bool has_materials = character.face_materials.size() == character.face_count();
  int group = -1, material = -1;
  for (size_t f = 0; f < character.face_count(); ++f) {
    if (has_groups && character.face_groups[f] != group) {
      group = character.face_groups[f];
      out += group < 0 ? "g\n" : "g " + rest_of_line(character.group_names[static_cast<size_t>(group)]) + "\n";
    }
    if (has_materials && character.face_materials[f] != material) {
      material = character.face_materials[f];
      if (material >= 0) {
        out += "usemtl " + rest_of_line(character.material_names[static_cast<size_t>(material)]) + "\n";
      }
    }
    out += 'f';
    for (size_t c = character.face_offsets[f]; c < character.face_offsets[f + 1]; ++c) {
      out += ' ' + std::to_string(character.face_vertices[c] + 1);
      if (has_uvs) out += '/' + std::to_string(uv_numbers[c]);
      if (has_normals) out += (has_uvs ? "/" : "//") + std::to_string(normal_numbers[c]);
    }
    out += '\n';
  }
  write_text_file(path, out);
}

}  // namespace sinew
