// SPDX-License-Identifier: MIT
// The same character in other clothes: makes them, binds them and maps the rows back.
#include "robustness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "sinew_data_sets/dataset.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr uint32_t kNone = 0xFFFFFFFFu;

// A changed character, and which vertex and joint of the original each of its own is (kNone: a new one).
struct Changed {
  Character character;
  std::vector<uint32_t> vertex_of, joint_of;
};

// Mesh and joints alone: what only files carry would not fit the changed mesh.
Changed same(const Character& c) {
  Changed changed;
  changed.character.name = c.name;
  changed.character.vertices = c.vertices;
  changed.character.face_offsets = c.face_offsets;
  changed.character.face_vertices = c.face_vertices;
  changed.character.joints = c.joints;
  changed.vertex_of.resize(c.vertices.size());
  changed.joint_of.resize(c.joints.size());
  std::iota(changed.vertex_of.begin(), changed.vertex_of.end(), 0u);
  std::iota(changed.joint_of.begin(), changed.joint_of.end(), 0u);
  return changed;
}

Changed with_points(const Character& c, const std::function<Vec3(const Vec3&)>& transform) {
  Changed changed = same(c);
  for (Vec3& p : changed.character.vertices) p = transform(p);
  for (Joint& j : changed.character.joints) j.position = transform(j.position);
  return changed;
}

Changed moved(const Character& c, float step) {
  return with_points(c, [step](const Vec3& p) { return Vec3{p.x + 3 * step, p.y - step, p.z + 2 * step}; });
}
Changed scaled(const Character& c, float scale) {
  return with_points(c, [scale](const Vec3& p) { return Vec3{p.x * scale, p.y * scale, p.z * scale}; });
}
Changed turned(const Character& c, double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180;
  const double sine = std::sin(angle), cosine = std::cos(angle);
  return with_points(c, [=](const Vec3& p) {
    const double x = static_cast<double>(p.x), z = static_cast<double>(p.z);
    return Vec3{static_cast<float>(cosine * x + sine * z), p.y, static_cast<float>(cosine * z - sine * x)};
  });
}
// Left becomes right, with the joints: every joint is where its counterpart was.
Changed mirrored(const Character& c) {
  Changed changed = with_points(c, [](const Vec3& p) { return Vec3{-p.x, p.y, p.z}; });
  Character& m = changed.character;
  for (size_t f = 0; f < m.face_count(); ++f)
    std::reverse(m.face_vertices.begin() + m.face_offsets[f] + 1, m.face_vertices.begin() + m.face_offsets[f + 1]);
  return changed;
}

// Vertices in another order and faces from last to first.
Changed renumbered(const Character& c) {
  Changed changed = same(c);
  Character& n = changed.character;
  std::mt19937_64 random(7);
  std::shuffle(changed.vertex_of.begin(), changed.vertex_of.end(), random);
  std::vector<uint32_t> new_index(c.vertices.size());
  for (uint32_t v = 0; v < new_index.size(); ++v) {
    n.vertices[v] = c.vertices[changed.vertex_of[v]];
    new_index[changed.vertex_of[v]] = v;
  }
  n.face_offsets = {0};
  n.face_vertices.clear();
  for (size_t f = c.face_count(); f-- > 0;) {
    for (uint32_t i = c.face_offsets[f]; i < c.face_offsets[f + 1]; ++i)
      n.face_vertices.push_back(new_index[c.face_vertices[i]]);
    n.face_offsets.push_back(static_cast<uint32_t>(n.face_vertices.size()));
  }
  return changed;
}

Changed joints_renumbered(const Character& c) {
  Changed changed = same(c);
  std::vector<Joint>& joints = changed.character.joints;
  std::mt19937_64 random(7);
  std::shuffle(changed.joint_of.begin(), changed.joint_of.end(), random);
  std::vector<int> new_index(joints.size());
  for (uint32_t j = 0; j < joints.size(); ++j) {
    joints[j] = c.joints[changed.joint_of[j]];
    new_index[changed.joint_of[j]] = static_cast<int>(j);
  }
  for (Joint& j : joints) {
    if (j.parent >= 0) j.parent = new_index[static_cast<size_t>(j.parent)];
  }
  return changed;
}

