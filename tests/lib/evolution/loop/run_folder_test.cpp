#include "evolution/loop/run_folder.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"

using namespace transformesh;
using test::content_of;
using test::make_file;
using test::TemporaryFolder;

TEST_CASE("a run is read as it was begun and continued") {
  const TemporaryFolder above;
  const std::string folder = above / "run";
  begin_run(folder, {"tm-evolve", "1.2.3", {"tm-evolve 'a b.ply'"}}, {{run_file::start, "bytes"}});
  continue_run(folder, "tm-evolve --resume");
  const RunDescription read = read_run(folder);
  CHECK(read.tool == "tm-evolve");
  CHECK(read.version == "1.2.3");
  CHECK(read.commands == std::vector<std::string>{"tm-evolve 'a b.ply'", "tm-evolve --resume"});
  CHECK(content_of(folder + run_file::start) == "bytes");
}

TEST_CASE("frames come in the order of their numbers, and other names are none") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "frames");
  for (const char* name : {"frame-00010.ply", "frame-100000.ply", "frame-00009.ply", "frame-1.png",
                           "frame-x.ply", "other.ply"})
    make_file(folder / "frames/" + name, "");
  std::vector<std::size_t> numbers;
  for (const auto& [number, path] : run_frames(folder / "")) numbers.push_back(number);
  CHECK(numbers == std::vector<std::size_t>{9, 10, 100000});
}

TEST_CASE("a new run takes the place of an old one, and of nothing else") {
  const TemporaryFolder folder;
  const std::string run = folder / "run";
  begin_run(run, {"tm-morph", "1", {"a"}}, {{run_file::target, "old"}});
  std::filesystem::create_directory(run + run_file::frames);
  make_file(run + "/frames/frame-00003.ply", "old");
  make_file(run + "/notes.txt", "mine");
  check_run_folder(run);
  begin_run(run, {"tm-morph", "1", {"b"}}, {});
  CHECK(run_frames(run).empty());
  CHECK_FALSE(std::filesystem::exists(run + run_file::target));
  CHECK(content_of(run + "/notes.txt") == "mine");
}

TEST_CASE("folders that are no run are neither read nor overwritten") {
  const TemporaryFolder folder;
  check_run_folder(folder / "new");
  check_run_folder(folder / "");
  CHECK_THROWS_AS(read_run(folder / ""), InputError);
  make_file(folder / "result.ply.tm-morph", "");
  make_file(folder / ".run.json.27996-0.tmp", "");  // a run was killed while it wrote run.json
  check_run_folder(folder / "");
  make_file(folder / "result.ply", "somebody's");
  CHECK_THROWS_AS(check_run_folder(folder / ""), UsageError);
  for (const char* text :
       {"", "{", "[]", "{}", "{\"layout\": 1, \"tool\": 3}",
        "{\"layout\": 2, \"tool\": \"x\", \"version\": \"\", \"commands\": []}"}) {
    CAPTURE(text);
    make_file(folder / "run.json", text);
    CHECK_THROWS_AS(read_run(folder / ""), InputError);
  }
}
