#include "corpus/chains/verdict.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace chains {
namespace {

using Json = nlohmann::json;

bool is_one_of(const std::string& name, const std::set<std::string>& names) {
  return names.contains(name);
}

bool has(const Step& step, const std::string& word) {
  return std::find(step.arguments.begin(), step.arguments.end(), word) != step.arguments.end();
}

/// Returns a count of the report: a number, the length of a list, or the count in an object.
std::size_t reported(const Json& report, const std::string& key) {
  const Json& result = report.contains("result") ? report["result"] : report;
  if (!result.is_object() || !result.contains(key)) return 0;
  const Json& value = result[key];
  if (value.is_number()) return value.get<std::size_t>();
  if (value.is_array()) return value.size();
  if (value.is_object())
    for (const char* name : {"count", "components"})
      if (value.contains(name) && value[name].is_number()) return value[name].get<std::size_t>();
  return 0;
}

class Judge {
 public:
  explicit Judge(const Passage& passage)
      : is_(passage), report_(Json::parse(passage.report, nullptr, false)) {}

  std::vector<Finding> findings() {
    check_indices();
    if (report_.is_discarded()) note("report", "is no JSON");
    if (!is_.after.is_valid()) return findings_;
    check_surface();
    check_borders();
    check_components();
    check_volume();
    check_measures();
    check_counts();
    return findings_;
  }

 private:
  template <typename... Parts>
  void note(const std::string& kind, const Parts&... parts) {
    std::string text;
    const auto add = [&](const auto& part) {
      if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>)
        text += Json(part).dump();
      else
        text += part;
    };
    (add(parts), ...);
    findings_.push_back({kind, text});
  }

  const std::string& program() const { return is_.step.program; }

  void check_indices() {
    if (is_.after.bad_indices > 0) note("index", is_.after.bad_indices, " faces with bad indices");
    if (is_.after.bad_coordinates > 0)
      note("coordinates", is_.after.bad_coordinates, " points that are not finite");
  }

  /// Checks that there is no intersection and no face without area, and that the mesh is a
  /// manifold.
  void check_surface() {
    const bool always = is_one_of(program(), {"clean", "offset", "evolve", "morph"});
    const bool as_input = is_one_of(program(), {"remesh", "fill", "select"});
    if ((always || (as_input && is_.before.intersections == 0)) && is_.after.intersections > 0)
      note("intersects", is_.after.intersections, " intersecting pairs");
    // tm-remesh reports which parts of its input it could not remove.
    const std::size_t kept = is_.before.no_area > 0 ? reported(report_, "faces_without_area") : 0;
    if ((always || program() == "remesh" || (as_input && is_.before.no_area == 0)) &&
        is_.after.no_area > kept)
      note("no-area", is_.after.no_area, " faces without area");
    const bool makes = is_one_of(program(), {"clean", "offset", "stitch"});
    if ((makes || is_.before.is_manifold()) && !is_.after.is_manifold() &&
        !is_one_of(program(), {"cat", "select"}))
      note("not-manifold", is_.after.bad_edges, " edges and ", is_.after.bad_vertices, " vertices");
  }

  void check_borders() {
    if (program() == "convert" && has(is_.step, "stl")) return;
    if (is_.step.program == "select") return;
    const bool joins = is_one_of(program(), {"clean", "stitch"});
    const bool was_closed = joins ? is_.before.unpaired_places == 0 : is_.before.is_closed();
    const std::size_t left =
        reported(report_, "left_crossing") + reported(report_, "left_too_large");
    const bool must_close = was_closed || (program() == "fill" && left == 0);
    if (must_close && !is_.after.is_closed()) note("open", is_.after.open_edges, " open edges");
  }

  void check_components() {
    if (!is_.before.is_sound()) return;
    std::size_t expected = is_.before.components;
    const std::size_t dropped =
        std::max(reported(report_, "components_removed"), reported(report_, "components_dropped"));
    if (is_one_of(program(), {"remesh", "displace", "morph-step", "transform"}) ||
        (program() == "clean" && is_.was_cleaned && is_.before.is_closed() &&
         !has(is_.step, "--outermost")))
      expected -= std::min(expected, dropped);
    else
      return;
    if (is_.after.components != expected)
      note("components", is_.after.components, " components of ", is_.before.components,
           ", reported as dropped: ", dropped);
  }

  /// Returns the change of volume that rounding may cause: a movement of a thousand spacings at
  /// every vertex.
  double volume_tolerance() const {
    const double spacing = (is_.coarsest == Type::float32 ? 0x1p-23 : 0x1p-52) *
                           std::max(largest_coordinate(is_.input), largest_coordinate(is_.output));
    return 1000 * spacing * (is_.before.area + is_.after.area) + 1e-9 * std::abs(is_.after.volume);
  }

  void check_volume() {
    if (!is_.volume || !is_.after.is_closed()) return;
    if (std::abs(is_.after.volume - *is_.volume) > volume_tolerance())
      note("volume", "volume ", is_.after.volume, " instead of ", *is_.volume);
  }

  void check_measures() {
    // tm-offset cleans first, so the volume of a self-intersecting input is not comparable.
    if (program() == "offset" && is_.before.intersections == 0 && !grows_as_asked())
      note("volume", "volume ", is_.after.volume, " from ", is_.before.volume);
    if (!is_.step.keeps_measures || !is_.is_flat || !is_.before.is_closed()) return;
    const auto differs = [](double a, double b) { return std::abs(a - b) > 1e-3 * std::abs(b); };
    if (differs(is_.after.volume, is_.before.volume))
      note("volume", "volume ", is_.after.volume, " from ", is_.before.volume, " at edges of 2 %");
    if (differs(is_.after.area, is_.before.area))
      note("area", "area ", is_.after.area, " from ", is_.before.area, " at edges of 2 %");
  }

  bool grows_as_asked() const {
    const bool inwards = is_.step.arguments.front().find("=-") != std::string::npos;
    return inwards ? is_.after.volume < is_.before.volume : is_.after.volume > is_.before.volume;
  }

  void check_counts() {
    if (is_one_of(program(),
                  {"transform", "convert", "displace", "morph-step", "intersect", "carry"}) &&
        is_.after.faces != is_.before.faces)
      note("faces", is_.after.faces, " faces of ", is_.before.faces);
    if (program() == "intersect" && reported(report_, "pairs") != is_.before.intersections)
      note("count", "reports ", reported(report_, "pairs"), " pairs of ", is_.before.intersections);
  }

  const Passage& is_;
  Json report_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> find_faults(const Passage& passage) { return Judge(passage).findings(); }

}  // namespace chains
