/// How camera files are refused, for tests of their formats.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "support/error.h"
#include "views/cameras/camera_file.h"

namespace transformesh::test {

/// The message that refuses the text, empty where it is read.
inline std::string refusal(const std::string& text) {
  try {
    parse_cameras(text, "some.txt");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Whether the message states `what` and ends with the line.
inline bool is_refused(const std::string& text, const std::string& what, int line) {
  const std::string message = refusal(text);
  INFO(message);
  const std::string place = "(some.txt line " + std::to_string(line) + ")";
  CHECK(message.ends_with(place));
  CHECK(message.find(what) != std::string::npos);
  return message.ends_with(place) && message.find(what) != std::string::npos;
}

}  // namespace transformesh::test
