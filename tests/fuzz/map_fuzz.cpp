// SPDX-License-Identifier: MIT
// Fuzz target: the size query and sinew_map() on arbitrary rigs, names, ends, pins and options. Refusals are those that the
// header documents; maps obey its rules; a second run with another content of the workspace gives the same bytes.
#include <algorithm>
#include <set>

#include "bind_checks.hpp"
#include "fuzz.hpp"
#include "mesh_input.hpp"
#include "skeleton_of.hpp"

namespace {

using namespace sinew::test;

const char* const kNames[] = {"Hips",      "Spine_01", "neck", "Head",      "hand.L",
                              "LeftUpLeg", "IndexR 1", "Tail", "mixa:Arm.R"};

struct RigInput : SkeletonInput {
  std::vector<std::string> names;
  std::vector<const char*> texts;
  std::vector<uint8_t> ends;
  sinew_skeleton rig = SINEW_INIT(sinew_skeleton);

  void read(Bytes& in, uint8_t shape, uint8_t extras) {
    const uint32_t joints = in.below(48);
    read_joints(in, shape, joints);
    rig = sinew_test::skeleton_of(joint_positions.data(), parents.data(), joints);
    for (uint32_t j = 0; j < joints; ++j) {
      const uint8_t name = in.u8();
      names.push_back(name < 9 ? kNames[name] : std::string(1 + name % 3, static_cast<char>(name)));
      ends.push_back(in.u8() % 8 == 0 ? 1 : 0);
    }
    for (const std::string& name : names) texts.push_back(name.c_str());
    if ((shape & 8) != 0) rig.names = texts.data();
    if ((shape & 16) != 0) rig.ends = ends.data();
    if ((shape & 32) != 0) rig.up = in.below(5);
    if ((extras & 1) != 0 && in.below(32) == 31) rig.struct_size -= 4;
  }
};

struct Map {
  sinew_status status = SINEW_OK;
  std::vector<int32_t> sources;
  std::vector<uint16_t> confidence;
  std::vector<uint8_t> reasons;
  sinew_map_outputs outputs = {};
  bool operator==(const Map& o) const {
    return status == o.status && sources == o.sources && confidence == o.confidence && reasons == o.reasons &&
           outputs.mapped == o.outputs.mapped && outputs.certainty == o.outputs.certainty;
  }
};

struct Call : Hindrance {
  RigInput target, source;
  std::vector<sinew_map_pin> pins;
  sinew_map_options options = SINEW_INIT(sinew_map_options);

  explicit Call(Bytes in) {
    const uint8_t shape = in.u8(), extras = in.u8();
    if ((extras & 1) != 0) {
      options.method = in.below(4);
      options.reserved = in.below(32) == 31 ? 1 : 0;
    }
    read_hindrance(in, extras & 0x7F);  // nothing to cancel
    for (uint32_t n = (extras & 2) != 0 ? in.below(5) : 0; n > 0; --n)
      pins.push_back({in.below(50), static_cast<int32_t>(in.below(50)) - 1});
    options.pins = pins.data();
    options.pin_count = static_cast<uint32_t>(pins.size());
    target.read(in, shape, extras);
    source.read(in, shape, extras);
  }

  Map run(size_t need, uint8_t fill) const {
    Map map;
    map.sources.assign(target.rig.joint_count + 1, -77);
    map.confidence.assign(target.rig.joint_count + 1, 77);
    map.reasons.assign(target.rig.joint_count + 1, 77);
    const Map before = map;
    map.outputs = SINEW_INIT(sinew_map_outputs);
    map.outputs.sources = map.sources.data();
    map.outputs.confidence = map.confidence.data();
    map.outputs.reasons = map.reasons.data();
    const size_t bytes = given(need);
    Workspace workspace(bytes, misaligned, fill);
    map.status = sinew_map(&target.rig, &source.rig, &options, workspace.data(), bytes, &map.outputs);
    demand(workspace.guards_hold(), "the workspace is not written beyond its size");
    if (map.status == SINEW_OK) {
      demand(map.outputs.used_bytes <= bytes, "not more of the workspace is used than there is");
    } else {
      demand(map.sources == before.sources && map.confidence == before.confidence && map.reasons == before.reasons &&
                 map.outputs.used_bytes == 0 && map.outputs.mapped == 0,
             "outputs are untouched on failure");
    }
    return map;
  }
};

void check_status(const Call& call, sinew_status status) {
  if (call.explains(status)) return;
  if (status == SINEW_ERROR_NOT_FINITE)
    return demand(any_not_finite(call.target.joint_positions) || any_not_finite(call.source.joint_positions),
                  "NOT_FINITE is about a position");
  if (status == SINEW_ERROR_RANGE) return demand(!call.pins.empty(), "RANGE is about a pin");
  demand(status == SINEW_ERROR_ARGUMENT || status == SINEW_ERROR_VERSION || status == SINEW_ERROR_COUNT ||
             status == SINEW_ERROR_INDEX || status == SINEW_ERROR_HIERARCHY,
         std::string("a documented status: ") + sinew_status_text(status));
}

void check_map(const Call& call, const Map& map) {
  const sinew_skeleton& target = call.target.rig;
  const auto is_below = [&](int32_t joint, int32_t above) {
    for (int32_t up = call.source.parents[static_cast<size_t>(joint)]; up >= 0;
         up = call.source.parents[static_cast<size_t>(up)])
      if (up == above) return true;
    return false;
  };
  std::set<int32_t> used;
  uint32_t mapped = 0;
  for (uint32_t j = 0; j < target.joint_count; ++j) {
    const int32_t s = map.sources[j];
    demand(s >= -1 && s < static_cast<int32_t>(call.source.rig.joint_count), "a source is a joint or none");
    demand(map.confidence[j] <= 32768 && (s >= 0 || map.confidence[j] == 0),
           "confidence is a share, 0 without a source");
    demand(map.reasons[j] <= SINEW_MAP_BESIDE_LIMITS, "a reason that is documented");
    if (map.reasons[j] != SINEW_MAP_PINNED)
      demand((s >= 0) == (map.reasons[j] == SINEW_MAP_FOUND), "a reason why there is none");
    if (s < 0) continue;
    ++mapped;
    if (map.outputs.method != SINEW_MAP_SINEW || !call.pins.empty()) continue;
    demand(used.insert(s).second, "a source once");
    for (int32_t up = target.parents[j]; up >= 0; up = target.parents[up]) {
      const int32_t above = map.sources[static_cast<size_t>(up)];
      demand(above < 0 || !is_below(above, s), "no two ways cross");
    }
  }
  demand(mapped == map.outputs.mapped, "the count of the mapped is right");
  for (const sinew_map_pin& pin : call.pins) demand(map.sources[pin.target] == pin.source, "pins are kept");
  demand(map.sources.back() == -77 && map.confidence.back() == 77 && map.reasons.back() == 77,
         "nothing behind the last joint is written");
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const Call call{Bytes(data, size)};
  size_t need = 1;
  const sinew_status sized = sinew_map_workspace_size(call.target.rig.joint_count, call.source.rig.joint_count, &need);
  if (sized != SINEW_OK) {
    demand(need == 0 && sized == SINEW_ERROR_COUNT, "only counts have no size");
    demand(call.run(size_t{1} << 16, 0xA5).status != SINEW_OK, "what has no size gets no map");
    return 0;
  }
  const Map first = call.run(need, 0xA5);
  if (first.status != SINEW_OK) return check_status(call, first.status), 0;
  check_map(call, first);
  demand(call.run(need, 0x3C) == first, "a second run gives the same");
  return 0;
}
