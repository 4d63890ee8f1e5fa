#include "tm/evolve/target_file.h"

#include "tm/evolve/point_text.h"
#include "tm/io/mesh_io.h"

namespace transformesh {

Target read_target(std::string_view bytes, const std::string& name) {
  const Source source{bytes, name};
  if (is_point_text(source)) return make_target(read_point_text(source));
  return make_target(read_mesh(bytes, name).document.mesh);
}

std::string write_target(const Target& target) {
  Document document;
  document.mesh.positions = target.mesh.positions;
  document.mesh.faces = target.mesh.faces;
  if (!target.is_mesh()) {
    document.style.element_order = {"vertex"};
    set_normal_columns(document.mesh, target.normals);
  }
  return write_mesh(document).bytes;
}

}  // namespace transformesh
