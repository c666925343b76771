// SPDX-License-Identifier: MIT
// The heat stage from sources to three sparse fields, and the finishing of a row (stage 4).
#include "heat/heat.hpp"

#include "heat/solver.hpp"
#include "heat/sources.hpp"
#include "solve/laplacian.hpp"

namespace sinew {
namespace {

constexpr uint32_t kSourcesEnd = 300;  // permille of this stage's progress

struct HeatScratch {
  HeatSources sources;
  EdgeWeights edges;
  HeatSolver solvers[kFieldCount];  // one per lane, as far as they go
  HeatLane* lanes = nullptr;        // where there is more than one lane

  bool allocate_solvers(Arena& arena, const Counts& counts);
};

// The finder's and the Laplacian's scratch lies where the solver's arrays come later.
bool allocate_inputs(Arena& arena, const Counts& counts, const HeatFields& fields, HeatScratch* scratch) {
  return scratch->sources.allocate_beside(arena, counts, fields) && scratch->edges.allocate(arena, counts);
}

bool same_sources(const Mesh& mesh, uint32_t part, const HeatSources& sources) {
  for (uint32_t i = mesh.part_offsets[part]; i < mesh.part_offsets[part + 1]; ++i) {
    const uint32_t v = mesh.part_vertices[i];
    if (sources.mask[kFieldRule][v] != sources.mask[kFieldParts][v]) return false;
  }
  return true;
}

void copy_part(const Mesh& mesh, uint32_t part, const HeatField& from, HeatField* to) {
  for (uint32_t i = mesh.part_offsets[part]; i < mesh.part_offsets[part + 1]; ++i) {
    const size_t row = static_cast<size_t>(mesh.part_vertices[i]) * kHeatSlots;
    for (uint32_t slot = 0; slot < kHeatSlots; ++slot) {
      to->joints[row + slot] = from.joints[row + slot];
      to->weights[row + slot] = from.weights[row + slot];
    }
  }
}

// All fields of parts: those of a large part on all lanes, small parts one to a lane, on up to kFieldCount of them.
class PartWalk {
 public:
  PartWalk(const Mesh& mesh, const Threads& threads, const Progress& progress, HeatScratch& scratch, HeatFields* fields,
           const WorkBeside& beside)
      : mesh_(mesh),
        all_lanes_(threads),
        threads_(threads),
        progress_(progress),
        scratch_(scratch),
        fields_(fields),
        beside_(beside) {
    threads_.lanes = solver_count(threads);
  }
  static uint32_t solver_count(const Threads& threads) {
    return threads.lane_count() < kFieldCount ? threads.lane_count() : static_cast<uint32_t>(kFieldCount);
  }

  sinew_status run() {
    for (uint32_t c = 0; c < mesh_.part_count;) {
      uint32_t end = c + 1, vertices = mesh_.part_sizes[c];
      if (threads_.lane_count() > 1 && vertices < kSmall) {
        while (end < mesh_.part_count && vertices + mesh_.part_sizes[end] < kRound) {
          vertices += mesh_.part_sizes[end++];
        }
        each_and_beside(threads_, end - c,
                        [&](uint32_t index, uint32_t lane) { solve_alone(c + index, scratch_.solvers[lane]); });
        if (!report(uint64_t{vertices} * kFieldCount)) return SINEW_ERROR_CANCELLED;
      } else if (threads_.lane_count() > 1) {
        solve_together(c);
        if (!report(uint64_t{vertices} * kFieldCount)) return SINEW_ERROR_CANCELLED;
      } else {
        scratch_.solvers[0].begin_part(mesh_, scratch_.edges, c);
        for (uint32_t f = 0; f < kFieldCount; ++f) {
          solve_field(c, f, scratch_.solvers[0]);
          if (!report(vertices)) return SINEW_ERROR_CANCELLED;
        }
      }
      c = end;
    }
    return SINEW_OK;
  }

 private:
  static constexpr uint32_t kSmall = 512, kRound = 8192;  // vertices

  // body(index, lane) for [0, count), and the work of another stage if it has not been done.
  template <class Body>
  void each_and_beside(const Threads& threads, uint32_t count, const Body& body) {
    const WorkBeside beside = beside_;
    beside_ = WorkBeside();
    threads.each(beside.run != nullptr ? count + 1 : count, [&](uint32_t index, uint32_t lane) {
      if (index == count) {
        beside.run(beside.data);
      } else {
        body(index, lane);
      }
    });
  }

