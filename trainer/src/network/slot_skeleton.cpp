// SPDX-License-Identifier: MIT
// Mesh to graph, both networks, slots to joints in the caller's units.
#include "sinew_trainer/slot_skeleton.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "data/slot_sample.hpp"
#include "network/connection_tree.hpp"
#include "network/slot_network.hpp"
#include "rig/joint_names.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

using Point = std::array<double, 3>;

// Joints of slots; bone ends come behind the others.
struct Found {
  std::vector<uint32_t> slots;
  uint32_t bones = 0;        // that are no ends
  std::vector<int> parents;  // -1 for the root
  std::vector<double> confidence, parent_confidence;
};

struct Outputs {
  const std::vector<float>& values;
  double number(uint32_t slot, uint32_t n) const { return static_cast<double>(values[slot * kSlotNumbers + n]); }
  double connection(uint32_t a, uint32_t b) const {
    return static_cast<double>(values[kSlots * kSlotNumbers + slot_pair(std::min(a, b), std::max(a, b))]);
  }
};

// The slots that more likely than not hold a joint, or the likeliest one.
void choose_slots(const Outputs& outputs, const SlotSkeletonOptions& options, Found* found) {
  std::vector<uint32_t> ends;
  uint32_t likeliest = 0;
  for (uint32_t i = 0; i < kSlots; ++i) {
    const JointSlot& slot = joint_slots()[i];
    if (!in_category(slot, options.category) || (slot.joint_class == kClassToe && !slot.tip && !options.toes)) continue;
    const double presence = outputs.number(i, kSlotPresence);
    if (!slot.tip && presence > outputs.number(likeliest, kSlotPresence)) likeliest = i;
    if (presence <= 0.5 || (slot.tip && !options.ends)) continue;
    (slot.tip ? ends : found->slots).push_back(i);
  }
  if (found->slots.empty()) found->slots.push_back(likeliest);
  found->bones = static_cast<uint32_t>(found->slots.size());
  found->slots.insert(found->slots.end(), ends.begin(), ends.end());
}

// Joints that are no ends are joined by the lightest tree, from the pelvis if there is one; an end hangs on the joint that it
// is likeliest to hang on.
void join(const Outputs& outputs, Found* found) {
  std::vector<Connection> graph;
  for (uint32_t a = 0; a < found->bones; ++a)
    for (uint32_t b = a + 1; b < found->bones; ++b)
      graph.push_back({a, b, connection_weight(outputs.connection(found->slots[a], found->slots[b]))});
  found->parents = parents_from(0, found->bones, without_redundant(found->bones, graph));  // slot 0 is the pelvis'
  for (uint32_t end = found->bones; end < found->slots.size(); ++end) {
    uint32_t best = 0;
    for (uint32_t joint = 1; joint < found->bones; ++joint) {
      if (outputs.connection(found->slots[joint], found->slots[end]) >
          outputs.connection(found->slots[best], found->slots[end]))
        best = joint;
    }
    found->parents.push_back(static_cast<int>(best));
  }
  for (size_t j = 0; j < found->slots.size(); ++j) {
    found->confidence.push_back(outputs.number(found->slots[j], kSlotPresence));
    found->parent_confidence.push_back(
        found->parents[j] < 0
            ? 1.0
            : outputs.connection(found->slots[j], found->slots[static_cast<size_t>(found->parents[j])]));
  }
}

// Parents first; of equal depth in the order given.
std::vector<size_t> from_the_root(const std::vector<int>& parents) {
  std::vector<size_t> order;
  for (size_t j = 0; j < parents.size(); ++j)
    if (parents[j] < 0) order.push_back(j);
  for (size_t next = 0; next < order.size(); ++next)
    for (size_t j = 0; j < parents.size(); ++j)
      if (parents[j] == static_cast<int>(order[next])) order.push_back(j);
  return order;
}

