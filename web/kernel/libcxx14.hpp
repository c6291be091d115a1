// What Debian 12's libc++ 14 for WebAssembly lacks of C++20, with the same meaning. The build
// includes it before each source.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>
#include <memory>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

// glibc's: "No such file or directory", the same in every locale, as this library's strerror().
inline const char* strerrordesc_np(int error) {
  return std::strerror(error);
}

namespace kerf::libcxx14 {

inline std::to_chars_result copied(char* first, char* last, const fmt::memory_buffer& text) {
  if (text.size() > static_cast<std::size_t>(last - first)) {
    return {last, std::errc::value_too_large};
  }
  std::memcpy(first, text.data(), text.size());
  return {first + text.size(), std::errc{}};
}

struct Less {
  template <typename A, typename B>
  constexpr bool operator()(const A& a, const B& b) const {
    return a < b;
  }
};

// An order of elements by their projections.
template <typename Compare, typename Projection>
constexpr auto by(Compare compare, Projection projection) {
  return [=](const auto& a, const auto& b) {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}

}  // namespace kerf::libcxx14

namespace std {  // NOLINT(cert-dcl58-cpp): these are its own names

template <typename To, typename From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

template <typename T>
unique_ptr<T> make_unique_for_overwrite() {
  return unique_ptr<T>(new T);
}

inline to_chars_result to_chars(char* first, char* last, double value, chars_format format,
                                int precision) {
  fmt::memory_buffer text;
  if (format == chars_format::fixed) {
    fmt::format_to(fmt::appender(text), "{:.{}f}", value, precision);
  } else {
    fmt::format_to(fmt::appender(text), "{:.{}g}", value, precision);
  }
  return kerf::libcxx14::copied(first, last, text);
}

// Fixed, with as few digits as tell the value from its neighbours.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format /*fixed*/) {
  constexpr int kMaxDecimals = 1100;  // of the smallest double
  for (int precision = 0; precision < kMaxDecimals; ++precision) {
    const to_chars_result written = to_chars(first, last, value, chars_format::fixed, precision);
    double read = 0.0;
    if (written.ec != errc{} || !isfinite(value) ||
        (fast_float::from_chars(first, written.ptr, read), read == value)) {
      return written;
    }
  }
  return {last, errc::value_too_large};
}

inline to_chars_result to_chars(char* first, char* last, double value) {
  fmt::memory_buffer text;
  fmt::format_to(fmt::appender(text), "{}", value);
  return kerf::libcxx14::copied(first, last, text);
}

inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format format = chars_format::general) {
  const auto read =
      fast_float::from_chars(first, last, value,
                             format == chars_format::fixed ? fast_float::chars_format::fixed
                                                           : fast_float::chars_format::general);
  const bool is_out_of_range = read.ec == errc{} && isinf(value);
  return {read.ptr, is_out_of_range ? errc::result_out_of_range : read.ec};
}

}  // namespace std

namespace std::ranges {  // NOLINT(cert-dcl58-cpp)

using Less = kerf::libcxx14::Less;

template <typename Iterator, typename Predicate>
constexpr Iterator find_if(Iterator first, type_identity_t<Iterator> last, Predicate predicate) {
  return std::find_if(first, last, predicate);
}
template <typename Range, typename Predicate, typename Projection = identity>
requires requires(Range& range) {
  std::begin(range);
}
constexpr auto find_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range), [&](const auto& element) {
    return std::invoke(predicate, std::invoke(projection, element));
  });
}
template <typename Range, typename Value, typename Projection = identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
  return ranges::find_if(
      range, [&](const auto& element) { return element == value; }, projection);
}
template <typename Range, typename Predicate>
constexpr bool all_of(Range&& range, Predicate predicate) {
  return std::all_of(std::begin(range), std::end(range),
                     [&](const auto& element) { return std::invoke(predicate, element); });
}
template <typename Range, typename Predicate>
constexpr bool any_of(Range&& range, Predicate predicate) {
  return std::any_of(std::begin(range), std::end(range),
                     [&](const auto& element) { return std::invoke(predicate, element); });
}
template <typename Range, typename Predicate>
constexpr auto count_if(Range&& range, Predicate predicate) {
  return std::count_if(std::begin(range), std::end(range), predicate);
}
template <typename Range, typename Compare, typename Projection = identity>
constexpr auto adjacent_find(Range&& range, Compare compare, Projection projection = {}) {
  return std::adjacent_find(std::begin(range), std::end(range),
                            kerf::libcxx14::by(compare, projection));
}

template <typename Iterator, typename Value, typename Compare = Less,
          typename Projection = identity>
constexpr Iterator lower_bound(Iterator first, type_identity_t<Iterator> last, const Value& value,
                               Compare compare = {}, Projection projection = {}) {
  return std::lower_bound(first, last, value, [&](const auto& element, const auto& sought) {
    return compare(std::invoke(projection, element), sought);
  });
}
template <typename Range, typename Value, typename Compare = Less, typename Projection = identity>
constexpr auto lower_bound(Range&& range, const Value& value, Compare compare = {},
                           Projection projection = {}) {
  return ranges::lower_bound(std::begin(range), std::end(range), value, compare, projection);
}
template <typename Iterator, typename Value, typename Compare = Less,
          typename Projection = identity>
constexpr Iterator upper_bound(Iterator first, type_identity_t<Iterator> last, const Value& value,
                               Compare compare = {}, Projection projection = {}) {
  return std::upper_bound(first, last, value, [&](const auto& sought, const auto& element) {
    return compare(sought, std::invoke(projection, element));
  });
}
template <typename Range, typename Value, typename Compare = Less, typename Projection = identity>
constexpr auto upper_bound(Range&& range, const Value& value, Compare compare = {},
                           Projection projection = {}) {
  return ranges::upper_bound(std::begin(range), std::end(range), value, compare, projection);
}

template <typename Range, typename Compare = Less, typename Projection = identity>
constexpr void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), kerf::libcxx14::by(compare, projection));
}
template <typename Range, typename Compare = Less, typename Projection = identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), kerf::libcxx14::by(compare, projection));
}
template <typename Range, typename Output>
constexpr auto copy(Range&& range, Output to) {
  return std::copy(std::begin(range), std::end(range), to);
}
template <typename First, typename Second, typename Output, typename Compare = Less,
          typename FirstProjection = identity, typename SecondProjection = identity>
constexpr auto merge(First&& first, Second&& second, Output to, Compare compare = {},
                     FirstProjection projection = {}, SecondProjection /*the same*/ = {}) {
  return std::merge(std::begin(first), std::end(first), std::begin(second), std::end(second), to,
                    kerf::libcxx14::by(compare, projection));
}

template <typename Iterator, typename Compare = Less, typename Projection = identity>
constexpr Iterator max_element(Iterator first, Iterator last, Compare compare = {},
                               Projection projection = {}) {
  return std::max_element(first, last, kerf::libcxx14::by(compare, projection));
}
template <typename Range, typename Compare = Less, typename Projection = identity>
constexpr auto max(const Range& range, Compare compare = {}, Projection projection = {}) {
  return *ranges::max_element(std::begin(range), std::end(range), compare, projection);
}
template <typename Element>
struct MinMax {
  Element min;
  Element max;
};
template <typename Range, typename Compare = Less, typename Projection = identity>
constexpr auto minmax(const Range& range, Compare compare = {}, Projection projection = {}) {
  const auto [min, max] = std::minmax_element(std::begin(range), std::end(range),
                                              kerf::libcxx14::by(compare, projection));
  return MinMax<std::decay_t<decltype(*min)>>{*min, *max};
}

}  // namespace std::ranges
