#include "tm/evolve/shapes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "tm/support/error.h"
#include "tm/support/parallel.h"

using namespace transformesh;

namespace {

constexpr double pi = std::numbers::pi;

ShapeOptions shape(const std::string& kind, std::size_t faces = 0,
                   std::vector<std::string> parameters = {}) {
  ShapeOptions options;
  options.kind = kind;
  options.parameters = std::move(parameters);
  if (faces > 0) options.faces = faces;
  return options;
}

ShapeOptions with_gap(ShapeOptions options, double gap) {
  options.gap = gap;
  return options;
}

ShapeOptions with_neck(ShapeOptions options, double neck) {
  options.neck = neck;
  return options;
}

// ---- what a closed oriented manifold is, counted here and not by the library

struct Count {
  bool is_closed_and_oriented = true;  // every halfedge once, and its opposite too
  bool is_manifold = true;             // the faces around each vertex are one cycle
  bool has_isolated_vertices = false;
  std::vector<long> genera;  // per component, sorted
};

Count count(const Mesh& mesh) {
  Count result;
  std::map<std::pair<Index, Index>, Index> third;  // of the face left of a halfedge
  std::vector<Index> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<std::size_t> valence(mesh.positions.size(), 0);
  std::vector<Index> some_neighbour(mesh.positions.size());
  for (const Face& face : mesh.faces)
    for (int i = 0; i < 3; ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % 3];
      if (!third.try_emplace({a, b}, face[(i + 2) % 3]).second || a == b)
        result.is_closed_and_oriented = false;
      parent[root(a)] = root(b);
      ++valence[a];
      some_neighbour[a] = b;
    }
  for (const auto& [halfedge, apex] : third)
    if (!third.contains({halfedge.second, halfedge.first})) result.is_closed_and_oriented = false;
  if (!result.is_closed_and_oriented) return result;

  std::map<Index, long> euler;
  for (Index v = 0; v < valence.size(); ++v) {
    if (valence[v] == 0) {
      result.has_isolated_vertices = true;
      continue;
    }
    std::size_t steps = 0;
    Index neighbour = some_neighbour[v];
    do {
      neighbour = third.at({v, neighbour});
      ++steps;
    } while (neighbour != some_neighbour[v] && steps <= valence[v]);
    if (steps != valence[v]) result.is_manifold = false;
    euler[root(v)] += 1;
  }
  std::map<Index, long> halfedges;
  for (const auto& [halfedge, apex] : third) ++halfedges[root(halfedge.first)];
  // 3 F = 2 E = H, so V - E + F = V - H / 6.
  for (const auto& [component, vertices] : euler)
    result.genera.push_back((2 - vertices + halfedges[component] / 6) / 2);
  std::sort(result.genera.begin(), result.genera.end());
  return result;
}

void check_sound(const Mesh& mesh) {
  const Count counted = count(mesh);
  CHECK(counted.is_closed_and_oriented);
  CHECK(counted.is_manifold);
  CHECK_FALSE(counted.has_isolated_vertices);
  CHECK(mesh.vertex_columns.columns.empty());
  CHECK(mesh.face_columns.columns.empty());
}

double signed_volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces)
    sum += mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c]));
  return sum / 6;
}

