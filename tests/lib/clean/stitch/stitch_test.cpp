#include "transformesh/stitch.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

std::vector<double> volumes(const Mesh& mesh) {
  std::vector<double> result;
  for (const Component& c : connected_components(mesh).components) result.push_back(c.volume);
  return result;
}

// Checks the result by counting, without functions of stitching.
bool is_closed_manifold(const Mesh& mesh) {
  const test::Count count = test::count(mesh);
  return count.is_closed_and_oriented && count.is_manifold;
}

/// Returns whether the faces around every vertex form one umbrella, by walking around it. In an
/// oriented mesh, no halfedge occurs twice.
bool is_manifold_with_border(const Mesh& mesh, bool is_oriented) {
  std::map<std::pair<Index, Index>, int> halfedges;
  std::map<std::pair<Index, Index>, int> edges;
  std::vector<std::vector<std::pair<Index, Index>>> links(mesh.positions.size());
  for (const Face& f : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++halfedges[{f[i], f[(i + 1) % 3]}];
      ++edges[std::minmax(f[i], f[(i + 1) % 3])];
      links[f[i]].emplace_back(f[(i + 1) % 3], f[(i + 2) % 3]);
    }
  }
  const auto twice = [](const auto& entry) { return entry.second > 1; };
  const auto thrice = [](const auto& entry) { return entry.second > 2; };
  if (is_oriented && std::any_of(halfedges.begin(), halfedges.end(), twice)) return false;
  if (std::any_of(edges.begin(), edges.end(), thrice)) return false;
  return std::all_of(links.begin(), links.end(), [](const auto& link) {
    std::set<Index> reached{link.empty() ? 0 : link[0].first};
    for (std::size_t round = 0; round < link.size(); ++round) {
      for (const auto& [a, b] : link) {
        if (reached.contains(a)) reached.insert(b);
        if (reached.contains(b)) reached.insert(a);
      }
    }
    return std::all_of(link.begin(), link.end(),
                       [&](const auto& ends) { return reached.contains(ends.first); });
  });
}

/// Reverses each face at random.
Mesh shuffled(Mesh mesh, std::uint64_t seed) {
  test::Random random(seed);
  for (Face& face : mesh.faces) {
    if (random.below(2) == 1) std::swap(face[0], face[1]);
  }
  return mesh;
}

StitchResult orient(Mesh& mesh) {
  StitchOptions options;
  options.orient = true;
  return stitch(mesh, options);
}

/// Unit cells of a 3 x 3 x 3 block, as a soup of the faces between filled and empty cells.
class Cells {
 public:
  static constexpr int side = 3;

  explicit Cells(std::uint64_t filled) : filled_(filled) {}
  bool at(int x, int y, int z) const {
    const auto inside = [](int c) { return c >= 0 && c < side; };
    return inside(x) && inside(y) && inside(z) && (filled_ >> (x + side * (y + side * z)) & 1) == 1;
  }
  double count() const {
    double sum = 0;
    each([&](int x, int y, int z) { sum += at(x, y, z) ? 1 : 0; });
    return sum;
  }
  Mesh boundary(bool with_walls) const;
  bool has_cavity() const;

  template <class Visit>
  static void each(const Visit& visit) {
    for (int z = -1; z <= side; ++z)
      for (int y = -1; y <= side; ++y)
        for (int x = -1; x <= side; ++x) visit(x, y, z);
  }

 private:
  std::uint64_t filled_;
};

// Returns the faces of all cells towards smaller coordinates, oriented out of the filled cell.
Mesh Cells::boundary(bool with_walls) const {
  Mesh mesh;
  each([&](int x, int y, int z) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool here = at(x, y, z);
      const bool before = at(x - (axis == 0), y - (axis == 1), z - (axis == 2));
      if (here == before && !(with_walls && here)) continue;
      const Vec3 corner(x, y, z);
      Vec3 u = Vec3::Unit((axis + 1) % 3), v = Vec3::Unit((axis + 2) % 3);
      if (here) std::swap(u, v);
      const auto base = static_cast<Index>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), {corner, corner + u, corner + u + v, corner + v});
      mesh.faces.insert(mesh.faces.end(), {{base, base + 1, base + 2}, {base, base + 2, base + 3}});
    }
  });
  return mesh;
}

