// SPDX-License-Identifier: MIT
// Fuzz target: plans, frames, contacts, reference points and measures of sinew/motion.h for arbitrary skeletons, maps, classes, poses and
// bodies. Refusals are those that the header documents; what comes out is finite, of turns of length 1, and the same again.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "bind_checks.hpp"
#include "fuzz.hpp"
#include "mesh_input.hpp"
#include "sinew/motion_clips.h"
#include "sinew/published.h"
#include "sinew/rig.h"
#include "skeleton_of.hpp"
#include "skinned_triangles.hpp"

namespace {

using namespace sinew::test;

enum Extras : uint8_t {
  kRaw = 1,
  kAnyIndex = 2,
  kRotations = 4,
  kNoSource = 8,
  kCancel = 16,
  kShort = 32,
  kOptions = 64,
  kLimbs = 128
};

struct RigInput {
  std::vector<float> positions, rotations;
  std::vector<int32_t> parents;

  void read(Bytes& in, uint8_t extras, uint32_t count) {
    for (uint32_t j = 0; j < count; ++j) {
      const bool any = (extras & kAnyIndex) != 0;
      const int32_t chain = j % 4 == 1 ? 0 : static_cast<int32_t>(j) - 1;  // of limb_class()
      parents.push_back(any                      ? static_cast<int32_t>(in.below(count + 2)) - 1
                        : (extras & kLimbs) != 0 ? chain
                                                 : static_cast<int32_t>(in.below(j + 1)) - (j == 0 ? 1 : 0));
      for (int i = 0; i < 3; ++i) positions.push_back(any_float(in, (extras & kRaw) != 0));
      for (int i = 0; i < 4; ++i)
        if ((extras & kRotations) != 0) rotations.push_back(any_float(in, (extras & kRaw) != 0));
    }
  }
  uint32_t up = SINEW_UP_AUTO;

  sinew_skeleton view() const {
    sinew_skeleton view = sinew_test::skeleton_of(positions, parents);
    if (!rotations.empty()) view.rotations = rotations.data();
    view.up = up;
    return view;
  }
};

struct BodyInput : sinew_test::SkinnedTriangles {
  BodyInput() : SkinnedTriangles(2) {}
  void read(Bytes& in, uint8_t extras, uint32_t vertices, uint32_t triangle_count, uint32_t joint_count) {
    const uint32_t beyond = (extras & kAnyIndex) != 0 ? 1 : 0;
    for (uint32_t v = 0; v < vertices; ++v) {
      for (int i = 0; i < 3; ++i) positions.push_back(any_float(in, (extras & kRaw) != 0));
      const uint16_t first = static_cast<uint16_t>(257 * in.u8());
      weights.insert(weights.end(), {first, static_cast<uint16_t>(65535 - first)});
      for (int i = 0; i < 2; ++i) joints.push_back(static_cast<uint16_t>(in.below(joint_count + beyond)));
    }
    for (uint32_t c = 0; c < 3 * triangle_count && vertices + beyond > 0; ++c)
      triangles.push_back(in.below(vertices + beyond));
  }
};

// The first joint is a pelvis, then arms and legs of four joints follow each other.
uint8_t limb_class(uint32_t t) {
  constexpr uint8_t kClasses[8] = {SINEW_CLASS_UPPER_ARM, SINEW_CLASS_FOREARM, SINEW_CLASS_HAND, SINEW_CLASS_INDEX,
                                   SINEW_CLASS_THIGH,     SINEW_CLASS_CALF,    SINEW_CLASS_FOOT, SINEW_CLASS_TOE};
  return t == 0 ? uint8_t{SINEW_CLASS_PELVIS} : kClasses[(t - 1) % 8];
}

struct Call {
  uint8_t extras = 0;
  RigInput source, target;
  std::vector<int32_t> map;
  std::vector<uint8_t> classes;
  BodyInput source_body, target_body;
  sinew_retarget_options options = SINEW_INIT(sinew_retarget_options);
  sinew_contact_options contacts = SINEW_INIT(sinew_contact_options);
  sinew_reference_options points = SINEW_INIT(sinew_reference_options);
  uint32_t frames = 0, cancel_at = 0, reports = 0;
  std::vector<float> rotations, translations;

