// SPDX-License-Identifier: MIT
// What is done about seams does not depend on which way faces look: a mesh and the same mesh inside out get equal bytes.
#include <gtest/gtest.h>

#include <cstdio>
#include <set>

#include "block_body.hpp"
#include "draw.hpp"
#include "shared_data.hpp"
#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/jobs/bind_job.hpp"
#include "sinew_character/models/models.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

void expect_same_rows(const WeightRows& rows, const WeightRows& others) {
  ASSERT_EQ(rows.size(), others.size());
  for (size_t v = 0; v < rows.size(); ++v) {
    ASSERT_EQ(rows[v].size(), others[v].size()) << v;
    for (size_t i = 0; i < rows[v].size(); ++i) {
      ASSERT_EQ(rows[v][i].joint, others[v][i].joint) << v;
      ASSERT_EQ(rows[v][i].weight, others[v][i].weight) << v;
    }
  }
}

// Legs that have grown together, of uneven shape, with faces of three and four corners that begin anywhere.
Character uneven_body(sinew_test::Draw& draw) {
  const Character even = block_body(1, 3);
  Character body = even;
  for (Vec3& p : body.vertices)
    for (float* const coordinate : {&p.x, &p.y, &p.z}) *coordinate += draw.range(-0.25f, 0.25f);
  body.face_offsets = {0};
  body.face_vertices.clear();
  const auto add_face = [&](const std::vector<uint32_t>& corners) {
    const uint32_t start = draw.below(static_cast<uint32_t>(corners.size()));
    for (size_t k = 0; k < corners.size(); ++k) body.face_vertices.push_back(corners[(start + k) % corners.size()]);
    body.face_offsets.push_back(static_cast<uint32_t>(body.face_vertices.size()));
  };
  for (size_t f = 0; f < even.face_count(); ++f) {
    const uint32_t* const c = &even.face_vertices[even.face_offsets[f]];
    if (draw.chance(50)) {
      add_face({c[0], c[1], c[2], c[3]});
      continue;
    }
    add_face({c[0], c[1], c[2]});
    add_face({c[2], c[3], c[0]});
  }
  return body;
}

TEST(SeamsProperty, AMeshInsideOutGetsTheSameBytes) {
  size_t with_seams = 0;
  for (uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    sinew_test::Draw draw(seed);
    Character body = uneven_body(draw), twin = inside_out(body);
    body.influences = twin.influences = blurred(body);
    const Seams seams = find_seams(body, body.influences), of_twin = find_seams(twin, twin.influences);
    ASSERT_EQ(seams.edges, of_twin.edges);
    ASSERT_EQ(seams.homes, of_twin.homes);
    if (seams.seams.empty()) continue;
    ++with_seams;
    keep_apart(body, seams, {}, &body.influences);
    keep_apart(twin, of_twin, {}, &twin.influences);
    expect_same_rows(body.influences, twin.influences);
    ASSERT_EQ(cut_seams(seams, &body), cut_seams(of_twin, &twin));
    expect_same_rows(body.influences, twin.influences);
    ASSERT_EQ(body.face_vertices, inside_out(twin).face_vertices);
    if (HasFailure()) return;
  }
  EXPECT_GE(with_seams, 20u);
}

// The first character of every training family that is small enough.
TEST(SharedSeams, CharactersInsideOutGetTheSameBytes) {
  if (shared_folder().empty())
    GTEST_SKIP() << "NO SHARED DATA HERE: no real mesh was turned inside out; set SINEW_SHARED_DIR";
  constexpr size_t kMostVertices = 3000;
  const std::unique_ptr<LoadedModel> model = load_model("");
  std::set<std::string> families;
  size_t bound = 0, with_seams = 0;
  for (const std::string& path : list_characters((shared_folder() / "data" / "characters" / "train").string())) {
    Character character = read_character(path);
    if (!families.insert(character.name.substr(0, character.name.find("__"))).second) continue;
    if (character.vertices.size() > kMostVertices) continue;
    SCOPED_TRACE(path);
    character.influences.clear();
    CharacterBindOptions options;
    options.bind.method = SINEW_METHOD_MODEL;
    options.bind.model = &model->model;
    const JointChoice choice = choose_joints(character, JointsFrom::kNames);
    const CharacterBind one = bind_character(character, choice, options),
                        twin = bind_character(inside_out(character), choice, options);
    expect_same_rows(one.influences, twin.influences);
    ++bound;
    with_seams += one.seams.seams.empty() ? 0 : 1;
    if (HasFailure()) return;
  }
  std::printf("%zu characters, %zu of them with seams\n", bound, with_seams);
  EXPECT_GE(with_seams, 5u);
}

}  // namespace
}  // namespace sinew
