// SPDX-License-Identifier: MIT
// Loose balls in front of a head's bone are eyes; the jaw follows from where they are.
#include "core/vector_math.hpp"
#include "details/details.hpp"
#include "details/given_skeleton.hpp"
#include "front/mirror_frame.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kLeastBallVertices = 8;  // of a ball
// The middle and the smallest extent of a ball's box, percent of the largest. Eyes often lack their back.
constexpr int64_t kRound = 70, kDeep = 25;
// Below this the smallest extent is that of a ball that was cut.
constexpr int64_t kWhole = 85;
// Two balls are a pair: extents this much alike, percent; beside each other, percent of their size.
constexpr int64_t kAlike = 88, kLevel = 25;
// Their distance, percent: of their size at least and at most, and of the head's bone at most.
constexpr int64_t kLeastGap = 80, kMostGap = 800, kMostOfHead = 120;
// Jaws, percent of the eyes' distance.
constexpr int64_t kJawDown = 75, kJawBack = 110;
constexpr int64_t kChinHigh = 120, kChinLow = 230, kChinWide = 30;
// How sure a position is, 0..32768: a ball's middle is measured, a jaw's is where people have it.
constexpr uint16_t kEyeConfidence = 29491, kJawConfidence = 16384;

struct FaceBall {
  Vec3i low, high, at;
  int32_t size;

  int64_t extent(int axis) const { return axis == 0 ? high.x - low.x : axis == 1 ? high.y - low.y : high.z - low.z; }
};

Vec3i halfway(Vec3i a, Vec3i b) { return {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2, a.z + (b.z - a.z) / 2}; }

uint32_t quarters_of(const GivenSkeleton& skeleton) { return skeleton.joints.facing % 4; }

FaceBall box_of(const Mesh& mesh, uint32_t part, uint32_t quarters) {
  FaceBall ball = {};
  for (uint32_t i = mesh.part_offsets[part]; i < mesh.part_offsets[part + 1]; ++i) {
    const Vec3i p = MirrorFrame::turn(mesh.positions[mesh.part_vertices[i]], quarters);
    if (i == mesh.part_offsets[part]) ball.low = ball.high = p;
    grow(p, &ball.low, &ball.high);
  }
  return ball;
}

// Fills in the middle and the size of a ball; false where the box is none's.
//   right  whether it is to the right of the head
bool make_ball(FaceBall* ball, bool right) {
  int64_t most = 0, least = INT64_MAX, sum = 0;
  int thin = 0;
  for (int axis = 2; axis >= 0; --axis) {  // of equal ones the last: eyes look forward
    const int64_t e = ball->extent(axis);
    sum += e;
    most = e > most ? e : most;
    if (e < least) {
      least = e;
      thin = axis;
    }
  }
  const int64_t middle = sum - most - least;
  if (most < 2 || middle * 100 < most * kRound || least * 100 < most * kDeep) return false;
  ball->size = static_cast<int32_t>(most);
  ball->at = halfway(ball->low, ball->high);
  if (least * 100 >= most * kWhole) return true;
  // Less than half a ball: the radius from the rim's and the height.
  const int64_t radius = 2 * least >= most ? most / 2 : (most * most / 4 + least * least) / (2 * least);
  const auto r = static_cast<int32_t>(radius);
  if (thin == 0) {
    ball->at.x = right ? ball->low.x + r : ball->high.x - r;
  } else if (thin == 1) {
    ball->at.y = ball->high.y - r;
  } else {
    ball->at.z = ball->high.z - r;
  }
  return true;
}

// The head's bone: to its only bone end, or as long again as from its parent.
Vec3i head_tip(const GivenSkeleton& s, uint32_t head) {
  const int32_t end = s.end_of(head);
  if (end >= 0) return s.at[end];
  if (s.joints.parents[head] < 0) return s.at[head];
  const Vec3i back = s.at[head] - s.at[s.joints.parents[head]];
  return s.at[head] + back;
}

bool is_below(const GivenSkeleton& s, int32_t j, uint32_t head) {
  for (; j >= 0; j = s.joints.parents[j])
    if (j == static_cast<int32_t>(head)) return true;
  return false;
}

// Returns whether the head's own bone, or one of its descendants, is nearer to p than all others.
bool belongs_to(const GivenSkeleton& s, uint32_t head, Vec3i p) {
  const auto squared = [&](Vec3i a, Vec3i b) {
    const Vec3i d = nearest_on_segment(a, b, p) - p;
    return dot(d, d);
  };
  int64_t own = squared(s.at[head], head_tip(s, head)), others = INT64_MAX;
  for (uint32_t j = 0; j < s.joints.joint_count; ++j) {
    const int32_t parent = s.joints.parents[j];
    if (parent < 0) continue;
    int64_t& least = is_below(s, parent, head) ? own : others;
    const int64_t here = squared(s.at[parent], s.at[j]);
    least = here < least ? here : least;
  }
  return own <= others;
}

