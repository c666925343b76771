// SPDX-License-Identifier: MIT
// Clothes, hats, horns and gear of generated characters.
#include <algorithm>
#include <functional>
#include <map>

#include "synth/surface.hpp"

namespace sinew::synth {
namespace {

double share_of(const std::vector<Influence>& row, const std::vector<bool>& joints) {
  double sum = 0;
  for (const Influence& i : row) sum += joints[i.joint] ? static_cast<double>(i.weight) : 0.0;
  return sum;
}

// The faces whose corners all pass, pushed out by `offset` along the normals, with the body's weights. Faces at pinched
// vertices (more than one fan) are dropped, so the boundary is a set of simple loops.
Surface shell(const Surface& body, const std::vector<Point>& normals, const std::function<bool(uint32_t)>& passes,
              double offset) {
  std::vector<bool> keep(body.faces.size());
  for (size_t f = 0; f < body.faces.size(); ++f)
    keep[f] = std::all_of(body.faces[f].begin(), body.faces[f].end(), passes);
  for (bool changed = true; changed;) {
    changed = false;
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (size_t f = 0; f < keep.size(); ++f) {
      if (!keep[f]) continue;
      const std::vector<uint32_t>& face = body.faces[f];
      for (size_t i = 0; i < face.size(); ++i) {
        const uint32_t a = face[i], b = face[(i + 1) % face.size()];
        ++edges[{std::min(a, b), std::max(a, b)}];
      }
    }
    std::vector<int> open(body.positions.size(), 0);
    for (const auto& [edge, count] : edges) {
      if (count != 1) continue;
      ++open[edge.first];
      ++open[edge.second];
    }
    for (size_t f = 0; f < keep.size(); ++f) {
      if (!keep[f]) continue;
      if (std::any_of(body.faces[f].begin(), body.faces[f].end(), [&](uint32_t v) { return open[v] > 2; })) {
        keep[f] = false;
        changed = true;
      }
    }
  }
  Surface surface;
  std::vector<int64_t> map(body.positions.size(), -1);
  for (size_t f = 0; f < keep.size(); ++f) {
    if (!keep[f]) continue;
    std::vector<uint32_t> face;
    for (uint32_t v : body.faces[f]) {
      if (map[v] < 0) {
        map[v] = static_cast<int64_t>(surface.positions.size());
        surface.positions.push_back(body.positions[v] + normals[v] * offset);
        surface.influences.push_back(body.influences[v]);
      }
      face.push_back(static_cast<uint32_t>(map[v]));
    }
    surface.faces.push_back(std::move(face));
  }
  return surface;
}

// Weights of cloth that hangs from the torso at height y: the torso joints above and below share it.
std::vector<Influence> trunk_weights(const Blueprint& plan, double y) {
  for (size_t i = plan.trunk.size(); i-- > 1;) {
    const double here = plan.at(plan.trunk[i]).y, below = plan.at(plan.trunk[i - 1]).y;
    if (y > here + 0.3 * (here - below)) return {{static_cast<uint32_t>(plan.trunk[i]), 1.0f}};
    if (y > here - 0.3 * (here - below)) {
      const double t = smooth_step(here - 0.3 * (here - below), here + 0.3 * (here - below), y);
      return {{static_cast<uint32_t>(plan.trunk[i]), static_cast<float>(t)},
              {static_cast<uint32_t>(plan.trunk[i - 1]), static_cast<float>(1 - t)}};
    }
  }
  return {{static_cast<uint32_t>(plan.trunk[0]), 1.0f}};
}

// Body parts that hanging cloth has to clear: not the arms, not a tail.
std::vector<bool> trunk_and_legs(const Blueprint& plan) {
  std::vector<bool> set(plan.joints.size(), false);
  for (int joint : plan.trunk) set[static_cast<size_t>(joint)] = true;
  for (const Limb& limb : plan.legs) {
    for (int joint : limb.joints) set[static_cast<size_t>(joint)] = true;
  }
  return set;
}

// An open tube around hips and legs, from the waist down to `hem`; follows hips, thighs and shins.
Surface skirt(const Blueprint& plan, const Surface& body, double waist, double hem, double flare) {
  const Point hip = plan.at(plan.legs[0].joints[0]), knee = plan.at(plan.legs[0].joints[1]);
  const std::vector<bool> covered = trunk_and_legs(plan);
  const int rows = std::max(4, static_cast<int>((waist - hem) / (1.6 * plan.cell))), sides = 24;
  std::vector<std::array<double, 3>> profile;
  double rx = 0, rz = 0;
  for (int r = 0; r <= rows; ++r) {
    const double y = mix(waist, hem, static_cast<double>(r) / rows);
    for (size_t v = 0; v < body.positions.size(); ++v) {
      const Point p = body.positions[v];
      if (p.y < y - plan.cell || p.y > y + plan.cell || share_of(body.influences[v], covered) < 0.8) continue;
      rx = std::max(rx, (p.x < 0 ? -p.x : p.x) + 0.02);
      rz = std::max(rz, (p.z < 0 ? -p.z : p.z) + 0.02);
    }
    const double grow = 1 + flare * r / rows;
    profile.push_back({rx * grow * 1.06, rz * grow * 1.1, y});
  }
  Surface cloth = revolve(static_cast<uint32_t>(plan.trunk[0]), {0, 0, 0}, profile, sides);
  for (size_t v = 0; v < cloth.positions.size(); ++v) {
    const Point p = cloth.positions[v];
    const double legs = smooth_step(hip.y + 0.05, mix(hip.y, knee.y, 0.7), p.y) * 0.9;
    const double left = smooth_step(-hip.x, hip.x, p.x),
                 low = smooth_step(mix(knee.y, hip.y, 0.15), mix(knee.y, 0, 0.25), p.y);
    std::vector<Influence> row = {{static_cast<uint32_t>(plan.trunk[0]), static_cast<float>(1 - legs)}};
    for (size_t side = 0; side < 2; ++side) {
      const double share = legs * (side == 0 ? left : 1 - left);
      row.push_back({static_cast<uint32_t>(plan.legs[side].joints[0]), static_cast<float>(share * (1 - low))});
      row.push_back({static_cast<uint32_t>(plan.legs[side].joints[1]), static_cast<float>(share * low)});
    }
    cloth.influences[v] = tidy_weights(std::move(row));
  }
  return cloth;
}

// A sheet behind the back, from the shoulders to `hem`.
Surface cape(const Blueprint& plan, const Surface& body, double hem, bool rigid) {
  const uint32_t chest = static_cast<uint32_t>(plan.trunk.back()), hips = static_cast<uint32_t>(plan.trunk.front());
  const Point shoulder = plan.at(plan.arms[0].joints[0]);
  const double top = plan.at(plan.neck).y - 0.01;
  const int columns = 10, rows = std::max(6, static_cast<int>((top - hem) / (1.7 * plan.cell)));
  const std::vector<bool> covered = trunk_and_legs(plan);
  Surface sheet;
  double depth = 0;
  for (int r = 0; r <= rows; ++r) {
    const double t = static_cast<double>(r) / rows, y = mix(top, hem, t);
    for (size_t v = 0; v < body.positions.size(); ++v) {
      const Point p = body.positions[v];
      const bool behind = p.x < shoulder.x && p.x > -shoulder.x && share_of(body.influences[v], covered) > 0.8;
      if (behind && p.y > y - plan.cell && p.y < y + plan.cell) depth = std::max(depth, -p.z);
    }
    const double width = shoulder.x * mix(0.85, 1.5, t);
    for (int c = 0; c <= columns; ++c) {
      const double s = 2.0 * c / columns - 1;
      sheet.positions.push_back({s * width, y, -depth - 0.03 - 0.06 * t + 0.05 * s * s});
      std::vector<Influence> row = {{chest, 1.0f}};
      if (!rigid) {
        row = trunk_weights(plan, y);
        // Below the seat the cloth trails the hips only half as much; the chest it hangs from keeps the rest.
        const double low = 0.5 * smooth_step(plan.at(plan.trunk[0]).y, plan.at(plan.trunk[0]).y * 0.6, y);
        for (Influence& i : row) i.weight *= static_cast<float>(1 - low);
        if (low > 0 && row[0].joint == hips) row.push_back({chest, static_cast<float>(low)});
      }
      sheet.influences.push_back(tidy_weights(std::move(row)));
    }
  }
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const uint32_t a = static_cast<uint32_t>(r * (columns + 1) + c), below = a + static_cast<uint32_t>(columns) + 1;
      sheet.faces.push_back({a, a + 1, below + 1, below});  // seen from behind
    }
  }
  std::vector<std::vector<uint32_t>> out;
  for (std::vector<uint32_t> f : sheet.faces) {
    const Point n = cross(sheet.positions[f[1]] - sheet.positions[f[0]], sheet.positions[f[2]] - sheet.positions[f[0]]);
    if (n.z > 0) std::reverse(f.begin(), f.end());
    out.push_back(std::move(f));
  }
  sheet.faces = std::move(out);
  return sheet;
}

