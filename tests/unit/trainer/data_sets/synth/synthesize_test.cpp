// SPDX-License-Identifier: MIT
// Promises of the character generator: sound meshes, exact weights, the same bytes for a seed, samples that still come
// out.
#include "sinew_data_sets/synthesize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

std::vector<BodyPlan> all_plans() {
  std::vector<BodyPlan> plans(std::begin(kBodyPlans), std::end(kBodyPlans));
  plans.insert(plans.end(), std::begin(kCreaturePlans), std::end(kCreaturePlans));
  return plans;
}

Character make(BodyPlan plan, uint64_t seed, int resolution, bool clothing) {
  SynthesizeOptions options;
  options.plan = plan;
  options.seed = seed;
  options.resolution = resolution;
  options.clothing = clothing;
  return synthesize(options);
}

struct Topology {
  std::map<std::pair<uint32_t, uint32_t>, int> directed;  // edges as walked by faces
  size_t open = 0;                                        // directed edges without a partner
  size_t parts = 0;
  std::vector<int> fans;  // [V] groups of faces around a vertex
};

uint32_t root_of(std::vector<uint32_t>* parent, uint32_t v) {
  while ((*parent)[v] != v) v = (*parent)[v] = (*parent)[(*parent)[v]];
  return v;
}

Topology topology_of(const Character& c) {
  Topology t;
  std::vector<uint32_t> parent(c.vertices.size());
  for (uint32_t v = 0; v < parent.size(); ++v) parent[v] = v;
  std::vector<std::map<uint32_t, uint32_t>> next(
      c.vertices.size());  // around a vertex: incoming neighbor -> outgoing one
  for (size_t f = 0; f < c.face_count(); ++f) {
    const uint32_t begin = c.face_offsets[f], count = c.face_offsets[f + 1] - begin;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t a = c.face_vertices[begin + i], b = c.face_vertices[begin + (i + 1) % count];
      const uint32_t before = c.face_vertices[begin + (i + count - 1) % count];
      ++t.directed[{a, b}];
      next[a][before] = b;
      parent[root_of(&parent, a)] = root_of(&parent, b);
    }
  }
  for (const auto& [edge, count] : t.directed) t.open += t.directed.count({edge.second, edge.first}) == 0 ? 1 : 0;
  std::set<uint32_t> roots;
  for (uint32_t v = 0; v < parent.size(); ++v) roots.insert(root_of(&parent, v));
  t.parts = roots.size();
  t.fans.assign(c.vertices.size(), 0);
  for (size_t v = 0; v < next.size(); ++v) {
    std::map<uint32_t, uint32_t> left = next[v];
    std::set<uint32_t> entered;
    for (const auto& [in, out] : left) entered.insert(out);
    // Start open fans at their beginning, closed ones anywhere.
    while (!left.empty()) {
      uint32_t at = left.begin()->first;
      for (const auto& [in, out] : left) {
        if (entered.count(in) == 0) {
          at = in;
          break;
        }
      }
      ++t.fans[v];
      for (auto found = left.find(at); found != left.end(); found = left.find(at)) {
        at = found->second;
        left.erase(found);
      }
    }
  }
  return t;
}

double face_area(const Character& c, size_t f) {
  double x = 0, y = 0, z = 0;
  const uint32_t begin = c.face_offsets[f], end = c.face_offsets[f + 1];
  for (uint32_t i = begin; i < end; ++i) {
    const Vec3 p = c.vertices[c.face_vertices[i]], q = c.vertices[c.face_vertices[i + 1 < end ? i + 1 : begin]];
    x += (double(p.y) - double(q.y)) * (double(p.z) + double(q.z));
    y += (double(p.z) - double(q.z)) * (double(p.x) + double(q.x));
    z += (double(p.x) - double(q.x)) * (double(p.y) + double(q.y));
  }
  return 0.5 * std::sqrt(x * x + y * y + z * z);
}

double volume(const Character& c) {
  double sum = 0;
  for (size_t f = 0; f < c.face_count(); ++f) {
    const Vec3 a = c.vertices[c.face_vertices[c.face_offsets[f]]];
    for (uint32_t i = c.face_offsets[f] + 2; i < c.face_offsets[f + 1]; ++i) {
      const Vec3 p = c.vertices[c.face_vertices[i - 1]], q = c.vertices[c.face_vertices[i]];
      sum += double(a.x) * (double(p.y) * double(q.z) - double(p.z) * double(q.y)) +
             double(a.y) * (double(p.z) * double(q.x) - double(p.x) * double(q.z)) +
             double(a.z) * (double(p.x) * double(q.y) - double(p.y) * double(q.x));
    }
  }
  return sum / 6;
}

