#include "boolean/operands.h"

#include <string>
#include <utility>

#include "clean/intersect/welded_mesh.h"
#include "clean/open/borders.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/surface_columns.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

void append(Mesh& all, const Mesh& other) {
  const auto first = static_cast<Index>(all.positions.size());
  all.vertex_columns.concatenate(other.vertex_columns, all.positions.size(),
                                 other.positions.size());
  all.face_columns.concatenate(other.face_columns, all.faces.size(), other.faces.size());
  all.positions.insert(all.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.faces) all.faces.push_back({first + a, first + b, first + c});
}

Borders borders_of(const Operand& operand) {
  const WeldedMesh welded = weld(*operand.mesh);
  try {
    return find_oriented_borders(welded, *operand.mesh);
  } catch (const InputError& error) {
    throw InputError(error.kind(), operand.name + ": " + error.what(), error.data());
  }
}

}  // namespace

std::vector<Operand> rounded_operands(std::vector<Operand> operands, Scalar coordinate,
                                      std::deque<Mesh>& rounded) {
  for (Operand& operand : operands) {
    std::optional<Mesh> changed = rounded_mesh(*operand.mesh, coordinate);
    if (changed) operand.mesh = &rounded.emplace_back(std::move(*changed));
  }
  return operands;
}

JoinedOperands join_operands(BooleanOperation operation, const std::vector<Operand>& operands) {
  JoinedOperands joined;
  std::size_t vertices = 0, faces = 0;
  for (const Operand& operand : operands) {
    vertices += operand.mesh->positions.size();
    faces += operand.mesh->faces.size();
  }
  joined.mesh.positions.reserve(vertices);
  joined.mesh.faces.reserve(faces);
  for (Index i = 0; i < operands.size(); ++i) {
    const bool is_reversed = operation == BooleanOperation::subtract && i > 0;
    joined.is_reversed.push_back(is_reversed ? 1 : 0);
    joined.operand_of.resize(joined.operand_of.size() + operands[i].mesh->faces.size(), i);
    if (is_reversed) {
      Mesh reversed = *operands[i].mesh;
      reverse_faces(reversed);
      append(joined.mesh, reversed);
    } else {
      append(joined.mesh, *operands[i].mesh);
    }
  }
  return joined;
}

void check_solids(const std::vector<Operand>& operands) {
  for (const Operand& operand : operands) {
    if (operand.mesh->faces.empty()) continue;
    const std::size_t borders = borders_of(operand).loops.size();
    if (borders > 0)
      throw InputError(ErrorKind::not_closed,
                       operand.name + " has " + counted(borders, "border") + ": it is not a solid",
                       {.counts = {borders}});
  }
}

}  // namespace transformesh
