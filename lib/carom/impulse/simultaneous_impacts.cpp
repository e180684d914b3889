#include "carom/impulse/simultaneous_impacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/impulse/bounded_impact.hpp"
#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/linear_complementarity.hpp"
#include "carom/impulse/passive_impact.hpp"

namespace carom {

namespace {

using Numbers = std::span<const int>;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

bool movable(const MovingBody& body) {
  return body.mass.inverseMass > 0 || body.mass.inverseInertia.cwiseAbs().maxCoeff() > 0;
}

// The bodies and contacts of one call.
class Scene {
 public:
  Scene(std::span<MovingBody> bodies, std::span<const BodyContact> contacts, bool stopsSlip,
        ImpactMemory& memory)
      : bodies_(bodies), contacts_(contacts), memory_(memory), stopsSlip_(stopsSlip) {}

  int count() const {
    return static_cast<int>(contacts_.size());
  }

  const BodyContact& contact(int i) const {
    return contacts_[at(i)];
  }

  // u . n of a contact.
  Real parting(int i) const {
    const BodyContact& c = contact(i);
    return relativeVelocity(bodies_[at(c.bodyA)], bodies_[at(c.bodyB)], c.contact)
        .dot(c.contact.normal);
  }

  // What rounding can leave of a speed at this contact that should be zero.
  Real rounding(int i) const {
    const BodyContact& c = contact(i);
    const auto speed = [](const MovingBody& body, const Vector3& arm) {
      return body.velocity.linear.norm() + body.velocity.angular.norm() * arm.norm();
    };
    constexpr Real kShare = 16 * std::numeric_limits<Real>::epsilon();
    return kShare * (speed(bodies_[at(c.bodyA)], c.contact.armA) +
                     speed(bodies_[at(c.bodyB)], c.contact.armB));
  }

  // How much a unit impulse at contact j changes the parting speed at contact i.
  Real coupling(int i, int j) const {
    const BodyContact &p = contact(i), &q = contact(j);
    Real sum = 0;
    if (p.bodyA == q.bodyA) sum += through(p.bodyA, p.contact.armA, p, q.contact.armA, q);
    if (p.bodyB == q.bodyB) sum += through(p.bodyB, p.contact.armB, p, q.contact.armB, q);
    if (p.bodyA == q.bodyB) sum -= through(p.bodyA, p.contact.armA, p, q.contact.armB, q);
    if (p.bodyB == q.bodyA) sum -= through(p.bodyB, p.contact.armB, p, q.contact.armA, q);
    return sum;
  }

  void push(int i, const Vector3& impulse) {
    const BodyContact& c = contact(i);
    changeVelocities(bodies_[at(c.bodyA)], bodies_[at(c.bodyB)], c.contact, impulse);
  }

  // Coulomb's friction at one contact that had a normal impulse: against the slip, at most to a
  // stop.
  void rub(int i, Real normalImpulse) {
    const BodyContact& c = contact(i);
    if (c.law.friction == 0 || normalImpulse == 0) return;
    const Vector3 u = relativeVelocity(bodies_[at(c.bodyA)], bodies_[at(c.bodyB)], c.contact);
    const Vector3 slip = u - u.dot(c.contact.normal) * c.contact.normal;
    const Real speed = slip.norm();
    if (speed <= rounding(i)) return;
    BodyContact along = c;  // the same place, seen along the slip
    along.contact.normal = slip / speed;
    const Real inverseMass = through(c.bodyA, c.contact.armA, along, c.contact.armA, along) +
                             through(c.bodyB, c.contact.armB, along, c.contact.armB, along);
    if (!(inverseMass > 0)) return;
    const Real size = std::min(speed / inverseMass, c.law.friction * normalImpulse);
    push(i, -size * along.contact.normal);
  }

  // A contact that is alone, with friction.
  Real hit(int i) {
    const BodyContact& c = contact(i);
    return strike(bodies_[at(c.bodyA)], bodies_[at(c.bodyB)], c.contact, c.law)
        .dot(c.contact.normal);
  }

  // Whether contacts are points of one area: of the same two bodies, along one normal.
  bool isArea(Numbers group) const {
    const BodyContact& first = contact(group[0]);
    return std::all_of(group.begin(), group.end(), [&](int i) {
      const BodyContact& c = contact(i);
      return c.bodyA == first.bodyA && c.bodyB == first.bodyB &&
             c.contact.normal == first.contact.normal && c.law.friction == first.law.friction;
    });
  }

