// SPDX-License-Identifier: MIT
// The integer heat fields against an independent float64 solution of engine/src/heat/README.md on the same integer
// mesh: brute-force visibility, its own Laplacian, Eigen's sparse LDL^T.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "heat/sources.hpp"
#include "heat_scene.hpp"
#include "shared_data.hpp"
#include "solve/laplacian.hpp"

namespace {

using namespace sinew;
using sinew_test::HeatRun;
using sinew_test::HeatScene;
using Vec = Eigen::Vector3d;

Vec vec(Vec3i p) { return {double(p.x), double(p.y), double(p.z)}; }

enum class Sight { kSeen, kHidden, kUnsure };

// The definition in float64. `unsure` choices (a tie at the very edge of its window, a ray through an edge) take the
// engine's answer and are counted.
struct Reference {
  const HeatRun& run;
  const Mesh& mesh;
  const Skeleton& skeleton;
  const HeatSources& engine;
  std::vector<bool> positive;  // [part_count] negative edge weights count as 0
  std::vector<uint32_t> bones;
  size_t unsure = 0;

  Vec nearest_point(uint32_t bone, const Vec& p) const {
    const Vec a = vec(skeleton.positions[bone]), d = vec(skeleton.bone_tail[bone]) - a;
    const double t = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
    return a + t * d;
  }

  double distance(uint32_t v, uint32_t bone, bool soft) const {
    const Vec p = vec(mesh.positions[v]);
    const Vec d = p - nearest_point(bone, p);
    if (soft || d.norm() == 0) return d.norm();
    const double cosine = d.dot(vec(mesh.normals[v])) / (d.norm() * 16384.0);
    return d.norm() / (0.5 * std::max(cosine + 1.001, 0.001));
  }

  // Front crossings of the open segment, with about a grid unit of doubt.
  Sight sight(uint32_t v, uint32_t bone, bool own_faces_only) const {
    const Vec p = vec(mesh.positions[v]);
    const Vec along = nearest_point(bone, p) - p;
    if (along.norm() < 1.5) return Sight::kSeen;
    bool doubt = false;
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
      const uint32_t* c = mesh.triangles + 3 * t;
      if (c[0] == v || c[1] == v || c[2] == v) continue;
      if (own_faces_only && mesh.part[c[0]] != mesh.part[v]) continue;
      const Vec a = vec(mesh.positions[c[0]]) - p, b = vec(mesh.positions[c[1]]) - p, e = vec(mesh.positions[c[2]]) - p;
      const Vec n = (b - a).cross(e - a);
      const double size = n.norm(), speed = n.dot(along) / size, depth = n.dot(a) / size;  // in grid units
      if (speed > 2 || depth > 2) continue;
      if (depth < speed - 2) continue;
      // Distance of the crossing from each edge, in grid units and inwards.
      double inside = 1e30;
      const Vec corners[3] = {a, b, e};
      const double s = speed == 0 ? 0 : depth / speed;
      const Vec q = std::clamp(s, 0.0, 1.0) * along;
      for (int k = 0; k < 3; ++k) {
        const Vec edge = corners[(k + 1) % 3] - corners[k];
        inside = std::min(inside, n.cross(edge).dot(q - corners[k]) / (size * edge.norm()));
      }
      const double slack = 2 + 2 * along.norm() / std::max(-speed, 1e-9);
      if (inside < -slack) continue;
      if (inside > slack && speed < -2 && depth < -2 && depth > speed + 2) return Sight::kHidden;
      doubt = true;
    }
    return doubt ? Sight::kUnsure : Sight::kSeen;
  }

  bool seen(uint32_t v, uint32_t bone, bool own_faces_only, bool engine_says) {
    switch (sight(v, bone, own_faces_only)) {
      case Sight::kSeen:
        return true;
      case Sight::kHidden:
        return false;
      case Sight::kUnsure:
        break;
    }
    ++unsure;
    return engine_says;
  }

  bool engine_has(uint32_t field, uint32_t v, uint32_t bone) const {
    const int m = HeatSources::metric_of(field);
    for (uint32_t t = 0; t < kMaxTies; ++t) {
      if (engine.ties[m][v * kMaxTies + t] == bone) return (engine.mask[field][v] >> t & 1) != 0;
    }
    return false;
  }

  // The engine's answer for the merged faces is only kept where it chose that rule; elsewhere a doubt counts as hidden.
  bool engine_merged(uint32_t v, uint32_t bone) const {
    return engine.part_rule[mesh.part[v]] == 0 && engine_has(kFieldRule, v, bone);
  }

