#pragma once

#include <string>

namespace byhand::practise {

/// The page in which all exercises are done, practise.html: their tasks and hints stand in it; page.js shows one
/// at a time, with practise/ beside it.
std::string practise_page();

}  // namespace byhand::practise
