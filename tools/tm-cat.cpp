/// tm-cat: several meshes as one, one after the other.
#include <algorithm>
#include <utility>

#include "tool.h"

namespace {

using namespace transformesh;

void append_mesh(Mesh& all, const Mesh& other) {
  const auto offset = static_cast<Index>(all.positions.size());
  all.vertex_columns.concatenate(other.vertex_columns, all.positions.size(),
                                 other.positions.size());
  all.face_columns.concatenate(other.face_columns, all.faces.size(), other.faces.size());
  all.positions.insert(all.positions.end(), other.positions.begin(), other.positions.end());
  for (const Face& face : other.faces) {
    all.faces.push_back({face[0] + offset, face[1] + offset, face[2] + offset});
  }
}

void append_element(std::vector<OtherElement>& all, const OtherElement& other) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const OtherElement& element) {
    return element.name == other.name;
  });
  if (same == all.end()) {
    all.push_back(other);
    return;
  }
  same->columns.concatenate(other.columns, same->rows, other.rows);
  same->rows += other.rows;
}

// Lines that are not there yet. A reference edge belongs to one mesh: the first keeps its own.
void append_lines(std::vector<std::string>& all, const std::vector<std::string>& other) {
  for (const std::string& line : other) {
    const bool is_present = std::find(all.begin(), all.end(), line) != all.end();
    if (!is_present && !line.starts_with("tm:reference-edge")) all.push_back(line);
  }
}

void append(Document& all, const Document& other) {
  append_mesh(all.mesh, other.mesh);
  for (const OtherElement& element : other.other_elements) {
    append_element(all.other_elements, element);
  }
  append_lines(all.style.comments, other.style.comments);
  append_lines(all.style.obj_info, other.style.obj_info);
  if (other.style.coordinate == Scalar::float64) all.style.coordinate = Scalar::float64;
}

Document concatenate(std::vector<Document> documents, tool::Run& run) {
  Document all = std::move(documents[0]);
  for (std::size_t i = 1; i < documents.size(); ++i) append(all, documents[i]);
  run.report("meshes", documents.size());
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  tool::Program program("tm-cat", "[OPTION]... [INPUT]...", "Concatenates meshes");
  program.epilog("The union of overlapping bodies: tm-cat a.ply b.ply | tm-clean > union.ply");
  return program.combine(argc, argv, concatenate);
}
