// SPDX-License-Identifier: MIT
// Checks, anatomy of both rigs, the method, pins, and the confidence of the result.
#include "mapping/map.hpp"

#include <stddef.h>

#include "core/build.hpp"
#include "core/read_skeleton.hpp"
#include "core/struct_size.hpp"
#include "mapping/hierarchy.hpp"
#include "mapping/matcher.hpp"
#include "sinew/published.h"

namespace sinew::mapping {
namespace {

constexpr double kWhole = 32768;      // certainty
constexpr double kGuess = 0.08;       // how much more alike rigs must be for leaves to be end markers
constexpr double kNearlyEqual = 0.5;  // mean cost of a pair of joints by branches

sinew_status check_areas(const float* areas, uint32_t joints) {
  for (uint32_t j = 0; j < joints && areas != nullptr; ++j) {
    if (!(areas[j] - areas[j] == 0)) return SINEW_ERROR_NOT_FINITE;
    if (areas[j] < 0) return SINEW_ERROR_RANGE;
  }
  return SINEW_OK;
}

// A rig with what is known of it.
struct Side {
  Hierarchy rig;
  Anatomy anatomy;
  Point up;
  bool has_up = false;

  bool allocate(Arena& arena, uint32_t joints) {
    (void)rig.allocate(arena, joints);
    (void)anatomy.allocate(arena, joints);
    return arena.ok();
  }
  void read_up(const sinew_skeleton& given) {
    has_up = given.up != SINEW_UP_AUTO;
    up = {given.up == SINEW_UP_X ? 1.0 : 0.0, given.up == SINEW_UP_Y ? 1.0 : 0.0, given.up == SINEW_UP_Z ? 1.0 : 0.0};
  }
  bool build(bool flip, Arena& arena) { return anatomy.build(rig, has_up ? &up : nullptr, flip, arena); }
};

struct Result {
  int32_t* sources = nullptr;  // [target n]
  double* costs = nullptr;     // [target n]

  bool allocate(Arena& arena, uint32_t joints) {
    sources = arena.alloc<int32_t>(joints);
    costs = arena.alloc<double>(joints);
    return arena.ok();
  }
};

uint32_t mapped_count(const int32_t* sources, uint32_t joints) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < joints; ++i) count += sources[i] >= 0 ? 1 : 0;
  return count;
}

void read_pins(const MapPlan& plan, Pins* pins) {
  for (uint32_t i = 0; i < plan.target.joint_count; ++i) pins->source_of[i] = Pins::kFree;
  for (uint32_t j = 0; j < plan.source.joint_count; ++j) pins->target_of[j] = Pins::kFree;
  pins->any = plan.options.pin_count > 0;
  for (uint32_t k = 0; k < plan.options.pin_count; ++k) {
    const sinew_map_pin& pin = plan.options.pins[k];
    pins->source_of[pin.target] = pin.source;
    if (pin.source >= 0) pins->target_of[pin.source] = static_cast<int32_t>(pin.target);
  }
}

// Returns whether pins map the target's left to the source's right.
bool pins_turn(const Anatomy& target, const Anatomy& source, const MapPlan& plan) {
  int32_t sum = 0;
  for (uint32_t k = 0; k < plan.options.pin_count; ++k) {
    const sinew_map_pin& pin = plan.options.pins[k];
    if (pin.source >= 0) sum += target.side[pin.target] * source.side[pin.source];
  }
  return sum < 0;
}

// Share of the joints of both rigs, end markers aside, that have no counterpart.
double unlikeness(const Hierarchy& target, const Hierarchy& source, const int32_t* sources, int32_t* used) {
  int32_t all = 0, alone = 0;
  for (int32_t j = 0; j < source.n; ++j) used[j] = 0;
  for (int32_t i = 0; i < target.n; ++i) {
    if (sources[i] >= 0) used[sources[i]] = 1;
    if (target.end[i] != 0) continue;
    ++all;
    alone += sources[i] < 0 || source.end[sources[i]] != 0 ? 1 : 0;
  }
  for (int32_t j = 0; j < source.n; ++j) {
    if (source.end[j] != 0) continue;
    ++all;
    alone += used[j] == 0 ? 1 : 0;
  }
  return static_cast<double>(alone) / (all > 0 ? all : 1);
}

