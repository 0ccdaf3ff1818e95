#pragma once

// What a reader may change in the page of lesson 5.
#include "lessons/05_contact/plain_clamp.hpp"
#include "practise.hpp"

#define FUNCTIONS byhand::contact::plain_change