// The solid angle of each face as seen from the point, summed up (Van Oosterom & Strackee 1983).
double winding_number(const Mesh& mesh, const Vec3& point) {
  double sum = 0;
  for (const Face& face : mesh.faces) {
    const Vec3 a = mesh.positions[face[0]] - point;
    const Vec3 b = mesh.positions[face[1]] - point;
    const Vec3 c = mesh.positions[face[2]] - point;
    sum += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                 b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return sum / (4 * pi);
}

// ---- self-intersections by testing all pairs

double orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

struct Crossings {
  std::size_t pairs = 0;    // faces of which an edge of one properly crosses the other
  double flattest = 1e300;  // the least volume of a test between two faces with a common point
};

class CrossingCounter {
 public:
  explicit CrossingCounter(const Mesh& mesh) : mesh_(mesh) {}

  Crossings all() {
    struct Interval {
      double low, high;
      Index face;
    };
    std::vector<Interval> intervals;
    for (Index f = 0; f < mesh_.faces.size(); ++f) {
      const auto box = box_of(f);
      intervals.push_back({box.first.x(), box.second.x(), f});
    }
    std::sort(intervals.begin(), intervals.end(),
              [](const Interval& a, const Interval& b) { return a.low < b.low; });
    for (std::size_t i = 0; i < intervals.size(); ++i)
      for (std::size_t j = i + 1; j < intervals.size() && intervals[j].low <= intervals[i].high;
           ++j)
        if (boxes_overlap(intervals[i].face, intervals[j].face))
          test(intervals[i].face, intervals[j].face);
    return result_;
  }

 private:
  std::pair<Vec3, Vec3> box_of(Index f) const {
    const auto& [a, b, c] = mesh_.faces[f];
    const auto& p = mesh_.positions;
    return {p[a].cwiseMin(p[b]).cwiseMin(p[c]), p[a].cwiseMax(p[b]).cwiseMax(p[c])};
  }

  bool boxes_overlap(Index f, Index g) const {
    const auto first = box_of(f);
    const auto second = box_of(g);
    return (first.first.array() <= second.second.array()).all() &&
           (second.first.array() <= first.second.array()).all();
  }

  void test(Index f, Index g) {
    const bool crosses_one = crosses(f, g);
    const bool crosses_other = crosses(g, f);
    if (crosses_one || crosses_other) ++result_.pairs;
  }

  // Whether an edge of f that has no corner of g runs through the inside of g.
  bool crosses(Index f, Index g) {
    const auto& [ga, gb, gc] = mesh_.faces[g];
    const auto is_of_g = [&](Index v) { return v == ga || v == gb || v == gc; };
    bool found = false;
    for (int i = 0; i < 3; ++i) {
      const Index p = mesh_.faces[f][i];
      const Index q = mesh_.faces[f][(i + 1) % 3];
      if (is_of_g(p) || is_of_g(q)) continue;
      found |= segment_crosses(mesh_.positions[p], mesh_.positions[q], mesh_.positions[ga],
                               mesh_.positions[gb], mesh_.positions[gc]);
    }
    return found;
  }

  bool segment_crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double at_p = orientation(a, b, c, p);
    const double at_q = orientation(a, b, c, q);
    if ((at_p > 0) == (at_q > 0)) return false;
    const std::array<double, 3> around = {orientation(p, q, a, b), orientation(p, q, b, c),
                                          orientation(p, q, c, a)};
    const bool is_inside = (around[0] > 0) == (around[1] > 0) && (around[1] > 0) == (around[2] > 0);
    if (!is_inside) return false;
    for (const double value : {at_p, at_q, around[0], around[1], around[2]})
      result_.flattest = std::min(result_.flattest, std::abs(value));
    return true;
  }

  const Mesh& mesh_;
  Crossings result_;
};

Crossings crossings(const Mesh& mesh) { return CrossingCounter(mesh).all(); }

double mean_edge(const Mesh& mesh) {
  double sum = 0;
  for (const Face& face : mesh.faces)
    for (int i = 0; i < 3; ++i)
      sum += (mesh.positions[face[i]] - mesh.positions[face[(i + 1) % 3]]).norm();
  return sum / (3.0 * static_cast<double>(mesh.faces.size()));
}

