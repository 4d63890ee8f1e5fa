#include "options/remesh_options.h"

#include <algorithm>
#include <limits>

#include "frame/smoothing_option.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

/// Returns a limit of edge lengths in input units; if `has_sizes` is set, as a factor of the local
/// size. If the length is not given, sets it to the default, so that settings and report show it.
double edge_length(std::optional<Length>& length, double default_value, const char* option,
                   bool has_sizes, Run& run) {
  if (!length) length = Length{default_value, Length::Unit::reference_edge};
  if (!has_sizes) return run.length(*length);
  if (length->unit == Length::Unit::reference_edge) return length->value;
  throw UsageError("with --size-field, " + std::string(option) +
                   " is a factor of the local size: write it as 0.7x, not as " + length->text());
}

/// Sets --min-edge and --max-edge to 0.7 and 1.5 times --edge, the factors of their defaults.
void take_one_edge(RemeshChoices& choices) {
  if (!choices.edge) return;
  if (choices.min_edge || choices.max_edge || choices.adaptive)
    throw UsageError("--edge sets --min-edge and --max-edge: give either --edge or these");
  choices.min_edge = Length{0.7 * choices.edge->value, choices.edge->unit};
  choices.max_edge = Length{1.5 * choices.edge->value, choices.edge->unit};
}

/// Parses --feature-angle; returns `otherwise` for `auto`.
double feature_angle(const std::string& text, double otherwise) {
  if (text == "auto") return otherwise;
  const auto angle = number_in<double>(text);
  if (!angle || !(*angle >= 1 && *angle <= 180))
    throw UsageError("--feature-angle: '" + text +
                     "' is neither auto nor a number of degrees from 1 to 180");
  return *angle;
}

// Throws UsageError if the command line combines `mode` with options of remeshing. `mode` is an
// option that replaces remeshing by another operation, such as --faces.
void refuse_others(const Program& program, const std::string& mode, const std::string& does,
                   const std::vector<std::string>& allowed) {
  for (const Option& option : program.options) {
    const bool is_allowed = std::ranges::find(allowed, option.name()) != allowed.end();
    if (option.is_given && !option.is_common && option.name() != mode && !is_allowed)
      throw UsageError("--" + mode + ' ' + does + " and --" + option.name() +
                       " remeshes: use one after the other");
  }
}

}  // namespace

void declare_remeshing(Program& program, RemeshChoices& choices) {
  RemeshOptions& remesh = choices.remesh;
  program.options.integer(
      "faces", &choices.faces, 4, std::numeric_limits<long>::max(),
      "decimate to N faces, where the surface changes least, and do nothing else");
  program.options.length(
      "error", &choices.error,
      "decimate within this distance of the input, and do nothing else; 0: only merge flat faces");
  program.options.text("align", &choices.align, "FILE",
                       "align vertices and edges with the sharp edges of this mesh, which must lie "
                       "near, and do nothing else");
  program.options.length(
      "edge", &choices.edge,
      "edge length: sets --min-edge to 0.7 times and --max-edge to 1.5 times this length");
  program.options.length("min-edge", &choices.min_edge,
                         "collapse shorter edges (default 0.7x; with --adaptive 0.1x)");
  program.options.length(
      "max-edge", &choices.max_edge,
      "split longer edges; at least 1.5 times --min-edge (default 1.5x; with --adaptive 5x)");
  program.options.text("size-field", &remesh.size_column, "COLUMN",
                       "vertex property with the wanted edge length; --min-edge and --max-edge are "
                       "factors of it, such as 0.7x");
  program.options.length("adaptive", &choices.adaptive,
                         "choose edge lengths by the curvature, so that the result deviates from "
                         "the input by about this");
  program.options.integer("iterations", &remesh.iterations, 0, 1000,
                          "number of iterations; each splits, collapses, flips and smooths");
  program.options.named("only", &remesh.only_smooth, {{"all", false}, {"smooth", true}},
                        "all: split, collapse, flip and smooth; smooth: only move vertices");
  program.options.named(
      "flip", &remesh.flip,
      {{"valence", FlipRule::valence}, {"angle", FlipRule::angle}, {"none", FlipRule::none}},
      "flip edges towards six edges at a vertex, or if the smallest angle grows");
  program.options.text("smooth", &choices.smooth, "KIND",
                       "tangential (slides vertices, does not shrink), none, or the factor of the "
                       "Laplace-Beltrami operator, from 0 to 1");
  program.options.numbers("smooth2", &choices.smooth_twice, "B1,B2",
                          "apply the operator once and twice: v - B1 dv + B2 d2v");
  program.options.text(
      "feature-angle", &choices.feature_angle, "auto|NUMBER",
      "keep edges sharper than this, from 1 to 180 degrees; 180 keeps none; auto: 40 if the "
      "mesh certainly has sharp edges, else 180");
  program.options.flag("keep-border", &remesh.keep_border, "do not change borders");
  program.options.flag("project", &remesh.project,
                       "move vertices back onto the input after tangential smoothing");
  program.options.flag("curved", &remesh.curved,
                       "put new vertices on curves through their neighbors, and do not move "
                       "others; sets the defaults --smooth none and --flip angle");
  program.options.length(
      "min-film", &choices.min_film,
      "keep thin sheets, strips and rims thicker than this, even if edges across them are short");
  program.options.length(
      "pinch", &choices.pinch,
      "cut and cap necks and handles that have a loop of at most this length around them");
  program.options.flag("source", &choices.source_points,
                       "write the source point of each vertex and face on the input, as the "
                       "properties source_face, source_u and source_v");
  choices.keep_out.declare(program);
}

