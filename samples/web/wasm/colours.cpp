// SPDX-License-Identifier: MIT
// A value or a colour for each vertex, then for each that is shown.
#include "colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "sinew_character/draw/image.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::web {
namespace {

// Half of the sum over joints of |weight - the file's weight|: the share of a vertex that moves otherwise. [V]
std::vector<float> differences(const Session& s) {
  std::vector<float> values(s.character.vertices.size(), 0);
  for (size_t v = 0; v < values.size(); ++v) {
    std::map<uint32_t, float> sums;
    for (const Influence& influence : s.character.influences[v]) sums[influence.joint] += influence.weight;
    for (const Influence& influence : s.reference[v]) sums[influence.joint] -= influence.weight;
    for (const auto& [joint, weight] : sums) values[v] += std::abs(weight) / 2;
  }
  return values;
}

std::vector<float> field(const std::vector<std::vector<Influence>>& rows, uint32_t joint) {
  std::vector<float> values(rows.size(), 0);
  for (size_t v = 0; v < rows.size(); ++v)
    for (const Influence& influence : rows[v])
      if (influence.joint == joint) values[v] = influence.weight;
  return values;
}

// Where a joint has no weight the character stays as light as without a choice: the scale's dark end would hide its shape.
void lighten_unmoved(const std::vector<float>& weights, std::vector<std::array<uint8_t, 3>>* colours) {
  constexpr std::array<float, 3> kUnmoved = {168, 174, 182};
  constexpr float kShown = 0.25f;  // from this weight on the colour is the scale's
  for (size_t v = 0; v < weights.size(); ++v) {
    const float share = std::min(1.0f, weights[v] / kShown);
    for (size_t i = 0; i < 3; ++i) {
      const float own = (*colours)[v][i];
      (*colours)[v][i] = static_cast<uint8_t>(std::lround(kUnmoved[i] + share * (own - kUnmoved[i])));
    }
  }
}

}  // namespace

// Returns the mean of what is shown: of kDifference twice it is the L1 of the READMEs.
double colour(Session& s, ColourMode mode, uint32_t joint) {
  std::vector<std::array<uint8_t, 3>> of_vertex;
  std::vector<float> values;
  const bool is_artist =
      mode == ColourMode::kArtist || mode == ColourMode::kArtistField || mode == ColourMode::kDifference;
  if (is_artist && s.reference.empty())
    throw Error(s.character.name + ": the file has no weights of its own to compare with");
  if (mode == ColourMode::kJoints) {
    of_vertex = weight_colors(s.character);
  } else if (mode == ColourMode::kArtist) {
    std::swap(s.character.influences, s.reference);
    of_vertex = weight_colors(s.character);
    std::swap(s.character.influences, s.reference);
  } else {
    values.assign(s.character.vertices.size(), 0);
    if (mode == ColourMode::kField) values = field(s.character.influences, joint);
    if (mode == ColourMode::kArtistField) values = field(s.reference, joint);
    if (mode == ColourMode::kDifference) values = differences(s);
    for (size_t v = 0; v < values.size() && mode == ColourMode::kDoubt; ++v)
      values[v] = 1.0f - static_cast<float>(s.confidence[v]) / 255.0f;
    of_vertex = heat_colors(values, 1.0f);
    if (mode == ColourMode::kField || mode == ColourMode::kArtistField) lighten_unmoved(values, &of_vertex);
  }
  s.colours.clear();
  for (const uint32_t v : s.surface.vertex_of)
    s.colours.insert(s.colours.end(), of_vertex[v].begin(), of_vertex[v].end());
  double sum = 0;
  for (const float value : values) sum += static_cast<double>(value);
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

}  // namespace sinew::web
