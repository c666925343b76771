// SPDX-License-Identifier: MIT
// Parts beyond all others along an axis, taken off one after the other.
#include "sinew_character/predict/scenery.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

constexpr double kOverlap = 0.1;         // of what is left along the axis: feet sink in, grass stands around them
constexpr double kLeastBelow = 0.5;      // of what is left, as areas across the axis: a pedestal
constexpr double kLeastBehind = 0.9;     // a backdrop; shields and tools are smaller
constexpr size_t kMostSceneryParts = 8;  // of a scenery, beside what lies within them
constexpr size_t kFewestVertices = 60;   // of a body

struct SceneryPart {
  Box box;
  size_t vertices = 0;
  bool taken = false;
};

std::array<std::array<double, 2>, 3> spans_of(const Box& box) {
  return {{{double{box.low.x}, double{box.high.x}},
           {double{box.low.y}, double{box.high.y}},
           {double{box.low.z}, double{box.high.z}}}};
}

Box joined(Box a, const Box& b) {
  a.add(b.low);
  a.add(b.high);
  return a;
}

// How large the part is across an axis along which it lies beyond all of `rest`, in shares of that; 0 where it is not, or is too small.
double share_beyond(const SceneryPart& part, const Box& rest, Axis up) {
  const auto own = spans_of(part.box), others = spans_of(rest);
  double most = 0;
  for (size_t a = 0; a < 3; ++a) {
    const double slack = kOverlap * (others[a][1] - others[a][0]);
    const bool before = own[a][1] <= others[a][0] + slack, behind = own[a][0] >= others[a][1] - slack;
    const bool upright = a == axis_index(up);
    if (!before && (upright || !behind)) continue;
    double share = 1;
    for (const size_t b : {(a + 1) % 3, (a + 2) % 3}) {
      const double common = std::min(own[b][1], others[b][1]) - std::max(own[b][0], others[b][0]);
      share *= std::max(0.0, common) / std::max(others[b][1] - others[b][0], 1e-30);
    }
    if (share >= (upright ? kLeastBelow : kLeastBehind)) most = std::max(most, share);
  }
  return most;
}

// The box of every part but one, of those that are left.
class BoxesOfOthers {
 public:
  explicit BoxesOfOthers(const std::vector<SceneryPart>& parts) : before_(parts.size()), after_(parts.size()) {
    for (size_t i = 1; i < parts.size(); ++i) before_[i] = with(before_[i - 1], parts[i - 1]);
    for (size_t i = parts.size(); i-- > 1;) after_[i - 1] = with(after_[i], parts[i]);
  }
  std::optional<Box> without(size_t i) const {
    if (!before_[i] || !after_[i]) return before_[i] ? before_[i] : after_[i];
    return joined(*before_[i], *after_[i]);
  }

 private:
  static std::optional<Box> with(const std::optional<Box>& box, const SceneryPart& part) {
    if (part.taken) return box;
    return box ? joined(*box, part.box) : part.box;
  }
  std::vector<std::optional<Box>> before_, after_;
};

}  // namespace

std::vector<uint8_t> find_scenery(const Character& mesh, Axis up) {
  const MeshParts found = connected_parts(mesh);
  std::vector<SceneryPart> parts(found.count);
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    SceneryPart& part = parts[found.part[v]];
    if (part.vertices++ == 0) part.box = {mesh.vertices[v], mesh.vertices[v]};
    part.box.add(mesh.vertices[v]);
  }
  size_t left = mesh.vertices.size();
  bool any = false;
  for (size_t round = 0; round < kMostSceneryParts; ++round) {
    const BoxesOfOthers others(parts);
    size_t best = parts.size();
    double share = 0;
    for (size_t i = 0; i < parts.size(); ++i) {
      const std::optional<Box> rest = others.without(i);
      if (parts[i].taken || !rest || 2 * parts[i].vertices >= left || left - parts[i].vertices < kFewestVertices)
        continue;
      const double own = share_beyond(parts[i], *rest, up);
      if (own <= share) continue;
      best = i;
      share = own;
    }
    if (best == parts.size()) break;
    parts[best].taken = any = true;
    left -= parts[best].vertices;
  }
  if (!any) return {};
  std::vector<uint8_t> scenery(mesh.vertices.size());
  for (size_t v = 0; v < scenery.size(); ++v) scenery[v] = parts[found.part[v]].taken ? 1 : 0;
  return scenery;
}

}  // namespace sinew