Changed without_faces(const Character& c) {
  Changed changed = same(c);
  changed.character.face_offsets = {0};
  changed.character.face_vertices.clear();
  return changed;
}
void add_face(Character* c, std::initializer_list<uint32_t> corners) {
  c->face_vertices.insert(c->face_vertices.end(), corners);
  c->face_offsets.push_back(static_cast<uint32_t>(c->face_vertices.size()));
}

// Polygons become fans from their second corner, so that quads are cut along the other diagonal than the engine's.
Changed split(const Character& c) {
  Changed changed = without_faces(c);
  for (size_t f = 0; f < c.face_count(); ++f) {
    const uint32_t begin = c.face_offsets[f], n = c.face_offsets[f + 1] - begin;
    const auto corner = [&](uint32_t i) { return c.face_vertices[begin + (1 + i) % n]; };
    for (uint32_t i = 1; i + 1 < n; ++i) add_face(&changed.character, {corner(0), corner(i), corner(i + 1)});
  }
  return changed;
}

// Pairs of triangles that follow each other in the list and share an edge become quads, as exporters merge them.
Changed merged(const Character& c) {
  Changed changed = without_faces(c);
  const auto triangle = [&](size_t f) { return c.face_offsets[f + 1] - c.face_offsets[f] == 3; };
  for (size_t f = 0; f < c.face_count(); ++f) {
    const uint32_t* a = &c.face_vertices[c.face_offsets[f]];
    bool done = false;
    if (f + 1 < c.face_count() && triangle(f) && triangle(f + 1)) {
      const uint32_t* b = &c.face_vertices[c.face_offsets[f + 1]];
      for (uint32_t i = 0; i < 3 && !done; ++i) {
        for (uint32_t k = 0; k < 3 && !done; ++k) {
          if (a[i] != b[(k + 1) % 3] || a[(i + 1) % 3] != b[k]) continue;
          add_face(&changed.character, {a[(i + 1) % 3], a[(i + 2) % 3], a[i], b[(k + 2) % 3]});
          done = true;
        }
      }
    }
    if (done) {
      ++f;
      continue;
    }
    changed.character.face_vertices.insert(changed.character.face_vertices.end(), a,
                                           a + (c.face_offsets[f + 1] - c.face_offsets[f]));
    changed.character.face_offsets.push_back(static_cast<uint32_t>(changed.character.face_vertices.size()));
  }
  return changed;
}

// New vertices stand where none was.
Changed subdivided(const Character& c) {
  Changed changed = same(c);
  changed.character = subdivide(changed.character);
  changed.vertex_of.resize(changed.character.vertices.size(), kNone);
  return changed;
}

// Every corner gets a vertex of its own.
Changed unwelded(const Character& c) {
  Changed changed = same(c);
  Character& u = changed.character;
  for (uint32_t i = 0; i < u.face_vertices.size(); ++i) {
    changed.vertex_of.push_back(u.face_vertices[i]);
    u.vertices.push_back(c.vertices[u.face_vertices[i]]);
    u.face_vertices[i] = static_cast<uint32_t>(u.vertices.size()) - 1;
  }
  return changed;
}

// Vertices that are left stand where they stood.
Changed decimated(const Character& c) {
  Changed changed = same(c);
  changed.character = decimate(changed.character, 0.5);
  std::map<std::array<float, 3>, uint32_t> at;
  for (uint32_t v = 0; v < c.vertices.size(); ++v)
    at.emplace(std::array<float, 3>{c.vertices[v].x, c.vertices[v].y, c.vertices[v].z}, v);
  changed.vertex_of.clear();
  for (const Vec3& p : changed.character.vertices) {
    const auto found = at.find({p.x, p.y, p.z});
    changed.vertex_of.push_back(found == at.end() ? kNone : found->second);
  }
  return changed;
}

