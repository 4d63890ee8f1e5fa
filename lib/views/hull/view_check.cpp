#include "views/hull/view_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "io/streams/source.h"
#include "raster/camera.h"
#include "support/counted.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/contour_distance.h"
#include "views/hull/hull_values.h"
#include "views/hull/silhouette.h"

namespace transformesh {
namespace {

/// Resolution at which views are compared with their hull.
struct Fineness {
  int side_px = 160;  ///< largest width or height of the object in shrunk silhouettes
  int cells = 64;     ///< HullOptions::resolution
};
constexpr Fineness coarse;
constexpr Fineness fine{320, 128};
/// At least this number of views stay if views are left out.
constexpr std::size_t least_views = 3;
/// Number of grid points along each side of the box in which suspicions() compares the views.
constexpr int vote_points = 48;

/// Returns an image of the means of blocks of `side` x `side` pixels. It belongs to the camera that
/// PinholeCamera::shrunk(side) returns.
GrayImage block_means(const GrayImage& image, int side) {
  GrayImage means(image.width / side, image.height / side);
  for (int y = 0; y < means.height; ++y) {
    for (int x = 0; x < means.width; ++x) {
      float sum = 0;
      for (int row = y * side; row < (y + 1) * side; ++row)
        sum = std::accumulate(image.row(row) + x * side, image.row(row) + (x + 1) * side, sum);
      means.at(x, y) = sum / static_cast<float>(side * side);
    }
  }
  return means;
}

/// Returns the larger side of the bounding rectangle of the silhouette's inside, in pixels.
int extent(const GrayImage& silhouette) {
  int left = silhouette.width, right = -1, top = silhouette.height, bottom = -1;
  for (int y = 0; y < silhouette.height; ++y) {
    for (int x = 0; x < silhouette.width; ++x) {
      if (silhouette.at(x, y) <= contour_intensity) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = y;
    }
  }
  return std::max({right - left, bottom - top, 0}) + 1;
}

/// Returns the views with silhouettes and cameras shrunk by an integer factor, and without
/// photographs. The object is then at most `side_px` pixels large.
std::vector<View> shrunk_silhouettes(std::span<const View> views, int side_px) {
  std::vector<View> result(views.size());
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const GrayImage& silhouette = views[i].silhouette;
      const int smaller = std::min(silhouette.width, silhouette.height);
      const int side = std::clamp((extent(silhouette) + side_px - 1) / side_px, 1, smaller);
      result[i] = {views[i].name, views[i].camera.shrunk(side), {}, block_means(silhouette, side)};
    }
  });
  return result;
}

/// Comparison of the silhouettes of some views with those of their visual hull.
struct Agreement {
  std::vector<double> of_view;  ///< silhouette_agreement() of each view
  bool has_hull = false;        ///< false: the views have no common hull, and `of_view` is 0

  double least() const { return *std::min_element(of_view.begin(), of_view.end()); }
  double sum() const { return std::accumulate(of_view.begin(), of_view.end(), 0.0); }
  std::size_t worst() const {
    return static_cast<std::size_t>(std::min_element(of_view.begin(), of_view.end()) -
                                    of_view.begin());
  }
};

Agreement agreement_of(const std::vector<View>& views, const Fineness& fineness) {
  try {
    const Mesh hull = visual_hull(views, {.resolution = fineness.cells, .keep = 0}).mesh;
    return {silhouette_agreements(hull, views), true};
  } catch (const InputError&) {
    return {std::vector<double>(views.size(), 0), false};
  }
}

void invert(PackableImage& silhouette) {
  GrayImage image = silhouette;
  for (float& pixel : image.pixels) pixel = 255 - pixel;
  silhouette = std::move(image);
}

bool is_border_inside(const GrayImage& silhouette) {
  std::size_t inside = 0;
  std::size_t count = 0;
  for (int y = 0; y < silhouette.height; ++y) {
    const bool is_outer_row = y == 0 || y == silhouette.height - 1;
    const int step = is_outer_row ? 1 : std::max(1, silhouette.width - 1);
    for (int x = 0; x < silhouette.width; x += step, ++count)
      inside += silhouette.at(x, y) > contour_intensity ? 1 : 0;
  }
  return 2 * inside > count;
}

