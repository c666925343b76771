// SPDX-License-Identifier: MIT
#include "springs/sections.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sinew_character/rig/mesh_surface.hpp"

namespace sinew {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr size_t kBins = 72;  // of a full circle

}  // namespace

double angle_of(const Point2& direction) {
  const double turns = std::atan2(direction[0], direction[1]) / kTurn;
  return turns < 0 ? turns + 1 : turns;
}

double SectionCurve::covered_turn(const Point2& middle) const {
  std::array<uint8_t, kBins> bins{};
  for (const auto& segment : segments) {
    const double from = angle_of(segment[0] - middle), to = angle_of(segment[1] - middle);
    double step = to - from;  // the shorter arc
    step -= std::round(step);
    const auto count = static_cast<size_t>(std::abs(step) * kBins) + 1;
    for (size_t i = 0; i <= count; ++i) {
      double at = from + step * static_cast<double>(i) / static_cast<double>(count);
      at -= std::floor(at);
      bins[std::min(kBins - 1, static_cast<size_t>(at * kBins))] = 1;
    }
  }
  return static_cast<double>(std::count(bins.begin(), bins.end(), 1)) / static_cast<double>(kBins);
}

double SectionCurve::total_length() const {
  double sum = 0;
  for (const auto& segment : segments) sum += length(segment[1] - segment[0]);
  return sum;
}

double SectionCurve::mean_distance(const Point2& middle) const {
  double sum = 0, weight = 0;
  for (const auto& segment : segments) {
    const double size = length(segment[1] - segment[0]);
    sum += size * 0.5 * (length(segment[0] - middle) + length(segment[1] - middle));
    weight += size;
  }
  return weight > 0 ? sum / weight : 0;
}

SectionedMesh::SectionedMesh(const Character& character, const Point3& left, const Point3& front, const Point3& up)
    : left_(left), front_(front), up_(up), triangles_(fan_triangles(character)), first_(first_at_position(character)) {
  for (const Vec3& v : character.vertices) {
    heights_.push_back(height(point(v)));
    across_.push_back(across(point(v)));
  }
}

std::vector<std::vector<SectionCurve>> SectionedMesh::sections(double top, double bottom, size_t count) const {
  struct Cut {
    std::array<uint32_t, 2> edges;
    std::array<Point2, 2> segment;
    uint32_t triangle;
  };
  const double step = (top - bottom) / static_cast<double>(count - 1);
  std::vector<std::vector<Cut>> cuts(count);
  std::vector<std::map<std::pair<uint32_t, uint32_t>, uint32_t>> edges(count);
  for (uint32_t t = 0; t < triangles_.size(); ++t) {
    const auto& corners = triangles_[t];
    double low = heights_[corners[0]], high = low;
    for (const uint32_t v : corners) {
      low = std::min(low, heights_[v]);
      high = std::max(high, heights_[v]);
    }
    const double from = std::max(0.0, std::ceil((top - high) / step)),
                 to = std::min(static_cast<double>(count - 1), std::floor((top - low) / step));
    for (double k = from; k <= to; k += 1) {
      const double level = top - k * step;
      const auto at = static_cast<size_t>(k);
      Cut cut{};
      size_t found = 0;
      for (size_t i = 0; i < 3 && found < 2; ++i) {
        const uint32_t a = corners[i], b = corners[(i + 1) % 3];
        if ((heights_[a] < level) == (heights_[b] < level)) continue;
        const double share = (level - heights_[a]) / (heights_[b] - heights_[a]);
        for (size_t axis = 0; axis < 2; ++axis)
          cut.segment[found][axis] = across_[a][axis] + share * (across_[b][axis] - across_[a][axis]);
        const auto key = std::minmax(first_[a], first_[b]);
        cut.edges[found] =
            edges[at].emplace(std::pair(key.first, key.second), static_cast<uint32_t>(edges[at].size())).first->second;
        ++found;
      }
      if (found < 2) continue;
      cut.triangle = t;
      cuts[at].push_back(cut);
    }
  }
  std::vector<std::vector<SectionCurve>> out(count);
  for (size_t k = 0; k < count; ++k) {
    VertexGroups groups(edges[k].size());
    for (const Cut& cut : cuts[k]) groups.join(cut.edges[0], cut.edges[1]);
    std::map<uint32_t, size_t> number;
    for (const Cut& cut : cuts[k]) {
      const size_t curve = number.emplace(groups.of(cut.edges[0]), number.size()).first->second;
      if (curve == out[k].size()) out[k].emplace_back();
      out[k][curve].segments.push_back(cut.segment);
      out[k][curve].triangles.push_back(cut.triangle);
    }
  }
  return out;
}

}  // namespace sinew
