#pragma once

// What a reader may change in the page of lesson 2.
#include "lessons/02_single_constraint/plain_step.hpp"
#include "practise.hpp"

#define FUNCTIONS byhand::single_constraint::plain_step
