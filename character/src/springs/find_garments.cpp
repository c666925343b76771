// SPDX-License-Identifier: MIT
// Garments by cross-sections below the hips and behind the trunk.
#include "springs/find_garments.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "motion/upright_body.hpp"
#include "sinew/sinew.h"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/median.hpp"
#include "springs/body_skin.hpp"
#include "springs/sections.hpp"

namespace sinew {
namespace {

constexpr size_t kLevels = 65;       // from the hips to the floor, and from the shoulders
constexpr size_t kRows = 3;          // joints of a line
constexpr double kAround = 0.6;      // of a turn around both legs a skirt covers at least
constexpr double kRing = 0.95;       // from there on it is closed
constexpr size_t kGap = 2;           // levels that a garment may miss, where it is torn
constexpr double kLeastSkirt = 0.2;  // of the leg that a skirt is long
constexpr double kLeastSheet = 0.2;  // of the height that a cape is long
constexpr double kToFloor = 0.7;     // of the leg: what encloses legs so far without showing them is a robe
constexpr double kFlare = 1.15;      // of its length around at the hips a robe is wide at its hem at least
constexpr double kLeg = 0.3;         // of the height: a body with shorter legs wears no robe
constexpr double kShown = 0.35;      // of its levels that show a leg within, or the skirt is the body's own shape
constexpr double kOverhang = 1.2;    // how much farther from the middle a hem is than the legs below it
constexpr double kLineGap = 0.12;    // of the height from line to line
constexpr size_t kFewestRing = 6, kMostRing = 12, kFewestSheet = 3, kMostSheet = 7;
constexpr double kThin = 0.22;       // of its width squared that a sheet's section encloses at most
constexpr double kWide = 0.5;        // of the shoulders' distance that it is wide at least
constexpr double kBehind = 0.02;     // of the height behind the trunk's middle line all of it is
constexpr double kSheetTurn = 0.55;  // of a turn around the trunk it covers at most
constexpr double kMadeShare = 0.05;  // of its weight that joints of garments hold: more, and it has chains
constexpr double kOwnShare = 0.7;    // of its weight that joints hold which do not swing
constexpr double kBesideLeg =
    0.45;  // sine of the angle from the front, or from the back, from which a panel goes with its leg
constexpr size_t kFewestVertices = 24;  // of a garment
constexpr float kSure = 0.9f, kFairlySure = 0.6f;

// Along a polyline of falling points at a height; beyond its ends, the end.
Point2 at_height(const std::vector<Point3>& line, double height, const SectionedMesh& mesh) {
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const double top = mesh.height(line[i]), bottom = mesh.height(line[i + 1]);
    if (height > top) return mesh.across(line[i]);
    if (height < bottom || !(top > bottom)) continue;
    const double share = (top - height) / (top - bottom);
    return mesh.across(line[i] + share * (line[i + 1] - line[i]));
  }
  return mesh.across(line.back());
}

class GarmentFinder {
 public:
  GarmentFinder(const Character& character, const UprightBody& body, const BodyFrame& frame,
                const std::vector<uint8_t>& classes, const std::vector<uint8_t>& swings)
      : c_(character),
        body_(body),
        classes_(classes),
        swings_(swings),
        height_(height_of(character)),
        mesh_(character, frame.left, frame.front, frame.up),
        first_(first_at_position(character)),
        rings_(welded_rings(character, first_)) {
    for (size_t side = 0; side < 2; ++side)
      for (const int joint : {body.legs[side].upper, body.legs[side].middle, body.legs[side].end})
        legs_[side].push_back(at(joint));
    left_leg_ = mesh_.across(legs_[0][0])[0] > mesh_.across(legs_[1][0])[0];
    spine_ = {at(body.chest), at(body.hips), 0.5 * (legs_[0][2] + legs_[1][2])};
  }

  std::vector<Garment> find() {
    std::vector<Garment> out;
    if (std::optional<Garment> skirt = find_skirt()) out.push_back(std::move(*skirt));
    if (std::optional<Garment> sheet = find_sheet()) out.push_back(std::move(*sheet));
    return out;
  }

 private:
  using Sections = std::vector<std::vector<SectionCurve>>;

  Point3 at(int joint) const { return point(c_.joints[joint_index(joint)].position); }
  Point2 leg(size_t side, double height) const { return at_height(legs_[side], height, mesh_); }
  Point2 between_legs(double height) const {
    const Point2 a = leg(0, height), b = leg(1, height);
    return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
  }

