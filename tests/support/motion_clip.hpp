// SPDX-License-Identifier: MIT
// A clip that is played from one body of boxes on another, for tests of what looks at whole clips.
#ifndef SINEW_TESTS_SUPPORT_MOTION_CLIP_HPP
#define SINEW_TESTS_SUPPORT_MOTION_CLIP_HPP

#include <gtest/gtest.h>

#include <algorithm>

#include "motion_scene.hpp"
#include "sinew/motion_clips.h"
#include "sinew/published.h"
#include "skinned_triangles.hpp"

namespace sinew_test {

// A body of boxes, one around each joint of body(), rigid; `belly` is how thick the one at the spine is, and that one has a
// grid on each side. The same vertices and triangles whatever the sizes are.
struct BoxBody : SkinnedTriangles {
  BoxBody(const MotionScene& scene, double belly, double size = 1) : SkinnedTriangles(1) {
    for (uint32_t j = 0; j < scene.count(); ++j) {
      const double half = size * (j == kSpine ? belly : 0.04);
      const uint32_t cells = j == kSpine ? 6 : 1;
      for (int axis = 0; axis < 3; ++axis) {
        add_side(scene, j, axis, half, cells);
        add_side(scene, j, axis, -half, cells);
      }
    }
  }
  void add_side(const MotionScene& scene, uint32_t j, int axis, double half, uint32_t cells) {
    const uint32_t first = static_cast<uint32_t>(positions.size() / 3), row = cells + 1;
    const double size = std::abs(half);
    for (uint32_t u = 0; u <= cells; ++u) {
      for (uint32_t v = 0; v <= cells; ++v) {
        double p[3];
        p[axis] = half;
        p[(axis + 1) % 3] = size * (2.0 * u / cells - 1);
        p[(axis + 2) % 3] = size * (2.0 * v / cells - 1);
        const Vec3d position = scene.at(j) + Vec3d{p[0], p[1], p[2]};
        for (const double x : {position.x, position.y, position.z}) positions.push_back(static_cast<float>(x));
        joints.push_back(static_cast<uint16_t>(j));
        weights.push_back(65535);
      }
    }
    for (uint32_t u = 0; u < cells; ++u) {
      for (uint32_t v = 0; v < cells; ++v) {
        const uint32_t c = first + u * row + v;
        const uint32_t out[6] = {c, c + row, c + row + 1, c, c + row + 1, c + 1};
        for (int i = 0; i < 6; ++i) triangles.push_back(half > 0 ? out[i] : out[5 - i]);
      }
    }
  }
};

// A source's clip, played on a target.
struct PlayedClip {
  MotionScene source, target;
  std::vector<float> from_rotations, from_translations, rotations, translations;
  uint32_t frames = 0;
  float ground = 0;
  sinew::Workspace memory;
  sinew_retarget* plan = nullptr;

