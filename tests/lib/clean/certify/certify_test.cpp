#include "clean/certify/certify.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "clean/certify/certify_faces.h"
#include "geometry/numbers/predicates.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "mesh/coordinate_spacing.h"
#include "support/parallel.h"
#include "transformesh/clean.h"
#include "transformesh/control.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

Mesh two_balls() { return joined(icosphere(2), moved(icosphere(2), {0.9, 0.33, 0.21})); }

Mesh inner_ball() { return moved(scaled(icosphere(1), 0.4), {0.1, 0.05, -0.1}); }

/// Returns a face of the output that is not in the input; there must be one.
Index new_face(const Mesh& input, const Mesh& output) {
  const auto faces = marked_faces(match_faces(input, output).output_is_new, 1);
  REQUIRE(!faces.empty());
  return faces[faces.size() / 2];
}

void check_wrong(const Mesh& input, const Mesh& output) {
  const Certificate certificate = certify(input, output);
  CHECK(certificate.wrong > 0);
  CHECK(!certificate.holds());
  CHECK(certificate.problem.find("winding number") != std::string::npos);
}

}  // namespace

TEST_CASE("cleaned workloads are certified, in doubles and floats") {
  for (const char* kind :
       {"two-spheres", "folded", "tangle", "dumbbell", "many-spheres", "boxes", "pinch"})
    for (const Scalar coordinate : {Scalar::float64, Scalar::float32}) {
      CAPTURE(kind);
      const Mesh input = workload(kind, 1500);
      CleanOptions clean_options;
      clean_options.coordinate = coordinate;
      CertifyOptions options;
      options.coordinate = coordinate;
      const Certificate certificate = certify(input, clean(input, clean_options).mesh, options);
      CHECK(certificate.problem == "");
      CHECK(certificate.input_is_closed);
      CHECK(certificate.samples > 500);
      CHECK(certificate.undecided_share() < 0.01);
      CHECK(certificate.wrong == 0);
    }
}

TEST_CASE("rotated boxes and moved pinches, whose thin sheets rounding closes, are certified") {
  for (const char* kind : {"boxes", "pinch"})
    for (const double angle : {0.4, 1.3})
      for (const Scalar coordinate : {Scalar::float64, Scalar::float32}) {
        CAPTURE(kind);
        CAPTURE(angle);
        Mesh input = workload(kind, 800, 3);
        const Eigen::AngleAxisd rotation(angle, Vec3(1, 2, 3).normalized());
        for (Vec3& p : input.positions) p = rotation * p + Vec3(31, -7, 190 * angle);
        if (coordinate == Scalar::float32)
          for (Vec3& p : input.positions)
            for (double& x : p) x = round_to_single(x);
        CleanOptions clean_options;
        clean_options.coordinate = coordinate;
        const CleanResult result = clean(input, clean_options);
        CertifyOptions options;
        options.coordinate = coordinate;
        const Certificate certificate = certify(input, result.mesh, options);
        CHECK(certificate.problem == "");
        CHECK(certificate.undecided_share() < 0.04);
        CHECK(result.rounding_spacings < 200);
      }
}

TEST_CASE("an untouched mesh is its own boundary, at winding level 1 only") {
  CHECK(certify(icosphere(2), icosphere(2)).holds());
  CertifyOptions twice;
  twice.winding_level = 2;
  CHECK(!certify(icosphere(2), icosphere(2), twice).holds());
  CHECK(certify(joined(icosphere(2), icosphere(2)), icosphere(2), twice).holds());
  CHECK(!certify(joined(icosphere(2), icosphere(2)), Mesh(), twice).holds());
}

TEST_CASE("a flipped face is found, an old one and a new one") {
  const Mesh input = two_balls();
  const Mesh output = clean(input).mesh;
  for (const Index face : {Index{0}, new_face(input, output)}) {
    Mesh wrong = output;
    std::swap(wrong.faces[face][0], wrong.faces[face][1]);
    check_wrong(input, wrong);
  }
}

TEST_CASE("a dropped component and one too many are found") {
  const Mesh ball = icosphere(2);
  const Mesh far = moved(inner_ball(), {5, 0, 0});
  check_wrong(joined(ball, far), ball);
  check_wrong(ball, joined(ball, far));
}