Surface torus(uint32_t joint, Point center, double rx, double rz, double thickness, int sides) {
  std::vector<std::array<double, 3>> profile;
  for (int i = 0; i < 6; ++i) {
    const double angle = 2 * kPi * i / 6;
    profile.push_back({rx + thickness * sine(angle), rz + thickness * sine(angle), thickness * cosine(angle)});
  }
  return revolve(joint, center, profile, sides, true);
}

void hat(const Blueprint& plan, Random* random, Surface* out) {
  const uint32_t head = static_cast<uint32_t>(plan.head);
  const double r = plan.head_radius;
  const Point brow = plan.head_center + Point{0, r * 0.45, 0};
  if (random->chance(0.5)) {  // pointed, with a brim
    const double tall = r * random->range(1.2, 2.4);
    out->append(revolve(head, brow,
                        {{0, 0, tall},
                         {r * 0.35, r * 0.35, tall * 0.6},
                         {r * 0.7, r * 0.7, tall * 0.25},
                         {r * 1.0, r * 1.0, 0},
                         {r * 1.35, r * 1.35, -0.02},
                         {r * 1.7, r * 1.7, -0.05}},
                        14));
  } else {  // a cap of hair or a helmet
    const double w = r * 1.12;
    out->append(
        revolve(head, plan.head_center,
                {{0, 0, w * 1.1}, {w * 0.5, w * 0.5, w * 0.95}, {w * 0.85, w * 0.85, w * 0.55}, {w, w, w * 0.1}}, 14));
  }
}

