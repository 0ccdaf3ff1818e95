#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// Law 2: contacts pop.
Law pop();

}  // namespace byhand::laws
