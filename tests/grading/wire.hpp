#pragma once
// How does a value cross the pipe between the grader and a submission, and how is it printed and compared?
//
// Every type that an exercise takes or returns is made of numbers, text, fixed Eigen matrices, lists, and structs
// of these. One description of a struct's fields (Fields<T>) serves four jobs: writing to the wire, reading
// from it, printing it in a message, and flattening it to numbers for a comparison.
//
// The reader trusts nothing: the bytes come from a process that runs somebody else's code. Every length is
// checked against the bytes that are there before anything is allocated.

#include <Eigen/Core>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace carom::grading {

/// Bytes that do not decode to the value that was asked for.
class BrokenMessage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Description of a struct: specialise with `static constexpr auto list = fieldList("w", &Q::w, ...)`.
template <class T>
struct Fields;

template <class T>
concept Struct = requires {
  Fields<T>::list;
};

template <class M>
struct Field {
  const char* name;
  M member;
};

/// Pairs of a field's name and its pointer to member.
template <class... Rest>
constexpr auto fieldList(Rest... rest) {
  auto all = std::make_tuple(rest...);
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::make_tuple(Field<std::tuple_element_t<2 * I + 1, decltype(all)>>{
        std::get<2 * I>(all), std::get<2 * I + 1>(all)}...);
  }
  (std::make_index_sequence<sizeof...(Rest) / 2>{});
}

template <class T>
inline constexpr bool isVector = false;
template <class T>
inline constexpr bool isVector<std::vector<T>> = true;
template <class T>
inline constexpr bool isArray = false;
template <class T, std::size_t N>
inline constexpr bool isArray<std::array<T, N>> = true;
template <class T>
inline constexpr bool isOptional = false;
template <class T>
inline constexpr bool isOptional<std::optional<T>> = true;
template <class T>
inline constexpr bool isPair = false;
template <class A, class B>
inline constexpr bool isPair<std::pair<A, B>> = true;
template <class T>
inline constexpr bool isMatrix = std::is_base_of_v<Eigen::MatrixBase<T>, T>;

/// Collects the bytes of a message.
struct Writer {
  std::string bytes;

  void raw(const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  }

  template <class T>
  void put(const T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      raw(&value, sizeof value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      put(static_cast<std::uint32_t>(value.size()));
      raw(value.data(), value.size());
    } else if constexpr (isMatrix<T>) {
      static_assert(T::SizeAtCompileTime != Eigen::Dynamic, "exercises take fixed-size matrices");
      for (Eigen::Index i = 0; i < value.size(); ++i) put(value.data()[i]);
    } else if constexpr (isVector<T>) {
      put(static_cast<std::uint32_t>(value.size()));
      for (const auto& element : value) put(element);
    } else if constexpr (isArray<T>) {
      for (const auto& element : value) put(element);
    } else if constexpr (isOptional<T>) {
      put(static_cast<std::uint8_t>(value.has_value()));
      if (value) put(*value);
    } else if constexpr (isPair<T>) {
      put(value.first);
      put(value.second);
    } else {
      static_assert(Struct<T>, "describe this type with Fields<T>");
      std::apply([&](auto... field) { (put(value.*(field.member)), ...); }, Fields<T>::list);
    }
  }
};

/// Takes a message apart; every read is checked.
struct Reader {
  std::string_view bytes;

  void raw(void* data, std::size_t size) {
    if (bytes.size() < size) throw BrokenMessage("the answer ends too early");
    std::memcpy(data, bytes.data(), size);
    bytes.remove_prefix(size);
  }

  std::uint32_t length() {
    std::uint32_t count = 0;
    raw(&count, sizeof count);
    // Every element takes at least one byte, so a longer list cannot be in the message.
    if (count > bytes.size())
      throw BrokenMessage("the answer announces more elements than it holds");
    return count;
  }