  struct Source {
    std::vector<uint32_t> joints;
    double distance = 0;
  };

  // Bones within 1e-4 of the smallest distance.
  std::vector<uint32_t> tied(uint32_t v, double smallest, const std::vector<uint32_t>& among, bool soft,
                             uint32_t field) {
    std::vector<uint32_t> out;
    for (const uint32_t bone : among) {
      const double ratio = (distance(v, bone, soft) - smallest) / std::max(smallest, 1e-9);
      const double blur = 2e-6 + 0.04 / std::max(smallest, 1e-9);
      if (ratio < 1e-4 - blur) {
        out.push_back(bone);
      } else if (ratio < 1e-4 + blur) {
        ++unsure;
        const int m = HeatSources::metric_of(field);
        for (uint32_t t = 0; t < kMaxTies; ++t) {
          if (engine.ties[m][v * kMaxTies + t] == bone) out.push_back(bone);
        }
      }
    }
    return out;
  }

  std::vector<Source> sources(uint32_t field) {
    bones.clear();
    for (uint32_t j = 0; j < skeleton.joint_count; ++j) {
      if (run.source_joints[j]) bones.push_back(j);
    }
    std::vector<Source> merged(mesh.welded_count), parts(mesh.welded_count), open(mesh.welded_count);
    const bool soft = field == kFieldSoft;
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      std::vector<uint32_t> order = bones;
      std::stable_sort(order.begin(), order.end(),
                       [&](uint32_t a, uint32_t b) { return distance(v, a, soft) < distance(v, b, soft); });
      open[v].distance = distance(v, order[0], soft);
      open[v].joints = tied(v, open[v].distance, bones, soft, field);
      if (soft) {
        for (size_t i = 0; i < order.size(); ++i) {
          if (!seen(v, order[i], true, engine_has(field, v, order[i]))) continue;
          parts[v].distance = distance(v, order[i], soft);
          for (const uint32_t bone : tied(v, parts[v].distance, {order.begin() + long(i), order.end()}, soft, field)) {
            if (bone == order[i] || seen(v, bone, true, engine_has(field, v, bone))) parts[v].joints.push_back(bone);
          }
          break;
        }
        continue;
      }
      merged[v].distance = parts[v].distance = open[v].distance;
      for (const uint32_t bone : open[v].joints) {
        const bool by_parts = seen(v, bone, true, engine_has(kFieldParts, v, bone));
        if (by_parts) parts[v].joints.push_back(bone);
        if (by_parts && field == kFieldRule && seen(v, bone, false, engine_merged(v, bone)))
          merged[v].joints.push_back(bone);
      }
    }
    std::vector<Source> out(mesh.welded_count);
    for (uint32_t c = 0; c < mesh.part_count; ++c) {
      const uint32_t begin = mesh.part_offsets[c], end = mesh.part_offsets[c + 1];
      const auto share = [&](const std::vector<Source>& s) {
        size_t n = 0;
        for (uint32_t i = begin; i < end; ++i) n += !s[mesh.part_vertices[i]].joints.empty();
        return double(n) / (end - begin);
      };
      const std::vector<Source>* chosen = &parts;
      if (field == kFieldRule) {
        chosen = share(merged) > 0.1 ? &merged : share(parts) > 0.1 ? &parts : &open;
        EXPECT_EQ(engine.part_rule[c], chosen == &merged ? 0 : chosen == &parts ? 1 : 2);
      } else if (share(parts) == 0) {
        chosen = &open;
      }
      for (uint32_t i = begin; i < end; ++i) out[mesh.part_vertices[i]] = (*chosen)[mesh.part_vertices[i]];
    }
    return out;
  }

  Eigen::SparseMatrix<double> laplacian(std::vector<double>* area) const {
    std::map<std::pair<uint32_t, uint32_t>, std::pair<double, int>> edges;
    area->assign(mesh.welded_count, 0.0);
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
      const uint32_t* c = mesh.triangles + 3 * t;
      for (int k = 0; k < 3; ++k) {
        const uint32_t apex = c[k], b = c[(k + 1) % 3], e = c[(k + 2) % 3];
        const Vec u = vec(mesh.positions[b] - mesh.positions[apex]), w = vec(mesh.positions[e] - mesh.positions[apex]);
        const double twice_area = u.cross(w).norm();
        (*area)[apex] += twice_area / 6;
        auto& edge = edges[std::minmax(b, e)];
        edge.first += std::clamp(u.dot(w) / twice_area, -50.0, 50.0);
        ++edge.second;
      }
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& [ends, sum] : edges) {
      double w = sum.first / sum.second;
      if (positive[mesh.part[ends.first]]) w = std::max(w, 0.0);
      const int a = int(ends.first), b = int(ends.second);
      entries.insert(entries.end(), {{a, b, -w}, {b, a, -w}, {a, a, w}, {b, b, w}});
    }
    Eigen::SparseMatrix<double> l(mesh.welded_count, mesh.welded_count);
    l.setFromTriplets(entries.begin(), entries.end());
    return l;
  }

  Eigen::MatrixXd solve(uint32_t field) {
    const std::vector<Source> source = sources(field);
    Eigen::MatrixXd solution = solve_with(source, field);
    // A part whose solution leaves [-1, 2] has an indefinite matrix and is solved again without its negative
    // weights.
    const std::vector<bool> asked = positive;
    bool again = false;
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      if (solution.row(v).minCoeff() >= -1 && solution.row(v).maxCoeff() <= 2) continue;
      positive[mesh.part[v]] = true;
      again = true;
    }
    if (again) solution = solve_with(source, field);
    positive = asked;
    return solution;
  }

  Eigen::MatrixXd solve_with(const std::vector<Source>& source, uint32_t field) const {
    std::vector<double> area;
    Eigen::SparseMatrix<double> m = laplacian(&area);
    Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(mesh.welded_count, skeleton.joint_count);
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      const double n = double(source[v].joints.size());
      if (n == 0) continue;
      const double d = std::max(source[v].distance, 5e-5 * kSide);
      const double h = (field == kFieldSoft ? 0.7 : 4.0) * n / (d * d);
      const double a = std::max(area[v], 1.0);
      m.coeffRef(v, v) += a * h;
      for (const uint32_t j : source[v].joints) rhs(v, j) += a * h / n;
    }
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(m);
    EXPECT_EQ(factor.info(), Eigen::Success);
    return factor.solve(rhs);
  }
};