// A place of the mirror frame in the mesh's units.
class Placer {
 public:
  Placer(const EngineMesh& engine, const MirrorFrame& frame) : frame_(frame) {
    Point low, high;
    for (size_t axis = 0; axis < 3; ++axis) low[axis] = high[axis] = static_cast<double>(engine.positions[axis]);
    for (size_t i = 0; i < engine.positions.size(); ++i) {
      const double x = static_cast<double>(engine.positions[i]);
      low[i % 3] = std::min(low[i % 3], x);
      high[i % 3] = std::max(high[i % 3], x);
    }
    for (size_t axis = 0; axis < 3; ++axis) {
      side_ = std::max(side_, high[axis] - low[axis]);
      zero_[axis] = axis == 1 ? low[axis] : 0.5 * (low[axis] + high[axis]);
    }
    if (side_ <= 0) side_ = 1;
  }
  Point place(const Point& p) const {
    Vec3i grid;
    int32_t* const to[3] = {&grid.x, &grid.y, &grid.z};
    for (size_t axis = 0; axis < 3; ++axis) *to[axis] = static_cast<int32_t>(std::clamp(p[axis], -2.0, 2.0) * kSide);
    const Vec3i at = frame_.from(grid);
    return {zero_[0] + side_ * at.x / kSide, zero_[1] + side_ * at.y / kSide, zero_[2] + side_ * at.z / kSide};
  }

 private:
  const MirrorFrame frame_;
  Point zero_{};
  double side_ = 0;
};

std::vector<std::array<char, kMaxJointName>> names_of(const Found& found, const std::vector<size_t>& order) {
  std::vector<int16_t> number(order.size());
  for (size_t i = 0; i < order.size(); ++i) number[order[i]] = static_cast<int16_t>(i);
  std::vector<RigJoint> joints;
  for (const size_t j : order) {
    const JointSlot& slot = joint_slots()[found.slots[j]];
    RigJoint joint{};
    joint.position.x = slot.side == SlotSide::kRight ? -1 : 1;
    joint.parent = found.parents[j] < 0 ? int16_t{-1} : number[static_cast<size_t>(found.parents[j])];
    joint.partner = -1;
    joint.joint_class = slot.joint_class;
    joint.tip = slot.tip ? 1 : 0;
    joints.push_back(joint);
  }
  std::vector<std::array<char, kMaxJointName>> names(order.size());
  name_joints(joints.data(), static_cast<uint32_t>(joints.size()),
              reinterpret_cast<char(*)[kMaxJointName]>(names.data()));
  return names;
}

}  // namespace

FloatNetwork read_slot_network(const std::string& path) {
  FloatNetwork network = read_checkpoint(path).network;
  check_slot_network(network, path);
  return network;
}

PredictedSkeleton predict_slots(const Character& character, const FloatNetwork& network,
                                const SlotSkeletonOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<Point> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint32_t> source;
  surface_of(for_slots(character), &vertices, &triangles, &source);
  for (Point& p : vertices)
    if (options.up_axis != 0) p = {p[0], p[2], -p[1]};
  EngineMesh engine(character.name, vertices, triangles);
  const MirrorFrame frame = engine.mirror_frame();
  apply_mirror_frame(frame, &engine.mesh);
  NetworkSample sample;
  sample.name = character.name;
  fill_slot_graph(engine.mesh, &sample);
  SlotRunner<float> runner;
  const Outputs outputs{runner.forward(network, copy_blocks<float>(network), sample, {})};

  Found found;
  choose_slots(outputs, options, &found);
  join(outputs, &found);
  const std::vector<size_t> order = from_the_root(found.parents);
  const auto names = names_of(found, order);
  const Placer placer(engine, frame);
  std::vector<int> number(order.size());
  for (size_t i = 0; i < order.size(); ++i) number[order[i]] = static_cast<int>(i);
  PredictedSkeleton result;
  for (size_t i = 0; i < order.size(); ++i) {
    const size_t j = order[i];
    const uint32_t slot = found.slots[j];
    const bool end = joint_slots()[slot].tip;
    const int parent = found.parents[j] < 0 ? -1 : number[static_cast<size_t>(found.parents[j])];
    Point p = placer.place({outputs.number(slot, 0), outputs.number(slot, 1), outputs.number(slot, 2)});
    if (options.up_axis != 0) p = {p[0], -p[2], p[1]};
    result.joints.push_back({names[i].data(),
                             {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])},
                             parent,
                             !end});
    result.classes.push_back(
        joint_slots()[end ? found.slots[static_cast<size_t>(found.parents[j])] : slot].joint_class);
    result.ends.push_back(end ? 1 : 0);
    result.partners.push_back(-1);
    result.confidence.push_back(static_cast<float>(found.confidence[j]));
    result.parent_confidence.push_back(static_cast<float>(found.parent_confidence[j]));
  }
  result.facing = frame.quarters;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace sinew