// Returns whether an empty cell is not connected to the outside.
bool Cells::has_cavity() const {
  constexpr int n = side + 2;
  const auto cell = [](int x, int y, int z) { return (x + 1) + n * ((y + 1) + n * (z + 1)); };
  std::vector<int> root(n * n * n);
  std::iota(root.begin(), root.end(), 0);
  for (int round = 0; round < n * n * n; ++round) {
    each([&](int x, int y, int z) {
      for (int axis = 0; axis < 3; ++axis) {
        const int bx = x - (axis == 0), by = y - (axis == 1), bz = z - (axis == 2);
        if (std::min({bx, by, bz}) < -1 || at(x, y, z) || at(bx, by, bz)) continue;
        int &a = root[cell(x, y, z)], &b = root[cell(bx, by, bz)];
        a = b = std::min(a, b);
      }
    });
  }
  bool found = false;
  each([&](int x, int y, int z) { found |= !at(x, y, z) && root[cell(x, y, z)] != 0; });
  return found;
}

}  // namespace

TEST_CASE("a soup becomes the mesh it was cut from") {
  const Mesh torus = test::torus(1, 0.3, 20, 10);
  Mesh mesh = test::soup_of(torus);
  const StitchResult result = stitch(mesh);
  CHECK(mesh.positions.size() == torus.positions.size());
  CHECK(mesh.faces.size() == torus.faces.size());
  CHECK(result.joined_vertices == 3 * torus.faces.size() - torus.positions.size());
  CHECK(result.copied_vertices == 0);
  CHECK(is_closed_manifold(mesh));
}

TEST_CASE("singular vertex: cubes that touch at a corner are separated there") {
  Mesh mesh = test::soup_of(test::joined(test::cube(), test::moved(test::cube(), {1, 1, 1})));
  CHECK(stitch(mesh).copied_vertices == 1);
  CHECK(is_closed_manifold(mesh));
  CHECK(connected_components(mesh).components.size() == 2);
  for (const double v : volumes(mesh)) CHECK(v == doctest::Approx(1));
}

TEST_CASE("singular edge: cubes that touch along an edge pair across their insides") {
  Mesh mesh = test::soup_of(test::joined(test::cube(), test::moved(test::cube(), {1, 1, 0})));
  CHECK(stitch(mesh).copied_vertices == 2);
  CHECK(is_closed_manifold(mesh));
  CHECK(connected_components(mesh).components.size() == 2);
  for (const double v : volumes(mesh)) CHECK(v == doctest::Approx(1));
}

TEST_CASE("singular triangle: solids on both sides of a face keep one each") {
  const Mesh right = test::tetrahedron();
  Mesh left = right;
  for (Vec3& p : left.positions) p[0] = -p[0];
  left = test::reversed(left);
  Mesh mesh = test::soup_of(test::joined(right, left));
  CHECK(stitch(mesh).copied_vertices == 3);
  CHECK(is_closed_manifold(mesh));
  CHECK(connected_components(mesh).components.size() == 2);
  for (const double v : volumes(mesh)) CHECK(v == doctest::Approx(1.0 / 6));
}

TEST_CASE("orient reverses faces until neighbors agree, and closed parts outwards") {
  Mesh mesh = test::joined(test::icosphere(2), test::moved(test::icosphere(1), {5, 0, 0}));
  for (std::size_t f = 0; f < mesh.faces.size(); f += 3) {
    std::swap(mesh.faces[f][0], mesh.faces[f][1]);
  }
  Mesh unturned = mesh;
  CHECK(stitch(unturned).misoriented_edges > 0);
  const StitchResult result = orient(mesh);
  CHECK(result.reversed_faces > 0);
  CHECK(result.misoriented_edges == 0);
  CHECK(is_closed_manifold(mesh));
  for (const double v : volumes(mesh)) CHECK(v > 0);
}

