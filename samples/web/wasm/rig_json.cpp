// SPDX-License-Identifier: MIT
// Skeletons as JSON: names tie the joints of a file to those of the skeleton that is edited.
#include "rig_json.hpp"

#include <map>
#include <string>
#include <utility>

#include "sinew_character/draw/image.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_character/rig/joint_mirror.hpp"

namespace sinew::web {

using Json = nlohmann::json;

namespace {

// The joint that has this one's name on the other side, or -1: of skeletons that are no mirror image of themselves too.
int32_t named_partner(const std::vector<Joint>& joints, size_t joint, const std::map<std::string, int32_t>& number) {
  const auto other = number.find(other_side_name(joints[joint].name));
  return other == number.end() || other->second == static_cast<int32_t>(joint) ? -1 : other->second;
}

// A limb that may be wrong: {name, joint, joints, doubt}.
Json doubt_json(const PredictedSkeleton& skeleton, const LimbDoubt& limb,
                const std::map<std::string, int32_t>& number) {
  const auto in_file = [&](int joint) { return number.at(skeleton.joints[static_cast<size_t>(joint)].name); };
  Json joints = Json::array();
  for (const int joint : limb.joints) joints.push_back(in_file(joint));
  return {{"name", limb.name}, {"joint", in_file(limb.joint)}, {"joints", std::move(joints)}, {"doubt", limb.doubt}};
}

}  // namespace

Json rig_json(const Rigs& rigs) {
  const Rig& rig = rigs.now();
  std::map<std::string, int32_t> number;
  for (size_t j = 0; j < rig.joints.size(); ++j) number.emplace(rig.joints[j].name, static_cast<int32_t>(j));
  Json joints = Json::array();
  for (size_t j = 0; j < rig.joints.size(); ++j) {
    const Joint& joint = rig.joints[j];
    joints.push_back({{"name", joint.name},
                      {"parent", joint.parent},
                      {"position", {joint.position.x, joint.position.y, joint.position.z}},
                      {"colour", joint_color(j)},
                      {"side", static_cast<int>(side_of_name(joint.name))},
                      {"end", false},
                      {"partner", -1},
                      {"named", named_partner(rig.joints, j, number)},
                      {"confidence", 1}});
  }
  Json reply = {{"predicted", rig.predicted}, {"editable", rig.skeleton.has_value()}};
  if (rig.skeleton) {
    const PredictedSkeleton& skeleton = *rig.skeleton;
    for (size_t k = 0; k < skeleton.joints.size(); ++k) {  // a file's joints may stand in another order
      Json& joint = joints[static_cast<size_t>(number.at(skeleton.joints[k].name))];
      const int32_t partner = skeleton.partners[k];
      joint["end"] = skeleton.ends[k] != 0;
      if (partner >= 0) joint["partner"] = number.at(skeleton.joints[static_cast<size_t>(partner)].name);
      joint["confidence"] = skeleton.confidence[k];
    }
    reply["mirrored"] = skeleton.mirrored;
    reply["axis"] = skeleton.facing % 2 != 0 ? 2 : 0;
    reply["plane"] = skeleton.plane;
    reply["spread"] = skeleton.spread;
    reply["doubtful"] = rig.predicted && skeleton.usable && *skeleton.usable < kDoubtfulUsable;
    reply["seconds"] = skeleton.seconds;
    if (rig.predicted) {
      reply["upAxis"] = skeleton.up_axis == Axis::kZ ? 1 : 0;
      reply["upSure"] = skeleton.up_confidence;
      reply["front"] = skeleton.front;
      reply["frontSure"] = skeleton.front_confidence;
    }
    reply["doubts"] = Json::array();
    if (rig.predicted)
      for (const LimbDoubt& limb : doubtful_limbs(skeleton))
        reply["doubts"].push_back(doubt_json(skeleton, limb, number));
  }
  reply["joints"] = std::move(joints);
  return reply;
}

std::vector<SkeletonEdit> read_edits(const Json& edits) {
  std::vector<SkeletonEdit> list;
  for (const Json& one : edits) {
    SkeletonEdit edit;
    edit.kind = static_cast<EditKind>(one.at("kind").get<int>());
    edit.joint = one.at("joint").get<std::string>();
    edit.other = one.value("other", std::string());
    if (one.contains("place")) {
      const Json& place = one.at("place");
      edit.position = {place.at(0).get<float>(), place.at(1).get<float>(), place.at(2).get<float>()};
    }
    list.push_back(std::move(edit));
  }
  return list;
}

}  // namespace sinew::web
