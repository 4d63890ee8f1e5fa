#include "transformesh/events.h"

#include <array>

#include "evolution/loop/event_row.h"

namespace transformesh {
namespace {

std::string joined(const std::vector<LabeledVolume>& components, const auto& text_of) {
  std::string text;
  for (const LabeledVolume& component : components) {
    if (!text.empty()) text += ' ';
    text += text_of(component);
  }
  return text;
}

std::string label_of(const LabeledVolume& component) { return std::to_string(component.label); }

std::string volume_of(const LabeledVolume& component) { return significant(component.volume, 12); }

}  // namespace

std::string name_of(EventKind kind) {
  constexpr std::array names{
      "merge",         "split",        "handle opened", "handle closed", "component vanished",
      "cavity opened", "cavity closed"};
  return names.at(static_cast<std::size_t>(kind));
}

CsvRow event_row(const Event& event) {
  CsvRow row;
  row.count("iteration", event.iteration).number("time", event.time, 10);
  row.text("kind", name_of(event.kind));
  row.number("x", event.place.x(), 9).number("y", event.place.y(), 9);
  row.number("z", event.place.z(), 9).number("size", event.size);
  row.text("labels_before", joined(event.before, label_of));
  row.text("labels_after", joined(event.after, label_of));
  row.text("volumes_before", joined(event.before, volume_of));
  row.text("volumes_after", joined(event.after, volume_of));
  return row;
}

}  // namespace transformesh