// The mean over faces of their smallest angle, in degrees.
double mean_smallest_angle(const Mesh& mesh) {
  double sum = 0;
  for (const Face& face : mesh.faces) {
    double cosine = -1;
    for (int i = 0; i < 3; ++i) {
      const Vec3& apex = mesh.positions[face[i]];
      const Vec3 u = (mesh.positions[face[(i + 1) % 3]] - apex).normalized();
      const Vec3 v = (mesh.positions[face[(i + 2) % 3]] - apex).normalized();
      cosine = std::max(cosine, u.dot(v));
    }
    sum += std::acos(std::min(cosine, 1.0)) * 180 / pi;
  }
  return sum / static_cast<double>(mesh.faces.size());
}

}  // namespace

TEST_CASE("every kind is closed, oriented, manifold and near the faces wanted, for any seed") {
  for (const std::string& kind : shape_kinds())
    for (const std::size_t faces : {500, 6000})
      for (const std::uint64_t seed : {1, 2, 3}) {
        CAPTURE(kind);
        CAPTURE(faces);
        CAPTURE(seed);
        ShapeOptions options = shape(kind, faces);
        options.seed = seed;
        const Mesh mesh = make_shape(options);
        check_sound(mesh);
        CHECK(signed_volume(mesh) > 0);
        CHECK(static_cast<double>(mesh.faces.size()) ==
              doctest::Approx(static_cast<double>(faces)).epsilon(0.06));
      }
}

TEST_CASE("genus and components are those of the kind") {
  using Genera = std::vector<long>;
  const auto genera = [](const ShapeOptions& options) { return count(make_shape(options)).genera; };
  CHECK(genera(shape("sphere")) == Genera{0});
  CHECK(genera(shape("ellipsoid")) == Genera{0});
  CHECK(genera(shape("box")) == Genera{0});
  CHECK(genera(shape("torus")) == Genera{1});
  CHECK(genera(shape("torus-knot")) == Genera{1});
  CHECK(genera(shape("torus-knot", 4000, {"3", "7"})) == Genera{1});
  CHECK(genera(shape("two-spheres")) == Genera{0, 0});
  CHECK(genera(shape("tori")) == Genera{1, 1});
  CHECK(genera(shape("dumbbell")) == Genera{0});
  CHECK(genera(with_neck(shape("dumbbell"), -0.15)) == Genera{0});
  CHECK(genera(shape("bowl")) == Genera{0});
  CHECK(genera(shape("folded")) == Genera{0});
  CHECK(genera(shape("folded", 4000, {"torus"})) == Genera{1});
  CHECK(genera(shape("tangle")) == Genera{1});
  CHECK(genera(shape("many-spheres")) == Genera(20, 0));
  CHECK(genera(shape("boxes")) == Genera(50, 0));
  CHECK(genera(shape("pinch")) == Genera{0});
  for (const long holes : {1, 2, 3, 4, 5, 7}) {
    CAPTURE(holes);
    CHECK(genera(shape("genus", 5000, {std::to_string(holes)})) == Genera{holes});
  }
}

TEST_CASE("volumes are those of the smooth shapes, up to the flatness of faces") {
  // Inscribed faces lose volume as one over their number.
  const auto check = [](ShapeOptions options, double volume) {
    CAPTURE(options.kind);
    options.faces = 3000;
    const double coarse = 1 - signed_volume(make_shape(options)) / volume;
    options.faces = 12000;
    const double fine = 1 - signed_volume(make_shape(options)) / volume;
    CHECK(coarse > 0);
    CHECK(coarse < 0.03);
    CHECK(coarse / fine == doctest::Approx(4).epsilon(0.08));
  };
  ShapeOptions sphere = shape("sphere");
  sphere.radius = 0.8;
  check(sphere, 4 * pi / 3 * std::pow(0.8, 3));
  check(shape("ellipsoid", 0, {"1", "0.8", "0.5"}), 4 * pi / 3 * 0.4);
  ShapeOptions torus = shape("torus");
  torus.radius = 1;
  torus.tube = 0.4;
  check(torus, 2 * pi * pi * 0.16);
  check(with_gap(shape("two-spheres"), 0.1), 8 * pi / 3 * std::pow(0.7, 3));
  check(with_gap(shape("tori"), 0.08), 4 * pi * pi * 0.62 * 0.27 * 0.27);

  // A shell of inner radius 0.63 and outer radius 1.17 up to 9 degrees above the horizon, and half
  // a disk swept along its rim (Pappus).
  const double angle = 0.05 * pi;
  const double shell = 2 * pi / 3 * (1 + std::sin(angle)) * (std::pow(1.17, 3) - std::pow(0.63, 3));
  const double centroid = 0.9 * std::cos(angle) - 4 * 0.27 / (3 * pi) * std::sin(angle);
  check(shape("bowl"), shell + 2 * pi * centroid * pi * 0.27 * 0.27 / 2);
}

