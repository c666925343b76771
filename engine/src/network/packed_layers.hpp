// SPDX-License-Identifier: MIT
// Data of a network's linear layers for vector kernels: their packed parameters, which columns are the same in
// many rows, and which rows no layer reads.
#ifndef SINEW_NETWORK_PACKED_LAYERS_HPP
#define SINEW_NETWORK_PACKED_LAYERS_HPP

#include "core/arena.hpp"
#include "kernels/kernels.hpp"
#include "model/layout.hpp"
#include "network/network.hpp"
#include "network/plan.hpp"

namespace sinew {

// Bytes of the model's weights as vector kernels read them (a multiple of 64; 0 in builds without such kernels), and
// the weights themselves, for sinew_model::packed.
size_t packed_bytes(const sinew_model& model);
void pack_model(const sinew_model& model, uint8_t* memory);

// A linear layer's parameters in the model's bytes.
LinearView make_linear_view(const ModelTables& tables, const Layer& layer);

// Whether memory is asked for packed weights. Does not look at the processor, so that the size query is the same
// everywhere; a processor whose kernels do not want them leaves the memory unused.
bool wants_packed(const NetworkOptions& options);

// The columns of a linear layer over pairs, in three kinds. A row is one pair: a slot of a vertex.
//   own       Columns with values of the row's own. They are multiplied for every row.
//   shared    Columns with the same values in all slots of a vertex, because a layer handed the vertex' value or the
//             slots' maximum to all of them. They are multiplied once per vertex, and the vertex' rows start from the
//             sum.
//   by_joint  Columns with the same values in all pairs of a joint in the part, because the layer `part_mean` wrote
//             them. They are multiplied once per joint and part, and the joint's rows start from that sum as well.
// The total of a row is the same integer as without: sums of int32 may be added in any order.
struct SharedColumns {
  ColumnRange own[kMaxRanges], shared[kMaxRanges - 1];
  ColumnRange by_joint;
  uint8_t own_count = 0, shared_count = 0;
  uint16_t part_mean = 0;  // layer index; valid with by_joint.count > 0
  // Whether anything is shared. If not, every row is multiplied as a whole.
  bool any() const { return shared_count + by_joint.count > 0; }
};

// Sorts the columns of layer `index` into the three kinds. Nothing is shared in a layer over vertices, in one of class W,
// and where ranges would not begin at even columns or would be too many.
SharedColumns find_shared_columns(const NetworkPlan& plan, uint32_t index, const LinearRecord& record);

// The part mean whose table a candidate maximum may read instead of the tile's rows, since both have one row per joint.
// Returns the part mean's layer index, or -1 where layer `index` is no such maximum.
int table_of_maximum(const NetworkPlan& plan, uint32_t index);

// Which rows of a layer's output are read by later layers, in a tile whose shared columns are multiplied once. Rows that
// nobody reads are not computed.
enum class RowsRead : uint8_t {
  kAll,
  kFirstOfVertex,  // the row of a vertex' first slot: shared columns are read there
  kNone            // all readers take the layer's table
};

// The linear layers' packed parameters: the model's, or made in the workspace.
struct PackedLayers {
  const uint8_t* memory = nullptr;   // the parameters; null where no kernel wants them
  size_t offsets[kMaxLayers];        // of each linear layer's parameters in `memory`
  uint8_t* own = nullptr;            // the same as `memory` where fill() must write it; else the model brought it
  bool has_shared = false;           // some layer has shared columns
  SharedColumns* columns = nullptr;  // [layers]
  int32_t* starts = nullptr;         // [lanes x tile x outputs] a vertex' sums of shared columns
  uint32_t outputs = 0;              // of the widest layer that has shared columns
  RowsRead rows_read[kMaxLayers];

  bool allocate(const sinew_model& model, const NetworkPlan& plan, const ModelTables& tables,
                const NetworkOptions& options, uint32_t lanes, Arena& arena);
  // Packs the parameters if the model did not bring them, and sorts the columns.
  //   wanted  whether the kernels at hand read packed parameters; if not, the memory stays unused
  void fill(const NetworkPlan& plan, const ModelTables& tables, bool wanted);
  PackedLinear view(const LinearView& linear, uint32_t index) const {
    return packed_view(linear, memory + offsets[index]);
  }
};

}  // namespace sinew
#endif
