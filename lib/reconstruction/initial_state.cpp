#include "reconstruction/initial_state.h"

#include "evolution/loop/record.h"
#include "reconstruction/initial_mesh.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"
#include "views/cameras/view.h"
#include "views/depth/opened_hull.h"

namespace transformesh {
namespace {

constexpr const char* initial_mesh_file = "start.ply";
constexpr const char* hull_name = "hull.ply";
constexpr const char* coarsest_name = "coarsest";
constexpr const char* unclipped_name = "unclipped.ply";
constexpr const char* first_scale_name = "first_scale";
constexpr const char* dense_name = "dense";

void open_hollows(InitialState& begun, const std::vector<View>& views,
                  const InitialStateOptions& options, const Progress& progress) {
  OpenedHullOptions opening;
  opening.keep = options.initial.keep;
  opening.pairs = options.pairs;
  std::optional<OpenedHull> opened = opened_hull(views, opening, progress);
  if (!opened) return;
  begun.document.mesh = std::move(opened->mesh);
  begun.coarsest = read_back(fixed(opened->scale, 4));
}

}  // namespace

InitialState make_initial_state(const Document& document, std::vector<View>& views,
                                const InitialStateOptions& options, Record& record,
                                const Progress& progress) {
  InitialState begun;
  begun.document = document;
  InitialMesh made =
      make_initial_mesh(begun.document, views, options.initial, pixel_size(views), progress);
  begun.outlined = std::move(made.outlined);
  begun.unclipped = std::move(made.unclipped);
  begun.why_dense = std::move(made.why_dense);
  if (!options.initial.is_given && begun.why_dense.empty() && options.initial.opens_hollows)
    open_hollows(begun, views, options, progress);
  record.add(initial_mesh_file, write_mesh(begun.document).bytes);
  if (begun.outlined) record.add(hull_name, write_mesh({*begun.outlined, {}, {}}).bytes);
  if (begun.unclipped) record.add(unclipped_name, write_mesh(*begun.unclipped).bytes);
  if (!begun.why_dense.empty()) record.add(dense_name, begun.why_dense);
  if (begun.coarsest) record.add(coarsest_name, fixed(*begun.coarsest, 4));
  return begun;
}

void set_first_scale(InitialState& initial_state, double scale, Record& record) {
  initial_state.first_scale = scale;
  record.add(first_scale_name, fixed(scale, 4));
}

InitialState read_initial_state(const Record& record) {
  const auto start = record.find(initial_mesh_file);
  const auto hull = record.find(hull_name);
  if (!start) throw InputError("the state of the run is not that of a reconstruction");
  InitialState found;
  found.document = read_mesh(*start, initial_mesh_file).document;
  if (hull) found.outlined = read_mesh(*hull, hull_name).document.mesh;
  if (const auto coarsest = record.find(coarsest_name)) found.coarsest = read_back(*coarsest);
  if (const auto whole = record.find(unclipped_name))
    found.unclipped = read_mesh(*whole, unclipped_name).document;
  if (const auto reason = record.find(dense_name)) found.why_dense = *reason;
  if (const auto scale = record.find(first_scale_name)) found.first_scale = read_back(*scale);
  return found;
}

}  // namespace transformesh