  PlayedClip(const MotionScene& s, const MotionScene& t, const sinew::RetargetSettings& settings = {})
      : source(s), target(t) {
    const sinew_skeleton from = s.view(), to = t.view();
    size_t bytes = 0;
    EXPECT_EQ(sinew_retarget_create_workspace_size(s.count(), t.count(), &bytes), SINEW_OK);
    memory = sinew::Workspace(bytes);
    EXPECT_EQ(sinew_retarget_create(&from, &to, one_to_one(t.count()).data(), t.classes.data(), &settings,
                                    memory.data(), memory.size(), &plan),
              SINEW_OK);
    EXPECT_EQ(sinew_retarget_ground(plan, nullptr, 0, &ground), SINEW_OK);
  }
  void add(const Pose& pose) {
    Pose out(target.count());
    EXPECT_EQ(sinew_retarget_frame(plan, pose.rotations.data(), pose.translations.data(), ground, out.rotations.data(),
                                   out.translations.data()),
              SINEW_OK);
    from_rotations.insert(from_rotations.end(), pose.rotations.begin(), pose.rotations.end());
    from_translations.insert(from_translations.end(), pose.translations.begin(), pose.translations.end());
    rotations.insert(rotations.end(), out.rotations.begin(), out.rotations.end());
    translations.insert(translations.end(), out.translations.begin(), out.translations.end());
    ++frames;
  }
  sinew_motion_clip view() {
    return {from_rotations.data(), from_translations.data(), rotations.data(), translations.data(), frames, ground};
  }
  // Runs a call on bodies and the clip in a workspace for it; `source_body` may be null.
  template <class Size, class Run>
  sinew_status on_bodies(const BoxBody* source_body, const BoxBody& target_body, const Size& size, const Run& run) {
    const sinew_motion_body own = target_body.view();
    sinew_motion_body other = {};
    if (source_body != nullptr) other = source_body->view();
    other.triangles = nullptr;  // unused
    other.triangle_count = 0;
    const sinew_motion_clip clip = view();
    size_t bytes = 0;
    const sinew_status sized = size(&own, &bytes);
    if (sized != SINEW_OK) return sized;
    const sinew::Workspace workspace(bytes);
    return run(source_body == nullptr ? nullptr : &other, &own, &clip, workspace.data(), workspace.size());
  }
  auto contacts_size() const {
    return [this](const sinew_motion_body* own, size_t* bytes) {
      return sinew_retarget_contacts_workspace_size(plan, own, frames, bytes);
    };
  }
  sinew_status contacts(const BoxBody* source_body, const BoxBody& target_body,
                        const sinew::ContactSettings& settings = {}) {
    return on_bodies(source_body, target_body, contacts_size(),
                     [&](const auto* from, const auto* own, const auto* clip, void* block, size_t bytes) {
                       return sinew_retarget_contacts(plan, from, own, clip, &settings, block, bytes);
                     });
  }
  sinew_status keep_range(const BoxBody& target_body) {
    return on_bodies(nullptr, target_body, contacts_size(),
                     [&](const auto*, const auto* own, const auto* clip, void* block, size_t bytes) {
                       return sinew_retarget_keep_range(plan, own, clip, block, bytes);
                     });
  }
  // source_body null: capsules.
  sinew_status reference_points(const BoxBody* source_body, const BoxBody& target_body,
                                const sinew_reference_options& options = SINEW_INIT(sinew_reference_options)) {
    return on_bodies(
        source_body, target_body,
        [&](const sinew_motion_body* own, size_t* bytes) {
          return sinew_retarget_reference_points_workspace_size(plan, own, bytes);
        },
        [&](const auto* from, const auto* own, const auto* clip, void* block, size_t bytes) {
          return sinew_retarget_reference_points(plan, from, own, clip, &options, block, bytes);
        });
  }
  sinew_status reference_points(const BoxBody& source_body, const BoxBody& target_body,
                                const sinew_reference_options& options = SINEW_INIT(sinew_reference_options)) {
    return reference_points(&source_body, target_body, options);
  }
  // With `spots` frame by frame as well.
  std::vector<sinew_limb_quality> measure(const BoxBody* source_body, const BoxBody& target_body,
                                          std::vector<sinew_contact_spot>* spots = nullptr) {
    std::vector<sinew_limb_quality> limbs(SINEW_MAX_MOTION_LIMBS);
    uint32_t count = 0;
    if (spots != nullptr) spots->assign(size_t{frames} * SINEW_MAX_MOTION_LIMBS, {9, {9, 9, 9}, 9, 9});
    EXPECT_EQ(on_bodies(source_body, target_body, contacts_size(),
                        [&](const auto* from, const auto* own, const auto* clip, void* block, size_t bytes) {
                          if (spots != nullptr)
                            return sinew_retarget_spots(plan, from, own, clip, nullptr, block, bytes, limbs.data(),
                                                        &count, spots->data());
                          return sinew_retarget_measure(plan, from, own, clip, nullptr, block, bytes, limbs.data(),
                                                        &count);
                        }),
              SINEW_OK);
    limbs.resize(count);
    return limbs;
  }
  WorldPose frame(uint32_t f) const {
    Pose pose(target.count());
    std::copy_n(rotations.begin() + 4 * target.count() * f, pose.rotations.size(), pose.rotations.begin());
    std::copy_n(translations.begin() + 3 * target.count() * f, pose.translations.size(), pose.translations.begin());
    return world_pose(target, pose);
  }
};

}  // namespace sinew_test
#endif
