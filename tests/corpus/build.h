/// What the corpus builds its meshes from, beside tests/helpers/shapes.h.
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

/// `name-value`, with values in order: the names of cases.
std::string named(const std::string& name, long value);

/// An integer in [low, high].
long integer(Random& random, long low, long high);
/// With integer coordinates in [low, high].
Vec3 lattice_point(Random& random, long low, long high);
/// A box with integer corners in [0, size], no side longer than `longest`.
Mesh lattice_box(Random& random, long size, long longest);
/// A tetrahedron with volume and integer corners in [low, high], facing outwards.
Mesh lattice_tetrahedron(Random& random, long low, long high);

/// The tetrahedron of four points that are not coplanar, facing outwards.
Mesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Two apexes on the z axis and a ring of `sides` points about it, turned by `angle`.
Mesh bipyramid(int sides, double radius, double height, double angle);

/// About an axis that is no coordinate axis: coplanar faces of different shapes come apart by what
/// is rounded.
Mesh turned(Mesh mesh, double angle = 0.7);
Mesh stretched(Mesh mesh, const Vec3& by);
/// Coordinates rounded to integers.
Mesh on_lattice(Mesh mesh);
/// Every vertex moved at random by at most `amplitude` per coordinate.
Mesh jittered(Mesh mesh, double amplitude, Random& random);

}  // namespace transformesh::corpus
