/// Settings of the C library's heap for programs that run for milliseconds. The heap is reserved at
/// once, and the system is asked for huge pages there. First touches of small pages would take up
/// to a quarter of the time of cleaning a large mesh.
#pragma once

namespace transformesh::tool {

/// Call before anything large is allocated, and after the limits of memory are set.
void prepare_memory();

/// From then on, the system provides each large block separately and gets it back when it is freed.
/// For programs that run for a long time and hold much memory at different times.
void give_large_blocks_back();

}  // namespace transformesh::tool
