/// How a program takes memory from the system: rarely, blocks of medium size as a whole, and large
/// ones in huge pages where the system gives them, as first touches of small pages cost a sixth of
/// a large mesh's time. (Huge pages for medium blocks too were slower by half on a virtual machine
/// that hands unused memory back to its host.)
#pragma once

namespace transformesh::tool {

/// Before anything large is allocated.
void prepare_memory();

/// From here on each large block is taken from the system by itself and given back when it is not
/// needed any more: for programs that run for long and hold much, of which no more than that is to
/// count.
void give_large_blocks_back();

}  // namespace transformesh::tool
