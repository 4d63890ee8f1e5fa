/// Whether cameras and silhouettes agree with each other, before they are believed.
///
/// The visual hull covers each silhouette where all views agree on the object. Good sets cover at
/// least three quarters of every silhouette; one bad view carves the object in all others. Where
/// some silhouette is covered less, the explanations that are tried are those of mistakes which are
/// often made, and the one after which all views agree is reported: a left-handed world, cameras
/// that look along -z, inverted masks, silhouettes shifted by one against the cameras, two cameras
/// swapped, and a few views that disagree with the rest.
///
/// What is consistent cannot be found: a shift by one on a regular turntable turns the object.
#pragma once

#include <string>
#include <vector>

#include "transformesh/control.h"
#include "views/cameras/view.h"

namespace transformesh {

struct ViewCheckOptions {
  /// [0, 1]: of every silhouette with that of the hull, as silhouette_agreement() has it; at 0
  /// views are believed without a look.
  double least_agreement = 0.7;
  /// Views that disagree with the rest are left out, up to a third and as long as three agree.
  bool drops_bad_views = false;
};

struct BadView {
  std::string name;
  double agreement = 0;  ///< with the hull of the others
};

/// Returns "the view 'NAME' is left out: ..." with the agreement in percent.
std::string in_words(const BadView& view);

struct ViewCheck {
  double least_agreement = 1;    ///< of the views that are left
  std::vector<BadView> dropped;  ///< in the order in which they were left out
};

/// Takes views that disagree out of `views` where that is wanted. Views without silhouette are
/// passed over; fewer than two with one are believed, and so are those that have no hull for which
/// there is no explanation: their silhouettes may not bound the object. Throws InputError that
/// names views and says what is wrong and what to do, and UsageError for options out of range.
///
/// Looks at silhouettes made smaller, the object to 160 pixels, and hulls of 64 cells, then at
/// twice as fine ones where thin parts may be lost. 0.1 s of computing for 16 views that agree, 1
/// to 3 s for others. Parallel; the same for any number of threads.
ViewCheck check_views(std::vector<View>& views, const ViewCheckOptions& options = {},
                      const Progress& progress = {});

}  // namespace transformesh