TEST_CASE("a closed part that agreed keeps its orientation, a shuffled one beside it does not") {
  const Mesh inside_out = test::reversed(test::icosphere(1));
  Mesh mesh = test::joined(inside_out, shuffled(test::moved(test::cube(), {5, 0, 0}), 1));
  orient(mesh);
  CHECK(volumes(mesh).front() == doctest::Approx(test::signed_volume(inside_out)));
  CHECK(volumes(mesh).back() == doctest::Approx(1));
}

TEST_CASE("random voxel solids are restored from shuffled soups") {
  test::Random random(7);
  int tested = 0, singular = 0;
  while (tested < 300) {
    const Cells cells(random.bits() & (random.below(2) == 1 ? random.bits() : ~0ULL));
    if (cells.count() == 0 || cells.has_cavity()) continue;
    ++tested;
    CAPTURE(tested);
    Mesh mesh = shuffled(cells.boundary(false), random.bits());
    const StitchResult result = orient(mesh);
    singular += result.copied_vertices + result.split_edges > 0 ? 1 : 0;
    CHECK(is_closed_manifold(mesh));
    CHECK(result.misoriented_edges == 0);
    CHECK(result.border_edges == 0);
    CHECK(test::signed_volume(mesh) == doctest::Approx(cells.count()));
    bool fits = true;
    Cells::each([&](int x, int y, int z) {
      const double w = test::winding_number(mesh, Vec3(x + 0.5, y + 0.47, z + 0.51));
      fits = fits && std::abs(w - (cells.at(x, y, z) ? 1 : 0)) < 1e-6;
    });
    CHECK(fits);
  }
  CHECK(singular > 100);  // otherwise no difficult case was tested
}

TEST_CASE("solids that share an edge, a vertex or a face come out whole from a shuffled soup") {
  const Mesh tetrahedron = test::tetrahedron();
  Mesh mirrored = tetrahedron;
  for (Vec3& p : mirrored.positions) p[0] = -p[0];
  mirrored = test::reversed(mirrored);
  const Mesh vertex = test::joined(test::cube(), test::moved(test::cube(), {1, 1, 1}));
  const Mesh edge = test::joined(test::cube(), test::moved(test::cube(), {1, 1, 0}));
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    for (const Mesh& both : {test::joined(tetrahedron, mirrored), vertex, edge}) {
      Mesh mesh = shuffled(test::soup_of(both), seed);
      orient(mesh);
      CHECK(is_closed_manifold(mesh));
      REQUIRE(volumes(mesh).size() == 2);
      for (const double v : volumes(mesh)) {
        CHECK(v == doctest::Approx(test::signed_volume(both) / 2));
      }
    }
  }
}

TEST_CASE("volumes of extreme size orient solids, which share faces, or are inside out") {
  Mesh both = test::joined(test::cube(), test::moved(test::cube(), {1, 0, 0}));
  both = test::joined(both, test::scaled(test::reversed(test::cube()), -0.5));
  for (const double size : {1e-150, 1e-108, 1e110, 1e150}) {
    CAPTURE(size);
    StitchOptions options;
    options.outwards = true;
    Mesh mesh = test::scaled(test::reversed(both), size);
    stitch(mesh, options);
    for (const double v : volumes(test::scaled(mesh, 1 / size))) CHECK(v > 0);
    mesh = test::scaled(shuffled(both, 5), size);
    orient(mesh);
    CHECK(is_closed_manifold(mesh));
    const std::vector<double> found = volumes(test::scaled(mesh, 1 / size));
    REQUIRE(found.size() == 3);
    for (const double v : found) CHECK(v > 0.1);
  }
}

