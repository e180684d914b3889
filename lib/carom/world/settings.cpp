#include "carom/world/settings.hpp"

#include <string>

#include "carom/core/checks.hpp"

namespace carom::world {

namespace {

void requireAtLeastOne(int value, const char* name) {
  if (value < 1) reject(name, std::to_string(value), "must be positive");
}

void requireNotBelowZero(int value, const char* name) {
  if (value < 0) reject(name, std::to_string(value), "must be zero or positive");
}

}  // namespace

void requireUsable(const WorldSettings& settings) {
  requireFinite(settings.gravity, "gravity");
  requireAtLeastOne(settings.iterations, "iterations");
  requireAtLeastOne(settings.eventsPerBody, "eventsPerBody");
  requireAtLeastOne(settings.maxBodies, "maxBodies");
  requireNotBelowZero(settings.rowBudget, "rowBudget");
  requireNotBelowZero(settings.directWork, "directWork");
  requireNotBelowZero(settings.eventContacts, "eventContacts");
  requireNotBelowZero(settings.pileContacts, "pileContacts");
  requireNotBelowZero(settings.pileBodies, "pileBodies");
  requireAtLeastOne(settings.pileWork, "pileWork");
  requireNotBelowZero(settings.pileSteps, "pileSteps");
  requireAtLeastOne(settings.shortSteps, "shortSteps");
  requireAtLeastOne(settings.threads, "threads");
  requirePositive(settings.phaseTurn, "phaseTurn");
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
