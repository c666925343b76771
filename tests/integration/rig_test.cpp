// SPDX-License-Identifier: MIT
// sinew_rig() with the bundled model: what it promises of any mesh, and what it makes of a figure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "rig_scene.hpp"
#include "sample_mesh.hpp"
#include "sinew/published.h"
#include "skeleton_of.hpp"

namespace {

using sinew_test::add_cube;
using sinew_test::from_file;
using sinew_test::MeshScene;
using sinew_test::RiggedScene;

// The mesh beside its mirror image: symmetric to the last bit.
MeshScene mirrored(const MeshScene& half) {
  MeshScene scene = half;
  const uint32_t count = half.vertex_count();
  for (uint32_t v = 0; v < count; ++v)
    scene.add_vertex(-half.positions[3 * v], half.positions[3 * v + 1], half.positions[3 * v + 2]);
  for (size_t f = 0; f + 1 < half.offsets.size(); ++f) {
    std::vector<uint32_t> face(half.corners.begin() + half.offsets[f], half.corners.begin() + half.offsets[f + 1]);
    for (uint32_t& v : face) v += count;
    std::reverse(face.begin(), face.end());
    scene.add_face(face);
  }
  return scene;
}

TEST(SkeletonOfAMesh, ABipedGetsNamedLimbsOnBothSides) {
  const RiggedScene rigged(from_file("biped__robot.obj"), SINEW_INIT(sinew_rig_options));
  rigged.expect_sound();
  const std::set<std::string> names(rigged.names.begin(), rigged.names.end());
  for (const char* name : {"Hips", "Head", "LeftArm", "RightArm", "LeftForeArm", "RightForeArm", "LeftUpLeg",
                           "RightUpLeg", "LeftLeg", "RightLeg", "LeftFoot", "RightFoot"})
    EXPECT_EQ(names.count(name), 1u) << name;
  // +x is left, as in the files.
  const size_t left =
      static_cast<size_t>(std::find(rigged.names.begin(), rigged.names.end(), "LeftArm") - rigged.names.begin());
  EXPECT_GT(rigged.positions[3 * left], 0);
}

TEST(SkeletonOfAMesh, ASymmetricMeshHasExactlyMirroredJoints) {
  for (const char* name : {"biped__robed.obj", "bird__winged.obj", "quadruped__tailed.obj"}) {
    const RiggedScene rigged(mirrored(from_file(name)), SINEW_INIT(sinew_rig_options));
    rigged.expect_sound();
    ASSERT_EQ(rigged.outputs.mirrored, 1u);
    for (uint32_t j = 0; j < rigged.count; ++j) {
      const float* const p = &rigged.positions[3 * j];
      ASSERT_GE(rigged.partners[j], 0);
      const float* const q = &rigged.positions[3 * static_cast<size_t>(rigged.partners[j])];
      if (rigged.outputs.facing % 2 == 0) {
        EXPECT_EQ(p[0] - rigged.outputs.plane, rigged.outputs.plane - q[0]) << name << " " << rigged.names[j];
        EXPECT_EQ(p[2], q[2]);
      } else {
        EXPECT_EQ(p[2] - rigged.outputs.plane, rigged.outputs.plane - q[2]) << name << " " << rigged.names[j];
        EXPECT_EQ(p[0], q[0]);
      }
      EXPECT_EQ(p[1], q[1]);
    }
  }
}

TEST(SkeletonOfAMesh, TheNumberingOfTheMeshDoesNotMatter) {
  const MeshScene scene = from_file("quadruped__tailed.obj");
  std::mt19937 random(3);
  std::vector<uint32_t> new_index(scene.vertex_count());
  std::iota(new_index.begin(), new_index.end(), 0u);
  std::shuffle(new_index.begin(), new_index.end(), random);
  MeshScene other;
  other.positions.resize(scene.positions.size());
  for (uint32_t v = 0; v < new_index.size(); ++v)
    std::copy_n(&scene.positions[3 * v], 3, &other.positions[3 * new_index[v]]);
  std::vector<size_t> faces(scene.offsets.size() - 1);
  std::iota(faces.begin(), faces.end(), size_t{0});
  std::shuffle(faces.begin(), faces.end(), random);
  for (const size_t f : faces) {
    std::vector<uint32_t> face(scene.corners.begin() + scene.offsets[f], scene.corners.begin() + scene.offsets[f + 1]);
    for (uint32_t& v : face) v = new_index[v];
    if (face.size() == 3) std::rotate(face.begin(), face.begin() + 1, face.end());
    other.add_face(face);
  }
  const RiggedScene a(scene, SINEW_INIT(sinew_rig_options)), b(other, SINEW_INIT(sinew_rig_options));
  a.expect_sound();
  EXPECT_TRUE(a.same_as(b));
}

TEST(SkeletonOfAMesh, InsideOutIsTheSame) {
  const MeshScene scene = from_file("biped__caped.gltf");
  MeshScene turned = scene;
  for (size_t f = 0; f + 1 < scene.offsets.size(); ++f)
    std::reverse(turned.corners.begin() + scene.offsets[f], turned.corners.begin() + scene.offsets[f + 1]);
  EXPECT_TRUE(
      RiggedScene(scene, SINEW_INIT(sinew_rig_options)).same_as(RiggedScene(turned, SINEW_INIT(sinew_rig_options))));
}

TEST(SkeletonOfAMesh, EveryKernelGivesTheSame) {
  const MeshScene scene = from_file("biped__robed.obj");
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.kernel = SINEW_KERNEL_REF;
  const RiggedScene reference(scene, options);
  reference.expect_sound();
  for (uint32_t kernel = 0; sinew_kernel_name(kernel) != nullptr; ++kernel) {
    if (sinew_kernel_select(kernel) == 0) continue;
    for (const uint32_t in_place : {0u, 1u}) {
      options.kernel = kernel;
      options.weights_in_place = in_place;
      EXPECT_TRUE(reference.same_as(RiggedScene(scene, options))) << sinew_kernel_name(kernel) << " " << in_place;
    }
  }
}

// Positions move with the mesh, and axes follow it.
TEST(SkeletonOfAMesh, FarAwayTinyOrZUpIsTheSameSkeleton) {
  const MeshScene scene = from_file("biped__robot.obj");
  const RiggedScene plain(scene, SINEW_INIT(sinew_rig_options));
  const auto changed = [&](float scale, float offset, bool z_up) {
    MeshScene other = scene;
    for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
      const float x = scene.positions[3 * v], y = scene.positions[3 * v + 1], z = scene.positions[3 * v + 2];
      const float turned[3] = {x, z_up ? -z : y, z_up ? y : z};
      for (uint32_t axis = 0; axis < 3; ++axis) other.positions[3 * v + axis] = scale * turned[axis] + offset;
    }
    sinew_rig_options options = SINEW_INIT(sinew_rig_options);
    options.up = z_up ? SINEW_UP_Z : SINEW_UP_Y;
    return RiggedScene(other, options);
  };
  for (const auto& [scale, offset, z_up] :
       {std::tuple{0.0078125f, 0.0f, false}, {128.0f, 0.0f, false}, {1.0f, 0.0f, true}}) {
    const RiggedScene other = changed(scale, offset, z_up);
    ASSERT_EQ(other.count, plain.count) << scale << " " << z_up;
    EXPECT_EQ(other.parents, plain.parents);
    EXPECT_EQ(other.names, plain.names);
    for (uint32_t j = 0; j < plain.count; ++j) {
      const float x = plain.positions[3 * j], y = plain.positions[3 * j + 1], z = plain.positions[3 * j + 2];
      const float want[3] = {x, z_up ? -z : y, z_up ? y : z};
      for (uint32_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(other.positions[3 * j + axis], scale * want[axis], 1e-5f * scale) << plain.names[j];
    }
  }
  changed(1e-3f, 1e3f, false).expect_sound();
}

// Left stays left, whichever way the figure looks.
TEST(SkeletonOfAMesh, ItIsFoundWhicheverWayItFaces) {
  const MeshScene scene = from_file("quadruped__tailed.obj");
  const RiggedScene plain(scene, SINEW_INIT(sinew_rig_options));
  for (uint32_t quarters = 0; quarters < 4; ++quarters) {
    MeshScene other = scene;  // facing +z, +x, -z, -x
    for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
      const float x = scene.positions[3 * v], z = scene.positions[3 * v + 2];
      const float positions[4][2] = {{x, z}, {z, -x}, {-x, -z}, {-z, x}};
      other.positions[3 * v] = positions[quarters][0];
      other.positions[3 * v + 2] = positions[quarters][1];
    }
    const RiggedScene rigged(other, SINEW_INIT(sinew_rig_options));
    rigged.expect_sound();
    EXPECT_EQ(rigged.outputs.facing, quarters);
    // Points lie elsewhere on the turned mesh, so a joint may come or go, and those behind it have other numbers; where one
    // was there is one of its class.
    size_t shared = 0;
    for (uint32_t j = 0; j < plain.count; ++j) {
      const float x = plain.positions[3 * j], z = plain.positions[3 * j + 2];
      const float positions[4][2] = {{x, z}, {z, -x}, {-x, -z}, {-z, x}};
      bool found = false;
      for (uint32_t k = 0; k < rigged.count; ++k) {
        found = found || (rigged.classes[k] == plain.classes[j] && rigged.flags[k] == plain.flags[j] &&
                          std::hypot(rigged.positions[3 * k] - positions[quarters][0],
                                     rigged.positions[3 * k + 1] - plain.positions[3 * j + 1],
                                     rigged.positions[3 * k + 2] - positions[quarters][1]) < 0.1f);
      }
      shared += found ? 1 : 0;
    }
    EXPECT_GE(shared, plain.count * 3 / 4) << quarters;
  }
}

