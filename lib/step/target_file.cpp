#include "step/target_file.h"

#include <algorithm>

#include "io/document/unit.h"
#include "step/prepare_target.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

constexpr const char* spatial_order = "tm:faces in spatial order";
constexpr const char* measured_gaps = "tm:gaps measured";
constexpr const char* gap_column = "gap";

bool has_comment(const Document& document, const char* comment) {
  const std::vector<std::string>& comments = document.style.comments;
  return std::find(comments.begin(), comments.end(), comment) != comments.end();
}

}  // namespace

Target read_target(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  auto [document, notes, soup] = read_mesh(bytes, name, options);
  Target target = make_target(std::move(document.mesh));
  target.notes = std::move(notes);
  if (const Unit* unit = unit_of(document)) target.unit = unit->name;
  target.is_prepared = has_comment(document, spatial_order);
  if (target.is_prepared) target.has_spatial_order = true;
  order_spatially(target);
  const Column* gaps = target.mesh.vertex_columns.find(gap_column);
  if (has_comment(document, measured_gaps) && gaps != nullptr) target.thickness = gaps->values;
  return target;
}

std::string write_target(const Target& target) {
  Document document;
  document.mesh.positions = target.mesh.positions;
  if (target.is_mesh()) {
    Target ordered;
    ordered.mesh = target.mesh;
    ordered.has_spatial_order = target.has_spatial_order;
    order_spatially(ordered);
    document.mesh.faces = std::move(ordered.mesh.faces);
    document.style.comments.emplace_back(spatial_order);
  } else {
    document.style.element_order = {"vertex"};
    set_normal_columns(document.mesh, target.normals);
  }
  if (!target.thickness.empty()) {
    Columns& columns = document.mesh.vertex_columns;
    columns.get(gap_column, Scalar::float64, target.thickness.size()).values = target.thickness;
    document.style.comments.emplace_back(measured_gaps);
  }
  return write_mesh(document).bytes;
}

}  // namespace transformesh