TEST_CASE("a wrong sheet is found: the inner one beside or instead of the outer one") {
  const Mesh input = two_balls();
  CleanOptions winding_level_2;
  winding_level_2.winding_level = 2;
  const Mesh inner_sheet = clean(input, winding_level_2).mesh;
  check_wrong(input, inner_sheet);
  check_wrong(input, joined(clean(input).mesh, inner_sheet));
  const Mesh nested = joined(icosphere(2), inner_ball());
  check_wrong(nested, nested);
  check_wrong(nested, inner_ball());
}

TEST_CASE("remaining self-intersections are found") { check_wrong(two_balls(), two_balls()); }

TEST_CASE("a cavity inverted, filled or invented is found") {
  const Mesh hollow = joined(icosphere(2), reversed(inner_ball()));
  CHECK(certify(hollow, hollow).holds());
  check_wrong(hollow, joined(icosphere(2), inner_ball()));
  check_wrong(hollow, icosphere(2));
  check_wrong(icosphere(2), hollow);
}

TEST_CASE("a moved vertex is found, even if it moved little") {
  const Mesh input = two_balls();
  const Mesh output = clean(input).mesh;
  for (const double shift : {1e-1, 1e-4, 1e-8, 1e-11}) {
    CAPTURE(shift);
    Mesh wrong = output;
    wrong.positions[3] *= 1 + shift;
    check_wrong(input, wrong);
    wrong = output;
    wrong.positions[wrong.faces[new_face(input, output)][0]] *= 1 - shift;
    check_wrong(input, wrong);
  }
}

TEST_CASE("movements by rounding are accepted") {
  const Mesh input = two_balls();
  Mesh output = clean(input).mesh;
  for (Vec3& position : output.positions) position = position.unaryExpr(&round_to_single);
  CertifyOptions options;
  options.coordinate = Scalar::float32;
  const Certificate certificate = certify(input, output, options);
  CHECK(certificate.holds());
  CHECK(certificate.samples > output.faces.size());
}

TEST_CASE("faces of the input that collapse to a point disturb nothing") {
  Mesh input = two_balls();
  const Mesh output = clean(input).mesh;
  input.positions.emplace_back(0, 0, 0);
  const Index origin = static_cast<Index>(input.positions.size() - 1);
  input.faces.insert(input.faces.begin(), 40, {origin, origin, origin});
  Mesh rounded = output;
  for (Vec3& position : rounded.positions) position = position.unaryExpr(&round_to_single);
  CertifyOptions options;
  options.coordinate = Scalar::float32;
  CHECK(certify(input, rounded, options).problem == "");
}

TEST_CASE("tiny and huge coordinates are judged alike") {
  const Mesh input = two_balls();
  Mesh wrong = clean(input).mesh;
  const Index moved_vertex = wrong.faces[new_face(input, wrong)][0];
  const Mesh output = wrong;
  wrong.positions[moved_vertex] *= 1 + 1e-9;
  const std::size_t samples = certify(input, output).samples;
  for (const int exponent : {-1000, -500, -100, 100, 500, 1000}) {
    CAPTURE(exponent);
    const double scale = std::ldexp(1.0, exponent);
    const Certificate certificate = certify(scaled(input, scale), scaled(output, scale));
    CHECK(certificate.problem == "");
    CHECK(certificate.samples == samples);
    check_wrong(scaled(input, scale), scaled(wrong, scale));
  }
}

TEST_CASE("too many undecided samples are a problem of their own") {
  // The plate is so thin that no double lies clearly inside.
  const Mesh plate = cuboid({1, 1, 1}, {2, 2, std::nextafter(1.0, 2.0)});
  const Certificate certificate = certify(plate, plate);
  CHECK(certificate.wrong == 0);
  CHECK(certificate.undecided_share() > most_undecided);
  CHECK(certificate.problem.find("undecided") != std::string::npos);
}

