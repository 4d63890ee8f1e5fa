#include "transformesh/errors.h"

#include <array>

#include "support/error_prefix.h"

namespace transformesh {
namespace {

/// Names of the error kinds, in the order of the enumerators of ErrorKind. The test
/// tests/tools/errors.bats checks this order.
constexpr std::array kind_names{"other",
                                "not_closed",
                                "not_joined",
                                "not_oriented",
                                "not_orientable",
                                "overlapping_sheets",
                                "one_sided",
                                "not_manifold",
                                "self_intersections",
                                "inside_out",
                                "double_sided",
                                "double_sided_sheet",
                                "canceling_faces",
                                "no_area",
                                "no_positive_winding",
                                "no_such_level",
                                "component_too_small",
                                "surface_vanished",
                                "thinner_than_rounding",
                                "float_rounding_failed",
                                "double_rounding_failed",
                                "coordinates_too_large",
                                "needs_cleaning",
                                "box_in_open_mesh",
                                "static_test_of_open_mesh",
                                "decimation_stuck",
                                "meets_keep_out",
                                "bad_reference_edge",
                                "unknown_format",
                                "no_velocity",
                                "no_source_points",
                                "no_segments",
                                "no_color_property",
                                "texture_too_small",
                                "target_open",
                                "target_not_solid",
                                "source_apart",
                                "edges_too_long",
                                "uniform_edges_too_long",
                                "outside_hull",
                                "scene_behind_cameras",
                                "views_disagree",
                                "few_views_disagree",
                                "bad_state",
                                "other_settings",
                                "interrupted_run",
                                "not_a_run"};
static_assert(kind_names.size() == static_cast<std::size_t>(ErrorKind::not_a_run) + 1);

template <typename Kind>
[[noreturn]] void throw_prefixed(const std::string& prefix, const Kind& error) {
  throw Kind(prefixed(prefix, error.problem()));
}

}  // namespace

const char* name_of(ErrorKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

Problem prefixed(const std::string& prefix, Problem problem) {
  problem.sentence.insert(0, prefix);
  return problem;
}

Error::Error(ErrorKind kind, const std::string& sentence, ErrorData data)
    : Error(Problem{kind, sentence, std::move(data)}) {}

Error::Error(Problem problem)
    : std::runtime_error(problem.sentence),
      problem_(std::make_shared<const Problem>(std::move(problem))) {}

void rethrow_with_prefix(const std::string& prefix) {
  try {
    throw;
  } catch (const UsageError& error) {
    throw_prefixed(prefix, error);
  } catch (const InputError& error) {
    throw_prefixed(prefix, error);
  } catch (const GoalError& error) {
    throw_prefixed(prefix, error);
  } catch (const OutputError& error) {
    throw_prefixed(prefix, error);
  }
}

}  // namespace transformesh