TEST_CASE("a tube around a knot has the volume of its cross section times its length") {
  ShapeOptions options = shape("torus-knot", 40000, {"2", "5"});
  options.radius = 1;
  options.tube = 0.1;
  double length = 0;
  Vec3 last(1.42, 0, 0);
  constexpr int steps = 100000;
  for (int i = 1; i <= steps; ++i) {
    const double t = 2 * pi * i / steps;
    const double radius = 1 + 0.42 * std::cos(5 * t);
    const Vec3 here(radius * std::cos(2 * t), radius * std::sin(2 * t), 0.42 * std::sin(5 * t));
    length += (here - last).norm();
    last = here;
  }
  CHECK(signed_volume(make_shape(options)) == doctest::Approx(pi * 0.01 * length).epsilon(0.01));
}

TEST_CASE("a box has its exact volume, and its corners where they belong") {
  const Mesh mesh = make_shape(shape("box", 3000, {"2", "1", "0.5"}));
  CHECK(signed_volume(mesh) == doctest::Approx(1).epsilon(1e-12));
  const Box box = bounding_box(mesh);
  CHECK(box.minimum == Vec3(-1, -0.5, -0.25));
  CHECK(box.maximum == Vec3(1, 0.5, 0.25));
  CHECK(make_shape(shape("box", 1)).faces.size() == 12);
}

TEST_CASE("plain kinds do not cross themselves") {
  std::vector<ShapeOptions> plain;
  for (const std::size_t faces : {500, 6000}) {
    for (const char* kind :
         {"sphere", "ellipsoid", "box", "torus", "genus", "torus-knot", "tori", "dumbbell", "bowl"})
      plain.push_back(shape(kind, faces));
    plain.push_back(with_gap(shape("two-spheres", faces), 0.05));
  }
  plain.push_back(shape("torus-knot", 6000, {"3", "5"}));
  plain.push_back(shape("torus-knot", 6000, {"5", "2"}));
  plain.push_back(shape("genus", 6000, {"7"}));
  for (const ShapeOptions& options : plain) {
    CAPTURE(options.kind);
    CAPTURE(*options.faces);
    CHECK(crossings(make_shape(options)).pairs == 0);
  }
}

TEST_CASE("workloads cross themselves, in general position") {
  for (const std::size_t faces : {500, 6000})
    for (const std::uint64_t seed : {1, 2, 3}) {
      std::vector<ShapeOptions> workloads = {shape("two-spheres", faces),
                                             shape("folded", faces),
                                             shape("folded", faces, {"torus"}),
                                             shape("tangle", faces),
                                             shape("many-spheres", faces),
                                             with_gap(shape("tori", faces), -0.1),
                                             with_neck(shape("dumbbell", faces), -0.15)};
      for (ShapeOptions& options : workloads) {
        options.seed = seed;
        CAPTURE(options.kind);
        CAPTURE(faces);
        CAPTURE(seed);
        const Mesh mesh = make_shape(options);
        const Crossings found = crossings(mesh);
        CHECK(found.pairs > 5);
        CHECK(found.flattest > 1e-11 * std::pow(mean_edge(mesh), 3));
      }
    }
}

