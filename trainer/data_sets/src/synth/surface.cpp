// SPDX-License-Identifier: MIT
// Distance field, skin weights and polygoniser of generated bodies.
#include "synth/surface.hpp"

#include <algorithm>
#include <array>

namespace sinew::synth {

void Surface::append(const Surface& piece) {
  const uint32_t base = static_cast<uint32_t>(positions.size());
  positions.insert(positions.end(), piece.positions.begin(), piece.positions.end());
  influences.insert(influences.end(), piece.influences.begin(), piece.influences.end());
  for (std::vector<uint32_t> face : piece.faces) {
    for (uint32_t& v : face) v += base;
    faces.push_back(std::move(face));
  }
}

std::vector<Point> vertex_normals(const Surface& surface) {
  std::vector<Point> normals(surface.positions.size());
  for (const std::vector<uint32_t>& face : surface.faces) {
    Point sum;
    for (size_t i = 2; i < face.size(); ++i) {
      sum = sum + cross(surface.positions[face[i - 1]] - surface.positions[face[0]],
                        surface.positions[face[i]] - surface.positions[face[0]]);
    }
    for (uint32_t v : face) normals[v] = normals[v] + sum;
  }
  for (Point& n : normals) n = unit(n);
  return normals;
}

double primitive_distance(const Primitive& primitive, Point p) {
  const Point s = primitive.scale;
  const Point q = {(p.x - primitive.a.x) / s.x, (p.y - primitive.a.y) / s.y, (p.z - primitive.a.z) / s.z};
  const Point d = primitive.b - primitive.a;
  const Point bone = {d.x / s.x, d.y / s.y, d.z / s.z};
  const double squared = dot(bone, bone);
  const double t = squared > 0 ? clamp01(dot(q, bone) / squared) : 0;
  return (length(q - bone * t) - mix(primitive.ra, primitive.rb, t)) * std::min({s.x, s.y, s.z});
}

double body_distance(const Blueprint& plan, Point p) {
  double sum = 1e9;
  for (const Primitive& primitive : plan.body) {
    const double d = primitive_distance(primitive, p);
    // Polynomial smooth minimum; its width follows the thinner end so that thin limbs do not swell.
    const double k = plan.blend * std::min(primitive.ra, primitive.rb);
    const double gap = sum > d ? sum - d : d - sum;
    const double h = gap < k ? (k - gap) / k : 0;
    sum = std::min(sum, d) - h * h * k * 0.25;
  }
  return sum;
}

std::vector<Influence> tidy_weights(std::vector<Influence> row) {
  std::stable_sort(row.begin(), row.end(), [](const Influence& a, const Influence& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
  if (row.size() > 4) row.resize(4);
  double sum = 0;
  for (const Influence& i : row) sum += static_cast<double>(i.weight);
  std::vector<int> thousandths;
  int total = 0;
  for (const Influence& i : row) {
    int part = static_cast<int>(static_cast<double>(i.weight) / sum * 1000 + 0.5);
    if (part < 10) part = 0;
    thousandths.push_back(part);
    total += part;
  }
  thousandths[0] += 1000 - total;
  std::vector<Influence> tidy;
  for (size_t i = 0; i < row.size(); ++i) {
    if (thousandths[i] > 0) tidy.push_back({row[i].joint, static_cast<float>(thousandths[i] / 1000.0)});
  }
  return tidy;
}

std::vector<Influence> body_weights(const Blueprint& plan, Point p) {
  const size_t joints = plan.joints.size();
  std::vector<double> distance(joints, 1e9), reach(joints, 0);
  for (const Primitive& primitive : plan.body) {
    const size_t j = static_cast<size_t>(primitive.joint);
    const double d = primitive_distance(primitive, p);
    if (d < distance[j]) {
      distance[j] = d;
      // Going x past the end of a capsule of radius r costs x^2 / 2r of distance. So that a blend ends within the next
      // bone, the reach of a short thick one (a spine's) is what its own length costs; but no joint is sharper than a
      // quarter of its radius.
      const double r = std::min(primitive.ra, primitive.rb), l = length(primitive.b - primitive.a);
      reach[j] = std::max(0.25 * r, std::min(r, l * l / (2 * r)));
    }
  }
  const size_t best = static_cast<size_t>(std::min_element(distance.begin(), distance.end()) - distance.begin());
  const auto parent = [&](int joint) {
    return joint == kNoJoint ? kNoJoint : plan.joints[static_cast<size_t>(joint)].parent;
  };
  const int self = static_cast<int>(best), up = parent(self);
  std::vector<Influence> row;
  for (size_t j = 0; j < joints; ++j) {
    const int other = static_cast<int>(j), other_up = parent(other);
    const bool related = other == self || other == up || other_up == self ||
                         (up != kNoJoint && (other_up == up || other == parent(up))) ||
                         (other_up != kNoJoint && parent(other_up) == self);
    if (!related || distance[j] > 1e8) continue;
    const double width = plan.softness * std::min(reach[j], reach[best]);
    const double weight = smooth_step(0, 1, 1 - (distance[j] - distance[best]) / width);
    if (weight > 0) row.push_back({static_cast<uint32_t>(j), static_cast<float>(weight)});
  }
  return tidy_weights(std::move(row));
}

namespace {

class Grid {
 public:
  Grid(const Blueprint& plan) : cell_(plan.cell) {
    Point low = plan.body[0].a, high = low;
    for (const Primitive& p : plan.body) {
      const double r = std::max(p.ra, p.rb) * 1.1;
      for (Point end : {p.a, p.b}) {
        low = {std::min(low.x, end.x - r * p.scale.x), std::min(low.y, end.y - r * p.scale.y),
               std::min(low.z, end.z - r * p.scale.z)};
        high = {std::max(high.x, end.x + r * p.scale.x), std::max(high.y, end.y + r * p.scale.y),
                std::max(high.z, end.z + r * p.scale.z)};
      }
    }
    // Whole cells around the box, and x = 0 in the middle of a cell, so that mirrored bodies get mirrored vertices.
    const double half_x = std::max(high.x, -low.x);
    const int half = static_cast<int>(half_x / cell_) + 3;
    size_ = {2 * half + 2, static_cast<int>((high.y - low.y) / cell_) + 6,
             static_cast<int>((high.z - low.z) / cell_) + 6};
    origin_ = {-(half + 0.5) * cell_, low.y - 2.5 * cell_, low.z - 2.5 * cell_};
    value_.resize(static_cast<size_t>(size_[0]) * static_cast<size_t>(size_[1]) * static_cast<size_t>(size_[2]));
    for (int z = 0; z < size_[2]; ++z) {
      for (int y = 0; y < size_[1]; ++y) {
        int skip = 0;
        double d = 0;
        for (int x = 0; x < size_[0]; ++x) {
          if (skip > 0) {
            --skip;
          } else {
            d = body_distance(plan, corner(x, y, z));
            // The field changes by less than 2.5 per unit (tapered limbs are the steepest): far from the surface its
            // sign cannot change over the next corners, and only values beside a change of sign matter.
            skip = static_cast<int>((d < 0 ? -d : d) / (2.5 * cell_)) - 1;
          }
          // The outermost layer is outside whatever the field says: every surface closes inside the grid.
          const bool border = x == 0 || y == 0 || z == 0 || x + 1 == size_[0] || y + 1 == size_[1] || z + 1 == size_[2];
          value_[index(x, y, z)] = border ? std::max(d, cell_) : d;
        }
      }
    }
  }
  size_t index(int x, int y, int z) const {
    return (static_cast<size_t>(z) * static_cast<size_t>(size_[1]) + static_cast<size_t>(y)) *
               static_cast<size_t>(size_[0]) +
           static_cast<size_t>(x);
  }
  Point corner(int x, int y, int z) const { return origin_ + Point{x * cell_, y * cell_, z * cell_}; }
  bool inside(int x, int y, int z) const { return value_[index(x, y, z)] < 0; }
  double value(int x, int y, int z) const { return value_[index(x, y, z)]; }
  const std::array<int, 3>& size() const { return size_; }
  double cell() const { return cell_; }

  // Fills outside corners (the nearest to the surface first) until no face of a cell is a checkerboard and the inside
  // and the outside corners of every cell are connected by edges. Filling only ever adds, so this ends.
  void make_well_composed() {
    bool changed = true;
    while (changed) {
      changed = false;
      for (int z = 1; z + 2 < size_[2]; ++z) {
        for (int y = 1; y + 2 < size_[1]; ++y) {
          for (int x = 1; x + 2 < size_[0]; ++x) {
            while (repair(x, y, z)) changed = true;
          }
        }
      }
    }
  }

  // Keeps the largest inside body and fills enclosed holes. Well-composed bodies touch by faces only, so six neighbors
  // suffice.
  void keep_one_body() {
    std::vector<int> label(value_.size(), -1);
    std::vector<size_t> stack;
    std::vector<bool> is_inside;
    std::vector<size_t> sizes;
    const size_t step_y = static_cast<size_t>(size_[0]), step_z = step_y * static_cast<size_t>(size_[1]);
    for (size_t seed = 0; seed < value_.size(); ++seed) {
      if (label[seed] >= 0) continue;
      const int now = static_cast<int>(sizes.size());
      const bool in = value_[seed] < 0;
      is_inside.push_back(in);
      sizes.push_back(0);
      label[seed] = now;
      stack.assign(1, seed);
      while (!stack.empty()) {
        const size_t at = stack.back();
        stack.pop_back();
        ++sizes.back();
        const size_t x = at % step_y, y = at / step_y % static_cast<size_t>(size_[1]), z = at / step_z;
        const auto visit = [&](size_t next) {
          if (label[next] < 0 && (value_[next] < 0) == in) {
            label[next] = now;
            stack.push_back(next);
          }
        };
        if (x > 0) visit(at - 1);
        if (x + 1 < step_y) visit(at + 1);
        if (y > 0) visit(at - step_y);
        if (y + 1 < static_cast<size_t>(size_[1])) visit(at + step_y);
        if (z > 0) visit(at - step_z);
        if (z + 1 < static_cast<size_t>(size_[2])) visit(at + step_z);
      }
    }
    size_t body = sizes.size();
    for (size_t i = 0; i < sizes.size(); ++i) {
      if (is_inside[i] && (body == sizes.size() || sizes[i] > sizes[body])) body = i;
    }
    const size_t air = 0;  // the corner of the grid is outside
    for (size_t i = 0; i < value_.size(); ++i) {
      const size_t l = static_cast<size_t>(label[i]);
      if (is_inside[l] && l != body) value_[i] = cell_ * 0.5;
      if (!is_inside[l] && l != air) value_[i] = -cell_ * 0.5;
    }
  }

 private:
  // Fills one corner of cell (x, y, z) if the cell is ambiguous.
  bool repair(int x, int y, int z) {
    unsigned mask = 0;
    for (unsigned c = 0; c < 8; ++c) {
      if (inside(x + static_cast<int>(c & 1), y + static_cast<int>(c >> 1 & 1), z + static_cast<int>(c >> 2)))
        mask |= 1u << c;
    }
    if (mask == 0 || mask == 255 || !ambiguous(mask)) return false;
    double nearest = 1e30;
    size_t fill = 0;
    for (unsigned c = 0; c < 8; ++c) {
      if (mask >> c & 1) continue;
      // Only a corner beside an inside one can join bodies.
      if (!((mask >> (c ^ 1) & 1) || (mask >> (c ^ 2) & 1) || (mask >> (c ^ 4) & 1))) continue;
      const size_t i =
          index(x + static_cast<int>(c & 1), y + static_cast<int>(c >> 1 & 1), z + static_cast<int>(c >> 2));
      if (value_[i] < nearest) {
        nearest = value_[i];
        fill = i;
      }
    }
    value_[fill] = -0.05 * cell_;
    return true;
  }
  static bool connected(unsigned mask) {
    unsigned reached = mask & (~mask + 1), before = 0;
    while (reached != before) {
      before = reached;
      for (unsigned c = 0; c < 8; ++c) {
        if (reached >> c & 1) reached |= mask & ((1u << (c ^ 1)) | (1u << (c ^ 2)) | (1u << (c ^ 4)));
      }
    }
    return reached == mask;
  }
  static bool ambiguous(unsigned mask) {
    if (!connected(mask) || !connected(~mask & 255u)) return true;
    constexpr unsigned kFaces[6][4] = {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                       {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};
    for (const auto& face : kFaces) {
      const unsigned a = mask >> face[0] & 1, b = mask >> face[1] & 1, c = mask >> face[2] & 1, d = mask >> face[3] & 1;
      if (a == c && b == d && a != b) return true;
    }
    return false;
  }

  double cell_;
  Point origin_;
  std::array<int, 3> size_{};
  std::vector<double> value_;
};

// Forward differences; `here` is the field at p.
Point gradient(const Blueprint& plan, Point p, double here, double h) {
  return {(body_distance(plan, p + Point{h, 0, 0}) - here) / h, (body_distance(plan, p + Point{0, h, 0}) - here) / h,
          (body_distance(plan, p + Point{0, 0, h}) - here) / h};
}

// Evens out the faces: each vertex moves halfway to the mean of its neighbors, then back onto the surface by Newton
// steps.
void relax(const Blueprint& plan, const std::vector<Point>& low, const std::vector<Point>& high, Surface* surface) {
  const size_t count = surface->positions.size();
  for (int round = 0; round < 4; ++round) {
    std::vector<Point> sum(count);
    std::vector<int> neighbors(count, 0);
    for (const std::vector<uint32_t>& face : surface->faces) {
      for (size_t i = 0; i < face.size(); ++i) {
        // Each edge is walked once in each direction, by its two faces.
        sum[face[i]] = sum[face[i]] + surface->positions[face[(i + 1) % face.size()]];
        ++neighbors[face[i]];
      }
    }
    for (size_t v = 0; v < count; ++v) {
      const auto clamped = [&](Point p) {
        return Point{std::clamp(p.x, low[v].x, high[v].x), std::clamp(p.y, low[v].y, high[v].y),
                     std::clamp(p.z, low[v].z, high[v].z)};
      };
      Point p = clamped(mix(surface->positions[v], sum[v] * (1.0 / neighbors[v]), 0.5));
      for (int step = 0; step < 2; ++step) {
        const double here = body_distance(plan, p);
        const Point g = gradient(plan, p, here, 0.01 * plan.cell);
        const double slope = dot(g, g);
        if (slope < 0.04) break;  // between two limbs the field has a ridge: stay
        p = clamped(p - g * (here / slope));
      }
      surface->positions[v] = p;
    }
  }
}

}  // namespace

Surface polygonise(const Blueprint& plan) {
  Grid grid(plan);
  // Removing stray bodies can only take away whole bodies and fill whole holes, which keeps the grid well-composed.
  grid.make_well_composed();
  grid.keep_one_body();
  const std::array<int, 3> n = grid.size();

  Surface surface;
  // A vertex stays well inside its own cell, so no two vertices can meet and no face can vanish.
  const Point margin = Point{0.06, 0.06, 0.06} * grid.cell();
  std::vector<Point> low, high;
  std::vector<int64_t> vertex_of(static_cast<size_t>(n[0]) * static_cast<size_t>(n[1]) * static_cast<size_t>(n[2]), -1);
  for (int z = 0; z + 1 < n[2]; ++z) {
    for (int y = 0; y + 1 < n[1]; ++y) {
      for (int x = 0; x + 1 < n[0]; ++x) {
        Point sum;
        int crossings = 0;
        const int at[3] = {x, y, z};
        for (int axis = 0; axis < 3; ++axis) {
          const int u = (axis + 1) % 3, v = (axis + 2) % 3;
          for (int corner = 0; corner < 4; ++corner) {
            int a[3] = {at[0], at[1], at[2]};
            a[u] += corner & 1;
            a[v] += corner >> 1;
            int b[3] = {a[0], a[1], a[2]};
            ++b[axis];
            const double da = grid.value(a[0], a[1], a[2]), db = grid.value(b[0], b[1], b[2]);
            if ((da < 0) == (db < 0)) continue;
            sum = sum + mix(grid.corner(a[0], a[1], a[2]), grid.corner(b[0], b[1], b[2]), da / (da - db));
            ++crossings;
          }
        }
        if (crossings == 0) continue;
        const Point p = sum * (1.0 / crossings);
        low.push_back(grid.corner(x, y, z) + margin);
        high.push_back(grid.corner(x + 1, y + 1, z + 1) - margin);
        vertex_of[grid.index(x, y, z)] = static_cast<int64_t>(surface.positions.size());
        surface.positions.push_back(p);
      }
    }
  }
  // A quad around every grid edge that crosses the surface, through the four cells that share the edge.
  for (int z = 1; z + 1 < n[2]; ++z) {
    for (int y = 1; y + 1 < n[1]; ++y) {
      for (int x = 1; x + 1 < n[0]; ++x) {
        const int at[3] = {x, y, z};
        for (int axis = 0; axis < 3; ++axis) {
          const int u = (axis + 1) % 3, v = (axis + 2) % 3;
          int end[3] = {x, y, z};
          ++end[axis];
          const bool in_a = grid.inside(x, y, z), in_b = grid.inside(end[0], end[1], end[2]);
          if (in_a == in_b) continue;
          std::vector<uint32_t> face;
          constexpr int kAround[4][2] = {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}};
          for (const auto& around : kAround) {
            int c[3] = {at[0], at[1], at[2]};
            c[u] += around[0];
            c[v] += around[1];
            face.push_back(static_cast<uint32_t>(vertex_of[grid.index(c[0], c[1], c[2])]));
          }
          // (axis, u, v) is right-handed: the order above is counter-clockwise seen from +axis.
          if (in_b) std::reverse(face.begin(), face.end());
          surface.faces.push_back(std::move(face));
        }
      }
    }
  }
  relax(plan, low, high, &surface);
  surface.influences.reserve(surface.positions.size());
  for (Point p : surface.positions) surface.influences.push_back(body_weights(plan, p));
  return surface;
}

}  // namespace sinew::synth