uint64_t hash_of(const Character& c) {
  uint64_t hash = 0xCBF29CE484222325ull;
  const auto add = [&hash](int64_t v) { hash = (hash ^ static_cast<uint64_t>(v)) * 0x100000001B3ull; };
  for (const Vec3& v : c.vertices) {
    for (float x : {v.x, v.y, v.z}) add(std::llround(double(x) * 1e5));
  }
  for (uint32_t v : c.face_vertices) add(v);
  for (const auto& row : c.influences) {
    for (const Influence& i : row) {
      add(i.joint);
      add(std::llround(double(i.weight) * 1000));
    }
  }
  for (const Joint& j : c.joints) add(j.parent);
  return hash;
}

class EveryPlan : public ::testing::TestWithParam<BodyPlan> {};

// A body alone is one closed piece, with each edge walked once in each direction, that turns its outside out.
TEST_P(EveryPlan, BodyIsOneClosedManifold) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    for (int resolution : {24, 33}) {
      const Character c = make(GetParam(), seed, resolution, false);
      SCOPED_TRACE(c.name + " at " + std::to_string(resolution));
      const Topology t = topology_of(c);
      EXPECT_EQ(t.parts, 1u);
      EXPECT_EQ(t.open, 0u);
      for (const auto& [edge, count] : t.directed) ASSERT_EQ(count, 1) << "edge " << edge.first << " " << edge.second;
      for (size_t v = 0; v < t.fans.size(); ++v) ASSERT_EQ(t.fans[v], 1) << "vertex " << v;
      EXPECT_GT(volume(c), 0.003);
    }
  }
}

TEST_P(EveryPlan, ClothedCharactersHaveNoFoldedOrEmptyFaces) {
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const Character c = make(GetParam(), seed, 28, true);
    SCOPED_TRACE(c.name);
    const Topology t = topology_of(c);
    EXPECT_GE(t.parts, 2u) << "no eyes, no clothes";
    for (const auto& [edge, count] : t.directed) ASSERT_EQ(count, 1) << "edge " << edge.first << " " << edge.second;
    for (size_t v = 0; v < t.fans.size(); ++v) ASSERT_EQ(t.fans[v], 1) << "vertex " << v;
    for (size_t f = 0; f < c.face_count(); ++f) ASSERT_GT(face_area(c, f), 1e-7) << "face " << f;
    for (const Vec3& p : c.vertices) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
}

TEST_P(EveryPlan, WeightsAreExactAndJointsAreATree) {
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const Character c = make(GetParam(), seed, 24, true);
    SCOPED_TRACE(c.name);
    ASSERT_EQ(c.influences.size(), c.vertices.size());
    for (const auto& row : c.influences) {
      ASSERT_GE(row.size(), 1u);
      ASSERT_LE(row.size(), 4u);
      int64_t thousandths = 0;
      std::set<uint32_t> joints;
      for (const Influence& i : row) {
        ASSERT_LT(i.joint, c.joints.size());
        ASSERT_TRUE(joints.insert(i.joint).second) << "a joint twice in a row";
        const double scaled = double(i.weight) * 1000;
        ASSERT_NEAR(scaled, std::round(scaled), 1e-3);
        thousandths += std::llround(scaled);
      }
      ASSERT_EQ(thousandths, 1000);
    }
    int roots = 0;
    std::set<std::string> names;
    for (size_t j = 0; j < c.joints.size(); ++j) {
      roots += c.joints[j].parent < 0 ? 1 : 0;
      ASSERT_LT(c.joints[j].parent, static_cast<int>(j));
      ASSERT_TRUE(names.insert(c.joints[j].name).second) << c.joints[j].name;
    }
    EXPECT_EQ(roots, 1);
  }
}

// Both sides of a body must be the same body: the left leg's share of the weight equals the right one's.
TEST(Synthesize, BodiesAreMirrored) {
  const Character c = make(BodyPlan::kBiped, 22, 40, false);
  std::map<std::string, double> mass;
  for (const auto& row : c.influences) {
    for (const Influence& i : row) mass[c.joints[i.joint].name] += double(i.weight);
  }
  ASSERT_GT(mass["thigh.L"], 20);
  EXPECT_NEAR(mass["thigh.L"], mass["thigh.R"], 0.02 * mass["thigh.L"]);
  EXPECT_NEAR(mass["forearm.L"], mass["forearm.R"], 0.02 * mass["forearm.L"]);
}

