#include "corpus/chains/bodies.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "corpus/chains/convex.h"

namespace chains {
namespace {

constexpr double unit = 0.125;  ///< spacing of the lattice; coordinates on it are exact
constexpr double reach = 16;    ///< farther from the origin than any part

struct Interval {
  double low, high;
  double length() const { return high - low; }
};

/// A prism: a convex polygon, counterclockwise, extruded along an axis.
struct Part {
  std::size_t axis = 2;
  std::vector<std::array<double, 2>> polygon;
  Interval along{};
  std::array<Interval, 3> box{};
  bool is_flat = true;
};

double on_lattice(double x) { return std::round(x / unit) * unit; }

/// Returns a random size; some parts are thin plates and rods.
double side_length(Random& random) {
  return unit * (random.chance(0.03) ? 0.125 : random.integer(2, 10));
}

/// Returns an interval that shares an end with `other`, touches it from outside (if allowed), or
/// overlaps a part of it.
Interval place_beside(const Interval& other, bool may_touch, Random& random) {
  const double length = side_length(random);
  switch (random.integer(0, may_touch ? 5 : 3)) {
    case 0:
      return other;
    case 1:
      return {other.low, other.low + length};
    case 2:
      return {other.high - length, other.high};
    case 4:
      return {other.high, other.high + length};
    case 5:
      return {other.low - length, other.low};
    default:
      break;
  }
  const double low = on_lattice(random.uniform(other.low - length / 2, other.high - length / 2));
  return {low, low + length};
}

/// Chooses corners on an ellipse in the rectangle, the rectangle itself, or half of it.
void draw_polygon(Part& part, const Interval& u, const Interval& v, Random& random) {
  const int kind = random.integer(0, 9);
  if (kind < 4) {
    part.polygon = {{u.low, v.low}, {u.high, v.low}, {u.high, v.high}, {u.low, v.high}};
    return;
  }
  const double side = std::min(u.length(), v.length());
  if (kind == 4) {  // a right triangle, half of a square
    part.polygon = {{u.low, v.low}, {u.low + side, v.low}, {u.low, v.low + side}};
    return;
  }
  const bool is_eighth = kind <= 6;
  const int corners = is_eighth   ? 4 * random.integer(1, 2)
                      : kind == 7 ? random.integer(3, 7)
                                  : random.integer(12, 32);
  part.is_flat = is_eighth;
  const double middle_u = u.low + side / 2, middle_v = v.low + side / 2;
  const double turn = std::numbers::pi / corners *
                      (is_eighth ? (corners == 8 ? 1 : 0) : random.pick(std::array{0.0, 1.0, 0.3}));
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / corners;
    part.polygon.push_back(
        {middle_u + side / 2 * std::cos(angle), middle_v + side / 2 * std::sin(angle)});
  }
}

Part make_part(const std::array<Interval, 3>& box, Random& random) {
  Part part;
  part.axis = static_cast<std::size_t>(random.integer(0, 2));
  part.along = box[part.axis];
  part.box = box;
  draw_polygon(part, box[(part.axis + 1) % 3], box[(part.axis + 2) % 3], random);
  return part;
}

Part first_part(Random& random) {
  std::array<Interval, 3> box;
  for (Interval& side : box) side = {0, 1.5 * side_length(random)};
  return make_part(box, random);
}

Part next_solid(const Part& other, Random& random) {
  std::array<Interval, 3> box;
  const int touching = random.integer(0, 3);
  for (int k = 0; k < 3; ++k)
    box[static_cast<std::size_t>(k)] =
        place_beside(other.box[static_cast<std::size_t>(k)], k == touching, random);
  return make_part(box, random);
}

/// Returns a cutter that makes a hole through `other`, a pocket or a cavity. Most of its ends stick
/// out of `other`; some are flush with its sides.
Part next_cutter(const Part& other, Random& random) {
  std::array<Interval, 3> box;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length =
        std::max(unit, on_lattice(other.box[k].length() * random.uniform(.2, .7)));
    const double low = on_lattice(random.uniform(other.box[k].low, other.box[k].high - length));
    box[k] = {low, low + length};
  }
  Interval& along = box[static_cast<std::size_t>(random.integer(0, 2))];
  const Interval& through = other.box[static_cast<std::size_t>(&along - box.data())];
  switch (random.integer(0, 7)) {
    case 0:
      along = through;
      break;
    case 1:
      along.high = through.high;
      break;
    case 2:
      break;
    case 3:
      along = {through.low - unit, along.high};
      break;
    default:
      along = {through.low - unit, through.high + unit};
      break;
  }
  if (!(along.high > along.low)) along.low = along.high - unit;
  return make_part(box, random);
}