TEST(SkeletonOfAMesh, OptionsAreKept) {
  const MeshScene scene = from_file("biped__robot.obj");
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.without = SINEW_WITHOUT_ENDS | SINEW_WITHOUT_TOES;
  options.spine_count = 5;
  const RiggedScene rigged(scene, options);
  rigged.expect_sound();
  size_t spine = 0;
  for (uint32_t j = 0; j < rigged.count; ++j) {
    EXPECT_EQ(rigged.flags[j], 0);
    EXPECT_NE(rigged.classes[j], SINEW_CLASS_TOE);
    spine += rigged.classes[j] == SINEW_CLASS_SPINE ? 1 : 0;
  }
  EXPECT_EQ(spine, 5u);
  options = SINEW_INIT(sinew_rig_options);
  options.mirror = SINEW_MIRROR_NEVER;
  const RiggedScene apart(scene, options);
  apart.expect_sound();
  EXPECT_EQ(apart.outputs.mirrored, 0u);
  EXPECT_TRUE(
      std::all_of(apart.partners.begin(), apart.partners.begin() + apart.count, [](int32_t p) { return p == -1; }));
}

// What it gives is what sinew_bind() takes.
TEST(SkeletonOfAMesh, TheSkeletonCanBeBoundAtOnce) {
  const MeshScene scene = from_file("quadruped__tailed.obj");
  const RiggedScene rigged(scene, SINEW_INIT(sinew_rig_options));
  rigged.expect_sound();
  const sinew_mesh mesh = scene.mesh_view();
  sinew_skeleton skeleton = sinew_test::skeleton_of(rigged.positions.data(), rigged.parents.data(), rigged.count);
  skeleton.flags = rigged.flags.data();
  size_t bytes = 0;
  ASSERT_EQ(sinew_bind_workspace_size(bundled_model(), mesh.vertex_count, mesh.face_count, mesh.corner_count,
                                      skeleton.joint_count, nullptr, &bytes),
            SINEW_OK);
  const sinew::Workspace block(bytes);
  std::vector<uint16_t> joints(4 * mesh.vertex_count), weights(joints);
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints.data();
  outputs.weights = weights.data();
  ASSERT_EQ(sinew_bind(bundled_model(), &mesh, &skeleton, nullptr, block.data(), bytes, &outputs), SINEW_OK);
  for (size_t i = 0; i < joints.size(); ++i) {
    if (weights[i] > 0) {
      EXPECT_EQ(rigged.flags[joints[i]], 0) << "a bone end got weight";
    }
  }
}

