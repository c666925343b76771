// SPDX-License-Identifier: MIT
// What the targets of file readers share: the input as a file, the form of a refusal, and what an accepted character
// promises to the rest of the tools.
#ifndef SINEW_TESTS_FUZZ_READER_CHECKS_HPP
#define SINEW_TESTS_FUZZ_READER_CHECKS_HPP

#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "fuzz.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/error.hpp"
#include "temp_folder.hpp"

namespace sinew::test {

// The input as a file in a folder of its own, the same for all inputs of a process.
inline std::string input_file(const uint8_t* data, size_t size, const char* name) {
  static const TempFolder folder;
  return folder.write(name, {reinterpret_cast<const char*>(data), size});
}

// One line, beginning with the file, saying what was expected or what cannot be done.
inline void check_refusal(const std::string& text, const std::string& path) {
  demand(text.rfind(path, 0) == 0, "an error begins with its file: " + text);
  demand(text.size() <= path.size() + 1000, "an error is short: " + std::to_string(text.size()) + " bytes");
  for (const char c : text)
    demand(static_cast<unsigned char>(c) >= 32 && c != 127, "an error is one line of printable text: " + text);
  bool says = false;
  for (const char* word : {"expected", "cannot", "truncated"}) says = says || text.find(word) != std::string::npos;
  demand(says, "an error says what was expected: " + text);
}

// The character that `read` returns, or nothing when it refuses as it should.
inline std::optional<Character> read_or_refuse(const std::string& path, const std::function<Character()>& read) {
  try {
    return read();
  } catch (const Error& error) {
    check_refusal(error.what(), path);
    return std::nullopt;
  }
}

inline bool is_finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

inline void check_joints(const Character& c) {
  std::set<std::string> names;
  for (const Joint& joint : c.joints) {
    demand(is_finite(joint.position), "joint positions are finite");
    demand(names.insert(joint.name).second, "joint names are unique");
    demand(joint.parent >= -1 && joint.parent < static_cast<int>(c.joints.size()), "parents exist");
    size_t steps = 0;
    for (int j = joint.parent; j >= 0; j = c.joints[static_cast<size_t>(j)].parent)
      demand(++steps <= c.joints.size(), "joints form a tree");
  }
  demand(c.influences.empty() || c.influences.size() == c.vertices.size(), "a row of influences per vertex");
  for (const auto& row : c.influences) {
    std::set<uint32_t> seen;
    for (const Influence& influence : row) {
      demand(influence.joint < c.joints.size(), "influences name joints that exist");
      demand(std::isfinite(influence.weight) && influence.weight >= 0, "weights are finite and not negative");
      demand(seen.insert(influence.joint).second, "no joint twice in a row");
    }
  }
}

inline void check_character(const Character& c) {
  const size_t corners = c.face_vertices.size(), faces = c.face_count();
  demand(!c.vertices.empty(), "a mesh has vertices");
  for (const Vec3& p : c.vertices) demand(is_finite(p), "positions are finite");
  demand(c.face_offsets[0] == 0 && c.face_offsets.back() == corners, "face offsets span the corners");
  for (size_t f = 0; f < faces; ++f) demand(c.face_offsets[f] + 3 <= c.face_offsets[f + 1], "a face has 3 corners");
  for (const uint32_t v : c.face_vertices) demand(v < c.vertices.size(), "corners name vertices that exist");
  demand(c.corner_uvs.empty() || c.corner_uvs.size() == corners, "a texture coordinate per corner");
  demand(c.corner_normals.empty() || c.corner_normals.size() == corners, "a normal per corner");
  demand(c.face_materials.empty() || c.face_materials.size() == faces, "a material per face");
  demand(c.face_groups.empty() || c.face_groups.size() == faces, "a group per face");
  for (const int m : c.face_materials)
    demand(m >= -1 && m < static_cast<int>(c.material_names.size()), "materials exist");
  for (const int g : c.face_groups) demand(g >= -1 && g < static_cast<int>(c.group_names.size()), "groups exist");
  check_joints(c);
}

inline bool same_points(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0);
}
inline bool same_joints(const Character& a, const Character& b) {
  bool same = a.joints.size() == b.joints.size() && a.influences.size() == b.influences.size();
  for (size_t j = 0; same && j < a.joints.size(); ++j) {
    const Joint &x = a.joints[j], &y = b.joints[j];
    same = x.name == y.name && x.parent == y.parent && std::memcmp(&x.position, &y.position, sizeof x.position) == 0;
  }
  for (size_t v = 0; same && v < a.influences.size(); ++v) {
    same = a.influences[v].size() == b.influences[v].size();
    for (size_t i = 0; same && i < a.influences[v].size(); ++i)
      same = a.influences[v][i].joint == b.influences[v][i].joint &&
             a.influences[v][i].weight == b.influences[v][i].weight;
  }
  return same;
}
inline bool same_mesh(const Character& a, const Character& b) {
  return same_points(a.vertices, b.vertices) && a.face_offsets == b.face_offsets && a.face_vertices == b.face_vertices;
}

}  // namespace sinew::test
#endif