  // Contacts of one area, with friction: as one contact at the centre of their pressure, which is
  // the same along the normal. What is left of the cone brakes the turning about it.
  void hitArea(Numbers group, const std::vector<Real>& stopping, Real restitution,
               std::vector<Real>& sums) {
    Real pressed = 0;
    for (const Real z : stopping) pressed += z;
    if (!(pressed > 0)) return;
    const BodyContact& first = contact(group[0]);
    Contact centre{first.contact.normal, Vector3::Zero(), Vector3::Zero()};
    for (std::size_t i = 0; i < group.size(); ++i) {
      centre.armA += stopping[i] / pressed * contact(group[i]).contact.armA;
      centre.armB += stopping[i] / pressed * contact(group[i]).contact.armB;
    }
    MovingBody &a = bodies_[at(first.bodyA)], &b = bodies_[at(first.bodyB)];
    const Vector3 impulse = strike(a, b, centre, {restitution, first.law.friction, 0});
    const Real along = impulse.dot(centre.normal);
    const Real across = (impulse - along * centre.normal).norm();
    for (std::size_t i = 0; i < group.size(); ++i) {
      const Real share = stopping[i] / pressed;
      sums[at(group[i])] += share * along;
      rub(group[i], share * std::max(Real(0), along - across / first.law.friction));
    }
  }

  // Sorts contacts into groups that are joined by bodies which can move. Returns how many.
  std::size_t sortIntoGroups(Numbers active) {
    std::vector<int>& roots = memory_.roots;
    roots.resize(bodies_.size());
    std::iota(roots.begin(), roots.end(), 0);
    for (const int i : active) {
      const int a = contact(i).bodyA, b = contact(i).bodyB;
      if (movable(bodies_[at(a)]) && movable(bodies_[at(b)])) roots[at(rootOf(a))] = rootOf(b);
    }
    const auto rootOfContact = [&](int i) {
      const int a = contact(i).bodyA;
      return rootOf(movable(bodies_[at(a)]) ? a : contact(i).bodyB);
    };
    // Groups are numbered as they come; contacts keep their order in them.
    std::vector<int>& starts = memory_.starts;
    starts.clear();
    memory_.groupOfRoot.assign(roots.size(), -1);
    for (const int i : active) {
      int& group = memory_.groupOfRoot[at(rootOfContact(i))];
      if (group < 0) {
        group = static_cast<int>(starts.size());
        starts.push_back(0);
      }
      ++starts[at(group)];
    }
    std::exclusive_scan(starts.begin(), starts.end(), starts.begin(), 0);
    memory_.members.resize(active.size());
    for (const int i : active) {
      int& place = starts[at(memory_.groupOfRoot[at(rootOfContact(i))])];
      memory_.members[at(place++)] = i;
    }
    return starts.size();
  }

  // Each group ends where its last contact was put.
  Numbers group(std::size_t number) const {
    const int begin = number == 0 ? 0 : memory_.starts[number - 1], end = memory_.starts[number];
    return Numbers(memory_.members).subspan(at(begin), at(end - begin));
  }

  ImpactMemory& memory() {
    return memory_;
  }

 private:
  // One contact with friction. Returns its impulse on B.
  Vector3 strike(MovingBody& a, MovingBody& b, const Contact& contact, const ImpactLaw& law) const {
    const Impact impact =
        stopsSlip_ ? boundedImpact(a, b, contact, law) : passiveImpact(a, b, contact, law);
    changeVelocities(a, b, contact, impact.impulse);
    return impact.impulse;
  }

  // n_p . K n_q, of the part of K that goes through one body.
  Real through(int body, const Vector3& armP, const BodyContact& p, const Vector3& armQ,
               const BodyContact& q) const {
    const BodyMass& mass = bodies_[at(body)].mass;
    return mass.inverseMass * p.contact.normal.dot(q.contact.normal) +
           cross(armP, p.contact.normal).dot(mass.inverseInertia * cross(armQ, q.contact.normal));
  }

  int rootOf(int body) {
    std::vector<int>& roots = memory_.roots;
    while (roots[at(body)] != body) {
      roots[at(body)] = roots[at(roots[at(body)])];
      body = roots[at(body)];
    }
    return body;
  }

