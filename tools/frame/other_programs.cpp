#include "frame/other_programs.h"

#include <algorithm>

namespace transformesh::tool {

// tests/tools/tm.bats checks that each option is in the help of its program.
const std::array<OtherProgram, 30> other_programs{{
    {"ascii", "tm-convert --format"},
    {"binary", "tm-convert --format"},
    {"cap", "tm-select --cap"},
    {"closed", "tm-checkmanifold --closed"},
    {"color-by", "tm-render --color-by"},
    {"count", "tm-sample --count"},
    {"curvature-speed", "tm-displace --curvature-speed"},
    {"decimate", "tm-remesh --faces"},
    {"distance", "tm-offset --distance"},
    {"edge", "tm-remesh --edge"},
    {"faces", "tm-remesh --faces"},
    {"feature-angle", "tm-remesh --feature-angle"},
    {"flip", "tm-stitch --flip"},
    {"largest", "tm-select --largest"},
    {"level", "tm-clean --level"},
    {"matrix", "tm-transform --matrix"},
    {"merge-flat", "tm-clean --merge-flat"},
    {"mirror", "tm-transform --mirror"},
    {"normal-speed", "tm-displace --normal-speed"},
    {"orient", "tm-stitch --orient"},
    {"plane", "tm-select --plane"},
    {"reference", "tm-compare --reference"},
    {"rotate", "tm-transform --rotate"},
    {"scale", "tm-transform --scale"},
    {"simplify", "tm-remesh --faces"},
    {"smooth", "tm-remesh --smooth"},
    {"target", "tm-morph --target"},
    {"tolerance", "tm-stitch --tolerance"},
    {"translate", "tm-transform --translate"},
    {"weld", "tm-stitch --tolerance"},
}};

std::string command_with(std::string_view option) {
  const auto found = std::ranges::find(other_programs, option, &OtherProgram::option);
  return found == other_programs.end() ? std::string() : std::string(found->command);
}

}  // namespace transformesh::tool
