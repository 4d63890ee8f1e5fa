/// tm-cat: concatenates meshes.
#include "frame/run.h"
#include "transformesh/document.h"

namespace {

using namespace transformesh;

void concatenate(tool::Run& run) {
  std::vector<Document>& documents = run.in().documents();
  for (std::size_t i = 1; i < documents.size(); ++i)
    for (const std::string& line : append(documents[0], documents[i])) run.note(line);
  run.report("meshes", documents.size());
}

}  // namespace

int main(int argc, char** argv) {
  tool::Program program{
      "tm-cat", "[OPTION]... [INPUT]...", "Concatenates meshes", {tool::Reads::meshes}};
  program.example = "tm-cat a.ply b.ply | tm-clean > union.ply";
  return program.run(argc, argv, concatenate);
}
