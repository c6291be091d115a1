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
  using Json = nlohmann::ordered_json;
  constexpr int kDeepest = 64;
  if (line.empty()) {
    return tl::unexpected<std::string>("the line is empty");
  }
  if (depth_of(line) > kDeepest) {
    return tl::unexpected<std::string>("it is nested more than 64 deep");
  }
  try {
    Json json = Json::parse(line);
    if (json.is_object()) {
      return json;
    }
  } catch (const Json::out_of_range&) {
    return tl::unexpected<std::string>("a number is out of range");
  } catch (const Json::parse_error& error) {
    return tl::unexpected("it is no JSON: wrong at byte " + std::to_string(error.byte));
  }
  return tl::unexpected<std::string>("an object with a command is wanted");
}

}  // namespace kerf::program
