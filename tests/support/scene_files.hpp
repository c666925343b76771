// SPDX-License-Identifier: MIT
// A character as FBX and as COLLADA, both as text: a strip of 4 quads, 2 wide and 4 high, hip and knee with weights, a
// tip without, a mesh that hangs on the knee. Z is up; FBX counts in centimetres, COLLADA in steps of 0.01 m.
#ifndef SINEW_TESTS_SCENE_FILES_HPP
#define SINEW_TESTS_SCENE_FILES_HPP

#include <string>

inline std::string strip_positions() {  // x, 0, z: ten vertices
  std::string out;
  for (int z = 0; z < 5; ++z)
    for (int x = 0; x < 2; ++x)
      out += (out.empty() ? "" : ",") + std::to_string(x * 100) + ",0," + std::to_string(z * 100);
  return out;
}

inline std::string strip_fbx() {
  const std::string still = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1", knee = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,200,1",
                    knee_back = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,-200,1";
  const auto model = [](int id, const char* name, const char* kind, const char* at) {
    return "  Model: " + std::to_string(id) + ", \"Model::" + name + "\", \"" + kind +
           "\" {\n    Version: 232\n    Properties70: {\n      P: \"Lcl Translation\", \"Lcl Translation\", \"\", "
           "\"A\"," +
           at +
           "\n      P: \"PreRotation\", \"Vector3D\", \"Vector\", \"\",0,0,0\n      P: \"RotationActive\", \"bool\", "
           "\"\", \"\",1\n    }\n"
           "    Shading: T\n    Culling: \"CullingOff\"\n  }\n";
  };
  const auto attribute = [](int id) {
    return "  NodeAttribute: " + std::to_string(id) +
           ", \"NodeAttribute::\", \"LimbNode\" {\n    TypeFlags: \"Skeleton\"\n  }\n";
  };
  const auto array = [](const char* name, const std::string& values, size_t count) {
    return std::string("    ") + name + ": *" + std::to_string(count) + " {\n      a: " + values + "\n    }\n";
  };
  const auto cluster = [&](int id, const char* name, const char* vertices, const char* weights, size_t count,
                           const std::string& link, const std::string& back) {
    return "  Deformer: " + std::to_string(id) + ", \"SubDeformer::" + name +
           "\", \"Cluster\" {\n    Version: 100\n    UserData: \"\", \"\"\n" + array("Indexes", vertices, count) +
           array("Weights", weights, count) + array("Transform", back, 16) + array("TransformLink", link, 16) + "  }\n";
  };
  std::string out =
      "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n  FBXHeaderVersion: 1003\n  FBXVersion: 7400\n}\n"
      "GlobalSettings:  {\n  Version: 1000\n  Properties70:  {\n"
      "    P: \"UpAxis\", \"int\", \"Integer\", \"\",2\n    P: \"UpAxisSign\", \"int\", \"Integer\", \"\",1\n"
      "    P: \"FrontAxis\", \"int\", \"Integer\", \"\",1\n    P: \"FrontAxisSign\", \"int\", \"Integer\", \"\",-1\n"
      "    P: \"CoordAxis\", \"int\", \"Integer\", \"\",0\n    P: \"CoordAxisSign\", \"int\", \"Integer\", \"\",1\n"
      "    P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",1\n  }\n}\nDefinitions:  {\n  Version: "
      "100\n}\nObjects:  {\n"
      "  Geometry: 10, \"Geometry::strip\", \"Mesh\" {\n" +
      array("Vertices", strip_positions(), 30) +
      array("PolygonVertexIndex", "0,1,3,-3,2,3,5,-5,4,5,7,-7,6,7,9,-9", 16) +
      "    GeometryVersion: 124\n    LayerElementUV: 0 {\n      Version: 101\n      Name: \"UVMap\"\n"
      "      MappingInformationType: \"ByVertice\"\n      ReferenceInformationType: \"Direct\"\n" +
      array("UV", "0,0,1,0,0,0.25,1,0.25,0,0.5,1,0.5,0,0.75,1,0.75,0,1,1,1", 20) +
      "    }\n    LayerElementMaterial: 0 {\n      Version: 101\n      MappingInformationType: \"AllSame\"\n"
      "      ReferenceInformationType: \"IndexToDirect\"\n      Materials: *1 {\n        a: 0\n      }\n    }\n"
      "    Layer: 0 {\n      Version: 100\n      LayerElement:  {\n        Type: \"LayerElementUV\"\n"
      "        TypedIndex: 0\n      }\n      LayerElement:  {\n        Type: \"LayerElementMaterial\"\n"
      "        TypedIndex: 0\n      }\n    }\n  }\n"
      "  Geometry: 11, \"Geometry::lamp\", \"Mesh\" {\n" +
      array("Vertices", "0,0,0,10,0,0,0,0,10", 9) + array("PolygonVertexIndex", "0,1,-3", 3) + "  }\n";
  out += attribute(20) + attribute(21) + attribute(22);
  out += "  NodeAttribute: 23, \"NodeAttribute::\", \"Null\" {\n    TypeFlags: \"Null\"\n  }\n";
  out += model(30, "rig", "Null", "0,0,0") + model(31, "hip", "LimbNode", "0,0,0") +
         model(32, "knee", "LimbNode", "0,0,200") + model(33, "tip", "LimbNode", "0,0,200") +
         model(34, "body", "Mesh", "0,0,0") + model(35, "lamp", "Mesh", "0,0,50");
  out +=
      "  Material: 40, \"Material::red\", \"\" {\n    Version: 102\n    ShadingModel: \"lambert\"\n    Properties70: "
      "{\n"
      "      P: \"DiffuseColor\", \"Color\", \"\", \"A\",1,0,0\n    }\n  }\n"
      "  Deformer: 50, \"Deformer::\", \"Skin\" {\n    Version: 101\n    Link_DeformAcuracy: 50\n  }\n";
  out += cluster(51, "hip", "0,1,2,3,4,5,6,7", "1,1,0.75,0.75,0.5,0.5,0.25,0.25", 8, still, still);
  out += cluster(52, "knee", "2,3,4,5,6,7,8,9", "0.25,0.25,0.5,0.5,0.75,0.75,1,1", 8, knee, knee_back);
  out += "}\nConnections:  {\n";
  for (const char* pair : {"30,0", "31,30", "32,31", "33,32", "34,30", "35,32", "23,30", "20,31", "21,32", "22,33",
                           "10,34", "11,35", "40,34", "50,10", "51,50", "52,50", "31,51", "32,52"})
    out += std::string("  C: \"OO\",") + pair + "\n";
  return out + "}\n";
}

