// SPDX-License-Identifier: MIT
// USD as other programs write it: other units and axes, quads, transforms of all kinds, joints by their own order.
#include "usd/gltf_from_usd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"
#include "usd/usd_package.hpp"

namespace sinew {
namespace {

constexpr const char* kJoints = R"(
    def Skeleton "Skel"
    {
        uniform token[] joints = ["Hip", "Hip/Knee"]
        uniform matrix4d[] bindTransforms = [( (1,0,0,0), (0,1,0,0), (0,0,1,0), (0,0,100,1) ), ( (1,0,0,0), (0,1,0,0), (0,0,1,0), (0,0,50,1) )]
        uniform matrix4d[] restTransforms = [( (1,0,0,0), (0,1,0,0), (0,0,1,0), (0,0,100,1) ), ( (1,0,0,0), (0,1,0,0), (0,0,1,0), (0,0,-50,1) )]
    }
)";

// A leg of two joints in centimetres, z up: a quad and a triangle, whose joints have an order of their own.
std::string leg(const std::string& more = "") {
  return R"(#usda 1.0
(
    metersPerUnit = 0.01
    upAxis = "Z"
    timeCodesPerSecond = 24
)
def SkelRoot "Leg" ( prepend apiSchemas = ["SkelBindingAPI"] )
{
    double3 xformOp:translate = (10, 0, 0)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    rel skel:skeleton = </Leg/Skel>
    rel skel:animationSource = </Leg/Kick>
)" + std::string(kJoints) +
         R"(
    def SkelAnimation "Kick"
    {
        uniform token[] joints = ["Hip/Knee"]
        quatf[] rotations.timeSamples = { 24: [(1, 0, 0, 0)], 48: [(0.70710677, 0.70710677, 0, 0)] }
        half3[] scales = [(1, 1, 1)]
        float3[] translations = [(0, 0, -50)]
    }
    def Mesh "Skin" ( prepend apiSchemas = ["SkelBindingAPI"] )
    {
        int[] faceVertexCounts = [4, 3]
        int[] faceVertexIndices = [0, 1, 2, 3, 3, 2, 4]
        point3f[] points = [(0, 0, 0), (10, 0, 0), (10, 0, 50), (0, 0, 50), (5, 0, 100)]
        texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 0.5)] ( interpolation = "faceVarying" )
        int[] primvars:st:indices = [0, 1, 2, 2, 2, 2, 0]
        uniform token[] skel:joints = ["Hip/Knee", "Hip"]
        int[] primvars:skel:jointIndices = [0, 1, 0, 1, 0, 1, 0, 1, 0, 1] ( elementSize = 2
            interpolation = "vertex" )
        float[] primvars:skel:jointWeights = [1, 0, 1, 0, 0.5, 0.5, 1, 1, 0, 1] ( elementSize = 2 )
)" + more +
         R"(
    }
}
)";
}

class GltfFromUsd : public ::testing::Test {
 protected:
  TempFolder folder_;
};

TEST_F(GltfFromUsd, ReadsUnitsAxesPolygonsAndJointsOfTheMesh) {
  const Character leg_read = read_gltf(folder_.write("leg.usda", leg()));
  ASSERT_EQ(leg_read.joints.size(), 2u);
  EXPECT_EQ(leg_read.joints[0].name, "Hip");
  EXPECT_NEAR(leg_read.joints[0].position.x, 0.1, 1e-6);
  EXPECT_NEAR(leg_read.joints[0].position.y, 1, 1e-6);
  EXPECT_NEAR(leg_read.joints[1].position.y, 0.5, 1e-6);
  EXPECT_EQ(leg_read.joints[1].parent, 0);
  ASSERT_EQ(leg_read.vertices.size(), 5u);
  EXPECT_EQ(leg_read.face_count(), 3u);
  float high = 0;
  for (size_t v = 0; v < 5; ++v) {
    const Vec3& p = leg_read.vertices[v];
    high = std::max(high, p.y);
    const auto& row = leg_read.influences[v];
    if (p.y < 0.01f) {
      ASSERT_EQ(row.size(), 1u);
      EXPECT_EQ(row[0].joint, 1u);
    } else if (p.y < 0.6f) {
      ASSERT_EQ(row.size(), 2u);
      EXPECT_NEAR(row[0].weight, 0.5, 1e-6);
    } else {
      EXPECT_EQ(row[0].joint, 0u);
    }
  }
  EXPECT_NEAR(high, 1, 1e-6);
}

TEST_F(GltfFromUsd, ReadsTheAnimationFromItsFirstKeyOn) {
  const Motion kick = read_motion(folder_.write("leg.usda", leg()), 24);
  ASSERT_EQ(kick.clips.size(), 1u);
  EXPECT_EQ(kick.clips[0].name, "Kick");
  ASSERT_EQ(kick.clips[0].frames.size(), 25u);
  const Quaternion& last = kick.clips[0].frames[24].rotations[1];
  EXPECT_NEAR(std::abs(last[3]), 0.70710677, 1e-5);
}

