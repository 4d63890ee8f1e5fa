#include "clean/stitch/orientation_check.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "clean/exterior/angular_order.h"
#include "mesh/edges.h"
#include "mesh/location_text.h"

namespace transformesh {
namespace {

/// Largest number of faces that an error message lists, so that it stays short.
constexpr std::size_t most_named = 5;

std::string list_text(const std::vector<Index>& faces) {
  std::string text = "faces " + std::to_string(faces[0]);
  const std::size_t named = std::min(faces.size(), most_named);
  for (std::size_t i = 1; i < named; ++i) {
    const bool is_last = i + 1 == faces.size();
    text += (is_last ? " and " : ", ") + std::to_string(faces[i]);
  }
  if (named < faces.size()) text += " and " + std::to_string(faces.size() - named) + " more";
  return text;
}

// Returns the problem of a misoriented edge. Its message lists the faces that traverse the edge in
// the direction `forward`, in which most faces traverse it.
Problem edge_problem(const Mesh& mesh, std::span<const Index> halfedges, bool forward) {
  const auto points_alike = [&](Index h) { return is_forward(mesh.faces, h) == forward; };
  std::vector<Index> alike;
  for (const Index h : halfedges) {
    if (points_alike(h)) alike.push_back(h / 3);
  }
  const auto first = std::find_if(halfedges.begin(), halfedges.end(), points_alike);
  const std::size_t against = halfedges.size() - alike.size();
  Problem problem{
      ErrorKind::not_oriented,
      list_text(alike) + " traverse the " + edge_text(mesh, *first) + " in the same direction" +
          (against == 0 ? ""
                        : ", and only " + std::to_string(against) + " in the opposite direction"),
      edge_data(mesh, *first)};
  problem.data.faces.assign(alike.begin(), alike.end());
  return problem;
}

}  // namespace

int sum_along(std::span<const Face> faces, std::span<const Index> halfedges) {
  int sum = 0;
  for (const Index h : halfedges) sum += is_forward(faces, h) ? 1 : -1;
  return sum;
}

Problem find_misorientation(const Mesh& mesh) {
  const Edges edges(without_collapsed(mesh.faces), mesh.positions.size());
  Problem problem;
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int sum = sum_along(mesh.faces, edges.halfedges(e));
    if (std::abs(sum) <= 1) continue;
    if (count == 0) problem = edge_problem(mesh, edges.halfedges(e), sum > 0);
    ++count;
  }
  if (count > 0) problem.data.counts = {count};
  if (count > 1) problem.sentence += " (the first of " + std::to_string(count) + " such edges)";
  return problem;
}

std::string describe_misorientation(const Mesh& mesh) { return find_misorientation(mesh).sentence; }

}  // namespace transformesh
