#pragma once

#include "practise.hpp"

/// A contact may only push: its accumulated impulse stays ≥ 0. Adds what it may of `delta` to `accumulated` and
/// returns the impulse that is then applied to V. All in N s.
double clamp_contact(double& accumulated, double delta);

#define FUNCTIONS clamp_contact
