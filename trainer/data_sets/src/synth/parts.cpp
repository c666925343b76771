// SPDX-License-Identifier: MIT
// Lumps and shells of revolution, and bodies that are made of them.
#include <algorithm>
#include <map>

#include "synth/surface.hpp"

namespace sinew::synth {

Frame box_frame(double hx, double hy, double hz) { return {{hx, 0, 0}, {0, hy, 0}, {0, 0, hz}}; }

Frame bone_frame(Point a, Point b, double hx, double hy) {
  const Point z = (b - a) * 0.5, along = unit(z);
  const Point helper = along.y > 0.8 || along.y < -0.8 ? Point{0, 0, 1} : Point{0, 1, 0};
  const Point x = unit(cross(helper, along)), y = cross(along, x);
  return {x * hx, y * hy, z};
}

Surface lump(uint32_t joint, Point center, const Frame& frame, int n, double round, double taper) {
  Surface surface;
  std::map<std::array<int, 3>, uint32_t> known;
  const auto vertex = [&](std::array<int, 3> at) {
    const auto found = known.find(at);
    if (found != known.end()) return found->second;
    const Point cube = {2.0 * at[0] / n - 1, 2.0 * at[1] / n - 1, 2.0 * at[2] / n - 1};
    const Point p = mix(cube, unit(cube), round);
    const double across = mix(1.0, taper, (p.z + 1) * 0.5);
    const uint32_t id = static_cast<uint32_t>(surface.positions.size());
    surface.positions.push_back(center + frame.x * (p.x * across) + frame.y * (p.y * across) + frame.z * p.z);
    surface.influences.push_back({{joint, 1.0f}});
    known.emplace(at, id);
    return id;
  };
  // A mirrored frame would turn the lump inside out.
  const bool flipped = dot(cross(frame.x, frame.y), frame.z) < 0;
  for (int axis = 0; axis < 3; ++axis) {
    const size_t w = static_cast<size_t>(axis), u = (w + 1) % 3, v = (w + 2) % 3;
    for (int side = 0; side < 2; ++side) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          std::vector<uint32_t> face;
          constexpr int kAround[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
          for (const auto& around : kAround) {
            std::array<int, 3> at{};
            at[w] = side * n;
            at[u] = i + around[0];
            at[v] = j + around[1];
            face.push_back(vertex(at));
          }
          if ((side == 0) != flipped) std::reverse(face.begin(), face.end());
          surface.faces.push_back(std::move(face));
        }
      }
    }
  }
  return surface;
}

Surface revolve(uint32_t joint, Point center, const std::vector<std::array<double, 3>>& profile, int sides,
                bool closed) {
  Surface surface;
  std::vector<uint32_t> first;
  std::vector<bool> pole;
  for (const auto& [rx, rz, height] : profile) {
    first.push_back(static_cast<uint32_t>(surface.positions.size()));
    pole.push_back(rx == 0);
    const int count = rx == 0 ? 1 : sides;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * kPi * i / sides;
      surface.positions.push_back(center + Point{rx * sine(angle), height, rz * cosine(angle)});
      surface.influences.push_back({{joint, 1.0f}});
    }
  }
  const size_t rings = profile.size();
  for (size_t r = 0; r + (closed ? 0 : 1) < rings; ++r) {
    const size_t next = (r + 1) % rings;
    for (int i = 0; i < sides; ++i) {
      const uint32_t a = static_cast<uint32_t>(i), b = static_cast<uint32_t>((i + 1) % sides);
      std::vector<uint32_t> face;
      if (pole[r]) {
        face = {first[r], first[next] + a, first[next] + b};
      } else if (pole[next]) {
        face = {first[r] + a, first[next], first[r] + b};
      } else {
        face = {first[r] + a, first[next] + a, first[next] + b, first[r] + b};
      }
      surface.faces.push_back(std::move(face));
    }
  }
  return surface;
}

