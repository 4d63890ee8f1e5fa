/// Settings of the C library's heap for programs that run for milliseconds. The heap is reserved at
/// once, with huge pages if possible. Page faults of small pages would take up to a quarter of the
/// time of cleaning a large mesh.
#pragma once

namespace transformesh::tool {

/// Reserves the heap. Must be called after the memory limit is set and before large allocations.
void prepare_memory();

/// Makes later large blocks separate mappings, which are returned to the system when they are
/// freed. For programs that run for a long time and need much memory at different times.
void give_large_blocks_back();

}  // namespace transformesh::tool
