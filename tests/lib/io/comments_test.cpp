#include "io/comments.h"

#include <doctest/doctest.h>

#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("the last twenty provenance lines stay, and all other comments") {
  std::vector<std::string> comments = {"made by hand", "tm-shape 0.1.0 sphere",
                                       "tm:reference-edge 1"};
  for (int i = 0; i < 25; ++i) {
    add_provenance(comments, "tm-clean 0.1.0 --level " + std::to_string(i));
  }
  CHECK(comments.size() == 22);
  CHECK(comments[0] == "made by hand");
  CHECK(comments[1] == "tm:reference-edge 1");
  CHECK(comments[2] == "tm-clean 0.1.0 --level 5");
  CHECK(comments.back() == "tm-clean 0.1.0 --level 24");
}

TEST_CASE("comments that only look like provenance stay") {
  std::vector<std::string> comments = {"tm-notes about this", "tm-x 1.2", "tm-x 1.2.x"};
  for (int i = 0; i < 30; ++i) add_provenance(comments, "tm-clean 0.1.0");
  CHECK(comments.size() == 23);
  CHECK(comments[2] == "tm-x 1.2.x");
}

TEST_CASE("reference edges that are no lengths are dropped") {
  std::vector<std::string> comments = {"tm:reference-edge nan", "a", "tm:reference-edge 1",
                                       "tm:reference-edge -2", "tm:reference-edge"};
  CHECK(drop_bad_reference_edges(comments) == 3);
  CHECK(comments == std::vector<std::string>{"a", "tm:reference-edge 1"});
}

TEST_CASE("the reference edge is read, replaced and checked") {
  std::vector<std::string> comments = {"tm:reference-edge 0.5", "a", "tm:reference-edge 0.25"};
  CHECK(reference_edge_of(comments) == 0.25);
  set_reference_edge(comments, 0.1);
  CHECK(comments == std::vector<std::string>{"tm:reference-edge 0.1", "a"});
  CHECK(reference_edge_of({"tm:reference-edges 1"}) == std::nullopt);
  comments.clear();
  set_reference_edge(comments, 2);
  CHECK(comments == std::vector<std::string>{"tm:reference-edge 2"});
  for (const char* bad : {"", " ", " 0", " -1", " nan", " inf", " 1 m", " one"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(reference_edge_of({std::string("tm:reference-edge") + bad}), InputError);
  }
}

TEST_CASE("movements of flat faces add up, the largest first") {
  std::vector<std::string> comments = {"a"};
  add_planarity(comments, 0);
  CHECK(comments == std::vector<std::string>{"a"});
  add_planarity(comments, 0.25);
  CHECK(comments == std::vector<std::string>{"a", "tm:planarity 0.25"});
  comments = {"tm:planarity 0.25", "tm:planarity 2", "tm:planarity nan", "tm:planarity-x"};
  CHECK(planarity_of(comments) == 2);
  add_planarity(comments, 0.5);
  CHECK(comments == std::vector<std::string>{"tm:planarity-x", "tm:planarity 2.5"});
}

TEST_CASE("both lengths are scaled, and nothing else") {
  std::vector<std::string> comments = {"tm:reference-edge 0.5", "a", "tm:planarity 0.25"};
  scale_lengths(comments, 2);
  CHECK(comments == std::vector<std::string>{"tm:reference-edge 1", "a", "tm:planarity 0.5"});
  comments = {"a"};
  scale_lengths(comments, 2);
  CHECK(comments == std::vector<std::string>{"a"});
}
