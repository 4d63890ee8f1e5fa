#include "mesh/face_conditions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mesh/local_measures.h"
#include "support/number.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

std::vector<double> sizes_of(const Mesh& mesh, const Components& all, ComponentSize by) {
  std::vector<double> sizes(all.components.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f)
    sizes[all.of_face[f]] += by == ComponentSize::area ? face_area(mesh, f) : 1;
  if (by == ComponentSize::volume)
    for (std::size_t c = 0; c < sizes.size(); ++c) sizes[c] = std::abs(all.components[c].volume);
  return sizes;
}

/// Returns the components in descending order of size; ties keep their order.
std::vector<std::size_t> by_size(const std::vector<double>& sizes) {
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  return order;
}

/// Returns the components in descending order of size. The sizes of extreme meshes are compared at
/// a usual scale, at which they neither overflow nor vanish.
std::vector<std::size_t> by_size(const Mesh& mesh, const Components& all, ComponentSize by) {
  const int exponent = extreme_exponent(mesh);
  if (exponent == 0 || by == ComponentSize::faces) return by_size(sizes_of(mesh, all, by));
  const Mesh usual = scaled_down(mesh, exponent);
  return by_size(sizes_of(usual, connected_components(usual), by));
}

/// Returns the vertices of each component, in ascending order.
std::vector<std::vector<Index>> vertices_of(const Mesh& mesh, const Components& all) {
  std::vector<Index> component(mesh.positions.size(), no_index);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (const Index vertex : mesh.faces[f]) component[vertex] = all.of_face[f];
  std::vector<std::vector<Index>> vertices(all.components.size());
  for (Index v = 0; v < component.size(); ++v)
    if (component[v] != no_index) vertices[component[v]].push_back(v);
  return vertices;
}

/// Returns a mesh of these faces and vertices. Writes the new vertex indices to `new_vertex`.
Mesh part_of(const Mesh& mesh, const std::vector<Index>& faces, const std::vector<Index>& vertices,
             std::vector<Index>& new_vertex) {
  Mesh part;
  for (const Index v : vertices) {
    new_vertex[v] = static_cast<Index>(part.positions.size());
    part.positions.push_back(mesh.positions[v]);
  }
  for (const Index f : faces) {
    const Face& face = mesh.faces[f];
    part.faces.push_back({new_vertex[face[0]], new_vertex[face[1]], new_vertex[face[2]]});
  }
  part.vertex_columns = mesh.vertex_columns.select(vertices);
  part.face_columns = mesh.face_columns.select(faces);
  return part;
}

std::vector<bool> faces_of(const Components& all, const std::vector<bool>& chosen) {
  std::vector<bool> keep(all.of_face.size());
  for (std::size_t f = 0; f < keep.size(); ++f) keep[f] = chosen[all.of_face[f]];
  return keep;
}

/// Returns the float nearest to a value, or the value itself if floats do not reach it.
double nearest_float(double value) {
  if (!(std::abs(value) <= std::numeric_limits<float>::max())) return value;
  return static_cast<double>(static_cast<float>(value));
}

struct Condition {
  std::string column, relation;
  double number = 0;

  bool holds(const Column& values, std::size_t row) const {
    const double value = values.values[row];
    // Text such as 0.1 stands for the float that is written as 0.1.
    return values.type == Scalar::float32 ? holds(nearest_float(value), nearest_float(number))
                                          : holds(value, number);
  }

 private:
  bool holds(double value, double limit) const {
    if (relation == "<") return value < limit;
    if (relation == "<=") return value <= limit;
    if (relation == ">") return value > limit;
    if (relation == ">=") return value >= limit;
    return (value == limit) == (relation == "=" || relation == "==");
  }
};

std::string without_outer_spaces(const std::string& text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

Condition parsed(const std::string& text) {
  const std::size_t begin = std::min(text.find_first_of("<>=!"), text.size());
  const std::size_t end = std::min(text.find_first_not_of("<>=!", begin), text.size());
  const std::string column = without_outer_spaces(text.substr(0, begin));
  const std::string relation = text.substr(begin, end - begin);
  const auto number = number_in<double>(without_outer_spaces(text.substr(end)));
  const std::vector<std::string> known{"<", "<=", "=", "==", "!=", ">=", ">"};
  if (column.empty() || !number || std::find(known.begin(), known.end(), relation) == known.end())
    throw UsageError("'" + text + "' is no condition such as 'intersections>0'");
  return {column, relation, *number};
}

const Column* numbers_of(const Columns& columns, const std::string& name) {
  const Column* column = columns.find(name);
  return column == nullptr || column->list_count_type ? nullptr : column;
}

}  // namespace

ComponentSize component_size_of(const std::string& word) {
  if (word == "faces") return ComponentSize::faces;
  if (word == "area") return ComponentSize::area;
  if (word == "volume") return ComponentSize::volume;
  throw UsageError("by: '" + word + "' is unknown: write faces, area or volume");
}

std::vector<bool> faces_of_largest(const Mesh& mesh, std::size_t count, ComponentSize by) {
  const Components all = connected_components(mesh);
  const std::vector<std::size_t> order = by_size(mesh, all, by);
  std::vector<bool> chosen(order.size(), false);
  for (std::size_t i = 0; i < std::min(count, order.size()); ++i) chosen[order[i]] = true;
  return faces_of(all, chosen);
}

std::vector<bool> faces_of_at_least(const Mesh& mesh, double size, ComponentSize by) {
  const Components all = connected_components(mesh);
  std::vector<bool> chosen;
  for (const double found : sizes_of(mesh, all, by)) chosen.push_back(found >= size);
  return faces_of(all, chosen);
}

std::vector<Mesh> split_components(const Mesh& mesh, ComponentSize by) {
  const Components all = connected_components(mesh);
  const std::vector<std::vector<Index>> vertices = vertices_of(mesh, all);
  std::vector<std::vector<Index>> faces(all.components.size());
  for (Index f = 0; f < mesh.faces.size(); ++f) faces[all.of_face[f]].push_back(f);

  std::vector<Index> new_vertex(mesh.positions.size(), no_index);
  std::vector<Mesh> parts;
  for (const std::size_t c : by_size(mesh, all, by))
    parts.push_back(part_of(mesh, faces[c], vertices[c], new_vertex));
  return parts;
}

std::vector<bool> faces_where(const Mesh& mesh, const std::string& condition) {
  const Condition wanted = parsed(condition);
  const Column* of_faces = numbers_of(mesh.face_columns, wanted.column);
  const Column* of_vertices = numbers_of(mesh.vertex_columns, wanted.column);
  if (of_faces == nullptr && of_vertices == nullptr)
    throw InputError("the mesh has no property '" + wanted.column + "' of numbers");
  std::vector<bool> keep(mesh.faces.size());
  for (std::size_t f = 0; f < keep.size(); ++f) {
    const Face& face = mesh.faces[f];
    keep[f] = of_faces != nullptr ? wanted.holds(*of_faces, f)
                                  : std::all_of(face.begin(), face.end(), [&](Index v) {
                                      return wanted.holds(*of_vertices, v);
                                    });
  }
  return keep;
}

std::vector<bool> faces_in_box(const Mesh& mesh, const Box& box) {
  std::vector<bool> keep(mesh.faces.size());
  for (std::size_t f = 0; f < keep.size(); ++f)
    keep[f] = std::all_of(mesh.faces[f].begin(), mesh.faces[f].end(), [&](Index v) {
      const Vec3& p = mesh.positions[v];
      return (p.array() >= box.min().array()).all() && (p.array() <= box.max().array()).all();
    });
  return keep;
}

}  // namespace transformesh
