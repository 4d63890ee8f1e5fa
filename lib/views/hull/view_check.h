/// Checks whether cameras and silhouettes agree, before a hull is computed from them.
///
/// The visual hull fills every silhouette if all views agree. In good sets of views, the hull
/// covers at least three quarters of each silhouette. A single view with a wrong camera or mask
/// makes the hull too small for all other views. If the hull covers less of a silhouette,
/// corrections of common mistakes are tried. If all views agree after a correction, the mistake is
/// reported. The mistakes are a left-handed world, cameras that look along -z, and inverted masks.
/// Further mistakes are silhouettes shifted by one against the cameras, two swapped cameras, and a
/// few views that disagree with the rest.
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
  /// Least accepted intersection over union of a view's silhouette and that of the hull, in [0, 1];
  /// 0 disables the check. Good sets of views reach 0.75.
  double least_agreement = 0.7;
  /// True if views that disagree with the rest are left out instead of reported as an error. At
  /// most a third of the views is left out, and at least three views stay.
  bool drops_bad_views = false;
};

struct BadView {
  std::string name;
  /// Fraction of the view's silhouette that the hull of the other views covers.
  double agreement = 0;
};

/// Returns "the view 'NAME' is left out: ..." with the agreement in percent.
std::string in_words(const BadView& view);

struct ViewCheck {
  /// Least intersection over union, in the remaining views, of their silhouettes and that of their
  /// hull.
  double least_agreement = 1;
  std::vector<BadView> dropped;  ///< views that were left out, in input order
};

/// Checks the views that have a silhouette, and removes views that disagree if the options allow
/// it. Does not check fewer than two silhouettes. Accepts views without a common hull if no known
/// mistake explains this, because possibly only the box of the hull must be given. Throws
/// InputError if views disagree; the message contains the names of views, the mistake and its
/// remedy. Throws UsageError if options are out of range.
///
/// Shrinks silhouettes so that the object is at most 160 pixels large, and computes a hull with 64
/// cells along its longest side. If views disagree, repeats the check at twice the resolution,
/// because thin parts may have been lost. Takes 0.1 s of processor time for 16 views that agree, 1
/// to 3 s for others. Parallel; the result does not depend on the number of threads.
ViewCheck check_views(std::vector<View>& views, const ViewCheckOptions& options = {},
                      const Progress& progress = {});

}  // namespace transformesh
