/// How a program takes memory from the system: rarely, and large blocks in huge pages where the
/// system gives them, as first touches of small pages cost a sixth of a large mesh's time.
#pragma once

namespace transformesh::tool {

/// Before anything large is allocated.
void prepare_memory();

}  // namespace transformesh::tool