// A post six cubes high with arms of three cubes at its fifth.
MeshScene post_with_arms() {
  MeshScene scene;
  for (int y = 0; y < 6; ++y) add_cube(&scene, -0.5f, static_cast<float>(y), -0.5f);
  for (int x = 1; x < 4; ++x) {
    add_cube(&scene, static_cast<float>(x) - 0.5f, 4, -0.5f);
    add_cube(&scene, -static_cast<float>(x) - 0.5f, 4, -0.5f);
  }
  return scene;
}

// Without a model: the middle line of every limb, with an end in it.
TEST(SkeletonOfAMesh, TheShapeAloneGivesALineThroughEveryLimb) {
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.method = SINEW_RIG_SHAPE;
  const RiggedScene rigged(post_with_arms(), options, nullptr);
  rigged.expect_sound();
  EXPECT_EQ(rigged.outputs.mirrored, 1u);
  EXPECT_EQ(rigged.outputs.spread, 0);
  const auto at = [&](uint32_t j, size_t axis) { return rigged.positions[3 * size_t{j} + axis]; };
  uint32_t ends = 0, arms = 0, top = 0, bottom = 0;
  for (uint32_t j = 0; j < rigged.count; ++j) {
    EXPECT_EQ(rigged.classes[j], SINEW_CLASS_OTHER);
    EXPECT_EQ(rigged.names[j].substr(0, rigged.names[j].find_first_of("0123456789_")).find("Bone") == std::string::npos,
              false)
        << rigged.names[j];
    // Within the post or an arm.
    const bool in_post = std::fabs(at(j, 0)) <= 0.5f && at(j, 1) >= 0 && at(j, 1) <= 6;
    const bool in_arm = std::fabs(at(j, 0)) <= 3.5f && at(j, 1) >= 4 && at(j, 1) <= 5;
    EXPECT_TRUE(in_post || in_arm) << at(j, 0) << " " << at(j, 1);
    EXPECT_NEAR(at(j, 2), 0, 0.1);
    const uint32_t image = static_cast<uint32_t>(rigged.partners[j]);
    EXPECT_EQ(at(image, 0), -at(j, 0));
    EXPECT_EQ(at(image, 1), at(j, 1));
    if (rigged.flags[j] == 0) continue;
    ++ends;
    arms += std::fabs(at(j, 0)) > 2.9f ? 1 : 0;
    top += at(j, 1) > 5.4f ? 1 : 0;
    bottom += at(j, 1) < 0.6f ? 1 : 0;
  }
  EXPECT_EQ(ends, 4u);
  EXPECT_EQ(arms, 2u);
  EXPECT_EQ(top, 1u);
  EXPECT_EQ(bottom, 1u);
}

