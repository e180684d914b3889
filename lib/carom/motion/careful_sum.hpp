#pragma once
// How does a sum of a million small terms keep what rounding cuts off each of them?
//
// Method: add, find the rounding error exactly (Knuth's two-sum: it needs no comparison of sizes),
// and give it to the next term. The error of the whole is then that of one sum, not of a million.

namespace carom {

/// Adds a term to a sum that remembers what rounding has taken from it.
/// \tparam T a number or a vector of fixed size
/// \param sum is changed to sum + term, rounded [any unit]
/// \param lost what earlier additions have lost; is changed to what is lost now [the same unit]
/// \param term what to add [the same unit]
/// \ingroup motion
template <class T>
void addCarefully(T& sum, T& lost, const T& term) {
  const T wanted = term + lost;
  const T next = sum + wanted;
  const T taken = next - sum;
  lost = (sum - (next - taken)) + (wanted - taken);
  sum = next;
}

}  // namespace carom
