#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace byhand::site {

/// What stands in <main> of a page of the site, without what only a browser with scripts has a use for: fields and
/// links to files.
std::string content_of_page(const std::filesystem::path& page);

/// Takes from pictures the sizes that keep room for those of a narrow page.
void keep_no_room(std::string& text);

/// Takes hints and answers out of the questions of a page, which link to them, and returns them, each in
/// <section id="answer-3.1">. `page`: where the questions are, for links back; "" for the same page.
std::string take_answers(std::string& text, const std::string& page = "");

void replace_all(std::string& text, std::string_view what, std::string_view by);
/// Replaces every stretch from `begin` to `end`.
void replace_all(std::string& text, std::string_view begin, std::string_view end, std::string_view by);

}  // namespace byhand::site
