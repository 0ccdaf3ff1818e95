// Writes the pages that need no lesson, desk.html and playground.html: page_desk FOLDER.

#include "lessons/desk/task_files.hpp"
#include "lessons/files/atomic_file.hpp"
#include "lessons/site/course/desk_page.hpp"
#include "lessons/site/course/playground_page.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  byhand::course::write_whole(folder / "desk.html",
                              byhand::site::desk_page(byhand::desk::read_tasks(BYHAND_DESK_TASKS)));
  byhand::course::write_whole(folder / "playground.html", byhand::site::playground_page(true));
  return 0;
}
