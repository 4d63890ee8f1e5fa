#include "remesh_options.h"

#include <charconv>

#include "tm/support/error.h"

namespace transformesh::tool {
namespace {

double smoothing_factor(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && rest == end) return value;
  throw UsageError("--smooth: '" + std::string(text) +
                   "' is not a number; write tangential, none or a factor such as 0.1");
}

void read_smoothing_twice(const RemeshChoices& options, RemeshOptions& result) {
  if (options.smooth_twice.empty()) return;
  if (options.smooth != "tangential") throw UsageError("--smooth and --smooth2 exclude each other");
  result.smoothing = Smoothing::bilaplace;
  result.smooth_first = options.smooth_twice[0];
  result.smooth_second = options.smooth_twice[1];
}

Length in_reference_edges(double value) { return {value, Length::Unit::reference_edge}; }

/// A factor of the local size.
double size_factor(const std::string& option, const Length& length) {
  if (length.unit == Length::Unit::reference_edge) return length.value;
  throw UsageError("with --size-field, --" + option +
                   " is a factor of the local size: write it as 0.7x, not as " + length.text());
}

/// Fills in the defaults, so that settings and report show them.
void set_default_lengths(RemeshChoices& options) {
  const bool adapts = options.adaptive.has_value();
  if (!options.min_edge) options.min_edge = in_reference_edges(adapts ? 0.1 : 0.7);
  if (!options.max_edge) options.max_edge = in_reference_edges(adapts ? 5 : 1.5);
}

void read_lengths(const RemeshChoices& options, Run& run, RemeshOptions& result) {
  if (options.adaptive) {
    result.adaptive_error = run.length(*options.adaptive);
    if (result.adaptive_error == 0) throw UsageError("--adaptive: the error must be above 0");
  }
  result.size_column = options.size_column;
  const bool has_sizes = !options.size_column.empty();
  result.min_edge =
      has_sizes ? size_factor("min-edge", *options.min_edge) : run.length(*options.min_edge);
  result.max_edge =
      has_sizes ? size_factor("max-edge", *options.max_edge) : run.length(*options.max_edge);
}

}  // namespace

void declare_remeshing(Program& program, RemeshChoices& options) {
  program.length("min-edge", &options.min_edge,
                 "collapse shorter edges (default 0.7x; with --adaptive 0.1x)");
  program.length("max-edge", &options.max_edge,
                 "split longer edges; at least 1.5 times the shortest (default 1.5x; with "
                 "--adaptive 5x)");
  program.text("size-field", &options.size_column, "COLUMN",
               "vertex property with the wanted edge length; x of --min-edge and --max-edge is of "
               "that");
  program.length("adaptive", &options.adaptive,
                 "edges as short as the curvature takes to stay this close to the surface");
  program.integer("iterations", &options.iterations, 0, 1000,
                  "rounds of split, collapse, flip and smooth");
  program.choice("flip", &options.flip, {"valence", "angle", "none"},
                 "flip edges for six edges at a vertex, or for larger least angles");
  program.text("smooth", &options.smooth, "KIND",
               "tangential (slides vertices, does not shrink), none, or the factor B of the "
               "Laplace-Beltrami operator, 0 to 1");
  program.numbers("smooth2", &options.smooth_twice, "B1,B2",
                  "the operator used twice: v - B1 dv + B2 d2v");
  program.number("feature-angle", &options.feature_angle, 1, 180,
                 "keep edges sharper than this, in degrees; 180 keeps none");
  program.flag("keep-border", &options.keep_border, "leave borders as they are");
  program.flag("project", &options.project,
               "tangential smoothing puts vertices back onto the input");
}

void read_smoothing(const std::string& text, RemeshOptions& options) {
  if (text == "tangential") return;
  options.smoothing = text == "none" ? Smoothing::none : Smoothing::laplace;
  if (text != "none") options.smooth_first = smoothing_factor(text);
}

RemeshOptions remesh_options(RemeshChoices& options, const Document& document, Run& run) {
  set_default_lengths(options);
  RemeshOptions result;
  read_lengths(options, run, result);
  result.iterations = static_cast<int>(options.iterations);
  result.flip = options.flip == "angle"  ? FlipRule::angle
                : options.flip == "none" ? FlipRule::none
                                         : FlipRule::valence;
  result.feature_angle_deg = options.feature_angle;
  result.keep_border = options.keep_border;
  result.project = options.project;
  result.coordinate = document.style.coordinate;
  read_smoothing(options.smooth, result);
  read_smoothing_twice(options, result);
  return result;
}

}  // namespace transformesh::tool
