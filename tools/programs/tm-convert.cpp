/// tm-convert: converts a mesh to another format, encoding or scalar type. The frame (program.h)
/// reads, converts and writes the mesh.
#include "frame/run.h"

int main(int argc, char** argv) {
  using namespace transformesh;
  tool::Program program{"tm-convert", "[OPTION]... [INPUT]", "Converts between mesh formats"};
  program.epilog = "Endings of -o that choose a format: .ply .off .obj .stl .glb .vtp .3mf .xyz";
  program.input.may_keep_polygons = true;
  program.example = "tm-convert mesh.ply -o mesh.stl";
  return program.run(argc, argv, [](tool::Run&) {});
}
