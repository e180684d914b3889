#include "carom_io/table.hpp"

#include <algorithm>

#include "carom/core/errors.hpp"
#include "carom_io/number_text.hpp"

namespace carom::io {

namespace {

Notation checked(Notation::Kind kind, int digits, int fewest) {
  if (digits < fewest || digits > 60) {
    throw InvalidInput("a notation with " + std::to_string(digits) + " digits: must be " +
                       std::to_string(fewest) + " to 60");
  }
  return {kind, digits};
}

// Columns are as wide as what one sees, not as the bytes: a UTF-8 continuation byte (10xxxxxx)
// takes no room.
std::size_t widthOnScreen(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
  }));
}

std::string padded(const std::string& text, std::size_t width, bool toTheLeft) {
  const std::string spaces(width - widthOnScreen(text), ' ');
  return toTheLeft ? text + spaces : spaces + text;
}

}  // namespace

Notation fixed(int digits) {
  return checked(Notation::Kind::Fixed, digits, 0);
}

Notation scientific(int digits) {
  return checked(Notation::Kind::Scientific, digits, 0);
}

Notation significant(int digits) {
  return checked(Notation::Kind::Significant, digits, 1);
}

std::string Cell::text(const Notation& notation) const {
  if (const std::string* word = std::get_if<std::string>(&content_)) return *word;
  if (const std::int64_t* whole = std::get_if<std::int64_t>(&content_))
    return std::to_string(*whole);
  const Real number = std::get<Real>(content_);
  switch (notation.kind) {
    case Notation::Kind::Fixed:
      return roundedText(number, std::chars_format::fixed, notation.digits);
    case Notation::Kind::Scientific:
      return roundedText(number, std::chars_format::scientific, notation.digits);
    case Notation::Kind::Significant:
      break;
  }
  return roundedText(number, std::chars_format::general, notation.digits);
}

bool Cell::isWord() const {
  return std::holds_alternative<std::string>(content_);
}

Table& Table::column(std::string title, Notation notation) {
  if (!rows_.empty()) {
    throw InvalidInput("column '" + title + "': all columns must be declared before the first row");
  }
  titles_.push_back(std::move(title));
  notations_.push_back(notation);
  return *this;
}

Table& Table::row(std::vector<Cell> cells) {
  if (cells.size() != titles_.size()) {
    throw InvalidInput("a row with " + std::to_string(cells.size()) + " cells: the table has " +
                       std::to_string(titles_.size()) + " columns");
  }
  rows_.push_back(std::move(cells));
  return *this;
}

std::string Table::text() const {
  const std::size_t columns = titles_.size();
  std::vector<std::size_t> width(columns);
  std::vector<bool> words(columns, !rows_.empty());
  for (std::size_t c = 0; c < columns; ++c) {
    width[c] = widthOnScreen(titles_[c]);
    for (const std::vector<Cell>& cells : rows_) {
      width[c] = std::max(width[c], widthOnScreen(cells[c].text(notations_[c])));
      words[c] = words[c] && cells[c].isWord();
    }
  }

  std::string result;
  const auto addLine = [&](const auto& textOfColumn) {
    std::string line;
    for (std::size_t c = 0; c < columns; ++c) {
      if (c > 0) line += "  ";
      line += padded(textOfColumn(c), width[c], words[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + '\n';
  };
  addLine([&](std::size_t c) { return titles_[c]; });
  addLine([&](std::size_t c) { return std::string(width[c], '-'); });
  for (const std::vector<Cell>& cells : rows_) {
    addLine([&](std::size_t c) { return cells[c].text(notations_[c]); });
  }
  return result;
}

std::ostream& operator<<(std::ostream& out, const Table& table) {
  return out << table.text();
}

}  // namespace carom::io
