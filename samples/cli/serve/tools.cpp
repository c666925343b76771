// SPDX-License-Identifier: MIT
#include "serve/tools.hpp"

#include <algorithm>
#include <cmath>

#include "options.hpp"
#include "sinew_character/jobs/springs_job.hpp"
#include "sinew_character/picture/body_class.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

// kOutputs: a name that the names of several files are made of.
enum class Value { kInput, kOutput, kOutputs, kText, kTexts, kNumber, kFlag, kRotations };

struct Argument {
  std::string name;    // as callers give it
  std::string option;  // "" where it stands by itself
  Value value = Value::kText;
  std::string meaning;
  bool required = false;
  std::vector<std::string> choices = {};  // of a text
};

struct Tool {
  std::string name, title, meaning;
  bool json = true;
  std::vector<Argument> arguments;
};

Argument output_argument(const std::string& kinds) {
  return {"output", "-o", Value::kOutput, "File to write, below the served folder: " + kinds, true};
}

Argument class_argument() {
  return {"class", "--class", Value::kText, "Body class, where the prediction is wrong", false, body_class_words()};
}

Argument controls_argument() {
  return {"controls", "--controls", Value::kOutput,
          "Also write the joints of animator controls (formats/spec/controls.md): .controls.json"};
}

std::vector<Argument> joined(std::vector<Argument> first, std::vector<Argument> second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// Files for another program.
std::vector<Argument> profile_arguments() {
  std::vector<std::string> names;
  for (const Profile& one : profiles()) names.emplace_back(one.name);
  return {{"for", "--for", Value::kText, "Write for this program or format: names, axes, rest pose", false, names},
          {"author", "--author", Value::kText, "For vrm and vrm0: author; by default the file's own"},
          {"title", "--title", Value::kText, "For vrm and vrm0: name of the character; by default the file's"}};
}

std::vector<Argument> with_transform(std::vector<Argument> arguments) {
  return joined(std::move(arguments),
                {{"turn",
                  "--turn",
                  Value::kText,
                  "Rotate the mesh by 90 degrees before everything else; x rotates y to z",
                  false,
                  {"x", "y", "z", "-x", "-y", "-z"}},
                 {"height", "--height", Value::kNumber, "Scale the mesh to this height in meters"},
                 {"floor", "--floor", Value::kFlag, "Move the lowest vertex to height 0"}});
}

Tool rig_tool() {
  return {"rig", "Make a skeleton",
          "Makes a skeleton for a bare mesh or a picture of a character and binds it. Returns joints with confidences, "
          "and warnings.",
          true,
          joined(profile_arguments(),
                 with_transform(
                     {{"mesh", "", Value::kInput,
                       "Mesh (" + mesh_files() + ") or picture (" + extensions_text(kReadsPicture) + ")", true},
                      output_argument(extensions_text(kWritesSkin)),
                      {"skeleton", "--skeleton", Value::kInput, "Fit the skeleton of this file into the mesh"},
                      {"detail", "--detail", Value::kText, "Extent of the skeleton", false, kCharacterDetail},
                      class_argument(),
                      {"up", "--up", Value::kText, "Up axis", false, {"auto", "y", "z"}},
                      {"to_pose", "--to-pose", Value::kText, "Rest pose to put the result into", false, {"t", "a"}},
                      {"cut", "--cut", Value::kFlag, "Cut fused parts open"},
                      controls_argument(),
                      {"picture", "--png", Value::kOutput, "Also draw the mesh with its joints: .png"}}))};
}

Tool bind_tool() {
  return {
      "bind", "Predict weights", "Predicts the skin weights of a mesh for a skeleton. Returns their confidence.", true,
      joined(profile_arguments(),
             with_transform(
                 {{"mesh", "", Value::kInput, "Mesh (" + mesh_files() + ")", true},
                  output_argument(extensions_text(kWritesSkin)),
                  {"skeleton", "--skeleton", Value::kInput, "Skeleton of another file (" + skeleton_files() + ")"},
                  {"influences", "--influences", Value::kNumber, "Maximum number of joints per vertex, 4 by default"},
                  {"symmetric", "--symmetric", Value::kFlag, "Give mirrored vertices mirrored weights"},
                  {"fit", "--fit", Value::kFlag,
                   "Scale, rotate and move a skeleton that has other units or stands beside the mesh"},
                  controls_argument(),
                  {"picture", "--png", Value::kOutput, "Also draw the mesh colored by weight: .png"}}))};
}

Tool animate_tool() {
  return {"animate", "Play a motion",
          "Plays a motion of any skeleton on a character. Returns which joints move, and the confidence of the map.",
          true,
          joined(profile_arguments(),
                 {{"character", "", Value::kInput, "Skinned file, bare mesh or picture", true},
                  {"motion", "--motion", Value::kInput, "Motion (" + motion_files() + ")"},
                  {"clip", "--motion", Value::kText, "Built-in clip instead of a file: builtin:walk"},
                  output_argument(extensions_text(kWritesWhole) + "; one clip only: " + extensions_text(kWritesMotion)),
                  {"map", "--map", Value::kInput, "Joint map: lines TARGET_JOINT SOURCE_JOINT"},
                  {"in_place", "--in-place", Value::kFlag, "Keep the character above its rest position"},
                  {"arm_spread", "--arm-spread", Value::kNumber,
                   "Degrees, -90 to 90, by which both arms are lifted away from the body"},
                  {"springs", "--springs", Value::kFlag, "Simulate hair, tails, ears and skirts"},
                  {"force", "--force", Value::kFlag, "Play a motion that does not fit the character"},
                  controls_argument(),
                  {"sheet", "--sheet", Value::kOutput, "Also draw frames side by side: .png"}})};
}

Tool springs_tool() {
  return {"springs", "Find what swings",
          "Finds the chains of joints that should swing, hair, tails, ears and skirts, with colliders. Answers each "
          "chain with its reason and how sure it is.",
          true,
          joined(profile_arguments(),
                 {{"character", "", Value::kInput, "Skinned file or bare mesh (" + mesh_files() + ")", true},
                  {"output", "-o", Value::kOutput,
                   "Character with its springs, below the served folder: " + extensions_text(kWritesSprings)},
                  {"make", "--make", Value::kFlag, "Lay chains into skirts, coats and capes that have none"},
                  {"take", "--take", Value::kTexts,
                   "Chains to keep although they are not sure; NAME* takes all that begin so"},
                  {"drop", "--drop", Value::kTexts, "Chains to leave out"},
                  {"presets", "--preset", Value::kTexts, "NAME=KIND: " + spring_kinds_text()},
                  {"values", "--value", Value::kTexts, "NAME:FIELD=X or NAME:FIELD=xFACTOR: " + spring_fields_text()},
                  {"replace", "--replace", Value::kFlag, "Find springs anew instead of the file's own"}})};
}

Tool check_tool() {
  return {"check",
          "Check a rig",
          "Checks a rig: weights, joints, names, matrices, test poses, animations. Changes no file.",
          true,
          {{"file", "", Value::kInput, "Character (" + mesh_files() + ")", true},
           {"against", "--against", Value::kInput, "Older version of the character: report what is new"},
           {"report", "--report", Value::kOutput, "Also write a page with a picture per finding: .html"},
           {"no_poses", "--no-poses", Value::kFlag, "Leave out the test poses"},
           {"score", "--score", Value::kFlag, "Score the weights by similarity to those of three methods, 0 to 100"}}};
}

Tool lod_tool() {
  return {
      "lod", "Make levels of detail",
      "Makes copies of a bound character with fewer and fewer triangles. Returns a line of JSON per level, with its "
      "error.",
      true,
      joined(profile_arguments(), {{"character", "", Value::kInput, "Bound character (" + mesh_files() + ")", true},
                                   {"output", "-o", Value::kOutputs,
                                    "Base name of the levels NAME.lod1, NAME.lod2, ..., below the served folder: " +
                                        extensions_text(kWritesWhole),
                                    true},
                                   {"levels", "--levels", Value::kNumber, "Number of levels, 1 to 8; 3 by default"},
                                   {"triangles", "--triangles", Value::kNumber,
                                    "Triangles of a level as a share of the level before; 0.5 by default"},
                                   {"fewer_joints", "--fewer-joints", Value::kFlag, "Reduce joints from level 2 on"}})};
}

Tool transfer_tool() {
  return {"transfer", "Transfer weights",
          "Transfers the weights of a finished character to another mesh. Returns their confidence.", true,
          joined(profile_arguments(),
                 {{"source", "", Value::kInput, "Bound character (" + mesh_files() + ")", true},
                  {"target", "", Value::kInput, "Mesh to bind (" + mesh_files() + ")", true},
                  output_argument(extensions_text(kWritesSkin)),
                  {"skeleton", "--skeleton", Value::kInput,
                   "Skeleton for the target from another file (" + skeleton_files() + ")"},
                  {"map", "--map", Value::kInput, "Joint map: lines TARGET_JOINT SOURCE_JOINT, - for none"},
                  {"garment", "--garment", Value::kFlag, "The source wears the target: same space, same skeleton"},
                  {"picture", "--png", Value::kOutput, "Also draw the mesh colored by weight: .png"}})};
}

Tool map_tool() {
  return {"map",
          "Map joints",
          "Matches the joints of a skeleton to those of another. Returns the confidence of each pair. The map can be "
          "edited and passed to animate or transfer.",
          true,
          {{"target", "", Value::kInput, "Skeleton to map (" + skeleton_files() + ")", true},
           {"from", "--from", Value::kInput, "Skeleton or motion with the sources"},
           {"to", "--to", Value::kText, "Names of a standard rig, such as mixamo, instead of from"},
           {"output", "-o", Value::kOutput, "File to write, below the served folder: .txt or .map", true},
           {"map", "--map", Value::kInput, "Pairs to keep; the rest is matched"},
           {"picture", "--png", Value::kOutput, "Also draw both skeletons with their pairs: .png"}}};
}

Tool bake_tool() {
  return {"bake",
          "Bake corrected bends",
          "Bakes bends that keep their volume into morph targets, for programs with linear skinning only. Returns the "
          "error before and after.",
          true,
          {{"character", "", Value::kInput, "Bound character (" + mesh_files() + ")", true},
           output_argument(extensions_text(kWritesWhole)),
           {"poses", "--poses", Value::kNumber, "Number of training poses, 1500 by default"},
           {"error", "--error", Value::kNumber,
            "Threshold for leaving out shapes, in percent of the size; smaller values make larger files"},
           {"animation", "--animation", Value::kText, "Train on one of the file's animations"}}};
}

Tool simplify_tool() {
  return {"simplify", "Leave out joints",
          "Makes a bound character with fewer joints; weights and animations follow. Returns the remaining joints.",
          true,
          joined(profile_arguments(),
                 {{"character", "", Value::kInput, "Bound character (" + mesh_files() + ")", true},
                  output_argument(extensions_text(kWritesWhole)),
                  {"level", "--level", Value::kText, "high, low, or a number of joints; high by default"}})};
}

Tool pose_tool() {
  return {
      "pose",
      "Draw a pose",
      "Draws a bound character in a pose. Returns the picture.",
      false,
      {{"character", "", Value::kInput, "Skinned file, or NAME.obj with NAME.rig.txt", true},
       output_argument(extensions_text(kWritesMesh) + " or .png"),
       {"joints", "--joint", Value::kRotations, "Degrees about x, then y, then z, by joint: {\"head\": [0, 30, 0]}"},
       {"animation", "--animation", Value::kText, "Animation of the file"},
       {"time", "--time", Value::kNumber, "Time in the animation, in seconds"},
       {"random", "--random", Value::kNumber, "Rotate every joint at random; a seed"}}};
}

Tool inspect_tool() {
  return {"inspect",
          "Describe a file",
          "Describes a mesh, character or model. Changes no file.",
          true,
          {{"file", "", Value::kInput, "File", true}}};
}

const std::vector<Tool>& tools() {
  static const std::vector<Tool> all = {rig_tool(),      bind_tool(), animate_tool(), springs_tool(),
                                        transfer_tool(), map_tool(),  check_tool(),   lod_tool(),
                                        simplify_tool(), bake_tool(), pose_tool(),    inspect_tool()};
  return all;
}

OrderedJson schema_of(const Argument& argument) {
  OrderedJson schema;
  switch (argument.value) {
    case Value::kNumber:
      schema["type"] = "number";
      break;
    case Value::kFlag:
      schema["type"] = "boolean";
      break;
    case Value::kTexts:
      schema = {{"type", "array"}, {"items", {{"type", "string"}}}};
      break;
    case Value::kRotations:
      schema = {{"type", "object"},
                {"additionalProperties",
                 {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}}}};
      break;
    default:
      schema["type"] = "string";
  }
  if (!argument.choices.empty()) schema["enum"] = argument.choices;
  schema["description"] = argument.meaning;
  return schema;
}