Point place(const Part& part, const std::array<double, 2>& corner, double height) {
  Point p{};
  p[(part.axis + 1) % 3] = corner[0];
  p[(part.axis + 2) % 3] = corner[1];
  p[part.axis] = height;
  return p;
}

TriangleMesh mesh_of(const Part& part, Random& random) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(part.polygon.size());
  for (const double height : {part.along.low, part.along.high})
    for (const auto& corner : part.polygon) mesh.points.push_back(place(part, corner, height));
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    mesh.faces.push_back({0, i + 1, i});
    mesh.faces.push_back({n, n + i, n + i + 1});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    if (random.chance(0.5)) {
      mesh.faces.push_back({i, j, n + j});
      mesh.faces.push_back({i, n + j, n + i});
    } else {
      mesh.faces.push_back({i, j, n + i});
      mesh.faces.push_back({j, n + j, n + i});
    }
  }
  return mesh;
}

ConvexBody convex_body(const Part& part) {
  ConvexBody body;
  Point up{};
  up[part.axis] = 1;
  body.push_back({up, part.along.high});
  up[part.axis] = -1;
  body.push_back({up, -part.along.low});
  for (std::size_t i = 0; i < part.polygon.size(); ++i) {
    const auto &from = part.polygon[i], &to = part.polygon[(i + 1) % part.polygon.size()];
    const double x = to[1] - from[1], y = from[0] - to[0], length = std::hypot(x, y);
    const Point normal = place(part, {x / length, y / length}, 0);
    body.push_back({normal, (x * from[0] + y * from[1]) / length});
  }
  return body;
}

/// Returns whether faces of both meshes lie exactly in one plane and intersect.
bool touch_in_plane(const TriangleMesh& one, const TriangleMesh& other) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto triangle = [](const TriangleMesh& mesh, const Triangle& face) {
    const auto point = [&](std::uint32_t v) {
      const Point& p = mesh.points[v];
      return Kernel::Point_3(p[0], p[1], p[2]);
    };
    return Kernel::Triangle_3(point(face[0]), point(face[1]), point(face[2]));
  };
  for (const Triangle& f : one.faces)
    for (const Triangle& g : other.faces) {
      const Kernel::Triangle_3 s = triangle(one, f), t = triangle(other, g);
      const auto is_in_plane = [&](int i) { return CGAL::coplanar(s[0], s[1], s[2], t[i]); };
      if (is_in_plane(0) && is_in_plane(1) && is_in_plane(2) && CGAL::do_intersect(s, t))
        return true;
    }
  return false;
}

using Matrix = std::array<Point, 3>;

