// SPDX-License-Identifier: MIT
// Multi-source label propagation through voxels: every cell learns its K nearest joints. The heart of the candidate
// search.
#ifndef SINEW_CANDIDATES_PROPAGATION_HPP
#define SINEW_CANDIDATES_PROPAGATION_HPP

#include "core/build.hpp"
#include "voxels/voxels.hpp"

namespace sinew {

// Lengths in the grid are counted in fortieths of a cell: chamfer steps 5/7/9 (Borgefors 1986) in eighths of a chamfer
// unit, so that bones and vertices need not sit at cell centers. A step that touches an outside cell costs four times
// as much.
constexpr int32_t kCellLength = 40;
constexpr uint32_t kStepLengths[4] = {0, 40, 56, 72};  // by the number of axes a step moves along
constexpr uint32_t kOutsideFactor = 4;

// A label is (distance << 12) | joint, so labels order by (distance, joint). 12 bits hold SINEW_MAX_JOINTS. 17 bits
// hold any distance that is needed: joints lie within 2^22 of the origin, at most 887 cells of the box at the finest
// grid, or 35,480; from there a straight walk of at most 128 outside steps adds 36,864, a late start 160, and a cell
// cannot need more for its K-th label, because a cell that refuses a label on that walk is full of nearer ones that go
// on in its stead. Longer paths, through a winding body, are not followed.
constexpr int kJointBits = 12;
constexpr uint32_t kJointMask = (1u << kJointBits) - 1;
static_assert(SINEW_MAX_JOINTS <= kJointMask + 1, "a label's joint field is too small");
inline constexpr uint32_t make_label(uint32_t distance, uint32_t joint) { return (distance << kJointBits) | joint; }

// A run: survey() once the grid is filled; then begin(), seed() and run() as often as needed. Its result is a function
// of the grid and the seeds alone: labels come by (distance, joint), whatever order the queue holds them in.
//
// run() goes in two steps, because few labels ever come back from outside, where most of the cells are. First the
// labels walk through solid cells (inside and surface) and along the bones only. That gives every solid cell an upper
// bound of its K-th distance, and so every outside cell the farthest distance with which a label can still matter:
// bound_outside(). Then the labels step outside, within these bounds, and what comes back corrects the first result,
// again nearest first: a label of the first step that is right stays and has been passed on to solid cells, one that is
// not has its better before its turn comes. The pruning below holds in each step by itself: the cells q that excuse an
// offer between solid cells are solid.
class Propagation {
 public:
  VoxelGrid grid;

  bool allocate(Arena& arena, const Counts& counts);
  // Scratch for voxelise(), free until survey(). [max_cells]
  uint32_t* queue() { return numbers_; }
  // Learns the grid's terrain.
  void survey();
  // Empties all cells. capacity: labels a cell holds in this run, 1 .. K and at most the number of joints that are
  // seeded.
  void begin(uint32_t capacity);
  // Offers a label to an inner cell.
  void seed(uint32_t cell, uint32_t label);
  // Finds the labels of all solid cells. Returns false if cancelled; reports `permille` to progress.
  bool run(const Progress& progress, uint32_t permille);

  // A solid cell's number, 0 for others.
  uint32_t solid_cell(uint32_t grid_index) const {
    return numbers_[grid_index] <= solid_count_ ? numbers_[grid_index] : 0;
  }
  // Labels of the solid cell of that number after run(), ascending: capacity() of them.
  const uint32_t* labels(uint32_t number) const { return row(at(number)); }
  uint32_t capacity() const { return capacity_; }

 private:
  // The 26 steps to a cell's neighbors, x fastest. A label that came to a cell c by a step from p need not go on to a
  // neighbor n that has a path from p beside c, straight or over one other cell q, that is shorter, or as long with a
  // shorter last step (the pruning rule of Harabor and Grastien 2011, "Online Graph Pruning for Pathfinding on Grid
  // Maps", in three dimensions and with two terrains). Distances stay exact: among the shortest paths to n take one
  // with the shortest last step; its last cell must offer to n.
  //   all cells around c solid    the label goes on straight ahead and along the axes of its step: 1, 3 or 7 offers
  //   c outside                   the same, because no path from p to n costs more than it would outside throughout
  //   c and p solid               which n are left depends on the terrain of n and of every q: beside_
  //   c solid, p outside          rare: 26 offers
  // The border does not count as terrain: the other path lies between p and n.
  static constexpr uint8_t kStepCount = 26;
  static constexpr uint8_t kEverywhere = kStepCount;
  static constexpr uint32_t kAllSteps = (1u << kStepCount) - 1;
  struct Step {
    int32_t offset;
    uint32_t label_step;  // length, already in the bits of a label's distance
    uint32_t next;        // bit s: a label that came by this step goes on with step s
  };

