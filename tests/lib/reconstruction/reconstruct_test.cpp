#include "transformesh/reconstruct.h"

#include <doctest/doctest.h>

#include "evolution/loop/record.h"
#include "helpers/photographed.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "reconstruction/initial_mesh.h"
#include "reconstruction/recorded_reconstruction.h"
#include "support/parallel.h"
#include "transformesh/compare.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "transformesh/manifold.h"
#include "transformesh/mesh_io.h"
#include "views/cameras/view.h"
#include "views/hull/silhouette.h"

using namespace transformesh;
using test::TemporaryFolder;

namespace {

/// A ball with a dent that no silhouette shows.
Mesh dented_ball() {
  Mesh mesh = test::icosphere(5);
  for (Vec3& p : mesh.positions)
    p *= 1 - 0.3 * std::exp(-12 * (p - Vec3(0.97, 0.17, 0.17)).squaredNorm());
  return mesh;
}

const std::vector<View>& dented_views() {
  static const std::vector<View> views = test::photographed(dented_ball());
  return views;
}

ReconstructionOptions few_sweeps() {
  ReconstructionOptions options;
  options.scales = {2, 4, 4};
  options.sweeps = 2;
  options.iterations = 3;
  return options;
}

struct Run {
  Document document;
  ReconstructionResult result;
  std::vector<View> views;
};

Run run_of(const ReconstructionOptions& options, Document start = {},
           std::vector<View> views = dented_views(), RecordOptions kept = {}) {
  Run run{std::move(start), {}, std::move(views)};
  Record record(std::move(kept));
  run.result = reconstruct(run.document, run.views, options, record);
  return run;
}

double largest_distance(const Mesh& mesh) {
  return compare(mesh, dented_ball(), {.samples = 5000}).hausdorff;
}

Document ball_of(double radius, const Vec3& center = Vec3::Zero()) {
  Document document;
  document.mesh = test::moved(test::scaled(test::icosphere(3), radius), center);
  return document;
}

ReconstructionOptions from_given(ReconstructionOptions options) {
  options.initial.is_given = true;
  options.initial.name = "start.ply";
  return options;
}

}  // namespace

TEST_CASE("a dent that the hull does not show is found; the surface is closed") {
  std::vector<View> views = dented_views();
  const Mesh hull = hull_of(views, {}, 0.1);
  std::vector<std::string> messages;
  ReconstructionOptions options = few_sweeps();
  options.on_sweep = [&](const std::string& text) { messages.push_back(text); };
  const Run run = run_of(options);
  const ManifoldReport found = check_manifold(run.document.mesh);
  CHECK((found.is_manifold() && found.is_closed() && found.is_oriented()));
  CHECK(largest_distance(run.document.mesh) < 0.4 * largest_distance(hull));
  CHECK(run.result.last.dissimilarity < 0.75 * run.result.first.dissimilarity);
  CHECK(run.result.topology == Topology{1, 0});
  CHECK(messages.size() == run.result.sweeps);
  CHECK(messages[0].find("sweep 1, scale 2.00: ") == 0);
  CHECK(summary_of(run.result).find("components 1, genus 0; dissimilarity from ") !=
        std::string::npos);
  // The last, robust sweeps still approach the true surface, although the mean agreement of windows
  // decreases slightly.
  options.robust = 0;
  const Run plain = run_of(options);
  CHECK(plain.result.last.dissimilarity < 0.7 * plain.result.first.dissimilarity);
  CHECK(largest_distance(run.document.mesh) < largest_distance(plain.document.mesh));
}

TEST_CASE("a run that was ended continues to the same bytes, from any sweep") {
  ReconstructionOptions options = few_sweeps();
  const std::string whole = write_mesh(run_of(options).document).bytes;
  // Without masks, the outlines of the hull must be found again if a run continues.
  const std::string outlined =
      write_mesh(run_of(options, {}, test::without_masks(dented_views())).document).bytes;
  CHECK(outlined != whole);
  for (const bool has_masks : {true, false}) {
    const std::vector<View> views =
        has_masks ? dented_views() : test::without_masks(dented_views());
    const TemporaryFolder folder;
    RecordOptions kept;
    kept.state = folder / "state";
    kept.csv = folder / "log.csv";
    kept.resume = true;
    options.on_sweep = [](const std::string&) { throw CancelledError("the power fails"); };
    std::size_t sweeps = 0;
    Run run{{}, {}, views};
    for (bool is_ended = false; !is_ended && sweeps < 20; ++sweeps) {
      try {
        run = run_of(options, {}, views, kept);
        is_ended = true;
      } catch (const CancelledError&) {
      }
    }
    CHECK(write_mesh(run.document).bytes == (has_masks ? whole : outlined));
    CHECK(run.result.sweeps == sweeps - 1);
    CHECK_FALSE(std::filesystem::exists(folder / "state"));
    const std::string csv = test::content_of(folder / "log.csv");
    CHECK(std::count(csv.begin(), csv.end(), '\n') == static_cast<std::ptrdiff_t>(sweeps));
  }
}

