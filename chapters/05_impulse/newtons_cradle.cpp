// How many balls leave Newton's cradle?
//
// Five equal balls in a row, touching. Some come in from the left at 1 m/s. Four ways to let the
// contacts act: each once, from left to right or from right to left; all at once; and in rounds.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/impulse_3d.hpp"
#include "carom/impulse/linear_complementarity.hpp"
#include "carom/impulse/simultaneous_impacts.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::BodyContact;
using carom::MovingBody;
using carom::Real;
using carom::Vector3;
using Balls = std::vector<MovingBody>;

constexpr Real kRadius = 0.5;  // [m]
const Vector3 kRight = Vector3::UnitX();

Balls ballsOf(const std::vector<Real>& masses, const std::vector<Real>& speeds) {
  Balls balls;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const Real inertia = 0.4 * masses[i] * kRadius * kRadius;
    const carom::Matrix3 inverse = carom::Matrix3::Identity() / inertia;
    balls.push_back({{1 / masses[i], inverse}, {speeds[i] * kRight, Vector3::Zero()}});
  }
  return balls;
}

std::vector<BodyContact> contactsOf(const Balls& balls, Real restitution) {
  std::vector<BodyContact> contacts;
  for (int i = 0; i + 1 < static_cast<int>(balls.size()); ++i) {
    const carom::Contact contact{kRight, kRadius * kRight, -kRadius * kRight};
    contacts.push_back({i, i + 1, contact, {restitution, 0, 0}});
  }
  return contacts;
}

MovingBody& at(Balls& balls, int i) {
  return balls[static_cast<std::size_t>(i)];
}

void push(Balls& balls, const BodyContact& c, Real j) {
  changeVelocities(at(balls, c.bodyA), at(balls, c.bodyB), c.contact, j * c.contact.normal);
}

// Each contact once, in the order of the list.
void once(Balls& balls, const std::vector<BodyContact>& contacts) {
  for (const BodyContact& c : contacts) {
    const MovingBody &a = at(balls, c.bodyA), &b = at(balls, c.bodyB);
    push(balls, c, carom::impulse3d(a, b, c.contact, c.law.restitution));
  }
}

// All at once: impulses after which every contact parts at e times the
// speed of its approach. Every impulse changes three balls' worth of
// contacts, so they are unknowns of one system, M z = -(1 + e) u.
void together(Balls& balls, const std::vector<BodyContact>& contacts) {
  const int count = static_cast<int>(contacts.size());
  carom::DenseMatrix M(count, count);
  std::vector<Real> q;
  for (int i = 0; i < count; ++i) {
    const auto mass = [&](int ball) { return at(balls, ball).mass.inverseMass; };
    M(i, i) = mass(i) + mass(i + 1);
    if (i > 0) M(i, i - 1) = -mass(i);
    if (i + 1 < count) M(i, i + 1) = -mass(i + 1);
    const Real u = at(balls, i + 1).velocity.linear.x() - at(balls, i).velocity.linear.x();
    q.push_back((1 + contacts[static_cast<std::size_t>(i)].law.restitution) * u);
  }
  const auto found = carom::solveComplementarity(M, q);
  for (int i = 0; i < count; ++i) {
    push(balls, contacts[static_cast<std::size_t>(i)], found.z[static_cast<std::size_t>(i)]);
  }
}

//! [rounds]
// Only what approaches, again and again until nothing does.
void inRounds(Balls& balls, const std::vector<BodyContact>& contacts) {
  carom::simultaneousImpacts(balls, contacts);
}
//! [rounds]

void rightToLeft(Balls& balls, const std::vector<BodyContact>& contacts) {
  once(balls, {contacts.rbegin(), contacts.rend()});
}

using Way = std::pair<std::string, std::function<void(Balls&, const std::vector<BodyContact>&)>>;

carom::io::Table tableOf(std::size_t count) {
  carom::io::Table table;
  table.column("").column("contacts act");
  for (std::size_t i = 1; i <= count; ++i) {
    table.column(std::to_string(i), carom::io::fixed(2));
  }
  return table;
}

