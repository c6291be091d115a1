#include "programs/kerf/control/request_text.hpp"

#include <algorithm>
#include <cstddef>

namespace kerf::program {

namespace {

// Of what is no JSON it means nothing.
int depth_of(std::string_view line) {
  int depth = 0;
  int deepest = 0;
  bool is_in_string = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (is_in_string) {
      i += c == '\\' ? 1 : 0;
      is_in_string = c != '"';
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    } else {
      is_in_string = c == '"';
    }
  }
  return deepest;
}

}  // namespace

tl::expected<nlohmann::ordered_json, std::string> request_object(std::string_view line) {
  constexpr int kDeepest = 64;
  if (depth_of(line) > kDeepest) {
    return tl::unexpected<std::string>("it is nested more than 64 deep");
  }
  auto json = nlohmann::ordered_json::parse(line, nullptr, false);
  if (!json.is_object()) {
    return tl::unexpected<std::string>("an object with a command is wanted");
  }
  return json;
}

}  // namespace kerf::program
