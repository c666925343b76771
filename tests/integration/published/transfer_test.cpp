// SPDX-License-Identifier: MIT
// What weight relocation by biharmonic distances promises, on the samples: a mesh keeps its own weights, as drawn and as shipped,
// and a body of another build gets like ones. By the command.
#include <string>
#include <vector>

#include "cli_fixture.hpp"

namespace sinew {
namespace {

constexpr const char* kTransferred[] = {"biped__robot", "snake__long"};
constexpr const char* kWays[] = {"", " --as-drawn"};

Character bound(const std::string& mesh, const std::string& rig) {
  Character character = read_obj(mesh);
  read_skeleton(rig, true, &character);
  return character;
}

class PublishedTransfer : public Cli {
 protected:
  double moved(const Character& expected, const std::string& sample, const std::string& target,
               const std::string& method) {
    good("transfer " + kData + "/" + sample + ".obj " + target + " --method " + method +
         " --influences 8 -o out.rig.txt");
    return mean_l1(expected, bound(in(target), in("out.rig.txt")));
  }
};

TEST_F(PublishedTransfer, AMeshOntoItselfKeepsItsWeights) {
  for (const std::string sample : kTransferred) {
    fs::copy(kData + "/" + sample + ".obj", in("own.obj"), fs::copy_options::overwrite_existing);
    fs::copy(kData + "/" + sample + ".rig.txt", in("own.rig.txt"), fs::copy_options::overwrite_existing);
    const Character own = bound(in("own.obj"), in("own.rig.txt"));
    for (const char* way : kWays)
      EXPECT_LE(moved(own, sample, "own.obj", std::string("biharmonic") + way), 0.001) << sample << way;
  }
}

// A third wider, a quarter lower. Nearest points of bodies that were aligned are what relocation must not fall far behind. As drawn it
// does: distances to all reference points say how large a body is (engine/src/published/README.md).
TEST_F(PublishedTransfer, AnotherBuildGetsLikeWeights) {
  const std::string sample = "biped__robot";
  Character other = bound(kData + "/" + sample + ".obj", kData + "/" + sample + ".rig.txt");
  const auto reshape = [](auto& p) {
    p.x *= 1.33f;
    p.y *= 0.75f;
  };
  for (auto& p : other.vertices) reshape(p);
  for (auto& joint : other.joints) reshape(joint.position);
  write_obj(in("other.obj"), other);
  write_rig(in("other.rig.txt"), other);
  const double nearest = moved(other, sample, "other.obj", "nearest");
  EXPECT_LE(moved(other, sample, "other.obj", "biharmonic"), nearest + 0.05);
}

}  // namespace
}  // namespace sinew