  template <class T>
  void get(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t byte = 0;
      raw(&byte, 1);
      value = byte != 0;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      raw(&value, sizeof value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      value.resize(length());
      raw(value.data(), value.size());
    } else if constexpr (isMatrix<T>) {
      for (Eigen::Index i = 0; i < value.size(); ++i) get(value.data()[i]);
    } else if constexpr (isVector<T>) {
      const std::uint32_t count = length();
      value.clear();
      for (std::uint32_t i = 0; i < count; ++i) get(value.emplace_back());
    } else if constexpr (isArray<T>) {
      for (auto& element : value) get(element);
    } else if constexpr (isOptional<T>) {
      std::uint8_t there = 0;
      get(there);
      value.reset();
      if (there) get(value.emplace());
    } else if constexpr (isPair<T>) {
      get(value.first);
      get(value.second);
    } else {
      static_assert(Struct<T>, "describe this type with Fields<T>");
      std::apply([&](auto... field) { (get(value.*(field.member)), ...); }, Fields<T>::list);
    }
  }

  template <class T>
  T take() {
    T value{};
    get(value);
    return value;
  }
};

/// The shortest text that reads back as the same number; not-a-number and infinity spelled out.
std::string showNumber(double number);

/// A value as a reader of a message wants to see it. Long lists are cut short.
template <class T>
std::string show(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_floating_point_v<T>) {
    return showNumber(static_cast<double>(value));
  } else if constexpr (std::is_integral_v<T>) {
    return std::to_string(value);
  } else if constexpr (std::is_enum_v<T>) {
    return std::to_string(static_cast<long long>(value));
  } else if constexpr (std::is_convertible_v<T, std::string_view>) {
    return "\"" + std::string(std::string_view(value)) + "\"";
  } else if constexpr (isMatrix<T>) {
    std::string text = T::ColsAtCompileTime == 1 ? "(" : "[";
    for (Eigen::Index row = 0; row < value.rows(); ++row) {
      if (row) text += T::ColsAtCompileTime == 1 ? ", " : "; ";
      for (Eigen::Index col = 0; col < value.cols(); ++col) {
        text += (col ? ", " : "") + show(value(row, col));
      }
    }
    return text + (T::ColsAtCompileTime == 1 ? ")" : "]");
  } else if constexpr (isVector<T> || isArray<T>) {
    std::string text = "{";
    std::size_t shown = 0;
    for (const auto& element : value) {
      if (shown == 8) {
        text += ", ... " + std::to_string(value.size()) + " in all";
        break;
      }
      text += (shown++ ? ", " : "") + show(element);
    }
    return text + "}";
  } else if constexpr (isOptional<T>) {
    return value ? show(*value) : "none";
  } else if constexpr (isPair<T>) {
    return "(" + show(value.first) + ", " + show(value.second) + ")";
  } else {
    static_assert(Struct<T>, "describe this type with Fields<T>");
    std::string text = "{";
    std::apply(
        [&](auto... field) {
          ((text += (text.size() > 1 ? ", " : "") + std::string(field.name) + " = " +
                    show(value.*(field.member))),
           ...);
        },
        Fields<T>::list);
    return text + "}";
  }
}

/// The numbers in a value, in a fixed order. Lengths of lists are part of it, so that lists of different length
/// never compare equal; text is spelled out as character codes.
template <class T>
void flatten(const T& value, std::vector<double>& out) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    out.push_back(static_cast<double>(value));
  } else if constexpr (std::is_same_v<T, std::string>) {
    out.push_back(static_cast<double>(value.size()));
    for (const unsigned char c : value) out.push_back(c);
  } else if constexpr (isMatrix<T>) {
    for (Eigen::Index row = 0; row < value.rows(); ++row) {
      for (Eigen::Index col = 0; col < value.cols(); ++col) flatten(value(row, col), out);
    }
  } else if constexpr (isVector<T>) {
    out.push_back(static_cast<double>(value.size()));
    for (const auto& element : value) flatten(element, out);
  } else if constexpr (isArray<T>) {
    for (const auto& element : value) flatten(element, out);
  } else if constexpr (isOptional<T>) {
    out.push_back(value.has_value());
    if (value) flatten(*value, out);
  } else if constexpr (isPair<T>) {
    flatten(value.first, out);
    flatten(value.second, out);
  } else {
    static_assert(Struct<T>, "describe this type with Fields<T>");
    std::apply([&](auto... field) { (flatten(value.*(field.member), out), ...); }, Fields<T>::list);
  }
}

}  // namespace carom::grading