TEST_CASE("touching solids that are inside out come out whole if they are turned outwards") {
  const Mesh pair = test::joined(test::cube(), test::moved(test::cube(), {1, 1, 0}));
  const Mesh three = test::joined(pair, test::moved(test::cube(), {0, 1, 1}));
  for (const bool orients : {false, true}) {
    StitchOptions options;
    options.outwards = true;
    options.orient = orients;
    Mesh mesh = test::soup_of(test::reversed(three));
    // One face of another direction: most faces are still inside out.
    if (orients) std::swap(mesh.faces[0][1], mesh.faces[0][2]);
    const StitchResult result = stitch(mesh, options);
    CHECK(result.split_edges == 0);
    CHECK(is_closed_manifold(mesh));
    CHECK(volumes(mesh).size() == 3);
    for (const double v : volumes(mesh)) CHECK(v == doctest::Approx(1));
  }
}

TEST_CASE("a wall between two solids becomes a sheet, and the skin around both looks outwards") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    Mesh mesh = shuffled(Cells(3).boundary(true), seed);
    CHECK(mesh.faces.size() == 22);
    const StitchResult result = orient(mesh);
    CHECK(result.border_edges == 4);
    CHECK(result.misoriented_edges == 0);
    CHECK(test::winding_number(mesh, {-0.5, 0.5, 0.5}) == doctest::Approx(0).epsilon(0.5));
    for (const double x : {0.2, 1.8}) {
      const double w = test::winding_number(mesh, {x, 0.49, 0.51});
      CHECK(std::lround(w) == 1);
    }
  }
}

TEST_CASE("three faces on an edge: two become a sheet, one another") {
  Mesh mesh;
  mesh.positions = {{0, 0, -3}, {0, -2, 1}, {3, 0, 0}, {0, 2, 1}, {-3, 0, 0}};
  mesh.faces = {{0, 2, 4}, {3, 2, 4}, {2, 4, 1}};
  Mesh apart = mesh;
  CHECK(stitch(apart).misoriented_edges == 1);
  CHECK(stitch(apart).misorientation.empty() == false);
  const StitchResult result = orient(mesh);
  CHECK(result.reversed_faces == 1);
  CHECK(result.misoriented_edges == 0);
  CHECK(result.border_edges == 7);
  CHECK(mesh.positions.size() == 7);
}

TEST_CASE("faces at an edge are paired, except one if their number is odd") {
  for (Index pages = 3; pages < 12; ++pages) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Mesh mesh;
      mesh.positions = {{0, 0, 0}, {0, 0, 1}};
      for (Index i = 0; i < pages; ++i) {
        const double angle = 2 * std::numbers::pi * i / pages;
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.1 * i);
        mesh.faces.push_back({0, 1, i + 2});
      }
      mesh = shuffled(mesh, seed);
      const StitchResult result = orient(mesh);
      CHECK(result.misoriented_edges == 0);
      CHECK(result.border_edges == 2 * pages + pages % 2);
      CHECK(2 * result.reversed_faces <= pages);
    }
  }
}

TEST_CASE("an edge that copies of its ends cannot take apart is split in the middle") {
  // At both ends of the edge from (1,1,1) to (1,1,2), all faces are connected.
  Mesh mesh;
  std::uint64_t filled = 0;
  for (const auto& [x, y, z] : {std::array{0, 0, 0},
                                {1, 0, 0},
                                {0, 1, 0},
                                {1, 1, 0},
                                {0, 0, 1},
                                {1, 1, 1},
                                {0, 0, 2},
                                {1, 0, 2},
                                {0, 1, 2},
                                {1, 1, 2}}) {
    filled |= 1ULL << (x + 3 * (y + 3 * z));
  }
  mesh = Cells(filled).boundary(false);
  mesh.vertex_columns.get("height", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.vertex_columns.columns[0].values[v] = mesh.positions[v][2];
  }
  Column& id = mesh.face_columns.get("side", Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    for (int i = 0; i < 3; ++i) {
      if (mesh.positions[a][i] == mesh.positions[b][i] &&
          mesh.positions[b][i] == mesh.positions[c][i])
        id.values[f] = 10 * i + mesh.positions[a][i];
    }
  }
  const std::size_t faces = mesh.faces.size();
  const StitchResult result = stitch(mesh);
  CHECK(result.split_edges == 1);
  CHECK(mesh.faces.size() == faces + 4);
  CHECK(is_closed_manifold(mesh));
  CHECK(test::signed_volume(mesh) == doctest::Approx(10));
  const auto& height = mesh.vertex_columns.find("height")->values;
  REQUIRE(height.size() == mesh.positions.size());
  for (std::size_t v = 0; v < height.size(); ++v) CHECK(height[v] == mesh.positions[v][2]);
  const auto& side = mesh.face_columns.find("side")->values;
  REQUIRE(side.size() == mesh.faces.size());
  for (std::size_t f = 0; f < side.size(); ++f) {
    const int axis = static_cast<int>(side[f]) / 10;
    for (const Index v : mesh.faces[f]) CHECK(mesh.positions[v][axis] == side[f] - 10 * axis);
  }
}

