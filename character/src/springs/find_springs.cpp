// SPDX-License-Identifier: MIT
// Finds chains by joint names, then by the branches of a body whose limbs are known.
#include "sinew_character/springs/find_springs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/upright_body.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/document_form.hpp"
#include "sinew_formats/error.hpp"
#include "springs/body_skin.hpp"
#include "springs/swing_words.hpp"

namespace sinew {
namespace {

constexpr float kSureClass = 0.95f, kSureWord = 0.9f, kSureShape = 0.6f, kUnsure = 0.3f;
constexpr double kLongHair = 0.22;     // of the height
constexpr double kLeastLength = 0.02;  // of the height that a chain is long: shorter ones are details of a face
constexpr double kLeastSkin = 0.5;     // weight of a chain, in vertices
constexpr double kShapeLength = 0.06;  // the same without names
constexpr double kOwnEar = 0.06;       // of the height that a person's ear is shorter than
constexpr double kFloor = 0.06;        // of the height over the floor a foot's end is
constexpr double kTipPercentile = 0.95;

bool is_trunk(uint8_t c) {
  return c == SINEW_CLASS_PELVIS || c == SINEW_CLASS_SPINE || c == SINEW_CLASS_NECK || c == SINEW_CLASS_HEAD;
}
bool is_body(uint8_t c) {
  return is_trunk(c) || (c >= SINEW_CLASS_CLAVICLE && c <= SINEW_CLASS_TOE) || c == SINEW_CLASS_WING ||
         (c >= SINEW_CLASS_THUMB && c <= SINEW_CLASS_PROP);
}
// A wing that no map needs and a thing that is held may go with a chain.
bool is_firm_body(uint8_t c) { return is_body(c) && c != SINEW_CLASS_WING && c != SINEW_CLASS_PROP; }

class SpringFinder {
 public:
  explicit SpringFinder(const Character& character)
      : c_(character),
        verdicts_(joint_verdicts(character.joints, follows_of(character))),
        tree_(character.joints),
        held_(followers_of(character)),
        height_(height_of(character)),
        up_(up_of(character)) {
    leave_humanoid();
    knows_legs_ = std::count(verdicts_.classes.begin(), verdicts_.classes.end(), SINEW_CLASS_THIGH) >= 2;
    shapes_ = knows_legs_ ? verdicts_.classes : limb_classes(map_rig_of(character), character.up);
    if (!knows_legs_) knows_legs_ = stands_upright();
    used_.assign(character.joints.size(), 0);
    weight_.assign(character.joints.size(), 0);
    for (const std::vector<Influence>& row : character.influences)
      for (const Influence& one : row) weight_[one.joint] += static_cast<double>(one.weight);
    for (const Joint& joint : character.joints) stiff_.push_back(names_stiff_thing(joint.name) ? 1 : 0);
    // A word that most names contain is the character's name: a horn monster's.
    if (2 * std::count(stiff_.begin(), stiff_.end(), 1) > static_cast<std::ptrdiff_t>(stiff_.size()))
      stiff_.assign(stiff_.size(), 0);
    names_.resize(character.joints.size());
    for (size_t j = 0; j < names_.size(); ++j) names_[j] = name_kind(j);
  }

  std::vector<FoundChain> find() {
    for (const size_t j : tree_.parents_first)
      if (names_[j].certainty > 0 && used_[j] == 0 && ends_freely(j)) add_named(j);
    if (knows_body())
      for (const size_t j : tree_.parents_first)
        if (used_[j] == 0 && hangs_off(j)) add_unnamed(j);
    std::stable_sort(out_.begin(), out_.end(), [](const FoundChain& a, const FoundChain& b) {
      return a.chain.joints[0].joint < b.chain.joints[0].joint;
    });
    return std::move(out_);
  }

 private:
  struct NameKind {
    SpringKind kind = SpringKind::kRibbon;
    float certainty = 0;
    std::string reason;
  };

  // A VRM says which joints are its body: those of its humanoid and what carries them. No other is, whatever its name: spine.002 of a tail, hips.002
  // of a skirt.
  void leave_humanoid() {
    const std::vector<std::string> bones = vrm_file_bones(c_);
    if (bones.empty()) return;
    std::vector<uint8_t> carries(bones.size(), 0);
    for (size_t i = tree_.parents_first.size(); i-- > 0;) {
      const size_t j = tree_.parents_first[i];
      if (!bones[j].empty()) carries[j] = 1;
      if (carries[j] != 0 && c_.joints[j].parent >= 0) carries[joint_index(c_.joints[j].parent)] = 1;
      uint8_t& joint_class = verdicts_.classes[j];
      if (carries[j] == 0 && is_firm_body(joint_class)) joint_class = SINEW_CLASS_OTHER;
    }
  }