// As published: nodes of boxes around pieces, joined where the pieces touch. Every piece of the post has some.
TEST(SkeletonOfAMesh, RegionsOfTheSurfaceGiveATreeThroughEveryPart) {
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.method = SINEW_RIG_REGIONS;
  const RiggedScene rigged(post_with_arms(), options, nullptr);
  rigged.expect_sound();
  EXPECT_EQ(rigged.outputs.mirrored, 0u);
  EXPECT_GE(rigged.count, 5u);
  EXPECT_LE(rigged.count, 48u);
  float most[3] = {-9, -9, -9}, least[3] = {9, 9, 9};
  for (uint32_t j = 0; j < rigged.count; ++j) {
    EXPECT_EQ(rigged.classes[j], SINEW_CLASS_OTHER);
    for (size_t axis = 0; axis < 3; ++axis) {
      most[axis] = std::max(most[axis], rigged.positions[3 * size_t{j} + axis]);
      least[axis] = std::min(least[axis], rigged.positions[3 * size_t{j} + axis]);
    }
  }
  EXPECT_GT(most[0], 2);
  EXPECT_LT(least[0], -2);
  EXPECT_GT(most[1], 4.5f);
  EXPECT_LT(least[1], 1.5f);
  EXPECT_LE(most[0], 3.5f);
  EXPECT_GE(least[1], 0);
}

