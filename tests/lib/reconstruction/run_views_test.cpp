#include "reconstruction/run_views.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "evolution/loop/recorded_views.h"
#include "evolution/loop/run_folder.h"
#include "helpers/temporary_folder.h"
#include "io/streams/atomic_file.h"
#include "views/cameras/camera_ring.h"
#include "views/cameras/view.h"
#include "views/images/image_file.h"

using namespace transformesh;
using test::make_file;
using test::TemporaryFolder;

namespace {

std::vector<View> views_of_a_ring() {
  std::vector<View> views;
  for (const CameraRecord& record : camera_ring({.count = 3, .width = 700, .height = 500}).cameras)
    views.push_back(
        {views.empty() ? "#1 a" : "a view", record.camera, GrayImage(700, 500, 90.0F), {}});
  views[1].image = GrayImage();
  return views;
}

}  // namespace

TEST_CASE("views of time steps are apart, and go with the run") {
  const TemporaryFolder above;
  const std::string folder = above / "run";
  const std::vector<View> views = views_of_a_ring();
  begin_run(folder, {"tm-reconstruct", "1", {}}, {});
  for (const std::size_t step : {2, 1}) add_to_run(folder, run_files_of(views, step));
  make_folder(folder + "/views/00003");
  const RunPaths found = run_views(folder);
  REQUIRE(found.size() == 2);
  CHECK(found[1] == RunPaths::value_type{2, folder + "/views/00002"});
  CHECK(read_run_views(found[1].second).size() == 3);
  CHECK_FALSE(read_run_views(found[1].second)[0].photograph.empty());
  CHECK(read_run_views(folder).empty());

  make_file(folder + "/views/00001/notes.txt", "mine");
  begin_run(folder, {"tm-reconstruct", "1", {}}, run_files_of(views));
  CHECK(run_views(folder) == RunPaths{{0, folder}});
  CHECK(std::filesystem::exists(folder + "/views/00001/notes.txt"));
  CHECK_FALSE(std::filesystem::exists(folder + "/views/00001/photographs"));
  CHECK_FALSE(std::filesystem::exists(folder + "/views/00002"));
}

TEST_CASE("views come back with their cameras, the images' sizes and small photographs") {
  const TemporaryFolder above;
  const std::string folder = above / "run";
  const std::vector<View> views = views_of_a_ring();
  begin_run(folder, {"tm-reconstruct", "1", {}}, run_files_of(views));
  make_file(folder + "/photographs/notes.txt", "mine");
  make_file(folder + "/photographs/9-9x9.png", "of no camera");

  const std::vector<RunView> read = read_run_views(folder);
  REQUIRE(read.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(read[i].camera.camera.intrinsics.isApprox(views[i].camera.intrinsics, 1e-14));
    CHECK(read[i].camera.camera.translation.isApprox(views[i].camera.translation, 1e-14));
  }
  CHECK(read[0].camera.name == "_1_a");
  CHECK(read[1].camera.name == "a_view");
  CHECK(read[2].camera.name == "a_view_2");
  CHECK(read[0].camera.width == 700);
  CHECK(read[0].camera.height == 500);
  const GrayImage small = decode_photograph(read[0].photograph, "photograph");
  CHECK(small.width == 320);
  CHECK(small.height == 228);
  CHECK(small.at(100, 100) == doctest::Approx(90).epsilon(0.01));
  CHECK(read[1].photograph.empty());
  CHECK(read[1].camera.width == 0);

  begin_run(folder, {"tm-morph", "1", {}}, {});
  CHECK(read_run_views(folder).empty());
  CHECK(std::filesystem::exists(folder + "/photographs/notes.txt"));
  CHECK_FALSE(std::filesystem::exists(folder + "/photographs/000-700x500.png"));
}
