#include "advice.h"

#include <algorithm>
#include <array>
#include <utility>

namespace transformesh::python {
namespace {

using Kind = ErrorKind;
using Advice = std::pair<ErrorKind, const char*>;

constexpr const char* far_away =
    "for a shape that is small or far from the origin, move it there with transform(center=True)";

constexpr std::array table{
    Advice{Kind::not_closed, "close holes with fill()"},
    Advice{Kind::not_joined, "join them with stitch()"},
    Advice{Kind::not_oriented, "orient it with stitch(orient=True)"},
    Advice{Kind::not_orientable, "remove faces at this edge"},
    Advice{Kind::overlapping_sheets, "separate them with stitch()"},
    Advice{Kind::one_sided,
           "cut it open with stitch() without orient, then close its borders with "
           "fill(allow_crossings=True)"},
    Advice{Kind::not_manifold, "orient it with stitch(orient=True)"},
    Advice{Kind::self_intersections, "remove self-intersections with clean()"},
    Advice{Kind::inside_out, "reverse it with stitch(flip=True)"},
    Advice{Kind::double_sided, "keep one side of a double-sided model with stitch(one_side=True)"},
    Advice{Kind::double_sided_sheet,
           "keep one side of a double-sided sheet, open, with stitch(one_side=True)"},
    Advice{Kind::canceling_faces, far_away},
    Advice{Kind::no_area, far_away},
    Advice{Kind::no_positive_winding,
           "if the mesh is inside out, reverse it with stitch(flip=True)"},
    Advice{Kind::component_too_small, "use a smaller min_edge"},
    Advice{Kind::thinner_than_rounding, far_away},
    Advice{Kind::float_rounding_failed, "merge close vertices there with stitch(tolerance=LENGTH)"},
    Advice{Kind::double_rounding_failed,
           "merge close vertices there with stitch(tolerance=LENGTH)"},
    Advice{Kind::needs_cleaning, "leave out refuse to clean it"},
    Advice{Kind::box_in_open_mesh,
           "close holes with fill(), or use clean() without box, which accepts open meshes"},
    Advice{Kind::static_test_of_open_mesh, "use method='grow', or close it with fill()"},
    Advice{Kind::decimation_stuck,
           "ask for more faces, or use clean() first: edges near self-intersections are not "
           "collapsed"},
    Advice{Kind::meets_keep_out,
           "enlarge that surface with offset(), and subtract it from the mesh with boolean()"},
    Advice{Kind::bad_reference_edge, "remove it from the mesh's comments"},
    Advice{Kind::no_velocity, "give velocities, normal_speed or curvature_speed"},
    Advice{Kind::no_source_points,
           "make them with source=True, or use the closest points with closest=True"},
    Advice{Kind::no_color_property, "name the property with color_by"},
    Advice{Kind::surface_vanished, "shorten the steps with max_move or time_step, or end earlier"},
    Advice{Kind::target_open, "close its holes first with fill()"},
    Advice{
        Kind::target_not_solid,
        "the target is open, not manifold or self-intersecting: clean() it, or fill() its holes"},
    Advice{Kind::source_apart, "begin with a source that overlaps all of the target"},
    Advice{Kind::edges_too_long, "begin with shorter edges"},
    Advice{Kind::uniform_edges_too_long,
           "shorten edges at narrow places with gap_edges=1.5, or begin with shorter edges"},
    Advice{Kind::surface_explodes, "check the cameras, or raise coarsest"},
    Advice{Kind::outside_hull,
           "check that cameras and mesh have the same units and origin, or see clip"},
    Advice{Kind::scene_behind_cameras, "mirror the scene with mirror=True"},
    Advice{Kind::views_disagree,
           "check cameras and masks, or accept less agreement with least_agreement"},
    Advice{Kind::few_views_disagree,
           "check their cameras and masks, or leave these views out with drop_bad_views=True"},
};

}  // namespace

const char* advice_for(ErrorKind kind) {
  const auto* const row = std::ranges::find(table, kind, &Advice::first);
  return row == table.end() ? "" : row->second;
}

std::string with_advice(const Problem& problem) {
  const std::string advice = advice_for(problem.kind);
  return advice.empty() ? problem.sentence : problem.sentence + "; " + advice;
}

std::vector<std::string> with_advice(const std::vector<Problem>& problems) {
  std::vector<std::string> lines;
  for (const Problem& problem : problems) lines.push_back(with_advice(problem));
  return lines;
}

}  // namespace transformesh::python