class EveryCreature : public ::testing::TestWithParam<BodyPlan> {};

// What a skeleton is learned from: a name that says nothing teaches nothing, and a joint outside of its body the wrong
// thing.
TEST_P(EveryCreature, JointsHaveClassesAndStandInTheBody) {
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    const Character c = make(GetParam(), seed, 24, true);
    SCOPED_TRACE(c.name);
    Vec3 low = c.vertices[0], high = low;
    for (const Vec3& p : c.vertices) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const JointVerdicts verdicts = joint_verdicts(c.joints);
    for (size_t k = 0; k < c.joints.size(); ++k) {
      const Joint& j = c.joints[k];
      ASSERT_TRUE(verdicts.is_part(k)) << j.name;
      EXPECT_LT(verdicts.classes[k], SINEW_CLASS_OTHER) << j.name;
      if (j.name.ends_with("_end")) continue;  // a box stops short of it
      const Vec3 p = j.position;
      EXPECT_TRUE(p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y && p.z < high.z) << j.name;
    }
    EXPECT_NEAR(low.y, 0.0f, 0.2f * (high.y - low.y)) << "not on the floor";
    // The left side has a joint for each of the right one's, at the mirrored position.
    std::map<std::string, Vec3> by_name;
    for (const Joint& j : c.joints) by_name[j.name] = j.position;
    for (const auto& [name, p] : by_name) {
      const size_t side = name.find(".L");
      if (side == std::string::npos) continue;
      std::string other = name;
      other[side + 1] = 'R';
      ASSERT_TRUE(by_name.count(other)) << other;
      EXPECT_TRUE(by_name[other].x == -p.x && by_name[other].y == p.y && by_name[other].z == p.z) << name;
    }
  }
}

// What toys have that looks like arms and is none: over some seeds each occurs, and a head is high beside its body.
TEST(Synthesize, MascotsHaveBigHeadsHairEarsWingsAndTails) {
  std::map<std::string, int> with;
  int high = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    const Character c = make(BodyPlan::kMascot, seed, 24, false);
    const JointVerdicts verdicts = joint_verdicts(c.joints);
    std::map<uint32_t, std::string> kinds = {
        {SINEW_CLASS_HAIR, "hair"}, {SINEW_CLASS_EAR, "ears"}, {SINEW_CLASS_WING, "wings"}, {SINEW_CLASS_TAIL, "tail"}};
    std::set<std::string> found;
    float head = 0;
    for (size_t k = 0; k < c.joints.size(); ++k) {
      const auto kind = kinds.find(verdicts.classes[k]);
      if (kind != kinds.end()) found.insert(kind->second);
    }
    EXPECT_FALSE(found.empty()) << c.name;
    for (const std::string& kind : found) ++with[kind];
    // How high what follows the head is: from the lowest vertex that mostly does to the highest.
    float low = 1e9f;
    for (size_t v = 0; v < c.vertices.size(); ++v) {
      const Influence most = *std::max_element(c.influences[v].begin(), c.influences[v].end(),
                                               [](Influence a, Influence b) { return a.weight < b.weight; });
      if (c.joints[most.joint].name != "head") continue;
      low = std::min(low, c.vertices[v].y);
      head = std::max(head, c.vertices[v].y);
    }
    high += head - low > 0.35f * head ? 1 : 0;
  }
  for (const char* kind : {"hair", "ears", "wings", "tail"}) {
    EXPECT_GE(with[kind], 6) << kind;
    EXPECT_LE(with[kind], 34) << kind;
  }
  EXPECT_GE(high, 32);
}

// Smooth skins and rigid parts both occur, and no two creatures are alike.
TEST_P(EveryCreature, SeedsVary) {
  int rigid = 0;
  std::set<size_t> joint_counts;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    const Character c = make(GetParam(), seed, 24, true);
    bool all_rigid = true;
    for (const auto& row : c.influences) all_rigid = all_rigid && row.size() == 1;
    rigid += all_rigid ? 1 : 0;
    joint_counts.insert(c.joints.size());
  }
  EXPECT_GE(rigid, 8);
  EXPECT_LE(rigid, 28);
  EXPECT_GE(joint_counts.size(), 6u);
}