// Takes out joints whose names contradict those of their sources, puts pins in, and takes out what shares a source
// with another joint or crosses the path of one.
class Cleaner {
 public:
  Cleaner(const Hierarchy& target, const Hierarchy& source, const Pins& pins, int32_t* sources, uint8_t* reasons,
          int32_t* owner)
      : a_(target), b_(source), pins_(pins), sources_(sources), reasons_(reasons), owner_(owner) {}

  void run(bool one_to_one) {
    for (int32_t i = 0; i < a_.n; ++i) reasons_[i] = SINEW_MAP_FOUND;
    drop_contradictions();
    for (int32_t i = 0; i < a_.n && pins_.any; ++i) {
      if (pins_.source_of[i] == Pins::kFree) continue;
      sources_[i] = pins_.source_of[i];
      reasons_[i] = SINEW_MAP_PINNED;
    }
    if (one_to_one) share();
    for (int32_t i = 0; i < a_.n && pins_.any; ++i) {
      if (reasons_[i] == SINEW_MAP_PINNED && sources_[i] >= 0) clear_way_of(i);
    }
    for (int32_t k = 0; k < a_.n; ++k) {
      const int32_t t = a_.order[k];
      if (sources_[t] < 0 || reasons_[t] == SINEW_MAP_PINNED) continue;
      for (int32_t above = a_.parent[t]; above >= 0; above = a_.parent[above]) {
        if (!crosses(above, t)) continue;
        drop(t);
        break;
      }
    }
  }

 private:
  // All of them would leave nothing: then names say other things than joints are.
  void drop_contradictions() {
    const auto contradicts = [&](int32_t i) {
      return a_.has_names && sources_[i] >= 0 &&
             (contradict(a_.names[i], b_.names[sources_[i]]) || is_leg_in_hand(a_, b_, pins_, sources_, i));
    };
    bool some_agree = false;
    for (int32_t i = 0; i < a_.n; ++i) some_agree = some_agree || (sources_[i] >= 0 && !contradicts(i));
    for (int32_t i = 0; i < a_.n && some_agree; ++i)
      if (contradicts(i)) sources_[i] = -1;
  }
  bool crosses(int32_t above, int32_t below) const {
    const int32_t s = sources_[above], t = sources_[below];
    return s >= 0 && t >= 0 && s != t && b_.holds(t, s);
  }
  void drop(int32_t i) {
    sources_[i] = -1;
    reasons_[i] = SINEW_MAP_TAKEN;
  }
  // A source goes to the joint that is pinned to it, else to the first in the order of the hierarchy.
  void share() {
    for (int32_t j = 0; j < b_.n; ++j) owner_[j] = pins_.any ? pins_.target_of[j] : Pins::kFree;
    for (int32_t k = 0; k < a_.n; ++k) {
      const int32_t i = a_.order[k], j = sources_[i];
      if (j < 0) continue;
      if (owner_[j] == Pins::kFree) owner_[j] = i;
      if (owner_[j] != i) drop(i);
    }
  }
  void clear_way_of(int32_t pinned) {
    for (int32_t i = a_.parent[pinned]; i >= 0; i = a_.parent[i]) {
      if (reasons_[i] != SINEW_MAP_PINNED && crosses(i, pinned)) drop(i);
    }
    for (int32_t k = a_.position[pinned] + 1; k < a_.position[pinned] + a_.count[pinned]; ++k) {
      const int32_t i = a_.order[k];
      if (reasons_[i] != SINEW_MAP_PINNED && crosses(pinned, i)) drop(i);
    }
  }

