#pragma once
// How does a program print a table that is the same on every machine?
//
// A column has a title that carries the unit, and one notation for all its numbers. Numbers are
// rounded by std::to_chars, so neither the locale nor the C library has a say; a result that rounds
// to zero has no sign. What a table cannot do is make an unstable figure stable: print as many
// digits as the method gives, no more.

#include <cstdint>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "carom/core/real.hpp"

namespace carom::io {

/// How the numbers of a column are written. Made by fixed(), scientific(), significant().
/// \ingroup io
struct Notation {
  /// The kinds of notation.
  enum class Kind {
    Fixed,        ///< 3.142
    Scientific,   ///< 3.142e+00
    Significant,  ///< 3.14, 3.14e-09: whichever is shorter
  };
  Kind kind = Kind::Significant;  ///< which kind
  int digits = 6;  ///< digits behind the point; significant digits for Kind::Significant
};

/// A given count of digits behind the point: fixed(3) writes 3.142.
/// \param digits digits behind the point, 0 to 60
/// \return the notation
/// \ingroup io
Notation fixed(int digits);

/// A mantissa with a given count of digits behind the point: scientific(1) writes 3.1e+00.
/// \param digits digits behind the point, 0 to 60
/// \return the notation
/// \ingroup io
Notation scientific(int digits);

/// A given count of significant digits: significant(3) writes 3.14.
/// \param digits significant digits, 1 to 60
/// \return the notation
/// \ingroup io
Notation significant(int digits);

/// What stands in a table: a number, a whole number or a word. \ingroup io
class Cell {
 public:
  /// A number, written in the notation of its column. \param value the number
  Cell(Real value) : content_(value) {}
  /// A whole number, written in full. \param value the number
  Cell(int value) : content_(std::int64_t{value}) {}
  /// A whole number, written in full. \param value the number
  Cell(long value) : content_(std::int64_t{value}) {}
  /// A whole number, written in full. \param value the number
  Cell(long long value) : content_(std::int64_t{value}) {}
  /// A count, written in full. \param value the number
  Cell(std::size_t value) : content_(static_cast<std::int64_t>(value)) {}
  /// A word. \param text the word
  Cell(std::string text) : content_(std::move(text)) {}
  /// A word. \param text the word
  Cell(const char* text) : content_(std::string(text)) {}

  /// The text of the cell.
  /// \param notation how to write a number
  /// \return the text
  std::string text(const Notation& notation) const;

  /// Whether the cell is a word, which is set to the left, or a number, which is set to the right.
  /// \return true for a word
  bool isWord() const;

 private:
  std::variant<Real, std::int64_t, std::string> content_;
};

/// A text table. Declare the columns, add rows, print. \ingroup io
class Table {
 public:
  /// Adds a column. Call before the first row.
  /// \param title what the column holds, with its unit: "height [m]"
  /// \param notation how its numbers are written
  /// \return this table, for chaining
  /// \throws InvalidInput when a row has been added already
  Table& column(std::string title, Notation notation = {});

  /// Adds a row.
  /// \param cells as many as there are columns
  /// \return this table, for chaining
  /// \throws InvalidInput when the count is not that of the columns
  Table& row(std::vector<Cell> cells);

  /// The table as lines of text, each ending in a newline: titles, a rule, rows. Columns are two
  /// spaces apart, numbers end at the right edge of their column, words start at the left edge; no
  /// spaces at the line's end.
  /// \return the text, UTF-8
  std::string text() const;

 private:
  std::vector<std::string> titles_;
  std::vector<Notation> notations_;
  std::vector<std::vector<Cell>> rows_;
};

/// Prints a table.
/// \param out where to
/// \param table what
/// \return out
/// \ingroup io
std::ostream& operator<<(std::ostream& out, const Table& table);

}  // namespace carom::io
