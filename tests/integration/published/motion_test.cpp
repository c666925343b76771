// SPDX-License-Identifier: MIT
// What reference points are published for, by the command: hands that touch the body touch another one too, from the same mesh, from
// another mesh and from a skeleton alone.
#include "sinew_formats/motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"

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
  Quaternion q = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
                  1 + a[0] * b[0] + a[1] * b[1] + a[2] * b[2]};
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& x : q) x /= size;
  return q;
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
    constexpr double kCloser = 0.02;
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
        const Quaternion upper =
            turn_between({side * 0.278, -0.145, 0}, {side * 0.25, -0.45 + 0.02 * f, 0.9 - kCloser * f});
        const Quaternion fore =
            turn_between({side * 0.256, -0.133, 0.02}, {-side * 0.8, -0.2 + 0.02 * f, 0.1 - kCloser * f});
        frame.rotations[j] = upper;
        frame.rotations[j + 1] = product({-upper[0], -upper[1], -upper[2], upper[3]}, fore);
      }
      clip.frames.push_back(frame);
    }
    motion.clips.push_back(clip);
    write_bvh(in("hug.bvh"), motion, motion.clips[0]);
    Character hero = read_character(kData + "/biped__robed.obj"), broad = hero;
    write_gltf(in("hero.glb"), hero);
    broaden(&broad);
    write_gltf(in("broad.glb"), broad);
    good("animate hero.glb --motion hug.bvh --method copy -o hugging.glb");
  }
  static void broaden(Character* character) {
    for (Vec3& v : character->vertices) v = {1.3f * v.x, v.y, 1.7f * v.z};
    for (Joint& j : character->joints) j.position = {1.3f * j.position.x, j.position.y, 1.7f * j.position.z};
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
  EXPECT_LT(drawn.contact, 0.9 * copied.contact) << copied.contact;
  EXPECT_LE(drawn.deep, copied.deep + copied.frames / 40);
}

// The same surface with its faces in another order is another mesh: the points that correspond are found on it.
TEST_F(PublishedMotion, ABodyOfAnotherMeshIsAsGood) {
  Character other = read_character(kData + "/biped__robed.obj");
  broaden(&other);
  const Character broad = other;
  other.face_vertices.clear();
  other.face_offsets.assign(1, 0);
  for (size_t first = 0; first < 3; ++first) {
    for (size_t f = first; f < broad.face_count(); f += 3) {
      for (size_t c = broad.face_offsets[f]; c < broad.face_offsets[f + 1]; ++c)
        other.face_vertices.push_back(broad.face_vertices[c]);
      other.face_offsets.push_back(static_cast<uint32_t>(other.face_vertices.size()));
    }
  }
  write_gltf(in("other.glb"), other);
  const std::string call = "other.glb --motion hugging.glb" + kPoints;
  const Outcome told = good("animate " + call + " -o out.glb");
  EXPECT_NE(told.out.find("its body has another mesh"), std::string::npos) << told.out;
  const Arms copied = arms(call, "before"), drawn = arms(call, "after");
  ASSERT_GE(copied.contacts, 6u);
  EXPECT_LT(drawn.contact, 0.9 * copied.contact) << copied.contact;
  EXPECT_LE(drawn.deep, copied.deep + copied.frames / 40);
}

TEST_F(PublishedMotion, ASkeletonAloneGetsABody) {
  for (const std::string& target : {std::string("broad.glb"), kCaped}) {
    const std::string call = target + " --motion hug.bvh" + kPoints;
    const Arms copied = arms(call, "before"), drawn = arms(call, "after");
    EXPECT_LE(drawn.deep, copied.deep) << target;
    const Outcome told = good("animate " + call + " -o drawn.glb");
    EXPECT_NE(told.out.find("capsules around the bones"), std::string::npos) << told.out;
  }
  good("animate broad.glb --motion hug.bvh --method copy -o copied.glb");
  good("animate broad.glb --motion hug.bvh" + kPoints + " -o drawn.glb");
  EXPECT_TRUE(slurp(in("drawn.glb")) != slurp(in("copied.glb"))) << "arms come out of the body";
}

}  // namespace
}  // namespace sinew