struct Difference {
  double mean = 0, largest = 0;
  size_t pairs = 0;
  uint32_t worst_vertex = 0;
};

Difference compare(const HeatRun& run, uint32_t field, const Eigen::MatrixXd& exact) {
  Difference d;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    for (uint32_t j = 0; j < run.skeleton.joint_count; ++j) {
      const double a = std::clamp(exact(v, j), 0.0, 1.0), b = run.weight(field, v, j);
      if (a < 1.0 / 4096 && b == 0) continue;
      // A full row leaves out what is smaller than its last slot.
      const uint16_t last = run.fields.field[field].weights[v * kHeatSlots + kHeatSlots - 1];
      if (b == 0 && last > 0 && a <= last / 32768.0 + 1e-4) continue;
      const double diff = std::abs(a - b);
      ++d.pairs;
      d.mean += diff;
      if (diff > d.largest) {
        d.largest = diff;
        d.worst_vertex = v;
      }
    }
  }
  d.mean /= double(std::max<size_t>(d.pairs, 1));
  return d;
}

// Returns the number of choices that were left to the engine.
size_t expect_agreement(const char* name, const HeatScene& scene, bool positive = false) {
  HeatRun run(scene);
  EXPECT_EQ(run.status, SINEW_OK) << name;
  if (run.status != SINEW_OK) return 0;
  HeatSources sources;
  const auto find = [&](Arena& arena) {
    sources.allocate(arena, run.counts);
    return find_sources(run.mesh, run.skeleton, run.source_joints.data(), run.counts, boxes_met_ref, {}, 1000, arena,
                        &sources);
  };
  Arena measure;
  (void)find(measure);
  std::unique_ptr<void, void (*)(void*)> block(std::aligned_alloc(64, measure.high_water()), std::free);
  Arena arena(block.get(), measure.high_water());
  EXPECT_EQ(find(arena), SINEW_OK);
  Reference reference{run, run.mesh, run.skeleton, sources, std::vector<bool>(run.mesh.part_count, positive), {}, 0};
  size_t all_unsure = 0;
  for (uint32_t field = 0; field < kFieldCount; ++field) {
    reference.unsure = 0;
    const Eigen::MatrixXd exact = reference.solve(field);
    const Difference d = compare(run, field, exact);
    std::printf(
        "[ heat     ] %-36s field %u: %u vertices, %u joints, mean %.1e, largest %.1e (vertex %u), unsure choices "
        "%zu\n",
        name, field, run.mesh.welded_count, run.skeleton.joint_count, d.mean, d.largest, d.worst_vertex,
        reference.unsure);
    EXPECT_LE(d.mean, 1e-4) << name << " field " << field;
    EXPECT_LE(d.largest, 2e-3) << name << " field " << field << " vertex " << d.worst_vertex;
    EXPECT_LE(reference.unsure, run.mesh.welded_count / 6 + 4) << name;
    all_unsure += reference.unsure;
  }
  return all_unsure;
}

