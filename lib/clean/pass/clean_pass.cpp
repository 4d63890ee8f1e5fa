#include "clean/pass/clean_pass.h"

#include <algorithm>
#include <memory>
#include <string>

#include "clean/arrange/arrange.h"
#include "clean/exterior/close_borders.h"
#include "clean/exterior/exterior_arrangement.h"
#include "clean/exterior/ray_cast_front_winding.h"
#include "clean/intersect/intersect.h"
#include "clean/open/borders.h"
#include "clean/open/enclosed_sheets.h"
#include "mesh/adjacency.h"
#include "support/error.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

// In front of a piece of an open mesh the winding number is no integer.
void refuse_static_test(std::size_t borders) {
  throw UsageError("--method static needs a closed mesh; this one has " + std::to_string(borders) +
                   (borders == 1 ? " border" : " borders") +
                   ": use --method grow, or close it with tm-fill");
}

void count_faces(const Mesh& mesh, const Arrangement& arrangement, std::size_t whole_faces,
                 const Borders& borders, CleanPass& pass) {
  const auto& kept = pass.exterior.kept;
  const auto whole_end = kept.begin() + static_cast<std::ptrdiff_t>(arrangement.whole_pieces);
  pass.cut_faces = arrangement.welded->faces.size() - whole_faces;
  pass.removed_faces +=
      whole_faces - static_cast<std::size_t>(std::count(kept.begin(), whole_end, 1));
  pass.unchanged = pass.cut_faces == 0 && pass.removed_faces == 0 &&
                   arrangement.welded->faces.size() == mesh.faces.size() &&
                   is_stitched(mesh, borders);
}

class CleanPassRun {
 public:
  CleanPassRun(const Mesh& mesh, const CleanPassOptions& options, const Progress& progress)
      : mesh_(mesh),
        options_(options),
        progress_(progress),
        welded_(std::make_shared<const WeldedMesh>(weld(mesh))) {}
  CleanPass run();

 private:
  void find_borders_or_none();
  bool find_all_exterior();
  bool arrange_what_is_exterior(const std::vector<Meeting>& meetings);
  void arrange_everything(const std::vector<Meeting>& meetings);

  const Mesh& mesh_;
  const CleanPassOptions& options_;
  const Progress& progress_;
  std::shared_ptr<const WeldedMesh> welded_;
  std::optional<std::vector<Index>> opposites_;  ///< of a closed manifold
  Borders borders_;
  Arrangement arrangement_;
  std::size_t whole_faces_ = 0;
  CleanPass pass_;
};

void CleanPassRun::find_borders_or_none() {
  const bool is_as_given = welded_->points.size() == mesh_.positions.size() &&
                           welded_->faces.size() == mesh_.faces.size();
  if (is_as_given) opposites_ = closed_opposites(mesh_, welded_->opposites);
  if (opposites_) return;
  borders_ = options_.check_orientation ? find_oriented_borders(*welded_, mesh_)
                                        : find_borders(*welded_, mesh_);
}

// Where nothing meets in a closed manifold, a ray for each component says whether all of it stays:
// then nothing need be arranged or stitched. Returns whether that is so.
bool CleanPassRun::find_all_exterior() {
  if (!opposites_) return false;
  progress_("arrange");
  Connectivity connectivity = connect(std::move(*opposites_));
  opposites_.reset();
  const std::size_t count = connectivity.components;
  const RayCastFrontWinding ray(*welded_, count);
  const ExactGeometry geometry(welded_->points, welded_->faces);
  std::size_t seen = 0;
  for (Index f = 0; seen < count; ++f) {
    if (connectivity.component_of[f] != seen) continue;
    const auto& [a, b, c] = welded_->faces[f];
    const int w = ray.in_front_of({geometry.given(a), geometry.given(b), geometry.given(c)}, f);
    if (w >= options_.winding_level || w + 1 < options_.winding_level) return false;
    ++seen;
  }
  pass_.exterior.rays = count;
  pass_.connectivity = std::move(connectivity);
  return true;
}

// Returns whether there is anything.
bool CleanPassRun::arrange_what_is_exterior(const std::vector<Meeting>& meetings) {
  ExteriorArrangement exterior =
      arrange_exterior(welded_, meetings, options_.winding_level, progress_);
  arrangement_ = std::move(exterior.arrangement);
  whole_faces_ = exterior.whole_faces;
  pass_.exterior.kept.assign(arrangement_.pieces.size(), 1);
  pass_.exterior.rays = exterior.rays;
  return !arrangement_.pieces.empty();
}

void CleanPassRun::arrange_everything(const std::vector<Meeting>& meetings) {
  arrangement_ = arrange(welded_, meetings, progress_);
  whole_faces_ = arrangement_.whole_pieces;
  if (pass_.is_open) {
    pass_.removed_faces =
        drop_enclosed_sheets(mesh_, options_.winding_level, arrangement_, borders_, progress_);
    welded_ = arrangement_.welded;
    whole_faces_ = arrangement_.whole_pieces;
    if (options_.method == ExteriorMethod::static_test && !borders_.loops.empty())
      refuse_static_test(borders_.loops.size());
  }
  pass_.exterior = find_exterior(arrangement_, options_.winding_level, options_.method,
                                 close_borders(*welded_, borders_.loops), progress_);
  if (options_.change_kept) options_.change_kept(arrangement_, pass_.exterior.kept);
}

// Where everything is needed, or nothing is kept and it is to be told why, everything is arranged.
CleanPass CleanPassRun::run() {
  std::vector<Meeting> meetings;
  parallel_invoke([&] { find_borders_or_none(); },
                  [&] { meetings = find_meetings(*welded_, Progress()); });
  pass_.pairs = count_pairs(*welded_, meetings);
  if (pass_.pairs > options_.most_pairs) return std::move(pass_);
  pass_.is_open = !borders_.loops.empty();
  const bool needs_everything =
      pass_.is_open || options_.change_kept || options_.method == ExteriorMethod::static_test;
  if (!needs_everything && pass_.pairs == 0 && find_all_exterior()) {
    progress_("stitch");
    pass_.unchanged = true;
    return std::move(pass_);
  }
  if (needs_everything || !arrange_what_is_exterior(meetings)) arrange_everything(meetings);

  count_faces(mesh_, arrangement_, whole_faces_, borders_, pass_);
  progress_("stitch");
  if (!pass_.unchanged) pass_.assembly = assemble(mesh_, arrangement_, pass_.exterior.kept);
  return std::move(pass_);
}

}  // namespace

CleanPass run_clean_pass(const Mesh& mesh, const CleanPassOptions& options,
                         const Progress& progress) {
  progress("intersect");
  return CleanPassRun(mesh, options, progress).run();
}

}  // namespace transformesh