inline std::string strip_dae() {
  std::string positions = strip_positions(), corners;
  for (char& c : positions) c = c == ',' ? ' ' : c;
  for (int z = 0; z < 4; ++z)
    for (const int v : {0, 1, 3, 2}) corners += std::to_string(2 * z + v) + " ";
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimetre" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_images><image id="skin"><init_from>skin.png</init_from></image></library_images>
<library_effects><effect id="red-fx"><profile_COMMON>
<newparam sid="s"><surface type="2D"><init_from>skin</init_from></surface></newparam>
<newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>
<technique sid="common"><lambert><diffuse><texture texture="t" texcoord="UVMap"/></diffuse></lambert></technique>
</profile_COMMON></effect></library_effects>
<library_materials><material id="red" name="red"><instance_effect url="#red-fx"/></material></library_materials>
<library_geometries><geometry id="strip" name="strip"><mesh>
<source id="p"><float_array id="pa" count="30">)" +
         positions + R"(</float_array><technique_common><accessor source="#pa" count="10" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist material="red" count="4"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 4 4 4</vcount><p>)" +
         corners + R"(</p></polylist></mesh></geometry></library_geometries>
<library_controllers><controller id="skin-c"><skin source="#strip">
<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>
<source id="j"><Name_array id="ja" count="2">hip knee</Name_array><technique_common><accessor source="#ja" count="2" stride="1">
<param name="JOINT" type="name"/></accessor></technique_common></source>
<source id="b"><float_array id="ba" count="32">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 0 1 0 0 0 0 1 -200 0 0 0 1</float_array>
<technique_common><accessor source="#ba" count="2" stride="16"><param name="TRANSFORM" type="float4x4"/></accessor></technique_common></source>
<source id="w"><float_array id="wa" count="5">0 0.25 0.5 0.75 1</float_array><technique_common><accessor source="#wa" count="5" stride="1">
<param name="WEIGHT" type="float"/></accessor></technique_common></source>
<joints><input semantic="JOINT" source="#j"/><input semantic="INV_BIND_MATRIX" source="#b"/></joints>
<vertex_weights count="10"><input semantic="JOINT" source="#j" offset="0"/><input semantic="WEIGHT" source="#w" offset="1"/>
<vcount>1 1 2 2 2 2 2 2 1 1</vcount><v>0 4 0 4 0 3 1 1 0 3 1 1 0 2 1 2 0 2 1 2 0 1 1 3 0 1 1 3 1 4 1 4</v></vertex_weights>
</skin></controller></library_controllers>
<library_visual_scenes><visual_scene id="scene"><node id="rig" name="rig" type="NODE">
<node id="rig_hip" name="hip" sid="hip" type="JOINT"><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>
<node id="rig_knee" name="knee" sid="knee" type="JOINT"><matrix>1 0 0 0 0 1 0 0 0 0 1 200 0 0 0 1</matrix>
<node id="rig_tip" name="tip" sid="tip" type="JOINT"><matrix>1 0 0 0 0 1 0 0 0 0 1 200 0 0 0 1</matrix></node></node></node>
<node id="body" name="body"><instance_controller url="#skin-c"><skeleton>#rig_hip</skeleton>
<bind_material><technique_common><instance_material symbol="red" target="#red"/></technique_common></bind_material>
</instance_controller></node></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene></COLLADA>
)";
}

