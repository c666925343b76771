// SPDX-License-Identifier: MIT
// Checks one layer of a list: regions, shapes, order of writing and reading.
#include "model/layer_list.hpp"

#include "core/build.hpp"
#include "model/regions.hpp"

namespace sinew {
namespace {

// Whether a layer of this kind may read `in_channels` of an `in` buffer and write `out_channels` of an `out` buffer.
bool shape_fits(LayerKind kind, Domain in, Domain out, uint32_t in_channels, uint32_t out_channels,
                uint32_t candidates) {
  switch (traits_of(kind).shape) {
    case LayerShape::kWeights:
      return in == out;
    case LayerShape::kSame:
      return in == out && in_channels == out_channels;
    case LayerShape::kSameSlots:
      return has_slots(in) && in == out && in_channels == out_channels;
    case LayerShape::kToSlots:
      return !has_slots(in) && out == with_slots(in) && in_channels == out_channels;
    case LayerShape::kJoinSlots:
      return has_slots(in) && out == without_slots(in) && in_channels * candidates == out_channels;
    case LayerShape::kSplitSlots:
      return !has_slots(in) && out == with_slots(in) && in_channels == out_channels * candidates;
  }
  return false;
}

bool inside(const LayerList& list, const Region& region) {
  return region.buffer < list.buffer_count && region.channels > 0 &&
         region_end(region) <= list.buffers[region.buffer].channels;
}

// All channels of the region are inputs or were written by a layer before `before`.
bool written(const LayerList& list, uint32_t before, const Region& region) {
  for (uint32_t channel = region.offset; channel < region_end(region);) {
    const Segment segment = segment_at(list.layers, list.input_count, before, region, channel);
    if (segment.producer == kNotWritten) return false;
    channel += segment.count;
  }
  return true;
}

}  // namespace

LayerFault find_layer_fault(const LayerList& list, uint32_t index) {
  const Layer& layer = list.layers[index];
  if (!inside(list, layer.in) || !inside(list, layer.out)) return LayerFault::kRegion;
  const Domain in = list.buffers[layer.in.buffer].domain, out = list.buffers[layer.out.buffer].domain;
  if (!is_layer_kind(layer.kind) ||
      !shape_fits(layer.kind, in, out, layer.in.channels, layer.out.channels, list.candidates))
    return LayerFault::kShape;
  uint32_t known = traits_of(layer.kind).flags;
  if (kSmallCode || !list.far_neighbors || has_slots(in)) known &= ~static_cast<uint32_t>(kLayerFar);
  if ((layer.flags & ~known) != 0) return LayerFault::kFlags;
  if (layer.out.buffer < list.input_count) return LayerFault::kOverwrite;
  for (uint32_t i = 0; i < index; ++i) {
    if (regions_overlap(list.layers[i].out, layer.out)) return LayerFault::kOverwrite;
  }
  if (!written(list, index, layer.in)) return LayerFault::kUnwritten;
  if ((layer.flags & kLayerResidual) != 0 &&
      (!inside(list, layer.residual) || layer.residual.channels != layer.out.channels ||
       list.buffers[layer.residual.buffer].domain != out || !written(list, index, layer.residual))) {
    return LayerFault::kResidual;
  }
  return LayerFault::kNone;
}

bool writes_output(const LayerList& list, uint32_t index, const Buffer& output) {
  const Region& out = list.layers[index].out;
  return list.buffers[out.buffer].domain == output.domain && out.channels == output.channels;
}

}  // namespace sinew
