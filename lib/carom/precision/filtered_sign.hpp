#pragma once
// What does a predicate answer?

namespace carom {

/// A sign beyond doubt, and how it was found. \ingroup precision
struct FilteredSign {
  int sign = 0;          ///< -1, 0 or 1, exactly
  bool filtered = true;  ///< whether the rounded value settled it; if not, exact numbers had to
};

}  // namespace carom
