#include "page/run_page.h"

#include <doctest/doctest.h>

#include "evolution/loop/run_folder.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "io/streams/atomic_file.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;

namespace {

using test::make_file;
using test::TemporaryFolder;

/// Balls of radius 2 to 1; the last one is the target.
std::string make_run(const TemporaryFolder& above, std::size_t frames) {
  const std::string folder = above / "a run";
  begin_run(folder, {"tm-morph", "1", {"tm-morph x"}}, {});
  make_folder(folder + run_file::frames);
  const Mesh ball = test::icosphere(2);
  write_mesh_file(folder + run_file::target, ball);
  std::string log = "iteration,faces\n";
  for (std::size_t i = 0; i < frames; ++i) {
    const double radius = 2 - static_cast<double>(i) / static_cast<double>(frames);
    write_mesh_file(folder + "/frames/frame-0000" + std::to_string(i) + ".ply",
                    test::scaled(ball, radius));
    if (i > 0) log += std::to_string(i) + ",320\n";
  }
  make_file(folder + run_file::log, log);
  return folder;
}

std::vector<std::size_t> numbers_of(const PageRun& run) {
  std::vector<std::size_t> numbers;
  for (const PageMesh& mesh : run.meshes) numbers.push_back(mesh.number);
  return numbers;
}

}  // namespace

TEST_CASE("an active run is shown up to its last frame") {
  const TemporaryFolder above;
  const PageRun run = read_run_page(make_run(above, 4) + '/');
  CHECK(run.name == "a run");
  CHECK(run.tool == "tm-morph");
  CHECK(run.report.empty());
  CHECK(numbers_of(run) == std::vector<std::size_t>{0, 1, 2, 3});
  REQUIRE(run.targets.size() == 1);
  // The ball of radius 2 is 1 away from the vertices of its target, and farther between them.
  const PackedColumn& distance = run.meshes[0].mesh.columns.at(0);
  CHECK(distance.name == "distance");
  CHECK(distance.low == doctest::Approx(1).epsilon(0.01));
  CHECK(distance.high == doctest::Approx(1).epsilon(0.05));
}

TEST_CASE("every N-th frame is taken, and the result if it is no frame") {
  const TemporaryFolder above;
  const std::string folder = make_run(above, 6);
  CHECK(numbers_of(read_run_page(folder, {.every = 4})) == std::vector<std::size_t>{0, 4, 5});
  write_mesh_file(folder + run_file::result, test::icosphere(2));
  CHECK(read_run_page(folder).meshes.size() == 6);
  make_file(folder + run_file::log, "iteration,faces\n1,320\n8,320\n9,3");
  const PageRun run = read_run_page(folder);
  CHECK(run.meshes.back().number == 8);
  CHECK(run.meshes.back().label == "result");
}

TEST_CASE("meshes of a movie are shown with their own targets, the first one with the next") {
  const TemporaryFolder above;
  const std::string folder = make_run(above, 4);
  make_folder(folder + run_file::targets);
  for (const std::size_t number : {1, 2, 3})
    write_mesh_file(folder + run_name(run_file::targets, number, ".ply"),
                    test::scaled(test::icosphere(2), 2.0 + static_cast<double>(number)));
  const PageRun run = read_run_page(folder, {.every = 2});
  CHECK(numbers_of(run) == std::vector<std::size_t>{0, 2, 3});
  REQUIRE(run.targets.size() == 3);
  CHECK(run.targets[0].number == 1);
  CHECK(run.targets[1].number == 2);
  // The balls have radii 2, 1.5 and 1.25, and their targets have radii 3, 4 and 5.
  for (const auto& [i, distance] : {std::pair{0, 1.0}, {1, 2.5}, {2, 3.75}})
    CHECK(run.meshes[i].mesh.columns.at(0).low == doctest::Approx(distance).epsilon(0.02));
  CHECK(page_blocks({&run, 1}).size() == 6);
}

TEST_CASE("a folder that is no run, and a run without a mesh, are refused") {
  const TemporaryFolder above;
  CHECK_THROWS_AS(read_run_page(above / "nothing"), InputError);
  begin_run(above / "empty", {"tm-morph", "1", {}}, {});
  CHECK_THROWS_AS(read_run_page(above / "empty"), InputError);
  const std::string folder = make_run(above, 2);
  make_file(folder + "/frames/frame-00001.ply", "ply\nbroken");
  CHECK_THROWS_AS(read_run_page(folder), InputError);
}