// Where a head is, rotated to face +z.
struct Head {
  Vec3i base, tip;
  int64_t length = 0;  // of its bone or its parent's, the longer one
  bool upright = true;

  Head(const GivenSkeleton& s, uint32_t j) {
    const uint32_t quarters = quarters_of(s);
    base = MirrorFrame::turn(s.at[j], quarters);
    tip = MirrorFrame::turn(head_tip(s, j), quarters);
    length = static_cast<int64_t>(sinew::length(tip - base));
    if (s.joints.parents[j] < 0) return;
    const Vec3i neck = base - MirrorFrame::turn(s.at[s.joints.parents[j]], quarters);
    const auto below = static_cast<int64_t>(sinew::length(neck));
    length = below > length ? below : length;
    upright = neck.y >= abs64(neck.z);
  }
};

int64_t apart(int64_t a, int64_t b) { return abs64(a - b); }

bool is_pair(const FaceBall& left, const FaceBall& right, int64_t head_length, int32_t middle) {
  const int64_t size = left.size > right.size ? left.size : right.size, gap = left.at.x - right.at.x;
  const int64_t smaller = left.size < right.size ? left.size : right.size;
  if (smaller * 100 < size * kAlike) return false;
  if (gap * 100 < size * kLeastGap || gap * 100 > size * kMostGap || gap * 100 > head_length * kMostOfHead)
    return false;
  if (apart(left.at.y, right.at.y) * 100 > size * kLevel || apart(left.at.z, right.at.z) * 100 > size * kLevel)
    return false;
  return apart(int64_t{left.at.x} + right.at.x, int64_t{2} * middle) <= gap;
}

// The first joint of a head that has no face yet.
bool is_bare_head(const GivenSkeleton& s, uint32_t j) {
  const uint8_t* const classes = s.joints.joint_classes;
  if (classes[j] != SINEW_CLASS_HEAD || s.end[j]) return false;
  const int32_t parent = s.joints.parents[j];
  if (parent >= 0 && classes[parent] == SINEW_CLASS_HEAD) return false;
  for (uint32_t c = j + 1; c < s.joints.joint_count; ++c) {
    const bool face = classes[c] == SINEW_CLASS_EYE || classes[c] == SINEW_CLASS_JAW;
    if (face && is_below(s, static_cast<int32_t>(c), j)) return false;
  }
  return true;
}

// Balls that lie like eyes, rotated to face +z (MirrorFrame::turn), grid units.
struct Eyes {
  Vec3i at[2] = {};  // of the balls' middles: left (+x) and right
  int32_t size = 0;  // across a ball; 0: there are none
};
// The two loose parts of `mesh` that are most like the eyes of head joint `head`: round, of one size, side by side, nearest
// to the head's own bone and in front of it. A ball that lacks its back is taken for a whole one.
Eyes find_eyes(const Mesh& mesh, const GivenSkeleton& s, uint32_t head, const Head& position) {
  const uint32_t quarters = quarters_of(s);
  constexpr uint32_t kMostBalls = 32;  // near one head; others are beads
  FaceBall balls[kMostBalls];
  uint32_t count = 0;
  for (uint32_t part = 0; part < mesh.part_count && count < kMostBalls; ++part) {
    if (mesh.part_sizes[part] < kLeastBallVertices) break;  // sizes fall
    FaceBall ball = box_of(mesh, part, quarters);
    if (!make_ball(&ball, ball.low.x + ball.high.x < 2 * position.base.x)) continue;
    if (position.upright && ball.at.z < position.base.z) continue;  // behind the head
    if (!belongs_to(s, head, MirrorFrame::turn(ball.at, 4 - quarters))) continue;
    balls[count++] = ball;
  }
  Eyes eyes;
  int64_t front = INT64_MIN;
  for (uint32_t i = 0; i < count; ++i) {
    for (uint32_t k = 0; k < count; ++k) {
      const FaceBall &left = balls[i], &right = balls[k];
      if (left.at.x <= right.at.x || !is_pair(left, right, position.length, position.base.x)) continue;
      const int64_t here = int64_t{left.high.z} + right.high.z;
      if (here < front || (here == front && left.size <= eyes.size)) continue;
      front = here;
      eyes.at[0] = left.at;
      eyes.at[1] = right.at;
      eyes.size = left.size;
    }
  }
  return eyes;
}

