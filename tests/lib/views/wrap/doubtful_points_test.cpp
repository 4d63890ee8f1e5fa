#include "views/wrap/doubtful_points.h"

#include <doctest/doctest.h>

using namespace transformesh;

TEST_CASE("points with more than three times the median error are doubtful") {
  CHECK(with_large_error({}).empty());
  CHECK(with_large_error({1, 1, 1, 2.9, 3.1}) == std::vector<Index>{4});
  CHECK(with_large_error({0, 0, 0, 5}).empty());
}

TEST_CASE("points of two photographs are doubtful if most points have more") {
  CHECK(with_short_track({}).empty());
  CHECK(with_short_track({2, 3, 5, 2}) == std::vector<Index>{0, 3});
  CHECK(with_short_track({2, 2, 5, 2}).empty());
}

TEST_CASE("columns are found by the names of programs, and lists count by their lengths") {
  Columns columns;
  columns.get("reprojection_error", Scalar::float32, 2).values = {1, 2};
  Column& track = columns.get("track", Scalar::int32, 2);
  track.values = {7, 8, 9, 7, 8};
  track.list_count_type = Scalar::uint8;
  track.list_offsets = {0, 3, 5};
  CHECK(reprojection_errors(columns) == std::vector<double>{1, 2});
  CHECK(track_lengths(columns) == std::vector<double>{3, 2});
  CHECK(reprojection_errors({}).empty());
}
