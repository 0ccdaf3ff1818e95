#pragma once

// Every lesson includes this: its page, charts and pictures, one step and its measures, units.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "lessons/page/lesson.hpp"
#include "lessons/page/rounding.hpp"
#include "lessons/pictures/curves.hpp"
#include "lessons/pictures/growing.hpp"
#include "lessons/pictures/methods.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"
#include "lessons/pictures/runs.hpp"
#include "lessons/scenes/units.hpp"
#include "renderer/canvas.hpp"
#include "renderer/chart.hpp"
#include "solver/measure.hpp"
#include "solver/step.hpp"
