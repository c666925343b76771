// SPDX-License-Identifier: MIT
// sinew_bind() on thousands of random and broken meshes and skeletons: never a crash, never an empty row, exact sums,
// the workspace it asked for, the same bytes again, and no dependence on numbering, position or size.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <numeric>
#include <random>
#include <vector>

#include "open_bundled_model.hpp"
#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"
#include "with_asan.hpp"

namespace {

struct Scene {
  std::vector<float> positions, joints;
  std::vector<uint32_t> offsets = {0}, corners;
  std::vector<int32_t> parents;
  uint32_t up = SINEW_UP_AUTO;
};

struct Rows {
  sinew_status status = SINEW_OK;
  std::vector<uint16_t> joints, weights;
  size_t asked = 0, used = 0;
};

class Block {
 public:
  explicit Block(size_t bytes) : data_(::operator new (bytes + 1, std::align_val_t{64})) {}
  ~Block() { ::operator delete (data_, std::align_val_t{64}); }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  void* data() const { return data_; }

 private:
  void* data_;
};

// Views of the scene, which must outlive them.
sinew_mesh mesh_of(const Scene& scene) {
  return {scene.positions.data(),
          static_cast<uint32_t>(scene.positions.size() / 3),
          scene.offsets.data(),
          scene.corners.data(),
          static_cast<uint32_t>(scene.offsets.size() - 1),
          static_cast<uint32_t>(scene.corners.size())};
}
sinew_skeleton skeleton_of(const Scene& scene) {
  sinew_skeleton skeleton = sinew_test::skeleton_of(scene.joints, scene.parents);
  skeleton.up = scene.up;
  return skeleton;
}

Rows bind(const Scene& scene, const sinew_model* model, sinew::Options options) {
  const sinew_mesh mesh = mesh_of(scene);
  const sinew_skeleton skeleton = skeleton_of(scene);
  options.method = model != nullptr ? SINEW_METHOD_MODEL : SINEW_METHOD_HEAT;
  Rows rows;
  rows.status = sinew_bind_workspace_size(model, mesh.vertex_count, mesh.face_count, mesh.corner_count,
                                          skeleton.joint_count, &options, &rows.asked);
  if (rows.status != SINEW_OK) return rows;
  const Block block(rows.asked);
  static_cast<uint8_t*>(block.data())[rows.asked] = 0xA5;
  const size_t n = options.influence_count != 0 ? options.influence_count : 4;
  rows.joints.resize(mesh.vertex_count * n);
  rows.weights.resize(mesh.vertex_count * n);
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = rows.joints.data();
  outputs.weights = rows.weights.data();
  rows.status = sinew_bind(model, &mesh, &skeleton, &options, block.data(), rows.asked, &outputs);
  rows.used = outputs.used_bytes;
  EXPECT_EQ(static_cast<uint8_t*>(block.data())[rows.asked], 0xA5) << "wrote behind the workspace";
  return rows;
}

testing::AssertionResult rows_are_sound(const Rows& rows, size_t n, size_t joint_count) {
  for (size_t first = 0; first < rows.joints.size(); first += n) {
    uint32_t sum = 0;
    for (size_t i = first; i < first + n; ++i) {
      sum += rows.weights[i];
      if (rows.weights[i] == 0) {
        if (rows.joints[i] != 0) return testing::AssertionFailure() << "unused slot names a joint at row " << first / n;
        continue;
      }
      if (rows.joints[i] >= joint_count)
        return testing::AssertionFailure() << "joint out of range at row " << first / n;
      for (size_t j = first; j < i; ++j) {
        if (rows.joints[j] == rows.joints[i]) return testing::AssertionFailure() << "joint twice in row " << first / n;
      }
      if (i > first && (rows.weights[i] > rows.weights[i - 1] ||
                        (rows.weights[i] == rows.weights[i - 1] && rows.joints[i] < rows.joints[i - 1]))) {
        return testing::AssertionFailure() << "row " << first / n << " is not sorted";
      }
    }
    if (sum != 65535) return testing::AssertionFailure() << "row " << first / n << " sums to " << sum;
  }
  return testing::AssertionSuccess();
}

using Random = std::mt19937_64;
uint32_t below(Random& random, uint32_t n) { return static_cast<uint32_t>(random() % n); }
float uniform(Random& random) { return static_cast<float>(static_cast<double>(random() >> 11) * 0x1p-53); }

void add_face(Scene* scene, std::initializer_list<uint32_t> face) {
  scene->corners.insert(scene->corners.end(), face);
  scene->offsets.push_back(static_cast<uint32_t>(scene->corners.size()));
}

// A closed or open grid tube around the y axis: an island.
void add_tube(Scene* scene, Random& random, uint32_t rings, uint32_t sides) {
  const uint32_t first = static_cast<uint32_t>(scene->positions.size() / 3);
  const float cx = uniform(random), cz = uniform(random), radius = 0.02f + 0.2f * uniform(random), y0 = uniform(random);
  for (uint32_t r = 0; r < rings; ++r) {
    for (uint32_t s = 0; s < sides; ++s) {
      const float a = 6.2831853f * static_cast<float>(s) / static_cast<float>(sides);
      scene->positions.insert(scene->positions.end(), {cx + radius * std::cos(a), y0 + static_cast<float>(r) * 0.1f,
                                                       cz + radius * std::sin(a)});
    }
  }
  for (uint32_t r = 0; r + 1 < rings; ++r) {
    for (uint32_t s = 0; s < sides; ++s) {
      const uint32_t a = first + r * sides + s, b = first + r * sides + (s + 1) % sides;
      add_face(scene, {a, a + sides, b + sides, b});
    }
  }
}

Scene random_scene(Random& random) {
  Scene scene;
  const uint32_t kind = below(random, 8);
  const uint32_t islands = 1 + below(random, 4);
  for (uint32_t i = 0; i < islands; ++i) add_tube(&scene, random, 2 + below(random, 4), 3 + below(random, 4));
  if (kind == 1) {  // triangle soup, non-manifold
    const uint32_t n = static_cast<uint32_t>(scene.positions.size() / 3);
    for (int i = 0; i < 40; ++i) add_face(&scene, {below(random, n), below(random, n), below(random, n)});
  } else if (kind == 2) {  // zero area, repeated vertices, two-corner faces
    add_face(&scene, {0, 0, 1});
    add_face(&scene, {0, 1});
    add_face(&scene, {1, 1, 1, 1});
    for (int i = 0; i < 9; ++i)
      scene.positions[static_cast<size_t>(3 + i)] = scene.positions[static_cast<size_t>(i % 3)];
  } else if (kind == 3) {  // isolated vertices
    for (int i = 0; i < 20; ++i) {
      scene.positions.insert(scene.positions.end(), {uniform(random) * 3, uniform(random) * 3, uniform(random) * 3});
    }
  } else if (kind == 4) {  // no faces at all
    scene.offsets = {0};
    scene.corners.clear();
  } else if (kind == 5) {  // all in one point, or in a plane
    const bool point = below(random, 2) != 0;
    for (size_t i = 0; i < scene.positions.size(); ++i) {
      if (point || i % 3 == 1) scene.positions[i] = 0.25f;
    }
  } else if (kind == 6) {  // huge polygon
    scene.corners.clear();
    scene.offsets = {0};
    for (uint32_t v = 0; v < scene.positions.size() / 3; ++v) scene.corners.push_back(v);
    scene.offsets.push_back(static_cast<uint32_t>(scene.corners.size()));
  }
  const uint32_t joint_choice = below(random, 10);
  const uint32_t joint_count = joint_choice == 0 ? 1 : joint_choice == 1 ? 300 : 2 + below(random, 20);
  for (uint32_t j = 0; j < joint_count; ++j) {
    const float reach = below(random, 10) == 0 ? 1000.0f : 1.2f;  // some joints far outside
    scene.joints.insert(scene.joints.end(),
                        {uniform(random) * reach, uniform(random) * reach, uniform(random) * reach});
    scene.parents.push_back(j == 0 || below(random, 12) == 0 ? -1 : static_cast<int32_t>(below(random, j)));
    if (j > 0 && below(random, 15) == 0) {  // coincident with another joint
      for (size_t i = 0; i < 3; ++i) scene.joints[j * 3 + i] = scene.joints[i];
    }
  }
  const float scale = below(random, 4) == 0 ? 1e-6f : below(random, 4) == 0 ? 1e5f : 1.0f;
  const float offset = below(random, 5) == 0 ? 1e6f : 0.0f;
  for (float& x : scene.positions) x = x * scale + offset;
  for (float& x : scene.joints) x = x * scale + offset;
  return scene;
}

TEST(BindProperty, TenThousandRandomScenes) {
  // Sanitizers are ten times slower; they see the first tenth.
#ifdef SINEW_WITH_ASAN
  const int scenes = 1000;
#else
  const int scenes = 10000;
#endif
  const sinew_model* model = bundled_model();
  for (int i = 0; i < scenes; ++i) {
    Random random(static_cast<uint64_t>(i));
    Scene scene = random_scene(random);
    sinew_bind_options options = SINEW_INIT(sinew_bind_options);
    options.influence_count = 1 + below(random, SINEW_MAX_INFLUENCES);
    options.grid_size = 16;
    options.candidate_count = below(random, SINEW_MAX_CANDIDATES + 1);
    scene.up = below(random, 4) == 0 ? 0 : SINEW_UP_Y + below(random, 2);
    options.surface_vertices = below(random, 3) == 0 ? 16 + below(random, 20) : 0;  // a reduced surface now and then
    const Rows rows = bind(scene, i % 2 != 0 ? model : nullptr, options);
    ASSERT_EQ(rows.status, SINEW_OK) << "scene " << i << ": " << sinew_status_text(rows.status);
    ASSERT_TRUE(rows_are_sound(rows, options.influence_count, scene.parents.size())) << "scene " << i;
    ASSERT_LE(rows.used, rows.asked) << "scene " << i;
  }
}

// Faces in another order, vertices in another order: the same row for the same vertex.
TEST(BindProperty, RenumberingChangesNothing) {
  for (int i = 0; i < 60; ++i) {
    Random random(static_cast<uint64_t>(i) + 500);
    const Scene scene = random_scene(random);
    const size_t n = scene.positions.size() / 3;
    std::vector<uint32_t> order(n);  // new vertex -> old vertex
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<uint32_t> where(n);
    Scene other = scene;
    for (uint32_t v = 0; v < n; ++v) {
      where[order[v]] = v;
      std::memcpy(&other.positions[v * 3], &scene.positions[order[v] * 3], 3 * sizeof(float));
    }
    other.offsets = {0};
    other.corners.clear();
    for (size_t f = scene.offsets.size() - 1; f-- > 0;) {  // faces backwards
      for (uint32_t c = scene.offsets[f]; c < scene.offsets[f + 1]; ++c)
        other.corners.push_back(where[scene.corners[c]]);
      other.offsets.push_back(static_cast<uint32_t>(other.corners.size()));
    }
    // Polygons are fans from their first corner, which stays first here.
    sinew_bind_options options = SINEW_INIT(sinew_bind_options);
    options.grid_size = 32;
    options.surface_vertices = i % 2 != 0 ? 16 : 0;
    for (const sinew_model* model : {static_cast<const sinew_model*>(nullptr), bundled_model()}) {
      const Rows a = bind(scene, model, options), b = bind(other, model, options);
      ASSERT_EQ(a.status, SINEW_OK);
      ASSERT_EQ(b.status, SINEW_OK);
      for (uint32_t v = 0; v < n; ++v) {
        for (size_t s = 0; s < 4; ++s) {
          ASSERT_EQ(a.joints[order[v] * 4 + s], b.joints[v * 4 + s]) << "scene " << i << " vertex " << v;
          ASSERT_EQ(a.weights[order[v] * 4 + s], b.weights[v * 4 + s]) << "scene " << i << " vertex " << v;
        }
      }
    }
  }
}

// Every face with its corners in reverse order, as engines with clockwise fronts and mirrored objects have them.
TEST(BindProperty, InsideOutIsTheSame) {
  for (int i = 0; i < 100; ++i) {
    Random random(static_cast<uint64_t>(i) + 900);
    const Scene scene = random_scene(random);
    Scene other = scene;
    for (size_t f = 0; f + 1 < scene.offsets.size(); ++f) {
      std::reverse(other.corners.begin() + static_cast<std::ptrdiff_t>(scene.offsets[f]),
                   other.corners.begin() + static_cast<std::ptrdiff_t>(scene.offsets[f + 1]));
    }
    sinew_bind_options options = SINEW_INIT(sinew_bind_options);
    options.grid_size = 32;
    options.surface_vertices = i % 2 != 0 ? 16 : 0;
    options.symmetric = i % 3 == 0 ? 1 : 0;
    for (const sinew_model* model : {static_cast<const sinew_model*>(nullptr), bundled_model()}) {
      const Rows a = bind(scene, model, options), b = bind(other, model, options);
      ASSERT_EQ(a.status, SINEW_OK);
      ASSERT_EQ(a.joints, b.joints) << "scene " << i;
      ASSERT_EQ(a.weights, b.weights) << "scene " << i;
    }
  }
}

// Powers of two and exact offsets lose no bit, so the result must not change at all.
TEST(BindProperty, MovedAndScaledIsTheSame) {
  Random random(77);
  Scene scene;
  for (int i = 0; i < 3; ++i) add_tube(&scene, random, 6, 8);
  for (float& x : scene.positions) x = std::round(x * 4096.0f) / 4096.0f;
  for (uint32_t j = 0; j < 9; ++j) {
    for (int i = 0; i < 3; ++i) scene.joints.push_back(std::round(uniform(random) * 4096.0f) / 4096.0f);
    scene.parents.push_back(static_cast<int32_t>(j) - 1);
  }
  Scene other = scene;
  for (float& x : other.positions) x = x * 8.0f + 64.0f;
  for (float& x : other.joints) x = x * 8.0f + 64.0f;
  for (const sinew_model* model : {static_cast<const sinew_model*>(nullptr), bundled_model()}) {
    const Rows a = bind(scene, model, {}), b = bind(other, model, {});
    ASSERT_EQ(a.status, SINEW_OK);
    EXPECT_EQ(a.joints, b.joints);
    EXPECT_EQ(a.weights, b.weights);
  }
}

TEST(BindProperty, RefusesBadInputAndLeavesOutputsAlone) {
  Random random(3);
  const Scene good = random_scene(random);
  struct Case {
    const char* what;
    Scene scene;
    sinew_status expected;
  };
  std::vector<Case> cases;
  auto add = [&](const char* what, sinew_status expected) -> Scene& {
    cases.push_back({what, good, expected});
    return cases.back().scene;
  };
  add("NaN vertex", SINEW_ERROR_NOT_FINITE).positions[4] = std::numeric_limits<float>::quiet_NaN();
  add("infinite joint", SINEW_ERROR_NOT_FINITE).joints[1] = std::numeric_limits<float>::infinity();
  add("vertex index", SINEW_ERROR_INDEX).corners[0] = static_cast<uint32_t>(good.positions.size());
  add("parent index", SINEW_ERROR_INDEX).parents[0] = static_cast<int32_t>(good.parents.size());
  add("own parent", SINEW_ERROR_HIERARCHY).parents[0] = 0;
  for (const Case& c : cases) {
    const Rows rows = bind(c.scene, nullptr, {});
    EXPECT_EQ(rows.status, c.expected) << c.what;
    EXPECT_TRUE(std::all_of(rows.weights.begin(), rows.weights.end(), [](uint16_t w) { return w == 0; })) << c.what;
  }
}

TEST(BindProperty, LockedRowsAndExcludedJoints) {
  Random random(11);
  Scene scene;
  add_tube(&scene, random, 8, 8);
  const uint32_t n = static_cast<uint32_t>(scene.positions.size() / 3);
  for (int j = 0; j < 4; ++j) {
    scene.joints.insert(scene.joints.end(),
                        {scene.positions[0], scene.positions[1] + 0.2f * static_cast<float>(j), scene.positions[2]});
    scene.parents.push_back(j - 1);
  }
  const sinew_mesh mesh = {scene.positions.data(),
                           n,
                           scene.offsets.data(),
                           scene.corners.data(),
                           static_cast<uint32_t>(scene.offsets.size() - 1),
                           static_cast<uint32_t>(scene.corners.size())};
  std::vector<uint8_t> flags = {0, SINEW_JOINT_NEVER, 0, 0}, locked(n, 0);
  sinew_skeleton skeleton = sinew_test::skeleton_of(scene.joints.data(), scene.parents.data(), 4);
  skeleton.flags = flags.data();
  locked[5] = 1;
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.method = SINEW_METHOD_HEAT;
  options.locked = locked.data();
  size_t bytes = 0;
  ASSERT_EQ(sinew_bind_workspace_size(nullptr, n, mesh.face_count, mesh.corner_count, 4, &options, &bytes), SINEW_OK);
  const Block block(bytes);
  std::vector<uint16_t> joints(n * 4, 0), weights(n * 4, 0);
  joints[20] = 1;
  weights[20] = 65535;
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints.data();
  outputs.weights = weights.data();
  ASSERT_EQ(sinew_bind(nullptr, &mesh, &skeleton, &options, block.data(), bytes, &outputs), SINEW_OK);
  EXPECT_EQ(joints[20], 1);
  EXPECT_EQ(weights[20], 65535);
  for (size_t i = 0; i < joints.size(); ++i) {
    if (i / 4 != 5 && weights[i] > 0) {
      EXPECT_NE(joints[i], 1) << "an excluded joint got weight";
    }
  }
  joints[20] = 9;
  EXPECT_EQ(sinew_bind(nullptr, &mesh, &skeleton, &options, block.data(), bytes, &outputs), SINEW_ERROR_RANGE);
  flags = {0, 0, SINEW_JOINT_DEFORMS, 0};
  joints[20] = 0;
  ASSERT_EQ(sinew_bind(nullptr, &mesh, &skeleton, &options, block.data(), bytes, &outputs), SINEW_OK);
  for (size_t i = 0; i < joints.size(); ++i) {
    if (i / 4 != 5 && weights[i] > 0) {
      EXPECT_EQ(joints[i], 2) << "only one joint deforms";
    }
  }
}

TEST(BindProperty, CancelStopsAtEveryCallAndProgressRises) {
  Random random(21);
  const Scene scene = random_scene(random);
  struct Watch {
    int calls = 0, stop_at = -1;
    uint32_t last = 0;
    bool fell = false;
  };
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.progress = [](void* user, uint32_t done) {
    Watch& w = *static_cast<Watch*>(user);
    w.fell = w.fell || done < w.last || done > 1000;
    w.last = done;
    return w.calls++ == w.stop_at ? 1 : 0;
  };
  for (const sinew_model* model : {static_cast<const sinew_model*>(nullptr), bundled_model()}) {
    Watch all;
    options.progress_user = &all;
    ASSERT_EQ(bind(scene, model, options).status, SINEW_OK);
    EXPECT_FALSE(all.fell);
    EXPECT_EQ(all.last, 1000u);
    ASSERT_GE(all.calls, 3);
    for (int stop = 0; stop < all.calls; ++stop) {
      Watch watch;
      watch.stop_at = stop;
      options.progress_user = &watch;
      const Rows rows = bind(scene, model, options);
      EXPECT_EQ(rows.status, SINEW_ERROR_CANCELLED);
      EXPECT_TRUE(std::all_of(rows.weights.begin(), rows.weights.end(), [](uint16_t w) { return w == 0; }));
    }
  }
}

TEST(BindProperty, WeightFormatsAgree) {
  Random random(31);
  const Scene scene = random_scene(random);
  const sinew_mesh mesh = mesh_of(scene);
  const sinew_skeleton skeleton = skeleton_of(scene);
  const uint32_t n = mesh.vertex_count;
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.method = SINEW_METHOD_HEAT;
  size_t bytes = 0;
  ASSERT_EQ(
      sinew_bind_workspace_size(nullptr, n, mesh.face_count, mesh.corner_count, skeleton.joint_count, &options, &bytes),
      SINEW_OK);
  const Block block(bytes);
  std::vector<uint16_t> joints(n * 4), wide(n * 4);
  std::vector<float> real(n * 4);
  std::vector<uint8_t> narrow(n * 4);
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints.data();
  outputs.weights = wide.data();
  ASSERT_EQ(sinew_bind(nullptr, &mesh, &skeleton, &options, block.data(), bytes, &outputs), SINEW_OK);
  options.weight_format = SINEW_WEIGHT_FLOAT;
  outputs.weights = real.data();
  ASSERT_EQ(sinew_bind(nullptr, &mesh, &skeleton, &options, block.data(), bytes, &outputs), SINEW_OK);
  options.weight_format = SINEW_WEIGHT_UNORM8;
  outputs.weights = narrow.data();
  ASSERT_EQ(sinew_bind(nullptr, &mesh, &skeleton, &options, block.data(), bytes, &outputs), SINEW_OK);
  for (size_t i = 0; i < wide.size(); ++i) EXPECT_EQ(real[i], static_cast<float>(wide[i]) / 65535.0f);
  for (uint32_t v = 0; v < n; ++v) {
    EXPECT_EQ(std::accumulate(narrow.begin() + v * 4, narrow.begin() + v * 4 + 4, 0), 255);
  }
}

// Hints: rows given for some vertices. Painted over the scene's own result: one joint alone, or two.
struct Painted {
  std::vector<uint8_t> hints;
  Rows rows;  // in: given rows; out: all rows
};

Painted paint(Random& random, const Scene& scene, uint32_t percent) {
  const uint32_t n = static_cast<uint32_t>(scene.positions.size() / 3);
  const uint32_t joint_count = static_cast<uint32_t>(scene.parents.size());
  Painted p;
  p.hints.assign(n, 0);
  p.rows.joints.assign(n * size_t{4}, 0);
  p.rows.weights.assign(n * size_t{4}, 0);
  for (uint32_t v = 0; v < n; ++v) {
    if (below(random, 100) >= percent) continue;
    p.hints[v] = 1;
    const uint32_t a = below(random, joint_count), b = below(random, joint_count);
    const uint32_t share = a == b ? 65535 : 32768 + below(random, 32768);
    p.rows.joints[v * 4] = static_cast<uint16_t>(a);
    p.rows.weights[v * 4] = static_cast<uint16_t>(share);
    if (share == 65535) continue;
    p.rows.joints[v * 4 + 1] = static_cast<uint16_t>(b);
    p.rows.weights[v * 4 + 1] = static_cast<uint16_t>(65535 - share);
  }
  return p;
}

void bind_painted(const Scene& scene, const sinew_model* model, sinew::Options options, Painted* p) {
  const sinew_mesh mesh = mesh_of(scene);
  const sinew_skeleton skeleton = skeleton_of(scene);
  options.method = model != nullptr ? SINEW_METHOD_MODEL : SINEW_METHOD_HEAT;
  options.hints = p->hints.data();
  p->rows.status = sinew_bind_workspace_size(model, mesh.vertex_count, mesh.face_count, mesh.corner_count,
                                             skeleton.joint_count, &options, &p->rows.asked);
  ASSERT_EQ(p->rows.status, SINEW_OK);
  const Block block(p->rows.asked);
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = p->rows.joints.data();
  outputs.weights = p->rows.weights.data();
  p->rows.status = sinew_bind(model, &mesh, &skeleton, &options, block.data(), p->rows.asked, &outputs);
  p->rows.used = outputs.used_bytes;
}

TEST(BindProperty, HintsAreKeptAndRowsStaySound) {
  const sinew_model* model = bundled_model();
  for (int i = 0; i < 200; ++i) {
    Random random(static_cast<uint64_t>(i) + 9000);
    const Scene scene = random_scene(random);
    const Painted given = paint(random, scene, 1 + below(random, 40));
    Painted out = given;
    sinew_bind_options options = SINEW_INIT(sinew_bind_options);
    options.grid_size = 16;
    bind_painted(scene, i % 2 != 0 ? model : nullptr, options, &out);
    ASSERT_EQ(out.rows.status, SINEW_OK) << "scene " << i << ": " << sinew_status_text(out.rows.status);
    ASSERT_LE(out.rows.used, out.rows.asked) << "scene " << i;
    for (size_t v = 0; v < given.hints.size(); ++v) {
      for (size_t s = v * 4; s < v * 4 + 4 && given.hints[v] != 0; ++s) {
        ASSERT_EQ(out.rows.joints[s], given.rows.joints[s]) << "scene " << i << " vertex " << v;
        ASSERT_EQ(out.rows.weights[s], given.rows.weights[s]) << "scene " << i << " vertex " << v;
      }
      // Only predicted rows promise order; a given row stays as it was given.
      if (given.hints[v] != 0) {
        for (size_t s = v * 4; s < v * 4 + 4; ++s) out.rows.joints[s] = out.rows.weights[s] = 0;
        out.rows.weights[v * 4] = 65535;
      }
    }
    ASSERT_TRUE(rows_are_sound(out.rows, 4, scene.parents.size())) << "scene " << i;
  }
}

TEST(BindProperty, HintsOnNothingChangeNothingAndOnAllKeepAll) {
  for (int i = 0; i < 20; ++i) {
    Random random(static_cast<uint64_t>(i) + 9500);
    const Scene scene = random_scene(random);
    const sinew_model* model = i % 2 != 0 ? bundled_model() : nullptr;
    sinew_bind_options options = SINEW_INIT(sinew_bind_options);
    options.grid_size = 16;
    Painted none = paint(random, scene, 0);
    bind_painted(scene, model, options, &none);
    const Rows plain = bind(scene, model, options);
    ASSERT_EQ(none.rows.joints, plain.joints) << "scene " << i;
    ASSERT_EQ(none.rows.weights, plain.weights) << "scene " << i;

    const Painted given = paint(random, scene, 100);
    Painted all = given;
    bind_painted(scene, model, options, &all);
    ASSERT_EQ(all.rows.joints, given.rows.joints) << "scene " << i;
    ASSERT_EQ(all.rows.weights, given.rows.weights) << "scene " << i;
  }
}

// A tube with three joints, all of it given to the joint at its far end by one painted ring: the ring's neighbors
// follow, an island without a hint does not move by a bit.
TEST(BindProperty, HintsSteerTheirSurroundings) {
  Random random(5);
  Scene scene;
  add_tube(&scene, random, 30, 8);
  add_tube(&scene, random, 10, 8);
  for (int j = 0; j < 3; ++j) {
    scene.joints.insert(scene.joints.end(),
                        {scene.positions[0], scene.positions[1] + 1.4f * static_cast<float>(j), scene.positions[2]});
    scene.parents.push_back(j - 1);
  }
  for (const sinew_model* model : {static_cast<const sinew_model*>(nullptr), bundled_model()}) {
    const Rows before = bind(scene, model, {});
    Painted painted = paint(random, scene, 0);
    for (size_t v = 8; v < 16; ++v) {  // the second ring from below belongs to joint 0 or 1
      painted.hints[v] = 1;
      painted.rows.joints[v * 4] = 2;
      painted.rows.weights[v * 4] = 65535;
    }
    bind_painted(scene, model, {}, &painted);
    ASSERT_EQ(painted.rows.status, SINEW_OK);
    const auto share_of_2 = [](const Rows& rows, size_t v) {
      for (size_t s = v * 4; s < v * 4 + 4; ++s) {
        if (rows.joints[s] == 2 && rows.weights[s] > 0) return static_cast<int>(rows.weights[s]);
      }
      return 0;
    };
    int last = 65536;
    for (size_t ring = 2; ring < 8; ++ring) {
      const int share = share_of_2(painted.rows, ring * 8);
      EXPECT_LT(share, last) << "it does not get weaker with distance, ring " << ring;
      last = share;
    }
    EXPECT_GT(share_of_2(painted.rows, 16), 65535 / 2);
    for (size_t s = 30 * 8 * 4; s < before.weights.size(); ++s) {
      ASSERT_EQ(painted.rows.joints[s], before.joints[s]);
      ASSERT_EQ(painted.rows.weights[s], before.weights[s]);
    }
  }
}

TEST(BindProperty, HintsDoNotDependOnNumbering) {
  for (int i = 0; i < 40; ++i) {
    Random random(static_cast<uint64_t>(i) + 9700);
    const Scene scene = random_scene(random);
    const size_t n = scene.positions.size() / 3;
    const Painted given = paint(random, scene, 10);
    Scene other = scene;
    Painted b = given;
    for (size_t v = 0; v < n; ++v) {  // vertices backwards
      std::memcpy(&other.positions[(n - 1 - v) * 3], &scene.positions[v * 3], 3 * sizeof(float));
      b.hints[n - 1 - v] = given.hints[v];
      std::memcpy(&b.rows.joints[(n - 1 - v) * 4], &given.rows.joints[v * 4], 4 * sizeof(uint16_t));
      std::memcpy(&b.rows.weights[(n - 1 - v) * 4], &given.rows.weights[v * 4], 4 * sizeof(uint16_t));
    }
    for (uint32_t& c : other.corners) c = static_cast<uint32_t>(n) - 1 - c;
    Painted a = given;
    sinew_bind_options options = SINEW_INIT(sinew_bind_options);
    options.grid_size = 16;
    const sinew_model* model = i % 2 != 0 ? bundled_model() : nullptr;
    bind_painted(scene, model, options, &a);
    bind_painted(other, model, options, &b);
    for (size_t v = 0; v < n; ++v) {
      for (size_t s = 0; s < 4; ++s) {
        ASSERT_EQ(a.rows.joints[v * 4 + s], b.rows.joints[(n - 1 - v) * 4 + s]) << "scene " << i << " vertex " << v;
        ASSERT_EQ(a.rows.weights[v * 4 + s], b.rows.weights[(n - 1 - v) * 4 + s]) << "scene " << i << " vertex " << v;
      }
    }
  }
}

TEST(BindProperty, HintsWithoutWeightAreRefused) {
  Random random(41);
  const Scene scene = random_scene(random);
  Painted painted = paint(random, scene, 0);
  painted.hints[0] = 1;
  bind_painted(scene, nullptr, {}, &painted);
  EXPECT_EQ(painted.rows.status, SINEW_ERROR_RANGE) << "a hint without weight";
  painted.rows.weights[0] = 65535;
  painted.rows.joints[0] = static_cast<uint16_t>(scene.parents.size());
  bind_painted(scene, nullptr, {}, &painted);
  EXPECT_EQ(painted.rows.status, SINEW_ERROR_RANGE) << "a joint that does not exist";
  painted.rows.joints[0] = 0;
  bind_painted(scene, nullptr, {}, &painted);
  EXPECT_EQ(painted.rows.status, SINEW_OK);
}

}  // namespace