TEST_CASE("equal positions close a soup, and a missing face opens it") {
  Mesh soup;
  for (const Face& face : cube().faces)
    for (const Index v : face) {
      if (soup.positions.size() % 3 == 0) {
        const Index n = static_cast<Index>(soup.positions.size());
        soup.faces.push_back({n, n + 1, n + 2});
      }
      soup.positions.push_back(cube().positions[v]);
    }
  const Certificate closed = certify(soup, cube());
  CHECK(closed.holds());
  CHECK(closed.input_is_closed);
  soup.faces.pop_back();
  CHECK(!certify(soup, cube()).input_is_closed);
}

TEST_CASE("new faces of an open mesh must be pieces of input faces") {
  const Mesh sheet = grid(1);
  Mesh finer = grid(4);
  for (Vec3& position : finer.positions) position.z() = 0;
  const Certificate certificate = certify(sheet, finer);
  CHECK(certificate.holds());
  CHECK(!certificate.input_is_closed);
  CHECK(certificate.samples == finer.faces.size());

  CHECK(certify(sheet, reversed(finer)).wrong == finer.faces.size());
  finer.positions[7].z() = 1e-6;
  CHECK(!certify(sheet, finer).holds());
  finer.positions[7] += Vec3(5, 0, -1e-6);
  CHECK(!certify(sheet, finer).holds());
}

TEST_CASE("a piece of an open mesh that rounding can reverse has any orientation") {
  Mesh sheet;
  sheet.positions = {{-1, 0, 1}, {0, 0, 9}, {0, -1, 1}};
  sheet.faces = {{0, 1, 2}};
  const auto turned_sliver = [](double width) {
    Mesh sliver;
    sliver.positions = {{0, -0.25, 7}, {-width / 2, -0.5 + width / 2, 5}, {0, -0.75, 3}};
    sliver.faces = {{0, 1, 2}};
    return sliver;
  };
  CHECK(normals_dot(triangle_of(sheet, 0), triangle_of(turned_sliver(1e-9), 0)) < 0);
  CHECK(certify(sheet, turned_sliver(1e-15)).holds());
  CHECK(certify(sheet, turned_sliver(1e-13)).wrong == 1);
  CHECK(certify(sheet, turned_sliver(1e-9)).wrong == 1);
}

// The sliver is 2e-30 wide, but numbers there are 3e-26 apart. Its exact orientation is that of the
// face; rounding to a neighboring number may reverse it.
TEST_CASE("a piece of an open mesh of many magnitudes may turn by rounding") {
  constexpr double tiny = 0x1p-32;
  Mesh mesh;
  mesh.positions = {{-tiny, 0, -tiny},    {0, 0, 9}, {0, -tiny, -0x1p-47}, {0, -tiny, 1 - 0x1p-47},
                    {-tiny, 0x1.cp31, 0}, {0, 0, 0}};
  mesh.faces = {{0, 1, 2}, {5, 4, 3}, {3, 4, 5}, {3, 5, 2}};
  const Mesh result = clean(mesh).mesh;
  CHECK(certify(mesh, result).wrong == 0);
  CHECK(certify(mesh, reversed(result)).wrong > 0);
}

TEST_CASE("patches are bounded by the faces that meet others") {
  const Mesh balls = two_balls();
  const UncutPatches patches = find_uncut_patches(balls, Progress());
  // The outer and the inner part of each ball.
  CHECK(patches.faces.size() == 4);
  std::size_t cut = 0;
  for (const char is_cut : patches.is_cut) cut += is_cut != 0 ? 1U : 0U;
  std::size_t whole = 0;
  for (const auto& patch : patches.faces) whole += patch.size();
  CHECK(cut > 0);
  CHECK(cut + whole == balls.faces.size());
}

TEST_CASE("certification does not depend on the number of threads") {
  const Mesh input = two_balls();
  const Mesh output = joined(clean(input).mesh, inner_ball());
  const Certificate expected = certify(input, output);
  const ThreadLimit one(1);
  const Certificate certificate = certify(input, output);
  CHECK(certificate.problem == expected.problem);
  CHECK(certificate.samples == expected.samples);
  CHECK(certificate.wrong == expected.wrong);
}

TEST_CASE("an input without faces cannot be certified against") {
  CHECK_THROWS_AS(certify(Mesh(), cube()), InputError);
}
