// Appends a sphere with a column to a sphere without one and checks counts, indices and values.
#include <transformesh/document.h>
#include <transformesh/shapes.h>

using namespace transformesh;

int main() {
  Document all{.mesh = make_sphere(Vec3::Zero(), 1, 300)};
  Document other{.mesh = make_sphere(Vec3(3, 0, 0), 1, 500)};
  all.style.comments = {"one", "two"};
  other.style.comments = {"two", "three"};
  const std::size_t rows = other.mesh.positions.size(), vertices = all.mesh.positions.size();
  other.mesh.vertex_columns.get("mark", Scalar::uint8, rows).values.assign(rows, 5);
  const std::size_t faces = all.mesh.faces.size() + other.mesh.faces.size();
  if (!append(all, other).empty() || all.mesh.faces.size() != faces) return 1;
  if (all.mesh.positions.size() != vertices + rows) return 1;
  if (all.mesh.faces.back()[0] != other.mesh.faces.back()[0] + vertices) return 1;
  const Column* mark = all.mesh.vertex_columns.find("mark");
  if (!mark || mark->values.front() != 0 || mark->values.back() != 5) return 1;
  if (all.style.comments != std::vector<std::string>{"one", "two", "three"}) return 1;
  return std::string(name_of(Format::ply_big)) == "ply-be" ? 0 : 1;
}
