/// Generated meshes: sources, targets and workloads for evolutions, tests and measurements. All
/// shapes are closed and consistently oriented, with positive volume, without isolated vertices or
/// columns. Lengths are in input units. Most shapes are about 2.4 wide.
///
/// Free of self-intersections: sphere, dented, ellipsoid, box, cylinder, cone, hull, torus, genus,
/// torus-knot, bowl, figure; dumbbell for neck > 0, two-spheres and tori for gap > 0.
/// Self-intersecting in general position: two-spheres, folded, tangle, many-spheres, tori and
/// dumbbell (gap, neck < 0). Self-intersecting in degenerate ways: boxes, pinch. Deterministic: the
/// same options give the same bytes for any number of threads.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/measure.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct ShapeOptions {
  std::string kind;  ///< one of shape_kinds()
  /// genus: N; torus-knot, tangle: P Q; ellipsoid, box: A B C; cylinder, cone: RADIUS HEIGHT;
  /// figure: T; folded: sphere or torus.
  std::vector<std::string> parameters;
  std::optional<std::size_t> faces;  ///< approximate number of faces; default 10000
  std::optional<double> edge;        ///< approximate mean edge, instead of `faces`; > 0
  /// Radius of a sphere or dented sphere, or of the ring of a torus or knot; > 0.
  std::optional<double> radius;
  std::optional<double> tube;        ///< tube radius of a torus or knot; > 0
  std::optional<double> gap;         ///< gap of two-spheres and tori; negative: parts overlap
  std::optional<double> neck;        ///< radius of a dumbbell's neck; negative: neck inside out
  std::optional<std::size_t> count;  ///< number of many-spheres or boxes
  std::optional<double> noise;  ///< amplitude of noise; >= 0; default 0, folded: 38 % of diagonal
  std::uint64_t seed = 1;       ///< seed of the noise and of random shapes
  std::optional<Box> around;    ///< the sphere contains this box with a margin of at least 5 %
  std::vector<Vec3> points;     ///< points of which shape `hull` is the convex hull
  Vec3 center = Vec3::Zero();   ///< position of the shape's origin
};

/// Returns the names of all kinds, in the order of the manual.
const std::vector<std::string>& shape_kinds();

/// Generates a mesh. The number of faces is within a few percent of `faces` if the kind allows (an
/// icosahedron has 20, box and boxes have 12 each). Throws UsageError for options that are invalid
/// or that the kind does not have, for fewer faces than a genus needs, and for more than 10^9. Also
/// throws it if the spacing of coordinates is too coarse, for shapes far from the origin or thin
/// tubes. O(faces).
Mesh make_shape(const ShapeOptions& options, const Progress& progress = {});

/// Returns the diagonal of the shape's bounding box, estimated from a coarse mesh.
double shape_diagonal(ShapeOptions options);

/// Returns an icosahedron whose faces are divided into n^2 each (geodesic, class I), with n such
/// that 20 n^2 is about `faces`.
Mesh make_sphere(const Vec3& center, double radius, std::size_t faces);

}  // namespace transformesh