Surface eyes(const Blueprint& plan, Random* random) {
  Surface out;
  const double r = plan.head_radius, size = r * random->range(0.16, 0.3);
  for (double side : {1.0, -1.0}) {
    const Point at = plan.head_center + unit({side * 0.5, 0.25, 1.0}) * (r * 0.97);
    out.append(lump(static_cast<uint32_t>(plan.head), at, box_frame(size, size, size * 0.7), 2, 1.0));
  }
  return out;
}

Surface capsule_body(const Blueprint& plan, int sides) {
  constexpr int kCapRings = 3;
  Surface out;
  for (const Primitive& bone : plan.body) {
    // Built where the bone is round, then scaled.
    const Point s = bone.scale, a = {bone.a.x / s.x, bone.a.y / s.y, bone.a.z / s.z},
                b = {bone.b.x / s.x, bone.b.y / s.y, bone.b.z / s.z};
    const Frame frame = bone_frame(a, b, 1, 1);
    const Point along = unit(frame.z);
    Surface capsule;
    const auto add = [&](Point p) {
      capsule.positions.push_back({p.x * s.x, p.y * s.y, p.z * s.z});
      capsule.influences.push_back({{static_cast<uint32_t>(bone.joint), 1.0f}});
    };
    add(a - along * bone.ra);
    for (int ring = 0; ring < 2 * kCapRings; ++ring) {
      const bool first = ring < kCapRings;
      const double angle =
          first ? 0.5 * kPi * (ring + 1 - kCapRings) / kCapRings : 0.5 * kPi * (ring - kCapRings) / kCapRings;
      const double r = first ? bone.ra : bone.rb;
      const Point center = (first ? a : b) + along * (r * sine(angle));
      for (int i = 0; i < sides; ++i) {
        const double around = 2 * kPi * i / sides;
        add(center + (frame.x * cosine(around) + frame.y * sine(around)) * (r * cosine(angle)));
      }
    }
    add(b + along * bone.rb);
    const uint32_t count = static_cast<uint32_t>(sides), last = static_cast<uint32_t>(capsule.positions.size()) - 1;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t next = (i + 1) % count, top = last - count;
      capsule.faces.push_back({0, 1 + next, 1 + i});
      for (uint32_t ring = 0; ring + 1 < 2 * kCapRings; ++ring) {
        const uint32_t low = 1 + ring * count, high = low + count;
        capsule.faces.push_back({low + i, low + next, high + next, high + i});
      }
      capsule.faces.push_back({top + i, top + next, last});
    }
    out.append(capsule);
  }
  return out;
}

Surface rigid_body(const Blueprint& plan, Random* random) {
  Surface out;
  const double round = random->range(0.1, 0.9);
  const bool balls = random->chance(0.5);
  for (const Primitive& p : plan.body) {
    const double whole_length = length(p.b - p.a), r = std::max(p.ra, p.rb);
    // Stretch short bones to their thickness, leave a gap at the ends of long ones.
    const Point along = whole_length > 1e-6 ? (p.b - p.a) * (1 / whole_length) : Point{0, 1, 0};
    const double half = whole_length > 2 * r ? whole_length * 0.5 - 0.15 * r : r * 0.9;
    const Point center = mix(p.a, p.b, 0.5);
    Frame frame = bone_frame(center - along * half, center + along * half, p.ra, p.ra);
    for (Point* axis : {&frame.x, &frame.y}) *axis = {axis->x * p.scale.x, axis->y * p.scale.y, axis->z * p.scale.z};
    out.append(lump(static_cast<uint32_t>(p.joint), center, frame, 3, round, p.rb / p.ra));
    if (balls) {
      const double ball = p.ra * 0.7;
      out.append(lump(static_cast<uint32_t>(p.joint), p.a, box_frame(ball, ball, ball), 2, 1.0));
    }
  }
  return out;
}

}  // namespace sinew::synth
