/// tm-cat: several meshes as one, one after the other.
#include <utility>

#include "tool.h"

namespace {

using namespace transformesh;

// Appends `other` to `all`: elements in order, columns united.
void append(Mesh& all, const Mesh& other) {
  const auto offset = static_cast<Index>(all.positions.size());
  all.vertex_columns.concatenate(other.vertex_columns, all.positions.size(),
                                 other.positions.size());
  all.face_columns.concatenate(other.face_columns, all.faces.size(), other.faces.size());
  all.positions.insert(all.positions.end(), other.positions.begin(), other.positions.end());
  for (const Face& face : other.faces) {
    all.faces.push_back({face[0] + offset, face[1] + offset, face[2] + offset});
  }
}

Document concatenate(std::vector<Document> documents, tool::Run& run) {
  Document all = std::move(documents[0]);
  for (std::size_t i = 1; i < documents.size(); ++i) append(all.mesh, documents[i].mesh);
  run.report("meshes", documents.size());
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  tool::Program program("tm-cat", "[OPTION]... [INPUT]...", "Concatenates meshes");
  return program.combine(argc, argv, concatenate);
}
