#include "views/hull/view_check.h"

#include <doctest/doctest.h>

#include <string>

#include "helpers/intensities.h"
#include "helpers/view_maker.h"
#include "io/streams/source.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/hull_values.h"
#include "views/hull/silhouette.h"

using namespace transformesh;
using namespace view_maker;

namespace {

constexpr Frame frame{128, 96, 300};

std::string name_of(std::size_t i) { return std::string(1, 'v').append(std::to_string(i)); }

/// Three balls, so that no two views are alike, seen from unevenly spaced eyes.
std::vector<View> right_views() {
  std::vector<View> views;
  for (int i = 0; i < 10; ++i) {
    const double azimuth = 0.63 * i + 0.2 * (i % 3);
    const Vec3 eye = 500 * Vec3(std::cos(azimuth), std::sin(azimuth), 0.5 * (i % 4) - 0.6);
    const auto first = ball_contour(eye, Vec3::Zero(), 45);
    const auto second = ball_contour(eye, {55, 25, 20}, 28);
    const auto third = ball_contour(eye, {-20, -50, 40}, 20);
    View view = view_of(camera_at(eye, frame), frame, [&](const Vec3& ray) {
      return std::min({first(ray), second(ray), third(ray)});
    });
    view.name = name_of(static_cast<std::size_t>(i));
    views.push_back(std::move(view));
  }
  return views;
}

double least_agreement(const std::vector<View>& views) {
  const Mesh hull = visual_hull(views, {.resolution = 64, .keep = 0}).mesh;
  const std::vector<double> agreements = silhouette_agreements(hull, views);
  return *std::min_element(agreements.begin(), agreements.end());
}

std::string problem_of(std::vector<View> views) {
  try {
    check_views(views);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void invert(View& view) {
  test::change_intensities(view.silhouette, [](float intensity) { return 255 - intensity; });
}

/// Moves the object to another place in the picture.
void move(View& view) {
  const GrayImage before = view.silhouette;
  for (int y = 0; y < before.height; ++y)
    for (int x = 0; x < before.width; ++x)
      view.silhouette.at(x, y) = x < 30 ? 0 : before.at(x - 30, y);
}

}  // namespace

TEST_CASE("the agreement is that of the silhouettes with those of the hull") {
  std::vector<View> views = right_views();
  const ViewCheck check = check_views(views);
  CHECK(check.dropped.empty());
  CHECK(views.size() == 10);
  CHECK(check.least_agreement == doctest::Approx(least_agreement(views)).epsilon(0.01));
  CHECK(check.least_agreement > 0.95);
}

TEST_CASE("two cameras that are swapped are named, unless all views agree nevertheless") {
  std::size_t named = 0;
  for (std::size_t i = 0; i < 10; i += 3) {
    for (std::size_t j = i + 1; j < 10; j += 4) {
      std::vector<View> views = right_views();
      std::swap(views[i].camera, views[j].camera);
      const std::string problem = problem_of(views);
      CAPTURE(problem);
      if (problem.empty()) {
        CHECK(least_agreement(views) > 0.68);
        continue;
      }
      CHECK(has(problem, in_quotes(name_of(i)) + " and " + in_quotes(name_of(j))));
      CHECK(has(problem, "swapped"));
      ++named;
    }
  }
  CHECK(named >= 4);
}

TEST_CASE("inverted masks, one and all") {
  std::vector<View> views = right_views();
  invert(views[4]);
  CHECK(has(problem_of(views), "the mask of 'v4' looks inverted"));
  for (View& view : views) invert(view);
  invert(views[4]);
  CHECK(has(problem_of(views), "all masks look inverted"));
}

TEST_CASE("silhouettes shifted by one") {
  const std::vector<View> right = right_views();
  std::vector<View> views = right;
  for (std::size_t i = 0; i < 10; ++i) views[i].silhouette = right[(i + 1) % 10].silhouette;
  CHECK(has(problem_of(views), "that of 'v0' fits the camera of 'v1'"));
  for (std::size_t i = 0; i < 10; ++i) views[i].silhouette = right[(i + 9) % 10].silhouette;
  CHECK(has(problem_of(views), "that of 'v1' fits the camera of 'v0'"));
}

TEST_CASE("a world that is left-handed, and cameras that look along -z") {
  std::vector<View> views = right_views();
  for (View& view : views) view.camera = view.camera.mirrored();
  CHECK(has(problem_of(views), "behind every camera"));
  for (View& view : views) view.camera = view.camera.mirrored();
  CHECK(problem_of(views).empty());
  for (View& view : views) {
    view.camera.rotation.bottomRows<2>() *= -1;
    view.camera.translation.tail<2>() *= -1;
  }
  CHECK(has(problem_of(views), "OpenGL"));
}

TEST_CASE("views that disagree are named, or left out") {
  std::vector<View> views = right_views();
  move(views[2]);
  move(views[7]);
  const std::string problem = problem_of(views);
  CAPTURE(problem);
  CHECK(has(problem, "'v2' and 'v7' disagree with the others"));
  const ViewCheck check = check_views(views, {.drops_bad_views = true});
  REQUIRE(check.dropped.size() == 2);
  CHECK(check.dropped[0].name == "v2");
  CHECK(check.dropped[1].name == "v7");
  CHECK(check.dropped[0].agreement < 0.7);
  CHECK(check.least_agreement > 0.95);
  REQUIRE(views.size() == 8);
  CHECK(views[2].name == "v3");
}

TEST_CASE("views are trusted if requested, and if there is nothing to compare") {
  std::vector<View> views = right_views();
  move(views[2]);
  CHECK(check_views(views, {.least_agreement = 0}).dropped.empty());
  std::vector<View> single(views.begin() + 2, views.begin() + 3);
  CHECK(check_views(single).dropped.empty());
  for (View& view : views) view.silhouette = GrayImage();
  CHECK(check_views(views).dropped.empty());
  CHECK_THROWS_AS(check_views(views, {.least_agreement = 2}), UsageError);
}

TEST_CASE("the message is the same for any number of threads") {
  std::vector<View> views = right_views();
  move(views[2]);
  const std::string problem = problem_of(views);
  const ThreadLimit limit(1);
  CHECK(problem_of(views) == problem);
}
