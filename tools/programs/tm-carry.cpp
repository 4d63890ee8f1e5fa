/// tm-carry: transfers properties of vertices and faces through a chain of meshes, each made from
/// the previous one, from the first mesh to the last.
#include <sstream>

#include "frame/run.h"
#include "transformesh/carry.h"

namespace {

using namespace transformesh;

struct Options {
  std::string from;
  std::string columns;
  bool closest = false;
};

std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) names.push_back(word);
  return names;
}

void carry(const Options& options, tool::Run& run) {
  const Mesh first = run.in().read(options.from).mesh;
  std::vector<Document>& chain = run.in().documents();
  CarryOptions how{names_in(options.columns), options.closest, run.in().names()};
  how.names.insert(how.names.begin(), options.from);
  std::vector<const Mesh*> before{&first};
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) before.push_back(&chain[i].mesh);
  run.report(entries_of(carry_along(before, chain.back().mesh, how)));
  std::swap(chain.front(), chain.back());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-carry",
                        "--from FIRST [OPTION]... [BETWEEN]... [LAST]",
                        "Carries properties from the first mesh of a chain to the last",
                        {tool::Reads::meshes}};
  program.options.text("from", &options.from, "FILE", "mesh that has the properties").is_needed =
      true;
  program.options.text(
      "columns", &options.columns, "NAMES",
      "names of the properties to carry, separated by commas (default: all except normals)");
  program.options.flag("closest", &options.closest,
                       "use closest points if a mesh lacks source points, which tm-clean --source "
                       "and tm-remesh --source write");
  program.example = "tm-clean --source a.ply | tm-carry --from a.ply - > carried.ply";
  return program.run(argc, argv, [&](tool::Run& run) { carry(options, run); });
}
