// Tests outputs alone: files appear together and complete, or not at all.
#include "frame/outputs.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::tool;

namespace {

struct Place {
  test::TemporaryFolder folder;
  Terminal terminal{"tm-x"};
  Program program{"tm-x", "[INPUT]", "Tests", {Reads::mesh}};
  Messages messages{program, terminal};
  Phases phases;
  Inputs inputs{program, messages, phases};
  Outputs outputs{program, inputs, messages};

  Place() {
    program.common.output = folder / "out.ply";
    inputs.document().mesh = test::cube();
  }
  bool has(const std::string& name) const { return std::filesystem::exists(folder / name); }
};

}  // namespace

TEST_CASE("no file has its name before all are committed") {
  Place place;
  place.outputs.write(place.folder / "more.txt", "more\n");
  place.outputs.write_into(place.folder / "a/b", "c/d.txt", "deep\n");
  bool are_written = false;
  place.outputs.when_written([&] { are_written = place.has("out.ply") && place.has("more.txt"); });
  place.outputs.stage_all();
  CHECK(!place.has("out.ply"));
  CHECK(!place.has("more.txt"));
  place.outputs.commit();
  CHECK(are_written);
  CHECK(test::content_of(place.folder / "a/b/c/d.txt") == "deep\n");
  CHECK(std::get<std::size_t>(place.outputs.counts()[1].second) == 12);
}

TEST_CASE("two outputs of one name are refused, and no file appears") {
  Place place;
  place.outputs.write(place.folder / "same.txt", "1");
  place.outputs.write(place.folder / "same.txt", "2");
  CHECK_THROWS_AS(place.outputs.stage_all(), UsageError);
  CHECK(!place.has("same.txt"));
  CHECK(!place.has("out.ply"));
}

TEST_CASE("a mesh file takes its format from its name, and the provenance") {
  Place place;
  Document document;
  document.mesh = test::tetrahedron();
  place.outputs.write_mesh_file(place.folder / "t.off", document);
  place.outputs.write_nothing();
  place.outputs.stage_all();
  place.outputs.commit();
  CHECK(!place.has("out.ply"));
  const std::string text = test::content_of(place.folder / "t.off");
  CHECK(text.starts_with("OFF"));
  CHECK(text.find("tm-x ") != std::string::npos);
}

TEST_CASE("names that promise a format that is not written are refused") {
  Place place;
  place.program.common.output = "out.fbx";
  CHECK_THROWS_AS(place.outputs.check_name(), UsageError);
  place.program.common.format = "ply";
  CHECK_NOTHROW(place.outputs.check_name());
}

TEST_CASE("outputs kept after a failed run are written") {
  Place place;
  place.terminal.configure(true, false, false, false);
  place.outputs.write_kept();
  CHECK(!place.has("out.ply"));
  place.outputs.keep("stopped in iteration 3", "the mesh of iteration 2");
  place.outputs.write_kept();
  CHECK(place.has("out.ply"));
}
