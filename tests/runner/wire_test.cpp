// Does every kind of value come through the pipe unchanged, and does the reader survive every other message?

#include "grading/wire.hpp"

#include <limits>

#include "carom/core/real.hpp"
#include "grading/fields_motion.hpp"
#include "support/catch.hpp"

namespace carom_test {

enum class Side : int { left = -1, right = 1 };

struct Contact {
  carom::Vector3 point{0, 0, 0};
  std::vector<double> depths;
  std::optional<std::pair<int, std::string>> label;
  std::array<bool, 3> flags{};
  Side side = Side::left;
};

}  // namespace carom_test

namespace carom::grading {

template <>
struct Fields<carom_test::Contact> {
  using C = carom_test::Contact;
  static constexpr auto list = fieldList("point", &C::point, "depths", &C::depths, "label",
                                         &C::label, "flags", &C::flags, "side", &C::side);
};

}  // namespace carom::grading

using namespace carom::grading;
using carom_test::Contact;
using carom_test::Side;

namespace {

template <class T>
T throughTheWire(const T& value) {
  Writer w;
  w.put(value);
  Reader r{w.bytes};
  T back = r.take<T>();
  CHECK(r.bytes.empty());
  return back;
}

template <class T>
std::vector<double> numbers(const T& value) {
  std::vector<double> all;
  flatten(value, all);
  return all;
}

template <class T>
void isRefused(const std::string& bytes) {
  Reader r{bytes};
  CHECK_THROWS_AS(r.take<T>(), BrokenMessage);
}

std::string length(std::uint32_t count) {
  return {reinterpret_cast<const char*>(&count), sizeof count};
}

Contact someContact() {
  return {{1, -2, 0.1}, {0.5, 1e300}, {{7, "edge"}}, {true, false, true}, Side::right};
}

}  // namespace

TEST_CASE("numbers come through bit for bit") {
  for (const double x : {0.0, -0.0, 0.1, 5e-324, 1.7976931348623157e308}) {
    CHECK(std::bit_cast<std::uint64_t>(throughTheWire(x)) == std::bit_cast<std::uint64_t>(x));
  }
  CHECK(std::isnan(throughTheWire(std::numeric_limits<double>::quiet_NaN())));
  CHECK(throughTheWire(std::numeric_limits<std::int64_t>::min()) ==
        std::numeric_limits<std::int64_t>::min());
  CHECK(throughTheWire(true));
  CHECK_FALSE(throughTheWire(false));
  CHECK(throughTheWire(Side::right) == Side::right);
}

TEST_CASE("texts, lists, pairs and values that may be missing come through") {
  CHECK(throughTheWire(std::string("a\0b", 3)) == std::string("a\0b", 3));
  CHECK(throughTheWire(std::vector<std::vector<int>>{{1, 2}, {}, {3}}) ==
        std::vector<std::vector<int>>{{1, 2}, {}, {3}});
  CHECK(throughTheWire(std::optional<double>{}) == std::nullopt);
  CHECK(throughTheWire(std::optional<double>{2.5}) == 2.5);
  CHECK(throughTheWire(std::pair<int, bool>{3, true}) == std::pair<int, bool>{3, true});
  CHECK(throughTheWire(std::array<int, 3>{1, 2, 3}) == std::array<int, 3>{1, 2, 3});
}

TEST_CASE("matrices and structs come through") {
  carom::Matrix3 m;
  m << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  CHECK(throughTheWire(m) == m);
  CHECK(numbers(throughTheWire(someContact())) == numbers(someContact()));
  CHECK(numbers(throughTheWire(carom::Quaternion{1, 2, 3, 4})) == std::vector<double>{1, 2, 3, 4});
}

TEST_CASE("a state comes through with as many coordinates as it has") {
  const carom::State state = {carom::Vector3(1, -2, 0.1), carom::Vector3(0.5, 1e300, -0.0)};
  const carom::State back = throughTheWire(state);
  CHECK(back.position == state.position);
  CHECK(back.velocity == state.velocity);
  CHECK(throughTheWire(carom::Coordinates()).size() == 0);
  CHECK(show(state.position) == "(1, -2, 0.1)");
  CHECK(numbers(carom::State{carom::Coordinates::Zero(2), carom::Coordinates::Zero(1)}) !=
        numbers(carom::State{carom::Coordinates::Zero(1), carom::Coordinates::Zero(2)}));
  isRefused<carom::Coordinates>(length(0xffffffffu) + std::string(64, 'x'));
  isRefused<carom::Coordinates>(length(2) + std::string(15, 'x'));
}

