#include "evolution/loop/record.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using test::TemporaryFolder;

namespace {

Document tetrahedron_with_columns() {
  Document document;
  document.mesh = test::tetrahedron();
  document.mesh.positions[1].x() = 1.0 / 3;
  document.mesh.vertex_columns.get("heat", Scalar::float32, 4).values = {0.5, 1.25, -3, 0};
  document.style.comments = {"tm:reference-edge 0.25", "a word of the user's"};
  return document;
}

RecordOptions options_in(const TemporaryFolder& folder) {
  RecordOptions options;
  options.state = folder / "state";
  options.settings = "alpha 0.2 target 'a b.ply'";
  options.csv = folder / "log.csv";
  options.frames = folder / "frames";
  options.every = 2;
  return options;
}

LoopState with_best(double best) {
  LoopState loop_state;
  loop_state("best", best);
  return loop_state;
}

double best_of(LoopState loop_state) {
  double best = 0;
  loop_state("best", best);
  return best;
}

void run_to(Record& record, const Document& document, std::size_t last) {
  record.begin(document, "iteration,faces", with_best(1));
  for (std::size_t i = 1; i <= last; ++i)
    record.keep(document, i, std::to_string(i) + ",4", with_best(1.0 / static_cast<double>(i)));
}

}  // namespace

TEST_CASE("an interrupted run continues with its mesh, comments, columns and values") {
  const TemporaryFolder folder;
  const Document document = tetrahedron_with_columns();
  Record first(options_in(folder));
  CHECK_FALSE(first.resumed());
  first.add("target.ply", "bytes");
  run_to(first, document, 3);

  RecordOptions options = options_in(folder);
  options.resume = true;
  const Record second(options);
  REQUIRE(second.resumed());
  CHECK(second.resumed()->iteration == 3);
  CHECK(best_of(second.resumed()->loop_state) == 1.0 / 3);
  CHECK(second.find("target.ply") == "bytes");
  CHECK(write_mesh(second.resumed()->document).bytes == write_mesh(document).bytes);
}

TEST_CASE("the state of an interrupted run is neither continued nor thrown away unasked") {
  const TemporaryFolder folder;
  const Document document = tetrahedron_with_columns();
  Record first(options_in(folder));
  run_to(first, document, 1);
  CHECK_THROWS_AS(Record{options_in(folder)}, UsageError);

  RecordOptions restart = options_in(folder);
  restart.restart = true;
  Record second(restart);
  CHECK_FALSE(second.resumed());
  run_to(second, document, 2);
  // A run that reached its limit of iterations may be begun again without `restart`.
  second.pause(document, {});
  CHECK_NOTHROW(Record{options_in(folder)});
}

TEST_CASE("a run with other settings is not continued") {
  const TemporaryFolder folder;
  Record first(options_in(folder));
  run_to(first, tetrahedron_with_columns(), 1);
  RecordOptions options = options_in(folder);
  options.resume = true;
  options.settings = "alpha 0.1 target 'a b.ply'";
  CHECK_THROWS_AS(Record{options}, UsageError);
}

TEST_CASE("a run that continues has one row for each iteration, whatever was written last") {
  const TemporaryFolder folder;
  const Document document = tetrahedron_with_columns();
  Record first(options_in(folder));
  run_to(first, document, 2);
  std::ofstream(folder / "log.csv", std::ios::app) << "3,4\n4,";

  RecordOptions options = options_in(folder);
  options.resume = true;
  Record second(options);
  second.begin(document, "iteration,faces", {});
  second.keep(document, 3, "3,5", {});
  CHECK(test::content_of(folder / "log.csv") == "iteration,faces\n1,4\n2,4\n3,5\n");
}

TEST_CASE("frames are the meshes as written, every so many iterations") {
  const TemporaryFolder folder;
  const Document document = tetrahedron_with_columns();
  Record record(options_in(folder));
  run_to(record, document, 5);
  for (const char* name : {"frame-00000.ply", "frame-00002.ply", "frame-00004.ply"})
    CHECK(test::content_of(folder / ("frames/" + std::string(name))) == write_mesh(document).bytes);
  CHECK_FALSE(std::filesystem::exists(folder / "frames/frame-00003.ply"));
}

TEST_CASE("at the end nothing of the state is left, or all until the caller has its result") {
  const TemporaryFolder folder;
  Record record(options_in(folder));
  run_to(record, tetrahedron_with_columns(), 1);
  record.end();
  CHECK_FALSE(std::filesystem::exists(folder / "state"));

  RecordOptions options = options_in(folder);
  options.keep_state_at_end = true;
  Record kept(options);
  run_to(kept, tetrahedron_with_columns(), 1);
  kept.end();
  CHECK(std::filesystem::exists(folder / "state/mesh.ply"));
  kept.remove_state();
  CHECK_FALSE(std::filesystem::exists(folder / "state"));
}

TEST_CASE("a record without names leaves nothing, and a name in a missing folder is refused") {
  Record none;
  run_to(none, tetrahedron_with_columns(), 3);
  none.end();

  const TemporaryFolder folder;
  RecordOptions options;
  options.csv = folder / "absent/log.csv";
  Record refused(options);
  CHECK_THROWS_AS(run_to(refused, tetrahedron_with_columns(), 1), OutputError);
}
