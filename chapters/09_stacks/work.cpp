// What does a digit cost?
//
// Ten boxes in a tower, and a heavy one on a light one, cold. Four ways to find the impulses, counted
// in visits to a row, whatever is done there: sweeps, sweeps that give more than they are asked for,
// conjugate gradients, and elimination from the top down.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "carom/solver/active_rows.hpp"
#include "carom/solver/box_column.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using Reals = std::vector<Real>;

// Impulses so far, and what is told after each pass over all rows.
using Tell = std::function<void(int visits, const Reals& impulses)>;
constexpr int kMost = 200'000;  // visits; who is not done by then gives up

struct Problem {
  carom::BoxColumn column;
  Reals exact;  // the load of each row
};

Problem problemOf(const Reals& masses) {
  Problem problem{carom::boxColumn(masses), masses};
  carom::pullDown(problem.column.bodies, -1);
  for (std::size_t i = masses.size() - 1; i-- > 0;) problem.exact[i] += problem.exact[i + 1];
  return problem;
}

Reals impulsesOf(const carom::BoxColumn& column) {
  Reals all;
  for (const carom::ContactRow& row : column.rows) all.push_back(row.impulse);
  return all;
}

// Each visit gives `more` times what brings the row to rest.
void overrelax(Problem problem, Real more, const Tell& tell) {
  auto& [bodies, rows] = problem.column;
  const int n = static_cast<int>(rows.size());
  for (int visits = n; visits <= kMost; visits += n) {
    for (carom::ContactRow& row : rows) {
      const Real wrong = carom::partingSpeed(row, bodies);
      const Real total =
          std::max(Real(0), row.impulse - more * carom::rowMass(row, bodies) * wrong);
      carom::pushRow(row, total - row.impulse, bodies);
      row.impulse = total;
    }
    tell(visits, impulsesOf(problem.column));
  }
}

Real dot(const Reals& a, const Reals& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Hestenes and Stiefel 1952, for contacts of which none lets go.
void conjugateGradients(const Problem& problem, const Tell& tell) {
  const auto [A, b] = carom::rowProblem(problem.column.bodies, problem.column.rows);
  const std::size_t n = b.size();
  Reals x(n, 0), left(n), along(n), changed(n);
  for (std::size_t i = 0; i < n; ++i) along[i] = left[i] = -b[i];
  for (std::size_t pass = 1; pass <= 3 * n && dot(left, left) > 0; ++pass) {
    for (std::size_t i = 0; i < n; ++i) {
      changed[i] = 0;
      for (std::size_t j = 0; j < n; ++j) changed[i] += A[i * n + j] * along[j];
    }
    const Real old = dot(left, left), step = old / dot(along, changed);
    for (std::size_t i = 0; i < n; ++i) x[i] += step * along[i], left[i] -= step * changed[i];
    const Real keep = dot(left, left) / old;
    for (std::size_t i = 0; i < n; ++i) along[i] = left[i] + keep * along[i];
    tell(static_cast<int>(pass * n), x);
  }
}

// A matrix of three diagonals: down once to eliminate, up once to find.
void eliminate(const Problem& problem, const Tell& tell) {
  const auto [A, b] = carom::rowProblem(problem.column.bodies, problem.column.rows);
  const std::size_t n = b.size();
  Reals diagonal(n), right(n), x(n);
  //! [direct]
  for (std::size_t i = n; i-- > 0;) {
    diagonal[i] = A[i * n + i];
    right[i] = -b[i];
    if (i + 1 == n) continue;
    const Real share = A[i * n + i + 1] / diagonal[i + 1];
    diagonal[i] -= share * A[(i + 1) * n + i];
    right[i] -= share * right[i + 1];
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Real below = i > 0 ? A[i * n + i - 1] * x[i - 1] : 0;
    x[i] = (right[i] - below) / diagonal[i];
  }
  //! [direct]
  tell(static_cast<int>(2 * n), x);
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const Problem tower = problemOf(Reals(10, 1)), unlike = problemOf({1, 1000});
  const std::vector<std::pair<std::string, std::function<void(const Problem&, const Tell&)>>> ways =
      {{"sweeps", [](const Problem& p, const Tell& t) { overrelax(p, 1, t); }},
       {"overrelaxed, 1.73", [](const Problem& p, const Tell& t) { overrelax(p, 1.73, t); }},
       {"conjugate gradients", conjugateGradients},
       {"elimination", eliminate}};
  carom::io::Plot plot("What a digit costs: a tower of ten");
  plot.describe(
      "Errors over visits to a row. Sweeps fall slowly, overrelaxed ones much faster; "
      "conjugate gradients drop to nothing at a hundred visits, elimination is one point "
      "at twenty.");
  plot.xAxis("visits to a row", carom::io::Scale::Logarithmic);
  plot.yAxis("error / load", carom::io::Scale::Logarithmic).yRange(1e-13, 2).size(760, 440);
  carom::io::Table table;
  table.column("visits to a row for 1e-6").column("ten boxes").column("1 kg under 1000 kg");
  for (const auto& [name, way] : ways) {
    std::vector<carom::io::Cell> cells = {name};
    for (const Problem* problem : {&tower, &unlike}) {
      Reals visited, errors;
      int enough = 0;
      way(*problem, [&](int visits, const Reals& impulses) {
        Real error = 0;
        for (std::size_t i = 0; i < impulses.size(); ++i) {
          error = std::max(error, std::abs(impulses[i] - problem->exact[i]) / problem->exact[0]);
        }
        if (error <= 1e-6 && enough == 0) enough = visits;
        if (visits > 20'000) return;
        visited.push_back(visits);
        errors.push_back(std::max(error, 1e-13));
      });
      if (problem == &tower) {
        plot.curve(name, visited, errors, {.marks = visited.size() < 40});
      }
      cells.emplace_back(enough);
    }
    table.row(cells);
  }
  std::cout << table;
  plot.writeSvg(folder / "work.svg");
}
