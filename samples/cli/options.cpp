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
    {"--actor", "NAME|N", "Of a file of several people: the root's name or number"},
    {"--animation", "NAME", "One of the file's own animations, by name or number"},
    {"--as-drawn", "", "The method as published, without what is ours"},
    {"--body-contact", "", "Keep arms and thighs out of the body, for volume and xpbd"},
    {"--cache", "DIR", "Folder for computed features"},
    {"--calibrate", "DIR", "Characters that the ranges of integers are measured on"},
    {"--cells", "N", "Cells of the lattice along the longest side, for volume and xpbd"},
    {"--checkpoint", "FILE", "Float checkpoint of sinew-lab train"},
    {"--config", "FILE", "Settings that differ from the defaults, as JSON"},
    {"--cut", "", "Open what has grown together as a slit: vertices along it are doubled"},
    {"--deform", "METHOD", "How vertices follow their joints"},
    {"--detail", "DETAIL", "How much of the body has joints"},
    {"--format", "FORMAT", "What to write where several files come out"},
    {"--from-up", "AXIS", "Axis that points up in the other file"},
    {"--groups", "FILE", "Families that stay together, as JSON"},
    {"--influences", "N", "Most joints per vertex"},
    {"--jobs", "N", "Files at the same time; the same bytes for any N"},
    {"--joints", "JOINTS", "Which joints may get weight: own, names, all"},
    {"--json", "", "Print what was done as JSON"},
    {"--label", "TEXT", "Name in tables"},
    {"--layout", "NAME", "Which joints places alone are, of .npy and .npz"},
    {"--limit", "DEGREES", "Largest angle by which a random pose rotates a joint"},
    {"--lock", "FILE|all", "Vertices that keep the weights they have: all, or one 0-based index per line"},
    {"--map", "FILE", "Which joint is which: lines TARGET_JOINT SOURCE_JOINT, - for none"},
    {"--method", "METHOD", "Which method does it"},
    {"--minutes", "N", "Stop after so many minutes"},
    {"--model", "FILE", "Model file, or bundled = the one in the program"},
    {"--no-smoothing", "", "Leave bends as they are solved, for xpbd"},
    {"--output", "OUT", "What to write"},
    {"--png", "FILE", "Also draw a picture"},
    {"--png-confidence", "FILE", "Also draw where to look: dark blue = sure, red = least sure"},
    {"--questions", "N", "How many parts to ask about, those whose answers are worth most"},
    {"--quiet", "", "No progress and no last words"},
    {"--release", "CKPT", "Also write the float weights alone, without the state of the run"},
    {"--report", "PAGE.html", "Also write a page with tables and pictures"},
    {"--resume", "", "Go on with a stopped run, with the same result"},
    {"--rounds", "N", "Rounds of the solver or, for delta-mush, of smoothing"},
    {"--seed", "N", "Seed of what is drawn at random; the same seed gives the same everywhere"},
    {"--shapes", "N", "Most morph targets, a bend or a clip"},
    {"--skeleton", "FILE", "Skeleton of another file"},
    {"--steps", "N", "Steps of training"},
    {"--stiffness", "K", "Of the springs in the lattice's tetrahedra, for xpbd"},
    {"--tet-weights", "SOURCE", "Where the lattice's tetrahedra have their weights from, for xpbd: skin, distance"},
    {"--threads", "N", "Threads at work"},
    {"--to-pose", "POSE",
     "Put into a rest pose: t, a, or a file whose skeleton stands so; none: as it stands, also where --for has a pose"},
    {"--up", "AXIS", "Axis that points up"},
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
  section(sub, "Where the mesh is, before anything else");
  sub->add_option("--turn", transform->turns,
                  "A quarter turn about an axis, x brings y to z; may be repeated, one after the other")
      ->type_name("AXIS")
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z"}));
  sub->add_option("--height", transform->height, "Scaled to be so tall, along y, with --up z along z")
      ->type_name("METRES")
      ->check(CLI::PositiveNumber);
  sub->add_flag("--floor", transform->floor, "The lowest vertex at 0");
}

}  // namespace sinew::cli