  std::span<MovingBody> bodies_;
  std::span<const BodyContact> contacts_;
  ImpactMemory& memory_;
  bool stopsSlip_;
};

// Speeds nearer to each other than this share count as equal: blows that mirror each other must
// stay together although rounding has set them apart by some hundred ulp.
constexpr Real kEqualSpeeds = 1e-9;

// The contacts of a group that act together: from the fastest down, all that do not work against
// one that was taken before. Where two contacts press a body against each other the faster one goes
// first; equally fast ones, which no order can be right for, go together.
Numbers firstOf(Scene& scene, Numbers members) {
  std::vector<int>&group = scene.memory().order, &taken = scene.memory().taken;
  group.assign(members.begin(), members.end());
  // Their numbers decide between equals: a sort that is stable takes memory.
  std::sort(group.begin(), group.end(), [&](int i, int j) {
    const Real p = scene.parting(i), q = scene.parting(j);
    return p != q ? p < q : i < j;
  });
  taken.clear();
  for (std::size_t i = 0; i < group.size();) {
    const Real speed = scene.parting(group[i]);
    const std::size_t before = taken.size();
    for (; i < group.size() && scene.parting(group[i]) <= speed * (1 - kEqualSpeeds); ++i) {
      const int candidate = group[i];
      const auto against = [&](int j) {
        const Real own = std::sqrt(scene.coupling(candidate, candidate) * scene.coupling(j, j));
        return scene.coupling(candidate, j) < -kEqualSpeeds * own;
      };
      const auto end = taken.begin() + static_cast<std::ptrdiff_t>(before);
      if (std::none_of(taken.begin(), end, against)) taken.push_back(candidate);
    }
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

// Whether contacts depend on each other: elimination of W leaves nothing for one of them.
bool redundant(const DenseMatrix& before, DenseMatrix& W) {
  constexpr Real kNothing = 1e-9;  // of what an entry started as: far above rounding
  W = before;
  for (int k = 0; k < W.rows(); ++k) {
    if (!(W(k, k) > kNothing * before(k, k))) return true;
    for (int i = k + 1; i < W.rows(); ++i) {
      const Real factor = W(i, k) / W(k, k);
      for (int j = k + 1; j < W.rows(); ++j) W(i, j) -= factor * W(k, j);
    }
  }
  return false;
}

// Of all impulses that stop a redundant group the evenest: the four legs of a table carry alike.
// Each contact gives way a little, which has one solution; then what that falls short of is added.
// Three times, each making the error a million times smaller, is enough. Returns false if pivoting
// fails.
bool findEvenImpulses(ImpactMemory& memory) {
  constexpr Real kGivesWay = 1e-6;
  const DenseMatrix& W = memory.couplings;
  DenseMatrix& softened = memory.softened;
  softened = W;
  for (int i = 0; i < W.rows(); ++i) softened(i, i) *= 1 + kGivesWay;
  std::vector<Real>& z = memory.impulses;
  z.assign(memory.speeds.size(), 0);
  for (int round = 0; round < 3; ++round) {
    std::vector<Real>& q = memory.bent;
    q = memory.speeds;
    for (int i = 0; i < W.rows(); ++i) q[at(i)] -= kGivesWay * W(i, i) * z[at(i)];
    solveComplementarity(softened, q, memory.searching, memory.solution);
    if (memory.solution.status != ComplementarityStatus::solved) return false;
    z = memory.solution.z;
  }
  return true;
}

// The least impulses that stop all contacts of a group. If pivoting fails, which takes contacts
// that rounding makes contradict each other, only the fastest is stopped: that is right for itself.
const std::vector<Real>& stoppingImpulses(Scene& scene, Numbers group) {
  const int n = static_cast<int>(group.size());
  ImpactMemory& memory = scene.memory();
  DenseMatrix& W = memory.couplings;
  std::vector<Real>& u = memory.speeds;
  W.reset(n, n);
  u.resize(group.size());
  for (int i = 0; i < n; ++i) {
    u[at(i)] = scene.parting(group[at(i)]);
    for (int j = 0; j <= i; ++j) W(i, j) = W(j, i) = scene.coupling(group[at(i)], group[at(j)]);
  }
  std::vector<Real>& z = memory.impulses;
  if (redundant(W, memory.softened) && findEvenImpulses(memory)) return z;
  solveComplementarity(W, u, memory.searching, memory.solution);
  if (memory.solution.status == ComplementarityStatus::solved) {
    z = memory.solution.z;
    return z;
  }
  z.assign(group.size(), 0);
  const auto fastest = std::min_element(u.begin(), u.end());
  const int i = static_cast<int>(fastest - u.begin());
  if (W(i, i) > 0) z[at(i)] = -*fastest / W(i, i);
  return z;
}

void check(std::span<const MovingBody> bodies, std::span<const BodyContact> contacts) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    requireUsable(bodies[i], ("bodies[" + std::to_string(i) + "]").c_str());
  }
  for (const BodyContact& c : contacts) {
    for (const int body : {c.bodyA, c.bodyB}) {
      if (body < 0 || at(body) >= bodies.size()) {
        reject("contact body", std::to_string(body), "names no body");
      }
    }
    if (c.bodyA == c.bodyB) reject("contact body", std::to_string(c.bodyA), "touches itself");
    requireUsable(c.contact);
    requireUsable(c.law);
  }
}

// One round over the given contacts; e is that of the contacts, or 0.
void reflect(Scene& scene, Numbers group, bool plastic, std::vector<Real>& sums) {
  if (group.size() == 1 && !plastic) {
    sums[at(group[0])] += scene.hit(group[0]);
    return;
  }
  const std::vector<Real>& z = stoppingImpulses(scene, group);
  Real e = plastic ? 0 : 1;
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (z[i] > 0) e = std::min(e, scene.contact(group[i]).law.restitution);
  }
  if (!plastic && scene.contact(group[0]).law.friction > 0 && scene.isArea(group)) {
    scene.hitArea(group, z, e, sums);
    return;
  }
  for (std::size_t i = 0; i < group.size(); ++i) {
    const Real size = (1 + e) * z[i];
    if (size == 0) continue;
    scene.push(group[i], size * scene.contact(group[i]).contact.normal);
    sums[at(group[i])] += size;
  }
  if (plastic) return;
  for (std::size_t i = 0; i < group.size(); ++i) scene.rub(group[i], (1 + e) * z[i]);
}

}  // namespace

