// Names the kinds of events, and makes an event with its defaults.
#include <transformesh/events.h>

using namespace transformesh;

int main() {
  if (name_of(EventKind::merge) != "merge" || name_of(EventKind::split) != "split") return 1;
  if (name_of(EventKind::handle_closed) != "handle closed") return 1;
  const Event event;
  if (!event.before.empty() || !event.after.empty() || event.place != Vec3::Zero()) return 1;
  return std::string(component_label) == "component_label" ? 0 : 1;
}