  // Levels of one garment: which curves of each section are its own.
  struct Levels {
    double top = 0, bottom = 0;
    Sections sections;
    std::vector<std::vector<size_t>> curves;  // [levels]
    size_t last = 0;                          // the lowest level that has some
    double height(size_t level) const {
      return top - (top - bottom) * static_cast<double>(level) / static_cast<double>(sections.size() - 1);
    }
  };

  std::optional<Garment> find_skirt() {
    Levels levels;
    levels.top = 0.5 * (mesh_.height(legs_[0][0]) + mesh_.height(legs_[1][0]));
    levels.bottom = 0.5 * (mesh_.height(legs_[0][2]) + mesh_.height(legs_[1][2]));
    const double leg_length = levels.top - levels.bottom;
    if (!(leg_length > 0.1 * height_)) return std::nullopt;
    levels.sections = mesh_.sections(levels.top, levels.bottom, kLevels);
    levels.curves.resize(kLevels);
    std::vector<uint8_t> shown(kLevels, 0);  // bits of the legs that are seen within
    std::optional<size_t> last;
    for (size_t k = 0; k < kLevels; ++k) {
      const double height = levels.height(k);
      const Point2 middle = between_legs(height);
      for (size_t i = 0; i < levels.sections[k].size(); ++i)
        if (levels.sections[k][i].covered_turn(middle) >= kAround) levels.curves[k].push_back(i);
      for (const SectionCurve& curve : levels.sections[k])
        for (size_t side = 0; side < 2; ++side)
          if (curve.covered_turn(middle) < kAround && curve.covered_turn(leg(side, height)) >= kAround)
            shown[k] |= 1u << side;
      if (!levels.curves[k].empty() && (last ? k - *last <= kGap + 1 : k <= kGap)) last = k;
    }
    if (!last) return std::nullopt;
    levels.last = *last;
    const double long_of_leg = static_cast<double>(*last) / static_cast<double>(kLevels - 1);
    if (long_of_leg < kLeastSkirt) return std::nullopt;
    const auto seen = static_cast<double>(
        std::count(shown.begin(), shown.begin() + static_cast<std::ptrdiff_t>(*last) + 1, uint8_t{3}));
    const bool over_legs = seen >= kShown * static_cast<double>(*last + 1);
    if (!over_legs) {
      if (leg_length < kLeg * height_) return std::nullopt;
      const double flare = around(levels, *last) / std::max(1e-9, around(levels, 0));
      const bool robe = long_of_leg >= kToFloor && flare >= kFlare;
      if (!robe && !hangs_over(levels)) return std::nullopt;
    }
    keep_outer(&levels);
    Garment out;
    out.kind = SpringKind::kSkirt;
    out.on = joint_index(body_.hips);
    out.certainty = over_legs ? kSure : kFairlySure;
    const auto place = [&](const Point2& p, double height) { return angle_of(p - between_legs(height)); };
    return lay(levels, place, &out) ? std::optional<Garment>(std::move(out)) : std::nullopt;
  }

  // Above the legs' parting the body encloses the legs as well: there the outermost curve is the skirt's.
  void keep_outer(Levels* levels) const {
    for (size_t k = 0; k <= levels->last; ++k) {
      std::vector<size_t>& curves = levels->curves[k];
      if (curves.size() < 2) continue;
      const Point2 middle = between_legs(levels->height(k));
      bool parted = false;
      for (const SectionCurve& curve : levels->sections[k])
        parted = parted ||
                 (curve.covered_turn(middle) < kAround && curve.covered_turn(leg(0, levels->height(k))) >= kAround);
      if (parted) continue;
      double farthest = 0;
      for (const size_t i : curves) farthest = std::max(farthest, levels->sections[k][i].mean_distance(middle));
      curves.erase(
          std::remove_if(curves.begin(), curves.end(),
                         [&](size_t i) { return levels->sections[k][i].mean_distance(middle) < 0.95 * farthest; }),
          curves.end());
    }
  }

  double around(const Levels& levels, size_t level) const {
    double most = 0;
    for (size_t k = level > kGap ? level - kGap : 0; k <= std::min(level + kGap, kLevels - 1); ++k)
      for (const size_t i : levels.curves[k]) most = std::max(most, levels.sections[k][i].total_length());
    return most;
  }