class CommandLine {
 public:
  CommandLine(const Tool& tool, const ServedFolder& folder) : tool_(tool), folder_(folder) {
    run_.words = {tool.name};
    run_.json = tool.json;
  }

  ToolRun of(const OrderedJson& arguments) {
    if (!arguments.is_object()) fail("arguments", "an object");
    for (const auto& [name, value] : arguments.items()) {
      const auto known = std::find_if(tool_.arguments.begin(), tool_.arguments.end(),
                                      [&name = name](const Argument& a) { return a.name == name; });
      if (known == tool_.arguments.end()) throw Error(tool_.name + ": no argument '" + printable(name) + "'");
    }
    for (const Argument& argument : tool_.arguments) {
      const auto value = arguments.find(argument.name);
      if (value != arguments.end() && !value->is_null())
        add(argument, *value);
      else if (argument.required)
        throw Error(tool_.name + ": expected an argument '" + argument.name + "': " + argument.meaning);
    }
    if (run_.json) run_.words.push_back("--json");
    return std::move(run_);
  }

 private:
  [[noreturn]] void fail(const std::string& name, const std::string& expected) const {
    throw Error(tool_.name + ": argument '" + name + "': expected " + expected);
  }

  std::string number(const Argument& argument, const OrderedJson& value) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) fail(argument.name, "a number");
    return print("%.9g", value.get<double>());
  }

  std::string text(const Argument& argument, const OrderedJson& value) const {
    if (!value.is_string()) fail(argument.name, "a text");
    std::string text = value.get<std::string>();
    if (text.size() > 1000 || text.find('\0') != std::string::npos)
      fail(argument.name, "a text of at most 1,000 characters");
    if (!argument.choices.empty() &&
        std::find(argument.choices.begin(), argument.choices.end(), text) == argument.choices.end())
      fail(argument.name, "one of " + listed(argument.choices));
    if (argument.option == "--motion" && text.rfind("builtin:", 0) != 0) fail(argument.name, "builtin:NAME");
    return text;
  }

  static std::string listed(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
    return all;
  }

  void put(const Argument& argument, const std::string& value) {
    // In one word with the option, so that no value passes for another option.
    if (argument.option.empty())
      run_.words.push_back(value);
    else if (argument.option.size() == 2)
      run_.words.insert(run_.words.end(), {argument.option, value});  // of files alone, which begin with ./
    else
      run_.words.push_back(argument.option + "=" + value);
  }

  void add(const Argument& argument, const OrderedJson& value) {
    switch (argument.value) {
      case Value::kInput:
        return put(argument, folder_.input(text(argument, value)));
      case Value::kOutput: {
        const std::string path = folder_.output(text(argument, value));
        run_.outputs.push_back(path.substr(2));
        return put(argument, path);
      }
      case Value::kOutputs:
        return put(argument, folder_.output(text(argument, value)));
      case Value::kText:
        return put(argument, text(argument, value));
      case Value::kTexts:
        if (!value.is_array()) fail(argument.name, "a list of texts");
        for (const OrderedJson& one : value) put(argument, text(argument, one));
        return;
      case Value::kNumber:
        return put(argument, number(argument, value));
      case Value::kFlag:
        if (!value.is_boolean()) fail(argument.name, "true or false");
        if (value.get<bool>()) run_.words.push_back(argument.option);
        return;
      case Value::kRotations:
        return rotations(argument, value);
    }
  }

  void rotations(const Argument& argument, const OrderedJson& value) {
    constexpr const char* kExpected = "three rotations in degrees per joint";
    if (!value.is_object()) fail(argument.name, kExpected);
    for (const auto& [joint, turn] : value.items()) {
      if (!turn.is_array() || turn.size() != 3 || joint.empty() || joint.size() > 1000 ||
          joint.find('\0') != std::string::npos)
        fail(argument.name, kExpected);
      put(argument,
          joint + "=" + number(argument, turn[0]) + "," + number(argument, turn[1]) + "," + number(argument, turn[2]));
    }
  }

  const Tool& tool_;
  const ServedFolder& folder_;
  ToolRun run_;
};

}  // namespace

OrderedJson tools_json() {
  OrderedJson list = OrderedJson::array();
  for (const Tool& tool : tools()) {
    OrderedJson properties = OrderedJson::object(), required = OrderedJson::array();
    bool writes = false;
    for (const Argument& argument : tool.arguments) {
      properties[argument.name] = schema_of(argument);
      if (argument.required) required.push_back(argument.name);
      writes = writes || argument.value == Value::kOutput || argument.value == Value::kOutputs;
    }
    list.push_back(
        {{"name", tool.name},
         {"title", tool.title},
         {"description", tool.meaning},
         {"inputSchema",
          {{"type", "object"}, {"properties", properties}, {"required", required}, {"additionalProperties", false}}},
         {"annotations", {{"readOnlyHint", !writes}, {"openWorldHint", false}}}});
  }
  return list;
}

ToolRun tool_run(const std::string& tool, const OrderedJson& arguments, const ServedFolder& folder) {
  const auto known = std::find_if(tools().begin(), tools().end(), [&](const Tool& t) { return t.name == tool; });
  if (known == tools().end()) throw Error("no tool '" + printable(tool) + "'");
  return CommandLine(*known, folder).of(arguments);
}

}  // namespace sinew::cli