// Votes of a sheet are sure of themselves for no reason.
TEST(SkeletonOfAMesh, ASheetIsSaidToBeUnknown) {
  MeshScene sheet;
  for (int i = 0; i < 100; ++i) sheet.add_vertex(static_cast<float>(i % 10), static_cast<float>(i / 10), 0);
  for (uint32_t y = 0; y < 9; ++y)
    for (uint32_t x = 0; x < 9; ++x) sheet.add_face({10 * y + x, 10 * y + x + 1, 10 * y + x + 11, 10 * y + x + 10});
  EXPECT_GE(RiggedScene(sheet, SINEW_INIT(sinew_rig_options)).outputs.spread, 0.1f);
  EXPECT_LT(RiggedScene(from_file("biped__robot.obj"), SINEW_INIT(sinew_rig_options)).outputs.spread, 0.1f);
}

TEST(SkeletonOfAMesh, RubbishGetsAtLeastOneJoint) {
  std::vector<MeshScene> scenes;
  scenes.emplace_back();  // a point
  scenes.back().add_vertex(1, 2, 3);
  scenes.emplace_back();  // two, without faces
  scenes.back().add_vertex(0, 0, 0);
  scenes.back().add_vertex(0, 1, 0);
  scenes.emplace_back();  // a plane
  for (const auto& [x, z] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}})
    scenes.back().add_vertex(x, 0, z);
  scenes.back().add_face({0, 1, 2, 3});
  scenes.emplace_back();
  add_cube(&scenes.back(), 0, 0, 0);
  scenes.emplace_back();  // a thousand parts
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto draw = [&] { return static_cast<float>(random() % 1000) / 100.0f; };
    add_cube(&scenes.back(), draw(), draw(), draw(), 0.2f);
  }
  scenes.emplace_back();  // far away, where floats are coarse
  add_cube(&scenes.back(), 1e6f, 1e6f, 1e6f);
  scenes.emplace_back();  // as large as floats are
  for (const float x : {-3e38f, 3e38f})
    for (const float y : {-3e38f, 3e38f}) scenes.back().add_vertex(x, y, x + y > 0 ? 1e38f : 0.0f);
  scenes.back().add_face({0, 1, 2});
  scenes.back().add_face({1, 2, 3});
  constexpr float kMost = std::numeric_limits<float>::max();
  for (const float x : {-kMost, kMost}) {  // one corner as far away as a float can be
    scenes.emplace_back();
    add_cube(&scenes.back(), 0, 0, 0);
    for (int axis = 0; axis < 3; ++axis) scenes.back().positions[static_cast<size_t>(axis)] = x;
  }
  scenes.emplace_back();
  add_cube(&scenes.back(), 0, 0, 0);
  for (float& x : scenes.back().positions) x = x > 0.5f ? kMost : -kMost;
  for (size_t i = 0; i < scenes.size(); ++i) {
    SCOPED_TRACE(i);
    for (const uint32_t mirror : {SINEW_MIRROR_AUTO, SINEW_MIRROR_ALWAYS, SINEW_MIRROR_NEVER}) {
      sinew_rig_options options = SINEW_INIT(sinew_rig_options);
      options.mirror = mirror;
      RiggedScene(scenes[i], options).expect_sound();
      for (const uint32_t method : {uint32_t{SINEW_RIG_SHAPE}, uint32_t{SINEW_RIG_REGIONS}}) {
        options.method = method;
        RiggedScene(scenes[i], options, nullptr).expect_sound();
      }
    }
  }
}