/// Returns a cube around the point at which the cameras look. Half of its side is the median, over
/// the views, of half of the image's diagonal, projected to that point.
Box viewed_box(const std::vector<View>& views) {
  const Vec3 center = viewed_point(cameras_of(views));
  std::vector<double> reaches;
  for (const View& view : views) {
    const PackableImage& image = view.silhouette;
    reaches.push_back((view.camera.center() - center).norm() *
                      Eigen::Vector2d(image.width, image.height).norm() / 2 /
                      view.camera.focal_length());
  }
  std::nth_element(reaches.begin(),
                   reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() / 2),
                   reaches.end());
  const Vec3 reach = Vec3::Constant(reaches[reaches.size() / 2]);
  return {center - reach, center + reach};
}

enum class Sight { nothing, object, background };

Sight seen_at(const View& view, const Projection& projection, const Vec3& point) {
  const Vec3 q = projection.leftCols<3>() * point + projection.col(3);
  if (!(q.z() > 0)) return Sight::nothing;
  const PackableImage& mask = view.silhouette;
  const double x = std::floor(q.x() / q.z() + 0.5);
  const double y = std::floor(q.y() / q.z() + 0.5);
  if (!(x >= 0 && y >= 0 && x < mask.width && y < mask.height)) return Sight::nothing;
  const bool is_inside = mask.at(static_cast<int>(x), static_cast<int>(y)) > contour_intensity;
  return is_inside ? Sight::object : Sight::background;
}

/// Returns for each view a score of how likely its mask or camera is wrong. The score sums over
/// grid points at which the view shows background although more than half of all views show the
/// object. If k views show background at such a point, each of them gets 1 / k^2. If these are more
/// than a third of the views, the point is probably background and usually does not count.
std::vector<double> suspicions(const std::vector<View>& views) {
  const Box box = viewed_box(views);
  std::vector<Projection> projections;
  for (const View& view : views) projections.push_back(view.camera.projection());
  std::vector<double> suspicion(views.size(), 0);
  std::vector<std::size_t> carvers;
  for (int i = 0; i < vote_points * vote_points * vote_points; ++i) {
    const Eigen::Array3d place(i % vote_points, i / vote_points % vote_points,
                               i / vote_points / vote_points);
    const Vec3 share = (place + 0.5) / vote_points;
    const Vec3 point = box.min() + share.cwiseProduct(box.max() - box.min());
    carvers.clear();
    std::size_t others = 0;
    for (std::size_t v = 0; v < views.size() && 3 * carvers.size() <= views.size(); ++v) {
      const Sight sight = seen_at(views[v], projections[v], point);
      if (sight == Sight::background) carvers.push_back(v);
      if (sight == Sight::object) ++others;
    }
    if (2 * others <= views.size()) continue;
    for (const std::size_t v : carvers)
      suspicion[v] += 1 / static_cast<double>(carvers.size() * carvers.size());
  }
  return suspicion;
}

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + "%"; }

/// Returns "'a'", "'a' and 'b'", "'a', 'b' and 'c'", or "'a', 'b' and 2 further views".
std::string names_of(const std::vector<std::string>& names) {
  std::string text = in_quotes(names.front());
  if (names.size() == 2) return text + " and " + in_quotes(names[1]);
  if (names.size() > 2) {
    text += ", " + in_quotes(names[1]) + " and " +
            (names.size() == 3 ? in_quotes(names[2]) : counted(names.size() - 2, "further view"));
  }
  return text;
}

/// Searches for a mistake of cameras or masks that explains why views disagree.
class Diagnosis {
 public:
  Diagnosis(std::vector<View> views, Agreement agreement, const ViewCheckOptions& options,
            const Progress& progress)
      : views_(std::move(views)),
        agreement_(std::move(agreement)),
        options_(options),
        progress_(progress) {}

  /// Returns the indices of the views to leave out. Returns none if the views have no hull and no
  /// known mistake explains this. Throws InputError if a known mistake, such as mirrored cameras,
  /// explains why views disagree. Also throws InputError if the options do not allow to leave views
  /// out.
  std::vector<std::size_t> run() {
    try_cameras();
    try_inverted();
    try_shifts();
    find_bad();
    if (options_.drops_bad_views && !bad_.empty()) return bad_;
    // Do not fail: visual_hull(), which is called later, reports why there is no hull. Possibly
    // only its box must be given.
    if (bad_.empty() && !agreement_.has_hull) return {};
    try_exchanges();
    fail_for_bad();
  }
  /// Returns for each bad view the fraction of its silhouette that the hull of the good views
  /// covers.
  const std::vector<double>& agreement_with_others() const { return agreement_of_bad_; }

  /// Throws InputError if all views agree after inverting those masks that are white at more than
  /// half of the pixels of the image border.
  void try_inverted() const;

 private:
  void try_cameras() const;
  void try_shifts() const;
  void try_exchanges() const;
  void find_bad();
  void keep_only_bad();
  [[noreturn]] void fail_for_bad() const;