  // A hem over legs that come out below it.
  bool hangs_over(const Levels& levels) const {
    double hem = 0, below = 0;
    for (size_t k = levels.last > 4 ? levels.last - 4 : 0; k <= levels.last; ++k)
      for (const size_t i : levels.curves[k])
        hem = std::max(hem, levels.sections[k][i].mean_distance(between_legs(levels.height(k))));
    size_t legs = 0;
    for (size_t k = levels.last + 2; k <= std::min(levels.last + 8, kLevels - 1); ++k)
      for (const SectionCurve& curve : levels.sections[k]) {
        const Point2 middle = between_legs(levels.height(k));
        for (const auto& segment : curve.segments) below = std::max(below, length(segment[0] - middle));
        ++legs;
      }
    return legs > 0 && hem > kOverhang * below;
  }

  std::optional<Garment> find_sheet() {
    Levels levels;
    levels.top = mesh_.height(at(body_.chest));
    for (const UprightLimb& arm : body_.arms)
      if (body_.has_arms && arm.upper >= 0) levels.top = std::max(levels.top, mesh_.height(at(arm.upper)));
    levels.bottom = 0.5 * (mesh_.height(legs_[0][2]) + mesh_.height(legs_[1][2]));
    if (!body_.has_arms || !(levels.top - levels.bottom > kLeastSheet * height_)) return std::nullopt;
    const double shoulders =
        std::abs(mesh_.across(at(body_.arms[0].upper))[0] - mesh_.across(at(body_.arms[1].upper))[0]);
    levels.sections = mesh_.sections(levels.top, levels.bottom, kLevels);
    levels.curves.resize(kLevels);
    std::optional<size_t> begin, last;
    for (size_t k = 0; k < kLevels; ++k) {
      const Point2 middle = at_height(spine_, levels.height(k), mesh_);
      for (size_t i = 0; i < levels.sections[k].size(); ++i)
        if (is_sheet(levels.sections[k][i], middle, shoulders)) levels.curves[k].push_back(i);
      if (levels.curves[k].empty() || (last && k - *last > kGap + 1)) continue;
      if (!begin) begin = k;
      last = k;
    }
    if (!last || levels.height(*begin) - levels.height(*last) < kLeastSheet * height_) return std::nullopt;
    if (levels.height(*begin) < mesh_.height(at(body_.hips))) return std::nullopt;
    // The lattice begins where the sheet leaves the back.
    Levels cut;
    cut.top = levels.height(*begin);
    cut.bottom = levels.bottom;
    cut.sections.assign(levels.sections.begin() + static_cast<std::ptrdiff_t>(*begin), levels.sections.end());
    cut.curves.assign(levels.curves.begin() + static_cast<std::ptrdiff_t>(*begin), levels.curves.end());
    cut.last = *last - *begin;
    Garment out;
    out.kind = SpringKind::kCape;
    out.on = joint_index(body_.chest);
    out.certainty = kSure;
    // From its left edge to its right one at every level, so that lines go with the cloth.
    std::vector<std::array<double, 2>> edges(cut.sections.size(), {0, 0});
    for (size_t k = 0; k < cut.sections.size(); ++k) {
      bool any = false;
      for (const size_t i : cut.curves[k])
        for (const auto& segment : cut.sections[k][i].segments)
          for (const Point2& p : segment) {
            edges[k][0] = any ? std::max(edges[k][0], p[0]) : p[0];
            edges[k][1] = any ? std::min(edges[k][1], p[0]) : p[0];
            any = true;
          }
      if (!any && k > 0) edges[k] = edges[k - 1];
    }
    const auto place = [&, edges](const Point2& p, double height) {
      const double step = (cut.top - cut.bottom) / static_cast<double>(cut.sections.size() - 1);
      const auto k = static_cast<size_t>(
          std::clamp(std::round((cut.top - height) / step), 0.0, static_cast<double>(cut.sections.size() - 1)));
      const double wide = edges[k][0] - edges[k][1];
      return wide > 0 ? std::clamp((edges[k][0] - p[0]) / wide, 0.0, 1.0) : 0.5;
    };
    return lay(cut, place, &out) ? std::optional<Garment>(std::move(out)) : std::nullopt;
  }