  bool stands_upright() const {
    std::vector<Point3> positions;
    for (const Joint& joint : c_.joints) positions.push_back(point(joint.position));
    const std::optional<UprightBody> body = find_upright_body(c_.joints, shapes_);
    return body && is_upright(*body, positions);
  }

  Point3 at(size_t joint) const { return point(c_.joints[joint].position); }
  const std::vector<int>& children(size_t joint) const { return tree_.children[joint]; }

  bool is_stiff(size_t j) const {
    const uint8_t role = verdicts_.roles[j];
    return role == SINEW_ROLE_CONTROL || role == SINEW_ROLE_SLOT || role == SINEW_ROLE_FACE ||
           role == SINEW_ROLE_FINGER || role == SINEW_ROLE_TWIST || stiff_[j] != 0;
  }

  NameKind name_kind(size_t j) const {
    const uint8_t joint_class = verdicts_.classes[j], role = verdicts_.roles[j];
    if (role == SINEW_ROLE_CONTROL || role == SINEW_ROLE_SLOT || stiff_[j] != 0) return {};
    const std::optional<SwingWord> word = swing_word(c_.joints[j].name);
    if (joint_class == SINEW_CLASS_HAIR) return {SpringKind::kHair, kSureClass, "its joints' class is hair"};
    if (joint_class == SINEW_CLASS_EAR) return {SpringKind::kEar, kSureClass, "its joints' class is ear"};
    if (joint_class == SINEW_CLASS_TAIL && !(word && word->kind != SpringKind::kTail))
      return {SpringKind::kTail, kSureClass, "its joints' class is tail"};
    // CoatSkirtBack is a skirt, whatever else its back says; a DressLeftToe is a toe.
    if (!word || (is_body(joint_class) && !is_trunk(joint_class))) return {};
    if (is_trunk(joint_class) && c_.joints[j].parent < 0) return {};
    return {word->kind, kSureWord, "its joints are called " + word->word};
  }

  // No joint of the body lies below.
  bool ends_freely(size_t j) const {
    for (const int child : children(j)) {
      const size_t k = joint_index(child);
      const uint8_t c = verdicts_.classes[k];  // fins of a tail and things that it holds go with it
      const bool body = is_firm_body(c) && names_[k].certainty == 0;
      if ((body && !verdicts_.is_end(k)) || !ends_freely(k)) return false;
    }
    return true;
  }

  double reach_below(size_t j) const {
    double most = 0;
    for (const int child : children(j))
      most = std::max(most, length(at(joint_index(child)) - at(j)) + reach_below(joint_index(child)));
    return most;
  }

  // The joints from `first` down; where it forks, the longer branch goes on and `fork` gets the others.
  template <class Goes, class Fork>
  std::vector<size_t> chain_from(size_t first, Goes goes, Fork fork) {
    std::vector<size_t> joints = {first};
    used_[first] = 1;
    for (;;) {
      std::vector<size_t> next;
      for (const int child : children(joints.back()))
        if (used_[joint_index(child)] == 0 && goes(joint_index(child))) next.push_back(joint_index(child));
      if (next.empty()) return joints;
      const auto longest = std::max_element(next.begin(), next.end(),
                                            [&](size_t a, size_t b) { return reach_below(a) < reach_below(b); });
      const size_t chosen = *longest;
      for (const size_t other : next)
        if (other != chosen) fork(other);
      joints.push_back(chosen);
      used_[chosen] = 1;
    }
  }

