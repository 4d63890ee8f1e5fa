/// Numbers of things in messages.
#pragma once

#include <cstddef>
#include <string>

namespace transformesh {

/// "1 face", "2 faces"; "1 pass", "2 passes"; "1 vertex", "2 vertices".
std::string counted(std::size_t count, const std::string& noun);

/// "there is 1 face", "there are 2 faces".
std::string there_are(std::size_t count, const std::string& noun);

}  // namespace transformesh
