// SPDX-License-Identifier: MIT
// The caller's threads: the same bytes for any number of pieces and any way to run them, within the promised workspace.
// Run under ThreadSanitizer it also says that no piece touches another's memory (tests/README.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "bound_scene.hpp"
#include "lent_threads.hpp"

namespace {

using sinew_test::LoopLog;

struct Bound : sinew_test::BoundScene {
  LoopLog log;
};

struct Extras {
  uint32_t method = SINEW_METHOD_MODEL;
  uint32_t rigid_parts = SINEW_RIGID_PARTS_AUTO;
  bool symmetric = false, hints = false;
  sinew_progress progress = nullptr;
  void* progress_user = nullptr;
};

Bound bind_scene(const sinew_test::HeatScene& scene, uint32_t threads, sinew_parallel_for parallel_for,
                 const Extras& extras) {
  Bound bound;
  std::vector<uint8_t> hints(scene.vertex_count(), 0);
  for (size_t v = 0; v < hints.size(); v += 97) hints[v] = 1;
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.grid_size = 32;
  options.method = extras.method;
  options.rigid_parts = extras.rigid_parts;
  options.symmetric = extras.symmetric;
  options.hints = extras.hints ? hints.data() : nullptr;
  options.progress = extras.progress;
  options.progress_user = extras.progress_user;
  options.parallel_for = parallel_for;
  options.parallel_user = &bound.log;
  options.thread_count = threads;
  static_cast<sinew_test::BoundScene&>(bound) = sinew_test::bind_scene(scene, options);
  return bound;
}

// A body with six arms, and a swarm of loose parts of very different sizes around it.
sinew_test::HeatScene crowd() {
  sinew_test::HeatScene scene = sinew_test::star(15, 30, 4);
  for (uint32_t part = 0; part < 40; ++part) {
    const uint32_t first = scene.vertex_count(), rings = 1 + part % 7 * (part % 5 == 0 ? 12 : 1);
    const float x = 3 + static_cast<float>(part % 8), y = 3 + static_cast<float>(part / 8);
    for (uint32_t r = 0; r <= rings; ++r) {
      for (uint32_t c = 0; c < 4; ++c) {
        const float side[4][2] = {{0, 0}, {0.2f, 0}, {0.2f, 0.2f}, {0, 0.2f}};
        scene.positions.insert(scene.positions.end(), {x + side[c][0], y + side[c][1], 0.05f * static_cast<float>(r)});
      }
    }
    for (uint32_t r = 0; r < rings; ++r) {
      for (uint32_t c = 0; c < 4; ++c) {
        const uint32_t a = first + r * 4 + c, b = first + r * 4 + (c + 1) % 4;
        scene.triangles.insert(scene.triangles.end(), {a, b, b + 4, a, b + 4, a + 4});
      }
    }
  }
  return scene;
}

class ThreadsBind : public ::testing::TestWithParam<int> {
 protected:
  static Extras extras() {
    Extras e;
    switch (GetParam()) {
      case 1:
        e.method = SINEW_METHOD_HEAT;
        break;
      case 2:
        e.symmetric = e.hints = true;
        e.rigid_parts = SINEW_RIGID_PARTS_NEVER;
        break;
      default:
        break;
    }
    return e;
  }
};

TEST_P(ThreadsBind, TheSameBytesForAnyNumberOfPieces) {
  const sinew_test::HeatScene scene = crowd();
  const Bound alone = bind_scene(scene, 0, nullptr, extras());
  ASSERT_EQ(alone.status, SINEW_OK);
  struct Way {
    uint32_t threads;
    sinew_parallel_for run;
  };
  for (const Way& way : {Way{1, sinew_test::run_on_threads}, Way{2, sinew_test::run_on_threads},
                         Way{7, sinew_test::run_on_threads}, Way{64, sinew_test::run_backwards}, Way{3, nullptr}}) {
    SCOPED_TRACE(way.threads);
    const Bound bound = bind_scene(scene, way.threads, way.run, extras());
    ASSERT_EQ(bound.status, SINEW_OK);
    EXPECT_EQ(bound.joints, alone.joints);
    EXPECT_EQ(bound.weights, alone.weights);
    EXPECT_EQ(bound.confidence, alone.confidence);
    EXPECT_LE(bound.used, bound.bytes);
    if (way.threads == 1 || way.run == nullptr) {
      EXPECT_EQ(bound.log.loops, 0u);
    } else {
      EXPECT_GT(bound.log.loops, 0u);
      EXPECT_LE(bound.log.largest, way.threads);
      EXPECT_GE(bound.log.largest, std::min(way.threads, 7u)) << "there is work for all of a few threads";
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Methods, ThreadsBind, ::testing::Values(0, 1, 2));

TEST(ThreadsOption, WorkspaceDependsOnTheCountAlone) {
  const sinew_test::HeatScene scene = crowd();
  const Bound one = bind_scene(scene, 1, nullptr, {}), four = bind_scene(scene, 4, nullptr, {});
  EXPECT_EQ(bind_scene(scene, 0, nullptr, {}).bytes, one.bytes);
  EXPECT_EQ(bind_scene(scene, 4, sinew_test::run_backwards, {}).bytes, four.bytes);
  EXPECT_GT(four.bytes, one.bytes);
}

TEST(ThreadsOption, MoreThanTheLimitIsRefused) {
  EXPECT_EQ(bind_scene(crowd(), SINEW_MAX_THREADS + 1, nullptr, {}).status, SINEW_ERROR_ARGUMENT);
}

// Progress is told on the calling thread alone, rises, and cancels.
TEST(ThreadsOption, ProgressStaysOnTheCallingThread) {
  struct Watch {
    std::thread::id caller = std::this_thread::get_id();
    uint32_t last = 0, reports = 0, stop_at = 0;
    bool elsewhere = false, fell = false;
  } watch;
  Extras extras;
  extras.progress_user = &watch;
  extras.progress = [](void* user, uint32_t permille) {
    Watch& w = *static_cast<Watch*>(user);
    w.elsewhere = w.elsewhere || std::this_thread::get_id() != w.caller;
    w.fell = w.fell || permille < w.last;
    w.last = permille;
    return ++w.reports == w.stop_at ? 1 : 0;
  };
  const sinew_test::HeatScene scene = crowd();
  ASSERT_EQ(bind_scene(scene, 3, sinew_test::run_on_threads, extras).status, SINEW_OK);
  EXPECT_FALSE(watch.elsewhere);
  EXPECT_FALSE(watch.fell);
  EXPECT_EQ(watch.last, 1000u);
  EXPECT_GT(watch.reports, 20u);
  watch.stop_at = watch.reports - 2;
  watch.reports = 0;
  EXPECT_EQ(bind_scene(scene, 3, sinew_test::run_on_threads, extras).status, SINEW_ERROR_CANCELLED);
}

}  // namespace
