#include "reconstruction/surface_doubt.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "mesh/local_measures.h"
#include "reconstruction/filled_hollows.h"
#include "reconstruction/hidden_vertices.h"
#include "reconstruction/place_loops.h"
#include "step/local_thickness.h"
#include "support/number.h"
#include "transformesh/measure.h"
#include "views/photo/photo_scene.h"
#include "views/photo/thin_plate.h"

namespace transformesh {
namespace {

// Least area of a doubtful place, and thickness below which it is thin, in pixels (see the header).
constexpr double least_area_px = 25;
constexpr double thin_px = 6;

DoubtfulPlace measured_place(const Mesh& mesh, const std::vector<Index>& vertices,
                             const std::vector<double>& areas, double pixel) {
  DoubtfulPlace place;
  double area = 0;
  for (const Index v : vertices) {
    place.center += areas[v] * mesh.positions[v];
    area += areas[v];
  }
  if (area > 0) place.center /= area;
  place.area = area / (pixel * pixel);
  return place;
}

bool is_thin(const std::vector<Index>& vertices, const std::vector<double>& thickness,
             double most) {
  const auto thin =
      std::count_if(vertices.begin(), vertices.end(), [&](Index v) { return thickness[v] < most; });
  return 2 * static_cast<std::size_t>(thin) > vertices.size();
}

/// Returns the thickness between unobserved sheets, up to twice `thin_px`; empty if there are none.
std::vector<double> thickness_of_unobserved(const Mesh& mesh, const std::vector<bool>& is_observed,
                                            double pixel, const Progress& progress) {
  Target unobserved;
  unobserved.mesh.positions = mesh.positions;
  for (const Face& face : mesh.faces)
    if (std::none_of(face.begin(), face.end(), [&](Index v) { return is_observed[v]; }))
      unobserved.mesh.faces.push_back(face);
  if (unobserved.mesh.faces.empty()) return {};
  return local_thickness(unobserved, 2 * thin_px * pixel, progress, BallSides::inside);
}

void sort_by_area(std::vector<DoubtfulPlace>& places) {
  std::ranges::stable_sort(places, std::greater(), &DoubtfulPlace::area);
}

void find_places(const Mesh& mesh, const UniformLaplacian& laplacian, std::vector<bool> is_doubtful,
                 double pixel, SurfaceDoubt& doubt, const Progress& progress) {
  const std::vector<double> areas = vertex_areas(mesh);
  std::vector<double> thickness;
  std::optional<PlaceLoops> loops;
  for (Index v = 0; v < is_doubtful.size(); ++v) {
    if (!is_doubtful[v]) continue;
    const std::vector<Index> vertices = take_connected(v, laplacian, is_doubtful);
    DoubtfulPlace place = measured_place(mesh, vertices, areas, pixel);
    if (place.area < least_area_px) continue;
    if (!loops) loops.emplace(mesh);
    place.has_handle = loops->has_handle(vertices);
    if (thickness.empty())
      thickness = local_thickness(make_target(mesh), 2 * thin_px * pixel, progress);
    place.is_thin = is_thin(vertices, thickness, thin_px * pixel);
    doubt.places.push_back(place);
  }
  sort_by_area(doubt.places);
}

std::vector<DoubtfulPlace> places_of(std::vector<bool> is_marked, const Mesh& mesh,
                                     const UniformLaplacian& laplacian, double pixel) {
  const std::vector<double> areas = vertex_areas(mesh);
  std::vector<DoubtfulPlace> places;
  for (Index v = 0; v < is_marked.size(); ++v) {
    if (!is_marked[v]) continue;
    const auto place = measured_place(mesh, take_connected(v, laplacian, is_marked), areas, pixel);
    if (place.area >= least_area_px) places.push_back(place);
  }
  sort_by_area(places);
  return places;
}

/// Returns the area of the places, as a fraction of the area `whole` in input units.
double share_of(const std::vector<DoubtfulPlace>& places, double pixel, double whole) {
  double share = 0;
  for (const DoubtfulPlace& place : places) share += place.area * pixel * pixel / whole;
  return share;
}

/// Sets the places that only windows of 3x3 pixels show.
void find_small_window_places(const Mesh& mesh, const UniformLaplacian& laplacian,
                              const PhotoScene& scene, double least_cosine,
                              PhotoconsistencyOptions options, SurfaceDoubt& doubt,
                              const Progress& progress) {
  options.correlation.radius = 1;
  const auto measure = [&](const Mesh& surface) {
    return disagreement(surface, scene, least_cosine, options, progress).of_vertex;
  };
  const std::vector<WindowSums> sums = measure(mesh);
  std::vector<bool> is_doubtful;
  for (const WindowSums& around : spread(sums, laplacian, doubt_rings))
    is_doubtful.push_back(around.excess() > contradicted);
  doubt.small_window_places = places_of(is_doubtful, mesh, laplacian, scene.pixel);
  const std::vector<double> areas = vertex_areas(mesh);
  for (const auto& hollow : filled_hollows(mesh, sums, scene.pixel, measure))
    doubt.filled_hollows.push_back(measured_place(mesh, hollow, areas, scene.pixel));
  sort_by_area(doubt.filled_hollows);
}

}  // namespace

std::vector<WindowSums> spread(std::vector<WindowSums> sums, const UniformLaplacian& laplacian,
                               int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<WindowSums> before = sums;
    for (Index v = 0; v < sums.size(); ++v)
      for (const Index neighbor : laplacian.neighbors(v)) sums[v] += before[neighbor];
  }
  return sums;
}

