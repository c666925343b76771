// SPDX-License-Identifier: MIT
// Surface to cells, cells to a blurred body, the body's surface.
#include "data/grown_shell.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

constexpr int kPad = 4;          // empty cells around
constexpr int kReach = 3;        // of the blur
constexpr double kBlur = 0.8;    // standard deviation, cells
constexpr float kLevel = 0.42f;  // of the surface: a little outside of where inside and outside weigh the same
constexpr uint32_t kNobody = 0xFFFFFFFFu;
constexpr uint32_t kMostSteps = 400;  // of a triangle's side

class ShellGrower {
 public:
  ShellGrower(const std::vector<Point3>& vertices, uint32_t cells) : vertices_(vertices) {
    Point3 high = low_ = vertices[0];
    for (const Point3& p : vertices) {
      for (size_t axis = 0; axis < 3; ++axis) {
        low_[axis] = std::min(low_[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
    double longest = 1e-30;
    for (size_t axis = 0; axis < 3; ++axis) longest = std::max(longest, high[axis] - low_[axis]);
    cell_ = longest / cells;
    for (size_t axis = 0; axis < 3; ++axis)
      size_[axis] = static_cast<int>(std::ceil((high[axis] - low_[axis]) / cell_)) + 2 * kPad + 1;
    steps_ = {1, size_[0], size_[0] * size_[1]};
    owner_.assign(static_cast<size_t>(steps_[2]) * static_cast<size_t>(size_[2]), kNobody);
  }

  GrownShell run(const std::vector<std::array<uint32_t, 3>>& triangles) {
    for (const auto& t : triangles) mark(t);
    close_gaps();
    fill();
    blur();
    spread_owners();
    make_vertices();
    for (int axis = 0; axis < 3; ++axis) make_faces(axis);
    return std::move(shell_);
  }

 private:
  size_t index(int x, int y, int z) const {
    return static_cast<size_t>(x) + static_cast<size_t>(y) * static_cast<size_t>(steps_[1]) +
           static_cast<size_t>(z) * static_cast<size_t>(steps_[2]);
  }
  // Calls use(index, x, y, z) for all cells that are `margin` away from the border.
  template <class Use>
  void each(int margin, Use&& use) const {
    for (int z = margin; z < size_[2] - margin; ++z)
      for (int y = margin; y < size_[1] - margin; ++y)
        for (int x = margin; x < size_[0] - margin; ++x) use(index(x, y, z), x, y, z);
  }
  bool any_neighbor(const std::vector<uint8_t>& cells, size_t at, uint8_t value) const {
    for (const int step : steps_) {
      if (cells[at - static_cast<size_t>(step)] == value || cells[at + static_cast<size_t>(step)] == value) return true;
    }
    return false;
  }

  // Samples of a triangle, two a cell; a cell belongs to the vertex that the first sample in it is nearest to.
  void mark(const std::array<uint32_t, 3>& t) {
    double longest = 0;
    for (size_t i = 0; i < 3; ++i) {
      double squared = 0;
      for (size_t axis = 0; axis < 3; ++axis) {
        const double d = vertices_[t[i]][axis] - vertices_[t[(i + 1) % 3]][axis];
        squared += d * d;
      }
      longest = std::max(longest, squared);
    }
    const auto m =
        std::clamp<uint32_t>(static_cast<uint32_t>(std::ceil(2 * std::sqrt(longest) / cell_)), 1, kMostSteps);
    for (uint32_t a = 0; a <= m; ++a) {
      for (uint32_t b = 0; a + b <= m; ++b) {
        const uint32_t c = m - a - b;
        int at[3];
        for (size_t axis = 0; axis < 3; ++axis) {
          const double p = (c * vertices_[t[0]][axis] + a * vertices_[t[1]][axis] + b * vertices_[t[2]][axis]) / m;
          at[axis] =
              std::clamp(static_cast<int>(std::floor((p - low_[axis]) / cell_)) + kPad, kPad, size_[axis] - kPad - 1);
        }
        uint32_t& owner = owner_[index(at[0], at[1], at[2])];
        if (owner == kNobody) owner = t[a >= b && a >= c ? 1 : b >= c ? 2 : 0];
      }
    }
  }

  // One step larger, then one smaller; what was surface stays.
  void close_gaps() {
    solid_.resize(owner_.size());
    for (size_t i = 0; i < solid_.size(); ++i) solid_[i] = owner_[i] == kNobody ? 0 : 1;
    std::vector<uint8_t> grown = solid_;
    each(1, [&](size_t i, int, int, int) {
      if (any_neighbor(solid_, i, 1)) grown[i] = 1;
    });
    each(1, [&](size_t i, int, int, int) {
      if (grown[i] != 0 && !any_neighbor(grown, i, 0)) solid_[i] = 1;
    });
  }

  // Cells that cannot be reached from the border over faces are solid.
  void fill() {
    std::vector<uint8_t> outside(solid_.size(), 1);  // the border counts as reached
    each(1, [&](size_t i, int, int, int) { outside[i] = 0; });
    std::vector<size_t> queue = {index(1, 1, 1)};
    outside[queue[0]] = 1;
    while (!queue.empty()) {
      const size_t at = queue.back();
      queue.pop_back();
      const auto reach = [&](size_t next) {
        if (outside[next] != 0 || solid_[next] != 0) return;
        outside[next] = 1;
        queue.push_back(next);
      };
      for (const int step : steps_) {
        reach(at - static_cast<size_t>(step));
        reach(at + static_cast<size_t>(step));
      }
    }
    for (size_t i = 0; i < solid_.size(); ++i) solid_[i] = outside[i] == 0 ? 1 : 0;
  }

  void blur() {
    float kernel[2 * kReach + 1], sum = 0;
    for (int i = -kReach; i <= kReach; ++i)
      sum += kernel[i + kReach] = static_cast<float>(std::exp(-0.5 * i * i / (kBlur * kBlur)));
    for (float& k : kernel) k /= sum;
    field_.assign(solid_.begin(), solid_.end());
    std::vector<float> from;
    for (const int step : steps_) {
      from = field_;
      each(kReach, [&](size_t i, int, int, int) {
        const float* const middle = from.data() + i;
        float value = 0;
        for (int k = -kReach; k <= kReach; ++k) value += kernel[k + kReach] * middle[k * step];
        field_[i] = value;
      });
    }
  }

  // Cells without an owner take that of the nearest cell, in steps over faces.
  void spread_owners() {
    std::vector<size_t> now, next;
    each(1, [&](size_t i, int, int, int) {
      if (owner_[i] != kNobody) now.push_back(i);
    });
    while (!now.empty()) {
      next.clear();
      for (const size_t at : now) {
        for (const int step : steps_) {
          for (const size_t beside : {at - static_cast<size_t>(step), at + static_cast<size_t>(step)}) {
            if (beside >= owner_.size() || owner_[beside] != kNobody) continue;
            owner_[beside] = owner_[at];
            // Nothing of the surface is further from the cells that were marked than this.
            if (field_[beside] > 0) next.push_back(beside);
          }
        }
      }
      now.swap(next);
    }
  }

  // A vertex for every cube of eight cells' middles that the surface passes: the mean of where it crosses the cube's edges.
  void make_vertices() {
    number_.assign(owner_.size(), kNobody);
    for (int z = 0; z + 1 < size_[2]; ++z)
      for (int y = 0; y + 1 < size_[1]; ++y)
        for (int x = 0; x + 1 < size_[0]; ++x) add_vertex(x, y, z);
  }
  void add_vertex(int x, int y, int z) {
    const size_t base = index(x, y, z);
    size_t corner[8];
    uint32_t inside = 0;
    for (uint32_t c = 0; c < 8; ++c) {
      corner[c] =
          base + (c & 1) + ((c >> 1) & 1) * static_cast<size_t>(steps_[1]) + (c >> 2) * static_cast<size_t>(steps_[2]);
      inside |= static_cast<uint32_t>(field_[corner[c]] > kLevel) << c;
    }
    if (inside == 0 || inside == 255) return;
    double sum[3] = {}, count = 0;
    for (uint32_t c = 0; c < 8; ++c) {
      for (uint32_t axis = 0; axis < 3; ++axis) {
        const uint32_t d = c | (1u << axis);
        if (d == c || ((inside >> c) & 1) == ((inside >> d) & 1)) continue;
        const float a = field_[corner[c]], b = field_[corner[d]];
        for (uint32_t k = 0; k < 3; ++k)
          sum[k] += k == axis ? static_cast<double>((kLevel - a) / (b - a)) : (c >> k) & 1;
        count += 1;
      }
    }
    const int at[3] = {x, y, z};
    Point3 p;
    for (size_t k = 0; k < 3; ++k) p[k] = (at[k] - kPad + 0.5 + sum[k] / count) * cell_ + low_[k];
    uint32_t owner = kNobody;
    for (uint32_t c = 0; c < 8 && owner == kNobody; ++c) owner = owner_[corner[c]];
    number_[base] = static_cast<uint32_t>(shell_.vertices.size());
    shell_.vertices.push_back(p);
    shell_.source.push_back(owner == kNobody ? 0 : owner);
  }

  // Every edge between two cells along an axis that the surface crosses is in the middle of four cubes.
  void make_faces(int axis) {
    const size_t step = static_cast<size_t>(steps_[static_cast<size_t>(axis)]);
    const size_t u = static_cast<size_t>(steps_[static_cast<size_t>((axis + 1) % 3)]);
    const size_t v = static_cast<size_t>(steps_[static_cast<size_t>((axis + 2) % 3)]);
    each(1, [&](size_t i, int, int, int) {
      const bool here = field_[i] > kLevel, there = field_[i + step] > kLevel;
      if (here == there) return;
      uint32_t quad[4] = {number_[i - u - v], number_[i - v], number_[i], number_[i - u]};
      if (!here) std::swap(quad[1], quad[3]);
      shell_.triangles.push_back({quad[0], quad[1], quad[2]});
      shell_.triangles.push_back({quad[0], quad[2], quad[3]});
    });
  }

  const std::vector<Point3>& vertices_;
  Point3 low_;
  double cell_ = 0;
  std::array<int, 3> size_, steps_;  // cells; from a cell to the next along an axis
  std::vector<uint32_t> owner_;      // [cells] vertex, or kNobody
  std::vector<uint8_t> solid_;       // [cells]
  std::vector<float> field_;         // [cells] 0 to 1
  std::vector<uint32_t> number_;     // [cells] vertex of the cube whose lowest corner it is
  GrownShell shell_;
};

}  // namespace

GrownShell grow_shell(const std::vector<Point3>& vertices, const std::vector<std::array<uint32_t, 3>>& triangles,
                      uint32_t cells) {
  return ShellGrower(vertices, cells).run(triangles);
}

}  // namespace sinew
