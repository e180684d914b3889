#include "carom/world/settings.hpp"

#include <string>

#include "carom/core/checks.hpp"

namespace carom::world {

namespace {

void requireAtLeastOne(int value, const char* name) {
  if (value < 1) reject(name, std::to_string(value), "must be positive");
}

}  // namespace

void requireUsable(const WorldSettings& settings) {
  requireFinite(settings.gravity, "gravity");
  requireAtLeastOne(settings.iterations, "iterations");
  requireAtLeastOne(settings.eventsPerBody, "eventsPerBody");
  requireAtLeastOne(settings.maxBodies, "maxBodies");
  if (settings.rowBudget < 0) {
    reject("rowBudget", std::to_string(settings.rowBudget), "must be zero or positive");
  }
  if (settings.directWork < 0) {
    reject("directWork", std::to_string(settings.directWork), "must be zero or positive");
  }
  if (settings.eventContacts < 0) {
    reject("eventContacts", std::to_string(settings.eventContacts), "must be zero or positive");
  }
  if (settings.pileContacts < 0) {
    reject("pileContacts", std::to_string(settings.pileContacts), "must be zero or positive");
  }
  if (settings.pileBodies < 0) {
    reject("pileBodies", std::to_string(settings.pileBodies), "must be zero or positive");
  }
  requireAtLeastOne(settings.pileWork, "pileWork");
  if (settings.pileSteps < 0) {
    reject("pileSteps", std::to_string(settings.pileSteps), "must be zero or positive");
  }
  requireAtLeastOne(settings.shortSteps, "shortSteps");
  requireAtLeastOne(settings.threads, "threads");
  requirePositive(settings.contactMargin, "contactMargin");
  requirePositive(settings.touchTolerance, "touchTolerance");
  requirePositive(settings.restTolerance, "restTolerance");
  requireNonNegative(settings.shortestBounce, "shortestBounce");
  requirePositive(settings.shortestSubStep, "shortestSubStep");
  requirePositive(settings.sleepTime, "sleepTime");
  requirePositive(settings.sleepSpeed, "sleepSpeed");
  requirePositive(settings.sleepDistance, "sleepDistance");
}

}  // namespace carom::world
