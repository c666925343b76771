// SPDX-License-Identifier: MIT
// The table of names that several commands have. A name that is not in it belongs to one command.
#include "options.hpp"

#include <stdexcept>

namespace sinew::cli {

std::string picture_files() { return extensions_text(kReadsPicture); }
std::string mesh_files() { return extensions_text(kReadsMesh); }
std::string skeleton_files() { return extensions_text(kReadsSkeleton); }
std::string motion_files() { return extensions_text(kReadsMotion); }

std::vector<std::string> format_names(uint32_t uses) {
  std::vector<std::string> names = extensions_of(uses);
  for (std::string& name : names) name.erase(0, 1);
  return names;
}

std::string skin_output_text(const std::string& more) {
  return extensions_text(kWritesSkin) + " (a .gltf with its .bin), - for rig.txt on standard output; " + more;
}

namespace {

constexpr OptionWord kWords[] = {
    {"--actor", "NAME|N", "Actor of a file with several people: name of the root, or number"},
    {"--animation", "NAME", "Animation of the file, by name or number"},
    {"--as-drawn", "", "Use the method as published, without sinew's changes"},
    {"--body-contact", "", "Keep arms and thighs out of the body, for volume and xpbd"},
    {"--cache", "DIR", "Folder for computed features"},
    {"--calibrate", "DIR", "Characters that the integer ranges are measured on"},
    {"--cells", "N", "Number of lattice cells along the longest side, for volume and xpbd"},
    {"--checkpoint", "FILE", "Float checkpoint of sinew-lab train"},
    {"--config", "FILE", "Configuration that differs from the defaults, as JSON"},
    {"--cut", "", "Cut fused parts open as a slit; the vertices along it are doubled"},
    {"--deform", "METHOD", "Deformation of vertices by their joints"},
    {"--detail", "DETAIL", "Extent of the skeleton"},
    {"--format", "FORMAT", "Format of the output files"},
    {"--from-up", "AXIS", "Up axis of the other file"},
    {"--groups", "FILE", "Families that stay together, as JSON"},
    {"--influences", "N", "Maximum number of joints per vertex"},
    {"--jobs", "N", "Number of files in parallel; the result is the same for any N"},
    {"--joints", "JOINTS", "Joints that may get weight: own, names, all"},
    {"--json", "", "Print the result as JSON"},
    {"--label", "TEXT", "Label in tables"},
    {"--layout", "NAME", "Keypoint layout of a .npy or .npz file"},
    {"--limit", "DEGREES", "Maximum rotation of a joint in a random pose"},
    {"--lock", "FILE|all", "Vertices that keep their weights: all, or one 0-based index per line"},
    {"--map", "FILE", "Joint map: lines TARGET_JOINT SOURCE_JOINT, - for none"},
    {"--method", "METHOD", "Method"},
    {"--minutes", "N", "Stop after this many minutes"},
    {"--model", "FILE", "Model file, or bundled = the built-in model"},
    {"--no-smoothing", "", "Leave bends as the solver returns them, for xpbd"},
    {"--output", "OUT", "Output file"},
    {"--png", "FILE", "Also draw a picture"},
    {"--png-confidence", "FILE", "Also draw the confidence: dark blue = high, red = low"},
    {"--questions", "N", "Number of parts to ask about, most useful first"},
    {"--quiet", "", "Print nothing but errors"},
    {"--release", "CKPT", "Also write the float weights alone, without the training state"},
    {"--report", "PAGE.html", "Also write a page with tables and pictures"},
    {"--resume", "", "Continue a stopped run, with the same result"},
    {"--rounds", "N", "Number of iterations of the solver or, for delta-mush, of smoothing"},
    {"--seed", "N", "Random seed; a seed gives the same result on every machine"},
    {"--shapes", "N", "Maximum number of morph targets"},
    {"--skeleton", "FILE", "Skeleton from another file"},
    {"--steps", "N", "Number of training steps"},
    {"--stiffness", "K", "Stiffness of the springs in the lattice's tetrahedra, for xpbd"},
    {"--tet-weights", "SOURCE", "Weights of the lattice's tetrahedra, for xpbd: skin, distance"},
    {"--threads", "N", "Number of threads"},
    {"--to-pose", "POSE",
     "Rest pose to put the result into: t, a, or a file with a skeleton in that pose; none: as it is, even if --for "
     "has a pose"},
    {"--up", "AXIS", "Up axis"},
    {"--val", "DIR", "Characters for validation"},
};

std::string long_name(const std::string& names) { return names.substr(names.rfind("--")); }

}  // namespace

const OptionWord& option_word(const std::string& names) {
  for (const OptionWord& word : kWords)
    if (long_name(names) == word.name) return word;
  throw std::logic_error(names + " is in no row of the table of options");
}

std::string sentences(const std::string& meaning, const std::string& more) {
  return more.empty() ? meaning : meaning + ". " + more;
}

CLI::Option* shared_flag(CLI::App* sub, const std::string& name, bool& value, const std::string& more) {
  return sub->add_flag(name, value, sentences(option_word(name).meaning, more));
}

void section(CLI::App* sub, const std::string& heading) { sub->option_defaults()->group(heading); }

CLI::Option* add_influences(CLI::App* sub, unsigned& count) {
  return shared_option(sub, "--influences", count)->check(CLI::Range(1, 12))->capture_default_str();
}

CLI::Option* add_jobs(CLI::App* sub, unsigned& jobs, const std::string& more) {
  return shared_option(sub, "--jobs", jobs, more)->check(CLI::Range(1, 256));
}

void add_transform_options(CLI::App* sub, CharacterTransform* transform) {
  section(sub, "Transform of the mesh, before everything else");
  sub->add_option("--turn", transform->turns,
                  "Rotate by 90 degrees about an axis, x rotates y to z; repeatable, in order")
      ->type_name("AXIS")
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z"}));
  sub->add_option("--height", transform->height, "Scale to this height, along y, or along z with --up z")
      ->type_name("METERS")
      ->check(CLI::PositiveNumber);
  sub->add_flag("--floor", transform->floor, "Move the lowest vertex to height 0");
}

}  // namespace sinew::cli
