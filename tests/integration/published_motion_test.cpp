// SPDX-License-Identifier: MIT
// What reference points are published for, by the command: hands that touch the body touch another one too, from the same mesh, from
// another mesh and from a skeleton alone.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

using Direction = std::array<double, 3>;

Quaternion turn_between(Direction a, Direction b) {
  const auto scaled = [](Direction* v) {
    const double size = std::sqrt((*v)[0] * (*v)[0] + (*v)[1] * (*v)[1] + (*v)[2] * (*v)[2]);
    for (double& x : *v) x /= size;
  };
  scaled(&a);
  scaled(&b);
  return normalised({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
                     1 + a[0] * b[0] + a[1] * b[1] + a[2] * b[2]});
}
Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

struct Arms {
  double contact = 0;  // mean of the arms' errors over their contact frames
  uint32_t contacts = 0, deep = 0, frames = 0;
};

class PublishedMotion : public Cli {
 protected:
  // Both hands of the robed biped come to its belly and stroke up to the chest; as hug.bvh.
  void SetUp() override {
    Cli::SetUp();
    Character biped;
    read_skeleton(kData + "/biped__robed.rig.txt", false, &biped);
    Motion motion = motion_of(biped.joints);
    motion.name = "hug";
    Clip clip = {"hug", 0.05, {}};
    for (int f = 0; f < 12; ++f) {
      MotionFrame frame;
      for (const MotionJoint& joint : motion.joints) {
        frame.rotations.push_back(kNoRotation4);
        frame.translations.push_back(joint.offset);
      }
      for (size_t j = 0; j < motion.joints.size(); ++j) {
        const std::string& name = motion.joints[j].name;
        if (name.rfind("upper_arm", 0) != 0) continue;
        const double side = name.back() == 'L' ? 1 : -1;
        const Quaternion upper = turn_between({side * 0.278, -0.145, 0}, {side * 0.25, -0.6 + 0.02 * f, 0.55});
        const Quaternion fore = turn_between({side * 0.256, -0.133, 0.02}, {-side * 0.9, -0.25 + 0.04 * f, -0.1});
        frame.rotations[j] = upper;
        frame.rotations[j + 1] = product({-upper[0], -upper[1], -upper[2], upper[3]}, fore);
      }
      clip.frames.push_back(frame);
    }
    motion.clips.push_back(clip);
    write_bvh(in("hug.bvh"), motion, motion.clips[0]);
    Character hero = read_character(kData + "/biped__robed.obj"), broad = hero;
    write_gltf(in("hero.glb"), hero);
    for (Vec3& v : broad.vertices) v = {1.3f * v.x, v.y, 1.7f * v.z};
    for (Joint& j : broad.joints) j.position = {1.3f * j.position.x, j.position.y, 1.7f * j.position.z};
    write_gltf(in("broad.glb"), broad);
    good("animate hero.glb --motion hug.bvh --method copy -o hugging.glb");
  }
  // "before" is the copy, "after" what the method left.
  Arms arms(const std::string& call, const std::string& which) {
    const nlohmann::json told = nlohmann::json::parse(good("animate " + call + " --measure --json -o out.glb").out);
    Arms sum;
    for (const auto& limb : told["clips"][0]["report"]) {
      if (limb["limb"] != "arm") continue;
      const auto& own = limb[which];
      const uint32_t contacts = own["contact_frames"];
      sum.contact += contacts * own["error"].get<double>();
      sum.contacts += contacts;
      sum.deep += own["deep_frames"].get<uint32_t>();
      sum.frames += told["clips"][0]["frames"].get<uint32_t>();
    }
    if (sum.contacts > 0) sum.contact /= sum.contacts;
    return sum;
  }
  const std::string kPoints = " --method reference-points";
};

TEST_F(PublishedMotion, HandsTouchABroaderBodyBetterThanByCopying) {
  const std::string call = "broad.glb --motion hugging.glb" + kPoints;
  const Arms copied = arms(call, "before"), drawn = arms(call, "after");
  ASSERT_GE(copied.contacts, 6u);
  EXPECT_LT(drawn.contact, 0.8 * copied.contact) << copied.contact;
  EXPECT_LE(drawn.deep, copied.deep);
}

TEST_F(PublishedMotion, ABodyOfAnotherMeshIsNoWorseThanCopying) {
  const std::string call = kCaped + " --motion hugging.glb" + kPoints;
  const Arms copied = arms(call, "before"), drawn = arms(call, "after");
  ASSERT_GE(copied.contacts, 6u);
  EXPECT_LE(drawn.contact, copied.contact);
  EXPECT_LE(drawn.deep, copied.deep);
}

TEST_F(PublishedMotion, ASkeletonAloneGetsABody) {
  for (const std::string& target : {std::string("broad.glb"), kCaped}) {
    const std::string call = target + " --motion hug.bvh" + kPoints;
    const Arms copied = arms(call, "before"), drawn = arms(call, "after");
    EXPECT_LE(drawn.deep, copied.deep) << target;
    good("animate " + call + " -o drawn.glb");
    good("animate " + target + " --motion hug.bvh --method copy -o copied.glb");
    EXPECT_NE(slurp(in("drawn.glb")), slurp(in("copied.glb"))) << target;
  }
}

}  // namespace
}  // namespace sinew
