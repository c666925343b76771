// SPDX-License-Identifier: MIT
// Multi-source label propagation through voxels: every cell learns its K nearest joints. The heart of the candidate
// search.
#ifndef SINEW_FEATURES_PROPAGATION_HPP
#define SINEW_FEATURES_PROPAGATION_HPP

#include "features/voxels.hpp"

namespace sinew {

// Lengths in the grid are counted in fortieths of a cell: chamfer steps 5/7/9 (Borgefors 1986) in eighths of a chamfer
// unit, so that bones and vertices need not sit at cell centres. A step that touches an outside cell costs four times
// as much.
constexpr int32_t kCellLength = 40;
constexpr uint32_t kStepLengths[4] = {0, 40, 56, 72};  // by the number of axes a step moves along
constexpr uint32_t kOutsideFactor = 4;

// A label is (distance << 12) | joint, so labels order by (distance, joint). 12 bits hold SINEW_MAX_JOINTS. 20 bits
// hold any distance: joints lie within 2^22 of the origin, at most 887 cells of the box at the finest grid, or 35,480;
// from there a straight walk of at most 128 outside steps adds 36,864, a late start 160, and a cell cannot need more
// for its K-th label, because a cell that refuses a label on that walk is full of nearer ones that go on in its stead.
// For the same reason every cell that waits long enough gets all its labels.
constexpr int kJointBits = 12;
constexpr uint32_t kJointMask = (1u << kJointBits) - 1;
static_assert(SINEW_MAX_JOINTS <= kJointMask + 1, "a label's joint field is too small");
inline uint32_t make_label(uint32_t distance, uint32_t joint) { return (distance << kJointBits) | joint; }

// A run: survey() once the grid is filled and mark what is wanted; then begin(), seed() and run() as often as needed.
// Its result is a function of the grid and the seeds alone: labels come by (distance, joint), whatever order the queue
// holds them in.
class Propagation {
 public:
  VoxelGrid grid;

  bool allocate(Arena& arena, const Counts& counts);
  // Scratch for voxelise(), free until begin(). [max_cells]
  uint32_t* queue() { return next_; }
  // Learns the grid's terrain. Nothing is wanted afterwards.
  void survey();
  // Says that run() must not end before this cell is full.
  void want(uint32_t cell) { cells_[cell].terrain |= kWanted; }
  // Empties all cells. capacity: labels a cell holds in this run, 1 .. K and at most the number of joints that are
  // seeded.
  void begin(uint32_t capacity);
  // Offers a label to an inner cell.
  void seed(uint32_t cell, uint32_t label) {
    if (label <= cells_[cell].limit) offer(cell, label, kEverywhere);
  }
  // Settles labels, a cell's own by rising distance, until every wanted cell is full. False when cancelled; progress is
  // told `permille`.
  bool run(const Progress& progress, uint32_t permille);

  // A cell's final labels, ascending: all `capacity` for a wanted cell.
  const uint32_t* labels(uint32_t cell) const { return labels_ + static_cast<size_t>(cell) * capacity_; }
  uint32_t label_count(uint32_t cell) const { return cells_[cell].settled; }

 private:
  // The 26 steps to a cell's neighbours, x fastest. A label that came to a cell c by a step from p need not go on to a
  // neighbour n that has a way from p beside c, straight or over one other cell q, that is shorter, or as long with a
  // shorter last step (the pruning rule of Harabor and Grastien 2011, "Online Graph Pruning for Pathfinding on Grid
  // Maps", in three dimensions and with two terrains). Distances stay exact: among the shortest ways to n take one with
  // the shortest last step; its last cell must offer to n.
  //   all cells around c solid    the label goes on straight ahead and along the axes of its step: 1, 3 or 7 offers
  //   c outside                   the same, because no way from p to n is dearer than it would be outside throughout
  //   c and p solid               which n are left depends on the terrain of n and of every q: beside_
  //   c solid, p outside          rare: 26 offers
  // The border does not count as terrain: the other way lies between p and n.
  static constexpr uint8_t kStepCount = 26;
  static constexpr uint8_t kEverywhere = kStepCount;
  static constexpr uint32_t kAllSteps = (1u << kStepCount) - 1;
  struct Step {
    int32_t offset;
    uint32_t label_step;  // length, already in the place of a label's distance
    uint8_t next_count;   // steps a label that came by this one goes on with
    uint8_t next[7];
  };

  static constexpr uint8_t kDear = 1;
  static constexpr uint8_t kUniform = 2;  // outside, or no cell around is: a label goes on with Step::next
  static constexpr uint8_t kWanted = 4;   // some vertex reads this cell
  // Labels far outside wait longer, by what the way back to the body costs at least: a body is full before most of them
  // have their turn (Hart, Nilsson and Raphael 1968). One less than a step out, so that a label's turn comes after that
  // of the label it came from.
  static constexpr uint8_t kMostLayers = 3;
  static constexpr uint32_t kLayerWait = kOutsideFactor * kStepLengths[1] - 1;

  // What an offer looks at first, side by side: most offers are refused here.
  struct Cell {
    uint32_t limit;   // labels above this are refused: the last label of a full cell, 0 at the border, else kNever
    uint8_t terrain;  // kDear: steps to and from here are dear; kUniform; kWanted
    uint8_t found;    // labels present
    uint8_t settled;  // the first labels, final
    uint8_t layers;   // steps to the next solid cell, up to kMostLayers
  };

  void link(uint32_t cell, uint32_t ring);
  void unlink(uint32_t cell);
  // When a label has its turn.
  static uint32_t turn_of(const Cell& cell, uint32_t label) { return (label >> kJointBits) + kLayerWait * cell.layers; }
  uint32_t bucket_of(const Cell& cell, uint32_t label) const;
  void offer(uint32_t index, uint32_t label, uint8_t arrival);
  void offer_step(uint32_t index, uint32_t label, uint8_t way, bool dear);
  void spread(uint32_t index, uint32_t label, uint8_t arrival);
  void spread_along_surface(uint32_t index, uint32_t label, uint8_t arrival);
  void count_layers();
  void lay_steps();
  void lay_ways_beside();
  const uint32_t* beside(uint8_t came, bool dear) const { return beside_ + (2u * came + (dear ? 1 : 0)) * kStepCount; }

  Cell* cells_ = nullptr;      // [cells]
  uint32_t* solid_ = nullptr;  // [cells] where a cell is solid and not uniform: bit s, step s leads to a solid cell
  // [26 steps came by x 2 terrains of n x 26 steps on] steps to the solid cells q over which n is reached as well;
  // kAllSteps where it is reached straight or is p.
  uint32_t* beside_ = nullptr;
  uint32_t* labels_ = nullptr;   // [cells x K] ascending
  uint8_t* arrivals_ = nullptr;  // [cells x K] step by which the label came; a seed has kEverywhere
  // Buckets by distance (Dial 1969) as rings of cells; a cell waits in the bucket of its first unsettled label, so that
  // memory is a function of the grid alone. A cell linked to itself waits nowhere.
  uint32_t* next_ = nullptr;  // [cells + buckets + 1]
  uint32_t* last_ = nullptr;  // [cells + buckets + 1]
  uint32_t capacity_ = 0;
  uint32_t waiting_ = 0;  // cells in buckets
  Step steps_[kStepCount] = {};
  int8_t along_[kStepCount][3] = {};  // the steps as vectors
};

}  // namespace sinew
#endif
