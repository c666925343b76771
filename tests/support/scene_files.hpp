// SPDX-License-Identifier: MIT
// A character as FBX and as COLLADA, both as text: a strip of 4 quads, 2 wide and 4 high, hip and knee with weights, a
// tip without, a mesh that hangs on the knee. Z is up; FBX counts in centimeters, COLLADA in steps of 0.01 m. The same strip,
// 1 wide, without the hanging mesh, as DirectX, OGRE, Blitz3D and MilkShape (Y up), MD5 and Valve SMD (Z up).
#ifndef SINEW_TESTS_SCENE_FILES_HPP
#define SINEW_TESTS_SCENE_FILES_HPP

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

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
         "version=\"1.4.1\">\n<asset><unit name=\"centimeter\" meter=\"0.01\"/><up_axis>Z_UP</up_axis></asset>\n"
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

// Of vertex v: how much the knee has of it; the hip has the rest.
inline double strip_weight(int v) { return v / 2 / 4.0; }

inline std::vector<std::vector<int>> strip_triangles() {
  std::vector<std::vector<int>> triangles;
  for (int z = 0; z < 8; z += 2) {
    triangles.push_back({z, z + 1, z + 3});
    triangles.push_back({z, z + 3, z + 2});
  }
  return triangles;
}

// Who moves vertex v: 0 hip, 1 knee.
inline std::vector<std::pair<int, double>> strip_influences(int v) {
  std::vector<std::pair<int, double>> row;
  for (const auto& [joint, weight] : {std::pair(0, 1 - strip_weight(v)), std::pair(1, strip_weight(v))})
    if (weight > 0) row.emplace_back(joint, weight);
  return row;
}

inline std::string strip_x() {
  const auto matrix = [](int y) {
    return "1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0," + std::to_string(y) + ".0,0.0,1.0;;";
  };
  const auto frame = [&](const char* name, int y) {
    return std::string("Frame ") + name + " {\nFrameTransformMatrix { " + matrix(y) + " }\n";
  };
  std::string out = "xof 0303txt 0032\n" + frame("hip", 0) + frame("knee", 2) + frame("tip", 2) + "}\n}\n}\n" +
                    frame("body", 0) + "Mesh strip {\n10;\n";
  for (int v = 0; v < 10; ++v)
    out += std::to_string(v % 2) + ".0;" + std::to_string(v / 2) + ".0;0.0;" + (v < 9 ? ",\n" : ";\n8;\n");
  const auto triangles = strip_triangles();
  for (const auto& t : triangles)
    out += "3;" + std::to_string(t[0]) + "," + std::to_string(t[2]) + "," + std::to_string(t[1]) + ";" +
           (&t == &triangles.back() ? ";\n" : ",\n");
  for (const int joint : {0, 1}) {
    std::string vertices, weights;
    int count = 0;
    for (int v = 0; v < 10; ++v)
      for (const auto& [j, weight] : strip_influences(v)) {
        if (j != joint) continue;
        vertices += (count == 0 ? "" : ",") + std::to_string(v);
        weights += (count++ == 0 ? "" : ",") + std::to_string(weight);
      }
    out += std::string("SkinWeights { \"") + (joint == 0 ? "hip" : "knee") + "\"; " + std::to_string(count) + ";\n" +
           vertices + ";\n" + weights + ";\n" + matrix(-2 * joint) + " }\n";
  }
  return out + "}\n}\n";
}

