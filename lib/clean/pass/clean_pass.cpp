#include "clean/pass/clean_pass.h"

#include <algorithm>
#include <memory>
#include <string>

#include "clean/exterior/exterior.h"
#include "clean/exterior/exterior_arrangement.h"
#include "clean/exterior/ray_cast_front_winding.h"
#include "clean/intersect/find_meetings.h"
#include "clean/open/borders.h"
#include "clean/open/enclosed_sheets.h"
#include "clean/open/open_components.h"
#include "clean/open/open_patches.h"
#include "mesh/adjacency.h"
#include "support/counted.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

namespace transformesh {
namespace {

// Throws the UsageError of the static test for open meshes: the winding numbers in front of the
// pieces of an open mesh are not integers.
void refuse_static_test(std::size_t borders) {
  throw UsageError(
      ErrorKind::static_test_of_open_mesh,
      "the static test needs a closed mesh; this one has " + counted(borders, "border"),
      {.counts = {borders}});
}

// True if a face that was not cut is kept with reversed orientation. The first source of its piece
// is the face itself.
bool has_turned_piece(const Arrangement& arrangement, const std::vector<char>& kept) {
  for (std::size_t p = 0; p < arrangement.whole_pieces; ++p)
    if (kept[p] && arrangement.sources_of(arrangement.pieces[p]).front().reversed) return true;
  return false;
}

void count_faces(const Mesh& mesh, const Arrangement& arrangement, std::size_t whole_faces,
                 const std::vector<char>& kept, const Borders& borders, CleanPass& pass) {
  const auto whole_end = kept.begin() + static_cast<std::ptrdiff_t>(arrangement.whole_pieces);
  pass.pieces = arrangement.pieces.size();
  pass.cut_faces = arrangement.welded->faces.size() - whole_faces;
  pass.removed_faces =
      whole_faces - static_cast<std::size_t>(std::count(kept.begin(), whole_end, 1));
  pass.unchanged = pass.cut_faces == 0 && pass.removed_faces == 0 &&
                   arrangement.welded->faces.size() == mesh.faces.size() &&
                   !has_turned_piece(arrangement, kept) && is_stitched(mesh, borders);
}

class CleanPassRun {
 public:
  CleanPassRun(const Mesh& mesh, const CleanPassOptions& options, const Progress& progress)
      : mesh_(mesh),
        options_(options),
        progress_(progress),
        welded_(std::make_shared<WeldedMesh>(weld(mesh))) {}
  CleanPass run();

 private:
  void find_borders_or_none();
  bool find_all_exterior();
  void find_open_faces(const std::vector<Meeting>& meetings);
  void find_exterior_growing(const std::vector<Meeting>& meetings);
  void find_exterior_by_ray(const std::vector<Meeting>& meetings);
  void choose_pieces(const std::vector<Meeting>& meetings);
  void arrange_mesh(const std::vector<Meeting>& meetings, bool chooses);
  void stitch();
  void keep_exterior_patches();

