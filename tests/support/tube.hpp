// SPDX-License-Identifier: MIT
// A bound tube and what a check finds on it, for tests of what is done with characters of a data set.
#ifndef SINEW_TESTS_TUBE_HPP
#define SINEW_TESTS_TUBE_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_data_sets/dataset.hpp"
#include "sinew_formats/character.hpp"

inline void add_face(sinew::Character* c, std::vector<uint32_t> corners) {
  c->face_vertices.insert(c->face_vertices.end(), corners.begin(), corners.end());
  c->face_offsets.push_back(static_cast<uint32_t>(c->face_vertices.size()));
}

// A tube of quads around Y, open at both ends, with two joints and smooth weights.
inline sinew::Character tube(uint32_t around = 16, uint32_t rings = 20) {
  sinew::Character c;
  c.name = "tube";
  c.joints = {{"low", {0, 0, 0}, -1}, {"high", {0, 2, 0}, 0}};
  for (uint32_t r = 0; r < rings; ++r)
    for (uint32_t a = 0; a < around; ++a) {
      const double t = 6.283185307179586 * a / around, y = 4.0 * r / (rings - 1);
      c.vertices.push_back({static_cast<float>(std::cos(t)), static_cast<float>(y), static_cast<float>(std::sin(t))});
      c.influences.push_back({{0, static_cast<float>(1 - y / 4)}, {1, static_cast<float>(y / 4)}});
    }
  for (uint32_t r = 0; r + 1 < rings; ++r)
    for (uint32_t a = 0; a < around; ++a) {
      const uint32_t b = (a + 1) % around;
      add_face(&c, {r * around + a, (r + 1) * around + a, (r + 1) * around + b, r * around + b});
    }
  return c;
}

inline bool has(const sinew::CheckReport& report, const std::string& code) {
  return std::any_of(report.findings.begin(), report.findings.end(),
                     [&](const sinew::CheckFinding& f) { return f.code == code; });
}

inline bool has_more_than_notes(const sinew::CheckReport& report) {
  return std::any_of(report.findings.begin(), report.findings.end(),
                     [](const sinew::CheckFinding& f) { return f.level != sinew::CheckFinding::Level::kNote; });
}

#endif
