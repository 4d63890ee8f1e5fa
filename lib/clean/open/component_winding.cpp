#include "clean/open/component_winding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/numbers/predicates.h"
#include "support/parallel.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Limits of the number of sampled pieces per patch. A patch with more pieces than the limit is
/// sampled at equal shares of its area. The limit is in [least_samples, most_samples], and its
/// product with the number of faces of the component is `samples_times_faces`. With a limit of 15
/// samples for all components, the results of 6 of 10,000 random meshes changed after a rotation,
/// because the order of pieces of equal area changed.
constexpr std::size_t samples_times_faces = 2'000'000;
constexpr std::size_t most_samples = 200;
constexpr std::size_t least_samples = 15;

constexpr std::size_t samples_per_task = 4;  ///< affects time only

/// Sums of areas whose relative difference is smaller than this count as equal.
constexpr double sum_rounding = 1e-9;

/// An open component is a body with holes if its number on itself is at least this. The number is 0
/// for a flat sheet, 1/4 for a hemisphere, and 0.35 for a sphere without 30 % of its area.
constexpr double least_of_body = 0.3;

/// The fraction of a component is its typical winding number modulo 1. It is 1/4 for a hemisphere
/// with outward orientation, and 3/4 with inward orientation. Flatter components have fractions
/// closer to 0 or 1, which tell the orientation. Nearly closed components have fractions near 1/2
/// in either orientation, so that the sign of their volume decides.
constexpr double most_of_sheet = 0.25;

/// Largest mean deviation of the winding numbers of a component from multiples of 1 plus a common
/// fraction, so that they determine this fraction. Folded bodies that a plane has cut had 0.05 to
/// 0.07. Of 245 crumpled sheets, those with a fraction between 0.3 and 0.7 had at least 0.149.
constexpr double most_deviation = 0.1;

Index add_position(const Vec3& position, Index point, std::vector<Index>& number_of, Mesh& mesh) {
  if (number_of[point] == no_index) {
    number_of[point] = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(position);
  }
  return number_of[point];
}

}  // namespace

ComponentWinding::ComponentWinding(const Arrangement& arrangement) : arrangement_(arrangement) {
  const WeldedMesh& welded = *arrangement.welded;
  std::vector<std::vector<Index>> faces_of;
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (!welded.is_open(f)) continue;
    faces_of.resize(std::max<std::size_t>(faces_of.size(), welded.open_component[f] + 1));
    faces_of[welded.open_component[f]].push_back(f);
  }
  meshes_.resize(faces_of.size());
  windings_.resize(faces_of.size());
  number_of_face_.resize(welded.faces.size(), no_index);
  std::vector<Index> number_of(welded.points.size(), no_index);
  for (std::size_t c = 0; c < faces_of.size(); ++c) {
    for (const Index f : faces_of[c]) {
      Face face = welded.faces[f];
      for (Index& p : face) p = add_position(welded.points[p], p, number_of, meshes_[c]);
      number_of_face_[f] = static_cast<Index>(meshes_[c].faces.size());
      meshes_[c].faces.push_back(face);
    }
    for (const Index f : faces_of[c])
      for (const Index p : welded.faces[f]) number_of[p] = no_index;
  }
  pieces_of_.resize(faces_of.size());
  on_itself_.resize(faces_of.size());
  areas_.resize(faces_of.size());
  for (Index p = 0; p < arrangement.pieces.size(); ++p) {
    const Piece& piece = arrangement.pieces[p];
    if (!piece.is_open || piece.source_count == 0) continue;
    pieces_of_[welded.open_component[arrangement.sources_of(piece).front().face]].push_back(p);
  }
}

Index ComponentWinding::component_of_face(Index face) const {
  return arrangement_.welded->is_open(face) ? arrangement_.welded->open_component[face]
                                            : closed_part;
}

Index ComponentWinding::component_of(Index piece) const {
  const Piece& p = arrangement_.pieces[piece];
  if (!p.is_open) return closed_part;
  const auto sources = arrangement_.sources_of(p);
  const auto first = std::ranges::find_if(sources, [](const auto& s) { return !s.reversed; });
  return component_of_face((first == sources.end() ? sources.front() : *first).face);
}

std::set<Index> ComponentWinding::components_of(Index piece) const {
  std::set<Index> result;
  for (const PieceSource& source : arrangement_.sources_of(arrangement_.pieces[piece]))
    if (!source.reversed) result.insert(component_of_face(source.face));
  return result;
}

std::optional<bool> ComponentWinding::is_reverse_of(const std::vector<Index>& pieces,
                                                    Index component) const {
  for (const Index p : pieces)
    for (const PieceSource& source : arrangement_.sources_of(arrangement_.pieces[p]))
      if (component_of_face(source.face) == component) return source.reversed;
  return std::nullopt;
}

// Adds areas in ascending order, so that the sum does not depend on the order of the pieces.
double ComponentWinding::area_of(const std::vector<Index>& pieces) const {
  std::vector<double> areas;
  areas.reserve(pieces.size());
  for (const Index p : pieces) {
    const auto& [a, b, c] = arrangement_.pieces[p].corners;
    const Vec3 at = arrangement_.position(a);
    areas.push_back(
        (arrangement_.position(b) - at).cross(arrangement_.position(c) - at).stableNorm());
  }
  std::sort(areas.begin(), areas.end());
  return std::accumulate(areas.begin(), areas.end(), 0.0) / 2;
}

double ComponentWinding::area_of(Index component) {
  if (!areas_[component]) areas_[component] = area_of(pieces_of_[component]);
  return *areas_[component];
}