// Changes only with the generator itself; then samples/data must be made again (samples/data/README.md).
TEST(Synthesize, SeedsGiveTheSameCharacterEverywhere) {
  const std::map<BodyPlan, uint64_t> expected = {
      {BodyPlan::kBiped, 16625200270326584562ull},      {BodyPlan::kQuadruped, 9308260561266664488ull},
      {BodyPlan::kBird, 13318439284565765302ull},       {BodyPlan::kSnake, 3953238997546069265ull},
      {BodyPlan::kManyLegged, 15566189736412902489ull}, {BodyPlan::kDinosaur, 10832071083453145956ull},
      {BodyPlan::kFish, 9379203459780510572ull},        {BodyPlan::kBlob, 2869581529898377471ull},
      {BodyPlan::kBeast, 16170340158516760342ull},      {BodyPlan::kToy, 2287640016949408392ull},
      {BodyPlan::kFowl, 7651270643923474057ull},        {BodyPlan::kCrawler, 5956116377669104564ull},
      {BodyPlan::kMascot, 5869594466979057646ull}};
  for (const auto& [plan, hash] : expected) {
    EXPECT_EQ(hash_of(make(plan, 5, 24, true)), hash) << body_plan_name(plan);
    EXPECT_NE(hash_of(make(plan, 6, 24, true)), hash) << body_plan_name(plan);
  }
}

TEST(Synthesize, SamplesAreWhatTheirReadmeSays) {
  struct Made {
    const char* file;
    BodyPlan plan;
    uint64_t seed;
    int resolution;
  };
  const Made samples[] = {
      {"biped__robed", BodyPlan::kBiped, 27, 32},         {"biped__robot", BodyPlan::kBiped, 12, 32},
      {"quadruped__tailed", BodyPlan::kQuadruped, 3, 40}, {"bird__winged", BodyPlan::kBird, 4, 40},
      {"snake__long", BodyPlan::kSnake, 6, 40},           {"many-legged__plated", BodyPlan::kManyLegged, 1, 36}};
  for (const Made& sample : samples) {
    SCOPED_TRACE(sample.file);
    const Character file = read_character(std::string(SINEW_SOURCE_DIR) + "/samples/data/" + sample.file + ".obj");
    const Character again = make(sample.plan, sample.seed, sample.resolution, true);
    ASSERT_EQ(file.joints.size(), again.joints.size());
    EXPECT_EQ(file.face_vertices, again.face_vertices);
    ASSERT_EQ(file.vertices.size(), again.vertices.size());
    for (size_t v = 0; v < file.vertices.size(); ++v) {
      ASSERT_NEAR(file.vertices[v].x, again.vertices[v].x, 2e-6f);
      ASSERT_NEAR(file.vertices[v].y, again.vertices[v].y, 2e-6f);
      ASSERT_NEAR(file.vertices[v].z, again.vertices[v].z, 2e-6f);
    }
  }
}

// Clothes must be there to be of use: over some seeds, open shells, rigid characters and end markers all occur.
TEST(Synthesize, SeedsVary) {
  int open = 0, rigid = 0, with_ends = 0, with_floor_root = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    const Character c = make(BodyPlan::kBiped, seed, 24, true);
    open += topology_of(c).open > 0 ? 1 : 0;
    bool all_rigid = true;
    for (const auto& row : c.influences) all_rigid = all_rigid && row.size() == 1;
    rigid += all_rigid ? 1 : 0;
    with_ends += c.joints.back().name.ends_with("_end") ? 1 : 0;
    with_floor_root += c.joints[0].name == "root" ? 1 : 0;
  }
  EXPECT_GE(open, 15);
  EXPECT_GE(rigid, 1);
  EXPECT_LE(rigid, 15);
  EXPECT_GE(with_ends, 5);
  EXPECT_LE(with_ends, 25);
  EXPECT_GE(with_floor_root, 5);
  EXPECT_LE(with_floor_root, 25);
}

TEST(Synthesize, RefusesResolutionsOutOfRange) {
  EXPECT_THROW(make(BodyPlan::kBiped, 1, 23, true), Error);
  EXPECT_THROW(make(BodyPlan::kBiped, 1, 257, true), Error);
}

std::string test_name(const ::testing::TestParamInfo<BodyPlan>& plan) {
  std::string name = body_plan_name(plan.param);
  std::erase(name, '-');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Plans, EveryPlan, ::testing::ValuesIn(all_plans()), test_name);
INSTANTIATE_TEST_SUITE_P(Plans, EveryCreature, ::testing::ValuesIn(kCreaturePlans), test_name);

}  // namespace
}  // namespace sinew
