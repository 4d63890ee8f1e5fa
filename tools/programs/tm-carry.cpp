/// tm-carry: columns from the first mesh of a chain to the last.
#include <sstream>

#include "frame/run.h"
#include "geometry/source_points.h"
#include "transformesh/carry.h"
#include "transformesh/errors.h"

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

// Places of the vertices and faces of a mesh on the one before.
SourcePoints places_on(const Mesh& before, const std::string& before_name, const Mesh& mesh,
                       const std::string& name, const Options& options) {
  if (options.closest && !has_source_points(mesh)) return closest_source_points(before, mesh);
  if (!has_source_points(mesh))
    throw InputError(
        name +
        " does not state where its vertices and faces come from: write it with tm-clean --source "
        "or tm-remesh --source, or take the closest places with --closest");
  return read_source_points(mesh, before.faces.size(), before_name);
}

void carry(const Options& options, tool::Run& run) {
  const Mesh first = run.read(options.from).mesh;
  std::vector<Document>& chain = run.documents();
  SourcePoints on_first = places_on(first, options.from, chain[0].mesh, run.inputs()[0], options);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Mesh& before = chain[i - 1].mesh;
    on_first = compose_source_points(
        first, on_first, before,
        places_on(before, run.inputs()[i - 1], chain[i].mesh, run.inputs()[i], options));
  }

  std::swap(chain.front(), chain.back());
  Mesh& mesh = run.document().mesh;
  const CarryResult result = carry_columns(first, on_first, mesh, names_in(options.columns));
  write_source_points(mesh, on_first);
  run.report("vertex_columns", result.vertex_columns);
  run.report("face_columns", result.face_columns);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-carry", "--from FIRST [OPTION]... [BETWEEN]... [LAST]",
                        "Carries properties from the first mesh of a chain to the last",
                        tool::Reads::meshes};
  program.text("from", &options.from, "FILE", "the mesh that has the properties").is_needed = true;
  program.text("columns", &options.columns, "NAMES",
               "carry these, separated by commas (default: all but normals)");
  program.flag("closest", &options.closest,
               "what does not state where it comes from takes the closest places");
  program.epilog =
      "Texture coordinates through two steps:\n"
      "  tm-clean --source a.ply > b.ply\n"
      "  tm-remesh --source b.ply | tm-carry --from a.ply b.ply - > c.ply";
  return program.run(argc, argv, [&](tool::Run& run) { carry(options, run); });
}