  bool is_copy(uint32_t part, uint32_t field) const {
    return field == kFieldParts && same_sources(mesh_, part, scratch_.sources);
  }
  bool report(uint64_t field_vertices) {
    done_ += field_vertices;
    const uint64_t share = done_ * (Progress::kWhole - kSourcesEnd) / (uint64_t{mesh_.welded_count} * kFieldCount);
    return progress_.report(kSourcesEnd + static_cast<uint32_t>(share));
  }
  void copy_rule(uint32_t part) const {
    copy_part(mesh_, part, fields_->field[kFieldRule], &fields_->field[kFieldParts]);
  }

  void solve_alone(uint32_t part, HeatSolver& solver) const {
    solver.begin_part(mesh_, scratch_.edges, part);
    for (uint32_t f = 0; f < kFieldCount; ++f) solve_field(part, f, solver);
  }
  void solve_field(uint32_t part, uint32_t field, HeatSolver& solver) const {
    if (is_copy(part, field)) {
      copy_rule(part);
    } else {
      solver.solve_field(scratch_.sources, field, &fields_->field[field]);
    }
  }

  // A large part: fields have a solver each, and their batches of joints a lane each. Where fronts refuse one of them,
  // those after it have to do without too: rare, and then a matter for one lane.
  void solve_together(uint32_t part) {
    const bool copy = is_copy(part, kFieldParts);
    uint32_t fields[kFieldCount] = {kFieldRule, kFieldSoft, kFieldParts};
    const uint32_t count = copy ? kFieldCount - 1 : kFieldCount, at_once = threads_.lanes;
    for (uint32_t first = 0; first < count; first += at_once) {
      const uint32_t some = count - first < at_once ? count - first : at_once;
      if (!solve_fields(part, fields + first, some, first == 0)) return solve_alone(part, scratch_.solvers[0]);
    }
    if (copy) copy_rule(part);
  }

  bool solve_fields(uint32_t part, const uint32_t* fields, uint32_t count, bool first) {
    bool done[kFieldCount] = {};
    HeatSolver* const solvers = scratch_.solvers;
    const auto field_of = [&](uint32_t index) { return &fields_->field[fields[index]]; };
    each_and_beside(all_lanes_, count, [&](uint32_t index, uint32_t) {
      if (first) solvers[index].begin_part(mesh_, scratch_.edges, part);
      done[index] = solvers[index].begin_fronts(scratch_.sources, fields[index], field_of(index));
    });
    for (uint32_t index = 0; index < count; ++index) {
      if (!done[index]) return false;
    }
    HeatLane* const lanes = scratch_.lanes;
    for (uint32_t lane = 0; lane < all_lanes_.lanes; ++lane) lanes[lane].tame = true;
    for (uint32_t index = 0, batch = 0; index < count;) {
      uint32_t tasks = 0;
      for (; tasks < all_lanes_.lanes && index < count; ++tasks) {
        lanes[tasks].solver = index;
        lanes[tasks].batch = batch++;
        if (batch < solvers[index].batch_count()) continue;
        batch = 0;
        ++index;
      }
      all_lanes_.each(tasks, [&](uint32_t task, uint32_t) {
        const HeatLane& lane = lanes[task];
        solvers[lane.solver].solve_batch(scratch_.sources, fields[lane.solver], lane);
      });
      constexpr uint32_t kFrontPiece = 8;
      all_lanes_.ranges(solvers[0].front_count(), kFrontPiece, [&](uint32_t begin, uint32_t end, uint32_t lane) {
        for (uint32_t task = 0; task < tasks; ++task) {
          const uint32_t own = lanes[task].solver;
          if (!solvers[own].keep_batch(lanes[task], begin, end, field_of(own))) lanes[lane].tame = false;
        }
      });
    }
    constexpr uint32_t kRowPiece = 256;
    all_lanes_.ranges(mesh_.part_sizes[part], kRowPiece, [&](uint32_t begin, uint32_t end, uint32_t lane) {
      for (uint32_t index = 0; index < count; ++index) {
        if (solvers[index].close_totals(begin, end)) {
          solvers[index].finish_rows(begin, end, field_of(index));
        } else {
          lanes[lane].tame = false;
        }
      }
    });
    bool tame = true;
    for (uint32_t lane = 0; lane < all_lanes_.lanes; ++lane) tame = tame && lanes[lane].tame;
    return tame;
  }