// The pivot of the jaw, and the chin.
struct Jaw {
  Vec3i at = {}, chin = {};
  bool found = false;
};
// Below and behind the eyes by their distance, as people's are; none where the head does not stand upright or has no
// surface where a chin would be.
Jaw find_jaw(const Mesh& mesh, uint32_t quarters, const Head& position, const Eyes& eyes) {
  Jaw jaw;
  if (!position.upright) return jaw;
  const int64_t gap = eyes.at[0].x - eyes.at[1].x;
  const Vec3i middle = halfway(eyes.at[1], eyes.at[0]);
  const auto of_gap = [&](int64_t percent) { return static_cast<int32_t>(gap * percent / 100); };
  jaw.at = {middle.x, middle.y - of_gap(kJawDown), middle.z - of_gap(kJawBack)};
  // Large eyes stand far apart; a jaw is not behind the head's joint.
  jaw.at.z = jaw.at.z < position.base.z ? position.base.z : jaw.at.z;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const Vec3i p = MirrorFrame::turn(mesh.positions[v], quarters);
    if (apart(p.x, middle.x) > of_gap(kChinWide) || p.y > middle.y - of_gap(kChinHigh) ||
        p.y < middle.y - of_gap(kChinLow) || p.z <= jaw.at.z || p.z > middle.z + gap) {
      continue;
    }
    if (jaw.found && p.z <= jaw.chin.z) continue;
    jaw.found = true;
    jaw.chin = {middle.x, p.y, p.z};
  }
  return jaw;
}

struct Face {
  uint32_t head;
  Eyes eyes;
  Jaw jaw;
};

SINEW_RARE void add_face(const Face& face, const Units& units, uint32_t up_axis, sinew_rig_outputs* out) {
  if (out->joint_count + (face.jaw.found ? 4 : 2) > kMostGivenJoints) return;
  const bool mirrored = out->mirrored != 0;
  const int32_t head = static_cast<int32_t>(face.head), left = static_cast<int32_t>(out->joint_count);
  const auto add = [&](const char* name, uint8_t joint_class, Vec3i turned, PointSide side, int32_t parent,
                       int32_t partner) {
    NewJoint joint = {};
    joint.name = name;
    joint.named_after = -1;
    joint.at = MirrorFrame::turn(turned, 4 - out->facing % 4);
    joint.side = side;
    joint.parent = parent;
    joint.partner = mirrored ? partner : -1;
    joint.joint_class = joint_class;
    joint.end = parent != head;
    joint.confidence = joint_class == SINEW_CLASS_EYE ? kEyeConfidence : kJawConfidence;
    append_joint(units, up_axis, joint, out);
  };
  // In a mirrored skeleton the right eye is the left one's image.
  add("LeftEye", SINEW_CLASS_EYE, face.eyes.at[0], PointSide::kHere, head, left + 1);
  add("RightEye", SINEW_CLASS_EYE, face.eyes.at[mirrored ? 0 : 1], mirrored ? PointSide::kMirrored : PointSide::kHere,
      head, left);
  if (!face.jaw.found) return;
  const PointSide side = mirrored ? PointSide::kPlane : PointSide::kHere;
  add("Jaw", SINEW_CLASS_JAW, face.jaw.at, side, head, left + 2);
  add("Jaw_end", SINEW_CLASS_JAW, face.jaw.chin, side, left + 2, left + 3);
}

struct Faces {
  Face* found = nullptr;
  uint32_t count = 0;

  void room(Arena& arena) { found = arena.alloc<Face>(kMostGivenJoints); }
  void find(const Mesh& mesh, const GivenSkeleton& skeleton) {
    for (uint32_t j = 0; j < skeleton.joints.joint_count; ++j) {
      if (!is_bare_head(skeleton, j)) continue;
      Face face = {};
      face.head = j;
      const Head position(skeleton, j);
      face.eyes = find_eyes(mesh, skeleton, j, position);
      if (face.eyes.size == 0) continue;
      face.jaw = find_jaw(mesh, quarters_of(skeleton), position, face.eyes);
      found[count++] = face;
    }
  }
  void add(const Units& units, uint32_t up_axis, sinew_rig_outputs* outputs) const {
    for (uint32_t i = 0; i < count; ++i) add_face(found[i], units, up_axis, outputs);
  }
};

}  // namespace

sinew_status run_face(const RigPlan& plan, const sinew_mesh& mesh, Arena& arena, sinew_rig_outputs* outputs) {
  return grow_given(plan, mesh, arena, Faces(), outputs);
}

}  // namespace sinew::rigging
