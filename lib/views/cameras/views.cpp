#include "transformesh/views.h"

#include <utility>

#include "transformesh/errors.h"
#include "views/cameras/view.h"
#include "views/cameras/view_files.h"

namespace transformesh {

Views::Views() : Views(std::vector<View>()) {}
Views::Views(std::vector<View> views)
    : views_(std::make_unique<std::vector<View>>(std::move(views))) {}
Views::Views(Views&&) noexcept = default;
Views& Views::operator=(Views&&) noexcept = default;
Views::~Views() = default;

void Views::add(const std::string& name, const PinholeCamera& camera, GrayImage photograph,
                GrayImage silhouette) {
  const bool has_both = !photograph.empty() && !silhouette.empty();
  if (has_both && (photograph.width != silhouette.width || photograph.height != silhouette.height))
    throw UsageError("view '" + name + "': the silhouette differs in size from the photograph");
  views_->push_back({name, camera, std::move(photograph), std::move(silhouette)});
}

std::size_t Views::size() const { return views_->size(); }

const std::string& Views::name(std::size_t view) const { return views_->at(view).name; }

const PinholeCamera& Views::camera(std::size_t view) const { return views_->at(view).camera; }

Views read_views(const ViewSources& sources) { return Views(views_from(sources)); }

}  // namespace transformesh