RemeshOptions remesh_options(RemeshChoices& choices, const Document& document, Run& run) {
  const OptionSet& given = run.program().options;
  if (choices.remesh.curved && !given.find("flip")->is_given) choices.remesh.flip = FlipRule::angle;
  RemeshOptions result = choices.remesh;
  const bool adapts = choices.adaptive.has_value();
  if (adapts) result.adaptive_error = run.length(*choices.adaptive);
  if (adapts && result.adaptive_error == 0)
    throw UsageError("--adaptive: the error must be above 0");
  const bool has_sizes = !result.size_column.empty();
  take_one_edge(choices);
  result.min_edge = edge_length(choices.min_edge, adapts ? 0.1 : 0.7, "--min-edge", has_sizes, run);
  result.max_edge = edge_length(choices.max_edge, adapts ? 5 : 1.5, "--max-edge", has_sizes, run);
  result.feature_angle_deg = feature_angle(choices.feature_angle, 0);
  result.coordinate = document.style.coordinate;
  result.keep_out = choices.keep_out.options(run);
  if (choices.min_film) result.min_film = run.length(*choices.min_film);
  if (choices.pinch) result.pinch = run.length(*choices.pinch);
  const bool smooths = given.find("smooth")->is_given || !choices.smooth_twice.empty();
  if (result.curved && !smooths) choices.smooth = "none";
  read_smoothing(choices.smooth, result);
  if (choices.smooth_twice.empty()) return result;
  if (choices.smooth != "tangential")
    throw UsageError("give either --smooth or --smooth2, not both");
  result.smoothing = Smoothing::bilaplace;
  result.smooth_first = choices.smooth_twice[0];
  result.smooth_second = choices.smooth_twice[1];
  return result;
}

DecimateOptions decimate_options(RemeshChoices& choices, const Document& document, Run& run) {
  refuse_others(run.program(), choices.faces ? "faces" : "error", "decimates",
                {"faces", "error", "feature-angle", "keep-border", "source", "keep-out", "gap"});
  DecimateOptions options{choices.faces.value_or(0), feature_angle(choices.feature_angle, 180),
                          choices.remesh.keep_border, document.style.coordinate,
                          choices.keep_out.options(run)};
  if (choices.error) options.error = run.length(*choices.error);
  return options;
}

AlignOptions align_options(RemeshChoices& choices, const Document& document, Run& run) {
  refuse_others(run.program(), "align", "aligns",
                {"feature-angle", "edge", "min-edge", "max-edge", "source"});
  take_one_edge(choices);
  AlignOptions result;
  result.feature_angle_deg = feature_angle(choices.feature_angle, result.feature_angle_deg);
  result.min_edge = edge_length(choices.min_edge, 0.7, "--min-edge", false, run);
  result.max_edge = edge_length(choices.max_edge, 1.5, "--max-edge", false, run);
  result.coordinate = document.style.coordinate;
  return result;
}

}  // namespace transformesh::tool
