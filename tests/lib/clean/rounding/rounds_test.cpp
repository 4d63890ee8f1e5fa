// A small evolution: a mesh is displaced and cleaned again and again, with extreme velocities.
// TM_ROUNDS=200 runs the long version (CONTRIBUTING.md).
#include <doctest/doctest.h>

#include <cstdlib>
#include <set>

#include "helpers/cgal_oracle.h"
#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shape_options.h"
#include "helpers/winding_oracle.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/clean.h"
#include "transformesh/displace.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/mesh_io.h"
#include "transformesh/remesh.h"

using namespace transformesh;

namespace {

/// The velocity is a sum of a few waves in space, so that neighbors move alike.
std::vector<Vec3> smooth_velocities(const Mesh& mesh, test::Random random, double speed) {
  std::vector<Vec3> velocities(mesh.positions.size(), Vec3::Zero());
  for (int wave = 0; wave < 4; ++wave) {
    const Vec3 frequency = random.point(-4, 4);
    const Vec3 amplitude = random.point(-speed, speed);
    const double phase = random.uniform(0, 6);
    for (std::size_t v = 0; v < velocities.size(); ++v) {
      velocities[v] += amplitude * std::sin(frequency.dot(mesh.positions[v]) + phase);
    }
  }
  return velocities;
}

/// Every vertex gets an independent velocity.
std::vector<Vec3> rough_velocities(const Mesh& mesh, test::Random& random, double speed) {
  std::vector<Vec3> velocities;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    velocities.push_back(random.point(-speed, speed));
  }
  return velocities;
}

bool has_duplicates(const Mesh& mesh) {
  std::set<std::array<double, 3>> places;
  for (const Vec3& p : mesh.positions) places.insert({p.x(), p.y(), p.z()});
  return places.size() < mesh.positions.size();
}

class Evolution {
 public:
  Evolution(const std::string& kind, std::uint64_t seed, Scalar coordinate)
      : kind_(kind), random_(seed), wind_(seed), coordinate_(coordinate) {
    start();
  }

  void run(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      CAPTURE(round);
      move(round);
      if (!clean_and_check()) start();
      keep_small();
    }
  }
  std::size_t pairs() const { return pairs_; }
  int restarts() const { return starts_ - 1; }

 private:
  void start() {
    ShapeOptions options = test::shape(kind_, 600);
    if (kind_ == "dumbbell") options.neck = -0.1;
    if (kind_ == "folded") options.seed = 1 + random_.below(1000);
    mesh_ = make_shape(options);
    round_positions(mesh_, coordinate_);
    edge_ = test::mean_edge(mesh_);
    ++starts_;
  }

  // The smooth velocities change every ten rounds, so that the mesh moves far enough to merge and
  // split. About every fifth round moves vertices independently of each other.
  void move(int round) {
    if (round % 10 == 0) wind_ = test::Random(random_.bits());
    const double speed = test::mean_edge(mesh_) / 2;
    DisplaceOptions options;
    options.alpha = random_.below(4) == 0 ? 0.4 : 0.2;
    displace(mesh_,
             random_.below(5) == 0 ? rough_velocities(mesh_, random_, speed)
                                   : smooth_velocities(mesh_, wind_, speed),
             options);
    round_positions(mesh_, coordinate_);
  }

  // Returns false if nothing is left, which random motion may cause.
  bool clean_and_check() {
    CleanOptions options;
    options.coordinate = coordinate_;
    const Mesh before = mesh_;
    try {
      const CleanResult result = clean(before, options);
      mesh_ = result.mesh;
      pairs_ += result.pairs;
    } catch (const GoalError& error) {
      INFO(std::string(error.what()));
      REQUIRE(std::string(error.what()).find("inside out") != std::string::npos);
      return false;
    }
    const test::Count facts = test::count(mesh_);
    REQUIRE(facts.is_closed_and_oriented);
    REQUIRE(facts.is_manifold);
    REQUIRE(find_intersections(mesh_).empty());
    if (!has_duplicates(mesh_)) REQUIRE(test::count_self_intersections(mesh_) == 0);
    test::WindingOracleOptions sampling;
    sampling.samples = 100;
    if (coordinate_ == Scalar::float32) sampling.tolerance = 1e-6;
    REQUIRE(test::compare_windings(before, mesh_, sampling).wrong == 0);
    return true;
  }

  // Without remeshing, the number of slivers grows by a constant factor in every round.
  void keep_small() {
    RemeshOptions options;
    options.min_edge = 0.7 * edge_;
    options.max_edge = 1.5 * edge_;
    options.coordinate = coordinate_;
    try {
      if (mesh_.faces.size() > 2500) remesh(mesh_, options);
    } catch (const GoalError&) {
      start();
    }
    if (mesh_.faces.size() > 10000) start();
  }

  std::string kind_;
  test::Random random_;
  test::Random wind_;
  Scalar coordinate_;
  Mesh mesh_;
  double edge_ = 0;
  std::size_t pairs_ = 0;
  int starts_ = 0;
};

void run_rounds(Scalar coordinate) {
  const char* wanted = std::getenv("TM_ROUNDS");
  const int rounds = wanted != nullptr ? std::atoi(wanted) : 30;
  const std::uint64_t seeds = wanted != nullptr ? 3 : 2;
  std::vector<std::string> kinds = {"torus", "dumbbell"};
  if (wanted != nullptr) kinds.insert(kinds.end(), {"two-spheres", "folded"});
  for (const std::string& kind : kinds) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      CAPTURE(kind);
      CAPTURE(seed);
      Evolution evolution(kind, seed, coordinate);
      evolution.run(rounds);
      CHECK(evolution.pairs() > 0);
      if (wanted != nullptr) {
        MESSAGE(kind, " ", seed, ": ", evolution.pairs(), " pairs resolved in ", rounds,
                " rounds, started anew ", evolution.restarts(), " times");
      }
    }
  }
}

}  // namespace

TEST_CASE("rounds of displace and clean never fail in doubles") { run_rounds(Scalar::float64); }

TEST_CASE("rounds of displace and clean never fail in floats") { run_rounds(Scalar::float32); }