  Agreement agreement(const std::vector<View>& views) const {
    progress_("check views");
    return agreement_of(views, coarse);
  }
  bool agree(const Agreement& found) const { return found.least() >= options_.least_agreement; }
  bool agree(const std::vector<View>& views) const { return agree(agreement(views)); }
  std::vector<View> rest() const;  ///< all views except those in `bad_`

  std::vector<View> views_;
  Agreement agreement_;
  const ViewCheckOptions& options_;
  const Progress& progress_;
  std::vector<std::size_t> bad_;
  std::vector<double> agreement_of_bad_;
};

void Diagnosis::try_cameras() const {
  std::vector<View> views = views_;
  for (View& view : views) view.camera = view.camera.mirrored();
  if (agree(views)) {
    throw InputError(ErrorKind::scene_behind_cameras,
                     "the scene lies behind every camera, as if the coordinates of the cameras "
                     "were left-handed");
  }
  views = views_;
  for (View& view : views) {
    view.camera.rotation.bottomRows<2>() *= -1;
    view.camera.translation.tail<2>() *= -1;
  }
  if (agree(views)) {
    throw InputError(
        "the cameras look away from the scene, like those of OpenGL, which look along -z with y "
        "up: negate the second and the third row of each rotation and translation");
  }
}

void Diagnosis::try_inverted() const {
  std::vector<View> views = views_;
  std::vector<std::string> names;
  for (View& view : views) {
    if (!is_border_inside(view.silhouette)) continue;
    invert(view.silhouette);
    names.push_back(view.name);
  }
  // If at most a third of the masks look inverted, and the options allow to leave out views, run()
  // leaves out the views of these masks.
  const bool is_dropped = options_.drops_bad_views && 3 * names.size() <= views.size();
  if (names.empty() || is_dropped || !agree(views)) return;
  const bool are_all = names.size() == views.size();
  throw InputError((are_all
                        ? "all masks look inverted"
                        : (names.size() == 1 ? "the mask of " : "the masks of ") + names_of(names) +
                              (names.size() == 1 ? " looks inverted" : " look inverted")) +
                   ": they are not black outside of the object; if black and white are exchanged, "
                   "all views agree");
}

// Tests whether silhouettes are shifted by one against the cameras. Shifting leaves one silhouette
// and one camera without a partner; both are omitted.
void Diagnosis::try_shifts() const {
  if (views_.size() <= least_views) return;
  for (const std::size_t forward : {1U, 0U}) {
    std::vector<View> views(views_.begin(), views_.end() - 1);
    for (std::size_t i = 0; i < views.size(); ++i) {
      views[i].silhouette = views_[i + 1 - forward].silhouette;
      views[i].camera = views_[i + forward].camera;
    }
    if (!agree(views)) continue;
    const std::size_t first = 1 - forward;
    throw InputError("all silhouettes look shifted by one relative to the cameras: that of " +
                     in_quotes(views_[first].name) + " fits the camera of " +
                     in_quotes(views_[forward].name) +
                     ", and so on; is one numbered from 0 and the other from 1?");
  }
}

std::vector<View> Diagnosis::rest() const {
  std::vector<View> views;
  for (std::size_t i = 0; i < views_.size(); ++i)
    if (std::find(bad_.begin(), bad_.end(), i) == bad_.end()) views.push_back(views_[i]);
  return views;
}

/// Adds views to `bad_`, the most suspicious view first, until all other views agree. Clears `bad_`
/// if they do not agree after a third of the views was added.
void Diagnosis::find_bad() {
  if (views_.size() <= least_views) return;
  const std::vector<double> suspicion = suspicions(views_);
  std::vector<std::size_t> suspects(views_.size());
  std::iota(suspects.begin(), suspects.end(), std::size_t{0});
  std::stable_sort(suspects.begin(), suspects.end(),
                   [&](std::size_t a, std::size_t b) { return suspicion[a] > suspicion[b]; });
  const std::size_t most = std::min(views_.size() / 3, views_.size() - least_views);
  for (const std::size_t suspect : suspects) {
    if (bad_.size() == most) break;
    bad_.push_back(suspect);
    if (agree(rest())) return keep_only_bad();
  }
  bad_.clear();
}