void horns(const Blueprint& plan, Random* random, Surface* out) {
  const double r = plan.head_radius, tall = r * random->range(0.6, 1.3);
  for (int side = 0; side < 2; ++side) {
    const double s = side == 0 ? 1 : -1;
    const Point base = plan.head_center + Point{s * r * 0.6, r * 0.75, 0};
    out->append(lump(static_cast<uint32_t>(plan.head), base + Point{s * tall * 0.2, tall * 0.45, 0},
                     bone_frame(base, base + Point{s * tall * 0.4, tall, 0}, r * 0.22, r * 0.22), 3, 0.8, 0.25));
  }
}

// Clothes and gear for one body. What is drawn of `random`, and in which order, is part of what a seed gives.
class Wardrobe {
 public:
  Wardrobe(const Blueprint& plan, const Surface& body, Random* random)
      : plan_(plan), body_(body), random_(random), normals_(vertex_normals(body)) {}

  Surface run(BodyPlan kind) {
    if (kind == BodyPlan::kBiped) {
      dress_biped();
    } else if (kind == BodyPlan::kQuadruped && random_->chance(0.6)) {
      saddle();
    } else if (kind == BodyPlan::kManyLegged && random_->chance(0.6)) {
      plates();
    } else if (kind == BodyPlan::kBird) {
      beak();
    }
    const double on_head = random_->range(0, 1);
    if (on_head < 0.35) {
      hat(plan_, random_, &out_);
    } else if (on_head < 0.6) {
      horns(plan_, random_, &out_);
    }
    return std::move(out_);
  }

