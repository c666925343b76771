// SPDX-License-Identifier: MIT
// Points to rows to answers; of mirrored meshes the answer chooses an end of the mirror plane, of others it is rounded to steps
// from the mesh's own axis, so that the same mesh in another pose is brought to the same position.
#include "front/front.hpp"

#include "core/vector_math.hpp"
#include "front/mirror_angle.hpp"
#include "front/point_rows.hpp"

namespace sinew::rigging {
namespace {

constexpr uint64_t kFrontSeed = 7;
constexpr uint32_t kFrontSets = 2;        // of points, whose answers are added up
constexpr int64_t kHeadingOne = 1 << 28;  // of a Heading
// Weight of the file's +z relative to the network's answer, whose length is about 1 if it is sure; Q15.
constexpr int64_t kKnownFront = 11469, kUsualFront = 3277;
// Logit in Q10 for y up: the logarithm of ten, because at least ten times as many files have it up as z.
constexpr int32_t kUsualUp = 2358;
constexpr int64_t kSheetUp = 3072;                // logit in Q10 that a sheet stands,
constexpr int32_t kSheetDepth = kSide * 6 / 100;  // which is no deeper than that
// Logit of an answer of length 1, Q10: for the decision, and for the confidence of a mesh without a mirror plane.
// Fitted on makers that a network trained without (trainer/configs/RESULTS.md).
constexpr int64_t kSureness = 2816, kLeaningSureness = 1549;
// Below it the answer is left to the votes.
constexpr float kClear = 0.7f;
constexpr int64_t kAxisSnap = kHeadingOne / 573;  // sine of 0.1 degrees, which is how far off a plane is found
constexpr int64_t kKnownSnap = kHeadingOne / 3;   // of 20 degrees, where the file's axes are known

struct FrontMemory {
  int16_t *features, *outputs;
  PointRows points;

