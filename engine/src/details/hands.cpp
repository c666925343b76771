// SPDX-License-Identifier: MIT
// Skeleton to hands, each to crop, points, votes, fingers, and back to the caller's units.
#include "core/vector_math.hpp"
#include "details/details.hpp"
#include "details/fingers.hpp"
#include "details/given_skeleton.hpp"
#include "details/hand_crop.hpp"
#include "votes/point_voter.hpp"
#include "votes/read_votes.hpp"

namespace sinew::rigging {
namespace {

// Sets of points of a hand, each a run of the network.
constexpr uint32_t kHandSets = 4;

constexpr uint32_t kMostJoints = kMostGivenJoints;
constexpr int16_t kNoMirror = -1;
// A hand's length: this share of the distance to its bone's end, percent, or of the forearm; never beyond these
// shares of it.
constexpr int64_t kOfEnd = 118, kOfForearm = 75, kLeastOfForearm = 30, kMostOfForearm = 200;

constexpr char kFingerNames[kFingers][8] = {"Thumb", "Index", "Middle", "Ring", "Pinky"};

// A skeleton that has hands.
struct Body : GivenSkeleton {
  explicit Body(const sinew_rig_outputs& outputs) : GivenSkeleton(outputs) {}
  bool is_hand(uint32_t j) const {
    return !end[j] && joints.joint_classes[j] == SINEW_CLASS_HAND && joints.parents[j] >= 0 && joints_below[j] == 0;
  }
  // Which side the limb is on, by where it leaves the body.
  bool is_right(uint32_t j, uint32_t quarters) const {
    uint32_t top = j;
    for (int32_t above = joints.parents[j]; above > 0; above = joints.parents[above]) {
      const uint8_t c = joints.joint_classes[above];
      if (c >= SINEW_CLASS_CLAVICLE && c <= SINEW_CLASS_HAND) top = static_cast<uint32_t>(above);
    }
    return MirrorFrame::turn(at[top] - at[0], quarters).x < 0;
  }
  SINEW_RARE HandPosition position(uint32_t j) const {
    HandPosition position;
    position.wrist = at[j];
    position.elbow = at[joints.parents[j]];
    position.quarters = joints.facing % 4;
    position.right = is_right(j, position.quarters);
    const int64_t forearm = static_cast<int64_t>(length(position.wrist - position.elbow));
    const int32_t e = end_of(j);
    int64_t size = e >= 0 ? static_cast<int64_t>(length(at[e] - at[j])) * kOfEnd : forearm * kOfForearm;
    if (size < forearm * kLeastOfForearm) size = forearm * kLeastOfForearm;
    if (size > forearm * kMostOfForearm) size = forearm * kMostOfForearm;
    position.length = clamp32(size / 100, 1, kSide);
    return position;
  }
};

struct FoundHand {
  uint16_t hand;
  int16_t mirror;            // the hand that gets the same ones mirrored, or -1
  Finger fingers[kFingers];  // grid units of the mesh

  uint32_t joints() const {
    uint32_t count = 0;
    for (const Finger& finger : fingers) count += finger.joints + (finger.has_end ? 1u : 0u);
    return count;
  }
};

struct HandVoter {
  const RigPlan& plan;
  const Kernels& kernels;
  HandCrop crop = {};
  PointVoter voter = {};

  bool allocate(Arena& arena) {
    (void)crop.allocate(arena, plan.counts);
    return voter.allocate(arena);
  }

  // The fingers of one hand, none of them where there is no surface.
  sinew_status run(const Mesh& mesh, const HandPosition& position, const Progress& progress, Arena& arena,
                   Finger (&fingers)[kFingers]) {
    const ArenaScope scope(arena);
    VoteStore store;
    if (!store.allocate(arena, kHandSets)) return SINEW_ERROR_WORKSPACE;
    if (!crop_hand(mesh, position, plan.counts, arena, &crop)) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring() && crop.surface_triangles == 0) {
      for (Finger& finger : fingers) finger = Finger();
      return SINEW_OK;
    }
    if (!build_interior(crop.mesh, arena, &voter.interior)) return SINEW_ERROR_WORKSPACE;
    for (uint32_t i = 0; i < kHandSets; ++i) {
      const Progress part = progress.part(i * Progress::kWhole / kHandSets, (i + 1) * Progress::kWhole / kHandSets);
      const sinew_status status = voter.run(plan.model, plan.network, kernels, crop.mesh, i, part, arena);
      if (status != SINEW_OK) return status;
      if (!arena.measuring()) store.add(voter.set, voter.outputs, true);
    }
    Votes votes;
    if (!arena.measuring()) votes = store.votes(false);
    votes.points = kHandSets * kSetPoints;
    VotePool pool;
    if (!pool.build(votes, false, arena)) return SINEW_ERROR_WORKSPACE;
    const sinew_status status = find_fingers(pool, arena, fingers);
    if (status != SINEW_OK || arena.measuring()) return status;
    for (Finger& finger : fingers) {
      for (uint32_t k = 0; k <= kFingerJoints; ++k) finger.at[k] = crop.frame.from(finger.at[k]);
    }
    return SINEW_OK;
  }
};

// Appends fingers to the caller's joints; the first one replaces the hand's bone end.
class Writer {
 public:
  Writer(const Body& body, const Units& units, uint32_t up_axis, sinew_rig_outputs* outputs)
      : body_(body), units_(units), up_axis_(up_axis), out_(*outputs) {}