 private:
  std::vector<bool> set_of(const std::vector<int>& joints) const {
    std::vector<bool> set(plan_.joints.size(), false);
    for (int j : joints) set[static_cast<size_t>(j)] = true;
    return set;
  }

  void dress_biped() {
    neck_ = plan_.at(plan_.neck);
    waist_ = plan_.at(plan_.trunk[0]).y + random_->range(0.06, 0.12);
    knee_ = plan_.at(plan_.legs[0].joints[1]).y;
    below_the_waist();
    shirt();
    boots();
    if (random_->chance(0.35)) {
      const bool rigid = random_->chance(0.3),
                 to_the_knee = random_->chance(0.5);  // drawn here: arguments have no order
      out_.append(cape(plan_, body_, to_the_knee ? knee_ : 0.2, rigid));
    }
    on_chest_and_shoulders();
    belt();
    hand_and_halo();
  }

  void below_the_waist() {
    const int bottom = random_->integer(0, 3);  // trousers, skirt, robe, nothing
    std::vector<int> legs = {plan_.trunk[0]};
    for (const Limb& limb : plan_.legs) legs.insert(legs.end(), limb.joints.begin(), limb.joints.begin() + 2);
    if (bottom == 0) {
      const std::vector<bool> set = set_of(legs);
      const double cut = random_->chance(0.5) ? 0.14 : knee_ + 0.05;
      out_.append(shell(
          body_, normals_,
          [&](uint32_t v) {
            return share_of(body_.influences[v], set) > 0.6 && body_.positions[v].y > cut &&
                   body_.positions[v].y < waist_;
          },
          0.008));
    } else if (bottom < 3) {
      const double hem = bottom == 1 ? knee_ + random_->range(-0.05, 0.08) : random_->range(0.05, 0.12);
      out_.append(skirt(plan_, body_, waist_, hem, random_->range(0.0, 0.35)));
    }
  }

  void shirt() {
    if (random_->chance(0.75)) {
      std::vector<int> covered = plan_.trunk;
      const bool long_sleeves = random_->chance(0.5);
      for (const Limb& limb : plan_.arms) {
        covered.push_back(limb.joints[0]);
        if (long_sleeves) covered.push_back(limb.joints[1]);
        const int up = plan_.joints[static_cast<size_t>(limb.joints[0])].parent;
        if (up != plan_.trunk.back()) covered.push_back(up);
      }
      const std::vector<bool> set = set_of(covered);
      out_.append(shell(
          body_, normals_,
          [&](uint32_t v) {
            return share_of(body_.influences[v], set) > 0.6 && body_.positions[v].y > waist_ - 0.06 &&
                   body_.positions[v].y < neck_.y + 0.02;
          },
          0.014));
    }
  }

  void boots() {
    if (random_->chance(0.4)) {
      std::vector<int> feet;
      for (const Limb& limb : plan_.legs) feet.insert(feet.end(), limb.joints.begin() + 2, limb.joints.end());
      const std::vector<bool> set = set_of(feet);
      out_.append(shell(
          body_, normals_, [&](uint32_t v) { return share_of(body_.influences[v], set) > 0.45; }, 0.012));
    }
  }

  void on_chest_and_shoulders() {
    if (random_->chance(0.4)) {
      for (size_t side = 0; side < 2; ++side) {
        const Point at = plan_.at(plan_.arms[side].joints[0]) + Point{side == 0 ? 0.02 : -0.02, 0.07, 0};
        out_.append(lump(static_cast<uint32_t>(plan_.arms[side].joints[0]), at, box_frame(0.09, 0.045, 0.09), 3, 0.85));
      }
    }
    if (random_->chance(0.3)) {
      out_.append(lump(static_cast<uint32_t>(plan_.trunk.back()),
                       mix(plan_.at(plan_.trunk.back()), neck_, 0.4) - Point{0, 0, 0.26}, box_frame(0.13, 0.16, 0.08),
                       3, 0.3));
    }
  }

