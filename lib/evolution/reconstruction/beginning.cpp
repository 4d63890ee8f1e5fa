#include "evolution/reconstruction/beginning.h"

#include "evolution/loop/record.h"
#include "evolution/reconstruction/start.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"
#include "views/cameras/view.h"
#include "views/depth/opened_hull.h"

namespace transformesh {
namespace {

constexpr const char* start_name = "start.ply";
constexpr const char* hull_name = "hull.ply";
constexpr const char* coarsest_name = "coarsest";

void open_hollows(Beginning& begun, const std::vector<View>& views, const BeginningOptions& options,
                  const Progress& progress) {
  OpenedHullOptions opening;
  opening.keep = options.start.keep;
  opening.pairs = options.pairs;
  std::optional<OpenedHull> opened = opened_hull(views, opening, progress);
  if (!opened) return;
  begun.start.mesh = std::move(opened->mesh);
  begun.coarsest = read_back(fixed(opened->scale, 4));
}

}  // namespace

Beginning begin_reconstruction(const Document& document, std::vector<View>& views,
                               const BeginningOptions& options, Record& record,
                               const Progress& progress) {
  Beginning begun{document, std::nullopt, std::nullopt};
  begun.outlined = begin_surface(begun.start, views, options.start, pixel_size(views), progress);
  if (!options.start.is_given && options.start.opens_hollows)
    open_hollows(begun, views, options, progress);
  record.add(start_name, write_mesh(begun.start).bytes);
  if (begun.outlined) record.add(hull_name, write_mesh({*begun.outlined, {}, {}}).bytes);
  if (begun.coarsest) record.add(coarsest_name, fixed(*begun.coarsest, 4));
  return begun;
}

Beginning found_beginning(const Record& record) {
  const auto start = record.find(start_name);
  const auto hull = record.find(hull_name);
  if (!start) throw InputError("the state of the run is not that of a reconstruction");
  Beginning found{read_mesh(*start, start_name).document, std::nullopt, std::nullopt};
  if (hull) found.outlined = read_mesh(*hull, hull_name).document.mesh;
  if (const auto coarsest = record.find(coarsest_name)) found.coarsest = read_back(*coarsest);
  return found;
}

}  // namespace transformesh
