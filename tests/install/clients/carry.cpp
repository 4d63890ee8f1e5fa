// Carries the column x = position.x from a sphere to a finer one and compares it with positions.
#include <transformesh/carry.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh source = make_sphere(Vec3::Zero(), 1, 500);
  Column& x = source.vertex_columns.get("x_of_source", Scalar::float64, source.positions.size());
  for (std::size_t v = 0; v < source.positions.size(); ++v) x.values[v] = source.positions[v].x();
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 2000);
  const SourcePoints points = closest_source_points(source, mesh);
  const CarryResult result = carry_columns(source, points, mesh);
  const Column* carried = mesh.vertex_columns.find("x_of_source");
  if (result.vertex_columns != 1 || !carried) return 1;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (std::abs(carried->values[v] - mesh.positions[v].x()) > 0.03) return 1;
  try {
    carry_columns(source, points, mesh, {"no_such_column"});
  } catch (const InputError&) {
    return points.of_faces.size() == mesh.faces.size() ? 0 : 1;
  }
  return 1;
}
