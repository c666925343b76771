// SPDX-License-Identifier: MIT
// A character as FBX with what strangers' files have: two meshes of one skeleton, one whose clusters move nothing and which hangs on a joint, a
// blend shape, a picture outside, an animation, Z or Y up, units. And the same joints and body as COLLADA.

const across = [0, 100], heights = [0, 100, 200, 300, 400];

const array = (name, values) => `    ${name}: *${values.length} {\n      a: ${values.join(",")}\n    }\n`;
const matrix = (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];

// unit: centimetres of one unit. up: "y" or "z". size: units of the height, 400 where it is missing.
export function strangeFbx({ unit = 1, up = "z", size = 400 } = {}) {
  const k = size / 400, axis = up === "z" ? 2 : 1;
  const at = (height, x = 0) => [k * x, axis === 1 ? k * height : 0, axis === 2 ? k * height : 0];
  const strip = (shift) => heights.flatMap((h) => across.flatMap((x) => at(h, x + shift)));
  const quads = [0, 1, 3, -3, 2, 3, 5, -5, 4, 5, 7, -7, 6, 7, 9, -9];
  const uvs = heights.flatMap((h) => across.flatMap((x) => [x / 100, h / 400]));
  const model = (id, name, kind, place) => `  Model: ${id}, "Model::${name}", "${kind}" {\n    Version: 232\n    Properties70: {
      P: "Lcl Translation", "Lcl Translation", "", "A",${place.join(",")}\n    }\n    Shading: T\n    Culling: "CullingOff"\n  }\n`;
  const geometry = (id, name, points, corners) => `  Geometry: ${id}, "Geometry::${name}", "Mesh" {\n${array("Vertices", points)}${array("PolygonVertexIndex", corners)}
    GeometryVersion: 124\n    LayerElementUV: 0 {\n      Version: 101\n      Name: "UVMap"\n      MappingInformationType: "ByVertice"\n      ReferenceInformationType: "Direct"
${array("UV", uvs.slice(0, (points.length / 3) * 2))}    }\n    LayerElementMaterial: 0 {\n      Version: 101\n      MappingInformationType: "AllSame"\n      ReferenceInformationType: "IndexToDirect"\n      Materials: *1 {\n        a: 0\n      }\n    }
    Layer: 0 {\n      Version: 100\n      LayerElement:  {\n        Type: "LayerElementUV"\n        TypedIndex: 0\n      }\n      LayerElement:  {\n        Type: "LayerElementMaterial"\n        TypedIndex: 0\n      }\n    }\n  }\n`;
  const cluster = (id, name, vertices, weights, height) => `  Deformer: ${id}, "SubDeformer::${name}", "Cluster" {\n    Version: 100\n    UserData: "", ""
${vertices.length ? array("Indexes", vertices) + array("Weights", weights) : ""}${array("Transform", matrix(...at(-height)))}${array("TransformLink", matrix(...at(height)))}  }\n`;
  const skin = (id) => `  Deformer: ${id}, "Deformer::", "Skin" {\n    Version: 101\n    Link_DeformAcuracy: 50\n  }\n`;
  const low = [0, 1, 2, 3, 4, 5, 6, 7], high = [2, 3, 4, 5, 6, 7, 8, 9], fall = [1, 1, 0.75, 0.75, 0.5, 0.5, 0.25, 0.25];
  const axes = up === "z" ? [2, 1, 1, -1] : [1, 1, 2, 1];
  const objects = [
    geometry(10, "body", strip(0), quads), geometry(11, "coat", strip(20), quads),
    geometry(12, "lamp", [...at(200), ...at(200, 10), ...at(210)], [0, 1, -3]),
    ...[20, 21, 22].map((id) => `  NodeAttribute: ${id}, "NodeAttribute::", "LimbNode" {\n    TypeFlags: "Skeleton"\n  }\n`),
    model(30, "rig", "Null", at(0)), model(31, "hip", "LimbNode", at(0)), model(32, "knee", "LimbNode", at(200)), model(33, "tip", "LimbNode", at(200)),
    model(34, "body", "Mesh", at(0)), model(35, "coat", "Mesh", at(0)), model(36, "lamp", "Mesh", at(0)),
    `  Material: 40, "Material::cloth", "" {\n    Version: 102\n    ShadingModel: "lambert"\n    Properties70: {\n      P: "DiffuseColor", "Color", "", "A",0.5,0.5,0.5\n    }\n  }\n`,
    `  Texture: 41, "Texture::skin", "" {\n    Type: "TextureVideoClip"\n    Version: 202\n    TextureName: "Texture::skin"\n    FileName: "C:\\art\\skin.png"\n    RelativeFilename: "skin.png"\n  }\n`,
    skin(50), cluster(51, "hip", low, fall, 0), cluster(52, "knee", high, [...fall].reverse(), 200),
    skin(53), cluster(54, "hip", low, fall, 0), cluster(55, "knee", high, [...fall].reverse(), 200),
    skin(56), cluster(57, "hip", [], [], 0), cluster(58, "knee", [], [], 200),
    `  Deformer: 70, "Deformer::shapes", "BlendShape" {\n    Version: 100\n  }\n  Deformer: 71, "SubDeformer::wide", "BlendShapeChannel" {\n    Version: 100\n    DeformPercent: 0
${array("FullWeights", [100])}  }\n  Geometry: 72, "Geometry::wide", "Shape" {\n    Version: 100\n${array("Indexes", [8, 9])}${array("Vertices", [...at(0, -30), ...at(0, 30)])}${array("Normals", [0, 0, 0, 0, 0, 0])}  }\n`,
    `  AnimationStack: 60, "AnimStack::wave", "" {\n    Properties70: {\n      P: "LocalStop", "KTime", "Time", "",46186158000\n    }\n  }\n  AnimationLayer: 61, "AnimLayer::base", "" {\n  }
  AnimationCurveNode: 62, "AnimCurveNode::R", "" {\n    Properties70: {\n      P: "d|X", "Number", "", "A",0\n      P: "d|Y", "Number", "", "A",0\n      P: "d|Z", "Number", "", "A",0\n    }\n  }
  AnimationCurve: 63, "AnimCurve::", "" {\n    Default: 0\n    KeyVer: 4008\n${array("KeyTime", [0, 46186158000])}${array("KeyValueFloat", [0, 90])}${array("KeyAttrFlags", [24836])}${array("KeyAttrDataFloat", [0, 0, 0, 0])}${array("KeyAttrRefCount", [2])}  }\n`,
  ];
  const links = ["30,0", "31,30", "32,31", "33,32", "34,30", "35,30", "36,32", "20,31", "21,32", "22,33", "10,34", "11,35", "12,36", "40,34", "40,35", "40,36",
    "50,10", "51,50", "52,50", "31,51", "32,52", "53,11", "54,53", "55,53", "31,54", "32,55", "56,12", "57,56", "58,56", "31,57", "32,58", "70,10", "71,70", "72,71", "61,60", "62,61"];
  return `; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n  FBXHeaderVersion: 1003\n  FBXVersion: 7400\n}\nGlobalSettings:  {\n  Version: 1000\n  Properties70:  {
    P: "UpAxis", "int", "Integer", "",${axes[0]}\n    P: "UpAxisSign", "int", "Integer", "",${axes[1]}\n    P: "FrontAxis", "int", "Integer", "",${axes[2]}\n    P: "FrontAxisSign", "int", "Integer", "",${axes[3]}
    P: "CoordAxis", "int", "Integer", "",0\n    P: "CoordAxisSign", "int", "Integer", "",1\n    P: "UnitScaleFactor", "double", "Number", "",${unit}\n  }\n}
Definitions:  {\n  Version: 100\n}\nObjects:  {\n${objects.join("")}}\nConnections:  {\n${links.map((pair) => `  C: "OO",${pair}\n`).join("")}  C: "OP",41,40, "DiffuseColor"\n  C: "OP",62,32, "Lcl Rotation"\n  C: "OP",63,62, "d|X"\n}\n`;
}