TEST_CASE("solids that overlap at a common edge are paired without remainder") {
  Mesh mesh = test::soup_of(
      test::joined(test::cuboid({0, 0, 0}, {2, 1, 1}), test::cuboid({0, 0, 0}, {1, 2, 1})));
  const StitchResult result = stitch(mesh);
  CHECK(result.border_edges == 0);
  CHECK(result.misoriented_edges == 0);
  CHECK(is_closed_manifold(mesh));
  CHECK(test::signed_volume(mesh) == doctest::Approx(4));
}

TEST_CASE("a strip with one side is refused, naming the place in the input") {
  Mesh strip = test::moebius_strip(12);
  // A face that collapses comes first: messages use the numbers of the faces as given.
  strip.faces.insert(strip.faces.begin(), {0, 0, 1});
  std::string message;
  try {
    orient(strip);
  } catch (const InputError& error) {
    message = error.what();
  }
  CHECK(message.starts_with(
      "faces 13 and 14 cannot have consistent orientations at the edge from vertex 13 at (-1, "));
  CHECK(message.find("only one side, like a Moebius strip") != std::string::npos);
}

TEST_CASE("any soup becomes a manifold, misoriented edges aside") {
  test::Random random(3);
  std::size_t split = 0, copied = 0;
  for (int round = 0; round < 5000; ++round) {
    // Few points at few positions: many faces share an edge, are coplanar, coincide, or have no
    // area.
    Mesh mesh;
    for (int i = 0; i < 7; ++i) {
      mesh.positions.emplace_back(random.below(2), random.below(2), random.below(3));
    }
    for (std::uint64_t i = 2 + random.below(14); i > 0; --i) {
      Face face;
      for (Index& v : face) v = static_cast<Index>(random.below(7));
      mesh.faces.push_back(face);
    }
    CAPTURE(round);
    StitchResult result;
    try {
      result = orient(mesh);
    } catch (const InputError&) {
      result = stitch(mesh);
    }
    split += result.split_edges;
    copied += result.copied_vertices;
    CHECK(is_manifold_with_border(mesh, result.misoriented_edges == 0));
  }
  CHECK(split > 10);
  CHECK(copied > 1000);
}

TEST_CASE("a tolerance joins what is close and nothing else") {
  Mesh mesh = test::soup_of(test::icosphere(2));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v][v % 3] += 1e-7 * static_cast<double>(v % 5);
  }
  Mesh apart = mesh;
  CHECK(stitch(apart).border_edges > 0);
  StitchOptions options;
  options.tolerance = 1e-5;
  stitch(mesh, options);
  CHECK(mesh.positions.size() == test::icosphere(2).positions.size());
  CHECK(is_closed_manifold(mesh));
}

TEST_CASE("columns follow their vertices and faces") {
  Mesh mesh = test::soup_of(test::cube());
  Column& x = mesh.vertex_columns.get("x_copy", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) x.values[v] = mesh.positions[v][0];
  mesh.face_columns.get("id", Scalar::int32, mesh.faces.size()).values[3] = 7;
  stitch(mesh);
  CHECK(mesh.vertex_columns.find("x_copy")->values.size() == 8);
  for (std::size_t v = 0; v < 8; ++v) {
    CHECK(mesh.vertex_columns.find("x_copy")->values[v] == mesh.positions[v][0]);
  }
  CHECK(mesh.face_columns.find("id")->values[3] == 7);
}
