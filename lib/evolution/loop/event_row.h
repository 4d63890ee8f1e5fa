/// Writes events as rows of a CSV file. The first column is the number of the iteration, as in all
/// CSV files that a run records.
#pragma once

#include <string>

#include "evolution/loop/csv_row.h"
#include "transformesh/events.h"

namespace transformesh {

/// Returns the row of an event. Labels and volumes of several components are separated by spaces.
CsvRow event_row(const Event& event);

}  // namespace transformesh