export function strangeDae() {
  const points = heights.flatMap((h) => across.flatMap((x) => [x, 0, h])).join(" ");
  const corners = [0, 1, 2, 3].flatMap((z) => [0, 1, 3, 2].map((v) => 2 * z + v)).join(" ");
  const source = (id, kind, values, count, stride, type) => `<source id="${id}"><${kind} id="${id}-a" count="${count * stride}">${values}</${kind}><technique_common>
<accessor source="#${id}-a" count="${count}" stride="${stride}">${type}</accessor></technique_common></source>`;
  const one = (name, type) => `<param name="${name}" type="${type}"/>`;
  const node = (name, z, inside) => `<node id="${name}" name="${name}" sid="${name}" type="JOINT"><matrix>1 0 0 0 0 1 0 0 0 0 1 ${z} 0 0 0 1</matrix>${inside}</node>`;
  return `<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit name="centimetre" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_images><image id="skin"><init_from>skin.png</init_from></image></library_images>
<library_effects><effect id="red-fx"><profile_COMMON><newparam sid="s"><surface type="2D"><init_from>skin</init_from></surface></newparam>
<newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam><technique sid="common"><lambert><diffuse><texture texture="t" texcoord="UVMap"/></diffuse></lambert></technique>
</profile_COMMON></effect></library_effects><library_materials><material id="red" name="red"><instance_effect url="#red-fx"/></material></library_materials>
<library_geometries><geometry id="strip" name="strip"><mesh>${source("p", "float_array", points, 10, 3, one("X", "float") + one("Y", "float") + one("Z", "float"))}
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><polylist material="red" count="4"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 4 4 4</vcount><p>${corners}</p></polylist></mesh></geometry></library_geometries>
<library_controllers><controller id="skin-c"><skin source="#strip"><bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>
${source("j", "Name_array", "hip knee", 2, 1, one("JOINT", "name"))}${source("b", "float_array", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 0 1 0 0 0 0 1 -200 0 0 0 1", 2, 16, one("TRANSFORM", "float4x4"))}
${source("w", "float_array", "0 0.25 0.5 0.75 1", 5, 1, one("WEIGHT", "float"))}<joints><input semantic="JOINT" source="#j"/><input semantic="INV_BIND_MATRIX" source="#b"/></joints>
<vertex_weights count="10"><input semantic="JOINT" source="#j" offset="0"/><input semantic="WEIGHT" source="#w" offset="1"/><vcount>1 1 2 2 2 2 2 2 1 1</vcount><v>0 4 0 4 0 3 1 1 0 3 1 1 0 2 1 2 0 2 1 2 0 1 1 3 0 1 1 3 1 4 1 4</v></vertex_weights>
</skin></controller></library_controllers>
<library_visual_scenes><visual_scene id="scene"><node id="rig" name="rig" type="NODE">${node("hip", 0, node("knee", 200, node("tip", 200, "")))}
<node id="body" name="body"><instance_controller url="#skin-c"><skeleton>#hip</skeleton><bind_material><technique_common><instance_material symbol="red" target="#red"/></technique_common></bind_material></instance_controller></node></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene></COLLADA>\n`;
}
