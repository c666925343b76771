// SPDX-License-Identifier: MIT
// Controls as JSON: formats/spec/controls.md.
#include <cmath>
#include <nlohmann/json.hpp>

#include "predict/turn.hpp"
#include "sinew_character/profile/controls.hpp"

namespace sinew {
namespace {

using OrderedJson = nlohmann::ordered_json;

// Six digits; no -0.
OrderedJson direction_json(const ControlDirection& direction, const Rotation& turn) {
  OrderedJson json = OrderedJson::array();
  for (const double x : turned(turn, direction)) json.push_back(std::round(1e6 * x) / 1e6 + 0.0);
  return json;
}

const char* side_text(int side) { return side > 0 ? "left" : side < 0 ? "right" : ""; }

class ControlText {
 public:
  ControlText(const ControlRig& rig, const std::vector<Joint>& joints, const Rotation& turn)
      : rig_(rig), joints_(joints), turn_(turn) {}

  OrderedJson json(const std::string& name) const {
    OrderedJson json = {{"sinew_controls", 1}, {"character", name}};
    json["up"] = direction_json(rig_.up, turn_);
    json["front"] = direction_json(rig_.front, turn_);
    json["limbs"] = OrderedJson::array();
    for (const ControlLimb& limb : rig_.limbs) json["limbs"].push_back(limb_json(limb));
    json["hips"] = named(rig_.hips);
    json["spine"] = names(rig_.spine);
    json["neck"] = names(rig_.neck);
    json["head"] = named(rig_.head);
    json["fingers"] = OrderedJson::array();
    for (const ControlFinger& finger : rig_.fingers)
      json["fingers"].push_back({{"name", finger.name},
                                 {"side", side_text(finger.side)},
                                 {"hand", named(finger.hand)},
                                 {"joints", names(finger.joints)},
                                 {"axis", direction_json(finger.axis, turn_)}});
    json["joints"] = OrderedJson::array();
    for (const Joint& joint : joints_)
      json["joints"].push_back(
          {{"name", joint.name}, {"position", {joint.position.x, joint.position.y, joint.position.z}}});
    json["notes"] = rig_.notes;
    return json;
  }

 private:
  std::string named(int joint) const { return joint < 0 ? std::string() : joints_[static_cast<size_t>(joint)].name; }
  OrderedJson names(const std::vector<int>& joints) const {
    OrderedJson json = OrderedJson::array();
    for (const int joint : joints) json.push_back(named(joint));
    return json;
  }
  OrderedJson limb_json(const ControlLimb& limb) const {
    return {{"name", limb.name},
            {"kind", limb.leg ? "leg" : "arm"},
            {"side", side_text(limb.side)},
            {"joints", names(limb.joints)},
            {"middle", named(limb.middle)},
            {"ball", named(limb.ball)},
            {"pole", direction_json(limb.pole, turn_)}};
  }

  const ControlRig& rig_;
  const std::vector<Joint>& joints_;
  const Rotation& turn_;
};

}  // namespace

std::string controls_text(const ControlRig& rig, const std::string& name, const std::vector<Joint>& joints,
                          const Rotation& turn) {
  // Names of strangers' files need not be UTF-8.
  return ControlText(rig, joints, turn).json(name).dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

std::string controls_text(const Character& character) {
  return controls_text(find_controls(character), character.name, character.joints);
}

std::string controls_extras(const std::string& text) {
  return OrderedJson({{"sinew_controls", OrderedJson::parse(text)}}).dump();
}

}  // namespace sinew
