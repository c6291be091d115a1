// From a client's line to JSON.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace kerf::program {

// The object that the line is, of limited depth: copies and texts of it are made recursively, and a
// thread's stack has an end. Error: what is wrong with it.
tl::expected<nlohmann::ordered_json, std::string> request_object(std::string_view line);

}  // namespace kerf::program
