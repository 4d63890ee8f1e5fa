#include "views/cameras/camera_names.h"

#include <algorithm>

namespace transformesh {

void remove_common_folder(CameraList& list) {
  for (CameraRecord& record : list.cameras)
    std::replace(record.name.begin(), record.name.end(), '\\', '/');
  if (list.cameras.empty()) return;
  const std::string& first = list.cameras.front().name;
  std::size_t size = first.rfind('/') + 1;  // 0 if there is no folder
  for (const CameraRecord& record : list.cameras) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < size && i < record.name.size() && record.name[i] == first[i]; ++i)
      if (first[i] == '/') end = i + 1;
    size = end;
  }
  for (CameraRecord& record : list.cameras) record.name.erase(0, size);
}

}  // namespace transformesh
