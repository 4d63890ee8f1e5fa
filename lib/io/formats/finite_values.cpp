#include "io/formats/finite_values.h"

#include <algorithm>
#include <cmath>

#include "io/document/finite_positions.h"
#include "io/document/scalar.h"
#include "support/counted.h"

namespace transformesh {
namespace {

using Group = std::vector<Column*>;

/// Returns the floating-point columns with these names. Returns an empty group if one of the
/// columns is missing, is a list or has an integer type.
Group floating_group(Columns& columns, std::initializer_list<std::string_view> names) {
  Group group;
  for (const std::string_view name : names) {
    Column* column = columns.find(name);
    if (column == nullptr || column->list_count_type || !is_floating(column->type)) return {};
    group.push_back(column);
  }
  return group;
}

bool is_finite_row(const Group& group, std::size_t row) {
  return std::all_of(group.begin(), group.end(),
                     [&](const Column* column) { return std::isfinite(column->values[row]); });
}

void zero_group(const Group& group, const Source& source, const std::string& what,
                const std::string& element, const std::string& format,
                std::vector<std::string>& notes) {
  if (group.empty()) return;
  std::size_t count = 0;
  for (std::size_t row = 0; row < group[0]->values.size(); ++row) {
    if (is_finite_row(group, row)) continue;
    if (source.is_strict)
      source.fail("the " + what + " of " + element + ' ' + std::to_string(row) +
                  " is not a finite number");
    for (Column* column : group) column->values[row] = 0;
    ++count;
  }
  note_zeroed(count, what, format, notes);
}

}  // namespace

void drop_points_not_finite(Mesh& mesh, std::size_t dropped_faces, const std::string& format,
                            std::vector<std::string>& notes) {
  std::vector<std::uint32_t> kept;
  if (are_finite(mesh.positions)) return;
  std::vector<Index> number(mesh.positions.size(), no_index);
  for (Index v = 0; v < number.size(); ++v) {
    if (!mesh.positions[v].allFinite()) continue;
    number[v] = static_cast<Index>(kept.size());
    mesh.positions[kept.size()] = mesh.positions[v];
    kept.push_back(v);
  }
  const std::size_t dropped = number.size() - kept.size();
  mesh.positions.resize(kept.size());
  mesh.vertex_columns = mesh.vertex_columns.select(kept);

  std::vector<std::uint32_t> kept_faces;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    Face face = mesh.faces[f];
    for (Index& corner : face) corner = number[corner];
    if (std::find(face.begin(), face.end(), no_index) != face.end()) continue;
    mesh.faces[kept_faces.size()] = face;
    kept_faces.push_back(f);
  }
  dropped_faces += mesh.faces.size() - kept_faces.size();
  mesh.faces.resize(kept_faces.size());
  mesh.face_columns = mesh.face_columns.select(kept_faces);
  std::string note =
      format + ": " + counted(dropped, "vertex") + " with a coordinate that is not finite dropped";
  if (dropped_faces > 0)
    note += ", and " + counted(dropped_faces, "face") + " that " +
            (dropped_faces == 1 ? "uses " : "use ") + (dropped == 1 ? "it" : "them");
  notes.push_back(note);
}

void zero_values_not_finite(Columns& columns, const Source& source, const std::string& element,
                            const std::string& format, std::vector<std::string>& notes) {
  zero_group(floating_group(columns, {"nx", "ny", "nz"}), source, "normal", element, format, notes);
  Group color = floating_group(columns, {"red", "green", "blue"});
  const Group alpha = floating_group(columns, {"alpha"});
  if (!color.empty()) color.insert(color.end(), alpha.begin(), alpha.end());
  zero_group(color, source, "color", element, format, notes);
}

void note_zeroed(std::size_t count, const std::string& what, const std::string& format,
                 std::vector<std::string>& notes) {
  if (count == 0) return;
  notes.push_back(format + ": " + counted(count, what) +
                  (count == 1 ? " that is not finite becomes 0" : " that are not finite become 0"));
}

void note_rounded_integers(const std::vector<double>& values, const std::string& what,
                           const std::string& format, std::vector<std::string>& notes) {
  constexpr double limit = 0x1p53;  // doubles hold all smaller integers
  const auto count =
      std::ranges::count_if(values, [&](double value) { return std::abs(value) >= limit; });
  if (count == 0) return;
  notes.push_back(format + ": " + counted(static_cast<std::size_t>(count), "integer") + " of " +
                  what + (count == 1 ? " is" : " are") +
                  " 2^53 or larger, and may be rounded: numbers are kept as doubles");
}

}  // namespace transformesh