  void add_named(size_t first) {
    const NameKind kind = names_[first];
    std::vector<size_t> forks;
    const auto goes = [&](size_t j) {
      return names_[j].certainty > 0 ? names_[j].kind == kind.kind : !is_stiff(j) && !is_body(verdicts_.classes[j]);
    };
    // The common parent of several chains is their base and holds still: one of them would rotate all others.
    std::vector<size_t> begins;
    for (const int child : children(first))
      if (const size_t j = joint_index(child);
          used_[j] == 0 && goes(j) && (names_[j].certainty > 0 || !children(j).empty()))
        begins.push_back(j);
    if (begins.size() > 1) {
      used_[first] = 1;
      for (const size_t j : begins) {
        if (names_[j].certainty == 0) names_[j] = kind;
        add_named(j);
      }
      return;
    }
    const std::vector<size_t> joints = chain_from(first, goes, [&](size_t j) { forks.push_back(j); });
    add(joints, kind.kind, kind.certainty, kind.reason);
    for (const size_t fork : forks) {
      if (used_[fork] != 0) continue;
      if (names_[fork].certainty == 0 && children(fork).empty()) continue;  // a detail that goes with its joint
      if (names_[fork].certainty == 0) names_[fork] = kind;
      add_named(fork);
    }
  }

  bool knows_body() const {
    const auto has = [&](uint8_t c) { return std::count(shapes_.begin(), shapes_.end(), c) >= 2; };
    return has(SINEW_CLASS_THIGH) && has(SINEW_CLASS_UPPER_ARM);
  }
  bool is_other(size_t j) const {
    return (shapes_[j] == SINEW_CLASS_OTHER || !is_body(shapes_[j])) && !is_body(verdicts_.classes[j]) &&
           !is_stiff(j) && verdicts_.roles[j] != SINEW_ROLE_HELPER && verdicts_.roles[j] != SINEW_ROLE_ROOT;
  }
  bool all_other_below(size_t j) const {
    return is_other(j) && std::all_of(children(j).begin(), children(j).end(),
                                      [&](int child) { return all_other_below(joint_index(child)); });
  }
  bool hangs_off(size_t j) const {
    const int parent = c_.joints[j].parent;
    return parent >= 0 && is_trunk(shapes_[joint_index(parent)]) && all_other_below(j) && !children(j).empty() &&
           !held_[j].empty();
  }

  void add_unnamed(size_t first) {
    std::vector<size_t> forks;
    const std::vector<size_t> joints = chain_from(
        first, [](size_t) { return true; }, [&](size_t j) { forks.push_back(j); });
    const uint8_t on = shapes_[joint_index(c_.joints[first].parent)];
    const Point3 along = at(joints.back()) - at(first);
    const double lowest = lowest_vertex(), tip = dot(at(joints.back()), up_) - lowest;
    if (length(along) < kShapeLength * height_ || joints.size() < 3) return;
    if (!forks.empty()) return;                                      // a head that no name tells
    if (on == SINEW_CLASS_PELVIS && tip < kFloor * height_) return;  // stands on it: a leg
    const bool rises = dot(unit(along), up_) > 0.5;
    SpringKind kind = SpringKind::kRibbon;
    if (on == SINEW_CLASS_HEAD || on == SINEW_CLASS_NECK) kind = rises ? SpringKind::kEar : SpringKind::kHair;
    if (on == SINEW_CLASS_PELVIS || on == SINEW_CLASS_SPINE) {
      const size_t beside = unnamed_beside(first);
      if (on == SINEW_CLASS_PELVIS)
        kind = beside >= 4 ? SpringKind::kSkirt : beside == 1 ? SpringKind::kTail : SpringKind::kRibbon;
      if (on == SINEW_CLASS_SPINE && beside >= 2) kind = SpringKind::kCape;
    }
    // A body that is laid over a rig without names and does not stand upright may be a spider's: there only a lone tail is sure.
    const bool sure = kind == SpringKind::kTail || (knows_legs_ && kind != SpringKind::kRibbon);
    add(joints, kind, sure ? kSureShape : kUnsure,
        std::string("not part of the body, with a free end and skin off the ") + joint_class_text(on));
  }
  // How many such chains have the same parent.
  size_t unnamed_beside(size_t first) const {
    size_t count = 0;
    for (const int other : children(joint_index(c_.joints[first].parent))) {
      const size_t j = joint_index(other);
      if (names_[j].certainty == 0 && all_other_below(j) && !children(j).empty()) ++count;
    }
    return count;
  }
  double lowest_vertex() const {
    double low = c_.vertices.empty() ? 0 : dot(point(c_.vertices[0]), up_);
    for (const Vec3& p : c_.vertices) low = std::min(low, dot(point(p), up_));
    return low;
  }

