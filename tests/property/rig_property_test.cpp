// SPDX-License-Identifier: MIT
// sinew_rig() on random and broken meshes of every kind that strangers may bring: a sound skeleton of at least one joint,
// within the workspace it asked for, that sinew_bind() takes. SINEW_RIG_MESHES=10000 in the environment runs as many.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "draw.hpp"
#include "rig_scene.hpp"
#include "skeleton_of.hpp"
#include "with_asan.hpp"

namespace {

using sinew_test::add_cube;
using sinew_test::Draw;
using sinew_test::MeshScene;
using sinew_test::RiggedScene;

void add_box(MeshScene* scene, float x, float y, float z, float sx, float sy, float sz) {
  const uint32_t first = scene->vertex_count();
  add_cube(scene, 0, 0, 0);
  for (uint32_t v = first; v < scene->vertex_count(); ++v) {
    float* const p = &scene->positions[3 * size_t{v}];
    p[0] = x + sx * (p[0] - 0.5f);
    p[1] = y + sy * (p[1] - 0.5f);
    p[2] = z + sz * (p[2] - 0.5f);
  }
}

// A ring of rings around the y axis: `inner` is the radius of the tube.
void add_torus(MeshScene* scene, float x, float y, float z, float outer, float inner, uint32_t around, uint32_t sides) {
  const uint32_t first = scene->vertex_count();
  for (uint32_t a = 0; a < around; ++a) {
    const float turn = 6.2831853f * static_cast<float>(a) / static_cast<float>(around);
    for (uint32_t s = 0; s < sides; ++s) {
      const float lean = 6.2831853f * static_cast<float>(s) / static_cast<float>(sides);
      const float r = outer + inner * std::cos(lean);
      scene->add_vertex(x + r * std::cos(turn), y + inner * std::sin(lean), z + r * std::sin(turn));
    }
  }
  for (uint32_t a = 0; a < around; ++a) {
    for (uint32_t s = 0; s < sides; ++s) {
      const uint32_t a1 = (a + 1) % around, s1 = (s + 1) % sides;
      scene->add_face({first + a * sides + s, first + a * sides + s1, first + a1 * sides + s1, first + a1 * sides + s});
    }
  }
}

// Limbs of boxes around a trunk, both sides alike: what a model may take for a figure.
void add_figure(MeshScene* scene, Draw& draw) {
  const float height = draw.range(0.3f, 1.5f), width = draw.range(0.1f, 0.6f);
  add_box(scene, 0, height, 0, width, draw.range(0.2f, 1.0f), draw.range(0.1f, 1.5f));
  add_box(scene, 0, height + draw.range(0.2f, 0.8f), draw.range(-0.2f, 0.8f), width, width, width);
  const uint32_t pairs = draw.below(4);
  for (uint32_t pair = 0; pair < pairs; ++pair) {
    const float x = width * draw.range(0.3f, 1.2f), y = height * draw.range(0.2f, 1.2f), z = draw.range(-0.6f, 0.6f);
    const float sx = draw.range(0.05f, 0.6f), sy = draw.range(0.05f, 1.0f), sz = draw.range(0.05f, 0.3f);
    for (const float side : {1.0f, -1.0f}) add_box(scene, side * x, y, z, sx, sy, sz);
  }
}

enum Kind {
  kNoFaces,
  kPlane,
  kCube,
  kTank,
  kTwoVertices,
  kManyParts,
  kFigure,
  kSoup,
  kSticks,
  kTori,
  kDuplicates,
  kWeb,
  kKinds
};

MeshScene base_mesh(uint32_t kind, Draw& draw) {
  MeshScene scene;
  switch (kind) {
    case kNoFaces: {
      const uint32_t count = 1 + draw.below(200);
      for (uint32_t v = 0; v < count; ++v)
        scene.add_vertex(draw.range(-1, 1), draw.range(0, 2), draw.range(-0.5f, 0.5f));
      break;
    }
    case kPlane: {  // level or upright
      const uint32_t n = 1 + draw.below(12);
      const bool upright = draw.chance(50);
      const float depth = draw.range(0.1f, 2);
      for (uint32_t i = 0; i <= n; ++i) {
        for (uint32_t j = 0; j <= n; ++j) {
          const float u = static_cast<float>(i) / static_cast<float>(n), v = depth * static_cast<float>(j);
          scene.add_vertex(u, upright ? v : 0, upright ? 0 : v);
        }
      }
      for (uint32_t i = 0; i < n; ++i) {
        for (uint32_t j = 0; j < n; ++j) {
          const uint32_t a = i * (n + 1) + j;
          scene.add_face({a, a + 1, a + n + 2, a + n + 1});
        }
      }
      break;
    }
    case kCube:
      add_box(&scene, 0, 0, 0, draw.range(0.1f, 1), draw.range(0.1f, 1), draw.range(0.1f, 1));
      break;
    case kTank: {
      add_box(&scene, 0, 0.5f, 0, 1.2f, 0.4f, 2);
      add_box(&scene, 0, 0.9f, draw.range(-0.3f, 0.3f), 0.8f, 0.35f, 0.9f);
      add_box(&scene, 0, 0.95f, 1, 0.1f, 0.1f, draw.range(0.5f, 2));
      for (const float side : {1.0f, -1.0f}) add_box(&scene, side * 0.7f, 0.25f, 0, 0.3f, 0.5f, 2.1f);
      break;
    }
    case kTwoVertices:
      scene.add_vertex(0, 0, 0);
      if (draw.chance(80)) scene.add_vertex(draw.range(0, 1), draw.range(0, 1), 0);
      if (draw.chance(30)) scene.add_face({0, scene.vertex_count() - 1});
      if (draw.chance(30)) scene.add_face({0, 0, scene.vertex_count() - 1});
      break;
    case kManyParts: {
      const uint32_t parts = draw.chance(20) ? 1000 : 20 + draw.below(100);
      for (uint32_t i = 0; i < parts; ++i)
        add_cube(&scene, draw.range(-2, 2), draw.range(0, 4), draw.range(-2, 2), draw.range(0.01f, 0.4f));
      break;
    }
    case kFigure:
      add_figure(&scene, draw);
      break;
    case kSoup: {
      const uint32_t vertices = 3 + draw.below(80), faces = 1 + draw.below(200);
      for (uint32_t v = 0; v < vertices; ++v) scene.add_vertex(draw.range(-1, 1), draw.range(-1, 1), draw.range(-1, 1));
      for (uint32_t f = 0; f < faces; ++f)
        scene.add_face({draw.below(vertices), draw.below(vertices), draw.below(vertices)});
      break;
    }
    case kSticks: {
      const uint32_t sticks = 1 + draw.below(12);
      for (uint32_t i = 0; i < sticks; ++i) {
        float size[3] = {0.002f, 0.002f, 0.002f};
        size[draw.below(3)] = draw.range(0.2f, 2);
        add_box(&scene, draw.range(-0.3f, 0.3f), draw.range(0, 1), draw.range(-0.3f, 0.3f), size[0], size[1], size[2]);
      }
      break;
    }
    case kTori: {
      const uint32_t count = 1 + draw.below(3);
      for (uint32_t i = 0; i < count; ++i)
        add_torus(&scene, 0, draw.range(0, 1), draw.range(-0.5f, 0.5f), draw.range(0.2f, 1), draw.range(0.01f, 0.3f),
                  6 + draw.below(20), 3 + draw.below(8));
      break;
    }
    case kDuplicates: {  // everything two or three times at one position, and faces twice over
      add_figure(&scene, draw);
      const MeshScene once = scene;
      const uint32_t copies = 1 + draw.below(2);
      for (uint32_t copy = 0; copy < copies; ++copy) {
        const uint32_t first = draw.chance(50) ? scene.vertex_count() : 0;
        if (first != 0) scene.positions.insert(scene.positions.end(), once.positions.begin(), once.positions.end());
        for (size_t f = 0; f + 1 < once.offsets.size(); ++f) {
          std::vector<uint32_t> face(once.corners.begin() + once.offsets[f],
                                     once.corners.begin() + once.offsets[f + 1]);
          for (uint32_t& v : face) v += first;
          scene.add_face(face);
        }
      }
      break;
    }
    default: {  // one polygon through everything
      add_figure(&scene, draw);
      std::vector<uint32_t> face;
      for (uint32_t v = 0; v < scene.vertex_count(); ++v) face.push_back(v);
      scene.add_face(face);
      break;
    }
  }
  return scene;
}

MeshScene random_mesh(uint32_t seed) {
  Draw draw(seed);
  MeshScene scene = base_mesh(seed % kKinds, draw);
  if (draw.chance(20)) {  // inside out
    for (size_t f = 0; f + 1 < scene.offsets.size(); ++f)
      std::reverse(scene.corners.begin() + scene.offsets[f], scene.corners.begin() + scene.offsets[f + 1]);
  }
  const bool lying = draw.chance(20), bent = draw.chance(15);
  const float scale = draw.chance(20) ? 1e-6f : draw.chance(20) ? 1e5f : 1.0f, off = draw.chance(15) ? 1e6f : 0.0f;
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    float* const p = &scene.positions[3 * size_t{v}];
    if (lying) std::swap(p[1], p[2]);
    if (bent) p[0] += 0.3f * p[1] * p[2];  // no mirror image of itself
    for (uint32_t axis = 0; axis < 3; ++axis) p[axis] = p[axis] * scale + off;
  }
  return scene;
}

