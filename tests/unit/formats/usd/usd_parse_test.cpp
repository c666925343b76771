// SPDX-License-Identifier: MIT
// The grammar of USD's text form.
#include "usd/usd_parse.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"

namespace sinew {
namespace {

UsdPrim parse(const std::string& text) { return parse_usda("a.usda", "#usda 1.0\n" + text); }

TEST(UsdParse, ReadsPrimsPropertiesAndMetadata) {
  const UsdPrim root = parse(R"((
    "a comment"
    doc = """two
lines"""
    metersPerUnit = 0.01; upAxis = "Z"
    customLayerData = { string app = "x"; dictionary more = { int[] n = [1, 2] } }
)
def Xform "A" ( prepend apiSchemas = ["B", "C"]
    kind = "component" )
{
    custom uniform token[] names = ["p", 'q"', "r\"s"]  # behind it
    float3[] points.timeSamples = { 0: [(1, 2, 3), (4, 5, -6e-1)], 10.5: None, 20: [(1, 2, 3)], }
    float inputs:a.connect = </A/B.outputs:a>
    rel to = [</A/B>, <C>] ( bindMaterialAs = "weak" )
    asset file = @./it's.png@
    matrix4d m = ( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (5, 6, 7, 1) )
    double3 unset
    bool on = true
    // a comment of the newer kind
    def Mesh "B" {}
    variantSet "v" = { "one" { def "Inside" {} int x = 3 } "two" (doc = "y") {} }
    over "C" { }
}
)");
  EXPECT_EQ(root.metadata.at("metersPerUnit").numbers, std::vector<double>{0.01});
  EXPECT_EQ(root.metadata.at("upAxis").texts, std::vector<std::string>{"Z"});
  EXPECT_EQ(root.metadata.at("customLayerData:app").texts, std::vector<std::string>{"x"});
  EXPECT_EQ(root.metadata.at("customLayerData:more:n").numbers, (std::vector<double>{1, 2}));
  ASSERT_EQ(root.children.size(), 1u);
  const UsdPrim& a = root.children[0];
  EXPECT_EQ(a.type + a.name + a.path, "XformA/A");
  EXPECT_EQ(a.metadata.at("apiSchemas").texts.size(), 2u);
  EXPECT_EQ(find_property(a, "names")->value.texts, (std::vector<std::string>{"p", "q\"", "r\"s"}));
  const UsdProperty& points = *find_property(a, "points");
  EXPECT_EQ(points.type, "float3[]");
  ASSERT_EQ(points.samples.size(), 2u);
  EXPECT_EQ(points.samples.at(0).numbers, (std::vector<double>{1, 2, 3, 4, 5, -0.6}));
  EXPECT_EQ(points.samples.at(0).width, 3u);
  EXPECT_EQ(find_property(a, "inputs:a")->targets, std::vector<std::string>{"/A/B.outputs:a"});
  EXPECT_EQ(find_property(a, "to")->targets, (std::vector<std::string>{"/A/B", "C"}));
  EXPECT_EQ(find_property(a, "to")->metadata.at("bindMaterialAs").texts[0], "weak");
  EXPECT_EQ(text_of(a, "file"), "./it's.png");
  EXPECT_EQ(find_value(a, "m")->numbers.size(), 16u);
  EXPECT_EQ(find_value(a, "unset"), nullptr);
  EXPECT_EQ(find_value(a, "on")->numbers, std::vector<double>{1});
  ASSERT_EQ(a.children.size(), 2u);
  EXPECT_EQ(a.children[0].path, "/A/B");
  EXPECT_EQ(a.children[1].specifier, "over");
  EXPECT_TRUE(a.has_variants);
}

TEST(UsdParse, ReadsReferencesAndNumbersOfAllKinds) {
  const UsdPrim root = parse(
      "def \"A\" (\n references = [ @b.usda@</B> (offset = 1; scale = 2), @c.usda@ ]\n payload = @d.usda@</D>\n"
      " variants = { string look = \"red\" }\n)\n{ double[] n = [inf, -inf, .5, +2, -3e2, 1.] }\n");
  EXPECT_EQ(root.children[0].metadata.at("references").texts.size(), 2u);
  EXPECT_EQ(root.children[0].metadata.at("payload").texts[0], "d.usda");
  const std::vector<double>& n = find_value(root.children[0], "n")->numbers;
  ASSERT_EQ(n.size(), 6u);
  EXPECT_TRUE(std::isinf(n[0]) && std::isinf(n[1]) && n[1] < 0);
  EXPECT_EQ(n[4], -300);
}

TEST(UsdParse, RefusesWithFileLineAndWhatWasExpected) {
  const auto refuses = [](const std::string& text, const std::string& where, const std::string& expected) {
    EXPECT_ERROR(parse_usda("a.usda", text), "a.usda" + where, expected);
  };
  refuses("PXR-USDC\1\2", "", "binary");
  refuses("def", "", "#usda");
  refuses("#usda 1.0\ndef Mesh \"A\"\n{\n  int a = \n}", ":5", "a value");
  refuses("#usda 1.0\ndef Mesh \"A\" {", ":2", "end of the file");
  refuses("#usda 1.0\ndef Mesh \"A", ":2", "a string");
  refuses("#usda 1.0\n\ndef Mesh { }", ":3", "in quotes");
  refuses("#usda 1.0\ndef \"A\" { int a = 1e999 }", ":2", "a number");
  refuses("#usda 1.0\ndef \"A\" { float2[] a = [(1, 2), (3)] }", ":2", "one length");
  refuses("#usda 1.0\ndef \"A\" { int a.timeSamples = { 0 1 } }", ":2", "':'");
  refuses("#usda 1.0\nfloat a = 3", ":2", "def, over or class");
  refuses("#usda 1.0\ndef \"A\" { int a = " + std::string(200, '('), ":2", "at most 64");
  std::string deep = "#usda 1.0\n";
  for (int i = 0; i < 200; ++i) deep += "def \"A\" { ";
  refuses(deep, ":2", "at most 64");
}

}  // namespace
}  // namespace sinew