TEST_CASE("the result does not depend on the number of threads") {
  ReconstructionOptions options = few_sweeps();
  options.scales = {1, 5, 5};
  options.sweeps = 1;
  const std::string many = write_mesh(run_of(options).document).bytes;
  const ThreadLimit limit(1);
  CHECK(write_mesh(run_of(options).document).bytes == many);
}

TEST_CASE("an initial mesh is clipped by the hull of exact masks, and only by that") {
  const auto outside = [](const ReconstructionOptions& options) {
    const TemporaryFolder folder;
    RecordOptions kept;
    kept.csv = folder / "log.csv";
    run_of(from_given(options), ball_of(1.3), dented_views(), kept);
    std::string row = test::content_of(kept.csv);
    row = row.substr(row.find('\n') + 1);
    for (int column = 1; column < 12; ++column) row = row.substr(row.find(',') + 1);
    return std::stoi(row);
  };
  ReconstructionOptions options = few_sweeps();
  options.scales = {4, 3, 3};
  options.sweeps = 1;
  options.iterations = 1;
  CHECK(outside(options) < 10);
  options.initial.clips_by_hull = false;
  CHECK(outside(options) > 50);
  // Masks that show only a part of the object do not clip the mesh, and no vertex counts as outside
  // of them.
  options.initial.clips_by_hull = true;
  options.initial.meaning = SilhouetteMeaning::least;
  std::vector<View> views = dented_views();
  Document whole = ball_of(1.3);
  make_initial_mesh(whole, views, from_given(options).initial, 0.03);
  CHECK(whole.mesh.faces.size() == ball_of(1).mesh.faces.size());
}

TEST_CASE("an initial mesh of which nothing is within the hull is refused, and leaves no state") {
  const TemporaryFolder folder;
  RecordOptions kept;
  kept.state = folder / "state";
  const Document elsewhere = ball_of(0.1, Vec3(20, 0, 0));
  CHECK_THROWS_WITH_AS(run_of(from_given(few_sweeps()), elsewhere, dented_views(), kept),
                       "'start.ply' lies outside the hull of the silhouettes", GoalError);
  CHECK(folder.is_empty());
}

TEST_CASE("with a start, outlines come from a threshold that is given, and from nothing else") {
  ReconstructionOptions options = from_given(few_sweeps());
  for (const bool is_given : {false, true}) {
    std::vector<View> views = test::without_masks(dented_views());
    Document document = ball_of(1.1);
    if (is_given) options.initial.threshold = ThresholdOptions();
    const auto outlined = make_initial_mesh(document, views, options.initial, 0.03).outlined;
    CHECK(outlined.has_value() == is_given);
    CHECK(views[0].silhouette.empty() != is_given);
    if (outlined) outline(views, *outlined);
    const GrayImage silhouette = views[0].silhouette.unpacked();
    for (const float intensity : silhouette.pixels) CHECK((intensity == 0 || intensity == 255));
  }
}

TEST_CASE("a first scale at which the surface vanishes is skipped, unless requested") {
  // A ball of a few pixels, between edges that are longer than its diameter.
  const std::vector<View> views = test::photographed(test::scaled(test::icosphere(4), 0.2));
  ReconstructionOptions options = few_sweeps();
  options.scales = {};
  options.sweeps = 1;
  options.iterations = 1;
  std::vector<std::string> details;
  options.on_detail = [&](const std::string& text) { details.push_back(text); };
  const Run run = run_of(options, {}, views);
  CHECK(run.result.topology == Topology{1, 0});
  REQUIRE_FALSE(details.empty());
  CHECK(details[0] ==
        "scale 4.0000 is too coarse for this surface: restarting at the next finer scale");

  options.scales.coarsest = 4;
  CHECK_THROWS_AS(run_of(options, {}, views), std::runtime_error);
}

TEST_CASE("comments of the document are those of the result, and its columns are carried") {
  Document start = ball_of(1.1);
  start.style.comments = {"made by hand"};
  start.style.coordinate = Scalar::float32;
  start.mesh.vertex_columns.get("heat", Scalar::float32, start.mesh.positions.size());
  ReconstructionOptions options = from_given(few_sweeps());
  options.scales = {2, 6, 6};
  options.sweeps = 1;
  options.iterations = 1;
  options.initial.clips_by_hull = false;
  const Document result = run_of(options, start).document;
  CHECK(result.style.comments == start.style.comments);
  CHECK(result.style.coordinate == Scalar::float32);
  CHECK(result.mesh.vertex_columns.find("heat") != nullptr);
}