  explicit Call(Bytes in) {
    extras = in.u8();
    const uint32_t sources = 1 + in.below(12), targets = 1 + in.below(24);
    frames = in.below(5);
    const uint32_t vertices = in.below(40), triangles = in.below(40);
    if ((extras & kOptions) != 0) {
      options.struct_size -= in.below(16) == 15 ? 4 : 0;
      source.up = in.below(5);
      target.up = in.below(5);
      options.in_place = in.below(8) == 7 ? 2 : in.below(2);
      options.arm_spread = 40 * static_cast<float>(options.in_place);
      contacts.fps = any_float(in, (extras & kRaw) != 0);
      points.area_power = in.below(8) == 7 ? SINEW_NO_AREA : in.below(6);
      points.own_limb = in.below(8) == 7 ? 2 : in.below(2);
      points.head = points.torso = points.own_limb & 1;
      points.source_points = points.torso;
      points.legs = in.below(8) == 7 ? 2 : in.below(2);
      points.falloff = any_float(in, (extras & kRaw) != 0);
    }
    if ((extras & kCancel) != 0) cancel_at = 1 + in.below(16);
    contacts.progress = points.progress = [](void* user, uint32_t permille) {
      Call& call = *static_cast<Call*>(user);
      demand(permille <= 1000, "progress is 0 to 1000");
      return ++call.reports == call.cancel_at ? 1 : 0;
    };
    contacts.progress_user = points.progress_user = this;
    source.read(in, extras, sources);
    target.read(in, extras, targets);
    for (uint32_t t = 0; t < targets; ++t) {
      const uint32_t beyond = (extras & kAnyIndex) != 0 ? 2 : 1;
      const bool limbs = (extras & kLimbs) != 0;  // chains of arms and legs; else any class and map
      map.push_back(limbs ? static_cast<int32_t>(t % sources) : static_cast<int32_t>(in.below(sources + beyond)) - 1);
      classes.push_back(limbs ? limb_class(t) : static_cast<uint8_t>(in.below(26)));
    }
    source_body.read(in, extras, vertices, 0, sources);
    target_body.read(in, extras, vertices, triangles, targets);
    for (uint32_t i = 0; i < frames * sources; ++i) {
      for (int k = 0; k < 4; ++k) rotations.push_back(any_float(in, (extras & kRaw) != 0));
      for (int k = 0; k < 3; ++k) translations.push_back(any_float(in, (extras & kRaw) != 0));
    }
  }
};

bool documented(sinew_status status) {
  return status == SINEW_ERROR_ARGUMENT || status == SINEW_ERROR_VERSION || status == SINEW_ERROR_COUNT ||
         status == SINEW_ERROR_NOT_FINITE || status == SINEW_ERROR_INDEX || status == SINEW_ERROR_HIERARCHY ||
         status == SINEW_ERROR_NO_JOINT || status == SINEW_ERROR_RANGE || status == SINEW_ERROR_CANCELLED;
}

// What one call on the whole clip leaves.
struct ClipResult {
  sinew_status status = SINEW_OK;
  std::vector<float> rotations, translations;
  std::vector<uint8_t> limbs;  // of the measure
  bool operator==(const ClipResult& o) const {
    const auto same = [](const std::vector<float>& a, const std::vector<float>& b) {
      return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
    };
    return status == o.status && same(rotations, o.rotations) && same(translations, o.translations) && limbs == o.limbs;
  }
};

void check_pose(const Call& call, const std::vector<float>& rotations, const std::vector<float>& translations) {
  if ((call.extras & kRaw) != 0) return;  // what is 1e38 long may be infinite afterwards
  for (const float x : translations) demand(std::isfinite(x), "places are finite");
  for (size_t i = 0; i + 3 < rotations.size(); i += 4) {
    double square = 0;
    for (size_t k = 0; k < 4; ++k) square += double{rotations[i + k]} * double{rotations[i + k]};
    demand(std::abs(square - 1) < 1e-4, "turns have length 1");
  }
}

template <class Size, class Run>
ClipResult on_clip(Call& call, const ClipResult& copied, uint8_t fill, const Size& size, const Run& run) {
  ClipResult result = copied;
  size_t bytes = 0;
  result.status = size(&bytes);
  if (result.status != SINEW_OK) {
    demand(bytes == 0, "the size is 0 on failure");
    return result;
  }
  Workspace workspace(bytes, 0, fill);
  call.reports = 0;
  result.status = run(workspace.data(), bytes, &result);
  demand(workspace.guards_hold(), "the workspace is not written beyond its size");
  demand(result.status == SINEW_OK || documented(result.status), "a documented status");
  demand(result.status != SINEW_ERROR_CANCELLED || call.reports == call.cancel_at,
         "cancelled when the callback says so");
  if (result.status == SINEW_OK) check_pose(call, result.rotations, result.translations);
  if (result.status != SINEW_OK && result.status != SINEW_ERROR_CANCELLED) {
    const sinew_status status = result.status;
    result.status = copied.status;
    demand(result == copied, "the clip is untouched on failure");
    result.status = status;
  }
  return result;
}

void check_clip(Call& call, sinew_retarget* plan, const ClipResult& copied, float ground) {
  const sinew_motion_body from = call.source_body.view(), own = call.target_body.view();
  const sinew_motion_body* const source = (call.extras & kNoSource) != 0 ? nullptr : &from;
  const auto clip_of = [&](ClipResult* result) {
    return sinew_motion_clip{call.rotations.data(),
                             call.translations.data(),
                             result->rotations.data(),
                             result->translations.data(),
                             call.frames,
                             ground};
  };
  const auto contacts_size = [&](size_t* bytes) {
    return sinew_retarget_contacts_workspace_size(plan, &own, call.frames, bytes);
  };
  const auto measure = [&](void* block, size_t bytes, ClipResult* result) {
    const sinew_motion_clip clip = clip_of(result);
    sinew_limb_quality limbs[SINEW_MAX_MOTION_LIMBS];
    uint32_t count = 77;
    const sinew_status status =
        sinew_retarget_measure(plan, source, &own, &clip, &call.contacts, block, bytes, limbs, &count);
    demand(status == SINEW_OK ? count <= SINEW_MAX_MOTION_LIMBS : count == 77, "limbs are counted, or left alone");
    if (status != SINEW_OK) return status;
    sinew_limb_quality same[SINEW_MAX_MOTION_LIMBS];
    sinew_contact_options uncancelled = call.contacts;
    uncancelled.progress = nullptr;
    std::vector<sinew_contact_spot> spots(size_t{call.frames} * SINEW_MAX_MOTION_LIMBS + 1);
    demand(sinew_retarget_spots(plan, source, &own, &clip, &uncancelled, block, bytes, same, &count, spots.data()) ==
                   SINEW_OK &&
               std::memcmp(same, limbs, count * sizeof same[0]) == 0,
           "spots come with the same measure");
    for (size_t i = 0; i + 1 < spots.size(); ++i)
      demand(spots[i].kind <= SINEW_SPOT_INSIDE &&
                 (spots[i].kind == SINEW_SPOT_NONE || i % SINEW_MAX_MOTION_LIMBS < count),
             "a spot belongs to a limb");
    const uint8_t* const first = reinterpret_cast<const uint8_t*>(limbs);
    result->limbs.assign(first, first + count * sizeof(sinew_limb_quality));
    for (uint32_t l = 0; l < count; ++l) {
      const sinew_limb_quality& limb = limbs[l];
      demand(limb.joint < call.map.size() && limb.leg <= 1 && limb.deep_frames <= call.frames &&
                 limb.contact_frames <= call.frames && limb.range_frames <= call.frames,
             "a limb's figures are in their range");
      if ((call.extras & kRaw) == 0)
        demand(limb.depth >= 0 && limb.depth <= limb.greatest_depth * 1.0001f && limb.error >= 0 &&
                   limb.error <= limb.greatest_error * 1.0001f,
               "means are no more than what is greatest");
    }
    return status;
  };
  const auto contacts = [&](void* block, size_t bytes, ClipResult* result) {
    const sinew_motion_clip clip = clip_of(result);
    const sinew_status ranged = sinew_retarget_keep_range(plan, &own, &clip, block, bytes);
    if (ranged != SINEW_OK) return ranged;
    check_pose(call, result->rotations, result->translations);
    const ClipResult before = *result;
    const sinew_status status = sinew_retarget_contacts(plan, source, &own, &clip, &call.contacts, block, bytes);
    if (status != SINEW_OK && status != SINEW_ERROR_CANCELLED) {
      demand(*result == before, "contacts that are refused leave the clip");
      result->rotations = copied.rotations;
      result->translations = copied.translations;
    }
    return status;
  };
  const auto points_size = [&](size_t* bytes) {
    return sinew_retarget_reference_points_workspace_size(plan, &own, bytes);
  };
  const auto points = [&](void* block, size_t bytes, ClipResult* result) {
    const sinew_motion_clip clip = clip_of(result);
    return sinew_retarget_reference_points(plan, source, &own, &clip, &call.points, block, bytes);
  };
  const ClipResult measured = on_clip(call, copied, 0xA5, contacts_size, measure);
  demand(measured == on_clip(call, copied, 0x3C, contacts_size, measure), "a second measure gives the same");
  demand(measured.rotations == copied.rotations || (call.extras & kRaw) != 0, "a measure changes nothing");
  const ClipResult kept = on_clip(call, copied, 0xA5, contacts_size, contacts);
  demand(kept.status == SINEW_ERROR_CANCELLED || kept == on_clip(call, copied, 0x3C, contacts_size, contacts),
         "contacts are the same a second time");
  const ClipResult drawn = on_clip(call, copied, 0xA5, points_size, points);
  demand(drawn.status == SINEW_ERROR_CANCELLED || drawn == on_clip(call, copied, 0x3C, points_size, points),
         "reference points give the same a second time");
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Call call{Bytes(data, size)};
  const sinew_skeleton source = call.source.view(), target = call.target.view();
  size_t need = 0;
  demand(sinew_retarget_create_workspace_size(source.joint_count, target.joint_count, &need) == SINEW_OK,
         "these counts have a size");
  const size_t bytes = (call.extras & kShort) != 0 ? need - 1 : need;
  Workspace memory(bytes, 0, 0xA5);
  sinew_retarget* plan = nullptr;
  const sinew_status made = sinew_retarget_create(&source, &target, call.map.data(), call.classes.data(), &call.options,
                                                  memory.data(), bytes, &plan);
  demand(memory.guards_hold(), "the plan is not written beyond its size");
  if (made != SINEW_OK) {
    demand(plan == nullptr, "no plan on failure");
    demand(documented(made) || (made == SINEW_ERROR_WORKSPACE && bytes < need), "a documented status of the plan");
    return 0;
  }
  demand(bytes == need, "short memory is refused");
  ClipResult copied;
  copied.rotations.assign(size_t{4} * call.frames * target.joint_count, 77);
  copied.translations.assign(size_t{3} * call.frames * target.joint_count, 77);
  std::vector<float> heights(call.frames);
  float ground = 0;
  for (uint32_t f = 0; f < call.frames; ++f) {
    const sinew_status status =
        sinew_retarget_height(plan, &call.rotations[size_t{4} * source.joint_count * f],
                              &call.translations[size_t{3} * source.joint_count * f], &heights[f]);
    demand(status == SINEW_OK || ((call.extras & kRaw) != 0 && status == SINEW_ERROR_NOT_FINITE),
           "a height, or no number");
  }
  if (sinew_retarget_ground(plan, heights.data(), heights.size(), &ground) != SINEW_OK) return 0;
  for (uint32_t f = 0; f < call.frames; ++f) {
    const sinew_status status = sinew_retarget_frame(plan, &call.rotations[size_t{4} * source.joint_count * f],
                                                     &call.translations[size_t{3} * source.joint_count * f], ground,
                                                     &copied.rotations[size_t{4} * target.joint_count * f],
                                                     &copied.translations[size_t{3} * target.joint_count * f]);
    if (status != SINEW_OK) {
      demand(documented(status) && copied.rotations[size_t{4} * target.joint_count * f] == 77, "outputs are untouched");
      return 0;
    }
  }
  check_pose(call, copied.rotations, copied.translations);
  check_clip(call, plan, copied, ground);
  return 0;
}
