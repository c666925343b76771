// SPDX-License-Identifier: MIT
// Points of the surface as rows of the network of the front.
#include "front/front_points.hpp"

#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

int16_t twice_length(int64_t value) { return feature(round_shift(value, kToQ13 - 1)); }

// The direction in which the points reach farthest, by their second moments: half the angle of (xx - zz, 2 xz).
void set_axis(int64_t xx, int64_t xz, int64_t zz, FrontView* view) {
  const Vec3l doubled = {xx - zz, 2 * xz, 0};
  const uint64_t size = length(doubled);
  view->axis_x = 1 << 14;
  view->axis_z = 0;
  view->elongation = 0;
  if (size == 0) return;
  const Vec3i unit = unit_vector(doubled, 28);
  const auto root = [](int64_t q28) {  // Q14
    return static_cast<int32_t>(round_shift(isqrt64(static_cast<uint64_t>(q28 > 0 ? q28 : 0) << 32), 16));
  };
  constexpr int64_t kOne = 1 << 28;
  view->axis_x = root((kOne + unit.x) / 2);
  view->axis_z = unit.y < 0 ? -root((kOne - unit.x) / 2) : root((kOne - unit.x) / 2);
  view->elongation = static_cast<int32_t>((static_cast<int64_t>(size) >> 14) * 8192 / (((xx + zz) >> 14) + 1));
}

}  // namespace

bool front_task(uint32_t feature_set, ModelTask* task) {
  if (feature_set != kFrontFeatureSet) return false;
  *task = ModelTask();
  task->id = kTaskRig;
  task->input_count = 1;
  task->inputs[0] = {input_name("frnt"), {Domain::kVertex, static_cast<uint16_t>(kFrontChannels)}};
  task->output = {Domain::kVertex, static_cast<uint16_t>(kFrontOutputs)};
  return true;
}

void view_points(const SurfacePoint* points, uint32_t up_axis, FrontView* view) {
  const auto turned = [&](Vec3i v) { return up_axis == 0 ? v : Vec3i{v.x, v.z, -v.y}; };
  Vec3l sum = {0, 0, 0};
  Vec3i low = turned(points[0].position), high = low;
  for (uint32_t i = 0; i < kFrontPoints; ++i) {
    const Vec3i p = turned(points[i].position);
    view->points[i] = {p, turned(points[i].normal)};
    grow(p, &low, &high);
    sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  }
  view->mean = round_div(sum, kFrontPoints);
  view->height = high.y - low.y;
  view->middle = low.y + view->height / 2;
  int64_t xx = 0, xz = 0, zz = 0;  // below 2^42 x 2^9
  for (uint32_t i = 0; i < kFrontPoints; ++i) {
    const FrontOffset d = front_offset(*view, i);
    xx += d.x * d.x;
    xz += d.x * d.z;
    zz += d.z * d.z;
  }
  view->radius = static_cast<int32_t>(isqrt64(static_cast<uint64_t>((xx + zz) / kFrontPoints)));
  set_axis(xx, xz, zz, view);
}

void front_rows(const FrontView& view, uint32_t frame, int16_t* rows) {
  const FrontOffset axis = frame_axis(view, frame);
  for (uint32_t i = 0; i < kFrontPoints; ++i) {
    int16_t* const row = rows + size_t{i} * kFrontChannels;
    const FrontPoint& point = view.points[i];
    const FrontOffset d = front_offset(view, i);
    const int64_t along = round_shift(d.x * axis.x + d.z * axis.z, 14),
                  across = round_shift(d.z * axis.x - d.x * axis.z, 14);
    const int64_t n_along = round_shift(point.normal.x * axis.x + point.normal.z * axis.z, 14),
                  n_across = round_shift(point.normal.z * axis.x - point.normal.x * axis.z, 14);
    row[kFrontHeight] = twice_length(int64_t{point.position.y} - view.middle);
    row[kFrontAlong] = twice_length(along);
    row[kFrontAcross] = twice_length(abs64(across));
    row[kFrontNormal] = feature(round_shift(point.normal.y, 1));
    row[kFrontNormal + 1] = feature(round_shift(n_along, 1));
    row[kFrontNormal + 2] = feature(round_shift(across < 0 ? -n_across : n_across, 1));
    row[kFrontRadius] = twice_length(isqrt64(static_cast<uint64_t>(d.x * d.x + d.z * d.z)));
    row[kFrontRaised] = twice_length(int64_t{point.position.y} - view.mean.y);
    row[kFrontBody] = feature(round_shift(3 * int64_t{view.radius}, kToQ13));
    row[kFrontBody + 1] = feature(round_shift(3 * int64_t{view.height}, kToQ13 + 1));
    row[kFrontBody + 2] = feature(view.elongation);
  }
}

}  // namespace sinew::rigging
