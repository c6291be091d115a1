// The keys of a JSON object, each with what it may be.
#pragma once

#include <algorithm>
#include <cmath>
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
  // 1.0, 1e3 and -0 are whole, too. Nothing: it is none, or has more than 64 bits.
  static std::optional<std::uint64_t> whole_number(const Json& found) {
    constexpr double kEnd = 18446744073709551616.0;  // 2^64
    if (found.is_number_unsigned()) {
      return found.get<std::uint64_t>();
    }
    const double value = found.is_number() ? found.get<double>() : -1.0;
    return value >= 0.0 && value < kEnd && value == std::floor(value)
               ? std::optional(static_cast<std::uint64_t>(value))
               : std::nullopt;
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
    if (const auto number = whole_number(found)) {
      value = *number;
    } else {
      complain(key, "a whole number of 0 or more");
    }
  }
  void read_into(const char* key, const Json& found, BlockDelete& value) {
    const auto is_switch = [](const Json& found_number) {
      const std::uint64_t number = whole_number(found_number).value_or(0);
      return number >= 1 && number <= BlockDelete::kSwitches;
    };
    if (!found.is_array() || !std::ranges::all_of(found, is_switch)) {
      complain(key, "numbers from 1 to 9, as in [1, 3]");
      return;
    }
    for (const Json& number : found) {
      value.switch_on(static_cast<unsigned>(whole_number(number).value_or(0)));
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