Vec3 ComponentWinding::centroid(Index piece) const {
  const auto& [a, b, c] = arrangement_.pieces[piece].corners;
  return arrangement_.position(a) / 3 + arrangement_.position(b) / 3 + arrangement_.position(c) / 3;
}

const WindingHierarchy& ComponentWinding::hierarchy_of(Index component) {
  if (!windings_[component]) windings_[component].emplace(mesh_of(component));
  return *windings_[component];
}

double ComponentWinding::number_at(Index component, Index piece) {
  return number_at(hierarchy_of(component), component, piece);
}

// If a face of the component contains the piece, this face is left out, because its contribution is
// 1/2, -1/2 or 0, depending on rounding. Hence the result is the mean of the values on both sides.
double ComponentWinding::number_at(const WindingHierarchy& hierarchy, Index component,
                                   Index piece) const {
  const WeldedMesh& welded = *arrangement_.welded;
  std::vector<Index> own_faces;
  for (const PieceSource& source : arrangement_.sources_of(arrangement_.pieces[piece]))
    if (welded.is_open(source.face) && welded.open_component[source.face] == component)
      own_faces.push_back(number_of_face_[source.face]);
  return hierarchy(centroid(piece), own_faces);
}

double ComponentWinding::median(Index component, const std::vector<Index>& pieces) {
  return median_of(sampled_numbers(component, pieces));
}

std::vector<ComponentWinding::Number> ComponentWinding::sampled_numbers(
    Index component, const std::vector<Index>& pieces) {
  std::vector<Sample> samples;
  samples.reserve(pieces.size());
  for (const Index p : pieces) {
    const auto& [a, b, c] = arrangement_.pieces[p].corners;
    const Vec3 at = arrangement_.position(a);
    const Vec3 to_b = arrangement_.position(b) - at, to_c = arrangement_.position(c) - at;
    samples.push_back({to_b.cross(to_c).stableNorm(), at + to_b / 3 + to_c / 3, p});
  }
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return a.area != b.area ? a.area > b.area : compare_positions(a.at, b.at) < 0;
  });
  return numbers_at(component, choose(samples, samples_of(component)));
}

std::size_t ComponentWinding::samples_of(Index component) const {
  return std::clamp(samples_times_faces / mesh_of(component).faces.size(), least_samples,
                    most_samples);
}

std::vector<ComponentWinding::Number> ComponentWinding::numbers_at(
    Index component, const std::vector<Sample>& samples) {
  const WindingHierarchy& hierarchy = hierarchy_of(component);
  std::vector<Number> numbers(samples.size());
  parallel_for(samples.size(), samples_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      numbers[i] = {number_at(hierarchy, component, samples[i].piece), samples[i].area};
  });
  std::sort(numbers.begin(), numbers.end(), [](const Number& a, const Number& b) {
    return a.number != b.number ? a.number < b.number : a.area < b.area;
  });
  return numbers;
}

// Returns all samples if there are at most `count`. Otherwise returns `count` samples with equal
// weights, at equal shares of the total area.
std::vector<ComponentWinding::Sample> ComponentWinding::choose(const std::vector<Sample>& samples,
                                                               std::size_t count) {
  if (samples.size() <= count) return samples;
  double total = 0, sum = 0;
  for (const Sample& s : samples) total += s.area;
  std::vector<Sample> chosen;
  for (const Sample& s : samples) {
    sum += s.area;
    while (chosen.size() < count &&
           sum >= (static_cast<double>(chosen.size()) + 0.5) / static_cast<double>(count) * total)
      chosen.push_back({1, s.at, s.piece});
  }
  return chosen.empty() ? std::vector<Sample>{samples.front()} : chosen;
}

// Returns the median of the winding numbers, weighted by area. If the numbers up to some number
// have exactly half of the area, returns the mean of this number and the next one.
double ComponentWinding::median_of(const std::vector<Number>& numbers) {
  double total = 0, sum = 0;
  for (const Number& n : numbers) total += n.area;
  std::optional<double> lower;
  for (const Number& n : numbers) {
    sum += n.area;
    if (2 * sum < (1 - sum_rounding) * total) continue;
    if (!lower) lower = n.number;
    if (2 * sum > (1 + sum_rounding) * total) return (*lower + n.number) / 2;
  }
  return lower.value_or(0);
}

// Returns the number in [0, 1) with the least mean deviation, weighted by area, of the given
// numbers from it or from numbers that differ from it by integers.
ComponentWinding::Fraction ComponentWinding::fraction_of(const std::vector<Number>& numbers) {
  double total = 0;
  for (const Number& n : numbers) total += n.area;
  Fraction result{0, std::numeric_limits<double>::infinity()};
  for (const Number& candidate : numbers) {
    double sum = 0;
    for (const Number& n : numbers) {
      const double difference = n.number - candidate.number;
      sum += n.area * std::abs(difference - std::round(difference));
    }
    if (sum >= (1 - sum_rounding) * total * result.deviation) continue;
    result = {candidate.number - std::floor(candidate.number), sum / total};
  }
  return result;
}

double ComponentWinding::on_itself(Index component) {
  std::optional<double>& result = on_itself_[component];
  if (result) return *result;
  const std::vector<Number> numbers = sampled_numbers(component, pieces_of_[component]);
  const auto [fraction, deviation] = fraction_of(numbers);
  // The deviation is not a number if areas overflow.
  if (!(deviation <= most_deviation)) return *(result = std::clamp(median_of(numbers), 0.0, 0.5));
  const bool is_inverted =
      fraction > 1 - most_of_sheet || (fraction >= most_of_sheet && volume(mesh_of(component)) < 0);
  return *(result = is_inverted ? fraction - 1 : fraction);
}

bool ComponentWinding::is_body(Index component) { return on_itself(component) >= least_of_body; }

}  // namespace transformesh