inline std::string strip_md5mesh() {
  std::string vertices, weights;
  int count = 0;
  for (int v = 0; v < 10; ++v) {
    const auto row = strip_influences(v);
    vertices +=
        "\tvert " + std::to_string(v) + " ( 0 0 ) " + std::to_string(count) + " " + std::to_string(row.size()) + "\n";
    for (const auto& [joint, weight] : row)
      weights += "\tweight " + std::to_string(count++) + " " + std::to_string(joint) + " " + std::to_string(weight) +
                 " ( " + std::to_string(v % 2) + " 0 " + std::to_string(v / 2 - 2 * joint) + " )\n";
  }
  std::string triangles;
  int number = 0;
  for (const auto& t : strip_triangles())
    triangles += "\ttri " + std::to_string(number++) + " " + std::to_string(t[0]) + " " + std::to_string(t[2]) + " " +
                 std::to_string(t[1]) + "\n";
  return "MD5Version 10\ncommandline \"\"\n\nnumJoints 3\nnumMeshes 1\n\njoints {\n\t\"hip\" -1 ( 0 0 0 ) ( 0 0 0 )\n"
         "\t\"knee\" 0 ( 0 0 2 ) ( 0 0 0 )\n\t\"tip\" 1 ( 0 0 4 ) ( 0 0 0 )\n}\n\nmesh {\n\tshader \"red\"\n\tnumverts "
         "10\n" +
         vertices + "\tnumtris 8\n" + triangles + "\tnumweights " + std::to_string(count) + "\n" + weights + "}\n";
}

inline std::string strip_smd() {
  std::string out =
      "version 1\nnodes\n0 \"hip\" -1\n1 \"knee\" 0\n2 \"tip\" 1\nend\nskeleton\ntime 0\n0 0 0 0 0 0 0\n1 0 0 2 0 0 0\n"
      "2 0 0 2 0 0 0\nend\ntriangles\n";
  for (const auto& t : strip_triangles()) {
    out += "red.png\n";
    for (const int v : t) {
      const auto row = strip_influences(v);
      out += "0 " + std::to_string(v % 2) + " 0 " + std::to_string(v / 2) + " 0 -1 0 0 0 " + std::to_string(row.size());
      for (const auto& [joint, weight] : row) out += " " + std::to_string(joint) + " " + std::to_string(weight);
      out += "\n";
    }
  }
  return out + "end\n";
}

// Its bones lie beside it, in strip.skeleton.xml.
inline std::string strip_mesh_xml() {
  std::string out =
      "<mesh>\n<submeshes>\n<submesh material=\"red\" usesharedvertices=\"false\" use32bitindexes=\"false\" "
      "operationtype=\"triangle_list\">\n<faces count=\"8\">\n";
  for (const auto& t : strip_triangles())
    out += "<face v1=\"" + std::to_string(t[0]) + "\" v2=\"" + std::to_string(t[1]) + "\" v3=\"" +
           std::to_string(t[2]) + "\"/>\n";
  out += "</faces>\n<geometry vertexcount=\"10\">\n<vertexbuffer positions=\"true\" normals=\"false\">\n";
  std::string assignments;
  for (int v = 0; v < 10; ++v) {
    out += "<vertex><position x=\"" + std::to_string(v % 2) + "\" y=\"" + std::to_string(v / 2) +
           "\" z=\"0\"/></vertex>\n";
    for (const auto& [joint, weight] : strip_influences(v))
      assignments += "<vertexboneassignment vertexindex=\"" + std::to_string(v) + "\" boneindex=\"" +
                     std::to_string(joint) + "\" weight=\"" + std::to_string(weight) + "\"/>\n";
  }
  return out + "</vertexbuffer>\n</geometry>\n<boneassignments>\n" + assignments +
         "</boneassignments>\n</submesh>\n</submeshes>\n<skeletonlink name=\"strip.skeleton\"/>\n</mesh>\n";
}
inline std::string strip_skeleton_xml() {
  std::string bones;
  for (const auto& [id, name] : {std::pair(0, "hip"), std::pair(1, "knee"), std::pair(2, "tip")})
    bones += "<bone id=\"" + std::to_string(id) + "\" name=\"" + name + "\"><position x=\"0\" y=\"" +
             (id == 0 ? "0" : "2") +
             "\" z=\"0\"/><rotation angle=\"0\"><axis x=\"1\" y=\"0\" z=\"0\"/></rotation></bone>\n";
  return "<skeleton>\n<bones>\n" + bones +
         "</bones>\n<bonehierarchy><boneparent bone=\"knee\" parent=\"hip\"/>"
         "<boneparent bone=\"tip\" parent=\"knee\"/></bonehierarchy>\n</skeleton>\n";
}

