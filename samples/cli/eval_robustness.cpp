// SPDX-License-Identifier: MIT
// sinew eval --robustness: binds the same character in other clothes (moved, turned, renumbered, remeshed ...) and
// tells how far the weights move.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <numeric>
#include <random>

#include "eval_studies.hpp"
#include "sinew_formats/dataset.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/binder.hpp"
#include "support.hpp"

namespace sinew::cli {
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

Changed with_points(const Character& c, const std::function<Vec3(const Vec3&)>& place) {
  Changed changed = same(c);
  for (Vec3& p : changed.character.vertices) p = place(p);
  for (Joint& j : changed.character.joints) j.position = place(j.position);
  return changed;
}

float size_of(const Character& c) {
  Vec3 low = c.vertices[0], high = low;
  for (const Vec3& p : c.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

Changed moved(const Character& c) {
  const float s = size_of(c);
  return with_points(c, [s](const Vec3& p) { return Vec3{p.x + 3.7f * s, p.y - 1.3f * s, p.z + 2.9f * s}; });
}
Changed scaled(const Character& c) {
  return with_points(c, [](const Vec3& p) { return Vec3{p.x * 0.37f, p.y * 0.37f, p.z * 0.37f}; });
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

Changed renumbered(const Character& c) {
  Changed changed = same(c);
  Character& n = changed.character;
  std::mt19937_64 random(7);
  std::vector<uint32_t> place_of_vertex(c.vertices.size()), place_of_joint(c.joints.size());
  std::shuffle(changed.vertex_of.begin(), changed.vertex_of.end(), random);
  std::shuffle(changed.joint_of.begin(), changed.joint_of.end(), random);
  for (uint32_t v = 0; v < n.vertices.size(); ++v) {
    n.vertices[v] = c.vertices[changed.vertex_of[v]];
    place_of_vertex[changed.vertex_of[v]] = v;
  }
  for (uint32_t j = 0; j < n.joints.size(); ++j) {
    n.joints[j] = c.joints[changed.joint_of[j]];
    place_of_joint[changed.joint_of[j]] = j;
  }
  for (Joint& j : n.joints) {
    if (j.parent >= 0) j.parent = static_cast<int>(place_of_joint[static_cast<size_t>(j.parent)]);
  }
  n.face_offsets = {0};
  n.face_vertices.clear();
  for (size_t f = c.face_count(); f-- > 0;) {
    for (uint32_t i = c.face_offsets[f]; i < c.face_offsets[f + 1]; ++i)
      n.face_vertices.push_back(place_of_vertex[c.face_vertices[i]]);
    n.face_offsets.push_back(static_cast<uint32_t>(n.face_vertices.size()));
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

// Every triangle into four, new vertices in the middle of the edges.
Changed subdivided(const Character& c) {
  Changed changed = without_faces(c);
  Character& s = changed.character;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
  const auto middle = [&](uint32_t a, uint32_t b) {
    const auto [at, is_new] = middles.emplace(std::minmax(a, b), static_cast<uint32_t>(s.vertices.size()));
    if (is_new) {
      const Vec3 p = s.vertices[a], q = s.vertices[b];
      s.vertices.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
      changed.vertex_of.push_back(kNone);
    }
    return at->second;
  };
  for (size_t f = 0; f < c.face_count(); ++f) {
    for (uint32_t i = c.face_offsets[f] + 1; i + 1 < c.face_offsets[f + 1]; ++i) {
      const uint32_t p = c.face_vertices[c.face_offsets[f]], q = c.face_vertices[i], r = c.face_vertices[i + 1];
      const uint32_t pq = middle(p, q), qr = middle(q, r), rp = middle(r, p);
      add_face(&s, {p, pq, rp});
      add_face(&s, {pq, q, qr});
      add_face(&s, {rp, qr, r});
      add_face(&s, {pq, qr, rp});
    }
  }
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

struct Change {
  const char* name;
  std::function<Changed(const Character&)> make;
};

const std::vector<Change>& changes() {
  static const std::vector<Change> list = {
      {"moved", moved},
      {"scaled by 0.37", scaled},
      {"vertices, faces and joints renumbered", renumbered},
      {"unwelded", unwelded},
      {"faces split", split},
      {"faces merged", merged},
      {"turned by 30 degrees", [](const Character& c) { return turned(c, 30); }},
      {"turned by 90 degrees", [](const Character& c) { return turned(c, 90); }},
      {"mirrored", mirrored},
      {"decimated to a half", decimated},
      {"subdivided", subdivided},
  };
  return list;
}

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

void study_robustness(const Study& study) {
  const std::vector<std::string> paths = list_characters(study.folder);
  if (paths.empty()) throw Error(study.folder + ": no characters; expected NAME.obj with NAME.rig.txt, or .glb files");
  std::vector<std::vector<double>> means(changes().size(), std::vector<double>(paths.size(), 0));
  std::vector<std::vector<double>> largest = means;
  parallel_for(paths.size(), study.jobs, [&](size_t i) {
    const Character original = same(read_character(paths[i])).character;
    BindOptions options;
    options.method = study.model == nullptr ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
    options.model = study.model;
    options.influence_count = study.influences;
    const BindResult base = bind(original, options);
    for (size_t k = 0; k < changes().size(); ++k) {
      if (original.face_count() == 0) continue;
      const Changed changed = changes()[k].make(original);
      const BindResult other = bind(changed.character, options);
      size_t compared = 0;
      for (size_t v = 0; v < changed.vertex_of.size(); ++v) {
        if (changed.vertex_of[v] == kNone) continue;
        const double d = row_distance(base.influences[changed.vertex_of[v]], other.influences[v], changed.joint_of);
        means[k][i] += d;
        largest[k][i] = std::max(largest[k][i], d);
        ++compared;
      }
      means[k][i] /= static_cast<double>(std::max<size_t>(1, compared));
    }
  });
  std::printf(
      "| change (%zu characters) | mean L1 between the weights | worst character | its name | largest of a vertex |\n"
      "|---|---|---|---|---|\n",
      paths.size());
  for (size_t k = 0; k < changes().size(); ++k) {
    const double mean = std::accumulate(means[k].begin(), means[k].end(), 0.0) / static_cast<double>(paths.size());
    const size_t worst = static_cast<size_t>(std::max_element(means[k].begin(), means[k].end()) - means[k].begin());
    std::printf("| %s | %.5f | %.5f | %s | %.5f |\n", changes()[k].name, mean, means[k][worst],
                means[k][worst] > 0 ? stem(paths[worst]).c_str() : "",
                *std::max_element(largest[k].begin(), largest[k].end()));
  }
}

}  // namespace sinew::cli
