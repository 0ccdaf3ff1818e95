#pragma once

// What a reader may change in the page of lesson 4.
#include "lessons/04_baumgarte/plain_bias.hpp"
#include "practise.hpp"

#define FUNCTIONS byhand::baumgarte::plain_bias