  const Hierarchy &a_, &b_;
  const Pins& pins_;
  int32_t* sources_;
  uint8_t* reasons_;
  int32_t* owner_;
};

// Why what has no source has none.
void explain(const Anatomy& target, const int32_t* sources, uint8_t* reasons) {
  const Hierarchy& rig = *target.rig;
  for (int32_t i = 0; i < rig.n; ++i) {
    if (sources[i] >= 0 || reasons[i] != SINEW_MAP_FOUND) continue;
    reasons[i] = rig.apart[i] != 0           ? SINEW_MAP_OUTSIDE
                 : rig.end[i] != 0           ? SINEW_MAP_END
                 : !rig.holds(target.hip, i) ? SINEW_MAP_OUTSIDE
                 : target.limbs.full         ? SINEW_MAP_BESIDE_LIMITS
                                             : SINEW_MAP_NO_COUNTERPART;
  }
  const auto chain = [&](const int32_t* joints, int32_t count) {
    bool any = false;
    for (int32_t k = 0; k < count; ++k) any = any || sources[joints[k]] >= 0;
    for (int32_t k = 0; k < count; ++k) {
      uint8_t& reason = reasons[joints[k]];
      if (sources[joints[k]] >= 0 || reason == SINEW_MAP_PINNED || reason == SINEW_MAP_TAKEN || reason == SINEW_MAP_END)
        continue;
      reason = any ? SINEW_MAP_FEWER_JOINTS : SINEW_MAP_NO_COUNTERPART;
    }
  };
  chain(target.spine, target.spine_count);
  for (int32_t k = 0; k < target.limbs.count; ++k)
    chain(target.limbs.joints + target.limb(k).first_joint, target.limb(k).joint_count);
}

// 0..1: how sure front and sides are; a rig without sides needs no front.
double certainty(const Anatomy& rig) {
  if (rig.limbs.pair_count == 0) return 0.5;
  return rig.sure / (rig.sure + 0.3);
}

// One map: reads both rigs, matches them by limbs or as branches, cleans up and explains.
class MapRun {
 public:
  MapRun(const MapPlan& plan, Arena& arena)
      : plan_(plan), arena_(arena), n_(plan.target.joint_count), m_(plan.source.joint_count) {}

  bool allocate() {
    (void)target_.allocate(arena_, n_);
    (void)source_.allocate(arena_, m_);
    (void)own_.allocate(arena_, n_);
    (void)published_.allocate(arena_, n_);
    pins_.source_of = arena_.alloc<int32_t>(n_);
    pins_.target_of = arena_.alloc<int32_t>(m_);
    owner_ = arena_.alloc<int32_t>(m_);
    reasons_ = arena_.alloc<uint8_t>(n_);
    return arena_.ok();
  }

  sinew_status read() {
    const bool names = plan_.target.names != nullptr && plan_.source.names != nullptr;
    sinew_status status = target_.rig.build(plan_.target, names);
    if (status == SINEW_OK) status = source_.rig.build(plan_.source, names);
    if (status == SINEW_OK) status = check_areas(plan_.options.target_areas, n_);
    if (status == SINEW_OK) status = check_areas(plan_.options.source_areas, m_);
    if (status != SINEW_OK) return status;
    target_.read_up(plan_.target);
    source_.read_up(plan_.source);
    read_pins(plan_, &pins_);
    for (uint32_t k = 0; k < plan_.options.pin_count; ++k) {  // one of two that say different things was overwritten
      const sinew_map_pin& pin = plan_.options.pins[k];
      if (pins_.source_of[pin.target] != pin.source ||
          (pin.source >= 0 && pins_.target_of[pin.source] != static_cast<int32_t>(pin.target))) {
        return SINEW_ERROR_RANGE;
      }
    }
    return SINEW_OK;
  }

