#include "shapes/kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "shapes/assembly.h"
#include "shapes/boxes.h"
#include "shapes/convex_hull.h"
#include "shapes/figure.h"
#include "shapes/pinch.h"
#include "shapes/revolved.h"
#include "shapes/solids.h"
#include "shapes/spheres.h"
#include "shapes/tubes.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/length.h"

namespace transformesh::shapes {
namespace {

[[noreturn]] void refuse(const ShapeOptions& options, const std::string& reason) {
  throw UsageError(options.kind + ": " + reason);
}

std::string quoted(const std::string& text) { return "'" + text + "'"; }

long integer_parameter(const ShapeOptions& options, std::size_t i, long highest) {
  const std::string& text = options.parameters[i];
  const auto value = number_in<long>(text);
  if (!value || *value < 1 || *value > highest)
    refuse(options, quoted(text) + " is not an integer from 1 to " + std::to_string(highest));
  return *value;
}

double share_parameter(const ShapeOptions& options, std::size_t i) {
  const std::string& text = options.parameters[i];
  const auto value = number_in<double>(text);
  if (!value || !(*value >= 0 && *value <= 1))
    refuse(options, quoted(text) + " is not a number from 0 to 1");
  return *value;
}

Vec3 three_lengths(const ShapeOptions& options) {
  Vec3 lengths;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string& text = options.parameters[axis];
    const Length length = parse_length(text);
    if (length.unit != Length::Unit::absolute || !is_sensible_length(length.value))
      refuse(options, quoted(text) + " is not a length from 1e-50 to 1e50 in units of the mesh");
    lengths[axis] = length.value;
  }
  return lengths;
}

Mesh make_sphere_kind(const ShapeOptions& options, std::size_t faces, const Progress&) {
  if (!options.around) return make_sphere(Vec3::Zero(), options.radius.value_or(1), faces);
  // The sphere surrounds the box. Its triangles are closer to the center than the sphere itself,
  // and must not touch the box either.
  const Box& box = *options.around;
  const double inner = geodesic_inner_radius(geodesic_frequency(static_cast<double>(faces)));
  const double radius = 1.05 * diagonal_of(box) / 2 / inner;
  if (!(radius > 0)) throw InputError("the mesh to surround has no extent");
  if (!is_sensible_length(radius)) {
    throw InputError("the mesh to surround is " + shortest_text(diagonal_of(box)) +
                     " across: scale it to a size from 1e-50 to 1e50");
  }
  return make_sphere(box.min() + (box.max() - box.min()) / 2, radius, faces);
}

Mesh make_dented(const ShapeOptions& options, std::size_t faces, const Progress&) {
  return dented_sphere(options.radius.value_or(1), faces);
}

Mesh make_ellipsoid(const ShapeOptions& options, std::size_t faces, const Progress& progress) {
  const Vec3 axes = three_lengths(options);
  if (axes.maxCoeff() > 10 * axes.minCoeff())
    refuse(options, "the longest axis must be at most ten times the shortest");
  return ellipsoid(axes, faces, progress);
}

Mesh make_box(const ShapeOptions& options, std::size_t faces, const Progress&) {
  return box(three_lengths(options), faces);
}

std::array<double, 2> radius_and_height(const ShapeOptions& options) {
  ShapeOptions three = options;
  three.parameters.emplace_back("1");
  const Vec3 lengths = three_lengths(three);
  return {lengths[0], lengths[1]};
}

Mesh make_cylinder(const ShapeOptions& options, std::size_t faces, const Progress&) {
  const auto [radius, height] = radius_and_height(options);
  return cylinder(radius, height, faces);
}

Mesh make_cone(const ShapeOptions& options, std::size_t faces, const Progress&) {
  const auto [radius, height] = radius_and_height(options);
  return cone(radius, height, faces);
}

Mesh make_hull(const ShapeOptions& options, std::size_t, const Progress&) {
  if (options.points.empty()) refuse(options, "there are no points to surround");
  return convex_hull(options.points);
}

Mesh make_torus(const ShapeOptions& options, std::size_t faces, const Progress&) {
  const double ring = options.radius.value_or(0.85);
  const double tube = options.tube.value_or(0.41 * ring);
  if (tube >= ring) refuse(options, "the tube must be thinner than the ring's radius");
  return torus(ring, tube, faces);
}

Mesh make_genus(const ShapeOptions& options, std::size_t faces, const Progress& progress) {
  return genus(integer_parameter(options, 0, 50), faces, progress);
}

/// Makes a tube along a knot. `share` is the tube radius as a fraction of the largest radius at
/// which the tube does not touch itself.
Mesh make_knot(const ShapeOptions& options, std::size_t faces, double share) {
  const long p = integer_parameter(options, 0, 30);
  const long q = integer_parameter(options, 1, 30);
  if (std::gcd(p, q) != 1) {
    refuse(options, std::to_string(p) + " and " + std::to_string(q) +
                        " have a common factor, so the curve is several rings, not a knot");
  }
  const double ring = options.radius.value_or(0.75);
  const double tube = options.tube ? *options.tube : share * torus_knot_thickness(p, q, ring);
  return torus_knot(p, q, ring, tube, faces);
}

Mesh make_torus_knot(const ShapeOptions& options, std::size_t faces, const Progress&) {
  return make_knot(options, faces, 0.7);
}

Mesh make_tangle(const ShapeOptions& options, std::size_t faces, const Progress&) {
  return make_knot(options, faces, 1.3);
}

Mesh make_two_spheres(const ShapeOptions& options, std::size_t faces, const Progress&) {
  const double radius = options.radius.value_or(0.7);
  const double gap = options.gap.value_or(-0.55 * radius);
  if (gap <= -2 * radius)
    refuse(options, "the gap must be above -2 radii, or both spheres coincide");
  return two_spheres(radius, gap, faces);
}

Mesh make_tori(const ShapeOptions& options, std::size_t faces, const Progress&) {
  const double gap = options.gap.value_or(0.08);
  if (gap >= 0.79 || gap <= -0.79) refuse(options, "the gap must be between -0.79 and 0.79");
  Mesh mesh = tori(gap, faces);
  if (gap > 0 && !find_intersections(mesh).empty())
    refuse(options, "with so few faces both tori intersect; use more faces");
  return mesh;
}

Mesh make_dumbbell(const ShapeOptions& options, std::size_t faces, const Progress& progress) {
  const double neck = options.neck.value_or(0.15);
  if (!(std::abs(neck) >= 0.01 && std::abs(neck) <= 0.45))
    refuse(options, "the neck must be from 0.01 to 0.45, or from -0.01 to -0.45");
  return dumbbell(neck, faces, progress);
}

Mesh make_bowl(const ShapeOptions&, std::size_t faces, const Progress& progress) {
  return bowl(faces, progress);
}

Mesh make_figure(const ShapeOptions& options, std::size_t faces, const Progress& progress) {
  return figure(share_parameter(options, 0), faces, progress);
}

Mesh make_folded(const ShapeOptions& options, std::size_t faces, const Progress&) {
  const std::string& base = options.parameters[0];
  const double radius = options.radius.value_or(1);
  if (base == "sphere") {
    Mesh mesh = make_sphere(Vec3::Zero(), radius, faces);
    transform(mesh, generic_rotation(0), Vec3::Zero());
    return mesh;
  }
  if (base != "torus") refuse(options, quoted(base) + " is neither sphere nor torus");
  return torus(0.7 * radius, 0.3 * radius, faces, 0.137);
}

Mesh make_many_spheres(const ShapeOptions& options, std::size_t faces, const Progress&) {
  // Use fewer spheres if each would have less than 80 faces.
  const std::size_t count = std::clamp<std::size_t>(faces / 80, 1, 40);
  return many_spheres(options.count.value_or(count), options.seed, faces);
}

Mesh make_boxes(const ShapeOptions& options, std::size_t faces, const Progress&) {
  const std::size_t by_faces = std::max<std::size_t>(1, (faces + 6) / 12);
  return boxes(options.count.value_or(options.faces ? by_faces : 50), options.seed);
}

Mesh make_pinch(const ShapeOptions&, std::size_t faces, const Progress&) { return pinch(faces); }

}  // namespace