Matrix random_rotation(Random& random) {
  std::array<double, 4> q;
  double size = 0;
  do {
    size = 0;
    for (double& x : q) x = random.uniform(-1, 1), size += x * x;
  } while (size > 1 || size < 0.01);
  for (double& x : q) x /= std::sqrt(size);
  const auto [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

void map(TriangleMesh& mesh, const Matrix& matrix, double scale, const Point& shift) {
  for (Point& p : mesh.points) {
    const Point from = p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = scale * (matrix[k][0] * from[0] + matrix[k][1] * from[1] + matrix[k][2] * from[2]) +
             shift[k];
  }
}

void round_to(TriangleMesh& mesh, Type type) {
  mesh.type = type;
  if (type == Type::float32)
    for (Point& p : mesh.points)
      for (double& x : p) x = rounded_to_float(x);
}

/// Rotations back and forth change the last digits, so coplanar faces come slightly apart.
void shake(TriangleMesh& mesh, Random& random) {
  const Matrix there = random_rotation(random);
  Matrix back = there;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) back[i][j] = there[j][i];
  map(mesh, there, 1, {});
  map(mesh, back, 1, {});
}

/// Rotates, scales and translates the body as a whole, and rounds it to its scalar type.
void place_body(Body& body, Random& random) {
  Matrix matrix = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  body.is_rotated = random.chance(0.8);
  if (body.is_rotated) matrix = random_rotation(random);
  const double scale = random.chance(0.75) ? 1 : std::pow(10, random.uniform(-3, 3));
  Point shift{};
  const double distance = random.chance(0.9) ? 3 : 100;
  if (random.chance(0.4))
    for (double& x : shift) x = scale * random.uniform(-distance, distance);
  const bool is_shaken = random.chance(0.1);
  const Type type = random.chance(0.35) ? Type::float32 : Type::float64;
  for (TriangleMesh* mesh : {&body.solids, &body.cutter}) {
    if (is_shaken) shake(*mesh, random);
    map(*mesh, matrix, scale, shift);
    round_to(*mesh, type);
  }
  for (double* volume : {&body.volume, &body.volume_of_solids, &body.volume_in_two})
    *volume *= scale * scale * scale;
}

struct Parts {
  std::vector<Part> solids, cutters;
};

Parts draw_parts(Random& random) {
  Parts parts;
  parts.solids.push_back(first_part(random));
  const int solids = random.pick(std::array{1, 2, 2, 2, 3, 3, 4, 5});
  while (static_cast<int>(parts.solids.size()) < solids) {
    const Part& other = random.pick(parts.solids);
    parts.solids.push_back(random.chance(0.03) ? other : next_solid(other, random));
  }
  const int cutters = solids == 1 ? random.integer(1, 2) : random.pick(std::array{0, 0, 1, 2});
  for (int i = 0; i < cutters; ++i)
    parts.cutters.push_back(next_cutter(random.pick(parts.solids), random));
  return parts;
}

Body assemble(const Parts& parts, Random& random) {
  Body body;
  std::vector<ConvexBody> solids, cutters, all;
  std::vector<TriangleMesh> meshes;
  body.is_flat = true;
  for (const std::vector<Part>* group : {&parts.solids, &parts.cutters})
    for (const Part& part : *group) {
      const bool is_cutter = group == &parts.cutters;
      meshes.push_back(mesh_of(part, random));
      append(is_cutter ? body.cutter : body.solids, meshes.back(), is_cutter);
      (is_cutter ? cutters : solids).push_back(convex_body(part));
      all.push_back(convex_body(part));
      body.is_flat = body.is_flat && part.is_flat;
    }
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      body.has_coplanar_contact = body.has_coplanar_contact || touch_in_plane(meshes[i], meshes[j]);
  body.is_single_solid = solids.size() == 1;
  body.volume_of_solids = volume_at_winding_level(1, solids, reach);
  body.volume_in_two = volume_at_winding_level(2, solids, reach);
  body.volume = volume_at_winding_level(1, all, reach) - volume_at_winding_level(1, cutters, reach);
  return body;
}

}  // namespace

Body random_body(Random& random) {
  for (;;) {
    Body body = assemble(draw_parts(random), random);
    if (body.volume < 0.1 * body.volume_of_solids) continue;
    place_body(body, random);
    return body;
  }
}

}  // namespace chains
