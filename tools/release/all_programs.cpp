// An executable that contains all programs, for the portable tarball. Symbolic links to it have the
// names of the programs. It runs the program whose name it is called by, or `tm` for any other
// name. The programs share nearly all of their code, so the executable has a fifteenth of the size
// of all separate programs.
#include "all_programs.h"

using namespace transformesh;

int main(int argc, char** argv) {
  std::string_view name = argc > 0 ? argv[0] : "tm";
  name.remove_prefix(name.rfind('/') + 1);  // without a slash, npos + 1 is 0
  for (const tool::NamedMain& program : tool::all_programs)
    if (program.name == name) return program.main(argc, argv);
  return main_of_tm(argc, argv);
}
