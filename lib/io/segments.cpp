#include "io/segments.h"

#include <algorithm>

#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

const Vec3& end_of(const Document& document, const Column& column, std::size_t row,
                   const std::string& name) {
  const double vertex = column.values[row];
  const std::vector<Vec3>& positions = document.mesh.positions;
  // The condition is negated so that it also rejects NaN.
  if (!(vertex >= 0 && vertex < static_cast<double>(positions.size())))
    throw InputError(name + ": edge " + std::to_string(row) + " has vertex " +
                     shortest_text(vertex) + ", but there are " + std::to_string(positions.size()));
  return positions[static_cast<std::size_t>(vertex)];
}

}  // namespace

std::vector<Segment> segments_of(const Document& document, const std::string& name) {
  const auto edges = std::ranges::find(document.other_elements, "edge", &OtherElement::name);
  const bool is_there = edges != document.other_elements.end();
  const Column* first = is_there ? edges->columns.find("vertex1") : nullptr;
  const Column* second = is_there ? edges->columns.find("vertex2") : nullptr;
  if (first == nullptr || second == nullptr || first->list_count_type || second->list_count_type)
    throw InputError(ErrorKind::no_segments,
                     name +
                         ": no segments: a PLY with the element edge is needed, which has vertex1 "
                         "and vertex2",
                     {.name = name});
  std::vector<Segment> segments;
  for (std::size_t row = 0; row < edges->rows; ++row)
    segments.emplace_back(end_of(document, *first, row, name),
                          end_of(document, *second, row, name));
  return segments;
}

std::string segment_file(const std::vector<Segment>& segments) {
  Document document;
  OtherElement edges{"edge", segments.size(), {}};
  Column& first = edges.columns.get("vertex1", Scalar::int32, segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) first.values[i] = static_cast<double>(2 * i);
  Column& second = edges.columns.get("vertex2", Scalar::int32, segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    second.values[i] = static_cast<double>(2 * i + 1);
    document.mesh.positions.push_back(segments[i].first);
    document.mesh.positions.push_back(segments[i].second);
  }
  document.other_elements.push_back(std::move(edges));
  return write_mesh(document).bytes;
}

}  // namespace transformesh