/// Removes a view from `bad_` if it agrees with the good views. Such a view was suspected only
/// because of other bad views. Then computes `agreement_of_bad_`.
void Diagnosis::keep_only_bad() {
  const std::vector<std::size_t> suspects = bad_;
  for (const std::size_t suspect : suspects) {
    if (bad_.size() == 1) break;
    const std::vector<std::size_t> before = bad_;
    std::erase(bad_, suspect);
    if (!agree(rest())) bad_ = before;
  }
  std::sort(bad_.begin(), bad_.end());
  const std::vector<View> good = rest();
  for (const std::size_t i : bad_) {
    std::vector<View> views = good;
    views.push_back(views_[i]);
    agreement_of_bad_.push_back(agreement(views).of_view.back());
  }
}

void Diagnosis::try_exchanges() const {
  for (const std::size_t i : bad_) {
    for (std::size_t j = 0; j < views_.size(); ++j) {
      if (i == j || bad_.size() > 2) continue;
      const bool are_bad = std::find(bad_.begin(), bad_.end(), j) != bad_.end();
      if (bad_.size() == 2 && !are_bad) continue;
      std::vector<View> views = views_;
      std::swap(views[i].camera, views[j].camera);
      if (!agree(views)) continue;
      throw InputError("the cameras of " + in_quotes(views_[std::min(i, j)].name) + " and " +
                       in_quotes(views_[std::max(i, j)].name) +
                       " look swapped: if they are exchanged, all views agree");
    }
  }
}

void Diagnosis::fail_for_bad() const {
  const std::string& worst = views_[agreement_.worst()].name;
  if (bad_.empty()) {
    throw InputError(ErrorKind::views_disagree,
                     "cameras and silhouettes disagree and may not belong together: the hull "
                     "covers " +
                         percent(agreement_.least()) + " of the silhouette of " + in_quotes(worst) +
                         ", and leaving out a few views does not help",
                     {.name = worst});
  }
  std::vector<std::string> names;
  for (const std::size_t i : bad_) names.push_back(views_[i].name);
  throw InputError(ErrorKind::few_views_disagree,
                   (names.size() == 1 ? "the view " : "the views ") + names_of(names) +
                       (names.size() == 1 ? " disagrees" : " disagree") +
                       " with the others: the hull covers " + percent(agreement_.least()) +
                       " of the silhouette of " + in_quotes(worst) +
                       " with them, and agrees with all others without them",
                   {.name = names[0]});
}

void check_least_agreement(const ViewCheckOptions& options) {
  if (!(options.least_agreement >= 0 && options.least_agreement <= 1))
    throw UsageError("the least agreement of views must be between 0 and 1");
}

}  // namespace

std::string in_words(const BadView& view) {
  return "the view '" + view.name + "' is left out: the hull of the others covers " +
         percent(view.agreement) + " of its silhouette";
}

ViewCheck check_views(std::vector<View>& views, const ViewCheckOptions& options,
                      const Progress& progress) {
  check_least_agreement(options);
  std::vector<View> seen;
  std::vector<std::size_t> place;  // index in `views` of each view that has a silhouette
  for (std::size_t i = 0; i < views.size(); ++i)
    if (!views[i].silhouette.empty()) place.push_back(i);
  if (place.size() < 2 || options.least_agreement == 0) return {};

  // At low resolution thin parts of the object may vanish, so that correct views disagree. Such
  // views are accepted by a second check at higher resolution.
  progress("check views");
  for (const std::size_t i : place)
    seen.push_back({views[i].name, views[i].camera, {}, views[i].silhouette});
  std::vector<View> small = shrunk_silhouettes(seen, coarse.side_px);
  Agreement agreement = agreement_of(small, coarse);
  const bool may_be_inverted = std::all_of(small.begin(), small.end(), [](const View& view) {
    return is_border_inside(view.silhouette);
  });
  if (may_be_inverted) Diagnosis(small, agreement, options, progress).try_inverted();
  if (agreement.least() >= options.least_agreement) return {agreement.least(), {}};
  const Agreement finer = agreement_of(shrunk_silhouettes(seen, fine.side_px), fine);
  if (finer.least() >= options.least_agreement) return {finer.least(), {}};

  Diagnosis diagnosis(std::move(small), std::move(agreement), options, progress);
  const std::vector<std::size_t> bad = diagnosis.run();
  ViewCheck result;
  for (std::size_t k = 0; k < bad.size(); ++k)
    result.dropped.push_back({views[place[bad[k]]].name, diagnosis.agreement_with_others()[k]});
  for (std::size_t k = bad.size(); k-- > 0;) {
    views.erase(views.begin() + static_cast<std::ptrdiff_t>(place[bad[k]]));
    seen.erase(seen.begin() + static_cast<std::ptrdiff_t>(bad[k]));
  }
  result.least_agreement = agreement_of(shrunk_silhouettes(seen, coarse.side_px), coarse).least();
  return result;
}

}  // namespace transformesh