  const Mesh& mesh_;
  const Threads all_lanes_;
  Threads threads_;  // as many as solvers
  const Progress& progress_;
  HeatScratch& scratch_;
  HeatFields* fields_;
  WorkBeside beside_;  // none once it ran
  uint64_t done_ = 0;  // vertices of all fields
};

bool HeatScratch::allocate_solvers(Arena& arena, const Counts& counts) {
  const uint32_t count = PartWalk::solver_count(counts.threads), lane_count = counts.threads.lane_count();
  for (uint32_t i = 0; i < count; ++i) (void)solvers[i].allocate(arena, counts);
  if (lane_count == 1) return arena.ok();
  lanes = arena.alloc<HeatLane>(lane_count);
  for (uint32_t i = 0; i < lane_count; ++i) {
    HeatLane lane;
    (void)solvers[0].allocate_lane(arena, counts, i < count ? &solvers[i] : nullptr, &lane);
    if (lanes != nullptr) lanes[i] = lane;
  }
  return arena.ok();
}

}  // namespace

bool HeatFields::allocate(Arena& arena, const Counts& counts) {
  const size_t slots = static_cast<size_t>(counts.vertices) * kHeatSlots;
  for (HeatField& f : field) {
    f.joints = arena.alloc<uint16_t>(slots);
    f.weights = arena.alloc<uint16_t>(slots);
    f.nearest = arena.alloc<uint16_t>(counts.vertices);
    f.has_source = arena.alloc<uint8_t>(counts.vertices);
  }
  part_rule = arena.alloc<uint8_t>(counts.vertices);
  return arena.ok();
}

sinew_status solve_heat(const Mesh& mesh, const Skeleton& skeleton, const uint8_t* source_joints, const Counts& counts,
                        const Kernels& kernels, const Progress& progress, Arena& arena, HeatFields* fields,
                        const WorkBeside& beside) {
  const ArenaScope scope(arena);
  fields->source_joints = source_joints;
  HeatScratch scratch;
  for (HeatSolver& solver : scratch.solvers) solver.use(kernels.front);
  if (!allocate_inputs(arena, counts, *fields, &scratch)) return SINEW_ERROR_WORKSPACE;
  sinew_status status = find_sources(mesh, skeleton, source_joints, counts, kernels.boxes_met, progress, kSourcesEnd,
                                     arena, &scratch.sources);
  if (status != SINEW_OK) return status;
  status = weigh_edges(mesh, counts, arena, &scratch.edges);
  if (status != SINEW_OK) return status;
  if (!scratch.allocate_solvers(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    fields->field[kFieldParts].nearest[v] = fields->field[kFieldRule].nearest[v];
  }
  status = PartWalk(mesh, counts.threads, progress, scratch, fields, beside).run();
  for (HeatField& field : fields->field) {
    for (uint32_t v = 0; v < mesh.welded_count; ++v) field.has_source[v] = field.has_source[v] != 0;
  }
  return status;
}

uint32_t finish_heat_row(const HeatField& field, uint32_t vertex, uint16_t* joints, uint16_t* weights) {
  const uint16_t* raw_joints = field.joints + static_cast<size_t>(vertex) * kHeatSlots;
  const uint16_t* raw_weights = field.weights + static_cast<size_t>(vertex) * kHeatSlots;
  // Fifths of a Q15 unit: 0.025 is 4096 of them exactly.
  constexpr uint32_t kCut = 4096;
  uint32_t ramped[kHeatSlots];
  uint32_t used = 0, sum = 0;
  for (uint32_t slot = 0; slot < kHeatSlots && raw_joints[slot] != kNoJoint; ++slot) {
    const uint32_t fifths = 5u * raw_weights[slot];
    if (fifths <= kCut) break;  // rows fall
    ramped[used] = fifths < 2 * kCut ? 2 * (fifths - kCut) : fifths;
    sum += ramped[used];
    joints[used] = raw_joints[slot];
    ++used;
  }
  if (used == 0) {
    joints[0] = field.nearest[vertex];
    ramped[0] = sum = 1;
    used = 1;
  }
  for (uint32_t slot = 0; slot < used; ++slot) {
    weights[slot] = static_cast<uint16_t>((static_cast<uint64_t>(ramped[slot]) * 65536 / sum + 1) / 2);
  }
  for (uint32_t slot = used; slot < kHeatSlots; ++slot) {
    joints[slot] = kNoJoint;
    weights[slot] = 0;
  }
  return used;
}

}  // namespace sinew
