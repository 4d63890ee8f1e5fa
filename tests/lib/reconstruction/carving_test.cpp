#include "reconstruction/carving.h"

#include <doctest/doctest.h>

#include <functional>
#include <string>

#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

/// One window at each vertex, with this excess.
CarvingEvidence uniform(const Mesh& mesh, double excess) {
  return {std::vector<WindowSums>(mesh.positions.size(), {1, excess, 0}), 1};
}

/// Photographs that contradict a ball until its radius is at most `radius`.
CarvingEvidence contradicts_beyond(const Mesh& mesh, double radius) {
  return uniform(mesh, mesh.positions.front().norm() > radius ? 1 : 0.1);
}

void nothing(Document& /*document*/) {}

struct Carved {
  Mesh mesh;
  std::string stages;  ///< s: a sweep, t: the surface settles, k: it is kept
};

/// Carves a ball by steps of 0.08.
Carved carved_ball(const std::function<CarvingEvidence(const Mesh&)>& measure,
                   const std::function<void(Document&)>& sweep = nothing,
                   const std::function<void(Document&)>& clean = nothing) {
  Document document;
  document.mesh = test::icosphere(3);
  Carved result;
  carve(document, {measure, clean,
                   [&](Document& carved) {
                     result.stages += 's';
                     sweep(carved);
                   },
                   [&](Document&) { result.stages += 't'; }, [&] { result.stages += 'k'; }, 0.08});
  result.mesh = std::move(document.mesh);
  return result;
}

/// Carves the ball until its radius is at most `radius`.
Carved carved_to(double radius, const std::function<void(Document&)>& sweep = nothing) {
  return carved_ball([=](const Mesh& mesh) { return contradicts_beyond(mesh, radius); }, sweep);
}

}  // namespace

TEST_CASE("a surface recedes until photographs confirm it") {
  // Rounds end at radii of 0.92, 0.84, 0.76 and 0.68. Four rounds that confirm nothing are undone.
  for (const auto& [radius, end] : {std::pair(0.9, 0.84), {0.8, 0.76}, {0.7, 0.68}}) {
    const Carved carved = carved_to(radius);
    CHECK(carved.stages == "sssstk");
    for (const Vec3& p : carved.mesh.positions)
      CHECK(p.norm() == doctest::Approx(end).epsilon(1e-3));
  }
  CHECK(carved_to(0.5).stages == "sssst");
  CHECK(carved_to(0.5).mesh.positions == test::icosphere(3).positions);
}

TEST_CASE("each round uses the evidence of the surface after the last one") {
  // A sweep that remeshes changes the number of vertices.
  const Carved carved = carved_to(0.9, [](Document& document) {
    const std::size_t level = document.mesh.faces.size() > 500 ? 2 : 3;
    const double radius = document.mesh.positions.front().norm();
    document.mesh = test::icosphere(static_cast<int>(level));
    for (Vec3& p : document.mesh.positions) p *= radius;
  });
  CHECK(carved.stages == "sssstk");
  CHECK(carved.mesh.positions.front().norm() < 0.9);
}

TEST_CASE("carving ends after four settlings") {
  // Photographs contradict all but one vertex, and confirm that one the more the ball shrinks.
  const auto measure = [](const Mesh& mesh) {
    double radius = 0;
    for (const Vec3& p : mesh.positions) radius += p.norm();
    CarvingEvidence evidence = uniform(mesh, 0.6);
    evidence.of_vertex.front() = {1e6 / radius, 0, 0};
    return evidence;
  };
  CHECK(carved_ball(measure).stages == "sssstksssstksssstksssstk");
}

TEST_CASE("a surface that photographs confirm is not carved") {
  CHECK(carved_to(2).stages.empty());
}

TEST_CASE("carving is undone if the outline shrinks, no more is confirmed, or a stage fails") {
  const Mesh before = test::icosphere(3);
  const auto uncovers = [](const Mesh& mesh) {
    CarvingEvidence evidence = contradicts_beyond(mesh, 0.7);
    evidence.outline = mesh.positions.front().norm();
    return evidence;
  };
  CHECK(carved_ball(uncovers).mesh.positions == before.positions);
  const auto never_confirms = [](const Mesh& mesh) { return uniform(mesh, 1); };
  CHECK(carved_ball(never_confirms).mesh.positions == before.positions);
  const auto fails = [](Document& document) {
    document.mesh = {};
    throw GoalError("nothing is left");
  };
  CHECK(carved_to(0.7, fails).mesh.positions == before.positions);
  const auto is_cancelled = [](Document&) { throw CancelledError("cancelled"); };
  CHECK_THROWS_AS(carved_to(0.7, is_cancelled), CancelledError);
}

TEST_CASE("carving is undone before a sweep if cleaning more than doubles the number of faces") {
  const Mesh before = test::icosphere(3);
  const auto measure = [](const Mesh& mesh) { return contradicts_beyond(mesh, 0.7); };
  for (const std::size_t copies : {2, 3}) {
    const Carved carved = carved_ball(measure, nothing, [&](Document& document) {
      const std::vector<Face> faces = before.faces;
      document.mesh.faces.clear();
      for (std::size_t i = 0; i < copies; ++i)
        document.mesh.faces.insert(document.mesh.faces.end(), faces.begin(), faces.end());
    });
    CHECK(carved.stages == (copies == 2 ? "sssstk" : ""));
    CHECK((carved.mesh.positions == before.positions) == (copies == 3));
  }
}