  // Where the skin of a chain's last joint ends; nullopt where it holds none.
  std::optional<Point3> skin_end(const std::vector<size_t>& joints) const {
    const size_t last = joints.back();
    if (held_[last].empty()) return std::nullopt;
    Point3 middle{};
    for (const uint32_t v : held_[last]) middle = middle + point(c_.vertices[v]);
    middle = (1.0 / static_cast<double>(held_[last].size())) * middle;
    Point3 direction = joints.size() > 1 ? at(last) - at(joints[joints.size() - 2]) : middle - at(last);
    if (dot(direction, middle - at(last)) <= 0) direction = middle - at(last);
    direction = unit(direction);
    std::vector<double> along;
    for (const uint32_t v : held_[last]) along.push_back(dot(point(c_.vertices[v]) - at(last), direction));
    const size_t rank = static_cast<size_t>(kTipPercentile * static_cast<double>(along.size() - 1));
    std::nth_element(along.begin(), along.begin() + static_cast<std::ptrdiff_t>(rank), along.end());
    if (!(along[rank] > 0.2 * kLeastLength * height_)) return std::nullopt;
    return along[rank] * direction;
  }

  void add(const std::vector<size_t>& joints, SpringKind kind, float certainty, const std::string& reason) {
    FoundChain found;
    for (const size_t j : joints) found.chain.joints.push_back({j});
    found.chain.name = c_.joints[joints[0]].name;
    if (!verdicts_.is_end(joints.back())) found.chain.end = skin_end(joints);
    if (found.chain.turning_joints() == 0) return;
    found.kind = kind;
    found.reason = reason;
    found.certainty = certainty;
    found.length = chain_length(found.chain, c_.joints);
    double skin = 0;
    for (const size_t j : joints) skin += weight_[j];
    const bool has_skin = skin >= kLeastSkin;
    if (!has_skin) {
      found.certainty = kUnsure;
      found.reason += ", but no skin follows it";
    } else if (kind == SpringKind::kEar && joints.size() == 1 && found.length < kOwnEar * height_) {
      found.certainty = kUnsure;
      found.reason += ", but it is as short as a person's";
    } else if (kind == SpringKind::kBust && joints.size() == 1 &&
               c_.joints[joints[0]].name.find("Sec") == std::string::npos) {
      found.certainty = kUnsure;
      found.reason += ", but one joint alone may be part of a chest";
    } else if (found.length < kLeastLength * height_ && kind != SpringKind::kBust) {
      found.certainty = kUnsure;
      found.reason += ", but it is shorter than 2 % of the height";
    }
    if (kind == SpringKind::kHair && found.length > kLongHair * height_) found.kind = SpringKind::kLongHair;
    found.kept = found.certainty >= kKeptCertainty;
    preset_chain(found.kind, c_, &found.chain);
    out_.push_back(std::move(found));
  }

  const Character& c_;
  JointVerdicts verdicts_;
  const JointTree tree_;
  const std::vector<std::vector<uint32_t>> held_;
  const double height_;
  const Point3 up_;
  bool knows_legs_ = false;      // names tell its legs, or it stands on them as a person does
  std::vector<uint8_t> shapes_;  // [J] classes by names, of a rig without names by a body that is laid over it
  std::vector<NameKind> names_;  // [J]
  std::vector<uint8_t> stiff_;   // [J] 1: its name is that of a thing that does not swing
  std::vector<uint8_t> used_;    // [J] 1: in a chain, or the base of some
  std::vector<double> weight_;   // [J] of all vertices
  std::vector<FoundChain> out_;
};

}  // namespace

std::vector<FoundChain> find_springs(const Character& character) {
  if (character.joints.empty())
    throw Error(character.name + ": has no skeleton that could swing; rig it first with sinew rig");
  if (character.influences.empty())
    throw Error(character.name + ": has a skeleton but no skin weights; bind it first with sinew bind");
  return SpringFinder(character).find();
}

SpringKind kind_of_chain(const SpringChain& chain, const Character& character) {
  const std::optional<SwingWord> of_joint = swing_word(character.joints[chain.joints[0].joint].name),
                                 word = of_joint ? of_joint : swing_word(chain.name);
  if (!word) return SpringKind::kRibbon;
  if (word->kind == SpringKind::kHair && chain_length(chain, character.joints) > kLongHair * height_of(character))
    return SpringKind::kLongHair;
  return word->kind;
}

}  // namespace sinew