std::vector<Index> take_connected(Index first, const UniformLaplacian& laplacian,
                                  std::vector<bool>& is_marked) {
  std::vector<Index> part{first};
  is_marked[first] = false;
  for (std::size_t next = 0; next < part.size(); ++next) {
    for (const Index neighbor : laplacian.neighbors(part[next])) {
      if (is_marked[neighbor]) part.push_back(neighbor);
      is_marked[neighbor] = false;
    }
  }
  return part;
}

std::vector<std::vector<Index>> unobserved_fins(const Mesh& mesh,
                                                const std::vector<WindowSums>& sums, double pixel,
                                                const Progress& progress) {
  const UniformLaplacian laplacian(mesh);
  std::vector<bool> is_observed;
  for (const WindowSums& around : spread(sums, laplacian, doubt_rings))
    is_observed.push_back(around.weight > 0);
  const std::vector<double> thickness = thickness_of_unobserved(mesh, is_observed, pixel, progress);
  std::vector<bool> is_narrow;
  for (const double width : thickness) is_narrow.push_back(std::isfinite(width));
  const std::vector<double> areas = vertex_areas(mesh);
  std::vector<std::vector<Index>> fins;
  for (Index v = 0; v < is_narrow.size(); ++v) {
    if (!is_narrow[v]) continue;
    std::vector<Index> part = take_connected(v, laplacian, is_narrow);
    double thin_area = 0;
    for (const Index u : part) thin_area += thickness[u] < thin_px * pixel ? areas[u] : 0;
    if (thin_area >= least_area_px * pixel * pixel) fins.push_back(std::move(part));
  }
  return fins;
}

SurfaceDoubt surface_doubt(const Mesh& mesh, const PhotoScene& scene, double least_cosine,
                           const PhotoconsistencyOptions& options, const Progress& progress) {
  const Disagreement found = disagreement(mesh, scene, least_cosine, options, progress);
  SurfaceDoubt doubt;
  doubt.disagreement = found.all.excess();
  doubt.floor = found.all.mean_floor();

  const UniformLaplacian laplacian(mesh);
  const std::vector<WindowSums> around = spread(found.of_vertex, laplacian, doubt_rings);
  std::vector<bool> is_doubtful(around.size());
  std::vector<bool> is_observed(around.size());
  for (std::size_t v = 0; v < around.size(); ++v) {
    is_observed[v] = around[v].weight > 0;
    doubt.of_vertex.push_back(is_observed[v] ? read_back(significant(around[v].excess(), 6)) : 1);
    is_doubtful[v] = is_observed[v] && around[v].excess() > contradicted;
  }
  find_places(mesh, laplacian, is_doubtful, scene.pixel, doubt, progress);

  double observed = 0;
  const std::vector<double> areas = vertex_areas(mesh);
  for (std::size_t v = 0; v < areas.size(); ++v) observed += is_observed[v] ? areas[v] : 0;
  doubt.share = share_of(doubt.places, scene.pixel, observed);
  find_small_window_places(mesh, laplacian, scene, least_cosine, options, doubt, progress);
  doubt.small_window_share = share_of(doubt.small_window_places, scene.pixel, observed);
  doubt.hidden_places = places_of(hidden_vertices(mesh, is_observed, scene, least_cosine), mesh,
                                  laplacian, scene.pixel);
  doubt.hidden_share = share_of(doubt.hidden_places, scene.pixel, surface_area(mesh));
  for (const auto& fin : unobserved_fins(mesh, found.of_vertex, scene.pixel, progress))
    doubt.unobserved_fins.push_back(measured_place(mesh, fin, areas, scene.pixel));
  doubt.sums = found.of_vertex;
  return doubt;
}

void set_doubt_column(Mesh& mesh, const SurfaceDoubt& doubt) {
  Column& column = mesh.vertex_columns.get(doubt_column, Scalar::float32, mesh.positions.size());
  for (std::size_t v = 0; v < column.values.size(); ++v)
    column.values[v] = static_cast<float>(doubt.of_vertex[v]);
}

std::string in_words(const DoubtfulPlace& place) {
  const auto number = [&](int axis) { return significant(place.center[axis], 4); };
  return number(0) + ',' + number(1) + ',' + number(2) + " (" + fixed(place.area, 0) +
         " square pixels" + (place.is_thin ? ", thin" : "") +
         (place.has_handle ? ", with a handle)" : ")");
}

}  // namespace transformesh