TEST(SkeletonOfAMesh, RandomMeshesAreSound) {
  for (uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](uint32_t n) { return static_cast<uint32_t>(random() % n); };
    MeshScene scene;
    const uint32_t vertices = 1 + below(60), faces = below(120);
    const float flat = below(4) == 0 ? 0.0f : 1.0f;
    for (uint32_t v = 0; v < vertices; ++v)
      scene.add_vertex(static_cast<float>(below(64)) / 8, static_cast<float>(below(64)) / 8,
                       flat * static_cast<float>(below(64)) / 8);
    for (uint32_t f = 0; f < faces; ++f) scene.add_face({below(vertices), below(vertices), below(vertices)});
    sinew_rig_options options = SINEW_INIT(sinew_rig_options);
    options.mirror = below(3);
    options.up = below(2) == 0 ? SINEW_UP_Y : SINEW_UP_Z;
    options.spine_count = below(5);
    options.without = below(2) * SINEW_WITHOUT_TOES;
    options.without |= below(2) * SINEW_WITHOUT_ENDS;
    RiggedScene(scene, options).expect_sound();
    for (const uint32_t method : {uint32_t{SINEW_RIG_SHAPE}, uint32_t{SINEW_RIG_REGIONS}}) {
      options.method = method;
      RiggedScene(scene, options, nullptr).expect_sound();
    }
  }
}

TEST(SkeletonOfAMesh, WrongCallsAreRefused) {
  MeshScene scene;
  add_cube(&scene, 0, 0, 0);
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  EXPECT_EQ(RiggedScene(scene, options, nullptr).status, SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(RiggedScene(scene, options, bundled_model()).status, SINEW_ERROR_MODEL_TASK);
  EXPECT_EQ(RiggedScene(scene, options, bundled_rig_model(), 64).status, SINEW_ERROR_WORKSPACE);
  options.mirror = 3;
  EXPECT_EQ(RiggedScene(scene, options).status, SINEW_ERROR_ARGUMENT);
  options = SINEW_INIT(sinew_rig_options);
  options.spine_count = 17;
  EXPECT_EQ(RiggedScene(scene, options).status, SINEW_ERROR_ARGUMENT);
  options = SINEW_INIT(sinew_rig_options);
  options.method = SINEW_RIG_SLOTS + 1;
  EXPECT_EQ(RiggedScene(scene, options).status, SINEW_ERROR_ARGUMENT);
  options.method = SINEW_RIG_SLOTS;  // with the votes' model
  EXPECT_EQ(RiggedScene(scene, options).status, SINEW_ERROR_MODEL_TASK);
  options = SINEW_INIT(sinew_rig_options);
  options.struct_size = 0;
  EXPECT_EQ(RiggedScene(scene, options).status, SINEW_ERROR_ARGUMENT);
  options = SINEW_INIT(sinew_rig_options);
  scene.positions[4] = std::numeric_limits<float>::quiet_NaN();
  const RiggedScene nan(scene, options);
  EXPECT_EQ(nan.status, SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(nan.parents[0], 77) << "outputs are untouched";
  scene.positions[4] = 0;
  scene.corners[2] = 1000;
  EXPECT_EQ(RiggedScene(scene, options).status, SINEW_ERROR_INDEX);
  size_t bytes = 0;
  EXPECT_EQ(sinew_rig_workspace_size(bundled_rig_model(), 0, 0, 0, nullptr, &bytes), SINEW_ERROR_COUNT);
  sinew_model model;
  EXPECT_EQ(sinew_rig_model_open(bundled_model()->bytes, bundled_model()->size_bytes, &model), SINEW_ERROR_MODEL_TASK);
  EXPECT_NE(sinew_model_open(bundled_rig_model()->bytes, bundled_rig_model()->size_bytes, &model), SINEW_OK);
}

TEST(SkeletonOfAMesh, CancelStops) {
  MeshScene scene = from_file("biped__robot.obj");
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  struct Count {
    uint32_t calls = 0, stop_at = 0, last = 0;
  } count;
  options.progress_user = &count;
  options.progress = [](void* user, uint32_t permille) {
    Count& c = *static_cast<Count*>(user);
    EXPECT_GE(permille, c.last);
    c.last = permille;
    return ++c.calls == c.stop_at ? 1 : 0;
  };
  RiggedScene(scene, options).expect_sound();
  const uint32_t calls = count.calls;
  EXPECT_GE(calls, 5u);
  for (uint32_t stop = 1; stop <= calls; stop += 3) {
    count = {0, stop, 0};
    const RiggedScene stopped(scene, options);
    EXPECT_EQ(stopped.status, SINEW_ERROR_CANCELLED) << stop;
    EXPECT_EQ(stopped.parents[0], 77);
  }
}

}  // namespace