  // By limbs. Where nothing tells end markers, leaves are some in all of a rig or in none: what makes the two rigs most
  // alike. False when the workspace is full.
  bool match_limbs() {
    const ArenaScope scope(arena_);
    Matcher matcher;
    if (!matcher.allocate(arena_, n_, m_)) return false;
    bool best_target = false, best_source = false;
    double least = 1e30;
    for (int guess = 0; guess < 4 && !arena_.measuring() && !target_.rig.has_names; ++guess) {
      const bool target_ends = (guess & 1) != 0, source_ends = (guess & 2) != 0;
      if ((target_ends && target_.rig.has_ends) || (source_ends && source_.rig.has_ends)) continue;
      if (target_.rig.has_ends && source_.rig.has_ends) break;
      if (!match(target_ends, source_ends, &matcher)) return false;
      const double doubt =
          unlikeness(target_.rig, source_.rig, own_.sources, owner_) + kGuess * (target_ends + source_ends);
      if (!(doubt < least)) continue;
      least = doubt;
      best_target = target_ends;
      best_source = source_ends;
    }
    if (!match(best_target, best_source, &matcher)) return false;
    if (arena_.measuring() || !target_.rig.has_names) return true;
    named_ = pin_plain_names(target_.rig, source_.rig, own_.sources, &pins_) ||
             pin_legless_names(target_.rig, source_.rig, own_.sources, &pins_);
    return !named_ || match(best_target, best_source, &matcher);
  }

  // As branches, where that is asked for or limbs say too little; nearly the same rigs as what they are.
  sinew_status match_branches() {
    const bool automatic = plan_.options.method == SINEW_MAP_AUTO, asked = plan_.options.method == SINEW_MAP_BRANCHES;
    same_ = automatic && !arena_.measuring() &&
            (is_same_rig(plan_.target, plan_.source, target_.rig, source_.rig, published_.sources, owner_) ||
             is_same_shape(target_.rig, source_.rig, published_.sources, owner_));
    method_ = SINEW_MAP_SINEW;
    // Rigs of which little could be read, such as an animal of a thousand spines, may be nearly equal all the same.
    const bool odd = automatic && !arena_.measuring() && !pins_.any && !same_ && says_little();
    double cost = kNotCompared;
    const sinew_status status = map_branches(plan_, target_.anatomy, source_.anatomy, asked || odd, arena_,
                                             published_.sources, published_.costs, &cost);
    if (status == SINEW_OK && (asked || cost < kNearlyEqual)) method_ = SINEW_MAP_BRANCHES;
    return status;
  }

  void write(sinew_map_outputs* outputs) {
    const Result& result = same_ || method_ == SINEW_MAP_BRANCHES ? published_ : own_;
    for (uint32_t i = 0; i < n_ && same_; ++i) published_.costs[i] = 0;
    Cleaner(target_.rig, source_.rig, pins_, result.sources, reasons_, owner_).run(method_ == SINEW_MAP_SINEW);
    if (named_) {  // only the caller's pins have this reason
      read_pins(plan_, &pins_);
      for (uint32_t i = 0; i < n_; ++i)
        if (pins_.source_of[i] == Pins::kFree && reasons_[i] == SINEW_MAP_PINNED) reasons_[i] = SINEW_MAP_FOUND;
    }
    explain(target_.anatomy, result.sources, reasons_);

    const double sure = same_ ? 1 : lesser(certainty(target_.anatomy), certainty(source_.anatomy));
    outputs->method = method_;
    outputs->mapped = mapped_count(result.sources, n_);
    outputs->certainty = static_cast<uint32_t>(kWhole * sure);
    for (uint32_t i = 0; i < n_; ++i) {
      outputs->sources[i] = result.sources[i];
      if (outputs->reasons != nullptr) outputs->reasons[i] = reasons_[i];
      if (outputs->confidence == nullptr) continue;
      const double side = target_.anatomy.side[i] != 0 ? sure : 1;
      double own_share = reasons_[i] == SINEW_MAP_PINNED ? 1 : side / (1 + greater(0, result.costs[i]));
      if (result.sources[i] < 0) own_share = 0;
      outputs->confidence[i] = static_cast<uint16_t>(kWhole * own_share);
    }
    outputs->used_bytes = arena_.high_water();
  }

