// The keys of a JSON object, each with what it may be.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <kerf/kernel.hpp>
#include <nlohmann/json.hpp>

namespace kerf::program {

// Reads the keys of a request; what is wrong with the first wrong one stays.
class RequestKeys {
 public:
  using Json = nlohmann::ordered_json;  // in the order in which they are set

  explicit RequestKeys(const Json& object) : object_(object) {}

  template <typename T>
  void read(const char* key, T& value) {
    if (const Json* found = take(key)) {
      read_into(key, *found, value);
    }
  }
  [[nodiscard]] bool has(const char* key) const { return object_.contains(key); }
  [[nodiscard]] std::string complaint() const {
    if (!complaint_.empty()) {
      return complaint_;
    }
    return object_.size() > taken_ ? "a key that does not belong to the command" : "";
  }

 private:
  const Json* take(const char* key) {
    const auto found = object_.find(key);
    taken_ += found != object_.end() ? 1U : 0U;
    return found != object_.end() ? &*found : nullptr;
  }
  void complain(const char* key, const char* wanted) {
    if (complaint_.empty()) {
      complaint_ = std::string(key) + " is to be " + wanted;
    }
  }
  void read_into(const char* key, const Json& found, std::optional<double>& value) {
    if (found.is_number()) {
      value = found.get<double>();
    } else {
      complain(key, "a number");
    }
  }
  void read_into(const char* key, const Json& found, std::optional<std::uint64_t>& value) {
    read_into(key, found, value.emplace());
  }
  void read_into(const char* key, const Json& found, bool& value) {
    if (found.is_boolean()) {
      value = found.get<bool>();
    } else {
      complain(key, "true or false");
    }
  }
  void read_into(const char* key, const Json& found, std::uint64_t& value) {
    if (found.is_number_unsigned()) {
      value = found.get<std::uint64_t>();
    } else {
      complain(key, "a whole number of 0 or more");
    }
  }
  void read_into(const char* key, const Json& found, BlockDelete& value) {
    const auto is_switch = [](const Json& number) {
      return number.is_number_unsigned() && number.get<std::uint64_t>() >= 1 &&
             number.get<std::uint64_t>() <= BlockDelete::kSwitches;
    };
    if (!found.is_array() || !std::ranges::all_of(found, is_switch)) {
      complain(key, "numbers from 1 to 9, as in [1, 3]");
      return;
    }
    for (const Json& number : found) {
      value.switch_on(number.get<unsigned>());
    }
  }
  void read_into(const char* key, const Json& found, std::string& value) {
    if (found.is_string()) {
      value = found.get<std::string>();
    } else {
      complain(key, "a string");
    }
  }

  const Json& object_;
  std::size_t taken_ = 0;
  std::string complaint_;
};

}  // namespace kerf::program
