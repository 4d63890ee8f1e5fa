#include "options/view_options.h"

#include <cmath>

#include "options/source_options.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "transformesh/image.h"
#include "views/cameras/view.h"
#include "views/cameras/view_files.h"
#include "views/hull/agreed_threshold.h"
#include "views/hull/silhouette.h"
#include "views/images/image_file.h"

namespace transformesh::tool {

std::optional<double> threshold_intensity(const std::string& threshold) {
  if (threshold == "auto") return std::nullopt;
  const Length intensity = parse_length(threshold);
  if (intensity.unit != Length::Unit::absolute || intensity.value < 1 || intensity.value > 254) {
    throw UsageError("--threshold: '" + threshold + "' is neither auto nor a number from 1 to 254");
  }
  return intensity.value;
}

double hull_share(const std::string& keep) {
  if (keep == "largest") return 1;
  if (keep == "all") return 0;
  const Length share = parse_length(keep);
  if (share.unit != Length::Unit::absolute || share.value < 0 || share.value > 1)
    throw UsageError("--keep: '" + keep + "' is neither largest, all nor a number from 0 to 1");
  return share.value;
}

void declare_view_check(Program& program, ViewCheckChoices& choices, ViewSources& sources) {
  program.options.number("least-agreement", &choices.least_agreement, 0, 1,
                         "share of every silhouette that the hull must cover; 0: no check");
  program.options.flag("drop-bad-views", &choices.drops_bad_views,
                       "leave out views that disagree with the others (default: refuse them)");
  declare_reading(program, sources);
}

ViewCheck check_views(std::vector<View>& views, const ViewCheckChoices& choices, Run& run) {
  ViewCheck check =
      check_views(views, {choices.least_agreement, choices.drops_bad_views}, run.progress());
  for (const BadView& view : check.dropped) run.note(in_words(view));
  return check;
}

void declare_silhouettes(Program& program, SilhouetteOptions& options) {
  program.options
      .text("cameras", &options.sources.cameras, "WHERE", "file, folder or pattern of the cameras")
      .is_needed = true;
  program.options.text("silhouettes", &options.sources.silhouettes, "WHERE",
                       "masks; pixels that are not black show the object");
  program.options.text("images", &options.sources.images, "WHERE",
                       "photographs of a bright object before a dark background, instead of masks");
  program.options.text("threshold", &options.threshold, "auto|LEVEL",
                       "intensity from 1 to 254 above which photographs show the object");
  program.options.number(
      "blur", &options.blur, 0, 100,
      "standard deviation of the blur of photographs before the threshold, in pixels");
  program.options.number(
      "close", &options.close, 0, 1,
      "close dark marks and gaps narrower than twice this share of the image's larger side");
  program.options.text("write-silhouettes", &options.masks, "FOLDER",
                       "also write the silhouettes to this folder, as NAME.png");
}

std::vector<View> views_with_silhouettes(const SilhouetteOptions& options, Run& run) {
  if (options.sources.silhouettes.empty() == options.sources.images.empty())
    throw UsageError("either --silhouettes or --images is needed");
  const ThresholdOptions threshold{threshold_intensity(options.threshold), options.blur,
                                   options.close};
  ViewSources sources = options.sources;
  sources.on_note = [&run](const std::string& text) { run.note(text); };
  std::vector<View> views = views_from(sources);
  if (!options.sources.images.empty())
    run.report("threshold", threshold_silhouettes(views, threshold, run.progress()));
  for (const View& view : views) {
    if (options.masks.empty()) break;
    const GrayImage mask = binary_silhouette(view.silhouette);
    run.out().write_into(options.masks, view.name + ".png", write_png(picture_of(mask)));
  }
  return views;
}

void write_outlines(const Mesh& mesh, const std::vector<View>& views, const std::string& folder,
                    Run& run) {
  for (const View& view : views)
    run.out().write_into(folder, view.name + ".png",
                         write_png(picture_of(mesh_silhouette(mesh, view))));
}

}  // namespace transformesh::tool
