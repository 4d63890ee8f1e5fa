/// Checks whether cameras and silhouettes agree, before a hull is computed from them.
///
/// The visual hull fills every silhouette if all views agree. In good sets of views the hull covers
/// at least three quarters of each silhouette; one bad view carves the hull in all others. If a
/// silhouette is covered less, common mistakes are tried, and the one after whose correction all
/// views agree is reported. These mistakes are a left-handed world, cameras that look along -z, and
/// inverted masks. Further ones are silhouettes shifted by one against the cameras, two swapped
/// cameras, and a few views that disagree with the rest.
///
/// Consistent mistakes are not detected. For example, a shift by one on a regular turntable only
/// rotates the object.
#pragma once

#include <string>
#include <vector>

#include "transformesh/control.h"
#include "views/cameras/view.h"

namespace transformesh {

struct ViewCheckOptions {
  /// Least silhouette_agreement() of every silhouette with the silhouette of the hull, in [0, 1]; 0
  /// disables the check. Good sets reach 0.75.
  double least_agreement = 0.7;
  /// If true, views that disagree with the rest are left out: at most a third, and at least three
  /// stay.
  bool drops_bad_views = false;
};

struct BadView {
  std::string name;
  double agreement = 0;  ///< fraction of its silhouette that the hull of the others covers
};

/// Returns "the view 'NAME' is left out: ..." with the agreement in percent.
std::string in_words(const BadView& view);

struct ViewCheck {
  double least_agreement = 1;    ///< least agreement of the remaining views
  std::vector<BadView> dropped;  ///< in input order
};

/// Checks the views that have a silhouette, and removes views that disagree if the options allow
/// it. Accepts fewer than two silhouettes without a check. Also accepts views that have no hull if
/// no mistake explains this, because their silhouettes may not bound the object. Throws InputError,
/// with the names of views, the mistake and its remedy. Throws UsageError if options are out of
/// range.
///
/// Shrinks silhouettes so that the object is at most 160 pixels large, and computes a hull of 64
/// cells. If this fails, repeats the check at twice the resolution, because thin parts may have
/// been lost. Takes 0.1 s of processor time for 16 views that agree, 1 to 3 s for others. Parallel;
/// the result does not depend on the number of threads.
ViewCheck check_views(std::vector<View>& views, const ViewCheckOptions& options = {},
                      const Progress& progress = {});

}  // namespace transformesh