void reserve(ImpactMemory& memory, SimultaneousImpacts& result, int bodies, int contacts,
             int group) {
  result.normalImpulses.reserve(at(contacts));
  for (std::vector<int>* ofBodies : {&memory.roots, &memory.groupOfRoot}) {
    ofBodies->reserve(at(bodies));
  }
  for (std::vector<int>* ofContacts : {&memory.live, &memory.active, &memory.members,
                                       &memory.starts, &memory.order, &memory.taken}) {
    ofContacts->reserve(at(contacts) + 1);
  }
  for (std::vector<Real>* ofGroup : {&memory.speeds, &memory.bent, &memory.impulses}) {
    ofGroup->reserve(at(group));
  }
  memory.couplings.reserve(group, group);
  memory.softened.reserve(group, group);
  reserve(memory.searching, memory.solution, group);
}

SimultaneousImpacts simultaneousImpacts(std::span<MovingBody> bodies,
                                        std::span<const BodyContact> contacts,
                                        const ImpactRounds& limits) {
  ImpactMemory memory;
  SimultaneousImpacts result;
  simultaneousImpacts(bodies, contacts, limits, memory, result);
  return result;
}

void simultaneousImpacts(std::span<MovingBody> bodies, std::span<const BodyContact> contacts,
                         const ImpactRounds& limits, ImpactMemory& memory,
                         SimultaneousImpacts& result) {
  check(bodies, contacts);
  Scene scene(bodies, contacts, limits.stopsSlip, memory);
  result.status = ImpactsStatus::settled;
  result.rounds = 0;
  result.approach = 0;
  result.normalImpulses.assign(contacts.size(), 0);

  // Contacts of two immovable bodies cannot be helped.
  std::vector<int>&live = memory.live, &active = memory.active;
  live.clear();
  bool bounces = false;
  for (int i = 0; i < scene.count(); ++i) {
    const BodyContact& c = scene.contact(i);
    if (!movable(bodies[at(c.bodyA)]) && !movable(bodies[at(c.bodyB)])) continue;
    live.push_back(i);
    bounces = bounces || c.law.restitution > 0;
  }

  const auto findActive = [&] {
    active.clear();
    for (const int i : live) {
      if (scene.parting(i) < -scene.rounding(i)) active.push_back(i);
    }
  };
  for (findActive(); !active.empty() && result.rounds < limits.maxRounds; findActive()) {
    ++result.rounds;
    // Without any bounce nothing is gained by letting the blow travel: all contacts stop together.
    const std::size_t groups = scene.sortIntoGroups(bounces ? active : live);
    for (std::size_t k = 0; k < groups; ++k) {
      const Numbers group = scene.group(k);
      reflect(scene, bounces ? firstOf(scene, group) : group, false, result.normalImpulses);
    }
  }
  if (!active.empty()) result.status = ImpactsStatus::roundLimit;
  // One round is enough but for what rounding leaves of it, which the next one sees larger.
  constexpr int kPlasticRounds = 4;
  for (int i = 0; i < kPlasticRounds && !active.empty(); ++i, findActive()) {
    const std::size_t groups = scene.sortIntoGroups(live);
    for (std::size_t k = 0; k < groups; ++k) {
      reflect(scene, scene.group(k), true, result.normalImpulses);
    }
  }
  for (const int i : live) result.approach = std::max(result.approach, -scene.parting(i));
}

}  // namespace carom