 private:
  bool match(bool target_ends, bool source_ends, Matcher* matcher) {
    if (!arena_.measuring()) {
      target_.rig.take_leaves_as_ends(target_ends);
      source_.rig.take_leaves_as_ends(source_ends);
    }
    if (!target_.build(false, arena_) || !source_.build(false, arena_)) return false;
    if (arena_.measuring()) return true;
    if (pins_turn(target_.anatomy, source_.anatomy, plan_) && !target_.build(true, arena_)) return false;
    matcher->run(target_.anatomy, source_.anatomy, target_.rig.has_names, pins_, own_.sources, own_.costs);
    return true;
  }

  // Limbs found a source for few of the joints that could have one.
  bool says_little() const { return 10 * mapped_count(own_.sources, n_) < 6 * (n_ < m_ ? n_ : m_); }

  const MapPlan& plan_;
  Arena& arena_;
  const uint32_t n_, m_;  // joints of target and source
  Side target_, source_;
  Result own_, published_;  // by limbs; as branches, or of the same rig
  Pins pins_;
  int32_t* owner_ = nullptr;    // [m] scratch
  uint8_t* reasons_ = nullptr;  // [n]
  bool same_ = false, named_ = false;
  uint32_t method_ = SINEW_MAP_SINEW;
};

}  // namespace

sinew_status plan_map(const sinew_skeleton* target, const sinew_skeleton* source, const sinew_map_options* options,
                      MapPlan* plan) {
  constexpr uint32_t kFirstOptions = offsetof(sinew_map_options, branches_first);
  sinew_status status = read_skeleton(target, &plan->target);
  if (status == SINEW_OK) status = read_skeleton(source, &plan->source);
  plan->options = SINEW_INIT(sinew_map_options);
  if (status == SINEW_OK && options != nullptr)
    status = read_struct(options, kFirstOptions, sizeof plan->options, &plan->options);
  if (status != SINEW_OK) return status;
  const sinew_map_options& o = plan->options;
  if (o.method > SINEW_MAP_BRANCHES || (o.pin_count > 0 && o.pins == nullptr)) return SINEW_ERROR_ARGUMENT;
  if (o.method == SINEW_MAP_BRANCHES && !has_published_methods()) return SINEW_ERROR_NOT_BUILT;
  if (o.reserved != 0) return SINEW_ERROR_VERSION;
  const sinew_skeleton* const rigs[2] = {&plan->target, &plan->source};
  for (const sinew_skeleton* rig : rigs) {
    if (rig->joint_count == 0 || rig->joint_count > SINEW_MAX_JOINTS) return SINEW_ERROR_COUNT;
  }
  if (o.branches_first > SINEW_BRANCHES_SOURCE || o.branches_cost > SINEW_BRANCHES_SUM) return SINEW_ERROR_ARGUMENT;
  for (uint32_t k = 0; k < o.pin_count; ++k) {
    if (o.pins[k].target >= plan->target.joint_count || o.pins[k].source < -1 ||
        o.pins[k].source >= static_cast<int32_t>(plan->source.joint_count)) {
      return SINEW_ERROR_RANGE;
    }
  }
  return SINEW_OK;
}

sinew_status run_map(const MapPlan& plan, Arena& arena, sinew_map_outputs* outputs) {
  MapRun run(plan, arena);
  if (!run.allocate()) return SINEW_ERROR_WORKSPACE;
  if (!arena.measuring()) {
    const sinew_status status = run.read();
    if (status != SINEW_OK) return status;
  }
  if (!run.match_limbs()) return SINEW_ERROR_WORKSPACE;
  const sinew_status status = run.match_branches();
  if (status == SINEW_OK && !arena.measuring()) run.write(outputs);
  return status;
}

}  // namespace sinew::mapping
