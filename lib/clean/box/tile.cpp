#include "clean/box/tile.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr std::string_view tile_key = "tm:tile ";
constexpr std::string_view cleaned_key = "tm:cleaned-tile ";

const std::string* find(const std::vector<std::string>& comments, std::string_view key) {
  const auto found = std::find_if(comments.begin(), comments.end(),
                                  [&](const std::string& line) { return line.starts_with(key); });
  return found == comments.end() ? nullptr : &*found;
}

bool is_tile_comment(const std::string& line) {
  return line.starts_with(tile_key) || line.starts_with(cleaned_key);
}

void add(const Vec3& point, std::string& text) {
  for (const double x : point) text += ' ' + shortest_text(x);
}

std::string text_of(const TileName& name) {
  return std::to_string(name.number) + ' ' + std::to_string(name.count) + ' ' +
         std::to_string(name.mesh);
}

class Words {
 public:
  Words(const std::string& comment, std::string_view key)
      : comment_(comment), words_(comment.substr(key.size())) {}

  template <class Number>
  Number next() {
    std::string word;
    words_ >> word;
    const auto number = number_in<Number>(word);
    if (!number) fail();
    return *number;
  }
  Vec3 next_point() {
    Vec3 point;
    for (double& x : point) x = next<double>();
    return point;
  }
  TileName next_name() {
    TileName name;
    name.number = next<std::size_t>();
    name.count = next<std::size_t>();
    name.mesh = next<std::uint64_t>();
    if (name.number >= name.count) fail();
    return name;
  }
  void end() {
    std::string word;
    if (words_ >> word) fail();
  }

 private:
  [[noreturn]] void fail() const {
    throw InputError("the comment '" + comment_ + "' does not describe a tile");
  }

  const std::string& comment_;
  std::istringstream words_;
};

}  // namespace

std::string tile_comment(const Tile& tile) {
  std::string text = std::string(tile_key) + text_of(tile.name) + ' ' + std::to_string(tile.faces);
  for (const Box& box : {tile.own, tile.held}) {
    add(box.min(), text);
    add(box.max(), text);
  }
  add(tile.reference.position, text);
  text += ' ' + std::to_string(tile.reference.winding) + ' ' + shortest_text(tile.cell_size);
  return text + (tile.coordinate == Scalar::float32 ? " 32" : " 64");
}

std::string cleaned_tile_comment(const TileName& name) {
  return std::string(cleaned_key) + text_of(name);
}

std::optional<Tile> tile_of(const std::vector<std::string>& comments) {
  const std::string* comment = find(comments, tile_key);
  if (comment == nullptr) return std::nullopt;
  Words words(*comment, tile_key);
  Tile tile;
  tile.name = words.next_name();
  tile.faces = words.next<std::uint64_t>();
  for (Box* box : {&tile.own, &tile.held}) {
    box->min() = words.next_point();
    box->max() = words.next_point();
  }
  tile.reference.position = words.next_point();
  tile.reference.winding = words.next<int>();
  tile.cell_size = words.next<double>();
  tile.coordinate = words.next<int>() == 32 ? Scalar::float32 : Scalar::float64;
  words.end();
  return tile;
}

std::optional<TileName> cleaned_tile_of(const std::vector<std::string>& comments) {
  const std::string* comment = find(comments, cleaned_key);
  if (comment == nullptr) return std::nullopt;
  Words words(*comment, cleaned_key);
  const TileName name = words.next_name();
  words.end();
  return name;
}

bool has_tile_comment(const std::vector<std::string>& comments) {
  return std::any_of(comments.begin(), comments.end(), is_tile_comment);
}

void drop_tile_comments(std::vector<std::string>& comments) {
  std::erase_if(comments, is_tile_comment);
}

}  // namespace transformesh