// Mesh and joints on a lattice of powers of two, 2^18 to 2^19 steps a side, so that floats hold them exactly wherever
// they are moved to.
Character on_lattice(const Character& c) {
  const float size = box_of(c.vertices).longest_side();
  const double step = std::ldexp(1.0, std::ilogb(size > 0 ? size : 1.0f) - 18);
  const auto snap = [&](float x) { return static_cast<float>(std::round(static_cast<double>(x) / step) * step); };
  return with_points(c, [&](const Vec3& p) { return Vec3{snap(p.x), snap(p.y), snap(p.z)}; }).character;
}

struct Change {
  const char* name;
  Demand demand;
  Changed (*make)(const Character&);
};

constexpr Change kChanges[] = {
    {"moved, nothing rounded", Demand::kEqual,
     [](const Character& c) { return moved(c, std::ldexp(1.0f, std::ilogb(box_of(c.vertices).longest_side()))); }},
    {"scaled by a half, nothing rounded", Demand::kEqual, [](const Character& c) { return scaled(c, 0.5f); }},
    {"vertices and faces renumbered", Demand::kEqual, renumbered},
    {"unwelded", Demand::kEqual, unwelded},
    {"moved, coordinates rounded", Demand::kRounding,
     [](const Character& c) { return moved(c, 1.3f * box_of(c.vertices).longest_side()); }},
    {"scaled by 0.37, coordinates rounded", Demand::kRounding, [](const Character& c) { return scaled(c, 0.37f); }},
    {"joints renumbered", Demand::kClose, joints_renumbered},
    {"faces split", Demand::kClose, split},
    {"faces merged", Demand::kClose, merged},
    {"turned by 30 degrees", Demand::kClose, [](const Character& c) { return turned(c, 30); }},
    {"turned by 90 degrees", Demand::kClose, [](const Character& c) { return turned(c, 90); }},
    {"mirrored", Demand::kClose, mirrored},
    {"decimated to a half", Demand::kClose, decimated},
    {"subdivided", Demand::kClose, subdivided},
};

double row_distance(const std::vector<Influence>& a, const std::vector<Influence>& b,
                    const std::vector<uint32_t>& joint_of) {
  std::map<uint32_t, double> difference;
  for (const Influence& i : a) difference[i.joint] += static_cast<double>(i.weight);
  for (const Influence& i : b) difference[joint_of[i.joint]] -= static_cast<double>(i.weight);
  double sum = 0;
  for (const auto& [joint, d] : difference) sum += std::fabs(d);
  return sum;
}

}  // namespace

std::vector<RobustnessFigure> measure_robustness(const Character& character, const BindRows& bind) {
  if (character.vertices.empty() || character.face_count() == 0)
    throw Error(character.name + ": has no faces, so that nothing can be split, merged or decimated; expected a mesh");
  const Character original = on_lattice(character);
  const std::vector<std::vector<Influence>> base = bind(original);
  std::vector<RobustnessFigure> figures;
  for (const Change& change : kChanges) {
    const Changed changed = change.make(original);
    const std::vector<std::vector<Influence>> other = bind(changed.character);
    RobustnessFigure figure{change.name, change.demand, 0, 0, 0};
    for (size_t v = 0; v < changed.vertex_of.size(); ++v) {
      if (changed.vertex_of[v] == kNone) continue;
      const double d = row_distance(base[changed.vertex_of[v]], other[v], changed.joint_of);
      figure.mean += d;
      figure.largest = std::max(figure.largest, d);
      ++figure.compared;
    }
    figure.mean /= static_cast<double>(std::max<size_t>(1, figure.compared));
    figures.push_back(figure);
  }
  return figures;
}

}  // namespace sinew
