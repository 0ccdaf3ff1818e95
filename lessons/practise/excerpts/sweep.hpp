#pragma once

// What a reader may change in the page of lesson 3.
#include "lessons/03_iterations/plain_sweep.hpp"
#include "practise.hpp"

#define FUNCTIONS byhand::iterations::plain_sweep
