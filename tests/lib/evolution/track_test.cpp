#include <doctest/doctest.h>

#include "evolution/loop/record.h"
#include "evolution/loop/stages.h"
#include "evolution/recorded_loops.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"
#include "transformesh/morph.h"

using namespace transformesh;
using test::TemporaryFolder;

namespace {

/// Frames of two balls that approach, merge and separate again.
Target balls(std::size_t frame) {
  const double apart[] = {0.4, 0.2, -0.3, -0.3, 0.2, 0.4};
  Document both;
  both.mesh = test::joined(test::icosphere(3),
                           test::moved(test::icosphere(3), Vec3(2 + apart[frame], 0, 0)));
  clean_in_place(both);
  return make_target(both.mesh);
}

const std::vector<std::string> names{"a", "b", "c", "d", "e", "f"};

Document start() {
  Document document;
  document.mesh = balls(0).mesh;
  return document;
}

TrackResult tracked(Document& document, Record& record,
                    const std::function<void(const std::string&)>& on_frame = {}) {
  return track(document, names, balls, {}, {.on_iteration = on_frame}, record);
}

}  // namespace

TEST_CASE("a movie is followed through merges and splits, with edges of one length") {
  Document document = start();
  const double first = edge_lengths(document.mesh).mean;
  Record none;
  std::vector<std::string> messages;
  const TrackResult result =
      tracked(document, none, [&](const std::string& text) { messages.push_back(text); });
  CHECK(result.frames == names.size());
  CHECK(result.converged == names.size());
  REQUIRE(messages.size() == names.size());
  CHECK(messages[0].find("frame 1 of 6, a: converged") == 0);
  CHECK(messages[2].find("1 component") != std::string::npos);
  CHECK(messages[5].find("2 components") != std::string::npos);
  CHECK(edge_lengths(document.mesh).mean == doctest::Approx(first).epsilon(0.05));
}

TEST_CASE("a sequence that was ended continues to the same bytes") {
  Document whole = start();
  Record none;
  tracked(whole, none);

  const TemporaryFolder folder;
  RecordOptions kept;
  kept.state = folder / "state";
  kept.csv = folder / "log.csv";
  int calls = 0;
  Record first(kept);
  Document parts = start();
  const auto fail_later = [&](const std::string&) {
    if (++calls == 3) throw std::runtime_error("the power fails");
  };
  CHECK_THROWS(tracked(parts, first, fail_later));

  kept.resume = true;
  Record second(kept);
  Document continued = start();
  CHECK(tracked(continued, second).converged == names.size());
  CHECK(write_mesh(continued).bytes == write_mesh(whole).bytes);
  const std::string csv = test::content_of(folder / "log.csv");
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 7);
}
