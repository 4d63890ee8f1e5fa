#include "advice.h"

#include <algorithm>
#include <array>
#include <utility>

namespace transformesh::python {
namespace {

using Kind = ErrorKind;
using Advice = std::pair<ErrorKind, const char*>;

constexpr const char* far_away =
    "move a shape that is small or far from the origin there, with transform(center=True)";

constexpr std::array table{
    Advice{Kind::not_closed, "fill() closes holes"},
    Advice{Kind::not_joined, "stitch() joins them"},
    Advice{Kind::not_oriented, "mend it with stitch(orient=True)"},
    Advice{Kind::not_orientable, "remove faces there"},
    Advice{Kind::overlapping_sheets, "stitch() keeps them apart"},
    Advice{Kind::one_sided,
           "stitch() without orient cuts it open, and fill(allow_crossings=True) closes borders"},
    Advice{Kind::not_manifold, "mend it with stitch(orient=True)"},
    Advice{Kind::self_intersections, "clean() removes self-intersections"},
    Advice{Kind::inside_out, "reverse it with stitch(flip=True)"},
    Advice{Kind::double_sided, "stitch(one_side=True) keeps one side of a double-sided model"},
    Advice{Kind::double_sided_sheet,
           "stitch(one_side=True) keeps one side of a double-sided sheet, open"},
    Advice{Kind::canceling_faces, far_away},
    Advice{Kind::no_area, far_away},
    Advice{Kind::no_positive_winding, "a mesh that is inside out is reversed by stitch(flip=True)"},
    Advice{Kind::component_too_small, "use a smaller min_edge"},
    Advice{Kind::thinner_than_rounding, far_away},
    Advice{Kind::float_rounding_failed,
           "merge vertices that lie close together there, with stitch(tolerance=LENGTH)"},
    Advice{Kind::double_rounding_failed,
           "merge vertices that lie close together there, with stitch(tolerance=LENGTH)"},
    Advice{Kind::needs_cleaning, "leave out refuse to clean it"},
    Advice{Kind::box_in_open_mesh,
           "fill() closes holes, and clean() without box takes open meshes"},
    Advice{Kind::static_test_of_open_mesh, "use method='grow', or close it with fill()"},
    Advice{Kind::decimation_stuck,
           "ask for more faces, or remove crossings of the input first with clean(), around which "
           "nothing collapses"},
    Advice{Kind::meets_keep_out, "cut one from the other first"},
    Advice{Kind::bad_reference_edge, "remove it from the mesh's comments"},
    Advice{Kind::no_velocity, "give velocities, normal_speed or curvature_speed"},
    Advice{Kind::no_source_points,
           "make it with source=True, or take the closest places with closest=True"},
    Advice{Kind::no_color_property, "name it with color_by"},
    Advice{Kind::target_open, "close its holes before with fill()"},
    Advice{
        Kind::target_not_solid,
        "the target is open, no manifold, or intersects itself: clean() it, or fill() its holes"},
    Advice{Kind::source_apart, "begin with a source that overlaps all of the target"},
    Advice{Kind::edges_too_long, "begin with shorter edges"},
    Advice{Kind::uniform_edges_too_long,
           "shorten edges at narrow places with gap_edges=1.5, or begin with shorter edges"},
    Advice{Kind::surface_explodes, "see coarsest"},
    Advice{Kind::outside_hull, "see clip"},
    Advice{Kind::scene_behind_cameras, "mirror=True takes its mirror image, z for -z"},
    Advice{Kind::views_disagree, "see least_agreement"},
    Advice{Kind::few_views_disagree,
           "look at camera and mask, or leave out what disagrees with drop_bad_views=True"},
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
