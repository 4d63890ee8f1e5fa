/// The exit codes of every program. 124 to 127 and 137 stay free for timeout and the shell.
#pragma once

namespace transformesh::tool {

inline constexpr int exit_done = 0;  ///< for a predicate: yes
inline constexpr int exit_no = 1;    ///< predicates only
inline constexpr int exit_usage = 2;
inline constexpr int exit_input = 3;
inline constexpr int exit_goal = 4;
inline constexpr int exit_output = 5;
inline constexpr int exit_memory = 6;
inline constexpr int exit_signal = 128;  ///< plus the signal's number

}  // namespace transformesh::tool
