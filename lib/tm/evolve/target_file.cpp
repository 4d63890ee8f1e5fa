#include "tm/evolve/target_file.h"

#include <algorithm>

#include "tm/evolve/point_text.h"
#include "tm/io/mesh_io.h"

namespace transformesh {
namespace {

constexpr const char* spatial_order = "tm:faces in spatial order";

bool is_in_spatial_order(const Document& document) {
  const std::vector<std::string>& comments = document.style.comments;
  return std::find(comments.begin(), comments.end(), spatial_order) != comments.end();
}

}  // namespace

Target read_target(std::string_view bytes, const std::string& name) {
  const Source source{bytes, name};
  if (is_point_text(source)) return make_target(read_point_text(source));
  Document document = read_mesh(bytes, name).document;
  const bool is_in_order = is_in_spatial_order(document);
  Target target = make_target(std::move(document.mesh));
  if (is_in_order) target.face_order = FaceOrder::spatial;
  return target;
}

std::string write_target(const Target& target) {
  Document document;
  document.mesh.positions = target.mesh.positions;
  if (target.is_mesh()) {
    for (const Index face : spatial_face_order(target.mesh))
      document.mesh.faces.push_back(target.mesh.faces[face]);
    document.style.comments.emplace_back(spatial_order);
  } else {
    document.style.element_order = {"vertex"};
    set_normal_columns(document.mesh, target.normals);
  }
  return write_mesh(document).bytes;
}

}  // namespace transformesh
