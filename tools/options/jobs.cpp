#include "options/jobs.h"

#include <algorithm>
#include <array>
#include <utility>

namespace transformesh::tool {
namespace {

using Job = std::pair<std::string_view, std::string_view>;

// tests/tools/tm.bats runs each command.
constexpr std::array<Job, 12> jobs{{
    {"repair a scan or a print", "tm-repair in.stl > solid.ply"},
    {"unite A and B", "tm-boolean union a.ply b.ply > union.ply"},
    {"cut B out of A", "tm-boolean difference a.ply b.ply > cut.ply"},
    {"cut it at a plane", "tm-select --plane 0,0,1,0 --cap a.ply > upper.ply"},
    {"reduce its faces", "tm-remesh --faces 500 a.ply > lighter.ply"},
    {"make triangles even", "tm-remesh a.ply > even.ply"},
    {"smooth it", "tm-remesh --only smooth a.ply > smooth.ply"},
    {"make it thicker", "tm-offset --distance 2% a.ply > thicker.ply"},
    {"align a scan with another", "tm-align --reference a.ply b.ply > placed.ply"},
    {"compare two meshes", "tm-compare a.ply b.ply"},
    {"morph A into B", "tm-morph a.ply --target b.ply --run morph"},
    {"watch a run", "tm-view --serve --run morph"},
}};

constexpr std::array<Alias, 17> aliases{{
    {"cut", "tm-select", "tm-select --plane 0,0,1,0 --cap a.ply"},
    {"decimate", "tm-remesh", "tm-remesh --faces 5000 a.ply"},
    {"difference", "tm-boolean", "tm-boolean difference a.ply b.ply"},
    {"hausdorff", "tm-compare", "tm-compare --get hausdorff a.ply b.ply"},
    {"icp", "tm-align", "tm-align --reference a.ply b.ply"},
    {"intersection", "tm-boolean", "tm-boolean intersection a.ply b.ply"},
    {"merge", "tm-cat", "tm-cat a.ply b.ply"},
    {"mirror", "tm-transform", "tm-transform --mirror x a.ply"},
    {"register", "tm-align", "tm-align --reference a.ply b.ply"},
    {"scale", "tm-transform", "tm-transform --scale 2 a.ply"},
    {"section", "tm-select", "tm-select --plane 0,0,1,0 --section outline.svg a.ply"},
    {"simplify", "tm-remesh", "tm-remesh --faces 5000 a.ply"},
    {"slice", "tm-select", "tm-select --plane 0,0,1,0 --section outline.svg a.ply"},
    {"smooth", "tm-remesh", "tm-remesh --only smooth a.ply"},
    {"split", "tm-select", "tm-select --split part a.ply"},
    {"union", "tm-boolean", "tm-boolean union a.ply b.ply"},
    {"weld", "tm-stitch", "tm-stitch a.stl"},
}};

}  // namespace

std::string list_of_jobs() {
  std::string text;
  for (const auto& [job, command] : jobs) {
    std::string line(job);
    line.resize(26, ' ');
    text += line.append(command) + '\n';
  }
  return text;
}

const Alias* alias_of(std::string_view word) {
  const auto found = std::ranges::find(aliases, word, &Alias::word);
  return found == aliases.end() ? nullptr : &*found;
}

}  // namespace transformesh::tool
