#include "carom/precision/cubic_roots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"
#include "carom/precision/exact_sum.hpp"

namespace carom {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr int kDegree = 3;

// Times a power of two so that the largest is about 2^600: products with x, x^2 and x^3 stay finite,
// and what falls below the smallest double is 2^-1600 of the largest coefficient.
std::array<Real, 4> scaled(std::array<Real, 4> c) {
  Real largest = 0;
  for (const Real x : c) largest = std::max(largest, std::abs(x));
  if (largest == 0) return c;
  const int by = 600 - std::ilogb(largest);
  for (Real& x : c) x = std::scalbn(x, by);
  return c;
}

// How often term i counts in the k-th derivative divided by k!: i over k.
constexpr Real kBinomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};

struct Value {
  Real value = 0;
  Real error = 0;  // at most
};

// The k-th derivative divided by k!, so that its values are the coefficients about x.
struct Derivative {
  const std::array<Real, 4>& c;
  int k = 0;

  // Horner's rule, and the same with absolute values for the error: two roundings per term and one
  // for the binomial; the bound counts two more.
  Value rounded(Real x) const {
    Real value = 0, size = 0;
    for (int i = kDegree; i >= k; --i) {
      const Real term = kBinomial[i][k] * c[static_cast<std::size_t>(i)];
      value = value * x + term;
      size = size * std::abs(x) + std::abs(term);
    }
    return {value, 9 * 0x1p-53 * size};
  }

  Real exact(Real x) const {
    ExactSum sum;
    for (int i = k; i <= kDegree; ++i) {
      const Real coefficient = c[static_cast<std::size_t>(i)];
      Real weight = kBinomial[i][k];
      for (Real part = 2; part >= 1; part /= 2) {  // 3 c would be rounded, 2 c and c are not
        if (weight < part) continue;
        weight -= part;
        const Real t = part * coefficient;
        switch (i - k) {
          case 0:
            sum.add(t);
            break;
          case 1:
            sum.addProduct(t, x, 1);
            break;
          case 2:
            sum.addProduct(t, x, x);
            break;
          default:
            sum.addProduct(t, x, x, x);
            break;
        }
      }
    }
    return sum.value();
  }

  int sign(Real x) const {
    const Value v = rounded(x);
    if (std::abs(v.value) > v.error && v.error > 1e-250) return v.value > 0 ? 1 : -1;
    const Real e = exact(x);
    // Below this, products have lost digits: counted as a root, 2^-1550 of the coefficients.
    if (std::abs(e) < 0x1p-950) return 0;
    return e > 0 ? 1 : -1;
  }

  // Whether it can be 0 between two doubles at which its sign is the same: no, if it changes by
  // less than its value there, which its coefficients about `low` say.
  bool mayTouch(Real low, Real high) const {
    const Real width = high - low;
    Real change = 0;
    for (int j = kDegree; j > k; --j) {
      const Value v = Derivative{c, j}.rounded(low);
      change = change * width + kBinomial[j][k] * (std::abs(v.value) + v.error);
    }
    change *= width;
    return !(std::abs(exact(low)) > 2 * change);
  }
};

// Shrinks [low, high], at whose ends the signs differ, to neighbouring doubles. Newton's method
// comes near, mostly from one side; the other side is then drawn in by doubled steps.
RootBracket shrunk(const Derivative& p, Real low, Real high, int signOfLow) {
  const Derivative slope{p.c, p.k + 1};
  const Real scale = p.k + 1;  // derivatives are divided by k!
  Real x = low / 2 + high / 2;
  int reach = 0;
  while (std::nextafter(low, kInfinity) < high) {
    if (!(x > low && x < high)) x = low / 2 + high / 2;
    if (!(x > low && x < high)) x = std::nextafter(low, kInfinity);  // halves may round to the ends
    const int sign = p.sign(x);
    if (sign == 0) return {x, x};
    const bool below = sign == signOfLow;
    (below ? low : high) = x;
    const Real step = -p.rounded(x).value / (scale * slope.rounded(x).value);
    const Real ulp = std::nextafter(std::abs(x), kInfinity) - std::abs(x);
    if (std::abs(step) <= 4 * ulp) {
      x += (below ? 1 : -1) * std::ldexp(ulp, std::min(reach++, 60));
    } else if (std::isfinite(step) && reach < 8) {
      x += step;
      reach += std::abs(step) > (high - low) / 2;  // too often: halve instead
    } else {
      x = low / 2 + high / 2;
    }
  }
  return {low, high};
}

CubicRoots rootsOf(const Derivative& p, Real from, Real to) {
  CubicRoots found;
  if (p.k == kDegree) return found;  // a constant: its roots divide nothing
  const CubicRoots extrema = rootsOf(Derivative{p.c, p.k + 1}, from, to);

  const auto enter = [&found](const RootBracket& root) {
    const bool again = found.count > 0 && root.low == root.high &&
                       found.roots[static_cast<std::size_t>(found.count - 1)].high == root.low;
    if (!again) found.roots[static_cast<std::size_t>(found.count++)] = root;
  };
  Real low = from;
  int sign = p.sign(low);
  if (sign == 0) enter({low, low});
  // Goes on to x; up to there the polynomial is monotone, or x is the next double.
  const auto advance = [&](Real x, bool monotone) {
    if (x <= low) return;
    const int next = p.sign(x);
    if (sign * next < 0) {
      enter(shrunk(p, low, x, sign));
    } else if (next == 0) {
      enter({x, x});
    } else if (sign != 0 && !monotone && p.mayTouch(low, x)) {
      enter({low, x, false});
    }
    low = x, sign = next;
  };
  for (int i = 0; i < extrema.count; ++i) {
    const RootBracket& extremum = extrema.roots[static_cast<std::size_t>(i)];
    advance(extremum.low, true);
    advance(extremum.high, false);
  }
  advance(to, true);
  return found;
}

}  // namespace

CubicRoots cubicRoots(const std::array<Real, 4>& coefficients, Real from, Real to) {
  constexpr const char* kNames[] = {"c0", "c1", "c2", "c3"};
  for (std::size_t i = 0; i < 4; ++i) requireFinite(coefficients[i], kNames[i]);
  if (!(std::abs(from) <= 0x1p100)) reject("from", toText(from), "must be within 2^100");
  if (!(std::abs(to) <= 0x1p100)) reject("to", toText(to), "must be within 2^100");
  if (from > to) reject("to", toText(to), "must not be below from = " + toText(from));
  const std::array<Real, 4> c = scaled(coefficients);
  if (std::all_of(c.begin(), c.end(), [](Real x) { return x == 0; })) return {0, true, {}};
  return rootsOf(Derivative{c, 0}, from, to);
}

}  // namespace carom
