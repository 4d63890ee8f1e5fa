#include "reconstruction/convergence.h"

#include <doctest/doctest.h>

using namespace transformesh;

TEST_CASE("lost surface is reported before movement, and movement before late changes") {
  const SurfaceEvidence good;
  CHECK(ReconstructionFaults{0, 0, true}.in_words(good).empty());
  CHECK(ReconstructionFaults{1.4142, 1, false}.in_words(good).find(
            "after scale 1.4142 than before") != std::string::npos);
  CHECK(ReconstructionFaults{0, 1, false}.in_words(good) ==
        "the surface still moved in the last sweep");
  CHECK(ReconstructionFaults{0, 1, true}.in_words(good).find("vanished at scale 1.0000") !=
        std::string::npos);
  CHECK(ReconstructionFaults{1, 1, false, 2}.in_words(good).find(
            "the surface explodes at scale 2.0000: ") == 0);
}

TEST_CASE("a surface at rest is not converged if masks or photographs disagree with it") {
  const ReconstructionFaults at_rest{0, 0, true};
  CHECK(at_rest.in_words({0.946, 0.942, {}}).empty());
  CHECK(
      at_rest.in_words({0.946, 0.902, {}}) ==
      "the overlap of outline and silhouettes is 0.902, less than that of the initial mesh, 0.946");
  SurfaceEvidence evidence;
  evidence.doubt.disagreement = 0.17;
  evidence.doubt.share = 0.029;
  evidence.doubt.places = {{{1, 2, 3}, 400, false}, {{4, 5, 60000}, 30, false}};
  evidence.doubt.small_window_places = {{{5, 6, 7}, 300}};
  evidence.doubt.small_window_share = 0.014;
  CHECK(at_rest.in_words(evidence).empty());
  evidence.doubt.filled_hollows = {{{4, 5, 6}, 60}};
  CHECK(at_rest.in_words(evidence) ==
        "photographs agree better if the surface is deeper around 4,5,6 (60 square pixels), "
        "perhaps because it fills a hole");
  evidence.doubt.small_window_share = 0.016;
  CHECK(at_rest.in_words(evidence) ==
        "small windows of photographs disagree on 1.6 % of the surface, most around 5,6,7 (300 "
        "square pixels)");
  evidence.doubt.share = 0.031;
  CHECK(at_rest.in_words(evidence) ==
        "photographs disagree on 3.1 % of the surface, most around 1,2,3 (400 square pixels)");
  evidence.doubt.hidden_places = {{{1, 2, 3}, 90}};
  evidence.doubt.hidden_share = 0.0049;
  CHECK(at_rest.in_words(evidence).find("photographs disagree on 3.1 %") == 0);
  evidence.doubt.hidden_share = 0.0051;
  CHECK(at_rest.in_words(evidence) ==
        "other parts of the surface hide 0.5 % of the surface from photographs, most around 1,2,3 "
        "(90 square pixels)");
  evidence.doubt.unobserved_fins = {{{7, 8, 9}, 50}};
  CHECK(at_rest.in_words(evidence) ==
        "fewer than two photographs show a thin sheet or fin around 7,8,9 (50 square pixels)");
  evidence.doubt.places[1].is_thin = true;
  CHECK(at_rest.in_words(evidence) ==
        "photographs disagree on a thin sheet or fin around 4,5,6e+04 (30 square pixels, thin)");
  evidence.doubt.places[0].has_handle = true;
  CHECK(at_rest.in_words(evidence) ==
        "photographs disagree all around a handle or tunnel at 1,2,3 (400 square pixels, with a "
        "handle)");
  evidence.doubt.disagreement = 0.19;
  CHECK(at_rest.in_words(evidence) ==
        "photographs disagree by 0.19 beyond their noise, on a scale from 0 to 1; at most 0.18 is "
        "accepted");
}
