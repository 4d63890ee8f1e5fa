#include "clean/open/component_winding.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/numbers/predicates.h"
#include "geometry/solid_angle_winding.h"

namespace transformesh {
namespace {

/// How many places of a patch are sampled.
constexpr std::size_t samples_of_patch = 15;

/// The least number on itself of a body with holes. A flat sheet has 0 and half a sphere 1/4; a
/// sphere of which 30 % of the area is missing has .35.
constexpr double least_of_body = 0.3;

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
  std::vector<Index> number_of(welded.points.size(), no_index);
  for (std::size_t c = 0; c < faces_of.size(); ++c) {
    for (const Index f : faces_of[c]) {
      Face face = welded.faces[f];
      for (Index& p : face) p = add_position(welded.points[p], p, number_of, meshes_[c]);
      meshes_[c].faces.push_back(face);
    }
    for (const Index f : faces_of[c])
      for (const Index p : welded.faces[f]) number_of[p] = no_index;
  }
  pieces_of_.resize(faces_of.size());
  on_itself_.resize(faces_of.size());
  for (Index p = 0; p < arrangement.pieces.size(); ++p) {
    const Piece& piece = arrangement.pieces[p];
    if (!piece.is_open || piece.source_count == 0) continue;
    pieces_of_[welded.open_component[arrangement.sources_of(piece).front().face]].push_back(p);
  }
}

// The face of the component on which the piece lies, if there is one, adds half a turn or nothing.
double ComponentWinding::number_at(Index component, Index piece) const {
  const WeldedMesh& welded = *arrangement_.welded;
  const auto& [a, b, c] = arrangement_.pieces[piece].corners;
  const Vec3 at =
      arrangement_.position(a) / 3 + arrangement_.position(b) / 3 + arrangement_.position(c) / 3;
  double number = SolidAngleWinding(mesh_of(component))(at).number;
  for (const PieceSource& source : arrangement_.sources_of(arrangement_.pieces[piece])) {
    if (!welded.is_open(source.face) || welded.open_component[source.face] != component) continue;
    const Triangle t = welded.triangle(source.face);
    const Mesh own{{t[0], t[1], t[2]}, {{0, 1, 2}}, {}, {}};
    number -= SolidAngleWinding(own)(at).number;
  }
  return number;
}

double ComponentWinding::median(Index component, const std::vector<Index>& pieces) const {
  std::vector<Sample> samples;
  samples.reserve(pieces.size());
  for (const Index p : pieces) {
    const auto& [a, b, c] = arrangement_.pieces[p].corners;
    const Vec3 at = arrangement_.position(a);
    const Vec3 cross = (arrangement_.position(b) - at).cross(arrangement_.position(c) - at);
    samples.push_back({cross.stableNorm(), at, p});
  }
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return a.area != b.area ? a.area > b.area : compare_positions(a.at, b.at) < 0;
  });
  std::vector<double> numbers = sample(component, samples);
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

// At equal shares of the area.
std::vector<double> ComponentWinding::sample(Index component,
                                             const std::vector<Sample>& samples) const {
  double total = 0;
  for (const Sample& s : samples) total += s.area;
  std::vector<double> numbers;
  double sum = 0;
  for (const Sample& s : samples) {
    sum += s.area;
    double number = 0;
    for (bool is_known = false; numbers.size() < samples_of_patch; is_known = true) {
      const double share = (static_cast<double>(numbers.size()) + 0.5) / samples_of_patch;
      if (sum < share * total) break;
      if (!is_known) number = number_at(component, s.piece);
      numbers.push_back(number);
    }
  }
  if (numbers.empty()) numbers.push_back(number_at(component, samples.front().piece));
  return numbers;
}

double ComponentWinding::on_itself(Index component) {
  std::optional<double>& number = on_itself_[component];
  if (!number) number = median(component, pieces_of_[component]);
  return *number;
}

bool ComponentWinding::is_body(Index component) { return on_itself(component) >= least_of_body; }

}  // namespace transformesh