  void belt() {
    if (random_->chance(0.3)) {
      double rx = 0, rz = 0;
      const std::vector<bool> trunk = set_of(plan_.trunk);
      for (size_t v = 0; v < body_.positions.size(); ++v) {
        const Point p = body_.positions[v];
        if (p.y < waist_ - plan_.cell || p.y > waist_ + plan_.cell || share_of(body_.influences[v], trunk) < 0.7)
          continue;
        rx = std::max(rx, p.x);
        rz = std::max(rz, p.z);
      }
      if (rx > 0)
        out_.append(torus(static_cast<uint32_t>(plan_.trunk.front()), {0, waist_, 0}, rx + 0.03, rz + 0.03, 0.025, 18));
    }
  }

  // Something long in the left hand, and a ring above the head.
  void hand_and_halo() {
    if (random_->chance(0.25)) {  // something long in the left hand
      const Limb& arm = plan_.arms[0];
      const Point hand = plan_.at(arm.joints[2]), out_by = unit(hand - plan_.at(arm.joints[1]));
      const Point grip = hand + out_by * 0.07;
      out_.append(lump(static_cast<uint32_t>(arm.joints[2]), grip + Point{0, 0, 0.28},
                       bone_frame(grip - Point{0, 0, 0.1}, grip + Point{0, 0, 0.66}, 0.03, 0.015), 3, 0.2, 0.5));
    }
    if (random_->chance(0.15))
      out_.append(torus(static_cast<uint32_t>(plan_.head), plan_.head_center + Point{0, plan_.head_radius * 1.6, 0},
                        0.12, 0.12, 0.015, 16));
  }

  void saddle() {
    const std::vector<bool> trunk = set_of(plan_.trunk);
    const double back = plan_.at(plan_.trunk[1]).y - 0.02;
    out_.append(shell(
        body_, normals_,
        [&](uint32_t v) {
          return share_of(body_.influences[v], trunk) > 0.6 && body_.positions[v].y > back &&
                 body_.positions[v].z > plan_.at(plan_.trunk[1]).z - 0.1 &&
                 body_.positions[v].z < plan_.at(plan_.trunk.back()).z + 0.08;
        },
        0.016));
    if (random_->chance(0.5)) {
      for (double side : {1.0, -1.0}) {
        out_.append(lump(static_cast<uint32_t>(plan_.trunk[1]),
                         plan_.at(plan_.trunk[1]) + Point{side * 0.24, 0.02, 0.06}, box_frame(0.05, 0.1, 0.12), 3,
                         0.3));
      }
    }
  }

  // On the back.
  void plates() {
    for (int joint : plan_.trunk) {  // plates on the back
      const PlanJoint& segment = plan_.joints[static_cast<size_t>(joint)];
      out_.append(lump(static_cast<uint32_t>(joint), mix(segment.position, segment.tip, 0.5) + Point{0, 0.16, 0},
                       box_frame(0.12, 0.03, 0.1), 3, 0.6));
    }
  }

  void beak() {
    const Point front = plan_.head_center + Point{0, -0.01, plan_.head_radius * 0.8};
    out_.append(lump(static_cast<uint32_t>(plan_.head), front + Point{0, 0, 0.08},
                     bone_frame(front, front + Point{0, -0.02, 0.17}, 0.035, 0.03), 3, 0.6, 0.2));
  }

  const Blueprint& plan_;
  const Surface& body_;
  Random* random_;
  const std::vector<Point> normals_;
  Surface out_;
  Point neck_{};
  double waist_ = 0, knee_ = 0;  // heights
};

}  // namespace

Surface dress(const Blueprint& plan, const Surface& body, BodyPlan kind, Random* random) {
  return Wardrobe(plan, body, random).run(kind);
}

}  // namespace sinew::synth