  bool allocate(Arena& arena) {
    features = arena.alloc<int16_t>(size_t{kFrontPoints} * kFrontChannels);
    outputs = arena.alloc<int16_t>(size_t{kFrontPoints} * kFrontOutputs);
    if (!points.allocate(arena)) return false;
    if (!arena.measuring()) points.fill(0);
    return true;
  }
  NetworkInput input() const { return points.input(features); }
};

void add_rows(const FrontView& view, const int16_t* rows, FrontAnswer* answer) {
  int64_t x = 0, z = 0, upright = 0;  // Q30, below 2^15 x 2^24 x 2^9
  for (uint32_t i = 0; i < kFrontPoints; ++i) {
    const int16_t* const row = rows + size_t{i} * kFrontOutputs;
    const FrontOffset d = front_offset(view, i);
    const int64_t p = int64_t{row[kFrontPosition]} * kFrontPositionScale;
    const int64_t n = int64_t{row[kFrontNormalShare]} * (int64_t{kFrontNormalScale} << (kGridBits - kNormalBits));
    x += p * d.x + n * view.points[i].normal.x;
    z += p * d.z + n * view.points[i].normal.z;
    upright += row[kFrontUpright];
  }
  constexpr int kPointBits = 9, kToQ15 = 10 + kGridBits - 15;
  static_assert(1u << kPointBits == kFrontPoints, "a mean by a shift");
  answer->x += round_shift(x, kToQ15 + kPointBits);
  answer->z += round_shift(z, kToQ15 + kPointBits);
  answer->upright += static_cast<int32_t>(round_shift(upright, kPointBits));
}

int64_t dot(Heading a, Heading b) { return round_shift(a.x * b.x + a.z * b.z, 28); }

// 1 / (1 + e^-x) of x in Q10, as a float of Q15.
float likelihood(int64_t x) {
  constexpr int64_t kLog2E = 94548;                                // Q16
  const int64_t power = exp2_negative((abs64(x) * kLog2E) >> 10);  // Q30
  const int64_t small = (power << 15) / ((int64_t{1} << 30) + power);
  return static_cast<float>(x >= 0 ? (1 << 15) - small : small) / 32768.0f;
}

// The nearest of 24 directions, counted from the axis.
Heading nearest_step(Heading axis, Heading wanted) {
  constexpr int64_t kSteps[7][2] = {{268435456, 0},         {259288736, 69476207},  {232471924, 134217728},
                                    {189812531, 189812531}, {134217728, 232471924}, {69476207, 259288736},
                                    {0, 268435456}};
  Heading best = axis;
  int64_t most = INT64_MIN;
  for (uint32_t k = 0; k < 24; ++k) {
    int64_t c = kSteps[k % 6][0], s = kSteps[k % 6][1];
    for (uint32_t quarter = 0; quarter < k / 6; ++quarter) {
      const int64_t t = c;
      c = -s;
      s = t;
    }
    const Heading at = {round_shift(axis.x * c - axis.z * s, 28), round_shift(axis.x * s + axis.z * c, 28)};
    if (dot(at, wanted) <= most) continue;
    most = dot(at, wanted);
    best = at;
  }
  return best;
}

Heading snapped(Heading h) {
  if (abs64(h.x) < kAxisSnap) return {0, h.z < 0 ? -kHeadingOne : kHeadingOne};
  if (abs64(h.z) < kAxisSnap) return {h.x < 0 ? -kHeadingOne : kHeadingOne, 0};
  return h;
}

sinew_status place_front(const FrontQuestion& question, const Mesh& mesh, uint32_t grid_up, FrontAnswer answer,
                         Arena& arena, Front* front) {
  answer.z += question.axes_known ? kKnownFront : kUsualFront;
  Heading wanted = unit_heading(answer.x, answer.z);
  if (wanted.x == 0 && wanted.z == 0) wanted = {0, kHeadingOne};
  Heading normal = {kHeadingOne, 0};
  bool mirrored = false;
  if (!find_mirror_angle(mesh, grid_up, wanted, arena, &normal, &mirrored)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  Heading found = {-normal.z, normal.x};
  if (mirrored) {
    if (dot(found, wanted) < 0) found = {-found.x, -found.z};
    found = snapped(found);
  } else if (question.axes_known && wanted.z > 0 && abs64(wanted.x) < kKnownSnap) {
    found = {0, kHeadingOne};
  } else {
    found = snapped(nearest_step(surface_axis(mesh, grid_up).along, wanted));
  }
  front->turn.sine = to_float(static_cast<double>(found.x) / kHeadingOne);
  front->turn.cosine = to_float(static_cast<double>(found.z) / kHeadingOne);
  const int64_t reach = round_shift(answer.x * found.x + answer.z * found.z, 28);
  front->confidence = front_likelihood(reach, mirrored);
  front->clear = front_likelihood(reach, true) >= kClear;
  return SINEW_OK;
}

}  // namespace

float front_likelihood(int64_t reach, bool mirrored) {
  return likelihood((reach * (mirrored ? kSureness : kLeaningSureness)) >> 15);
}

sinew_status ask_front(const sinew_model& model, const NetworkOptions& options, const Kernels& kernels,
                       const SurfacePoint* points, uint32_t up_axis, Arena& arena, FrontAnswer* answer) {
  const ArenaScope scope(arena);
  FrontView view;
  FrontMemory rows;
  (void)view.allocate(arena);
  if (!rows.allocate(arena)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return run_network(model, rows.input(), kernels, Progress(), arena, rows.outputs, options);
  view_points(points, up_axis, &view);
  *answer = FrontAnswer();
  for (uint32_t frame = 0; frame < kFrontFrames; ++frame) {
    front_rows(view, frame, rows.features);
    const sinew_status status = run_network(model, rows.input(), kernels, Progress(), arena, rows.outputs, options);
    if (status != SINEW_OK) return status;
    add_rows(view, rows.outputs, answer);
  }
  constexpr int kFrameBits = 2;
  static_assert(1u << kFrameBits == kFrontFrames, "a mean by a shift");
  answer->x = round_shift(answer->x, kFrameBits);
  answer->z = round_shift(answer->z, kFrameBits);
  answer->upright = static_cast<int32_t>(round_shift(answer->upright, kFrameBits));
  return SINEW_OK;
}

// A sheet, a puppet or a picture, stands: less than 0 where it is thin along z, so that y is up, more than 0 where it is thin along y,
// 0 where it is no sheet.
static int32_t standing_sheet(const Mesh& mesh) {
  Vec3i low = mesh.positions[0], high = low;
  for (uint32_t i = 1; i < mesh.welded_count; ++i) {
    const Vec3i p = mesh.positions[i];
    low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
    high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y, p.z > high.z ? p.z : high.z};
  }
  const bool thin_y = high.y - low.y < kSheetDepth, thin_z = high.z - low.z < kSheetDepth;
  return thin_y == thin_z ? 0 : thin_z ? -1 : 1;
}

sinew_status find_front(const FrontQuestion& question, const Kernels& kernels, const Mesh& mesh, Arena& arena,
                        Front* front) {
  const ArenaScope scope(arena);
  SurfacePoint* const points = arena.alloc<SurfacePoint>(kFrontPoints);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  FrontAnswer answers[2];
  const uint32_t candidates = question.find_up ? 2 : 1;
  for (uint32_t set = 0; set < kFrontSets; ++set) {
    if (!arena.measuring()) spread_points(mesh, kFrontPoints, kFrontSeed + set, points);
    for (uint32_t up = 0; up < candidates; ++up) {
      FrontAnswer answer;
      const sinew_status status = ask_front(*question.model, question.network, kernels, points, up, arena, &answer);
      if (status != SINEW_OK) return status;
      answers[up].x += answer.x / kFrontSets;
      answers[up].z += answer.z / kFrontSets;
      answers[up].upright += answer.upright / static_cast<int32_t>(kFrontSets);
    }
  }
  // The grid has the caller's up axis at y already where that is known.
  uint32_t grid_up = 0;
  *front = Front();
  front->turn.up_axis = question.up_axis;
  if (question.find_up) {
    const int32_t sheet = arena.measuring() ? 0 : standing_sheet(mesh);
    const int64_t by = sheet != 0 ? sheet * kSheetUp : int64_t{answers[1].upright} - answers[0].upright - kUsualUp;
    grid_up = by > 0 ? 1 : 0;
    front->turn.up_axis = grid_up;
    front->up_confidence = likelihood(abs64(by));
  }
  return place_front(question, mesh, grid_up, answers[grid_up], arena, front);
}

}  // namespace sinew::rigging
