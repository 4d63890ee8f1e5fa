#include "page/live_run.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>

#include "evolution/loop/run_folder.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "io/streams/atomic_file.h"
#include "reconstruction/run_views.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"
#include "views/cameras/camera_ring.h"
#include "views/cameras/view.h"

using namespace transformesh;

namespace {

using test::make_file;
using test::TemporaryFolder;

void add_frame(const std::string& folder, std::size_t number, double radius) {
  make_folder(folder + run_file::frames);
  write_mesh_file(folder + "/frames/frame-0000" + std::to_string(number) + ".ply",
                  test::scaled(test::icosphere(1), radius));
}

std::vector<std::size_t> numbers_of(const LiveRun& live) {
  std::vector<std::size_t> numbers;
  for (const PageMesh& mesh : live.run().meshes) numbers.push_back(mesh.number);
  return numbers;
}

}  // namespace

TEST_CASE("frames of an active run appear one after the other, each under its own name") {
  const TemporaryFolder above;
  const std::string folder = above / "run";
  begin_run(folder, {"tm-evolve", "1", {}}, {});
  LiveRun live(folder);
  CHECK(live.run().meshes.empty());
  add_frame(folder, 0, 1);
  add_frame(folder, 2, 2);
  live.refresh(10);
  CHECK(numbers_of(live) == std::vector<std::size_t>{0, 2});
  const std::string first = live.run().meshes[0].block;
  REQUIRE(live.block(first) != nullptr);
  CHECK(*live.block(first) == live.run().meshes[0].mesh.block);
  CHECK(live.block("mesh-0-0") == nullptr);

  add_frame(folder, 4, 3);
  live.refresh(10);
  CHECK(numbers_of(live) == std::vector<std::size_t>{0, 2, 4});
  CHECK(live.run().meshes[0].block == first);
}

TEST_CASE("a restarted run has new meshes, and an incomplete frame waits") {
  const TemporaryFolder above;
  const std::string folder = above / "run";
  begin_run(folder, {"tm-evolve", "1", {}}, {});
  add_frame(folder, 0, 1);
  add_frame(folder, 1, 2);
  LiveRun live(folder);
  live.refresh(10);
  const std::string old = live.run().meshes[1].block;
  begin_run(folder, {"tm-morph", "1", {}}, {});
  write_mesh_file(folder + run_file::target, test::icosphere(2));
  add_frame(folder, 0, 5);
  live.refresh(10);
  CHECK(numbers_of(live) == std::vector<std::size_t>{0});
  CHECK(live.run().tool == "tm-morph");
  REQUIRE(live.run().targets.size() == 1);
  CHECK(live.block(live.run().targets[0].block) != nullptr);
  CHECK(live.block(old) == nullptr);
  CHECK(live.run().meshes[0].mesh.columns.at(0).low == doctest::Approx(4).epsilon(0.01));

  make_file(folder + "/frames/frame-00003.ply", "ply\nformat");
  live.refresh(10);
  CHECK(numbers_of(live) == std::vector<std::size_t>{0});
  add_frame(folder, 3, 1);
  live.refresh(10);
  CHECK(numbers_of(live) == std::vector<std::size_t>{0, 3});
}

TEST_CASE("a FIFO among the frames is left out, and holds nothing up") {
  const TemporaryFolder above;
  const std::string folder = above / "run";
  begin_run(folder, {"tm-evolve", "1", {}}, {});
  add_frame(folder, 0, 1);
  REQUIRE(mkfifo((folder + "/frames/frame-00001.ply").c_str(), 0600) == 0);
  add_frame(folder, 2, 2);
  LiveRun live(folder);
  live.refresh(10);
  CHECK(numbers_of(live) == std::vector<std::size_t>{0, 2});
}

TEST_CASE("targets and views of a movie appear with their frames") {
  const TemporaryFolder above;
  const std::string folder = above / "run";
  begin_run(folder, {"tm-morph", "1", {}}, {});
  add_frame(folder, 0, 1);
  LiveRun live(folder);
  live.refresh(10);
  CHECK(live.run().targets.empty());
  const std::string alone = live.run().meshes[0].block;

  make_folder(folder + run_file::targets);
  write_mesh_file(folder + run_name(run_file::targets, 1, ".ply"), test::icosphere(2));
  const std::vector<View> views{
      {"a", camera_ring({.count = 2}).cameras[0].camera, GrayImage{8, 6, 1}, {}}};
  add_to_run(folder, run_files_of(views, 1));
  add_frame(folder, 1, 2);
  live.refresh(10);
  CHECK(numbers_of(live) == std::vector<std::size_t>{0, 1});
  REQUIRE(live.run().targets.size() == 1);
  CHECK(live.block(live.run().targets[0].block) != nullptr);
  // The run has a target now, so that the mesh has distances from it.
  CHECK(live.run().meshes[0].block != alone);
  REQUIRE(live.run().views.size() == 1);
  CHECK(live.block("photograph-0-1-0") != nullptr);

  write_mesh_file(folder + run_name(run_file::targets, 2, ".ply"), test::icosphere(3));
  const std::string first = live.run().targets[0].block;
  add_frame(folder, 2, 3);
  live.refresh(10);
  REQUIRE(live.run().targets.size() == 2);
  CHECK(live.run().targets[0].block == first);
}

TEST_CASE("a folder that is no run is refused") {
  const TemporaryFolder above;
  CHECK_THROWS_AS(LiveRun(above / "none"), InputError);
}