  bool is_sheet(const SectionCurve& curve, const Point2& middle, double shoulders) const {
    double left = -1e30, right = 1e30, front = -1e30;
    Point2 centroid = {0, 0};
    double weight = 0;
    for (const auto& segment : curve.segments) {
      const double size = length(segment[1] - segment[0]);
      weight += size;
      for (size_t axis = 0; axis < 2; ++axis) centroid[axis] += size * 0.5 * (segment[0][axis] + segment[1][axis]);
      for (const Point2& p : segment) {
        left = std::max(left, p[0]);
        right = std::min(right, p[0]);
        front = std::max(front, p[1]);
      }
    }
    if (!(weight > 0) || left - right < kWide * shoulders || front > middle[1] - kBehind * height_) return false;
    if (!(left > middle[0]) || !(right < middle[0])) return false;
    if (curve.covered_turn(middle) > kSheetTurn) return false;
    for (double& x : centroid) x /= weight;
    double area = 0;
    for (const auto& segment : curve.segments) {
      const Point2 a = segment[0] - centroid, b = segment[1] - centroid;
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return std::abs(area) < kThin * (left - right) * (left - right);
  }

  // Triangles that curves of the garment cut, then vertices; what no level cuts goes with what is beside it. [V] 1: the garment's
  std::vector<uint8_t> covered_by(const Levels& levels) const {
    const size_t triangle_count = mesh_.triangles().size();
    std::vector<int32_t> votes(c_.vertices.size(), 0);
    std::vector<uint8_t> seen(c_.vertices.size(), 0), own(triangle_count, 0), cut(triangle_count, 0);
    for (size_t k = 0; k < levels.sections.size(); ++k)
      for (size_t i = 0; i < levels.sections[k].size(); ++i) {
        const bool mine = k <= levels.last && std::count(levels.curves[k].begin(), levels.curves[k].end(), i) != 0;
        for (const uint32_t t : levels.sections[k][i].triangles) {
          cut[t] = 1;
          if (mine) own[t] = 1;
        }
      }
    for (size_t t = 0; t < triangle_count; ++t)
      if (cut[t] != 0)
        for (const uint32_t v : mesh_.triangles()[t]) {
          seen[first_[v]] = 1;
          votes[first_[v]] += own[t] != 0 ? 1 : -1;
        }
    std::vector<uint32_t> queue;
    std::vector<uint8_t> covered(c_.vertices.size(), 0);
    const auto between = [&](uint32_t v) {
      return mesh_.height(v) <= levels.top &&
             mesh_.height(v) >= levels.height(levels.last) - (levels.top - levels.bottom) / kLevels;
    };
    for (uint32_t v = 0; v < c_.vertices.size(); ++v) {
      if (first_[v] != v || seen[v] == 0) continue;
      covered[v] = votes[v] > 0 && between(v) ? 1 : 0;
      queue.push_back(v);
    }
    for (size_t next = 0; next < queue.size(); ++next)
      for (const uint32_t v : rings_[queue[next]])
        if (seen[v] == 0) {
          seen[v] = 1;
          covered[v] = covered[queue[next]] != 0 && between(v) ? 1 : 0;
          queue.push_back(v);
        }
    for (uint32_t v = 0; v < covered.size(); ++v) covered[v] = covered[first_[v]];
    return covered;
  }

  // Whether the vertices hang on a body that holds still beside them: not on joints that swing, wings and tails.
  bool is_held_by_body(const Garment& garment) const {
    double own = 0, made = 0, all = 0;
    for (const uint32_t v : garment.vertices)
      for (const Influence& one : c_.influences[v]) {
        const uint8_t c = classes_[one.joint];
        const bool other = swings_[one.joint] != 0 || c == SINEW_CLASS_WING || c == SINEW_CLASS_TAIL ||
                           c == SINEW_CLASS_HAIR || c == SINEW_CLASS_PROP;
        all += static_cast<double>(one.weight);
        if (swings_[one.joint] == kSwingsAsGarment) made += static_cast<double>(one.weight);
        if (!other) own += static_cast<double>(one.weight);
      }
    return all > 0 && own >= kOwnShare * all && made <= kMadeShare * all;
  }

  // Lines, vertices and their places. `place` says of a point in a section how far around or across it is, 0..1.
  template <class Place>
  bool lay(const Levels& levels, Place place, Garment* out) const {
    constexpr size_t kParts = 48;  // around or across
    // By part and level: the farthest point out, which is where lines run.
    std::vector<std::vector<std::optional<Point2>>> surface(kParts,
                                                            std::vector<std::optional<Point2>>(levels.last + 1));
    double longest_around = 0, span = 0;
    size_t levels_with = 0;
    const bool is_skirt = out->kind == SpringKind::kSkirt;
    for (size_t k = 0; k <= levels.last; ++k) {
      const double height = levels.height(k);
      const Point2 middle = is_skirt ? between_legs(height) : at_height(spine_, height, mesh_);
      double left = -1e30, right = 1e30;
      for (const size_t i : levels.curves[k]) {
        const SectionCurve& curve = levels.sections[k][i];
        longest_around = std::max(longest_around, curve.total_length());
        for (const auto& segment : curve.segments) {
          const double step = length(segment[1] - segment[0]);
          const auto points = static_cast<size_t>(step / (0.005 * height_)) + 1;
          for (size_t n = 0; n <= points; ++n) {
            const double share = static_cast<double>(n) / static_cast<double>(points);
            const Point2 p = {segment[0][0] + share * (segment[1][0] - segment[0][0]),
                              segment[0][1] + share * (segment[1][1] - segment[0][1])};
            left = std::max(left, p[0]);
            right = std::min(right, p[0]);
            const double s = place(p, height);
            std::optional<Point2>& at = surface[std::min(kParts - 1, static_cast<size_t>(s * kParts))][k];
            if (!at || length(p - middle) > length(*at - middle)) at = p;
          }
        }
      }
      if (left > right) {
        span += left - right;
        ++levels_with;
      }
    }
    // How far down each part hangs, and which parts there are.
    std::vector<double> hem(kParts, -1);
    for (size_t b = 0; b < kParts; ++b)
      for (size_t k = 0; k <= levels.last; ++k)
        if (surface[b][k]) hem[b] = static_cast<double>(k);
    double from = 0, to = 1;
    out->ring = false;
    if (is_skirt) {
      const auto there = static_cast<size_t>(
          std::count_if(hem.begin(), hem.end(), [&](double h) { return h >= 0.5 * static_cast<double>(levels.last); }));
      out->ring = static_cast<double>(there) >= kRing * kParts;
      if (!out->ring) std::tie(from, to) = widest_arc(hem, 0.5 * static_cast<double>(levels.last));
    }
    const double around =
        is_skirt ? longest_around * (to - from) : span / static_cast<double>(std::max<size_t>(levels_with, 1));
    const double wanted = std::round(around / (kLineGap * height_));
    size_t count = is_skirt ? static_cast<size_t>(std::clamp(wanted, double{kFewestRing}, double{kMostRing}))
                            : static_cast<size_t>(std::clamp(wanted + 1, double{kFewestSheet}, double{kMostSheet}));
    if (out->ring) count += count % 2;
    const double gaps = static_cast<double>(out->ring ? count : count - 1);
    std::vector<double> hems(count);
    for (size_t n = 0; n < count; ++n) {
      double s = from + (to - from) * static_cast<double>(n) / gaps;
      s -= s >= 1 && out->kind == SpringKind::kSkirt ? std::floor(s) : 0;
      const auto middle_part = static_cast<std::ptrdiff_t>(std::clamp(s * kParts, 0.0, kParts - 1.0));
      // The nearest parts say where the line runs at each level.
      const auto point_at = [&](double level) -> std::optional<Point3> {
        for (std::ptrdiff_t off = 0; off <= static_cast<std::ptrdiff_t>(kParts) / 8; ++off)
          for (const std::ptrdiff_t side : {off, -off}) {
            std::ptrdiff_t b = middle_part + side;
            if (is_skirt) b = (b + kParts) % static_cast<std::ptrdiff_t>(kParts);
            if (b < 0 || b >= static_cast<std::ptrdiff_t>(kParts)) continue;
            const auto& column = surface[static_cast<size_t>(b)];
            const auto k = static_cast<std::ptrdiff_t>(std::round(level));
            for (const std::ptrdiff_t d : {0, -1, 1, -2, 2}) {
              const std::ptrdiff_t row = k + d;
              if (row < 0 || row >= static_cast<std::ptrdiff_t>(column.size()) || !column[static_cast<size_t>(row)])
                continue;
              return mesh_.point_at(*column[static_cast<size_t>(row)], levels.height(static_cast<size_t>(k)));
            }
          }
        return std::nullopt;
      };
      double lowest = 0;
      for (std::ptrdiff_t off = -1; off <= 1; ++off) {
        std::ptrdiff_t b = middle_part + off;
        if (is_skirt) b = (b + kParts) % static_cast<std::ptrdiff_t>(kParts);
        if (b >= 0 && b < static_cast<std::ptrdiff_t>(kParts)) lowest = std::max(lowest, hem[static_cast<size_t>(b)]);
      }
      hems[n] = lowest;
      std::vector<Point3> line;
      for (size_t row = 0; row <= kRows; ++row)
        if (const auto p = point_at(lowest * static_cast<double>(row) / kRows)) line.push_back(*p);
      if (line.size() != kRows + 1) return false;
      const Point2 from_middle = mesh_.across(line[0]) - between_legs(levels.top);
      const double aside = from_middle[0] / std::max(1e-9, length(from_middle));
      const bool with_leg = is_skirt && std::abs(aside) >= kBesideLeg;
      out->parents.push_back(with_leg ? joint_index(body_.legs[left_leg_ == (aside > 0) ? 0 : 1].upper) : out->on);
      out->lines.push_back(std::move(line));
    }
    const std::vector<uint8_t> covered = covered_by(levels);
    const double step = (levels.top - levels.bottom) / static_cast<double>(levels.sections.size() - 1);
    for (uint32_t v = 0; v < covered.size(); ++v) {
      if (covered[v] == 0) continue;
      double s = place(mesh_.across(v), mesh_.height(v));
      if (is_skirt && s < from) s += 1;  // an arc may pass the front
      double along = (s - from) / (to - from) * gaps;
      if (!out->ring) {
        if (along > gaps && is_skirt && s - to > 0.5 * (1 - (to - from))) along = 0;  // beyond the gap's middle
        along = std::clamp(along, 0.0, gaps);
      }
      const auto low = static_cast<size_t>(std::floor(along)) % count;
      const size_t high = out->ring ? (low + 1) % count : std::min(low + 1, count - 1);
      const double share = along - std::floor(along);
      const double local = ((1 - share) * hems[low] + share * hems[high]) * step;
      const double down = local > 0 ? std::clamp((levels.top - mesh_.height(v)) / local, 0.0, 1.0) : 0;
      out->vertices.push_back(v);
      out->places.push_back({along, down});
    }
    return out->vertices.size() >= kFewestVertices && is_held_by_body(*out);
  }

  // The longest run of parts that hang so far down, around the front; as shares of a turn, the end above 1 where it passes it.
  static std::pair<double, double> widest_arc(const std::vector<double>& hem, double least) {
    const size_t count = hem.size();
    size_t best = 0, best_begin = 0;
    for (size_t begin = 0; begin < count; ++begin) {
      size_t run = 0;
      while (run < count && hem[(begin + run) % count] >= least) ++run;
      if (run > best) {
        best = run;
        best_begin = begin;
      }
    }
    const double from = (static_cast<double>(best_begin) + 0.5) / static_cast<double>(count);
    return {from, from + (static_cast<double>(best) - 1) / static_cast<double>(count)};
  }

  const Character& c_;
  const UprightBody& body_;
  const std::vector<uint8_t>&classes_, &swings_;
  const double height_;
  const SectionedMesh mesh_;
  const std::vector<uint32_t> first_;  // [V] the first vertex at its position
  const std::vector<std::vector<uint32_t>> rings_;
  std::array<std::vector<Point3>, 2> legs_;
  std::vector<Point3> spine_;
  bool left_leg_ = true;  // the first of body_.legs is the left one
};

}  // namespace

std::vector<Garment> find_garments(const Character& character, const std::vector<uint8_t>& classes,
                                   const std::vector<uint8_t>& swings) {
  const std::optional<UprightBody> body = find_upright_body(character.joints, classes);
  if (!body || body->hips < 0 || body->chest < 0 || character.influences.empty()) return {};
  for (const UprightLimb& leg : body->legs)
    if (leg.upper < 0 || leg.middle < 0 || leg.end < 0) return {};
  std::vector<Point3> positions;
  for (const Joint& joint : character.joints) positions.push_back(point(joint.position));
  if (!is_upright(*body, positions)) return {};
  const BodyFrame frame = body_frame(character.joints, *body, character.up);
  if (!(length(frame.front) > 0)) return {};
  return GarmentFinder(character, *body, frame, classes, swings).find();
}

}  // namespace sinew
