#include "frame/advice.h"

#include <algorithm>
#include <array>

#include "support/number.h"

namespace transformesh::tool {
namespace {

using Kind = ErrorKind;

constexpr std::array table{
    Advice{Kind::not_closed, "keep-open",
           "no patch closes these holes: leave them open with --keep-open"},
    Advice{Kind::not_closed, "", "close holes with tm-fill"},
    Advice{Kind::not_joined, "", "join them with tm-stitch"},
    Advice{Kind::not_oriented, "", "orient it with tm-stitch --orient"},
    Advice{Kind::not_orientable, "", "remove faces at this edge"},
    Advice{Kind::overlapping_sheets, "", "separate them with tm-stitch"},
    Advice{Kind::one_sided, "",
           "cut it open with tm-stitch without --orient, then close its borders with tm-fill "
           "--allow-crossings"},
    Advice{Kind::not_manifold, "", "stitch and orient it with tm-stitch --orient"},
    Advice{Kind::self_intersections, "", "remove self-intersections with tm-clean"},
    Advice{Kind::inside_out, "", "reverse it with tm-stitch --flip"},
    Advice{Kind::double_sided, "",
           "keep one side of a double-sided model with tm-stitch --one-side"},
    Advice{Kind::double_sided_sheet, "keep-open",
           "keep the sheet open with --keep-open; or wrap it with tm-sample and tm-wrap --method "
           "alpha"},
    Advice{Kind::double_sided_sheet, "",
           "keep one side of a double-sided sheet, open, with tm-stitch --one-side; or wrap the "
           "sheet with tm-sample and tm-wrap --method alpha"},
    Advice{
        Kind::canceling_faces, "keep-open",
        "keep a sheet open with --keep-open; or wrap it with tm-sample and tm-wrap --method alpha"},
    Advice{Kind::canceling_faces, "double",
           "if the mesh is a sheet, wrap it with tm-sample and tm-wrap --method alpha; if it is "
           "small or far from the origin, give --double or move it to the origin"},
    Advice{Kind::canceling_faces, "",
           "if the mesh is a sheet, wrap it with tm-sample and tm-wrap --method alpha; if it is "
           "small or far from the origin, run tm-convert --double first or move it to the origin"},
    Advice{Kind::no_area, "double",
           "if the shape is small or far from the origin, give --double or move it to the origin"},
    Advice{Kind::no_area, "",
           "if the shape is small or far from the origin, run tm-convert --double first or move it "
           "to the origin"},
    Advice{Kind::no_positive_winding, "",
           "if the mesh is inside out, reverse it with tm-stitch --flip"},
    Advice{Kind::component_too_small, "min-edge", "use a smaller --min-edge"},
    Advice{Kind::thinner_than_rounding, "double",
           "if the mesh is a sheet, wrap it with tm-sample and tm-wrap --method alpha; if it is "
           "small or far from the origin, give --double or move it to the origin"},
    Advice{Kind::thinner_than_rounding, "",
           "if the mesh is a sheet, wrap it with tm-sample and tm-wrap --method alpha; if it is "
           "small or far from the origin, run tm-convert --double first or move it to the origin"},
    Advice{Kind::float_rounding_failed, "double",
           "write doubles (--double), or merge close vertices there (tm-stitch --tolerance)"},
    Advice{Kind::float_rounding_failed, "",
           "convert the input to doubles first (tm-convert --double), or merge close vertices "
           "there (tm-stitch --tolerance)"},
    Advice{Kind::double_rounding_failed, "", "merge close vertices there (tm-stitch --tolerance)"},
    Advice{Kind::needs_cleaning, "refuse", "leave out --refuse to clean it"},
    Advice{Kind::box_in_open_mesh, "",
           "find these edges with tm-checkmanifold, close holes with tm-fill, or run tm-clean "
           "without --box, which accepts open meshes"},
    Advice{Kind::static_test_of_open_mesh, "method",
           "use --method grow, or close the mesh with tm-fill"},
    Advice{Kind::decimation_stuck, "",
           "ask for more faces, or run tm-repair first: edges near self-intersections and open "
           "seams are not collapsed"},
    Advice{Kind::meets_keep_out, "",
           "enlarge that surface with tm-offset --distance, and subtract it from the mesh with "
           "tm-boolean difference"},
    Advice{Kind::bad_reference_edge, "reference-edge",
           "measure it again with --reference-edge auto"},
    Advice{Kind::bad_reference_edge, "", "measure it again with tm-convert --reference-edge auto"},
    Advice{Kind::no_velocity, "normal-speed",
           "give --normal-speed or --curvature-speed, or write the vertex properties vx vy vz"},
    Advice{Kind::no_source_points, "closest",
           "write them with tm-clean --source or tm-remesh --source, or use the closest points "
           "with tm-carry --closest"},
    Advice{Kind::no_segments, "", "write one with tm-intersect --segments"},
    Advice{Kind::no_color_property, "color-by", "name the property with --color-by"},
    Advice{Kind::texture_too_small, "texture-size",
           "remesh the surface, or give a larger --texture-size"},
    Advice{Kind::surface_vanished, "max-move",
           "shorten the steps with --max-move or --time-step, or in the command of --step, or end "
           "the run earlier"},
    Advice{Kind::target_open, "", "close its holes first, or wrap it with tm-wrap"},
    Advice{Kind::target_not_solid, "",
           "the target is open, non-manifold or self-intersecting, so an embedded surface cannot "
           "lie on all of it: clean it with tm-clean, or close its holes with tm-fill"},
    Advice{Kind::source_apart, "",
           "begin with a source that overlaps all of the target, for example from tm-shape sphere "
           "--around"},
    Advice{Kind::edges_too_long, "reference-edge", "shorten edges with --reference-edge {edge}"},
    Advice{Kind::uniform_edges_too_long, "gap-edges",
           "shorten edges at narrow places with --gap-edges 1.5"},
    Advice{Kind::outside_hull, "clip",
           "check that cameras and mesh have the same units and origin, or keep all of the mesh "
           "with --clip nothing"},
    Advice{Kind::scene_behind_cameras, "mirror", "mirror the scene with --mirror"},
    Advice{Kind::views_disagree, "least-agreement",
           "check cameras and masks, or accept less agreement with --least-agreement"},
    Advice{Kind::few_views_disagree, "drop-bad-views",
           "check their cameras and masks, or leave these views out with --drop-bad-views"},
    Advice{Kind::bad_state, "restart", "begin again with --restart"},
    Advice{Kind::other_settings, "resume",
           "repeat these settings, or begin again with --restart instead of --resume"},
    Advice{Kind::interrupted_run, "restart",
           "continue it with --resume, or discard it with --restart"},
    Advice{Kind::not_a_run, "", "write it with tm-evolve, tm-morph or tm-reconstruct --run {name}"},
};

void replace(std::string& text, const std::string& word, const std::string& value) {
  const std::size_t at = text.find(word);
  if (at != std::string::npos) text.replace(at, word.size(), value);
}

/// Returns half the reference edge as text. The last of `data.lengths` is 1.5 times the reference
/// edge, so half the reference edge is a third of this length.
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
