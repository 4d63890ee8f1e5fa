#include "frame/advice.h"

#include <algorithm>
#include <array>

#include "support/number.h"

namespace transformesh::tool {
namespace {

using Kind = ErrorKind;

constexpr std::array table{
    Advice{Kind::not_closed, "", "tm-fill closes holes"},
    Advice{Kind::not_joined, "", "tm-stitch joins them"},
    Advice{Kind::not_oriented, "", "mend it with tm-stitch --orient"},
    Advice{Kind::not_orientable, "", "remove faces there"},
    Advice{Kind::overlapping_sheets, "", "tm-stitch keeps them apart"},
    Advice{Kind::one_sided, "",
           "tm-stitch without --orient cuts it open, and tm-fill --allow-crossings closes borders"},
    Advice{Kind::not_manifold, "", "mend it with tm-stitch --orient"},
    Advice{Kind::self_intersections, "", "tm-clean removes self-intersections"},
    Advice{Kind::inside_out, "", "reverse it with tm-stitch --flip"},
    Advice{Kind::double_sided, "", "tm-stitch --one-side keeps one side of a double-sided model"},
    Advice{Kind::double_sided_sheet, "",
           "tm-stitch --one-side keeps one side of a double-sided sheet, open; tm-sample and "
           "tm-wrap --method alpha go around a sheet"},
    Advice{Kind::canceling_faces, "double",
           "tm-sample and tm-wrap --method alpha go around a sheet; a shape that is small or far "
           "from the origin needs --double, or to be moved there"},
    Advice{Kind::canceling_faces, "",
           "tm-sample and tm-wrap --method alpha go around a sheet; a shape that is small or far "
           "from the origin needs tm-convert --double, or to be moved there"},
    Advice{Kind::no_area, "double",
           "a shape that is small or far from the origin needs --double, or to be moved there"},
    Advice{Kind::no_area, "",
           "a shape that is small or far from the origin needs tm-convert --double, or to be moved "
           "there"},
    Advice{Kind::no_positive_winding, "",
           "a mesh that is inside out is reversed by tm-stitch --flip"},
    Advice{Kind::component_too_small, "min-edge", "use a smaller --min-edge"},
    Advice{Kind::thinner_than_rounding, "double",
           "a shape that is small or far from the origin needs --double, or to be moved there"},
    Advice{Kind::thinner_than_rounding, "",
           "a shape that is small or far from the origin needs tm-convert --double, or to be moved "
           "there"},
    Advice{Kind::float_rounding_failed, "double",
           "write doubles (--double), or merge vertices that lie close together there (tm-stitch "
           "--tolerance)"},
    Advice{Kind::float_rounding_failed, "",
           "begin with doubles (tm-convert --double), or merge vertices that lie close together "
           "there (tm-stitch --tolerance)"},
    Advice{Kind::double_rounding_failed, "",
           "merge vertices that lie close together there (tm-stitch --tolerance)"},
    Advice{Kind::needs_cleaning, "refuse", "leave out --refuse to clean it"},
    Advice{Kind::box_in_open_mesh, "",
           "tm-checkmanifold names them, tm-fill closes holes, and tm-clean without --box takes "
           "open meshes"},
    Advice{Kind::static_test_of_open_mesh, "method", "use --method grow, or close it with tm-fill"},
    Advice{Kind::decimation_stuck, "",
           "ask for more faces, or remove crossings of the input first (tm-clean), around which "
           "nothing collapses"},
    Advice{Kind::meets_keep_out, "",
           "cut one from the other first, as the difference in tm-clean(1)"},
    Advice{Kind::bad_reference_edge, "reference-edge",
           "measure it again with --reference-edge auto"},
    Advice{Kind::bad_reference_edge, "", "measure it again with tm-convert --reference-edge auto"},
    Advice{Kind::no_velocity, "normal-speed",
           "give --normal-speed or --curvature-speed, or write the vertex properties vx vy vz"},
    Advice{Kind::no_source_points, "closest",
           "write it with tm-clean --source or tm-remesh --source, or take the closest places with "
           "tm-carry --closest"},
    Advice{Kind::no_segments, "", "tm-intersect --segments writes one"},
    Advice{Kind::no_color_property, "color-by", "name it with --color-by"},
    Advice{Kind::texture_too_small, "texture-size",
           "remesh the surface, or give a larger --texture-size"},
    Advice{Kind::target_open, "", "close its holes before, or go around it with tm-wrap"},
    Advice{Kind::target_not_solid, "",
           "the target is open, no manifold, or intersects itself, so that no surface without "
           "crossings lies on all of it: clean it with tm-clean, or close its holes with tm-fill"},
    Advice{Kind::source_apart, "",
           "begin with a source that overlaps all of the target, as tm-shape sphere --around makes "
           "it"},
    Advice{Kind::edges_too_long, "reference-edge", "shorten edges with --reference-edge {edge}"},
    Advice{Kind::uniform_edges_too_long, "gap-edges",
           "shorten edges at narrow places with --gap-edges 1.5"},
    // Only tm-reconstruct has --crumbs, which identifies the program here.
    Advice{Kind::surface_explodes, "crumbs", "see --stiffness, --coarsest and tm-cameras"},
    Advice{Kind::outside_hull, "clip", "see --clip"},
    Advice{Kind::scene_behind_cameras, "mirror", "--mirror takes its mirror image, z for -z"},
    Advice{Kind::views_disagree, "least-agreement", "see --least-agreement"},
    Advice{Kind::few_views_disagree, "drop-bad-views",
           "look at camera and mask, or leave out what disagrees with --drop-bad-views"},
    Advice{Kind::bad_state, "restart", "begin again with --restart"},
    Advice{Kind::other_settings, "resume", "leave out --resume"},
    Advice{Kind::interrupted_run, "restart",
           "continue it with --resume, or discard it with --restart"},
    Advice{Kind::not_a_run, "", "a loop such as tm-morph writes it with --run {name}"},
};

void replace(std::string& text, const std::string& word, const std::string& value) {
  const std::size_t at = text.find(word);
  if (at != std::string::npos) text.replace(at, word.size(), value);
}

/// Returns half the reference edge as text. The longest edge in the data is 1.5 times the reference
/// edge.
std::string half_of_reference_edge(const ErrorData& data) {
  return significant(data.lengths.empty() ? 0 : data.lengths.back() / 3, 2);
}

}  // namespace

std::span<const Advice> advice_table() { return table; }

std::string advice_for(const Problem& problem, const Program& program) {
  const auto row = std::ranges::find_if(table, [&](const Advice& advice) {
    return advice.kind == problem.kind &&
           (*advice.option == 0 || program.options.find(advice.option) != nullptr);
  });
  if (row == table.end()) return {};
  std::string text = row->text;
  replace(text, "{name}", problem.data.name);
  replace(text, "{edge}", half_of_reference_edge(problem.data));
  return text;
}

std::string with_advice(const Problem& problem, const Program& program) {
  const std::string advice = advice_for(problem, program);
  return advice.empty() ? problem.sentence : problem.sentence + "; " + advice;
}

}  // namespace transformesh::tool
