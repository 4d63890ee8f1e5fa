#include "reconstruction/convergence.h"

#include <algorithm>

#include "reconstruction/surface_doubt.h"
#include "support/number.h"

namespace transformesh {
namespace {

/// Tolerated decrease of the intersection over union of outlines and silhouettes. The outlines of
/// the initial mesh are inaccurate by about this much because its edges are long.
constexpr double agreement_lost = 0.005;
/// Largest accepted dissimilarity of photographs after subtraction of their noise (disagreement.h).
/// On true surfaces it is at most 0.09, on wrong surfaces 0.5. Right results of 33 generated scenes
/// had at most 0.16. The body of genus 7 in photographs of 100x75 had 0.196, with genus 0.
constexpr double most_disagreement = 0.18;
/// Largest accepted area of doubtful places, as a fraction of the observed area. Chosen to tolerate
/// small places that photographs do not confirm.
constexpr double most_doubtful = 0.03;
/// Largest accepted area of places where small windows disagree, as a fraction of the observed
/// area. Right results of 33 generated scenes had at most 1.0 %. Films across bores of 24 and 31
/// pixels had 1.8 to 5.2 %.
constexpr double most_doubtful_in_small = 0.015;
/// Largest accepted area of hidden places, as a fraction of the area of the mesh. Eleven right
/// results of generated scenes had none, and the dino of Middlebury 0.07 %. The bottom of a bowl
/// was 2.6 % of a surface up to 31 pixels wrong.
constexpr double most_hidden = 0.005;

std::string in_words_of(const SurfaceDoubt& doubt) {
  if (doubt.disagreement > most_disagreement)
    return "photographs disagree by " + fixed(doubt.disagreement, 2) +
           " beyond their noise, on a scale from 0 to 1; at most " +
           shortest_text(most_disagreement) + " is accepted";
  const auto& places = doubt.places;
  const auto handle = std::ranges::find_if(places, &DoubtfulPlace::has_handle);
  if (handle != places.end())
    return "photographs disagree all around a handle or tunnel at " + in_words(*handle);
  const auto thin = std::ranges::find_if(places, &DoubtfulPlace::is_thin);
  if (thin != places.end())
    return "photographs disagree on a thin sheet or fin around " + in_words(*thin);
  if (!doubt.unobserved_fins.empty())
    return "fewer than two photographs show a thin sheet or fin around " +
           in_words(doubt.unobserved_fins.front());
  if (doubt.hidden_share > most_hidden)
    return "other parts of the surface hide " + fixed(100 * doubt.hidden_share, 1) +
           " % of the surface from photographs, most around " +
           in_words(doubt.hidden_places.front());
  if (doubt.share > most_doubtful)
    return "photographs disagree on " + fixed(100 * doubt.share, 1) +
           " % of the surface, most around " + in_words(doubt.places.front());
  if (doubt.small_window_share > most_doubtful_in_small)
    return "small windows of photographs disagree on " + fixed(100 * doubt.small_window_share, 1) +
           " % of the surface, most around " + in_words(doubt.small_window_places.front());
  if (!doubt.filled_hollows.empty())
    return "photographs agree better if the surface is deeper around " +
           in_words(doubt.filled_hollows.front()) + ", perhaps because it fills a hole";
  return {};
}

}  // namespace

std::string ReconstructionFaults::in_words(const SurfaceEvidence& evidence) const {
  if (exploded_at > 0)
    return "the surface explodes at scale " + fixed(exploded_at, 4) +
           ": the photographs may be too small, or cameras, photographs and masks may not belong "
           "together";
  if (lost_at > 0)
    return "photographs can be compared on less of the surface after scale " + fixed(lost_at, 4) +
           " than before";
  if (!is_at_rest) return "the surface still moved in the last sweep";
  if (late_at > 0)
    return "components or handles still appeared or vanished at scale " + fixed(late_at, 4) +
           ", perhaps at thin sheets that no photograph shows";
  if (evidence.agreement < evidence.first_agreement - agreement_lost)
    return "the overlap of outline and silhouettes is " + fixed(evidence.agreement, 3) +
           ", less than that of the initial mesh, " + fixed(evidence.first_agreement, 3);
  return in_words_of(evidence.doubt);
}

}  // namespace transformesh