void expect_binds(const MeshScene& scene, const RiggedScene& rigged) {
  const sinew_mesh mesh = scene.mesh_view();
  sinew_skeleton skeleton = sinew_test::skeleton_of(rigged.positions.data(), rigged.parents.data(), rigged.count);
  skeleton.flags = rigged.flags.data();
  sinew::Workspace workspace;
  sinew::Skin<uint16_t> skin;
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.grid_size = 16;
  ASSERT_EQ(sinew::bind(bundled_model(), mesh, skeleton, options, &workspace, &skin), SINEW_OK);
  for (size_t i = 0; i < skin.joint_indices.size(); ++i) {
    if (skin.weights[i] == 0) continue;
    ASSERT_EQ(rigged.flags[skin.joint_indices[i]], 0) << "a bone end got weight";
  }
}

TEST(RigProperty, RandomMeshesGetSoundSkeletons) {
  const char* const said = std::getenv("SINEW_RIG_MESHES");
#ifdef SINEW_WITH_ASAN
  constexpr uint32_t kFew = 3 * kKinds;
#else
  constexpr uint32_t kFew = 8 * kKinds;
#endif
  const uint32_t meshes = said == nullptr ? kFew : static_cast<uint32_t>(std::strtoul(said, nullptr, 10));
  for (uint32_t seed = 0; seed < meshes; ++seed) {
    SCOPED_TRACE(seed);
    const MeshScene scene = random_mesh(seed);
    Draw draw(seed + 1000000);
    sinew_rig_options options = SINEW_INIT(sinew_rig_options);
    options.up = draw.below(2) == 0 ? SINEW_UP_Y : SINEW_UP_Z;
    options.mirror = draw.below(3);
    options.spine_count = draw.chance(50) ? 0 : draw.below(17);
    options.without = draw.below(2) * SINEW_WITHOUT_TOES;
    options.without |= draw.below(2) * SINEW_WITHOUT_ENDS;
    const RiggedScene rigged(scene, options);
    rigged.expect_sound();
    if (HasFailure()) return;
    options.method = SINEW_RIG_SHAPE;
    const RiggedScene shaped(scene, options, nullptr);
    shaped.expect_sound();
    if (HasFailure()) return;
    if (draw.chance(25)) expect_binds(scene, draw.chance(70) ? rigged : shaped);
    if (HasFailure()) return;
  }
}

}  // namespace
