// SPDX-License-Identifier: MIT
// Copies in a data set, dividing it, and the page that shows it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "expect_error.hpp"
#include "sinew_datasets/dataset_page.hpp"
#include "sinew_datasets/dedup.hpp"
#include "sinew_datasets/split.hpp"
#include "sinew_datasets/synthesize.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace fs = std::filesystem;

namespace sinew {
namespace {

Character made(uint64_t seed) {
  SynthesizeOptions options;
  options.plan = BodyPlan::kQuadruped;
  options.seed = seed;
  options.resolution = 24;
  return synthesize(options);
}

// Another order of vertices, twice the size, somewhere else.
Character moved(const Character& c) {
  Character out = c;
  const auto count = static_cast<uint32_t>(c.vertices.size());
  const auto place = [&](const Vec3& p) { return Vec3{2 * p.x + 7, 2 * p.y - 3, 2 * p.z + 1}; };
  for (uint32_t v = 0; v < count; ++v) {
    out.vertices[count - 1 - v] = place(c.vertices[v]);
    out.influences[count - 1 - v] = c.influences[v];
  }
  for (uint32_t& v : out.face_vertices) v = count - 1 - v;
  for (Joint& joint : out.joints) {
    joint.position = place(joint.position);
    joint.name = "other " + joint.name;
  }
  return out;
}

std::vector<DuplicateGroup> groups_of(const std::vector<Character>& characters) {
  DuplicateFinder finder;
  for (const Character& c : characters) finder.add(c);
  return finder.groups();
}

TEST(Dedup, FindsCopiesThatMovedGrewAndChangedTheirOrder) {
  const Character a = made(1);
  const auto groups = groups_of({made(2), a, made(3), moved(a)});
  ASSERT_EQ(groups.size(), 1u);
  ASSERT_EQ(groups[0].members.size(), 2u);
  EXPECT_EQ(groups[0].members[0].index, 1u);
  EXPECT_EQ(groups[0].members[1].index, 3u);
  EXPECT_EQ(groups[0].members[1].likeness, Likeness::kSame);
  EXPECT_EQ(groups[0].members[1].like, 1u);
}

TEST(Dedup, TellsNearFromOtherWeightsAndOtherSkeletons) {
  const Character a = made(1);
  Character near = a, repainted = a, rerigged = a;
  for (size_t v = 0; v < near.vertices.size(); v += 2) near.vertices[v].y += 0.002f;
  for (size_t v = 0; v < a.vertices.size() / 2; ++v) repainted.influences[v] = {{0, 1.0f}};
  for (Joint& joint : rerigged.joints) joint.position.x += 0.2f;
  Character rerigged_again = rerigged;
  const auto groups = groups_of({a, near, repainted, rerigged, rerigged_again});
  ASSERT_EQ(groups.size(), 1u);
  const auto& m = groups[0].members;
  ASSERT_EQ(m.size(), 5u);
  EXPECT_EQ(m[1].likeness, Likeness::kNear);
  EXPECT_EQ(m[1].like, 0u);
  EXPECT_EQ(m[2].likeness, Likeness::kOtherWeights);
  EXPECT_EQ(m[2].like, 2u);
  EXPECT_GT(m[2].weights, 0.1);
  EXPECT_EQ(m[3].likeness, Likeness::kOtherSkeleton);
  EXPECT_EQ(m[3].like, 3u);
  EXPECT_EQ(m[4].likeness, Likeness::kSame) << "to the other skeleton's first";
  EXPECT_EQ(m[4].like, 3u);
  EXPECT_TRUE(groups_of({a, made(4)}).empty());
}

TEST(CharacterFiles, BelongTogetherAndAreNeverReplaced) {
  const TempFolder folder;
  const std::string data = std::string(SINEW_SOURCE_DIR) + "/samples/data/";
  EXPECT_EQ(character_files("x/a.glb"), std::vector<std::string>{"x/a.glb"});
  EXPECT_EQ(character_files("x/a.obj"), (std::vector<std::string>{"x/a.obj", "x/a.rig.txt"}));
  folder.write("part one.bin", "1234");
  const std::string document =
      folder.write("c.gltf", R"({"buffers":[{"uri":"part%20one.bin"},{"uri":"data:,x"}],"images":[]})");
  EXPECT_EQ(character_files(document), (std::vector<std::string>{document, folder.file("part one.bin")}));
  const std::string outside = folder.write("d.gltf", R"({"buffers":[{"uri":"../secret.bin"}]})");
  EXPECT_ERROR(character_files(outside), "outside");

  place_character(data + "snake__long.obj", folder.file("out"));
  EXPECT_EQ(read_file(folder.file("out/snake__long.rig.txt")), read_file(data + "snake__long.rig.txt"));
  EXPECT_ERROR(place_character(data + "snake__long.obj", folder.file("out")), "there already");
}

TEST(Split, KeepsUnitsTogetherAndComesAsCloseAsTheyAllow) {
  std::vector<std::string> keys;
  for (const auto& [family, count] : std::vector<std::pair<std::string, int>>{{"a", 50}, {"b", 7}, {"c", 5}, {"d", 3}})
    keys.insert(keys.end(), static_cast<size_t>(count), family);
  const std::vector<SplitUnit> units = split_units(keys);
  ASSERT_EQ(units.size(), 4u);
  std::set<std::vector<bool>> drawn;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<bool> chosen = choose_validation(units, 8.0 / 65, seed);
    EXPECT_EQ(chosen, choose_validation(units, 8.0 / 65, seed));
    size_t count = 0;
    for (size_t u = 0; u < units.size(); ++u) count += chosen[u] ? units[u].members.size() : 0;
    EXPECT_EQ(count, 8u) << "c and d; no other units come as close";
    drawn.insert(choose_validation(units, 0.1, seed));
  }
  for (const double share : {0.0, 1.0}) {
    const std::vector<bool> chosen = choose_validation(units, share, 1);
    const auto count = std::count(chosen.begin(), chosen.end(), true);
    EXPECT_GT(count, 0);
    EXPECT_LT(count, 4);
  }
  const std::vector<SplitUnit> singles = split_units({"p", "q", "r", "s", "t", "u"});
  for (uint64_t seed = 0; seed < 20; ++seed) drawn.insert(choose_validation(singles, 0.34, seed));
  EXPECT_GT(drawn.size(), 5u) << "other seeds, other choices";
  EXPECT_ERROR((choose_validation(split_units({"a", "a"}), 0.5, 1)), "at least two");
}

TEST(DatasetPage, ShowsFamiliesCharactersAndWarningsEscaped) {
  DatasetStats stats;
  stats.folder = "a <folder>";
  stats.candidate_counts = {6, 8};
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    CharacterStats one = character_stats(made(seed));
    one.family = seed == 3 ? "b&b" : "a";
    one.name = one.family + "__" + std::to_string(seed);
    one.recall = {0.5, 0.75};
    stats.characters.push_back(one);
  }
  stats.characters[0].png = {1, 2, 3};
  stats.characters[0].report.findings.push_back({CheckFinding::Level::kWarning, "odd-vertex", 1, "<one>"});
  stats.unreadable = {{"c.obj", "c.obj: line 1"}};
  const std::string html = dataset_html(stats);
  for (const char* text : {"a &lt;folder&gt;", "b&amp;b (1)", "a (2)", "odd-vertex: &lt;one&gt;", "75.00", "AQID",
                           "c.obj: line 1", "1 warning"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
  for (const char* outside : {"http:", "https:", "<script", "<link", "url(", "nan", "inf\""})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  const std::string table = dataset_table(stats);
  EXPECT_NE(table.find("recall@8"), std::string::npos);
  EXPECT_NE(table.find("(all)"), std::string::npos);
  EXPECT_NE(dataset_json(stats).find("\"8\": 0.75"), std::string::npos) << dataset_json(stats);
  EXPECT_ERROR(dataset_html({}), "no character");
}

TEST(DatasetPage, CountsInfluences) {
  Character c = made(1);
  c.influences.assign(c.vertices.size(), {{0, 0.5f}, {1, 0.5f}});
  c.influences[0].clear();
  c.influences[1] = {{2, 1.0f}};
  const CharacterStats stats = character_stats(c);
  EXPECT_EQ(stats.bound_joints, 3u);
  EXPECT_EQ(stats.vertices_with[0], 1u);
  EXPECT_EQ(stats.vertices_with[1], 1u);
  EXPECT_EQ(stats.vertices_with[2], c.vertices.size() - 2);
  EXPECT_NEAR(stats.influences_per_vertex(), 2, 0.01);
}

}  // namespace
}  // namespace sinew