TEST_CASE("a surface that explodes is restarted, stiffer, and replaced by the hull at last") {
  // The photographs show other sides, and nothing keeps the surface in place.
  std::vector<View> views = dented_views();
  std::vector<GrayImage> images;
  for (const View& view : views) images.push_back(view.image);
  for (std::size_t v = 0; v < views.size(); ++v) views[v].image = images[(v + 3) % views.size()];
  ReconstructionOptions options;
  options.scales = {4, 3, 3};
  options.iterations = 30;
  options.pull = 0;
  options.step.stiffness = 1e-4;
  options.sweeps = 6;
  std::vector<std::string> notes;
  options.on_note = [&](const std::string& text) { notes.push_back(text); };
  const Run run = run_of(options, {}, views);
  REQUIRE(notes.size() == 3);
  CHECK(notes[0].find("the surface explodes at scale ") == 0);
  CHECK(notes[0].find("restarting with 4 times the stiffness") != std::string::npos);
  CHECK(notes[1].find("restarting with 16 times the stiffness") != std::string::npos);
  CHECK(notes[2].find("the initial mesh is kept: the surface explodes at scale ") == 0);
  CHECK(run.result.fault == run.result.kept);
  CHECK(run.result.restored == 1);
  CHECK(run.result.last.pixels == run.result.first.pixels);
  CHECK(run.result.topology.components == 1);
}

TEST_CASE("components that are small relative to the largest are removed at the end") {
  Mesh mesh = test::moved(test::scaled(test::icosphere(4), 0.6), Vec3(0, -0.3, 0));
  const Mesh moon = test::moved(test::scaled(test::icosphere(4), 0.25), Vec3(0, 0.75, 0));
  const auto offset = static_cast<Index>(mesh.positions.size());
  for (const Vec3& p : moon.positions) mesh.positions.push_back(p);
  for (const auto& [a, b, c] : moon.faces)
    mesh.faces.push_back({a + offset, b + offset, c + offset});
  const std::vector<View> views = test::photographed(mesh);
  ReconstructionOptions options = few_sweeps();
  options.initial.keep = 0;
  options.sweeps = 1;
  for (const double crumbs : {0.0, 0.2}) {
    options.crumbs = crumbs;
    const Run run = run_of(options, {}, views);
    CHECK(run.result.topology.components == (crumbs > 0 ? 1 : 2));
    CHECK(run.result.crumbs == (crumbs > 0 ? 1 : 0));
    CHECK(run.result.faces == run.document.mesh.faces.size());
  }
}

TEST_CASE("the result says where photographs disagree, and does not converge where they do") {
  ReconstructionOptions options = few_sweeps();
  const Run good = run_of(options);
  const Column* doubt = good.document.mesh.vertex_columns.find("doubt");
  REQUIRE(doubt != nullptr);
  CHECK(doubt->values.size() == good.document.mesh.positions.size());
  // The stiffness is too large for the dent.
  options.scales.coarsest = 1;
  options.step.stiffness = 1e6;
  const Run stiff = run_of(options);
  CHECK(stiff.result.doubtful > good.result.doubtful);
  CHECK(stiff.result.disagreement > good.result.disagreement);
  CHECK_FALSE(stiff.result.fault.empty());
}

TEST_CASE("an accurate start is returned as it is, a rough one is not") {
  Document start;
  start.mesh = dented_ball();
  std::vector<std::string> notes;
  ReconstructionOptions options = from_given({});
  options.sweeps = 2;
  options.iterations = 3;
  options.on_note = [&](const std::string& text) { notes.push_back(text); };
  const Run accurate = run_of(options, start);
  CHECK_FALSE(accurate.result.kept.empty());
  REQUIRE(notes.size() == 1);
  CHECK(notes[0] == "the initial mesh is kept: " + accurate.result.kept);
  CHECK(accurate.result.restored == 1);
  CHECK(accurate.result.last.dissimilarity == accurate.result.first.dissimilarity);
  CHECK(largest_distance(accurate.document.mesh) < 1e-12);
  CHECK(accurate.result.faces == start.mesh.faces.size());
  CHECK(summary_of(accurate.result).find("; the initial mesh is kept") != std::string::npos);

  const Document ball = ball_of(1.1);
  options.initial.clips_by_hull = false;
  const Run rough = run_of(options, ball);
  CHECK(rough.result.kept.empty());
  CHECK(rough.result.last.dissimilarity < rough.result.first.dissimilarity);
  CHECK(rough.result.restored < 0.9);
  CHECK(largest_distance(rough.document.mesh) < 0.6 * largest_distance(ball.mesh));
}

TEST_CASE("a run from a start that was ended continues to the same bytes") {
  // The start is larger than the masks, so it is clipped.
  const Document ball = ball_of(1.1);
  ReconstructionOptions options = from_given({});
  options.sweeps = 1;
  options.iterations = 2;
  const std::string whole = write_mesh(run_of(options, ball).document).bytes;
  const TemporaryFolder folder;
  RecordOptions kept;
  kept.state = folder / "state";
  kept.resume = true;
  options.on_sweep = [](const std::string&) { throw CancelledError("the power fails"); };
  CHECK_THROWS_AS(run_of(options, ball, dented_views(), kept), CancelledError);
  options.on_sweep = {};
  CHECK(write_mesh(run_of(options, ball, dented_views(), kept).document).bytes == whole);
}