TEST_CASE("a message that is cut anywhere is refused") {
  Writer w;
  w.put(someContact());
  for (std::size_t size = 0; size < w.bytes.size(); ++size) {
    INFO(size << " of " << w.bytes.size() << " bytes");
    isRefused<Contact>(w.bytes.substr(0, size));
  }
}

TEST_CASE("a length that the message cannot hold is refused before anything is allocated") {
  isRefused<std::string>(length(0xffffffffu));
  isRefused<std::string>(length(5) + "four");
  isRefused<std::vector<double>>(length(0xffffffffu) + std::string(64, 'x'));
  isRefused<std::vector<double>>(length(2) + std::string(15, 'x'));
  // Lists of lists: every inner length is looked at too.
  isRefused<std::vector<std::vector<double>>>(length(1) + length(0x7fffffffu));
  isRefused<std::vector<std::string>>(length(3) + length(0) + length(0));
  isRefused<std::vector<double>>("\x01");
}

TEST_CASE("odd bytes give an odd value, never an odd program") {
  Reader r{std::string_view("\x02", 1)};
  CHECK(r.take<bool>());
  const std::string there = std::string(1, '\xff') + std::string(8, '\0');
  Reader o{there};
  CHECK(o.take<std::optional<double>>() == 0.0);
  // Noise of every length, read as the most complicated type there is.
  std::uint32_t state = 1;
  for (int n = 0; n < 2000; ++n) {
    std::string noise;
    for (int i = 0; i < n % 97; ++i) {
      state = state * 1664525u + 1013904223u;
      noise += static_cast<char>(state >> 24);
    }
    Reader any{noise};
    try {
      const auto contact = any.take<Contact>();
      CHECK(contact.depths.size() <= noise.size());
    } catch (const BrokenMessage&) {
      SUCCEED();
    }
  }
}

TEST_CASE("numbers are shown in the shortest form that reads back, and odd ones in words") {
  CHECK(show(0.1) == "0.1");
  CHECK(show(1.0 / 3) == "0.3333333333333333");
  CHECK(show(-0.0) == "-0");
  CHECK(show(std::numeric_limits<double>::infinity()) == "infinity");
  CHECK(show(-std::numeric_limits<double>::infinity()) == "-infinity");
  CHECK_THAT(show(std::nan("")), carom_test::ContainsSubstring("not a number"));
  CHECK(show(true) == "true");
  CHECK(show(std::string("a")) == "\"a\"");
}

TEST_CASE("vectors, matrices, lists and structs are shown as one would write them") {
  CHECK(show(carom::Vector3(1, 2.5, -3)) == "(1, 2.5, -3)");
  Eigen::Matrix2d m;
  m << 1, 2, 3, 4;
  CHECK(show(m) == "[1, 2; 3, 4]");
  CHECK(show(carom::Quaternion{1, 0, 0, 0}) == "{w = 1, x = 0, y = 0, z = 0}");
  CHECK(show(std::vector<int>{1, 2}) == "{1, 2}");
  CHECK(show(std::vector<int>(20, 1)) == "{1, 1, 1, 1, 1, 1, 1, 1, ... 20 in all}");
  CHECK(show(std::optional<int>{}) == "none");
  CHECK(show(std::pair<int, double>{1, 0.5}) == "(1, 0.5)");
}

TEST_CASE("lists of different length never flatten to the same numbers") {
  using Lists = std::vector<std::vector<int>>;
  CHECK(numbers(Lists{{1}, {}}) != numbers(Lists{{}, {1}}));
  CHECK(numbers(Lists{{}}) != numbers(Lists{}));
  CHECK(numbers(std::optional<int>{0}) != numbers(std::optional<int>{}));
  CHECK(numbers(std::string("ab")) == std::vector<double>{2, 97, 98});
}