TEST_CASE("overlaps have winding number 2 and an inverted neck -1") {
  CHECK(winding_number(make_shape(shape("two-spheres")), {0, 0, 0}) == doctest::Approx(2));
  CHECK(winding_number(make_shape(with_gap(shape("tori"), -0.1)), {0, 0, 0}) == doctest::Approx(2));
  const Mesh plain = make_shape(shape("dumbbell"));
  const Mesh inverted = make_shape(with_neck(shape("dumbbell"), -0.15));
  CHECK(winding_number(plain, {0, 0, 0}) == doctest::Approx(1));
  CHECK(winding_number(inverted, {0, 0, 0}) == doctest::Approx(-1));
  CHECK(winding_number(inverted, {0, 0, 0.7}) == doctest::Approx(1));
  CHECK(winding_number(inverted, {0, 0, -0.7}) == doctest::Approx(1));
}

TEST_CASE("boxes are integer, and share planes, edges and whole faces") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    ShapeOptions options = shape("boxes");
    options.seed = seed;
    const Mesh mesh = make_shape(options);
    CHECK(mesh.faces.size() == 600);
    std::map<std::array<double, 3>, std::size_t> corners;
    std::map<std::set<std::array<double, 3>>, std::size_t> edges;
    std::map<std::pair<int, double>, std::set<std::size_t>> planes;
    const auto key = [](const Vec3& p) { return std::array<double, 3>{p.x(), p.y(), p.z()}; };
    for (const Vec3& point : mesh.positions) {
      CHECK(point == Vec3(point.array().round()));
      ++corners[key(point)];
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const Vec3& from = mesh.positions[mesh.faces[f][i]];
        const Vec3& to = mesh.positions[mesh.faces[f][(i + 1) % 3]];
        const Vec3& next = mesh.positions[mesh.faces[f][(i + 2) % 3]];
        ++edges[{key(from), key(to)}];
        for (int axis = 0; axis < 3; ++axis)
          if (from[axis] == to[axis] && to[axis] == next[axis])
            planes[{axis, from[axis]}].insert(f / 12);
      }
    const auto most = [](const auto& table) {
      std::size_t result = 0;
      for (const auto& [entry, times] : table) result = std::max(result, times);
      return result;
    };
    CHECK(most(corners) > 1);  // boxes that meet in a corner
    CHECK(most(edges) > 2);    // in an edge
    std::size_t coplanar = 0;
    for (const auto& [plane, boxes] : planes) coplanar = std::max(coplanar, boxes.size());
    CHECK(coplanar > 5);
  }
}

TEST_CASE("a pinch has hundreds of edges through exactly one point") {
  const Mesh mesh = make_shape(shape("pinch"));
  std::set<std::pair<Index, Index>> through;
  for (const Face& face : mesh.faces)
    for (int i = 0; i < 3; ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % 3];
      if (mesh.positions[a] == -mesh.positions[b]) through.insert(std::minmax(a, b));
    }
  CHECK(through.size() > 200);
  CHECK(crossings(make_shape(shape("pinch", 2000))).pairs > 1000);
}

TEST_CASE("triangles are well shaped") {
  for (const char* kind : {"sphere", "ellipsoid", "torus", "genus", "torus-knot", "two-spheres",
                           "tori", "dumbbell", "bowl"}) {
    CAPTURE(kind);
    CHECK(mean_smallest_angle(make_shape(shape(kind))) > 49);
  }
}

TEST_CASE("edges are as long as asked for") {
  for (const char* kind : {"sphere", "box", "torus", "genus", "torus-knot", "two-spheres", "tori",
                           "dumbbell", "bowl", "tangle"}) {
    CAPTURE(kind);
    ShapeOptions options = shape(kind);
    options.edge = 0.05;
    CHECK(mean_edge(make_shape(options)) == doctest::Approx(0.05).epsilon(0.03));
  }
}

