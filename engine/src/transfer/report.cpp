// SPDX-License-Identifier: MIT
// Finishes the rows and tells of the parts.
#include "transfer/report.hpp"

#include "weights/influences.hpp"

namespace sinew::transferring {
namespace {

uint32_t to_q16(double v) { return static_cast<uint32_t>(clamped(v, 0, 65535) * kWholeRow + 0.5); }

// A carried row is as wrong as the match is off, a bound one as the style differs from a bind: L1 of 2 is all wrong.
uint8_t confidence_of(const TransferOutcome& r, uint32_t v) {
  constexpr double kLost = 0.1;  // distance at which a match says nothing
  double sure = 1;
  if (r.plan.method == SINEW_TRANSFER_AUTO) {
    const double carried = r.balance.carried[v];
    sure = 1 - 0.5 * (carried * r.balance.mismatch[v] + (1 - carried) * r.balance.style[v]);
  } else if (r.plan.method == SINEW_TRANSFER_NEAREST) {
    const MatchedPoint& p = r.match.points[v];
    sure = (1 - clamped(p.distance / kLost, 0, 1)) * clamped(p.cosine, 0, 1);
  } else {
    uint32_t largest = 0;
    for (uint32_t i = 0; i < kRowSlots; ++i)
      largest = r.rows.weights_of(v)[i] > largest ? r.rows.weights_of(v)[i] : largest;
    sure = static_cast<double>(largest) / kWholeRow;
  }
  return static_cast<uint8_t>(clamped(sure, 0, 1) * 255 + 0.5);
}

uint32_t reason_of(const TransferOutcome& r, const PartReport::Sums& part) {
  if (part.locked == part.vertices) return SINEW_TRANSFER_KEPT;
  if (r.plan.method != SINEW_TRANSFER_AUTO) return SINEW_TRANSFER_ASKED;
  const bool carried = 2 * part.carried >= part.welded;
  if (r.plan.garment) return carried ? SINEW_TRANSFER_NEAR : SINEW_TRANSFER_FAR;
  if (carried) return SINEW_TRANSFER_STYLE;
  if (part.matched == 0) return SINEW_TRANSFER_NO_MATCH;
  // The style may be larger in this part: what holds for the whole decides then.
  return part.mismatch > 0.1 * part.welded ? SINEW_TRANSFER_MISMATCH : SINEW_TRANSFER_PLAIN;
}

void write_rows(const TransferOutcome& r, sinew_transfer_outputs* outputs) {
  const uint32_t n = r.plan.influence_count;
  const uint32_t total = r.plan.weight_format == SINEW_WEIGHT_UNORM8 ? 255u : 65535u;
  for (uint32_t v = 0; v < r.pair.target.vertex_count; ++v) {
    if (outputs->vertex_parts != nullptr)
      outputs->vertex_parts[v] = r.pair.target.part[r.pair.target.vertex_to_welded[v]];
    if (r.plan.locked != nullptr && r.plan.locked[v] != 0) {
      if (outputs->confidence != nullptr) outputs->confidence[v] = 255;
      continue;
    }
    const uint32_t welded = r.pair.target.vertex_to_welded[v];
    const size_t first = static_cast<size_t>(v) * n;
    uint16_t row[SINEW_MAX_INFLUENCES];
    keep_largest(r.rows.joints_of(welded), r.rows.weights_of(welded), kRowSlots, n, total,
                 outputs->joint_indices + first, row);
    store_weights(row, n, r.plan.weight_format, first, outputs->weights);
    if (outputs->confidence != nullptr) outputs->confidence[v] = confidence_of(r, welded);
  }
}

}  // namespace

void write_transfer(const TransferOutcome& r, const PartReport& report, sinew_transfer_outputs* outputs) {
  write_rows(r, outputs);
  const Mesh& mesh = r.pair.target;
  for (uint32_t p = 0; p < mesh.part_count; ++p) report.parts[p] = {};
  for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
    PartReport::Sums& part = report.parts[mesh.part[mesh.vertex_to_welded[v]]];
    if (part.vertices++ == 0) part.first = v;
    part.locked += r.plan.locked != nullptr && r.plan.locked[v] != 0 ? 1 : 0;
  }
  double carried = 0, style = 0, mismatch = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    PartReport::Sums& part = report.parts[mesh.part[v]];
    ++part.welded;
    part.matched += r.balance.matched[v];
    part.carried += r.balance.carried[v];
    part.style += r.balance.style[v];
    part.mismatch += r.balance.mismatch[v];
    part.distance += r.plan.matches() ? r.match.points[v].distance : 0;
    carried += r.balance.carried[v];
    style += r.balance.style[v];
    mismatch += r.balance.mismatch[v];
  }
  outputs->part_count = mesh.part_count;
  for (uint32_t p = 0; p < mesh.part_count && p < outputs->part_capacity && outputs->parts != nullptr; ++p) {
    const PartReport::Sums& part = report.parts[p];
    const double share = 1.0 / part.welded;
    outputs->parts[p] = {part.first,
                         part.vertices,
                         reason_of(r, part),
                         to_q16(share * part.carried),
                         to_q16(share * part.style),
                         to_q16(share * part.mismatch),
                         to_q16(share * part.distance),
                         0};
  }
  const double share = 1.0 / mesh.welded_count;
  outputs->carried_q16 = to_q16(share * carried);
  outputs->style_q16 = to_q16(share * style);
  outputs->mismatch_q16 = to_q16(share * mismatch);
  outputs->bound_by = r.bound_by;
  outputs->reference_count = r.reference_count;
}

}  // namespace sinew::transferring
