#include "reconstruction/sequence.h"

#include <doctest/doctest.h>

#include "evolution/loop/record.h"
#include "helpers/photographed.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "reconstruction/time_steps.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"
#include "views/cameras/view.h"

using namespace transformesh;
using test::TemporaryFolder;

namespace {

const std::vector<TimeStep> movie{{"first/8", "8"}, {"second/9", "9"}, {"third/10", "10"}};

/// A ball that moves, and then jumps to another place.
std::vector<View> views_of(const TimeStep& step) {
  const double x = step.text == "first/8" ? 0 : step.text == "second/9" ? 0.06 : -0.9;
  return test::photographed(test::moved(test::scaled(test::icosphere(4), 0.4), Vec3(x, 0, 0.1)));
}

SequenceOptions options_in(const TemporaryFolder& folder) {
  SequenceOptions options;
  options.reconstruction.scales = {2, 4, 4};
  options.reconstruction.sweeps = 1;
  options.reconstruction.iterations = 3;
  options.track = 2;
  options.comments = {"tm-reconstruct 0.1.0"};
  options.folder = folder / "out";
  options.states = folder / "out/.state";
  return options;
}

RecordOptions kept_in(const TemporaryFolder& folder) {
  RecordOptions kept;
  kept.state = folder / "out/.state";
  kept.csv = folder / "log.csv";
  return kept;
}

SequenceResult run_of(const SequenceOptions& options, const RecordOptions& kept) {
  Document document;
  Record record(kept);
  return reconstruct_sequence(document, movie, views_of, options, record);
}

/// Returns the first four columns of each row.
std::vector<std::string> starts_in(const std::string& csv) {
  std::istringstream lines(csv);
  std::vector<std::string> starts;
  for (std::string line; std::getline(lines, line);) {
    std::size_t end = 0;
    for (int column = 0; column < 4; ++column) end = line.find(',', end + 1);
    starts.push_back(line.substr(0, end));
  }
  return starts;
}

std::string without_seconds(const std::string& csv) {
  std::istringstream lines(csv);
  std::string text;
  for (std::string line; std::getline(lines, line);) text += line.substr(0, line.rfind(',')) + '\n';
  return text;
}

}  // namespace

TEST_CASE("surfaces follow movement, jumps are found from the hull, and a run continues") {
  const TemporaryFolder whole;
  std::vector<std::string> messages;
  SequenceOptions options = options_in(whole);
  options.on_step = [&](const std::string& text) { messages.push_back(text); };
  const SequenceResult result = run_of(options, kept_in(whole));
  CHECK(result.time_steps == 3);
  CHECK(result.tracked == 1);
  CHECK(result.accepted == 3);
  const std::string csv = test::content_of(whole / "log.csv");
  CHECK(starts_in(csv) == std::vector<std::string>{"step,name,start,accepted", "1,8,hull,yes",
                                                   "2,9,before,yes", "3,10,hull,yes"});
  REQUIRE(messages.size() == 3);
  CHECK(messages[1].find("time step 2 of 3, 9, from before: ") == 0);
  CHECK_FALSE(std::filesystem::exists(whole / "out/.state"));

  // The run is interrupted after each sweep and each time step.
  const TemporaryFolder parts;
  options = options_in(parts);
  const auto power_fails = [](const std::string&) { throw CancelledError("the power fails"); };
  options.reconstruction.on_sweep = options.on_step = power_fails;
  RecordOptions kept = kept_in(parts);
  kept.resume = true;
  int runs = 1;
  for (bool is_ended = false; !is_ended && runs < 40; ++runs) {
    try {
      run_of(options, kept);
      is_ended = true;
    } catch (const CancelledError&) {
    }
  }
  CHECK(runs > 10);
  for (const auto& [text, name] : movie)
    CHECK(test::content_of(parts / ("out/" + name + ".ply")) ==
          test::content_of(whole / ("out/" + name + ".ply")));
  CHECK(without_seconds(test::content_of(parts / "log.csv")) == without_seconds(csv));
}

TEST_CASE("an interrupted time step is thrown away where the sequence is begun anew") {
  const TemporaryFolder folder;
  SequenceOptions options = options_in(folder);
  options.reconstruction.on_sweep = [](const std::string&) {
    throw CancelledError("the power fails");
  };
  CHECK_THROWS_AS(run_of(options, kept_in(folder)), CancelledError);
  CHECK(std::filesystem::exists(folder / "out/.state/hull/mesh.ply"));
  CHECK_THROWS_AS(run_of(options, kept_in(folder)), UsageError);

  // Other options: the unfinished first sweep must not be continued with them.
  RecordOptions kept = kept_in(folder);
  kept.restart = true;
  options.reconstruction.on_sweep = {};
  options.reconstruction.scales = {1, 6, 6};
  options.track = 1;
  options.format = Format::off;
  CHECK(run_of(options, kept).time_steps == 3);
  CHECK(test::content_of(folder / "out/10.off").starts_with("OFF"));
  CHECK_FALSE(std::filesystem::exists(folder / "out/.state"));
}

TEST_CASE(
    "time steps are the lines of a file, the folders in a folder, or what a pattern matches") {
  const TemporaryFolder folder;
  for (const char* name : {"movie/9", "movie/10", "movie/.git"})
    std::filesystem::create_directories(folder / name);
  std::ofstream(folder / "movie/readme") << "no folder\n";
  const auto names_at = [](const std::string& where) {
    std::string text;
    for (const TimeStep& step : time_steps(where)) text += step.name + ' ';
    return text;
  };
  CHECK(names_at(folder / "movie") == "9 10 ");
  CHECK(names_at(folder / "movie/[0-9]*") == "9 10 ");
  CHECK(time_steps(folder / "movie")[1].text == folder / "movie/10");
  std::ofstream(folder / "names") << "b/second/\n  \na/first\n";
  CHECK(names_at(folder / "names") == "second first ");
  CHECK(place_of("x/{}/{}.txt", {"a/b", "b"}) == "x/a/b/a/b.txt");

  std::ofstream(folder / "twice") << "a/first\nb/first\n";
  CHECK_THROWS_AS(time_steps(folder / "twice"), UsageError);
  std::ofstream(folder / "none") << "\n";
  CHECK_THROWS_AS(time_steps(folder / "none"), InputError);
  CHECK_THROWS_AS(time_steps(folder / "nowhere"), InputError);
}