TEST_CASE("center moves, and around contains with little room") {
  ShapeOptions options = shape("sphere", 320);
  options.center = {5, -3, 2};
  CHECK((bounding_box(make_shape(options)).minimum - Vec3(4, -4, 1)).norm() < 0.1);

  options = shape("sphere", 20);
  options.around = Box{{1, 2, 3}, {2, 4, 6}};
  for (const std::size_t faces : {20, 320, 5000}) {
    options.faces = faces;
    const Mesh mesh = make_shape(options);
    double nearest = 1e300;
    for (const double x : {1, 2})
      for (const double y : {2, 4})
        for (const double z : {3, 6}) {
          CHECK(winding_number(mesh, {x, y, z}) == doctest::Approx(1));
          for (const Vec3& point : mesh.positions)
            nearest = std::min(nearest, (point - Vec3(x, y, z)).norm());
        }
    if (faces == 5000) CHECK(nearest < 0.1 * std::sqrt(14));
  }
}

TEST_CASE("noise moves along the normals, by its amplitude at most, and depends on the seed") {
  ShapeOptions options = shape("sphere", 5000);
  options.noise = 0.05;
  const Mesh first = make_shape(options);
  options.seed = 2;
  const Mesh second = make_shape(options);
  CHECK(first.positions != second.positions);
  double largest = 0;
  for (const Vec3& point : first.positions) largest = std::max(largest, std::abs(point.norm() - 1));
  CHECK(largest > 0.02);
  CHECK(largest < 0.051);
  CHECK(crossings(first).pairs == 0);
}

TEST_CASE("the same options give the same bytes for any number of threads") {
  for (const std::string& kind : shape_kinds()) {
    CAPTURE(kind);
    const auto made = [&](int threads) {
      const ThreadLimit limit(threads);
      ShapeOptions options = shape(kind, 3000);
      options.noise = 0.1;
      return make_shape(options);
    };
    const Mesh one = made(1);
    const Mesh four = made(4);
    CHECK(one.positions == four.positions);
    CHECK(one.faces == four.faces);
  }
}

TEST_CASE("senseless options are refused") {
  const auto refused = [](const ShapeOptions& options) {
    CHECK_THROWS_AS(make_shape(options), UsageError);
  };
  refused(shape("shpere"));
  refused(shape("sphere", 0, {"3"}));
  refused(shape("torus-knot", 0, {"2", "4"}));
  refused(shape("torus-knot", 0, {"2"}));
  refused(shape("torus-knot", 0, {"2", "-3"}));
  refused(shape("genus", 0, {"0"}));
  refused(shape("genus", 0, {"3x"}));
  refused(shape("genus", 100, {"3"}));
  refused(shape("box", 0, {"1", "0", "1"}));
  refused(shape("ellipsoid", 0, {"1", "1", "10%"}));
  refused(shape("folded", 0, {"cube"}));
  refused(with_neck(shape("sphere"), 0.1));
  refused(with_neck(shape("dumbbell"), 0));
  refused(with_neck(shape("dumbbell"), 0.8));
  refused(with_gap(shape("two-spheres"), -1.4));
  refused(with_gap(shape("tori"), 1));
  for (const double radius : {0.0, -1.0}) {
    ShapeOptions options = shape("sphere");
    options.radius = radius;
    refused(options);
  }
  ShapeOptions options = shape("torus");
  options.tube = 1;
  refused(options);
  options = shape("sphere", 100);
  options.edge = 0.1;
  refused(options);
  options.faces.reset();
  options.edge = 1e-9;
  refused(options);
  options = shape("boxes");
  options.edge = 1;
  refused(options);
  options = shape("torus");
  options.around = Box{{0, 0, 0}, {1, 1, 1}};
  refused(options);
  refused(shape("sphere", 2000000000));
}

TEST_CASE("making a shape can be cancelled") {
  const Progress stop([](std::string_view, double) { return false; });
  CHECK_THROWS_AS(make_shape(shape("genus"), stop), CancelledError);
}