TEST_F(GltfFromUsd, ReadsTransformsOfAllKinds) {
  const std::string text = R"(#usda 1.0
( metersPerUnit = 1 )
def Xform "A"
{
    float xformOp:rotateZ = 90
    double3 xformOp:translate:pivot = (1, 0, 0)
    uniform token[] xformOpOrder = ["xformOp:translate:pivot", "xformOp:rotateZ", "!invert!xformOp:translate:pivot"]
    def Mesh "M"
    {
        float3 xformOp:scale = (2, 2, 2)
        uniform token[] xformOpOrder = ["xformOp:scale"]
        uniform token orientation = "leftHanded"
        int[] faceVertexCounts = [3]
        int[] faceVertexIndices = [0, 1, 2]
        point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
    }
    def Mesh "Guide" { token purpose = "guide" int[] faceVertexCounts = [3] int[] faceVertexIndices = [0, 0, 0] point3f[] points = [(9, 9, 9)] }
}
)";
  const Character read = read_mesh(folder_.write("a.usda", text));
  ASSERT_EQ(read.vertices.size(), 3u);
  // (1, 0, 0) is 2 along x, less the pivot 1, turned to 1 along y, and the pivot again.
  const auto has = [&](float x, float y) {
    return std::any_of(read.vertices.begin(), read.vertices.end(),
                       [&](const Vec3& p) { return std::abs(p.x - x) < 1e-5f && std::abs(p.y - y) < 1e-5f; });
  };
  EXPECT_TRUE(has(1, 1));
  EXPECT_TRUE(has(1, -1));
  EXPECT_TRUE(has(-1, -1));
}

TEST_F(GltfFromUsd, TellsWhatItLeavesOut) {
  std::string text = leg("variantSet \"v\" = { \"a\" {} }\n asset inputs:x = @y@");
  text.replace(text.find("upAxis"), 0, "subLayers = [@./other.usda@]\n");
  const Character read = read_gltf(folder_.write("leg.usda", text));
  std::string notes;
  for (const std::string& note : read.notes) notes += note + "\n";
  EXPECT_NE(notes.find("references"), std::string::npos) << notes;
  EXPECT_NE(notes.find("variants"), std::string::npos) << notes;
}

TEST_F(GltfFromUsd, RefusesArraysThatDoNotFit) {
  const auto refuses = [&](const std::string& what, const std::string& with, const std::string& expected) {
    std::string text = leg();
    ASSERT_NE(text.find(what), std::string::npos);
    text.replace(text.find(what), what.size(), with);
    EXPECT_ERROR(read_gltf(folder_.write("leg.usda", text)), "leg.usda", expected);
  };
  refuses("[0, 1, 2, 3, 3, 2, 4]", "[0, 1, 2, 3, 3, 2, 5]", "below 5");
  refuses("[4, 3]", "[4, 4]", "faceVertexCounts");
  refuses("[\"Hip\", \"Hip/Knee\"]", "[\"Hip\"]", "1 matrices");
  refuses("[1, 0, 1, 0, 0.5, 0.5, 1, 1, 0, 1]", "[1, 0]", "joints and weights");
  refuses("[0, 1, 0, 1, 0, 1, 0, 1, 0, 1]", "[0, 1, 0, 1, 0, 1, 0, 1, 0, 2]", "below 2");
  refuses("[\"Hip/Knee\", \"Hip\"]", "[\"Hip/Knee\", \"Toe\"]", "Toe");
  refuses("[(1, 0, 0, 0)]", "[(1, 0, 0)]", "rotations");
  refuses("(0,0,1,0), (0,0,100,1)", "(0,0,0,0), (0,0,100,1)", "inverse");
  refuses("(10, 0, 0)\n    uniform", "(10, 0)\n    uniform", "xformOp:translate");
}

TEST_F(GltfFromUsd, RefusesPackagesWithoutText) {
  const auto put = [&](const std::vector<NamedBytes>& files) {
    const std::vector<uint8_t> bytes = usd_package("", files);
    return folder_.write("a.usdz", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  };
  const std::string binary = put({{"a.usdc", {1, 2}}});
  EXPECT_ERROR(read_gltf(binary), "a.usdz", "binary");
  const std::string picture = put({{"a.png", {1, 2}}});
  EXPECT_ERROR(read_gltf(picture), "a.usdz", "#usda");
  EXPECT_ERROR(read_gltf(folder_.write("b.usdz", "PK")), "b.usdz", "expected");
}

}  // namespace
}  // namespace sinew
