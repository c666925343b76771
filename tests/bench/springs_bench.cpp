// SPDX-License-Identifier: MIT
// A frame of springs on a character of 60 other joints: CSV on standard output.
//   sinew_bench_springs [--repeats N] [--frames N]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "bench_report.hpp"
#include "spring_scene.hpp"

namespace {

using namespace sinew_test;

void check(sinew_status status, const char* what) { sinew_bench::check("sinew_bench_springs", what, status); }

// Ten chains of `joints` / 10 joints that turn each, about colliders of both shapes that touch some of them.
SpringScene scene_of(uint32_t joints, uint32_t colliders) {
  SpringScene scene;
  for (int j = 2; j < 60; ++j) {
    scene.positions.insert(scene.positions.end(), {0.3f * static_cast<float>(j % 5), 0.02f * static_cast<float>(j), 0});
    scene.parents.push_back(j % 5 == 0 ? 1 : j - 1);
  }
  for (int c = 0; c < 10; ++c) {
    const double angle = 0.628 * c;
    const Vec3d out = {std::cos(angle), 0, std::sin(angle)};
    scene.add_chain(Vec3d{0, 1, 0} + 0.1 * out, 0.02 * out + Vec3d{0, -0.05, 0}, joints / 10 + 1,
                    spring_joint(1, 0.3f, 0.4f, 0.02f));
  }
  for (uint32_t c = 0; c < colliders; ++c) {
    const float y = -0.05f * static_cast<float>(c);
    scene.colliders.push_back({c % 3 == 0 ? 1u : c,
                               c % 2 == 0 ? SINEW_COLLIDER_SPHERE : SINEW_COLLIDER_CAPSULE,
                               {0, y, 0},
                               {0, y - 0.2f, 0},
                               0.1f});
  }
  scene.share_colliders();
  return scene;
}

void measure(uint32_t joints, uint32_t colliders, double fps, uint32_t frames, int repeats) {
  const SpringScene scene = scene_of(joints, colliders);
  sinew::SpringSystem springs;
  check(springs.make(scene.skeleton(), scene.set()), "create");
  size_t bytes = 0;
  check(sinew_springs_workspace_size(scene.count(), static_cast<uint32_t>(scene.joints.size()), 10, colliders,
                                     colliders, &bytes),
        "size");
  std::vector<float> rotations, translations;
  std::vector<std::vector<float>> poses, moves;
  for (uint32_t f = 0; f < frames; ++f) {
    const double t = f / fps;
    scene.pose({0.2 * std::sin(3 * t), 0, 0}, about({0, 1, 0.2}, 0.7 * std::sin(4 * t)), &rotations, &translations);
    poses.push_back(rotations);
    moves.push_back(translations);
  }
  std::vector<double> seconds;
  uint64_t hash = 0;
  for (int i = 0; i < repeats; ++i) {
    check(springs.restart(), "restart");
    hash = sinew_bench::kHashStart;
    double sum = 0;
    for (uint32_t f = 0; f < frames; ++f) {
      const double start = sinew_bench::thread_seconds();
      check(springs.frame(static_cast<float>(1 / fps), poses[f].data(), moves[f].data(), rotations.data()), "frame");
      sum += sinew_bench::thread_seconds() - start;
      hash = sinew_bench::fnv1a(hash, rotations.data(), rotations.size() * sizeof(float));
    }
    seconds.push_back(sum / frames);
  }
  std::printf("%s,%u,%u,%u,%.0f,%u,%.5f,%zu,%016llx\n", sinew_bench::row_start().c_str(), joints, colliders,
              scene.count(), fps, frames, sinew_bench::median(seconds) * 1e3, bytes,
              static_cast<unsigned long long>(hash));
}

}  // namespace

int main(int argc, char** argv) {
  int repeats = 11;
  uint32_t frames = 300;
  for (int i = 1; i < argc; ++i) {
    if (i + 1 < argc && std::strcmp(argv[i], "--repeats") == 0) {
      repeats = std::max(1, std::atoi(argv[++i]));
    } else if (i + 1 < argc && std::strcmp(argv[i], "--frames") == 0) {
      frames = static_cast<uint32_t>(std::max(1, std::atoi(argv[++i])));
    } else {
      std::fprintf(stderr, "usage: sinew_bench_springs [--repeats N] [--frames N]\n");
      return 2;
    }
  }
  std::printf("machine,compiler,commit,spring_joints,colliders,joints,fps,frames,ms_a_frame,workspace_bytes,hash\n");
  for (const double fps : {60.0, 30.0, 144.0}) measure(50, 16, fps, frames, repeats);
  measure(200, 16, 60, frames, repeats);
  return 0;
}