  const Mesh& mesh_;
  const CleanPassOptions& options_;
  const Progress& progress_;
  std::shared_ptr<WeldedMesh> welded_;
  /// True if the mesh is a closed manifold, and welding changes nothing.
  bool is_closed_manifold_ = false;
  Borders borders_;
  Arrangement arrangement_;
  std::vector<char> kept_;  ///< 1 for each piece that is kept in the result
  bool has_surface_ = true;
  std::size_t whole_faces_ = 0;
  CleanPass pass_;
};

void CleanPassRun::find_borders_or_none() {
  const bool is_as_given = welded_->points.size() == mesh_.positions.size() &&
                           welded_->faces.size() == mesh_.faces.size();
  is_closed_manifold_ = is_as_given && is_closed_manifold(mesh_, welded_->opposites);
  if (is_closed_manifold_) return;
  borders_ = options_.check_orientation ? find_oriented_borders(*welded_, mesh_)
                                        : find_borders(*welded_, mesh_);
}

// Returns true if a mesh without intersections is a closed manifold and all its faces are exterior,
// which one ray per component decides. Then arranging and stitching are unnecessary.
bool CleanPassRun::find_all_exterior() {
  if (!is_closed_manifold_) return false;
  progress_("arrange");
  Connectivity connectivity = connect(std::move(welded_->opposites));
  const std::size_t count = connectivity.components;
  const RayCastFrontWinding ray(*welded_, count);
  const ExactGeometry geometry(welded_->points, welded_->faces);
  std::size_t seen = 0;
  for (Index f = 0; seen < count; ++f) {
    if (connectivity.component_of[f] != seen) continue;
    const auto& [a, b, c] = welded_->faces[f];
    const int w = ray.in_front_of({geometry.given(a), geometry.given(b), geometry.given(c)}, f);
    if (w >= options_.winding_level || w + 1 < options_.winding_level) {
      welded_->opposites = std::move(connectivity.opposites);
      return false;
    }
    ++seen;
  }
  pass_.rays = count;
  pass_.connectivity = std::move(connectivity);
  return true;
}

void CleanPassRun::find_open_faces(const std::vector<Meeting>& meetings) {
  const auto find_enclosed = [&] {
    return find_enclosed_sheets(arrange(welded_, meetings, progress_), options_.winding_level,
                                progress_);
  };
  welded_->open_component =
      find_open_components(mesh_, *welded_, is_stitched(mesh_, borders_), find_enclosed);
}

void CleanPassRun::find_exterior_growing(const std::vector<Meeting>& meetings) {
  const bool arranges_everything = options_.change_kept != nullptr;
  ExteriorArrangement exterior = arrange_exterior(
      welded_, meetings, {options_.winding_level, arranges_everything, nullptr}, progress_);
  arrangement_ = std::move(exterior.arrangement);
  kept_ = std::move(exterior.kept);
  has_surface_ = exterior.has_surface;
  whole_faces_ = exterior.whole_faces;
  pass_.rays = exterior.rays;
  if (!welded_->open_component.empty()) keep_exterior_patches();
}

// Selects the kept patches of a mesh with open components. If no face is cut, no open component is
// divided into several patches, and the selection does not change.
void CleanPassRun::keep_exterior_patches() {
  if (arrangement_.whole_pieces == arrangement_.pieces.size() && options_.winding_level == 1)
    return;
  OpenPatches patches =
      find_exterior_patches(arrangement_, options_.winding_level, options_.coordinate);
  kept_ = std::move(patches.kept);
  pass_.open_patches = patches.patches;
  pass_.decided_by_number = patches.decided_by_number;
  pass_.least_margin = patches.least_margin;
}

void CleanPassRun::choose_pieces(const std::vector<Meeting>& meetings) {
  if (welded_->open_component.empty()) {
    arrangement_ = arrange(welded_, meetings, progress_);
    whole_faces_ = arrangement_.whole_pieces;
  } else {
    ExteriorArrangement whole =
        arrange_exterior(welded_, meetings, {options_.winding_level, true, nullptr}, progress_);
    arrangement_ = std::move(whole.arrangement);
    whole_faces_ = whole.whole_faces;
  }
  kept_.assign(arrangement_.pieces.size(), 0);
  options_.chooser->choose(arrangement_, kept_);
}

void CleanPassRun::find_exterior_by_ray(const std::vector<Meeting>& meetings) {
  if (!borders_.loops.empty()) refuse_static_test(borders_.loops.size());
  arrangement_ = arrange(welded_, meetings, progress_);
  whole_faces_ = arrangement_.whole_pieces;
  kept_ = find_exterior_by_rays(arrangement_, options_.winding_level, progress_);
  const auto counts = [](const Piece& piece) { return piece.multiplicity != 0; };
  has_surface_ = std::any_of(arrangement_.pieces.begin(), arrangement_.pieces.end(), counts);
  pass_.rays = arrangement_.pieces.size();
}

void CleanPassRun::arrange_mesh(const std::vector<Meeting>& meetings, bool chooses) {
  if (options_.arranged && !options_.arranged->kept.empty()) {
    arrangement_ = std::move(options_.arranged->arrangement);
    kept_ = std::move(options_.arranged->kept);
    whole_faces_ = options_.arranged->whole_faces;
  } else if (chooses) {
    choose_pieces(meetings);
  } else if (options_.method == ExteriorMethod::static_test) {
    find_exterior_by_ray(meetings);
  } else {
    find_exterior_growing(meetings);
  }
}

// Changes which pieces are kept, and stitches these. `change_kept` may reverse pieces, so the
// pieces for later clean passes are copied before.
void CleanPassRun::stitch() {
  ArrangedMesh before;
  if (options_.arranged) {
    before.arrangement.pieces = arrangement_.pieces;
    before.arrangement.sources = arrangement_.sources;
    before.kept = kept_;
  }
  if (options_.change_kept) options_.change_kept(arrangement_, kept_);
  count_faces(mesh_, arrangement_, whole_faces_, kept_, borders_, pass_);
  progress_("stitch");
  if (!pass_.unchanged) pass_.assembly = assemble(mesh_, arrangement_, kept_);
  if (!options_.arranged) return;
  arrangement_.pieces = std::move(before.arrangement.pieces);
  arrangement_.sources = std::move(before.arrangement.sources);
  *options_.arranged = {std::move(arrangement_), std::move(before.kept), whole_faces_};
}

CleanPass CleanPassRun::run() {
  std::vector<Meeting> meetings;
  if (options_.chooser) options_.chooser->mark_open(*welded_);
  parallel_invoke([&] { find_borders_or_none(); },
                  [&] {
                    meetings = options_.pairs ? meetings_of(*welded_, *options_.pairs)
                                              : find_meetings(*welded_, Progress());
                  });
  pass_.pairs = count_pairs(*welded_, meetings);
  if (pass_.pairs > options_.most_pairs) return std::move(pass_);
  pass_.is_open = !borders_.loops.empty();
  if (pass_.is_open && !options_.chooser) find_open_faces(meetings);
  const bool chooses = options_.chooser && !options_.chooser->is_level_set(*welded_, meetings);
  const bool is_static = options_.method == ExteriorMethod::static_test;
  const bool takes_all = !chooses && !is_static && !options_.change_kept;
  if (takes_all && pass_.pairs == 0 && find_all_exterior()) {
    progress_("stitch");
    pass_.unchanged = true;
    return std::move(pass_);
  }
  arrange_mesh(meetings, chooses);
  if (std::find(kept_.begin(), kept_.end(), 1) == kept_.end() && chooses)
    throw GoalError(ErrorKind::no_positive_winding, "the result is empty: it encloses no point");
  if (std::find(kept_.begin(), kept_.end(), 1) == kept_.end())
    throw GoalError(nothing_kept(*welded_, has_surface_, options_.winding_level));
  stitch();
  return std::move(pass_);
}

}  // namespace

CleanPass run_clean_pass(const Mesh& mesh, const CleanPassOptions& options,
                         const Progress& progress) {
  progress("intersect");
  return CleanPassRun(mesh, options, progress).run();
}

}  // namespace transformesh
