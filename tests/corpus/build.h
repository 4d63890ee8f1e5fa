/// Functions from which the corpus builds its meshes, besides those of tests/helpers/shapes.h.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "helpers/random.h"
#include "helpers/shapes.h"

namespace transformesh::corpus {

using test::cube;
using test::cuboid;
using test::grid;
using test::icosphere;
using test::joined;
using test::moved;
using test::Random;
using test::reversed;
using test::scaled;
using test::soup_of;
using test::torus;

/// Returns the name of a case, `name-value`. Names sort by value.
std::string named(const std::string& name, long value);

/// Returns a random integer in [low, high].
long integer(Random& random, long low, long high);
/// Returns a random point with integer coordinates in [low, high].
Vec3 lattice_point(Random& random, long low, long high);
/// Returns a random box with integer corners in [0, size], no side longer than `longest`.
Mesh lattice_box(Random& random, long size, long longest);
/// Returns a random tetrahedron with volume and integer corners in [low, high], oriented outwards.
Mesh lattice_tetrahedron(Random& random, long low, long high);

/// Returns the tetrahedron of four points that are not coplanar, oriented outwards.
Mesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Returns two apexes on the z axis and a ring of `sides` points around it, turned by `angle`.
Mesh bipyramid(int sides, double radius, double height, double angle);

/// Rotates the mesh about an axis that is not a coordinate axis. Rounding moves coplanar faces of
/// different shapes apart.
Mesh turned(Mesh mesh, double angle = 0.7);
Mesh stretched(Mesh mesh, const Vec3& by);
/// Rounds the coordinates to integers.
Mesh on_lattice(Mesh mesh);
/// Moves every vertex at random by at most `amplitude` per coordinate.
Mesh jittered(Mesh mesh, double amplitude, Random& random);

}  // namespace transformesh::corpus
