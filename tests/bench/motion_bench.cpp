// SPDX-License-Identifier: MIT
// A frame of a retargeted clip by every method, on a body of tubes whose hands pass over its belly: CSV on standard output. Times are
// those of whole clips, divided by their frames; `times` is the ratio to the copy.
//   sinew_bench_motion [--repeats N] [--frames N] [VERTICES...]      default: 5000
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench_report.hpp"
#include "motion_scene.hpp"
#include "sinew/motion_clips.h"
#include "sinew/published.h"
#include "sinew/sinew.hpp"
#include "skinned_triangles.hpp"

namespace {

using namespace sinew_test;

void check(sinew_status status, const char* what) { sinew_bench::check("sinew_bench_motion", what, status); }

// 60 joints: the body of the tests, with fingers and toes.
MotionScene whole_body(double degrees, double size) {
  MotionScene scene = body(degrees, size);
  for (const uint32_t hand : {uint32_t{kLeftHand}, uint32_t{kRightHand}}) {
    const Vec3d out = sinew::unit(scene.at(hand) - scene.at(hand - 1));
    for (int finger = 0; finger < 5; ++finger) {
      uint32_t parent = hand;
      for (int part = 1; part <= 4; ++part)
        parent = scene.add(scene.at(hand) + (0.02 * size * part) * out + Vec3d{0, 0, 0.015 * size * (finger - 2)},
                           static_cast<int32_t>(parent), static_cast<uint8_t>(SINEW_CLASS_THUMB + finger));
    }
  }
  while (scene.count() < 60) {
    const uint32_t foot = scene.count() % 2 == 0 ? kLeftFoot : kRightFoot;
    scene.add(scene.at(foot) + Vec3d{0, -0.05 * size, 0.12 * size}, static_cast<int32_t>(foot), SINEW_CLASS_TOE);
  }
  return scene;
}

constexpr uint32_t kRightTip = 17 + 20 + 11;  // of the third finger

// A tube of rings around every long bone and the trunk.
struct Tubes : sinew_test::SkinnedTriangles {
  Tubes(const MotionScene& scene, double belly, double size, uint32_t vertices) : SkinnedTriangles(2) {
    const uint32_t bones[13][2] = {{kPelvis, kSpine},
                                   {kSpine, kNeck},
                                   {kNeck, kHead},
                                   {kLeftUpperArm, kLeftForearm},
                                   {kLeftForearm, kLeftHand},
                                   {kLeftHand, kLeftFinger},
                                   {kRightUpperArm, kRightForearm},
                                   {kRightForearm, kRightHand},
                                   {kRightHand, kRightTip},
                                   {kLeftThigh, kLeftCalf},
                                   {kLeftCalf, kLeftFoot},
                                   {kRightThigh, kRightCalf},
                                   {kRightCalf, kRightFoot}};
    const uint32_t each = vertices / 13;
    const uint32_t around = static_cast<uint32_t>(std::lround(std::sqrt(each * 0.8)));
    for (size_t b = 0; b < 13; ++b) {
      add(scene, bones[b][0], bones[b][1], size * (b < 2 ? belly : 0.045), around, each / around);
    }
  }
  void add(const MotionScene& scene, uint32_t from, uint32_t to, double radius, uint32_t around, uint32_t rings) {
    const uint32_t first = static_cast<uint32_t>(joints.size() / 2);
    const Vec3d a = scene.at(from), way = scene.at(to) - a, along = sinew::unit(way);
    const Vec3d side = sinew::unit(sinew::cross(along, {0.3, 0.1, 1})), other = sinew::cross(along, side);
    for (uint32_t r = 0; r < rings; ++r) {
      const double share = static_cast<double>(r) / (rings - 1);
      for (uint32_t k = 0; k < around; ++k) {
        const double angle = 6.283185307179586 * k / around;
        const Vec3d p = a + share * way + radius * (std::cos(angle) * side + std::sin(angle) * other);
        for (const double x : {p.x, p.y, p.z}) positions.push_back(static_cast<float>(x));
        const uint16_t of_next = static_cast<uint16_t>(share > 0.8 ? 65535 * (share - 0.8) * 2.5 : 0);
        joints.insert(joints.end(), {static_cast<uint16_t>(from), static_cast<uint16_t>(to)});
        weights.insert(weights.end(), {static_cast<uint16_t>(65535 - of_next), of_next});
        if (r + 1 == rings) continue;
        const uint32_t v = first + r * around + k, next = first + r * around + (k + 1) % around;
        triangles.insert(triangles.end(), {v, next, next + around, v, next + around, v + around});
      }
    }
  }
};

// Arms that swing over the belly, knees that bend, hips that sway.
Pose pose_at(const MotionScene& scene, double t) {
  Pose pose = rest_pose(scene);
  const auto turn = [&](uint32_t j, Vec3d axis, double angle) {
    const Vec3d v = std::sin(angle / 2) * sinew::unit(axis);
    pose.set(j, {v.x, v.y, v.z, std::cos(angle / 2)}, vec(&pose.translations[3 * j]));
  };
  for (const double side : {1.0, -1.0}) {
    const uint32_t arm = side > 0 ? kLeftUpperArm : kRightUpperArm, leg = side > 0 ? kLeftThigh : kRightThigh;
    turn(arm, {0.5, -0.6 * side, -side}, 1.1 + 0.3 * std::sin(t));
    turn(arm + 1, {0.2, -side, 0}, 1.3 + 0.5 * std::sin(1.3 * t));
    turn(leg, {1, 0, 0}, -0.3 - 0.2 * std::sin(t * side));
    turn(leg + 1, {1, 0, 0}, 0.5 + 0.3 * std::sin(t * side));
  }
  pose.translations[0] += static_cast<float>(0.05 * std::sin(t));
  return pose;
}

struct Method {
  const char* name;
  std::vector<double> seconds = {};
  size_t bytes = 0;
  uint64_t hash = 0;
};

void measure(uint32_t vertices, uint32_t frames, int repeats) {
  const MotionScene from = whole_body(5, 1), to = whole_body(35, 0.85);
  const Tubes source_mesh(from, 0.13, 1, vertices), target_mesh(to, 0.19, 0.85, vertices);
  const sinew_motion_body source = source_mesh.view(), target = target_mesh.view();
  std::vector<float> rotations, translations;
  for (uint32_t f = 0; f < frames; ++f) {
    const Pose pose = pose_at(from, 0.1 * f);
    rotations.insert(rotations.end(), pose.rotations.begin(), pose.rotations.end());
    translations.insert(translations.end(), pose.translations.begin(), pose.translations.end());
  }
  std::vector<float> sitting = translations;  // seat, knees, hands and feet are on the floor
  for (uint32_t f = 0; f < frames; ++f) sitting[size_t{3} * from.count() * f + 1] -= 0.8f;
  const sinew_skeleton source_rig = from.view(), target_rig = to.view();
  size_t bytes = 0;
  check(sinew_retarget_create_workspace_size(from.count(), to.count(), &bytes), "size");
  const sinew::Workspace memory(bytes);
  sinew_retarget* plan = nullptr;
  check(sinew_retarget_create(&source_rig, &target_rig, one_to_one(to.count()).data(), to.classes.data(), nullptr,
                              memory.data(), memory.size(), &plan),
        "plan");
  float ground = 0;
  check(sinew_retarget_ground(plan, nullptr, 0, &ground), "ground");
  Method methods[] = {{"copy"},
                      {"contacts"},
                      {"contacts without a body"},
                      {"reference points"},
                      {"stream"},
                      {"stream on the floor"},
                      {"stream with a body"},
                      {"stream that knows no hands"}};
  size_t contacts = 0, points = 0;
  check(sinew_retarget_contacts_workspace_size(plan, &target, frames, &contacts), "size");
  check(sinew_retarget_reference_points_workspace_size(plan, &target, &points), "size");
  const sinew::Workspace workspace(contacts > points ? contacts : points);
  sinew_motion_body const* const bodies[] = {nullptr, &source, nullptr, &source};
  sinew::RetargetStream stream, stream_of_body, no_hands;
  sinew::StreamSettings of_body;
  of_body.source = &source;
  sinew_motion_body bare = target;
  bare.triangle_count = 0;
  const auto make = [&](sinew::RetargetStream* one, const sinew_motion_body& on,
                        const sinew::StreamSettings& settings) {
    check(one->make(source_rig, target_rig, one_to_one(to.count()).data(), to.classes.data(), {}, &on, settings),
          "stream");
  };
  make(&stream, target, {});
  make(&stream_of_body, target, of_body);
  make(&no_hands, bare, {});
  sinew::RetargetStream* const streams[] = {&stream, &stream, &stream_of_body, &no_hands};
  size_t stream_bytes[4] = {};
  for (size_t k = 0; k < 4; ++k)
    check(sinew_retarget_stream_workspace_size(from.count(), to.count(), target.vertex_count,
                                               k == 3 ? 0 : target.triangle_count, &stream_bytes[k]),
          "size");
  for (int i = 0; i < repeats; ++i) {
    for (size_t m = 0; m < 8; ++m) {
      std::vector<float> out_rotations(size_t{4} * to.count() * frames),
          out_translations(size_t{3} * to.count() * frames);
      double start = sinew_bench::thread_seconds();
      for (uint32_t f = 0; f < frames; ++f)
        check(sinew_retarget_frame(
                  plan, &rotations[size_t{4} * from.count() * f], &translations[size_t{3} * from.count() * f], ground,
                  &out_rotations[size_t{4} * to.count() * f], &out_translations[size_t{3} * to.count() * f]),
              "frame");
      const sinew_motion_clip clip = {
          rotations.data(), translations.data(), out_rotations.data(), out_translations.data(), frames, ground};
      if (m > 0) start = sinew_bench::thread_seconds();  // what comes after the copy
      if (m == 1 || m == 2)
        check(sinew_retarget_contacts(plan, bodies[m], &target, &clip, nullptr, workspace.data(), workspace.size()),
              methods[m].name);
      if (m >= 4) {  // with a copy of its own
        check(streams[m - 4]->restart(), "restart");
        for (uint32_t f = 0; f < frames; ++f)
          check(streams[m - 4]->frame(&rotations[size_t{4} * from.count() * f],
                                      &(m == 5 ? sitting : translations)[size_t{3} * from.count() * f],
                                      &out_rotations[size_t{4} * to.count() * f],
                                      &out_translations[size_t{3} * to.count() * f]),
                "stream");
      }
      if (m == 3)
        check(sinew_retarget_reference_points(plan, bodies[m], &target, &clip, nullptr, workspace.data(),
                                              workspace.size()),
              methods[m].name);
      methods[m].seconds.push_back((sinew_bench::thread_seconds() - start) / frames);
      methods[m].bytes = m == 0 ? 0 : m == 3 ? points : m >= 4 ? stream_bytes[m - 4] : contacts;
      methods[m].hash =
          sinew_bench::fnv1a(sinew_bench::kHashStart, out_rotations.data(), out_rotations.size() * sizeof(float));
    }
  }
  const double copy = sinew_bench::median(methods[0].seconds);
  for (const Method& method : methods) {
    const double median = sinew_bench::median(method.seconds);
    std::printf("%s,%s,%u,%u,%u,%u,%.4f,%.1f,%zu,%016llx\n", sinew_bench::row_start().c_str(), method.name,
                target.vertex_count, target.triangle_count, to.count(), frames, median * 1e3, median / copy,
                method.bytes, static_cast<unsigned long long>(method.hash));
  }
}

}  // namespace

int main(int argc, char** argv) {
  int repeats = 7;
  uint32_t frames = 60;
  std::vector<uint32_t> sizes;
  for (int i = 1; i < argc; ++i) {
    if (i + 1 < argc && std::strcmp(argv[i], "--repeats") == 0) {
      repeats = std::max(1, std::atoi(argv[++i]));
    } else if (i + 1 < argc && std::strcmp(argv[i], "--frames") == 0) {
      frames = static_cast<uint32_t>(std::max(1, std::atoi(argv[++i])));
    } else {
      const int size = std::atoi(argv[i]);
      if (size < 500) {
        std::fprintf(stderr, "usage: sinew_bench_motion [--repeats N] [--frames N] [VERTICES...]   (500 or more)\n");
        return 2;
      }
      sizes.push_back(static_cast<uint32_t>(size));
    }
  }
  if (sizes.empty()) sizes.push_back(5000);
  std::printf(
      "machine,compiler,commit,method,vertices,triangles,joints,frames,ms_a_frame,times,workspace_bytes,hash\n");
  for (const uint32_t vertices : sizes) measure(vertices, frames, repeats);
  return 0;
}