TEST(HeatAgreement, Capsule) { expect_agreement("capsule", sinew_test::capsule(30, 17, 5)); }

TEST(HeatAgreement, ManyArms) { expect_agreement("star", sinew_test::star(28, 37, 4)); }

TEST(HeatAgreement, ClothesOverABody) {
  HeatScene scene = sinew_test::capsule(24, 19, 6);
  sinew_test::add_sleeve(&scene, 0.55, 0.5, 2.5, 9, 16);
  sinew_test::add_sleeve(&scene, 0.2, 1.5, 2.0, 4, 11);
  expect_agreement("capsule in a sleeve", scene);
}

TEST(HeatAgreement, BorderWithObtuseTriangles) {
  // A strip whose border triangles are very flat makes the matrix indefinite (a border edge counts in full).
  HeatScene scene;
  for (int i = 0; i <= 40; ++i) {
    scene.add_vertex(i, 3, 0);
    scene.add_vertex(i + 0.5, 3.3, 0.02 * (i % 3));
    scene.add_vertex(i, 6, 0.1);
  }
  for (uint32_t i = 0; i < 40; ++i) {
    const uint32_t a = 3 * i;
    scene.add_triangle(a, a + 1, a + 3);
    scene.add_triangle(a, a + 2, a + 1);
    scene.add_triangle(a + 1, a + 2, a + 5);
    scene.add_triangle(a + 1, a + 5, a + 3);
  }
  for (int j = 0; j < 5; ++j) scene.add_joint(2 + 9 * j, 4, -2, j - 1);
  expect_agreement("flat strip", scene);
}

TEST(HeatAgreement, TangleOnTheIterativeSolver) {
  expect_agreement("tangle", sinew_test::tangle(700, 1500, 4, 5), true);
}

HeatScene read_character(const std::filesystem::path& stem) {
  HeatScene scene;
  std::ifstream obj(stem.string() + ".obj");
  for (std::string line; std::getline(obj, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      double x, y, z;
      words >> x >> y >> z;
      scene.add_vertex(x, y, z);
    } else if (word == "f") {
      std::vector<uint32_t> corners;
      while (words >> word) corners.push_back(uint32_t(std::stoul(word) - 1));
      for (size_t k = 2; k < corners.size(); ++k) scene.add_triangle(corners[0], corners[k - 1], corners[k]);
    }
  }
  std::ifstream rig(stem.string() + ".rig.txt");
  std::map<std::string, int> index;
  for (std::string line; std::getline(rig, line);) {
    std::istringstream words(line);
    std::string word, name, child;
    words >> word;
    if (word == "joints") {
      double x, y, z;
      words >> name >> x >> y >> z;
      index[name] = int(scene.add_joint(x, y, z, -1));
    } else if (word == "hier") {
      words >> name >> child;
      scene.parents[size_t(index.at(child))] = index.at(name);
    }
  }
  return scene;
}

TEST(HeatAgreementShared, CharactersOfVal) {
  if (shared_folder().empty()) GTEST_SKIP() << "NOT RUN: the characters of ../shared are not on this machine";
  const std::filesystem::path val = shared_folder() / "data" / "characters" / "val";
  // All of them with SINEW_HEAT_ALL set (minutes: the reference tests every face for every vertex); else the small
  // ones.
  const bool all = std::getenv("SINEW_HEAT_ALL") != nullptr;
  size_t compared = 0;
  std::vector<std::filesystem::path> stems;
  for (const auto& entry : std::filesystem::directory_iterator(val)) {
    if (entry.path().extension() == ".obj") stems.push_back(val / entry.path().stem());
  }
  std::sort(stems.begin(), stems.end());
  for (const auto& stem : stems) {
    const HeatScene scene = read_character(stem);
    if (!all && scene.vertex_count() > 1000) continue;
    expect_agreement(stem.filename().string().substr(0, 36).c_str(), scene);
    ++compared;
  }
  EXPECT_GE(compared, 5u);
}

}  // namespace