// Little-endian, as all machines are that the tests run on.
template <class T>
inline std::string strip_bytes(const T& value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

inline std::string strip_b3d() {
  const auto floats = [](std::initializer_list<double> values) {
    std::string out;
    for (const double value : values) out += strip_bytes(static_cast<float>(value));
    return out;
  };
  const auto chunk = [](const char* tag, const std::string& body) {
    return tag + strip_bytes(static_cast<int32_t>(body.size())) + body;
  };
  const auto node = [&](const char* name, int y, const std::string& inside) {
    return chunk("NODE", name + std::string(1, '\0') + floats({0, double(y), 0, 1, 1, 1, 1, 0, 0, 0}) + inside);
  };
  const auto bone = [&](int joint) {
    std::string weights;
    for (int v = 0; v < 10; ++v)
      for (const auto& [j, weight] : strip_influences(v))
        if (j == joint) weights += strip_bytes(int32_t{v}) + floats({weight});
    return chunk("BONE", weights);
  };
  std::string vertices = strip_bytes(int32_t{0}) + strip_bytes(int32_t{0}) + strip_bytes(int32_t{0});
  for (int v = 0; v < 10; ++v) vertices += floats({double(v % 2), double(v / 2), 0});
  std::string triangles = strip_bytes(int32_t{-1});
  for (const auto& t : strip_triangles())
    triangles += strip_bytes(int32_t{t[0]}) + strip_bytes(int32_t{t[2]}) + strip_bytes(int32_t{t[1]});
  const std::string mesh = chunk("MESH", strip_bytes(int32_t{-1}) + chunk("VRTS", vertices) + chunk("TRIS", triangles));
  const std::string hip = node("hip", 0, bone(0) + node("knee", 2, bone(1) + node("tip", 2, bone(2))));
  return chunk("BB3D", strip_bytes(int32_t{1}) + node("body", 0, mesh + hip));
}

// One joint a vertex is all that it holds: the nearer one.
inline std::string strip_ms3d() {
  const auto text = [](std::string value, size_t size) { return value.resize(size, '\0'), value; };
  std::string out = "MS3D000000" + strip_bytes(int32_t{4}) + strip_bytes(uint16_t{10});
  for (int v = 0; v < 10; ++v)
    out += '\0' + strip_bytes(static_cast<float>(v % 2)) + strip_bytes(static_cast<float>(v / 2)) + strip_bytes(0.0f) +
           static_cast<char>(strip_weight(v) > 0.5 ? 1 : 0) + '\0';
  const auto triangles = strip_triangles();
  out += strip_bytes(static_cast<uint16_t>(triangles.size()));
  for (const auto& t : triangles) {
    out += strip_bytes(uint16_t{0});
    for (const int v : t) out += strip_bytes(static_cast<uint16_t>(v));
    for (int corner = 0; corner < 3; ++corner) out += strip_bytes(0.0f) + strip_bytes(0.0f) + strip_bytes(1.0f);
    out += std::string(24, '\0') + '\1' + '\0';
  }
  out += strip_bytes(uint16_t{1}) + '\0' + text("body", 32) + strip_bytes(static_cast<uint16_t>(triangles.size()));
  for (uint16_t t = 0; t < triangles.size(); ++t) out += strip_bytes(t);
  out += '\xff' + strip_bytes(uint16_t{0}) + strip_bytes(24.0f) + strip_bytes(0.0f) + strip_bytes(int32_t{1}) +
         strip_bytes(uint16_t{3});
  for (const auto& [name, parent] : {std::pair("hip", ""), std::pair("knee", "hip"), std::pair("tip", "knee")})
    out += '\0' + text(name, 32) + text(parent, 32) + std::string(12, '\0') + strip_bytes(0.0f) +
           strip_bytes(*parent == '\0' ? 0.0f : 2.0f) + strip_bytes(0.0f) + std::string(4, '\0');
  return out;
}

#endif