  SINEW_RARE void add(const FoundHand& found) {
    const uint32_t hands = found.mirror >= 0 ? 2 : 1;
    if (out_.joint_count + hands * found.joints() > kMostJoints || found.joints() == 0) return;
    int32_t numbers[2][kFingers][kFingerJoints + 1];
    for (uint32_t side = 0; side < hands; ++side) {
      const uint32_t hand = side == 0 ? found.hand : static_cast<uint32_t>(found.mirror);
      int32_t free = body_.end_of(hand);
      for (uint32_t f = 0; f < kFingers; ++f) {
        const Finger& finger = found.fingers[f];
        int32_t parent = static_cast<int32_t>(hand);
        for (uint32_t k = 0; k < finger.joints + (finger.has_end ? 1u : 0u); ++k) {
          const int32_t j = free >= 0 ? free : static_cast<int32_t>(out_.joint_count++);
          free = -1;
          put(finger, f, k, hand, parent, side == 1, static_cast<uint32_t>(j));
          numbers[side][f][k] = parent = j;
        }
      }
    }
    if (out_.partners == nullptr) return;
    for (uint32_t f = 0; f < kFingers; ++f) {
      for (uint32_t k = 0; k < found.fingers[f].joints + (found.fingers[f].has_end ? 1u : 0u); ++k) {
        out_.partners[numbers[0][f][k]] = hands == 2 ? numbers[1][f][k] : kNoMirror;
        if (hands == 2) out_.partners[numbers[1][f][k]] = numbers[0][f][k];
      }
    }
  }

 private:
  void put(const Finger& finger, uint32_t f, uint32_t k, uint32_t hand, int32_t parent, bool mirrored, uint32_t j) {
    const bool is_end = k == finger.joints;
    place_point(units_, up_axis_, out_, finger.at[k], mirrored ? PointSide::kMirrored : PointSide::kHere,
                out_.positions + size_t{3} * j);
    out_.parents[j] = parent;
    if (out_.flags != nullptr) out_.flags[j] = is_end ? SINEW_JOINT_NEVER : 0;
    out_.joint_classes[j] = static_cast<uint8_t>(SINEW_CLASS_THUMB + f);
    if (out_.confidence != nullptr) out_.confidence[j] = finger.confidence[k];
    if (out_.parent_confidence != nullptr) out_.parent_confidence[j] = finger.confidence[k > 0 ? k - 1 : 0];
    if (out_.names != nullptr) name(hand, f, k, is_end, out_.names[j]);
  }

  // LeftHandThumb1, LeftHandThumb3_end: the hand's name, cut where there is no room.
  void name(uint32_t hand, uint32_t f, uint32_t k, bool is_end, char* to) const {
    constexpr uint32_t kRoom = SINEW_JOINT_NAME_BYTES - 1, kLongest = 11;  // Middle3_end
    uint32_t at = 0;
    for (const char* from = out_.names[hand]; at < kRoom - kLongest && from[at] != 0; ++at) to[at] = from[at];
    for (const char* from = kFingerNames[f]; *from != 0; ++from) to[at++] = *from;
    to[at++] = static_cast<char>('1' + (is_end ? k - 1 : k));
    for (const char* from = is_end ? "_end" : ""; *from != 0; ++from) to[at++] = *from;
    to[at] = 0;
  }

  const Body& body_;
  const Units& units_;
  const uint32_t up_axis_;
  sinew_rig_outputs& out_;
};

}  // namespace

sinew_status run_hands(const RigPlan& plan, const sinew_mesh& mesh_input, const Kernels& kernels, Arena& arena,
                       sinew_rig_outputs* outputs) {
  Mesh mesh;
  HandVoter voter = {plan, kernels};
  (void)mesh.allocate(arena, plan.counts);
  (void)voter.allocate(arena);
  FoundHand* const found = arena.alloc<FoundHand>(kMostJoints);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) {
    const sinew_status status = build_mesh(mesh_input, GridQuantizer(), plan.counts, arena, &mesh);
    Finger fingers[kFingers];
    return status == SINEW_OK ? voter.run(mesh, {}, {}, arena, fingers) : status;
  }
  Body body(*outputs);
  sinew_status status = read_given(mesh_input, plan.up_axis, plan.counts, arena, &mesh, &body);
  if (status != SINEW_OK) return status;
  uint32_t hands = 0, count = 0;
  const uint32_t joints = outputs->joint_count;
  // In a mirrored pair the left one counts for both.
  const auto is_asked = [&](uint32_t j) {
    if (!body.is_hand(j)) return false;
    const int32_t other = body.partner(j);
    if (other < 0 || other == static_cast<int32_t>(j)) return true;
    return !body.is_right(j, outputs->facing % 4) || !body.is_hand(static_cast<uint32_t>(other)) ||
           body.partner(static_cast<uint32_t>(other)) != static_cast<int32_t>(j);
  };
  for (uint32_t j = 0; j < joints; ++j) hands += is_asked(j) ? 1 : 0;
  for (uint32_t j = 0; j < joints; ++j) {
    if (!is_asked(j)) continue;
    FoundHand& one = found[count];
    one.hand = static_cast<uint16_t>(j);
    one.mirror = kNoMirror;
    const int32_t other = body.partner(j);
    if (other >= 0 && other != static_cast<int32_t>(j) && body.is_hand(static_cast<uint32_t>(other)) &&
        !is_asked(static_cast<uint32_t>(other))) {
      one.mirror = static_cast<int16_t>(other);
    }
    const Progress part = plan.progress.part(count * Progress::kWhole / hands, (count + 1) * Progress::kWhole / hands);
    status = voter.run(mesh, body.position(j), part, arena, one.fingers);
    if (status != SINEW_OK) return status;
    ++count;
  }
  const Units units(mesh_input, plan.up_axis);
  Writer writer(body, units, plan.up_axis, outputs);
  for (uint32_t i = 0; i < count; ++i) writer.add(found[i]);
  outputs->used_bytes = arena.high_water();
  return SINEW_OK;
}

}  // namespace sinew::rigging