bool is_sensible_length(double length) { return length >= 1e-50 && length <= 1e50; }

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"sphere", {"radius"}, {}, 0, make_sphere_kind},
      {"dented", {"radius"}, {}, 0, make_dented},
      {"ellipsoid", {}, {"1.2", "0.9", "0.6"}, 0, make_ellipsoid},
      {"box", {}, {"1.6", "1.2", "0.8"}, 0, make_box},
      {"cylinder", {}, {"0.8", "1.6"}, 0, make_cylinder},
      {"cone", {}, {"0.9", "1.6"}, 0, make_cone},
      {"hull", {}, {}, 0, make_hull},
      {"torus", {"radius", "tube"}, {}, 0, make_torus},
      {"genus", {}, {"3"}, 0, make_genus},
      {"torus-knot", {"radius", "tube"}, {"2", "3"}, 0, make_torus_knot},
      {"two-spheres", {"radius", "gap"}, {}, 0, make_two_spheres},
      {"tori", {"gap"}, {}, 0, make_tori},
      {"dumbbell", {"neck"}, {}, 0, make_dumbbell},
      {"bowl", {}, {}, 0, make_bowl},
      {"figure", {}, {"0"}, 0, make_figure},
      {"folded", {"radius"}, {"sphere"}, 0.38, make_folded},
      {"tangle", {"radius", "tube"}, {"2", "3"}, 0, make_tangle},
      {"many-spheres", {"count"}, {}, 0, make_many_spheres},
      {"boxes", {"count"}, {}, 0, make_boxes},
      {"pinch", {}, {}, 0, make_pinch},
  };
  return all;
}

}  // namespace transformesh::shapes
