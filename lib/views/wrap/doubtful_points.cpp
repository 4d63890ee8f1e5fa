#include "views/wrap/doubtful_points.h"

#include <algorithm>
#include <initializer_list>

namespace transformesh {
namespace {

/// A point is accepted if its reprojection error is at most this multiple of the median error; the
/// reason is given at with_large_error().
constexpr double most_error_by_median = 3;
/// A point is accepted if at least this number of photographs observe it; the reason is given at
/// with_short_track().
constexpr double least_track = 3;
/// No points are rejected for their number of photographs if less than this fraction of the points
/// would be left.
constexpr double least_left = 0.5;

/// Returns the values of a column, or the lengths of its lists if it is a list column.
std::vector<double> numbers_of(const Column& column) {
  if (!column.list_count_type) return column.values;
  std::vector<double> lengths;
  for (std::size_t i = 0; i + 1 < column.list_offsets.size(); ++i)
    lengths.push_back(static_cast<double>(column.list_offsets[i + 1] - column.list_offsets[i]));
  return lengths;
}

std::vector<double> column_of(const Columns& columns, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const Column* column = columns.find(name)) return numbers_of(*column);
  return {};
}

}  // namespace

std::vector<Index> with_large_error(const std::vector<double>& errors) {
  std::vector<Index> points;
  if (errors.empty()) return points;
  std::vector<double> sorted = errors;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  for (Index i = 0; i < errors.size(); ++i)
    if (*middle > 0 && errors[i] > most_error_by_median * *middle) points.push_back(i);
  return points;
}

std::vector<Index> with_short_track(const std::vector<double>& lengths) {
  std::vector<Index> points;
  for (Index i = 0; i < lengths.size(); ++i)
    if (lengths[i] < least_track) points.push_back(i);
  const double left = static_cast<double>(lengths.size() - points.size());
  if (left < least_left * static_cast<double>(lengths.size())) points.clear();
  return points;
}

std::vector<double> reprojection_errors(const Columns& columns) {
  return column_of(columns, {"error", "reprojection_error", "mean_reprojection_error"});
}

std::vector<double> track_lengths(const Columns& columns) {
  return column_of(columns, {"track_length", "track", "views", "num_views", "observations"});
}

}  // namespace transformesh
