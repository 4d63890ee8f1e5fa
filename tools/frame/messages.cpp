#include "frame/messages.h"

namespace transformesh::tool {

void Messages::note_all(const std::vector<std::string>& lines) const {
  for (const std::string& line : lines) note(line);
}

void Messages::note_all(const std::vector<Problem>& warnings) const {
  for (const Problem& warning : warnings) note(warning);
}

void Messages::note_once(const std::vector<std::string>& lines) {
  for (const std::string& line : lines)
    if (noted_.insert(line).second) note(line);
}

}  // namespace transformesh::tool
