#pragma once

#include <string>

namespace byhand::course {

/// What a program that runs in a page answers to a request of the page's script. Each such program has its own;
/// lessons/site/live/exchange.cpp hands both across.
std::string answered(const std::string& request);

}  // namespace byhand::course