// Two clips, as stranger's files have them: a skeleton without a mesh, hip and knee with their tip. In "bend" the knee turns by 90 degrees about
// x in a second, in "rise" the hip goes up by 100 units in two; keys begin half a second late.
inline std::string moving_dae() {
  const auto source = [](const std::string& id, const char* kind, const std::string& values, size_t count,
                         size_t stride, const char* type) {
    return "<source id=\"" + id + "\"><" + kind + " id=\"" + id + "-a\" count=\"" + std::to_string(count * stride) +
           "\">" + values + "</" + kind + "><technique_common><accessor source=\"#" + id + "-a\" count=\"" +
           std::to_string(count) + "\" stride=\"" + std::to_string(stride) + "\"><param name=\"V\" type=\"" + type +
           "\"/></accessor></technique_common></source>\n";
  };
  // Both joints move in both clips: Assimp makes one of clips with one joint each.
  const auto track = [&](const std::string& id, const std::string& joint, const std::string& times,
                         const std::string& matrices) {
    const std::string own = id + "-" + joint;
    return source(own + "-in", "float_array", times, 2, 1, "float") +
           source(own + "-out", "float_array", matrices, 2, 16, "float4x4") +
           source(own + "-how", "Name_array", "LINEAR LINEAR", 2, 1, "name") + "<sampler id=\"" + own +
           "-s\"><input semantic=\"INPUT\" source=\"#" + own + "-in\"/><input semantic=\"OUTPUT\" source=\"#" + own +
           "-out\"/><input semantic=\"INTERPOLATION\" source=\"#" + own + "-how\"/></sampler><channel source=\"#" +
           own + "-s\" target=\"" + joint + "/transform\"/>\n";
  };
  const auto animation = [&](const std::string& id, const std::string& tracks) {
    return "<animation id=\"" + id + "\" name=\"" + id + "\">\n" + tracks + "</animation>\n";
  };
  const std::string hip = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", knee = "1 0 0 0 0 1 0 0 0 0 1 200 0 0 0 1",
                    up = "1 0 0 0 0 1 0 0 0 0 1 100 0 0 0 1", bent = "1 0 0 0 0 0 -1 0 0 1 0 200 0 0 0 1";
  const auto node = [](const char* name, int z) {
    return std::string("<node id=\"") + name + "\" name=\"" + name + "\" sid=\"" + name +
           "\" type=\"JOINT\"><matrix sid=\"transform\">1 0 0 0 0 1 0 0 0 0 1 " + std::to_string(z) +
           " 0 0 0 1</matrix>";
  };
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
         "version=\"1.4.1\">\n<asset><unit name=\"centimetre\" meter=\"0.01\"/><up_axis>Z_UP</up_axis></asset>\n"
         "<library_animations>\n" +
         animation("bend", track("bend", "hip", "0.5 1.5", hip + " " + hip) +
                               track("bend", "knee", "0.5 1.5", knee + " " + bent)) +
         animation("rise", track("rise", "hip", "0.5 2.5", hip + " " + up) +
                               track("rise", "knee", "0.5 2.5", knee + " " + knee)) +
         "</library_animations>\n"
         "<library_visual_scenes><visual_scene id=\"scene\"><node id=\"rig\" name=\"rig\" type=\"NODE\">" +
         node("hip", 0) + node("knee", 200) + node("tip", 200) +
         "</node></node></node></node></visual_scene></library_visual_scenes>\n"
         "<scene><instance_visual_scene url=\"#scene\"/></scene></COLLADA>\n";
}

// strip_fbx() whose knee turns by 90 degrees about x in a second. 46186158000 ticks are one.
inline std::string moving_fbx() {
  std::string out = strip_fbx();
  const std::string curves =
      "  AnimationStack: 60, \"AnimStack::Take 001\", \"\" {\n    Properties70: {\n"
      "      P: \"LocalStop\", \"KTime\", \"Time\", \"\",46186158000\n    }\n  }\n"
      "  AnimationLayer: 61, \"AnimLayer::BaseLayer\", \"\" {\n  }\n"
      "  AnimationCurveNode: 62, \"AnimCurveNode::R\", \"\" {\n    Properties70: {\n"
      "      P: \"d|X\", \"Number\", \"\", \"A\",0\n      P: \"d|Y\", \"Number\", \"\", \"A\",0\n"
      "      P: \"d|Z\", \"Number\", \"\", \"A\",0\n    }\n  }\n"
      "  AnimationCurve: 63, \"AnimCurve::\", \"\" {\n    Default: 0\n    KeyVer: 4008\n"
      "    KeyTime: *2 {\n      a: 0,46186158000\n    }\n    KeyValueFloat: *2 {\n      a: 0,90\n    }\n"
      "    KeyAttrFlags: *1 {\n      a: 24836\n    }\n    KeyAttrDataFloat: *4 {\n      a: 0,0,0,0\n    }\n"
      "    KeyAttrRefCount: *1 {\n      a: 2\n    }\n  }\n";
  out.insert(out.find("}\nConnections:"), curves);
  const std::string links =
      "  C: \"OO\",61,60\n  C: \"OO\",62,61\n  C: \"OP\",62,32, \"Lcl Rotation\"\n  C: \"OP\",63,62, \"d|X\"\n";
  return out.insert(out.rfind("}\n"), links);
}

#endif
