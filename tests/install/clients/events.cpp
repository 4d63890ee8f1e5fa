// Finds no event in an evolution in which nothing changes, and names one.
#include <transformesh/events.h>
#include <transformesh/evolve.h>

using namespace transformesh;

int main() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  EvolveOptions options;
  options.iteration.remesh = RemeshOptions();
  options.finds_events = true;
  const auto still = step_along([](const Mesh& now, const Progress&) {
    return std::vector<Vec3>(now.positions.size(), Vec3::Zero());
  });
  const EvolveResult result = evolve(mesh, still, options, {.iterations = 1});
  const Column* labels = mesh.face_columns.find(component_label);
  if (labels == nullptr || labels->values.front() != 1) return 1;
  return result.event_count == 0 && name_of(EventKind::handle_closed) == "handle closed" ? 0 : 1;
}