std::vector<carom::io::Cell> rowOf(const std::string& what, const std::string& how,
                                   const Balls& balls) {
  std::vector<carom::io::Cell> cells = {what, how};
  for (const MovingBody& ball : balls) cells.emplace_back(ball.velocity.linear.x());
  return cells;
}

// Pendulums of equal length swing in step, so all come through the middle at once.
void record(carom::io::Recording& recording, const std::string& name, std::vector<Real> speeds,
            const Way& way) {
  constexpr Real kHalfSwing = 1;  // [s]
  recording.beginCase(name);
  for (int swing = 0; swing < 6; ++swing) {
    for (int k = 0; k < 60; ++k) {
      carom::io::Frame frame{.time = swing * kHalfSwing + k * kHalfSwing / 60};
      const auto [s, c] = carom::sineCosine(std::numbers::pi * k / 60);
      for (std::size_t i = 0; i < speeds.size(); ++i) {
        const Real x = speeds[i] * s * kHalfSwing / std::numbers::pi;
        const Real middle = 2 * kRadius * (static_cast<Real>(i) - 2);
        frame.poses.push_back({Vector3(middle + 4 * x, 0, 1.6 * x * x), {}});
      }
      recording.addFrame(frame);
    }
    for (Real& speed : speeds) speed = -speed;
    Balls balls = ballsOf({1, 1, 1, 1, 1}, speeds);
    way.second(balls, contactsOf(balls, 1));
    for (std::size_t i = 0; i < speeds.size(); ++i) speeds[i] = balls[i].velocity.linear.x();
  }
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const std::vector<Way> ways = {{"from the left", once},
                                 {"from the right", rightToLeft},
                                 {"all at once", together},
                                 {"in rounds", inRounds}};
  std::cout << "Five equal balls, e = 1: speeds afterwards [m/s]\n\n";
  carom::io::Table table = tableOf(5);
  const std::vector<std::vector<Real>> starts = {
      {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 1, 1, 0, 0}, {1, 0, 0, 0, -1}, {2, 1, 0, 0, -1}};
  const std::vector<std::string> names = {"1 ball comes in", "2 balls", "3 balls",
                                          "1 from each side", "2 and 1 against -1"};
  for (std::size_t i = 0; i < starts.size(); ++i) {
    for (const auto& [name, act] : ways) {
      Balls balls = ballsOf({1, 1, 1, 1, 1}, starts[i]);
      act(balls, contactsOf(balls, 1));
      table.row(rowOf(name == ways.front().first ? names[i] : "", name, balls));
    }
  }
  std::cout << table << "\nIn rounds, other balls: speeds afterwards [m/s]\n\n";

  carom::io::Table others = tableOf(5);
  Balls halved = ballsOf({1, 0.5, 0.25, 0.125, 0.0625}, starts[0]);
  inRounds(halved, contactsOf(halved, 1));
  others.row(rowOf("each half as heavy", "in rounds", halved));
  Balls dull = ballsOf({1, 1, 1, 1, 1}, starts[0]);
  inRounds(dull, contactsOf(dull, 0.9));
  others.row(rowOf("e = 0.9", "in rounds", dull));
  std::cout << others;

  carom::io::Recording recording(
      "Newton's cradle",
      "Five balls hang in a row. As many as come in on one side leave on the "
      "other; with all contacts at once the whole row is set going.");
  recording.setView({.direction = Vector3(0, 1, -0.1)});
  recording.setParameter("balls in");
  for (int i = 1; i <= 5; ++i) {
    recording.addBody("ball " + std::to_string(i), carom::io::Ball{kRadius});
  }
  for (std::size_t i = 0; i < 3; ++i) record(recording, names[i], starts[i], ways[3]);
  record(recording, names[3], starts[3], ways[3]);
  record(recording, "1 ball, all at once", starts[0], ways[2]);
  recording.writeHtml(folder / "newtons_cradle.html");
}