  static constexpr uint8_t kCostly = 1;   // outside: steps to and from here are costly
  static constexpr uint8_t kSurface = 2;  // solid, with outside cells around
  static constexpr uint8_t kBeside = 4;   // solid, and a bone passes an outside cell around
  // A cell that labels may enter; K labels and K arrivals follow it, so that for K = 8 it fills a line of the cache.
  // Solid cells come first, in grid order; outside cells get theirs with their first label.
  struct Cell {
    uint32_t limit;       // labels above this are refused: the last label of a full cell
    uint32_t next;        // cells in the same bucket; next 0: the last one
    uint32_t last;        // 0: waits nowhere; kHead | bucket: the first one
    uint32_t grid_index;  // index in the grid
    uint32_t solid;       // bit s: step s leads to a solid cell (of solid cells only)
    uint8_t found;        // labels present
    uint8_t settled;      // the first label that has not been passed on
    uint8_t terrain;
    uint8_t unused;
  };
  static constexpr uint32_t kHead = 1u << 31;
  static constexpr uint8_t kPassedOn = 0x80;  // a bit of an arrival: the label has been passed on
  // Buckets by distance (Dial 1969), narrower than the shortest step, so that nothing can reach a bucket while it has
  // its turn; a power of two of them beyond the longest step. A cell waits in the bucket of its first label that has
  // not been passed on, so that memory is a function of the grid alone.
  static constexpr int kBucketBits = 5;
  static constexpr uint32_t kBuckets = 64;

  Cell& at(uint32_t number) { return *static_cast<Cell*>(static_cast<void*>(block_ + number * cell_bytes_)); }
  const Cell& at(uint32_t number) const {
    return *static_cast<const Cell*>(static_cast<const void*>(block_ + number * cell_bytes_));
  }
  static uint32_t* row(Cell& cell) { return static_cast<uint32_t*>(static_cast<void*>(&cell + 1)); }
  static const uint32_t* row(const Cell& cell) {
    return static_cast<const uint32_t*>(static_cast<const void*>(&cell + 1));
  }
  // [K] step by which a label came, a seed has kEverywhere; and kPassedOn.
  uint8_t* arrivals(Cell& cell) const { return static_cast<uint8_t*>(static_cast<void*>(row(cell) + row_size_)); }

  void lay_steps();
  void lay_directions_beside();
  uint32_t add_cell(uint32_t grid_index, uint8_t terrain);
  void empty(Cell* cell) const;
  void link(uint32_t number, uint32_t bucket);
  void unlink(Cell* cell);
  static uint32_t round_of(uint32_t label) { return label >> (kJointBits + kBucketBits); }
  void offer(uint32_t number, uint32_t label, uint8_t arrival);
  bool enters(uint32_t grid_index, uint32_t label) const;
  void offer_solid(uint32_t grid_index, uint32_t label, uint32_t directions);
  void offer_costly(uint32_t grid_index, uint32_t label, uint32_t directions);
  SINEW_ONCE uint32_t directions_beside(uint32_t directions, uint32_t solid, uint8_t arrival, uint32_t costly) const;
  void spread(const Cell& from, uint32_t label, uint8_t arrival, uint32_t solid, uint32_t costly);
  bool settle(const Progress& progress, uint32_t permille);
  bool bound_outside();
  void spread_bounds();
  void leave(Cell* cell);

  uint32_t* numbers_ = nullptr;  // [cells] a cell's number in block_, from 1; 0: labels have not entered it
  int16_t* bounds_ = nullptr;    // [cells] farthest distance with which a label enters an outside cell, or kAnyDistance
  uint8_t* block_ = nullptr;     // [inner cells + 1] Cell
  uint32_t cell_bytes_ = 0;
  uint32_t row_size_ = 0;
  // [26 steps came by x 2 terrains of n x 26 steps on] steps to the solid cells q over which n is reached as well.
  uint32_t* beside_ = nullptr;
  uint32_t capacity_ = 0;
  uint32_t solid_count_ = 0;
  uint32_t cell_count_ = 0;  // of block_, without number 0
  uint32_t waiting_ = 0;     // cells in buckets
  uint32_t passed_on_ = 0;
  uint8_t edge_ = 0;  // cells with one of these flags pass labels on to outside cells
  uint32_t heads_[kBuckets + 1] = {};
  Step steps_[kStepCount] = {};
  uint32_t left_[kStepCount][2] = {};  // [step came by][terrain of n] bits of n that are neither p nor reached straight
  int8_t along_[kStepCount][3] = {};   // the steps as vectors
};

}  // namespace sinew
#endif
