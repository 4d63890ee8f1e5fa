#include "transformesh/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/coordinate_spacing.h"
#include "shapes/assembly.h"
#include "shapes/kinds.h"
#include "shapes/noise.h"
#include "shapes/spheres.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

using shapes::Kind;

constexpr std::size_t default_faces = 10000;  ///< chosen by hand
constexpr std::size_t coarse_faces = 2000;    ///< chosen by hand
constexpr double most_faces = 1e9;            ///< three indices per face stay below 2^32
// Least size of faces and thickness, in coordinate spacings. A choice: with a smaller value, shapes
// lose digits; with a larger value, usable shapes are rejected.
constexpr double least_spacings = 1000;
constexpr double noise_wavelength = 0.2;  // in diagonals of the bounding box

const Kind& find_kind(const std::string& name) {
  for (const Kind& kind : shapes::kinds())
    if (kind.name == name) return kind;
  throw UsageError("unknown kind of shape '" + name + "'");
}

bool has_option(const Kind& kind, const std::string& option) {
  return std::find(kind.options.begin(), kind.options.end(), option) != kind.options.end();
}

// Throws if the kind does not have this option, and lists the kinds that do.
void check_applies(const Kind& kind, const std::string& option) {
  if (has_option(kind, option)) return;
  std::string others;
  for (const Kind& other : shapes::kinds())
    if (has_option(other, option)) others += (others.empty() ? "" : ", ") + other.name;
  throw UsageError(kind.name + " has no " + option + "; these have: " + others);
}

void check_length(const std::optional<double>& value, const std::string& option) {
  if (value && !shapes::is_sensible_length(*value))
    throw UsageError(ErrorKind::other,
                     option + " must be positive, from 1e-50 to 1e50, not " + shortest_text(*value),
                     {.lengths = {*value}, .name = option});
}

// Checks a length that may be 0 or negative.
void check_distance(const std::optional<double>& value, const std::string& option) {
  if (value && *value != 0) check_length(std::abs(*value), option);
}

void check_options(const Kind& kind, const ShapeOptions& options) {
  if (options.radius) check_applies(kind, "radius");
  if (options.tube) check_applies(kind, "tube");
  if (options.gap) check_applies(kind, "gap");
  if (options.neck) check_applies(kind, "neck");
  if (options.count) check_applies(kind, "count");
  check_length(options.radius, "radius");
  check_length(options.tube, "tube");
  check_length(options.edge, "edge");
  check_distance(options.gap, "gap");
  if (options.noise && !(*options.noise >= 0)) throw UsageError("noise must not be negative");
  check_distance(options.noise, "noise");
  if (options.around && (kind.name != "sphere" || options.radius || !options.center.isZero(0)))
    throw UsageError("around makes a sphere and sets its radius and center itself");
  if (options.faces && options.edge)
    throw UsageError("faces and edge both set the size of the faces: give one of them");
  if (kind.name == "hull" ? options.faces || options.edge : !options.points.empty())
    throw UsageError("only the shape hull takes points, and it takes no faces and no edge");
  if (kind.name == "boxes" && options.edge)
    throw UsageError("boxes has no edge: its boxes have 12 faces each; give their count");
  if (kind.name == "boxes" && options.faces && options.count)
    throw UsageError("faces and count both set the number of boxes: give one of them");
}

// Fills in default parameters if the user gave none.
ShapeOptions with_parameters(const Kind& kind, ShapeOptions options) {
  if (options.parameters.empty()) options.parameters = kind.parameters;
  if (options.parameters.size() == kind.parameters.size()) return options;
  std::string example = kind.name;
  for (const std::string& parameter : kind.parameters) example += ' ' + parameter;
  throw UsageError(kind.parameters.empty()
                       ? kind.name + " takes no parameters, but '" + options.parameters[0] +
                             "' was given"
                       : kind.name + " takes " + counted(kind.parameters.size(), "parameter") +
                             ", for example: " + example);
}

std::size_t checked_faces(double faces, const std::string& asked) {
  if (!(faces <= most_faces))
    throw UsageError(asked + " asks for more than 10^9 faces, the most that can be made");
  return static_cast<std::size_t>(std::max(faces, 1.0));
}

// Estimates the number of faces from the mean edge of a coarse mesh of the same kind.
std::size_t faces_for_edge(const Kind& kind, const ShapeOptions& options) {
  const Mesh coarse = kind.make(options, coarse_faces, {});
  const double edge = *options.edge;
  const double mean_edge = edge_lengths(coarse).mean;
  const double faces =
      static_cast<double>(coarse.faces.size()) * (mean_edge / edge) * (mean_edge / edge);
  return checked_faces(faces, "edge " + shortest_text(edge));
}

std::size_t wanted_faces(const Kind& kind, const ShapeOptions& options) {
  if (options.edge) return faces_for_edge(kind, options);
  const std::size_t faces = options.faces.value_or(default_faces);
  return checked_faces(static_cast<double>(faces), "faces " + std::to_string(faces));
}

// Volume over area: half the thickness of a plate, a third of the radius of a ball.
double thickness(const Mesh& mesh) { return volume(mesh) / surface_area(mesh); }

// Throws unless faces and the solid between them are far larger than the spacing of coordinates.
void check_digits(const Mesh& mesh, double thickness) {
  const double least = least_spacings * coordinate_spacing(mesh);
  const double face = std::sqrt(surface_area(mesh) / static_cast<double>(mesh.faces.size()));
  if (face > least && thickness > least) return;
  throw UsageError(
      "coordinates " + shortest_text(coordinate_spacing(mesh)) +
      " apart cannot represent this shape: it is too far from the origin, or too thin");
}

}  // namespace

const std::vector<std::string>& shape_kinds() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const Kind& kind : shapes::kinds()) result.push_back(kind.name);
    return result;
  }();
  return names;
}

Mesh make_shape(const ShapeOptions& options, const Progress& progress) {
  const Kind& kind = find_kind(options.kind);
  check_options(kind, options);
  const ShapeOptions complete = with_parameters(kind, options);
  progress("shape");
  Mesh mesh = kind.make(complete, wanted_faces(kind, complete), progress);

  const bool can_be_thin = has_option(kind, "tube") || !options.center.isZero(0);
  const double thin = can_be_thin ? thickness(mesh) : std::numeric_limits<double>::infinity();

  const double diagonal = diagonal_of(bounding_box(mesh));
  const double noise = options.noise.value_or(kind.noise * diagonal);
  if (noise > 0)
    shapes::add_noise(mesh, noise, noise_wavelength * diagonal, options.seed, progress);
  if (!options.center.isZero(0))
    shapes::transform(mesh, Eigen::Matrix3d::Identity(), options.center);
  check_digits(mesh, thin);
  return mesh;
}

double shape_diagonal(ShapeOptions options) {
  options.edge.reset();
  options.noise = 0;
  if (options.kind != "boxes" && options.kind != "hull") options.faces = coarse_faces;
  return diagonal_of(bounding_box(make_shape(options)));
}

Mesh make_sphere(const Vec3& center, double radius, std::size_t faces) {
  Mesh mesh = shapes::geodesic_sphere(shapes::geodesic_frequency(static_cast<double>(faces)));
  shapes::transform(mesh, radius * Eigen::Matrix3d::Identity(), center);
  return mesh;
}

}  // namespace transformesh
