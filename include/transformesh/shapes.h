/// Generated meshes: sources, targets and workloads for evolutions, tests and measurements. Every
/// one is closed, consistently oriented, without isolated vertices or columns, and its signed
/// volume is positive. Lengths are in the units of the mesh. Most shapes are about 2.4 wide.
///
/// sphere dented ellipsoid box cylinder cone hull torus genus torus-knot bowl figure are free of
/// self-intersections; dumbbell for neck > 0, two-spheres and tori for gap > 0 also. Others are
/// not: two-spheres folded tangle many-spheres, tori and dumbbell (gap, neck < 0) in general
/// position, boxes and pinch as degenerately as they can. Deterministic: the same options give the
/// same bytes for any number of threads.
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
  std::optional<std::size_t> faces;  ///< how many, about; default 10000
  std::optional<double> edge;        ///< or the mean edge length, about; > 0
  std::optional<double> radius;  ///< of a sphere (dented too), of the ring of a torus or knot; > 0
  std::optional<double> tube;    ///< of a torus or knot; > 0
  std::optional<double> gap;     ///< two-spheres, tori; negative where the two overlap
  std::optional<double> neck;    ///< dumbbell: radius; negative where it is inverted
  std::optional<std::size_t> count;  ///< many-spheres, boxes
  std::optional<double> noise;       ///< amplitude; >= 0; default 0, folded: 38 % of its box
  std::uint64_t seed = 1;            ///< of the noise and of random shapes
  std::optional<Box> around;         ///< sphere: contains this box with a little room
  std::vector<Vec3> points;          ///< hull: the points to go around
  Vec3 center = Vec3::Zero();        ///< where the shape's own origin goes
};

/// The names of all kinds, in the order of the manual.
const std::vector<std::string>& shape_kinds();

/// The mesh asked for. The number of faces is within a few percent of `faces` where the kind allows
/// (an icosahedron has 20, box and boxes have 12 each). Throws UsageError for options that the kind
/// does not have, or that make no sense, for fewer faces than a genus needs, for more than 10^9,
/// and for shapes too far from the origin, or with tubes too thin, for their coordinates. O(faces).
Mesh make_shape(const ShapeOptions& options, const Progress& progress = {});

/// The diagonal of the bounding box of that shape, estimated by a coarse version.
double shape_diagonal(ShapeOptions options);

/// An icosahedron with each face cut into n^2 (geodesic, class I), n chosen for `faces` = 20 n^2.
Mesh make_sphere(const Vec3& center, double radius, std::size_t faces);

}  // namespace transformesh
