// Report entries (names and values for reports and Python) of flows.
#include "entries/entries.h"
#include "flow/flow_columns.h"
#include "transformesh/flow.h"

namespace transformesh {

Entries entries_of(const FlowSpeeds& speeds) {
  return {{"max_speed", speeds.maximum}, {"rms_speed", speeds.rms}};
}

Entries entries_of(const FlowCounts& counts) {
  return {{"outside", counts.outside}, {"fixed", counts.fixed}};
}

}  // namespace transformesh
